<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>QObject</name>
    <message>
        <source>Move %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;%1 more rows; the exported table has all of them.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>Pose from points</source>
        <extracomment>Measurement model</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nominal coordinates of the points in their own frame, and standard uncertainties of single coordinates where they differ from the common ones.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the point.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nominal coordinate x in the point&apos;s own frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nominal coordinate y in the point&apos;s own frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nominal coordinate z in the point&apos;s own frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of this x; empty: as typed for all.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of this y; empty: as typed for all.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of this z; empty: as typed for all.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame from its points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3-2-1: the origin from point 1, the x-axis from points 1 and 2, the xy-plane from points 1, 2 and 3. Least squares: the frame in which the nominal coordinates fit all points best.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3-2-1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>least squares</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Side of point 3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On which side of the x-axis point 3 lies in the base frame b; this directs z.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>negative y: z = (q3 − q1) × x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>positive y: z = x × (q3 − q1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Origin from point 1, x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along x of the base frame b (s of Eqs 17 and 18).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Origin from point 1, y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along y of the base frame b (s of Eqs 17 and 18).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Origin from point 1, z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along z of the base frame b (s of Eqs 17 and 18).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pose of the base in frame 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the base stands in the frame of the measurement (frame 0, the world of the picture). It matters only for an instrument that stands somewhere.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moving frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points of the moving frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On which side of the x-axis point 3 lies in the moving frame p; this directs z.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along x of the moving frame p (s of Eqs 17 and 18).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along y of the moving frame p (s of Eqs 17 and 18).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along z of the moving frame p (s of Eqs 17 and 18).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Poses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A priori: at the nominal coordinates. A posteriori: at the means of measured coordinates.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a priori (nominal poses)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a posteriori (measured points)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nominal poses of the moving frame in the base frame; angles are R = Rz(γ) Ry(β) Rx(α). All poses share the measurement of the base.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the pose; groups its results.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position x in the base frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position y in the base frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position z in the base frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation about x.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation about y.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation about z.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coordinates in one frame 0 for the base and every pose, typed or from a CSV file; the mean of the repeats is the estimate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;base&quot;, or the name of a pose.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of the repetition.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured coordinate x in frame 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured coordinate y in frame 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured coordinate z in frame 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orientation stated as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbers in which the result states the orientation of the moving frame. Angles are undefined in gimbal lock; rotation vector and quaternion are not.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Z-Y-X angles (roll α, pitch β, yaw γ)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Z-Y-Z angles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotation vector</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit quaternion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty: Base frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty of the points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainties typed here, or those that an artefact or an instrument of the project gives.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>typed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>artefact or instrument</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along x of the base frame b.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u_x is common</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One and the same deviation along x for all base points, instead of independent ones.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along y of the base frame b.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u_y is common</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One and the same deviation along y for all base points, instead of independent ones.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along z of the base frame b.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u_z is common</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One and the same deviation along z for all base points, instead of independent ones.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Their distribution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The distribution of typed deviations of the points; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rectangular: limits ± √3 u</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>triangular: limits ± √6 u</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>arc sine: limits ± √2 u</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Artefact or instrument</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gives the uncertainty of the coordinates of the points of the base frame b.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty: Moving frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along x of the moving frame p.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One and the same deviation along x for all points of the moving frame, in all poses, instead of independent ones.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along y of the moving frame p.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One and the same deviation along y for all points of the moving frame, in all poses, instead of independent ones.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along z of the moving frame p.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One and the same deviation along z for all points of the moving frame, in all poses, instead of independent ones.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gives the uncertainty of the coordinates of the points of the moving frame p.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainties along</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along which axes the typed uncertainties of the moving points lie: those of the moving frame, which turn with it, or those of the base frame, the same in all poses.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the axes of the moving frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the axes of the base frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points from sensors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Network</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The instruments of the network, each an instrument of the project that stands somewhere.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sensor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An instrument of the project.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Targets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points to be localised, at their nominal coordinates.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the target, unique.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nominal coordinate x.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nominal coordinate y.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nominal coordinate z.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>new set-up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sensors were located anew before this target: it and those below share the deviations of the stations with each other, not with the targets above.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distances between targets that are measurands too, for instance of a scale bar.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of a target.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of another target.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angles at a target between the directions to two others, measurands too.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the target where the angle is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of a third target.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames on three targets (3-2-1), whose position and Z-Y-X angles in the world are measurands too.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the frame, unique.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>origin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target at its origin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target on its positive x-axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in xy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target in its xy-plane, at positive y.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrated lengths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale bars and other calibrated distances between two targets: compared with the network, or a constraint of the estimation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrated length; empty in a design: the distance of the nominal targets.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of the length as it is during the measurement, with temperature.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>role</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check: the difference between network and calibration is a measurand. Constraint: the length is adjusted with the readings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>constraint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distribution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The distribution that has the standard uncertainty u; empty: normal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A priori: the readings are those of the nominal targets. A posteriori: the readings are given.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a priori (design: nominal targets)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a posteriori (given readings)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the sensors read, one row for a sensor and a target, typed or from a CSV file; leave empty what was not read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the target.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The instrument that read it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slope distance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>azimuth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Horizontal angle from the sensor&apos;s x-axis, positive towards y; whole turns do not matter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>elevation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertical angle above the sensor&apos;s xy-plane.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How a target&apos;s coordinates follow from its readings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>non-linear weighted least squares</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>linearised equations: OLS, then GLS (Eqs 1-4 of the paper)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>linearised equations: OLS alone (Eq 3 of the paper)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the weights of the equations account for. Weights from the readings alone, as in the paper, are not the best where the stations are uncertain.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>readings and stations, all targets of a set-up at once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>readings alone, each target by itself (the paper)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP from ballbars</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ballbars</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The set of telescopic ballbars that measures the points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gives the repeatability with which the robot goes to the points; none: an ideal robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool centre point from a planned procedure or from measured points; or only the points as the ballbars measure them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tool centre point, planned procedure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tool centre point, measured points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>points alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Procedure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flange</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pose of the flange in the robot&apos;s frame before it turns; its origin is the centre of the sphere on which the ball moves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nominal coordinate x of the tool centre point in the flange&apos;s frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nominal coordinate y of the tool centre point in the flange&apos;s frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nominal coordinate z of the tool centre point in the flange&apos;s frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two or three rotations of the flange about its own axes, its origin held in place: the ball traces an arc in each.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis of the flange about which the robot turns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle at the first point.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>span</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle from the first point to the last; negative: turned the other way.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of points, equally spaced from the first to the last.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points as measured, each with the axis of its rotation and the commanded angle, typed or from a CSV file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commanded angle of rotation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coordinate x in the frame of the ballbars.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coordinate y in the frame of the ballbars.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coordinate z in the frame of the ballbars.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Places of the ball that are measured, typed or from a CSV file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the point, unique.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axes of the flange</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured axes are not exactly perpendicular: which one is kept as measured. A third measured axis then only helps the sphere and the mean.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y as measured, x nearest to measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x as measured, y nearest to measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>z as measured, x nearest to measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nearest to all measured axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre of the flange</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sphere through all points by linear least squares, or refined to least distances from it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sphere, geometric fit from the linear one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sphere, linear fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm, with its parameters and their uncertainty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Components of a parameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each by itself, so that the budget tells the sources apart; or combined into one normal deviation, which needs fewer draws.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>each by itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>combined into one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correlation of the parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Used as the robot states it; or ignored, as in the paper, to see what that does.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ignored (the paper)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Poses by joint readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Readings of the joints, typed or from a CSV file. An empty cell is the zero reading of the joint; a robot with fewer joints leaves the last columns empty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the pose, unique.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of joint 1, if it turns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of joint 2, if it turns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of joint 3, if it turns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of joint 4, if it turns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of joint 5, if it turns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of joint 6, if it turns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of joint 7, if it turns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of joint 1, if it slides.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of joint 2, if it slides.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of joint 3, if it slides.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of joint 4, if it slides.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of joint 5, if it slides.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of joint 6, if it slides.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of joint 7, if it slides.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Poses by place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Places of the tool in the robot&apos;s base frame; the readings follow by inverse kinematics, within the limits and near those of the pose before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name, unique.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coordinate x of the tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coordinate y of the tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coordinate z of the tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orientation, R = Rz(gamma) Ry(beta) Rx(alpha); all three empty: any orientation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbers that state the orientation of the tool; none: the position alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none (position alone)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The frame in which position and orientation are stated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the base frame of the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the world frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot by joint trajectories</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nominal robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm as designed: directions of the frames, definitions of base and last link, and the arm of a simulation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured: a table. Simulated: those of the nominal robot, to see what an experiment would give.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>simulated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points of the ball at the flange in the order in which they were measured, joint by joint, in the frame of the instrument&apos;s world; typed or from a CSV file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>joint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of the joint that turned.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of that joint; says which way round the points run. Empty: with the joint&apos;s positive direction.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coordinate x.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coordinate y.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coordinate z.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range of each joint, ±</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each joint turns from its zero reading less this to its zero reading plus this.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points for each joint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of points, evenly spaced over the range.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ball</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the ball is in the frame of the last link. On the axis of a joint it draws no circle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A standard uncertainty of every coordinate, or an instrument of the project that stands somewhere.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>typed: alike for all coordinates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an instrument</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of a coordinate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of every coordinate of every point, independent of all others.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The distribution of the coordinates&apos; deviations; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What measured the points: each reading deviates by itself, its scale and its station alike for all points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plane of a circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Total least squares fits any plane. Eq 1 of the paper has no plane through the origin and fails near it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>total least squares</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A x + B y + C z + 1 = 0 (Eq 1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axes are parallel below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle between two axes below which they are described by beta and not by their common perpendicular, whose place is then hardly determined.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot from measured poses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arm as designed: start of the fit, values of what the poses cannot tell, uncertainty of the readings of its joints, and the arm of a simulation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Poses are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The position of a ball alone, or position and orientation of the tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>position and orientation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured poses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Readings of the joints and the place of the ball or tool that was measured there; typed or from a CSV file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fit: taken into the fit. check: held back, to see how well the fit tells a pose that it has not seen. Empty: fit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of joint 1; empty: its zero reading.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of joint 2; empty: its zero reading.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of joint 3; empty: its zero reading.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of joint 4; empty: its zero reading.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of joint 5; empty: its zero reading.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of joint 6; empty: its zero reading.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of joint 7; empty: its zero reading.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured coordinate x in the frame of the instrument&apos;s world.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured coordinate y in the frame of the instrument&apos;s world.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured coordinate z in the frame of the instrument&apos;s world.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured orientation, R = Rz(gamma) Ry(beta) Rx(alpha), where poses are measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of poses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Poses of the simulated experiment, spread over the range of all joints, always the same.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the zero reading on, as far as the limits of the joint allow.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of an orientation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the rotation of the measured tool about each of its axes, independent.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ball or tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where it is in the frame of the last link: exactly, or as a start of the fit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place of the ball or tool is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Found by the fit together with the parameters, or known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>found by the fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>known exactly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place of the base is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Found by the fit: the instrument stands anywhere. Known: the base stands where the robot says it stands in the world.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters that stay nominal although the poses could tell them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A parameter by its symbol, such as d_3 or alpha_4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Channels of a force/moment sensor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The calibrated multi-axis sensor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loads on the other axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What acts on the other axes while a channel is read. Unknown loads are rectangular between minus and plus the rated load, one and the same for all channels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none: one component alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown on one axis, that with the largest interference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown on all other axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeatability</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The largest standard deviation of all steps, as in the paper, or that pooled over the steps, which has more degrees of freedom.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest of the steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pooled over the steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type A in Monte Carlo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal, with its degrees of freedom in the law of propagation, or a t-distribution (JCGM 101 6.4.9). With n = 3 the latter has no standard deviation: only coverage intervals then mean something.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scaled and shifted t</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coverage factor of the comparison</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>k of the GUM&apos;s columns in the table beside the paper&apos;s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forces and moments by the calibration matrix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cases</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cases are given by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Readings that were taken, or loads whose uncertainty is wanted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>loads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Net readings of all channels, the unloaded readings subtracted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Names the case in results.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fx</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Net reading of this channel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mx</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>My</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forces and moments that act together; the readings follow from the calibration matrix. An empty cell is zero.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load on this axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibration matrix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least squares through zero over the increasing readings: slopes alone, or with the squares of the loads.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>linear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with quadratic terms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeatability of a reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The largest standard deviation of all steps, or that pooled over the steps.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal, with its degrees of freedom in the law of propagation, or a t-distribution (JCGM 101 6.4.9), which has no standard deviation with n = 3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hysteresis of a reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rectangular over the width of the loop: in proportion to the load on the channel&apos;s axis, or the full width at any load.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in proportion to the load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>full at any load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measurement equation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Equations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One equation a line: y = x_1*x_2 + 3 [mm]. Names without an equation are input quantities. &apos;solve y = 1: y^2 = x&apos; finds y in every trial, from its starting value. &apos;#&apos; starts a comment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is reported, and in which unit. Without rows: every name that an equation defines and no other one uses, in SI units.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>symbol</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name that an equation defines.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it is, for tables and reports.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit of the result; empty: the SI unit that follows from the equations.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measurands have coverage regions together; empty: measurand.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measurand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>intermediate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results of one group have a joint coverage region.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quantities</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One row for each component of uncertainty. The first row of a symbol has its value and unit; further rows of the same symbol add components and have no value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name that the equations use: x_1, alpha_s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it is, or what the component is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimate, in the row&apos;s unit; empty where observations or limits give it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit of value, a and b; empty: 1. A difference of temperatures is given in K.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stated as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How its uncertainty is known; a and b are then: u; U and k; U and p in %; half-width (and inexactness, or ratio of top to base); lower and upper limit; step of the indication; permissible error and % of the value; number of counts; number of observations in the mean (pooled). Empty: a constant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>constant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>standard uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>certificate, U and k</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>certificate, U and p</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rectangular</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>limits from a to b</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>limits inexactly known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>trapezoidal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>triangular</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>arc sine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>resolution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>maximum permissible error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exponential</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>counts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>observations (Type A)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pooled observations (Type A)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading of an instrument</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First figure of the statement, in the row&apos;s unit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second figure of the statement.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Degrees of freedom; empty: infinite, or those of the observations.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relative uncertainty of u instead of degrees of freedom (JCGM 100 G.3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the figure comes from: certificate, data sheet, handbook.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>instrument</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Instrument of the project that reads the quantity, a distance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Observations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeated observations for Type A evaluations, typed, pasted or from a CSV file. Observations of several quantities with the same numbers were made together: their means are then correlated (JCGM 100 5.2.3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Symbol of the quantity.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of the simultaneous observation; empty: the quantity was observed by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>series</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of an earlier series of the same procedure, for a pooled standard deviation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Observed value, in the unit of the quantity.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Means of observations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distribution of a mean in Monte Carlo trials: Student t with the degrees of freedom of the observations (JCGM 101 6.4.9), or normal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Student t</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibration curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit of x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit in which x is given. A difference of temperatures, a correction of a thermometer too, is given in K.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit of y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit in which y is given. A difference of temperatures, a correction of a thermometer too, is given in K.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points of the calibration, typed, pasted or from a CSV file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Independent quantity, in its unit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of x; empty: none. Used with stated uncertainties.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Observed quantity, in its unit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of y. Used, and needed, with stated uncertainties.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Degree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the polynomial: 1 is a straight line.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Origin x_0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The polynomial is one of x - x_0, in the unit of x. In the middle of the points the coefficients are hardly correlated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Through the origin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No constant term: the curve is zero at x_0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the scatter of the residuals about the curve (JCGM 100 H.3), or as stated for each point.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from the residuals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as stated for x and y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use of the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the value of the curve is wanted, with its uncertainty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the unit of x.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inverse use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Observed values of y whose x is wanted, with its uncertainty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Observed, in the unit of y.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of the observed y; empty: none beside that of the readings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The observed y is the mean of so many readings, which scatter as the points of the calibration do. With the uncertainty from the residuals only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>near</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of several x that give this y, the one nearest to here, in the unit of x. Needed where the curve reaches y more than once between its points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Observations in groups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the measured quantity.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In which the observations are given.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every observation, or mean and standard deviation of each group.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>observations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>means and standard deviations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Observations with the day, instrument or operator they belong to, typed, pasted or from a CSV file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Day, instrument or operator.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Groups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean and experimental standard deviation of the observations of each group.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the observations of the group, in the unit of the quantity.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experimental standard deviation of a single observation of the group.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of observations in the group; empty: observations per group, as below.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Observations per group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of observations in each group whose row does not say it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Effect of the groups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Included: u of the mean of the groups&apos; means from their scatter. By components of variance: the same for groups of one size, else groups with more observations have more weight. Not included: all observations count as independent, which the F-test in the evaluation must allow.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>included</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>by components of variance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not included</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Artefact with calibrated points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Artefact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrated points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The artefact&apos;s points with their calibrated coordinates in the artefact&apos;s frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrated coordinate x.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrated coordinate y.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrated coordinate z.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>defines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coordinates that define the frame (&quot;xyz&quot;, &quot;yz&quot;), when they are named by point.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Evaluate from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeated measurements of the artefact, or the components of uncertainty as a report prints them (Table 1 of the paper).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>components of uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured coordinates in the artefact&apos;s frame: one row for each point and run, typed or from a CSV file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of a calibrated point.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Indicated coordinate x.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Indicated coordinate y.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Indicated coordinate z.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Components of uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One row for each coordinate, as Table 1 of the paper prints them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coordinate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coordinate of the row.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibration.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temperature.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Variability: standard deviation of the errors of indication.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bias: mean of the errors of indication.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of observations, where it is known; gives the degrees of freedom.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coordinates that define the frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Errors of these coordinates are zero by construction of the frame and are left out of the statistics.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>first point x, y, z; second y, z; third z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as the points&apos; column &apos;defines&apos; says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Systematic error of indication</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What becomes of the mean error b. The paper leaves it uncorrected and counts |b| as a standard uncertainty; JCGM 100 3.2.4 asks for a correction.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>counts as a standard uncertainty (paper)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ignored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>corrected, the uncertainty of the correction remains</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Systematic parts are common to all points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibration, temperature and bias are drawn once for all points instead of independently for each, as the paper does.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest standard uncertainty of the calibrated values, from the certificate (U divided by its k).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coefficient of thermal expansion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linear expansion of the artefact&apos;s material; aluminium has about 23e-6 1/K.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temperature of the artefact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether indications are corrected to 20 °C with a measured temperature. If not, the largest deviation from 20 °C is a component of uncertainty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not corrected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>corrected to 20 °C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest deviation from 20 °C, or U of the temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ΔT of Eqs 3 and 6: without correction the largest absolute deviation from 20 °C, with correction the expanded uncertainty of the measured temperature. Half-width of a rectangular distribution.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temperature of the artefact during the measurement; indications are divided by 1 + α (T − 20 °C).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length for the thermal expansion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>L_max of Eq 3. The paper&apos;s figures result with the largest distance between two points; its text says the largest value of the coordinate, which gives 0 for a flat artefact&apos;s z.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest distance between two points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest value of the coordinate (text of Eq 3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length standard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrated length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance between the two nests, from the certificate. It should be like the largest distance between the points of both frames.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeated measurements of the artefact, or the components of uncertainty as a report prints them (Table 2 of the paper).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured lengths: one row for each position and run, typed or from a CSV file. The paper proposes at least 14 positions of three runs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the standard stood.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Indicated length.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One row, as Table 2 of the paper prints it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty of a coordinate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A length is the difference of two points, so u of a length is √2 times u of a coordinate. The paper uses the length&apos;s figure unchanged, which is cautious.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>that of the length (paper)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>that of the length divided by √2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tracker, total station, camera or distance meter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the instrument stands in the world frame: the point where its axes meet. x is the zero of the azimuth (the optical axis of a camera), z the vertical axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The angles are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the three angles of the station turn its axes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α, β, γ: R = Rz(γ) Ry(β) Rx(α)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ω, φ, κ: R = Rx(ω) Ry(φ) Rz(κ), photogrammetric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the instrument reads, and how it is drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>total station: distance and two angles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>laser tracker: distance and two angles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>laser scanner: distance and two angles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>camera: two angles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distance meter: distance only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>other: chosen readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads the distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the sensor reads a distance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads the azimuth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the sensor reads a horizontal angle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads the elevation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the sensor reads a vertical angle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Specification</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance: constant part a</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part of the distance&apos;s figure that does not depend on the distance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance: part b per length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part of the distance&apos;s figure in proportion to the distance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Figure for the horizontal angle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Figure for the vertical angle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angles: constant part across</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part of both angles&apos; figures that is a length across the line of sight, as trackers state it (15 µm + 6 µm/m); an angle&apos;s figure is this over the distance plus its own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The figures are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the data sheet states: a standard uncertainty, an expanded one, or a limit that is not exceeded (maximum permissible error).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>standard uncertainty (normal)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>expanded uncertainty, k = 2 (normal)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>limit (MPE), rectangular: divided by √3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>limit (MPE), triangular: divided by √6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>limit (MPE), arc sine: divided by √2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range and field of view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortest distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Targets nearer than this are not measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Targets farther than this are not measured; empty: no limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Horizontal field of view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full angle, half of it to either side of the sensor&apos;s x-axis; empty: all round.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertical field of view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full angle, half of it above the sensor&apos;s xy-plane and half below; empty: no limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shared by all readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale of distances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of the scale, which all distances share: wavelength, refractive index, temperature of a scale.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zero offset of distances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of the constant offset of all distances: home position, reflector.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Index of the elevation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of the zero of the vertical circle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Collimation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of the angle between beam and tilting axis off square: the azimuth changes by it over the cosine of the elevation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Squareness of the axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of the angle between the two axes off square: the azimuth changes by it times the tangent of the elevation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offset of the beam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of the distance by which the beam misses the vertical axis sideways: the azimuth changes by it over the horizontal distance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coefficient of refraction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of k: the elevation changes by k L/(2 × 6371 km) over a distance L.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The distribution of what all readings share; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty of the station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>position x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of this coordinate of the station, shared by everything measured from it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>position y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>position z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotation about x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotation about y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotation about z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The distribution of the coordinates of the station; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correlation of the station&apos;s coordinates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correlation coefficients from the adjustment that located the station; pairs left out are uncorrelated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A coordinate of the station.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correlation coefficient.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Network of sensors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the weights of the readings account for. With the stations, all points of one analysis are estimated together.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>readings and stations, all points at once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>readings alone, each point by itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Specification of a measured point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Figure of the data sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The uncertainty or limit that the manufacturer states, the same for x, y and z.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The figure applies to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A coordinate of a point, or a length between two points; a length is the difference of two points, so a coordinate has 1/√2 of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a coordinate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a length between two points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Telescopic ballbars (multilateration)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Supports</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Support 1 to support 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured length between supports 1 and 2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Support 1 to support 3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured length between supports 1 and 3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Support 2 to support 3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured length between supports 2 and 3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Further supports</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Supports 4, 5 ...: their lengths to the first three, and their height above the plane of these. More than three lengths are adjusted by least squares.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length to this support.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height above the first three supports.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of the height.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The ball is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Three lengths meet in two points, mirror images in the plane of the supports: on which side of it the ball is (sign of the root of Eq 3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on the side of +z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on the side of −z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Placement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place in the robot&apos;s frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the instrument&apos;s frame is in the robot&apos;s: origin in support 1, x towards support 2, z normal to the plane of the first three supports, on the left of the way 1-2-3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty of a length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the ball: constant part a</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Figure for one reading of a bar to the ball, the part that does not depend on the length.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the ball: part b per length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Figure for one reading of a bar to the ball, the part in proportion to the length.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Between supports: constant part a</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Figure for a length between two supports, which one measurement gives for all points: the part that does not depend on the length.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Between supports: part b per length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Figure for a length between two supports, the part in proportion to the length.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shared by all lengths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale of all lengths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of the scale that all lengths share: wavelength, refractive index.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Constant of each bar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of the constant of a bar, the same in all its readings to the ball.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The distribution of scale and constants; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot: repeatability of a pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Positioning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot&apos;s figure for the scatter of a position that it is sent to again and again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The figure is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A largest distance from the mean position, or RP of ISO 9283: the mean distance plus three times its standard deviation. A normal law has no largest distance, so its figure is always RP.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the largest distance r</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RP of ISO 9283: mean + 3 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviation of a position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the distance from the mean position is distributed; all directions are equally probable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rectangular in [0, r] in a random direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>anywhere in a ball of radius r</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>always r, in a random direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>normal along each axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Figure for the scatter of the orientation about each axis of the flange; 0: none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The angle is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A standard uncertainty, RP of ISO 9283 for an angle (three times its standard deviation), or a limit that is not exceeded.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RP of ISO 9283: ± 3 s (normal)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>limit, rectangular: divided by √3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serial robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Convention</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the parameters of a row lead from one joint&apos;s frame to the next.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rz(theta) Tz(d) Tx(a) Rx(alpha) Ry(beta): beta for parallel joints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rz(theta) Tz(d) Tx(a) Rx(alpha): Denavit-Hartenberg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rx(alpha) Tx(a) Rz(theta) Tz(d): Craig; row i holds alpha and a before joint i</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One row for each joint from the base to the tool, in the chosen convention.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joint angle where the reading is the zero reading.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offset along the joint&apos;s axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the common perpendicular.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Twist about x between two axes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Twist about y, of a joint whose axis is parallel to the next: d is then 0 by definition. Empty: the axes are not parallel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of the joint at which theta holds; empty: 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the joint angle grows or falls with the reading; empty: grows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with the reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>against the reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lowest reading; empty: no limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Highest reading; empty: no limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of a reading by the joint&apos;s encoder, drawn anew at each pose.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty by which the joint comes back to a reading, drawn anew at each pose.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A joint that turns has readings q, which add to theta; one that slides has readings s, which add to d. Empty: it turns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turns about its axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slides along its axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading of a sliding joint at which d holds; empty: 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lowest reading of a sliding joint; empty: no limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Highest reading of a sliding joint; empty: no limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of a reading of a sliding joint by its scale, drawn anew at each pose.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty by which a sliding joint comes back to a reading, drawn anew at each pose.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where frame 0 of the robot stands in the world.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the tool is in the frame of the last link.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainties of the parameters by source. A row for a joint and a source; components of one parameter combine in quadrature.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the figures come from: repeatability, sampling, range, certificate ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of the joint; empty: all joints, each with a deviation of its own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of theta from this source; empty: none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of d from this source; empty: none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of a from this source; empty: none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of alpha from this source; empty: none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of beta from this source; empty: none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Degrees of freedom of the figures; empty: infinitely many.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Form of the distribution with this standard uncertainty; empty: normal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correlation coefficients from the identification; pairs left out are uncorrelated. A correlated parameter has one component.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool, position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of each coordinate of the tool in the frame of the last link.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool, orientation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of each rotation of the tool about its own axes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot identified by joint trajectories</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot identified from measured poses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force/moment calibration machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty of its loads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One row for each axis that the machine loads: the relative expanded uncertainty of its certificate and the coverage factor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force or moment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relative expanded uncertainty of the load: a ratio, not %.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coverage factor; empty: 2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Multi-axis force/moment sensor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The forces and moments that the sensor measures, with their rated loads.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force or moment that the channel measures.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rated force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rated load of Fx, Fy or Fz.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rated moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rated load of Mx, My or Mz.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the sensor&apos;s axes are; loads are along and about them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of its housing, for the picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Indicator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resolution of the indicator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smallest step of the indicated value, r of Eq 6.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range of the indicator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest value that it can indicate; a reading there is refused as saturated. Empty: only readings that stand still while the load rises are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibration machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What loaded the sensor; its relative uncertainty enters by Eq 5.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raw readings, from which everything follows, or what an evaluation states.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>raw readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>summary tables</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Indicated values of all channels at each step, the unloaded value not subtracted; typed or from a CSV file, whose columns may have other names.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis on which the machine&apos;s load acts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preloading or calibration.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>preload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unloaded before, preload, increasing or decreasing load, unloaded after.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zero before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>increasing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>decreasing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zero after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of the step: 0 without load, the same number for increasing and decreasing load.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load in the unit of the next column.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>load unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N, kN, Nm ...; empty: N for forces and N·m for moments.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time of the reading.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Indicated value of this channel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Summary</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What an evaluation states of each channel, like Tables 1 and 3 of the paper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Channel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rated output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean net reading at the rated load.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>non-zero error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Non-zero error: change of the unloaded reading over a series.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type A standard uncertainty of the mean, the largest of all steps.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hysteresis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest difference between increasing and decreasing load.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type B standard uncertainty as stated; empty: from the machine, the resolution and the non-zero error (Eq 8).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outputs at rated loads on other axes, like Table 2 of the paper; which index is the load is chosen below.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Row of the table.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Column of the table; empty on the diagonal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interference has signs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the signs are printed. Without them interference cannot be compensated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibration plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preloads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How often each axis is loaded to its rated load before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibration series of each axis: n of Eqs 2 to 4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loads of a series up to the rated load; the paper asks for five or more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Decreasing loads too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether each series goes down again; hysteresis needs it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without load before a series</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before each series, Fig. 2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At each load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before a reading is taken, Fig. 2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Evaluation by the paper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coverage factor k of Eq 12</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The paper takes 2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A row of the interference table is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section 2.5 says e_12 is the output of Fy under Fx (row = load), but divides by the rated output of the row and calls the row&apos;s largest the error of that sensor. Raw readings leave no doubt; for a printed table the choice changes U.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a sensor: its outputs under the other loads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a load: the outputs of the other sensors under it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stated values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values that a certificate or a paper prints, to be compared with those computed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As printed, in mV/V; empty: not compared.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>interference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U, relative</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relative expanded uncertainty of Eq 12b.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U, as a load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expanded uncertainty of Eq 12c in N or N·m, a number without unit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stated interference in %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table 4 of the paper: interference by the rated output of the row.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest of the row.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Typed measurement equation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The uncertainty of a quantity computed from others by an equation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gauge block by comparison</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The length of a gauge block compared with a standard of the same length.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two quantities from the same readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resistance and reactance from simultaneous readings, with their correlation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibration line of a thermometer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The correction at any reading, from a line through calibration points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Observations on several days</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mean of readings in groups, and whether the groups differ.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pose of a platform from a tracker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where a robot&apos;s flange or platform is, from nests measured by a laser tracker.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pose from two instruments together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same pose measured by a tracker and a total station as one network.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pose from calibrated artefacts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A pose whose point uncertainties come from measurements of artefacts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points by cameras and a tracker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coordinates of targets that several instruments measure together.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where do I put the station?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The place of an instrument that makes the uncertainties smallest.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool by ballbars</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A robot&apos;s tool centre point from rotations measured by telescopic ballbars.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which points do I measure?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The dozen of a plan of points that makes the uncertainty smallest.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool position of a robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the tool is, from joint readings and Denavit-Hartenberg parameters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters of an arm from circles that its joints describe one by one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters of an arm from measured places of its flange.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibration of a force/moment sensor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Errors and uncertainty of the channels of a multi-axis sensor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forces and moments from readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loads from the readings of a multi-axis sensor by its calibration matrix.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Law of propagation alone (JCGM 100), with a fixed number of trials (JCGM 101), or with as many as the tolerance needs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Law of propagation only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Monte Carlo, fixed number of trials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Monte Carlo, adaptive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the method monte-carlo.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0 to 18446744073709551615, as text.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Variance reduction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes each trial tell more; the gain is measured and stated with the result. Plain trials are those of JCGM 101.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None: plain trials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control variate: the linear part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sobol points, scrambled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coverage probability</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the expanded uncertainty, of intervals and regions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coverage factor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A fixed k for U = k u; absent: U by the effective degrees of freedom (law of propagation), or half of the coverage interval (Monte Carlo).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second-order terms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Terms of second order of the law of propagation (JCGM 100 5.1.2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trials one at a time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of Monte Carlo with all components but one kept constant, for each component; 0: none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trials by contributor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of Monte Carlo without each contributor, and of it alone; 0: none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trials for Sobol indices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pairs of trials for Sobol indices; 0: none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Significant digits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of u, for the numerical tolerance of adaptive runs and of the validation (JCGM 101 7.9.2, 8).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A quantity applies to the outputs of its dimension; a number to every output in its SI unit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least number of batches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of an adaptive run, before it may stop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Most trials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At which an adaptive run stops in any case.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Certificate and laboratory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Certificate number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unique; it stands on every page.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Laboratory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That issues the certificate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Address of the laboratory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Street, town, country.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Country of the laboratory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two capital letters (ISO 3166-1): DE. For a Digital Calibration Certificate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accreditation number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Absent: not accredited for this.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place of calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where it was done if not in the laboratory: at the customer, in the field.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Customer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For whom it was done.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Address of the customer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Item</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was calibrated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Manufacturer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the item.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The manufacturer&apos;s name for it: model, size, class.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By which the item is recognised, unless it has an identification.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Identification</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The customer&apos;s mark, an inventory number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Condition of the item</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As it was received, where that matters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Received</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ISO 8601: 2026-04-17.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A date, or two of an interval: 2026-04-17/2026-04-18.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Issued</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ISO 8601: 2026-04-20.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Procedure by which it was calibrated, with its edition.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviations from the method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Additions, exclusions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Environmental conditions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Those that influence the results.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metrological traceability</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To which references, by which certificates the results are traceable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adjustment or repair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results before and after it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opinions and interpretations are marked as such (7.8.7).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Authorisation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Authorised by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The person who authorises the certificate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Function</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of that person in the laboratory.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measurement model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input quantities</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Artefacts and instruments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty budgets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sobol indices and contributors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Evaluation of the set-up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Law of propagation beside Monte Carlo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joint coverage regions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distributions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set-up in space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Studies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Designs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Provenance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>standard deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>degrees of freedom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lower limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>upper limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>curvilinear trapezoid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inexactness of the limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ratio of top to base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>truncated normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lognormal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean value of the logarithm of the number in SI</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>standard deviation of the logarithm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameter alpha</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameter beta</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>discrete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SpatialAnalyzer points (ASCII)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table of points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Digital Calibration Certificate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leica GSI-8 and GSI-16</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>GNU Gama network</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comp3D coordinates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comp3D observations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty budget in Excel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>GUM Workbench</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Suncal project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OptiTrack Motive tracking data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kinematic calibration of a UR robot (ROS)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point list with Ux Uy Uz (SpatialAnalyzer ASCII)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Digital Calibration Certificate 3.2.1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Excel workbook</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot description (URDF)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pose, point or target the quantity belongs to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Output quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Best value of the output quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coverage factor. U = k u with k of the t distribution for the effective degrees of freedom.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expanded uncertainty. U = k u with k of the t distribution for the effective degrees of freedom.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limit of the probabilistically symmetric coverage interval</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>High</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limit of the shortest coverage interval</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimate (first order)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By the law of propagation of uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u (first order)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Effective degrees of freedom (JCGM 100 G.4)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U (first order)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First order validated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>JCGM 101 clause 8: agrees with Monte Carlo within the tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u (second order)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With the second-order terms of JCGM 100 5.1.2; for information</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shift (second order)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the curvature of the equation adds to the estimate; for information, not added</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target uncertainty that is required</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U / target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expanded uncertainty as a part of its target: above 1 the target is not met</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Requirement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the target uncertainty is met and the value is accepted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Component of uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the component&apos;s u</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of the component</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type A or Type B evaluation (JCGM 100 2.3.2, 2.3.3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sensitivity coefficient, unit of the output quantity per unit of the component</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>|c|·u</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contribution to the standard uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share / %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the variance, with its part of the covariances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u one at a time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By Monte Carlo with every other component kept constant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Origin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the figure comes from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether both results have the quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expanded uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change of U in %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change of the expanded uncertainty, in per cent of that before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimate before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimate after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change of estimate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimate after less estimate before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>k before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>k after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changed, the same, new, or gone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>|c|·u before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>|c|·u after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share before / %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the variance before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share after / %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the variance after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change of variance / %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By how much this component changes the variance of the output, in per cent of the whole variance before; the rows add up to the change of the whole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>met</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not met</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gamma</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beta</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coverage factor. U = k u with the coverage factor that was fixed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expanded uncertainty. U = k u with the coverage factor that was fixed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coverage factor. U is half the width of the probabilistically symmetric coverage interval, and k = U/u.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expanded uncertainty. U is half the width of the probabilistically symmetric coverage interval, and k = U/u.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>75 nm: standard uncertainty
2 ppm: standard uncertainty, a part of the value
U = 0.3 um, k = 2 (or p = 95 %): certificate
rectangular 0.5 (or rect, ±): limits about the value; likewise triangular, arcsine
limits 19.5 to 20.5: they give the value
resolution 0.01, MPE 3 + 0.1 %, observations, counts 12, constant
nu 18 behind any of them: degrees of freedom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Target uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The expanded uncertainty U must not exceed this.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lower limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the tolerance; empty: none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upper limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guard factor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guard bands of this times U inside the tolerance: 1 proves conformity (ISO 14253-1), 0 is simple acceptance, negative values favour the producer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Prior mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is known of such quantities before the measurement, as a normal distribution (the production process): for the global risks of JCGM 106.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Prior standard deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the production process.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui</name>
    <message>
        <source>Add %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a unit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number without unit is expected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a unit like %1 is expected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The unit %1 does not fit here: </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a whole number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not one of: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is neither yes nor no.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The value must be greater than %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The value must be at least %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The value must be at most %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved Changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without saving they are lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File Changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another program changed “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading it again loses your unsaved changes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It can be read again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read Again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recover Unsaved Work</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Covaria did not end properly. Unsaved work was kept:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open Project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Covaria project or report (*.covaria *.pdf)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About Covaria</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;h3&gt;Covaria %1&lt;/h3&gt;&lt;p&gt;Measurement uncertainty of robots and large-scale metrology.&lt;br&gt;Evaluates by JCGM 100, 101 and 102.&lt;/p&gt;&lt;p&gt;Qt %2, VTK %3, Eigen %4&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>symbol</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the equations use it; further rows of a symbol add components</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>estimate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the row&apos;s unit: 50.000 838 or 50.000 838 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the estimate and of what is stated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stated as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distribution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That Monte Carlo draws</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type A or Type B evaluation (JCGM 100 2.3.2, 2.3.3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Degrees of freedom; empty: infinite, or those of the observations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty, in the row&apos;s unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sensitivity coefficient, unit of the result per unit of the row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contribution to the standard uncertainty of the result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>index / %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the variance, with its part of the covariances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the figure comes from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard uncertainty of the position in space: square root of the sum of the variances of its three coordinates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, worth %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preview by the law of propagation, without Monte Carlo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preview with %1 trials, before the adaptive procedure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preview with %1 of %2 trials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Law of propagation of uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Monte Carlo, %1 trials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Out of date: of the project as it was</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expanded uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source># Keys

| Key | Does |
|---|---|
| Ctrl+N, Ctrl+O, Ctrl+S | new, open, save |
| Ctrl+Z, Ctrl+Y | undo, redo |
| F5, Ctrl+F5, Esc | run this analysis, run all, stop |
| F2, Ctrl+D, Delete | rename, duplicate, delete the selected entry |
| Arrow keys, + and − | turn and zoom the scene |
| 1, 2, 3, 4, F | iso, top, front, right view, fit |
| Ctrl+C, Ctrl+V | copy and paste blocks of cells |
| F1 | help on the field, cell or entry with the focus |
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The analysis is not complete yet: what must still be given is listed below.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The analysis has problems; they are listed below.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::AllResultsModel</name>
    <message>
        <source>%1 interval</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interval</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coverage interval of the result line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, high</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double click: goes to the analysis</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::AllResultsTab</name>
    <message>
        <source>Filter: analysis, symbol, name, group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter of all results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not met only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only results whose target uncertainty or tolerance is not met</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all-results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Output quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>k</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>up to date</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 requirements met</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 analyses have no result: press Ctrl+F5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; </source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::AssetEvaluation</name>
    <message>
        <source>The asset has problems; they are listed below the scene.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This asset is used as it is specified; nothing is evaluated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Evaluation of the asset</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::BudgetPage</name>
    <message>
        <source>Results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correlation coefficient</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select two rows, and type the correlation coefficient of their components</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Budget</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;i&gt;r&lt;/i&gt; of two rows =</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::BudgetSheetModel</name>
    <message>
        <source>Out of date: being computed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type a name here to add a quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no unit for a quantity in %2.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::CertificateForm</name>
    <message>
        <source>Required by %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asked for by %1 where it applies.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next Missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the certificate lacks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goes to the next field that %1 requires and that is empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything that %1 requires beside the results is stated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For File › Export › Certificate. A clause of %1 stands where it requires something; a report needs none of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 required texts are stated; missing: %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, </source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::ChartView</name>
    <message>
        <source>Run the analysis to see this chart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Chart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy Data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as %1 …</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::ColumnTableModel</name>
    <message>
        <source>Out of date: the project has changed since.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::CompareTab</name>
    <message>
        <source>Keep as Before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps the present results of this analysis, to compare later ones with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go Back to Kept State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes the project what it was when the results were kept; can be undone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard Kept State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forgets the kept results; the project stays as it is now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>comparison</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Output quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change of estimate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>k before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>k after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>budget-changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Origin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distributions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes of the budget</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The results are kept: the tab Compare shows them beside those to come.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go back to kept state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select an analysis to compare its results.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the analysis (F5), then keep its results.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the present results and edit: before and after stand here beside each other.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before: %1, kept at %2. </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After: no results.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::ComponentsEdit</name>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Components of uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the component</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type of evaluation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Origin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the components that the model gives</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type A (from observations)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type B (other means)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Degrees of freedom of the standard uncertainty; empty: infinitely many.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change component of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>component %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add component to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove component of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset components of %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::CorrelationEdit</name>
    <message>
        <source>Add to the matrix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correlation coefficients between components of uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Component of uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All components are uncorrelated. Add those that are correlated to the matrix.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The coefficients are possible together (positive semi-definite). Monte Carlo draws them with a Gaussian copula: exact for normal distributions, nearly so for others.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::CorrelationTableModel</name>
    <message>
        <source>Correlation of %1 with %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::CsvImportDialog</name>
    <message>
        <source>Import %1 into %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>found by itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>comma</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>semicolon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preview</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Separator of cells</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Column of the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is read as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Columns of the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Column %1 is read as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as it is named</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown: choose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file cannot be imported: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n row(s).</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more problem(s).</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>covaria::ui::DateEditor</name>
    <message>
        <source>to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, last day</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose from a calendar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is no date of the form 2026-04-17.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The first day is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last day is before the first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the same day</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::DensityPicture</name>
    <message>
        <source>Density of the distribution</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::DesignBoxList</name>
    <message>
        <source>Add Box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name, such as pillar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove Box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::DesignReductionList</name>
    <message>
        <source>Reductions with a price, in place of variables and rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add Reduction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One more uncertainty that can be made smaller for money</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smallest factor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The smallest factor that can be had, between 0 and 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Price of the first halving</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Law of the price</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>price (1/f − 1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>price (1/f² − 1)/3: further readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>price log₂(1/f): every halving the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove Reduction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least factor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First halving</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A factor f costs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choose what is reduced</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::DesignTab</name>
    <message>
        <source>Design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Design of this analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run Design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Searches for the best design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops the search (Esc)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Variables, rows and objective of the design, in the properties of the analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take Over This Design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts the values and rows that were found into the project; can be undone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add Design …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the design to see the best that can be done with what it may choose.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A design finds where to stand and what to measure: add one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> – out of date</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 evaluations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, best so far %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>searching …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not searched yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing that was tried has a result.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cheapest reductions cost %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cheapest rows cost %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, before %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; &lt;b&gt;the target of U(%1) is not met&lt;/b&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;Out of date&lt;/b&gt;: shown for the project as it was. </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take over design</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::DesignsForm</name>
    <message>
        <source>Design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds a design of this analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds a copy of this design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deletes this design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Searches for the best design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A design finds where to stand and what to measure: the numbers and the rows of the set-up that make the uncertainties smallest. Add one to let Covaria search.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add Variable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One more number that may be chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Objective</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is made smallest of the ratios of U to the target uncertainties; without targets to U of the present design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest ratio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean of the ratios</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Root mean square of the ratios</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cost of the rows, with all targets met</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Output quantities of the design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Output quantities looked at; with none ticked, all with a target uncertainty, or all measurands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outputs (none ticked: all with a target, or all measurands)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows to choose from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table to choose from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows to keep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File of candidates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A CSV file beside the project with further rows; may be empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows that stay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ticked rows stay in any case</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Prices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Evaluations at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Between instruments, and of them from all other points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep out of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No instrument stands in this box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines of sight are hidden by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No line of sight passes this box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Prices of the rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one for all rows, or one for each: 120; 80; 95</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the rows cost, separated by semicolons; needed where the cost is to be small</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no number; separate prices by semicolons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the random starts: a whole number from 0 to 18446744073709551615</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::DistributionEdit</name>
    <message>
        <source>Distribution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probabilities</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>numbers with ; between</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” are not all numbers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There must be as many probabilities as values.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This distribution has no finite standard uncertainty.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::DockTitle</name>
    <message>
        <source>Float or dock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::Document</name>
    <message>
        <source>Untitled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (from %2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project has no file yet: choose a name for it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (copy)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Study %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Design %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change notes of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take %1 from an analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the link of %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::EquationsView</name>
    <message>
        <source>Equations</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::EvaluationTab</name>
    <message>
        <source>Evaluation of the set-up</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::EvaluationView</name>
    <message>
        <source>Tables of the evaluation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which chart of the evaluation is shown</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::ExportActions</name>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HTML page (*.html)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Markdown text (*.md)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report as &amp;PDF …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Certificate as PDF …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report as &amp;HTML …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report as &amp;Markdown …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Results and Tables …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No results yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No analysis is up to date. Run one first (F5).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The export waits until the analyses have run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, without %1: not up to date</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export Report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The certificate does not state what ISO/IEC 17025 requires of it:

%1

It says “not stated” in these places. They are fields of the project&apos;s page.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export Anyway</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export Certificate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export Results and Tables into the Folder of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results (results.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: what it must state is missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (*%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A report is being written; wait until it is finished</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing %1 …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The export failed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::FieldEditor</name>
    <message>
        <source>From %1 to %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More than %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At least %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At most %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::FieldHelp</name>
    <message>
        <source>Help on the field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbers may be typed with another unit (0.5 um); the arrow keys change the last digit.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::FileActions</name>
    <message>
        <source>line %1: </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;New Project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;As …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No projects yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New from &amp;Example</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Untitled project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening %1 …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project has errors and was not opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The example could not be opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project was not saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Covaria project (*.covaria)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Saved %1 without %n text(s) that cannot be read: see the problems</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The work could not be recovered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was removed by another program; saving writes it again</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::HelpActions</name>
    <message>
        <source>Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Help on What Has the &amp;Focus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>M&amp;odels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A&amp;rtefacts, Instruments and Robots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Results and Requirements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What Every &amp;Analysis Has</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Glossary</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About Covaria</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::HelpPane</name>
    <message>
        <source>Help</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::ImportActions</name>
    <message>
        <source>&amp;Import File …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add points, budgets, certificates, readings or poses of other programs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Import Robot (URDF) …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a serial robot from a robot description in URDF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files that are read (%1);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Imported %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import Robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot description (*.urdf);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot was not imported</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::ImportDialog</name>
    <message>
        <source>Line %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the file says contradicts itself: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Columns of the file and what each is read as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Units that the &amp;file does not state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Note the file with its size, time and SHA-256 in what is added</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as the file says, else mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What becomes of the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Read as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Unit of lengths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What becomes of it, and what is not taken over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no reader recognises it: choose one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>several readers recognise it: choose one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (recognised)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Column %1 is read as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown: choose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as it is named</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose what the file is read as.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 assets and %2 analyses are added, in one step that can be undone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Imported from %1, %2 bytes, of %3, SHA-256 %4.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::InputCorrelationModel</name>
    <message>
        <source>Remove correlations of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A correlation coefficient lies between −1 and 1; “%1” does not.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change correlation of %1 and %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::InputQuantitiesModel</name>
    <message>
        <source>from %1, linearised: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2, %3 %4)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Evaluated in the other analysis, in every trial: edit it there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changed: differs from what the model says.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Components of uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Constant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change estimate of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep %1 constant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let %1 vary</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset %1 to the model&apos;s values</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::InputsPage</name>
    <message>
        <source>Find a quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Components</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correlations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The quantities that the set-up makes. What is changed here replaces what the set-up states.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input quantities</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take From an Analysis…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove Link</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::InquiryHead</name>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::LibraryBrowser</name>
    <message>
        <source>Collections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Templates, examples and assets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Library and Examples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search: name, kind, source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search in the library</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Examples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>GUM and its supplements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It comes with what it needs and has results at once. Assets of the same kind that the project has already stand in the place of its own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opens as a new project.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add to the Project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;Nothing here has these words.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open as a New Project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add This Analysis</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::LibraryMenu</name>
    <message>
        <source>From the &amp;Library</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not readable: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::LinesEditor</name>
    <message>
        <source>Add rows for new names</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds a row to the tables below for every name that has none yet</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::LinkDialog</name>
    <message>
        <source>&amp;Linearised: faster, exact to first order only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take %1 From an Analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No other analysis has a result of this dimension.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Both analyses are then evaluated together, as one model: the result is not carried over as a number with an uncertainty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Result</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::ListEditor</name>
    <message>
        <source>(none)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (does not exist)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1

Chosen: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::LogPane</name>
    <message>
        <source>Log</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::MainWindow</name>
    <message>
        <source>Covaria</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Properties</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Problems</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add an analysis or what it uses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Library and Examples …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pre&amp;ferences …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset Layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start Page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3D Scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>out of date</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Problems (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Covaria[*]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1[*] – Covaria</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::NotesPage</name>
    <message>
        <source>Title</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Appear in the report</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::OptionsForm</name>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forecast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change evaluation options</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::OutputTicks</name>
    <message>
        <source> of %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results in the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the project does not state them. Reports and files are the project&apos;s alone, with the decimal point everywhere.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New analyses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written into analyses that are added; others stay as they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of tables and charts of results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the model gives them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Digits of U</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Significant digits of uncertainties; estimates are rounded to match</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of all tables, charts and fields of the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the language writes them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1234.5 (point)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1234,5 (comma)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coverage factor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of U = k u, where a new analysis begins with a fixed one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>k from the degrees of freedom or the coverage interval</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>k = 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of Monte Carlo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the window, when Covaria starts again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the system</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the window, its charts and the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Font size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the whole window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as the system</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> pt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recovery copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How long an edit may stay without a copy that a crash leaves behind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at most </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s after an edit</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProblemsModel</name>
    <message>
        <source>, row %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Project: certificate, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Project: report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>evaluation, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To give</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, line %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Problem</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProblemsPane</name>
    <message>
        <source>Problems</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProjectPage</name>
    <message>
        <source>Number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the project or order; in the report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Author</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who evaluated; in the report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results of all analyses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not stated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of results in the window, reports, tables and CSV files; where it is not stated, files have the unit of the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change units of results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Digits of U</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Significant digits of uncertainties in the window and the report; certificates have two</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change digits of results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coverage factor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A fixed k for U = k u of all analyses whose options state none; empty: from the degrees of freedom, or the coverage interval</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change coverage factor</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProjectPane</name>
    <message>
        <source>Project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D&amp;uplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Delete …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analysis: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Library and Templates …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The analysis was not added: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is in the project now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete “%1”?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>

It is used by: %1. They will have an error until they use something else.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is in your library now (Add &gt; From the Library)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep in My Library</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProjectTreeModel</name>
    <message>
        <source>Artefacts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Instruments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points and frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analyses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has problems</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Untitled project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Title, notes, certificate and contents of the report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>incomplete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>up to date</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>out of date</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 requirements not met</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::PropertiesPane</name>
    <message>
        <source>The project is empty. Add an analysis, or first what it uses, with the plus sign above or a right click in the project tree.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select an entry of the project tree to see its properties.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Properties</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Options</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Studies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Designs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Requirements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::QuantityEdit</name>
    <message>
        <source>A value is needed here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A whole number is needed here.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::ReferenceEditor</name>
    <message>
        <source>(nothing in the project fits: add it first)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(none)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(choose)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::ReportForm</name>
    <message>
        <source>Analyses, of report and certificate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chapters of the report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Long tables</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The report shows what counts most of long tables; the CSV files have them whole. Ticked, they stand whole at the end of the report too.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole, in an annex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the annex of the report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goes into the report where it is ticked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put %1 into the report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave %1 out of the report</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::ReportPreview</name>
    <message>
        <source>Pages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is shown: the report, or the calibration certificate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Update</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The certificate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Out of date: the project or its results have changed since.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has not been made yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The analyses are running: %1 waits for them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No analysis is up to date: run one first (F5).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is being made …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be made: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 page, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 pages, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; one required text is not stated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; %2 required texts are not stated</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::RequirementsForm</name>
    <message>
        <source>U = %1: the target is %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>met</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not met</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;li&gt;u of %1 reduced from %2 to %3&lt;/li&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;br&gt;It would be met with one of these alone:&lt;ul&gt;%1&lt;/ul&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;br&gt;No component suffices alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> It would be met with all standard uncertainties multiplied by %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(trials)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(Student t)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(normal)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not judged: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By %5, guard band %1: the result is &lt;b&gt;%2&lt;/b&gt;. Probability of conformance %3 %4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>accepted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rejected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;br&gt;TUR %1, C&lt;sub&gt;m&lt;/sub&gt; %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;br&gt;Global risks of the rule: consumer&apos;s %1, producer&apos;s %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the requirement for %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By the law of propagation; Monte Carlo is to follow.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By the trials of a preview; the whole run is to follow.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the analysis to see whether the requirement is met.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::ResultsPane</name>
    <message>
        <source>Results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Budget</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distributions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Convergence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Output quantity of the budget and the charts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Output quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>digits of U: </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Significant digits of uncertainties</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Significant digits of uncertainties; estimates are rounded to match</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter: symbol, name, group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter of the results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All groups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results of all poses, points or targets, whichever is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not met only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only results whose target uncertainty or tolerance is not met</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimate (first order)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U (first order)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortest Coverage Intervals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>budget</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>correlation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select an analysis to see its results.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not complete yet: nothing is wrong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not evaluated yet: press F5.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The analysis has problems.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; press F5 for the result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; %1 trials without a value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;Does not represent the measurand&lt;/b&gt; (more than 1 % of the trials are lost). </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; not stabilised</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;Out of date&lt;/b&gt;: shown for the project as it was. </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goes to the field that must be given next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All Results</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::RunActions</name>
    <message>
        <source>&amp;Run This Analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run &amp;All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each edit computes first-order results at once, then Monte Carlo</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::RunStatus</name>
    <message>
        <source>%1 trials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 million/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 s left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop all runs (Esc)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop all runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, best so far %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No analysis yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No analysis selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has problems</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 trials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, with warnings</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::ScenePanel</name>
    <message>
        <source>Select an analysis in the project tree to see its layout here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which pose or group of outputs to show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Iso</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View from the front right, from above (1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View from above (2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View from the front (3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View from the right (4)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything in the picture (F)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magnification of the uncertainty; it is always written in the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magnification of the uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magnification: auto</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>× %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coverage probability of the ellipsoids</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>p = %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Links and Sight Lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vectors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ellipsoids</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clouds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Histograms on the Walls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Labels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Legend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map of a Study or Design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the picture shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;  at %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>,  u = %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>,  U = %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::SceneView</name>
    <message>
        <source>3D scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrow keys turn the scene, plus and minus zoom, F fits, 1 to 4 are standard views; a selected point or instrument can be dragged to another place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture could not be written to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Picture …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scene.png</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::SetupForm</name>
    <message>
        <source>Change %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>covaria::ui::SetupTableModel</name>
    <message>
        <source>Change %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Insert rows in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete rows of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste into %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill down in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear cells of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change unit in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take %1 into the project</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::SortableTable</name>
    <message>
        <source>Click to sort, right click to choose columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV table (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Original Order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as CSV …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit Widths</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::SpreadsheetView</name>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Insert row above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add row at the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete rows</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::StartPage</name>
    <message>
        <source>Start page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Covaria</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measurement uncertainty of robots
and large-scale metrology</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New Project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Library and Examples …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Examples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They open as new projects; the shipped files stay as they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Worked examples of the GUM and its supplements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Projects that you open are listed here.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::StudiesForm</name>
    <message>
        <source>Study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds a study of this analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds a copy of this study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deletes this study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Evaluates the analysis at every grid point of this study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A study evaluates this analysis for many values of a number: a sweep over one, a map over two or three. Add one to see how the uncertainty depends on the set-up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Law of propagation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Monte Carlo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trials at each grid point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trials per point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add Axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Varies one more number: every combination is evaluated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Output quantities of the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Output quantities looked at; with none ticked, all measurands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outputs (none ticked: all measurands)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::StudyAxisEdit</name>
    <message>
        <source>Axis %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Variable %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove Axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove Variable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>takes these values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is multiplied with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has added to it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>evenly spaced</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>logarithmically spaced</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It can be put into effect only so well: what counts is the worst within it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Varied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choose what is varied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (factor)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: has a problem</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::StudyTab</name>
    <message>
        <source>study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Study of this analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run Study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axes, outputs and method of the study, in the properties of the analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quantity of the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the chart and the scene show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind of chart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A map, or lines over the first axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis of the slices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which axis the slices are across</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slice only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the scene: the points of this slice; else all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ellipsoids</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the scene: coverage ellipsoids at the grid points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add Study …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Out of date: of the project as it was</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slice: </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the study to see how the uncertainty depends on what it varies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A study evaluates the analysis for many values of a number: add one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> – out of date</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>running …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not evaluated yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 grid points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 without values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;Out of date&lt;/b&gt;: shown for the project as it was. </source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::StudyTableModel</name>
    <message>
        <source>Remark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why there are no values, or what is wrong with them</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::TableEditor</name>
    <message>
        <source>Take into the project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import CSV…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read from %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The rows are read from %1. Taken into the project they can be edited here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import CSV into %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tables (*.csv *.tsv *.txt);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::TargetBox</name>
    <message>
        <source>What is varied: type a part of its name to search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is varied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” names nothing that can be varied.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>“%1” names %n things that can be varied.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source> (factor)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::UnitButton</name>
    <message>
        <source>Units</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Units of the tables and charts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the Model Gives Them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change unit of results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear units of results</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::UnitChoices</name>
    <message>
        <source>Lengths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moments</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>covaria::ui::UnreadTexts</name>
    <message>
        <source>What is typed in a field cannot be read. %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
