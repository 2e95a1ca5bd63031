<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>QObject</name>
    <message>
        <source>Move %1</source>
        <translation>Mover %1</translation>
    </message>
    <message>
        <source>&lt;p&gt;%1 more rows; the exported table has all of them.&lt;/p&gt;</source>
        <translation>&lt;p&gt;%1 filas más; la tabla exportada las contiene todas.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>Girar %1</translation>
    </message>
    <message>
        <source>&lt;b&gt;Trial %1&lt;/b&gt;, inputs farthest from their estimates: %2</source>
        <translation>&lt;b&gt;Ensayo %1&lt;/b&gt;, entradas más alejadas de sus estimaciones: %2</translation>
    </message>
    <message>
        <source>Only %1 is shown (Shift+H: all)</source>
        <translation>Solo se muestra %1 (Mayús+H: todo)</translation>
    </message>
    <message numerus="yes">
        <source>%n hidden (Shift+H: show all)</source>
        <translation>
            <numerusform>%n ocultos (Mayús+H: mostrar todo)</numerusform>
            <numerusform>%n ocultos (Mayús+H: mostrar todo)</numerusform>
        </translation>
    </message>
    <message>
        <source>The interval is not symmetric about the estimate: state the interval, not y ± U (JCGM 101 5.5).</source>
        <translation>El intervalo no es simétrico respecto a la estimación: indique el intervalo, no y ± U (JCGM 101 5.5).</translation>
    </message>
    <message>
        <source>Turns about its %1 axis</source>
        <translation>Gira alrededor de su eje %1</translation>
    </message>
    <message>
        <source>Moves along %1</source>
        <translation>Se mueve a lo largo de %1</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>Pose from points</source>
        <extracomment>Measurement model</extracomment>
        <translation>Pose a partir de puntos</translation>
    </message>
    <message>
        <source>Base frame</source>
        <translation>Sistema base</translation>
    </message>
    <message>
        <source>Base points</source>
        <translation>Puntos de la base</translation>
    </message>
    <message>
        <source>Nominal coordinates of the points in their own frame, and standard uncertainties of single coordinates where they differ from the common ones.</source>
        <translation>Coordenadas nominales de los puntos en su propio sistema, e incertidumbres típicas de coordenadas individuales cuando difieren de las comunes.</translation>
    </message>
    <message>
        <source>name</source>
        <translation>nombre</translation>
    </message>
    <message>
        <source>Name of the point.</source>
        <translation>Nombre del punto.</translation>
    </message>
    <message>
        <source>Nominal coordinate x in the point&apos;s own frame.</source>
        <translation>Coordenada nominal x en el sistema propio del punto.</translation>
    </message>
    <message>
        <source>Nominal coordinate y in the point&apos;s own frame.</source>
        <translation>Coordenada nominal y en el sistema propio del punto.</translation>
    </message>
    <message>
        <source>Nominal coordinate z in the point&apos;s own frame.</source>
        <translation>Coordenada nominal z en el sistema propio del punto.</translation>
    </message>
    <message>
        <source>Standard uncertainty of this x; empty: as typed for all.</source>
        <translation>Incertidumbre típica de esta x; vacío: la indicada para todos.</translation>
    </message>
    <message>
        <source>Standard uncertainty of this y; empty: as typed for all.</source>
        <translation>Incertidumbre típica de esta y; vacío: la indicada para todos.</translation>
    </message>
    <message>
        <source>Standard uncertainty of this z; empty: as typed for all.</source>
        <translation>Incertidumbre típica de esta z; vacío: la indicada para todos.</translation>
    </message>
    <message>
        <source>Frame from its points</source>
        <translation>Sistema a partir de sus puntos</translation>
    </message>
    <message>
        <source>3-2-1: the origin from point 1, the x-axis from points 1 and 2, the xy-plane from points 1, 2 and 3. Least squares: the frame in which the nominal coordinates fit all points best.</source>
        <translation>3-2-1: el origen con el punto 1, el eje x con los puntos 1 y 2, el plano xy con los puntos 1, 2 y 3. Mínimos cuadrados: el sistema en el que las coordenadas nominales se ajustan mejor a todos los puntos.</translation>
    </message>
    <message>
        <source>3-2-1</source>
        <translation>3-2-1</translation>
    </message>
    <message>
        <source>least squares</source>
        <translation>mínimos cuadrados</translation>
    </message>
    <message>
        <source>Side of point 3</source>
        <translation>Lado del punto 3</translation>
    </message>
    <message>
        <source>On which side of the x-axis point 3 lies in the base frame b; this directs z.</source>
        <translation>A qué lado del eje x está el punto 3 en el sistema base b; determina el sentido de z.</translation>
    </message>
    <message>
        <source>negative y: z = (q3 − q1) × x</source>
        <translation>y negativa: z = (q3 − q1) × x</translation>
    </message>
    <message>
        <source>positive y: z = x × (q3 − q1)</source>
        <translation>y positiva: z = x × (q3 − q1)</translation>
    </message>
    <message>
        <source>Origin from point 1, x</source>
        <translation>Origen desde el punto 1, x</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along x of the base frame b (s of Eqs 17 and 18).</source>
        <translation>Posición del origen respecto del punto 1 según x del sistema base b (s de las ecs. 17 y 18).</translation>
    </message>
    <message>
        <source>Origin from point 1, y</source>
        <translation>Origen desde el punto 1, y</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along y of the base frame b (s of Eqs 17 and 18).</source>
        <translation>Posición del origen respecto del punto 1 según y del sistema base b (s de las ecs. 17 y 18).</translation>
    </message>
    <message>
        <source>Origin from point 1, z</source>
        <translation>Origen desde el punto 1, z</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along z of the base frame b (s of Eqs 17 and 18).</source>
        <translation>Posición del origen respecto del punto 1 según z del sistema base b (s de las ecs. 17 y 18).</translation>
    </message>
    <message>
        <source>Pose of the base in frame 0</source>
        <translation>Pose de la base en el sistema 0</translation>
    </message>
    <message>
        <source>Where the base stands in the frame of the measurement (frame 0, the world of the picture). It matters only for an instrument that stands somewhere.</source>
        <translation>Dónde está la base en el sistema de la medición (sistema 0, el sistema global de la imagen). Solo importa para un instrumento que tiene un emplazamiento.</translation>
    </message>
    <message>
        <source>Moving frame</source>
        <translation>Sistema móvil</translation>
    </message>
    <message>
        <source>Points of the moving frame</source>
        <translation>Puntos del sistema móvil</translation>
    </message>
    <message>
        <source>On which side of the x-axis point 3 lies in the moving frame p; this directs z.</source>
        <translation>A qué lado del eje x está el punto 3 en el sistema móvil p; determina el sentido de z.</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along x of the moving frame p (s of Eqs 17 and 18).</source>
        <translation>Posición del origen respecto del punto 1 según x del sistema móvil p (s de las ecs. 17 y 18).</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along y of the moving frame p (s of Eqs 17 and 18).</source>
        <translation>Posición del origen respecto del punto 1 según y del sistema móvil p (s de las ecs. 17 y 18).</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along z of the moving frame p (s of Eqs 17 and 18).</source>
        <translation>Posición del origen respecto del punto 1 según z del sistema móvil p (s de las ecs. 17 y 18).</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>Poses</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>Evaluación</translation>
    </message>
    <message>
        <source>A priori: at the nominal coordinates. A posteriori: at the means of measured coordinates.</source>
        <translation>A priori: en las coordenadas nominales. A posteriori: en las medias de las coordenadas medidas.</translation>
    </message>
    <message>
        <source>a priori (nominal poses)</source>
        <translation>a priori (poses nominales)</translation>
    </message>
    <message>
        <source>a posteriori (measured points)</source>
        <translation>a posteriori (puntos medidos)</translation>
    </message>
    <message>
        <source>Nominal poses of the moving frame in the base frame; angles are R = Rz(γ) Ry(β) Rx(α). All poses share the measurement of the base.</source>
        <translation>Poses nominales del sistema móvil en el sistema base; los ángulos son R = Rz(γ) Ry(β) Rx(α). Todas las poses comparten la medición de la base.</translation>
    </message>
    <message>
        <source>Name of the pose; groups its results.</source>
        <translation>Nombre de la pose; agrupa sus resultados.</translation>
    </message>
    <message>
        <source>Position x in the base frame.</source>
        <translation>Posición x en el sistema base.</translation>
    </message>
    <message>
        <source>Position y in the base frame.</source>
        <translation>Posición y en el sistema base.</translation>
    </message>
    <message>
        <source>Position z in the base frame.</source>
        <translation>Posición z en el sistema base.</translation>
    </message>
    <message>
        <source>Rotation about x.</source>
        <translation>Rotación alrededor de x.</translation>
    </message>
    <message>
        <source>Rotation about y.</source>
        <translation>Rotación alrededor de y.</translation>
    </message>
    <message>
        <source>Rotation about z.</source>
        <translation>Rotación alrededor de z.</translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation>Puntos medidos</translation>
    </message>
    <message>
        <source>Coordinates in one frame 0 for the base and every pose, typed or from a CSV file; the mean of the repeats is the estimate.</source>
        <translation>Coordenadas en un mismo sistema 0 para la base y todas las poses, tecleadas o de un archivo CSV; la media de las repeticiones es la estimación.</translation>
    </message>
    <message>
        <source>set</source>
        <translation>conjunto</translation>
    </message>
    <message>
        <source>&quot;base&quot;, or the name of a pose.</source>
        <translation>&quot;base&quot;, o el nombre de una pose.</translation>
    </message>
    <message>
        <source>point</source>
        <translation>punto</translation>
    </message>
    <message>
        <source>repeat</source>
        <translation>repetición</translation>
    </message>
    <message>
        <source>Number of the repetition.</source>
        <translation>Número de la repetición.</translation>
    </message>
    <message>
        <source>Measured coordinate x in frame 0.</source>
        <translation>Coordenada medida x en el sistema 0.</translation>
    </message>
    <message>
        <source>Measured coordinate y in frame 0.</source>
        <translation>Coordenada medida y en el sistema 0.</translation>
    </message>
    <message>
        <source>Measured coordinate z in frame 0.</source>
        <translation>Coordenada medida z en el sistema 0.</translation>
    </message>
    <message>
        <source>Orientation stated as</source>
        <translation>Orientación expresada como</translation>
    </message>
    <message>
        <source>Numbers in which the result states the orientation of the moving frame. Angles are undefined in gimbal lock; rotation vector and quaternion are not.</source>
        <translation>Números con los que el resultado expresa la orientación del sistema móvil. Los ángulos no están definidos en el bloqueo de cardán; el vector de rotación y el cuaternión sí.</translation>
    </message>
    <message>
        <source>Z-Y-X angles (roll α, pitch β, yaw γ)</source>
        <translation>Ángulos Z-Y-X (alabeo α, cabeceo β, guiñada γ)</translation>
    </message>
    <message>
        <source>Z-Y-Z angles</source>
        <translation>Ángulos Z-Y-Z</translation>
    </message>
    <message>
        <source>rotation vector</source>
        <translation>vector de rotación</translation>
    </message>
    <message>
        <source>unit quaternion</source>
        <translation>cuaternión unitario</translation>
    </message>
    <message>
        <source>Uncertainty: Base frame</source>
        <translation>Incertidumbre: sistema base</translation>
    </message>
    <message>
        <source>Uncertainty of the points</source>
        <translation>Incertidumbre de los puntos</translation>
    </message>
    <message>
        <source>Standard uncertainties typed here, or those that an artefact or an instrument of the project gives.</source>
        <translation>Incertidumbres típicas tecleadas aquí, o las que da un artefacto o un instrumento del proyecto.</translation>
    </message>
    <message>
        <source>typed</source>
        <translation>tecleada</translation>
    </message>
    <message>
        <source>artefact or instrument</source>
        <translation>artefacto o instrumento</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along x of the base frame b.</source>
        <translation>Incertidumbre típica de las coordenadas de los puntos según x del sistema base b.</translation>
    </message>
    <message>
        <source>u_x is common</source>
        <translation>u_x es común</translation>
    </message>
    <message>
        <source>One and the same deviation along x for all base points, instead of independent ones.</source>
        <translation>Una misma desviación según x para todos los puntos de la base, en lugar de desviaciones independientes.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along y of the base frame b.</source>
        <translation>Incertidumbre típica de las coordenadas de los puntos según y del sistema base b.</translation>
    </message>
    <message>
        <source>u_y is common</source>
        <translation>u_y es común</translation>
    </message>
    <message>
        <source>One and the same deviation along y for all base points, instead of independent ones.</source>
        <translation>Una misma desviación según y para todos los puntos de la base, en lugar de desviaciones independientes.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along z of the base frame b.</source>
        <translation>Incertidumbre típica de las coordenadas de los puntos según z del sistema base b.</translation>
    </message>
    <message>
        <source>u_z is common</source>
        <translation>u_z es común</translation>
    </message>
    <message>
        <source>One and the same deviation along z for all base points, instead of independent ones.</source>
        <translation>Una misma desviación según z para todos los puntos de la base, en lugar de desviaciones independientes.</translation>
    </message>
    <message>
        <source>Their distribution</source>
        <translation>Su distribución</translation>
    </message>
    <message>
        <source>The distribution of typed deviations of the points; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation>Distribución de las desviaciones tecleadas de los puntos; lo que se indica es su incertidumbre típica, sea cual sea la forma.</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>rectangular: limits ± √3 u</source>
        <translation>rectangular: límites ± √3 u</translation>
    </message>
    <message>
        <source>triangular: limits ± √6 u</source>
        <translation>triangular: límites ± √6 u</translation>
    </message>
    <message>
        <source>arc sine: limits ± √2 u</source>
        <translation>arcoseno: límites ± √2 u</translation>
    </message>
    <message>
        <source>Artefact or instrument</source>
        <translation>Artefacto o instrumento</translation>
    </message>
    <message>
        <source>Gives the uncertainty of the coordinates of the points of the base frame b.</source>
        <translation>Da la incertidumbre de las coordenadas de los puntos del sistema base b.</translation>
    </message>
    <message>
        <source>Uncertainty: Moving frame</source>
        <translation>Incertidumbre: sistema móvil</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along x of the moving frame p.</source>
        <translation>Incertidumbre típica de las coordenadas de los puntos según x del sistema móvil p.</translation>
    </message>
    <message>
        <source>One and the same deviation along x for all points of the moving frame, in all poses, instead of independent ones.</source>
        <translation>Una misma desviación según x para todos los puntos del sistema móvil, en todas las poses, en lugar de desviaciones independientes.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along y of the moving frame p.</source>
        <translation>Incertidumbre típica de las coordenadas de los puntos según y del sistema móvil p.</translation>
    </message>
    <message>
        <source>One and the same deviation along y for all points of the moving frame, in all poses, instead of independent ones.</source>
        <translation>Una misma desviación según y para todos los puntos del sistema móvil, en todas las poses, en lugar de desviaciones independientes.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along z of the moving frame p.</source>
        <translation>Incertidumbre típica de las coordenadas de los puntos según z del sistema móvil p.</translation>
    </message>
    <message>
        <source>One and the same deviation along z for all points of the moving frame, in all poses, instead of independent ones.</source>
        <translation>Una misma desviación según z para todos los puntos del sistema móvil, en todas las poses, en lugar de desviaciones independientes.</translation>
    </message>
    <message>
        <source>Gives the uncertainty of the coordinates of the points of the moving frame p.</source>
        <translation>Da la incertidumbre de las coordenadas de los puntos del sistema móvil p.</translation>
    </message>
    <message>
        <source>Uncertainties along</source>
        <translation>Incertidumbres según</translation>
    </message>
    <message>
        <source>Along which axes the typed uncertainties of the moving points lie: those of the moving frame, which turn with it, or those of the base frame, the same in all poses.</source>
        <translation>Según qué ejes se dan las incertidumbres tecleadas de los puntos móviles: los del sistema móvil, que giran con él, o los del sistema base, iguales en todas las poses.</translation>
    </message>
    <message>
        <source>the axes of the moving frame</source>
        <translation>los ejes del sistema móvil</translation>
    </message>
    <message>
        <source>the axes of the base frame</source>
        <translation>los ejes del sistema base</translation>
    </message>
    <message>
        <source>Points from sensors</source>
        <translation>Puntos a partir de sensores</translation>
    </message>
    <message>
        <source>Network</source>
        <translation>Red</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>Sensores</translation>
    </message>
    <message>
        <source>The instruments of the network, each an instrument of the project that stands somewhere.</source>
        <translation>Los instrumentos de la red, cada uno un instrumento del proyecto que tiene un emplazamiento.</translation>
    </message>
    <message>
        <source>sensor</source>
        <translation>sensor</translation>
    </message>
    <message>
        <source>An instrument of the project.</source>
        <translation>Un instrumento del proyecto.</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Dianas</translation>
    </message>
    <message>
        <source>Points to be localised, at their nominal coordinates.</source>
        <translation>Puntos que se han de localizar, en sus coordenadas nominales.</translation>
    </message>
    <message>
        <source>Name of the target, unique.</source>
        <translation>Nombre de la diana, único.</translation>
    </message>
    <message>
        <source>Nominal coordinate x.</source>
        <translation>Coordenada nominal x.</translation>
    </message>
    <message>
        <source>Nominal coordinate y.</source>
        <translation>Coordenada nominal y.</translation>
    </message>
    <message>
        <source>Nominal coordinate z.</source>
        <translation>Coordenada nominal z.</translation>
    </message>
    <message>
        <source>new set-up</source>
        <translation>nuevo estacionamiento</translation>
    </message>
    <message>
        <source>The sensors were located anew before this target: it and those below share the deviations of the stations with each other, not with the targets above.</source>
        <translation>Los sensores se localizaron de nuevo antes de esta diana: esta y las de abajo comparten entre sí las desviaciones de las estaciones, pero no con las dianas de arriba.</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Distancias</translation>
    </message>
    <message>
        <source>Distances between targets that are measurands too, for instance of a scale bar.</source>
        <translation>Distancias entre dianas que también son mensurandos, por ejemplo de una barra de escala.</translation>
    </message>
    <message>
        <source>from</source>
        <translation>desde</translation>
    </message>
    <message>
        <source>Name of a target.</source>
        <translation>Nombre de una diana.</translation>
    </message>
    <message>
        <source>to</source>
        <translation>hasta</translation>
    </message>
    <message>
        <source>Name of another target.</source>
        <translation>Nombre de otra diana.</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Ángulos</translation>
    </message>
    <message>
        <source>Angles at a target between the directions to two others, measurands too.</source>
        <translation>Ángulos en una diana entre las direcciones a otras dos, también mensurandos.</translation>
    </message>
    <message>
        <source>at</source>
        <translation>en</translation>
    </message>
    <message>
        <source>Name of the target where the angle is.</source>
        <translation>Nombre de la diana donde está el ángulo.</translation>
    </message>
    <message>
        <source>Name of a third target.</source>
        <translation>Nombre de una tercera diana.</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Sistemas</translation>
    </message>
    <message>
        <source>Frames on three targets (3-2-1), whose position and Z-Y-X angles in the world are measurands too.</source>
        <translation>Sistemas definidos por tres dianas (3-2-1), cuya posición y ángulos Z-Y-X en el sistema global también son mensurandos.</translation>
    </message>
    <message>
        <source>Name of the frame, unique.</source>
        <translation>Nombre del sistema, único.</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>origen</translation>
    </message>
    <message>
        <source>Target at its origin.</source>
        <translation>Diana en su origen.</translation>
    </message>
    <message>
        <source>on x</source>
        <translation>en x</translation>
    </message>
    <message>
        <source>Target on its positive x-axis.</source>
        <translation>Diana en su semieje x positivo.</translation>
    </message>
    <message>
        <source>in xy</source>
        <translation>en xy</translation>
    </message>
    <message>
        <source>Target in its xy-plane, at positive y.</source>
        <translation>Diana en su plano xy, con y positiva.</translation>
    </message>
    <message>
        <source>Calibrated lengths</source>
        <translation>Longitudes calibradas</translation>
    </message>
    <message>
        <source>Scale bars and other calibrated distances between two targets: compared with the network, or a constraint of the estimation.</source>
        <translation>Barras de escala y otras distancias calibradas entre dos dianas: se comparan con la red o son una restricción de la estimación.</translation>
    </message>
    <message>
        <source>length</source>
        <translation>longitud</translation>
    </message>
    <message>
        <source>Calibrated length; empty in a design: the distance of the nominal targets.</source>
        <translation>Longitud calibrada; vacío en un diseño: la distancia entre las dianas nominales.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the length as it is during the measurement, with temperature.</source>
        <translation>Incertidumbre típica de la longitud tal como es durante la medición, con la temperatura.</translation>
    </message>
    <message>
        <source>role</source>
        <translation>función</translation>
    </message>
    <message>
        <source>Check: the difference between network and calibration is a measurand. Constraint: the length is adjusted with the readings.</source>
        <translation>Comprobación: la diferencia entre red y calibración es un mensurando. Restricción: la longitud se compensa junto con las lecturas.</translation>
    </message>
    <message>
        <source>check</source>
        <translation>comprobación</translation>
    </message>
    <message>
        <source>constraint</source>
        <translation>restricción</translation>
    </message>
    <message>
        <source>distribution</source>
        <translation>distribución</translation>
    </message>
    <message>
        <source>The distribution that has the standard uncertainty u; empty: normal.</source>
        <translation>Distribución que tiene la incertidumbre típica u; vacío: normal.</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Lecturas</translation>
    </message>
    <message>
        <source>A priori: the readings are those of the nominal targets. A posteriori: the readings are given.</source>
        <translation>A priori: las lecturas son las de las dianas nominales. A posteriori: las lecturas están dadas.</translation>
    </message>
    <message>
        <source>a priori (design: nominal targets)</source>
        <translation>a priori (diseño: dianas nominales)</translation>
    </message>
    <message>
        <source>a posteriori (given readings)</source>
        <translation>a posteriori (lecturas dadas)</translation>
    </message>
    <message>
        <source>What the sensors read, one row for a sensor and a target, typed or from a CSV file; leave empty what was not read.</source>
        <translation>Lo que leen los sensores, una fila por sensor y diana, tecleado o de un archivo CSV; deje vacío lo que no se leyó.</translation>
    </message>
    <message>
        <source>target</source>
        <translation>diana</translation>
    </message>
    <message>
        <source>Name of the target.</source>
        <translation>Nombre de la diana.</translation>
    </message>
    <message>
        <source>The instrument that read it.</source>
        <translation>El instrumento que la leyó.</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>distancia</translation>
    </message>
    <message>
        <source>Slope distance.</source>
        <translation>Distancia inclinada.</translation>
    </message>
    <message>
        <source>azimuth</source>
        <translation>acimut</translation>
    </message>
    <message>
        <source>Horizontal angle from the sensor&apos;s x-axis, positive towards y; whole turns do not matter.</source>
        <translation>Ángulo horizontal desde el eje x del sensor, positivo hacia y; las vueltas completas no importan.</translation>
    </message>
    <message>
        <source>elevation</source>
        <translation>elevación</translation>
    </message>
    <message>
        <source>Vertical angle above the sensor&apos;s xy-plane.</source>
        <translation>Ángulo vertical sobre el plano xy del sensor.</translation>
    </message>
    <message>
        <source>Estimation</source>
        <translation>Estimación</translation>
    </message>
    <message>
        <source>Estimator</source>
        <translation>Estimador</translation>
    </message>
    <message>
        <source>How a target&apos;s coordinates follow from its readings.</source>
        <translation>Cómo se obtienen las coordenadas de una diana a partir de sus lecturas.</translation>
    </message>
    <message>
        <source>non-linear weighted least squares</source>
        <translation>mínimos cuadrados ponderados no lineales</translation>
    </message>
    <message>
        <source>linearised equations: OLS, then GLS (Eqs 1-4 of the paper)</source>
        <translation>linealizadas: OLS, luego GLS (ecs. 1-4 del artículo)</translation>
    </message>
    <message>
        <source>linearised equations: OLS alone (Eq 3 of the paper)</source>
        <translation>ecuaciones linealizadas: solo OLS (ec. 3 del artículo)</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Pesos</translation>
    </message>
    <message>
        <source>What the weights of the equations account for. Weights from the readings alone, as in the paper, are not the best where the stations are uncertain.</source>
        <translation>Qué tienen en cuenta los pesos de las ecuaciones. Los pesos de las lecturas solas, como en el artículo, no son los mejores si las estaciones son inciertas.</translation>
    </message>
    <message>
        <source>readings and stations, all targets of a set-up at once</source>
        <translation>lecturas y estaciones, juntas por estacionamiento</translation>
    </message>
    <message>
        <source>readings alone, each target by itself (the paper)</source>
        <translation>solo lecturas, cada diana por separado (el artículo)</translation>
    </message>
    <message>
        <source>TCP from ballbars</source>
        <translation>TCP con barras de bolas</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Medición</translation>
    </message>
    <message>
        <source>Ballbars</source>
        <translation>Barras de bolas</translation>
    </message>
    <message>
        <source>The set of telescopic ballbars that measures the points.</source>
        <translation>El conjunto de barras de bolas telescópicas que mide los puntos.</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Gives the repeatability with which the robot goes to the points; none: an ideal robot.</source>
        <translation>Da la repetibilidad con la que el robot va a los puntos; ninguno: un robot ideal.</translation>
    </message>
    <message>
        <source>The tool centre point from a planned procedure or from measured points; or only the points as the ballbars measure them.</source>
        <translation>El punto central de la herramienta a partir de un procedimiento planificado o de puntos medidos; o solo los puntos tal como los miden las barras de bolas.</translation>
    </message>
    <message>
        <source>tool centre point, planned procedure</source>
        <translation>punto central de la herramienta, procedimiento planificado</translation>
    </message>
    <message>
        <source>tool centre point, measured points</source>
        <translation>punto central de la herramienta, puntos medidos</translation>
    </message>
    <message>
        <source>points alone</source>
        <translation>solo puntos</translation>
    </message>
    <message>
        <source>Procedure</source>
        <translation>Procedimiento</translation>
    </message>
    <message>
        <source>Flange</source>
        <translation>Brida</translation>
    </message>
    <message>
        <source>Pose of the flange in the robot&apos;s frame before it turns; its origin is the centre of the sphere on which the ball moves.</source>
        <translation>Pose de la brida en el sistema del robot antes de girar; su origen es el centro de la esfera sobre la que se mueve la bola.</translation>
    </message>
    <message>
        <source>Tool x</source>
        <translation>Herramienta x</translation>
    </message>
    <message>
        <source>Nominal coordinate x of the tool centre point in the flange&apos;s frame.</source>
        <translation>Coordenada nominal x del punto central de la herramienta en el sistema de la brida.</translation>
    </message>
    <message>
        <source>Tool y</source>
        <translation>Herramienta y</translation>
    </message>
    <message>
        <source>Nominal coordinate y of the tool centre point in the flange&apos;s frame.</source>
        <translation>Coordenada nominal y del punto central de la herramienta en el sistema de la brida.</translation>
    </message>
    <message>
        <source>Tool z</source>
        <translation>Herramienta z</translation>
    </message>
    <message>
        <source>Nominal coordinate z of the tool centre point in the flange&apos;s frame.</source>
        <translation>Coordenada nominal z del punto central de la herramienta en el sistema de la brida.</translation>
    </message>
    <message>
        <source>Rotations</source>
        <translation>Rotaciones</translation>
    </message>
    <message>
        <source>Two or three rotations of the flange about its own axes, its origin held in place: the ball traces an arc in each.</source>
        <translation>Dos o tres rotaciones de la brida alrededor de sus propios ejes, con el origen fijo: la bola describe un arco en cada una.</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>eje</translation>
    </message>
    <message>
        <source>Axis of the flange about which the robot turns.</source>
        <translation>Eje de la brida alrededor del cual gira el robot.</translation>
    </message>
    <message>
        <source>start</source>
        <translation>inicio</translation>
    </message>
    <message>
        <source>Angle at the first point.</source>
        <translation>Ángulo en el primer punto.</translation>
    </message>
    <message>
        <source>span</source>
        <translation>amplitud</translation>
    </message>
    <message>
        <source>Angle from the first point to the last; negative: turned the other way.</source>
        <translation>Ángulo del primer punto al último; negativo: giro en sentido contrario.</translation>
    </message>
    <message>
        <source>points</source>
        <translation>puntos</translation>
    </message>
    <message>
        <source>Number of points, equally spaced from the first to the last.</source>
        <translation>Número de puntos, equiespaciados del primero al último.</translation>
    </message>
    <message>
        <source>Points as measured, each with the axis of its rotation and the commanded angle, typed or from a CSV file.</source>
        <translation>Puntos medidos, cada uno con el eje de su rotación y el ángulo ordenado, tecleados o de un archivo CSV.</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>ángulo</translation>
    </message>
    <message>
        <source>Commanded angle of rotation.</source>
        <translation>Ángulo de rotación ordenado.</translation>
    </message>
    <message>
        <source>Coordinate x in the frame of the ballbars.</source>
        <translation>Coordenada x en el sistema de las barras de bolas.</translation>
    </message>
    <message>
        <source>Coordinate y in the frame of the ballbars.</source>
        <translation>Coordenada y en el sistema de las barras de bolas.</translation>
    </message>
    <message>
        <source>Coordinate z in the frame of the ballbars.</source>
        <translation>Coordenada z en el sistema de las barras de bolas.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Places of the ball that are measured, typed or from a CSV file.</source>
        <translation>Lugares de la bola que se miden, tecleados o de un archivo CSV.</translation>
    </message>
    <message>
        <source>Name of the point, unique.</source>
        <translation>Nombre del punto, único.</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuste</translation>
    </message>
    <message>
        <source>Axes of the flange</source>
        <translation>Ejes de la brida</translation>
    </message>
    <message>
        <source>Measured axes are not exactly perpendicular: which one is kept as measured. A third measured axis then only helps the sphere and the mean.</source>
        <translation>Los ejes medidos no son exactamente perpendiculares: cuál se mantiene como se midió. Un tercer eje medido solo ayuda entonces a la esfera y a la media.</translation>
    </message>
    <message>
        <source>y as measured, x nearest to measured</source>
        <translation>y como se midió, x lo más cerca posible</translation>
    </message>
    <message>
        <source>x as measured, y nearest to measured</source>
        <translation>x como se midió, y lo más cerca posible</translation>
    </message>
    <message>
        <source>z as measured, x nearest to measured</source>
        <translation>z como se midió, x lo más cerca posible</translation>
    </message>
    <message>
        <source>nearest to all measured axes</source>
        <translation>lo más cerca de todos los ejes medidos</translation>
    </message>
    <message>
        <source>Centre of the flange</source>
        <translation>Centro de la brida</translation>
    </message>
    <message>
        <source>Sphere through all points by linear least squares, or refined to least distances from it.</source>
        <translation>Esfera por todos los puntos por mínimos cuadrados lineales, o refinada a las menores distancias a ella.</translation>
    </message>
    <message>
        <source>sphere, geometric fit from the linear one</source>
        <translation>esfera, ajuste geométrico desde el lineal</translation>
    </message>
    <message>
        <source>sphere, linear fit</source>
        <translation>esfera, ajuste lineal</translation>
    </message>
    <message>
        <source>Robot pose</source>
        <translation>Pose de un robot</translation>
    </message>
    <message>
        <source>The arm, with its parameters and their uncertainty.</source>
        <translation>El brazo, con sus parámetros y la incertidumbre de estos.</translation>
    </message>
    <message>
        <source>Components of a parameter</source>
        <translation>Componentes de un parámetro</translation>
    </message>
    <message>
        <source>Each by itself, so that the budget tells the sources apart; or combined into one normal deviation, which needs fewer draws.</source>
        <translation>Cada una por separado, de modo que el balance distinga las fuentes; o combinadas en una desviación normal, que necesita menos extracciones.</translation>
    </message>
    <message>
        <source>each by itself</source>
        <translation>cada una por separado</translation>
    </message>
    <message>
        <source>combined into one</source>
        <translation>combinadas en una</translation>
    </message>
    <message>
        <source>Correlation of the parameters</source>
        <translation>Correlación de los parámetros</translation>
    </message>
    <message>
        <source>Used as the robot states it; or ignored, as in the paper, to see what that does.</source>
        <translation>Se usa tal como la indica el robot; o se ignora, como en el artículo, para ver qué efecto tiene.</translation>
    </message>
    <message>
        <source>used</source>
        <translation>utilizada</translation>
    </message>
    <message>
        <source>ignored (the paper)</source>
        <translation>ignorada (el artículo)</translation>
    </message>
    <message>
        <source>Poses by joint readings</source>
        <translation>Poses por lecturas articulares</translation>
    </message>
    <message>
        <source>Readings of the joints, typed or from a CSV file. An empty cell is the zero reading of the joint; a robot with fewer joints leaves the last columns empty.</source>
        <translation>Lecturas de las articulaciones, tecleadas o de un archivo CSV. Una celda vacía es la lectura cero de la articulación; un robot con menos articulaciones deja vacías las últimas columnas.</translation>
    </message>
    <message>
        <source>Name of the pose, unique.</source>
        <translation>Nombre de la pose, único.</translation>
    </message>
    <message>
        <source>Reading of joint 1, if it turns.</source>
        <translation>Lectura de la articulación 1, si gira.</translation>
    </message>
    <message>
        <source>Reading of joint 2, if it turns.</source>
        <translation>Lectura de la articulación 2, si gira.</translation>
    </message>
    <message>
        <source>Reading of joint 3, if it turns.</source>
        <translation>Lectura de la articulación 3, si gira.</translation>
    </message>
    <message>
        <source>Reading of joint 4, if it turns.</source>
        <translation>Lectura de la articulación 4, si gira.</translation>
    </message>
    <message>
        <source>Reading of joint 5, if it turns.</source>
        <translation>Lectura de la articulación 5, si gira.</translation>
    </message>
    <message>
        <source>Reading of joint 6, if it turns.</source>
        <translation>Lectura de la articulación 6, si gira.</translation>
    </message>
    <message>
        <source>Reading of joint 7, if it turns.</source>
        <translation>Lectura de la articulación 7, si gira.</translation>
    </message>
    <message>
        <source>Reading of joint 1, if it slides.</source>
        <translation>Lectura de la articulación 1, si desliza.</translation>
    </message>
    <message>
        <source>Reading of joint 2, if it slides.</source>
        <translation>Lectura de la articulación 2, si desliza.</translation>
    </message>
    <message>
        <source>Reading of joint 3, if it slides.</source>
        <translation>Lectura de la articulación 3, si desliza.</translation>
    </message>
    <message>
        <source>Reading of joint 4, if it slides.</source>
        <translation>Lectura de la articulación 4, si desliza.</translation>
    </message>
    <message>
        <source>Reading of joint 5, if it slides.</source>
        <translation>Lectura de la articulación 5, si desliza.</translation>
    </message>
    <message>
        <source>Reading of joint 6, if it slides.</source>
        <translation>Lectura de la articulación 6, si desliza.</translation>
    </message>
    <message>
        <source>Reading of joint 7, if it slides.</source>
        <translation>Lectura de la articulación 7, si desliza.</translation>
    </message>
    <message>
        <source>Poses by place</source>
        <translation>Poses por lugar</translation>
    </message>
    <message>
        <source>Places of the tool in the robot&apos;s base frame; the readings follow by inverse kinematics, within the limits and near those of the pose before.</source>
        <translation>Lugares de la herramienta en el sistema base del robot; las lecturas se obtienen por cinemática inversa, dentro de los límites y cerca de las de la pose anterior.</translation>
    </message>
    <message>
        <source>Name, unique.</source>
        <translation>Nombre, único.</translation>
    </message>
    <message>
        <source>Coordinate x of the tool.</source>
        <translation>Coordenada x de la herramienta.</translation>
    </message>
    <message>
        <source>Coordinate y of the tool.</source>
        <translation>Coordenada y de la herramienta.</translation>
    </message>
    <message>
        <source>Coordinate z of the tool.</source>
        <translation>Coordenada z de la herramienta.</translation>
    </message>
    <message>
        <source>Orientation, R = Rz(gamma) Ry(beta) Rx(alpha); all three empty: any orientation.</source>
        <translation>Orientación, R = Rz(gamma) Ry(beta) Rx(alpha); los tres vacíos: cualquier orientación.</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Resultados</translation>
    </message>
    <message>
        <source>Numbers that state the orientation of the tool; none: the position alone.</source>
        <translation>Números que expresan la orientación de la herramienta; ninguno: solo la posición.</translation>
    </message>
    <message>
        <source>none (position alone)</source>
        <translation>ninguno (solo la posición)</translation>
    </message>
    <message>
        <source>Results in</source>
        <translation>Resultados en</translation>
    </message>
    <message>
        <source>The frame in which position and orientation are stated.</source>
        <translation>Sistema en el que se expresan la posición y la orientación.</translation>
    </message>
    <message>
        <source>the base frame of the robot</source>
        <translation>el sistema base del robot</translation>
    </message>
    <message>
        <source>the world frame</source>
        <translation>el sistema global</translation>
    </message>
    <message>
        <source>Robot by joint trajectories</source>
        <translation>Robot por trayectorias articulares</translation>
    </message>
    <message>
        <source>Nominal robot</source>
        <translation>Robot nominal</translation>
    </message>
    <message>
        <source>The arm as designed: directions of the frames, definitions of base and last link, and the arm of a simulation.</source>
        <translation>El brazo según su diseño: direcciones de los sistemas, definiciones de la base y del último eslabón, y el brazo de una simulación.</translation>
    </message>
    <message>
        <source>Points are</source>
        <translation>Origen de los puntos</translation>
    </message>
    <message>
        <source>Measured: a table. Simulated: those of the nominal robot, to see what an experiment would give.</source>
        <translation>Medición: una tabla. Simulación: los del robot nominal, para ver qué daría un experimento.</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>medición</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>simulación</translation>
    </message>
    <message>
        <source>Points of the ball at the flange in the order in which they were measured, joint by joint, in the frame of the instrument&apos;s world; typed or from a CSV file.</source>
        <translation>Puntos de la bola en la brida en el orden en que se midieron, articulación por articulación, en el sistema global del instrumento; tecleados o de un archivo CSV.</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>articulación</translation>
    </message>
    <message>
        <source>Number of the joint that turned.</source>
        <translation>Número de la articulación que giró.</translation>
    </message>
    <message>
        <source>Reading of that joint; says which way round the points run. Empty: with the joint&apos;s positive direction.</source>
        <translation>Lectura de esa articulación; indica en qué sentido se recorren los puntos. Vacío: en el sentido positivo de la articulación.</translation>
    </message>
    <message>
        <source>Coordinate x.</source>
        <translation>Coordenada x.</translation>
    </message>
    <message>
        <source>Coordinate y.</source>
        <translation>Coordenada y.</translation>
    </message>
    <message>
        <source>Coordinate z.</source>
        <translation>Coordenada z.</translation>
    </message>
    <message>
        <source>Range of each joint, ±</source>
        <translation>Intervalo de cada articulación, ±</translation>
    </message>
    <message>
        <source>Each joint turns from its zero reading less this to its zero reading plus this.</source>
        <translation>Cada articulación gira desde su lectura cero menos esto hasta su lectura cero más esto.</translation>
    </message>
    <message>
        <source>Points for each joint</source>
        <translation>Puntos por articulación</translation>
    </message>
    <message>
        <source>Number of points, evenly spaced over the range.</source>
        <translation>Número de puntos, equiespaciados en el intervalo.</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Bola</translation>
    </message>
    <message>
        <source>Where the ball is in the frame of the last link. On the axis of a joint it draws no circle.</source>
        <translation>Dónde está la bola en el sistema del último eslabón. Sobre el eje de una articulación no describe ningún círculo.</translation>
    </message>
    <message>
        <source>A standard uncertainty of every coordinate, or an instrument of the project that stands somewhere.</source>
        <translation>Una incertidumbre típica de cada coordenada, o un instrumento del proyecto que tiene un emplazamiento.</translation>
    </message>
    <message>
        <source>typed: alike for all coordinates</source>
        <translation>tecleada: igual para todas las coordenadas</translation>
    </message>
    <message>
        <source>an instrument</source>
        <translation>un instrumento</translation>
    </message>
    <message>
        <source>Standard uncertainty of a coordinate</source>
        <translation>Incertidumbre típica de una coordenada</translation>
    </message>
    <message>
        <source>Of every coordinate of every point, independent of all others.</source>
        <translation>De cada coordenada de cada punto, independiente de todas las demás.</translation>
    </message>
    <message>
        <source>The distribution of the coordinates&apos; deviations; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation>Distribución de las desviaciones de las coordenadas; lo que se indica es su incertidumbre típica, sea cual sea la forma.</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>Instrumento</translation>
    </message>
    <message>
        <source>What measured the points: each reading deviates by itself, its scale and its station alike for all points.</source>
        <translation>Lo que midió los puntos: cada lectura se desvía por sí misma; su escala y su estación, igual para todos los puntos.</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>Plane of a circle</source>
        <translation>Plano de un círculo</translation>
    </message>
    <message>
        <source>Total least squares fits any plane. Eq 1 of the paper has no plane through the origin and fails near it.</source>
        <translation>Los mínimos cuadrados totales se ajustan a cualquier plano. La ec. 1 del artículo no admite planos por el origen y falla cerca de él.</translation>
    </message>
    <message>
        <source>total least squares</source>
        <translation>mínimos cuadrados totales</translation>
    </message>
    <message>
        <source>A x + B y + C z + 1 = 0 (Eq 1)</source>
        <translation>A x + B y + C z + 1 = 0 (ec. 1)</translation>
    </message>
    <message>
        <source>Axes are parallel below</source>
        <translation>Ejes paralelos por debajo de</translation>
    </message>
    <message>
        <source>Angle between two axes below which they are described by beta and not by their common perpendicular, whose place is then hardly determined.</source>
        <translation>Ángulo entre dos ejes por debajo del cual se describen con beta y no con su perpendicular común, cuyo lugar apenas queda determinado.</translation>
    </message>
    <message>
        <source>Robot from measured poses</source>
        <translation>Robot a partir de poses medidas</translation>
    </message>
    <message>
        <source>The arm as designed: start of the fit, values of what the poses cannot tell, uncertainty of the readings of its joints, and the arm of a simulation.</source>
        <translation>El brazo según su diseño: inicio del ajuste, valores de lo que las poses no pueden revelar, incertidumbre de las lecturas de sus articulaciones, y el brazo de una simulación.</translation>
    </message>
    <message>
        <source>Poses are</source>
        <translation>Origen de las poses</translation>
    </message>
    <message>
        <source>Measured is</source>
        <translation>Se mide</translation>
    </message>
    <message>
        <source>The position of a ball alone, or position and orientation of the tool.</source>
        <translation>Solo la posición de una bola, o posición y orientación de la herramienta.</translation>
    </message>
    <message>
        <source>the position</source>
        <translation>la posición</translation>
    </message>
    <message>
        <source>position and orientation</source>
        <translation>posición y orientación</translation>
    </message>
    <message>
        <source>Measured poses</source>
        <translation>Poses medidas</translation>
    </message>
    <message>
        <source>Readings of the joints and the place of the ball or tool that was measured there; typed or from a CSV file.</source>
        <translation>Lecturas de las articulaciones y el lugar de la bola o de la herramienta que se midió con ellas; tecleado o de un archivo CSV.</translation>
    </message>
    <message>
        <source>use</source>
        <translation>uso</translation>
    </message>
    <message>
        <source>fit: taken into the fit. check: held back, to see how well the fit tells a pose that it has not seen. Empty: fit.</source>
        <translation>ajuste: entra en el ajuste. comprobación: se reserva, para ver con qué acierto predice el ajuste una pose que no ha visto. Vacío: ajuste.</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>ajuste</translation>
    </message>
    <message>
        <source>Reading of joint 1; empty: its zero reading.</source>
        <translation>Lectura de la articulación 1; vacío: su lectura cero.</translation>
    </message>
    <message>
        <source>Reading of joint 2; empty: its zero reading.</source>
        <translation>Lectura de la articulación 2; vacío: su lectura cero.</translation>
    </message>
    <message>
        <source>Reading of joint 3; empty: its zero reading.</source>
        <translation>Lectura de la articulación 3; vacío: su lectura cero.</translation>
    </message>
    <message>
        <source>Reading of joint 4; empty: its zero reading.</source>
        <translation>Lectura de la articulación 4; vacío: su lectura cero.</translation>
    </message>
    <message>
        <source>Reading of joint 5; empty: its zero reading.</source>
        <translation>Lectura de la articulación 5; vacío: su lectura cero.</translation>
    </message>
    <message>
        <source>Reading of joint 6; empty: its zero reading.</source>
        <translation>Lectura de la articulación 6; vacío: su lectura cero.</translation>
    </message>
    <message>
        <source>Reading of joint 7; empty: its zero reading.</source>
        <translation>Lectura de la articulación 7; vacío: su lectura cero.</translation>
    </message>
    <message>
        <source>Measured coordinate x in the frame of the instrument&apos;s world.</source>
        <translation>Coordenada medida x en el sistema global del instrumento.</translation>
    </message>
    <message>
        <source>Measured coordinate y in the frame of the instrument&apos;s world.</source>
        <translation>Coordenada medida y en el sistema global del instrumento.</translation>
    </message>
    <message>
        <source>Measured coordinate z in the frame of the instrument&apos;s world.</source>
        <translation>Coordenada medida z en el sistema global del instrumento.</translation>
    </message>
    <message>
        <source>Measured orientation, R = Rz(gamma) Ry(beta) Rx(alpha), where poses are measured.</source>
        <translation>Orientación medida, R = Rz(gamma) Ry(beta) Rx(alpha), cuando se miden poses.</translation>
    </message>
    <message>
        <source>Number of poses</source>
        <translation>Número de poses</translation>
    </message>
    <message>
        <source>Poses of the simulated experiment, spread over the range of all joints, always the same.</source>
        <translation>Poses del experimento simulado, repartidas por el intervalo de todas las articulaciones, siempre las mismas.</translation>
    </message>
    <message>
        <source>From the zero reading on, as far as the limits of the joint allow.</source>
        <translation>Desde la lectura cero, hasta donde lo permiten los límites de la articulación.</translation>
    </message>
    <message>
        <source>Standard uncertainty of an orientation</source>
        <translation>Incertidumbre típica de una orientación</translation>
    </message>
    <message>
        <source>Of the rotation of the measured tool about each of its axes, independent.</source>
        <translation>De la rotación de la herramienta medida alrededor de cada uno de sus ejes, independientes.</translation>
    </message>
    <message>
        <source>Ball or tool</source>
        <translation>Bola o herramienta</translation>
    </message>
    <message>
        <source>Where it is in the frame of the last link: exactly, or as a start of the fit.</source>
        <translation>Dónde está en el sistema del último eslabón: exactamente, o como inicio del ajuste.</translation>
    </message>
    <message>
        <source>Place of the ball or tool is</source>
        <translation>Lugar de la bola o herramienta</translation>
    </message>
    <message>
        <source>Found by the fit together with the parameters, or known.</source>
        <translation>Hallado en el ajuste junto con los parámetros, o conocido.</translation>
    </message>
    <message>
        <source>found by the fit</source>
        <translation>hallado en el ajuste</translation>
    </message>
    <message>
        <source>known exactly</source>
        <translation>conocido exactamente</translation>
    </message>
    <message>
        <source>Place of the base is</source>
        <translation>Lugar de la base</translation>
    </message>
    <message>
        <source>Found by the fit: the instrument stands anywhere. Known: the base stands where the robot says it stands in the world.</source>
        <translation>Hallado en el ajuste: el instrumento está en cualquier sitio. Conocido: la base está donde el robot indica que está en el sistema global.</translation>
    </message>
    <message>
        <source>Parameters held</source>
        <translation>Parámetros fijados</translation>
    </message>
    <message>
        <source>Parameters that stay nominal although the poses could tell them.</source>
        <translation>Parámetros que siguen siendo nominales aunque las poses podrían revelarlos.</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>parámetro</translation>
    </message>
    <message>
        <source>A parameter by its symbol, such as d_3 or alpha_4.</source>
        <translation>Un parámetro por su símbolo, como d_3 o alpha_4.</translation>
    </message>
    <message>
        <source>Channels of a force/moment sensor</source>
        <translation>Canales de un sensor de fuerza/momento</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>The calibrated multi-axis sensor.</source>
        <translation>El sensor multieje calibrado.</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Uso</translation>
    </message>
    <message>
        <source>Loads on the other axes</source>
        <translation>Cargas en los otros ejes</translation>
    </message>
    <message>
        <source>What acts on the other axes while a channel is read. Unknown loads are rectangular between minus and plus the rated load, one and the same for all channels.</source>
        <translation>Lo que actúa en los otros ejes mientras se lee un canal. Las cargas desconocidas son rectangulares entre menos y más la carga nominal, las mismas para todos los canales.</translation>
    </message>
    <message>
        <source>none: one component alone</source>
        <translation>ninguna: una sola componente</translation>
    </message>
    <message>
        <source>unknown on one axis, that with the largest interference</source>
        <translation>desconocida en un eje, el de mayor interferencia</translation>
    </message>
    <message>
        <source>unknown on all other axes</source>
        <translation>desconocida en todos los otros ejes</translation>
    </message>
    <message>
        <source>Repeatability</source>
        <translation>Repetibilidad</translation>
    </message>
    <message>
        <source>The largest standard deviation of all steps, as in the paper, or that pooled over the steps, which has more degrees of freedom.</source>
        <translation>La mayor desviación típica de todos los escalones, como en el artículo, o la combinada de los escalones, que tiene más grados de libertad.</translation>
    </message>
    <message>
        <source>largest of the steps</source>
        <translation>la mayor de los escalones</translation>
    </message>
    <message>
        <source>pooled over the steps</source>
        <translation>combinada de los escalones</translation>
    </message>
    <message>
        <source>Type A in Monte Carlo</source>
        <translation>Tipo A en Monte Carlo</translation>
    </message>
    <message>
        <source>Normal, with its degrees of freedom in the law of propagation, or a t-distribution (JCGM 101 6.4.9). With n = 3 the latter has no standard deviation: only coverage intervals then mean something.</source>
        <translation>Normal, con sus grados de libertad en la ley de propagación, o una distribución t (JCGM 101 6.4.9). Con n = 3 esta no tiene desviación típica: solo los intervalos de cobertura significan entonces algo.</translation>
    </message>
    <message>
        <source>scaled and shifted t</source>
        <translation>t escalada y desplazada</translation>
    </message>
    <message>
        <source>Coverage factor of the comparison</source>
        <translation>Factor de cobertura de la comparación</translation>
    </message>
    <message>
        <source>k of the GUM&apos;s columns in the table beside the paper&apos;s.</source>
        <translation>k de las columnas de la GUM en la tabla, junto a las del artículo.</translation>
    </message>
    <message>
        <source>Forces and moments by the calibration matrix</source>
        <translation>Fuerzas y momentos por la matriz de calibración</translation>
    </message>
    <message>
        <source>Cases</source>
        <translation>Casos</translation>
    </message>
    <message>
        <source>Cases are given by</source>
        <translation>Casos dados por</translation>
    </message>
    <message>
        <source>Readings that were taken, or loads whose uncertainty is wanted.</source>
        <translation>Lecturas que se tomaron, o cargas cuya incertidumbre se busca.</translation>
    </message>
    <message>
        <source>readings</source>
        <translation>lecturas</translation>
    </message>
    <message>
        <source>loads</source>
        <translation>cargas</translation>
    </message>
    <message>
        <source>Net readings of all channels, the unloaded readings subtracted.</source>
        <translation>Lecturas netas de todos los canales, restadas las lecturas sin carga.</translation>
    </message>
    <message>
        <source>Names the case in results.</source>
        <translation>Nombra el caso en los resultados.</translation>
    </message>
    <message>
        <source>Fx</source>
        <translation>Fx</translation>
    </message>
    <message>
        <source>Net reading of this channel.</source>
        <translation>Lectura neta de este canal.</translation>
    </message>
    <message>
        <source>Fy</source>
        <translation>Fy</translation>
    </message>
    <message>
        <source>Fz</source>
        <translation>Fz</translation>
    </message>
    <message>
        <source>Mx</source>
        <translation>Mx</translation>
    </message>
    <message>
        <source>My</source>
        <translation>My</translation>
    </message>
    <message>
        <source>Mz</source>
        <translation>Mz</translation>
    </message>
    <message>
        <source>Loads</source>
        <translation>Cargas</translation>
    </message>
    <message>
        <source>Forces and moments that act together; the readings follow from the calibration matrix. An empty cell is zero.</source>
        <translation>Fuerzas y momentos que actúan juntos; las lecturas se obtienen de la matriz de calibración. Una celda vacía es cero.</translation>
    </message>
    <message>
        <source>Load on this axis.</source>
        <translation>Carga en este eje.</translation>
    </message>
    <message>
        <source>Calibration matrix</source>
        <translation>Matriz de calibración</translation>
    </message>
    <message>
        <source>Least squares through zero over the increasing readings: slopes alone, or with the squares of the loads.</source>
        <translation>Mínimos cuadrados por cero con las lecturas crecientes: solo pendientes, o también con los cuadrados de las cargas.</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>lineal</translation>
    </message>
    <message>
        <source>with quadratic terms</source>
        <translation>con términos cuadráticos</translation>
    </message>
    <message>
        <source>Repeatability of a reading</source>
        <translation>Repetibilidad de una lectura</translation>
    </message>
    <message>
        <source>The largest standard deviation of all steps, or that pooled over the steps.</source>
        <translation>La mayor desviación típica de todos los escalones, o la combinada de los escalones.</translation>
    </message>
    <message>
        <source>Normal, with its degrees of freedom in the law of propagation, or a t-distribution (JCGM 101 6.4.9), which has no standard deviation with n = 3.</source>
        <translation>Normal, con sus grados de libertad en la ley de propagación, o una distribución t (JCGM 101 6.4.9), que con n = 3 no tiene desviación típica.</translation>
    </message>
    <message>
        <source>Hysteresis of a reading</source>
        <translation>Histéresis de una lectura</translation>
    </message>
    <message>
        <source>Rectangular over the width of the loop: in proportion to the load on the channel&apos;s axis, or the full width at any load.</source>
        <translation>Rectangular sobre la anchura del ciclo: proporcional a la carga en el eje del canal, o la anchura completa con cualquier carga.</translation>
    </message>
    <message>
        <source>in proportion to the load</source>
        <translation>proporcional a la carga</translation>
    </message>
    <message>
        <source>full at any load</source>
        <translation>completa con cualquier carga</translation>
    </message>
    <message>
        <source>Measurement equation</source>
        <translation>Ecuación de medida</translation>
    </message>
    <message>
        <source>Equations</source>
        <translation>Ecuaciones</translation>
    </message>
    <message>
        <source>symbol</source>
        <translation>símbolo</translation>
    </message>
    <message>
        <source>Name that an equation defines.</source>
        <translation>Nombre que define una ecuación.</translation>
    </message>
    <message>
        <source>What it is, for tables and reports.</source>
        <translation>Qué es, para tablas e informes.</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>unidad</translation>
    </message>
    <message>
        <source>Unit of the result; empty: the SI unit that follows from the equations.</source>
        <translation>Unidad del resultado; vacío: la unidad SI que resulta de las ecuaciones.</translation>
    </message>
    <message>
        <source>Measurands have coverage regions together; empty: measurand.</source>
        <translation>Los mensurandos tienen regiones de cobertura conjuntas; vacío: mensurando.</translation>
    </message>
    <message>
        <source>measurand</source>
        <translation>mensurando</translation>
    </message>
    <message>
        <source>intermediate</source>
        <translation>intermedia</translation>
    </message>
    <message>
        <source>group</source>
        <translation>grupo</translation>
    </message>
    <message>
        <source>Results of one group have a joint coverage region.</source>
        <translation>Los resultados de un grupo tienen una región de cobertura conjunta.</translation>
    </message>
    <message>
        <source>Quantities</source>
        <translation>Magnitudes</translation>
    </message>
    <message>
        <source>One row for each component of uncertainty. The first row of a symbol has its value and unit; further rows of the same symbol add components and have no value.</source>
        <translation>Una fila por cada componente de incertidumbre. La primera fila de un símbolo lleva su valor y su unidad; las demás filas del mismo símbolo añaden componentes y no llevan valor.</translation>
    </message>
    <message>
        <source>Name that the equations use: x_1, alpha_s.</source>
        <translation>Nombre que usan las ecuaciones: x_1, alpha_s.</translation>
    </message>
    <message>
        <source>What it is, or what the component is.</source>
        <translation>Qué es, o qué es la componente.</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valor</translation>
    </message>
    <message>
        <source>Estimate, in the row&apos;s unit; empty where observations or limits give it.</source>
        <translation>Estimación, en la unidad de la fila; vacío si la dan observaciones o límites.</translation>
    </message>
    <message>
        <source>stated as</source>
        <translation>indicada como</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>constante</translation>
    </message>
    <message>
        <source>standard uncertainty</source>
        <translation>incertidumbre típica</translation>
    </message>
    <message>
        <source>certificate, U and k</source>
        <translation>certificado, U y k</translation>
    </message>
    <message>
        <source>certificate, U and p</source>
        <translation>certificado, U y p</translation>
    </message>
    <message>
        <source>rectangular</source>
        <translation>rectangular</translation>
    </message>
    <message>
        <source>limits from a to b</source>
        <translation>límites de a a b</translation>
    </message>
    <message>
        <source>limits inexactly known</source>
        <translation>límites conocidos con inexactitud</translation>
    </message>
    <message>
        <source>trapezoidal</source>
        <translation>trapezoidal</translation>
    </message>
    <message>
        <source>triangular</source>
        <translation>triangular</translation>
    </message>
    <message>
        <source>arc sine</source>
        <translation>arcoseno</translation>
    </message>
    <message>
        <source>resolution</source>
        <translation>resolución</translation>
    </message>
    <message>
        <source>maximum permissible error</source>
        <translation>error máximo permitido</translation>
    </message>
    <message>
        <source>exponential</source>
        <translation>exponencial</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>recuentos</translation>
    </message>
    <message>
        <source>observations (Type A)</source>
        <translation>observaciones (Tipo A)</translation>
    </message>
    <message>
        <source>pooled observations (Type A)</source>
        <translation>observaciones combinadas (Tipo A)</translation>
    </message>
    <message>
        <source>reading of an instrument</source>
        <translation>lectura de un instrumento</translation>
    </message>
    <message>
        <source>Second figure of the statement.</source>
        <translation>Segunda cifra de la indicación.</translation>
    </message>
    <message>
        <source>Degrees of freedom; empty: infinite, or those of the observations.</source>
        <translation>Grados de libertad; vacío: infinitos, o los de las observaciones.</translation>
    </message>
    <message>
        <source>Relative uncertainty of u instead of degrees of freedom (JCGM 100 G.3).</source>
        <translation>Incertidumbre relativa de u en lugar de grados de libertad (JCGM 100 G.3).</translation>
    </message>
    <message>
        <source>source</source>
        <translation>fuente</translation>
    </message>
    <message>
        <source>Where the figure comes from: certificate, data sheet, handbook.</source>
        <translation>De dónde procede la cifra: certificado, hoja de datos, manual.</translation>
    </message>
    <message>
        <source>instrument</source>
        <translation>instrumento</translation>
    </message>
    <message>
        <source>Instrument of the project that reads the quantity, a distance.</source>
        <translation>Instrumento del proyecto que lee la magnitud, una distancia.</translation>
    </message>
    <message>
        <source>Observations</source>
        <translation>Observaciones</translation>
    </message>
    <message>
        <source>Repeated observations for Type A evaluations, typed, pasted or from a CSV file. Observations of several quantities with the same numbers were made together: their means are then correlated (JCGM 100 5.2.3).</source>
        <translation>Observaciones repetidas para evaluaciones de Tipo A, tecleadas, pegadas o de un archivo CSV. Las observaciones de varias magnitudes con los mismos números se hicieron a la vez: sus medias están entonces correlacionadas (JCGM 100 5.2.3).</translation>
    </message>
    <message>
        <source>quantity</source>
        <translation>magnitud</translation>
    </message>
    <message>
        <source>Symbol of the quantity.</source>
        <translation>Símbolo de la magnitud.</translation>
    </message>
    <message>
        <source>number</source>
        <translation>número</translation>
    </message>
    <message>
        <source>Number of the simultaneous observation; empty: the quantity was observed by itself.</source>
        <translation>Número de la observación simultánea; vacío: la magnitud se observó por separado.</translation>
    </message>
    <message>
        <source>series</source>
        <translation>serie</translation>
    </message>
    <message>
        <source>Name of an earlier series of the same procedure, for a pooled standard deviation.</source>
        <translation>Nombre de una serie anterior del mismo procedimiento, para una desviación típica combinada.</translation>
    </message>
    <message>
        <source>Observed value, in the unit of the quantity.</source>
        <translation>Valor observado, en la unidad de la magnitud.</translation>
    </message>
    <message>
        <source>Means of observations</source>
        <translation>Medias de observaciones</translation>
    </message>
    <message>
        <source>Distribution of a mean in Monte Carlo trials: Student t with the degrees of freedom of the observations (JCGM 101 6.4.9), or normal.</source>
        <translation>Distribución de una media en las pruebas de Monte Carlo: t de Student con los grados de libertad de las observaciones (JCGM 101 6.4.9), o normal.</translation>
    </message>
    <message>
        <source>Student t</source>
        <translation>t de Student</translation>
    </message>
    <message>
        <source>Calibration curve</source>
        <translation>Curva de calibración</translation>
    </message>
    <message>
        <source>Unit of x</source>
        <translation>Unidad de x</translation>
    </message>
    <message>
        <source>Unit in which x is given. A difference of temperatures, a correction of a thermometer too, is given in K.</source>
        <translation>Unidad en la que se da x. Una diferencia de temperaturas, también la corrección de un termómetro, se da en K.</translation>
    </message>
    <message>
        <source>Unit of y</source>
        <translation>Unidad de y</translation>
    </message>
    <message>
        <source>Unit in which y is given. A difference of temperatures, a correction of a thermometer too, is given in K.</source>
        <translation>Unidad en la que se da y. Una diferencia de temperaturas, también la corrección de un termómetro, se da en K.</translation>
    </message>
    <message>
        <source>Points of the calibration, typed, pasted or from a CSV file.</source>
        <translation>Puntos de la calibración, tecleados, pegados o de un archivo CSV.</translation>
    </message>
    <message>
        <source>Independent quantity, in its unit.</source>
        <translation>Magnitud independiente, en su unidad.</translation>
    </message>
    <message>
        <source>Standard uncertainty of x; empty: none. Used with stated uncertainties.</source>
        <translation>Incertidumbre típica de x; vacío: ninguna. Se usa con incertidumbres indicadas.</translation>
    </message>
    <message>
        <source>Observed quantity, in its unit.</source>
        <translation>Magnitud observada, en su unidad.</translation>
    </message>
    <message>
        <source>Standard uncertainty of y. Used, and needed, with stated uncertainties.</source>
        <translation>Incertidumbre típica de y. Se usa, y es necesaria, con incertidumbres indicadas.</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Curva</translation>
    </message>
    <message>
        <source>Degree</source>
        <translation>Grado</translation>
    </message>
    <message>
        <source>Of the polynomial: 1 is a straight line.</source>
        <translation>Del polinomio: 1 es una recta.</translation>
    </message>
    <message>
        <source>Origin x_0</source>
        <translation>Origen x_0</translation>
    </message>
    <message>
        <source>The polynomial is one of x - x_0, in the unit of x. In the middle of the points the coefficients are hardly correlated.</source>
        <translation>El polinomio lo es en x - x_0, en la unidad de x. En el centro de los puntos los coeficientes apenas están correlacionados.</translation>
    </message>
    <message>
        <source>Through the origin</source>
        <translation>Por el origen</translation>
    </message>
    <message>
        <source>No constant term: the curve is zero at x_0.</source>
        <translation>Sin término constante: la curva es cero en x_0.</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Incertidumbre</translation>
    </message>
    <message>
        <source>From the scatter of the residuals about the curve (JCGM 100 H.3), or as stated for each point.</source>
        <translation>De la dispersión de los residuos en torno a la curva (JCGM 100 H.3), o la indicada para cada punto.</translation>
    </message>
    <message>
        <source>from the residuals</source>
        <translation>de los residuos</translation>
    </message>
    <message>
        <source>as stated for x and y</source>
        <translation>la indicada para x e y</translation>
    </message>
    <message>
        <source>Use of the curve</source>
        <translation>Uso de la curva</translation>
    </message>
    <message>
        <source>Where the value of the curve is wanted, with its uncertainty.</source>
        <translation>Dónde se busca el valor de la curva, con su incertidumbre.</translation>
    </message>
    <message>
        <source>In the unit of x.</source>
        <translation>En la unidad de x.</translation>
    </message>
    <message>
        <source>Inverse use</source>
        <translation>Uso inverso</translation>
    </message>
    <message>
        <source>Observed values of y whose x is wanted, with its uncertainty.</source>
        <translation>Valores observados de y cuya x se busca, con su incertidumbre.</translation>
    </message>
    <message>
        <source>Observed, in the unit of y.</source>
        <translation>Observado, en la unidad de y.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the observed y; empty: none beside that of the readings.</source>
        <translation>Incertidumbre típica de la y observada; vacío: ninguna aparte de la de las lecturas.</translation>
    </message>
    <message>
        <source>The observed y is the mean of so many readings, which scatter as the points of the calibration do. With the uncertainty from the residuals only.</source>
        <translation>La y observada es la media de este número de lecturas, que se dispersan como los puntos de la calibración. Solo con la incertidumbre de los residuos.</translation>
    </message>
    <message>
        <source>near</source>
        <translation>cerca de</translation>
    </message>
    <message>
        <source>Of several x that give this y, the one nearest to here, in the unit of x. Needed where the curve reaches y more than once between its points.</source>
        <translation>De varias x que dan esta y, la más cercana a este valor, en la unidad de x. Necesario si la curva alcanza y más de una vez entre sus puntos.</translation>
    </message>
    <message>
        <source>Observations in groups</source>
        <translation>Observaciones en grupos</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Magnitud</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>Símbolo</translation>
    </message>
    <message>
        <source>Of the measured quantity.</source>
        <translation>De la magnitud medida.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>What is measured.</source>
        <translation>Lo que se mide.</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>In which the observations are given.</source>
        <translation>En la que se dan las observaciones.</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Datos</translation>
    </message>
    <message>
        <source>Every observation, or mean and standard deviation of each group.</source>
        <translation>Todas las observaciones, o media y desviación típica de cada grupo.</translation>
    </message>
    <message>
        <source>observations</source>
        <translation>observaciones</translation>
    </message>
    <message>
        <source>means and standard deviations</source>
        <translation>medias y desviaciones típicas</translation>
    </message>
    <message>
        <source>Observations with the day, instrument or operator they belong to, typed, pasted or from a CSV file.</source>
        <translation>Observaciones con el día, instrumento u operador al que pertenecen, tecleadas, pegadas o de un archivo CSV.</translation>
    </message>
    <message>
        <source>Day, instrument or operator.</source>
        <translation>Día, instrumento u operador.</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Grupos</translation>
    </message>
    <message>
        <source>Mean and experimental standard deviation of the observations of each group.</source>
        <translation>Media y desviación típica experimental de las observaciones de cada grupo.</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>media</translation>
    </message>
    <message>
        <source>Of the observations of the group, in the unit of the quantity.</source>
        <translation>De las observaciones del grupo, en la unidad de la magnitud.</translation>
    </message>
    <message>
        <source>Experimental standard deviation of a single observation of the group.</source>
        <translation>Desviación típica experimental de una sola observación del grupo.</translation>
    </message>
    <message>
        <source>Number of observations in the group; empty: observations per group, as below.</source>
        <translation>Número de observaciones del grupo; vacío: observaciones por grupo, como abajo.</translation>
    </message>
    <message>
        <source>Observations per group</source>
        <translation>Observaciones por grupo</translation>
    </message>
    <message>
        <source>Number of observations in each group whose row does not say it.</source>
        <translation>Número de observaciones de cada grupo cuya fila no lo indica.</translation>
    </message>
    <message>
        <source>Effect of the groups</source>
        <translation>Efecto de los grupos</translation>
    </message>
    <message>
        <source>Included: u of the mean of the groups&apos; means from their scatter. By components of variance: the same for groups of one size, else groups with more observations have more weight. Not included: all observations count as independent, which the F-test in the evaluation must allow.</source>
        <translation>Incluido: u de la media de las medias de los grupos a partir de su dispersión. Por componentes de varianza: lo mismo para grupos de igual tamaño; si no, los grupos con más observaciones tienen más peso. No incluido: todas las observaciones cuentan como independientes, lo que la prueba F de la evaluación debe permitir.</translation>
    </message>
    <message>
        <source>included</source>
        <translation>incluido</translation>
    </message>
    <message>
        <source>by components of variance</source>
        <translation>por componentes de varianza</translation>
    </message>
    <message>
        <source>not included</source>
        <translation>no incluido</translation>
    </message>
    <message>
        <source>Artefact with calibrated points</source>
        <translation>Artefacto con puntos calibrados</translation>
    </message>
    <message>
        <source>Artefact</source>
        <translation>Artefacto</translation>
    </message>
    <message>
        <source>Calibrated points</source>
        <translation>Puntos calibrados</translation>
    </message>
    <message>
        <source>The artefact&apos;s points with their calibrated coordinates in the artefact&apos;s frame.</source>
        <translation>Los puntos del artefacto con sus coordenadas calibradas en el sistema del artefacto.</translation>
    </message>
    <message>
        <source>Calibrated coordinate x.</source>
        <translation>Coordenada calibrada x.</translation>
    </message>
    <message>
        <source>Calibrated coordinate y.</source>
        <translation>Coordenada calibrada y.</translation>
    </message>
    <message>
        <source>Calibrated coordinate z.</source>
        <translation>Coordenada calibrada z.</translation>
    </message>
    <message>
        <source>defines</source>
        <translation>define</translation>
    </message>
    <message>
        <source>Coordinates that define the frame (&quot;xyz&quot;, &quot;yz&quot;), when they are named by point.</source>
        <translation>Coordenadas que definen el sistema (&quot;xyz&quot;, &quot;yz&quot;), cuando se nombran por punto.</translation>
    </message>
    <message>
        <source>Evaluate from</source>
        <translation>Evaluar a partir de</translation>
    </message>
    <message>
        <source>Repeated measurements of the artefact, or the components of uncertainty as a report prints them (Table 1 of the paper).</source>
        <translation>Mediciones repetidas del artefacto, o las componentes de incertidumbre tal como las imprime un informe (tabla 1 del artículo).</translation>
    </message>
    <message>
        <source>components of uncertainty</source>
        <translation>componentes de incertidumbre</translation>
    </message>
    <message>
        <source>Measured coordinates in the artefact&apos;s frame: one row for each point and run, typed or from a CSV file.</source>
        <translation>Coordenadas medidas en el sistema del artefacto: una fila por cada punto y pasada, tecleadas o de un archivo CSV.</translation>
    </message>
    <message>
        <source>Name of a calibrated point.</source>
        <translation>Nombre de un punto calibrado.</translation>
    </message>
    <message>
        <source>run</source>
        <translation>pasada</translation>
    </message>
    <message>
        <source>Indicated coordinate x.</source>
        <translation>Coordenada x indicada.</translation>
    </message>
    <message>
        <source>Indicated coordinate y.</source>
        <translation>Coordenada y indicada.</translation>
    </message>
    <message>
        <source>Indicated coordinate z.</source>
        <translation>Coordenada z indicada.</translation>
    </message>
    <message>
        <source>Components of uncertainty</source>
        <translation>Componentes de incertidumbre</translation>
    </message>
    <message>
        <source>One row for each coordinate, as Table 1 of the paper prints them.</source>
        <translation>Una fila por cada coordenada, como las imprime la tabla 1 del artículo.</translation>
    </message>
    <message>
        <source>coordinate</source>
        <translation>coordenada</translation>
    </message>
    <message>
        <source>Coordinate of the row.</source>
        <translation>Coordenada de la fila.</translation>
    </message>
    <message>
        <source>Calibration.</source>
        <translation>Calibración.</translation>
    </message>
    <message>
        <source>Temperature.</source>
        <translation>Temperatura.</translation>
    </message>
    <message>
        <source>Variability: standard deviation of the errors of indication.</source>
        <translation>Variabilidad: desviación típica de los errores de indicación.</translation>
    </message>
    <message>
        <source>Bias: mean of the errors of indication.</source>
        <translation>Sesgo: media de los errores de indicación.</translation>
    </message>
    <message>
        <source>Number of observations, where it is known; gives the degrees of freedom.</source>
        <translation>Número de observaciones, si se conoce; da los grados de libertad.</translation>
    </message>
    <message>
        <source>Coordinates that define the frame</source>
        <translation>Coordenadas que definen el sistema</translation>
    </message>
    <message>
        <source>Errors of these coordinates are zero by construction of the frame and are left out of the statistics.</source>
        <translation>Los errores de estas coordenadas son cero por construcción del sistema y se excluyen de la estadística.</translation>
    </message>
    <message>
        <source>first point x, y, z; second y, z; third z</source>
        <translation>primer punto x, y, z; segundo y, z; tercero z</translation>
    </message>
    <message>
        <source>as the points&apos; column &apos;defines&apos; says</source>
        <translation>según la columna &apos;define&apos; de los puntos</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>Systematic error of indication</source>
        <translation>Error sistemático de indicación</translation>
    </message>
    <message>
        <source>What becomes of the mean error b. The paper leaves it uncorrected and counts |b| as a standard uncertainty; JCGM 100 3.2.4 asks for a correction.</source>
        <translation>Qué se hace con el error medio b. El artículo lo deja sin corregir y toma |b| como incertidumbre típica; JCGM 100 3.2.4 pide una corrección.</translation>
    </message>
    <message>
        <source>counts as a standard uncertainty (paper)</source>
        <translation>cuenta como incertidumbre típica (artículo)</translation>
    </message>
    <message>
        <source>ignored</source>
        <translation>ignorado</translation>
    </message>
    <message>
        <source>corrected, the uncertainty of the correction remains</source>
        <translation>corregido, queda la incertidumbre de la corrección</translation>
    </message>
    <message>
        <source>Systematic parts are common to all points</source>
        <translation>Partes sistemáticas comunes a todos los puntos</translation>
    </message>
    <message>
        <source>Calibration, temperature and bias are drawn once for all points instead of independently for each, as the paper does.</source>
        <translation>La calibración, la temperatura y el sesgo se extraen una vez para todos los puntos, en lugar de independientemente para cada uno, como hace el artículo.</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Calibración</translation>
    </message>
    <message>
        <source>Standard uncertainty of calibration</source>
        <translation>Incertidumbre típica de calibración</translation>
    </message>
    <message>
        <source>Largest standard uncertainty of the calibrated values, from the certificate (U divided by its k).</source>
        <translation>Mayor incertidumbre típica de los valores calibrados, según el certificado (U dividida por su k).</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatura</translation>
    </message>
    <message>
        <source>Coefficient of thermal expansion</source>
        <translation>Coeficiente de dilatación térmica</translation>
    </message>
    <message>
        <source>Linear expansion of the artefact&apos;s material; aluminium has about 23e-6 1/K.</source>
        <translation>Dilatación lineal del material del artefacto; el aluminio tiene unos 23e-6 1/K.</translation>
    </message>
    <message>
        <source>Temperature of the artefact</source>
        <translation>Temperatura del artefacto</translation>
    </message>
    <message>
        <source>Whether indications are corrected to 20 °C with a measured temperature. If not, the largest deviation from 20 °C is a component of uncertainty.</source>
        <translation>Si las indicaciones se corrigen a 20 °C con una temperatura medida. Si no, la mayor desviación respecto de 20 °C es una componente de incertidumbre.</translation>
    </message>
    <message>
        <source>not corrected</source>
        <translation>sin corrección</translation>
    </message>
    <message>
        <source>corrected to 20 °C</source>
        <translation>con corrección a 20 °C</translation>
    </message>
    <message>
        <source>Largest deviation from 20 °C, or U of the temperature</source>
        <translation>Mayor desviación respecto de 20 °C, o U de la temperatura</translation>
    </message>
    <message>
        <source>ΔT of Eqs 3 and 6: without correction the largest absolute deviation from 20 °C, with correction the expanded uncertainty of the measured temperature. Half-width of a rectangular distribution.</source>
        <translation>ΔT de las ecs. 3 y 6: sin corrección, la mayor desviación absoluta respecto de 20 °C; con corrección, la incertidumbre expandida de la temperatura medida. Semiamplitud de una distribución rectangular.</translation>
    </message>
    <message>
        <source>Measured temperature</source>
        <translation>Temperatura medida</translation>
    </message>
    <message>
        <source>Temperature of the artefact during the measurement; indications are divided by 1 + α (T − 20 °C).</source>
        <translation>Temperatura del artefacto durante la medición; las indicaciones se dividen por 1 + α (T − 20 °C).</translation>
    </message>
    <message>
        <source>Length for the thermal expansion</source>
        <translation>Longitud para la dilatación térmica</translation>
    </message>
    <message>
        <source>L_max of Eq 3. The paper&apos;s figures result with the largest distance between two points; its text says the largest value of the coordinate, which gives 0 for a flat artefact&apos;s z.</source>
        <translation>L_max de la ec. 3. Las cifras del artículo resultan con la mayor distancia entre dos puntos; su texto dice el mayor valor de la coordenada, lo que da 0 para la z de un artefacto plano.</translation>
    </message>
    <message>
        <source>largest distance between two points</source>
        <translation>mayor distancia entre dos puntos</translation>
    </message>
    <message>
        <source>largest value of the coordinate (text of Eq 3)</source>
        <translation>mayor valor de la coordenada (texto de la ec. 3)</translation>
    </message>
    <message>
        <source>Length standard</source>
        <translation>Patrón de longitud</translation>
    </message>
    <message>
        <source>Calibrated length</source>
        <translation>Longitud calibrada</translation>
    </message>
    <message>
        <source>Distance between the two nests, from the certificate. It should be like the largest distance between the points of both frames.</source>
        <translation>Distancia entre los dos nidos, según el certificado. Debería parecerse a la mayor distancia entre los puntos de ambos sistemas.</translation>
    </message>
    <message>
        <source>Repeated measurements of the artefact, or the components of uncertainty as a report prints them (Table 2 of the paper).</source>
        <translation>Mediciones repetidas del artefacto, o las componentes de incertidumbre tal como las imprime un informe (tabla 2 del artículo).</translation>
    </message>
    <message>
        <source>Measured lengths: one row for each position and run, typed or from a CSV file. The paper proposes at least 14 positions of three runs.</source>
        <translation>Longitudes medidas: una fila por cada posición y pasada, tecleadas o de un archivo CSV. El artículo propone al menos 14 posiciones de tres pasadas.</translation>
    </message>
    <message>
        <source>position</source>
        <translation>posición</translation>
    </message>
    <message>
        <source>Where the standard stood.</source>
        <translation>Dónde estaba el patrón.</translation>
    </message>
    <message>
        <source>Indicated length.</source>
        <translation>Longitud indicada.</translation>
    </message>
    <message>
        <source>One row, as Table 2 of the paper prints it.</source>
        <translation>Una fila, como la imprime la tabla 2 del artículo.</translation>
    </message>
    <message>
        <source>Uncertainty of a coordinate</source>
        <translation>Incertidumbre de una coordenada</translation>
    </message>
    <message>
        <source>A length is the difference of two points, so u of a length is √2 times u of a coordinate. The paper uses the length&apos;s figure unchanged, which is cautious.</source>
        <translation>Una longitud es la diferencia de dos puntos, de modo que u de una longitud es √2 veces u de una coordenada. El artículo usa la cifra de la longitud sin cambios, lo que es prudente.</translation>
    </message>
    <message>
        <source>that of the length (paper)</source>
        <translation>la de la longitud (artículo)</translation>
    </message>
    <message>
        <source>that of the length divided by √2</source>
        <translation>la de la longitud dividida por √2</translation>
    </message>
    <message>
        <source>Tracker, total station, camera or distance meter</source>
        <translation>Seguidor, estación total, cámara o distanciómetro</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Estación</translation>
    </message>
    <message>
        <source>Where the instrument stands in the world frame: the point where its axes meet. x is the zero of the azimuth (the optical axis of a camera), z the vertical axis.</source>
        <translation>Dónde está el instrumento en el sistema global: el punto donde se cortan sus ejes. x es el cero del acimut (el eje óptico de una cámara), z el eje vertical.</translation>
    </message>
    <message>
        <source>The angles are</source>
        <translation>Los ángulos son</translation>
    </message>
    <message>
        <source>How the three angles of the station turn its axes.</source>
        <translation>Cómo giran sus ejes los tres ángulos de la estación.</translation>
    </message>
    <message>
        <source>α, β, γ: R = Rz(γ) Ry(β) Rx(α)</source>
        <translation>α, β, γ: R = Rz(γ) Ry(β) Rx(α)</translation>
    </message>
    <message>
        <source>ω, φ, κ: R = Rx(ω) Ry(φ) Rz(κ), photogrammetric</source>
        <translation>ω, φ, κ: R = Rx(ω) Ry(φ) Rz(κ), fotogramétricos</translation>
    </message>
    <message>
        <source>What the instrument reads, and how it is drawn.</source>
        <translation>Qué lee el instrumento y cómo se dibuja.</translation>
    </message>
    <message>
        <source>total station: distance and two angles</source>
        <translation>estación total: distancia y dos ángulos</translation>
    </message>
    <message>
        <source>laser tracker: distance and two angles</source>
        <translation>seguidor láser: distancia y dos ángulos</translation>
    </message>
    <message>
        <source>laser scanner: distance and two angles</source>
        <translation>escáner láser: distancia y dos ángulos</translation>
    </message>
    <message>
        <source>camera: two angles</source>
        <translation>cámara: dos ángulos</translation>
    </message>
    <message>
        <source>distance meter: distance only</source>
        <translation>distanciómetro: solo distancia</translation>
    </message>
    <message>
        <source>other: chosen readings</source>
        <translation>otro: lecturas elegidas</translation>
    </message>
    <message>
        <source>Reads the distance</source>
        <translation>Lee la distancia</translation>
    </message>
    <message>
        <source>Whether the sensor reads a distance.</source>
        <translation>Si el sensor lee una distancia.</translation>
    </message>
    <message>
        <source>Reads the azimuth</source>
        <translation>Lee el acimut</translation>
    </message>
    <message>
        <source>Whether the sensor reads a horizontal angle.</source>
        <translation>Si el sensor lee un ángulo horizontal.</translation>
    </message>
    <message>
        <source>Reads the elevation</source>
        <translation>Lee la elevación</translation>
    </message>
    <message>
        <source>Whether the sensor reads a vertical angle.</source>
        <translation>Si el sensor lee un ángulo vertical.</translation>
    </message>
    <message>
        <source>Specification</source>
        <translation>Especificación</translation>
    </message>
    <message>
        <source>Distance: constant part a</source>
        <translation>Distancia: parte constante a</translation>
    </message>
    <message>
        <source>Part of the distance&apos;s figure that does not depend on the distance.</source>
        <translation>Parte de la cifra de la distancia que no depende de la distancia.</translation>
    </message>
    <message>
        <source>Distance: part b per length</source>
        <translation>Distancia: parte b por longitud</translation>
    </message>
    <message>
        <source>Part of the distance&apos;s figure in proportion to the distance.</source>
        <translation>Parte de la cifra de la distancia proporcional a la distancia.</translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation>Acimut</translation>
    </message>
    <message>
        <source>Figure for the horizontal angle.</source>
        <translation>Cifra para el ángulo horizontal.</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Elevación</translation>
    </message>
    <message>
        <source>Figure for the vertical angle.</source>
        <translation>Cifra para el ángulo vertical.</translation>
    </message>
    <message>
        <source>Angles: constant part across</source>
        <translation>Ángulos: parte constante transversal</translation>
    </message>
    <message>
        <source>Part of both angles&apos; figures that is a length across the line of sight, as trackers state it (15 µm + 6 µm/m); an angle&apos;s figure is this over the distance plus its own.</source>
        <translation>Parte de las cifras de ambos ángulos que es una longitud transversal a la línea de visión, como la indican los seguidores (15 µm + 6 µm/m); la cifra de un ángulo es esta dividida por la distancia más la suya propia.</translation>
    </message>
    <message>
        <source>The figures are</source>
        <translation>Las cifras son</translation>
    </message>
    <message>
        <source>What the data sheet states: a standard uncertainty, an expanded one, or a limit that is not exceeded (maximum permissible error).</source>
        <translation>Lo que indica la hoja de datos: una incertidumbre típica, una expandida, o un límite que no se supera (error máximo permitido).</translation>
    </message>
    <message>
        <source>standard uncertainty (normal)</source>
        <translation>incertidumbre típica (normal)</translation>
    </message>
    <message>
        <source>expanded uncertainty, k = 2 (normal)</source>
        <translation>incertidumbre expandida, k = 2 (normal)</translation>
    </message>
    <message>
        <source>limit (MPE), rectangular: divided by √3</source>
        <translation>límite (MPE), rectangular: dividido por √3</translation>
    </message>
    <message>
        <source>limit (MPE), triangular: divided by √6</source>
        <translation>límite (MPE), triangular: dividido por √6</translation>
    </message>
    <message>
        <source>limit (MPE), arc sine: divided by √2</source>
        <translation>límite (MPE), arcoseno: dividido por √2</translation>
    </message>
    <message>
        <source>Range and field of view</source>
        <translation>Alcance y campo de visión</translation>
    </message>
    <message>
        <source>Shortest distance</source>
        <translation>Distancia mínima</translation>
    </message>
    <message>
        <source>Targets nearer than this are not measured.</source>
        <translation>Las dianas más cercanas no se miden.</translation>
    </message>
    <message>
        <source>Longest distance</source>
        <translation>Distancia máxima</translation>
    </message>
    <message>
        <source>Targets farther than this are not measured; empty: no limit.</source>
        <translation>Las dianas más lejanas no se miden; vacío: sin límite.</translation>
    </message>
    <message>
        <source>Horizontal field of view</source>
        <translation>Campo de visión horizontal</translation>
    </message>
    <message>
        <source>Full angle, half of it to either side of the sensor&apos;s x-axis; empty: all round.</source>
        <translation>Ángulo completo, la mitad a cada lado del eje x del sensor; vacío: todo alrededor.</translation>
    </message>
    <message>
        <source>Vertical field of view</source>
        <translation>Campo de visión vertical</translation>
    </message>
    <message>
        <source>Full angle, half of it above the sensor&apos;s xy-plane and half below; empty: no limit.</source>
        <translation>Ángulo completo, la mitad por encima del plano xy del sensor y la mitad por debajo; vacío: sin límite.</translation>
    </message>
    <message>
        <source>Shared by all readings</source>
        <translation>Común a todas las lecturas</translation>
    </message>
    <message>
        <source>Scale of distances</source>
        <translation>Escala de las distancias</translation>
    </message>
    <message>
        <source>Standard uncertainty of the scale, which all distances share: wavelength, refractive index, temperature of a scale.</source>
        <translation>Incertidumbre típica de la escala, que comparten todas las distancias: longitud de onda, índice de refracción, temperatura de una regla.</translation>
    </message>
    <message>
        <source>Zero offset of distances</source>
        <translation>Desviación de cero de las distancias</translation>
    </message>
    <message>
        <source>Standard uncertainty of the constant offset of all distances: home position, reflector.</source>
        <translation>Incertidumbre típica de la desviación constante de todas las distancias: posición de referencia, reflector.</translation>
    </message>
    <message>
        <source>Index of the elevation</source>
        <translation>Índice de la elevación</translation>
    </message>
    <message>
        <source>Standard uncertainty of the zero of the vertical circle.</source>
        <translation>Incertidumbre típica del cero del círculo vertical.</translation>
    </message>
    <message>
        <source>Collimation</source>
        <translation>Colimación</translation>
    </message>
    <message>
        <source>Standard uncertainty of the angle between beam and tilting axis off square: the azimuth changes by it over the cosine of the elevation.</source>
        <translation>Incertidumbre típica de la falta de perpendicularidad entre el haz y el eje de basculamiento: el acimut cambia en ella dividida por el coseno de la elevación.</translation>
    </message>
    <message>
        <source>Squareness of the axes</source>
        <translation>Perpendicularidad de los ejes</translation>
    </message>
    <message>
        <source>Standard uncertainty of the angle between the two axes off square: the azimuth changes by it times the tangent of the elevation.</source>
        <translation>Incertidumbre típica de la falta de perpendicularidad entre los dos ejes: el acimut cambia en ella multiplicada por la tangente de la elevación.</translation>
    </message>
    <message>
        <source>Offset of the beam</source>
        <translation>Descentrado del haz</translation>
    </message>
    <message>
        <source>Standard uncertainty of the distance by which the beam misses the vertical axis sideways: the azimuth changes by it over the horizontal distance.</source>
        <translation>Incertidumbre típica de la distancia lateral con que el haz pasa junto al eje vertical: el acimut cambia en ella dividida por la distancia horizontal.</translation>
    </message>
    <message>
        <source>Coefficient of refraction</source>
        <translation>Coeficiente de refracción</translation>
    </message>
    <message>
        <source>Standard uncertainty of k: the elevation changes by k L/(2 × 6371 km) over a distance L.</source>
        <translation>Incertidumbre típica de k: la elevación cambia en k L/(2 × 6371 km) en una distancia L.</translation>
    </message>
    <message>
        <source>The distribution of what all readings share; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation>Distribución de lo que comparten todas las lecturas; lo que se indica es su incertidumbre típica, sea cual sea la forma.</translation>
    </message>
    <message>
        <source>Uncertainty of the station</source>
        <translation>Incertidumbre de la estación</translation>
    </message>
    <message>
        <source>position x</source>
        <translation>posición x</translation>
    </message>
    <message>
        <source>Standard uncertainty of this coordinate of the station, shared by everything measured from it.</source>
        <translation>Incertidumbre típica de esta coordenada de la estación, compartida por todo lo que se mide desde ella.</translation>
    </message>
    <message>
        <source>position y</source>
        <translation>posición y</translation>
    </message>
    <message>
        <source>position z</source>
        <translation>posición z</translation>
    </message>
    <message>
        <source>rotation about x</source>
        <translation>rotación alrededor de x</translation>
    </message>
    <message>
        <source>rotation about y</source>
        <translation>rotación alrededor de y</translation>
    </message>
    <message>
        <source>rotation about z</source>
        <translation>rotación alrededor de z</translation>
    </message>
    <message>
        <source>The distribution of the coordinates of the station; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation>Distribución de las coordenadas de la estación; lo que se indica es su incertidumbre típica, sea cual sea la forma.</translation>
    </message>
    <message>
        <source>Correlation of the station&apos;s coordinates</source>
        <translation>Correlación de las coordenadas de la estación</translation>
    </message>
    <message>
        <source>Correlation coefficients from the adjustment that located the station; pairs left out are uncorrelated.</source>
        <translation>Coeficientes de correlación de la compensación que localizó la estación; los pares omitidos no están correlacionados.</translation>
    </message>
    <message>
        <source>first</source>
        <translation>primera</translation>
    </message>
    <message>
        <source>A coordinate of the station.</source>
        <translation>Una coordenada de la estación.</translation>
    </message>
    <message>
        <source>second</source>
        <translation>segunda</translation>
    </message>
    <message>
        <source>Correlation coefficient.</source>
        <translation>Coeficiente de correlación.</translation>
    </message>
    <message>
        <source>Network of sensors</source>
        <translation>Red de sensores</translation>
    </message>
    <message>
        <source>What the weights of the readings account for. With the stations, all points of one analysis are estimated together.</source>
        <translation>Qué tienen en cuenta los pesos de las lecturas. Con las estaciones, todos los puntos de un análisis se estiman conjuntamente.</translation>
    </message>
    <message>
        <source>readings and stations, all points at once</source>
        <translation>lecturas y estaciones, todos los puntos a la vez</translation>
    </message>
    <message>
        <source>readings alone, each point by itself</source>
        <translation>solo lecturas, cada punto por separado</translation>
    </message>
    <message>
        <source>Specification of a measured point</source>
        <translation>Especificación de un punto medido</translation>
    </message>
    <message>
        <source>Figure of the data sheet</source>
        <translation>Cifra de la hoja de datos</translation>
    </message>
    <message>
        <source>The uncertainty or limit that the manufacturer states, the same for x, y and z.</source>
        <translation>La incertidumbre o el límite que indica el fabricante, igual para x, y y z.</translation>
    </message>
    <message>
        <source>The figure applies to</source>
        <translation>La cifra se refiere a</translation>
    </message>
    <message>
        <source>A coordinate of a point, or a length between two points; a length is the difference of two points, so a coordinate has 1/√2 of it.</source>
        <translation>Una coordenada de un punto, o una longitud entre dos puntos; una longitud es la diferencia de dos puntos, de modo que a una coordenada le corresponde 1/√2 de ella.</translation>
    </message>
    <message>
        <source>a coordinate</source>
        <translation>una coordenada</translation>
    </message>
    <message>
        <source>a length between two points</source>
        <translation>una longitud entre dos puntos</translation>
    </message>
    <message>
        <source>Telescopic ballbars (multilateration)</source>
        <translation>Barras de bolas telescópicas (multilateración)</translation>
    </message>
    <message>
        <source>Supports</source>
        <translation>Soportes</translation>
    </message>
    <message>
        <source>Support 1 to support 2</source>
        <translation>Soporte 1 a soporte 2</translation>
    </message>
    <message>
        <source>Measured length between supports 1 and 2.</source>
        <translation>Longitud medida entre los soportes 1 y 2.</translation>
    </message>
    <message>
        <source>Support 1 to support 3</source>
        <translation>Soporte 1 a soporte 3</translation>
    </message>
    <message>
        <source>Measured length between supports 1 and 3.</source>
        <translation>Longitud medida entre los soportes 1 y 3.</translation>
    </message>
    <message>
        <source>Support 2 to support 3</source>
        <translation>Soporte 2 a soporte 3</translation>
    </message>
    <message>
        <source>Measured length between supports 2 and 3.</source>
        <translation>Longitud medida entre los soportes 2 y 3.</translation>
    </message>
    <message>
        <source>Further supports</source>
        <translation>Otros soportes</translation>
    </message>
    <message>
        <source>Supports 4, 5 ...: their lengths to the first three, and their height above the plane of these. More than three lengths are adjusted by least squares.</source>
        <translation>Soportes 4, 5 ...: sus longitudes a los tres primeros y su altura sobre el plano de estos. Más de tres longitudes se compensan por mínimos cuadrados.</translation>
    </message>
    <message>
        <source>Length to this support.</source>
        <translation>Longitud a este soporte.</translation>
    </message>
    <message>
        <source>Height above the first three supports.</source>
        <translation>Altura sobre los tres primeros soportes.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the height.</source>
        <translation>Incertidumbre típica de la altura.</translation>
    </message>
    <message>
        <source>The ball is</source>
        <translation>La bola está</translation>
    </message>
    <message>
        <source>Three lengths meet in two points, mirror images in the plane of the supports: on which side of it the ball is (sign of the root of Eq 3).</source>
        <translation>Tres longitudes se cortan en dos puntos, simétricos respecto del plano de los soportes: a qué lado de él está la bola (signo de la raíz de la ec. 3).</translation>
    </message>
    <message>
        <source>on the side of +z</source>
        <translation>en el lado de +z</translation>
    </message>
    <message>
        <source>on the side of −z</source>
        <translation>en el lado de −z</translation>
    </message>
    <message>
        <source>Placement</source>
        <translation>Emplazamiento</translation>
    </message>
    <message>
        <source>Place in the robot&apos;s frame</source>
        <translation>Lugar en el sistema del robot</translation>
    </message>
    <message>
        <source>Where the instrument&apos;s frame is in the robot&apos;s: origin in support 1, x towards support 2, z normal to the plane of the first three supports, on the left of the way 1-2-3.</source>
        <translation>Dónde está el sistema del instrumento en el del robot: origen en el soporte 1, x hacia el soporte 2, z normal al plano de los tres primeros soportes, a la izquierda del recorrido 1-2-3.</translation>
    </message>
    <message>
        <source>Uncertainty of a length</source>
        <translation>Incertidumbre de una longitud</translation>
    </message>
    <message>
        <source>To the ball: constant part a</source>
        <translation>A la bola: parte constante a</translation>
    </message>
    <message>
        <source>Figure for one reading of a bar to the ball, the part that does not depend on the length.</source>
        <translation>Cifra para una lectura de una barra a la bola, la parte que no depende de la longitud.</translation>
    </message>
    <message>
        <source>To the ball: part b per length</source>
        <translation>A la bola: parte b por longitud</translation>
    </message>
    <message>
        <source>Figure for one reading of a bar to the ball, the part in proportion to the length.</source>
        <translation>Cifra para una lectura de una barra a la bola, la parte proporcional a la longitud.</translation>
    </message>
    <message>
        <source>Between supports: constant part a</source>
        <translation>Entre soportes: parte constante a</translation>
    </message>
    <message>
        <source>Figure for a length between two supports, which one measurement gives for all points: the part that does not depend on the length.</source>
        <translation>Cifra para una longitud entre dos soportes, que una medición da para todos los puntos: la parte que no depende de la longitud.</translation>
    </message>
    <message>
        <source>Between supports: part b per length</source>
        <translation>Entre soportes: parte b por longitud</translation>
    </message>
    <message>
        <source>Figure for a length between two supports, the part in proportion to the length.</source>
        <translation>Cifra para una longitud entre dos soportes, la parte proporcional a la longitud.</translation>
    </message>
    <message>
        <source>Shared by all lengths</source>
        <translation>Común a todas las longitudes</translation>
    </message>
    <message>
        <source>Scale of all lengths</source>
        <translation>Escala de todas las longitudes</translation>
    </message>
    <message>
        <source>Standard uncertainty of the scale that all lengths share: wavelength, refractive index.</source>
        <translation>Incertidumbre típica de la escala que comparten todas las longitudes: longitud de onda, índice de refracción.</translation>
    </message>
    <message>
        <source>Constant of each bar</source>
        <translation>Constante de cada barra</translation>
    </message>
    <message>
        <source>Standard uncertainty of the constant of a bar, the same in all its readings to the ball.</source>
        <translation>Incertidumbre típica de la constante de una barra, la misma en todas sus lecturas a la bola.</translation>
    </message>
    <message>
        <source>The distribution of scale and constants; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation>Distribución de la escala y las constantes; lo que se indica es su incertidumbre típica, sea cual sea la forma.</translation>
    </message>
    <message>
        <source>Robot: repeatability of a pose</source>
        <translation>Robot: repetibilidad de una pose</translation>
    </message>
    <message>
        <source>Positioning</source>
        <translation>Posicionamiento</translation>
    </message>
    <message>
        <source>The robot&apos;s figure for the scatter of a position that it is sent to again and again.</source>
        <translation>La cifra del robot para la dispersión de una posición a la que se le envía una y otra vez.</translation>
    </message>
    <message>
        <source>The figure is</source>
        <translation>La cifra es</translation>
    </message>
    <message>
        <source>A largest distance from the mean position, or RP of ISO 9283: the mean distance plus three times its standard deviation. A normal law has no largest distance, so its figure is always RP.</source>
        <translation>Una distancia máxima a la posición media, o RP de ISO 9283: la distancia media más tres veces su desviación típica. Una ley normal no tiene distancia máxima, así que su cifra es siempre RP.</translation>
    </message>
    <message>
        <source>the largest distance r</source>
        <translation>la distancia máxima r</translation>
    </message>
    <message>
        <source>RP of ISO 9283: mean + 3 s</source>
        <translation>RP de ISO 9283: media + 3 s</translation>
    </message>
    <message>
        <source>Deviation of a position</source>
        <translation>Desviación de una posición</translation>
    </message>
    <message>
        <source>How the distance from the mean position is distributed; all directions are equally probable.</source>
        <translation>Cómo se distribuye la distancia a la posición media; todas las direcciones son igualmente probables.</translation>
    </message>
    <message>
        <source>rectangular in [0, r] in a random direction</source>
        <translation>rectangular en [0, r] en una dirección aleatoria</translation>
    </message>
    <message>
        <source>anywhere in a ball of radius r</source>
        <translation>en cualquier lugar de una bola de radio r</translation>
    </message>
    <message>
        <source>always r, in a random direction</source>
        <translation>siempre r, en una dirección aleatoria</translation>
    </message>
    <message>
        <source>normal along each axis</source>
        <translation>normal según cada eje</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Orientación</translation>
    </message>
    <message>
        <source>Figure for the scatter of the orientation about each axis of the flange; 0: none.</source>
        <translation>Cifra para la dispersión de la orientación alrededor de cada eje de la brida; 0: ninguna.</translation>
    </message>
    <message>
        <source>The angle is</source>
        <translation>El ángulo es</translation>
    </message>
    <message>
        <source>A standard uncertainty, RP of ISO 9283 for an angle (three times its standard deviation), or a limit that is not exceeded.</source>
        <translation>Una incertidumbre típica, RP de ISO 9283 para un ángulo (tres veces su desviación típica), o un límite que no se supera.</translation>
    </message>
    <message>
        <source>RP of ISO 9283: ± 3 s (normal)</source>
        <translation>RP de ISO 9283: ± 3 s (normal)</translation>
    </message>
    <message>
        <source>limit, rectangular: divided by √3</source>
        <translation>límite, rectangular: dividido por √3</translation>
    </message>
    <message>
        <source>Serial robot</source>
        <translation>Robot serie</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Geometría</translation>
    </message>
    <message>
        <source>Convention</source>
        <translation>Convención</translation>
    </message>
    <message>
        <source>How the parameters of a row lead from one joint&apos;s frame to the next.</source>
        <translation>Cómo llevan los parámetros de una fila del sistema de una articulación al siguiente.</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Articulaciones</translation>
    </message>
    <message>
        <source>One row for each joint from the base to the tool, in the chosen convention.</source>
        <translation>Una fila por cada articulación, de la base a la herramienta, en la convención elegida.</translation>
    </message>
    <message>
        <source>Joint angle where the reading is the zero reading.</source>
        <translation>Ángulo de la articulación cuando la lectura es la lectura cero.</translation>
    </message>
    <message>
        <source>Offset along the joint&apos;s axis.</source>
        <translation>Desplazamiento según el eje de la articulación.</translation>
    </message>
    <message>
        <source>Length of the common perpendicular.</source>
        <translation>Longitud de la perpendicular común.</translation>
    </message>
    <message>
        <source>Twist about x between two axes.</source>
        <translation>Torsión alrededor de x entre dos ejes.</translation>
    </message>
    <message>
        <source>Twist about y, of a joint whose axis is parallel to the next: d is then 0 by definition. Empty: the axes are not parallel.</source>
        <translation>Torsión alrededor de y, de una articulación cuyo eje es paralelo al siguiente: d es entonces 0 por definición. Vacío: los ejes no son paralelos.</translation>
    </message>
    <message>
        <source>Reading of the joint at which theta holds; empty: 0.</source>
        <translation>Lectura de la articulación para la que vale theta; vacío: 0.</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>dirección</translation>
    </message>
    <message>
        <source>Whether the joint angle grows or falls with the reading; empty: grows.</source>
        <translation>Si el ángulo de la articulación crece o decrece con la lectura; vacío: crece.</translation>
    </message>
    <message>
        <source>with the reading</source>
        <translation>con la lectura</translation>
    </message>
    <message>
        <source>against the reading</source>
        <translation>contra la lectura</translation>
    </message>
    <message>
        <source>Lowest reading; empty: no limit.</source>
        <translation>Lectura mínima; vacío: sin límite.</translation>
    </message>
    <message>
        <source>Highest reading; empty: no limit.</source>
        <translation>Lectura máxima; vacío: sin límite.</translation>
    </message>
    <message>
        <source>Standard uncertainty of a reading by the joint&apos;s encoder, drawn anew at each pose.</source>
        <translation>Incertidumbre típica de una lectura del codificador de la articulación, extraída de nuevo en cada pose.</translation>
    </message>
    <message>
        <source>Standard uncertainty by which the joint comes back to a reading, drawn anew at each pose.</source>
        <translation>Incertidumbre típica con la que la articulación vuelve a una lectura, extraída de nuevo en cada pose.</translation>
    </message>
    <message>
        <source>type</source>
        <translation>tipo</translation>
    </message>
    <message>
        <source>A joint that turns has readings q, which add to theta; one that slides has readings s, which add to d. Empty: it turns.</source>
        <translation>Una articulación que gira tiene lecturas q, que se suman a theta; una que desliza tiene lecturas s, que se suman a d. Vacío: gira.</translation>
    </message>
    <message>
        <source>turns about its axis</source>
        <translation>gira alrededor de su eje</translation>
    </message>
    <message>
        <source>slides along its axis</source>
        <translation>desliza a lo largo de su eje</translation>
    </message>
    <message>
        <source>Reading of a sliding joint at which d holds; empty: 0.</source>
        <translation>Lectura de una articulación deslizante para la que vale d; vacío: 0.</translation>
    </message>
    <message>
        <source>Lowest reading of a sliding joint; empty: no limit.</source>
        <translation>Lectura mínima de una articulación deslizante; vacío: sin límite.</translation>
    </message>
    <message>
        <source>Highest reading of a sliding joint; empty: no limit.</source>
        <translation>Lectura máxima de una articulación deslizante; vacío: sin límite.</translation>
    </message>
    <message>
        <source>Standard uncertainty of a reading of a sliding joint by its scale, drawn anew at each pose.</source>
        <translation>Incertidumbre típica de una lectura de la regla de una articulación deslizante, extraída de nuevo en cada pose.</translation>
    </message>
    <message>
        <source>Standard uncertainty by which a sliding joint comes back to a reading, drawn anew at each pose.</source>
        <translation>Incertidumbre típica con la que una articulación deslizante vuelve a una lectura, extraída de nuevo en cada pose.</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Where frame 0 of the robot stands in the world.</source>
        <translation>Dónde está el sistema 0 del robot en el sistema global.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Herramienta</translation>
    </message>
    <message>
        <source>Where the tool is in the frame of the last link.</source>
        <translation>Dónde está la herramienta en el sistema del último eslabón.</translation>
    </message>
    <message>
        <source>Standard uncertainties of the parameters by source. A row for a joint and a source; components of one parameter combine in quadrature.</source>
        <translation>Incertidumbres típicas de los parámetros por fuente. Una fila por articulación y fuente; las componentes de un parámetro se combinan cuadráticamente.</translation>
    </message>
    <message>
        <source>Where the figures come from: repeatability, sampling, range, certificate ...</source>
        <translation>De dónde proceden las cifras: repetibilidad, muestreo, intervalo, certificado ...</translation>
    </message>
    <message>
        <source>Number of the joint; empty: all joints, each with a deviation of its own.</source>
        <translation>Número de la articulación; vacío: todas las articulaciones, cada una con su propia desviación.</translation>
    </message>
    <message>
        <source>Standard uncertainty of theta from this source; empty: none.</source>
        <translation>Incertidumbre típica de theta debida a esta fuente; vacío: ninguna.</translation>
    </message>
    <message>
        <source>Standard uncertainty of d from this source; empty: none.</source>
        <translation>Incertidumbre típica de d debida a esta fuente; vacío: ninguna.</translation>
    </message>
    <message>
        <source>Standard uncertainty of a from this source; empty: none.</source>
        <translation>Incertidumbre típica de a debida a esta fuente; vacío: ninguna.</translation>
    </message>
    <message>
        <source>Standard uncertainty of alpha from this source; empty: none.</source>
        <translation>Incertidumbre típica de alpha debida a esta fuente; vacío: ninguna.</translation>
    </message>
    <message>
        <source>Standard uncertainty of beta from this source; empty: none.</source>
        <translation>Incertidumbre típica de beta debida a esta fuente; vacío: ninguna.</translation>
    </message>
    <message>
        <source>Degrees of freedom of the figures; empty: infinitely many.</source>
        <translation>Grados de libertad de las cifras; vacío: infinitos.</translation>
    </message>
    <message>
        <source>Form of the distribution with this standard uncertainty; empty: normal.</source>
        <translation>Forma de la distribución con esta incertidumbre típica; vacío: normal.</translation>
    </message>
    <message>
        <source>Correlation coefficients from the identification; pairs left out are uncorrelated. A correlated parameter has one component.</source>
        <translation>Coeficientes de correlación de la identificación; los pares omitidos no están correlacionados. Un parámetro correlacionado tiene una sola componente.</translation>
    </message>
    <message>
        <source>Tool, position</source>
        <translation>Herramienta, posición</translation>
    </message>
    <message>
        <source>Standard uncertainty of each coordinate of the tool in the frame of the last link.</source>
        <translation>Incertidumbre típica de cada coordenada de la herramienta en el sistema del último eslabón.</translation>
    </message>
    <message>
        <source>Tool, orientation</source>
        <translation>Herramienta, orientación</translation>
    </message>
    <message>
        <source>Standard uncertainty of each rotation of the tool about its own axes.</source>
        <translation>Incertidumbre típica de cada rotación de la herramienta alrededor de sus propios ejes.</translation>
    </message>
    <message>
        <source>Force/moment calibration machine</source>
        <translation>Máquina de calibración de fuerza/momento</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Certificado</translation>
    </message>
    <message>
        <source>Uncertainty of its loads</source>
        <translation>Incertidumbre de sus cargas</translation>
    </message>
    <message>
        <source>One row for each axis that the machine loads: the relative expanded uncertainty of its certificate and the coverage factor.</source>
        <translation>Una fila por cada eje que carga la máquina: la incertidumbre expandida relativa de su certificado y el factor de cobertura.</translation>
    </message>
    <message>
        <source>Force or moment.</source>
        <translation>Fuerza o momento.</translation>
    </message>
    <message>
        <source>Relative expanded uncertainty of the load: a ratio, not %.</source>
        <translation>Incertidumbre expandida relativa de la carga: una razón, no %.</translation>
    </message>
    <message>
        <source>Coverage factor; empty: 2.</source>
        <translation>Factor de cobertura; vacío: 2.</translation>
    </message>
    <message>
        <source>Multi-axis force/moment sensor</source>
        <translation>Sensor multieje de fuerza/momento</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Canales</translation>
    </message>
    <message>
        <source>The forces and moments that the sensor measures, with their rated loads.</source>
        <translation>Las fuerzas y los momentos que mide el sensor, con sus cargas nominales.</translation>
    </message>
    <message>
        <source>Force or moment that the channel measures.</source>
        <translation>Fuerza o momento que mide el canal.</translation>
    </message>
    <message>
        <source>rated force</source>
        <translation>fuerza nominal</translation>
    </message>
    <message>
        <source>Rated load of Fx, Fy or Fz.</source>
        <translation>Carga nominal de Fx, Fy o Fz.</translation>
    </message>
    <message>
        <source>rated moment</source>
        <translation>momento nominal</translation>
    </message>
    <message>
        <source>Rated load of Mx, My or Mz.</source>
        <translation>Carga nominal de Mx, My o Mz.</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>Where the sensor&apos;s axes are; loads are along and about them.</source>
        <translation>Dónde están los ejes del sensor; las cargas actúan según ellos y alrededor de ellos.</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diámetro</translation>
    </message>
    <message>
        <source>Of its housing, for the picture.</source>
        <translation>De su carcasa, para la imagen.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>Indicator</source>
        <translation>Indicador</translation>
    </message>
    <message>
        <source>Resolution of the indicator</source>
        <translation>Resolución del indicador</translation>
    </message>
    <message>
        <source>Smallest step of the indicated value, r of Eq 6.</source>
        <translation>Escalón más pequeño del valor indicado, r de la ec. 6.</translation>
    </message>
    <message>
        <source>Range of the indicator</source>
        <translation>Alcance del indicador</translation>
    </message>
    <message>
        <source>Largest value that it can indicate; a reading there is refused as saturated. Empty: only readings that stand still while the load rises are.</source>
        <translation>Mayor valor que puede indicar; una lectura en él se rechaza por saturada. Vacío: solo se rechazan las lecturas que no varían mientras la carga aumenta.</translation>
    </message>
    <message>
        <source>Calibration machine</source>
        <translation>Máquina de calibración</translation>
    </message>
    <message>
        <source>What loaded the sensor; its relative uncertainty enters by Eq 5.</source>
        <translation>Lo que cargó el sensor; su incertidumbre relativa entra por la ec. 5.</translation>
    </message>
    <message>
        <source>Raw readings, from which everything follows, or what an evaluation states.</source>
        <translation>Lecturas brutas, de las que se obtiene todo, o lo que indica una evaluación.</translation>
    </message>
    <message>
        <source>raw readings</source>
        <translation>lecturas brutas</translation>
    </message>
    <message>
        <source>summary tables</source>
        <translation>tablas resumen</translation>
    </message>
    <message>
        <source>Indicated values of all channels at each step, the unloaded value not subtracted; typed or from a CSV file, whose columns may have other names.</source>
        <translation>Valores indicados de todos los canales en cada escalón, sin restar el valor sin carga; tecleados o de un archivo CSV, cuyas columnas pueden tener otros nombres.</translation>
    </message>
    <message>
        <source>Axis on which the machine&apos;s load acts.</source>
        <translation>Eje sobre el que actúa la carga de la máquina.</translation>
    </message>
    <message>
        <source>Preloading or calibration.</source>
        <translation>Precarga o calibración.</translation>
    </message>
    <message>
        <source>preload</source>
        <translation>precarga</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>calibración</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>fase</translation>
    </message>
    <message>
        <source>Unloaded before, preload, increasing or decreasing load, unloaded after.</source>
        <translation>Sin carga antes, precarga, carga creciente o decreciente, sin carga después.</translation>
    </message>
    <message>
        <source>zero before</source>
        <translation>cero antes</translation>
    </message>
    <message>
        <source>load</source>
        <translation>carga</translation>
    </message>
    <message>
        <source>increasing</source>
        <translation>creciente</translation>
    </message>
    <message>
        <source>decreasing</source>
        <translation>decreciente</translation>
    </message>
    <message>
        <source>zero after</source>
        <translation>cero después</translation>
    </message>
    <message>
        <source>step</source>
        <translation>escalón</translation>
    </message>
    <message>
        <source>Number of the step: 0 without load, the same number for increasing and decreasing load.</source>
        <translation>Número del escalón: 0 sin carga, el mismo número para carga creciente y decreciente.</translation>
    </message>
    <message>
        <source>Load in the unit of the next column.</source>
        <translation>Carga en la unidad de la columna siguiente.</translation>
    </message>
    <message>
        <source>load unit</source>
        <translation>unidad de carga</translation>
    </message>
    <message>
        <source>N, kN, Nm ...; empty: N for forces and N·m for moments.</source>
        <translation>N, kN, Nm ...; vacío: N para fuerzas y N·m para momentos.</translation>
    </message>
    <message>
        <source>Time of the reading.</source>
        <translation>Hora de la lectura.</translation>
    </message>
    <message>
        <source>Indicated value of this channel.</source>
        <translation>Valor indicado de este canal.</translation>
    </message>
    <message>
        <source>Summary</source>
        <translation>Resumen</translation>
    </message>
    <message>
        <source>What an evaluation states of each channel, like Tables 1 and 3 of the paper.</source>
        <translation>Lo que una evaluación indica de cada canal, como las tablas 1 y 3 del artículo.</translation>
    </message>
    <message>
        <source>Channel.</source>
        <translation>Canal.</translation>
    </message>
    <message>
        <source>rated output</source>
        <translation>salida nominal</translation>
    </message>
    <message>
        <source>Mean net reading at the rated load.</source>
        <translation>Lectura neta media a la carga nominal.</translation>
    </message>
    <message>
        <source>non-zero error</source>
        <translation>error de cero</translation>
    </message>
    <message>
        <source>Non-zero error: change of the unloaded reading over a series.</source>
        <translation>Error de cero: cambio de la lectura sin carga a lo largo de una serie.</translation>
    </message>
    <message>
        <source>Type A standard uncertainty of the mean, the largest of all steps.</source>
        <translation>Incertidumbre típica de Tipo A de la media, la mayor de todos los escalones.</translation>
    </message>
    <message>
        <source>hysteresis</source>
        <translation>histéresis</translation>
    </message>
    <message>
        <source>Largest difference between increasing and decreasing load.</source>
        <translation>Mayor diferencia entre carga creciente y decreciente.</translation>
    </message>
    <message>
        <source>Type B standard uncertainty as stated; empty: from the machine, the resolution and the non-zero error (Eq 8).</source>
        <translation>Incertidumbre típica de Tipo B indicada; vacío: a partir de la máquina, la resolución y el error de cero (ec. 8).</translation>
    </message>
    <message>
        <source>Interference</source>
        <translation>Interferencia</translation>
    </message>
    <message>
        <source>Outputs at rated loads on other axes, like Table 2 of the paper; which index is the load is chosen below.</source>
        <translation>Salidas con cargas nominales en otros ejes, como la tabla 2 del artículo; abajo se elige qué índice es la carga.</translation>
    </message>
    <message>
        <source>Row of the table.</source>
        <translation>Fila de la tabla.</translation>
    </message>
    <message>
        <source>Column of the table; empty on the diagonal.</source>
        <translation>Columna de la tabla; vacía en la diagonal.</translation>
    </message>
    <message>
        <source>Interference has signs</source>
        <translation>Interferencia con signos</translation>
    </message>
    <message>
        <source>Whether the signs are printed. Without them interference cannot be compensated.</source>
        <translation>Si los signos están impresos. Sin ellos la interferencia no se puede compensar.</translation>
    </message>
    <message>
        <source>Calibration plan</source>
        <translation>Plan de calibración</translation>
    </message>
    <message>
        <source>Preloads</source>
        <translation>Precargas</translation>
    </message>
    <message>
        <source>How often each axis is loaded to its rated load before.</source>
        <translation>Cuántas veces se carga antes cada eje hasta su carga nominal.</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Pasadas</translation>
    </message>
    <message>
        <source>Calibration series of each axis: n of Eqs 2 to 4.</source>
        <translation>Series de calibración de cada eje: n de las ecs. 2 a 4.</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Escalones</translation>
    </message>
    <message>
        <source>Loads of a series up to the rated load; the paper asks for five or more.</source>
        <translation>Cargas de una serie hasta la carga nominal; el artículo pide cinco o más.</translation>
    </message>
    <message>
        <source>Decreasing loads too</source>
        <translation>También cargas decrecientes</translation>
    </message>
    <message>
        <source>Whether each series goes down again; hysteresis needs it.</source>
        <translation>Si cada serie vuelve a bajar; la histéresis lo necesita.</translation>
    </message>
    <message>
        <source>Without load before a series</source>
        <translation>Sin carga antes de una serie</translation>
    </message>
    <message>
        <source>Before each series, Fig. 2.</source>
        <translation>Antes de cada serie, fig. 2.</translation>
    </message>
    <message>
        <source>At each load</source>
        <translation>En cada carga</translation>
    </message>
    <message>
        <source>Before a reading is taken, Fig. 2.</source>
        <translation>Antes de tomar una lectura, fig. 2.</translation>
    </message>
    <message>
        <source>Evaluation by the paper</source>
        <translation>Evaluación según el artículo</translation>
    </message>
    <message>
        <source>Coverage factor k of Eq 12</source>
        <translation>Factor de cobertura k de la ec. 12</translation>
    </message>
    <message>
        <source>The paper takes 2.</source>
        <translation>El artículo toma 2.</translation>
    </message>
    <message>
        <source>A row of the interference table is</source>
        <translation>Una fila de la tabla de interferencia es</translation>
    </message>
    <message>
        <source>Section 2.5 says e_12 is the output of Fy under Fx (row = load), but divides by the rated output of the row and calls the row&apos;s largest the error of that sensor. Raw readings leave no doubt; for a printed table the choice changes U.</source>
        <translation>El apartado 2.5 dice que e_12 es la salida de Fy bajo Fx (fila = carga), pero divide por la salida nominal de la fila y llama al mayor de la fila el error de ese sensor. Las lecturas brutas no dejan duda; para una tabla impresa la elección cambia U.</translation>
    </message>
    <message>
        <source>a sensor: its outputs under the other loads</source>
        <translation>un sensor: sus salidas bajo las otras cargas</translation>
    </message>
    <message>
        <source>a load: the outputs of the other sensors under it</source>
        <translation>una carga: las salidas de los otros sensores bajo ella</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Comparación</translation>
    </message>
    <message>
        <source>Stated values</source>
        <translation>Valores indicados</translation>
    </message>
    <message>
        <source>Values that a certificate or a paper prints, to be compared with those computed.</source>
        <translation>Valores que imprime un certificado o un artículo, para compararlos con los calculados.</translation>
    </message>
    <message>
        <source>As printed, in mV/V; empty: not compared.</source>
        <translation>Como está impreso, en mV/V; vacío: no se compara.</translation>
    </message>
    <message>
        <source>interference</source>
        <translation>interferencia</translation>
    </message>
    <message>
        <source>U, relative</source>
        <translation>U, relativa</translation>
    </message>
    <message>
        <source>Relative expanded uncertainty of Eq 12b.</source>
        <translation>Incertidumbre expandida relativa de la ec. 12b.</translation>
    </message>
    <message>
        <source>U, as a load</source>
        <translation>U, como carga</translation>
    </message>
    <message>
        <source>Expanded uncertainty of Eq 12c in N or N·m, a number without unit.</source>
        <translation>Incertidumbre expandida de la ec. 12c en N o N·m, un número sin unidad.</translation>
    </message>
    <message>
        <source>Stated interference in %</source>
        <translation>Interferencia indicada en %</translation>
    </message>
    <message>
        <source>Table 4 of the paper: interference by the rated output of the row.</source>
        <translation>Tabla 4 del artículo: interferencia dividida por la salida nominal de la fila.</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>máximo</translation>
    </message>
    <message>
        <source>Largest of the row.</source>
        <translation>Máximo de la fila.</translation>
    </message>
    <message>
        <source>Typed measurement equation</source>
        <translation>Ecuación de medida tecleada</translation>
    </message>
    <message>
        <source>The uncertainty of a quantity computed from others by an equation.</source>
        <translation>La incertidumbre de una magnitud calculada a partir de otras con una ecuación.</translation>
    </message>
    <message>
        <source>Gauge block by comparison</source>
        <translation>Bloque patrón por comparación</translation>
    </message>
    <message>
        <source>The length of a gauge block compared with a standard of the same length.</source>
        <translation>La longitud de un bloque patrón comparado con un patrón de la misma longitud.</translation>
    </message>
    <message>
        <source>Two quantities from the same readings</source>
        <translation>Dos magnitudes de las mismas lecturas</translation>
    </message>
    <message>
        <source>Resistance and reactance from simultaneous readings, with their correlation.</source>
        <translation>Resistencia y reactancia de lecturas simultáneas, con su correlación.</translation>
    </message>
    <message>
        <source>Calibration line of a thermometer</source>
        <translation>Recta de calibración de un termómetro</translation>
    </message>
    <message>
        <source>The correction at any reading, from a line through calibration points.</source>
        <translation>La corrección en cualquier lectura, con una recta por puntos de calibración.</translation>
    </message>
    <message>
        <source>Observations on several days</source>
        <translation>Observaciones en varios días</translation>
    </message>
    <message>
        <source>The mean of readings in groups, and whether the groups differ.</source>
        <translation>La media de lecturas en grupos, y si los grupos difieren.</translation>
    </message>
    <message>
        <source>Pose of a platform from a tracker</source>
        <translation>Pose de una plataforma con un seguidor</translation>
    </message>
    <message>
        <source>Where a robot&apos;s flange or platform is, from nests measured by a laser tracker.</source>
        <translation>Dónde está la brida o la plataforma de un robot, a partir de nidos medidos con un seguidor láser.</translation>
    </message>
    <message>
        <source>Pose from two instruments together</source>
        <translation>Pose con dos instrumentos a la vez</translation>
    </message>
    <message>
        <source>The same pose measured by a tracker and a total station as one network.</source>
        <translation>La misma pose medida con un seguidor y una estación total como una sola red.</translation>
    </message>
    <message>
        <source>Pose from calibrated artefacts</source>
        <translation>Pose a partir de artefactos calibrados</translation>
    </message>
    <message>
        <source>A pose whose point uncertainties come from measurements of artefacts.</source>
        <translation>Una pose cuyas incertidumbres de los puntos proceden de mediciones de artefactos.</translation>
    </message>
    <message>
        <source>Points by cameras and a tracker</source>
        <translation>Puntos con cámaras y un seguidor</translation>
    </message>
    <message>
        <source>Coordinates of targets that several instruments measure together.</source>
        <translation>Coordenadas de dianas que varios instrumentos miden conjuntamente.</translation>
    </message>
    <message>
        <source>Network with unknown stations</source>
        <translation>Red con estaciones desconocidas</translation>
    </message>
    <message>
        <source>Places of targets and of the instruments themselves, from readings to control points.</source>
        <translation>Posiciones de dianas y de los propios instrumentos, a partir de lecturas a puntos de control.</translation>
    </message>
    <message>
        <source>Where do I put the station?</source>
        <translation>¿Dónde coloco la estación?</translation>
    </message>
    <message>
        <source>The place of an instrument that makes the uncertainties smallest.</source>
        <translation>El lugar de un instrumento que hace mínimas las incertidumbres.</translation>
    </message>
    <message>
        <source>Tool by ballbars</source>
        <translation>Herramienta con barras de bolas</translation>
    </message>
    <message>
        <source>A robot&apos;s tool centre point from rotations measured by telescopic ballbars.</source>
        <translation>El punto central de la herramienta de un robot, a partir de rotaciones medidas con barras de bolas telescópicas.</translation>
    </message>
    <message>
        <source>Which points do I measure?</source>
        <translation>¿Qué puntos mido?</translation>
    </message>
    <message>
        <source>The dozen of a plan of points that makes the uncertainty smallest.</source>
        <translation>La docena de puntos de un plan que hace mínima la incertidumbre.</translation>
    </message>
    <message>
        <source>Tool position of a robot</source>
        <translation>Posición de la herramienta de un robot</translation>
    </message>
    <message>
        <source>Where the tool is, from joint readings and Denavit-Hartenberg parameters.</source>
        <translation>Dónde está la herramienta, a partir de lecturas articulares y parámetros de Denavit-Hartenberg.</translation>
    </message>
    <message>
        <source>Parameters of an arm from circles that its joints describe one by one.</source>
        <translation>Parámetros de un brazo a partir de los círculos que describen sus articulaciones una a una.</translation>
    </message>
    <message>
        <source>Parameters of an arm from measured places of its flange.</source>
        <translation>Parámetros de un brazo a partir de lugares medidos de su brida.</translation>
    </message>
    <message>
        <source>Calibration of a force/moment sensor</source>
        <translation>Calibración de un sensor de fuerza/momento</translation>
    </message>
    <message>
        <source>Errors and uncertainty of the channels of a multi-axis sensor.</source>
        <translation>Errores e incertidumbre de los canales de un sensor multieje.</translation>
    </message>
    <message>
        <source>Forces and moments from readings</source>
        <translation>Fuerzas y momentos a partir de lecturas</translation>
    </message>
    <message>
        <source>Loads from the readings of a multi-axis sensor by its calibration matrix.</source>
        <translation>Cargas a partir de las lecturas de un sensor multieje con su matriz de calibración.</translation>
    </message>
    <message>
        <source>Law of propagation alone (JCGM 100), with a fixed number of trials (JCGM 101), or with as many as the tolerance needs.</source>
        <translation>Solo la ley de propagación (JCGM 100), con un número fijo de pruebas (JCGM 101), o con tantas como exija la tolerancia.</translation>
    </message>
    <message>
        <source>Law of propagation only</source>
        <translation>Solo ley de propagación</translation>
    </message>
    <message>
        <source>Monte Carlo, fixed number of trials</source>
        <translation>Monte Carlo, número fijo de pruebas</translation>
    </message>
    <message>
        <source>Monte Carlo, adaptive</source>
        <translation>Monte Carlo, adaptativo</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Pruebas</translation>
    </message>
    <message>
        <source>Of the method monte-carlo.</source>
        <translation>Del método monte-carlo.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semilla</translation>
    </message>
    <message>
        <source>0 to 18446744073709551615, as text.</source>
        <translation>0 a 18446744073709551615, como texto.</translation>
    </message>
    <message>
        <source>Variance reduction</source>
        <translation>Reducción de la varianza</translation>
    </message>
    <message>
        <source>Makes each trial tell more; the gain is measured and stated with the result. Plain trials are those of JCGM 101.</source>
        <translation>Hace que cada prueba aporte más; la ganancia se mide y se indica con el resultado. Las pruebas simples son las de JCGM 101.</translation>
    </message>
    <message>
        <source>None: plain trials</source>
        <translation>Ninguna: pruebas simples</translation>
    </message>
    <message>
        <source>Control variate: the linear part</source>
        <translation>Variable de control: la parte lineal</translation>
    </message>
    <message>
        <source>Sobol points, scrambled</source>
        <translation>Puntos de Sobol, aleatorizados</translation>
    </message>
    <message>
        <source>Coverage probability</source>
        <translation>Probabilidad de cobertura</translation>
    </message>
    <message>
        <source>Of the expanded uncertainty, of intervals and regions.</source>
        <translation>De la incertidumbre expandida, de los intervalos y las regiones.</translation>
    </message>
    <message>
        <source>Coverage factor</source>
        <translation>Factor de cobertura</translation>
    </message>
    <message>
        <source>A fixed k for U = k u; absent: U by the effective degrees of freedom (law of propagation), or half of the coverage interval (Monte Carlo).</source>
        <translation>Un k fijo para U = k u; ausente: U con los grados de libertad efectivos (ley de propagación), o la mitad del intervalo de cobertura (Monte Carlo).</translation>
    </message>
    <message>
        <source>Second-order terms</source>
        <translation>Términos de segundo orden</translation>
    </message>
    <message>
        <source>Terms of second order of the law of propagation (JCGM 100 5.1.2).</source>
        <translation>Términos de segundo orden de la ley de propagación (JCGM 100 5.1.2).</translation>
    </message>
    <message>
        <source>Trials one at a time</source>
        <translation>Pruebas de una en una</translation>
    </message>
    <message>
        <source>Of Monte Carlo with all components but one kept constant, for each component; 0: none.</source>
        <translation>De Monte Carlo con todas las componentes constantes salvo una, para cada componente; 0: ninguna.</translation>
    </message>
    <message>
        <source>Trials by contributor</source>
        <translation>Pruebas por contribución</translation>
    </message>
    <message>
        <source>Of Monte Carlo without each contributor, and of it alone; 0: none.</source>
        <translation>De Monte Carlo sin cada contribución, y con ella sola; 0: ninguna.</translation>
    </message>
    <message>
        <source>Trials for Sobol indices</source>
        <translation>Pruebas para índices de Sobol</translation>
    </message>
    <message>
        <source>Pairs of trials for Sobol indices; 0: none.</source>
        <translation>Pares de pruebas para los índices de Sobol; 0: ninguno.</translation>
    </message>
    <message>
        <source>Significant digits</source>
        <translation>Cifras significativas</translation>
    </message>
    <message>
        <source>Of u, for the numerical tolerance of adaptive runs and of the validation (JCGM 101 7.9.2, 8).</source>
        <translation>De u, para la tolerancia numérica de las ejecuciones adaptativas y de la validación (JCGM 101 7.9.2, 8).</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancia</translation>
    </message>
    <message>
        <source>A quantity applies to the outputs of its dimension; a number to every output in its SI unit.</source>
        <translation>Una magnitud se aplica a las salidas de su dimensión; un número, a cada salida en su unidad SI.</translation>
    </message>
    <message>
        <source>Least number of batches</source>
        <translation>Número mínimo de lotes</translation>
    </message>
    <message>
        <source>Of an adaptive run, before it may stop.</source>
        <translation>De una ejecución adaptativa, antes de que pueda detenerse.</translation>
    </message>
    <message>
        <source>Most trials</source>
        <translation>Máximo de pruebas</translation>
    </message>
    <message>
        <source>At which an adaptive run stops in any case.</source>
        <translation>En el que una ejecución adaptativa se detiene en todo caso.</translation>
    </message>
    <message>
        <source>Certificate and laboratory</source>
        <translation>Certificado y laboratorio</translation>
    </message>
    <message>
        <source>Certificate number</source>
        <translation>Número de certificado</translation>
    </message>
    <message>
        <source>Unique; it stands on every page.</source>
        <translation>Único; figura en todas las páginas.</translation>
    </message>
    <message>
        <source>Laboratory</source>
        <translation>Laboratorio</translation>
    </message>
    <message>
        <source>That issues the certificate.</source>
        <translation>Que emite el certificado.</translation>
    </message>
    <message>
        <source>Address of the laboratory</source>
        <translation>Dirección del laboratorio</translation>
    </message>
    <message>
        <source>Street, town, country.</source>
        <translation>Calle, ciudad, país.</translation>
    </message>
    <message>
        <source>Country of the laboratory</source>
        <translation>País del laboratorio</translation>
    </message>
    <message>
        <source>Two capital letters (ISO 3166-1): DE. For a Digital Calibration Certificate.</source>
        <translation>Dos letras mayúsculas (ISO 3166-1): DE. Para un certificado de calibración digital.</translation>
    </message>
    <message>
        <source>Accreditation number</source>
        <translation>Número de acreditación</translation>
    </message>
    <message>
        <source>Absent: not accredited for this.</source>
        <translation>Ausente: no acreditado para esto.</translation>
    </message>
    <message>
        <source>Place of calibration</source>
        <translation>Lugar de calibración</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>Cliente</translation>
    </message>
    <message>
        <source>For whom it was done.</source>
        <translation>Para quién se realizó.</translation>
    </message>
    <message>
        <source>Address of the customer</source>
        <translation>Dirección del cliente</translation>
    </message>
    <message>
        <source>Item</source>
        <translation>Ítem</translation>
    </message>
    <message>
        <source>What was calibrated.</source>
        <translation>Lo que se calibró.</translation>
    </message>
    <message>
        <source>Manufacturer</source>
        <translation>Fabricante</translation>
    </message>
    <message>
        <source>Of the item.</source>
        <translation>Del ítem.</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>The manufacturer&apos;s name for it: model, size, class.</source>
        <translation>El nombre que le da el fabricante: modelo, tamaño, clase.</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Número de serie</translation>
    </message>
    <message>
        <source>By which the item is recognised, unless it has an identification.</source>
        <translation>Por el que se reconoce el ítem, salvo que tenga una identificación.</translation>
    </message>
    <message>
        <source>Identification</source>
        <translation>Identificación</translation>
    </message>
    <message>
        <source>The customer&apos;s mark, an inventory number.</source>
        <translation>La marca del cliente, un número de inventario.</translation>
    </message>
    <message>
        <source>Condition of the item</source>
        <translation>Estado del ítem</translation>
    </message>
    <message>
        <source>As it was received, where that matters.</source>
        <translation>Tal como se recibió, si es relevante.</translation>
    </message>
    <message>
        <source>Dates</source>
        <translation>Fechas</translation>
    </message>
    <message>
        <source>ISO 8601: 2026-04-17.</source>
        <translation>ISO 8601: 2026-04-17.</translation>
    </message>
    <message>
        <source>A date, or two of an interval: 2026-04-17/2026-04-18.</source>
        <translation>Una fecha, o dos de un intervalo: 2026-04-17/2026-04-18.</translation>
    </message>
    <message>
        <source>ISO 8601: 2026-04-20.</source>
        <translation>ISO 8601: 2026-04-20.</translation>
    </message>
    <message>
        <source>Procedure by which it was calibrated, with its edition.</source>
        <translation>Procedimiento con el que se calibró, con su edición.</translation>
    </message>
    <message>
        <source>Deviations from the method</source>
        <translation>Desviaciones del método</translation>
    </message>
    <message>
        <source>Additions, exclusions.</source>
        <translation>Adiciones, exclusiones.</translation>
    </message>
    <message>
        <source>Environmental conditions</source>
        <translation>Condiciones ambientales</translation>
    </message>
    <message>
        <source>Those that influence the results.</source>
        <translation>Las que influyen en los resultados.</translation>
    </message>
    <message>
        <source>Metrological traceability</source>
        <translation>Trazabilidad metrológica</translation>
    </message>
    <message>
        <source>To which references, by which certificates the results are traceable.</source>
        <translation>A qué referencias, mediante qué certificados son trazables los resultados.</translation>
    </message>
    <message>
        <source>Adjustment or repair</source>
        <translation>Ajuste o reparación</translation>
    </message>
    <message>
        <source>Results before and after it.</source>
        <translation>Resultados antes y después.</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Comentarios</translation>
    </message>
    <message>
        <source>Opinions and interpretations are marked as such (7.8.7).</source>
        <translation>Las opiniones e interpretaciones se identifican como tales (7.8.7).</translation>
    </message>
    <message>
        <source>Authorisation</source>
        <translation>Autorización</translation>
    </message>
    <message>
        <source>Authorised by</source>
        <translation>Autorizado por</translation>
    </message>
    <message>
        <source>The person who authorises the certificate.</source>
        <translation>La persona que autoriza el certificado.</translation>
    </message>
    <message>
        <source>Function</source>
        <translation>Cargo</translation>
    </message>
    <message>
        <source>Of that person in the laboratory.</source>
        <translation>De esa persona en el laboratorio.</translation>
    </message>
    <message>
        <source>Measurement model</source>
        <translation>Modelo de medición</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>Configuración</translation>
    </message>
    <message>
        <source>Input quantities</source>
        <translation>Magnitudes de entrada</translation>
    </message>
    <message>
        <source>Artefacts and instruments</source>
        <translation>Artefactos e instrumentos</translation>
    </message>
    <message>
        <source>Uncertainty budgets</source>
        <translation>Balances de incertidumbre</translation>
    </message>
    <message>
        <source>Sobol indices and contributors</source>
        <translation>Índices de Sobol y contribuciones</translation>
    </message>
    <message>
        <source>Evaluation of the set-up</source>
        <translation>Evaluación de la configuración</translation>
    </message>
    <message>
        <source>Law of propagation beside Monte Carlo</source>
        <translation>Ley de propagación junto a Monte Carlo</translation>
    </message>
    <message>
        <source>Joint coverage regions</source>
        <translation>Regiones de cobertura conjuntas</translation>
    </message>
    <message>
        <source>Distributions</source>
        <translation>Distribuciones</translation>
    </message>
    <message>
        <source>Set-up in space</source>
        <translation>Configuración en el espacio</translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation>Correlación</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Estudios</translation>
    </message>
    <message>
        <source>Designs</source>
        <translation>Diseños</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notas</translation>
    </message>
    <message>
        <source>Provenance</source>
        <translation>Procedencia</translation>
    </message>
    <message>
        <source>mean value</source>
        <translation>valor medio</translation>
    </message>
    <message>
        <source>standard deviation</source>
        <translation>desviación típica</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>escala</translation>
    </message>
    <message>
        <source>degrees of freedom</source>
        <translation>grados de libertad</translation>
    </message>
    <message>
        <source>lower limit</source>
        <translation>límite inferior</translation>
    </message>
    <message>
        <source>upper limit</source>
        <translation>límite superior</translation>
    </message>
    <message>
        <source>curvilinear trapezoid</source>
        <translation>trapezoidal curvilínea</translation>
    </message>
    <message>
        <source>inexactness of the limits</source>
        <translation>inexactitud de los límites</translation>
    </message>
    <message>
        <source>ratio of top to base</source>
        <translation>razón entre techo y base</translation>
    </message>
    <message>
        <source>shape</source>
        <translation>forma</translation>
    </message>
    <message>
        <source>truncated normal</source>
        <translation>normal truncada</translation>
    </message>
    <message>
        <source>lognormal</source>
        <translation>lognormal</translation>
    </message>
    <message>
        <source>mean value of the logarithm of the number in SI</source>
        <translation>valor medio del logaritmo del número en SI</translation>
    </message>
    <message>
        <source>standard deviation of the logarithm</source>
        <translation>desviación típica del logaritmo</translation>
    </message>
    <message>
        <source>parameter alpha</source>
        <translation>parámetro alpha</translation>
    </message>
    <message>
        <source>parameter beta</source>
        <translation>parámetro beta</translation>
    </message>
    <message>
        <source>discrete</source>
        <translation>discreta</translation>
    </message>
    <message>
        <source>SpatialAnalyzer points (ASCII)</source>
        <translation>Puntos de SpatialAnalyzer (ASCII)</translation>
    </message>
    <message>
        <source>Table of points</source>
        <translation>Tabla de puntos</translation>
    </message>
    <message>
        <source>Digital Calibration Certificate</source>
        <translation>Certificado de calibración digital</translation>
    </message>
    <message>
        <source>Leica GSI-8 and GSI-16</source>
        <translation>Leica GSI-8 y GSI-16</translation>
    </message>
    <message>
        <source>GNU Gama network</source>
        <translation>Red de GNU Gama</translation>
    </message>
    <message>
        <source>Comp3D coordinates</source>
        <translation>Coordenadas de Comp3D</translation>
    </message>
    <message>
        <source>Comp3D observations</source>
        <translation>Observaciones de Comp3D</translation>
    </message>
    <message>
        <source>Uncertainty budget in Excel</source>
        <translation>Balance de incertidumbre en Excel</translation>
    </message>
    <message>
        <source>GUM Workbench</source>
        <translation>GUM Workbench</translation>
    </message>
    <message>
        <source>Suncal project</source>
        <translation>Proyecto de Suncal</translation>
    </message>
    <message>
        <source>OptiTrack Motive tracking data</source>
        <translation>Datos de seguimiento de OptiTrack Motive</translation>
    </message>
    <message>
        <source>Kinematic calibration of a UR robot (ROS)</source>
        <translation>Calibración cinemática de un robot UR (ROS)</translation>
    </message>
    <message>
        <source>Point list with Ux Uy Uz (SpatialAnalyzer ASCII)</source>
        <translation>Lista de puntos con Ux Uy Uz (SpatialAnalyzer ASCII)</translation>
    </message>
    <message>
        <source>Digital Calibration Certificate 3.2.1</source>
        <translation>Certificado de calibración digital 3.2.1</translation>
    </message>
    <message>
        <source>Excel workbook</source>
        <translation>Libro de Excel</translation>
    </message>
    <message>
        <source>Robot description (URDF)</source>
        <translation>Descripción de robot (URDF)</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grupo</translation>
    </message>
    <message>
        <source>The pose, point or target the quantity belongs to</source>
        <translation>La pose, el punto o la diana a que pertenece la magnitud</translation>
    </message>
    <message>
        <source>Output quantity</source>
        <translation>Magnitud de salida</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>Estimación</translation>
    </message>
    <message>
        <source>Best value of the output quantity</source>
        <translation>Mejor valor de la magnitud de salida</translation>
    </message>
    <message>
        <source>Standard uncertainty</source>
        <translation>Incertidumbre típica</translation>
    </message>
    <message>
        <source>Coverage factor. U = k u with k of the t distribution for the effective degrees of freedom.</source>
        <translation>Factor de cobertura. U = k u con k de la distribución t para los grados de libertad efectivos.</translation>
    </message>
    <message>
        <source>Expanded uncertainty. U = k u with k of the t distribution for the effective degrees of freedom.</source>
        <translation>Incertidumbre expandida. U = k u con k de la distribución t para los grados de libertad efectivos.</translation>
    </message>
    <message>
        <source>Limit of the shortest coverage interval</source>
        <translation>Límite del intervalo de cobertura más corto</translation>
    </message>
    <message>
        <source>Estimate (first order)</source>
        <translation>Estimación (primer orden)</translation>
    </message>
    <message>
        <source>By the law of propagation of uncertainty</source>
        <translation>Por la ley de propagación de la incertidumbre</translation>
    </message>
    <message>
        <source>u (first order)</source>
        <translation>u (primer orden)</translation>
    </message>
    <message>
        <source>Effective degrees of freedom (JCGM 100 G.4)</source>
        <translation>Grados de libertad efectivos (JCGM 100 G.4)</translation>
    </message>
    <message>
        <source>U (first order)</source>
        <translation>U (primer orden)</translation>
    </message>
    <message>
        <source>First order validated</source>
        <translation>Primer orden validado</translation>
    </message>
    <message>
        <source>JCGM 101 clause 8: agrees with Monte Carlo within the tolerance</source>
        <translation>JCGM 101 apartado 8: concuerda con Monte Carlo dentro de la tolerancia</translation>
    </message>
    <message>
        <source>u (second order)</source>
        <translation>u (segundo orden)</translation>
    </message>
    <message>
        <source>With the second-order terms of JCGM 100 5.1.2; for information</source>
        <translation>Con los términos de segundo orden de JCGM 100 5.1.2; a título informativo</translation>
    </message>
    <message>
        <source>shift (second order)</source>
        <translation>desplazamiento (segundo orden)</translation>
    </message>
    <message>
        <source>What the curvature of the equation adds to the estimate; for information, not added</source>
        <translation>Lo que la curvatura de la ecuación añade a la estimación; a título informativo, no se suma</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Objetivo</translation>
    </message>
    <message>
        <source>Target uncertainty that is required</source>
        <translation>Incertidumbre objetivo que se exige</translation>
    </message>
    <message>
        <source>U / target</source>
        <translation>U / objetivo</translation>
    </message>
    <message>
        <source>Expanded uncertainty as a part of its target: above 1 the target is not met</source>
        <translation>Incertidumbre expandida como fracción de su objetivo: por encima de 1 no se cumple el objetivo</translation>
    </message>
    <message>
        <source>Requirement</source>
        <translation>Requisito</translation>
    </message>
    <message>
        <source>Whether the target uncertainty is met and the value is accepted</source>
        <translation>Si se cumple la incertidumbre objetivo y se acepta el valor</translation>
    </message>
    <message>
        <source>Input quantity</source>
        <translation>Magnitud de entrada</translation>
    </message>
    <message>
        <source>Component of uncertainty</source>
        <translation>Componente de incertidumbre</translation>
    </message>
    <message>
        <source>Of the component&apos;s u</source>
        <translation>De la u de la componente</translation>
    </message>
    <message>
        <source>Standard uncertainty of the component</source>
        <translation>Incertidumbre típica de la componente</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Distribución</translation>
    </message>
    <message>
        <source>Type A or Type B evaluation (JCGM 100 2.3.2, 2.3.3)</source>
        <translation>Evaluación de Tipo A o de Tipo B (JCGM 100 2.3.2, 2.3.3)</translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation>Grados de libertad</translation>
    </message>
    <message>
        <source>Sensitivity coefficient, unit of the output quantity per unit of the component</source>
        <translation>Coeficiente de sensibilidad, unidad de la magnitud de salida por unidad de la componente</translation>
    </message>
    <message>
        <source>|c|·u</source>
        <translation>|c|·u</translation>
    </message>
    <message>
        <source>Contribution to the standard uncertainty</source>
        <translation>Contribución a la incertidumbre típica</translation>
    </message>
    <message>
        <source>Share / %</source>
        <translation>Parte / %</translation>
    </message>
    <message>
        <source>Of the variance, with its part of the covariances</source>
        <translation>De la varianza, con su parte de las covarianzas</translation>
    </message>
    <message>
        <source>u one at a time</source>
        <translation>u de una en una</translation>
    </message>
    <message>
        <source>By Monte Carlo with every other component kept constant</source>
        <translation>Por Monte Carlo con todas las demás componentes constantes</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Origen</translation>
    </message>
    <message>
        <source>Where the figure comes from</source>
        <translation>De dónde procede la cifra</translation>
    </message>
    <message>
        <source>In</source>
        <translation>En</translation>
    </message>
    <message>
        <source>Whether both results have the quantity</source>
        <translation>Si ambos resultados tienen la magnitud</translation>
    </message>
    <message>
        <source>U before</source>
        <translation>U antes</translation>
    </message>
    <message>
        <source>Expanded uncertainty</source>
        <translation>Incertidumbre expandida</translation>
    </message>
    <message>
        <source>U after</source>
        <translation>U después</translation>
    </message>
    <message>
        <source>Change of U in %</source>
        <translation>Cambio de U en %</translation>
    </message>
    <message>
        <source>Change of the expanded uncertainty, in per cent of that before</source>
        <translation>Cambio de la incertidumbre expandida, en tanto por ciento de la anterior</translation>
    </message>
    <message>
        <source>Estimate before</source>
        <translation>Estimación antes</translation>
    </message>
    <message>
        <source>Estimate after</source>
        <translation>Estimación después</translation>
    </message>
    <message>
        <source>Change of estimate</source>
        <translation>Cambio de la estimación</translation>
    </message>
    <message>
        <source>Estimate after less estimate before</source>
        <translation>Estimación después menos estimación antes</translation>
    </message>
    <message>
        <source>u before</source>
        <translation>u antes</translation>
    </message>
    <message>
        <source>u after</source>
        <translation>u después</translation>
    </message>
    <message>
        <source>k before</source>
        <translation>k antes</translation>
    </message>
    <message>
        <source>k after</source>
        <translation>k después</translation>
    </message>
    <message>
        <source>Changed, the same, new, or gone</source>
        <translation>Modificada, igual, nueva o desaparecida</translation>
    </message>
    <message>
        <source>|c|·u before</source>
        <translation>|c|·u antes</translation>
    </message>
    <message>
        <source>|c|·u after</source>
        <translation>|c|·u después</translation>
    </message>
    <message>
        <source>Share before / %</source>
        <translation>Parte antes / %</translation>
    </message>
    <message>
        <source>Of the variance before</source>
        <translation>De la varianza antes</translation>
    </message>
    <message>
        <source>Share after / %</source>
        <translation>Parte después / %</translation>
    </message>
    <message>
        <source>Of the variance after</source>
        <translation>De la varianza después</translation>
    </message>
    <message>
        <source>Change of variance / %</source>
        <translation>Cambio de varianza / %</translation>
    </message>
    <message>
        <source>By how much this component changes the variance of the output, in per cent of the whole variance before; the rows add up to the change of the whole</source>
        <translation>Cuánto cambia esta componente la varianza de la salida, en tanto por ciento de la varianza total anterior; las filas suman el cambio total</translation>
    </message>
    <message>
        <source>met</source>
        <translation>cumplido</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>no cumplido</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sí</translation>
    </message>
    <message>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <source>gamma</source>
        <translation>gamma</translation>
    </message>
    <message>
        <source>beta</source>
        <translation>beta</translation>
    </message>
    <message>
        <source>Coverage factor. U = k u with the coverage factor that was fixed.</source>
        <translation>Factor de cobertura. U = k u con el factor de cobertura que se fijó.</translation>
    </message>
    <message>
        <source>Expanded uncertainty. U = k u with the coverage factor that was fixed.</source>
        <translation>Incertidumbre expandida. U = k u con el factor de cobertura que se fijó.</translation>
    </message>
    <message>
        <source>Coverage factor. U is half the width of the probabilistically symmetric coverage interval, and k = U/u.</source>
        <translation>Factor de cobertura. U es la mitad de la anchura del intervalo de cobertura probabilísticamente simétrico, y k = U/u.</translation>
    </message>
    <message>
        <source>Expanded uncertainty. U is half the width of the probabilistically symmetric coverage interval, and k = U/u.</source>
        <translation>Incertidumbre expandida. U es la mitad de la anchura del intervalo de cobertura probabilísticamente simétrico, y k = U/u.</translation>
    </message>
    <message>
        <source>Target uncertainty</source>
        <translation>Incertidumbre objetivo</translation>
    </message>
    <message>
        <source>The expanded uncertainty U must not exceed this.</source>
        <translation>La incertidumbre expandida U no debe superar este valor.</translation>
    </message>
    <message>
        <source>Lower limit</source>
        <translation>Límite inferior</translation>
    </message>
    <message>
        <source>Of the tolerance; empty: none.</source>
        <translation>De la tolerancia; vacío: ninguno.</translation>
    </message>
    <message>
        <source>Upper limit</source>
        <translation>Límite superior</translation>
    </message>
    <message>
        <source>Guard factor</source>
        <translation>Factor de guarda</translation>
    </message>
    <message>
        <source>Guard bands of this times U inside the tolerance: 1 proves conformity (ISO 14253-1), 0 is simple acceptance, negative values favour the producer.</source>
        <translation>Bandas de guarda de tantas U dentro de la tolerancia: 1 demuestra la conformidad (ISO 14253-1), 0 es aceptación simple, los valores negativos favorecen al productor.</translation>
    </message>
    <message>
        <source>Prior mean</source>
        <translation>Media a priori</translation>
    </message>
    <message>
        <source>What is known of such quantities before the measurement, as a normal distribution (the production process): for the global risks of JCGM 106.</source>
        <translation>Lo que se sabe de tales magnitudes antes de la medición, como distribución normal (el proceso de producción): para los riesgos globales de JCGM 106.</translation>
    </message>
    <message>
        <source>Prior standard deviation</source>
        <translation>Desviación típica a priori</translation>
    </message>
    <message>
        <source>Of the production process.</source>
        <translation>Del proceso de producción.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>Logo</source>
        <translation>Logotipo</translation>
    </message>
    <message>
        <source>A PNG or JPEG file beside the project, up to 2 MB: at the head of the first page.</source>
        <translation>Un archivo PNG o JPEG junto al proyecto, hasta 2 MB: en la cabecera de la primera página.</translation>
    </message>
    <message>
        <source>Calibration certificate %1</source>
        <translation>Certificado de calibración %1</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Página %1 de %2</translation>
    </message>
    <message>
        <source>— not stated —</source>
        <translation>— no indicado —</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>in the laboratory</source>
        <translation>en el laboratorio</translation>
    </message>
    <message>
        <source>This certificate states %1 of %2 results. Not stated: %3.</source>
        <translation>Este certificado indica %1 de %2 resultados. No indicados: %3.</translation>
    </message>
    <message>
        <source>1 further result is in the digital certificate that is attached to the PDF (certificate.xml).</source>
        <translation>1 resultado más está en el certificado digital adjunto al PDF (certificate.xml).</translation>
    </message>
    <message>
        <source>%1 further results are in the digital certificate that is attached to the PDF (certificate.xml).</source>
        <translation>%1 resultados más están en el certificado digital adjunto al PDF (certificate.xml).</translation>
    </message>
    <message>
        <source>Not evaluated: %1.</source>
        <translation>No evaluado: %1.</translation>
    </message>
    <message>
        <source>Evaluated with Covaria %1, project fingerprint %2.</source>
        <translation>Evaluado con Covaria %1, huella del proyecto %2.</translation>
    </message>
    <message>
        <source>Evaluated with Covaria %1, project fingerprint %2, analyses: %3.</source>
        <translation>Evaluado con Covaria %1, huella del proyecto %2, análisis: %3.</translation>
    </message>
    <message>
        <source>The results relate only to the item described above, in the state in which it was calibrated. This certificate may be reproduced in full only, unless the laboratory permits otherwise.</source>
        <translation>Los resultados se refieren únicamente al objeto descrito arriba, en el estado en que fue calibrado. Este certificado solo puede reproducirse íntegramente, salvo autorización del laboratorio.</translation>
    </message>
    <message>
        <source>Date of issue: %1</source>
        <translation>Fecha de emisión: %1</translation>
    </message>
    <message>
        <source>End of certificate</source>
        <translation>Fin del certificado</translation>
    </message>
    <message>
        <source>End of certificate %1</source>
        <translation>Fin del certificado %1</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>p = %1 to %2.</source>
        <translation>p = %1 a %2.</translation>
    </message>
    <message>
        <source>No result is stated: what was evaluated does not represent the measurand; %1 trials have no value.</source>
        <translation>No se indica ningún resultado: lo evaluado no representa el mensurando; %1 pruebas no tienen valor.</translation>
    </message>
    <message>
        <source>Coverage intervals that are not symmetric about the estimate: %1.</source>
        <translation>Intervalos de cobertura que no son simétricos respecto a la estimación: %1.</translation>
    </message>
    <message>
        <source>Coverage intervals that are not symmetric about the estimate: %1; and %2 others.</source>
        <translation>Intervalos de cobertura que no son simétricos respecto a la estimación: %1; y otros %2.</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>%1 (exact)</source>
        <translation>%1 (exacto)</translation>
    </message>
    <message>
        <source>%1 (U not finite)</source>
        <translation>%1 (U no finita)</translation>
    </message>
    <message>
        <source>without k, because u is not finite</source>
        <translation>sin k, porque u no es finita</translation>
    </message>
    <message>
        <source>coverage interval %1</source>
        <translation>intervalo de cobertura %1</translation>
    </message>
    <message>
        <source>The standard uncertainty was determined by the law of propagation of uncertainty in accordance with JCGM 100.</source>
        <translation>La incertidumbre típica se determinó por la ley de propagación de la incertidumbre conforme a JCGM 100.</translation>
    </message>
    <message>
        <source>The distribution was determined by the propagation of distributions in accordance with JCGM 101.</source>
        <translation>La distribución se determinó por propagación de distribuciones conforme a JCGM 101.</translation>
    </message>
    <message>
        <source>The expanded uncertainty U stated after ± is the standard uncertainty multiplied by the fixed coverage factor k; y ± U has the coverage probability p that is stated with it.</source>
        <translation>La incertidumbre expandida U indicada tras ± es la incertidumbre típica multiplicada por el factor de cobertura fijo k; y ± U tiene la probabilidad de cobertura p que se indica con ella.</translation>
    </message>
    <message>
        <source>The expanded uncertainty U stated after ± is half the width of the probabilistically symmetric coverage interval of the coverage probability p, and k = U/u.</source>
        <translation>La incertidumbre expandida U indicada tras ± es la mitad de la anchura del intervalo de cobertura probabilísticamente simétrico de probabilidad de cobertura p, y k = U/u.</translation>
    </message>
    <message>
        <source>The expanded uncertainty U stated after ± is the standard uncertainty multiplied by the coverage factor k, which for a normal distribution, or for a t distribution of the effective degrees of freedom nu_eff where they are stated, corresponds to the coverage probability p.</source>
        <translation>La incertidumbre expandida U indicada tras ± es la incertidumbre típica multiplicada por el factor de cobertura k, que para una distribución normal, o para una distribución t con los grados efectivos de libertad nu_eff donde se indican, corresponde a la probabilidad de cobertura p.</translation>
    </message>
    <message>
        <source>Statement of conformity</source>
        <translation>Declaración de conformidad</translation>
    </message>
    <message>
        <source>Acceptance</source>
        <translation>Aceptación</translation>
    </message>
    <message>
        <source>Decision rule</source>
        <translation>Regla de decisión</translation>
    </message>
    <message>
        <source>Decision</source>
        <translation>Decisión</translation>
    </message>
    <message>
        <source>Conforming</source>
        <translation>Conforme</translation>
    </message>
    <message>
        <source>by</source>
        <translation>por</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>no evaluado</translation>
    </message>
    <message>
        <source>trials</source>
        <translation>pruebas</translation>
    </message>
    <message>
        <source>JCGM 106: probability that the measurand lies inside the tolerance, by the distribution of the result: its trials, or by the law of propagation Student&apos;s t for the effective degrees of freedom. The acceptance interval is the tolerance less guard bands w. Decision rules are named as in ILAC-G8:09/2019. TUR: half of the tolerance over U. C_m: T/(2U) for U = 2u, T/(4u).</source>
        <translation>JCGM 106: probabilidad de que el mensurando esté dentro de la tolerancia, según la distribución del resultado: sus pruebas o, con la ley de propagación, la t de Student con los grados efectivos de libertad. El intervalo de aceptación es la tolerancia menos las bandas de guarda w. Las reglas de decisión se nombran como en ILAC-G8:09/2019. TUR: mitad de la tolerancia dividida por U. C_m: T/(2U) para U = 2u, T/(4u).</translation>
    </message>
    <message>
        <source>simple acceptance (w = 0)</source>
        <translation>aceptación simple (w = 0)</translation>
    </message>
    <message>
        <source>guard band w = %1</source>
        <translation>banda de guarda w = %1</translation>
    </message>
    <message>
        <source>guarded rejection (w = −%1)</source>
        <translation>rechazo con guarda (w = −%1)</translation>
    </message>
    <message>
        <source>Results before and after</source>
        <translation>Resultados antes y después</translation>
    </message>
    <message>
        <source>Context mesh</source>
        <translation>Malla de contexto</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Malla</translation>
    </message>
    <message>
        <source>STL file</source>
        <translation>Archivo STL</translation>
    </message>
    <message>
        <source>A binary or ASCII STL file beside the project, up to 200 MB and 5 million triangles. It is drawn in the scenes of all analyses and influences no number.</source>
        <translation>Un archivo STL binario o ASCII junto al proyecto, de hasta 200 MB y 5 millones de triángulos. Se dibuja en las escenas de todos los análisis y no influye en ningún número.</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>Unidad del archivo</translation>
    </message>
    <message>
        <source>STL files do not say in which unit their numbers are.</source>
        <translation>Los archivos STL no indican en qué unidad están sus números.</translation>
    </message>
    <message>
        <source>millimetre</source>
        <translation>milímetro</translation>
    </message>
    <message>
        <source>metre</source>
        <translation>metro</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>pulgada</translation>
    </message>
    <message>
        <source>Position and orientation</source>
        <translation>Posición y orientación</translation>
    </message>
    <message>
        <source>Where the origin of the file stands in the world frame, and how its axes are turned.</source>
        <translation>Dónde está el origen del archivo en el sistema global y cómo están girados sus ejes.</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Aspecto</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Of the surface, on a light and on a dark ground.</source>
        <translation>De la superficie, sobre fondo claro y sobre fondo oscuro.</translation>
    </message>
    <message>
        <source>grey</source>
        <translation>gris</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>azul</translation>
    </message>
    <message>
        <source>green</source>
        <translation>verde</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>naranja</translation>
    </message>
    <message>
        <source>red</source>
        <translation>rojo</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidad</translation>
    </message>
    <message>
        <source>100 % hides what is behind the surface; less lets the measured points be seen.</source>
        <translation>100 % oculta lo que hay detrás de la superficie; con menos se ven los puntos medidos.</translation>
    </message>
    <message>
        <source>largest U/target</source>
        <translation>mayor U/objetivo</translation>
    </message>
    <message>
        <source>largest U relative to the present design</source>
        <translation>mayor U respecto al diseño actual</translation>
    </message>
    <message>
        <source>mean U/target</source>
        <translation>media de U/objetivo</translation>
    </message>
    <message>
        <source>mean U relative to the present design</source>
        <translation>media de U respecto al diseño actual</translation>
    </message>
    <message>
        <source>root mean square of U/target</source>
        <translation>media cuadrática de U/objetivo</translation>
    </message>
    <message>
        <source>root mean square of U relative to the present design</source>
        <translation>media cuadrática de U respecto al diseño actual</translation>
    </message>
    <message>
        <source>Monte Carlo</source>
        <translation>Monte Carlo</translation>
    </message>
    <message>
        <source>Run Monte Carlo to see the distribution of %1</source>
        <translation>Ejecute Monte Carlo para ver la distribución de %1</translation>
    </message>
    <message>
        <source>Run Monte Carlo to see the quantiles of %1</source>
        <translation>Ejecute Monte Carlo para ver los cuantiles de %1</translation>
    </message>
    <message>
        <source>Run Monte Carlo with more trials to see the distribution of %1</source>
        <translation>Ejecute Monte Carlo con más pruebas para ver la distribución de %1</translation>
    </message>
    <message>
        <source>Run Monte Carlo with more trials to see the quantiles of %1</source>
        <translation>Ejecute Monte Carlo con más pruebas para ver los cuantiles de %1</translation>
    </message>
    <message>
        <source>%1 has the same value in every trial: give its inputs components of uncertainty</source>
        <translation>%1 tiene el mismo valor en todas las pruebas: dé componentes de incertidumbre a sus magnitudes de entrada</translation>
    </message>
    <message>
        <source>Distribution of %1</source>
        <translation>Distribución de %1</translation>
    </message>
    <message>
        <source>probability density</source>
        <translation>densidad de probabilidad</translation>
    </message>
    <message>
        <source>normal, same mean and u</source>
        <translation>normal, misma media y misma u</translation>
    </message>
    <message>
        <source>normal, same interval</source>
        <translation>normal, mismo intervalo</translation>
    </message>
    <message>
        <source>normal, first order</source>
        <translation>normal, primer orden</translation>
    </message>
    <message>
        <source>Student t, first order</source>
        <translation>t de Student, primer orden</translation>
    </message>
    <message>
        <source>%1 coverage interval</source>
        <translation>intervalo de cobertura del %1</translation>
    </message>
    <message>
        <source>mean %1</source>
        <translation>media %1</translation>
    </message>
    <message>
        <source>Normal quantiles of %1</source>
        <translation>Cuantiles normales de %1</translation>
    </message>
    <message>
        <source>quantile of the standard normal distribution</source>
        <translation>cuantil de la distribución normal estándar</translation>
    </message>
    <message>
        <source>quantile of %1</source>
        <translation>cuantil de %1</translation>
    </message>
    <message>
        <source>No input quantity with an uncertainty influences %1: give its inputs components of uncertainty</source>
        <translation>Ninguna magnitud de entrada con incertidumbre influye en %1: dé componentes de incertidumbre a sus magnitudes de entrada</translation>
    </message>
    <message>
        <source>Contributions to u(%1)</source>
        <translation>Contribuciones a u(%1)</translation>
    </message>
    <message>
        <source>first order</source>
        <translation>primer orden</translation>
    </message>
    <message>
        <source>one at a time, Monte Carlo</source>
        <translation>de una en una, Monte Carlo</translation>
    </message>
    <message>
        <source>%1 others</source>
        <translation>otras %1</translation>
    </message>
    <message>
        <source>A single output quantity has nothing to be correlated with</source>
        <translation>Una sola magnitud de salida no tiene con qué correlacionarse</translation>
    </message>
    <message>
        <source>Correlation coefficients</source>
        <translation>Coeficientes de correlación</translation>
    </message>
    <message>
        <source>correlation coefficient</source>
        <translation>coeficiente de correlación</translation>
    </message>
    <message>
        <source>Run Monte Carlo to see how u of %1 settles</source>
        <translation>Ejecute Monte Carlo para ver cómo se estabiliza u de %1</translation>
    </message>
    <message>
        <source>%1, against the number of trials</source>
        <translation>%1 frente al número de pruebas</translation>
    </message>
    <message>
        <source>%1 (not stabilised)</source>
        <translation>%1 (no estabilizada)</translation>
    </message>
    <message>
        <source>± 2 standard errors</source>
        <translation>± 2 errores estándar</translation>
    </message>
    <message>
        <source>final u %1</source>
        <translation>u final %1</translation>
    </message>
    <message>
        <source>before</source>
        <translation>antes</translation>
    </message>
    <message>
        <source>after</source>
        <translation>después</translation>
    </message>
    <message>
        <source>Distributions of %1</source>
        <translation>Distribuciones de %1</translation>
    </message>
    <message>
        <source>The output quantity has no distribution to show</source>
        <translation>La magnitud de salida no tiene distribución que mostrar</translation>
    </message>
    <message>
        <source>Only one of the results has %1</source>
        <translation>Solo uno de los resultados tiene %1</translation>
    </message>
    <message>
        <source>The budget of %1 has not changed</source>
        <translation>El balance de %1 no ha cambiado</translation>
    </message>
    <message>
        <source>Changes of the budget of %1</source>
        <translation>Cambios del balance de %1</translation>
    </message>
    <message>
        <source>uncertainty</source>
        <translation>incertidumbre</translation>
    </message>
    <message>
        <source>as set up: %1</source>
        <translation>como está configurado: %1</translation>
    </message>
    <message>
        <source>%1 at %2 = %3</source>
        <translation>%1 en %2 = %3</translation>
    </message>
    <message>
        <source>Run the study “%1” to see it</source>
        <translation>Ejecute el estudio «%1» para verlo</translation>
    </message>
    <message>
        <source>No grid point of “%1” has values: %2</source>
        <translation>Ningún punto de la malla de «%1» tiene valores: %2</translation>
    </message>
    <message>
        <source>Uncertainties before and after</source>
        <translation>Incertidumbres antes y después</translation>
    </message>
    <message>
        <source>U relative to the present design</source>
        <translation>U respecto al diseño actual</translation>
    </message>
    <message>
        <source>designed</source>
        <translation>diseño</translation>
    </message>
    <message>
        <source>What more rows give</source>
        <translation>Qué aportan más filas</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>filas</translation>
    </message>
    <message>
        <source>best found</source>
        <translation>el mejor hallado</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>conservadas</translation>
    </message>
    <message>
        <source>What each row kept is worth</source>
        <translation>Cuánto vale cada fila conservada</translation>
    </message>
    <message>
        <source>What a smaller uncertainty costs</source>
        <translation>Cuánto cuesta una incertidumbre menor</translation>
    </message>
    <message>
        <source>largest U / target</source>
        <translation>mayor U / objetivo</translation>
    </message>
    <message>
        <source>cost</source>
        <translation>coste</translation>
    </message>
    <message>
        <source>cheapest reductions</source>
        <translation>reducciones más baratas</translation>
    </message>
    <message>
        <source>cheapest rows</source>
        <translation>filas más baratas</translation>
    </message>
    <message>
        <source>targets</source>
        <translation>objetivos</translation>
    </message>
    <message>
        <source>The way of the search</source>
        <translation>El camino de la búsqueda</translation>
    </message>
    <message>
        <source>evaluations</source>
        <translation>evaluaciones</translation>
    </message>
    <message>
        <source>best so far</source>
        <translation>el mejor hasta ahora</translation>
    </message>
    <message>
        <source>both</source>
        <translation>en ambos</translation>
    </message>
    <message>
        <source>only before</source>
        <translation>solo antes</translation>
    </message>
    <message>
        <source>only after</source>
        <translation>solo después</translation>
    </message>
    <message>
        <source>new</source>
        <translation>nueva</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>eliminada</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>cambiada</translation>
    </message>
    <message>
        <source>same</source>
        <translation>igual</translation>
    </message>
    <message>
        <source>number of trials</source>
        <translation>número de pruebas</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Cámaras</translation>
    </message>
    <message>
        <source>Coordinate measuring machines and arms</source>
        <translation>Máquinas y brazos de medición por coordenadas</translation>
    </message>
    <message>
        <source>Distance meters</source>
        <translation>Distanciómetros</translation>
    </message>
    <message>
        <source>Laser scanners</source>
        <translation>Escáneres láser</translation>
    </message>
    <message>
        <source>Laser trackers</source>
        <translation>Seguidores láser</translation>
    </message>
    <message>
        <source>Length standards and ballbars</source>
        <translation>Patrones de longitud y barras de bolas</translation>
    </message>
    <message>
        <source>Robot arms</source>
        <translation>Brazos robóticos</translation>
    </message>
    <message>
        <source>Total stations</source>
        <translation>Estaciones totales</translation>
    </message>
    <message>
        <source>Uncertainty budget of a measured point</source>
        <translation>Balance de incertidumbre de un punto medido</translation>
    </message>
    <message>
        <source>Errors of indication (Eq 1)</source>
        <translation>Errores de indicación (ec. 1)</translation>
    </message>
    <message>
        <source>Errors of indication (Eq 4)</source>
        <translation>Errores de indicación (ec. 4)</translation>
    </message>
    <message>
        <source>Standard uncertainty of one reading, along and across the line of sight</source>
        <translation>Incertidumbre estándar de una lectura, a lo largo y a través de la visual</translation>
    </message>
    <message>
        <source>across, by azimuth</source>
        <translation>a través, por el acimut</translation>
    </message>
    <message>
        <source>across, by elevation</source>
        <translation>a través, por la elevación</translation>
    </message>
    <message>
        <source>along</source>
        <translation>a lo largo</translation>
    </message>
    <message>
        <source>Standard uncertainty by the readings alone, and with the stations</source>
        <translation>Incertidumbre estándar solo por las lecturas y con las estaciones</translation>
    </message>
    <message>
        <source>readings alone (Eq 5)</source>
        <translation>solo lecturas (ec. 5)</translation>
    </message>
    <message>
        <source>readings and shared deviations, first order</source>
        <translation>lecturas y desviaciones comunes, primer orden</translation>
    </message>
    <message>
        <source>Parameters and their uncertainty</source>
        <translation>Parámetros y su incertidumbre</translation>
    </message>
    <message>
        <source>u, section 4.1</source>
        <translation>u, sección 4.1</translation>
    </message>
    <message>
        <source>U = 2 u</source>
        <translation>U = 2 u</translation>
    </message>
    <message>
        <source>value − U</source>
        <translation>valor − U</translation>
    </message>
    <message>
        <source>value + U</source>
        <translation>valor + U</translation>
    </message>
    <message>
        <source>u, Table 1</source>
        <translation>u, tabla 1</translation>
    </message>
    <message>
        <source>u, repeatability</source>
        <translation>u, repetibilidad</translation>
    </message>
    <message>
        <source>u, sampling</source>
        <translation>u, muestreo</translation>
    </message>
    <message>
        <source>u, range</source>
        <translation>u, intervalo</translation>
    </message>
    <message>
        <source>Identified parameters beside the nominal ones</source>
        <translation>Parámetros identificados junto a los nominales</translation>
    </message>
    <message>
        <source>nominal</source>
        <translation>nominal</translation>
    </message>
    <message>
        <source>identified</source>
        <translation>identificado</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>diferencia</translation>
    </message>
    <message>
        <source>What these points cannot tell</source>
        <translation>Lo que estos puntos no pueden decir</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>motivo</translation>
    </message>
    <message>
        <source>Observability</source>
        <translation>Observabilidad</translation>
    </message>
    <message>
        <source>Strongest correlation of each unknown</source>
        <translation>Correlación más fuerte de cada incógnita</translation>
    </message>
    <message>
        <source>Residuals of the fit, measured less calculated</source>
        <translation>Residuos del ajuste, medido menos calculado</translation>
    </message>
    <message>
        <source>pose</source>
        <translation>pose</translation>
    </message>
    <message>
        <source>largest over its u</source>
        <translation>mayor dividido por su u</translation>
    </message>
    <message>
        <source>outlier test</source>
        <translation>prueba de valores atípicos</translation>
    </message>
    <message>
        <source>Poses held back from the fit, calculated less measured</source>
        <translation>Poses reservadas del ajuste, calculado menos medido</translation>
    </message>
    <message>
        <source>nominal, distance</source>
        <translation>nominal, distancia</translation>
    </message>
    <message>
        <source>U (k = 2), largest</source>
        <translation>U (k = 2), mayor</translation>
    </message>
    <message>
        <source>E_n, largest</source>
        <translation>E_n, mayor</translation>
    </message>
    <message>
        <source>Circles of the joints</source>
        <translation>Círculos de las articulaciones</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>arco</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>radio</translation>
    </message>
    <message>
        <source>rms along the radius</source>
        <translation>rms a lo largo del radio</translation>
    </message>
    <message>
        <source>rms off the plane</source>
        <translation>rms fuera del plano</translation>
    </message>
    <message>
        <source>Readings and places of the poses, without uncertainty</source>
        <translation>Lecturas y lugares de las poses, sin incertidumbre</translation>
    </message>
    <message>
        <source>Relative uncertainty of the loads</source>
        <translation>Incertidumbre relativa de las cargas</translation>
    </message>
    <message>
        <source>Calibration as planned and as read</source>
        <translation>Calibración prevista y leída</translation>
    </message>
    <message>
        <source>preloads</source>
        <translation>precargas</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>series</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>escalones</translation>
    </message>
    <message>
        <source>decreasing steps</source>
        <translation>escalones decrecientes</translation>
    </message>
    <message>
        <source>spread of the preloads</source>
        <translation>dispersión de las precargas</translation>
    </message>
    <message>
        <source>Rated output and non-zero error of each sensor (Kim, Table 1)</source>
        <translation>Salida nominal y error de cero de cada sensor (Kim, tabla 1)</translation>
    </message>
    <message>
        <source>rated load</source>
        <translation>carga nominal</translation>
    </message>
    <message>
        <source>Interference error of each sensor (Kim, Table 2)</source>
        <translation>Error de interferencia de cada sensor (Kim, tabla 2)</translation>
    </message>
    <message>
        <source>Uncertainty of the sensors by the paper (Kim, Table 3, Eqs 4 to 12)</source>
        <translation>Incertidumbre de los sensores según el artículo (Kim, tabla 3, ecs. 4 a 12)</translation>
    </message>
    <message>
        <source>U, load</source>
        <translation>U, carga</translation>
    </message>
    <message>
        <source>Interference error in per cent of the rated output (Kim, Table 4)</source>
        <translation>Error de interferencia en tanto por ciento de la salida nominal (Kim, tabla 4)</translation>
    </message>
    <message>
        <source>Parts of the Type B standard uncertainty (Eqs 5 to 8)</source>
        <translation>Partes de la incertidumbre típica de tipo B (ecs. 5 a 8)</translation>
    </message>
    <message>
        <source>Means and standard deviations of the net values (Eqs 1 to 4)</source>
        <translation>Medias y desviaciones estándar de los valores netos (ecs. 1 a 4)</translation>
    </message>
    <message>
        <source>mean, decreasing</source>
        <translation>media, decreciente</translation>
    </message>
    <message>
        <source>Stated values beside the computed ones</source>
        <translation>Valores declarados junto a los calculados</translation>
    </message>
    <message>
        <source>stated</source>
        <translation>declarado</translation>
    </message>
    <message>
        <source>computed</source>
        <translation>calculado</translation>
    </message>
    <message>
        <source>status</source>
        <translation>estado</translation>
    </message>
    <message>
        <source>Interference at rated loads (% of the sensor&apos;s rated output)</source>
        <translation>Interferencia con cargas nominales (% de la salida nominal)</translation>
    </message>
    <message>
        <source>Parts of U by the paper (% of rated output)</source>
        <translation>Partes de U según el artículo (% de la salida nominal)</translation>
    </message>
    <message>
        <source>per cent of rated output</source>
        <translation>tanto por ciento de la salida nominal</translation>
    </message>
    <message>
        <source>k u_c</source>
        <translation>k u_c</translation>
    </message>
    <message>
        <source>Loads of one axis against time</source>
        <translation>Cargas de un eje frente al tiempo</translation>
    </message>
    <message>
        <source>Calibration curve of Fx</source>
        <translation>Curva de calibración de Fx</translation>
    </message>
    <message>
        <source>increasing, mean</source>
        <translation>creciente, media</translation>
    </message>
    <message>
        <source>decreasing, mean</source>
        <translation>decreciente, media</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of Fx</source>
        <translation>Residuos respecto a la recta por cero de Fx</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of Fx</source>
        <translation>Bucle de histéresis, ampliado, de Fx</translation>
    </message>
    <message>
        <source>Calibration curve of Fy</source>
        <translation>Curva de calibración de Fy</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of Fy</source>
        <translation>Residuos respecto a la recta por cero de Fy</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of Fy</source>
        <translation>Bucle de histéresis, ampliado, de Fy</translation>
    </message>
    <message>
        <source>Calibration curve of Fz</source>
        <translation>Curva de calibración de Fz</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of Fz</source>
        <translation>Residuos respecto a la recta por cero de Fz</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of Fz</source>
        <translation>Bucle de histéresis, ampliado, de Fz</translation>
    </message>
    <message>
        <source>Calibration curve of Mx</source>
        <translation>Curva de calibración de Mx</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of Mx</source>
        <translation>Residuos respecto a la recta por cero de Mx</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of Mx</source>
        <translation>Bucle de histéresis, ampliado, de Mx</translation>
    </message>
    <message>
        <source>Calibration curve of My</source>
        <translation>Curva de calibración de My</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of My</source>
        <translation>Residuos respecto a la recta por cero de My</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of My</source>
        <translation>Bucle de histéresis, ampliado, de My</translation>
    </message>
    <message>
        <source>Calibration curve of Mz</source>
        <translation>Curva de calibración de Mz</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of Mz</source>
        <translation>Residuos respecto a la recta por cero de Mz</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of Mz</source>
        <translation>Bucle de histéresis, ampliado, de Mz</translation>
    </message>
    <message>
        <source>The paper&apos;s U and the GUM&apos;s, per cent of rated output</source>
        <translation>U del artículo y de la GUM, tanto por ciento de la salida nominal</translation>
    </message>
    <message>
        <source>paper, linear sum</source>
        <translation>artículo, suma lineal</translation>
    </message>
    <message>
        <source>GUM, unknown loads on all other axes</source>
        <translation>GUM, cargas desconocidas en todos los demás ejes</translation>
    </message>
    <message>
        <source>GUM, unknown load on one axis</source>
        <translation>GUM, carga desconocida en un eje</translation>
    </message>
    <message>
        <source>GUM, one component alone, 95 %</source>
        <translation>GUM, una sola componente, 95 %</translation>
    </message>
    <message>
        <source>all other axes at rated load, worst signs</source>
        <translation>todos los demás ejes a carga nominal, signos más desfavorables</translation>
    </message>
    <message>
        <source>interference alone exceeds the paper&apos;s U</source>
        <translation>la interferencia sola supera la U del artículo</translation>
    </message>
    <message>
        <source>Standard uncertainties by the GUM</source>
        <translation>Incertidumbres estándar según la GUM</translation>
    </message>
    <message>
        <source>repeatability</source>
        <translation>repetibilidad</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>máquina</translation>
    </message>
    <message>
        <source>non-zero</source>
        <translation>error de cero</translation>
    </message>
    <message>
        <source>all</source>
        <translation>todas</translation>
    </message>
    <message>
        <source>U by the paper and by the GUM</source>
        <translation>U según el artículo y según la GUM</translation>
    </message>
    <message>
        <source>all others at rated load, worst signs</source>
        <translation>todos los demás a carga nominal, signos más desfavorables</translation>
    </message>
    <message>
        <source>Calibration matrix: reading by load</source>
        <translation>Matriz de calibración: lectura por carga</translation>
    </message>
    <message>
        <source>channel</source>
        <translation>canal</translation>
    </message>
    <message>
        <source>load Fx</source>
        <translation>carga Fx</translation>
    </message>
    <message>
        <source>load Fy</source>
        <translation>carga Fy</translation>
    </message>
    <message>
        <source>load Fz</source>
        <translation>carga Fz</translation>
    </message>
    <message>
        <source>load Mx</source>
        <translation>carga Mx</translation>
    </message>
    <message>
        <source>load My</source>
        <translation>carga My</translation>
    </message>
    <message>
        <source>load Mz</source>
        <translation>carga Mz</translation>
    </message>
    <message>
        <source>Decoupling matrix: load by reading</source>
        <translation>Matriz de desacoplo: carga por lectura</translation>
    </message>
    <message>
        <source>channel Fx</source>
        <translation>canal Fx</translation>
    </message>
    <message>
        <source>channel Fy</source>
        <translation>canal Fy</translation>
    </message>
    <message>
        <source>channel Fz</source>
        <translation>canal Fz</translation>
    </message>
    <message>
        <source>channel Mx</source>
        <translation>canal Mx</translation>
    </message>
    <message>
        <source>channel My</source>
        <translation>canal My</translation>
    </message>
    <message>
        <source>channel Mz</source>
        <translation>canal Mz</translation>
    </message>
    <message>
        <source>Loads with and without compensation of interference</source>
        <translation>Cargas con y sin compensación de la interferencia</translation>
    </message>
    <message>
        <source>case</source>
        <translation>caso</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>lectura</translation>
    </message>
    <message>
        <source>compensated</source>
        <translation>compensada</translation>
    </message>
    <message>
        <source>uncompensated</source>
        <translation>sin compensar</translation>
    </message>
    <message>
        <source>by rated load</source>
        <translation>por carga nominal</translation>
    </message>
    <message>
        <source>What interference adds without compensation</source>
        <translation>Lo que añade la interferencia sin compensación</translation>
    </message>
    <message>
        <source>per cent of rated load</source>
        <translation>tanto por ciento de la carga nominal</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>mixta</translation>
    </message>
    <message>
        <source>all rated</source>
        <translation>todas nominales</translation>
    </message>
    <message>
        <source>no load</source>
        <translation>sin carga</translation>
    </message>
    <message>
        <source>Supports in the instrument&apos;s frame and in the robot&apos;s</source>
        <translation>Apoyos en el sistema del instrumento y en el del robot</translation>
    </message>
    <message>
        <source>support</source>
        <translation>apoyo</translation>
    </message>
    <message>
        <source>Scatter of a pose that the robot is sent to again</source>
        <translation>Dispersión de una pose a la que el robot vuelve</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>desviación</translation>
    </message>
    <message>
        <source>Rotations of the flange</source>
        <translation>Rotaciones de la brida</translation>
    </message>
    <message>
        <source>about</source>
        <translation>alrededor de</translation>
    </message>
    <message>
        <source>radius of the circle</source>
        <translation>radio del círculo</translation>
    </message>
    <message>
        <source>least height above the supports</source>
        <translation>altura mínima sobre los apoyos</translation>
    </message>
    <message>
        <source>greatest height</source>
        <translation>altura máxima</translation>
    </message>
    <message>
        <source>Sensors of the network</source>
        <translation>Sensores de la red</translation>
    </message>
    <message>
        <source>reads</source>
        <translation>lee</translation>
    </message>
    <message>
        <source>Analysis of variance</source>
        <translation>Análisis de varianza</translation>
    </message>
    <message>
        <source>source of variation</source>
        <translation>fuente de variación</translation>
    </message>
    <message>
        <source>sum of squares</source>
        <translation>suma de cuadrados</translation>
    </message>
    <message>
        <source>mean square</source>
        <translation>cuadrado medio</translation>
    </message>
    <message>
        <source>Components of variance</source>
        <translation>Componentes de la varianza</translation>
    </message>
    <message>
        <source>Type A evaluation of observations</source>
        <translation>Evaluación de tipo A de las observaciones</translation>
    </message>
    <message>
        <source>s of one observation</source>
        <translation>s de una observación</translation>
    </message>
    <message>
        <source>u of the mean</source>
        <translation>u de la media</translation>
    </message>
    <message>
        <source>number of the observation</source>
        <translation>número de la observación</translation>
    </message>
    <message>
        <source>Points and their residuals</source>
        <translation>Puntos y sus residuos</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>residuo</translation>
    </message>
    <message>
        <source>Analysis of variance of the fit</source>
        <translation>Análisis de varianza del ajuste</translation>
    </message>
    <message>
        <source>Uncertainties</source>
        <translation>Incertidumbres</translation>
    </message>
    <message>
        <source>output</source>
        <translation>magnitud de salida</translation>
    </message>
    <message>
        <source>U by Monte Carlo</source>
        <translation>U por Monte Carlo</translation>
    </message>
    <message>
        <source>validated (clause 8)</source>
        <translation>validado (apartado 8)</translation>
    </message>
    <message>
        <source>cost per unit of target</source>
        <translation>coste por unidad del objetivo</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>variable</source>
        <translation>variable</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>elegido</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>tolerancia</translation>
    </message>
    <message>
        <source>Rows that are kept</source>
        <translation>Filas que se conservan</translation>
    </message>
    <message>
        <source>row</source>
        <translation>fila</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>fija</translation>
    </message>
    <message>
        <source>of the candidates&apos; file</source>
        <translation>del archivo de candidatos</translation>
    </message>
    <message>
        <source>objective without it</source>
        <translation>objetivo sin ella</translation>
    </message>
    <message>
        <source>price</source>
        <translation>precio</translation>
    </message>
    <message>
        <source>Candidates and what they gain</source>
        <translation>Candidatos y lo que aportan</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>ganancia</translation>
    </message>
    <message>
        <source>What would be gained without the uncertainty of</source>
        <translation>Lo que se ganaría sin la incertidumbre de</translation>
    </message>
    <message>
        <source>Objective and number of rows</source>
        <translation>Objetivo y número de filas</translation>
    </message>
    <message>
        <source>objective</source>
        <translation>objetivo</translation>
    </message>
    <message>
        <source>change</source>
        <translation>cambio</translation>
    </message>
    <message>
        <source>Cost and uncertainty</source>
        <translation>Coste e incertidumbre</translation>
    </message>
    <message>
        <source>Improvements</source>
        <translation>Mejoras</translation>
    </message>
    <message>
        <source>evaluation</source>
        <translation>evaluación</translation>
    </message>
    <message>
        <source>search</source>
        <translation>búsqueda</translation>
    </message>
    <message>
        <source>Candidates without result</source>
        <translation>Candidatos sin resultado</translation>
    </message>
    <message>
        <source>count</source>
        <translation>cantidad</translation>
    </message>
    <message>
        <source>U without %1</source>
        <translation>U sin %1</translation>
    </message>
    <message>
        <source>Expanded uncertainty that remains when everything %1 brings in is kept constant (an ideal one), by the law of propagation</source>
        <translation>Incertidumbre expandida que queda cuando todo lo que aporta %1 se mantiene constante (uno ideal), por la ley de propagación</translation>
    </message>
    <message>
        <source>Expanded uncertainty that remains when everything %1 brings in is kept constant (an ideal one), by Monte Carlo</source>
        <translation>Incertidumbre expandida que queda cuando todo lo que aporta %1 se mantiene constante (uno ideal), por Monte Carlo</translation>
    </message>
    <message>
        <source>symbol of the quantity</source>
        <translation>símbolo de la magnitud</translation>
    </message>
    <message>
        <source>what it is</source>
        <translation>qué es</translation>
    </message>
    <message>
        <source>estimate</source>
        <translation>estimación</translation>
    </message>
    <message>
        <source>unit of estimate and uncertainty</source>
        <translation>unidad de la estimación y de la incertidumbre</translation>
    </message>
    <message>
        <source>uncertainty before the divisor</source>
        <translation>incertidumbre antes del divisor</translation>
    </message>
    <message>
        <source>half-width of the limits</source>
        <translation>semianchura de los límites</translation>
    </message>
    <message>
        <source>divisor, coverage factor k</source>
        <translation>divisor, factor de cobertura k</translation>
    </message>
    <message>
        <source>sensitivity coefficient</source>
        <translation>coeficiente de sensibilidad</translation>
    </message>
    <message>
        <source>contribution to u(y)</source>
        <translation>contribución a u(y)</translation>
    </message>
    <message>
        <source>where the figure comes from</source>
        <translation>de dónde sale la cifra</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>no se lee</translation>
    </message>
    <message>
        <source>name of the point</source>
        <translation>nombre del punto</translation>
    </message>
    <message>
        <source>standard uncertainty of x, y, z</source>
        <translation>incertidumbre típica de x, y, z</translation>
    </message>
    <message>
        <source>standard uncertainty of x</source>
        <translation>incertidumbre típica de x</translation>
    </message>
    <message>
        <source>standard uncertainty of y</source>
        <translation>incertidumbre típica de y</translation>
    </message>
    <message>
        <source>standard uncertainty of z</source>
        <translation>incertidumbre típica de z</translation>
    </message>
    <message>
        <source>expanded uncertainty of x, y, z, k = 2</source>
        <translation>incertidumbre expandida de x, y, z, k = 2</translation>
    </message>
    <message>
        <source>expanded uncertainty of x, k = 2</source>
        <translation>incertidumbre expandida de x, k = 2</translation>
    </message>
    <message>
        <source>expanded uncertainty of y, k = 2</source>
        <translation>incertidumbre expandida de y, k = 2</translation>
    </message>
    <message>
        <source>expanded uncertainty of z, k = 2</source>
        <translation>incertidumbre expandida de z, k = 2</translation>
    </message>
    <message>
        <source>Kind of change</source>
        <translation>Tipo de cambio</translation>
    </message>
    <message>
        <source>Fields of the set-up</source>
        <translation>Campos de la configuración</translation>
    </message>
    <message>
        <source>Equations as evaluated</source>
        <translation>Ecuaciones tal como se evalúan</translation>
    </message>
    <message>
        <source>References</source>
        <translation>Referencias</translation>
    </message>
    <message>
        <source>Options of the evaluation</source>
        <translation>Opciones de la evaluación</translation>
    </message>
    <message>
        <source>What a calibration certificate says beside its results, with the clause of ISO/IEC 17025:2017 that asks for it.</source>
        <translation>Lo que dice un certificado de calibración además de sus resultados, con el apartado de ISO/IEC 17025:2017 que lo pide.</translation>
    </message>
    <message>
        <source>optional</source>
        <translation>opcional</translation>
    </message>
    <message>
        <source>default %1</source>
        <translation>predeterminado %1</translation>
    </message>
    <message>
        <source>Choices: </source>
        <translation>Opciones: </translation>
    </message>
    <message>
        <source>required by %1</source>
        <translation>exigido por %1</translation>
    </message>
    <message>
        <source>asked for by %1</source>
        <translation>pedido por %1</translation>
    </message>
    <message>
        <source>integer</source>
        <translation>número entero</translation>
    </message>
    <message>
        <source>choice</source>
        <translation>elección</translation>
    </message>
    <message>
        <source>text</source>
        <translation>texto</translation>
    </message>
    <message>
        <source>flag</source>
        <translation>sí o no</translation>
    </message>
    <message>
        <source>table</source>
        <translation>tabla</translation>
    </message>
    <message>
        <source>reference to an asset</source>
        <translation>referencia a un recurso</translation>
    </message>
    <message>
        <source>real number</source>
        <translation>número real</translation>
    </message>
    <message>
        <source>Position and orientation of a moving frame in a base frame, both defined by measured points: the platform of a robot measured with a total station or laser tracker.</source>
        <translation>Posición y orientación de un sistema móvil en un sistema base, ambos definidos por puntos medidos: la plataforma de un robot medida con estación total o láser tracker.</translation>
    </message>
    <message>
        <source>Eq 19 is corrected: o_p − o_b must be expressed in the base frame. As printed, the pose does not depend on the orientation of the base, and U(x) of all poses is the same.</source>
        <translation>Se corrige la ec. 19: o_p − o_b debe expresarse en el sistema base. Tal como está impresa, la pose no depende de la orientación de la base y U(x) es igual en todas las poses.</translation>
    </message>
    <message>
        <source>Eq 20 is corrected: R = R_bᵀ R_p. The printed R_p R_bᵀ is the same rotation expressed in frame 0.</source>
        <translation>Se corrige la ec. 20: R = R_bᵀ R_p. La R_p R_bᵀ impresa es la misma rotación expresada en el sistema 0.</translation>
    </message>
    <message>
        <source>Eqs 21-23 are corrected: as printed they are Z-Y-Z angles, undefined without tilt; the text and Table 3 use Z-Y-X angles, R = Rz(γ) Ry(β) Rx(α).</source>
        <translation>Se corrigen las ecs. 21-23: tal como están impresas son ángulos Z-Y-Z, indefinidos sin inclinación; el texto y la tabla 3 usan ángulos Z-Y-X, R = Rz(γ) Ry(β) Rx(α).</translation>
    </message>
    <message>
        <source>b₃ lies at negative y of its frame (Eq 10) and p₃ at positive y of its own (Eq 14); other arrangements can be chosen.</source>
        <translation>b₃ está en y negativo de su sistema (ec. 10) y p₃ en y positivo del suyo (ec. 14); se pueden elegir otras disposiciones.</translation>
    </message>
    <message>
        <source>Typed uncertainties lie along the axes of the frame that the points define (those of the moving frame along the base&apos;s on request) and are turned into frame 0; those of an instrument lie along and across its line of sight.</source>
        <translation>Las incertidumbres tecleadas van según los ejes del sistema que definen los puntos (las del sistema móvil, si se pide, según los de la base) y se giran al sistema 0; las de un instrumento van a lo largo y a través de su línea de visión.</translation>
    </message>
    <message>
        <source>Measured points of a least-squares frame are tested against their nominal coordinates: residuals, redundancy, chi-square with the full covariance of the stated uncertainties.</source>
        <translation>Los puntos medidos de un sistema por mínimos cuadrados se contrastan con sus coordenadas nominales: residuos, redundancia, chi cuadrado con la covarianza completa de las incertidumbres indicadas.</translation>
    </message>
    <message>
        <source>All poses of an analysis share one measurement of the base, so their results are correlated.</source>
        <translation>Todas las poses de un análisis comparten una medición de la base, de modo que sus resultados están correlacionados.</translation>
    </message>
    <message>
        <source>The uncertainty of the mean of repeated measurements (a posteriori) is taken as that of one measurement, as in the paper: the systematic part does not average out.</source>
        <translation>La incertidumbre de la media de mediciones repetidas (a posteriori) se toma como la de una sola medición, como en el artículo: la parte sistemática no se promedia.</translation>
    </message>
    <message>
        <source>Angles are undefined in gimbal lock; the set-up then warns. Rotation vector and quaternion are free of it.</source>
        <translation>Los ángulos no están definidos en el bloqueo de cardán; la configuración avisa entonces. El vector de rotación y el cuaternión no lo sufren.</translation>
    </message>
    <message>
        <source>Coordinates of targets and distances between them, measured by any mix of trackers, total stations, cameras and distance meters placed in space.</source>
        <translation>Coordenadas de dianas y distancias entre ellas, medidas con cualquier mezcla de trackers, estaciones totales, cámaras y distanciómetros situados en el espacio.</translation>
    </message>
    <message>
        <source>The uncertainty of the stations does not contribute marginally to the position of a target, as the paper says: only distances within one set-up are nearly free of it. Eq 5 is the precision of the readings; it is shown beside the total, never as the uncertainty of a position.</source>
        <translation>La incertidumbre de las estaciones no contribuye solo marginalmente a la posición de una diana, como dice el artículo: únicamente las distancias dentro de un estacionamiento están casi libres de ella. La ec. 5 es la precisión de las lecturas; se muestra junto al total, nunca como incertidumbre de una posición.</translation>
    </message>
    <message>
        <source>Weights from the readings alone, as in the paper, are inefficient for positions; those with the stations are the default.</source>
        <translation>Los pesos de las lecturas solas, como en el artículo, son ineficientes para las posiciones; los que incluyen las estaciones son el valor predeterminado.</translation>
    </message>
    <message>
        <source>Eq 2 is corrected: D holds equations by readings; as printed it is transposed.</source>
        <translation>Se corrige la ec. 2: D tiene ecuaciones por lecturas; tal como está impresa, está traspuesta.</translation>
    </message>
    <message>
        <source>The linearised equations have the measured angles in M: their estimate shrinks towards the sensors, the non-linear one moves outwards by half as much. It matters beyond a milliradian (3.5 mrad, cameras alone: −6.9 mm against +3.3 mm) and not for the paper&apos;s network.</source>
        <translation>Las ecuaciones linealizadas tienen los ángulos medidos en M: su estimación se contrae hacia los sensores, la no lineal se desplaza hacia fuera la mitad. Importa por encima de un milirradián (3.5 mrad, solo cámaras: −6.9 mm frente a +3.3 mm) y no en la red del artículo.</translation>
    </message>
    <message>
        <source>Stations are located once for a set-up: all its targets share their deviations. &quot;New set-up&quot; at a target draws them anew.</source>
        <translation>Las estaciones se localizan una vez por estacionamiento: todas sus dianas comparten sus desviaciones. «Nuevo estacionamiento» en una diana las extrae de nuevo.</translation>
    </message>
    <message>
        <source>A distance without angles has no linear equation; the non-linear estimator uses it, from the nominal coordinates as start.</source>
        <translation>Una distancia sin ángulos no tiene ecuación lineal; el estimador no lineal la usa, con las coordenadas nominales como inicio.</translation>
    </message>
    <message>
        <source>A calibrated length as a check is not used in the estimation: its difference is to be judged by its uncertainty. As a constraint it carries its own uncertainty; a scale that the instruments share is corrected by it.</source>
        <translation>Una longitud calibrada como comprobación no se usa en la estimación: su diferencia debe juzgarse por su incertidumbre. Como restricción aporta su propia incertidumbre; una escala que los instrumentos comparten se corrige con ella.</translation>
    </message>
    <message>
        <source>With more than 600 readings in one set-up each target is estimated by itself, weighted with the stations.</source>
        <translation>Con más de 600 lecturas en un estacionamiento, cada diana se estima por separado, con los pesos que incluyen las estaciones.</translation>
    </message>
    <message>
        <source>Azimuths may be given with any number of whole turns.</source>
        <translation>Los acimutes se pueden dar con cualquier número de vueltas completas.</translation>
    </message>
    <message>
        <source>The tool centre point of a robot: the flange turns about its own axes, telescopic ballbars measure where the ball at the tool goes, and planes and a sphere give the flange&apos;s axes and centre.</source>
        <translation>El centro de la herramienta de un robot: la brida gira alrededor de sus propios ejes, unas ballbars telescópicas miden adónde va la bola de la herramienta, y planos y una esfera dan los ejes y el centro de la brida.</translation>
    </message>
    <message>
        <source>The paper states neither the tool, nor the flange&apos;s orientation, start angles, how the frame is made, nor how the points are averaged. With a tool of (0, 0, 100) mm, the flange pointing down, arcs from -60° to 140° and from -90° to 90° and u(L) = 1.55 µm, the published values reproduce within 1.5 % (root mean square).</source>
        <translation>El artículo no indica ni la herramienta, ni la orientación de la brida, ni los ángulos iniciales, ni cómo se forma el sistema, ni cómo se promedian los puntos. Con una herramienta de (0, 0, 100) mm, la brida hacia abajo, arcos de -60° a 140° y de -90° a 90° y u(L) = 1.55 µm, los valores publicados se reproducen dentro del 1.5 % (media cuadrática).</translation>
    </message>
    <message>
        <source>U(TCP): published 8.2, 11.1, 5.1 µm; here 8.16, 10.92, 5.00 µm: reproduces.</source>
        <translation>U(TCP): publicado 8.2, 11.1, 5.1 µm; aquí 8.16, 10.92, 5.00 µm: se reproduce.</translation>
    </message>
    <message>
        <source>U(TCP) with an ideal robot: published 2.8, 3.7, 1.6 µm; here 2.77, 3.61, 1.57 µm: reproduces.</source>
        <translation>U(TCP) con un robot ideal: publicado 2.8, 3.7, 1.6 µm; aquí 2.77, 3.61, 1.57 µm: se reproduce.</translation>
    </message>
    <message>
        <source>U of the axes&apos; angles XY, XZ, YX, YZ: published 79, 87, 59, 123 µrad; here 78.3, 87.2, 58.5, 120.6 µrad: reproduces.</source>
        <translation>U de los ángulos de los ejes XY, XZ, YX, YZ: publicado 79, 87, 59, 123 µrad; aquí 78.3, 87.2, 58.5, 120.6 µrad: se reproduce.</translation>
    </message>
    <message>
        <source>Largest U of a point measured by the ballbars alone: published 5.7, 5.7, 2.4 µm; here 5.83, 5.72, 2.38 µm: reproduces.</source>
        <translation>Mayor U de un punto medido solo con las barras de bolas: publicado 5.7, 5.7, 2.4 µm; aquí 5.83, 5.72, 2.38 µm: se reproduce.</translation>
    </message>
    <message>
        <source>With the stated U(L) = 4 µm the same geometry gives U(TCP) 8.46, 11.31, 5.16 µm and points up to 7.53, 7.37, 3.07 µm: differs, because the stated 4 µm and the published points cannot both hold. U(z) of a point at most 577 mm above the supports is 2.4 µm only for U(L) near 3.1 µm; all six figures of the instrument alone are 0.78 of what 4 µm gives.</source>
        <translation>Con el U(L) = 4 µm indicado, la misma geometría da U(TCP) 8.46, 11.31, 5.16 µm y puntos de hasta 7.53, 7.37, 3.07 µm: difiere, porque los 4 µm indicados y los puntos publicados no pueden ser ciertos a la vez. U(z) de un punto a 577 mm como máximo por encima de los apoyos es 2.4 µm solo con U(L) cerca de 3.1 µm; las seis cifras del instrumento solo son 0.78 de lo que dan 4 µm.</translation>
    </message>
    <message>
        <source>The centre of the sphere is the centre of the flange, not the tool centre point as section 4 says: its U is 5.96, 7.42, 6.94 µm.</source>
        <translation>El centro de la esfera es el centro de la brida, no el punto central de la herramienta, como dice el apartado 4: su U es 5.96, 7.42, 6.94 µm.</translation>
    </message>
    <message>
        <source>Eq 8 needs perpendicular axes, which two measured normals are not: U(x) of the tool is 8.16, 8.37 or 8.66 µm with y first, symmetric or x first.</source>
        <translation>La ec. 8 necesita ejes perpendiculares, y dos normales medidas no lo son: U(x) de la herramienta es 8.16, 8.37 u 8.66 µm con y primero, simétrico o x primero.</translation>
    </message>
    <message>
        <source>A trial whose lengths do not meet (negative root of Eq 3) has no value: it is counted and reported.</source>
        <translation>Una prueba cuyas longitudes no se encuentran (raíz negativa de la ec. 3) no tiene valor: se cuenta y se comunica.</translation>
    </message>
    <message>
        <source>Position and orientation of the tool of a serial robot from its geometric parameters and joint readings.</source>
        <translation>Posición y orientación de la herramienta de un robot serie a partir de sus parámetros geométricos y de las lecturas de las articulaciones.</translation>
    </message>
    <message>
        <source>The paper calls the model highly non-linear. At the uncertainties of its Table 1 it is not: the law of propagation and Monte Carlo agree to 4e-5 mm in u, and the laws are normal.</source>
        <translation>El artículo califica el modelo de muy no lineal. Con las incertidumbres de su tabla 1 no lo es: la ley de propagación y Monte Carlo concuerdan en u hasta 4e-5 mm, y las distribuciones son normales.</translation>
    </message>
    <message>
        <source>The tolerance 0.0001 of the paper has no unit. In millimetres it would need 5e9 trials; in metres it is 0.1 mm, and 20 000 trials do.</source>
        <translation>La tolerancia 0.0001 del artículo no tiene unidad. En milímetros exigiría 5e9 pruebas; en metros es 0.1 mm, y bastan 20 000 pruebas.</translation>
    </message>
    <message>
        <source>The paper takes the parameters as uncorrelated. Parameters identified together are strongly correlated; an identified robot carries their full covariance into this analysis, which lowers u by up to a factor of 12.</source>
        <translation>El artículo toma los parámetros como no correlacionados. Los parámetros identificados conjuntamente están muy correlacionados; un robot identificado aporta su covarianza completa a este análisis, lo que reduce u hasta en un factor 12.</translation>
    </message>
    <message>
        <source>Of two readings of section 4.1 (0.01 rad for theta alone, or for all angles) both are reproduced; that theta matters more than alpha holds only where its standard deviation is ten times larger.</source>
        <translation>De las dos lecturas posibles del apartado 4.1 (0.01 rad solo para theta, o para todos los ángulos) se reproducen ambas; que theta importe más que alpha solo se cumple donde su desviación típica es diez veces mayor.</translation>
    </message>
    <message>
        <source>Readings of the joints deviate anew at each pose; parameters and tool are the same for all poses of an analysis.</source>
        <translation>Las lecturas de las articulaciones se desvían de nuevo en cada pose; los parámetros y la herramienta son los mismos para todas las poses de un análisis.</translation>
    </message>
    <message>
        <source>Geometric parameters of a serial robot from points measured while one joint after the other turns (circle point analysis).</source>
        <translation>Parámetros geométricos de un robot serie a partir de puntos medidos mientras gira una articulación tras otra (análisis de puntos de círculo).</translation>
    </message>
    <message>
        <source>Eq 4 is corrected: without the square its derivative by R gives R = 0.</source>
        <translation>Se corrige la ec. 4: sin el cuadrado, su derivada respecto a R da R = 0.</translation>
    </message>
    <message>
        <source>2.1.3 is corrected: x_i = z_i × y_i is left-handed.</source>
        <translation>Se corrige 2.1.3: x_i = z_i × y_i es levógiro.</translation>
    </message>
    <message>
        <source>2.1.4 is corrected: alpha_i and beta_i turn z_{i−1} into z_i.</source>
        <translation>Se corrige 2.1.4: alpha_i y beta_i giran z_{i−1} hasta z_i.</translation>
    </message>
    <message>
        <source>The auxiliary plane of Figure 2 is not defined in the paper; it must pass through O_{i−1} with the normal z_{i−1}, or d_i = 0 is impossible.</source>
        <translation>El plano auxiliar de la figura 2 no está definido en el artículo; debe pasar por O_{i−1} con la normal z_{i−1}, o d_i = 0 es imposible.</translation>
    </message>
    <message>
        <source>Eq 1 has no plane through the origin and fails near it; total least squares is the default.</source>
        <translation>La ec. 1 no tiene ningún plano por el origen y falla cerca de él; el valor predeterminado son los mínimos cuadrados totales.</translation>
    </message>
    <message>
        <source>Eq 8 is a standard deviation of the mean of repeats. The paper applies it to different ranges and numbers of points, which are no repeats: the ±10° run dominates, and the noise is counted three times. Here the covariance is that of the chosen experiment.</source>
        <translation>La ec. 8 es una desviación típica de la media de repeticiones. El artículo la aplica a intervalos y números de puntos distintos, que no son repeticiones: domina la serie de ±10°, y el ruido se cuenta tres veces. Aquí la covarianza es la del experimento elegido.</translation>
    </message>
    <message>
        <source>The standard deviation falls with the square of the range (factor 30 from ±10° to ±60°) and with the root of the number of points.</source>
        <translation>La desviación típica disminuye con el cuadrado del intervalo (factor 30 de ±10° a ±60°) y con la raíz del número de puntos.</translation>
    </message>
    <message>
        <source>Parameters are strongly correlated (d_3 and alpha_3: −0.99): use their full covariance, as an identified robot does.</source>
        <translation>Los parámetros están muy correlacionados (d_3 y alpha_3: −0.99): use su covarianza completa, como hace un robot identificado.</translation>
    </message>
    <message>
        <source>Every joint needs a ball off its axis; at the paper&apos;s flange origin joint 6 draws no circle.</source>
        <translation>Cada articulación necesita una bola fuera de su eje; en el origen de la brida del artículo, la articulación 6 no describe ningún círculo.</translation>
    </message>
    <message>
        <source>Geometric parameters of a serial robot by least squares from measured positions or poses of its tool, with observability, residuals and validation.</source>
        <translation>Parámetros geométricos de un robot serie por mínimos cuadrados a partir de posiciones o poses medidas de su herramienta, con observabilidad, residuos y validación.</translation>
    </message>
    <message>
        <source>The paper identifies parameters by joint trajectories; least squares on measured positions or poses is the other usual way, with the same model of the arm (Eq 5).</source>
        <translation>El artículo identifica los parámetros por trayectorias articulares; los mínimos cuadrados con posiciones o poses medidas son la otra vía habitual, con el mismo modelo del brazo (ec. 5).</translation>
    </message>
    <message>
        <source>Parameters that the poses cannot tell are found by their columns of the Jacobian: each that is a combination of those before it (base, then ball or tool, then joint by joint) stays nominal and is named with its partners.</source>
        <translation>Los parámetros que las poses no pueden revelar se hallan por sus columnas de la jacobiana: cada uno que sea combinación de los anteriores (base, después bola o herramienta, después articulación por articulación) conserva su valor nominal y se nombra junto con sus compañeros.</translation>
    </message>
    <message>
        <source>Weights are the inverse variances of the measured coordinates. Shared deviations of an instrument and the readings of the joints do not change the weights, but are propagated in full.</source>
        <translation>Los pesos son las inversas de las varianzas de las coordenadas medidas. Las desviaciones comunes de un instrumento y las lecturas de las articulaciones no cambian los pesos, pero se propagan por completo.</translation>
    </message>
    <message>
        <source>In each trial the gain of the estimates is used. It differs from a complete fit by residual times curvature, below 1e-9 m here.</source>
        <translation>En cada prueba se usa la ganancia de las estimaciones. Difiere de un ajuste completo en el residuo por la curvatura, aquí menos de 1e-9 m.</translation>
    </message>
    <message>
        <source>Position alone does not tell the last joint&apos;s parameters from the place of the ball; a known base and a known ball leave more to find.</source>
        <translation>La posición sola no distingue los parámetros de la última articulación del lugar de la bola; una base conocida y una bola conocida permiten hallar más.</translation>
    </message>
    <message>
        <source>The uncertainty of each channel of a multi-axis force/moment sensor, used alone or while unknown loads act on its other axes; by the GUM, with the paper&apos;s evaluation beside it.</source>
        <translation>La incertidumbre de cada canal de un sensor multieje de fuerza y momento, usado solo o mientras cargas desconocidas actúan sobre sus otros ejes; según la GUM, con la evaluación del artículo al lado.</translation>
    </message>
    <message>
        <source>U of the paper: 0.91, 1.22, 1.67, 1.68, 2.78, 1.20 % of rated output: reproduces.</source>
        <translation>U del artículo: 0.91, 1.22, 1.67, 1.68, 2.78, 1.20 % de la salida nominal: se reproduce.</translation>
    </message>
    <message>
        <source>By the GUM (k = 2) with unknown loads on the other five axes: 1.446, 1.425, 2.123, 2.637, 2.990, 1.388 %. With all others at rated load interference alone reaches 2.70, 2.12, 3.33, 4.59, 3.70, 2.27 %, more than U of the paper for all six: its linear sum is no bound.</source>
        <translation>Según la GUM (k = 2), con cargas desconocidas en los otros cinco ejes: 1.446, 1.425, 2.123, 2.637, 2.990, 1.388 %. Con todas las demás a carga nominal, la interferencia sola llega a 2.70, 2.12, 3.33, 4.59, 3.70, 2.27 %, más que U del artículo en los seis: su suma lineal no es una cota.</translation>
    </message>
    <message>
        <source>Monte Carlo intervals are a little shorter than k = 2 because a few rectangular loads dominate.</source>
        <translation>Los intervalos de Monte Carlo son un poco más cortos que k = 2 porque dominan unas pocas cargas rectangulares.</translation>
    </message>
    <message>
        <source>The load on an axis is one quantity in the equations of all channels, which correlates them.</source>
        <translation>La carga sobre un eje es una sola magnitud en las ecuaciones de todos los canales, lo que los correlaciona.</translation>
    </message>
    <message>
        <source>With n = 3 a standard deviation has two degrees of freedom. Used alone a channel has effective degrees of freedom between 20 and 140, because its repeatability is a small part.</source>
        <translation>Con n = 3 una desviación típica tiene dos grados de libertad. Usado por separado, un canal tiene entre 20 y 140 grados de libertad efectivos, porque su repetibilidad es una parte pequeña.</translation>
    </message>
    <message>
        <source>Not covered: misalignment of the loads, creep, temperature, remounting.</source>
        <translation>No se incluye: desalineación de las cargas, fluencia, temperatura, nuevo montaje.</translation>
    </message>
    <message>
        <source>Forces and moments that act together, from the readings of all channels of a multi-axis sensor: the calibration matrix takes the interference between them away.</source>
        <translation>Fuerzas y momentos que actúan juntos, a partir de las lecturas de todos los canales de un sensor multieje: la matriz de calibración elimina la interferencia entre ellos.</translation>
    </message>
    <message>
        <source>Kim prints no signs of the interference: nothing can be compensated from the paper. The readings of the example have signs of their own.</source>
        <translation>Kim no imprime los signos de la interferencia: a partir del artículo no se puede compensar nada. Las lecturas del ejemplo tienen signos propios.</translation>
    </message>
    <message>
        <source>U (k = 2) in % of rated load with all six axes at rated load: 0.184, 0.192, 0.152, 0.226, 0.219, 0.261; without load 0.149, 0.159, 0.144, 0.188, 0.179, 0.180. Compensation lowers the uncertainty under combined loads by a factor of 5 to 13 against U of the paper.</source>
        <translation>U (k = 2) en % de la carga nominal con los seis ejes a carga nominal: 0.184, 0.192, 0.152, 0.226, 0.219, 0.261; sin carga 0.149, 0.159, 0.144, 0.188, 0.179, 0.180. La compensación reduce la incertidumbre con cargas combinadas en un factor de 5 a 13 frente a U del artículo.</translation>
    </message>
    <message>
        <source>Without compensation the same loads are told wrong by -0.73, +2.05, -1.42, -2.72, +2.90, -1.54 %.</source>
        <translation>Sin compensación, las mismas cargas se indican con un error de -0.73, +2.05, -1.42, -2.72, +2.90, -1.54 %.</translation>
    </message>
    <message>
        <source>The machine&apos;s deviation is common to all readings under one load: a column of the matrix, and so a scale of the load on that axis.</source>
        <translation>La desviación de la máquina es común a todas las lecturas bajo una carga: una columna de la matriz y, por tanto, una escala de la carga en ese eje.</translation>
    </message>
    <message>
        <source>Repeatability is that of one reading, the largest of the steps; hysteresis is rectangular over the loop, in proportion to the load.</source>
        <translation>La repetibilidad es la de una lectura, la mayor de los escalones; la histéresis es rectangular sobre el ciclo, en proporción a la carga.</translation>
    </message>
    <message>
        <source>Not covered: products of loads in the interference, misalignment of loads, creep, temperature, remounting.</source>
        <translation>No se incluye: productos de cargas en la interferencia, desalineación de las cargas, fluencia, temperatura, nuevo montaje.</translation>
    </message>
    <message>
        <source>Sensitivity coefficients are exact (automatic differentiation); those of unknowns that equations define implicitly follow JCGM 102 6.3.</source>
        <translation>Los coeficientes de sensibilidad son exactos (diferenciación automática); los de incógnitas que las ecuaciones definen implícitamente siguen JCGM 102 6.3.</translation>
    </message>
    <message>
        <source>JCGM 100 H.1, H.2 and JCGM 101 9.2 to 9.5, JCGM 102 9.2 to 9.4 are examples in projects/gum: covaria verify holds them against their published values.</source>
        <translation>JCGM 100 H.1, H.2 y JCGM 101 9.2 a 9.5, JCGM 102 9.2 a 9.4 son ejemplos en projects/gum: covaria verify los contrasta con sus valores publicados.</translation>
    </message>
    <message>
        <source>A straight line or polynomial through the points of a calibration by least squares, with uncertainties in y and in x: the covariance of its coefficients, its values, and the x that belong to observed y, with their uncertainties.</source>
        <translation>Una recta o un polinomio por los puntos de una calibración por mínimos cuadrados, con incertidumbres en y y en x: la covarianza de sus coeficientes, sus valores y las x que corresponden a las y observadas, con sus incertidumbres.</translation>
    </message>
    <message>
        <source>Computed with polynomials that are orthonormal over the points, so results do not depend on the origin, up to degree 10. From the residuals their coefficients are drawn from a multivariate t distribution: one estimate of the scatter, n - p degrees of freedom for every result.</source>
        <translation>Se calcula con polinomios ortonormales sobre los puntos, de modo que los resultados no dependen del origen, hasta el grado 10. A partir de los residuos, sus coeficientes se extraen de una distribución t multivariante: una sola estimación de la dispersión, n - p grados de libertad para cada resultado.</translation>
    </message>
    <message>
        <source>JCGM 100 H.3, published y₁ = −0.1712 °C, y₂ = 0.002 18, u(y₁) = 0.0029 °C, u(y₂) = 0.000 67, b(30 °C) = −0.1494 °C with u = 0.0041 °C: reproduces.</source>
        <translation>JCGM 100 H.3, publicado y₁ = −0.1712 °C, y₂ = 0.002 18, u(y₁) = 0.0029 °C, u(y₂) = 0.000 67, b(30 °C) = −0.1494 °C con u = 0.0041 °C: se reproduce.</translation>
    </message>
    <message>
        <source>The uncertainty of b(x) is that of the curve: the scatter of a further observation is not part of it.</source>
        <translation>La incertidumbre de b(x) es la de la curva: la dispersión de una observación adicional no forma parte de ella.</translation>
    </message>
    <message>
        <source>The mean of observations made on several days, with several instruments or by several operators, and an analysis of variance that says whether these have an effect.</source>
        <translation>La media de observaciones hechas en varios días, con varios instrumentos o por varios operadores, y un análisis de varianza que dice si estos tienen efecto.</translation>
    </message>
    <message>
        <source>Groups may have different numbers of observations; n_0 = (N − Σ n_j²/N)/(J − 1) is then their size in the components of variance.</source>
        <translation>Los grupos pueden tener números de observaciones distintos; n_0 = (N − Σ n_j²/N)/(J − 1) es entonces su tamaño en las componentes de la varianza.</translation>
    </message>
    <message>
        <source>JCGM 100 H.5, published V̄ = 10.000 097 V, s(V̄_j) = 57 µV, s_b = 85 µV, u(V̄) = 18 µV with nine degrees of freedom, or 13 µV with 49 without an effect of the days: reproduces.</source>
        <translation>JCGM 100 H.5, publicado V̄ = 10.000 097 V, s(V̄_j) = 57 µV, s_b = 85 µV, u(V̄) = 18 µV con nueve grados de libertad, o 13 µV con 49 sin efecto de los días: se reproduce.</translation>
    </message>
    <message>
        <source>A plate or frame with calibrated nests, measured repeatedly where the real points will be. Its errors of indication give the uncertainty of each coordinate of a measured point.</source>
        <translation>Una placa o un bastidor con nidos calibrados, medido repetidamente donde estarán los puntos reales. Sus errores de indicación dan la incertidumbre de cada coordenada de un punto medido.</translation>
    </message>
    <message>
        <source>u_i² = u_cal² + u_var,i² + u_T,i² + b_i² (Eq 2) with u_T = L_max α ΔT/√3 (Eq 3).</source>
        <translation>u_i² = u_cal² + u_var,i² + u_T,i² + b_i² (ec. 2) con u_T = L_max α ΔT/√3 (ec. 3).</translation>
    </message>
    <message>
        <source>The paper draws all parts independently for each point; calibration, temperature and bias are in truth common to all points, which can be chosen.</source>
        <translation>El artículo extrae todas las partes independientemente para cada punto; calibración, temperatura y sesgo son en realidad comunes a todos los puntos, lo que se puede elegir.</translation>
    </message>
    <message>
        <source>The noise of the three points that define the artefact&apos;s frame is part of the errors of the others; the errors of the defining coordinates themselves are never observed.</source>
        <translation>El ruido de los tres puntos que definen el sistema del artefacto forma parte de los errores de los demás; los errores de las propias coordenadas definitorias nunca se observan.</translation>
    </message>
    <message>
        <source>A bar of calibrated length, measured in many positions and orientations. Its errors of indication give one figure for every coordinate of a measured point.</source>
        <translation>Una barra de longitud calibrada, medida en muchas posiciones y orientaciones. Sus errores de indicación dan una sola cifra para cada coordenada de un punto medido.</translation>
    </message>
    <message>
        <source>u² = u_cal² + u_var² + u_T² + b² (Eq 5) with u_T = L α ΔT/√3 (Eq 6).</source>
        <translation>u² = u_cal² + u_var² + u_T² + b² (ec. 5) con u_T = L α ΔT/√3 (ec. 6).</translation>
    </message>
    <message>
        <source>A length is a difference of two points: dividing by √2 would be consistent; the paper does not.</source>
        <translation>Una longitud es una diferencia de dos puntos: dividir por √2 sería coherente; el artículo no lo hace.</translation>
    </message>
    <message>
        <source>A sensor that stands somewhere and reads a distance, two angles, or some of them. Its uncertainty: each reading for itself, what all its readings share, and where it stands.</source>
        <translation>Un sensor que tiene un emplazamiento y lee una distancia, dos ángulos o algunos de ellos. Su incertidumbre: la de cada lectura por sí misma, lo que comparten todas sus lecturas y dónde está.</translation>
    </message>
    <message>
        <source>The distance has the figure a + b L, each angle its own; these are independent from reading to reading. Scale, zero, index, collimation, squareness, beam offset and refraction are shared by all readings.</source>
        <translation>La distancia tiene la cifra a + b L, cada ángulo la suya; estas son independientes de una lectura a otra. Escala, cero, índice, colimación, perpendicularidad, descentrado del haz y refracción son comunes a todas las lecturas.</translation>
    </message>
    <message>
        <source>Only a sensor that reads a distance and both angles can say by itself where a point is.</source>
        <translation>Solo un sensor que lee una distancia y ambos ángulos puede decir por sí mismo dónde está un punto.</translation>
    </message>
    <message>
        <source>Instruments of the project that measure the same points together. Points measured by the network keep what they share: the scale and the station of each instrument.</source>
        <translation>Instrumentos del proyecto que miden conjuntamente los mismos puntos. Los puntos medidos por la red conservan lo que comparten: la escala y la estación de cada instrumento.</translation>
    </message>
    <message>
        <source>A point&apos;s deviations are the least-squares gain times those of the readings and stations, linearised at the point: exact to first order, and in Monte Carlo as long as the angles&apos; deviations stay below about a milliradian.</source>
        <translation>Las desviaciones de un punto son la ganancia de mínimos cuadrados por las de las lecturas y estaciones, linealizada en el punto: exacto a primer orden, y en Monte Carlo mientras las desviaciones de los ángulos queden por debajo de un milirradián aproximadamente.</translation>
    </message>
    <message>
        <source>All points that an analysis takes from the network are measured from one set-up: none of its instruments is moved or located anew between them.</source>
        <translation>Todos los puntos que un análisis toma de la red se miden en un mismo estacionamiento: ninguno de sus instrumentos se mueve ni se localiza de nuevo entre ellos.</translation>
    </message>
    <message>
        <source>A sensor contributes to a point that is in its range and field of view, and no others.</source>
        <translation>Un sensor contribuye a un punto que está dentro de su alcance y su campo de visión, y a ningún otro.</translation>
    </message>
    <message>
        <source>One figure of a data sheet for all coordinates: a standard uncertainty or a maximum permissible error.</source>
        <translation>Una sola cifra de una hoja de datos para todas las coordenadas: una incertidumbre típica o un error máximo permitido.</translation>
    </message>
    <message>
        <source>A specification taken alike in all directions overestimates, by a factor of 2 to 5 in the paper&apos;s example; an instrument that stands somewhere (spherical instrument) is closer to the truth.</source>
        <translation>Una especificación tomada igual en todas las direcciones sobrestima, en un factor de 2 a 5 en el ejemplo del artículo; un instrumento que tiene un emplazamiento (instrumento esférico) se acerca más a la verdad.</translation>
    </message>
    <message>
        <source>Three or more telescopic ballbars that measure the lengths from their supports to one ball at once, and with it where the ball is.</source>
        <translation>Tres o más barras de bolas telescópicas que miden a la vez las longitudes desde sus apoyos hasta una bola y, con ellas, dónde está la bola.</translation>
    </message>
    <message>
        <source>The supports&apos; frame follows from the lengths between them (Eqs 4 to 7), measured once: their deviations are common to all points.</source>
        <translation>El sistema de los apoyos resulta de las longitudes entre ellos (ecs. 4 a 7), medidas una vez: sus desviaciones son comunes a todos los puntos.</translation>
    </message>
    <message>
        <source>Eq 2 as printed has Y_VC3; Y_KS3 is meant. Eq 3 has two roots; the side is a choice here.</source>
        <translation>La ec. 2 impresa tiene Y_VC3; se refiere a Y_KS3. La ec. 3 tiene dos raíces; aquí se elige el lado.</translation>
    </message>
    <message>
        <source>The paper&apos;s supports are called an equilateral triangle of 520 mm; its Table 1 is isosceles, 520 mm and 519.711 mm.</source>
        <translation>El artículo llama a los apoyos un triángulo equilátero de 520 mm; su tabla 1 es isósceles, 520 mm y 519.711 mm.</translation>
    </message>
    <message>
        <source>A fourth support and those after it are located by their lengths to the first three at a height that is an input of its own: lengths say nothing about a height above the plane in which all supports lie.</source>
        <translation>Un cuarto apoyo y los siguientes se localizan por sus longitudes a los tres primeros, a una altura que es una entrada propia: las longitudes no dicen nada de una altura sobre el plano en el que están todos los apoyos.</translation>
    </message>
    <message>
        <source>A robot as a source of uncertainty: each time it goes to a pose it misses it by a distance in a random direction, and perhaps by small rotations.</source>
        <translation>Un robot como fuente de incertidumbre: cada vez que va a una pose, se aparta de ella una distancia en una dirección aleatoria y, tal vez, pequeñas rotaciones.</translation>
    </message>
    <message>
        <source>The paper takes the distance as rectangular in [0, r], r being the data sheet&apos;s ± 0.02 mm; u along an axis is then r/3. RP of ISO 9283 is the mean distance plus three standard deviations, which is another figure: for that law RP = 1.366 r, in a ball 1.331 r, on a sphere r, and 3.616 u for normal coordinates.</source>
        <translation>El artículo toma la distancia como rectangular en [0, r], donde r son los ± 0.02 mm de la hoja de datos; u a lo largo de un eje es entonces r/3. RP de ISO 9283 es la distancia media más tres desviaciones típicas, que es otra cifra: para esa distribución RP = 1.366 r, en una bola 1.331 r, sobre una esfera r, y 3.616 u para coordenadas normales.</translation>
    </message>
    <message>
        <source>The paper leaves the orientation out. A rotation by e moves the tool by about e times its length.</source>
        <translation>El artículo omite la orientación. Una rotación e mueve la herramienta aproximadamente e veces su longitud.</translation>
    </message>
    <message>
        <source>An arm of joints that turn or slide: parameters in a Denavit-Hartenberg convention with one or more components of uncertainty each, their correlation, limits, encoders, base and tool.</source>
        <translation>Un brazo de articulaciones que giran o deslizan: parámetros en una convención de Denavit-Hartenberg con una o más componentes de incertidumbre cada uno, su correlación, límites, codificadores, base y herramienta.</translation>
    </message>
    <message>
        <source>Eq. 5: T = Rz(theta) Tz(d) Tx(a) Rx(alpha) Ry(beta). Where an axis is parallel to the next, beta is a parameter and d is 0 by definition; elsewhere beta is 0.</source>
        <translation>Ec. 5: T = Rz(theta) Tz(d) Tx(a) Rx(alpha) Ry(beta). Donde un eje es paralelo al siguiente, beta es un parámetro y d es 0 por definición; en los demás casos beta es 0.</translation>
    </message>
    <message>
        <source>alpha and beta of a row turn the axis of the joint into that of the next (the paper&apos;s text shifts them by one joint).</source>
        <translation>alpha y beta de una fila giran el eje de la articulación hasta el de la siguiente (el texto del artículo los desplaza una articulación).</translation>
    </message>
    <message>
        <source>The joint angle is theta plus the reading less the zero reading; a sliding joint adds its reading to d in the same way.</source>
        <translation>El ángulo de la articulación es theta más la lectura menos la lectura cero; una articulación deslizante suma del mismo modo su lectura a d.</translation>
    </message>
    <message>
        <source>Loads a multi-axis force/moment sensor with one force or moment at a time.</source>
        <translation>Carga un sensor multieje de fuerzas y momentos con una sola fuerza o un solo momento cada vez.</translation>
    </message>
    <message>
        <source>The uncertainty of a load is common to all readings under loads on that axis: it does not average out in the calibration matrix.</source>
        <translation>La incertidumbre de una carga es común a todas las lecturas bajo cargas en ese eje: no se promedia en la matriz de calibración.</translation>
    </message>
    <message>
        <source>Up to three forces and three moments measured at once; calibrated with one load at a time, evaluated from its readings.</source>
        <translation>Hasta tres fuerzas y tres momentos medidos a la vez; calibrado con una carga cada vez, evaluado a partir de sus lecturas.</translation>
    </message>
    <message>
        <source>Tables 1 to 4 reproduce from raw readings that are consistent with them, to the printed digits, with relative uncertainties of the machine of 8.6e-4, 8.7e-4, 1.2e-5, 8.7e-4, 8.6e-4 and 1.7e-3.</source>
        <translation>Las tablas 1 a 4 se reproducen a partir de lecturas brutas coherentes con ellas, hasta las cifras impresas, con incertidumbres relativas de la máquina de 8.6e-4, 8.7e-4, 1.2e-5, 8.7e-4, 8.6e-4 y 1.7e-3.</translation>
    </message>
    <message>
        <source>Type B, Table 3: differs for five of six sensors, because the stated uncertainties of the machine (2.1e-4, 1.8e-4, 1.2e-5, 3.1e-4, 2.9e-4, 2.4e-4) give 0.16, 0.23, 0.28, 0.31, 0.30, 0.36 µV/V and not 0.27, 0.31, 0.28, 0.41, 0.40, 0.62. The list equals the Type A column in five places: most likely copied there.</source>
        <translation>Tipo B, tabla 3: difiere en cinco de seis sensores, porque las incertidumbres indicadas de la máquina (2.1e-4, 1.8e-4, 1.2e-5, 3.1e-4, 2.9e-4, 2.4e-4) dan 0.16, 0.23, 0.28, 0.31, 0.30, 0.36 µV/V y no 0.27, 0.31, 0.28, 0.41, 0.40, 0.62. La lista coincide con la columna de Tipo A en cinco lugares: lo más probable es que se copiara allí.</translation>
    </message>
    <message>
        <source>Table 4, Mx under Fy: differs, printed 1.55 %, is 0.15 %; the largest for Mx is 1.38 %, and the difference to its U 0.30 %, not 0.13 %.</source>
        <translation>Tabla 4, Mx bajo Fy: difiere, impreso 1.55 %, es 0.15 %; el mayor para Mx es 1.38 %, y la diferencia con su U 0.30 %, no 0.13 %.</translation>
    </message>
    <message>
        <source>Section 2.5 calls e_12 the output of Fy under Fx, but Table 4 divides by the rated output of the row: a row is taken as a sensor.</source>
        <translation>El apartado 2.5 llama e_12 a la salida de Fy bajo Fx, pero la tabla 4 divide por la salida nominal de la fila: una fila se toma como un sensor.</translation>
    </message>
    <message>
        <source>Eq 12 adds hysteresis and interference, limits that are not standard uncertainties, to an expanded uncertainty: the sum is neither a standard uncertainty nor a coverage interval.</source>
        <translation>La ec. 12 suma histéresis e interferencia, límites que no son incertidumbres típicas, a una incertidumbre expandida: la suma no es ni una incertidumbre típica ni un intervalo de cobertura.</translation>
    </message>
    <message>
        <source>The largest values of Type A and Type B need not occur at the same step. Eq 5 takes the rated output at every step. In 2.1.1 &quot;h=2&quot; of My and Mz is a slip.</source>
        <translation>Los mayores valores de Tipo A y de Tipo B no tienen por qué darse en el mismo escalón. La ec. 5 toma la salida nominal en todos los escalones. En 2.1.1, &quot;h=2&quot; de My y Mz es una errata.</translation>
    </message>
    <message>
        <source>A surface from an STL file - the robot cell, the part, the fixture, the room - that is drawn in the scenes of all analyses. It is context only: no number depends on it.</source>
        <translation>Una superficie de un archivo STL (la célula del robot, la pieza, el útil, la sala) que se dibuja en las escenas de todos los análisis. Es solo contexto: ningún número depende de ella.</translation>
    </message>
    <message>
        <source>The picture is fitted to what is measured, not to the mesh, which may be a whole hall.</source>
        <translation>La imagen se encuadra según lo que se mide, no según la malla, que puede ser una nave entera.</translation>
    </message>
    <message>
        <source>A file that is missing or damaged is warned of; analyses keep their results.</source>
        <translation>Se avisa de un archivo que falta o está dañado; los análisis conservan sus resultados.</translation>
    </message>
    <message>
        <source>Of the certificate and the report; what was typed stays as it is.</source>
        <translation>Del certificado y del informe; lo escrito queda como está.</translation>
    </message>
    <message>
        <source>distributions of %1</source>
        <translation>distribuciones de %1</translation>
    </message>
    <message>
        <source>and %1 more like these</source>
        <translation>y otros %1 como estos</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was not written: %2: %3</source>
        <translation>&apos;%1&apos; no se escribió: %2: %3</translation>
    </message>
    <message>
        <source>it cannot be opened</source>
        <translation>no se puede abrir</translation>
    </message>
    <message>
        <source>writing failed</source>
        <translation>falló la escritura</translation>
    </message>
    <message>
        <source>closing failed</source>
        <translation>falló el cierre</translation>
    </message>
    <message>
        <source>a file cannot be created in its folder &apos;%1&apos;</source>
        <translation>no se puede crear un archivo en su carpeta &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the permissions of the old file cannot be kept</source>
        <translation>no se pueden conservar los permisos del archivo anterior</translation>
    </message>
    <message>
        <source>flushing to the disk failed</source>
        <translation>falló la escritura en el disco</translation>
    </message>
    <message>
        <source>the new file cannot take its place</source>
        <translation>el archivo nuevo no puede ocupar su lugar</translation>
    </message>
    <message>
        <source>a folder</source>
        <translation>una carpeta</translation>
    </message>
    <message>
        <source>a pipe</source>
        <translation>una tubería</translation>
    </message>
    <message>
        <source>a socket</source>
        <translation>un socket</translation>
    </message>
    <message>
        <source>a device</source>
        <translation>un dispositivo</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be read: %2</source>
        <translation>&apos;%1&apos; no se puede leer: %2</translation>
    </message>
    <message>
        <source>it is %1, not a file</source>
        <translation>es %1, no un archivo</translation>
    </message>
    <message>
        <source>it is not a file</source>
        <translation>no es un archivo</translation>
    </message>
    <message>
        <source>it is too large: files of up to %1 MB are read, it has %2 MB</source>
        <translation>es demasiado grande: se leen archivos de hasta %1 MB, tiene %2 MB</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>es una carpeta</translation>
    </message>
    <message>
        <source>unit &quot;%1&quot;: %2</source>
        <translation>unidad &quot;%1&quot;: %2</translation>
    </message>
    <message>
        <source>a parenthesis is closed that was not opened.</source>
        <translation>se cierra un paréntesis que no se abrió.</translation>
    </message>
    <message>
        <source>write a product with &apos;*&apos; (&quot;N*m&quot;, &quot;W/(m*K)&quot;), not with a blank.</source>
        <translation>escriba un producto con &apos;*&apos; (&quot;N*m&quot;, &quot;W/(m*K)&quot;), no con un espacio.</translation>
    </message>
    <message>
        <source>a parenthesis is not closed.</source>
        <translation>no se cierra un paréntesis.</translation>
    </message>
    <message>
        <source>the exponent must be a whole number between -9 and 9, not 0 (&quot;mm^2&quot;).</source>
        <translation>el exponente debe ser un número entero entre -9 y 9, distinto de 0 (&quot;mm^2&quot;).</translation>
    </message>
    <message>
        <source>the exponents are too large.</source>
        <translation>los exponentes son demasiado grandes.</translation>
    </message>
    <message>
        <source>a unit is missing beside &apos;*&apos;, &apos;/&apos; or a parenthesis.</source>
        <translation>falta una unidad junto a &apos;*&apos;, &apos;/&apos; o un paréntesis.</translation>
    </message>
    <message>
        <source>numbers other than 1 do not belong in a unit; put them into the value.</source>
        <translation>en una unidad no caben números distintos de 1; póngalos en el valor.</translation>
    </message>
    <message>
        <source>the unit &quot;%1&quot; is not known.%2</source>
        <translation>la unidad &quot;%1&quot; no se conoce.%2</translation>
    </message>
    <message>
        <source>the text is too long for a unit.</source>
        <translation>el texto es demasiado largo para una unidad.</translation>
    </message>
    <message>
        <source>the unit is empty: write &quot;1&quot; for a pure number.</source>
        <translation>la unidad está vacía: escriba &quot;1&quot; para un número puro.</translation>
    </message>
    <message>
        <source> Known units, most of them with the prefixes of the SI: %1.</source>
        <translation> Unidades conocidas, la mayoría con los prefijos del SI: %1.</translation>
    </message>
    <message>
        <source> Did you mean %1?</source>
        <translation> ¿Se quiso decir %1?</translation>
    </message>
    <message>
        <source> Did you mean %1 or %2?</source>
        <translation> ¿Se quiso decir %1 o %2?</translation>
    </message>
    <message>
        <source>the attached file &apos;%1&apos; is broken</source>
        <translation>el archivo adjunto &apos;%1&apos; está dañado</translation>
    </message>
    <message>
        <source>the coverage probability must lie between 0 and 1.</source>
        <translation>la probabilidad de cobertura debe estar entre 0 y 1.</translation>
    </message>
    <message>
        <source>the effective degrees of freedom must be greater than 0.</source>
        <translation>los grados efectivos de libertad deben ser mayores que 0.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is defined by itself here, directly or through other definitions; an equation that is to be solved is written &apos;solve %1 = 1: ... = ...&apos;, with a starting value</source>
        <translation>&apos;%1&apos; se define aquí por sí mismo, directamente o por otras definiciones; una ecuación que ha de resolverse se escribe &apos;solve %1 = 1: ... = ...&apos;, con un valor inicial</translation>
    </message>
    <message>
        <source>the expression in columns %1-%2</source>
        <translation>la expresión de las columnas %1-%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither defined nor one of the quantities: give it a row in the table of quantities</source>
        <translation>&apos;%1&apos; ni se define ni es una de las magnitudes: dele una fila en la tabla de magnitudes</translation>
    </message>
    <message>
        <source>%1 is a difference of temperatures: its unit is K, not %2</source>
        <translation>%1 es una diferencia de temperaturas: su unidad es K, no %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; would be a condition: a definition must give a number</source>
        <translation>&apos;%1&apos; sería una condición: una definición debe dar un número</translation>
    </message>
    <message>
        <source>%1 is %2, %3 is %4: they cannot be equal</source>
        <translation>%1 es %2, %3 es %4: no pueden ser iguales</translation>
    </message>
    <message>
        <source>the equations do not depend on the unknown &apos;%1&apos;</source>
        <translation>las ecuaciones no dependen de la incógnita &apos;%1&apos;</translation>
    </message>
    <message>
        <source>this equation does not depend on any unknown</source>
        <translation>esta ecuación no depende de ninguna incógnita</translation>
    </message>
    <message>
        <source>this constant has no value (division by zero, or root of a negative number)</source>
        <translation>esta constante no tiene valor (división por cero, o raíz de un número negativo)</translation>
    </message>
    <message>
        <source>no equation defines &apos;%1&apos;</source>
        <translation>ninguna ecuación define &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is to be given in %2, but is %3</source>
        <translation>&apos;%1&apos; ha de darse en %2, pero es %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is %2, which has no unit of its own</source>
        <translation>&apos;%1&apos; es %2, que no tiene unidad propia</translation>
    </message>
    <message>
        <source>%1 is %2, %3 is %4</source>
        <translation>%1 es %2, %3 es %4</translation>
    </message>
    <message>
        <source>they cannot be added</source>
        <translation>no se pueden sumar</translation>
    </message>
    <message>
        <source>they cannot be subtracted</source>
        <translation>no se pueden restar</translation>
    </message>
    <message>
        <source>%1 is %2: %3</source>
        <translation>%1 es %2: %3</translation>
    </message>
    <message>
        <source>the exponent %1 is %2: an exponent must be a pure number</source>
        <translation>el exponente %1 es %2: un exponente debe ser un número puro</translation>
    </message>
    <message>
        <source>%1 is %2: its exponent must be a constant, or the dimension would vary</source>
        <translation>%1 es %2: su exponente debe ser una constante, o la dimensión variaría</translation>
    </message>
    <message>
        <source>atan2 needs two quantities of one kind</source>
        <translation>atan2 necesita dos magnitudes de la misma clase</translation>
    </message>
    <message>
        <source>a function of both needs quantities of one kind</source>
        <translation>una función de ambas necesita magnitudes de la misma clase</translation>
    </message>
    <message>
        <source>sin, cos and tan need an angle or a pure number</source>
        <translation>sin, cos y tan necesitan un ángulo o un número puro</translation>
    </message>
    <message>
        <source>an inverse function of an angle needs a pure number</source>
        <translation>una función inversa de un ángulo necesita un número puro</translation>
    </message>
    <message>
        <source>this function needs a pure number: divide by a quantity of the same kind</source>
        <translation>esta función necesita un número puro: divida por una magnitud de la misma clase</translation>
    </message>
    <message>
        <source>they cannot be compared</source>
        <translation>no se pueden comparar</translation>
    </message>
    <message>
        <source>%1 is not a condition: write a comparison, as in x &gt; 0</source>
        <translation>%1 no es una condición: escriba una comparación, como en x &gt; 0</translation>
    </message>
    <message>
        <source>a condition</source>
        <translation>una condición</translation>
    </message>
    <message>
        <source>a pure number</source>
        <translation>un número puro</translation>
    </message>
    <message>
        <source>measured in %1</source>
        <translation>medido en %1</translation>
    </message>
    <message>
        <source>%1 is a temperature in degC, %2 a difference of temperatures: give differences in K</source>
        <translation>%1 es una temperatura en degC, %2 una diferencia de temperaturas: dé las diferencias en K</translation>
    </message>
    <message>
        <source>%1 is a temperature in degC, and 0 has no unit: write 0 [degC], or 0 [K] for absolute zero</source>
        <translation>%1 es una temperatura en degC, y 0 no tiene unidad: escriba 0 [degC], o 0 [K] para el cero absoluto</translation>
    </message>
    <message>
        <source>%1 is a sum of temperatures in degC, which means nothing: give differences in K, or divide the sum by the number of temperatures for their mean</source>
        <translation>%1 es una suma de temperaturas en degC, que no significa nada: dé las diferencias en K, o divida la suma por el número de temperaturas para su media</translation>
    </message>
    <message>
        <source>%1 is not a condition: write a comparison, as in if(x &gt; 0, x, 0)</source>
        <translation>%1 no es una condición: escriba una comparación, como en if(x &gt; 0, x, 0)</translation>
    </message>
    <message>
        <source>both values of &apos;if&apos; must be numbers, not conditions</source>
        <translation>ambos valores de &apos;if&apos; deben ser números, no condiciones</translation>
    </message>
    <message>
        <source>both values of &apos;if&apos; must be of one kind</source>
        <translation>ambos valores de &apos;if&apos; deben ser de la misma clase</translation>
    </message>
    <message>
        <source>%1 is a condition: use it as the first argument of if(...)</source>
        <translation>%1 es una condición: úsela como primer argumento de if(...)</translation>
    </message>
    <message>
        <source>the end of the equation</source>
        <translation>el final de la ecuación</translation>
    </message>
    <message>
        <source>%1 is not a function; to multiply, write &apos;*&apos;. Functions are: %2</source>
        <translation>%1 no es una función; para multiplicar, escriba &apos;*&apos;. Las funciones son: %2</translation>
    </message>
    <message>
        <source>%1 needs %2 arguments; here it has %3</source>
        <translation>%1 necesita %2 argumentos; aquí tiene %3</translation>
    </message>
    <message>
        <source>%1 needs %2 to %3 arguments; here it has %4</source>
        <translation>%1 necesita de %2 a %3 argumentos; aquí tiene %4</translation>
    </message>
    <message>
        <source>&apos;+&apos; stands here twice</source>
        <translation>&apos;+&apos; aparece aquí dos veces</translation>
    </message>
    <message>
        <source>the expression is nested more than %1 levels deep: split it into definitions</source>
        <translation>la expresión tiene más de %1 niveles de anidamiento: divídala en definiciones</translation>
    </message>
    <message>
        <source>a unit in brackets belongs behind a number: 20 [degC]</source>
        <translation>una unidad entre corchetes va detrás de un número: 20 [degC]</translation>
    </message>
    <message>
        <source>a number, a name or a parenthesis is expected here, not %1</source>
        <translation>aquí se espera un número, un nombre o un paréntesis, no %1</translation>
    </message>
    <message>
        <source>this parenthesis is not closed</source>
        <translation>este paréntesis no está cerrado</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a function: its argument follows in parentheses</source>
        <translation>&apos;%1&apos; es una función: su argumento sigue entre paréntesis</translation>
    </message>
    <message>
        <source>the word &apos;%1&apos; is not expected here</source>
        <translation>aquí no se espera la palabra &apos;%1&apos;</translation>
    </message>
    <message>
        <source>an operator, a comma or &apos;)&apos; is expected here, not %1</source>
        <translation>aquí se espera un operador, una coma o &apos;)&apos;, no %1</translation>
    </message>
    <message>
        <source>this parenthesis closes nothing</source>
        <translation>este paréntesis no cierra nada</translation>
    </message>
    <message>
        <source>an equation defines one name: write &apos;y = ...&apos;; to compare, write &apos;==&apos;; an equation that is to be solved starts with &apos;solve&apos;</source>
        <translation>una ecuación define un nombre: escriba &apos;y = ...&apos;; para comparar, escriba &apos;==&apos;; una ecuación que ha de resolverse empieza por &apos;solve&apos;</translation>
    </message>
    <message>
        <source>an operator is missing before %1</source>
        <translation>falta un operador antes de %1</translation>
    </message>
    <message>
        <source>%1 is not expected here</source>
        <translation>aquí no se espera %1</translation>
    </message>
    <message>
        <source>an equation starts with the name that it defines: y = ...</source>
        <translation>una ecuación empieza por el nombre que define: y = ...</translation>
    </message>
    <message>
        <source>a name with its starting value is expected here: y = 1</source>
        <translation>aquí se espera un nombre con su valor inicial: y = 1</translation>
    </message>
    <message>
        <source>a function</source>
        <translation>una función</translation>
    </message>
    <message>
        <source>a word of the language</source>
        <translation>una palabra del lenguaje</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is %2: choose another name</source>
        <translation>&apos;%1&apos; es %2: elija otro nombre</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is defined twice</source>
        <translation>&apos;%1&apos; se define dos veces</translation>
    </message>
    <message>
        <source>a colon is expected before the equations to be solved: solve y = 1: y^2 = x</source>
        <translation>se esperan dos puntos antes de las ecuaciones que han de resolverse: solve y = 1: y^2 = x</translation>
    </message>
    <message>
        <source>%1 unknowns need as many equations; there are %2</source>
        <translation>%1 incógnitas necesitan otras tantas ecuaciones; hay %2</translation>
    </message>
    <message>
        <source>an equals sign is expected in an equation to be solved</source>
        <translation>se espera un signo igual en una ecuación que ha de resolverse</translation>
    </message>
    <message>
        <source>line %1, column %2: </source>
        <translation>línea %1, columna %2: </translation>
    </message>
    <message>
        <source>line %1, columns %2-%3: </source>
        <translation>línea %1, columnas %2-%3: </translation>
    </message>
    <message>
        <source>this number is too large or too small to compute with</source>
        <translation>este número es demasiado grande o demasiado pequeño para calcular con él</translation>
    </message>
    <message>
        <source>the bracket of a unit is not closed: write &apos;]&apos; behind the unit</source>
        <translation>el corchete de una unidad no está cerrado: escriba &apos;]&apos; detrás de la unidad</translation>
    </message>
    <message>
        <source>the character &apos;%1&apos; does not belong in an equation</source>
        <translation>el carácter &apos;%1&apos; no puede estar en una ecuación</translation>
    </message>
    <message>
        <source>the equations have %1 characters; more than %2 are not read: put tables of data into assets or observations</source>
        <translation>las ecuaciones tienen %1 caracteres; no se leen más de %2: ponga las tablas de datos en recursos u observaciones</translation>
    </message>
    <message>
        <source>the coverage factor k must be greater than zero</source>
        <translation>el factor de cobertura k debe ser mayor que cero</translation>
    </message>
    <message>
        <source>the coverage probability must lie between 0 and 100 %</source>
        <translation>la probabilidad de cobertura debe estar entre 0 y 100 %</translation>
    </message>
    <message>
        <source>the limits give the estimate: leave the value empty, or state a half-width</source>
        <translation>los límites dan la estimación: deje vacío el valor, o indique una semianchura</translation>
    </message>
    <message>
        <source>the lower limit is above the upper limit</source>
        <translation>el límite inferior está por encima del superior</translation>
    </message>
    <message>
        <source>a relative part of the permissible error needs the value of the quantity</source>
        <translation>una parte relativa del error permitido necesita el valor de la magnitud</translation>
    </message>
    <message>
        <source>an exponential distribution needs an estimate greater than zero</source>
        <translation>una distribución exponencial necesita una estimación mayor que cero</translation>
    </message>
    <message>
        <source>the number of counts must be whole</source>
        <translation>el número de cuentas debe ser entero</translation>
    </message>
    <message>
        <source>the counts give the estimate: leave the value empty</source>
        <translation>las cuentas dan la estimación: deje vacío el valor</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not used by this statement: leave it empty</source>
        <translation>esta indicación no usa &apos;%1&apos;: déjelo vacío</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is missing: %2</source>
        <translation>falta &apos;%1&apos;: %2</translation>
    </message>
    <message>
        <source>&apos;a&apos; must not be negative</source>
        <translation>&apos;a&apos; no debe ser negativo</translation>
    </message>
    <message>
        <source>give the degrees of freedom or the relative uncertainty of u, not both</source>
        <translation>indique los grados de libertad o la incertidumbre relativa de u, no ambos</translation>
    </message>
    <message>
        <source>the degrees of freedom must be greater than zero</source>
        <translation>los grados de libertad deben ser mayores que cero</translation>
    </message>
    <message>
        <source>the relative uncertainty of u must not be negative</source>
        <translation>la incertidumbre relativa de u no debe ser negativa</translation>
    </message>
    <message>
        <source>there is no statement &apos;%1&apos;</source>
        <translation>no hay ninguna indicación &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not understood here</source>
        <translation>aquí no se entiende &apos;%1&apos;</translation>
    </message>
    <message>
        <source>a number is missing after &apos;%1&apos;</source>
        <translation>falta un número después de &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no way to state an uncertainty. For example: 75 nm; U = 0.3 um, k = 2; rectangular 0.5; resolution 0.01; constant</source>
        <translation>&apos;%1&apos; no es una forma de indicar una incertidumbre. Por ejemplo: 75 nm; U = 0,3 um, k = 2; rectangular 0,5; resolución 0,01; constante</translation>
    </message>
    <message>
        <source>%1 has %2 figure</source>
        <translation>%1 tiene %2 cifra</translation>
    </message>
    <message>
        <source>%1 has %2 figures</source>
        <translation>%1 tiene %2 cifras</translation>
    </message>
    <message>
        <source>a figure is missing: an expanded uncertainty needs k = ... or p = ... %</source>
        <translation>falta una cifra: una incertidumbre expandida necesita k = ... o p = ... %</translation>
    </message>
    <message>
        <source>a figure is missing: it is noted as %1</source>
        <translation>falta una cifra: se anota como %1</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no part of it: it is noted as %2</source>
        <translation>&apos;%1&apos; no forma parte de ello: se anota como %2</translation>
    </message>
    <message>
        <source>it has no unit</source>
        <translation>no tiene unidad</translation>
    </message>
    <message>
        <source>the second figure has no unit but %</source>
        <translation>la segunda cifra no tiene más unidad que %</translation>
    </message>
    <message>
        <source>the second figure has no unit</source>
        <translation>la segunda cifra no tiene unidad</translation>
    </message>
    <message>
        <source>the further part is one in %: write MPE 3 + 0.1 %</source>
        <translation>la otra parte es en %: escriba MPE 3 + 0.1 %</translation>
    </message>
    <message>
        <source>say which it is: k = ... or p = ... %</source>
        <translation>diga cuál es: k = ... o p = ... %</translation>
    </message>
    <message>
        <source>a part of the value needs the value</source>
        <translation>una parte del valor necesita el valor</translation>
    </message>
    <message>
        <source>%1 is no unit for a quantity in %2</source>
        <translation>%1 no es una unidad para una magnitud en %2</translation>
    </message>
    <message>
        <source>a Type A evaluation needs at least two observations.</source>
        <translation>una evaluación tipo A necesita al menos dos observaciones.</translation>
    </message>
    <message>
        <source>one of the observations is not a finite number.</source>
        <translation>una de las observaciones no es un número finito.</translation>
    </message>
    <message>
        <source>there is no series to be pooled.</source>
        <translation>no hay ninguna serie que agrupar.</translation>
    </message>
    <message>
        <source>the covariance of two means needs observations made in pairs: the series have different lengths.</source>
        <translation>la covarianza de dos medias necesita observaciones hechas por pares: las series tienen longitudes distintas.</translation>
    </message>
    <message>
        <source>the covariance of two means needs at least two pairs.</source>
        <translation>la covarianza de dos medias necesita al menos dos pares.</translation>
    </message>
    <message>
        <source>the components %1 and %2 are given two different correlations; a quantity that combines its components arithmetically needs +1 or -1.</source>
        <translation>se dan dos correlaciones distintas a las componentes %1 y %2; una magnitud que combina sus componentes aritméticamente necesita +1 o -1.</translation>
    </message>
    <message>
        <source>a correlation refers to component number %1 of %2.</source>
        <translation>una correlación remite a la componente número %1 de %2.</translation>
    </message>
    <message>
        <source>a correlation is given between the component %1 and itself.</source>
        <translation>se da una correlación entre la componente %1 y ella misma.</translation>
    </message>
    <message>
        <source>the correlation of the components %1 and %2 must lie between -1 and 1.</source>
        <translation>la correlación de las componentes %1 y %2 debe estar entre -1 y 1.</translation>
    </message>
    <message>
        <source>the quantity &quot;%1&quot; refers to component number %2 of %3.</source>
        <translation>la magnitud &quot;%1&quot; remite a la componente número %2 de %3.</translation>
    </message>
    <message>
        <source>the correlations of the components %1 contradict each other: the smallest eigenvalue of their correlation matrix is %2, it must not be negative.</source>
        <translation>las correlaciones de las componentes %1 se contradicen: el menor autovalor de su matriz de correlación es %2, no debe ser negativo.</translation>
    </message>
    <message>
        <source>the component %1 is a coordinate of a vector of random direction and cannot be correlated with another component; give it a normal distribution first.</source>
        <translation>la componente %1 es una coordenada de un vector de dirección aleatoria y no puede correlacionarse con otra componente; dele antes una distribución normal.</translation>
    </message>
    <message>
        <source>the estimate of variance &quot;%1&quot; has component number %2, which does not exist or rests on two estimates.</source>
        <translation>la estimación de varianza &quot;%1&quot; tiene la componente número %2, que no existe o se apoya en dos estimaciones.</translation>
    </message>
    <message>
        <source>the component %1 rests on the estimate of variance &quot;%2&quot; with others: it needs a normal or Student t distribution and their finite degrees of freedom.</source>
        <translation>la componente %1 se apoya con otras en la estimación de varianza &quot;%2&quot;: necesita una distribución normal o t de Student y sus grados de libertad finitos.</translation>
    </message>
    <message>
        <source>the components %1 and %2 cannot have the correlation %3: with these distributions it lies between %4 and %5.</source>
        <translation>las componentes %1 y %2 no pueden tener la correlación %3: con estas distribuciones está entre %4 y %5.</translation>
    </message>
    <message>
        <source>%1 distribution: %2</source>
        <translation>distribución %1: %2</translation>
    </message>
    <message>
        <source>the %1 must be a finite number.</source>
        <translation>%1: debe ser un número finito.</translation>
    </message>
    <message>
        <source>the %1 is too large (at most 1e150).</source>
        <translation>%1: es demasiado grande (como máximo 1e150).</translation>
    </message>
    <message>
        <source>the %1 must not be negative.</source>
        <translation>%1: no debe ser negativo.</translation>
    </message>
    <message>
        <source>the %1 must lie between 0.001 and 1000000.</source>
        <translation>%1: debe estar entre 0.001 y 1000000.</translation>
    </message>
    <message>
        <source>the lower limit must not be greater than the upper limit.</source>
        <translation>el límite inferior no debe ser mayor que el superior.</translation>
    </message>
    <message>
        <source>the degrees of freedom must be at least 0.2 (they may be infinite).</source>
        <translation>los grados de libertad deben ser al menos 0.2 (pueden ser infinitos).</translation>
    </message>
    <message>
        <source>the inexactness of the limits must not exceed half the distance between them.</source>
        <translation>la inexactitud de los límites no debe superar la mitad de la distancia entre ellos.</translation>
    </message>
    <message>
        <source>the ratio beta of top to base must lie between 0 and 1.</source>
        <translation>la razón beta de la base superior a la inferior debe estar entre 0 y 1.</translation>
    </message>
    <message>
        <source>one of the limits excludes every value.</source>
        <translation>uno de los límites excluye todo valor.</translation>
    </message>
    <message>
        <source>the mean value lies outside the limits.</source>
        <translation>el valor medio está fuera de los límites.</translation>
    </message>
    <message>
        <source>the limits lie so far from the mean value that no probability is left between them.</source>
        <translation>los límites están tan lejos del valor medio que no queda probabilidad entre ellos.</translation>
    </message>
    <message>
        <source>mean value of the logarithm</source>
        <translation>valor medio del logaritmo</translation>
    </message>
    <message>
        <source>the parameters of the logarithm are too large: the quantity has no finite variance in numbers.</source>
        <translation>los parámetros del logaritmo son demasiado grandes: la magnitud no tiene varianza finita en números.</translation>
    </message>
    <message>
        <source>a discrete distribution needs at least one value.</source>
        <translation>una distribución discreta necesita al menos un valor.</translation>
    </message>
    <message>
        <source>there must be as many probabilities as values.</source>
        <translation>debe haber tantas probabilidades como valores.</translation>
    </message>
    <message>
        <source>values</source>
        <translation>valores</translation>
    </message>
    <message>
        <source>probabilities</source>
        <translation>probabilidades</translation>
    </message>
    <message>
        <source>the probabilities must sum to 1.</source>
        <translation>las probabilidades deben sumar 1.</translation>
    </message>
    <message>
        <source>discrete distribution: there must be as many probabilities as values.</source>
        <translation>distribución discreta: debe haber tantas probabilidades como valores.</translation>
    </message>
    <message>
        <source>%1 distribution: %2 parameters are needed, %3 are given.</source>
        <translation>distribución %1: se necesitan %2 parámetros, se dan %3.</translation>
    </message>
    <message>
        <source>the distribution &quot;%1&quot; is not known. Known distributions: %2.</source>
        <translation>no se conoce la distribución &quot;%1&quot;. Distribuciones conocidas: %2.</translation>
    </message>
    <message>
        <source>%1 in row %2 of %3</source>
        <translation>%1 en la fila %2 de %3</translation>
    </message>
    <message>
        <source>greater than %1 and at most %2</source>
        <translation>mayor que %1 y como máximo %2</translation>
    </message>
    <message>
        <source>between %1 and %2</source>
        <translation>entre %1 y %2</translation>
    </message>
    <message>
        <source>greater than %1</source>
        <translation>mayor que %1</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>al menos %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>como máximo %1</translation>
    </message>
    <message>
        <source>%1 must be a whole number; it is %2</source>
        <translation>%1 debe ser un número entero; es %2</translation>
    </message>
    <message>
        <source>%1 is too large a number: %2</source>
        <translation>%1 es un número demasiado grande: %2</translation>
    </message>
    <message>
        <source>%1 must be %2; it is %3</source>
        <translation>%1 debe ser %2; es %3</translation>
    </message>
    <message>
        <source>%1 must be one of %2; it is %3%4</source>
        <translation>%1 debe ser uno de %2; es %3%4</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un número</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>un número entero</translation>
    </message>
    <message>
        <source>one of its choices</source>
        <translation>una de sus opciones</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texto</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true o false</translation>
    </message>
    <message>
        <source>a pose</source>
        <translation>una pose</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>una tabla</translation>
    </message>
    <message>
        <source>the id of an asset</source>
        <translation>el id de un recurso</translation>
    </message>
    <message>
        <source>%1 must be %2</source>
        <translation>%1 debe ser %2</translation>
    </message>
    <message>
        <source>%1 needs at least 1 row; it has %2</source>
        <translation>%1 necesita al menos 1 fila; tiene %2</translation>
    </message>
    <message>
        <source>%1 needs at least %2 rows; it has %3</source>
        <translation>%1 necesita al menos %2 filas; tiene %3</translation>
    </message>
    <message>
        <source>%1 has %2 columns, but %3 units</source>
        <translation>%1 tiene %2 columnas, pero %3 unidades</translation>
    </message>
    <message>
        <source>row %1 of %2 has %3 cells; there are %4 columns</source>
        <translation>la fila %1 de %2 tiene %3 celdas; hay %4 columnas</translation>
    </message>
    <message>
        <source>%1 is empty</source>
        <translation>%1 está vacío</translation>
    </message>
    <message>
        <source>%1 must not be empty</source>
        <translation>%1 no debe estar vacío</translation>
    </message>
    <message>
        <source>%1 must be given (&apos;%2&apos; is missing)</source>
        <translation>%1 debe darse (falta &apos;%2&apos;)</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; is %3; &apos;%4&apos; is the unit of %5</source>
        <translation>la columna &apos;%1&apos; de &apos;%2&apos; es %3; &apos;%4&apos; es la unidad de %5</translation>
    </message>
    <message>
        <source>there is no field &apos;%1&apos; here%2</source>
        <translation>aquí no hay ningún campo &apos;%1&apos;%2</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>una longitud</translation>
    </message>
    <message>
        <source>an area</source>
        <translation>un área</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>un volumen</translation>
    </message>
    <message>
        <source>a mass</source>
        <translation>una masa</translation>
    </message>
    <message>
        <source>a time</source>
        <translation>un tiempo</translation>
    </message>
    <message>
        <source>a frequency</source>
        <translation>una frecuencia</translation>
    </message>
    <message>
        <source>an electric current</source>
        <translation>una corriente eléctrica</translation>
    </message>
    <message>
        <source>a temperature</source>
        <translation>una temperatura</translation>
    </message>
    <message>
        <source>an expansion coefficient</source>
        <translation>un coeficiente de dilatación</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>un ángulo</translation>
    </message>
    <message>
        <source>a velocity</source>
        <translation>una velocidad</translation>
    </message>
    <message>
        <source>an acceleration</source>
        <translation>una aceleración</translation>
    </message>
    <message>
        <source>a force</source>
        <translation>una fuerza</translation>
    </message>
    <message>
        <source>a moment</source>
        <translation>un momento</translation>
    </message>
    <message>
        <source>a pressure</source>
        <translation>una presión</translation>
    </message>
    <message>
        <source>a stiffness</source>
        <translation>una rigidez</translation>
    </message>
    <message>
        <source>a voltage</source>
        <translation>una tensión eléctrica</translation>
    </message>
    <message>
        <source>an electric resistance</source>
        <translation>una resistencia eléctrica</translation>
    </message>
    <message>
        <source>an electric charge</source>
        <translation>una carga eléctrica</translation>
    </message>
    <message>
        <source>a capacitance</source>
        <translation>una capacitancia</translation>
    </message>
    <message>
        <source>an inductance</source>
        <translation>una inductancia</translation>
    </message>
    <message>
        <source>a magnetic flux density</source>
        <translation>una densidad de flujo magnético</translation>
    </message>
    <message>
        <source>a magnetic flux</source>
        <translation>un flujo magnético</translation>
    </message>
    <message>
        <source>a power</source>
        <translation>una potencia</translation>
    </message>
    <message>
        <source>an amount of substance</source>
        <translation>una cantidad de sustancia</translation>
    </message>
    <message>
        <source>a luminous intensity</source>
        <translation>una intensidad luminosa</translation>
    </message>
    <message>
        <source>an angular velocity</source>
        <translation>una velocidad angular</translation>
    </message>
    <message>
        <source>a density</source>
        <translation>una densidad</translation>
    </message>
    <message>
        <source> (did you mean &apos;%1&apos;?)</source>
        <translation> (¿quiso decir &apos;%1&apos;?)</translation>
    </message>
    <message>
        <source>%1 must be a finite number; it is %2</source>
        <translation>%1 debe ser un número finito; es %2</translation>
    </message>
    <message>
        <source>%1 is too large to be computed with (at most 1e100): it is %2</source>
        <translation>%1 es demasiado grande para calcular con él (como máximo 1e100): es %2</translation>
    </message>
    <message>
        <source>%1 is %2; %3 has no unit</source>
        <translation>%1 es %2; %3 no tiene unidad</translation>
    </message>
    <message>
        <source>%1 is %2; %3 is %4</source>
        <translation>%1 es %2; %3 es %4</translation>
    </message>
    <message>
        <source>the result does not represent the measurand: more than 1 % of the trials have no value</source>
        <translation>el resultado no representa el mensurando: más del 1 % de las pruebas no tienen valor</translation>
    </message>
    <message>
        <source>U = k u with the coverage factor that was fixed.</source>
        <translation>U = k u con el factor de cobertura que se fijó.</translation>
    </message>
    <message>
        <source>U is half the width of the probabilistically symmetric coverage interval, and k = U/u.</source>
        <translation>U es la mitad de la anchura del intervalo de cobertura probabilísticamente simétrico, y k = U/u.</translation>
    </message>
    <message>
        <source>U = k u with k of the t distribution for the effective degrees of freedom.</source>
        <translation>U = k u con k de la distribución t para los grados efectivos de libertad.</translation>
    </message>
    <message>
        <source>the number of significant digits of the numerical tolerance must be 1, 2, 3 or 4</source>
        <translation>el número de cifras significativas de la tolerancia numérica debe ser 1, 2, 3 o 4</translation>
    </message>
    <message>
        <source>the numerical tolerance must be greater than zero</source>
        <translation>la tolerancia numérica debe ser mayor que cero</translation>
    </message>
    <message>
        <source>the adaptive procedure needs at least two batches</source>
        <translation>el procedimiento adaptativo necesita al menos dos lotes</translation>
    </message>
    <message>
        <source>the adaptive procedure needs at least two batches: allow %1 trials or more</source>
        <translation>el procedimiento adaptativo necesita al menos dos lotes: permita %1 pruebas o más</translation>
    </message>
    <message>
        <source>a Monte Carlo run needs at least two trials</source>
        <translation>una ejecución de Monte Carlo necesita al menos dos pruebas</translation>
    </message>
    <message>
        <source>the coverage probability must lie between 0 and 1</source>
        <translation>la probabilidad de cobertura debe estar entre 0 y 1</translation>
    </message>
    <message>
        <source>the coverage probability is too near to 1</source>
        <translation>la probabilidad de cobertura está demasiado cerca de 1</translation>
    </message>
    <message>
        <source>the coverage factor must be greater than zero</source>
        <translation>el factor de cobertura debe ser mayor que cero</translation>
    </message>
    <message>
        <source>one-at-a-time Monte Carlo needs at least two trials</source>
        <translation>Monte Carlo de uno en uno necesita al menos dos pruebas</translation>
    </message>
    <message>
        <source>Monte Carlo without a contributor needs at least two trials</source>
        <translation>Monte Carlo sin una contribución necesita al menos dos pruebas</translation>
    </message>
    <message>
        <source>Sobol indices need at least 100 trials</source>
        <translation>los índices de Sobol necesitan al menos 100 pruebas</translation>
    </message>
    <message>
        <source>the evaluation was stopped</source>
        <translation>se detuvo la evaluación</translation>
    </message>
    <message>
        <source>none of the trials has a value: the measurement model cannot be evaluated within the uncertainties of its inputs; check the standard uncertainties and the geometry</source>
        <translation>ninguna de las pruebas tiene valor: el modelo de medición no se puede evaluar dentro de las incertidumbres de sus entradas; compruebe las incertidumbres típicas y la geometría</translation>
    </message>
    <message>
        <source>the linear part explains %1 % of the variance: a gain of %2</source>
        <translation>la parte lineal explica el %1 % de la varianza: una ganancia de %2</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>no trial has a value</source>
        <translation>ninguna prueba tiene valor</translation>
    </message>
    <message>
        <source>the measurement model has no sensitivity coefficients near the estimates: second-order terms do not exist</source>
        <translation>el modelo de medición no tiene coeficientes de sensibilidad cerca de las estimaciones: no existen términos de segundo orden</translation>
    </message>
    <message>
        <source>there are too many quantities for them</source>
        <translation>hay demasiadas magnitudes para ellos</translation>
    </message>
    <message>
        <source>the degrees of freedom of %1 must be greater than zero</source>
        <translation>los grados de libertad de %1 deben ser mayores que cero</translation>
    </message>
    <message>
        <source>the degrees of freedom of %1 are too few: there must be at least 0.2</source>
        <translation>los grados de libertad de %1 son demasiado pocos: debe haber al menos 0,2</translation>
    </message>
    <message>
        <source>the distribution of %1 has no finite mean or standard uncertainty</source>
        <translation>la distribución de %1 no tiene media o incertidumbre típica finita</translation>
    </message>
    <message>
        <source>the estimate of %1 is not a finite number</source>
        <translation>la estimación de %1 no es un número finito</translation>
    </message>
    <message>
        <source>quantity %1 refers to a component that does not exist, or with a factor that is not finite</source>
        <translation>la magnitud %1 remite a una componente que no existe, o con un factor que no es finito</translation>
    </message>
    <message>
        <source>the measurement model has %1 input quantities, but %2 were given</source>
        <translation>el modelo de medición tiene %1 magnitudes de entrada, pero se dieron %2</translation>
    </message>
    <message>
        <source>the measurement model has no output quantities</source>
        <translation>el modelo de medición no tiene magnitudes de salida</translation>
    </message>
    <message>
        <source>its correlated components are not normally distributed</source>
        <translation>sus componentes correlacionadas no tienen distribución normal</translation>
    </message>
    <message>
        <source>no spread</source>
        <translation>sin dispersión</translation>
    </message>
    <message>
        <source>normal as far as so few trials can tell</source>
        <translation>normal hasta donde pueden decirlo tan pocas pruebas</translation>
    </message>
    <message>
        <source>normal within 1 %</source>
        <translation>normal dentro del 1 %</translation>
    </message>
    <message>
        <source>normal within 5 %</source>
        <translation>normal dentro del 5 %</translation>
    </message>
    <message>
        <source>too skewed for k u</source>
        <translation>demasiado asimétrica para k u</translation>
    </message>
    <message>
        <source>too heavy-tailed for k u</source>
        <translation>de colas demasiado pesadas para k u</translation>
    </message>
    <message>
        <source>too flat for k u</source>
        <translation>demasiado plana para k u</translation>
    </message>
    <message>
        <source>Second-order terms are left out: the formula of JCGM 100 5.1.2 assumes independent components, and some of these are correlated.</source>
        <translation>Se omiten los términos de segundo orden: la fórmula de JCGM 100 5.1.2 supone componentes independientes, y algunas de estas están correlacionadas.</translation>
    </message>
    <message>
        <source>Second-order terms are left out: %1.</source>
        <translation>Se omiten los términos de segundo orden: %1.</translation>
    </message>
    <message>
        <source>%1 of %2 trials (%3 %) have no value (the measurement model cannot be evaluated there) and are not part of the statistics.</source>
        <translation>%1 de %2 pruebas (%3 %) no tienen valor (el modelo de medición no puede evaluarse ahí) y no forman parte de la estadística.</translation>
    </message>
    <message>
        <source>The result does not represent the measurand: more than 1 % of the trials are lost, and they are not a random choice.</source>
        <translation>El resultado no representa el mensurando: se pierde más del 1 % de las pruebas, y no son una elección al azar.</translation>
    </message>
    <message>
        <source>The adaptive procedure stopped at %1 trials before its results were stable: allow more trials, or ask for fewer significant digits.</source>
        <translation>El procedimiento adaptativo se detuvo en %1 pruebas antes de que sus resultados fueran estables: permita más pruebas, o pida menos cifras significativas.</translation>
    </message>
    <message>
        <source>Coverage intervals are interpolated in fine cells: there are too many trials to keep the values of the tails in memory.</source>
        <translation>Los intervalos de cobertura se interpolan en celdas finas: hay demasiadas pruebas para mantener en memoria los valores de las colas.</translation>
    </message>
    <message>
        <source>The correlations stated cannot all hold with these distributions: the nearest that can are drawn, with coefficients that differ by up to %1.</source>
        <translation>Las correlaciones indicadas no pueden cumplirse todas con estas distribuciones: se extraen las más próximas posibles, con coeficientes que difieren hasta en %1.</translation>
    </message>
    <message>
        <source>The angle %1%2 is hardly determined: its standard uncertainty exceeds 1 rad.</source>
        <translation>El ángulo %1%2 apenas está determinado: su incertidumbre típica supera 1 rad.</translation>
    </message>
    <message>
        <source>Nothing is gained by variance reduction, and standard errors are not known: there are fewer than %1 batches of %2 trials.</source>
        <translation>No se gana nada con la reducción de varianza, y no se conocen errores típicos: hay menos de %1 lotes de %2 pruebas.</translation>
    </message>
    <message>
        <source>Control variates are not used: the linear part of the trials that have a value has another distribution than that of all trials.</source>
        <translation>No se usan variables de control: la parte lineal de las pruebas que tienen valor tiene otra distribución que la de todas las pruebas.</translation>
    </message>
    <message>
        <source>Without control variate: %1.</source>
        <translation>Sin variable de control: %1.</translation>
    </message>
    <message>
        <source>The standard uncertainty by Monte Carlo of %1 does not exist, because a Student t distribution with two degrees of freedom or fewer has no finite standard deviation: it is shown as infinite, and U is half the width of the coverage interval.</source>
        <translation>La incertidumbre típica por Monte Carlo de %1 no existe, porque una distribución t de Student con dos grados de libertad o menos no tiene desviación típica finita: se muestra como infinita, y U es la mitad de la anchura del intervalo de cobertura.</translation>
    </message>
    <message>
        <source>The standard uncertainty by Monte Carlo of %1 cannot stabilise, because Student t distributions with four degrees of freedom or fewer have no finite fourth moment: the adaptive procedure judges by the coverage intervals; use these.</source>
        <translation>La incertidumbre típica por Monte Carlo de %1 no puede estabilizarse, porque las distribuciones t de Student con cuatro grados de libertad o menos no tienen cuarto momento finito: el procedimiento adaptativo juzga por los intervalos de cobertura; use estos.</translation>
    </message>
    <message>
        <source>the measurement model has no value at the estimates of its input quantities%1: check the nominal geometry and the values entered</source>
        <translation>el modelo de medición no tiene valor en las estimaciones de sus magnitudes de entrada%1: compruebe la geometría nominal y los valores introducidos</translation>
    </message>
    <message>
        <source>Effective degrees of freedom are approximate: the Welch-Satterthwaite formula assumes independent components, and correlated components with finite degrees of freedom contribute. The Monte Carlo coverage interval is the better guide.</source>
        <translation>Los grados efectivos de libertad son aproximados: la fórmula de Welch-Satterthwaite supone componentes independientes, y contribuyen componentes correlacionadas con grados de libertad finitos. El intervalo de cobertura de Monte Carlo es mejor guía.</translation>
    </message>
    <message>
        <source>1 vector of random direction has coordinates with different distributions after editing: they are drawn independently.</source>
        <translation>1 vector de dirección aleatoria tiene coordenadas con distribuciones distintas tras la edición: se extraen de forma independiente.</translation>
    </message>
    <message>
        <source>%1 vectors of random direction have coordinates with different distributions after editing: they are drawn independently.</source>
        <translation>%1 vectores de dirección aleatoria tienen coordenadas con distribuciones distintas tras la edición: se extraen de forma independiente.</translation>
    </message>
    <message>
        <source>The angle %1 is hardly determined: its standard uncertainty by the law of propagation exceeds 1 rad.</source>
        <translation>El ángulo %1 apenas está determinado: su incertidumbre típica por la ley de propagación supera 1 rad.</translation>
    </message>
    <message>
        <source>a tolerance of %1 %2 for %3 (u = %4 %2) needs about %5 trials (%6 batches)</source>
        <translation>una tolerancia de %1 %2 para %3 (u = %4 %2) necesita unas %5 pruebas (%6 lotes)</translation>
    </message>
    <message>
        <source>to correct the bias of coordinate %1, give the number of observations n in its row: the uncertainty of the correction is u_var/sqrt(n)</source>
        <translation>para corregir el sesgo de la coordenada %1, dé en su fila el número de observaciones n: la incertidumbre de la corrección es u_var/sqrt(n)</translation>
    </message>
    <message>
        <source>there are two points called &apos;%1&apos;; rename one</source>
        <translation>hay dos puntos llamados &apos;%1&apos;; cambie el nombre de uno</translation>
    </message>
    <message>
        <source>there is no calibrated point called &apos;%1&apos;</source>
        <translation>no hay ningún punto calibrado llamado &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must consist of the letters x, y and z</source>
        <translation>&apos;%1&apos; debe formarse con las letras x, y y z</translation>
    </message>
    <message>
        <source>coordinate %1 has fewer than two observations that do not define the frame: measure more points or runs</source>
        <translation>la coordenada %1 tiene menos de dos observaciones que no definen el sistema: mida más puntos o series</translation>
    </message>
    <message>
        <source>coordinate %1 has %2 rows; it must have one</source>
        <translation>la coordenada %1 tiene %2 filas; debe tener una</translation>
    </message>
    <message>
        <source>the length standard needs at least two observations</source>
        <translation>el patrón de longitud necesita al menos dos observaciones</translation>
    </message>
    <message>
        <source>the table must have one row; it has %1</source>
        <translation>la tabla debe tener una fila; tiene %1</translation>
    </message>
    <message>
        <source>the analysis has no point called &apos;%1&apos;</source>
        <translation>el análisis no tiene ningún punto llamado &apos;%1&apos;</translation>
    </message>
    <message>
        <source>point %1: %2</source>
        <translation>punto %1: %2</translation>
    </message>
    <message>
        <source>it is at the place of the instrument</source>
        <translation>está en el lugar del instrumento</translation>
    </message>
    <message>
        <source>it is out of the range or field of view of the instrument</source>
        <translation>está fuera del alcance o del campo de visión del instrumento</translation>
    </message>
    <message>
        <source>correlated coordinates of a station are combinations of independent deviations, which are normal: leave the distribution normal, or the correlation out</source>
        <translation>las coordenadas correlacionadas de una estación son combinaciones de desviaciones independientes, que son normales: deje la distribución normal, o quite la correlación</translation>
    </message>
    <message>
        <source>a coordinate of the station is correlated with itself; name two different ones</source>
        <translation>una coordenada de la estación está correlacionada consigo misma; nombre dos distintas</translation>
    </message>
    <message>
        <source>the range ends before it begins: the longest distance must be greater than the shortest</source>
        <translation>el alcance termina antes de empezar: la distancia mayor debe ser mayor que la menor</translation>
    </message>
    <message>
        <source>the sensor reads nothing: choose a distance or an angle</source>
        <translation>el sensor no lee nada: elija una distancia o un ángulo</translation>
    </message>
    <message>
        <source>these coefficients are not possible together: their matrix has a negative eigenvalue</source>
        <translation>estos coeficientes no son posibles juntos: su matriz tiene un autovalor negativo</translation>
    </message>
    <message>
        <source>it is at the place of %1</source>
        <translation>está en el lugar de %1</translation>
    </message>
    <message>
        <source>no sensor of the network sees it</source>
        <translation>ningún sensor de la red lo ve</translation>
    </message>
    <message>
        <source>it cannot be localised from what %1 read: the readings leave a direction undetermined; add a sensor or a reading</source>
        <translation>no se puede localizar con lo que leen %1: las lecturas dejan indeterminada una dirección; añada un sensor o una lectura</translation>
    </message>
    <message>
        <source>the readings do not lead to a position of every target: the estimation does not converge from the nominal coordinates; look for exchanged or mistyped readings</source>
        <translation>las lecturas no llevan a una posición de cada diana: la estimación no converge desde las coordenadas nominales; busque lecturas intercambiadas o mal escritas</translation>
    </message>
    <message>
        <source>%1 looks away from target %2: its angles point to the opposite side</source>
        <translation>%1 mira en sentido opuesto a la diana %2: sus ángulos señalan al lado contrario</translation>
    </message>
    <message>
        <source>there is no target %1</source>
        <translation>no hay ninguna diana %1</translation>
    </message>
    <message>
        <source>%1 does not see target %2: it is out of its range or field of view</source>
        <translation>%1 no ve la diana %2: está fuera de su alcance o campo de visión</translation>
    </message>
    <message>
        <source>%1 does not see %2 of the %3 targets: they are out of its range or field of view</source>
        <translation>%1 no ve %2 de las %3 dianas: están fuera de su alcance o campo de visión</translation>
    </message>
    <message>
        <source>the sensor %1 is not listed in the network</source>
        <translation>el sensor %1 no figura en la red</translation>
    </message>
    <message>
        <source>%1 reads no %2 according to its description</source>
        <translation>%1 no lee %2 según su descripción</translation>
    </message>
    <message>
        <source>more than %1 rows for target %2</source>
        <translation>más de %1 filas para la diana %2</translation>
    </message>
    <message>
        <source>target %1 is at the place of %2</source>
        <translation>la diana %1 está en el lugar de %2</translation>
    </message>
    <message>
        <source>target %1 is behind the camera %2</source>
        <translation>la diana %1 está detrás de la cámara %2</translation>
    </message>
    <message>
        <source>a network has at most %1 sensors; divide it into several analyses</source>
        <translation>una red tiene como máximo %1 sensores; divídala en varios análisis</translation>
    </message>
    <message>
        <source>two targets are called %1</source>
        <translation>dos dianas se llaman %1</translation>
    </message>
    <message>
        <source>a distance needs two targets at different places</source>
        <translation>una distancia necesita dos dianas en lugares distintos</translation>
    </message>
    <message>
        <source>a calibrated length needs two targets at different places</source>
        <translation>una longitud calibrada necesita dos dianas en lugares distintos</translation>
    </message>
    <message>
        <source>the calibrated length is missing</source>
        <translation>falta la longitud calibrada</translation>
    </message>
    <message>
        <source>the nominal targets of the %1 are at another distance than its calibrated length; the design takes their distance</source>
        <translation>las dianas nominales de %1 están a otra distancia que su longitud calibrada; el diseño toma la distancia de ellas</translation>
    </message>
    <message>
        <source>a calibrated length can be a constraint only of the non-linear estimator with weights from readings and stations</source>
        <translation>una longitud calibrada solo puede ser restricción del estimador no lineal con pesos de lecturas y estaciones</translation>
    </message>
    <message>
        <source>the targets of the %1 belong to two set-ups, which are estimated one after the other: it can only be a check</source>
        <translation>las dianas de %1 pertenecen a dos estacionamientos, que se estiman uno tras otro: solo puede ser una comprobación</translation>
    </message>
    <message>
        <source>the targets of an angle must be at three places off one line: at 0° and 180° an angle has no sign and no derivative</source>
        <translation>las dianas de un ángulo deben estar en tres lugares fuera de una recta: a 0° y 180° un ángulo no tiene signo ni derivada</translation>
    </message>
    <message>
        <source>the name %1 is taken by another frame or a target</source>
        <translation>el nombre %1 ya lo tiene otro sistema o una diana</translation>
    </message>
    <message>
        <source>the three targets of frame %1 lie on one line: its axes are undefined</source>
        <translation>las tres dianas del sistema %1 están en una recta: sus ejes no están definidos</translation>
    </message>
    <message>
        <source>the x-axis of frame %1 is vertical: its Z-Y-X angles are undefined (gimbal lock)</source>
        <translation>el eje x del sistema %1 es vertical: sus ángulos Z-Y-X no están definidos (bloqueo de cardán)</translation>
    </message>
    <message>
        <source>scale bar %1 – %2</source>
        <translation>barra de escala %1 – %2</translation>
    </message>
    <message>
        <source>the sensor %1 is listed twice</source>
        <translation>el sensor %1 figura dos veces</translation>
    </message>
    <message>
        <source>%1 The residuals are larger than the uncertainties allow; the largest for its uncertainty is the %2. Look for mistyped or exchanged readings, or figures of the instruments that are too small</source>
        <translation>%1 Los residuos son mayores de lo que permiten las incertidumbres; el mayor para su incertidumbre es %2. Busque lecturas mal escritas o intercambiadas, o cifras de los instrumentos demasiado pequeñas</translation>
    </message>
    <message>
        <source>distance of %1 by %2</source>
        <translation>distancia de %1 por %2</translation>
    </message>
    <message>
        <source>azimuth of %1 by %2</source>
        <translation>azimut de %1 por %2</translation>
    </message>
    <message>
        <source>elevation of %1 by %2</source>
        <translation>elevación de %1 por %2</translation>
    </message>
    <message>
        <source>length of the %1</source>
        <translation>longitud de %1</translation>
    </message>
    <message>
        <source>Chi-square of the residuals: %1 with %2 degrees of freedom, p = %3.</source>
        <translation>Ji cuadrado de los residuos: %1 con %2 grados de libertad, p = %3.</translation>
    </message>
    <message>
        <source>no sensor</source>
        <translation>ningún sensor</translation>
    </message>
    <message>
        <source>target %1 has no linear equations that localise it (a distance without angles has none): use the non-linear estimator</source>
        <translation>la diana %1 no tiene ecuaciones lineales que la localicen (una distancia sin ángulos no las tiene): use el estimador no lineal</translation>
    </message>
    <message>
        <source>target %1 cannot be localised from what %2 read: the readings leave a direction undetermined; add a sensor or a reading</source>
        <translation>la diana %1 no se puede localizar con lo que leen %2: las lecturas dejan indeterminada una dirección; añada un sensor o una lectura</translation>
    </message>
    <message>
        <source>target %1 is hardly localised: in one direction u is %2 m at a distance of %3 m</source>
        <translation>la diana %1 apenas se localiza: en una dirección u es %2 m a una distancia de %3 m</translation>
    </message>
    <message>
        <source>the stations that measure target %1 lie in one plane and read distances only: its mirror image behind that plane fits as well; the one near the nominal coordinates is taken</source>
        <translation>las estaciones que miden la diana %1 están en un plano y solo leen distancias: su imagen especular tras ese plano también se ajusta; se toma la próxima a las coordenadas nominales</translation>
    </message>
    <message>
        <source>a calibrated length cannot be a constraint of a set-up with more than %1 readings (this one has %2): make it a check</source>
        <translation>una longitud calibrada no puede ser restricción de un estacionamiento con más de %1 lecturas (este tiene %2): hágala comprobación</translation>
    </message>
    <message>
        <source>the %1 readings of one set-up are too many to be weighed together: each target is estimated from its own readings, weighted with the stations</source>
        <translation>las %1 lecturas de un estacionamiento son demasiadas para ponderarlas juntas: cada diana se estima con sus propias lecturas, ponderadas con las estaciones</translation>
    </message>
    <message>
        <source>the standard uncertainty of a coordinate, %1 mm, is more than a tenth of the distance of point %2 from the x-axis, %3 mm: the law of propagation is not reliable here, look at Monte Carlo</source>
        <translation>la incertidumbre típica de una coordenada, %1 mm, es más de la décima parte de la distancia del punto %2 al eje x, %3 mm: la ley de propagación no es fiable aquí, mire Monte Carlo</translation>
    </message>
    <message>
        <source>the frame made from these points lies %1 mm and %2° away from the axes in which they are given, so results differ from the table of poses; check the side of point 3 and the shift of the origin</source>
        <translation>el sistema formado por estos puntos está a %1 mm y %2° de los ejes en que se dan, por lo que los resultados difieren de la tabla de poses; compruebe el lado del punto 3 y el desplazamiento del origen</translation>
    </message>
    <message>
        <source>%1: beta is within 2° of ±90°, where Z-Y-X angles are undefined (gimbal lock); state the orientation as a rotation vector</source>
        <translation>%1: beta está a menos de 2° de ±90°, donde los ángulos Z-Y-X no están definidos (bloqueo de cardán); indique la orientación como vector de rotación</translation>
    </message>
    <message>
        <source>%1: beta is within 2° of 0° or 180°, where Z-Y-Z angles are undefined (gimbal lock); state the orientation as Z-Y-X angles or a rotation vector</source>
        <translation>%1: beta está a menos de 2° de 0° o 180°, donde los ángulos Z-Y-Z no están definidos (bloqueo de cardán); indique la orientación como ángulos Z-Y-X o vector de rotación</translation>
    </message>
    <message>
        <source>%1: the rotation is within 4° of half a turn, where the sign of the axis is undefined; state the orientation as angles</source>
        <translation>%1: la rotación está a menos de 4° de media vuelta, donde el signo del eje no está definido; indique la orientación como ángulos</translation>
    </message>
    <message>
        <source>the analysis %1 has no point called &apos;%2&apos;</source>
        <translation>el análisis %1 no tiene ningún punto llamado &apos;%2&apos;</translation>
    </message>
    <message>
        <source>point %1 cannot be measured by %2: %3</source>
        <translation>el punto %1 no puede ser medido por %2: %3</translation>
    </message>
    <message>
        <source>the 3-2-1 method uses the first three points; point %1 and those after it are not used: choose least squares</source>
        <translation>el método 3-2-1 usa los tres primeros puntos; el punto %1 y los siguientes no se usan: elija mínimos cuadrados</translation>
    </message>
    <message>
        <source>the base frame is undefined</source>
        <translation>el sistema base no está definido</translation>
    </message>
    <message>
        <source>the moving frame is undefined</source>
        <translation>el sistema móvil no está definido</translation>
    </message>
    <message>
        <source>points %1 and %2 coincide: %3</source>
        <translation>los puntos %1 y %2 coinciden: %3</translation>
    </message>
    <message>
        <source>point %1 lies on the line through %2 and %3: %4</source>
        <translation>el punto %1 está en la recta por %2 y %3: %4</translation>
    </message>
    <message>
        <source>all points lie on one line or coincide: their frame is undefined</source>
        <translation>todos los puntos están en una recta o coinciden: su sistema no está definido</translation>
    </message>
    <message>
        <source>not used: the uncertainties come from an artefact or instrument</source>
        <translation>no se usa: las incertidumbres proceden de un patrón o instrumento</translation>
    </message>
    <message>
        <source>there are two poses called &apos;%1&apos;; rename one</source>
        <translation>hay dos poses llamadas &apos;%1&apos;; cambie el nombre de una</translation>
    </message>
    <message>
        <source>no pose may be called &apos;base&apos;: that names the base among the measured points</source>
        <translation>ninguna pose puede llamarse &apos;base&apos;: eso nombra la base entre los puntos medidos</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither &apos;base&apos; nor the name of a pose</source>
        <translation>&apos;%1&apos; no es ni &apos;base&apos; ni el nombre de una pose</translation>
    </message>
    <message>
        <source>there is no point called &apos;%1&apos; in that frame</source>
        <translation>no hay ningún punto llamado &apos;%1&apos; en ese sistema</translation>
    </message>
    <message>
        <source>point %1 of &apos;%2&apos; was not measured</source>
        <translation>el punto %1 de &apos;%2&apos; no se midió</translation>
    </message>
    <message>
        <source>the mirrored coordinates leave %1 instead of %2: frame 0 is left-handed, check the signs and the order of its axes</source>
        <translation>las coordenadas reflejadas dejan %1 en vez de %2: el sistema 0 es levógiro, compruebe los signos y el orden de sus ejes</translation>
    </message>
    <message>
        <source>with %1 and %2 exchanged the residuals are %3 instead of %4: check the names</source>
        <translation>con %1 y %2 intercambiados los residuos son %3 en vez de %4: compruebe los nombres</translation>
    </message>
    <message>
        <source>the points of &apos;%1&apos; do not fit their nominal coordinates</source>
        <translation>los puntos de &apos;%1&apos; no se ajustan a sus coordenadas nominales</translation>
    </message>
    <message>
        <source>the points of &apos;%1&apos; do not fit their nominal coordinates within the stated uncertainties: chi-square %2 with %3 degrees of freedom; the largest normalised residual is %4 (%5)</source>
        <translation>los puntos de &apos;%1&apos; no se ajustan a sus coordenadas nominales dentro de las incertidumbres indicadas: ji cuadrado %2 con %3 grados de libertad; el mayor residuo normalizado es %4 (%5)</translation>
    </message>
    <message>
        <source>the lengths between the supports make no triangle: the longest of %1, %2 and %3 exceeds the sum of the others</source>
        <translation>las longitudes entre los apoyos no forman un triángulo: la mayor de %1, %2 y %3 supera la suma de las otras</translation>
    </message>
    <message>
        <source>the three supports lie on a line (%1, %2 and %3): they leave the place of the ball undetermined; move one of them aside</source>
        <translation>los tres apoyos están en una recta (%1, %2 y %3): dejan indeterminado el lugar de la bola; aparte uno de ellos</translation>
    </message>
    <message>
        <source>the lengths of support %1 do not meet at its height: they miss by %2</source>
        <translation>las longitudes del apoyo %1 no se encuentran a su altura: fallan en %2</translation>
    </message>
    <message>
        <source>a set has at most %1 supports</source>
        <translation>un conjunto tiene como máximo %1 apoyos</translation>
    </message>
    <message>
        <source>the rotation about %1</source>
        <translation>la rotación alrededor de %1</translation>
    </message>
    <message>
        <source>%1 has %2 points; a plane needs three, and some more to be checked</source>
        <translation>%1 tiene %2 puntos; un plano necesita tres, y alguno más para comprobarlo</translation>
    </message>
    <message>
        <source>%1 has a span of zero: all its points coincide</source>
        <translation>%1 tiene recorrido cero: todos sus puntos coinciden</translation>
    </message>
    <message>
        <source>the tool centre point lies on the axis of %1 (or the tool has no length): it traces no circle; turn about another axis</source>
        <translation>el centro de la herramienta está en el eje de %1 (o la herramienta no tiene longitud): no traza círculo; gire alrededor de otro eje</translation>
    </message>
    <message>
        <source>the arc of %1 spans only %2°: uncertainties grow as the inverse square of the span and may be %3 times those of half a turn</source>
        <translation>el arco de %1 abarca solo %2°: las incertidumbres crecen con el inverso del cuadrado del recorrido y pueden ser %3 veces las de media vuelta</translation>
    </message>
    <message>
        <source>point %1 is %2 mm on the other side of the supports&apos; plane, where the ballbars look for no solution; change their placement or their side</source>
        <translation>el punto %1 está %2 mm al otro lado del plano de los apoyos, donde las ballbars no buscan solución; cambie su colocación o su lado</translation>
    </message>
    <message>
        <source>point %1 is only %2 mm from the supports&apos; plane, with a standard uncertainty of %3 mm in that direction: in some trials the lengths will not meet (negative root), and u is not to be trusted</source>
        <translation>el punto %1 está a solo %2 mm del plano de los apoyos, con una incertidumbre típica de %3 mm en esa dirección: en algunas pruebas las longitudes no se encontrarán (raíz negativa), y u no es de fiar</translation>
    </message>
    <message>
        <source>the measured points determine no sphere and no axes: they lie on one circle, or coincide; check their axes and angles</source>
        <translation>los puntos medidos no determinan esfera ni ejes: están en un círculo, o coinciden; compruebe sus ejes y ángulos</translation>
    </message>
    <message>
        <source>a procedure has at most %1 points</source>
        <translation>un procedimiento tiene como máximo %1 puntos</translation>
    </message>
    <message>
        <source>two points are called %1</source>
        <translation>dos puntos se llaman %1</translation>
    </message>
    <message>
        <source>the flange turns about %1 in two rotations; put their points into one</source>
        <translation>la brida gira alrededor de %1 en dos rotaciones; ponga sus puntos en una</translation>
    </message>
    <message>
        <source>one rotation traces one circle, which leaves the centre of the flange and its axes undetermined: add a rotation about another axis</source>
        <translation>una rotación traza un círculo, que deja indeterminados el centro de la brida y sus ejes: añada una rotación alrededor de otro eje</translation>
    </message>
    <message>
        <source>no rotation measures axis %1: choose another way to make the axes, or add the rotation</source>
        <translation>ninguna rotación mide el eje %1: elija otra forma de construir los ejes, o añada la rotación</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not offer &apos;%2&apos;</source>
        <translation>&apos;%1&apos; no ofrece &apos;%2&apos;</translation>
    </message>
    <message>
        <source>column %1: %2</source>
        <translation>columna %1: %2</translation>
    </message>
    <message>
        <source>it is called like a joint of a gripper</source>
        <translation>se llama como una articulación de una pinza</translation>
    </message>
    <message>
        <source>others follow it at the end of the arm, as in a gripper</source>
        <translation>otras la siguen al final del brazo, como en una pinza</translation>
    </message>
    <message>
        <source>it slides by less than 100 mm at the end of the arm, as in a gripper</source>
        <translation>se desliza menos de 100 mm al final del brazo, como en una pinza</translation>
    </message>
    <message>
        <source>it is one of several at the end of the arm, as in a hand</source>
        <translation>es una de varias al final del brazo, como en una mano</translation>
    </message>
    <message>
        <source>no joint leads to a link called %1</source>
        <translation>ninguna articulación lleva a un eslabón llamado %1</translation>
    </message>
    <message>
        <source>no moving joint leads to %1</source>
        <translation>ninguna articulación móvil lleva a %1</translation>
    </message>
    <message>
        <source>the links form a ring; URDF describes trees</source>
        <translation>los eslabones forman un anillo; URDF describe árboles</translation>
    </message>
    <message>
        <source>joint %1 on the way to %2 is of the type %3: freeze it, --freeze %1=0</source>
        <translation>la articulación %1 en el camino a %2 es del tipo %3: congélela, --freeze %1=0</translation>
    </message>
    <message>
        <source>joint %1 on the way to %2 follows joint %3: freeze it, --freeze %1=0</source>
        <translation>la articulación %1 en el camino a %2 sigue a la articulación %3: congélela, --freeze %1=0</translation>
    </message>
    <message>
        <source>no arm: joint %1 was left out because %2</source>
        <translation>no es un brazo: la articulación %1 se omitió porque %2</translation>
    </message>
    <message>
        <source>no arm: joint %1 is of the type %2</source>
        <translation>no es un brazo: la articulación %1 es del tipo %2</translation>
    </message>
    <message>
        <source>no arm: joint %1 follows joint %2</source>
        <translation>no es un brazo: la articulación %1 sigue a la articulación %2</translation>
    </message>
    <message>
        <source>left out: it is of the type %1</source>
        <translation>omitida: es del tipo %1</translation>
    </message>
    <message>
        <source>left out: it follows joint %1</source>
        <translation>omitida: sigue a la articulación %1</translation>
    </message>
    <message>
        <source>left out: %1</source>
        <translation>omitida: %1</translation>
    </message>
    <message>
        <source>left out: it is not on the way to %1</source>
        <translation>omitida: no está en el camino a %1</translation>
    </message>
    <message>
        <source>the file has no moving joint</source>
        <translation>el archivo no tiene ninguna articulación móvil</translation>
    </message>
    <message>
        <source>the file has several arms of equal length, ending at %1 and %2: name the tip link of the one to import</source>
        <translation>el archivo tiene varios brazos de igual longitud, que terminan en %1 y %2: nombre el eslabón final del que se importa</translation>
    </message>
    <message>
        <source>frozen: %1</source>
        <translation>congelada: %1</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not three numbers</source>
        <translation>&apos;%1&apos; no son tres números</translation>
    </message>
    <message>
        <source>joint %1 does not say which links it joins</source>
        <translation>la articulación %1 no dice qué eslabones une</translation>
    </message>
    <message>
        <source>joint %1: %2</source>
        <translation>articulación %1: %2</translation>
    </message>
    <message>
        <source>joint %1: its axis has no direction</source>
        <translation>articulación %1: su eje no tiene dirección</translation>
    </message>
    <message>
        <source>not readable as XML: %1</source>
        <translation>no se puede leer como XML: %1</translation>
    </message>
    <message>
        <source>no URDF: its root element &lt;robot&gt; is missing</source>
        <translation>no es URDF: falta su elemento raíz &lt;robot&gt;</translation>
    </message>
    <message>
        <source>the file has xacro macros: expand them first (xacro FILE &gt; arm.urdf)</source>
        <translation>el archivo tiene macros xacro: expándalas antes (xacro FILE &gt; arm.urdf)</translation>
    </message>
    <message>
        <source>link %1 hangs on two joints; URDF describes trees</source>
        <translation>el eslabón %1 cuelga de dos articulaciones; URDF describe árboles</translation>
    </message>
    <message>
        <source>there is no joint %1 to freeze%2</source>
        <translation>no hay ninguna articulación %1 que congelar%2</translation>
    </message>
    <message>
        <source>joint %1 does not move, or is frozen twice</source>
        <translation>la articulación %1 no se mueve, o se congela dos veces</translation>
    </message>
    <message>
        <source>joint %1 is of the type %2: it can be frozen at 0 only</source>
        <translation>la articulación %1 es del tipo %2: solo puede congelarse en 0</translation>
    </message>
    <message>
        <source>frozen at %1, beyond its limits</source>
        <translation>congelada en %1, más allá de sus límites</translation>
    </message>
    <message>
        <source>frozen at %1</source>
        <translation>congelada en %1</translation>
    </message>
    <message>
        <source>an arm has at most %1 joints here</source>
        <translation>un brazo tiene aquí como máximo %1 articulaciones</translation>
    </message>
    <message>
        <source>joint %1 slides: state its readings as lengths, in the columns of s</source>
        <translation>la articulación %1 se desliza: indique sus lecturas como longitudes, en las columnas de s</translation>
    </message>
    <message>
        <source>joint %1 turns: state its readings as angles, or give it the type sliding</source>
        <translation>la articulación %1 gira: indique sus lecturas como ángulos, o dele el tipo deslizante</translation>
    </message>
    <message>
        <source>joint %1</source>
        <translation>articulación %1</translation>
    </message>
    <message>
        <source>only the convention with Ry(beta) has a beta; leave it empty for %1, or choose that convention</source>
        <translation>solo la convención con Ry(beta) tiene beta; déjelo vacío para %1, o elija esa convención</translation>
    </message>
    <message>
        <source>d and beta of %1 describe the same place of a parallel axis: where beta is given, d is 0 by definition</source>
        <translation>d y beta de %1 describen el mismo lugar de un eje paralelo: donde se da beta, d es 0 por definición</translation>
    </message>
    <message>
        <source>the lowest reading of %1 is not below its highest</source>
        <translation>la lectura mínima de %1 no es menor que la máxima</translation>
    </message>
    <message>
        <source>the robot has no joint %1</source>
        <translation>el robot no tiene la articulación %1</translation>
    </message>
    <message>
        <source>%1 is 0 by definition, because the axis is parallel to the next</source>
        <translation>%1 es 0 por definición, porque el eje es paralelo al siguiente</translation>
    </message>
    <message>
        <source>%1 is no parameter of this robot: give beta in the table of joints where axes are parallel</source>
        <translation>%1 no es un parámetro de este robot: dé beta en la tabla de articulaciones donde los ejes son paralelos</translation>
    </message>
    <message>
        <source>a parameter is correlated with itself; name two different ones</source>
        <translation>un parámetro está correlacionado consigo mismo; nombre dos distintos</translation>
    </message>
    <message>
        <source>there is no parameter &apos;%1&apos; with an uncertainty; write its symbol, such as d_3</source>
        <translation>no hay ningún parámetro &apos;%1&apos; con incertidumbre; escriba su símbolo, como d_3</translation>
    </message>
    <message>
        <source>%1 has several components of uncertainty: give it one, the combined, so that it can be correlated</source>
        <translation>%1 tiene varias componentes de incertidumbre: dele una, la combinada, para que pueda correlacionarse</translation>
    </message>
    <message>
        <source>there is no pose: give joint readings or a place of the tool</source>
        <translation>no hay ninguna pose: dé lecturas de articulaciones o un lugar de la herramienta</translation>
    </message>
    <message>
        <source>two poses are called %1</source>
        <translation>dos poses se llaman %1</translation>
    </message>
    <message>
        <source>pose %1: reading %2 of joint %3 is beyond its limits, %4 to %5</source>
        <translation>pose %1: la lectura %2 de la articulación %3 está más allá de sus límites, %4 a %5</translation>
    </message>
    <message>
        <source>pose %1: the orientation is within 2° of one that %2 cannot state (gimbal lock, half turn); state it otherwise</source>
        <translation>pose %1: la orientación está a menos de 2° de una que %2 no puede indicar (bloqueo de cardán, media vuelta); indíquela de otro modo</translation>
    </message>
    <message>
        <source>%1 has only %2 joints; leave %3 empty</source>
        <translation>%1 solo tiene %2 articulaciones; deje %3 vacío</translation>
    </message>
    <message>
        <source>joint %1 of %2 slides: its reading is %3</source>
        <translation>la articulación %1 de %2 se desliza: su lectura es %3</translation>
    </message>
    <message>
        <source>joint %1 of %2 turns: its reading is %3</source>
        <translation>la articulación %1 de %2 gira: su lectura es %3</translation>
    </message>
    <message>
        <source>pose %1: give all three angles or none</source>
        <translation>pose %1: dé los tres ángulos o ninguno</translation>
    </message>
    <message>
        <source>pose %1: no readings within the limits of the joints bring the tool there; the nearest attempt misses the place by %2 but not the orientation</source>
        <translation>pose %1: ninguna lectura dentro de los límites de las articulaciones lleva allí la herramienta; el intento más próximo falla el lugar en %2 pero no la orientación</translation>
    </message>
    <message>
        <source>pose %1: no readings within the limits of the joints bring the tool there; the nearest attempt misses the place by %2</source>
        <translation>pose %1: ninguna lectura dentro de los límites de las articulaciones lleva allí la herramienta; el intento más próximo falla el lugar en %2</translation>
    </message>
    <message>
        <source>without limits</source>
        <translation>sin límites</translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <translation>%1 a %2 %3</translation>
    </message>
    <message>
        <source>%1 mm, turned by %2 deg</source>
        <translation>%1 mm, girado %2 deg</translation>
    </message>
    <message>
        <source>joint %1: %2, slides, %3</source>
        <translation>articulación %1: %2, se desliza, %3</translation>
    </message>
    <message>
        <source>joint %1: %2, turns, %3</source>
        <translation>articulación %1: %2, gira, %3</translation>
    </message>
    <message>
        <source>%1 joint from link %2 to link %3</source>
        <translation>%1 articulación del eslabón %2 al eslabón %3</translation>
    </message>
    <message>
        <source>%1 joints from link %2 to link %3</source>
        <translation>%1 articulaciones del eslabón %2 al eslabón %3</translation>
    </message>
    <message>
        <source>tool: link %1 at %2 from the frame of the last joint</source>
        <translation>herramienta: eslabón %1 a %2 del sistema de la última articulación</translation>
    </message>
    <message>
        <source>with all readings at 0 the tool stands at %1 in link %2</source>
        <translation>con todas las lecturas a 0 la herramienta está en %1 en el eslabón %2</translation>
    </message>
    <message>
        <source>the chain to %1 has %2 moving joints; an arm has at most %3 here: freeze those before the arm, --freeze %4=0</source>
        <translation>la cadena hasta %1 tiene %2 articulaciones móviles; un brazo tiene aquí como máximo %3: congele las anteriores al brazo, --freeze %4=0</translation>
    </message>
    <message>
        <source>pose %1: the residual of its %2 is %3 times its standard uncertainty (limit %4). Look at this pose first; hold it back by use = check</source>
        <translation>pose %1: el residuo de su %2 es %3 veces su incertidumbre típica (límite %4). Mire primero esta pose; resérvela con use = check</translation>
    </message>
    <message>
        <source>the residuals are %1 times as large as the uncertainties of points and readings explain: there is more than these (a joint&apos;s elasticity, temperature, an outlier), and the uncertainty of the parameters is stated too small</source>
        <translation>los residuos son %1 veces mayores de lo que explican las incertidumbres de puntos y lecturas: hay algo más (elasticidad de una articulación, temperatura, un valor atípico), y la incertidumbre de los parámetros se indica demasiado pequeña</translation>
    </message>
    <message>
        <source>these poses hardly tell %1 apart (condition %2): turn more joints further, or hold one of them</source>
        <translation>estas poses apenas distinguen %1 (condición %2): gire más articulaciones más lejos, o fije uno de ellos</translation>
    </message>
    <message>
        <source>no parameter of the arm can be told from these poses: every one of them is coupled with others or held</source>
        <translation>con estas poses no se puede hallar ningún parámetro del brazo: cada uno está acoplado con otros o fijado</translation>
    </message>
    <message>
        <source>the poses of the fit give %1 coordinates, no more than there are unknowns to find: measure more poses, or hold parameters</source>
        <translation>las poses del ajuste dan %1 coordenadas, no más que incógnitas por hallar: mida más poses, o fije parámetros</translation>
    </message>
    <message>
        <source>the fit does not converge: look for exchanged poses, readings of the wrong sign or in another unit, and for a nominal robot that is another arm</source>
        <translation>el ajuste no converge: busque poses intercambiadas, lecturas de signo contrario o en otra unidad, y un robot nominal que sea otro brazo</translation>
    </message>
    <message>
        <source>at the solution the unknowns cannot be told apart; hold one of those that the table of observability names</source>
        <translation>en la solución las incógnitas no se pueden distinguir; fije una de las que nombra la tabla de observabilidad</translation>
    </message>
    <message>
        <source>joint %1 slides: only arms whose joints turn are identified; take an arm without it, as it stands during the measurement</source>
        <translation>la articulación %1 se desliza: solo se identifican brazos cuyas articulaciones giran; tome un brazo sin ella, tal como está durante la medición</translation>
    </message>
    <message>
        <source>the fit has %1 poses; it needs three or more, and about twenty to tell all parameters</source>
        <translation>el ajuste tiene %1 poses; necesita tres o más, y unas veinte para hallar todos los parámetros</translation>
    </message>
    <message>
        <source>the robot has only %1 joints; leave %2 empty</source>
        <translation>el robot solo tiene %1 articulaciones; deje %2 vacío</translation>
    </message>
    <message>
        <source>pose %1: its orientation is missing; give alpha, beta and gamma of every pose, or fit positions alone</source>
        <translation>pose %1: falta su orientación; dé alpha, beta y gamma de cada pose, o ajuste solo posiciones</translation>
    </message>
    <message>
        <source>the robot has no parameter &apos;%1&apos; to hold; write its symbol, such as d_3</source>
        <translation>el robot no tiene ningún parámetro &apos;%1&apos; que fijar; escriba su símbolo, como d_3</translation>
    </message>
    <message>
        <source>rotation about %1</source>
        <translation>rotación alrededor de %1</translation>
    </message>
    <message>
        <source>base %1</source>
        <translation>base %1</translation>
    </message>
    <message>
        <source>tool %1</source>
        <translation>herramienta %1</translation>
    </message>
    <message>
        <source>the points do not lead to parameters of the arm</source>
        <translation>los puntos no llevan a parámetros del brazo</translation>
    </message>
    <message>
        <source>the points of %1 run against the positive direction of the joint: reverse their order, or give its readings</source>
        <translation>los puntos de %1 van contra el sentido positivo de la articulación: invierta su orden, o dé sus lecturas</translation>
    </message>
    <message>
        <source>the axes of joints %1 and %2</source>
        <translation>los ejes de las articulaciones %1 y %2</translation>
    </message>
    <message>
        <source>%1 are nearly parallel (%2): they are described by beta with d = 0, because the place of their common perpendicular is hardly determined</source>
        <translation>%1 son casi paralelos (%2): se describen con beta y d = 0, porque el lugar de su perpendicular común apenas está determinado</translation>
    </message>
    <message>
        <source>%1 are %2 apart: they are described by d without beta, although the nominal robot has beta</source>
        <translation>%1 están a %2: se describen con d y sin beta, aunque el robot nominal tiene beta</translation>
    </message>
    <message>
        <source>the axes of joints %1 and %2 are the same line: nothing tells their frames apart</source>
        <translation>los ejes de las articulaciones %1 y %2 son la misma recta: nada distingue sus sistemas</translation>
    </message>
    <message>
        <source>parameters are identified by Eq 5: describe the nominal robot in that convention, not in Craig&apos;s</source>
        <translation>los parámetros se identifican por la ec. 5: describa el robot nominal en esa convención, no en la de Craig</translation>
    </message>
    <message>
        <source>joint %1 slides and draws no circle: take an arm without it, as it stands during the measurement</source>
        <translation>la articulación %1 se desliza y no traza círculo: tome un brazo sin ella, tal como está durante la medición</translation>
    </message>
    <message>
        <source>an arm of one joint has no parameters between two axes</source>
        <translation>un brazo de una articulación no tiene parámetros entre dos ejes</translation>
    </message>
    <message>
        <source>the robot has no %1</source>
        <translation>el robot no tiene %1</translation>
    </message>
    <message>
        <source>%1 has %2 points; a circle needs three or more</source>
        <translation>%1 tiene %2 puntos; un círculo necesita tres o más</translation>
    </message>
    <message>
        <source>the ball hardly moves while %1 turns: it lies on the axis of that joint and draws no circle. Fix the ball off the axis</source>
        <translation>la bola apenas se mueve mientras gira %1: está en el eje de esa articulación y no traza círculo. Fije la bola fuera del eje</translation>
    </message>
    <message>
        <source>the points of %1 lie on a straight line, as far as their uncertainty lets it be seen: no circle goes through them. Turn the joint further</source>
        <translation>los puntos de %1 están en una recta, hasta donde su incertidumbre deja ver: ningún círculo pasa por ellos. Gire más la articulación</translation>
    </message>
    <message>
        <source>the arc of %1 over %2 is short for the uncertainty of its points: its axis will be known poorly</source>
        <translation>el arco de %1 sobre %2 es corto para la incertidumbre de sus puntos: su eje se conocerá mal</translation>
    </message>
    <message>
        <source>the plane of %1 passes the origin at %2: Eq 1 excludes planes through the origin and fails near it. Use total least squares</source>
        <translation>el plano de %1 pasa por el origen a %2: la ec. 1 excluye planos por el origen y falla cerca de él. Use mínimos cuadrados totales</translation>
    </message>
    <message>
        <source>no circle fits the points of %1; look for exchanged points</source>
        <translation>ningún círculo se ajusta a los puntos de %1; busque puntos intercambiados</translation>
    </message>
    <message>
        <source>the calibration matrix is singular: the channels answer to loads on %1 alike, so these cannot be told apart</source>
        <translation>la matriz de calibración es singular: los canales responden igual a cargas en %1, por lo que no se pueden distinguir</translation>
    </message>
    <message>
        <source>the calibration matrix has the condition number %1: loads on %2 are hardly told apart</source>
        <translation>la matriz de calibración tiene el número de condición %1: las cargas en %2 apenas se distinguen</translation>
    </message>
    <message>
        <source>add a row of loads to be evaluated</source>
        <translation>añada una fila de cargas que evaluar</translation>
    </message>
    <message>
        <source>add a row of readings to be decoupled</source>
        <translation>añada una fila de lecturas que desacoplar</translation>
    </message>
    <message>
        <source>two cases are called &apos;%1&apos;</source>
        <translation>dos casos se llaman &apos;%1&apos;</translation>
    </message>
    <message>
        <source>channel %1 has no reading: all channels are needed</source>
        <translation>el canal %1 no tiene lectura: hacen falta todos los canales</translation>
    </message>
    <message>
        <source>the sensor has no channel %1</source>
        <translation>el sensor no tiene el canal %1</translation>
    </message>
    <message>
        <source>no load gives these readings by the calibration matrix</source>
        <translation>ninguna carga da estas lecturas con la matriz de calibración</translation>
    </message>
    <message>
        <source>the load on %1 is %2 % of its rated load: the calibration says nothing about it</source>
        <translation>la carga en %1 es el %2 % de su carga nominal: la calibración no dice nada de ella</translation>
    </message>
    <message>
        <source>loads on %1 are too few for this calibration matrix</source>
        <translation>las cargas en %1 son demasiado pocas para esta matriz de calibración</translation>
    </message>
    <message>
        <source>the interference of %1 is known without signs: it cannot be compensated. Give raw readings, or a table with signs</source>
        <translation>la interferencia de %1 se conoce sin signos: no se puede compensar. Dé lecturas brutas, o una tabla con signos</translation>
    </message>
    <message>
        <source>quadratic terms need raw readings; %1 has a summary only</source>
        <translation>los términos cuadráticos necesitan lecturas brutas; %1 solo tiene un resumen</translation>
    </message>
    <message>
        <source>channel %1 is listed twice</source>
        <translation>el canal %1 figura dos veces</translation>
    </message>
    <message>
        <source>moment</source>
        <translation>momento</translation>
    </message>
    <message>
        <source>force</source>
        <translation>fuerza</translation>
    </message>
    <message>
        <source>channel %1 needs its rated load, a %2</source>
        <translation>el canal %1 necesita su carga nominal, de %2</translation>
    </message>
    <message>
        <source>%1 states no uncertainty of its load on %2: add it to its certificate</source>
        <translation>%1 no indica la incertidumbre de su carga en %2: añádala a su certificado</translation>
    </message>
    <message>
        <source>increasing loads</source>
        <translation>cargas crecientes</translation>
    </message>
    <message>
        <source>unloaded reading before</source>
        <translation>lectura sin carga antes</translation>
    </message>
    <message>
        <source>run %1 of %2 has no %3: it is left out</source>
        <translation>la serie %1 de %2 no tiene %3: se omite</translation>
    </message>
    <message>
        <source>%1 was not calibrated: there are no runs with its axis loaded</source>
        <translation>%1 no se calibró: no hay series con su eje cargado</translation>
    </message>
    <message>
        <source>%1 has one run only: its repeatability needs two or more</source>
        <translation>%1 tiene una sola serie: su repetibilidad necesita dos o más</translation>
    </message>
    <message>
        <source>%1 has %2 runs, %3 are planned: its means have %4 degrees of freedom</source>
        <translation>%1 tiene %2 series, están previstas %3: sus medias tienen %4 grados de libertad</translation>
    </message>
    <message>
        <source>%1 has %2 preloads, %3 are planned</source>
        <translation>%1 tiene %2 precargas, están previstas %3</translation>
    </message>
    <message>
        <source>, and it says nothing about repeatability</source>
        <translation>, y no dice nada de la repetibilidad</translation>
    </message>
    <message>
        <source>step %1 of %2 is missing in %3 of %4 runs: its mean is that of %5%6</source>
        <translation>el escalón %1 de %2 falta en %3 de %4 series: su media es la de %5%6</translation>
    </message>
    <message>
        <source>%1 was loaded in %2 steps, %3 are planned</source>
        <translation>%1 se cargó en %2 escalones, están previstos %3</translation>
    </message>
    <message>
        <source>the largest load on %1 is %2; the rated output needs the rated load, %3</source>
        <translation>la mayor carga en %1 es %2; la salida nominal necesita la carga nominal, %3</translation>
    </message>
    <message>
        <source>%1 has the same reading in all runs: its repeatability is evaluated as zero</source>
        <translation>%1 tiene la misma lectura en todas las series: su repetibilidad se evalúa como cero</translation>
    </message>
    <message>
        <source>%1 has no unloaded readings after a run: its non-zero error is taken as zero</source>
        <translation>%1 no tiene lecturas sin carga después de una serie: su error de cero se toma como cero</translation>
    </message>
    <message>
        <source>%1 has no decreasing loads: its hysteresis is not known and is taken as zero</source>
        <translation>%1 no tiene cargas decrecientes: su histéresis no se conoce y se toma como cero</translation>
    </message>
    <message>
        <source>run %1 of %2 reads the same at steps %3 and %4 although the load rises: the indicator is saturated or the channel is stuck</source>
        <translation>la serie %1 de %2 lee lo mismo en los escalones %3 y %4 aunque la carga sube: el indicador está saturado o el canal bloqueado</translation>
    </message>
    <message>
        <source>run %1 of %2: only %3 s between steps %4 and %5, %6 s are planned</source>
        <translation>serie %1 de %2: solo %3 s entre los escalones %4 y %5, están previstos %6 s</translation>
    </message>
    <message>
        <source>run %1 of %2 begins %3 s after the one before was unloaded, %4 s are planned</source>
        <translation>la serie %1 de %2 empieza %3 s después de descargar la anterior, están previstos %4 s</translation>
    </message>
    <message>
        <source>channel %1 does not respond to its load: %2 at the rated load; look at its cable and its column</source>
        <translation>el canal %1 no responde a su carga: %2 a la carga nominal; mire su cable y su columna</translation>
    </message>
    <message>
        <source>channel %1 responds to %2 more than to its own load: are columns exchanged?</source>
        <translation>el canal %1 responde a %2 más que a su propia carga: ¿están intercambiadas las columnas?</translation>
    </message>
    <message>
        <source>there are no readings: import them from a CSV file, or choose summary tables</source>
        <translation>no hay lecturas: impórtelas de un archivo CSV, o elija tablas de resumen</translation>
    </message>
    <message>
        <source>the sensor has no channel %1: list it among its channels</source>
        <translation>el sensor no tiene el canal %1: inclúyalo entre sus canales</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no unit of a load: %2</source>
        <translation>&apos;%1&apos; no es unidad de una carga: %2</translation>
    </message>
    <message>
        <source>%1 is a moment, but its load is in %2: are forces and moments, or their units, exchanged?</source>
        <translation>%1 es un momento, pero su carga está en %2: ¿están intercambiados fuerzas y momentos, o sus unidades?</translation>
    </message>
    <message>
        <source>%1 is a force, but its load is in %2: are forces and moments, or their units, exchanged?</source>
        <translation>%1 es una fuerza, pero su carga está en %2: ¿están intercambiados fuerzas y momentos, o sus unidades?</translation>
    </message>
    <message>
        <source>a load of %1 is more than 1.2 times the rated load of %2, %3: is its unit right?</source>
        <translation>una carga de %1 es más de 1,2 veces la carga nominal de %2, %3: ¿es correcta su unidad?</translation>
    </message>
    <message>
        <source>channel %1 has no reading in this row</source>
        <translation>el canal %1 no tiene lectura en esta fila</translation>
    </message>
    <message>
        <source>channel %1 indicates %2 mV/V, which is the end of the indicator&apos;s range: the reading is saturated</source>
        <translation>el canal %1 indica %2 mV/V, que es el final del rango del indicador: la lectura está saturada</translation>
    </message>
    <message>
        <source>this run has its unloaded reading already</source>
        <translation>esta serie ya tiene su lectura sin carga</translation>
    </message>
    <message>
        <source>step %1 of this run is given twice</source>
        <translation>el escalón %1 de esta serie se da dos veces</translation>
    </message>
    <message>
        <source>channel %1 has no row in the summary</source>
        <translation>el canal %1 no tiene fila en el resumen</translation>
    </message>
    <message>
        <source>%1 has no row in the table of interference: taken as zero</source>
        <translation>%1 no tiene fila en la tabla de interferencias: se toma como cero</translation>
    </message>
    <message>
        <source>axis %1 is listed twice</source>
        <translation>el eje %1 figura dos veces</translation>
    </message>
    <message>
        <source>the sensor&apos;s calibration is a summary: there are no steps to pool over, so the largest standard deviation is taken</source>
        <translation>la calibración del sensor es un resumen: no hay escalones que agrupar, así que se toma la mayor desviación típica</translation>
    </message>
    <message>
        <source>the name is one of a function or a word of the equations; choose another</source>
        <translation>el nombre es el de una función o una palabra de las ecuaciones; elija otro</translation>
    </message>
    <message>
        <source>a symbol is made of letters, Greek ones too, digits and &apos;_&apos;, a letter first</source>
        <translation>un símbolo se forma con letras, también griegas, cifras y &apos;_&apos;, con una letra al principio</translation>
    </message>
    <message>
        <source>only the first row of a symbol has a value; further rows add components</source>
        <translation>solo la primera fila de un símbolo tiene valor; las demás filas añaden componentes</translation>
    </message>
    <message>
        <source>the component is in %1, the quantity in %2</source>
        <translation>la componente está en %1, la magnitud en %2</translation>
    </message>
    <message>
        <source>a further row states a component of uncertainty</source>
        <translation>una fila adicional indica una componente de incertidumbre</translation>
    </message>
    <message>
        <source>the instrument of the project is missing</source>
        <translation>falta el instrumento del proyecto</translation>
    </message>
    <message>
        <source>the reading of an instrument needs a value</source>
        <translation>la lectura de un instrumento necesita un valor</translation>
    </message>
    <message>
        <source>an instrument reads distances here; the unit must be one of length</source>
        <translation>un instrumento lee aquí distancias; la unidad debe ser de longitud</translation>
    </message>
    <message>
        <source>%1 reads no distances</source>
        <translation>%1 no lee distancias</translation>
    </message>
    <message>
        <source>the value is missing, and no statement gives it</source>
        <translation>falta el valor, y ninguna indicación lo da</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has observations and no row in the table of quantities</source>
        <translation>&apos;%1&apos; tiene observaciones y ninguna fila en la tabla de magnitudes</translation>
    </message>
    <message>
        <source>Newton&apos;s method finds no solution of this equation from the starting value, at the estimates of the quantities</source>
        <translation>el método de Newton no halla solución de esta ecuación desde el valor inicial, en las estimaciones de las magnitudes</translation>
    </message>
    <message>
        <source>this operation has no value at the estimates of the quantities (division by zero, root or logarithm of a negative number, or a number too large)</source>
        <translation>esta operación no tiene valor en las estimaciones de las magnitudes (división por cero, raíz o logaritmo de un número negativo, o un número demasiado grande)</translation>
    </message>
    <message>
        <source>it has several series: leave out the name of the one that is measured now</source>
        <translation>tiene varias series: omita el nombre de la que se mide ahora</translation>
    </message>
    <message>
        <source>the table of observations has no rows for it</source>
        <translation>la tabla de observaciones no tiene filas para ella</translation>
    </message>
    <message>
        <source>&apos;a&apos; is missing: number of observations of which the value is the mean</source>
        <translation>falta &apos;a&apos;: número de observaciones de las que el valor es la media</translation>
    </message>
    <message>
        <source>there is no equation: write one, y = x_1 + x_2</source>
        <translation>no hay ecuación: escriba una, y = x_1 + x_2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is defined by an equation: it cannot be a quantity too</source>
        <translation>&apos;%1&apos; se define por una ecuación: no puede ser además una magnitud</translation>
    </message>
    <message>
        <source>no equation uses &apos;%1&apos;</source>
        <translation>ninguna ecuación usa &apos;%1&apos;</translation>
    </message>
    <message>
        <source>no equation defines &apos;%1&apos;%2</source>
        <translation>ninguna ecuación define &apos;%1&apos;%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is listed twice</source>
        <translation>&apos;%1&apos; figura dos veces</translation>
    </message>
    <message>
        <source>group &apos;%1&apos;: %2</source>
        <translation>grupo &apos;%1&apos;: %2</translation>
    </message>
    <message>
        <source>an analysis of variance needs at least two groups</source>
        <translation>un análisis de varianza necesita al menos dos grupos</translation>
    </message>
    <message>
        <source>no group has more than one observation: nothing tells the scatter within the groups from that between them</source>
        <translation>ningún grupo tiene más de una observación: nada distingue la dispersión dentro de los grupos de la que hay entre ellos</translation>
    </message>
    <message>
        <source>the curve does not reach %1</source>
        <translation>la curva no alcanza %1</translation>
    </message>
    <message>
        <source>, outside of its points</source>
        <translation>, fuera de sus puntos</translation>
    </message>
    <message>
        <source>the curve reaches %1 at x = %2%3: say in &apos;near&apos; which of them is meant</source>
        <translation>la curva alcanza %1 en x = %2%3: diga en &apos;near&apos; cuál de ellos se quiere</translation>
    </message>
    <message>
        <source>no curve of this degree was found: the iteration for the uncertainties of x does not settle on these points</source>
        <translation>no se halló ninguna curva de este grado: la iteración para las incertidumbres de x no se estabiliza con estos puntos</translation>
    </message>
    <message>
        <source>the points do not determine a curve of this degree</source>
        <translation>los puntos no determinan una curva de este grado</translation>
    </message>
    <message>
        <source>the x of y = %1 lies outside of the points of the calibration</source>
        <translation>la x de y = %1 está fuera de los puntos de la calibración</translation>
    </message>
    <message>
        <source>the standard uncertainty of y is missing in row %1</source>
        <translation>falta la incertidumbre típica de y en la fila %1</translation>
    </message>
    <message>
        <source>the standard uncertainty of y must be greater than zero in row %1</source>
        <translation>la incertidumbre típica de y debe ser mayor que cero en la fila %1</translation>
    </message>
    <message>
        <source>readings have the scatter of the residuals, which stated uncertainties do not use: give u_y in row %1</source>
        <translation>las lecturas tienen la dispersión de los residuos, que las incertidumbres indicadas no usan: dé u_y en la fila %1</translation>
    </message>
    <message>
        <source>a curve through the origin needs differences: give y in K</source>
        <translation>una curva por el origen necesita diferencias: dé y en K</translation>
    </message>
    <message>
        <source>a polynomial of this degree needs points at %1 different places or more beside the origin</source>
        <translation>un polinomio de este grado necesita puntos en %1 lugares distintos o más además del origen</translation>
    </message>
    <message>
        <source>a polynomial of this degree needs points at %1 different places or more</source>
        <translation>un polinomio de este grado necesita puntos en %1 lugares distintos o más</translation>
    </message>
    <message>
        <source>residuals say nothing about the uncertainty unless there are more points than coefficients: add points, or state u_y</source>
        <translation>los residuos no dicen nada de la incertidumbre si no hay más puntos que coeficientes: añada puntos, o indique u_y</translation>
    </message>
    <message>
        <source>line %1, %2</source>
        <translation>línea %1, %2</translation>
    </message>
    <message>
        <source>The mesh is not drawn: %1: %2</source>
        <translation>La malla no se dibuja: %1: %2</translation>
    </message>
    <message>
        <source>The mesh is not drawn: %1</source>
        <translation>La malla no se dibuja: %1</translation>
    </message>
    <message>
        <source>it has more than %1 triangles: thin it out</source>
        <translation>tiene más de %1 triángulos: redúzcalo</translation>
    </message>
    <message>
        <source>triangle %1 has a coordinate that is not a finite number</source>
        <translation>el triángulo %1 tiene una coordenada que no es un número finito</translation>
    </message>
    <message>
        <source>triangle %1: %2 is no number</source>
        <translation>triángulo %1: %2 no es un número</translation>
    </message>
    <message>
        <source>it ends in triangle %1: it has been cut off</source>
        <translation>termina en el triángulo %1: está cortado</translation>
    </message>
    <message>
        <source>triangle %1: %2 stands where %3 should</source>
        <translation>triángulo %1: está %2 donde debería estar %3</translation>
    </message>
    <message>
        <source>it is no STL file: it neither begins with &quot;solid&quot; nor has a header of 84 bytes</source>
        <translation>no es un archivo STL: ni empieza por &quot;solid&quot; ni tiene una cabecera de 84 bytes</translation>
    </message>
    <message>
        <source>it is no STL file: its header states %1 triangles, and there is more behind them</source>
        <translation>no es un archivo STL: su cabecera indica %1 triángulos, y hay más detrás de ellos</translation>
    </message>
    <message>
        <source>its header states %1 triangles; it ends in triangle %2</source>
        <translation>su cabecera indica %1 triángulos; termina en el triángulo %2</translation>
    </message>
    <message>
        <source>it has no triangles</source>
        <translation>no tiene triángulos</translation>
    </message>
    <message>
        <source>target uncertainty</source>
        <translation>incertidumbre objetivo</translation>
    </message>
    <message>
        <source>mean of the prior</source>
        <translation>media de la distribución a priori</translation>
    </message>
    <message>
        <source>standard deviation of the prior</source>
        <translation>desviación típica de la distribución a priori</translation>
    </message>
    <message>
        <source>the %1 must be greater than zero</source>
        <translation>%1: debe ser mayor que cero</translation>
    </message>
    <message>
        <source>the %1 must be above the lower limit</source>
        <translation>%1: debe estar por encima del límite inferior</translation>
    </message>
    <message>
        <source>the guard factor of %1 must lie between -10 and 10; 1 is a guard band of U, 0 simple acceptance</source>
        <translation>el factor de guarda de %1 debe estar entre -10 y 10; 1 es una banda de guarda de U, 0 aceptación simple</translation>
    </message>
    <message>
        <source>the prior of %1 needs both a mean and a standard deviation</source>
        <translation>la distribución a priori de %1 necesita tanto una media como una desviación típica</translation>
    </message>
    <message>
        <source>the prior of %1 is of use only with a tolerance: give a limit</source>
        <translation>la distribución a priori de %1 solo sirve con una tolerancia: indique un límite</translation>
    </message>
    <message>
        <source> in %1</source>
        <translation> en %1</translation>
    </message>
    <message>
        <source>the model has no output quantity %1%2%3</source>
        <translation>el modelo no tiene ninguna magnitud de salida %1%2%3</translation>
    </message>
    <message>
        <source>an axis needs at least two values</source>
        <translation>un eje necesita al menos dos valores</translation>
    </message>
    <message>
        <source>&apos;from&apos; and &apos;to&apos; must be two different numbers</source>
        <translation>&apos;from&apos; y &apos;to&apos; deben ser dos números distintos</translation>
    </message>
    <message>
        <source>with logarithmic spacing both ends must be greater than zero</source>
        <translation>con espaciado logarítmico, ambos extremos deben ser mayores que cero</translation>
    </message>
    <message>
        <source>&apos;%1&apos; takes whole numbers: there are fewer than %2 between the ends</source>
        <translation>&apos;%1&apos; toma números enteros: hay menos de %2 entre los extremos</translation>
    </message>
    <message>
        <source>a study has one to three axes; this one has %1</source>
        <translation>un estudio tiene de uno a tres ejes; este tiene %1</translation>
    </message>
    <message>
        <source>%1 is varied by two axes</source>
        <translation>dos ejes varían %1</translation>
    </message>
    <message>
        <source>Monte Carlo needs at least two trials</source>
        <translation>Monte Carlo necesita al menos dos pruebas</translation>
    </message>
    <message>
        <source>the grid has %1 points; a study may have %2</source>
        <translation>la cuadrícula tiene %1 puntos; un estudio puede tener %2</translation>
    </message>
    <message>
        <source>the uncertainty of an input quantity can be varied by a factor only</source>
        <translation>la incertidumbre de una magnitud de entrada solo se puede variar con un factor</translation>
    </message>
    <message>
        <source>a factor has no unit</source>
        <translation>un factor no tiene unidad</translation>
    </message>
    <message>
        <source>a factor of an uncertainty must not be negative</source>
        <translation>un factor de una incertidumbre no debe ser negativo</translation>
    </message>
    <message>
        <source>a temperature in %1 cannot be multiplied; add to it, or give its values</source>
        <translation>una temperatura en %1 no se puede multiplicar; súmele algo o indique sus valores</translation>
    </message>
    <message>
        <source>a number that varies</source>
        <translation>un número que varía</translation>
    </message>
    <message>
        <source>an axis of a study</source>
        <translation>un eje de un estudio</translation>
    </message>
    <message>
        <source>an output of a study</source>
        <translation>una salida de un estudio</translation>
    </message>
    <message>
        <source>a study</source>
        <translation>un estudio</translation>
    </message>
    <message>
        <source>only numbers of the set-up of an asset can be varied</source>
        <translation>solo se pueden variar los números de la configuración de un recurso</translation>
    </message>
    <message>
        <source>a target is written as &quot;/setup/KEY&quot;, &quot;/setup/KEY/rows/0/COLUMN&quot;, &quot;/inputs/SYMBOL/estimate&quot; or &quot;/inputs/SYMBOL/components&quot;</source>
        <translation>un objetivo se escribe como &quot;/setup/KEY&quot;, &quot;/setup/KEY/rows/0/COLUMN&quot;, &quot;/inputs/SYMBOL/estimate&quot; o &quot;/inputs/SYMBOL/components&quot;</translation>
    </message>
    <message>
        <source>the set-up has no schema</source>
        <translation>la configuración no tiene esquema</translation>
    </message>
    <message>
        <source>the set-up has no field %1%2</source>
        <translation>la configuración no tiene ningún campo %1%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not used with the present choices of the set-up</source>
        <translation>&apos;%1&apos; no se usa con las opciones actuales de la configuración</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number</source>
        <translation>&apos;%1&apos; no es un número</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not given, so there is nothing to change</source>
        <translation>&apos;%1&apos; no está indicado, así que no hay nada que cambiar</translation>
    </message>
    <message>
        <source>a coordinate of the pose &apos;%1&apos; is written as &quot;/setup/%2/position/0&quot; or &quot;/setup/%3/angles/2&quot;</source>
        <translation>una coordenada de la pose &apos;%1&apos; se escribe como &quot;/setup/%2/position/0&quot; o &quot;/setup/%3/angles/2&quot;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not given</source>
        <translation>&apos;%1&apos; no está indicado</translation>
    </message>
    <message>
        <source>a number of the table &apos;%1&apos; is written as &quot;/setup/%2/rows/0/COLUMN&quot; or &quot;/setup/%3/columns/COLUMN&quot;</source>
        <translation>un número de la tabla &apos;%1&apos; se escribe como &quot;/setup/%2/rows/0/COLUMN&quot; o &quot;/setup/%3/columns/COLUMN&quot;</translation>
    </message>
    <message>
        <source>the table &apos;%1&apos; has no column %2</source>
        <translation>la tabla &apos;%1&apos; no tiene ninguna columna %2</translation>
    </message>
    <message>
        <source>the column %1 does not hold numbers</source>
        <translation>la columna %1 no contiene números</translation>
    </message>
    <message>
        <source>the table &apos;%1&apos; is empty</source>
        <translation>la tabla &apos;%1&apos; está vacía</translation>
    </message>
    <message>
        <source>the table &apos;%1&apos; has %2 rows, counted from 0</source>
        <translation>la tabla &apos;%1&apos; tiene %2 filas, contadas desde 0</translation>
    </message>
    <message>
        <source>the cell is empty, so there is nothing to change</source>
        <translation>la celda está vacía, así que no hay nada que cambiar</translation>
    </message>
    <message>
        <source>the column is empty, so there is nothing to change</source>
        <translation>la columna está vacía, así que no hay nada que cambiar</translation>
    </message>
    <message>
        <source>of an input quantity, &quot;estimate&quot; or &quot;components&quot; can be varied</source>
        <translation>de una magnitud de entrada se pueden variar &quot;estimate&quot; o &quot;components&quot;</translation>
    </message>
    <message>
        <source>the model has no input quantity %1%2</source>
        <translation>el modelo no tiene ninguna magnitud de entrada %1%2</translation>
    </message>
    <message>
        <source>there is no component %1%2</source>
        <translation>no hay ninguna componente %1%2</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; has no unit; it is not a measured number</source>
        <translation>la columna &apos;%1&apos; de &apos;%2&apos; no tiene unidad; no es un número medido</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; is missing</source>
        <translation>falta la columna &apos;%1&apos; de &apos;%2&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no column &apos;%2&apos;%3; its columns are %4</source>
        <translation>&apos;%1&apos; no tiene ninguna columna &apos;%2&apos;%3; sus columnas son %4</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; is given twice</source>
        <translation>la columna &apos;%1&apos; de &apos;%2&apos; está indicada dos veces</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be one of %2; it is &apos;%3&apos;%4</source>
        <translation>&apos;%1&apos; debe ser uno de %2; es &apos;%3&apos;%4</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a whole number that is not negative; it is %2</source>
        <translation>&apos;%1&apos; debe ser un número entero no negativo; es %2</translation>
    </message>
    <message>
        <source>a unit is needed here, such as &quot;mm&quot;, not %1</source>
        <translation>aquí hace falta una unidad, como &quot;mm&quot;, no %1</translation>
    </message>
    <message>
        <source>a unit with a dimension is needed here, not &apos;%1&apos;</source>
        <translation>aquí hace falta una unidad con dimensión, no &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is of the same dimension as a unit before it; give one of each</source>
        <translation>&apos;%1&apos; es de la misma dimensión que una unidad anterior; indique una de cada</translation>
    </message>
    <message>
        <source>what the project states for results</source>
        <translation>lo que el proyecto indica para los resultados</translation>
    </message>
    <message>
        <source>the coverage factor must be greater than zero; without one, k follows from the degrees of freedom or the coverage interval</source>
        <translation>el factor de cobertura debe ser mayor que cero; sin él, k resulta de los grados de libertad o del intervalo de cobertura</translation>
    </message>
    <message>
        <source>a report has no chapter %1%2</source>
        <translation>un informe no tiene ningún capítulo %1%2</translation>
    </message>
    <message>
        <source>there is no analysis %1%2</source>
        <translation>no hay ningún análisis %1%2</translation>
    </message>
    <message>
        <source>the contents of the report</source>
        <translation>el contenido del informe</translation>
    </message>
    <message>
        <source>a requirement</source>
        <translation>un requisito</translation>
    </message>
    <message>
        <source>a unit of length is needed here, not %1</source>
        <translation>aquí hace falta una unidad de longitud, no %1</translation>
    </message>
    <message>
        <source>the size of a view must be greater than zero</source>
        <translation>el tamaño de una vista debe ser mayor que cero</translation>
    </message>
    <message>
        <source>&apos;direction&apos; and &apos;up&apos; must be two different directions, not of length zero</source>
        <translation>&apos;direction&apos; y &apos;up&apos; deben ser dos direcciones distintas, de longitud no nula</translation>
    </message>
    <message>
        <source>a view</source>
        <translation>una vista</translation>
    </message>
    <message>
        <source>%1 is the name of a standard view</source>
        <translation>%1 es el nombre de una vista estándar</translation>
    </message>
    <message>
        <source>the name %1 is used twice</source>
        <translation>el nombre %1 se usa dos veces</translation>
    </message>
    <message>
        <source>there is no single value here, but a list or a group</source>
        <translation>aquí no hay un único valor, sino una lista o un grupo</translation>
    </message>
    <message>
        <source>there is nothing called &apos;%1&apos; to set</source>
        <translation>no hay nada llamado &apos;%1&apos; que se pueda fijar</translation>
    </message>
    <message>
        <source>there is nothing called &apos;%1&apos; to set%2</source>
        <translation>no hay nada llamado &apos;%1&apos; que se pueda fijar%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not of the form /PLACE/IN/THE/PROJECT=VALUE</source>
        <translation>&apos;%1&apos; no tiene la forma /PLACE/IN/THE/PROJECT=VALUE</translation>
    </message>
    <message>
        <source>%1 is a table: it needs &quot;columns&quot; and &quot;rows&quot;, or the name of a &quot;csv&quot; file</source>
        <translation>%1 es una tabla: necesita &quot;columns&quot; y &quot;rows&quot;, o el nombre de un archivo &quot;csv&quot;</translation>
    </message>
    <message>
        <source>the columns of %1 must be texts in quotes</source>
        <translation>las columnas de %1 deben ser textos entre comillas</translation>
    </message>
    <message>
        <source>row %1 of %2 must be a list in brackets, not %3</source>
        <translation>la fila %1 de %2 debe ser una lista entre corchetes, no %3</translation>
    </message>
    <message>
        <source>a text in quotes</source>
        <translation>un texto entre comillas</translation>
    </message>
    <message>
        <source>the columns of the CSV file of %1 must be an object in braces: a header of the file and the column it stands for</source>
        <translation>las columnas del archivo CSV de %1 deben ser un objeto entre llaves: un encabezado del archivo y la columna a la que corresponde</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must stand for a column of %2 (a text), or for none (an empty text)</source>
        <translation>&apos;%1&apos; debe corresponder a una columna de %2 (un texto), o a ninguna (un texto vacío)</translation>
    </message>
    <message>
        <source>the CSV file &apos;%1&apos; of %2 must be named relative to the project&apos;s folder and lie in it</source>
        <translation>el archivo CSV &apos;%1&apos; de %2 debe nombrarse en relación con la carpeta del proyecto y estar en ella</translation>
    </message>
    <message>
        <source>the CSV file of %1 does not exist: looked for &apos;%2&apos;</source>
        <translation>el archivo CSV de %1 no existe: se buscó &apos;%2&apos;</translation>
    </message>
    <message>
        <source>CSV file of %1: %2</source>
        <translation>Archivo CSV de %1: %2</translation>
    </message>
    <message>
        <source>%1 must be a whole number, not %2</source>
        <translation>%1 debe ser un número entero, no %2</translation>
    </message>
    <message>
        <source>%1 is %2; its unit is missing: write {&quot;value&quot;: %3, &quot;unit&quot;: &quot;%4&quot;}</source>
        <translation>%1 es %2; falta su unidad: escriba {&quot;value&quot;: %3, &quot;unit&quot;: &quot;%4&quot;}</translation>
    </message>
    <message>
        <source>%1 must be a text in quotes, not %2</source>
        <translation>%1 debe ser un texto entre comillas, no %2</translation>
    </message>
    <message>
        <source>the lines of %1 must be texts in quotes, each one line</source>
        <translation>las líneas de %1 deben ser textos entre comillas, cada uno de una línea</translation>
    </message>
    <message>
        <source>&apos;%1&apos; of %2 must be a list of three numbers</source>
        <translation>&apos;%1&apos; de %2 debe ser una lista de tres números</translation>
    </message>
    <message>
        <source>this set-up</source>
        <translation>esta configuración</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be three numbers: x, y, z</source>
        <translation>&apos;%1&apos; debe ser tres números: x, y, z</translation>
    </message>
    <message>
        <source>a text is needed here, not %1</source>
        <translation>aquí hace falta un texto, no %1</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>el archivo está vacío</translation>
    </message>
    <message>
        <source>the project ends before this: nothing may follow its closing &apos;}&apos;</source>
        <translation>el proyecto termina antes de esto: nada puede seguir a su &apos;}&apos; de cierre</translation>
    </message>
    <message>
        <source>%1 (column %2)</source>
        <translation>%1 (columna %2)</translation>
    </message>
    <message>
        <source>the file is truncated: it ends %1; its rest is missing</source>
        <translation>el archivo está truncado: termina %1; falta el resto</translation>
    </message>
    <message>
        <source>lists and objects are nested too deeply</source>
        <translation>las listas y los objetos están anidados a demasiada profundidad</translation>
    </message>
    <message>
        <source>where a value is expected</source>
        <translation>donde se espera un valor</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is too large a number</source>
        <translation>&apos;%1&apos; es un número demasiado grande</translation>
    </message>
    <message>
        <source>in the middle of a value</source>
        <translation>en medio de un valor</translation>
    </message>
    <message>
        <source>a value is expected here (a number, a text in quotes, a list or an object), not &apos;%1&apos;</source>
        <translation>aquí se espera un valor (un número, un texto entre comillas, una lista o un objeto), no &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number that a project file can hold: give a finite number, or null where infinity is meant</source>
        <translation>&apos;%1&apos; no es un número que un archivo de proyecto pueda contener: indique un número finito, o null para infinito</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a value: texts stand in double quotes, numbers are written like -12.5e-3</source>
        <translation>&apos;%1&apos; no es un valor: los textos van entre comillas dobles, los números se escriben como -12.5e-3</translation>
    </message>
    <message>
        <source>the text that begins here is not closed by a double quote on its line</source>
        <translation>el texto que empieza aquí no se cierra con comillas dobles en su línea</translation>
    </message>
    <message>
        <source>in the middle of a text</source>
        <translation>en medio de un texto</translation>
    </message>
    <message>
        <source>inside %1</source>
        <translation>dentro de %1</translation>
    </message>
    <message>
        <source>&apos;,&apos; or &apos;%1&apos; is expected here, inside %2, not &apos;%3&apos;</source>
        <translation>aquí se espera &apos;,&apos; o &apos;%1&apos;, dentro de %2, no &apos;%3&apos;</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>un objeto</translation>
    </message>
    <message>
        <source>a key in double quotes is expected here</source>
        <translation>aquí se espera una clave entre comillas dobles</translation>
    </message>
    <message>
        <source>the key before this is not a valid text</source>
        <translation>la clave anterior no es un texto válido</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is given twice in the same object</source>
        <translation>&apos;%1&apos; aparece dos veces en el mismo objeto</translation>
    </message>
    <message>
        <source>after the key &apos;%1&apos;</source>
        <translation>después de la clave &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;:&apos; is expected after the key &apos;%1&apos;</source>
        <translation>se espera &apos;:&apos; después de la clave &apos;%1&apos;</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>una lista</translation>
    </message>
    <message>
        <source>there is no kind of asset &apos;%1&apos;%2; known are %3</source>
        <translation>no hay ninguna clase de recurso &apos;%1&apos;%2; las conocidas son %3</translation>
    </message>
    <message>
        <source>there is no measurement model &apos;%1&apos;%2; known are %3</source>
        <translation>no hay ningún modelo de medición &apos;%1&apos;%2; los conocidos son %3</translation>
    </message>
    <message>
        <source>%1 is taken from another analysis, with all its uncertainty: remove either this or the link</source>
        <translation>%1 se toma de otro análisis, con toda su incertidumbre: elimine esto o el vínculo</translation>
    </message>
    <message>
        <source>the analysis %1 has errors of its own: %2</source>
        <translation>el análisis %1 tiene errores propios: %2</translation>
    </message>
    <message>
        <source>the analysis %1 has no value at its estimates</source>
        <translation>el análisis %1 no tiene valor en sus estimaciones</translation>
    </message>
    <message>
        <source>the component %1 is not stated alike (held, or edited) by all analyses of the chain: they are taken as independent</source>
        <translation>la componente %1 no está indicada igual (fijada o editada) en todos los análisis de la cadena: se toman como independientes</translation>
    </message>
    <message>
        <source>%1 is linked twice</source>
        <translation>%1 está vinculado dos veces</translation>
    </message>
    <message>
        <source>%1 is %2; %3 of %4 is %5</source>
        <translation>%1 es %2; %3 de %4 es %5</translation>
    </message>
    <message>
        <source>the analysis %1 would be made of itself: %2%3</source>
        <translation>el análisis %1 se formaría a partir de sí mismo: %2%3</translation>
    </message>
    <message>
        <source>the analysis %1 has no output %2%3</source>
        <translation>el análisis %1 no tiene ninguna salida %2%3</translation>
    </message>
    <message>
        <source>&apos;schemaVersion&apos; is missing</source>
        <translation>falta &apos;schemaVersion&apos;</translation>
    </message>
    <message>
        <source>&apos;schemaVersion&apos; must be a whole number</source>
        <translation>&apos;schemaVersion&apos; debe ser un número entero</translation>
    </message>
    <message>
        <source>written by a newer version of Covaria (schema %1, this program reads up to %2); nothing was changed</source>
        <translation>escrito por una versión más reciente de Covaria (esquema %1, este programa lee hasta %2); no se ha cambiado nada</translation>
    </message>
    <message>
        <source>the text &apos;%1&apos;</source>
        <translation>el texto &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the number %1</source>
        <translation>el número %1</translation>
    </message>
    <message>
        <source>%1 must be an object in braces, not %2</source>
        <translation>%1 debe ser un objeto entre llaves, no %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is missing in %2</source>
        <translation>falta &apos;%1&apos; en %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be %2, not %3</source>
        <translation>&apos;%1&apos; debe ser %2, no %3</translation>
    </message>
    <message>
        <source>a list in brackets</source>
        <translation>una lista entre corchetes</translation>
    </message>
    <message>
        <source>there is no &apos;%1&apos; in %2%3</source>
        <translation>no hay &apos;%1&apos; en %2%3</translation>
    </message>
    <message>
        <source>a number with its unit</source>
        <translation>un número con su unidad</translation>
    </message>
    <message>
        <source>a whole number from 0 to 18446744073709551615, in quotes</source>
        <translation>un número entero de 0 a 18446744073709551615, entre comillas</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be %2; it is %3</source>
        <translation>&apos;%1&apos; debe ser %2; es %3</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>uno de %1</translation>
    </message>
    <message>
        <source>a whole number that is not negative</source>
        <translation>un número entero no negativo</translation>
    </message>
    <message>
        <source>a text here is not valid UTF-8 or has a wrong \ sequence</source>
        <translation>un texto de aquí no es UTF-8 válido o tiene una secuencia \ incorrecta</translation>
    </message>
    <message>
        <source>the project</source>
        <translation>el proyecto</translation>
    </message>
    <message>
        <source>an asset</source>
        <translation>un recurso</translation>
    </message>
    <message>
        <source>an analysis</source>
        <translation>un análisis</translation>
    </message>
    <message>
        <source>this is not a project of Covaria: it does not begin with &quot;format&quot;: &quot;covaria&quot;</source>
        <translation>no es un proyecto de Covaria: no empieza con &quot;format&quot;: &quot;covaria&quot;</translation>
    </message>
    <message>
        <source>it has %1 MB, and projects of up to %2 MB are read: put its long tables into CSV files beside it</source>
        <translation>tiene %1 MB, y se leen proyectos de hasta %2 MB: ponga sus tablas largas en archivos CSV junto a él</translation>
    </message>
    <message>
        <source>the project was not saved: it holds a number that is not finite, or fields that belong to no known kind of asset or model</source>
        <translation>el proyecto no se ha guardado: contiene un número que no es finito, o campos que no pertenecen a ninguna clase de recurso ni modelo conocidos</translation>
    </message>
    <message>
        <source>the project was not saved: %1</source>
        <translation>el proyecto no se ha guardado: %1</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be two capital letters, such as DE; it is &apos;%2&apos;</source>
        <translation>&apos;%1&apos; debe tener dos letras mayúsculas, como DE; es &apos;%2&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be one of %2; it is &apos;%3&apos;</source>
        <translation>&apos;%1&apos; debe ser uno de %2; es &apos;%3&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a date of the form 2026-04-17 or an interval 2026-04-17/2026-04-18; it is &apos;%2&apos;</source>
        <translation>&apos;%1&apos; debe ser una fecha de la forma 2026-04-17 o un intervalo 2026-04-17/2026-04-18; es &apos;%2&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a date of the form 2026-04-17; it is &apos;%2&apos;</source>
        <translation>&apos;%1&apos; debe ser una fecha de la forma 2026-04-17; es &apos;%2&apos;</translation>
    </message>
    <message>
        <source>the item cannot have been calibrated before it was received</source>
        <translation>el objeto no puede haberse calibrado antes de recibirse</translation>
    </message>
    <message>
        <source>the certificate cannot have been issued before the calibration</source>
        <translation>el certificado no puede haberse emitido antes de la calibración</translation>
    </message>
    <message>
        <source> (or %1)</source>
        <translation> (o %1)</translation>
    </message>
    <message>
        <source>&apos;%1&apos;%2 must be stated (ISO/IEC 17025 %3)</source>
        <translation>&apos;%1&apos;%2 debe indicarse (ISO/IEC 17025 %3)</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be stated (Digital Calibration Certificate)</source>
        <translation>&apos;%1&apos; debe indicarse (certificado de calibración digital)</translation>
    </message>
    <message>
        <source>the certificate</source>
        <translation>el certificado</translation>
    </message>
    <message>
        <source>%1 has more than 2 MB, too much for a logo</source>
        <translation>%1 tiene más de 2 MB, demasiado para un logotipo</translation>
    </message>
    <message>
        <source>%1 is neither a PNG nor a JPEG picture</source>
        <translation>%1 no es una imagen PNG ni JPEG</translation>
    </message>
    <message>
        <source>The certificate has no logo: %1</source>
        <translation>El certificado no tiene logotipo: %1</translation>
    </message>
    <message>
        <source>more than %1 columns are not read</source>
        <translation>no se leen más de %1 columnas</translation>
    </message>
    <message>
        <source>the quote that begins here is not closed</source>
        <translation>las comillas que se abren aquí no se cierran</translation>
    </message>
    <message>
        <source>text follows the closing quote of a cell; write a quote inside a quoted cell twice</source>
        <translation>hay texto después de las comillas de cierre de una celda; dentro de una celda entrecomillada, escriba las comillas dos veces</translation>
    </message>
    <message>
        <source>the text is encoded as UTF-16; save it as UTF-8</source>
        <translation>el texto está codificado en UTF-16; guárdelo en UTF-8</translation>
    </message>
    <message>
        <source>the text is not encoded as UTF-8; save it as UTF-8</source>
        <translation>el texto no está codificado en UTF-8; guárdelo en UTF-8</translation>
    </message>
    <message>
        <source>this row has %1 cells; there are %2 columns</source>
        <translation>esta fila tiene %1 celdas; hay %2 columnas</translation>
    </message>
    <message>
        <source>column &apos;%1&apos;: &apos;%2&apos; is not a number</source>
        <translation>columna &apos;%1&apos;: &apos;%2&apos; no es un número</translation>
    </message>
    <message>
        <source>column &apos;%1&apos;: &apos;%2&apos; is neither true nor false</source>
        <translation>columna &apos;%1&apos;: &apos;%2&apos; no es true ni false</translation>
    </message>
    <message>
        <source>the file has no column &apos;%1&apos;%2; its columns are %3</source>
        <translation>el archivo no tiene ninguna columna &apos;%1&apos;%2; sus columnas son %3</translation>
    </message>
    <message>
        <source>there is no row with the names of the columns</source>
        <translation>no hay ninguna fila con los nombres de las columnas</translation>
    </message>
    <message>
        <source>it has %1 lines, and there is memory for about %2 of these rows: leave rows out, or take means of several</source>
        <translation>tiene %1 líneas, y hay memoria para unas %2 de estas filas: omita filas, o tome medias de varias</translation>
    </message>
    <message>
        <source>a table to choose from is written as &quot;/setup/KEY/rows&quot;; it is %1</source>
        <translation>una tabla de la que elegir se escribe como &quot;/setup/KEY/rows&quot;; es %1</translation>
    </message>
    <message>
        <source>a design needs &apos;variables&apos;, a table to &apos;choose&apos; from, or &apos;reductions&apos;</source>
        <translation>un diseño necesita &apos;variables&apos;, una tabla de la que elegir (&apos;choose&apos;) o &apos;reductions&apos;</translation>
    </message>
    <message>
        <source>the cheapest reductions are a design of their own, without variables and rows</source>
        <translation>las reducciones más baratas son un diseño propio, sin variables ni filas</translation>
    </message>
    <message>
        <source>a design has at most %1 reductions</source>
        <translation>un diseño tiene como máximo %1 reducciones</translation>
    </message>
    <message>
        <source>a design has at most %1 variables</source>
        <translation>un diseño tiene como máximo %1 variables</translation>
    </message>
    <message>
        <source>the cost is that of rows with &apos;prices&apos;: it needs a table to choose from, and no variables</source>
        <translation>el coste es el de filas con &apos;prices&apos;: necesita una tabla de la que elegir, y ninguna variable</translation>
    </message>
    <message>
        <source>a tolerance must not be negative</source>
        <translation>una tolerancia no debe ser negativa</translation>
    </message>
    <message>
        <source>&apos;%1&apos; takes whole numbers: a study shows what each of them gives</source>
        <translation>&apos;%1&apos; toma números enteros: un estudio muestra lo que da cada uno de ellos</translation>
    </message>
    <message>
        <source>%1 is chosen by two variables</source>
        <translation>dos variables eligen %1</translation>
    </message>
    <message>
        <source>the smallest factor is between 0 and 1</source>
        <translation>el factor mínimo está entre 0 y 1</translation>
    </message>
    <message>
        <source>a price must not be negative</source>
        <translation>un precio no debe ser negativo</translation>
    </message>
    <message>
        <source>%1 is reduced twice</source>
        <translation>%1 se reduce dos veces</translation>
    </message>
    <message>
        <source>of %1 rows, %2 to %3 can be kept; it is %4</source>
        <translation>de %1 filas se pueden conservar de %2 a %3; son %4</translation>
    </message>
    <message>
        <source>there are %1 rows, counted from 0</source>
        <translation>hay %1 filas, contadas desde 0</translation>
    </message>
    <message>
        <source>row %1 is fixed twice</source>
        <translation>la fila %1 está fijada dos veces</translation>
    </message>
    <message>
        <source>more rows are fixed than kept</source>
        <translation>hay más filas fijadas que conservadas</translation>
    </message>
    <message>
        <source>there is one price for all rows, or one for each of the %1; there are %2</source>
        <translation>hay un precio para todas las filas, o uno para cada una de las %1; hay %2</translation>
    </message>
    <message>
        <source>a box</source>
        <translation>una caja</translation>
    </message>
    <message>
        <source>every coordinate of &apos;to&apos; must be greater than that of &apos;from&apos;</source>
        <translation>cada coordenada de &apos;to&apos; debe ser mayor que la de &apos;from&apos;</translation>
    </message>
    <message>
        <source>the least distance</source>
        <translation>la distancia mínima</translation>
    </message>
    <message>
        <source>the least distance must be greater than zero</source>
        <translation>la distancia mínima debe ser mayor que cero</translation>
    </message>
    <message>
        <source>there are 1 to %1 starts</source>
        <translation>hay de 1 a %1 inicios</translation>
    </message>
    <message>
        <source>at least one evaluation is needed</source>
        <translation>hace falta al menos una evaluación</translation>
    </message>
    <message>
        <source>the set-up has no table %1%2</source>
        <translation>la configuración no tiene ninguna tabla %1%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be %2; it is &apos;%3&apos;</source>
        <translation>&apos;%1&apos; debe ser %2; es &apos;%3&apos;</translation>
    </message>
    <message>
        <source>a variable of a design</source>
        <translation>una variable de un diseño</translation>
    </message>
    <message>
        <source>a number that is reduced</source>
        <translation>un número que se reduce</translation>
    </message>
    <message>
        <source>a reduction of a design</source>
        <translation>una reducción de un diseño</translation>
    </message>
    <message>
        <source>the choice of a design</source>
        <translation>la elección de un diseño</translation>
    </message>
    <message>
        <source>a box of a design</source>
        <translation>una caja de un diseño</translation>
    </message>
    <message>
        <source>a design</source>
        <translation>un diseño</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a list of numbers</source>
        <translation>&apos;%1&apos; debe ser una lista de números</translation>
    </message>
    <message>
        <source>the parameters of &apos;%1&apos;</source>
        <translation>los parámetros de &apos;%1&apos;</translation>
    </message>
    <message>
        <source>a distribution</source>
        <translation>una distribución</translation>
    </message>
    <message>
        <source>there is no distribution &apos;%1&apos;%2; known are %3</source>
        <translation>no hay ninguna distribución &apos;%1&apos;%2; las conocidas son %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is missing in a component</source>
        <translation>falta &apos;%1&apos; en una componente</translation>
    </message>
    <message>
        <source>a component</source>
        <translation>una componente</translation>
    </message>
    <message>
        <source>the edit of an input quantity</source>
        <translation>la edición de una magnitud de entrada</translation>
    </message>
    <message>
        <source>the notes of a quantity</source>
        <translation>las notas de una magnitud</translation>
    </message>
    <message>
        <source>an output of an analysis</source>
        <translation>una salida de un análisis</translation>
    </message>
    <message>
        <source>a link</source>
        <translation>un enlace</translation>
    </message>
    <message>
        <source>a correlation</source>
        <translation>una correlación</translation>
    </message>
    <message>
        <source>component %1</source>
        <translation>componente %1</translation>
    </message>
    <message>
        <source>%1 is %2; the unit %3 of %4 is the unit of %5</source>
        <translation>%1 es %2; la unidad %3 de %4 es la unidad de %5</translation>
    </message>
    <message>
        <source>%1: the degrees of freedom must be greater than zero</source>
        <translation>%1: los grados de libertad deben ser mayores que cero</translation>
    </message>
    <message>
        <source>%1 is a component, not an input quantity: it can be held, but not be edited otherwise</source>
        <translation>%1 es una componente, no una magnitud de entrada: se puede fijar, pero no editar de otro modo</translation>
    </message>
    <message>
        <source>%1 has no uncertainty to be correlated</source>
        <translation>%1 no tiene incertidumbre que correlacionar</translation>
    </message>
    <message>
        <source>there is no component or quantity %1%2</source>
        <translation>no hay ninguna componente ni magnitud %1%2</translation>
    </message>
    <message>
        <source>%1 cannot be correlated with itself</source>
        <translation>%1 no se puede correlacionar consigo mismo</translation>
    </message>
    <message>
        <source>%1 and %2 have the component %3 in common, which correlates them; state the correlation of other components instead</source>
        <translation>%1 y %2 tienen en común la componente %3, que los correlaciona; indique en su lugar la correlación de otras componentes</translation>
    </message>
    <message>
        <source>%1 is edited twice</source>
        <translation>%1 se edita dos veces</translation>
    </message>
    <message>
        <source>the correlation of %1 and %2 is given twice</source>
        <translation>la correlación de %1 y %2 está indicada dos veces</translation>
    </message>
    <message>
        <source>a number is needed here; it is %1</source>
        <translation>aquí hace falta un número; es %1</translation>
    </message>
    <message>
        <source>%1: %2 must lie within %3</source>
        <translation>%1: %2 debe estar dentro de %3</translation>
    </message>
    <message>
        <source>the frame of %1 is missing</source>
        <translation>falta el sistema de %1</translation>
    </message>
    <message>
        <source>no calibration of a robot: &apos;kinematics&apos; is missing</source>
        <translation>no es una calibración de un robot: falta &apos;kinematics&apos;</translation>
    </message>
    <message>
        <source>calibration %1</source>
        <translation>calibración %1</translation>
    </message>
    <message>
        <source>lengths in m, angles in rad, about fixed axes as in URDF</source>
        <translation>longitudes en m, ángulos en rad, alrededor de ejes fijos como en URDF</translation>
    </message>
    <message>
        <source>%1 is called %2 here</source>
        <translation>%1 se llama %2 aquí</translation>
    </message>
    <message>
        <source>an input without a name</source>
        <translation>una entrada sin nombre</translation>
    </message>
    <message>
        <source>its %1 must be a number</source>
        <translation>su %1 debe ser un número</translation>
    </message>
    <message>
        <source>there are two inputs of that name</source>
        <translation>hay dos entradas con ese nombre</translation>
    </message>
    <message>
        <source>%1 %2 is %3 %4</source>
        <translation>%1 %2 es %3 %4</translation>
    </message>
    <message>
        <source>typea_uncert must be a number from 0</source>
        <translation>typea_uncert debe ser un número a partir de 0</translation>
    </message>
    <message>
        <source>typea must be a list of at least two observations</source>
        <translation>typea debe ser una lista de al menos dos observaciones</translation>
    </message>
    <message>
        <source>an observation must be a number; those in groups are not read</source>
        <translation>una observación debe ser un número; las agrupadas no se leen</translation>
    </message>
    <message>
        <source>more than %1 observations are not read</source>
        <translation>no se leen más de %1 observaciones</translation>
    </message>
    <message>
        <source>numnewmeas must be a number from 1</source>
        <translation>numnewmeas debe ser un número a partir de 1</translation>
    </message>
    <message>
        <source>its observations are taken as independent: Suncal enlarges the uncertainty of more than 50 that are autocorrelated</source>
        <translation>sus observaciones se toman como independientes: Suncal aumenta la incertidumbre de más de 50 que estén autocorrelacionadas</translation>
    </message>
    <message>
        <source>%1 %2 is no number</source>
        <translation>%1 %2 no es un número</translation>
    </message>
    <message>
        <source>%1 %2 is %3</source>
        <translation>%1 %2 es %3</translation>
    </message>
    <message>
        <source>degf must be a number greater than 0, or .inf</source>
        <translation>degf debe ser un número mayor que 0, o .inf</translation>
    </message>
    <message>
        <source>; it has %1</source>
        <translation>; tiene %1</translation>
    </message>
    <message>
        <source>the file has no calculation of mode &apos;uncertainty&apos; or &apos;system&apos;%1</source>
        <translation>el archivo no tiene ningún cálculo de modo &apos;uncertainty&apos; o &apos;system&apos;%1</translation>
    </message>
    <message>
        <source>%1: %2 quantities, %3 results</source>
        <translation>%1: %2 magnitudes, %3 resultados</translation>
    </message>
    <message>
        <source>the calculation has no inputs</source>
        <translation>el cálculo no tiene entradas</translation>
    </message>
    <message>
        <source>the calculation has no functions</source>
        <translation>el cálculo no tiene funciones</translation>
    </message>
    <message>
        <source>the system has no quantities</source>
        <translation>el sistema no tiene magnitudes</translation>
    </message>
    <message>
        <source>quantities of type %1 are not read; those that are: direct, indirect</source>
        <translation>no se leen magnitudes del tipo %1; las que se leen: direct, indirect</translation>
    </message>
    <message>
        <source>the system has no direct quantity</source>
        <translation>el sistema no tiene ninguna magnitud direct</translation>
    </message>
    <message>
        <source>more than %1 inputs are not read</source>
        <translation>no se leen más de %1 entradas</translation>
    </message>
    <message>
        <source>more than %1 functions are not read</source>
        <translation>no se leen más de %1 funciones</translation>
    </message>
    <message>
        <source>a function has the name of an input or of another function</source>
        <translation>una función tiene el nombre de una entrada o de otra función</translation>
    </message>
    <message>
        <source>%1: in %2 instead of %3</source>
        <translation>%1: en %2 en vez de %3</translation>
    </message>
    <message>
        <source>%1: no starting value</source>
        <translation>%1: sin valor inicial</translation>
    </message>
    <message>
        <source>%1: state the unit of what is solved for under &apos;units&apos;</source>
        <translation>%1: indique en &apos;units&apos; la unidad de lo que se resuelve</translation>
    </message>
    <message>
        <source>a correlation needs var1 and var2, two inputs, and cor, a number between -1 and 1</source>
        <translation>una correlación necesita var1 y var2, dos entradas, y cor, un número entre -1 y 1</translation>
    </message>
    <message>
        <source>no unit can be stated for %1%2</source>
        <translation>no se puede indicar unidad para %1%2</translation>
    </message>
    <message>
        <source>the file has no Excel workbook in it</source>
        <translation>el archivo no contiene ningún libro de Excel</translation>
    </message>
    <message>
        <source>the file has no sheet with cells</source>
        <translation>el archivo no tiene ninguna hoja con celdas</translation>
    </message>
    <message>
        <source>%1: %2 is no place of a cell</source>
        <translation>%1: %2 no es el lugar de una celda</translation>
    </message>
    <message>
        <source>%1: more than %2 cells are not read</source>
        <translation>%1: no se leen más de %2 celdas</translation>
    </message>
    <message>
        <source>its text is missing from the file</source>
        <translation>su texto falta en el archivo</translation>
    </message>
    <message>
        <source>the file has a password or the old format .xls: save it as .xlsx without a password</source>
        <translation>el archivo tiene contraseña o el formato antiguo .xls: guárdelo como .xlsx sin contraseña</translation>
    </message>
    <message>
        <source>XML of more than %1 MB is not read</source>
        <translation>no se lee XML de más de %1 MB</translation>
    </message>
    <message>
        <source>a document type declaration: files that declare entities are not read</source>
        <translation>una declaración de tipo de documento: no se leen archivos que declaran entidades</translation>
    </message>
    <message>
        <source>an alias (*name): write out what it stands for, aliases are not expanded</source>
        <translation>un alias (*name): escriba lo que representa, los alias no se expanden</translation>
    </message>
    <message>
        <source>more than %1 entries are not read</source>
        <translation>no se leen más de %1 entradas</translation>
    </message>
    <message>
        <source>more than %1 levels are not read</source>
        <translation>no se leen más de %1 niveles</translation>
    </message>
    <message>
        <source>a key must be a word</source>
        <translation>una clave debe ser una palabra</translation>
    </message>
    <message>
        <source>the key %1 stands twice</source>
        <translation>la clave %1 aparece dos veces</translation>
    </message>
    <message>
        <source>more than 1000 keys are not read</source>
        <translation>no se leen más de 1000 claves</translation>
    </message>
    <message>
        <source>YAML of more than %1 kB is not read</source>
        <translation>no se lee YAML de más de %1 kB</translation>
    </message>
    <message>
        <source>the file has no YAML document</source>
        <translation>el archivo no tiene ningún documento YAML</translation>
    </message>
    <message>
        <source>not readable as YAML: %1</source>
        <translation>no se puede leer como YAML: %1</translation>
    </message>
    <message>
        <source>the file has %1</source>
        <translation>el archivo tiene %1</translation>
    </message>
    <message>
        <source>no readable zip archive in it (%1)</source>
        <translation>no contiene ningún archivo zip legible (%1)</translation>
    </message>
    <message>
        <source>more than %1 parts, which are not read</source>
        <translation>más de %1 partes, que no se leen</translation>
    </message>
    <message>
        <source>no part %1</source>
        <translation>ninguna parte %1</translation>
    </message>
    <message>
        <source>a part %1 that cannot be read</source>
        <translation>una parte %1 que no se puede leer</translation>
    </message>
    <message>
        <source>an encrypted part %1: save it without a password</source>
        <translation>una parte %1 cifrada: guárdelo sin contraseña</translation>
    </message>
    <message>
        <source>a part %1 that cannot be unpacked</source>
        <translation>una parte %1 que no se puede descomprimir</translation>
    </message>
    <message>
        <source>a damaged part %1</source>
        <translation>una parte %1 dañada</translation>
    </message>
    <message>
        <source>parts that unpack to more than %1 MB (at %2), which are not read</source>
        <translation>partes que se descomprimen a más de %1 MB (en %2), que no se leen</translation>
    </message>
    <message>
        <source>no network of GNU Gama: &lt;gama-local&gt; with a &lt;network&gt; is expected</source>
        <translation>no es una red de GNU Gama: se espera &lt;gama-local&gt; con &lt;network&gt;</translation>
    </message>
    <message>
        <source>the stated unit of lengths: coordinates of Gama are in metres</source>
        <translation>la unidad de longitud indicada: las coordenadas de Gama están en metros</translation>
    </message>
    <message>
        <source>&lt;parameters&gt;</source>
        <translation>&lt;parameters&gt;</translation>
    </message>
    <message>
        <source>%1 &lt;%2&gt; with observations</source>
        <translation>%1 &lt;%2&gt; con observaciones</translation>
    </message>
    <message>
        <source>%1 points without x and y</source>
        <translation>%1 puntos sin x e y</translation>
    </message>
    <message>
        <source>%1 points have no z: it is taken as 0</source>
        <translation>%1 puntos no tienen z: se toma como 0</translation>
    </message>
    <message>
        <source>the network has no points with coordinates x and y</source>
        <translation>la red no tiene puntos con coordenadas x e y</translation>
    </message>
    <message>
        <source>%1 points are to be adjusted: their coordinates are approximate ones</source>
        <translation>%1 puntos deben compensarse: sus coordenadas son aproximadas</translation>
    </message>
    <message>
        <source>: a left-handed frame; x and y are taken as they stand</source>
        <translation>: un sistema levógiro; x e y se toman tal como están</translation>
    </message>
    <message>
        <source>coordinates in metres, axes-xy = %1%2</source>
        <translation>coordenadas en metros, axes-xy = %1%2</translation>
    </message>
    <message>
        <source>%1 = %2 is no number</source>
        <translation>%1 = %2 no es un número</translation>
    </message>
    <message>
        <source>too many points: divide the file</source>
        <translation>demasiados puntos: divida el archivo</translation>
    </message>
    <message>
        <source>&lt;coordinates&gt;: point %1 has no x and y</source>
        <translation>&lt;coordinates&gt;: el punto %1 no tiene x ni y</translation>
    </message>
    <message>
        <source>a covariance matrix of more than %1 coordinates</source>
        <translation>una matriz de covarianza de más de %1 coordenadas</translation>
    </message>
    <message>
        <source>the file has no adjusted coordinates</source>
        <translation>el archivo no tiene coordenadas compensadas</translation>
    </message>
    <message>
        <source>point %1 has no x and y</source>
        <translation>el punto %1 no tiene x ni y</translation>
    </message>
    <message>
        <source>adjusted coordinates in metres</source>
        <translation>coordenadas compensadas en metros</translation>
    </message>
    <message>
        <source>uncertainties: the file has no &lt;cov-mat&gt;</source>
        <translation>incertidumbres: el archivo no tiene &lt;cov-mat&gt;</translation>
    </message>
    <message>
        <source>residuals and orientations</source>
        <translation>residuos y orientaciones</translation>
    </message>
    <message>
        <source>its dim must be at least the %1 adjusted coordinates, its band less than it</source>
        <translation>su dim debe ser al menos las %1 coordenadas compensadas, y su band menor que él</translation>
    </message>
    <message>
        <source>element %1, %2 is no number</source>
        <translation>elemento %1, %2 no es un número</translation>
    </message>
    <message>
        <source>its dim must be the %1 %2, its band less than that</source>
        <translation>su dim debe ser el número de %2, %1, y su band menor que él</translation>
    </message>
    <message>
        <source>element %1, %2: %3 is no number</source>
        <translation>elemento %1, %2: %3 no es un número</translation>
    </message>
    <message>
        <source>a covariance matrix of observations that are left out</source>
        <translation>una matriz de covarianza de observaciones que se omiten</translation>
    </message>
    <message>
        <source>the standard deviation %1 is no number</source>
        <translation>la desviación típica %1 no es un número</translation>
    </message>
    <message>
        <source>the standard deviation %1 must not be negative</source>
        <translation>la desviación típica %1 no debe ser negativa</translation>
    </message>
    <message>
        <source>, %1 of them without a standard deviation</source>
        <translation>, %1 de ellas sin desviación típica</translation>
    </message>
    <message>
        <source>, %1 correlations</source>
        <translation>, %1 correlaciones</translation>
    </message>
    <message>
        <source>%1 observations%2%3; each is its own result: write the equations of what you measure with them</source>
        <translation>%1 observaciones%2%3; cada una es su propio resultado: escriba las ecuaciones de lo que mide con ellas</translation>
    </message>
    <message>
        <source>%1 observations: more than %2</source>
        <translation>%1 observaciones: más de %2</translation>
    </message>
    <message>
        <source>the stated unit of lengths: words of GSI state theirs</source>
        <translation>la unidad de longitud indicada: las palabras de GSI indican la suya</translation>
    </message>
    <message>
        <source>words %1 (%2)</source>
        <translation>palabras %1 (%2)</translation>
    </message>
    <message>
        <source>%1 readings of reflectors above their points: the targets are the reflectors</source>
        <translation>%1 lecturas de reflectores situados sobre sus puntos: las dianas son los reflectores</translation>
    </message>
    <message>
        <source>the file has neither coordinates nor readings with a distance</source>
        <translation>el archivo no tiene ni coordenadas ni lecturas con distancia</translation>
    </message>
    <message>
        <source>the reading of %1: angles and a distance are needed</source>
        <translation>la lectura de %1: hacen falta ángulos y una distancia</translation>
    </message>
    <message>
        <source>coordinates E, N, H become x, y, z</source>
        <translation>las coordenadas E, N, H pasan a ser x, y, z</translation>
    </message>
    <message>
        <source>%1: more than %2 set-ups; divide the file</source>
        <translation>%1: más de %2 estacionamientos; divida el archivo</translation>
    </message>
    <message>
        <source>%1: its coordinates are not in the file: 0, 0, 0</source>
        <translation>%1: sus coordenadas no están en el archivo: 0, 0, 0</translation>
    </message>
    <message>
        <source>%1: readings of points that have coordinates</source>
        <translation>%1: lecturas de puntos que tienen coordenadas</translation>
    </message>
    <message>
        <source>%1: readings do not repeat, or are too far apart for it, and say nothing of their uncertainty: points</source>
        <translation>%1: las lecturas no se repiten, o están demasiado separadas para ello, y no dicen nada de su incertidumbre: puntos</translation>
    </message>
    <message>
        <source>no word of GSI: index, information, sign and data are expected</source>
        <translation>no es una palabra de GSI: se esperan índice, información, signo y datos</translation>
    </message>
    <message>
        <source>more than %1 blocks</source>
        <translation>más de %1 bloques</translation>
    </message>
    <message>
        <source>a block begins with the word 11 or 41</source>
        <translation>un bloque empieza con la palabra 11 o 41</translation>
    </message>
    <message>
        <source>the data of a word must be digits</source>
        <translation>los datos de una palabra deben ser cifras</translation>
    </message>
    <message>
        <source>the unit &apos;%1&apos; is none of %2</source>
        <translation>la unidad &apos;%1&apos; no es ninguna de %2</translation>
    </message>
    <message>
        <source>the file has no blocks of GSI</source>
        <translation>el archivo no tiene bloques de GSI</translation>
    </message>
    <message>
        <source>more than %1 lines are not read</source>
        <translation>no se leen más de %1 líneas</translation>
    </message>
    <message>
        <source>the name of a section is not closed by &apos;]&apos;</source>
        <translation>el nombre de una sección no se cierra con &apos;]&apos;</translation>
    </message>
    <message>
        <source>the section %1 stands twice</source>
        <translation>la sección %1 aparece dos veces</translation>
    </message>
    <message>
        <source>neither a section [...] nor a line name=value of one</source>
        <translation>ni una sección [...] ni una línea nombre=valor de una sección</translation>
    </message>
    <message>
        <source>no quantity with a value and an uncertainty</source>
        <translation>ninguna magnitud con un valor y una incertidumbre</translation>
    </message>
    <message>
        <source>the file has no equation (Model[1]=)</source>
        <translation>el archivo no tiene ecuación (Model[1]=)</translation>
    </message>
    <message>
        <source>log may be the natural or the decimal logarithm: write ln or log10</source>
        <translation>log puede ser el logaritmo natural o el decimal: escriba ln o log10</translation>
    </message>
    <message>
        <source>no file of GUM Workbench: the section [Components] is missing</source>
        <translation>no es un archivo de GUM Workbench: falta la sección [Components]</translation>
    </message>
    <message>
        <source>the section [COMP %1] is missing</source>
        <translation>falta la sección [COMP %1]</translation>
    </message>
    <message>
        <source>more than %1 quantities are not read</source>
        <translation>no se leen más de %1 magnitudes</translation>
    </message>
    <message>
        <source>%1= is missing</source>
        <translation>falta %1=</translation>
    </message>
    <message>
        <source>quantities of type %1 are not known; those that are: Result, TypBNormal, TypBRectang, TypAPooled</source>
        <translation>no se conocen las magnitudes de tipo %1; se conocen: Result, TypBNormal, TypBRectang, TypAPooled</translation>
    </message>
    <message>
        <source>result %1 as the file states it: %2</source>
        <translation>resultado %1 tal como lo indica el archivo: %2</translation>
    </message>
    <message>
        <source>section [%1]</source>
        <translation>sección [%1]</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 punto</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 puntos</translation>
    </message>
    <message>
        <source>1 name occurs again and has got a number: first %1</source>
        <translation>1 nombre se repite y ha recibido un número: el primero, %1</translation>
    </message>
    <message>
        <source>%1 names occur again and have got a number: first %2</source>
        <translation>%1 nombres se repiten y han recibido un número: el primero, %2</translation>
    </message>
    <message>
        <source>%1 groups in one artefact: their names stand before those of the points</source>
        <translation>%1 grupos en un artefacto: sus nombres van delante de los de los puntos</translation>
    </message>
    <message>
        <source>no uncertainties are stated: u_cal is 0 until you state it</source>
        <translation>no se indican incertidumbres: u_cal es 0 hasta que la indique</translation>
    </message>
    <message>
        <source>u_cal is the largest of the stated standard uncertainties: %1</source>
        <translation>u_cal es la mayor de las incertidumbres típicas indicadas: %1</translation>
    </message>
    <message>
        <source>u_cal as stated: %1</source>
        <translation>u_cal según lo indicado: %1</translation>
    </message>
    <message>
        <source>%1 without a stated one</source>
        <translation>%1 sin incertidumbre indicada</translation>
    </message>
    <message>
        <source>the uncertainty of each point by itself, and correlations: only up to %1 have an analysis of their own</source>
        <translation>la incertidumbre de cada punto por sí mismo, y las correlaciones: solo hasta %1 tienen un análisis propio</translation>
    </message>
    <message>
        <source> and 1 correlation coefficient</source>
        <translation> y 1 coeficiente de correlación</translation>
    </message>
    <message>
        <source> and %1 correlation coefficients</source>
        <translation> y %1 coeficientes de correlación</translation>
    </message>
    <message>
        <source>analysis &apos;Points as stated&apos;: every coordinate with its own uncertainty%1</source>
        <translation>análisis &apos;Points as stated&apos;: cada coordenada con su propia incertidumbre%1</translation>
    </message>
    <message>
        <source>the file has no points</source>
        <translation>el archivo no tiene puntos</translation>
    </message>
    <message>
        <source>the file has no line &apos;Frame,Time (Seconds),...&apos; with data below</source>
        <translation>el archivo no tiene ninguna línea &apos;Frame,Time (Seconds),...&apos; con datos debajo</translation>
    </message>
    <message>
        <source>the file must begin with &apos;Format Version,&apos;</source>
        <translation>el archivo debe empezar con &apos;Format Version,&apos;</translation>
    </message>
    <message>
        <source>rotations of type %1 are not read: export the take with quaternions</source>
        <translation>no se leen rotaciones de tipo %1: exporte la toma con cuaterniones</translation>
    </message>
    <message>
        <source>the file does not state its unit of lengths; state it</source>
        <translation>el archivo no indica su unidad de longitud; indíquela</translation>
    </message>
    <message>
        <source>take %1, lengths in %2, coordinate space %3</source>
        <translation>toma %1, longitudes en %2, espacio de coordenadas %3</translation>
    </message>
    <message>
        <source>%1 columns of markers</source>
        <translation>%1 columnas de marcadores</translation>
    </message>
    <message>
        <source>more than %1 rigid bodies are not read</source>
        <translation>no se leen más de %1 cuerpos rígidos</translation>
    </message>
    <message>
        <source>rigid body %1: columns of its rotation (X, Y, Z, W) or position (X, Y, Z) are missing</source>
        <translation>cuerpo rígido %1: faltan columnas de su rotación (X, Y, Z, W) o posición (X, Y, Z)</translation>
    </message>
    <message>
        <source>the take has no rigid body</source>
        <translation>la toma no tiene ningún cuerpo rígido</translation>
    </message>
    <message>
        <source>%1 is not a number of a pose</source>
        <translation>%1 no es un número de una pose</translation>
    </message>
    <message>
        <source>the quaternion of %1 has not the length 1</source>
        <translation>el cuaternión de %1 no tiene longitud 1</translation>
    </message>
    <message>
        <source>the angles about z and x of %1 are not determined: turned by 90 degrees about y. Turn the axes of the body in Motive by 90 degrees</source>
        <translation>los ángulos en torno a z y x de %1 no están determinados: girado 90 grados en torno a y. Gire en Motive los ejes del cuerpo 90 grados</translation>
    </message>
    <message>
        <source>%1: %2 frames in which it was not seen</source>
        <translation>%1: %2 fotogramas en los que no se vio</translation>
    </message>
    <message>
        <source>rigid body %1: at least two frames in which it is seen are needed</source>
        <translation>cuerpo rígido %1: hacen falta al menos dos fotogramas en los que se vea</translation>
    </message>
    <message>
        <source>rigid body %1: mean pose of %2 frames, Type A with covariance; the body must not have moved, and the frames are taken as independent</source>
        <translation>cuerpo rígido %1: pose media de %2 fotogramas, Tipo A con covarianza; el cuerpo no debe haberse movido, y los fotogramas se toman como independientes</translation>
    </message>
    <message>
        <source>unit &quot;%1&quot;: write it without parentheses</source>
        <translation>unidad &quot;%1&quot;: escríbala sin paréntesis</translation>
    </message>
    <message>
        <source>the exponents are too large</source>
        <translation>los exponentes son demasiado grandes</translation>
    </message>
    <message>
        <source>%1; state the columns: %2</source>
        <translation>%1; indique las columnas: %2</translation>
    </message>
    <message>
        <source>there is no column %1%2</source>
        <translation>no hay ninguna columna %1%2</translation>
    </message>
    <message>
        <source>more than %1 points: divide the file</source>
        <translation>más de %1 puntos: divida el archivo</translation>
    </message>
    <message>
        <source> is empty</source>
        <translation> está vacío</translation>
    </message>
    <message>
        <source> is not a number</source>
        <translation> no es un número</translation>
    </message>
    <message>
        <source>: an uncertainty must not be negative</source>
        <translation>: una incertidumbre no debe ser negativa</translation>
    </message>
    <message>
        <source> is too large</source>
        <translation> es demasiado grande</translation>
    </message>
    <message>
        <source>the line has %1 columns instead of %2; put names that contain blanks into quotes</source>
        <translation>la línea tiene %1 columnas en lugar de %2; ponga entre comillas los nombres que contienen espacios</translation>
    </message>
    <message>
        <source>what stands behind column %1</source>
        <translation>lo que hay después de la columna %1</translation>
    </message>
    <message>
        <source>lengths are taken as mm: the file does not say its unit</source>
        <translation>las longitudes se toman en mm: el archivo no indica su unidad</translation>
    </message>
    <message>
        <source>column %1%2</source>
        <translation>columna %1%2</translation>
    </message>
    <message>
        <source>%1 lines above the headers</source>
        <translation>%1 líneas encima de los encabezados</translation>
    </message>
    <message>
        <source>%1 lines of comment</source>
        <translation>%1 líneas de comentario</translation>
    </message>
    <message>
        <source>the table has no line of headers; state the columns: %1</source>
        <translation>la tabla no tiene línea de encabezados; indique las columnas: %1</translation>
    </message>
    <message>
        <source>its columns may mean several things (names that are numbers, offsets, weights, tolerances, notes); state the columns: %1</source>
        <translation>sus columnas pueden significar varias cosas (nombres que son números, desplazamientos, pesos, tolerancias, notas); indique las columnas: %1</translation>
    </message>
    <message>
        <source>six numbers may be X Y Z Ux Uy Uz, but also X Y Z with weights, a vector or the angles of a frame: name the reader if they are uncertainties, or state the columns: %1</source>
        <translation>seis números pueden ser X Y Z Ux Uy Uz, pero también X Y Z con pesos, un vector o los ángulos de un sistema: nombre el lector si son incertidumbres, o indique las columnas: %1</translation>
    </message>
    <message>
        <source>read as %1 (%2)</source>
        <translation>se lee como %1 (%2)</translation>
    </message>
    <message>
        <source>%1: the file states no unit, %2 is taken</source>
        <translation>%1: el archivo no indica unidad, se toma %2</translation>
    </message>
    <message>
        <source>Analysis &quot;%1&quot; (%2)</source>
        <translation>Análisis &quot;%1&quot; (%2)</translation>
    </message>
    <message>
        <source>not taken over</source>
        <translation>no se toma</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>línea %1: %2</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>y %1 más</translation>
    </message>
    <message>
        <source>and %1 more rows</source>
        <translation>y %1 filas más</translation>
    </message>
    <message>
        <source>no reader recognises the file; name the one to read it with</source>
        <translation>ningún lector reconoce el archivo; nombre el lector con el que leerlo</translation>
    </message>
    <message>
        <source>several readers recognise the file: %1; name one of them</source>
        <translation>varios lectores reconocen el archivo: %1; nombre uno de ellos</translation>
    </message>
    <message>
        <source>a column cannot be %1; there are %2</source>
        <translation>una columna no puede ser %1; las posibles son %2</translation>
    </message>
    <message>
        <source>the columns %1 and %2 mean the same; state the columns</source>
        <translation>las columnas %1 y %2 significan lo mismo; indique las columnas</translation>
    </message>
    <message>
        <source>a budget needs columns for the quantity or its name, for an uncertainty (u, U or limits) and one more; state the columns</source>
        <translation>un balance necesita columnas para la magnitud o su nombre, para una incertidumbre (u, U o límites) y una más; indique las columnas</translation>
    </message>
    <message>
        <source>the distribution %1 is not known; there are normal, rectangular, triangular, U-shaped</source>
        <translation>no se conoce la distribución %1; hay normal, rectangular, triangular, en forma de U</translation>
    </message>
    <message>
        <source>the divisor must be greater than 0</source>
        <translation>el divisor debe ser mayor que 0</translation>
    </message>
    <message>
        <source>an uncertainty must not be negative</source>
        <translation>una incertidumbre no debe ser negativa</translation>
    </message>
    <message>
        <source>no uncertainty is stated</source>
        <translation>no se indica ninguna incertidumbre</translation>
    </message>
    <message>
        <source>neither divisor, k nor distribution says what the uncertainty %1 is</source>
        <translation>ni el divisor, ni k, ni la distribución dicen qué es la incertidumbre %1</translation>
    </message>
    <message>
        <source>a normal distribution needs a divisor or k for the uncertainty %1</source>
        <translation>una distribución normal necesita un divisor o k para la incertidumbre %1</translation>
    </message>
    <message>
        <source>no row has a number in the stated columns</source>
        <translation>ninguna fila tiene un número en las columnas indicadas</translation>
    </message>
    <message>
        <source>there is no sheet %1 with cells; there are %2</source>
        <translation>no hay ninguna hoja %1 con celdas; hay %2</translation>
    </message>
    <message>
        <source>the workbook has several sheets, %1: name the sheet whose columns are stated</source>
        <translation>el libro tiene varias hojas, %1: nombre la hoja cuyas columnas se indican</translation>
    </message>
    <message>
        <source>no row of headers of a budget was found; state the columns (quantity, value, unit, U, divisor ...)</source>
        <translation>no se encontró ninguna fila de encabezados de un balance; indique las columnas (magnitud, valor, unidad, U, divisor ...)</translation>
    </message>
    <message>
        <source>several sheets have a budget: %1; name one of them</source>
        <translation>varias hojas tienen un balance: %1; nombre una de ellas</translation>
    </message>
    <message>
        <source>a file that it includes: %1</source>
        <translation>un archivo que incluye: %1</translation>
    </message>
    <message>
        <source>the code of a point is expected, a digit</source>
        <translation>se espera el código de un punto, una cifra</translation>
    </message>
    <message>
        <source>a point that is not to be used: %1</source>
        <translation>un punto que no debe usarse: %1</translation>
    </message>
    <message>
        <source>code, name, x, y, z, three standard deviations and two deflections of the vertical are expected, there are %1 columns</source>
        <translation>se esperan código, nombre, x, y, z, tres desviaciones típicas y dos desviaciones de la vertical, hay %1 columnas</translation>
    </message>
    <message>
        <source>none of their coordinates</source>
        <translation>ninguna de sus coordenadas</translation>
    </message>
    <message>
        <source>%1 only</source>
        <translation>solo %1</translation>
    </message>
    <message>
        <source>standard deviations of %1 points of code %2: it constrains %3</source>
        <translation>desviaciones típicas de %1 puntos de código %2: restringe %3</translation>
    </message>
    <message>
        <source>deflections of the vertical of %1 points</source>
        <translation>desviaciones de la vertical de %1 puntos</translation>
    </message>
    <message>
        <source>%1 points are not constrained: their coordinates are approximate ones for the adjustment</source>
        <translation>%1 puntos no están restringidos: sus coordenadas son aproximadas, para la compensación</translation>
    </message>
    <message>
        <source>%1 comments</source>
        <translation>%1 comentarios</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 no es un número</translation>
    </message>
    <message>
        <source>%1: the constraint of %2, which is switched off</source>
        <translation>%1: la restricción de %2, que está desactivada</translation>
    </message>
    <message>
        <source>coordinates in metres</source>
        <translation>coordenadas en metros</translation>
    </message>
    <message>
        <source>the stated unit of lengths: coordinates of Comp3D are in metres</source>
        <translation>la unidad de longitud indicada: las coordenadas de Comp3D están en metros</translation>
    </message>
    <message>
        <source>the code of an observation is expected, a whole number</source>
        <translation>se espera el código de una observación, un número entero</translation>
    </message>
    <message>
        <source>an observation of code %1</source>
        <translation>una observación de código %1</translation>
    </message>
    <message>
        <source>code, two points, value, one or two standard deviations and two heights are expected, there are %1 columns</source>
        <translation>se esperan código, dos puntos, valor, una o dos desviaciones típicas y dos alturas, hay %1 columnas</translation>
    </message>
    <message>
        <source>%1 %2: it is switched off</source>
        <translation>%1 %2: está desactivada</translation>
    </message>
    <message>
        <source>the file has no observation that is taken</source>
        <translation>el archivo no tiene ninguna observación que se tome</translation>
    </message>
    <message>
        <source>%1 observations, lengths in metres; each is its own result: write the equations of what you measure with them</source>
        <translation>%1 observaciones, longitudes en metros; cada una es su propio resultado: escriba con ellas las ecuaciones de lo que mide</translation>
    </message>
    <message>
        <source>the unit of angles must be one of an angle: gon, deg, rad</source>
        <translation>la unidad de los ángulos debe ser de ángulo: gon, deg, rad</translation>
    </message>
    <message>
        <source>%1 %2: the part of its standard deviation that depends on the distance</source>
        <translation>%1 %2: la parte de su desviación típica que depende de la distancia</translation>
    </message>
    <message>
        <source>%1: it is switched off</source>
        <translation>%1: está desactivado</translation>
    </message>
    <message>
        <source>a variance of its covariance matrix is negative</source>
        <translation>una varianza de su matriz de covarianza es negativa</translation>
    </message>
    <message>
        <source>its covariance matrix is not symmetric</source>
        <translation>su matriz de covarianza no es simétrica</translation>
    </message>
    <message>
        <source>its matrix is no covariance matrix: a variance of some combination is negative</source>
        <translation>su matriz no es de covarianza: la varianza de alguna combinación es negativa</translation>
    </message>
    <message>
        <source>no Digital Calibration Certificate: its root is &lt;%1&gt;</source>
        <translation>no es un certificado digital de calibración: su raíz es &lt;%1&gt;</translation>
    </message>
    <message>
        <source>the certificate has no results with numbers</source>
        <translation>el certificado no tiene resultados con números</translation>
    </message>
    <message>
        <source>schema version %1</source>
        <translation>versión de esquema %1</translation>
    </message>
    <message>
        <source>what this version of the schema has beyond version 3</source>
        <translation>lo que esta versión del esquema tiene más allá de la versión 3</translation>
    </message>
    <message>
        <source>the stated unit of lengths: a certificate states its units</source>
        <translation>la unidad de longitud indicada: un certificado indica sus unidades</translation>
    </message>
    <message>
        <source>%1: &lt;measurementMetaData&gt;</source>
        <translation>%1: &lt;measurementMetaData&gt;</translation>
    </message>
    <message>
        <source>a quantity: more than %1 values</source>
        <translation>una magnitud: más de %1 valores</translation>
    </message>
    <message>
        <source>%1 as a length standard: more than %2</source>
        <translation>%1 como patrón de longitud: más de %2</translation>
    </message>
    <message>
        <source>the signature: it is not verified</source>
        <translation>la firma: no se verifica</translation>
    </message>
    <message>
        <source>%1 values, %2 of them with an uncertainty</source>
        <translation>%1 valores, %2 de ellos con incertidumbre</translation>
    </message>
    <message>
        <source>%1 values, %2 of them with an uncertainty, with covariances</source>
        <translation>%1 valores, %2 de ellos con incertidumbre, con covarianzas</translation>
    </message>
    <message>
        <source>length standard %1: delete it where the length is no standard</source>
        <translation>patrón de longitud %1: bórrelo si la longitud no es un patrón</translation>
    </message>
    <message>
        <source>a value as &lt;%1&gt;</source>
        <translation>un valor como &lt;%1&gt;</translation>
    </message>
    <message>
        <source>its relative uncertainty</source>
        <translation>su incertidumbre relativa</translation>
    </message>
    <message>
        <source>the same in other units (%1 is taken)</source>
        <translation>lo mismo en otras unidades (se toma %1)</translation>
    </message>
    <message>
        <source>its lists have different lengths than the %1 values</source>
        <translation>sus listas tienen longitudes distintas de los %1 valores</translation>
    </message>
    <message>
        <source>its covariance matrix: %1</source>
        <translation>su matriz de covarianza: %1</translation>
    </message>
    <message>
        <source>its covariance matrix has not %1 x %2 elements</source>
        <translation>su matriz de covarianza no tiene %1 x %2 elementos</translation>
    </message>
    <message>
        <source>p must be between 0 and 1</source>
        <translation>p debe estar entre 0 y 1</translation>
    </message>
    <message>
        <source>k must be greater than 0</source>
        <translation>k debe ser mayor que 0</translation>
    </message>
    <message>
        <source>its uncertainty is negative</source>
        <translation>su incertidumbre es negativa</translation>
    </message>
    <message>
        <source>it does not begin with \</source>
        <translation>no empieza por \</translation>
    </message>
    <message>
        <source>a brace is not closed</source>
        <translation>una llave no está cerrada</translation>
    </message>
    <message>
        <source>its power &apos;%1&apos; is no small integer</source>
        <translation>su potencia &apos;%1&apos; no es un entero pequeño</translation>
    </message>
    <message>
        <source>&apos;\%1&apos; is not known</source>
        <translation>no se conoce &apos;\%1&apos;</translation>
    </message>
    <message>
        <source>it ends too early</source>
        <translation>termina demasiado pronto</translation>
    </message>
    <message>
        <source>the unit %1: %2</source>
        <translation>la unidad %1: %2</translation>
    </message>
    <message>
        <source>sheet %1, columns: %2</source>
        <translation>hoja %1, columnas: %2</translation>
    </message>
    <message>
        <source>%1 is no number</source>
        <translation>%1 no es un número</translation>
    </message>
    <message>
        <source>its unit differs from that of the other uncertainty of the row</source>
        <translation>su unidad difiere de la de la otra incertidumbre de la fila</translation>
    </message>
    <message>
        <source>%1 is no divisor</source>
        <translation>%1 no es un divisor</translation>
    </message>
    <message>
        <source>degrees of freedom must be greater than 0</source>
        <translation>los grados de libertad deben ser mayores que 0</translation>
    </message>
    <message>
        <source>row %1: %2</source>
        <translation>fila %1: %2</translation>
    </message>
    <message>
        <source>the contribution %1: c and u give %2</source>
        <translation>la contribución %1: c y u dan %2</translation>
    </message>
    <message>
        <source>the contribution does not follow from c and u in any unit; state the unit behind the coefficient (&apos;-575 nm/K&apos;)</source>
        <translation>la contribución no se sigue de c y u en ninguna unidad; indique la unidad tras el coeficiente (&apos;-575 nm/K&apos;)</translation>
    </message>
    <message>
        <source>its unit makes no coefficient of the result</source>
        <translation>su unidad no da un coeficiente del resultado</translation>
    </message>
    <message>
        <source>its unit may be %1 or %2: state it behind the coefficient</source>
        <translation>su unidad puede ser %1 o %2: indíquela tras el coeficiente</translation>
    </message>
    <message>
        <source>what stands below the budget, to row %1</source>
        <translation>lo que está debajo del balance, hasta la fila %1</translation>
    </message>
    <message>
        <source>there is no quantity with an uncertainty below</source>
        <translation>debajo no hay ninguna magnitud con incertidumbre</translation>
    </message>
    <message>
        <source>row without a quantity</source>
        <translation>fila sin magnitud</translation>
    </message>
    <message>
        <source>row %1 without figures</source>
        <translation>fila %1 sin cifras</translation>
    </message>
    <message>
        <source>the quantity has no name</source>
        <translation>la magnitud no tiene nombre</translation>
    </message>
    <message>
        <source>row %1: computed anew</source>
        <translation>fila %1: calculada de nuevo</translation>
    </message>
    <message>
        <source>the unit of the result is not stated: give the result a row of its own, put the unit behind the head of the contributions, or state it as that of &apos;result&apos;</source>
        <translation>no se indica la unidad del resultado: dé al resultado una fila propia, ponga la unidad tras el encabezado de las contribuciones, o indíquela como la de &apos;result&apos;</translation>
    </message>
    <message>
        <source>model: %1; the sheet has sensitivity coefficients only, write your equation instead where you have it</source>
        <translation>modelo: %1; la hoja solo tiene coeficientes de sensibilidad, escriba en su lugar su ecuación donde la tenga</translation>
    </message>
    <message>
        <source>%1 quantities</source>
        <translation>%1 magnitudes</translation>
    </message>
    <message>
        <source>sheet %1</source>
        <translation>hoja %1</translation>
    </message>
    <message>
        <source>no input quantity has an uncertainty, so that U is 0 everywhere: state the uncertainties of what the analysis uses</source>
        <translation>ninguna magnitud de entrada tiene incertidumbre, de modo que U es 0 en todas partes: indique las incertidumbres de lo que usa el análisis</translation>
    </message>
    <message>
        <source>%1; the run is to end at %2 trials and will not be stable then. Choose a larger tolerance or fewer digits</source>
        <translation>%1; la ejecución debe terminar a las %2 pruebas y no será estable entonces. Elija una tolerancia mayor o menos cifras</translation>
    </message>
    <message>
        <source>it cannot be read</source>
        <translation>no se puede leer</translation>
    </message>
    <message>
        <source>%1 has no analysis &quot;%2&quot;</source>
        <translation>%1 no tiene ningún análisis &quot;%2&quot;</translation>
    </message>
    <message>
        <source>%1 refers to other assets of the project and cannot be kept alone</source>
        <translation>%1 hace referencia a otros recursos del proyecto y no se puede guardar solo</translation>
    </message>
    <message>
        <source>%1 has errors; open it and repair it before adding to it</source>
        <translation>%1 tiene errores; ábralo y corríjalo antes de añadirle algo</translation>
    </message>
    <message>
        <source>asset %1: %2</source>
        <translation>recurso %1: %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; refers to the analysis &apos;%2&apos;</source>
        <translation>&apos;%1&apos; remite al análisis &apos;%2&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; refers to the asset &apos;%2&apos;</source>
        <translation>&apos;%1&apos; remite al recurso &apos;%2&apos;</translation>
    </message>
    <message>
        <source>%1, which does not offer %2</source>
        <translation>%1, que no ofrece %2</translation>
    </message>
    <message>
        <source>it cannot be made</source>
        <translation>no se puede formar</translation>
    </message>
    <message>
        <source>the analysis &apos;%1&apos; has errors of its own: %2</source>
        <translation>el análisis &apos;%1&apos; tiene errores propios: %2</translation>
    </message>
    <message>
        <source>%1, which has errors of its own</source>
        <translation>%1, que tiene errores propios</translation>
    </message>
    <message>
        <source>%1, which is of the kind &apos;%2&apos; and does not offer %3</source>
        <translation>%1, que es de la clase &apos;%2&apos; y no ofrece %3</translation>
    </message>
    <message>
        <source>%1, which refers back to this one: %2%3</source>
        <translation>%1, que remite de nuevo a este: %2%3</translation>
    </message>
    <message>
        <source>%1: only analyses take something from analyses</source>
        <translation>%1: solo los análisis toman algo de otros análisis</translation>
    </message>
    <message>
        <source>%1, which does not exist%2</source>
        <translation>%1, que no existe%2</translation>
    </message>
    <message>
        <source>the values given lead to a %1</source>
        <translation>los valores dados llevan a: %1</translation>
    </message>
    <message>
        <source>the memory of this machine does not suffice</source>
        <translation>la memoria de esta máquina no basta</translation>
    </message>
    <message>
        <source>a defect of the program was met (%1): please report it with the project</source>
        <translation>se topó con un defecto del programa (%1): comuníquelo con el proyecto</translation>
    </message>
    <message>
        <source>%1: the part is damaged or no part at all: delete it and make it anew</source>
        <translation>%1: la parte está dañada o no es una parte: bórrela y hágala de nuevo</translation>
    </message>
    <message>
        <source>%1: the part was made %2 %3, this is %4: the bits of its results would not be those of one run</source>
        <translation>%1: la parte se hizo con %2 %3 y esto es %4: los bits de sus resultados no serían los de una sola ejecución</translation>
    </message>
    <message>
        <source>%1: the part would have %2 MB, more than %3: divide the run into more parts</source>
        <translation>%1: la parte tendría %2 MB, más de %3: divida la ejecución en más partes</translation>
    </message>
    <message>
        <source>%1: the part is of &quot;%2&quot;, which is not evaluated here: it is of another project</source>
        <translation>%1: la parte es de &quot;%2&quot;, que no se evalúa aquí: es de otro proyecto</translation>
    </message>
    <message>
        <source>%1: the part is of &quot;%2&quot; in another project or another state of it (fingerprint %3, here %4): make it anew</source>
        <translation>%1: la parte es de &quot;%2&quot; en otro proyecto o en otro estado de él (huella %3, aquí %4): hágala de nuevo</translation>
    </message>
    <message>
        <source>the model cannot be made</source>
        <translation>no se puede formar el modelo</translation>
    </message>
    <message>
        <source>there is no component &apos;%1&apos; here</source>
        <translation>aquí no hay ninguna componente &apos;%1&apos;</translation>
    </message>
    <message>
        <source>there is no input quantity &apos;%1&apos; here</source>
        <translation>aquí no hay ninguna magnitud de entrada &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the analysis has no study &apos;%1&apos;</source>
        <translation>el análisis no tiene ningún estudio &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the study was stopped</source>
        <translation>se detuvo el estudio</translation>
    </message>
    <message>
        <source>the analysis does not use the asset &apos;%1&apos;: varying it changes nothing</source>
        <translation>el análisis no usa el recurso &apos;%1&apos;: variarlo no cambia nada</translation>
    </message>
    <message>
        <source>the model shows no instruments: a least distance and boxes to keep out of mean nothing to it</source>
        <translation>el modelo no muestra instrumentos: una distancia mínima y las cajas que deben evitarse no significan nada para él</translation>
    </message>
    <message>
        <source>the model shows no lines of sight, so that no box can hide them</source>
        <translation>el modelo no muestra líneas de visión, así que ninguna caja puede ocultarlas</translation>
    </message>
    <message>
        <source>the analysis has no design &apos;%1&apos;</source>
        <translation>el análisis no tiene ningún diseño &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the variances are not a sum over what is reduced: some of it is correlated, or changes more than a component of uncertainty</source>
        <translation>las varianzas no son una suma sobre lo que se reduce: parte de ello está correlacionado o cambia más de una componente de incertidumbre</translation>
    </message>
    <message>
        <source>the analysis has no measurand that a design could look at</source>
        <translation>el análisis no tiene ningún mensurando que un diseño pueda mirar</translation>
    </message>
    <message>
        <source>without target uncertainties U is looked at relative to that of the present design, which has no result (%1): state requirements</source>
        <translation>sin incertidumbres objetivo, U se mira respecto a la del diseño actual, que no tiene resultado (%1): indique requisitos</translation>
    </message>
    <message>
        <source>U of &apos;%1&apos; is zero now: choose the outputs to look at</source>
        <translation>U de &apos;%1&apos; es ahora cero: elija las salidas que se miran</translation>
    </message>
    <message>
        <source>the cheapest reductions need target uncertainties: state requirements</source>
        <translation>las reducciones más baratas necesitan incertidumbres objetivo: indique requisitos</translation>
    </message>
    <message>
        <source>the cheapest rows need target uncertainties: state requirements</source>
        <translation>las filas más baratas necesitan incertidumbres objetivo: indique requisitos</translation>
    </message>
    <message>
        <source>the design was stopped</source>
        <translation>se detuvo el diseño</translation>
    </message>
    <message>
        <source>the set-up</source>
        <translation>la configuración</translation>
    </message>
    <message>
        <source>the component &apos;%1&apos; is not of one input quantity alone: change it where it comes from (%2)</source>
        <translation>la componente &apos;%1&apos; no es de una sola magnitud de entrada: cámbiela donde se origina (%2)</translation>
    </message>
    <message>
        <source>Distribution of %1.</source>
        <translation>Distribución de %1.</translation>
    </message>
    <message>
        <source>Quantiles of %1, the least normal, against those of a normal distribution.</source>
        <translation>Cuantiles de %1, la menos normal, frente a los de una distribución normal.</translation>
    </message>
    <message>
        <source>Standard uncertainty of %1 against the number of trials.</source>
        <translation>Incertidumbre típica de %1 frente al número de pruebas.</translation>
    </message>
    <message>
        <source>%1: uncertainty ellipsoids at a coverage probability of %2, magnified as the picture states.</source>
        <translation>%1: elipsoides de incertidumbre con una probabilidad de cobertura de %2, ampliados como indica la imagen.</translation>
    </message>
    <message>
        <source>Correlation coefficients of components</source>
        <translation>Coeficientes de correlación de las componentes</translation>
    </message>
    <message>
        <source>Component</source>
        <translation>Componente</translation>
    </message>
    <message>
        <source>Notes on input quantities</source>
        <translation>Notas sobre magnitudes de entrada</translation>
    </message>
    <message>
        <source>Input quantities and the origin of their uncertainties</source>
        <translation>Magnitudes de entrada y origen de sus incertidumbres</translation>
    </message>
    <message>
        <source>%1 input quantities; many with equal components share a row. The CSV table of inputs lists every one with its estimate.</source>
        <translation>%1 magnitudes de entrada; muchas con componentes iguales comparten una fila. La tabla CSV de entradas las contiene todas con su estimación.</translation>
    </message>
    <message>
        <source>These input quantities are results of other analyses. All are evaluated together as one model, in every trial, so that the budget goes down to the components of the analyses that they come from; a component that reaches the result on several ways is one component.</source>
        <translation>Estas magnitudes de entrada son resultados de otros análisis. Todos se evalúan juntos como un solo modelo, en cada prueba, de modo que el balance llega hasta las componentes de los análisis de los que proceden; una componente que llega al resultado por varios caminos es una sola componente.</translation>
    </message>
    <message>
        <source>Linearised: the analysis that the value comes from is replaced by its law of propagation about its estimates. That is exact to first order; its non-linearity is left out of Monte Carlo.</source>
        <translation>Linealizado: el análisis del que procede el valor se sustituye por su ley de propagación en torno a sus estimaciones. Es exacto a primer orden; su no linealidad no entra en Monte Carlo.</translation>
    </message>
    <message>
        <source>Where the inputs come from</source>
        <translation>De dónde proceden las entradas</translation>
    </message>
    <message>
        <source>Input quantities taken from other analyses</source>
        <translation>Magnitudes de entrada tomadas de otros análisis</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>Análisis</translation>
    </message>
    <message>
        <source>Its result</source>
        <translation>Su resultado</translation>
    </message>
    <message>
        <source>%1, linearised</source>
        <translation>%1, linealizado</translation>
    </message>
    <message>
        <source>The trials are Sobol points with a random digital shift in each batch; standard errors are from the scatter of the batches.</source>
        <translation>Las pruebas son puntos de Sobol con un desplazamiento digital aleatorio en cada lote; los errores típicos proceden de la dispersión de los lotes.</translation>
    </message>
    <message>
        <source>Mean, standard uncertainty, symmetric interval and covariance were found with the linear part of each output as control variate: its distribution is known exactly, and the trials tell how the output differs from it. Shortest intervals, histograms and probabilities of conformance are those of the trials.</source>
        <translation>Media, incertidumbre típica, intervalo simétrico y covarianza se hallaron con la parte lineal de cada magnitud de salida como variable de control: su distribución se conoce exactamente, y las pruebas dicen en qué difiere de ella la salida. Los intervalos más cortos, los histogramas y las probabilidades de conformidad son los de las pruebas.</translation>
    </message>
    <message>
        <source>At the interval ends each trial is worth %1 plain ones or more.</source>
        <translation>En los extremos del intervalo cada prueba vale por %1 simples o más.</translation>
    </message>
    <message>
        <source>The adaptive procedure reached its largest number of trials: the results have not stabilised to the numerical tolerance.</source>
        <translation>El procedimiento adaptativo alcanzó su número máximo de pruebas: los resultados no se han estabilizado dentro de la tolerancia numérica.</translation>
    </message>
    <message>
        <source>Coverage intervals were read from finely divided cells, not from ordered trials: there were more trials than memory allows to order.</source>
        <translation>Los intervalos de cobertura se leyeron de celdas finamente divididas, no de pruebas ordenadas: había más pruebas de las que la memoria permite ordenar.</translation>
    </message>
    <message>
        <source>law of propagation</source>
        <translation>ley de propagación</translation>
    </message>
    <message>
        <source>adaptive</source>
        <translation>adaptativo</translation>
    </message>
    <message>
        <source>%1, Sobol points</source>
        <translation>%1, puntos de Sobol</translation>
    </message>
    <message>
        <source>%1, control variate</source>
        <translation>%1, variable de control</translation>
    </message>
    <message>
        <source>Runs that gave these results</source>
        <translation>Ejecuciones que dieron estos resultados</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Fallido</translation>
    </message>
    <message>
        <source>Fingerprint</source>
        <translation>Huella</translation>
    </message>
    <message>
        <source>The same project, seed and version give the same numbers on any number of threads. The fingerprint covers everything that influences the numbers of an analysis.</source>
        <translation>El mismo proyecto, semilla y versión dan los mismos números con cualquier número de hilos. La huella abarca todo lo que influye en los números de un análisis.</translation>
    </message>
    <message>
        <source>Factors by which the standard uncertainties are to be multiplied so that all measurands of a group lie in the region together with a probability of %1 (JCGM 102 6.5 and 7.7).</source>
        <translation>Factores por los que deben multiplicarse las incertidumbres típicas para que todos los mensurandos de un grupo estén a la vez en la región con una probabilidad de %1 (JCGM 102 6.5 y 7.7).</translation>
    </message>
    <message>
        <source>Factors of the coverage regions</source>
        <translation>Factores de las regiones de cobertura</translation>
    </message>
    <message>
        <source>No ellipsoid is given where the covariance matrix of the group is singular.</source>
        <translation>No se da elipsoide donde la matriz de covarianza del grupo es singular.</translation>
    </message>
    <message>
        <source>Target uncertainties</source>
        <translation>Incertidumbres objetivo</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
    <message>
        <source>With the figure put in, U by the law of propagation is the target; k follows the effective degrees of freedom.</source>
        <translation>Con la cifra puesta, U por la ley de propagación es el objetivo; k sigue los grados efectivos de libertad.</translation>
    </message>
    <message>
        <source>With the figure put in, U by Monte Carlo is the target; found with %1 trials of the same draws.</source>
        <translation>Con la cifra puesta, U por Monte Carlo es el objetivo; hallada con %1 pruebas de las mismas extracciones.</translation>
    </message>
    <message>
        <source>No component suffices alone: all standard uncertainties multiplied by %1 do.</source>
        <translation>Ninguna componente basta por sí sola: todas las incertidumbres típicas multiplicadas por %1 sí.</translation>
    </message>
    <message>
        <source>What one component alone must be reduced to for U(%1) to meet its target</source>
        <translation>A qué debe reducirse una sola componente para que U(%1) cumpla su objetivo</translation>
    </message>
    <message>
        <source>needed</source>
        <translation>necesario</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Comentario</translation>
    </message>
    <message>
        <source>not enough by itself, even if it vanished</source>
        <translation>no basta por sí sola, aunque desapareciera</translation>
    </message>
    <message>
        <source>%1: specific consumer&apos;s risk %2 of this decision.</source>
        <translation>%1: riesgo específico del consumidor %2 de esta decisión.</translation>
    </message>
    <message>
        <source>%1: specific producer&apos;s risk %2 of this decision.</source>
        <translation>%1: riesgo específico del productor %2 de esta decisión.</translation>
    </message>
    <message>
        <source>%1: specific consumer&apos;s risk %2 of this decision; global risks of the rule for its prior: consumer&apos;s %3, producer&apos;s %4.</source>
        <translation>%1: riesgo específico del consumidor %2 de esta decisión; riesgos globales de la regla para su distribución a priori: consumidor %3, productor %4.</translation>
    </message>
    <message>
        <source>%1: specific producer&apos;s risk %2 of this decision; global risks of the rule for its prior: consumer&apos;s %3, producer&apos;s %4.</source>
        <translation>%1: riesgo específico del productor %2 de esta decisión; riesgos globales de la regla para su distribución a priori: consumidor %3, productor %4.</translation>
    </message>
    <message>
        <source>Conformity with tolerances</source>
        <translation>Conformidad con tolerancias</translation>
    </message>
    <message>
        <source>The requirements are not judged: %1.</source>
        <translation>Los requisitos no se juzgan: %1.</translation>
    </message>
    <message>
        <source>U of</source>
        <translation>U de</translation>
    </message>
    <message>
        <source>Coverage probability %1.</source>
        <translation>Probabilidad de cobertura %1.</translation>
    </message>
    <message>
        <source>Values from the law of propagation of uncertainty (JCGM 100).</source>
        <translation>Valores de la ley de propagación de la incertidumbre (JCGM 100).</translation>
    </message>
    <message>
        <source>Values from the propagation of distributions (JCGM 101) with %1 trials; the interval is probabilistically symmetric, the shortest one beside it. The effective degrees of freedom are those of the law of propagation.</source>
        <translation>Valores de la propagación de distribuciones (JCGM 101) con %1 pruebas; el intervalo es probabilísticamente simétrico, con el más corto al lado. Los grados efectivos de libertad son los de la ley de propagación.</translation>
    </message>
    <message>
        <source>Components with finite degrees of freedom are drawn from normal distributions, as was chosen: U and k leave these degrees of freedom out, unlike k of the law of propagation (JCGM 100 G.6.4).</source>
        <translation>Las componentes con grados de libertad finitos se extraen de distribuciones normales, como se eligió: U y k no tienen en cuenta esos grados de libertad, a diferencia de la k de la ley de propagación (JCGM 100 G.6.4).</translation>
    </message>
    <message>
        <source>This result does not represent the measurand: %1 trials, more than 1 %, have no value.</source>
        <translation>Este resultado no representa el mensurando: %1 pruebas, más del 1 %, no tienen valor.</translation>
    </message>
    <message>
        <source>Law of propagation with second-order terms</source>
        <translation>Ley de propagación con términos de segundo orden</translation>
    </message>
    <message>
        <source>JCGM 100 5.1.2, NOTE, for independent components with symmetric distributions. The shift, half the sum of the second derivatives times the variances, is what the mean of the measurand differs by from the value at the estimates; neither is part of the results above.</source>
        <translation>JCGM 100 5.1.2, NOTA, para componentes independientes con distribuciones simétricas. El desplazamiento, la mitad de la suma de las segundas derivadas por las varianzas, es lo que la media del mensurando difiere del valor en las estimaciones; ninguno de los dos forma parte de los resultados anteriores.</translation>
    </message>
    <message>
        <source>Measurands</source>
        <translation>Mensurandos</translation>
    </message>
    <message>
        <source>Intermediate quantities</source>
        <translation>Magnitudes intermedias</translation>
    </message>
    <message>
        <source>Read from %1.</source>
        <translation>Leído de %1.</translation>
    </message>
    <message>
        <source>The first %1 of %2 rows; the project file has them all.</source>
        <translation>Las primeras %1 de %2 filas; el archivo del proyecto las contiene todas.</translation>
    </message>
    <message>
        <source>Sobol indices of %1 in %</source>
        <translation>Índices de Sobol de %1 en %</translation>
    </message>
    <message>
        <source>first order of the law of propagation</source>
        <translation>primer orden de la ley de propagación</translation>
    </message>
    <message>
        <source>standard error of S</source>
        <translation>error típico de S</translation>
    </message>
    <message>
        <source>S total</source>
        <translation>S total</translation>
    </message>
    <message>
        <source>standard error of S total</source>
        <translation>error típico de S total</translation>
    </message>
    <message>
        <source>%1 components with smaller indices are left out.</source>
        <translation>Se omiten %1 componentes con índices menores.</translation>
    </message>
    <message>
        <source>Sobol indices</source>
        <translation>Índices de Sobol</translation>
    </message>
    <message>
        <source>S is the share of the variance that a component causes by itself, S total the share with all its interactions with others: where both agree and the shares sum to 100 %, the measurement model is additive. Components that are correlated have indices together. By Monte Carlo with %1 pairs of trials.</source>
        <translation>S es la parte de la varianza que una componente causa por sí misma, S total la parte con todas sus interacciones con otras: donde ambas coinciden y las partes suman 100 %, el modelo de medición es aditivo. Las componentes correlacionadas tienen índices conjuntos. Por Monte Carlo con %1 pares de pruebas.</translation>
    </message>
    <message>
        <source>%1 from %2 to %3 (%4 values, logarithmic)</source>
        <translation>%1 de %2 a %3 (%4 valores, logarítmico)</translation>
    </message>
    <message>
        <source>%1 from %2 to %3 (%4 values)</source>
        <translation>%1 de %2 a %3 (%4 valores)</translation>
    </message>
    <message>
        <source>Evaluated at %1 grid points, with %2 trials at each.</source>
        <translation>Evaluado en %1 puntos de la malla, con %2 pruebas en cada uno.</translation>
    </message>
    <message>
        <source>Evaluated at %1 grid points, by the law of propagation of uncertainty.</source>
        <translation>Evaluado en %1 puntos de la malla, por la ley de propagación de la incertidumbre.</translation>
    </message>
    <message>
        <source>Varied: %1.</source>
        <translation>Se varía: %1.</translation>
    </message>
    <message>
        <source>The CSV table of the study has all output quantities.</source>
        <translation>La tabla CSV del estudio contiene todas las magnitudes de salida.</translation>
    </message>
    <message>
        <source>%1: best and worst grid points</source>
        <translation>%1: mejor y peor punto de la malla</translation>
    </message>
    <message>
        <source>least</source>
        <translation>menor</translation>
    </message>
    <message>
        <source>greatest</source>
        <translation>mayor</translation>
    </message>
    <message>
        <source>What is given for %1 of the grid points does not represent the measurand: more than 1 % of their trials have no value (see the CSV table).</source>
        <translation>Lo que se da para %1 de los puntos de la malla no representa el mensurando: más del 1 % de sus pruebas no tienen valor (véase la tabla CSV).</translation>
    </message>
    <message>
        <source>%1 grid points have no values:</source>
        <translation>%1 puntos de la malla no tienen valores:</translation>
    </message>
    <message>
        <source>others: see the CSV table of the study</source>
        <translation>otros: véase la tabla CSV del estudio</translation>
    </message>
    <message>
        <source>law of propagation of uncertainty</source>
        <translation>ley de propagación de la incertidumbre</translation>
    </message>
    <message>
        <source>adaptive Monte Carlo, %1 trials</source>
        <translation>Monte Carlo adaptativo, %1 pruebas</translation>
    </message>
    <message>
        <source>Monte Carlo, %1 trials</source>
        <translation>Monte Carlo, %1 pruebas</translation>
    </message>
    <message>
        <source>%1; %2; coverage probability %3</source>
        <translation>%1; %2; probabilidad de cobertura %3</translation>
    </message>
    <message>
        <source>k, intervals and the law of propagation are in the results of the analysis.</source>
        <translation>k, los intervalos y la ley de propagación están en los resultados del análisis.</translation>
    </message>
    <message>
        <source>Not evaluated: %1: %2.</source>
        <translation>No evaluado: %1: %2.</translation>
    </message>
    <message>
        <source>Study &quot;%1&quot; not evaluated: %2: %3.</source>
        <translation>Estudio &quot;%1&quot; no evaluado: %2: %3.</translation>
    </message>
    <message>
        <source>Expanded uncertainty U: %1</source>
        <translation>Incertidumbre expandida U: %1</translation>
    </message>
    <message>
        <source>Results: %1</source>
        <translation>Resultados: %1</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Número</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Autor</translation>
    </message>
    <message>
        <source>Evaluated with</source>
        <translation>Evaluado con</translation>
    </message>
    <message>
        <source>Not in this report</source>
        <translation>No está en este informe</translation>
    </message>
    <message>
        <source>Project fingerprint</source>
        <translation>Huella del proyecto</translation>
    </message>
    <message>
        <source>Evaluated with an earlier analysis: %1.</source>
        <translation>Evaluado con un análisis anterior: %1.</translation>
    </message>
    <message>
        <source>Budget of %1, %2</source>
        <translation>Balance de %1, %2</translation>
    </message>
    <message>
        <source>%1 further components</source>
        <translation>otras %1 componentes</translation>
    </message>
    <message>
        <source>combined (law of propagation)</source>
        <translation>combinada (ley de propagación)</translation>
    </message>
    <message>
        <source>%1 = %2, u_c = %3, effective degrees of freedom %4, k = %5, p = %6 (law of propagation).</source>
        <translation>%1 = %2, u_c = %3, grados efectivos de libertad %4, k = %5, p = %6 (ley de propagación).</translation>
    </message>
    <message>
        <source>Shares of the variance in % by %1, %2</source>
        <translation>Partes de la varianza en % por %1, %2</translation>
    </message>
    <message>
        <source>together</source>
        <translation>en conjunto</translation>
    </message>
    <message>
        <source>other</source>
        <translation>otros</translation>
    </message>
    <message>
        <source>Components by falling share of the variance; cᵢ in the unit of the measurand per unit of the component.</source>
        <translation>Componentes por parte decreciente de la varianza; cᵢ en la unidad del mensurando por unidad de la componente.</translation>
    </message>
    <message>
        <source>Contributions to the variance of %1.</source>
        <translation>Contribuciones a la varianza de %1.</translation>
    </message>
    <message>
        <source>Estimates and standard uncertainties by both methods</source>
        <translation>Estimaciones e incertidumbres típicas por ambos métodos</translation>
    </message>
    <message>
        <source>Where a distribution is too skewed, heavy-tailed or flat for k u, state its coverage interval.</source>
        <translation>Donde una distribución sea demasiado asimétrica, de colas pesadas o plana para k u, indique su intervalo de cobertura.</translation>
    </message>
    <message>
        <source>The expanded uncertainty U beside what remains of it when everything that a contributor brings in is kept at its estimate (an ideal one), and what that contributor gives alone, with the same coverage factor.</source>
        <translation>La incertidumbre expandida U junto a lo que queda de ella cuando todo lo que aporta una contribución se mantiene en su estimación (una ideal), y lo que da esa contribución por sí sola, con el mismo factor de cobertura.</translation>
    </message>
    <message>
        <source>By Monte Carlo with %1 trials.</source>
        <translation>Por Monte Carlo con %1 pruebas.</translation>
    </message>
    <message>
        <source>By the law of propagation.</source>
        <translation>Por la ley de propagación.</translation>
    </message>
    <message>
        <source>Without %1, %2 trials had no value.</source>
        <translation>Sin %1, %2 pruebas no tuvieron valor.</translation>
    </message>
    <message>
        <source>U without each contributor, and of it alone</source>
        <translation>U sin cada contribución, y de ella sola</translation>
    </message>
    <message>
        <source>without %1</source>
        <translation>sin %1</translation>
    </message>
    <message>
        <source>%1 alone</source>
        <translation>solo %1</translation>
    </message>
    <message>
        <source>Of two contributors, what remains without one is what the other gives alone.</source>
        <translation>De dos contribuciones, lo que queda sin una es lo que da la otra por sí sola.</translation>
    </message>
    <message>
        <source>Results by contributor</source>
        <translation>Resultados por contribución</translation>
    </message>
    <message>
        <source>Correlation coefficients, %1</source>
        <translation>Coeficientes de correlación, %1</translation>
    </message>
    <message>
        <source>Between groups, which share input quantities, the largest coefficient is %1.</source>
        <translation>Entre grupos que comparten magnitudes de entrada, el mayor coeficiente es %1.</translation>
    </message>
    <message>
        <source>Between groups, which share input quantities, the largest coefficient is %1, of %2 with %3.</source>
        <translation>Entre grupos que comparten magnitudes de entrada, el mayor coeficiente es %1, de %2 con %3.</translation>
    </message>
    <message>
        <source>The CSV table of correlations has all of them.</source>
        <translation>La tabla CSV de correlaciones las contiene todas.</translation>
    </message>
    <message>
        <source>Looked for: the smallest %1.</source>
        <translation>Se buscó: el menor %1.</translation>
    </message>
    <message>
        <source>Looked for: the cheapest reductions of uncertainty with which all targets are met.</source>
        <translation>Se buscaron: las reducciones de incertidumbre más baratas con las que se cumplen todos los objetivos.</translation>
    </message>
    <message>
        <source>Looked for: the cheapest rows with which all targets are met.</source>
        <translation>Se buscaron: las filas más baratas con las que se cumplen todos los objetivos.</translation>
    </message>
    <message>
        <source>Cost: %1.</source>
        <translation>Coste: %1.</translation>
    </message>
    <message>
        <source>Found: %1, before %2.</source>
        <translation>Hallado: %1, antes %2.</translation>
    </message>
    <message>
        <source>Found: %1.</source>
        <translation>Hallado: %1.</translation>
    </message>
    <message>
        <source>Nothing that was tried has a result.</source>
        <translation>Nada de lo que se probó tiene resultado.</translation>
    </message>
    <message>
        <source>%1 candidates were evaluated by the law of propagation of uncertainty, all that there are.</source>
        <translation>Se evaluaron %1 candidatos con la ley de propagación de la incertidumbre, todos los que hay.</translation>
    </message>
    <message>
        <source>%1 candidates were evaluated by the law of propagation of uncertainty.</source>
        <translation>Se evaluaron %1 candidatos con la ley de propagación de la incertidumbre.</translation>
    </message>
    <message>
        <source>Verified by Monte Carlo with %1 trials.</source>
        <translation>Verificado por Monte Carlo con %1 pruebas.</translation>
    </message>
    <message>
        <source>Not every target is met: what is given is the best that was found.</source>
        <translation>No se cumplen todos los objetivos: lo que se da es lo mejor que se halló.</translation>
    </message>
    <message>
        <source>%1: the way of the search to the best place, coloured by the objective.</source>
        <translation>%1: el camino de la búsqueda hasta el mejor lugar, coloreado según el objetivo.</translation>
    </message>
    <message>
        <source>%1: the candidates, coloured by what they gain; the larger ones are chosen.</source>
        <translation>%1: los candidatos, coloreados según lo que aportan; los mayores son los elegidos.</translation>
    </message>
    <message>
        <source>combined</source>
        <translation>combinada</translation>
    </message>
    <message>
        <source>%1, constant</source>
        <translation>%1, constante</translation>
    </message>
    <message>
        <source>%1 components, added arithmetically</source>
        <translation>%1 componentes, suma aritmética</translation>
    </message>
    <message>
        <source>%1 components, in quadrature</source>
        <translation>%1 componentes, suma cuadrática</translation>
    </message>
    <message>
        <source>Table %1. %2</source>
        <translation>Tabla %1. %2</translation>
    </message>
    <message>
        <source>Figure %1. %2</source>
        <translation>Figura %1. %2</translation>
    </message>
    <message>
        <source>Uncertainty report</source>
        <translation>Informe de incertidumbre</translation>
    </message>
    <message>
        <source>Report of an uncertainty evaluation</source>
        <translation>Informe de una evaluación de incertidumbre</translation>
    </message>
    <message>
        <source>Annex</source>
        <translation>Anexo</translation>
    </message>
    <message>
        <source>In the annex: %1.</source>
        <translation>En el anexo: %1.</translation>
    </message>
    <message>
        <source>In the annex, on request: %1.</source>
        <translation>En el anexo, si se pide: %1.</translation>
    </message>
    <message>
        <source>The first %1 of %2 rows; the annex has all of them.</source>
        <translation>Las primeras %1 de %2 filas; el anexo las contiene todas.</translation>
    </message>
    <message>
        <source>The first %1 of %2 rows; the CSV tables, and the annex on request, have all of them.</source>
        <translation>Las primeras %1 de %2 filas; las tablas CSV y, si se pide, el anexo las contienen todas.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables; the annex has the rest.</source>
        <translation>Se muestran %1 de %2 tablas; el anexo contiene el resto.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables; the CSV tables, and the annex on request, have the rest.</source>
        <translation>Se muestran %1 de %2 tablas; las tablas CSV y, si se pide, el anexo contienen el resto.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 charts; the annex has the rest.</source>
        <translation>Se muestran %1 de %2 gráficos; el anexo contiene el resto.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 charts; the CSV tables, and the annex on request, have the rest.</source>
        <translation>Se muestran %1 de %2 gráficos; las tablas CSV y, si se pide, el anexo contienen el resto.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables and %3 of %4 charts; the annex has the rest.</source>
        <translation>Se muestran %1 de %2 tablas y %3 de %4 gráficos; el anexo contiene el resto.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables and %3 of %4 charts; the CSV tables, and the annex on request, have the rest.</source>
        <translation>Se muestran %1 de %2 tablas y %3 de %4 gráficos; las tablas CSV y, si se pide, el anexo contienen el resto.</translation>
    </message>
    <message>
        <source>%1 (constant)</source>
        <translation>%1 (constante)</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Después</translation>
    </message>
    <message>
        <source>U is stated by different rules: before, %1 After, %2</source>
        <translation>U se indica por reglas distintas: antes, %1 Después, %2</translation>
    </message>
    <message>
        <source>%1 of %2 measurands are in both results; the budgets of %3 of them differ.</source>
        <translation>%1 de %2 mensurandos están en ambos resultados; difieren los balances de %3 de ellos.</translation>
    </message>
    <message>
        <source>Shown are the %1 whose standard uncertainty changes most, relative to what it was.</source>
        <translation>Se muestran las %1 cuya incertidumbre típica más cambia, respecto a lo que era.</translation>
    </message>
    <message>
        <source>Distribution of %1 before and after.</source>
        <translation>Distribución de %1 antes y después.</translation>
    </message>
    <message>
        <source>Comparison of uncertainty evaluations</source>
        <translation>Comparación de evaluaciones de incertidumbre</translation>
    </message>
    <message>
        <source>Only before: %1.</source>
        <translation>Solo antes: %1.</translation>
    </message>
    <message>
        <source>Only after: %1.</source>
        <translation>Solo después: %1.</translation>
    </message>
    <message>
        <source>this report</source>
        <translation>este informe</translation>
    </message>
    <message>
        <source>there are no results for the certificate to state</source>
        <translation>no hay resultados que el certificado pueda indicar</translation>
    </message>
    <message>
        <source>the standard uncertainty of %1 is not finite; a Digital Calibration Certificate has no place for that</source>
        <translation>la incertidumbre típica de %1 no es finita; un certificado digital de calibración no tiene lugar para ello</translation>
    </message>
    <message>
        <source>there is no robot to write: no analysis uses or finds one</source>
        <translation>no hay robot que escribir: ningún análisis usa o halla uno</translation>
    </message>
    <message>
        <source>the file is of one robot, and there are %1: choose an analysis that uses or finds the one to write (--analysis)</source>
        <translation>el archivo es de un robot y hay %1: elija un análisis que use o halle el que se ha de escribir (--analysis)</translation>
    </message>
    <message>
        <source>there are no points to write: no analysis has a result with coordinates x, y, z of a point</source>
        <translation>no hay puntos que escribir: ningún análisis tiene un resultado con coordenadas x, y, z de un punto</translation>
    </message>
    <message>
        <source>robot %1: the file is of six joints that turn (shoulder to wrist_3); write it as URDF</source>
        <translation>robot %1: el archivo es de seis articulaciones que giran (shoulder a wrist_3); escríbalo como URDF</translation>
    </message>
    <message>
        <source>there are no results to write</source>
        <translation>no hay resultados que escribir</translation>
    </message>
    <message>
        <source>the workbook cannot be made in the folder for temporary files</source>
        <translation>no se puede crear el libro en la carpeta de archivos temporales</translation>
    </message>
    <message>
        <source>the report carries no results to compare with (results.json)</source>
        <translation>el informe no lleva resultados con los que comparar (results.json)</translation>
    </message>
    <message>
        <source>what the report carries as results.json is none of Covaria</source>
        <translation>lo que el informe lleva como results.json no es de Covaria</translation>
    </message>
    <message>
        <source>no folder could be made in %1: %2</source>
        <translation>no se pudo crear una carpeta en %1: %2</translation>
    </message>
    <message>
        <source>the attached file %1 would leave its folder; nothing was taken out</source>
        <translation>el archivo adjunto %1 saldría de su carpeta; no se extrajo nada</translation>
    </message>
    <message>
        <source>the attached file %1 cannot be taken out: another one is in its way</source>
        <translation>el archivo adjunto %1 no se puede extraer: otro lo impide</translation>
    </message>
    <message>
        <source>it is no PDF</source>
        <translation>no es un PDF</translation>
    </message>
    <message>
        <source>it carries no project: it is no report of Covaria, or one of a version before 0.2.0, or another program has written it anew</source>
        <translation>no lleva ningún proyecto: no es un informe de Covaria, o es de una versión anterior a 0.2.0, u otro programa lo ha escrito de nuevo</translation>
    </message>
    <message>
        <source>best</source>
        <translation>mejor</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>peor</translation>
    </message>
    <message>
        <source>iso-surfaces at %1</source>
        <translation>isosuperficies en %1</translation>
    </message>
    <message>
        <source>the study has not been run</source>
        <translation>el estudio no se ha ejecutado</translation>
    </message>
    <message>
        <source>none of the study&apos;s output quantities has a place in space</source>
        <translation>ninguna de las magnitudes de salida del estudio tiene lugar en el espacio</translation>
    </message>
    <message>
        <source>the point %1 does not move in this study</source>
        <translation>el punto %1 no se mueve en este estudio</translation>
    </message>
    <message>
        <source>best: %1</source>
        <translation>mejor: %1</translation>
    </message>
    <message>
        <source>nothing that this design chooses stands in space</source>
        <translation>nada de lo que elige este diseño está en el espacio</translation>
    </message>
    <message>
        <source>nothing that was tried has a result</source>
        <translation>nada de lo probado tiene resultado</translation>
    </message>
    <message>
        <source>candidates; the larger %1 of %2 are chosen</source>
        <translation>candidatos; los %1 mayores de %2 son los elegidos</translation>
    </message>
    <message>
        <source>gain: by how much the uncertainty is smaller with this candidate than without it, the others as chosen</source>
        <translation>ganancia: cuánto menor es la incertidumbre con este candidato que sin él, los demás como se eligieron</translation>
    </message>
    <message>
        <source>best so far, in the order of the search</source>
        <translation>lo mejor hasta ahora, en el orden de la búsqueda</translation>
    </message>
    <message>
        <source>dashed: where it may stand</source>
        <translation>a trazos: donde puede estar</translation>
    </message>
    <message>
        <source>analysis</source>
        <translation>análisis</translation>
    </message>
    <message>
        <source>kind</source>
        <translation>clase</translation>
    </message>
    <message>
        <source>trajectory</source>
        <translation>trayectoria</translation>
    </message>
    <message>
        <source>mean Monte Carlo</source>
        <translation>media Monte Carlo</translation>
    </message>
    <message>
        <source>u Monte Carlo</source>
        <translation>u Monte Carlo</translation>
    </message>
    <message>
        <source>interval low</source>
        <translation>intervalo inferior</translation>
    </message>
    <message>
        <source>interval high</source>
        <translation>intervalo superior</translation>
    </message>
    <message>
        <source>shortest low</source>
        <translation>más corto inferior</translation>
    </message>
    <message>
        <source>shortest high</source>
        <translation>más corto superior</translation>
    </message>
    <message>
        <source>skewness</source>
        <translation>asimetría</translation>
    </message>
    <message>
        <source>excess kurtosis</source>
        <translation>exceso de curtosis</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>razón</translation>
    </message>
    <message>
        <source>y at the estimates</source>
        <translation>y en las estimaciones</translation>
    </message>
    <message>
        <source>u law of prop.</source>
        <translation>u ley de prop.</translation>
    </message>
    <message>
        <source>u with second-order terms</source>
        <translation>u con términos de segundo orden</translation>
    </message>
    <message>
        <source>shift of the estimate</source>
        <translation>desplazamiento de la estimación</translation>
    </message>
    <message>
        <source>|cᵢ|·u(xᵢ) in %1</source>
        <translation>|cᵢ|·u(xᵢ) en %1</translation>
    </message>
    <message>
        <source>Share of variance in %</source>
        <translation>Parte de la varianza en %</translation>
    </message>
    <message>
        <source>alone, Monte Carlo, in %1</source>
        <translation>sola, Monte Carlo, en %1</translation>
    </message>
    <message>
        <source>ellipsoid, law of prop.</source>
        <translation>elipsoide, ley de prop.</translation>
    </message>
    <message>
        <source>rectangle, law of prop.</source>
        <translation>paralelepípedo, ley de prop.</translation>
    </message>
    <message>
        <source>ellipsoid, Monte Carlo</source>
        <translation>elipsoide, Monte Carlo</translation>
    </message>
    <message>
        <source>rectangle, Monte Carlo</source>
        <translation>paralelepípedo, Monte Carlo</translation>
    </message>
    <message>
        <source>y before</source>
        <translation>y antes</translation>
    </message>
    <message>
        <source>y after</source>
        <translation>y después</translation>
    </message>
    <message>
        <source>Change of y</source>
        <translation>Cambio de y</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Qué</translation>
    </message>
    <message>
        <source>|c|·u before in %1</source>
        <translation>|c|·u antes en %1</translation>
    </message>
    <message>
        <source>|c|·u after in %1</source>
        <translation>|c|·u después en %1</translation>
    </message>
    <message>
        <source>Share before in %</source>
        <translation>Parte antes en %</translation>
    </message>
    <message>
        <source>Share after in %</source>
        <translation>Parte después en %</translation>
    </message>
    <message>
        <source>Change of variance in %</source>
        <translation>Cambio de la varianza en %</translation>
    </message>
    <message>
        <source>first rotation, about z</source>
        <translation>primera rotación, alrededor de z</translation>
    </message>
    <message>
        <source>second rotation, about y</source>
        <translation>segunda rotación, alrededor de y</translation>
    </message>
    <message>
        <source>third rotation, about z</source>
        <translation>tercera rotación, alrededor de z</translation>
    </message>
    <message>
        <source>rotation vector, x</source>
        <translation>vector de rotación, x</translation>
    </message>
    <message>
        <source>rotation vector, y</source>
        <translation>vector de rotación, y</translation>
    </message>
    <message>
        <source>rotation vector, z</source>
        <translation>vector de rotación, z</translation>
    </message>
    <message>
        <source>quaternion, scalar part</source>
        <translation>cuaternión, parte escalar</translation>
    </message>
    <message>
        <source>quaternion, x</source>
        <translation>cuaternión, x</translation>
    </message>
    <message>
        <source>quaternion, y</source>
        <translation>cuaternión, y</translation>
    </message>
    <message>
        <source>quaternion, z</source>
        <translation>cuaternión, z</translation>
    </message>
    <message>
        <source>Coordinates that define the frame are left out.</source>
        <translation>Se omiten las coordenadas que definen el sistema de referencia.</translation>
    </message>
    <message>
        <source>%1, coordinate %2</source>
        <translation>%1, coordenada %2</translation>
    </message>
    <message>
        <source>tool centre point</source>
        <translation>punto central de la herramienta</translation>
    </message>
    <message>
        <source>centre of the flange</source>
        <translation>centro de la brida</translation>
    </message>
    <message>
        <source>calibration of the artefact</source>
        <translation>calibración del artefacto</translation>
    </message>
    <message>
        <source>temperature of the artefact</source>
        <translation>temperatura del artefacto</translation>
    </message>
    <message>
        <source>systematic error of indication</source>
        <translation>error sistemático de indicación</translation>
    </message>
    <message>
        <source>coordinate %1</source>
        <translation>coordenada %1</translation>
    </message>
    <message>
        <source>The bias b is not corrected; |b| counts as a standard uncertainty (against JCGM 100 3.2.4).</source>
        <translation>El sesgo b no se corrige; |b| cuenta como incertidumbre típica (en contra de JCGM 100 3.2.4).</translation>
    </message>
    <message>
        <source>The bias b is not part of u_c.</source>
        <translation>El sesgo b no forma parte de u_c.</translation>
    </message>
    <message>
        <source>Measured values are taken as corrected by -b; u_var/sqrt(n) of the correction is part of u_c.</source>
        <translation>Los valores medidos se toman como corregidos por -b; u_var/sqrt(n) de la corrección forma parte de u_c.</translation>
    </message>
    <message>
        <source>A coordinate of a point has u_c divided by √2.</source>
        <translation>Una coordenada de un punto tiene u_c dividida por √2.</translation>
    </message>
    <message>
        <source>measured coordinate</source>
        <translation>coordenada medida</translation>
    </message>
    <message>
        <source>typed standard uncertainty</source>
        <translation>incertidumbre típica tecleada</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>specification: %1</source>
        <translation>especificación: %1</translation>
    </message>
    <message>
        <source>The figure is taken as: %1.</source>
        <translation>La cifra se toma como: %1.</translation>
    </message>
    <message>
        <source>%1, of a length: divided by √2</source>
        <translation>%1, de una longitud: dividida por √2</translation>
    </message>
    <message>
        <source>station, combination %1</source>
        <translation>estación, combinación %1</translation>
    </message>
    <message>
        <source>instrument: standard uncertainties and correlation of the station</source>
        <translation>instrumento: incertidumbres típicas y correlación de la estación</translation>
    </message>
    <message>
        <source>scale of distances</source>
        <translation>escala de las distancias</translation>
    </message>
    <message>
        <source>zero offset of distances</source>
        <translation>error de cero de las distancias</translation>
    </message>
    <message>
        <source>index of the elevation</source>
        <translation>índice de la elevación</translation>
    </message>
    <message>
        <source>collimation</source>
        <translation>colimación</translation>
    </message>
    <message>
        <source>squareness of the axes</source>
        <translation>perpendicularidad de los ejes</translation>
    </message>
    <message>
        <source>offset of the beam</source>
        <translation>desplazamiento del haz</translation>
    </message>
    <message>
        <source>coefficient of refraction</source>
        <translation>coeficiente de refracción</translation>
    </message>
    <message>
        <source>instrument: standard uncertainty</source>
        <translation>instrumento: incertidumbre típica</translation>
    </message>
    <message>
        <source>instrument: %1</source>
        <translation>instrumento: %1</translation>
    </message>
    <message>
        <source>For a target at the height of the instrument.</source>
        <translation>Para una diana a la altura del instrumento.</translation>
    </message>
    <message>
        <source>station, %1</source>
        <translation>estación, %1</translation>
    </message>
    <message>
        <source>%1, %2, set-up %3</source>
        <translation>%1, %2, estacionamiento %3</translation>
    </message>
    <message>
        <source>displacement across the azimuth</source>
        <translation>desplazamiento transversal al acimut</translation>
    </message>
    <message>
        <source>%1 to %2, %3</source>
        <translation>%1 a %2, %3</translation>
    </message>
    <message>
        <source>calibrated length</source>
        <translation>longitud calibrada</translation>
    </message>
    <message>
        <source>calibration of the %1</source>
        <translation>calibración: %1</translation>
    </message>
    <message>
        <source>%1, calibrated length</source>
        <translation>%1, longitud calibrada</translation>
    </message>
    <message>
        <source>distance from %1 to %2</source>
        <translation>distancia de %1 a %2</translation>
    </message>
    <message>
        <source>angle at %1 from %2 to %3</source>
        <translation>ángulo en %1 de %2 a %3</translation>
    </message>
    <message>
        <source>%1, measured minus calibrated length</source>
        <translation>%1, longitud medida menos calibrada</translation>
    </message>
    <message>
        <source>origin of %1, coordinate %2</source>
        <translation>origen de %1, coordenada %2</translation>
    </message>
    <message>
        <source>rotation of %1 about %2</source>
        <translation>rotación de %1 alrededor de %2</translation>
    </message>
    <message>
        <source>The precision of the readings is no uncertainty of a position: it leaves out where the sensors stand and what their readings share. Monte Carlo is in the results.</source>
        <translation>La precisión de las lecturas no es la incertidumbre de una posición: omite dónde están los sensores y lo que sus lecturas comparten. Monte Carlo está en los resultados.</translation>
    </message>
    <message>
        <source>No redundancy: as many readings as unknowns, so nothing can be checked.</source>
        <translation>Sin redundancia: tantas lecturas como incógnitas, por lo que nada se puede comprobar.</translation>
    </message>
    <message>
        <source>The residuals are larger than the uncertainties allow.</source>
        <translation>Los residuos son mayores de lo que permiten las incertidumbres.</translation>
    </message>
    <message>
        <source>The residuals are smaller than the uncertainties lead to expect.</source>
        <translation>Los residuos son menores de lo que hacen esperar las incertidumbres.</translation>
    </message>
    <message>
        <source>The residuals agree with the uncertainties.</source>
        <translation>Los residuos concuerdan con las incertidumbres.</translation>
    </message>
    <message>
        <source>%1 readings have |w| &gt; 3.29 (0.1 %); where several do, look at the largest first.</source>
        <translation>%1 lecturas tienen |w| &gt; 3.29 (0.1 %); si son varias, mire primero la mayor.</translation>
    </message>
    <message>
        <source>%1 in %2, coordinate %3</source>
        <translation>%1 en %2, coordenada %3</translation>
    </message>
    <message>
        <source>position of the platform, %1</source>
        <translation>posición de la plataforma, %1</translation>
    </message>
    <message>
        <source>Chi-square of the residuals with the full covariance of the stated uncertainties; nominal coordinates are taken as exact. p is the probability of a larger value if all is as stated; the test has a level of 1 % for all sets together. Not tested: sets without stated uncertainty, and sets of more than %1 points.</source>
        <translation>Ji-cuadrado de los residuos con la covarianza completa de las incertidumbres declaradas; las coordenadas nominales se toman como exactas. p es la probabilidad de un valor mayor si todo es como se declara; el contraste tiene un nivel del 1 % para todos los conjuntos juntos. No se contrastan: conjuntos sin incertidumbre declarada y conjuntos de más de %1 puntos.</translation>
    </message>
    <message>
        <source>Measured less nominal coordinates. w is a residual over its own standard uncertainty; |w| &gt; 3.29 (0.1 %) is remarked. Redundancy is the share of an error of the coordinate that stays in its residual.</source>
        <translation>Coordenadas medidas menos nominales. w es un residuo dividido por su propia incertidumbre típica; |w| &gt; 3.29 (0.1 %) se señala. La redundancia es la parte de un error de la coordenada que queda en su residuo.</translation>
    </message>
    <message>
        <source>reading of bar %1</source>
        <translation>lectura de la barra %1</translation>
    </message>
    <message>
        <source>ballbars: %1</source>
        <translation>barras de bolas: %1</translation>
    </message>
    <message>
        <source>length between supports %1</source>
        <translation>longitud entre los apoyos %1</translation>
    </message>
    <message>
        <source>height of support %1</source>
        <translation>altura del apoyo %1</translation>
    </message>
    <message>
        <source>ballbars: standard uncertainty</source>
        <translation>barras de bolas: incertidumbre típica</translation>
    </message>
    <message>
        <source>scale of all lengths</source>
        <translation>escala de todas las longitudes</translation>
    </message>
    <message>
        <source>constant of bar %1</source>
        <translation>constante de la barra %1</translation>
    </message>
    <message>
        <source>%1, point %2</source>
        <translation>%1, punto %2</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>punto %1</translation>
    </message>
    <message>
        <source>axis %1 of the flange, angle towards %2</source>
        <translation>eje %1 de la brida, ángulo hacia %2</translation>
    </message>
    <message>
        <source>repeatability along %1</source>
        <translation>repetibilidad a lo largo de %1</translation>
    </message>
    <message>
        <source>repeatability: %1</source>
        <translation>repetibilidad: %1</translation>
    </message>
    <message>
        <source>The coordinates are uncorrelated; unless they are normal, they are not independent: the distance has the law above, its direction is random.</source>
        <translation>Las coordenadas no están correlacionadas; salvo que sean normales, no son independientes: la distancia tiene la ley de arriba, su dirección es aleatoria.</translation>
    </message>
    <message>
        <source>repeatability about %1</source>
        <translation>repetibilidad alrededor de %1</translation>
    </message>
    <message>
        <source>repeatability of the orientation</source>
        <translation>repetibilidad de la orientación</translation>
    </message>
    <message>
        <source>%1 of joint %2</source>
        <translation>%1 de la articulación %2</translation>
    </message>
    <message>
        <source>encoder</source>
        <translation>codificador</translation>
    </message>
    <message>
        <source>tool, rotation about %1</source>
        <translation>herramienta, rotación alrededor de %1</translation>
    </message>
    <message>
        <source>tool: standard uncertainty</source>
        <translation>herramienta: incertidumbre típica</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1, combined</source>
        <translation>%1, combinada</translation>
    </message>
    <message>
        <source>%1, deviation</source>
        <translation>%1, desviación</translation>
    </message>
    <message>
        <source>reading of joint %1, %2</source>
        <translation>lectura de la articulación %1, %2</translation>
    </message>
    <message>
        <source>position of the tool, %1</source>
        <translation>posición de la herramienta, %1</translation>
    </message>
    <message>
        <source>orientation of the tool, %1</source>
        <translation>orientación de la herramienta, %1</translation>
    </message>
    <message>
        <source>joint angle</source>
        <translation>ángulo de la articulación</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>desplazamiento</translation>
    </message>
    <message>
        <source>link length</source>
        <translation>longitud del eslabón</translation>
    </message>
    <message>
        <source>twist</source>
        <translation>torsión</translation>
    </message>
    <message>
        <source>second twist</source>
        <translation>segunda torsión</translation>
    </message>
    <message>
        <source>Components of a parameter combine in quadrature (Wen et al., Eq. 10). U has the factor 2 of the paper; with few effective degrees of freedom 95 % need more.</source>
        <translation>Los componentes de un parámetro se combinan en cuadratura (Wen et al., Eq. 10). U tiene el factor 2 del artículo; con pocos grados de libertad efectivos el 95 % requiere más.</translation>
    </message>
    <message>
        <source>Places of the tool in the base frame of the robot.</source>
        <translation>Lugares de la herramienta en el sistema de la base del robot.</translation>
    </message>
    <message>
        <source>calculated less measured %1, held back</source>
        <translation>%1 calculada menos medida, reservada</translation>
    </message>
    <message>
        <source>orientation of the base, %1</source>
        <translation>orientación de la base, %1</translation>
    </message>
    <message>
        <source>position of the base, %1</source>
        <translation>posición de la base, %1</translation>
    </message>
    <message>
        <source>pose %1, rotation about %2</source>
        <translation>pose %1, rotación alrededor de %2</translation>
    </message>
    <message>
        <source>pose %1, %2</source>
        <translation>pose %1, %2</translation>
    </message>
    <message>
        <source>measured orientation</source>
        <translation>orientación medida</translation>
    </message>
    <message>
        <source>pose %1, reading of joint %2</source>
        <translation>pose %1, lectura de la articulación %2</translation>
    </message>
    <message>
        <source>Singular values are those of the weighted Jacobian with columns of length one.</source>
        <translation>Los valores singulares son los de la jacobiana ponderada con columnas de longitud uno.</translation>
    </message>
    <message>
        <source>Least well told apart: %1.</source>
        <translation>Los que peor se distinguen: %1.</translation>
    </message>
    <message>
        <source>A residual beyond %1 times its own standard uncertainty is an outlier: 5 % for all residuals together (Bonferroni).</source>
        <translation>Un residuo mayor que %1 veces su propia incertidumbre típica es un valor atípico: 5 % para todos los residuos juntos (Bonferroni).</translation>
    </message>
    <message>
        <source>Nominal: the same base and ball fitted with the nominal parameters. E_n = |d|/U: below 1 the pose agrees with the calibration.</source>
        <translation>Nominal: la misma base y bola ajustadas con los parámetros nominales. E_n = |d|/U: por debajo de 1 la pose concuerda con la calibración.</translation>
    </message>
    <message>
        <source>radius of the circle of joint %1</source>
        <translation>radio del círculo de la articulación %1</translation>
    </message>
    <message>
        <source>%1, point %2, %3</source>
        <translation>%1, punto %2, %3</translation>
    </message>
    <message>
        <source>Simulated points of the nominal robot: they lie on their circles.</source>
        <translation>Puntos simulados del robot nominal: están sobre sus círculos.</translation>
    </message>
    <message>
        <source>load %1, compensated</source>
        <translation>carga %1, compensada</translation>
    </message>
    <message>
        <source>load %1 by its own channel alone</source>
        <translation>carga %1 solo por su propio canal</translation>
    </message>
    <message>
        <source>calibration machine, %1</source>
        <translation>máquina de calibración, %1</translation>
    </message>
    <message>
        <source>calibration machine, Eq 5</source>
        <translation>máquina de calibración, Eq 5</translation>
    </message>
    <message>
        <source>regression of %1</source>
        <translation>regresión de %1</translation>
    </message>
    <message>
        <source>reading of %1 by load %2</source>
        <translation>lectura de %1 por la carga %2</translation>
    </message>
    <message>
        <source>quadratic term of %1 by load %2</source>
        <translation>término cuadrático de %1 por la carga %2</translation>
    </message>
    <message>
        <source>%1 of %2, %3</source>
        <translation>%1 de %2, %3</translation>
    </message>
    <message>
        <source>standard deviation of one reading, Eq 3</source>
        <translation>desviación típica de una lectura, Eq 3</translation>
    </message>
    <message>
        <source>net reading of %1, %2</source>
        <translation>lectura neta de %1, %2</translation>
    </message>
    <message>
        <source>Eq 6</source>
        <translation>Eq 6</translation>
    </message>
    <message>
        <source>Eq 7</source>
        <translation>Eq 7</translation>
    </message>
    <message>
        <source>Eq 10, full width of the loop</source>
        <translation>Eq 10, ancho completo del ciclo</translation>
    </message>
    <message>
        <source>Eq 10, in proportion to the load</source>
        <translation>Eq 10, en proporción a la carga</translation>
    </message>
    <message>
        <source>Condition number, by rated outputs and rated loads: %1; with quadratic terms beside these slopes.</source>
        <translation>Número de condición, referido a salidas y cargas nominales: %1; con términos cuadráticos además de estas pendientes.</translation>
    </message>
    <message>
        <source>Condition number, by rated outputs and rated loads: %1.</source>
        <translation>Número de condición, referido a salidas y cargas nominales: %1.</translation>
    </message>
    <message>
        <source>Uncompensated: by the slope of the channel&apos;s own axis. The uncertainties of both are among the results.</source>
        <translation>Sin compensar: por la pendiente del eje propio del canal. Las incertidumbres de ambas están en los resultados.</translation>
    </message>
    <message>
        <source>Reproduces: equal in all printed digits. Inside rounding: what it is computed from was rounded, too. Interference, percent: the row&apos;s sensor, then the column&apos;s axis.</source>
        <translation>Reproduce: igual en todas las cifras impresas. Dentro del redondeo: también se redondeó aquello de lo que se calcula. Interferencia, por ciento: el sensor de la fila, luego el eje de la columna.</translation>
    </message>
    <message>
        <source>Fig. 2: %1 s without load before a series, %2 s at each load.</source>
        <translation>Fig. 2: %1 s sin carga antes de una serie, %2 s en cada carga.</translation>
    </message>
    <message>
        <source>A row is a load, a column the sensor that answers to it.</source>
        <translation>Una fila es una carga, una columna el sensor que responde a ella.</translation>
    </message>
    <message>
        <source>A row is a sensor, a column the load under which it gives this output.</source>
        <translation>Una fila es un sensor, una columna la carga bajo la que da esta salida.</translation>
    </message>
    <message>
        <source>Magnitudes: the signs are not known.</source>
        <translation>Magnitudes: los signos no se conocen.</translation>
    </message>
    <message>
        <source>U = hysteresis + interference + k u_c with k = %1: a linear sum of two largest values and an expanded uncertainty. Type A: n = %2 runs, %3 degrees of freedom.</source>
        <translation>U = histéresis + interferencia + k u_c con k = %1: una suma lineal de dos valores máximos y una incertidumbre expandida. Tipo A: n = %2 series, %3 grados de libertad.</translation>
    </message>
    <message>
        <source>Calibration machine: %1.</source>
        <translation>Máquina de calibración: %1.</translation>
    </message>
    <message>
        <source>Table 3 takes the Type B standard uncertainties that are stated, not these.</source>
        <translation>La tabla 3 toma las incertidumbres típicas de tipo B declaradas, no estas.</translation>
    </message>
    <message>
        <source>load %1 that channel %1 tells</source>
        <translation>carga %1 que indica el canal %1</translation>
    </message>
    <message>
        <source>net reading of channel %1</source>
        <translation>lectura neta del canal %1</translation>
    </message>
    <message>
        <source>load by the rated load of channel %1</source>
        <translation>carga dividida por la carga nominal del canal %1</translation>
    </message>
    <message>
        <source>Eqs 3, 4</source>
        <translation>Eqs 3, 4</translation>
    </message>
    <message>
        <source>net reading of %1 at rated load</source>
        <translation>lectura neta de %1 con la carga nominal</translation>
    </message>
    <message>
        <source>calibration machine</source>
        <translation>máquina de calibración</translation>
    </message>
    <message>
        <source>Eq 5</source>
        <translation>Eq 5</translation>
    </message>
    <message>
        <source>Eq 10, as a rectangular distribution over the loop</source>
        <translation>Eq 10, como distribución rectangular sobre el ciclo</translation>
    </message>
    <message>
        <source>unknown load on %1</source>
        <translation>carga desconocida en %1</translation>
    </message>
    <message>
        <source>set-up: unknown between minus and plus the rated load</source>
        <translation>configuración: desconocida entre menos y más la carga nominal</translation>
    </message>
    <message>
        <source>load on %1 by its rated load</source>
        <translation>carga en %1 dividida por su carga nominal</translation>
    </message>
    <message>
        <source>The paper adds the largest hysteresis and the largest interference to k times u_c. It counts one other load only: with several loads their interference adds up, and exceeds the paper&apos;s U for %1 of %2 sensors when all act fully.</source>
        <translation>El artículo suma la mayor histéresis y la mayor interferencia a k por u_c. Cuenta solo otra carga: con varias cargas sus interferencias se suman y superan la U del artículo en %1 de %2 sensores cuando todas actúan por completo.</translation>
    </message>
    <message>
        <source>So the linear sum is no bound under combined load, and for one component alone it is far too large. As hysteresis and interference are limits and no standard uncertainties, it is no coverage interval either.</source>
        <translation>Así, la suma lineal no es una cota bajo carga combinada, y para un solo componente es demasiado grande. Como la histéresis y la interferencia son límites y no incertidumbres típicas, tampoco es un intervalo de cobertura.</translation>
    </message>
    <message>
        <source>GUM: hysteresis, non-zero error and resolution are rectangular, each unknown load is rectangular between minus and plus its rated load, root sum of squares. One component alone: k from the t-distribution with the effective degrees of freedom.</source>
        <translation>GUM: histéresis, error de cero y resolución son rectangulares, cada carga desconocida es rectangular entre menos y más su carga nominal, raíz de la suma de cuadrados. Un solo componente: k de la distribución t con los grados de libertad efectivos.</translation>
    </message>
    <message>
        <source>Repeatability: the largest of the steps; its degrees of freedom are those of one step. Pooled over the steps it has more of them.</source>
        <translation>Repetibilidad: la mayor de los escalones; sus grados de libertad son los de un escalón. Combinada sobre los escalones tiene más.</translation>
    </message>
    <message>
        <source>pooled standard deviation</source>
        <translation>desviación típica combinada</translation>
    </message>
    <message>
        <source>mean of %1 observations</source>
        <translation>media de %1 observaciones</translation>
    </message>
    <message>
        <source>s is the experimental standard deviation, u = s/√n (JCGM 100 4.2). A quantity that is stated as pooled observations has the u of all its series together (JCGM 100 4.2.4).</source>
        <translation>s es la desviación típica experimental, u = s/√n (JCGM 100 4.2). Una magnitud declarada como observaciones combinadas tiene la u de todas sus series juntas (JCGM 100 4.2.4).</translation>
    </message>
    <message>
        <source>scatter of the means of the groups</source>
        <translation>dispersión de las medias de los grupos</translation>
    </message>
    <message>
        <source>components of variance between and within the groups</source>
        <translation>componentes de la varianza entre los grupos y dentro de ellos</translation>
    </message>
    <message>
        <source>%1 groups, %2 observations</source>
        <translation>%1 grupos, %2 observaciones</translation>
    </message>
    <message>
        <source>mean of all observations</source>
        <translation>media de todas las observaciones</translation>
    </message>
    <message>
        <source>There is an effect of the groups at the level of 5 %.</source>
        <translation>Hay un efecto de los grupos al nivel del 5 %.</translation>
    </message>
    <message>
        <source>No effect of the groups is seen at the level of 5 %.</source>
        <translation>No se ve ningún efecto de los grupos al nivel del 5 %.</translation>
    </message>
    <message>
        <source>The component of variance between the groups is zero: all observations count as independent.</source>
        <translation>El componente de la varianza entre los grupos es cero: todas las observaciones cuentan como independientes.</translation>
    </message>
    <message>
        <source>scatter of the points about the curve</source>
        <translation>dispersión de los puntos alrededor de la curva</translation>
    </message>
    <message>
        <source>least squares, residuals of %1 points</source>
        <translation>mínimos cuadrados, residuos de %1 puntos</translation>
    </message>
    <message>
        <source>value of the curve at the origin</source>
        <translation>valor de la curva en el origen</translation>
    </message>
    <message>
        <source>coefficient of the power %1</source>
        <translation>coeficiente de la potencia %1</translation>
    </message>
    <message>
        <source>mean of y</source>
        <translation>media de y</translation>
    </message>
    <message>
        <source>term of degree %1 (orthonormal polynomial)</source>
        <translation>término de grado %1 (polinomio ortonormal)</translation>
    </message>
    <message>
        <source>%1 of point %2</source>
        <translation>%1 del punto %2</translation>
    </message>
    <message>
        <source>stated uncertainty of %1</source>
        <translation>incertidumbre declarada de %1</translation>
    </message>
    <message>
        <source>table of points</source>
        <translation>tabla de los puntos</translation>
    </message>
    <message>
        <source>observed y</source>
        <translation>y observada</translation>
    </message>
    <message>
        <source>%1, observed y</source>
        <translation>%1, y observada</translation>
    </message>
    <message>
        <source>table of the inverse use</source>
        <translation>tabla del uso inverso</translation>
    </message>
    <message>
        <source>value of the curve at %1</source>
        <translation>valor de la curva en %1</translation>
    </message>
    <message>
        <source>x where the curve is %1</source>
        <translation>x donde la curva es %1</translation>
    </message>
    <message>
        <source>The residuals agree with the stated uncertainties.</source>
        <translation>Los residuos concuerdan con las incertidumbres declaradas.</translation>
    </message>
    <message>
        <source>The residuals are larger than the stated uncertainties explain: the curve or the uncertainties do not describe these points.</source>
        <translation>Los residuos son mayores de lo que explican las incertidumbres declaradas: la curva o las incertidumbres no describen estos puntos.</translation>
    </message>
    <message>
        <source>The x of y = %1 lies outside of the points of the calibration.</source>
        <translation>La x de y = %1 está fuera de los puntos de la calibración.</translation>
    </message>
    <message>
        <source>the parameters come from an analysis, which is evaluated in every trial: their correlation cannot be ignored</source>
        <translation>los parámetros proceden de un análisis que se evalúa en cada prueba: su correlación no puede omitirse</translation>
    </message>
    <message>
        <source>Rz(θ) Tz(d) Tx(a) Rx(α) Ry(β), β for parallel joints</source>
        <translation>Rz(θ) Tz(d) Tx(a) Rx(α) Ry(β), β para ejes paralelos</translation>
    </message>
    <message>
        <source>Rz(θ) Tz(d) Tx(a) Rx(α), Denavit-Hartenberg</source>
        <translation>Rz(θ) Tz(d) Tx(a) Rx(α), Denavit-Hartenberg</translation>
    </message>
    <message>
        <source>Rx(α) Tx(a) Rz(θ) Tz(d), Craig: α and a before joint i</source>
        <translation>Rx(α) Tx(a) Rz(θ) Tz(d), Craig: α y a antes del eje i</translation>
    </message>
    <message>
        <source>Date of receipt</source>
        <translation>Fecha de recepción</translation>
    </message>
    <message>
        <source>Date of calibration</source>
        <translation>Fecha de calibración</translation>
    </message>
    <message>
        <source>Date of issue</source>
        <translation>Fecha de emisión</translation>
    </message>
    <message>
        <source>To first order no input quantity influences %1 at these estimates: its uncertainty is of second order, as Monte Carlo shows</source>
        <translation>En primer orden ninguna magnitud de entrada influye en %1 en estas estimaciones: su incertidumbre es de segundo orden, como muestra Monte Carlo</translation>
    </message>
    <message>
        <source>Calibration certificate</source>
        <translation>Certificado de calibración</translation>
    </message>
    <message>
        <source>not normal; k u fits as far as so few trials can tell</source>
        <translation>no normal; k u es adecuado hasta donde pueden decirlo tan pocas pruebas</translation>
    </message>
    <message>
        <source>measured artefact, Porath et al., Eq. 2</source>
        <translation>artefacto medido, Porath et al., ec. 2</translation>
    </message>
    <message>
        <source>not controlled</source>
        <translation>no controlada</translation>
    </message>
    <message>
        <source>outlier?</source>
        <translation>¿valor atípico?</translation>
    </message>
    <message>
        <source>not tested</source>
        <translation>sin comprobar</translation>
    </message>
    <message>
        <source>residuals larger than stated</source>
        <translation>residuos mayores que lo declarado</translation>
    </message>
    <message>
        <source>agrees</source>
        <translation>concuerda</translation>
    </message>
    <message>
        <source>distance: largest</source>
        <translation>distancia: máxima</translation>
    </message>
    <message>
        <source>distance: RP = mean + 3 s</source>
        <translation>distancia: RP = media + 3 s</translation>
    </message>
    <message>
        <source>does not move the measured points in any pose</source>
        <translation>no mueve los puntos medidos en ninguna pose</translation>
    </message>
    <message>
        <source>moves the measured points as %1 can: coupled with it, held at its nominal value</source>
        <translation>mueve los puntos medidos como puede hacerlo %1: acoplado con ello, se mantiene en su valor nominal</translation>
    </message>
    <message>
        <source>coordinates in the fit</source>
        <translation>coordenadas en el ajuste</translation>
    </message>
    <message>
        <source>unknowns (rank)</source>
        <translation>incógnitas (rango)</translation>
    </message>
    <message>
        <source>condition of the fit</source>
        <translation>número de condición del ajuste</translation>
    </message>
    <message>
        <source>smallest singular value</source>
        <translation>menor valor singular</translation>
    </message>
    <message>
        <source>residuals over what uncertainties explain</source>
        <translation>residuos respecto a lo que explican las incertidumbres</translation>
    </message>
    <message>
        <source>outlier</source>
        <translation>valor atípico</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>herramienta</translation>
    </message>
    <message>
        <source>one ball is one point: it has no orientation</source>
        <translation>una bola es un punto: no tiene orientación</translation>
    </message>
    <message>
        <source>places the base frame on axis 1: by definition, as nominal; it would need a measured base</source>
        <translation>sitúa el sistema de la base en el eje 1: por definición, como el nominal; haría falta una base medida</translation>
    </message>
    <message>
        <source>places the frame of the last link, which no axis follows: by definition, as nominal</source>
        <translation>sitúa el sistema del último eslabón, al que no sigue ningún eje: por definición, como el nominal</translation>
    </message>
    <message>
        <source>the axis is parallel to the next: 0 by definition, or beta and d would describe the same</source>
        <translation>el eje es paralelo al siguiente: 0 por definición, o beta y d describirían lo mismo</translation>
    </message>
    <message>
        <source>reproduces</source>
        <translation>se reproduce</translation>
    </message>
    <message>
        <source>inside rounding</source>
        <translation>dentro del redondeo</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>difiere</translation>
    </message>
    <message>
        <source>planned</source>
        <translation>planificado</translation>
    </message>
    <message>
        <source>total</source>
        <translation>total</translation>
    </message>
    <message>
        <source>standard deviation of the means of the groups</source>
        <translation>desviación típica de las medias de los grupos</translation>
    </message>
    <message>
        <source>s_a, from the means of the groups</source>
        <translation>s_a, de las medias de los grupos</translation>
    </message>
    <message>
        <source>s_b, within the groups</source>
        <translation>s_b, dentro de los grupos</translation>
    </message>
    <message>
        <source>s_B, between the groups</source>
        <translation>s_B, entre los grupos</translation>
    </message>
    <message>
        <source>n_0, size of the groups</source>
        <translation>n_0, tamaño de los grupos</translation>
    </message>
    <message>
        <source>F = s_a²/s_b²</source>
        <translation>F = s_a²/s_b²</translation>
    </message>
    <message>
        <source>95 % quantile of F</source>
        <translation>cuantil del 95 % de F</translation>
    </message>
    <message>
        <source>97.5 % quantile of F</source>
        <translation>cuantil del 97,5 % de F</translation>
    </message>
    <message>
        <source>between the groups</source>
        <translation>entre los grupos</translation>
    </message>
    <message>
        <source>within the groups</source>
        <translation>dentro de los grupos</translation>
    </message>
    <message>
        <source>chi-squared</source>
        <translation>chi cuadrado</translation>
    </message>
    <message>
        <source>its 95 % quantile</source>
        <translation>su cuantil del 95 %</translation>
    </message>
    <message>
        <source>standard deviation of the residuals</source>
        <translation>desviación típica de los residuos</translation>
    </message>
    <message>
        <source>coefficient of determination R²</source>
        <translation>coeficiente de determinación R²</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>curva</translation>
    </message>
    <message>
        <source>residuals</source>
        <translation>residuos</translation>
    </message>
    <message>
        <source>position %1, rotations about x, y, z: %2</source>
        <translation>posición %1, rotaciones alrededor de x, y, z: %2</translation>
    </message>
    <message>
        <source>1 further component</source>
        <translation>otra componente</translation>
    </message>
    <message>
        <source>Shown for %1, the first of the %2 groups; the CSV table of budgets has every group.</source>
        <translation>Se muestra para %1, el primero de los %2 grupos; la tabla CSV de balances contiene todos los grupos.</translation>
    </message>
    <message>
        <source>Shown for %1: of the %2 groups it has the largest expanded uncertainties on average; the CSV table of budgets has every group.</source>
        <translation>Se muestra para %1: de los %2 grupos tiene por término medio las mayores incertidumbres expandidas; la tabla CSV de balances contiene todos los grupos.</translation>
    </message>
    <message>
        <source>Shown for %1: of the %2 groups with the same quantities it has the largest expanded uncertainties on average; the CSV table of budgets has all %3 groups.</source>
        <translation>Se muestra para %1: de los %2 grupos con las mismas magnitudes tiene por término medio las mayores incertidumbres expandidas; la tabla CSV de balances contiene los %3 grupos.</translation>
    </message>
    <message>
        <source>The law of propagation is validated by JCGM 101 clause 8 where both ends of its coverage interval, y ± U, lie within the numerical tolerance δ of those of the propagation of distributions. Validated: %1 of %2.</source>
        <translation>La ley de propagación queda validada según JCGM 101, capítulo 8, donde ambos extremos de su intervalo de cobertura, y ± U, están dentro de la tolerancia numérica δ de los de la propagación de distribuciones. Validadas: %1 de %2.</translation>
    </message>
    <message>
        <source>Shape of the distributions by Monte Carlo</source>
        <translation>Forma de las distribuciones según Monte Carlo</translation>
    </message>
    <message>
        <source>From &apos;%1&apos; on, %2 of %3 rows; the annex has all of them.</source>
        <translation>Desde «%1», %2 de %3 filas; el anexo las contiene todas.</translation>
    </message>
    <message>
        <source>From &apos;%1&apos; on, %2 of %3 rows; the CSV tables, and the annex on request, have all of them.</source>
        <translation>Desde «%1», %2 de %3 filas; las tablas CSV y, si se pide, el anexo las contienen todas.</translation>
    </message>
    <message>
        <source>The annex has the charts.</source>
        <translation>El anexo contiene los gráficos.</translation>
    </message>
    <message>
        <source>The CSV tables, and the annex on request, have what the charts show.</source>
        <translation>Las tablas CSV y, si se pide, el anexo contienen lo que muestran los gráficos.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables and no chart; the annex has the rest.</source>
        <translation>Se muestran %1 de %2 tablas y ningún gráfico; el anexo contiene el resto.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables and no chart; the CSV tables, and the annex on request, have the rest.</source>
        <translation>Se muestran %1 de %2 tablas y ningún gráfico; las tablas CSV y, si se pide, el anexo contienen el resto.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>incógnita</translation>
    </message>
    <message>
        <source>coupled with</source>
        <translation>acoplada con</translation>
    </message>
    <message>
        <source>Observations of %1</source>
        <translation>Observaciones de %1</translation>
    </message>
    <message>
        <source>mean + s</source>
        <translation>media + s</translation>
    </message>
    <message>
        <source>mean − s</source>
        <translation>media − s</translation>
    </message>
    <message>
        <source>What is reported, and in which unit. Without rows: every name that an equation defines and no other one uses, in the unit of the first quantity of the same dimension, else in SI units.</source>
        <translation>Lo que se informa y en qué unidad. Sin filas: cada nombre que define una ecuación y que no usa ninguna otra, en la unidad de la primera magnitud de la misma dimensión y, si no hay ninguna, en unidades SI.</translation>
    </message>
    <message>
        <source>arcsine</source>
        <translation>arcoseno</translation>
    </message>
    <message>
        <source>curvilinear</source>
        <translation>curvilíneo</translation>
    </message>
    <message>
        <source>inexactness</source>
        <translation>inexactitud</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>límites</translation>
    </message>
    <message>
        <source>pooled</source>
        <translation>agrupada</translation>
    </message>
    <message>
        <source>From the set-up as it is stated. Values and uncertainties that other analyses give (%1 quantities) are in the results, not here.</source>
        <translation>A partir de la configuración tal como está indicada. Los valores e incertidumbres que dan otros análisis (%1 magnitudes) están en los resultados, no aquí.</translation>
    </message>
    <message>
        <source>Limit of the coverage interval: of Monte Carlo, else of the law of propagation</source>
        <translation>Límite del intervalo de cobertura: de Monte Carlo y, si no, de la ley de propagación</translation>
    </message>
    <message>
        <source>Input quantities that the component is part of</source>
        <translation>Magnitudes de entrada de las que forma parte la componente</translation>
    </message>
    <message>
        <source>Quantity or component of uncertainty, as at the bars of the chart</source>
        <translation>Magnitud o componente de incertidumbre, como en las barras del gráfico</translation>
    </message>
    <message>
        <source>density</source>
        <translation>densidad</translation>
    </message>
    <message>
        <source>quantile</source>
        <translation>cuantil</translation>
    </message>
    <message>
        <source>calibrated lengths</source>
        <translation>longitudes calibradas</translation>
    </message>
    <message>
        <source>distances</source>
        <translation>distancias</translation>
    </message>
    <message>
        <source>angles</source>
        <translation>ángulos</translation>
    </message>
    <message>
        <source>scale bar</source>
        <translation>regla patrón</translation>
    </message>
    <message>
        <source>base</source>
        <translation>base</translation>
    </message>
    <message>
        <source>supports</source>
        <translation>apoyos</translation>
    </message>
    <message>
        <source>axes of the flange</source>
        <translation>ejes de la brida</translation>
    </message>
    <message>
        <source>circles</source>
        <translation>círculos</translation>
    </message>
    <message>
        <source>calibration matrix</source>
        <translation>matriz de calibración</translation>
    </message>
    <message>
        <source>loads on other axes</source>
        <translation>cargas en otros ejes</translation>
    </message>
    <message>
        <source>scatter of all observations</source>
        <translation>dispersión de todas las observaciones</translation>
    </message>
    <message>
        <source>points, x</source>
        <translation>puntos, x</translation>
    </message>
    <message>
        <source>points, y</source>
        <translation>puntos, y</translation>
    </message>
    <message>
        <source>inverse use</source>
        <translation>uso inverso</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>%1, all rows: %2</source>
        <translation>%1, todas las filas: %2</translation>
    </message>
    <message>
        <source>%1: uncertainty</source>
        <translation>%1: incertidumbre</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>fila %1</translation>
    </message>
    <message>
        <source>%1: estimate</source>
        <translation>%1: estimación</translation>
    </message>
    <message>
        <source>%1, factor</source>
        <translation>%1, factor</translation>
    </message>
    <message>
        <source>%1, added</source>
        <translation>%1, sumado</translation>
    </message>
    <message>
        <source>base b</source>
        <translation>base b</translation>
    </message>
    <message>
        <source>platform p</source>
        <translation>plataforma p</translation>
    </message>
    <message>
        <source>support %1</source>
        <translation>apoyo %1</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>eje %1</translation>
    </message>
    <message>
        <source>check %1</source>
        <translation>control %1</translation>
    </message>
    <message>
        <source>axis of %1</source>
        <translation>eje de %1</translation>
    </message>
    <message>
        <source>scale bar %1</source>
        <translation>regla patrón %1</translation>
    </message>
    <message>
        <source>%1 (u of first order: %2 of that by Monte Carlo)</source>
        <translation>%1 (u de primer orden: %2 de la de Monte Carlo)</translation>
    </message>
    <message>
        <source>S / %</source>
        <translation>S / %</translation>
    </message>
    <message>
        <source>Share of the variance that the component causes by itself (Sobol index)</source>
        <translation>Parte de la varianza que la componente causa por sí sola (índice de Sobol)</translation>
    </message>
    <message>
        <source>S total / %</source>
        <translation>S total / %</translation>
    </message>
    <message>
        <source>Share of the variance with all interactions of the component with others</source>
        <translation>Parte de la varianza con todas las interacciones de la componente con otras</translation>
    </message>
    <message>
        <source>ν (first order)</source>
        <translation>ν (primer orden)</translation>
    </message>
    <message>
        <source>%1 out of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>%1 interval, low</source>
        <translation>Intervalo %1, inferior</translation>
    </message>
    <message>
        <source>%1 interval, high</source>
        <translation>Intervalo %1, superior</translation>
    </message>
    <message>
        <source>Interval, low</source>
        <translation>Intervalo, inferior</translation>
    </message>
    <message>
        <source>Interval, high</source>
        <translation>Intervalo, superior</translation>
    </message>
    <message>
        <source>ballbars</source>
        <translation>ballbars</translation>
    </message>
    <message>
        <source>flange</source>
        <translation>brida</translation>
    </message>
    <message>
        <source>A mean of n observations is drawn from a t distribution with n − 1 degrees of freedom (JCGM 101 6.4.9). Means of simultaneous observations are drawn from one multivariate t distribution with these n − 1 degrees of freedom; with the n − N of JCGM 102 5.3.2 no mean would keep its own distribution.</source>
        <translation>La media de n observaciones se extrae de una distribución t con n − 1 grados de libertad (JCGM 101 6.4.9). Las medias de observaciones simultáneas se extraen de una misma distribución t multivariante con estos n − 1 grados de libertad; con los n − N de JCGM 102 5.3.2 ninguna media conservaría su propia distribución.</translation>
    </message>
    <message>
        <source>if it vanished, U would exceed the target again, with fewer degrees of freedom</source>
        <translation>si desapareciera, U volvería a superar el objetivo, con menos grados de libertad</translation>
    </message>
    <message>
        <source>Unit of the value, and of a and b where they have no other; empty: 1. A difference of temperatures is given in K.</source>
        <translation>Unidad del valor, y de a y b si no tienen otra; vacía: 1. Una diferencia de temperaturas se da en K.</translation>
    </message>
    <message>
        <source>First figure of the statement.</source>
        <translation>Primera cifra de la indicación.</translation>
    </message>
    <message>
        <source>unit of a, b</source>
        <translation>unidad de a, b</translation>
    </message>
    <message>
        <source>Unit of the statement&apos;s figures; empty: the row&apos;s. % and ppm of a quantity that has a unit are parts of its value.</source>
        <translation>Unidad de las cifras de la indicación; vacía: la de la fila. % y ppm de una magnitud con unidad son partes de su valor.</translation>
    </message>
    <message>
        <source>Budget of %1</source>
        <translation>Balance de %1</translation>
    </message>
    <message>
        <source>Two correlated components have half of their covariance each, in the effective degrees of freedom too.</source>
        <translation>Dos componentes correlacionadas tienen cada una la mitad de su covarianza, también en los grados efectivos de libertad.</translation>
    </message>
    <message>
        <source>u along any axis</source>
        <translation>u a lo largo de cada eje</translation>
    </message>
    <message>
        <source>results: in the base frame of the robot</source>
        <translation>resultados: en el sistema de la base del robot</translation>
    </message>
    <message>
        <source>%1: chosen at an end of its range; a wider one can give a better design.</source>
        <translation>%1: elegido en un extremo de su intervalo; uno más amplio puede dar un diseño mejor.</translation>
    </message>
    <message>
        <source>artefact</source>
        <translation>artefacto</translation>
    </message>
    <message>
        <source>length standard</source>
        <translation>patrón de longitud</translation>
    </message>
    <message>
        <source>station</source>
        <translation>estación</translation>
    </message>
    <message>
        <source>field of view</source>
        <translation>campo de visión</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>sin decidir</translation>
    </message>
    <message>
        <source>Of these verdicts, %1 could be the other one with other trials.</source>
        <translation>De estos juicios, %1 podrían ser el contrario con otras pruebas.</translation>
    </message>
    <message>
        <source>the value typed is used, not the mean of the observations, %1</source>
        <translation>se usa el valor escrito, no la media de las observaciones, %1</translation>
    </message>
    <message>
        <source>the correlation coefficient of %1 and %2 must lie between -1 and 1; it is %3</source>
        <translation>el coeficiente de correlación de %1 y %2 debe estar entre -1 y 1; es %3</translation>
    </message>
    <message>
        <source>Both are estimates by sampling, with the standard errors beside them: S can exceed S total by chance.</source>
        <translation>Ambas son estimaciones por muestreo, con los errores típicos al lado: S puede superar a S total por azar.</translation>
    </message>
    <message>
        <source>Any measurement equation with what is known about its quantities: several results, intermediate definitions, conditions, and equations that are solved in every trial.</source>
        <translation>Cualquier ecuación de medición con lo que se sabe de sus magnitudes: varios resultados, definiciones intermedias, condiciones y ecuaciones que se resuelven en cada prueba.</translation>
    </message>
    <message>
        <source>Uncertainty of a measured point</source>
        <translation>Incertidumbre de un punto medido</translation>
    </message>
    <message>
        <source>Residuals of the readings</source>
        <translation>Residuos de las lecturas</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lectura</translation>
    </message>
    <message>
        <source>u of the reading</source>
        <translation>u de la lectura</translation>
    </message>
    <message>
        <source>redundancy</source>
        <translation>redundancia</translation>
    </message>
    <message>
        <source>remark</source>
        <translation>comentario</translation>
    </message>
    <message>
        <source>Fit of the measured points to their nominal coordinates</source>
        <translation>Ajuste de los puntos medidos a sus coordenadas nominales</translation>
    </message>
    <message>
        <source>root mean square residual</source>
        <translation>residuo cuadrático medio</translation>
    </message>
    <message>
        <source>chi-square</source>
        <translation>ji cuadrado</translation>
    </message>
    <message>
        <source>largest normalised residual</source>
        <translation>mayor residuo normalizado</translation>
    </message>
    <message>
        <source>of</source>
        <translation>de</translation>
    </message>
    <message>
        <source>Residuals of the points, along the axes of their frame</source>
        <translation>Residuos de los puntos, a lo largo de los ejes de su sistema</translation>
    </message>
    <message>
        <source>residual x</source>
        <translation>residuo x</translation>
    </message>
    <message>
        <source>residual y</source>
        <translation>residuo y</translation>
    </message>
    <message>
        <source>residual z</source>
        <translation>residuo z</translation>
    </message>
    <message>
        <source>redundancy x</source>
        <translation>redundancia x</translation>
    </message>
    <message>
        <source>redundancy y</source>
        <translation>redundancia y</translation>
    </message>
    <message>
        <source>redundancy z</source>
        <translation>redundancia z</translation>
    </message>
    <message>
        <source>present series</source>
        <translation>serie actual</translation>
    </message>
    <message>
        <source>also reached at x</source>
        <translation>también se alcanza en x</translation>
    </message>
    <message>
        <source>a kept state</source>
        <translation>un estado conservado</translation>
    </message>
    <message>
        <source>two states of the analysis %1 are kept; one can be</source>
        <translation>se conservan dos estados del análisis %1; solo puede haber uno</translation>
    </message>
    <message>
        <source>&apos;digits&apos; must be a whole number from %1 to %2 (JCGM 100 7.2.6)</source>
        <translation>&apos;digits&apos; debe ser un número entero de %1 a %2 (JCGM 100 7.2.6)</translation>
    </message>
    <message>
        <source>the model cannot be evaluated</source>
        <translation>el modelo no puede evaluarse</translation>
    </message>
    <message>
        <source>there is no output quantity &apos;%1&apos; here</source>
        <translation>aquí no hay ninguna magnitud de salida &apos;%1&apos;</translation>
    </message>
    <message>
        <source>from the present values</source>
        <translation>desde los valores actuales</translation>
    </message>
    <message>
        <source>global search</source>
        <translation>búsqueda global</translation>
    </message>
    <message>
        <source>start %1</source>
        <translation>inicio %1</translation>
    </message>
    <message>
        <source>a target uncertainty is not met</source>
        <translation>no se cumple una incertidumbre objetivo</translation>
    </message>
    <message>
        <source>there is no output quantity &apos;%1&apos; then</source>
        <translation>entonces no hay ninguna magnitud de salida &apos;%1&apos;</translation>
    </message>
    <message>
        <source>an uncertainty has no finite value</source>
        <translation>una incertidumbre no tiene valor finito</translation>
    </message>
    <message>
        <source>an uncertainty vanishes: the model is degenerate there</source>
        <translation>una incertidumbre se anula: el modelo es degenerado ahí</translation>
    </message>
    <message>
        <source>all choices</source>
        <translation>todas las elecciones</translation>
    </message>
    <message>
        <source>greedy</source>
        <translation>paso a paso</translation>
    </message>
    <message>
        <source>backward elimination</source>
        <translation>eliminación hacia atrás</translation>
    </message>
    <message>
        <source>exchange</source>
        <translation>intercambio</translation>
    </message>
    <message>
        <source>%1 and %2 are closer than the least distance</source>
        <translation>%1 y %2 están más cerca que la distancia mínima</translation>
    </message>
    <message>
        <source>%1 stands in a box</source>
        <translation>%1 está dentro de una caja</translation>
    </message>
    <message>
        <source>%1 stands in the box &apos;%2&apos;</source>
        <translation>%1 está dentro de la caja &apos;%2&apos;</translation>
    </message>
    <message>
        <source>the line of sight %1 passes a box</source>
        <translation>la línea de visión %1 atraviesa una caja</translation>
    </message>
    <message>
        <source>the line of sight %1 passes the box &apos;%2&apos;</source>
        <translation>la línea de visión %1 atraviesa la caja &apos;%2&apos;</translation>
    </message>
    <message>
        <source>%1 (row %2)</source>
        <translation>%1 (fila %2)</translation>
    </message>
    <message>
        <source>%1: uncertainty too small to be seen</source>
        <translation>%1: incertidumbre demasiado pequeña para verse</translation>
    </message>
    <message>
        <source>uncertainty drawn at %1 of %2 points</source>
        <translation>incertidumbre dibujada en %1 de %2 puntos</translation>
    </message>
    <message>
        <source>standard deviation known before (Type A)</source>
        <translation>desviación típica conocida de antes (Tipo A)</translation>
    </message>
    <message>
        <source>share of the variance, first order</source>
        <translation>parte de la varianza, primer orden</translation>
    </message>
    <message>
        <source>change, relative to the variance before</source>
        <translation>cambio, respecto a la varianza anterior</translation>
    </message>
    <message>
        <source>growth of the objective without it</source>
        <translation>aumento del objetivo sin ella</translation>
    </message>
    <message>
        <source>the number of observations in the mean must be at least one</source>
        <translation>el número de observaciones en la media debe ser al menos uno</translation>
    </message>
    <message>
        <source>results: in the frame of the sensor</source>
        <translation>resultados: en el sistema del sensor</translation>
    </message>
    <message>
        <source>time</source>
        <translation>tiempo</translation>
    </message>
    <message>
        <source>net reading</source>
        <translation>lectura neta</translation>
    </message>
    <message>
        <source>deviation from the line</source>
        <translation>desviación de la recta</translation>
    </message>
    <message>
        <source>Design: twelve points of a ballbar measurement</source>
        <translation>Diseño: doce puntos de una medición con barras de bolas</translation>
    </message>
    <message>
        <source>Tool centre point of a robot by telescopic ballbars</source>
        <translation>Punto central de la herramienta de un robot con barras de bolas telescópicas</translation>
    </message>
    <message>
        <source>From the certificate of a scale bar to the tool of a robot</source>
        <translation>Del certificado de una regla patrón a la herramienta de un robot</translation>
    </message>
    <message>
        <source>Industrial robot ER10L-C10</source>
        <translation>Robot industrial ER10L-C10</translation>
    </message>
    <message>
        <source>Six-axis force/moment sensor</source>
        <translation>Sensor de fuerza/momento de seis ejes</translation>
    </message>
    <message>
        <source>Scale bar in a network of three cameras and a laser tracker</source>
        <translation>Regla patrón en una red de tres cámaras y un láser tracker</translation>
    </message>
    <message>
        <source>Stewart platform measured with a total station</source>
        <translation>Plataforma Stewart medida con una estación total</translation>
    </message>
    <message>
        <source>Pose of a Stewart platform measured by a network</source>
        <translation>Pose de una plataforma Stewart medida por una red</translation>
    </message>
    <message>
        <source>End-gauge calibration (GUM H.1)</source>
        <translation>Calibración de un bloque patrón (GUM H.1)</translation>
    </message>
    <message>
        <source>Simultaneous resistance and reactance (GUM H.2)</source>
        <translation>Resistencia y reactancia simultáneas (GUM H.2)</translation>
    </message>
    <message>
        <source>Calibration of a thermometer (GUM H.3)</source>
        <translation>Calibración de un termómetro (GUM H.3)</translation>
    </message>
    <message>
        <source>Zener voltage standard on ten days (GUM H.5)</source>
        <translation>Patrón de tensión Zener en diez días (GUM H.5)</translation>
    </message>
    <message>
        <source>JCGM 100:2008, Annex H.5, Table H.9: five observations on each of ten days, and the analysis of variance that says whether the days have an effect.</source>
        <translation>JCGM 100:2008, anexo H.5, tabla H.9: cinco observaciones en cada uno de diez días y el análisis de varianza que dice si los días tienen efecto.</translation>
    </message>
    <message>
        <source>Additive model (GUM Supplement 1, 9.2)</source>
        <translation>Modelo aditivo (Suplemento 1 de la GUM, 9.2)</translation>
    </message>
    <message>
        <source>JCGM 101:2008, clause 9.2: a sum of four quantities with three choices of their distributions, and the validation of clause 8.</source>
        <translation>JCGM 101:2008, apartado 9.2: una suma de cuatro magnitudes con tres elecciones de sus distribuciones, y la validación del apartado 8.</translation>
    </message>
    <message>
        <source>Mass calibration (GUM Supplement 1, 9.3)</source>
        <translation>Calibración de masa (Suplemento 1 de la GUM, 9.3)</translation>
    </message>
    <message>
        <source>JCGM 101:2008, clause 9.3: a weight of 100 g is compared with a reference weight in air; to first order the densities seem not to matter.</source>
        <translation>JCGM 101:2008, apartado 9.3: una pesa de 100 g se compara en el aire con una pesa de referencia; a primer orden, las densidades parecen no importar.</translation>
    </message>
    <message>
        <source>Comparison loss of a power meter (GUM Supplement 1, 9.4)</source>
        <translation>Pérdida de comparación de un medidor de potencia (Suplemento 1 de la GUM, 9.4)</translation>
    </message>
    <message>
        <source>JCGM 101:2008, clause 9.4, Tables 8 and 9: a sum of two squares near zero, where the law of propagation fails.</source>
        <translation>JCGM 101:2008, apartado 9.4, tablas 8 y 9: una suma de dos cuadrados cerca de cero, donde falla la ley de propagación.</translation>
    </message>
    <message>
        <source>Gauge-block calibration (GUM Supplement 1, 9.5)</source>
        <translation>Calibración de un bloque patrón (Suplemento 1 de la GUM, 9.5)</translation>
    </message>
    <message>
        <source>JCGM 101:2008, clause 9.5: the end gauge of GUM H.1 with the distributions of Table 10.</source>
        <translation>JCGM 101:2008, apartado 9.5: el bloque patrón de la GUM H.1 con las distribuciones de la tabla 10.</translation>
    </message>
    <message>
        <source>Two sums with a common term (GUM Supplement 2, 9.2)</source>
        <translation>Dos sumas con un término común (Suplemento 2 de la GUM, 9.2)</translation>
    </message>
    <message>
        <source>JCGM 102:2011, clause 9.2: a bivariate additive model with standard normal quantities.</source>
        <translation>JCGM 102:2011, apartado 9.2: un modelo aditivo bivariado con magnitudes normales estándar.</translation>
    </message>
    <message>
        <source>Cartesian to polar co-ordinates (GUM Supplement 2, 9.3)</source>
        <translation>De coordenadas cartesianas a polares (Suplemento 2 de la GUM, 9.3)</translation>
    </message>
    <message>
        <source>JCGM 102:2011, clause 9.3, Tables 6 and 7: magnitude and phase of a small complex quantity.</source>
        <translation>JCGM 102:2011, apartado 9.3, tablas 6 y 7: módulo y fase de una magnitud compleja pequeña.</translation>
    </message>
    <message>
        <source>Resistance and reactance by Monte Carlo (GUM Supplement 2, 9.4)</source>
        <translation>Resistencia y reactancia por Monte Carlo (Suplemento 2 de la GUM, 9.4)</translation>
    </message>
    <message>
        <source>JCGM 102:2011, clause 9.4: the impedance of GUM H.2 with trivariate normal input quantities and the joint coverage region of R and X.</source>
        <translation>JCGM 102:2011, apartado 9.4: la impedancia de la GUM H.2 con magnitudes de entrada normales trivariadas y la región de cobertura conjunta de R y X.</translation>
    </message>
    <message>
        <source>JCGM 100:2008, Annex H.1: a gauge block of 50 mm is compared with a standard; first- and second-order law of propagation.</source>
        <translation>JCGM 100:2008, anexo H.1: un bloque patrón de 50 mm se compara con un patrón; ley de propagación de primer y segundo orden.</translation>
    </message>
    <message>
        <source>JCGM 100:2008, Annex H.2: five simultaneous observations of voltage, current and phase give three correlated results.</source>
        <translation>JCGM 100:2008, anexo H.2: cinco observaciones simultáneas de tensión, corriente y fase dan tres resultados correlacionados.</translation>
    </message>
    <message>
        <source>JCGM 100:2008, Annex H.3: the correction b of a thermometer at eleven temperatures, and the straight line through them: b(t) = y₁ + y₂ (t − 20 °C).</source>
        <translation>JCGM 100:2008, anexo H.3: la corrección b de un termómetro a once temperaturas y la recta que pasa por ellas: b(t) = y₁ + y₂ (t − 20 °C).</translation>
    </message>
    <message>
        <source>Which twelve of the 22 points of a ballbar measurement make the uncertainty of the tool centre point smallest.</source>
        <translation>Qué doce de los 22 puntos de una medición con barras de bolas hacen mínima la incertidumbre del punto central de la herramienta.</translation>
    </message>
    <message>
        <source>Three telescopic ballbars measure points on spheres and circles; from them follow the flange, its axes and the tool.</source>
        <translation>Tres barras de bolas telescópicas miden puntos sobre esferas y círculos; de ellos resultan la brida, sus ejes y la herramienta.</translation>
    </message>
    <message>
        <source>Scale bar, two trackers, flange, identified arm and tool: analyses that feed each other, evaluated as one model.</source>
        <translation>Regla patrón, dos trackers, brida, brazo identificado y herramienta: análisis que se alimentan unos a otros, evaluados como un solo modelo.</translation>
    </message>
    <message>
        <source>Parameters of an arm of six axes, identified from measured places, and the position of its end effector.</source>
        <translation>Parámetros de un brazo de seis ejes, identificados a partir de lugares medidos, y la posición de su efector final.</translation>
    </message>
    <message>
        <source>Rated output, zero, repeatability and interference of three forces and three moments.</source>
        <translation>Salida nominal, cero, repetibilidad e interferencia de tres fuerzas y tres momentos.</translation>
    </message>
    <message>
        <source>Distances on a scale bar that three cameras and a laser tracker measure together.</source>
        <translation>Distancias en una regla patrón que tres cámaras y un láser tracker miden juntos.</translation>
    </message>
    <message>
        <source>Pose of a platform from six measured points, whose uncertainties come from calibrated artefacts.</source>
        <translation>Pose de una plataforma a partir de seis puntos medidos, cuyas incertidumbres vienen de artefactos calibrados.</translation>
    </message>
    <message>
        <source>Sensor layout, points and pose in one chain: a laser tracker and a total station measure six nests of a platform.</source>
        <translation>Disposición de sensores, puntos y pose en una cadena: un láser tracker y una estación total miden seis alojamientos de una plataforma.</translation>
    </message>
    <message>
        <source>%1 in line %2</source>
        <translation>%1 en la línea %2</translation>
    </message>
    <message>
        <source>columns between tabs</source>
        <translation>columnas entre tabuladores</translation>
    </message>
    <message>
        <source>columns between semicolons</source>
        <translation>columnas entre puntos y comas</translation>
    </message>
    <message>
        <source>columns between commas</source>
        <translation>columnas entre comas</translation>
    </message>
    <message>
        <source>columns between blanks, decimal commas</source>
        <translation>columnas entre espacios, comas decimales</translation>
    </message>
    <message>
        <source>columns between blanks</source>
        <translation>columnas entre espacios</translation>
    </message>
    <message>
        <source>all %1 met</source>
        <translation>los %1 cumplidos</translation>
    </message>
    <message>
        <source>%1 of %2 not met</source>
        <translation>%1 de %2 no cumplidos</translation>
    </message>
    <message>
        <source>Requirements</source>
        <translation>Requisitos</translation>
    </message>
    <message>
        <source>Requirements: %1</source>
        <translation>Requisitos: %1</translation>
    </message>
    <message>
        <source>min Σ w (reading − h(X))²</source>
        <translation>min Σ w (lectura − h(X))²</translation>
    </message>
    <message>
        <source>least squares: R maximises tr(Rᵀ Σ (q_i − q̄) l_iᵀ),  o = q̄ − R l̄</source>
        <translation>mínimos cuadrados: R maximiza tr(Rᵀ Σ (q_i − q̄) l_iᵀ),  o = q̄ − R l̄</translation>
    </message>
    <message>
        <source>Z = ± √(L₁² − X² − Y²);  no value where the root is negative</source>
        <translation>Z = ± √(L₁² − X² − Y²);  sin valor donde la raíz es negativa</translation>
    </message>
    <message>
        <source>min Σ w (L_j − |M − KS_j|)², Gauss-Newton from Eqs 1-3</source>
        <translation>min Σ w (L_j − |M − KS_j|)², Gauss-Newton desde Ecs. 1-3</translation>
    </message>
    <message>
        <source>L_j = |P_i + e_i + R_i (ω_i × t) − KS_j| + reading&apos;s deviation</source>
        <translation>L_j = |P_i + e_i + R_i (ω_i × t) − KS_j| + desviación de la lectura</translation>
    </message>
    <message>
        <source>n_x, n_y: planes of the arcs by total least squares;  C: sphere through all points</source>
        <translation>n_x, n_y: planos de los arcos por mínimos cuadrados totales;  C: esfera por todos los puntos</translation>
    </message>
    <message>
        <source>TCP = mean of Rot_iᵀ Fᵀ (M_i − C)</source>
        <translation>TCP = media de Rot_iᵀ Fᵀ (M_i − C)</translation>
    </message>
    <message>
        <source>JCGM 102 6.2, with all that points and readings share</source>
        <translation>JCGM 102 6.2, con todo lo que comparten puntos y lecturas</translation>
    </message>
    <message>
        <source>n·p = D with |n| = 1, least sum of squares</source>
        <translation>n·p = D con |n| = 1, suma de cuadrados mínima</translation>
    </message>
    <message>
        <source>min Σ (|p_j − c| − R)²  in the fitted plane</source>
        <translation>min Σ (|p_j − c| − R)²  en el plano ajustado</translation>
    </message>
    <message>
        <source>x_i = ± z_{i−1} × z_i/|…|,  O_i: foot of the common perpendicular on axis i + 1</source>
        <translation>x_i = ± z_{i−1} × z_i/|…|,  O_i: pie de la perpendicular común en el eje i + 1</translation>
    </message>
    <message>
        <source>parallel: O_i in the plane through O_{i−1} normal to z_{i−1},  y_i = z_i × h/|…|,  x_i = y_i × z_i</source>
        <translation>paralelos: O_i en el plano por O_{i−1} normal a z_{i−1},  y_i = z_i × h/|…|,  x_i = y_i × z_i</translation>
    </message>
    <message>
        <source>S_hc = Σ L d_h/Σ L²  over the increasing readings under load c</source>
        <translation>S_hc = Σ L d_h/Σ L²  sobre las lecturas crecientes bajo la carga c</translation>
    </message>
    <message>
        <source>V = S L,  L = C V  with  C = S⁻¹</source>
        <translation>V = S L,  L = C V  con  C = S⁻¹</translation>
    </message>
    <message>
        <source>V_h = Σ_c (S_hc L_c + Q_hc L_c²),  by Newton&apos;s method from L = C V</source>
        <translation>V_h = Σ_c (S_hc L_c + Q_hc L_c²),  por el método de Newton desde L = C V</translation>
    </message>
    <message>
        <source>V_h = d_h + repeatability + resolution + non-zero + hysteresis</source>
        <translation>V_h = d_h + repetibilidad + resolución + desviación del cero + histéresis</translation>
    </message>
    <message>
        <source>S_hc = fitted + regression + S_hc δ_c</source>
        <translation>S_hc = valor ajustado + regresión + S_hc δ_c</translation>
    </message>
    <message>
        <source>d_hij = d′_hij − d_h0j,  d_hi = mean over j,  s_hi,  u_A = max s_hi/√n</source>
        <translation>d_hij = d′_hij − d_h0j,  d_hi = media sobre j,  s_hi,  u_A = max s_hi/√n</translation>
    </message>
    <message>
        <source>JCGM 100, Eq 1</source>
        <translation>JCGM 100, Ec. 1</translation>
    </message>
    <message>
        <source>JCGM 100, Eqs H.24, H.25, for groups of any size</source>
        <translation>JCGM 100, Ecs. H.24, H.25, para grupos de cualquier tamaño</translation>
    </message>
    <message>
        <source>groups included, JCGM 100 H.5.2.3</source>
        <translation>grupos incluidos, JCGM 100 H.5.2.3</translation>
    </message>
    <message>
        <source>components of variance, Searle et al. 1992</source>
        <translation>componentes de la varianza, Searle et al. 1992</translation>
    </message>
    <message>
        <source>groups not included, JCGM 100, Eq H.28</source>
        <translation>grupos no incluidos, JCGM 100, Ec. H.28</translation>
    </message>
    <message>
        <source>JCGM 100, Eq H.12</source>
        <translation>JCGM 100, Ec. H.12</translation>
    </message>
    <message>
        <source>from the residuals, JCGM 100 H.3.2</source>
        <translation>de los residuos, JCGM 100 H.3.2</translation>
    </message>
    <message>
        <source>as stated, York et al. 2004</source>
        <translation>como se indica, York et al. 2004</translation>
    </message>
    <message>
        <source>it must be an analysis of the kept state and have a name (otherName)</source>
        <translation>debe ser un análisis del estado conservado y tener un nombre (otherName)</translation>
    </message>
    <message>
        <source>Dimensions are checked where the equations are read; plane angle counts as a number, because the radian is one in the SI. A temperature in °C is taken in kelvin only where two make a ratio; a difference of temperatures is given in K.</source>
        <translation>Las dimensiones se comprueban donde se leen las ecuaciones; el ángulo plano cuenta como número, porque el radián lo es en el SI. Una temperatura en °C solo se toma en kelvin donde dos forman una razón; una diferencia de temperaturas se da en K.</translation>
    </message>
    <message>
        <source>Angles that inverse functions give or that were read, their sums and whole multiples are on the circle where the result is given in a unit of angle.</source>
        <translation>Los ángulos que dan las funciones inversas o que se han leído, sus sumas y sus múltiplos enteros están en el círculo donde el resultado se da en una unidad de ángulo.</translation>
    </message>
    <message>
        <source>One equation a line: y = x_1*x_2 + x_3. Names without an equation are input quantities; a number has its unit in brackets: 3 [mm]. &apos;solve y = 1: y^2 = x&apos; finds y in every trial, from its starting value. complex(a, b) and polar(r, phi) make complex numbers, re, im, abs and arg real ones of them. &apos;#&apos; starts a comment.</source>
        <translation>Una ecuación por línea: y = x_1*x_2 + x_3. Los nombres sin ecuación son magnitudes de entrada; un número lleva su unidad entre corchetes: 3 [mm]. &apos;solve y = 1: y^2 = x&apos; halla y en cada ensayo, desde su valor inicial. complex(a, b) y polar(r, phi) forman números complejos; re, im, abs y arg, reales a partir de ellos. &apos;#&apos; empieza un comentario.</translation>
    </message>
    <message>
        <source>How its uncertainty is known; a and b are then: u; s and n; U and k; U and p in %; half-width (and inexactness, or ratio of top to base); lower and upper limit; step of the indication; permissible error and % of the value; number of counts; number of observations in the mean (pooled); standard deviation (Laplace, Weibull about the value), scale (and shape); expected number of events; number of trials and probability in %. A sample is drawn as it is listed among the observations, a histogram has the edges of its cells there. Empty: a constant.</source>
        <translation>Cómo se conoce su incertidumbre; a y b son entonces: u; s y n; U y k; U y p en %; semiancho (e inexactitud, o razón de arriba a base); límite inferior y superior; paso de la indicación; error permitido y % del valor; número de cuentas; número de observaciones en la media (combinada); desviación típica (Laplace, Weibull en torno al valor), escala (y forma); número esperado de sucesos; número de pruebas y probabilidad en %. Una muestra se sortea como figura entre las observaciones; un histograma tiene allí los bordes de sus celdas. Vacío: una constante.</translation>
    </message>
    <message>
        <source>Laplace, standard deviation</source>
        <translation>Laplace, desviación típica</translation>
    </message>
    <message>
        <source>Laplace, scale</source>
        <translation>Laplace, escala</translation>
    </message>
    <message>
        <source>Weibull, scale and shape</source>
        <translation>Weibull, escala y forma</translation>
    </message>
    <message>
        <source>Weibull, standard deviation</source>
        <translation>Weibull, desviación típica</translation>
    </message>
    <message>
        <source>Poisson</source>
        <translation>Poisson</translation>
    </message>
    <message>
        <source>binomial</source>
        <translation>binomial</translation>
    </message>
    <message>
        <source>sample of values</source>
        <translation>muestra de valores</translation>
    </message>
    <message>
        <source>histogram</source>
        <translation>histograma</translation>
    </message>
    <message>
        <source>ensemble</source>
        <translation>conjunto</translation>
    </message>
    <message>
        <source>Name of the evaluation that gave several quantities together, with one and the same nu: their uncertainties rest on one estimate of variance, and they are drawn from a multivariate t distribution (JCGM 102 5.3.2). Correlation coefficients between them stand with the correlations of the analysis.</source>
        <translation>Nombre de la evaluación que dio varias magnitudes juntas, con un mismo nu: sus incertidumbres se apoyan en una sola estimación de la varianza y se sortean de una distribución t multivariante (JCGM 102 5.3.2). Los coeficientes de correlación entre ellas están con las correlaciones del análisis.</translation>
    </message>
    <message>
        <source>Observed value, value of a sample or edge of a histogram, in the unit of the quantity.</source>
        <translation>Valor observado, valor de una muestra o borde de un histograma, en la unidad de la magnitud.</translation>
    </message>
    <message>
        <source>weight</source>
        <translation>peso</translation>
    </message>
    <message>
        <source>Of a value of a sample, or of the cell of a histogram that begins at this edge: counts, or parts of any sum. Empty: one in a sample, none behind the last edge.</source>
        <translation>De un valor de una muestra, o de la celda de un histograma que empieza en este borde: cuentas, o partes de una suma cualquiera. Vacío: uno en una muestra, ninguno tras el último borde.</translation>
    </message>
    <message>
        <source>Covariance of the points</source>
        <translation>Covarianza de los puntos</translation>
    </message>
    <message>
        <source>Common u of x</source>
        <translation>u común de x</translation>
    </message>
    <message>
        <source>Standard uncertainty of a deviation that all x share beside their own (one standard, one temperature), in the unit of x. Used with stated uncertainties, in the weights too.</source>
        <translation>Incertidumbre típica de una desviación que comparten todas las x además de la propia (un patrón, una temperatura), en la unidad de x. Se usa con incertidumbres declaradas, también en los pesos.</translation>
    </message>
    <message>
        <source>Common u of y</source>
        <translation>u común de y</translation>
    </message>
    <message>
        <source>Likewise of all y, in the unit of y.</source>
        <translation>Lo mismo de todas las y, en la unidad de y.</translation>
    </message>
    <message>
        <source>Correlations of the points</source>
        <translation>Correlaciones de los puntos</translation>
    </message>
    <message>
        <source>Correlation coefficients between coordinates of the points (ISO/TS 28037): they change the curve, which minimises v^T V^-1 v, and its uncertainty. Used with stated uncertainties.</source>
        <translation>Coeficientes de correlación entre coordenadas de los puntos (ISO/TS 28037): cambian la curva, que minimiza v^T V^-1 v, y su incertidumbre. Se usan con incertidumbres declaradas.</translation>
    </message>
    <message>
        <source>A coordinate of a point by its number: y_1 is the y of the first point.</source>
        <translation>Una coordenada de un punto por su número: y_1 es la y del primer punto.</translation>
    </message>
    <message>
        <source>Another one: y_2, or the x_1 of the same point.</source>
        <translation>Otra: y_2, o la x_1 del mismo punto.</translation>
    </message>
    <message>
        <source>coefficient</source>
        <translation>coeficiente</translation>
    </message>
    <message>
        <source>Correlation coefficient of their stated uncertainties.</source>
        <translation>Coeficiente de correlación de sus incertidumbres declaradas.</translation>
    </message>
    <message>
        <source>Certificate of a gauge block of 50 mm</source>
        <translation>Certificado de un bloque patrón de 50 mm</translation>
    </message>
    <message>
        <source>A gauge block is compared with a standard of the same length, by the model of EA-4/02, S4; its certificate says all that ISO/IEC 17025 7.8 asks for.</source>
        <translation>Un bloque patrón se compara con un patrón de la misma longitud, según el modelo de EA-4/02, S4; su certificado dice todo lo que pide ISO/IEC 17025 7.8.</translation>
    </message>
    <message>
        <source>Conformity of a micrometer</source>
        <translation>Conformidad de un micrómetro</translation>
    </message>
    <message>
        <source>Errors of indication of a micrometer of 25 mm at four gauge blocks, and whether they conform with a maximum permissible error of 4 µm under the decision rule of ISO 14253-1.</source>
        <translation>Errores de indicación de un micrómetro de 25 mm en cuatro bloques patrón, y si cumplen un error máximo permitido de 4 µm con la regla de decisión de ISO 14253-1.</translation>
    </message>
    <message>
        <source>A budget from Excel</source>
        <translation>Un balance de Excel</translation>
    </message>
    <message>
        <source>What &apos;covaria import excel-budget.xlsx&apos; makes of a budget in a spreadsheet, with the columns of EA-4/02.</source>
        <translation>Lo que &apos;covaria import excel-budget.xlsx&apos; hace de un balance en una hoja de cálculo, con las columnas de EA-4/02.</translation>
    </message>
    <message>
        <source>Gewichtsstück von 10 kg</source>
        <translation>Pesa de 10 kg</translation>
    </message>
    <message>
        <source>Kalibrierung eines Gewichtsstücks nach EA-4/02, S2: ein Beispiel in deutscher Sprache, mit vollständigem Kalibrierschein.</source>
        <translation>Calibración de una pesa según EA-4/02, S2: un ejemplo en alemán, con certificado completo.</translation>
    </message>
    <message>
        <source>Guard band</source>
        <translation>Banda de seguridad</translation>
    </message>
    <message>
        <source>How the guard band follows: by the guard factor, by the ratio TUR of tolerance and U (both limits are needed), or so narrow as a target risk allows (global risks need a prior).</source>
        <translation>Cómo resulta la banda de seguridad: del factor de seguridad, de la razón TUR de tolerancia y U (hacen falta ambos límites), o tan estrecha como permite un riesgo objetivo (los riesgos globales necesitan un conocimiento previo).</translation>
    </message>
    <message>
        <source>Target risk</source>
        <translation>Riesgo objetivo</translation>
    </message>
    <message>
        <source>That the guard band is made for, above 0 and up to 0.5: 0.02 or 2 %.</source>
        <translation>Para el que se hace la banda de seguridad, mayor que 0 y hasta 0.5: 0.02 o 2 %.</translation>
    </message>
    <message>
        <source>guard factor times U</source>
        <translation>factor de seguridad por U</translation>
    </message>
    <message>
        <source>RSS: root of T²/4 − U²</source>
        <translation>RSS: raíz de T²/4 − U²</translation>
    </message>
    <message>
        <source>NCSL RP-10: 1.25 − 1/TUR</source>
        <translation>NCSL RP-10: 1.25 − 1/TUR</translation>
    </message>
    <message>
        <source>managed (Dobbert): at most 2 % false accepts</source>
        <translation>gestionada (Dobbert): a lo sumo 2 % de aceptaciones falsas</translation>
    </message>
    <message>
        <source>to a specific risk at the acceptance limit</source>
        <translation>a un riesgo específico en el límite de aceptación</translation>
    </message>
    <message>
        <source>to a global consumer&apos;s risk</source>
        <translation>a un riesgo global del consumidor</translation>
    </message>
    <message>
        <source>to a risk of what is accepted</source>
        <translation>a un riesgo de lo aceptado</translation>
    </message>
    <message>
        <source>Site of calibration</source>
        <translation>Lugar de calibración</translation>
    </message>
    <message>
        <source>Whose place it was done at; empty: in the laboratory, or elsewhere where a place is stated.</source>
        <translation>En casa de quién se hizo; vacío: en el laboratorio, o en otra parte donde se indica un lugar.</translation>
    </message>
    <message>
        <source>Where it was done if not in the laboratory: the customer&apos;s hall, the field.</source>
        <translation>Dónde se hizo si no fue en el laboratorio: la nave del cliente, el campo.</translation>
    </message>
    <message>
        <source>To which a statement of conformity refers: the standard or drawing, with its edition.</source>
        <translation>A qué se refiere una declaración de conformidad: la norma o el plano, con su edición.</translation>
    </message>
    <message>
        <source>at the customer</source>
        <translation>en casa del cliente</translation>
    </message>
    <message>
        <source>in a branch of the laboratory</source>
        <translation>en una sucursal del laboratorio</translation>
    </message>
    <message>
        <source>in a branch of the customer</source>
        <translation>en una sucursal del cliente</translation>
    </message>
    <message>
        <source>elsewhere</source>
        <translation>en otra parte</translation>
    </message>
    <message>
        <source>RSS guard band</source>
        <translation>banda de seguridad RSS</translation>
    </message>
    <message>
        <source>NCSL RP-10 guard band</source>
        <translation>banda de seguridad NCSL RP-10</translation>
    </message>
    <message>
        <source>managed guard band (Dobbert, 2 % false accepts)</source>
        <translation>banda de seguridad gestionada (Dobbert, 2 % de aceptaciones falsas)</translation>
    </message>
    <message>
        <source>guard band to a specific risk of %1</source>
        <translation>banda de seguridad a un riesgo específico de %1</translation>
    </message>
    <message>
        <source>guard band to a global consumer&apos;s risk of %1</source>
        <translation>banda de seguridad a un riesgo global del consumidor de %1</translation>
    </message>
    <message>
        <source>guard band to a risk of %1 of what is accepted</source>
        <translation>banda de seguridad a un riesgo de %1 de lo aceptado</translation>
    </message>
    <message>
        <source>pass (accepted)</source>
        <translation>pasa (aceptado)</translation>
    </message>
    <message>
        <source>fail (rejected)</source>
        <translation>no pasa (rechazado)</translation>
    </message>
    <message>
        <source>January</source>
        <translation>enero</translation>
    </message>
    <message>
        <source>February</source>
        <translation>febrero</translation>
    </message>
    <message>
        <source>March</source>
        <translation>marzo</translation>
    </message>
    <message>
        <source>April</source>
        <translation>abril</translation>
    </message>
    <message>
        <source>May</source>
        <translation>mayo</translation>
    </message>
    <message>
        <source>June</source>
        <translation>junio</translation>
    </message>
    <message>
        <source>July</source>
        <translation>julio</translation>
    </message>
    <message>
        <source>August</source>
        <translation>agosto</translation>
    </message>
    <message>
        <source>September</source>
        <translation>septiembre</translation>
    </message>
    <message>
        <source>October</source>
        <translation>octubre</translation>
    </message>
    <message>
        <source>November</source>
        <translation>noviembre</translation>
    </message>
    <message>
        <source>December</source>
        <translation>diciembre</translation>
    </message>
    <message>
        <source>%1 %2 %3</source>
        <translation>%1 de %2 de %3</translation>
    </message>
    <message>
        <source>required by %1 where conformity is stated</source>
        <translation>exigido por %1 donde se declara conformidad</translation>
    </message>
    <message>
        <source>%1 is the unit of a temperature, and the quantity is given in %2, in which it may be a difference: give both in %1, or both in %2</source>
        <translation>%1 es la unidad de una temperatura, y la magnitud se da en %2, donde puede ser una diferencia: dé ambas en %1, o ambas en %2</translation>
    </message>
    <message>
        <source>%1 is a difference of temperatures, and %2 a temperature in %3: take a temperature, or give %2 in K</source>
        <translation>%1 es una diferencia de temperaturas, y %2 una temperatura en %3: tome una temperatura, o dé %2 en K</translation>
    </message>
    <message>
        <source>%1 is given in %2, which may be a difference of temperatures, and %3 is a temperature in %4: give both in %4, or both in K</source>
        <translation>%1 se da en %2, que puede ser una diferencia de temperaturas, y %3 es una temperatura en %4: dé ambas en %4, o ambas en K</translation>
    </message>
    <message>
        <source>%1 is a temperature in %2, and %3 is given in %4, which may be a difference of temperatures: give both in %2, or both in K</source>
        <translation>%1 es una temperatura en %2, y %3 se da en %4, que puede ser una diferencia de temperaturas: dé ambas en %2, o ambas en K</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is complex, so that &apos;%2&apos; is a part of it: to use a part write re(%1) or im(%1), else choose another name</source>
        <translation>&apos;%1&apos; es complejo, de modo que &apos;%2&apos; es una parte suya: para usar una parte escriba re(%1) o im(%1); si no, elija otro nombre</translation>
    </message>
    <message>
        <source>a complex unknown counts twice, and so does a complex equation: there are %1 real unknowns and %2 real equations</source>
        <translation>una incógnita compleja cuenta doble, y también una ecuación compleja: hay %1 incógnitas reales y %2 ecuaciones reales</translation>
    </message>
    <message>
        <source>modulus and argument</source>
        <translation>módulo y argumento</translation>
    </message>
    <message>
        <source>real and imaginary part</source>
        <translation>parte real e imaginaria</translation>
    </message>
    <message>
        <source>%1 of a complex number are real; one of them is complex here</source>
        <translation>%1 de un número complejo son reales; aquí uno de ellos es complejo</translation>
    </message>
    <message>
        <source>complex numbers have no order and are no condition: compare re, im, abs or arg of them</source>
        <translation>los números complejos no tienen orden y no son una condición: compare re, im, abs o arg de ellos</translation>
    </message>
    <message>
        <source>this function is one of real numbers; for a complex one there are + - * / ^, exp, log, sqrt, sin, cos, tan, sinh, cosh, tanh, conj, abs, arg, re and im</source>
        <translation>esta función es de números reales; para uno complejo hay + - * / ^, exp, log, sqrt, sin, cos, tan, sinh, cosh, tanh, conj, abs, arg, re e im</translation>
    </message>
    <message>
        <source>%1 unknowns are too many to be solved together: the time for each trial grows with the cube of their number, so the limit is %2; solve what does not depend on the rest in systems of its own</source>
        <translation>%1 incógnitas son demasiadas para resolverlas juntas: el tiempo de cada ensayo crece con el cubo de su número, por eso el límite es %2; resuelva en sistemas propios lo que no depende del resto</translation>
    </message>
    <message>
        <source>the expected number of events gives the estimate: leave the value empty, or the number</source>
        <translation>el número esperado de sucesos da la estimación: deje vacío el valor, o el número</translation>
    </message>
    <message>
        <source>the expected number of events is missing: state it, or the value</source>
        <translation>falta el número esperado de sucesos: indíquelo, o el valor</translation>
    </message>
    <message>
        <source>trials and probability give the estimate: leave the value empty, or the probability</source>
        <translation>las pruebas y la probabilidad dan la estimación: deje vacío el valor, o la probabilidad</translation>
    </message>
    <message>
        <source>the probability of each trial is missing: state it, or the value</source>
        <translation>falta la probabilidad de cada prueba: indíquela, o el valor</translation>
    </message>
    <message>
        <source>the number of trials must be at least one</source>
        <translation>el número de pruebas debe ser al menos uno</translation>
    </message>
    <message>
        <source>the probability of each trial must lie between 0 and 100 %</source>
        <translation>la probabilidad de cada prueba debe estar entre 0 y 100 %</translation>
    </message>
    <message>
        <source>the value must lie between 0 and the number of trials</source>
        <translation>el valor debe estar entre 0 y el número de pruebas</translation>
    </message>
    <message>
        <source>scale and shape give the estimate: leave the value empty, or state the standard deviation alone</source>
        <translation>la escala y la forma dan la estimación: deje vacío el valor, o indique solo la desviación típica</translation>
    </message>
    <message>
        <source>a Weibull distribution needs a value greater than zero, which is its mean</source>
        <translation>una distribución de Weibull necesita un valor mayor que cero, que es su media</translation>
    </message>
    <message>
        <source>no Weibull distribution has such a ratio of standard deviation to mean: it must lie between 0.000002 and 429</source>
        <translation>ninguna distribución de Weibull tiene tal razón de desviación típica a media: debe estar entre 0.000002 y 429</translation>
    </message>
    <message>
        <source>observations have no weights: for values with weights write sample 1; 2; 3 weights 2; 5; 2</source>
        <translation>las observaciones no tienen pesos: para valores con pesos escriba sample 1; 2; 3 weights 2; 5; 2</translation>
    </message>
    <message>
        <source>weights have no unit</source>
        <translation>los pesos no tienen unidad</translation>
    </message>
    <message>
        <source>a histogram has one edge more than weights: histogram 0; 1; 2 weights 5; 8</source>
        <translation>un histograma tiene un borde más que pesos: histogram 0; 1; 2 weights 5; 8</translation>
    </message>
    <message>
        <source>there must be as many weights as values</source>
        <translation>debe haber tantos pesos como valores</translation>
    </message>
    <message>
        <source>the weights of the cells are missing: histogram 0; 1; 2 weights 5; 8</source>
        <translation>faltan los pesos de las celdas: histogram 0; 1; 2 weights 5; 8</translation>
    </message>
    <message>
        <source>write the probability as p = 0.02 or p = 2 %</source>
        <translation>escriba la probabilidad como p = 0.02 o p = 2 %</translation>
    </message>
    <message>
        <source>location</source>
        <translation>posición</translation>
    </message>
    <message>
        <source>the shape must lie between 0.1 and 1000000.</source>
        <translation>la forma debe estar entre 0.1 y 1000000.</translation>
    </message>
    <message>
        <source>value without an event</source>
        <translation>valor sin suceso</translation>
    </message>
    <message>
        <source>the expected number of events must lie between 0 and 10000000; beyond it a normal distribution says the same.</source>
        <translation>el número esperado de sucesos debe estar entre 0 y 10000000; más allá, una distribución normal dice lo mismo.</translation>
    </message>
    <message>
        <source>the number of trials must be a whole number up to 10000000; beyond it a normal distribution says the same.</source>
        <translation>el número de pruebas debe ser un entero hasta 10000000; más allá, una distribución normal dice lo mismo.</translation>
    </message>
    <message>
        <source>the probability must lie between 0 and 1.</source>
        <translation>la probabilidad debe estar entre 0 y 1.</translation>
    </message>
    <message>
        <source>a histogram needs at least one cell.</source>
        <translation>un histograma necesita al menos una celda.</translation>
    </message>
    <message>
        <source>there must be one edge more than probabilities.</source>
        <translation>debe haber un borde más que probabilidades.</translation>
    </message>
    <message>
        <source>edges</source>
        <translation>bordes</translation>
    </message>
    <message>
        <source>the edges must rise.</source>
        <translation>los bordes deben crecer.</translation>
    </message>
    <message>
        <source>histogram: there must be one edge more than probabilities.</source>
        <translation>histograma: debe haber un borde más que probabilidades.</translation>
    </message>
    <message>
        <source>the measurement model has a kink at the estimates, or bends too sharply there for derivatives of second and third order</source>
        <translation>el modelo de medición tiene un quiebro en las estimaciones, o se curva allí demasiado para derivadas de segundo y tercer orden</translation>
    </message>
    <message>
        <source>the measurement model has no value there</source>
        <translation>el modelo de medición no tiene valor allí</translation>
    </message>
    <message>
        <source>its sensitivity coefficients are zero, or there are none</source>
        <translation>sus coeficientes de sensibilidad son cero, o no los hay</translation>
    </message>
    <message>
        <source>Monte Carlo answers alone for %1: the measurement model has no sensitivity coefficients at the estimates of its input quantities.</source>
        <translation>Solo Monte Carlo responde para %1: el modelo de medición no tiene coeficientes de sensibilidad en las estimaciones de sus magnitudes de entrada.</translation>
    </message>
    <message>
        <source>%1 has a kink at the estimates of the input quantities (an absolute value, a maximum, a condition): the law of propagation takes the sensitivity coefficients of one side. Use Monte Carlo.</source>
        <translation>%1 tiene un quiebro en las estimaciones de las magnitudes de entrada (un valor absoluto, un máximo, una condición): la ley de propagación toma los coeficientes de sensibilidad de un lado. Use Monte Carlo.</translation>
    </message>
    <message>
        <source>Monte Carlo answers alone for %1, which has a kink at the estimates of the input quantities (an absolute value, a maximum, a condition): the law of propagation would take the sensitivity coefficients of one side.</source>
        <translation>Solo Monte Carlo responde para %1, que tiene un quiebro en las estimaciones de las magnitudes de entrada (un valor absoluto, un máximo, una condición): la ley de propagación tomaría los coeficientes de sensibilidad de un lado.</translation>
    </message>
    <message>
        <source>There is no standard uncertainty with second-order terms of %1: they would make its variance negative, so terms of higher order matter as much. Use Monte Carlo.</source>
        <translation>No hay incertidumbre típica con términos de segundo orden de %1: harían negativa su varianza, de modo que los términos de orden superior importan igual. Use Monte Carlo.</translation>
    </message>
    <message>
        <source>%1 trials are few for a coverage interval of %2 %: some %3 lie beyond each of its ends, so that U is not known well. JCGM 101 7.2.2 asks for some %4 trials.</source>
        <translation>%1 ensayos son pocos para un intervalo de cobertura del %2 %: unos %3 quedan más allá de cada extremo, de modo que U no se conoce bien. JCGM 101 7.2.2 pide unos %4 ensayos.</translation>
    </message>
    <message>
        <source>the measurement model has no sensitivity coefficients at the estimates of its input quantities%1: it is not differentiable there (singular geometry); Monte Carlo needs none</source>
        <translation>el modelo de medición no tiene coeficientes de sensibilidad en las estimaciones de las magnitudes de entrada%1: no es diferenciable allí (geometría singular); Monte Carlo no necesita ninguno</translation>
    </message>
    <message>
        <source>the readings find target %1 %2 mm from its nominal coordinates; look for exchanged names or a unit that was mixed up (the result does not depend on the nominal coordinates)</source>
        <translation>las lecturas hallan el objetivo %1 a %2 mm de sus coordenadas nominales; busque nombres intercambiados o una unidad confundida (el resultado no depende de las coordenadas nominales)</translation>
    </message>
    <message>
        <source>the readings find %1 further targets far from their nominal coordinates</source>
        <translation>las lecturas hallan otros %1 objetivos lejos de sus coordenadas nominales</translation>
    </message>
    <message>
        <source>observations have degrees of freedom of their own; those made together have the same numbers in the table of observations</source>
        <translation>las observaciones tienen grados de libertad propios; las hechas juntas tienen los mismos números en la tabla de observaciones</translation>
    </message>
    <message>
        <source>the members of an ensemble have a standard or expanded uncertainty with finite nu</source>
        <translation>los miembros de un conjunto tienen una incertidumbre típica o expandida con nu finito</translation>
    </message>
    <message>
        <source>the members of ensemble &apos;%1&apos; have one and the same nu; it is %2 in the first, %3 here</source>
        <translation>los miembros del conjunto &apos;%1&apos; tienen un mismo nu; es %2 en el primero, %3 aquí</translation>
    </message>
    <message>
        <source>the sample gives the estimate: leave the value empty</source>
        <translation>la muestra da la estimación: deje vacío el valor</translation>
    </message>
    <message>
        <source>the weight of a cell of its histogram is missing</source>
        <translation>falta el peso de una celda de su histograma</translation>
    </message>
    <message>
        <source>a histogram has the weight of each cell beside the edge where it begins, and none beside the last edge</source>
        <translation>un histograma tiene el peso de cada celda junto al borde donde empieza, y ninguno junto al último borde</translation>
    </message>
    <message>
        <source>some values of its sample have a weight and some have none</source>
        <translation>algunos valores de su muestra tienen peso y otros no</translation>
    </message>
    <message>
        <source>its weights must have a sum above zero</source>
        <translation>sus pesos deben tener una suma mayor que cero</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is complex: list its parts %2 and %3, or define abs(%1) and arg(%1) and list these</source>
        <translation>&apos;%1&apos; es complejo: enumere sus partes %2 y %3, o defina abs(%1) y arg(%1) y enumere estas</translation>
    </message>
    <message>
        <source>a difference: %1</source>
        <translation>una diferencia: %1</translation>
    </message>
    <message>
        <source>as stated with correlations, ISO/TS 28037, 10</source>
        <translation>como se declara, con correlaciones, ISO/TS 28037, 10</translation>
    </message>
    <message>
        <source>common deviation of all %1</source>
        <translation>desviación común de todas las %1</translation>
    </message>
    <message>
        <source>stated for all points</source>
        <translation>declarada para todos los puntos</translation>
    </message>
    <message>
        <source>a common deviation is one of stated uncertainties: choose these, or leave it 0</source>
        <translation>una desviación común es de incertidumbres declaradas: elíjalas, o déjela en 0</translation>
    </message>
    <message>
        <source>correlations are those of stated uncertainties: choose these, or leave out the correlations</source>
        <translation>las correlaciones son de incertidumbres declaradas: elíjalas, o quite las correlaciones</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no coordinate of a point: write y_1 for the y of the first one</source>
        <translation>&apos;%1&apos; no es una coordenada de un punto: escriba y_1 para la y del primero</translation>
    </message>
    <message>
        <source>%1 has no standard uncertainty of its own that could be correlated</source>
        <translation>%1 no tiene una incertidumbre típica propia que pueda estar correlacionada</translation>
    </message>
    <message>
        <source>a coordinate is not correlated with itself</source>
        <translation>una coordenada no está correlacionada consigo misma</translation>
    </message>
    <message>
        <source>the CSV file &apos;%1&apos; of %2 is a link that leads out of the project&apos;s folder: put the file itself there</source>
        <translation>el archivo CSV &apos;%1&apos; de %2 es un enlace que lleva fuera de la carpeta del proyecto: ponga allí el archivo mismo</translation>
    </message>
    <message>
        <source>the guard band of %1 follows from the ratio of tolerance and U: give both limits, or choose a guard factor</source>
        <translation>la banda de seguridad de %1 resulta de la razón de tolerancia y U: dé ambos límites, o elija un factor de seguridad</translation>
    </message>
    <message>
        <source>the guard band of %1 is made for a global risk: give the prior, or choose a specific risk</source>
        <translation>la banda de seguridad de %1 se hace para un riesgo global: dé el conocimiento previo, o elija un riesgo específico</translation>
    </message>
    <message>
        <source>the guard band of %1 needs a tolerance: give a limit</source>
        <translation>la banda de seguridad de %1 necesita una tolerancia: dé un límite</translation>
    </message>
    <message>
        <source>the target risk of %1 must lie above 0 and not above 0.5</source>
        <translation>el riesgo objetivo de %1 debe ser mayor que 0 y no mayor que 0.5</translation>
    </message>
    <message>
        <source>another study has the same id</source>
        <translation>otro estudio tiene el mismo identificador</translation>
    </message>
    <message>
        <source>its id must be made of letters, digits, &apos;-&apos; and &apos;_&apos;</source>
        <translation>su identificador debe constar de letras, cifras, &apos;-&apos; y &apos;_&apos;</translation>
    </message>
    <message>
        <source>there is no asset %1, and no analysis of this name that this one takes from%2</source>
        <translation>no hay activo %1, ni análisis de este nombre del que este tome%2</translation>
    </message>
    <message>
        <source> (did you mean %1?)</source>
        <translation> (¿quiso decir %1?)</translation>
    </message>
    <message>
        <source>a number here is larger than any that can be computed with (1.8e308)</source>
        <translation>un número aquí es mayor que cualquiera con el que se pueda calcular (1.8e308)</translation>
    </message>
    <message>
        <source>the value or its place is no text in UTF-8</source>
        <translation>el valor o su lugar no es un texto en UTF-8</translation>
    </message>
    <message>
        <source>more than %1 analyses feed each other in a row: put the equations of some of them into one</source>
        <translation>más de %1 análisis se alimentan unos a otros en fila: ponga las ecuaciones de algunos en uno</translation>
    </message>
    <message>
        <source>%1 is a link that leads out of the project&apos;s folder: put the picture itself there</source>
        <translation>%1 es un enlace que lleva fuera de la carpeta del proyecto: ponga allí la imagen misma</translation>
    </message>
    <message>
        <source>%1; in this file write %2</source>
        <translation>%1; en este archivo escriba %2</translation>
    </message>
    <message>
        <source>there is no asset %1%2</source>
        <translation>no hay activo %1%2</translation>
    </message>
    <message>
        <source>the file of candidates &apos;%1&apos; is a link that leads out of the project&apos;s folder: put the file itself there</source>
        <translation>el archivo de candidatos &apos;%1&apos; es un enlace que lleva fuera de la carpeta del proyecto: ponga allí el archivo mismo</translation>
    </message>
    <message>
        <source>another design has the same id</source>
        <translation>otro diseño tiene el mismo identificador</translation>
    </message>
    <message>
        <source>row %1 was left out</source>
        <translation>se omitió la fila %1</translation>
    </message>
    <message>
        <source>row %1: %2 in %3 beside a sensitivity coefficient is taken as a difference or reading, in %4</source>
        <translation>fila %1: %2 en %3 junto a un coeficiente de sensibilidad se toma como diferencia o lectura, en %4</translation>
    </message>
    <message>
        <source>the result is not the sum of c x: %1 = %2 is the difference</source>
        <translation>el resultado no es la suma de las c x: %1 = %2 es la diferencia</translation>
    </message>
    <message>
        <source>the sheet %1 has no row %2 to leave out</source>
        <translation>la hoja %1 no tiene una fila %2 que omitir</translation>
    </message>
    <message>
        <source>%1 is no place of a cell; D3 is one</source>
        <translation>%1 no es el lugar de una celda; D3 lo es</translation>
    </message>
    <message>
        <source>point %1 with other coordinates: those of line %2 are taken</source>
        <translation>punto %1 con otras coordenadas: se toman las de la línea %2</translation>
    </message>
    <message>
        <source>%1 determinations of the same points (&lt;coordinates&gt; of lines %2): each is an artefact of its own; keep all of them, or delete those that you do not want</source>
        <translation>%1 determinaciones de los mismos puntos (&lt;coordinates&gt; de las líneas %2): cada una es un artefacto propio; conserve todas, o borre las que no quiera</translation>
    </message>
    <message>
        <source>%1 is no number: write %2, with a point</source>
        <translation>%1 no es un número: escriba %2, con punto</translation>
    </message>
    <message>
        <source>the name of the result %1 of %2</source>
        <translation>el nombre del resultado %1 de %2</translation>
    </message>
    <message>
        <source>the names of the results %1 of %2</source>
        <translation>los nombres de los resultados %1 de %2</translation>
    </message>
    <message>
        <source>the certificate calls it by its symbol alone: %1 must be stated (ISO/IEC 17025 %2)</source>
        <translation>el certificado lo llama solo por su símbolo: debe indicarse %1 (ISO/IEC 17025 %2)</translation>
    </message>
    <message>
        <source>under an accreditation U is stated for a coverage probability of about 95 % (ILAC-P14 5.3); here it is %1</source>
        <translation>bajo una acreditación U se declara para una probabilidad de cobertura de alrededor del 95 % (ILAC-P14 5.3); aquí es %1</translation>
    </message>
    <message>
        <source>%1: the file states %2, this budget gives %3, %4 apart</source>
        <translation>%1: el archivo declara %2, este balance da %3, una diferencia de %4</translation>
    </message>
    <message>
        <source>%1: FIND OUT WHY before it is used</source>
        <translation>%1: AVERIGÜE POR QUÉ antes de usarlo</translation>
    </message>
    <message>
        <source>u(%1) by its contributions</source>
        <translation>u(%1) por sus contribuciones</translation>
    </message>
    <message>
        <source>%1: the file states no result that this budget could be held against</source>
        <translation>%1: el archivo no declara ningún resultado con el que comparar este balance</translation>
    </message>
    <message>
        <source>another one has the same id</source>
        <translation>otro tiene el mismo identificador</translation>
    </message>
    <message>
        <source>%1: of what the rule accepts %2 does not conform, of what it rejects %3 does.</source>
        <translation>%1: de lo que la regla acepta, %2 no es conforme; de lo que rechaza, %3 lo es.</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Índice</translation>
    </message>
    <message>
        <source>%1 further components of %2 other sources</source>
        <translation>%1 componentes más de otras %2 fuentes</translation>
    </message>
    <message>
        <source>other sources</source>
        <translation>otras fuentes</translation>
    </message>
    <message>
        <source>1 further component: %1</source>
        <translation>1 componente más: %1</translation>
    </message>
    <message>
        <source>%1 further components: %2</source>
        <translation>%1 componentes más: %2</translation>
    </message>
    <message>
        <source>Left out: %1 components that contribute nothing (less than 10⁻⁹ of u_c).</source>
        <translation>Omitidas: %1 componentes que no contribuyen nada (menos de 10⁻⁹ de u_c).</translation>
    </message>
    <message>
        <source>Left out, because they contribute nothing (less than 10⁻⁹ of u_c): %1.</source>
        <translation>Omitidas, porque no contribuyen nada (menos de 10⁻⁹ de u_c): %1.</translation>
    </message>
    <message>
        <source>Stated in the results: %1 = %2 (propagation of distributions).</source>
        <translation>Declarado en los resultados: %1 = %2 (propagación de distribuciones).</translation>
    </message>
    <message>
        <source>%1: under an accreditation U is stated for a coverage probability of about 95 % (ILAC-P14 5.3); with k = %2 that of %3 is %4</source>
        <translation>%1: bajo una acreditación U se declara para una probabilidad de cobertura de alrededor del 95 % (ILAC-P14 5.3); con k = %2 la de %3 es %4</translation>
    </message>
    <message>
        <source>not drawn, for it is farther away than 10¹² km: %1</source>
        <translation>no se dibuja, porque está a más de 10¹² km: %1</translation>
    </message>
    <message>
        <source>Laplace</source>
        <translation>Laplace</translation>
    </message>
    <message>
        <source>Weibull</source>
        <translation>Weibull</translation>
    </message>
    <message>
        <source>expected number of events</source>
        <translation>número esperado de sucesos</translation>
    </message>
    <message>
        <source>step of one event</source>
        <translation>paso de un suceso</translation>
    </message>
    <message>
        <source>probability</source>
        <translation>probabilidad</translation>
    </message>
    <message>
        <source>75 nm: standard uncertainty
2 ppm: standard uncertainty, a part of the value; absolute where the quantity is a ratio itself
U = 0.3 um, k = 2 (or p = 95 %): certificate
s = 13 nm, n = 5: standard deviation known before, mean of n observations (Type A)
rectangular 0.5 (or rect, ±): limits about the value; likewise triangular, arcsine
limits 19.5 to 20.5: they give the value
10.1; 10.3; 10.2: observations
resolution 0.01, MPE 3 + 0.1 %, counts 12, constant
Laplace 0.3, Weibull 0.3 (standard deviations), Weibull scale 2, shape 1.5
Poisson 12, binomial n = 50, p = 2 %: they give the value
sample 1; 2; 3 weights 2; 5; 2 (drawn as they are), histogram 0; 1; 2 weights 5; 8 (edges)
nu 18 behind any of them: degrees of freedom</source>
        <translation>75 nm: incertidumbre típica
2 ppm: incertidumbre típica, una parte del valor; absoluta donde la magnitud es ella misma una razón
U = 0.3 um, k = 2 (o p = 95 %): certificado
s = 13 nm, n = 5: desviación típica conocida de antes, media de n observaciones (tipo A)
rectangular 0.5 (o rect, ±): límites en torno al valor; igual triangular, arcsine
limits 19.5 to 20.5: dan el valor
10.1; 10.3; 10.2: observaciones
resolution 0.01, MPE 3 + 0.1 %, counts 12, constant
Laplace 0.3, Weibull 0.3 (desviaciones típicas), Weibull scale 2, shape 1.5
Poisson 12, binomial n = 50, p = 2 %: dan el valor
sample 1; 2; 3 weights 2; 5; 2 (se sortean como son), histogram 0; 1; 2 weights 5; 8 (bordes)
nu 18 detrás de cualquiera de ellos: grados de libertad</translation>
    </message>
    <message>
        <source>sample</source>
        <translation>muestra</translation>
    </message>
    <message>
        <source>weights</source>
        <translation>pesos</translation>
    </message>
    <message>
        <source>Network adjustment</source>
        <translation>Compensación de redes</translation>
    </message>
    <message>
        <source>Coordinates of stations and targets from the distances, directions, angles and height differences that were read between them: heights, plane or space, free or held by known points, with the reliability of each reading.</source>
        <translation>Coordenadas de estaciones y dianas a partir de las distancias, direcciones, ángulos y desniveles leídos entre ellas: alturas, plano o espacio, libre o sujeta a puntos conocidos, con la fiabilidad de cada lectura.</translation>
    </message>
    <message>
        <source>Uncertainties follow from those that were stated for the readings; they are not multiplied by s_0, which is a test of them.</source>
        <translation>Las incertidumbres se deducen de las indicadas para las lecturas; no se multiplican por s_0, que es una comprobación de ellas.</translation>
    </message>
    <message>
        <source>In a free network what no reading tells is taken from the approximate coordinates of the points of the datum: the sum of squares of their changes is least. Residuals, s_0 and redundancies do not depend on the datum.</source>
        <translation>En una red libre, lo que ninguna lectura dice se toma de las coordenadas aproximadas de los puntos del datum: la suma de los cuadrados de sus cambios es mínima. Los residuos, s_0 y las redundancias no dependen del datum.</translation>
    </message>
    <message>
        <source>Each round of directions has an orientation that is not known. Instruments are levelled unless the set-up says how they lean: zenith angles count from the vertical, the z-axis at all points.</source>
        <translation>Cada serie de direcciones tiene una orientación que no se conoce. Los instrumentos están nivelados salvo que el estacionamiento indique cómo se inclinan: los ángulos cenitales se cuentan desde la vertical, el eje z en todos los puntos.</translation>
    </message>
    <message>
        <source>Smallest detectable errors are those of a test at 0.1 % with a power of 80 % (delta_0 = 4.132), with the uncertainties that were stated.</source>
        <translation>Los errores mínimos detectables son los de un contraste al 0,1 % con una potencia del 80 % (delta_0 = 4,132), con las incertidumbres indicadas.</translation>
    </message>
    <message>
        <source>In Monte Carlo each trial is a solution with the derivatives at the estimates, repeated until it stands still.</source>
        <translation>En Monte Carlo cada prueba es una solución con las derivadas en las estimaciones, repetida hasta que deja de cambiar.</translation>
    </message>
    <message>
        <source>Stations and targets alike, with what is known of them beforehand.</source>
        <translation>Estaciones y dianas por igual, con lo que se sabe de ellas de antemano.</translation>
    </message>
    <message>
        <source>Coordinate x; of an unknown point an approximate one, or empty: the readings place it.</source>
        <translation>Coordenada x; de un punto desconocido, una aproximada, o vacía: las lecturas lo sitúan.</translation>
    </message>
    <message>
        <source>Coordinate y; of an unknown point an approximate one, or empty: the readings place it.</source>
        <translation>Coordenada y; de un punto desconocido, una aproximada, o vacía: las lecturas lo sitúan.</translation>
    </message>
    <message>
        <source>Coordinate z; of an unknown point an approximate one, or empty: the readings place it.</source>
        <translation>Coordenada z; de un punto desconocido, una aproximada, o vacía: las lecturas lo sitúan.</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>plano</translation>
    </message>
    <message>
        <source>What is known of x and y: unknown; unknown, and what no reading tells is taken from this point and others like it (free network); fixed without uncertainty; stated with u.</source>
        <translation>Lo que se sabe de x e y: incógnita; incógnita, y lo que ninguna lectura dice se toma de este punto y de otros como él (red libre); fija sin incertidumbre; indicada con u.</translation>
    </message>
    <message>
        <source>unknown, of the datum</source>
        <translation>incógnita, del datum</translation>
    </message>
    <message>
        <source>stated with u</source>
        <translation>indicada con u</translation>
    </message>
    <message>
        <source>not part of the network</source>
        <translation>no forma parte de la red</translation>
    </message>
    <message>
        <source>height</source>
        <translation>altura</translation>
    </message>
    <message>
        <source>What is known of z, likewise.</source>
        <translation>Lo que se sabe de z, del mismo modo.</translation>
    </message>
    <message>
        <source>Standard uncertainty of a stated coordinate.</source>
        <translation>Incertidumbre típica de una coordenada indicada.</translation>
    </message>
    <message>
        <source>Distances between points that are measurands too.</source>
        <translation>Distancias entre puntos que también son mensurandos.</translation>
    </message>
    <message>
        <source>Name of a point.</source>
        <translation>Nombre de un punto.</translation>
    </message>
    <message>
        <source>Name of another point.</source>
        <translation>Nombre de otro punto.</translation>
    </message>
    <message>
        <source>Directions grow</source>
        <translation>Las direcciones crecen</translation>
    </message>
    <message>
        <source>In which sense directions, angles and azimuths grow, and from which axis azimuths count.</source>
        <translation>En qué sentido crecen las direcciones, los ángulos y los acimutes, y desde qué eje se cuentan los acimutes.</translation>
    </message>
    <message>
        <source>from x towards y; azimuths count from x</source>
        <translation>de x hacia y; los acimutes se cuentan desde x</translation>
    </message>
    <message>
        <source>from y towards x; azimuths count from y</source>
        <translation>de y hacia x; los acimutes se cuentan desde y</translation>
    </message>
    <message>
        <source>What was read between the points, one row for each figure, typed or from a CSV file.</source>
        <translation>Lo que se leyó entre los puntos, una fila por cada cifra, tecleada o de un archivo CSV.</translation>
    </message>
    <message>
        <source>label</source>
        <translation>etiqueta</translation>
    </message>
    <message>
        <source>By which a correlation calls it.</source>
        <translation>Con la que la nombra una correlación.</translation>
    </message>
    <message>
        <source>What was read.</source>
        <translation>Lo que se leyó.</translation>
    </message>
    <message>
        <source>slope distance</source>
        <translation>distancia inclinada</translation>
    </message>
    <message>
        <source>horizontal distance</source>
        <translation>distancia horizontal</translation>
    </message>
    <message>
        <source>zenith angle</source>
        <translation>ángulo cenital</translation>
    </message>
    <message>
        <source>height difference</source>
        <translation>desnivel</translation>
    </message>
    <message>
        <source>x of a point</source>
        <translation>x de un punto</translation>
    </message>
    <message>
        <source>y of a point</source>
        <translation>y de un punto</translation>
    </message>
    <message>
        <source>z of a point</source>
        <translation>z de un punto</translation>
    </message>
    <message>
        <source>difference of x</source>
        <translation>diferencia de x</translation>
    </message>
    <message>
        <source>difference of y</source>
        <translation>diferencia de y</translation>
    </message>
    <message>
        <source>difference of z</source>
        <translation>diferencia de z</translation>
    </message>
    <message>
        <source>The point where it was read; of a coordinate its point.</source>
        <translation>El punto donde se leyó; de una coordenada, su punto.</translation>
    </message>
    <message>
        <source>The point that was sighted.</source>
        <translation>El punto que se visó.</translation>
    </message>
    <message>
        <source>Of an angle the point at its second leg.</source>
        <translation>De un ángulo, el punto de su segundo lado.</translation>
    </message>
    <message>
        <source>round</source>
        <translation>serie</translation>
    </message>
    <message>
        <source>Of a direction: rounds of one station between which its circle was turned have names; each has an orientation of its own.</source>
        <translation>De una dirección: las series de una estación entre las que se giró su círculo llevan nombre; cada una tiene su propia orientación.</translation>
    </message>
    <message>
        <source>A length or coordinate as read.</source>
        <translation>Una longitud o coordenada tal como se leyó.</translation>
    </message>
    <message>
        <source>An angle as read.</source>
        <translation>Un ángulo tal como se leyó.</translation>
    </message>
    <message>
        <source>u of length</source>
        <translation>u de longitud</translation>
    </message>
    <message>
        <source>Standard uncertainty of the length.</source>
        <translation>Incertidumbre típica de la longitud.</translation>
    </message>
    <message>
        <source>u of angle</source>
        <translation>u de ángulo</translation>
    </message>
    <message>
        <source>Standard uncertainty of the angle.</source>
        <translation>Incertidumbre típica del ángulo.</translation>
    </message>
    <message>
        <source>height from</source>
        <translation>altura desde</translation>
    </message>
    <message>
        <source>Height of the instrument above its point.</source>
        <translation>Altura del instrumento sobre su punto.</translation>
    </message>
    <message>
        <source>height to</source>
        <translation>altura hasta</translation>
    </message>
    <message>
        <source>Height of the target above its point.</source>
        <translation>Altura de la diana sobre su punto.</translation>
    </message>
    <message>
        <source>Instruments that are not levelled</source>
        <translation>Instrumentos no nivelados</translation>
    </message>
    <message>
        <source>Where an instrument stands that is not levelled, or not exactly; all others are.</source>
        <translation>Dónde está un instrumento que no está nivelado, o no exactamente; todos los demás lo están.</translation>
    </message>
    <message>
        <source>The point where the instrument stands.</source>
        <translation>El punto donde está el instrumento.</translation>
    </message>
    <message>
        <source>tilt</source>
        <translation>inclinación</translation>
    </message>
    <message>
        <source>How it leans: unknown, so that the readings tell it; or levelled within u, about x and about y.</source>
        <translation>Cómo se inclina: incógnita, de modo que las lecturas lo dicen; o nivelado dentro de u, alrededor de x y alrededor de y.</translation>
    </message>
    <message>
        <source>levelled within u</source>
        <translation>nivelado dentro de u</translation>
    </message>
    <message>
        <source>u of tilt</source>
        <translation>u de inclinación</translation>
    </message>
    <message>
        <source>Standard uncertainty of each tilt of a levelled instrument.</source>
        <translation>Incertidumbre típica de cada inclinación de un instrumento nivelado.</translation>
    </message>
    <message>
        <source>Correlations of readings</source>
        <translation>Correlaciones de lecturas</translation>
    </message>
    <message>
        <source>Correlation coefficients of readings: they change the weights and the uncertainty.</source>
        <translation>Coeficientes de correlación de lecturas: cambian los pesos y la incertidumbre.</translation>
    </message>
    <message>
        <source>Label of a reading.</source>
        <translation>Etiqueta de una lectura.</translation>
    </message>
    <message>
        <source>Label of another reading.</source>
        <translation>Etiqueta de otra lectura.</translation>
    </message>
    <message>
        <source>Correlation coefficient of the two.</source>
        <translation>Coeficiente de correlación de ambas.</translation>
    </message>
    <message>
        <source>Two targets from two stations that nobody measured</source>
        <translation>Dos dianas desde dos estaciones que nadie midió</translation>
    </message>
    <message>
        <source>A total station stood at S1 and S2, whose places are not known.</source>
        <translation>Una estación total estuvo en S1 y S2, cuyas posiciones no se conocen.</translation>
    </message>
    <message>
        <source>The law of propagation of uncertainty says nothing of %1 at these estimates: Monte Carlo answers alone</source>
        <translation>La ley de propagación de la incertidumbre no dice nada de %1 en estas estimaciones: solo responde Monte Carlo</translation>
    </message>
    <message>
        <source>The standard uncertainty by Monte Carlo of %1 is not known from these trials, and may not exist: the tails of its distribution are too heavy. Use the coverage interval.</source>
        <translation>La incertidumbre típica por Monte Carlo de %1 no se conoce con estas pruebas, y puede que no exista: las colas de su distribución son demasiado pesadas. Use el intervalo de cobertura.</translation>
    </message>
    <message>
        <source>as stated</source>
        <translation>según lo indicado</translation>
    </message>
    <message>
        <source>tilt at %1 about %2</source>
        <translation>inclinación en %1 alrededor de %2</translation>
    </message>
    <message>
        <source>orientation at %1</source>
        <translation>orientación en %1</translation>
    </message>
    <message>
        <source>orientation at %1, round %2</source>
        <translation>orientación en %1, serie %2</translation>
    </message>
    <message>
        <source>readings l, their residuals v, unknowns x</source>
        <translation>lecturas l, sus residuos v, incógnitas x</translation>
    </message>
    <message>
        <source>least squares, Gauss-Newton method</source>
        <translation>mínimos cuadrados, método de Gauss-Newton</translation>
    </message>
    <message>
        <source>law of propagation; generalised inverse of the datum</source>
        <translation>ley de propagación; inversa generalizada del datum</translation>
    </message>
    <message>
        <source>free network: W. Baarda, S-transformations, 1973</source>
        <translation>red libre: W. Baarda, S-transformations, 1973</translation>
    </message>
    <message>
        <source>redundancy and test of a reading: W. Baarda, A testing procedure, 1968</source>
        <translation>redundancia y contraste de una lectura: W. Baarda, A testing procedure, 1968</translation>
    </message>
    <message>
        <source>smallest error of a reading that the test finds</source>
        <translation>error mínimo de una lectura que el contraste detecta</translation>
    </message>
    <message>
        <source>a posteriori; uncertainties are those that were stated, not times s₀</source>
        <translation>a posteriori; las incertidumbres son las indicadas, no multiplicadas por s₀</translation>
    </message>
    <message>
        <source>slope distance %1 – %2</source>
        <translation>distancia inclinada %1 – %2</translation>
    </message>
    <message>
        <source>horizontal distance %1 – %2</source>
        <translation>distancia horizontal %1 – %2</translation>
    </message>
    <message>
        <source>direction %1 – %2</source>
        <translation>dirección %1 – %2</translation>
    </message>
    <message>
        <source>azimuth %1 – %2</source>
        <translation>acimut %1 – %2</translation>
    </message>
    <message>
        <source>zenith angle %1 – %2</source>
        <translation>ángulo cenital %1 – %2</translation>
    </message>
    <message>
        <source>height difference %1 – %2</source>
        <translation>desnivel %1 – %2</translation>
    </message>
    <message>
        <source>tilt about x of the instrument at %1</source>
        <translation>inclinación alrededor de x del instrumento en %1</translation>
    </message>
    <message>
        <source>tilt about y of the instrument at %1</source>
        <translation>inclinación alrededor de y del instrumento en %1</translation>
    </message>
    <message>
        <source>x of %1</source>
        <translation>x de %1</translation>
    </message>
    <message>
        <source>y of %1</source>
        <translation>y de %1</translation>
    </message>
    <message>
        <source>z of %1</source>
        <translation>z de %1</translation>
    </message>
    <message>
        <source>difference of x, %1 – %2</source>
        <translation>diferencia de x, %1 – %2</translation>
    </message>
    <message>
        <source>difference of y, %1 – %2</source>
        <translation>diferencia de y, %1 – %2</translation>
    </message>
    <message>
        <source>difference of z, %1 – %2</source>
        <translation>diferencia de z, %1 – %2</translation>
    </message>
    <message>
        <source>the readings do not lead to a place of every point: the adjustment does not converge; look for exchanged or mistyped readings, for a unit that was mixed up (gon and degrees, m and mm), and for coordinates that are far off</source>
        <translation>las lecturas no llevan a un lugar de cada punto: la compensación no converge; busque lecturas intercambiadas o mal escritas, una unidad confundida (gon y grados, m y mm) y coordenadas muy alejadas</translation>
    </message>
    <message>
        <source>and %1 further ways in which the points can move</source>
        <translation>y %1 formas más en que los puntos pueden moverse</translation>
    </message>
    <message>
        <source>point %1: its %2 is said to be known, and is missing</source>
        <translation>punto %1: se dice que su %2 es conocida, y falta</translation>
    </message>
    <message>
        <source>point %1: the u of its stated %2 is missing</source>
        <translation>punto %1: falta la u de su %2 indicada</translation>
    </message>
    <message>
        <source>the name of a point is missing</source>
        <translation>falta el nombre de un punto</translation>
    </message>
    <message>
        <source>there is no point %1</source>
        <translation>no hay ningún punto %1</translation>
    </message>
    <message>
        <source>the instrument at %1: the u of its tilt is missing</source>
        <translation>el instrumento en %1: falta la u de su inclinación</translation>
    </message>
    <message>
        <source>two instruments stand at %1</source>
        <translation>hay dos instrumentos en %1</translation>
    </message>
    <message>
        <source>a reading from %1 to itself</source>
        <translation>una lectura de %1 a sí mismo</translation>
    </message>
    <message>
        <source>both legs of the angle at %1 go to %2</source>
        <translation>los dos lados del ángulo en %1 van a %2</translation>
    </message>
    <message>
        <source>%1: its value is missing</source>
        <translation>%1: falta su valor</translation>
    </message>
    <message>
        <source>%1: its standard uncertainty is missing</source>
        <translation>%1: falta su incertidumbre típica</translation>
    </message>
    <message>
        <source>%1 is an angle and has a length</source>
        <translation>%1 es un ángulo y tiene una longitud</translation>
    </message>
    <message>
        <source>%1 is a length and has an angle</source>
        <translation>%1 es una longitud y tiene un ángulo</translation>
    </message>
    <message>
        <source>%1 is not positive</source>
        <translation>%1 no es positiva</translation>
    </message>
    <message>
        <source>%1 is not between 0 and half a turn: state the mean of both faces</source>
        <translation>%1 no está entre 0 y media vuelta: indique la media de círculo directo e inverso</translation>
    </message>
    <message>
        <source>%1 needs the height of %2, which is not part of the network</source>
        <translation>%1 necesita la altura de %2, que no forma parte de la red</translation>
    </message>
    <message>
        <source>%1 needs x and y of %2, which are not part of the network</source>
        <translation>%1 necesita x e y de %2, que no forman parte de la red</translation>
    </message>
    <message>
        <source>a distance needs two points</source>
        <translation>una distancia necesita dos puntos</translation>
    </message>
    <message>
        <source>all points are fixed: there is nothing to be found</source>
        <translation>todos los puntos están fijos: no hay nada que hallar</translation>
    </message>
    <message>
        <source>two readings have the label %1</source>
        <translation>dos lecturas tienen la etiqueta %1</translation>
    </message>
    <message>
        <source>there is no reading with the label %1</source>
        <translation>no hay ninguna lectura con la etiqueta %1</translation>
    </message>
    <message>
        <source>reading %1 with itself</source>
        <translation>la lectura %1 consigo misma</translation>
    </message>
    <message>
        <source>the correlation coefficients are not possible together</source>
        <translation>los coeficientes de correlación no son posibles juntos</translation>
    </message>
    <message>
        <source>the readings do not place point %1: too few of them tie it to the others; add readings, or state approximate coordinates</source>
        <translation>las lecturas no sitúan el punto %1: son muy pocas las que lo ligan a los demás; añada lecturas, o indique coordenadas aproximadas</translation>
    </message>
    <message>
        <source>the readings do not place %1 points (%2): too few tie them to the others; add readings, or state approximate coordinates</source>
        <translation>las lecturas no sitúan %1 puntos (%2): son muy pocas las que los ligan a los demás; añada lecturas, o indique coordenadas aproximadas</translation>
    </message>
    <message>
        <source>Adjustment</source>
        <translation>Compensación</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Cifra</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>unknowns</source>
        <translation>incógnitas</translation>
    </message>
    <message>
        <source>what no reading tells (datum defect)</source>
        <translation>lo que ninguna lectura dice (defecto de datum)</translation>
    </message>
    <message>
        <source>degrees of freedom f</source>
        <translation>grados de libertad f</translation>
    </message>
    <message>
        <source>sum of squares vᵀ C⁻¹ v</source>
        <translation>suma de cuadrados vᵀ C⁻¹ v</translation>
    </message>
    <message>
        <source>s₀ a posteriori</source>
        <translation>s₀ a posteriori</translation>
    </message>
    <message>
        <source>δ₀ of smallest detectable errors (0.1 %, 80 %)</source>
        <translation>δ₀ de los errores mínimos detectables (0,1 %, 80 %)</translation>
    </message>
    <message>
        <source>smallest detectable error</source>
        <translation>error mínimo detectable</translation>
    </message>
    <message>
        <source>its largest effect</source>
        <translation>su mayor efecto</translation>
    </message>
    <message>
        <source>on</source>
        <translation>en</translation>
    </message>
    <message>
        <source>%1 The residuals are larger than the uncertainties allow; the largest for its uncertainty is the %2. Look for mistyped or exchanged readings, or uncertainties that are too small</source>
        <translation>%1 Los residuos son mayores de lo que permiten las incertidumbres; el mayor para su incertidumbre es %2. Busque lecturas mal escritas o intercambiadas, o incertidumbres demasiado pequeñas</translation>
    </message>
    <message>
        <source>nothing was read of point %1: add readings to it, or take it out</source>
        <translation>no se leyó nada del punto %1: añádale lecturas, o quítelo</translation>
    </message>
    <message>
        <source>nothing tells how the instrument at %1 stood: add directions or angles from there to places that are known</source>
        <translation>nada dice cómo estaba el instrumento en %1: añada direcciones o ángulos desde allí a lugares conocidos</translation>
    </message>
    <message>
        <source>nothing tells the height of %1: state it, or add a height difference, or a zenith angle with a distance</source>
        <translation>nada dice la altura de %1: indíquela, o añada un desnivel, o un ángulo cenital con una distancia</translation>
    </message>
    <message>
        <source>nothing tells where %1 is: add readings to it</source>
        <translation>nada dice dónde está %1: añádale lecturas</translation>
    </message>
    <message>
        <source>point %1 can move along %2 without changing a reading: add one that sees this</source>
        <translation>el punto %1 puede moverse a lo largo de %2 sin cambiar ninguna lectura: añada una que lo detecte</translation>
    </message>
    <message>
        <source>the direction (%1, %2, %3)</source>
        <translation>la dirección (%1, %2, %3)</translation>
    </message>
    <message>
        <source>the whole network</source>
        <translation>toda la red</translation>
    </message>
    <message>
        <source>the part with %1 and %2 more</source>
        <translation>la parte con %1 y %2 más</translation>
    </message>
    <message>
        <source>the part with %1</source>
        <translation>la parte con %1</translation>
    </message>
    <message>
        <source>nothing tells where %1 is along %2: fix or state a point, or let points be of the datum</source>
        <translation>nada dice dónde está %1 a lo largo de %2: fije o indique un punto, o deje que haya puntos del datum</translation>
    </message>
    <message>
        <source>nothing tells the height of %1: fix or state the height of a point, or let heights be of the datum</source>
        <translation>nada dice la altura de %1: fije o indique la altura de un punto, o deje que haya alturas del datum</translation>
    </message>
    <message>
        <source>%1 may tilt about %2: add zenith angles or height differences, or fix a third point</source>
        <translation>%1 puede inclinarse alrededor de %2: añada ángulos cenitales o desniveles, o fije un tercer punto</translation>
    </message>
    <message>
        <source>%1 may turn about the vertical: add an azimuth, fix a second point, or let points be of the datum</source>
        <translation>%1 puede girar alrededor de la vertical: añada un acimut, fije un segundo punto, o deje que haya puntos del datum</translation>
    </message>
    <message>
        <source>nothing tells the scale of %1: add a distance, fix a second point, or let points be of the datum</source>
        <translation>nada dice la escala de %1: añada una distancia, fije un segundo punto, o deje que haya puntos del datum</translation>
    </message>
    <message>
        <source>the readings leave open a common movement of %1: add readings that tie them to the others</source>
        <translation>las lecturas dejan libre un movimiento común de %1: añada lecturas que los liguen a los demás</translation>
    </message>
    <message>
        <source>orientations</source>
        <translation>orientaciones</translation>
    </message>
    <message>
        <source>moving platform</source>
        <translation>plataforma móvil</translation>
    </message>
    <message>
        <source>lengths</source>
        <translation>longitudes</translation>
    </message>
    <message>
        <source>measured orientations</source>
        <translation>orientaciones medidas</translation>
    </message>
    <message>
        <source>measured positions</source>
        <translation>posiciones medidas</translation>
    </message>
    <message>
        <source>readings of the joints</source>
        <translation>lecturas de las articulaciones</translation>
    </message>
    <message>
        <source>circle of %1</source>
        <translation>círculo de %1</translation>
    </message>
    <message>
        <source>regression</source>
        <translation>regresión</translation>
    </message>
    <message>
        <source>it cannot be varied: %1</source>
        <translation>no se puede variar: %1</translation>
    </message>
    <message>
        <source>no more than %1</source>
        <translation>no más de %1</translation>
    </message>
    <message>
        <source>an observation of %1, which the file neither fixes nor adjusts in what it needs</source>
        <translation>una observación de %1, que el archivo ni fija ni compensa en lo que ella necesita</translation>
    </message>
    <message>
        <source>an observation of %1 without a standard deviation</source>
        <translation>una observación de %1 sin desviación típica</translation>
    </message>
    <message>
        <source>a network of %1 points with %2 readings, which is adjusted</source>
        <translation>una red de %1 puntos con %2 lecturas, que se compensa</translation>
    </message>
    <message>
        <source>its heights above the points are no numbers</source>
        <translation>sus alturas sobre los puntos no son números</translation>
    </message>
    <message>
        <source>column %1%2 of sheet %3 is filled but not understood: state what each column is, %4, with one of %5 in place of ? (- leaves the column out)</source>
        <translation>la columna %1%2 de la hoja %3 está llena pero no se entiende: indique qué es cada columna, %4, con uno de %5 en lugar de ? (- omite la columna)</translation>
    </message>
    <message>
        <source>There is no budget of %1: the law of propagation of uncertainty says nothing of it at the estimates of its input quantities.</source>
        <translation>No hay balance de %1: la ley de propagación de la incertidumbre no dice nada de él en las estimaciones de sus magnitudes de entrada.</translation>
    </message>
    <message>
        <source>out</source>
        <translation>salida</translation>
    </message>
    <message>
        <source>%1 trials</source>
        <translation>%1 pruebas</translation>
    </message>
    <message>
        <source>sight</source>
        <translation>visual</translation>
    </message>
    <message>
        <source>force, own scale</source>
        <translation>fuerza, escala propia</translation>
    </message>
    <message>
        <source>moment, own scale</source>
        <translation>momento, escala propia</translation>
    </message>
    <message>
        <source>in</source>
        <translation>entrada</translation>
    </message>
    <message>
        <source>uncertainty %1</source>
        <translation>incertidumbre %1</translation>
    </message>
    <message>
        <source>ellipsoids %1, %2</source>
        <translation>elipsoides %1, %2</translation>
    </message>
    <message>
        <source>Uncertainties of the readings</source>
        <translation>Incertidumbres de las lecturas</translation>
    </message>
    <message>
        <source>As typed in the table; or as the residuals of this adjustment see them: typed ones times one common factor s_0, or times the factor of each kind of reading and instrument (variance components). Either has the degrees of freedom of its estimate.</source>
        <translation>Las tecleadas en la tabla; o las que ven los residuos de esta compensación: las tecleadas por un factor común s_0, o por el factor de cada clase de lectura y cada instrumento (componentes de varianza). Ambas tienen los grados de libertad de su estimación.</translation>
    </message>
    <message>
        <source>as seen, one factor s_0</source>
        <translation>las observadas, un solo factor s_0</translation>
    </message>
    <message>
        <source>as seen, a factor for each figure</source>
        <translation>las observadas, un factor por cada cifra</translation>
    </message>
    <message>
        <source>Are the figures of the data sheet true?</source>
        <translation>¿Son ciertas las cifras de la hoja de datos?</translation>
    </message>
    <message>
        <source>A section of a barrel, 8 m long, with 20 targets, read by a total station from three places that nobody measured.</source>
        <translation>Una sección de un cuerpo cilíndrico, de 8 m de longitud, con 20 dianas, leída por una estación total desde tres lugares que nadie midió.</translation>
    </message>
    <message>
        <source>slope distances</source>
        <translation>distancias inclinadas</translation>
    </message>
    <message>
        <source>horizontal distances</source>
        <translation>distancias horizontales</translation>
    </message>
    <message>
        <source>directions</source>
        <translation>direcciones</translation>
    </message>
    <message>
        <source>azimuths</source>
        <translation>acimutes</translation>
    </message>
    <message>
        <source>zenith angles</source>
        <translation>ángulos cenitales</translation>
    </message>
    <message>
        <source>height differences</source>
        <translation>desniveles</translation>
    </message>
    <message>
        <source>tilts of instruments</source>
        <translation>inclinaciones de instrumentos</translation>
    </message>
    <message>
        <source>stated coordinates</source>
        <translation>coordenadas indicadas</translation>
    </message>
    <message>
        <source>coordinates</source>
        <translation>coordenadas</translation>
    </message>
    <message>
        <source>coordinate differences</source>
        <translation>diferencias de coordenadas</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 y %2</translation>
    </message>
    <message>
        <source>The readings have no residuals that could tell their uncertainty: it stays as stated</source>
        <translation>Las lecturas no tienen residuos que puedan decir su incertidumbre: se queda como se indicó</translation>
    </message>
    <message>
        <source>Nothing is redundant: uncertainties of the readings stay as stated</source>
        <translation>Nada es redundante: las incertidumbres de las lecturas se quedan como se indicaron</translation>
    </message>
    <message>
        <source>The residuals give no factors: uncertainties of the readings stay as stated</source>
        <translation>Los residuos no dan factores: las incertidumbres de las lecturas se quedan como se indicaron</translation>
    </message>
    <message>
        <source>Too little redundancy to say, so they stay as stated: %1</source>
        <translation>Redundancia insuficiente para decir algo, por lo que se quedan como se indicaron: %1</translation>
    </message>
    <message>
        <source>as seen: %1 times what was stated</source>
        <translation>observada: %1 veces la indicada</translation>
    </message>
    <message>
        <source>measured places</source>
        <translation>lugares medidos</translation>
    </message>
    <message>
        <source>encoders of the joints</source>
        <translation>codificadores de las articulaciones</translation>
    </message>
    <message>
        <source>repeatability of the joints</source>
        <translation>repetibilidad de las articulaciones</translation>
    </message>
    <message>
        <source>Residuals over their standard uncertainties as stated</source>
        <translation>Residuos divididos por sus incertidumbres típicas indicadas</translation>
    </message>
    <message>
        <source>others</source>
        <translation>otras</translation>
    </message>
    <message>
        <source>Quantiles of the residuals</source>
        <translation>Cuantiles de los residuos</translation>
    </message>
    <message>
        <source>normal distribution</source>
        <translation>distribución normal</translation>
    </message>
    <message>
        <source>The readings cannot tell apart, and give one factor to: %1.</source>
        <translation>Las lecturas no permiten distinguir, y dan un solo factor a: %1.</translation>
    </message>
    <message>
        <source>The estimate of the variance was negative, so it is zero, of: %1.</source>
        <translation>La estimación de la varianza resultó negativa, por lo que se toma cero, de: %1.</translation>
    </message>
    <message>
        <source>The global test does not see that figures which are too large and figures which are too small make up for each other: %1.</source>
        <translation>El contraste global no ve que cifras demasiado grandes y cifras demasiado pequeñas se contrarrestan: %1.</translation>
    </message>
    <message>
        <source>seen is smaller</source>
        <translation>la observada es menor</translation>
    </message>
    <message>
        <source>seen is larger</source>
        <translation>la observada es mayor</translation>
    </message>
    <message>
        <source>too little to say</source>
        <translation>muy poco para un veredicto</translation>
    </message>
    <message>
        <source>Stated and seen uncertainties</source>
        <translation>Incertidumbres indicadas y observadas</translation>
    </message>
    <message>
        <source>figure</source>
        <translation>cifra</translation>
    </message>
    <message>
        <source>stated u</source>
        <translation>u indicada</translation>
    </message>
    <message>
        <source>factor</source>
        <translation>factor</translation>
    </message>
    <message>
        <source>seen u</source>
        <translation>u observada</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>veredicto</translation>
    </message>
    <message>
        <source>Nothing is redundant: the readings say nothing.</source>
        <translation>Nada es redundante: las lecturas no dicen nada.</translation>
    </message>
    <message>
        <source>More than %1 readings: their factors are not computed.</source>
        <translation>Más de %1 lecturas: sus factores no se calculan.</translation>
    </message>
    <message>
        <source>The factors of the figures do not come to rest.</source>
        <translation>Los factores de las cifras no se estabilizan.</translation>
    </message>
    <message>
        <source>Global test: s₀ = %1 with %2 degrees of freedom passes (%3 to %4).</source>
        <translation>Contraste global: s₀ = %1 con %2 grados de libertad, se supera (%3 a %4).</translation>
    </message>
    <message>
        <source>Global test: s₀ = %1 with %2 degrees of freedom fails (%3 to %4).</source>
        <translation>Contraste global: s₀ = %1 con %2 grados de libertad, no se supera (%3 a %4).</translation>
    </message>
    <message>
        <source>Mean u of a coordinate: %1 as stated, %2 as seen.</source>
        <translation>u media de una coordenada: %1 según lo indicado, %2 según lo observado.</translation>
    </message>
    <message>
        <source>Geometry from points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines, planes, circles, spheres, cylinders and cones through measured points by orthogonal least squares: place, direction, diameter and form deviation with the full covariance of the points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points weigh alike, whatever their uncertainty, as in least-squares features of coordinate measurement; their covariance goes into the uncertainty of the results.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A circle in space is fitted in two steps, as NIST&apos;s: the plane by all points, then the circle by the points projected onto it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The direction has its largest component positive; that of a cone leads from the apex into it. &quot;Reversed&quot; turns it. Trials keep the sign of the estimates.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The place of a plane or line is the mean of the points; of a cylinder or cone it is the point of the axis next to that mean, so the uncertainty along the axis is that of the mean.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every trial of a Monte Carlo run fits its points anew. Form deviations of trials are larger than that of the points as measured, for uncertainty adds to what is form.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forms that are fitted to points by orthogonal least squares.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the feature, unique.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>form</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is fitted to its points. In the xy-plane z does not matter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sphere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line in the xy-plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>circle in the xy-plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reversed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The direction is stated with the other sign: the largest component of the direction is negative, that of a cone leads to its apex.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Form deviations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Peak to valley and root mean square of the points&apos; deviations from their feature are results too.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured points of the features, typed, pasted or from a CSV file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The feature that it is a point of; empty: that of the row above, of the first row the first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the point, unique in its feature; empty: its number. Of points that an analysis measured the name there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured coordinate x; empty where the point is a feature of an analysis, and z in the xy-plane.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured coordinate y; empty where the point is a feature of an analysis, and z in the xy-plane.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured coordinate z; empty where the point is a feature of an analysis, and z in the xy-plane.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of coordinate x of this point; empty: as for all points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of coordinate y of this point; empty: as for all points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of coordinate z of this point; empty: as for all points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correlation coefficient of the point&apos;s own x and y.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correlation coefficient of the point&apos;s own x and z.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correlation coefficient of the point&apos;s own y and z.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Typed, from the scatter of the points about their feature, or of what measured them: an instrument of the project, or an analysis whose results are points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from the scatter about the feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an instrument or an analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of every coordinate of every point that states none, independent of all others.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of a deviation along x that all points share beside their own: where the instrument stands.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of a deviation along y that all points share beside their own: where the instrument stands.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Common u of z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of a deviation along z that all points share beside their own: where the instrument stands.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An instrument that stands somewhere, whose scale and station are alike for all points; or an analysis, whose points are known by their names and are evaluated with this one in every trial.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relation of features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distances, angles, intersections and frames of features and points that other analyses measured, or that are typed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Features are evaluated with the relations as one model in every trial: what two features have in common, as the station of their instrument, cancels where it cancels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A direction is that of the feature, with its sign: of a plane the normal. The angle of a line and a plane is 90° less the angle of their directions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The angle of nearly parallel directions is never negative, so its estimate is too large where its uncertainty is not small; tilts have signs and no such bias.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A frame&apos;s angles are those of Z-Y-X: R = Rz(γ) Ry(β) Rx(α).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results of analyses (features, targets, frames&apos; origins), or typed ones, such as the direction of gravity.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the feature here, unique.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The analysis whose result it is; empty: place and direction are typed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its name in that analysis: a feature, a target, &quot;apex of C1&quot;; empty: the name here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Typed coordinate x; empty: 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Typed coordinate y; empty: 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Typed coordinate z; empty: 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Typed direction, component x, of any length; empty: it has none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Typed direction, component y, of any length; empty: it has none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Typed direction, component z, of any length; empty: it has none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of each typed coordinate; empty: none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of the typed direction, of two tilts across it; empty: none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distances, angles, intersections and frames of the features.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the result, unique.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>relation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is wanted of the features.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distance of two places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distance of a place from a plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distance of a place from a line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distance of two lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle of two directions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tilts of a direction against another</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>middle of two places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>foot of a place on a plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>foot of a place on a line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>intersection of a line and a plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>intersection of two lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>intersection of three planes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line of two planes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frame: origin, z, x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frame: origin on a plane, its normal z, x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A feature: the place, line or plane that is asked about; of a frame its origin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another one: what it is related to; of a frame the direction of z.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>third</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A third one: the third plane; of a frame and of tilts what x points to, along its direction if it has one, else towards its place.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance meter on a baseline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zero offset and standard deviation of a distance meter from distances between all pairs of pillars on a line, with their uncertainties, and the statistical tests of ISO 17123-4; its scale, where lengths of the baseline are known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All pairs of n pillars, read once each: the cofactor of the zero offset is 6/((n − 1)(n − 2)) whatever the lengths, and there are n (n − 1)/2 − n degrees of freedom.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits of the tests are quantiles of chi-squared, F and t for the degrees of freedom that the readings have, not figures of a table.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Any set of readings that tells the unknowns is adjusted, also one with pairs left out or repeated; readings that repeat without the instrument set up anew agree better than the instrument does.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distances count with equal weights.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distances between pillars that stand on a line, best of all pairs, each with the instrument set up anew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pillar of the instrument.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pillar of the reflector.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As read, with the correction for the atmosphere and without one for the zero.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the reflector above the instrument, where the distance is a slope distance; empty: it is horizontal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tests</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>σ, stated or wanted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard deviation of one distance that test a holds s against: of the maker, or what a job needs. Empty: no test a.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>s of another campaign</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experimental standard deviation that test b compares s with: of another instrument or day. Empty: no test b.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its degrees of freedom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the s of the other campaign: 14 for all pairs of seven pillars.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probability of the tests</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 − α: an instrument that is as good as stated passes a test with this probability.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale correction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Readings alone say nothing of it: it needs lengths of the baseline that are known better.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not asked for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>by reference lengths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference lengths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Horizontal lengths from the pillar where the line begins, of a certificate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pillar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As in the readings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the pillar where the line begins.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of this length alone, beside what all share; empty: none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u of the baseline&apos;s scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relative standard uncertainty that all reference lengths share.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u of the correction for the atmosphere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relative standard uncertainty that all readings share: 1 °C or 3.5 hPa are about 1 ppm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Planes, circles, axes and balls through measured points, with form deviations.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame, distances and angles of features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A frame as shops make it of a face, a bore and a hole, and where other features are from it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zero offset and standard deviation of a distance meter, with the tests of ISO 17123-4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Total station on a baseline of seven pillars</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The distance meter of a total station, tested after ISO 17123-4 with distances between all pairs of seven pillars.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flange and tool of a robot, from measured points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A laser tracker probed the flange of a robot: its face, its bore, a dowel hole, the shank of a tool and the ball at its tip.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Form deviations of a turned part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A coordinate measuring machine probed a seat, a taper, a face and a groove.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, point %2, coordinate %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>common deviation of all points along %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scatter of the points of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>residuals of %1 points about %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an instrument measures points in space; &apos;%1&apos; lies in the xy-plane: state the uncertainty of its points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>orthogonal distances of the points from the feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>circle in its plane, cylinder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cone, half angle φ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>form deviations of m points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two features are called &apos;%1&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no feature called &apos;%2&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the direction of &apos;%1&apos; is zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>typed coordinate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tilt of the typed direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, direction along %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two relations are called &apos;%1&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&apos;%1&apos; takes two features; leave the third empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&apos;%1&apos; needs three features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no feature &apos;%1&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no direction, which &apos;%2&apos; needs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, tilt towards x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, tilt towards y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, rotation about %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the two places are the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the place is on the line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the two are parallel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the directions are parallel: ask for tilts, which have a sign</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the line is parallel to the plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the three planes have no common point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x and z are parallel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&apos;%1&apos;: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>elementary geometry; p places, n unit directions of the first, second, third</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from a plane; from a line the length across n₂</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>between lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tilts, z = n₂</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frames, v of the third</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>centre of %1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>point on the axis of %1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>place of %1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>point on %1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>normal of %1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>direction of the axis of %1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>direction of %1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flatness deviation of %1, peak to valley</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>straightness deviation of %1, peak to valley</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>roundness deviation of %1, peak to valley</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cylindricity deviation of %1, peak to valley</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>form deviation of %1, peak to valley</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>diameter of %1 at its point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>diameter of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>form deviation of %1, root mean square</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>apex of %1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two points of &apos;%1&apos; are called &apos;%2&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no point called &apos;%2&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>point &apos;%1&apos; has no coordinate %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&apos;%1&apos; has %2 points; a %3 needs %4 or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the %1 points of &apos;%2&apos; do not scatter: with so few the form goes through all of them; add points, or state their uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the points of &apos;%1&apos;: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the points of &apos;%1&apos; lie exactly on it: their scatter says nothing of their uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>they are so nearly flat or straight that they determine no radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no %1 that fits them was found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all of them are the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>they are too far from each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>they lie on a straight line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>they lie on a plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How well the points determine the features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at a standard deviation of 1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at the scatter of the points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainties that independent deviations of all coordinates alike would give, first with a standard deviation of 1 mm: they depend on where the points are alone. Places and tilts are along the directions in which they are largest and smallest.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>place across the axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>offset across the line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>offset along the normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>diameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle of the cone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>correlation of diameter and centre along the middle of the arc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle to both sides of that middle within which the points are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Features and the scatter of their points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>s is the root of the sum of squares of the deviations over the degrees of freedom.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviations of the points from their features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>above the plane of the circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Positive outside of a circle, sphere, cylinder or cone and on the side of a plane to which its normal points; of a line in space the distance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the points of &apos;%1&apos; are within %2° of the middle of their arc: its diameter has %3 times the standard uncertainty of a coordinate and correlates with the place of the centre by %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>apex of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all pairs of pillars, ISO 17123-4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N distances between n pillars; JCGM 100 H.3.2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>JCGM 100 E.4.3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scale, by the reference lengths L_j</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scatter of the distances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>least squares, residuals of %1 distances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zero offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>place of pillar %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>standard deviation of one distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>few degrees of freedom of s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference lengths and their conditions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scale of the readings by the atmosphere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>correction for the atmosphere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scale of the baseline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference length of pillar %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zero offset, added to a reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scale correction, times a reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the readings do not tell the zero offset from the lengths: some line of three pillars must be read whole and in parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a distance from pillar &apos;%1&apos; to itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the height difference in row %1 is not shorter than the slope distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a zero offset needs distances between three pillars or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 distances for %2 lengths and the zero offset leave nothing that would tell the scatter: read more pairs of pillars</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the distances do not connect all pillars</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pillar &apos;%1&apos; has two reference lengths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no reading is to or from pillar &apos;%1&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference lengths begin at pillar &apos;%1&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a: s is not larger than the stated σ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>b: s and the s of the other campaign are of one σ, s²/s²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>c: the zero offset is not different from zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A zero offset is seen: add it to readings, or enter it in the instrument.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pillars</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>s of one distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>standard uncertainty of s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>standard uncertainty of the zero offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cofactor of the zero offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>residual over its s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>passed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not passed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line of the baseline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>baseline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scatter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the name of the file says that it is a %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file does not say which form its points have: a %1 is fitted; choose another one in the table of features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the first line is not a number of points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x y z were expected, %1 columns found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the first line announces %1 points, but there are %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what stands behind the %1 points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 points; their uncertainty is taken from their scatter about the form</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 points; state their uncertainty: the file says nothing of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>List of coordinates (NIST .ds)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Statistical tests</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>test</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lengths of the baseline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Readings and their residuals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Residuals of the distances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>−s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainties of the points are used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As stated; or as the residuals of least-squares frames see them: stated ones times one common factor, or times the factor of each figure (variance components). Either has the degrees of freedom of its estimate. What all points share stays as stated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zero, scale, refraction, index and collimation of an instrument are unknowns with or without a prior, which all of its readings share.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map projections are not part of it: reduce the readings before. The curvature of the Earth counts in zenith angles where its radius is given.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which instrument read it: readings of one kind by one instrument rest on one figure when stated uncertainties are held against the residuals, and share its figures.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A reading that is left out stays in the table, and is told among those left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Figures as seen in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another network, rounds of a total station say, whose residuals see what its readings are worth. Readings of the same kind and instrument get the standard uncertainty that it sees, with its degrees of freedom, and follow its readings; others stay as stated here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Figures of instruments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What an instrument does to all of its readings alike, with what is known of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the instrument, as in the column of the readings; empty: of all readings without one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it does to all of its readings alike: its zero is added to distances, by its scale (weather correction included) they are longer, refraction bends its lines of sight, its index is added to zenith angles, its collimation over the sine of the zenith angle to directions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zero of distances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>refraction coefficient</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vertical index</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>knowledge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unknown: the readings tell it; stated with u: its value is one more reading, which all of the instrument&apos;s share; fixed without uncertainty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The zero; 0 where it is empty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of a stated zero.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scale beyond 1, or the refraction coefficient.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u of ratio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of a stated scale or refraction coefficient.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The index or collimation; 0 where it is empty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of a stated index or collimation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius of the Earth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the curvature of the Earth counts in zenith angles; empty: it does not.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refraction coefficient</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of zenith angles, where the curvature of the Earth counts and no instrument states its own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gross readings beyond</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Readings that miss what the others agree on (a robust adjustment) by more, an angle at its target, are left out; empty: none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points that nothing tells</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They are refused, by name; or left out with their readings, and told.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>are refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>are left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outliers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All readings are kept, and the adjustment says which contradict the others; or the search begins robustly (Huber&apos;s weights), and readings with |w| beyond 3.29 are left out, each with its reason.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>are kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robust start, and left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainties of the points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As stated; or as the distances of the points from their circles see them: stated ones times one common factor, or times the factor of each figure (variance components). Either has the degrees of freedom of its estimate. What all points share stays as stated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainties of points and readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As stated; or as the residuals of this fit see them: stated ones times one common factor, or times the factor of each figure (variance components). Either has the degrees of freedom of its estimate. What all poses share stays as stated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stated ones weigh the points and are used as they are; or they are used as the residuals see them: times one common factor, or times one of x and one of y. Either has the degrees of freedom of its estimate. What all points share stays as stated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accuracy and repeatability of poses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What ISO 9283 asks of a robot, from measured poses: AP and RP, distances, directions of approach, drift; with the uncertainty that few cycles and the instrument leave, and decisions about a maker&apos;s figures.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RP of the standard comes out too small from few cycles: by 2 % from 30 and 7 % from 10, where the scatter is alike in all directions. The result is multiplied by what that is for the shape of the scatter seen; the table gives RP as the standard defines it beside it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scatter is taken to be normal. The law of RP for the number of cycles and the shape of the scatter comes from up to 4,000 simulated campaigns, always the same ones.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits and numbers of cycles of the standard are not built in: what is held against a figure is what is entered. Formulas of directions, distances and drift are those in common use; hold them against the text of the standard before a sheet names it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RP² is split between robot and instrument as if both scattered in one shape.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commanded poses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the robot was sent to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name, unique: P1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commanded coordinate x in the base of the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commanded coordinate y in the base of the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commanded coordinate z in the base of the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commanded angle of the orientation; empty: orientations are not evaluated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attained poses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A row for every cycle in the order of measurement, typed, pasted or from a CSV file. The coordinates are those of the robot&apos;s base.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As in the commanded poses.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From where the pose was approached, where there are several ways; empty: one for all.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the series of cycles, where it is repeated to see a drift; empty: there is one series.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attained coordinate x in the base of the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attained coordinate y in the base of the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attained coordinate z in the base of the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attained angle of the orientation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pairs of poses whose distance is held against the commanded one, cycle by cycle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A commanded pose.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another one, with as many cycles.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u of a measured coordinate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty that all cycles of a pose share: of the instrument and of the robot&apos;s base in its frame. It is part of u(AP), not of RP.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scatter of the instrument</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the instrument scatters by itself is part of RP. Where it is known, RP² less its RP² is that of the robot, if both scatter alike in all directions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not taken out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its RP from a fixed target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>readings of a fixed target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RP of the instrument alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>l̄ + 3 s of readings of a fixed target, as measured in the cell.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of readings that it is taken from: so well is it known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Readings of a fixed target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coordinates of a target that does not move, read as the poses were.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read coordinate x.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read coordinate y.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read coordinate z.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Decisions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rated AP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The maker&apos;s figure; empty: nothing is decided.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rated RP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probability of a decision</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A robot conforms where this is the probability that its figure is not above the rated one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U of the instrument</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expanded uncertainty of the measured position, k = 2; empty: it is not held against AP and RP.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest ratio of U to AP, RP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the standard or the contract allows, as it says it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two-face and length tests of a tracker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Errors of a laser tracker at the positions of its acceptance test, with the uncertainty of the test, and the decision whether they are within the maximum permissible errors.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Positions, numbers of repetitions and limits are those that are entered: none of a standard is built in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The uncertainty of a test value is what the test adds, not the scatter of the tracker: that is what is tested.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A row for every position, typed, pasted or from a CSV file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number or name of the position, unique.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two-face: a fixed target read in both faces. Length: a reference length.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two-face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two-face: distance across the beam between the readings of both faces. Length: as measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrated length, of a length test.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance of the target, or of the middle of the length, from the tracker.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its horizontal angle; empty: 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its angle above the horizon; empty: 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of this test value; empty: that of its kind, as below.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MPE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limit for this position; empty: it follows from constant and slope, as below.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MPE two-face, constant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the maker states it for a two-face test; empty: every two-face test has its own MPE.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MPE two-face, per metre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Times the range of the target.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MPE length, constant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the maker states it; empty: every length has its own MPE.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MPE length, per metre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Times the reference length.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty of the test values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u of a two-face value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of what the test adds: seat of the reflector, motion of its mount. Not the scatter of the tracker, which is tested.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u of a length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of what the test adds to each length: calibration, mounting, temperature. Not the scatter of the tracker.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u of the scale of the references</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A position conforms where this is the probability that its error is within the MPE.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accuracy and repeatability of a robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AP and RP of ISO 9283 from measured poses, and whether the maker&apos;s figures are met.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceptance test of a tracker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two-face and length tests against their limits, with the uncertainty of the test.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot at five poses, thirty cycles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An industrial robot, sent thirty times to each of five poses and measured by a laser tracker: AP and RP after ISO 9283 with what thirty cycles and the tracker leave open of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From rounds of a total station to a certificate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Four rounds of a total station say what its readings are worth: a network takes their figures as seen, a pose takes its points from the network, and the certificate states the pose.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceptance test of a laser tracker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A laser tracker, tested with fixed reflectors read in both faces from three distances, and with a reference length of 2.3 m.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is a temperature in %3, and here it would be taken in kelvin (20 degC as 293.15 K): if it is a difference, give it in %4; for its reading in %3 write (%2 - 0 [%3]). Only the ratio of two temperatures in %3 is taken in kelvin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is a multiple of a temperature in %2, which depends on where the scale has its zero: if the temperature is a difference, give it in %3; else multiply its reading, as in 1.5*(t - 0 [%2])</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a part (%, ppm) or multiple of a temperature in %1 depends on where the scale has its zero: give the figure in %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a difference: %1 in %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; is %3; its unit is missing: write &quot;%4 [%5]&quot;</source>
        <translation type="unfinished">la columna &apos;%1&apos; de &apos;%2&apos; es %3; falta su unidad: escriba &quot;%1 [%4]&quot; {1&apos;?} {2&apos;?} {3;?} {4 ?} {5]?}</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; is a difference of temperatures: give it in %3, not in %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is a difference of temperatures: give it in %2, not in %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The figures of the set-up are too far apart in size for %1: the last digits of the estimates change its sensitivity coefficients by more than a tenth. Give coordinates from a place nearby.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>uncertainties as the residuals see them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stated figures of instruments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 does not see these figures, so they stay as stated here: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>readings of figures that are seen elsewhere are correlated with others here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the readings from %1 agree if the names %2 and %3 are exchanged there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as seen in %1: %2 times what is stated here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the only direction of its round, whose orientation is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it contradicts the others: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it contradicts the others: %1; it cannot be told apart from %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing tells them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x and y of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the height of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing tells it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its point %1 is left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the height of %1 is left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it misses what the others agree on by %1 m, more than %2 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>|w| = %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 times its u in a robust adjustment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>by hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is left out: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and %1 more are left out, listed with their reasons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zero c and scale m of distances, index i, refraction k</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all instruments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the zero of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the scale of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the refraction coefficient of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the vertical index of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the collimation of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is stated twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 needs the radius of the Earth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no reading that %1 would change: readings say their instrument in their column</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outlier? it cannot be told apart from %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reason</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the readings cannot tell %1 apart: add readings that see them differently, or state one of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing tells %1: add readings that see it, or state it with u</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 readings cannot tell %2 unknowns (coordinates less what the datum takes, orientations, figures of instruments): add %3 readings at least, or state figures with u</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>instruments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>base points, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>points of the moving frame, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>joint %1, point %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, off the plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, along the radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a thermodynamic temperature: %1 in %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its reading in %2: %1 - 0 [%2]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a part of its reading in %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a temperature: %1 in %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y of the points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x of the points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the distance in row %1 is too long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 distances between %2 pillars are more than a baseline has: at most %3 between %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cycles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>few cycles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cycles, normal scatter of the shape seen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>barycentre of %1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scatter of the cycles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeatability of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean deviation of angle %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeatability of angle %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>instrument and base of the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>error of the measured place of %1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean distance %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeatability of distance %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeatability of the instrument alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ISO 9283, accuracy of a pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ISO 9283, repeatability; c = RP(∞)/RP(n) by simulated campaigns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>without the instrument, where both scatter in one shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of several directions of approach</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distances between poses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drift</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>accuracy of the pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeatability of the pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeatability of the robot alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>share of the instrument in RP²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>accuracy of angle %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeatability of angle %1, ±</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>variation of the accuracy over the directions of approach</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drift of the accuracy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drift of the repeatability</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>accuracy of the distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeatability of the distance, ±</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the instrument alone scatters as much as what it measured at %1: nothing is left that could be called the robot&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two series are called &apos;%1&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no commanded pose &apos;%1&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has fewer than three cycles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>row %1 has angles, though its pose is commanded without them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>row %1 has no angles, though its pose is commanded with them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the coordinates at %1 are too large</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pose &apos;%1&apos; is commanded twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pose &apos;%1&apos; is commanded with some angles and without others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>some poses are commanded with all angles and others are not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no cycles were measured at pose &apos;%1&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a distance from pose &apos;%1&apos; to itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the distance from &apos;%1&apos; to &apos;%2&apos; is there twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>poses &apos;%1&apos; and &apos;%2&apos; have different numbers of cycles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the coordinates of the fixed target in row %1 are too large</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U of the instrument and the largest ratio go together: enter both, or neither</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AP by scatter alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RP, few cycles allowed for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where AP is not twice what the scatter of the cycles alone makes of it, it says little about the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest s of an axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>smallest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean RP over that of many cycles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>relative u of RP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>conforms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>does not conform</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not decided</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>probability of conformity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>risk that it is wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cycles that would decide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AP of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RP of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U of the instrument over AP of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U of the instrument over RP of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>poses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean AP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest AP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>quantile of AP for the probability of a decision</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 poses are too few to bound this quantile: the largest of %2 poses does, with the same probability.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two-face: distance of both readings across the beam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>length; a: scale of the references</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>decision, ISO 14253-1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scale of the reference lengths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>uncertainty of the test</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>uncertainty of the test values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measured length at position %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distance of both faces at position %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>error at position %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there are two tests of position &apos;%1&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the length at position &apos;%1&apos; has no reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the two-face test of position &apos;%1&apos; has a reference length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing says the MPE of position &apos;%1&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tracker conforms at every position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tracker does not conform.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Some positions are not decided: the test is not good enough to tell.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distance %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pose %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>directions of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drift of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>base of the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>references</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tracker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&apos;%1&apos; in row %2 of %3 must be %4, not %5: %6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be a number, not %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be true or false, not %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a difference of temperatures is given in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>write true or false, without quotes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>write a text in quotes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>write it in quotes: &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>write a number without quotes, such as 0.25, or null where there is none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>write %1, without quotes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>write a number in %1, the unit of the column, without quotes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>write %1, without quotes: the unit of the column is %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>write %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>observations that miss what the others agree on by more than %1 m, and points that nothing tells, are left out, as Gama does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file asks for standard deviations a posteriori: for these choose uncertainties as seen, one factor s_0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: readings are not reduced to an ellipsoid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>update-constrained-coordinates: the datum keeps the coordinates of the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accuracy and repeatability, from the cycles as they are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cycles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What few cycles do to RP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Conformity with the maker&apos;s figures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>decision</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Is the instrument good enough</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AP over the poses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accuracy and repeatability of the poses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AP, RP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rated AP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rated RP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Decisions after ISO 14253-1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui</name>
    <message>
        <source>Add %1</source>
        <translation>Añadir %1</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>«%1» no es un número.</translation>
    </message>
    <message>
        <source>“%1” is not a unit.</source>
        <translation>«%1» no es una unidad.</translation>
    </message>
    <message>
        <source>a number without unit is expected.</source>
        <translation>se espera un número sin unidad.</translation>
    </message>
    <message>
        <source>a unit like %1 is expected.</source>
        <translation>se espera una unidad como %1.</translation>
    </message>
    <message>
        <source>The unit %1 does not fit here: </source>
        <translation>La unidad %1 no es adecuada aquí: </translation>
    </message>
    <message>
        <source>“%1” is not a whole number.</source>
        <translation>«%1» no es un número entero.</translation>
    </message>
    <message>
        <source>“%1” is not one of: %2.</source>
        <translation>«%1» no es uno de: %2.</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sí</translation>
    </message>
    <message>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <source>“%1” is neither yes nor no.</source>
        <translation>«%1» no es ni sí ni no.</translation>
    </message>
    <message>
        <source>The value must be greater than %1.</source>
        <translation>El valor debe ser mayor que %1.</translation>
    </message>
    <message>
        <source>The value must be at least %1.</source>
        <translation>El valor debe ser al menos %1.</translation>
    </message>
    <message>
        <source>The value must be at most %1.</source>
        <translation>El valor debe ser como máximo %1.</translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation>Grados de libertad</translation>
    </message>
    <message>
        <source>Unsaved Changes</source>
        <translation>Cambios sin guardar</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>¿Guardar los cambios de «%1»?</translation>
    </message>
    <message>
        <source>Without saving they are lost.</source>
        <translation>Si no se guardan, se perderán.</translation>
    </message>
    <message>
        <source>File Changed</source>
        <translation>Archivo modificado</translation>
    </message>
    <message>
        <source>Another program changed “%1”.</source>
        <translation>Otro programa ha modificado «%1».</translation>
    </message>
    <message>
        <source>Reading it again loses your unsaved changes.</source>
        <translation>Al leerlo de nuevo se pierden los cambios sin guardar.</translation>
    </message>
    <message>
        <source>It can be read again.</source>
        <translation>Se puede leer de nuevo.</translation>
    </message>
    <message>
        <source>Read Again</source>
        <translation>Leer de nuevo</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>Conservar el mío</translation>
    </message>
    <message>
        <source>Recover Unsaved Work</source>
        <translation>Recuperar trabajo sin guardar</translation>
    </message>
    <message>
        <source>Covaria did not end properly. Unsaved work was kept:</source>
        <translation>Covaria no se cerró correctamente. Se conservó trabajo sin guardar:</translation>
    </message>
    <message>
        <source>Open Project</source>
        <translation>Abrir proyecto</translation>
    </message>
    <message>
        <source>Covaria project or report (*.covaria *.pdf)</source>
        <translation>Proyecto o informe de Covaria (*.covaria *.pdf)</translation>
    </message>
    <message>
        <source>About Covaria</source>
        <translation>Acerca de Covaria</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Covaria %1&lt;/h3&gt;&lt;p&gt;Measurement uncertainty of robots and large-scale metrology.&lt;br&gt;Evaluates by JCGM 100, 101 and 102.&lt;/p&gt;&lt;p&gt;Qt %2, VTK %3, Eigen %4&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Covaria %1&lt;/h3&gt;&lt;p&gt;Incertidumbre de medida de robots y metrología de grandes dimensiones.&lt;br&gt;Evalúa según JCGM 100, 101 y 102.&lt;/p&gt;&lt;p&gt;Qt %2, VTK %3, Eigen %4&lt;/p&gt;</translation>
    </message>
    <message>
        <source>symbol</source>
        <translation>símbolo</translation>
    </message>
    <message>
        <source>As the equations use it; further rows of a symbol add components</source>
        <translation>Como lo usan las ecuaciones; otras filas de un símbolo añaden componentes</translation>
    </message>
    <message>
        <source>quantity</source>
        <translation>magnitud</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Qué es</translation>
    </message>
    <message>
        <source>estimate</source>
        <translation>estimación</translation>
    </message>
    <message>
        <source>In the row&apos;s unit: 50.000 838 or 50.000 838 mm</source>
        <translation>En la unidad de la fila: 50.000 838 o 50.000 838 mm</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>unidad</translation>
    </message>
    <message>
        <source>stated as</source>
        <translation>indicada como</translation>
    </message>
    <message>
        <source>distribution</source>
        <translation>distribución</translation>
    </message>
    <message>
        <source>That Monte Carlo draws</source>
        <translation>De la que extrae Monte Carlo</translation>
    </message>
    <message>
        <source>type</source>
        <translation>tipo</translation>
    </message>
    <message>
        <source>Type A or Type B evaluation (JCGM 100 2.3.2, 2.3.3)</source>
        <translation>Evaluación de Tipo A o de Tipo B (JCGM 100 2.3.2, 2.3.3)</translation>
    </message>
    <message>
        <source>Degrees of freedom; empty: infinite, or those of the observations</source>
        <translation>Grados de libertad; vacío: infinitos, o los de las observaciones</translation>
    </message>
    <message>
        <source>Standard uncertainty, in the row&apos;s unit</source>
        <translation>Incertidumbre típica, en la unidad de la fila</translation>
    </message>
    <message>
        <source>Sensitivity coefficient, unit of the result per unit of the row</source>
        <translation>Coeficiente de sensibilidad, unidad del resultado por unidad de la fila</translation>
    </message>
    <message>
        <source>Contribution to the standard uncertainty of the result</source>
        <translation>Contribución a la incertidumbre típica del resultado</translation>
    </message>
    <message>
        <source>share / %</source>
        <translation>parte / %</translation>
    </message>
    <message>
        <source>Share of the variance, with its part of the covariances</source>
        <translation>Parte de la varianza, con su parte de las covarianzas</translation>
    </message>
    <message>
        <source>source</source>
        <translation>fuente</translation>
    </message>
    <message>
        <source>Where the figure comes from</source>
        <translation>De dónde procede la cifra</translation>
    </message>
    <message>
        <source>Standard uncertainty of the position in space: square root of the sum of the variances of its three coordinates</source>
        <translation>Incertidumbre típica de la posición en el espacio: raíz cuadrada de la suma de las varianzas de sus tres coordenadas</translation>
    </message>
    <message>
        <source>, as good as %1 plain trials</source>
        <translation>, tan buena como %1 pruebas sencillas</translation>
    </message>
    <message>
        <source>Preview by the law of propagation, without Monte Carlo</source>
        <translation>Vista previa por la ley de propagación, sin Monte Carlo</translation>
    </message>
    <message>
        <source>Preview with %1 trials, before the adaptive procedure</source>
        <translation>Vista previa con %1 pruebas, antes del procedimiento adaptativo</translation>
    </message>
    <message>
        <source>Preview with %1 of %2 trials</source>
        <translation>Vista previa con %1 de %2 pruebas</translation>
    </message>
    <message>
        <source>Law of propagation of uncertainty</source>
        <translation>Ley de propagación de la incertidumbre</translation>
    </message>
    <message>
        <source>Monte Carlo, %1 trials</source>
        <translation>Monte Carlo, %1 pruebas</translation>
    </message>
    <message>
        <source>Out of date: of the project as it was</source>
        <translation>Desactualizado: del proyecto tal como era</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>Duplicar %1</translation>
    </message>
    <message>
        <source>Expanded uncertainty</source>
        <translation>Incertidumbre expandida</translation>
    </message>
    <message>
        <source>the picture shows no result of the analysis</source>
        <translation>la imagen no muestra ningún resultado del análisis</translation>
    </message>
    <message>
        <source>the coordinates of %1 are no quantities of the analysis</source>
        <translation>las coordenadas de %1 no son magnitudes del análisis</translation>
    </message>
    <message>
        <source>%1 is a constant: no uncertainty is stated for it</source>
        <translation>%1 es constante: no se declara ninguna incertidumbre</translation>
    </message>
    <message>
        <source>the joint covariance of the points is not known</source>
        <translation>no se conoce la covarianza conjunta de los puntos</translation>
    </message>
    <message>
        <source>the angle is too close to 0° or 180°, or the points are too close, for the law of propagation</source>
        <translation>el ángulo está demasiado cerca de 0° o 180°, o los puntos demasiado próximos, para la ley de propagación</translation>
    </message>
    <message>
        <source>the points are too close to each other for the law of propagation</source>
        <translation>los puntos están demasiado próximos entre sí para la ley de propagación</translation>
    </message>
    <message>
        <source>%1, u = %2</source>
        <translation>%1, u = %2</translation>
    </message>
    <message>
        <source>Angle at %1 between %2 and %3: %4</source>
        <translation>Ángulo en %1 entre %2 y %3: %4</translation>
    </message>
    <message>
        <source>Distance %1 to %2: %3</source>
        <translation>Distancia de %1 a %2: %3</translation>
    </message>
    <message>
        <source>; u not stated, because %1</source>
        <translation>; u no se declara porque %1</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isométrica</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Superior</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Frontal</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Derecha</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Inferior</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Posterior</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Izquierda</translation>
    </message>
    <message>
        <source>Add an analysis</source>
        <translation>Añadir un análisis</translation>
    </message>
    <message>
        <source>The plus sign in the toolbar adds what a project consists of. Choose Measurement equation from its menu.</source>
        <translation>El signo más de la barra de herramientas añade las partes de un proyecto. Elija en su menú Ecuación de medida.</translation>
    </message>
    <message>
        <source>Name the quantities</source>
        <translation>Nombrar las magnitudes</translation>
    </message>
    <message>
        <source>Replace the equation in the field Equations by yours, such as l = l_S + d. Every name that it uses becomes a row of the budget when you leave the field.</source>
        <translation>Sustituya la ecuación del campo Ecuaciones por la suya, como l = l_S + d. Cada nombre que use será una fila del balance al salir del campo.</translation>
    </message>
    <message>
        <source>State an uncertainty</source>
        <translation>Declarar una incertidumbre</translation>
    </message>
    <message>
        <source>Type the estimate of each quantity into its row, such as 50 mm, and what is known of it under “stated as”, such as 75 nm. “rect 30 nm” and “U = 0.3 um, k = 2” are read as they are typed.</source>
        <translation>Escriba la estimación de cada magnitud en su fila, como 50 mm, y lo que se sabe de ella en “indicada como”, como 75 nm. “rect 30 nm” y “U = 0.3 um, k = 2” se leen tal como se escriben.</translation>
    </message>
    <message>
        <source>See the result</source>
        <translation>Ver el resultado</translation>
    </message>
    <message>
        <source>Correlate two quantities</source>
        <translation>Correlacionar dos magnitudes</translation>
    </message>
    <message>
        <source>Select two rows of the budget, the second with Ctrl, and type their correlation coefficient r into the field below, such as 0.5. The result takes it into account at once.</source>
        <translation>Seleccione dos filas del balance, la segunda con Ctrl, y escriba su coeficiente de correlación r en el campo de abajo, como 0.5. El resultado lo tiene en cuenta al instante.</translation>
    </message>
    <message>
        <source>State a requirement</source>
        <translation>Declarar un requisito</translation>
    </message>
    <message>
        <source>Type the uncertainty that must not be exceeded as Target uncertainty. The verdict below it, and in the table of results, follows every change.</source>
        <translation>Escriba como incertidumbre objetivo la que no debe superarse. El veredicto de debajo, y el de la tabla de resultados, sigue cada cambio.</translation>
    </message>
    <message>
        <source>See what contributes most</source>
        <translation>Ver qué contribuye más</translation>
    </message>
    <message>
        <source>Keep and compare</source>
        <translation>Conservar y comparar</translation>
    </message>
    <message>
        <source>Run the analysis (F5), press Keep as Before, and change a value of the budget. The tab Compare shows the results before and after beside each other.</source>
        <translation>Ejecute el análisis (F5), pulse Conservar como antes y cambie un valor del balance. La pestaña Comparar muestra los resultados de antes y después lado a lado.</translation>
    </message>
    <message>
        <source>Look at the report</source>
        <translation>Mirar el informe</translation>
    </message>
    <message>
        <source>Save it as PDF</source>
        <translation>Guardarlo como PDF</translation>
    </message>
    <message>
        <source># Keys

| Key | Does |
|---|---|
| Ctrl+N, Ctrl+O, Ctrl+S | new, open, save |
| Ctrl+Z; Ctrl+Shift+Z or Ctrl+Y | undo; redo |
| F6, Shift+F6 | next, previous pane |
| F11 | the budget or the scene alone, and back |
| Tab, Shift+Tab in a table | next, previous cell, and on behind the last one; with Ctrl out of the table at once |
| Ctrl+R in a budget | correlation coefficient of the two rows that are selected |
| F5, Ctrl+F5, Esc | run this analysis, run all, stop |
| F2, Ctrl+D, Delete | rename, duplicate, delete the selected entry |
| Arrow keys, + and − | turn and zoom the scene |
| 1 to 7, F | iso, top, front, right, bottom, back, left view, fit (Ctrl+1 to Ctrl+7 anywhere) |
| H, I, Shift+H | hide what is selected in the scene, show it alone, show all |
| Drag in the scene | moves a thing, turns it by the tip of an axis; with Ctrl in round steps |
| D, A | measure a distance, an angle in the scene; Esc puts the tool away |
| +, −, Ctrl+wheel in the report | larger, smaller pages; Alt+Up and Alt+Down: previous, next page |
| Ctrl+C, Ctrl+V | copy and paste blocks of cells |
| Ctrl+K | find anything: analyses, quantities, results, fields, commands, help |
| F1 | help on the field, cell or entry with the focus |
</source>
        <translation># Teclas

| Tecla | Acción |
|---|---|
| Ctrl+N, Ctrl+O, Ctrl+S | nuevo, abrir, guardar |
| Ctrl+Z; Ctrl+Mayús+Z o Ctrl+Y | deshacer; rehacer |
| F6, Mayús+F6 | panel siguiente, anterior |
| F11 | solo el balance o la escena, y vuelta |
| Tab, Mayús+Tab en una tabla | celda siguiente, anterior, y más allá de la última; con Ctrl, fuera de la tabla enseguida |
| Ctrl+R en un presupuesto | coeficiente de correlación de las dos filas seleccionadas |
| F5, Ctrl+F5, Esc | calcular este análisis, calcular todos, detener |
| F2, Ctrl+D, Supr | renombrar, duplicar, borrar la entrada elegida |
| Flechas, + y − | girar y ampliar la escena |
| 1 a 7, F | vista isométrica, superior, frontal, derecha, inferior, posterior, izquierda, ajustar (Ctrl+1 a Ctrl+7 en todas partes) |
| H, I, Mayús+H | ocultar lo seleccionado en la escena, mostrar solo eso, mostrar todo |
| Arrastrar en la escena | mueve un objeto, lo gira por la punta de un eje; con Ctrl en pasos redondos |
| D, A | medir una distancia, un ángulo en la escena; Esc deja la herramienta |
| +, −, Ctrl+rueda en el informe | páginas más grandes, más pequeñas; Alt+Arriba y Alt+Abajo: página anterior, siguiente |
| Ctrl+C, Ctrl+V | copiar y pegar bloques de celdas |
| Ctrl+K | buscar cualquier cosa: análisis, magnitudes, resultados, campos, órdenes, ayuda |
| F1 | ayuda sobre el campo, la celda o la entrada con el foco |
</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Deshacer: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>The analysis is not complete yet: what must still be given is listed under Problems.</source>
        <translation>El análisis aún no está completo: lo que falta figura en Problemas.</translation>
    </message>
    <message>
        <source>The analysis has problems; they are listed under Problems.</source>
        <translation>El análisis tiene problemas; figuran en Problemas.</translation>
    </message>
    <message>
        <source>Adaptive Monte Carlo, %1 trials</source>
        <translation>Monte Carlo adaptativo, %1 pruebas</translation>
    </message>
    <message>
        <source>; k leaves degrees of freedom out (normal draws)</source>
        <translation>; k sin grados de libertad (extracción normal)</translation>
    </message>
    <message>
        <source>, chosen k = %1</source>
        <translation>, k = %1 elegido</translation>
    </message>
    <message>
        <source>Of the estimate, and of what is stated without a unit</source>
        <translation>De la estimación y de lo indicado sin unidad</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>Deshecho: %1</translation>
    </message>
    <message>
        <source>Before these steps</source>
        <translation>Antes de estos pasos</translation>
    </message>
    <message>
        <source>Undo Lis&amp;t</source>
        <translation>&amp;Lista de pasos</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>Done again: %1</source>
        <translation>Rehecho: %1</translation>
    </message>
    <message>
        <source>Type it as %1.</source>
        <translation>Escríbalo como %1.</translation>
    </message>
    <message>
        <source>Type it as %1, or as %2.</source>
        <translation>Escríbalo como %1, o como %2.</translation>
    </message>
    <message>
        <source>met</source>
        <translation>cumplido</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>no cumplido</translation>
    </message>
    <message>
        <source>The result is there when every quantity has its uncertainty, above the budget and in the tab Results. It follows every change at once.</source>
        <translation>El resultado aparece cuando cada magnitud tiene su incertidumbre, encima del balance y en la pestaña Resultados. Sigue cada cambio de inmediato.</translation>
    </message>
    <message>
        <source>The tab Contributions has them as a table and as a chart, the largest first. What is at the top is worth improving.</source>
        <translation>La pestaña Contribuciones las muestra como tabla y como gráfico, la mayor primero. Lo que está arriba es lo que vale la pena mejorar.</translation>
    </message>
    <message>
        <source>The tab Document shows the pages as they are printed, of the report or of the certificate. It has results that are up to date only: run the analysis first (F5).</source>
        <translation>La pestaña Documento muestra las páginas tal como se imprimen, del informe o del certificado. Solo tiene resultados actualizados: ejecute antes el análisis (F5).</translation>
    </message>
    <message>
        <source>Report as PDF in the toolbar (Ctrl+P) writes the report with the project in it, so that Covaria can open it again. While the tab Document shows the certificate, the button writes that; it is also in the menu File under Export.</source>
        <translation>Informe en PDF en la barra de herramientas (Ctrl+P) escribe el informe con el proyecto dentro, de modo que Covaria puede volver a abrirlo. Mientras la pestaña Documento muestra el certificado, el botón escribe este; también está en el menú Archivo, en Exportar.</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>desactualizado</translation>
    </message>
    <message>
        <source>Kept projects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recover</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::AllResultsModel</name>
    <message>
        <source>Analysis</source>
        <translation>Análisis</translation>
    </message>
    <message>
        <source>Coverage interval of the result line</source>
        <translation>Intervalo de cobertura de la línea de resultado</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Double click: goes to the analysis</source>
        <translation>Doble clic: va al análisis</translation>
    </message>
</context>
<context>
    <name>covaria::ui::AllResultsTab</name>
    <message>
        <source>Filter: analysis, symbol, name, group</source>
        <translation>Filtro: análisis, símbolo, nombre, grupo</translation>
    </message>
    <message>
        <source>Filter of all results</source>
        <translation>Filtro de todos los resultados</translation>
    </message>
    <message>
        <source>Not met only</source>
        <translation>Solo no cumplidos</translation>
    </message>
    <message>
        <source>Only results whose target uncertainty or tolerance is not met</source>
        <translation>Solo resultados que no cumplen la incertidumbre objetivo o la tolerancia</translation>
    </message>
    <message>
        <source>all-results</source>
        <translation>todos-los-resultados</translation>
    </message>
    <message>
        <source>up to date</source>
        <translation>actualizado</translation>
    </message>
    <message>
        <source>%1 of %2 requirements met</source>
        <translation>%1 de %2 requisitos cumplidos</translation>
    </message>
    <message>
        <source>%1 of %2 analyses have no result: press Ctrl+F5</source>
        <translation>%1 de %2 análisis no tienen resultado: pulse Ctrl+F5</translation>
    </message>
    <message>
        <source>; </source>
        <translation>; </translation>
    </message>
    <message>
        <source>%1 of %2 analyses have no result: they lack something or have problems</source>
        <translation>%1 de %2 análisis no tienen resultado: les falta algo o tienen problemas</translation>
    </message>
</context>
<context>
    <name>covaria::ui::AnswerStrip</name>
    <message>
        <source>Answer</source>
        <translation>Respuesta</translation>
    </message>
    <message>
        <source>Output quantity of the budget and the charts</source>
        <translation>Magnitud de salida del balance y de los gráficos</translation>
    </message>
    <message>
        <source>Output quantity</source>
        <translation>Magnitud de salida</translation>
    </message>
    <message>
        <source>Copy the result, as it stands in a certificate</source>
        <translation>Copiar el resultado, tal como figura en un certificado</translation>
    </message>
    <message>
        <source>Copy the result</source>
        <translation>Copiar el resultado</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Próximo paso</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fallido</translation>
    </message>
    <message>
        <source>incomplete</source>
        <translation>incompleto</translation>
    </message>
    <message>
        <source>has problems</source>
        <translation>tiene problemas</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>desactualizado</translation>
    </message>
    <message>
        <source>not evaluated</source>
        <translation>no evaluado</translation>
    </message>
    <message>
        <source>Select an analysis to see its results.</source>
        <translation>Seleccione un análisis para ver sus resultados.</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Fallido: %1</translation>
    </message>
    <message>
        <source>Not complete yet: nothing is wrong.</source>
        <translation>Aún incompleto: no hay nada mal.</translation>
    </message>
    <message>
        <source>Not complete yet, but not wrong; to give next: %1</source>
        <translation>Aún incompleto, pero no hay nada mal; lo siguiente por indicar: %1</translation>
    </message>
    <message>
        <source>Not evaluated yet: press F5.</source>
        <translation>Aún no evaluado: pulse F5.</translation>
    </message>
    <message>
        <source>The analysis has problems.</source>
        <translation>El análisis tiene problemas.</translation>
    </message>
    <message>
        <source>; running</source>
        <translation>; en ejecución</translation>
    </message>
    <message>
        <source>; press F5 for the result</source>
        <translation>; pulse F5 para el resultado</translation>
    </message>
    <message>
        <source>; %1 trials without a value</source>
        <translation>; %1 pruebas sin valor</translation>
    </message>
    <message>
        <source>&lt;b&gt;Does not represent the measurand&lt;/b&gt; (more than 1 % of the trials are lost). </source>
        <translation>&lt;b&gt;No representa el mensurando&lt;/b&gt; (se pierde más del 1 % de las pruebas). </translation>
    </message>
    <message>
        <source>; not stabilised</source>
        <translation>; no estabilizado</translation>
    </message>
    <message>
        <source>&lt;b&gt;Out of date&lt;/b&gt;: shown for the project as it was. </source>
        <translation>&lt;b&gt;Desactualizado&lt;/b&gt;: se muestra para el proyecto tal como era. </translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Próximo: %1</translation>
    </message>
    <message>
        <source>Goes to the field that must be given next</source>
        <translation>Va al campo que debe indicarse a continuación</translation>
    </message>
    <message>
        <source>Show the Field</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::AssetEvaluation</name>
    <message>
        <source>The asset has problems; they are listed below the scene.</source>
        <translation>El recurso tiene problemas; se enumeran bajo la escena.</translation>
    </message>
    <message>
        <source>This asset is used as it is specified; nothing is evaluated.</source>
        <translation>Este recurso se usa tal como está especificado; no se evalúa nada.</translation>
    </message>
    <message>
        <source>Evaluation of the asset</source>
        <translation>Evaluación del recurso</translation>
    </message>
</context>
<context>
    <name>covaria::ui::BudgetPage</name>
    <message>
        <source>Correlation coefficient</source>
        <translation>Coeficiente de correlación</translation>
    </message>
    <message>
        <source>Select two rows, and type the correlation coefficient of their components</source>
        <translation>Seleccione dos filas y teclee el coeficiente de correlación de sus componentes</translation>
    </message>
    <message>
        <source>Budget</source>
        <translation>Balance</translation>
    </message>
    <message>
        <source>&lt;i&gt;r&lt;/i&gt; of two rows =</source>
        <translation>&lt;i&gt;r&lt;/i&gt; de dos filas =</translation>
    </message>
    <message>
        <source>Correlation of Two Rows</source>
        <translation>Correlación de dos filas</translation>
    </message>
    <message>
        <source>&lt;i&gt;r&lt;/i&gt;(%1, %2) =</source>
        <translation>&lt;i&gt;r&lt;/i&gt;(%1, %2) =</translation>
    </message>
    <message>
        <source>Both quantities need an uncertainty before they can be correlated</source>
        <translation>Ambas magnitudes necesitan una incertidumbre antes de poder correlacionarse</translation>
    </message>
    <message>
        <source>c and share by the law of propagation, whose u is %1 of that by Monte Carlo</source>
        <translation>c y parte según la ley de propagación, cuya u es %1 de la de Monte Carlo</translation>
    </message>
</context>
<context>
    <name>covaria::ui::BudgetSheetModel</name>
    <message>
        <source>Out of date: being computed.</source>
        <translation>Desactualizado: se está calculando.</translation>
    </message>
    <message>
        <source>Type a name here to add a quantity</source>
        <translation>Teclee aquí un nombre para añadir una magnitud</translation>
    </message>
    <message>
        <source>“%1” is not a number of degrees of freedom.</source>
        <translation>«%1» no es un número de grados de libertad.</translation>
    </message>
    <message>
        <source>Name the quantity before its observations.</source>
        <translation>Dé un símbolo a la magnitud antes de sus observaciones.</translation>
    </message>
    <message>
        <source>The observations are read from %1.</source>
        <translation>Las observaciones se leen de %1.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::BudgetSheetView</name>
    <message>
        <source>Show Quantity</source>
        <translation>Mostrar magnitud</translation>
    </message>
    <message>
        <source>Its components, observations, correlations and notes</source>
        <translation>Sus componentes, observaciones, correlaciones y notas</translation>
    </message>
</context>
<context>
    <name>covaria::ui::BudgetTableModel</name>
    <message>
        <source>An estimate by sampling with a standard error of %1 %: S can exceed S total by chance</source>
        <translation>Estimación por muestreo con un error típico de %1 %: S puede superar a S total por azar</translation>
    </message>
</context>
<context>
    <name>covaria::ui::CertificateForm</name>
    <message>
        <source>Required by %1.</source>
        <translation>Lo exige %1.</translation>
    </message>
    <message>
        <source>Asked for by %1 where it applies.</source>
        <translation>Lo pide %1 cuando procede.</translation>
    </message>
    <message>
        <source>Next Missing</source>
        <translation>Siguiente que falta</translation>
    </message>
    <message>
        <source>What the certificate lacks</source>
        <translation>Lo que falta en el certificado</translation>
    </message>
    <message>
        <source>Goes to the next field that %1 requires and that is empty</source>
        <translation>Va al siguiente campo que %1 exige y que está vacío</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Cambiar %1</translation>
    </message>
    <message>
        <source>Everything that %1 requires beside the results is stated.</source>
        <translation>Está indicado todo lo que %1 exige además de los resultados.</translation>
    </message>
    <message>
        <source>For File › Export › Certificate. A clause of %1 stands where it requires something; a report needs none of it.</source>
        <translation>Para Archivo › Exportar › Certificado. Se cita un apartado de %1 donde exige algo; un informe no necesita nada de ello.</translation>
    </message>
    <message>
        <source>%1 of %2 required texts are stated; missing: %3.</source>
        <translation>Están indicados %1 de %2 textos exigidos; faltan: %3.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg)</source>
        <translation>Imágenes (*.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>English (none chosen)</source>
        <translation>Inglés (ninguno elegido)</translation>
    </message>
    <message>
        <source>Required by %1 where conformity is stated.</source>
        <translation>Exigido por %1 donde se declara conformidad.</translation>
    </message>
    <message>
        <source>in the laboratory, or at the place stated</source>
        <translation>en el laboratorio, o en el lugar indicado</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished">%1 de %2</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ChartView</name>
    <message>
        <source>Run the analysis to see this chart</source>
        <translation>Ejecute el análisis para ver este gráfico</translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation>Archivos %1 (*.%2)</translation>
    </message>
    <message>
        <source>Save Chart</source>
        <translation>Guardar gráfico</translation>
    </message>
    <message>
        <source>Show All</source>
        <translation>Mostrar todo</translation>
    </message>
    <message>
        <source>Copy Picture</source>
        <translation>Copiar imagen</translation>
    </message>
    <message>
        <source>Copy Data</source>
        <translation>Copiar datos</translation>
    </message>
    <message>
        <source>Save as %1 …</source>
        <translation>Guardar como %1 …</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ColumnTableModel</name>
    <message>
        <source>Out of date: the project has changed since.</source>
        <translation>Desactualizado: el proyecto ha cambiado desde entonces.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::CompareTab</name>
    <message>
        <source>Keep as Before</source>
        <translation>Conservar como antes</translation>
    </message>
    <message>
        <source>Keeps the present results of this analysis, to compare later ones with</source>
        <translation>Conserva los resultados actuales de este análisis, para comparar con ellos los posteriores</translation>
    </message>
    <message>
        <source>Go Back to Kept State</source>
        <translation>Volver al estado conservado</translation>
    </message>
    <message>
        <source>Discard Kept State</source>
        <translation>Descartar estado conservado</translation>
    </message>
    <message>
        <source>Forgets the kept results; the project stays as it is now</source>
        <translation>Olvida los resultados conservados; el proyecto queda como está ahora</translation>
    </message>
    <message>
        <source>comparison</source>
        <translation>comparación</translation>
    </message>
    <message>
        <source>budget-changes</source>
        <translation>cambios-del-balance</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Gráfico</translation>
    </message>
    <message>
        <source>Distributions</source>
        <translation>Distribuciones</translation>
    </message>
    <message>
        <source>Changes of the budget</source>
        <translation>Cambios del balance</translation>
    </message>
    <message>
        <source>The results are kept: the tab Compare shows them beside those to come.</source>
        <translation>Los resultados se conservan: la pestaña Comparar los muestra junto a los que vendrán.</translation>
    </message>
    <message>
        <source>Go back to kept state</source>
        <translation>Volver al estado conservado</translation>
    </message>
    <message>
        <source>Select an analysis to compare its results.</source>
        <translation>Seleccione un análisis para comparar sus resultados.</translation>
    </message>
    <message>
        <source>Before: %1, kept at %2. </source>
        <translation>Antes: %1, conservado a las %2. </translation>
    </message>
    <message>
        <source>After: no results.</source>
        <translation>Después: sin resultados.</translation>
    </message>
    <message>
        <source>After: %1</source>
        <translation>Después: %1</translation>
    </message>
    <message>
        <source>Go Back to Kept</source>
        <translation>Volver al conservado</translation>
    </message>
    <message>
        <source>Discard Kept</source>
        <translation>Descartar conservado</translation>
    </message>
    <message>
        <source>The present results are kept in place of those kept before.</source>
        <translation>Los resultados actuales se conservan en lugar de los conservados antes.</translation>
    </message>
    <message>
        <source>Replace Kept State</source>
        <translation>Reemplazar estado conservado</translation>
    </message>
    <message>
        <source>Keeps the present results in place of those kept before, which are forgotten</source>
        <translation>Conserva los resultados actuales en lugar de los conservados antes, que se olvidan</translation>
    </message>
    <message>
        <source>Run the analysis (F5), then keep its results with “%1”.</source>
        <translation>Ejecute el análisis (F5) y luego conserve sus resultados con «%1».</translation>
    </message>
    <message>
        <source>results that are computed again once the analysis has run</source>
        <translation>resultados que se vuelven a calcular en cuanto se haya ejecutado el análisis</translation>
    </message>
    <message>
        <source>Compare With Another Project</source>
        <translation>Comparar con otro proyecto</translation>
    </message>
    <message>
        <source>Covaria project (*.covaria)</source>
        <translation>Proyecto de Covaria (*.covaria)</translation>
    </message>
    <message>
        <source>Analysis of that project:</source>
        <translation>Análisis de ese proyecto:</translation>
    </message>
    <message>
        <source>Compare With</source>
        <translation>Comparar con</translation>
    </message>
    <message>
        <source>Another analysis, of this project or of another one, stands in the place of kept results</source>
        <translation>Otro análisis, de este proyecto o de otro, ocupa el lugar de los resultados conservados</translation>
    </message>
    <message>
        <source>Another Project …</source>
        <translation>Otro proyecto …</translation>
    </message>
    <message>
        <source>%1 has no analysis.</source>
        <translation>%1 no tiene ningún análisis.</translation>
    </message>
    <message>
        <source>The tab Compare shows %1 as before.</source>
        <translation>La pestaña Comparar muestra %1 como antes.</translation>
    </message>
    <message>
        <source>Keep the present results with “%1” and edit, or choose another analysis by “%2”: before and after stand here beside each other.</source>
        <translation>Conserve los resultados actuales con «%1» y edite, o elija otro análisis con «%2»: antes y después quedan aquí lado a lado.</translation>
    </message>
    <message>
        <source>Before: %1 (%2), taken at %3. </source>
        <translation>Antes: %1 (%2), tomado a las %3. </translation>
    </message>
    <message>
        <source>Makes the analysis, and what it uses, what they were when the results were kept, and the coverage factor of the project; can be undone</source>
        <translation>Devuelve el análisis, lo que usa y el factor de cobertura del proyecto a lo que eran cuando se conservaron los resultados; se puede deshacer</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ComponentsEdit</name>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Restablecer</translation>
    </message>
    <message>
        <source>Components of uncertainty</source>
        <translation>Componentes de incertidumbre</translation>
    </message>
    <message>
        <source>Name of the component</source>
        <translation>Nombre de la componente</translation>
    </message>
    <message>
        <source>Type of evaluation</source>
        <translation>Tipo de evaluación</translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation>Grados de libertad</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Origen</translation>
    </message>
    <message>
        <source>Back to the components that the model gives</source>
        <translation>Volver a las componentes que da el modelo</translation>
    </message>
    <message>
        <source>Type A (from observations)</source>
        <translation>Tipo A (de observaciones)</translation>
    </message>
    <message>
        <source>Type B (other means)</source>
        <translation>Tipo B (otros medios)</translation>
    </message>
    <message>
        <source>Degrees of freedom of the standard uncertainty; empty: infinitely many.</source>
        <translation>Grados de libertad de la incertidumbre típica; vacío: infinitos.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Change component of %1</source>
        <translation>Modificar componente de %1</translation>
    </message>
    <message>
        <source>component %1</source>
        <translation>componente %1</translation>
    </message>
    <message>
        <source>Add component to %1</source>
        <translation>Añadir componente a %1</translation>
    </message>
    <message>
        <source>Remove component of %1</source>
        <translation>Quitar componente de %1</translation>
    </message>
    <message>
        <source>Reset components of %1</source>
        <translation>Restablecer componentes de %1</translation>
    </message>
    <message>
        <source>Its uncertainty comes from another analysis.</source>
        <translation>Su incertidumbre proviene de otro análisis.</translation>
    </message>
    <message>
        <source>Components that it shares with other quantities are edited where they are stated.</source>
        <translation>Las componentes que comparte con otras magnitudes se editan donde se declaran.</translation>
    </message>
    <message>
        <source>It has no component of uncertainty yet.</source>
        <translation>Aún no tiene ninguna componente de incertidumbre.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::CorrelationEdit</name>
    <message>
        <source>Add to the matrix</source>
        <translation>Añadir a la matriz</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Correlation coefficients between components of uncertainty</source>
        <translation>Coeficientes de correlación entre componentes de incertidumbre</translation>
    </message>
    <message>
        <source>Component of uncertainty</source>
        <translation>Componente de incertidumbre</translation>
    </message>
    <message>
        <source>All components are uncorrelated. Add those that are correlated to the matrix.</source>
        <translation>Ninguna componente está correlacionada. Añada a la matriz las que lo estén.</translation>
    </message>
    <message>
        <source>The coefficients are possible together (positive semi-definite). Monte Carlo draws them with a Gaussian copula: exact for normal distributions, nearly so for others.</source>
        <translation>Los coeficientes son posibles conjuntamente (semidefinida positiva). Monte Carlo los extrae con una cópula gaussiana: exacto para distribuciones normales, casi exacto para otras.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::CorrelationTableModel</name>
    <message>
        <source>Correlation of %1 with %2</source>
        <translation>Correlación de %1 con %2</translation>
    </message>
</context>
<context>
    <name>covaria::ui::CsvImportDialog</name>
    <message>
        <source>Import %1 into %2</source>
        <translation>Importar %1 en %2</translation>
    </message>
    <message>
        <source>found by itself</source>
        <translation>detectado automáticamente</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>coma</translation>
    </message>
    <message>
        <source>semicolon</source>
        <translation>punto y coma</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>tabulador</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vista previa</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importar</translation>
    </message>
    <message>
        <source>&amp;Separator of cells</source>
        <translation>&amp;Separador de celdas</translation>
    </message>
    <message>
        <source>Column of the file</source>
        <translation>Columna del archivo</translation>
    </message>
    <message>
        <source>is read as</source>
        <translation>se lee como</translation>
    </message>
    <message>
        <source>Columns of the file</source>
        <translation>Columnas del archivo</translation>
    </message>
    <message>
        <source>Column %1 is read as</source>
        <translation>La columna %1 se lee como</translation>
    </message>
    <message>
        <source>as it is named</source>
        <translation>según su nombre</translation>
    </message>
    <message>
        <source>unknown: choose</source>
        <translation>desconocida: elija</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>no se lee</translation>
    </message>
    <message>
        <source>The file cannot be imported: %1.</source>
        <translation>El archivo no se puede importar: %1.</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Línea %1: %2</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s).</source>
        <translation>
            <numerusform>%n fila(s).</numerusform>
            <numerusform>%n fila(s).</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more problem(s).</source>
        <translation>
            <numerusform>%n problema(s) más.</numerusform>
            <numerusform>%n problema(s) más.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>covaria::ui::DateEditor</name>
    <message>
        <source>to</source>
        <translation>hasta</translation>
    </message>
    <message>
        <source>%1, last day</source>
        <translation>%1, último día</translation>
    </message>
    <message>
        <source>Choose from a calendar</source>
        <translation>Elegir en un calendario</translation>
    </message>
    <message>
        <source>“%1” is no date of the form 2026-04-17.</source>
        <translation>«%1» no es una fecha de la forma 2026-04-17.</translation>
    </message>
    <message>
        <source>The first day is missing.</source>
        <translation>Falta el primer día.</translation>
    </message>
    <message>
        <source>The last day is before the first.</source>
        <translation>El último día es anterior al primero.</translation>
    </message>
    <message>
        <source>the same day</source>
        <translation>el mismo día</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DensityPicture</name>
    <message>
        <source>Density of the distribution</source>
        <translation>Densidad de la distribución</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DesignBoxList</name>
    <message>
        <source>Add Box</source>
        <translation>Añadir caja</translation>
    </message>
    <message>
        <source>To, %1</source>
        <translation>Hasta, %1</translation>
    </message>
    <message>
        <source>From, %1</source>
        <translation>Desde, %1</translation>
    </message>
    <message>
        <source>Name of the box</source>
        <translation>Nombre de la caja</translation>
    </message>
    <message>
        <source>name, such as pillar</source>
        <translation>nombre, p. ej. pilar</translation>
    </message>
    <message>
        <source>Remove Box</source>
        <translation>Quitar caja</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Hasta</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DesignReductionList</name>
    <message>
        <source>Add Reduction</source>
        <translation>Añadir reducción</translation>
    </message>
    <message>
        <source>One more uncertainty that can be made smaller for money</source>
        <translation>Una incertidumbre más que se puede reducir pagando</translation>
    </message>
    <message>
        <source>Smallest factor</source>
        <translation>Factor mínimo</translation>
    </message>
    <message>
        <source>The smallest factor that can be had, between 0 and 1</source>
        <translation>El menor factor que se puede obtener, entre 0 y 1</translation>
    </message>
    <message>
        <source>Price of the first halving</source>
        <translation>Precio de la primera reducción a la mitad</translation>
    </message>
    <message>
        <source>Law of the price</source>
        <translation>Ley del precio</translation>
    </message>
    <message>
        <source>price (1/f − 1)</source>
        <translation>precio (1/f − 1)</translation>
    </message>
    <message>
        <source>price (1/f² − 1)/3: further readings</source>
        <translation>precio (1/f² − 1)/3: más lecturas</translation>
    </message>
    <message>
        <source>price log₂(1/f): every halving the same</source>
        <translation>precio log₂(1/f): igual cada vez que se reduce a la mitad</translation>
    </message>
    <message>
        <source>Remove Reduction</source>
        <translation>Quitar reducción</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>Se reduce</translation>
    </message>
    <message>
        <source>Least factor</source>
        <translation>Factor mínimo</translation>
    </message>
    <message>
        <source>First halving</source>
        <translation>Primera mitad</translation>
    </message>
    <message>
        <source>A factor f costs</source>
        <translation>Un factor f cuesta</translation>
    </message>
    <message>
        <source>choose what is reduced</source>
        <translation>elija lo que se reduce</translation>
    </message>
    <message>
        <source>Reductions</source>
        <translation>Reducciones</translation>
    </message>
    <message>
        <source>Each has a price; they take the place of variables and rows.</source>
        <translation>Cada una tiene un precio; ocupan el lugar de variables y filas.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DesignTab</name>
    <message>
        <source>Design</source>
        <translation>Diseño</translation>
    </message>
    <message>
        <source>Design of this analysis</source>
        <translation>Diseño de este análisis</translation>
    </message>
    <message>
        <source>Run Design</source>
        <translation>Ejecutar diseño</translation>
    </message>
    <message>
        <source>Searches for the best design</source>
        <translation>Busca el mejor diseño</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Stops the search (Esc)</source>
        <translation>Detiene la búsqueda (Esc)</translation>
    </message>
    <message>
        <source>Edit …</source>
        <translation>Editar …</translation>
    </message>
    <message>
        <source>Variables, rows and objective of the design, in the properties of the analysis</source>
        <translation>Variables, filas y función objetivo del diseño, en las propiedades del análisis</translation>
    </message>
    <message>
        <source>Take Over This Design</source>
        <translation>Adoptar este diseño</translation>
    </message>
    <message>
        <source>Puts the values and rows that were found into the project; can be undone</source>
        <translation>Pone en el proyecto los valores y las filas hallados; se puede deshacer</translation>
    </message>
    <message>
        <source>Add Design …</source>
        <translation>Añadir diseño …</translation>
    </message>
    <message>
        <source> – out of date</source>
        <translation> – desactualizado</translation>
    </message>
    <message>
        <source>%1 of %2 evaluations</source>
        <translation>%1 de %2 evaluaciones</translation>
    </message>
    <message>
        <source>, best so far %1</source>
        <translation>, mejor hasta ahora %1</translation>
    </message>
    <message>
        <source>searching …</source>
        <translation>buscando …</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Fallido: %1</translation>
    </message>
    <message>
        <source>Not searched yet.</source>
        <translation>Aún no se ha buscado.</translation>
    </message>
    <message>
        <source>Nothing that was tried has a result.</source>
        <translation>Nada de lo que se probó tiene resultado.</translation>
    </message>
    <message>
        <source>The cheapest reductions cost %1</source>
        <translation>Las reducciones más baratas cuestan %1</translation>
    </message>
    <message>
        <source>The cheapest rows cost %1</source>
        <translation>Las filas más baratas cuestan %1</translation>
    </message>
    <message>
        <source>, before %1</source>
        <translation>, antes %1</translation>
    </message>
    <message>
        <source>; &lt;b&gt;the target of U(%1) is not met&lt;/b&gt;</source>
        <translation>; &lt;b&gt;no se cumple el objetivo de U(%1)&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Out of date&lt;/b&gt;: shown for the project as it was. </source>
        <translation>&lt;b&gt;Desactualizado&lt;/b&gt;: se muestra para el proyecto tal como era. </translation>
    </message>
    <message>
        <source>Take over design</source>
        <translation>Adoptar diseño</translation>
    </message>
    <message>
        <source>“%1” shows the best that can be done with what the design may choose.</source>
        <translation>«%1» muestra lo mejor que se puede lograr con lo que el diseño puede elegir.</translation>
    </message>
    <message>
        <source>A design finds where to stand and what to measure: add one with “%1”.</source>
        <translation>Un diseño halla dónde colocarse y qué medir: añada uno con «%1».</translation>
    </message>
    <message>
        <source> (law of propagation)</source>
        <translation> (ley de propagación)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DesignsForm</name>
    <message>
        <source>Design</source>
        <translation>Diseño</translation>
    </message>
    <message>
        <source>Adds a design of this analysis</source>
        <translation>Añade un diseño de este análisis</translation>
    </message>
    <message>
        <source>Adds a copy of this design</source>
        <translation>Añade una copia de este diseño</translation>
    </message>
    <message>
        <source>Deletes this design</source>
        <translation>Elimina este diseño</translation>
    </message>
    <message>
        <source>Searches for the best design</source>
        <translation>Busca el mejor diseño</translation>
    </message>
    <message>
        <source>A design finds where to stand and what to measure: the numbers and the rows of the set-up that make the uncertainties smallest. Add one to let Covaria search.</source>
        <translation>Un diseño halla dónde colocarse y qué medir: los números y las filas de la configuración que hacen mínimas las incertidumbres. Añada uno para que Covaria busque.</translation>
    </message>
    <message>
        <source>Add Variable</source>
        <translation>Añadir variable</translation>
    </message>
    <message>
        <source>One more number that may be chosen</source>
        <translation>Un número más que se puede elegir</translation>
    </message>
    <message>
        <source>Name of the design</source>
        <translation>Nombre del diseño</translation>
    </message>
    <message>
        <source>Objective</source>
        <translation>Función objetivo</translation>
    </message>
    <message>
        <source>What is made smallest of the ratios of U to the target uncertainties; without targets to U of the present design</source>
        <translation>Lo que se minimiza de las razones de U a las incertidumbres objetivo; sin objetivos, a la U del diseño actual</translation>
    </message>
    <message>
        <source>Largest ratio</source>
        <translation>Mayor razón</translation>
    </message>
    <message>
        <source>Mean of the ratios</source>
        <translation>Media de las razones</translation>
    </message>
    <message>
        <source>Root mean square of the ratios</source>
        <translation>Media cuadrática de las razones</translation>
    </message>
    <message>
        <source>Cost of the rows, with all targets met</source>
        <translation>Coste de las filas, cumplidos todos los objetivos</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>Minimizar</translation>
    </message>
    <message>
        <source>Output quantities of the design</source>
        <translation>Magnitudes de salida del diseño</translation>
    </message>
    <message>
        <source>Output quantities looked at; with none ticked, all with a target uncertainty, or all measurands</source>
        <translation>Magnitudes de salida consideradas; si no se marca ninguna, todas las que tienen incertidumbre objetivo, o todos los mensurandos</translation>
    </message>
    <message>
        <source>Outputs (none ticked: all with a target, or all measurands)</source>
        <translation>Salidas (ninguna marcada: todas las que tienen objetivo, o todos los mensurandos)</translation>
    </message>
    <message>
        <source>Rows to choose from</source>
        <translation>Filas entre las que elegir</translation>
    </message>
    <message>
        <source>Table to choose from</source>
        <translation>Tabla de la que elegir</translation>
    </message>
    <message>
        <source>Rows to keep</source>
        <translation>Filas que conservar</translation>
    </message>
    <message>
        <source>File of candidates</source>
        <translation>Archivo de candidatos</translation>
    </message>
    <message>
        <source>A CSV file beside the project with further rows; may be empty</source>
        <translation>Un archivo CSV junto al proyecto con más filas; puede quedar vacío</translation>
    </message>
    <message>
        <source>Rows that stay</source>
        <translation>Filas que permanecen</translation>
    </message>
    <message>
        <source>Ticked rows stay in any case</source>
        <translation>Las filas marcadas permanecen en todo caso</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabla</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conservar</translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation>Candidatos</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Fijas</translation>
    </message>
    <message>
        <source>Prices</source>
        <translation>Precios</translation>
    </message>
    <message>
        <source>Starts</source>
        <translation>Inicios</translation>
    </message>
    <message>
        <source>Evaluations at most</source>
        <translation>Evaluaciones como máximo</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semilla</translation>
    </message>
    <message>
        <source>Least distance</source>
        <translation>Distancia mínima</translation>
    </message>
    <message>
        <source>Between instruments, and of them from all other points</source>
        <translation>Entre instrumentos, y de estos a todos los demás puntos</translation>
    </message>
    <message>
        <source>Keep out of</source>
        <translation>Zonas excluidas</translation>
    </message>
    <message>
        <source>No instrument stands in this box</source>
        <translation>Ningún instrumento se coloca en esta caja</translation>
    </message>
    <message>
        <source>Lines of sight are hidden by</source>
        <translation>Las líneas de visión las ocultan</translation>
    </message>
    <message>
        <source>No line of sight passes this box</source>
        <translation>Ninguna línea de visión atraviesa esta caja</translation>
    </message>
    <message>
        <source>Prices of the rows</source>
        <translation>Precios de las filas</translation>
    </message>
    <message>
        <source>one for all rows, or one for each: 120; 80; 95</source>
        <translation>uno para todas las filas, o uno para cada una: 120; 80; 95</translation>
    </message>
    <message>
        <source>What the rows cost, separated by semicolons; needed where the cost is to be small</source>
        <translation>Lo que cuestan las filas, separado por puntos y comas; necesario si el coste ha de ser pequeño</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no number; separate prices by semicolons</source>
        <translation>&apos;%1&apos; no es un número; separe los precios con puntos y comas</translation>
    </message>
    <message>
        <source>Of the random starts: a whole number from 0 to 18446744073709551615</source>
        <translation>De los inicios aleatorios: un número entero de 0 a 18446744073709551615</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DistributionEdit</name>
    <message>
        <source>Distribution</source>
        <translation>Distribución</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>Probabilities</source>
        <translation>Probabilidades</translation>
    </message>
    <message>
        <source>numbers with ; between</source>
        <translation>números separados por ;</translation>
    </message>
    <message>
        <source>“%1” are not all numbers.</source>
        <translation>«%1» no son todos números.</translation>
    </message>
    <message>
        <source>There must be as many probabilities as values.</source>
        <translation>Debe haber tantas probabilidades como valores.</translation>
    </message>
    <message>
        <source>This distribution has no finite standard uncertainty.</source>
        <translation>Esta distribución no tiene incertidumbre típica finita.</translation>
    </message>
    <message>
        <source>Monte Carlo draws: %1, ν = %2</source>
        <translation>Monte Carlo extrae de: %1, ν = %2</translation>
    </message>
    <message>
        <source>Edges of the cells</source>
        <translation>Bordes de las celdas</translation>
    </message>
    <message>
        <source>There must be one edge more than probabilities.</source>
        <translation>Debe haber un borde más que probabilidades.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DockTitle</name>
    <message>
        <source>Float or dock</source>
        <translation>Flotar o acoplar</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
</context>
<context>
    <name>covaria::ui::Document</name>
    <message>
        <source>Untitled</source>
        <translation>Sin título</translation>
    </message>
    <message>
        <source>%1 (from %2)</source>
        <translation>%1 (de %2)</translation>
    </message>
    <message>
        <source>The project has no file yet: choose a name for it.</source>
        <translation>El proyecto aún no tiene archivo: elija un nombre para él.</translation>
    </message>
    <message>
        <source> (copy)</source>
        <translation> (copia)</translation>
    </message>
    <message>
        <source>Add study</source>
        <translation>Añadir estudio</translation>
    </message>
    <message>
        <source>Duplicate study</source>
        <translation>Duplicar estudio</translation>
    </message>
    <message>
        <source>Delete study</source>
        <translation>Eliminar estudio</translation>
    </message>
    <message>
        <source>Change study</source>
        <translation>Modificar estudio</translation>
    </message>
    <message>
        <source>Study %1</source>
        <translation>Estudio %1</translation>
    </message>
    <message>
        <source>Add design</source>
        <translation>Añadir diseño</translation>
    </message>
    <message>
        <source>Duplicate design</source>
        <translation>Duplicar diseño</translation>
    </message>
    <message>
        <source>Delete design</source>
        <translation>Eliminar diseño</translation>
    </message>
    <message>
        <source>Change design</source>
        <translation>Modificar diseño</translation>
    </message>
    <message>
        <source>Design %1</source>
        <translation>Diseño %1</translation>
    </message>
    <message>
        <source>the project</source>
        <translation>el proyecto</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>Renombrar %1</translation>
    </message>
    <message>
        <source>Change notes of %1</source>
        <translation>Modificar notas de %1</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>Eliminar %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Mover %1</translation>
    </message>
    <message>
        <source>Take %1 from an analysis</source>
        <translation>Tomar %1 de un análisis</translation>
    </message>
    <message>
        <source>Remove the link of %1</source>
        <translation>Quitar el vínculo de %1</translation>
    </message>
    <message>
        <source>Another program has changed the file since it was read.</source>
        <translation>Otro programa ha cambiado el archivo desde que se leyó.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::EmptyProject</name>
    <message>
        <source>Empty project</source>
        <translation>Proyecto vacío</translation>
    </message>
    <message>
        <source>What is to be evaluated?</source>
        <translation>¿Qué se va a evaluar?</translation>
    </message>
    <message>
        <source>&amp;Library and Templates …</source>
        <translation>&amp;Biblioteca y plantillas …</translation>
    </message>
</context>
<context>
    <name>covaria::ui::EquationsView</name>
    <message>
        <source>Equations</source>
        <translation>Ecuaciones</translation>
    </message>
</context>
<context>
    <name>covaria::ui::EvaluationTab</name>
    <message>
        <source>Evaluation of the set-up</source>
        <translation>Evaluación de la configuración</translation>
    </message>
</context>
<context>
    <name>covaria::ui::EvaluationView</name>
    <message>
        <source>Tables of the evaluation</source>
        <translation>Tablas de la evaluación</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Gráfico</translation>
    </message>
    <message>
        <source>Which chart of the evaluation is shown</source>
        <translation>Qué gráfico de la evaluación se muestra</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ExportActions</name>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>Documento PDF (*.pdf)</translation>
    </message>
    <message>
        <source>HTML page (*.html)</source>
        <translation>Página HTML (*.html)</translation>
    </message>
    <message>
        <source>Markdown text (*.md)</source>
        <translation>Texto Markdown (*.md)</translation>
    </message>
    <message>
        <source>Report as &amp;PDF …</source>
        <translation>Informe en &amp;PDF …</translation>
    </message>
    <message>
        <source>&amp;Certificate as PDF …</source>
        <translation>&amp;Certificado en PDF …</translation>
    </message>
    <message>
        <source>Report as &amp;HTML …</source>
        <translation>Informe en &amp;HTML …</translation>
    </message>
    <message>
        <source>Report as &amp;Markdown …</source>
        <translation>Informe en &amp;Markdown …</translation>
    </message>
    <message>
        <source>&amp;Results and Tables (JSON, CSV) …</source>
        <translation>&amp;Resultados y tablas (JSON, CSV) …</translation>
    </message>
    <message>
        <source> …</source>
        <translation> …</translation>
    </message>
    <message>
        <source>No results yet</source>
        <translation>Aún no hay resultados</translation>
    </message>
    <message>
        <source>The export waits until the analyses have run</source>
        <translation>La exportación espera a que se ejecuten los análisis</translation>
    </message>
    <message>
        <source>, without %1: not up to date</source>
        <translation>, sin %1: no actualizado</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Export Report</source>
        <translation>Exportar informe</translation>
    </message>
    <message>
        <source>The certificate does not state what ISO/IEC 17025 requires of it:

%1

It says “not stated” in these places. They are fields of the project&apos;s page.</source>
        <translation>El certificado no indica lo que ISO/IEC 17025 exige de él:

%1

En esos lugares figura “not stated”. Son campos de la página del proyecto.</translation>
    </message>
    <message>
        <source>Export Anyway</source>
        <translation>Exportar igualmente</translation>
    </message>
    <message>
        <source>Export Certificate</source>
        <translation>Exportar certificado</translation>
    </message>
    <message>
        <source>Export Results and Tables into the Folder of</source>
        <translation>Exportar resultados y tablas a la carpeta de</translation>
    </message>
    <message>
        <source>Results (results.json)</source>
        <translation>Resultados (results.json)</translation>
    </message>
    <message>
        <source>%1: what it must state is missing</source>
        <translation>%1: falta lo que debe indicar</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>Exportar %1</translation>
    </message>
    <message>
        <source>%1 (*%2)</source>
        <translation>%1 (*%2)</translation>
    </message>
    <message>
        <source>A report is being written; wait until it is finished</source>
        <translation>Se está escribiendo un informe; espere a que termine</translation>
    </message>
    <message>
        <source>Writing %1 …</source>
        <translation>Escribiendo %1 …</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>Se escribió %1</translation>
    </message>
    <message>
        <source>The export failed</source>
        <translation>La exportación ha fallado</translation>
    </message>
    <message>
        <source>No analysis can be run: each one is incomplete or has errors.</source>
        <translation>No se puede ejecutar ningún análisis: cada uno está incompleto o tiene errores.</translation>
    </message>
    <message>
        <source>Ex&amp;port</source>
        <translation>&amp;Exportar</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FieldEditor</name>
    <message>
        <source>From %1 to %2.</source>
        <translation>De %1 a %2.</translation>
    </message>
    <message>
        <source>More than %1.</source>
        <translation>Más de %1.</translation>
    </message>
    <message>
        <source>At least %1.</source>
        <translation>Al menos %1.</translation>
    </message>
    <message>
        <source>At most %1.</source>
        <translation>Como máximo %1.</translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation>Archivos %1</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FieldHelp</name>
    <message>
        <source>Help on the field</source>
        <translation>Ayuda sobre el campo</translation>
    </message>
    <message>
        <source>Numbers may be typed with another unit (%1); the arrow keys change the last digit.</source>
        <translation>Los números se pueden teclear con otra unidad (%1); las teclas de flecha cambian la última cifra.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FileActions</name>
    <message>
        <source>line %1: </source>
        <translation>línea %1: </translation>
    </message>
    <message>
        <source>&amp;New Project</source>
        <translation>&amp;Nuevo proyecto</translation>
    </message>
    <message>
        <source>&amp;Open …</source>
        <translation>&amp;Abrir …</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>Save &amp;As …</source>
        <translation>Guardar &amp;como …</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Abrir &amp;reciente</translation>
    </message>
    <message>
        <source>No projects yet</source>
        <translation>Aún no hay proyectos</translation>
    </message>
    <message>
        <source>New from &amp;Example</source>
        <translation>Nuevo desde e&amp;jemplo</translation>
    </message>
    <message>
        <source>Untitled project</source>
        <translation>Proyecto sin título</translation>
    </message>
    <message>
        <source>Opening %1 …</source>
        <translation>Abriendo %1 …</translation>
    </message>
    <message>
        <source>%1 was not opened</source>
        <translation>No se abrió %1</translation>
    </message>
    <message>
        <source>The project has errors and was not opened</source>
        <translation>El proyecto tiene errores y no se abrió</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>Se abrió %1</translation>
    </message>
    <message>
        <source>The example could not be opened</source>
        <translation>No se pudo abrir el ejemplo</translation>
    </message>
    <message>
        <source>The project was not saved</source>
        <translation>No se guardó el proyecto</translation>
    </message>
    <message>
        <source>Save Project</source>
        <translation>Guardar proyecto</translation>
    </message>
    <message>
        <source>Covaria project (*.covaria)</source>
        <translation>Proyecto de Covaria (*.covaria)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Se guardó %1</translation>
    </message>
    <message numerus="yes">
        <source>Saved %1 without %n text(s) that cannot be read: see the problems</source>
        <translation>
            <numerusform>Se guardó %1 sin %n texto(s) que no se pueden leer: véanse los problemas</numerusform>
            <numerusform>Se guardó %1 sin %n texto(s) que no se pueden leer: véanse los problemas</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>The work could not be recovered</source>
        <translation>No se pudo recuperar el trabajo</translation>
    </message>
    <message>
        <source>%1 was removed by another program; saving writes it again</source>
        <translation>Otro programa eliminó %1; al guardar se escribe de nuevo</translation>
    </message>
    <message>
        <source>Name project</source>
        <translation>Dar nombre al proyecto</translation>
    </message>
    <message>
        <source>%1 was changed by another program since it was read here. Saving replaces what it holds now.</source>
        <translation>Otro programa cambió %1 desde que se leyó aquí. Guardar reemplaza lo que contiene ahora.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FileEditor</name>
    <message>
        <source>Choose a file: %1</source>
        <translation>Elegir un archivo: %1</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FirstStepsGuide</name>
    <message>
        <source>First Steps</source>
        <translation>Primeros pasos</translation>
    </message>
    <message>
        <source>Not there yet: first step %1, %2.</source>
        <translation>Aún no está: antes, el paso %1, %2.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FirstStepsPanel</name>
    <message>
        <source>Show Me</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Siguiente</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Primeros pasos</translation>
    </message>
    <message>
        <source>Shows where it is done: opens the tab and puts a frame around it</source>
        <translation>Muestra dónde se hace: abre la pestaña y pone un marco alrededor</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>step 3 of 10</comment>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>done</source>
        <translation>hecho</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FoldGroups</name>
    <message>
        <source>none</source>
        <translation type="unfinished">ninguno</translation>
    </message>
</context>
<context>
    <name>covaria::ui::HelpActions</name>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>M&amp;odels</source>
        <translation>M&amp;odelos</translation>
    </message>
    <message>
        <source>&amp;Results and Requirements</source>
        <translation>&amp;Resultados y requisitos</translation>
    </message>
    <message>
        <source>&amp;Glossary</source>
        <translation>&amp;Glosario</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Teclas</translation>
    </message>
    <message>
        <source>&amp;About Covaria</source>
        <translation>&amp;Acerca de Covaria</translation>
    </message>
    <message>
        <source>The S&amp;cene</source>
        <translation>La es&amp;cena</translation>
    </message>
    <message>
        <source>An Everyday &amp;Budget</source>
        <translation>Un ba&amp;lance cotidiano</translation>
    </message>
    <message>
        <source>Help on &amp;What Has the Focus</source>
        <translation>Ayuda sobre lo que tiene el &amp;foco</translation>
    </message>
    <message>
        <source>Artefacts, &amp;Instruments and Robots</source>
        <translation>Patrones, &amp;instrumentos y robots</translation>
    </message>
    <message>
        <source>What Every Analysis &amp;Has</source>
        <translation>Lo &amp;que tiene todo análisis</translation>
    </message>
</context>
<context>
    <name>covaria::ui::HelpPane</name>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ImportActions</name>
    <message>
        <source>&amp;Import File …</source>
        <translation>&amp;Importar archivo …</translation>
    </message>
    <message>
        <source>Add points, budgets, certificates, readings or poses of other programs</source>
        <translation>Añade puntos, balances, certificados, lecturas o poses de otros programas</translation>
    </message>
    <message>
        <source>Add a serial robot from a robot description in URDF</source>
        <translation>Añade un robot serie a partir de una descripción de robot en URDF</translation>
    </message>
    <message>
        <source>Import File</source>
        <translation>Importar archivo</translation>
    </message>
    <message>
        <source>Files that are read (%1);;All files (*)</source>
        <translation>Archivos que se leen (%1);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Importar %1</translation>
    </message>
    <message>
        <source>Imported %1</source>
        <translation>Se importó %1</translation>
    </message>
    <message>
        <source>Import Robot</source>
        <translation>Importar robot</translation>
    </message>
    <message>
        <source>Robot description (*.urdf);;All files (*)</source>
        <translation>Descripción de robot (*.urdf);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>The robot was not imported</source>
        <translation>No se importó el robot</translation>
    </message>
    <message>
        <source>Import Robo&amp;t (URDF) …</source>
        <translation>Importar r&amp;obot (URDF) …</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ImportDialog</name>
    <message>
        <source>Line %1: %2</source>
        <translation>Línea %1: %2</translation>
    </message>
    <message>
        <source>What the file says contradicts itself: %1</source>
        <translation>Lo que dice el archivo se contradice: %1</translation>
    </message>
    <message>
        <source>&amp;Sheet</source>
        <translation>&amp;Hoja</translation>
    </message>
    <message>
        <source>Columns of the file and what each is read as</source>
        <translation>Columnas del archivo y cómo se lee cada una</translation>
    </message>
    <message>
        <source>Units that the &amp;file does not state</source>
        <translation>Unidades que el &amp;archivo no indica</translation>
    </message>
    <message>
        <source>&amp;Note the file with its size, time and SHA-256 in what is added</source>
        <translation>A&amp;notar el archivo con su tamaño, hora y SHA-256 en lo que se añade</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Importar %1</translation>
    </message>
    <message>
        <source>as the file says, else mm</source>
        <translation>según el archivo; si no, mm</translation>
    </message>
    <message>
        <source>What becomes of the file</source>
        <translation>Qué se hace con el archivo</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importar</translation>
    </message>
    <message>
        <source>&amp;Read as</source>
        <translation>&amp;Leer como</translation>
    </message>
    <message>
        <source>&amp;Unit of lengths</source>
        <translation>&amp;Unidad de longitudes</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Magnitud</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>What becomes of it, and what is not taken over</source>
        <translation>Qué se hace con él y qué no se incorpora</translation>
    </message>
    <message>
        <source>no reader recognises it: choose one</source>
        <translation>ningún lector lo reconoce: elija uno</translation>
    </message>
    <message>
        <source>several readers recognise it: choose one</source>
        <translation>varios lectores lo reconocen: elija uno</translation>
    </message>
    <message>
        <source>%1 (recognised)</source>
        <translation>%1 (reconocido)</translation>
    </message>
    <message>
        <source>Column %1 is read as</source>
        <translation>La columna %1 se lee como</translation>
    </message>
    <message>
        <source>unknown: choose</source>
        <translation>desconocida: elija</translation>
    </message>
    <message>
        <source>as it is named</source>
        <translation>según su nombre</translation>
    </message>
    <message>
        <source>Choose what the file is read as.</source>
        <translation>Elija cómo se lee el archivo.</translation>
    </message>
    <message>
        <source>%1 assets and %2 analyses are added, in one step that can be undone.</source>
        <translation>Se añaden %1 recursos y %2 análisis, en un solo paso que se puede deshacer.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Imported from %1, %2 bytes, of %3, SHA-256 %4.</source>
        <translation>Importado de %1, %2 bytes, del %3, SHA-256 %4.</translation>
    </message>
    <message>
        <source>&amp;Leave Out or Read the Row</source>
        <translation>&amp;Omitir o leer la fila</translation>
    </message>
    <message>
        <source>%1, left out</source>
        <translation>%1, omitida</translation>
    </message>
    <message>
        <source>What each column is read as; cells can be typed over</source>
        <translation>Como qué se lee cada columna; se puede escribir sobre las celdas</translation>
    </message>
</context>
<context>
    <name>covaria::ui::InputCorrelationModel</name>
    <message>
        <source>Remove correlations of %1</source>
        <translation>Quitar correlaciones de %1</translation>
    </message>
    <message>
        <source>Change correlation of %1 and %2</source>
        <translation>Modificar correlación de %1 y %2</translation>
    </message>
    <message>
        <source>The correlation coefficient of %1 and %2 lies between −1 and 1; “%3” does not.</source>
        <translation>El coeficiente de correlación de %1 y %2 está entre −1 y 1; «%3» no lo está.</translation>
    </message>
    <message>
        <source>The correlation coefficient of %1 and %2 is a number; “%3” is not.</source>
        <translation>El coeficiente de correlación de %1 y %2 es un número; «%3» no lo es.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::InputQuantitiesModel</name>
    <message>
        <source>from %1, linearised: %2</source>
        <translation>de %1, linealizado: %2</translation>
    </message>
    <message>
        <source>from %1: %2</source>
        <translation>de %1: %2</translation>
    </message>
    <message>
        <source>Evaluated in the other analysis, in every trial: edit it there.</source>
        <translation>Se evalúa en el otro análisis, en cada prueba: edítelo allí.</translation>
    </message>
    <message>
        <source>Changed: differs from what the model says.</source>
        <translation>Modificada: difiere de lo que dice el modelo.</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>Símbolo</translation>
    </message>
    <message>
        <source>Input quantity</source>
        <translation>Magnitud de entrada</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>Estimación</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Constant</source>
        <translation>Constante</translation>
    </message>
    <message>
        <source>Change estimate of %1</source>
        <translation>Modificar estimación de %1</translation>
    </message>
    <message>
        <source>Keep %1 constant</source>
        <translation>Mantener %1 constante</translation>
    </message>
    <message>
        <source>Let %1 vary</source>
        <translation>Dejar variar %1</translation>
    </message>
    <message>
        <source>Reset %1 to the model&apos;s values</source>
        <translation>Restablecer %1 a los valores del modelo</translation>
    </message>
    <message>
        <source>%1 (%2, %3)</source>
        <translation>%1 (%2, %3)</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Componentes</translation>
    </message>
</context>
<context>
    <name>covaria::ui::InputsPage</name>
    <message>
        <source>Find a quantity</source>
        <translation>Buscar una magnitud</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Componentes</translation>
    </message>
    <message>
        <source>Correlations</source>
        <translation>Correlaciones</translation>
    </message>
    <message>
        <source>The quantities that the set-up makes. What is changed here replaces what the set-up states.</source>
        <translation>Las magnitudes que genera la configuración. Lo que se modifica aquí sustituye a lo que indica la configuración.</translation>
    </message>
    <message>
        <source>Input quantities</source>
        <translation>Magnitudes de entrada</translation>
    </message>
    <message>
        <source>Take From an Analysis …</source>
        <translation>Tomar de un análisis …</translation>
    </message>
    <message>
        <source>Remove Link</source>
        <translation>Quitar vínculo</translation>
    </message>
    <message>
        <source>Observations</source>
        <translation>Observaciones</translation>
    </message>
    <message>
        <source>Notes on the quantity</source>
        <translation type="unfinished">Notas sobre la magnitud</translation>
    </message>
</context>
<context>
    <name>covaria::ui::InquiryHead</name>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplicar</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ejecutar</translation>
    </message>
</context>
<context>
    <name>covaria::ui::InspectorHead</name>
    <message>
        <source>Entry before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Entry after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Properties</source>
        <translation type="unfinished">Propiedades</translation>
    </message>
    <message>
        <source>Project and documents</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::KeptStates</name>
    <message>
        <source>Keep state</source>
        <translation>Conservar estado</translation>
    </message>
    <message>
        <source>Discard kept state</source>
        <translation>Descartar estado conservado</translation>
    </message>
    <message>
        <source>Compare with %1</source>
        <translation>Comparar con %1</translation>
    </message>
</context>
<context>
    <name>covaria::ui::LibraryBrowser</name>
    <message>
        <source>Collections</source>
        <translation>Colecciones</translation>
    </message>
    <message>
        <source>Templates, examples and assets</source>
        <translation>Plantillas, ejemplos y recursos</translation>
    </message>
    <message>
        <source>Library and Examples</source>
        <translation>Biblioteca y ejemplos</translation>
    </message>
    <message>
        <source>Search: name, kind, source</source>
        <translation>Buscar: nombre, clase, fuente</translation>
    </message>
    <message>
        <source>Search in the library</source>
        <translation>Buscar en la biblioteca</translation>
    </message>
    <message>
        <source>What is selected</source>
        <translation>Lo seleccionado</translation>
    </message>
    <message>
        <source>New analysis</source>
        <translation>Nuevo análisis</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Ejemplos</translation>
    </message>
    <message>
        <source>GUM and its supplements</source>
        <translation>GUM y sus suplementos</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Todo</translation>
    </message>
    <message>
        <source>It comes with what it needs and has results at once. Assets of the same kind that the project has already stand in the place of its own.</source>
        <translation>Incluye lo que necesita y tiene resultados de inmediato. Los recursos de la misma clase que el proyecto ya tiene ocupan el lugar de los suyos.</translation>
    </message>
    <message>
        <source>Opens as a new project.</source>
        <translation>Se abre como proyecto nuevo.</translation>
    </message>
    <message>
        <source>Add to the Project</source>
        <translation>Añadir al proyecto</translation>
    </message>
    <message>
        <source>&lt;p&gt;Nothing here has these words.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Nada contiene aquí estas palabras.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Open as a New Project</source>
        <translation>Abrir como proyecto nuevo</translation>
    </message>
    <message>
        <source>Add This Analysis</source>
        <translation>Añadir este análisis</translation>
    </message>
</context>
<context>
    <name>covaria::ui::LibraryMenu</name>
    <message>
        <source>Not readable: %1</source>
        <translation>No se puede leer: %1</translation>
    </message>
    <message>
        <source>F&amp;rom the Library</source>
        <translation>De &amp;la biblioteca</translation>
    </message>
</context>
<context>
    <name>covaria::ui::LinesEditor</name>
    <message>
        <source>Add rows for new names</source>
        <translation>Añadir filas para nombres nuevos</translation>
    </message>
    <message>
        <source>Adds a row to the tables below for every name that has none yet</source>
        <translation>Añade a las tablas de abajo una fila por cada nombre que aún no la tiene</translation>
    </message>
</context>
<context>
    <name>covaria::ui::LinkDialog</name>
    <message>
        <source>&amp;Linearised: faster, exact to first order only</source>
        <translation>&amp;Linealizado: más rápido, exacto solo en primer orden</translation>
    </message>
    <message>
        <source>Take %1 From an Analysis</source>
        <translation>Tomar %1 de un análisis</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>Análisis</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>No other analysis has a result of this dimension.</source>
        <translation>Ningún otro análisis tiene un resultado de esta dimensión.</translation>
    </message>
    <message>
        <source>Both analyses are then evaluated together, as one model: the result is not carried over as a number with an uncertainty.</source>
        <translation>Ambos análisis se evalúan entonces conjuntamente, como un solo modelo: el resultado no se traslada como un número con una incertidumbre.</translation>
    </message>
    <message>
        <source>&amp;Analysis</source>
        <translation>&amp;Análisis</translation>
    </message>
    <message>
        <source>&amp;Result</source>
        <translation>&amp;Resultado</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ListEditor</name>
    <message>
        <source>(none)</source>
        <translation>(ninguno)</translation>
    </message>
    <message>
        <source>%1 (does not exist)</source>
        <translation>%1 (no existe)</translation>
    </message>
    <message>
        <source>%1

Chosen: %2</source>
        <translation>%1

Elegido: %2</translation>
    </message>
</context>
<context>
    <name>covaria::ui::LogPane</name>
    <message>
        <source>Log</source>
        <translation>Registro</translation>
    </message>
</context>
<context>
    <name>covaria::ui::MainWindow</name>
    <message>
        <source>Covaria</source>
        <translation>Covaria</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Proyecto</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Propiedades</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problemas</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Registro</translation>
    </message>
    <message>
        <source>Add an analysis or what it uses</source>
        <translation>Añade un análisis o lo que este usa</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>&amp;Library and Examples …</source>
        <translation>&amp;Biblioteca y ejemplos …</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>Pre&amp;ferences …</source>
        <translation>Pre&amp;ferencias …</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>E&amp;jecutar</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>&amp;Reset Layout</source>
        <translation>&amp;Restablecer disposición</translation>
    </message>
    <message>
        <source>Start Page</source>
        <translation>Página de inicio</translation>
    </message>
    <message>
        <source>3D Scene</source>
        <translation>Escena 3D</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Problems (%1)</source>
        <translation>Problemas (%1)</translation>
    </message>
    <message>
        <source>Covaria[*]</source>
        <translation>Covaria[*]</translation>
    </message>
    <message>
        <source>%1[*] – Covaria</source>
        <translation>%1[*] – Covaria</translation>
    </message>
    <message>
        <source>First &amp;Steps</source>
        <translation>Primeros &amp;pasos</translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished">Ejecutar</translation>
    </message>
    <message>
        <source>Document</source>
        <translation type="unfinished">Documento</translation>
    </message>
</context>
<context>
    <name>covaria::ui::MeasureTool</name>
    <message>
        <source>Measure Distance</source>
        <translation>Medir distancia</translation>
    </message>
    <message>
        <source>Distance of two points, with its uncertainty (D)</source>
        <translation>Distancia entre dos puntos, con su incertidumbre (D)</translation>
    </message>
    <message>
        <source>Measure Angle</source>
        <translation>Medir ángulo</translation>
    </message>
    <message>
        <source>Angle at the second of three points, with its uncertainty (A)</source>
        <translation>Ángulo en el segundo de tres puntos, con su incertidumbre (A)</translation>
    </message>
    <message>
        <source>Distance: pick the first point. Esc puts the tool away.</source>
        <translation>Distancia: elegir el primer punto. Esc deja la herramienta.</translation>
    </message>
    <message>
        <source>Distance: pick the second point.</source>
        <translation>Distancia: elegir el segundo punto.</translation>
    </message>
    <message>
        <source>Angle: pick a point on the first side. Esc puts the tool away.</source>
        <translation>Ángulo: elegir un punto del primer lado. Esc deja la herramienta.</translation>
    </message>
    <message>
        <source>Angle: pick the apex.</source>
        <translation>Ángulo: elegir el vértice.</translation>
    </message>
    <message>
        <source>Angle: pick a point on the second side.</source>
        <translation>Ángulo: elegir un punto del segundo lado.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::NotesPage</name>
    <message>
        <source>Title</source>
        <translation>Título</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notas</translation>
    </message>
    <message>
        <source>Appear in the report</source>
        <translation>Aparecer en el informe</translation>
    </message>
</context>
<context>
    <name>covaria::ui::OnlyMiddle</name>
    <message>
        <source>Only the &amp;Middle</source>
        <translation>Solo el &amp;centro</translation>
    </message>
    <message>
        <source>The stage alone; once more, and the panes stand as they did</source>
        <translation>Solo el área central; otra vez, y los paneles quedan como estaban</translation>
    </message>
</context>
<context>
    <name>covaria::ui::OptionsForm</name>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>Forecast</source>
        <translation>Previsión</translation>
    </message>
    <message>
        <source>Change evaluation options</source>
        <translation>Modificar opciones de evaluación</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automático</translation>
    </message>
</context>
<context>
    <name>covaria::ui::PageBar</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Página</translation>
    </message>
    <message>
        <source>Number of the page that is shown</source>
        <translation>Número de la página que se muestra</translation>
    </message>
    <message>
        <source>Previous page</source>
        <translation>Página anterior</translation>
    </message>
    <message>
        <source>Next page</source>
        <translation>Página siguiente</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Más pequeño</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Más grande</translation>
    </message>
    <message>
        <source>Size of the pages</source>
        <translation>Tamaño de las páginas</translation>
    </message>
    <message>
        <source>Size of the pages: fitted, or in per cent of the paper (Ctrl with the wheel)</source>
        <translation>Tamaño de las páginas: ajustado, o en tanto por ciento del papel (Ctrl con la rueda)</translation>
    </message>
    <message>
        <source>Fit Width</source>
        <translation>Ajustar al ancho</translation>
    </message>
    <message>
        <source>Fit Page</source>
        <translation>Ajustar a la página</translation>
    </message>
    <message>
        <source> of %1</source>
        <comment>page 3 of 17</comment>
        <translation> de %1</translation>
    </message>
</context>
<context>
    <name>covaria::ui::PageList</name>
    <message>
        <source>Pages</source>
        <translation>Páginas</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>Página %1</translation>
    </message>
</context>
<context>
    <name>covaria::ui::PaneKeys</name>
    <message>
        <source>Ne&amp;xt Pane</source>
        <translation>Panel siguien&amp;te</translation>
    </message>
    <message>
        <source>Pre&amp;vious Pane</source>
        <translation>Panel anteri&amp;or</translation>
    </message>
</context>
<context>
    <name>covaria::ui::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Preferencias</translation>
    </message>
    <message>
        <source>Results in the window</source>
        <translation>Resultados en la ventana</translation>
    </message>
    <message>
        <source>New analyses</source>
        <translation>Nuevos análisis</translation>
    </message>
    <message>
        <source>Written into analyses that are added; others stay as they are.</source>
        <translation>Se escriben en los análisis que se añaden; los demás quedan como están.</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Ventana</translation>
    </message>
    <message>
        <source>Of tables and charts of results</source>
        <translation>De las tablas y los gráficos de resultados</translation>
    </message>
    <message>
        <source>As the model gives them</source>
        <translation>Como los da el modelo</translation>
    </message>
    <message>
        <source>Digits of U</source>
        <translation>Cifras de U</translation>
    </message>
    <message>
        <source>Significant digits of uncertainties; estimates are rounded to match</source>
        <translation>Cifras significativas de las incertidumbres; las estimaciones se redondean en consonancia</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Números</translation>
    </message>
    <message>
        <source>Of all tables, charts and fields of the window</source>
        <translation>De todas las tablas, gráficos y campos de la ventana</translation>
    </message>
    <message>
        <source>As the language writes them</source>
        <translation>Como los escribe el idioma</translation>
    </message>
    <message>
        <source>1234.5 (point)</source>
        <translation>1234.5 (punto)</translation>
    </message>
    <message>
        <source>1234,5 (comma)</source>
        <translation>1234,5 (coma)</translation>
    </message>
    <message>
        <source>Coverage factor</source>
        <translation>Factor de cobertura</translation>
    </message>
    <message>
        <source>Of U = k u, where a new analysis begins with a fixed one</source>
        <translation>De U = k u, cuando un nuevo análisis empieza con uno fijo</translation>
    </message>
    <message>
        <source>k from the degrees of freedom or the coverage interval</source>
        <translation>k de los grados de libertad o del intervalo de cobertura</translation>
    </message>
    <message>
        <source>k = 2</source>
        <translation>k = 2</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Pruebas</translation>
    </message>
    <message>
        <source>Of Monte Carlo</source>
        <translation>De Monte Carlo</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>Of the window, when Covaria starts again</source>
        <translation>De la ventana, cuando Covaria se inicie de nuevo</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Como el sistema</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Colores</translation>
    </message>
    <message>
        <source>Of the window, its charts and the scene</source>
        <translation>De la ventana, sus gráficos y la escena</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Oscuro</translation>
    </message>
    <message>
        <source>Font size</source>
        <translation>Tamaño de letra</translation>
    </message>
    <message>
        <source>Of the whole window</source>
        <translation>De toda la ventana</translation>
    </message>
    <message>
        <source>as the system</source>
        <translation>como el sistema</translation>
    </message>
    <message>
        <source> pt</source>
        <translation> pt</translation>
    </message>
    <message>
        <source>Recovery copy</source>
        <translation>Copia de recuperación</translation>
    </message>
    <message>
        <source>How long an edit may stay without a copy that a crash leaves behind</source>
        <translation>Cuánto tiempo puede quedar un cambio sin la copia que deja un fallo del programa</translation>
    </message>
    <message>
        <source>at most </source>
        <translation>como máximo </translation>
    </message>
    <message>
        <source> s after an edit</source>
        <translation> s tras un cambio</translation>
    </message>
    <message>
        <source>Where the project does not state them. Reports and files are the project&apos;s alone.</source>
        <translation>Donde el proyecto no las indica. Los informes y archivos siguen solo al proyecto.</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>Tipo de letra</translation>
    </message>
    <message>
        <source>Covaria&apos;s own</source>
        <translation>La de Covaria</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProblemsModel</name>
    <message>
        <source>, row %1</source>
        <translation>, fila %1</translation>
    </message>
    <message>
        <source>Project: certificate, %1</source>
        <translation>Proyecto: certificado, %1</translation>
    </message>
    <message>
        <source>Project: report</source>
        <translation>Proyecto: informe</translation>
    </message>
    <message>
        <source>evaluation, %1</source>
        <translation>evaluación, %1</translation>
    </message>
    <message>
        <source>To give</source>
        <translation>Por indicar</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Error</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Advertencia</translation>
    </message>
    <message>
        <source>, line %1</source>
        <translation>, línea %1</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Clase</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problema</translation>
    </message>
    <message>
        <source>correlation of %1 and %2</source>
        <translation>correlación de %1 y %2</translation>
    </message>
    <message>
        <source>link of %1</source>
        <translation>enlace de %1</translation>
    </message>
    <message>
        <source>change of %1</source>
        <translation>cambio de %1</translation>
    </message>
    <message>
        <source>requirement on %1</source>
        <translation>requisito de %1</translation>
    </message>
    <message>
        <source>study</source>
        <translation>estudio</translation>
    </message>
    <message>
        <source>design</source>
        <translation>diseño</translation>
    </message>
    <message>
        <source>Way out</source>
        <translation>Salida</translation>
    </message>
    <message>
        <source>or</source>
        <translation>o</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProblemsPane</name>
    <message>
        <source>Problems</source>
        <translation>Problemas</translation>
    </message>
    <message>
        <source>No problems.</source>
        <translation>Sin problemas.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProjectPage</name>
    <message>
        <source>Number</source>
        <translation>Número</translation>
    </message>
    <message>
        <source>Of the project or order; in the report</source>
        <translation>Del proyecto o pedido; en el informe</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Autor</translation>
    </message>
    <message>
        <source>Who evaluated; in the report</source>
        <translation>Quién evaluó; en el informe</translation>
    </message>
    <message>
        <source>Results of all analyses</source>
        <translation>Resultados de todos los análisis</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Cambiar %1</translation>
    </message>
    <message>
        <source>Not stated</source>
        <translation>No indicado</translation>
    </message>
    <message>
        <source>Of results in the window, reports, tables and CSV files; where it is not stated, files have the unit of the model</source>
        <translation>De los resultados en la ventana, los informes, las tablas y los archivos CSV; si no se indica, los archivos llevan la unidad del modelo</translation>
    </message>
    <message>
        <source>Change units of results</source>
        <translation>Cambiar las unidades de los resultados</translation>
    </message>
    <message>
        <source>Digits of U</source>
        <translation>Cifras de U</translation>
    </message>
    <message>
        <source>Significant digits of uncertainties in the window and the report; certificates have two</source>
        <translation>Cifras significativas de las incertidumbres en la ventana y el informe; los certificados tienen dos</translation>
    </message>
    <message>
        <source>Change digits of results</source>
        <translation>Cambiar las cifras de los resultados</translation>
    </message>
    <message>
        <source>Coverage factor</source>
        <translation>Factor de cobertura</translation>
    </message>
    <message>
        <source>A fixed k for U = k u of all analyses whose options state none; empty: from the degrees of freedom, or the coverage interval</source>
        <translation>Un k fijo para U = k u de todos los análisis cuyas opciones no indican ninguno; vacío: a partir de los grados de libertad o del intervalo de cobertura</translation>
    </message>
    <message>
        <source>Change coverage factor</source>
        <translation>Cambiar el factor de cobertura</translation>
    </message>
    <message>
        <source>Reports, certificates and files have these units, and those of the model where none is stated; units of the preferences are of the window only.</source>
        <translation>Los informes, certificados y archivos tienen estas unidades y, donde no se indica ninguna, las del modelo; las unidades de las preferencias son solo de la ventana.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProjectPane</name>
    <message>
        <source>Project</source>
        <translation>Proyecto</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>Re&amp;nombrar</translation>
    </message>
    <message>
        <source>&amp;Delete …</source>
        <translation>&amp;Eliminar …</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Añadir</translation>
    </message>
    <message>
        <source>&amp;Library and Templates …</source>
        <translation>&amp;Biblioteca y plantillas …</translation>
    </message>
    <message>
        <source>The analysis was not added: %1</source>
        <translation>No se añadió el análisis: %1</translation>
    </message>
    <message>
        <source>“%1” is in the project now</source>
        <translation>«%1» está ahora en el proyecto</translation>
    </message>
    <message>
        <source>Delete “%1”?</source>
        <translation>¿Eliminar «%1»?</translation>
    </message>
    <message>
        <source>

It is used by: %1. They will have an error until they use something else.</source>
        <translation>

Lo usan: %1. Tendrán un error hasta que usen otra cosa.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>“%1” is in your library now (Add &gt; From the Library)</source>
        <translation>«%1» está ahora en su biblioteca (Añadir &gt; De la biblioteca)</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ejecutar</translation>
    </message>
    <message>
        <source>Keep in My Library</source>
        <translation>Conservar en mi biblioteca</translation>
    </message>
    <message>
        <source>Show in the Scene</source>
        <translation>Mostrar en la escena</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>Análisis</translation>
    </message>
    <message>
        <source>What it uses</source>
        <translation>Lo que utiliza</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>D&amp;uplicar</translation>
    </message>
    <message>
        <source>Add an analysis or what it uses</source>
        <translation type="unfinished">Añade un análisis o lo que este usa</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProjectTreeModel</name>
    <message>
        <source>Artefacts</source>
        <translation>Artefactos</translation>
    </message>
    <message>
        <source>Instruments</source>
        <translation>Instrumentos</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Robots</translation>
    </message>
    <message>
        <source>Points and frames</source>
        <translation>Puntos y sistemas</translation>
    </message>
    <message>
        <source>Analyses</source>
        <translation>Análisis</translation>
    </message>
    <message>
        <source>has problems</source>
        <translation>tiene problemas</translation>
    </message>
    <message>
        <source>Untitled project</source>
        <translation>Proyecto sin título</translation>
    </message>
    <message>
        <source>Title, notes, certificate and contents of the report</source>
        <translation>Título, notas, certificado y contenido del informe</translation>
    </message>
    <message>
        <source>incomplete</source>
        <translation>incompleto</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Proyecto</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>running</source>
        <translation>en ejecución</translation>
    </message>
    <message>
        <source>up to date</source>
        <translation>actualizado</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fallido</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>desactualizado</translation>
    </message>
    <message>
        <source>%1 of %2 requirements not met</source>
        <translation>%1 de %2 requisitos no cumplidos</translation>
    </message>
    <message>
        <source>Context</source>
        <translation>Contexto</translation>
    </message>
</context>
<context>
    <name>covaria::ui::PropertiesPane</name>
    <message>
        <source>The project is empty. Add an analysis, or first what it uses, with the plus sign above or a right click in the project tree.</source>
        <translation>El proyecto está vacío. Añada un análisis, o antes lo que este usa, con el signo más de arriba o con el botón derecho en el árbol del proyecto.</translation>
    </message>
    <message>
        <source>Select an entry of the project tree to see its properties.</source>
        <translation>Seleccione una entrada del árbol del proyecto para ver sus propiedades.</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Proyecto</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Certificado</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Informe</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>Evaluación</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Entradas</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Opciones</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Estudios</translation>
    </message>
    <message>
        <source>Designs</source>
        <translation>Diseños</translation>
    </message>
    <message>
        <source>Requirements</source>
        <translation>Requisitos</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notas</translation>
    </message>
</context>
<context>
    <name>covaria::ui::QuantityEdit</name>
    <message>
        <source>A value is needed here.</source>
        <translation>Aquí hace falta un valor.</translation>
    </message>
    <message>
        <source>A whole number is needed here.</source>
        <translation>Aquí hace falta un número entero.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::QuantityNotesEdit</name>
    <message>
        <source>Notes on the quantity</source>
        <translation>Notas sobre la magnitud</translation>
    </message>
    <message>
        <source>Why this figure, what was agreed: in the report, below the input quantities</source>
        <translation>Por qué este valor, qué se acordó: en el informe, debajo de las magnitudes de entrada</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ReferenceEditor</name>
    <message>
        <source>(nothing in the project fits: add it first)</source>
        <translation>(nada del proyecto sirve: añádalo antes)</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>(ninguno)</translation>
    </message>
    <message>
        <source>(choose)</source>
        <translation>(elija)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ReportForm</name>
    <message>
        <source>Analyses, of report and certificate</source>
        <translation>Análisis, del informe y del certificado</translation>
    </message>
    <message>
        <source>Chapters of the report</source>
        <translation>Capítulos del informe</translation>
    </message>
    <message>
        <source>Long tables</source>
        <translation>Tablas largas</translation>
    </message>
    <message>
        <source>The report shows what counts most of long tables; the CSV files have them whole. Ticked, they stand whole at the end of the report too.</source>
        <translation>El informe muestra lo que más cuenta de las tablas largas; los archivos CSV las contienen enteras. Si se marca, figuran enteras también al final del informe.</translation>
    </message>
    <message>
        <source>Whole, in an annex</source>
        <translation>Enteras, en un anexo</translation>
    </message>
    <message>
        <source>Change the annex of the report</source>
        <translation>Modificar el anexo del informe</translation>
    </message>
    <message>
        <source>Goes into the report where it is ticked.</source>
        <translation>Entra en el informe donde está marcado.</translation>
    </message>
    <message>
        <source>Put %1 into the report</source>
        <translation>Incluir %1 en el informe</translation>
    </message>
    <message>
        <source>Leave %1 out of the report</source>
        <translation>Excluir %1 del informe</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>English: none is chosen on the page Certificate.</source>
        <translation>Inglés: no se ha elegido ninguno en la página Certificado.</translation>
    </message>
    <message>
        <source>%1, as chosen on the page Certificate.</source>
        <translation>%1, como se eligió en la página Certificado.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ReportPreview</name>
    <message>
        <source>Document</source>
        <translation>Documento</translation>
    </message>
    <message>
        <source>What is shown: the report, or the calibration certificate</source>
        <translation>Lo que se muestra: el informe o el certificado de calibración</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Informe</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Certificado</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>Actualizar</translation>
    </message>
    <message>
        <source>The report</source>
        <translation>El informe</translation>
    </message>
    <message>
        <source>The certificate</source>
        <translation>El certificado</translation>
    </message>
    <message>
        <source>Out of date: the project or its results have changed since.</source>
        <translation>Desactualizado: el proyecto o sus resultados han cambiado desde entonces.</translation>
    </message>
    <message>
        <source>%1 has not been made yet.</source>
        <translation>%1 aún no se ha elaborado.</translation>
    </message>
    <message>
        <source>The analyses are running: %1 waits for them.</source>
        <translation>Los análisis están en ejecución: %1 los espera.</translation>
    </message>
    <message>
        <source>No analysis is up to date: run one first (F5).</source>
        <translation>Ningún análisis está actualizado: ejecute antes uno (F5).</translation>
    </message>
    <message>
        <source>%1 could not be made: %2</source>
        <translation>%1 no se pudo elaborar: %2</translation>
    </message>
    <message>
        <source>1 page, as printed</source>
        <translation>1 página, como impresa</translation>
    </message>
    <message>
        <source>%1 pages, as printed</source>
        <translation>%1 páginas, como impresas</translation>
    </message>
    <message>
        <source>%1; one required text is not stated</source>
        <translation>%1; un texto exigido no está indicado</translation>
    </message>
    <message>
        <source>%1; %2 required texts are not stated</source>
        <translation>%1; %2 textos exigidos no están indicados</translation>
    </message>
    <message>
        <source>Pages as they are printed</source>
        <translation>Páginas tal como se imprimen</translation>
    </message>
    <message>
        <source>Being made …</source>
        <translation>en preparación …</translation>
    </message>
</context>
<context>
    <name>covaria::ui::RequirementsForm</name>
    <message>
        <source>U = %1: the target is %2.</source>
        <translation>U = %1: el objetivo es %2.</translation>
    </message>
    <message>
        <source>met</source>
        <translation>cumplido</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>no cumplido</translation>
    </message>
    <message>
        <source>&lt;li&gt;u of %1 reduced from %2 to %3: %4 of what is stated&lt;/li&gt;</source>
        <translation>&lt;li&gt;u de %1 reducida de %2 a %3: %4 de lo indicado&lt;/li&gt;</translation>
    </message>
    <message>
        <source>&lt;br&gt;It would be met with one of these alone:&lt;ul&gt;%1&lt;/ul&gt;</source>
        <translation>&lt;br&gt;Se cumpliría con una sola de estas:&lt;ul&gt;%1&lt;/ul&gt;</translation>
    </message>
    <message>
        <source>&lt;br&gt;No component suffices alone.</source>
        <translation>&lt;br&gt;Ninguna componente basta por sí sola.</translation>
    </message>
    <message>
        <source> It would be met with all standard uncertainties multiplied by %1.</source>
        <translation> Se cumpliría con todas las incertidumbres típicas multiplicadas por %1.</translation>
    </message>
    <message>
        <source>(trials)</source>
        <translation>(pruebas)</translation>
    </message>
    <message>
        <source>(Student t)</source>
        <translation>(t de Student)</translation>
    </message>
    <message>
        <source>(normal)</source>
        <translation>(normal)</translation>
    </message>
    <message>
        <source>Not judged: %1.</source>
        <translation>No se juzga: %1.</translation>
    </message>
    <message>
        <source>By %5, guard band %1: the result is &lt;b&gt;%2&lt;/b&gt;. Probability of conformance %3 %4.</source>
        <translation>Según %5, banda de guarda %1: el resultado es &lt;b&gt;%2&lt;/b&gt;. Probabilidad de conformidad %3 %4.</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>aceptado</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>rechazado</translation>
    </message>
    <message>
        <source>&lt;br&gt;TUR %1, C&lt;sub&gt;m&lt;/sub&gt; %2.</source>
        <translation>&lt;br&gt;TUR %1, C&lt;sub&gt;m&lt;/sub&gt; %2.</translation>
    </message>
    <message>
        <source>&lt;br&gt;Global risks of the rule: consumer&apos;s %1, producer&apos;s %2.</source>
        <translation>&lt;br&gt;Riesgos globales de la regla: del consumidor %1, del productor %2.</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Change the requirement for %1</source>
        <translation>Modificar el requisito para %1</translation>
    </message>
    <message>
        <source>By the law of propagation; Monte Carlo is to follow.</source>
        <translation>Por la ley de propagación; seguirá Monte Carlo.</translation>
    </message>
    <message>
        <source>By the trials of a preview; the whole run is to follow.</source>
        <translation>Por las pruebas de una vista previa; seguirá la ejecución completa.</translation>
    </message>
    <message>
        <source>Run the analysis to see whether the requirement is met.</source>
        <translation>Ejecute el análisis para ver si se cumple el requisito.</translation>
    </message>
    <message>
        <source>&lt;br&gt;Of what the rule accepts %1 does not conform, of what it rejects %2 does.</source>
        <translation>&lt;br&gt;De lo que la regla acepta, %1 no es conforme; de lo que rechaza, %2 lo es.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ResultTableModel</name>
    <message>
        <source>Ends of the interval differ by %1 and %2 from those of Monte Carlo; tolerance %3</source>
        <translation>Los extremos del intervalo difieren en %1 y %2 de los de Monte Carlo; tolerancia %3</translation>
    </message>
    <message>
        <source>. Other trials could give the other verdict: more of them decide.</source>
        <translation>. Otras pruebas podrían dar el juicio contrario: más pruebas deciden.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ResultsPane</name>
    <message>
        <source>Results</source>
        <translation>Resultados</translation>
    </message>
    <message>
        <source>Budget</source>
        <translation>Balance</translation>
    </message>
    <message>
        <source>Distributions</source>
        <translation>Distribuciones</translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation>Correlación</translation>
    </message>
    <message>
        <source>Convergence</source>
        <translation>Convergencia</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>Evaluación</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Estudio</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>Diseño</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>digits of U: </source>
        <translation>cifras de U: </translation>
    </message>
    <message>
        <source>Significant digits of uncertainties</source>
        <translation>Cifras significativas de las incertidumbres</translation>
    </message>
    <message>
        <source>Significant digits of uncertainties in the window; estimates are rounded to match. Documents have those of the project page.</source>
        <translation>Cifras significativas de las incertidumbres en la ventana; las estimaciones se redondean en consecuencia. Los documentos tienen las de la página del proyecto.</translation>
    </message>
    <message>
        <source>Filter: symbol, name, group</source>
        <translation>Filtro: símbolo, nombre, grupo</translation>
    </message>
    <message>
        <source>Filter of the results</source>
        <translation>Filtro de los resultados</translation>
    </message>
    <message>
        <source>All groups</source>
        <translation>Todos los grupos</translation>
    </message>
    <message>
        <source>Results of all poses, points or targets, whichever is selected</source>
        <translation>Resultados de todas las poses, puntos o dianas, sea cual sea la selección</translation>
    </message>
    <message>
        <source>Not met only</source>
        <translation>Solo no cumplidos</translation>
    </message>
    <message>
        <source>Only results whose target uncertainty or tolerance is not met</source>
        <translation>Solo resultados que no cumplen la incertidumbre objetivo o la tolerancia</translation>
    </message>
    <message>
        <source>results</source>
        <translation>resultados</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Shortest Coverage Intervals</source>
        <translation>Intervalos de cobertura más cortos</translation>
    </message>
    <message>
        <source>budget</source>
        <translation>balance</translation>
    </message>
    <message>
        <source>correlation</source>
        <translation>correlación</translation>
    </message>
    <message>
        <source>All Results</source>
        <translation>Todos los resultados</translation>
    </message>
    <message>
        <source>Go to Source</source>
        <translation>Ir al origen</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Gráficos</translation>
    </message>
    <message>
        <source>Document</source>
        <translation>Documento</translation>
    </message>
    <message>
        <source>Kind of chart</source>
        <translation>Clase de gráfico</translation>
    </message>
    <message>
        <source>Which charts of the result are shown</source>
        <translation>Qué gráficos del resultado se muestran</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Escena</translation>
    </message>
    <message>
        <source>Contributions</source>
        <translation>Contribuciones</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Observado</translation>
    </message>
</context>
<context>
    <name>covaria::ui::RunActions</name>
    <message>
        <source>&amp;Run This Analysis</source>
        <translation>&amp;Ejecutar este análisis</translation>
    </message>
    <message>
        <source>Run &amp;All</source>
        <translation>Ejecutar &amp;todo</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Detener</translation>
    </message>
    <message>
        <source>&amp;Live</source>
        <translation>En &amp;vivo</translation>
    </message>
    <message>
        <source>Each edit computes first-order results at once, then Monte Carlo</source>
        <translation>Cada cambio calcula de inmediato resultados de primer orden, luego Monte Carlo</translation>
    </message>
</context>
<context>
    <name>covaria::ui::RunStatus</name>
    <message>
        <source>%1 trials</source>
        <translation>%1 pruebas</translation>
    </message>
    <message>
        <source>, %1 million/s</source>
        <translation>, %1 millones/s</translation>
    </message>
    <message>
        <source>Progress of the run</source>
        <translation>Avance de la ejecución</translation>
    </message>
    <message>
        <source>Stop all runs (Esc)</source>
        <translation>Detener todas las ejecuciones (Esc)</translation>
    </message>
    <message>
        <source>Stop all runs</source>
        <translation>Detener todas las ejecuciones</translation>
    </message>
    <message>
        <source>%1: %2 %</source>
        <translation>%1: %2 %</translation>
    </message>
    <message>
        <source>, best so far %1</source>
        <translation>, mejor hasta ahora %1</translation>
    </message>
    <message>
        <source>No analysis yet</source>
        <translation>Aún no hay análisis</translation>
    </message>
    <message>
        <source>No analysis selected</source>
        <translation>Ningún análisis seleccionado</translation>
    </message>
    <message>
        <source>has problems</source>
        <translation>tiene problemas</translation>
    </message>
    <message>
        <source>, %1 trials</source>
        <translation>, %1 pruebas</translation>
    </message>
    <message>
        <source>, with warnings</source>
        <translation>, con advertencias</translation>
    </message>
    <message>
        <source>%1, kept state: </source>
        <translation>%1, estado conservado: </translation>
    </message>
    <message>
        <source>%1 s left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 min left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 h left</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::ScenePanel</name>
    <message>
        <source>Select an analysis in the project tree to see its layout here.</source>
        <translation>Seleccione un análisis en el árbol del proyecto para ver aquí su disposición.</translation>
    </message>
    <message>
        <source>Which pose or group of outputs to show</source>
        <translation>Qué pose o grupo de salidas se muestra</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grupo</translation>
    </message>
    <message>
        <source>Iso</source>
        <translation>Iso</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajustar</translation>
    </message>
    <message>
        <source>Everything in the picture (F)</source>
        <translation>Todo en la imagen (F)</translation>
    </message>
    <message>
        <source>Magnification of the uncertainty; it is always written in the picture</source>
        <translation>Ampliación de la incertidumbre; siempre figura escrita en la imagen</translation>
    </message>
    <message>
        <source>Magnification of the uncertainty</source>
        <translation>Ampliación de la incertidumbre</translation>
    </message>
    <message>
        <source>× %1</source>
        <translation>× %1</translation>
    </message>
    <message>
        <source>Coverage probability of the ellipsoids</source>
        <translation>Probabilidad de cobertura de los elipsoides</translation>
    </message>
    <message>
        <source>p = %1 %</source>
        <translation>p = %1 %</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Sistemas</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>Cuerpos</translation>
    </message>
    <message>
        <source>Links and Sight Lines</source>
        <translation>Eslabones y líneas de visión</translation>
    </message>
    <message>
        <source>Vectors</source>
        <translation>Vectores</translation>
    </message>
    <message>
        <source>Ellipsoids</source>
        <translation>Elipsoides</translation>
    </message>
    <message>
        <source>Clouds</source>
        <translation>Nubes</translation>
    </message>
    <message>
        <source>Histograms on the Walls</source>
        <translation>Histogramas en las paredes</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Etiquetas</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Ejes</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Leyenda</translation>
    </message>
    <message>
        <source>Map of a Study or Design</source>
        <translation>Mapa de un estudio o diseño</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Capas</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;  at %2</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;  en %2</translation>
    </message>
    <message>
        <source>,  u = %1</source>
        <translation>,  u = %1</translation>
    </message>
    <message>
        <source>,  U = %1</source>
        <translation>,  U = %1</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Vistas</translation>
    </message>
    <message>
        <source>Ellipsoids of the Kept State</source>
        <translation>Elipsoides del estado conservado</translation>
    </message>
    <message>
        <source>× auto</source>
        <translation>× auto</translation>
    </message>
    <message>
        <source>Context Meshes</source>
        <translation>Mallas de contexto</translation>
    </message>
    <message>
        <source>View from the front right, from above (1); beside it standard and saved views, orthographic or perspective</source>
        <translation>Vista desde delante a la derecha y arriba (1); al lado, vistas estándar y guardadas, ortográficas o en perspectiva</translation>
    </message>
    <message>
        <source>Layers: what the picture shows</source>
        <translation>Capas: lo que muestra la imagen</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SceneView</name>
    <message>
        <source>3D scene</source>
        <translation>Escena 3D</translation>
    </message>
    <message>
        <source>The picture could not be written to %1</source>
        <translation>No se pudo escribir la imagen en %1</translation>
    </message>
    <message>
        <source>Drawing …</source>
        <translation>Dibujando …</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajustar</translation>
    </message>
    <message>
        <source>Copy Picture</source>
        <translation>Copiar imagen</translation>
    </message>
    <message>
        <source>Save Picture …</source>
        <translation>Guardar imagen …</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Guardar imagen</translation>
    </message>
    <message>
        <source>scene.png</source>
        <translation>escena.png</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>Imagen PNG (*.png)</translation>
    </message>
    <message>
        <source>Arrow keys turn the scene, plus and minus zoom, F fits, 1 to 7 are standard views, H hides what is selected, I shows it alone, Shift+H shows all; points and instruments can be dragged to another place</source>
        <translation>Las teclas de flecha giran la escena, más y menos la amplían o reducen, F la encuadra, 1 a 7 son vistas estándar, H oculta lo seleccionado, I muestra solo eso, Mayús+H muestra todo; los puntos e instrumentos se pueden arrastrar a otro lugar</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ocultar</translation>
    </message>
    <message>
        <source>Show Only This</source>
        <translation>Mostrar solo esto</translation>
    </message>
    <message>
        <source>Show All</source>
        <translation>Mostrar todo</translation>
    </message>
    <message>
        <source>Type Coordinates</source>
        <translation>Escribir coordenadas</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SearchActions</name>
    <message>
        <source>&amp;Find Anything …</source>
        <translation>&amp;Buscar cualquier cosa …</translation>
    </message>
    <message>
        <source>analysis</source>
        <translation>análisis</translation>
    </message>
    <message>
        <source>asset</source>
        <translation>recurso</translation>
    </message>
    <message>
        <source>command, menu %1</source>
        <translation>orden, menú %1</translation>
    </message>
    <message>
        <source>field of %1</source>
        <translation>campo de %1</translation>
    </message>
    <message>
        <source>result of %1</source>
        <translation>resultado de %1</translation>
    </message>
    <message>
        <source>input quantity of %1</source>
        <translation>magnitud de entrada de %1</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>pestaña</translation>
    </message>
    <message>
        <source>help</source>
        <translation>ayuda</translation>
    </message>
    <message>
        <source>help: %1</source>
        <translation>ayuda: %1</translation>
    </message>
    <message>
        <source>group</source>
        <translation type="unfinished">grupo</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SearchPalette</name>
    <message>
        <source>Find anything</source>
        <translation>Buscar cualquier cosa</translation>
    </message>
    <message>
        <source>Analyses, quantities, results, fields, commands, help</source>
        <translation>Análisis, magnitudes, resultados, campos, órdenes, ayuda</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Lo que se encontró</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SecondPart</name>
    <message>
        <source>View of the second part</source>
        <translation>Vista de la segunda parte</translation>
    </message>
    <message>
        <source>What the second part of the stage shows</source>
        <translation>Lo que muestra la segunda parte del área central</translation>
    </message>
    <message>
        <source>Close this part</source>
        <translation>Cerrar esta parte</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SeenTab</name>
    <message>
        <source>seen</source>
        <translation>observado</translation>
    </message>
    <message>
        <source>What the residuals say</source>
        <translation>Lo que dicen los residuos</translation>
    </message>
    <message>
        <source>Level of the tests</source>
        <translation>Nivel de los contrastes</translation>
    </message>
    <message>
        <source>How often a figure that is right is contradicted by chance</source>
        <translation>Con qué frecuencia se contradice por azar una cifra que es correcta</translation>
    </message>
    <message>
        <source>Level %1 %</source>
        <translation>Nivel %1 %</translation>
    </message>
    <message>
        <source>Back to Stated</source>
        <translation>Volver a lo indicado</translation>
    </message>
    <message>
        <source>Take Over as Seen</source>
        <translation>Adoptar lo observado</translation>
    </message>
    <message>
        <source>The results follow from the stated uncertainties again</source>
        <translation>Los resultados se deducen de nuevo de las incertidumbres indicadas</translation>
    </message>
    <message>
        <source>The results, and all that hang on them, follow from the uncertainties that the residuals see, and change with the readings; can be undone</source>
        <translation>Los resultados, y todo lo que depende de ellos, se deducen de las incertidumbres que ven los residuos, y cambian con las lecturas; se puede deshacer</translation>
    </message>
    <message>
        <source>Back to stated uncertainties</source>
        <translation>Volver a las incertidumbres indicadas</translation>
    </message>
    <message>
        <source>Take over uncertainties as seen</source>
        <translation>Adoptar las incertidumbres observadas</translation>
    </message>
    <message>
        <source>Go to Source</source>
        <translation type="unfinished">Ir al origen</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SeenTableModel</name>
    <message>
        <source>interval of the factor</source>
        <translation>intervalo del factor</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SetupForm</name>
    <message>
        <source>Change %1</source>
        <translation>Cambiar %1</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>y %n más</numerusform>
            <numerusform>y %n más</numerusform>
        </translation>
    </message>
    <message>
        <source>From “%1”: %2. What is stated of them here is not used.</source>
        <translation>De «%1»: %2. Lo que aquí se indica de ellas no se usa.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SetupTableModel</name>
    <message>
        <source>Insert rows in %1</source>
        <translation>Insertar filas en %1</translation>
    </message>
    <message>
        <source>Delete rows of %1</source>
        <translation>Eliminar filas de %1</translation>
    </message>
    <message>
        <source>Paste into %1</source>
        <translation>Pegar en %1</translation>
    </message>
    <message>
        <source>Delete rows</source>
        <translation>Eliminar filas</translation>
    </message>
    <message>
        <source>Fill down in %1</source>
        <translation>Rellenar abajo en %1</translation>
    </message>
    <message>
        <source>Clear cells of %1</source>
        <translation>Vaciar celdas de %1</translation>
    </message>
    <message>
        <source>Change unit in %1</source>
        <translation>Cambiar unidad en %1</translation>
    </message>
    <message>
        <source>Take %1 into the project</source>
        <translation>Incorporar %1 al proyecto</translation>
    </message>
    <message>
        <source>%1 is no unit for a quantity in %2.</source>
        <translation>%1 no es unidad para una magnitud en %2.</translation>
    </message>
    <message>
        <source>Its value is %1 of the analysis “%2”: what is stated here is not used.</source>
        <translation>Su valor es %1 del análisis «%2»: lo que se declara aquí no se usa.</translation>
    </message>
    <message>
        <source>%1 of the value</source>
        <translation>%1 del valor</translation>
    </message>
    <message>
        <source>%1 absolute, not a part of the value</source>
        <translation>%1 en términos absolutos, no una fracción del valor</translation>
    </message>
    <message>
        <source>Change %1: %2</source>
        <translation>Cambiar %1: %2</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>fila %1</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SortableTable</name>
    <message>
        <source>Click to sort, right click to choose columns</source>
        <translation>Clic para ordenar, botón derecho para elegir columnas</translation>
    </message>
    <message>
        <source>Save Table</source>
        <translation>Guardar tabla</translation>
    </message>
    <message>
        <source>CSV table (*.csv)</source>
        <translation>Tabla CSV (*.csv)</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Seleccionar todo</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Columnas</translation>
    </message>
    <message>
        <source>Original Order</source>
        <translation>Orden original</translation>
    </message>
    <message>
        <source>Save as CSV …</source>
        <translation>Guardar como CSV …</translation>
    </message>
    <message>
        <source>Fit Widths</source>
        <translation>Ajustar anchuras</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SpreadsheetView</name>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Cortar</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Pegar</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Vaciar</translation>
    </message>
    <message>
        <source>Fill down</source>
        <translation>Rellenar abajo</translation>
    </message>
    <message>
        <source>Insert row above</source>
        <translation>Insertar fila encima</translation>
    </message>
    <message>
        <source>Add row at the end</source>
        <translation>Añadir fila al final</translation>
    </message>
    <message>
        <source>Delete rows</source>
        <translation>Eliminar filas</translation>
    </message>
</context>
<context>
    <name>covaria::ui::Stage</name>
    <message>
        <source>Two views at once</source>
        <translation>Dos vistas a la vez</translation>
    </message>
    <message>
        <source>Below Each Other</source>
        <translation>Una debajo de otra</translation>
    </message>
    <message>
        <source>Beside Each Other</source>
        <translation>Una al lado de otra</translation>
    </message>
</context>
<context>
    <name>covaria::ui::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>Página de inicio</translation>
    </message>
    <message>
        <source>New Project</source>
        <translation>Nuevo proyecto</translation>
    </message>
    <message>
        <source>Open …</source>
        <translation>Abrir …</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Recientes</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Ejemplos</translation>
    </message>
    <message>
        <source>They open as new projects; the shipped files stay as they are.</source>
        <translation>Se abren como proyectos nuevos; los archivos suministrados quedan como están.</translation>
    </message>
    <message>
        <source>Projects that you open are listed here.</source>
        <translation>Aquí figuran los proyectos que abra.</translation>
    </message>
    <message>
        <source>First Steps</source>
        <translation>Primeros pasos</translation>
    </message>
    <message>
        <source>A budget from nothing to a PDF, in ten steps beside the window</source>
        <translation>Un balance desde cero hasta el PDF, en diez pasos junto a la ventana</translation>
    </message>
    <message>
        <source>What do you want to know?</source>
        <translation>¿Qué quiere saber?</translation>
    </message>
    <message>
        <source>Library …</source>
        <translation>Biblioteca …</translation>
    </message>
    <message>
        <source>A quantity by an equation</source>
        <translation>Una magnitud por una ecuación</translation>
    </message>
    <message>
        <source>Type y = f(x), state each input, get the budget.</source>
        <translation>Escriba y = f(x), indique cada entrada, obtenga el balance.</translation>
    </message>
    <message>
        <source>Points by instruments</source>
        <translation>Puntos con instrumentos</translation>
    </message>
    <message>
        <source>Tracker, total station, camera; one or many.</source>
        <translation>Seguidor, estación total, cámara; uno o varios.</translation>
    </message>
    <message>
        <source>The pose of an object</source>
        <translation>La pose de un objeto</translation>
    </message>
    <message>
        <source>A frame from its points, in the frame of another.</source>
        <translation>Un sistema a partir de sus puntos, en el sistema de otro.</translation>
    </message>
    <message>
        <source>A robot</source>
        <translation>Un robot</translation>
    </message>
    <message>
        <source>Where its tool is, and what its parameters are.</source>
        <translation>Dónde está su herramienta y cuáles son sus parámetros.</translation>
    </message>
    <message>
        <source>A file I have</source>
        <translation>Un archivo que tengo</translation>
    </message>
    <message>
        <source>Excel budget, points, measurement report.</source>
        <translation>Balance de Excel, puntos, informe de medición.</translation>
    </message>
    <message>
        <source>Budget, Points or Report …</source>
        <translation>Balance, puntos o informe …</translation>
    </message>
    <message>
        <source>Robot (URDF) …</source>
        <translation>Robot (URDF) …</translation>
    </message>
    <message>
        <source>Project …</source>
        <translation>Proyecto …</translation>
    </message>
    <message>
        <source>Show All %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::StudiesForm</name>
    <message>
        <source>Study</source>
        <translation>Estudio</translation>
    </message>
    <message>
        <source>Adds a study of this analysis</source>
        <translation>Añade un estudio de este análisis</translation>
    </message>
    <message>
        <source>Adds a copy of this study</source>
        <translation>Añade una copia de este estudio</translation>
    </message>
    <message>
        <source>Deletes this study</source>
        <translation>Elimina este estudio</translation>
    </message>
    <message>
        <source>Evaluates the analysis at every grid point of this study</source>
        <translation>Evalúa el análisis en cada punto de la malla de este estudio</translation>
    </message>
    <message>
        <source>A study evaluates this analysis for many values of a number: a sweep over one, a map over two or three. Add one to see how the uncertainty depends on the set-up.</source>
        <translation>Un estudio evalúa este análisis para muchos valores de un número: un barrido de uno, un mapa de dos o tres. Añada uno para ver cómo depende la incertidumbre de la configuración.</translation>
    </message>
    <message>
        <source>Name of the study</source>
        <translation>Nombre del estudio</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>Law of propagation</source>
        <translation>Ley de propagación</translation>
    </message>
    <message>
        <source>Monte Carlo</source>
        <translation>Monte Carlo</translation>
    </message>
    <message>
        <source>Trials at each grid point</source>
        <translation>Pruebas en cada punto de la malla</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Trials per point</source>
        <translation>Pruebas por punto</translation>
    </message>
    <message>
        <source>Add Axis</source>
        <translation>Añadir eje</translation>
    </message>
    <message>
        <source>Varies one more number: every combination is evaluated</source>
        <translation>Varía un número más: se evalúan todas las combinaciones</translation>
    </message>
    <message>
        <source>Output quantities of the study</source>
        <translation>Magnitudes de salida del estudio</translation>
    </message>
    <message>
        <source>Output quantities looked at; with none ticked, all measurands</source>
        <translation>Magnitudes de salida consideradas; si no se marca ninguna, todos los mensurandos</translation>
    </message>
    <message>
        <source>Outputs (none ticked: all measurands)</source>
        <translation>Salidas (ninguna marcada: todos los mensurandos)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::StudyAxisEdit</name>
    <message>
        <source>Axis %1</source>
        <translation>Eje %1</translation>
    </message>
    <message>
        <source>Variable %1</source>
        <translation>Variable %1</translation>
    </message>
    <message>
        <source>Remove Axis</source>
        <translation>Quitar eje</translation>
    </message>
    <message>
        <source>Remove Variable</source>
        <translation>Quitar variable</translation>
    </message>
    <message>
        <source>takes these values</source>
        <translation>toma estos valores</translation>
    </message>
    <message>
        <source>is multiplied with</source>
        <translation>se multiplica por</translation>
    </message>
    <message>
        <source>has added to it</source>
        <translation>se incrementa en</translation>
    </message>
    <message>
        <source>evenly spaced</source>
        <translation>equiespaciados</translation>
    </message>
    <message>
        <source>logarithmically spaced</source>
        <translation>espaciado logarítmico</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Hasta</translation>
    </message>
    <message>
        <source>Number of values</source>
        <translation>Número de valores</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancia</translation>
    </message>
    <message>
        <source>It can be put into effect only so well: what counts is the worst within it</source>
        <translation>Solo se puede llevar a la práctica con esta exactitud: cuenta lo peor dentro de ella</translation>
    </message>
    <message>
        <source>Varied</source>
        <translation>Se varía</translation>
    </message>
    <message>
        <source>It</source>
        <translation>Su valor</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>choose what is varied</source>
        <translation>elija lo que se varía</translation>
    </message>
    <message>
        <source> (factor)</source>
        <translation> (factor)</translation>
    </message>
    <message>
        <source>%1: has a problem</source>
        <translation>%1: tiene un problema</translation>
    </message>
</context>
<context>
    <name>covaria::ui::StudyTab</name>
    <message>
        <source>study</source>
        <translation>estudio</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Estudio</translation>
    </message>
    <message>
        <source>Study of this analysis</source>
        <translation>Estudio de este análisis</translation>
    </message>
    <message>
        <source>Run Study</source>
        <translation>Ejecutar estudio</translation>
    </message>
    <message>
        <source>Edit …</source>
        <translation>Editar …</translation>
    </message>
    <message>
        <source>Axes, outputs and method of the study, in the properties of the analysis</source>
        <translation>Ejes, salidas y método del estudio, en las propiedades del análisis</translation>
    </message>
    <message>
        <source>Quantity of the study</source>
        <translation>Magnitud del estudio</translation>
    </message>
    <message>
        <source>What the chart and the scene show</source>
        <translation>Lo que muestran el gráfico y la escena</translation>
    </message>
    <message>
        <source>Kind of chart</source>
        <translation>Clase de gráfico</translation>
    </message>
    <message>
        <source>A map, or lines over the first axis</source>
        <translation>Un mapa, o líneas sobre el primer eje</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Líneas</translation>
    </message>
    <message>
        <source>Axis of the slices</source>
        <translation>Eje de los cortes</translation>
    </message>
    <message>
        <source>Which axis the slices are across</source>
        <translation>A qué eje son transversales los cortes</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>Corte</translation>
    </message>
    <message>
        <source>slice only</source>
        <translation>solo el corte</translation>
    </message>
    <message>
        <source>In the scene: the points of this slice; else all</source>
        <translation>En la escena: los puntos de este corte; si no, todos</translation>
    </message>
    <message>
        <source>ellipsoids</source>
        <translation>elipsoides</translation>
    </message>
    <message>
        <source>In the scene: coverage ellipsoids at the grid points</source>
        <translation>En la escena: elipsoides de cobertura en los puntos de la malla</translation>
    </message>
    <message>
        <source>Add Study …</source>
        <translation>Añadir estudio …</translation>
    </message>
    <message>
        <source>Out of date: of the project as it was</source>
        <translation>Desactualizado: del proyecto tal como era</translation>
    </message>
    <message>
        <source>slice: </source>
        <translation>corte: </translation>
    </message>
    <message>
        <source> – out of date</source>
        <translation> – desactualizado</translation>
    </message>
    <message>
        <source>running …</source>
        <translation>en ejecución …</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Fallido: %1</translation>
    </message>
    <message>
        <source>Not evaluated yet.</source>
        <translation>Aún no evaluado.</translation>
    </message>
    <message>
        <source>%1 grid points</source>
        <translation>%1 puntos de la malla</translation>
    </message>
    <message>
        <source>, %1 without values</source>
        <translation>, %1 sin valores</translation>
    </message>
    <message>
        <source>&lt;b&gt;Out of date&lt;/b&gt;: shown for the project as it was. </source>
        <translation>&lt;b&gt;Desactualizado&lt;/b&gt;: se muestra para el proyecto tal como era. </translation>
    </message>
    <message>
        <source>“%1” shows how the uncertainty depends on what the study varies.</source>
        <translation>«%1» muestra cómo depende la incertidumbre de lo que varía el estudio.</translation>
    </message>
    <message>
        <source>A study evaluates the analysis for many values of a number: add one with “%1”.</source>
        <translation>Un estudio evalúa el análisis para muchos valores de un número: añada uno con «%1».</translation>
    </message>
</context>
<context>
    <name>covaria::ui::StudyTableModel</name>
    <message>
        <source>Remark</source>
        <translation>Comentario</translation>
    </message>
    <message>
        <source>Why there are no values, or what is wrong with them</source>
        <translation>Por qué no hay valores, o qué les pasa</translation>
    </message>
</context>
<context>
    <name>covaria::ui::TabBar</name>
    <message>
        <source>More tabs</source>
        <translation>Más pestañas</translation>
    </message>
</context>
<context>
    <name>covaria::ui::TableEditor</name>
    <message>
        <source>Take into the project</source>
        <translation>Incorporar al proyecto</translation>
    </message>
    <message>
        <source>Add row</source>
        <translation>Añadir fila</translation>
    </message>
    <message>
        <source>Delete rows</source>
        <translation>Eliminar filas</translation>
    </message>
    <message>
        <source>Import CSV …</source>
        <translation>Importar CSV …</translation>
    </message>
    <message>
        <source>Read from %1</source>
        <translation>Leído de %1</translation>
    </message>
    <message>
        <source>The rows are read from %1. Taken into the project they can be edited here.</source>
        <translation>Las filas se leen de %1. Incorporadas al proyecto, se pueden editar aquí.</translation>
    </message>
    <message>
        <source>Import CSV into %1</source>
        <translation>Importar CSV en %1</translation>
    </message>
    <message>
        <source>Tables (*.csv *.tsv *.txt);;All files (*)</source>
        <translation>Tablas (*.csv *.tsv *.txt);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Importar %1</translation>
    </message>
    <message>
        <source>All columns</source>
        <translation>Todas las columnas</translation>
    </message>
    <message>
        <source>Shows also the columns that no row has something in</source>
        <translation>Muestra también las columnas en las que ninguna fila tiene algo</translation>
    </message>
    <message>
        <source>Fill down</source>
        <translation type="unfinished">Rellenar abajo</translation>
    </message>
</context>
<context>
    <name>covaria::ui::TargetBox</name>
    <message>
        <source>What is varied: type a part of its name to search</source>
        <translation>Lo que se varía: teclee parte de su nombre para buscar</translation>
    </message>
    <message>
        <source>What is varied</source>
        <translation>Lo que se varía</translation>
    </message>
    <message>
        <source>“%1” names nothing that can be varied.</source>
        <translation>«%1» no designa nada que se pueda variar.</translation>
    </message>
    <message numerus="yes">
        <source>“%1” names %n things that can be varied.</source>
        <translation>
            <numerusform>«%1» designa %n cosas que se pueden variar.</numerusform>
            <numerusform>«%1» designa %n cosas que se pueden variar.</numerusform>
        </translation>
    </message>
    <message>
        <source> (factor)</source>
        <translation> (factor)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::UnitButton</name>
    <message>
        <source>Units</source>
        <translation>Unidades</translation>
    </message>
    <message>
        <source>Units of the tables and charts</source>
        <translation>Unidades de las tablas y los gráficos</translation>
    </message>
    <message>
        <source>As the Model Gives Them</source>
        <translation>Como las da el modelo</translation>
    </message>
    <message>
        <source>Change unit of results</source>
        <translation>Cambiar la unidad de los resultados</translation>
    </message>
    <message>
        <source>Clear units of results</source>
        <translation>Borrar las unidades de los resultados</translation>
    </message>
    <message>
        <source>In Reports and Files Too</source>
        <translation>También en informes y archivos</translation>
    </message>
    <message>
        <source>States the units that are shown in the project: they are those of its documents</source>
        <translation>Fija en el proyecto las unidades que se muestran: son las de sus documentos</translation>
    </message>
    <message>
        <source>Units of the tables and charts; reports and files have those that the project states</source>
        <translation>Unidades de las tablas y gráficos; los informes y archivos tienen las que indica el proyecto</translation>
    </message>
</context>
<context>
    <name>covaria::ui::UnitChoices</name>
    <message>
        <source>Lengths</source>
        <translation>Longitudes</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Ángulos</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Fuerzas</translation>
    </message>
    <message>
        <source>Moments</source>
        <translation>Momentos</translation>
    </message>
</context>
<context>
    <name>covaria::ui::UnreadTexts</name>
    <message>
        <source>What is typed in a field cannot be read. %1</source>
        <translation>Lo tecleado en un campo no se puede leer. %1</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ViewActions</name>
    <message>
        <source>&amp;Scene</source>
        <translation>&amp;Escena</translation>
    </message>
    <message>
        <source>Save View</source>
        <translation>Guardar vista</translation>
    </message>
    <message>
        <source>Name of the view:</source>
        <translation>Nombre de la vista:</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajustar</translation>
    </message>
    <message>
        <source>&amp;Orthographic</source>
        <translation>&amp;Ortográfica</translation>
    </message>
    <message>
        <source>Parallel lines stay parallel, and the scale bar holds everywhere</source>
        <translation>Las líneas paralelas siguen paralelas y la escala gráfica vale en todas partes</translation>
    </message>
    <message>
        <source>Show &amp;All</source>
        <translation>Mostrar &amp;todo</translation>
    </message>
    <message>
        <source>&amp;Save View …</source>
        <translation>&amp;Guardar vista …</translation>
    </message>
    <message>
        <source>Remo&amp;ve View</source>
        <translation>&amp;Quitar vista</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Vista %1</translation>
    </message>
    <message>
        <source>Save View %1</source>
        <translation>Guardar vista %1</translation>
    </message>
    <message>
        <source>Remove View %1</source>
        <translation>Quitar vista %1</translation>
    </message>
</context>
</TS>
