<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>QObject</name>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>&lt;p&gt;%1 more rows; the exported table has all of them.&lt;/p&gt;</source>
        <translation>&lt;p&gt;%1 weitere Zeilen; die exportierte Tabelle enthält alle.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>%1 drehen</translation>
    </message>
    <message>
        <source>&lt;b&gt;Trial %1&lt;/b&gt;, inputs farthest from their estimates: %2</source>
        <translation>&lt;b&gt;Versuch %1&lt;/b&gt;, Eingangsgrößen am weitesten von ihren Schätzwerten: %2</translation>
    </message>
    <message>
        <source>Only %1 is shown (Shift+H: all)</source>
        <translation>Nur %1 ist gezeigt (Umschalt+H: alles)</translation>
    </message>
    <message numerus="yes">
        <source>%n hidden (Shift+H: show all)</source>
        <translation>
            <numerusform>%n ausgeblendet (Umschalt+H: alles zeigen)</numerusform>
            <numerusform>%n ausgeblendet (Umschalt+H: alles zeigen)</numerusform>
        </translation>
    </message>
    <message>
        <source>The interval is not symmetric about the estimate: state the interval, not y ± U (JCGM 101 5.5).</source>
        <translation>Das Intervall liegt nicht symmetrisch um den Schätzwert: das Intervall angeben, nicht y ± U (JCGM 101 5.5).</translation>
    </message>
    <message>
        <source>Turns about its %1 axis</source>
        <translation>Dreht um seine Achse %1</translation>
    </message>
    <message>
        <source>Moves along %1</source>
        <translation>Verschiebt längs %1</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>Pose from points</source>
        <extracomment>Measurement model</extracomment>
        <translation>Pose aus Punkten</translation>
    </message>
    <message>
        <source>Base frame</source>
        <translation>Basissystem</translation>
    </message>
    <message>
        <source>Base points</source>
        <translation>Basispunkte</translation>
    </message>
    <message>
        <source>Nominal coordinates of the points in their own frame, and standard uncertainties of single coordinates where they differ from the common ones.</source>
        <translation>Nennkoordinaten der Punkte in ihrem eigenen Koordinatensystem und Standardunsicherheiten einzelner Koordinaten, wo sie von den gemeinsamen abweichen.</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name of the point.</source>
        <translation>Name des Punktes.</translation>
    </message>
    <message>
        <source>Nominal coordinate x in the point&apos;s own frame.</source>
        <translation>Nennkoordinate x im eigenen System des Punktes.</translation>
    </message>
    <message>
        <source>Nominal coordinate y in the point&apos;s own frame.</source>
        <translation>Nennkoordinate y im eigenen System des Punktes.</translation>
    </message>
    <message>
        <source>Nominal coordinate z in the point&apos;s own frame.</source>
        <translation>Nennkoordinate z im eigenen System des Punktes.</translation>
    </message>
    <message>
        <source>Standard uncertainty of this x; empty: as typed for all.</source>
        <translation>Standardunsicherheit dieses x; leer: wie für alle eingegeben.</translation>
    </message>
    <message>
        <source>Standard uncertainty of this y; empty: as typed for all.</source>
        <translation>Standardunsicherheit dieses y; leer: wie für alle eingegeben.</translation>
    </message>
    <message>
        <source>Standard uncertainty of this z; empty: as typed for all.</source>
        <translation>Standardunsicherheit dieses z; leer: wie für alle eingegeben.</translation>
    </message>
    <message>
        <source>Frame from its points</source>
        <translation>System aus seinen Punkten</translation>
    </message>
    <message>
        <source>3-2-1: the origin from point 1, the x-axis from points 1 and 2, the xy-plane from points 1, 2 and 3. Least squares: the frame in which the nominal coordinates fit all points best.</source>
        <translation>3-2-1: der Ursprung aus Punkt 1, die x-Achse aus den Punkten 1 und 2, die xy-Ebene aus den Punkten 1, 2 und 3. Kleinste Quadrate: das System, in dem die Nennkoordinaten am besten zu allen Punkten passen.</translation>
    </message>
    <message>
        <source>3-2-1</source>
        <translation>3-2-1</translation>
    </message>
    <message>
        <source>least squares</source>
        <translation>kleinste Quadrate</translation>
    </message>
    <message>
        <source>Side of point 3</source>
        <translation>Seite von Punkt 3</translation>
    </message>
    <message>
        <source>On which side of the x-axis point 3 lies in the base frame b; this directs z.</source>
        <translation>Auf welcher Seite der x-Achse Punkt 3 im Basissystem b liegt; dies legt die Richtung von z fest.</translation>
    </message>
    <message>
        <source>negative y: z = (q3 − q1) × x</source>
        <translation>negatives y: z = (q3 − q1) × x</translation>
    </message>
    <message>
        <source>positive y: z = x × (q3 − q1)</source>
        <translation>positives y: z = x × (q3 − q1)</translation>
    </message>
    <message>
        <source>Origin from point 1, x</source>
        <translation>Ursprung von Punkt 1, x</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along x of the base frame b (s of Eqs 17 and 18).</source>
        <translation>Lage des Ursprungs von Punkt 1 aus entlang x des Basissystems b (s der Gl. 17 und 18).</translation>
    </message>
    <message>
        <source>Origin from point 1, y</source>
        <translation>Ursprung von Punkt 1, y</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along y of the base frame b (s of Eqs 17 and 18).</source>
        <translation>Lage des Ursprungs von Punkt 1 aus entlang y des Basissystems b (s der Gl. 17 und 18).</translation>
    </message>
    <message>
        <source>Origin from point 1, z</source>
        <translation>Ursprung von Punkt 1, z</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along z of the base frame b (s of Eqs 17 and 18).</source>
        <translation>Lage des Ursprungs von Punkt 1 aus entlang z des Basissystems b (s der Gl. 17 und 18).</translation>
    </message>
    <message>
        <source>Pose of the base in frame 0</source>
        <translation>Pose der Basis im System 0</translation>
    </message>
    <message>
        <source>Where the base stands in the frame of the measurement (frame 0, the world of the picture). It matters only for an instrument that stands somewhere.</source>
        <translation>Wo die Basis im System der Messung steht (System 0, die Welt des Bildes). Das ist nur für ein Messgerät von Belang, das irgendwo steht.</translation>
    </message>
    <message>
        <source>Moving frame</source>
        <translation>Bewegtes System</translation>
    </message>
    <message>
        <source>Points of the moving frame</source>
        <translation>Punkte des bewegten Systems</translation>
    </message>
    <message>
        <source>On which side of the x-axis point 3 lies in the moving frame p; this directs z.</source>
        <translation>Auf welcher Seite der x-Achse Punkt 3 im bewegten System p liegt; dies legt die Richtung von z fest.</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along x of the moving frame p (s of Eqs 17 and 18).</source>
        <translation>Lage des Ursprungs von Punkt 1 aus entlang x des bewegten Systems p (s der Gl. 17 und 18).</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along y of the moving frame p (s of Eqs 17 and 18).</source>
        <translation>Lage des Ursprungs von Punkt 1 aus entlang y des bewegten Systems p (s der Gl. 17 und 18).</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along z of the moving frame p (s of Eqs 17 and 18).</source>
        <translation>Lage des Ursprungs von Punkt 1 aus entlang z des bewegten Systems p (s der Gl. 17 und 18).</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>Posen</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>Auswertung</translation>
    </message>
    <message>
        <source>A priori: at the nominal coordinates. A posteriori: at the means of measured coordinates.</source>
        <translation>A priori: an den Nennkoordinaten. A posteriori: an den Mittelwerten gemessener Koordinaten.</translation>
    </message>
    <message>
        <source>a priori (nominal poses)</source>
        <translation>a priori (Nennposen)</translation>
    </message>
    <message>
        <source>a posteriori (measured points)</source>
        <translation>a posteriori (gemessene Punkte)</translation>
    </message>
    <message>
        <source>Nominal poses of the moving frame in the base frame; angles are R = Rz(γ) Ry(β) Rx(α). All poses share the measurement of the base.</source>
        <translation>Nennposen des bewegten Systems im Basissystem; die Winkel sind R = Rz(γ) Ry(β) Rx(α). Alle Posen teilen sich die Messung der Basis.</translation>
    </message>
    <message>
        <source>Name of the pose; groups its results.</source>
        <translation>Name der Pose; fasst ihre Ergebnisse zusammen.</translation>
    </message>
    <message>
        <source>Position x in the base frame.</source>
        <translation>Position x im Basissystem.</translation>
    </message>
    <message>
        <source>Position y in the base frame.</source>
        <translation>Position y im Basissystem.</translation>
    </message>
    <message>
        <source>Position z in the base frame.</source>
        <translation>Position z im Basissystem.</translation>
    </message>
    <message>
        <source>Rotation about x.</source>
        <translation>Drehung um x.</translation>
    </message>
    <message>
        <source>Rotation about y.</source>
        <translation>Drehung um y.</translation>
    </message>
    <message>
        <source>Rotation about z.</source>
        <translation>Drehung um z.</translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation>Gemessene Punkte</translation>
    </message>
    <message>
        <source>Coordinates in one frame 0 for the base and every pose, typed or from a CSV file; the mean of the repeats is the estimate.</source>
        <translation>Koordinaten in einem System 0 für die Basis und jede Pose, eingegeben oder aus einer CSV-Datei; der Mittelwert der Wiederholungen ist der Schätzwert.</translation>
    </message>
    <message>
        <source>set</source>
        <translation>Satz</translation>
    </message>
    <message>
        <source>&quot;base&quot;, or the name of a pose.</source>
        <translation>&quot;base&quot; oder der Name einer Pose.</translation>
    </message>
    <message>
        <source>point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>repeat</source>
        <translation>Wiederholung</translation>
    </message>
    <message>
        <source>Number of the repetition.</source>
        <translation>Nummer der Wiederholung.</translation>
    </message>
    <message>
        <source>Measured coordinate x in frame 0.</source>
        <translation>Gemessene Koordinate x im System 0.</translation>
    </message>
    <message>
        <source>Measured coordinate y in frame 0.</source>
        <translation>Gemessene Koordinate y im System 0.</translation>
    </message>
    <message>
        <source>Measured coordinate z in frame 0.</source>
        <translation>Gemessene Koordinate z im System 0.</translation>
    </message>
    <message>
        <source>Orientation stated as</source>
        <translation>Orientierung angegeben als</translation>
    </message>
    <message>
        <source>Numbers in which the result states the orientation of the moving frame. Angles are undefined in gimbal lock; rotation vector and quaternion are not.</source>
        <translation>Zahlen, in denen das Ergebnis die Orientierung des bewegten Systems angibt. Winkel sind bei kardanischer Blockade (Gimbal Lock) unbestimmt; Rotationsvektor und Quaternion nicht.</translation>
    </message>
    <message>
        <source>Z-Y-X angles (roll α, pitch β, yaw γ)</source>
        <translation>Z-Y-X-Winkel (Rollen α, Nicken β, Gieren γ)</translation>
    </message>
    <message>
        <source>Z-Y-Z angles</source>
        <translation>Z-Y-Z-Winkel</translation>
    </message>
    <message>
        <source>rotation vector</source>
        <translation>Rotationsvektor</translation>
    </message>
    <message>
        <source>unit quaternion</source>
        <translation>Einheitsquaternion</translation>
    </message>
    <message>
        <source>Uncertainty: Base frame</source>
        <translation>Unsicherheit: Basissystem</translation>
    </message>
    <message>
        <source>Uncertainty of the points</source>
        <translation>Unsicherheit der Punkte</translation>
    </message>
    <message>
        <source>Standard uncertainties typed here, or those that an artefact or an instrument of the project gives.</source>
        <translation>Hier eingegebene Standardunsicherheiten oder solche, die ein Prüfkörper oder ein Messgerät des Projekts liefert.</translation>
    </message>
    <message>
        <source>typed</source>
        <translation>eingegeben</translation>
    </message>
    <message>
        <source>artefact or instrument</source>
        <translation>Prüfkörper oder Messgerät</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along x of the base frame b.</source>
        <translation>Standardunsicherheit der Punktkoordinaten entlang x des Basissystems b.</translation>
    </message>
    <message>
        <source>u_x is common</source>
        <translation>u_x ist gemeinsam</translation>
    </message>
    <message>
        <source>One and the same deviation along x for all base points, instead of independent ones.</source>
        <translation>Ein und dieselbe Abweichung entlang x für alle Basispunkte statt unabhängiger.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along y of the base frame b.</source>
        <translation>Standardunsicherheit der Punktkoordinaten entlang y des Basissystems b.</translation>
    </message>
    <message>
        <source>u_y is common</source>
        <translation>u_y ist gemeinsam</translation>
    </message>
    <message>
        <source>One and the same deviation along y for all base points, instead of independent ones.</source>
        <translation>Ein und dieselbe Abweichung entlang y für alle Basispunkte statt unabhängiger.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along z of the base frame b.</source>
        <translation>Standardunsicherheit der Punktkoordinaten entlang z des Basissystems b.</translation>
    </message>
    <message>
        <source>u_z is common</source>
        <translation>u_z ist gemeinsam</translation>
    </message>
    <message>
        <source>One and the same deviation along z for all base points, instead of independent ones.</source>
        <translation>Ein und dieselbe Abweichung entlang z für alle Basispunkte statt unabhängiger.</translation>
    </message>
    <message>
        <source>Their distribution</source>
        <translation>Verteilung</translation>
    </message>
    <message>
        <source>The distribution of typed deviations of the points; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation>Die Verteilung eingegebener Abweichungen der Punkte; angegeben ist ihre Standardunsicherheit, gleich welcher Form.</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>rectangular: limits ± √3 u</source>
        <translation>rechteckig: Grenzen ± √3 u</translation>
    </message>
    <message>
        <source>triangular: limits ± √6 u</source>
        <translation>dreieckig: Grenzen ± √6 u</translation>
    </message>
    <message>
        <source>arc sine: limits ± √2 u</source>
        <translation>Arkussinus: Grenzen ± √2 u</translation>
    </message>
    <message>
        <source>Artefact or instrument</source>
        <translation>Prüfkörper oder Messgerät</translation>
    </message>
    <message>
        <source>Gives the uncertainty of the coordinates of the points of the base frame b.</source>
        <translation>Liefert die Unsicherheit der Koordinaten der Punkte des Basissystems b.</translation>
    </message>
    <message>
        <source>Uncertainty: Moving frame</source>
        <translation>Unsicherheit: bewegtes System</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along x of the moving frame p.</source>
        <translation>Standardunsicherheit der Punktkoordinaten entlang x des bewegten Systems p.</translation>
    </message>
    <message>
        <source>One and the same deviation along x for all points of the moving frame, in all poses, instead of independent ones.</source>
        <translation>Ein und dieselbe Abweichung entlang x für alle Punkte des bewegten Systems, in allen Posen, statt unabhängiger.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along y of the moving frame p.</source>
        <translation>Standardunsicherheit der Punktkoordinaten entlang y des bewegten Systems p.</translation>
    </message>
    <message>
        <source>One and the same deviation along y for all points of the moving frame, in all poses, instead of independent ones.</source>
        <translation>Ein und dieselbe Abweichung entlang y für alle Punkte des bewegten Systems, in allen Posen, statt unabhängiger.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along z of the moving frame p.</source>
        <translation>Standardunsicherheit der Punktkoordinaten entlang z des bewegten Systems p.</translation>
    </message>
    <message>
        <source>One and the same deviation along z for all points of the moving frame, in all poses, instead of independent ones.</source>
        <translation>Ein und dieselbe Abweichung entlang z für alle Punkte des bewegten Systems, in allen Posen, statt unabhängiger.</translation>
    </message>
    <message>
        <source>Gives the uncertainty of the coordinates of the points of the moving frame p.</source>
        <translation>Liefert die Unsicherheit der Koordinaten der Punkte des bewegten Systems p.</translation>
    </message>
    <message>
        <source>Uncertainties along</source>
        <translation>Unsicherheiten entlang</translation>
    </message>
    <message>
        <source>Along which axes the typed uncertainties of the moving points lie: those of the moving frame, which turn with it, or those of the base frame, the same in all poses.</source>
        <translation>Entlang welcher Achsen die eingegebenen Unsicherheiten der bewegten Punkte liegen: der des bewegten Systems, die sich mit ihm drehen, oder der des Basissystems, in allen Posen gleich.</translation>
    </message>
    <message>
        <source>the axes of the moving frame</source>
        <translation>der Achsen des bewegten Systems</translation>
    </message>
    <message>
        <source>the axes of the base frame</source>
        <translation>der Achsen des Basissystems</translation>
    </message>
    <message>
        <source>Points from sensors</source>
        <translation>Punkte aus Sensoren</translation>
    </message>
    <message>
        <source>Network</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>Sensoren</translation>
    </message>
    <message>
        <source>The instruments of the network, each an instrument of the project that stands somewhere.</source>
        <translation>Die Messgeräte des Netzes, jedes ein Messgerät des Projekts, das irgendwo steht.</translation>
    </message>
    <message>
        <source>sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>An instrument of the project.</source>
        <translation>Ein Messgerät des Projekts.</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Zielpunkte</translation>
    </message>
    <message>
        <source>Points to be localised, at their nominal coordinates.</source>
        <translation>Zu bestimmende Punkte, an ihren Nennkoordinaten.</translation>
    </message>
    <message>
        <source>Name of the target, unique.</source>
        <translation>Name des Zielpunktes, eindeutig.</translation>
    </message>
    <message>
        <source>Nominal coordinate x.</source>
        <translation>Nennkoordinate x.</translation>
    </message>
    <message>
        <source>Nominal coordinate y.</source>
        <translation>Nennkoordinate y.</translation>
    </message>
    <message>
        <source>Nominal coordinate z.</source>
        <translation>Nennkoordinate z.</translation>
    </message>
    <message>
        <source>new set-up</source>
        <translation>neue Aufstellung</translation>
    </message>
    <message>
        <source>The sensors were located anew before this target: it and those below share the deviations of the stations with each other, not with the targets above.</source>
        <translation>Die Sensoren wurden vor diesem Zielpunkt neu eingemessen: er und die folgenden haben die Abweichungen der Standpunkte miteinander gemeinsam, nicht mit den Zielpunkten darüber.</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Abstände</translation>
    </message>
    <message>
        <source>Distances between targets that are measurands too, for instance of a scale bar.</source>
        <translation>Abstände zwischen Zielpunkten, die ebenfalls Messgrößen sind, zum Beispiel die eines Maßstabs.</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>Name of a target.</source>
        <translation>Name eines Zielpunktes.</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Name of another target.</source>
        <translation>Name eines anderen Zielpunktes.</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Angles at a target between the directions to two others, measurands too.</source>
        <translation>Winkel an einem Zielpunkt zwischen den Richtungen zu zwei anderen, ebenfalls Messgrößen.</translation>
    </message>
    <message>
        <source>at</source>
        <translation>bei</translation>
    </message>
    <message>
        <source>Name of the target where the angle is.</source>
        <translation>Name des Zielpunktes, an dem der Winkel liegt.</translation>
    </message>
    <message>
        <source>Name of a third target.</source>
        <translation>Name eines dritten Zielpunktes.</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Koordinatensysteme</translation>
    </message>
    <message>
        <source>Frames on three targets (3-2-1), whose position and Z-Y-X angles in the world are measurands too.</source>
        <translation>Koordinatensysteme auf drei Zielpunkten (3-2-1), deren Position und Z-Y-X-Winkel in der Welt ebenfalls Messgrößen sind.</translation>
    </message>
    <message>
        <source>Name of the frame, unique.</source>
        <translation>Name des Systems, eindeutig.</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <source>Target at its origin.</source>
        <translation>Zielpunkt in seinem Ursprung.</translation>
    </message>
    <message>
        <source>on x</source>
        <translation>auf x</translation>
    </message>
    <message>
        <source>Target on its positive x-axis.</source>
        <translation>Zielpunkt auf seiner positiven x-Achse.</translation>
    </message>
    <message>
        <source>in xy</source>
        <translation>in xy</translation>
    </message>
    <message>
        <source>Target in its xy-plane, at positive y.</source>
        <translation>Zielpunkt in seiner xy-Ebene, bei positivem y.</translation>
    </message>
    <message>
        <source>Calibrated lengths</source>
        <translation>Kalibrierte Längen</translation>
    </message>
    <message>
        <source>Scale bars and other calibrated distances between two targets: compared with the network, or a constraint of the estimation.</source>
        <translation>Maßstäbe und andere kalibrierte Abstände zwischen zwei Zielpunkten: mit dem Netz verglichen oder eine Bedingung der Schätzung.</translation>
    </message>
    <message>
        <source>length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Calibrated length; empty in a design: the distance of the nominal targets.</source>
        <translation>Kalibrierte Länge; in einer Planung leer: der Abstand der Nennzielpunkte.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the length as it is during the measurement, with temperature.</source>
        <translation>Standardunsicherheit der Länge, wie sie während der Messung ist, mit Temperatur.</translation>
    </message>
    <message>
        <source>role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>Check: the difference between network and calibration is a measurand. Constraint: the length is adjusted with the readings.</source>
        <translation>Prüfung: Die Differenz zwischen Netz und Kalibrierung ist eine Messgröße. Bedingung: Die Länge wird mit den Ablesungen ausgeglichen.</translation>
    </message>
    <message>
        <source>check</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>constraint</source>
        <translation>Bedingung</translation>
    </message>
    <message>
        <source>distribution</source>
        <translation>Verteilung</translation>
    </message>
    <message>
        <source>The distribution that has the standard uncertainty u; empty: normal.</source>
        <translation>Die Verteilung mit der Standardunsicherheit u; leer: normal.</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Ablesungen</translation>
    </message>
    <message>
        <source>A priori: the readings are those of the nominal targets. A posteriori: the readings are given.</source>
        <translation>A priori: Die Ablesungen sind die der Nennzielpunkte. A posteriori: Die Ablesungen sind gegeben.</translation>
    </message>
    <message>
        <source>a priori (design: nominal targets)</source>
        <translation>a priori (Planung: Nennzielpunkte)</translation>
    </message>
    <message>
        <source>a posteriori (given readings)</source>
        <translation>a posteriori (gegebene Ablesungen)</translation>
    </message>
    <message>
        <source>What the sensors read, one row for a sensor and a target, typed or from a CSV file; leave empty what was not read.</source>
        <translation>Was die Sensoren ablesen, eine Zeile je Sensor und Zielpunkt, eingegeben oder aus einer CSV-Datei; was nicht abgelesen wurde, bleibt leer.</translation>
    </message>
    <message>
        <source>target</source>
        <translation>Zielpunkt</translation>
    </message>
    <message>
        <source>Name of the target.</source>
        <translation>Name des Zielpunktes.</translation>
    </message>
    <message>
        <source>The instrument that read it.</source>
        <translation>Das Messgerät, das ihn abgelesen hat.</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>Distanz</translation>
    </message>
    <message>
        <source>Slope distance.</source>
        <translation>Schrägdistanz.</translation>
    </message>
    <message>
        <source>azimuth</source>
        <translation>Azimut</translation>
    </message>
    <message>
        <source>Horizontal angle from the sensor&apos;s x-axis, positive towards y; whole turns do not matter.</source>
        <translation>Horizontalwinkel von der x-Achse des Sensors aus, positiv in Richtung y; ganze Umdrehungen spielen keine Rolle.</translation>
    </message>
    <message>
        <source>elevation</source>
        <translation>Höhenwinkel</translation>
    </message>
    <message>
        <source>Vertical angle above the sensor&apos;s xy-plane.</source>
        <translation>Vertikalwinkel über der xy-Ebene des Sensors.</translation>
    </message>
    <message>
        <source>Estimation</source>
        <translation>Schätzung</translation>
    </message>
    <message>
        <source>Estimator</source>
        <translation>Schätzer</translation>
    </message>
    <message>
        <source>How a target&apos;s coordinates follow from its readings.</source>
        <translation>Wie die Koordinaten eines Zielpunktes aus seinen Ablesungen folgen.</translation>
    </message>
    <message>
        <source>non-linear weighted least squares</source>
        <translation>nichtlineare gewichtete kleinste Quadrate</translation>
    </message>
    <message>
        <source>linearised equations: OLS, then GLS (Eqs 1-4 of the paper)</source>
        <translation>linearisiert: OLS, dann GLS (Gl. 1-4 des Artikels)</translation>
    </message>
    <message>
        <source>linearised equations: OLS alone (Eq 3 of the paper)</source>
        <translation>linearisierte Gleichungen: nur OLS (Gl. 3 der Veröffentlichung)</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Gewichte</translation>
    </message>
    <message>
        <source>What the weights of the equations account for. Weights from the readings alone, as in the paper, are not the best where the stations are uncertain.</source>
        <translation>Was die Gewichte der Gleichungen berücksichtigen. Gewichte aus den Ablesungen allein, wie in der Veröffentlichung, sind nicht die besten, wenn die Standpunkte unsicher sind.</translation>
    </message>
    <message>
        <source>readings and stations, all targets of a set-up at once</source>
        <translation>Ablesungen und Standpunkte, je Aufstellung zugleich</translation>
    </message>
    <message>
        <source>readings alone, each target by itself (the paper)</source>
        <translation>nur Ablesungen, jeder Zielpunkt für sich (Veröffentlichung)</translation>
    </message>
    <message>
        <source>TCP from ballbars</source>
        <translation>TCP mit Kugelstäben</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Ballbars</source>
        <translation>Kugelstäbe</translation>
    </message>
    <message>
        <source>The set of telescopic ballbars that measures the points.</source>
        <translation>Der Satz teleskopischer Kugelstäbe, der die Punkte misst.</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Gives the repeatability with which the robot goes to the points; none: an ideal robot.</source>
        <translation>Liefert die Wiederholpräzision, mit der der Roboter die Punkte anfährt; keiner: ein idealer Roboter.</translation>
    </message>
    <message>
        <source>The tool centre point from a planned procedure or from measured points; or only the points as the ballbars measure them.</source>
        <translation>Der Werkzeugmittelpunkt aus einem geplanten Verfahren oder aus gemessenen Punkten; oder nur die Punkte, wie die Kugelstäbe sie messen.</translation>
    </message>
    <message>
        <source>tool centre point, planned procedure</source>
        <translation>Werkzeugmittelpunkt, geplantes Verfahren</translation>
    </message>
    <message>
        <source>tool centre point, measured points</source>
        <translation>Werkzeugmittelpunkt, gemessene Punkte</translation>
    </message>
    <message>
        <source>points alone</source>
        <translation>nur Punkte</translation>
    </message>
    <message>
        <source>Procedure</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Flange</source>
        <translation>Flansch</translation>
    </message>
    <message>
        <source>Pose of the flange in the robot&apos;s frame before it turns; its origin is the centre of the sphere on which the ball moves.</source>
        <translation>Pose des Flansches im System des Roboters, bevor er sich dreht; sein Ursprung ist der Mittelpunkt der Kugelfläche, auf der sich die Kugel bewegt.</translation>
    </message>
    <message>
        <source>Tool x</source>
        <translation>Werkzeug x</translation>
    </message>
    <message>
        <source>Nominal coordinate x of the tool centre point in the flange&apos;s frame.</source>
        <translation>Nennkoordinate x des Werkzeugmittelpunktes im System des Flansches.</translation>
    </message>
    <message>
        <source>Tool y</source>
        <translation>Werkzeug y</translation>
    </message>
    <message>
        <source>Nominal coordinate y of the tool centre point in the flange&apos;s frame.</source>
        <translation>Nennkoordinate y des Werkzeugmittelpunktes im System des Flansches.</translation>
    </message>
    <message>
        <source>Tool z</source>
        <translation>Werkzeug z</translation>
    </message>
    <message>
        <source>Nominal coordinate z of the tool centre point in the flange&apos;s frame.</source>
        <translation>Nennkoordinate z des Werkzeugmittelpunktes im System des Flansches.</translation>
    </message>
    <message>
        <source>Rotations</source>
        <translation>Drehungen</translation>
    </message>
    <message>
        <source>Two or three rotations of the flange about its own axes, its origin held in place: the ball traces an arc in each.</source>
        <translation>Zwei oder drei Drehungen des Flansches um seine eigenen Achsen bei festgehaltenem Ursprung: Die Kugel beschreibt jeweils einen Bogen.</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Axis of the flange about which the robot turns.</source>
        <translation>Achse des Flansches, um die der Roboter dreht.</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>Angle at the first point.</source>
        <translation>Winkel am ersten Punkt.</translation>
    </message>
    <message>
        <source>span</source>
        <translation>Spanne</translation>
    </message>
    <message>
        <source>Angle from the first point to the last; negative: turned the other way.</source>
        <translation>Winkel vom ersten bis zum letzten Punkt; negativ: in die andere Richtung gedreht.</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Number of points, equally spaced from the first to the last.</source>
        <translation>Anzahl der Punkte, gleichmäßig vom ersten bis zum letzten verteilt.</translation>
    </message>
    <message>
        <source>Points as measured, each with the axis of its rotation and the commanded angle, typed or from a CSV file.</source>
        <translation>Punkte wie gemessen, jeder mit der Achse seiner Drehung und dem befohlenen Winkel, eingegeben oder aus einer CSV-Datei.</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Commanded angle of rotation.</source>
        <translation>Befohlener Drehwinkel.</translation>
    </message>
    <message>
        <source>Coordinate x in the frame of the ballbars.</source>
        <translation>Koordinate x im System der Kugelstäbe.</translation>
    </message>
    <message>
        <source>Coordinate y in the frame of the ballbars.</source>
        <translation>Koordinate y im System der Kugelstäbe.</translation>
    </message>
    <message>
        <source>Coordinate z in the frame of the ballbars.</source>
        <translation>Koordinate z im System der Kugelstäbe.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Places of the ball that are measured, typed or from a CSV file.</source>
        <translation>Orte der Kugel, die gemessen werden, eingegeben oder aus einer CSV-Datei.</translation>
    </message>
    <message>
        <source>Name of the point, unique.</source>
        <translation>Name des Punktes, eindeutig.</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassung</translation>
    </message>
    <message>
        <source>Axes of the flange</source>
        <translation>Achsen des Flansches</translation>
    </message>
    <message>
        <source>Measured axes are not exactly perpendicular: which one is kept as measured. A third measured axis then only helps the sphere and the mean.</source>
        <translation>Gemessene Achsen sind nicht genau rechtwinklig: welche so bleibt, wie sie gemessen ist. Eine dritte gemessene Achse hilft dann nur der Kugelfläche und dem Mittelwert.</translation>
    </message>
    <message>
        <source>y as measured, x nearest to measured</source>
        <translation>y wie gemessen, x der gemessenen am nächsten</translation>
    </message>
    <message>
        <source>x as measured, y nearest to measured</source>
        <translation>x wie gemessen, y der gemessenen am nächsten</translation>
    </message>
    <message>
        <source>z as measured, x nearest to measured</source>
        <translation>z wie gemessen, x der gemessenen am nächsten</translation>
    </message>
    <message>
        <source>nearest to all measured axes</source>
        <translation>allen gemessenen Achsen am nächsten</translation>
    </message>
    <message>
        <source>Centre of the flange</source>
        <translation>Mittelpunkt des Flansches</translation>
    </message>
    <message>
        <source>Sphere through all points by linear least squares, or refined to least distances from it.</source>
        <translation>Kugelfläche durch alle Punkte mit linearen kleinsten Quadraten oder verfeinert auf kleinste Abstände von ihr.</translation>
    </message>
    <message>
        <source>sphere, geometric fit from the linear one</source>
        <translation>Kugel, geometrisch nach linearer Anpassung</translation>
    </message>
    <message>
        <source>sphere, linear fit</source>
        <translation>Kugel, lineare Anpassung</translation>
    </message>
    <message>
        <source>Robot pose</source>
        <translation>Roboterpose</translation>
    </message>
    <message>
        <source>The arm, with its parameters and their uncertainty.</source>
        <translation>Der Arm mit seinen Parametern und deren Unsicherheit.</translation>
    </message>
    <message>
        <source>Components of a parameter</source>
        <translation>Komponenten eines Parameters</translation>
    </message>
    <message>
        <source>Each by itself, so that the budget tells the sources apart; or combined into one normal deviation, which needs fewer draws.</source>
        <translation>Jede für sich, sodass das Budget die Quellen unterscheidet; oder zu einer normalen Abweichung zusammengefasst, was weniger Ziehungen braucht.</translation>
    </message>
    <message>
        <source>each by itself</source>
        <translation>jede für sich</translation>
    </message>
    <message>
        <source>combined into one</source>
        <translation>zu einer zusammengefasst</translation>
    </message>
    <message>
        <source>Correlation of the parameters</source>
        <translation>Korrelation der Parameter</translation>
    </message>
    <message>
        <source>Used as the robot states it; or ignored, as in the paper, to see what that does.</source>
        <translation>So verwendet, wie der Roboter sie angibt; oder vernachlässigt wie in der Veröffentlichung, um die Wirkung zu sehen.</translation>
    </message>
    <message>
        <source>used</source>
        <translation>verwendet</translation>
    </message>
    <message>
        <source>ignored (the paper)</source>
        <translation>vernachlässigt (Veröffentlichung)</translation>
    </message>
    <message>
        <source>Poses by joint readings</source>
        <translation>Posen nach Gelenkablesungen</translation>
    </message>
    <message>
        <source>Readings of the joints, typed or from a CSV file. An empty cell is the zero reading of the joint; a robot with fewer joints leaves the last columns empty.</source>
        <translation>Ablesungen der Gelenke, eingegeben oder aus einer CSV-Datei. Eine leere Zelle ist die Nullablesung des Gelenks; ein Roboter mit weniger Gelenken lässt die letzten Spalten leer.</translation>
    </message>
    <message>
        <source>Name of the pose, unique.</source>
        <translation>Name der Pose, eindeutig.</translation>
    </message>
    <message>
        <source>Reading of joint 1, if it turns.</source>
        <translation>Ablesung von Gelenk 1, wenn es dreht.</translation>
    </message>
    <message>
        <source>Reading of joint 2, if it turns.</source>
        <translation>Ablesung von Gelenk 2, wenn es dreht.</translation>
    </message>
    <message>
        <source>Reading of joint 3, if it turns.</source>
        <translation>Ablesung von Gelenk 3, wenn es dreht.</translation>
    </message>
    <message>
        <source>Reading of joint 4, if it turns.</source>
        <translation>Ablesung von Gelenk 4, wenn es dreht.</translation>
    </message>
    <message>
        <source>Reading of joint 5, if it turns.</source>
        <translation>Ablesung von Gelenk 5, wenn es dreht.</translation>
    </message>
    <message>
        <source>Reading of joint 6, if it turns.</source>
        <translation>Ablesung von Gelenk 6, wenn es dreht.</translation>
    </message>
    <message>
        <source>Reading of joint 7, if it turns.</source>
        <translation>Ablesung von Gelenk 7, wenn es dreht.</translation>
    </message>
    <message>
        <source>Reading of joint 1, if it slides.</source>
        <translation>Ablesung von Gelenk 1, wenn es schiebt.</translation>
    </message>
    <message>
        <source>Reading of joint 2, if it slides.</source>
        <translation>Ablesung von Gelenk 2, wenn es schiebt.</translation>
    </message>
    <message>
        <source>Reading of joint 3, if it slides.</source>
        <translation>Ablesung von Gelenk 3, wenn es schiebt.</translation>
    </message>
    <message>
        <source>Reading of joint 4, if it slides.</source>
        <translation>Ablesung von Gelenk 4, wenn es schiebt.</translation>
    </message>
    <message>
        <source>Reading of joint 5, if it slides.</source>
        <translation>Ablesung von Gelenk 5, wenn es schiebt.</translation>
    </message>
    <message>
        <source>Reading of joint 6, if it slides.</source>
        <translation>Ablesung von Gelenk 6, wenn es schiebt.</translation>
    </message>
    <message>
        <source>Reading of joint 7, if it slides.</source>
        <translation>Ablesung von Gelenk 7, wenn es schiebt.</translation>
    </message>
    <message>
        <source>Poses by place</source>
        <translation>Posen nach Ort</translation>
    </message>
    <message>
        <source>Places of the tool in the robot&apos;s base frame; the readings follow by inverse kinematics, within the limits and near those of the pose before.</source>
        <translation>Orte des Werkzeugs im Basissystem des Roboters; die Ablesungen folgen durch inverse Kinematik, innerhalb der Grenzen und nahe denen der vorigen Pose.</translation>
    </message>
    <message>
        <source>Name, unique.</source>
        <translation>Name, eindeutig.</translation>
    </message>
    <message>
        <source>Coordinate x of the tool.</source>
        <translation>Koordinate x des Werkzeugs.</translation>
    </message>
    <message>
        <source>Coordinate y of the tool.</source>
        <translation>Koordinate y des Werkzeugs.</translation>
    </message>
    <message>
        <source>Coordinate z of the tool.</source>
        <translation>Koordinate z des Werkzeugs.</translation>
    </message>
    <message>
        <source>Orientation, R = Rz(gamma) Ry(beta) Rx(alpha); all three empty: any orientation.</source>
        <translation>Orientierung, R = Rz(gamma) Ry(beta) Rx(alpha); alle drei leer: beliebige Orientierung.</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Numbers that state the orientation of the tool; none: the position alone.</source>
        <translation>Zahlen, die die Orientierung des Werkzeugs angeben; keine: nur die Position.</translation>
    </message>
    <message>
        <source>none (position alone)</source>
        <translation>keine (nur Position)</translation>
    </message>
    <message>
        <source>Results in</source>
        <translation>Ergebnisse in</translation>
    </message>
    <message>
        <source>The frame in which position and orientation are stated.</source>
        <translation>Das System, in dem Position und Orientierung angegeben werden.</translation>
    </message>
    <message>
        <source>the base frame of the robot</source>
        <translation>dem Basissystem des Roboters</translation>
    </message>
    <message>
        <source>the world frame</source>
        <translation>dem Weltsystem</translation>
    </message>
    <message>
        <source>Robot by joint trajectories</source>
        <translation>Roboter aus Gelenkbahnen</translation>
    </message>
    <message>
        <source>Nominal robot</source>
        <translation>Nennroboter</translation>
    </message>
    <message>
        <source>The arm as designed: directions of the frames, definitions of base and last link, and the arm of a simulation.</source>
        <translation>Der Arm wie konstruiert: Richtungen der Koordinatensysteme, Definitionen von Basis und letztem Glied und der Arm einer Simulation.</translation>
    </message>
    <message>
        <source>Points are</source>
        <translation>Punkte sind</translation>
    </message>
    <message>
        <source>Measured: a table. Simulated: those of the nominal robot, to see what an experiment would give.</source>
        <translation>Gemessen: eine Tabelle. Simuliert: die des Nennroboters, um zu sehen, was ein Experiment ergäbe.</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>simuliert</translation>
    </message>
    <message>
        <source>Points of the ball at the flange in the order in which they were measured, joint by joint, in the frame of the instrument&apos;s world; typed or from a CSV file.</source>
        <translation>Punkte der Kugel am Flansch in der Reihenfolge, in der sie gemessen wurden, Gelenk für Gelenk, im Weltsystem des Messgeräts; eingegeben oder aus einer CSV-Datei.</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>Gelenk</translation>
    </message>
    <message>
        <source>Number of the joint that turned.</source>
        <translation>Nummer des Gelenks, das sich gedreht hat.</translation>
    </message>
    <message>
        <source>Reading of that joint; says which way round the points run. Empty: with the joint&apos;s positive direction.</source>
        <translation>Ablesung dieses Gelenks; sagt, in welcher Richtung die Punkte laufen. Leer: in der positiven Richtung des Gelenks.</translation>
    </message>
    <message>
        <source>Coordinate x.</source>
        <translation>Koordinate x.</translation>
    </message>
    <message>
        <source>Coordinate y.</source>
        <translation>Koordinate y.</translation>
    </message>
    <message>
        <source>Coordinate z.</source>
        <translation>Koordinate z.</translation>
    </message>
    <message>
        <source>Range of each joint, ±</source>
        <translation>Bereich jedes Gelenks, ±</translation>
    </message>
    <message>
        <source>Each joint turns from its zero reading less this to its zero reading plus this.</source>
        <translation>Jedes Gelenk dreht von seiner Nullablesung minus diesem Wert bis zu seiner Nullablesung plus diesem Wert.</translation>
    </message>
    <message>
        <source>Points for each joint</source>
        <translation>Punkte je Gelenk</translation>
    </message>
    <message>
        <source>Number of points, evenly spaced over the range.</source>
        <translation>Anzahl der Punkte, gleichmäßig über den Bereich verteilt.</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Where the ball is in the frame of the last link. On the axis of a joint it draws no circle.</source>
        <translation>Wo die Kugel im System des letzten Glieds ist. Auf der Achse eines Gelenks beschreibt sie keinen Kreis.</translation>
    </message>
    <message>
        <source>A standard uncertainty of every coordinate, or an instrument of the project that stands somewhere.</source>
        <translation>Eine Standardunsicherheit jeder Koordinate oder ein Messgerät des Projekts, das irgendwo steht.</translation>
    </message>
    <message>
        <source>typed: alike for all coordinates</source>
        <translation>eingegeben: gleich für alle Koordinaten</translation>
    </message>
    <message>
        <source>an instrument</source>
        <translation>ein Messgerät</translation>
    </message>
    <message>
        <source>Standard uncertainty of a coordinate</source>
        <translation>Standardunsicherheit einer Koordinate</translation>
    </message>
    <message>
        <source>Of every coordinate of every point, independent of all others.</source>
        <translation>Jeder Koordinate jedes Punktes, unabhängig von allen anderen.</translation>
    </message>
    <message>
        <source>The distribution of the coordinates&apos; deviations; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation>Die Verteilung der Abweichungen der Koordinaten; angegeben ist ihre Standardunsicherheit, gleich welcher Form.</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>Messgerät</translation>
    </message>
    <message>
        <source>What measured the points: each reading deviates by itself, its scale and its station alike for all points.</source>
        <translation>Was die Punkte gemessen hat: Jede Ablesung weicht für sich ab, sein Maßstab und sein Standpunkt für alle Punkte gleich.</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>Plane of a circle</source>
        <translation>Ebene eines Kreises</translation>
    </message>
    <message>
        <source>Total least squares fits any plane. Eq 1 of the paper has no plane through the origin and fails near it.</source>
        <translation>Totale kleinste Quadrate passen jede Ebene an. Gl. 1 der Veröffentlichung kennt keine Ebene durch den Ursprung und versagt in seiner Nähe.</translation>
    </message>
    <message>
        <source>total least squares</source>
        <translation>totale kleinste Quadrate</translation>
    </message>
    <message>
        <source>A x + B y + C z + 1 = 0 (Eq 1)</source>
        <translation>A x + B y + C z + 1 = 0 (Gl. 1)</translation>
    </message>
    <message>
        <source>Axes are parallel below</source>
        <translation>Achsen sind parallel unter</translation>
    </message>
    <message>
        <source>Angle between two axes below which they are described by beta and not by their common perpendicular, whose place is then hardly determined.</source>
        <translation>Winkel zwischen zwei Achsen, unter dem sie durch beta beschrieben werden und nicht durch ihre gemeinsame Normale, deren Ort dann kaum bestimmt ist.</translation>
    </message>
    <message>
        <source>Robot from measured poses</source>
        <translation>Roboter aus gemessenen Posen</translation>
    </message>
    <message>
        <source>The arm as designed: start of the fit, values of what the poses cannot tell, uncertainty of the readings of its joints, and the arm of a simulation.</source>
        <translation>Der Arm wie konstruiert: Startwert der Anpassung, Werte dessen, was die Posen nicht zeigen können, Unsicherheit der Ablesungen seiner Gelenke und der Arm einer Simulation.</translation>
    </message>
    <message>
        <source>Poses are</source>
        <translation>Posen sind</translation>
    </message>
    <message>
        <source>Measured is</source>
        <translation>Gemessen ist</translation>
    </message>
    <message>
        <source>The position of a ball alone, or position and orientation of the tool.</source>
        <translation>Nur die Position einer Kugel oder Position und Orientierung des Werkzeugs.</translation>
    </message>
    <message>
        <source>the position</source>
        <translation>die Position</translation>
    </message>
    <message>
        <source>position and orientation</source>
        <translation>Position und Orientierung</translation>
    </message>
    <message>
        <source>Measured poses</source>
        <translation>Gemessene Posen</translation>
    </message>
    <message>
        <source>Readings of the joints and the place of the ball or tool that was measured there; typed or from a CSV file.</source>
        <translation>Ablesungen der Gelenke und der Ort der Kugel oder des Werkzeugs, der dort gemessen wurde; eingegeben oder aus einer CSV-Datei.</translation>
    </message>
    <message>
        <source>use</source>
        <translation>Verwendung</translation>
    </message>
    <message>
        <source>fit: taken into the fit. check: held back, to see how well the fit tells a pose that it has not seen. Empty: fit.</source>
        <translation>Anpassung: geht in die Anpassung ein. Prüfung: zurückgehalten, um zu sehen, wie gut die Anpassung eine ihr unbekannte Pose vorhersagt. Leer: Anpassung.</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>Anpassung</translation>
    </message>
    <message>
        <source>Reading of joint 1; empty: its zero reading.</source>
        <translation>Ablesung von Gelenk 1; leer: seine Nullablesung.</translation>
    </message>
    <message>
        <source>Reading of joint 2; empty: its zero reading.</source>
        <translation>Ablesung von Gelenk 2; leer: seine Nullablesung.</translation>
    </message>
    <message>
        <source>Reading of joint 3; empty: its zero reading.</source>
        <translation>Ablesung von Gelenk 3; leer: seine Nullablesung.</translation>
    </message>
    <message>
        <source>Reading of joint 4; empty: its zero reading.</source>
        <translation>Ablesung von Gelenk 4; leer: seine Nullablesung.</translation>
    </message>
    <message>
        <source>Reading of joint 5; empty: its zero reading.</source>
        <translation>Ablesung von Gelenk 5; leer: seine Nullablesung.</translation>
    </message>
    <message>
        <source>Reading of joint 6; empty: its zero reading.</source>
        <translation>Ablesung von Gelenk 6; leer: seine Nullablesung.</translation>
    </message>
    <message>
        <source>Reading of joint 7; empty: its zero reading.</source>
        <translation>Ablesung von Gelenk 7; leer: seine Nullablesung.</translation>
    </message>
    <message>
        <source>Measured coordinate x in the frame of the instrument&apos;s world.</source>
        <translation>Gemessene Koordinate x im Weltsystem des Messgeräts.</translation>
    </message>
    <message>
        <source>Measured coordinate y in the frame of the instrument&apos;s world.</source>
        <translation>Gemessene Koordinate y im Weltsystem des Messgeräts.</translation>
    </message>
    <message>
        <source>Measured coordinate z in the frame of the instrument&apos;s world.</source>
        <translation>Gemessene Koordinate z im Weltsystem des Messgeräts.</translation>
    </message>
    <message>
        <source>Measured orientation, R = Rz(gamma) Ry(beta) Rx(alpha), where poses are measured.</source>
        <translation>Gemessene Orientierung, R = Rz(gamma) Ry(beta) Rx(alpha), wo Posen gemessen werden.</translation>
    </message>
    <message>
        <source>Number of poses</source>
        <translation>Anzahl der Posen</translation>
    </message>
    <message>
        <source>Poses of the simulated experiment, spread over the range of all joints, always the same.</source>
        <translation>Posen des simulierten Experiments, über den Bereich aller Gelenke verteilt, immer dieselben.</translation>
    </message>
    <message>
        <source>From the zero reading on, as far as the limits of the joint allow.</source>
        <translation>Von der Nullablesung aus, so weit die Grenzen des Gelenks es erlauben.</translation>
    </message>
    <message>
        <source>Standard uncertainty of an orientation</source>
        <translation>Standardunsicherheit einer Orientierung</translation>
    </message>
    <message>
        <source>Of the rotation of the measured tool about each of its axes, independent.</source>
        <translation>Der Drehung des gemessenen Werkzeugs um jede seiner Achsen, unabhängig.</translation>
    </message>
    <message>
        <source>Ball or tool</source>
        <translation>Kugel oder Werkzeug</translation>
    </message>
    <message>
        <source>Where it is in the frame of the last link: exactly, or as a start of the fit.</source>
        <translation>Wo sie im System des letzten Glieds ist: genau oder als Startwert der Anpassung.</translation>
    </message>
    <message>
        <source>Place of the ball or tool is</source>
        <translation>Ort von Kugel oder Werkzeug ist</translation>
    </message>
    <message>
        <source>Found by the fit together with the parameters, or known.</source>
        <translation>Von der Anpassung zusammen mit den Parametern gefunden oder bekannt.</translation>
    </message>
    <message>
        <source>found by the fit</source>
        <translation>durch Anpassung gefunden</translation>
    </message>
    <message>
        <source>known exactly</source>
        <translation>genau bekannt</translation>
    </message>
    <message>
        <source>Place of the base is</source>
        <translation>Ort der Basis ist</translation>
    </message>
    <message>
        <source>Found by the fit: the instrument stands anywhere. Known: the base stands where the robot says it stands in the world.</source>
        <translation>Durch Anpassung gefunden: Das Messgerät steht irgendwo. Bekannt: Die Basis steht dort, wo sie laut Roboter in der Welt steht.</translation>
    </message>
    <message>
        <source>Parameters held</source>
        <translation>Festgehaltene Parameter</translation>
    </message>
    <message>
        <source>Parameters that stay nominal although the poses could tell them.</source>
        <translation>Parameter, die ihren Nennwert behalten, obwohl die Posen sie zeigen könnten.</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>A parameter by its symbol, such as d_3 or alpha_4.</source>
        <translation>Ein Parameter nach seinem Symbol, etwa d_3 oder alpha_4.</translation>
    </message>
    <message>
        <source>Channels of a force/moment sensor</source>
        <translation>Kanäle eines Kraft-/Momentensensors</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>The calibrated multi-axis sensor.</source>
        <translation>Der kalibrierte mehrachsige Sensor.</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Verwendung</translation>
    </message>
    <message>
        <source>Loads on the other axes</source>
        <translation>Lasten auf den anderen Achsen</translation>
    </message>
    <message>
        <source>What acts on the other axes while a channel is read. Unknown loads are rectangular between minus and plus the rated load, one and the same for all channels.</source>
        <translation>Was auf die anderen Achsen wirkt, während ein Kanal abgelesen wird. Unbekannte Lasten sind rechteckig zwischen minus und plus der Nennlast, ein und dieselbe für alle Kanäle.</translation>
    </message>
    <message>
        <source>none: one component alone</source>
        <translation>keine: eine Komponente allein</translation>
    </message>
    <message>
        <source>unknown on one axis, that with the largest interference</source>
        <translation>unbekannt auf der Achse mit größtem Übersprechen</translation>
    </message>
    <message>
        <source>unknown on all other axes</source>
        <translation>unbekannt auf allen anderen Achsen</translation>
    </message>
    <message>
        <source>Repeatability</source>
        <translation>Wiederholpräzision</translation>
    </message>
    <message>
        <source>The largest standard deviation of all steps, as in the paper, or that pooled over the steps, which has more degrees of freedom.</source>
        <translation>Die größte Standardabweichung aller Stufen wie in der Veröffentlichung oder die über die Stufen zusammengefasste, die mehr Freiheitsgrade hat.</translation>
    </message>
    <message>
        <source>largest of the steps</source>
        <translation>größte der Stufen</translation>
    </message>
    <message>
        <source>pooled over the steps</source>
        <translation>über die Stufen zusammengefasst</translation>
    </message>
    <message>
        <source>Type A in Monte Carlo</source>
        <translation>Typ A in Monte Carlo</translation>
    </message>
    <message>
        <source>Normal, with its degrees of freedom in the law of propagation, or a t-distribution (JCGM 101 6.4.9). With n = 3 the latter has no standard deviation: only coverage intervals then mean something.</source>
        <translation>Normal, mit ihren Freiheitsgraden im Fortpflanzungsgesetz, oder eine t-Verteilung (JCGM 101 6.4.9). Mit n = 3 hat letztere keine Standardabweichung: Nur Überdeckungsintervalle haben dann eine Bedeutung.</translation>
    </message>
    <message>
        <source>scaled and shifted t</source>
        <translation>skaliertes, verschobenes t</translation>
    </message>
    <message>
        <source>Coverage factor of the comparison</source>
        <translation>Erweiterungsfaktor des Vergleichs</translation>
    </message>
    <message>
        <source>k of the GUM&apos;s columns in the table beside the paper&apos;s.</source>
        <translation>k der GUM-Spalten in der Tabelle neben denen der Veröffentlichung.</translation>
    </message>
    <message>
        <source>Forces and moments by the calibration matrix</source>
        <translation>Kräfte und Momente aus der Kalibriermatrix</translation>
    </message>
    <message>
        <source>Cases</source>
        <translation>Fälle</translation>
    </message>
    <message>
        <source>Cases are given by</source>
        <translation>Fälle gegeben durch</translation>
    </message>
    <message>
        <source>Readings that were taken, or loads whose uncertainty is wanted.</source>
        <translation>Ablesungen, die genommen wurden, oder Lasten, deren Unsicherheit gesucht ist.</translation>
    </message>
    <message>
        <source>readings</source>
        <translation>Ablesungen</translation>
    </message>
    <message>
        <source>loads</source>
        <translation>Lasten</translation>
    </message>
    <message>
        <source>Net readings of all channels, the unloaded readings subtracted.</source>
        <translation>Nettoablesungen aller Kanäle, die unbelasteten Ablesungen abgezogen.</translation>
    </message>
    <message>
        <source>Names the case in results.</source>
        <translation>Benennt den Fall in den Ergebnissen.</translation>
    </message>
    <message>
        <source>Fx</source>
        <translation>Fx</translation>
    </message>
    <message>
        <source>Net reading of this channel.</source>
        <translation>Nettoablesung dieses Kanals.</translation>
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
        <translation>Lasten</translation>
    </message>
    <message>
        <source>Forces and moments that act together; the readings follow from the calibration matrix. An empty cell is zero.</source>
        <translation>Kräfte und Momente, die zusammen wirken; die Ablesungen folgen aus der Kalibriermatrix. Eine leere Zelle ist null.</translation>
    </message>
    <message>
        <source>Load on this axis.</source>
        <translation>Last auf dieser Achse.</translation>
    </message>
    <message>
        <source>Calibration matrix</source>
        <translation>Kalibriermatrix</translation>
    </message>
    <message>
        <source>Least squares through zero over the increasing readings: slopes alone, or with the squares of the loads.</source>
        <translation>Kleinste Quadrate durch null über die steigenden Ablesungen: nur Steigungen oder mit den Quadraten der Lasten.</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>with quadratic terms</source>
        <translation>mit quadratischen Gliedern</translation>
    </message>
    <message>
        <source>Repeatability of a reading</source>
        <translation>Wiederholpräzision einer Ablesung</translation>
    </message>
    <message>
        <source>The largest standard deviation of all steps, or that pooled over the steps.</source>
        <translation>Die größte Standardabweichung aller Stufen oder die über die Stufen zusammengefasste.</translation>
    </message>
    <message>
        <source>Normal, with its degrees of freedom in the law of propagation, or a t-distribution (JCGM 101 6.4.9), which has no standard deviation with n = 3.</source>
        <translation>Normal, mit ihren Freiheitsgraden im Fortpflanzungsgesetz, oder eine t-Verteilung (JCGM 101 6.4.9), die mit n = 3 keine Standardabweichung hat.</translation>
    </message>
    <message>
        <source>Hysteresis of a reading</source>
        <translation>Hysterese einer Ablesung</translation>
    </message>
    <message>
        <source>Rectangular over the width of the loop: in proportion to the load on the channel&apos;s axis, or the full width at any load.</source>
        <translation>Rechteckig über die Breite der Schleife: proportional zur Last auf der Achse des Kanals oder die volle Breite bei jeder Last.</translation>
    </message>
    <message>
        <source>in proportion to the load</source>
        <translation>proportional zur Last</translation>
    </message>
    <message>
        <source>full at any load</source>
        <translation>voll bei jeder Last</translation>
    </message>
    <message>
        <source>Measurement equation</source>
        <translation>Messgleichung</translation>
    </message>
    <message>
        <source>Equations</source>
        <translation>Gleichungen</translation>
    </message>
    <message>
        <source>symbol</source>
        <translation>Symbol</translation>
    </message>
    <message>
        <source>Name that an equation defines.</source>
        <translation>Name, den eine Gleichung definiert.</translation>
    </message>
    <message>
        <source>What it is, for tables and reports.</source>
        <translation>Was es ist, für Tabellen und Berichte.</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Unit of the result; empty: the SI unit that follows from the equations.</source>
        <translation>Einheit des Ergebnisses; leer: die SI-Einheit, die aus den Gleichungen folgt.</translation>
    </message>
    <message>
        <source>Measurands have coverage regions together; empty: measurand.</source>
        <translation>Messgrößen haben gemeinsame Überdeckungsbereiche; leer: Messgröße.</translation>
    </message>
    <message>
        <source>measurand</source>
        <translation>Messgröße</translation>
    </message>
    <message>
        <source>intermediate</source>
        <translation>Zwischengröße</translation>
    </message>
    <message>
        <source>group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Results of one group have a joint coverage region.</source>
        <translation>Ergebnisse einer Gruppe haben einen gemeinsamen Überdeckungsbereich.</translation>
    </message>
    <message>
        <source>Quantities</source>
        <translation>Größen</translation>
    </message>
    <message>
        <source>One row for each component of uncertainty. The first row of a symbol has its value and unit; further rows of the same symbol add components and have no value.</source>
        <translation>Eine Zeile je Unsicherheitskomponente. Die erste Zeile eines Symbols hat seinen Wert und seine Einheit; weitere Zeilen desselben Symbols fügen Komponenten hinzu und haben keinen Wert.</translation>
    </message>
    <message>
        <source>Name that the equations use: x_1, alpha_s.</source>
        <translation>Name, den die Gleichungen verwenden: x_1, alpha_s.</translation>
    </message>
    <message>
        <source>What it is, or what the component is.</source>
        <translation>Was es ist oder was die Komponente ist.</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Estimate, in the row&apos;s unit; empty where observations or limits give it.</source>
        <translation>Schätzwert, in der Einheit der Zeile; leer, wo Beobachtungen oder Grenzen ihn liefern.</translation>
    </message>
    <message>
        <source>stated as</source>
        <translation>angegeben als</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>Konstante</translation>
    </message>
    <message>
        <source>standard uncertainty</source>
        <translation>Standardunsicherheit</translation>
    </message>
    <message>
        <source>certificate, U and k</source>
        <translation>Kalibrierschein, U und k</translation>
    </message>
    <message>
        <source>certificate, U and p</source>
        <translation>Kalibrierschein, U und p</translation>
    </message>
    <message>
        <source>rectangular</source>
        <translation>rechteckig</translation>
    </message>
    <message>
        <source>limits from a to b</source>
        <translation>Grenzen von a bis b</translation>
    </message>
    <message>
        <source>limits inexactly known</source>
        <translation>Grenzen ungenau bekannt</translation>
    </message>
    <message>
        <source>trapezoidal</source>
        <translation>trapezförmig</translation>
    </message>
    <message>
        <source>triangular</source>
        <translation>dreieckig</translation>
    </message>
    <message>
        <source>arc sine</source>
        <translation>Arkussinus</translation>
    </message>
    <message>
        <source>resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>maximum permissible error</source>
        <translation>Fehlergrenze (MPE)</translation>
    </message>
    <message>
        <source>exponential</source>
        <translation>exponentiell</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>Zählereignisse</translation>
    </message>
    <message>
        <source>observations (Type A)</source>
        <translation>Beobachtungen (Typ A)</translation>
    </message>
    <message>
        <source>pooled observations (Type A)</source>
        <translation>zusammengefasste Beobachtungen (Typ A)</translation>
    </message>
    <message>
        <source>reading of an instrument</source>
        <translation>Ablesung eines Messgeräts</translation>
    </message>
    <message>
        <source>Second figure of the statement.</source>
        <translation>Zweite Zahl der Angabe.</translation>
    </message>
    <message>
        <source>Degrees of freedom; empty: infinite, or those of the observations.</source>
        <translation>Freiheitsgrade; leer: unendlich oder die der Beobachtungen.</translation>
    </message>
    <message>
        <source>Relative uncertainty of u instead of degrees of freedom (JCGM 100 G.3).</source>
        <translation>Relative Unsicherheit von u anstelle der Freiheitsgrade (JCGM 100 G.3).</translation>
    </message>
    <message>
        <source>source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Where the figure comes from: certificate, data sheet, handbook.</source>
        <translation>Woher die Zahl stammt: Kalibrierschein, Datenblatt, Handbuch.</translation>
    </message>
    <message>
        <source>instrument</source>
        <translation>Messgerät</translation>
    </message>
    <message>
        <source>Instrument of the project that reads the quantity, a distance.</source>
        <translation>Messgerät des Projekts, das die Größe, eine Distanz, abliest.</translation>
    </message>
    <message>
        <source>Observations</source>
        <translation>Beobachtungen</translation>
    </message>
    <message>
        <source>Repeated observations for Type A evaluations, typed, pasted or from a CSV file. Observations of several quantities with the same numbers were made together: their means are then correlated (JCGM 100 5.2.3).</source>
        <translation>Wiederholte Beobachtungen für Auswertungen vom Typ A, eingegeben, eingefügt oder aus einer CSV-Datei. Beobachtungen mehrerer Größen mit denselben Nummern wurden gemeinsam gemacht: Ihre Mittelwerte sind dann korreliert (JCGM 100 5.2.3).</translation>
    </message>
    <message>
        <source>quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Symbol of the quantity.</source>
        <translation>Symbol der Größe.</translation>
    </message>
    <message>
        <source>number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Number of the simultaneous observation; empty: the quantity was observed by itself.</source>
        <translation>Nummer der gleichzeitigen Beobachtung; leer: Die Größe wurde für sich beobachtet.</translation>
    </message>
    <message>
        <source>series</source>
        <translation>Reihe</translation>
    </message>
    <message>
        <source>Name of an earlier series of the same procedure, for a pooled standard deviation.</source>
        <translation>Name einer früheren Reihe desselben Verfahrens, für eine zusammengefasste Standardabweichung.</translation>
    </message>
    <message>
        <source>Observed value, in the unit of the quantity.</source>
        <translation>Beobachteter Wert, in der Einheit der Größe.</translation>
    </message>
    <message>
        <source>Means of observations</source>
        <translation>Mittelwerte von Beobachtungen</translation>
    </message>
    <message>
        <source>Distribution of a mean in Monte Carlo trials: Student t with the degrees of freedom of the observations (JCGM 101 6.4.9), or normal.</source>
        <translation>Verteilung eines Mittelwertes in den Monte-Carlo-Versuchen: Student-t mit den Freiheitsgraden der Beobachtungen (JCGM 101 6.4.9) oder normal.</translation>
    </message>
    <message>
        <source>Student t</source>
        <translation>Student-t</translation>
    </message>
    <message>
        <source>Calibration curve</source>
        <translation>Kalibrierkurve</translation>
    </message>
    <message>
        <source>Unit of x</source>
        <translation>Einheit von x</translation>
    </message>
    <message>
        <source>Unit in which x is given. A difference of temperatures, a correction of a thermometer too, is given in K.</source>
        <translation>Einheit, in der x angegeben ist. Eine Temperaturdifferenz, auch die Korrektion eines Thermometers, wird in K angegeben.</translation>
    </message>
    <message>
        <source>Unit of y</source>
        <translation>Einheit von y</translation>
    </message>
    <message>
        <source>Unit in which y is given. A difference of temperatures, a correction of a thermometer too, is given in K.</source>
        <translation>Einheit, in der y angegeben ist. Eine Temperaturdifferenz, auch die Korrektion eines Thermometers, wird in K angegeben.</translation>
    </message>
    <message>
        <source>Points of the calibration, typed, pasted or from a CSV file.</source>
        <translation>Punkte der Kalibrierung, eingegeben, eingefügt oder aus einer CSV-Datei.</translation>
    </message>
    <message>
        <source>Independent quantity, in its unit.</source>
        <translation>Unabhängige Größe, in ihrer Einheit.</translation>
    </message>
    <message>
        <source>Standard uncertainty of x; empty: none. Used with stated uncertainties.</source>
        <translation>Standardunsicherheit von x; leer: keine. Verwendet bei angegebenen Unsicherheiten.</translation>
    </message>
    <message>
        <source>Observed quantity, in its unit.</source>
        <translation>Beobachtete Größe, in ihrer Einheit.</translation>
    </message>
    <message>
        <source>Standard uncertainty of y. Used, and needed, with stated uncertainties.</source>
        <translation>Standardunsicherheit von y. Verwendet und nötig bei angegebenen Unsicherheiten.</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Degree</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>Of the polynomial: 1 is a straight line.</source>
        <translation>Des Polynoms: 1 ist eine Gerade.</translation>
    </message>
    <message>
        <source>Origin x_0</source>
        <translation>Ursprung x_0</translation>
    </message>
    <message>
        <source>The polynomial is one of x - x_0, in the unit of x. In the middle of the points the coefficients are hardly correlated.</source>
        <translation>Das Polynom ist eines von x - x_0, in der Einheit von x. In der Mitte der Punkte sind die Koeffizienten kaum korreliert.</translation>
    </message>
    <message>
        <source>Through the origin</source>
        <translation>Durch den Ursprung</translation>
    </message>
    <message>
        <source>No constant term: the curve is zero at x_0.</source>
        <translation>Kein konstantes Glied: Die Kurve ist bei x_0 null.</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Unsicherheit</translation>
    </message>
    <message>
        <source>From the scatter of the residuals about the curve (JCGM 100 H.3), or as stated for each point.</source>
        <translation>Aus der Streuung der Residuen um die Kurve (JCGM 100 H.3) oder wie für jeden Punkt angegeben.</translation>
    </message>
    <message>
        <source>from the residuals</source>
        <translation>aus den Residuen</translation>
    </message>
    <message>
        <source>as stated for x and y</source>
        <translation>wie für x und y angegeben</translation>
    </message>
    <message>
        <source>Use of the curve</source>
        <translation>Verwendung der Kurve</translation>
    </message>
    <message>
        <source>Where the value of the curve is wanted, with its uncertainty.</source>
        <translation>Wo der Wert der Kurve mit seiner Unsicherheit gesucht ist.</translation>
    </message>
    <message>
        <source>In the unit of x.</source>
        <translation>In der Einheit von x.</translation>
    </message>
    <message>
        <source>Inverse use</source>
        <translation>Umkehrung</translation>
    </message>
    <message>
        <source>Observed values of y whose x is wanted, with its uncertainty.</source>
        <translation>Beobachtete Werte von y, deren x mit seiner Unsicherheit gesucht ist.</translation>
    </message>
    <message>
        <source>Observed, in the unit of y.</source>
        <translation>Beobachtet, in der Einheit von y.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the observed y; empty: none beside that of the readings.</source>
        <translation>Standardunsicherheit des beobachteten y; leer: keine außer der der Ablesungen.</translation>
    </message>
    <message>
        <source>The observed y is the mean of so many readings, which scatter as the points of the calibration do. With the uncertainty from the residuals only.</source>
        <translation>Das beobachtete y ist der Mittelwert so vieler Ablesungen, die wie die Punkte der Kalibrierung streuen. Nur mit der Unsicherheit aus den Residuen.</translation>
    </message>
    <message>
        <source>near</source>
        <translation>nahe</translation>
    </message>
    <message>
        <source>Of several x that give this y, the one nearest to here, in the unit of x. Needed where the curve reaches y more than once between its points.</source>
        <translation>Von mehreren x, die dieses y ergeben, das hierzu nächste, in der Einheit von x. Nötig, wo die Kurve y zwischen ihren Punkten mehr als einmal erreicht.</translation>
    </message>
    <message>
        <source>Observations in groups</source>
        <translation>Beobachtungen in Gruppen</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>Symbol</translation>
    </message>
    <message>
        <source>Of the measured quantity.</source>
        <translation>Der gemessenen Größe.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>What is measured.</source>
        <translation>Was gemessen wird.</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>In which the observations are given.</source>
        <translation>In der die Beobachtungen angegeben sind.</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>Every observation, or mean and standard deviation of each group.</source>
        <translation>Jede Beobachtung oder Mittelwert und Standardabweichung jeder Gruppe.</translation>
    </message>
    <message>
        <source>observations</source>
        <translation>Beobachtungen</translation>
    </message>
    <message>
        <source>means and standard deviations</source>
        <translation>Mittelwerte und Standardabweichungen</translation>
    </message>
    <message>
        <source>Observations with the day, instrument or operator they belong to, typed, pasted or from a CSV file.</source>
        <translation>Beobachtungen mit dem Tag, Messgerät oder Bediener, zu dem sie gehören, eingegeben, eingefügt oder aus einer CSV-Datei.</translation>
    </message>
    <message>
        <source>Day, instrument or operator.</source>
        <translation>Tag, Messgerät oder Bediener.</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>Mean and experimental standard deviation of the observations of each group.</source>
        <translation>Mittelwert und empirische Standardabweichung der Beobachtungen jeder Gruppe.</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>Of the observations of the group, in the unit of the quantity.</source>
        <translation>Der Beobachtungen der Gruppe, in der Einheit der Größe.</translation>
    </message>
    <message>
        <source>Experimental standard deviation of a single observation of the group.</source>
        <translation>Empirische Standardabweichung einer einzelnen Beobachtung der Gruppe.</translation>
    </message>
    <message>
        <source>Number of observations in the group; empty: observations per group, as below.</source>
        <translation>Anzahl der Beobachtungen in der Gruppe; leer: Beobachtungen je Gruppe, wie unten.</translation>
    </message>
    <message>
        <source>Observations per group</source>
        <translation>Beobachtungen je Gruppe</translation>
    </message>
    <message>
        <source>Number of observations in each group whose row does not say it.</source>
        <translation>Anzahl der Beobachtungen in jeder Gruppe, deren Zeile sie nicht angibt.</translation>
    </message>
    <message>
        <source>Effect of the groups</source>
        <translation>Einfluss der Gruppen</translation>
    </message>
    <message>
        <source>Included: u of the mean of the groups&apos; means from their scatter. By components of variance: the same for groups of one size, else groups with more observations have more weight. Not included: all observations count as independent, which the F-test in the evaluation must allow.</source>
        <translation>Einbezogen: u des Mittelwertes der Gruppenmittelwerte aus deren Streuung. Nach Varianzkomponenten: bei gleich großen Gruppen dasselbe, sonst haben Gruppen mit mehr Beobachtungen mehr Gewicht. Nicht einbezogen: Alle Beobachtungen gelten als unabhängig, was der F-Test in der Auswertung zulassen muss.</translation>
    </message>
    <message>
        <source>included</source>
        <translation>einbezogen</translation>
    </message>
    <message>
        <source>by components of variance</source>
        <translation>nach Varianzkomponenten</translation>
    </message>
    <message>
        <source>not included</source>
        <translation>nicht einbezogen</translation>
    </message>
    <message>
        <source>Artefact with calibrated points</source>
        <translation>Prüfkörper mit kalibrierten Punkten</translation>
    </message>
    <message>
        <source>Artefact</source>
        <translation>Prüfkörper</translation>
    </message>
    <message>
        <source>Calibrated points</source>
        <translation>Kalibrierte Punkte</translation>
    </message>
    <message>
        <source>The artefact&apos;s points with their calibrated coordinates in the artefact&apos;s frame.</source>
        <translation>Die Punkte des Prüfkörpers mit ihren kalibrierten Koordinaten im System des Prüfkörpers.</translation>
    </message>
    <message>
        <source>Calibrated coordinate x.</source>
        <translation>Kalibrierte Koordinate x.</translation>
    </message>
    <message>
        <source>Calibrated coordinate y.</source>
        <translation>Kalibrierte Koordinate y.</translation>
    </message>
    <message>
        <source>Calibrated coordinate z.</source>
        <translation>Kalibrierte Koordinate z.</translation>
    </message>
    <message>
        <source>defines</source>
        <translation>definiert</translation>
    </message>
    <message>
        <source>Coordinates that define the frame (&quot;xyz&quot;, &quot;yz&quot;), when they are named by point.</source>
        <translation>Koordinaten, die das System definieren (&quot;xyz&quot;, &quot;yz&quot;), wenn sie punktweise benannt sind.</translation>
    </message>
    <message>
        <source>Evaluate from</source>
        <translation>Auswerten aus</translation>
    </message>
    <message>
        <source>Repeated measurements of the artefact, or the components of uncertainty as a report prints them (Table 1 of the paper).</source>
        <translation>Wiederholte Messungen des Prüfkörpers oder die Unsicherheitskomponenten, wie ein Bericht sie angibt (Tabelle 1 der Veröffentlichung).</translation>
    </message>
    <message>
        <source>components of uncertainty</source>
        <translation>Unsicherheitskomponenten</translation>
    </message>
    <message>
        <source>Measured coordinates in the artefact&apos;s frame: one row for each point and run, typed or from a CSV file.</source>
        <translation>Gemessene Koordinaten im System des Prüfkörpers: eine Zeile je Punkt und Lauf, eingegeben oder aus einer CSV-Datei.</translation>
    </message>
    <message>
        <source>Name of a calibrated point.</source>
        <translation>Name eines kalibrierten Punktes.</translation>
    </message>
    <message>
        <source>run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Indicated coordinate x.</source>
        <translation>Angezeigte Koordinate x.</translation>
    </message>
    <message>
        <source>Indicated coordinate y.</source>
        <translation>Angezeigte Koordinate y.</translation>
    </message>
    <message>
        <source>Indicated coordinate z.</source>
        <translation>Angezeigte Koordinate z.</translation>
    </message>
    <message>
        <source>Components of uncertainty</source>
        <translation>Unsicherheitskomponenten</translation>
    </message>
    <message>
        <source>One row for each coordinate, as Table 1 of the paper prints them.</source>
        <translation>Eine Zeile je Koordinate, wie Tabelle 1 der Veröffentlichung sie angibt.</translation>
    </message>
    <message>
        <source>coordinate</source>
        <translation>Koordinate</translation>
    </message>
    <message>
        <source>Coordinate of the row.</source>
        <translation>Koordinate der Zeile.</translation>
    </message>
    <message>
        <source>Calibration.</source>
        <translation>Kalibrierung.</translation>
    </message>
    <message>
        <source>Temperature.</source>
        <translation>Temperatur.</translation>
    </message>
    <message>
        <source>Variability: standard deviation of the errors of indication.</source>
        <translation>Streuung: Standardabweichung der Anzeigeabweichungen.</translation>
    </message>
    <message>
        <source>Bias: mean of the errors of indication.</source>
        <translation>Systematische Abweichung: Mittelwert der Anzeigeabweichungen.</translation>
    </message>
    <message>
        <source>Number of observations, where it is known; gives the degrees of freedom.</source>
        <translation>Anzahl der Beobachtungen, wo sie bekannt ist; liefert die Freiheitsgrade.</translation>
    </message>
    <message>
        <source>Coordinates that define the frame</source>
        <translation>Koordinaten, die das System definieren</translation>
    </message>
    <message>
        <source>Errors of these coordinates are zero by construction of the frame and are left out of the statistics.</source>
        <translation>Abweichungen dieser Koordinaten sind durch die Bildung des Systems null und bleiben in der Statistik unberücksichtigt.</translation>
    </message>
    <message>
        <source>first point x, y, z; second y, z; third z</source>
        <translation>erster Punkt x, y, z; zweiter y, z; dritter z</translation>
    </message>
    <message>
        <source>as the points&apos; column &apos;defines&apos; says</source>
        <translation>wie in der Spalte &apos;definiert&apos; der Punkte</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Systematic error of indication</source>
        <translation>Systematische Anzeigeabweichung</translation>
    </message>
    <message>
        <source>What becomes of the mean error b. The paper leaves it uncorrected and counts |b| as a standard uncertainty; JCGM 100 3.2.4 asks for a correction.</source>
        <translation>Was aus der mittleren Abweichung b wird. Die Veröffentlichung lässt sie unkorrigiert und zählt |b| als Standardunsicherheit; JCGM 100 3.2.4 verlangt eine Korrektion.</translation>
    </message>
    <message>
        <source>counts as a standard uncertainty (paper)</source>
        <translation>zählt als Standardunsicherheit (Veröffentlichung)</translation>
    </message>
    <message>
        <source>ignored</source>
        <translation>vernachlässigt</translation>
    </message>
    <message>
        <source>corrected, the uncertainty of the correction remains</source>
        <translation>korrigiert, die Unsicherheit der Korrektion bleibt</translation>
    </message>
    <message>
        <source>Systematic parts are common to all points</source>
        <translation>Systematische Anteile allen Punkten gemeinsam</translation>
    </message>
    <message>
        <source>Calibration, temperature and bias are drawn once for all points instead of independently for each, as the paper does.</source>
        <translation>Kalibrierung, Temperatur und systematische Abweichung werden einmal für alle Punkte gezogen statt unabhängig für jeden, wie es die Veröffentlichung tut.</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Standard uncertainty of calibration</source>
        <translation>Standardunsicherheit der Kalibrierung</translation>
    </message>
    <message>
        <source>Largest standard uncertainty of the calibrated values, from the certificate (U divided by its k).</source>
        <translation>Größte Standardunsicherheit der kalibrierten Werte, aus dem Kalibrierschein (U geteilt durch sein k).</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>Coefficient of thermal expansion</source>
        <translation>Wärmeausdehnungskoeffizient</translation>
    </message>
    <message>
        <source>Linear expansion of the artefact&apos;s material; aluminium has about 23e-6 1/K.</source>
        <translation>Längenausdehnung des Werkstoffs des Prüfkörpers; Aluminium hat etwa 23e-6 1/K.</translation>
    </message>
    <message>
        <source>Temperature of the artefact</source>
        <translation>Temperatur des Prüfkörpers</translation>
    </message>
    <message>
        <source>Whether indications are corrected to 20 °C with a measured temperature. If not, the largest deviation from 20 °C is a component of uncertainty.</source>
        <translation>Ob Anzeigen mit einer gemessenen Temperatur auf 20 °C korrigiert werden. Wenn nicht, ist die größte Abweichung von 20 °C eine Unsicherheitskomponente.</translation>
    </message>
    <message>
        <source>not corrected</source>
        <translation>nicht korrigiert</translation>
    </message>
    <message>
        <source>corrected to 20 °C</source>
        <translation>auf 20 °C korrigiert</translation>
    </message>
    <message>
        <source>Largest deviation from 20 °C, or U of the temperature</source>
        <translation>Größte Abweichung von 20 °C oder U der Temperatur</translation>
    </message>
    <message>
        <source>ΔT of Eqs 3 and 6: without correction the largest absolute deviation from 20 °C, with correction the expanded uncertainty of the measured temperature. Half-width of a rectangular distribution.</source>
        <translation>ΔT der Gl. 3 und 6: ohne Korrektion die größte absolute Abweichung von 20 °C, mit Korrektion die erweiterte Unsicherheit der gemessenen Temperatur. Halbbreite einer Rechteckverteilung.</translation>
    </message>
    <message>
        <source>Measured temperature</source>
        <translation>Gemessene Temperatur</translation>
    </message>
    <message>
        <source>Temperature of the artefact during the measurement; indications are divided by 1 + α (T − 20 °C).</source>
        <translation>Temperatur des Prüfkörpers während der Messung; Anzeigen werden durch 1 + α (T − 20 °C) geteilt.</translation>
    </message>
    <message>
        <source>Length for the thermal expansion</source>
        <translation>Länge für die Wärmeausdehnung</translation>
    </message>
    <message>
        <source>L_max of Eq 3. The paper&apos;s figures result with the largest distance between two points; its text says the largest value of the coordinate, which gives 0 for a flat artefact&apos;s z.</source>
        <translation>L_max der Gl. 3. Die Zahlen der Veröffentlichung ergeben sich mit dem größten Abstand zweier Punkte; ihr Text nennt den größten Wert der Koordinate, der für z eines flachen Prüfkörpers 0 ergibt.</translation>
    </message>
    <message>
        <source>largest distance between two points</source>
        <translation>größter Abstand zweier Punkte</translation>
    </message>
    <message>
        <source>largest value of the coordinate (text of Eq 3)</source>
        <translation>größter Wert der Koordinate (Text zu Gl. 3)</translation>
    </message>
    <message>
        <source>Length standard</source>
        <translation>Längennormal</translation>
    </message>
    <message>
        <source>Calibrated length</source>
        <translation>Kalibrierte Länge</translation>
    </message>
    <message>
        <source>Distance between the two nests, from the certificate. It should be like the largest distance between the points of both frames.</source>
        <translation>Abstand zwischen den beiden Aufnahmen, aus dem Kalibrierschein. Er sollte etwa dem größten Abstand zwischen den Punkten beider Systeme entsprechen.</translation>
    </message>
    <message>
        <source>Repeated measurements of the artefact, or the components of uncertainty as a report prints them (Table 2 of the paper).</source>
        <translation>Wiederholte Messungen des Prüfkörpers oder die Unsicherheitskomponenten, wie ein Bericht sie angibt (Tabelle 2 der Veröffentlichung).</translation>
    </message>
    <message>
        <source>Measured lengths: one row for each position and run, typed or from a CSV file. The paper proposes at least 14 positions of three runs.</source>
        <translation>Gemessene Längen: eine Zeile je Position und Lauf, eingegeben oder aus einer CSV-Datei. Die Veröffentlichung schlägt mindestens 14 Positionen mit drei Läufen vor.</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Where the standard stood.</source>
        <translation>Wo das Normal stand.</translation>
    </message>
    <message>
        <source>Indicated length.</source>
        <translation>Angezeigte Länge.</translation>
    </message>
    <message>
        <source>One row, as Table 2 of the paper prints it.</source>
        <translation>Eine Zeile, wie Tabelle 2 der Veröffentlichung sie angibt.</translation>
    </message>
    <message>
        <source>Uncertainty of a coordinate</source>
        <translation>Unsicherheit einer Koordinate</translation>
    </message>
    <message>
        <source>A length is the difference of two points, so u of a length is √2 times u of a coordinate. The paper uses the length&apos;s figure unchanged, which is cautious.</source>
        <translation>Eine Länge ist die Differenz zweier Punkte, daher ist u einer Länge √2-mal u einer Koordinate. Die Veröffentlichung verwendet die Zahl der Länge unverändert, was vorsichtig ist.</translation>
    </message>
    <message>
        <source>that of the length (paper)</source>
        <translation>die der Länge (Veröffentlichung)</translation>
    </message>
    <message>
        <source>that of the length divided by √2</source>
        <translation>die der Länge geteilt durch √2</translation>
    </message>
    <message>
        <source>Tracker, total station, camera or distance meter</source>
        <translation>Tracker, Totalstation, Kamera oder Distanzmesser</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Standpunkt</translation>
    </message>
    <message>
        <source>Where the instrument stands in the world frame: the point where its axes meet. x is the zero of the azimuth (the optical axis of a camera), z the vertical axis.</source>
        <translation>Wo das Messgerät im Weltsystem steht: der Punkt, in dem sich seine Achsen treffen. x ist der Nullpunkt des Azimuts (die optische Achse einer Kamera), z die Stehachse.</translation>
    </message>
    <message>
        <source>The angles are</source>
        <translation>Die Winkel sind</translation>
    </message>
    <message>
        <source>How the three angles of the station turn its axes.</source>
        <translation>Wie die drei Winkel des Standpunktes seine Achsen drehen.</translation>
    </message>
    <message>
        <source>α, β, γ: R = Rz(γ) Ry(β) Rx(α)</source>
        <translation>α, β, γ: R = Rz(γ) Ry(β) Rx(α)</translation>
    </message>
    <message>
        <source>ω, φ, κ: R = Rx(ω) Ry(φ) Rz(κ), photogrammetric</source>
        <translation>ω, φ, κ: R = Rx(ω) Ry(φ) Rz(κ), photogrammetrisch</translation>
    </message>
    <message>
        <source>What the instrument reads, and how it is drawn.</source>
        <translation>Was das Messgerät abliest und wie es gezeichnet wird.</translation>
    </message>
    <message>
        <source>total station: distance and two angles</source>
        <translation>Totalstation: Distanz und zwei Winkel</translation>
    </message>
    <message>
        <source>laser tracker: distance and two angles</source>
        <translation>Lasertracker: Distanz und zwei Winkel</translation>
    </message>
    <message>
        <source>laser scanner: distance and two angles</source>
        <translation>Laserscanner: Distanz und zwei Winkel</translation>
    </message>
    <message>
        <source>camera: two angles</source>
        <translation>Kamera: zwei Winkel</translation>
    </message>
    <message>
        <source>distance meter: distance only</source>
        <translation>Distanzmesser: nur Distanz</translation>
    </message>
    <message>
        <source>other: chosen readings</source>
        <translation>anderes: gewählte Ablesungen</translation>
    </message>
    <message>
        <source>Reads the distance</source>
        <translation>Liest die Distanz ab</translation>
    </message>
    <message>
        <source>Whether the sensor reads a distance.</source>
        <translation>Ob der Sensor eine Distanz abliest.</translation>
    </message>
    <message>
        <source>Reads the azimuth</source>
        <translation>Liest das Azimut ab</translation>
    </message>
    <message>
        <source>Whether the sensor reads a horizontal angle.</source>
        <translation>Ob der Sensor einen Horizontalwinkel abliest.</translation>
    </message>
    <message>
        <source>Reads the elevation</source>
        <translation>Liest den Höhenwinkel ab</translation>
    </message>
    <message>
        <source>Whether the sensor reads a vertical angle.</source>
        <translation>Ob der Sensor einen Vertikalwinkel abliest.</translation>
    </message>
    <message>
        <source>Specification</source>
        <translation>Spezifikation</translation>
    </message>
    <message>
        <source>Distance: constant part a</source>
        <translation>Distanz: konstanter Anteil a</translation>
    </message>
    <message>
        <source>Part of the distance&apos;s figure that does not depend on the distance.</source>
        <translation>Anteil der Zahl für die Distanz, der nicht von der Distanz abhängt.</translation>
    </message>
    <message>
        <source>Distance: part b per length</source>
        <translation>Distanz: Anteil b je Länge</translation>
    </message>
    <message>
        <source>Part of the distance&apos;s figure in proportion to the distance.</source>
        <translation>Anteil der Zahl für die Distanz, der zur Distanz proportional ist.</translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation>Azimut</translation>
    </message>
    <message>
        <source>Figure for the horizontal angle.</source>
        <translation>Zahl für den Horizontalwinkel.</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Höhenwinkel</translation>
    </message>
    <message>
        <source>Figure for the vertical angle.</source>
        <translation>Zahl für den Vertikalwinkel.</translation>
    </message>
    <message>
        <source>Angles: constant part across</source>
        <translation>Winkel: konstanter Anteil quer</translation>
    </message>
    <message>
        <source>Part of both angles&apos; figures that is a length across the line of sight, as trackers state it (15 µm + 6 µm/m); an angle&apos;s figure is this over the distance plus its own.</source>
        <translation>Anteil der Zahlen beider Winkel, der eine Länge quer zur Ziellinie ist, wie Tracker ihn angeben (15 µm + 6 µm/m); die Zahl eines Winkels ist dieser Anteil geteilt durch die Distanz plus sein eigener.</translation>
    </message>
    <message>
        <source>The figures are</source>
        <translation>Die Zahlen sind</translation>
    </message>
    <message>
        <source>What the data sheet states: a standard uncertainty, an expanded one, or a limit that is not exceeded (maximum permissible error).</source>
        <translation>Was das Datenblatt angibt: eine Standardunsicherheit, eine erweiterte Unsicherheit oder eine Grenze, die nicht überschritten wird (Fehlergrenze).</translation>
    </message>
    <message>
        <source>standard uncertainty (normal)</source>
        <translation>Standardunsicherheit (normal)</translation>
    </message>
    <message>
        <source>expanded uncertainty, k = 2 (normal)</source>
        <translation>erweiterte Unsicherheit, k = 2 (normal)</translation>
    </message>
    <message>
        <source>limit (MPE), rectangular: divided by √3</source>
        <translation>Grenze (MPE), rechteckig: geteilt durch √3</translation>
    </message>
    <message>
        <source>limit (MPE), triangular: divided by √6</source>
        <translation>Grenze (MPE), dreieckig: geteilt durch √6</translation>
    </message>
    <message>
        <source>limit (MPE), arc sine: divided by √2</source>
        <translation>Grenze (MPE), Arkussinus: geteilt durch √2</translation>
    </message>
    <message>
        <source>Range and field of view</source>
        <translation>Reichweite und Sichtfeld</translation>
    </message>
    <message>
        <source>Shortest distance</source>
        <translation>Kürzeste Distanz</translation>
    </message>
    <message>
        <source>Targets nearer than this are not measured.</source>
        <translation>Zielpunkte, die näher liegen, werden nicht gemessen.</translation>
    </message>
    <message>
        <source>Longest distance</source>
        <translation>Längste Distanz</translation>
    </message>
    <message>
        <source>Targets farther than this are not measured; empty: no limit.</source>
        <translation>Zielpunkte, die weiter entfernt liegen, werden nicht gemessen; leer: keine Grenze.</translation>
    </message>
    <message>
        <source>Horizontal field of view</source>
        <translation>Horizontales Sichtfeld</translation>
    </message>
    <message>
        <source>Full angle, half of it to either side of the sensor&apos;s x-axis; empty: all round.</source>
        <translation>Voller Winkel, je zur Hälfte auf beiden Seiten der x-Achse des Sensors; leer: rundum.</translation>
    </message>
    <message>
        <source>Vertical field of view</source>
        <translation>Vertikales Sichtfeld</translation>
    </message>
    <message>
        <source>Full angle, half of it above the sensor&apos;s xy-plane and half below; empty: no limit.</source>
        <translation>Voller Winkel, je zur Hälfte über und unter der xy-Ebene des Sensors; leer: keine Grenze.</translation>
    </message>
    <message>
        <source>Shared by all readings</source>
        <translation>Allen Ablesungen gemeinsam</translation>
    </message>
    <message>
        <source>Scale of distances</source>
        <translation>Maßstab der Distanzen</translation>
    </message>
    <message>
        <source>Standard uncertainty of the scale, which all distances share: wavelength, refractive index, temperature of a scale.</source>
        <translation>Standardunsicherheit des Maßstabs, den alle Distanzen gemeinsam haben: Wellenlänge, Brechzahl, Temperatur eines Maßstabs.</translation>
    </message>
    <message>
        <source>Zero offset of distances</source>
        <translation>Nullpunktabweichung der Distanzen</translation>
    </message>
    <message>
        <source>Standard uncertainty of the constant offset of all distances: home position, reflector.</source>
        <translation>Standardunsicherheit der konstanten Abweichung aller Distanzen: Home-Position, Reflektor.</translation>
    </message>
    <message>
        <source>Index of the elevation</source>
        <translation>Index des Höhenwinkels</translation>
    </message>
    <message>
        <source>Standard uncertainty of the zero of the vertical circle.</source>
        <translation>Standardunsicherheit des Nullpunkts des Vertikalkreises.</translation>
    </message>
    <message>
        <source>Collimation</source>
        <translation>Zielachsenabweichung</translation>
    </message>
    <message>
        <source>Standard uncertainty of the angle between beam and tilting axis off square: the azimuth changes by it over the cosine of the elevation.</source>
        <translation>Standardunsicherheit der Abweichung vom rechten Winkel zwischen Strahl und Kippachse: Das Azimut ändert sich um sie geteilt durch den Kosinus des Höhenwinkels.</translation>
    </message>
    <message>
        <source>Squareness of the axes</source>
        <translation>Rechtwinkligkeit der Achsen</translation>
    </message>
    <message>
        <source>Standard uncertainty of the angle between the two axes off square: the azimuth changes by it times the tangent of the elevation.</source>
        <translation>Standardunsicherheit der Abweichung vom rechten Winkel zwischen den beiden Achsen: Das Azimut ändert sich um sie mal dem Tangens des Höhenwinkels.</translation>
    </message>
    <message>
        <source>Offset of the beam</source>
        <translation>Versatz des Strahls</translation>
    </message>
    <message>
        <source>Standard uncertainty of the distance by which the beam misses the vertical axis sideways: the azimuth changes by it over the horizontal distance.</source>
        <translation>Standardunsicherheit des Abstands, um den der Strahl die Stehachse seitlich verfehlt: Das Azimut ändert sich um ihn geteilt durch die Horizontaldistanz.</translation>
    </message>
    <message>
        <source>Coefficient of refraction</source>
        <translation>Refraktionskoeffizient</translation>
    </message>
    <message>
        <source>Standard uncertainty of k: the elevation changes by k L/(2 × 6371 km) over a distance L.</source>
        <translation>Standardunsicherheit von k: Der Höhenwinkel ändert sich über eine Distanz L um k L/(2 × 6371 km).</translation>
    </message>
    <message>
        <source>The distribution of what all readings share; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation>Die Verteilung dessen, was alle Ablesungen gemeinsam haben; angegeben ist ihre Standardunsicherheit, gleich welcher Form.</translation>
    </message>
    <message>
        <source>Uncertainty of the station</source>
        <translation>Unsicherheit des Standpunktes</translation>
    </message>
    <message>
        <source>position x</source>
        <translation>Position x</translation>
    </message>
    <message>
        <source>Standard uncertainty of this coordinate of the station, shared by everything measured from it.</source>
        <translation>Standardunsicherheit dieser Koordinate des Standpunktes, allem gemeinsam, was von ihm aus gemessen wird.</translation>
    </message>
    <message>
        <source>position y</source>
        <translation>Position y</translation>
    </message>
    <message>
        <source>position z</source>
        <translation>Position z</translation>
    </message>
    <message>
        <source>rotation about x</source>
        <translation>Drehung um x</translation>
    </message>
    <message>
        <source>rotation about y</source>
        <translation>Drehung um y</translation>
    </message>
    <message>
        <source>rotation about z</source>
        <translation>Drehung um z</translation>
    </message>
    <message>
        <source>The distribution of the coordinates of the station; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation>Die Verteilung der Koordinaten des Standpunktes; angegeben ist ihre Standardunsicherheit, gleich welcher Form.</translation>
    </message>
    <message>
        <source>Correlation of the station&apos;s coordinates</source>
        <translation>Korrelation der Standpunktkoordinaten</translation>
    </message>
    <message>
        <source>Correlation coefficients from the adjustment that located the station; pairs left out are uncorrelated.</source>
        <translation>Korrelationskoeffizienten aus der Ausgleichung, die den Standpunkt bestimmt hat; weggelassene Paare sind unkorreliert.</translation>
    </message>
    <message>
        <source>first</source>
        <translation>erste</translation>
    </message>
    <message>
        <source>A coordinate of the station.</source>
        <translation>Eine Koordinate des Standpunktes.</translation>
    </message>
    <message>
        <source>second</source>
        <translation>zweite</translation>
    </message>
    <message>
        <source>Correlation coefficient.</source>
        <translation>Korrelationskoeffizient.</translation>
    </message>
    <message>
        <source>Network of sensors</source>
        <translation>Netz aus Sensoren</translation>
    </message>
    <message>
        <source>What the weights of the readings account for. With the stations, all points of one analysis are estimated together.</source>
        <translation>Was die Gewichte der Ablesungen berücksichtigen. Mit den Standpunkten werden alle Punkte einer Analyse gemeinsam geschätzt.</translation>
    </message>
    <message>
        <source>readings and stations, all points at once</source>
        <translation>Ablesungen und Standpunkte, alle Punkte zugleich</translation>
    </message>
    <message>
        <source>readings alone, each point by itself</source>
        <translation>nur Ablesungen, jeder Punkt für sich</translation>
    </message>
    <message>
        <source>Specification of a measured point</source>
        <translation>Spezifikation eines gemessenen Punktes</translation>
    </message>
    <message>
        <source>Figure of the data sheet</source>
        <translation>Zahl des Datenblatts</translation>
    </message>
    <message>
        <source>The uncertainty or limit that the manufacturer states, the same for x, y and z.</source>
        <translation>Die Unsicherheit oder Grenze, die der Hersteller angibt, gleich für x, y und z.</translation>
    </message>
    <message>
        <source>The figure applies to</source>
        <translation>Die Zahl gilt für</translation>
    </message>
    <message>
        <source>A coordinate of a point, or a length between two points; a length is the difference of two points, so a coordinate has 1/√2 of it.</source>
        <translation>Eine Koordinate eines Punktes oder eine Länge zwischen zwei Punkten; eine Länge ist die Differenz zweier Punkte, daher hat eine Koordinate davon 1/√2.</translation>
    </message>
    <message>
        <source>a coordinate</source>
        <translation>eine Koordinate</translation>
    </message>
    <message>
        <source>a length between two points</source>
        <translation>eine Länge zwischen zwei Punkten</translation>
    </message>
    <message>
        <source>Telescopic ballbars (multilateration)</source>
        <translation>Teleskopische Kugelstäbe (Multilateration)</translation>
    </message>
    <message>
        <source>Supports</source>
        <translation>Auflager</translation>
    </message>
    <message>
        <source>Support 1 to support 2</source>
        <translation>Auflager 1 bis Auflager 2</translation>
    </message>
    <message>
        <source>Measured length between supports 1 and 2.</source>
        <translation>Gemessene Länge zwischen den Auflagern 1 und 2.</translation>
    </message>
    <message>
        <source>Support 1 to support 3</source>
        <translation>Auflager 1 bis Auflager 3</translation>
    </message>
    <message>
        <source>Measured length between supports 1 and 3.</source>
        <translation>Gemessene Länge zwischen den Auflagern 1 und 3.</translation>
    </message>
    <message>
        <source>Support 2 to support 3</source>
        <translation>Auflager 2 bis Auflager 3</translation>
    </message>
    <message>
        <source>Measured length between supports 2 and 3.</source>
        <translation>Gemessene Länge zwischen den Auflagern 2 und 3.</translation>
    </message>
    <message>
        <source>Further supports</source>
        <translation>Weitere Auflager</translation>
    </message>
    <message>
        <source>Supports 4, 5 ...: their lengths to the first three, and their height above the plane of these. More than three lengths are adjusted by least squares.</source>
        <translation>Auflager 4, 5 ...: ihre Längen zu den ersten drei und ihre Höhe über deren Ebene. Mehr als drei Längen werden nach kleinsten Quadraten ausgeglichen.</translation>
    </message>
    <message>
        <source>Length to this support.</source>
        <translation>Länge zu diesem Auflager.</translation>
    </message>
    <message>
        <source>Height above the first three supports.</source>
        <translation>Höhe über den ersten drei Auflagern.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the height.</source>
        <translation>Standardunsicherheit der Höhe.</translation>
    </message>
    <message>
        <source>The ball is</source>
        <translation>Die Kugel ist</translation>
    </message>
    <message>
        <source>Three lengths meet in two points, mirror images in the plane of the supports: on which side of it the ball is (sign of the root of Eq 3).</source>
        <translation>Drei Längen treffen sich in zwei Punkten, Spiegelbildern an der Ebene der Auflager: auf welcher Seite davon die Kugel ist (Vorzeichen der Wurzel in Gl. 3).</translation>
    </message>
    <message>
        <source>on the side of +z</source>
        <translation>auf der Seite von +z</translation>
    </message>
    <message>
        <source>on the side of −z</source>
        <translation>auf der Seite von −z</translation>
    </message>
    <message>
        <source>Placement</source>
        <translation>Aufstellung</translation>
    </message>
    <message>
        <source>Place in the robot&apos;s frame</source>
        <translation>Ort im Robotersystem</translation>
    </message>
    <message>
        <source>Where the instrument&apos;s frame is in the robot&apos;s: origin in support 1, x towards support 2, z normal to the plane of the first three supports, on the left of the way 1-2-3.</source>
        <translation>Wo das System des Messgeräts in dem des Roboters ist: Ursprung im Auflager 1, x zum Auflager 2 hin, z normal zur Ebene der ersten drei Auflager, links vom Weg 1-2-3.</translation>
    </message>
    <message>
        <source>Uncertainty of a length</source>
        <translation>Unsicherheit einer Länge</translation>
    </message>
    <message>
        <source>To the ball: constant part a</source>
        <translation>Zur Kugel: konstanter Anteil a</translation>
    </message>
    <message>
        <source>Figure for one reading of a bar to the ball, the part that does not depend on the length.</source>
        <translation>Zahl für eine Ablesung eines Stabs zur Kugel, der Anteil, der nicht von der Länge abhängt.</translation>
    </message>
    <message>
        <source>To the ball: part b per length</source>
        <translation>Zur Kugel: Anteil b je Länge</translation>
    </message>
    <message>
        <source>Figure for one reading of a bar to the ball, the part in proportion to the length.</source>
        <translation>Zahl für eine Ablesung eines Stabs zur Kugel, der zur Länge proportionale Anteil.</translation>
    </message>
    <message>
        <source>Between supports: constant part a</source>
        <translation>Zwischen Auflagern: konstanter Anteil a</translation>
    </message>
    <message>
        <source>Figure for a length between two supports, which one measurement gives for all points: the part that does not depend on the length.</source>
        <translation>Zahl für eine Länge zwischen zwei Auflagern, die eine Messung für alle Punkte liefert: der Anteil, der nicht von der Länge abhängt.</translation>
    </message>
    <message>
        <source>Between supports: part b per length</source>
        <translation>Zwischen Auflagern: Anteil b je Länge</translation>
    </message>
    <message>
        <source>Figure for a length between two supports, the part in proportion to the length.</source>
        <translation>Zahl für eine Länge zwischen zwei Auflagern, der zur Länge proportionale Anteil.</translation>
    </message>
    <message>
        <source>Shared by all lengths</source>
        <translation>Allen Längen gemeinsam</translation>
    </message>
    <message>
        <source>Scale of all lengths</source>
        <translation>Maßstab aller Längen</translation>
    </message>
    <message>
        <source>Standard uncertainty of the scale that all lengths share: wavelength, refractive index.</source>
        <translation>Standardunsicherheit des Maßstabs, den alle Längen gemeinsam haben: Wellenlänge, Brechzahl.</translation>
    </message>
    <message>
        <source>Constant of each bar</source>
        <translation>Konstante jedes Stabs</translation>
    </message>
    <message>
        <source>Standard uncertainty of the constant of a bar, the same in all its readings to the ball.</source>
        <translation>Standardunsicherheit der Konstante eines Stabs, dieselbe in allen seinen Ablesungen zur Kugel.</translation>
    </message>
    <message>
        <source>The distribution of scale and constants; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation>Die Verteilung von Maßstab und Konstanten; angegeben ist ihre Standardunsicherheit, gleich welcher Form.</translation>
    </message>
    <message>
        <source>Robot: repeatability of a pose</source>
        <translation>Roboter: Wiederholpräzision einer Pose</translation>
    </message>
    <message>
        <source>Positioning</source>
        <translation>Positionierung</translation>
    </message>
    <message>
        <source>The robot&apos;s figure for the scatter of a position that it is sent to again and again.</source>
        <translation>Die Zahl des Roboters für die Streuung einer Position, die er immer wieder anfährt.</translation>
    </message>
    <message>
        <source>The figure is</source>
        <translation>Die Zahl ist</translation>
    </message>
    <message>
        <source>A largest distance from the mean position, or RP of ISO 9283: the mean distance plus three times its standard deviation. A normal law has no largest distance, so its figure is always RP.</source>
        <translation>Ein größter Abstand von der mittleren Position oder RP nach ISO 9283: der mittlere Abstand plus das Dreifache seiner Standardabweichung. Eine Normalverteilung hat keinen größten Abstand, ihre Zahl ist daher immer RP.</translation>
    </message>
    <message>
        <source>the largest distance r</source>
        <translation>der größte Abstand r</translation>
    </message>
    <message>
        <source>RP of ISO 9283: mean + 3 s</source>
        <translation>RP nach ISO 9283: Mittelwert + 3 s</translation>
    </message>
    <message>
        <source>Deviation of a position</source>
        <translation>Abweichung einer Position</translation>
    </message>
    <message>
        <source>How the distance from the mean position is distributed; all directions are equally probable.</source>
        <translation>Wie der Abstand von der mittleren Position verteilt ist; alle Richtungen sind gleich wahrscheinlich.</translation>
    </message>
    <message>
        <source>rectangular in [0, r] in a random direction</source>
        <translation>rechteckig in [0, r] in zufälliger Richtung</translation>
    </message>
    <message>
        <source>anywhere in a ball of radius r</source>
        <translation>irgendwo in einer Kugel mit Radius r</translation>
    </message>
    <message>
        <source>always r, in a random direction</source>
        <translation>immer r, in zufälliger Richtung</translation>
    </message>
    <message>
        <source>normal along each axis</source>
        <translation>normal entlang jeder Achse</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Orientierung</translation>
    </message>
    <message>
        <source>Figure for the scatter of the orientation about each axis of the flange; 0: none.</source>
        <translation>Zahl für die Streuung der Orientierung um jede Achse des Flansches; 0: keine.</translation>
    </message>
    <message>
        <source>The angle is</source>
        <translation>Der Winkel ist</translation>
    </message>
    <message>
        <source>A standard uncertainty, RP of ISO 9283 for an angle (three times its standard deviation), or a limit that is not exceeded.</source>
        <translation>Eine Standardunsicherheit, RP nach ISO 9283 für einen Winkel (das Dreifache seiner Standardabweichung) oder eine Grenze, die nicht überschritten wird.</translation>
    </message>
    <message>
        <source>RP of ISO 9283: ± 3 s (normal)</source>
        <translation>RP nach ISO 9283: ± 3 s (normal)</translation>
    </message>
    <message>
        <source>limit, rectangular: divided by √3</source>
        <translation>Grenze, rechteckig: geteilt durch √3</translation>
    </message>
    <message>
        <source>Serial robot</source>
        <translation>Serieller Roboter</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Geometrie</translation>
    </message>
    <message>
        <source>Convention</source>
        <translation>Konvention</translation>
    </message>
    <message>
        <source>How the parameters of a row lead from one joint&apos;s frame to the next.</source>
        <translation>Wie die Parameter einer Zeile vom System eines Gelenks zum nächsten führen.</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>One row for each joint from the base to the tool, in the chosen convention.</source>
        <translation>Eine Zeile je Gelenk von der Basis zum Werkzeug, in der gewählten Konvention.</translation>
    </message>
    <message>
        <source>Joint angle where the reading is the zero reading.</source>
        <translation>Gelenkwinkel, wo die Ablesung die Nullablesung ist.</translation>
    </message>
    <message>
        <source>Offset along the joint&apos;s axis.</source>
        <translation>Versatz entlang der Achse des Gelenks.</translation>
    </message>
    <message>
        <source>Length of the common perpendicular.</source>
        <translation>Länge der gemeinsamen Normale.</translation>
    </message>
    <message>
        <source>Twist about x between two axes.</source>
        <translation>Verdrehung um x zwischen zwei Achsen.</translation>
    </message>
    <message>
        <source>Twist about y, of a joint whose axis is parallel to the next: d is then 0 by definition. Empty: the axes are not parallel.</source>
        <translation>Verdrehung um y eines Gelenks, dessen Achse zur nächsten parallel ist: d ist dann definitionsgemäß 0. Leer: Die Achsen sind nicht parallel.</translation>
    </message>
    <message>
        <source>Reading of the joint at which theta holds; empty: 0.</source>
        <translation>Ablesung des Gelenks, bei der theta gilt; leer: 0.</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Whether the joint angle grows or falls with the reading; empty: grows.</source>
        <translation>Ob der Gelenkwinkel mit der Ablesung wächst oder fällt; leer: wächst.</translation>
    </message>
    <message>
        <source>with the reading</source>
        <translation>mit der Ablesung</translation>
    </message>
    <message>
        <source>against the reading</source>
        <translation>gegen die Ablesung</translation>
    </message>
    <message>
        <source>Lowest reading; empty: no limit.</source>
        <translation>Kleinste Ablesung; leer: keine Grenze.</translation>
    </message>
    <message>
        <source>Highest reading; empty: no limit.</source>
        <translation>Größte Ablesung; leer: keine Grenze.</translation>
    </message>
    <message>
        <source>Standard uncertainty of a reading by the joint&apos;s encoder, drawn anew at each pose.</source>
        <translation>Standardunsicherheit einer Ablesung durch den Drehgeber des Gelenks, in jeder Pose neu gezogen.</translation>
    </message>
    <message>
        <source>Standard uncertainty by which the joint comes back to a reading, drawn anew at each pose.</source>
        <translation>Standardunsicherheit, mit der das Gelenk zu einer Ablesung zurückkehrt, in jeder Pose neu gezogen.</translation>
    </message>
    <message>
        <source>type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>A joint that turns has readings q, which add to theta; one that slides has readings s, which add to d. Empty: it turns.</source>
        <translation>Ein Gelenk, das dreht, hat Ablesungen q, die zu theta addiert werden; eines, das schiebt, hat Ablesungen s, die zu d addiert werden. Leer: Es dreht.</translation>
    </message>
    <message>
        <source>turns about its axis</source>
        <translation>dreht um seine Achse</translation>
    </message>
    <message>
        <source>slides along its axis</source>
        <translation>schiebt entlang seiner Achse</translation>
    </message>
    <message>
        <source>Reading of a sliding joint at which d holds; empty: 0.</source>
        <translation>Ablesung eines Schubgelenks, bei der d gilt; leer: 0.</translation>
    </message>
    <message>
        <source>Lowest reading of a sliding joint; empty: no limit.</source>
        <translation>Kleinste Ablesung eines Schubgelenks; leer: keine Grenze.</translation>
    </message>
    <message>
        <source>Highest reading of a sliding joint; empty: no limit.</source>
        <translation>Größte Ablesung eines Schubgelenks; leer: keine Grenze.</translation>
    </message>
    <message>
        <source>Standard uncertainty of a reading of a sliding joint by its scale, drawn anew at each pose.</source>
        <translation>Standardunsicherheit einer Ablesung eines Schubgelenks durch seinen Maßstab, in jeder Pose neu gezogen.</translation>
    </message>
    <message>
        <source>Standard uncertainty by which a sliding joint comes back to a reading, drawn anew at each pose.</source>
        <translation>Standardunsicherheit, mit der ein Schubgelenk zu einer Ablesung zurückkehrt, in jeder Pose neu gezogen.</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>Where frame 0 of the robot stands in the world.</source>
        <translation>Wo das System 0 des Roboters in der Welt steht.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Where the tool is in the frame of the last link.</source>
        <translation>Wo das Werkzeug im System des letzten Glieds ist.</translation>
    </message>
    <message>
        <source>Standard uncertainties of the parameters by source. A row for a joint and a source; components of one parameter combine in quadrature.</source>
        <translation>Standardunsicherheiten der Parameter nach Quelle. Eine Zeile je Gelenk und Quelle; Komponenten eines Parameters werden quadratisch addiert.</translation>
    </message>
    <message>
        <source>Where the figures come from: repeatability, sampling, range, certificate ...</source>
        <translation>Woher die Zahlen stammen: Wiederholpräzision, Stichprobe, Bereich, Kalibrierschein ...</translation>
    </message>
    <message>
        <source>Number of the joint; empty: all joints, each with a deviation of its own.</source>
        <translation>Nummer des Gelenks; leer: alle Gelenke, jedes mit eigener Abweichung.</translation>
    </message>
    <message>
        <source>Standard uncertainty of theta from this source; empty: none.</source>
        <translation>Standardunsicherheit von theta aus dieser Quelle; leer: keine.</translation>
    </message>
    <message>
        <source>Standard uncertainty of d from this source; empty: none.</source>
        <translation>Standardunsicherheit von d aus dieser Quelle; leer: keine.</translation>
    </message>
    <message>
        <source>Standard uncertainty of a from this source; empty: none.</source>
        <translation>Standardunsicherheit von a aus dieser Quelle; leer: keine.</translation>
    </message>
    <message>
        <source>Standard uncertainty of alpha from this source; empty: none.</source>
        <translation>Standardunsicherheit von alpha aus dieser Quelle; leer: keine.</translation>
    </message>
    <message>
        <source>Standard uncertainty of beta from this source; empty: none.</source>
        <translation>Standardunsicherheit von beta aus dieser Quelle; leer: keine.</translation>
    </message>
    <message>
        <source>Degrees of freedom of the figures; empty: infinitely many.</source>
        <translation>Freiheitsgrade der Zahlen; leer: unendlich viele.</translation>
    </message>
    <message>
        <source>Form of the distribution with this standard uncertainty; empty: normal.</source>
        <translation>Form der Verteilung mit dieser Standardunsicherheit; leer: normal.</translation>
    </message>
    <message>
        <source>Correlation coefficients from the identification; pairs left out are uncorrelated. A correlated parameter has one component.</source>
        <translation>Korrelationskoeffizienten aus der Identifikation; weggelassene Paare sind unkorreliert. Ein korrelierter Parameter hat eine Komponente.</translation>
    </message>
    <message>
        <source>Tool, position</source>
        <translation>Werkzeug, Position</translation>
    </message>
    <message>
        <source>Standard uncertainty of each coordinate of the tool in the frame of the last link.</source>
        <translation>Standardunsicherheit jeder Koordinate des Werkzeugs im System des letzten Glieds.</translation>
    </message>
    <message>
        <source>Tool, orientation</source>
        <translation>Werkzeug, Orientierung</translation>
    </message>
    <message>
        <source>Standard uncertainty of each rotation of the tool about its own axes.</source>
        <translation>Standardunsicherheit jeder Drehung des Werkzeugs um seine eigenen Achsen.</translation>
    </message>
    <message>
        <source>Force/moment calibration machine</source>
        <translation>Kraft-/Momenten-Kalibriermaschine</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Kalibrierschein</translation>
    </message>
    <message>
        <source>Uncertainty of its loads</source>
        <translation>Unsicherheit der Lasten</translation>
    </message>
    <message>
        <source>One row for each axis that the machine loads: the relative expanded uncertainty of its certificate and the coverage factor.</source>
        <translation>Eine Zeile je Achse, die die Maschine belastet: die relative erweiterte Unsicherheit ihres Kalibrierscheins und der Erweiterungsfaktor.</translation>
    </message>
    <message>
        <source>Force or moment.</source>
        <translation>Kraft oder Moment.</translation>
    </message>
    <message>
        <source>Relative expanded uncertainty of the load: a ratio, not %.</source>
        <translation>Relative erweiterte Unsicherheit der Last: ein Verhältnis, nicht %.</translation>
    </message>
    <message>
        <source>Coverage factor; empty: 2.</source>
        <translation>Erweiterungsfaktor; leer: 2.</translation>
    </message>
    <message>
        <source>Multi-axis force/moment sensor</source>
        <translation>Mehrachsiger Kraft-/Momentensensor</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Kanäle</translation>
    </message>
    <message>
        <source>The forces and moments that the sensor measures, with their rated loads.</source>
        <translation>Die Kräfte und Momente, die der Sensor misst, mit ihren Nennlasten.</translation>
    </message>
    <message>
        <source>Force or moment that the channel measures.</source>
        <translation>Kraft oder Moment, das der Kanal misst.</translation>
    </message>
    <message>
        <source>rated force</source>
        <translation>Nennkraft</translation>
    </message>
    <message>
        <source>Rated load of Fx, Fy or Fz.</source>
        <translation>Nennlast von Fx, Fy oder Fz.</translation>
    </message>
    <message>
        <source>rated moment</source>
        <translation>Nennmoment</translation>
    </message>
    <message>
        <source>Rated load of Mx, My or Mz.</source>
        <translation>Nennlast von Mx, My oder Mz.</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Where the sensor&apos;s axes are; loads are along and about them.</source>
        <translation>Wo die Achsen des Sensors sind; Lasten wirken entlang dieser Achsen und um sie.</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Of its housing, for the picture.</source>
        <translation>Seines Gehäuses, für das Bild.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Indicator</source>
        <translation>Anzeigegerät</translation>
    </message>
    <message>
        <source>Resolution of the indicator</source>
        <translation>Auflösung des Anzeigegeräts</translation>
    </message>
    <message>
        <source>Smallest step of the indicated value, r of Eq 6.</source>
        <translation>Kleinster Schritt des angezeigten Wertes, r der Gl. 6.</translation>
    </message>
    <message>
        <source>Range of the indicator</source>
        <translation>Bereich des Anzeigegeräts</translation>
    </message>
    <message>
        <source>Largest value that it can indicate; a reading there is refused as saturated. Empty: only readings that stand still while the load rises are.</source>
        <translation>Größter Wert, den es anzeigen kann; eine Ablesung dort wird als übersteuert abgelehnt. Leer: Nur Ablesungen, die bei steigender Last stehen bleiben, werden abgelehnt.</translation>
    </message>
    <message>
        <source>Calibration machine</source>
        <translation>Kalibriermaschine</translation>
    </message>
    <message>
        <source>What loaded the sensor; its relative uncertainty enters by Eq 5.</source>
        <translation>Was den Sensor belastet hat; ihre relative Unsicherheit geht durch Gl. 5 ein.</translation>
    </message>
    <message>
        <source>Raw readings, from which everything follows, or what an evaluation states.</source>
        <translation>Rohe Ablesungen, aus denen alles folgt, oder was eine Auswertung angibt.</translation>
    </message>
    <message>
        <source>raw readings</source>
        <translation>rohe Ablesungen</translation>
    </message>
    <message>
        <source>summary tables</source>
        <translation>Übersichtstabellen</translation>
    </message>
    <message>
        <source>Indicated values of all channels at each step, the unloaded value not subtracted; typed or from a CSV file, whose columns may have other names.</source>
        <translation>Angezeigte Werte aller Kanäle bei jeder Stufe, der unbelastete Wert nicht abgezogen; eingegeben oder aus einer CSV-Datei, deren Spalten andere Namen haben dürfen.</translation>
    </message>
    <message>
        <source>Axis on which the machine&apos;s load acts.</source>
        <translation>Achse, auf die die Last der Maschine wirkt.</translation>
    </message>
    <message>
        <source>Preloading or calibration.</source>
        <translation>Vorbelastung oder Kalibrierung.</translation>
    </message>
    <message>
        <source>preload</source>
        <translation>Vorbelastung</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Unloaded before, preload, increasing or decreasing load, unloaded after.</source>
        <translation>Unbelastet vorher, Vorbelastung, steigende oder fallende Last, unbelastet nachher.</translation>
    </message>
    <message>
        <source>zero before</source>
        <translation>Null vorher</translation>
    </message>
    <message>
        <source>load</source>
        <translation>Last</translation>
    </message>
    <message>
        <source>increasing</source>
        <translation>steigend</translation>
    </message>
    <message>
        <source>decreasing</source>
        <translation>fallend</translation>
    </message>
    <message>
        <source>zero after</source>
        <translation>Null nachher</translation>
    </message>
    <message>
        <source>step</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Number of the step: 0 without load, the same number for increasing and decreasing load.</source>
        <translation>Nummer der Stufe: 0 ohne Last, dieselbe Nummer für steigende und fallende Last.</translation>
    </message>
    <message>
        <source>Load in the unit of the next column.</source>
        <translation>Last in der Einheit der nächsten Spalte.</translation>
    </message>
    <message>
        <source>load unit</source>
        <translation>Lasteinheit</translation>
    </message>
    <message>
        <source>N, kN, Nm ...; empty: N for forces and N·m for moments.</source>
        <translation>N, kN, Nm ...; leer: N für Kräfte und N·m für Momente.</translation>
    </message>
    <message>
        <source>Time of the reading.</source>
        <translation>Zeit der Ablesung.</translation>
    </message>
    <message>
        <source>Indicated value of this channel.</source>
        <translation>Angezeigter Wert dieses Kanals.</translation>
    </message>
    <message>
        <source>Summary</source>
        <translation>Zusammenfassung</translation>
    </message>
    <message>
        <source>What an evaluation states of each channel, like Tables 1 and 3 of the paper.</source>
        <translation>Was eine Auswertung für jeden Kanal angibt, wie die Tabellen 1 und 3 der Veröffentlichung.</translation>
    </message>
    <message>
        <source>Channel.</source>
        <translation>Kanal.</translation>
    </message>
    <message>
        <source>rated output</source>
        <translation>Nennkennwert</translation>
    </message>
    <message>
        <source>Mean net reading at the rated load.</source>
        <translation>Mittlere Nettoablesung bei der Nennlast.</translation>
    </message>
    <message>
        <source>non-zero error</source>
        <translation>Nullpunktabweichung</translation>
    </message>
    <message>
        <source>Non-zero error: change of the unloaded reading over a series.</source>
        <translation>Nullpunktabweichung: Änderung der unbelasteten Ablesung über eine Reihe.</translation>
    </message>
    <message>
        <source>Type A standard uncertainty of the mean, the largest of all steps.</source>
        <translation>Standardunsicherheit des Mittelwertes vom Typ A, die größte aller Stufen.</translation>
    </message>
    <message>
        <source>hysteresis</source>
        <translation>Hysterese</translation>
    </message>
    <message>
        <source>Largest difference between increasing and decreasing load.</source>
        <translation>Größte Differenz zwischen steigender und fallender Last.</translation>
    </message>
    <message>
        <source>Type B standard uncertainty as stated; empty: from the machine, the resolution and the non-zero error (Eq 8).</source>
        <translation>Standardunsicherheit vom Typ B wie angegeben; leer: aus der Maschine, der Auflösung und der Nullpunktabweichung (Gl. 8).</translation>
    </message>
    <message>
        <source>Interference</source>
        <translation>Übersprechen</translation>
    </message>
    <message>
        <source>Outputs at rated loads on other axes, like Table 2 of the paper; which index is the load is chosen below.</source>
        <translation>Ausgaben bei Nennlasten auf anderen Achsen, wie Tabelle 2 der Veröffentlichung; welcher Index die Last ist, wird unten gewählt.</translation>
    </message>
    <message>
        <source>Row of the table.</source>
        <translation>Zeile der Tabelle.</translation>
    </message>
    <message>
        <source>Column of the table; empty on the diagonal.</source>
        <translation>Spalte der Tabelle; auf der Diagonale leer.</translation>
    </message>
    <message>
        <source>Interference has signs</source>
        <translation>Übersprechen hat Vorzeichen</translation>
    </message>
    <message>
        <source>Whether the signs are printed. Without them interference cannot be compensated.</source>
        <translation>Ob die Vorzeichen angegeben sind. Ohne sie kann das Übersprechen nicht kompensiert werden.</translation>
    </message>
    <message>
        <source>Calibration plan</source>
        <translation>Kalibrierplan</translation>
    </message>
    <message>
        <source>Preloads</source>
        <translation>Vorbelastungen</translation>
    </message>
    <message>
        <source>How often each axis is loaded to its rated load before.</source>
        <translation>Wie oft jede Achse zuvor bis zu ihrer Nennlast belastet wird.</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>Calibration series of each axis: n of Eqs 2 to 4.</source>
        <translation>Kalibrierreihen jeder Achse: n der Gl. 2 bis 4.</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Loads of a series up to the rated load; the paper asks for five or more.</source>
        <translation>Lasten einer Reihe bis zur Nennlast; die Veröffentlichung verlangt fünf oder mehr.</translation>
    </message>
    <message>
        <source>Decreasing loads too</source>
        <translation>Auch fallende Lasten</translation>
    </message>
    <message>
        <source>Whether each series goes down again; hysteresis needs it.</source>
        <translation>Ob jede Reihe wieder hinuntergeht; die Hysterese braucht es.</translation>
    </message>
    <message>
        <source>Without load before a series</source>
        <translation>Ohne Last vor einer Reihe</translation>
    </message>
    <message>
        <source>Before each series, Fig. 2.</source>
        <translation>Vor jeder Reihe, Bild 2.</translation>
    </message>
    <message>
        <source>At each load</source>
        <translation>Bei jeder Last</translation>
    </message>
    <message>
        <source>Before a reading is taken, Fig. 2.</source>
        <translation>Bevor eine Ablesung genommen wird, Bild 2.</translation>
    </message>
    <message>
        <source>Evaluation by the paper</source>
        <translation>Auswertung nach der Veröffentlichung</translation>
    </message>
    <message>
        <source>Coverage factor k of Eq 12</source>
        <translation>Erweiterungsfaktor k der Gl. 12</translation>
    </message>
    <message>
        <source>The paper takes 2.</source>
        <translation>Die Veröffentlichung nimmt 2.</translation>
    </message>
    <message>
        <source>A row of the interference table is</source>
        <translation>Eine Zeile der Übersprechtabelle ist</translation>
    </message>
    <message>
        <source>Section 2.5 says e_12 is the output of Fy under Fx (row = load), but divides by the rated output of the row and calls the row&apos;s largest the error of that sensor. Raw readings leave no doubt; for a printed table the choice changes U.</source>
        <translation>Abschnitt 2.5 nennt e_12 die Ausgabe von Fy unter Fx (Zeile = Last), teilt aber durch den Nennkennwert der Zeile und nennt das Größte der Zeile die Abweichung dieses Sensors. Rohe Ablesungen lassen keinen Zweifel; bei einer gedruckten Tabelle ändert die Wahl U.</translation>
    </message>
    <message>
        <source>a sensor: its outputs under the other loads</source>
        <translation>ein Sensor: seine Ausgaben unter den anderen Lasten</translation>
    </message>
    <message>
        <source>a load: the outputs of the other sensors under it</source>
        <translation>eine Last: die Ausgaben der anderen Sensoren unter ihr</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Stated values</source>
        <translation>Angegebene Werte</translation>
    </message>
    <message>
        <source>Values that a certificate or a paper prints, to be compared with those computed.</source>
        <translation>Werte, die ein Kalibrierschein oder eine Veröffentlichung angibt, zum Vergleich mit den berechneten.</translation>
    </message>
    <message>
        <source>As printed, in mV/V; empty: not compared.</source>
        <translation>Wie gedruckt, in mV/V; leer: nicht verglichen.</translation>
    </message>
    <message>
        <source>interference</source>
        <translation>Übersprechen</translation>
    </message>
    <message>
        <source>U, relative</source>
        <translation>U, relativ</translation>
    </message>
    <message>
        <source>Relative expanded uncertainty of Eq 12b.</source>
        <translation>Relative erweiterte Unsicherheit der Gl. 12b.</translation>
    </message>
    <message>
        <source>U, as a load</source>
        <translation>U, als Last</translation>
    </message>
    <message>
        <source>Expanded uncertainty of Eq 12c in N or N·m, a number without unit.</source>
        <translation>Erweiterte Unsicherheit der Gl. 12c in N oder N·m, eine Zahl ohne Einheit.</translation>
    </message>
    <message>
        <source>Stated interference in %</source>
        <translation>Angegebenes Übersprechen in %</translation>
    </message>
    <message>
        <source>Table 4 of the paper: interference by the rated output of the row.</source>
        <translation>Tabelle 4 der Veröffentlichung: Übersprechen geteilt durch den Nennkennwert der Zeile.</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>größtes</translation>
    </message>
    <message>
        <source>Largest of the row.</source>
        <translation>Größtes der Zeile.</translation>
    </message>
    <message>
        <source>Typed measurement equation</source>
        <translation>Eingegebene Messgleichung</translation>
    </message>
    <message>
        <source>The uncertainty of a quantity computed from others by an equation.</source>
        <translation>Die Unsicherheit einer Größe, die aus anderen durch eine Gleichung berechnet wird.</translation>
    </message>
    <message>
        <source>Gauge block by comparison</source>
        <translation>Endmaß im Vergleich</translation>
    </message>
    <message>
        <source>The length of a gauge block compared with a standard of the same length.</source>
        <translation>Die Länge eines Endmaßes, verglichen mit einem Normal derselben Länge.</translation>
    </message>
    <message>
        <source>Two quantities from the same readings</source>
        <translation>Zwei Größen aus denselben Ablesungen</translation>
    </message>
    <message>
        <source>Resistance and reactance from simultaneous readings, with their correlation.</source>
        <translation>Wirk- und Blindwiderstand aus gleichzeitigen Ablesungen, mit ihrer Korrelation.</translation>
    </message>
    <message>
        <source>Calibration line of a thermometer</source>
        <translation>Kalibriergerade eines Thermometers</translation>
    </message>
    <message>
        <source>The correction at any reading, from a line through calibration points.</source>
        <translation>Die Korrektion bei jeder Ablesung, aus einer Geraden durch Kalibrierpunkte.</translation>
    </message>
    <message>
        <source>Observations on several days</source>
        <translation>Beobachtungen an mehreren Tagen</translation>
    </message>
    <message>
        <source>The mean of readings in groups, and whether the groups differ.</source>
        <translation>Der Mittelwert von Ablesungen in Gruppen und ob sich die Gruppen unterscheiden.</translation>
    </message>
    <message>
        <source>Pose of a platform from a tracker</source>
        <translation>Pose einer Plattform mit einem Tracker</translation>
    </message>
    <message>
        <source>Where a robot&apos;s flange or platform is, from nests measured by a laser tracker.</source>
        <translation>Wo Flansch oder Plattform eines Roboters ist, aus Aufnahmen, die ein Lasertracker misst.</translation>
    </message>
    <message>
        <source>Pose from two instruments together</source>
        <translation>Pose aus zwei Messgeräten gemeinsam</translation>
    </message>
    <message>
        <source>The same pose measured by a tracker and a total station as one network.</source>
        <translation>Dieselbe Pose, gemessen von einem Tracker und einer Totalstation als einem Netz.</translation>
    </message>
    <message>
        <source>Pose from calibrated artefacts</source>
        <translation>Pose aus kalibrierten Prüfkörpern</translation>
    </message>
    <message>
        <source>A pose whose point uncertainties come from measurements of artefacts.</source>
        <translation>Eine Pose, deren Punktunsicherheiten aus Messungen von Prüfkörpern stammen.</translation>
    </message>
    <message>
        <source>Points by cameras and a tracker</source>
        <translation>Punkte mit Kameras und einem Tracker</translation>
    </message>
    <message>
        <source>Coordinates of targets that several instruments measure together.</source>
        <translation>Koordinaten von Zielpunkten, die mehrere Messgeräte gemeinsam messen.</translation>
    </message>
    <message>
        <source>Network with unknown stations</source>
        <translation>Netz mit unbekannten Standpunkten</translation>
    </message>
    <message>
        <source>Places of targets and of the instruments themselves, from readings to control points.</source>
        <translation>Orte von Zielpunkten und der Messgeräte selbst, aus Messungen zu Festpunkten.</translation>
    </message>
    <message>
        <source>Where do I put the station?</source>
        <translation>Wo wähle ich den Standpunkt?</translation>
    </message>
    <message>
        <source>The place of an instrument that makes the uncertainties smallest.</source>
        <translation>Der Ort eines Messgeräts, der die Unsicherheiten am kleinsten macht.</translation>
    </message>
    <message>
        <source>Tool by ballbars</source>
        <translation>Werkzeug mit Kugelstäben</translation>
    </message>
    <message>
        <source>A robot&apos;s tool centre point from rotations measured by telescopic ballbars.</source>
        <translation>Der Werkzeugmittelpunkt eines Roboters aus Drehungen, gemessen mit teleskopischen Kugelstäben.</translation>
    </message>
    <message>
        <source>Which points do I measure?</source>
        <translation>Welche Punkte messe ich?</translation>
    </message>
    <message>
        <source>The dozen of a plan of points that makes the uncertainty smallest.</source>
        <translation>Das Dutzend aus einem Plan von Punkten, das die Unsicherheit am kleinsten macht.</translation>
    </message>
    <message>
        <source>Tool position of a robot</source>
        <translation>Werkzeugposition eines Roboters</translation>
    </message>
    <message>
        <source>Where the tool is, from joint readings and Denavit-Hartenberg parameters.</source>
        <translation>Wo das Werkzeug ist, aus Gelenkablesungen und Denavit-Hartenberg-Parametern.</translation>
    </message>
    <message>
        <source>Parameters of an arm from circles that its joints describe one by one.</source>
        <translation>Parameter eines Arms aus Kreisen, die seine Gelenke einzeln beschreiben.</translation>
    </message>
    <message>
        <source>Parameters of an arm from measured places of its flange.</source>
        <translation>Parameter eines Arms aus gemessenen Orten seines Flansches.</translation>
    </message>
    <message>
        <source>Calibration of a force/moment sensor</source>
        <translation>Kalibrierung eines Kraft-/Momentensensors</translation>
    </message>
    <message>
        <source>Errors and uncertainty of the channels of a multi-axis sensor.</source>
        <translation>Abweichungen und Unsicherheit der Kanäle eines mehrachsigen Sensors.</translation>
    </message>
    <message>
        <source>Forces and moments from readings</source>
        <translation>Kräfte und Momente aus Ablesungen</translation>
    </message>
    <message>
        <source>Loads from the readings of a multi-axis sensor by its calibration matrix.</source>
        <translation>Lasten aus den Ablesungen eines mehrachsigen Sensors durch seine Kalibriermatrix.</translation>
    </message>
    <message>
        <source>Law of propagation alone (JCGM 100), with a fixed number of trials (JCGM 101), or with as many as the tolerance needs.</source>
        <translation>Nur Fortpflanzungsgesetz (JCGM 100), mit fester Anzahl von Versuchen (JCGM 101) oder mit so vielen, wie die Toleranz braucht.</translation>
    </message>
    <message>
        <source>Law of propagation only</source>
        <translation>Nur Fortpflanzungsgesetz</translation>
    </message>
    <message>
        <source>Monte Carlo, fixed number of trials</source>
        <translation>Monte Carlo, feste Anzahl von Versuchen</translation>
    </message>
    <message>
        <source>Monte Carlo, adaptive</source>
        <translation>Monte Carlo, adaptiv</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Of the method monte-carlo.</source>
        <translation>Der Methode monte-carlo.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startzahl</translation>
    </message>
    <message>
        <source>0 to 18446744073709551615, as text.</source>
        <translation>0 bis 18446744073709551615, als Text.</translation>
    </message>
    <message>
        <source>Variance reduction</source>
        <translation>Varianzreduktion</translation>
    </message>
    <message>
        <source>Makes each trial tell more; the gain is measured and stated with the result. Plain trials are those of JCGM 101.</source>
        <translation>Lässt jeden Versuch mehr aussagen; der Gewinn wird gemessen und mit dem Ergebnis angegeben. Einfache Versuche sind die nach JCGM 101.</translation>
    </message>
    <message>
        <source>None: plain trials</source>
        <translation>Keine: einfache Versuche</translation>
    </message>
    <message>
        <source>Control variate: the linear part</source>
        <translation>Kontrollvariate: der lineare Anteil</translation>
    </message>
    <message>
        <source>Sobol points, scrambled</source>
        <translation>Sobol-Punkte, verwürfelt</translation>
    </message>
    <message>
        <source>Coverage probability</source>
        <translation>Überdeckungswahrscheinlichkeit</translation>
    </message>
    <message>
        <source>Of the expanded uncertainty, of intervals and regions.</source>
        <translation>Der erweiterten Unsicherheit, der Intervalle und Bereiche.</translation>
    </message>
    <message>
        <source>Coverage factor</source>
        <translation>Erweiterungsfaktor</translation>
    </message>
    <message>
        <source>A fixed k for U = k u; absent: U by the effective degrees of freedom (law of propagation), or half of the coverage interval (Monte Carlo).</source>
        <translation>Ein festes k für U = k u; fehlt es: U aus den effektiven Freiheitsgraden (Fortpflanzungsgesetz) oder die Hälfte des Überdeckungsintervalls (Monte Carlo).</translation>
    </message>
    <message>
        <source>Second-order terms</source>
        <translation>Glieder zweiter Ordnung</translation>
    </message>
    <message>
        <source>Terms of second order of the law of propagation (JCGM 100 5.1.2).</source>
        <translation>Glieder zweiter Ordnung des Fortpflanzungsgesetzes (JCGM 100 5.1.2).</translation>
    </message>
    <message>
        <source>Trials one at a time</source>
        <translation>Versuche je Komponente</translation>
    </message>
    <message>
        <source>Of Monte Carlo with all components but one kept constant, for each component; 0: none.</source>
        <translation>Von Monte Carlo mit allen Komponenten bis auf eine konstant, für jede Komponente; 0: keine.</translation>
    </message>
    <message>
        <source>Trials by contributor</source>
        <translation>Versuche je Beitragsquelle</translation>
    </message>
    <message>
        <source>Of Monte Carlo without each contributor, and of it alone; 0: none.</source>
        <translation>Von Monte Carlo ohne jeden Beitragenden und mit ihm allein; 0: keine.</translation>
    </message>
    <message>
        <source>Trials for Sobol indices</source>
        <translation>Versuche für Sobol-Indizes</translation>
    </message>
    <message>
        <source>Pairs of trials for Sobol indices; 0: none.</source>
        <translation>Versuchspaare für Sobol-Indizes; 0: keine.</translation>
    </message>
    <message>
        <source>Significant digits</source>
        <translation>Signifikante Stellen</translation>
    </message>
    <message>
        <source>Of u, for the numerical tolerance of adaptive runs and of the validation (JCGM 101 7.9.2, 8).</source>
        <translation>Von u, für die numerische Toleranz adaptiver Läufe und der Validierung (JCGM 101 7.9.2, 8).</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>A quantity applies to the outputs of its dimension; a number to every output in its SI unit.</source>
        <translation>Eine Größe gilt für die Ausgangsgrößen ihrer Dimension; eine Zahl für jede Ausgangsgröße in ihrer SI-Einheit.</translation>
    </message>
    <message>
        <source>Least number of batches</source>
        <translation>Kleinste Anzahl von Blöcken</translation>
    </message>
    <message>
        <source>Of an adaptive run, before it may stop.</source>
        <translation>Eines adaptiven Laufs, bevor er anhalten darf.</translation>
    </message>
    <message>
        <source>Most trials</source>
        <translation>Höchstzahl der Versuche</translation>
    </message>
    <message>
        <source>At which an adaptive run stops in any case.</source>
        <translation>Bei der ein adaptiver Lauf auf jeden Fall anhält.</translation>
    </message>
    <message>
        <source>Certificate and laboratory</source>
        <translation>Kalibrierschein und Laboratorium</translation>
    </message>
    <message>
        <source>Certificate number</source>
        <translation>Nummer des Kalibrierscheins</translation>
    </message>
    <message>
        <source>Unique; it stands on every page.</source>
        <translation>Eindeutig; sie steht auf jeder Seite.</translation>
    </message>
    <message>
        <source>Laboratory</source>
        <translation>Laboratorium</translation>
    </message>
    <message>
        <source>That issues the certificate.</source>
        <translation>Das den Kalibrierschein ausstellt.</translation>
    </message>
    <message>
        <source>Address of the laboratory</source>
        <translation>Anschrift des Laboratoriums</translation>
    </message>
    <message>
        <source>Street, town, country.</source>
        <translation>Straße, Ort, Land.</translation>
    </message>
    <message>
        <source>Country of the laboratory</source>
        <translation>Land des Laboratoriums</translation>
    </message>
    <message>
        <source>Two capital letters (ISO 3166-1): DE. For a Digital Calibration Certificate.</source>
        <translation>Zwei Großbuchstaben (ISO 3166-1): DE. Für einen Digitalen Kalibrierschein.</translation>
    </message>
    <message>
        <source>Accreditation number</source>
        <translation>Akkreditierungsnummer</translation>
    </message>
    <message>
        <source>Absent: not accredited for this.</source>
        <translation>Fehlt: hierfür nicht akkreditiert.</translation>
    </message>
    <message>
        <source>Place of calibration</source>
        <translation>Ort der Kalibrierung</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>Kunde</translation>
    </message>
    <message>
        <source>For whom it was done.</source>
        <translation>Für wen sie durchgeführt wurde.</translation>
    </message>
    <message>
        <source>Address of the customer</source>
        <translation>Anschrift des Kunden</translation>
    </message>
    <message>
        <source>Item</source>
        <translation>Gegenstand</translation>
    </message>
    <message>
        <source>What was calibrated.</source>
        <translation>Was kalibriert wurde.</translation>
    </message>
    <message>
        <source>Manufacturer</source>
        <translation>Hersteller</translation>
    </message>
    <message>
        <source>Of the item.</source>
        <translation>Des Gegenstands.</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>The manufacturer&apos;s name for it: model, size, class.</source>
        <translation>Die Bezeichnung des Herstellers: Modell, Größe, Klasse.</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>By which the item is recognised, unless it has an identification.</source>
        <translation>An der der Gegenstand erkannt wird, wenn er keine Kennzeichnung hat.</translation>
    </message>
    <message>
        <source>Identification</source>
        <translation>Kennzeichnung</translation>
    </message>
    <message>
        <source>The customer&apos;s mark, an inventory number.</source>
        <translation>Das Zeichen des Kunden, eine Inventarnummer.</translation>
    </message>
    <message>
        <source>Condition of the item</source>
        <translation>Zustand des Gegenstands</translation>
    </message>
    <message>
        <source>As it was received, where that matters.</source>
        <translation>Wie er einging, wo das von Belang ist.</translation>
    </message>
    <message>
        <source>Dates</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>ISO 8601: 2026-04-17.</source>
        <translation>ISO 8601: 2026-04-17.</translation>
    </message>
    <message>
        <source>A date, or two of an interval: 2026-04-17/2026-04-18.</source>
        <translation>Ein Datum oder zwei eines Zeitraums: 2026-04-17/2026-04-18.</translation>
    </message>
    <message>
        <source>ISO 8601: 2026-04-20.</source>
        <translation>ISO 8601: 2026-04-20.</translation>
    </message>
    <message>
        <source>Procedure by which it was calibrated, with its edition.</source>
        <translation>Verfahren, nach dem kalibriert wurde, mit seiner Ausgabe.</translation>
    </message>
    <message>
        <source>Deviations from the method</source>
        <translation>Abweichungen von der Methode</translation>
    </message>
    <message>
        <source>Additions, exclusions.</source>
        <translation>Ergänzungen, Ausschlüsse.</translation>
    </message>
    <message>
        <source>Environmental conditions</source>
        <translation>Umgebungsbedingungen</translation>
    </message>
    <message>
        <source>Those that influence the results.</source>
        <translation>Die, die die Ergebnisse beeinflussen.</translation>
    </message>
    <message>
        <source>Metrological traceability</source>
        <translation>Metrologische Rückführbarkeit</translation>
    </message>
    <message>
        <source>To which references, by which certificates the results are traceable.</source>
        <translation>Auf welche Referenzen und durch welche Kalibrierscheine die Ergebnisse rückführbar sind.</translation>
    </message>
    <message>
        <source>Adjustment or repair</source>
        <translation>Justierung oder Reparatur</translation>
    </message>
    <message>
        <source>Results before and after it.</source>
        <translation>Ergebnisse davor und danach.</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Bemerkungen</translation>
    </message>
    <message>
        <source>Opinions and interpretations are marked as such (7.8.7).</source>
        <translation>Meinungen und Interpretationen sind als solche gekennzeichnet (7.8.7).</translation>
    </message>
    <message>
        <source>Authorisation</source>
        <translation>Freigabe</translation>
    </message>
    <message>
        <source>Authorised by</source>
        <translation>Freigegeben von</translation>
    </message>
    <message>
        <source>The person who authorises the certificate.</source>
        <translation>Die Person, die den Kalibrierschein freigibt.</translation>
    </message>
    <message>
        <source>Function</source>
        <translation>Funktion</translation>
    </message>
    <message>
        <source>Of that person in the laboratory.</source>
        <translation>Dieser Person im Laboratorium.</translation>
    </message>
    <message>
        <source>Measurement model</source>
        <translation>Messmodell</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>Aufbau</translation>
    </message>
    <message>
        <source>Input quantities</source>
        <translation>Eingangsgrößen</translation>
    </message>
    <message>
        <source>Artefacts and instruments</source>
        <translation>Prüfkörper und Messgeräte</translation>
    </message>
    <message>
        <source>Uncertainty budgets</source>
        <translation>Unsicherheitsbudgets</translation>
    </message>
    <message>
        <source>Sobol indices and contributors</source>
        <translation>Sobol-Indizes und Beitragende</translation>
    </message>
    <message>
        <source>Evaluation of the set-up</source>
        <translation>Auswertung des Aufbaus</translation>
    </message>
    <message>
        <source>Law of propagation beside Monte Carlo</source>
        <translation>Fortpflanzungsgesetz neben Monte Carlo</translation>
    </message>
    <message>
        <source>Joint coverage regions</source>
        <translation>Gemeinsame Überdeckungsbereiche</translation>
    </message>
    <message>
        <source>Distributions</source>
        <translation>Verteilungen</translation>
    </message>
    <message>
        <source>Set-up in space</source>
        <translation>Aufbau im Raum</translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation>Korrelation</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Studien</translation>
    </message>
    <message>
        <source>Designs</source>
        <translation>Entwürfe</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Provenance</source>
        <translation>Herkunftsnachweis</translation>
    </message>
    <message>
        <source>mean value</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>standard deviation</source>
        <translation>Standardabweichung</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>Skala</translation>
    </message>
    <message>
        <source>degrees of freedom</source>
        <translation>Freiheitsgrade</translation>
    </message>
    <message>
        <source>lower limit</source>
        <translation>untere Grenze</translation>
    </message>
    <message>
        <source>upper limit</source>
        <translation>obere Grenze</translation>
    </message>
    <message>
        <source>curvilinear trapezoid</source>
        <translation>krummliniges Trapez</translation>
    </message>
    <message>
        <source>inexactness of the limits</source>
        <translation>Ungenauigkeit der Grenzen</translation>
    </message>
    <message>
        <source>ratio of top to base</source>
        <translation>Verhältnis oben zu unten</translation>
    </message>
    <message>
        <source>shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>truncated normal</source>
        <translation>gestutzt normal</translation>
    </message>
    <message>
        <source>lognormal</source>
        <translation>lognormal</translation>
    </message>
    <message>
        <source>mean value of the logarithm of the number in SI</source>
        <translation>Mittelwert des Logarithmus der Zahl in SI</translation>
    </message>
    <message>
        <source>standard deviation of the logarithm</source>
        <translation>Standardabweichung des Logarithmus</translation>
    </message>
    <message>
        <source>parameter alpha</source>
        <translation>Parameter alpha</translation>
    </message>
    <message>
        <source>parameter beta</source>
        <translation>Parameter beta</translation>
    </message>
    <message>
        <source>discrete</source>
        <translation>diskret</translation>
    </message>
    <message>
        <source>SpatialAnalyzer points (ASCII)</source>
        <translation>SpatialAnalyzer-Punkte (ASCII)</translation>
    </message>
    <message>
        <source>Table of points</source>
        <translation>Punkttabelle</translation>
    </message>
    <message>
        <source>Digital Calibration Certificate</source>
        <translation>Digitaler Kalibrierschein</translation>
    </message>
    <message>
        <source>Leica GSI-8 and GSI-16</source>
        <translation>Leica GSI-8 und GSI-16</translation>
    </message>
    <message>
        <source>GNU Gama network</source>
        <translation>GNU-Gama-Netz</translation>
    </message>
    <message>
        <source>Comp3D coordinates</source>
        <translation>Comp3D-Koordinaten</translation>
    </message>
    <message>
        <source>Comp3D observations</source>
        <translation>Comp3D-Beobachtungen</translation>
    </message>
    <message>
        <source>Uncertainty budget in Excel</source>
        <translation>Unsicherheitsbudget in Excel</translation>
    </message>
    <message>
        <source>GUM Workbench</source>
        <translation>GUM Workbench</translation>
    </message>
    <message>
        <source>Suncal project</source>
        <translation>Suncal-Projekt</translation>
    </message>
    <message>
        <source>OptiTrack Motive tracking data</source>
        <translation>Trackingdaten von OptiTrack Motive</translation>
    </message>
    <message>
        <source>Kinematic calibration of a UR robot (ROS)</source>
        <translation>Kinematische Kalibrierung eines UR-Roboters (ROS)</translation>
    </message>
    <message>
        <source>Point list with Ux Uy Uz (SpatialAnalyzer ASCII)</source>
        <translation>Punktliste mit Ux Uy Uz (SpatialAnalyzer ASCII)</translation>
    </message>
    <message>
        <source>Digital Calibration Certificate 3.2.1</source>
        <translation>Digitaler Kalibrierschein 3.2.1</translation>
    </message>
    <message>
        <source>Excel workbook</source>
        <translation>Excel-Arbeitsmappe</translation>
    </message>
    <message>
        <source>Robot description (URDF)</source>
        <translation>Roboterbeschreibung (URDF)</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>The pose, point or target the quantity belongs to</source>
        <translation>Die Pose, der Punkt oder der Zielpunkt, zu dem die Größe gehört</translation>
    </message>
    <message>
        <source>Output quantity</source>
        <translation>Ausgangsgröße</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>Schätzwert</translation>
    </message>
    <message>
        <source>Best value of the output quantity</source>
        <translation>Bester Wert der Ausgangsgröße</translation>
    </message>
    <message>
        <source>Standard uncertainty</source>
        <translation>Standardunsicherheit</translation>
    </message>
    <message>
        <source>Coverage factor. U = k u with k of the t distribution for the effective degrees of freedom.</source>
        <translation>Erweiterungsfaktor. U = k u mit k der t-Verteilung für die effektiven Freiheitsgrade.</translation>
    </message>
    <message>
        <source>Expanded uncertainty. U = k u with k of the t distribution for the effective degrees of freedom.</source>
        <translation>Erweiterte Unsicherheit. U = k u mit k der t-Verteilung für die effektiven Freiheitsgrade.</translation>
    </message>
    <message>
        <source>Limit of the shortest coverage interval</source>
        <translation>Grenze des kürzesten Überdeckungsintervalls</translation>
    </message>
    <message>
        <source>Estimate (first order)</source>
        <translation>Schätzwert (erste Ordnung)</translation>
    </message>
    <message>
        <source>By the law of propagation of uncertainty</source>
        <translation>Nach dem Fortpflanzungsgesetz der Unsicherheit</translation>
    </message>
    <message>
        <source>u (first order)</source>
        <translation>u (erste Ordnung)</translation>
    </message>
    <message>
        <source>Effective degrees of freedom (JCGM 100 G.4)</source>
        <translation>Effektive Freiheitsgrade (JCGM 100 G.4)</translation>
    </message>
    <message>
        <source>U (first order)</source>
        <translation>U (erste Ordnung)</translation>
    </message>
    <message>
        <source>First order validated</source>
        <translation>Erste Ordnung validiert</translation>
    </message>
    <message>
        <source>JCGM 101 clause 8: agrees with Monte Carlo within the tolerance</source>
        <translation>JCGM 101 Abschnitt 8: stimmt innerhalb der Toleranz mit Monte Carlo überein</translation>
    </message>
    <message>
        <source>u (second order)</source>
        <translation>u (zweite Ordnung)</translation>
    </message>
    <message>
        <source>With the second-order terms of JCGM 100 5.1.2; for information</source>
        <translation>Mit den Gliedern zweiter Ordnung nach JCGM 100 5.1.2; zur Information</translation>
    </message>
    <message>
        <source>shift (second order)</source>
        <translation>Verschiebung (zweite Ordnung)</translation>
    </message>
    <message>
        <source>What the curvature of the equation adds to the estimate; for information, not added</source>
        <translation>Was die Krümmung der Gleichung zum Schätzwert beiträgt; zur Information, nicht addiert</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel-U</translation>
    </message>
    <message>
        <source>Target uncertainty that is required</source>
        <translation>Geforderte Zielunsicherheit</translation>
    </message>
    <message>
        <source>U / target</source>
        <translation>U / Ziel-U</translation>
    </message>
    <message>
        <source>Expanded uncertainty as a part of its target: above 1 the target is not met</source>
        <translation>Erweiterte Unsicherheit als Teil der Zielunsicherheit: über 1 ist diese nicht eingehalten</translation>
    </message>
    <message>
        <source>Requirement</source>
        <translation>Anforderung</translation>
    </message>
    <message>
        <source>Whether the target uncertainty is met and the value is accepted</source>
        <translation>Ob die Zielunsicherheit eingehalten und der Wert angenommen ist</translation>
    </message>
    <message>
        <source>Input quantity</source>
        <translation>Eingangsgröße</translation>
    </message>
    <message>
        <source>Component of uncertainty</source>
        <translation>Unsicherheitskomponente</translation>
    </message>
    <message>
        <source>Of the component&apos;s u</source>
        <translation>Von u der Komponente</translation>
    </message>
    <message>
        <source>Standard uncertainty of the component</source>
        <translation>Standardunsicherheit der Komponente</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Verteilung</translation>
    </message>
    <message>
        <source>Type A or Type B evaluation (JCGM 100 2.3.2, 2.3.3)</source>
        <translation>Auswertung vom Typ A oder Typ B (JCGM 100 2.3.2, 2.3.3)</translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation>Freiheitsgrade</translation>
    </message>
    <message>
        <source>Sensitivity coefficient, unit of the output quantity per unit of the component</source>
        <translation>Sensitivitätskoeffizient, Einheit der Ausgangsgröße je Einheit der Komponente</translation>
    </message>
    <message>
        <source>|c|·u</source>
        <translation>|c|·u</translation>
    </message>
    <message>
        <source>Contribution to the standard uncertainty</source>
        <translation>Beitrag zur Standardunsicherheit</translation>
    </message>
    <message>
        <source>Share / %</source>
        <translation>Anteil / %</translation>
    </message>
    <message>
        <source>Of the variance, with its part of the covariances</source>
        <translation>An der Varianz, mit seinem Teil der Kovarianzen</translation>
    </message>
    <message>
        <source>u one at a time</source>
        <translation>u einzeln</translation>
    </message>
    <message>
        <source>By Monte Carlo with every other component kept constant</source>
        <translation>Mit Monte Carlo, jede andere Komponente konstant gehalten</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Herkunft</translation>
    </message>
    <message>
        <source>Where the figure comes from</source>
        <translation>Woher die Zahl stammt</translation>
    </message>
    <message>
        <source>In</source>
        <translation>In</translation>
    </message>
    <message>
        <source>Whether both results have the quantity</source>
        <translation>Ob beide Ergebnisse die Größe haben</translation>
    </message>
    <message>
        <source>U before</source>
        <translation>U vorher</translation>
    </message>
    <message>
        <source>Expanded uncertainty</source>
        <translation>Erweiterte Unsicherheit</translation>
    </message>
    <message>
        <source>U after</source>
        <translation>U nachher</translation>
    </message>
    <message>
        <source>Change of U in %</source>
        <translation>Änderung von U in %</translation>
    </message>
    <message>
        <source>Change of the expanded uncertainty, in per cent of that before</source>
        <translation>Änderung der erweiterten Unsicherheit, in Prozent der vorherigen</translation>
    </message>
    <message>
        <source>Estimate before</source>
        <translation>Schätzwert vorher</translation>
    </message>
    <message>
        <source>Estimate after</source>
        <translation>Schätzwert nachher</translation>
    </message>
    <message>
        <source>Change of estimate</source>
        <translation>Änderung des Schätzwerts</translation>
    </message>
    <message>
        <source>Estimate after less estimate before</source>
        <translation>Schätzwert nachher minus Schätzwert vorher</translation>
    </message>
    <message>
        <source>u before</source>
        <translation>u vorher</translation>
    </message>
    <message>
        <source>u after</source>
        <translation>u nachher</translation>
    </message>
    <message>
        <source>k before</source>
        <translation>k vorher</translation>
    </message>
    <message>
        <source>k after</source>
        <translation>k nachher</translation>
    </message>
    <message>
        <source>Changed, the same, new, or gone</source>
        <translation>Geändert, gleich, neu oder entfallen</translation>
    </message>
    <message>
        <source>|c|·u before</source>
        <translation>|c|·u vorher</translation>
    </message>
    <message>
        <source>|c|·u after</source>
        <translation>|c|·u nachher</translation>
    </message>
    <message>
        <source>Share before / %</source>
        <translation>Anteil vorher / %</translation>
    </message>
    <message>
        <source>Of the variance before</source>
        <translation>An der Varianz vorher</translation>
    </message>
    <message>
        <source>Share after / %</source>
        <translation>Anteil nachher / %</translation>
    </message>
    <message>
        <source>Of the variance after</source>
        <translation>An der Varianz nachher</translation>
    </message>
    <message>
        <source>Change of variance / %</source>
        <translation>Änderung der Varianz / %</translation>
    </message>
    <message>
        <source>By how much this component changes the variance of the output, in per cent of the whole variance before; the rows add up to the change of the whole</source>
        <translation>Um wie viel diese Komponente die Varianz der Ausgangsgröße ändert, in Prozent der gesamten vorherigen Varianz; die Zeilen summieren sich zur gesamten Änderung</translation>
    </message>
    <message>
        <source>met</source>
        <translation>eingehalten</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>nicht eingehalten</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
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
        <translation>Erweiterungsfaktor. U = k u mit dem Erweiterungsfaktor, der festgelegt wurde.</translation>
    </message>
    <message>
        <source>Expanded uncertainty. U = k u with the coverage factor that was fixed.</source>
        <translation>Erweiterte Unsicherheit. U = k u mit dem Erweiterungsfaktor, der festgelegt wurde.</translation>
    </message>
    <message>
        <source>Coverage factor. U is half the width of the probabilistically symmetric coverage interval, and k = U/u.</source>
        <translation>Erweiterungsfaktor. U ist die halbe Breite des wahrscheinlichkeitssymmetrischen Überdeckungsintervalls, und k = U/u.</translation>
    </message>
    <message>
        <source>Expanded uncertainty. U is half the width of the probabilistically symmetric coverage interval, and k = U/u.</source>
        <translation>Erweiterte Unsicherheit. U ist die halbe Breite des wahrscheinlichkeitssymmetrischen Überdeckungsintervalls, und k = U/u.</translation>
    </message>
    <message>
        <source>Target uncertainty</source>
        <translation>Zielunsicherheit</translation>
    </message>
    <message>
        <source>The expanded uncertainty U must not exceed this.</source>
        <translation>Die erweiterte Unsicherheit U darf dies nicht überschreiten.</translation>
    </message>
    <message>
        <source>Lower limit</source>
        <translation>Untere Grenze</translation>
    </message>
    <message>
        <source>Of the tolerance; empty: none.</source>
        <translation>Der Toleranz; leer: keine.</translation>
    </message>
    <message>
        <source>Upper limit</source>
        <translation>Obere Grenze</translation>
    </message>
    <message>
        <source>Guard factor</source>
        <translation>Schutzfaktor</translation>
    </message>
    <message>
        <source>Guard bands of this times U inside the tolerance: 1 proves conformity (ISO 14253-1), 0 is simple acceptance, negative values favour the producer.</source>
        <translation>Schutzabstände von so vielen U innerhalb der Toleranz: 1 weist Konformität nach (ISO 14253-1), 0 ist einfache Annahme, negative Werte begünstigen den Hersteller.</translation>
    </message>
    <message>
        <source>Prior mean</source>
        <translation>A-priori-Mittelwert</translation>
    </message>
    <message>
        <source>What is known of such quantities before the measurement, as a normal distribution (the production process): for the global risks of JCGM 106.</source>
        <translation>Was man vor der Messung von solchen Größen weiß, als Normalverteilung (Herstellungsprozess): für die globalen Risiken nach JCGM 106.</translation>
    </message>
    <message>
        <source>Prior standard deviation</source>
        <translation>A-priori-Standardabweichung</translation>
    </message>
    <message>
        <source>Of the production process.</source>
        <translation>Des Herstellungsprozesses.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Logo</source>
        <translation>Logo</translation>
    </message>
    <message>
        <source>A PNG or JPEG file beside the project, up to 2 MB: at the head of the first page.</source>
        <translation>Eine PNG- oder JPEG-Datei neben dem Projekt, bis 2 MB: am Kopf der ersten Seite.</translation>
    </message>
    <message>
        <source>Calibration certificate %1</source>
        <translation>Kalibrierschein %1</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>— not stated —</source>
        <translation>— nicht angegeben —</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>in the laboratory</source>
        <translation>im Laboratorium</translation>
    </message>
    <message>
        <source>This certificate states %1 of %2 results. Not stated: %3.</source>
        <translation>Dieser Kalibrierschein gibt %1 von %2 Ergebnissen an. Nicht angegeben: %3.</translation>
    </message>
    <message>
        <source>1 further result is in the digital certificate that is attached to the PDF (certificate.xml).</source>
        <translation>1 weiteres Ergebnis steht im digitalen Kalibrierschein, der dem PDF beigefügt ist (certificate.xml).</translation>
    </message>
    <message>
        <source>%1 further results are in the digital certificate that is attached to the PDF (certificate.xml).</source>
        <translation>%1 weitere Ergebnisse stehen im digitalen Kalibrierschein, der dem PDF beigefügt ist (certificate.xml).</translation>
    </message>
    <message>
        <source>Not evaluated: %1.</source>
        <translation>Nicht ausgewertet: %1.</translation>
    </message>
    <message>
        <source>Evaluated with Covaria %1, project fingerprint %2.</source>
        <translation>Ausgewertet mit Covaria %1, Fingerabdruck des Projekts %2.</translation>
    </message>
    <message>
        <source>Evaluated with Covaria %1, project fingerprint %2, analyses: %3.</source>
        <translation>Ausgewertet mit Covaria %1, Fingerabdruck des Projekts %2, Analysen: %3.</translation>
    </message>
    <message>
        <source>The results relate only to the item described above, in the state in which it was calibrated. This certificate may be reproduced in full only, unless the laboratory permits otherwise.</source>
        <translation>Die Ergebnisse beziehen sich nur auf den oben beschriebenen Gegenstand in dem Zustand, in dem er kalibriert wurde. Dieser Kalibrierschein darf nur vollständig vervielfältigt werden, sofern das Laboratorium nichts anderes genehmigt.</translation>
    </message>
    <message>
        <source>Date of issue: %1</source>
        <translation>Ausgestellt am: %1</translation>
    </message>
    <message>
        <source>End of certificate</source>
        <translation>Ende des Kalibrierscheins</translation>
    </message>
    <message>
        <source>End of certificate %1</source>
        <translation>Ende des Kalibrierscheins %1</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>p = %1 to %2.</source>
        <translation>p = %1 bis %2.</translation>
    </message>
    <message>
        <source>No result is stated: what was evaluated does not represent the measurand; %1 trials have no value.</source>
        <translation>Es wird kein Ergebnis angegeben: Was ausgewertet wurde, stellt die Messgröße nicht dar; %1 Versuche haben keinen Wert.</translation>
    </message>
    <message>
        <source>Coverage intervals that are not symmetric about the estimate: %1.</source>
        <translation>Überdeckungsintervalle, die nicht symmetrisch zum Schätzwert sind: %1.</translation>
    </message>
    <message>
        <source>Coverage intervals that are not symmetric about the estimate: %1; and %2 others.</source>
        <translation>Überdeckungsintervalle, die nicht symmetrisch zum Schätzwert sind: %1; und %2 weitere.</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>%1 (exact)</source>
        <translation>%1 (exakt)</translation>
    </message>
    <message>
        <source>%1 (U not finite)</source>
        <translation>%1 (U nicht endlich)</translation>
    </message>
    <message>
        <source>without k, because u is not finite</source>
        <translation>ohne k, weil u nicht endlich ist</translation>
    </message>
    <message>
        <source>coverage interval %1</source>
        <translation>Überdeckungsintervall %1</translation>
    </message>
    <message>
        <source>The standard uncertainty was determined by the law of propagation of uncertainty in accordance with JCGM 100.</source>
        <translation>Die Standardmessunsicherheit wurde nach dem Unsicherheitsfortpflanzungsgesetz gemäß JCGM 100 ermittelt.</translation>
    </message>
    <message>
        <source>The distribution was determined by the propagation of distributions in accordance with JCGM 101.</source>
        <translation>Die Verteilung wurde durch Fortpflanzung von Verteilungen gemäß JCGM 101 ermittelt.</translation>
    </message>
    <message>
        <source>The expanded uncertainty U stated after ± is the standard uncertainty multiplied by the fixed coverage factor k; y ± U has the coverage probability p that is stated with it.</source>
        <translation>Die nach ± angegebene erweiterte Messunsicherheit U ist die Standardmessunsicherheit, multipliziert mit dem festen Erweiterungsfaktor k; y ± U hat die dabei angegebene Überdeckungswahrscheinlichkeit p.</translation>
    </message>
    <message>
        <source>The expanded uncertainty U stated after ± is half the width of the probabilistically symmetric coverage interval of the coverage probability p, and k = U/u.</source>
        <translation>Die nach ± angegebene erweiterte Messunsicherheit U ist die halbe Breite des wahrscheinlichkeitssymmetrischen Überdeckungsintervalls zur Überdeckungswahrscheinlichkeit p, und k = U/u.</translation>
    </message>
    <message>
        <source>The expanded uncertainty U stated after ± is the standard uncertainty multiplied by the coverage factor k, which for a normal distribution, or for a t distribution of the effective degrees of freedom nu_eff where they are stated, corresponds to the coverage probability p.</source>
        <translation>Die nach ± angegebene erweiterte Messunsicherheit U ist die Standardmessunsicherheit, multipliziert mit dem Erweiterungsfaktor k, der bei einer Normalverteilung oder, wo sie angegeben sind, bei einer t-Verteilung mit den effektiven Freiheitsgraden nu_eff der Überdeckungswahrscheinlichkeit p entspricht.</translation>
    </message>
    <message>
        <source>Statement of conformity</source>
        <translation>Konformitätsaussage</translation>
    </message>
    <message>
        <source>Acceptance</source>
        <translation>Annahme</translation>
    </message>
    <message>
        <source>Decision rule</source>
        <translation>Entscheidungsregel</translation>
    </message>
    <message>
        <source>Decision</source>
        <translation>Entscheidung</translation>
    </message>
    <message>
        <source>Conforming</source>
        <translation>Konform</translation>
    </message>
    <message>
        <source>by</source>
        <translation>nach</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>nicht beurteilt</translation>
    </message>
    <message>
        <source>trials</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>JCGM 106: probability that the measurand lies inside the tolerance, by the distribution of the result: its trials, or by the law of propagation Student&apos;s t for the effective degrees of freedom. The acceptance interval is the tolerance less guard bands w. Decision rules are named as in ILAC-G8:09/2019. TUR: half of the tolerance over U. C_m: T/(2U) for U = 2u, T/(4u).</source>
        <translation>JCGM 106: Wahrscheinlichkeit, dass die Messgröße innerhalb der Toleranz liegt, nach der Verteilung des Ergebnisses: seinen Versuchen oder, beim Fortpflanzungsgesetz, der t-Verteilung mit den effektiven Freiheitsgraden. Das Annahmeintervall ist die Toleranz abzüglich der Schutzabstände w. Entscheidungsregeln heißen wie in ILAC-G8:09/2019. TUR: halbe Toleranz durch U. C_m: T/(2U) für U = 2u, T/(4u).</translation>
    </message>
    <message>
        <source>simple acceptance (w = 0)</source>
        <translation>einfache Annahme (w = 0)</translation>
    </message>
    <message>
        <source>guard band w = %1</source>
        <translation>Schutzabstand w = %1</translation>
    </message>
    <message>
        <source>guarded rejection (w = −%1)</source>
        <translation>gesicherte Rückweisung (w = −%1)</translation>
    </message>
    <message>
        <source>Results before and after</source>
        <translation>Ergebnisse vorher und nachher</translation>
    </message>
    <message>
        <source>Context mesh</source>
        <translation>Umgebungsnetz</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>STL file</source>
        <translation>STL-Datei</translation>
    </message>
    <message>
        <source>A binary or ASCII STL file beside the project, up to 200 MB and 5 million triangles. It is drawn in the scenes of all analyses and influences no number.</source>
        <translation>Eine binäre oder ASCII-STL-Datei neben dem Projekt, bis zu 200 MB und 5 Millionen Dreiecke. Sie wird in den Szenen aller Analysen gezeichnet und beeinflusst keine Zahl.</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>Einheit der Datei</translation>
    </message>
    <message>
        <source>STL files do not say in which unit their numbers are.</source>
        <translation>STL-Dateien sagen nicht, in welcher Einheit ihre Zahlen sind.</translation>
    </message>
    <message>
        <source>millimetre</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>metre</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Position and orientation</source>
        <translation>Lage und Orientierung</translation>
    </message>
    <message>
        <source>Where the origin of the file stands in the world frame, and how its axes are turned.</source>
        <translation>Wo der Ursprung der Datei im Weltsystem liegt und wie ihre Achsen gedreht sind.</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Aussehen</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Of the surface, on a light and on a dark ground.</source>
        <translation>Der Oberfläche, auf hellem und auf dunklem Grund.</translation>
    </message>
    <message>
        <source>grey</source>
        <translation>grau</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>blau</translation>
    </message>
    <message>
        <source>green</source>
        <translation>grün</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>orange</translation>
    </message>
    <message>
        <source>red</source>
        <translation>rot</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>100 % hides what is behind the surface; less lets the measured points be seen.</source>
        <translation>100 % verdeckt, was hinter der Oberfläche ist; weniger lässt die gemessenen Punkte sehen.</translation>
    </message>
    <message>
        <source>largest U/target</source>
        <translation>größtes U/Ziel</translation>
    </message>
    <message>
        <source>largest U relative to the present design</source>
        <translation>größtes U, bezogen auf den jetzigen Entwurf</translation>
    </message>
    <message>
        <source>mean U/target</source>
        <translation>Mittel von U/Ziel</translation>
    </message>
    <message>
        <source>mean U relative to the present design</source>
        <translation>Mittel von U, bezogen auf den jetzigen Entwurf</translation>
    </message>
    <message>
        <source>root mean square of U/target</source>
        <translation>quadratisches Mittel von U/Ziel</translation>
    </message>
    <message>
        <source>root mean square of U relative to the present design</source>
        <translation>quadratisches Mittel von U, bezogen auf den jetzigen Entwurf</translation>
    </message>
    <message>
        <source>Monte Carlo</source>
        <translation>Monte Carlo</translation>
    </message>
    <message>
        <source>Run Monte Carlo to see the distribution of %1</source>
        <translation>Monte Carlo ausführen, um die Verteilung von %1 zu sehen</translation>
    </message>
    <message>
        <source>Run Monte Carlo to see the quantiles of %1</source>
        <translation>Monte Carlo ausführen, um die Quantile von %1 zu sehen</translation>
    </message>
    <message>
        <source>Run Monte Carlo with more trials to see the distribution of %1</source>
        <translation>Monte Carlo mit mehr Versuchen ausführen, um die Verteilung von %1 zu sehen</translation>
    </message>
    <message>
        <source>Run Monte Carlo with more trials to see the quantiles of %1</source>
        <translation>Monte Carlo mit mehr Versuchen ausführen, um die Quantile von %1 zu sehen</translation>
    </message>
    <message>
        <source>%1 has the same value in every trial: give its inputs components of uncertainty</source>
        <translation>%1 hat in jedem Versuch denselben Wert: den Eingangsgrößen Unsicherheitskomponenten geben</translation>
    </message>
    <message>
        <source>Distribution of %1</source>
        <translation>Verteilung von %1</translation>
    </message>
    <message>
        <source>probability density</source>
        <translation>Wahrscheinlichkeitsdichte</translation>
    </message>
    <message>
        <source>normal, same mean and u</source>
        <translation>normal, gleiches Mittel und u</translation>
    </message>
    <message>
        <source>normal, same interval</source>
        <translation>Normalverteilung, gleiches Intervall</translation>
    </message>
    <message>
        <source>normal, first order</source>
        <translation>normal, erste Ordnung</translation>
    </message>
    <message>
        <source>Student t, first order</source>
        <translation>Student-t, erste Ordnung</translation>
    </message>
    <message>
        <source>%1 coverage interval</source>
        <translation>Überdeckungsintervall %1</translation>
    </message>
    <message>
        <source>mean %1</source>
        <translation>Mittelwert %1</translation>
    </message>
    <message>
        <source>Normal quantiles of %1</source>
        <translation>Normalquantile von %1</translation>
    </message>
    <message>
        <source>quantile of the standard normal distribution</source>
        <translation>Quantil der Standardnormalverteilung</translation>
    </message>
    <message>
        <source>quantile of %1</source>
        <translation>Quantil von %1</translation>
    </message>
    <message>
        <source>No input quantity with an uncertainty influences %1: give its inputs components of uncertainty</source>
        <translation>Keine Eingangsgröße mit einer Unsicherheit beeinflusst %1: den Eingangsgrößen Unsicherheitskomponenten geben</translation>
    </message>
    <message>
        <source>Contributions to u(%1)</source>
        <translation>Beiträge zu u(%1)</translation>
    </message>
    <message>
        <source>first order</source>
        <translation>erste Ordnung</translation>
    </message>
    <message>
        <source>one at a time, Monte Carlo</source>
        <translation>einzeln, Monte Carlo</translation>
    </message>
    <message>
        <source>%1 others</source>
        <translation>%1 weitere</translation>
    </message>
    <message>
        <source>A single output quantity has nothing to be correlated with</source>
        <translation>Eine einzelne Ausgangsgröße kann mit nichts korreliert sein</translation>
    </message>
    <message>
        <source>Correlation coefficients</source>
        <translation>Korrelationskoeffizienten</translation>
    </message>
    <message>
        <source>correlation coefficient</source>
        <translation>Korrelationskoeffizient</translation>
    </message>
    <message>
        <source>Run Monte Carlo to see how u of %1 settles</source>
        <translation>Monte Carlo ausführen, um zu sehen, wie sich u von %1 einstellt</translation>
    </message>
    <message>
        <source>%1, against the number of trials</source>
        <translation>%1 über der Zahl der Versuche</translation>
    </message>
    <message>
        <source>%1 (not stabilised)</source>
        <translation>%1 (nicht stabilisiert)</translation>
    </message>
    <message>
        <source>± 2 standard errors</source>
        <translation>± 2 Standardfehler</translation>
    </message>
    <message>
        <source>final u %1</source>
        <translation>zuletzt u %1</translation>
    </message>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
    <message>
        <source>after</source>
        <translation>nachher</translation>
    </message>
    <message>
        <source>Distributions of %1</source>
        <translation>Verteilungen: %1</translation>
    </message>
    <message>
        <source>The output quantity has no distribution to show</source>
        <translation>Die Ausgangsgröße hat keine Verteilung, die gezeigt werden könnte</translation>
    </message>
    <message>
        <source>Only one of the results has %1</source>
        <translation>Nur eines der Ergebnisse hat %1</translation>
    </message>
    <message>
        <source>The budget of %1 has not changed</source>
        <translation>Das Budget von %1 hat sich nicht geändert</translation>
    </message>
    <message>
        <source>Changes of the budget of %1</source>
        <translation>Änderungen des Budgets von %1</translation>
    </message>
    <message>
        <source>uncertainty</source>
        <translation>Unsicherheit</translation>
    </message>
    <message>
        <source>as set up: %1</source>
        <translation>wie eingestellt: %1</translation>
    </message>
    <message>
        <source>%1 at %2 = %3</source>
        <translation>%1 bei %2 = %3</translation>
    </message>
    <message>
        <source>Run the study “%1” to see it</source>
        <translation>Die Studie „%1“ ausführen, um sie zu sehen</translation>
    </message>
    <message>
        <source>No grid point of “%1” has values: %2</source>
        <translation>Kein Gitterpunkt von „%1“ hat Werte: %2</translation>
    </message>
    <message>
        <source>Uncertainties before and after</source>
        <translation>Unsicherheiten vorher und nachher</translation>
    </message>
    <message>
        <source>U relative to the present design</source>
        <translation>U, bezogen auf den jetzigen Entwurf</translation>
    </message>
    <message>
        <source>designed</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>What more rows give</source>
        <translation>Was mehr Zeilen bringen</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>best found</source>
        <translation>bestes gefundenes</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>behalten</translation>
    </message>
    <message>
        <source>What each row kept is worth</source>
        <translation>Was jede behaltene Zeile wert ist</translation>
    </message>
    <message>
        <source>What a smaller uncertainty costs</source>
        <translation>Was eine kleinere Unsicherheit kostet</translation>
    </message>
    <message>
        <source>largest U / target</source>
        <translation>größtes U / Ziel</translation>
    </message>
    <message>
        <source>cost</source>
        <translation>Kosten</translation>
    </message>
    <message>
        <source>cheapest reductions</source>
        <translation>günstigste Verringerungen</translation>
    </message>
    <message>
        <source>cheapest rows</source>
        <translation>günstigste Zeilen</translation>
    </message>
    <message>
        <source>targets</source>
        <translation>Ziele</translation>
    </message>
    <message>
        <source>The way of the search</source>
        <translation>Der Weg der Suche</translation>
    </message>
    <message>
        <source>evaluations</source>
        <translation>Auswertungen</translation>
    </message>
    <message>
        <source>best so far</source>
        <translation>bisher bestes</translation>
    </message>
    <message>
        <source>both</source>
        <translation>in beiden</translation>
    </message>
    <message>
        <source>only before</source>
        <translation>nur vorher</translation>
    </message>
    <message>
        <source>only after</source>
        <translation>nur nachher</translation>
    </message>
    <message>
        <source>new</source>
        <translation>neu</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>entfallen</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>geändert</translation>
    </message>
    <message>
        <source>same</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>number of trials</source>
        <translation>Zahl der Versuche</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Coordinate measuring machines and arms</source>
        <translation>Koordinatenmessgeräte und -messarme</translation>
    </message>
    <message>
        <source>Distance meters</source>
        <translation>Entfernungsmesser</translation>
    </message>
    <message>
        <source>Laser scanners</source>
        <translation>Laserscanner</translation>
    </message>
    <message>
        <source>Laser trackers</source>
        <translation>Lasertracker</translation>
    </message>
    <message>
        <source>Length standards and ballbars</source>
        <translation>Längennormale und Kugelstäbe</translation>
    </message>
    <message>
        <source>Robot arms</source>
        <translation>Roboterarme</translation>
    </message>
    <message>
        <source>Total stations</source>
        <translation>Totalstationen</translation>
    </message>
    <message>
        <source>Uncertainty budget of a measured point</source>
        <translation>Unsicherheitsbudget eines gemessenen Punktes</translation>
    </message>
    <message>
        <source>Errors of indication (Eq 1)</source>
        <translation>Anzeigeabweichungen (Gl. 1)</translation>
    </message>
    <message>
        <source>Errors of indication (Eq 4)</source>
        <translation>Anzeigeabweichungen (Gl. 4)</translation>
    </message>
    <message>
        <source>Standard uncertainty of one reading, along and across the line of sight</source>
        <translation>Standardunsicherheit einer Ablesung, längs und quer zur Ziellinie</translation>
    </message>
    <message>
        <source>across, by azimuth</source>
        <translation>quer, durch das Azimut</translation>
    </message>
    <message>
        <source>across, by elevation</source>
        <translation>quer, durch den Höhenwinkel</translation>
    </message>
    <message>
        <source>along</source>
        <translation>längs</translation>
    </message>
    <message>
        <source>Standard uncertainty by the readings alone, and with the stations</source>
        <translation>Standardunsicherheit allein durch die Ablesungen und mit den Standpunkten</translation>
    </message>
    <message>
        <source>readings alone (Eq 5)</source>
        <translation>nur Ablesungen (Gl. 5)</translation>
    </message>
    <message>
        <source>readings and shared deviations, first order</source>
        <translation>Ablesungen und gemeinsame Abweichungen, erste Ordnung</translation>
    </message>
    <message>
        <source>Parameters and their uncertainty</source>
        <translation>Parameter und ihre Unsicherheit</translation>
    </message>
    <message>
        <source>u, section 4.1</source>
        <translation>u, Abschnitt 4.1</translation>
    </message>
    <message>
        <source>U = 2 u</source>
        <translation>U = 2 u</translation>
    </message>
    <message>
        <source>value − U</source>
        <translation>Wert − U</translation>
    </message>
    <message>
        <source>value + U</source>
        <translation>Wert + U</translation>
    </message>
    <message>
        <source>u, Table 1</source>
        <translation>u, Tabelle 1</translation>
    </message>
    <message>
        <source>u, repeatability</source>
        <translation>u, Wiederholpräzision</translation>
    </message>
    <message>
        <source>u, sampling</source>
        <translation>u, Abtastung</translation>
    </message>
    <message>
        <source>u, range</source>
        <translation>u, Bereich</translation>
    </message>
    <message>
        <source>Identified parameters beside the nominal ones</source>
        <translation>Identifizierte Parameter neben den Nennwerten</translation>
    </message>
    <message>
        <source>nominal</source>
        <translation>Nennwert</translation>
    </message>
    <message>
        <source>identified</source>
        <translation>identifiziert</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>What these points cannot tell</source>
        <translation>Was diese Punkte nicht sagen können</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Observability</source>
        <translation>Beobachtbarkeit</translation>
    </message>
    <message>
        <source>Strongest correlation of each unknown</source>
        <translation>Stärkste Korrelation jeder Unbekannten</translation>
    </message>
    <message>
        <source>Residuals of the fit, measured less calculated</source>
        <translation>Residuen der Ausgleichung, gemessen minus berechnet</translation>
    </message>
    <message>
        <source>pose</source>
        <translation>Pose</translation>
    </message>
    <message>
        <source>largest over its u</source>
        <translation>größte durch ihr u</translation>
    </message>
    <message>
        <source>outlier test</source>
        <translation>Ausreißertest</translation>
    </message>
    <message>
        <source>Poses held back from the fit, calculated less measured</source>
        <translation>Posen außerhalb der Ausgleichung, berechnet minus gemessen</translation>
    </message>
    <message>
        <source>nominal, distance</source>
        <translation>Nennwert, Abstand</translation>
    </message>
    <message>
        <source>U (k = 2), largest</source>
        <translation>U (k = 2), größtes</translation>
    </message>
    <message>
        <source>E_n, largest</source>
        <translation>E_n, größtes</translation>
    </message>
    <message>
        <source>Circles of the joints</source>
        <translation>Kreise der Gelenke</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>rms along the radius</source>
        <translation>RMS längs des Radius</translation>
    </message>
    <message>
        <source>rms off the plane</source>
        <translation>RMS aus der Ebene</translation>
    </message>
    <message>
        <source>Readings and places of the poses, without uncertainty</source>
        <translation>Ablesungen und Orte der Posen, ohne Unsicherheit</translation>
    </message>
    <message>
        <source>Relative uncertainty of the loads</source>
        <translation>Relative Unsicherheit der Lasten</translation>
    </message>
    <message>
        <source>Calibration as planned and as read</source>
        <translation>Kalibrierung wie geplant und wie abgelesen</translation>
    </message>
    <message>
        <source>preloads</source>
        <translation>Vorbelastungen</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>Durchläufe</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>decreasing steps</source>
        <translation>fallende Stufen</translation>
    </message>
    <message>
        <source>spread of the preloads</source>
        <translation>Spanne der Vorbelastungen</translation>
    </message>
    <message>
        <source>Rated output and non-zero error of each sensor (Kim, Table 1)</source>
        <translation>Nennkennwert und Nullpunktabweichung jedes Sensors (Kim, Tabelle 1)</translation>
    </message>
    <message>
        <source>rated load</source>
        <translation>Nennlast</translation>
    </message>
    <message>
        <source>Interference error of each sensor (Kim, Table 2)</source>
        <translation>Übersprechfehler jedes Sensors (Kim, Tabelle 2)</translation>
    </message>
    <message>
        <source>Uncertainty of the sensors by the paper (Kim, Table 3, Eqs 4 to 12)</source>
        <translation>Unsicherheit der Sensoren nach dem Artikel (Kim, Tabelle 3, Gl. 4 bis 12)</translation>
    </message>
    <message>
        <source>U, load</source>
        <translation>U, Last</translation>
    </message>
    <message>
        <source>Interference error in per cent of the rated output (Kim, Table 4)</source>
        <translation>Übersprechfehler in Prozent des Nennkennwerts (Kim, Tabelle 4)</translation>
    </message>
    <message>
        <source>Parts of the Type B standard uncertainty (Eqs 5 to 8)</source>
        <translation>Teile der Standardunsicherheit vom Typ B (Gl. 5 bis 8)</translation>
    </message>
    <message>
        <source>Means and standard deviations of the net values (Eqs 1 to 4)</source>
        <translation>Mittelwerte und Standardabweichungen der Nettowerte (Gl. 1 bis 4)</translation>
    </message>
    <message>
        <source>mean, decreasing</source>
        <translation>Mittelwert, fallend</translation>
    </message>
    <message>
        <source>Stated values beside the computed ones</source>
        <translation>Angegebene Werte neben den berechneten</translation>
    </message>
    <message>
        <source>stated</source>
        <translation>angegeben</translation>
    </message>
    <message>
        <source>computed</source>
        <translation>berechnet</translation>
    </message>
    <message>
        <source>status</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>Interference at rated loads (% of the sensor&apos;s rated output)</source>
        <translation>Übersprechen bei Nennlasten (% des Nennkennwerts)</translation>
    </message>
    <message>
        <source>Parts of U by the paper (% of rated output)</source>
        <translation>Teile von U nach dem Artikel (% des Nennkennwerts)</translation>
    </message>
    <message>
        <source>per cent of rated output</source>
        <translation>Prozent des Nennkennwerts</translation>
    </message>
    <message>
        <source>k u_c</source>
        <translation>k u_c</translation>
    </message>
    <message>
        <source>Loads of one axis against time</source>
        <translation>Lasten einer Achse über der Zeit</translation>
    </message>
    <message>
        <source>Calibration curve of Fx</source>
        <translation>Kalibrierkurve von Fx</translation>
    </message>
    <message>
        <source>increasing, mean</source>
        <translation>steigend, Mittelwert</translation>
    </message>
    <message>
        <source>decreasing, mean</source>
        <translation>fallend, Mittelwert</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of Fx</source>
        <translation>Residuen von der Geraden durch null von Fx</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of Fx</source>
        <translation>Hystereseschleife, vergrößert, von Fx</translation>
    </message>
    <message>
        <source>Calibration curve of Fy</source>
        <translation>Kalibrierkurve von Fy</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of Fy</source>
        <translation>Residuen von der Geraden durch null von Fy</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of Fy</source>
        <translation>Hystereseschleife, vergrößert, von Fy</translation>
    </message>
    <message>
        <source>Calibration curve of Fz</source>
        <translation>Kalibrierkurve von Fz</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of Fz</source>
        <translation>Residuen von der Geraden durch null von Fz</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of Fz</source>
        <translation>Hystereseschleife, vergrößert, von Fz</translation>
    </message>
    <message>
        <source>Calibration curve of Mx</source>
        <translation>Kalibrierkurve von Mx</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of Mx</source>
        <translation>Residuen von der Geraden durch null von Mx</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of Mx</source>
        <translation>Hystereseschleife, vergrößert, von Mx</translation>
    </message>
    <message>
        <source>Calibration curve of My</source>
        <translation>Kalibrierkurve von My</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of My</source>
        <translation>Residuen von der Geraden durch null von My</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of My</source>
        <translation>Hystereseschleife, vergrößert, von My</translation>
    </message>
    <message>
        <source>Calibration curve of Mz</source>
        <translation>Kalibrierkurve von Mz</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of Mz</source>
        <translation>Residuen von der Geraden durch null von Mz</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of Mz</source>
        <translation>Hystereseschleife, vergrößert, von Mz</translation>
    </message>
    <message>
        <source>The paper&apos;s U and the GUM&apos;s, per cent of rated output</source>
        <translation>U des Artikels und des GUM, Prozent des Nennkennwerts</translation>
    </message>
    <message>
        <source>paper, linear sum</source>
        <translation>Artikel, lineare Summe</translation>
    </message>
    <message>
        <source>GUM, unknown loads on all other axes</source>
        <translation>GUM, unbekannte Lasten auf allen anderen Achsen</translation>
    </message>
    <message>
        <source>GUM, unknown load on one axis</source>
        <translation>GUM, unbekannte Last auf einer Achse</translation>
    </message>
    <message>
        <source>GUM, one component alone, 95 %</source>
        <translation>GUM, eine Komponente allein, 95 %</translation>
    </message>
    <message>
        <source>all other axes at rated load, worst signs</source>
        <translation>alle anderen Achsen bei Nennlast, ungünstigste Vorzeichen</translation>
    </message>
    <message>
        <source>interference alone exceeds the paper&apos;s U</source>
        <translation>das Übersprechen allein übersteigt U des Artikels</translation>
    </message>
    <message>
        <source>Standard uncertainties by the GUM</source>
        <translation>Standardunsicherheiten nach dem GUM</translation>
    </message>
    <message>
        <source>repeatability</source>
        <translation>Wiederholpräzision</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>non-zero</source>
        <translation>Nullpunktabweichung</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>U by the paper and by the GUM</source>
        <translation>U nach dem Artikel und nach dem GUM</translation>
    </message>
    <message>
        <source>all others at rated load, worst signs</source>
        <translation>alle anderen bei Nennlast, ungünstigste Vorzeichen</translation>
    </message>
    <message>
        <source>Calibration matrix: reading by load</source>
        <translation>Kalibriermatrix: Ablesung je Last</translation>
    </message>
    <message>
        <source>channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>load Fx</source>
        <translation>Last Fx</translation>
    </message>
    <message>
        <source>load Fy</source>
        <translation>Last Fy</translation>
    </message>
    <message>
        <source>load Fz</source>
        <translation>Last Fz</translation>
    </message>
    <message>
        <source>load Mx</source>
        <translation>Last Mx</translation>
    </message>
    <message>
        <source>load My</source>
        <translation>Last My</translation>
    </message>
    <message>
        <source>load Mz</source>
        <translation>Last Mz</translation>
    </message>
    <message>
        <source>Decoupling matrix: load by reading</source>
        <translation>Entkopplungsmatrix: Last je Ablesung</translation>
    </message>
    <message>
        <source>channel Fx</source>
        <translation>Kanal Fx</translation>
    </message>
    <message>
        <source>channel Fy</source>
        <translation>Kanal Fy</translation>
    </message>
    <message>
        <source>channel Fz</source>
        <translation>Kanal Fz</translation>
    </message>
    <message>
        <source>channel Mx</source>
        <translation>Kanal Mx</translation>
    </message>
    <message>
        <source>channel My</source>
        <translation>Kanal My</translation>
    </message>
    <message>
        <source>channel Mz</source>
        <translation>Kanal Mz</translation>
    </message>
    <message>
        <source>Loads with and without compensation of interference</source>
        <translation>Lasten mit und ohne Ausgleich des Übersprechens</translation>
    </message>
    <message>
        <source>case</source>
        <translation>Fall</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>Ablesung</translation>
    </message>
    <message>
        <source>compensated</source>
        <translation>entkoppelt</translation>
    </message>
    <message>
        <source>uncompensated</source>
        <translation>nicht entkoppelt</translation>
    </message>
    <message>
        <source>by rated load</source>
        <translation>durch Nennlast</translation>
    </message>
    <message>
        <source>What interference adds without compensation</source>
        <translation>Was das Übersprechen ohne Ausgleich hinzufügt</translation>
    </message>
    <message>
        <source>per cent of rated load</source>
        <translation>Prozent der Nennlast</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>gemischt</translation>
    </message>
    <message>
        <source>all rated</source>
        <translation>alle Nennlast</translation>
    </message>
    <message>
        <source>no load</source>
        <translation>ohne Last</translation>
    </message>
    <message>
        <source>Supports in the instrument&apos;s frame and in the robot&apos;s</source>
        <translation>Auflager im Koordinatensystem des Geräts und des Roboters</translation>
    </message>
    <message>
        <source>support</source>
        <translation>Auflager</translation>
    </message>
    <message>
        <source>Scatter of a pose that the robot is sent to again</source>
        <translation>Streuung einer Pose, die der Roboter wieder anfährt</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Rotations of the flange</source>
        <translation>Drehungen des Flansches</translation>
    </message>
    <message>
        <source>about</source>
        <translation>um</translation>
    </message>
    <message>
        <source>radius of the circle</source>
        <translation>Radius des Kreises</translation>
    </message>
    <message>
        <source>least height above the supports</source>
        <translation>kleinste Höhe über den Auflagern</translation>
    </message>
    <message>
        <source>greatest height</source>
        <translation>größte Höhe</translation>
    </message>
    <message>
        <source>Sensors of the network</source>
        <translation>Sensoren des Netzes</translation>
    </message>
    <message>
        <source>reads</source>
        <translation>liest ab</translation>
    </message>
    <message>
        <source>Analysis of variance</source>
        <translation>Varianzanalyse</translation>
    </message>
    <message>
        <source>source of variation</source>
        <translation>Quelle der Streuung</translation>
    </message>
    <message>
        <source>sum of squares</source>
        <translation>Quadratsumme</translation>
    </message>
    <message>
        <source>mean square</source>
        <translation>mittleres Quadrat</translation>
    </message>
    <message>
        <source>Components of variance</source>
        <translation>Varianzkomponenten</translation>
    </message>
    <message>
        <source>Type A evaluation of observations</source>
        <translation>Ermittlung vom Typ A aus Beobachtungen</translation>
    </message>
    <message>
        <source>s of one observation</source>
        <translation>s einer Beobachtung</translation>
    </message>
    <message>
        <source>u of the mean</source>
        <translation>u des Mittelwerts</translation>
    </message>
    <message>
        <source>number of the observation</source>
        <translation>Nummer der Beobachtung</translation>
    </message>
    <message>
        <source>Points and their residuals</source>
        <translation>Punkte und ihre Residuen</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>Residuum</translation>
    </message>
    <message>
        <source>Analysis of variance of the fit</source>
        <translation>Varianzanalyse der Ausgleichung</translation>
    </message>
    <message>
        <source>Uncertainties</source>
        <translation>Unsicherheiten</translation>
    </message>
    <message>
        <source>output</source>
        <translation>Ausgangsgröße</translation>
    </message>
    <message>
        <source>U by Monte Carlo</source>
        <translation>U durch Monte Carlo</translation>
    </message>
    <message>
        <source>validated (clause 8)</source>
        <translation>validiert (Abschnitt 8)</translation>
    </message>
    <message>
        <source>cost per unit of target</source>
        <translation>Kosten je Einheit des Ziels</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>gewählt</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Rows that are kept</source>
        <translation>Zeilen, die bleiben</translation>
    </message>
    <message>
        <source>row</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>fest</translation>
    </message>
    <message>
        <source>of the candidates&apos; file</source>
        <translation>aus der Kandidatendatei</translation>
    </message>
    <message>
        <source>objective without it</source>
        <translation>Zielgröße ohne sie</translation>
    </message>
    <message>
        <source>price</source>
        <translation>Preis</translation>
    </message>
    <message>
        <source>Candidates and what they gain</source>
        <translation>Kandidaten und ihr Gewinn</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>Gewinn</translation>
    </message>
    <message>
        <source>What would be gained without the uncertainty of</source>
        <translation>Was ohne die Unsicherheit gewonnen wäre von</translation>
    </message>
    <message>
        <source>Objective and number of rows</source>
        <translation>Zielgröße und Zahl der Zeilen</translation>
    </message>
    <message>
        <source>objective</source>
        <translation>Zielgröße</translation>
    </message>
    <message>
        <source>change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>Cost and uncertainty</source>
        <translation>Kosten und Unsicherheit</translation>
    </message>
    <message>
        <source>Improvements</source>
        <translation>Verbesserungen</translation>
    </message>
    <message>
        <source>evaluation</source>
        <translation>Auswertung</translation>
    </message>
    <message>
        <source>search</source>
        <translation>Suche</translation>
    </message>
    <message>
        <source>Candidates without result</source>
        <translation>Kandidaten ohne Ergebnis</translation>
    </message>
    <message>
        <source>count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>U without %1</source>
        <translation>U ohne %1</translation>
    </message>
    <message>
        <source>Expanded uncertainty that remains when everything %1 brings in is kept constant (an ideal one), by the law of propagation</source>
        <translation>Erweiterte Unsicherheit, die bleibt, wenn alles konstant gehalten wird, was %1 einbringt (ein Ideal), nach dem Fortpflanzungsgesetz</translation>
    </message>
    <message>
        <source>Expanded uncertainty that remains when everything %1 brings in is kept constant (an ideal one), by Monte Carlo</source>
        <translation>Erweiterte Unsicherheit, die bleibt, wenn alles konstant gehalten wird, was %1 einbringt (ein Ideal), durch Monte Carlo</translation>
    </message>
    <message>
        <source>symbol of the quantity</source>
        <translation>Symbol der Größe</translation>
    </message>
    <message>
        <source>what it is</source>
        <translation>was es ist</translation>
    </message>
    <message>
        <source>estimate</source>
        <translation>Schätzwert</translation>
    </message>
    <message>
        <source>unit of estimate and uncertainty</source>
        <translation>Einheit von Schätzwert und Unsicherheit</translation>
    </message>
    <message>
        <source>uncertainty before the divisor</source>
        <translation>Unsicherheit vor dem Teiler</translation>
    </message>
    <message>
        <source>half-width of the limits</source>
        <translation>halbe Weite der Grenzen</translation>
    </message>
    <message>
        <source>divisor, coverage factor k</source>
        <translation>Teiler, Erweiterungsfaktor k</translation>
    </message>
    <message>
        <source>sensitivity coefficient</source>
        <translation>Sensitivitätskoeffizient</translation>
    </message>
    <message>
        <source>contribution to u(y)</source>
        <translation>Beitrag zu u(y)</translation>
    </message>
    <message>
        <source>where the figure comes from</source>
        <translation>woher die Zahl kommt</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>nicht gelesen</translation>
    </message>
    <message>
        <source>name of the point</source>
        <translation>Name des Punktes</translation>
    </message>
    <message>
        <source>standard uncertainty of x, y, z</source>
        <translation>Standardunsicherheit von x, y, z</translation>
    </message>
    <message>
        <source>standard uncertainty of x</source>
        <translation>Standardunsicherheit von x</translation>
    </message>
    <message>
        <source>standard uncertainty of y</source>
        <translation>Standardunsicherheit von y</translation>
    </message>
    <message>
        <source>standard uncertainty of z</source>
        <translation>Standardunsicherheit von z</translation>
    </message>
    <message>
        <source>expanded uncertainty of x, y, z, k = 2</source>
        <translation>erweiterte Unsicherheit von x, y, z, k = 2</translation>
    </message>
    <message>
        <source>expanded uncertainty of x, k = 2</source>
        <translation>erweiterte Unsicherheit von x, k = 2</translation>
    </message>
    <message>
        <source>expanded uncertainty of y, k = 2</source>
        <translation>erweiterte Unsicherheit von y, k = 2</translation>
    </message>
    <message>
        <source>expanded uncertainty of z, k = 2</source>
        <translation>erweiterte Unsicherheit von z, k = 2</translation>
    </message>
    <message>
        <source>Kind of change</source>
        <translation>Art der Änderung</translation>
    </message>
    <message>
        <source>Fields of the set-up</source>
        <translation>Felder des Aufbaus</translation>
    </message>
    <message>
        <source>Equations as evaluated</source>
        <translation>Gleichungen, wie sie ausgewertet werden</translation>
    </message>
    <message>
        <source>References</source>
        <translation>Quellen</translation>
    </message>
    <message>
        <source>Options of the evaluation</source>
        <translation>Optionen der Auswertung</translation>
    </message>
    <message>
        <source>What a calibration certificate says beside its results, with the clause of ISO/IEC 17025:2017 that asks for it.</source>
        <translation>Was ein Kalibrierschein neben seinen Ergebnissen sagt, mit dem Abschnitt von ISO/IEC 17025:2017, der es verlangt.</translation>
    </message>
    <message>
        <source>optional</source>
        <translation>optional</translation>
    </message>
    <message>
        <source>default %1</source>
        <translation>Vorgabe %1</translation>
    </message>
    <message>
        <source>Choices: </source>
        <translation>Auswahl: </translation>
    </message>
    <message>
        <source>required by %1</source>
        <translation>verlangt von %1</translation>
    </message>
    <message>
        <source>asked for by %1</source>
        <translation>erwünscht nach %1</translation>
    </message>
    <message>
        <source>integer</source>
        <translation>ganze Zahl</translation>
    </message>
    <message>
        <source>choice</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>flag</source>
        <translation>ja oder nein</translation>
    </message>
    <message>
        <source>table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>reference to an asset</source>
        <translation>Verweis auf ein Betriebsmittel</translation>
    </message>
    <message>
        <source>real number</source>
        <translation>reelle Zahl</translation>
    </message>
    <message>
        <source>Position and orientation of a moving frame in a base frame, both defined by measured points: the platform of a robot measured with a total station or laser tracker.</source>
        <translation>Position und Orientierung eines bewegten Systems in einem Basissystem, beide durch gemessene Punkte bestimmt: die Plattform eines Roboters, gemessen mit Totalstation oder Lasertracker.</translation>
    </message>
    <message>
        <source>Eq 19 is corrected: o_p − o_b must be expressed in the base frame. As printed, the pose does not depend on the orientation of the base, and U(x) of all poses is the same.</source>
        <translation>Gl. 19 ist berichtigt: o_p − o_b muss im Basissystem ausgedrückt werden. Wie gedruckt hängt die Pose nicht von der Orientierung der Basis ab, und U(x) ist für alle Posen gleich.</translation>
    </message>
    <message>
        <source>Eq 20 is corrected: R = R_bᵀ R_p. The printed R_p R_bᵀ is the same rotation expressed in frame 0.</source>
        <translation>Gl. 20 ist berichtigt: R = R_bᵀ R_p. Das gedruckte R_p R_bᵀ ist dieselbe Drehung, ausgedrückt im System 0.</translation>
    </message>
    <message>
        <source>Eqs 21-23 are corrected: as printed they are Z-Y-Z angles, undefined without tilt; the text and Table 3 use Z-Y-X angles, R = Rz(γ) Ry(β) Rx(α).</source>
        <translation>Gl. 21 bis 23 sind berichtigt: Wie gedruckt sind es Z-Y-Z-Winkel, ohne Neigung undefiniert; Text und Tabelle 3 verwenden Z-Y-X-Winkel, R = Rz(γ) Ry(β) Rx(α).</translation>
    </message>
    <message>
        <source>b₃ lies at negative y of its frame (Eq 10) and p₃ at positive y of its own (Eq 14); other arrangements can be chosen.</source>
        <translation>b₃ liegt bei negativem y seines Systems (Gl. 10) und p₃ bei positivem y des seinen (Gl. 14); andere Anordnungen können gewählt werden.</translation>
    </message>
    <message>
        <source>Typed uncertainties lie along the axes of the frame that the points define (those of the moving frame along the base&apos;s on request) and are turned into frame 0; those of an instrument lie along and across its line of sight.</source>
        <translation>Eingegebene Unsicherheiten liegen entlang der Achsen des Systems, das die Punkte definieren (die des bewegten Systems auf Wunsch entlang derer der Basis), und werden in das System 0 gedreht; die eines Messgeräts liegen längs und quer zu seiner Ziellinie.</translation>
    </message>
    <message>
        <source>Measured points of a least-squares frame are tested against their nominal coordinates: residuals, redundancy, chi-square with the full covariance of the stated uncertainties.</source>
        <translation>Gemessene Punkte eines Systems nach kleinsten Quadraten werden gegen ihre Nennkoordinaten geprüft: Residuen, Redundanz, Chi-Quadrat mit der vollen Kovarianz der angegebenen Unsicherheiten.</translation>
    </message>
    <message>
        <source>All poses of an analysis share one measurement of the base, so their results are correlated.</source>
        <translation>Alle Posen einer Analyse teilen sich eine Messung der Basis, ihre Ergebnisse sind daher korreliert.</translation>
    </message>
    <message>
        <source>The uncertainty of the mean of repeated measurements (a posteriori) is taken as that of one measurement, as in the paper: the systematic part does not average out.</source>
        <translation>Als Unsicherheit des Mittelwertes wiederholter Messungen (a posteriori) gilt wie in der Veröffentlichung die einer einzelnen Messung: Der systematische Teil mittelt sich nicht heraus.</translation>
    </message>
    <message>
        <source>Angles are undefined in gimbal lock; the set-up then warns. Rotation vector and quaternion are free of it.</source>
        <translation>Bei kardanischer Blockade sind die Winkel undefiniert; der Aufbau warnt dann. Rotationsvektor und Quaternion sind frei davon.</translation>
    </message>
    <message>
        <source>Coordinates of targets and distances between them, measured by any mix of trackers, total stations, cameras and distance meters placed in space.</source>
        <translation>Koordinaten von Zielpunkten und Abstände zwischen ihnen, gemessen mit beliebig gemischten Trackern, Totalstationen, Kameras und Distanzmessern, die im Raum stehen.</translation>
    </message>
    <message>
        <source>The uncertainty of the stations does not contribute marginally to the position of a target, as the paper says: only distances within one set-up are nearly free of it. Eq 5 is the precision of the readings; it is shown beside the total, never as the uncertainty of a position.</source>
        <translation>Die Unsicherheit der Standpunkte trägt zur Position eines Zielpunktes, anders als die Veröffentlichung sagt, nicht nur unwesentlich bei: Nur Abstände innerhalb einer Aufstellung sind fast frei davon. Gl. 5 ist die Präzision der Ablesungen; sie steht neben der Gesamtunsicherheit, nie als Unsicherheit einer Position.</translation>
    </message>
    <message>
        <source>Weights from the readings alone, as in the paper, are inefficient for positions; those with the stations are the default.</source>
        <translation>Gewichte aus den Ablesungen allein, wie in der Veröffentlichung, sind für Positionen ineffizient; die mit den Standpunkten sind die Vorgabe.</translation>
    </message>
    <message>
        <source>Eq 2 is corrected: D holds equations by readings; as printed it is transposed.</source>
        <translation>Gl. 2 ist berichtigt: D enthält Gleichungen mal Ablesungen; wie gedruckt ist sie transponiert.</translation>
    </message>
    <message>
        <source>The linearised equations have the measured angles in M: their estimate shrinks towards the sensors, the non-linear one moves outwards by half as much. It matters beyond a milliradian (3.5 mrad, cameras alone: −6.9 mm against +3.3 mm) and not for the paper&apos;s network.</source>
        <translation>Die linearisierten Gleichungen enthalten die gemessenen Winkel in M: Ihr Schätzwert schrumpft zu den Sensoren hin, der nichtlineare wandert um halb so viel nach außen. Das zählt erst über einem Milliradiant (3.5 mrad, nur Kameras: −6.9 mm gegen +3.3 mm) und nicht für das Netz der Veröffentlichung.</translation>
    </message>
    <message>
        <source>Stations are located once for a set-up: all its targets share their deviations. &quot;New set-up&quot; at a target draws them anew.</source>
        <translation>Die Standpunkte werden für eine Aufstellung einmal bestimmt: Alle ihre Zielpunkte haben deren Abweichungen gemeinsam. &quot;Neue Aufstellung&quot; bei einem Zielpunkt zieht sie neu.</translation>
    </message>
    <message>
        <source>A distance without angles has no linear equation; the non-linear estimator uses it, from the nominal coordinates as start.</source>
        <translation>Eine Distanz ohne Winkel hat keine lineare Gleichung; der nichtlineare Schätzer verwendet sie, mit den Nennkoordinaten als Startwert.</translation>
    </message>
    <message>
        <source>A calibrated length as a check is not used in the estimation: its difference is to be judged by its uncertainty. As a constraint it carries its own uncertainty; a scale that the instruments share is corrected by it.</source>
        <translation>Eine kalibrierte Länge als Prüfung geht nicht in die Schätzung ein: Ihre Differenz ist nach deren Unsicherheit zu beurteilen. Als Bedingung bringt sie ihre eigene Unsicherheit mit; ein den Messgeräten gemeinsamer Maßstab wird durch sie korrigiert.</translation>
    </message>
    <message>
        <source>With more than 600 readings in one set-up each target is estimated by itself, weighted with the stations.</source>
        <translation>Bei mehr als 600 Ablesungen in einer Aufstellung wird jeder Zielpunkt für sich geschätzt, gewichtet mit den Standpunkten.</translation>
    </message>
    <message>
        <source>Azimuths may be given with any number of whole turns.</source>
        <translation>Azimute dürfen mit beliebig vielen ganzen Umdrehungen angegeben werden.</translation>
    </message>
    <message>
        <source>The tool centre point of a robot: the flange turns about its own axes, telescopic ballbars measure where the ball at the tool goes, and planes and a sphere give the flange&apos;s axes and centre.</source>
        <translation>Der Werkzeugmittelpunkt eines Roboters: der Flansch dreht sich um seine eigenen Achsen, teleskopische Kugelstäbe messen, wohin die Kugel am Werkzeug kommt, und Ebenen und eine Kugel geben Achsen und Mittelpunkt des Flansches.</translation>
    </message>
    <message>
        <source>The paper states neither the tool, nor the flange&apos;s orientation, start angles, how the frame is made, nor how the points are averaged. With a tool of (0, 0, 100) mm, the flange pointing down, arcs from -60° to 140° and from -90° to 90° and u(L) = 1.55 µm, the published values reproduce within 1.5 % (root mean square).</source>
        <translation>Die Veröffentlichung nennt weder Werkzeug, Orientierung des Flansches und Startwinkel noch, wie das System gebildet wird oder die Punkte gemittelt werden. Mit einem Werkzeug von (0, 0, 100) mm, nach unten weisendem Flansch, Bögen von -60° bis 140° und von -90° bis 90° und u(L) = 1.55 µm werden die veröffentlichten Werte auf 1.5 % (quadratischer Mittelwert) reproduziert.</translation>
    </message>
    <message>
        <source>U(TCP): published 8.2, 11.1, 5.1 µm; here 8.16, 10.92, 5.00 µm: reproduces.</source>
        <translation>U(TCP): veröffentlicht 8.2, 11.1, 5.1 µm; hier 8.16, 10.92, 5.00 µm: reproduziert.</translation>
    </message>
    <message>
        <source>U(TCP) with an ideal robot: published 2.8, 3.7, 1.6 µm; here 2.77, 3.61, 1.57 µm: reproduces.</source>
        <translation>U(TCP) mit einem idealen Roboter: veröffentlicht 2.8, 3.7, 1.6 µm; hier 2.77, 3.61, 1.57 µm: reproduziert.</translation>
    </message>
    <message>
        <source>U of the axes&apos; angles XY, XZ, YX, YZ: published 79, 87, 59, 123 µrad; here 78.3, 87.2, 58.5, 120.6 µrad: reproduces.</source>
        <translation>U der Achsenwinkel XY, XZ, YX, YZ: veröffentlicht 79, 87, 59, 123 µrad; hier 78.3, 87.2, 58.5, 120.6 µrad: reproduziert.</translation>
    </message>
    <message>
        <source>Largest U of a point measured by the ballbars alone: published 5.7, 5.7, 2.4 µm; here 5.83, 5.72, 2.38 µm: reproduces.</source>
        <translation>Größtes U eines nur mit den Kugelstäben gemessenen Punktes: veröffentlicht 5.7, 5.7, 2.4 µm; hier 5.83, 5.72, 2.38 µm: reproduziert.</translation>
    </message>
    <message>
        <source>With the stated U(L) = 4 µm the same geometry gives U(TCP) 8.46, 11.31, 5.16 µm and points up to 7.53, 7.37, 3.07 µm: differs, because the stated 4 µm and the published points cannot both hold. U(z) of a point at most 577 mm above the supports is 2.4 µm only for U(L) near 3.1 µm; all six figures of the instrument alone are 0.78 of what 4 µm gives.</source>
        <translation>Mit dem angegebenen U(L) = 4 µm ergibt dieselbe Geometrie U(TCP) 8.46, 11.31, 5.16 µm und Punkte bis 7.53, 7.37, 3.07 µm: weicht ab, weil die angegebenen 4 µm und die veröffentlichten Punkte nicht beide gelten können. U(z) eines Punktes höchstens 577 mm über den Stützen ist nur für U(L) nahe 3.1 µm gleich 2.4 µm; alle sechs Zahlen des Messgeräts allein betragen das 0.78-Fache dessen, was 4 µm ergeben.</translation>
    </message>
    <message>
        <source>The centre of the sphere is the centre of the flange, not the tool centre point as section 4 says: its U is 5.96, 7.42, 6.94 µm.</source>
        <translation>Der Mittelpunkt der Kugelfläche ist der Mittelpunkt des Flansches, nicht der Werkzeugmittelpunkt, wie Abschnitt 4 sagt: Sein U ist 5.96, 7.42, 6.94 µm.</translation>
    </message>
    <message>
        <source>Eq 8 needs perpendicular axes, which two measured normals are not: U(x) of the tool is 8.16, 8.37 or 8.66 µm with y first, symmetric or x first.</source>
        <translation>Gl. 8 braucht senkrechte Achsen, was zwei gemessene Normalen nicht sind: U(x) des Werkzeugs ist 8.16, 8.37 oder 8.66 µm mit y zuerst, symmetrisch oder x zuerst.</translation>
    </message>
    <message>
        <source>A trial whose lengths do not meet (negative root of Eq 3) has no value: it is counted and reported.</source>
        <translation>Ein Versuch, dessen Längen sich nicht treffen (negative Wurzel in Gl. 3), hat keinen Wert: Er wird gezählt und berichtet.</translation>
    </message>
    <message>
        <source>Position and orientation of the tool of a serial robot from its geometric parameters and joint readings.</source>
        <translation>Position und Orientierung des Werkzeugs eines seriellen Roboters aus seinen geometrischen Parametern und Gelenkablesungen.</translation>
    </message>
    <message>
        <source>The paper calls the model highly non-linear. At the uncertainties of its Table 1 it is not: the law of propagation and Monte Carlo agree to 4e-5 mm in u, and the laws are normal.</source>
        <translation>Die Veröffentlichung nennt das Modell stark nichtlinear. Bei den Unsicherheiten ihrer Tabelle 1 ist es das nicht: Fortpflanzungsgesetz und Monte Carlo stimmen in u auf 4e-5 mm überein, und die Verteilungen sind normal.</translation>
    </message>
    <message>
        <source>The tolerance 0.0001 of the paper has no unit. In millimetres it would need 5e9 trials; in metres it is 0.1 mm, and 20 000 trials do.</source>
        <translation>Die Toleranz 0.0001 der Veröffentlichung hat keine Einheit. In Millimetern würde sie 5e9 Versuche brauchen; in Metern ist sie 0.1 mm, und 20 000 Versuche genügen.</translation>
    </message>
    <message>
        <source>The paper takes the parameters as uncorrelated. Parameters identified together are strongly correlated; an identified robot carries their full covariance into this analysis, which lowers u by up to a factor of 12.</source>
        <translation>Die Veröffentlichung nimmt die Parameter als unkorreliert an. Gemeinsam identifizierte Parameter sind stark korreliert; ein identifizierter Roboter bringt ihre volle Kovarianz in diese Analyse ein, was u um bis zu einem Faktor 12 senkt.</translation>
    </message>
    <message>
        <source>Of two readings of section 4.1 (0.01 rad for theta alone, or for all angles) both are reproduced; that theta matters more than alpha holds only where its standard deviation is ten times larger.</source>
        <translation>Von zwei Lesarten des Abschnitts 4.1 (0.01 rad nur für theta oder für alle Winkel) werden beide reproduziert; dass theta mehr zählt als alpha, gilt nur, wo seine Standardabweichung zehnmal größer ist.</translation>
    </message>
    <message>
        <source>Readings of the joints deviate anew at each pose; parameters and tool are the same for all poses of an analysis.</source>
        <translation>Ablesungen der Gelenke weichen bei jeder Pose neu ab; Parameter und Werkzeug sind für alle Posen einer Analyse dieselben.</translation>
    </message>
    <message>
        <source>Geometric parameters of a serial robot from points measured while one joint after the other turns (circle point analysis).</source>
        <translation>Geometrische Parameter eines seriellen Roboters aus Punkten, die gemessen werden, während sich ein Gelenk nach dem anderen dreht (Kreispunktanalyse).</translation>
    </message>
    <message>
        <source>Eq 4 is corrected: without the square its derivative by R gives R = 0.</source>
        <translation>Gl. 4 ist berichtigt: Ohne das Quadrat ergibt ihre Ableitung nach R, dass R = 0 ist.</translation>
    </message>
    <message>
        <source>2.1.3 is corrected: x_i = z_i × y_i is left-handed.</source>
        <translation>2.1.3 ist berichtigt: x_i = z_i × y_i ist linkshändig.</translation>
    </message>
    <message>
        <source>2.1.4 is corrected: alpha_i and beta_i turn z_{i−1} into z_i.</source>
        <translation>2.1.4 ist berichtigt: alpha_i und beta_i drehen z_{i−1} in z_i.</translation>
    </message>
    <message>
        <source>The auxiliary plane of Figure 2 is not defined in the paper; it must pass through O_{i−1} with the normal z_{i−1}, or d_i = 0 is impossible.</source>
        <translation>Die Hilfsebene in Bild 2 ist in der Veröffentlichung nicht definiert; sie muss mit der Normalen z_{i−1} durch O_{i−1} gehen, sonst ist d_i = 0 unmöglich.</translation>
    </message>
    <message>
        <source>Eq 1 has no plane through the origin and fails near it; total least squares is the default.</source>
        <translation>Gl. 1 kennt keine Ebene durch den Ursprung und versagt in seiner Nähe; totale kleinste Quadrate sind die Vorgabe.</translation>
    </message>
    <message>
        <source>Eq 8 is a standard deviation of the mean of repeats. The paper applies it to different ranges and numbers of points, which are no repeats: the ±10° run dominates, and the noise is counted three times. Here the covariance is that of the chosen experiment.</source>
        <translation>Gl. 8 ist eine Standardabweichung des Mittelwertes von Wiederholungen. Die Veröffentlichung wendet sie auf verschiedene Bereiche und Punktzahlen an, die keine Wiederholungen sind: Der Lauf mit ±10° überwiegt, und das Rauschen wird dreimal gezählt. Hier ist die Kovarianz die des gewählten Experiments.</translation>
    </message>
    <message>
        <source>The standard deviation falls with the square of the range (factor 30 from ±10° to ±60°) and with the root of the number of points.</source>
        <translation>Die Standardabweichung fällt mit dem Quadrat des Bereichs (Faktor 30 von ±10° bis ±60°) und mit der Wurzel der Punktzahl.</translation>
    </message>
    <message>
        <source>Parameters are strongly correlated (d_3 and alpha_3: −0.99): use their full covariance, as an identified robot does.</source>
        <translation>Parameter sind stark korreliert (d_3 und alpha_3: −0.99): Ihre volle Kovarianz verwenden, wie es ein identifizierter Roboter tut.</translation>
    </message>
    <message>
        <source>Every joint needs a ball off its axis; at the paper&apos;s flange origin joint 6 draws no circle.</source>
        <translation>Jedes Gelenk braucht eine Kugel außerhalb seiner Achse; im Flanschursprung der Veröffentlichung beschreibt Gelenk 6 keinen Kreis.</translation>
    </message>
    <message>
        <source>Geometric parameters of a serial robot by least squares from measured positions or poses of its tool, with observability, residuals and validation.</source>
        <translation>Geometrische Parameter eines seriellen Roboters nach kleinsten Quadraten aus gemessenen Positionen oder Posen seines Werkzeugs, mit Beobachtbarkeit, Residuen und Validierung.</translation>
    </message>
    <message>
        <source>The paper identifies parameters by joint trajectories; least squares on measured positions or poses is the other usual way, with the same model of the arm (Eq 5).</source>
        <translation>Die Veröffentlichung identifiziert Parameter durch Gelenkbahnen; kleinste Quadrate an gemessenen Positionen oder Posen sind der andere übliche Weg, mit demselben Modell des Arms (Gl. 5).</translation>
    </message>
    <message>
        <source>Parameters that the poses cannot tell are found by their columns of the Jacobian: each that is a combination of those before it (base, then ball or tool, then joint by joint) stays nominal and is named with its partners.</source>
        <translation>Parameter, die die Posen nicht bestimmen können, werden an ihren Spalten der Jacobi-Matrix erkannt: Jeder, der eine Kombination der vor ihm stehenden ist (Basis, dann Kugel oder Werkzeug, dann Gelenk für Gelenk), behält seinen Nennwert und wird mit seinen Partnern genannt.</translation>
    </message>
    <message>
        <source>Weights are the inverse variances of the measured coordinates. Shared deviations of an instrument and the readings of the joints do not change the weights, but are propagated in full.</source>
        <translation>Gewichte sind die inversen Varianzen der gemessenen Koordinaten. Gemeinsame Abweichungen eines Messgeräts und die Ablesungen der Gelenke ändern die Gewichte nicht, werden aber vollständig fortgepflanzt.</translation>
    </message>
    <message>
        <source>In each trial the gain of the estimates is used. It differs from a complete fit by residual times curvature, below 1e-9 m here.</source>
        <translation>In jedem Versuch wird die Verstärkung der Schätzwerte verwendet. Sie unterscheidet sich von einer vollständigen Anpassung um Residuum mal Krümmung, hier unter 1e-9 m.</translation>
    </message>
    <message>
        <source>Position alone does not tell the last joint&apos;s parameters from the place of the ball; a known base and a known ball leave more to find.</source>
        <translation>Die Position allein trennt die Parameter des letzten Gelenks nicht vom Ort der Kugel; mit bekannter Basis und bekannter Kugel ist mehr zu bestimmen.</translation>
    </message>
    <message>
        <source>The uncertainty of each channel of a multi-axis force/moment sensor, used alone or while unknown loads act on its other axes; by the GUM, with the paper&apos;s evaluation beside it.</source>
        <translation>Die Unsicherheit jedes Kanals eines mehrachsigen Kraft-/Momentensensors, allein verwendet oder während unbekannte Lasten auf seine anderen Achsen wirken; nach dem GUM, daneben die Auswertung des Aufsatzes.</translation>
    </message>
    <message>
        <source>U of the paper: 0.91, 1.22, 1.67, 1.68, 2.78, 1.20 % of rated output: reproduces.</source>
        <translation>U der Veröffentlichung: 0.91, 1.22, 1.67, 1.68, 2.78, 1.20 % des Nennkennwerts: reproduziert.</translation>
    </message>
    <message>
        <source>By the GUM (k = 2) with unknown loads on the other five axes: 1.446, 1.425, 2.123, 2.637, 2.990, 1.388 %. With all others at rated load interference alone reaches 2.70, 2.12, 3.33, 4.59, 3.70, 2.27 %, more than U of the paper for all six: its linear sum is no bound.</source>
        <translation>Nach dem GUM (k = 2) mit unbekannten Lasten auf den anderen fünf Achsen: 1.446, 1.425, 2.123, 2.637, 2.990, 1.388 %. Mit Nennlast auf allen anderen erreicht schon das Übersprechen 2.70, 2.12, 3.33, 4.59, 3.70, 2.27 %, bei allen sechs mehr als U der Veröffentlichung: Deren lineare Summe ist keine Schranke.</translation>
    </message>
    <message>
        <source>Monte Carlo intervals are a little shorter than k = 2 because a few rectangular loads dominate.</source>
        <translation>Die Monte-Carlo-Intervalle sind etwas kürzer als k = 2, weil wenige rechteckverteilte Lasten überwiegen.</translation>
    </message>
    <message>
        <source>The load on an axis is one quantity in the equations of all channels, which correlates them.</source>
        <translation>Die Last auf einer Achse ist eine einzige Größe in den Gleichungen aller Kanäle, was sie korreliert.</translation>
    </message>
    <message>
        <source>With n = 3 a standard deviation has two degrees of freedom. Used alone a channel has effective degrees of freedom between 20 and 140, because its repeatability is a small part.</source>
        <translation>Mit n = 3 hat eine Standardabweichung zwei Freiheitsgrade. Allein verwendet hat ein Kanal effektive Freiheitsgrade zwischen 20 und 140, weil seine Wiederholpräzision ein kleiner Teil ist.</translation>
    </message>
    <message>
        <source>Not covered: misalignment of the loads, creep, temperature, remounting.</source>
        <translation>Nicht erfasst: Fehlausrichtung der Lasten, Kriechen, Temperatur, erneute Montage.</translation>
    </message>
    <message>
        <source>Forces and moments that act together, from the readings of all channels of a multi-axis sensor: the calibration matrix takes the interference between them away.</source>
        <translation>Kräfte und Momente, die zusammen wirken, aus den Ablesungen aller Kanäle eines mehrachsigen Sensors: die Kalibriermatrix nimmt das Übersprechen zwischen ihnen weg.</translation>
    </message>
    <message>
        <source>Kim prints no signs of the interference: nothing can be compensated from the paper. The readings of the example have signs of their own.</source>
        <translation>Kim gibt keine Vorzeichen des Übersprechens an: Aus der Veröffentlichung lässt sich nichts kompensieren. Die Ablesungen des Beispiels haben eigene Vorzeichen.</translation>
    </message>
    <message>
        <source>U (k = 2) in % of rated load with all six axes at rated load: 0.184, 0.192, 0.152, 0.226, 0.219, 0.261; without load 0.149, 0.159, 0.144, 0.188, 0.179, 0.180. Compensation lowers the uncertainty under combined loads by a factor of 5 to 13 against U of the paper.</source>
        <translation>U (k = 2) in % der Nennlast mit allen sechs Achsen unter Nennlast: 0.184, 0.192, 0.152, 0.226, 0.219, 0.261; ohne Last 0.149, 0.159, 0.144, 0.188, 0.179, 0.180. Die Kompensation senkt die Unsicherheit unter kombinierten Lasten gegenüber U der Veröffentlichung um einen Faktor 5 bis 13.</translation>
    </message>
    <message>
        <source>Without compensation the same loads are told wrong by -0.73, +2.05, -1.42, -2.72, +2.90, -1.54 %.</source>
        <translation>Ohne Kompensation werden dieselben Lasten um -0.73, +2.05, -1.42, -2.72, +2.90, -1.54 % falsch angezeigt.</translation>
    </message>
    <message>
        <source>The machine&apos;s deviation is common to all readings under one load: a column of the matrix, and so a scale of the load on that axis.</source>
        <translation>Die Abweichung der Maschine ist allen Ablesungen unter einer Last gemeinsam: eine Spalte der Matrix und damit ein Maßstab der Last auf dieser Achse.</translation>
    </message>
    <message>
        <source>Repeatability is that of one reading, the largest of the steps; hysteresis is rectangular over the loop, in proportion to the load.</source>
        <translation>Die Wiederholpräzision ist die einer Ablesung, die größte der Stufen; die Hysterese ist rechteckverteilt über die Schleife, proportional zur Last.</translation>
    </message>
    <message>
        <source>Not covered: products of loads in the interference, misalignment of loads, creep, temperature, remounting.</source>
        <translation>Nicht erfasst: Produkte von Lasten im Übersprechen, Fehlausrichtung der Lasten, Kriechen, Temperatur, erneute Montage.</translation>
    </message>
    <message>
        <source>Sensitivity coefficients are exact (automatic differentiation); those of unknowns that equations define implicitly follow JCGM 102 6.3.</source>
        <translation>Sensitivitätskoeffizienten sind exakt (automatisches Differenzieren); die von Unbekannten, die Gleichungen implizit definieren, folgen JCGM 102 6.3.</translation>
    </message>
    <message>
        <source>JCGM 100 H.1, H.2 and JCGM 101 9.2 to 9.5, JCGM 102 9.2 to 9.4 are examples in projects/gum: covaria verify holds them against their published values.</source>
        <translation>JCGM 100 H.1, H.2 und JCGM 101 9.2 bis 9.5, JCGM 102 9.2 bis 9.4 sind Beispiele in projects/gum: covaria verify vergleicht sie mit ihren veröffentlichten Werten.</translation>
    </message>
    <message>
        <source>A straight line or polynomial through the points of a calibration by least squares, with uncertainties in y and in x: the covariance of its coefficients, its values, and the x that belong to observed y, with their uncertainties.</source>
        <translation>Eine Gerade oder ein Polynom durch die Punkte einer Kalibrierung nach kleinsten Quadraten, mit Unsicherheiten in y und in x: die Kovarianz der Koeffizienten, die Werte und die x, die zu beobachteten y gehören, mit ihren Unsicherheiten.</translation>
    </message>
    <message>
        <source>Computed with polynomials that are orthonormal over the points, so results do not depend on the origin, up to degree 10. From the residuals their coefficients are drawn from a multivariate t distribution: one estimate of the scatter, n - p degrees of freedom for every result.</source>
        <translation>Gerechnet mit Polynomen, die über den Punkten orthonormal sind, sodass Ergebnisse nicht vom Ursprung abhängen, bis Grad 10. Aus den Residuen werden ihre Koeffizienten aus einer multivariaten t-Verteilung gezogen: ein Schätzwert der Streuung, n - p Freiheitsgrade für jedes Ergebnis.</translation>
    </message>
    <message>
        <source>JCGM 100 H.3, published y₁ = −0.1712 °C, y₂ = 0.002 18, u(y₁) = 0.0029 °C, u(y₂) = 0.000 67, b(30 °C) = −0.1494 °C with u = 0.0041 °C: reproduces.</source>
        <translation>JCGM 100 H.3, veröffentlicht y₁ = −0.1712 °C, y₂ = 0.002 18, u(y₁) = 0.0029 °C, u(y₂) = 0.000 67, b(30 °C) = −0.1494 °C mit u = 0.0041 °C: reproduziert.</translation>
    </message>
    <message>
        <source>The uncertainty of b(x) is that of the curve: the scatter of a further observation is not part of it.</source>
        <translation>Die Unsicherheit von b(x) ist die der Kurve: Die Streuung einer weiteren Beobachtung gehört nicht dazu.</translation>
    </message>
    <message>
        <source>The mean of observations made on several days, with several instruments or by several operators, and an analysis of variance that says whether these have an effect.</source>
        <translation>Der Mittelwert von Beobachtungen an mehreren Tagen, mit mehreren Messgeräten oder durch mehrere Personen, und eine Varianzanalyse, die sagt, ob diese einen Einfluss haben.</translation>
    </message>
    <message>
        <source>Groups may have different numbers of observations; n_0 = (N − Σ n_j²/N)/(J − 1) is then their size in the components of variance.</source>
        <translation>Gruppen dürfen verschieden viele Beobachtungen haben; n_0 = (N − Σ n_j²/N)/(J − 1) ist dann ihre Größe in den Varianzkomponenten.</translation>
    </message>
    <message>
        <source>JCGM 100 H.5, published V̄ = 10.000 097 V, s(V̄_j) = 57 µV, s_b = 85 µV, u(V̄) = 18 µV with nine degrees of freedom, or 13 µV with 49 without an effect of the days: reproduces.</source>
        <translation>JCGM 100 H.5, veröffentlicht V̄ = 10.000 097 V, s(V̄_j) = 57 µV, s_b = 85 µV, u(V̄) = 18 µV mit neun Freiheitsgraden oder 13 µV mit 49 ohne einen Einfluss der Tage: reproduziert.</translation>
    </message>
    <message>
        <source>A plate or frame with calibrated nests, measured repeatedly where the real points will be. Its errors of indication give the uncertainty of each coordinate of a measured point.</source>
        <translation>Eine Platte oder ein Rahmen mit kalibrierten Aufnahmen, wiederholt dort gemessen, wo die wirklichen Punkte sein werden. Seine Anzeigeabweichungen liefern die Unsicherheit jeder Koordinate eines gemessenen Punktes.</translation>
    </message>
    <message>
        <source>u_i² = u_cal² + u_var,i² + u_T,i² + b_i² (Eq 2) with u_T = L_max α ΔT/√3 (Eq 3).</source>
        <translation>u_i² = u_cal² + u_var,i² + u_T,i² + b_i² (Gl. 2) mit u_T = L_max α ΔT/√3 (Gl. 3).</translation>
    </message>
    <message>
        <source>The paper draws all parts independently for each point; calibration, temperature and bias are in truth common to all points, which can be chosen.</source>
        <translation>Die Veröffentlichung zieht alle Teile für jeden Punkt unabhängig; Kalibrierung, Temperatur und Bias sind in Wahrheit allen Punkten gemeinsam, was gewählt werden kann.</translation>
    </message>
    <message>
        <source>The noise of the three points that define the artefact&apos;s frame is part of the errors of the others; the errors of the defining coordinates themselves are never observed.</source>
        <translation>Das Rauschen der drei Punkte, die das System des Prüfkörpers definieren, ist Teil der Abweichungen der anderen; die Abweichungen der definierenden Koordinaten selbst werden nie beobachtet.</translation>
    </message>
    <message>
        <source>A bar of calibrated length, measured in many positions and orientations. Its errors of indication give one figure for every coordinate of a measured point.</source>
        <translation>Ein Stab kalibrierter Länge, in vielen Positionen und Orientierungen gemessen. Seine Anzeigeabweichungen ergeben eine Zahl für jede Koordinate eines gemessenen Punktes.</translation>
    </message>
    <message>
        <source>u² = u_cal² + u_var² + u_T² + b² (Eq 5) with u_T = L α ΔT/√3 (Eq 6).</source>
        <translation>u² = u_cal² + u_var² + u_T² + b² (Gl. 5) mit u_T = L α ΔT/√3 (Gl. 6).</translation>
    </message>
    <message>
        <source>A length is a difference of two points: dividing by √2 would be consistent; the paper does not.</source>
        <translation>Eine Länge ist eine Differenz zweier Punkte: Durch √2 zu teilen wäre folgerichtig; die Veröffentlichung tut es nicht.</translation>
    </message>
    <message>
        <source>A sensor that stands somewhere and reads a distance, two angles, or some of them. Its uncertainty: each reading for itself, what all its readings share, and where it stands.</source>
        <translation>Ein Sensor, der irgendwo steht und eine Distanz, zwei Winkel oder einen Teil davon abliest. Seine Unsicherheit: jede Ablesung für sich, was alle seine Ablesungen gemeinsam haben und wo er steht.</translation>
    </message>
    <message>
        <source>The distance has the figure a + b L, each angle its own; these are independent from reading to reading. Scale, zero, index, collimation, squareness, beam offset and refraction are shared by all readings.</source>
        <translation>Die Distanz hat die Angabe a + b L, jeder Winkel seine eigene; diese sind von Ablesung zu Ablesung unabhängig. Maßstab, Nullpunkt, Index, Zielachse, Rechtwinkligkeit, Strahlversatz und Refraktion sind allen Ablesungen gemeinsam.</translation>
    </message>
    <message>
        <source>Only a sensor that reads a distance and both angles can say by itself where a point is.</source>
        <translation>Nur ein Sensor, der eine Distanz und beide Winkel abliest, kann allein sagen, wo ein Punkt ist.</translation>
    </message>
    <message>
        <source>Instruments of the project that measure the same points together. Points measured by the network keep what they share: the scale and the station of each instrument.</source>
        <translation>Messgeräte des Projekts, die dieselben Punkte gemeinsam messen. Vom Netz gemessene Punkte behalten, was sie gemeinsam haben: Maßstab und Standpunkt jedes Messgeräts.</translation>
    </message>
    <message>
        <source>A point&apos;s deviations are the least-squares gain times those of the readings and stations, linearised at the point: exact to first order, and in Monte Carlo as long as the angles&apos; deviations stay below about a milliradian.</source>
        <translation>Die Abweichungen eines Punktes sind die Verstärkung der kleinsten Quadrate mal denen der Ablesungen und Standpunkte, am Punkt linearisiert: exakt in erster Ordnung und in Monte Carlo, solange die Abweichungen der Winkel unter etwa einem Milliradiant bleiben.</translation>
    </message>
    <message>
        <source>All points that an analysis takes from the network are measured from one set-up: none of its instruments is moved or located anew between them.</source>
        <translation>Alle Punkte, die eine Analyse aus dem Netz nimmt, werden aus einer Aufstellung gemessen: Keines seiner Messgeräte wird dazwischen bewegt oder neu eingemessen.</translation>
    </message>
    <message>
        <source>A sensor contributes to a point that is in its range and field of view, and no others.</source>
        <translation>Ein Sensor trägt zu einem Punkt bei, der in seiner Reichweite und seinem Sichtfeld liegt, zu keinem anderen.</translation>
    </message>
    <message>
        <source>One figure of a data sheet for all coordinates: a standard uncertainty or a maximum permissible error.</source>
        <translation>Eine Zahl eines Datenblatts für alle Koordinaten: eine Standardunsicherheit oder eine Grenzabweichung (MPE).</translation>
    </message>
    <message>
        <source>A specification taken alike in all directions overestimates, by a factor of 2 to 5 in the paper&apos;s example; an instrument that stands somewhere (spherical instrument) is closer to the truth.</source>
        <translation>Eine in allen Richtungen gleich angenommene Spezifikation überschätzt, im Beispiel der Veröffentlichung um einen Faktor 2 bis 5; ein Messgerät, das irgendwo steht (sphärisches Messgerät), kommt der Wahrheit näher.</translation>
    </message>
    <message>
        <source>Three or more telescopic ballbars that measure the lengths from their supports to one ball at once, and with it where the ball is.</source>
        <translation>Drei oder mehr teleskopische Kugelstäbe, die die Längen von ihren Stützen zu einer Kugel zugleich messen und damit, wo die Kugel ist.</translation>
    </message>
    <message>
        <source>The supports&apos; frame follows from the lengths between them (Eqs 4 to 7), measured once: their deviations are common to all points.</source>
        <translation>Das System der Stützen folgt aus den Längen zwischen ihnen (Gl. 4 bis 7), einmal gemessen: Ihre Abweichungen sind allen Punkten gemeinsam.</translation>
    </message>
    <message>
        <source>Eq 2 as printed has Y_VC3; Y_KS3 is meant. Eq 3 has two roots; the side is a choice here.</source>
        <translation>Gl. 2 enthält im Druck Y_VC3; gemeint ist Y_KS3. Gl. 3 hat zwei Wurzeln; die Seite ist hier wählbar.</translation>
    </message>
    <message>
        <source>The paper&apos;s supports are called an equilateral triangle of 520 mm; its Table 1 is isosceles, 520 mm and 519.711 mm.</source>
        <translation>Die Stützen der Veröffentlichung heißen gleichseitiges Dreieck mit 520 mm; ihre Tabelle 1 ist gleichschenklig, 520 mm und 519.711 mm.</translation>
    </message>
    <message>
        <source>A fourth support and those after it are located by their lengths to the first three at a height that is an input of its own: lengths say nothing about a height above the plane in which all supports lie.</source>
        <translation>Eine vierte Stütze und die folgenden werden durch ihre Längen zu den ersten drei in einer Höhe bestimmt, die eine eigene Eingangsgröße ist: Längen sagen nichts über eine Höhe über der Ebene, in der alle Stützen liegen.</translation>
    </message>
    <message>
        <source>A robot as a source of uncertainty: each time it goes to a pose it misses it by a distance in a random direction, and perhaps by small rotations.</source>
        <translation>Ein Roboter als Unsicherheitsquelle: Jedes Mal, wenn er eine Pose anfährt, verfehlt er sie um einen Abstand in zufälliger Richtung und vielleicht um kleine Drehungen.</translation>
    </message>
    <message>
        <source>The paper takes the distance as rectangular in [0, r], r being the data sheet&apos;s ± 0.02 mm; u along an axis is then r/3. RP of ISO 9283 is the mean distance plus three standard deviations, which is another figure: for that law RP = 1.366 r, in a ball 1.331 r, on a sphere r, and 3.616 u for normal coordinates.</source>
        <translation>Die Veröffentlichung nimmt den Abstand als rechteckverteilt in [0, r] an, mit r gleich den ± 0.02 mm des Datenblatts; u entlang einer Achse ist dann r/3. RP nach ISO 9283 ist der mittlere Abstand plus drei Standardabweichungen, was eine andere Zahl ist: für diese Verteilung RP = 1.366 r, in einer Kugel 1.331 r, auf einer Kugelfläche r und 3.616 u für normalverteilte Koordinaten.</translation>
    </message>
    <message>
        <source>The paper leaves the orientation out. A rotation by e moves the tool by about e times its length.</source>
        <translation>Die Veröffentlichung lässt die Orientierung weg. Eine Drehung um e bewegt das Werkzeug um etwa e mal seine Länge.</translation>
    </message>
    <message>
        <source>An arm of joints that turn or slide: parameters in a Denavit-Hartenberg convention with one or more components of uncertainty each, their correlation, limits, encoders, base and tool.</source>
        <translation>Ein Arm aus Gelenken, die drehen oder schieben: Parameter in einer Denavit-Hartenberg-Konvention mit je einer oder mehreren Unsicherheitskomponenten, ihre Korrelation, Grenzen, Encoder, Basis und Werkzeug.</translation>
    </message>
    <message>
        <source>Eq. 5: T = Rz(theta) Tz(d) Tx(a) Rx(alpha) Ry(beta). Where an axis is parallel to the next, beta is a parameter and d is 0 by definition; elsewhere beta is 0.</source>
        <translation>Gl. 5: T = Rz(theta) Tz(d) Tx(a) Rx(alpha) Ry(beta). Wo eine Achse parallel zur nächsten ist, ist beta ein Parameter und d definitionsgemäß 0; sonst ist beta 0.</translation>
    </message>
    <message>
        <source>alpha and beta of a row turn the axis of the joint into that of the next (the paper&apos;s text shifts them by one joint).</source>
        <translation>alpha und beta einer Zeile drehen die Achse des Gelenks in die des nächsten (der Text der Veröffentlichung verschiebt sie um ein Gelenk).</translation>
    </message>
    <message>
        <source>The joint angle is theta plus the reading less the zero reading; a sliding joint adds its reading to d in the same way.</source>
        <translation>Der Gelenkwinkel ist theta plus Ablesung minus Nullablesung; ein Schubgelenk addiert seine Ablesung ebenso zu d.</translation>
    </message>
    <message>
        <source>Loads a multi-axis force/moment sensor with one force or moment at a time.</source>
        <translation>Belastet einen mehrachsigen Kraft-/Momentensensor mit jeweils einer Kraft oder einem Moment.</translation>
    </message>
    <message>
        <source>The uncertainty of a load is common to all readings under loads on that axis: it does not average out in the calibration matrix.</source>
        <translation>Die Unsicherheit einer Last ist allen Ablesungen unter Lasten auf dieser Achse gemeinsam: Sie mittelt sich in der Kalibriermatrix nicht heraus.</translation>
    </message>
    <message>
        <source>Up to three forces and three moments measured at once; calibrated with one load at a time, evaluated from its readings.</source>
        <translation>Bis zu drei Kräfte und drei Momente zugleich gemessen; mit jeweils einer Last kalibriert, aus seinen Ablesungen ausgewertet.</translation>
    </message>
    <message>
        <source>Tables 1 to 4 reproduce from raw readings that are consistent with them, to the printed digits, with relative uncertainties of the machine of 8.6e-4, 8.7e-4, 1.2e-5, 8.7e-4, 8.6e-4 and 1.7e-3.</source>
        <translation>Die Tabellen 1 bis 4 werden aus Rohablesungen, die mit ihnen verträglich sind, auf die gedruckten Stellen reproduziert, mit relativen Unsicherheiten der Maschine von 8.6e-4, 8.7e-4, 1.2e-5, 8.7e-4, 8.6e-4 und 1.7e-3.</translation>
    </message>
    <message>
        <source>Type B, Table 3: differs for five of six sensors, because the stated uncertainties of the machine (2.1e-4, 1.8e-4, 1.2e-5, 3.1e-4, 2.9e-4, 2.4e-4) give 0.16, 0.23, 0.28, 0.31, 0.30, 0.36 µV/V and not 0.27, 0.31, 0.28, 0.41, 0.40, 0.62. The list equals the Type A column in five places: most likely copied there.</source>
        <translation>Typ B, Tabelle 3: weicht bei fünf von sechs Sensoren ab, weil die angegebenen Unsicherheiten der Maschine (2.1e-4, 1.8e-4, 1.2e-5, 3.1e-4, 2.9e-4, 2.4e-4) 0.16, 0.23, 0.28, 0.31, 0.30, 0.36 µV/V ergeben und nicht 0.27, 0.31, 0.28, 0.41, 0.40, 0.62. Die Liste gleicht an fünf Stellen der Spalte für Typ A: höchstwahrscheinlich von dort kopiert.</translation>
    </message>
    <message>
        <source>Table 4, Mx under Fy: differs, printed 1.55 %, is 0.15 %; the largest for Mx is 1.38 %, and the difference to its U 0.30 %, not 0.13 %.</source>
        <translation>Tabelle 4, Mx unter Fy: weicht ab, gedruckt 1.55 %, ist 0.15 %; der größte Wert für Mx ist 1.38 %, und die Differenz zu seinem U ist 0.30 %, nicht 0.13 %.</translation>
    </message>
    <message>
        <source>Section 2.5 calls e_12 the output of Fy under Fx, but Table 4 divides by the rated output of the row: a row is taken as a sensor.</source>
        <translation>Abschnitt 2.5 nennt e_12 die Ausgabe von Fy unter Fx, aber Tabelle 4 teilt durch den Nennkennwert der Zeile: Eine Zeile gilt als Sensor.</translation>
    </message>
    <message>
        <source>Eq 12 adds hysteresis and interference, limits that are not standard uncertainties, to an expanded uncertainty: the sum is neither a standard uncertainty nor a coverage interval.</source>
        <translation>Gl. 12 addiert Hysterese und Übersprechen, Grenzen, die keine Standardunsicherheiten sind, zu einer erweiterten Unsicherheit: Die Summe ist weder eine Standardunsicherheit noch ein Überdeckungsintervall.</translation>
    </message>
    <message>
        <source>The largest values of Type A and Type B need not occur at the same step. Eq 5 takes the rated output at every step. In 2.1.1 &quot;h=2&quot; of My and Mz is a slip.</source>
        <translation>Die größten Werte von Typ A und Typ B müssen nicht bei derselben Stufe auftreten. Gl. 5 nimmt den Nennkennwert bei jeder Stufe. In 2.1.1 ist &quot;h=2&quot; bei My und Mz ein Versehen.</translation>
    </message>
    <message>
        <source>A surface from an STL file - the robot cell, the part, the fixture, the room - that is drawn in the scenes of all analyses. It is context only: no number depends on it.</source>
        <translation>Eine Oberfläche aus einer STL-Datei - Roboterzelle, Werkstück, Vorrichtung, Raum -, die in den Szenen aller Analysen gezeichnet wird. Sie ist nur Umgebung: Keine Zahl hängt von ihr ab.</translation>
    </message>
    <message>
        <source>The picture is fitted to what is measured, not to the mesh, which may be a whole hall.</source>
        <translation>Das Bild wird an das angepasst, was gemessen wird, nicht an das Dreiecksnetz, das eine ganze Halle sein kann.</translation>
    </message>
    <message>
        <source>A file that is missing or damaged is warned of; analyses keep their results.</source>
        <translation>Vor einer fehlenden oder beschädigten Datei wird gewarnt; Analysen behalten ihre Ergebnisse.</translation>
    </message>
    <message>
        <source>Of the certificate and the report; what was typed stays as it is.</source>
        <translation>Von Kalibrierschein und Bericht; was eingetippt wurde, bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>distributions of %1</source>
        <translation>Verteilungen: %1</translation>
    </message>
    <message>
        <source>and %1 more like these</source>
        <translation>und %1 weitere dieser Art</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was not written: %2: %3</source>
        <translation>&apos;%1&apos; wurde nicht geschrieben: %2: %3</translation>
    </message>
    <message>
        <source>it cannot be opened</source>
        <translation>sie kann nicht geöffnet werden</translation>
    </message>
    <message>
        <source>writing failed</source>
        <translation>das Schreiben ist gescheitert</translation>
    </message>
    <message>
        <source>closing failed</source>
        <translation>das Schließen ist gescheitert</translation>
    </message>
    <message>
        <source>a file cannot be created in its folder &apos;%1&apos;</source>
        <translation>im Ordner &apos;%1&apos; kann keine Datei angelegt werden</translation>
    </message>
    <message>
        <source>the permissions of the old file cannot be kept</source>
        <translation>die Rechte der alten Datei können nicht behalten werden</translation>
    </message>
    <message>
        <source>flushing to the disk failed</source>
        <translation>das Schreiben auf den Datenträger ist gescheitert</translation>
    </message>
    <message>
        <source>the new file cannot take its place</source>
        <translation>die neue Datei kann ihren Platz nicht einnehmen</translation>
    </message>
    <message>
        <source>a folder</source>
        <translation>ein Ordner</translation>
    </message>
    <message>
        <source>a pipe</source>
        <translation>eine Pipe</translation>
    </message>
    <message>
        <source>a socket</source>
        <translation>ein Socket</translation>
    </message>
    <message>
        <source>a device</source>
        <translation>ein Gerät</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be read: %2</source>
        <translation>&apos;%1&apos; kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>it is %1, not a file</source>
        <translation>es ist %1, keine Datei</translation>
    </message>
    <message>
        <source>it is not a file</source>
        <translation>es ist keine Datei</translation>
    </message>
    <message>
        <source>it is too large: files of up to %1 MB are read, it has %2 MB</source>
        <translation>zu groß: gelesen werden Dateien bis %1 MB, diese hat %2 MB</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>sie ist ein Ordner</translation>
    </message>
    <message>
        <source>unit &quot;%1&quot;: %2</source>
        <translation>Einheit &quot;%1&quot;: %2</translation>
    </message>
    <message>
        <source>a parenthesis is closed that was not opened.</source>
        <translation>eine Klammer wird geschlossen, die nicht geöffnet wurde.</translation>
    </message>
    <message>
        <source>write a product with &apos;*&apos; (&quot;N*m&quot;, &quot;W/(m*K)&quot;), not with a blank.</source>
        <translation>ein Produkt mit &apos;*&apos; schreiben (&quot;N*m&quot;, &quot;W/(m*K)&quot;), nicht mit einem Leerzeichen.</translation>
    </message>
    <message>
        <source>a parenthesis is not closed.</source>
        <translation>eine Klammer ist nicht geschlossen.</translation>
    </message>
    <message>
        <source>the exponent must be a whole number between -9 and 9, not 0 (&quot;mm^2&quot;).</source>
        <translation>der Exponent muss eine ganze Zahl von -9 bis 9 und nicht 0 sein (&quot;mm^2&quot;).</translation>
    </message>
    <message>
        <source>the exponents are too large.</source>
        <translation>die Exponenten sind zu groß.</translation>
    </message>
    <message>
        <source>a unit is missing beside &apos;*&apos;, &apos;/&apos; or a parenthesis.</source>
        <translation>neben &apos;*&apos;, &apos;/&apos; oder einer Klammer fehlt eine Einheit.</translation>
    </message>
    <message>
        <source>numbers other than 1 do not belong in a unit; put them into the value.</source>
        <translation>Zahlen außer 1 gehören nicht in eine Einheit; in den Wert einrechnen.</translation>
    </message>
    <message>
        <source>the unit &quot;%1&quot; is not known.%2</source>
        <translation>die Einheit &quot;%1&quot; ist nicht bekannt.%2</translation>
    </message>
    <message>
        <source>the text is too long for a unit.</source>
        <translation>der Text ist zu lang für eine Einheit.</translation>
    </message>
    <message>
        <source>the unit is empty: write &quot;1&quot; for a pure number.</source>
        <translation>die Einheit ist leer: &quot;1&quot; für eine reine Zahl schreiben.</translation>
    </message>
    <message>
        <source> Known units, most of them with the prefixes of the SI: %1.</source>
        <translation> Bekannte Einheiten, die meisten mit den Vorsätzen des SI: %1.</translation>
    </message>
    <message>
        <source> Did you mean %1?</source>
        <translation> Gemeint ist vielleicht %1.</translation>
    </message>
    <message>
        <source> Did you mean %1 or %2?</source>
        <translation> Gemeint ist vielleicht %1 oder %2.</translation>
    </message>
    <message>
        <source>the attached file &apos;%1&apos; is broken</source>
        <translation>die angehängte Datei &apos;%1&apos; ist beschädigt</translation>
    </message>
    <message>
        <source>the coverage probability must lie between 0 and 1.</source>
        <translation>die Überdeckungswahrscheinlichkeit muss zwischen 0 und 1 liegen.</translation>
    </message>
    <message>
        <source>the effective degrees of freedom must be greater than 0.</source>
        <translation>die effektiven Freiheitsgrade müssen größer als 0 sein.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is defined by itself here, directly or through other definitions; an equation that is to be solved is written &apos;solve %1 = 1: ... = ...&apos;, with a starting value</source>
        <translation>&apos;%1&apos; ist hier durch sich selbst definiert, unmittelbar oder über andere Definitionen; eine Gleichung, die gelöst werden soll, wird &apos;solve %1 = 1: ... = ...&apos; geschrieben, mit einem Startwert</translation>
    </message>
    <message>
        <source>the expression in columns %1-%2</source>
        <translation>der Ausdruck in den Spalten %1-%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither defined nor one of the quantities: give it a row in the table of quantities</source>
        <translation>&apos;%1&apos; ist weder definiert noch eine der Größen: eine Zeile in der Tabelle der Größen geben</translation>
    </message>
    <message>
        <source>%1 is a difference of temperatures: its unit is K, not %2</source>
        <translation>%1 ist eine Temperaturdifferenz: ihre Einheit ist K, nicht %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; would be a condition: a definition must give a number</source>
        <translation>&apos;%1&apos; wäre eine Bedingung: eine Definition muss eine Zahl ergeben</translation>
    </message>
    <message>
        <source>%1 is %2, %3 is %4: they cannot be equal</source>
        <translation>%1 ist %2, %3 ist %4: sie können nicht gleich sein</translation>
    </message>
    <message>
        <source>the equations do not depend on the unknown &apos;%1&apos;</source>
        <translation>die Gleichungen hängen nicht von der Unbekannten &apos;%1&apos; ab</translation>
    </message>
    <message>
        <source>this equation does not depend on any unknown</source>
        <translation>diese Gleichung hängt von keiner Unbekannten ab</translation>
    </message>
    <message>
        <source>this constant has no value (division by zero, or root of a negative number)</source>
        <translation>diese Konstante hat keinen Wert (Division durch null oder Wurzel einer negativen Zahl)</translation>
    </message>
    <message>
        <source>no equation defines &apos;%1&apos;</source>
        <translation>keine Gleichung definiert &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is to be given in %2, but is %3</source>
        <translation>&apos;%1&apos; ist in %2 anzugeben, ist aber %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is %2, which has no unit of its own</source>
        <translation>&apos;%1&apos; ist %2, ohne eigene Einheit</translation>
    </message>
    <message>
        <source>%1 is %2, %3 is %4</source>
        <translation>%1 ist %2, %3 ist %4</translation>
    </message>
    <message>
        <source>they cannot be added</source>
        <translation>sie können nicht addiert werden</translation>
    </message>
    <message>
        <source>they cannot be subtracted</source>
        <translation>sie können nicht subtrahiert werden</translation>
    </message>
    <message>
        <source>%1 is %2: %3</source>
        <translation>%1 ist %2: %3</translation>
    </message>
    <message>
        <source>the exponent %1 is %2: an exponent must be a pure number</source>
        <translation>der Exponent %1 ist %2: ein Exponent muss eine reine Zahl sein</translation>
    </message>
    <message>
        <source>%1 is %2: its exponent must be a constant, or the dimension would vary</source>
        <translation>%1 ist %2: der Exponent muss eine Konstante sein, sonst wäre die Dimension veränderlich</translation>
    </message>
    <message>
        <source>atan2 needs two quantities of one kind</source>
        <translation>atan2 braucht zwei Größen gleicher Art</translation>
    </message>
    <message>
        <source>a function of both needs quantities of one kind</source>
        <translation>eine Funktion von beiden braucht Größen gleicher Art</translation>
    </message>
    <message>
        <source>sin, cos and tan need an angle or a pure number</source>
        <translation>sin, cos und tan brauchen einen Winkel oder eine reine Zahl</translation>
    </message>
    <message>
        <source>an inverse function of an angle needs a pure number</source>
        <translation>eine Umkehrfunktion eines Winkels braucht eine reine Zahl</translation>
    </message>
    <message>
        <source>this function needs a pure number: divide by a quantity of the same kind</source>
        <translation>diese Funktion braucht eine reine Zahl: durch eine Größe gleicher Art teilen</translation>
    </message>
    <message>
        <source>they cannot be compared</source>
        <translation>sie können nicht verglichen werden</translation>
    </message>
    <message>
        <source>%1 is not a condition: write a comparison, as in x &gt; 0</source>
        <translation>%1 ist keine Bedingung: einen Vergleich schreiben, etwa x &gt; 0</translation>
    </message>
    <message>
        <source>a condition</source>
        <translation>eine Bedingung</translation>
    </message>
    <message>
        <source>a pure number</source>
        <translation>eine reine Zahl</translation>
    </message>
    <message>
        <source>measured in %1</source>
        <translation>gemessen in %1</translation>
    </message>
    <message>
        <source>%1 is a temperature in degC, %2 a difference of temperatures: give differences in K</source>
        <translation>%1 ist eine Temperatur in degC, %2 eine Temperaturdifferenz: Differenzen in K angeben</translation>
    </message>
    <message>
        <source>%1 is a temperature in degC, and 0 has no unit: write 0 [degC], or 0 [K] for absolute zero</source>
        <translation>%1 ist eine Temperatur in degC, und 0 hat keine Einheit: 0 [degC] schreiben oder 0 [K] für den absoluten Nullpunkt</translation>
    </message>
    <message>
        <source>%1 is a sum of temperatures in degC, which means nothing: give differences in K, or divide the sum by the number of temperatures for their mean</source>
        <translation>%1 ist eine Summe von Temperaturen in degC, was keinen Sinn ergibt: Differenzen in K angeben oder für den Mittelwert die Summe durch die Anzahl der Temperaturen teilen</translation>
    </message>
    <message>
        <source>%1 is not a condition: write a comparison, as in if(x &gt; 0, x, 0)</source>
        <translation>%1 ist keine Bedingung: einen Vergleich schreiben, etwa if(x &gt; 0, x, 0)</translation>
    </message>
    <message>
        <source>both values of &apos;if&apos; must be numbers, not conditions</source>
        <translation>beide Werte von &apos;if&apos; müssen Zahlen sein, keine Bedingungen</translation>
    </message>
    <message>
        <source>both values of &apos;if&apos; must be of one kind</source>
        <translation>beide Werte von &apos;if&apos; müssen gleicher Art sein</translation>
    </message>
    <message>
        <source>%1 is a condition: use it as the first argument of if(...)</source>
        <translation>%1 ist eine Bedingung: als erstes Argument von if(...) verwenden</translation>
    </message>
    <message>
        <source>the end of the equation</source>
        <translation>das Ende der Gleichung</translation>
    </message>
    <message>
        <source>%1 is not a function; to multiply, write &apos;*&apos;. Functions are: %2</source>
        <translation>%1 ist keine Funktion; zum Multiplizieren &apos;*&apos; schreiben. Funktionen sind: %2</translation>
    </message>
    <message>
        <source>%1 needs %2 arguments; here it has %3</source>
        <translation>%1 braucht %2 Argumente; hier sind es %3</translation>
    </message>
    <message>
        <source>%1 needs %2 to %3 arguments; here it has %4</source>
        <translation>%1 braucht %2 bis %3 Argumente; hier sind es %4</translation>
    </message>
    <message>
        <source>&apos;+&apos; stands here twice</source>
        <translation>&apos;+&apos; steht hier zweimal</translation>
    </message>
    <message>
        <source>the expression is nested more than %1 levels deep: split it into definitions</source>
        <translation>der Ausdruck ist mehr als %1 Ebenen tief verschachtelt: in Definitionen aufteilen</translation>
    </message>
    <message>
        <source>a unit in brackets belongs behind a number: 20 [degC]</source>
        <translation>eine Einheit in Klammern gehört hinter eine Zahl: 20 [degC]</translation>
    </message>
    <message>
        <source>a number, a name or a parenthesis is expected here, not %1</source>
        <translation>hier wird eine Zahl, ein Name oder eine Klammer erwartet, nicht %1</translation>
    </message>
    <message>
        <source>this parenthesis is not closed</source>
        <translation>diese Klammer ist nicht geschlossen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a function: its argument follows in parentheses</source>
        <translation>&apos;%1&apos; ist eine Funktion: ihr Argument folgt in Klammern</translation>
    </message>
    <message>
        <source>the word &apos;%1&apos; is not expected here</source>
        <translation>das Wort &apos;%1&apos; wird hier nicht erwartet</translation>
    </message>
    <message>
        <source>an operator, a comma or &apos;)&apos; is expected here, not %1</source>
        <translation>hier wird ein Operator, ein Komma oder &apos;)&apos; erwartet, nicht %1</translation>
    </message>
    <message>
        <source>this parenthesis closes nothing</source>
        <translation>diese Klammer schließt nichts</translation>
    </message>
    <message>
        <source>an equation defines one name: write &apos;y = ...&apos;; to compare, write &apos;==&apos;; an equation that is to be solved starts with &apos;solve&apos;</source>
        <translation>eine Gleichung definiert einen Namen: &apos;y = ...&apos; schreiben; zum Vergleichen &apos;==&apos; schreiben; eine zu lösende Gleichung beginnt mit &apos;solve&apos;</translation>
    </message>
    <message>
        <source>an operator is missing before %1</source>
        <translation>vor %1 fehlt ein Operator</translation>
    </message>
    <message>
        <source>%1 is not expected here</source>
        <translation>%1 wird hier nicht erwartet</translation>
    </message>
    <message>
        <source>an equation starts with the name that it defines: y = ...</source>
        <translation>eine Gleichung beginnt mit dem Namen, den sie definiert: y = ...</translation>
    </message>
    <message>
        <source>a name with its starting value is expected here: y = 1</source>
        <translation>hier wird ein Name mit seinem Startwert erwartet: y = 1</translation>
    </message>
    <message>
        <source>a function</source>
        <translation>eine Funktion</translation>
    </message>
    <message>
        <source>a word of the language</source>
        <translation>ein Wort der Sprache</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is %2: choose another name</source>
        <translation>&apos;%1&apos; ist %2: einen anderen Namen wählen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is defined twice</source>
        <translation>&apos;%1&apos; ist zweimal definiert</translation>
    </message>
    <message>
        <source>a colon is expected before the equations to be solved: solve y = 1: y^2 = x</source>
        <translation>vor den zu lösenden Gleichungen wird ein Doppelpunkt erwartet: solve y = 1: y^2 = x</translation>
    </message>
    <message>
        <source>%1 unknowns need as many equations; there are %2</source>
        <translation>%1 Unbekannte brauchen ebenso viele Gleichungen; vorhanden sind %2</translation>
    </message>
    <message>
        <source>an equals sign is expected in an equation to be solved</source>
        <translation>in einer zu lösenden Gleichung wird ein Gleichheitszeichen erwartet</translation>
    </message>
    <message>
        <source>line %1, column %2: </source>
        <translation>Zeile %1, Spalte %2: </translation>
    </message>
    <message>
        <source>line %1, columns %2-%3: </source>
        <translation>Zeile %1, Spalten %2-%3: </translation>
    </message>
    <message>
        <source>this number is too large or too small to compute with</source>
        <translation>diese Zahl ist zum Rechnen zu groß oder zu klein</translation>
    </message>
    <message>
        <source>the bracket of a unit is not closed: write &apos;]&apos; behind the unit</source>
        <translation>die Klammer einer Einheit ist nicht geschlossen: &apos;]&apos; hinter die Einheit schreiben</translation>
    </message>
    <message>
        <source>the character &apos;%1&apos; does not belong in an equation</source>
        <translation>das Zeichen &apos;%1&apos; gehört nicht in eine Gleichung</translation>
    </message>
    <message>
        <source>the equations have %1 characters; more than %2 are not read: put tables of data into assets or observations</source>
        <translation>die Gleichungen haben %1 Zeichen; mehr als %2 werden nicht gelesen: Tabellen von Daten in Betriebsmittel oder Beobachtungen stellen</translation>
    </message>
    <message>
        <source>the coverage factor k must be greater than zero</source>
        <translation>der Erweiterungsfaktor k muss größer als null sein</translation>
    </message>
    <message>
        <source>the coverage probability must lie between 0 and 100 %</source>
        <translation>die Überdeckungswahrscheinlichkeit muss zwischen 0 und 100 % liegen</translation>
    </message>
    <message>
        <source>the limits give the estimate: leave the value empty, or state a half-width</source>
        <translation>die Grenzen liefern den Schätzwert: den Wert leer lassen oder eine halbe Weite angeben</translation>
    </message>
    <message>
        <source>the lower limit is above the upper limit</source>
        <translation>die untere Grenze liegt über der oberen Grenze</translation>
    </message>
    <message>
        <source>a relative part of the permissible error needs the value of the quantity</source>
        <translation>ein relativer Anteil der Fehlergrenze braucht den Wert der Größe</translation>
    </message>
    <message>
        <source>an exponential distribution needs an estimate greater than zero</source>
        <translation>eine Exponentialverteilung braucht einen Schätzwert größer als null</translation>
    </message>
    <message>
        <source>the number of counts must be whole</source>
        <translation>die Anzahl der Zählereignisse muss ganzzahlig sein</translation>
    </message>
    <message>
        <source>the counts give the estimate: leave the value empty</source>
        <translation>die Zählung liefert den Schätzwert: den Wert leer lassen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not used by this statement: leave it empty</source>
        <translation>&apos;%1&apos; wird von dieser Angabe nicht gebraucht: leer lassen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is missing: %2</source>
        <translation>&apos;%1&apos; fehlt: %2</translation>
    </message>
    <message>
        <source>&apos;a&apos; must not be negative</source>
        <translation>&apos;a&apos; darf nicht negativ sein</translation>
    </message>
    <message>
        <source>give the degrees of freedom or the relative uncertainty of u, not both</source>
        <translation>die Freiheitsgrade oder die relative Unsicherheit von u angeben, nicht beides</translation>
    </message>
    <message>
        <source>the degrees of freedom must be greater than zero</source>
        <translation>die Freiheitsgrade müssen größer als null sein</translation>
    </message>
    <message>
        <source>the relative uncertainty of u must not be negative</source>
        <translation>die relative Unsicherheit von u darf nicht negativ sein</translation>
    </message>
    <message>
        <source>there is no statement &apos;%1&apos;</source>
        <translation>es gibt keine Angabe &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not understood here</source>
        <translation>&apos;%1&apos; wird hier nicht verstanden</translation>
    </message>
    <message>
        <source>a number is missing after &apos;%1&apos;</source>
        <translation>nach &apos;%1&apos; fehlt eine Zahl</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no way to state an uncertainty. For example: 75 nm; U = 0.3 um, k = 2; rectangular 0.5; resolution 0.01; constant</source>
        <translation>&apos;%1&apos; ist keine Angabe einer Unsicherheit. Zum Beispiel: 75 nm; U = 0,3 um, k = 2; rechteckig 0,5; Auflösung 0,01; Konstante</translation>
    </message>
    <message>
        <source>%1 has %2 figure</source>
        <translation>%1 hat %2 Zahl</translation>
    </message>
    <message>
        <source>%1 has %2 figures</source>
        <translation>%1 hat %2 Zahlen</translation>
    </message>
    <message>
        <source>a figure is missing: an expanded uncertainty needs k = ... or p = ... %</source>
        <translation>eine Zahl fehlt: eine erweiterte Unsicherheit braucht k = ... oder p = ... %</translation>
    </message>
    <message>
        <source>a figure is missing: it is noted as %1</source>
        <translation>eine Zahl fehlt: als %1 vermerkt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no part of it: it is noted as %2</source>
        <translation>&apos;%1&apos; gehört nicht dazu: als %2 vermerkt</translation>
    </message>
    <message>
        <source>it has no unit</source>
        <translation>sie hat keine Einheit</translation>
    </message>
    <message>
        <source>the second figure has no unit but %</source>
        <translation>die zweite Zahl hat keine Einheit außer %</translation>
    </message>
    <message>
        <source>the second figure has no unit</source>
        <translation>die zweite Zahl hat keine Einheit</translation>
    </message>
    <message>
        <source>the further part is one in %: write MPE 3 + 0.1 %</source>
        <translation>der weitere Teil ist einer in %: MPE 3 + 0.1 % schreiben</translation>
    </message>
    <message>
        <source>say which it is: k = ... or p = ... %</source>
        <translation>angeben, was es ist: k = ... oder p = ... %</translation>
    </message>
    <message>
        <source>a part of the value needs the value</source>
        <translation>ein Teil des Wertes braucht den Wert</translation>
    </message>
    <message>
        <source>%1 is no unit for a quantity in %2</source>
        <translation>%1 ist keine Einheit für eine Größe in %2</translation>
    </message>
    <message>
        <source>a Type A evaluation needs at least two observations.</source>
        <translation>eine Auswertung nach Typ A braucht mindestens zwei Beobachtungen.</translation>
    </message>
    <message>
        <source>one of the observations is not a finite number.</source>
        <translation>eine der Beobachtungen ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>there is no series to be pooled.</source>
        <translation>es gibt keine Reihe zum Zusammenfassen.</translation>
    </message>
    <message>
        <source>the covariance of two means needs observations made in pairs: the series have different lengths.</source>
        <translation>die Kovarianz zweier Mittelwerte braucht paarweise Beobachtungen: die Reihen sind verschieden lang.</translation>
    </message>
    <message>
        <source>the covariance of two means needs at least two pairs.</source>
        <translation>die Kovarianz zweier Mittelwerte braucht mindestens zwei Paare.</translation>
    </message>
    <message>
        <source>the components %1 and %2 are given two different correlations; a quantity that combines its components arithmetically needs +1 or -1.</source>
        <translation>die Komponenten %1 und %2 haben zwei verschiedene Korrelationen; eine Größe, die ihre Komponenten arithmetisch zusammenfasst, braucht +1 oder -1.</translation>
    </message>
    <message>
        <source>a correlation refers to component number %1 of %2.</source>
        <translation>eine Korrelation verweist auf Komponente Nummer %1 von %2.</translation>
    </message>
    <message>
        <source>a correlation is given between the component %1 and itself.</source>
        <translation>eine Korrelation ist zwischen der Komponente %1 und sich selbst angegeben.</translation>
    </message>
    <message>
        <source>the correlation of the components %1 and %2 must lie between -1 and 1.</source>
        <translation>die Korrelation der Komponenten %1 und %2 muss zwischen -1 und 1 liegen.</translation>
    </message>
    <message>
        <source>the quantity &quot;%1&quot; refers to component number %2 of %3.</source>
        <translation>die Größe &quot;%1&quot; verweist auf Komponente Nummer %2 von %3.</translation>
    </message>
    <message>
        <source>the correlations of the components %1 contradict each other: the smallest eigenvalue of their correlation matrix is %2, it must not be negative.</source>
        <translation>die Korrelationen der Komponenten %1 widersprechen einander: der kleinste Eigenwert ihrer Korrelationsmatrix ist %2, er darf nicht negativ sein.</translation>
    </message>
    <message>
        <source>the component %1 is a coordinate of a vector of random direction and cannot be correlated with another component; give it a normal distribution first.</source>
        <translation>die Komponente %1 ist eine Koordinate eines Vektors zufälliger Richtung und kann nicht mit einer anderen Komponente korreliert werden; ihr zuerst eine Normalverteilung geben.</translation>
    </message>
    <message>
        <source>the estimate of variance &quot;%1&quot; has component number %2, which does not exist or rests on two estimates.</source>
        <translation>die Varianzschätzung &quot;%1&quot; hat die Komponente Nummer %2, die es nicht gibt oder die auf zwei Schätzungen beruht.</translation>
    </message>
    <message>
        <source>the component %1 rests on the estimate of variance &quot;%2&quot; with others: it needs a normal or Student t distribution and their finite degrees of freedom.</source>
        <translation>die Komponente %1 beruht mit anderen auf der Varianzschätzung &quot;%2&quot;: sie braucht eine Normal- oder Student-t-Verteilung und deren endliche Freiheitsgrade.</translation>
    </message>
    <message>
        <source>the components %1 and %2 cannot have the correlation %3: with these distributions it lies between %4 and %5.</source>
        <translation>die Komponenten %1 und %2 können nicht die Korrelation %3 haben: mit diesen Verteilungen liegt sie zwischen %4 und %5.</translation>
    </message>
    <message>
        <source>%1 distribution: %2</source>
        <translation>Verteilung %1: %2</translation>
    </message>
    <message>
        <source>the %1 must be a finite number.</source>
        <translation>%1: eine endliche Zahl ist nötig.</translation>
    </message>
    <message>
        <source>the %1 is too large (at most 1e150).</source>
        <translation>%1: zu groß (höchstens 1e150).</translation>
    </message>
    <message>
        <source>the %1 must not be negative.</source>
        <translation>%1: negativ nicht zulässig.</translation>
    </message>
    <message>
        <source>the %1 must lie between 0.001 and 1000000.</source>
        <translation>%1: nur zwischen 0,001 und 1000000 zulässig.</translation>
    </message>
    <message>
        <source>the lower limit must not be greater than the upper limit.</source>
        <translation>die untere Grenze darf nicht größer als die obere Grenze sein.</translation>
    </message>
    <message>
        <source>the degrees of freedom must be at least 0.2 (they may be infinite).</source>
        <translation>die Freiheitsgrade müssen mindestens 0,2 betragen (sie dürfen unendlich sein).</translation>
    </message>
    <message>
        <source>the inexactness of the limits must not exceed half the distance between them.</source>
        <translation>die Ungenauigkeit der Grenzen darf nicht größer als ihr halber Abstand sein.</translation>
    </message>
    <message>
        <source>the ratio beta of top to base must lie between 0 and 1.</source>
        <translation>das Verhältnis beta von oberer Breite zu Basis muss zwischen 0 und 1 liegen.</translation>
    </message>
    <message>
        <source>one of the limits excludes every value.</source>
        <translation>eine der Grenzen schließt jeden Wert aus.</translation>
    </message>
    <message>
        <source>the mean value lies outside the limits.</source>
        <translation>der Mittelwert liegt außerhalb der Grenzen.</translation>
    </message>
    <message>
        <source>the limits lie so far from the mean value that no probability is left between them.</source>
        <translation>die Grenzen liegen so weit vom Mittelwert entfernt, dass zwischen ihnen keine Wahrscheinlichkeit bleibt.</translation>
    </message>
    <message>
        <source>mean value of the logarithm</source>
        <translation>Mittelwert des Logarithmus</translation>
    </message>
    <message>
        <source>the parameters of the logarithm are too large: the quantity has no finite variance in numbers.</source>
        <translation>die Parameter des Logarithmus sind zu groß: die Größe hat in Zahlen keine endliche Varianz.</translation>
    </message>
    <message>
        <source>a discrete distribution needs at least one value.</source>
        <translation>eine diskrete Verteilung braucht mindestens einen Wert.</translation>
    </message>
    <message>
        <source>there must be as many probabilities as values.</source>
        <translation>es muss so viele Wahrscheinlichkeiten wie Werte geben.</translation>
    </message>
    <message>
        <source>values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>probabilities</source>
        <translation>Wahrscheinlichkeiten</translation>
    </message>
    <message>
        <source>the probabilities must sum to 1.</source>
        <translation>die Summe der Wahrscheinlichkeiten muss 1 sein.</translation>
    </message>
    <message>
        <source>discrete distribution: there must be as many probabilities as values.</source>
        <translation>diskrete Verteilung: es muss so viele Wahrscheinlichkeiten wie Werte geben.</translation>
    </message>
    <message>
        <source>%1 distribution: %2 parameters are needed, %3 are given.</source>
        <translation>Verteilung %1: %2 Parameter werden gebraucht, %3 sind angegeben.</translation>
    </message>
    <message>
        <source>the distribution &quot;%1&quot; is not known. Known distributions: %2.</source>
        <translation>die Verteilung &quot;%1&quot; ist nicht bekannt. Bekannte Verteilungen: %2.</translation>
    </message>
    <message>
        <source>%1 in row %2 of %3</source>
        <translation>%1 in Zeile %2 von %3</translation>
    </message>
    <message>
        <source>greater than %1 and at most %2</source>
        <translation>größer als %1 und höchstens %2</translation>
    </message>
    <message>
        <source>between %1 and %2</source>
        <translation>zwischen %1 und %2</translation>
    </message>
    <message>
        <source>greater than %1</source>
        <translation>größer als %1</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>mindestens %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>%1 must be a whole number; it is %2</source>
        <translation>%1 muss eine ganze Zahl sein; angegeben ist %2</translation>
    </message>
    <message>
        <source>%1 is too large a number: %2</source>
        <translation>%1 ist eine zu große Zahl: %2</translation>
    </message>
    <message>
        <source>%1 must be %2; it is %3</source>
        <translation>%1 muss %2 sein; angegeben ist %3</translation>
    </message>
    <message>
        <source>%1 must be one of %2; it is %3%4</source>
        <translation>%1 muss eins von %2 sein; angegeben ist %3%4</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>one of its choices</source>
        <translation>eine der Auswahlmöglichkeiten</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>a pose</source>
        <translation>eine Pose</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>eine Tabelle</translation>
    </message>
    <message>
        <source>the id of an asset</source>
        <translation>die Kennung eines Betriebsmittels</translation>
    </message>
    <message>
        <source>%1 must be %2</source>
        <translation>%1 muss %2 sein</translation>
    </message>
    <message>
        <source>%1 needs at least 1 row; it has %2</source>
        <translation>%1 braucht mindestens 1 Zeile; vorhanden: %2</translation>
    </message>
    <message>
        <source>%1 needs at least %2 rows; it has %3</source>
        <translation>%1 braucht mindestens %2 Zeilen; vorhanden: %3</translation>
    </message>
    <message>
        <source>%1 has %2 columns, but %3 units</source>
        <translation>%1 hat %2 Spalten, aber %3 Einheiten</translation>
    </message>
    <message>
        <source>row %1 of %2 has %3 cells; there are %4 columns</source>
        <translation>Zeile %1 von %2 hat %3 Zellen; es gibt %4 Spalten</translation>
    </message>
    <message>
        <source>%1 is empty</source>
        <translation>%1 ist leer</translation>
    </message>
    <message>
        <source>%1 must not be empty</source>
        <translation>%1 darf nicht leer sein</translation>
    </message>
    <message>
        <source>%1 must be given (&apos;%2&apos; is missing)</source>
        <translation>%1 muss angegeben sein (&apos;%2&apos; fehlt)</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; is %3; its unit is missing: write &quot;%1 [%4]&quot;</source>
        <translation>Spalte &apos;%1&apos; von &apos;%2&apos; ist %3; die Einheit fehlt: &quot;%1 [%4]&quot; schreiben</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; is %3; &apos;%4&apos; is the unit of %5</source>
        <translation>Spalte &apos;%1&apos; von &apos;%2&apos; ist %3; &apos;%4&apos; ist die Einheit von etwas anderem: %5</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; is a difference of temperatures: give it in K, not in %3</source>
        <translation>Spalte &apos;%1&apos; von &apos;%2&apos; ist eine Temperaturdifferenz: in K angeben, nicht in %3</translation>
    </message>
    <message>
        <source>there is no field &apos;%1&apos; here%2</source>
        <translation>hier gibt es kein Feld &apos;%1&apos;%2</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>eine Länge</translation>
    </message>
    <message>
        <source>an area</source>
        <translation>eine Fläche</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>ein Volumen</translation>
    </message>
    <message>
        <source>a mass</source>
        <translation>eine Masse</translation>
    </message>
    <message>
        <source>a time</source>
        <translation>eine Zeit</translation>
    </message>
    <message>
        <source>a frequency</source>
        <translation>eine Frequenz</translation>
    </message>
    <message>
        <source>an electric current</source>
        <translation>eine elektrische Stromstärke</translation>
    </message>
    <message>
        <source>a temperature</source>
        <translation>eine Temperatur</translation>
    </message>
    <message>
        <source>an expansion coefficient</source>
        <translation>ein Ausdehnungskoeffizient</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>ein Winkel</translation>
    </message>
    <message>
        <source>a velocity</source>
        <translation>eine Geschwindigkeit</translation>
    </message>
    <message>
        <source>an acceleration</source>
        <translation>eine Beschleunigung</translation>
    </message>
    <message>
        <source>a force</source>
        <translation>eine Kraft</translation>
    </message>
    <message>
        <source>a moment</source>
        <translation>ein Moment</translation>
    </message>
    <message>
        <source>a pressure</source>
        <translation>ein Druck</translation>
    </message>
    <message>
        <source>a stiffness</source>
        <translation>eine Steifigkeit</translation>
    </message>
    <message>
        <source>a voltage</source>
        <translation>eine Spannung</translation>
    </message>
    <message>
        <source>an electric resistance</source>
        <translation>ein elektrischer Widerstand</translation>
    </message>
    <message>
        <source>an electric charge</source>
        <translation>eine elektrische Ladung</translation>
    </message>
    <message>
        <source>a capacitance</source>
        <translation>eine Kapazität</translation>
    </message>
    <message>
        <source>an inductance</source>
        <translation>eine Induktivität</translation>
    </message>
    <message>
        <source>a magnetic flux density</source>
        <translation>eine magnetische Flussdichte</translation>
    </message>
    <message>
        <source>a magnetic flux</source>
        <translation>ein magnetischer Fluss</translation>
    </message>
    <message>
        <source>a power</source>
        <translation>eine Leistung</translation>
    </message>
    <message>
        <source>an amount of substance</source>
        <translation>eine Stoffmenge</translation>
    </message>
    <message>
        <source>a luminous intensity</source>
        <translation>eine Lichtstärke</translation>
    </message>
    <message>
        <source>an angular velocity</source>
        <translation>eine Winkelgeschwindigkeit</translation>
    </message>
    <message>
        <source>a density</source>
        <translation>eine Dichte</translation>
    </message>
    <message>
        <source> (did you mean &apos;%1&apos;?)</source>
        <translation> (gemeint: &apos;%1&apos;?)</translation>
    </message>
    <message>
        <source>%1 must be a finite number; it is %2</source>
        <translation>%1 muss eine endliche Zahl sein; angegeben ist %2</translation>
    </message>
    <message>
        <source>%1 is too large to be computed with (at most 1e100): it is %2</source>
        <translation>%1 ist zu groß zum Rechnen (höchstens 1e100): angegeben ist %2</translation>
    </message>
    <message>
        <source>%1 is %2; %3 has no unit</source>
        <translation>%1 ist %2; %3 hat keine Einheit</translation>
    </message>
    <message>
        <source>%1 is %2; %3 is %4</source>
        <translation>%1 ist %2; %3 ist %4</translation>
    </message>
    <message>
        <source>%1 is a difference of temperatures: give it in K, not in %2</source>
        <translation>%1 ist eine Temperaturdifferenz: in K angeben, nicht in %2</translation>
    </message>
    <message>
        <source>the result does not represent the measurand: more than 1 % of the trials have no value</source>
        <translation>das Ergebnis stellt die Messgröße nicht dar: mehr als 1 % der Versuche haben keinen Wert</translation>
    </message>
    <message>
        <source>U = k u with the coverage factor that was fixed.</source>
        <translation>U = k u mit dem festgelegten Erweiterungsfaktor.</translation>
    </message>
    <message>
        <source>U is half the width of the probabilistically symmetric coverage interval, and k = U/u.</source>
        <translation>U ist die halbe Breite des wahrscheinlichkeitssymmetrischen Überdeckungsintervalls, und k = U/u.</translation>
    </message>
    <message>
        <source>U = k u with k of the t distribution for the effective degrees of freedom.</source>
        <translation>U = k u mit k der t-Verteilung für die effektiven Freiheitsgrade.</translation>
    </message>
    <message>
        <source>the number of significant digits of the numerical tolerance must be 1, 2, 3 or 4</source>
        <translation>die Anzahl der signifikanten Stellen der numerischen Toleranz muss 1, 2, 3 oder 4 sein</translation>
    </message>
    <message>
        <source>the numerical tolerance must be greater than zero</source>
        <translation>die numerische Toleranz muss größer als null sein</translation>
    </message>
    <message>
        <source>the adaptive procedure needs at least two batches</source>
        <translation>das adaptive Verfahren braucht mindestens zwei Blöcke</translation>
    </message>
    <message>
        <source>the adaptive procedure needs at least two batches: allow %1 trials or more</source>
        <translation>das adaptive Verfahren braucht mindestens zwei Blöcke: %1 oder mehr Versuche zulassen</translation>
    </message>
    <message>
        <source>a Monte Carlo run needs at least two trials</source>
        <translation>ein Monte-Carlo-Lauf braucht mindestens zwei Versuche</translation>
    </message>
    <message>
        <source>the coverage probability must lie between 0 and 1</source>
        <translation>die Überdeckungswahrscheinlichkeit muss zwischen 0 und 1 liegen</translation>
    </message>
    <message>
        <source>the coverage probability is too near to 1</source>
        <translation>die Überdeckungswahrscheinlichkeit liegt zu nahe bei 1</translation>
    </message>
    <message>
        <source>the coverage factor must be greater than zero</source>
        <translation>der Erweiterungsfaktor muss größer als null sein</translation>
    </message>
    <message>
        <source>one-at-a-time Monte Carlo needs at least two trials</source>
        <translation>Monte Carlo mit einzelnen Beitragenden braucht mindestens zwei Versuche</translation>
    </message>
    <message>
        <source>Monte Carlo without a contributor needs at least two trials</source>
        <translation>Monte Carlo ohne einen Beitragenden braucht mindestens zwei Versuche</translation>
    </message>
    <message>
        <source>Sobol indices need at least 100 trials</source>
        <translation>Sobol-Indizes brauchen mindestens 100 Versuche</translation>
    </message>
    <message>
        <source>the evaluation was stopped</source>
        <translation>die Auswertung wurde abgebrochen</translation>
    </message>
    <message>
        <source>none of the trials has a value: the measurement model cannot be evaluated within the uncertainties of its inputs; check the standard uncertainties and the geometry</source>
        <translation>keiner der Versuche hat einen Wert: das Messmodell ist innerhalb der Unsicherheiten seiner Eingangsgrößen nicht auswertbar; die Standardunsicherheiten und die Geometrie prüfen</translation>
    </message>
    <message>
        <source>the linear part explains %1 % of the variance: a gain of %2</source>
        <translation>der lineare Teil erklärt %1 % der Varianz: ein Gewinn von %2</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>no trial has a value</source>
        <translation>kein Versuch hat einen Wert</translation>
    </message>
    <message>
        <source>the measurement model has no sensitivity coefficients near the estimates: second-order terms do not exist</source>
        <translation>das Messmodell hat nahe den Schätzwerten keine Sensitivitätskoeffizienten: Glieder zweiter Ordnung existieren nicht</translation>
    </message>
    <message>
        <source>there are too many quantities for them</source>
        <translation>dafür gibt es zu viele Größen</translation>
    </message>
    <message>
        <source>the degrees of freedom of %1 must be greater than zero</source>
        <translation>die Freiheitsgrade von %1 müssen größer als null sein</translation>
    </message>
    <message>
        <source>the degrees of freedom of %1 are too few: there must be at least 0.2</source>
        <translation>die Freiheitsgrade von %1 sind zu wenige: es müssen mindestens 0,2 sein</translation>
    </message>
    <message>
        <source>the distribution of %1 has no finite mean or standard uncertainty</source>
        <translation>die Verteilung von %1 hat keinen endlichen Mittelwert oder keine endliche Standardunsicherheit</translation>
    </message>
    <message>
        <source>the estimate of %1 is not a finite number</source>
        <translation>der Schätzwert von %1 ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>quantity %1 refers to a component that does not exist, or with a factor that is not finite</source>
        <translation>Größe %1 verweist auf eine Komponente, die nicht existiert, oder mit einem nicht endlichen Faktor</translation>
    </message>
    <message>
        <source>the measurement model has %1 input quantities, but %2 were given</source>
        <translation>das Messmodell hat %1 Eingangsgrößen, angegeben sind aber %2</translation>
    </message>
    <message>
        <source>the measurement model has no output quantities</source>
        <translation>das Messmodell hat keine Ausgangsgrößen</translation>
    </message>
    <message>
        <source>its correlated components are not normally distributed</source>
        <translation>die korrelierten Komponenten sind nicht normalverteilt</translation>
    </message>
    <message>
        <source>no spread</source>
        <translation>keine Streuung</translation>
    </message>
    <message>
        <source>normal as far as so few trials can tell</source>
        <translation>normal, soweit so wenige Versuche es sagen können</translation>
    </message>
    <message>
        <source>normal within 1 %</source>
        <translation>normal auf 1 %</translation>
    </message>
    <message>
        <source>normal within 5 %</source>
        <translation>normal auf 5 %</translation>
    </message>
    <message>
        <source>too skewed for k u</source>
        <translation>zu schief für k u</translation>
    </message>
    <message>
        <source>too heavy-tailed for k u</source>
        <translation>zu schwer an den Rändern für k u</translation>
    </message>
    <message>
        <source>too flat for k u</source>
        <translation>zu flach für k u</translation>
    </message>
    <message>
        <source>Second-order terms are left out: the formula of JCGM 100 5.1.2 assumes independent components, and some of these are correlated.</source>
        <translation>Glieder zweiter Ordnung werden weggelassen: die Formel von JCGM 100 5.1.2 setzt unabhängige Komponenten voraus, und einige davon sind korreliert.</translation>
    </message>
    <message>
        <source>Second-order terms are left out: %1.</source>
        <translation>Glieder zweiter Ordnung werden weggelassen: %1.</translation>
    </message>
    <message>
        <source>%1 of %2 trials (%3 %) have no value (the measurement model cannot be evaluated there) and are not part of the statistics.</source>
        <translation>%1 von %2 Versuchen (%3 %) haben keinen Wert (das Messmodell kann dort nicht ausgewertet werden) und gehören nicht zur Statistik.</translation>
    </message>
    <message>
        <source>The result does not represent the measurand: more than 1 % of the trials are lost, and they are not a random choice.</source>
        <translation>Das Ergebnis stellt die Messgröße nicht dar: mehr als 1 % der Versuche sind verloren, und sie sind keine zufällige Auswahl.</translation>
    </message>
    <message>
        <source>The adaptive procedure stopped at %1 trials before its results were stable: allow more trials, or ask for fewer significant digits.</source>
        <translation>Das adaptive Verfahren hielt bei %1 Versuchen an, bevor seine Ergebnisse stabil waren: mehr Versuche zulassen oder weniger signifikante Stellen verlangen.</translation>
    </message>
    <message>
        <source>Coverage intervals are interpolated in fine cells: there are too many trials to keep the values of the tails in memory.</source>
        <translation>Überdeckungsintervalle werden in feinen Zellen interpoliert: es sind zu viele Versuche, um die Werte der Ausläufer im Speicher zu halten.</translation>
    </message>
    <message>
        <source>The correlations stated cannot all hold with these distributions: the nearest that can are drawn, with coefficients that differ by up to %1.</source>
        <translation>Die angegebenen Korrelationen können mit diesen Verteilungen nicht alle gelten: gezogen werden die nächsten, die es können, mit Koeffizienten, die um bis zu %1 abweichen.</translation>
    </message>
    <message>
        <source>The angle %1%2 is hardly determined: its standard uncertainty exceeds 1 rad.</source>
        <translation>Der Winkel %1%2 ist kaum bestimmt: seine Standardunsicherheit übersteigt 1 rad.</translation>
    </message>
    <message>
        <source>Nothing is gained by variance reduction, and standard errors are not known: there are fewer than %1 batches of %2 trials.</source>
        <translation>Die Varianzreduktion bringt keinen Gewinn, und Standardfehler sind nicht bekannt: es gibt weniger als %1 Blöcke zu %2 Versuchen.</translation>
    </message>
    <message>
        <source>Control variates are not used: the linear part of the trials that have a value has another distribution than that of all trials.</source>
        <translation>Kontrollvariaten werden nicht verwendet: der lineare Anteil der Versuche, die einen Wert haben, hat eine andere Verteilung als der aller Versuche.</translation>
    </message>
    <message>
        <source>Without control variate: %1.</source>
        <translation>Ohne Kontrollvariate: %1.</translation>
    </message>
    <message>
        <source>The standard uncertainty by Monte Carlo of %1 does not exist, because a Student t distribution with two degrees of freedom or fewer has no finite standard deviation: it is shown as infinite, and U is half the width of the coverage interval.</source>
        <translation>Die Standardunsicherheit von %1 nach Monte Carlo existiert nicht, weil eine Student-t-Verteilung mit zwei oder weniger Freiheitsgraden keine endliche Standardabweichung hat: sie wird als unendlich angezeigt, und U ist die halbe Weite des Überdeckungsintervalls.</translation>
    </message>
    <message>
        <source>The standard uncertainty by Monte Carlo of %1 cannot stabilise, because Student t distributions with four degrees of freedom or fewer have no finite fourth moment: the adaptive procedure judges by the coverage intervals; use these.</source>
        <translation>Die Standardunsicherheit von %1 nach Monte Carlo kann nicht stabil werden, weil Student-t-Verteilungen mit vier oder weniger Freiheitsgraden kein endliches viertes Moment haben: das adaptive Verfahren urteilt nach den Überdeckungsintervallen; diese verwenden.</translation>
    </message>
    <message>
        <source>the measurement model has no value at the estimates of its input quantities%1: check the nominal geometry and the values entered</source>
        <translation>das Messmodell hat bei den Schätzwerten seiner Eingangsgrößen keinen Wert%1: die Nenngeometrie und die eingegebenen Werte prüfen</translation>
    </message>
    <message>
        <source>Effective degrees of freedom are approximate: the Welch-Satterthwaite formula assumes independent components, and correlated components with finite degrees of freedom contribute. The Monte Carlo coverage interval is the better guide.</source>
        <translation>Die effektiven Freiheitsgrade sind genähert: die Welch-Satterthwaite-Formel setzt unabhängige Komponenten voraus, und korrelierte Komponenten mit endlichen Freiheitsgraden tragen bei. Das Überdeckungsintervall nach Monte Carlo ist der bessere Anhalt.</translation>
    </message>
    <message>
        <source>1 vector of random direction has coordinates with different distributions after editing: they are drawn independently.</source>
        <translation>1 Vektor zufälliger Richtung hat nach der Bearbeitung Koordinaten mit verschiedenen Verteilungen: sie werden unabhängig gezogen.</translation>
    </message>
    <message>
        <source>%1 vectors of random direction have coordinates with different distributions after editing: they are drawn independently.</source>
        <translation>%1 Vektoren zufälliger Richtung haben nach der Bearbeitung Koordinaten mit verschiedenen Verteilungen: sie werden unabhängig gezogen.</translation>
    </message>
    <message>
        <source>The angle %1 is hardly determined: its standard uncertainty by the law of propagation exceeds 1 rad.</source>
        <translation>Der Winkel %1 ist kaum bestimmt: seine Standardunsicherheit nach dem Fortpflanzungsgesetz übersteigt 1 rad.</translation>
    </message>
    <message>
        <source>a tolerance of %1 %2 for %3 (u = %4 %2) needs about %5 trials (%6 batches)</source>
        <translation>eine Toleranz von %1 %2 für %3 (u = %4 %2) braucht etwa %5 Versuche (%6 Blöcke)</translation>
    </message>
    <message>
        <source>to correct the bias of coordinate %1, give the number of observations n in its row: the uncertainty of the correction is u_var/sqrt(n)</source>
        <translation>um die Abweichung der Koordinate %1 zu korrigieren, in ihrer Zeile die Anzahl n der Beobachtungen angeben: die Unsicherheit der Korrektion ist u_var/sqrt(n)</translation>
    </message>
    <message>
        <source>there are two points called &apos;%1&apos;; rename one</source>
        <translation>zwei Punkte heißen &apos;%1&apos;; einen umbenennen</translation>
    </message>
    <message>
        <source>there is no calibrated point called &apos;%1&apos;</source>
        <translation>es gibt keinen kalibrierten Punkt mit dem Namen &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must consist of the letters x, y and z</source>
        <translation>&apos;%1&apos; muss aus den Buchstaben x, y und z bestehen</translation>
    </message>
    <message>
        <source>coordinate %1 has fewer than two observations that do not define the frame: measure more points or runs</source>
        <translation>Koordinate %1 hat weniger als zwei Beobachtungen, die das System nicht festlegen: mehr Punkte oder Läufe messen</translation>
    </message>
    <message>
        <source>coordinate %1 has %2 rows; it must have one</source>
        <translation>Koordinate %1 hat %2 Zeilen; sie muss eine haben</translation>
    </message>
    <message>
        <source>the length standard needs at least two observations</source>
        <translation>das Längennormal braucht mindestens zwei Beobachtungen</translation>
    </message>
    <message>
        <source>the table must have one row; it has %1</source>
        <translation>die Tabelle muss eine Zeile haben; vorhanden: %1</translation>
    </message>
    <message>
        <source>the analysis has no point called &apos;%1&apos;</source>
        <translation>die Analyse hat keinen Punkt mit dem Namen &apos;%1&apos;</translation>
    </message>
    <message>
        <source>point %1: %2</source>
        <translation>Punkt %1: %2</translation>
    </message>
    <message>
        <source>it is at the place of the instrument</source>
        <translation>er liegt am Ort des Messgeräts</translation>
    </message>
    <message>
        <source>it is out of the range or field of view of the instrument</source>
        <translation>er liegt außerhalb der Reichweite oder des Sichtfelds des Messgeräts</translation>
    </message>
    <message>
        <source>correlated coordinates of a station are combinations of independent deviations, which are normal: leave the distribution normal, or the correlation out</source>
        <translation>korrelierte Koordinaten eines Standpunktes sind Kombinationen unabhängiger Abweichungen, die normalverteilt sind: die Verteilung bei normal belassen oder die Korrelation weglassen</translation>
    </message>
    <message>
        <source>a coordinate of the station is correlated with itself; name two different ones</source>
        <translation>eine Koordinate des Standpunktes ist mit sich selbst korreliert; zwei verschiedene nennen</translation>
    </message>
    <message>
        <source>the range ends before it begins: the longest distance must be greater than the shortest</source>
        <translation>der Bereich endet, bevor er beginnt: die längste Distanz muss größer als die kürzeste sein</translation>
    </message>
    <message>
        <source>the sensor reads nothing: choose a distance or an angle</source>
        <translation>der Sensor liest nichts: eine Distanz oder einen Winkel wählen</translation>
    </message>
    <message>
        <source>these coefficients are not possible together: their matrix has a negative eigenvalue</source>
        <translation>diese Koeffizienten sind zusammen nicht möglich: ihre Matrix hat einen negativen Eigenwert</translation>
    </message>
    <message>
        <source>it is at the place of %1</source>
        <translation>er liegt am Ort von %1</translation>
    </message>
    <message>
        <source>no sensor of the network sees it</source>
        <translation>kein Sensor des Netzes sieht ihn</translation>
    </message>
    <message>
        <source>it cannot be localised from what %1 read: the readings leave a direction undetermined; add a sensor or a reading</source>
        <translation>aus dem, was %1 ablesen, kann er nicht bestimmt werden: die Ablesungen lassen eine Richtung offen; einen Sensor oder eine Ablesung hinzufügen</translation>
    </message>
    <message>
        <source>the readings do not lead to a position of every target: the estimation does not converge from the nominal coordinates; look for exchanged or mistyped readings</source>
        <translation>die Ablesungen führen nicht zu einer Lage jedes Zielpunktes: die Schätzung konvergiert von den Nennkoordinaten aus nicht; nach vertauschten oder vertippten Ablesungen suchen</translation>
    </message>
    <message>
        <source>%1 looks away from target %2: its angles point to the opposite side</source>
        <translation>%1 blickt von Zielpunkt %2 weg: die Winkel zeigen zur entgegengesetzten Seite</translation>
    </message>
    <message>
        <source>there is no target %1</source>
        <translation>es gibt keinen Zielpunkt %1</translation>
    </message>
    <message>
        <source>%1 does not see target %2: it is out of its range or field of view</source>
        <translation>%1 sieht Zielpunkt %2 nicht: er liegt außerhalb der Reichweite oder des Sichtfelds</translation>
    </message>
    <message>
        <source>%1 does not see %2 of the %3 targets: they are out of its range or field of view</source>
        <translation>%1 sieht %2 der %3 Zielpunkte nicht: sie liegen außerhalb der Reichweite oder des Sichtfelds</translation>
    </message>
    <message>
        <source>the sensor %1 is not listed in the network</source>
        <translation>der Sensor %1 ist im Netz nicht aufgeführt</translation>
    </message>
    <message>
        <source>%1 reads no %2 according to its description</source>
        <translation>%1 liest nach seiner Beschreibung keine Größe %2</translation>
    </message>
    <message>
        <source>more than %1 rows for target %2</source>
        <translation>mehr als %1 Zeilen für Zielpunkt %2</translation>
    </message>
    <message>
        <source>target %1 is at the place of %2</source>
        <translation>Zielpunkt %1 ist am Ort von %2</translation>
    </message>
    <message>
        <source>target %1 is behind the camera %2</source>
        <translation>Zielpunkt %1 ist hinter der Kamera %2</translation>
    </message>
    <message>
        <source>a network has at most %1 sensors; divide it into several analyses</source>
        <translation>ein Netz hat höchstens %1 Sensoren; auf mehrere Analysen aufteilen</translation>
    </message>
    <message>
        <source>two targets are called %1</source>
        <translation>zwei Zielpunkte heißen %1</translation>
    </message>
    <message>
        <source>a distance needs two targets at different places</source>
        <translation>eine Distanz braucht zwei Zielpunkte an verschiedenen Orten</translation>
    </message>
    <message>
        <source>a calibrated length needs two targets at different places</source>
        <translation>eine kalibrierte Länge braucht zwei Zielpunkte an verschiedenen Orten</translation>
    </message>
    <message>
        <source>the calibrated length is missing</source>
        <translation>die kalibrierte Länge fehlt</translation>
    </message>
    <message>
        <source>the nominal targets of the %1 are at another distance than its calibrated length; the design takes their distance</source>
        <translation>die Nennlagen der Zielpunkte (%1) haben einen anderen Abstand als die kalibrierte Länge; die Planung nimmt ihren Abstand</translation>
    </message>
    <message>
        <source>a calibrated length can be a constraint only of the non-linear estimator with weights from readings and stations</source>
        <translation>eine kalibrierte Länge kann nur beim nichtlinearen Schätzer mit Gewichten aus Ablesungen und Standpunkten eine Bedingung sein</translation>
    </message>
    <message>
        <source>the targets of the %1 belong to two set-ups, which are estimated one after the other: it can only be a check</source>
        <translation>die Zielpunkte (%1) gehören zu zwei Aufstellungen, die nacheinander geschätzt werden: nur als Prüfung möglich</translation>
    </message>
    <message>
        <source>the targets of an angle must be at three places off one line: at 0° and 180° an angle has no sign and no derivative</source>
        <translation>die Zielpunkte eines Winkels müssen an drei Orten sein, die nicht auf einer Geraden liegen: bei 0° und 180° hat ein Winkel kein Vorzeichen und keine Ableitung</translation>
    </message>
    <message>
        <source>the name %1 is taken by another frame or a target</source>
        <translation>der Name %1 ist durch ein anderes System oder einen Zielpunkt vergeben</translation>
    </message>
    <message>
        <source>the three targets of frame %1 lie on one line: its axes are undefined</source>
        <translation>die drei Zielpunkte des Systems %1 liegen auf einer Geraden: seine Achsen sind unbestimmt</translation>
    </message>
    <message>
        <source>the x-axis of frame %1 is vertical: its Z-Y-X angles are undefined (gimbal lock)</source>
        <translation>die x-Achse des Systems %1 ist senkrecht: seine Z-Y-X-Winkel sind unbestimmt (Gimbal Lock)</translation>
    </message>
    <message>
        <source>scale bar %1 – %2</source>
        <translation>Maßstab %1 – %2</translation>
    </message>
    <message>
        <source>the sensor %1 is listed twice</source>
        <translation>der Sensor %1 ist zweimal aufgeführt</translation>
    </message>
    <message>
        <source>%1 The residuals are larger than the uncertainties allow; the largest for its uncertainty is the %2. Look for mistyped or exchanged readings, or figures of the instruments that are too small</source>
        <translation>%1 Die Residuen sind größer, als die Unsicherheiten zulassen; das größte im Verhältnis zu seiner Unsicherheit ist: %2. Nach vertippten oder vertauschten Ablesungen suchen oder nach zu kleinen Zahlen der Messgeräte</translation>
    </message>
    <message>
        <source>distance of %1 by %2</source>
        <translation>Abstand von %1 durch %2</translation>
    </message>
    <message>
        <source>azimuth of %1 by %2</source>
        <translation>Azimut von %1 durch %2</translation>
    </message>
    <message>
        <source>elevation of %1 by %2</source>
        <translation>Höhenwinkel von %1 durch %2</translation>
    </message>
    <message>
        <source>length of the %1</source>
        <translation>Länge: %1</translation>
    </message>
    <message>
        <source>Chi-square of the residuals: %1 with %2 degrees of freedom, p = %3.</source>
        <translation>Chi-Quadrat der Residuen: %1 mit %2 Freiheitsgraden, p = %3.</translation>
    </message>
    <message>
        <source>no sensor</source>
        <translation>kein Sensor</translation>
    </message>
    <message>
        <source>target %1 has no linear equations that localise it (a distance without angles has none): use the non-linear estimator</source>
        <translation>Zielpunkt %1 hat keine linearen Gleichungen, die ihn lokalisieren (eine Distanz ohne Winkel hat keine): den nichtlinearen Schätzer verwenden</translation>
    </message>
    <message>
        <source>target %1 cannot be localised from what %2 read: the readings leave a direction undetermined; add a sensor or a reading</source>
        <translation>Zielpunkt %1 kann aus den Ablesungen von %2 nicht lokalisiert werden: sie lassen eine Richtung unbestimmt; einen Sensor oder eine Ablesung hinzufügen</translation>
    </message>
    <message>
        <source>target %1 is hardly localised: in one direction u is %2 m at a distance of %3 m</source>
        <translation>Zielpunkt %1 ist kaum lokalisiert: in einer Richtung ist u gleich %2 m bei einem Abstand von %3 m</translation>
    </message>
    <message>
        <source>the stations that measure target %1 lie in one plane and read distances only: its mirror image behind that plane fits as well; the one near the nominal coordinates is taken</source>
        <translation>die Standpunkte, die Zielpunkt %1 messen, liegen in einer Ebene und lesen nur Distanzen: sein Spiegelbild hinter dieser Ebene passt ebenso; genommen wird der Ort nahe den Nennkoordinaten</translation>
    </message>
    <message>
        <source>a calibrated length cannot be a constraint of a set-up with more than %1 readings (this one has %2): make it a check</source>
        <translation>eine kalibrierte Länge kann keine Bedingung einer Aufstellung mit mehr als %1 Ablesungen sein (diese hat %2): als Prüfung verwenden</translation>
    </message>
    <message>
        <source>the %1 readings of one set-up are too many to be weighed together: each target is estimated from its own readings, weighted with the stations</source>
        <translation>die %1 Ablesungen einer Aufstellung sind zu viele für eine gemeinsame Gewichtung: jeder Zielpunkt wird aus seinen eigenen Ablesungen geschätzt, mit den Standpunkten gewichtet</translation>
    </message>
    <message>
        <source>the standard uncertainty of a coordinate, %1 mm, is more than a tenth of the distance of point %2 from the x-axis, %3 mm: the law of propagation is not reliable here, look at Monte Carlo</source>
        <translation>die Standardunsicherheit einer Koordinate, %1 mm, ist mehr als ein Zehntel des Abstands von Punkt %2 zur x-Achse, %3 mm: das Fortpflanzungsgesetz ist hier nicht zuverlässig, Monte Carlo ansehen</translation>
    </message>
    <message>
        <source>the frame made from these points lies %1 mm and %2° away from the axes in which they are given, so results differ from the table of poses; check the side of point 3 and the shift of the origin</source>
        <translation>das aus diesen Punkten gebildete System liegt %1 mm und %2° neben den Achsen, in denen sie angegeben sind, daher weichen Ergebnisse von der Tabelle der Posen ab; die Seite von Punkt 3 und die Verschiebung des Ursprungs prüfen</translation>
    </message>
    <message>
        <source>%1: beta is within 2° of ±90°, where Z-Y-X angles are undefined (gimbal lock); state the orientation as a rotation vector</source>
        <translation>%1: beta liegt innerhalb von 2° um ±90°, wo Z-Y-X-Winkel unbestimmt sind (Gimbal Lock); die Orientierung als Drehvektor angeben</translation>
    </message>
    <message>
        <source>%1: beta is within 2° of 0° or 180°, where Z-Y-Z angles are undefined (gimbal lock); state the orientation as Z-Y-X angles or a rotation vector</source>
        <translation>%1: beta liegt innerhalb von 2° um 0° oder 180°, wo Z-Y-Z-Winkel unbestimmt sind (Gimbal Lock); die Orientierung als Z-Y-X-Winkel oder Drehvektor angeben</translation>
    </message>
    <message>
        <source>%1: the rotation is within 4° of half a turn, where the sign of the axis is undefined; state the orientation as angles</source>
        <translation>%1: die Drehung liegt innerhalb von 4° um eine halbe Umdrehung, wo das Vorzeichen der Achse unbestimmt ist; die Orientierung als Winkel angeben</translation>
    </message>
    <message>
        <source>the analysis %1 has no point called &apos;%2&apos;</source>
        <translation>die Analyse %1 hat keinen Punkt mit dem Namen &apos;%2&apos;</translation>
    </message>
    <message>
        <source>point %1 cannot be measured by %2: %3</source>
        <translation>Punkt %1 kann von %2 nicht gemessen werden: %3</translation>
    </message>
    <message>
        <source>the 3-2-1 method uses the first three points; point %1 and those after it are not used: choose least squares</source>
        <translation>die 3-2-1-Methode verwendet die ersten drei Punkte; Punkt %1 und die folgenden werden nicht verwendet: kleinste Quadrate wählen</translation>
    </message>
    <message>
        <source>the base frame is undefined</source>
        <translation>das Basissystem ist nicht bestimmt</translation>
    </message>
    <message>
        <source>the moving frame is undefined</source>
        <translation>das bewegte System ist nicht bestimmt</translation>
    </message>
    <message>
        <source>points %1 and %2 coincide: %3</source>
        <translation>die Punkte %1 und %2 fallen zusammen: %3</translation>
    </message>
    <message>
        <source>point %1 lies on the line through %2 and %3: %4</source>
        <translation>Punkt %1 liegt auf der Geraden durch %2 und %3: %4</translation>
    </message>
    <message>
        <source>all points lie on one line or coincide: their frame is undefined</source>
        <translation>alle Punkte liegen auf einer Geraden oder fallen zusammen: ihr System ist unbestimmt</translation>
    </message>
    <message>
        <source>not used: the uncertainties come from an artefact or instrument</source>
        <translation>nicht verwendet: die Unsicherheiten stammen von einem Prüfkörper oder Messgerät</translation>
    </message>
    <message>
        <source>there are two poses called &apos;%1&apos;; rename one</source>
        <translation>es gibt zwei Posen namens &apos;%1&apos;; eine umbenennen</translation>
    </message>
    <message>
        <source>no pose may be called &apos;base&apos;: that names the base among the measured points</source>
        <translation>keine Pose darf &apos;base&apos; heißen: das bezeichnet die Basis unter den gemessenen Punkten</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither &apos;base&apos; nor the name of a pose</source>
        <translation>&apos;%1&apos; ist weder &apos;base&apos; noch der Name einer Pose</translation>
    </message>
    <message>
        <source>there is no point called &apos;%1&apos; in that frame</source>
        <translation>in diesem System gibt es keinen Punkt mit dem Namen &apos;%1&apos;</translation>
    </message>
    <message>
        <source>point %1 of &apos;%2&apos; was not measured</source>
        <translation>Punkt %1 von &apos;%2&apos; wurde nicht gemessen</translation>
    </message>
    <message>
        <source>the mirrored coordinates leave %1 instead of %2: frame 0 is left-handed, check the signs and the order of its axes</source>
        <translation>die gespiegelten Koordinaten lassen %1 statt %2: System 0 ist linkshändig, Vorzeichen und Reihenfolge seiner Achsen prüfen</translation>
    </message>
    <message>
        <source>with %1 and %2 exchanged the residuals are %3 instead of %4: check the names</source>
        <translation>mit %1 und %2 vertauscht sind die Residuen %3 statt %4: die Namen prüfen</translation>
    </message>
    <message>
        <source>the points of &apos;%1&apos; do not fit their nominal coordinates</source>
        <translation>die Punkte von &apos;%1&apos; passen nicht zu ihren Nennkoordinaten</translation>
    </message>
    <message>
        <source>the points of &apos;%1&apos; do not fit their nominal coordinates within the stated uncertainties: chi-square %2 with %3 degrees of freedom; the largest normalised residual is %4 (%5)</source>
        <translation>die Punkte von &apos;%1&apos; passen innerhalb der angegebenen Unsicherheiten nicht zu ihren Nennkoordinaten: Chi-Quadrat %2 mit %3 Freiheitsgraden; das größte normierte Residuum ist %4 (%5)</translation>
    </message>
    <message>
        <source>the lengths between the supports make no triangle: the longest of %1, %2 and %3 exceeds the sum of the others</source>
        <translation>die Längen zwischen den Auflagern bilden kein Dreieck: die längste von %1, %2 und %3 ist größer als die Summe der anderen</translation>
    </message>
    <message>
        <source>the three supports lie on a line (%1, %2 and %3): they leave the place of the ball undetermined; move one of them aside</source>
        <translation>die drei Auflager liegen auf einer Geraden (%1, %2 und %3): sie lassen den Ort der Kugel unbestimmt; eine davon zur Seite rücken</translation>
    </message>
    <message>
        <source>the lengths of support %1 do not meet at its height: they miss by %2</source>
        <translation>die Längen von Auflager %1 treffen sich nicht auf seiner Höhe: sie verfehlen sich um %2</translation>
    </message>
    <message>
        <source>a set has at most %1 supports</source>
        <translation>ein Satz hat höchstens %1 Auflager</translation>
    </message>
    <message>
        <source>the rotation about %1</source>
        <translation>die Drehung um %1</translation>
    </message>
    <message>
        <source>%1 has %2 points; a plane needs three, and some more to be checked</source>
        <translation>%1 hat %2 Punkte; eine Ebene braucht drei und einige mehr zur Prüfung</translation>
    </message>
    <message>
        <source>%1 has a span of zero: all its points coincide</source>
        <translation>%1 hat keine Spannweite: alle Punkte fallen zusammen</translation>
    </message>
    <message>
        <source>the tool centre point lies on the axis of %1 (or the tool has no length): it traces no circle; turn about another axis</source>
        <translation>der Werkzeugmittelpunkt liegt auf der Achse von %1 (oder das Werkzeug hat keine Länge): er zeichnet keinen Kreis; um eine andere Achse drehen</translation>
    </message>
    <message>
        <source>the arc of %1 spans only %2°: uncertainties grow as the inverse square of the span and may be %3 times those of half a turn</source>
        <translation>der Bogen von %1 umfasst nur %2°: Unsicherheiten wachsen mit dem inversen Quadrat des Bogens und können das %3-fache derer einer halben Umdrehung sein</translation>
    </message>
    <message>
        <source>point %1 is %2 mm on the other side of the supports&apos; plane, where the ballbars look for no solution; change their placement or their side</source>
        <translation>Punkt %1 liegt %2 mm auf der anderen Seite der Ebene der Auflager, wo die Kugelstäbe keine Lösung suchen; ihre Aufstellung oder ihre Seite ändern</translation>
    </message>
    <message>
        <source>point %1 is only %2 mm from the supports&apos; plane, with a standard uncertainty of %3 mm in that direction: in some trials the lengths will not meet (negative root), and u is not to be trusted</source>
        <translation>Punkt %1 liegt nur %2 mm von der Ebene der Auflager entfernt, bei einer Standardunsicherheit von %3 mm in dieser Richtung: in einigen Versuchen treffen sich die Längen nicht (negative Wurzel), und u ist nicht zu trauen</translation>
    </message>
    <message>
        <source>the measured points determine no sphere and no axes: they lie on one circle, or coincide; check their axes and angles</source>
        <translation>die gemessenen Punkte bestimmen weder Kugel noch Achsen: sie liegen auf einem Kreis oder fallen zusammen; ihre Achsen und Winkel prüfen</translation>
    </message>
    <message>
        <source>a procedure has at most %1 points</source>
        <translation>ein Verfahren hat höchstens %1 Punkte</translation>
    </message>
    <message>
        <source>two points are called %1</source>
        <translation>zwei Punkte heißen %1</translation>
    </message>
    <message>
        <source>the flange turns about %1 in two rotations; put their points into one</source>
        <translation>der Flansch dreht in zwei Drehungen um %1; ihre Punkte in eine zusammenfassen</translation>
    </message>
    <message>
        <source>one rotation traces one circle, which leaves the centre of the flange and its axes undetermined: add a rotation about another axis</source>
        <translation>eine Drehung zeichnet einen Kreis, der den Mittelpunkt des Flansches und seine Achsen unbestimmt lässt: eine Drehung um eine andere Achse hinzufügen</translation>
    </message>
    <message>
        <source>no rotation measures axis %1: choose another way to make the axes, or add the rotation</source>
        <translation>keine Drehung misst Achse %1: eine andere Art wählen, die Achsen zu bilden, oder die Drehung hinzufügen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not offer &apos;%2&apos;</source>
        <translation>&apos;%1&apos; bietet kein &apos;%2&apos;</translation>
    </message>
    <message>
        <source>column %1: %2</source>
        <translation>Spalte %1: %2</translation>
    </message>
    <message>
        <source>it is called like a joint of a gripper</source>
        <translation>es heißt wie ein Gelenk eines Greifers</translation>
    </message>
    <message>
        <source>others follow it at the end of the arm, as in a gripper</source>
        <translation>andere folgen ihm am Ende des Arms, wie in einem Greifer</translation>
    </message>
    <message>
        <source>it slides by less than 100 mm at the end of the arm, as in a gripper</source>
        <translation>es schiebt am Ende des Arms um weniger als 100 mm, wie in einem Greifer</translation>
    </message>
    <message>
        <source>it is one of several at the end of the arm, as in a hand</source>
        <translation>es ist eines von mehreren am Ende des Arms, wie in einer Hand</translation>
    </message>
    <message>
        <source>no joint leads to a link called %1</source>
        <translation>kein Gelenk führt zu einem Glied mit dem Namen %1</translation>
    </message>
    <message>
        <source>no moving joint leads to %1</source>
        <translation>kein bewegliches Gelenk führt zu %1</translation>
    </message>
    <message>
        <source>the links form a ring; URDF describes trees</source>
        <translation>die Glieder bilden einen Ring; URDF beschreibt Bäume</translation>
    </message>
    <message>
        <source>joint %1 on the way to %2 is of the type %3: freeze it, --freeze %1=0</source>
        <translation>Gelenk %1 auf dem Weg zu %2 ist von der Art %3: einfrieren, --freeze %1=0</translation>
    </message>
    <message>
        <source>joint %1 on the way to %2 follows joint %3: freeze it, --freeze %1=0</source>
        <translation>Gelenk %1 auf dem Weg zu %2 folgt Gelenk %3: einfrieren, --freeze %1=0</translation>
    </message>
    <message>
        <source>no arm: joint %1 was left out because %2</source>
        <translation>kein Arm: Gelenk %1 wurde weggelassen: %2</translation>
    </message>
    <message>
        <source>no arm: joint %1 is of the type %2</source>
        <translation>kein Arm: Gelenk %1 ist von der Art %2</translation>
    </message>
    <message>
        <source>no arm: joint %1 follows joint %2</source>
        <translation>kein Arm: Gelenk %1 folgt Gelenk %2</translation>
    </message>
    <message>
        <source>left out: it is of the type %1</source>
        <translation>weggelassen: es ist von der Art %1</translation>
    </message>
    <message>
        <source>left out: it follows joint %1</source>
        <translation>weggelassen: es folgt Gelenk %1</translation>
    </message>
    <message>
        <source>left out: %1</source>
        <translation>weggelassen: %1</translation>
    </message>
    <message>
        <source>left out: it is not on the way to %1</source>
        <translation>weggelassen: es liegt nicht auf dem Weg zu %1</translation>
    </message>
    <message>
        <source>the file has no moving joint</source>
        <translation>die Datei hat kein bewegliches Gelenk</translation>
    </message>
    <message>
        <source>the file has several arms of equal length, ending at %1 and %2: name the tip link of the one to import</source>
        <translation>die Datei hat mehrere Arme gleicher Länge, die bei %1 und %2 enden: das Endglied des zu importierenden nennen</translation>
    </message>
    <message>
        <source>frozen: %1</source>
        <translation>eingefroren: %1</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not three numbers</source>
        <translation>&apos;%1&apos; sind nicht drei Zahlen</translation>
    </message>
    <message>
        <source>joint %1 does not say which links it joins</source>
        <translation>Gelenk %1 sagt nicht, welche Glieder es verbindet</translation>
    </message>
    <message>
        <source>joint %1: %2</source>
        <translation>Gelenk %1: %2</translation>
    </message>
    <message>
        <source>joint %1: its axis has no direction</source>
        <translation>Gelenk %1: seine Achse hat keine Richtung</translation>
    </message>
    <message>
        <source>not readable as XML: %1</source>
        <translation>nicht als XML lesbar: %1</translation>
    </message>
    <message>
        <source>no URDF: its root element &lt;robot&gt; is missing</source>
        <translation>kein URDF: das Wurzelelement &lt;robot&gt; fehlt</translation>
    </message>
    <message>
        <source>the file has xacro macros: expand them first (xacro FILE &gt; arm.urdf)</source>
        <translation>die Datei hat xacro-Makros: zuerst auflösen (xacro FILE &gt; arm.urdf)</translation>
    </message>
    <message>
        <source>link %1 hangs on two joints; URDF describes trees</source>
        <translation>Glied %1 hängt an zwei Gelenken; URDF beschreibt Bäume</translation>
    </message>
    <message>
        <source>there is no joint %1 to freeze%2</source>
        <translation>es gibt kein Gelenk %1 zum Einfrieren%2</translation>
    </message>
    <message>
        <source>joint %1 does not move, or is frozen twice</source>
        <translation>Gelenk %1 bewegt sich nicht oder ist zweimal eingefroren</translation>
    </message>
    <message>
        <source>joint %1 is of the type %2: it can be frozen at 0 only</source>
        <translation>Gelenk %1 ist vom Typ %2: es kann nur bei 0 eingefroren werden</translation>
    </message>
    <message>
        <source>frozen at %1, beyond its limits</source>
        <translation>eingefroren bei %1, jenseits seiner Grenzen</translation>
    </message>
    <message>
        <source>frozen at %1</source>
        <translation>eingefroren bei %1</translation>
    </message>
    <message>
        <source>an arm has at most %1 joints here</source>
        <translation>ein Arm hat hier höchstens %1 Gelenke</translation>
    </message>
    <message>
        <source>joint %1 slides: state its readings as lengths, in the columns of s</source>
        <translation>Gelenk %1 schiebt: seine Ablesungen als Längen angeben, in den Spalten von s</translation>
    </message>
    <message>
        <source>joint %1 turns: state its readings as angles, or give it the type sliding</source>
        <translation>Gelenk %1 dreht: seine Ablesungen als Winkel angeben oder die Art schiebend wählen</translation>
    </message>
    <message>
        <source>joint %1</source>
        <translation>Gelenk %1</translation>
    </message>
    <message>
        <source>only the convention with Ry(beta) has a beta; leave it empty for %1, or choose that convention</source>
        <translation>nur die Konvention mit Ry(beta) hat ein beta; für %1 leer lassen oder diese Konvention wählen</translation>
    </message>
    <message>
        <source>d and beta of %1 describe the same place of a parallel axis: where beta is given, d is 0 by definition</source>
        <translation>d und beta von %1 beschreiben denselben Ort einer parallelen Achse: wo beta gegeben ist, ist d nach Definition 0</translation>
    </message>
    <message>
        <source>the lowest reading of %1 is not below its highest</source>
        <translation>die kleinste Ablesung von %1 liegt nicht unter der größten</translation>
    </message>
    <message>
        <source>the robot has no joint %1</source>
        <translation>der Roboter hat kein Gelenk %1</translation>
    </message>
    <message>
        <source>%1 is 0 by definition, because the axis is parallel to the next</source>
        <translation>%1 ist nach Definition 0, weil die Achse zur nächsten parallel ist</translation>
    </message>
    <message>
        <source>%1 is no parameter of this robot: give beta in the table of joints where axes are parallel</source>
        <translation>%1 ist kein Parameter dieses Roboters: beta in der Tabelle der Gelenke angeben, wo Achsen parallel sind</translation>
    </message>
    <message>
        <source>a parameter is correlated with itself; name two different ones</source>
        <translation>ein Parameter ist mit sich selbst korreliert; zwei verschiedene nennen</translation>
    </message>
    <message>
        <source>there is no parameter &apos;%1&apos; with an uncertainty; write its symbol, such as d_3</source>
        <translation>es gibt keinen Parameter &apos;%1&apos; mit einer Unsicherheit; sein Symbol schreiben, etwa d_3</translation>
    </message>
    <message>
        <source>%1 has several components of uncertainty: give it one, the combined, so that it can be correlated</source>
        <translation>%1 hat mehrere Komponenten der Unsicherheit: eine angeben, die zusammengefasste, damit er korreliert werden kann</translation>
    </message>
    <message>
        <source>there is no pose: give joint readings or a place of the tool</source>
        <translation>es gibt keine Pose: Gelenkablesungen oder einen Ort des Werkzeugs angeben</translation>
    </message>
    <message>
        <source>two poses are called %1</source>
        <translation>zwei Posen heißen %1</translation>
    </message>
    <message>
        <source>pose %1: reading %2 of joint %3 is beyond its limits, %4 to %5</source>
        <translation>Pose %1: Ablesung %2 von Gelenk %3 liegt außerhalb seiner Grenzen, %4 bis %5</translation>
    </message>
    <message>
        <source>pose %1: the orientation is within 2° of one that %2 cannot state (gimbal lock, half turn); state it otherwise</source>
        <translation>Pose %1: die Orientierung liegt innerhalb von 2° um eine, die %2 nicht angeben kann (Gimbal Lock, halbe Umdrehung); anders angeben</translation>
    </message>
    <message>
        <source>%1 has only %2 joints; leave %3 empty</source>
        <translation>%1 hat nur %2 Gelenke; %3 leer lassen</translation>
    </message>
    <message>
        <source>joint %1 of %2 slides: its reading is %3</source>
        <translation>Gelenk %1 von %2 schiebt: seine Ablesung ist %3</translation>
    </message>
    <message>
        <source>joint %1 of %2 turns: its reading is %3</source>
        <translation>Gelenk %1 von %2 dreht: seine Ablesung ist %3</translation>
    </message>
    <message>
        <source>pose %1: give all three angles or none</source>
        <translation>Pose %1: alle drei Winkel oder keinen angeben</translation>
    </message>
    <message>
        <source>pose %1: no readings within the limits of the joints bring the tool there; the nearest attempt misses the place by %2 but not the orientation</source>
        <translation>Pose %1: keine Ablesungen innerhalb der Grenzen der Gelenke bringen das Werkzeug dorthin; der nächste Versuch verfehlt den Ort um %2, aber nicht die Orientierung</translation>
    </message>
    <message>
        <source>pose %1: no readings within the limits of the joints bring the tool there; the nearest attempt misses the place by %2</source>
        <translation>Pose %1: keine Ablesungen innerhalb der Grenzen der Gelenke bringen das Werkzeug dorthin; der nächste Versuch verfehlt den Ort um %2</translation>
    </message>
    <message>
        <source>without limits</source>
        <translation>ohne Grenzen</translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <translation>%1 bis %2 %3</translation>
    </message>
    <message>
        <source>%1 mm, turned by %2 deg</source>
        <translation>%1 mm, gedreht um %2 deg</translation>
    </message>
    <message>
        <source>joint %1: %2, slides, %3</source>
        <translation>Gelenk %1: %2, schiebt, %3</translation>
    </message>
    <message>
        <source>joint %1: %2, turns, %3</source>
        <translation>Gelenk %1: %2, dreht, %3</translation>
    </message>
    <message>
        <source>%1 joint from link %2 to link %3</source>
        <translation>%1 Gelenk von Glied %2 zu Glied %3</translation>
    </message>
    <message>
        <source>%1 joints from link %2 to link %3</source>
        <translation>%1 Gelenke von Glied %2 zu Glied %3</translation>
    </message>
    <message>
        <source>tool: link %1 at %2 from the frame of the last joint</source>
        <translation>Werkzeug: Glied %1 bei %2 vom System des letzten Gelenks</translation>
    </message>
    <message>
        <source>with all readings at 0 the tool stands at %1 in link %2</source>
        <translation>mit allen Ablesungen auf 0 steht das Werkzeug bei %1 in Glied %2</translation>
    </message>
    <message>
        <source>the chain to %1 has %2 moving joints; an arm has at most %3 here: freeze those before the arm, --freeze %4=0</source>
        <translation>die Kette bis %1 hat %2 bewegliche Gelenke; ein Arm hat hier höchstens %3: die vor dem Arm einfrieren, --freeze %4=0</translation>
    </message>
    <message>
        <source>pose %1: the residual of its %2 is %3 times its standard uncertainty (limit %4). Look at this pose first; hold it back by use = check</source>
        <translation>Pose %1: das Residuum von %2 ist das %3-fache seiner Standardunsicherheit (Grenze %4). Diese Pose zuerst ansehen; mit use = check zurückhalten</translation>
    </message>
    <message>
        <source>the residuals are %1 times as large as the uncertainties of points and readings explain: there is more than these (a joint&apos;s elasticity, temperature, an outlier), and the uncertainty of the parameters is stated too small</source>
        <translation>die Residuen sind %1-mal so groß, wie die Unsicherheiten von Punkten und Ablesungen erklären: es gibt mehr als diese (Elastizität eines Gelenks, Temperatur, einen Ausreißer), und die Unsicherheit der Parameter ist zu klein angegeben</translation>
    </message>
    <message>
        <source>these poses hardly tell %1 apart (condition %2): turn more joints further, or hold one of them</source>
        <translation>diese Posen trennen %1 kaum (Kondition %2): mehr Gelenke weiter drehen oder einen davon festhalten</translation>
    </message>
    <message>
        <source>no parameter of the arm can be told from these poses: every one of them is coupled with others or held</source>
        <translation>kein Parameter des Arms ist aus diesen Posen bestimmbar: jeder ist mit anderen gekoppelt oder festgehalten</translation>
    </message>
    <message>
        <source>the poses of the fit give %1 coordinates, no more than there are unknowns to find: measure more poses, or hold parameters</source>
        <translation>die Posen der Ausgleichung geben %1 Koordinaten, nicht mehr als Unbekannte zu finden sind: mehr Posen messen oder Parameter festhalten</translation>
    </message>
    <message>
        <source>the fit does not converge: look for exchanged poses, readings of the wrong sign or in another unit, and for a nominal robot that is another arm</source>
        <translation>die Ausgleichung konvergiert nicht: nach vertauschten Posen, Ablesungen mit falschem Vorzeichen oder in anderer Einheit suchen und nach einem Nennroboter, der ein anderer Arm ist</translation>
    </message>
    <message>
        <source>at the solution the unknowns cannot be told apart; hold one of those that the table of observability names</source>
        <translation>an der Lösung sind die Unbekannten nicht zu trennen; einen der Parameter festhalten, die die Tabelle der Beobachtbarkeit nennt</translation>
    </message>
    <message>
        <source>joint %1 slides: only arms whose joints turn are identified; take an arm without it, as it stands during the measurement</source>
        <translation>Gelenk %1 schiebt: identifiziert werden nur Arme, deren Gelenke drehen; einen Arm ohne dieses Gelenk nehmen, so wie es während der Messung steht</translation>
    </message>
    <message>
        <source>the fit has %1 poses; it needs three or more, and about twenty to tell all parameters</source>
        <translation>die Ausgleichung hat %1 Posen; sie braucht drei oder mehr und etwa zwanzig, um alle Parameter zu bestimmen</translation>
    </message>
    <message>
        <source>the robot has only %1 joints; leave %2 empty</source>
        <translation>der Roboter hat nur %1 Gelenke; %2 leer lassen</translation>
    </message>
    <message>
        <source>pose %1: its orientation is missing; give alpha, beta and gamma of every pose, or fit positions alone</source>
        <translation>Pose %1: die Orientierung fehlt; alpha, beta und gamma jeder Pose angeben oder nur Positionen ausgleichen</translation>
    </message>
    <message>
        <source>the robot has no parameter &apos;%1&apos; to hold; write its symbol, such as d_3</source>
        <translation>der Roboter hat keinen Parameter &apos;%1&apos; zum Festhalten; sein Symbol schreiben, etwa d_3</translation>
    </message>
    <message>
        <source>rotation about %1</source>
        <translation>Drehung um %1</translation>
    </message>
    <message>
        <source>base %1</source>
        <translation>Fußpunkt %1</translation>
    </message>
    <message>
        <source>tool %1</source>
        <translation>Werkzeug %1</translation>
    </message>
    <message>
        <source>the points do not lead to parameters of the arm</source>
        <translation>die Punkte führen nicht zu Parametern des Arms</translation>
    </message>
    <message>
        <source>the points of %1 run against the positive direction of the joint: reverse their order, or give its readings</source>
        <translation>die Punkte von %1 laufen gegen die positive Richtung des Gelenks: ihre Reihenfolge umkehren oder seine Ablesungen angeben</translation>
    </message>
    <message>
        <source>the axes of joints %1 and %2</source>
        <translation>die Achsen der Gelenke %1 und %2</translation>
    </message>
    <message>
        <source>%1 are nearly parallel (%2): they are described by beta with d = 0, because the place of their common perpendicular is hardly determined</source>
        <translation>%1 sind nahezu parallel (%2): sie werden durch beta mit d = 0 beschrieben, weil der Ort ihrer gemeinsamen Normale kaum bestimmt ist</translation>
    </message>
    <message>
        <source>%1 are %2 apart: they are described by d without beta, although the nominal robot has beta</source>
        <translation>%1 liegen %2 auseinander: sie werden durch d ohne beta beschrieben, obwohl der Nennroboter beta hat</translation>
    </message>
    <message>
        <source>the axes of joints %1 and %2 are the same line: nothing tells their frames apart</source>
        <translation>die Achsen der Gelenke %1 und %2 sind dieselbe Gerade: nichts trennt ihre Systeme</translation>
    </message>
    <message>
        <source>parameters are identified by Eq 5: describe the nominal robot in that convention, not in Craig&apos;s</source>
        <translation>Parameter werden nach Gl. 5 identifiziert: den Nennroboter in dieser Konvention beschreiben, nicht in der von Craig</translation>
    </message>
    <message>
        <source>joint %1 slides and draws no circle: take an arm without it, as it stands during the measurement</source>
        <translation>Gelenk %1 schiebt und zeichnet keinen Kreis: einen Arm ohne dieses Gelenk nehmen, so wie es während der Messung steht</translation>
    </message>
    <message>
        <source>an arm of one joint has no parameters between two axes</source>
        <translation>ein Arm mit einem Gelenk hat keine Parameter zwischen zwei Achsen</translation>
    </message>
    <message>
        <source>the robot has no %1</source>
        <translation>der Roboter hat kein %1</translation>
    </message>
    <message>
        <source>%1 has %2 points; a circle needs three or more</source>
        <translation>%1 hat %2 Punkte; ein Kreis braucht drei oder mehr</translation>
    </message>
    <message>
        <source>the ball hardly moves while %1 turns: it lies on the axis of that joint and draws no circle. Fix the ball off the axis</source>
        <translation>die Kugel bewegt sich kaum, während %1 dreht: sie liegt auf der Achse dieses Gelenks und zeichnet keinen Kreis. Die Kugel abseits der Achse befestigen</translation>
    </message>
    <message>
        <source>the points of %1 lie on a straight line, as far as their uncertainty lets it be seen: no circle goes through them. Turn the joint further</source>
        <translation>die Punkte von %1 liegen auf einer Geraden, soweit ihre Unsicherheit es erkennen lässt: kein Kreis geht hindurch. Das Gelenk weiter drehen</translation>
    </message>
    <message>
        <source>the arc of %1 over %2 is short for the uncertainty of its points: its axis will be known poorly</source>
        <translation>der Bogen von %1 über %2 ist kurz für die Unsicherheit seiner Punkte: seine Achse wird schlecht bekannt sein</translation>
    </message>
    <message>
        <source>the plane of %1 passes the origin at %2: Eq 1 excludes planes through the origin and fails near it. Use total least squares</source>
        <translation>die Ebene von %1 geht im Abstand %2 am Ursprung vorbei: Gl. 1 schließt Ebenen durch den Ursprung aus und versagt in seiner Nähe. Totale kleinste Quadrate verwenden</translation>
    </message>
    <message>
        <source>no circle fits the points of %1; look for exchanged points</source>
        <translation>kein Kreis passt zu den Punkten von %1; nach vertauschten Punkten suchen</translation>
    </message>
    <message>
        <source>the calibration matrix is singular: the channels answer to loads on %1 alike, so these cannot be told apart</source>
        <translation>die Kalibriermatrix ist singulär: die Kanäle antworten auf Lasten an %1 gleich, daher sind diese nicht zu trennen</translation>
    </message>
    <message>
        <source>the calibration matrix has the condition number %1: loads on %2 are hardly told apart</source>
        <translation>die Kalibriermatrix hat die Konditionszahl %1: Lasten an %2 sind kaum zu trennen</translation>
    </message>
    <message>
        <source>add a row of loads to be evaluated</source>
        <translation>eine Zeile mit auszuwertenden Lasten hinzufügen</translation>
    </message>
    <message>
        <source>add a row of readings to be decoupled</source>
        <translation>eine Zeile mit zu entkoppelnden Ablesungen hinzufügen</translation>
    </message>
    <message>
        <source>two cases are called &apos;%1&apos;</source>
        <translation>zwei Fälle heißen &apos;%1&apos;</translation>
    </message>
    <message>
        <source>channel %1 has no reading: all channels are needed</source>
        <translation>Kanal %1 hat keine Ablesung: alle Kanäle sind nötig</translation>
    </message>
    <message>
        <source>the sensor has no channel %1</source>
        <translation>der Sensor hat keinen Kanal %1</translation>
    </message>
    <message>
        <source>no load gives these readings by the calibration matrix</source>
        <translation>keine Last ergibt mit der Kalibriermatrix diese Ablesungen</translation>
    </message>
    <message>
        <source>the load on %1 is %2 % of its rated load: the calibration says nothing about it</source>
        <translation>die Last an %1 ist %2 % ihrer Nennlast: die Kalibrierung sagt darüber nichts</translation>
    </message>
    <message>
        <source>loads on %1 are too few for this calibration matrix</source>
        <translation>die Lasten an %1 sind zu wenige für diese Kalibriermatrix</translation>
    </message>
    <message>
        <source>the interference of %1 is known without signs: it cannot be compensated. Give raw readings, or a table with signs</source>
        <translation>das Übersprechen von %1 ist ohne Vorzeichen bekannt: es kann nicht kompensiert werden. Rohablesungen oder eine Tabelle mit Vorzeichen angeben</translation>
    </message>
    <message>
        <source>quadratic terms need raw readings; %1 has a summary only</source>
        <translation>quadratische Glieder brauchen Rohablesungen; %1 hat nur eine Zusammenfassung</translation>
    </message>
    <message>
        <source>channel %1 is listed twice</source>
        <translation>Kanal %1 ist zweimal aufgeführt</translation>
    </message>
    <message>
        <source>moment</source>
        <translation>Moment</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>channel %1 needs its rated load, a %2</source>
        <translation>Kanal %1 braucht seine Nennlast (%2)</translation>
    </message>
    <message>
        <source>%1 states no uncertainty of its load on %2: add it to its certificate</source>
        <translation>%1 gibt keine Unsicherheit der Last an %2 an: in seinem Kalibrierschein ergänzen</translation>
    </message>
    <message>
        <source>increasing loads</source>
        <translation>steigende Belastungen</translation>
    </message>
    <message>
        <source>unloaded reading before</source>
        <translation>unbelastete Ablesung davor</translation>
    </message>
    <message>
        <source>run %1 of %2 has no %3: it is left out</source>
        <translation>Lauf %1 von %2 ohne %3: er bleibt unberücksichtigt</translation>
    </message>
    <message>
        <source>%1 was not calibrated: there are no runs with its axis loaded</source>
        <translation>%1 wurde nicht kalibriert: es gibt keine Läufe mit belasteter Achse</translation>
    </message>
    <message>
        <source>%1 has one run only: its repeatability needs two or more</source>
        <translation>%1 hat nur einen Lauf: die Wiederholpräzision braucht zwei oder mehr</translation>
    </message>
    <message>
        <source>%1 has %2 runs, %3 are planned: its means have %4 degrees of freedom</source>
        <translation>%1 hat %2 Läufe, geplant sind %3: die Mittelwerte haben %4 Freiheitsgrade</translation>
    </message>
    <message>
        <source>%1 has %2 preloads, %3 are planned</source>
        <translation>%1 hat %2 Vorbelastungen, geplant sind %3</translation>
    </message>
    <message>
        <source>, and it says nothing about repeatability</source>
        <translation>, und er sagt nichts über die Wiederholpräzision</translation>
    </message>
    <message>
        <source>step %1 of %2 is missing in %3 of %4 runs: its mean is that of %5%6</source>
        <translation>Stufe %1 von %2 fehlt in %3 von %4 Läufen: ihr Mittelwert ist der von %5%6</translation>
    </message>
    <message>
        <source>%1 was loaded in %2 steps, %3 are planned</source>
        <translation>%1 wurde in %2 Stufen belastet, geplant sind %3</translation>
    </message>
    <message>
        <source>the largest load on %1 is %2; the rated output needs the rated load, %3</source>
        <translation>die größte Last an %1 ist %2; der Nennkennwert braucht die Nennlast, %3</translation>
    </message>
    <message>
        <source>%1 has the same reading in all runs: its repeatability is evaluated as zero</source>
        <translation>%1 hat in allen Läufen dieselbe Ablesung: die Wiederholpräzision wird zu null ausgewertet</translation>
    </message>
    <message>
        <source>%1 has no unloaded readings after a run: its non-zero error is taken as zero</source>
        <translation>%1 hat nach keinem Lauf unbelastete Ablesungen: die Nullpunktabweichung wird als null angenommen</translation>
    </message>
    <message>
        <source>%1 has no decreasing loads: its hysteresis is not known and is taken as zero</source>
        <translation>%1 hat keine fallenden Belastungen: die Hysterese ist nicht bekannt und wird als null angenommen</translation>
    </message>
    <message>
        <source>run %1 of %2 reads the same at steps %3 and %4 although the load rises: the indicator is saturated or the channel is stuck</source>
        <translation>Lauf %1 von %2 liest auf den Stufen %3 und %4 dasselbe, obwohl die Last steigt: das Anzeigegerät ist übersteuert oder der Kanal hängt</translation>
    </message>
    <message>
        <source>run %1 of %2: only %3 s between steps %4 and %5, %6 s are planned</source>
        <translation>Lauf %1 von %2: nur %3 s zwischen den Stufen %4 und %5, geplant sind %6 s</translation>
    </message>
    <message>
        <source>run %1 of %2 begins %3 s after the one before was unloaded, %4 s are planned</source>
        <translation>Lauf %1 von %2 beginnt %3 s nach der Entlastung des vorigen, geplant sind %4 s</translation>
    </message>
    <message>
        <source>channel %1 does not respond to its load: %2 at the rated load; look at its cable and its column</source>
        <translation>Kanal %1 antwortet nicht auf seine Last: %2 bei der Nennlast; sein Kabel und seine Spalte prüfen</translation>
    </message>
    <message>
        <source>channel %1 responds to %2 more than to its own load: are columns exchanged?</source>
        <translation>Kanal %1 antwortet stärker auf %2 als auf seine eigene Last: sind Spalten vertauscht?</translation>
    </message>
    <message>
        <source>there are no readings: import them from a CSV file, or choose summary tables</source>
        <translation>es gibt keine Ablesungen: aus einer CSV-Datei importieren oder zusammenfassende Tabellen wählen</translation>
    </message>
    <message>
        <source>the sensor has no channel %1: list it among its channels</source>
        <translation>der Sensor hat keinen Kanal %1: unter seinen Kanälen aufführen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no unit of a load: %2</source>
        <translation>&apos;%1&apos; ist keine Einheit einer Last: %2</translation>
    </message>
    <message>
        <source>%1 is a moment, but its load is in %2: are forces and moments, or their units, exchanged?</source>
        <translation>%1 ist ein Moment, aber die Last steht in %2: sind Kräfte und Momente oder ihre Einheiten vertauscht?</translation>
    </message>
    <message>
        <source>%1 is a force, but its load is in %2: are forces and moments, or their units, exchanged?</source>
        <translation>%1 ist eine Kraft, aber die Last steht in %2: sind Kräfte und Momente oder ihre Einheiten vertauscht?</translation>
    </message>
    <message>
        <source>a load of %1 is more than 1.2 times the rated load of %2, %3: is its unit right?</source>
        <translation>eine Last von %1 ist mehr als das 1,2-fache der Nennlast von %2, %3: stimmt die Einheit?</translation>
    </message>
    <message>
        <source>channel %1 has no reading in this row</source>
        <translation>Kanal %1 hat in dieser Zeile keine Ablesung</translation>
    </message>
    <message>
        <source>channel %1 indicates %2 mV/V, which is the end of the indicator&apos;s range: the reading is saturated</source>
        <translation>Kanal %1 zeigt %2 mV/V, das Ende des Bereichs des Anzeigegeräts: die Ablesung ist übersteuert</translation>
    </message>
    <message>
        <source>this run has its unloaded reading already</source>
        <translation>dieser Lauf hat seine unbelastete Ablesung schon</translation>
    </message>
    <message>
        <source>step %1 of this run is given twice</source>
        <translation>Stufe %1 dieses Laufs ist zweimal angegeben</translation>
    </message>
    <message>
        <source>channel %1 has no row in the summary</source>
        <translation>Kanal %1 hat keine Zeile in der Zusammenfassung</translation>
    </message>
    <message>
        <source>%1 has no row in the table of interference: taken as zero</source>
        <translation>%1 hat keine Zeile in der Tabelle des Übersprechens: als null angenommen</translation>
    </message>
    <message>
        <source>axis %1 is listed twice</source>
        <translation>Achse %1 ist zweimal aufgeführt</translation>
    </message>
    <message>
        <source>the sensor&apos;s calibration is a summary: there are no steps to pool over, so the largest standard deviation is taken</source>
        <translation>die Kalibrierung des Sensors ist eine Zusammenfassung: es gibt keine Stufen zum Zusammenfassen, daher wird die größte Standardabweichung genommen</translation>
    </message>
    <message>
        <source>the name is one of a function or a word of the equations; choose another</source>
        <translation>der Name ist der einer Funktion oder eines Wortes der Gleichungen; einen anderen wählen</translation>
    </message>
    <message>
        <source>a symbol is made of letters, Greek ones too, digits and &apos;_&apos;, a letter first</source>
        <translation>ein Symbol besteht aus Buchstaben, auch griechischen, Ziffern und &apos;_&apos;, ein Buchstabe zuerst</translation>
    </message>
    <message>
        <source>only the first row of a symbol has a value; further rows add components</source>
        <translation>nur die erste Zeile eines Symbols hat einen Wert; weitere Zeilen fügen Komponenten hinzu</translation>
    </message>
    <message>
        <source>the component is in %1, the quantity in %2</source>
        <translation>die Komponente ist in %1, die Größe in %2</translation>
    </message>
    <message>
        <source>a further row states a component of uncertainty</source>
        <translation>eine weitere Zeile gibt eine Komponente der Unsicherheit an</translation>
    </message>
    <message>
        <source>the instrument of the project is missing</source>
        <translation>das Messgerät des Projekts fehlt</translation>
    </message>
    <message>
        <source>the reading of an instrument needs a value</source>
        <translation>die Ablesung eines Messgeräts braucht einen Wert</translation>
    </message>
    <message>
        <source>an instrument reads distances here; the unit must be one of length</source>
        <translation>ein Messgerät liest hier Distanzen; die Einheit muss eine der Länge sein</translation>
    </message>
    <message>
        <source>%1 reads no distances</source>
        <translation>%1 liest keine Distanzen</translation>
    </message>
    <message>
        <source>the value is missing, and no statement gives it</source>
        <translation>der Wert fehlt, und keine Angabe liefert ihn</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has observations and no row in the table of quantities</source>
        <translation>&apos;%1&apos; hat Beobachtungen, aber keine Zeile in der Tabelle der Größen</translation>
    </message>
    <message>
        <source>Newton&apos;s method finds no solution of this equation from the starting value, at the estimates of the quantities</source>
        <translation>das Newton-Verfahren findet bei den Schätzwerten der Größen vom Startwert aus keine Lösung dieser Gleichung</translation>
    </message>
    <message>
        <source>this operation has no value at the estimates of the quantities (division by zero, root or logarithm of a negative number, or a number too large)</source>
        <translation>diese Rechnung hat bei den Schätzwerten der Größen keinen Wert (Division durch null, Wurzel oder Logarithmus einer negativen Zahl oder eine zu große Zahl)</translation>
    </message>
    <message>
        <source>it has several series: leave out the name of the one that is measured now</source>
        <translation>es gibt mehrere Reihen: den Namen der jetzt gemessenen weglassen</translation>
    </message>
    <message>
        <source>the table of observations has no rows for it</source>
        <translation>die Tabelle der Beobachtungen hat dafür keine Zeilen</translation>
    </message>
    <message>
        <source>&apos;a&apos; is missing: number of observations of which the value is the mean</source>
        <translation>&apos;a&apos; fehlt: Anzahl der Beobachtungen, deren Mittelwert der Wert ist</translation>
    </message>
    <message>
        <source>there is no equation: write one, y = x_1 + x_2</source>
        <translation>es gibt keine Gleichung: eine schreiben, y = x_1 + x_2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is defined by an equation: it cannot be a quantity too</source>
        <translation>&apos;%1&apos; ist durch eine Gleichung definiert: es kann nicht auch eine Größe sein</translation>
    </message>
    <message>
        <source>no equation uses &apos;%1&apos;</source>
        <translation>keine Gleichung verwendet &apos;%1&apos;</translation>
    </message>
    <message>
        <source>no equation defines &apos;%1&apos;%2</source>
        <translation>keine Gleichung definiert &apos;%1&apos;%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is listed twice</source>
        <translation>&apos;%1&apos; ist zweimal aufgeführt</translation>
    </message>
    <message>
        <source>group &apos;%1&apos;: %2</source>
        <translation>Gruppe &apos;%1&apos;: %2</translation>
    </message>
    <message>
        <source>an analysis of variance needs at least two groups</source>
        <translation>eine Varianzanalyse braucht mindestens zwei Gruppen</translation>
    </message>
    <message>
        <source>no group has more than one observation: nothing tells the scatter within the groups from that between them</source>
        <translation>keine Gruppe hat mehr als eine Beobachtung: nichts trennt die Streuung in den Gruppen von der zwischen ihnen</translation>
    </message>
    <message>
        <source>the curve does not reach %1</source>
        <translation>die Kurve erreicht %1 nicht</translation>
    </message>
    <message>
        <source>, outside of its points</source>
        <translation>, außerhalb ihrer Punkte</translation>
    </message>
    <message>
        <source>the curve reaches %1 at x = %2%3: say in &apos;near&apos; which of them is meant</source>
        <translation>die Kurve erreicht %1 bei x = %2%3: in &apos;near&apos; angeben, welches davon gemeint ist</translation>
    </message>
    <message>
        <source>no curve of this degree was found: the iteration for the uncertainties of x does not settle on these points</source>
        <translation>keine Kurve dieses Grades gefunden: die Iteration für die Unsicherheiten von x kommt bei diesen Punkten nicht zur Ruhe</translation>
    </message>
    <message>
        <source>the points do not determine a curve of this degree</source>
        <translation>die Punkte bestimmen keine Kurve dieses Grades</translation>
    </message>
    <message>
        <source>the x of y = %1 lies outside of the points of the calibration</source>
        <translation>das x von y = %1 liegt außerhalb der Punkte der Kalibrierung</translation>
    </message>
    <message>
        <source>the standard uncertainty of y is missing in row %1</source>
        <translation>die Standardunsicherheit von y fehlt in Zeile %1</translation>
    </message>
    <message>
        <source>the standard uncertainty of y must be greater than zero in row %1</source>
        <translation>die Standardunsicherheit von y muss in Zeile %1 größer als null sein</translation>
    </message>
    <message>
        <source>readings have the scatter of the residuals, which stated uncertainties do not use: give u_y in row %1</source>
        <translation>Ablesungen haben die Streuung der Residuen, die angegebene Unsicherheiten nicht verwenden: u_y in Zeile %1 angeben</translation>
    </message>
    <message>
        <source>a curve through the origin needs differences: give y in K</source>
        <translation>eine Kurve durch den Ursprung braucht Differenzen: y in K angeben</translation>
    </message>
    <message>
        <source>a polynomial of this degree needs points at %1 different places or more beside the origin</source>
        <translation>ein Polynom dieses Grades braucht Punkte an %1 verschiedenen Stellen oder mehr neben dem Ursprung</translation>
    </message>
    <message>
        <source>a polynomial of this degree needs points at %1 different places or more</source>
        <translation>ein Polynom dieses Grades braucht Punkte an %1 verschiedenen Stellen oder mehr</translation>
    </message>
    <message>
        <source>residuals say nothing about the uncertainty unless there are more points than coefficients: add points, or state u_y</source>
        <translation>Residuen sagen nichts über die Unsicherheit, wenn es nicht mehr Punkte als Koeffizienten gibt: Punkte hinzufügen oder u_y angeben</translation>
    </message>
    <message>
        <source>line %1, %2</source>
        <translation>Zeile %1, %2</translation>
    </message>
    <message>
        <source>The mesh is not drawn: %1: %2</source>
        <translation>Das Netz wird nicht gezeichnet: %1: %2</translation>
    </message>
    <message>
        <source>The mesh is not drawn: %1</source>
        <translation>Das Netz wird nicht gezeichnet: %1</translation>
    </message>
    <message>
        <source>it has more than %1 triangles: thin it out</source>
        <translation>sie hat mehr als %1 Dreiecke: ausdünnen</translation>
    </message>
    <message>
        <source>triangle %1 has a coordinate that is not a finite number</source>
        <translation>Dreieck %1 hat eine Koordinate, die keine endliche Zahl ist</translation>
    </message>
    <message>
        <source>triangle %1: %2 is no number</source>
        <translation>Dreieck %1: %2 ist keine Zahl</translation>
    </message>
    <message>
        <source>it ends in triangle %1: it has been cut off</source>
        <translation>sie endet in Dreieck %1: sie ist abgeschnitten</translation>
    </message>
    <message>
        <source>triangle %1: %2 stands where %3 should</source>
        <translation>Dreieck %1: %2 steht, wo %3 stehen sollte</translation>
    </message>
    <message>
        <source>it is no STL file: it neither begins with &quot;solid&quot; nor has a header of 84 bytes</source>
        <translation>sie ist keine STL-Datei: sie beginnt weder mit &quot;solid&quot; noch hat sie einen Kopf von 84 Byte</translation>
    </message>
    <message>
        <source>it is no STL file: its header states %1 triangles, and there is more behind them</source>
        <translation>sie ist keine STL-Datei: ihr Kopf nennt %1 Dreiecke, und danach folgt noch mehr</translation>
    </message>
    <message>
        <source>its header states %1 triangles; it ends in triangle %2</source>
        <translation>ihr Kopf nennt %1 Dreiecke; sie endet in Dreieck %2</translation>
    </message>
    <message>
        <source>it has no triangles</source>
        <translation>sie hat keine Dreiecke</translation>
    </message>
    <message>
        <source>target uncertainty</source>
        <translation>Zielunsicherheit</translation>
    </message>
    <message>
        <source>mean of the prior</source>
        <translation>Mittelwert der A-priori-Verteilung</translation>
    </message>
    <message>
        <source>standard deviation of the prior</source>
        <translation>Standardabweichung der A-priori-Verteilung</translation>
    </message>
    <message>
        <source>the %1 must be greater than zero</source>
        <translation>%1 muss größer als null sein</translation>
    </message>
    <message>
        <source>the %1 must be above the lower limit</source>
        <translation>%1 muss über der unteren Grenze liegen</translation>
    </message>
    <message>
        <source>the guard factor of %1 must lie between -10 and 10; 1 is a guard band of U, 0 simple acceptance</source>
        <translation>der Schutzfaktor von %1 muss zwischen -10 und 10 liegen; 1 ist ein Schutzabstand von U, 0 einfache Annahme</translation>
    </message>
    <message>
        <source>the prior of %1 needs both a mean and a standard deviation</source>
        <translation>die A-priori-Verteilung von %1 braucht Mittelwert und Standardabweichung</translation>
    </message>
    <message>
        <source>the prior of %1 is of use only with a tolerance: give a limit</source>
        <translation>die A-priori-Verteilung von %1 ist nur mit einer Toleranz von Nutzen: eine Grenze angeben</translation>
    </message>
    <message>
        <source> in %1</source>
        <translation> in %1</translation>
    </message>
    <message>
        <source>the model has no output quantity %1%2%3</source>
        <translation>das Modell hat keine Ausgangsgröße %1%2%3</translation>
    </message>
    <message>
        <source>an axis needs at least two values</source>
        <translation>eine Achse braucht mindestens zwei Werte</translation>
    </message>
    <message>
        <source>&apos;from&apos; and &apos;to&apos; must be two different numbers</source>
        <translation>&apos;from&apos; und &apos;to&apos; müssen zwei verschiedene Zahlen sein</translation>
    </message>
    <message>
        <source>with logarithmic spacing both ends must be greater than zero</source>
        <translation>bei logarithmischer Teilung müssen beide Enden größer als null sein</translation>
    </message>
    <message>
        <source>&apos;%1&apos; takes whole numbers: there are fewer than %2 between the ends</source>
        <translation>&apos;%1&apos; nimmt ganze Zahlen: zwischen den Enden liegen weniger als %2</translation>
    </message>
    <message>
        <source>a study has one to three axes; this one has %1</source>
        <translation>eine Studie hat eine bis drei Achsen; diese hat %1</translation>
    </message>
    <message>
        <source>%1 is varied by two axes</source>
        <translation>%1 wird von zwei Achsen variiert</translation>
    </message>
    <message>
        <source>Monte Carlo needs at least two trials</source>
        <translation>Monte Carlo braucht mindestens zwei Versuche</translation>
    </message>
    <message>
        <source>the grid has %1 points; a study may have %2</source>
        <translation>das Gitter hat %1 Punkte; eine Studie darf %2 haben</translation>
    </message>
    <message>
        <source>the uncertainty of an input quantity can be varied by a factor only</source>
        <translation>die Unsicherheit einer Eingangsgröße kann nur um einen Faktor variiert werden</translation>
    </message>
    <message>
        <source>a factor has no unit</source>
        <translation>ein Faktor hat keine Einheit</translation>
    </message>
    <message>
        <source>a factor of an uncertainty must not be negative</source>
        <translation>ein Faktor einer Unsicherheit darf nicht negativ sein</translation>
    </message>
    <message>
        <source>a temperature in %1 cannot be multiplied; add to it, or give its values</source>
        <translation>eine Temperatur in %1 kann nicht multipliziert werden; etwas addieren oder ihre Werte angeben</translation>
    </message>
    <message>
        <source>a difference of temperatures is given in K</source>
        <translation>eine Temperaturdifferenz wird in K angegeben</translation>
    </message>
    <message>
        <source>a number that varies</source>
        <translation>eine Zahl, die variiert</translation>
    </message>
    <message>
        <source>an axis of a study</source>
        <translation>eine Achse einer Studie</translation>
    </message>
    <message>
        <source>an output of a study</source>
        <translation>eine Ausgangsgröße einer Studie</translation>
    </message>
    <message>
        <source>a study</source>
        <translation>eine Studie</translation>
    </message>
    <message>
        <source>only numbers of the set-up of an asset can be varied</source>
        <translation>nur Zahlen des Aufbaus eines Betriebsmittels können variiert werden</translation>
    </message>
    <message>
        <source>a target is written as &quot;/setup/KEY&quot;, &quot;/setup/KEY/rows/0/COLUMN&quot;, &quot;/inputs/SYMBOL/estimate&quot; or &quot;/inputs/SYMBOL/components&quot;</source>
        <translation>ein Ziel wird als &quot;/setup/KEY&quot;, &quot;/setup/KEY/rows/0/COLUMN&quot;, &quot;/inputs/SYMBOL/estimate&quot; oder &quot;/inputs/SYMBOL/components&quot; geschrieben</translation>
    </message>
    <message>
        <source>the set-up has no schema</source>
        <translation>der Aufbau hat kein Schema</translation>
    </message>
    <message>
        <source>the set-up has no field %1%2</source>
        <translation>der Aufbau hat kein Feld %1%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not used with the present choices of the set-up</source>
        <translation>&apos;%1&apos; wird bei der derzeitigen Auswahl im Aufbau nicht verwendet</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number</source>
        <translation>&apos;%1&apos; ist keine Zahl</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not given, so there is nothing to change</source>
        <translation>&apos;%1&apos; ist nicht angegeben, es gibt also nichts zu ändern</translation>
    </message>
    <message>
        <source>a coordinate of the pose &apos;%1&apos; is written as &quot;/setup/%2/position/0&quot; or &quot;/setup/%3/angles/2&quot;</source>
        <translation>eine Koordinate der Pose &apos;%1&apos; wird als &quot;/setup/%2/position/0&quot; oder &quot;/setup/%3/angles/2&quot; geschrieben</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not given</source>
        <translation>&apos;%1&apos; ist nicht angegeben</translation>
    </message>
    <message>
        <source>a number of the table &apos;%1&apos; is written as &quot;/setup/%2/rows/0/COLUMN&quot; or &quot;/setup/%3/columns/COLUMN&quot;</source>
        <translation>eine Zahl der Tabelle &apos;%1&apos; wird als &quot;/setup/%2/rows/0/COLUMN&quot; oder &quot;/setup/%3/columns/COLUMN&quot; geschrieben</translation>
    </message>
    <message>
        <source>the table &apos;%1&apos; has no column %2</source>
        <translation>die Tabelle &apos;%1&apos; hat keine Spalte %2</translation>
    </message>
    <message>
        <source>the column %1 does not hold numbers</source>
        <translation>die Spalte %1 enthält keine Zahlen</translation>
    </message>
    <message>
        <source>the table &apos;%1&apos; is empty</source>
        <translation>die Tabelle &apos;%1&apos; ist leer</translation>
    </message>
    <message>
        <source>the table &apos;%1&apos; has %2 rows, counted from 0</source>
        <translation>die Tabelle &apos;%1&apos; hat %2 Zeilen, ab 0 gezählt</translation>
    </message>
    <message>
        <source>the cell is empty, so there is nothing to change</source>
        <translation>die Zelle ist leer, es gibt also nichts zu ändern</translation>
    </message>
    <message>
        <source>the column is empty, so there is nothing to change</source>
        <translation>die Spalte ist leer, es gibt also nichts zu ändern</translation>
    </message>
    <message>
        <source>of an input quantity, &quot;estimate&quot; or &quot;components&quot; can be varied</source>
        <translation>bei einer Eingangsgröße kann &quot;estimate&quot; oder &quot;components&quot; variiert werden</translation>
    </message>
    <message>
        <source>the model has no input quantity %1%2</source>
        <translation>das Modell hat keine Eingangsgröße %1%2</translation>
    </message>
    <message>
        <source>there is no component %1%2</source>
        <translation>es gibt keine Komponente %1%2</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; has no unit; it is not a measured number</source>
        <translation>Spalte &apos;%1&apos; von &apos;%2&apos; hat keine Einheit; sie ist keine gemessene Zahl</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; is missing</source>
        <translation>Spalte &apos;%1&apos; von &apos;%2&apos; fehlt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no column &apos;%2&apos;%3; its columns are %4</source>
        <translation>&apos;%1&apos; hat keine Spalte &apos;%2&apos;%3; ihre Spalten sind %4</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; is given twice</source>
        <translation>Spalte &apos;%1&apos; von &apos;%2&apos; ist zweimal angegeben</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be one of %2; it is &apos;%3&apos;%4</source>
        <translation>&apos;%1&apos; muss eines von %2 sein; es ist &apos;%3&apos;%4</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a whole number that is not negative; it is %2</source>
        <translation>&apos;%1&apos; muss eine ganze Zahl sein, die nicht negativ ist; es ist %2</translation>
    </message>
    <message>
        <source>a unit is needed here, such as &quot;mm&quot;, not %1</source>
        <translation>hier ist eine Einheit nötig, etwa &quot;mm&quot;, nicht %1</translation>
    </message>
    <message>
        <source>a unit with a dimension is needed here, not &apos;%1&apos;</source>
        <translation>hier ist eine Einheit mit Dimension nötig, nicht &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is of the same dimension as a unit before it; give one of each</source>
        <translation>&apos;%1&apos; hat dieselbe Dimension wie eine Einheit davor; von jeder eine angeben</translation>
    </message>
    <message>
        <source>what the project states for results</source>
        <translation>was das Projekt für Ergebnisse angibt</translation>
    </message>
    <message>
        <source>the coverage factor must be greater than zero; without one, k follows from the degrees of freedom or the coverage interval</source>
        <translation>der Erweiterungsfaktor muss größer als null sein; ohne ihn folgt k aus den Freiheitsgraden oder dem Überdeckungsintervall</translation>
    </message>
    <message>
        <source>a report has no chapter %1%2</source>
        <translation>ein Bericht hat kein Kapitel %1%2</translation>
    </message>
    <message>
        <source>there is no analysis %1%2</source>
        <translation>es gibt keine Analyse %1%2</translation>
    </message>
    <message>
        <source>the contents of the report</source>
        <translation>der Inhalt des Berichts</translation>
    </message>
    <message>
        <source>a requirement</source>
        <translation>eine Anforderung</translation>
    </message>
    <message>
        <source>a unit of length is needed here, not %1</source>
        <translation>hier ist eine Längeneinheit nötig, nicht %1</translation>
    </message>
    <message>
        <source>the size of a view must be greater than zero</source>
        <translation>die Größe einer Ansicht muss größer als null sein</translation>
    </message>
    <message>
        <source>&apos;direction&apos; and &apos;up&apos; must be two different directions, not of length zero</source>
        <translation>&apos;direction&apos; und &apos;up&apos; müssen zwei verschiedene Richtungen sein, nicht der Länge null</translation>
    </message>
    <message>
        <source>a view</source>
        <translation>eine Ansicht</translation>
    </message>
    <message>
        <source>%1 is the name of a standard view</source>
        <translation>%1 ist der Name einer Standardansicht</translation>
    </message>
    <message>
        <source>the name %1 is used twice</source>
        <translation>der Name %1 wird zweimal verwendet</translation>
    </message>
    <message>
        <source>there is no single value here, but a list or a group</source>
        <translation>hier steht kein einzelner Wert, sondern eine Liste oder Gruppe</translation>
    </message>
    <message>
        <source>there is nothing called &apos;%1&apos; to set</source>
        <translation>&apos;%1&apos; gibt es hier nicht zu setzen</translation>
    </message>
    <message>
        <source>there is nothing called &apos;%1&apos; to set%2</source>
        <translation>&apos;%1&apos; gibt es hier nicht zu setzen%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not of the form /PLACE/IN/THE/PROJECT=VALUE</source>
        <translation>&apos;%1&apos; hat nicht die Form /PLACE/IN/THE/PROJECT=VALUE</translation>
    </message>
    <message>
        <source>%1 is a table: it needs &quot;columns&quot; and &quot;rows&quot;, or the name of a &quot;csv&quot; file</source>
        <translation>%1 ist eine Tabelle: sie braucht &quot;columns&quot; und &quot;rows&quot; oder den Namen einer &quot;csv&quot;-Datei</translation>
    </message>
    <message>
        <source>the columns of %1 must be texts in quotes</source>
        <translation>die Spalten von %1 müssen Texte in Anführungszeichen sein</translation>
    </message>
    <message>
        <source>row %1 of %2 must be a list in brackets, not %3</source>
        <translation>Zeile %1 von %2 muss eine Liste in Klammern sein, nicht %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in row %2 of %3 must be %4, not %5</source>
        <translation>&apos;%1&apos; in Zeile %2 von %3 muss %4 sein, nicht %5</translation>
    </message>
    <message>
        <source>a text in quotes</source>
        <translation>ein Text in Anführungszeichen</translation>
    </message>
    <message>
        <source>the columns of the CSV file of %1 must be an object in braces: a header of the file and the column it stands for</source>
        <translation>die Spalten der CSV-Datei von %1 müssen ein Objekt in geschweiften Klammern sein: eine Überschrift der Datei und die Spalte, für die sie steht</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must stand for a column of %2 (a text), or for none (an empty text)</source>
        <translation>&apos;%1&apos; muss für eine Spalte von %2 stehen (ein Text) oder für keine (ein leerer Text)</translation>
    </message>
    <message>
        <source>the CSV file &apos;%1&apos; of %2 must be named relative to the project&apos;s folder and lie in it</source>
        <translation>die CSV-Datei &apos;%1&apos; von %2 muss relativ zum Ordner des Projekts angegeben sein und darin liegen</translation>
    </message>
    <message>
        <source>the CSV file of %1 does not exist: looked for &apos;%2&apos;</source>
        <translation>die CSV-Datei von %1 gibt es nicht: gesucht wurde &apos;%2&apos;</translation>
    </message>
    <message>
        <source>CSV file of %1: %2</source>
        <translation>CSV-Datei von %1: %2</translation>
    </message>
    <message>
        <source>%1 must be a whole number, not %2</source>
        <translation>%1 muss eine ganze Zahl sein, nicht %2</translation>
    </message>
    <message>
        <source>%1 is %2; its unit is missing: write {&quot;value&quot;: %3, &quot;unit&quot;: &quot;%4&quot;}</source>
        <translation>%1 ist %2; die Einheit fehlt: {&quot;value&quot;: %3, &quot;unit&quot;: &quot;%4&quot;} schreiben</translation>
    </message>
    <message>
        <source>%1 must be a number, not %2</source>
        <translation>%1 muss eine Zahl sein, nicht %2</translation>
    </message>
    <message>
        <source>%1 must be a text in quotes, not %2</source>
        <translation>%1 muss ein Text in Anführungszeichen sein, nicht %2</translation>
    </message>
    <message>
        <source>the lines of %1 must be texts in quotes, each one line</source>
        <translation>die Zeilen von %1 müssen Texte in Anführungszeichen sein, jeder einzeilig</translation>
    </message>
    <message>
        <source>%1 must be true or false, not %2</source>
        <translation>%1 muss true oder false sein, nicht %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; of %2 must be a list of three numbers</source>
        <translation>&apos;%1&apos; von %2 muss eine Liste aus drei Zahlen sein</translation>
    </message>
    <message>
        <source>this set-up</source>
        <translation>dieser Aufbau</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be three numbers: x, y, z</source>
        <translation>&apos;%1&apos; muss aus drei Zahlen bestehen: x, y, z</translation>
    </message>
    <message>
        <source>a text is needed here, not %1</source>
        <translation>hier ist ein Text nötig, nicht %1</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>the project ends before this: nothing may follow its closing &apos;}&apos;</source>
        <translation>das Projekt endet vorher: auf das schließende &apos;}&apos; darf nichts folgen</translation>
    </message>
    <message>
        <source>%1 (column %2)</source>
        <translation>%1 (Spalte %2)</translation>
    </message>
    <message>
        <source>the file is truncated: it ends %1; its rest is missing</source>
        <translation>die Datei ist abgeschnitten: sie endet %1; der Rest fehlt</translation>
    </message>
    <message>
        <source>lists and objects are nested too deeply</source>
        <translation>Listen und Objekte sind zu tief verschachtelt</translation>
    </message>
    <message>
        <source>where a value is expected</source>
        <translation>wo ein Wert erwartet wird</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is too large a number</source>
        <translation>&apos;%1&apos; ist eine zu große Zahl</translation>
    </message>
    <message>
        <source>in the middle of a value</source>
        <translation>mitten in einem Wert</translation>
    </message>
    <message>
        <source>a value is expected here (a number, a text in quotes, a list or an object), not &apos;%1&apos;</source>
        <translation>hier wird ein Wert erwartet (eine Zahl, ein Text in Anführungszeichen, eine Liste oder ein Objekt), nicht &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number that a project file can hold: give a finite number, or null where infinity is meant</source>
        <translation>&apos;%1&apos; ist keine Zahl, die eine Projektdatei enthalten kann: eine endliche Zahl angeben oder null, wo unendlich gemeint ist</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a value: texts stand in double quotes, numbers are written like -12.5e-3</source>
        <translation>&apos;%1&apos; ist kein Wert: Texte stehen in doppelten Anführungszeichen, Zahlen schreibt man wie -12.5e-3</translation>
    </message>
    <message>
        <source>the text that begins here is not closed by a double quote on its line</source>
        <translation>der hier beginnende Text ist in seiner Zeile nicht durch ein doppeltes Anführungszeichen geschlossen</translation>
    </message>
    <message>
        <source>in the middle of a text</source>
        <translation>mitten in einem Text</translation>
    </message>
    <message>
        <source>inside %1</source>
        <translation>innerhalb von %1</translation>
    </message>
    <message>
        <source>&apos;,&apos; or &apos;%1&apos; is expected here, inside %2, not &apos;%3&apos;</source>
        <translation>&apos;,&apos; oder &apos;%1&apos; wird hier erwartet (%2), nicht &apos;%3&apos;</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>a key in double quotes is expected here</source>
        <translation>hier wird ein Schlüssel in doppelten Anführungszeichen erwartet</translation>
    </message>
    <message>
        <source>the key before this is not a valid text</source>
        <translation>der Schlüssel davor ist kein gültiger Text</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is given twice in the same object</source>
        <translation>&apos;%1&apos; ist im selben Objekt zweimal angegeben</translation>
    </message>
    <message>
        <source>after the key &apos;%1&apos;</source>
        <translation>nach dem Schlüssel &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;:&apos; is expected after the key &apos;%1&apos;</source>
        <translation>&apos;:&apos; wird nach dem Schlüssel &apos;%1&apos; erwartet</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>there is no kind of asset &apos;%1&apos;%2; known are %3</source>
        <translation>es gibt keine Art von Betriebsmittel &apos;%1&apos;%2; bekannt sind %3</translation>
    </message>
    <message>
        <source>there is no measurement model &apos;%1&apos;%2; known are %3</source>
        <translation>es gibt kein Messmodell &apos;%1&apos;%2; bekannt sind %3</translation>
    </message>
    <message>
        <source>%1 is taken from another analysis, with all its uncertainty: remove either this or the link</source>
        <translation>%1 wird mit seiner ganzen Unsicherheit aus einer anderen Analyse übernommen: entweder dies oder die Verknüpfung entfernen</translation>
    </message>
    <message>
        <source>the analysis %1 has errors of its own: %2</source>
        <translation>die Analyse %1 hat eigene Fehler: %2</translation>
    </message>
    <message>
        <source>the analysis %1 has no value at its estimates</source>
        <translation>die Analyse %1 hat bei ihren Schätzwerten keinen Wert</translation>
    </message>
    <message>
        <source>the component %1 is not stated alike (held, or edited) by all analyses of the chain: they are taken as independent</source>
        <translation>die Komponente %1 ist nicht in allen Analysen der Kette gleich angegeben (festgehalten oder bearbeitet): sie gelten als unabhängig</translation>
    </message>
    <message>
        <source>%1 is linked twice</source>
        <translation>%1 ist zweimal verknüpft</translation>
    </message>
    <message>
        <source>%1 is %2; %3 of %4 is %5</source>
        <translation>%1 ist %2; %3 von %4 ist %5</translation>
    </message>
    <message>
        <source>the analysis %1 would be made of itself: %2%3</source>
        <translation>die Analyse %1 würde aus sich selbst gebildet: %2%3</translation>
    </message>
    <message>
        <source>the analysis %1 has no output %2%3</source>
        <translation>die Analyse %1 hat keine Ausgangsgröße %2%3</translation>
    </message>
    <message>
        <source>&apos;schemaVersion&apos; is missing</source>
        <translation>&apos;schemaVersion&apos; fehlt</translation>
    </message>
    <message>
        <source>&apos;schemaVersion&apos; must be a whole number</source>
        <translation>&apos;schemaVersion&apos; muss eine ganze Zahl sein</translation>
    </message>
    <message>
        <source>written by a newer version of Covaria (schema %1, this program reads up to %2); nothing was changed</source>
        <translation>von einer neueren Version von Covaria geschrieben (Schema %1, dieses Programm liest bis %2); nichts wurde geändert</translation>
    </message>
    <message>
        <source>the text &apos;%1&apos;</source>
        <translation>der Text &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the number %1</source>
        <translation>die Zahl %1</translation>
    </message>
    <message>
        <source>%1 must be an object in braces, not %2</source>
        <translation>%1 muss ein Objekt in geschweiften Klammern sein, nicht %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is missing in %2</source>
        <translation>%2: &apos;%1&apos; fehlt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be %2, not %3</source>
        <translation>&apos;%1&apos; muss %2 sein, nicht %3</translation>
    </message>
    <message>
        <source>a list in brackets</source>
        <translation>eine Liste in Klammern</translation>
    </message>
    <message>
        <source>there is no &apos;%1&apos; in %2%3</source>
        <translation>%2: es gibt kein &apos;%1&apos;%3</translation>
    </message>
    <message>
        <source>a number with its unit</source>
        <translation>eine Zahl mit ihrer Einheit</translation>
    </message>
    <message>
        <source>a whole number from 0 to 18446744073709551615, in quotes</source>
        <translation>eine ganze Zahl von 0 bis 18446744073709551615, in Anführungszeichen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be %2; it is %3</source>
        <translation>&apos;%1&apos; muss %2 sein; angegeben ist %3</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>eines von %1</translation>
    </message>
    <message>
        <source>a whole number that is not negative</source>
        <translation>eine ganze, nicht negative Zahl</translation>
    </message>
    <message>
        <source>a text here is not valid UTF-8 or has a wrong \ sequence</source>
        <translation>ein Text ist hier kein gültiges UTF-8 oder hat eine falsche \-Folge</translation>
    </message>
    <message>
        <source>the project</source>
        <translation>das Projekt</translation>
    </message>
    <message>
        <source>an asset</source>
        <translation>ein Betriebsmittel</translation>
    </message>
    <message>
        <source>an analysis</source>
        <translation>eine Analyse</translation>
    </message>
    <message>
        <source>this is not a project of Covaria: it does not begin with &quot;format&quot;: &quot;covaria&quot;</source>
        <translation>dies ist kein Projekt von Covaria: es beginnt nicht mit &quot;format&quot;: &quot;covaria&quot;</translation>
    </message>
    <message>
        <source>it has %1 MB, and projects of up to %2 MB are read: put its long tables into CSV files beside it</source>
        <translation>es hat %1 MB, gelesen werden Projekte bis %2 MB: lange Tabellen in CSV-Dateien daneben auslagern</translation>
    </message>
    <message>
        <source>the project was not saved: it holds a number that is not finite, or fields that belong to no known kind of asset or model</source>
        <translation>das Projekt wurde nicht gespeichert: es enthält eine nicht endliche Zahl oder Felder, die zu keiner bekannten Art von Betriebsmittel oder Modell gehören</translation>
    </message>
    <message>
        <source>the project was not saved: %1</source>
        <translation>das Projekt wurde nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be two capital letters, such as DE; it is &apos;%2&apos;</source>
        <translation>&apos;%1&apos; muss aus zwei Großbuchstaben bestehen, etwa DE; es ist &apos;%2&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be one of %2; it is &apos;%3&apos;</source>
        <translation>&apos;%1&apos; muss eines von %2 sein; es ist &apos;%3&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a date of the form 2026-04-17 or an interval 2026-04-17/2026-04-18; it is &apos;%2&apos;</source>
        <translation>&apos;%1&apos; muss ein Datum der Form 2026-04-17 oder ein Zeitraum 2026-04-17/2026-04-18 sein; es ist &apos;%2&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a date of the form 2026-04-17; it is &apos;%2&apos;</source>
        <translation>&apos;%1&apos; muss ein Datum der Form 2026-04-17 sein; es ist &apos;%2&apos;</translation>
    </message>
    <message>
        <source>the item cannot have been calibrated before it was received</source>
        <translation>der Gegenstand kann nicht kalibriert worden sein, bevor er eingegangen ist</translation>
    </message>
    <message>
        <source>the certificate cannot have been issued before the calibration</source>
        <translation>der Kalibrierschein kann nicht vor der Kalibrierung ausgestellt worden sein</translation>
    </message>
    <message>
        <source> (or %1)</source>
        <translation> (oder %1)</translation>
    </message>
    <message>
        <source>&apos;%1&apos;%2 must be stated (ISO/IEC 17025 %3)</source>
        <translation>&apos;%1&apos;%2 muss angegeben werden (ISO/IEC 17025 %3)</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be stated (Digital Calibration Certificate)</source>
        <translation>&apos;%1&apos; muss angegeben werden (Digitaler Kalibrierschein)</translation>
    </message>
    <message>
        <source>the certificate</source>
        <translation>der Kalibrierschein</translation>
    </message>
    <message>
        <source>%1 has more than 2 MB, too much for a logo</source>
        <translation>%1 hat mehr als 2 MB, zu viel für ein Logo</translation>
    </message>
    <message>
        <source>%1 is neither a PNG nor a JPEG picture</source>
        <translation>%1 ist weder ein PNG- noch ein JPEG-Bild</translation>
    </message>
    <message>
        <source>The certificate has no logo: %1</source>
        <translation>Der Kalibrierschein hat kein Logo: %1</translation>
    </message>
    <message>
        <source>more than %1 columns are not read</source>
        <translation>mehr als %1 Spalten werden nicht gelesen</translation>
    </message>
    <message>
        <source>the quote that begins here is not closed</source>
        <translation>das hier beginnende Anführungszeichen ist nicht geschlossen</translation>
    </message>
    <message>
        <source>text follows the closing quote of a cell; write a quote inside a quoted cell twice</source>
        <translation>auf das schließende Anführungszeichen einer Zelle folgt Text; ein Anführungszeichen in einer solchen Zelle doppelt schreiben</translation>
    </message>
    <message>
        <source>the text is encoded as UTF-16; save it as UTF-8</source>
        <translation>der Text ist als UTF-16 codiert; als UTF-8 speichern</translation>
    </message>
    <message>
        <source>the text is not encoded as UTF-8; save it as UTF-8</source>
        <translation>der Text ist nicht als UTF-8 codiert; als UTF-8 speichern</translation>
    </message>
    <message>
        <source>this row has %1 cells; there are %2 columns</source>
        <translation>diese Zeile hat %1 Zellen; es gibt %2 Spalten</translation>
    </message>
    <message>
        <source>column &apos;%1&apos;: &apos;%2&apos; is not a number</source>
        <translation>Spalte &apos;%1&apos;: &apos;%2&apos; ist keine Zahl</translation>
    </message>
    <message>
        <source>column &apos;%1&apos;: &apos;%2&apos; is neither true nor false</source>
        <translation>Spalte &apos;%1&apos;: &apos;%2&apos; ist weder true noch false</translation>
    </message>
    <message>
        <source>the file has no column &apos;%1&apos;%2; its columns are %3</source>
        <translation>die Datei hat keine Spalte &apos;%1&apos;%2; ihre Spalten sind %3</translation>
    </message>
    <message>
        <source>there is no row with the names of the columns</source>
        <translation>es gibt keine Zeile mit den Namen der Spalten</translation>
    </message>
    <message>
        <source>it has %1 lines, and there is memory for about %2 of these rows: leave rows out, or take means of several</source>
        <translation>sie hat %1 Zeilen, und der Speicher reicht für etwa %2 davon: Zeilen weglassen oder Mittelwerte mehrerer nehmen</translation>
    </message>
    <message>
        <source>a table to choose from is written as &quot;/setup/KEY/rows&quot;; it is %1</source>
        <translation>eine Tabelle zur Auswahl wird als &quot;/setup/KEY/rows&quot; geschrieben; angegeben ist %1</translation>
    </message>
    <message>
        <source>a design needs &apos;variables&apos;, a table to &apos;choose&apos; from, or &apos;reductions&apos;</source>
        <translation>ein Entwurf braucht &apos;variables&apos;, eine Tabelle für &apos;choose&apos; oder &apos;reductions&apos;</translation>
    </message>
    <message>
        <source>the cheapest reductions are a design of their own, without variables and rows</source>
        <translation>die günstigsten Verringerungen sind ein eigener Entwurf, ohne Variablen und Zeilen</translation>
    </message>
    <message>
        <source>a design has at most %1 reductions</source>
        <translation>ein Entwurf hat höchstens %1 Verringerungen</translation>
    </message>
    <message>
        <source>a design has at most %1 variables</source>
        <translation>ein Entwurf hat höchstens %1 Variablen</translation>
    </message>
    <message>
        <source>the cost is that of rows with &apos;prices&apos;: it needs a table to choose from, and no variables</source>
        <translation>die Kosten sind die der Zeilen mit &apos;prices&apos;: nötig ist eine Tabelle zur Auswahl, ohne Variablen</translation>
    </message>
    <message>
        <source>a tolerance must not be negative</source>
        <translation>eine Toleranz darf nicht negativ sein</translation>
    </message>
    <message>
        <source>&apos;%1&apos; takes whole numbers: a study shows what each of them gives</source>
        <translation>&apos;%1&apos; nimmt ganze Zahlen: eine Studie zeigt, was jede davon ergibt</translation>
    </message>
    <message>
        <source>%1 is chosen by two variables</source>
        <translation>%1 wird von zwei Variablen gewählt</translation>
    </message>
    <message>
        <source>the smallest factor is between 0 and 1</source>
        <translation>der kleinste Faktor liegt zwischen 0 und 1</translation>
    </message>
    <message>
        <source>a price must not be negative</source>
        <translation>ein Preis darf nicht negativ sein</translation>
    </message>
    <message>
        <source>%1 is reduced twice</source>
        <translation>%1 wird zweimal verringert</translation>
    </message>
    <message>
        <source>of %1 rows, %2 to %3 can be kept; it is %4</source>
        <translation>von %1 Zeilen können %2 bis %3 behalten werden; angegeben ist %4</translation>
    </message>
    <message>
        <source>there are %1 rows, counted from 0</source>
        <translation>es gibt %1 Zeilen, ab 0 gezählt</translation>
    </message>
    <message>
        <source>row %1 is fixed twice</source>
        <translation>Zeile %1 ist zweimal festgelegt</translation>
    </message>
    <message>
        <source>more rows are fixed than kept</source>
        <translation>es sind mehr Zeilen festgelegt als behalten</translation>
    </message>
    <message>
        <source>there is one price for all rows, or one for each of the %1; there are %2</source>
        <translation>es gibt einen Preis für alle Zeilen oder einen für jede der %1; angegeben sind %2</translation>
    </message>
    <message>
        <source>a box</source>
        <translation>ein Kasten</translation>
    </message>
    <message>
        <source>every coordinate of &apos;to&apos; must be greater than that of &apos;from&apos;</source>
        <translation>jede Koordinate von &apos;to&apos; muss größer sein als die von &apos;from&apos;</translation>
    </message>
    <message>
        <source>the least distance</source>
        <translation>der kleinste Abstand</translation>
    </message>
    <message>
        <source>the least distance must be greater than zero</source>
        <translation>der kleinste Abstand muss größer als null sein</translation>
    </message>
    <message>
        <source>there are 1 to %1 starts</source>
        <translation>es gibt 1 bis %1 Starts</translation>
    </message>
    <message>
        <source>at least one evaluation is needed</source>
        <translation>mindestens eine Auswertung ist nötig</translation>
    </message>
    <message>
        <source>the set-up has no table %1%2</source>
        <translation>der Aufbau hat keine Tabelle %1%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be %2; it is &apos;%3&apos;</source>
        <translation>&apos;%1&apos; muss %2 sein; angegeben ist &apos;%3&apos;</translation>
    </message>
    <message>
        <source>a variable of a design</source>
        <translation>eine Variable eines Entwurfs</translation>
    </message>
    <message>
        <source>a number that is reduced</source>
        <translation>eine Zahl, die verringert wird</translation>
    </message>
    <message>
        <source>a reduction of a design</source>
        <translation>eine Verringerung eines Entwurfs</translation>
    </message>
    <message>
        <source>the choice of a design</source>
        <translation>die Auswahl eines Entwurfs</translation>
    </message>
    <message>
        <source>a box of a design</source>
        <translation>ein Kasten eines Entwurfs</translation>
    </message>
    <message>
        <source>a design</source>
        <translation>ein Entwurf</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a list of numbers</source>
        <translation>&apos;%1&apos; muss eine Liste von Zahlen sein</translation>
    </message>
    <message>
        <source>the parameters of &apos;%1&apos;</source>
        <translation>die Parameter von &apos;%1&apos;</translation>
    </message>
    <message>
        <source>a distribution</source>
        <translation>eine Verteilung</translation>
    </message>
    <message>
        <source>there is no distribution &apos;%1&apos;%2; known are %3</source>
        <translation>es gibt keine Verteilung &apos;%1&apos;%2; bekannt sind %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is missing in a component</source>
        <translation>&apos;%1&apos; fehlt in einer Komponente</translation>
    </message>
    <message>
        <source>a component</source>
        <translation>eine Komponente</translation>
    </message>
    <message>
        <source>the edit of an input quantity</source>
        <translation>die Bearbeitung einer Eingangsgröße</translation>
    </message>
    <message>
        <source>the notes of a quantity</source>
        <translation>die Anmerkungen einer Größe</translation>
    </message>
    <message>
        <source>an output of an analysis</source>
        <translation>eine Ausgangsgröße einer Analyse</translation>
    </message>
    <message>
        <source>a link</source>
        <translation>eine Verknüpfung</translation>
    </message>
    <message>
        <source>a correlation</source>
        <translation>eine Korrelation</translation>
    </message>
    <message>
        <source>component %1</source>
        <translation>Komponente %1</translation>
    </message>
    <message>
        <source>%1 is %2; the unit %3 of %4 is the unit of %5</source>
        <translation>%1 ist %2; zur Einheit %3 von %4 gehört %5</translation>
    </message>
    <message>
        <source>%1: the degrees of freedom must be greater than zero</source>
        <translation>%1: die Freiheitsgrade müssen größer als null sein</translation>
    </message>
    <message>
        <source>%1 is a component, not an input quantity: it can be held, but not be edited otherwise</source>
        <translation>%1 ist eine Komponente, keine Eingangsgröße: sie kann festgehalten, aber nicht anders bearbeitet werden</translation>
    </message>
    <message>
        <source>%1 has no uncertainty to be correlated</source>
        <translation>%1 hat keine Unsicherheit, die korreliert sein könnte</translation>
    </message>
    <message>
        <source>there is no component or quantity %1%2</source>
        <translation>es gibt keine Komponente oder Größe %1%2</translation>
    </message>
    <message>
        <source>%1 cannot be correlated with itself</source>
        <translation>%1 kann nicht mit sich selbst korreliert sein</translation>
    </message>
    <message>
        <source>%1 and %2 have the component %3 in common, which correlates them; state the correlation of other components instead</source>
        <translation>%1 und %2 haben die Komponente %3 gemeinsam, was sie korreliert; stattdessen die Korrelation anderer Komponenten angeben</translation>
    </message>
    <message>
        <source>%1 is edited twice</source>
        <translation>%1 wird zweimal bearbeitet</translation>
    </message>
    <message>
        <source>the correlation of %1 and %2 is given twice</source>
        <translation>die Korrelation von %1 und %2 ist zweimal angegeben</translation>
    </message>
    <message>
        <source>a number is needed here; it is %1</source>
        <translation>hier wird eine Zahl gebraucht; es ist %1</translation>
    </message>
    <message>
        <source>%1: %2 must lie within %3</source>
        <translation>%1: %2 muss in %3 liegen</translation>
    </message>
    <message>
        <source>the frame of %1 is missing</source>
        <translation>das System von %1 fehlt</translation>
    </message>
    <message>
        <source>no calibration of a robot: &apos;kinematics&apos; is missing</source>
        <translation>keine Kalibrierung eines Roboters: &apos;kinematics&apos; fehlt</translation>
    </message>
    <message>
        <source>calibration %1</source>
        <translation>Kalibrierung %1</translation>
    </message>
    <message>
        <source>lengths in m, angles in rad, about fixed axes as in URDF</source>
        <translation>Längen in m, Winkel in rad, um feste Achsen wie in URDF</translation>
    </message>
    <message>
        <source>%1 is called %2 here</source>
        <translation>%1 heißt hier %2</translation>
    </message>
    <message>
        <source>an input without a name</source>
        <translation>eine Eingangsgröße ohne Namen</translation>
    </message>
    <message>
        <source>its %1 must be a number</source>
        <translation>%1 muss eine Zahl sein</translation>
    </message>
    <message>
        <source>there are two inputs of that name</source>
        <translation>es gibt zwei Eingangsgrößen dieses Namens</translation>
    </message>
    <message>
        <source>%1 %2 is %3 %4</source>
        <translation>%1 %2 ist %3 %4</translation>
    </message>
    <message>
        <source>typea_uncert must be a number from 0</source>
        <translation>typea_uncert muss eine Zahl ab 0 sein</translation>
    </message>
    <message>
        <source>typea must be a list of at least two observations</source>
        <translation>typea muss eine Liste von mindestens zwei Beobachtungen sein</translation>
    </message>
    <message>
        <source>an observation must be a number; those in groups are not read</source>
        <translation>eine Beobachtung muss eine Zahl sein; solche in Gruppen werden nicht gelesen</translation>
    </message>
    <message>
        <source>more than %1 observations are not read</source>
        <translation>mehr als %1 Beobachtungen werden nicht gelesen</translation>
    </message>
    <message>
        <source>numnewmeas must be a number from 1</source>
        <translation>numnewmeas muss eine Zahl ab 1 sein</translation>
    </message>
    <message>
        <source>its observations are taken as independent: Suncal enlarges the uncertainty of more than 50 that are autocorrelated</source>
        <translation>ihre Beobachtungen gelten als unabhängig: Suncal vergrößert die Unsicherheit von mehr als 50, die autokorreliert sind</translation>
    </message>
    <message>
        <source>%1 %2 is no number</source>
        <translation>%1 %2 ist keine Zahl</translation>
    </message>
    <message>
        <source>%1 %2 is %3</source>
        <translation>%1 %2 ist %3</translation>
    </message>
    <message>
        <source>degf must be a number greater than 0, or .inf</source>
        <translation>degf muss eine Zahl größer als 0 oder .inf sein</translation>
    </message>
    <message>
        <source>; it has %1</source>
        <translation>; vorhanden: %1</translation>
    </message>
    <message>
        <source>the file has no calculation of mode &apos;uncertainty&apos; or &apos;system&apos;%1</source>
        <translation>die Datei hat keine Berechnung der Art &apos;uncertainty&apos; oder &apos;system&apos;%1</translation>
    </message>
    <message>
        <source>%1: %2 quantities, %3 results</source>
        <translation>%1: %2 Größen, %3 Ergebnisse</translation>
    </message>
    <message>
        <source>the calculation has no inputs</source>
        <translation>die Berechnung hat keine Eingangsgrößen</translation>
    </message>
    <message>
        <source>the calculation has no functions</source>
        <translation>die Berechnung hat keine Funktionen</translation>
    </message>
    <message>
        <source>the system has no quantities</source>
        <translation>das System hat keine Größen</translation>
    </message>
    <message>
        <source>quantities of type %1 are not read; those that are: direct, indirect</source>
        <translation>Größen vom Typ %1 werden nicht gelesen; gelesen werden: direct, indirect</translation>
    </message>
    <message>
        <source>the system has no direct quantity</source>
        <translation>das System hat keine direkte Größe</translation>
    </message>
    <message>
        <source>more than %1 inputs are not read</source>
        <translation>mehr als %1 Eingangsgrößen werden nicht gelesen</translation>
    </message>
    <message>
        <source>more than %1 functions are not read</source>
        <translation>mehr als %1 Funktionen werden nicht gelesen</translation>
    </message>
    <message>
        <source>a function has the name of an input or of another function</source>
        <translation>eine Funktion hat den Namen einer Eingangsgröße oder einer anderen Funktion</translation>
    </message>
    <message>
        <source>%1: in %2 instead of %3</source>
        <translation>%1: in %2 statt %3</translation>
    </message>
    <message>
        <source>%1: no starting value</source>
        <translation>%1: kein Startwert</translation>
    </message>
    <message>
        <source>%1: state the unit of what is solved for under &apos;units&apos;</source>
        <translation>%1: die Einheit dessen, wonach aufgelöst wird, unter &apos;units&apos; angeben</translation>
    </message>
    <message>
        <source>a correlation needs var1 and var2, two inputs, and cor, a number between -1 and 1</source>
        <translation>eine Korrelation braucht var1 und var2, zwei Eingangsgrößen, und cor, eine Zahl zwischen -1 und 1</translation>
    </message>
    <message>
        <source>no unit can be stated for %1%2</source>
        <translation>für %1 kann keine Einheit angegeben werden%2</translation>
    </message>
    <message>
        <source>the file has no Excel workbook in it</source>
        <translation>die Datei enthält keine Excel-Arbeitsmappe</translation>
    </message>
    <message>
        <source>the file has no sheet with cells</source>
        <translation>die Datei hat kein Blatt mit Zellen</translation>
    </message>
    <message>
        <source>%1: %2 is no place of a cell</source>
        <translation>%1: %2 ist kein Ort einer Zelle</translation>
    </message>
    <message>
        <source>%1: more than %2 cells are not read</source>
        <translation>%1: mehr als %2 Zellen werden nicht gelesen</translation>
    </message>
    <message>
        <source>its text is missing from the file</source>
        <translation>der Text fehlt in der Datei</translation>
    </message>
    <message>
        <source>the file has a password or the old format .xls: save it as .xlsx without a password</source>
        <translation>die Datei hat ein Kennwort oder das alte Format .xls: als .xlsx ohne Kennwort speichern</translation>
    </message>
    <message>
        <source>XML of more than %1 MB is not read</source>
        <translation>XML von mehr als %1 MB wird nicht gelesen</translation>
    </message>
    <message>
        <source>a document type declaration: files that declare entities are not read</source>
        <translation>eine Dokumenttypdeklaration: Dateien, die Entitäten deklarieren, werden nicht gelesen</translation>
    </message>
    <message>
        <source>an alias (*name): write out what it stands for, aliases are not expanded</source>
        <translation>ein Alias (*name): ausschreiben, wofür er steht, Aliasse werden nicht aufgelöst</translation>
    </message>
    <message>
        <source>more than %1 entries are not read</source>
        <translation>mehr als %1 Einträge werden nicht gelesen</translation>
    </message>
    <message>
        <source>more than %1 levels are not read</source>
        <translation>mehr als %1 Ebenen werden nicht gelesen</translation>
    </message>
    <message>
        <source>a key must be a word</source>
        <translation>ein Schlüssel muss ein Wort sein</translation>
    </message>
    <message>
        <source>the key %1 stands twice</source>
        <translation>der Schlüssel %1 steht zweimal da</translation>
    </message>
    <message>
        <source>more than 1000 keys are not read</source>
        <translation>mehr als 1000 Schlüssel werden nicht gelesen</translation>
    </message>
    <message>
        <source>YAML of more than %1 kB is not read</source>
        <translation>YAML von mehr als %1 kB wird nicht gelesen</translation>
    </message>
    <message>
        <source>the file has no YAML document</source>
        <translation>die Datei hat kein YAML-Dokument</translation>
    </message>
    <message>
        <source>not readable as YAML: %1</source>
        <translation>nicht als YAML lesbar: %1</translation>
    </message>
    <message>
        <source>the file has %1</source>
        <translation>die Datei hat %1</translation>
    </message>
    <message>
        <source>no readable zip archive in it (%1)</source>
        <translation>kein lesbares Zip-Archiv (%1)</translation>
    </message>
    <message>
        <source>more than %1 parts, which are not read</source>
        <translation>mehr als %1 Teile, die nicht gelesen werden</translation>
    </message>
    <message>
        <source>no part %1</source>
        <translation>keinen Teil %1</translation>
    </message>
    <message>
        <source>a part %1 that cannot be read</source>
        <translation>einen Teil %1, der nicht gelesen werden kann</translation>
    </message>
    <message>
        <source>an encrypted part %1: save it without a password</source>
        <translation>einen verschlüsselten Teil %1: ohne Kennwort speichern</translation>
    </message>
    <message>
        <source>a part %1 that cannot be unpacked</source>
        <translation>einen Teil %1, der nicht entpackt werden kann</translation>
    </message>
    <message>
        <source>a damaged part %1</source>
        <translation>einen beschädigten Teil %1</translation>
    </message>
    <message>
        <source>parts that unpack to more than %1 MB (at %2), which are not read</source>
        <translation>Teile, die entpackt mehr als %1 MB ergeben (bei %2) und nicht gelesen werden</translation>
    </message>
    <message>
        <source>no network of GNU Gama: &lt;gama-local&gt; with a &lt;network&gt; is expected</source>
        <translation>kein Netz von GNU Gama: &lt;gama-local&gt; mit einem &lt;network&gt; wird erwartet</translation>
    </message>
    <message>
        <source>the stated unit of lengths: coordinates of Gama are in metres</source>
        <translation>die angegebene Längeneinheit: Koordinaten von Gama sind in Metern</translation>
    </message>
    <message>
        <source>&lt;parameters&gt;</source>
        <translation>&lt;parameters&gt;</translation>
    </message>
    <message>
        <source>%1 &lt;%2&gt; with observations</source>
        <translation>%1 &lt;%2&gt; mit Beobachtungen</translation>
    </message>
    <message>
        <source>%1 points without x and y</source>
        <translation>%1 Punkte ohne x und y</translation>
    </message>
    <message>
        <source>%1 points have no z: it is taken as 0</source>
        <translation>%1 Punkte haben kein z: es wird als 0 angenommen</translation>
    </message>
    <message>
        <source>the network has no points with coordinates x and y</source>
        <translation>das Netz hat keine Punkte mit Koordinaten x und y</translation>
    </message>
    <message>
        <source>%1 points are to be adjusted: their coordinates are approximate ones</source>
        <translation>%1 Punkte sind auszugleichen: ihre Koordinaten sind Näherungen</translation>
    </message>
    <message>
        <source>: a left-handed frame; x and y are taken as they stand</source>
        <translation>: ein linkshändiges System; x und y werden unverändert übernommen</translation>
    </message>
    <message>
        <source>coordinates in metres, axes-xy = %1%2</source>
        <translation>Koordinaten in Metern, axes-xy = %1%2</translation>
    </message>
    <message>
        <source>%1 = %2 is no number</source>
        <translation>%1 = %2 ist keine Zahl</translation>
    </message>
    <message>
        <source>too many points: divide the file</source>
        <translation>zu viele Punkte: die Datei aufteilen</translation>
    </message>
    <message>
        <source>&lt;coordinates&gt;: point %1 has no x and y</source>
        <translation>&lt;coordinates&gt;: Punkt %1 hat kein x und y</translation>
    </message>
    <message>
        <source>a covariance matrix of more than %1 coordinates</source>
        <translation>eine Kovarianzmatrix mit mehr als %1 Koordinaten</translation>
    </message>
    <message>
        <source>the file has no adjusted coordinates</source>
        <translation>die Datei hat keine ausgeglichenen Koordinaten</translation>
    </message>
    <message>
        <source>point %1 has no x and y</source>
        <translation>Punkt %1 hat kein x und y</translation>
    </message>
    <message>
        <source>adjusted coordinates in metres</source>
        <translation>ausgeglichene Koordinaten in Metern</translation>
    </message>
    <message>
        <source>uncertainties: the file has no &lt;cov-mat&gt;</source>
        <translation>Unsicherheiten: die Datei hat keine &lt;cov-mat&gt;</translation>
    </message>
    <message>
        <source>residuals and orientations</source>
        <translation>Residuen und Orientierungen</translation>
    </message>
    <message>
        <source>its dim must be at least the %1 adjusted coordinates, its band less than it</source>
        <translation>ihr dim muss mindestens die Anzahl %1 der ausgeglichenen Koordinaten sein, ihr band kleiner als dim</translation>
    </message>
    <message>
        <source>element %1, %2 is no number</source>
        <translation>Element %1, %2 ist keine Zahl</translation>
    </message>
    <message>
        <source>its dim must be the %1 %2, its band less than that</source>
        <translation>ihr dim muss der Anzahl entsprechen (%1 %2), ihr band muss kleiner sein</translation>
    </message>
    <message>
        <source>element %1, %2: %3 is no number</source>
        <translation>Element %1, %2: %3 ist keine Zahl</translation>
    </message>
    <message>
        <source>a covariance matrix of observations that are left out</source>
        <translation>eine Kovarianzmatrix ausgelassener Beobachtungen</translation>
    </message>
    <message>
        <source>the standard deviation %1 is no number</source>
        <translation>die Standardabweichung %1 ist keine Zahl</translation>
    </message>
    <message>
        <source>the standard deviation %1 must not be negative</source>
        <translation>die Standardabweichung %1 darf nicht negativ sein</translation>
    </message>
    <message>
        <source>, %1 of them without a standard deviation</source>
        <translation>, %1 davon ohne Standardabweichung</translation>
    </message>
    <message>
        <source>, %1 correlations</source>
        <translation>, %1 Korrelationen</translation>
    </message>
    <message>
        <source>%1 observations%2%3; each is its own result: write the equations of what you measure with them</source>
        <translation>%1 Beobachtungen%2%3; jede ist ihr eigenes Ergebnis: die Gleichungen dessen, was damit gemessen wird, selbst schreiben</translation>
    </message>
    <message>
        <source>%1 observations: more than %2</source>
        <translation>%1 Beobachtungen: mehr als %2</translation>
    </message>
    <message>
        <source>the stated unit of lengths: words of GSI state theirs</source>
        <translation>die angegebene Längeneinheit: GSI-Wörter geben ihre eigene an</translation>
    </message>
    <message>
        <source>words %1 (%2)</source>
        <translation>Wörter %1 (%2)</translation>
    </message>
    <message>
        <source>%1 readings of reflectors above their points: the targets are the reflectors</source>
        <translation>%1 Ablesungen zu Reflektoren über ihren Punkten: die Zielpunkte sind die Reflektoren</translation>
    </message>
    <message>
        <source>the file has neither coordinates nor readings with a distance</source>
        <translation>die Datei hat weder Koordinaten noch Ablesungen mit einer Distanz</translation>
    </message>
    <message>
        <source>the reading of %1: angles and a distance are needed</source>
        <translation>die Ablesung von %1: Winkel und eine Distanz sind nötig</translation>
    </message>
    <message>
        <source>coordinates E, N, H become x, y, z</source>
        <translation>die Koordinaten E, N, H werden zu x, y, z</translation>
    </message>
    <message>
        <source>%1: more than %2 set-ups; divide the file</source>
        <translation>%1: mehr als %2 Aufstellungen; die Datei aufteilen</translation>
    </message>
    <message>
        <source>%1: its coordinates are not in the file: 0, 0, 0</source>
        <translation>%1: seine Koordinaten stehen nicht in der Datei: 0, 0, 0</translation>
    </message>
    <message>
        <source>%1: readings of points that have coordinates</source>
        <translation>%1: Ablesungen von Punkten, die Koordinaten haben</translation>
    </message>
    <message>
        <source>%1: readings do not repeat, or are too far apart for it, and say nothing of their uncertainty: points</source>
        <translation>%1: Ablesungen wiederholen sich nicht oder liegen dafür zu weit auseinander und sagen nichts über ihre Unsicherheit: Punkte</translation>
    </message>
    <message>
        <source>no word of GSI: index, information, sign and data are expected</source>
        <translation>kein GSI-Wort: Index, Information, Vorzeichen und Daten werden erwartet</translation>
    </message>
    <message>
        <source>more than %1 blocks</source>
        <translation>mehr als %1 Blöcke</translation>
    </message>
    <message>
        <source>a block begins with the word 11 or 41</source>
        <translation>ein Block beginnt mit dem Wort 11 oder 41</translation>
    </message>
    <message>
        <source>the data of a word must be digits</source>
        <translation>die Daten eines Wortes müssen Ziffern sein</translation>
    </message>
    <message>
        <source>the unit &apos;%1&apos; is none of %2</source>
        <translation>die Einheit &apos;%1&apos; passt nicht; nötig ist %2</translation>
    </message>
    <message>
        <source>the file has no blocks of GSI</source>
        <translation>die Datei hat keine GSI-Blöcke</translation>
    </message>
    <message>
        <source>more than %1 lines are not read</source>
        <translation>mehr als %1 Zeilen werden nicht gelesen</translation>
    </message>
    <message>
        <source>the name of a section is not closed by &apos;]&apos;</source>
        <translation>der Name eines Abschnitts ist nicht durch &apos;]&apos; geschlossen</translation>
    </message>
    <message>
        <source>the section %1 stands twice</source>
        <translation>der Abschnitt %1 steht zweimal da</translation>
    </message>
    <message>
        <source>neither a section [...] nor a line name=value of one</source>
        <translation>weder ein Abschnitt [...] noch eine Zeile name=value darin</translation>
    </message>
    <message>
        <source>no quantity with a value and an uncertainty</source>
        <translation>keine Größe mit Wert und Unsicherheit</translation>
    </message>
    <message>
        <source>the file has no equation (Model[1]=)</source>
        <translation>die Datei hat keine Gleichung (Model[1]=)</translation>
    </message>
    <message>
        <source>log may be the natural or the decimal logarithm: write ln or log10</source>
        <translation>log kann der natürliche oder der dekadische Logarithmus sein: ln oder log10 schreiben</translation>
    </message>
    <message>
        <source>no file of GUM Workbench: the section [Components] is missing</source>
        <translation>keine Datei der GUM Workbench: der Abschnitt [Components] fehlt</translation>
    </message>
    <message>
        <source>the section [COMP %1] is missing</source>
        <translation>der Abschnitt [COMP %1] fehlt</translation>
    </message>
    <message>
        <source>more than %1 quantities are not read</source>
        <translation>mehr als %1 Größen werden nicht gelesen</translation>
    </message>
    <message>
        <source>%1= is missing</source>
        <translation>%1= fehlt</translation>
    </message>
    <message>
        <source>quantities of type %1 are not known; those that are: Result, TypBNormal, TypBRectang, TypAPooled</source>
        <translation>Größen vom Typ %1 sind nicht bekannt; bekannt sind: Result, TypBNormal, TypBRectang, TypAPooled</translation>
    </message>
    <message>
        <source>result %1 as the file states it: %2</source>
        <translation>Ergebnis %1 nach Angabe der Datei: %2</translation>
    </message>
    <message>
        <source>section [%1]</source>
        <translation>Abschnitt [%1]</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 Punkt</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>1 name occurs again and has got a number: first %1</source>
        <translation>1 Name kommt mehrfach vor und hat eine Nummer erhalten: zuerst %1</translation>
    </message>
    <message>
        <source>%1 names occur again and have got a number: first %2</source>
        <translation>%1 Namen kommen mehrfach vor und haben eine Nummer erhalten: zuerst %2</translation>
    </message>
    <message>
        <source>%1 groups in one artefact: their names stand before those of the points</source>
        <translation>%1 Gruppen in einem Prüfkörper: ihre Namen stehen vor denen der Punkte</translation>
    </message>
    <message>
        <source>no uncertainties are stated: u_cal is 0 until you state it</source>
        <translation>keine Unsicherheiten angegeben: u_cal ist 0, bis es angegeben wird</translation>
    </message>
    <message>
        <source>u_cal is the largest of the stated standard uncertainties: %1</source>
        <translation>u_cal ist die größte der angegebenen Standardunsicherheiten: %1</translation>
    </message>
    <message>
        <source>u_cal as stated: %1</source>
        <translation>u_cal wie angegeben: %1</translation>
    </message>
    <message>
        <source>%1 without a stated one</source>
        <translation>%1 ohne eine angegebene</translation>
    </message>
    <message>
        <source>the uncertainty of each point by itself, and correlations: only up to %1 have an analysis of their own</source>
        <translation>die Unsicherheit jedes Punktes für sich und Korrelationen: nur bis zu %1 haben eine eigene Analyse</translation>
    </message>
    <message>
        <source> and 1 correlation coefficient</source>
        <translation> und 1 Korrelationskoeffizient</translation>
    </message>
    <message>
        <source> and %1 correlation coefficients</source>
        <translation> und %1 Korrelationskoeffizienten</translation>
    </message>
    <message>
        <source>analysis &apos;Points as stated&apos;: every coordinate with its own uncertainty%1</source>
        <translation>Analyse &apos;Points as stated&apos;: jede Koordinate mit eigener Unsicherheit%1</translation>
    </message>
    <message>
        <source>the file has no points</source>
        <translation>die Datei hat keine Punkte</translation>
    </message>
    <message>
        <source>the file has no line &apos;Frame,Time (Seconds),...&apos; with data below</source>
        <translation>die Datei hat keine Zeile &apos;Frame,Time (Seconds),...&apos; mit Daten darunter</translation>
    </message>
    <message>
        <source>the file must begin with &apos;Format Version,&apos;</source>
        <translation>die Datei muss mit &apos;Format Version,&apos; beginnen</translation>
    </message>
    <message>
        <source>rotations of type %1 are not read: export the take with quaternions</source>
        <translation>Drehungen vom Typ %1 werden nicht gelesen: die Aufnahme mit Quaternionen exportieren</translation>
    </message>
    <message>
        <source>the file does not state its unit of lengths; state it</source>
        <translation>die Datei gibt ihre Längeneinheit nicht an; diese angeben</translation>
    </message>
    <message>
        <source>take %1, lengths in %2, coordinate space %3</source>
        <translation>Aufnahme %1, Längen in %2, Koordinatenraum %3</translation>
    </message>
    <message>
        <source>%1 columns of markers</source>
        <translation>%1 Spalten von Markern</translation>
    </message>
    <message>
        <source>more than %1 rigid bodies are not read</source>
        <translation>mehr als %1 Starrkörper werden nicht gelesen</translation>
    </message>
    <message>
        <source>rigid body %1: columns of its rotation (X, Y, Z, W) or position (X, Y, Z) are missing</source>
        <translation>Starrkörper %1: Spalten der Drehung (X, Y, Z, W) oder der Position (X, Y, Z) fehlen</translation>
    </message>
    <message>
        <source>the take has no rigid body</source>
        <translation>die Aufnahme hat keinen Starrkörper</translation>
    </message>
    <message>
        <source>%1 is not a number of a pose</source>
        <translation>%1 ist keine Zahl einer Pose</translation>
    </message>
    <message>
        <source>the quaternion of %1 has not the length 1</source>
        <translation>das Quaternion von %1 hat nicht die Länge 1</translation>
    </message>
    <message>
        <source>the angles about z and x of %1 are not determined: turned by 90 degrees about y. Turn the axes of the body in Motive by 90 degrees</source>
        <translation>die Winkel um z und x von %1 sind nicht bestimmt: um 90 Grad um y gedreht. In Motive die Achsen des Körpers um 90 Grad drehen</translation>
    </message>
    <message>
        <source>%1: %2 frames in which it was not seen</source>
        <translation>%1: %2 Einzelbilder, in denen er nicht zu sehen war</translation>
    </message>
    <message>
        <source>rigid body %1: at least two frames in which it is seen are needed</source>
        <translation>Starrkörper %1: mindestens zwei Einzelbilder nötig, in denen er zu sehen ist</translation>
    </message>
    <message>
        <source>rigid body %1: mean pose of %2 frames, Type A with covariance; the body must not have moved, and the frames are taken as independent</source>
        <translation>Starrkörper %1: mittlere Pose aus %2 Einzelbildern, Typ A mit Kovarianz; der Körper darf sich nicht bewegt haben, und die Einzelbilder gelten als unabhängig</translation>
    </message>
    <message>
        <source>unit &quot;%1&quot;: write it without parentheses</source>
        <translation>Einheit &quot;%1&quot;: ohne Klammern schreiben</translation>
    </message>
    <message>
        <source>the exponents are too large</source>
        <translation>die Exponenten sind zu groß</translation>
    </message>
    <message>
        <source>%1; state the columns: %2</source>
        <translation>%1; die Spalten angeben: %2</translation>
    </message>
    <message>
        <source>there is no column %1%2</source>
        <translation>es gibt keine Spalte %1%2</translation>
    </message>
    <message>
        <source>more than %1 points: divide the file</source>
        <translation>mehr als %1 Punkte: die Datei aufteilen</translation>
    </message>
    <message>
        <source> is empty</source>
        <translation> ist leer</translation>
    </message>
    <message>
        <source> is not a number</source>
        <translation> ist keine Zahl</translation>
    </message>
    <message>
        <source>: an uncertainty must not be negative</source>
        <translation>: eine Unsicherheit darf nicht negativ sein</translation>
    </message>
    <message>
        <source> is too large</source>
        <translation> ist zu groß</translation>
    </message>
    <message>
        <source>the line has %1 columns instead of %2; put names that contain blanks into quotes</source>
        <translation>die Zeile hat %1 Spalten statt %2; Namen mit Leerzeichen in Anführungszeichen setzen</translation>
    </message>
    <message>
        <source>what stands behind column %1</source>
        <translation>was hinter Spalte %1 steht</translation>
    </message>
    <message>
        <source>lengths are taken as mm: the file does not say its unit</source>
        <translation>Längen gelten als mm: die Datei nennt ihre Einheit nicht</translation>
    </message>
    <message>
        <source>column %1%2</source>
        <translation>Spalte %1%2</translation>
    </message>
    <message>
        <source>%1 lines above the headers</source>
        <translation>%1 Zeilen über den Überschriften</translation>
    </message>
    <message>
        <source>%1 lines of comment</source>
        <translation>%1 Kommentarzeilen</translation>
    </message>
    <message>
        <source>the table has no line of headers; state the columns: %1</source>
        <translation>die Tabelle hat keine Zeile mit Überschriften; die Spalten angeben: %1</translation>
    </message>
    <message>
        <source>its columns may mean several things (names that are numbers, offsets, weights, tolerances, notes); state the columns: %1</source>
        <translation>ihre Spalten können mehreres bedeuten (Namen aus Zahlen, Offsets, Gewichte, Toleranzen, Anmerkungen); die Spalten angeben: %1</translation>
    </message>
    <message>
        <source>six numbers may be X Y Z Ux Uy Uz, but also X Y Z with weights, a vector or the angles of a frame: name the reader if they are uncertainties, or state the columns: %1</source>
        <translation>sechs Zahlen können X Y Z Ux Uy Uz sein, aber auch X Y Z mit Gewichten, einem Vektor oder den Winkeln eines Koordinatensystems: den Leser nennen, wenn es Unsicherheiten sind, oder die Spalten angeben: %1</translation>
    </message>
    <message>
        <source>read as %1 (%2)</source>
        <translation>gelesen als %1 (%2)</translation>
    </message>
    <message>
        <source>%1: the file states no unit, %2 is taken</source>
        <translation>%1: die Datei nennt keine Einheit, %2 wird angenommen</translation>
    </message>
    <message>
        <source>Analysis &quot;%1&quot; (%2)</source>
        <translation>Analyse &quot;%1&quot; (%2)</translation>
    </message>
    <message>
        <source>not taken over</source>
        <translation>nicht übernommen</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>and %1 more rows</source>
        <translation>und %1 weitere Zeilen</translation>
    </message>
    <message>
        <source>no reader recognises the file; name the one to read it with</source>
        <translation>kein Leser erkennt die Datei; den angeben, mit dem sie gelesen werden soll</translation>
    </message>
    <message>
        <source>several readers recognise the file: %1; name one of them</source>
        <translation>mehrere Leser erkennen die Datei: %1; einen davon angeben</translation>
    </message>
    <message>
        <source>a column cannot be %1; there are %2</source>
        <translation>eine Spalte kann nicht %1 sein; es gibt %2</translation>
    </message>
    <message>
        <source>the columns %1 and %2 mean the same; state the columns</source>
        <translation>die Spalten %1 und %2 bedeuten dasselbe; die Spalten angeben</translation>
    </message>
    <message>
        <source>a budget needs columns for the quantity or its name, for an uncertainty (u, U or limits) and one more; state the columns</source>
        <translation>ein Budget braucht Spalten für die Größe oder ihren Namen, für eine Unsicherheit (u, U oder Grenzen) und eine weitere; die Spalten angeben</translation>
    </message>
    <message>
        <source>the distribution %1 is not known; there are normal, rectangular, triangular, U-shaped</source>
        <translation>die Verteilung %1 ist nicht bekannt; es gibt normal, rectangular, triangular, U-shaped</translation>
    </message>
    <message>
        <source>the divisor must be greater than 0</source>
        <translation>der Divisor muss größer als 0 sein</translation>
    </message>
    <message>
        <source>an uncertainty must not be negative</source>
        <translation>eine Unsicherheit darf nicht negativ sein</translation>
    </message>
    <message>
        <source>no uncertainty is stated</source>
        <translation>keine Unsicherheit ist angegeben</translation>
    </message>
    <message>
        <source>neither divisor, k nor distribution says what the uncertainty %1 is</source>
        <translation>weder Divisor, k noch Verteilung sagt, was die Unsicherheit %1 ist</translation>
    </message>
    <message>
        <source>a normal distribution needs a divisor or k for the uncertainty %1</source>
        <translation>eine Normalverteilung braucht einen Divisor oder k für die Unsicherheit %1</translation>
    </message>
    <message>
        <source>no row has a number in the stated columns</source>
        <translation>keine Zeile hat eine Zahl in den angegebenen Spalten</translation>
    </message>
    <message>
        <source>there is no sheet %1 with cells; there are %2</source>
        <translation>es gibt kein Blatt %1 mit Zellen; vorhanden sind %2</translation>
    </message>
    <message>
        <source>the workbook has several sheets, %1: name the sheet whose columns are stated</source>
        <translation>die Arbeitsmappe hat mehrere Blätter, %1: das Blatt nennen, dessen Spalten angegeben sind</translation>
    </message>
    <message>
        <source>no row of headers of a budget was found; state the columns (quantity, value, unit, U, divisor ...)</source>
        <translation>keine Kopfzeile eines Budgets gefunden; die Spalten angeben (Größe, Wert, Einheit, U, Teiler ...)</translation>
    </message>
    <message>
        <source>several sheets have a budget: %1; name one of them</source>
        <translation>mehrere Blätter haben ein Budget: %1; eines davon nennen</translation>
    </message>
    <message>
        <source>a file that it includes: %1</source>
        <translation>eine Datei, die sie einbindet: %1</translation>
    </message>
    <message>
        <source>the code of a point is expected, a digit</source>
        <translation>der Code eines Punktes wird erwartet, eine Ziffer</translation>
    </message>
    <message>
        <source>a point that is not to be used: %1</source>
        <translation>ein Punkt, der nicht zu verwenden ist: %1</translation>
    </message>
    <message>
        <source>code, name, x, y, z, three standard deviations and two deflections of the vertical are expected, there are %1 columns</source>
        <translation>Code, Name, x, y, z, drei Standardabweichungen und zwei Lotabweichungen werden erwartet, es sind %1 Spalten</translation>
    </message>
    <message>
        <source>none of their coordinates</source>
        <translation>keine ihrer Koordinaten</translation>
    </message>
    <message>
        <source>%1 only</source>
        <translation>nur %1</translation>
    </message>
    <message>
        <source>standard deviations of %1 points of code %2: it constrains %3</source>
        <translation>Standardabweichungen von %1 Punkten mit Code %2: er legt %3 fest</translation>
    </message>
    <message>
        <source>deflections of the vertical of %1 points</source>
        <translation>Lotabweichungen von %1 Punkten</translation>
    </message>
    <message>
        <source>%1 points are not constrained: their coordinates are approximate ones for the adjustment</source>
        <translation>%1 Punkte sind nicht festgelegt: ihre Koordinaten sind Näherungswerte für die Ausgleichung</translation>
    </message>
    <message>
        <source>%1 comments</source>
        <translation>%1 Kommentare</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 ist keine Zahl</translation>
    </message>
    <message>
        <source>%1: the constraint of %2, which is switched off</source>
        <translation>%1: die Bedingung von %2, die abgeschaltet ist</translation>
    </message>
    <message>
        <source>coordinates in metres</source>
        <translation>Koordinaten in Metern</translation>
    </message>
    <message>
        <source>the stated unit of lengths: coordinates of Comp3D are in metres</source>
        <translation>die angegebene Längeneinheit: Koordinaten von Comp3D sind in Metern</translation>
    </message>
    <message>
        <source>the code of an observation is expected, a whole number</source>
        <translation>der Code einer Beobachtung wird erwartet, eine ganze Zahl</translation>
    </message>
    <message>
        <source>an observation of code %1</source>
        <translation>eine Beobachtung mit Code %1</translation>
    </message>
    <message>
        <source>code, two points, value, one or two standard deviations and two heights are expected, there are %1 columns</source>
        <translation>Code, zwei Punkte, Wert, eine oder zwei Standardabweichungen und zwei Höhen werden erwartet, es sind %1 Spalten</translation>
    </message>
    <message>
        <source>%1 %2: it is switched off</source>
        <translation>%1 %2: abgeschaltet</translation>
    </message>
    <message>
        <source>the file has no observation that is taken</source>
        <translation>die Datei hat keine Beobachtung, die übernommen wird</translation>
    </message>
    <message>
        <source>%1 observations, lengths in metres; each is its own result: write the equations of what you measure with them</source>
        <translation>%1 Beobachtungen, Längen in Metern; jede ist ihr eigenes Ergebnis: die Gleichungen für das damit Gemessene schreiben</translation>
    </message>
    <message>
        <source>the unit of angles must be one of an angle: gon, deg, rad</source>
        <translation>die Winkeleinheit muss die eines Winkels sein: gon, deg, rad</translation>
    </message>
    <message>
        <source>%1 %2: the part of its standard deviation that depends on the distance</source>
        <translation>%1 %2: der Anteil der Standardabweichung, der vom Abstand abhängt</translation>
    </message>
    <message>
        <source>%1: it is switched off</source>
        <translation>%1: abgeschaltet</translation>
    </message>
    <message>
        <source>a variance of its covariance matrix is negative</source>
        <translation>eine Varianz der Kovarianzmatrix ist negativ</translation>
    </message>
    <message>
        <source>its covariance matrix is not symmetric</source>
        <translation>die Kovarianzmatrix ist nicht symmetrisch</translation>
    </message>
    <message>
        <source>its matrix is no covariance matrix: a variance of some combination is negative</source>
        <translation>die Matrix ist keine Kovarianzmatrix: eine Varianz einer Kombination ist negativ</translation>
    </message>
    <message>
        <source>no Digital Calibration Certificate: its root is &lt;%1&gt;</source>
        <translation>kein Digitaler Kalibrierschein: das Wurzelelement ist &lt;%1&gt;</translation>
    </message>
    <message>
        <source>the certificate has no results with numbers</source>
        <translation>der Kalibrierschein hat keine Ergebnisse mit Zahlen</translation>
    </message>
    <message>
        <source>schema version %1</source>
        <translation>Schemaversion %1</translation>
    </message>
    <message>
        <source>what this version of the schema has beyond version 3</source>
        <translation>was diese Version des Schemas über Version 3 hinaus hat</translation>
    </message>
    <message>
        <source>the stated unit of lengths: a certificate states its units</source>
        <translation>die angegebene Längeneinheit: ein Kalibrierschein nennt seine Einheiten</translation>
    </message>
    <message>
        <source>%1: &lt;measurementMetaData&gt;</source>
        <translation>%1: &lt;measurementMetaData&gt;</translation>
    </message>
    <message>
        <source>a quantity: more than %1 values</source>
        <translation>eine Größe: mehr als %1 Werte</translation>
    </message>
    <message>
        <source>%1 as a length standard: more than %2</source>
        <translation>%1 als Längennormal: mehr als %2</translation>
    </message>
    <message>
        <source>the signature: it is not verified</source>
        <translation>die Signatur: sie wird nicht geprüft</translation>
    </message>
    <message>
        <source>%1 values, %2 of them with an uncertainty</source>
        <translation>%1 Werte, %2 davon mit einer Unsicherheit</translation>
    </message>
    <message>
        <source>%1 values, %2 of them with an uncertainty, with covariances</source>
        <translation>%1 Werte, %2 davon mit einer Unsicherheit, mit Kovarianzen</translation>
    </message>
    <message>
        <source>length standard %1: delete it where the length is no standard</source>
        <translation>Längennormal %1: löschen, wo die Länge kein Normal ist</translation>
    </message>
    <message>
        <source>a value as &lt;%1&gt;</source>
        <translation>ein Wert als &lt;%1&gt;</translation>
    </message>
    <message>
        <source>its relative uncertainty</source>
        <translation>die relative Unsicherheit dazu</translation>
    </message>
    <message>
        <source>the same in other units (%1 is taken)</source>
        <translation>dasselbe in anderen Einheiten (%1 wird übernommen)</translation>
    </message>
    <message>
        <source>its lists have different lengths than the %1 values</source>
        <translation>die Listen haben andere Längen als die %1 Werte</translation>
    </message>
    <message>
        <source>its covariance matrix: %1</source>
        <translation>die Kovarianzmatrix: %1</translation>
    </message>
    <message>
        <source>its covariance matrix has not %1 x %2 elements</source>
        <translation>die Kovarianzmatrix hat nicht %1 x %2 Elemente</translation>
    </message>
    <message>
        <source>p must be between 0 and 1</source>
        <translation>p muss zwischen 0 und 1 liegen</translation>
    </message>
    <message>
        <source>k must be greater than 0</source>
        <translation>k muss größer als 0 sein</translation>
    </message>
    <message>
        <source>its uncertainty is negative</source>
        <translation>die Unsicherheit ist negativ</translation>
    </message>
    <message>
        <source>it does not begin with \</source>
        <translation>beginnt nicht mit \</translation>
    </message>
    <message>
        <source>a brace is not closed</source>
        <translation>eine geschweifte Klammer ist nicht geschlossen</translation>
    </message>
    <message>
        <source>its power &apos;%1&apos; is no small integer</source>
        <translation>die Potenz &apos;%1&apos; ist keine kleine ganze Zahl</translation>
    </message>
    <message>
        <source>&apos;\%1&apos; is not known</source>
        <translation>&apos;\%1&apos; ist nicht bekannt</translation>
    </message>
    <message>
        <source>it ends too early</source>
        <translation>endet zu früh</translation>
    </message>
    <message>
        <source>the unit %1: %2</source>
        <translation>die Einheit %1: %2</translation>
    </message>
    <message>
        <source>sheet %1, columns: %2</source>
        <translation>Blatt %1, Spalten: %2</translation>
    </message>
    <message>
        <source>%1 is no number</source>
        <translation>%1 ist keine Zahl</translation>
    </message>
    <message>
        <source>its unit differs from that of the other uncertainty of the row</source>
        <translation>die Einheit weicht von der der anderen Unsicherheit der Zeile ab</translation>
    </message>
    <message>
        <source>%1 is no divisor</source>
        <translation>%1 ist kein Teiler</translation>
    </message>
    <message>
        <source>degrees of freedom must be greater than 0</source>
        <translation>Freiheitsgrade müssen größer als 0 sein</translation>
    </message>
    <message>
        <source>row %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>the contribution %1: c and u give %2</source>
        <translation>der Beitrag %1: c und u ergeben %2</translation>
    </message>
    <message>
        <source>the contribution does not follow from c and u in any unit; state the unit behind the coefficient (&apos;-575 nm/K&apos;)</source>
        <translation>der Beitrag folgt in keiner Einheit aus c und u; die Einheit hinter dem Koeffizienten angeben (&apos;-575 nm/K&apos;)</translation>
    </message>
    <message>
        <source>its unit makes no coefficient of the result</source>
        <translation>die Einheit ergibt keinen Koeffizienten des Ergebnisses</translation>
    </message>
    <message>
        <source>its unit may be %1 or %2: state it behind the coefficient</source>
        <translation>die Einheit kann %1 oder %2 sein: hinter dem Koeffizienten angeben</translation>
    </message>
    <message>
        <source>what stands below the budget, to row %1</source>
        <translation>was unter dem Budget steht, bis Zeile %1</translation>
    </message>
    <message>
        <source>there is no quantity with an uncertainty below</source>
        <translation>darunter steht keine Größe mit einer Unsicherheit</translation>
    </message>
    <message>
        <source>row without a quantity</source>
        <translation>Zeile ohne Größe</translation>
    </message>
    <message>
        <source>row %1 without figures</source>
        <translation>Zeile %1 ohne Zahlen</translation>
    </message>
    <message>
        <source>the quantity has no name</source>
        <translation>die Größe hat keinen Namen</translation>
    </message>
    <message>
        <source>row %1: computed anew</source>
        <translation>Zeile %1: neu berechnet</translation>
    </message>
    <message>
        <source>the unit of the result is not stated: give the result a row of its own, put the unit behind the head of the contributions, or state it as that of &apos;result&apos;</source>
        <translation>die Einheit des Ergebnisses ist nicht angegeben: dem Ergebnis eine eigene Zeile geben, die Einheit hinter die Überschrift der Beiträge setzen oder sie als die von &apos;result&apos; angeben</translation>
    </message>
    <message>
        <source>model: %1; the sheet has sensitivity coefficients only, write your equation instead where you have it</source>
        <translation>Modell: %1; das Blatt hat nur Sensitivitätskoeffizienten, stattdessen die eigene Gleichung schreiben, wo vorhanden</translation>
    </message>
    <message>
        <source>%1 quantities</source>
        <translation>%1 Größen</translation>
    </message>
    <message>
        <source>sheet %1</source>
        <translation>Blatt %1</translation>
    </message>
    <message>
        <source>no input quantity has an uncertainty, so that U is 0 everywhere: state the uncertainties of what the analysis uses</source>
        <translation>keine Eingangsgröße hat eine Unsicherheit, sodass U überall 0 ist: die Unsicherheiten dessen angeben, was die Analyse verwendet</translation>
    </message>
    <message>
        <source>%1; the run is to end at %2 trials and will not be stable then. Choose a larger tolerance or fewer digits</source>
        <translation>%1; der Lauf soll bei %2 Versuchen enden und wird dann nicht stabil sein. Größere Toleranz oder weniger Stellen wählen</translation>
    </message>
    <message>
        <source>it cannot be read</source>
        <translation>es kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>%1 has no analysis &quot;%2&quot;</source>
        <translation>%1 hat keine Analyse &quot;%2&quot;</translation>
    </message>
    <message>
        <source>%1 refers to other assets of the project and cannot be kept alone</source>
        <translation>%1 verweist auf andere Betriebsmittel des Projekts und kann nicht allein aufbewahrt werden</translation>
    </message>
    <message>
        <source>%1 has errors; open it and repair it before adding to it</source>
        <translation>%1 hat Fehler; vor dem Hinzufügen öffnen und beheben</translation>
    </message>
    <message>
        <source>asset %1: %2</source>
        <translation>Betriebsmittel %1: %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; refers to the analysis &apos;%2&apos;</source>
        <translation>&apos;%1&apos; verweist auf die Analyse &apos;%2&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; refers to the asset &apos;%2&apos;</source>
        <translation>&apos;%1&apos; verweist auf das Betriebsmittel &apos;%2&apos;</translation>
    </message>
    <message>
        <source>%1, which does not offer %2</source>
        <translation>%1, die %2 nicht bietet</translation>
    </message>
    <message>
        <source>it cannot be made</source>
        <translation>es kann nicht erstellt werden</translation>
    </message>
    <message>
        <source>the analysis &apos;%1&apos; has errors of its own: %2</source>
        <translation>die Analyse &apos;%1&apos; hat eigene Fehler: %2</translation>
    </message>
    <message>
        <source>%1, which has errors of its own</source>
        <translation>%1, das eigene Fehler hat</translation>
    </message>
    <message>
        <source>%1, which is of the kind &apos;%2&apos; and does not offer %3</source>
        <translation>%1, das von der Art &apos;%2&apos; ist und %3 nicht bietet</translation>
    </message>
    <message>
        <source>%1, which refers back to this one: %2%3</source>
        <translation>%1, und von dort führt ein Verweis hierher zurück: %2%3</translation>
    </message>
    <message>
        <source>%1: only analyses take something from analyses</source>
        <translation>%1: nur Analysen übernehmen etwas aus Analysen</translation>
    </message>
    <message>
        <source>%1, which does not exist%2</source>
        <translation>%1, was es nicht gibt%2</translation>
    </message>
    <message>
        <source>the values given lead to a %1</source>
        <translation>die angegebenen Werte führen zu: %1</translation>
    </message>
    <message>
        <source>the memory of this machine does not suffice</source>
        <translation>der Speicher dieses Rechners reicht nicht aus</translation>
    </message>
    <message>
        <source>a defect of the program was met (%1): please report it with the project</source>
        <translation>ein Fehler des Programms ist aufgetreten (%1): mit dem Projekt melden</translation>
    </message>
    <message>
        <source>%1: the part is damaged or no part at all: delete it and make it anew</source>
        <translation>%1: der Teil ist beschädigt oder gar kein Teil: löschen und neu rechnen</translation>
    </message>
    <message>
        <source>%1: the part was made %2 %3, this is %4: the bits of its results would not be those of one run</source>
        <translation>%1: der Teil entstand mit %2 %3, dies ist %4: die Bits der Ergebnisse wären nicht die eines einzigen Laufs</translation>
    </message>
    <message>
        <source>%1: the part would have %2 MB, more than %3: divide the run into more parts</source>
        <translation>%1: der Teil hätte %2 MB, mehr als %3: den Lauf in mehr Teile teilen</translation>
    </message>
    <message>
        <source>%1: the part is of &quot;%2&quot;, which is not evaluated here: it is of another project</source>
        <translation>%1: der Teil ist von &quot;%2&quot;, das hier nicht ausgewertet wird: er gehört zu einem anderen Projekt</translation>
    </message>
    <message>
        <source>%1: the part is of &quot;%2&quot; in another project or another state of it (fingerprint %3, here %4): make it anew</source>
        <translation>%1: der Teil ist von &quot;%2&quot; in einem anderen Projekt oder einem anderen Stand davon (Fingerabdruck %3, hier %4): neu rechnen</translation>
    </message>
    <message>
        <source>the model cannot be made</source>
        <translation>das Modell kann nicht gebildet werden</translation>
    </message>
    <message>
        <source>there is no component &apos;%1&apos; here</source>
        <translation>hier gibt es keine Komponente &apos;%1&apos;</translation>
    </message>
    <message>
        <source>there is no input quantity &apos;%1&apos; here</source>
        <translation>hier gibt es keine Eingangsgröße &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the analysis has no study &apos;%1&apos;</source>
        <translation>die Analyse hat keine Studie &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the study was stopped</source>
        <translation>die Studie wurde abgebrochen</translation>
    </message>
    <message>
        <source>the analysis does not use the asset &apos;%1&apos;: varying it changes nothing</source>
        <translation>die Analyse verwendet das Betriebsmittel &apos;%1&apos; nicht: es zu variieren ändert nichts</translation>
    </message>
    <message>
        <source>the model shows no instruments: a least distance and boxes to keep out of mean nothing to it</source>
        <translation>das Modell zeigt keine Messgeräte: ein kleinster Abstand und freizuhaltende Kästen sagen ihm nichts</translation>
    </message>
    <message>
        <source>the model shows no lines of sight, so that no box can hide them</source>
        <translation>das Modell zeigt keine Ziellinien, so dass kein Kasten sie verdecken kann</translation>
    </message>
    <message>
        <source>the analysis has no design &apos;%1&apos;</source>
        <translation>die Analyse hat keinen Entwurf &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the variances are not a sum over what is reduced: some of it is correlated, or changes more than a component of uncertainty</source>
        <translation>die Varianzen sind keine Summe über das, was verringert wird: etwas davon ist korreliert oder ändert mehr als eine Unsicherheitskomponente</translation>
    </message>
    <message>
        <source>the analysis has no measurand that a design could look at</source>
        <translation>die Analyse hat keine Messgröße, die ein Entwurf betrachten könnte</translation>
    </message>
    <message>
        <source>without target uncertainties U is looked at relative to that of the present design, which has no result (%1): state requirements</source>
        <translation>ohne Zielunsicherheiten wird U gegenüber dem des vorliegenden Entwurfs betrachtet, der kein Ergebnis hat (%1): Anforderungen angeben</translation>
    </message>
    <message>
        <source>U of &apos;%1&apos; is zero now: choose the outputs to look at</source>
        <translation>U von &apos;%1&apos; ist jetzt null: die zu betrachtenden Ausgangsgrößen wählen</translation>
    </message>
    <message>
        <source>the cheapest reductions need target uncertainties: state requirements</source>
        <translation>die billigsten Verringerungen brauchen Zielunsicherheiten: Anforderungen angeben</translation>
    </message>
    <message>
        <source>the cheapest rows need target uncertainties: state requirements</source>
        <translation>die billigsten Zeilen brauchen Zielunsicherheiten: Anforderungen angeben</translation>
    </message>
    <message>
        <source>the design was stopped</source>
        <translation>der Entwurf wurde abgebrochen</translation>
    </message>
    <message>
        <source>the set-up</source>
        <translation>der Aufbau</translation>
    </message>
    <message>
        <source>the component &apos;%1&apos; is not of one input quantity alone: change it where it comes from (%2)</source>
        <translation>die Komponente &apos;%1&apos; gehört nicht zu einer Eingangsgröße allein: dort ändern, wo sie herkommt (%2)</translation>
    </message>
    <message>
        <source>Distribution of %1.</source>
        <translation>Verteilung von %1.</translation>
    </message>
    <message>
        <source>Quantiles of %1, the least normal, against those of a normal distribution.</source>
        <translation>Quantile von %1, der am wenigsten normalen, gegen die einer Normalverteilung.</translation>
    </message>
    <message>
        <source>Standard uncertainty of %1 against the number of trials.</source>
        <translation>Standardunsicherheit von %1 gegen die Anzahl der Versuche.</translation>
    </message>
    <message>
        <source>%1: uncertainty ellipsoids at a coverage probability of %2, magnified as the picture states.</source>
        <translation>%1: Unsicherheitsellipsoide mit einer Überdeckungswahrscheinlichkeit von %2, vergrößert wie im Bild angegeben.</translation>
    </message>
    <message>
        <source>Correlation coefficients of components</source>
        <translation>Korrelationskoeffizienten der Komponenten</translation>
    </message>
    <message>
        <source>Component</source>
        <translation>Komponente</translation>
    </message>
    <message>
        <source>Notes on input quantities</source>
        <translation>Anmerkungen zu Eingangsgrößen</translation>
    </message>
    <message>
        <source>Input quantities and the origin of their uncertainties</source>
        <translation>Eingangsgrößen und die Herkunft ihrer Unsicherheiten</translation>
    </message>
    <message>
        <source>%1 input quantities; many with equal components share a row. The CSV table of inputs lists every one with its estimate.</source>
        <translation>%1 Eingangsgrößen; viele mit gleichen Komponenten teilen sich eine Zeile. Die CSV-Tabelle der Eingangsgrößen enthält jede mit ihrem Schätzwert.</translation>
    </message>
    <message>
        <source>These input quantities are results of other analyses. All are evaluated together as one model, in every trial, so that the budget goes down to the components of the analyses that they come from; a component that reaches the result on several ways is one component.</source>
        <translation>Diese Eingangsgrößen sind Ergebnisse anderer Analysen. Alle werden in jedem Versuch zusammen als ein Modell ausgewertet, so dass das Budget bis zu den Komponenten der Analysen reicht, aus denen sie kommen; eine Komponente, die das Ergebnis auf mehreren Wegen erreicht, ist eine Komponente.</translation>
    </message>
    <message>
        <source>Linearised: the analysis that the value comes from is replaced by its law of propagation about its estimates. That is exact to first order; its non-linearity is left out of Monte Carlo.</source>
        <translation>Linearisiert: die Analyse, aus der der Wert kommt, ist durch ihr Fortpflanzungsgesetz um ihre Schätzwerte ersetzt. Das ist in erster Ordnung exakt; ihre Nichtlinearität fehlt in Monte Carlo.</translation>
    </message>
    <message>
        <source>Where the inputs come from</source>
        <translation>Woher die Eingangsgrößen kommen</translation>
    </message>
    <message>
        <source>Input quantities taken from other analyses</source>
        <translation>Eingangsgrößen aus anderen Analysen</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>Analyse</translation>
    </message>
    <message>
        <source>Its result</source>
        <translation>Ihr Ergebnis</translation>
    </message>
    <message>
        <source>%1, linearised</source>
        <translation>%1, linearisiert</translation>
    </message>
    <message>
        <source>The trials are Sobol points with a random digital shift in each batch; standard errors are from the scatter of the batches.</source>
        <translation>Die Versuche sind Sobol-Punkte mit einer zufälligen digitalen Verschiebung in jedem Block; Standardfehler folgen aus der Streuung der Blöcke.</translation>
    </message>
    <message>
        <source>Mean, standard uncertainty, symmetric interval and covariance were found with the linear part of each output as control variate: its distribution is known exactly, and the trials tell how the output differs from it. Shortest intervals, histograms and probabilities of conformance are those of the trials.</source>
        <translation>Mittelwert, Standardunsicherheit, symmetrisches Intervall und Kovarianz wurden mit dem linearen Teil jeder Ausgangsgröße als Kontrollvariable gefunden: seine Verteilung ist genau bekannt, und die Versuche sagen, wie die Ausgangsgröße davon abweicht. Kürzeste Intervalle, Histogramme und Konformitätswahrscheinlichkeiten sind die der Versuche.</translation>
    </message>
    <message>
        <source>At the interval ends each trial is worth %1 plain ones or more.</source>
        <translation>An den Enden des Intervalls ist jeder Versuch %1 einfache Versuche oder mehr wert.</translation>
    </message>
    <message>
        <source>The adaptive procedure reached its largest number of trials: the results have not stabilised to the numerical tolerance.</source>
        <translation>Das adaptive Verfahren hat die größte Anzahl von Versuchen erreicht: die Ergebnisse haben sich nicht innerhalb der numerischen Toleranz stabilisiert.</translation>
    </message>
    <message>
        <source>Coverage intervals were read from finely divided cells, not from ordered trials: there were more trials than memory allows to order.</source>
        <translation>Überdeckungsintervalle wurden aus fein geteilten Zellen abgelesen, nicht aus geordneten Versuchen: es waren mehr Versuche, als der Speicher zu ordnen erlaubt.</translation>
    </message>
    <message>
        <source>law of propagation</source>
        <translation>Fortpflanzungsgesetz</translation>
    </message>
    <message>
        <source>adaptive</source>
        <translation>adaptiv</translation>
    </message>
    <message>
        <source>%1, Sobol points</source>
        <translation>%1, Sobol-Punkte</translation>
    </message>
    <message>
        <source>%1, control variate</source>
        <translation>%1, Kontrollvariable</translation>
    </message>
    <message>
        <source>Runs that gave these results</source>
        <translation>Läufe, die diese Ergebnisse ergaben</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Gescheitert</translation>
    </message>
    <message>
        <source>Fingerprint</source>
        <translation>Fingerabdruck</translation>
    </message>
    <message>
        <source>The same project, seed and version give the same numbers on any number of threads. The fingerprint covers everything that influences the numbers of an analysis.</source>
        <translation>Dasselbe Projekt, dieselbe Startzahl und dieselbe Version geben dieselben Zahlen mit jeder Anzahl von Threads. Der Fingerabdruck umfasst alles, was die Zahlen einer Analyse beeinflusst.</translation>
    </message>
    <message>
        <source>Factors by which the standard uncertainties are to be multiplied so that all measurands of a group lie in the region together with a probability of %1 (JCGM 102 6.5 and 7.7).</source>
        <translation>Faktoren, mit denen die Standardunsicherheiten zu multiplizieren sind, damit alle Messgrößen einer Gruppe zusammen mit der Wahrscheinlichkeit %1 im Bereich liegen (JCGM 102 6.5 und 7.7).</translation>
    </message>
    <message>
        <source>Factors of the coverage regions</source>
        <translation>Faktoren der Überdeckungsbereiche</translation>
    </message>
    <message>
        <source>No ellipsoid is given where the covariance matrix of the group is singular.</source>
        <translation>Wo die Kovarianzmatrix der Gruppe singulär ist, wird kein Ellipsoid angegeben.</translation>
    </message>
    <message>
        <source>Target uncertainties</source>
        <translation>Zielunsicherheiten</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>With the figure put in, U by the law of propagation is the target; k follows the effective degrees of freedom.</source>
        <translation>Mit der eingesetzten Zahl ist U nach dem Fortpflanzungsgesetz das Ziel; k folgt den effektiven Freiheitsgraden.</translation>
    </message>
    <message>
        <source>With the figure put in, U by Monte Carlo is the target; found with %1 trials of the same draws.</source>
        <translation>Mit der eingesetzten Zahl ist U nach Monte Carlo das Ziel; gefunden mit %1 Versuchen derselben Ziehungen.</translation>
    </message>
    <message>
        <source>No component suffices alone: all standard uncertainties multiplied by %1 do.</source>
        <translation>Keine Komponente genügt allein: alle Standardunsicherheiten mal %1 tun es.</translation>
    </message>
    <message>
        <source>What one component alone must be reduced to for U(%1) to meet its target</source>
        <translation>Worauf eine Komponente allein zu verringern ist, damit U(%1) das Ziel einhält</translation>
    </message>
    <message>
        <source>needed</source>
        <translation>nötig</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>not enough by itself, even if it vanished</source>
        <translation>für sich nicht genug, selbst wenn sie verschwände</translation>
    </message>
    <message>
        <source>%1: specific consumer&apos;s risk %2 of this decision.</source>
        <translation>%1: spezifisches Konsumentenrisiko %2 dieser Entscheidung.</translation>
    </message>
    <message>
        <source>%1: specific producer&apos;s risk %2 of this decision.</source>
        <translation>%1: spezifisches Produzentenrisiko %2 dieser Entscheidung.</translation>
    </message>
    <message>
        <source>%1: specific consumer&apos;s risk %2 of this decision; global risks of the rule for its prior: consumer&apos;s %3, producer&apos;s %4.</source>
        <translation>%1: spezifisches Konsumentenrisiko %2 dieser Entscheidung; globale Risiken der Regel für ihre A-priori-Verteilung: Konsument %3, Produzent %4.</translation>
    </message>
    <message>
        <source>%1: specific producer&apos;s risk %2 of this decision; global risks of the rule for its prior: consumer&apos;s %3, producer&apos;s %4.</source>
        <translation>%1: spezifisches Produzentenrisiko %2 dieser Entscheidung; globale Risiken der Regel für ihre A-priori-Verteilung: Konsument %3, Produzent %4.</translation>
    </message>
    <message>
        <source>Conformity with tolerances</source>
        <translation>Konformität mit Toleranzen</translation>
    </message>
    <message>
        <source>The requirements are not judged: %1.</source>
        <translation>Die Anforderungen werden nicht beurteilt: %1.</translation>
    </message>
    <message>
        <source>U of</source>
        <translation>U von</translation>
    </message>
    <message>
        <source>Coverage probability %1.</source>
        <translation>Überdeckungswahrscheinlichkeit %1.</translation>
    </message>
    <message>
        <source>Values from the law of propagation of uncertainty (JCGM 100).</source>
        <translation>Werte nach dem Fortpflanzungsgesetz (JCGM 100).</translation>
    </message>
    <message>
        <source>Values from the propagation of distributions (JCGM 101) with %1 trials; the interval is probabilistically symmetric, the shortest one beside it. The effective degrees of freedom are those of the law of propagation.</source>
        <translation>Werte aus der Fortpflanzung von Verteilungen (JCGM 101) mit %1 Versuchen; das Intervall ist wahrscheinlichkeitssymmetrisch, das kürzeste steht daneben. Die effektiven Freiheitsgrade sind die des Fortpflanzungsgesetzes.</translation>
    </message>
    <message>
        <source>Components with finite degrees of freedom are drawn from normal distributions, as was chosen: U and k leave these degrees of freedom out, unlike k of the law of propagation (JCGM 100 G.6.4).</source>
        <translation>Komponenten mit endlichen Freiheitsgraden werden wie gewählt aus Normalverteilungen gezogen: U und k berücksichtigen diese Freiheitsgrade nicht, anders als k nach dem Fortpflanzungsgesetz (JCGM 100 G.6.4).</translation>
    </message>
    <message>
        <source>This result does not represent the measurand: %1 trials, more than 1 %, have no value.</source>
        <translation>Dieses Ergebnis stellt die Messgröße nicht dar: %1 Versuche, mehr als 1 %, haben keinen Wert.</translation>
    </message>
    <message>
        <source>Law of propagation with second-order terms</source>
        <translation>Fortpflanzungsgesetz mit Gliedern zweiter Ordnung</translation>
    </message>
    <message>
        <source>JCGM 100 5.1.2, NOTE, for independent components with symmetric distributions. The shift, half the sum of the second derivatives times the variances, is what the mean of the measurand differs by from the value at the estimates; neither is part of the results above.</source>
        <translation>JCGM 100 5.1.2, ANMERKUNG, für unabhängige Komponenten mit symmetrischen Verteilungen. Die Verschiebung, die halbe Summe der zweiten Ableitungen mal den Varianzen, ist das, worin sich der Mittelwert der Messgröße vom Wert bei den Schätzwerten unterscheidet; beides gehört nicht zu den Ergebnissen oben.</translation>
    </message>
    <message>
        <source>Measurands</source>
        <translation>Messgrößen</translation>
    </message>
    <message>
        <source>Intermediate quantities</source>
        <translation>Zwischengrößen</translation>
    </message>
    <message>
        <source>Read from %1.</source>
        <translation>Gelesen aus %1.</translation>
    </message>
    <message>
        <source>The first %1 of %2 rows; the project file has them all.</source>
        <translation>Die ersten %1 von %2 Zeilen; die Projektdatei enthält alle.</translation>
    </message>
    <message>
        <source>Sobol indices of %1 in %</source>
        <translation>Sobol-Indizes von %1 in %</translation>
    </message>
    <message>
        <source>first order of the law of propagation</source>
        <translation>erste Ordnung des Fortpflanzungsgesetzes</translation>
    </message>
    <message>
        <source>standard error of S</source>
        <translation>Standardfehler von S</translation>
    </message>
    <message>
        <source>S total</source>
        <translation>S total</translation>
    </message>
    <message>
        <source>standard error of S total</source>
        <translation>Standardfehler von S total</translation>
    </message>
    <message>
        <source>%1 components with smaller indices are left out.</source>
        <translation>%1 Komponenten mit kleineren Indizes sind weggelassen.</translation>
    </message>
    <message>
        <source>Sobol indices</source>
        <translation>Sobol-Indizes</translation>
    </message>
    <message>
        <source>S is the share of the variance that a component causes by itself, S total the share with all its interactions with others: where both agree and the shares sum to 100 %, the measurement model is additive. Components that are correlated have indices together. By Monte Carlo with %1 pairs of trials.</source>
        <translation>S ist der Anteil der Varianz, den eine Komponente für sich verursacht, S total der Anteil mit allen ihren Wechselwirkungen mit anderen: wo beide übereinstimmen und die Anteile sich zu 100 % summieren, ist das Messmodell additiv. Korrelierte Komponenten haben gemeinsame Indizes. Mit Monte Carlo, %1 Paare von Versuchen.</translation>
    </message>
    <message>
        <source>%1 from %2 to %3 (%4 values, logarithmic)</source>
        <translation>%1 von %2 bis %3 (%4 Werte, logarithmisch)</translation>
    </message>
    <message>
        <source>%1 from %2 to %3 (%4 values)</source>
        <translation>%1 von %2 bis %3 (%4 Werte)</translation>
    </message>
    <message>
        <source>Evaluated at %1 grid points, with %2 trials at each.</source>
        <translation>Ausgewertet an %1 Gitterpunkten mit je %2 Versuchen.</translation>
    </message>
    <message>
        <source>Evaluated at %1 grid points, by the law of propagation of uncertainty.</source>
        <translation>Ausgewertet an %1 Gitterpunkten nach dem Fortpflanzungsgesetz.</translation>
    </message>
    <message>
        <source>Varied: %1.</source>
        <translation>Variiert: %1.</translation>
    </message>
    <message>
        <source>The CSV table of the study has all output quantities.</source>
        <translation>Die CSV-Tabelle der Studie enthält alle Ausgangsgrößen.</translation>
    </message>
    <message>
        <source>%1: best and worst grid points</source>
        <translation>%1: bester und schlechtester Gitterpunkt</translation>
    </message>
    <message>
        <source>least</source>
        <translation>kleinster</translation>
    </message>
    <message>
        <source>greatest</source>
        <translation>größter</translation>
    </message>
    <message>
        <source>What is given for %1 of the grid points does not represent the measurand: more than 1 % of their trials have no value (see the CSV table).</source>
        <translation>Was für %1 der Gitterpunkte angegeben ist, stellt die Messgröße nicht dar: mehr als 1 % ihrer Versuche haben keinen Wert (siehe die CSV-Tabelle).</translation>
    </message>
    <message>
        <source>%1 grid points have no values:</source>
        <translation>%1 Gitterpunkte haben keine Werte:</translation>
    </message>
    <message>
        <source>others: see the CSV table of the study</source>
        <translation>andere: siehe die CSV-Tabelle der Studie</translation>
    </message>
    <message>
        <source>law of propagation of uncertainty</source>
        <translation>Fortpflanzungsgesetz</translation>
    </message>
    <message>
        <source>adaptive Monte Carlo, %1 trials</source>
        <translation>adaptives Monte Carlo, %1 Versuche</translation>
    </message>
    <message>
        <source>Monte Carlo, %1 trials</source>
        <translation>Monte Carlo, %1 Versuche</translation>
    </message>
    <message>
        <source>%1; %2; coverage probability %3</source>
        <translation>%1; %2; Überdeckungswahrscheinlichkeit %3</translation>
    </message>
    <message>
        <source>k, intervals and the law of propagation are in the results of the analysis.</source>
        <translation>k, Intervalle und das Fortpflanzungsgesetz stehen bei den Ergebnissen der Analyse.</translation>
    </message>
    <message>
        <source>Not evaluated: %1: %2.</source>
        <translation>Nicht ausgewertet: %1: %2.</translation>
    </message>
    <message>
        <source>Study &quot;%1&quot; not evaluated: %2: %3.</source>
        <translation>Studie &quot;%1&quot; nicht ausgewertet: %2: %3.</translation>
    </message>
    <message>
        <source>Expanded uncertainty U: %1</source>
        <translation>Erweiterte Unsicherheit U: %1</translation>
    </message>
    <message>
        <source>Results: %1</source>
        <translation>Ergebnisse: %1</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Bearbeiter</translation>
    </message>
    <message>
        <source>Evaluated with</source>
        <translation>Ausgewertet mit</translation>
    </message>
    <message>
        <source>Not in this report</source>
        <translation>Nicht in diesem Bericht</translation>
    </message>
    <message>
        <source>Project fingerprint</source>
        <translation>Fingerabdruck des Projekts</translation>
    </message>
    <message>
        <source>Evaluated with an earlier analysis: %1.</source>
        <translation>Ausgewertet mit einer früheren Analyse: %1.</translation>
    </message>
    <message>
        <source>Budget of %1, %2</source>
        <translation>Budget von %1, %2</translation>
    </message>
    <message>
        <source>%1 further components</source>
        <translation>%1 weitere Komponenten</translation>
    </message>
    <message>
        <source>combined (law of propagation)</source>
        <translation>kombiniert (Fortpflanzungsgesetz)</translation>
    </message>
    <message>
        <source>%1 = %2, u_c = %3, effective degrees of freedom %4, k = %5, p = %6 (law of propagation).</source>
        <translation>%1 = %2, u_c = %3, effektive Freiheitsgrade %4, k = %5, p = %6 (Fortpflanzungsgesetz).</translation>
    </message>
    <message>
        <source>Shares of the variance in % by %1, %2</source>
        <translation>Anteile an der Varianz in % nach %1, %2</translation>
    </message>
    <message>
        <source>together</source>
        <translation>zusammen</translation>
    </message>
    <message>
        <source>other</source>
        <translation>andere</translation>
    </message>
    <message>
        <source>Components by falling share of the variance; cᵢ in the unit of the measurand per unit of the component.</source>
        <translation>Komponenten nach fallendem Anteil an der Varianz; cᵢ in der Einheit der Messgröße je Einheit der Komponente.</translation>
    </message>
    <message>
        <source>Contributions to the variance of %1.</source>
        <translation>Beiträge zur Varianz von %1.</translation>
    </message>
    <message>
        <source>Estimates and standard uncertainties by both methods</source>
        <translation>Schätzwerte und Standardunsicherheiten nach beiden Verfahren</translation>
    </message>
    <message>
        <source>Where a distribution is too skewed, heavy-tailed or flat for k u, state its coverage interval.</source>
        <translation>Wo eine Verteilung für k u zu schief, zu schwer an den Rändern oder zu flach ist, ihr Überdeckungsintervall angeben.</translation>
    </message>
    <message>
        <source>The expanded uncertainty U beside what remains of it when everything that a contributor brings in is kept at its estimate (an ideal one), and what that contributor gives alone, with the same coverage factor.</source>
        <translation>Die erweiterte Unsicherheit U neben dem, was von ihr bleibt, wenn alles, was ein Beitragender einbringt, bei seinem Schätzwert gehalten wird (ein idealer), und was dieser Beitragende allein ergibt, mit demselben Erweiterungsfaktor.</translation>
    </message>
    <message>
        <source>By Monte Carlo with %1 trials.</source>
        <translation>Mit Monte Carlo, %1 Versuche.</translation>
    </message>
    <message>
        <source>By the law of propagation.</source>
        <translation>Nach dem Fortpflanzungsgesetz.</translation>
    </message>
    <message>
        <source>Without %1, %2 trials had no value.</source>
        <translation>Ohne %1 hatten %2 Versuche keinen Wert.</translation>
    </message>
    <message>
        <source>U without each contributor, and of it alone</source>
        <translation>U ohne jeden Beitragenden, und mit ihm allein</translation>
    </message>
    <message>
        <source>without %1</source>
        <translation>ohne %1</translation>
    </message>
    <message>
        <source>%1 alone</source>
        <translation>%1 allein</translation>
    </message>
    <message>
        <source>Of two contributors, what remains without one is what the other gives alone.</source>
        <translation>Von zwei Beitragenden ist das, was ohne den einen bleibt, das, was der andere allein ergibt.</translation>
    </message>
    <message>
        <source>Results by contributor</source>
        <translation>Ergebnisse nach Beitragenden</translation>
    </message>
    <message>
        <source>Correlation coefficients, %1</source>
        <translation>Korrelationskoeffizienten, %1</translation>
    </message>
    <message>
        <source>Between groups, which share input quantities, the largest coefficient is %1.</source>
        <translation>Zwischen Gruppen, die Eingangsgrößen gemeinsam haben, ist der größte Koeffizient %1.</translation>
    </message>
    <message>
        <source>Between groups, which share input quantities, the largest coefficient is %1, of %2 with %3.</source>
        <translation>Zwischen Gruppen, die Eingangsgrößen gemeinsam haben, ist der größte Koeffizient %1, von %2 mit %3.</translation>
    </message>
    <message>
        <source>The CSV table of correlations has all of them.</source>
        <translation>Die CSV-Tabelle der Korrelationen enthält alle.</translation>
    </message>
    <message>
        <source>Looked for: the smallest %1.</source>
        <translation>Gesucht: kleinstmögliche %1.</translation>
    </message>
    <message>
        <source>Looked for: the cheapest reductions of uncertainty with which all targets are met.</source>
        <translation>Gesucht: die billigsten Verringerungen der Unsicherheit, mit denen alle Zielunsicherheiten eingehalten werden.</translation>
    </message>
    <message>
        <source>Looked for: the cheapest rows with which all targets are met.</source>
        <translation>Gesucht: die billigsten Zeilen, mit denen alle Zielunsicherheiten eingehalten werden.</translation>
    </message>
    <message>
        <source>Cost: %1.</source>
        <translation>Kosten: %1.</translation>
    </message>
    <message>
        <source>Found: %1, before %2.</source>
        <translation>Gefunden: %1, vorher %2.</translation>
    </message>
    <message>
        <source>Found: %1.</source>
        <translation>Gefunden: %1.</translation>
    </message>
    <message>
        <source>Nothing that was tried has a result.</source>
        <translation>Nichts des Versuchten hat ein Ergebnis.</translation>
    </message>
    <message>
        <source>%1 candidates were evaluated by the law of propagation of uncertainty, all that there are.</source>
        <translation>%1 Kandidaten wurden nach dem Fortpflanzungsgesetz ausgewertet, alle, die es gibt.</translation>
    </message>
    <message>
        <source>%1 candidates were evaluated by the law of propagation of uncertainty.</source>
        <translation>%1 Kandidaten wurden nach dem Fortpflanzungsgesetz ausgewertet.</translation>
    </message>
    <message>
        <source>Verified by Monte Carlo with %1 trials.</source>
        <translation>Bestätigt mit Monte Carlo, %1 Versuche.</translation>
    </message>
    <message>
        <source>Not every target is met: what is given is the best that was found.</source>
        <translation>Nicht jede Zielunsicherheit wird eingehalten: angegeben ist das Beste, das gefunden wurde.</translation>
    </message>
    <message>
        <source>%1: the way of the search to the best place, coloured by the objective.</source>
        <translation>%1: der Weg der Suche zum besten Ort, gefärbt nach der Zielfunktion.</translation>
    </message>
    <message>
        <source>%1: the candidates, coloured by what they gain; the larger ones are chosen.</source>
        <translation>%1: die Kandidaten, gefärbt nach ihrem Gewinn; die größeren sind gewählt.</translation>
    </message>
    <message>
        <source>combined</source>
        <translation>kombiniert</translation>
    </message>
    <message>
        <source>%1, constant</source>
        <translation>%1, Konstante</translation>
    </message>
    <message>
        <source>%1 components, added arithmetically</source>
        <translation>%1 Komponenten, linear addiert</translation>
    </message>
    <message>
        <source>%1 components, in quadrature</source>
        <translation>%1 Komponenten, quadratisch addiert</translation>
    </message>
    <message>
        <source>Table %1. %2</source>
        <translation>Tabelle %1. %2</translation>
    </message>
    <message>
        <source>Figure %1. %2</source>
        <translation>Bild %1. %2</translation>
    </message>
    <message>
        <source>Uncertainty report</source>
        <translation>Unsicherheitsbericht</translation>
    </message>
    <message>
        <source>Report of an uncertainty evaluation</source>
        <translation>Bericht über eine Unsicherheitsauswertung</translation>
    </message>
    <message>
        <source>Annex</source>
        <translation>Anhang</translation>
    </message>
    <message>
        <source>In the annex: %1.</source>
        <translation>Im Anhang: %1.</translation>
    </message>
    <message>
        <source>In the annex, on request: %1.</source>
        <translation>Im Anhang, auf Wunsch: %1.</translation>
    </message>
    <message>
        <source>The first %1 of %2 rows; the annex has all of them.</source>
        <translation>Die ersten %1 von %2 Zeilen; der Anhang enthält alle.</translation>
    </message>
    <message>
        <source>The first %1 of %2 rows; the CSV tables, and the annex on request, have all of them.</source>
        <translation>Die ersten %1 von %2 Zeilen; die CSV-Tabellen und auf Wunsch der Anhang enthalten alle.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables; the annex has the rest.</source>
        <translation>Gezeigt sind %1 von %2 Tabellen; der Anhang enthält die übrigen.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables; the CSV tables, and the annex on request, have the rest.</source>
        <translation>Gezeigt sind %1 von %2 Tabellen; die CSV-Tabellen und auf Wunsch der Anhang enthalten die übrigen.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 charts; the annex has the rest.</source>
        <translation>Gezeigt sind %1 von %2 Diagrammen; der Anhang enthält die übrigen.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 charts; the CSV tables, and the annex on request, have the rest.</source>
        <translation>Gezeigt sind %1 von %2 Diagrammen; die CSV-Tabellen und auf Wunsch der Anhang enthalten die übrigen.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables and %3 of %4 charts; the annex has the rest.</source>
        <translation>Gezeigt sind %1 von %2 Tabellen und %3 von %4 Diagrammen; der Anhang enthält die übrigen.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables and %3 of %4 charts; the CSV tables, and the annex on request, have the rest.</source>
        <translation>Gezeigt sind %1 von %2 Tabellen und %3 von %4 Diagrammen; die CSV-Tabellen und auf Wunsch der Anhang enthalten die übrigen.</translation>
    </message>
    <message>
        <source>%1 (constant)</source>
        <translation>%1 (Konstante)</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Nachher</translation>
    </message>
    <message>
        <source>U is stated by different rules: before, %1 After, %2</source>
        <translation>U ist nach verschiedenen Regeln angegeben: vorher, %1 Nachher, %2</translation>
    </message>
    <message>
        <source>%1 of %2 measurands are in both results; the budgets of %3 of them differ.</source>
        <translation>%1 von %2 Messgrößen sind in beiden Ergebnissen; die Budgets von %3 davon unterscheiden sich.</translation>
    </message>
    <message>
        <source>Shown are the %1 whose standard uncertainty changes most, relative to what it was.</source>
        <translation>Gezeigt sind die %1, deren Standardunsicherheit sich am meisten ändert, bezogen auf das, was sie war.</translation>
    </message>
    <message>
        <source>Distribution of %1 before and after.</source>
        <translation>Verteilung von %1 vorher und nachher.</translation>
    </message>
    <message>
        <source>Comparison of uncertainty evaluations</source>
        <translation>Vergleich von Unsicherheitsauswertungen</translation>
    </message>
    <message>
        <source>Only before: %1.</source>
        <translation>Nur vorher: %1.</translation>
    </message>
    <message>
        <source>Only after: %1.</source>
        <translation>Nur nachher: %1.</translation>
    </message>
    <message>
        <source>this report</source>
        <translation>dieser Bericht</translation>
    </message>
    <message>
        <source>there are no results for the certificate to state</source>
        <translation>es gibt keine Ergebnisse, die der Kalibrierschein angeben könnte</translation>
    </message>
    <message>
        <source>the standard uncertainty of %1 is not finite; a Digital Calibration Certificate has no place for that</source>
        <translation>die Standardunsicherheit von %1 ist nicht endlich; ein Digitaler Kalibrierschein hat dafür keinen Platz</translation>
    </message>
    <message>
        <source>there is no robot to write: no analysis uses or finds one</source>
        <translation>es gibt keinen Roboter zu schreiben: keine Analyse verwendet oder findet einen</translation>
    </message>
    <message>
        <source>the file is of one robot, and there are %1: choose an analysis that uses or finds the one to write (--analysis)</source>
        <translation>die Datei ist für einen Roboter, und es sind %1: eine Analyse wählen, die den zu schreibenden verwendet oder findet (--analysis)</translation>
    </message>
    <message>
        <source>there are no points to write: no analysis has a result with coordinates x, y, z of a point</source>
        <translation>es gibt keine Punkte zu schreiben: keine Analyse hat ein Ergebnis mit den Koordinaten x, y, z eines Punktes</translation>
    </message>
    <message>
        <source>robot %1: the file is of six joints that turn (shoulder to wrist_3); write it as URDF</source>
        <translation>Roboter %1: die Datei ist für sechs Drehgelenke (shoulder bis wrist_3); als URDF schreiben</translation>
    </message>
    <message>
        <source>there are no results to write</source>
        <translation>es gibt keine Ergebnisse zu schreiben</translation>
    </message>
    <message>
        <source>the workbook cannot be made in the folder for temporary files</source>
        <translation>die Arbeitsmappe kann im Ordner für temporäre Dateien nicht angelegt werden</translation>
    </message>
    <message>
        <source>the report carries no results to compare with (results.json)</source>
        <translation>der Bericht enthält keine Ergebnisse zum Vergleichen (results.json)</translation>
    </message>
    <message>
        <source>what the report carries as results.json is none of Covaria</source>
        <translation>was der Bericht als results.json enthält, ist nicht von Covaria</translation>
    </message>
    <message>
        <source>no folder could be made in %1: %2</source>
        <translation>in %1 konnte kein Ordner angelegt werden: %2</translation>
    </message>
    <message>
        <source>the attached file %1 would leave its folder; nothing was taken out</source>
        <translation>die angehängte Datei %1 würde ihren Ordner verlassen; nichts wurde herausgenommen</translation>
    </message>
    <message>
        <source>the attached file %1 cannot be taken out: another one is in its way</source>
        <translation>die angehängte Datei %1 kann nicht herausgenommen werden: eine andere steht im Weg</translation>
    </message>
    <message>
        <source>it is no PDF</source>
        <translation>sie ist kein PDF</translation>
    </message>
    <message>
        <source>it carries no project: it is no report of Covaria, or one of a version before 0.2.0, or another program has written it anew</source>
        <translation>sie enthält kein Projekt: sie ist kein Bericht von Covaria oder einer vor Version 0.2.0, oder ein anderes Programm hat sie neu geschrieben</translation>
    </message>
    <message>
        <source>best</source>
        <translation>bester</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>schlechtester</translation>
    </message>
    <message>
        <source>iso-surfaces at %1</source>
        <translation>Isoflächen bei %1</translation>
    </message>
    <message>
        <source>the study has not been run</source>
        <translation>die Studie ist noch nicht gelaufen</translation>
    </message>
    <message>
        <source>none of the study&apos;s output quantities has a place in space</source>
        <translation>keine der Ausgangsgrößen der Studie hat einen Ort im Raum</translation>
    </message>
    <message>
        <source>the point %1 does not move in this study</source>
        <translation>der Punkt %1 bewegt sich in dieser Studie nicht</translation>
    </message>
    <message>
        <source>best: %1</source>
        <translation>bester: %1</translation>
    </message>
    <message>
        <source>nothing that this design chooses stands in space</source>
        <translation>nichts, was dieser Entwurf wählt, steht im Raum</translation>
    </message>
    <message>
        <source>nothing that was tried has a result</source>
        <translation>nichts von dem, was versucht wurde, hat ein Ergebnis</translation>
    </message>
    <message>
        <source>candidates; the larger %1 of %2 are chosen</source>
        <translation>Kandidaten; die %1 größeren von %2 sind gewählt</translation>
    </message>
    <message>
        <source>gain: by how much the uncertainty is smaller with this candidate than without it, the others as chosen</source>
        <translation>Gewinn: um wie viel die Unsicherheit mit diesem Kandidaten kleiner ist als ohne ihn, die anderen wie gewählt</translation>
    </message>
    <message>
        <source>best so far, in the order of the search</source>
        <translation>bester Stand bisher, in der Reihenfolge der Suche</translation>
    </message>
    <message>
        <source>dashed: where it may stand</source>
        <translation>gestrichelt: wo es stehen darf</translation>
    </message>
    <message>
        <source>analysis</source>
        <translation>Analyse</translation>
    </message>
    <message>
        <source>kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>trajectory</source>
        <translation>Bahn</translation>
    </message>
    <message>
        <source>mean Monte Carlo</source>
        <translation>Mittelwert Monte Carlo</translation>
    </message>
    <message>
        <source>u Monte Carlo</source>
        <translation>u Monte Carlo</translation>
    </message>
    <message>
        <source>interval low</source>
        <translation>Intervall unten</translation>
    </message>
    <message>
        <source>interval high</source>
        <translation>Intervall oben</translation>
    </message>
    <message>
        <source>shortest low</source>
        <translation>kürzestes unten</translation>
    </message>
    <message>
        <source>shortest high</source>
        <translation>kürzestes oben</translation>
    </message>
    <message>
        <source>skewness</source>
        <translation>Schiefe</translation>
    </message>
    <message>
        <source>excess kurtosis</source>
        <translation>Exzess</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>Verhältnis</translation>
    </message>
    <message>
        <source>y at the estimates</source>
        <translation>y bei den Schätzwerten</translation>
    </message>
    <message>
        <source>u law of prop.</source>
        <translation>u Fortpfl.-Gesetz</translation>
    </message>
    <message>
        <source>u with second-order terms</source>
        <translation>u mit Gliedern zweiter Ordnung</translation>
    </message>
    <message>
        <source>shift of the estimate</source>
        <translation>Verschiebung des Schätzwerts</translation>
    </message>
    <message>
        <source>|cᵢ|·u(xᵢ) in %1</source>
        <translation>|cᵢ|·u(xᵢ) in %1</translation>
    </message>
    <message>
        <source>Share of variance in %</source>
        <translation>Anteil an der Varianz in %</translation>
    </message>
    <message>
        <source>alone, Monte Carlo, in %1</source>
        <translation>allein, Monte Carlo, in %1</translation>
    </message>
    <message>
        <source>ellipsoid, law of prop.</source>
        <translation>Ellipsoid, Fortpfl.-Gesetz</translation>
    </message>
    <message>
        <source>rectangle, law of prop.</source>
        <translation>Quader, Fortpfl.-Gesetz</translation>
    </message>
    <message>
        <source>ellipsoid, Monte Carlo</source>
        <translation>Ellipsoid, Monte Carlo</translation>
    </message>
    <message>
        <source>rectangle, Monte Carlo</source>
        <translation>Quader, Monte Carlo</translation>
    </message>
    <message>
        <source>y before</source>
        <translation>y vorher</translation>
    </message>
    <message>
        <source>y after</source>
        <translation>y nachher</translation>
    </message>
    <message>
        <source>Change of y</source>
        <translation>Änderung von y</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>|c|·u before in %1</source>
        <translation>|c|·u vorher in %1</translation>
    </message>
    <message>
        <source>|c|·u after in %1</source>
        <translation>|c|·u nachher in %1</translation>
    </message>
    <message>
        <source>Share before in %</source>
        <translation>Anteil vorher in %</translation>
    </message>
    <message>
        <source>Share after in %</source>
        <translation>Anteil nachher in %</translation>
    </message>
    <message>
        <source>Change of variance in %</source>
        <translation>Änderung der Varianz in %</translation>
    </message>
    <message>
        <source>first rotation, about z</source>
        <translation>erste Drehung, um z</translation>
    </message>
    <message>
        <source>second rotation, about y</source>
        <translation>zweite Drehung, um y</translation>
    </message>
    <message>
        <source>third rotation, about z</source>
        <translation>dritte Drehung, um z</translation>
    </message>
    <message>
        <source>rotation vector, x</source>
        <translation>Drehvektor, x</translation>
    </message>
    <message>
        <source>rotation vector, y</source>
        <translation>Drehvektor, y</translation>
    </message>
    <message>
        <source>rotation vector, z</source>
        <translation>Drehvektor, z</translation>
    </message>
    <message>
        <source>quaternion, scalar part</source>
        <translation>Quaternion, Skalarteil</translation>
    </message>
    <message>
        <source>quaternion, x</source>
        <translation>Quaternion, x</translation>
    </message>
    <message>
        <source>quaternion, y</source>
        <translation>Quaternion, y</translation>
    </message>
    <message>
        <source>quaternion, z</source>
        <translation>Quaternion, z</translation>
    </message>
    <message>
        <source>Coordinates that define the frame are left out.</source>
        <translation>Koordinaten, die das Koordinatensystem festlegen, sind weggelassen.</translation>
    </message>
    <message>
        <source>%1, coordinate %2</source>
        <translation>%1, Koordinate %2</translation>
    </message>
    <message>
        <source>tool centre point</source>
        <translation>Werkzeugmittelpunkt</translation>
    </message>
    <message>
        <source>centre of the flange</source>
        <translation>Mittelpunkt des Flansches</translation>
    </message>
    <message>
        <source>calibration of the artefact</source>
        <translation>Kalibrierung des Prüfkörpers</translation>
    </message>
    <message>
        <source>temperature of the artefact</source>
        <translation>Temperatur des Prüfkörpers</translation>
    </message>
    <message>
        <source>systematic error of indication</source>
        <translation>systematische Anzeigeabweichung</translation>
    </message>
    <message>
        <source>coordinate %1</source>
        <translation>Koordinate %1</translation>
    </message>
    <message>
        <source>The bias b is not corrected; |b| counts as a standard uncertainty (against JCGM 100 3.2.4).</source>
        <translation>Die Abweichung b wird nicht korrigiert; |b| zählt als Standardunsicherheit (entgegen JCGM 100 3.2.4).</translation>
    </message>
    <message>
        <source>The bias b is not part of u_c.</source>
        <translation>Die Abweichung b ist nicht Teil von u_c.</translation>
    </message>
    <message>
        <source>Measured values are taken as corrected by -b; u_var/sqrt(n) of the correction is part of u_c.</source>
        <translation>Messwerte gelten als um -b korrigiert; u_var/sqrt(n) der Korrektion ist Teil von u_c.</translation>
    </message>
    <message>
        <source>A coordinate of a point has u_c divided by √2.</source>
        <translation>Eine Koordinate eines Punktes hat u_c geteilt durch √2.</translation>
    </message>
    <message>
        <source>measured coordinate</source>
        <translation>gemessene Koordinate</translation>
    </message>
    <message>
        <source>typed standard uncertainty</source>
        <translation>eingegebene Standardunsicherheit</translation>
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
        <translation>Spezifikation: %1</translation>
    </message>
    <message>
        <source>The figure is taken as: %1.</source>
        <translation>Die Angabe ist so gemeint: %1.</translation>
    </message>
    <message>
        <source>%1, of a length: divided by √2</source>
        <translation>%1, einer Länge: geteilt durch √2</translation>
    </message>
    <message>
        <source>station, combination %1</source>
        <translation>Station, Kombination %1</translation>
    </message>
    <message>
        <source>instrument: standard uncertainties and correlation of the station</source>
        <translation>Messgerät: Standardunsicherheiten und Korrelation der Station</translation>
    </message>
    <message>
        <source>scale of distances</source>
        <translation>Maßstab der Distanzen</translation>
    </message>
    <message>
        <source>zero offset of distances</source>
        <translation>Nullpunktabweichung der Distanzen</translation>
    </message>
    <message>
        <source>index of the elevation</source>
        <translation>Index des Höhenwinkels</translation>
    </message>
    <message>
        <source>collimation</source>
        <translation>Zielachsfehler</translation>
    </message>
    <message>
        <source>squareness of the axes</source>
        <translation>Rechtwinkligkeit der Achsen</translation>
    </message>
    <message>
        <source>offset of the beam</source>
        <translation>Versatz des Strahls</translation>
    </message>
    <message>
        <source>coefficient of refraction</source>
        <translation>Refraktionskoeffizient</translation>
    </message>
    <message>
        <source>instrument: standard uncertainty</source>
        <translation>Messgerät: Standardunsicherheit</translation>
    </message>
    <message>
        <source>instrument: %1</source>
        <translation>Messgerät: %1</translation>
    </message>
    <message>
        <source>For a target at the height of the instrument.</source>
        <translation>Für ein Ziel in Höhe des Messgeräts.</translation>
    </message>
    <message>
        <source>station, %1</source>
        <translation>Station, %1</translation>
    </message>
    <message>
        <source>%1, %2, set-up %3</source>
        <translation>%1, %2, Aufstellung %3</translation>
    </message>
    <message>
        <source>displacement across the azimuth</source>
        <translation>Verschiebung quer zum Azimut</translation>
    </message>
    <message>
        <source>%1 to %2, %3</source>
        <translation>%1 nach %2, %3</translation>
    </message>
    <message>
        <source>calibrated length</source>
        <translation>kalibrierte Länge</translation>
    </message>
    <message>
        <source>calibration of the %1</source>
        <translation>Kalibrierung: %1</translation>
    </message>
    <message>
        <source>%1, calibrated length</source>
        <translation>%1, kalibrierte Länge</translation>
    </message>
    <message>
        <source>distance from %1 to %2</source>
        <translation>Abstand von %1 zu %2</translation>
    </message>
    <message>
        <source>angle at %1 from %2 to %3</source>
        <translation>Winkel in %1 von %2 nach %3</translation>
    </message>
    <message>
        <source>%1, measured minus calibrated length</source>
        <translation>%1, gemessene minus kalibrierte Länge</translation>
    </message>
    <message>
        <source>origin of %1, coordinate %2</source>
        <translation>Ursprung von %1, Koordinate %2</translation>
    </message>
    <message>
        <source>rotation of %1 about %2</source>
        <translation>Drehung von %1 um %2</translation>
    </message>
    <message>
        <source>The precision of the readings is no uncertainty of a position: it leaves out where the sensors stand and what their readings share. Monte Carlo is in the results.</source>
        <translation>Die Präzision der Ablesungen ist keine Unsicherheit einer Position: sie lässt weg, wo die Sensoren stehen und was ihre Ablesungen gemeinsam haben. Monte Carlo steht in den Ergebnissen.</translation>
    </message>
    <message>
        <source>No redundancy: as many readings as unknowns, so nothing can be checked.</source>
        <translation>Keine Redundanz: so viele Ablesungen wie Unbekannte, also kann nichts geprüft werden.</translation>
    </message>
    <message>
        <source>The residuals are larger than the uncertainties allow.</source>
        <translation>Die Residuen sind größer, als die Unsicherheiten zulassen.</translation>
    </message>
    <message>
        <source>The residuals are smaller than the uncertainties lead to expect.</source>
        <translation>Die Residuen sind kleiner, als die Unsicherheiten erwarten lassen.</translation>
    </message>
    <message>
        <source>The residuals agree with the uncertainties.</source>
        <translation>Die Residuen stimmen mit den Unsicherheiten überein.</translation>
    </message>
    <message>
        <source>%1 readings have |w| &gt; 3.29 (0.1 %); where several do, look at the largest first.</source>
        <translation>%1 Ablesungen haben |w| &gt; 3.29 (0.1 %); bei mehreren zuerst die größte ansehen.</translation>
    </message>
    <message>
        <source>%1 in %2, coordinate %3</source>
        <translation>%1 in %2, Koordinate %3</translation>
    </message>
    <message>
        <source>position of the platform, %1</source>
        <translation>Position der Plattform, %1</translation>
    </message>
    <message>
        <source>Chi-square of the residuals with the full covariance of the stated uncertainties; nominal coordinates are taken as exact. p is the probability of a larger value if all is as stated; the test has a level of 1 % for all sets together. Not tested: sets without stated uncertainty, and sets of more than %1 points.</source>
        <translation>Chi-Quadrat der Residuen mit der vollen Kovarianz der angegebenen Unsicherheiten; Nennkoordinaten gelten als exakt. p ist die Wahrscheinlichkeit eines größeren Wertes, wenn alles wie angegeben ist; der Test hat das Niveau 1 % für alle Sätze zusammen. Nicht geprüft: Sätze ohne angegebene Unsicherheit und Sätze von mehr als %1 Punkten.</translation>
    </message>
    <message>
        <source>Measured less nominal coordinates. w is a residual over its own standard uncertainty; |w| &gt; 3.29 (0.1 %) is remarked. Redundancy is the share of an error of the coordinate that stays in its residual.</source>
        <translation>Gemessene minus Nennkoordinaten. w ist ein Residuum durch seine eigene Standardunsicherheit; |w| &gt; 3.29 (0.1 %) wird angemerkt. Redundanz ist der Anteil eines Fehlers der Koordinate, der in ihrem Residuum bleibt.</translation>
    </message>
    <message>
        <source>reading of bar %1</source>
        <translation>Ablesung des Kugelstabs %1</translation>
    </message>
    <message>
        <source>ballbars: %1</source>
        <translation>Kugelstäbe: %1</translation>
    </message>
    <message>
        <source>length between supports %1</source>
        <translation>Abstand der Auflager %1</translation>
    </message>
    <message>
        <source>height of support %1</source>
        <translation>Höhe des Auflagers %1</translation>
    </message>
    <message>
        <source>ballbars: standard uncertainty</source>
        <translation>Kugelstäbe: Standardunsicherheit</translation>
    </message>
    <message>
        <source>scale of all lengths</source>
        <translation>Maßstab aller Längen</translation>
    </message>
    <message>
        <source>constant of bar %1</source>
        <translation>Konstante des Kugelstabs %1</translation>
    </message>
    <message>
        <source>%1, point %2</source>
        <translation>%1, Punkt %2</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>Punkt %1</translation>
    </message>
    <message>
        <source>axis %1 of the flange, angle towards %2</source>
        <translation>Achse %1 des Flansches, Winkel gegen %2</translation>
    </message>
    <message>
        <source>repeatability along %1</source>
        <translation>Wiederholpräzision entlang %1</translation>
    </message>
    <message>
        <source>repeatability: %1</source>
        <translation>Wiederholpräzision: %1</translation>
    </message>
    <message>
        <source>The coordinates are uncorrelated; unless they are normal, they are not independent: the distance has the law above, its direction is random.</source>
        <translation>Die Koordinaten sind unkorreliert; sofern sie nicht normalverteilt sind, sind sie nicht unabhängig: der Abstand hat die obige Verteilung, seine Richtung ist zufällig.</translation>
    </message>
    <message>
        <source>repeatability about %1</source>
        <translation>Wiederholpräzision um %1</translation>
    </message>
    <message>
        <source>repeatability of the orientation</source>
        <translation>Wiederholpräzision der Orientierung</translation>
    </message>
    <message>
        <source>%1 of joint %2</source>
        <translation>%1 von Gelenk %2</translation>
    </message>
    <message>
        <source>encoder</source>
        <translation>Encoder</translation>
    </message>
    <message>
        <source>tool, rotation about %1</source>
        <translation>Werkzeug, Drehung um %1</translation>
    </message>
    <message>
        <source>tool: standard uncertainty</source>
        <translation>Werkzeug: Standardunsicherheit</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1, combined</source>
        <translation>%1, kombiniert</translation>
    </message>
    <message>
        <source>%1, deviation</source>
        <translation>%1, Abweichung</translation>
    </message>
    <message>
        <source>reading of joint %1, %2</source>
        <translation>Ablesung von Gelenk %1, %2</translation>
    </message>
    <message>
        <source>position of the tool, %1</source>
        <translation>Position des Werkzeugs, %1</translation>
    </message>
    <message>
        <source>orientation of the tool, %1</source>
        <translation>Orientierung des Werkzeugs, %1</translation>
    </message>
    <message>
        <source>joint angle</source>
        <translation>Gelenkwinkel</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>link length</source>
        <translation>Armlänge</translation>
    </message>
    <message>
        <source>twist</source>
        <translation>Verwindung</translation>
    </message>
    <message>
        <source>second twist</source>
        <translation>zweite Verwindung</translation>
    </message>
    <message>
        <source>Components of a parameter combine in quadrature (Wen et al., Eq. 10). U has the factor 2 of the paper; with few effective degrees of freedom 95 % need more.</source>
        <translation>Komponenten eines Parameters werden quadratisch addiert (Wen et al., Gl. 10). U hat den Faktor 2 der Veröffentlichung; bei wenigen effektiven Freiheitsgraden ist für 95 % ein größerer Faktor nötig.</translation>
    </message>
    <message>
        <source>Places of the tool in the base frame of the robot.</source>
        <translation>Orte des Werkzeugs im Basissystem des Roboters.</translation>
    </message>
    <message>
        <source>calculated less measured %1, held back</source>
        <translation>berechnete minus gemessene Koordinate %1, zurückgehalten</translation>
    </message>
    <message>
        <source>orientation of the base, %1</source>
        <translation>Orientierung der Basis, %1</translation>
    </message>
    <message>
        <source>position of the base, %1</source>
        <translation>Position der Basis, %1</translation>
    </message>
    <message>
        <source>pose %1, rotation about %2</source>
        <translation>Pose %1, Drehung um %2</translation>
    </message>
    <message>
        <source>pose %1, %2</source>
        <translation>Pose %1, %2</translation>
    </message>
    <message>
        <source>measured orientation</source>
        <translation>gemessene Orientierung</translation>
    </message>
    <message>
        <source>pose %1, reading of joint %2</source>
        <translation>Pose %1, Ablesung von Gelenk %2</translation>
    </message>
    <message>
        <source>Singular values are those of the weighted Jacobian with columns of length one.</source>
        <translation>Singulärwerte sind die der gewichteten Jacobi-Matrix mit Spalten der Länge eins.</translation>
    </message>
    <message>
        <source>Least well told apart: %1.</source>
        <translation>Am schlechtesten zu trennen: %1.</translation>
    </message>
    <message>
        <source>A residual beyond %1 times its own standard uncertainty is an outlier: 5 % for all residuals together (Bonferroni).</source>
        <translation>Ein Residuum über dem %1-Fachen seiner eigenen Standardunsicherheit ist ein Ausreißer: 5 % für alle Residuen zusammen (Bonferroni).</translation>
    </message>
    <message>
        <source>Nominal: the same base and ball fitted with the nominal parameters. E_n = |d|/U: below 1 the pose agrees with the calibration.</source>
        <translation>Nenn: dieselbe Basis und Kugel, mit den Nennparametern angepasst. E_n = |d|/U: unter 1 stimmt die Pose mit der Kalibrierung überein.</translation>
    </message>
    <message>
        <source>radius of the circle of joint %1</source>
        <translation>Radius des Kreises von Gelenk %1</translation>
    </message>
    <message>
        <source>%1, point %2, %3</source>
        <translation>%1, Punkt %2, %3</translation>
    </message>
    <message>
        <source>Simulated points of the nominal robot: they lie on their circles.</source>
        <translation>Simulierte Punkte des Nennroboters: sie liegen auf ihren Kreisen.</translation>
    </message>
    <message>
        <source>load %1, compensated</source>
        <translation>Last %1, entkoppelt</translation>
    </message>
    <message>
        <source>load %1 by its own channel alone</source>
        <translation>Last %1 nach dem eigenen Kanal allein</translation>
    </message>
    <message>
        <source>calibration machine, %1</source>
        <translation>Kalibriermaschine, %1</translation>
    </message>
    <message>
        <source>calibration machine, Eq 5</source>
        <translation>Kalibriermaschine, Gl. 5</translation>
    </message>
    <message>
        <source>regression of %1</source>
        <translation>Regression von %1</translation>
    </message>
    <message>
        <source>reading of %1 by load %2</source>
        <translation>Ablesung von %1 unter Last %2</translation>
    </message>
    <message>
        <source>quadratic term of %1 by load %2</source>
        <translation>quadratisches Glied von %1 unter Last %2</translation>
    </message>
    <message>
        <source>%1 of %2, %3</source>
        <translation>%1 von %2, %3</translation>
    </message>
    <message>
        <source>standard deviation of one reading, Eq 3</source>
        <translation>Standardabweichung einer Ablesung, Gl. 3</translation>
    </message>
    <message>
        <source>net reading of %1, %2</source>
        <translation>Nettoablesung von %1, %2</translation>
    </message>
    <message>
        <source>Eq 6</source>
        <translation>Gl. 6</translation>
    </message>
    <message>
        <source>Eq 7</source>
        <translation>Gl. 7</translation>
    </message>
    <message>
        <source>Eq 10, full width of the loop</source>
        <translation>Gl. 10, volle Breite der Schleife</translation>
    </message>
    <message>
        <source>Eq 10, in proportion to the load</source>
        <translation>Gl. 10, im Verhältnis zur Last</translation>
    </message>
    <message>
        <source>Condition number, by rated outputs and rated loads: %1; with quadratic terms beside these slopes.</source>
        <translation>Konditionszahl, bezogen auf Nennausgänge und Nennlasten: %1; mit quadratischen Gliedern neben diesen Steigungen.</translation>
    </message>
    <message>
        <source>Condition number, by rated outputs and rated loads: %1.</source>
        <translation>Konditionszahl, bezogen auf Nennausgänge und Nennlasten: %1.</translation>
    </message>
    <message>
        <source>Uncompensated: by the slope of the channel&apos;s own axis. The uncertainties of both are among the results.</source>
        <translation>Nicht ausgeglichen: nach der Steigung der eigenen Achse des Kanals. Die Unsicherheiten beider stehen in den Ergebnissen.</translation>
    </message>
    <message>
        <source>Reproduces: equal in all printed digits. Inside rounding: what it is computed from was rounded, too. Interference, percent: the row&apos;s sensor, then the column&apos;s axis.</source>
        <translation>Reproduziert: gleich in allen gedruckten Stellen. Innerhalb der Rundung: auch das, woraus es berechnet ist, war gerundet. Übersprechen, Prozent: der Sensor der Zeile, dann die Achse der Spalte.</translation>
    </message>
    <message>
        <source>Fig. 2: %1 s without load before a series, %2 s at each load.</source>
        <translation>Bild 2: %1 s ohne Last vor einer Reihe, %2 s bei jeder Last.</translation>
    </message>
    <message>
        <source>A row is a load, a column the sensor that answers to it.</source>
        <translation>Eine Zeile ist eine Last, eine Spalte der Sensor, der darauf antwortet.</translation>
    </message>
    <message>
        <source>A row is a sensor, a column the load under which it gives this output.</source>
        <translation>Eine Zeile ist ein Sensor, eine Spalte die Last, unter der er diesen Ausgang gibt.</translation>
    </message>
    <message>
        <source>Magnitudes: the signs are not known.</source>
        <translation>Beträge: die Vorzeichen sind nicht bekannt.</translation>
    </message>
    <message>
        <source>U = hysteresis + interference + k u_c with k = %1: a linear sum of two largest values and an expanded uncertainty. Type A: n = %2 runs, %3 degrees of freedom.</source>
        <translation>U = Hysterese + Übersprechen + k u_c mit k = %1: eine lineare Summe aus zwei größten Werten und einer erweiterten Unsicherheit. Typ A: n = %2 Durchläufe, %3 Freiheitsgrade.</translation>
    </message>
    <message>
        <source>Calibration machine: %1.</source>
        <translation>Kalibriermaschine: %1.</translation>
    </message>
    <message>
        <source>Table 3 takes the Type B standard uncertainties that are stated, not these.</source>
        <translation>Tabelle 3 nimmt die angegebenen Standardunsicherheiten vom Typ B, nicht diese.</translation>
    </message>
    <message>
        <source>load %1 that channel %1 tells</source>
        <translation>Last %1, die der Kanal %1 anzeigt</translation>
    </message>
    <message>
        <source>net reading of channel %1</source>
        <translation>Nettoablesung des Kanals %1</translation>
    </message>
    <message>
        <source>load by the rated load of channel %1</source>
        <translation>Last des Kanals %1, bezogen auf die Nennlast</translation>
    </message>
    <message>
        <source>Eqs 3, 4</source>
        <translation>Gl. 3, 4</translation>
    </message>
    <message>
        <source>net reading of %1 at rated load</source>
        <translation>Nettoablesung von %1 bei Nennlast</translation>
    </message>
    <message>
        <source>calibration machine</source>
        <translation>Kalibriermaschine</translation>
    </message>
    <message>
        <source>Eq 5</source>
        <translation>Gl. 5</translation>
    </message>
    <message>
        <source>Eq 10, as a rectangular distribution over the loop</source>
        <translation>Gl. 10, als Rechteckverteilung über die Schleife</translation>
    </message>
    <message>
        <source>unknown load on %1</source>
        <translation>unbekannte Last auf %1</translation>
    </message>
    <message>
        <source>set-up: unknown between minus and plus the rated load</source>
        <translation>Vorgaben: unbekannt zwischen minus und plus der Nennlast</translation>
    </message>
    <message>
        <source>load on %1 by its rated load</source>
        <translation>Last auf %1 durch ihre Nennlast</translation>
    </message>
    <message>
        <source>The paper adds the largest hysteresis and the largest interference to k times u_c. It counts one other load only: with several loads their interference adds up, and exceeds the paper&apos;s U for %1 of %2 sensors when all act fully.</source>
        <translation>Die Veröffentlichung addiert die größte Hysterese und das größte Übersprechen zu k mal u_c. Sie zählt nur eine andere Last: bei mehreren Lasten addiert sich ihr Übersprechen und übersteigt das U der Veröffentlichung für %1 von %2 Sensoren, wenn alle voll wirken.</translation>
    </message>
    <message>
        <source>So the linear sum is no bound under combined load, and for one component alone it is far too large. As hysteresis and interference are limits and no standard uncertainties, it is no coverage interval either.</source>
        <translation>Die lineare Summe ist also keine Grenze unter kombinierter Last, und für eine Komponente allein ist sie viel zu groß. Da Hysterese und Übersprechen Grenzen und keine Standardunsicherheiten sind, ist sie auch kein Überdeckungsintervall.</translation>
    </message>
    <message>
        <source>GUM: hysteresis, non-zero error and resolution are rectangular, each unknown load is rectangular between minus and plus its rated load, root sum of squares. One component alone: k from the t-distribution with the effective degrees of freedom.</source>
        <translation>GUM: Hysterese, Nullpunktabweichung und Auflösung sind rechteckverteilt, jede unbekannte Last ist rechteckverteilt zwischen minus und plus ihrer Nennlast, Wurzel der Quadratsumme. Eine Komponente allein: k aus der t-Verteilung mit den effektiven Freiheitsgraden.</translation>
    </message>
    <message>
        <source>Repeatability: the largest of the steps; its degrees of freedom are those of one step. Pooled over the steps it has more of them.</source>
        <translation>Wiederholpräzision: die größte der Stufen; ihre Freiheitsgrade sind die einer Stufe. Über die Stufen zusammengefasst hat sie mehr davon.</translation>
    </message>
    <message>
        <source>pooled standard deviation</source>
        <translation>zusammengefasste Standardabweichung</translation>
    </message>
    <message>
        <source>mean of %1 observations</source>
        <translation>Mittelwert von %1 Beobachtungen</translation>
    </message>
    <message>
        <source>s is the experimental standard deviation, u = s/√n (JCGM 100 4.2). A quantity that is stated as pooled observations has the u of all its series together (JCGM 100 4.2.4).</source>
        <translation>s ist die empirische Standardabweichung, u = s/√n (JCGM 100 4.2). Eine Größe, die als zusammengefasste Beobachtungen angegeben ist, hat das u aller ihrer Reihen zusammen (JCGM 100 4.2.4).</translation>
    </message>
    <message>
        <source>scatter of the means of the groups</source>
        <translation>Streuung der Mittelwerte der Gruppen</translation>
    </message>
    <message>
        <source>components of variance between and within the groups</source>
        <translation>Varianzkomponenten zwischen und innerhalb der Gruppen</translation>
    </message>
    <message>
        <source>%1 groups, %2 observations</source>
        <translation>%1 Gruppen, %2 Beobachtungen</translation>
    </message>
    <message>
        <source>mean of all observations</source>
        <translation>Mittelwert aller Beobachtungen</translation>
    </message>
    <message>
        <source>There is an effect of the groups at the level of 5 %.</source>
        <translation>Es gibt einen Effekt der Gruppen auf dem Niveau 5 %.</translation>
    </message>
    <message>
        <source>No effect of the groups is seen at the level of 5 %.</source>
        <translation>Auf dem Niveau 5 % ist kein Effekt der Gruppen zu sehen.</translation>
    </message>
    <message>
        <source>The component of variance between the groups is zero: all observations count as independent.</source>
        <translation>Die Varianzkomponente zwischen den Gruppen ist null: alle Beobachtungen zählen als unabhängig.</translation>
    </message>
    <message>
        <source>scatter of the points about the curve</source>
        <translation>Streuung der Punkte um die Kurve</translation>
    </message>
    <message>
        <source>least squares, residuals of %1 points</source>
        <translation>kleinste Quadrate, Residuen von %1 Punkten</translation>
    </message>
    <message>
        <source>value of the curve at the origin</source>
        <translation>Wert der Kurve am Ursprung</translation>
    </message>
    <message>
        <source>coefficient of the power %1</source>
        <translation>Koeffizient der Potenz %1</translation>
    </message>
    <message>
        <source>mean of y</source>
        <translation>Mittelwert von y</translation>
    </message>
    <message>
        <source>term of degree %1 (orthonormal polynomial)</source>
        <translation>Glied vom Grad %1 (orthonormales Polynom)</translation>
    </message>
    <message>
        <source>%1 of point %2</source>
        <translation>%1 von Punkt %2</translation>
    </message>
    <message>
        <source>stated uncertainty of %1</source>
        <translation>angegebene Unsicherheit von %1</translation>
    </message>
    <message>
        <source>table of points</source>
        <translation>Tabelle der Punkte</translation>
    </message>
    <message>
        <source>observed y</source>
        <translation>beobachtetes y</translation>
    </message>
    <message>
        <source>%1, observed y</source>
        <translation>%1, beobachtetes y</translation>
    </message>
    <message>
        <source>table of the inverse use</source>
        <translation>Tabelle der umgekehrten Verwendung</translation>
    </message>
    <message>
        <source>value of the curve at %1</source>
        <translation>Wert der Kurve bei %1</translation>
    </message>
    <message>
        <source>x where the curve is %1</source>
        <translation>x, bei dem die Kurve %1 ist</translation>
    </message>
    <message>
        <source>The residuals agree with the stated uncertainties.</source>
        <translation>Die Residuen stimmen mit den angegebenen Unsicherheiten überein.</translation>
    </message>
    <message>
        <source>The residuals are larger than the stated uncertainties explain: the curve or the uncertainties do not describe these points.</source>
        <translation>Die Residuen sind größer, als die angegebenen Unsicherheiten erklären: die Kurve oder die Unsicherheiten beschreiben diese Punkte nicht.</translation>
    </message>
    <message>
        <source>The x of y = %1 lies outside of the points of the calibration.</source>
        <translation>Das x von y = %1 liegt außerhalb der Punkte der Kalibrierung.</translation>
    </message>
    <message>
        <source>the parameters come from an analysis, which is evaluated in every trial: their correlation cannot be ignored</source>
        <translation>die Parameter stammen aus einer Analyse, die in jedem Versuch ausgewertet wird: ihre Korrelation lässt sich nicht vernachlässigen</translation>
    </message>
    <message>
        <source>Rz(θ) Tz(d) Tx(a) Rx(α) Ry(β), β for parallel joints</source>
        <translation>Rz(θ) Tz(d) Tx(a) Rx(α) Ry(β), β für parallele Gelenke</translation>
    </message>
    <message>
        <source>Rz(θ) Tz(d) Tx(a) Rx(α), Denavit-Hartenberg</source>
        <translation>Rz(θ) Tz(d) Tx(a) Rx(α), Denavit-Hartenberg</translation>
    </message>
    <message>
        <source>Rx(α) Tx(a) Rz(θ) Tz(d), Craig: α and a before joint i</source>
        <translation>Rx(α) Tx(a) Rz(θ) Tz(d), Craig: α und a vor Gelenk i</translation>
    </message>
    <message>
        <source>Date of receipt</source>
        <translation>Datum des Eingangs</translation>
    </message>
    <message>
        <source>Date of calibration</source>
        <translation>Datum der Kalibrierung</translation>
    </message>
    <message>
        <source>Date of issue</source>
        <translation>Datum der Ausstellung</translation>
    </message>
    <message>
        <source>To first order no input quantity influences %1 at these estimates: its uncertainty is of second order, as Monte Carlo shows</source>
        <translation>In erster Ordnung beeinflusst keine Eingangsgröße %1 bei diesen Schätzwerten: seine Unsicherheit ist von zweiter Ordnung, wie Monte Carlo zeigt</translation>
    </message>
    <message>
        <source>Calibration certificate</source>
        <translation>Kalibrierschein</translation>
    </message>
    <message>
        <source>not normal; k u fits as far as so few trials can tell</source>
        <translation>nicht normal; k u passt, soweit so wenige Versuche es sagen können</translation>
    </message>
    <message>
        <source>measured artefact, Porath et al., Eq. 2</source>
        <translation>gemessenes Normal, Porath et al., Gl. 2</translation>
    </message>
    <message>
        <source>not controlled</source>
        <translation>nicht kontrolliert</translation>
    </message>
    <message>
        <source>outlier?</source>
        <translation>Ausreißer?</translation>
    </message>
    <message>
        <source>not tested</source>
        <translation>nicht geprüft</translation>
    </message>
    <message>
        <source>residuals larger than stated</source>
        <translation>Residuen größer als angegeben</translation>
    </message>
    <message>
        <source>agrees</source>
        <translation>stimmt überein</translation>
    </message>
    <message>
        <source>distance: largest</source>
        <translation>Abstand: größter</translation>
    </message>
    <message>
        <source>distance: RP = mean + 3 s</source>
        <translation>Abstand: RP = Mittelwert + 3 s</translation>
    </message>
    <message>
        <source>does not move the measured points in any pose</source>
        <translation>bewegt die gemessenen Punkte in keiner Pose</translation>
    </message>
    <message>
        <source>moves the measured points as %1 can: coupled with it, held at its nominal value</source>
        <translation>bewegt die gemessenen Punkte, wie es %1 kann: damit gekoppelt, beim Nennwert gehalten</translation>
    </message>
    <message>
        <source>coordinates in the fit</source>
        <translation>Koordinaten in der Ausgleichung</translation>
    </message>
    <message>
        <source>unknowns (rank)</source>
        <translation>Unbekannte (Rang)</translation>
    </message>
    <message>
        <source>condition of the fit</source>
        <translation>Kondition der Ausgleichung</translation>
    </message>
    <message>
        <source>smallest singular value</source>
        <translation>kleinster Singulärwert</translation>
    </message>
    <message>
        <source>residuals over what uncertainties explain</source>
        <translation>Residuen, bezogen auf das, was Unsicherheiten erklären</translation>
    </message>
    <message>
        <source>outlier</source>
        <translation>Ausreißer</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>one ball is one point: it has no orientation</source>
        <translation>eine Kugel ist ein Punkt: sie hat keine Orientierung</translation>
    </message>
    <message>
        <source>places the base frame on axis 1: by definition, as nominal; it would need a measured base</source>
        <translation>legt das Basissystem auf Achse 1: nach Definition wie der Nennwert; nötig wäre eine gemessene Basis</translation>
    </message>
    <message>
        <source>places the frame of the last link, which no axis follows: by definition, as nominal</source>
        <translation>legt das System des letzten Glieds fest, auf das keine Achse folgt: nach Definition wie der Nennwert</translation>
    </message>
    <message>
        <source>the axis is parallel to the next: 0 by definition, or beta and d would describe the same</source>
        <translation>die Achse ist parallel zur nächsten: 0 nach Definition, sonst beschrieben beta und d dasselbe</translation>
    </message>
    <message>
        <source>reproduces</source>
        <translation>stimmt überein</translation>
    </message>
    <message>
        <source>inside rounding</source>
        <translation>innerhalb der Rundung</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>weicht ab</translation>
    </message>
    <message>
        <source>planned</source>
        <translation>geplant</translation>
    </message>
    <message>
        <source>total</source>
        <translation>gesamt</translation>
    </message>
    <message>
        <source>standard deviation of the means of the groups</source>
        <translation>Standardabweichung der Mittelwerte der Gruppen</translation>
    </message>
    <message>
        <source>s_a, from the means of the groups</source>
        <translation>s_a, aus den Mittelwerten der Gruppen</translation>
    </message>
    <message>
        <source>s_b, within the groups</source>
        <translation>s_b, innerhalb der Gruppen</translation>
    </message>
    <message>
        <source>s_B, between the groups</source>
        <translation>s_B, zwischen den Gruppen</translation>
    </message>
    <message>
        <source>n_0, size of the groups</source>
        <translation>n_0, Größe der Gruppen</translation>
    </message>
    <message>
        <source>F = s_a²/s_b²</source>
        <translation>F = s_a²/s_b²</translation>
    </message>
    <message>
        <source>95 % quantile of F</source>
        <translation>95-%-Quantil von F</translation>
    </message>
    <message>
        <source>97.5 % quantile of F</source>
        <translation>97,5-%-Quantil von F</translation>
    </message>
    <message>
        <source>between the groups</source>
        <translation>zwischen den Gruppen</translation>
    </message>
    <message>
        <source>within the groups</source>
        <translation>innerhalb der Gruppen</translation>
    </message>
    <message>
        <source>chi-squared</source>
        <translation>Chi-Quadrat</translation>
    </message>
    <message>
        <source>its 95 % quantile</source>
        <translation>dessen 95-%-Quantil</translation>
    </message>
    <message>
        <source>standard deviation of the residuals</source>
        <translation>Standardabweichung der Residuen</translation>
    </message>
    <message>
        <source>coefficient of determination R²</source>
        <translation>Bestimmtheitsmaß R²</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>residuals</source>
        <translation>Residuen</translation>
    </message>
    <message>
        <source>position %1, rotations about x, y, z: %2</source>
        <translation>Position %1, Drehungen um x, y, z: %2</translation>
    </message>
    <message>
        <source>1 further component</source>
        <translation>1 weitere Komponente</translation>
    </message>
    <message>
        <source>Shown for %1, the first of the %2 groups; the CSV table of budgets has every group.</source>
        <translation>Gezeigt für %1, die erste der %2 Gruppen; die CSV-Tabelle der Budgets enthält jede Gruppe.</translation>
    </message>
    <message>
        <source>Shown for %1: of the %2 groups it has the largest expanded uncertainties on average; the CSV table of budgets has every group.</source>
        <translation>Gezeigt für %1: von den %2 Gruppen hat sie im Mittel die größten erweiterten Unsicherheiten; die CSV-Tabelle der Budgets enthält jede Gruppe.</translation>
    </message>
    <message>
        <source>Shown for %1: of the %2 groups with the same quantities it has the largest expanded uncertainties on average; the CSV table of budgets has all %3 groups.</source>
        <translation>Gezeigt für %1: von den %2 Gruppen mit denselben Größen hat sie im Mittel die größten erweiterten Unsicherheiten; die CSV-Tabelle der Budgets enthält alle %3 Gruppen.</translation>
    </message>
    <message>
        <source>The law of propagation is validated by JCGM 101 clause 8 where both ends of its coverage interval, y ± U, lie within the numerical tolerance δ of those of the propagation of distributions. Validated: %1 of %2.</source>
        <translation>Das Fortpflanzungsgesetz ist nach JCGM 101 Abschnitt 8 validiert, wo beide Enden seines Überdeckungsintervalls, y ± U, innerhalb der numerischen Toleranz δ bei denen der Fortpflanzung von Verteilungen liegen. Validiert: %1 von %2.</translation>
    </message>
    <message>
        <source>Shape of the distributions by Monte Carlo</source>
        <translation>Form der Verteilungen nach Monte Carlo</translation>
    </message>
    <message>
        <source>From &apos;%1&apos; on, %2 of %3 rows; the annex has all of them.</source>
        <translation>Ab „%1“ %2 von %3 Zeilen; der Anhang enthält alle.</translation>
    </message>
    <message>
        <source>From &apos;%1&apos; on, %2 of %3 rows; the CSV tables, and the annex on request, have all of them.</source>
        <translation>Ab „%1“ %2 von %3 Zeilen; die CSV-Tabellen und auf Wunsch der Anhang enthalten alle.</translation>
    </message>
    <message>
        <source>The annex has the charts.</source>
        <translation>Der Anhang enthält die Diagramme.</translation>
    </message>
    <message>
        <source>The CSV tables, and the annex on request, have what the charts show.</source>
        <translation>Was die Diagramme zeigen, enthalten die CSV-Tabellen und auf Wunsch der Anhang.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables and no chart; the annex has the rest.</source>
        <translation>Gezeigt sind %1 von %2 Tabellen und kein Diagramm; der Anhang enthält die übrigen.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables and no chart; the CSV tables, and the annex on request, have the rest.</source>
        <translation>Gezeigt sind %1 von %2 Tabellen und kein Diagramm; die CSV-Tabellen und auf Wunsch der Anhang enthalten die übrigen.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>Unbekannte</translation>
    </message>
    <message>
        <source>coupled with</source>
        <translation>gekoppelt mit</translation>
    </message>
    <message>
        <source>Observations of %1</source>
        <translation>Beobachtungen von %1</translation>
    </message>
    <message>
        <source>mean + s</source>
        <translation>Mittelwert + s</translation>
    </message>
    <message>
        <source>mean − s</source>
        <translation>Mittelwert − s</translation>
    </message>
    <message>
        <source>What is reported, and in which unit. Without rows: every name that an equation defines and no other one uses, in the unit of the first quantity of the same dimension, else in SI units.</source>
        <translation>Was berichtet wird und in welcher Einheit. Ohne Zeilen: jeder Name, den eine Gleichung definiert und keine andere benutzt, in der Einheit der ersten Größe gleicher Dimension, sonst in SI-Einheiten.</translation>
    </message>
    <message>
        <source>arcsine</source>
        <translation>Arkussinus</translation>
    </message>
    <message>
        <source>curvilinear</source>
        <translation>krummlinig</translation>
    </message>
    <message>
        <source>inexactness</source>
        <translation>Ungenauigkeit</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>pooled</source>
        <translation>gepoolt</translation>
    </message>
    <message>
        <source>From the set-up as it is stated. Values and uncertainties that other analyses give (%1 quantities) are in the results, not here.</source>
        <translation>Aus dem Aufbau, wie er angegeben ist. Werte und Unsicherheiten, die andere Analysen liefern (%1 Größen), stehen in den Ergebnissen, nicht hier.</translation>
    </message>
    <message>
        <source>Limit of the coverage interval: of Monte Carlo, else of the law of propagation</source>
        <translation>Grenze des Überdeckungsintervalls: nach Monte Carlo, sonst nach dem Fortpflanzungsgesetz</translation>
    </message>
    <message>
        <source>Input quantities that the component is part of</source>
        <translation>Eingangsgrößen, zu denen die Komponente gehört</translation>
    </message>
    <message>
        <source>Quantity or component of uncertainty, as at the bars of the chart</source>
        <translation>Größe oder Unsicherheitskomponente, wie an den Balken des Diagramms</translation>
    </message>
    <message>
        <source>density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>quantile</source>
        <translation>Quantil</translation>
    </message>
    <message>
        <source>calibrated lengths</source>
        <translation>kalibrierte Längen</translation>
    </message>
    <message>
        <source>distances</source>
        <translation>Abstände</translation>
    </message>
    <message>
        <source>angles</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>scale bar</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>supports</source>
        <translation>Auflager</translation>
    </message>
    <message>
        <source>axes of the flange</source>
        <translation>Achsen des Flansches</translation>
    </message>
    <message>
        <source>circles</source>
        <translation>Kreise</translation>
    </message>
    <message>
        <source>calibration matrix</source>
        <translation>Kalibriermatrix</translation>
    </message>
    <message>
        <source>loads on other axes</source>
        <translation>Lasten auf anderen Achsen</translation>
    </message>
    <message>
        <source>scatter of all observations</source>
        <translation>Streuung aller Beobachtungen</translation>
    </message>
    <message>
        <source>points, x</source>
        <translation>Punkte, x</translation>
    </message>
    <message>
        <source>points, y</source>
        <translation>Punkte, y</translation>
    </message>
    <message>
        <source>inverse use</source>
        <translation>inverse Verwendung</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>%1, all rows: %2</source>
        <translation>%1, alle Zeilen: %2</translation>
    </message>
    <message>
        <source>%1: uncertainty</source>
        <translation>%1: Unsicherheit</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>%1: estimate</source>
        <translation>%1: Schätzwert</translation>
    </message>
    <message>
        <source>%1, factor</source>
        <translation>%1, Faktor</translation>
    </message>
    <message>
        <source>%1, added</source>
        <translation>%1, addiert</translation>
    </message>
    <message>
        <source>base b</source>
        <translation>Basis b</translation>
    </message>
    <message>
        <source>platform p</source>
        <translation>Plattform p</translation>
    </message>
    <message>
        <source>support %1</source>
        <translation>Auflager %1</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>Achse %1</translation>
    </message>
    <message>
        <source>check %1</source>
        <translation>Kontrolle %1</translation>
    </message>
    <message>
        <source>axis of %1</source>
        <translation>Achse von %1</translation>
    </message>
    <message>
        <source>scale bar %1</source>
        <translation>Maßstab %1</translation>
    </message>
    <message>
        <source>%1 (u of first order: %2 of that by Monte Carlo)</source>
        <translation>%1 (u erster Ordnung: %2 des u aus Monte Carlo)</translation>
    </message>
    <message>
        <source>S / %</source>
        <translation>S / %</translation>
    </message>
    <message>
        <source>Share of the variance that the component causes by itself (Sobol index)</source>
        <translation>Anteil an der Varianz, den die Komponente allein verursacht (Sobol-Index)</translation>
    </message>
    <message>
        <source>S total / %</source>
        <translation>S gesamt / %</translation>
    </message>
    <message>
        <source>Share of the variance with all interactions of the component with others</source>
        <translation>Anteil an der Varianz mit allen Wechselwirkungen der Komponente mit anderen</translation>
    </message>
    <message>
        <source>ν (first order)</source>
        <translation>ν (erste Ordnung)</translation>
    </message>
    <message>
        <source>%1 out of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1 interval, low</source>
        <translation>Intervall %1, unten</translation>
    </message>
    <message>
        <source>%1 interval, high</source>
        <translation>Intervall %1, oben</translation>
    </message>
    <message>
        <source>Interval, low</source>
        <translation>Intervall, unten</translation>
    </message>
    <message>
        <source>Interval, high</source>
        <translation>Intervall, oben</translation>
    </message>
    <message>
        <source>ballbars</source>
        <translation>Kugelstäbe</translation>
    </message>
    <message>
        <source>flange</source>
        <translation>Flansch</translation>
    </message>
    <message>
        <source>A mean of n observations is drawn from a t distribution with n − 1 degrees of freedom (JCGM 101 6.4.9). Means of simultaneous observations are drawn from one multivariate t distribution with these n − 1 degrees of freedom; with the n − N of JCGM 102 5.3.2 no mean would keep its own distribution.</source>
        <translation>Ein Mittelwert aus n Beobachtungen wird aus einer t-Verteilung mit n − 1 Freiheitsgraden gezogen (JCGM 101 6.4.9). Mittelwerte gleichzeitiger Beobachtungen werden aus einer gemeinsamen multivariaten t-Verteilung mit diesen n − 1 Freiheitsgraden gezogen; mit n − N nach JCGM 102 5.3.2 behielte kein Mittelwert seine eigene Verteilung.</translation>
    </message>
    <message>
        <source>if it vanished, U would exceed the target again, with fewer degrees of freedom</source>
        <translation>verschwände sie, läge U wieder über der Vorgabe: mit weniger Freiheitsgraden</translation>
    </message>
    <message>
        <source>Unit of the value, and of a and b where they have no other; empty: 1. A difference of temperatures is given in K.</source>
        <translation>Einheit des Werts, und von a und b, wo sie keine andere haben; leer: 1. Eine Temperaturdifferenz wird in K angegeben.</translation>
    </message>
    <message>
        <source>First figure of the statement.</source>
        <translation>Erste Zahl der Angabe.</translation>
    </message>
    <message>
        <source>unit of a, b</source>
        <translation>Einheit von a, b</translation>
    </message>
    <message>
        <source>Unit of the statement&apos;s figures; empty: the row&apos;s. % and ppm of a quantity that has a unit are parts of its value.</source>
        <translation>Einheit der Zahlen der Angabe; leer: die der Zeile. % und ppm einer Größe mit Einheit sind Teile ihres Werts.</translation>
    </message>
    <message>
        <source>Budget of %1</source>
        <translation>Budget von %1</translation>
    </message>
    <message>
        <source>Two correlated components have half of their covariance each, in the effective degrees of freedom too.</source>
        <translation>Zwei korrelierte Komponenten haben je die Hälfte ihrer Kovarianz, auch in den effektiven Freiheitsgraden.</translation>
    </message>
    <message>
        <source>u along any axis</source>
        <translation>u längs jeder Achse</translation>
    </message>
    <message>
        <source>results: in the base frame of the robot</source>
        <translation>Ergebnisse: im Basiskoordinatensystem des Roboters</translation>
    </message>
    <message>
        <source>%1: chosen at an end of its range; a wider one can give a better design.</source>
        <translation>%1: am Ende seines Bereichs gewählt; ein weiterer kann einen besseren Entwurf ergeben.</translation>
    </message>
    <message>
        <source>artefact</source>
        <translation>Prüfkörper</translation>
    </message>
    <message>
        <source>length standard</source>
        <translation>Längennormal</translation>
    </message>
    <message>
        <source>station</source>
        <translation>Standpunkt</translation>
    </message>
    <message>
        <source>field of view</source>
        <translation>Sichtfeld</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>Of these verdicts, %1 could be the other one with other trials.</source>
        <translation>Von diesen Urteilen könnten %1 mit anderen Versuchen anders ausfallen.</translation>
    </message>
    <message>
        <source>the value typed is used, not the mean of the observations, %1</source>
        <translation>verwendet wird der eingetippte Wert, nicht der Mittelwert der Beobachtungen, %1</translation>
    </message>
    <message>
        <source>the correlation coefficient of %1 and %2 must lie between -1 and 1; it is %3</source>
        <translation>der Korrelationskoeffizient von %1 und %2 muss zwischen -1 und 1 liegen; er ist %3</translation>
    </message>
    <message>
        <source>Both are estimates by sampling, with the standard errors beside them: S can exceed S total by chance.</source>
        <translation>Beide sind durch Stichproben geschätzt, mit den Standardfehlern daneben: S kann S total durch Zufall übersteigen.</translation>
    </message>
    <message>
        <source>Any measurement equation with what is known about its quantities: several results, intermediate definitions, conditions, and equations that are solved in every trial.</source>
        <translation>Jede Messgleichung mit dem, was über ihre Größen bekannt ist: mehrere Ergebnisse, Zwischendefinitionen, Bedingungen und Gleichungen, die in jedem Versuch gelöst werden.</translation>
    </message>
    <message>
        <source>Uncertainty of a measured point</source>
        <translation>Unsicherheit eines gemessenen Punktes</translation>
    </message>
    <message>
        <source>Residuals of the readings</source>
        <translation>Residuen der Ablesungen</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Ablesung</translation>
    </message>
    <message>
        <source>u of the reading</source>
        <translation>u der Ablesung</translation>
    </message>
    <message>
        <source>redundancy</source>
        <translation>Redundanz</translation>
    </message>
    <message>
        <source>remark</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>Fit of the measured points to their nominal coordinates</source>
        <translation>Anpassung der gemessenen Punkte an ihre Nennkoordinaten</translation>
    </message>
    <message>
        <source>root mean square residual</source>
        <translation>quadratischer Mittelwert der Residuen</translation>
    </message>
    <message>
        <source>chi-square</source>
        <translation>Chi-Quadrat</translation>
    </message>
    <message>
        <source>largest normalised residual</source>
        <translation>größtes normiertes Residuum</translation>
    </message>
    <message>
        <source>of</source>
        <translation>von</translation>
    </message>
    <message>
        <source>Residuals of the points, along the axes of their frame</source>
        <translation>Residuen der Punkte, längs der Achsen ihres Systems</translation>
    </message>
    <message>
        <source>residual x</source>
        <translation>Residuum x</translation>
    </message>
    <message>
        <source>residual y</source>
        <translation>Residuum y</translation>
    </message>
    <message>
        <source>residual z</source>
        <translation>Residuum z</translation>
    </message>
    <message>
        <source>redundancy x</source>
        <translation>Redundanz x</translation>
    </message>
    <message>
        <source>redundancy y</source>
        <translation>Redundanz y</translation>
    </message>
    <message>
        <source>redundancy z</source>
        <translation>Redundanz z</translation>
    </message>
    <message>
        <source>present series</source>
        <translation>jetzige Reihe</translation>
    </message>
    <message>
        <source>also reached at x</source>
        <translation>auch erreicht bei x</translation>
    </message>
    <message>
        <source>a kept state</source>
        <translation>ein gemerkter Stand</translation>
    </message>
    <message>
        <source>two states of the analysis %1 are kept; one can be</source>
        <translation>von der Analyse %1 sind zwei Stände gemerkt; einer kann es sein</translation>
    </message>
    <message>
        <source>&apos;digits&apos; must be a whole number from %1 to %2 (JCGM 100 7.2.6)</source>
        <translation>&apos;digits&apos; muss eine ganze Zahl von %1 bis %2 sein (JCGM 100 7.2.6)</translation>
    </message>
    <message>
        <source>the model cannot be evaluated</source>
        <translation>das Modell kann nicht ausgewertet werden</translation>
    </message>
    <message>
        <source>there is no output quantity &apos;%1&apos; here</source>
        <translation>hier gibt es keine Ausgangsgröße &apos;%1&apos;</translation>
    </message>
    <message>
        <source>from the present values</source>
        <translation>von den jetzigen Werten aus</translation>
    </message>
    <message>
        <source>global search</source>
        <translation>globale Suche</translation>
    </message>
    <message>
        <source>start %1</source>
        <translation>Start %1</translation>
    </message>
    <message>
        <source>a target uncertainty is not met</source>
        <translation>eine Zielunsicherheit wird nicht eingehalten</translation>
    </message>
    <message>
        <source>there is no output quantity &apos;%1&apos; then</source>
        <translation>dann gibt es keine Ausgangsgröße &apos;%1&apos;</translation>
    </message>
    <message>
        <source>an uncertainty has no finite value</source>
        <translation>eine Unsicherheit hat keinen endlichen Wert</translation>
    </message>
    <message>
        <source>an uncertainty vanishes: the model is degenerate there</source>
        <translation>eine Unsicherheit verschwindet: das Modell ist dort entartet</translation>
    </message>
    <message>
        <source>all choices</source>
        <translation>alle Auswahlen</translation>
    </message>
    <message>
        <source>greedy</source>
        <translation>schrittweise</translation>
    </message>
    <message>
        <source>backward elimination</source>
        <translation>Rückwärtselimination</translation>
    </message>
    <message>
        <source>exchange</source>
        <translation>Austausch</translation>
    </message>
    <message>
        <source>%1 and %2 are closer than the least distance</source>
        <translation>%1 und %2 liegen näher als der kleinste Abstand</translation>
    </message>
    <message>
        <source>%1 stands in a box</source>
        <translation>%1 steht in einem Quader</translation>
    </message>
    <message>
        <source>%1 stands in the box &apos;%2&apos;</source>
        <translation>%1 steht im Quader &apos;%2&apos;</translation>
    </message>
    <message>
        <source>the line of sight %1 passes a box</source>
        <translation>die Ziellinie %1 geht durch einen Quader</translation>
    </message>
    <message>
        <source>the line of sight %1 passes the box &apos;%2&apos;</source>
        <translation>die Ziellinie %1 geht durch den Quader &apos;%2&apos;</translation>
    </message>
    <message>
        <source>%1 (row %2)</source>
        <translation>%1 (Zeile %2)</translation>
    </message>
    <message>
        <source>%1: uncertainty too small to be seen</source>
        <translation>%1: Unsicherheit zu klein, um sichtbar zu sein</translation>
    </message>
    <message>
        <source>uncertainty drawn at %1 of %2 points</source>
        <translation>Unsicherheit bei %1 von %2 Punkten gezeichnet</translation>
    </message>
    <message>
        <source>standard deviation known before (Type A)</source>
        <translation>früher bestimmte Standardabweichung (Typ A)</translation>
    </message>
    <message>
        <source>share of the variance, first order</source>
        <translation>Anteil an der Varianz, erste Ordnung</translation>
    </message>
    <message>
        <source>change, relative to the variance before</source>
        <translation>Änderung, bezogen auf die vorherige Varianz</translation>
    </message>
    <message>
        <source>growth of the objective without it</source>
        <translation>Zuwachs der Zielgröße ohne sie</translation>
    </message>
    <message>
        <source>the number of observations in the mean must be at least one</source>
        <translation>die Anzahl der Beobachtungen im Mittelwert muss mindestens eins sein</translation>
    </message>
    <message>
        <source>results: in the frame of the sensor</source>
        <translation>Ergebnisse: im Koordinatensystem des Sensors</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>net reading</source>
        <translation>Nettoablesung</translation>
    </message>
    <message>
        <source>deviation from the line</source>
        <translation>Abweichung von der Geraden</translation>
    </message>
    <message>
        <source>Design: twelve points of a ballbar measurement</source>
        <translation>Entwurf: zwölf Punkte einer Kugelstab-Messung</translation>
    </message>
    <message>
        <source>Tool centre point of a robot by telescopic ballbars</source>
        <translation>Werkzeugmittelpunkt eines Roboters mit teleskopischen Kugelstäben</translation>
    </message>
    <message>
        <source>From the certificate of a scale bar to the tool of a robot</source>
        <translation>Vom Kalibrierschein eines Maßstabs zum Werkzeug eines Roboters</translation>
    </message>
    <message>
        <source>Industrial robot ER10L-C10</source>
        <translation>Industrieroboter ER10L-C10</translation>
    </message>
    <message>
        <source>Six-axis force/moment sensor</source>
        <translation>Sechsachsiger Kraft-/Momentensensor</translation>
    </message>
    <message>
        <source>Scale bar in a network of three cameras and a laser tracker</source>
        <translation>Maßstab in einem Netz aus drei Kameras und einem Lasertracker</translation>
    </message>
    <message>
        <source>Stewart platform measured with a total station</source>
        <translation>Stewart-Plattform, mit einer Totalstation gemessen</translation>
    </message>
    <message>
        <source>Pose of a Stewart platform measured by a network</source>
        <translation>Pose einer Stewart-Plattform, von einem Netz gemessen</translation>
    </message>
    <message>
        <source>End-gauge calibration (GUM H.1)</source>
        <translation>Kalibrierung eines Endmaßes (GUM H.1)</translation>
    </message>
    <message>
        <source>Simultaneous resistance and reactance (GUM H.2)</source>
        <translation>Wirk- und Blindwiderstand, zugleich gemessen (GUM H.2)</translation>
    </message>
    <message>
        <source>Calibration of a thermometer (GUM H.3)</source>
        <translation>Kalibrierung eines Thermometers (GUM H.3)</translation>
    </message>
    <message>
        <source>Zener voltage standard on ten days (GUM H.5)</source>
        <translation>Zener-Spannungsnormal an zehn Tagen (GUM H.5)</translation>
    </message>
    <message>
        <source>JCGM 100:2008, Annex H.5, Table H.9: five observations on each of ten days, and the analysis of variance that says whether the days have an effect.</source>
        <translation>JCGM 100:2008, Anhang H.5, Tabelle H.9: fünf Beobachtungen an jedem von zehn Tagen und die Varianzanalyse, die sagt, ob die Tage einen Einfluss haben.</translation>
    </message>
    <message>
        <source>Additive model (GUM Supplement 1, 9.2)</source>
        <translation>Additives Modell (GUM-Supplement 1, 9.2)</translation>
    </message>
    <message>
        <source>JCGM 101:2008, clause 9.2: a sum of four quantities with three choices of their distributions, and the validation of clause 8.</source>
        <translation>JCGM 101:2008, Abschnitt 9.2: eine Summe von vier Größen mit dreierlei Verteilungen, und die Validierung nach Abschnitt 8.</translation>
    </message>
    <message>
        <source>Mass calibration (GUM Supplement 1, 9.3)</source>
        <translation>Massekalibrierung (GUM-Supplement 1, 9.3)</translation>
    </message>
    <message>
        <source>JCGM 101:2008, clause 9.3: a weight of 100 g is compared with a reference weight in air; to first order the densities seem not to matter.</source>
        <translation>JCGM 101:2008, Abschnitt 9.3: ein Gewicht von 100 g wird in Luft mit einem Referenzgewicht verglichen; in erster Ordnung scheinen die Dichten keine Rolle zu spielen.</translation>
    </message>
    <message>
        <source>Comparison loss of a power meter (GUM Supplement 1, 9.4)</source>
        <translation>Vergleichsverlust eines Leistungsmessers (GUM-Supplement 1, 9.4)</translation>
    </message>
    <message>
        <source>JCGM 101:2008, clause 9.4, Tables 8 and 9: a sum of two squares near zero, where the law of propagation fails.</source>
        <translation>JCGM 101:2008, Abschnitt 9.4, Tabellen 8 und 9: eine Summe zweier Quadrate nahe null, bei der das Fortpflanzungsgesetz versagt.</translation>
    </message>
    <message>
        <source>Gauge-block calibration (GUM Supplement 1, 9.5)</source>
        <translation>Kalibrierung eines Parallelendmaßes (GUM-Supplement 1, 9.5)</translation>
    </message>
    <message>
        <source>JCGM 101:2008, clause 9.5: the end gauge of GUM H.1 with the distributions of Table 10.</source>
        <translation>JCGM 101:2008, Abschnitt 9.5: das Endmaß aus GUM H.1 mit den Verteilungen der Tabelle 10.</translation>
    </message>
    <message>
        <source>Two sums with a common term (GUM Supplement 2, 9.2)</source>
        <translation>Zwei Summen mit gemeinsamem Glied (GUM-Supplement 2, 9.2)</translation>
    </message>
    <message>
        <source>JCGM 102:2011, clause 9.2: a bivariate additive model with standard normal quantities.</source>
        <translation>JCGM 102:2011, Abschnitt 9.2: ein bivariates additives Modell mit standardnormalverteilten Größen.</translation>
    </message>
    <message>
        <source>Cartesian to polar co-ordinates (GUM Supplement 2, 9.3)</source>
        <translation>Von kartesischen zu Polarkoordinaten (GUM-Supplement 2, 9.3)</translation>
    </message>
    <message>
        <source>JCGM 102:2011, clause 9.3, Tables 6 and 7: magnitude and phase of a small complex quantity.</source>
        <translation>JCGM 102:2011, Abschnitt 9.3, Tabellen 6 und 7: Betrag und Phase einer kleinen komplexen Größe.</translation>
    </message>
    <message>
        <source>Resistance and reactance by Monte Carlo (GUM Supplement 2, 9.4)</source>
        <translation>Wirk- und Blindwiderstand mit Monte Carlo (GUM-Supplement 2, 9.4)</translation>
    </message>
    <message>
        <source>JCGM 102:2011, clause 9.4: the impedance of GUM H.2 with trivariate normal input quantities and the joint coverage region of R and X.</source>
        <translation>JCGM 102:2011, Abschnitt 9.4: die Impedanz aus GUM H.2 mit trivariat normalverteilten Eingangsgrößen und dem gemeinsamen Überdeckungsbereich von R und X.</translation>
    </message>
    <message>
        <source>JCGM 100:2008, Annex H.1: a gauge block of 50 mm is compared with a standard; first- and second-order law of propagation.</source>
        <translation>JCGM 100:2008, Anhang H.1: ein Endmaß von 50 mm wird mit einem Normal verglichen; Fortpflanzungsgesetz erster und zweiter Ordnung.</translation>
    </message>
    <message>
        <source>JCGM 100:2008, Annex H.2: five simultaneous observations of voltage, current and phase give three correlated results.</source>
        <translation>JCGM 100:2008, Anhang H.2: fünf gleichzeitige Beobachtungen von Spannung, Strom und Phase ergeben drei korrelierte Ergebnisse.</translation>
    </message>
    <message>
        <source>JCGM 100:2008, Annex H.3: the correction b of a thermometer at eleven temperatures, and the straight line through them: b(t) = y₁ + y₂ (t − 20 °C).</source>
        <translation>JCGM 100:2008, Anhang H.3: die Korrektion b eines Thermometers bei elf Temperaturen und die Gerade hindurch: b(t) = y₁ + y₂ (t − 20 °C).</translation>
    </message>
    <message>
        <source>Which twelve of the 22 points of a ballbar measurement make the uncertainty of the tool centre point smallest.</source>
        <translation>Welche zwölf der 22 Punkte einer Kugelstab-Messung die Unsicherheit des Werkzeugmittelpunkts am kleinsten machen.</translation>
    </message>
    <message>
        <source>Three telescopic ballbars measure points on spheres and circles; from them follow the flange, its axes and the tool.</source>
        <translation>Drei teleskopische Kugelstäbe messen Punkte auf Kugeln und Kreisen; daraus folgen Flansch, Achsen und Werkzeug.</translation>
    </message>
    <message>
        <source>Scale bar, two trackers, flange, identified arm and tool: analyses that feed each other, evaluated as one model.</source>
        <translation>Maßstab, zwei Tracker, Flansch, identifizierter Arm und Werkzeug: Analysen, die einander speisen, als ein Modell ausgewertet.</translation>
    </message>
    <message>
        <source>Parameters of an arm of six axes, identified from measured places, and the position of its end effector.</source>
        <translation>Parameter eines Arms mit sechs Achsen, aus gemessenen Orten identifiziert, und die Position seines Endeffektors.</translation>
    </message>
    <message>
        <source>Rated output, zero, repeatability and interference of three forces and three moments.</source>
        <translation>Nennkennwert, Nullpunkt, Wiederholbarkeit und Übersprechen von drei Kräften und drei Momenten.</translation>
    </message>
    <message>
        <source>Distances on a scale bar that three cameras and a laser tracker measure together.</source>
        <translation>Abstände auf einem Maßstab, den drei Kameras und ein Lasertracker gemeinsam messen.</translation>
    </message>
    <message>
        <source>Pose of a platform from six measured points, whose uncertainties come from calibrated artefacts.</source>
        <translation>Pose einer Plattform aus sechs gemessenen Punkten, deren Unsicherheiten von kalibrierten Prüfkörpern kommen.</translation>
    </message>
    <message>
        <source>Sensor layout, points and pose in one chain: a laser tracker and a total station measure six nests of a platform.</source>
        <translation>Sensoranordnung, Punkte und Pose in einer Kette: ein Lasertracker und eine Totalstation messen sechs Aufnahmen einer Plattform.</translation>
    </message>
    <message>
        <source>%1 in line %2</source>
        <translation>%1 in Zeile %2</translation>
    </message>
    <message>
        <source>columns between tabs</source>
        <translation>Spalten zwischen Tabulatoren</translation>
    </message>
    <message>
        <source>columns between semicolons</source>
        <translation>Spalten zwischen Semikolons</translation>
    </message>
    <message>
        <source>columns between commas</source>
        <translation>Spalten zwischen Kommas</translation>
    </message>
    <message>
        <source>columns between blanks, decimal commas</source>
        <translation>Spalten zwischen Leerzeichen, Dezimalkommas</translation>
    </message>
    <message>
        <source>columns between blanks</source>
        <translation>Spalten zwischen Leerzeichen</translation>
    </message>
    <message>
        <source>all %1 met</source>
        <translation>alle %1 erfüllt</translation>
    </message>
    <message>
        <source>%1 of %2 not met</source>
        <translation>%1 von %2 nicht erfüllt</translation>
    </message>
    <message>
        <source>Requirements</source>
        <translation>Anforderungen</translation>
    </message>
    <message>
        <source>Requirements: %1</source>
        <translation>Anforderungen: %1</translation>
    </message>
    <message>
        <source>min Σ w (reading − h(X))²</source>
        <translation>min Σ w (Ablesung − h(X))²</translation>
    </message>
    <message>
        <source>least squares: R maximises tr(Rᵀ Σ (q_i − q̄) l_iᵀ),  o = q̄ − R l̄</source>
        <translation>kleinste Quadrate: R maximiert tr(Rᵀ Σ (q_i − q̄) l_iᵀ),  o = q̄ − R l̄</translation>
    </message>
    <message>
        <source>Z = ± √(L₁² − X² − Y²);  no value where the root is negative</source>
        <translation>Z = ± √(L₁² − X² − Y²);  kein Wert, wo die Wurzel negativ ist</translation>
    </message>
    <message>
        <source>min Σ w (L_j − |M − KS_j|)², Gauss-Newton from Eqs 1-3</source>
        <translation>min Σ w (L_j − |M − KS_j|)², Gauß-Newton ab Gln. 1-3</translation>
    </message>
    <message>
        <source>L_j = |P_i + e_i + R_i (ω_i × t) − KS_j| + reading&apos;s deviation</source>
        <translation>L_j = |P_i + e_i + R_i (ω_i × t) − KS_j| + Abweichung der Ablesung</translation>
    </message>
    <message>
        <source>n_x, n_y: planes of the arcs by total least squares;  C: sphere through all points</source>
        <translation>n_x, n_y: Ebenen der Bögen mit totalen kleinsten Quadraten;  C: Kugel durch alle Punkte</translation>
    </message>
    <message>
        <source>TCP = mean of Rot_iᵀ Fᵀ (M_i − C)</source>
        <translation>TCP = Mittel von Rot_iᵀ Fᵀ (M_i − C)</translation>
    </message>
    <message>
        <source>JCGM 102 6.2, with all that points and readings share</source>
        <translation>JCGM 102 6.2, mit allem, was Punkte und Ablesungen teilen</translation>
    </message>
    <message>
        <source>n·p = D with |n| = 1, least sum of squares</source>
        <translation>n·p = D mit |n| = 1, kleinste Quadratsumme</translation>
    </message>
    <message>
        <source>min Σ (|p_j − c| − R)²  in the fitted plane</source>
        <translation>min Σ (|p_j − c| − R)²  in der angepassten Ebene</translation>
    </message>
    <message>
        <source>x_i = ± z_{i−1} × z_i/|…|,  O_i: foot of the common perpendicular on axis i + 1</source>
        <translation>x_i = ± z_{i−1} × z_i/|…|,  O_i: Fußpunkt des gemeinsamen Lots auf Achse i + 1</translation>
    </message>
    <message>
        <source>parallel: O_i in the plane through O_{i−1} normal to z_{i−1},  y_i = z_i × h/|…|,  x_i = y_i × z_i</source>
        <translation>parallel: O_i in der Ebene durch O_{i−1} senkrecht zu z_{i−1},  y_i = z_i × h/|…|,  x_i = y_i × z_i</translation>
    </message>
    <message>
        <source>S_hc = Σ L d_h/Σ L²  over the increasing readings under load c</source>
        <translation>S_hc = Σ L d_h/Σ L²  über die steigenden Ablesungen unter der Last c</translation>
    </message>
    <message>
        <source>V = S L,  L = C V  with  C = S⁻¹</source>
        <translation>V = S L,  L = C V  mit  C = S⁻¹</translation>
    </message>
    <message>
        <source>V_h = Σ_c (S_hc L_c + Q_hc L_c²),  by Newton&apos;s method from L = C V</source>
        <translation>V_h = Σ_c (S_hc L_c + Q_hc L_c²),  mit dem Newton-Verfahren ab L = C V</translation>
    </message>
    <message>
        <source>V_h = d_h + repeatability + resolution + non-zero + hysteresis</source>
        <translation>V_h = d_h + Wiederholpräzision + Auflösung + Nullpunktabweichung + Hysterese</translation>
    </message>
    <message>
        <source>S_hc = fitted + regression + S_hc δ_c</source>
        <translation>S_hc = angepasster Wert + Regression + S_hc δ_c</translation>
    </message>
    <message>
        <source>d_hij = d′_hij − d_h0j,  d_hi = mean over j,  s_hi,  u_A = max s_hi/√n</source>
        <translation>d_hij = d′_hij − d_h0j,  d_hi = Mittel über j,  s_hi,  u_A = max s_hi/√n</translation>
    </message>
    <message>
        <source>JCGM 100, Eq 1</source>
        <translation>JCGM 100, Gl. 1</translation>
    </message>
    <message>
        <source>JCGM 100, Eqs H.24, H.25, for groups of any size</source>
        <translation>JCGM 100, Gln. H.24, H.25, für Gruppen jeder Größe</translation>
    </message>
    <message>
        <source>groups included, JCGM 100 H.5.2.3</source>
        <translation>Gruppen einbezogen, JCGM 100 H.5.2.3</translation>
    </message>
    <message>
        <source>components of variance, Searle et al. 1992</source>
        <translation>Varianzkomponenten, Searle et al. 1992</translation>
    </message>
    <message>
        <source>groups not included, JCGM 100, Eq H.28</source>
        <translation>Gruppen nicht einbezogen, JCGM 100, Gl. H.28</translation>
    </message>
    <message>
        <source>JCGM 100, Eq H.12</source>
        <translation>JCGM 100, Gl. H.12</translation>
    </message>
    <message>
        <source>from the residuals, JCGM 100 H.3.2</source>
        <translation>aus den Residuen, JCGM 100 H.3.2</translation>
    </message>
    <message>
        <source>as stated, York et al. 2004</source>
        <translation>wie angegeben, York et al. 2004</translation>
    </message>
    <message>
        <source>it must be an analysis of the kept state and have a name (otherName)</source>
        <translation>es muss eine Analyse des gemerkten Stands sein und einen Namen haben (otherName)</translation>
    </message>
    <message>
        <source>Dimensions are checked where the equations are read; plane angle counts as a number, because the radian is one in the SI. A temperature in °C is taken in kelvin only where two make a ratio; a difference of temperatures is given in K.</source>
        <translation>Dimensionen werden geprüft, wo die Gleichungen gelesen werden; ebene Winkel zählen als Zahl, weil der Radiant im SI eine ist. Eine Temperatur in °C wird nur dort in Kelvin genommen, wo zwei ein Verhältnis bilden; eine Temperaturdifferenz wird in K angegeben.</translation>
    </message>
    <message>
        <source>Angles that inverse functions give or that were read, their sums and whole multiples are on the circle where the result is given in a unit of angle.</source>
        <translation>Winkel, die Umkehrfunktionen ergeben oder die abgelesen wurden, ihre Summen und ganzen Vielfachen liegen auf dem Kreis, wenn das Ergebnis in einer Winkeleinheit angegeben ist.</translation>
    </message>
    <message>
        <source>One equation a line: y = x_1*x_2 + x_3. Names without an equation are input quantities; a number has its unit in brackets: 3 [mm]. &apos;solve y = 1: y^2 = x&apos; finds y in every trial, from its starting value. complex(a, b) and polar(r, phi) make complex numbers, re, im, abs and arg real ones of them. &apos;#&apos; starts a comment.</source>
        <translation>Eine Gleichung je Zeile: y = x_1*x_2 + x_3. Namen ohne Gleichung sind Eingangsgrößen; eine Zahl hat ihre Einheit in Klammern: 3 [mm]. &apos;solve y = 1: y^2 = x&apos; findet y in jedem Versuch, ausgehend von seinem Startwert. complex(a, b) und polar(r, phi) bilden komplexe Zahlen, re, im, abs und arg reelle aus ihnen. &apos;#&apos; beginnt einen Kommentar.</translation>
    </message>
    <message>
        <source>How its uncertainty is known; a and b are then: u; s and n; U and k; U and p in %; half-width (and inexactness, or ratio of top to base); lower and upper limit; step of the indication; permissible error and % of the value; number of counts; number of observations in the mean (pooled); standard deviation (Laplace, Weibull about the value), scale (and shape); expected number of events; number of trials and probability in %. A sample is drawn as it is listed among the observations, a histogram has the edges of its cells there. Empty: a constant.</source>
        <translation>Wie ihre Unsicherheit bekannt ist; a und b sind dann: u; s und n; U und k; U und p in %; Halbweite (und Unschärfe der Grenzen oder Verhältnis von oben zu unten); untere und obere Grenze; Ziffernschritt der Anzeige; Fehlergrenze und % des Werts; Zahl der Ereignisse; Zahl der Beobachtungen im Mittelwert (gepoolt); Standardabweichung (Laplace, Weibull um den Wert), Skala (und Form); erwartete Zahl der Ereignisse; Zahl der Versuche und Wahrscheinlichkeit in %. Eine Stichprobe wird gezogen, wie sie unter den Beobachtungen steht, ein Histogramm hat dort die Kanten seiner Zellen. Leer: eine Konstante.</translation>
    </message>
    <message>
        <source>Laplace, standard deviation</source>
        <translation>Laplace, Standardabweichung</translation>
    </message>
    <message>
        <source>Laplace, scale</source>
        <translation>Laplace, Skala</translation>
    </message>
    <message>
        <source>Weibull, scale and shape</source>
        <translation>Weibull, Skala und Form</translation>
    </message>
    <message>
        <source>Weibull, standard deviation</source>
        <translation>Weibull, Standardabweichung</translation>
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
        <translation>Stichprobe von Werten</translation>
    </message>
    <message>
        <source>histogram</source>
        <translation>Histogramm</translation>
    </message>
    <message>
        <source>ensemble</source>
        <translation>Ensemble</translation>
    </message>
    <message>
        <source>Name of the evaluation that gave several quantities together, with one and the same nu: their uncertainties rest on one estimate of variance, and they are drawn from a multivariate t distribution (JCGM 102 5.3.2). Correlation coefficients between them stand with the correlations of the analysis.</source>
        <translation>Name der Auswertung, die mehrere Größen zusammen ergab, mit ein und demselben nu: ihre Unsicherheiten beruhen auf einer Schätzung der Varianz, und sie werden aus einer multivariaten t-Verteilung gezogen (JCGM 102 5.3.2). Korrelationskoeffizienten zwischen ihnen stehen bei den Korrelationen der Analyse.</translation>
    </message>
    <message>
        <source>Observed value, value of a sample or edge of a histogram, in the unit of the quantity.</source>
        <translation>Beobachteter Wert, Wert einer Stichprobe oder Kante eines Histogramms, in der Einheit der Größe.</translation>
    </message>
    <message>
        <source>weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Of a value of a sample, or of the cell of a histogram that begins at this edge: counts, or parts of any sum. Empty: one in a sample, none behind the last edge.</source>
        <translation>Von einem Wert einer Stichprobe oder der Zelle eines Histogramms, die an dieser Kante beginnt: Anzahlen oder Teile einer beliebigen Summe. Leer: eins in einer Stichprobe, keines hinter der letzten Kante.</translation>
    </message>
    <message>
        <source>Covariance of the points</source>
        <translation>Kovarianz der Punkte</translation>
    </message>
    <message>
        <source>Common u of x</source>
        <translation>Gemeinsames u von x</translation>
    </message>
    <message>
        <source>Standard uncertainty of a deviation that all x share beside their own (one standard, one temperature), in the unit of x. Used with stated uncertainties, in the weights too.</source>
        <translation>Standardunsicherheit einer Abweichung, die alle x neben ihrer eigenen teilen (ein Normal, eine Temperatur), in der Einheit von x. Verwendet mit angegebenen Unsicherheiten, auch in den Gewichten.</translation>
    </message>
    <message>
        <source>Common u of y</source>
        <translation>Gemeinsames u von y</translation>
    </message>
    <message>
        <source>Likewise of all y, in the unit of y.</source>
        <translation>Ebenso von allen y, in der Einheit von y.</translation>
    </message>
    <message>
        <source>Correlations of the points</source>
        <translation>Korrelationen der Punkte</translation>
    </message>
    <message>
        <source>Correlation coefficients between coordinates of the points (ISO/TS 28037): they change the curve, which minimises v^T V^-1 v, and its uncertainty. Used with stated uncertainties.</source>
        <translation>Korrelationskoeffizienten zwischen Koordinaten der Punkte (ISO/TS 28037): sie ändern die Kurve, die v^T V^-1 v minimiert, und ihre Unsicherheit. Verwendet mit angegebenen Unsicherheiten.</translation>
    </message>
    <message>
        <source>A coordinate of a point by its number: y_1 is the y of the first point.</source>
        <translation>Eine Koordinate eines Punkts durch seine Nummer: y_1 ist das y des ersten Punkts.</translation>
    </message>
    <message>
        <source>Another one: y_2, or the x_1 of the same point.</source>
        <translation>Eine andere: y_2 oder das x_1 desselben Punkts.</translation>
    </message>
    <message>
        <source>coefficient</source>
        <translation>Koeffizient</translation>
    </message>
    <message>
        <source>Correlation coefficient of their stated uncertainties.</source>
        <translation>Korrelationskoeffizient ihrer angegebenen Unsicherheiten.</translation>
    </message>
    <message>
        <source>Certificate of a gauge block of 50 mm</source>
        <translation>Kalibrierschein eines Endmaßes von 50 mm</translation>
    </message>
    <message>
        <source>A gauge block is compared with a standard of the same length, by the model of EA-4/02, S4; its certificate says all that ISO/IEC 17025 7.8 asks for.</source>
        <translation>Ein Endmaß wird mit einem Normal gleicher Länge verglichen, nach dem Modell von EA-4/02, S4; sein Kalibrierschein sagt alles, was ISO/IEC 17025 7.8 verlangt.</translation>
    </message>
    <message>
        <source>Conformity of a micrometer</source>
        <translation>Konformität einer Messschraube</translation>
    </message>
    <message>
        <source>Errors of indication of a micrometer of 25 mm at four gauge blocks, and whether they conform with a maximum permissible error of 4 µm under the decision rule of ISO 14253-1.</source>
        <translation>Anzeigeabweichungen einer Messschraube von 25 mm an vier Endmaßen, und ob sie mit einer Fehlergrenze von 4 µm nach der Entscheidungsregel der ISO 14253-1 konform sind.</translation>
    </message>
    <message>
        <source>A budget from Excel</source>
        <translation>Ein Budget aus Excel</translation>
    </message>
    <message>
        <source>What &apos;covaria import excel-budget.xlsx&apos; makes of a budget in a spreadsheet, with the columns of EA-4/02.</source>
        <translation>Was &apos;covaria import excel-budget.xlsx&apos; aus einem Budget in einer Tabelle macht, mit den Spalten von EA-4/02.</translation>
    </message>
    <message>
        <source>Gewichtsstück von 10 kg</source>
        <translation>Gewichtsstück von 10 kg</translation>
    </message>
    <message>
        <source>Kalibrierung eines Gewichtsstücks nach EA-4/02, S2: ein Beispiel in deutscher Sprache, mit vollständigem Kalibrierschein.</source>
        <translation>Kalibrierung eines Gewichtsstücks nach EA-4/02, S2: ein Beispiel in deutscher Sprache, mit vollständigem Kalibrierschein.</translation>
    </message>
    <message>
        <source>Guard band</source>
        <translation>Sicherheitsband</translation>
    </message>
    <message>
        <source>How the guard band follows: by the guard factor, by the ratio TUR of tolerance and U (both limits are needed), or so narrow as a target risk allows (global risks need a prior).</source>
        <translation>Wie das Sicherheitsband folgt: aus dem Sicherheitsfaktor, aus dem Verhältnis TUR von Toleranz und U (beide Grenzen werden gebraucht), oder so schmal, wie ein Zielrisiko es erlaubt (globale Risiken brauchen eine Vorkenntnis).</translation>
    </message>
    <message>
        <source>Target risk</source>
        <translation>Zielrisiko</translation>
    </message>
    <message>
        <source>That the guard band is made for, above 0 and up to 0.5: 0.02 or 2 %.</source>
        <translation>Für das das Sicherheitsband gemacht ist, über 0 und bis 0.5: 0.02 oder 2 %.</translation>
    </message>
    <message>
        <source>guard factor times U</source>
        <translation>Sicherheitsfaktor mal U</translation>
    </message>
    <message>
        <source>RSS: root of T²/4 − U²</source>
        <translation>RSS: Wurzel aus T²/4 − U²</translation>
    </message>
    <message>
        <source>NCSL RP-10: 1.25 − 1/TUR</source>
        <translation>NCSL RP-10: 1.25 − 1/TUR</translation>
    </message>
    <message>
        <source>managed (Dobbert): at most 2 % false accepts</source>
        <translation>gesteuert (Dobbert): höchstens 2 % falsch angenommene</translation>
    </message>
    <message>
        <source>to a specific risk at the acceptance limit</source>
        <translation>auf ein spezifisches Risiko an der Annahmegrenze</translation>
    </message>
    <message>
        <source>to a global consumer&apos;s risk</source>
        <translation>auf ein globales Kundenrisiko</translation>
    </message>
    <message>
        <source>to a risk of what is accepted</source>
        <translation>auf ein Risiko des Angenommenen</translation>
    </message>
    <message>
        <source>Site of calibration</source>
        <translation>Ort der Kalibrierung</translation>
    </message>
    <message>
        <source>Whose place it was done at; empty: in the laboratory, or elsewhere where a place is stated.</source>
        <translation>Bei wem sie ausgeführt wurde; leer: im Laboratorium, oder anderswo, wenn ein Ort angegeben ist.</translation>
    </message>
    <message>
        <source>Where it was done if not in the laboratory: the customer&apos;s hall, the field.</source>
        <translation>Wo sie ausgeführt wurde, wenn nicht im Laboratorium: die Halle des Kunden, das Feld.</translation>
    </message>
    <message>
        <source>To which a statement of conformity refers: the standard or drawing, with its edition.</source>
        <translation>Worauf sich eine Konformitätsaussage bezieht: die Norm oder Zeichnung, mit ihrer Ausgabe.</translation>
    </message>
    <message>
        <source>at the customer</source>
        <translation>beim Kunden</translation>
    </message>
    <message>
        <source>in a branch of the laboratory</source>
        <translation>in einer Zweigstelle des Laboratoriums</translation>
    </message>
    <message>
        <source>in a branch of the customer</source>
        <translation>in einer Zweigstelle des Kunden</translation>
    </message>
    <message>
        <source>elsewhere</source>
        <translation>anderswo</translation>
    </message>
    <message>
        <source>RSS guard band</source>
        <translation>Sicherheitsband RSS</translation>
    </message>
    <message>
        <source>NCSL RP-10 guard band</source>
        <translation>Sicherheitsband NCSL RP-10</translation>
    </message>
    <message>
        <source>managed guard band (Dobbert, 2 % false accepts)</source>
        <translation>gesteuertes Sicherheitsband (Dobbert, 2 % falsch angenommene)</translation>
    </message>
    <message>
        <source>guard band to a specific risk of %1</source>
        <translation>Sicherheitsband auf ein spezifisches Risiko von %1</translation>
    </message>
    <message>
        <source>guard band to a global consumer&apos;s risk of %1</source>
        <translation>Sicherheitsband auf ein globales Kundenrisiko von %1</translation>
    </message>
    <message>
        <source>guard band to a risk of %1 of what is accepted</source>
        <translation>Sicherheitsband auf ein Risiko von %1 des Angenommenen</translation>
    </message>
    <message>
        <source>pass (accepted)</source>
        <translation>bestanden (angenommen)</translation>
    </message>
    <message>
        <source>fail (rejected)</source>
        <translation>nicht bestanden (zurückgewiesen)</translation>
    </message>
    <message>
        <source>January</source>
        <translation>Januar</translation>
    </message>
    <message>
        <source>February</source>
        <translation>Februar</translation>
    </message>
    <message>
        <source>March</source>
        <translation>März</translation>
    </message>
    <message>
        <source>April</source>
        <translation>April</translation>
    </message>
    <message>
        <source>May</source>
        <translation>Mai</translation>
    </message>
    <message>
        <source>June</source>
        <translation>Juni</translation>
    </message>
    <message>
        <source>July</source>
        <translation>Juli</translation>
    </message>
    <message>
        <source>August</source>
        <translation>August</translation>
    </message>
    <message>
        <source>September</source>
        <translation>September</translation>
    </message>
    <message>
        <source>October</source>
        <translation>Oktober</translation>
    </message>
    <message>
        <source>November</source>
        <translation>November</translation>
    </message>
    <message>
        <source>December</source>
        <translation>Dezember</translation>
    </message>
    <message>
        <source>%1 %2 %3</source>
        <translation>%1. %2 %3</translation>
    </message>
    <message>
        <source>required by %1 where conformity is stated</source>
        <translation>verlangt von %1, wo Konformität ausgesagt wird</translation>
    </message>
    <message>
        <source>%1 is the unit of a temperature, and the quantity is given in %2, in which it may be a difference: give both in %1, or both in %2</source>
        <translation>%1 ist die Einheit einer Temperatur, und die Größe ist in %2 angegeben, worin sie eine Differenz sein kann: geben Sie beide in %1 oder beide in %2 an</translation>
    </message>
    <message>
        <source>%1 is a temperature in degC, and here it would be taken in kelvin (20 degC as 293.15 K): if it is a difference, give it in K; for its reading in degC write (%2 - 0 [degC]). Only the ratio of two temperatures in degC is taken in kelvin</source>
        <translation>%1 ist eine Temperatur in degC und würde hier in Kelvin genommen (20 degC als 293.15 K): ist sie eine Differenz, geben Sie sie in K an; für ihre Ablesung in degC schreiben Sie (%2 - 0 [degC]). Nur das Verhältnis zweier Temperaturen in degC wird in Kelvin genommen</translation>
    </message>
    <message>
        <source>%1 is a multiple of a temperature in degC, which depends on where the scale has its zero: if the temperature is a difference, give it in K; else multiply its reading, as in 1.5*(t - 0 [degC])</source>
        <translation>%1 ist ein Vielfaches einer Temperatur in degC, das davon abhängt, wo die Skala ihren Nullpunkt hat: ist die Temperatur eine Differenz, geben Sie sie in K an; sonst multiplizieren Sie ihre Ablesung, wie in 1.5*(t - 0 [degC])</translation>
    </message>
    <message>
        <source>a part (%, ppm) or multiple of a temperature in %1 depends on where the scale has its zero: give the figure in K</source>
        <translation>ein Teil (%, ppm) oder Vielfaches einer Temperatur in %1 hängt davon ab, wo die Skala ihren Nullpunkt hat: geben Sie die Zahl in K an</translation>
    </message>
    <message>
        <source>%1 is a difference of temperatures, and %2 a temperature in %3: take a temperature, or give %2 in K</source>
        <translation>%1 ist eine Temperaturdifferenz, und %2 eine Temperatur in %3: nehmen Sie eine Temperatur, oder geben Sie %2 in K an</translation>
    </message>
    <message>
        <source>%1 is given in %2, which may be a difference of temperatures, and %3 is a temperature in %4: give both in %4, or both in K</source>
        <translation>%1 ist in %2 angegeben, was eine Temperaturdifferenz sein kann, und %3 ist eine Temperatur in %4: geben Sie beide in %4 oder beide in K an</translation>
    </message>
    <message>
        <source>%1 is a temperature in %2, and %3 is given in %4, which may be a difference of temperatures: give both in %2, or both in K</source>
        <translation>%1 ist eine Temperatur in %2, und %3 ist in %4 angegeben, was eine Temperaturdifferenz sein kann: geben Sie beide in %2 oder beide in K an</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is complex, so that &apos;%2&apos; is a part of it: to use a part write re(%1) or im(%1), else choose another name</source>
        <translation>&apos;%1&apos; ist komplex, so dass &apos;%2&apos; ein Teil davon ist: um einen Teil zu verwenden, schreiben Sie re(%1) oder im(%1), sonst wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>a complex unknown counts twice, and so does a complex equation: there are %1 real unknowns and %2 real equations</source>
        <translation>eine komplexe Unbekannte zählt doppelt, ebenso eine komplexe Gleichung: es sind %1 reelle Unbekannte und %2 reelle Gleichungen</translation>
    </message>
    <message>
        <source>modulus and argument</source>
        <translation>Betrag und Argument</translation>
    </message>
    <message>
        <source>real and imaginary part</source>
        <translation>Real- und Imaginärteil</translation>
    </message>
    <message>
        <source>%1 of a complex number are real; one of them is complex here</source>
        <translation>%1 einer komplexen Zahl sind reell; einer davon ist hier komplex</translation>
    </message>
    <message>
        <source>complex numbers have no order and are no condition: compare re, im, abs or arg of them</source>
        <translation>komplexe Zahlen haben keine Ordnung und sind keine Bedingung: vergleichen Sie re, im, abs oder arg von ihnen</translation>
    </message>
    <message>
        <source>this function is one of real numbers; for a complex one there are + - * / ^, exp, log, sqrt, sin, cos, tan, sinh, cosh, tanh, conj, abs, arg, re and im</source>
        <translation>diese Funktion ist eine reeller Zahlen; für eine komplexe gibt es + - * / ^, exp, log, sqrt, sin, cos, tan, sinh, cosh, tanh, conj, abs, arg, re und im</translation>
    </message>
    <message>
        <source>%1 unknowns are too many to be solved together: the time for each trial grows with the cube of their number, so the limit is %2; solve what does not depend on the rest in systems of its own</source>
        <translation>%1 Unbekannte sind zu viele, um zusammen gelöst zu werden: die Zeit je Versuch wächst mit der dritten Potenz ihrer Zahl, darum ist die Grenze %2; lösen Sie, was vom Rest nicht abhängt, in eigenen Systemen</translation>
    </message>
    <message>
        <source>the expected number of events gives the estimate: leave the value empty, or the number</source>
        <translation>die erwartete Zahl der Ereignisse ergibt den Schätzwert: lassen Sie den Wert oder die Zahl leer</translation>
    </message>
    <message>
        <source>the expected number of events is missing: state it, or the value</source>
        <translation>die erwartete Zahl der Ereignisse fehlt: geben Sie sie oder den Wert an</translation>
    </message>
    <message>
        <source>trials and probability give the estimate: leave the value empty, or the probability</source>
        <translation>Versuche und Wahrscheinlichkeit ergeben den Schätzwert: lassen Sie den Wert oder die Wahrscheinlichkeit leer</translation>
    </message>
    <message>
        <source>the probability of each trial is missing: state it, or the value</source>
        <translation>die Wahrscheinlichkeit jedes Versuchs fehlt: geben Sie sie oder den Wert an</translation>
    </message>
    <message>
        <source>the number of trials must be at least one</source>
        <translation>die Zahl der Versuche muss mindestens eins sein</translation>
    </message>
    <message>
        <source>the probability of each trial must lie between 0 and 100 %</source>
        <translation>die Wahrscheinlichkeit jedes Versuchs muss zwischen 0 und 100 % liegen</translation>
    </message>
    <message>
        <source>the value must lie between 0 and the number of trials</source>
        <translation>der Wert muss zwischen 0 und der Zahl der Versuche liegen</translation>
    </message>
    <message>
        <source>scale and shape give the estimate: leave the value empty, or state the standard deviation alone</source>
        <translation>Skala und Form ergeben den Schätzwert: lassen Sie den Wert leer, oder geben Sie nur die Standardabweichung an</translation>
    </message>
    <message>
        <source>a Weibull distribution needs a value greater than zero, which is its mean</source>
        <translation>eine Weibull-Verteilung braucht einen Wert größer als null, der ihr Mittelwert ist</translation>
    </message>
    <message>
        <source>no Weibull distribution has such a ratio of standard deviation to mean: it must lie between 0.000002 and 429</source>
        <translation>keine Weibull-Verteilung hat ein solches Verhältnis von Standardabweichung zu Mittelwert: es muss zwischen 0.000002 und 429 liegen</translation>
    </message>
    <message>
        <source>observations have no weights: for values with weights write sample 1; 2; 3 weights 2; 5; 2</source>
        <translation>Beobachtungen haben keine Gewichte: für Werte mit Gewichten schreiben Sie sample 1; 2; 3 weights 2; 5; 2</translation>
    </message>
    <message>
        <source>weights have no unit</source>
        <translation>Gewichte haben keine Einheit</translation>
    </message>
    <message>
        <source>a histogram has one edge more than weights: histogram 0; 1; 2 weights 5; 8</source>
        <translation>ein Histogramm hat eine Kante mehr als Gewichte: histogram 0; 1; 2 weights 5; 8</translation>
    </message>
    <message>
        <source>there must be as many weights as values</source>
        <translation>es muss so viele Gewichte wie Werte geben</translation>
    </message>
    <message>
        <source>the weights of the cells are missing: histogram 0; 1; 2 weights 5; 8</source>
        <translation>die Gewichte der Zellen fehlen: histogram 0; 1; 2 weights 5; 8</translation>
    </message>
    <message>
        <source>write the probability as p = 0.02 or p = 2 %</source>
        <translation>schreiben Sie die Wahrscheinlichkeit als p = 0.02 oder p = 2 %</translation>
    </message>
    <message>
        <source>location</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>the shape must lie between 0.1 and 1000000.</source>
        <translation>die Form muss zwischen 0.1 und 1000000 liegen.</translation>
    </message>
    <message>
        <source>value without an event</source>
        <translation>Wert ohne Ereignis</translation>
    </message>
    <message>
        <source>the expected number of events must lie between 0 and 10000000; beyond it a normal distribution says the same.</source>
        <translation>die erwartete Zahl der Ereignisse muss zwischen 0 und 10000000 liegen; darüber sagt eine Normalverteilung dasselbe.</translation>
    </message>
    <message>
        <source>the number of trials must be a whole number up to 10000000; beyond it a normal distribution says the same.</source>
        <translation>die Zahl der Versuche muss eine ganze Zahl bis 10000000 sein; darüber sagt eine Normalverteilung dasselbe.</translation>
    </message>
    <message>
        <source>the probability must lie between 0 and 1.</source>
        <translation>die Wahrscheinlichkeit muss zwischen 0 und 1 liegen.</translation>
    </message>
    <message>
        <source>a histogram needs at least one cell.</source>
        <translation>ein Histogramm braucht mindestens eine Zelle.</translation>
    </message>
    <message>
        <source>there must be one edge more than probabilities.</source>
        <translation>es muss eine Kante mehr als Wahrscheinlichkeiten geben.</translation>
    </message>
    <message>
        <source>edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>the edges must rise.</source>
        <translation>die Kanten müssen steigen.</translation>
    </message>
    <message>
        <source>histogram: there must be one edge more than probabilities.</source>
        <translation>Histogramm: es muss eine Kante mehr als Wahrscheinlichkeiten geben.</translation>
    </message>
    <message>
        <source>the measurement model has a kink at the estimates, or bends too sharply there for derivatives of second and third order</source>
        <translation>das Messmodell hat bei den Schätzwerten einen Knick oder ist dort zu stark gekrümmt für Ableitungen zweiter und dritter Ordnung</translation>
    </message>
    <message>
        <source>the measurement model has no value there</source>
        <translation>das Messmodell hat dort keinen Wert</translation>
    </message>
    <message>
        <source>its sensitivity coefficients are zero, or there are none</source>
        <translation>ihre Empfindlichkeitskoeffizienten sind null, oder es gibt keine</translation>
    </message>
    <message>
        <source>Monte Carlo answers alone for %1: the measurement model has no sensitivity coefficients at the estimates of its input quantities.</source>
        <translation>Nur Monte Carlo antwortet für %1: das Messmodell hat bei den Schätzwerten seiner Eingangsgrößen keine Empfindlichkeitskoeffizienten.</translation>
    </message>
    <message>
        <source>%1 has a kink at the estimates of the input quantities (an absolute value, a maximum, a condition): the law of propagation takes the sensitivity coefficients of one side. Use Monte Carlo.</source>
        <translation>%1 hat bei den Schätzwerten der Eingangsgrößen einen Knick (ein Betrag, ein Maximum, eine Bedingung): das Fortpflanzungsgesetz nimmt die Empfindlichkeitskoeffizienten einer Seite. Verwenden Sie Monte Carlo.</translation>
    </message>
    <message>
        <source>Monte Carlo answers alone for %1, which has a kink at the estimates of the input quantities (an absolute value, a maximum, a condition): the law of propagation would take the sensitivity coefficients of one side.</source>
        <translation>Nur Monte Carlo antwortet für %1, das bei den Schätzwerten der Eingangsgrößen einen Knick hat (ein Betrag, ein Maximum, eine Bedingung): das Fortpflanzungsgesetz nähme die Empfindlichkeitskoeffizienten einer Seite.</translation>
    </message>
    <message>
        <source>There is no standard uncertainty with second-order terms of %1: they would make its variance negative, so terms of higher order matter as much. Use Monte Carlo.</source>
        <translation>Es gibt keine Standardunsicherheit mit Gliedern zweiter Ordnung von %1: sie machten ihre Varianz negativ, so dass Glieder höherer Ordnung ebenso zählen. Verwenden Sie Monte Carlo.</translation>
    </message>
    <message>
        <source>%1 trials are few for a coverage interval of %2 %: some %3 lie beyond each of its ends, so that U is not known well. JCGM 101 7.2.2 asks for some %4 trials.</source>
        <translation>%1 Versuche sind wenige für ein Überdeckungsintervall von %2 %: etwa %3 liegen jenseits jedes seiner Enden, so dass U nicht gut bekannt ist. JCGM 101 7.2.2 verlangt etwa %4 Versuche.</translation>
    </message>
    <message>
        <source>the measurement model has no sensitivity coefficients at the estimates of its input quantities%1: it is not differentiable there (singular geometry); Monte Carlo needs none</source>
        <translation>das Messmodell hat bei den Schätzwerten der Eingangsgrößen keine Empfindlichkeitskoeffizienten%1: es ist dort nicht differenzierbar (singuläre Geometrie); Monte Carlo braucht keine</translation>
    </message>
    <message>
        <source>the readings find target %1 %2 mm from its nominal coordinates; look for exchanged names or a unit that was mixed up (the result does not depend on the nominal coordinates)</source>
        <translation>die Ablesungen finden das Ziel %1 %2 mm von seinen Nennkoordinaten; suchen Sie nach vertauschten Namen oder einer verwechselten Einheit (das Ergebnis hängt nicht von den Nennkoordinaten ab)</translation>
    </message>
    <message>
        <source>the readings find %1 further targets far from their nominal coordinates</source>
        <translation>die Ablesungen finden %1 weitere Ziele weit von ihren Nennkoordinaten</translation>
    </message>
    <message>
        <source>observations have degrees of freedom of their own; those made together have the same numbers in the table of observations</source>
        <translation>Beobachtungen haben eigene Freiheitsgrade; zusammen gemachte haben dieselben Nummern in der Tabelle der Beobachtungen</translation>
    </message>
    <message>
        <source>the members of an ensemble have a standard or expanded uncertainty with finite nu</source>
        <translation>die Mitglieder eines Ensembles haben eine Standard- oder erweiterte Unsicherheit mit endlichem nu</translation>
    </message>
    <message>
        <source>the members of ensemble &apos;%1&apos; have one and the same nu; it is %2 in the first, %3 here</source>
        <translation>die Mitglieder des Ensembles &apos;%1&apos; haben ein und dasselbe nu; es ist %2 im ersten, %3 hier</translation>
    </message>
    <message>
        <source>the sample gives the estimate: leave the value empty</source>
        <translation>die Stichprobe ergibt den Schätzwert: lassen Sie den Wert leer</translation>
    </message>
    <message>
        <source>the weight of a cell of its histogram is missing</source>
        <translation>das Gewicht einer Zelle ihres Histogramms fehlt</translation>
    </message>
    <message>
        <source>a histogram has the weight of each cell beside the edge where it begins, and none beside the last edge</source>
        <translation>ein Histogramm hat das Gewicht jeder Zelle neben der Kante, an der sie beginnt, und keines neben der letzten Kante</translation>
    </message>
    <message>
        <source>some values of its sample have a weight and some have none</source>
        <translation>einige Werte ihrer Stichprobe haben ein Gewicht und einige keines</translation>
    </message>
    <message>
        <source>its weights must have a sum above zero</source>
        <translation>ihre Gewichte müssen eine Summe über null haben</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is complex: list its parts %2 and %3, or define abs(%1) and arg(%1) and list these</source>
        <translation>&apos;%1&apos; ist komplex: führen Sie seine Teile %2 und %3 auf, oder definieren Sie abs(%1) und arg(%1) und führen diese auf</translation>
    </message>
    <message>
        <source>a difference: %1 in K</source>
        <translation>eine Differenz: %1 in K</translation>
    </message>
    <message>
        <source>a thermodynamic temperature: %1 in K</source>
        <translation>eine thermodynamische Temperatur: %1 in K</translation>
    </message>
    <message>
        <source>a difference: %1</source>
        <translation>eine Differenz: %1</translation>
    </message>
    <message>
        <source>its reading in degC: %1 - 0 [degC]</source>
        <translation>ihre Ablesung in degC: %1 - 0 [degC]</translation>
    </message>
    <message>
        <source>a part of its reading in degC: %1 K</source>
        <translation>ein Teil ihrer Ablesung in degC: %1 K</translation>
    </message>
    <message>
        <source>as stated with correlations, ISO/TS 28037, 10</source>
        <translation>wie angegeben mit Korrelationen, ISO/TS 28037, 10</translation>
    </message>
    <message>
        <source>common deviation of all %1</source>
        <translation>gemeinsame Abweichung aller %1</translation>
    </message>
    <message>
        <source>stated for all points</source>
        <translation>für alle Punkte angegeben</translation>
    </message>
    <message>
        <source>a common deviation is one of stated uncertainties: choose these, or leave it 0</source>
        <translation>eine gemeinsame Abweichung ist eine angegebener Unsicherheiten: wählen Sie diese, oder lassen Sie sie 0</translation>
    </message>
    <message>
        <source>correlations are those of stated uncertainties: choose these, or leave out the correlations</source>
        <translation>Korrelationen sind die angegebener Unsicherheiten: wählen Sie diese, oder lassen Sie die Korrelationen weg</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no coordinate of a point: write y_1 for the y of the first one</source>
        <translation>&apos;%1&apos; ist keine Koordinate eines Punkts: schreiben Sie y_1 für das y des ersten</translation>
    </message>
    <message>
        <source>%1 has no standard uncertainty of its own that could be correlated</source>
        <translation>%1 hat keine eigene Standardunsicherheit, die korreliert sein könnte</translation>
    </message>
    <message>
        <source>a coordinate is not correlated with itself</source>
        <translation>eine Koordinate ist nicht mit sich selbst korreliert</translation>
    </message>
    <message>
        <source>the CSV file &apos;%1&apos; of %2 is a link that leads out of the project&apos;s folder: put the file itself there</source>
        <translation>die CSV-Datei &apos;%1&apos; von %2 ist eine Verknüpfung, die aus dem Ordner des Projekts hinausführt: legen Sie die Datei selbst dorthin</translation>
    </message>
    <message>
        <source>the guard band of %1 follows from the ratio of tolerance and U: give both limits, or choose a guard factor</source>
        <translation>das Sicherheitsband von %1 folgt aus dem Verhältnis von Toleranz und U: geben Sie beide Grenzen an, oder wählen Sie einen Sicherheitsfaktor</translation>
    </message>
    <message>
        <source>the guard band of %1 is made for a global risk: give the prior, or choose a specific risk</source>
        <translation>das Sicherheitsband von %1 ist für ein globales Risiko gemacht: geben Sie die Vorkenntnis an, oder wählen Sie ein spezifisches Risiko</translation>
    </message>
    <message>
        <source>the guard band of %1 needs a tolerance: give a limit</source>
        <translation>das Sicherheitsband von %1 braucht eine Toleranz: geben Sie eine Grenze an</translation>
    </message>
    <message>
        <source>the target risk of %1 must lie above 0 and not above 0.5</source>
        <translation>das Zielrisiko von %1 muss über 0 und nicht über 0.5 liegen</translation>
    </message>
    <message>
        <source>another study has the same id</source>
        <translation>eine andere Studie hat dieselbe Kennung</translation>
    </message>
    <message>
        <source>its id must be made of letters, digits, &apos;-&apos; and &apos;_&apos;</source>
        <translation>ihre Kennung muss aus Buchstaben, Ziffern, &apos;-&apos; und &apos;_&apos; bestehen</translation>
    </message>
    <message>
        <source>there is no asset %1, and no analysis of this name that this one takes from%2</source>
        <translation>es gibt kein Objekt %1 und keine Analyse dieses Namens, von der diese nimmt%2</translation>
    </message>
    <message>
        <source> (did you mean %1?)</source>
        <translation> (meinten Sie %1?)</translation>
    </message>
    <message>
        <source>a number here is larger than any that can be computed with (1.8e308)</source>
        <translation>eine Zahl hier ist größer als jede, mit der gerechnet werden kann (1.8e308)</translation>
    </message>
    <message>
        <source>the value or its place is no text in UTF-8</source>
        <translation>der Wert oder sein Ort ist kein Text in UTF-8</translation>
    </message>
    <message>
        <source>more than %1 analyses feed each other in a row: put the equations of some of them into one</source>
        <translation>mehr als %1 Analysen speisen einander in einer Reihe: fassen Sie die Gleichungen einiger in einer zusammen</translation>
    </message>
    <message>
        <source>a temperature: %1 in degC</source>
        <translation>eine Temperatur: %1 in degC</translation>
    </message>
    <message>
        <source>%1 is a link that leads out of the project&apos;s folder: put the picture itself there</source>
        <translation>%1 ist eine Verknüpfung, die aus dem Ordner des Projekts hinausführt: legen Sie das Bild selbst dorthin</translation>
    </message>
    <message>
        <source>%1; in this file write %2</source>
        <translation>%1; schreiben Sie in dieser Datei %2</translation>
    </message>
    <message>
        <source>there is no asset %1%2</source>
        <translation>es gibt kein Objekt %1%2</translation>
    </message>
    <message>
        <source>the file of candidates &apos;%1&apos; is a link that leads out of the project&apos;s folder: put the file itself there</source>
        <translation>die Datei der Kandidaten &apos;%1&apos; ist eine Verknüpfung, die aus dem Ordner des Projekts hinausführt: legen Sie die Datei selbst dorthin</translation>
    </message>
    <message>
        <source>another design has the same id</source>
        <translation>ein anderer Entwurf hat dieselbe Kennung</translation>
    </message>
    <message>
        <source>row %1 was left out</source>
        <translation>Zeile %1 wurde ausgelassen</translation>
    </message>
    <message>
        <source>row %1: %2 in %3 beside a sensitivity coefficient is taken as a difference or reading, in %4</source>
        <translation>Zeile %1: %2 in %3 neben einem Empfindlichkeitskoeffizienten wird als Differenz oder Ablesung genommen, in %4</translation>
    </message>
    <message>
        <source>the result is not the sum of c x: %1 = %2 is the difference</source>
        <translation>das Ergebnis ist nicht die Summe der c x: %1 = %2 ist die Differenz</translation>
    </message>
    <message>
        <source>the sheet %1 has no row %2 to leave out</source>
        <translation>das Blatt %1 hat keine Zeile %2, die ausgelassen werden könnte</translation>
    </message>
    <message>
        <source>%1 is no place of a cell; D3 is one</source>
        <translation>%1 ist kein Ort einer Zelle; D3 ist einer</translation>
    </message>
    <message>
        <source>point %1 with other coordinates: those of line %2 are taken</source>
        <translation>Punkt %1 mit anderen Koordinaten: die der Zeile %2 werden genommen</translation>
    </message>
    <message>
        <source>%1 determinations of the same points (&lt;coordinates&gt; of lines %2): each is an artefact of its own; keep all of them, or delete those that you do not want</source>
        <translation>%1 Bestimmungen derselben Punkte (&lt;coordinates&gt; der Zeilen %2): jede ist ein eigenes Artefakt; behalten Sie alle, oder löschen Sie die, die Sie nicht wollen</translation>
    </message>
    <message>
        <source>%1 is no number: write %2, with a point</source>
        <translation>%1 ist keine Zahl: schreiben Sie %2, mit einem Punkt</translation>
    </message>
    <message>
        <source>the name of the result %1 of %2</source>
        <translation>den Namen des Ergebnisses %1 von %2</translation>
    </message>
    <message>
        <source>the names of the results %1 of %2</source>
        <translation>die Namen der Ergebnisse %1 von %2</translation>
    </message>
    <message>
        <source>the certificate calls it by its symbol alone: %1 must be stated (ISO/IEC 17025 %2)</source>
        <translation>der Kalibrierschein nennt es nur mit seinem Symbol: %1 muss angegeben werden (ISO/IEC 17025 %2)</translation>
    </message>
    <message>
        <source>under an accreditation U is stated for a coverage probability of about 95 % (ILAC-P14 5.3); here it is %1</source>
        <translation>unter einer Akkreditierung wird U für eine Überdeckungswahrscheinlichkeit von etwa 95 % angegeben (ILAC-P14 5.3); hier ist sie %1</translation>
    </message>
    <message>
        <source>%1: the file states %2, this budget gives %3, %4 apart</source>
        <translation>%1: die Datei gibt %2 an, dieses Budget ergibt %3, %4 auseinander</translation>
    </message>
    <message>
        <source>%1: FIND OUT WHY before it is used</source>
        <translation>%1: FINDEN SIE HERAUS, WARUM, bevor es verwendet wird</translation>
    </message>
    <message>
        <source>u(%1) by its contributions</source>
        <translation>u(%1) aus seinen Beiträgen</translation>
    </message>
    <message>
        <source>%1: the file states no result that this budget could be held against</source>
        <translation>%1: die Datei gibt kein Ergebnis an, gegen das dieses Budget gehalten werden könnte</translation>
    </message>
    <message>
        <source>another one has the same id</source>
        <translation>ein anderes hat dieselbe Kennung</translation>
    </message>
    <message>
        <source>%1: of what the rule accepts %2 does not conform, of what it rejects %3 does.</source>
        <translation>%1: von dem, was die Regel annimmt, ist %2 nicht konform, von dem, was sie zurückweist, ist %3 konform.</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>%1 further components of %2 other sources</source>
        <translation>%1 weitere Komponenten aus %2 anderen Quellen</translation>
    </message>
    <message>
        <source>other sources</source>
        <translation>andere Quellen</translation>
    </message>
    <message>
        <source>1 further component: %1</source>
        <translation>1 weitere Komponente: %1</translation>
    </message>
    <message>
        <source>%1 further components: %2</source>
        <translation>%1 weitere Komponenten: %2</translation>
    </message>
    <message>
        <source>Left out: %1 components that contribute nothing (less than 10⁻⁹ of u_c).</source>
        <translation>Weggelassen: %1 Komponenten, die nichts beitragen (weniger als 10⁻⁹ von u_c).</translation>
    </message>
    <message>
        <source>Left out, because they contribute nothing (less than 10⁻⁹ of u_c): %1.</source>
        <translation>Weggelassen, weil sie nichts beitragen (weniger als 10⁻⁹ von u_c): %1.</translation>
    </message>
    <message>
        <source>Stated in the results: %1 = %2 (propagation of distributions).</source>
        <translation>In den Ergebnissen angegeben: %1 = %2 (Fortpflanzung von Verteilungen).</translation>
    </message>
    <message>
        <source>%1: under an accreditation U is stated for a coverage probability of about 95 % (ILAC-P14 5.3); with k = %2 that of %3 is %4</source>
        <translation>%1: unter einer Akkreditierung wird U für eine Überdeckungswahrscheinlichkeit von etwa 95 % angegeben (ILAC-P14 5.3); mit k = %2 ist die von %3 %4</translation>
    </message>
    <message>
        <source>not drawn, for it is farther away than 10¹² km: %1</source>
        <translation>nicht gezeichnet, denn es ist weiter weg als 10¹² km: %1</translation>
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
        <translation>erwartete Zahl der Ereignisse</translation>
    </message>
    <message>
        <source>step of one event</source>
        <translation>Schritt eines Ereignisses</translation>
    </message>
    <message>
        <source>probability</source>
        <translation>Wahrscheinlichkeit</translation>
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
        <translation>75 nm: Standardunsicherheit
2 ppm: Standardunsicherheit, ein Teil des Werts; absolut, wo die Größe selbst ein Verhältnis ist
U = 0.3 um, k = 2 (oder p = 95 %): Kalibrierschein
s = 13 nm, n = 5: vorher bekannte Standardabweichung, Mittelwert von n Beobachtungen (Typ A)
rectangular 0.5 (oder rect, ±): Grenzen um den Wert; ebenso triangular, arcsine
limits 19.5 to 20.5: sie ergeben den Wert
10.1; 10.3; 10.2: Beobachtungen
resolution 0.01, MPE 3 + 0.1 %, counts 12, constant
Laplace 0.3, Weibull 0.3 (Standardabweichungen), Weibull scale 2, shape 1.5
Poisson 12, binomial n = 50, p = 2 %: sie ergeben den Wert
sample 1; 2; 3 weights 2; 5; 2 (gezogen, wie sie sind), histogram 0; 1; 2 weights 5; 8 (Kanten)
nu 18 hinter jedem davon: Freiheitsgrade</translation>
    </message>
    <message>
        <source>sample</source>
        <translation>Stichprobe</translation>
    </message>
    <message>
        <source>weights</source>
        <translation>Gewichte</translation>
    </message>
    <message>
        <source>Network adjustment</source>
        <translation>Netzausgleichung</translation>
    </message>
    <message>
        <source>Coordinates of stations and targets from the distances, directions, angles and height differences that were read between them: heights, plane or space, free or held by known points, with the reliability of each reading.</source>
        <translation>Koordinaten von Standpunkten und Zielpunkten aus den Distanzen, Richtungen, Winkeln und Höhenunterschieden, die zwischen ihnen abgelesen wurden: Höhen, Lage oder Raum, frei oder von bekannten Punkten gehalten, mit der Zuverlässigkeit jeder Ablesung.</translation>
    </message>
    <message>
        <source>Uncertainties follow from those that were stated for the readings; they are not multiplied by s_0, which is a test of them.</source>
        <translation>Die Unsicherheiten folgen aus denen, die für die Ablesungen angegeben wurden; sie werden nicht mit s_0 multipliziert, das eine Prüfung von ihnen ist.</translation>
    </message>
    <message>
        <source>In a free network what no reading tells is taken from the approximate coordinates of the points of the datum: the sum of squares of their changes is least. Residuals, s_0 and redundancies do not depend on the datum.</source>
        <translation>In einem freien Netz wird das, worüber keine Ablesung etwas sagt, aus den Näherungskoordinaten der Datumspunkte genommen: Die Quadratsumme ihrer Änderungen ist am kleinsten. Residuen, s_0 und Redundanzen hängen nicht vom Datum ab.</translation>
    </message>
    <message>
        <source>Each round of directions has an orientation that is not known. Instruments are levelled unless the set-up says how they lean: zenith angles count from the vertical, the z-axis at all points.</source>
        <translation>Jeder Richtungssatz hat eine Orientierung, die nicht bekannt ist. Messgeräte sind horizontiert, wenn der Aufbau nicht sagt, wie sie geneigt sind: Zenitwinkel zählen von der Lotrichtung, in allen Punkten die z-Achse.</translation>
    </message>
    <message>
        <source>Smallest detectable errors are those of a test at 0.1 % with a power of 80 % (delta_0 = 4.132), with the uncertainties that were stated.</source>
        <translation>Die kleinsten aufdeckbaren Fehler sind die einer Prüfung auf 0.1 % mit einer Testgüte von 80 % (delta_0 = 4.132), mit den angegebenen Unsicherheiten.</translation>
    </message>
    <message>
        <source>In Monte Carlo each trial is a solution with the derivatives at the estimates, repeated until it stands still.</source>
        <translation>Bei Monte Carlo ist jeder Versuch eine Lösung mit den Ableitungen bei den Schätzwerten, wiederholt, bis sie sich nicht mehr ändert.</translation>
    </message>
    <message>
        <source>Map projections, refraction and the curvature of the Earth are not part of it: reduce the readings before.</source>
        <translation>Kartenprojektionen, Refraktion und Erdkrümmung gehören nicht dazu: Reduzieren Sie die Ablesungen vorher.</translation>
    </message>
    <message>
        <source>Stations and targets alike, with what is known of them beforehand.</source>
        <translation>Standpunkte und Zielpunkte gleichermaßen, mit dem, was vorab über sie bekannt ist.</translation>
    </message>
    <message>
        <source>Coordinate x; of an unknown point an approximate one, or empty: the readings place it.</source>
        <translation>Koordinate x; bei einem unbekannten Punkt eine Näherung oder leer: die Ablesungen bestimmen seinen Ort.</translation>
    </message>
    <message>
        <source>Coordinate y; of an unknown point an approximate one, or empty: the readings place it.</source>
        <translation>Koordinate y; bei einem unbekannten Punkt eine Näherung oder leer: die Ablesungen bestimmen seinen Ort.</translation>
    </message>
    <message>
        <source>Coordinate z; of an unknown point an approximate one, or empty: the readings place it.</source>
        <translation>Koordinate z; bei einem unbekannten Punkt eine Näherung oder leer: die Ablesungen bestimmen seinen Ort.</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>What is known of x and y: unknown; unknown, and what no reading tells is taken from this point and others like it (free network); fixed without uncertainty; stated with u.</source>
        <translation>Was über x und y bekannt ist: unbekannt; unbekannt, und was keine Ablesung sagt, wird aus diesem Punkt und anderen wie ihm genommen (freies Netz); fest ohne Unsicherheit; angegeben mit u.</translation>
    </message>
    <message>
        <source>unknown, of the datum</source>
        <translation>unbekannt, Datumspunkt</translation>
    </message>
    <message>
        <source>stated with u</source>
        <translation>angegeben mit u</translation>
    </message>
    <message>
        <source>not part of the network</source>
        <translation>nicht Teil des Netzes</translation>
    </message>
    <message>
        <source>height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>What is known of z, likewise.</source>
        <translation>Was über z bekannt ist, ebenso.</translation>
    </message>
    <message>
        <source>Standard uncertainty of a stated coordinate.</source>
        <translation>Standardunsicherheit einer angegebenen Koordinate.</translation>
    </message>
    <message>
        <source>Distances between points that are measurands too.</source>
        <translation>Abstände zwischen Punkten, die ebenfalls Messgrößen sind.</translation>
    </message>
    <message>
        <source>Name of a point.</source>
        <translation>Name eines Punktes.</translation>
    </message>
    <message>
        <source>Name of another point.</source>
        <translation>Name eines anderen Punktes.</translation>
    </message>
    <message>
        <source>Directions grow</source>
        <translation>Richtungen wachsen</translation>
    </message>
    <message>
        <source>In which sense directions, angles and azimuths grow, and from which axis azimuths count.</source>
        <translation>In welchem Sinn Richtungen, Winkel und Azimute wachsen und von welcher Achse Azimute zählen.</translation>
    </message>
    <message>
        <source>from x towards y; azimuths count from x</source>
        <translation>von x nach y; Azimute zählen von x</translation>
    </message>
    <message>
        <source>from y towards x; azimuths count from y</source>
        <translation>von y nach x; Azimute zählen von y</translation>
    </message>
    <message>
        <source>What was read between the points, one row for each figure, typed or from a CSV file.</source>
        <translation>Was zwischen den Punkten abgelesen wurde, eine Zeile je Zahl, eingegeben oder aus einer CSV-Datei.</translation>
    </message>
    <message>
        <source>label</source>
        <translation>Kennung</translation>
    </message>
    <message>
        <source>By which a correlation calls it.</source>
        <translation>Unter der eine Korrelation sie nennt.</translation>
    </message>
    <message>
        <source>What was read.</source>
        <translation>Was abgelesen wurde.</translation>
    </message>
    <message>
        <source>slope distance</source>
        <translation>Schrägdistanz</translation>
    </message>
    <message>
        <source>horizontal distance</source>
        <translation>Horizontaldistanz</translation>
    </message>
    <message>
        <source>zenith angle</source>
        <translation>Zenitwinkel</translation>
    </message>
    <message>
        <source>height difference</source>
        <translation>Höhenunterschied</translation>
    </message>
    <message>
        <source>x of a point</source>
        <translation>x eines Punktes</translation>
    </message>
    <message>
        <source>y of a point</source>
        <translation>y eines Punktes</translation>
    </message>
    <message>
        <source>z of a point</source>
        <translation>z eines Punktes</translation>
    </message>
    <message>
        <source>difference of x</source>
        <translation>Differenz von x</translation>
    </message>
    <message>
        <source>difference of y</source>
        <translation>Differenz von y</translation>
    </message>
    <message>
        <source>difference of z</source>
        <translation>Differenz von z</translation>
    </message>
    <message>
        <source>The point where it was read; of a coordinate its point.</source>
        <translation>Der Punkt, auf dem abgelesen wurde; bei einer Koordinate ihr Punkt.</translation>
    </message>
    <message>
        <source>The point that was sighted.</source>
        <translation>Der Punkt, der angezielt wurde.</translation>
    </message>
    <message>
        <source>Of an angle the point at its second leg.</source>
        <translation>Bei einem Winkel der Punkt an seinem zweiten Schenkel.</translation>
    </message>
    <message>
        <source>round</source>
        <translation>Satz</translation>
    </message>
    <message>
        <source>Of a direction: rounds of one station between which its circle was turned have names; each has an orientation of its own.</source>
        <translation>Bei einer Richtung: Sätze eines Standpunktes, zwischen denen der Kreis verdreht wurde, haben Namen; jeder hat eine eigene Orientierung.</translation>
    </message>
    <message>
        <source>A length or coordinate as read.</source>
        <translation>Eine Länge oder Koordinate, wie abgelesen.</translation>
    </message>
    <message>
        <source>An angle as read.</source>
        <translation>Ein Winkel, wie abgelesen.</translation>
    </message>
    <message>
        <source>u of length</source>
        <translation>u der Länge</translation>
    </message>
    <message>
        <source>Standard uncertainty of the length.</source>
        <translation>Standardunsicherheit der Länge.</translation>
    </message>
    <message>
        <source>u of angle</source>
        <translation>u des Winkels</translation>
    </message>
    <message>
        <source>Standard uncertainty of the angle.</source>
        <translation>Standardunsicherheit des Winkels.</translation>
    </message>
    <message>
        <source>height from</source>
        <translation>Gerätehöhe</translation>
    </message>
    <message>
        <source>Height of the instrument above its point.</source>
        <translation>Höhe des Messgeräts über seinem Punkt.</translation>
    </message>
    <message>
        <source>height to</source>
        <translation>Zielhöhe</translation>
    </message>
    <message>
        <source>Height of the target above its point.</source>
        <translation>Höhe des Zielzeichens über seinem Punkt.</translation>
    </message>
    <message>
        <source>Instruments that are not levelled</source>
        <translation>Messgeräte, die nicht horizontiert sind</translation>
    </message>
    <message>
        <source>Where an instrument stands that is not levelled, or not exactly; all others are.</source>
        <translation>Wo ein Messgerät steht, das nicht oder nicht genau horizontiert ist; alle anderen sind es.</translation>
    </message>
    <message>
        <source>The point where the instrument stands.</source>
        <translation>Der Punkt, auf dem das Messgerät steht.</translation>
    </message>
    <message>
        <source>tilt</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>How it leans: unknown, so that the readings tell it; or levelled within u, about x and about y.</source>
        <translation>Wie es geneigt ist: unbekannt, so dass die Ablesungen es sagen; oder horizontiert innerhalb von u, um x und um y.</translation>
    </message>
    <message>
        <source>levelled within u</source>
        <translation>horizontiert innerhalb von u</translation>
    </message>
    <message>
        <source>u of tilt</source>
        <translation>u der Neigung</translation>
    </message>
    <message>
        <source>Standard uncertainty of each tilt of a levelled instrument.</source>
        <translation>Standardunsicherheit jeder Neigung eines horizontierten Messgeräts.</translation>
    </message>
    <message>
        <source>Correlations of readings</source>
        <translation>Korrelationen der Ablesungen</translation>
    </message>
    <message>
        <source>Correlation coefficients of readings: they change the weights and the uncertainty.</source>
        <translation>Korrelationskoeffizienten von Ablesungen: sie ändern die Gewichte und die Unsicherheit.</translation>
    </message>
    <message>
        <source>Label of a reading.</source>
        <translation>Kennung einer Ablesung.</translation>
    </message>
    <message>
        <source>Label of another reading.</source>
        <translation>Kennung einer anderen Ablesung.</translation>
    </message>
    <message>
        <source>Correlation coefficient of the two.</source>
        <translation>Korrelationskoeffizient der beiden.</translation>
    </message>
    <message>
        <source>Two targets from two stations that nobody measured</source>
        <translation>Zwei Zielpunkte von zwei Standpunkten aus, die niemand gemessen hat</translation>
    </message>
    <message>
        <source>A total station stood at S1 and S2, whose places are not known.</source>
        <translation>Eine Totalstation stand auf S1 und S2, deren Orte nicht bekannt sind.</translation>
    </message>
    <message>
        <source>The law of propagation of uncertainty says nothing of %1 at these estimates: Monte Carlo answers alone</source>
        <translation>Das Fortpflanzungsgesetz der Unsicherheit sagt bei diesen Schätzwerten nichts über %1: nur Monte Carlo antwortet</translation>
    </message>
    <message>
        <source>The standard uncertainty by Monte Carlo of %1 is not known from these trials, and may not exist: the tails of its distribution are too heavy. Use the coverage interval.</source>
        <translation>Die Standardunsicherheit von %1 nach Monte Carlo ist aus diesen Versuchen nicht bekannt und existiert vielleicht nicht: die Ausläufer der Verteilung sind zu schwer. Verwenden Sie das Überdeckungsintervall.</translation>
    </message>
    <message>
        <source>as stated</source>
        <translation>wie angegeben</translation>
    </message>
    <message>
        <source>tilt at %1 about %2</source>
        <translation>Neigung auf %1 um %2</translation>
    </message>
    <message>
        <source>orientation at %1</source>
        <translation>Orientierung auf %1</translation>
    </message>
    <message>
        <source>orientation at %1, round %2</source>
        <translation>Orientierung auf %1, Satz %2</translation>
    </message>
    <message>
        <source>readings l, their residuals v, unknowns x</source>
        <translation>Ablesungen l, ihre Residuen v, Unbekannte x</translation>
    </message>
    <message>
        <source>least squares, Gauss-Newton method</source>
        <translation>kleinste Quadrate, Gauß-Newton-Verfahren</translation>
    </message>
    <message>
        <source>law of propagation; generalised inverse of the datum</source>
        <translation>Fortpflanzungsgesetz; verallgemeinerte Inverse des Datums</translation>
    </message>
    <message>
        <source>free network: W. Baarda, S-transformations, 1973</source>
        <translation>freies Netz: W. Baarda, S-transformations, 1973</translation>
    </message>
    <message>
        <source>redundancy and test of a reading: W. Baarda, A testing procedure, 1968</source>
        <translation>Redundanz und Prüfung einer Ablesung: W. Baarda, A testing procedure, 1968</translation>
    </message>
    <message>
        <source>smallest error of a reading that the test finds</source>
        <translation>kleinster Fehler einer Ablesung, den die Prüfung findet</translation>
    </message>
    <message>
        <source>a posteriori; uncertainties are those that were stated, not times s₀</source>
        <translation>a posteriori; Unsicherheiten sind die angegebenen, nicht mal s₀</translation>
    </message>
    <message>
        <source>slope distance %1 – %2</source>
        <translation>Schrägdistanz %1 – %2</translation>
    </message>
    <message>
        <source>horizontal distance %1 – %2</source>
        <translation>Horizontaldistanz %1 – %2</translation>
    </message>
    <message>
        <source>direction %1 – %2</source>
        <translation>Richtung %1 – %2</translation>
    </message>
    <message>
        <source>azimuth %1 – %2</source>
        <translation>Azimut %1 – %2</translation>
    </message>
    <message>
        <source>zenith angle %1 – %2</source>
        <translation>Zenitwinkel %1 – %2</translation>
    </message>
    <message>
        <source>height difference %1 – %2</source>
        <translation>Höhenunterschied %1 – %2</translation>
    </message>
    <message>
        <source>tilt about x of the instrument at %1</source>
        <translation>Neigung um x des Messgeräts auf %1</translation>
    </message>
    <message>
        <source>tilt about y of the instrument at %1</source>
        <translation>Neigung um y des Messgeräts auf %1</translation>
    </message>
    <message>
        <source>x of %1</source>
        <translation>x von %1</translation>
    </message>
    <message>
        <source>y of %1</source>
        <translation>y von %1</translation>
    </message>
    <message>
        <source>z of %1</source>
        <translation>z von %1</translation>
    </message>
    <message>
        <source>difference of x, %1 – %2</source>
        <translation>Differenz von x, %1 – %2</translation>
    </message>
    <message>
        <source>difference of y, %1 – %2</source>
        <translation>Differenz von y, %1 – %2</translation>
    </message>
    <message>
        <source>difference of z, %1 – %2</source>
        <translation>Differenz von z, %1 – %2</translation>
    </message>
    <message>
        <source>the readings do not lead to a place of every point: the adjustment does not converge; look for exchanged or mistyped readings, for a unit that was mixed up (gon and degrees, m and mm), and for coordinates that are far off</source>
        <translation>die Ablesungen führen nicht zu einem Ort jedes Punktes: die Ausgleichung konvergiert nicht; nach vertauschten oder vertippten Ablesungen suchen, nach einer verwechselten Einheit (gon und Grad, m und mm) und nach Koordinaten, die weit daneben liegen</translation>
    </message>
    <message>
        <source>and %1 further ways in which the points can move</source>
        <translation>und %1 weitere Arten, wie sich die Punkte bewegen können</translation>
    </message>
    <message>
        <source>point %1: its %2 is said to be known, and is missing</source>
        <translation>Punkt %1: %2 gilt als bekannt und fehlt</translation>
    </message>
    <message>
        <source>point %1: the u of its stated %2 is missing</source>
        <translation>Punkt %1: das u des angegebenen %2 fehlt</translation>
    </message>
    <message>
        <source>the name of a point is missing</source>
        <translation>der Name eines Punktes fehlt</translation>
    </message>
    <message>
        <source>there is no point %1</source>
        <translation>es gibt keinen Punkt %1</translation>
    </message>
    <message>
        <source>the instrument at %1: the u of its tilt is missing</source>
        <translation>das Messgerät auf %1: das u seiner Neigung fehlt</translation>
    </message>
    <message>
        <source>two instruments stand at %1</source>
        <translation>zwei Messgeräte stehen auf %1</translation>
    </message>
    <message>
        <source>a reading from %1 to itself</source>
        <translation>eine Ablesung von %1 zu sich selbst</translation>
    </message>
    <message>
        <source>both legs of the angle at %1 go to %2</source>
        <translation>beide Schenkel des Winkels auf %1 gehen nach %2</translation>
    </message>
    <message>
        <source>%1: its value is missing</source>
        <translation>%1: der Wert fehlt</translation>
    </message>
    <message>
        <source>%1: its standard uncertainty is missing</source>
        <translation>%1: die Standardunsicherheit fehlt</translation>
    </message>
    <message>
        <source>%1 is an angle and has a length</source>
        <translation>%1 ist ein Winkel und hat eine Länge</translation>
    </message>
    <message>
        <source>%1 is a length and has an angle</source>
        <translation>%1 ist eine Länge und hat einen Winkel</translation>
    </message>
    <message>
        <source>%1 is not positive</source>
        <translation>%1 ist nicht positiv</translation>
    </message>
    <message>
        <source>%1 is not between 0 and half a turn: state the mean of both faces</source>
        <translation>%1 liegt nicht zwischen 0 und einer halben Umdrehung: das Mittel beider Kreislagen angeben</translation>
    </message>
    <message>
        <source>%1 needs the height of %2, which is not part of the network</source>
        <translation>%1 braucht die Höhe von %2, die nicht Teil des Netzes ist</translation>
    </message>
    <message>
        <source>%1 needs x and y of %2, which are not part of the network</source>
        <translation>%1 braucht x und y von %2, die nicht Teil des Netzes sind</translation>
    </message>
    <message>
        <source>a distance needs two points</source>
        <translation>ein Abstand braucht zwei Punkte</translation>
    </message>
    <message>
        <source>all points are fixed: there is nothing to be found</source>
        <translation>alle Punkte sind fest: es gibt nichts zu bestimmen</translation>
    </message>
    <message>
        <source>two readings have the label %1</source>
        <translation>zwei Ablesungen haben die Kennung %1</translation>
    </message>
    <message>
        <source>there is no reading with the label %1</source>
        <translation>es gibt keine Ablesung mit der Kennung %1</translation>
    </message>
    <message>
        <source>reading %1 with itself</source>
        <translation>Ablesung %1 mit sich selbst</translation>
    </message>
    <message>
        <source>the correlation coefficients are not possible together</source>
        <translation>die Korrelationskoeffizienten sind zusammen nicht möglich</translation>
    </message>
    <message>
        <source>the readings do not place point %1: too few of them tie it to the others; add readings, or state approximate coordinates</source>
        <translation>die Ablesungen bestimmen den Ort von Punkt %1 nicht: zu wenige verbinden ihn mit den anderen; Ablesungen hinzufügen oder Näherungskoordinaten angeben</translation>
    </message>
    <message>
        <source>the readings do not place %1 points (%2): too few tie them to the others; add readings, or state approximate coordinates</source>
        <translation>die Ablesungen bestimmen den Ort von %1 Punkten nicht (%2): zu wenige verbinden sie mit den anderen; Ablesungen hinzufügen oder Näherungskoordinaten angeben</translation>
    </message>
    <message>
        <source>Adjustment</source>
        <translation>Ausgleichung</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Kennzahl</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>unknowns</source>
        <translation>Unbekannte</translation>
    </message>
    <message>
        <source>what no reading tells (datum defect)</source>
        <translation>was keine Ablesung sagt (Datumsdefekt)</translation>
    </message>
    <message>
        <source>degrees of freedom f</source>
        <translation>Freiheitsgrade f</translation>
    </message>
    <message>
        <source>sum of squares vᵀ C⁻¹ v</source>
        <translation>Quadratsumme vᵀ C⁻¹ v</translation>
    </message>
    <message>
        <source>s₀ a posteriori</source>
        <translation>s₀ a posteriori</translation>
    </message>
    <message>
        <source>δ₀ of smallest detectable errors (0.1 %, 80 %)</source>
        <translation>δ₀ der kleinsten aufdeckbaren Fehler (0.1 %, 80 %)</translation>
    </message>
    <message>
        <source>smallest detectable error</source>
        <translation>kleinster aufdeckbarer Fehler</translation>
    </message>
    <message>
        <source>its largest effect</source>
        <translation>sein größter Einfluss</translation>
    </message>
    <message>
        <source>on</source>
        <translation>auf</translation>
    </message>
    <message>
        <source>%1 The residuals are larger than the uncertainties allow; the largest for its uncertainty is the %2. Look for mistyped or exchanged readings, or uncertainties that are too small</source>
        <translation>%1 Die Residuen sind größer, als die Unsicherheiten zulassen; das größte im Verhältnis zu seiner Unsicherheit ist: %2. Nach vertippten oder vertauschten Ablesungen suchen oder nach zu kleinen Unsicherheiten</translation>
    </message>
    <message>
        <source>nothing was read of point %1: add readings to it, or take it out</source>
        <translation>zu Punkt %1 wurde nichts abgelesen: Ablesungen zu ihm hinzufügen oder ihn herausnehmen</translation>
    </message>
    <message>
        <source>nothing tells how the instrument at %1 stood: add directions or angles from there to places that are known</source>
        <translation>nichts sagt, wie das Messgerät auf %1 stand: von dort Richtungen oder Winkel zu bekannten Orten hinzufügen</translation>
    </message>
    <message>
        <source>nothing tells the height of %1: state it, or add a height difference, or a zenith angle with a distance</source>
        <translation>nichts sagt, wie hoch %1 liegt: die Höhe angeben oder einen Höhenunterschied hinzufügen oder einen Zenitwinkel mit einer Distanz</translation>
    </message>
    <message>
        <source>nothing tells where %1 is: add readings to it</source>
        <translation>nichts sagt, wo %1 ist: Ablesungen dazu hinzufügen</translation>
    </message>
    <message>
        <source>point %1 can move along %2 without changing a reading: add one that sees this</source>
        <translation>Punkt %1 kann sich längs %2 bewegen, ohne dass sich eine Ablesung ändert: eine hinzufügen, die das sieht</translation>
    </message>
    <message>
        <source>the direction (%1, %2, %3)</source>
        <translation>der Richtung (%1, %2, %3)</translation>
    </message>
    <message>
        <source>the whole network</source>
        <translation>das ganze Netz</translation>
    </message>
    <message>
        <source>the part with %1 and %2 more</source>
        <translation>der Teil mit %1 und %2 weiteren</translation>
    </message>
    <message>
        <source>the part with %1</source>
        <translation>der Teil mit %1</translation>
    </message>
    <message>
        <source>nothing tells where %1 is along %2: fix or state a point, or let points be of the datum</source>
        <translation>nichts sagt, wo %1 längs %2 ist: einen Punkt festhalten oder angeben oder Punkte ins Datum aufnehmen</translation>
    </message>
    <message>
        <source>nothing tells the height of %1: fix or state the height of a point, or let heights be of the datum</source>
        <translation>nichts sagt, wie hoch %1 liegt: die Höhe eines Punktes festhalten oder angeben oder Höhen ins Datum aufnehmen</translation>
    </message>
    <message>
        <source>%1 may tilt about %2: add zenith angles or height differences, or fix a third point</source>
        <translation>%1 kann kippen (Achse %2): Zenitwinkel oder Höhenunterschiede hinzufügen oder einen dritten Punkt festhalten</translation>
    </message>
    <message>
        <source>%1 may turn about the vertical: add an azimuth, fix a second point, or let points be of the datum</source>
        <translation>%1 kann sich um die Lotrichtung drehen: ein Azimut hinzufügen, einen zweiten Punkt festhalten oder Punkte ins Datum aufnehmen</translation>
    </message>
    <message>
        <source>nothing tells the scale of %1: add a distance, fix a second point, or let points be of the datum</source>
        <translation>nichts sagt, welchen Maßstab %1 hat: eine Distanz hinzufügen, einen zweiten Punkt festhalten oder Punkte ins Datum aufnehmen</translation>
    </message>
    <message>
        <source>the readings leave open a common movement of %1: add readings that tie them to the others</source>
        <translation>die Ablesungen lassen eine gemeinsame Bewegung offen (%1): Ablesungen hinzufügen, die mit den anderen Punkten verbinden</translation>
    </message>
    <message>
        <source>orientations</source>
        <translation>Orientierungen</translation>
    </message>
    <message>
        <source>moving platform</source>
        <translation>bewegte Plattform</translation>
    </message>
    <message>
        <source>lengths</source>
        <translation>Längen</translation>
    </message>
    <message>
        <source>measured orientations</source>
        <translation>gemessene Orientierungen</translation>
    </message>
    <message>
        <source>measured positions</source>
        <translation>gemessene Positionen</translation>
    </message>
    <message>
        <source>readings of the joints</source>
        <translation>Ablesungen der Gelenke</translation>
    </message>
    <message>
        <source>circle of %1</source>
        <translation>Kreis von %1</translation>
    </message>
    <message>
        <source>regression</source>
        <translation>Regression</translation>
    </message>
    <message>
        <source>it cannot be varied: %1</source>
        <translation>es kann nicht variiert werden: %1</translation>
    </message>
    <message>
        <source>no more than %1</source>
        <translation>nicht mehr als %1</translation>
    </message>
    <message>
        <source>an observation of %1, which the file neither fixes nor adjusts in what it needs</source>
        <translation>eine Beobachtung von %1, wovon die Datei das Nötige weder festlegt noch ausgleicht</translation>
    </message>
    <message>
        <source>an observation of %1 without a standard deviation</source>
        <translation>eine Beobachtung von %1 ohne Standardabweichung</translation>
    </message>
    <message>
        <source>a network of %1 points with %2 readings, which is adjusted</source>
        <translation>ein Netz aus %1 Punkten mit %2 Ablesungen, das ausgeglichen wird</translation>
    </message>
    <message>
        <source>its heights above the points are no numbers</source>
        <translation>die Höhen über den Punkten sind keine Zahlen</translation>
    </message>
    <message>
        <source>column %1%2 of sheet %3 is filled but not understood: state what each column is, %4, with one of %5 in place of ? (- leaves the column out)</source>
        <translation>Spalte %1%2 von Blatt %3 ist gefüllt, aber nicht verstanden: angeben, was jede Spalte ist, %4, mit einem von %5 anstelle von ? (- lässt die Spalte aus)</translation>
    </message>
    <message>
        <source>There is no budget of %1: the law of propagation of uncertainty says nothing of it at the estimates of its input quantities.</source>
        <translation>Es gibt kein Budget von %1: Das Fortpflanzungsgesetz der Unsicherheit sagt darüber bei den Schätzwerten der Eingangsgrößen nichts.</translation>
    </message>
    <message>
        <source>out</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>%1 trials</source>
        <translation>%1 Versuche</translation>
    </message>
    <message>
        <source>sight</source>
        <translation>Ziellinie</translation>
    </message>
    <message>
        <source>force, own scale</source>
        <translation>Kraft, eigener Maßstab</translation>
    </message>
    <message>
        <source>moment, own scale</source>
        <translation>Moment, eigener Maßstab</translation>
    </message>
    <message>
        <source>in</source>
        <translation>Eingang</translation>
    </message>
    <message>
        <source>uncertainty %1</source>
        <translation>Unsicherheit %1</translation>
    </message>
    <message>
        <source>ellipsoids %1, %2</source>
        <translation>Ellipsoide %1, %2</translation>
    </message>
    <message>
        <source>Which instrument read it: readings of one kind by one instrument rest on one figure when stated uncertainties are held against the residuals.</source>
        <translation>Welches Messgerät sie abgelesen hat: Ablesungen einer Art von einem Messgerät beruhen auf einer Angabe, wenn angegebene Unsicherheiten an den Residuen geprüft werden.</translation>
    </message>
    <message>
        <source>Uncertainties of the readings</source>
        <translation>Unsicherheiten der Ablesungen</translation>
    </message>
    <message>
        <source>As typed in the table; or as the residuals of this adjustment see them: typed ones times one common factor s_0, or times the factor of each kind of reading and instrument (variance components). Either has the degrees of freedom of its estimate.</source>
        <translation>Wie in der Tabelle eingegeben; oder wie die Residuen dieser Ausgleichung sie sehen: die eingegebenen mal einem gemeinsamen Faktor s_0 oder mal dem Faktor jeder Art von Ablesung und jedes Messgeräts (Varianzkomponenten). Beide haben die Freiheitsgrade ihrer Schätzung.</translation>
    </message>
    <message>
        <source>as seen, one factor s_0</source>
        <translation>wie gesehen, ein Faktor s_0</translation>
    </message>
    <message>
        <source>as seen, a factor for each figure</source>
        <translation>wie gesehen, ein Faktor je Angabe</translation>
    </message>
    <message>
        <source>Are the figures of the data sheet true?</source>
        <translation>Stimmen die Angaben des Datenblatts?</translation>
    </message>
    <message>
        <source>A section of a barrel, 8 m long, with 20 targets, read by a total station from three places that nobody measured.</source>
        <translation>Eine tonnenförmige Sektion, 8 m lang, mit 20 Zielpunkten, von einer Totalstation von drei Orten aus abgelesen, die niemand gemessen hat.</translation>
    </message>
    <message>
        <source>slope distances</source>
        <translation>Schrägdistanzen</translation>
    </message>
    <message>
        <source>horizontal distances</source>
        <translation>Horizontaldistanzen</translation>
    </message>
    <message>
        <source>directions</source>
        <translation>Richtungen</translation>
    </message>
    <message>
        <source>azimuths</source>
        <translation>Azimute</translation>
    </message>
    <message>
        <source>zenith angles</source>
        <translation>Zenitwinkel</translation>
    </message>
    <message>
        <source>height differences</source>
        <translation>Höhenunterschiede</translation>
    </message>
    <message>
        <source>tilts of instruments</source>
        <translation>Neigungen von Messgeräten</translation>
    </message>
    <message>
        <source>stated coordinates</source>
        <translation>angegebene Koordinaten</translation>
    </message>
    <message>
        <source>coordinates</source>
        <translation>Koordinaten</translation>
    </message>
    <message>
        <source>coordinate differences</source>
        <translation>Koordinatendifferenzen</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>The readings have no residuals that could tell their uncertainty: it stays as stated</source>
        <translation>Die Ablesungen haben keine Residuen, die ihre Unsicherheit zeigen könnten: sie bleibt wie angegeben</translation>
    </message>
    <message>
        <source>Nothing is redundant: uncertainties of the readings stay as stated</source>
        <translation>Nichts ist redundant: Unsicherheiten der Ablesungen bleiben wie angegeben</translation>
    </message>
    <message>
        <source>The residuals give no factors: uncertainties of the readings stay as stated</source>
        <translation>Die Residuen ergeben keine Faktoren: Unsicherheiten der Ablesungen bleiben wie angegeben</translation>
    </message>
    <message>
        <source>Too little redundancy to say, so they stay as stated: %1</source>
        <translation>Zu wenig Redundanz für ein Urteil, also bleiben sie wie angegeben: %1</translation>
    </message>
    <message>
        <source>as seen: %1 times what was stated</source>
        <translation>wie gesehen: %1 mal das Angegebene</translation>
    </message>
    <message>
        <source>measured places</source>
        <translation>gemessene Orte</translation>
    </message>
    <message>
        <source>encoders of the joints</source>
        <translation>Drehgeber der Gelenke</translation>
    </message>
    <message>
        <source>repeatability of the joints</source>
        <translation>Wiederholpräzision der Gelenke</translation>
    </message>
    <message>
        <source>Residuals over their standard uncertainties as stated</source>
        <translation>Residuen geteilt durch ihre Standardunsicherheiten wie angegeben</translation>
    </message>
    <message>
        <source>others</source>
        <translation>weitere</translation>
    </message>
    <message>
        <source>Quantiles of the residuals</source>
        <translation>Quantile der Residuen</translation>
    </message>
    <message>
        <source>normal distribution</source>
        <translation>Normalverteilung</translation>
    </message>
    <message>
        <source>The readings cannot tell apart, and give one factor to: %1.</source>
        <translation>Nach den Ablesungen nicht zu unterscheiden, daher mit einem gemeinsamen Faktor: %1.</translation>
    </message>
    <message>
        <source>The estimate of the variance was negative, so it is zero, of: %1.</source>
        <translation>Der Schätzwert der Varianz war negativ und ist daher null, bei: %1.</translation>
    </message>
    <message>
        <source>The global test does not see that figures which are too large and figures which are too small make up for each other: %1.</source>
        <translation>Der Globaltest sieht nicht, dass zu große und zu kleine Angaben einander ausgleichen: %1.</translation>
    </message>
    <message>
        <source>seen is smaller</source>
        <translation>gesehen ist kleiner</translation>
    </message>
    <message>
        <source>seen is larger</source>
        <translation>gesehen ist größer</translation>
    </message>
    <message>
        <source>too little to say</source>
        <translation>zu wenig für ein Urteil</translation>
    </message>
    <message>
        <source>Stated and seen uncertainties</source>
        <translation>Angegebene und gesehene Unsicherheiten</translation>
    </message>
    <message>
        <source>figure</source>
        <translation>Angabe</translation>
    </message>
    <message>
        <source>stated u</source>
        <translation>angegebenes u</translation>
    </message>
    <message>
        <source>factor</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>seen u</source>
        <translation>gesehenes u</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Nothing is redundant: the readings say nothing.</source>
        <translation>Nichts ist redundant: die Ablesungen sagen nichts.</translation>
    </message>
    <message>
        <source>More than %1 readings: their factors are not computed.</source>
        <translation>Mehr als %1 Ablesungen: ihre Faktoren werden nicht berechnet.</translation>
    </message>
    <message>
        <source>The factors of the figures do not come to rest.</source>
        <translation>Die Faktoren der Angaben konvergieren nicht.</translation>
    </message>
    <message>
        <source>Global test: s₀ = %1 with %2 degrees of freedom passes (%3 to %4).</source>
        <translation>Globaltest bestanden: s₀ = %1 mit %2 Freiheitsgraden (%3 bis %4).</translation>
    </message>
    <message>
        <source>Global test: s₀ = %1 with %2 degrees of freedom fails (%3 to %4).</source>
        <translation>Globaltest nicht bestanden: s₀ = %1 mit %2 Freiheitsgraden (%3 bis %4).</translation>
    </message>
    <message>
        <source>Mean u of a coordinate: %1 as stated, %2 as seen.</source>
        <translation>Mittleres u einer Koordinate: %1 wie angegeben, %2 wie gesehen.</translation>
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
</context>
<context>
    <name>covaria::ui</name>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>„%1“ ist keine Zahl.</translation>
    </message>
    <message>
        <source>“%1” is not a unit.</source>
        <translation>„%1“ ist keine Einheit.</translation>
    </message>
    <message>
        <source>a number without unit is expected.</source>
        <translation>eine Zahl ohne Einheit wird erwartet.</translation>
    </message>
    <message>
        <source>a unit like %1 is expected.</source>
        <translation>eine Einheit wie %1 wird erwartet.</translation>
    </message>
    <message>
        <source>The unit %1 does not fit here: </source>
        <translation>Die Einheit %1 passt hier nicht: </translation>
    </message>
    <message>
        <source>“%1” is not a whole number.</source>
        <translation>„%1“ ist keine ganze Zahl.</translation>
    </message>
    <message>
        <source>“%1” is not one of: %2.</source>
        <translation>„%1“ ist keines von: %2.</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>“%1” is neither yes nor no.</source>
        <translation>„%1“ ist weder ja noch nein.</translation>
    </message>
    <message>
        <source>The value must be greater than %1.</source>
        <translation>Der Wert muss größer als %1 sein.</translation>
    </message>
    <message>
        <source>The value must be at least %1.</source>
        <translation>Der Wert muss mindestens %1 sein.</translation>
    </message>
    <message>
        <source>The value must be at most %1.</source>
        <translation>Der Wert darf höchstens %1 sein.</translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation>Freiheitsgrade</translation>
    </message>
    <message>
        <source>Unsaved Changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>Die Änderungen an „%1“ speichern?</translation>
    </message>
    <message>
        <source>Without saving they are lost.</source>
        <translation>Ohne Speichern gehen sie verloren.</translation>
    </message>
    <message>
        <source>File Changed</source>
        <translation>Datei geändert</translation>
    </message>
    <message>
        <source>Another program changed “%1”.</source>
        <translation>Ein anderes Programm hat „%1“ geändert.</translation>
    </message>
    <message>
        <source>Reading it again loses your unsaved changes.</source>
        <translation>Beim erneuten Lesen gehen Ihre nicht gespeicherten Änderungen verloren.</translation>
    </message>
    <message>
        <source>It can be read again.</source>
        <translation>Sie kann erneut gelesen werden.</translation>
    </message>
    <message>
        <source>Read Again</source>
        <translation>Erneut lesen</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>Meine behalten</translation>
    </message>
    <message>
        <source>Recover Unsaved Work</source>
        <translation>Ungespeicherte Arbeit wiederherstellen</translation>
    </message>
    <message>
        <source>Covaria did not end properly. Unsaved work was kept:</source>
        <translation>Covaria wurde nicht ordnungsgemäß beendet. Nicht gespeicherte Arbeit blieb erhalten:</translation>
    </message>
    <message>
        <source>Open Project</source>
        <translation>Projekt öffnen</translation>
    </message>
    <message>
        <source>Covaria project or report (*.covaria *.pdf)</source>
        <translation>Covaria-Projekt oder -Bericht (*.covaria *.pdf)</translation>
    </message>
    <message>
        <source>About Covaria</source>
        <translation>Über Covaria</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Covaria %1&lt;/h3&gt;&lt;p&gt;Measurement uncertainty of robots and large-scale metrology.&lt;br&gt;Evaluates by JCGM 100, 101 and 102.&lt;/p&gt;&lt;p&gt;Qt %2, VTK %3, Eigen %4&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Covaria %1&lt;/h3&gt;&lt;p&gt;Messunsicherheit in Robotik und Großraummetrologie.&lt;br&gt;Wertet nach JCGM 100, 101 und 102 aus.&lt;/p&gt;&lt;p&gt;Qt %2, VTK %3, Eigen %4&lt;/p&gt;</translation>
    </message>
    <message>
        <source>symbol</source>
        <translation>Symbol</translation>
    </message>
    <message>
        <source>As the equations use it; further rows of a symbol add components</source>
        <translation>Wie die Gleichungen es verwenden; weitere Zeilen eines Symbols fügen Komponenten hinzu</translation>
    </message>
    <message>
        <source>quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Was es ist</translation>
    </message>
    <message>
        <source>estimate</source>
        <translation>Schätzwert</translation>
    </message>
    <message>
        <source>In the row&apos;s unit: 50.000 838 or 50.000 838 mm</source>
        <translation>In der Einheit der Zeile: 50.000 838 oder 50.000 838 mm</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>stated as</source>
        <translation>angegeben als</translation>
    </message>
    <message>
        <source>distribution</source>
        <translation>Verteilung</translation>
    </message>
    <message>
        <source>That Monte Carlo draws</source>
        <translation>Die Monte Carlo zieht</translation>
    </message>
    <message>
        <source>type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Type A or Type B evaluation (JCGM 100 2.3.2, 2.3.3)</source>
        <translation>Auswertung vom Typ A oder Typ B (JCGM 100 2.3.2, 2.3.3)</translation>
    </message>
    <message>
        <source>Degrees of freedom; empty: infinite, or those of the observations</source>
        <translation>Freiheitsgrade; leer: unendlich oder die der Beobachtungen</translation>
    </message>
    <message>
        <source>Standard uncertainty, in the row&apos;s unit</source>
        <translation>Standardunsicherheit, in der Einheit der Zeile</translation>
    </message>
    <message>
        <source>Sensitivity coefficient, unit of the result per unit of the row</source>
        <translation>Sensitivitätskoeffizient, Einheit des Ergebnisses je Einheit der Zeile</translation>
    </message>
    <message>
        <source>Contribution to the standard uncertainty of the result</source>
        <translation>Beitrag zur Standardunsicherheit des Ergebnisses</translation>
    </message>
    <message>
        <source>share / %</source>
        <translation>Anteil / %</translation>
    </message>
    <message>
        <source>Share of the variance, with its part of the covariances</source>
        <translation>Anteil an der Varianz, mit seinem Teil der Kovarianzen</translation>
    </message>
    <message>
        <source>source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Where the figure comes from</source>
        <translation>Woher die Zahl stammt</translation>
    </message>
    <message>
        <source>Standard uncertainty of the position in space: square root of the sum of the variances of its three coordinates</source>
        <translation>Standardunsicherheit der Position im Raum: Quadratwurzel aus der Summe der Varianzen ihrer drei Koordinaten</translation>
    </message>
    <message>
        <source>, as good as %1 plain trials</source>
        <translation>, so gut wie %1 gewöhnliche Versuche</translation>
    </message>
    <message>
        <source>Preview by the law of propagation, without Monte Carlo</source>
        <translation>Vorschau nach dem Fortpflanzungsgesetz, ohne Monte Carlo</translation>
    </message>
    <message>
        <source>Preview with %1 trials, before the adaptive procedure</source>
        <translation>Vorschau mit %1 Versuchen, vor dem adaptiven Verfahren</translation>
    </message>
    <message>
        <source>Preview with %1 of %2 trials</source>
        <translation>Vorschau mit %1 von %2 Versuchen</translation>
    </message>
    <message>
        <source>Law of propagation of uncertainty</source>
        <translation>Fortpflanzungsgesetz der Unsicherheit</translation>
    </message>
    <message>
        <source>Monte Carlo, %1 trials</source>
        <translation>Monte Carlo, %1 Versuche</translation>
    </message>
    <message>
        <source>Out of date: of the project as it was</source>
        <translation>Veraltet: vom früheren Stand des Projekts</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>%1 duplizieren</translation>
    </message>
    <message>
        <source>Expanded uncertainty</source>
        <translation>Erweiterte Unsicherheit</translation>
    </message>
    <message>
        <source>the picture shows no result of the analysis</source>
        <translation>das Bild kein Ergebnis der Analyse zeigt</translation>
    </message>
    <message>
        <source>the coordinates of %1 are no quantities of the analysis</source>
        <translation>die Koordinaten von %1 keine Größen der Analyse sind</translation>
    </message>
    <message>
        <source>%1 is a constant: no uncertainty is stated for it</source>
        <translation>%1 konstant ist: es ist keine Unsicherheit dafür angegeben</translation>
    </message>
    <message>
        <source>the joint covariance of the points is not known</source>
        <translation>die gemeinsame Kovarianz der Punkte nicht bekannt ist</translation>
    </message>
    <message>
        <source>the angle is too close to 0° or 180°, or the points are too close, for the law of propagation</source>
        <translation>der Winkel für das Fortpflanzungsgesetz zu nahe bei 0° oder 180° ist oder die Punkte zu nahe beieinander liegen</translation>
    </message>
    <message>
        <source>the points are too close to each other for the law of propagation</source>
        <translation>die Punkte für das Fortpflanzungsgesetz zu nahe beieinander liegen</translation>
    </message>
    <message>
        <source>%1, u = %2</source>
        <translation>%1, u = %2</translation>
    </message>
    <message>
        <source>Angle at %1 between %2 and %3: %4</source>
        <translation>Winkel bei %1 zwischen %2 und %3: %4</translation>
    </message>
    <message>
        <source>Distance %1 to %2: %3</source>
        <translation>Abstand von %1 bis %2: %3</translation>
    </message>
    <message>
        <source>; u not stated, because %1</source>
        <translation>; u nicht angegeben, weil %1</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isometrisch</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Add an analysis</source>
        <translation>Eine Analyse hinzufügen</translation>
    </message>
    <message>
        <source>The plus sign in the toolbar adds what a project consists of. Choose Measurement equation from its menu.</source>
        <translation>Das Pluszeichen in der Werkzeugleiste fügt hinzu, woraus ein Projekt besteht. Wählen Sie in seinem Menü Messgleichung.</translation>
    </message>
    <message>
        <source>Name the quantities</source>
        <translation>Die Größen benennen</translation>
    </message>
    <message>
        <source>Replace the equation in the field Equations by yours, such as l = l_S + d. Every name that it uses becomes a row of the budget when you leave the field.</source>
        <translation>Ersetzen Sie die Gleichung im Feld Gleichungen durch Ihre, etwa l = l_S + d. Jeder Name darin wird eine Zeile des Budgets, sobald Sie das Feld verlassen.</translation>
    </message>
    <message>
        <source>State an uncertainty</source>
        <translation>Eine Unsicherheit angeben</translation>
    </message>
    <message>
        <source>Type the estimate of each quantity into its row, such as 50 mm, and what is known of it under “stated as”, such as 75 nm. “rect 30 nm” and “U = 0.3 um, k = 2” are read as they are typed.</source>
        <translation>Tippen Sie den Schätzwert jeder Größe in ihre Zeile, etwa 50 mm, und was man von ihr weiß unter „angegeben als“, etwa 75 nm. „rect 30 nm“ und „U = 0.3 um, k = 2“ werden so gelesen, wie sie getippt sind.</translation>
    </message>
    <message>
        <source>See the result</source>
        <translation>Das Ergebnis sehen</translation>
    </message>
    <message>
        <source>Correlate two quantities</source>
        <translation>Zwei Größen korrelieren</translation>
    </message>
    <message>
        <source>Select two rows of the budget, the second with Ctrl, and type their correlation coefficient r into the field below, such as 0.5. The result takes it into account at once.</source>
        <translation>Wählen Sie zwei Zeilen des Budgets, die zweite mit Strg, und tippen Sie ihren Korrelationskoeffizienten r in das Feld darunter, etwa 0.5. Das Ergebnis berücksichtigt ihn sofort.</translation>
    </message>
    <message>
        <source>State a requirement</source>
        <translation>Eine Anforderung angeben</translation>
    </message>
    <message>
        <source>Type the uncertainty that must not be exceeded as Target uncertainty. The verdict below it, and in the table of results, follows every change.</source>
        <translation>Tippen Sie die Unsicherheit, die nicht überschritten werden darf, als Zielunsicherheit ein. Das Urteil darunter und in der Ergebnistabelle folgt jeder Änderung.</translation>
    </message>
    <message>
        <source>See what contributes most</source>
        <translation>Sehen, was am meisten beiträgt</translation>
    </message>
    <message>
        <source>Keep and compare</source>
        <translation>Merken und vergleichen</translation>
    </message>
    <message>
        <source>Run the analysis (F5), press Keep as Before, and change a value of the budget. The tab Compare shows the results before and after beside each other.</source>
        <translation>Rechnen Sie die Analyse (F5), drücken Sie Stand merken, und ändern Sie einen Wert des Budgets. Der Reiter Vergleich zeigt die Ergebnisse vorher und nachher nebeneinander.</translation>
    </message>
    <message>
        <source>Look at the report</source>
        <translation>Den Bericht ansehen</translation>
    </message>
    <message>
        <source>Save it as PDF</source>
        <translation>Als PDF speichern</translation>
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
        <translation># Tasten

| Taste | Wirkung |
|---|---|
| Strg+N, Strg+O, Strg+S | neu, öffnen, speichern |
| Strg+Z; Strg+Umschalt+Z oder Strg+Y | rückgängig; wiederholen |
| F6, Umschalt+F6 | nächster, voriger Bereich |
| F11 | das Budget oder die Szene allein, und zurück |
| Tab, Umschalt+Tab in einer Tabelle | nächste, vorige Zelle, und hinter der letzten weiter; mit Strg sofort aus der Tabelle |
| Strg+R in einem Budget | Korrelationskoeffizient der beiden gewählten Zeilen |
| F5, Strg+F5, Esc | diese Analyse rechnen, alle rechnen, anhalten |
| F2, Strg+D, Entf | gewählten Eintrag umbenennen, verdoppeln, löschen |
| Pfeiltasten, + und − | Szene drehen und vergrößern |
| 1 bis 7, F | isometrisch, oben, vorn, rechts, unten, hinten, links, einpassen (Strg+1 bis Strg+7 überall) |
| H, I, Umschalt+H | das in der Szene Gewählte ausblenden, nur dieses zeigen, alles zeigen |
| Ziehen in der Szene | verschiebt ein Ding, dreht es an der Spitze einer Achse; mit Strg in runden Schritten |
| D, A | Abstand, Winkel in der Szene messen; Esc legt das Werkzeug weg |
| +, −, Strg+Rad im Bericht | größere, kleinere Seiten; Alt+Auf und Alt+Ab: vorige, nächste Seite |
| Strg+C, Strg+V | Blöcke von Zellen kopieren und einfügen |
| Strg+K | alles finden: Analysen, Größen, Ergebnisse, Felder, Befehle, Hilfe |
| F1 | Hilfe zu Feld, Zelle oder Eintrag mit dem Fokus |
</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>The analysis is not complete yet: what must still be given is listed under Problems.</source>
        <translation>Die Analyse ist noch nicht vollständig: was noch anzugeben ist, steht unter „Probleme“.</translation>
    </message>
    <message>
        <source>The analysis has problems; they are listed under Problems.</source>
        <translation>Die Analyse hat Probleme; sie stehen unter „Probleme“.</translation>
    </message>
    <message>
        <source>Adaptive Monte Carlo, %1 trials</source>
        <translation>Adaptives Monte Carlo, %1 Versuche</translation>
    </message>
    <message>
        <source>; k leaves degrees of freedom out (normal draws)</source>
        <translation>; k ohne Freiheitsgrade (normalverteilt gezogen)</translation>
    </message>
    <message>
        <source>, chosen k = %1</source>
        <translation>, k = %1 gewählt</translation>
    </message>
    <message>
        <source>Of the estimate, and of what is stated without a unit</source>
        <translation>Des Schätzwerts und dessen, was ohne Einheit angegeben ist</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>Rückgängig gemacht: %1</translation>
    </message>
    <message>
        <source>Before these steps</source>
        <translation>Vor diesen Schritten</translation>
    </message>
    <message>
        <source>Undo Lis&amp;t</source>
        <translation>Liste der &amp;Schritte</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Done again: %1</source>
        <translation>Wiederholt: %1</translation>
    </message>
    <message>
        <source>Type it as %1.</source>
        <translation>Schreiben Sie es als %1.</translation>
    </message>
    <message>
        <source>Type it as %1, or as %2.</source>
        <translation>Schreiben Sie es als %1 oder als %2.</translation>
    </message>
    <message>
        <source>met</source>
        <translation>eingehalten</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>nicht eingehalten</translation>
    </message>
    <message>
        <source>The result is there when every quantity has its uncertainty, above the budget and in the tab Results. It follows every change at once.</source>
        <translation>Das Ergebnis ist da, sobald jede Größe ihre Unsicherheit hat, über dem Budget und im Reiter Ergebnisse. Es folgt jeder Änderung sofort.</translation>
    </message>
    <message>
        <source>The tab Contributions has them as a table and as a chart, the largest first. What is at the top is worth improving.</source>
        <translation>Der Reiter Beiträge zeigt sie als Tabelle und als Diagramm, die größten zuerst. Was oben steht, lohnt die Verbesserung.</translation>
    </message>
    <message>
        <source>The tab Document shows the pages as they are printed, of the report or of the certificate. It has results that are up to date only: run the analysis first (F5).</source>
        <translation>Der Reiter Dokument zeigt die Seiten, wie sie gedruckt werden, die des Berichts oder des Kalibrierscheins. Er enthält nur aktuelle Ergebnisse: Führen Sie zuerst die Analyse aus (F5).</translation>
    </message>
    <message>
        <source>Report as PDF in the toolbar (Ctrl+P) writes the report with the project in it, so that Covaria can open it again. While the tab Document shows the certificate, the button writes that; it is also in the menu File under Export.</source>
        <translation>Bericht als PDF in der Werkzeugleiste (Strg+P) schreibt den Bericht mit dem Projekt darin, so dass Covaria es wieder öffnen kann. Solange der Reiter Dokument den Kalibrierschein zeigt, schreibt die Schaltfläche diesen; er ist auch im Menü Datei unter Exportieren.</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>veraltet</translation>
    </message>
</context>
<context>
    <name>covaria::ui::AllResultsModel</name>
    <message>
        <source>Analysis</source>
        <translation>Analyse</translation>
    </message>
    <message>
        <source>Coverage interval of the result line</source>
        <translation>Überdeckungsintervall der Ergebniszeile</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Double click: goes to the analysis</source>
        <translation>Doppelklick: zur Analyse</translation>
    </message>
</context>
<context>
    <name>covaria::ui::AllResultsTab</name>
    <message>
        <source>Filter: analysis, symbol, name, group</source>
        <translation>Filter: Analyse, Symbol, Name, Gruppe</translation>
    </message>
    <message>
        <source>Filter of all results</source>
        <translation>Filter aller Ergebnisse</translation>
    </message>
    <message>
        <source>Not met only</source>
        <translation>Nur nicht eingehaltene</translation>
    </message>
    <message>
        <source>Only results whose target uncertainty or tolerance is not met</source>
        <translation>Nur Ergebnisse, deren Zielunsicherheit oder Toleranz nicht eingehalten ist</translation>
    </message>
    <message>
        <source>all-results</source>
        <translation>alle-ergebnisse</translation>
    </message>
    <message>
        <source>up to date</source>
        <translation>aktuell</translation>
    </message>
    <message>
        <source>%1 of %2 requirements met</source>
        <translation>%1 von %2 Anforderungen eingehalten</translation>
    </message>
    <message>
        <source>%1 of %2 analyses have no result: press Ctrl+F5</source>
        <translation>%1 von %2 Analysen haben kein Ergebnis: Strg+F5 drücken</translation>
    </message>
    <message>
        <source>; </source>
        <translation>; </translation>
    </message>
    <message>
        <source>%1 of %2 analyses have no result: they lack something or have problems</source>
        <translation>%1 von %2 Analysen haben kein Ergebnis: Ihnen fehlt etwas, oder sie haben Probleme</translation>
    </message>
</context>
<context>
    <name>covaria::ui::AnswerStrip</name>
    <message>
        <source>Answer</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Output quantity of the budget and the charts</source>
        <translation>Ausgangsgröße des Budgets und der Diagramme</translation>
    </message>
    <message>
        <source>Output quantity</source>
        <translation>Ausgangsgröße</translation>
    </message>
    <message>
        <source>Copy the result, as it stands in a certificate</source>
        <translation>Das Ergebnis kopieren, wie es in einem Kalibrierschein steht</translation>
    </message>
    <message>
        <source>Copy the result</source>
        <translation>Das Ergebnis kopieren</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Nächster Schritt</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>incomplete</source>
        <translation>unvollständig</translation>
    </message>
    <message>
        <source>has problems</source>
        <translation>hat Probleme</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>veraltet</translation>
    </message>
    <message>
        <source>not evaluated</source>
        <translation>nicht ausgewertet</translation>
    </message>
    <message>
        <source>Select an analysis to see its results.</source>
        <translation>Eine Analyse auswählen, um ihre Ergebnisse zu sehen.</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Fehlgeschlagen: %1</translation>
    </message>
    <message>
        <source>Not complete yet: nothing is wrong.</source>
        <translation>Noch nicht vollständig: Nichts ist falsch.</translation>
    </message>
    <message>
        <source>Not complete yet, but not wrong; to give next: %1</source>
        <translation>Noch nicht vollständig, aber nicht falsch; als Nächstes anzugeben: %1</translation>
    </message>
    <message>
        <source>Not evaluated yet: press F5.</source>
        <translation>Noch nicht ausgewertet: F5 drücken.</translation>
    </message>
    <message>
        <source>The analysis has problems.</source>
        <translation>Die Analyse hat Probleme.</translation>
    </message>
    <message>
        <source>; running</source>
        <translation>; läuft</translation>
    </message>
    <message>
        <source>; press F5 for the result</source>
        <translation>; F5 drücken für das Ergebnis</translation>
    </message>
    <message>
        <source>; %1 trials without a value</source>
        <translation>; %1 Versuche ohne Wert</translation>
    </message>
    <message>
        <source>&lt;b&gt;Does not represent the measurand&lt;/b&gt; (more than 1 % of the trials are lost). </source>
        <translation>&lt;b&gt;Stellt die Messgröße nicht dar&lt;/b&gt; (mehr als 1 % der Versuche gingen verloren). </translation>
    </message>
    <message>
        <source>; not stabilised</source>
        <translation>; nicht stabilisiert</translation>
    </message>
    <message>
        <source>&lt;b&gt;Out of date&lt;/b&gt;: shown for the project as it was. </source>
        <translation>&lt;b&gt;Veraltet&lt;/b&gt;: gezeigt für den früheren Stand des Projekts. </translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Weiter: %1</translation>
    </message>
    <message>
        <source>Goes to the field that must be given next</source>
        <translation>Geht zu dem Feld, das als Nächstes anzugeben ist</translation>
    </message>
</context>
<context>
    <name>covaria::ui::AssetEvaluation</name>
    <message>
        <source>The asset has problems; they are listed below the scene.</source>
        <translation>Das Betriebsmittel hat Probleme; sie sind unter der Szene aufgeführt.</translation>
    </message>
    <message>
        <source>This asset is used as it is specified; nothing is evaluated.</source>
        <translation>Dieses Betriebsmittel wird wie spezifiziert verwendet; nichts wird ausgewertet.</translation>
    </message>
    <message>
        <source>Evaluation of the asset</source>
        <translation>Auswertung des Betriebsmittels</translation>
    </message>
</context>
<context>
    <name>covaria::ui::BudgetPage</name>
    <message>
        <source>Correlation coefficient</source>
        <translation>Korrelationskoeffizient</translation>
    </message>
    <message>
        <source>Select two rows, and type the correlation coefficient of their components</source>
        <translation>Zwei Zeilen auswählen und den Korrelationskoeffizienten ihrer Komponenten eingeben</translation>
    </message>
    <message>
        <source>Budget</source>
        <translation>Budget</translation>
    </message>
    <message>
        <source>&lt;i&gt;r&lt;/i&gt; of two rows =</source>
        <translation>&lt;i&gt;r&lt;/i&gt; zweier Zeilen =</translation>
    </message>
    <message>
        <source>Correlation of Two Rows</source>
        <translation>Korrelation zweier Zeilen</translation>
    </message>
    <message>
        <source>&lt;i&gt;r&lt;/i&gt;(%1, %2) =</source>
        <translation>&lt;i&gt;r&lt;/i&gt;(%1, %2) =</translation>
    </message>
    <message>
        <source>Both quantities need an uncertainty before they can be correlated</source>
        <translation>Beide Größen brauchen eine Unsicherheit, bevor sie korreliert werden können</translation>
    </message>
    <message>
        <source>c and share by the law of propagation, whose u is %1 of that by Monte Carlo</source>
        <translation>c und Anteil nach dem Fortpflanzungsgesetz, dessen u %1 von dem nach Monte Carlo beträgt</translation>
    </message>
</context>
<context>
    <name>covaria::ui::BudgetSheetModel</name>
    <message>
        <source>Out of date: being computed.</source>
        <translation>Veraltet: wird berechnet.</translation>
    </message>
    <message>
        <source>Type a name here to add a quantity</source>
        <translation>Hier einen Namen eingeben, um eine Größe hinzuzufügen</translation>
    </message>
    <message>
        <source>“%1” is not a number of degrees of freedom.</source>
        <translation>„%1“ ist keine Anzahl von Freiheitsgraden.</translation>
    </message>
    <message>
        <source>Name the quantity before its observations.</source>
        <translation>Der Größe zuerst ein Symbol geben, dann ihre Beobachtungen.</translation>
    </message>
    <message>
        <source>The observations are read from %1.</source>
        <translation>Die Beobachtungen werden aus %1 gelesen.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::BudgetSheetView</name>
    <message>
        <source>Show Quantity</source>
        <translation>Größe zeigen</translation>
    </message>
    <message>
        <source>Its components, observations, correlations and notes</source>
        <translation>Ihre Komponenten, Beobachtungen, Korrelationen und Notizen</translation>
    </message>
</context>
<context>
    <name>covaria::ui::BudgetTableModel</name>
    <message>
        <source>An estimate by sampling with a standard error of %1 %: S can exceed S total by chance</source>
        <translation>Durch Stichproben geschätzt, Standardfehler %1 %: S kann S total durch Zufall übersteigen</translation>
    </message>
</context>
<context>
    <name>covaria::ui::CertificateForm</name>
    <message>
        <source>Required by %1.</source>
        <translation>Von %1 gefordert.</translation>
    </message>
    <message>
        <source>Asked for by %1 where it applies.</source>
        <translation>Von %1 verlangt, wo es zutrifft.</translation>
    </message>
    <message>
        <source>Next Missing</source>
        <translation>Nächstes fehlendes</translation>
    </message>
    <message>
        <source>What the certificate lacks</source>
        <translation>Was dem Kalibrierschein fehlt</translation>
    </message>
    <message>
        <source>Goes to the next field that %1 requires and that is empty</source>
        <translation>Geht zum nächsten leeren Feld, das %1 fordert</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>Everything that %1 requires beside the results is stated.</source>
        <translation>Alles, was %1 neben den Ergebnissen fordert, ist angegeben.</translation>
    </message>
    <message>
        <source>For File › Export › Certificate. A clause of %1 stands where it requires something; a report needs none of it.</source>
        <translation>Für Datei › Exportieren › Kalibrierschein. Ein Abschnitt von %1 steht, wo er etwas fordert; ein Bericht braucht nichts davon.</translation>
    </message>
    <message>
        <source>%1 of %2 required texts are stated; missing: %3.</source>
        <translation>%1 von %2 geforderten Texten sind angegeben; es fehlen: %3.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg)</source>
        <translation>Bilder (*.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>English (none chosen)</source>
        <translation>Englisch (keine gewählt)</translation>
    </message>
    <message>
        <source>Required by %1 where conformity is stated.</source>
        <translation>Verlangt von %1, wo Konformität ausgesagt wird.</translation>
    </message>
    <message>
        <source>in the laboratory, or at the place stated</source>
        <translation>im Laboratorium oder am angegebenen Ort</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ChartView</name>
    <message>
        <source>Run the analysis to see this chart</source>
        <translation>Analyse ausführen, um dieses Diagramm zu sehen</translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation>%1-Dateien (*.%2)</translation>
    </message>
    <message>
        <source>Save Chart</source>
        <translation>Diagramm speichern</translation>
    </message>
    <message>
        <source>Show All</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Copy Picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Copy Data</source>
        <translation>Daten kopieren</translation>
    </message>
    <message>
        <source>Save as %1 …</source>
        <translation>Als %1 speichern …</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ColumnTableModel</name>
    <message>
        <source>Out of date: the project has changed since.</source>
        <translation>Veraltet: Das Projekt hat sich seither geändert.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::CompareTab</name>
    <message>
        <source>Keep as Before</source>
        <translation>Stand merken</translation>
    </message>
    <message>
        <source>Keeps the present results of this analysis, to compare later ones with</source>
        <translation>Behält die jetzigen Ergebnisse dieser Analyse, um spätere mit ihnen zu vergleichen</translation>
    </message>
    <message>
        <source>Go Back to Kept State</source>
        <translation>Zum gemerkten Stand zurück</translation>
    </message>
    <message>
        <source>Discard Kept State</source>
        <translation>Gemerkten Stand verwerfen</translation>
    </message>
    <message>
        <source>Forgets the kept results; the project stays as it is now</source>
        <translation>Vergisst die gemerkten Ergebnisse; das Projekt bleibt, wie es jetzt ist</translation>
    </message>
    <message>
        <source>comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>budget-changes</source>
        <translation>Budget-Änderungen</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Diagramm</translation>
    </message>
    <message>
        <source>Distributions</source>
        <translation>Verteilungen</translation>
    </message>
    <message>
        <source>Changes of the budget</source>
        <translation>Änderungen des Budgets</translation>
    </message>
    <message>
        <source>The results are kept: the tab Compare shows them beside those to come.</source>
        <translation>Die Ergebnisse sind gemerkt: Der Reiter Vergleich zeigt sie neben den kommenden.</translation>
    </message>
    <message>
        <source>Go back to kept state</source>
        <translation>Zum gemerkten Stand zurück</translation>
    </message>
    <message>
        <source>Select an analysis to compare its results.</source>
        <translation>Eine Analyse auswählen, um ihre Ergebnisse zu vergleichen.</translation>
    </message>
    <message>
        <source>Before: %1, kept at %2. </source>
        <translation>Vorher: %1, gemerkt um %2. </translation>
    </message>
    <message>
        <source>After: no results.</source>
        <translation>Nachher: keine Ergebnisse.</translation>
    </message>
    <message>
        <source>After: %1</source>
        <translation>Nachher: %1</translation>
    </message>
    <message>
        <source>Go Back to Kept</source>
        <translation>Zum gemerkten Stand zurück</translation>
    </message>
    <message>
        <source>Discard Kept</source>
        <translation>Gemerkten Stand verwerfen</translation>
    </message>
    <message>
        <source>The present results are kept in place of those kept before.</source>
        <translation>Die jetzigen Ergebnisse sind anstelle der zuvor gemerkten gemerkt.</translation>
    </message>
    <message>
        <source>Replace Kept State</source>
        <translation>Gemerkten Stand ersetzen</translation>
    </message>
    <message>
        <source>Keeps the present results in place of those kept before, which are forgotten</source>
        <translation>Merkt die jetzigen Ergebnisse anstelle der zuvor gemerkten, die vergessen werden</translation>
    </message>
    <message>
        <source>Run the analysis (F5), then keep its results with “%1”.</source>
        <translation>Die Analyse ausführen (F5), dann ihren Stand mit „%1“ festhalten.</translation>
    </message>
    <message>
        <source>results that are computed again once the analysis has run</source>
        <translation>Ergebnisse, die neu berechnet werden, sobald die Analyse gelaufen ist</translation>
    </message>
    <message>
        <source>Compare With Another Project</source>
        <translation>Mit einem anderen Projekt vergleichen</translation>
    </message>
    <message>
        <source>Covaria project (*.covaria)</source>
        <translation>Covaria-Projekt (*.covaria)</translation>
    </message>
    <message>
        <source>Analysis of that project:</source>
        <translation>Analyse jenes Projekts:</translation>
    </message>
    <message>
        <source>Compare With</source>
        <translation>Vergleichen mit</translation>
    </message>
    <message>
        <source>Another analysis, of this project or of another one, stands in the place of kept results</source>
        <translation>Eine andere Analyse, dieses oder eines anderen Projekts, steht an der Stelle gemerkter Ergebnisse</translation>
    </message>
    <message>
        <source>Another Project …</source>
        <translation>Anderes Projekt …</translation>
    </message>
    <message>
        <source>%1 has no analysis.</source>
        <translation>%1 hat keine Analyse.</translation>
    </message>
    <message>
        <source>The tab Compare shows %1 as before.</source>
        <translation>Der Reiter Vergleich zeigt %1 als Vorher.</translation>
    </message>
    <message>
        <source>Keep the present results with “%1” and edit, or choose another analysis by “%2”: before and after stand here beside each other.</source>
        <translation>Merken Sie die jetzigen Ergebnisse mit „%1“ und ändern Sie etwas, oder wählen Sie mit „%2“ eine andere Analyse: Vorher und Nachher stehen hier nebeneinander.</translation>
    </message>
    <message>
        <source>Before: %1 (%2), taken at %3. </source>
        <translation>Vorher: %1 (%2), übernommen %3. </translation>
    </message>
    <message>
        <source>Makes the analysis, and what it uses, what they were when the results were kept, and the coverage factor of the project; can be undone</source>
        <translation>Macht die Analyse und was sie verwendet zu dem, was sie waren, als die Ergebnisse gemerkt wurden, auch den Erweiterungsfaktor des Projekts; lässt sich rückgängig machen</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ComponentsEdit</name>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Components of uncertainty</source>
        <translation>Unsicherheitskomponenten</translation>
    </message>
    <message>
        <source>Name of the component</source>
        <translation>Name der Komponente</translation>
    </message>
    <message>
        <source>Type of evaluation</source>
        <translation>Art der Auswertung</translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation>Freiheitsgrade</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Herkunft</translation>
    </message>
    <message>
        <source>Back to the components that the model gives</source>
        <translation>Zurück zu den Komponenten, die das Modell liefert</translation>
    </message>
    <message>
        <source>Type A (from observations)</source>
        <translation>Typ A (aus Beobachtungen)</translation>
    </message>
    <message>
        <source>Type B (other means)</source>
        <translation>Typ B (auf andere Weise)</translation>
    </message>
    <message>
        <source>Degrees of freedom of the standard uncertainty; empty: infinitely many.</source>
        <translation>Freiheitsgrade der Standardunsicherheit; leer: unendlich viele.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Change component of %1</source>
        <translation>Komponente von %1 ändern</translation>
    </message>
    <message>
        <source>component %1</source>
        <translation>Komponente %1</translation>
    </message>
    <message>
        <source>Add component to %1</source>
        <translation>Komponente zu %1 hinzufügen</translation>
    </message>
    <message>
        <source>Remove component of %1</source>
        <translation>Komponente von %1 entfernen</translation>
    </message>
    <message>
        <source>Reset components of %1</source>
        <translation>Komponenten von %1 zurücksetzen</translation>
    </message>
    <message>
        <source>Its uncertainty comes from another analysis.</source>
        <translation>Ihre Unsicherheit kommt aus einer anderen Analyse.</translation>
    </message>
    <message>
        <source>Components that it shares with other quantities are edited where they are stated.</source>
        <translation>Komponenten, die sie mit anderen Größen teilt, werden dort bearbeitet, wo sie angegeben sind.</translation>
    </message>
    <message>
        <source>It has no component of uncertainty yet.</source>
        <translation>Die Größe hat noch keine Unsicherheitskomponente.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::CorrelationEdit</name>
    <message>
        <source>Add to the matrix</source>
        <translation>Zur Matrix hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Correlation coefficients between components of uncertainty</source>
        <translation>Korrelationskoeffizienten zwischen Unsicherheitskomponenten</translation>
    </message>
    <message>
        <source>Component of uncertainty</source>
        <translation>Unsicherheitskomponente</translation>
    </message>
    <message>
        <source>All components are uncorrelated. Add those that are correlated to the matrix.</source>
        <translation>Alle Komponenten sind unkorreliert. Korrelierte zur Matrix hinzufügen.</translation>
    </message>
    <message>
        <source>The coefficients are possible together (positive semi-definite). Monte Carlo draws them with a Gaussian copula: exact for normal distributions, nearly so for others.</source>
        <translation>Die Koeffizienten sind zusammen möglich (positiv semidefinit). Monte Carlo zieht sie mit einer Gauß-Copula: exakt für Normalverteilungen, nahezu exakt für andere.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::CorrelationTableModel</name>
    <message>
        <source>Correlation of %1 with %2</source>
        <translation>Korrelation von %1 mit %2</translation>
    </message>
</context>
<context>
    <name>covaria::ui::CsvImportDialog</name>
    <message>
        <source>Import %1 into %2</source>
        <translation>%1 in %2 importieren</translation>
    </message>
    <message>
        <source>found by itself</source>
        <translation>selbst erkannt</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>Komma</translation>
    </message>
    <message>
        <source>semicolon</source>
        <translation>Semikolon</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>Tabulator</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>&amp;Separator of cells</source>
        <translation>&amp;Trennzeichen der Zellen</translation>
    </message>
    <message>
        <source>Column of the file</source>
        <translation>Spalte der Datei</translation>
    </message>
    <message>
        <source>is read as</source>
        <translation>wird gelesen als</translation>
    </message>
    <message>
        <source>Columns of the file</source>
        <translation>Spalten der Datei</translation>
    </message>
    <message>
        <source>Column %1 is read as</source>
        <translation>Spalte %1 wird gelesen als</translation>
    </message>
    <message>
        <source>as it is named</source>
        <translation>wie benannt</translation>
    </message>
    <message>
        <source>unknown: choose</source>
        <translation>unbekannt: wählen</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>nicht gelesen</translation>
    </message>
    <message>
        <source>The file cannot be imported: %1.</source>
        <translation>Die Datei kann nicht importiert werden: %1.</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s).</source>
        <translation>
            <numerusform>%n Zeile(n).</numerusform>
            <numerusform>%n Zeile(n).</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more problem(s).</source>
        <translation>
            <numerusform>%n weitere(s) Problem(e).</numerusform>
            <numerusform>%n weitere(s) Problem(e).</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>covaria::ui::DateEditor</name>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>%1, last day</source>
        <translation>%1, letzter Tag</translation>
    </message>
    <message>
        <source>Choose from a calendar</source>
        <translation>Aus einem Kalender wählen</translation>
    </message>
    <message>
        <source>“%1” is no date of the form 2026-04-17.</source>
        <translation>„%1“ ist kein Datum der Form 2026-04-17.</translation>
    </message>
    <message>
        <source>The first day is missing.</source>
        <translation>Der erste Tag fehlt.</translation>
    </message>
    <message>
        <source>The last day is before the first.</source>
        <translation>Der letzte Tag liegt vor dem ersten.</translation>
    </message>
    <message>
        <source>the same day</source>
        <translation>derselbe Tag</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DensityPicture</name>
    <message>
        <source>Density of the distribution</source>
        <translation>Dichte der Verteilung</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DesignBoxList</name>
    <message>
        <source>Add Box</source>
        <translation>Quader hinzufügen</translation>
    </message>
    <message>
        <source>To, %1</source>
        <translation>Bis, %1</translation>
    </message>
    <message>
        <source>From, %1</source>
        <translation>Von, %1</translation>
    </message>
    <message>
        <source>Name of the box</source>
        <translation>Name des Quaders</translation>
    </message>
    <message>
        <source>name, such as pillar</source>
        <translation>Name, etwa Säule</translation>
    </message>
    <message>
        <source>Remove Box</source>
        <translation>Quader entfernen</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DesignReductionList</name>
    <message>
        <source>Add Reduction</source>
        <translation>Verringerung hinzufügen</translation>
    </message>
    <message>
        <source>One more uncertainty that can be made smaller for money</source>
        <translation>Eine weitere Unsicherheit, die sich für Geld verkleinern lässt</translation>
    </message>
    <message>
        <source>Smallest factor</source>
        <translation>Kleinster Faktor</translation>
    </message>
    <message>
        <source>The smallest factor that can be had, between 0 and 1</source>
        <translation>Der kleinste Faktor, der zu haben ist, zwischen 0 und 1</translation>
    </message>
    <message>
        <source>Price of the first halving</source>
        <translation>Preis der ersten Halbierung</translation>
    </message>
    <message>
        <source>Law of the price</source>
        <translation>Preisgesetz</translation>
    </message>
    <message>
        <source>price (1/f − 1)</source>
        <translation>Preis (1/f − 1)</translation>
    </message>
    <message>
        <source>price (1/f² − 1)/3: further readings</source>
        <translation>Preis (1/f² − 1)/3: weitere Ablesungen</translation>
    </message>
    <message>
        <source>price log₂(1/f): every halving the same</source>
        <translation>Preis log₂(1/f): jede Halbierung gleich</translation>
    </message>
    <message>
        <source>Remove Reduction</source>
        <translation>Verringerung entfernen</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>Reduziert</translation>
    </message>
    <message>
        <source>Least factor</source>
        <translation>Kleinster Faktor</translation>
    </message>
    <message>
        <source>First halving</source>
        <translation>Erste Halbierung</translation>
    </message>
    <message>
        <source>A factor f costs</source>
        <translation>Ein Faktor f kostet</translation>
    </message>
    <message>
        <source>choose what is reduced</source>
        <translation>wählen, was reduziert wird</translation>
    </message>
    <message>
        <source>Reductions</source>
        <translation>Verringerungen</translation>
    </message>
    <message>
        <source>Each has a price; they take the place of variables and rows.</source>
        <translation>Jede hat einen Preis; sie treten an die Stelle von Variablen und Zeilen.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DesignTab</name>
    <message>
        <source>Design</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Design of this analysis</source>
        <translation>Entwurf dieser Analyse</translation>
    </message>
    <message>
        <source>Run Design</source>
        <translation>Entwurf ausführen</translation>
    </message>
    <message>
        <source>Searches for the best design</source>
        <translation>Sucht den besten Entwurf</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stops the search (Esc)</source>
        <translation>Hält die Suche an (Esc)</translation>
    </message>
    <message>
        <source>Edit …</source>
        <translation>Bearbeiten …</translation>
    </message>
    <message>
        <source>Variables, rows and objective of the design, in the properties of the analysis</source>
        <translation>Variablen, Zeilen und Ziel des Entwurfs, in den Eigenschaften der Analyse</translation>
    </message>
    <message>
        <source>Take Over This Design</source>
        <translation>Diesen Entwurf übernehmen</translation>
    </message>
    <message>
        <source>Puts the values and rows that were found into the project; can be undone</source>
        <translation>Setzt die gefundenen Werte und Zeilen in das Projekt ein; kann rückgängig gemacht werden</translation>
    </message>
    <message>
        <source>Add Design …</source>
        <translation>Entwurf hinzufügen …</translation>
    </message>
    <message>
        <source> – out of date</source>
        <translation> – veraltet</translation>
    </message>
    <message>
        <source>%1 of %2 evaluations</source>
        <translation>%1 von %2 Auswertungen</translation>
    </message>
    <message>
        <source>, best so far %1</source>
        <translation>, bisher bester %1</translation>
    </message>
    <message>
        <source>searching …</source>
        <translation>wird gesucht …</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Fehlgeschlagen: %1</translation>
    </message>
    <message>
        <source>Not searched yet.</source>
        <translation>Noch nicht gesucht.</translation>
    </message>
    <message>
        <source>Nothing that was tried has a result.</source>
        <translation>Nichts des Versuchten hat ein Ergebnis.</translation>
    </message>
    <message>
        <source>The cheapest reductions cost %1</source>
        <translation>Die billigsten Verringerungen kosten %1</translation>
    </message>
    <message>
        <source>The cheapest rows cost %1</source>
        <translation>Die billigsten Zeilen kosten %1</translation>
    </message>
    <message>
        <source>, before %1</source>
        <translation>, vorher %1</translation>
    </message>
    <message>
        <source>; &lt;b&gt;the target of U(%1) is not met&lt;/b&gt;</source>
        <translation>; &lt;b&gt;die Zielunsicherheit von U(%1) ist nicht eingehalten&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Out of date&lt;/b&gt;: shown for the project as it was. </source>
        <translation>&lt;b&gt;Veraltet&lt;/b&gt;: gezeigt für den früheren Stand des Projekts. </translation>
    </message>
    <message>
        <source>Take over design</source>
        <translation>Entwurf übernehmen</translation>
    </message>
    <message>
        <source>“%1” shows the best that can be done with what the design may choose.</source>
        <translation>„%1“ zeigt das Beste, was mit der Auswahl des Entwurfs möglich ist.</translation>
    </message>
    <message>
        <source>A design finds where to stand and what to measure: add one with “%1”.</source>
        <translation>Ein Entwurf sucht die besten Zahlen und Zeilen des Aufbaus: einen hinzufügen mit „%1“.</translation>
    </message>
    <message>
        <source> (law of propagation)</source>
        <translation> (Fortpflanzungsgesetz)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DesignsForm</name>
    <message>
        <source>Design</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Adds a design of this analysis</source>
        <translation>Fügt einen Entwurf dieser Analyse hinzu</translation>
    </message>
    <message>
        <source>Adds a copy of this design</source>
        <translation>Fügt eine Kopie dieses Entwurfs hinzu</translation>
    </message>
    <message>
        <source>Deletes this design</source>
        <translation>Löscht diesen Entwurf</translation>
    </message>
    <message>
        <source>Searches for the best design</source>
        <translation>Sucht den besten Entwurf</translation>
    </message>
    <message>
        <source>A design finds where to stand and what to measure: the numbers and the rows of the set-up that make the uncertainties smallest. Add one to let Covaria search.</source>
        <translation>Ein Entwurf sucht die Zahlen und die Zeilen des Aufbaus, die die Unsicherheiten am kleinsten machen. Einen hinzufügen, damit Covaria sucht.</translation>
    </message>
    <message>
        <source>Add Variable</source>
        <translation>Variable hinzufügen</translation>
    </message>
    <message>
        <source>One more number that may be chosen</source>
        <translation>Eine weitere Zahl, die gewählt werden darf</translation>
    </message>
    <message>
        <source>Name of the design</source>
        <translation>Name des Entwurfs</translation>
    </message>
    <message>
        <source>Objective</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>What is made smallest of the ratios of U to the target uncertainties; without targets to U of the present design</source>
        <translation>Was von den Verhältnissen von U zu den Zielunsicherheiten am kleinsten gemacht wird; ohne diese zu U des jetzigen Entwurfs</translation>
    </message>
    <message>
        <source>Largest ratio</source>
        <translation>Größtes Verhältnis</translation>
    </message>
    <message>
        <source>Mean of the ratios</source>
        <translation>Mittelwert der Verhältnisse</translation>
    </message>
    <message>
        <source>Root mean square of the ratios</source>
        <translation>Quadratisches Mittel der Verhältnisse</translation>
    </message>
    <message>
        <source>Cost of the rows, with all targets met</source>
        <translation>Kosten der Zeilen, alle Zielunsicherheiten eingehalten</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>Minimiert</translation>
    </message>
    <message>
        <source>Output quantities of the design</source>
        <translation>Ausgangsgrößen des Entwurfs</translation>
    </message>
    <message>
        <source>Output quantities looked at; with none ticked, all with a target uncertainty, or all measurands</source>
        <translation>Betrachtete Ausgangsgrößen; ist keine angehakt, alle mit einer Zielunsicherheit oder alle Messgrößen</translation>
    </message>
    <message>
        <source>Outputs (none ticked: all with a target, or all measurands)</source>
        <translation>Ausgangsgrößen (keine angehakt: alle mit Zielunsicherheit oder alle Messgrößen)</translation>
    </message>
    <message>
        <source>Rows to choose from</source>
        <translation>Zeilen zur Auswahl</translation>
    </message>
    <message>
        <source>Table to choose from</source>
        <translation>Tabelle zur Auswahl</translation>
    </message>
    <message>
        <source>Rows to keep</source>
        <translation>Zeilen zu behalten</translation>
    </message>
    <message>
        <source>File of candidates</source>
        <translation>Datei der Kandidaten</translation>
    </message>
    <message>
        <source>A CSV file beside the project with further rows; may be empty</source>
        <translation>Eine CSV-Datei neben dem Projekt mit weiteren Zeilen; darf leer sein</translation>
    </message>
    <message>
        <source>Rows that stay</source>
        <translation>Zeilen, die bleiben</translation>
    </message>
    <message>
        <source>Ticked rows stay in any case</source>
        <translation>Angehakte Zeilen bleiben auf jeden Fall</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation>Kandidaten</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Bleiben</translation>
    </message>
    <message>
        <source>Prices</source>
        <translation>Preise</translation>
    </message>
    <message>
        <source>Starts</source>
        <translation>Starts</translation>
    </message>
    <message>
        <source>Evaluations at most</source>
        <translation>Auswertungen höchstens</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startzahl</translation>
    </message>
    <message>
        <source>Least distance</source>
        <translation>Kleinster Abstand</translation>
    </message>
    <message>
        <source>Between instruments, and of them from all other points</source>
        <translation>Zwischen Messgeräten und von ihnen zu allen anderen Punkten</translation>
    </message>
    <message>
        <source>Keep out of</source>
        <translation>Fernhalten von</translation>
    </message>
    <message>
        <source>No instrument stands in this box</source>
        <translation>In diesem Quader steht kein Messgerät</translation>
    </message>
    <message>
        <source>Lines of sight are hidden by</source>
        <translation>Ziellinien verdeckt durch</translation>
    </message>
    <message>
        <source>No line of sight passes this box</source>
        <translation>Keine Ziellinie geht durch diesen Quader</translation>
    </message>
    <message>
        <source>Prices of the rows</source>
        <translation>Preise der Zeilen</translation>
    </message>
    <message>
        <source>one for all rows, or one for each: 120; 80; 95</source>
        <translation>für alle Zeilen oder je Zeile: 120; 80; 95</translation>
    </message>
    <message>
        <source>What the rows cost, separated by semicolons; needed where the cost is to be small</source>
        <translation>Was die Zeilen kosten, durch Semikolons getrennt; nötig, wo die Kosten klein sein sollen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no number; separate prices by semicolons</source>
        <translation>&apos;%1&apos; ist keine Zahl; Preise durch Semikolons trennen</translation>
    </message>
    <message>
        <source>Of the random starts: a whole number from 0 to 18446744073709551615</source>
        <translation>Der zufälligen Starts: eine ganze Zahl von 0 bis 18446744073709551615</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DistributionEdit</name>
    <message>
        <source>Distribution</source>
        <translation>Verteilung</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Probabilities</source>
        <translation>Wahrscheinlichkeiten</translation>
    </message>
    <message>
        <source>numbers with ; between</source>
        <translation>Zahlen mit ; dazwischen</translation>
    </message>
    <message>
        <source>“%1” are not all numbers.</source>
        <translation>„%1“ sind nicht alles Zahlen.</translation>
    </message>
    <message>
        <source>There must be as many probabilities as values.</source>
        <translation>Es muss so viele Wahrscheinlichkeiten wie Werte geben.</translation>
    </message>
    <message>
        <source>This distribution has no finite standard uncertainty.</source>
        <translation>Diese Verteilung hat keine endliche Standardunsicherheit.</translation>
    </message>
    <message>
        <source>Monte Carlo draws: %1, ν = %2</source>
        <translation>Monte Carlo zieht: %1, ν = %2</translation>
    </message>
    <message>
        <source>Edges of the cells</source>
        <translation>Kanten der Zellen</translation>
    </message>
    <message>
        <source>There must be one edge more than probabilities.</source>
        <translation>Es muss eine Kante mehr als Wahrscheinlichkeiten geben.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DockTitle</name>
    <message>
        <source>Float or dock</source>
        <translation>Lösen oder andocken</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>covaria::ui::Document</name>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>%1 (from %2)</source>
        <translation>%1 (aus %2)</translation>
    </message>
    <message>
        <source>The project has no file yet: choose a name for it.</source>
        <translation>Das Projekt hat noch keine Datei: einen Namen dafür wählen.</translation>
    </message>
    <message>
        <source> (copy)</source>
        <translation> (Kopie)</translation>
    </message>
    <message>
        <source>Add study</source>
        <translation>Studie hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate study</source>
        <translation>Studie duplizieren</translation>
    </message>
    <message>
        <source>Delete study</source>
        <translation>Studie löschen</translation>
    </message>
    <message>
        <source>Change study</source>
        <translation>Studie ändern</translation>
    </message>
    <message>
        <source>Study %1</source>
        <translation>Studie %1</translation>
    </message>
    <message>
        <source>Add design</source>
        <translation>Entwurf hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate design</source>
        <translation>Entwurf duplizieren</translation>
    </message>
    <message>
        <source>Delete design</source>
        <translation>Entwurf löschen</translation>
    </message>
    <message>
        <source>Change design</source>
        <translation>Entwurf ändern</translation>
    </message>
    <message>
        <source>Design %1</source>
        <translation>Entwurf %1</translation>
    </message>
    <message>
        <source>the project</source>
        <translation>das Projekt</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>Change notes of %1</source>
        <translation>Notizen von %1 ändern</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>Take %1 from an analysis</source>
        <translation>%1 aus einer Analyse nehmen</translation>
    </message>
    <message>
        <source>Remove the link of %1</source>
        <translation>Verknüpfung von %1 entfernen</translation>
    </message>
    <message>
        <source>Another program has changed the file since it was read.</source>
        <translation>Ein anderes Programm hat die Datei geändert, seit sie gelesen wurde.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::EmptyProject</name>
    <message>
        <source>Empty project</source>
        <translation>Leeres Projekt</translation>
    </message>
    <message>
        <source>What is to be evaluated?</source>
        <translation>Was soll ausgewertet werden?</translation>
    </message>
    <message>
        <source>&amp;Library and Templates …</source>
        <translation>Bibliothe&amp;k und Vorlagen …</translation>
    </message>
</context>
<context>
    <name>covaria::ui::EquationsView</name>
    <message>
        <source>Equations</source>
        <translation>Gleichungen</translation>
    </message>
</context>
<context>
    <name>covaria::ui::EvaluationTab</name>
    <message>
        <source>Evaluation of the set-up</source>
        <translation>Auswertung des Aufbaus</translation>
    </message>
</context>
<context>
    <name>covaria::ui::EvaluationView</name>
    <message>
        <source>Tables of the evaluation</source>
        <translation>Tabellen der Auswertung</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Diagramm</translation>
    </message>
    <message>
        <source>Which chart of the evaluation is shown</source>
        <translation>Welches Diagramm der Auswertung gezeigt wird</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ExportActions</name>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>PDF-Dokument (*.pdf)</translation>
    </message>
    <message>
        <source>HTML page (*.html)</source>
        <translation>HTML-Seite (*.html)</translation>
    </message>
    <message>
        <source>Markdown text (*.md)</source>
        <translation>Markdown-Text (*.md)</translation>
    </message>
    <message>
        <source>Report as &amp;PDF …</source>
        <translation>Bericht als &amp;PDF …</translation>
    </message>
    <message>
        <source>&amp;Certificate as PDF …</source>
        <translation>&amp;Kalibrierschein als PDF …</translation>
    </message>
    <message>
        <source>Report as &amp;HTML …</source>
        <translation>Bericht als &amp;HTML …</translation>
    </message>
    <message>
        <source>Report as &amp;Markdown …</source>
        <translation>Bericht als &amp;Markdown …</translation>
    </message>
    <message>
        <source>&amp;Results and Tables (JSON, CSV) …</source>
        <translation>&amp;Ergebnisse und Tabellen (JSON, CSV) …</translation>
    </message>
    <message>
        <source> …</source>
        <translation> …</translation>
    </message>
    <message>
        <source>No results yet</source>
        <translation>Noch keine Ergebnisse</translation>
    </message>
    <message>
        <source>The export waits until the analyses have run</source>
        <translation>Der Export wartet, bis die Analysen gelaufen sind</translation>
    </message>
    <message>
        <source>, without %1: not up to date</source>
        <translation>, ohne %1: nicht aktuell</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Export Report</source>
        <translation>Bericht exportieren</translation>
    </message>
    <message>
        <source>The certificate does not state what ISO/IEC 17025 requires of it:

%1

It says “not stated” in these places. They are fields of the project&apos;s page.</source>
        <translation>Der Kalibrierschein gibt nicht an, was ISO/IEC 17025 von ihm fordert:

%1

An diesen Stellen steht „nicht angegeben“. Es sind Felder der Seite des Projekts.</translation>
    </message>
    <message>
        <source>Export Anyway</source>
        <translation>Trotzdem exportieren</translation>
    </message>
    <message>
        <source>Export Certificate</source>
        <translation>Kalibrierschein exportieren</translation>
    </message>
    <message>
        <source>Export Results and Tables into the Folder of</source>
        <translation>Ergebnisse und Tabellen exportieren in den Ordner von</translation>
    </message>
    <message>
        <source>Results (results.json)</source>
        <translation>Ergebnisse (results.json)</translation>
    </message>
    <message>
        <source>%1: what it must state is missing</source>
        <translation>%1: Es fehlt, was er angeben muss</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>%1 exportieren</translation>
    </message>
    <message>
        <source>%1 (*%2)</source>
        <translation>%1 (*%2)</translation>
    </message>
    <message>
        <source>A report is being written; wait until it is finished</source>
        <translation>Ein Bericht wird geschrieben; bitte warten, bis er fertig ist</translation>
    </message>
    <message>
        <source>Writing %1 …</source>
        <translation>%1 wird geschrieben …</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 geschrieben</translation>
    </message>
    <message>
        <source>The export failed</source>
        <translation>Der Export ist fehlgeschlagen</translation>
    </message>
    <message>
        <source>No analysis can be run: each one is incomplete or has errors.</source>
        <translation>Keine Analyse kann ausgeführt werden: Jede ist unvollständig oder hat Fehler.</translation>
    </message>
    <message>
        <source>Ex&amp;port</source>
        <translation>&amp;Exportieren</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FieldEditor</name>
    <message>
        <source>From %1 to %2.</source>
        <translation>Von %1 bis %2.</translation>
    </message>
    <message>
        <source>More than %1.</source>
        <translation>Mehr als %1.</translation>
    </message>
    <message>
        <source>At least %1.</source>
        <translation>Mindestens %1.</translation>
    </message>
    <message>
        <source>At most %1.</source>
        <translation>Höchstens %1.</translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation>%1-Dateien</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FieldHelp</name>
    <message>
        <source>Help on the field</source>
        <translation>Hilfe zum Feld</translation>
    </message>
    <message>
        <source>Numbers may be typed with another unit (%1); the arrow keys change the last digit.</source>
        <translation>Zahlen dürfen mit einer anderen Einheit eingegeben werden (%1); die Pfeiltasten ändern die letzte Stelle.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FileActions</name>
    <message>
        <source>line %1: </source>
        <translation>Zeile %1: </translation>
    </message>
    <message>
        <source>&amp;New Project</source>
        <translation>&amp;Neues Projekt</translation>
    </message>
    <message>
        <source>&amp;Open …</source>
        <translation>Ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save &amp;As …</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>No projects yet</source>
        <translation>Noch keine Projekte</translation>
    </message>
    <message>
        <source>New from &amp;Example</source>
        <translation>Neu aus Beis&amp;piel</translation>
    </message>
    <message>
        <source>Untitled project</source>
        <translation>Unbenanntes Projekt</translation>
    </message>
    <message>
        <source>Opening %1 …</source>
        <translation>%1 wird geöffnet …</translation>
    </message>
    <message>
        <source>%1 was not opened</source>
        <translation>%1 wurde nicht geöffnet</translation>
    </message>
    <message>
        <source>The project has errors and was not opened</source>
        <translation>Das Projekt hat Fehler und wurde nicht geöffnet</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>%1 geöffnet</translation>
    </message>
    <message>
        <source>The example could not be opened</source>
        <translation>Das Beispiel konnte nicht geöffnet werden</translation>
    </message>
    <message>
        <source>The project was not saved</source>
        <translation>Das Projekt wurde nicht gespeichert</translation>
    </message>
    <message>
        <source>Save Project</source>
        <translation>Projekt speichern</translation>
    </message>
    <message>
        <source>Covaria project (*.covaria)</source>
        <translation>Covaria-Projekt (*.covaria)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message numerus="yes">
        <source>Saved %1 without %n text(s) that cannot be read: see the problems</source>
        <translation>
            <numerusform>%1 gespeichert ohne %n Text(e), die nicht lesbar sind: siehe Probleme</numerusform>
            <numerusform>%1 gespeichert ohne %n Text(e), die nicht lesbar sind: siehe Probleme</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>The work could not be recovered</source>
        <translation>Die Arbeit konnte nicht wiederhergestellt werden</translation>
    </message>
    <message>
        <source>%1 was removed by another program; saving writes it again</source>
        <translation>%1 wurde von einem anderen Programm entfernt; Speichern schreibt es erneut</translation>
    </message>
    <message>
        <source>Name project</source>
        <translation>Projekt benennen</translation>
    </message>
    <message>
        <source>%1 was changed by another program since it was read here. Saving replaces what it holds now.</source>
        <translation>%1 wurde von einem anderen Programm geändert, seit es hier gelesen wurde. Speichern ersetzt, was sie jetzt enthält.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FileEditor</name>
    <message>
        <source>Choose a file: %1</source>
        <translation>Datei wählen: %1</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FirstStepsGuide</name>
    <message>
        <source>First Steps</source>
        <translation>Erste Schritte</translation>
    </message>
    <message>
        <source>Not there yet: first step %1, %2.</source>
        <translation>Noch nicht da: erst Schritt %1, %2.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FirstStepsPanel</name>
    <message>
        <source>Show Me</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Erste Schritte</translation>
    </message>
    <message>
        <source>Shows where it is done: opens the tab and puts a frame around it</source>
        <translation>Zeigt, wo es geht: öffnet den Reiter und setzt einen Rahmen darum</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>step 3 of 10</comment>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>done</source>
        <translation>erledigt</translation>
    </message>
</context>
<context>
    <name>covaria::ui::HelpActions</name>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>M&amp;odels</source>
        <translation>M&amp;odelle</translation>
    </message>
    <message>
        <source>&amp;Results and Requirements</source>
        <translation>&amp;Ergebnisse und Anforderungen</translation>
    </message>
    <message>
        <source>&amp;Glossary</source>
        <translation>&amp;Glossar</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>&amp;About Covaria</source>
        <translation>&amp;Über Covaria</translation>
    </message>
    <message>
        <source>The S&amp;cene</source>
        <translation>Die S&amp;zene</translation>
    </message>
    <message>
        <source>An Everyday &amp;Budget</source>
        <translation>Ein alltägliches &amp;Budget</translation>
    </message>
    <message>
        <source>Help on &amp;What Has the Focus</source>
        <translation>Hilfe zum fo&amp;kussierten Element</translation>
    </message>
    <message>
        <source>Artefacts, &amp;Instruments and Robots</source>
        <translation>P&amp;rüfkörper, Messgeräte und Roboter</translation>
    </message>
    <message>
        <source>What Every Analysis &amp;Has</source>
        <translation>Was jede &amp;Analyse hat</translation>
    </message>
</context>
<context>
    <name>covaria::ui::HelpPane</name>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ImportActions</name>
    <message>
        <source>&amp;Import File …</source>
        <translation>Datei &amp;importieren …</translation>
    </message>
    <message>
        <source>Add points, budgets, certificates, readings or poses of other programs</source>
        <translation>Punkte, Budgets, Kalibrierscheine, Ablesungen oder Posen anderer Programme hinzufügen</translation>
    </message>
    <message>
        <source>Add a serial robot from a robot description in URDF</source>
        <translation>Einen seriellen Roboter aus einer Roboterbeschreibung in URDF hinzufügen</translation>
    </message>
    <message>
        <source>Import File</source>
        <translation>Datei importieren</translation>
    </message>
    <message>
        <source>Files that are read (%1);;All files (*)</source>
        <translation>Lesbare Dateien (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 importieren</translation>
    </message>
    <message>
        <source>Imported %1</source>
        <translation>%1 importiert</translation>
    </message>
    <message>
        <source>Import Robot</source>
        <translation>Roboter importieren</translation>
    </message>
    <message>
        <source>Robot description (*.urdf);;All files (*)</source>
        <translation>Roboterbeschreibung (*.urdf);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>The robot was not imported</source>
        <translation>Der Roboter wurde nicht importiert</translation>
    </message>
    <message>
        <source>Import Robo&amp;t (URDF) …</source>
        <translation>&amp;Roboter importieren (URDF) …</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ImportDialog</name>
    <message>
        <source>Line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>What the file says contradicts itself: %1</source>
        <translation>Die Angaben der Datei widersprechen sich: %1</translation>
    </message>
    <message>
        <source>&amp;Sheet</source>
        <translation>&amp;Blatt</translation>
    </message>
    <message>
        <source>Columns of the file and what each is read as</source>
        <translation>Spalten der Datei und als was jede gelesen wird</translation>
    </message>
    <message>
        <source>Units that the &amp;file does not state</source>
        <translation>Einheiten, die die &amp;Datei nicht angibt</translation>
    </message>
    <message>
        <source>&amp;Note the file with its size, time and SHA-256 in what is added</source>
        <translation>Die Datei mit Größe, Zeit und SHA-256 im Hinzugefügten &amp;vermerken</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 importieren</translation>
    </message>
    <message>
        <source>as the file says, else mm</source>
        <translation>wie in der Datei, sonst mm</translation>
    </message>
    <message>
        <source>What becomes of the file</source>
        <translation>Was aus der Datei wird</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>&amp;Read as</source>
        <translation>&amp;Lesen als</translation>
    </message>
    <message>
        <source>&amp;Unit of lengths</source>
        <translation>&amp;Einheit der Längen</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>What becomes of it, and what is not taken over</source>
        <translation>Was daraus wird und was nicht übernommen wird</translation>
    </message>
    <message>
        <source>no reader recognises it: choose one</source>
        <translation>kein Leser erkennt sie: einen wählen</translation>
    </message>
    <message>
        <source>several readers recognise it: choose one</source>
        <translation>mehrere Leser erkennen sie: einen wählen</translation>
    </message>
    <message>
        <source>%1 (recognised)</source>
        <translation>%1 (erkannt)</translation>
    </message>
    <message>
        <source>Column %1 is read as</source>
        <translation>Spalte %1 wird gelesen als</translation>
    </message>
    <message>
        <source>unknown: choose</source>
        <translation>unbekannt: wählen</translation>
    </message>
    <message>
        <source>as it is named</source>
        <translation>wie benannt</translation>
    </message>
    <message>
        <source>Choose what the file is read as.</source>
        <translation>Wählen, als was die Datei gelesen wird.</translation>
    </message>
    <message>
        <source>%1 assets and %2 analyses are added, in one step that can be undone.</source>
        <translation>%1 Betriebsmittel und %2 Analysen werden hinzugefügt, in einem Schritt, der rückgängig gemacht werden kann.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Imported from %1, %2 bytes, of %3, SHA-256 %4.</source>
        <translation>Importiert aus %1, %2 Byte, von %3, SHA-256 %4.</translation>
    </message>
    <message>
        <source>&amp;Leave Out or Read the Row</source>
        <translation>Zeile aus&amp;lassen oder lesen</translation>
    </message>
    <message>
        <source>%1, left out</source>
        <translation>%1, ausgelassen</translation>
    </message>
    <message>
        <source>What each column is read as; cells can be typed over</source>
        <translation>Als was jede Spalte gelesen wird; Zellen können überschrieben werden</translation>
    </message>
</context>
<context>
    <name>covaria::ui::InputCorrelationModel</name>
    <message>
        <source>Remove correlations of %1</source>
        <translation>Korrelationen von %1 entfernen</translation>
    </message>
    <message>
        <source>Change correlation of %1 and %2</source>
        <translation>Korrelation von %1 und %2 ändern</translation>
    </message>
    <message>
        <source>The correlation coefficient of %1 and %2 lies between −1 and 1; “%3” does not.</source>
        <translation>Der Korrelationskoeffizient von %1 und %2 liegt zwischen −1 und 1; „%3“ nicht.</translation>
    </message>
    <message>
        <source>The correlation coefficient of %1 and %2 is a number; “%3” is not.</source>
        <translation>Der Korrelationskoeffizient von %1 und %2 ist eine Zahl; „%3“ nicht.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::InputQuantitiesModel</name>
    <message>
        <source>from %1, linearised: %2</source>
        <translation>aus %1, linearisiert: %2</translation>
    </message>
    <message>
        <source>from %1: %2</source>
        <translation>aus %1: %2</translation>
    </message>
    <message>
        <source>Evaluated in the other analysis, in every trial: edit it there.</source>
        <translation>In der anderen Analyse ausgewertet, in jedem Versuch: dort bearbeiten.</translation>
    </message>
    <message>
        <source>Changed: differs from what the model says.</source>
        <translation>Geändert: weicht von der Angabe des Modells ab.</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>Symbol</translation>
    </message>
    <message>
        <source>Input quantity</source>
        <translation>Eingangsgröße</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>Schätzwert</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Constant</source>
        <translation>Konstante</translation>
    </message>
    <message>
        <source>Change estimate of %1</source>
        <translation>Schätzwert von %1 ändern</translation>
    </message>
    <message>
        <source>Keep %1 constant</source>
        <translation>%1 konstant halten</translation>
    </message>
    <message>
        <source>Let %1 vary</source>
        <translation>%1 variieren lassen</translation>
    </message>
    <message>
        <source>Reset %1 to the model&apos;s values</source>
        <translation>%1 auf die Werte des Modells zurücksetzen</translation>
    </message>
    <message>
        <source>%1 (%2, %3)</source>
        <translation>%1 (%2, %3)</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Komponenten</translation>
    </message>
</context>
<context>
    <name>covaria::ui::InputsPage</name>
    <message>
        <source>Find a quantity</source>
        <translation>Eine Größe suchen</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Komponenten</translation>
    </message>
    <message>
        <source>Correlations</source>
        <translation>Korrelationen</translation>
    </message>
    <message>
        <source>The quantities that the set-up makes. What is changed here replaces what the set-up states.</source>
        <translation>Die Größen, die der Aufbau bildet. Was hier geändert wird, ersetzt, was der Aufbau angibt.</translation>
    </message>
    <message>
        <source>Input quantities</source>
        <translation>Eingangsgrößen</translation>
    </message>
    <message>
        <source>Take From an Analysis …</source>
        <translation>Aus einer Analyse nehmen …</translation>
    </message>
    <message>
        <source>Remove Link</source>
        <translation>Verknüpfung entfernen</translation>
    </message>
    <message>
        <source>Observations</source>
        <translation>Beobachtungen</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
</context>
<context>
    <name>covaria::ui::InquiryHead</name>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ausführen</translation>
    </message>
</context>
<context>
    <name>covaria::ui::KeptStates</name>
    <message>
        <source>Keep state</source>
        <translation>Stand merken</translation>
    </message>
    <message>
        <source>Discard kept state</source>
        <translation>Gemerkten Stand verwerfen</translation>
    </message>
    <message>
        <source>Compare with %1</source>
        <translation>Mit %1 vergleichen</translation>
    </message>
</context>
<context>
    <name>covaria::ui::LibraryBrowser</name>
    <message>
        <source>Collections</source>
        <translation>Sammlungen</translation>
    </message>
    <message>
        <source>Templates, examples and assets</source>
        <translation>Vorlagen, Beispiele und Betriebsmittel</translation>
    </message>
    <message>
        <source>Library and Examples</source>
        <translation>Bibliothek und Beispiele</translation>
    </message>
    <message>
        <source>Search: name, kind, source</source>
        <translation>Suche: Name, Art, Quelle</translation>
    </message>
    <message>
        <source>Search in the library</source>
        <translation>In der Bibliothek suchen</translation>
    </message>
    <message>
        <source>What is selected</source>
        <translation>Was ausgewählt ist</translation>
    </message>
    <message>
        <source>New analysis</source>
        <translation>Neue Analyse</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>GUM and its supplements</source>
        <translation>GUM und seine Supplemente</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>It comes with what it needs and has results at once. Assets of the same kind that the project has already stand in the place of its own.</source>
        <translation>Sie kommt mit allem, was sie braucht, und hat sofort Ergebnisse. Betriebsmittel derselben Art, die das Projekt schon hat, treten an die Stelle ihrer eigenen.</translation>
    </message>
    <message>
        <source>Opens as a new project.</source>
        <translation>Öffnet sich als neues Projekt.</translation>
    </message>
    <message>
        <source>Add to the Project</source>
        <translation>Zum Projekt hinzufügen</translation>
    </message>
    <message>
        <source>&lt;p&gt;Nothing here has these words.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Nichts hier enthält diese Wörter.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Open as a New Project</source>
        <translation>Als neues Projekt öffnen</translation>
    </message>
    <message>
        <source>Add This Analysis</source>
        <translation>Diese Analyse hinzufügen</translation>
    </message>
</context>
<context>
    <name>covaria::ui::LibraryMenu</name>
    <message>
        <source>Not readable: %1</source>
        <translation>Nicht lesbar: %1</translation>
    </message>
    <message>
        <source>F&amp;rom the Library</source>
        <translation>A&amp;us der Bibliothek</translation>
    </message>
</context>
<context>
    <name>covaria::ui::LinesEditor</name>
    <message>
        <source>Add rows for new names</source>
        <translation>Zeilen für neue Namen</translation>
    </message>
    <message>
        <source>Adds a row to the tables below for every name that has none yet</source>
        <translation>Fügt den Tabellen unten für jeden Namen, der noch keine hat, eine Zeile hinzu</translation>
    </message>
</context>
<context>
    <name>covaria::ui::LinkDialog</name>
    <message>
        <source>&amp;Linearised: faster, exact to first order only</source>
        <translation>&amp;Linearisiert: schneller, nur in erster Ordnung exakt</translation>
    </message>
    <message>
        <source>Take %1 From an Analysis</source>
        <translation>%1 aus einer Analyse nehmen</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>Analyse</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>No other analysis has a result of this dimension.</source>
        <translation>Keine andere Analyse hat ein Ergebnis dieser Dimension.</translation>
    </message>
    <message>
        <source>Both analyses are then evaluated together, as one model: the result is not carried over as a number with an uncertainty.</source>
        <translation>Beide Analysen werden dann gemeinsam als ein Modell ausgewertet: Das Ergebnis wird nicht als Zahl mit einer Unsicherheit übertragen.</translation>
    </message>
    <message>
        <source>&amp;Analysis</source>
        <translation>&amp;Analyse</translation>
    </message>
    <message>
        <source>&amp;Result</source>
        <translation>&amp;Ergebnis</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ListEditor</name>
    <message>
        <source>(none)</source>
        <translation>(keine)</translation>
    </message>
    <message>
        <source>%1 (does not exist)</source>
        <translation>%1 (existiert nicht)</translation>
    </message>
    <message>
        <source>%1

Chosen: %2</source>
        <translation>%1

Gewählt: %2</translation>
    </message>
</context>
<context>
    <name>covaria::ui::LogPane</name>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
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
        <translation>Projekt</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Add an analysis or what it uses</source>
        <translation>Eine Analyse hinzufügen oder was sie verwendet</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Library and Examples …</source>
        <translation>Bibliothe&amp;k und Beispiele …</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>Pre&amp;ferences …</source>
        <translation>&amp;Einstellungen …</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>Aus&amp;führen</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Reset Layout</source>
        <translation>&amp;Layout zurücksetzen</translation>
    </message>
    <message>
        <source>Start Page</source>
        <translation>Startseite</translation>
    </message>
    <message>
        <source>3D Scene</source>
        <translation>3D-Szene</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Problems (%1)</source>
        <translation>Probleme (%1)</translation>
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
        <translation>Erste &amp;Schritte</translation>
    </message>
</context>
<context>
    <name>covaria::ui::MeasureTool</name>
    <message>
        <source>Measure Distance</source>
        <translation>Abstand messen</translation>
    </message>
    <message>
        <source>Distance of two points, with its uncertainty (D)</source>
        <translation>Abstand zweier Punkte mit seiner Unsicherheit (D)</translation>
    </message>
    <message>
        <source>Measure Angle</source>
        <translation>Winkel messen</translation>
    </message>
    <message>
        <source>Angle at the second of three points, with its uncertainty (A)</source>
        <translation>Winkel am zweiten von drei Punkten mit seiner Unsicherheit (A)</translation>
    </message>
    <message>
        <source>Distance: pick the first point. Esc puts the tool away.</source>
        <translation>Abstand: den ersten Punkt anklicken. Esc legt das Werkzeug weg.</translation>
    </message>
    <message>
        <source>Distance: pick the second point.</source>
        <translation>Abstand: den zweiten Punkt anklicken.</translation>
    </message>
    <message>
        <source>Angle: pick a point on the first side. Esc puts the tool away.</source>
        <translation>Winkel: einen Punkt auf dem ersten Schenkel anklicken. Esc legt das Werkzeug weg.</translation>
    </message>
    <message>
        <source>Angle: pick the apex.</source>
        <translation>Winkel: den Scheitel anklicken.</translation>
    </message>
    <message>
        <source>Angle: pick a point on the second side.</source>
        <translation>Winkel: einen Punkt auf dem zweiten Schenkel anklicken.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::NotesPage</name>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Appear in the report</source>
        <translation>Im Bericht zeigen</translation>
    </message>
</context>
<context>
    <name>covaria::ui::OnlyMiddle</name>
    <message>
        <source>Only the &amp;Middle</source>
        <translation>Nur die &amp;Mitte</translation>
    </message>
    <message>
        <source>The stage alone; once more, and the panes stand as they did</source>
        <translation>Nur der Hauptbereich; noch einmal, und die Bereiche stehen wie zuvor</translation>
    </message>
</context>
<context>
    <name>covaria::ui::OptionsForm</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Forecast</source>
        <translation>Prognose</translation>
    </message>
    <message>
        <source>Change evaluation options</source>
        <translation>Auswertungsoptionen ändern</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
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
        <translation>Seite</translation>
    </message>
    <message>
        <source>Number of the page that is shown</source>
        <translation>Nummer der gezeigten Seite</translation>
    </message>
    <message>
        <source>Previous page</source>
        <translation>Vorige Seite</translation>
    </message>
    <message>
        <source>Next page</source>
        <translation>Nächste Seite</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Kleiner</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Größer</translation>
    </message>
    <message>
        <source>Size of the pages</source>
        <translation>Größe der Seiten</translation>
    </message>
    <message>
        <source>Size of the pages: fitted, or in per cent of the paper (Ctrl with the wheel)</source>
        <translation>Größe der Seiten: eingepasst oder in Prozent des Papiers (Strg mit dem Rad)</translation>
    </message>
    <message>
        <source>Fit Width</source>
        <translation>Seitenbreite</translation>
    </message>
    <message>
        <source>Fit Page</source>
        <translation>Ganze Seite</translation>
    </message>
    <message>
        <source> of %1</source>
        <comment>page 3 of 17</comment>
        <translation> von %1</translation>
    </message>
</context>
<context>
    <name>covaria::ui::PageList</name>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>Seite %1</translation>
    </message>
</context>
<context>
    <name>covaria::ui::PaneKeys</name>
    <message>
        <source>Ne&amp;xt Pane</source>
        <translation>N&amp;ächster Bereich</translation>
    </message>
    <message>
        <source>Pre&amp;vious Pane</source>
        <translation>&amp;Voriger Bereich</translation>
    </message>
</context>
<context>
    <name>covaria::ui::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Results in the window</source>
        <translation>Ergebnisse im Fenster</translation>
    </message>
    <message>
        <source>New analyses</source>
        <translation>Neue Analysen</translation>
    </message>
    <message>
        <source>Written into analyses that are added; others stay as they are.</source>
        <translation>In hinzugefügte Analysen geschrieben; andere bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Of tables and charts of results</source>
        <translation>Von Tabellen und Diagrammen der Ergebnisse</translation>
    </message>
    <message>
        <source>As the model gives them</source>
        <translation>Wie das Modell sie liefert</translation>
    </message>
    <message>
        <source>Digits of U</source>
        <translation>Stellen von U</translation>
    </message>
    <message>
        <source>Significant digits of uncertainties; estimates are rounded to match</source>
        <translation>Signifikante Stellen der Unsicherheiten; Schätzwerte werden passend gerundet</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>Of all tables, charts and fields of the window</source>
        <translation>Aller Tabellen, Diagramme und Felder des Fensters</translation>
    </message>
    <message>
        <source>As the language writes them</source>
        <translation>Wie die Sprache sie schreibt</translation>
    </message>
    <message>
        <source>1234.5 (point)</source>
        <translation>1234.5 (Punkt)</translation>
    </message>
    <message>
        <source>1234,5 (comma)</source>
        <translation>1234,5 (Komma)</translation>
    </message>
    <message>
        <source>Coverage factor</source>
        <translation>Erweiterungsfaktor</translation>
    </message>
    <message>
        <source>Of U = k u, where a new analysis begins with a fixed one</source>
        <translation>Von U = k u, wo eine neue Analyse mit einem festen beginnt</translation>
    </message>
    <message>
        <source>k from the degrees of freedom or the coverage interval</source>
        <translation>k aus den Freiheitsgraden oder dem Überdeckungsintervall</translation>
    </message>
    <message>
        <source>k = 2</source>
        <translation>k = 2</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Of Monte Carlo</source>
        <translation>Von Monte Carlo</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Of the window, when Covaria starts again</source>
        <translation>Gilt nach einem Neustart von Covaria</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Of the window, its charts and the scene</source>
        <translation>Des Fensters, seiner Diagramme und der Szene</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Font size</source>
        <translation>Schriftgröße</translation>
    </message>
    <message>
        <source>Of the whole window</source>
        <translation>Des ganzen Fensters</translation>
    </message>
    <message>
        <source>as the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source> pt</source>
        <translation> pt</translation>
    </message>
    <message>
        <source>Recovery copy</source>
        <translation>Sicherungskopie</translation>
    </message>
    <message>
        <source>How long an edit may stay without a copy that a crash leaves behind</source>
        <translation>Wie lange eine Änderung ohne Kopie bleiben darf, die ein Absturz hinterlässt</translation>
    </message>
    <message>
        <source>at most </source>
        <translation>höchstens </translation>
    </message>
    <message>
        <source> s after an edit</source>
        <translation> s nach einer Änderung</translation>
    </message>
    <message>
        <source>Where the project does not state them. Reports and files are the project&apos;s alone.</source>
        <translation>Wo das Projekt sie nicht angibt. Berichte und Dateien richten sich allein nach dem Projekt.</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>Schriftart</translation>
    </message>
    <message>
        <source>Covaria&apos;s own</source>
        <translation>Die von Covaria</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProblemsModel</name>
    <message>
        <source>, row %1</source>
        <translation>, Zeile %1</translation>
    </message>
    <message>
        <source>Project: certificate, %1</source>
        <translation>Projekt: Kalibrierschein, %1</translation>
    </message>
    <message>
        <source>Project: report</source>
        <translation>Projekt: Bericht</translation>
    </message>
    <message>
        <source>evaluation, %1</source>
        <translation>Auswertung, %1</translation>
    </message>
    <message>
        <source>To give</source>
        <translation>Anzugeben</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>, line %1</source>
        <translation>, Zeile %1</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>correlation of %1 and %2</source>
        <translation>Korrelation von %1 und %2</translation>
    </message>
    <message>
        <source>link of %1</source>
        <translation>Verknüpfung von %1</translation>
    </message>
    <message>
        <source>change of %1</source>
        <translation>Änderung von %1</translation>
    </message>
    <message>
        <source>requirement on %1</source>
        <translation>Anforderung an %1</translation>
    </message>
    <message>
        <source>study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>design</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Way out</source>
        <translation>Ausweg</translation>
    </message>
    <message>
        <source>or</source>
        <translation>oder</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProblemsPane</name>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>No problems.</source>
        <translation>Keine Probleme.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProjectPage</name>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Of the project or order; in the report</source>
        <translation>Des Projekts oder Auftrags; im Bericht</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Bearbeiter</translation>
    </message>
    <message>
        <source>Who evaluated; in the report</source>
        <translation>Wer ausgewertet hat; im Bericht</translation>
    </message>
    <message>
        <source>Results of all analyses</source>
        <translation>Ergebnisse aller Analysen</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>Not stated</source>
        <translation>Nicht angegeben</translation>
    </message>
    <message>
        <source>Of results in the window, reports, tables and CSV files; where it is not stated, files have the unit of the model</source>
        <translation>Der Ergebnisse in Fenster, Berichten, Tabellen und CSV-Dateien; ist nichts angegeben, haben Dateien die Einheit des Modells</translation>
    </message>
    <message>
        <source>Change units of results</source>
        <translation>Einheiten der Ergebnisse ändern</translation>
    </message>
    <message>
        <source>Digits of U</source>
        <translation>Stellen von U</translation>
    </message>
    <message>
        <source>Significant digits of uncertainties in the window and the report; certificates have two</source>
        <translation>Signifikante Stellen der Unsicherheiten in Fenster und Bericht; Kalibrierscheine haben zwei</translation>
    </message>
    <message>
        <source>Change digits of results</source>
        <translation>Stellen der Ergebnisse ändern</translation>
    </message>
    <message>
        <source>Coverage factor</source>
        <translation>Erweiterungsfaktor</translation>
    </message>
    <message>
        <source>A fixed k for U = k u of all analyses whose options state none; empty: from the degrees of freedom, or the coverage interval</source>
        <translation>Ein festes k für U = k u aller Analysen, deren Optionen keines nennen; leer: aus den Freiheitsgraden oder dem Überdeckungsintervall</translation>
    </message>
    <message>
        <source>Change coverage factor</source>
        <translation>Erweiterungsfaktor ändern</translation>
    </message>
    <message>
        <source>Reports, certificates and files have these units, and those of the model where none is stated; units of the preferences are of the window only.</source>
        <translation>Berichte, Kalibrierscheine und Dateien haben diese Einheiten, und wo keine angegeben ist, die des Modells; Einheiten der Einstellungen gelten nur für das Fenster.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProjectPane</name>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>U&amp;mbenennen</translation>
    </message>
    <message>
        <source>&amp;Delete …</source>
        <translation>&amp;Löschen …</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Library and Templates …</source>
        <translation>Bibliothe&amp;k und Vorlagen …</translation>
    </message>
    <message>
        <source>The analysis was not added: %1</source>
        <translation>Die Analyse wurde nicht hinzugefügt: %1</translation>
    </message>
    <message>
        <source>“%1” is in the project now</source>
        <translation>„%1“ ist jetzt im Projekt</translation>
    </message>
    <message>
        <source>Delete “%1”?</source>
        <translation>„%1“ löschen?</translation>
    </message>
    <message>
        <source>

It is used by: %1. They will have an error until they use something else.</source>
        <translation>

Verwendet von: %1. Dort steht ein Fehler, bis etwas anderes verwendet wird.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>“%1” is in your library now (Add &gt; From the Library)</source>
        <translation>„%1“ ist jetzt in Ihrer Bibliothek (Hinzufügen &gt; Aus der Bibliothek)</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ausführen</translation>
    </message>
    <message>
        <source>Keep in My Library</source>
        <translation>In meine Bibliothek aufnehmen</translation>
    </message>
    <message>
        <source>Show in the Scene</source>
        <translation>In der Szene zeigen</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>Analyse</translation>
    </message>
    <message>
        <source>What it uses</source>
        <translation>Was sie verwendet</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>D&amp;uplizieren</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProjectTreeModel</name>
    <message>
        <source>Artefacts</source>
        <translation>Prüfkörper</translation>
    </message>
    <message>
        <source>Instruments</source>
        <translation>Messgeräte</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Points and frames</source>
        <translation>Punkte und Koordinatensysteme</translation>
    </message>
    <message>
        <source>Analyses</source>
        <translation>Analysen</translation>
    </message>
    <message>
        <source>has problems</source>
        <translation>hat Probleme</translation>
    </message>
    <message>
        <source>Untitled project</source>
        <translation>Unbenanntes Projekt</translation>
    </message>
    <message>
        <source>Title, notes, certificate and contents of the report</source>
        <translation>Titel, Notizen, Kalibrierschein und Inhalt des Berichts</translation>
    </message>
    <message>
        <source>incomplete</source>
        <translation>unvollständig</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>up to date</source>
        <translation>aktuell</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>veraltet</translation>
    </message>
    <message>
        <source>%1 of %2 requirements not met</source>
        <translation>%1 von %2 Anforderungen nicht eingehalten</translation>
    </message>
    <message>
        <source>Context</source>
        <translation>Umgebung</translation>
    </message>
</context>
<context>
    <name>covaria::ui::PropertiesPane</name>
    <message>
        <source>The project is empty. Add an analysis, or first what it uses, with the plus sign above or a right click in the project tree.</source>
        <translation>Das Projekt ist leer. Eine Analyse oder zuerst das, was sie verwendet, mit dem Pluszeichen oben oder einem Rechtsklick im Projektbaum hinzufügen.</translation>
    </message>
    <message>
        <source>Select an entry of the project tree to see its properties.</source>
        <translation>Einen Eintrag des Projektbaums auswählen, um seine Eigenschaften zu sehen.</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>Aufbau</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Kalibrierschein</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>Auswertung</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Eingaben</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Optionen</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Studien</translation>
    </message>
    <message>
        <source>Designs</source>
        <translation>Entwürfe</translation>
    </message>
    <message>
        <source>Requirements</source>
        <translation>Anforderungen</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
</context>
<context>
    <name>covaria::ui::QuantityEdit</name>
    <message>
        <source>A value is needed here.</source>
        <translation>Hier ist ein Wert nötig.</translation>
    </message>
    <message>
        <source>A whole number is needed here.</source>
        <translation>Hier ist eine ganze Zahl nötig.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::QuantityNotesEdit</name>
    <message>
        <source>Notes on the quantity</source>
        <translation>Notizen zur Größe</translation>
    </message>
    <message>
        <source>Why this figure, what was agreed: in the report, below the input quantities</source>
        <translation>Warum dieser Wert, was vereinbart wurde: im Bericht unter den Eingangsgrößen</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ReferenceEditor</name>
    <message>
        <source>(nothing in the project fits: add it first)</source>
        <translation>(nichts im Projekt passt: zuerst hinzufügen)</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>(keine)</translation>
    </message>
    <message>
        <source>(choose)</source>
        <translation>(wählen)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ReportForm</name>
    <message>
        <source>Analyses, of report and certificate</source>
        <translation>Analysen, von Bericht und Kalibrierschein</translation>
    </message>
    <message>
        <source>Chapters of the report</source>
        <translation>Kapitel des Berichts</translation>
    </message>
    <message>
        <source>Long tables</source>
        <translation>Lange Tabellen</translation>
    </message>
    <message>
        <source>The report shows what counts most of long tables; the CSV files have them whole. Ticked, they stand whole at the end of the report too.</source>
        <translation>Der Bericht zeigt von langen Tabellen, was am meisten zählt; die CSV-Dateien enthalten sie ganz. Angehakt stehen sie auch am Ende des Berichts ganz.</translation>
    </message>
    <message>
        <source>Whole, in an annex</source>
        <translation>Ganz, in einem Anhang</translation>
    </message>
    <message>
        <source>Change the annex of the report</source>
        <translation>Anhang des Berichts ändern</translation>
    </message>
    <message>
        <source>Goes into the report where it is ticked.</source>
        <translation>Kommt in den Bericht, wo es angehakt ist.</translation>
    </message>
    <message>
        <source>Put %1 into the report</source>
        <translation>%1 in den Bericht aufnehmen</translation>
    </message>
    <message>
        <source>Leave %1 out of the report</source>
        <translation>%1 aus dem Bericht weglassen</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>English: none is chosen on the page Certificate.</source>
        <translation>Englisch: Auf der Seite Kalibrierschein ist keine gewählt.</translation>
    </message>
    <message>
        <source>%1, as chosen on the page Certificate.</source>
        <translation>%1, wie auf der Seite Kalibrierschein gewählt.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ReportPreview</name>
    <message>
        <source>Document</source>
        <translation>Dokument</translation>
    </message>
    <message>
        <source>What is shown: the report, or the calibration certificate</source>
        <translation>Was gezeigt wird: der Bericht oder der Kalibrierschein</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Kalibrierschein</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>Aktualisieren</translation>
    </message>
    <message>
        <source>The report</source>
        <translation>Der Bericht</translation>
    </message>
    <message>
        <source>The certificate</source>
        <translation>Der Kalibrierschein</translation>
    </message>
    <message>
        <source>Out of date: the project or its results have changed since.</source>
        <translation>Veraltet: Das Projekt oder seine Ergebnisse haben sich seither geändert.</translation>
    </message>
    <message>
        <source>%1 has not been made yet.</source>
        <translation>%1 wurde noch nicht erstellt.</translation>
    </message>
    <message>
        <source>The analyses are running: %1 waits for them.</source>
        <translation>Die Analysen laufen: %1 wartet auf sie.</translation>
    </message>
    <message>
        <source>No analysis is up to date: run one first (F5).</source>
        <translation>Keine Analyse ist aktuell: zuerst eine ausführen (F5).</translation>
    </message>
    <message>
        <source>%1 could not be made: %2</source>
        <translation>%1 konnte nicht erstellt werden: %2</translation>
    </message>
    <message>
        <source>1 page, as printed</source>
        <translation>1 Seite, wie gedruckt</translation>
    </message>
    <message>
        <source>%1 pages, as printed</source>
        <translation>%1 Seiten, wie gedruckt</translation>
    </message>
    <message>
        <source>%1; one required text is not stated</source>
        <translation>%1; ein geforderter Text ist nicht angegeben</translation>
    </message>
    <message>
        <source>%1; %2 required texts are not stated</source>
        <translation>%1; %2 geforderte Texte sind nicht angegeben</translation>
    </message>
    <message>
        <source>Pages as they are printed</source>
        <translation>Seiten, wie sie gedruckt werden</translation>
    </message>
    <message>
        <source>Being made …</source>
        <translation>wird erstellt …</translation>
    </message>
</context>
<context>
    <name>covaria::ui::RequirementsForm</name>
    <message>
        <source>U = %1: the target is %2.</source>
        <translation>U = %1: Die Zielunsicherheit ist %2.</translation>
    </message>
    <message>
        <source>met</source>
        <translation>eingehalten</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>nicht eingehalten</translation>
    </message>
    <message>
        <source>&lt;li&gt;u of %1 reduced from %2 to %3: %4 of what is stated&lt;/li&gt;</source>
        <translation>&lt;li&gt;u von %1 von %2 auf %3 verringert: %4 dessen, was angegeben ist&lt;/li&gt;</translation>
    </message>
    <message>
        <source>&lt;br&gt;It would be met with one of these alone:&lt;ul&gt;%1&lt;/ul&gt;</source>
        <translation>&lt;br&gt;Sie würde mit einem hiervon allein eingehalten:&lt;ul&gt;%1&lt;/ul&gt;</translation>
    </message>
    <message>
        <source>&lt;br&gt;No component suffices alone.</source>
        <translation>&lt;br&gt;Keine Komponente genügt allein.</translation>
    </message>
    <message>
        <source> It would be met with all standard uncertainties multiplied by %1.</source>
        <translation> Sie würde eingehalten, wenn alle Standardunsicherheiten mit %1 multipliziert würden.</translation>
    </message>
    <message>
        <source>(trials)</source>
        <translation>(Versuche)</translation>
    </message>
    <message>
        <source>(Student t)</source>
        <translation>(Student-t)</translation>
    </message>
    <message>
        <source>(normal)</source>
        <translation>(normal)</translation>
    </message>
    <message>
        <source>Not judged: %1.</source>
        <translation>Nicht beurteilt: %1.</translation>
    </message>
    <message>
        <source>By %5, guard band %1: the result is &lt;b&gt;%2&lt;/b&gt;. Probability of conformance %3 %4.</source>
        <translation>Nach %5, Schutzabstand %1: Das Ergebnis ist &lt;b&gt;%2&lt;/b&gt;. Konformitätswahrscheinlichkeit %3 %4.</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>zurückgewiesen</translation>
    </message>
    <message>
        <source>&lt;br&gt;TUR %1, C&lt;sub&gt;m&lt;/sub&gt; %2.</source>
        <translation>&lt;br&gt;TUR %1, C&lt;sub&gt;m&lt;/sub&gt; %2.</translation>
    </message>
    <message>
        <source>&lt;br&gt;Global risks of the rule: consumer&apos;s %1, producer&apos;s %2.</source>
        <translation>&lt;br&gt;Globale Risiken der Regel: Konsumentenrisiko %1, Produzentenrisiko %2.</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Change the requirement for %1</source>
        <translation>Anforderung an %1 ändern</translation>
    </message>
    <message>
        <source>By the law of propagation; Monte Carlo is to follow.</source>
        <translation>Nach dem Fortpflanzungsgesetz; Monte Carlo folgt noch.</translation>
    </message>
    <message>
        <source>By the trials of a preview; the whole run is to follow.</source>
        <translation>Nach den Versuchen einer Vorschau; der ganze Lauf folgt noch.</translation>
    </message>
    <message>
        <source>Run the analysis to see whether the requirement is met.</source>
        <translation>Die Analyse ausführen, um zu sehen, ob die Anforderung eingehalten ist.</translation>
    </message>
    <message>
        <source>&lt;br&gt;Of what the rule accepts %1 does not conform, of what it rejects %2 does.</source>
        <translation>&lt;br&gt;Von dem, was die Regel annimmt, ist %1 nicht konform, von dem, was sie zurückweist, ist %2 konform.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ResultTableModel</name>
    <message>
        <source>Ends of the interval differ by %1 and %2 from those of Monte Carlo; tolerance %3</source>
        <translation>Enden des Intervalls weichen um %1 und %2 von denen aus Monte Carlo ab; Toleranz %3</translation>
    </message>
    <message>
        <source>. Other trials could give the other verdict: more of them decide.</source>
        <translation>. Andere Versuche könnten das andere Urteil ergeben: mehr davon entscheiden.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ResultsPane</name>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Budget</source>
        <translation>Budget</translation>
    </message>
    <message>
        <source>Distributions</source>
        <translation>Verteilungen</translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation>Korrelation</translation>
    </message>
    <message>
        <source>Convergence</source>
        <translation>Konvergenz</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>Auswertung</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>digits of U: </source>
        <translation>Stellen von U: </translation>
    </message>
    <message>
        <source>Significant digits of uncertainties</source>
        <translation>Signifikante Stellen der Unsicherheiten</translation>
    </message>
    <message>
        <source>Significant digits of uncertainties in the window; estimates are rounded to match. Documents have those of the project page.</source>
        <translation>Signifikante Ziffern der Unsicherheiten im Fenster; Schätzwerte werden passend gerundet. Dokumente haben die der Projektseite.</translation>
    </message>
    <message>
        <source>Filter: symbol, name, group</source>
        <translation>Filter: Symbol, Name, Gruppe</translation>
    </message>
    <message>
        <source>Filter of the results</source>
        <translation>Filter der Ergebnisse</translation>
    </message>
    <message>
        <source>All groups</source>
        <translation>Alle Gruppen</translation>
    </message>
    <message>
        <source>Results of all poses, points or targets, whichever is selected</source>
        <translation>Ergebnisse aller Posen, Punkte oder Zielpunkte, gleich welche ausgewählt ist</translation>
    </message>
    <message>
        <source>Not met only</source>
        <translation>Nur nicht eingehaltene</translation>
    </message>
    <message>
        <source>Only results whose target uncertainty or tolerance is not met</source>
        <translation>Nur Ergebnisse, deren Zielunsicherheit oder Toleranz nicht eingehalten ist</translation>
    </message>
    <message>
        <source>results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Shortest Coverage Intervals</source>
        <translation>Kürzeste Überdeckungsintervalle</translation>
    </message>
    <message>
        <source>budget</source>
        <translation>Budget</translation>
    </message>
    <message>
        <source>correlation</source>
        <translation>Korrelation</translation>
    </message>
    <message>
        <source>All Results</source>
        <translation>Alle Ergebnisse</translation>
    </message>
    <message>
        <source>Go to Source</source>
        <translation>Zur Quelle</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Document</source>
        <translation>Dokument</translation>
    </message>
    <message>
        <source>Kind of chart</source>
        <translation>Art des Diagramms</translation>
    </message>
    <message>
        <source>Which charts of the result are shown</source>
        <translation>Welche Diagramme des Ergebnisses gezeigt werden</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Contributions</source>
        <translation>Beiträge</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Gesehen</translation>
    </message>
</context>
<context>
    <name>covaria::ui::RunActions</name>
    <message>
        <source>&amp;Run This Analysis</source>
        <translation>&amp;Diese Analyse ausführen</translation>
    </message>
    <message>
        <source>Run &amp;All</source>
        <translation>&amp;Alle ausführen</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>An&amp;halten</translation>
    </message>
    <message>
        <source>&amp;Live</source>
        <translation>&amp;Live</translation>
    </message>
    <message>
        <source>Each edit computes first-order results at once, then Monte Carlo</source>
        <translation>Jede Änderung berechnet sofort Ergebnisse erster Ordnung, dann Monte Carlo</translation>
    </message>
</context>
<context>
    <name>covaria::ui::RunStatus</name>
    <message>
        <source>%1 trials</source>
        <translation>%1 Versuche</translation>
    </message>
    <message>
        <source>, %1 million/s</source>
        <translation>, %1 Millionen/s</translation>
    </message>
    <message>
        <source>, %1 s left</source>
        <translation>, noch %1 s</translation>
    </message>
    <message>
        <source>Progress of the run</source>
        <translation>Fortschritt des Laufs</translation>
    </message>
    <message>
        <source>Stop all runs (Esc)</source>
        <translation>Alle Läufe anhalten (Esc)</translation>
    </message>
    <message>
        <source>Stop all runs</source>
        <translation>Alle Läufe anhalten</translation>
    </message>
    <message>
        <source>%1: %2 %</source>
        <translation>%1: %2 %</translation>
    </message>
    <message>
        <source>, best so far %1</source>
        <translation>, bisher bester %1</translation>
    </message>
    <message>
        <source>No analysis yet</source>
        <translation>Noch keine Analyse</translation>
    </message>
    <message>
        <source>No analysis selected</source>
        <translation>Keine Analyse ausgewählt</translation>
    </message>
    <message>
        <source>has problems</source>
        <translation>hat Probleme</translation>
    </message>
    <message>
        <source>, %1 trials</source>
        <translation>, %1 Versuche</translation>
    </message>
    <message>
        <source>, with warnings</source>
        <translation>, mit Warnungen</translation>
    </message>
    <message>
        <source>%1, kept state: </source>
        <translation>%1, gemerkter Stand: </translation>
    </message>
</context>
<context>
    <name>covaria::ui::ScenePanel</name>
    <message>
        <source>Select an analysis in the project tree to see its layout here.</source>
        <translation>Eine Analyse im Projektbaum auswählen, um hier ihre Anordnung zu sehen.</translation>
    </message>
    <message>
        <source>Which pose or group of outputs to show</source>
        <translation>Welche Pose oder Gruppe von Ausgangsgrößen gezeigt wird</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Iso</source>
        <translation>Iso</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Everything in the picture (F)</source>
        <translation>Alles im Bild (F)</translation>
    </message>
    <message>
        <source>Magnification of the uncertainty; it is always written in the picture</source>
        <translation>Vergrößerung der Unsicherheit; sie steht immer im Bild</translation>
    </message>
    <message>
        <source>Magnification of the uncertainty</source>
        <translation>Vergrößerung der Unsicherheit</translation>
    </message>
    <message>
        <source>× %1</source>
        <translation>× %1</translation>
    </message>
    <message>
        <source>Coverage probability of the ellipsoids</source>
        <translation>Überdeckungswahrscheinlichkeit der Ellipsoide</translation>
    </message>
    <message>
        <source>p = %1 %</source>
        <translation>p = %1 %</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Koordinatensysteme</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Links and Sight Lines</source>
        <translation>Glieder und Ziellinien</translation>
    </message>
    <message>
        <source>Vectors</source>
        <translation>Vektoren</translation>
    </message>
    <message>
        <source>Ellipsoids</source>
        <translation>Ellipsoide</translation>
    </message>
    <message>
        <source>Clouds</source>
        <translation>Punktwolken</translation>
    </message>
    <message>
        <source>Histograms on the Walls</source>
        <translation>Histogramme an den Wänden</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Beschriftungen</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
    <message>
        <source>Map of a Study or Design</source>
        <translation>Karte einer Studie oder eines Entwurfs</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;  at %2</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;  bei %2</translation>
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
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>Ellipsoids of the Kept State</source>
        <translation>Ellipsoide des gemerkten Stands</translation>
    </message>
    <message>
        <source>× auto</source>
        <translation>× auto</translation>
    </message>
    <message>
        <source>Context Meshes</source>
        <translation>Umgebungsnetze</translation>
    </message>
    <message>
        <source>View from the front right, from above (1); beside it standard and saved views, orthographic or perspective</source>
        <translation>Ansicht von vorn rechts oben (1); daneben Standard- und gespeicherte Ansichten, orthografisch oder perspektivisch</translation>
    </message>
    <message>
        <source>Layers: what the picture shows</source>
        <translation>Ebenen: was das Bild zeigt</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SceneView</name>
    <message>
        <source>3D scene</source>
        <translation>3D-Szene</translation>
    </message>
    <message>
        <source>The picture could not be written to %1</source>
        <translation>Das Bild konnte nicht nach %1 geschrieben werden</translation>
    </message>
    <message>
        <source>Drawing …</source>
        <translation>Wird gezeichnet …</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Copy Picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Save Picture …</source>
        <translation>Bild speichern …</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>scene.png</source>
        <translation>szene.png</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG-Bild (*.png)</translation>
    </message>
    <message>
        <source>Arrow keys turn the scene, plus and minus zoom, F fits, 1 to 7 are standard views, H hides what is selected, I shows it alone, Shift+H shows all; points and instruments can be dragged to another place</source>
        <translation>Pfeiltasten drehen die Szene, Plus und Minus zoomen, F passt ein, 1 bis 7 sind Standardansichten, H blendet das Gewählte aus, I zeigt nur dieses, Umschalt+H zeigt alles; Punkte und Messgeräte lassen sich an einen anderen Ort ziehen</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Show Only This</source>
        <translation>Nur dies zeigen</translation>
    </message>
    <message>
        <source>Show All</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Type Coordinates</source>
        <translation>Koordinaten eingeben</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SearchActions</name>
    <message>
        <source>&amp;Find Anything …</source>
        <translation>Alles &amp;finden …</translation>
    </message>
    <message>
        <source>analysis</source>
        <translation>Analyse</translation>
    </message>
    <message>
        <source>asset</source>
        <translation>Betriebsmittel</translation>
    </message>
    <message>
        <source>command, menu %1</source>
        <translation>Befehl, Menü %1</translation>
    </message>
    <message>
        <source>field of %1</source>
        <translation>Feld von %1</translation>
    </message>
    <message>
        <source>result of %1</source>
        <translation>Ergebnis von %1</translation>
    </message>
    <message>
        <source>input quantity of %1</source>
        <translation>Eingangsgröße von %1</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>Reiter</translation>
    </message>
    <message>
        <source>help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>help: %1</source>
        <translation>Hilfe: %1</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SearchPalette</name>
    <message>
        <source>Find anything</source>
        <translation>Alles finden</translation>
    </message>
    <message>
        <source>Analyses, quantities, results, fields, commands, help</source>
        <translation>Analysen, Größen, Ergebnisse, Felder, Befehle, Hilfe</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Was gefunden wurde</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SecondPart</name>
    <message>
        <source>View of the second part</source>
        <translation>Ansicht des zweiten Teils</translation>
    </message>
    <message>
        <source>What the second part of the stage shows</source>
        <translation>Was der zweite Teil des Hauptbereichs zeigt</translation>
    </message>
    <message>
        <source>Close this part</source>
        <translation>Diesen Teil schließen</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SeenTab</name>
    <message>
        <source>seen</source>
        <translation>gesehen</translation>
    </message>
    <message>
        <source>What the residuals say</source>
        <translation>Was die Residuen sagen</translation>
    </message>
    <message>
        <source>Level of the tests</source>
        <translation>Niveau der Tests</translation>
    </message>
    <message>
        <source>How often a figure that is right is contradicted by chance</source>
        <translation>Wie oft einer richtigen Angabe durch Zufall widersprochen wird</translation>
    </message>
    <message>
        <source>Level %1 %</source>
        <translation>Niveau %1 %</translation>
    </message>
    <message>
        <source>Back to Stated</source>
        <translation>Zurück zu den Angaben</translation>
    </message>
    <message>
        <source>Take Over as Seen</source>
        <translation>Wie gesehen übernehmen</translation>
    </message>
    <message>
        <source>The results follow from the stated uncertainties again</source>
        <translation>Die Ergebnisse folgen wieder aus den angegebenen Unsicherheiten</translation>
    </message>
    <message>
        <source>The results, and all that hang on them, follow from the uncertainties that the residuals see, and change with the readings; can be undone</source>
        <translation>Die Ergebnisse und alles, was von ihnen abhängt, folgen aus den Unsicherheiten, die die Residuen sehen, und ändern sich mit den Ablesungen; kann rückgängig gemacht werden</translation>
    </message>
    <message>
        <source>Back to stated uncertainties</source>
        <translation>Zurück zu den angegebenen Unsicherheiten</translation>
    </message>
    <message>
        <source>Take over uncertainties as seen</source>
        <translation>Unsicherheiten wie gesehen übernehmen</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SeenTableModel</name>
    <message>
        <source>interval of the factor</source>
        <translation>Intervall des Faktors</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SetupForm</name>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weitere</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>From “%1”: %2. What is stated of them here is not used.</source>
        <translation>Aus „%1“: %2. Was hier von ihnen angegeben ist, wird nicht verwendet.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SetupTableModel</name>
    <message>
        <source>Insert rows in %1</source>
        <translation>Zeilen in %1 einfügen</translation>
    </message>
    <message>
        <source>Delete rows of %1</source>
        <translation>Zeilen von %1 löschen</translation>
    </message>
    <message>
        <source>Paste into %1</source>
        <translation>In %1 einfügen</translation>
    </message>
    <message>
        <source>Delete rows</source>
        <translation>Zeilen löschen</translation>
    </message>
    <message>
        <source>Fill down in %1</source>
        <translation>In %1 nach unten ausfüllen</translation>
    </message>
    <message>
        <source>Clear cells of %1</source>
        <translation>Zellen von %1 leeren</translation>
    </message>
    <message>
        <source>Change unit in %1</source>
        <translation>Einheit in %1 ändern</translation>
    </message>
    <message>
        <source>Take %1 into the project</source>
        <translation>%1 in das Projekt übernehmen</translation>
    </message>
    <message>
        <source>%1 is no unit for a quantity in %2.</source>
        <translation>%1 ist keine Einheit für eine Größe in %2.</translation>
    </message>
    <message>
        <source>Its value is %1 of the analysis “%2”: what is stated here is not used.</source>
        <translation>Ihr Wert ist %1 der Analyse „%2“: Was hier angegeben ist, wird nicht verwendet.</translation>
    </message>
    <message>
        <source>%1 of the value</source>
        <translation>%1 des Wertes</translation>
    </message>
    <message>
        <source>%1 absolute, not a part of the value</source>
        <translation>%1 absolut, kein Teil des Wertes</translation>
    </message>
    <message>
        <source>Change %1: %2</source>
        <translation>%1 ändern: %2</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>Zeile %1</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SortableTable</name>
    <message>
        <source>Click to sort, right click to choose columns</source>
        <translation>Klick sortiert, Rechtsklick wählt Spalten</translation>
    </message>
    <message>
        <source>Save Table</source>
        <translation>Tabelle speichern</translation>
    </message>
    <message>
        <source>CSV table (*.csv)</source>
        <translation>CSV-Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Alles auswählen</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>Original Order</source>
        <translation>Ursprüngliche Reihenfolge</translation>
    </message>
    <message>
        <source>Save as CSV …</source>
        <translation>Als CSV speichern …</translation>
    </message>
    <message>
        <source>Fit Widths</source>
        <translation>Breiten anpassen</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SpreadsheetView</name>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Ausschneiden</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Fill down</source>
        <translation>Nach unten ausfüllen</translation>
    </message>
    <message>
        <source>Insert row above</source>
        <translation>Zeile darüber einfügen</translation>
    </message>
    <message>
        <source>Add row at the end</source>
        <translation>Zeile am Ende anfügen</translation>
    </message>
    <message>
        <source>Delete rows</source>
        <translation>Zeilen löschen</translation>
    </message>
</context>
<context>
    <name>covaria::ui::Stage</name>
    <message>
        <source>Two views at once</source>
        <translation>Zwei Ansichten zugleich</translation>
    </message>
    <message>
        <source>Below Each Other</source>
        <translation>Untereinander</translation>
    </message>
    <message>
        <source>Beside Each Other</source>
        <translation>Nebeneinander</translation>
    </message>
</context>
<context>
    <name>covaria::ui::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>Startseite</translation>
    </message>
    <message>
        <source>New Project</source>
        <translation>Neues Projekt</translation>
    </message>
    <message>
        <source>Open …</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>They open as new projects; the shipped files stay as they are.</source>
        <translation>Sie öffnen sich als neue Projekte; die mitgelieferten Dateien bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>Projects that you open are listed here.</source>
        <translation>Geöffnete Projekte stehen hier.</translation>
    </message>
    <message>
        <source>First Steps</source>
        <translation>Erste Schritte</translation>
    </message>
    <message>
        <source>A budget from nothing to a PDF, in ten steps beside the window</source>
        <translation>Ein Budget von nichts bis zum PDF, in zehn Schritten neben dem Fenster</translation>
    </message>
    <message>
        <source>What do you want to know?</source>
        <translation>Was möchten Sie wissen?</translation>
    </message>
    <message>
        <source>Library …</source>
        <translation>Bibliothek …</translation>
    </message>
    <message>
        <source>A quantity by an equation</source>
        <translation>Eine Größe aus einer Gleichung</translation>
    </message>
    <message>
        <source>Type y = f(x), state each input, get the budget.</source>
        <translation>y = f(x) eintippen, jede Eingangsgröße angeben, das Budget erhalten.</translation>
    </message>
    <message>
        <source>Points by instruments</source>
        <translation>Punkte mit Messgeräten</translation>
    </message>
    <message>
        <source>Tracker, total station, camera; one or many.</source>
        <translation>Tracker, Totalstation, Kamera; eines oder viele.</translation>
    </message>
    <message>
        <source>The pose of an object</source>
        <translation>Die Pose eines Objekts</translation>
    </message>
    <message>
        <source>A frame from its points, in the frame of another.</source>
        <translation>Ein System aus seinen Punkten, im System eines anderen.</translation>
    </message>
    <message>
        <source>A robot</source>
        <translation>Ein Roboter</translation>
    </message>
    <message>
        <source>Where its tool is, and what its parameters are.</source>
        <translation>Wo sein Werkzeug ist und welche Parameter er hat.</translation>
    </message>
    <message>
        <source>A file I have</source>
        <translation>Eine vorhandene Datei</translation>
    </message>
    <message>
        <source>Excel budget, points, measurement report.</source>
        <translation>Excel-Budget, Punkte, Messbericht.</translation>
    </message>
    <message>
        <source>Budget, Points or Report …</source>
        <translation>Budget, Punkte oder Bericht …</translation>
    </message>
    <message>
        <source>Robot (URDF) …</source>
        <translation>Roboter (URDF) …</translation>
    </message>
    <message>
        <source>Project …</source>
        <translation>Projekt …</translation>
    </message>
</context>
<context>
    <name>covaria::ui::StudiesForm</name>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Adds a study of this analysis</source>
        <translation>Fügt eine Studie dieser Analyse hinzu</translation>
    </message>
    <message>
        <source>Adds a copy of this study</source>
        <translation>Fügt eine Kopie dieser Studie hinzu</translation>
    </message>
    <message>
        <source>Deletes this study</source>
        <translation>Löscht diese Studie</translation>
    </message>
    <message>
        <source>Evaluates the analysis at every grid point of this study</source>
        <translation>Wertet die Analyse an jedem Gitterpunkt dieser Studie aus</translation>
    </message>
    <message>
        <source>A study evaluates this analysis for many values of a number: a sweep over one, a map over two or three. Add one to see how the uncertainty depends on the set-up.</source>
        <translation>Eine Studie wertet diese Analyse für viele Werte einer Zahl aus: ein Durchlauf über eine, eine Karte über zwei oder drei. Eine hinzufügen, um zu sehen, wie die Unsicherheit vom Aufbau abhängt.</translation>
    </message>
    <message>
        <source>Name of the study</source>
        <translation>Name der Studie</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>Law of propagation</source>
        <translation>Fortpflanzungsgesetz</translation>
    </message>
    <message>
        <source>Monte Carlo</source>
        <translation>Monte Carlo</translation>
    </message>
    <message>
        <source>Trials at each grid point</source>
        <translation>Versuche an jedem Gitterpunkt</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Trials per point</source>
        <translation>Versuche je Punkt</translation>
    </message>
    <message>
        <source>Add Axis</source>
        <translation>Achse hinzufügen</translation>
    </message>
    <message>
        <source>Varies one more number: every combination is evaluated</source>
        <translation>Variiert eine weitere Zahl: Jede Kombination wird ausgewertet</translation>
    </message>
    <message>
        <source>Output quantities of the study</source>
        <translation>Ausgangsgrößen der Studie</translation>
    </message>
    <message>
        <source>Output quantities looked at; with none ticked, all measurands</source>
        <translation>Betrachtete Ausgangsgrößen; ist keine angehakt, alle Messgrößen</translation>
    </message>
    <message>
        <source>Outputs (none ticked: all measurands)</source>
        <translation>Ausgangsgrößen (keine angehakt: alle Messgrößen)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::StudyAxisEdit</name>
    <message>
        <source>Axis %1</source>
        <translation>Achse %1</translation>
    </message>
    <message>
        <source>Variable %1</source>
        <translation>Variable %1</translation>
    </message>
    <message>
        <source>Remove Axis</source>
        <translation>Achse entfernen</translation>
    </message>
    <message>
        <source>Remove Variable</source>
        <translation>Variable entfernen</translation>
    </message>
    <message>
        <source>takes these values</source>
        <translation>nimmt diese Werte an</translation>
    </message>
    <message>
        <source>is multiplied with</source>
        <translation>wird multipliziert mit</translation>
    </message>
    <message>
        <source>has added to it</source>
        <translation>wird erhöht um</translation>
    </message>
    <message>
        <source>evenly spaced</source>
        <translation>gleichmäßig verteilt</translation>
    </message>
    <message>
        <source>logarithmically spaced</source>
        <translation>logarithmisch verteilt</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Number of values</source>
        <translation>Anzahl der Werte</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>It can be put into effect only so well: what counts is the worst within it</source>
        <translation>Genauer lässt es sich nicht verwirklichen: Es zählt das Schlechteste innerhalb davon</translation>
    </message>
    <message>
        <source>Varied</source>
        <translation>Variiert</translation>
    </message>
    <message>
        <source>It</source>
        <translation>Wie</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>choose what is varied</source>
        <translation>wählen, was variiert wird</translation>
    </message>
    <message>
        <source> (factor)</source>
        <translation> (Faktor)</translation>
    </message>
    <message>
        <source>%1: has a problem</source>
        <translation>%1: hat ein Problem</translation>
    </message>
</context>
<context>
    <name>covaria::ui::StudyTab</name>
    <message>
        <source>study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Study of this analysis</source>
        <translation>Studie dieser Analyse</translation>
    </message>
    <message>
        <source>Run Study</source>
        <translation>Studie ausführen</translation>
    </message>
    <message>
        <source>Edit …</source>
        <translation>Bearbeiten …</translation>
    </message>
    <message>
        <source>Axes, outputs and method of the study, in the properties of the analysis</source>
        <translation>Achsen, Ausgangsgrößen und Methode der Studie, in den Eigenschaften der Analyse</translation>
    </message>
    <message>
        <source>Quantity of the study</source>
        <translation>Größe der Studie</translation>
    </message>
    <message>
        <source>What the chart and the scene show</source>
        <translation>Was das Diagramm und die Szene zeigen</translation>
    </message>
    <message>
        <source>Kind of chart</source>
        <translation>Art des Diagramms</translation>
    </message>
    <message>
        <source>A map, or lines over the first axis</source>
        <translation>Eine Karte oder Linien über der ersten Achse</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>Axis of the slices</source>
        <translation>Achse der Schnitte</translation>
    </message>
    <message>
        <source>Which axis the slices are across</source>
        <translation>Quer zu welcher Achse die Schnitte liegen</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>slice only</source>
        <translation>nur Schnitt</translation>
    </message>
    <message>
        <source>In the scene: the points of this slice; else all</source>
        <translation>In der Szene: die Punkte dieses Schnitts; sonst alle</translation>
    </message>
    <message>
        <source>ellipsoids</source>
        <translation>Ellipsoide</translation>
    </message>
    <message>
        <source>In the scene: coverage ellipsoids at the grid points</source>
        <translation>In der Szene: Überdeckungsellipsoide an den Gitterpunkten</translation>
    </message>
    <message>
        <source>Add Study …</source>
        <translation>Studie hinzufügen …</translation>
    </message>
    <message>
        <source>Out of date: of the project as it was</source>
        <translation>Veraltet: vom früheren Stand des Projekts</translation>
    </message>
    <message>
        <source>slice: </source>
        <translation>Schnitt: </translation>
    </message>
    <message>
        <source> – out of date</source>
        <translation> – veraltet</translation>
    </message>
    <message>
        <source>running …</source>
        <translation>läuft …</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Fehlgeschlagen: %1</translation>
    </message>
    <message>
        <source>Not evaluated yet.</source>
        <translation>Noch nicht ausgewertet.</translation>
    </message>
    <message>
        <source>%1 grid points</source>
        <translation>%1 Gitterpunkte</translation>
    </message>
    <message>
        <source>, %1 without values</source>
        <translation>, %1 ohne Werte</translation>
    </message>
    <message>
        <source>&lt;b&gt;Out of date&lt;/b&gt;: shown for the project as it was. </source>
        <translation>&lt;b&gt;Veraltet&lt;/b&gt;: gezeigt für den früheren Stand des Projekts. </translation>
    </message>
    <message>
        <source>“%1” shows how the uncertainty depends on what the study varies.</source>
        <translation>„%1“ zeigt, wie die Unsicherheit von dem abhängt, was die Studie variiert.</translation>
    </message>
    <message>
        <source>A study evaluates the analysis for many values of a number: add one with “%1”.</source>
        <translation>Eine Studie wertet die Analyse für viele Werte einer Zahl aus: eine hinzufügen mit „%1“.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::StudyTableModel</name>
    <message>
        <source>Remark</source>
        <translation>Bemerkung</translation>
    </message>
    <message>
        <source>Why there are no values, or what is wrong with them</source>
        <translation>Warum es keine Werte gibt oder was mit ihnen nicht stimmt</translation>
    </message>
</context>
<context>
    <name>covaria::ui::TabBar</name>
    <message>
        <source>More tabs</source>
        <translation>Weitere Reiter</translation>
    </message>
</context>
<context>
    <name>covaria::ui::TableEditor</name>
    <message>
        <source>Take into the project</source>
        <translation>In das Projekt übernehmen</translation>
    </message>
    <message>
        <source>Add row</source>
        <translation>Zeile hinzufügen</translation>
    </message>
    <message>
        <source>Delete rows</source>
        <translation>Zeilen löschen</translation>
    </message>
    <message>
        <source>Import CSV …</source>
        <translation>CSV importieren …</translation>
    </message>
    <message>
        <source>Read from %1</source>
        <translation>Gelesen aus %1</translation>
    </message>
    <message>
        <source>The rows are read from %1. Taken into the project they can be edited here.</source>
        <translation>Die Zeilen werden aus %1 gelesen. In das Projekt übernommen, können sie hier bearbeitet werden.</translation>
    </message>
    <message>
        <source>Import CSV into %1</source>
        <translation>CSV in %1 importieren</translation>
    </message>
    <message>
        <source>Tables (*.csv *.tsv *.txt);;All files (*)</source>
        <translation>Tabellen (*.csv *.tsv *.txt);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 importieren</translation>
    </message>
    <message>
        <source>All columns</source>
        <translation>Alle Spalten</translation>
    </message>
    <message>
        <source>Shows also the columns that no row has something in</source>
        <translation>Zeigt auch die Spalten, in denen keine Zeile etwas hat</translation>
    </message>
</context>
<context>
    <name>covaria::ui::TargetBox</name>
    <message>
        <source>What is varied: type a part of its name to search</source>
        <translation>Was variiert wird: einen Teil des Namens eingeben, um zu suchen</translation>
    </message>
    <message>
        <source>What is varied</source>
        <translation>Was variiert wird</translation>
    </message>
    <message>
        <source>“%1” names nothing that can be varied.</source>
        <translation>„%1“ benennt nichts, was variiert werden kann.</translation>
    </message>
    <message numerus="yes">
        <source>“%1” names %n things that can be varied.</source>
        <translation>
            <numerusform>„%1“ benennt %n Dinge, die variiert werden können.</numerusform>
            <numerusform>„%1“ benennt %n Dinge, die variiert werden können.</numerusform>
        </translation>
    </message>
    <message>
        <source> (factor)</source>
        <translation> (Faktor)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::UnitButton</name>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>Units of the tables and charts</source>
        <translation>Einheiten der Tabellen und Diagramme</translation>
    </message>
    <message>
        <source>As the Model Gives Them</source>
        <translation>Wie das Modell sie liefert</translation>
    </message>
    <message>
        <source>Change unit of results</source>
        <translation>Einheit der Ergebnisse ändern</translation>
    </message>
    <message>
        <source>Clear units of results</source>
        <translation>Einheiten der Ergebnisse löschen</translation>
    </message>
    <message>
        <source>In Reports and Files Too</source>
        <translation>Auch in Berichten und Dateien</translation>
    </message>
    <message>
        <source>States the units that are shown in the project: they are those of its documents</source>
        <translation>Hält die gezeigten Einheiten im Projekt fest: Es sind dann die seiner Dokumente</translation>
    </message>
    <message>
        <source>Units of the tables and charts; reports and files have those that the project states</source>
        <translation>Einheiten der Tabellen und Diagramme; Berichte und Dateien haben die, die das Projekt festlegt</translation>
    </message>
</context>
<context>
    <name>covaria::ui::UnitChoices</name>
    <message>
        <source>Lengths</source>
        <translation>Längen</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Kräfte</translation>
    </message>
    <message>
        <source>Moments</source>
        <translation>Momente</translation>
    </message>
</context>
<context>
    <name>covaria::ui::UnreadTexts</name>
    <message>
        <source>What is typed in a field cannot be read. %1</source>
        <translation>Was in ein Feld eingegeben ist, kann nicht gelesen werden. %1</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ViewActions</name>
    <message>
        <source>&amp;Scene</source>
        <translation>&amp;Szene</translation>
    </message>
    <message>
        <source>Save View</source>
        <translation>Ansicht speichern</translation>
    </message>
    <message>
        <source>Name of the view:</source>
        <translation>Name der Ansicht:</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>&amp;Orthographic</source>
        <translation>&amp;Orthografisch</translation>
    </message>
    <message>
        <source>Parallel lines stay parallel, and the scale bar holds everywhere</source>
        <translation>Parallele Linien bleiben parallel, und der Maßstab gilt überall</translation>
    </message>
    <message>
        <source>Show &amp;All</source>
        <translation>&amp;Alles zeigen</translation>
    </message>
    <message>
        <source>&amp;Save View …</source>
        <translation>Ansicht &amp;speichern …</translation>
    </message>
    <message>
        <source>Remo&amp;ve View</source>
        <translation>Ansicht ent&amp;fernen</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Ansicht %1</translation>
    </message>
    <message>
        <source>Save View %1</source>
        <translation>Ansicht %1 speichern</translation>
    </message>
    <message>
        <source>Remove View %1</source>
        <translation>Ansicht %1 entfernen</translation>
    </message>
</context>
</TS>
