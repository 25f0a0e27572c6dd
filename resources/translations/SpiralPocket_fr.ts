<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- SPDX-License-Identifier: LGPL-2.1-or-later -->
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>How the laps of the spiral are made</source>
        <translation>Comment les tours de la spirale sont faits</translation>
    </message>
    <message>
        <source>Percent of cutter diameter to step over on each lap, at most</source>
        <translation>Pas latéral par tour, en pour cent du diamètre de la fraise, au plus</translation>
    </message>
    <message>
        <source>Largest engagement angle of a straight cut, in place of StepOver; 0 for that of StepOver</source>
        <translation>Angle d'engagement maximal en coupe droite, à la place de StepOver ; 0 pour celui de StepOver</translation>
    </message>
    <message>
        <source>Climb or conventional milling, for a spindle that turns clockwise</source>
        <translation>En avalant ou en opposition, broche tournant à droite</translation>
    </message>
    <message>
        <source>How much stock to leave in the XY plane (eg for finishing operation)</source>
        <translation>Surépaisseur laissée dans le plan XY (p. ex. pour la finition)</translation>
    </message>
    <message>
        <source>How much stock to leave along the Z axis</source>
        <translation>Surépaisseur laissée selon Z</translation>
    </message>
    <message>
        <source>Ramp angle of the helical entry</source>
        <translation>Angle de pente de l'entrée en hélice</translation>
    </message>
    <message>
        <source>Limit helix entry diameter, if limit larger than tool diameter or 0, tool diameter is used</source>
        <translation>Limite du diamètre de l'hélice ; si elle dépasse le diamètre de l'outil ou vaut 0, c'est le diamètre de l'outil</translation>
    </message>
    <message>
        <source>Largest deviation of the path from the exact curve</source>
        <translation>Plus grand écart du parcours à la courbe exacte</translation>
    </message>
    <message>
        <source>The machine on which the time is to be least</source>
        <translation>La machine sur laquelle le temps doit être minimal</translation>
    </message>
    <message>
        <source>How the feed follows the engagement: slowed where it passes the limit, slowed linearly with the chip, or raised where the chip is thin</source>
        <translation>Comment l'avance suit l'engagement : ralentie là où il dépasse la limite, ralentie linéairement avec le copeau, ou augmentée là où le copeau est mince</translation>
    </message>
    <message>
        <source>Feed at the largest radial depth of cut, in percent (Linear slow-down)</source>
        <translation>Avance à la plus grande prise radiale, en pour cent (Ralentissement linéaire)</translation>
    </message>
    <message>
        <source>Largest feed where the chip is thin, as a multiple of the tool controller's (Chip thickness)</source>
        <translation>Plus grande avance en copeau mince, en multiple de celle du contrôleur (Épaisseur du copeau)</translation>
    </message>
    <message>
        <source>Feed of moves at depth through cleared ground in mm/min, 0 for the horizontal rapid rate</source>
        <translation>Avance des trajets en profondeur sur zone vidée en mm/min, 0 pour l'avance rapide horizontale</translation>
    </message>
    <message>
        <source>Largest axial depth of one level of a slot that opens the pocket, 0 for automatic</source>
        <translation>Plus grande passe axiale d'une rainure qui ouvre la poche, 0 pour automatique</translation>
    </message>
    <message>
        <source>To take a finishing lap along the walls at the end; Automatic and Extended Archimedean do without, their laps finish the walls</source>
        <translation>Terminer par une passe de finition le long des parois ; inutile en Automatique et en Archimédienne étendue, dont les tours finissent les parois</translation>
    </message>
    <message>
        <source>Ignore islands and clear everything inside the outline</source>
        <translation>Ignorer les îlots et vider tout l'intérieur du contour</translation>
    </message>
    <message>
        <source>Clear the floor beyond its edge where no wall rises, and begin there in the air where the stock ends near by; else the cutter stays within the floor</source>
        <translation>Vider le fond au-delà de son bord là où aucune paroi ne s'élève, et y commencer dans l'air si le brut finit tout près ; sinon la fraise reste à l'intérieur du fond</translation>
    </message>
    <message>
        <source>Cut only what earlier operations of the job have left standing in the pocket</source>
        <translation>N'usiner que ce que les opérations précédentes de la tâche ont laissé dans la poche</translation>
    </message>
    <message>
        <source>Make True, if specifying a Start Point</source>
        <translation>Mettre à Vrai pour imposer un point de départ</translation>
    </message>
    <message>
        <source>Where the cutter goes down, as near as it can; its height does not matter</source>
        <translation>Où la fraise plonge, au plus près ; la hauteur est sans importance</translation>
    </message>
    <message>
        <source>The exact curves behind the path, B-splines at the floors; can be exported to STEP</source>
        <translation>Les courbes exactes du parcours, B-splines sur les fonds ; exportables en STEP</translation>
    </message>
    <message>
        <source>Largest engagement angle that was measured, at the floor after the entry</source>
        <translation>Plus grand angle d'engagement mesuré, au fond après l'entrée</translation>
    </message>
    <message>
        <source>Area within the cutter's reach left standing, in mm^2</source>
        <translation>Surface accessible à la fraise restée non usinée, en mm^2</translation>
    </message>
    <message>
        <source>How far the cutter passes the walls, measured</source>
        <translation>De combien la fraise dépasse les parois, mesuré</translation>
    </message>
    <message>
        <source>Length of all cutting moves</source>
        <translation>Longueur de tous les trajets de coupe</translation>
    </message>
    <message>
        <source>Time of the path on the chosen machine, in seconds</source>
        <translation>Temps du parcours sur la machine choisie, en secondes</translation>
    </message>
    <message>
        <source>What the machinist should know about this path</source>
        <translation>Ce qu'il faut savoir de ce parcours</translation>
    </message>
    <message>
        <source>Version of these properties</source>
        <translation>Version de ces propriétés</translation>
    </message>
</context>
<context>
    <name>SpiralPocket</name>
    <message>
        <source>{} was saved by a FreeCAD without Spiral Pocket; its path may be older than the part. Recompute the document.</source>
        <translation>{} a été enregistré par un FreeCAD sans Spiral Pocket ; son parcours peut être plus ancien que la pièce. Recalculez le document.</translation>
    </message>
    <message>
        <source>Compare...</source>
        <translation>Comparer...</translation>
    </message>
    <message>
        <source>All strategies side by side</source>
        <translation>Toutes les stratégies côte à côte</translation>
    </message>
    <message>
        <source>Use this</source>
        <translation>Utiliser celle-ci</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Cutting length</source>
        <translation>Longueur de coupe</translation>
    </message>
    <message>
        <source>Largest engagement</source>
        <translation>Engagement maximal</translation>
    </message>
    <message>
        <source>99 % of it below</source>
        <translation>99 % en dessous de</translation>
    </message>
    <message>
        <source>Mean engagement</source>
        <translation>Engagement moyen</translation>
    </message>
    <message>
        <source>Left uncut in reach</source>
        <translation>Non usiné à portée</translation>
    </message>
    <message>
        <source>the fastest that keeps the limit of engagement on 99 % of the way and leaves nothing uncut</source>
        <translation>la plus rapide qui tient la limite d'engagement sur 99 % du trajet et ne laisse rien</translation>
    </message>
    <message>
        <source>An error, see the Report view.</source>
        <translation>Une erreur, voir la vue rapport.</translation>
    </message>
    <message>
        <source>Planning... {:.0f} %</source>
        <translation>Calcul... {:.0f} %</translation>
    </message>
    <message>
        <source>No path</source>
        <translation>Pas de parcours</translation>
    </message>
    <message>
        <source>FreeCAD's Adaptive</source>
        <translation>Adaptive de FreeCAD</translation>
    </message>
    <message>
        <source>Compare strategies</source>
        <translation>Comparer les stratégies</translation>
    </message>
    <message>
        <source>Pocket {} ({}), {}</source>
        <translation>Poche {} ({}), {}</translation>
    </message>
    <message>
        <source>No pocket: the first line of the panel says why.</source>
        <translation>Pas de poche : la première ligne du panneau dit pourquoi.</translation>
    </message>
    <message>
        <source>With the same cutter, step-over and feeds on {}. Limit of engagement {:.0f}°; what clearly passes it, or stays uncut, is red. ★ the fastest that keeps it on 99 % of the way and leaves nothing uncut.</source>
        <translation>Avec la même fraise, le même pas et les mêmes avances sur {}. Limite d'engagement {:.0f}° ; ce qui la dépasse nettement, ou reste, est en rouge. ★ la plus rapide qui la respecte sur 99 % du trajet et ne laisse rien.</translation>
    </message>
    <message>
        <source>Create Spiral Pocket</source>
        <translation>Créer une poche en spirale</translation>
    </message>
    <message>
        <source>Type {} to {}.</source>
        <translation>Saisissez de {} à {}.</translation>
    </message>
    <message>
        <source>Type more than {} and less than {}.</source>
        <translation>Saisissez plus de {} et moins de {}.</translation>
    </message>
    <message>
        <source>Type a number.</source>
        <translation>Saisissez un nombre.</translation>
    </message>
    <message>
        <source>Type a number; where no unit is typed, it is "{}".</source>
        <translation>Saisissez un nombre ; sans autre indication, l’unité est « {} ».</translation>
    </message>
    <message>
        <source>Type {} or more.</source>
        <translation>Saisissez {} ou plus.</translation>
    </message>
    <message>
        <source>Type more than 0, at most {}.</source>
        <translation>Saisissez plus de 0, au plus {}.</translation>
    </message>
    <message>
        <source>Feed of moves at depth through cleared ground, 0 for the horizontal rapid rate</source>
        <translation>Avance des trajets en profondeur sur zone vidée, 0 pour l'avance rapide horizontale</translation>
    </message>
    <message>
        <source>Set by the expression {}</source>
        <translation>Fixé par l'expression {}</translation>
    </message>
    <message>
        <source>The same step-over as a length, for this cutter</source>
        <translation>Le même pas latéral en longueur, pour cette fraise</translation>
    </message>
    <message>
        <source>The engagement angle of a straight cut at this step-over: 90° at half the cutter's diameter, 180° in a full slot</source>
        <translation>L'angle d'engagement en coupe droite à ce pas : 90° à la moitié du diamètre, 180° en pleine rainure</translation>
    </message>
    <message>
        <source>{}: "{}" is not taken, {} stays.</source>
        <translation>{} : « {} » n’est pas pris, {} reste.</translation>
    </message>
    <message>
        <source>OK once more keeps what was made without that.</source>
        <translation>Encore une fois OK garde ce qui a été fait sans cela.</translation>
    </message>
    <message>
        <source>The remarks in the result box say why.</source>
        <translation>Les remarques sous « Résultat » disent pourquoi.</translation>
    </message>
    <message>
        <source>OK once more keeps this path.</source>
        <translation>Encore une fois OK garde ce parcours.</translation>
    </message>
    <message>
        <source>An error in the add-on: the path was not computed.</source>
        <translation>Une erreur dans l'extension : le parcours n'a pas été calculé.</translation>
    </message>
    <message>
        <source>Please report it with the text in the Report view.</source>
        <translation>Merci de le signaler avec le texte de la vue rapport.</translation>
    </message>
    <message>
        <source>Remove Spiral Pocket</source>
        <translation>Supprimer la poche en spirale</translation>
    </message>
    <message>
        <source>{} of the floor stay uncut.</source>
        <translation>{} du fond restent non usinés.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Spiral Pocket</source>
        <translation>Poche en spirale</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Graphiques</translation>
    </message>
    <message>
        <source>Engagement, feed, velocity and force along the time</source>
        <translation>Engagement, avance, vitesse et force au fil du temps</translation>
    </message>
    <message>
        <source>Aluminum 6082-T6</source>
        <translation>aluminium 6082-T6</translation>
    </message>
    <message>
        <source>Spiral Pocket plots</source>
        <translation>Graphiques de la poche en spirale</translation>
    </message>
    <message>
        <source>Mean cutting force in {} [N]</source>
        <translation>Effort de coupe moyen dans {} [N]</translation>
    </message>
    <message>
        <source>No path: the first line of the panel says why.</source>
        <translation>Pas de parcours : la première ligne du panneau dit pourquoi.</translation>
    </message>
    <message>
        <source>Engagement [°]</source>
        <translation>Engagement [°]</translation>
    </message>
    <message>
        <source>Time [s]</source>
        <translation>Temps [s]</translation>
    </message>
    <message>
        <source>No force: no spindle speed in the tool controller</source>
        <translation>Pas d'effort : aucune vitesse de broche dans le contrôleur d'outil</translation>
    </message>
    <message>
        <source>Plots need the Python library matplotlib.</source>
        <translation>Les graphiques demandent la bibliothèque Python matplotlib.</translation>
    </message>
    <message>
        <source>Install it with the Addon Manager or pip.</source>
        <translation>Installez-la avec le gestionnaire d'extensions ou pip.</translation>
    </message>
    <message>
        <source>Programmed feed [{}]</source>
        <translation>Avance programmée [{}]</translation>
    </message>
    <message>
        <source>The machine's velocity [{}]</source>
        <translation>Vitesse de la machine [{}]</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>En direct</translation>
    </message>
    <message>
        <source>Draw the path anew while values change</source>
        <translation>Redessiner le parcours à chaque changement</translation>
    </message>
    <message>
        <source>What the colors of the cut show</source>
        <translation>Ce que montrent les couleurs de la coupe</translation>
    </message>
    <message>
        <source>Play the cut</source>
        <translation>Jouer la coupe</translation>
    </message>
    <message>
        <source>How far the cut is shown</source>
        <translation>Jusqu'où la coupe est montrée</translation>
    </message>
    <message>
        <source>Feed [{}]</source>
        <translation>Avance [{}]</translation>
    </message>
    <message>
        <source>The mark is the limit at the step-over: {:.0f}°</source>
        <translation>Le repère est la limite pour ce pas : {:.0f}°</translation>
    </message>
    <message>
        <source>entry</source>
        <translation>entrée</translation>
    </message>
    <message>
        <source>link</source>
        <translation>liaison</translation>
    </message>
    <message>
        <source>rapid</source>
        <translation>rapide</translation>
    </message>
    <message>
        <source>cleared</source>
        <translation>vidé</translation>
    </message>
    <message>
        <source>left over</source>
        <translation>restant</translation>
    </message>
    <message>
        <source>island</source>
        <translation>îlot</translation>
    </message>
    <message>
        <source>Switched off.</source>
        <translation>Désactivé.</translation>
    </message>
    <message>
        <source>This is the proved path.</source>
        <translation>Ceci est le parcours vérifié.</translation>
    </message>
    <message>
        <source>Draft. Stopped; Apply or the next change goes on.</source>
        <translation>Ébauche. Arrêté ; Appliquer ou le prochain changement reprend.</translation>
    </message>
    <message>
        <source>Draft. The path is being proved: {:.0f} %</source>
        <translation>Ébauche. Parcours en vérification : {:.0f} %</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>The operation has this path.</source>
        <translation>L'opération a ce parcours.</translation>
    </message>
    <message>
        <source>OK or Apply makes this path.</source>
        <translation>OK ou Appliquer crée ce parcours.</translation>
    </message>
    <message>
        <source>Stopped: no new path. OK or Apply plans it again.</source>
        <translation>Arrêté : pas de nouveau parcours. OK ou Appliquer le replanifie.</translation>
    </message>
    <message>
        <source>Live is off: OK or Apply plans the path.</source>
        <translation>« En direct » est désactivé : OK ou Appliquer planifie le parcours.</translation>
    </message>
    <message>
        <source>There is no path.</source>
        <translation>Il n'y a pas de parcours.</translation>
    </message>
    <message>
        <source>Planning: {:.0f} %</source>
        <translation>Planification : {:.0f} %</translation>
    </message>
    <message>
        <source>Click to see the place</source>
        <translation>Cliquer pour voir l'endroit</translation>
    </message>
    <message>
        <source>FreeCAD's estimate</source>
        <translation>Estimation de FreeCAD</translation>
    </message>
    <message>
        <source>Entry at full width, deep</source>
        <translation>Entrée en pleine largeur, profondeur</translation>
    </message>
    <message>
        <source>Gouge</source>
        <translation>Surcoupe</translation>
    </message>
    <message>
        <source>{:.0f}°, limit {:.0f}°</source>
        <translation>{:.0f}°, limite {:.0f}°</translation>
    </message>
    <message>
        <source>whole width, {} deep</source>
        <translation>pleine largeur, {} de profondeur</translation>
    </message>
    <message>
        <source>Time on {}</source>
        <translation>Temps sur {}</translation>
    </message>
    <message>
        <source>{} (allowed: {})</source>
        <translation>{} (admis : {})</translation>
    </message>
    <message>
        <source>pockets not cut: {}</source>
        <translation>poches non usinées : {}</translation>
    </message>
    <message>
        <source>remarks: {}</source>
        <translation>remarques : {}</translation>
    </message>
    <message>
        <source>{} uncut</source>
        <translation>{} non usinés</translation>
    </message>
    <message>
        <source>Any pocket, with islands and necks: holds the engagement, least time on the machine</source>
        <translation>Toute poche, avec îlots et étranglements : tient l'engagement, temps machine minimal</translation>
    </message>
    <message>
        <source>One exact B-spline from the middle to the wall, for pockets without islands</source>
        <translation>Une B-spline exacte du milieu à la paroi, pour poches sans îlots</translation>
    </message>
    <message>
        <source>Even laps about the pocket's middle line, for long and branched pockets</source>
        <translation>Tours réguliers autour de la ligne médiane, pour poches longues et ramifiées</translation>
    </message>
    <message>
        <source>Laps like lines of equal temperature, smooth everywhere, for compact pockets</source>
        <translation>Tours en lignes d'égale température, lisses partout, pour poches compactes</translation>
    </message>
    <message>
        <source>A round spiral that turns into the wall's shape, for compact pockets</source>
        <translation>Une spirale ronde qui prend la forme de la paroi, pour poches compactes</translation>
    </message>
    <message>
        <source>Start point</source>
        <translation>Point de départ</translation>
    </message>
    <message>
        <source>"{}"</source>
        <translation>« {} »</translation>
    </message>
    <message>
        <source>Switched off: no path until Active is set again.</source>
        <translation>Désactivée : pas de parcours tant qu’Active n’est pas rétabli.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>Add one with an end mill to the job, then try again.</source>
        <translation>Ajoutez-en un avec une fraise deux tailles à la tâche, puis réessayez.</translation>
    </message>
    <message>
        <source>{} has no tool controller that can clear a pocket.</source>
        <translation>{} n'a pas de contrôleur d'outil qui puisse vider une poche.</translation>
    </message>
    <message>
        <source>Use as Default in This Job</source>
        <translation>Utiliser par défaut dans cette tâche</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Linear Morph</source>
        <translation>Morphing linéaire</translation>
    </message>
    <message>
        <source>Extended Archimedean</source>
        <translation>Archimédienne étendue</translation>
    </message>
    <message>
        <source>Isotherm</source>
        <translation>Isothermes</translation>
    </message>
    <message>
        <source>Central Spiral</source>
        <translation>Spirale centrale</translation>
    </message>
    <message>
        <source>Climb</source>
        <translation>En avalant</translation>
    </message>
    <message>
        <source>Conventional</source>
        <translation>En opposition</translation>
    </message>
    <message>
        <source>Constant</source>
        <translation>Constante</translation>
    </message>
    <message>
        <source>Linear slow-down</source>
        <translation>Ralentissement linéaire</translation>
    </message>
    <message>
        <source>Chip thickness</source>
        <translation>Épaisseur du copeau</translation>
    </message>
    <message>
        <source>Benchtop mill</source>
        <translation>Fraiseuse d'établi</translation>
    </message>
    <message>
        <source>Hobby router</source>
        <translation>Fraiseuse à portique amateur</translation>
    </message>
    <message>
        <source>Huron with Siemens 840D</source>
        <translation>Huron avec Siemens 840D</translation>
    </message>
    <message>
        <source>Mikron UCP710</source>
        <translation>Mikron UCP710</translation>
    </message>
    <message>
        <source>Vertical machining center</source>
        <translation>Centre d'usinage vertical</translation>
    </message>
</context>
<context>
    <name>SpiralPocketMessages</name>
    <message>
        <source>the pocket</source>
        <translation>la poche</translation>
    </message>
    <message>
        <source>feeds</source>
        <translation>avances</translation>
    </message>
    <message>
        <source>horizontal feed</source>
        <translation>avance horizontale</translation>
    </message>
    <message>
        <source>vertical feed</source>
        <translation>avance verticale</translation>
    </message>
    <message>
        <source>rapid</source>
        <translation>rapide</translation>
    </message>
    <message>
        <source>link</source>
        <translation>liaison</translation>
    </message>
    <message>
        <source>the path asked for failed its proof</source>
        <translation>le parcours demandé n'a pas passé la vérification</translation>
    </message>
    <message>
        <source>the path asked for would leave {0} mm2 standing</source>
        <translation>le parcours demandé laisserait {0} mm2 debout</translation>
    </message>
    <message>
        <source>The cutter's diameter</source>
        <translation>Diamètre de la fraise</translation>
    </message>
    <message>
        <source>The horizontal feed</source>
        <translation>Avance horizontale</translation>
    </message>
    <message>
        <source>The vertical feed</source>
        <translation>Avance verticale</translation>
    </message>
    <message>
        <source>The horizontal rapid rate</source>
        <translation>Avance rapide horizontale</translation>
    </message>
    <message>
        <source>The vertical rapid rate</source>
        <translation>Avance rapide verticale</translation>
    </message>
    <message>
        <source>The tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>XY stock to leave</source>
        <translation>Surépaisseur XY</translation>
    </message>
    <message>
        <source>Z stock to leave</source>
        <translation>Surépaisseur Z</translation>
    </message>
    <message>
        <source>with {0} mm of stock to leave</source>
        <translation>avec {0} mm de surépaisseur</translation>
    </message>
    <message>
        <source>Pocket {0} of {1}: {2}</source>
        <translation>Poche {0} sur {1} : {2}</translation>
    </message>
    <message>
        <source>0.01 mm is usual.</source>
        <translation>0,01 mm est usuel.</translation>
    </message>
    <message>
        <source>A cutter below {0} mm reaches all of them.</source>
        <translation>Une fraise de moins de {0} mm y accède partout.</translation>
    </message>
    <message>
        <source>A cutter below {0} mm reaches it.</source>
        <translation>Une fraise de moins de {0} mm y accède.</translation>
    </message>
    <message>
        <source>A cutter below {0} mm reaches {1} of them.</source>
        <translation>Une fraise de moins de {0} mm accède à {1} d'entre elles.</translation>
    </message>
    <message>
        <source>A depth or height is {0}; it must be a number of millimeters.</source>
        <translation>Une profondeur ou une hauteur vaut {0} ; ce doit être un nombre de millimètres.</translation>
    </message>
    <message>
        <source>A helix angle of {0} degrees cannot be cut.</source>
        <translation>Un angle d'hélice de {0} degrés est impossible.</translation>
    </message>
    <message>
        <source>A largest engagement of {0} degrees cannot be cut.</source>
        <translation>Un engagement maximal de {0} degrés est impossible.</translation>
    </message>
    <message>
        <source>A smaller StepDown makes them smaller; a finishing operation removes them.</source>
        <translation>Une valeur plus petite de StepDown les réduit ; une opération de finition les enlève.</translation>
    </message>
    <message>
        <source>A smaller step-over may clear it.</source>
        <translation>Un pas latéral plus petit peut l'enlever.</translation>
    </message>
    <message>
        <source>A step down of {0} mm makes more than {1} levels.</source>
        <translation>Une descente de {0} mm donne plus de {1} niveaux.</translation>
    </message>
    <message>
        <source>A step down of {0} mm never reaches the floor.</source>
        <translation>Avec une passe de {0} mm, le fond n'est jamais atteint.</translation>
    </message>
    <message>
        <source>A step-over of {0} mm is wider than the {1} mm cutter.</source>
        <translation>Un pas latéral de {0} mm dépasse la fraise de {1} mm.</translation>
    </message>
    <message>
        <source>A step-over of {0} mm never clears the pocket.</source>
        <translation>Un pas latéral de {0} mm ne vide jamais la poche.</translation>
    </message>
    <message>
        <source>A tolerance of {0} mm is too coarse for this cutter.</source>
        <translation>Une tolérance de {0} mm est trop grossière pour cette fraise.</translation>
    </message>
    <message>
        <source>A {0} move runs through standing stock at {at}, {1} mm in all.</source>
        <translation>Un trajet ({0}) traverse de la matière en {at}, {1} mm en tout.</translation>
    </message>
    <message>
        <source>Above Z{0} also {1} mm2 beside the selected floor are cleared, down to ledges.</source>
        <translation>Au-dessus de Z{0}, {1} mm2 à côté du fond sélectionné sont aussi vidés, jusqu'aux épaulements.</translation>
    </message>
    <message>
        <source>Above the floor the pocket has notches that the {0} mm cutter does not fit, the largest at {at}; these ({1} mm2) stay uncut.</source>
        <translation>Au-dessus du fond, la poche a des encoches où la fraise de {0} mm n'entre pas, la plus grande en {at} ; celles-ci ({1} mm2) restent non usinées.</translation>
    </message>
    <message>
        <source>Add it; vmc.json shows how.</source>
        <translation>Ajoutez-le ; vmc.json montre comment.</translation>
    </message>
    <message>
        <source>Add the part to the job's model.</source>
        <translation>Ajoutez la pièce au modèle de la tâche.</translation>
    </message>
    <message>
        <source>Another part of the job covers the whole floor; no cutter gets there from above.</source>
        <translation>Une autre pièce de la tâche couvre tout le fond ; aucune fraise n'y accède par le haut.</translation>
    </message>
    <message>
        <source>Another part of the job covers {0} mm2 of the floor; that stays uncut.</source>
        <translation>Une autre pièce de la tâche couvre {0} mm2 du fond ; cela n'est pas usiné.</translation>
    </message>
    <message>
        <source>Another part of the job stands in the pocket or over it; the cutter keeps off that.</source>
        <translation>Une autre pièce de la tâche se trouve dans la poche ou au-dessus ; la fraise l'évite.</translation>
    </message>
    <message>
        <source>At Z{0} the pocket reaches under a wall.</source>
        <translation>À Z{0} la poche passe sous une paroi.</translation>
    </message>
    <message>
        <source>At a helix angle of {0} degrees the cutter goes round more than {1} times on its way down.</source>
        <translation>Avec un angle d'hélice de {0} degrés, la fraise fait plus de {1} tours pour descendre.</translation>
    </message>
    <message>
        <source>At {at} the cutter cuts {0} mm into the wall.</source>
        <translation>En {at} la fraise entame la paroi de {0} mm.</translation>
    </message>
    <message>
        <source>At {at} the engagement reaches {0} degrees, the step-over of {1} % allows {2}; {3} % of the cut clearly pass that.</source>
        <translation>À {at} l'engagement atteint {0} degrés, le recouvrement de {1} % en permet {2} ; {3} % de la coupe le dépassent nettement.</translation>
    </message>
    <message>
        <source>Below Z{0} that part stays uncut.</source>
        <translation>Sous Z{0}, cette partie reste non usinée.</translation>
    </message>
    <message>
        <source>Below Z{0} the pocket is too narrow and stays uncut.</source>
        <translation>Sous Z{0}, la poche est trop étroite et reste non usinée.</translation>
    </message>
    <message>
        <source>Central Spiral cannot go round islands; there is one at {at}.</source>
        <translation>La Spirale centrale ne contourne pas les îlots ; il y en a un en {at}.</translation>
    </message>
    <message>
        <source>Central Spiral needs a pocket whose whole wall can be seen from one place in its middle; the one at {at} has walls behind corners.</source>
        <translation>La Spirale centrale demande une poche dont toute la paroi se voit d'un point central ; celle en {at} a des parois cachées derrière des coins.</translation>
    </message>
    <message>
        <source>Check the geometry of the part and the job's stock.</source>
        <translation>Vérifiez la géométrie de la pièce et du brut de la tâche.</translation>
    </message>
    <message>
        <source>Check the outline for tiny steps, or choose a smaller cutter.</source>
        <translation>Cherchez de minuscules marches dans le contour, ou prenez une fraise plus petite.</translation>
    </message>
    <message>
        <source>Check the part's geometry in the Part workbench and repair the face.</source>
        <translation>Vérifiez la géométrie dans l'atelier Part et réparez la face.</translation>
    </message>
    <message>
        <source>Check the part's geometry in the Part workbench.</source>
        <translation>Vérifiez la géométrie dans l'atelier Part.</translation>
    </message>
    <message>
        <source>Checking the pocket</source>
        <translation>Vérification de la poche</translation>
    </message>
    <message>
        <source>Choose a tool controller with an end mill in it.</source>
        <translation>Choisissez un contrôleur avec une fraise deux tailles.</translation>
    </message>
    <message>
        <source>Choose another strategy, for example Automatic.</source>
        <translation>Choisissez une autre stratégie, par exemple Automatique.</translation>
    </message>
    <message>
        <source>Choose one of: {0}.</source>
        <translation>Choisissez parmi : {0}.</translation>
    </message>
    <message>
        <source>Choose one with an end mill in it.</source>
        <translation>Choisissez-en un avec une fraise deux tailles.</translation>
    </message>
    <message>
        <source>Choose that strategy, or another step-over.</source>
        <translation>Choisissez cette stratégie, ou un autre pas latéral.</translation>
    </message>
    <message>
        <source>Choose the strategy Automatic or Isotherm for this pocket.</source>
        <translation>Choisissez la stratégie Automatique ou Isothermes pour cette poche.</translation>
    </message>
    <message>
        <source>Choose your machine in Machine, or lower the feed in the tool controller.</source>
        <translation>Choisir votre machine dans Machine, ou baisser l'avance dans le contrôleur d'outil.</translation>
    </message>
    <message>
        <source>Close it first (Part workbench, Check Geometry and Convert to Solid).</source>
        <translation>Fermez-la d'abord (atelier Part, Vérifier la géométrie et Convertir en solide).</translation>
    </message>
    <message>
        <source>Compare it with vmc.json.</source>
        <translation>Comparez-le à vmc.json.</translation>
    </message>
    <message>
        <source>Cut them by a smaller cutter.</source>
        <translation>Usinez-les avec une fraise plus petite.</translation>
    </message>
    <message>
        <source>Do not run this path; check the final depth and the floor stock.</source>
        <translation>N'usinez pas ce parcours ; vérifiez la profondeur finale et la surépaisseur du fond.</translation>
    </message>
    <message>
        <source>Do not run this path; try another strategy or step-over.</source>
        <translation>N'usinez pas ce parcours ; essayez une autre stratégie ou un autre pas.</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminé</translation>
    </message>
    <message>
        <source>Drag it into the job's operations.</source>
        <translation>Faites-la glisser dans les opérations de la tâche.</translation>
    </message>
    <message>
        <source>Earlier operations have cleared more than 99 % of this pocket; what this cutter reaches of the rest is cut.</source>
        <translation>Les opérations précédentes ont vidé plus de 99 % de cette poche ; du reste est usiné ce que cette fraise atteint.</translation>
    </message>
    <message>
        <source>Earlier operations have cleared this pocket as far as this cutter reaches.</source>
        <translation>Les opérations précédentes ont vidé cette poche aussi loin que porte cette fraise.</translation>
    </message>
    <message>
        <source>Earlier operations have cleared {0} % of this pocket; what this cutter reaches of the rest is cut.</source>
        <translation>Les opérations précédentes ont vidé {0} % de cette poche ; du reste est usiné ce que cette fraise atteint.</translation>
    </message>
    <message>
        <source>Finish with a flat end mill where that must be sharp.</source>
        <translation>Finissez avec une fraise plate là où l’angle doit être vif.</translation>
    </message>
    <message>
        <source>FreeCAD's Adaptive cannot be reached from here.</source>
        <translation>L'Adaptive de FreeCAD n'est pas accessible d'ici.</translation>
    </message>
    <message>
        <source>FreeCAD's Adaptive finds no path in this pocket.</source>
        <translation>L'Adaptive de FreeCAD ne trouve pas de parcours dans cette poche.</translation>
    </message>
    <message>
        <source>FreeCAD's Adaptive has found no path in this pocket within {0} s.</source>
        <translation>L'Adaptive de FreeCAD n'a pas trouvé de parcours dans cette poche en {0} s.</translation>
    </message>
    <message>
        <source>Give it the number of an end mill, 1 or higher.</source>
        <translation>Donnez-lui le numéro d'une fraise, 1 ou plus.</translation>
    </message>
    <message>
        <source>Install it with FreeCAD's Addon Manager (it is a dependency of Spiral Pocket) or with pip into the Python that FreeCAD uses, then start FreeCAD again.</source>
        <translation>Installez-la avec le gestionnaire d'extensions de FreeCAD (c'est une dépendance de Spiral Pocket) ou avec pip dans le Python de FreeCAD, puis relancez FreeCAD.</translation>
    </message>
    <message>
        <source>Islands on {0} mm2 of the floor are milled away.</source>
        <translation>Les îlots sur {0} mm2 du fond sont enlevés au fraisage.</translation>
    </message>
    <message>
        <source>Isotherm would need more than {0} laps.</source>
        <translation>Isothermes demanderait plus de {0} tours.</translation>
    </message>
    <message>
        <source>It comes with matplotlib 3.6 or later: install that with FreeCAD's Addon Manager, or choose another strategy.</source>
        <translation>Elle vient avec matplotlib 3.6 ou plus récent : installez-le avec le gestionnaire d'extensions de FreeCAD, ou choisissez une autre stratégie.</translation>
    </message>
    <message>
        <source>Its faces are Face1 to Face{0}.</source>
        <translation>Ses faces sont Face1 à Face{0}.</translation>
    </message>
    <message>
        <source>Keep clamps away from that side, or unset ExtendOpenSides.</source>
        <translation>Éloignez les brides de ce côté, ou désactivez ExtendOpenSides.</translation>
    </message>
    <message>
        <source>Laps of Linear Morph would cross themselves at {at}, where the wall turns away from the middle of the pocket.</source>
        <translation>Des tours du Morphing linéaire se croiseraient en {at}, où la paroi se détourne du centre de la poche.</translation>
    </message>
    <message>
        <source>Laying the spiral</source>
        <translation>Tracé de la spirale</translation>
    </message>
    <message>
        <source>Levels are {0} mm deep, the tool's cutting edge is {1} mm long.</source>
        <translation>Les niveaux font {0} mm de profondeur, l'arête de l'outil {1} mm de long.</translation>
    </message>
    <message>
        <source>Linear Morph cannot go round islands; there is one at {at}.</source>
        <translation>Le Morphing linéaire ne contourne pas les îlots ; il y en a un en {at}.</translation>
    </message>
    <message>
        <source>Linear Morph finds no middle to start from.</source>
        <translation>Le Morphing linéaire ne trouve pas de centre de départ.</translation>
    </message>
    <message>
        <source>Look what lies under the hole. If it goes on there, select a wall of that.</source>
        <translation>Regardez ce qui se trouve sous l’ouverture. Si elle y continue, sélectionnez une de ses parois à cet endroit.</translation>
    </message>
    <message>
        <source>Look what lies under the stock, or raise FinalDepth.</source>
        <translation>Regardez ce qu'il y a sous le brut, ou relevez FinalDepth.</translation>
    </message>
    <message>
        <source>Look whether the stock is where it should be.</source>
        <translation>Vérifiez que le brut est où il doit être.</translation>
    </message>
    <message>
        <source>Lower FinishDepth or raise StepDown.</source>
        <translation>Diminuez FinishDepth ou augmentez StepDown.</translation>
    </message>
    <message>
        <source>Lower StepDown, or take a longer tool.</source>
        <translation>Diminuez StepDown, ou prenez un outil plus long.</translation>
    </message>
    <message>
        <source>Lower StockToLeave.</source>
        <translation>Diminuez StockToLeave.</translation>
    </message>
    <message>
        <source>Lower Tolerance if the wall must be truer.</source>
        <translation>Réduisez Tolerance si la paroi doit être plus juste.</translation>
    </message>
    <message>
        <source>Lower ZStockToLeave.</source>
        <translation>Diminuez ZStockToLeave.</translation>
    </message>
    <message>
        <source>Machine that part from another side, or with an undercutting tool.</source>
        <translation>Usinez cette partie d'un autre côté, ou avec un outil de contre-dépouille.</translation>
    </message>
    <message>
        <source>Mend or remove it.</source>
        <translation>Corrigez-la ou supprimez-la.</translation>
    </message>
    <message>
        <source>More than {0} laps are left beside the spirals.</source>
        <translation>Il reste plus de {0} tours à côté des spirales.</translation>
    </message>
    <message>
        <source>Move this operation behind the one with the larger end mill, or unset UseRestMachining. Only flat end mills count: round ones leave ridges.</source>
        <translation>Placez cette opération après celle de la plus grande fraise, ou désactivez UseRestMachining. Seules comptent les fraises plates : les rondes laissent des crêtes.</translation>
    </message>
    <message>
        <source>Much the same is told of {0} more pockets (at {1}).</source>
        <translation>Il en est presque de même pour {0} autres poches (en {1}).</translation>
    </message>
    <message>
        <source>Much the same is told of {0} more pockets.</source>
        <translation>Il en est presque de même pour {0} autres poches.</translation>
    </message>
    <message>
        <source>No cutter goes through so narrow a gap; check the model.</source>
        <translation>Aucune fraise ne passe par un espace aussi étroit ; vérifiez le modèle.</translation>
    </message>
    <message>
        <source>No earlier operation has cleared any of this pocket down to its floor; all is cut.</source>
        <translation>Aucune opération précédente n'a vidé quoi que ce soit de cette poche jusqu'au fond ; tout est usiné.</translation>
    </message>
    <message>
        <source>No face is selected.</source>
        <translation>Aucune face n'est sélectionnée.</translation>
    </message>
    <message>
        <source>No isotherm leads to the slot.</source>
        <translation>Aucune isotherme ne mène à la rainure.</translation>
    </message>
    <message>
        <source>Nothing is cut below Z{0}.</source>
        <translation>Rien n'est usiné sous Z{0}.</translation>
    </message>
    <message>
        <source>Of the step-over of {0} % Automatic uses {1}: wider laps would leave stock where they meet.</source>
        <translation>Du pas latéral de {0} %, Automatique utilise {1} : des passes plus larges laisseraient de la matière où elles se rejoignent.</translation>
    </message>
    <message>
        <source>Open the document in that version, or make a new job here.</source>
        <translation>Ouvrez le document dans cette version-là ou créez ici une nouvelle tâche.</translation>
    </message>
    <message>
        <source>Other strategies use it whole, and may leave stock.</source>
        <translation>Les autres stratégies l'utilisent en entier et peuvent laisser de la matière.</translation>
    </message>
    <message>
        <source>Planning feeds</source>
        <translation>Calcul des avances</translation>
    </message>
    <message>
        <source>Proving the path</source>
        <translation>Preuve du parcours</translation>
    </message>
    <message>
        <source>Put an end mill into the tool controller.</source>
        <translation>Mettez une fraise deux tailles dans le contrôleur d'outil.</translation>
    </message>
    <message>
        <source>Raise FinalDepth or ZStockToLeave if that is not meant.</source>
        <translation>Relevez FinalDepth ou ZStockToLeave si ce n'est pas voulu.</translation>
    </message>
    <message>
        <source>Raise HelixDiameterLimit.</source>
        <translation>Augmentez HelixDiameterLimit.</translation>
    </message>
    <message>
        <source>Raise SafeHeight and ClearanceHeight above the stock.</source>
        <translation>Relevez SafeHeight et ClearanceHeight au-dessus du brut.</translation>
    </message>
    <message>
        <source>Raise SlotBite, or set it to 0 to have it found.</source>
        <translation>Relevez SlotBite, ou réglez-le à 0 pour qu'il soit déterminé.</translation>
    </message>
    <message>
        <source>Raise StartDepth to the top of the stock, or clear it with an operation before.</source>
        <translation>Relevez StartDepth au sommet du brut, ou videz-le par une opération avant.</translation>
    </message>
    <message>
        <source>Raise StepDown.</source>
        <translation>Relevez StepDown.</translation>
    </message>
    <message>
        <source>Raise StockToLeave if that is not meant.</source>
        <translation>Relevez StockToLeave si ce n'est pas voulu.</translation>
    </message>
    <message>
        <source>Recompute the operation to try again.</source>
        <translation>Recalculez l'opération pour réessayer.</translation>
    </message>
    <message>
        <source>Refine the part (Part workbench, Refine Shape), or select one of them.</source>
        <translation>Affinez la pièce (atelier Part, Affiner la forme), ou choisissez-en une.</translation>
    </message>
    <message>
        <source>Remove it from the base geometry and select the floor of the pocket again.</source>
        <translation>Retirez-la de la géométrie de base et sélectionnez à nouveau le fond de la poche.</translation>
    </message>
    <message>
        <source>Repair the part (Part workbench, Check Geometry).</source>
        <translation>Réparez la pièce (atelier Part, Vérifier la géométrie).</translation>
    </message>
    <message>
        <source>Repairing the path</source>
        <translation>Réparation du parcours</translation>
    </message>
    <message>
        <source>Select a face of the job's model, or add that part to it.</source>
        <translation>Sélectionnez une face du modèle de la tâche, ou ajoutez-y cette pièce.</translation>
    </message>
    <message>
        <source>Select all faces that make the floor, or refine the part.</source>
        <translation>Sélectionnez toutes les faces qui forment le fond, ou affinez la pièce.</translation>
    </message>
    <message>
        <source>Select the floor face of the pocket.</source>
        <translation>Sélectionnez la face du fond de la poche.</translation>
    </message>
    <message>
        <source>Select the floor of the pocket, a flat level face with walls around it, or a wall of a hole through the part that ends at one level face below.</source>
        <translation>Sélectionnez le fond de la poche, une face plane et horizontale entourée de parois, ou une paroi d’une ouverture qui se termine en bas sur une seule face horizontale.</translation>
    </message>
    <message>
        <source>Select the floor of the pocket, or turn the part over.</source>
        <translation>Sélectionnez le fond de la poche, ou retournez la pièce.</translation>
    </message>
    <message>
        <source>Set ClearanceHeight above SafeHeight above StartDepth.</source>
        <translation>Mettez ClearanceHeight au-dessus de SafeHeight, elle-même au-dessus de StartDepth.</translation>
    </message>
    <message>
        <source>Set ExtendOpenSides, or clear that side with another operation.</source>
        <translation>Activez ExtendOpenSides, ou videz ce côté avec une autre opération.</translation>
    </message>
    <message>
        <source>Set HelixAngle above 0 and below 90 degrees; 5 is usual.</source>
        <translation>Réglez HelixAngle au-dessus de 0 et au-dessous de 90 degrés ; 5 est habituel.</translation>
    </message>
    <message>
        <source>Set HelixAngle above {0} degrees; 5 is usual.</source>
        <translation>Réglez HelixAngle au-dessus de {0} degrés ; 5 est usuel.</translation>
    </message>
    <message>
        <source>Set HelixDiameterLimit to 0 for no limit.</source>
        <translation>Mettez HelixDiameterLimit à 0 pour aucune limite.</translation>
    </message>
    <message>
        <source>Set LinkFeed to 0 for the horizontal rapid rate.</source>
        <translation>Mettez LinkFeed à 0 pour l'avance rapide horizontale.</translation>
    </message>
    <message>
        <source>Set MaxEngagement up to {0} degrees, or to 0 for StepOver's.</source>
        <translation>Mettez MaxEngagement à {0} degrés au plus, ou à 0 pour celui de StepOver.</translation>
    </message>
    <message>
        <source>Set MaxFeedRatio to 1 or more; 2 is usual.</source>
        <translation>Mettez MaxFeedRatio à 1 ou plus ; 2 est usuel.</translation>
    </message>
    <message>
        <source>Set SlotBite to 0 to have it found.</source>
        <translation>Réglez SlotBite à 0 pour qu'il soit déterminé.</translation>
    </message>
    <message>
        <source>Set SlowdownPercent between 1 and 100; 75 is usual.</source>
        <translation>Mettez SlowdownPercent entre 1 et 100 ; 75 est usuel.</translation>
    </message>
    <message>
        <source>Set StartDepth above FinalDepth.</source>
        <translation>Mettez StartDepth au-dessus de FinalDepth.</translation>
    </message>
    <message>
        <source>Set StartPoint inside one, or do without.</source>
        <translation>Mettez StartPoint dans l'une d'elles, ou passez-vous-en.</translation>
    </message>
    <message>
        <source>Set StartPoint where a helix has room, or near the slot along the wall.</source>
        <translation>Placez StartPoint où une hélice a de la place, ou près de la rainure le long de la paroi.</translation>
    </message>
    <message>
        <source>Set StartPoint, or do without.</source>
        <translation>Réglez StartPoint, ou passez-vous-en.</translation>
    </message>
    <message>
        <source>Set StepDown above 0.</source>
        <translation>Mettez StepDown au-dessus de 0.</translation>
    </message>
    <message>
        <source>Set StepOver above 0; 20 to 45 % of the cutter's diameter is usual.</source>
        <translation>Mettez StepOver au-dessus de 0 ; 20 à 45 % du diamètre de la fraise est usuel.</translation>
    </message>
    <message>
        <source>Set StepOver to 100 % or less.</source>
        <translation>Mettez StepOver à 100 % ou moins.</translation>
    </message>
    <message>
        <source>Set StepOver to {0}, or a smaller one.</source>
        <translation>Réglez StepOver à {0}, ou moins.</translation>
    </message>
    <message>
        <source>Set Tolerance to at most {0} mm.</source>
        <translation>Réglez Tolerance à {0} mm au plus.</translation>
    </message>
    <message>
        <source>Set all depths and heights.</source>
        <translation>Réglez toutes les profondeurs et hauteurs.</translation>
    </message>
    <message>
        <source>Set it in the tool controller, unless you start the spindle by hand.</source>
        <translation>Réglez-la dans le contrôleur d'outil, sauf si vous démarrez la broche à la main.</translation>
    </message>
    <message>
        <source>Set it in the tool of the tool controller.</source>
        <translation>Réglez-le dans l'outil du contrôleur d'outil.</translation>
    </message>
    <message>
        <source>Set it to 0 for none.</source>
        <translation>Mettez 0 pour aucune.</translation>
    </message>
    <message>
        <source>Set one up in the job's editor.</source>
        <translation>Créez-en un dans l'éditeur de la tâche.</translation>
    </message>
    <message>
        <source>Set the feeds in the tool controller.</source>
        <translation>Réglez les avances dans le contrôleur d'outil.</translation>
    </message>
    <message>
        <source>Set the horizontal and vertical feed in the tool controller.</source>
        <translation>Réglez les avances horizontale et verticale dans le contrôleur d'outil.</translation>
    </message>
    <message>
        <source>Set the spindle's direction in the tool controller or the tool, or the other CutMode.</source>
        <translation>Réglez le sens de rotation de la broche sur avant dans le contrôleur d'outil ou dans l'outil, ou l'autre CutMode.</translation>
    </message>
    <message>
        <source>Set the spindle's direction there, or in the tool, unless you start it by hand.</source>
        <translation>Réglez le sens de rotation de la broche là ou dans l'outil, sauf si vous la démarrez à la main.</translation>
    </message>
    <message>
        <source>Spiral Pocket needs shapely 2, this FreeCAD has {0}.</source>
        <translation>Spiral Pocket demande shapely 2, ce FreeCAD a {0}.</translation>
    </message>
    <message>
        <source>Spiral Pocket needs the Python library {0}, which this FreeCAD lacks.</source>
        <translation>Spiral Pocket demande la bibliothèque Python {0}, absente de ce FreeCAD.</translation>
    </message>
    <message>
        <source>Stopped by the user.</source>
        <translation>Arrêté par l'utilisateur.</translation>
    </message>
    <message>
        <source>Take a cutter below {0} mm.</source>
        <translation>Prenez une fraise de moins de {0} mm.</translation>
    </message>
    <message>
        <source>Take a larger step-over or the strategy Automatic.</source>
        <translation>Prenez un pas plus grand ou la stratégie Automatique.</translation>
    </message>
    <message>
        <source>Take a longer tool; its holder would strike the part.</source>
        <translation>Prenez un outil plus long ; son porte-outil heurterait la pièce.</translation>
    </message>
    <message>
        <source>Take a lower feed or a smaller SlotBite if that is too heavy for the cutter.</source>
        <translation>Réduisez l'avance ou la valeur de SlotBite si c'est trop pour la fraise.</translation>
    </message>
    <message>
        <source>Take a smaller cutter or the strategy Automatic.</source>
        <translation>Prenez une fraise plus petite ou la stratégie Automatique.</translation>
    </message>
    <message>
        <source>Take a smaller cutter.</source>
        <translation>Prenez une fraise plus petite.</translation>
    </message>
    <message>
        <source>Take a smaller cutter; a hole as wide as the cutter is one for FreeCAD's Drilling.</source>
        <translation>Prenez une fraise plus petite ; un trou aussi large que la fraise relève du Perçage de FreeCAD.</translation>
    </message>
    <message>
        <source>Take a smaller cutter; a slot as wide as the cutter is one for FreeCAD's Slot.</source>
        <translation>Prenez une fraise plus petite ; une rainure aussi large que la fraise relève de l'opération Slot de FreeCAD.</translation>
    </message>
    <message>
        <source>Take a wider cutter or a larger step-over.</source>
        <translation>Prenez une fraise plus grosse ou un pas plus grand.</translation>
    </message>
    <message>
        <source>Take that part out of the job's model if it is not there when the pocket is cut.</source>
        <translation>Retirez cette pièce du modèle de la tâche si elle n'est pas là pendant l'usinage de la poche.</translation>
    </message>
    <message>
        <source>Take that part out of the job's model.</source>
        <translation>Retirez cette pièce du modèle de la tâche.</translation>
    </message>
    <message>
        <source>That part stays uncut.</source>
        <translation>Cette partie reste non usinée.</translation>
    </message>
    <message>
        <source>The cutter goes down at {at}, {0} mm from the start point: that is as near as {1} can begin.</source>
        <translation>La fraise descend en {at}, à {0} mm du point de départ : {1} ne peut pas commencer plus près.</translation>
    </message>
    <message>
        <source>The cutter goes {0} mm below the floor.</source>
        <translation>La fraise descend {0} mm sous le fond.</translation>
    </message>
    <message>
        <source>The cutter goes {0} mm below the selected floor, {1} mm of that below the stock.</source>
        <translation>La fraise descend {0} mm sous le fond choisi, dont {1} mm sous le brut.</translation>
    </message>
    <message>
        <source>The cutter goes {0} mm below the selected floor.</source>
        <translation>La fraise descend {0} mm sous le fond choisi.</translation>
    </message>
    <message>
        <source>The cutter goes {0} mm below the top of the stock, the tool is {1} mm long.</source>
        <translation>La fraise descend à {0} mm sous le dessus du brut, l'outil a {1} mm de long.</translation>
    </message>
    <message>
        <source>The cutter goes {0} mm into the walls.</source>
        <translation>La fraise entre de {0} mm dans les parois.</translation>
    </message>
    <message>
        <source>The cutter has no room to go down anywhere in the pocket.</source>
        <translation>La fraise n'a nulle part la place de plonger dans la poche.</translation>
    </message>
    <message>
        <source>The depths are upside down: the pocket's floor (final depth {0} mm) is not below its top (start depth {1} mm).</source>
        <translation>Les profondeurs sont inversées : le fond de la poche (profondeur finale {0} mm) n'est pas sous le dessus (profondeur de départ {1} mm).</translation>
    </message>
    <message>
        <source>The expression of {0} cannot be evaluated: {1}.</source>
        <translation>L'expression de {0} ne peut être évaluée : {1}.</translation>
    </message>
    <message>
        <source>The feed is lowered there; take a lower one if that is too heavy for the cutter.</source>
        <translation>L'avance y est réduite ; prenez-en une plus faible si c'est trop lourd pour la fraise.</translation>
    </message>
    <message>
        <source>The finish depth of {0} mm is not between 0 and the step down of {1} mm.</source>
        <translation>La profondeur de finition de {0} mm n'est pas entre 0 et la passe de {1} mm.</translation>
    </message>
    <message>
        <source>The fit of {0} patches has no solution.</source>
        <translation>L'ajustement de {0} morceaux de courbe n'a pas de solution.</translation>
    </message>
    <message>
        <source>The floor goes on beyond what is selected; that stays.</source>
        <translation>Le fond continue au-delà de ce qui est sélectionné ; cela reste.</translation>
    </message>
    <message>
        <source>The heights are upside down: clearance {0} mm, safe {1} mm, start depth {2} mm.</source>
        <translation>Les hauteurs sont inversées : dégagement {0} mm, sécurité {1} mm, profondeur de départ {2} mm.</translation>
    </message>
    <message>
        <source>The helix's diameter limit is negative.</source>
        <translation>La limite du diamètre de l'hélice est négative.</translation>
    </message>
    <message>
        <source>The hole ends at Z{0}, the part goes down to Z{1}; the cutter goes down to Z{2}.</source>
        <translation>L’ouverture se termine à Z{0}, la pièce descend jusqu’à Z{1} ; la fraise descend jusqu’à Z{2}.</translation>
    </message>
    <message>
        <source>The horizontal feed of {0} mm/min is more than the chosen machine does; the program runs at {1} mm/min.</source>
        <translation>L'avance horizontale de {0} mm/min dépasse ce que fait la machine choisie ; le programme tourne à {1} mm/min.</translation>
    </message>
    <message>
        <source>The largest feed ratio of {0} is below 1.</source>
        <translation>Le rapport d'avance maximal {0} est inférieur à 1.</translation>
    </message>
    <message>
        <source>The level from Z{0} to Z{1} is not between 0 and the step down of {2} mm deep.</source>
        <translation>Le niveau de Z{0} à Z{1} n'a pas une profondeur entre 0 et la passe de {2} mm.</translation>
    </message>
    <message>
        <source>The link feed is negative.</source>
        <translation>L'avance de liaison est négative.</translation>
    </message>
    <message>
        <source>The lowest level, at Z{0}, is not the pocket's floor.</source>
        <translation>Le niveau le plus bas, à Z{0}, n'est pas le fond de la poche.</translation>
    </message>
    <message>
        <source>The machine file {0} cannot be read: {1}.</source>
        <translation>Le fichier machine {0} est illisible : {1}.</translation>
    </message>
    <message>
        <source>The machine file {0} is broken: {1}.</source>
        <translation>Le fichier machine {0} est défectueux : {1}.</translation>
    </message>
    <message>
        <source>The machine file {0} lacks {1}.</source>
        <translation>Il manque {1} au fichier machine {0}.</translation>
    </message>
    <message>
        <source>The outline of {0} crosses itself.</source>
        <translation>Le contour de {0} se croise.</translation>
    </message>
    <message>
        <source>The outline of {0} has points at infinity.</source>
        <translation>Le contour ({0}) a des points à l'infini.</translation>
    </message>
    <message>
        <source>The outline of {0} is broken ({1}).</source>
        <translation>Le contour ({0}) est défectueux ({1}).</translation>
    </message>
    <message>
        <source>The outline of {0} is not closed at X{1} Y{2}.</source>
        <translation>Le contour de {0} n'est pas fermé en X{1} Y{2}.</translation>
    </message>
    <message>
        <source>The part overhangs the whole floor; no cutter gets there from above.</source>
        <translation>La pièce surplombe tout le fond ; aucune fraise n'y accède d'en haut.</translation>
    </message>
    <message>
        <source>The part with {0} is an open shell, not a closed solid.</source>
        <translation>La pièce avec {0} est une coque ouverte, pas un solide fermé.</translation>
    </message>
    <message>
        <source>The path was made, but at {at} would cut {0} mm into a wall or the floor; it is not handed out.</source>
        <translation>Le parcours est fait, mais en {at} il couperait {0} mm dans une paroi ou le fond ; il n'est pas livré.</translation>
    </message>
    <message>
        <source>The path was made, but at {at} would run {0} mm through standing stock where it should not cut; it is not handed out.</source>
        <translation>Le parcours a été fait, mais traverserait en {at} {0} mm de matière là où il ne doit pas couper ; il n'est pas remis.</translation>
    </message>
    <message>
        <source>The plate has several summits.</source>
        <translation>La plaque a plusieurs sommets.</translation>
    </message>
    <message>
        <source>The pocket at {at} is cut by {0} instead of {1}: {2}.</source>
        <translation>La poche en {at} est usinée avec {0} au lieu de {1} : {2}.</translation>
    </message>
    <message>
        <source>The pocket at {at} is cut with a step-over of {0} mm instead of {1} mm: {2}.</source>
        <translation>La poche en {at} est usinée avec un pas latéral de {0} mm au lieu de {1} mm : {2}.</translation>
    </message>
    <message>
        <source>The pocket has no area.</source>
        <translation>La poche n'a pas de surface.</translation>
    </message>
    <message>
        <source>The pocket is more than {0} step-overs wide.</source>
        <translation>La poche fait plus de {0} pas de large.</translation>
    </message>
    <message>
        <source>The pocket is no wider than the {0} mm cutter{1}, at {at}.</source>
        <translation>La poche n'est pas plus large que la fraise de {0} mm{1}, en {at}.</translation>
    </message>
    <message>
        <source>The pocket is open at a side; the cutter runs out of it there.</source>
        <translation>La poche est ouverte d'un côté ; la fraise en sort par là.</translation>
    </message>
    <message>
        <source>The pocket is open at a side; the cutter stays within the floor there.</source>
        <translation>La poche est ouverte d'un côté ; la fraise y reste dans les limites du fond.</translation>
    </message>
    <message>
        <source>The pocket is too narrow at {at} for Isotherm: no isotherm leads through.</source>
        <translation>La poche est trop étroite en {at} pour Isothermes : aucune isotherme n'y passe.</translation>
    </message>
    <message>
        <source>The pocket lies beside the stock.</source>
        <translation>La poche se trouve à côté du brut.</translation>
    </message>
    <message>
        <source>The pocket's outline has points at infinity.</source>
        <translation>Le contour de la poche a des points à l'infini.</translation>
    </message>
    <message>
        <source>The pocket's outline is broken ({0}).</source>
        <translation>Le contour de la poche est défectueux ({0}).</translation>
    </message>
    <message>
        <source>The pocket's wall near {at} is too jagged or too narrow for Linear Morph.</source>
        <translation>La paroi de la poche près de {at} est trop dentelée ou trop étroite pour le Morphing linéaire.</translation>
    </message>
    <message>
        <source>The selected floor lies {0} mm above the stock.</source>
        <translation>Le fond choisi est à {0} mm au-dessus du brut.</translation>
    </message>
    <message>
        <source>The selected floor lies {0} mm below the stock.</source>
        <translation>Le fond choisi est à {0} mm sous le brut.</translation>
    </message>
    <message>
        <source>The slot bite is negative.</source>
        <translation>La profondeur de passe de la rainure est négative.</translation>
    </message>
    <message>
        <source>The slowed feed of {0} percent is not between 0 and 100 percent.</source>
        <translation>L'avance ralentie de {0} pour cent n'est pas entre 0 et 100.</translation>
    </message>
    <message>
        <source>The spindle runs in reverse; what CutMode calls climb is conventional then.</source>
        <translation>La broche tourne à l'envers ; ce que CutMode appelle en avalant est alors en opposition.</translation>
    </message>
    <message>
        <source>The spindle speed of {0} is 0; the program does not start it.</source>
        <translation>La vitesse de broche de {0} est 0 ; le programme ne la démarre pas.</translation>
    </message>
    <message>
        <source>The start point at {at} lies in none of the pockets.</source>
        <translation>Le point de départ en {at} n'est dans aucune des poches.</translation>
    </message>
    <message>
        <source>The start point is not a place.</source>
        <translation>Le point de départ n'est pas un lieu.</translation>
    </message>
    <message>
        <source>The stock reaches {0} mm above the height at which rapids go over it.</source>
        <translation>Le brut dépasse de {0} mm la hauteur des déplacements rapides.</translation>
    </message>
    <message>
        <source>The stock reaches {0} mm above the start depth; the cutter goes down through that without ramping.</source>
        <translation>Le brut dépasse de {0} mm la profondeur de départ ; la fraise le traverse sans rampe.</translation>
    </message>
    <message>
        <source>The strategy Automatic begins anywhere with room for a helix.</source>
        <translation>La stratégie Automatique commence partout où il y a la place pour une hélice.</translation>
    </message>
    <message>
        <source>The wall at {at} cannot be cut at Z{0}: {1}.</source>
        <translation>La paroi en {at} ne peut être coupée à Z{0} : {1}.</translation>
    </message>
    <message>
        <source>The wall of the pocket about {at} is too jagged for Central Spiral.</source>
        <translation>La paroi de la poche vers {at} est trop dentelée pour la Spirale centrale.</translation>
    </message>
    <message>
        <source>The walls' outline at Z{0} is not closed at {at}.</source>
        <translation>Le contour des parois à Z{0} n'est pas fermé en {at}.</translation>
    </message>
    <message>
        <source>The {0} is not a number.</source>
        <translation>{0} n'est pas un nombre.</translation>
    </message>
    <message>
        <source>The {0} mm cutter does not fit the pocket{1}: it is {2} mm wide at its widest, at {at}.</source>
        <translation>La fraise de {0} mm n'entre pas dans la poche{1} : elle fait {2} mm au plus large, en {at}.</translation>
    </message>
    <message>
        <source>The {0} mm cutter does not fit the room at {at}, {1} mm wide at its widest; that part ({2} mm2) stays uncut.</source>
        <translation>La fraise de {0} mm n'entre pas dans l'espace en {at}, large de {1} mm au plus ; cette partie ({2} mm2) reste non usinée.</translation>
    </message>
    <message>
        <source>The {0} mm cutter does not fit the {1} mm neck at {at}; that part ({2} mm2) stays uncut.</source>
        <translation>La fraise de {0} mm ne passe pas l'étranglement de {1} mm en {at} ; cette partie ({2} mm2) reste non usinée.</translation>
    </message>
    <message>
        <source>The {0} mm cutter does not fit {1} necks, up to {2} mm wide, the widest at {at}; these parts ({3} mm2) stay uncut.</source>
        <translation>La fraise de {0} mm ne passe pas {1} étranglements, larges de {2} mm au plus, le plus large en {at} ; ces parties ({3} mm2) restent non usinées.</translation>
    </message>
    <message>
        <source>The {0} mm cutter does not fit {1} rooms, up to {2} mm wide, the widest at {at}; these ({3} mm2) stay uncut.</source>
        <translation>La fraise de {0} mm n'entre pas dans {1} espaces, larges de {2} mm au plus, le plus large en {at} ; ceux-ci ({3} mm2) restent non usinés.</translation>
    </message>
    <message>
        <source>The {0} mm cutter fits the pocket, but has no room for its helix at {at} (circle of {1} mm).</source>
        <translation>La fraise de {0} mm entre dans la poche, mais n'a pas la place pour son hélice en {at} (cercle de {1} mm).</translation>
    </message>
    <message>
        <source>There is no machine '{0}'.</source>
        <translation>Il n'y a pas de machine '{0}'.</translation>
    </message>
    <message>
        <source>This FreeCAD cannot read {0}, which another version has saved.</source>
        <translation>Ce FreeCAD ne peut pas lire {0}, enregistré par une autre version.</translation>
    </message>
    <message>
        <source>This pocket is not cut.</source>
        <translation>Cette poche n'est pas usinée.</translation>
    </message>
    <message>
        <source>Try another step-over or strategy, and please report this pocket.</source>
        <translation>Essayez un autre pas ou une autre stratégie, et signalez cette poche.</translation>
    </message>
    <message>
        <source>Turn the part over, or machine it from another side.</source>
        <translation>Retournez la pièce, ou usinez-la d'un autre côté.</translation>
    </message>
    <message>
        <source>Unset UseOutline if they shall stand.</source>
        <translation>Désactivez UseOutline s'ils doivent rester.</translation>
    </message>
    <message>
        <source>Unset UseRestMachining to cut it all the same.</source>
        <translation>Désactivez UseRestMachining pour l'usiner quand même.</translation>
    </message>
    <message>
        <source>Use a flat end mill, or finish the floor with one.</source>
        <translation>Utilisez une fraise à bout plat, ou finissez-en le fond.</translation>
    </message>
    <message>
        <source>Walls lean over the floor; {0} mm2 of it below them stay uncut.</source>
        <translation>Des parois surplombent le fond ; {0} mm2 en dessous restent non usinés.</translation>
    </message>
    <message>
        <source>Walls that are not vertical keep steps up to {0} mm wide and {1} mm high, the widest at {at}.</source>
        <translation>Les parois non verticales gardent des marches jusqu'à {0} mm de large et {1} mm de haut, la plus large en {at}.</translation>
    </message>
    <message>
        <source>Where that is done already, lower StartDepth or set UseRestMachining.</source>
        <translation>Là où c'est déjà fait, abaissez StartDepth ou activez UseRestMachining.</translation>
    </message>
    <message>
        <source>With a slot bite of {0} mm a slot has more than {1} levels.</source>
        <translation>Avec une profondeur de passe de {0} mm une rainure a plus de {1} niveaux.</translation>
    </message>
    <message>
        <source>With {0} mm of stock to leave on the floor nothing is left to cut.</source>
        <translation>Avec {0} mm de surépaisseur au fond, il ne reste rien à usiner.</translation>
    </message>
    <message>
        <source>{0} does not start the spindle.</source>
        <translation>{0} ne démarre pas la broche.</translation>
    </message>
    <message>
        <source>{0} has no face {1}.</source>
        <translation>{0} n’a pas de face {1}.</translation>
    </message>
    <message>
        <source>{0} has no model.</source>
        <translation>{0} n'a pas de modèle.</translation>
    </message>
    <message>
        <source>{0} has no stock.</source>
        <translation>{0} n'a pas de brut.</translation>
    </message>
    <message>
        <source>{0} has no tool controller.</source>
        <translation>{0} n'a pas de contrôleur d'outil.</translation>
    </message>
    <message>
        <source>{0} has no tool, or one without a diameter.</source>
        <translation>{0} n'a pas d'outil, ou un outil sans diamètre.</translation>
    </message>
    <message>
        <source>{0} has no {1}; the path carries no feeds and its time is unknown.</source>
        <translation>{0} n’a pas d’{1} ; le parcours ne contient pas d’avances et sa durée est inconnue.</translation>
    </message>
    <message>
        <source>{0} has tool number 0, which stands for no tool.</source>
        <translation>{0} a le numéro d'outil 0, qui signifie aucun outil.</translation>
    </message>
    <message>
        <source>{0} is not a face.</source>
        <translation>{0} n'est pas une face.</translation>
    </message>
    <message>
        <source>{0} is not an end mill; it cannot clear a pocket.</source>
        <translation>{0} n'est pas une fraise deux tailles ; il ne peut vider une poche.</translation>
    </message>
    <message>
        <source>{0} is not flat at its end and leaves ridges on the floor.</source>
        <translation>{0} n'a pas le bout plat et laisse des crêtes au fond.</translation>
    </message>
    <message>
        <source>{0} is not flat.</source>
        <translation>{0} n'est pas plane.</translation>
    </message>
    <message>
        <source>{0} is not in a job.</source>
        <translation>{0} n'est dans aucune tâche.</translation>
    </message>
    <message>
        <source>{0} is not in the job's model.</source>
        <translation>{0} ne fait pas partie du modèle de la tâche.</translation>
    </message>
    <message>
        <source>{0} is not level.</source>
        <translation>{0} n'est pas horizontale.</translation>
    </message>
    <message>
        <source>{0} is not the floor of a pocket: no wall rises from it.</source>
        <translation>{0} n'est pas le fond d'une poche : aucune paroi n'en monte.</translation>
    </message>
    <message>
        <source>{0} is not there any more: the model has changed.</source>
        <translation>{0} n'existe plus : le modèle a changé.</translation>
    </message>
    <message>
        <source>{0} is vertical: it is a wall, not a floor.</source>
        <translation>{0} est verticale : c'est une paroi, pas un fond.</translation>
    </message>
    <message>
        <source>{0} is {1}; it must be more than 0.</source>
        <translation>{0} : {1}. La valeur doit être supérieure à 0.</translation>
    </message>
    <message>
        <source>{0} leaves the radius of its corner, {1} mm, at the foot of walls.</source>
        <translation>{0} laisse le rayon de son coin, {1} mm, au pied des parois.</translation>
    </message>
    <message>
        <source>{0} looks down.</source>
        <translation>{0} regarde vers le bas.</translation>
    </message>
    <message>
        <source>{0} meet, but do not make one floor.</source>
        <translation>{0} se touchent, mais ne forment pas un seul fond.</translation>
    </message>
    <message>
        <source>{0} mm2 of the floor stay uncut, the largest part at {at}.</source>
        <translation>{0} mm2 du fond restent non usinés, la plus grande partie en {at}.</translation>
    </message>
    <message>
        <source>{0} mm2 of the pocket lie beside the stock, at {at}.</source>
        <translation>{0} mm2 de la poche se trouvent à côté du brut, en {at}.</translation>
    </message>
</context>
<context>
    <name>SpiralPocketPanel</name>
    <message>
        <source>Tool controller</source>
        <translation>Contrôleur d'outil</translation>
    </message>
    <message>
        <source>The tool and its feeds and speed</source>
        <translation>L'outil, ses avances et sa vitesse</translation>
    </message>
    <message>
        <source>Coolant</source>
        <translation>Arrosage</translation>
    </message>
    <message>
        <source>The coolant of this operation</source>
        <translation>L'arrosage de cette opération</translation>
    </message>
    <message>
        <source>Show feeds, speed and tool here, to change them for all operations with this tool controller</source>
        <translation>Montrer ici avances, vitesse et outil, pour les changer dans toutes les opérations qui ont ce contrôleur d'outil</translation>
    </message>
    <message>
        <source>Edit Tool Controller</source>
        <translation>Modifier le contrôleur d'outil</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>Stratégie</translation>
    </message>
    <message>
        <source>Step over percent</source>
        <translation>Pas latéral (%)</translation>
    </message>
    <message>
        <source>Step over</source>
        <translation>Pas latéral</translation>
    </message>
    <message>
        <source>Engagement angle</source>
        <translation>Angle d'engagement</translation>
    </message>
    <message>
        <source>Cut mode</source>
        <translation>Sens de coupe</translation>
    </message>
    <message>
        <source>XY stock to leave</source>
        <translation>Surépaisseur XY</translation>
    </message>
    <message>
        <source>Z stock to leave</source>
        <translation>Surépaisseur Z</translation>
    </message>
    <message>
        <source>Helix ramp angle</source>
        <translation>Angle de l'hélice</translation>
    </message>
    <message>
        <source>Helix max diameter</source>
        <translation>Diamètre max. de l'hélice</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Feed mode</source>
        <translation>Mode d'avance</translation>
    </message>
    <message>
        <source>Slow-down percent</source>
        <translation>Avance ralentie (%)</translation>
    </message>
    <message>
        <source>Max feed ratio</source>
        <translation>Rapport d'avance max.</translation>
    </message>
    <message>
        <source>Finishing profile</source>
        <translation>Passe de finition</translation>
    </message>
    <message>
        <source>Ignore islands</source>
        <translation>Ignorer les îlots</translation>
    </message>
    <message>
        <source>Show options that are rarely needed</source>
        <translation>Montrer les options rarement utiles</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Avancé</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>Link feed</source>
        <translation>Avance de liaison</translation>
    </message>
    <message>
        <source>Slot bite</source>
        <translation>Passe en rainure</translation>
    </message>
    <message>
        <source>Extend open sides</source>
        <translation>Prolonger les côtés ouverts</translation>
    </message>
    <message>
        <source>Use rest machining</source>
        <translation>Usinage de reprise</translation>
    </message>
    <message>
        <source>Use start point</source>
        <translation>Utiliser un point de départ</translation>
    </message>
    <message>
        <source>Start point X</source>
        <translation>Point de départ X</translation>
    </message>
    <message>
        <source>Start point Y</source>
        <translation>Point de départ Y</translation>
    </message>
    <message>
        <source>Take the place that was clicked on the part</source>
        <translation>Prendre l'endroit cliqué sur la pièce</translation>
    </message>
    <message>
        <source>From selection</source>
        <translation>Depuis la sélection</translation>
    </message>
</context>
<context>
    <name>SpiralPocketPreferences</name>
    <message>
        <source>Spiral Pocket</source>
        <translation>Poche en spirale</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Folder with own machines</source>
        <translation>Dossier de vos machines</translation>
    </message>
    <message>
        <source>Machine files (JSON) in this folder are offered besides those of the add-on; after the next start</source>
        <translation>Les fichiers machine (JSON) de ce dossier s'ajoutent à ceux de l'extension, dès le prochain démarrage</translation>
    </message>
    <message>
        <source>Defaults of new operations</source>
        <translation>Valeurs par défaut des nouvelles opérations</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>Stratégie</translation>
    </message>
    <message>
        <source>Step over percent</source>
        <translation>Pas latéral (%)</translation>
    </message>
    <message>
        <source>Cut mode</source>
        <translation>Sens de coupe</translation>
    </message>
    <message>
        <source>Helix ramp angle</source>
        <translation>Angle de l'hélice</translation>
    </message>
    <message>
        <source>Feed mode</source>
        <translation>Mode d'avance</translation>
    </message>
    <message>
        <source>Slow-down percent</source>
        <translation>Avance ralentie (%)</translation>
    </message>
    <message>
        <source>Max feed ratio</source>
        <translation>Rapport d'avance max.</translation>
    </message>
    <message>
        <source>Link feed</source>
        <translation>Avance de liaison</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
</context>
<context>
    <name>SpiralPocket_Create</name>
    <message>
        <source>Spiral Pocket</source>
        <translation>Poche en spirale</translation>
    </message>
    <message>
        <source>Clears the pockets above the selected floors with one smooth spiral each</source>
        <translation>Vide les poches au-dessus des fonds choisis, chacune d'une spirale lisse</translation>
    </message>
</context>
</TS>
