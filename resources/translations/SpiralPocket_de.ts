<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- SPDX-License-Identifier: LGPL-2.1-or-later -->
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>How the laps of the spiral are made</source>
        <translation>Wie die Umläufe der Spirale entstehen</translation>
    </message>
    <message>
        <source>Percent of cutter diameter to step over on each lap, at most</source>
        <translation>Seitliche Zustellung je Umlauf in Prozent des Fräserdurchmessers, höchstens</translation>
    </message>
    <message>
        <source>Largest engagement angle of a straight cut, in place of StepOver; 0 for that of StepOver</source>
        <translation>Größter Eingriffswinkel im geraden Schnitt, anstelle von StepOver; 0 für den von StepOver</translation>
    </message>
    <message>
        <source>Climb or conventional milling, for a spindle that turns clockwise</source>
        <translation>Gleichlauf oder Gegenlauf, bei rechtsdrehender Spindel</translation>
    </message>
    <message>
        <source>How much stock to leave in the XY plane (eg for finishing operation)</source>
        <translation>Wie viel Aufmaß in der XY-Ebene bleibt (etwa zum Schlichten)</translation>
    </message>
    <message>
        <source>How much stock to leave along the Z axis</source>
        <translation>Wie viel Aufmaß in Z bleibt</translation>
    </message>
    <message>
        <source>Ramp angle of the helical entry</source>
        <translation>Rampenwinkel beim Eintauchen auf der Helix</translation>
    </message>
    <message>
        <source>Limit helix entry diameter, if limit larger than tool diameter or 0, tool diameter is used</source>
        <translation>Grenze für den Helixdurchmesser; ist sie größer als der Werkzeugdurchmesser oder 0, gilt der Werkzeugdurchmesser</translation>
    </message>
    <message>
        <source>Largest deviation of the path from the exact curve</source>
        <translation>Größte Abweichung des Pfads von der exakten Kurve</translation>
    </message>
    <message>
        <source>The machine on which the time is to be least</source>
        <translation>Die Maschine, auf der die Zeit am kürzesten sein soll</translation>
    </message>
    <message>
        <source>How the feed follows the engagement: slowed where it passes the limit, slowed linearly with the chip, or raised where the chip is thin</source>
        <translation>Wie der Vorschub dem Eingriff folgt: langsamer, wo er die Grenze überschreitet, linear mit dem Span, oder schneller, wo der Span dünn ist</translation>
    </message>
    <message>
        <source>Feed at the largest radial depth of cut, in percent (Linear slow-down)</source>
        <translation>Vorschub bei der größten radialen Schnitttiefe, in Prozent (Linear verlangsamt)</translation>
    </message>
    <message>
        <source>Largest feed where the chip is thin, as a multiple of the tool controller's (Chip thickness)</source>
        <translation>Größter Vorschub bei dünnem Span, als Vielfaches des eingestellten (Spandicke)</translation>
    </message>
    <message>
        <source>Feed of moves at depth through cleared ground in mm/min, 0 for the horizontal rapid rate</source>
        <translation>Vorschub der Wege in der Tiefe durch geräumte Fläche in mm/min, 0 für den waagerechten Eilgang</translation>
    </message>
    <message>
        <source>Largest axial depth of one level of a slot that opens the pocket, 0 for automatic</source>
        <translation>Größte Tiefenzustellung je Ebene einer Nut, die die Tasche öffnet, 0 für automatisch</translation>
    </message>
    <message>
        <source>To take a finishing lap along the walls at the end; Automatic and Extended Archimedean do without, their laps finish the walls</source>
        <translation>Zum Schluss eine Schlichtbahn entlang der Wände; Automatisch und Erweitert archimedisch kommen ohne aus, dort schlichten die Umläufe die Wände</translation>
    </message>
    <message>
        <source>Ignore islands and clear everything inside the outline</source>
        <translation>Inseln ignorieren und alles innerhalb des Umrisses räumen</translation>
    </message>
    <message>
        <source>Clear the floor beyond its edge where no wall rises, and begin there in the air where the stock ends near by; else the cutter stays within the floor</source>
        <translation>Den Boden über seinen Rand hinaus räumen, wo keine Wand aufsteigt, und dort in der Luft beginnen, wo das Rohteil nahebei endet; sonst bleibt der Fräser innerhalb des Bodens</translation>
    </message>
    <message>
        <source>Cut only what earlier operations of the job have left standing in the pocket</source>
        <translation>Nur räumen, was frühere Operationen des Auftrags in der Tasche stehen ließen</translation>
    </message>
    <message>
        <source>Make True, if specifying a Start Point</source>
        <translation>Auf Wahr setzen, wenn ein Startpunkt angegeben wird</translation>
    </message>
    <message>
        <source>Where the cutter goes down, as near as it can; its height does not matter</source>
        <translation>Wo der Fräser eintaucht, so nah wie möglich; die Höhe ist ohne Bedeutung</translation>
    </message>
    <message>
        <source>The exact curves behind the path, B-splines at the floors; can be exported to STEP</source>
        <translation>Die exakten Kurven hinter dem Pfad, B-Splines auf den Böden; als STEP exportierbar</translation>
    </message>
    <message>
        <source>Largest engagement angle that was measured, at the floor after the entry</source>
        <translation>Größter gemessener Eingriffswinkel, am Boden nach dem Eintauchen</translation>
    </message>
    <message>
        <source>Area within the cutter's reach left standing, in mm^2</source>
        <translation>Für den Fräser erreichbare, stehen gebliebene Fläche in mm^2</translation>
    </message>
    <message>
        <source>How far the cutter passes the walls, measured</source>
        <translation>Wie weit der Fräser in die Wände gerät, gemessen</translation>
    </message>
    <message>
        <source>Length of all cutting moves</source>
        <translation>Länge aller Schnittwege</translation>
    </message>
    <message>
        <source>Time of the path on the chosen machine, in seconds</source>
        <translation>Zeit des Pfades auf der gewählten Maschine, in Sekunden</translation>
    </message>
    <message>
        <source>What the machinist should know about this path</source>
        <translation>Was an diesem Pfad zu beachten ist</translation>
    </message>
    <message>
        <source>Version of these properties</source>
        <translation>Version dieser Eigenschaften</translation>
    </message>
</context>
<context>
    <name>SpiralPocket</name>
    <message>
        <source>{} was saved by a FreeCAD without Spiral Pocket; its path may be older than the part. Recompute the document.</source>
        <translation>{} wurde von einem FreeCAD ohne Spiral Pocket gespeichert; der Pfad kann älter sein als das Teil. Das Dokument neu berechnen.</translation>
    </message>
    <message>
        <source>Compare...</source>
        <translation>Vergleichen...</translation>
    </message>
    <message>
        <source>All strategies side by side</source>
        <translation>Alle Strategien nebeneinander</translation>
    </message>
    <message>
        <source>Use this</source>
        <translation>Diese nehmen</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Cutting length</source>
        <translation>Schnittlänge</translation>
    </message>
    <message>
        <source>Largest engagement</source>
        <translation>Größter Eingriff</translation>
    </message>
    <message>
        <source>99 % of it below</source>
        <translation>99 % davon unter</translation>
    </message>
    <message>
        <source>Mean engagement</source>
        <translation>Mittlerer Eingriff</translation>
    </message>
    <message>
        <source>Left uncut in reach</source>
        <translation>Ungeschnitten in Reichweite</translation>
    </message>
    <message>
        <source>the fastest that keeps the limit of engagement on 99 % of the way and leaves nothing uncut</source>
        <translation>die schnellste, die die Eingriffsgrenze auf 99 % des Weges hält und nichts stehen lässt</translation>
    </message>
    <message>
        <source>An error, see the Report view.</source>
        <translation>Ein Fehler, siehe Berichtsansicht.</translation>
    </message>
    <message>
        <source>Planning... {:.0f} %</source>
        <translation>Wird geplant... {:.0f} %</translation>
    </message>
    <message>
        <source>No path</source>
        <translation>Kein Pfad</translation>
    </message>
    <message>
        <source>FreeCAD's Adaptive</source>
        <translation>Adaptive von FreeCAD</translation>
    </message>
    <message>
        <source>Compare strategies</source>
        <translation>Strategien vergleichen</translation>
    </message>
    <message>
        <source>Pocket {} ({}), {}</source>
        <translation>Tasche {} ({}), {}</translation>
    </message>
    <message>
        <source>No pocket: the first line of the panel says why.</source>
        <translation>Keine Tasche: Die erste Zeile des Panels sagt, warum.</translation>
    </message>
    <message>
        <source>With the same cutter, step-over and feeds on {}. Limit of engagement {:.0f}°; what clearly passes it, or stays uncut, is red. ★ the fastest that keeps it on 99 % of the way and leaves nothing uncut.</source>
        <translation>Mit demselben Fräser, gleicher seitlicher Zustellung und gleichen Vorschüben auf {}. Grenze des Eingriffs {:.0f}°; was sie deutlich überschreitet oder stehen bleibt, ist rot. ★ die schnellste, die sie auf 99 % des Weges einhält und nichts stehen lässt.</translation>
    </message>
    <message>
        <source>Create Spiral Pocket</source>
        <translation>Spiraltasche erzeugen</translation>
    </message>
    <message>
        <source>Type {} to {}.</source>
        <translation>{} bis {} eingeben.</translation>
    </message>
    <message>
        <source>Type more than {} and less than {}.</source>
        <translation>Mehr als {} und weniger als {} eingeben.</translation>
    </message>
    <message>
        <source>Type a number.</source>
        <translation>Eine Zahl eingeben.</translation>
    </message>
    <message>
        <source>Type a number; where no unit is typed, it is "{}".</source>
        <translation>Eine Zahl eingeben; ohne Angabe ist die Einheit „{}“.</translation>
    </message>
    <message>
        <source>Type {} or more.</source>
        <translation>Mindestens {} eingeben.</translation>
    </message>
    <message>
        <source>Type more than 0, at most {}.</source>
        <translation>Mehr als 0 eingeben, höchstens {}.</translation>
    </message>
    <message>
        <source>Feed of moves at depth through cleared ground, 0 for the horizontal rapid rate</source>
        <translation>Vorschub der Wege in der Tiefe durch geräumte Fläche, 0 für den waagerechten Eilgang</translation>
    </message>
    <message>
        <source>Set by the expression {}</source>
        <translation>Bestimmt durch den Ausdruck {}</translation>
    </message>
    <message>
        <source>The same step-over as a length, for this cutter</source>
        <translation>Dieselbe seitliche Zustellung als Länge, für diesen Fräser</translation>
    </message>
    <message>
        <source>The engagement angle of a straight cut at this step-over: 90° at half the cutter's diameter, 180° in a full slot</source>
        <translation>Der Eingriffswinkel im geraden Schnitt bei dieser seitlichen Zustellung: 90° beim halben Fräserdurchmesser, 180° in der vollen Nut</translation>
    </message>
    <message>
        <source>{}: "{}" is not taken, {} stays.</source>
        <translation>{}: „{}“ wird nicht übernommen, {} bleibt.</translation>
    </message>
    <message>
        <source>OK once more keeps what was made without that.</source>
        <translation>Noch einmal OK behält, was ohne das gemacht wurde.</translation>
    </message>
    <message>
        <source>The remarks in the result box say why.</source>
        <translation>Die Hinweise unter „Ergebnis“ sagen, warum.</translation>
    </message>
    <message>
        <source>OK once more keeps this path.</source>
        <translation>Noch einmal OK behält diesen Pfad.</translation>
    </message>
    <message>
        <source>An error in the add-on: the path was not computed.</source>
        <translation>Ein Fehler in der Erweiterung: der Pfad wurde nicht berechnet.</translation>
    </message>
    <message>
        <source>Please report it with the text in the Report view.</source>
        <translation>Bitte melden, mit dem Text aus der Berichtsansicht.</translation>
    </message>
    <message>
        <source>Remove Spiral Pocket</source>
        <translation>Spiraltasche entfernen</translation>
    </message>
    <message>
        <source>{} of the floor stay uncut.</source>
        <translation>{} des Bodens bleiben stehen.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Spiral Pocket</source>
        <translation>Spiraltasche</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Engagement, feed, velocity and force along the time</source>
        <translation>Eingriff, Vorschub, Geschwindigkeit und Kraft über der Zeit</translation>
    </message>
    <message>
        <source>Aluminum 6082-T6</source>
        <translation>Aluminium 6082-T6</translation>
    </message>
    <message>
        <source>Spiral Pocket plots</source>
        <translation>Diagramme der Spiraltasche</translation>
    </message>
    <message>
        <source>Mean cutting force in {} [N]</source>
        <translation>Mittlere Schnittkraft in {} [N]</translation>
    </message>
    <message>
        <source>No path: the first line of the panel says why.</source>
        <translation>Kein Pfad: Die erste Zeile des Panels sagt, warum.</translation>
    </message>
    <message>
        <source>Engagement [°]</source>
        <translation>Eingriff [°]</translation>
    </message>
    <message>
        <source>Time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>No force: no spindle speed in the tool controller</source>
        <translation>Keine Kraft: keine Spindeldrehzahl in der Werkzeugsteuerung</translation>
    </message>
    <message>
        <source>Plots need the Python library matplotlib.</source>
        <translation>Diagramme brauchen die Python-Bibliothek matplotlib.</translation>
    </message>
    <message>
        <source>Install it with the Addon Manager or pip.</source>
        <translation>Mit dem Addon-Manager oder pip installieren.</translation>
    </message>
    <message>
        <source>Programmed feed [{}]</source>
        <translation>Programmierter Vorschub [{}]</translation>
    </message>
    <message>
        <source>The machine's velocity [{}]</source>
        <translation>Geschwindigkeit der Maschine [{}]</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>Draw the path anew while values change</source>
        <translation>Den Pfad bei jeder Änderung neu zeichnen</translation>
    </message>
    <message>
        <source>What the colors of the cut show</source>
        <translation>Was die Farben des Schnitts zeigen</translation>
    </message>
    <message>
        <source>Play the cut</source>
        <translation>Schnitt abspielen</translation>
    </message>
    <message>
        <source>How far the cut is shown</source>
        <translation>Wie weit der Schnitt gezeigt wird</translation>
    </message>
    <message>
        <source>Feed [{}]</source>
        <translation>Vorschub [{}]</translation>
    </message>
    <message>
        <source>The mark is the limit at the step-over: {:.0f}°</source>
        <translation>Die Marke ist die Grenze bei dieser seitlichen Zustellung: {:.0f}°</translation>
    </message>
    <message>
        <source>entry</source>
        <translation>Eintauchen</translation>
    </message>
    <message>
        <source>link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>rapid</source>
        <translation>Eilgang</translation>
    </message>
    <message>
        <source>cleared</source>
        <translation>geräumt</translation>
    </message>
    <message>
        <source>left over</source>
        <translation>Rest</translation>
    </message>
    <message>
        <source>island</source>
        <translation>Insel</translation>
    </message>
    <message>
        <source>Switched off.</source>
        <translation>Ausgeschaltet.</translation>
    </message>
    <message>
        <source>This is the proved path.</source>
        <translation>Dies ist der geprüfte Pfad.</translation>
    </message>
    <message>
        <source>Draft. Stopped; Apply or the next change goes on.</source>
        <translation>Entwurf. Gestoppt; Anwenden oder die nächste Änderung geht weiter.</translation>
    </message>
    <message>
        <source>Draft. The path is being proved: {:.0f} %</source>
        <translation>Entwurf. Der Pfad wird geprüft: {:.0f} %</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>The operation has this path.</source>
        <translation>Die Operation hat diesen Pfad.</translation>
    </message>
    <message>
        <source>OK or Apply makes this path.</source>
        <translation>OK oder Anwenden erzeugt diesen Pfad.</translation>
    </message>
    <message>
        <source>Stopped: no new path. OK or Apply plans it again.</source>
        <translation>Gestoppt: kein neuer Pfad. OK oder Anwenden plant ihn neu.</translation>
    </message>
    <message>
        <source>Live is off: OK or Apply plans the path.</source>
        <translation>„Live“ ist aus: OK oder Anwenden plant den Pfad.</translation>
    </message>
    <message>
        <source>There is no path.</source>
        <translation>Es gibt keinen Pfad.</translation>
    </message>
    <message>
        <source>Planning: {:.0f} %</source>
        <translation>Planung: {:.0f} %</translation>
    </message>
    <message>
        <source>Click to see the place</source>
        <translation>Anklicken zeigt die Stelle</translation>
    </message>
    <message>
        <source>FreeCAD's estimate</source>
        <translation>Schätzung von FreeCAD</translation>
    </message>
    <message>
        <source>Entry at full width, deep</source>
        <translation>Eintauchen in voller Breite, tief</translation>
    </message>
    <message>
        <source>Gouge</source>
        <translation>Wandverletzung</translation>
    </message>
    <message>
        <source>{:.0f}°, limit {:.0f}°</source>
        <translation>{:.0f}°, Grenze {:.0f}°</translation>
    </message>
    <message>
        <source>whole width, {} deep</source>
        <translation>ganze Breite, {} tief</translation>
    </message>
    <message>
        <source>Time on {}</source>
        <translation>Zeit auf {}</translation>
    </message>
    <message>
        <source>{} (allowed: {})</source>
        <translation>{} (erlaubt: {})</translation>
    </message>
    <message>
        <source>pockets not cut: {}</source>
        <translation>Taschen nicht gefräst: {}</translation>
    </message>
    <message>
        <source>remarks: {}</source>
        <translation>Hinweise: {}</translation>
    </message>
    <message>
        <source>{} uncut</source>
        <translation>{} bleiben stehen</translation>
    </message>
    <message>
        <source>Any pocket, with islands and necks: holds the engagement, least time on the machine</source>
        <translation>Jede Tasche, auch mit Inseln und Engstellen: hält den Eingriff, kürzeste Zeit auf der Maschine</translation>
    </message>
    <message>
        <source>One exact B-spline from the middle to the wall, for pockets without islands</source>
        <translation>Ein exakter B-Spline von der Mitte bis zur Wand, für Taschen ohne Inseln</translation>
    </message>
    <message>
        <source>Even laps about the pocket's middle line, for long and branched pockets</source>
        <translation>Gleichmäßige Umläufe um die Mittellinie, für lange und verzweigte Taschen</translation>
    </message>
    <message>
        <source>Laps like lines of equal temperature, smooth everywhere, for compact pockets</source>
        <translation>Umläufe wie Linien gleicher Temperatur, überall glatt, für kompakte Taschen</translation>
    </message>
    <message>
        <source>A round spiral that turns into the wall's shape, for compact pockets</source>
        <translation>Eine runde Spirale, die in die Form der Wand übergeht, für kompakte Taschen</translation>
    </message>
    <message>
        <source>Start point</source>
        <translation>Startpunkt</translation>
    </message>
    <message>
        <source>"{}"</source>
        <translation>„{}“</translation>
    </message>
    <message>
        <source>Switched off: no path until Active is set again.</source>
        <translation>Abgeschaltet: kein Pfad, bis Active wieder gesetzt ist.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>Add one with an end mill to the job, then try again.</source>
        <translation>Dem Auftrag eine mit Schaftfräser hinzufügen und erneut versuchen.</translation>
    </message>
    <message>
        <source>{} has no tool controller that can clear a pocket.</source>
        <translation>{} hat keine Werkzeugsteuerung, die eine Tasche räumen kann.</translation>
    </message>
    <message>
        <source>Use as Default in This Job</source>
        <translation>Als Vorgabe in diesem Auftrag verwenden</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Linear Morph</source>
        <translation>Lineares Morphen</translation>
    </message>
    <message>
        <source>Extended Archimedean</source>
        <translation>Erweitert archimedisch</translation>
    </message>
    <message>
        <source>Isotherm</source>
        <translation>Isothermen</translation>
    </message>
    <message>
        <source>Central Spiral</source>
        <translation>Zentrale Spirale</translation>
    </message>
    <message>
        <source>Climb</source>
        <translation>Gleichlauf</translation>
    </message>
    <message>
        <source>Conventional</source>
        <translation>Gegenlauf</translation>
    </message>
    <message>
        <source>Constant</source>
        <translation>Konstant</translation>
    </message>
    <message>
        <source>Linear slow-down</source>
        <translation>Linear verlangsamt</translation>
    </message>
    <message>
        <source>Chip thickness</source>
        <translation>Spandicke</translation>
    </message>
    <message>
        <source>Benchtop mill</source>
        <translation>Tischfräsmaschine</translation>
    </message>
    <message>
        <source>Hobby router</source>
        <translation>Hobby-Portalfräse</translation>
    </message>
    <message>
        <source>Huron with Siemens 840D</source>
        <translation>Huron mit Siemens 840D</translation>
    </message>
    <message>
        <source>Mikron UCP710</source>
        <translation>Mikron UCP710</translation>
    </message>
    <message>
        <source>Vertical machining center</source>
        <translation>Vertikales Bearbeitungszentrum</translation>
    </message>
</context>
<context>
    <name>SpiralPocketMessages</name>
    <message>
        <source>the pocket</source>
        <translation>der Tasche</translation>
    </message>
    <message>
        <source>feeds</source>
        <translation>Vorschübe</translation>
    </message>
    <message>
        <source>horizontal feed</source>
        <translation>waagerechter Vorschub</translation>
    </message>
    <message>
        <source>vertical feed</source>
        <translation>senkrechter Vorschub</translation>
    </message>
    <message>
        <source>rapid</source>
        <translation>Eilgang</translation>
    </message>
    <message>
        <source>link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>the path asked for failed its proof</source>
        <translation>Der verlangte Pfad bestand die Prüfung nicht</translation>
    </message>
    <message>
        <source>the path asked for would leave {0} mm2 standing</source>
        <translation>Der verlangte Pfad ließe {0} mm2 stehen</translation>
    </message>
    <message>
        <source>The cutter's diameter</source>
        <translation>Fräserdurchmesser</translation>
    </message>
    <message>
        <source>The horizontal feed</source>
        <translation>Waagerechter Vorschub</translation>
    </message>
    <message>
        <source>The vertical feed</source>
        <translation>Senkrechter Vorschub</translation>
    </message>
    <message>
        <source>The horizontal rapid rate</source>
        <translation>Waagerechter Eilgang</translation>
    </message>
    <message>
        <source>The vertical rapid rate</source>
        <translation>Senkrechter Eilgang</translation>
    </message>
    <message>
        <source>The tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>XY stock to leave</source>
        <translation>XY-Aufmaß</translation>
    </message>
    <message>
        <source>Z stock to leave</source>
        <translation>Z-Aufmaß</translation>
    </message>
    <message>
        <source>with {0} mm of stock to leave</source>
        <translation>mit {0} mm Aufmaß</translation>
    </message>
    <message>
        <source>Pocket {0} of {1}: {2}</source>
        <translation>Tasche {0} von {1}: {2}</translation>
    </message>
    <message>
        <source>0.01 mm is usual.</source>
        <translation>Üblich sind 0,01 mm.</translation>
    </message>
    <message>
        <source>A cutter below {0} mm reaches all of them.</source>
        <translation>Ein Fräser unter {0} mm kommt überall hin.</translation>
    </message>
    <message>
        <source>A cutter below {0} mm reaches it.</source>
        <translation>Ein Fräser unter {0} mm kommt hin.</translation>
    </message>
    <message>
        <source>A cutter below {0} mm reaches {1} of them.</source>
        <translation>Ein Fräser unter {0} mm kommt zu {1} davon.</translation>
    </message>
    <message>
        <source>A depth or height is {0}; it must be a number of millimeters.</source>
        <translation>Eine Tiefe oder Höhe ist {0}; sie muss eine Zahl von Millimetern sein.</translation>
    </message>
    <message>
        <source>A helix angle of {0} degrees cannot be cut.</source>
        <translation>Ein Helixwinkel von {0} Grad lässt sich nicht fräsen.</translation>
    </message>
    <message>
        <source>A largest engagement of {0} degrees cannot be cut.</source>
        <translation>Ein größter Eingriff von {0} Grad lässt sich nicht fräsen.</translation>
    </message>
    <message>
        <source>A smaller StepDown makes them smaller; a finishing operation removes them.</source>
        <translation>Mit kleinerem Wert von StepDown werden sie kleiner; eine Schlichtoperation entfernt sie.</translation>
    </message>
    <message>
        <source>A smaller step-over may clear it.</source>
        <translation>Eine kleinere seitliche Zustellung kann ihn räumen.</translation>
    </message>
    <message>
        <source>A step down of {0} mm makes more than {1} levels.</source>
        <translation>Eine Tiefenzustellung von {0} mm ergibt mehr als {1} Ebenen.</translation>
    </message>
    <message>
        <source>A step down of {0} mm never reaches the floor.</source>
        <translation>Mit {0} mm Tiefenzustellung wird der Boden nie erreicht.</translation>
    </message>
    <message>
        <source>A step-over of {0} mm is wider than the {1} mm cutter.</source>
        <translation>{0} mm seitliche Zustellung sind mehr, als der {1}-mm-Fräser breit ist.</translation>
    </message>
    <message>
        <source>A step-over of {0} mm never clears the pocket.</source>
        <translation>Mit {0} mm seitlicher Zustellung wird die Tasche nie leer.</translation>
    </message>
    <message>
        <source>A tolerance of {0} mm is too coarse for this cutter.</source>
        <translation>Eine Toleranz von {0} mm ist zu grob für diesen Fräser.</translation>
    </message>
    <message>
        <source>A {0} move runs through standing stock at {at}, {1} mm in all.</source>
        <translation>Bei {at} fährt ein Weg ({0}) durch stehendes Material, zusammen {1} mm.</translation>
    </message>
    <message>
        <source>Above Z{0} also {1} mm2 beside the selected floor are cleared, down to ledges.</source>
        <translation>Über Z{0} werden auch {1} mm2 neben dem gewählten Boden geräumt, bis auf Absätze hinab.</translation>
    </message>
    <message>
        <source>Above the floor the pocket has notches that the {0} mm cutter does not fit, the largest at {at}; these ({1} mm2) stay uncut.</source>
        <translation>Über dem Boden hat die Tasche Kerben, in die der {0}-mm-Fräser nicht passt, die größte bei {at}; diese ({1} mm2) bleiben stehen.</translation>
    </message>
    <message>
        <source>Add it; vmc.json shows how.</source>
        <translation>Ergänzen; vmc.json zeigt, wie.</translation>
    </message>
    <message>
        <source>Add the part to the job's model.</source>
        <translation>Das Werkstück zum Modell des Auftrags hinzufügen.</translation>
    </message>
    <message>
        <source>Another part of the job covers the whole floor; no cutter gets there from above.</source>
        <translation>Ein anderes Teil des Auftrags verdeckt den ganzen Boden; von oben kommt kein Fräser hin.</translation>
    </message>
    <message>
        <source>Another part of the job covers {0} mm2 of the floor; that stays uncut.</source>
        <translation>Ein anderes Teil des Auftrags verdeckt {0} mm2 des Bodens; das bleibt stehen.</translation>
    </message>
    <message>
        <source>Another part of the job stands in the pocket or over it; the cutter keeps off that.</source>
        <translation>Ein anderes Teil des Auftrags steht in der Tasche oder über ihr; der Fräser hält sich davon fern.</translation>
    </message>
    <message>
        <source>At Z{0} the pocket reaches under a wall.</source>
        <translation>Bei Z{0} reicht die Tasche unter eine Wand.</translation>
    </message>
    <message>
        <source>At a helix angle of {0} degrees the cutter goes round more than {1} times on its way down.</source>
        <translation>Bei einem Helixwinkel von {0} Grad läuft der Fräser auf dem Weg nach unten mehr als {1}-mal im Kreis.</translation>
    </message>
    <message>
        <source>At {at} the cutter cuts {0} mm into the wall.</source>
        <translation>Bei {at} schneidet der Fräser {0} mm in die Wand.</translation>
    </message>
    <message>
        <source>At {at} the engagement reaches {0} degrees, the step-over of {1} % allows {2}; {3} % of the cut clearly pass that.</source>
        <translation>Bei {at} erreicht der Eingriff {0} Grad, die seitliche Zustellung von {1} % erlaubt {2}; {3} % des Schnitts liegen deutlich darüber.</translation>
    </message>
    <message>
        <source>Below Z{0} that part stays uncut.</source>
        <translation>Unter Z{0} bleibt dieser Teil stehen.</translation>
    </message>
    <message>
        <source>Below Z{0} the pocket is too narrow and stays uncut.</source>
        <translation>Unter Z{0} ist die Tasche zu eng und bleibt stehen.</translation>
    </message>
    <message>
        <source>Central Spiral cannot go round islands; there is one at {at}.</source>
        <translation>Die Zentrale Spirale kann Inseln nicht umfahren; bei {at} ist eine.</translation>
    </message>
    <message>
        <source>Central Spiral needs a pocket whose whole wall can be seen from one place in its middle; the one at {at} has walls behind corners.</source>
        <translation>Die Zentrale Spirale braucht eine Tasche, deren ganze Wand von einer Stelle in der Mitte zu sehen ist; die bei {at} hat Wände hinter Ecken.</translation>
    </message>
    <message>
        <source>Check the geometry of the part and the job's stock.</source>
        <translation>Die Geometrie des Teils und des Rohteils im Auftrag prüfen.</translation>
    </message>
    <message>
        <source>Check the outline for tiny steps, or choose a smaller cutter.</source>
        <translation>Den Umriss auf winzige Stufen prüfen oder einen kleineren Fräser wählen.</translation>
    </message>
    <message>
        <source>Check the part's geometry in the Part workbench and repair the face.</source>
        <translation>Die Geometrie im Arbeitsbereich Part prüfen und die Fläche reparieren.</translation>
    </message>
    <message>
        <source>Check the part's geometry in the Part workbench.</source>
        <translation>Die Geometrie im Arbeitsbereich Part prüfen.</translation>
    </message>
    <message>
        <source>Checking the pocket</source>
        <translation>Tasche wird geprüft</translation>
    </message>
    <message>
        <source>Choose a tool controller with an end mill in it.</source>
        <translation>Eine Werkzeugsteuerung mit Schaftfräser wählen.</translation>
    </message>
    <message>
        <source>Choose another strategy, for example Automatic.</source>
        <translation>Eine andere Strategie wählen, etwa Automatisch.</translation>
    </message>
    <message>
        <source>Choose one of: {0}.</source>
        <translation>Zur Auswahl stehen: {0}.</translation>
    </message>
    <message>
        <source>Choose one with an end mill in it.</source>
        <translation>Eine mit Schaftfräser wählen.</translation>
    </message>
    <message>
        <source>Choose that strategy, or another step-over.</source>
        <translation>Diese Strategie wählen, oder eine andere seitliche Zustellung.</translation>
    </message>
    <message>
        <source>Choose the strategy Automatic or Isotherm for this pocket.</source>
        <translation>Für diese Tasche die Strategie Automatisch oder Isothermen wählen.</translation>
    </message>
    <message>
        <source>Choose your machine in Machine, or lower the feed in the tool controller.</source>
        <translation>Die eigene Maschine unter Machine wählen oder den Vorschub in der Werkzeugsteuerung senken.</translation>
    </message>
    <message>
        <source>Close it first (Part workbench, Check Geometry and Convert to Solid).</source>
        <translation>Zuerst schließen (Arbeitsbereich Part, Geometrie überprüfen und In Festkörper umwandeln).</translation>
    </message>
    <message>
        <source>Compare it with vmc.json.</source>
        <translation>Mit vmc.json vergleichen.</translation>
    </message>
    <message>
        <source>Cut them by a smaller cutter.</source>
        <translation>Diese mit einem kleineren Fräser schneiden.</translation>
    </message>
    <message>
        <source>Do not run this path; check the final depth and the floor stock.</source>
        <translation>Diesen Pfad nicht fahren; Endtiefe und Bodenaufmaß prüfen.</translation>
    </message>
    <message>
        <source>Do not run this path; try another strategy or step-over.</source>
        <translation>Diesen Pfad nicht fahren; andere Strategie oder seitliche Zustellung versuchen.</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Drag it into the job's operations.</source>
        <translation>In die Operationen des Auftrags ziehen.</translation>
    </message>
    <message>
        <source>Earlier operations have cleared more than 99 % of this pocket; what this cutter reaches of the rest is cut.</source>
        <translation>Frühere Operationen haben mehr als 99 % dieser Tasche geräumt; vom Rest wird gefräst, was dieser Fräser erreicht.</translation>
    </message>
    <message>
        <source>Earlier operations have cleared this pocket as far as this cutter reaches.</source>
        <translation>Frühere Operationen haben diese Tasche geräumt, soweit dieser Fräser reicht.</translation>
    </message>
    <message>
        <source>Earlier operations have cleared {0} % of this pocket; what this cutter reaches of the rest is cut.</source>
        <translation>Frühere Operationen haben {0} % dieser Tasche geräumt; vom Rest wird gefräst, was dieser Fräser erreicht.</translation>
    </message>
    <message>
        <source>Finish with a flat end mill where that must be sharp.</source>
        <translation>Mit einem flachen Schaftfräser schlichten, wo das scharf sein muss.</translation>
    </message>
    <message>
        <source>FreeCAD's Adaptive cannot be reached from here.</source>
        <translation>FreeCADs Adaptive ist von hier aus nicht erreichbar.</translation>
    </message>
    <message>
        <source>FreeCAD's Adaptive finds no path in this pocket.</source>
        <translation>FreeCADs Adaptive findet in dieser Tasche keinen Pfad.</translation>
    </message>
    <message>
        <source>FreeCAD's Adaptive has found no path in this pocket within {0} s.</source>
        <translation>FreeCADs Adaptive hat in dieser Tasche innerhalb von {0} s keinen Pfad gefunden.</translation>
    </message>
    <message>
        <source>Give it the number of an end mill, 1 or higher.</source>
        <translation>Die Nummer eines Schaftfräsers geben, 1 oder höher.</translation>
    </message>
    <message>
        <source>Install it with FreeCAD's Addon Manager (it is a dependency of Spiral Pocket) or with pip into the Python that FreeCAD uses, then start FreeCAD again.</source>
        <translation>Mit dem Addon-Manager von FreeCAD installieren (sie gehört zu Spiral Pocket) oder mit pip in das Python von FreeCAD, dann FreeCAD neu starten.</translation>
    </message>
    <message>
        <source>Islands on {0} mm2 of the floor are milled away.</source>
        <translation>Inseln auf {0} mm2 des Bodens werden weggefräst.</translation>
    </message>
    <message>
        <source>Isotherm would need more than {0} laps.</source>
        <translation>Isothermen bräuchte mehr als {0} Umläufe.</translation>
    </message>
    <message>
        <source>It comes with matplotlib 3.6 or later: install that with FreeCAD's Addon Manager, or choose another strategy.</source>
        <translation>Sie gehört zu matplotlib ab 3.6: das mit FreeCADs Addon-Manager installieren oder eine andere Strategie wählen.</translation>
    </message>
    <message>
        <source>Its faces are Face1 to Face{0}.</source>
        <translation>Seine Flächen sind Face1 bis Face{0}.</translation>
    </message>
    <message>
        <source>Keep clamps away from that side, or unset ExtendOpenSides.</source>
        <translation>Diese Seite von Spannmitteln frei halten oder ExtendOpenSides ausschalten.</translation>
    </message>
    <message>
        <source>Laps of Linear Morph would cross themselves at {at}, where the wall turns away from the middle of the pocket.</source>
        <translation>Umläufe des Linearen Morphens würden sich bei {at} kreuzen, wo sich die Wand von der Mitte der Tasche abwendet.</translation>
    </message>
    <message>
        <source>Laying the spiral</source>
        <translation>Spirale wird gelegt</translation>
    </message>
    <message>
        <source>Levels are {0} mm deep, the tool's cutting edge is {1} mm long.</source>
        <translation>Die Ebenen sind {0} mm tief, die Schneide des Werkzeugs ist {1} mm lang.</translation>
    </message>
    <message>
        <source>Linear Morph cannot go round islands; there is one at {at}.</source>
        <translation>Lineares Morphen kann Inseln nicht umfahren; bei {at} ist eine.</translation>
    </message>
    <message>
        <source>Linear Morph finds no middle to start from.</source>
        <translation>Lineares Morphen findet keine Mitte zum Anfangen.</translation>
    </message>
    <message>
        <source>Look what lies under the hole. If it goes on there, select a wall of that.</source>
        <translation>Nachsehen, was unter dem Durchbruch liegt. Geht er dort weiter, eine Wand davon auswählen.</translation>
    </message>
    <message>
        <source>Look what lies under the stock, or raise FinalDepth.</source>
        <translation>Nachsehen, was unter dem Rohteil liegt, oder FinalDepth anheben.</translation>
    </message>
    <message>
        <source>Look whether the stock is where it should be.</source>
        <translation>Nachsehen, ob das Rohteil liegt, wo es soll.</translation>
    </message>
    <message>
        <source>Lower FinishDepth or raise StepDown.</source>
        <translation>FinishDepth verringern oder StepDown vergrößern.</translation>
    </message>
    <message>
        <source>Lower StepDown, or take a longer tool.</source>
        <translation>StepDown verkleinern oder ein längeres Werkzeug nehmen.</translation>
    </message>
    <message>
        <source>Lower StockToLeave.</source>
        <translation>StockToLeave verringern.</translation>
    </message>
    <message>
        <source>Lower Tolerance if the wall must be truer.</source>
        <translation>Verringere Tolerance, wenn die Wand genauer sein muss.</translation>
    </message>
    <message>
        <source>Lower ZStockToLeave.</source>
        <translation>ZStockToLeave verringern.</translation>
    </message>
    <message>
        <source>Machine that part from another side, or with an undercutting tool.</source>
        <translation>Diesen Teil von einer anderen Seite oder mit einem Hinterschnittwerkzeug bearbeiten.</translation>
    </message>
    <message>
        <source>Mend or remove it.</source>
        <translation>Berichtigen oder entfernen.</translation>
    </message>
    <message>
        <source>More than {0} laps are left beside the spirals.</source>
        <translation>Neben den Spiralen bleiben mehr als {0} Umläufe.</translation>
    </message>
    <message>
        <source>Move this operation behind the one with the larger end mill, or unset UseRestMachining. Only flat end mills count: round ones leave ridges.</source>
        <translation>Diese Operation hinter die mit dem größeren Fräser schieben oder UseRestMachining ausschalten. Nur flache Schaftfräser zählen: runde hinterlassen Rillen.</translation>
    </message>
    <message>
        <source>Much the same is told of {0} more pockets (at {1}).</source>
        <translation>Fast dasselbe gilt für {0} weitere Taschen (bei {1}).</translation>
    </message>
    <message>
        <source>Much the same is told of {0} more pockets.</source>
        <translation>Fast dasselbe gilt für {0} weitere Taschen.</translation>
    </message>
    <message>
        <source>No cutter goes through so narrow a gap; check the model.</source>
        <translation>Durch einen so engen Spalt kommt kein Fräser; das Modell prüfen.</translation>
    </message>
    <message>
        <source>No earlier operation has cleared any of this pocket down to its floor; all is cut.</source>
        <translation>Keine frühere Operation hat etwas von dieser Tasche bis zum Boden geräumt; alles wird gefräst.</translation>
    </message>
    <message>
        <source>No face is selected.</source>
        <translation>Keine Fläche ist ausgewählt.</translation>
    </message>
    <message>
        <source>No isotherm leads to the slot.</source>
        <translation>Keine Isotherme führt zur Nut.</translation>
    </message>
    <message>
        <source>Nothing is cut below Z{0}.</source>
        <translation>Unter Z{0} wird nichts gefräst.</translation>
    </message>
    <message>
        <source>Of the step-over of {0} % Automatic uses {1}: wider laps would leave stock where they meet.</source>
        <translation>Von der seitlichen Zustellung von {0} % nutzt Automatisch {1}: Breitere Bahnen ließen Material stehen, wo sie sich treffen.</translation>
    </message>
    <message>
        <source>Open the document in that version, or make a new job here.</source>
        <translation>Das Dokument in jener Version öffnen oder hier einen neuen Auftrag anlegen.</translation>
    </message>
    <message>
        <source>Other strategies use it whole, and may leave stock.</source>
        <translation>Andere Strategien nutzen sie ganz und lassen womöglich Material stehen.</translation>
    </message>
    <message>
        <source>Planning feeds</source>
        <translation>Vorschübe werden geplant</translation>
    </message>
    <message>
        <source>Proving the path</source>
        <translation>Pfad wird nachgewiesen</translation>
    </message>
    <message>
        <source>Put an end mill into the tool controller.</source>
        <translation>Einen Schaftfräser in die Werkzeugsteuerung einsetzen.</translation>
    </message>
    <message>
        <source>Raise FinalDepth or ZStockToLeave if that is not meant.</source>
        <translation>FinalDepth oder ZStockToLeave anheben, wenn das nicht gemeint ist.</translation>
    </message>
    <message>
        <source>Raise HelixDiameterLimit.</source>
        <translation>Erhöhe HelixDiameterLimit.</translation>
    </message>
    <message>
        <source>Raise SafeHeight and ClearanceHeight above the stock.</source>
        <translation>Lege SafeHeight und ClearanceHeight über das Rohteil.</translation>
    </message>
    <message>
        <source>Raise SlotBite, or set it to 0 to have it found.</source>
        <translation>SlotBite anheben oder auf 0 setzen: Dann wird der Wert bestimmt.</translation>
    </message>
    <message>
        <source>Raise StartDepth to the top of the stock, or clear it with an operation before.</source>
        <translation>StartDepth auf die Oberseite des Rohteils anheben oder es vorher mit einer Operation räumen.</translation>
    </message>
    <message>
        <source>Raise StepDown.</source>
        <translation>StepDown anheben.</translation>
    </message>
    <message>
        <source>Raise StockToLeave if that is not meant.</source>
        <translation>StockToLeave anheben, wenn das nicht gemeint ist.</translation>
    </message>
    <message>
        <source>Recompute the operation to try again.</source>
        <translation>Zum erneuten Versuch die Operation neu berechnen.</translation>
    </message>
    <message>
        <source>Refine the part (Part workbench, Refine Shape), or select one of them.</source>
        <translation>Das Teil bereinigen (Arbeitsbereich Part, Form aufbereiten) oder eine davon wählen.</translation>
    </message>
    <message>
        <source>Remove it from the base geometry and select the floor of the pocket again.</source>
        <translation>Aus der Basisgeometrie entfernen und den Taschenboden neu auswählen.</translation>
    </message>
    <message>
        <source>Repair the part (Part workbench, Check Geometry).</source>
        <translation>Das Werkstück reparieren (Arbeitsbereich Part, Geometrie überprüfen).</translation>
    </message>
    <message>
        <source>Repairing the path</source>
        <translation>Pfad wird nachgebessert</translation>
    </message>
    <message>
        <source>Select a face of the job's model, or add that part to it.</source>
        <translation>Eine Fläche des Modells wählen, oder das Teil zum Modell des Auftrags hinzufügen.</translation>
    </message>
    <message>
        <source>Select all faces that make the floor, or refine the part.</source>
        <translation>Alle Flächen wählen, die den Boden bilden, oder das Teil aufbereiten.</translation>
    </message>
    <message>
        <source>Select the floor face of the pocket.</source>
        <translation>Die Bodenfläche der Tasche auswählen.</translation>
    </message>
    <message>
        <source>Select the floor of the pocket, a flat level face with walls around it, or a wall of a hole through the part that ends at one level face below.</source>
        <translation>Den Boden der Tasche auswählen, eine ebene waagerechte Fläche mit Wänden ringsum, oder eine Wand eines Durchbruchs, der unten an einer einzigen waagerechten Fläche endet.</translation>
    </message>
    <message>
        <source>Select the floor of the pocket, or turn the part over.</source>
        <translation>Den Boden der Tasche auswählen oder das Werkstück umdrehen.</translation>
    </message>
    <message>
        <source>Set ClearanceHeight above SafeHeight above StartDepth.</source>
        <translation>ClearanceHeight über SafeHeight über StartDepth setzen.</translation>
    </message>
    <message>
        <source>Set ExtendOpenSides, or clear that side with another operation.</source>
        <translation>ExtendOpenSides einschalten oder diese Seite mit einer anderen Operation räumen.</translation>
    </message>
    <message>
        <source>Set HelixAngle above 0 and below 90 degrees; 5 is usual.</source>
        <translation>HelixAngle über 0 und unter 90 Grad setzen; üblich sind 5.</translation>
    </message>
    <message>
        <source>Set HelixAngle above {0} degrees; 5 is usual.</source>
        <translation>HelixAngle auf mehr als {0} Grad setzen; üblich sind 5.</translation>
    </message>
    <message>
        <source>Set HelixDiameterLimit to 0 for no limit.</source>
        <translation>HelixDiameterLimit auf 0 setzen: keine Grenze.</translation>
    </message>
    <message>
        <source>Set LinkFeed to 0 for the horizontal rapid rate.</source>
        <translation>LinkFeed auf 0 setzen: waagerechter Eilgang.</translation>
    </message>
    <message>
        <source>Set MaxEngagement up to {0} degrees, or to 0 for StepOver's.</source>
        <translation>MaxEngagement auf höchstens {0} Grad setzen oder auf 0 für den von StepOver.</translation>
    </message>
    <message>
        <source>Set MaxFeedRatio to 1 or more; 2 is usual.</source>
        <translation>MaxFeedRatio auf mindestens 1 setzen; üblich sind 2.</translation>
    </message>
    <message>
        <source>Set SlotBite to 0 to have it found.</source>
        <translation>SlotBite auf 0 setzen: Dann wird der Wert bestimmt.</translation>
    </message>
    <message>
        <source>Set SlowdownPercent between 1 and 100; 75 is usual.</source>
        <translation>SlowdownPercent zwischen 1 und 100 setzen; üblich sind 75.</translation>
    </message>
    <message>
        <source>Set StartDepth above FinalDepth.</source>
        <translation>StartDepth über FinalDepth setzen.</translation>
    </message>
    <message>
        <source>Set StartPoint inside one, or do without.</source>
        <translation>StartPoint in eine setzen oder darauf verzichten.</translation>
    </message>
    <message>
        <source>Set StartPoint where a helix has room, or near the slot along the wall.</source>
        <translation>StartPoint dorthin setzen, wo eine Helix Platz hat, oder nahe an die Nut entlang der Wand.</translation>
    </message>
    <message>
        <source>Set StartPoint, or do without.</source>
        <translation>StartPoint setzen oder darauf verzichten.</translation>
    </message>
    <message>
        <source>Set StepDown above 0.</source>
        <translation>StepDown über 0 setzen.</translation>
    </message>
    <message>
        <source>Set StepOver above 0; 20 to 45 % of the cutter's diameter is usual.</source>
        <translation>StepOver über 0 setzen; üblich sind 20 bis 45 % des Fräserdurchmessers.</translation>
    </message>
    <message>
        <source>Set StepOver to 100 % or less.</source>
        <translation>StepOver auf höchstens 100 % setzen.</translation>
    </message>
    <message>
        <source>Set StepOver to {0}, or a smaller one.</source>
        <translation>StepOver auf {0} setzen, oder kleiner.</translation>
    </message>
    <message>
        <source>Set Tolerance to at most {0} mm.</source>
        <translation>Tolerance auf höchstens {0} mm setzen.</translation>
    </message>
    <message>
        <source>Set all depths and heights.</source>
        <translation>Alle Tiefen und Höhen setzen.</translation>
    </message>
    <message>
        <source>Set it in the tool controller, unless you start the spindle by hand.</source>
        <translation>Im Werkzeugcontroller setzen, wenn die Spindel nicht von Hand gestartet wird.</translation>
    </message>
    <message>
        <source>Set it in the tool of the tool controller.</source>
        <translation>Im Werkzeug der Werkzeugsteuerung einstellen.</translation>
    </message>
    <message>
        <source>Set it to 0 for none.</source>
        <translation>Auf 0 setzen für keines.</translation>
    </message>
    <message>
        <source>Set one up in the job's editor.</source>
        <translation>Im Editor des Auftrags eines anlegen.</translation>
    </message>
    <message>
        <source>Set the feeds in the tool controller.</source>
        <translation>Die Vorschübe in der Werkzeugsteuerung einstellen.</translation>
    </message>
    <message>
        <source>Set the horizontal and vertical feed in the tool controller.</source>
        <translation>Waagerechten und senkrechten Vorschub in der Werkzeugsteuerung einstellen.</translation>
    </message>
    <message>
        <source>Set the spindle's direction in the tool controller or the tool, or the other CutMode.</source>
        <translation>Die Drehrichtung der Spindel im Werkzeugcontroller oder im Werkzeug auf vorwärts setzen, oder den anderen CutMode.</translation>
    </message>
    <message>
        <source>Set the spindle's direction there, or in the tool, unless you start it by hand.</source>
        <translation>Die Drehrichtung der Spindel dort oder im Werkzeug setzen, wenn sie nicht von Hand gestartet wird.</translation>
    </message>
    <message>
        <source>Spiral Pocket needs shapely 2, this FreeCAD has {0}.</source>
        <translation>Spiral Pocket braucht shapely 2, dieses FreeCAD hat {0}.</translation>
    </message>
    <message>
        <source>Spiral Pocket needs the Python library {0}, which this FreeCAD lacks.</source>
        <translation>Spiral Pocket braucht die Python-Bibliothek {0}, die diesem FreeCAD fehlt.</translation>
    </message>
    <message>
        <source>Stopped by the user.</source>
        <translation>Vom Benutzer gestoppt.</translation>
    </message>
    <message>
        <source>Take a cutter below {0} mm.</source>
        <translation>Einen Fräser unter {0} mm nehmen.</translation>
    </message>
    <message>
        <source>Take a larger step-over or the strategy Automatic.</source>
        <translation>Eine größere seitliche Zustellung oder die Strategie Automatisch nehmen.</translation>
    </message>
    <message>
        <source>Take a longer tool; its holder would strike the part.</source>
        <translation>Nimm ein längeres Werkzeug; seine Aufnahme würde das Teil treffen.</translation>
    </message>
    <message>
        <source>Take a lower feed or a smaller SlotBite if that is too heavy for the cutter.</source>
        <translation>Den Vorschub verringern oder den Wert von SlotBite, wenn das dem Fräser zu viel ist.</translation>
    </message>
    <message>
        <source>Take a smaller cutter or the strategy Automatic.</source>
        <translation>Einen kleineren Fräser oder die Strategie Automatisch nehmen.</translation>
    </message>
    <message>
        <source>Take a smaller cutter.</source>
        <translation>Einen kleineren Fräser nehmen.</translation>
    </message>
    <message>
        <source>Take a smaller cutter; a hole as wide as the cutter is one for FreeCAD's Drilling.</source>
        <translation>Nimm einen kleineren Fräser; ein Loch so weit wie der Fräser ist etwas für FreeCADs Bohren.</translation>
    </message>
    <message>
        <source>Take a smaller cutter; a slot as wide as the cutter is one for FreeCAD's Slot.</source>
        <translation>Einen kleineren Fräser nehmen; eine Nut, so breit wie der Fräser, ist etwas für FreeCADs Nut-Operation (Slot).</translation>
    </message>
    <message>
        <source>Take a wider cutter or a larger step-over.</source>
        <translation>Einen breiteren Fräser oder eine größere seitliche Zustellung nehmen.</translation>
    </message>
    <message>
        <source>Take that part out of the job's model if it is not there when the pocket is cut.</source>
        <translation>Das Teil aus dem Modell des Auftrags nehmen, wenn es beim Fräsen der Tasche nicht da ist.</translation>
    </message>
    <message>
        <source>Take that part out of the job's model.</source>
        <translation>Das Teil aus dem Modell des Auftrags nehmen.</translation>
    </message>
    <message>
        <source>That part stays uncut.</source>
        <translation>Dieser Teil bleibt stehen.</translation>
    </message>
    <message>
        <source>The cutter goes down at {at}, {0} mm from the start point: that is as near as {1} can begin.</source>
        <translation>Der Fräser taucht bei {at} ein, {0} mm vom Startpunkt entfernt: Näher kann {1} nicht beginnen.</translation>
    </message>
    <message>
        <source>The cutter goes {0} mm below the floor.</source>
        <translation>Der Fräser geht {0} mm unter den Boden.</translation>
    </message>
    <message>
        <source>The cutter goes {0} mm below the selected floor, {1} mm of that below the stock.</source>
        <translation>Der Fräser geht {0} mm unter den gewählten Boden, davon {1} mm unter das Rohteil.</translation>
    </message>
    <message>
        <source>The cutter goes {0} mm below the selected floor.</source>
        <translation>Der Fräser geht {0} mm unter den gewählten Boden.</translation>
    </message>
    <message>
        <source>The cutter goes {0} mm below the top of the stock, the tool is {1} mm long.</source>
        <translation>Der Fräser geht {0} mm unter die Oberseite des Rohteils, das Werkzeug ist {1} mm lang.</translation>
    </message>
    <message>
        <source>The cutter goes {0} mm into the walls.</source>
        <translation>Der Fräser geht {0} mm in die Wände.</translation>
    </message>
    <message>
        <source>The cutter has no room to go down anywhere in the pocket.</source>
        <translation>Der Fräser hat nirgends in der Tasche Platz zum Eintauchen.</translation>
    </message>
    <message>
        <source>The depths are upside down: the pocket's floor (final depth {0} mm) is not below its top (start depth {1} mm).</source>
        <translation>Die Tiefen sind vertauscht: der Boden der Tasche (Endtiefe {0} mm) liegt nicht unter ihrer Oberkante (Starttiefe {1} mm).</translation>
    </message>
    <message>
        <source>The expression of {0} cannot be evaluated: {1}.</source>
        <translation>Der Ausdruck von {0} lässt sich nicht auswerten: {1}.</translation>
    </message>
    <message>
        <source>The feed is lowered there; take a lower one if that is too heavy for the cutter.</source>
        <translation>Der Vorschub wird dort gesenkt; einen kleineren nehmen, wenn das für den Fräser zu schwer ist.</translation>
    </message>
    <message>
        <source>The finish depth of {0} mm is not between 0 and the step down of {1} mm.</source>
        <translation>Die Schlichttiefe von {0} mm liegt nicht zwischen 0 und der Tiefenzustellung von {1} mm.</translation>
    </message>
    <message>
        <source>The fit of {0} patches has no solution.</source>
        <translation>Die Anpassung von {0} Kurvenstücken hat keine Lösung.</translation>
    </message>
    <message>
        <source>The floor goes on beyond what is selected; that stays.</source>
        <translation>Der Boden geht über das Gewählte hinaus weiter; das bleibt stehen.</translation>
    </message>
    <message>
        <source>The heights are upside down: clearance {0} mm, safe {1} mm, start depth {2} mm.</source>
        <translation>Die Höhen sind vertauscht: Freifahrhöhe {0} mm, Sicherheitshöhe {1} mm, Starttiefe {2} mm.</translation>
    </message>
    <message>
        <source>The helix's diameter limit is negative.</source>
        <translation>Die Grenze des Helixdurchmessers ist negativ.</translation>
    </message>
    <message>
        <source>The hole ends at Z{0}, the part goes down to Z{1}; the cutter goes down to Z{2}.</source>
        <translation>Der Durchbruch endet bei Z{0}, das Teil reicht bis Z{1} hinab; der Fräser geht bis Z{2}.</translation>
    </message>
    <message>
        <source>The horizontal feed of {0} mm/min is more than the chosen machine does; the program runs at {1} mm/min.</source>
        <translation>Der waagerechte Vorschub von {0} mm/min ist mehr, als die gewählte Maschine schafft; das Programm läuft mit {1} mm/min.</translation>
    </message>
    <message>
        <source>The largest feed ratio of {0} is below 1.</source>
        <translation>Der größte Vorschubfaktor {0} liegt unter 1.</translation>
    </message>
    <message>
        <source>The level from Z{0} to Z{1} is not between 0 and the step down of {2} mm deep.</source>
        <translation>Die Ebene von Z{0} bis Z{1} ist nicht zwischen 0 und der Tiefenzustellung von {2} mm tief.</translation>
    </message>
    <message>
        <source>The link feed is negative.</source>
        <translation>Der Verbindungsvorschub ist negativ.</translation>
    </message>
    <message>
        <source>The lowest level, at Z{0}, is not the pocket's floor.</source>
        <translation>Die unterste Ebene bei Z{0} ist nicht der Boden der Tasche.</translation>
    </message>
    <message>
        <source>The machine file {0} cannot be read: {1}.</source>
        <translation>Die Maschinendatei {0} ist nicht lesbar: {1}.</translation>
    </message>
    <message>
        <source>The machine file {0} is broken: {1}.</source>
        <translation>Die Maschinendatei {0} ist defekt: {1}.</translation>
    </message>
    <message>
        <source>The machine file {0} lacks {1}.</source>
        <translation>Der Maschinendatei {0} fehlt {1}.</translation>
    </message>
    <message>
        <source>The outline of {0} crosses itself.</source>
        <translation>Der Umriss von {0} kreuzt sich selbst.</translation>
    </message>
    <message>
        <source>The outline of {0} has points at infinity.</source>
        <translation>Der Umriss ({0}) hat Punkte im Unendlichen.</translation>
    </message>
    <message>
        <source>The outline of {0} is broken ({1}).</source>
        <translation>Der Umriss ({0}) ist fehlerhaft ({1}).</translation>
    </message>
    <message>
        <source>The outline of {0} is not closed at X{1} Y{2}.</source>
        <translation>Der Umriss von {0} ist bei X{1} Y{2} nicht geschlossen.</translation>
    </message>
    <message>
        <source>The part overhangs the whole floor; no cutter gets there from above.</source>
        <translation>Das Werkstück überdeckt den ganzen Boden; von oben kommt kein Fräser hin.</translation>
    </message>
    <message>
        <source>The part with {0} is an open shell, not a closed solid.</source>
        <translation>Das Werkstück mit {0} ist eine offene Schale, kein geschlossener Körper.</translation>
    </message>
    <message>
        <source>The path was made, but at {at} would cut {0} mm into a wall or the floor; it is not handed out.</source>
        <translation>Der Pfad ist fertig, würde aber bei {at} {0} mm in eine Wand oder den Boden schneiden; er wird nicht ausgegeben.</translation>
    </message>
    <message>
        <source>The path was made, but at {at} would run {0} mm through standing stock where it should not cut; it is not handed out.</source>
        <translation>Der Pfad wurde erzeugt, führe aber bei {at} {0} mm durch stehendes Material, wo er nicht schneiden soll; er wird nicht ausgegeben.</translation>
    </message>
    <message>
        <source>The plate has several summits.</source>
        <translation>Die Platte hat mehrere Gipfel.</translation>
    </message>
    <message>
        <source>The pocket at {at} is cut by {0} instead of {1}: {2}.</source>
        <translation>Die Tasche bei {at} wird mit {0} statt {1} gefräst: {2}.</translation>
    </message>
    <message>
        <source>The pocket at {at} is cut with a step-over of {0} mm instead of {1} mm: {2}.</source>
        <translation>Die Tasche bei {at} wird mit {0} statt {1} mm seitlicher Zustellung gefräst: {2}.</translation>
    </message>
    <message>
        <source>The pocket has no area.</source>
        <translation>Die Tasche hat keine Fläche.</translation>
    </message>
    <message>
        <source>The pocket is more than {0} step-overs wide.</source>
        <translation>Die Tasche ist mehr als {0} seitliche Zustellungen breit.</translation>
    </message>
    <message>
        <source>The pocket is no wider than the {0} mm cutter{1}, at {at}.</source>
        <translation>Die Tasche ist nicht weiter als der {0}-mm-Fräser{1}, bei {at}.</translation>
    </message>
    <message>
        <source>The pocket is open at a side; the cutter runs out of it there.</source>
        <translation>Die Tasche ist an einer Seite offen; dort läuft der Fräser aus ihr hinaus.</translation>
    </message>
    <message>
        <source>The pocket is open at a side; the cutter stays within the floor there.</source>
        <translation>Die Tasche ist an einer Seite offen; der Fräser bleibt dort innerhalb des Bodens.</translation>
    </message>
    <message>
        <source>The pocket is too narrow at {at} for Isotherm: no isotherm leads through.</source>
        <translation>Die Tasche ist bei {at} für Isothermen zu eng: keine Isotherme führt hindurch.</translation>
    </message>
    <message>
        <source>The pocket lies beside the stock.</source>
        <translation>Die Tasche liegt neben dem Rohteil.</translation>
    </message>
    <message>
        <source>The pocket's outline has points at infinity.</source>
        <translation>Der Umriss der Tasche hat Punkte im Unendlichen.</translation>
    </message>
    <message>
        <source>The pocket's outline is broken ({0}).</source>
        <translation>Der Umriss der Tasche ist defekt ({0}).</translation>
    </message>
    <message>
        <source>The pocket's wall near {at} is too jagged or too narrow for Linear Morph.</source>
        <translation>Die Wand der Tasche bei {at} ist für Lineares Morphen zu zackig oder zu eng.</translation>
    </message>
    <message>
        <source>The selected floor lies {0} mm above the stock.</source>
        <translation>Der gewählte Boden liegt {0} mm über dem Rohteil.</translation>
    </message>
    <message>
        <source>The selected floor lies {0} mm below the stock.</source>
        <translation>Der gewählte Boden liegt {0} mm unter dem Rohteil.</translation>
    </message>
    <message>
        <source>The slot bite is negative.</source>
        <translation>Der Tiefenschritt der Nut ist negativ.</translation>
    </message>
    <message>
        <source>The slowed feed of {0} percent is not between 0 and 100 percent.</source>
        <translation>Der verlangsamte Vorschub von {0} Prozent liegt nicht zwischen 0 und 100 Prozent.</translation>
    </message>
    <message>
        <source>The spindle runs in reverse; what CutMode calls climb is conventional then.</source>
        <translation>Die Spindel läuft rückwärts; was CutMode Gleichlauf nennt, ist dann Gegenlauf.</translation>
    </message>
    <message>
        <source>The spindle speed of {0} is 0; the program does not start it.</source>
        <translation>Die Spindeldrehzahl von {0} ist 0; das Programm startet sie nicht.</translation>
    </message>
    <message>
        <source>The start point at {at} lies in none of the pockets.</source>
        <translation>Der Startpunkt bei {at} liegt in keiner der Taschen.</translation>
    </message>
    <message>
        <source>The start point is not a place.</source>
        <translation>Der Startpunkt ist kein Ort.</translation>
    </message>
    <message>
        <source>The stock reaches {0} mm above the height at which rapids go over it.</source>
        <translation>Das Rohteil reicht {0} mm über die Höhe, in der Eilgänge darüber gehen.</translation>
    </message>
    <message>
        <source>The stock reaches {0} mm above the start depth; the cutter goes down through that without ramping.</source>
        <translation>Das Rohteil reicht {0} mm über die Starttiefe; der Fräser geht dort ohne Rampe hindurch.</translation>
    </message>
    <message>
        <source>The strategy Automatic begins anywhere with room for a helix.</source>
        <translation>Die Strategie Automatisch beginnt überall, wo Platz für eine Helix ist.</translation>
    </message>
    <message>
        <source>The wall at {at} cannot be cut at Z{0}: {1}.</source>
        <translation>Die Wand bei {at} lässt sich auf Z{0} nicht schneiden: {1}.</translation>
    </message>
    <message>
        <source>The wall of the pocket about {at} is too jagged for Central Spiral.</source>
        <translation>Die Wand der Tasche um {at} ist für die Zentrale Spirale zu zackig.</translation>
    </message>
    <message>
        <source>The walls' outline at Z{0} is not closed at {at}.</source>
        <translation>Der Umriss der Wände bei Z{0} ist bei {at} nicht geschlossen.</translation>
    </message>
    <message>
        <source>The {0} is not a number.</source>
        <translation>{0} ist keine Zahl.</translation>
    </message>
    <message>
        <source>The {0} mm cutter does not fit the pocket{1}: it is {2} mm wide at its widest, at {at}.</source>
        <translation>Der {0}-mm-Fräser passt nicht in die Tasche{1}: sie ist an ihrer weitesten Stelle, bei {at}, {2} mm breit.</translation>
    </message>
    <message>
        <source>The {0} mm cutter does not fit the room at {at}, {1} mm wide at its widest; that part ({2} mm2) stays uncut.</source>
        <translation>Der {0}-mm-Fräser passt nicht in den Raum bei {at}, der an der breitesten Stelle {1} mm breit ist; dieser Teil ({2} mm2) bleibt stehen.</translation>
    </message>
    <message>
        <source>The {0} mm cutter does not fit the {1} mm neck at {at}; that part ({2} mm2) stays uncut.</source>
        <translation>Der {0}-mm-Fräser passt nicht durch die Engstelle von {1} mm bei {at}; dieser Teil ({2} mm2) bleibt stehen.</translation>
    </message>
    <message>
        <source>The {0} mm cutter does not fit {1} necks, up to {2} mm wide, the widest at {at}; these parts ({3} mm2) stay uncut.</source>
        <translation>Der {0}-mm-Fräser passt nicht durch {1} Engstellen von bis zu {2} mm, die breiteste bei {at}; diese Teile ({3} mm2) bleiben stehen.</translation>
    </message>
    <message>
        <source>The {0} mm cutter does not fit {1} rooms, up to {2} mm wide, the widest at {at}; these ({3} mm2) stay uncut.</source>
        <translation>Der {0}-mm-Fräser passt nicht in {1} Räume von bis zu {2} mm Breite, der breiteste bei {at}; diese ({3} mm2) bleiben stehen.</translation>
    </message>
    <message>
        <source>The {0} mm cutter fits the pocket, but has no room for its helix at {at} (circle of {1} mm).</source>
        <translation>Der {0}-mm-Fräser passt in die Tasche, hat aber bei {at} keinen Platz für seine Helix (Kreis von {1} mm).</translation>
    </message>
    <message>
        <source>There is no machine '{0}'.</source>
        <translation>Es gibt keine Maschine '{0}'.</translation>
    </message>
    <message>
        <source>This FreeCAD cannot read {0}, which another version has saved.</source>
        <translation>Dieses FreeCAD kann {0} nicht lesen, von einer anderen Version gespeichert.</translation>
    </message>
    <message>
        <source>This pocket is not cut.</source>
        <translation>Diese Tasche wird nicht gefräst.</translation>
    </message>
    <message>
        <source>Try another step-over or strategy, and please report this pocket.</source>
        <translation>Andere seitliche Zustellung oder Strategie versuchen und diese Tasche bitte melden.</translation>
    </message>
    <message>
        <source>Turn the part over, or machine it from another side.</source>
        <translation>Das Werkstück umdrehen oder von einer anderen Seite bearbeiten.</translation>
    </message>
    <message>
        <source>Unset UseOutline if they shall stand.</source>
        <translation>UseOutline ausschalten, wenn sie stehen bleiben sollen.</translation>
    </message>
    <message>
        <source>Unset UseRestMachining to cut it all the same.</source>
        <translation>UseRestMachining ausschalten, um sie trotzdem zu fräsen.</translation>
    </message>
    <message>
        <source>Use a flat end mill, or finish the floor with one.</source>
        <translation>Einen flachen Schaftfräser nehmen oder den Boden damit schlichten.</translation>
    </message>
    <message>
        <source>Walls lean over the floor; {0} mm2 of it below them stay uncut.</source>
        <translation>Wände neigen sich über den Boden; {0} mm2 darunter bleiben stehen.</translation>
    </message>
    <message>
        <source>Walls that are not vertical keep steps up to {0} mm wide and {1} mm high, the widest at {at}.</source>
        <translation>An nicht senkrechten Wänden bleiben Stufen bis {0} mm Breite und {1} mm Höhe, die breiteste bei {at}.</translation>
    </message>
    <message>
        <source>Where that is done already, lower StartDepth or set UseRestMachining.</source>
        <translation>Wo das schon geschehen ist, StartDepth senken oder UseRestMachining setzen.</translation>
    </message>
    <message>
        <source>With a slot bite of {0} mm a slot has more than {1} levels.</source>
        <translation>Mit einem Tiefenschritt von {0} mm hat eine Nut mehr als {1} Ebenen.</translation>
    </message>
    <message>
        <source>With {0} mm of stock to leave on the floor nothing is left to cut.</source>
        <translation>Mit {0} mm Aufmaß am Boden bleibt nichts zu fräsen.</translation>
    </message>
    <message>
        <source>{0} does not start the spindle.</source>
        <translation>{0} startet die Spindel nicht.</translation>
    </message>
    <message>
        <source>{0} has no face {1}.</source>
        <translation>{0} hat keine Fläche {1}.</translation>
    </message>
    <message>
        <source>{0} has no model.</source>
        <translation>{0} hat kein Modell.</translation>
    </message>
    <message>
        <source>{0} has no stock.</source>
        <translation>{0} hat kein Rohteil.</translation>
    </message>
    <message>
        <source>{0} has no tool controller.</source>
        <translation>{0} hat keine Werkzeugsteuerung.</translation>
    </message>
    <message>
        <source>{0} has no tool, or one without a diameter.</source>
        <translation>{0} hat kein Werkzeug oder eines ohne Durchmesser.</translation>
    </message>
    <message>
        <source>{0} has no {1}; the path carries no feeds and its time is unknown.</source>
        <translation>Bei {0} fehlt: {1}; der Pfad enthält keine Vorschübe, und seine Zeit ist unbekannt.</translation>
    </message>
    <message>
        <source>{0} has tool number 0, which stands for no tool.</source>
        <translation>{0} hat die Werkzeugnummer 0, das heißt: kein Werkzeug.</translation>
    </message>
    <message>
        <source>{0} is not a face.</source>
        <translation>{0} ist keine Fläche.</translation>
    </message>
    <message>
        <source>{0} is not an end mill; it cannot clear a pocket.</source>
        <translation>{0} ist kein Schaftfräser und kann keine Tasche räumen.</translation>
    </message>
    <message>
        <source>{0} is not flat at its end and leaves ridges on the floor.</source>
        <translation>{0} ist unten nicht flach und hinterlässt Rillen am Boden.</translation>
    </message>
    <message>
        <source>{0} is not flat.</source>
        <translation>{0} ist nicht eben.</translation>
    </message>
    <message>
        <source>{0} is not in a job.</source>
        <translation>{0} ist in keinem Auftrag.</translation>
    </message>
    <message>
        <source>{0} is not in the job's model.</source>
        <translation>{0} gehört nicht zum Modell des Auftrags.</translation>
    </message>
    <message>
        <source>{0} is not level.</source>
        <translation>{0} ist nicht waagerecht.</translation>
    </message>
    <message>
        <source>{0} is not the floor of a pocket: no wall rises from it.</source>
        <translation>{0} ist kein Taschenboden: keine Wand steigt davon auf.</translation>
    </message>
    <message>
        <source>{0} is not there any more: the model has changed.</source>
        <translation>{0} gibt es nicht mehr: das Modell hat sich geändert.</translation>
    </message>
    <message>
        <source>{0} is vertical: it is a wall, not a floor.</source>
        <translation>{0} ist senkrecht: eine Wand, kein Boden.</translation>
    </message>
    <message>
        <source>{0} is {1}; it must be more than 0.</source>
        <translation>{0}: {1}. Der Wert muss größer als 0 sein.</translation>
    </message>
    <message>
        <source>{0} leaves the radius of its corner, {1} mm, at the foot of walls.</source>
        <translation>{0} lässt am Fuß der Wände den Radius seiner Ecke stehen, {1} mm.</translation>
    </message>
    <message>
        <source>{0} looks down.</source>
        <translation>{0} zeigt nach unten.</translation>
    </message>
    <message>
        <source>{0} meet, but do not make one floor.</source>
        <translation>{0} grenzen aneinander, bilden aber keinen gemeinsamen Boden.</translation>
    </message>
    <message>
        <source>{0} mm2 of the floor stay uncut, the largest part at {at}.</source>
        <translation>{0} mm2 des Bodens bleiben stehen, das größte Stück bei {at}.</translation>
    </message>
    <message>
        <source>{0} mm2 of the pocket lie beside the stock, at {at}.</source>
        <translation>{0} mm2 der Tasche liegen neben dem Rohteil, bei {at}.</translation>
    </message>
</context>
<context>
    <name>SpiralPocketPanel</name>
    <message>
        <source>Tool controller</source>
        <translation>Werkzeugsteuerung</translation>
    </message>
    <message>
        <source>The tool and its feeds and speed</source>
        <translation>Das Werkzeug mit Vorschüben und Drehzahl</translation>
    </message>
    <message>
        <source>Coolant</source>
        <translation>Kühlmittel</translation>
    </message>
    <message>
        <source>The coolant of this operation</source>
        <translation>Das Kühlmittel dieser Bearbeitung</translation>
    </message>
    <message>
        <source>Show feeds, speed and tool here, to change them for all operations with this tool controller</source>
        <translation>Vorschübe, Drehzahl und Werkzeug hier zeigen, um sie für alle Bearbeitungen mit dieser Werkzeugsteuerung zu ändern</translation>
    </message>
    <message>
        <source>Edit Tool Controller</source>
        <translation>Werkzeugsteuerung bearbeiten</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>Strategie</translation>
    </message>
    <message>
        <source>Step over percent</source>
        <translation>Seitliche Zustellung (%)</translation>
    </message>
    <message>
        <source>Step over</source>
        <translation>Seitliche Zustellung</translation>
    </message>
    <message>
        <source>Engagement angle</source>
        <translation>Eingriffswinkel</translation>
    </message>
    <message>
        <source>Cut mode</source>
        <translation>Fräsart</translation>
    </message>
    <message>
        <source>XY stock to leave</source>
        <translation>XY-Aufmaß</translation>
    </message>
    <message>
        <source>Z stock to leave</source>
        <translation>Z-Aufmaß</translation>
    </message>
    <message>
        <source>Helix ramp angle</source>
        <translation>Eintauchwinkel der Helix</translation>
    </message>
    <message>
        <source>Helix max diameter</source>
        <translation>Größter Helixdurchmesser</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Feed mode</source>
        <translation>Vorschubart</translation>
    </message>
    <message>
        <source>Slow-down percent</source>
        <translation>Verlangsamter Vorschub (%)</translation>
    </message>
    <message>
        <source>Max feed ratio</source>
        <translation>Größter Vorschubfaktor</translation>
    </message>
    <message>
        <source>Finishing profile</source>
        <translation>Schlichtbahn</translation>
    </message>
    <message>
        <source>Ignore islands</source>
        <translation>Inseln ignorieren</translation>
    </message>
    <message>
        <source>Show options that are rarely needed</source>
        <translation>Selten benötigte Optionen zeigen</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Erweitert</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Link feed</source>
        <translation>Verbindungsvorschub</translation>
    </message>
    <message>
        <source>Slot bite</source>
        <translation>Zustellung in der Nut</translation>
    </message>
    <message>
        <source>Extend open sides</source>
        <translation>Offene Seiten erweitern</translation>
    </message>
    <message>
        <source>Use rest machining</source>
        <translation>Restbearbeitung</translation>
    </message>
    <message>
        <source>Use start point</source>
        <translation>Startpunkt verwenden</translation>
    </message>
    <message>
        <source>Start point X</source>
        <translation>Startpunkt X</translation>
    </message>
    <message>
        <source>Start point Y</source>
        <translation>Startpunkt Y</translation>
    </message>
    <message>
        <source>Take the place that was clicked on the part</source>
        <translation>Die am Werkstück angeklickte Stelle übernehmen</translation>
    </message>
    <message>
        <source>From selection</source>
        <translation>Aus Auswahl</translation>
    </message>
</context>
<context>
    <name>SpiralPocketPreferences</name>
    <message>
        <source>Spiral Pocket</source>
        <translation>Spiraltasche</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Folder with own machines</source>
        <translation>Ordner mit eigenen Maschinen</translation>
    </message>
    <message>
        <source>Machine files (JSON) in this folder are offered besides those of the add-on; after the next start</source>
        <translation>Maschinendateien (JSON) in diesem Ordner werden neben denen der Erweiterung angeboten; ab dem nächsten Start</translation>
    </message>
    <message>
        <source>Defaults of new operations</source>
        <translation>Vorgaben für neue Operationen</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>Strategie</translation>
    </message>
    <message>
        <source>Step over percent</source>
        <translation>Seitliche Zustellung (%)</translation>
    </message>
    <message>
        <source>Cut mode</source>
        <translation>Fräsart</translation>
    </message>
    <message>
        <source>Helix ramp angle</source>
        <translation>Eintauchwinkel der Helix</translation>
    </message>
    <message>
        <source>Feed mode</source>
        <translation>Vorschubart</translation>
    </message>
    <message>
        <source>Slow-down percent</source>
        <translation>Verlangsamter Vorschub (%)</translation>
    </message>
    <message>
        <source>Max feed ratio</source>
        <translation>Größter Vorschubfaktor</translation>
    </message>
    <message>
        <source>Link feed</source>
        <translation>Verbindungsvorschub</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
</context>
<context>
    <name>SpiralPocket_Create</name>
    <message>
        <source>Spiral Pocket</source>
        <translation>Spiraltasche</translation>
    </message>
    <message>
        <source>Clears the pockets above the selected floors with one smooth spiral each</source>
        <translation>Räumt die Taschen über den gewählten Böden mit je einer glatten Spirale</translation>
    </message>
</context>
</TS>
