<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- SPDX-License-Identifier: LGPL-2.1-or-later -->
<TS version="2.1" language="es_ES" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>How the laps of the spiral are made</source>
        <translation>Cómo se hacen las vueltas de la espiral</translation>
    </message>
    <message>
        <source>Percent of cutter diameter to step over on each lap, at most</source>
        <translation>Paso lateral por vuelta, en porcentaje del diámetro de la fresa, como máximo</translation>
    </message>
    <message>
        <source>Largest engagement angle of a straight cut, in place of StepOver; 0 for that of StepOver</source>
        <translation>Ángulo de contacto máximo en corte recto, en lugar de StepOver; 0 para el de StepOver</translation>
    </message>
    <message>
        <source>Climb or conventional milling, for a spindle that turns clockwise</source>
        <translation>Concordancia u oposición, con husillo a derechas</translation>
    </message>
    <message>
        <source>How much stock to leave in the XY plane (eg for finishing operation)</source>
        <translation>Material que queda en el plano XY (p. ej. para el acabado)</translation>
    </message>
    <message>
        <source>How much stock to leave along the Z axis</source>
        <translation>Material que queda en el eje Z</translation>
    </message>
    <message>
        <source>Ramp angle of the helical entry</source>
        <translation>Ángulo de rampa de la entrada en hélice</translation>
    </message>
    <message>
        <source>Limit helix entry diameter, if limit larger than tool diameter or 0, tool diameter is used</source>
        <translation>Límite del diámetro de la hélice; si supera el de la herramienta o es 0, vale el diámetro de la herramienta</translation>
    </message>
    <message>
        <source>Largest deviation of the path from the exact curve</source>
        <translation>Mayor desviación de la trayectoria respecto a la curva exacta</translation>
    </message>
    <message>
        <source>The machine on which the time is to be least</source>
        <translation>La máquina en la que el tiempo debe ser mínimo</translation>
    </message>
    <message>
        <source>How the feed follows the engagement: slowed where it passes the limit, slowed linearly with the chip, or raised where the chip is thin</source>
        <translation>Cómo sigue el avance al contacto: más lento donde pasa el límite, linealmente con la viruta, o más rápido donde la viruta es fina</translation>
    </message>
    <message>
        <source>Feed at the largest radial depth of cut, in percent (Linear slow-down)</source>
        <translation>Avance con la mayor profundidad radial, en porcentaje (Reducción lineal)</translation>
    </message>
    <message>
        <source>Largest feed where the chip is thin, as a multiple of the tool controller's (Chip thickness)</source>
        <translation>Mayor avance con viruta fina, como múltiplo del programado (Espesor de viruta)</translation>
    </message>
    <message>
        <source>Feed of moves at depth through cleared ground in mm/min, 0 for the horizontal rapid rate</source>
        <translation>Avance de los movimientos en profundidad por zona vaciada en mm/min, 0 para el rápido horizontal</translation>
    </message>
    <message>
        <source>Largest axial depth of one level of a slot that opens the pocket, 0 for automatic</source>
        <translation>Mayor pasada axial de una ranura que abre la cajera, 0 para automático</translation>
    </message>
    <message>
        <source>To take a finishing lap along the walls at the end; Automatic and Extended Archimedean do without, their laps finish the walls</source>
        <translation>Terminar con una pasada de acabado por las paredes; Automático y Arquimediana extendida no la necesitan, sus vueltas acaban las paredes</translation>
    </message>
    <message>
        <source>Ignore islands and clear everything inside the outline</source>
        <translation>Ignorar las islas y vaciar todo dentro del contorno</translation>
    </message>
    <message>
        <source>Clear the floor beyond its edge where no wall rises, and begin there in the air where the stock ends near by; else the cutter stays within the floor</source>
        <translation>Vaciar el fondo más allá de su borde donde no se alza ninguna pared, y empezar allí en el aire si el material acaba cerca; si no, la fresa queda dentro del fondo</translation>
    </message>
    <message>
        <source>Cut only what earlier operations of the job have left standing in the pocket</source>
        <translation>Mecanizar solo lo que operaciones anteriores del trabajo dejaron en la cajera</translation>
    </message>
    <message>
        <source>Make True, if specifying a Start Point</source>
        <translation>Poner en Verdadero si se indica un punto de inicio</translation>
    </message>
    <message>
        <source>Where the cutter goes down, as near as it can; its height does not matter</source>
        <translation>Dónde baja la fresa, lo más cerca posible; la altura no importa</translation>
    </message>
    <message>
        <source>The exact curves behind the path, B-splines at the floors; can be exported to STEP</source>
        <translation>Las curvas exactas de la trayectoria, B-splines en los fondos; exportables a STEP</translation>
    </message>
    <message>
        <source>Largest engagement angle that was measured, at the floor after the entry</source>
        <translation>Mayor ángulo de contacto medido, en el fondo después de la entrada</translation>
    </message>
    <message>
        <source>Area within the cutter's reach left standing, in mm^2</source>
        <translation>Área al alcance de la fresa que quedó sin cortar, en mm^2</translation>
    </message>
    <message>
        <source>How far the cutter passes the walls, measured</source>
        <translation>Cuánto pasa la fresa de las paredes, medido</translation>
    </message>
    <message>
        <source>Length of all cutting moves</source>
        <translation>Longitud de todos los movimientos de corte</translation>
    </message>
    <message>
        <source>Time of the path on the chosen machine, in seconds</source>
        <translation>Tiempo de la trayectoria en la máquina elegida, en segundos</translation>
    </message>
    <message>
        <source>What the machinist should know about this path</source>
        <translation>Lo que conviene saber de esta trayectoria</translation>
    </message>
    <message>
        <source>Version of these properties</source>
        <translation>Versión de estas propiedades</translation>
    </message>
</context>
<context>
    <name>SpiralPocket</name>
    <message>
        <source>{} was saved by a FreeCAD without Spiral Pocket; its path may be older than the part. Recompute the document.</source>
        <translation>{} se guardó con un FreeCAD sin Spiral Pocket; su trayectoria puede ser anterior a la pieza. Recalcule el documento.</translation>
    </message>
    <message>
        <source>Compare...</source>
        <translation>Comparar...</translation>
    </message>
    <message>
        <source>All strategies side by side</source>
        <translation>Todas las estrategias lado a lado</translation>
    </message>
    <message>
        <source>Use this</source>
        <translation>Usar esta</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Cutting length</source>
        <translation>Longitud de corte</translation>
    </message>
    <message>
        <source>Largest engagement</source>
        <translation>Contacto máximo</translation>
    </message>
    <message>
        <source>99 % of it below</source>
        <translation>El 99 % por debajo de</translation>
    </message>
    <message>
        <source>Mean engagement</source>
        <translation>Contacto medio</translation>
    </message>
    <message>
        <source>Left uncut in reach</source>
        <translation>Sin cortar al alcance</translation>
    </message>
    <message>
        <source>the fastest that keeps the limit of engagement on 99 % of the way and leaves nothing uncut</source>
        <translation>la más rápida que respeta el límite de contacto en el 99 % del recorrido y no deja nada sin cortar</translation>
    </message>
    <message>
        <source>An error, see the Report view.</source>
        <translation>Un error; vea la vista de informe.</translation>
    </message>
    <message>
        <source>Planning... {:.0f} %</source>
        <translation>Planificando... {:.0f} %</translation>
    </message>
    <message>
        <source>No path</source>
        <translation>Sin trayectoria</translation>
    </message>
    <message>
        <source>FreeCAD's Adaptive</source>
        <translation>Adaptive de FreeCAD</translation>
    </message>
    <message>
        <source>Compare strategies</source>
        <translation>Comparar estrategias</translation>
    </message>
    <message>
        <source>Pocket {} ({}), {}</source>
        <translation>Cajera {} ({}), {}</translation>
    </message>
    <message>
        <source>No pocket: the first line of the panel says why.</source>
        <translation>No hay cajera: la primera línea del panel dice por qué.</translation>
    </message>
    <message>
        <source>With the same cutter, step-over and feeds on {}. Limit of engagement {:.0f}°; what clearly passes it, or stays uncut, is red. ★ the fastest that keeps it on 99 % of the way and leaves nothing uncut.</source>
        <translation>Con la misma fresa, el mismo paso y los mismos avances en {}. Límite de contacto {:.0f}°; lo que lo supera claramente, o queda sin cortar, está en rojo. ★ la más rápida que lo respeta en el 99 % del recorrido y no deja nada sin cortar.</translation>
    </message>
    <message>
        <source>Create Spiral Pocket</source>
        <translation>Crear cajera en espiral</translation>
    </message>
    <message>
        <source>Type {} to {}.</source>
        <translation>Escriba de {} a {}.</translation>
    </message>
    <message>
        <source>Type more than {} and less than {}.</source>
        <translation>Escriba más de {} y menos de {}.</translation>
    </message>
    <message>
        <source>Type a number.</source>
        <translation>Escriba un número.</translation>
    </message>
    <message>
        <source>Type a number; where no unit is typed, it is "{}".</source>
        <translation>Escriba un número; si no se indica otra, la unidad es «{}».</translation>
    </message>
    <message>
        <source>Type {} or more.</source>
        <translation>Escriba {} o más.</translation>
    </message>
    <message>
        <source>Type more than 0, at most {}.</source>
        <translation>Escriba más de 0, como máximo {}.</translation>
    </message>
    <message>
        <source>Feed of moves at depth through cleared ground, 0 for the horizontal rapid rate</source>
        <translation>Avance de los movimientos en profundidad por zona vaciada, 0 para el rápido horizontal</translation>
    </message>
    <message>
        <source>Set by the expression {}</source>
        <translation>Fijado por la expresión {}</translation>
    </message>
    <message>
        <source>The same step-over as a length, for this cutter</source>
        <translation>El mismo paso lateral como longitud, para esta fresa</translation>
    </message>
    <message>
        <source>The engagement angle of a straight cut at this step-over: 90° at half the cutter's diameter, 180° in a full slot</source>
        <translation>El ángulo de contacto en corte recto con este paso: 90° a medio diámetro de fresa, 180° en ranura completa</translation>
    </message>
    <message>
        <source>{}: "{}" is not taken, {} stays.</source>
        <translation>{}: «{}» no se acepta, queda {}.</translation>
    </message>
    <message>
        <source>OK once more keeps what was made without that.</source>
        <translation>Otra vez Aceptar conserva lo que se hizo sin eso.</translation>
    </message>
    <message>
        <source>The remarks in the result box say why.</source>
        <translation>Los avisos en «Resultado» dicen por qué.</translation>
    </message>
    <message>
        <source>OK once more keeps this path.</source>
        <translation>Otra vez Aceptar conserva esta trayectoria.</translation>
    </message>
    <message>
        <source>An error in the add-on: the path was not computed.</source>
        <translation>Un error en el complemento: la trayectoria no se calculó.</translation>
    </message>
    <message>
        <source>Please report it with the text in the Report view.</source>
        <translation>Infórmelo con el texto de la vista de informe.</translation>
    </message>
    <message>
        <source>Remove Spiral Pocket</source>
        <translation>Quitar cajera en espiral</translation>
    </message>
    <message>
        <source>{} of the floor stay uncut.</source>
        <translation>{} del fondo quedan sin cortar.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Spiral Pocket</source>
        <translation>Cajera en espiral</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Gráficos</translation>
    </message>
    <message>
        <source>Engagement, feed, velocity and force along the time</source>
        <translation>Contacto, avance, velocidad y fuerza a lo largo del tiempo</translation>
    </message>
    <message>
        <source>Aluminum 6082-T6</source>
        <translation>aluminio 6082-T6</translation>
    </message>
    <message>
        <source>Spiral Pocket plots</source>
        <translation>Gráficos de la cajera en espiral</translation>
    </message>
    <message>
        <source>Mean cutting force in {} [N]</source>
        <translation>Fuerza de corte media en {} [N]</translation>
    </message>
    <message>
        <source>No path: the first line of the panel says why.</source>
        <translation>No hay trayectoria: la primera línea del panel dice por qué.</translation>
    </message>
    <message>
        <source>Engagement [°]</source>
        <translation>Contacto [°]</translation>
    </message>
    <message>
        <source>Time [s]</source>
        <translation>Tiempo [s]</translation>
    </message>
    <message>
        <source>No force: no spindle speed in the tool controller</source>
        <translation>Sin fuerza: el controlador de herramienta no tiene velocidad de husillo</translation>
    </message>
    <message>
        <source>Plots need the Python library matplotlib.</source>
        <translation>Los gráficos necesitan la biblioteca Python matplotlib.</translation>
    </message>
    <message>
        <source>Install it with the Addon Manager or pip.</source>
        <translation>Instálela con el gestor de complementos o pip.</translation>
    </message>
    <message>
        <source>Programmed feed [{}]</source>
        <translation>Avance programado [{}]</translation>
    </message>
    <message>
        <source>The machine's velocity [{}]</source>
        <translation>Velocidad de la máquina [{}]</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vista previa</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>En vivo</translation>
    </message>
    <message>
        <source>Draw the path anew while values change</source>
        <translation>Redibujar la trayectoria con cada cambio</translation>
    </message>
    <message>
        <source>What the colors of the cut show</source>
        <translation>Qué muestran los colores del corte</translation>
    </message>
    <message>
        <source>Play the cut</source>
        <translation>Reproducir el corte</translation>
    </message>
    <message>
        <source>How far the cut is shown</source>
        <translation>Hasta dónde se muestra el corte</translation>
    </message>
    <message>
        <source>Feed [{}]</source>
        <translation>Avance [{}]</translation>
    </message>
    <message>
        <source>The mark is the limit at the step-over: {:.0f}°</source>
        <translation>La marca es el límite con este paso: {:.0f}°</translation>
    </message>
    <message>
        <source>entry</source>
        <translation>entrada</translation>
    </message>
    <message>
        <source>link</source>
        <translation>enlace</translation>
    </message>
    <message>
        <source>rapid</source>
        <translation>rápido</translation>
    </message>
    <message>
        <source>cleared</source>
        <translation>vaciado</translation>
    </message>
    <message>
        <source>left over</source>
        <translation>restante</translation>
    </message>
    <message>
        <source>island</source>
        <translation>isla</translation>
    </message>
    <message>
        <source>Switched off.</source>
        <translation>Desactivado.</translation>
    </message>
    <message>
        <source>This is the proved path.</source>
        <translation>Esta es la trayectoria comprobada.</translation>
    </message>
    <message>
        <source>Draft. Stopped; Apply or the next change goes on.</source>
        <translation>Borrador. Detenido; Aplicar o el próximo cambio continúa.</translation>
    </message>
    <message>
        <source>Draft. The path is being proved: {:.0f} %</source>
        <translation>Borrador. Comprobando la trayectoria: {:.0f} %</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>The operation has this path.</source>
        <translation>La operación tiene esta trayectoria.</translation>
    </message>
    <message>
        <source>OK or Apply makes this path.</source>
        <translation>Aceptar o Aplicar crea esta trayectoria.</translation>
    </message>
    <message>
        <source>Stopped: no new path. OK or Apply plans it again.</source>
        <translation>Detenido: no hay trayectoria nueva. Aceptar o Aplicar la planifica de nuevo.</translation>
    </message>
    <message>
        <source>Live is off: OK or Apply plans the path.</source>
        <translation>«En vivo» está desactivado: Aceptar o Aplicar planifica la trayectoria.</translation>
    </message>
    <message>
        <source>There is no path.</source>
        <translation>No hay trayectoria.</translation>
    </message>
    <message>
        <source>Planning: {:.0f} %</source>
        <translation>Planificando: {:.0f} %</translation>
    </message>
    <message>
        <source>Click to see the place</source>
        <translation>Pulse para ver el lugar</translation>
    </message>
    <message>
        <source>FreeCAD's estimate</source>
        <translation>Estimación de FreeCAD</translation>
    </message>
    <message>
        <source>Entry at full width, deep</source>
        <translation>Entrada a todo el ancho, profundidad</translation>
    </message>
    <message>
        <source>Gouge</source>
        <translation>Sobrecorte</translation>
    </message>
    <message>
        <source>{:.0f}°, limit {:.0f}°</source>
        <translation>{:.0f}°, límite {:.0f}°</translation>
    </message>
    <message>
        <source>whole width, {} deep</source>
        <translation>todo el ancho, {} de profundidad</translation>
    </message>
    <message>
        <source>Time on {}</source>
        <translation>Tiempo en {}</translation>
    </message>
    <message>
        <source>{} (allowed: {})</source>
        <translation>{} (admitido: {})</translation>
    </message>
    <message>
        <source>pockets not cut: {}</source>
        <translation>cajeras sin mecanizar: {}</translation>
    </message>
    <message>
        <source>remarks: {}</source>
        <translation>avisos: {}</translation>
    </message>
    <message>
        <source>{} uncut</source>
        <translation>{} sin cortar</translation>
    </message>
    <message>
        <source>Any pocket, with islands and necks: holds the engagement, least time on the machine</source>
        <translation>Cualquier cajera, con islas y estrechos: mantiene el contacto, tiempo mínimo en la máquina</translation>
    </message>
    <message>
        <source>One exact B-spline from the middle to the wall, for pockets without islands</source>
        <translation>Una B-spline exacta del centro a la pared, para cajeras sin islas</translation>
    </message>
    <message>
        <source>Even laps about the pocket's middle line, for long and branched pockets</source>
        <translation>Vueltas uniformes en torno a la línea media, para cajeras largas y ramificadas</translation>
    </message>
    <message>
        <source>Laps like lines of equal temperature, smooth everywhere, for compact pockets</source>
        <translation>Vueltas como líneas de igual temperatura, suaves en todo punto, para cajeras compactas</translation>
    </message>
    <message>
        <source>A round spiral that turns into the wall's shape, for compact pockets</source>
        <translation>Una espiral redonda que toma la forma de la pared, para cajeras compactas</translation>
    </message>
    <message>
        <source>Start point</source>
        <translation>Punto de inicio</translation>
    </message>
    <message>
        <source>"{}"</source>
        <translation>«{}»</translation>
    </message>
    <message>
        <source>Switched off: no path until Active is set again.</source>
        <translation>Desactivada: sin trayectoria hasta volver a activar Active.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>Add one with an end mill to the job, then try again.</source>
        <translation>Añada uno con una fresa plana al trabajo e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>{} has no tool controller that can clear a pocket.</source>
        <translation>{} no tiene ningún controlador de herramienta que pueda vaciar una cajera.</translation>
    </message>
    <message>
        <source>Use as Default in This Job</source>
        <translation>Usar por defecto en este trabajo</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automático</translation>
    </message>
    <message>
        <source>Linear Morph</source>
        <translation>Transición lineal</translation>
    </message>
    <message>
        <source>Extended Archimedean</source>
        <translation>Arquimediana extendida</translation>
    </message>
    <message>
        <source>Isotherm</source>
        <translation>Isotermas</translation>
    </message>
    <message>
        <source>Central Spiral</source>
        <translation>Espiral central</translation>
    </message>
    <message>
        <source>Climb</source>
        <translation>Concordancia</translation>
    </message>
    <message>
        <source>Conventional</source>
        <translation>Oposición</translation>
    </message>
    <message>
        <source>Constant</source>
        <translation>Constante</translation>
    </message>
    <message>
        <source>Linear slow-down</source>
        <translation>Reducción lineal</translation>
    </message>
    <message>
        <source>Chip thickness</source>
        <translation>Espesor de viruta</translation>
    </message>
    <message>
        <source>Benchtop mill</source>
        <translation>Fresadora de banco</translation>
    </message>
    <message>
        <source>Hobby router</source>
        <translation>Router de aficionado</translation>
    </message>
    <message>
        <source>Huron with Siemens 840D</source>
        <translation>Huron con Siemens 840D</translation>
    </message>
    <message>
        <source>Mikron UCP710</source>
        <translation>Mikron UCP710</translation>
    </message>
    <message>
        <source>Vertical machining center</source>
        <translation>Centro de mecanizado vertical</translation>
    </message>
</context>
<context>
    <name>SpiralPocketMessages</name>
    <message>
        <source>the pocket</source>
        <translation>la cajera</translation>
    </message>
    <message>
        <source>feeds</source>
        <translation>avances</translation>
    </message>
    <message>
        <source>horizontal feed</source>
        <translation>avance horizontal</translation>
    </message>
    <message>
        <source>vertical feed</source>
        <translation>avance vertical</translation>
    </message>
    <message>
        <source>rapid</source>
        <translation>rápido</translation>
    </message>
    <message>
        <source>link</source>
        <translation>enlace</translation>
    </message>
    <message>
        <source>the path asked for failed its proof</source>
        <translation>la trayectoria pedida no superó la comprobación</translation>
    </message>
    <message>
        <source>the path asked for would leave {0} mm2 standing</source>
        <translation>la trayectoria pedida dejaría {0} mm2 en pie</translation>
    </message>
    <message>
        <source>The cutter's diameter</source>
        <translation>Diámetro de la fresa</translation>
    </message>
    <message>
        <source>The horizontal feed</source>
        <translation>Avance horizontal</translation>
    </message>
    <message>
        <source>The vertical feed</source>
        <translation>Avance vertical</translation>
    </message>
    <message>
        <source>The horizontal rapid rate</source>
        <translation>Rápido horizontal</translation>
    </message>
    <message>
        <source>The vertical rapid rate</source>
        <translation>Rápido vertical</translation>
    </message>
    <message>
        <source>The tolerance</source>
        <translation>Tolerancia</translation>
    </message>
    <message>
        <source>XY stock to leave</source>
        <translation>Sobrematerial XY</translation>
    </message>
    <message>
        <source>Z stock to leave</source>
        <translation>Sobrematerial Z</translation>
    </message>
    <message>
        <source>with {0} mm of stock to leave</source>
        <translation>con {0} mm de sobrematerial</translation>
    </message>
    <message>
        <source>Pocket {0} of {1}: {2}</source>
        <translation>Cajera {0} de {1}: {2}</translation>
    </message>
    <message>
        <source>0.01 mm is usual.</source>
        <translation>Lo usual es 0,01 mm.</translation>
    </message>
    <message>
        <source>A cutter below {0} mm reaches all of them.</source>
        <translation>Una fresa de menos de {0} mm llega a todas.</translation>
    </message>
    <message>
        <source>A cutter below {0} mm reaches it.</source>
        <translation>Una fresa de menos de {0} mm llega.</translation>
    </message>
    <message>
        <source>A cutter below {0} mm reaches {1} of them.</source>
        <translation>Una fresa de menos de {0} mm llega a {1} de ellas.</translation>
    </message>
    <message>
        <source>A depth or height is {0}; it must be a number of millimeters.</source>
        <translation>Una profundidad o altura es {0}; debe ser un número de milímetros.</translation>
    </message>
    <message>
        <source>A helix angle of {0} degrees cannot be cut.</source>
        <translation>Un ángulo de hélice de {0} grados no se puede cortar.</translation>
    </message>
    <message>
        <source>A largest engagement of {0} degrees cannot be cut.</source>
        <translation>Un contacto máximo de {0} grados no se puede cortar.</translation>
    </message>
    <message>
        <source>A smaller StepDown makes them smaller; a finishing operation removes them.</source>
        <translation>Un valor menor de StepDown los reduce; una operación de acabado los quita.</translation>
    </message>
    <message>
        <source>A smaller step-over may clear it.</source>
        <translation>Un paso lateral menor puede vaciarlo.</translation>
    </message>
    <message>
        <source>A step down of {0} mm makes more than {1} levels.</source>
        <translation>Una bajada de {0} mm da más de {1} niveles.</translation>
    </message>
    <message>
        <source>A step down of {0} mm never reaches the floor.</source>
        <translation>Con una pasada de {0} mm nunca se llega al fondo.</translation>
    </message>
    <message>
        <source>A step-over of {0} mm is wider than the {1} mm cutter.</source>
        <translation>Un paso lateral de {0} mm es mayor que la fresa de {1} mm.</translation>
    </message>
    <message>
        <source>A step-over of {0} mm never clears the pocket.</source>
        <translation>Con un paso lateral de {0} mm nunca se vacía la cajera.</translation>
    </message>
    <message>
        <source>A tolerance of {0} mm is too coarse for this cutter.</source>
        <translation>Una tolerancia de {0} mm es demasiado basta para esta fresa.</translation>
    </message>
    <message>
        <source>A {0} move runs through standing stock at {at}, {1} mm in all.</source>
        <translation>Un movimiento ({0}) atraviesa material en {at}, {1} mm en total.</translation>
    </message>
    <message>
        <source>Above Z{0} also {1} mm2 beside the selected floor are cleared, down to ledges.</source>
        <translation>Por encima de Z{0} también se vacían {1} mm2 junto al fondo seleccionado, hasta los escalones.</translation>
    </message>
    <message>
        <source>Above the floor the pocket has notches that the {0} mm cutter does not fit, the largest at {at}; these ({1} mm2) stay uncut.</source>
        <translation>Sobre el fondo, la cajera tiene muescas en las que no cabe la fresa de {0} mm, la mayor en {at}; estas ({1} mm2) quedan sin cortar.</translation>
    </message>
    <message>
        <source>Add it; vmc.json shows how.</source>
        <translation>Añádalo; vmc.json muestra cómo.</translation>
    </message>
    <message>
        <source>Add the part to the job's model.</source>
        <translation>Añada la pieza al modelo del trabajo.</translation>
    </message>
    <message>
        <source>Another part of the job covers the whole floor; no cutter gets there from above.</source>
        <translation>Otra pieza del trabajo cubre todo el fondo; ninguna fresa llega desde arriba.</translation>
    </message>
    <message>
        <source>Another part of the job covers {0} mm2 of the floor; that stays uncut.</source>
        <translation>Otra pieza del trabajo cubre {0} mm2 del fondo; eso queda sin cortar.</translation>
    </message>
    <message>
        <source>Another part of the job stands in the pocket or over it; the cutter keeps off that.</source>
        <translation>Otra pieza del trabajo está en la cajera o sobre ella; la fresa la evita.</translation>
    </message>
    <message>
        <source>At Z{0} the pocket reaches under a wall.</source>
        <translation>En Z{0} la cajera queda bajo una pared.</translation>
    </message>
    <message>
        <source>At a helix angle of {0} degrees the cutter goes round more than {1} times on its way down.</source>
        <translation>Con un ángulo de hélice de {0} grados la fresa da más de {1} vueltas al bajar.</translation>
    </message>
    <message>
        <source>At {at} the cutter cuts {0} mm into the wall.</source>
        <translation>En {at} la fresa corta {0} mm en la pared.</translation>
    </message>
    <message>
        <source>At {at} the engagement reaches {0} degrees, the step-over of {1} % allows {2}; {3} % of the cut clearly pass that.</source>
        <translation>En {at} el contacto llega a {0} grados, el paso lateral de {1} % permite {2}; un {3} % del corte lo supera claramente.</translation>
    </message>
    <message>
        <source>Below Z{0} that part stays uncut.</source>
        <translation>Por debajo de Z{0} esa parte queda sin cortar.</translation>
    </message>
    <message>
        <source>Below Z{0} the pocket is too narrow and stays uncut.</source>
        <translation>Por debajo de Z{0} la cajera es demasiado estrecha y queda sin cortar.</translation>
    </message>
    <message>
        <source>Central Spiral cannot go round islands; there is one at {at}.</source>
        <translation>Espiral central no puede rodear islas; hay una en {at}.</translation>
    </message>
    <message>
        <source>Central Spiral needs a pocket whose whole wall can be seen from one place in its middle; the one at {at} has walls behind corners.</source>
        <translation>Espiral central necesita una cajera cuya pared se vea entera desde un punto central; la de {at} tiene paredes tras esquinas.</translation>
    </message>
    <message>
        <source>Check the geometry of the part and the job's stock.</source>
        <translation>Compruebe la geometría de la pieza y del material en bruto del trabajo.</translation>
    </message>
    <message>
        <source>Check the outline for tiny steps, or choose a smaller cutter.</source>
        <translation>Busque escalones diminutos en el contorno o elija una fresa menor.</translation>
    </message>
    <message>
        <source>Check the part's geometry in the Part workbench and repair the face.</source>
        <translation>Revise la geometría en el banco Part y repare la cara.</translation>
    </message>
    <message>
        <source>Check the part's geometry in the Part workbench.</source>
        <translation>Revise la geometría en el banco Part.</translation>
    </message>
    <message>
        <source>Checking the pocket</source>
        <translation>Revisando la cajera</translation>
    </message>
    <message>
        <source>Choose a tool controller with an end mill in it.</source>
        <translation>Elija un controlador con una fresa plana.</translation>
    </message>
    <message>
        <source>Choose another strategy, for example Automatic.</source>
        <translation>Elija otra estrategia, por ejemplo Automático.</translation>
    </message>
    <message>
        <source>Choose one of: {0}.</source>
        <translation>Elija una de: {0}.</translation>
    </message>
    <message>
        <source>Choose one with an end mill in it.</source>
        <translation>Elija uno con una fresa plana.</translation>
    </message>
    <message>
        <source>Choose that strategy, or another step-over.</source>
        <translation>Elija esa estrategia, u otro paso lateral.</translation>
    </message>
    <message>
        <source>Choose the strategy Automatic or Isotherm for this pocket.</source>
        <translation>Elija la estrategia Automático o Isotermas para esta cajera.</translation>
    </message>
    <message>
        <source>Choose your machine in Machine, or lower the feed in the tool controller.</source>
        <translation>Elija su máquina en Machine, o baje el avance en el controlador de herramienta.</translation>
    </message>
    <message>
        <source>Close it first (Part workbench, Check Geometry and Convert to Solid).</source>
        <translation>Ciérrela primero (banco Part, Comprobar geometría y Convertir en sólido).</translation>
    </message>
    <message>
        <source>Compare it with vmc.json.</source>
        <translation>Compárelo con vmc.json.</translation>
    </message>
    <message>
        <source>Cut them by a smaller cutter.</source>
        <translation>Córtelas con una fresa más pequeña.</translation>
    </message>
    <message>
        <source>Do not run this path; check the final depth and the floor stock.</source>
        <translation>No ejecute esta trayectoria; revise la profundidad final y el sobrematerial del fondo.</translation>
    </message>
    <message>
        <source>Do not run this path; try another strategy or step-over.</source>
        <translation>No ejecute esta trayectoria; pruebe otra estrategia u otro paso lateral.</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Listo</translation>
    </message>
    <message>
        <source>Drag it into the job's operations.</source>
        <translation>Arrástrela a las operaciones del trabajo.</translation>
    </message>
    <message>
        <source>Earlier operations have cleared more than 99 % of this pocket; what this cutter reaches of the rest is cut.</source>
        <translation>Operaciones anteriores han vaciado más del 99 % de esta cajera; del resto se corta lo que esta fresa alcanza.</translation>
    </message>
    <message>
        <source>Earlier operations have cleared this pocket as far as this cutter reaches.</source>
        <translation>Operaciones anteriores han vaciado esta cajera hasta donde llega esta fresa.</translation>
    </message>
    <message>
        <source>Earlier operations have cleared {0} % of this pocket; what this cutter reaches of the rest is cut.</source>
        <translation>Operaciones anteriores han vaciado el {0} % de esta cajera; del resto se corta lo que esta fresa alcanza.</translation>
    </message>
    <message>
        <source>Finish with a flat end mill where that must be sharp.</source>
        <translation>Acabe con una fresa plana donde deba quedar vivo.</translation>
    </message>
    <message>
        <source>FreeCAD's Adaptive cannot be reached from here.</source>
        <translation>No se puede acceder desde aquí al Adaptive de FreeCAD.</translation>
    </message>
    <message>
        <source>FreeCAD's Adaptive finds no path in this pocket.</source>
        <translation>El Adaptive de FreeCAD no encuentra trayectoria en esta cajera.</translation>
    </message>
    <message>
        <source>FreeCAD's Adaptive has found no path in this pocket within {0} s.</source>
        <translation>El Adaptive de FreeCAD no ha encontrado trayectoria en esta cajera en {0} s.</translation>
    </message>
    <message>
        <source>Give it the number of an end mill, 1 or higher.</source>
        <translation>Dele el número de una fresa, 1 o mayor.</translation>
    </message>
    <message>
        <source>Install it with FreeCAD's Addon Manager (it is a dependency of Spiral Pocket) or with pip into the Python that FreeCAD uses, then start FreeCAD again.</source>
        <translation>Instálela con el gestor de complementos de FreeCAD (es una dependencia de Spiral Pocket) o con pip en el Python de FreeCAD y reinicie FreeCAD.</translation>
    </message>
    <message>
        <source>Islands on {0} mm2 of the floor are milled away.</source>
        <translation>Se eliminan al fresar las islas que ocupan {0} mm2 del fondo.</translation>
    </message>
    <message>
        <source>Isotherm would need more than {0} laps.</source>
        <translation>Isotermas necesitaría más de {0} vueltas.</translation>
    </message>
    <message>
        <source>It comes with matplotlib 3.6 or later: install that with FreeCAD's Addon Manager, or choose another strategy.</source>
        <translation>Viene con matplotlib 3.6 o posterior: instálelo con el gestor de complementos de FreeCAD, o elija otra estrategia.</translation>
    </message>
    <message>
        <source>Its faces are Face1 to Face{0}.</source>
        <translation>Sus caras son de Face1 a Face{0}.</translation>
    </message>
    <message>
        <source>Keep clamps away from that side, or unset ExtendOpenSides.</source>
        <translation>Mantenga las bridas lejos de ese lado, o desactive ExtendOpenSides.</translation>
    </message>
    <message>
        <source>Laps of Linear Morph would cross themselves at {at}, where the wall turns away from the middle of the pocket.</source>
        <translation>Las vueltas de Transición lineal se cruzarían en {at}, donde la pared se aparta del centro de la cajera.</translation>
    </message>
    <message>
        <source>Laying the spiral</source>
        <translation>Trazando la espiral</translation>
    </message>
    <message>
        <source>Levels are {0} mm deep, the tool's cutting edge is {1} mm long.</source>
        <translation>Los niveles tienen {0} mm de profundidad, el filo de la herramienta {1} mm de largo.</translation>
    </message>
    <message>
        <source>Linear Morph cannot go round islands; there is one at {at}.</source>
        <translation>Transición lineal no puede rodear islas; hay una en {at}.</translation>
    </message>
    <message>
        <source>Linear Morph finds no middle to start from.</source>
        <translation>Transición lineal no encuentra un centro donde empezar.</translation>
    </message>
    <message>
        <source>Look what lies under the hole. If it goes on there, select a wall of that.</source>
        <translation>Mire qué hay debajo del hueco. Si continúa allí, seleccione una pared de esa parte.</translation>
    </message>
    <message>
        <source>Look what lies under the stock, or raise FinalDepth.</source>
        <translation>Mire qué hay debajo del material, o suba FinalDepth.</translation>
    </message>
    <message>
        <source>Look whether the stock is where it should be.</source>
        <translation>Mire si el material está donde debe.</translation>
    </message>
    <message>
        <source>Lower FinishDepth or raise StepDown.</source>
        <translation>Reduzca FinishDepth o aumente StepDown.</translation>
    </message>
    <message>
        <source>Lower StepDown, or take a longer tool.</source>
        <translation>Baje StepDown o tome una herramienta más larga.</translation>
    </message>
    <message>
        <source>Lower StockToLeave.</source>
        <translation>Reduzca StockToLeave.</translation>
    </message>
    <message>
        <source>Lower Tolerance if the wall must be truer.</source>
        <translation>Reduzca Tolerance si la pared debe ser más exacta.</translation>
    </message>
    <message>
        <source>Lower ZStockToLeave.</source>
        <translation>Reduzca ZStockToLeave.</translation>
    </message>
    <message>
        <source>Machine that part from another side, or with an undercutting tool.</source>
        <translation>Mecanice esa parte desde otro lado o con una herramienta de contrasalida.</translation>
    </message>
    <message>
        <source>Mend or remove it.</source>
        <translation>Corríjala o quítela.</translation>
    </message>
    <message>
        <source>More than {0} laps are left beside the spirals.</source>
        <translation>Quedan más de {0} vueltas junto a las espirales.</translation>
    </message>
    <message>
        <source>Move this operation behind the one with the larger end mill, or unset UseRestMachining. Only flat end mills count: round ones leave ridges.</source>
        <translation>Mueva esta operación detrás de la de la fresa mayor, o desactive UseRestMachining. Solo cuentan las fresas planas: las redondas dejan crestas.</translation>
    </message>
    <message>
        <source>Much the same is told of {0} more pockets (at {1}).</source>
        <translation>Casi lo mismo vale para otras {0} cajeras (en {1}).</translation>
    </message>
    <message>
        <source>Much the same is told of {0} more pockets.</source>
        <translation>Casi lo mismo vale para otras {0} cajeras.</translation>
    </message>
    <message>
        <source>No cutter goes through so narrow a gap; check the model.</source>
        <translation>Ninguna fresa pasa por un hueco tan estrecho; revise el modelo.</translation>
    </message>
    <message>
        <source>No earlier operation has cleared any of this pocket down to its floor; all is cut.</source>
        <translation>Ninguna operación anterior ha vaciado nada de esta cajera hasta el fondo; se corta todo.</translation>
    </message>
    <message>
        <source>No face is selected.</source>
        <translation>No hay ninguna cara seleccionada.</translation>
    </message>
    <message>
        <source>No isotherm leads to the slot.</source>
        <translation>Ninguna isoterma lleva a la ranura.</translation>
    </message>
    <message>
        <source>Nothing is cut below Z{0}.</source>
        <translation>Por debajo de Z{0} no se corta nada.</translation>
    </message>
    <message>
        <source>Of the step-over of {0} % Automatic uses {1}: wider laps would leave stock where they meet.</source>
        <translation>Del paso lateral de {0} %, Automático usa {1}: vueltas más anchas dejarían material donde se encuentran.</translation>
    </message>
    <message>
        <source>Open the document in that version, or make a new job here.</source>
        <translation>Abra el documento en esa versión o cree aquí un trabajo nuevo.</translation>
    </message>
    <message>
        <source>Other strategies use it whole, and may leave stock.</source>
        <translation>Otras estrategias lo usan entero y pueden dejar material.</translation>
    </message>
    <message>
        <source>Planning feeds</source>
        <translation>Planificando avances</translation>
    </message>
    <message>
        <source>Proving the path</source>
        <translation>Comprobando la trayectoria</translation>
    </message>
    <message>
        <source>Put an end mill into the tool controller.</source>
        <translation>Ponga una fresa plana en el controlador de herramienta.</translation>
    </message>
    <message>
        <source>Raise FinalDepth or ZStockToLeave if that is not meant.</source>
        <translation>Suba FinalDepth o ZStockToLeave si no es lo que se quiere.</translation>
    </message>
    <message>
        <source>Raise HelixDiameterLimit.</source>
        <translation>Aumente HelixDiameterLimit.</translation>
    </message>
    <message>
        <source>Raise SafeHeight and ClearanceHeight above the stock.</source>
        <translation>Suba SafeHeight y ClearanceHeight por encima del bruto.</translation>
    </message>
    <message>
        <source>Raise SlotBite, or set it to 0 to have it found.</source>
        <translation>Suba SlotBite, o póngalo a 0 para que se determine.</translation>
    </message>
    <message>
        <source>Raise StartDepth to the top of the stock, or clear it with an operation before.</source>
        <translation>Suba StartDepth a la cara superior del material, o vacíelo antes con otra operación.</translation>
    </message>
    <message>
        <source>Raise StepDown.</source>
        <translation>Suba StepDown.</translation>
    </message>
    <message>
        <source>Raise StockToLeave if that is not meant.</source>
        <translation>Suba StockToLeave si no es lo que se quiere.</translation>
    </message>
    <message>
        <source>Recompute the operation to try again.</source>
        <translation>Recalcule la operación para intentarlo de nuevo.</translation>
    </message>
    <message>
        <source>Refine the part (Part workbench, Refine Shape), or select one of them.</source>
        <translation>Refine la pieza (banco Part, Refinar forma), o elija una de ellas.</translation>
    </message>
    <message>
        <source>Remove it from the base geometry and select the floor of the pocket again.</source>
        <translation>Quítela de la geometría base y seleccione de nuevo el fondo de la cajera.</translation>
    </message>
    <message>
        <source>Repair the part (Part workbench, Check Geometry).</source>
        <translation>Repare la pieza (banco Part, Comprobar geometría).</translation>
    </message>
    <message>
        <source>Repairing the path</source>
        <translation>Reparando la trayectoria</translation>
    </message>
    <message>
        <source>Select a face of the job's model, or add that part to it.</source>
        <translation>Seleccione una cara del modelo del trabajo, o añada esa pieza a él.</translation>
    </message>
    <message>
        <source>Select all faces that make the floor, or refine the part.</source>
        <translation>Seleccione todas las caras que forman el fondo, o refine la pieza.</translation>
    </message>
    <message>
        <source>Select the floor face of the pocket.</source>
        <translation>Seleccione la cara del fondo de la cajera.</translation>
    </message>
    <message>
        <source>Select the floor of the pocket, a flat level face with walls around it, or a wall of a hole through the part that ends at one level face below.</source>
        <translation>Seleccione el fondo de la cajera, una cara plana y horizontal con paredes alrededor, o una pared de un hueco pasante que termina abajo en una sola cara horizontal.</translation>
    </message>
    <message>
        <source>Select the floor of the pocket, or turn the part over.</source>
        <translation>Seleccione el fondo de la cajera o dé la vuelta a la pieza.</translation>
    </message>
    <message>
        <source>Set ClearanceHeight above SafeHeight above StartDepth.</source>
        <translation>Ponga ClearanceHeight sobre SafeHeight y esta sobre StartDepth.</translation>
    </message>
    <message>
        <source>Set ExtendOpenSides, or clear that side with another operation.</source>
        <translation>Active ExtendOpenSides, o vacíe ese lado con otra operación.</translation>
    </message>
    <message>
        <source>Set HelixAngle above 0 and below 90 degrees; 5 is usual.</source>
        <translation>Ponga HelixAngle por encima de 0 y por debajo de 90 grados; lo habitual es 5.</translation>
    </message>
    <message>
        <source>Set HelixAngle above {0} degrees; 5 is usual.</source>
        <translation>Ponga HelixAngle por encima de {0} grados; lo usual es 5.</translation>
    </message>
    <message>
        <source>Set HelixDiameterLimit to 0 for no limit.</source>
        <translation>Ponga HelixDiameterLimit en 0 para no limitar.</translation>
    </message>
    <message>
        <source>Set LinkFeed to 0 for the horizontal rapid rate.</source>
        <translation>Ponga LinkFeed en 0 para el rápido horizontal.</translation>
    </message>
    <message>
        <source>Set MaxEngagement up to {0} degrees, or to 0 for StepOver's.</source>
        <translation>Ponga MaxEngagement hasta {0} grados o en 0 para el de StepOver.</translation>
    </message>
    <message>
        <source>Set MaxFeedRatio to 1 or more; 2 is usual.</source>
        <translation>Ponga MaxFeedRatio en 1 o más; lo usual es 2.</translation>
    </message>
    <message>
        <source>Set SlotBite to 0 to have it found.</source>
        <translation>Ponga SlotBite a 0 para que se determine.</translation>
    </message>
    <message>
        <source>Set SlowdownPercent between 1 and 100; 75 is usual.</source>
        <translation>Ponga SlowdownPercent entre 1 y 100; lo usual es 75.</translation>
    </message>
    <message>
        <source>Set StartDepth above FinalDepth.</source>
        <translation>Ponga StartDepth por encima de FinalDepth.</translation>
    </message>
    <message>
        <source>Set StartPoint inside one, or do without.</source>
        <translation>Ponga StartPoint dentro de una o prescinda de él.</translation>
    </message>
    <message>
        <source>Set StartPoint where a helix has room, or near the slot along the wall.</source>
        <translation>Ponga StartPoint donde quepa una hélice, o cerca de la ranura a lo largo de la pared.</translation>
    </message>
    <message>
        <source>Set StartPoint, or do without.</source>
        <translation>Ponga StartPoint o prescinda de él.</translation>
    </message>
    <message>
        <source>Set StepDown above 0.</source>
        <translation>Ponga StepDown por encima de 0.</translation>
    </message>
    <message>
        <source>Set StepOver above 0; 20 to 45 % of the cutter's diameter is usual.</source>
        <translation>Ponga StepOver por encima de 0; lo usual es del 20 al 45 % del diámetro de la fresa.</translation>
    </message>
    <message>
        <source>Set StepOver to 100 % or less.</source>
        <translation>Ponga StepOver en 100 % o menos.</translation>
    </message>
    <message>
        <source>Set StepOver to {0}, or a smaller one.</source>
        <translation>Ponga StepOver en {0}, o menos.</translation>
    </message>
    <message>
        <source>Set Tolerance to at most {0} mm.</source>
        <translation>Ponga Tolerance a {0} mm como máximo.</translation>
    </message>
    <message>
        <source>Set all depths and heights.</source>
        <translation>Indique todas las profundidades y alturas.</translation>
    </message>
    <message>
        <source>Set it in the tool controller, unless you start the spindle by hand.</source>
        <translation>Póngala en el controlador de herramienta, salvo que arranque el husillo a mano.</translation>
    </message>
    <message>
        <source>Set it in the tool of the tool controller.</source>
        <translation>Póngalo en la herramienta del controlador.</translation>
    </message>
    <message>
        <source>Set it to 0 for none.</source>
        <translation>Ponga 0 para ninguno.</translation>
    </message>
    <message>
        <source>Set one up in the job's editor.</source>
        <translation>Cree uno en el editor del trabajo.</translation>
    </message>
    <message>
        <source>Set the feeds in the tool controller.</source>
        <translation>Ponga los avances en el controlador de herramienta.</translation>
    </message>
    <message>
        <source>Set the horizontal and vertical feed in the tool controller.</source>
        <translation>Ponga los avances horizontal y vertical en el controlador de herramienta.</translation>
    </message>
    <message>
        <source>Set the spindle's direction in the tool controller or the tool, or the other CutMode.</source>
        <translation>Ponga el sentido de giro del husillo hacia delante en el controlador de herramienta o en la herramienta, o el otro CutMode.</translation>
    </message>
    <message>
        <source>Set the spindle's direction there, or in the tool, unless you start it by hand.</source>
        <translation>Ponga el sentido de giro del husillo ahí o en la herramienta, salvo que lo arranque a mano.</translation>
    </message>
    <message>
        <source>Spiral Pocket needs shapely 2, this FreeCAD has {0}.</source>
        <translation>Spiral Pocket necesita shapely 2; este FreeCAD tiene {0}.</translation>
    </message>
    <message>
        <source>Spiral Pocket needs the Python library {0}, which this FreeCAD lacks.</source>
        <translation>Spiral Pocket necesita la biblioteca Python {0}, que falta en este FreeCAD.</translation>
    </message>
    <message>
        <source>Stopped by the user.</source>
        <translation>Detenido por el usuario.</translation>
    </message>
    <message>
        <source>Take a cutter below {0} mm.</source>
        <translation>Tome una fresa de menos de {0} mm.</translation>
    </message>
    <message>
        <source>Take a larger step-over or the strategy Automatic.</source>
        <translation>Tome un paso lateral mayor o la estrategia Automático.</translation>
    </message>
    <message>
        <source>Take a longer tool; its holder would strike the part.</source>
        <translation>Tome una herramienta más larga; su portaherramientas chocaría con la pieza.</translation>
    </message>
    <message>
        <source>Take a lower feed or a smaller SlotBite if that is too heavy for the cutter.</source>
        <translation>Reduzca el avance o el valor de SlotBite si es demasiado para la fresa.</translation>
    </message>
    <message>
        <source>Take a smaller cutter or the strategy Automatic.</source>
        <translation>Tome una fresa menor o la estrategia Automático.</translation>
    </message>
    <message>
        <source>Take a smaller cutter.</source>
        <translation>Tome una fresa menor.</translation>
    </message>
    <message>
        <source>Take a smaller cutter; a hole as wide as the cutter is one for FreeCAD's Drilling.</source>
        <translation>Tome una fresa más pequeña; un agujero tan ancho como la fresa es cosa del Taladrado de FreeCAD.</translation>
    </message>
    <message>
        <source>Take a smaller cutter; a slot as wide as the cutter is one for FreeCAD's Slot.</source>
        <translation>Use una fresa más pequeña; una ranura tan ancha como la fresa es para la operación Slot de FreeCAD.</translation>
    </message>
    <message>
        <source>Take a wider cutter or a larger step-over.</source>
        <translation>Tome una fresa mayor o un paso lateral mayor.</translation>
    </message>
    <message>
        <source>Take that part out of the job's model if it is not there when the pocket is cut.</source>
        <translation>Quite esa pieza del modelo del trabajo si no está ahí cuando se corta la cajera.</translation>
    </message>
    <message>
        <source>Take that part out of the job's model.</source>
        <translation>Quite esa pieza del modelo del trabajo.</translation>
    </message>
    <message>
        <source>That part stays uncut.</source>
        <translation>Esa parte queda sin cortar.</translation>
    </message>
    <message>
        <source>The cutter goes down at {at}, {0} mm from the start point: that is as near as {1} can begin.</source>
        <translation>La fresa baja en {at}, a {0} mm del punto de inicio: {1} no puede empezar más cerca.</translation>
    </message>
    <message>
        <source>The cutter goes {0} mm below the floor.</source>
        <translation>La fresa baja {0} mm por debajo del fondo.</translation>
    </message>
    <message>
        <source>The cutter goes {0} mm below the selected floor, {1} mm of that below the stock.</source>
        <translation>La fresa baja {0} mm por debajo del fondo elegido, de ellos {1} mm por debajo del material.</translation>
    </message>
    <message>
        <source>The cutter goes {0} mm below the selected floor.</source>
        <translation>La fresa baja {0} mm por debajo del fondo elegido.</translation>
    </message>
    <message>
        <source>The cutter goes {0} mm below the top of the stock, the tool is {1} mm long.</source>
        <translation>La fresa baja {0} mm por debajo de la cara superior del bruto, la herramienta mide {1} mm.</translation>
    </message>
    <message>
        <source>The cutter goes {0} mm into the walls.</source>
        <translation>La fresa entra {0} mm en las paredes.</translation>
    </message>
    <message>
        <source>The cutter has no room to go down anywhere in the pocket.</source>
        <translation>La fresa no tiene sitio para bajar en ninguna parte de la cajera.</translation>
    </message>
    <message>
        <source>The depths are upside down: the pocket's floor (final depth {0} mm) is not below its top (start depth {1} mm).</source>
        <translation>Las profundidades están invertidas: el fondo de la cajera (profundidad final {0} mm) no está bajo su parte superior (profundidad inicial {1} mm).</translation>
    </message>
    <message>
        <source>The expression of {0} cannot be evaluated: {1}.</source>
        <translation>La expresión de {0} no se puede evaluar: {1}.</translation>
    </message>
    <message>
        <source>The feed is lowered there; take a lower one if that is too heavy for the cutter.</source>
        <translation>Allí se reduce el avance; tome uno menor si es demasiado para la fresa.</translation>
    </message>
    <message>
        <source>The finish depth of {0} mm is not between 0 and the step down of {1} mm.</source>
        <translation>La profundidad de acabado de {0} mm no está entre 0 y la pasada de {1} mm.</translation>
    </message>
    <message>
        <source>The fit of {0} patches has no solution.</source>
        <translation>El ajuste de {0} tramos de curva no tiene solución.</translation>
    </message>
    <message>
        <source>The floor goes on beyond what is selected; that stays.</source>
        <translation>El fondo sigue más allá de lo seleccionado; eso queda.</translation>
    </message>
    <message>
        <source>The heights are upside down: clearance {0} mm, safe {1} mm, start depth {2} mm.</source>
        <translation>Las alturas están invertidas: despeje {0} mm, segura {1} mm, profundidad inicial {2} mm.</translation>
    </message>
    <message>
        <source>The helix's diameter limit is negative.</source>
        <translation>El límite del diámetro de la hélice es negativo.</translation>
    </message>
    <message>
        <source>The hole ends at Z{0}, the part goes down to Z{1}; the cutter goes down to Z{2}.</source>
        <translation>El hueco termina en Z{0}, la pieza baja hasta Z{1}; la fresa baja hasta Z{2}.</translation>
    </message>
    <message>
        <source>The horizontal feed of {0} mm/min is more than the chosen machine does; the program runs at {1} mm/min.</source>
        <translation>El avance horizontal de {0} mm/min es más de lo que alcanza la máquina elegida; el programa va a {1} mm/min.</translation>
    </message>
    <message>
        <source>The largest feed ratio of {0} is below 1.</source>
        <translation>El factor de avance máximo {0} es menor que 1.</translation>
    </message>
    <message>
        <source>The level from Z{0} to Z{1} is not between 0 and the step down of {2} mm deep.</source>
        <translation>El nivel de Z{0} a Z{1} no tiene una profundidad entre 0 y la pasada de {2} mm.</translation>
    </message>
    <message>
        <source>The link feed is negative.</source>
        <translation>El avance de enlace es negativo.</translation>
    </message>
    <message>
        <source>The lowest level, at Z{0}, is not the pocket's floor.</source>
        <translation>El nivel más bajo, en Z{0}, no es el fondo de la cajera.</translation>
    </message>
    <message>
        <source>The machine file {0} cannot be read: {1}.</source>
        <translation>El archivo de máquina {0} no se puede leer: {1}.</translation>
    </message>
    <message>
        <source>The machine file {0} is broken: {1}.</source>
        <translation>El archivo de máquina {0} es defectuoso: {1}.</translation>
    </message>
    <message>
        <source>The machine file {0} lacks {1}.</source>
        <translation>Al archivo de máquina {0} le falta {1}.</translation>
    </message>
    <message>
        <source>The outline of {0} crosses itself.</source>
        <translation>El contorno de {0} se cruza a sí mismo.</translation>
    </message>
    <message>
        <source>The outline of {0} has points at infinity.</source>
        <translation>El contorno ({0}) tiene puntos en el infinito.</translation>
    </message>
    <message>
        <source>The outline of {0} is broken ({1}).</source>
        <translation>El contorno ({0}) está roto ({1}).</translation>
    </message>
    <message>
        <source>The outline of {0} is not closed at X{1} Y{2}.</source>
        <translation>El contorno de {0} no está cerrado en X{1} Y{2}.</translation>
    </message>
    <message>
        <source>The part overhangs the whole floor; no cutter gets there from above.</source>
        <translation>La pieza cubre todo el fondo; ninguna fresa llega desde arriba.</translation>
    </message>
    <message>
        <source>The part with {0} is an open shell, not a closed solid.</source>
        <translation>La pieza con {0} es una cáscara abierta, no un sólido cerrado.</translation>
    </message>
    <message>
        <source>The path was made, but at {at} would cut {0} mm into a wall or the floor; it is not handed out.</source>
        <translation>La trayectoria está hecha, pero en {at} cortaría {0} mm en una pared o en el fondo; no se entrega.</translation>
    </message>
    <message>
        <source>The path was made, but at {at} would run {0} mm through standing stock where it should not cut; it is not handed out.</source>
        <translation>La trayectoria se hizo, pero en {at} atravesaría {0} mm de material donde no debe cortar; no se entrega.</translation>
    </message>
    <message>
        <source>The plate has several summits.</source>
        <translation>La placa tiene varias cumbres.</translation>
    </message>
    <message>
        <source>The pocket at {at} is cut by {0} instead of {1}: {2}.</source>
        <translation>La cajera en {at} se corta con {0} en lugar de {1}: {2}.</translation>
    </message>
    <message>
        <source>The pocket at {at} is cut with a step-over of {0} mm instead of {1} mm: {2}.</source>
        <translation>La cajera en {at} se corta con un paso lateral de {0} mm en lugar de {1} mm: {2}.</translation>
    </message>
    <message>
        <source>The pocket has no area.</source>
        <translation>La cajera no tiene área.</translation>
    </message>
    <message>
        <source>The pocket is more than {0} step-overs wide.</source>
        <translation>La cajera mide más de {0} pasos de ancho.</translation>
    </message>
    <message>
        <source>The pocket is no wider than the {0} mm cutter{1}, at {at}.</source>
        <translation>La cajera no es más ancha que la fresa de {0} mm{1}, en {at}.</translation>
    </message>
    <message>
        <source>The pocket is open at a side; the cutter runs out of it there.</source>
        <translation>La cajera está abierta por un lado; la fresa sale de ella por allí.</translation>
    </message>
    <message>
        <source>The pocket is open at a side; the cutter stays within the floor there.</source>
        <translation>La cajera está abierta por un lado; allí la fresa no sale del fondo.</translation>
    </message>
    <message>
        <source>The pocket is too narrow at {at} for Isotherm: no isotherm leads through.</source>
        <translation>La cajera es demasiado estrecha en {at} para Isotermas: ninguna isoterma pasa.</translation>
    </message>
    <message>
        <source>The pocket lies beside the stock.</source>
        <translation>La cajera está al lado del bruto.</translation>
    </message>
    <message>
        <source>The pocket's outline has points at infinity.</source>
        <translation>El contorno de la cajera tiene puntos en el infinito.</translation>
    </message>
    <message>
        <source>The pocket's outline is broken ({0}).</source>
        <translation>El contorno de la cajera es defectuoso ({0}).</translation>
    </message>
    <message>
        <source>The pocket's wall near {at} is too jagged or too narrow for Linear Morph.</source>
        <translation>La pared de la cajera cerca de {at} es demasiado dentada o estrecha para Transición lineal.</translation>
    </message>
    <message>
        <source>The selected floor lies {0} mm above the stock.</source>
        <translation>El fondo elegido está {0} mm por encima del material.</translation>
    </message>
    <message>
        <source>The selected floor lies {0} mm below the stock.</source>
        <translation>El fondo elegido está {0} mm por debajo del material.</translation>
    </message>
    <message>
        <source>The slot bite is negative.</source>
        <translation>La profundidad por pasada de la ranura es negativa.</translation>
    </message>
    <message>
        <source>The slowed feed of {0} percent is not between 0 and 100 percent.</source>
        <translation>El avance reducido del {0} por ciento no está entre 0 y 100.</translation>
    </message>
    <message>
        <source>The spindle runs in reverse; what CutMode calls climb is conventional then.</source>
        <translation>El husillo gira al revés; lo que CutMode llama en concordancia es entonces en oposición.</translation>
    </message>
    <message>
        <source>The spindle speed of {0} is 0; the program does not start it.</source>
        <translation>La velocidad del husillo de {0} es 0; el programa no lo arranca.</translation>
    </message>
    <message>
        <source>The start point at {at} lies in none of the pockets.</source>
        <translation>El punto de inicio en {at} no está en ninguna cajera.</translation>
    </message>
    <message>
        <source>The start point is not a place.</source>
        <translation>El punto de inicio no es un lugar.</translation>
    </message>
    <message>
        <source>The stock reaches {0} mm above the height at which rapids go over it.</source>
        <translation>El bruto sobresale {0} mm de la altura de los movimientos rápidos.</translation>
    </message>
    <message>
        <source>The stock reaches {0} mm above the start depth; the cutter goes down through that without ramping.</source>
        <translation>El material sobresale {0} mm de la profundidad inicial; la fresa lo atraviesa sin rampa.</translation>
    </message>
    <message>
        <source>The strategy Automatic begins anywhere with room for a helix.</source>
        <translation>La estrategia Automático empieza en cualquier lugar con sitio para una hélice.</translation>
    </message>
    <message>
        <source>The wall at {at} cannot be cut at Z{0}: {1}.</source>
        <translation>La pared en {at} no se puede cortar en Z{0}: {1}.</translation>
    </message>
    <message>
        <source>The wall of the pocket about {at} is too jagged for Central Spiral.</source>
        <translation>La pared de la cajera cerca de {at} es demasiado dentada para Espiral central.</translation>
    </message>
    <message>
        <source>The walls' outline at Z{0} is not closed at {at}.</source>
        <translation>El contorno de las paredes en Z{0} no está cerrado en {at}.</translation>
    </message>
    <message>
        <source>The {0} is not a number.</source>
        <translation>{0} no es un número.</translation>
    </message>
    <message>
        <source>The {0} mm cutter does not fit the pocket{1}: it is {2} mm wide at its widest, at {at}.</source>
        <translation>La fresa de {0} mm no cabe en la cajera{1}: mide {2} mm en lo más ancho, en {at}.</translation>
    </message>
    <message>
        <source>The {0} mm cutter does not fit the room at {at}, {1} mm wide at its widest; that part ({2} mm2) stays uncut.</source>
        <translation>La fresa de {0} mm no cabe en el espacio en {at}, de {1} mm en su parte más ancha; esa parte ({2} mm2) queda sin cortar.</translation>
    </message>
    <message>
        <source>The {0} mm cutter does not fit the {1} mm neck at {at}; that part ({2} mm2) stays uncut.</source>
        <translation>La fresa de {0} mm no pasa por el estrecho de {1} mm en {at}; esa parte ({2} mm2) queda sin cortar.</translation>
    </message>
    <message>
        <source>The {0} mm cutter does not fit {1} necks, up to {2} mm wide, the widest at {at}; these parts ({3} mm2) stay uncut.</source>
        <translation>La fresa de {0} mm no pasa por {1} estrechos de hasta {2} mm, el más ancho en {at}; esas partes ({3} mm2) quedan sin cortar.</translation>
    </message>
    <message>
        <source>The {0} mm cutter does not fit {1} rooms, up to {2} mm wide, the widest at {at}; these ({3} mm2) stay uncut.</source>
        <translation>La fresa de {0} mm no cabe en {1} espacios de hasta {2} mm, el más ancho en {at}; estos ({3} mm2) quedan sin cortar.</translation>
    </message>
    <message>
        <source>The {0} mm cutter fits the pocket, but has no room for its helix at {at} (circle of {1} mm).</source>
        <translation>La fresa de {0} mm cabe en la cajera, pero no tiene sitio para su hélice en {at} (círculo de {1} mm).</translation>
    </message>
    <message>
        <source>There is no machine '{0}'.</source>
        <translation>No hay ninguna máquina '{0}'.</translation>
    </message>
    <message>
        <source>This FreeCAD cannot read {0}, which another version has saved.</source>
        <translation>Este FreeCAD no puede leer {0}, guardado por otra versión.</translation>
    </message>
    <message>
        <source>This pocket is not cut.</source>
        <translation>Esta cajera no se corta.</translation>
    </message>
    <message>
        <source>Try another step-over or strategy, and please report this pocket.</source>
        <translation>Pruebe otro paso lateral u otra estrategia e informe de esta cajera.</translation>
    </message>
    <message>
        <source>Turn the part over, or machine it from another side.</source>
        <translation>Dé la vuelta a la pieza o mecanícela desde otro lado.</translation>
    </message>
    <message>
        <source>Unset UseOutline if they shall stand.</source>
        <translation>Desactive UseOutline si deben quedar en pie.</translation>
    </message>
    <message>
        <source>Unset UseRestMachining to cut it all the same.</source>
        <translation>Desactive UseRestMachining para cortarla de todos modos.</translation>
    </message>
    <message>
        <source>Use a flat end mill, or finish the floor with one.</source>
        <translation>Use una fresa plana o acabe el fondo con una.</translation>
    </message>
    <message>
        <source>Walls lean over the floor; {0} mm2 of it below them stay uncut.</source>
        <translation>Hay paredes que se inclinan sobre el fondo; {0} mm2 debajo quedan sin cortar.</translation>
    </message>
    <message>
        <source>Walls that are not vertical keep steps up to {0} mm wide and {1} mm high, the widest at {at}.</source>
        <translation>Las paredes no verticales conservan escalones de hasta {0} mm de ancho y {1} mm de alto, el más ancho en {at}.</translation>
    </message>
    <message>
        <source>Where that is done already, lower StartDepth or set UseRestMachining.</source>
        <translation>Donde eso ya esté hecho, baje StartDepth o active UseRestMachining.</translation>
    </message>
    <message>
        <source>With a slot bite of {0} mm a slot has more than {1} levels.</source>
        <translation>Con una profundidad de pasada de {0} mm una ranura tiene más de {1} niveles.</translation>
    </message>
    <message>
        <source>With {0} mm of stock to leave on the floor nothing is left to cut.</source>
        <translation>Con {0} mm de sobrematerial en el fondo no queda nada que cortar.</translation>
    </message>
    <message>
        <source>{0} does not start the spindle.</source>
        <translation>{0} no arranca el husillo.</translation>
    </message>
    <message>
        <source>{0} has no face {1}.</source>
        <translation>{0} no tiene la cara {1}.</translation>
    </message>
    <message>
        <source>{0} has no model.</source>
        <translation>{0} no tiene modelo.</translation>
    </message>
    <message>
        <source>{0} has no stock.</source>
        <translation>{0} no tiene material.</translation>
    </message>
    <message>
        <source>{0} has no tool controller.</source>
        <translation>{0} no tiene controlador de herramienta.</translation>
    </message>
    <message>
        <source>{0} has no tool, or one without a diameter.</source>
        <translation>{0} no tiene herramienta, o una sin diámetro.</translation>
    </message>
    <message>
        <source>{0} has no {1}; the path carries no feeds and its time is unknown.</source>
        <translation>{0} no tiene {1}; la trayectoria no lleva avances y su tiempo es desconocido.</translation>
    </message>
    <message>
        <source>{0} has tool number 0, which stands for no tool.</source>
        <translation>{0} tiene el número de herramienta 0, que significa ninguna.</translation>
    </message>
    <message>
        <source>{0} is not a face.</source>
        <translation>{0} no es una cara.</translation>
    </message>
    <message>
        <source>{0} is not an end mill; it cannot clear a pocket.</source>
        <translation>{0} no es una fresa plana; no puede vaciar una cajera.</translation>
    </message>
    <message>
        <source>{0} is not flat at its end and leaves ridges on the floor.</source>
        <translation>{0} no es plana en la punta y deja crestas en el fondo.</translation>
    </message>
    <message>
        <source>{0} is not flat.</source>
        <translation>{0} no es plana.</translation>
    </message>
    <message>
        <source>{0} is not in a job.</source>
        <translation>{0} no está en ningún trabajo.</translation>
    </message>
    <message>
        <source>{0} is not in the job's model.</source>
        <translation>{0} no está en el modelo del trabajo.</translation>
    </message>
    <message>
        <source>{0} is not level.</source>
        <translation>{0} no es horizontal.</translation>
    </message>
    <message>
        <source>{0} is not the floor of a pocket: no wall rises from it.</source>
        <translation>{0} no es el fondo de una cajera: ninguna pared sube de ella.</translation>
    </message>
    <message>
        <source>{0} is not there any more: the model has changed.</source>
        <translation>{0} ya no existe: el modelo ha cambiado.</translation>
    </message>
    <message>
        <source>{0} is vertical: it is a wall, not a floor.</source>
        <translation>{0} es vertical: es una pared, no un fondo.</translation>
    </message>
    <message>
        <source>{0} is {1}; it must be more than 0.</source>
        <translation>{0}: {1}. El valor debe ser mayor que 0.</translation>
    </message>
    <message>
        <source>{0} leaves the radius of its corner, {1} mm, at the foot of walls.</source>
        <translation>{0} deja el radio de su esquina, {1} mm, al pie de las paredes.</translation>
    </message>
    <message>
        <source>{0} looks down.</source>
        <translation>{0} mira hacia abajo.</translation>
    </message>
    <message>
        <source>{0} meet, but do not make one floor.</source>
        <translation>{0} se tocan, pero no forman un solo fondo.</translation>
    </message>
    <message>
        <source>{0} mm2 of the floor stay uncut, the largest part at {at}.</source>
        <translation>{0} mm2 del fondo quedan sin cortar, la mayor parte en {at}.</translation>
    </message>
    <message>
        <source>{0} mm2 of the pocket lie beside the stock, at {at}.</source>
        <translation>{0} mm2 de la cajera están al lado del bruto, en {at}.</translation>
    </message>
</context>
<context>
    <name>SpiralPocketPanel</name>
    <message>
        <source>Tool controller</source>
        <translation>Controlador de herramienta</translation>
    </message>
    <message>
        <source>The tool and its feeds and speed</source>
        <translation>La herramienta con sus avances y su velocidad</translation>
    </message>
    <message>
        <source>Coolant</source>
        <translation>Refrigerante</translation>
    </message>
    <message>
        <source>The coolant of this operation</source>
        <translation>El refrigerante de esta operación</translation>
    </message>
    <message>
        <source>Show feeds, speed and tool here, to change them for all operations with this tool controller</source>
        <translation>Mostrar aquí avances, velocidad y herramienta, para cambiarlos en todas las operaciones con este controlador de herramienta</translation>
    </message>
    <message>
        <source>Edit Tool Controller</source>
        <translation>Editar controlador de herramienta</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>Estrategia</translation>
    </message>
    <message>
        <source>Step over percent</source>
        <translation>Paso lateral (%)</translation>
    </message>
    <message>
        <source>Step over</source>
        <translation>Paso lateral</translation>
    </message>
    <message>
        <source>Engagement angle</source>
        <translation>Ángulo de contacto</translation>
    </message>
    <message>
        <source>Cut mode</source>
        <translation>Modo de corte</translation>
    </message>
    <message>
        <source>XY stock to leave</source>
        <translation>Sobrematerial XY</translation>
    </message>
    <message>
        <source>Z stock to leave</source>
        <translation>Sobrematerial Z</translation>
    </message>
    <message>
        <source>Helix ramp angle</source>
        <translation>Ángulo de la hélice</translation>
    </message>
    <message>
        <source>Helix max diameter</source>
        <translation>Diámetro máx. de la hélice</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Máquina</translation>
    </message>
    <message>
        <source>Feed mode</source>
        <translation>Modo de avance</translation>
    </message>
    <message>
        <source>Slow-down percent</source>
        <translation>Avance reducido (%)</translation>
    </message>
    <message>
        <source>Max feed ratio</source>
        <translation>Factor de avance máx.</translation>
    </message>
    <message>
        <source>Finishing profile</source>
        <translation>Pasada de acabado</translation>
    </message>
    <message>
        <source>Ignore islands</source>
        <translation>Ignorar islas</translation>
    </message>
    <message>
        <source>Show options that are rarely needed</source>
        <translation>Mostrar las opciones que rara vez hacen falta</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Avanzado</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancia</translation>
    </message>
    <message>
        <source>Link feed</source>
        <translation>Avance de enlace</translation>
    </message>
    <message>
        <source>Slot bite</source>
        <translation>Pasada en ranura</translation>
    </message>
    <message>
        <source>Extend open sides</source>
        <translation>Extender los lados abiertos</translation>
    </message>
    <message>
        <source>Use rest machining</source>
        <translation>Mecanizado de restos</translation>
    </message>
    <message>
        <source>Use start point</source>
        <translation>Usar punto de inicio</translation>
    </message>
    <message>
        <source>Start point X</source>
        <translation>Punto de inicio X</translation>
    </message>
    <message>
        <source>Start point Y</source>
        <translation>Punto de inicio Y</translation>
    </message>
    <message>
        <source>Take the place that was clicked on the part</source>
        <translation>Tomar el lugar pulsado en la pieza</translation>
    </message>
    <message>
        <source>From selection</source>
        <translation>De la selección</translation>
    </message>
</context>
<context>
    <name>SpiralPocketPreferences</name>
    <message>
        <source>Spiral Pocket</source>
        <translation>Cajera en espiral</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Máquina</translation>
    </message>
    <message>
        <source>Folder with own machines</source>
        <translation>Carpeta de máquinas propias</translation>
    </message>
    <message>
        <source>Machine files (JSON) in this folder are offered besides those of the add-on; after the next start</source>
        <translation>Los archivos de máquina (JSON) de esta carpeta se ofrecen junto a los del complemento; desde el próximo inicio</translation>
    </message>
    <message>
        <source>Defaults of new operations</source>
        <translation>Valores por defecto de operaciones nuevas</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>Estrategia</translation>
    </message>
    <message>
        <source>Step over percent</source>
        <translation>Paso lateral (%)</translation>
    </message>
    <message>
        <source>Cut mode</source>
        <translation>Modo de corte</translation>
    </message>
    <message>
        <source>Helix ramp angle</source>
        <translation>Ángulo de la hélice</translation>
    </message>
    <message>
        <source>Feed mode</source>
        <translation>Modo de avance</translation>
    </message>
    <message>
        <source>Slow-down percent</source>
        <translation>Avance reducido (%)</translation>
    </message>
    <message>
        <source>Max feed ratio</source>
        <translation>Factor de avance máx.</translation>
    </message>
    <message>
        <source>Link feed</source>
        <translation>Avance de enlace</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancia</translation>
    </message>
</context>
<context>
    <name>SpiralPocket_Create</name>
    <message>
        <source>Spiral Pocket</source>
        <translation>Cajera en espiral</translation>
    </message>
    <message>
        <source>Clears the pockets above the selected floors with one smooth spiral each</source>
        <translation>Vacía las cajeras sobre los fondos elegidos, cada una con una espiral suave</translation>
    </message>
</context>
</TS>
