<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ko" sourcelanguage="en">
<context>
    <name>QObject</name>
    <message>
        <source>Move %1</source>
        <translation>%1 이동</translation>
    </message>
    <message>
        <source>&lt;p&gt;%1 more rows; the exported table has all of them.&lt;/p&gt;</source>
        <translation>&lt;p&gt;%1개 행이 더 있습니다. 내보낸 표에는 모두 들어 있습니다.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>%1 회전</translation>
    </message>
    <message>
        <source>&lt;b&gt;Trial %1&lt;/b&gt;, inputs farthest from their estimates: %2</source>
        <translation>&lt;b&gt;시행 %1&lt;/b&gt;, 추정값에서 가장 먼 입력량: %2</translation>
    </message>
    <message>
        <source>Only %1 is shown (Shift+H: all)</source>
        <translation>%1만 표시됨(Shift+H: 모두)</translation>
    </message>
    <message numerus="yes">
        <source>%n hidden (Shift+H: show all)</source>
        <translation>
            <numerusform>%n개 숨김(Shift+H: 모두 표시)</numerusform>
        </translation>
    </message>
    <message>
        <source>The interval is not symmetric about the estimate: state the interval, not y ± U (JCGM 101 5.5).</source>
        <translation>구간이 추정값에 대해 대칭이 아닙니다. y ± U 대신 구간을 적으십시오(JCGM 101 5.5).</translation>
    </message>
    <message>
        <source>Turns about its %1 axis</source>
        <translation>자신의 %1축 둘레로 돕니다</translation>
    </message>
    <message>
        <source>Moves along %1</source>
        <translation>%1 방향으로 이동합니다</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>Pose from points</source>
        <extracomment>Measurement model</extracomment>
        <translation>점으로부터의 포즈</translation>
    </message>
    <message>
        <source>Base frame</source>
        <translation>기준 좌표계</translation>
    </message>
    <message>
        <source>Base points</source>
        <translation>기준 점</translation>
    </message>
    <message>
        <source>Nominal coordinates of the points in their own frame, and standard uncertainties of single coordinates where they differ from the common ones.</source>
        <translation>점의 고유 좌표계에서의 공칭 좌표, 그리고 공통값과 다른 개별 좌표의 표준불확도.</translation>
    </message>
    <message>
        <source>name</source>
        <translation>이름</translation>
    </message>
    <message>
        <source>Name of the point.</source>
        <translation>점의 이름.</translation>
    </message>
    <message>
        <source>Nominal coordinate x in the point&apos;s own frame.</source>
        <translation>점의 고유 좌표계에서의 공칭 좌표 x.</translation>
    </message>
    <message>
        <source>Nominal coordinate y in the point&apos;s own frame.</source>
        <translation>점의 고유 좌표계에서의 공칭 좌표 y.</translation>
    </message>
    <message>
        <source>Nominal coordinate z in the point&apos;s own frame.</source>
        <translation>점의 고유 좌표계에서의 공칭 좌표 z.</translation>
    </message>
    <message>
        <source>Standard uncertainty of this x; empty: as typed for all.</source>
        <translation>이 x의 표준불확도. 비어 있으면 전체에 입력한 값.</translation>
    </message>
    <message>
        <source>Standard uncertainty of this y; empty: as typed for all.</source>
        <translation>이 y의 표준불확도. 비어 있으면 전체에 입력한 값.</translation>
    </message>
    <message>
        <source>Standard uncertainty of this z; empty: as typed for all.</source>
        <translation>이 z의 표준불확도. 비어 있으면 전체에 입력한 값.</translation>
    </message>
    <message>
        <source>Frame from its points</source>
        <translation>점으로부터의 좌표계</translation>
    </message>
    <message>
        <source>3-2-1: the origin from point 1, the x-axis from points 1 and 2, the xy-plane from points 1, 2 and 3. Least squares: the frame in which the nominal coordinates fit all points best.</source>
        <translation>3-2-1: 원점은 점 1에서, x축은 점 1과 2에서, xy 평면은 점 1, 2, 3에서 정합니다. 최소제곱: 공칭 좌표가 모든 점에 가장 잘 맞는 좌표계입니다.</translation>
    </message>
    <message>
        <source>3-2-1</source>
        <translation>3-2-1</translation>
    </message>
    <message>
        <source>least squares</source>
        <translation>최소제곱</translation>
    </message>
    <message>
        <source>Side of point 3</source>
        <translation>점 3의 쪽</translation>
    </message>
    <message>
        <source>On which side of the x-axis point 3 lies in the base frame b; this directs z.</source>
        <translation>기준 좌표계 b에서 점 3이 x축의 어느 쪽에 있는지. 이것이 z의 방향을 정합니다.</translation>
    </message>
    <message>
        <source>negative y: z = (q3 − q1) × x</source>
        <translation>음의 y: z = (q3 − q1) × x</translation>
    </message>
    <message>
        <source>positive y: z = x × (q3 − q1)</source>
        <translation>양의 y: z = x × (q3 − q1)</translation>
    </message>
    <message>
        <source>Origin from point 1, x</source>
        <translation>점 1로부터의 원점, x</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along x of the base frame b (s of Eqs 17 and 18).</source>
        <translation>기준 좌표계 b의 x를 따라 점 1에서 본 원점의 위치(식 17과 18의 s).</translation>
    </message>
    <message>
        <source>Origin from point 1, y</source>
        <translation>점 1로부터의 원점, y</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along y of the base frame b (s of Eqs 17 and 18).</source>
        <translation>기준 좌표계 b의 y를 따라 점 1에서 본 원점의 위치(식 17과 18의 s).</translation>
    </message>
    <message>
        <source>Origin from point 1, z</source>
        <translation>점 1로부터의 원점, z</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along z of the base frame b (s of Eqs 17 and 18).</source>
        <translation>기준 좌표계 b의 z를 따라 점 1에서 본 원점의 위치(식 17과 18의 s).</translation>
    </message>
    <message>
        <source>Pose of the base in frame 0</source>
        <translation>좌표계 0에서의 기준 포즈</translation>
    </message>
    <message>
        <source>Where the base stands in the frame of the measurement (frame 0, the world of the picture). It matters only for an instrument that stands somewhere.</source>
        <translation>측정 좌표계(좌표계 0, 그림의 월드)에서 기준이 놓인 곳. 어딘가에 설치된 측정기에만 의미가 있습니다.</translation>
    </message>
    <message>
        <source>Moving frame</source>
        <translation>이동 좌표계</translation>
    </message>
    <message>
        <source>Points of the moving frame</source>
        <translation>이동 좌표계의 점</translation>
    </message>
    <message>
        <source>On which side of the x-axis point 3 lies in the moving frame p; this directs z.</source>
        <translation>이동 좌표계 p에서 점 3이 x축의 어느 쪽에 있는지. 이것이 z의 방향을 정합니다.</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along x of the moving frame p (s of Eqs 17 and 18).</source>
        <translation>이동 좌표계 p의 x를 따라 점 1에서 본 원점의 위치(식 17과 18의 s).</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along y of the moving frame p (s of Eqs 17 and 18).</source>
        <translation>이동 좌표계 p의 y를 따라 점 1에서 본 원점의 위치(식 17과 18의 s).</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along z of the moving frame p (s of Eqs 17 and 18).</source>
        <translation>이동 좌표계 p의 z를 따라 점 1에서 본 원점의 위치(식 17과 18의 s).</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>포즈</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>평가</translation>
    </message>
    <message>
        <source>A priori: at the nominal coordinates. A posteriori: at the means of measured coordinates.</source>
        <translation>사전: 공칭 좌표에서. 사후: 측정 좌표의 평균에서.</translation>
    </message>
    <message>
        <source>a priori (nominal poses)</source>
        <translation>사전(공칭 포즈)</translation>
    </message>
    <message>
        <source>a posteriori (measured points)</source>
        <translation>사후(측정점)</translation>
    </message>
    <message>
        <source>Nominal poses of the moving frame in the base frame; angles are R = Rz(γ) Ry(β) Rx(α). All poses share the measurement of the base.</source>
        <translation>기준 좌표계에서 이동 좌표계의 공칭 포즈. 각은 R = Rz(γ) Ry(β) Rx(α)입니다. 모든 포즈가 기준의 측정을 공유합니다.</translation>
    </message>
    <message>
        <source>Name of the pose; groups its results.</source>
        <translation>포즈의 이름. 결과를 묶습니다.</translation>
    </message>
    <message>
        <source>Position x in the base frame.</source>
        <translation>기준 좌표계에서의 위치 x.</translation>
    </message>
    <message>
        <source>Position y in the base frame.</source>
        <translation>기준 좌표계에서의 위치 y.</translation>
    </message>
    <message>
        <source>Position z in the base frame.</source>
        <translation>기준 좌표계에서의 위치 z.</translation>
    </message>
    <message>
        <source>Rotation about x.</source>
        <translation>x축 둘레 회전.</translation>
    </message>
    <message>
        <source>Rotation about y.</source>
        <translation>y축 둘레 회전.</translation>
    </message>
    <message>
        <source>Rotation about z.</source>
        <translation>z축 둘레 회전.</translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation>측정점</translation>
    </message>
    <message>
        <source>Coordinates in one frame 0 for the base and every pose, typed or from a CSV file; the mean of the repeats is the estimate.</source>
        <translation>기준과 모든 포즈에 대한 하나의 좌표계 0에서의 좌표. 직접 입력하거나 CSV 파일에서 읽습니다. 반복의 평균이 추정값입니다.</translation>
    </message>
    <message>
        <source>set</source>
        <translation>세트</translation>
    </message>
    <message>
        <source>&quot;base&quot;, or the name of a pose.</source>
        <translation>&quot;base&quot; 또는 포즈의 이름.</translation>
    </message>
    <message>
        <source>point</source>
        <translation>점</translation>
    </message>
    <message>
        <source>repeat</source>
        <translation>반복</translation>
    </message>
    <message>
        <source>Number of the repetition.</source>
        <translation>반복의 번호.</translation>
    </message>
    <message>
        <source>Measured coordinate x in frame 0.</source>
        <translation>좌표계 0에서의 측정 좌표 x.</translation>
    </message>
    <message>
        <source>Measured coordinate y in frame 0.</source>
        <translation>좌표계 0에서의 측정 좌표 y.</translation>
    </message>
    <message>
        <source>Measured coordinate z in frame 0.</source>
        <translation>좌표계 0에서의 측정 좌표 z.</translation>
    </message>
    <message>
        <source>Orientation stated as</source>
        <translation>자세의 표현</translation>
    </message>
    <message>
        <source>Numbers in which the result states the orientation of the moving frame. Angles are undefined in gimbal lock; rotation vector and quaternion are not.</source>
        <translation>결과에서 이동 좌표계의 자세를 나타내는 수. 각은 짐벌 락에서 정의되지 않지만, 회전 벡터와 쿼터니언은 정의됩니다.</translation>
    </message>
    <message>
        <source>Z-Y-X angles (roll α, pitch β, yaw γ)</source>
        <translation>Z-Y-X 각(롤 α, 피치 β, 요 γ)</translation>
    </message>
    <message>
        <source>Z-Y-Z angles</source>
        <translation>Z-Y-Z 각</translation>
    </message>
    <message>
        <source>rotation vector</source>
        <translation>회전 벡터</translation>
    </message>
    <message>
        <source>unit quaternion</source>
        <translation>단위 쿼터니언</translation>
    </message>
    <message>
        <source>Uncertainty: Base frame</source>
        <translation>불확도: 기준 좌표계</translation>
    </message>
    <message>
        <source>Uncertainty of the points</source>
        <translation>점의 불확도</translation>
    </message>
    <message>
        <source>Standard uncertainties typed here, or those that an artefact or an instrument of the project gives.</source>
        <translation>여기에 입력한 표준불확도, 또는 프로젝트의 기준물이나 측정기가 주는 표준불확도.</translation>
    </message>
    <message>
        <source>typed</source>
        <translation>직접 입력</translation>
    </message>
    <message>
        <source>artefact or instrument</source>
        <translation>기준물 또는 측정기</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along x of the base frame b.</source>
        <translation>기준 좌표계 b의 x 방향 점 좌표의 표준불확도.</translation>
    </message>
    <message>
        <source>u_x is common</source>
        <translation>u_x 공통</translation>
    </message>
    <message>
        <source>One and the same deviation along x for all base points, instead of independent ones.</source>
        <translation>독립된 편차 대신, 모든 기준 점에 x 방향으로 동일한 하나의 편차.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along y of the base frame b.</source>
        <translation>기준 좌표계 b의 y 방향 점 좌표의 표준불확도.</translation>
    </message>
    <message>
        <source>u_y is common</source>
        <translation>u_y 공통</translation>
    </message>
    <message>
        <source>One and the same deviation along y for all base points, instead of independent ones.</source>
        <translation>독립된 편차 대신, 모든 기준 점에 y 방향으로 동일한 하나의 편차.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along z of the base frame b.</source>
        <translation>기준 좌표계 b의 z 방향 점 좌표의 표준불확도.</translation>
    </message>
    <message>
        <source>u_z is common</source>
        <translation>u_z 공통</translation>
    </message>
    <message>
        <source>One and the same deviation along z for all base points, instead of independent ones.</source>
        <translation>독립된 편차 대신, 모든 기준 점에 z 방향으로 동일한 하나의 편차.</translation>
    </message>
    <message>
        <source>Their distribution</source>
        <translation>분포 형태</translation>
    </message>
    <message>
        <source>The distribution of typed deviations of the points; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation>입력한 점 편차의 분포. 형태와 관계없이 제시된 값은 표준불확도입니다.</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>정규</translation>
    </message>
    <message>
        <source>rectangular: limits ± √3 u</source>
        <translation>직사각형: 한계 ± √3 u</translation>
    </message>
    <message>
        <source>triangular: limits ± √6 u</source>
        <translation>삼각형: 한계 ± √6 u</translation>
    </message>
    <message>
        <source>arc sine: limits ± √2 u</source>
        <translation>아크사인: 한계 ± √2 u</translation>
    </message>
    <message>
        <source>Artefact or instrument</source>
        <translation>기준물 또는 측정기</translation>
    </message>
    <message>
        <source>Gives the uncertainty of the coordinates of the points of the base frame b.</source>
        <translation>기준 좌표계 b의 점 좌표의 불확도를 줍니다.</translation>
    </message>
    <message>
        <source>Uncertainty: Moving frame</source>
        <translation>불확도: 이동 좌표계</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along x of the moving frame p.</source>
        <translation>이동 좌표계 p의 x 방향 점 좌표의 표준불확도.</translation>
    </message>
    <message>
        <source>One and the same deviation along x for all points of the moving frame, in all poses, instead of independent ones.</source>
        <translation>독립된 편차 대신, 모든 포즈에서 이동 좌표계의 모든 점에 x 방향으로 동일한 하나의 편차.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along y of the moving frame p.</source>
        <translation>이동 좌표계 p의 y 방향 점 좌표의 표준불확도.</translation>
    </message>
    <message>
        <source>One and the same deviation along y for all points of the moving frame, in all poses, instead of independent ones.</source>
        <translation>독립된 편차 대신, 모든 포즈에서 이동 좌표계의 모든 점에 y 방향으로 동일한 하나의 편차.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along z of the moving frame p.</source>
        <translation>이동 좌표계 p의 z 방향 점 좌표의 표준불확도.</translation>
    </message>
    <message>
        <source>One and the same deviation along z for all points of the moving frame, in all poses, instead of independent ones.</source>
        <translation>독립된 편차 대신, 모든 포즈에서 이동 좌표계의 모든 점에 z 방향으로 동일한 하나의 편차.</translation>
    </message>
    <message>
        <source>Gives the uncertainty of the coordinates of the points of the moving frame p.</source>
        <translation>이동 좌표계 p의 점 좌표의 불확도를 줍니다.</translation>
    </message>
    <message>
        <source>Uncertainties along</source>
        <translation>불확도의 방향</translation>
    </message>
    <message>
        <source>Along which axes the typed uncertainties of the moving points lie: those of the moving frame, which turn with it, or those of the base frame, the same in all poses.</source>
        <translation>이동 점에 입력한 불확도가 놓인 축: 함께 회전하는 이동 좌표계의 축, 또는 모든 포즈에서 같은 기준 좌표계의 축.</translation>
    </message>
    <message>
        <source>the axes of the moving frame</source>
        <translation>이동 좌표계의 축</translation>
    </message>
    <message>
        <source>the axes of the base frame</source>
        <translation>기준 좌표계의 축</translation>
    </message>
    <message>
        <source>Points from sensors</source>
        <translation>센서로부터의 점</translation>
    </message>
    <message>
        <source>Network</source>
        <translation>센서망</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>센서</translation>
    </message>
    <message>
        <source>The instruments of the network, each an instrument of the project that stands somewhere.</source>
        <translation>센서망의 측정기. 각각 어딘가에 설치된 프로젝트의 측정기입니다.</translation>
    </message>
    <message>
        <source>sensor</source>
        <translation>센서</translation>
    </message>
    <message>
        <source>An instrument of the project.</source>
        <translation>프로젝트의 측정기.</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>표적</translation>
    </message>
    <message>
        <source>Points to be localised, at their nominal coordinates.</source>
        <translation>위치를 구할 점, 공칭 좌표로.</translation>
    </message>
    <message>
        <source>Name of the target, unique.</source>
        <translation>표적의 이름, 고유해야 합니다.</translation>
    </message>
    <message>
        <source>Nominal coordinate x.</source>
        <translation>공칭 좌표 x.</translation>
    </message>
    <message>
        <source>Nominal coordinate y.</source>
        <translation>공칭 좌표 y.</translation>
    </message>
    <message>
        <source>Nominal coordinate z.</source>
        <translation>공칭 좌표 z.</translation>
    </message>
    <message>
        <source>new set-up</source>
        <translation>새 설치</translation>
    </message>
    <message>
        <source>The sensors were located anew before this target: it and those below share the deviations of the stations with each other, not with the targets above.</source>
        <translation>이 표적 앞에서 센서의 위치를 새로 구했습니다. 이 표적과 그 아래 표적은 스테이션의 편차를 서로 공유하고, 위의 표적과는 공유하지 않습니다.</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>거리</translation>
    </message>
    <message>
        <source>Distances between targets that are measurands too, for instance of a scale bar.</source>
        <translation>함께 측정량이 되는 표적 사이의 거리, 예를 들어 스케일 바의 거리.</translation>
    </message>
    <message>
        <source>from</source>
        <translation>부터</translation>
    </message>
    <message>
        <source>Name of a target.</source>
        <translation>표적의 이름.</translation>
    </message>
    <message>
        <source>to</source>
        <translation>까지</translation>
    </message>
    <message>
        <source>Name of another target.</source>
        <translation>다른 표적의 이름.</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>각도</translation>
    </message>
    <message>
        <source>Angles at a target between the directions to two others, measurands too.</source>
        <translation>한 표적에서 다른 두 표적을 향한 방향 사이의 각. 역시 측정량입니다.</translation>
    </message>
    <message>
        <source>at</source>
        <translation>위치</translation>
    </message>
    <message>
        <source>Name of the target where the angle is.</source>
        <translation>각이 있는 표적의 이름.</translation>
    </message>
    <message>
        <source>Name of a third target.</source>
        <translation>세 번째 표적의 이름.</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>좌표계</translation>
    </message>
    <message>
        <source>Frames on three targets (3-2-1), whose position and Z-Y-X angles in the world are measurands too.</source>
        <translation>세 표적 위의 좌표계(3-2-1). 월드에서의 위치와 Z-Y-X 각도 측정량입니다.</translation>
    </message>
    <message>
        <source>Name of the frame, unique.</source>
        <translation>좌표계의 이름, 고유해야 합니다.</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>원점</translation>
    </message>
    <message>
        <source>Target at its origin.</source>
        <translation>원점에 있는 표적.</translation>
    </message>
    <message>
        <source>on x</source>
        <translation>x축 위</translation>
    </message>
    <message>
        <source>Target on its positive x-axis.</source>
        <translation>양의 x축 위의 표적.</translation>
    </message>
    <message>
        <source>in xy</source>
        <translation>xy 안</translation>
    </message>
    <message>
        <source>Target in its xy-plane, at positive y.</source>
        <translation>xy 평면에서 y가 양인 곳의 표적.</translation>
    </message>
    <message>
        <source>Calibrated lengths</source>
        <translation>교정된 길이</translation>
    </message>
    <message>
        <source>Scale bars and other calibrated distances between two targets: compared with the network, or a constraint of the estimation.</source>
        <translation>스케일 바와 두 표적 사이의 그 밖의 교정된 거리: 센서망과 비교하거나, 추정의 구속조건으로 씁니다.</translation>
    </message>
    <message>
        <source>length</source>
        <translation>길이</translation>
    </message>
    <message>
        <source>Calibrated length; empty in a design: the distance of the nominal targets.</source>
        <translation>교정된 길이. 설계에서 비어 있으면 공칭 표적의 거리.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the length as it is during the measurement, with temperature.</source>
        <translation>온도를 포함하여, 측정 중 길이의 표준불확도.</translation>
    </message>
    <message>
        <source>role</source>
        <translation>역할</translation>
    </message>
    <message>
        <source>Check: the difference between network and calibration is a measurand. Constraint: the length is adjusted with the readings.</source>
        <translation>확인: 센서망과 교정의 차이가 측정량입니다. 구속조건: 길이를 읽음값과 함께 조정합니다.</translation>
    </message>
    <message>
        <source>check</source>
        <translation>확인</translation>
    </message>
    <message>
        <source>constraint</source>
        <translation>구속조건</translation>
    </message>
    <message>
        <source>distribution</source>
        <translation>분포</translation>
    </message>
    <message>
        <source>The distribution that has the standard uncertainty u; empty: normal.</source>
        <translation>표준불확도 u를 갖는 분포. 비어 있으면 정규.</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>읽음값</translation>
    </message>
    <message>
        <source>A priori: the readings are those of the nominal targets. A posteriori: the readings are given.</source>
        <translation>사전: 읽음값은 공칭 표적의 읽음값입니다. 사후: 읽음값이 주어집니다.</translation>
    </message>
    <message>
        <source>a priori (design: nominal targets)</source>
        <translation>사전(설계: 공칭 표적)</translation>
    </message>
    <message>
        <source>a posteriori (given readings)</source>
        <translation>사후(주어진 읽음값)</translation>
    </message>
    <message>
        <source>What the sensors read, one row for a sensor and a target, typed or from a CSV file; leave empty what was not read.</source>
        <translation>센서가 읽은 값. 센서와 표적마다 한 행이며, 직접 입력하거나 CSV 파일에서 읽습니다. 읽지 않은 것은 비워 둡니다.</translation>
    </message>
    <message>
        <source>target</source>
        <translation>표적</translation>
    </message>
    <message>
        <source>Name of the target.</source>
        <translation>표적의 이름.</translation>
    </message>
    <message>
        <source>The instrument that read it.</source>
        <translation>그것을 읽은 측정기.</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>거리</translation>
    </message>
    <message>
        <source>Slope distance.</source>
        <translation>경사거리.</translation>
    </message>
    <message>
        <source>azimuth</source>
        <translation>방위각</translation>
    </message>
    <message>
        <source>Horizontal angle from the sensor&apos;s x-axis, positive towards y; whole turns do not matter.</source>
        <translation>센서의 x축에서 잰 수평각, y 쪽이 양. 온바퀴 수는 상관없습니다.</translation>
    </message>
    <message>
        <source>elevation</source>
        <translation>고도각</translation>
    </message>
    <message>
        <source>Vertical angle above the sensor&apos;s xy-plane.</source>
        <translation>센서의 xy 평면 위로 잰 수직각.</translation>
    </message>
    <message>
        <source>Estimation</source>
        <translation>추정</translation>
    </message>
    <message>
        <source>Estimator</source>
        <translation>추정 방법</translation>
    </message>
    <message>
        <source>How a target&apos;s coordinates follow from its readings.</source>
        <translation>읽음값에서 표적의 좌표를 구하는 방법.</translation>
    </message>
    <message>
        <source>non-linear weighted least squares</source>
        <translation>비선형 가중 최소제곱</translation>
    </message>
    <message>
        <source>linearised equations: OLS, then GLS (Eqs 1-4 of the paper)</source>
        <translation>선형화 방정식: OLS, 다음에 GLS(논문의 식 1-4)</translation>
    </message>
    <message>
        <source>linearised equations: OLS alone (Eq 3 of the paper)</source>
        <translation>선형화 방정식: OLS만(논문의 식 3)</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>가중치</translation>
    </message>
    <message>
        <source>What the weights of the equations account for. Weights from the readings alone, as in the paper, are not the best where the stations are uncertain.</source>
        <translation>방정식의 가중치가 고려하는 것. 논문처럼 읽음값만의 가중치는 스테이션이 불확실할 때 최선이 아닙니다.</translation>
    </message>
    <message>
        <source>readings and stations, all targets of a set-up at once</source>
        <translation>읽음값과 스테이션, 한 설치의 모든 표적을 동시에</translation>
    </message>
    <message>
        <source>readings alone, each target by itself (the paper)</source>
        <translation>읽음값만, 표적마다 따로(논문)</translation>
    </message>
    <message>
        <source>TCP from ballbars</source>
        <translation>볼바에 의한 TCP</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>측정</translation>
    </message>
    <message>
        <source>Ballbars</source>
        <translation>볼바</translation>
    </message>
    <message>
        <source>The set of telescopic ballbars that measures the points.</source>
        <translation>점을 측정하는 텔레스코픽 볼바 세트.</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>로봇</translation>
    </message>
    <message>
        <source>Gives the repeatability with which the robot goes to the points; none: an ideal robot.</source>
        <translation>로봇이 점으로 가는 반복성을 줍니다. 없음: 이상적인 로봇.</translation>
    </message>
    <message>
        <source>tool centre point, planned procedure</source>
        <translation>공구 중심점, 계획된 절차</translation>
    </message>
    <message>
        <source>tool centre point, measured points</source>
        <translation>공구 중심점, 측정점</translation>
    </message>
    <message>
        <source>points alone</source>
        <translation>점만</translation>
    </message>
    <message>
        <source>Procedure</source>
        <translation>절차</translation>
    </message>
    <message>
        <source>Flange</source>
        <translation>플랜지</translation>
    </message>
    <message>
        <source>Pose of the flange in the robot&apos;s frame before it turns; its origin is the centre of the sphere on which the ball moves.</source>
        <translation>회전하기 전 로봇 좌표계에서의 플랜지 포즈. 그 원점은 볼이 움직이는 구의 중심입니다.</translation>
    </message>
    <message>
        <source>Tool x</source>
        <translation>공구 x</translation>
    </message>
    <message>
        <source>Nominal coordinate x of the tool centre point in the flange&apos;s frame.</source>
        <translation>플랜지 좌표계에서 공구 중심점의 공칭 좌표 x.</translation>
    </message>
    <message>
        <source>Tool y</source>
        <translation>공구 y</translation>
    </message>
    <message>
        <source>Nominal coordinate y of the tool centre point in the flange&apos;s frame.</source>
        <translation>플랜지 좌표계에서 공구 중심점의 공칭 좌표 y.</translation>
    </message>
    <message>
        <source>Tool z</source>
        <translation>공구 z</translation>
    </message>
    <message>
        <source>Nominal coordinate z of the tool centre point in the flange&apos;s frame.</source>
        <translation>플랜지 좌표계에서 공구 중심점의 공칭 좌표 z.</translation>
    </message>
    <message>
        <source>Rotations</source>
        <translation>회전</translation>
    </message>
    <message>
        <source>Two or three rotations of the flange about its own axes, its origin held in place: the ball traces an arc in each.</source>
        <translation>원점을 고정한 채 플랜지를 자체 축 둘레로 두세 번 회전합니다. 각 회전에서 볼이 호를 그립니다.</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>축</translation>
    </message>
    <message>
        <source>Axis of the flange about which the robot turns.</source>
        <translation>로봇이 회전하는 플랜지의 축.</translation>
    </message>
    <message>
        <source>start</source>
        <translation>시작</translation>
    </message>
    <message>
        <source>Angle at the first point.</source>
        <translation>첫 점에서의 각.</translation>
    </message>
    <message>
        <source>span</source>
        <translation>범위</translation>
    </message>
    <message>
        <source>Angle from the first point to the last; negative: turned the other way.</source>
        <translation>첫 점에서 마지막 점까지의 각. 음수: 반대 방향으로 회전.</translation>
    </message>
    <message>
        <source>points</source>
        <translation>점</translation>
    </message>
    <message>
        <source>Number of points, equally spaced from the first to the last.</source>
        <translation>첫 점에서 마지막 점까지 등간격인 점의 수.</translation>
    </message>
    <message>
        <source>Points as measured, each with the axis of its rotation and the commanded angle, typed or from a CSV file.</source>
        <translation>측정된 점. 각각 회전의 축과 지령 각도를 가지며, 직접 입력하거나 CSV 파일에서 읽습니다.</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>각</translation>
    </message>
    <message>
        <source>Commanded angle of rotation.</source>
        <translation>회전의 지령 각도.</translation>
    </message>
    <message>
        <source>Coordinate x in the frame of the ballbars.</source>
        <translation>볼바 좌표계에서의 좌표 x.</translation>
    </message>
    <message>
        <source>Coordinate y in the frame of the ballbars.</source>
        <translation>볼바 좌표계에서의 좌표 y.</translation>
    </message>
    <message>
        <source>Coordinate z in the frame of the ballbars.</source>
        <translation>볼바 좌표계에서의 좌표 z.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>점</translation>
    </message>
    <message>
        <source>Places of the ball that are measured, typed or from a CSV file.</source>
        <translation>측정되는 볼의 위치. 직접 입력하거나 CSV 파일에서 읽습니다.</translation>
    </message>
    <message>
        <source>Name of the point, unique.</source>
        <translation>점의 이름, 고유해야 합니다.</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>맞춤</translation>
    </message>
    <message>
        <source>Axes of the flange</source>
        <translation>플랜지의 축</translation>
    </message>
    <message>
        <source>Measured axes are not exactly perpendicular: which one is kept as measured. A third measured axis then only helps the sphere and the mean.</source>
        <translation>측정된 축은 정확히 직각이 아닙니다. 어느 축을 측정된 대로 둘지 정합니다. 세 번째 측정 축은 구와 평균에만 도움이 됩니다.</translation>
    </message>
    <message>
        <source>y as measured, x nearest to measured</source>
        <translation>y는 측정대로, x는 측정에 가장 가깝게</translation>
    </message>
    <message>
        <source>x as measured, y nearest to measured</source>
        <translation>x는 측정대로, y는 측정에 가장 가깝게</translation>
    </message>
    <message>
        <source>z as measured, x nearest to measured</source>
        <translation>z는 측정대로, x는 측정에 가장 가깝게</translation>
    </message>
    <message>
        <source>nearest to all measured axes</source>
        <translation>측정된 모든 축에 가장 가깝게</translation>
    </message>
    <message>
        <source>Centre of the flange</source>
        <translation>플랜지의 중심</translation>
    </message>
    <message>
        <source>Sphere through all points by linear least squares, or refined to least distances from it.</source>
        <translation>모든 점을 지나는 구를 선형 최소제곱으로 구하거나, 구까지의 거리가 최소가 되도록 정밀화합니다.</translation>
    </message>
    <message>
        <source>sphere, geometric fit from the linear one</source>
        <translation>구, 선형 맞춤에서 시작한 기하 맞춤</translation>
    </message>
    <message>
        <source>sphere, linear fit</source>
        <translation>구, 선형 맞춤</translation>
    </message>
    <message>
        <source>Robot pose</source>
        <translation>로봇 포즈</translation>
    </message>
    <message>
        <source>The arm, with its parameters and their uncertainty.</source>
        <translation>매개변수와 그 불확도를 갖는 로봇 팔.</translation>
    </message>
    <message>
        <source>Components of a parameter</source>
        <translation>매개변수의 성분</translation>
    </message>
    <message>
        <source>Each by itself, so that the budget tells the sources apart; or combined into one normal deviation, which needs fewer draws.</source>
        <translation>총괄표에서 출처를 구별하도록 각각 따로, 또는 추출이 더 적게 드는 하나의 정규 편차로 합성.</translation>
    </message>
    <message>
        <source>each by itself</source>
        <translation>각각 따로</translation>
    </message>
    <message>
        <source>combined into one</source>
        <translation>하나로 합성</translation>
    </message>
    <message>
        <source>Correlation of the parameters</source>
        <translation>매개변수의 상관</translation>
    </message>
    <message>
        <source>Used as the robot states it; or ignored, as in the paper, to see what that does.</source>
        <translation>로봇이 제시한 대로 사용하거나, 그 영향을 보기 위해 논문처럼 무시합니다.</translation>
    </message>
    <message>
        <source>used</source>
        <translation>사용</translation>
    </message>
    <message>
        <source>ignored (the paper)</source>
        <translation>무시(논문)</translation>
    </message>
    <message>
        <source>Poses by joint readings</source>
        <translation>관절 읽음값에 의한 포즈</translation>
    </message>
    <message>
        <source>Readings of the joints, typed or from a CSV file. An empty cell is the zero reading of the joint; a robot with fewer joints leaves the last columns empty.</source>
        <translation>관절의 읽음값. 직접 입력하거나 CSV 파일에서 읽습니다. 빈 칸은 관절의 영점 읽음값이고, 관절이 더 적은 로봇은 마지막 열을 비워 둡니다.</translation>
    </message>
    <message>
        <source>Name of the pose, unique.</source>
        <translation>포즈의 이름, 고유해야 합니다.</translation>
    </message>
    <message>
        <source>Reading of joint 1, if it turns.</source>
        <translation>관절 1의 읽음값(회전 관절).</translation>
    </message>
    <message>
        <source>Reading of joint 2, if it turns.</source>
        <translation>관절 2의 읽음값(회전 관절).</translation>
    </message>
    <message>
        <source>Reading of joint 3, if it turns.</source>
        <translation>관절 3의 읽음값(회전 관절).</translation>
    </message>
    <message>
        <source>Reading of joint 4, if it turns.</source>
        <translation>관절 4의 읽음값(회전 관절).</translation>
    </message>
    <message>
        <source>Reading of joint 5, if it turns.</source>
        <translation>관절 5의 읽음값(회전 관절).</translation>
    </message>
    <message>
        <source>Reading of joint 6, if it turns.</source>
        <translation>관절 6의 읽음값(회전 관절).</translation>
    </message>
    <message>
        <source>Reading of joint 7, if it turns.</source>
        <translation>관절 7의 읽음값(회전 관절).</translation>
    </message>
    <message>
        <source>Reading of joint 1, if it slides.</source>
        <translation>관절 1의 읽음값(직선 관절).</translation>
    </message>
    <message>
        <source>Reading of joint 2, if it slides.</source>
        <translation>관절 2의 읽음값(직선 관절).</translation>
    </message>
    <message>
        <source>Reading of joint 3, if it slides.</source>
        <translation>관절 3의 읽음값(직선 관절).</translation>
    </message>
    <message>
        <source>Reading of joint 4, if it slides.</source>
        <translation>관절 4의 읽음값(직선 관절).</translation>
    </message>
    <message>
        <source>Reading of joint 5, if it slides.</source>
        <translation>관절 5의 읽음값(직선 관절).</translation>
    </message>
    <message>
        <source>Reading of joint 6, if it slides.</source>
        <translation>관절 6의 읽음값(직선 관절).</translation>
    </message>
    <message>
        <source>Reading of joint 7, if it slides.</source>
        <translation>관절 7의 읽음값(직선 관절).</translation>
    </message>
    <message>
        <source>Poses by place</source>
        <translation>위치에 의한 포즈</translation>
    </message>
    <message>
        <source>Places of the tool in the robot&apos;s base frame; the readings follow by inverse kinematics, within the limits and near those of the pose before.</source>
        <translation>로봇의 베이스 좌표계에서 공구의 위치. 읽음값은 한계 안에서 앞 포즈의 값에 가깝게 역기구학으로 구합니다.</translation>
    </message>
    <message>
        <source>Name, unique.</source>
        <translation>이름, 고유해야 합니다.</translation>
    </message>
    <message>
        <source>Coordinate x of the tool.</source>
        <translation>공구의 좌표 x.</translation>
    </message>
    <message>
        <source>Coordinate y of the tool.</source>
        <translation>공구의 좌표 y.</translation>
    </message>
    <message>
        <source>Coordinate z of the tool.</source>
        <translation>공구의 좌표 z.</translation>
    </message>
    <message>
        <source>Orientation, R = Rz(gamma) Ry(beta) Rx(alpha); all three empty: any orientation.</source>
        <translation>자세, R = Rz(gamma) Ry(beta) Rx(alpha). 셋 다 비어 있으면 임의의 자세.</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>결과</translation>
    </message>
    <message>
        <source>Numbers that state the orientation of the tool; none: the position alone.</source>
        <translation>공구의 자세를 나타내는 수. 없음: 위치만.</translation>
    </message>
    <message>
        <source>none (position alone)</source>
        <translation>없음(위치만)</translation>
    </message>
    <message>
        <source>Results in</source>
        <translation>결과의 좌표계</translation>
    </message>
    <message>
        <source>The frame in which position and orientation are stated.</source>
        <translation>위치와 자세를 나타내는 좌표계.</translation>
    </message>
    <message>
        <source>the base frame of the robot</source>
        <translation>로봇의 베이스 좌표계</translation>
    </message>
    <message>
        <source>the world frame</source>
        <translation>월드 좌표계</translation>
    </message>
    <message>
        <source>Robot by joint trajectories</source>
        <translation>관절 궤적에 의한 로봇</translation>
    </message>
    <message>
        <source>Nominal robot</source>
        <translation>공칭 로봇</translation>
    </message>
    <message>
        <source>The arm as designed: directions of the frames, definitions of base and last link, and the arm of a simulation.</source>
        <translation>설계된 로봇 팔: 좌표계의 방향, 베이스와 마지막 링크의 정의, 시뮬레이션의 팔.</translation>
    </message>
    <message>
        <source>Points are</source>
        <translation>점의 종류</translation>
    </message>
    <message>
        <source>Measured: a table. Simulated: those of the nominal robot, to see what an experiment would give.</source>
        <translation>측정: 표. 시뮬레이션: 실험이 무엇을 줄지 보기 위한 공칭 로봇의 점.</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>측정</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>시뮬레이션</translation>
    </message>
    <message>
        <source>Points of the ball at the flange in the order in which they were measured, joint by joint, in the frame of the instrument&apos;s world; typed or from a CSV file.</source>
        <translation>플랜지에 달린 볼의 점. 측정 순서대로 관절별로, 측정기의 월드 좌표계에서 나타내며, 직접 입력하거나 CSV 파일에서 읽습니다.</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>관절</translation>
    </message>
    <message>
        <source>Number of the joint that turned.</source>
        <translation>회전한 관절의 번호.</translation>
    </message>
    <message>
        <source>Reading of that joint; says which way round the points run. Empty: with the joint&apos;s positive direction.</source>
        <translation>그 관절의 읽음값. 점이 진행하는 방향을 알려 줍니다. 비어 있으면 관절의 양의 방향.</translation>
    </message>
    <message>
        <source>Coordinate x.</source>
        <translation>좌표 x.</translation>
    </message>
    <message>
        <source>Coordinate y.</source>
        <translation>좌표 y.</translation>
    </message>
    <message>
        <source>Coordinate z.</source>
        <translation>좌표 z.</translation>
    </message>
    <message>
        <source>Range of each joint, ±</source>
        <translation>각 관절의 범위, ±</translation>
    </message>
    <message>
        <source>Each joint turns from its zero reading less this to its zero reading plus this.</source>
        <translation>각 관절은 영점 읽음값에서 이 값을 뺀 곳부터 더한 곳까지 회전합니다.</translation>
    </message>
    <message>
        <source>Points for each joint</source>
        <translation>관절당 점의 수</translation>
    </message>
    <message>
        <source>Number of points, evenly spaced over the range.</source>
        <translation>범위에 등간격으로 놓인 점의 수.</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>볼</translation>
    </message>
    <message>
        <source>Where the ball is in the frame of the last link. On the axis of a joint it draws no circle.</source>
        <translation>마지막 링크의 좌표계에서 볼이 있는 곳. 관절의 축 위에 있으면 원을 그리지 않습니다.</translation>
    </message>
    <message>
        <source>A standard uncertainty of every coordinate, or an instrument of the project that stands somewhere.</source>
        <translation>모든 좌표의 표준불확도, 또는 어딘가에 설치된 프로젝트의 측정기.</translation>
    </message>
    <message>
        <source>typed: alike for all coordinates</source>
        <translation>직접 입력: 모든 좌표에 같게</translation>
    </message>
    <message>
        <source>an instrument</source>
        <translation>측정기</translation>
    </message>
    <message>
        <source>Standard uncertainty of a coordinate</source>
        <translation>좌표의 표준불확도</translation>
    </message>
    <message>
        <source>Of every coordinate of every point, independent of all others.</source>
        <translation>모든 점의 모든 좌표에 대한 값, 서로 독립입니다.</translation>
    </message>
    <message>
        <source>The distribution of the coordinates&apos; deviations; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation>좌표 편차의 분포. 형태와 관계없이 제시된 값은 표준불확도입니다.</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>측정기</translation>
    </message>
    <message>
        <source>What measured the points: each reading deviates by itself, its scale and its station alike for all points.</source>
        <translation>점을 측정한 것. 각 읽음값은 따로 벗어나고, 스케일과 스테이션은 모든 점에 똑같이 벗어납니다.</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>방법</translation>
    </message>
    <message>
        <source>Plane of a circle</source>
        <translation>원의 평면</translation>
    </message>
    <message>
        <source>Total least squares fits any plane. Eq 1 of the paper has no plane through the origin and fails near it.</source>
        <translation>전최소제곱은 어떤 평면에도 맞습니다. 논문의 식 1은 원점을 지나는 평면을 나타내지 못하고 그 근처에서 실패합니다.</translation>
    </message>
    <message>
        <source>total least squares</source>
        <translation>전최소제곱</translation>
    </message>
    <message>
        <source>A x + B y + C z + 1 = 0 (Eq 1)</source>
        <translation>A x + B y + C z + 1 = 0 (식 1)</translation>
    </message>
    <message>
        <source>Axes are parallel below</source>
        <translation>축을 평행으로 보는 한계</translation>
    </message>
    <message>
        <source>Angle between two axes below which they are described by beta and not by their common perpendicular, whose place is then hardly determined.</source>
        <translation>두 축 사이의 각이 이보다 작으면, 위치가 거의 정해지지 않는 공통 수선 대신 beta로 나타냅니다.</translation>
    </message>
    <message>
        <source>Robot from measured poses</source>
        <translation>측정 포즈로부터의 로봇</translation>
    </message>
    <message>
        <source>The arm as designed: start of the fit, values of what the poses cannot tell, uncertainty of the readings of its joints, and the arm of a simulation.</source>
        <translation>설계된 로봇 팔: 맞춤의 시작값, 포즈로 알 수 없는 값, 관절 읽음값의 불확도, 시뮬레이션의 팔.</translation>
    </message>
    <message>
        <source>Poses are</source>
        <translation>포즈의 종류</translation>
    </message>
    <message>
        <source>Measured is</source>
        <translation>측정 대상</translation>
    </message>
    <message>
        <source>The position of a ball alone, or position and orientation of the tool.</source>
        <translation>볼의 위치만, 또는 공구의 위치와 자세.</translation>
    </message>
    <message>
        <source>the position</source>
        <translation>위치</translation>
    </message>
    <message>
        <source>position and orientation</source>
        <translation>위치와 자세</translation>
    </message>
    <message>
        <source>Measured poses</source>
        <translation>측정 포즈</translation>
    </message>
    <message>
        <source>Readings of the joints and the place of the ball or tool that was measured there; typed or from a CSV file.</source>
        <translation>관절의 읽음값과 거기서 측정된 볼이나 공구의 위치. 직접 입력하거나 CSV 파일에서 읽습니다.</translation>
    </message>
    <message>
        <source>use</source>
        <translation>용도</translation>
    </message>
    <message>
        <source>fit: taken into the fit. check: held back, to see how well the fit tells a pose that it has not seen. Empty: fit.</source>
        <translation>맞춤(fit): 맞춤에 포함. 확인(check): 맞춤이 보지 못한 포즈를 얼마나 잘 예측하는지 보기 위해 제외. 비어 있으면 맞춤.</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>맞춤</translation>
    </message>
    <message>
        <source>Reading of joint 1; empty: its zero reading.</source>
        <translation>관절 1의 읽음값. 비어 있으면 영점 읽음값.</translation>
    </message>
    <message>
        <source>Reading of joint 2; empty: its zero reading.</source>
        <translation>관절 2의 읽음값. 비어 있으면 영점 읽음값.</translation>
    </message>
    <message>
        <source>Reading of joint 3; empty: its zero reading.</source>
        <translation>관절 3의 읽음값. 비어 있으면 영점 읽음값.</translation>
    </message>
    <message>
        <source>Reading of joint 4; empty: its zero reading.</source>
        <translation>관절 4의 읽음값. 비어 있으면 영점 읽음값.</translation>
    </message>
    <message>
        <source>Reading of joint 5; empty: its zero reading.</source>
        <translation>관절 5의 읽음값. 비어 있으면 영점 읽음값.</translation>
    </message>
    <message>
        <source>Reading of joint 6; empty: its zero reading.</source>
        <translation>관절 6의 읽음값. 비어 있으면 영점 읽음값.</translation>
    </message>
    <message>
        <source>Reading of joint 7; empty: its zero reading.</source>
        <translation>관절 7의 읽음값. 비어 있으면 영점 읽음값.</translation>
    </message>
    <message>
        <source>Measured coordinate x in the frame of the instrument&apos;s world.</source>
        <translation>측정기의 월드 좌표계에서 측정된 좌표 x.</translation>
    </message>
    <message>
        <source>Measured coordinate y in the frame of the instrument&apos;s world.</source>
        <translation>측정기의 월드 좌표계에서 측정된 좌표 y.</translation>
    </message>
    <message>
        <source>Measured coordinate z in the frame of the instrument&apos;s world.</source>
        <translation>측정기의 월드 좌표계에서 측정된 좌표 z.</translation>
    </message>
    <message>
        <source>Measured orientation, R = Rz(gamma) Ry(beta) Rx(alpha), where poses are measured.</source>
        <translation>포즈를 측정하는 경우의 측정된 자세, R = Rz(gamma) Ry(beta) Rx(alpha).</translation>
    </message>
    <message>
        <source>Number of poses</source>
        <translation>포즈의 수</translation>
    </message>
    <message>
        <source>Poses of the simulated experiment, spread over the range of all joints, always the same.</source>
        <translation>시뮬레이션 실험의 포즈. 모든 관절의 범위에 퍼져 있으며 항상 같습니다.</translation>
    </message>
    <message>
        <source>From the zero reading on, as far as the limits of the joint allow.</source>
        <translation>영점 읽음값에서부터 관절의 한계가 허용하는 데까지.</translation>
    </message>
    <message>
        <source>Standard uncertainty of an orientation</source>
        <translation>자세의 표준불확도</translation>
    </message>
    <message>
        <source>Of the rotation of the measured tool about each of its axes, independent.</source>
        <translation>측정된 공구의 각 축 둘레 회전의 값, 서로 독립입니다.</translation>
    </message>
    <message>
        <source>Ball or tool</source>
        <translation>볼 또는 공구</translation>
    </message>
    <message>
        <source>Where it is in the frame of the last link: exactly, or as a start of the fit.</source>
        <translation>마지막 링크의 좌표계에서의 위치: 정확한 값, 또는 맞춤의 시작값.</translation>
    </message>
    <message>
        <source>Place of the ball or tool is</source>
        <translation>볼 또는 공구의 위치</translation>
    </message>
    <message>
        <source>Found by the fit together with the parameters, or known.</source>
        <translation>매개변수와 함께 맞춤으로 구하거나, 알고 있습니다.</translation>
    </message>
    <message>
        <source>found by the fit</source>
        <translation>맞춤으로 구함</translation>
    </message>
    <message>
        <source>known exactly</source>
        <translation>정확히 알고 있음</translation>
    </message>
    <message>
        <source>Place of the base is</source>
        <translation>베이스의 위치</translation>
    </message>
    <message>
        <source>Found by the fit: the instrument stands anywhere. Known: the base stands where the robot says it stands in the world.</source>
        <translation>맞춤으로 구함: 측정기가 어디에 있어도 됩니다. 알고 있음: 베이스는 로봇이 제시한 월드의 위치에 있습니다.</translation>
    </message>
    <message>
        <source>Parameters held</source>
        <translation>고정된 매개변수</translation>
    </message>
    <message>
        <source>Parameters that stay nominal although the poses could tell them.</source>
        <translation>포즈로 알 수 있더라도 공칭값으로 두는 매개변수.</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>매개변수</translation>
    </message>
    <message>
        <source>A parameter by its symbol, such as d_3 or alpha_4.</source>
        <translation>d_3이나 alpha_4처럼 기호로 나타낸 매개변수.</translation>
    </message>
    <message>
        <source>Channels of a force/moment sensor</source>
        <translation>힘/모멘트 센서의 채널</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>센서</translation>
    </message>
    <message>
        <source>The calibrated multi-axis sensor.</source>
        <translation>교정된 다축 센서.</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>사용</translation>
    </message>
    <message>
        <source>Loads on the other axes</source>
        <translation>다른 축의 하중</translation>
    </message>
    <message>
        <source>What acts on the other axes while a channel is read. Unknown loads are rectangular between minus and plus the rated load, one and the same for all channels.</source>
        <translation>한 채널을 읽는 동안 다른 축에 작용하는 것. 알지 못하는 하중은 음과 양의 정격하중 사이의 직사각형 분포이며, 모든 채널에 동일합니다.</translation>
    </message>
    <message>
        <source>none: one component alone</source>
        <translation>없음: 한 성분만</translation>
    </message>
    <message>
        <source>unknown on one axis, that with the largest interference</source>
        <translation>한 축에서 알지 못함, 간섭이 가장 큰 축</translation>
    </message>
    <message>
        <source>unknown on all other axes</source>
        <translation>다른 모든 축에서 알지 못함</translation>
    </message>
    <message>
        <source>Repeatability</source>
        <translation>반복성</translation>
    </message>
    <message>
        <source>The largest standard deviation of all steps, as in the paper, or that pooled over the steps, which has more degrees of freedom.</source>
        <translation>논문처럼 모든 단계의 최대 표준편차, 또는 자유도가 더 큰 단계 전체의 합동 표준편차.</translation>
    </message>
    <message>
        <source>largest of the steps</source>
        <translation>단계 중 최대</translation>
    </message>
    <message>
        <source>pooled over the steps</source>
        <translation>단계 전체의 합동</translation>
    </message>
    <message>
        <source>Type A in Monte Carlo</source>
        <translation>몬테카를로에서의 A형</translation>
    </message>
    <message>
        <source>Normal, with its degrees of freedom in the law of propagation, or a t-distribution (JCGM 101 6.4.9). With n = 3 the latter has no standard deviation: only coverage intervals then mean something.</source>
        <translation>전파 법칙에서는 자유도를 갖는 정규분포, 또는 t 분포(JCGM 101 6.4.9). n = 3이면 t 분포는 표준편차가 없으며, 그때는 포함구간만 의미가 있습니다.</translation>
    </message>
    <message>
        <source>scaled and shifted t</source>
        <translation>척도와 위치를 변환한 t</translation>
    </message>
    <message>
        <source>Coverage factor of the comparison</source>
        <translation>비교의 포함인자</translation>
    </message>
    <message>
        <source>k of the GUM&apos;s columns in the table beside the paper&apos;s.</source>
        <translation>논문의 열 옆에 있는 표에서 GUM 열의 k.</translation>
    </message>
    <message>
        <source>Forces and moments by the calibration matrix</source>
        <translation>교정 행렬에 의한 힘과 모멘트</translation>
    </message>
    <message>
        <source>Cases</source>
        <translation>경우</translation>
    </message>
    <message>
        <source>Cases are given by</source>
        <translation>경우의 입력 방식</translation>
    </message>
    <message>
        <source>Readings that were taken, or loads whose uncertainty is wanted.</source>
        <translation>얻은 읽음값, 또는 불확도를 알고자 하는 하중.</translation>
    </message>
    <message>
        <source>readings</source>
        <translation>읽음값</translation>
    </message>
    <message>
        <source>loads</source>
        <translation>하중</translation>
    </message>
    <message>
        <source>Net readings of all channels, the unloaded readings subtracted.</source>
        <translation>무하중 읽음값을 뺀, 모든 채널의 순 읽음값.</translation>
    </message>
    <message>
        <source>Names the case in results.</source>
        <translation>결과에서 경우의 이름.</translation>
    </message>
    <message>
        <source>Fx</source>
        <translation>Fx</translation>
    </message>
    <message>
        <source>Net reading of this channel.</source>
        <translation>이 채널의 순 읽음값.</translation>
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
        <translation>하중</translation>
    </message>
    <message>
        <source>Forces and moments that act together; the readings follow from the calibration matrix. An empty cell is zero.</source>
        <translation>함께 작용하는 힘과 모멘트. 읽음값은 교정 행렬에서 구합니다. 빈 칸은 0입니다.</translation>
    </message>
    <message>
        <source>Load on this axis.</source>
        <translation>이 축의 하중.</translation>
    </message>
    <message>
        <source>Calibration matrix</source>
        <translation>교정 행렬</translation>
    </message>
    <message>
        <source>Least squares through zero over the increasing readings: slopes alone, or with the squares of the loads.</source>
        <translation>증가하는 읽음값에 대한 원점 통과 최소제곱: 기울기만, 또는 하중의 제곱항 포함.</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>선형</translation>
    </message>
    <message>
        <source>with quadratic terms</source>
        <translation>이차항 포함</translation>
    </message>
    <message>
        <source>Repeatability of a reading</source>
        <translation>읽음값의 반복성</translation>
    </message>
    <message>
        <source>The largest standard deviation of all steps, or that pooled over the steps.</source>
        <translation>모든 단계의 최대 표준편차, 또는 단계 전체의 합동 표준편차.</translation>
    </message>
    <message>
        <source>Normal, with its degrees of freedom in the law of propagation, or a t-distribution (JCGM 101 6.4.9), which has no standard deviation with n = 3.</source>
        <translation>전파 법칙에서는 자유도를 갖는 정규분포, 또는 n = 3이면 표준편차가 없는 t 분포(JCGM 101 6.4.9).</translation>
    </message>
    <message>
        <source>Hysteresis of a reading</source>
        <translation>읽음값의 히스테리시스</translation>
    </message>
    <message>
        <source>Rectangular over the width of the loop: in proportion to the load on the channel&apos;s axis, or the full width at any load.</source>
        <translation>루프의 폭에 걸친 직사각형 분포: 채널 축의 하중에 비례, 또는 모든 하중에서 전체 폭.</translation>
    </message>
    <message>
        <source>in proportion to the load</source>
        <translation>하중에 비례</translation>
    </message>
    <message>
        <source>full at any load</source>
        <translation>모든 하중에서 전체</translation>
    </message>
    <message>
        <source>Measurement equation</source>
        <translation>측정 방정식</translation>
    </message>
    <message>
        <source>Equations</source>
        <translation>방정식</translation>
    </message>
    <message>
        <source>symbol</source>
        <translation>기호</translation>
    </message>
    <message>
        <source>Name that an equation defines.</source>
        <translation>방정식이 정의하는 이름.</translation>
    </message>
    <message>
        <source>What it is, for tables and reports.</source>
        <translation>무엇인지에 대한 설명, 표와 보고서용.</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>단위</translation>
    </message>
    <message>
        <source>Unit of the result; empty: the SI unit that follows from the equations.</source>
        <translation>결과의 단위. 비어 있으면 방정식에서 나오는 SI 단위.</translation>
    </message>
    <message>
        <source>Measurands have coverage regions together; empty: measurand.</source>
        <translation>측정량은 함께 포함영역을 갖습니다. 비어 있으면 측정량.</translation>
    </message>
    <message>
        <source>measurand</source>
        <translation>측정량</translation>
    </message>
    <message>
        <source>intermediate</source>
        <translation>중간량</translation>
    </message>
    <message>
        <source>group</source>
        <translation>그룹</translation>
    </message>
    <message>
        <source>Results of one group have a joint coverage region.</source>
        <translation>한 그룹의 결과는 결합 포함영역을 갖습니다.</translation>
    </message>
    <message>
        <source>Quantities</source>
        <translation>양</translation>
    </message>
    <message>
        <source>One row for each component of uncertainty. The first row of a symbol has its value and unit; further rows of the same symbol add components and have no value.</source>
        <translation>불확도 성분마다 한 행. 기호의 첫 행에는 값과 단위가 있고, 같은 기호의 다음 행은 성분을 추가하며 값이 없습니다.</translation>
    </message>
    <message>
        <source>Name that the equations use: x_1, alpha_s.</source>
        <translation>방정식이 쓰는 이름: x_1, alpha_s.</translation>
    </message>
    <message>
        <source>What it is, or what the component is.</source>
        <translation>무엇인지, 또는 그 성분이 무엇인지.</translation>
    </message>
    <message>
        <source>value</source>
        <translation>값</translation>
    </message>
    <message>
        <source>Estimate, in the row&apos;s unit; empty where observations or limits give it.</source>
        <translation>행의 단위로 나타낸 추정값. 관측값이나 한계가 그것을 주면 비워 둡니다.</translation>
    </message>
    <message>
        <source>stated as</source>
        <translation>제시 형식</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>상수</translation>
    </message>
    <message>
        <source>standard uncertainty</source>
        <translation>표준불확도</translation>
    </message>
    <message>
        <source>certificate, U and k</source>
        <translation>성적서, U와 k</translation>
    </message>
    <message>
        <source>certificate, U and p</source>
        <translation>성적서, U와 p</translation>
    </message>
    <message>
        <source>rectangular</source>
        <translation>직사각형</translation>
    </message>
    <message>
        <source>limits from a to b</source>
        <translation>a에서 b까지의 한계</translation>
    </message>
    <message>
        <source>limits inexactly known</source>
        <translation>부정확하게 알려진 한계</translation>
    </message>
    <message>
        <source>trapezoidal</source>
        <translation>사다리꼴</translation>
    </message>
    <message>
        <source>triangular</source>
        <translation>삼각형</translation>
    </message>
    <message>
        <source>arc sine</source>
        <translation>아크사인</translation>
    </message>
    <message>
        <source>resolution</source>
        <translation>분해능</translation>
    </message>
    <message>
        <source>maximum permissible error</source>
        <translation>최대허용오차</translation>
    </message>
    <message>
        <source>exponential</source>
        <translation>지수</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>계수 횟수</translation>
    </message>
    <message>
        <source>observations (Type A)</source>
        <translation>관측값(A형)</translation>
    </message>
    <message>
        <source>pooled observations (Type A)</source>
        <translation>합동 관측값(A형)</translation>
    </message>
    <message>
        <source>reading of an instrument</source>
        <translation>측정기의 읽음값</translation>
    </message>
    <message>
        <source>Second figure of the statement.</source>
        <translation>제시된 두 번째 수치.</translation>
    </message>
    <message>
        <source>Degrees of freedom; empty: infinite, or those of the observations.</source>
        <translation>자유도. 비어 있으면 무한대, 또는 관측값의 자유도.</translation>
    </message>
    <message>
        <source>Relative uncertainty of u instead of degrees of freedom (JCGM 100 G.3).</source>
        <translation>자유도 대신 u의 상대불확도(JCGM 100 G.3).</translation>
    </message>
    <message>
        <source>source</source>
        <translation>출처</translation>
    </message>
    <message>
        <source>Where the figure comes from: certificate, data sheet, handbook.</source>
        <translation>수치가 나온 곳: 성적서, 사양서, 핸드북.</translation>
    </message>
    <message>
        <source>instrument</source>
        <translation>측정기</translation>
    </message>
    <message>
        <source>Instrument of the project that reads the quantity, a distance.</source>
        <translation>그 양, 즉 거리를 읽는 프로젝트의 측정기.</translation>
    </message>
    <message>
        <source>Observations</source>
        <translation>관측값</translation>
    </message>
    <message>
        <source>Repeated observations for Type A evaluations, typed, pasted or from a CSV file. Observations of several quantities with the same numbers were made together: their means are then correlated (JCGM 100 5.2.3).</source>
        <translation>A형 평가를 위한 반복 관측값. 직접 입력하거나 붙여넣거나 CSV 파일에서 읽습니다. 번호가 같은 여러 양의 관측값은 함께 얻은 것이며, 그 평균들은 상관됩니다(JCGM 100 5.2.3).</translation>
    </message>
    <message>
        <source>quantity</source>
        <translation>양</translation>
    </message>
    <message>
        <source>Symbol of the quantity.</source>
        <translation>양의 기호.</translation>
    </message>
    <message>
        <source>number</source>
        <translation>번호</translation>
    </message>
    <message>
        <source>Number of the simultaneous observation; empty: the quantity was observed by itself.</source>
        <translation>동시 관측의 번호. 비어 있으면 그 양을 따로 관측한 것입니다.</translation>
    </message>
    <message>
        <source>series</source>
        <translation>계열</translation>
    </message>
    <message>
        <source>Name of an earlier series of the same procedure, for a pooled standard deviation.</source>
        <translation>합동 표준편차를 위한, 같은 절차의 이전 계열의 이름.</translation>
    </message>
    <message>
        <source>Observed value, in the unit of the quantity.</source>
        <translation>양의 단위로 나타낸 관측된 값.</translation>
    </message>
    <message>
        <source>Means of observations</source>
        <translation>관측값의 평균</translation>
    </message>
    <message>
        <source>Distribution of a mean in Monte Carlo trials: Student t with the degrees of freedom of the observations (JCGM 101 6.4.9), or normal.</source>
        <translation>몬테카를로 시행에서 평균의 분포: 관측값의 자유도를 갖는 스튜던트 t(JCGM 101 6.4.9), 또는 정규.</translation>
    </message>
    <message>
        <source>Student t</source>
        <translation>스튜던트 t</translation>
    </message>
    <message>
        <source>Calibration curve</source>
        <translation>교정 곡선</translation>
    </message>
    <message>
        <source>Unit of x</source>
        <translation>x의 단위</translation>
    </message>
    <message>
        <source>Unit in which x is given. A difference of temperatures, a correction of a thermometer too, is given in K.</source>
        <translation>x를 나타내는 단위. 온도차는, 온도계의 보정값도, K로 나타냅니다.</translation>
    </message>
    <message>
        <source>Unit of y</source>
        <translation>y의 단위</translation>
    </message>
    <message>
        <source>Unit in which y is given. A difference of temperatures, a correction of a thermometer too, is given in K.</source>
        <translation>y를 나타내는 단위. 온도차는, 온도계의 보정값도, K로 나타냅니다.</translation>
    </message>
    <message>
        <source>Points of the calibration, typed, pasted or from a CSV file.</source>
        <translation>교정의 점. 직접 입력하거나 붙여넣거나 CSV 파일에서 읽습니다.</translation>
    </message>
    <message>
        <source>Independent quantity, in its unit.</source>
        <translation>독립량, 그 단위로.</translation>
    </message>
    <message>
        <source>Standard uncertainty of x; empty: none. Used with stated uncertainties.</source>
        <translation>x의 표준불확도. 비어 있으면 없음. 제시된 불확도와 함께 쓰입니다.</translation>
    </message>
    <message>
        <source>Observed quantity, in its unit.</source>
        <translation>관측된 양, 그 단위로.</translation>
    </message>
    <message>
        <source>Standard uncertainty of y. Used, and needed, with stated uncertainties.</source>
        <translation>y의 표준불확도. 제시된 불확도일 때 쓰이며 필요합니다.</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>곡선</translation>
    </message>
    <message>
        <source>Degree</source>
        <translation>차수</translation>
    </message>
    <message>
        <source>Of the polynomial: 1 is a straight line.</source>
        <translation>다항식의 차수: 1은 직선입니다.</translation>
    </message>
    <message>
        <source>Origin x_0</source>
        <translation>원점 x_0</translation>
    </message>
    <message>
        <source>The polynomial is one of x - x_0, in the unit of x. In the middle of the points the coefficients are hardly correlated.</source>
        <translation>다항식은 x의 단위로 나타낸 x - x_0의 다항식입니다. 점들의 가운데에서는 계수들의 상관이 거의 없습니다.</translation>
    </message>
    <message>
        <source>Through the origin</source>
        <translation>원점 통과</translation>
    </message>
    <message>
        <source>No constant term: the curve is zero at x_0.</source>
        <translation>상수항 없음: 곡선은 x_0에서 0입니다.</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>불확도</translation>
    </message>
    <message>
        <source>From the scatter of the residuals about the curve (JCGM 100 H.3), or as stated for each point.</source>
        <translation>곡선 둘레 잔차의 산포에서(JCGM 100 H.3), 또는 각 점에 제시된 대로.</translation>
    </message>
    <message>
        <source>from the residuals</source>
        <translation>잔차에서</translation>
    </message>
    <message>
        <source>as stated for x and y</source>
        <translation>x와 y에 제시된 대로</translation>
    </message>
    <message>
        <source>Use of the curve</source>
        <translation>곡선의 사용</translation>
    </message>
    <message>
        <source>Where the value of the curve is wanted, with its uncertainty.</source>
        <translation>곡선의 값과 그 불확도를 구할 곳.</translation>
    </message>
    <message>
        <source>In the unit of x.</source>
        <translation>x의 단위로.</translation>
    </message>
    <message>
        <source>Inverse use</source>
        <translation>역사용</translation>
    </message>
    <message>
        <source>Observed values of y whose x is wanted, with its uncertainty.</source>
        <translation>x와 그 불확도를 구할 y의 관측값.</translation>
    </message>
    <message>
        <source>Observed, in the unit of y.</source>
        <translation>관측값, y의 단위로.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the observed y; empty: none beside that of the readings.</source>
        <translation>관측된 y의 표준불확도. 비어 있으면 읽음값의 불확도뿐입니다.</translation>
    </message>
    <message>
        <source>The observed y is the mean of so many readings, which scatter as the points of the calibration do. With the uncertainty from the residuals only.</source>
        <translation>관측된 y는 이만큼의 읽음값의 평균이며, 읽음값은 교정의 점처럼 흩어집니다. 불확도를 잔차에서 구할 때만 해당합니다.</translation>
    </message>
    <message>
        <source>near</source>
        <translation>근처</translation>
    </message>
    <message>
        <source>Of several x that give this y, the one nearest to here, in the unit of x. Needed where the curve reaches y more than once between its points.</source>
        <translation>이 y를 주는 여러 x 가운데 여기에 가장 가까운 것, x의 단위로. 곡선이 점들 사이에서 y에 두 번 이상 이르는 경우에 필요합니다.</translation>
    </message>
    <message>
        <source>Observations in groups</source>
        <translation>그룹별 관측값</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>양</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>기호</translation>
    </message>
    <message>
        <source>Of the measured quantity.</source>
        <translation>측정된 양의 기호.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>이름</translation>
    </message>
    <message>
        <source>What is measured.</source>
        <translation>무엇을 측정하는지.</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>단위</translation>
    </message>
    <message>
        <source>In which the observations are given.</source>
        <translation>관측값을 나타내는 단위.</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>데이터</translation>
    </message>
    <message>
        <source>Every observation, or mean and standard deviation of each group.</source>
        <translation>모든 관측값, 또는 각 그룹의 평균과 표준편차.</translation>
    </message>
    <message>
        <source>observations</source>
        <translation>관측값</translation>
    </message>
    <message>
        <source>means and standard deviations</source>
        <translation>평균과 표준편차</translation>
    </message>
    <message>
        <source>Observations with the day, instrument or operator they belong to, typed, pasted or from a CSV file.</source>
        <translation>관측값과 그것이 속한 날짜, 측정기 또는 측정자. 직접 입력하거나 붙여넣거나 CSV 파일에서 읽습니다.</translation>
    </message>
    <message>
        <source>Day, instrument or operator.</source>
        <translation>날짜, 측정기 또는 측정자.</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>그룹</translation>
    </message>
    <message>
        <source>Mean and experimental standard deviation of the observations of each group.</source>
        <translation>각 그룹 관측값의 평균과 실험표준편차.</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>평균</translation>
    </message>
    <message>
        <source>Of the observations of the group, in the unit of the quantity.</source>
        <translation>그룹 관측값의 평균, 양의 단위로.</translation>
    </message>
    <message>
        <source>Experimental standard deviation of a single observation of the group.</source>
        <translation>그룹의 단일 관측값의 실험표준편차.</translation>
    </message>
    <message>
        <source>Number of observations in the group; empty: observations per group, as below.</source>
        <translation>그룹의 관측 횟수. 비어 있으면 아래의 그룹당 관측 횟수.</translation>
    </message>
    <message>
        <source>Observations per group</source>
        <translation>그룹당 관측 횟수</translation>
    </message>
    <message>
        <source>Number of observations in each group whose row does not say it.</source>
        <translation>행에 적혀 있지 않은 각 그룹의 관측 횟수.</translation>
    </message>
    <message>
        <source>Effect of the groups</source>
        <translation>그룹의 효과</translation>
    </message>
    <message>
        <source>Included: u of the mean of the groups&apos; means from their scatter. By components of variance: the same for groups of one size, else groups with more observations have more weight. Not included: all observations count as independent, which the F-test in the evaluation must allow.</source>
        <translation>포함: 그룹 평균의 산포에서 구한, 그룹 평균들의 평균의 u. 분산 성분: 그룹의 크기가 같으면 동일하고, 다르면 관측값이 많은 그룹의 가중치가 더 큽니다. 미포함: 모든 관측값을 독립으로 보며, 평가의 F 검정이 이를 허용해야 합니다.</translation>
    </message>
    <message>
        <source>included</source>
        <translation>포함</translation>
    </message>
    <message>
        <source>by components of variance</source>
        <translation>분산 성분에 의함</translation>
    </message>
    <message>
        <source>not included</source>
        <translation>미포함</translation>
    </message>
    <message>
        <source>Artefact with calibrated points</source>
        <translation>교정된 점을 갖는 기준물</translation>
    </message>
    <message>
        <source>Artefact</source>
        <translation>기준물</translation>
    </message>
    <message>
        <source>Calibrated points</source>
        <translation>교정된 점</translation>
    </message>
    <message>
        <source>The artefact&apos;s points with their calibrated coordinates in the artefact&apos;s frame.</source>
        <translation>기준물 좌표계에서 교정된 좌표를 갖는 기준물의 점.</translation>
    </message>
    <message>
        <source>Calibrated coordinate x.</source>
        <translation>교정된 좌표 x.</translation>
    </message>
    <message>
        <source>Calibrated coordinate y.</source>
        <translation>교정된 좌표 y.</translation>
    </message>
    <message>
        <source>Calibrated coordinate z.</source>
        <translation>교정된 좌표 z.</translation>
    </message>
    <message>
        <source>defines</source>
        <translation>정의</translation>
    </message>
    <message>
        <source>Coordinates that define the frame (&quot;xyz&quot;, &quot;yz&quot;), when they are named by point.</source>
        <translation>좌표계를 점별로 지정할 때, 좌표계를 정의하는 좌표(&quot;xyz&quot;, &quot;yz&quot;).</translation>
    </message>
    <message>
        <source>Evaluate from</source>
        <translation>평가의 근거</translation>
    </message>
    <message>
        <source>Repeated measurements of the artefact, or the components of uncertainty as a report prints them (Table 1 of the paper).</source>
        <translation>기준물의 반복 측정, 또는 보고서에 적힌 불확도 성분(논문의 표 1).</translation>
    </message>
    <message>
        <source>components of uncertainty</source>
        <translation>불확도 성분</translation>
    </message>
    <message>
        <source>Measured coordinates in the artefact&apos;s frame: one row for each point and run, typed or from a CSV file.</source>
        <translation>기준물 좌표계에서 측정된 좌표. 점과 회차마다 한 행이며, 직접 입력하거나 CSV 파일에서 읽습니다.</translation>
    </message>
    <message>
        <source>Name of a calibrated point.</source>
        <translation>교정된 점의 이름.</translation>
    </message>
    <message>
        <source>run</source>
        <translation>회차</translation>
    </message>
    <message>
        <source>Indicated coordinate x.</source>
        <translation>지시된 좌표 x.</translation>
    </message>
    <message>
        <source>Indicated coordinate y.</source>
        <translation>지시된 좌표 y.</translation>
    </message>
    <message>
        <source>Indicated coordinate z.</source>
        <translation>지시된 좌표 z.</translation>
    </message>
    <message>
        <source>Components of uncertainty</source>
        <translation>불확도 성분</translation>
    </message>
    <message>
        <source>One row for each coordinate, as Table 1 of the paper prints them.</source>
        <translation>논문의 표 1에 적힌 대로, 좌표마다 한 행.</translation>
    </message>
    <message>
        <source>coordinate</source>
        <translation>좌표</translation>
    </message>
    <message>
        <source>Coordinate of the row.</source>
        <translation>행의 좌표.</translation>
    </message>
    <message>
        <source>Calibration.</source>
        <translation>교정.</translation>
    </message>
    <message>
        <source>Temperature.</source>
        <translation>온도.</translation>
    </message>
    <message>
        <source>Variability: standard deviation of the errors of indication.</source>
        <translation>변동: 지시오차의 표준편차.</translation>
    </message>
    <message>
        <source>Bias: mean of the errors of indication.</source>
        <translation>편의: 지시오차의 평균.</translation>
    </message>
    <message>
        <source>Number of observations, where it is known; gives the degrees of freedom.</source>
        <translation>알려진 경우의 관측 횟수. 자유도를 줍니다.</translation>
    </message>
    <message>
        <source>Coordinates that define the frame</source>
        <translation>좌표계를 정의하는 좌표</translation>
    </message>
    <message>
        <source>Errors of these coordinates are zero by construction of the frame and are left out of the statistics.</source>
        <translation>이 좌표의 오차는 좌표계를 만드는 방식 때문에 0이므로 통계에서 제외합니다.</translation>
    </message>
    <message>
        <source>first point x, y, z; second y, z; third z</source>
        <translation>첫 점 x, y, z; 둘째 점 y, z; 셋째 점 z</translation>
    </message>
    <message>
        <source>as the points&apos; column &apos;defines&apos; says</source>
        <translation>점의 &apos;정의&apos; 열에 적힌 대로</translation>
    </message>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>Systematic error of indication</source>
        <translation>계통 지시오차</translation>
    </message>
    <message>
        <source>What becomes of the mean error b. The paper leaves it uncorrected and counts |b| as a standard uncertainty; JCGM 100 3.2.4 asks for a correction.</source>
        <translation>평균 오차 b의 처리. 논문은 보정하지 않고 |b|를 표준불확도로 셈하며, JCGM 100 3.2.4는 보정을 요구합니다.</translation>
    </message>
    <message>
        <source>counts as a standard uncertainty (paper)</source>
        <translation>표준불확도로 셈함(논문)</translation>
    </message>
    <message>
        <source>ignored</source>
        <translation>무시</translation>
    </message>
    <message>
        <source>corrected, the uncertainty of the correction remains</source>
        <translation>보정함, 보정의 불확도는 남음</translation>
    </message>
    <message>
        <source>Systematic parts are common to all points</source>
        <translation>계통 부분은 모든 점에 공통</translation>
    </message>
    <message>
        <source>Calibration, temperature and bias are drawn once for all points instead of independently for each, as the paper does.</source>
        <translation>교정, 온도, 편의를 논문처럼 점마다 독립으로 추출하지 않고 모든 점에 한 번만 추출합니다.</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>교정</translation>
    </message>
    <message>
        <source>Standard uncertainty of calibration</source>
        <translation>교정의 표준불확도</translation>
    </message>
    <message>
        <source>Largest standard uncertainty of the calibrated values, from the certificate (U divided by its k).</source>
        <translation>성적서에 나온 교정값의 최대 표준불확도(U를 k로 나눈 값).</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>온도</translation>
    </message>
    <message>
        <source>Coefficient of thermal expansion</source>
        <translation>열팽창계수</translation>
    </message>
    <message>
        <source>Linear expansion of the artefact&apos;s material; aluminium has about 23e-6 1/K.</source>
        <translation>기준물 재료의 선팽창계수. 알루미늄은 약 23e-6 1/K입니다.</translation>
    </message>
    <message>
        <source>Temperature of the artefact</source>
        <translation>기준물의 온도</translation>
    </message>
    <message>
        <source>Whether indications are corrected to 20 °C with a measured temperature. If not, the largest deviation from 20 °C is a component of uncertainty.</source>
        <translation>지시값을 측정 온도로 20 °C로 보정하는지 여부. 보정하지 않으면 20 °C로부터의 최대 편차가 불확도 성분이 됩니다.</translation>
    </message>
    <message>
        <source>not corrected</source>
        <translation>보정하지 않음</translation>
    </message>
    <message>
        <source>corrected to 20 °C</source>
        <translation>20 °C로 보정</translation>
    </message>
    <message>
        <source>Largest deviation from 20 °C, or U of the temperature</source>
        <translation>20 °C로부터의 최대 편차, 또는 온도의 U</translation>
    </message>
    <message>
        <source>ΔT of Eqs 3 and 6: without correction the largest absolute deviation from 20 °C, with correction the expanded uncertainty of the measured temperature. Half-width of a rectangular distribution.</source>
        <translation>식 3과 6의 ΔT: 보정하지 않으면 20 °C로부터의 최대 절대 편차, 보정하면 측정 온도의 확장불확도. 직사각형 분포의 반폭입니다.</translation>
    </message>
    <message>
        <source>Measured temperature</source>
        <translation>측정 온도</translation>
    </message>
    <message>
        <source>Temperature of the artefact during the measurement; indications are divided by 1 + α (T − 20 °C).</source>
        <translation>측정 중 기준물의 온도. 지시값을 1 + α (T − 20 °C)로 나눕니다.</translation>
    </message>
    <message>
        <source>Length for the thermal expansion</source>
        <translation>열팽창의 길이</translation>
    </message>
    <message>
        <source>L_max of Eq 3. The paper&apos;s figures result with the largest distance between two points; its text says the largest value of the coordinate, which gives 0 for a flat artefact&apos;s z.</source>
        <translation>식 3의 L_max. 논문의 수치는 두 점 사이의 최대 거리로 얻어집니다. 논문의 본문은 좌표의 최댓값이라고 하며, 이는 평평한 기준물의 z에 0을 줍니다.</translation>
    </message>
    <message>
        <source>largest distance between two points</source>
        <translation>두 점 사이의 최대 거리</translation>
    </message>
    <message>
        <source>largest value of the coordinate (text of Eq 3)</source>
        <translation>좌표의 최댓값(식 3의 본문)</translation>
    </message>
    <message>
        <source>Length standard</source>
        <translation>길이 표준기</translation>
    </message>
    <message>
        <source>Calibrated length</source>
        <translation>교정된 길이</translation>
    </message>
    <message>
        <source>Distance between the two nests, from the certificate. It should be like the largest distance between the points of both frames.</source>
        <translation>성적서에 나온 두 네스트 사이의 거리. 두 좌표계의 점 사이의 최대 거리와 비슷해야 합니다.</translation>
    </message>
    <message>
        <source>Repeated measurements of the artefact, or the components of uncertainty as a report prints them (Table 2 of the paper).</source>
        <translation>기준물의 반복 측정, 또는 보고서에 적힌 불확도 성분(논문의 표 2).</translation>
    </message>
    <message>
        <source>Measured lengths: one row for each position and run, typed or from a CSV file. The paper proposes at least 14 positions of three runs.</source>
        <translation>측정된 길이. 위치와 회차마다 한 행이며, 직접 입력하거나 CSV 파일에서 읽습니다. 논문은 3회씩 최소 14개 위치를 제안합니다.</translation>
    </message>
    <message>
        <source>position</source>
        <translation>위치</translation>
    </message>
    <message>
        <source>Where the standard stood.</source>
        <translation>표준기가 놓인 곳.</translation>
    </message>
    <message>
        <source>Indicated length.</source>
        <translation>지시된 길이.</translation>
    </message>
    <message>
        <source>One row, as Table 2 of the paper prints it.</source>
        <translation>논문의 표 2에 적힌 대로 한 행.</translation>
    </message>
    <message>
        <source>Uncertainty of a coordinate</source>
        <translation>좌표의 불확도</translation>
    </message>
    <message>
        <source>A length is the difference of two points, so u of a length is √2 times u of a coordinate. The paper uses the length&apos;s figure unchanged, which is cautious.</source>
        <translation>길이는 두 점의 차이므로 길이의 u는 좌표의 u의 √2배입니다. 논문은 길이의 수치를 그대로 쓰며, 이는 신중한 쪽입니다.</translation>
    </message>
    <message>
        <source>that of the length (paper)</source>
        <translation>길이의 값(논문)</translation>
    </message>
    <message>
        <source>that of the length divided by √2</source>
        <translation>길이의 값을 √2로 나눔</translation>
    </message>
    <message>
        <source>Tracker, total station, camera or distance meter</source>
        <translation>트래커, 토탈 스테이션, 카메라 또는 거리계</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>스테이션</translation>
    </message>
    <message>
        <source>Where the instrument stands in the world frame: the point where its axes meet. x is the zero of the azimuth (the optical axis of a camera), z the vertical axis.</source>
        <translation>월드 좌표계에서 측정기가 놓인 곳: 축들이 만나는 점. x는 방위각의 영점(카메라의 광축), z는 수직축입니다.</translation>
    </message>
    <message>
        <source>The angles are</source>
        <translation>각의 종류</translation>
    </message>
    <message>
        <source>How the three angles of the station turn its axes.</source>
        <translation>스테이션의 세 각이 축을 회전하는 방식.</translation>
    </message>
    <message>
        <source>α, β, γ: R = Rz(γ) Ry(β) Rx(α)</source>
        <translation>α, β, γ: R = Rz(γ) Ry(β) Rx(α)</translation>
    </message>
    <message>
        <source>ω, φ, κ: R = Rx(ω) Ry(φ) Rz(κ), photogrammetric</source>
        <translation>ω, φ, κ: R = Rx(ω) Ry(φ) Rz(κ), 사진측량</translation>
    </message>
    <message>
        <source>What the instrument reads, and how it is drawn.</source>
        <translation>측정기가 무엇을 읽고 어떻게 그려지는지.</translation>
    </message>
    <message>
        <source>total station: distance and two angles</source>
        <translation>토탈 스테이션: 거리와 두 각</translation>
    </message>
    <message>
        <source>laser tracker: distance and two angles</source>
        <translation>레이저 트래커: 거리와 두 각</translation>
    </message>
    <message>
        <source>laser scanner: distance and two angles</source>
        <translation>레이저 스캐너: 거리와 두 각</translation>
    </message>
    <message>
        <source>camera: two angles</source>
        <translation>카메라: 두 각</translation>
    </message>
    <message>
        <source>distance meter: distance only</source>
        <translation>거리계: 거리만</translation>
    </message>
    <message>
        <source>other: chosen readings</source>
        <translation>기타: 선택한 읽음값</translation>
    </message>
    <message>
        <source>Reads the distance</source>
        <translation>거리를 읽음</translation>
    </message>
    <message>
        <source>Whether the sensor reads a distance.</source>
        <translation>센서가 거리를 읽는지 여부.</translation>
    </message>
    <message>
        <source>Reads the azimuth</source>
        <translation>방위각을 읽음</translation>
    </message>
    <message>
        <source>Whether the sensor reads a horizontal angle.</source>
        <translation>센서가 수평각을 읽는지 여부.</translation>
    </message>
    <message>
        <source>Reads the elevation</source>
        <translation>고도각을 읽음</translation>
    </message>
    <message>
        <source>Whether the sensor reads a vertical angle.</source>
        <translation>센서가 수직각을 읽는지 여부.</translation>
    </message>
    <message>
        <source>Specification</source>
        <translation>사양</translation>
    </message>
    <message>
        <source>Distance: constant part a</source>
        <translation>거리: 상수부 a</translation>
    </message>
    <message>
        <source>Part of the distance&apos;s figure that does not depend on the distance.</source>
        <translation>거리 수치 가운데 거리와 무관한 부분.</translation>
    </message>
    <message>
        <source>Distance: part b per length</source>
        <translation>거리: 길이당 b</translation>
    </message>
    <message>
        <source>Part of the distance&apos;s figure in proportion to the distance.</source>
        <translation>거리 수치 가운데 거리에 비례하는 부분.</translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation>방위각</translation>
    </message>
    <message>
        <source>Figure for the horizontal angle.</source>
        <translation>수평각의 수치.</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>고도각</translation>
    </message>
    <message>
        <source>Figure for the vertical angle.</source>
        <translation>수직각의 수치.</translation>
    </message>
    <message>
        <source>Angles: constant part across</source>
        <translation>각: 시준선에 직각인 상수부</translation>
    </message>
    <message>
        <source>Part of both angles&apos; figures that is a length across the line of sight, as trackers state it (15 µm + 6 µm/m); an angle&apos;s figure is this over the distance plus its own.</source>
        <translation>두 각의 수치 가운데 시준선에 직각인 길이인 부분, 트래커의 표기 방식(15 µm + 6 µm/m). 각의 수치는 이것을 거리로 나눈 값에 각 자체의 값을 더한 것입니다.</translation>
    </message>
    <message>
        <source>The figures are</source>
        <translation>수치의 종류</translation>
    </message>
    <message>
        <source>What the data sheet states: a standard uncertainty, an expanded one, or a limit that is not exceeded (maximum permissible error).</source>
        <translation>사양서가 제시하는 것: 표준불확도, 확장불확도, 또는 넘지 않는 한계(최대허용오차).</translation>
    </message>
    <message>
        <source>standard uncertainty (normal)</source>
        <translation>표준불확도(정규)</translation>
    </message>
    <message>
        <source>expanded uncertainty, k = 2 (normal)</source>
        <translation>확장불확도, k = 2(정규)</translation>
    </message>
    <message>
        <source>limit (MPE), rectangular: divided by √3</source>
        <translation>한계(MPE), 직사각형: √3으로 나눔</translation>
    </message>
    <message>
        <source>limit (MPE), triangular: divided by √6</source>
        <translation>한계(MPE), 삼각형: √6으로 나눔</translation>
    </message>
    <message>
        <source>limit (MPE), arc sine: divided by √2</source>
        <translation>한계(MPE), 아크사인: √2로 나눔</translation>
    </message>
    <message>
        <source>Range and field of view</source>
        <translation>범위와 시야</translation>
    </message>
    <message>
        <source>Shortest distance</source>
        <translation>최단 거리</translation>
    </message>
    <message>
        <source>Targets nearer than this are not measured.</source>
        <translation>이보다 가까운 표적은 측정하지 않습니다.</translation>
    </message>
    <message>
        <source>Longest distance</source>
        <translation>최장 거리</translation>
    </message>
    <message>
        <source>Targets farther than this are not measured; empty: no limit.</source>
        <translation>이보다 먼 표적은 측정하지 않습니다. 비어 있으면 한계 없음.</translation>
    </message>
    <message>
        <source>Horizontal field of view</source>
        <translation>수평 시야</translation>
    </message>
    <message>
        <source>Full angle, half of it to either side of the sensor&apos;s x-axis; empty: all round.</source>
        <translation>전체 각, 센서의 x축 양쪽으로 절반씩. 비어 있으면 전 둘레.</translation>
    </message>
    <message>
        <source>Vertical field of view</source>
        <translation>수직 시야</translation>
    </message>
    <message>
        <source>Full angle, half of it above the sensor&apos;s xy-plane and half below; empty: no limit.</source>
        <translation>전체 각, 센서의 xy 평면 위와 아래로 절반씩. 비어 있으면 한계 없음.</translation>
    </message>
    <message>
        <source>Shared by all readings</source>
        <translation>모든 읽음값의 공통 요인</translation>
    </message>
    <message>
        <source>Scale of distances</source>
        <translation>거리의 스케일</translation>
    </message>
    <message>
        <source>Standard uncertainty of the scale, which all distances share: wavelength, refractive index, temperature of a scale.</source>
        <translation>모든 거리가 공유하는 스케일의 표준불확도: 파장, 굴절률, 스케일의 온도.</translation>
    </message>
    <message>
        <source>Zero offset of distances</source>
        <translation>거리의 영점 오프셋</translation>
    </message>
    <message>
        <source>Standard uncertainty of the constant offset of all distances: home position, reflector.</source>
        <translation>모든 거리의 일정한 오프셋의 표준불확도: 홈 위치, 반사경.</translation>
    </message>
    <message>
        <source>Index of the elevation</source>
        <translation>고도각의 영점</translation>
    </message>
    <message>
        <source>Standard uncertainty of the zero of the vertical circle.</source>
        <translation>수직 눈금판 영점의 표준불확도.</translation>
    </message>
    <message>
        <source>Collimation</source>
        <translation>시준</translation>
    </message>
    <message>
        <source>Standard uncertainty of the angle between beam and tilting axis off square: the azimuth changes by it over the cosine of the elevation.</source>
        <translation>빔과 수평축 사이 각의 직각에서 벗어난 양의 표준불확도. 방위각은 이것을 고도각의 코사인으로 나눈 만큼 변합니다.</translation>
    </message>
    <message>
        <source>Squareness of the axes</source>
        <translation>축의 직각도</translation>
    </message>
    <message>
        <source>Standard uncertainty of the angle between the two axes off square: the azimuth changes by it times the tangent of the elevation.</source>
        <translation>두 축 사이 각의 직각에서 벗어난 양의 표준불확도. 방위각은 이것에 고도각의 탄젠트를 곱한 만큼 변합니다.</translation>
    </message>
    <message>
        <source>Offset of the beam</source>
        <translation>빔의 오프셋</translation>
    </message>
    <message>
        <source>Standard uncertainty of the distance by which the beam misses the vertical axis sideways: the azimuth changes by it over the horizontal distance.</source>
        <translation>빔이 수직축에서 옆으로 벗어난 거리의 표준불확도. 방위각은 이것을 수평 거리로 나눈 만큼 변합니다.</translation>
    </message>
    <message>
        <source>Coefficient of refraction</source>
        <translation>굴절계수</translation>
    </message>
    <message>
        <source>Standard uncertainty of k: the elevation changes by k L/(2 × 6371 km) over a distance L.</source>
        <translation>k의 표준불확도. 거리 L에서 고도각은 k L/(2 × 6371 km)만큼 변합니다.</translation>
    </message>
    <message>
        <source>The distribution of what all readings share; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation>모든 읽음값이 공유하는 것의 분포. 형태와 관계없이 제시된 값은 표준불확도입니다.</translation>
    </message>
    <message>
        <source>Uncertainty of the station</source>
        <translation>스테이션의 불확도</translation>
    </message>
    <message>
        <source>position x</source>
        <translation>위치 x</translation>
    </message>
    <message>
        <source>Standard uncertainty of this coordinate of the station, shared by everything measured from it.</source>
        <translation>스테이션의 이 좌표의 표준불확도. 여기서 측정된 모든 것이 공유합니다.</translation>
    </message>
    <message>
        <source>position y</source>
        <translation>위치 y</translation>
    </message>
    <message>
        <source>position z</source>
        <translation>위치 z</translation>
    </message>
    <message>
        <source>rotation about x</source>
        <translation>x축 둘레 회전</translation>
    </message>
    <message>
        <source>rotation about y</source>
        <translation>y축 둘레 회전</translation>
    </message>
    <message>
        <source>rotation about z</source>
        <translation>z축 둘레 회전</translation>
    </message>
    <message>
        <source>The distribution of the coordinates of the station; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation>스테이션 좌표의 분포. 형태와 관계없이 제시된 값은 표준불확도입니다.</translation>
    </message>
    <message>
        <source>Correlation of the station&apos;s coordinates</source>
        <translation>스테이션 좌표의 상관</translation>
    </message>
    <message>
        <source>Correlation coefficients from the adjustment that located the station; pairs left out are uncorrelated.</source>
        <translation>스테이션의 위치를 구한 조정에서 나온 상관계수. 적지 않은 쌍은 상관이 없습니다.</translation>
    </message>
    <message>
        <source>first</source>
        <translation>첫째</translation>
    </message>
    <message>
        <source>A coordinate of the station.</source>
        <translation>스테이션의 좌표.</translation>
    </message>
    <message>
        <source>second</source>
        <translation>둘째</translation>
    </message>
    <message>
        <source>Correlation coefficient.</source>
        <translation>상관계수.</translation>
    </message>
    <message>
        <source>Network of sensors</source>
        <translation>센서망</translation>
    </message>
    <message>
        <source>What the weights of the readings account for. With the stations, all points of one analysis are estimated together.</source>
        <translation>읽음값의 가중치가 고려하는 것. 스테이션을 포함하면 한 분석의 모든 점을 함께 추정합니다.</translation>
    </message>
    <message>
        <source>readings and stations, all points at once</source>
        <translation>읽음값과 스테이션, 모든 점을 동시에</translation>
    </message>
    <message>
        <source>readings alone, each point by itself</source>
        <translation>읽음값만, 점마다 따로</translation>
    </message>
    <message>
        <source>Specification of a measured point</source>
        <translation>측정점의 사양</translation>
    </message>
    <message>
        <source>Figure of the data sheet</source>
        <translation>사양서의 수치</translation>
    </message>
    <message>
        <source>The uncertainty or limit that the manufacturer states, the same for x, y and z.</source>
        <translation>제조사가 제시하는 불확도나 한계, x, y, z에 동일합니다.</translation>
    </message>
    <message>
        <source>The figure applies to</source>
        <translation>수치의 적용 대상</translation>
    </message>
    <message>
        <source>A coordinate of a point, or a length between two points; a length is the difference of two points, so a coordinate has 1/√2 of it.</source>
        <translation>점의 좌표, 또는 두 점 사이의 길이. 길이는 두 점의 차이므로 좌표는 그 1/√2입니다.</translation>
    </message>
    <message>
        <source>a coordinate</source>
        <translation>좌표</translation>
    </message>
    <message>
        <source>a length between two points</source>
        <translation>두 점 사이의 길이</translation>
    </message>
    <message>
        <source>Telescopic ballbars (multilateration)</source>
        <translation>텔레스코픽 볼바(다변측량)</translation>
    </message>
    <message>
        <source>Supports</source>
        <translation>지지점</translation>
    </message>
    <message>
        <source>Support 1 to support 2</source>
        <translation>지지점 1 - 지지점 2</translation>
    </message>
    <message>
        <source>Measured length between supports 1 and 2.</source>
        <translation>지지점 1과 2 사이의 측정된 길이.</translation>
    </message>
    <message>
        <source>Support 1 to support 3</source>
        <translation>지지점 1 - 지지점 3</translation>
    </message>
    <message>
        <source>Measured length between supports 1 and 3.</source>
        <translation>지지점 1과 3 사이의 측정된 길이.</translation>
    </message>
    <message>
        <source>Support 2 to support 3</source>
        <translation>지지점 2 - 지지점 3</translation>
    </message>
    <message>
        <source>Measured length between supports 2 and 3.</source>
        <translation>지지점 2와 3 사이의 측정된 길이.</translation>
    </message>
    <message>
        <source>Further supports</source>
        <translation>추가 지지점</translation>
    </message>
    <message>
        <source>Supports 4, 5 ...: their lengths to the first three, and their height above the plane of these. More than three lengths are adjusted by least squares.</source>
        <translation>지지점 4, 5 ...: 처음 세 지지점까지의 길이와 그 평면 위의 높이. 길이가 셋보다 많으면 최소제곱으로 조정합니다.</translation>
    </message>
    <message>
        <source>Length to this support.</source>
        <translation>이 지지점까지의 길이.</translation>
    </message>
    <message>
        <source>Height above the first three supports.</source>
        <translation>처음 세 지지점 위의 높이.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the height.</source>
        <translation>높이의 표준불확도.</translation>
    </message>
    <message>
        <source>The ball is</source>
        <translation>볼의 위치</translation>
    </message>
    <message>
        <source>Three lengths meet in two points, mirror images in the plane of the supports: on which side of it the ball is (sign of the root of Eq 3).</source>
        <translation>세 길이는 지지점 평면에 대해 대칭인 두 점에서 만납니다. 볼이 그 평면의 어느 쪽에 있는지(식 3의 근의 부호).</translation>
    </message>
    <message>
        <source>on the side of +z</source>
        <translation>+z 쪽</translation>
    </message>
    <message>
        <source>on the side of −z</source>
        <translation>−z 쪽</translation>
    </message>
    <message>
        <source>Placement</source>
        <translation>배치</translation>
    </message>
    <message>
        <source>Place in the robot&apos;s frame</source>
        <translation>로봇 좌표계에서의 위치</translation>
    </message>
    <message>
        <source>Where the instrument&apos;s frame is in the robot&apos;s: origin in support 1, x towards support 2, z normal to the plane of the first three supports, on the left of the way 1-2-3.</source>
        <translation>로봇 좌표계에서 측정기 좌표계가 있는 곳: 원점은 지지점 1, x는 지지점 2를 향하고, z는 처음 세 지지점의 평면에 수직이며 1-2-3 경로의 왼쪽입니다.</translation>
    </message>
    <message>
        <source>Uncertainty of a length</source>
        <translation>길이의 불확도</translation>
    </message>
    <message>
        <source>To the ball: constant part a</source>
        <translation>볼까지: 상수부 a</translation>
    </message>
    <message>
        <source>Figure for one reading of a bar to the ball, the part that does not depend on the length.</source>
        <translation>볼까지의 바 읽음값 하나의 수치 가운데 길이와 무관한 부분.</translation>
    </message>
    <message>
        <source>To the ball: part b per length</source>
        <translation>볼까지: 길이당 b</translation>
    </message>
    <message>
        <source>Figure for one reading of a bar to the ball, the part in proportion to the length.</source>
        <translation>볼까지의 바 읽음값 하나의 수치 가운데 길이에 비례하는 부분.</translation>
    </message>
    <message>
        <source>Between supports: constant part a</source>
        <translation>지지점 사이: 상수부 a</translation>
    </message>
    <message>
        <source>Figure for a length between two supports, which one measurement gives for all points: the part that does not depend on the length.</source>
        <translation>한 번의 측정으로 모든 점에 주어지는 두 지지점 사이 길이의 수치 가운데 길이와 무관한 부분.</translation>
    </message>
    <message>
        <source>Between supports: part b per length</source>
        <translation>지지점 사이: 길이당 b</translation>
    </message>
    <message>
        <source>Figure for a length between two supports, the part in proportion to the length.</source>
        <translation>두 지지점 사이 길이의 수치 가운데 길이에 비례하는 부분.</translation>
    </message>
    <message>
        <source>Shared by all lengths</source>
        <translation>모든 길이의 공통 요인</translation>
    </message>
    <message>
        <source>Scale of all lengths</source>
        <translation>모든 길이의 스케일</translation>
    </message>
    <message>
        <source>Standard uncertainty of the scale that all lengths share: wavelength, refractive index.</source>
        <translation>모든 길이가 공유하는 스케일의 표준불확도: 파장, 굴절률.</translation>
    </message>
    <message>
        <source>Constant of each bar</source>
        <translation>각 바의 상수</translation>
    </message>
    <message>
        <source>Standard uncertainty of the constant of a bar, the same in all its readings to the ball.</source>
        <translation>바의 상수의 표준불확도. 볼까지의 모든 읽음값에서 동일합니다.</translation>
    </message>
    <message>
        <source>The distribution of scale and constants; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation>스케일과 상수의 분포. 형태와 관계없이 제시된 값은 표준불확도입니다.</translation>
    </message>
    <message>
        <source>Robot: repeatability of a pose</source>
        <translation>로봇: 포즈 반복성</translation>
    </message>
    <message>
        <source>Positioning</source>
        <translation>위치결정</translation>
    </message>
    <message>
        <source>The robot&apos;s figure for the scatter of a position that it is sent to again and again.</source>
        <translation>로봇을 같은 위치로 거듭 보낼 때의 산포에 대한 로봇의 수치.</translation>
    </message>
    <message>
        <source>The figure is</source>
        <translation>수치의 종류</translation>
    </message>
    <message>
        <source>A largest distance from the mean position, or RP of ISO 9283: the mean distance plus three times its standard deviation. A normal law has no largest distance, so its figure is always RP.</source>
        <translation>평균 위치로부터의 최대 거리, 또는 ISO 9283의 RP, 즉 평균 거리에 그 표준편차의 세 배를 더한 값. 정규분포에는 최대 거리가 없으므로 그 수치는 항상 RP입니다.</translation>
    </message>
    <message>
        <source>the largest distance r</source>
        <translation>최대 거리 r</translation>
    </message>
    <message>
        <source>RP of ISO 9283: mean + 3 s</source>
        <translation>ISO 9283의 RP: 평균 + 3 s</translation>
    </message>
    <message>
        <source>Deviation of a position</source>
        <translation>위치의 편차</translation>
    </message>
    <message>
        <source>How the distance from the mean position is distributed; all directions are equally probable.</source>
        <translation>평균 위치로부터의 거리의 분포. 모든 방향의 확률이 같습니다.</translation>
    </message>
    <message>
        <source>rectangular in [0, r] in a random direction</source>
        <translation>임의의 방향으로 [0, r]의 직사각형</translation>
    </message>
    <message>
        <source>anywhere in a ball of radius r</source>
        <translation>반지름 r인 구 안 어디든</translation>
    </message>
    <message>
        <source>always r, in a random direction</source>
        <translation>항상 r, 임의의 방향으로</translation>
    </message>
    <message>
        <source>normal along each axis</source>
        <translation>각 축을 따라 정규</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>자세</translation>
    </message>
    <message>
        <source>Figure for the scatter of the orientation about each axis of the flange; 0: none.</source>
        <translation>플랜지의 각 축 둘레 자세의 산포에 대한 수치. 0: 없음.</translation>
    </message>
    <message>
        <source>The angle is</source>
        <translation>각의 수치</translation>
    </message>
    <message>
        <source>A standard uncertainty, RP of ISO 9283 for an angle (three times its standard deviation), or a limit that is not exceeded.</source>
        <translation>표준불확도, 각에 대한 ISO 9283의 RP(표준편차의 세 배), 또는 넘지 않는 한계.</translation>
    </message>
    <message>
        <source>RP of ISO 9283: ± 3 s (normal)</source>
        <translation>ISO 9283의 RP: ± 3 s(정규)</translation>
    </message>
    <message>
        <source>limit, rectangular: divided by √3</source>
        <translation>한계, 직사각형: √3으로 나눔</translation>
    </message>
    <message>
        <source>Serial robot</source>
        <translation>직렬 로봇</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>기하</translation>
    </message>
    <message>
        <source>Convention</source>
        <translation>규약</translation>
    </message>
    <message>
        <source>How the parameters of a row lead from one joint&apos;s frame to the next.</source>
        <translation>행의 매개변수가 한 관절의 좌표계에서 다음 좌표계로 이어지는 방식.</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>관절</translation>
    </message>
    <message>
        <source>One row for each joint from the base to the tool, in the chosen convention.</source>
        <translation>선택한 규약에 따라 베이스에서 공구까지 관절마다 한 행.</translation>
    </message>
    <message>
        <source>Joint angle where the reading is the zero reading.</source>
        <translation>읽음값이 영점 읽음값일 때의 관절 각.</translation>
    </message>
    <message>
        <source>Offset along the joint&apos;s axis.</source>
        <translation>관절 축을 따른 오프셋.</translation>
    </message>
    <message>
        <source>Length of the common perpendicular.</source>
        <translation>공통 수선의 길이.</translation>
    </message>
    <message>
        <source>Twist about x between two axes.</source>
        <translation>두 축 사이의 x 둘레 비틀림.</translation>
    </message>
    <message>
        <source>Twist about y, of a joint whose axis is parallel to the next: d is then 0 by definition. Empty: the axes are not parallel.</source>
        <translation>축이 다음 축과 평행한 관절의 y 둘레 비틀림. 이때 d는 정의에 따라 0입니다. 비어 있으면 축이 평행하지 않습니다.</translation>
    </message>
    <message>
        <source>Reading of the joint at which theta holds; empty: 0.</source>
        <translation>theta가 성립하는 관절의 읽음값. 비어 있으면 0.</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>방향</translation>
    </message>
    <message>
        <source>Whether the joint angle grows or falls with the reading; empty: grows.</source>
        <translation>읽음값에 따라 관절 각이 커지는지 작아지는지. 비어 있으면 커집니다.</translation>
    </message>
    <message>
        <source>with the reading</source>
        <translation>읽음값과 같은 방향</translation>
    </message>
    <message>
        <source>against the reading</source>
        <translation>읽음값과 반대 방향</translation>
    </message>
    <message>
        <source>Lowest reading; empty: no limit.</source>
        <translation>최소 읽음값. 비어 있으면 한계 없음.</translation>
    </message>
    <message>
        <source>Highest reading; empty: no limit.</source>
        <translation>최대 읽음값. 비어 있으면 한계 없음.</translation>
    </message>
    <message>
        <source>Standard uncertainty of a reading by the joint&apos;s encoder, drawn anew at each pose.</source>
        <translation>관절 엔코더 읽음값의 표준불확도, 포즈마다 새로 추출합니다.</translation>
    </message>
    <message>
        <source>Standard uncertainty by which the joint comes back to a reading, drawn anew at each pose.</source>
        <translation>관절이 읽음값으로 되돌아오는 표준불확도, 포즈마다 새로 추출합니다.</translation>
    </message>
    <message>
        <source>type</source>
        <translation>유형</translation>
    </message>
    <message>
        <source>A joint that turns has readings q, which add to theta; one that slides has readings s, which add to d. Empty: it turns.</source>
        <translation>회전 관절의 읽음값 q는 theta에 더해지고, 직선 관절의 읽음값 s는 d에 더해집니다. 비어 있으면 회전합니다.</translation>
    </message>
    <message>
        <source>turns about its axis</source>
        <translation>축 둘레로 회전</translation>
    </message>
    <message>
        <source>slides along its axis</source>
        <translation>축을 따라 직선 이동</translation>
    </message>
    <message>
        <source>Reading of a sliding joint at which d holds; empty: 0.</source>
        <translation>d가 성립하는 직선 관절의 읽음값. 비어 있으면 0.</translation>
    </message>
    <message>
        <source>Lowest reading of a sliding joint; empty: no limit.</source>
        <translation>직선 관절의 최소 읽음값. 비어 있으면 한계 없음.</translation>
    </message>
    <message>
        <source>Highest reading of a sliding joint; empty: no limit.</source>
        <translation>직선 관절의 최대 읽음값. 비어 있으면 한계 없음.</translation>
    </message>
    <message>
        <source>Standard uncertainty of a reading of a sliding joint by its scale, drawn anew at each pose.</source>
        <translation>직선 관절 스케일 읽음값의 표준불확도, 포즈마다 새로 추출합니다.</translation>
    </message>
    <message>
        <source>Standard uncertainty by which a sliding joint comes back to a reading, drawn anew at each pose.</source>
        <translation>직선 관절이 읽음값으로 되돌아오는 표준불확도, 포즈마다 새로 추출합니다.</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>베이스</translation>
    </message>
    <message>
        <source>Where frame 0 of the robot stands in the world.</source>
        <translation>월드에서 로봇의 좌표계 0이 놓인 곳.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>공구</translation>
    </message>
    <message>
        <source>Where the tool is in the frame of the last link.</source>
        <translation>마지막 링크의 좌표계에서 공구가 있는 곳.</translation>
    </message>
    <message>
        <source>Standard uncertainties of the parameters by source. A row for a joint and a source; components of one parameter combine in quadrature.</source>
        <translation>출처별 매개변수의 표준불확도. 관절과 출처마다 한 행이며, 한 매개변수의 성분은 제곱합의 제곱근으로 합성합니다.</translation>
    </message>
    <message>
        <source>Where the figures come from: repeatability, sampling, range, certificate ...</source>
        <translation>수치가 나온 곳: 반복성, 표본추출, 범위, 성적서 ...</translation>
    </message>
    <message>
        <source>Number of the joint; empty: all joints, each with a deviation of its own.</source>
        <translation>관절의 번호. 비어 있으면 모든 관절, 각각 자체의 편차를 가집니다.</translation>
    </message>
    <message>
        <source>Standard uncertainty of theta from this source; empty: none.</source>
        <translation>이 출처에서 나온 theta의 표준불확도. 비어 있으면 없음.</translation>
    </message>
    <message>
        <source>Standard uncertainty of d from this source; empty: none.</source>
        <translation>이 출처에서 나온 d의 표준불확도. 비어 있으면 없음.</translation>
    </message>
    <message>
        <source>Standard uncertainty of a from this source; empty: none.</source>
        <translation>이 출처에서 나온 a의 표준불확도. 비어 있으면 없음.</translation>
    </message>
    <message>
        <source>Standard uncertainty of alpha from this source; empty: none.</source>
        <translation>이 출처에서 나온 alpha의 표준불확도. 비어 있으면 없음.</translation>
    </message>
    <message>
        <source>Standard uncertainty of beta from this source; empty: none.</source>
        <translation>이 출처에서 나온 beta의 표준불확도. 비어 있으면 없음.</translation>
    </message>
    <message>
        <source>Degrees of freedom of the figures; empty: infinitely many.</source>
        <translation>수치의 자유도. 비어 있으면 무한대.</translation>
    </message>
    <message>
        <source>Form of the distribution with this standard uncertainty; empty: normal.</source>
        <translation>이 표준불확도를 갖는 분포의 형태. 비어 있으면 정규.</translation>
    </message>
    <message>
        <source>Correlation coefficients from the identification; pairs left out are uncorrelated. A correlated parameter has one component.</source>
        <translation>식별에서 나온 상관계수. 적지 않은 쌍은 상관이 없습니다. 상관된 매개변수는 성분이 하나입니다.</translation>
    </message>
    <message>
        <source>Tool, position</source>
        <translation>공구, 위치</translation>
    </message>
    <message>
        <source>Standard uncertainty of each coordinate of the tool in the frame of the last link.</source>
        <translation>마지막 링크의 좌표계에서 공구의 각 좌표의 표준불확도.</translation>
    </message>
    <message>
        <source>Tool, orientation</source>
        <translation>공구, 자세</translation>
    </message>
    <message>
        <source>Standard uncertainty of each rotation of the tool about its own axes.</source>
        <translation>공구의 자체 축 둘레 각 회전의 표준불확도.</translation>
    </message>
    <message>
        <source>Force/moment calibration machine</source>
        <translation>힘/모멘트 교정기</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>성적서</translation>
    </message>
    <message>
        <source>Uncertainty of its loads</source>
        <translation>하중의 불확도</translation>
    </message>
    <message>
        <source>One row for each axis that the machine loads: the relative expanded uncertainty of its certificate and the coverage factor.</source>
        <translation>교정기가 하중을 가하는 축마다 한 행: 성적서의 상대확장불확도와 포함인자.</translation>
    </message>
    <message>
        <source>Force or moment.</source>
        <translation>힘 또는 모멘트.</translation>
    </message>
    <message>
        <source>Relative expanded uncertainty of the load: a ratio, not %.</source>
        <translation>하중의 상대확장불확도: %가 아닌 비율.</translation>
    </message>
    <message>
        <source>Coverage factor; empty: 2.</source>
        <translation>포함인자. 비어 있으면 2.</translation>
    </message>
    <message>
        <source>Multi-axis force/moment sensor</source>
        <translation>다축 힘/모멘트 센서</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>채널</translation>
    </message>
    <message>
        <source>The forces and moments that the sensor measures, with their rated loads.</source>
        <translation>센서가 측정하는 힘과 모멘트, 그 정격하중.</translation>
    </message>
    <message>
        <source>Force or moment that the channel measures.</source>
        <translation>채널이 측정하는 힘 또는 모멘트.</translation>
    </message>
    <message>
        <source>rated force</source>
        <translation>정격힘</translation>
    </message>
    <message>
        <source>Rated load of Fx, Fy or Fz.</source>
        <translation>Fx, Fy 또는 Fz의 정격하중.</translation>
    </message>
    <message>
        <source>rated moment</source>
        <translation>정격모멘트</translation>
    </message>
    <message>
        <source>Rated load of Mx, My or Mz.</source>
        <translation>Mx, My 또는 Mz의 정격하중.</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>위치</translation>
    </message>
    <message>
        <source>Where the sensor&apos;s axes are; loads are along and about them.</source>
        <translation>센서의 축이 있는 곳. 하중은 이 축을 따라, 그리고 그 둘레로 작용합니다.</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>지름</translation>
    </message>
    <message>
        <source>Of its housing, for the picture.</source>
        <translation>하우징의 지름, 그림용.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>높이</translation>
    </message>
    <message>
        <source>Indicator</source>
        <translation>지시계</translation>
    </message>
    <message>
        <source>Resolution of the indicator</source>
        <translation>지시계의 분해능</translation>
    </message>
    <message>
        <source>Smallest step of the indicated value, r of Eq 6.</source>
        <translation>지시값의 최소 간격, 식 6의 r.</translation>
    </message>
    <message>
        <source>Range of the indicator</source>
        <translation>지시계의 범위</translation>
    </message>
    <message>
        <source>Largest value that it can indicate; a reading there is refused as saturated. Empty: only readings that stand still while the load rises are.</source>
        <translation>지시할 수 있는 최댓값. 여기에 이른 읽음값은 포화로 보고 거부합니다. 비어 있으면 하중이 커지는데 멈춰 있는 읽음값만 거부합니다.</translation>
    </message>
    <message>
        <source>Calibration machine</source>
        <translation>교정기</translation>
    </message>
    <message>
        <source>What loaded the sensor; its relative uncertainty enters by Eq 5.</source>
        <translation>센서에 하중을 가한 것. 그 상대불확도는 식 5로 들어갑니다.</translation>
    </message>
    <message>
        <source>Raw readings, from which everything follows, or what an evaluation states.</source>
        <translation>모든 것을 계산할 수 있는 원시 읽음값, 또는 평가에서 제시한 값.</translation>
    </message>
    <message>
        <source>raw readings</source>
        <translation>원시 읽음값</translation>
    </message>
    <message>
        <source>summary tables</source>
        <translation>요약표</translation>
    </message>
    <message>
        <source>Indicated values of all channels at each step, the unloaded value not subtracted; typed or from a CSV file, whose columns may have other names.</source>
        <translation>각 단계에서 모든 채널의 지시값, 무하중 값을 빼지 않은 것. 직접 입력하거나 CSV 파일에서 읽으며, 파일의 열 이름은 달라도 됩니다.</translation>
    </message>
    <message>
        <source>Axis on which the machine&apos;s load acts.</source>
        <translation>교정기의 하중이 작용하는 축.</translation>
    </message>
    <message>
        <source>Preloading or calibration.</source>
        <translation>예비하중 또는 교정.</translation>
    </message>
    <message>
        <source>preload</source>
        <translation>예비하중</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>교정</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>구간</translation>
    </message>
    <message>
        <source>Unloaded before, preload, increasing or decreasing load, unloaded after.</source>
        <translation>사전 무하중, 예비하중, 증가 또는 감소 하중, 사후 무하중.</translation>
    </message>
    <message>
        <source>zero before</source>
        <translation>사전 영점</translation>
    </message>
    <message>
        <source>load</source>
        <translation>하중</translation>
    </message>
    <message>
        <source>increasing</source>
        <translation>증가</translation>
    </message>
    <message>
        <source>decreasing</source>
        <translation>감소</translation>
    </message>
    <message>
        <source>zero after</source>
        <translation>사후 영점</translation>
    </message>
    <message>
        <source>step</source>
        <translation>단계</translation>
    </message>
    <message>
        <source>Number of the step: 0 without load, the same number for increasing and decreasing load.</source>
        <translation>단계의 번호: 하중이 없으면 0, 증가와 감소 하중은 같은 번호.</translation>
    </message>
    <message>
        <source>Load in the unit of the next column.</source>
        <translation>다음 열의 단위로 나타낸 하중.</translation>
    </message>
    <message>
        <source>load unit</source>
        <translation>하중 단위</translation>
    </message>
    <message>
        <source>N, kN, Nm ...; empty: N for forces and N·m for moments.</source>
        <translation>N, kN, Nm ...; 비어 있으면 힘은 N, 모멘트는 N·m.</translation>
    </message>
    <message>
        <source>Time of the reading.</source>
        <translation>읽은 시각.</translation>
    </message>
    <message>
        <source>Indicated value of this channel.</source>
        <translation>이 채널의 지시값.</translation>
    </message>
    <message>
        <source>Summary</source>
        <translation>요약</translation>
    </message>
    <message>
        <source>What an evaluation states of each channel, like Tables 1 and 3 of the paper.</source>
        <translation>논문의 표 1과 3처럼, 각 채널에 대해 평가에서 제시한 것.</translation>
    </message>
    <message>
        <source>Channel.</source>
        <translation>채널.</translation>
    </message>
    <message>
        <source>rated output</source>
        <translation>정격출력</translation>
    </message>
    <message>
        <source>Mean net reading at the rated load.</source>
        <translation>정격하중에서의 평균 순 읽음값.</translation>
    </message>
    <message>
        <source>non-zero error</source>
        <translation>영점 오차</translation>
    </message>
    <message>
        <source>Non-zero error: change of the unloaded reading over a series.</source>
        <translation>영점 오차: 한 계열 동안 무하중 읽음값의 변화.</translation>
    </message>
    <message>
        <source>Type A standard uncertainty of the mean, the largest of all steps.</source>
        <translation>평균의 A형 표준불확도, 모든 단계 중 최댓값.</translation>
    </message>
    <message>
        <source>hysteresis</source>
        <translation>히스테리시스</translation>
    </message>
    <message>
        <source>Largest difference between increasing and decreasing load.</source>
        <translation>증가와 감소 하중 사이의 최대 차이.</translation>
    </message>
    <message>
        <source>Type B standard uncertainty as stated; empty: from the machine, the resolution and the non-zero error (Eq 8).</source>
        <translation>제시된 B형 표준불확도. 비어 있으면 교정기, 분해능, 영점 오차에서(식 8).</translation>
    </message>
    <message>
        <source>Interference</source>
        <translation>간섭</translation>
    </message>
    <message>
        <source>Outputs at rated loads on other axes, like Table 2 of the paper; which index is the load is chosen below.</source>
        <translation>논문의 표 2처럼, 다른 축의 정격하중에서의 출력. 어느 첨자가 하중인지는 아래에서 선택합니다.</translation>
    </message>
    <message>
        <source>Row of the table.</source>
        <translation>표의 행.</translation>
    </message>
    <message>
        <source>Column of the table; empty on the diagonal.</source>
        <translation>표의 열. 대각선에서는 비어 있음.</translation>
    </message>
    <message>
        <source>Interference has signs</source>
        <translation>간섭에 부호가 있음</translation>
    </message>
    <message>
        <source>Whether the signs are printed. Without them interference cannot be compensated.</source>
        <translation>부호가 적혀 있는지 여부. 부호가 없으면 간섭을 보상할 수 없습니다.</translation>
    </message>
    <message>
        <source>Calibration plan</source>
        <translation>교정 계획</translation>
    </message>
    <message>
        <source>Preloads</source>
        <translation>예비하중</translation>
    </message>
    <message>
        <source>How often each axis is loaded to its rated load before.</source>
        <translation>사전에 각 축을 정격하중까지 가하는 횟수.</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>회차</translation>
    </message>
    <message>
        <source>Calibration series of each axis: n of Eqs 2 to 4.</source>
        <translation>각 축의 교정 계열 수: 식 2부터 4까지의 n.</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>단계</translation>
    </message>
    <message>
        <source>Loads of a series up to the rated load; the paper asks for five or more.</source>
        <translation>정격하중까지 한 계열의 하중. 논문은 다섯 개 이상을 요구합니다.</translation>
    </message>
    <message>
        <source>Decreasing loads too</source>
        <translation>감소 하중 포함</translation>
    </message>
    <message>
        <source>Whether each series goes down again; hysteresis needs it.</source>
        <translation>각 계열이 다시 내려오는지 여부. 히스테리시스에 필요합니다.</translation>
    </message>
    <message>
        <source>Without load before a series</source>
        <translation>계열 전의 무하중 시간</translation>
    </message>
    <message>
        <source>Before each series, Fig. 2.</source>
        <translation>각 계열 전, 그림 2.</translation>
    </message>
    <message>
        <source>At each load</source>
        <translation>각 하중에서의 시간</translation>
    </message>
    <message>
        <source>Before a reading is taken, Fig. 2.</source>
        <translation>읽기 전, 그림 2.</translation>
    </message>
    <message>
        <source>Evaluation by the paper</source>
        <translation>논문에 의한 평가</translation>
    </message>
    <message>
        <source>Coverage factor k of Eq 12</source>
        <translation>식 12의 포함인자 k</translation>
    </message>
    <message>
        <source>The paper takes 2.</source>
        <translation>논문은 2를 씁니다.</translation>
    </message>
    <message>
        <source>A row of the interference table is</source>
        <translation>간섭 표의 행의 의미</translation>
    </message>
    <message>
        <source>Section 2.5 says e_12 is the output of Fy under Fx (row = load), but divides by the rated output of the row and calls the row&apos;s largest the error of that sensor. Raw readings leave no doubt; for a printed table the choice changes U.</source>
        <translation>2.5절은 e_12를 Fx에 의한 Fy의 출력이라 하지만(행 = 하중), 행의 정격출력으로 나누고 행의 최댓값을 그 센서의 오차라 합니다. 원시 읽음값에는 의문이 없지만, 인쇄된 표에서는 이 선택에 따라 U가 달라집니다.</translation>
    </message>
    <message>
        <source>a sensor: its outputs under the other loads</source>
        <translation>센서: 다른 하중에 의한 그 출력</translation>
    </message>
    <message>
        <source>a load: the outputs of the other sensors under it</source>
        <translation>하중: 그 하중에 의한 다른 센서의 출력</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>비교</translation>
    </message>
    <message>
        <source>Stated values</source>
        <translation>제시된 값</translation>
    </message>
    <message>
        <source>Values that a certificate or a paper prints, to be compared with those computed.</source>
        <translation>계산한 값과 비교할, 성적서나 논문에 적힌 값.</translation>
    </message>
    <message>
        <source>As printed, in mV/V; empty: not compared.</source>
        <translation>인쇄된 대로, mV/V 단위. 비어 있으면 비교하지 않음.</translation>
    </message>
    <message>
        <source>interference</source>
        <translation>간섭</translation>
    </message>
    <message>
        <source>U, relative</source>
        <translation>U, 상대</translation>
    </message>
    <message>
        <source>Relative expanded uncertainty of Eq 12b.</source>
        <translation>식 12b의 상대확장불확도.</translation>
    </message>
    <message>
        <source>U, as a load</source>
        <translation>U, 하중으로</translation>
    </message>
    <message>
        <source>Expanded uncertainty of Eq 12c in N or N·m, a number without unit.</source>
        <translation>식 12c의 확장불확도, N 또는 N·m, 단위 없는 수.</translation>
    </message>
    <message>
        <source>Stated interference in %</source>
        <translation>제시된 간섭(%)</translation>
    </message>
    <message>
        <source>Table 4 of the paper: interference by the rated output of the row.</source>
        <translation>논문의 표 4: 행의 정격출력에 대한 간섭.</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>최대</translation>
    </message>
    <message>
        <source>Largest of the row.</source>
        <translation>행의 최댓값.</translation>
    </message>
    <message>
        <source>Typed measurement equation</source>
        <translation>직접 입력한 측정 방정식</translation>
    </message>
    <message>
        <source>The uncertainty of a quantity computed from others by an equation.</source>
        <translation>다른 양들에서 방정식으로 계산한 양의 불확도.</translation>
    </message>
    <message>
        <source>Gauge block by comparison</source>
        <translation>비교에 의한 게이지 블록</translation>
    </message>
    <message>
        <source>The length of a gauge block compared with a standard of the same length.</source>
        <translation>같은 길이의 표준기와 비교한 게이지 블록의 길이.</translation>
    </message>
    <message>
        <source>Two quantities from the same readings</source>
        <translation>같은 읽음값에서 나온 두 양</translation>
    </message>
    <message>
        <source>Resistance and reactance from simultaneous readings, with their correlation.</source>
        <translation>동시 읽음값에서 구한 저항과 리액턴스, 그 상관 포함.</translation>
    </message>
    <message>
        <source>Calibration line of a thermometer</source>
        <translation>온도계의 교정 직선</translation>
    </message>
    <message>
        <source>The correction at any reading, from a line through calibration points.</source>
        <translation>교정점을 지나는 직선에서 구한, 임의 읽음값의 보정값.</translation>
    </message>
    <message>
        <source>Observations on several days</source>
        <translation>여러 날의 관측값</translation>
    </message>
    <message>
        <source>The mean of readings in groups, and whether the groups differ.</source>
        <translation>그룹별 읽음값의 평균, 그리고 그룹이 서로 다른지 여부.</translation>
    </message>
    <message>
        <source>Pose of a platform from a tracker</source>
        <translation>트래커에 의한 플랫폼의 포즈</translation>
    </message>
    <message>
        <source>Where a robot&apos;s flange or platform is, from nests measured by a laser tracker.</source>
        <translation>레이저 트래커로 측정한 네스트에서 구한 로봇 플랜지나 플랫폼의 위치.</translation>
    </message>
    <message>
        <source>Pose from two instruments together</source>
        <translation>두 측정기를 함께 쓴 포즈</translation>
    </message>
    <message>
        <source>The same pose measured by a tracker and a total station as one network.</source>
        <translation>트래커와 토탈 스테이션을 하나의 센서망으로 하여 측정한 같은 포즈.</translation>
    </message>
    <message>
        <source>Pose from calibrated artefacts</source>
        <translation>교정된 기준물에 의한 포즈</translation>
    </message>
    <message>
        <source>A pose whose point uncertainties come from measurements of artefacts.</source>
        <translation>기준물의 측정에서 점의 불확도를 얻는 포즈.</translation>
    </message>
    <message>
        <source>Points by cameras and a tracker</source>
        <translation>카메라와 트래커에 의한 점</translation>
    </message>
    <message>
        <source>Coordinates of targets that several instruments measure together.</source>
        <translation>여러 측정기가 함께 측정하는 표적의 좌표.</translation>
    </message>
    <message>
        <source>Network with unknown stations</source>
        <translation>측점을 모르는 망</translation>
    </message>
    <message>
        <source>Places of targets and of the instruments themselves, from readings to control points.</source>
        <translation>기준점에 대한 읽음값으로 구하는 표적과 측정기 자체의 위치.</translation>
    </message>
    <message>
        <source>Where do I put the station?</source>
        <translation>스테이션을 어디에 둘까?</translation>
    </message>
    <message>
        <source>The place of an instrument that makes the uncertainties smallest.</source>
        <translation>불확도를 가장 작게 하는 측정기의 위치.</translation>
    </message>
    <message>
        <source>Tool by ballbars</source>
        <translation>볼바에 의한 공구</translation>
    </message>
    <message>
        <source>A robot&apos;s tool centre point from rotations measured by telescopic ballbars.</source>
        <translation>텔레스코픽 볼바로 측정한 회전에서 구한 로봇의 공구 중심점.</translation>
    </message>
    <message>
        <source>Which points do I measure?</source>
        <translation>어떤 점을 측정할까?</translation>
    </message>
    <message>
        <source>The dozen of a plan of points that makes the uncertainty smallest.</source>
        <translation>점 계획 가운데 불확도를 가장 작게 하는 12개 점.</translation>
    </message>
    <message>
        <source>Tool position of a robot</source>
        <translation>로봇의 공구 위치</translation>
    </message>
    <message>
        <source>Where the tool is, from joint readings and Denavit-Hartenberg parameters.</source>
        <translation>관절 읽음값과 Denavit-Hartenberg 매개변수에서 구한 공구의 위치.</translation>
    </message>
    <message>
        <source>Parameters of an arm from circles that its joints describe one by one.</source>
        <translation>관절이 하나씩 그리는 원에서 구한 로봇 팔의 매개변수.</translation>
    </message>
    <message>
        <source>Parameters of an arm from measured places of its flange.</source>
        <translation>플랜지의 측정된 위치에서 구한 로봇 팔의 매개변수.</translation>
    </message>
    <message>
        <source>Calibration of a force/moment sensor</source>
        <translation>힘/모멘트 센서의 교정</translation>
    </message>
    <message>
        <source>Errors and uncertainty of the channels of a multi-axis sensor.</source>
        <translation>다축 센서 채널의 오차와 불확도.</translation>
    </message>
    <message>
        <source>Forces and moments from readings</source>
        <translation>읽음값에서 구한 힘과 모멘트</translation>
    </message>
    <message>
        <source>Loads from the readings of a multi-axis sensor by its calibration matrix.</source>
        <translation>다축 센서의 읽음값에서 교정 행렬로 구한 하중.</translation>
    </message>
    <message>
        <source>Law of propagation alone (JCGM 100), with a fixed number of trials (JCGM 101), or with as many as the tolerance needs.</source>
        <translation>전파 법칙만(JCGM 100), 정해진 시행 횟수로(JCGM 101), 또는 허용차에 필요한 횟수만큼.</translation>
    </message>
    <message>
        <source>Law of propagation only</source>
        <translation>전파 법칙만</translation>
    </message>
    <message>
        <source>Monte Carlo, fixed number of trials</source>
        <translation>몬테카를로, 고정 시행 횟수</translation>
    </message>
    <message>
        <source>Monte Carlo, adaptive</source>
        <translation>몬테카를로, 적응형</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>시행 횟수</translation>
    </message>
    <message>
        <source>Of the method monte-carlo.</source>
        <translation>monte-carlo 방법의 값.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>시드</translation>
    </message>
    <message>
        <source>0 to 18446744073709551615, as text.</source>
        <translation>0부터 18446744073709551615까지, 텍스트로.</translation>
    </message>
    <message>
        <source>Variance reduction</source>
        <translation>분산 감소</translation>
    </message>
    <message>
        <source>Makes each trial tell more; the gain is measured and stated with the result. Plain trials are those of JCGM 101.</source>
        <translation>각 시행이 더 많은 정보를 주게 합니다. 이득을 측정하여 결과와 함께 제시합니다. 일반 시행은 JCGM 101의 시행입니다.</translation>
    </message>
    <message>
        <source>None: plain trials</source>
        <translation>없음: 일반 시행</translation>
    </message>
    <message>
        <source>Control variate: the linear part</source>
        <translation>제어 변량: 선형 부분</translation>
    </message>
    <message>
        <source>Sobol points, scrambled</source>
        <translation>소볼 점, 스크램블</translation>
    </message>
    <message>
        <source>Coverage probability</source>
        <translation>포함확률</translation>
    </message>
    <message>
        <source>Of the expanded uncertainty, of intervals and regions.</source>
        <translation>확장불확도, 구간, 영역의 포함확률.</translation>
    </message>
    <message>
        <source>Coverage factor</source>
        <translation>포함인자</translation>
    </message>
    <message>
        <source>A fixed k for U = k u; absent: U by the effective degrees of freedom (law of propagation), or half of the coverage interval (Monte Carlo).</source>
        <translation>U = k u의 고정 k. 없으면 유효자유도에 의한 U(전파 법칙), 또는 포함구간의 절반(몬테카를로).</translation>
    </message>
    <message>
        <source>Second-order terms</source>
        <translation>이차항</translation>
    </message>
    <message>
        <source>Terms of second order of the law of propagation (JCGM 100 5.1.2).</source>
        <translation>전파 법칙의 이차항(JCGM 100 5.1.2).</translation>
    </message>
    <message>
        <source>Trials one at a time</source>
        <translation>단일 성분 시행</translation>
    </message>
    <message>
        <source>Of Monte Carlo with all components but one kept constant, for each component; 0: none.</source>
        <translation>각 성분에 대해 그 성분 외에는 모두 일정하게 둔 몬테카를로의 시행 횟수. 0: 없음.</translation>
    </message>
    <message>
        <source>Trials by contributor</source>
        <translation>기여요인별 시행</translation>
    </message>
    <message>
        <source>Of Monte Carlo without each contributor, and of it alone; 0: none.</source>
        <translation>각 기여요인을 뺀 몬테카를로와 그것만의 몬테카를로의 시행 횟수. 0: 없음.</translation>
    </message>
    <message>
        <source>Trials for Sobol indices</source>
        <translation>소볼 지수의 시행</translation>
    </message>
    <message>
        <source>Pairs of trials for Sobol indices; 0: none.</source>
        <translation>소볼 지수를 위한 시행 쌍의 수. 0: 없음.</translation>
    </message>
    <message>
        <source>Significant digits</source>
        <translation>유효숫자</translation>
    </message>
    <message>
        <source>Of u, for the numerical tolerance of adaptive runs and of the validation (JCGM 101 7.9.2, 8).</source>
        <translation>적응형 실행과 검증의 수치 허용차를 위한 u의 유효숫자(JCGM 101 7.9.2, 8).</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>허용차</translation>
    </message>
    <message>
        <source>A quantity applies to the outputs of its dimension; a number to every output in its SI unit.</source>
        <translation>단위가 있는 양은 같은 차원의 출력에 적용하고, 수는 모든 출력에 그 SI 단위로 적용합니다.</translation>
    </message>
    <message>
        <source>Least number of batches</source>
        <translation>최소 배치 수</translation>
    </message>
    <message>
        <source>Of an adaptive run, before it may stop.</source>
        <translation>적응형 실행이 멈출 수 있기 전까지의 배치 수.</translation>
    </message>
    <message>
        <source>Most trials</source>
        <translation>최대 시행 횟수</translation>
    </message>
    <message>
        <source>At which an adaptive run stops in any case.</source>
        <translation>적응형 실행이 어떤 경우에도 멈추는 횟수.</translation>
    </message>
    <message>
        <source>Certificate and laboratory</source>
        <translation>성적서와 교정기관</translation>
    </message>
    <message>
        <source>Certificate number</source>
        <translation>성적서 번호</translation>
    </message>
    <message>
        <source>Unique; it stands on every page.</source>
        <translation>고유해야 하며, 모든 쪽에 표시됩니다.</translation>
    </message>
    <message>
        <source>Laboratory</source>
        <translation>교정기관</translation>
    </message>
    <message>
        <source>That issues the certificate.</source>
        <translation>성적서를 발행하는 기관.</translation>
    </message>
    <message>
        <source>Address of the laboratory</source>
        <translation>교정기관의 주소</translation>
    </message>
    <message>
        <source>Street, town, country.</source>
        <translation>도로, 도시, 국가.</translation>
    </message>
    <message>
        <source>Country of the laboratory</source>
        <translation>교정기관의 국가</translation>
    </message>
    <message>
        <source>Two capital letters (ISO 3166-1): DE. For a Digital Calibration Certificate.</source>
        <translation>대문자 두 자(ISO 3166-1): DE. 디지털 교정성적서용.</translation>
    </message>
    <message>
        <source>Accreditation number</source>
        <translation>인정번호</translation>
    </message>
    <message>
        <source>Absent: not accredited for this.</source>
        <translation>없으면 이에 대해 인정받지 않음.</translation>
    </message>
    <message>
        <source>Place of calibration</source>
        <translation>교정 장소</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>고객</translation>
    </message>
    <message>
        <source>For whom it was done.</source>
        <translation>의뢰한 고객.</translation>
    </message>
    <message>
        <source>Address of the customer</source>
        <translation>고객의 주소</translation>
    </message>
    <message>
        <source>Item</source>
        <translation>교정 품목</translation>
    </message>
    <message>
        <source>What was calibrated.</source>
        <translation>교정 대상.</translation>
    </message>
    <message>
        <source>Manufacturer</source>
        <translation>제조사</translation>
    </message>
    <message>
        <source>Of the item.</source>
        <translation>품목의 제조사.</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>유형</translation>
    </message>
    <message>
        <source>The manufacturer&apos;s name for it: model, size, class.</source>
        <translation>제조사의 명칭: 모델, 크기, 등급.</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>일련번호</translation>
    </message>
    <message>
        <source>By which the item is recognised, unless it has an identification.</source>
        <translation>식별표시가 없을 때 품목을 알아보는 번호.</translation>
    </message>
    <message>
        <source>Identification</source>
        <translation>식별표시</translation>
    </message>
    <message>
        <source>The customer&apos;s mark, an inventory number.</source>
        <translation>고객의 표시, 관리번호.</translation>
    </message>
    <message>
        <source>Condition of the item</source>
        <translation>품목의 상태</translation>
    </message>
    <message>
        <source>As it was received, where that matters.</source>
        <translation>중요한 경우, 접수 당시의 상태.</translation>
    </message>
    <message>
        <source>Dates</source>
        <translation>날짜</translation>
    </message>
    <message>
        <source>ISO 8601: 2026-04-17.</source>
        <translation>ISO 8601: 2026-04-17.</translation>
    </message>
    <message>
        <source>A date, or two of an interval: 2026-04-17/2026-04-18.</source>
        <translation>날짜 하나, 또는 기간의 두 날짜: 2026-04-17/2026-04-18.</translation>
    </message>
    <message>
        <source>ISO 8601: 2026-04-20.</source>
        <translation>ISO 8601: 2026-04-20.</translation>
    </message>
    <message>
        <source>Procedure by which it was calibrated, with its edition.</source>
        <translation>교정에 쓴 절차와 그 판.</translation>
    </message>
    <message>
        <source>Deviations from the method</source>
        <translation>방법으로부터의 이탈</translation>
    </message>
    <message>
        <source>Additions, exclusions.</source>
        <translation>추가, 제외.</translation>
    </message>
    <message>
        <source>Environmental conditions</source>
        <translation>환경 조건</translation>
    </message>
    <message>
        <source>Those that influence the results.</source>
        <translation>결과에 영향을 주는 조건.</translation>
    </message>
    <message>
        <source>Metrological traceability</source>
        <translation>측정소급성</translation>
    </message>
    <message>
        <source>To which references, by which certificates the results are traceable.</source>
        <translation>결과가 어떤 기준에, 어떤 성적서로 소급되는지.</translation>
    </message>
    <message>
        <source>Adjustment or repair</source>
        <translation>조정 또는 수리</translation>
    </message>
    <message>
        <source>Results before and after it.</source>
        <translation>그 전후의 결과.</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>비고</translation>
    </message>
    <message>
        <source>Opinions and interpretations are marked as such (7.8.7).</source>
        <translation>의견과 해석은 그렇게 표시합니다(7.8.7).</translation>
    </message>
    <message>
        <source>Authorisation</source>
        <translation>승인</translation>
    </message>
    <message>
        <source>Authorised by</source>
        <translation>승인자</translation>
    </message>
    <message>
        <source>The person who authorises the certificate.</source>
        <translation>성적서를 승인하는 사람.</translation>
    </message>
    <message>
        <source>Function</source>
        <translation>직위</translation>
    </message>
    <message>
        <source>Of that person in the laboratory.</source>
        <translation>교정기관에서 그 사람의 직위.</translation>
    </message>
    <message>
        <source>Measurement model</source>
        <translation>측정 모델</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>측정 구성</translation>
    </message>
    <message>
        <source>Input quantities</source>
        <translation>입력량</translation>
    </message>
    <message>
        <source>Artefacts and instruments</source>
        <translation>기준물과 측정기</translation>
    </message>
    <message>
        <source>Uncertainty budgets</source>
        <translation>불확도 총괄표</translation>
    </message>
    <message>
        <source>Sobol indices and contributors</source>
        <translation>소볼 지수와 기여요인</translation>
    </message>
    <message>
        <source>Evaluation of the set-up</source>
        <translation>측정 구성의 평가</translation>
    </message>
    <message>
        <source>Law of propagation beside Monte Carlo</source>
        <translation>전파 법칙과 몬테카를로</translation>
    </message>
    <message>
        <source>Joint coverage regions</source>
        <translation>결합 포함영역</translation>
    </message>
    <message>
        <source>Distributions</source>
        <translation>분포</translation>
    </message>
    <message>
        <source>Set-up in space</source>
        <translation>공간상의 측정 구성</translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation>상관</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>스터디</translation>
    </message>
    <message>
        <source>Designs</source>
        <translation>설계</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>메모</translation>
    </message>
    <message>
        <source>Provenance</source>
        <translation>이력 정보</translation>
    </message>
    <message>
        <source>mean value</source>
        <translation>평균값</translation>
    </message>
    <message>
        <source>standard deviation</source>
        <translation>표준편차</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>척도</translation>
    </message>
    <message>
        <source>degrees of freedom</source>
        <translation>자유도</translation>
    </message>
    <message>
        <source>lower limit</source>
        <translation>하한</translation>
    </message>
    <message>
        <source>upper limit</source>
        <translation>상한</translation>
    </message>
    <message>
        <source>curvilinear trapezoid</source>
        <translation>곡선 사다리꼴</translation>
    </message>
    <message>
        <source>inexactness of the limits</source>
        <translation>한계의 부정확도</translation>
    </message>
    <message>
        <source>ratio of top to base</source>
        <translation>윗변과 밑변의 비</translation>
    </message>
    <message>
        <source>shape</source>
        <translation>형상</translation>
    </message>
    <message>
        <source>truncated normal</source>
        <translation>절단 정규</translation>
    </message>
    <message>
        <source>lognormal</source>
        <translation>로그정규</translation>
    </message>
    <message>
        <source>mean value of the logarithm of the number in SI</source>
        <translation>SI 단위 수치의 로그의 평균값</translation>
    </message>
    <message>
        <source>standard deviation of the logarithm</source>
        <translation>로그의 표준편차</translation>
    </message>
    <message>
        <source>parameter alpha</source>
        <translation>매개변수 alpha</translation>
    </message>
    <message>
        <source>parameter beta</source>
        <translation>매개변수 beta</translation>
    </message>
    <message>
        <source>discrete</source>
        <translation>이산</translation>
    </message>
    <message>
        <source>SpatialAnalyzer points (ASCII)</source>
        <translation>SpatialAnalyzer 점(ASCII)</translation>
    </message>
    <message>
        <source>Table of points</source>
        <translation>점의 표</translation>
    </message>
    <message>
        <source>Digital Calibration Certificate</source>
        <translation>디지털 교정성적서</translation>
    </message>
    <message>
        <source>Leica GSI-8 and GSI-16</source>
        <translation>Leica GSI-8 및 GSI-16</translation>
    </message>
    <message>
        <source>GNU Gama network</source>
        <translation>GNU Gama 망</translation>
    </message>
    <message>
        <source>Comp3D coordinates</source>
        <translation>Comp3D 좌표</translation>
    </message>
    <message>
        <source>Comp3D observations</source>
        <translation>Comp3D 관측값</translation>
    </message>
    <message>
        <source>Uncertainty budget in Excel</source>
        <translation>Excel 불확도 총괄표</translation>
    </message>
    <message>
        <source>GUM Workbench</source>
        <translation>GUM Workbench</translation>
    </message>
    <message>
        <source>Suncal project</source>
        <translation>Suncal 프로젝트</translation>
    </message>
    <message>
        <source>OptiTrack Motive tracking data</source>
        <translation>OptiTrack Motive 추적 데이터</translation>
    </message>
    <message>
        <source>Kinematic calibration of a UR robot (ROS)</source>
        <translation>UR 로봇의 기구학 교정(ROS)</translation>
    </message>
    <message>
        <source>Point list with Ux Uy Uz (SpatialAnalyzer ASCII)</source>
        <translation>Ux Uy Uz가 있는 점 목록(SpatialAnalyzer ASCII)</translation>
    </message>
    <message>
        <source>Digital Calibration Certificate 3.2.1</source>
        <translation>디지털 교정성적서 3.2.1</translation>
    </message>
    <message>
        <source>Excel workbook</source>
        <translation>Excel 통합 문서</translation>
    </message>
    <message>
        <source>Robot description (URDF)</source>
        <translation>로봇 기술 파일(URDF)</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>그룹</translation>
    </message>
    <message>
        <source>The pose, point or target the quantity belongs to</source>
        <translation>그 양이 속한 포즈, 점 또는 표적</translation>
    </message>
    <message>
        <source>Output quantity</source>
        <translation>출력량</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>추정값</translation>
    </message>
    <message>
        <source>Best value of the output quantity</source>
        <translation>출력량의 최선의 값</translation>
    </message>
    <message>
        <source>Standard uncertainty</source>
        <translation>표준불확도</translation>
    </message>
    <message>
        <source>Coverage factor. U = k u with k of the t distribution for the effective degrees of freedom.</source>
        <translation>포함인자. U = k u, k는 유효자유도에 대한 t 분포의 값.</translation>
    </message>
    <message>
        <source>Expanded uncertainty. U = k u with k of the t distribution for the effective degrees of freedom.</source>
        <translation>확장불확도. U = k u, k는 유효자유도에 대한 t 분포의 값.</translation>
    </message>
    <message>
        <source>Limit of the shortest coverage interval</source>
        <translation>최단 포함구간의 한계</translation>
    </message>
    <message>
        <source>Estimate (first order)</source>
        <translation>추정값(일차)</translation>
    </message>
    <message>
        <source>By the law of propagation of uncertainty</source>
        <translation>불확도 전파 법칙에 의함</translation>
    </message>
    <message>
        <source>u (first order)</source>
        <translation>u(일차)</translation>
    </message>
    <message>
        <source>Effective degrees of freedom (JCGM 100 G.4)</source>
        <translation>유효자유도(JCGM 100 G.4)</translation>
    </message>
    <message>
        <source>U (first order)</source>
        <translation>U(일차)</translation>
    </message>
    <message>
        <source>First order validated</source>
        <translation>일차 검증됨</translation>
    </message>
    <message>
        <source>JCGM 101 clause 8: agrees with Monte Carlo within the tolerance</source>
        <translation>JCGM 101 8절: 허용차 안에서 몬테카를로와 일치</translation>
    </message>
    <message>
        <source>u (second order)</source>
        <translation>u(이차)</translation>
    </message>
    <message>
        <source>With the second-order terms of JCGM 100 5.1.2; for information</source>
        <translation>JCGM 100 5.1.2의 이차항 포함, 참고용</translation>
    </message>
    <message>
        <source>shift (second order)</source>
        <translation>이동량(이차)</translation>
    </message>
    <message>
        <source>What the curvature of the equation adds to the estimate; for information, not added</source>
        <translation>방정식의 곡률이 추정값에 더하는 양. 참고용이며 더하지 않음</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>목표</translation>
    </message>
    <message>
        <source>Target uncertainty that is required</source>
        <translation>요구되는 목표불확도</translation>
    </message>
    <message>
        <source>U / target</source>
        <translation>U / 목표</translation>
    </message>
    <message>
        <source>Expanded uncertainty as a part of its target: above 1 the target is not met</source>
        <translation>목표에 대한 확장불확도의 비: 1보다 크면 목표 미충족</translation>
    </message>
    <message>
        <source>Requirement</source>
        <translation>요구사항</translation>
    </message>
    <message>
        <source>Whether the target uncertainty is met and the value is accepted</source>
        <translation>목표불확도를 충족하고 값이 합격인지 여부</translation>
    </message>
    <message>
        <source>Input quantity</source>
        <translation>입력량</translation>
    </message>
    <message>
        <source>Component of uncertainty</source>
        <translation>불확도 성분</translation>
    </message>
    <message>
        <source>Of the component&apos;s u</source>
        <translation>성분의 u</translation>
    </message>
    <message>
        <source>Standard uncertainty of the component</source>
        <translation>성분의 표준불확도</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>분포</translation>
    </message>
    <message>
        <source>Type A or Type B evaluation (JCGM 100 2.3.2, 2.3.3)</source>
        <translation>A형 또는 B형 평가(JCGM 100 2.3.2, 2.3.3)</translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation>자유도</translation>
    </message>
    <message>
        <source>Sensitivity coefficient, unit of the output quantity per unit of the component</source>
        <translation>감도계수, 성분의 단위당 출력량의 단위</translation>
    </message>
    <message>
        <source>|c|·u</source>
        <translation>|c|·u</translation>
    </message>
    <message>
        <source>Contribution to the standard uncertainty</source>
        <translation>표준불확도에 대한 기여</translation>
    </message>
    <message>
        <source>Share / %</source>
        <translation>비율 / %</translation>
    </message>
    <message>
        <source>Of the variance, with its part of the covariances</source>
        <translation>공분산의 몫을 포함한 분산의 비율</translation>
    </message>
    <message>
        <source>u one at a time</source>
        <translation>단일 성분 u</translation>
    </message>
    <message>
        <source>By Monte Carlo with every other component kept constant</source>
        <translation>다른 모든 성분을 일정하게 둔 몬테카를로에 의함</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>출처</translation>
    </message>
    <message>
        <source>Where the figure comes from</source>
        <translation>수치가 나온 곳</translation>
    </message>
    <message>
        <source>In</source>
        <translation>포함</translation>
    </message>
    <message>
        <source>Whether both results have the quantity</source>
        <translation>두 결과에 모두 그 양이 있는지 여부</translation>
    </message>
    <message>
        <source>U before</source>
        <translation>U 전</translation>
    </message>
    <message>
        <source>Expanded uncertainty</source>
        <translation>확장불확도</translation>
    </message>
    <message>
        <source>U after</source>
        <translation>U 후</translation>
    </message>
    <message>
        <source>Change of U in %</source>
        <translation>U의 변화 %</translation>
    </message>
    <message>
        <source>Change of the expanded uncertainty, in per cent of that before</source>
        <translation>이전 값에 대한 확장불확도의 변화(%)</translation>
    </message>
    <message>
        <source>Estimate before</source>
        <translation>추정값 전</translation>
    </message>
    <message>
        <source>Estimate after</source>
        <translation>추정값 후</translation>
    </message>
    <message>
        <source>Change of estimate</source>
        <translation>추정값의 변화</translation>
    </message>
    <message>
        <source>Estimate after less estimate before</source>
        <translation>이후 추정값에서 이전 추정값을 뺀 값</translation>
    </message>
    <message>
        <source>u before</source>
        <translation>u 전</translation>
    </message>
    <message>
        <source>u after</source>
        <translation>u 후</translation>
    </message>
    <message>
        <source>k before</source>
        <translation>k 전</translation>
    </message>
    <message>
        <source>k after</source>
        <translation>k 후</translation>
    </message>
    <message>
        <source>Changed, the same, new, or gone</source>
        <translation>변경, 동일, 신규 또는 삭제</translation>
    </message>
    <message>
        <source>|c|·u before</source>
        <translation>|c|·u 전</translation>
    </message>
    <message>
        <source>|c|·u after</source>
        <translation>|c|·u 후</translation>
    </message>
    <message>
        <source>Share before / %</source>
        <translation>비율 전 / %</translation>
    </message>
    <message>
        <source>Of the variance before</source>
        <translation>이전 분산의 비율</translation>
    </message>
    <message>
        <source>Share after / %</source>
        <translation>비율 후 / %</translation>
    </message>
    <message>
        <source>Of the variance after</source>
        <translation>이후 분산의 비율</translation>
    </message>
    <message>
        <source>Change of variance / %</source>
        <translation>분산의 변화 / %</translation>
    </message>
    <message>
        <source>By how much this component changes the variance of the output, in per cent of the whole variance before; the rows add up to the change of the whole</source>
        <translation>이 성분이 출력의 분산을 바꾸는 정도, 이전 전체 분산에 대한 %. 행의 합은 전체의 변화입니다</translation>
    </message>
    <message>
        <source>met</source>
        <translation>충족</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>미충족</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>예</translation>
    </message>
    <message>
        <source>no</source>
        <translation>아니요</translation>
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
        <translation>포함인자. U = k u, 포함인자는 고정된 값.</translation>
    </message>
    <message>
        <source>Expanded uncertainty. U = k u with the coverage factor that was fixed.</source>
        <translation>확장불확도. U = k u, 포함인자는 고정된 값.</translation>
    </message>
    <message>
        <source>Coverage factor. U is half the width of the probabilistically symmetric coverage interval, and k = U/u.</source>
        <translation>포함인자. U는 확률적 대칭 포함구간 폭의 절반이고, k = U/u.</translation>
    </message>
    <message>
        <source>Expanded uncertainty. U is half the width of the probabilistically symmetric coverage interval, and k = U/u.</source>
        <translation>확장불확도. U는 확률적 대칭 포함구간 폭의 절반이고, k = U/u.</translation>
    </message>
    <message>
        <source>Target uncertainty</source>
        <translation>목표불확도</translation>
    </message>
    <message>
        <source>The expanded uncertainty U must not exceed this.</source>
        <translation>확장불확도 U가 이 값을 넘지 않아야 함.</translation>
    </message>
    <message>
        <source>Lower limit</source>
        <translation>하한</translation>
    </message>
    <message>
        <source>Of the tolerance; empty: none.</source>
        <translation>허용차의 한계; 비우면 없음.</translation>
    </message>
    <message>
        <source>Upper limit</source>
        <translation>상한</translation>
    </message>
    <message>
        <source>Guard factor</source>
        <translation>보호인자</translation>
    </message>
    <message>
        <source>Guard bands of this times U inside the tolerance: 1 proves conformity (ISO 14253-1), 0 is simple acceptance, negative values favour the producer.</source>
        <translation>허용차 안쪽에 U의 이 배수만큼 보호대역을 둠: 1은 적합성을 입증(ISO 14253-1), 0은 단순 합격, 음수는 생산자에게 유리함.</translation>
    </message>
    <message>
        <source>Prior mean</source>
        <translation>사전 평균</translation>
    </message>
    <message>
        <source>What is known of such quantities before the measurement, as a normal distribution (the production process): for the global risks of JCGM 106.</source>
        <translation>측정 전에 이러한 양에 대해 아는 것을 정규분포로 나타냄(생산 공정): JCGM 106의 전역 위험에 사용.</translation>
    </message>
    <message>
        <source>Prior standard deviation</source>
        <translation>사전 표준편차</translation>
    </message>
    <message>
        <source>Of the production process.</source>
        <translation>생산 공정의 값.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>언어</translation>
    </message>
    <message>
        <source>Logo</source>
        <translation>로고</translation>
    </message>
    <message>
        <source>A PNG or JPEG file beside the project, up to 2 MB: at the head of the first page.</source>
        <translation>프로젝트 옆의 PNG 또는 JPEG 파일, 최대 2 MB: 첫 페이지 머리에 놓입니다.</translation>
    </message>
    <message>
        <source>Calibration certificate %1</source>
        <translation>교정 성적서 %1</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>%1 / %2 쪽</translation>
    </message>
    <message>
        <source>— not stated —</source>
        <translation>— 기재 없음 —</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1부터 %2까지</translation>
    </message>
    <message>
        <source>in the laboratory</source>
        <translation>시험실 내</translation>
    </message>
    <message>
        <source>This certificate states %1 of %2 results. Not stated: %3.</source>
        <translation>이 성적서는 결과 %2개 중 %1개를 기재합니다. 기재하지 않은 것: %3.</translation>
    </message>
    <message>
        <source>1 further result is in the digital certificate that is attached to the PDF (certificate.xml).</source>
        <translation>결과 1개가 PDF에 첨부된 디지털 성적서(certificate.xml)에 더 있습니다.</translation>
    </message>
    <message>
        <source>%1 further results are in the digital certificate that is attached to the PDF (certificate.xml).</source>
        <translation>결과 %1개가 PDF에 첨부된 디지털 성적서(certificate.xml)에 더 있습니다.</translation>
    </message>
    <message>
        <source>Not evaluated: %1.</source>
        <translation>평가하지 않음: %1.</translation>
    </message>
    <message>
        <source>Evaluated with Covaria %1, project fingerprint %2.</source>
        <translation>Covaria %1로 평가함, 프로젝트 지문 %2.</translation>
    </message>
    <message>
        <source>Evaluated with Covaria %1, project fingerprint %2, analyses: %3.</source>
        <translation>Covaria %1로 평가함, 프로젝트 지문 %2, 분석: %3.</translation>
    </message>
    <message>
        <source>The results relate only to the item described above, in the state in which it was calibrated. This certificate may be reproduced in full only, unless the laboratory permits otherwise.</source>
        <translation>결과는 위에 기술된 품목의 교정 당시 상태에만 관련됩니다. 시험실이 달리 허락하지 않는 한 이 성적서는 전체로만 복제할 수 있습니다.</translation>
    </message>
    <message>
        <source>Date of issue: %1</source>
        <translation>발급일: %1</translation>
    </message>
    <message>
        <source>End of certificate</source>
        <translation>성적서 끝</translation>
    </message>
    <message>
        <source>End of certificate %1</source>
        <translation>성적서 %1 끝</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>결과</translation>
    </message>
    <message>
        <source>p = %1 to %2.</source>
        <translation>p = %1 ~ %2.</translation>
    </message>
    <message>
        <source>No result is stated: what was evaluated does not represent the measurand; %1 trials have no value.</source>
        <translation>결과를 기재하지 않음: 평가한 것이 측정량을 나타내지 않습니다. 시행 %1회에 값이 없습니다.</translation>
    </message>
    <message>
        <source>Coverage intervals that are not symmetric about the estimate: %1.</source>
        <translation>추정값에 대해 대칭이 아닌 포함 구간: %1.</translation>
    </message>
    <message>
        <source>Coverage intervals that are not symmetric about the estimate: %1; and %2 others.</source>
        <translation>추정값에 대해 대칭이 아닌 포함 구간: %1; 그 밖에 %2개.</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 (exact)</source>
        <translation>%1 (정확한 값)</translation>
    </message>
    <message>
        <source>%1 (U not finite)</source>
        <translation>%1 (U가 유한하지 않음)</translation>
    </message>
    <message>
        <source>without k, because u is not finite</source>
        <translation>u가 유한하지 않아 k 없음</translation>
    </message>
    <message>
        <source>coverage interval %1</source>
        <translation>포함 구간 %1</translation>
    </message>
    <message>
        <source>The standard uncertainty was determined by the law of propagation of uncertainty in accordance with JCGM 100.</source>
        <translation>표준불확도는 JCGM 100에 따라 불확도 전파 법칙으로 구하였습니다.</translation>
    </message>
    <message>
        <source>The distribution was determined by the propagation of distributions in accordance with JCGM 101.</source>
        <translation>분포는 JCGM 101에 따라 분포의 전파로 구하였습니다.</translation>
    </message>
    <message>
        <source>The expanded uncertainty U stated after ± is the standard uncertainty multiplied by the fixed coverage factor k; y ± U has the coverage probability p that is stated with it.</source>
        <translation>± 뒤에 적은 확장불확도 U는 표준불확도에 고정된 포함인자 k를 곱한 것이며, y ± U의 포함확률은 함께 적은 p입니다.</translation>
    </message>
    <message>
        <source>The expanded uncertainty U stated after ± is half the width of the probabilistically symmetric coverage interval of the coverage probability p, and k = U/u.</source>
        <translation>± 뒤에 적은 확장불확도 U는 포함확률 p인 확률 대칭 포함 구간 너비의 절반이며, k = U/u입니다.</translation>
    </message>
    <message>
        <source>The expanded uncertainty U stated after ± is the standard uncertainty multiplied by the coverage factor k, which for a normal distribution, or for a t distribution of the effective degrees of freedom nu_eff where they are stated, corresponds to the coverage probability p.</source>
        <translation>± 뒤에 적은 확장불확도 U는 표준불확도에 포함인자 k를 곱한 것이며, k는 정규분포에서, 또는 유효자유도 nu_eff를 적은 경우 t 분포에서 포함확률 p에 해당합니다.</translation>
    </message>
    <message>
        <source>Statement of conformity</source>
        <translation>적합성 진술</translation>
    </message>
    <message>
        <source>Acceptance</source>
        <translation>합격 구간</translation>
    </message>
    <message>
        <source>Decision rule</source>
        <translation>의사결정 규칙</translation>
    </message>
    <message>
        <source>Decision</source>
        <translation>판정</translation>
    </message>
    <message>
        <source>Conforming</source>
        <translation>적합 확률</translation>
    </message>
    <message>
        <source>by</source>
        <translation>근거</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>판정 안 함</translation>
    </message>
    <message>
        <source>trials</source>
        <translation>시행</translation>
    </message>
    <message>
        <source>JCGM 106: probability that the measurand lies inside the tolerance, by the distribution of the result: its trials, or by the law of propagation Student&apos;s t for the effective degrees of freedom. The acceptance interval is the tolerance less guard bands w. Decision rules are named as in ILAC-G8:09/2019. TUR: half of the tolerance over U. C_m: T/(2U) for U = 2u, T/(4u).</source>
        <translation>JCGM 106: 측정량이 허용차 안에 있을 확률. 결과의 분포, 곧 그 시행에 따르거나, 전파 법칙에서는 유효자유도의 스튜던트 t 분포에 따릅니다. 합격 구간은 허용차에서 보호대역 w를 뺀 것입니다. 의사결정 규칙의 이름은 ILAC-G8:09/2019를 따릅니다. TUR: 허용차의 절반을 U로 나눈 값. C_m: U = 2u일 때 T/(2U), T/(4u).</translation>
    </message>
    <message>
        <source>simple acceptance (w = 0)</source>
        <translation>단순 합격 (w = 0)</translation>
    </message>
    <message>
        <source>guard band w = %1</source>
        <translation>보호대역 w = %1</translation>
    </message>
    <message>
        <source>guarded rejection (w = −%1)</source>
        <translation>보호 불합격 (w = −%1)</translation>
    </message>
    <message>
        <source>Results before and after</source>
        <translation>전후 결과</translation>
    </message>
    <message>
        <source>Context mesh</source>
        <translation>주변 메시</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>메시</translation>
    </message>
    <message>
        <source>STL file</source>
        <translation>STL 파일</translation>
    </message>
    <message>
        <source>A binary or ASCII STL file beside the project, up to 200 MB and 5 million triangles. It is drawn in the scenes of all analyses and influences no number.</source>
        <translation>프로젝트 옆에 있는 이진 또는 ASCII STL 파일로, 최대 200 MB, 삼각형 500만 개입니다. 모든 분석의 장면에 그려지며 어떤 수치에도 영향을 주지 않습니다.</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>파일의 단위</translation>
    </message>
    <message>
        <source>STL files do not say in which unit their numbers are.</source>
        <translation>STL 파일에는 수치의 단위가 적혀 있지 않습니다.</translation>
    </message>
    <message>
        <source>millimetre</source>
        <translation>밀리미터</translation>
    </message>
    <message>
        <source>metre</source>
        <translation>미터</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>인치</translation>
    </message>
    <message>
        <source>Position and orientation</source>
        <translation>위치와 자세</translation>
    </message>
    <message>
        <source>Where the origin of the file stands in the world frame, and how its axes are turned.</source>
        <translation>파일의 원점이 월드 좌표계에서 놓인 곳과 축들이 회전된 정도.</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>모양</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>색</translation>
    </message>
    <message>
        <source>Of the surface, on a light and on a dark ground.</source>
        <translation>표면의 색. 밝은 배경과 어두운 배경에 쓰입니다.</translation>
    </message>
    <message>
        <source>grey</source>
        <translation>회색</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>파랑</translation>
    </message>
    <message>
        <source>green</source>
        <translation>초록</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>주황</translation>
    </message>
    <message>
        <source>red</source>
        <translation>빨강</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>불투명도</translation>
    </message>
    <message>
        <source>100 % hides what is behind the surface; less lets the measured points be seen.</source>
        <translation>100 %이면 표면 뒤의 것이 가려지고, 더 작으면 측정한 점이 보입니다.</translation>
    </message>
    <message>
        <source>largest U/target</source>
        <translation>최대 U/목표</translation>
    </message>
    <message>
        <source>largest U relative to the present design</source>
        <translation>현재 설계에 대한 최대 U</translation>
    </message>
    <message>
        <source>mean U/target</source>
        <translation>U/목표의 평균</translation>
    </message>
    <message>
        <source>mean U relative to the present design</source>
        <translation>현재 설계에 대한 U의 평균</translation>
    </message>
    <message>
        <source>root mean square of U/target</source>
        <translation>U/목표의 제곱 평균 제곱근</translation>
    </message>
    <message>
        <source>root mean square of U relative to the present design</source>
        <translation>현재 설계에 대한 U의 제곱 평균 제곱근</translation>
    </message>
    <message>
        <source>Monte Carlo</source>
        <translation>몬테카를로</translation>
    </message>
    <message>
        <source>Run Monte Carlo to see the distribution of %1</source>
        <translation>몬테카를로를 실행하면 %1의 분포를 볼 수 있습니다</translation>
    </message>
    <message>
        <source>Run Monte Carlo to see the quantiles of %1</source>
        <translation>몬테카를로를 실행하면 %1의 분위수를 볼 수 있습니다</translation>
    </message>
    <message>
        <source>Run Monte Carlo with more trials to see the distribution of %1</source>
        <translation>더 많은 시행으로 몬테카를로를 실행하면 %1의 분포를 볼 수 있습니다</translation>
    </message>
    <message>
        <source>Run Monte Carlo with more trials to see the quantiles of %1</source>
        <translation>더 많은 시행으로 몬테카를로를 실행하면 %1의 분위수를 볼 수 있습니다</translation>
    </message>
    <message>
        <source>%1 has the same value in every trial: give its inputs components of uncertainty</source>
        <translation>%1의 값이 모든 시행에서 같습니다: 입력량에 불확도 성분을 주십시오</translation>
    </message>
    <message>
        <source>Distribution of %1</source>
        <translation>%1의 분포</translation>
    </message>
    <message>
        <source>probability density</source>
        <translation>확률 밀도</translation>
    </message>
    <message>
        <source>normal, same mean and u</source>
        <translation>정규분포, 같은 평균과 u</translation>
    </message>
    <message>
        <source>normal, same interval</source>
        <translation>정규분포, 같은 구간</translation>
    </message>
    <message>
        <source>normal, first order</source>
        <translation>정규분포, 1차</translation>
    </message>
    <message>
        <source>Student t, first order</source>
        <translation>스튜던트 t, 1차</translation>
    </message>
    <message>
        <source>%1 coverage interval</source>
        <translation>%1 포함구간</translation>
    </message>
    <message>
        <source>mean %1</source>
        <translation>평균 %1</translation>
    </message>
    <message>
        <source>Normal quantiles of %1</source>
        <translation>%1의 정규 분위수</translation>
    </message>
    <message>
        <source>quantile of the standard normal distribution</source>
        <translation>표준정규분포의 분위수</translation>
    </message>
    <message>
        <source>quantile of %1</source>
        <translation>%1의 분위수</translation>
    </message>
    <message>
        <source>No input quantity with an uncertainty influences %1: give its inputs components of uncertainty</source>
        <translation>불확도가 있는 어떤 입력량도 %1에 영향을 주지 않습니다: 입력량에 불확도 성분을 주십시오</translation>
    </message>
    <message>
        <source>Contributions to u(%1)</source>
        <translation>u(%1)에 대한 기여</translation>
    </message>
    <message>
        <source>first order</source>
        <translation>1차</translation>
    </message>
    <message>
        <source>one at a time, Monte Carlo</source>
        <translation>하나씩, 몬테카를로</translation>
    </message>
    <message>
        <source>%1 others</source>
        <translation>그 밖의 %1개</translation>
    </message>
    <message>
        <source>A single output quantity has nothing to be correlated with</source>
        <translation>출력량이 하나뿐이면 상관될 대상이 없습니다</translation>
    </message>
    <message>
        <source>Correlation coefficients</source>
        <translation>상관계수</translation>
    </message>
    <message>
        <source>correlation coefficient</source>
        <translation>상관계수</translation>
    </message>
    <message>
        <source>Run Monte Carlo to see how u of %1 settles</source>
        <translation>몬테카를로를 실행하면 %1의 u가 어떻게 안정되는지 볼 수 있습니다</translation>
    </message>
    <message>
        <source>%1, against the number of trials</source>
        <translation>시행 수에 따른 %1</translation>
    </message>
    <message>
        <source>%1 (not stabilised)</source>
        <translation>%1 (안정되지 않음)</translation>
    </message>
    <message>
        <source>± 2 standard errors</source>
        <translation>± 2 표준오차</translation>
    </message>
    <message>
        <source>final u %1</source>
        <translation>최종 u %1</translation>
    </message>
    <message>
        <source>before</source>
        <translation>이전</translation>
    </message>
    <message>
        <source>after</source>
        <translation>이후</translation>
    </message>
    <message>
        <source>Distributions of %1</source>
        <translation>%1의 분포들</translation>
    </message>
    <message>
        <source>The output quantity has no distribution to show</source>
        <translation>이 출력량에는 보여 줄 분포가 없습니다</translation>
    </message>
    <message>
        <source>Only one of the results has %1</source>
        <translation>결과 중 하나에만 %1이(가) 있습니다</translation>
    </message>
    <message>
        <source>The budget of %1 has not changed</source>
        <translation>%1의 불확도 총괄은 변하지 않았습니다</translation>
    </message>
    <message>
        <source>Changes of the budget of %1</source>
        <translation>%1의 불확도 총괄의 변화</translation>
    </message>
    <message>
        <source>uncertainty</source>
        <translation>불확도</translation>
    </message>
    <message>
        <source>as set up: %1</source>
        <translation>현재 설정: %1</translation>
    </message>
    <message>
        <source>%1 at %2 = %3</source>
        <translation>%1, %2 = %3</translation>
    </message>
    <message>
        <source>Run the study “%1” to see it</source>
        <translation>연구 “%1”을(를) 실행하면 볼 수 있습니다</translation>
    </message>
    <message>
        <source>No grid point of “%1” has values: %2</source>
        <translation>“%1”의 어떤 격자점에도 값이 없습니다: %2</translation>
    </message>
    <message>
        <source>Uncertainties before and after</source>
        <translation>이전과 이후의 불확도</translation>
    </message>
    <message>
        <source>U relative to the present design</source>
        <translation>현재 설계에 대한 U</translation>
    </message>
    <message>
        <source>designed</source>
        <translation>설계</translation>
    </message>
    <message>
        <source>What more rows give</source>
        <translation>행을 늘릴 때의 이득</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>행</translation>
    </message>
    <message>
        <source>best found</source>
        <translation>찾은 최선</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>유지</translation>
    </message>
    <message>
        <source>What each row kept is worth</source>
        <translation>유지된 각 행의 가치</translation>
    </message>
    <message>
        <source>What a smaller uncertainty costs</source>
        <translation>더 작은 불확도의 비용</translation>
    </message>
    <message>
        <source>largest U / target</source>
        <translation>최대 U / 목표</translation>
    </message>
    <message>
        <source>cost</source>
        <translation>비용</translation>
    </message>
    <message>
        <source>cheapest reductions</source>
        <translation>가장 저렴한 감소</translation>
    </message>
    <message>
        <source>cheapest rows</source>
        <translation>가장 저렴한 행</translation>
    </message>
    <message>
        <source>targets</source>
        <translation>목표</translation>
    </message>
    <message>
        <source>The way of the search</source>
        <translation>탐색 경로</translation>
    </message>
    <message>
        <source>evaluations</source>
        <translation>평가 횟수</translation>
    </message>
    <message>
        <source>best so far</source>
        <translation>지금까지의 최선</translation>
    </message>
    <message>
        <source>both</source>
        <translation>둘 다</translation>
    </message>
    <message>
        <source>only before</source>
        <translation>이전에만</translation>
    </message>
    <message>
        <source>only after</source>
        <translation>이후에만</translation>
    </message>
    <message>
        <source>new</source>
        <translation>새로 생김</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>없어짐</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>바뀜</translation>
    </message>
    <message>
        <source>same</source>
        <translation>같음</translation>
    </message>
    <message>
        <source>number of trials</source>
        <translation>시행 수</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>카메라</translation>
    </message>
    <message>
        <source>Coordinate measuring machines and arms</source>
        <translation>좌표 측정기와 측정 암</translation>
    </message>
    <message>
        <source>Distance meters</source>
        <translation>거리계</translation>
    </message>
    <message>
        <source>Laser scanners</source>
        <translation>레이저 스캐너</translation>
    </message>
    <message>
        <source>Laser trackers</source>
        <translation>레이저 트래커</translation>
    </message>
    <message>
        <source>Length standards and ballbars</source>
        <translation>길이 표준기와 볼바</translation>
    </message>
    <message>
        <source>Robot arms</source>
        <translation>로봇 팔</translation>
    </message>
    <message>
        <source>Total stations</source>
        <translation>토털 스테이션</translation>
    </message>
    <message>
        <source>Uncertainty budget of a measured point</source>
        <translation>측정점의 불확도 총괄표</translation>
    </message>
    <message>
        <source>Errors of indication (Eq 1)</source>
        <translation>지시 오차 (식 1)</translation>
    </message>
    <message>
        <source>Errors of indication (Eq 4)</source>
        <translation>지시 오차 (식 4)</translation>
    </message>
    <message>
        <source>Standard uncertainty of one reading, along and across the line of sight</source>
        <translation>한 번 읽음의 표준불확도, 시준선 방향과 직각 방향</translation>
    </message>
    <message>
        <source>across, by azimuth</source>
        <translation>직각, 방위각에 의함</translation>
    </message>
    <message>
        <source>across, by elevation</source>
        <translation>직각, 고도각에 의함</translation>
    </message>
    <message>
        <source>along</source>
        <translation>방향</translation>
    </message>
    <message>
        <source>Standard uncertainty by the readings alone, and with the stations</source>
        <translation>읽음만에 의한 표준불확도와 측점을 포함한 표준불확도</translation>
    </message>
    <message>
        <source>readings alone (Eq 5)</source>
        <translation>읽음만 (식 5)</translation>
    </message>
    <message>
        <source>readings and shared deviations, first order</source>
        <translation>읽음과 공통 편차, 1차</translation>
    </message>
    <message>
        <source>Parameters and their uncertainty</source>
        <translation>매개변수와 그 불확도</translation>
    </message>
    <message>
        <source>u, section 4.1</source>
        <translation>u, 4.1절</translation>
    </message>
    <message>
        <source>U = 2 u</source>
        <translation>U = 2 u</translation>
    </message>
    <message>
        <source>value − U</source>
        <translation>값 − U</translation>
    </message>
    <message>
        <source>value + U</source>
        <translation>값 + U</translation>
    </message>
    <message>
        <source>u, Table 1</source>
        <translation>u, 표 1</translation>
    </message>
    <message>
        <source>u, repeatability</source>
        <translation>u, 반복성</translation>
    </message>
    <message>
        <source>u, sampling</source>
        <translation>u, 표본추출</translation>
    </message>
    <message>
        <source>u, range</source>
        <translation>u, 범위</translation>
    </message>
    <message>
        <source>Identified parameters beside the nominal ones</source>
        <translation>식별된 매개변수와 공칭 매개변수</translation>
    </message>
    <message>
        <source>nominal</source>
        <translation>공칭</translation>
    </message>
    <message>
        <source>identified</source>
        <translation>식별값</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>차이</translation>
    </message>
    <message>
        <source>What these points cannot tell</source>
        <translation>이 점들로 알 수 없는 것</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>이유</translation>
    </message>
    <message>
        <source>Observability</source>
        <translation>관측 가능성</translation>
    </message>
    <message>
        <source>Strongest correlation of each unknown</source>
        <translation>각 미지수의 가장 강한 상관</translation>
    </message>
    <message>
        <source>Residuals of the fit, measured less calculated</source>
        <translation>맞춤 잔차, 측정값 빼기 계산값</translation>
    </message>
    <message>
        <source>pose</source>
        <translation>포즈</translation>
    </message>
    <message>
        <source>largest over its u</source>
        <translation>u에 대한 최댓값</translation>
    </message>
    <message>
        <source>outlier test</source>
        <translation>이상값 검정</translation>
    </message>
    <message>
        <source>Poses held back from the fit, calculated less measured</source>
        <translation>맞춤에서 제외한 포즈, 계산값 빼기 측정값</translation>
    </message>
    <message>
        <source>nominal, distance</source>
        <translation>공칭, 거리</translation>
    </message>
    <message>
        <source>U (k = 2), largest</source>
        <translation>U (k = 2), 최대</translation>
    </message>
    <message>
        <source>E_n, largest</source>
        <translation>E_n, 최대</translation>
    </message>
    <message>
        <source>Circles of the joints</source>
        <translation>관절의 원</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>호</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>반지름</translation>
    </message>
    <message>
        <source>rms along the radius</source>
        <translation>반지름 방향 rms</translation>
    </message>
    <message>
        <source>rms off the plane</source>
        <translation>평면 이탈 rms</translation>
    </message>
    <message>
        <source>Readings and places of the poses, without uncertainty</source>
        <translation>포즈의 읽음과 위치, 불확도 없음</translation>
    </message>
    <message>
        <source>Relative uncertainty of the loads</source>
        <translation>하중의 상대불확도</translation>
    </message>
    <message>
        <source>Calibration as planned and as read</source>
        <translation>계획된 교정과 읽은 교정</translation>
    </message>
    <message>
        <source>preloads</source>
        <translation>예비 하중</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>반복 횟수</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>단계</translation>
    </message>
    <message>
        <source>decreasing steps</source>
        <translation>감소 단계</translation>
    </message>
    <message>
        <source>spread of the preloads</source>
        <translation>예비 하중의 산포</translation>
    </message>
    <message>
        <source>Rated output and non-zero error of each sensor (Kim, Table 1)</source>
        <translation>각 센서의 정격 출력과 영점 오차 (Kim, 표 1)</translation>
    </message>
    <message>
        <source>rated load</source>
        <translation>정격 하중</translation>
    </message>
    <message>
        <source>Interference error of each sensor (Kim, Table 2)</source>
        <translation>각 센서의 간섭 오차 (Kim, 표 2)</translation>
    </message>
    <message>
        <source>Uncertainty of the sensors by the paper (Kim, Table 3, Eqs 4 to 12)</source>
        <translation>논문에 따른 센서의 불확도 (Kim, 표 3, 식 4~12)</translation>
    </message>
    <message>
        <source>U, load</source>
        <translation>U, 하중</translation>
    </message>
    <message>
        <source>Interference error in per cent of the rated output (Kim, Table 4)</source>
        <translation>정격 출력의 퍼센트로 나타낸 간섭 오차 (Kim, 표 4)</translation>
    </message>
    <message>
        <source>Parts of the Type B standard uncertainty (Eqs 5 to 8)</source>
        <translation>B형 표준불확도의 부분 (식 5~8)</translation>
    </message>
    <message>
        <source>Means and standard deviations of the net values (Eqs 1 to 4)</source>
        <translation>순값의 평균과 표준편차 (식 1~4)</translation>
    </message>
    <message>
        <source>mean, decreasing</source>
        <translation>평균, 감소</translation>
    </message>
    <message>
        <source>Stated values beside the computed ones</source>
        <translation>명시된 값과 계산된 값</translation>
    </message>
    <message>
        <source>stated</source>
        <translation>명시됨</translation>
    </message>
    <message>
        <source>computed</source>
        <translation>계산됨</translation>
    </message>
    <message>
        <source>status</source>
        <translation>상태</translation>
    </message>
    <message>
        <source>Interference at rated loads (% of the sensor&apos;s rated output)</source>
        <translation>정격 하중에서의 간섭 (센서 정격 출력의 %)</translation>
    </message>
    <message>
        <source>Parts of U by the paper (% of rated output)</source>
        <translation>논문에 따른 U의 부분 (정격 출력의 %)</translation>
    </message>
    <message>
        <source>per cent of rated output</source>
        <translation>정격 출력의 퍼센트</translation>
    </message>
    <message>
        <source>k u_c</source>
        <translation>k u_c</translation>
    </message>
    <message>
        <source>Loads of one axis against time</source>
        <translation>시간에 따른 한 축의 하중</translation>
    </message>
    <message>
        <source>Calibration curve of Fx</source>
        <translation>Fx의 교정 곡선</translation>
    </message>
    <message>
        <source>increasing, mean</source>
        <translation>증가, 평균</translation>
    </message>
    <message>
        <source>decreasing, mean</source>
        <translation>감소, 평균</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of Fx</source>
        <translation>Fx의 영점 통과 직선에 대한 잔차</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of Fx</source>
        <translation>Fx의 확대된 히스테리시스 고리</translation>
    </message>
    <message>
        <source>Calibration curve of Fy</source>
        <translation>Fy의 교정 곡선</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of Fy</source>
        <translation>Fy의 영점 통과 직선에 대한 잔차</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of Fy</source>
        <translation>Fy의 확대된 히스테리시스 고리</translation>
    </message>
    <message>
        <source>Calibration curve of Fz</source>
        <translation>Fz의 교정 곡선</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of Fz</source>
        <translation>Fz의 영점 통과 직선에 대한 잔차</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of Fz</source>
        <translation>Fz의 확대된 히스테리시스 고리</translation>
    </message>
    <message>
        <source>Calibration curve of Mx</source>
        <translation>Mx의 교정 곡선</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of Mx</source>
        <translation>Mx의 영점 통과 직선에 대한 잔차</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of Mx</source>
        <translation>Mx의 확대된 히스테리시스 고리</translation>
    </message>
    <message>
        <source>Calibration curve of My</source>
        <translation>My의 교정 곡선</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of My</source>
        <translation>My의 영점 통과 직선에 대한 잔차</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of My</source>
        <translation>My의 확대된 히스테리시스 고리</translation>
    </message>
    <message>
        <source>Calibration curve of Mz</source>
        <translation>Mz의 교정 곡선</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of Mz</source>
        <translation>Mz의 영점 통과 직선에 대한 잔차</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of Mz</source>
        <translation>Mz의 확대된 히스테리시스 고리</translation>
    </message>
    <message>
        <source>The paper&apos;s U and the GUM&apos;s, per cent of rated output</source>
        <translation>논문의 U와 GUM의 U, 정격 출력의 퍼센트</translation>
    </message>
    <message>
        <source>paper, linear sum</source>
        <translation>논문, 선형 합</translation>
    </message>
    <message>
        <source>GUM, unknown loads on all other axes</source>
        <translation>GUM, 다른 모든 축에 미지의 하중</translation>
    </message>
    <message>
        <source>GUM, unknown load on one axis</source>
        <translation>GUM, 한 축에 미지의 하중</translation>
    </message>
    <message>
        <source>GUM, one component alone, 95 %</source>
        <translation>GUM, 한 성분만, 95 %</translation>
    </message>
    <message>
        <source>all other axes at rated load, worst signs</source>
        <translation>다른 모든 축이 정격 하중, 최악의 부호</translation>
    </message>
    <message>
        <source>interference alone exceeds the paper&apos;s U</source>
        <translation>간섭만으로 논문의 U를 넘음</translation>
    </message>
    <message>
        <source>Standard uncertainties by the GUM</source>
        <translation>GUM에 따른 표준불확도</translation>
    </message>
    <message>
        <source>repeatability</source>
        <translation>반복성</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>교정기</translation>
    </message>
    <message>
        <source>non-zero</source>
        <translation>영점</translation>
    </message>
    <message>
        <source>all</source>
        <translation>전체</translation>
    </message>
    <message>
        <source>U by the paper and by the GUM</source>
        <translation>논문과 GUM에 따른 U</translation>
    </message>
    <message>
        <source>all others at rated load, worst signs</source>
        <translation>나머지 모두 정격 하중, 최악의 부호</translation>
    </message>
    <message>
        <source>Calibration matrix: reading by load</source>
        <translation>교정 행렬: 하중당 읽음</translation>
    </message>
    <message>
        <source>channel</source>
        <translation>채널</translation>
    </message>
    <message>
        <source>load Fx</source>
        <translation>하중 Fx</translation>
    </message>
    <message>
        <source>load Fy</source>
        <translation>하중 Fy</translation>
    </message>
    <message>
        <source>load Fz</source>
        <translation>하중 Fz</translation>
    </message>
    <message>
        <source>load Mx</source>
        <translation>하중 Mx</translation>
    </message>
    <message>
        <source>load My</source>
        <translation>하중 My</translation>
    </message>
    <message>
        <source>load Mz</source>
        <translation>하중 Mz</translation>
    </message>
    <message>
        <source>Decoupling matrix: load by reading</source>
        <translation>분리 행렬: 읽음당 하중</translation>
    </message>
    <message>
        <source>channel Fx</source>
        <translation>채널 Fx</translation>
    </message>
    <message>
        <source>channel Fy</source>
        <translation>채널 Fy</translation>
    </message>
    <message>
        <source>channel Fz</source>
        <translation>채널 Fz</translation>
    </message>
    <message>
        <source>channel Mx</source>
        <translation>채널 Mx</translation>
    </message>
    <message>
        <source>channel My</source>
        <translation>채널 My</translation>
    </message>
    <message>
        <source>channel Mz</source>
        <translation>채널 Mz</translation>
    </message>
    <message>
        <source>Loads with and without compensation of interference</source>
        <translation>간섭 보정 유무에 따른 하중</translation>
    </message>
    <message>
        <source>case</source>
        <translation>경우</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>읽음</translation>
    </message>
    <message>
        <source>compensated</source>
        <translation>보정함</translation>
    </message>
    <message>
        <source>uncompensated</source>
        <translation>보정 안 함</translation>
    </message>
    <message>
        <source>by rated load</source>
        <translation>정격 하중 대비</translation>
    </message>
    <message>
        <source>What interference adds without compensation</source>
        <translation>보정하지 않을 때 간섭이 더하는 값</translation>
    </message>
    <message>
        <source>per cent of rated load</source>
        <translation>정격 하중의 퍼센트</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>혼합</translation>
    </message>
    <message>
        <source>all rated</source>
        <translation>모두 정격</translation>
    </message>
    <message>
        <source>no load</source>
        <translation>무하중</translation>
    </message>
    <message>
        <source>Supports in the instrument&apos;s frame and in the robot&apos;s</source>
        <translation>기기 좌표계와 로봇 좌표계에서의 지지점</translation>
    </message>
    <message>
        <source>support</source>
        <translation>지지점</translation>
    </message>
    <message>
        <source>Scatter of a pose that the robot is sent to again</source>
        <translation>로봇이 다시 도달하는 포즈의 산포</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>편차</translation>
    </message>
    <message>
        <source>Rotations of the flange</source>
        <translation>플랜지의 회전</translation>
    </message>
    <message>
        <source>about</source>
        <translation>축</translation>
    </message>
    <message>
        <source>radius of the circle</source>
        <translation>원의 반지름</translation>
    </message>
    <message>
        <source>least height above the supports</source>
        <translation>지지점 위 최소 높이</translation>
    </message>
    <message>
        <source>greatest height</source>
        <translation>최대 높이</translation>
    </message>
    <message>
        <source>Sensors of the network</source>
        <translation>네트워크의 센서</translation>
    </message>
    <message>
        <source>reads</source>
        <translation>읽는 값</translation>
    </message>
    <message>
        <source>Analysis of variance</source>
        <translation>분산분석</translation>
    </message>
    <message>
        <source>source of variation</source>
        <translation>변동 요인</translation>
    </message>
    <message>
        <source>sum of squares</source>
        <translation>제곱합</translation>
    </message>
    <message>
        <source>mean square</source>
        <translation>평균제곱</translation>
    </message>
    <message>
        <source>Components of variance</source>
        <translation>분산 성분</translation>
    </message>
    <message>
        <source>Type A evaluation of observations</source>
        <translation>관측값의 A형 평가</translation>
    </message>
    <message>
        <source>s of one observation</source>
        <translation>한 관측값의 s</translation>
    </message>
    <message>
        <source>u of the mean</source>
        <translation>평균의 u</translation>
    </message>
    <message>
        <source>number of the observation</source>
        <translation>관측 번호</translation>
    </message>
    <message>
        <source>Points and their residuals</source>
        <translation>점과 그 잔차</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>잔차</translation>
    </message>
    <message>
        <source>Analysis of variance of the fit</source>
        <translation>맞춤의 분산분석</translation>
    </message>
    <message>
        <source>Uncertainties</source>
        <translation>불확도</translation>
    </message>
    <message>
        <source>output</source>
        <translation>출력량</translation>
    </message>
    <message>
        <source>U by Monte Carlo</source>
        <translation>몬테카를로의 U</translation>
    </message>
    <message>
        <source>validated (clause 8)</source>
        <translation>검증됨 (8절)</translation>
    </message>
    <message>
        <source>cost per unit of target</source>
        <translation>목표 단위당 비용</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>값</translation>
    </message>
    <message>
        <source>variable</source>
        <translation>변수</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>선택됨</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>허용차</translation>
    </message>
    <message>
        <source>Rows that are kept</source>
        <translation>유지되는 행</translation>
    </message>
    <message>
        <source>row</source>
        <translation>행</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>고정</translation>
    </message>
    <message>
        <source>of the candidates&apos; file</source>
        <translation>후보 파일에서</translation>
    </message>
    <message>
        <source>objective without it</source>
        <translation>없을 때의 목적값</translation>
    </message>
    <message>
        <source>price</source>
        <translation>가격</translation>
    </message>
    <message>
        <source>Candidates and what they gain</source>
        <translation>후보와 그 이득</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>이득</translation>
    </message>
    <message>
        <source>What would be gained without the uncertainty of</source>
        <translation>다음 불확도가 없을 때의 이득</translation>
    </message>
    <message>
        <source>Objective and number of rows</source>
        <translation>목적값과 행 수</translation>
    </message>
    <message>
        <source>objective</source>
        <translation>목적값</translation>
    </message>
    <message>
        <source>change</source>
        <translation>변화</translation>
    </message>
    <message>
        <source>Cost and uncertainty</source>
        <translation>비용과 불확도</translation>
    </message>
    <message>
        <source>Improvements</source>
        <translation>개선</translation>
    </message>
    <message>
        <source>evaluation</source>
        <translation>평가</translation>
    </message>
    <message>
        <source>search</source>
        <translation>탐색</translation>
    </message>
    <message>
        <source>Candidates without result</source>
        <translation>결과가 없는 후보</translation>
    </message>
    <message>
        <source>count</source>
        <translation>개수</translation>
    </message>
    <message>
        <source>U without %1</source>
        <translation>%1 없는 U</translation>
    </message>
    <message>
        <source>Expanded uncertainty that remains when everything %1 brings in is kept constant (an ideal one), by the law of propagation</source>
        <translation>%1이(가) 가져오는 모든 것을 일정하게 둘 때(이상적인 것) 남는 확장불확도, 전파 법칙에 의함</translation>
    </message>
    <message>
        <source>Expanded uncertainty that remains when everything %1 brings in is kept constant (an ideal one), by Monte Carlo</source>
        <translation>%1이(가) 가져오는 모든 것을 일정하게 둘 때(이상적인 것) 남는 확장불확도, 몬테카를로에 의함</translation>
    </message>
    <message>
        <source>symbol of the quantity</source>
        <translation>양의 기호</translation>
    </message>
    <message>
        <source>what it is</source>
        <translation>무엇인지</translation>
    </message>
    <message>
        <source>estimate</source>
        <translation>추정값</translation>
    </message>
    <message>
        <source>unit of estimate and uncertainty</source>
        <translation>추정값과 불확도의 단위</translation>
    </message>
    <message>
        <source>uncertainty before the divisor</source>
        <translation>나눗수로 나누기 전의 불확도</translation>
    </message>
    <message>
        <source>half-width of the limits</source>
        <translation>한계의 반너비</translation>
    </message>
    <message>
        <source>divisor, coverage factor k</source>
        <translation>나눗수, 포함인자 k</translation>
    </message>
    <message>
        <source>sensitivity coefficient</source>
        <translation>감도계수</translation>
    </message>
    <message>
        <source>contribution to u(y)</source>
        <translation>u(y)에 대한 기여</translation>
    </message>
    <message>
        <source>where the figure comes from</source>
        <translation>수치의 출처</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>읽지 않음</translation>
    </message>
    <message>
        <source>name of the point</source>
        <translation>점의 이름</translation>
    </message>
    <message>
        <source>standard uncertainty of x, y, z</source>
        <translation>x, y, z의 표준불확도</translation>
    </message>
    <message>
        <source>standard uncertainty of x</source>
        <translation>x의 표준불확도</translation>
    </message>
    <message>
        <source>standard uncertainty of y</source>
        <translation>y의 표준불확도</translation>
    </message>
    <message>
        <source>standard uncertainty of z</source>
        <translation>z의 표준불확도</translation>
    </message>
    <message>
        <source>expanded uncertainty of x, y, z, k = 2</source>
        <translation>x, y, z의 확장불확도, k = 2</translation>
    </message>
    <message>
        <source>expanded uncertainty of x, k = 2</source>
        <translation>x의 확장불확도, k = 2</translation>
    </message>
    <message>
        <source>expanded uncertainty of y, k = 2</source>
        <translation>y의 확장불확도, k = 2</translation>
    </message>
    <message>
        <source>expanded uncertainty of z, k = 2</source>
        <translation>z의 확장불확도, k = 2</translation>
    </message>
    <message>
        <source>Kind of change</source>
        <translation>변화의 종류</translation>
    </message>
    <message>
        <source>Fields of the set-up</source>
        <translation>설정의 항목</translation>
    </message>
    <message>
        <source>Equations as evaluated</source>
        <translation>평가되는 그대로의 식</translation>
    </message>
    <message>
        <source>References</source>
        <translation>참고 문헌</translation>
    </message>
    <message>
        <source>Options of the evaluation</source>
        <translation>평가 옵션</translation>
    </message>
    <message>
        <source>What a calibration certificate says beside its results, with the clause of ISO/IEC 17025:2017 that asks for it.</source>
        <translation>교정 성적서가 결과 외에 말하는 내용과 그것을 요구하는 ISO/IEC 17025:2017의 조항.</translation>
    </message>
    <message>
        <source>optional</source>
        <translation>선택</translation>
    </message>
    <message>
        <source>default %1</source>
        <translation>기본값 %1</translation>
    </message>
    <message>
        <source>Choices: </source>
        <translation>선택지: </translation>
    </message>
    <message>
        <source>required by %1</source>
        <translation>%1에서 필수로 요구</translation>
    </message>
    <message>
        <source>asked for by %1</source>
        <translation>%1에서 요구</translation>
    </message>
    <message>
        <source>integer</source>
        <translation>정수</translation>
    </message>
    <message>
        <source>choice</source>
        <translation>선택</translation>
    </message>
    <message>
        <source>text</source>
        <translation>텍스트</translation>
    </message>
    <message>
        <source>flag</source>
        <translation>예 또는 아니요</translation>
    </message>
    <message>
        <source>table</source>
        <translation>표</translation>
    </message>
    <message>
        <source>reference to an asset</source>
        <translation>에셋에 대한 참조</translation>
    </message>
    <message>
        <source>real number</source>
        <translation>실수</translation>
    </message>
    <message>
        <source>Position and orientation of a moving frame in a base frame, both defined by measured points: the platform of a robot measured with a total station or laser tracker.</source>
        <translation>베이스 좌표계에 대한 움직이는 좌표계의 위치와 방향. 둘 다 측정한 점으로 정합니다. 토털 스테이션이나 레이저 트래커로 측정한 로봇의 플랫폼.</translation>
    </message>
    <message>
        <source>Eq 19 is corrected: o_p − o_b must be expressed in the base frame. As printed, the pose does not depend on the orientation of the base, and U(x) of all poses is the same.</source>
        <translation>식 19를 바로잡음: o_p − o_b는 베이스 좌표계로 나타내야 합니다. 인쇄된 대로면 포즈가 베이스의 방향에 따르지 않고 모든 포즈의 U(x)가 같습니다.</translation>
    </message>
    <message>
        <source>Eq 20 is corrected: R = R_bᵀ R_p. The printed R_p R_bᵀ is the same rotation expressed in frame 0.</source>
        <translation>식 20을 바로잡음: R = R_bᵀ R_p. 인쇄된 R_p R_bᵀ는 좌표계 0에서 나타낸 같은 회전입니다.</translation>
    </message>
    <message>
        <source>Eqs 21-23 are corrected: as printed they are Z-Y-Z angles, undefined without tilt; the text and Table 3 use Z-Y-X angles, R = Rz(γ) Ry(β) Rx(α).</source>
        <translation>식 21-23을 바로잡음: 인쇄된 것은 기울기가 없으면 정해지지 않는 Z-Y-Z 각입니다. 본문과 표 3은 Z-Y-X 각, R = Rz(γ) Ry(β) Rx(α)를 씁니다.</translation>
    </message>
    <message>
        <source>b₃ lies at negative y of its frame (Eq 10) and p₃ at positive y of its own (Eq 14); other arrangements can be chosen.</source>
        <translation>b₃는 그 좌표계의 음의 y에(식 10), p₃는 자신의 양의 y에(식 14) 있습니다. 다른 배치를 고를 수 있습니다.</translation>
    </message>
    <message>
        <source>Typed uncertainties lie along the axes of the frame that the points define (those of the moving frame along the base&apos;s on request) and are turned into frame 0; those of an instrument lie along and across its line of sight.</source>
        <translation>입력한 불확도는 점이 정하는 좌표계의 축을 따르며(움직이는 좌표계의 것은 요청하면 베이스의 축) 좌표계 0으로 돌려집니다. 측정기의 불확도는 시준선 방향과 그 직각 방향입니다.</translation>
    </message>
    <message>
        <source>Measured points of a least-squares frame are tested against their nominal coordinates: residuals, redundancy, chi-square with the full covariance of the stated uncertainties.</source>
        <translation>최소제곱 좌표계의 측정점은 공칭 좌표에 대해 시험합니다. 잔차, 여유도, 제시된 불확도의 전체 공분산에 의한 카이제곱.</translation>
    </message>
    <message>
        <source>All poses of an analysis share one measurement of the base, so their results are correlated.</source>
        <translation>한 분석의 모든 포즈는 베이스의 측정 하나를 공유하므로 결과가 상관됩니다.</translation>
    </message>
    <message>
        <source>The uncertainty of the mean of repeated measurements (a posteriori) is taken as that of one measurement, as in the paper: the systematic part does not average out.</source>
        <translation>반복 측정 평균의 불확도(사후)는 논문처럼 한 번 측정의 불확도로 봅니다. 계통 부분은 평균으로 없어지지 않습니다.</translation>
    </message>
    <message>
        <source>Angles are undefined in gimbal lock; the set-up then warns. Rotation vector and quaternion are free of it.</source>
        <translation>짐벌락에서는 각도가 정해지지 않으며 측정 구성이 경고합니다. 회전 벡터와 사원수에는 그 문제가 없습니다.</translation>
    </message>
    <message>
        <source>Coordinates of targets and distances between them, measured by any mix of trackers, total stations, cameras and distance meters placed in space.</source>
        <translation>공간에 놓인 트래커, 토털 스테이션, 카메라, 거리계를 임의로 섞어 측정한 표적의 좌표와 그 사이의 거리.</translation>
    </message>
    <message>
        <source>The uncertainty of the stations does not contribute marginally to the position of a target, as the paper says: only distances within one set-up are nearly free of it. Eq 5 is the precision of the readings; it is shown beside the total, never as the uncertainty of a position.</source>
        <translation>스테이션의 불확도는 논문의 말처럼 표적 위치에 미미하게 기여하지 않습니다. 한 설치 안의 거리만 거의 영향을 받지 않습니다. 식 5는 읽음값의 정밀도이며, 전체 옆에 보일 뿐 위치의 불확도로 보이지 않습니다.</translation>
    </message>
    <message>
        <source>Weights from the readings alone, as in the paper, are inefficient for positions; those with the stations are the default.</source>
        <translation>논문처럼 읽음값만의 가중치는 위치에 비효율적입니다. 스테이션을 포함한 가중치가 기본입니다.</translation>
    </message>
    <message>
        <source>Eq 2 is corrected: D holds equations by readings; as printed it is transposed.</source>
        <translation>식 2를 바로잡음: D는 식 × 읽음값입니다. 인쇄된 것은 전치되어 있습니다.</translation>
    </message>
    <message>
        <source>The linearised equations have the measured angles in M: their estimate shrinks towards the sensors, the non-linear one moves outwards by half as much. It matters beyond a milliradian (3.5 mrad, cameras alone: −6.9 mm against +3.3 mm) and not for the paper&apos;s network.</source>
        <translation>선형화한 식의 M에는 측정한 각도가 있습니다. 그 추정은 센서 쪽으로 줄어들고 비선형 추정은 그 절반만큼 바깥으로 움직입니다. 1밀리라디안을 넘을 때 문제가 되며(3.5 mrad, 카메라만: −6.9 mm 대 +3.3 mm) 논문의 네트워크에서는 그렇지 않습니다.</translation>
    </message>
    <message>
        <source>Stations are located once for a set-up: all its targets share their deviations. &quot;New set-up&quot; at a target draws them anew.</source>
        <translation>스테이션은 한 설치에 한 번 위치를 정합니다. 모든 표적이 그 편차를 공유합니다. 표적의 &quot;새 설치&quot;는 편차를 다시 추출합니다.</translation>
    </message>
    <message>
        <source>A distance without angles has no linear equation; the non-linear estimator uses it, from the nominal coordinates as start.</source>
        <translation>각도 없는 거리에는 선형 식이 없습니다. 비선형 추정은 공칭 좌표를 시작으로 그것을 씁니다.</translation>
    </message>
    <message>
        <source>A calibrated length as a check is not used in the estimation: its difference is to be judged by its uncertainty. As a constraint it carries its own uncertainty; a scale that the instruments share is corrected by it.</source>
        <translation>점검으로서의 교정된 길이는 추정에 쓰지 않으며 그 차를 불확도로 판단합니다. 구속이면 자체 불확도를 가지며, 측정기가 공유하는 척도가 그것으로 보정됩니다.</translation>
    </message>
    <message>
        <source>With more than 600 readings in one set-up each target is estimated by itself, weighted with the stations.</source>
        <translation>한 설치의 읽음값이 600개를 넘으면 표적마다 따로, 스테이션과 함께 가중하여 추정합니다.</translation>
    </message>
    <message>
        <source>Azimuths may be given with any number of whole turns.</source>
        <translation>방위각은 몇 바퀴를 더해 제시해도 됩니다.</translation>
    </message>
    <message>
        <source>The tool centre point of a robot: the flange turns about its own axes, telescopic ballbars measure where the ball at the tool goes, and planes and a sphere give the flange&apos;s axes and centre.</source>
        <translation>로봇의 공구 중심점. 플랜지를 자신의 축 둘레로 돌리며 신축식 볼바로 공구의 구가 가는 곳을 측정하고, 평면과 구로 플랜지의 축과 중심을 구합니다.</translation>
    </message>
    <message>
        <source>The paper states neither the tool, nor the flange&apos;s orientation, start angles, how the frame is made, nor how the points are averaged. With a tool of (0, 0, 100) mm, the flange pointing down, arcs from -60° to 140° and from -90° to 90° and u(L) = 1.55 µm, the published values reproduce within 1.5 % (root mean square).</source>
        <translation>논문은 공구, 플랜지의 방향, 시작각, 좌표계를 만드는 방법, 점을 평균하는 방법을 밝히지 않습니다. 공구 (0, 0, 100) mm, 아래를 향한 플랜지, -60°~140°와 -90°~90°의 호, u(L) = 1.55 µm이면 발표된 값이 1.5 %(제곱평균제곱근) 안에서 재현됩니다.</translation>
    </message>
    <message>
        <source>U(TCP): published 8.2, 11.1, 5.1 µm; here 8.16, 10.92, 5.00 µm: reproduces.</source>
        <translation>U(TCP): 발표값 8.2, 11.1, 5.1 µm. 여기 8.16, 10.92, 5.00 µm: 재현됨.</translation>
    </message>
    <message>
        <source>U(TCP) with an ideal robot: published 2.8, 3.7, 1.6 µm; here 2.77, 3.61, 1.57 µm: reproduces.</source>
        <translation>이상적인 로봇의 U(TCP): 발표값 2.8, 3.7, 1.6 µm. 여기 2.77, 3.61, 1.57 µm: 재현됨.</translation>
    </message>
    <message>
        <source>U of the axes&apos; angles XY, XZ, YX, YZ: published 79, 87, 59, 123 µrad; here 78.3, 87.2, 58.5, 120.6 µrad: reproduces.</source>
        <translation>축 사이 각 XY, XZ, YX, YZ의 U: 발표값 79, 87, 59, 123 µrad. 여기 78.3, 87.2, 58.5, 120.6 µrad: 재현됨.</translation>
    </message>
    <message>
        <source>Largest U of a point measured by the ballbars alone: published 5.7, 5.7, 2.4 µm; here 5.83, 5.72, 2.38 µm: reproduces.</source>
        <translation>볼바만으로 측정한 점의 최대 U: 발표값 5.7, 5.7, 2.4 µm. 여기 5.83, 5.72, 2.38 µm: 재현됨.</translation>
    </message>
    <message>
        <source>With the stated U(L) = 4 µm the same geometry gives U(TCP) 8.46, 11.31, 5.16 µm and points up to 7.53, 7.37, 3.07 µm: differs, because the stated 4 µm and the published points cannot both hold. U(z) of a point at most 577 mm above the supports is 2.4 µm only for U(L) near 3.1 µm; all six figures of the instrument alone are 0.78 of what 4 µm gives.</source>
        <translation>제시된 U(L) = 4 µm이면 같은 기하에서 U(TCP) 8.46, 11.31, 5.16 µm, 점은 최대 7.53, 7.37, 3.07 µm: 다름. 제시된 4 µm와 발표된 점이 함께 성립할 수 없기 때문입니다. 받침 위 최대 577 mm인 점의 U(z)가 2.4 µm인 것은 U(L)이 3.1 µm 부근일 때뿐입니다. 측정기만의 여섯 수치는 모두 4 µm가 주는 값의 0.78배입니다.</translation>
    </message>
    <message>
        <source>The centre of the sphere is the centre of the flange, not the tool centre point as section 4 says: its U is 5.96, 7.42, 6.94 µm.</source>
        <translation>구의 중심은 4절의 말처럼 공구 중심점이 아니라 플랜지의 중심입니다. 그 U는 5.96, 7.42, 6.94 µm입니다.</translation>
    </message>
    <message>
        <source>Eq 8 needs perpendicular axes, which two measured normals are not: U(x) of the tool is 8.16, 8.37 or 8.66 µm with y first, symmetric or x first.</source>
        <translation>식 8에는 직교하는 축이 필요한데 측정한 두 법선은 그렇지 않습니다. 공구의 U(x)는 y 먼저, 대칭, x 먼저일 때 8.16, 8.37, 8.66 µm입니다.</translation>
    </message>
    <message>
        <source>A trial whose lengths do not meet (negative root of Eq 3) has no value: it is counted and reported.</source>
        <translation>길이들이 만나지 않는 시행(식 3의 음의 근)에는 값이 없습니다. 세어서 보고합니다.</translation>
    </message>
    <message>
        <source>Position and orientation of the tool of a serial robot from its geometric parameters and joint readings.</source>
        <translation>기하 파라미터와 관절 읽음값에서 구한 직렬 로봇 공구의 위치와 방향.</translation>
    </message>
    <message>
        <source>The paper calls the model highly non-linear. At the uncertainties of its Table 1 it is not: the law of propagation and Monte Carlo agree to 4e-5 mm in u, and the laws are normal.</source>
        <translation>논문은 모델이 매우 비선형이라고 합니다. 표 1의 불확도에서는 그렇지 않습니다. 전파 법칙과 몬테카를로의 u가 4e-5 mm까지 일치하고 분포가 정규입니다.</translation>
    </message>
    <message>
        <source>The tolerance 0.0001 of the paper has no unit. In millimetres it would need 5e9 trials; in metres it is 0.1 mm, and 20 000 trials do.</source>
        <translation>논문의 허용오차 0.0001에는 단위가 없습니다. 밀리미터이면 시행 5e9회가 필요하고, 미터이면 0.1 mm로 20 000회면 됩니다.</translation>
    </message>
    <message>
        <source>The paper takes the parameters as uncorrelated. Parameters identified together are strongly correlated; an identified robot carries their full covariance into this analysis, which lowers u by up to a factor of 12.</source>
        <translation>논문은 파라미터를 상관이 없는 것으로 봅니다. 함께 식별한 파라미터는 강하게 상관되며, 식별된 로봇은 전체 공분산을 이 분석에 가져와 u를 최대 12분의 1로 줄입니다.</translation>
    </message>
    <message>
        <source>Of two readings of section 4.1 (0.01 rad for theta alone, or for all angles) both are reproduced; that theta matters more than alpha holds only where its standard deviation is ten times larger.</source>
        <translation>4.1절의 두 해석(theta만 0.01 rad, 또는 모든 각도)이 모두 재현됩니다. theta가 alpha보다 중요하다는 것은 그 표준편차가 열 배 클 때만 성립합니다.</translation>
    </message>
    <message>
        <source>Readings of the joints deviate anew at each pose; parameters and tool are the same for all poses of an analysis.</source>
        <translation>관절의 읽음값은 포즈마다 새로 어긋나며, 파라미터와 공구는 한 분석의 모든 포즈에서 같습니다.</translation>
    </message>
    <message>
        <source>Geometric parameters of a serial robot from points measured while one joint after the other turns (circle point analysis).</source>
        <translation>관절을 하나씩 돌리며 측정한 점에서 구한 직렬 로봇의 기하 파라미터(원점 분석).</translation>
    </message>
    <message>
        <source>Eq 4 is corrected: without the square its derivative by R gives R = 0.</source>
        <translation>식 4를 바로잡음: 제곱이 없으면 R에 대한 미분이 R = 0을 줍니다.</translation>
    </message>
    <message>
        <source>2.1.3 is corrected: x_i = z_i × y_i is left-handed.</source>
        <translation>2.1.3을 바로잡음: x_i = z_i × y_i는 왼손 좌표계입니다.</translation>
    </message>
    <message>
        <source>2.1.4 is corrected: alpha_i and beta_i turn z_{i−1} into z_i.</source>
        <translation>2.1.4를 바로잡음: alpha_i와 beta_i는 z_{i−1}을 z_i로 돌립니다.</translation>
    </message>
    <message>
        <source>The auxiliary plane of Figure 2 is not defined in the paper; it must pass through O_{i−1} with the normal z_{i−1}, or d_i = 0 is impossible.</source>
        <translation>그림 2의 보조 평면은 논문에 정의되어 있지 않습니다. z_{i−1}을 법선으로 O_{i−1}을 지나야 하며 그렇지 않으면 d_i = 0이 불가능합니다.</translation>
    </message>
    <message>
        <source>Eq 1 has no plane through the origin and fails near it; total least squares is the default.</source>
        <translation>식 1에는 원점을 지나는 평면이 없고 그 부근에서 실패합니다. 전체 최소제곱이 기본입니다.</translation>
    </message>
    <message>
        <source>Eq 8 is a standard deviation of the mean of repeats. The paper applies it to different ranges and numbers of points, which are no repeats: the ±10° run dominates, and the noise is counted three times. Here the covariance is that of the chosen experiment.</source>
        <translation>식 8은 반복 평균의 표준편차입니다. 논문은 이를 반복이 아닌 서로 다른 범위와 점의 수에 적용합니다. ±10° 측정이 지배하고 잡음을 세 번 셉니다. 여기서 공분산은 선택한 실험의 것입니다.</translation>
    </message>
    <message>
        <source>The standard deviation falls with the square of the range (factor 30 from ±10° to ±60°) and with the root of the number of points.</source>
        <translation>표준편차는 범위의 제곱에 따라(±10°에서 ±60°까지 30배), 점의 수의 제곱근에 따라 줄어듭니다.</translation>
    </message>
    <message>
        <source>Parameters are strongly correlated (d_3 and alpha_3: −0.99): use their full covariance, as an identified robot does.</source>
        <translation>파라미터는 강하게 상관됩니다(d_3과 alpha_3: −0.99). 식별된 로봇처럼 전체 공분산을 쓰십시오.</translation>
    </message>
    <message>
        <source>Every joint needs a ball off its axis; at the paper&apos;s flange origin joint 6 draws no circle.</source>
        <translation>모든 관절에 축에서 벗어난 구가 필요합니다. 논문의 플랜지 원점에서는 관절 6이 원을 그리지 않습니다.</translation>
    </message>
    <message>
        <source>Geometric parameters of a serial robot by least squares from measured positions or poses of its tool, with observability, residuals and validation.</source>
        <translation>측정한 공구 위치나 포즈에서 최소제곱으로 구한 직렬 로봇의 기하 파라미터. 가관측성, 잔차, 검증 포함.</translation>
    </message>
    <message>
        <source>The paper identifies parameters by joint trajectories; least squares on measured positions or poses is the other usual way, with the same model of the arm (Eq 5).</source>
        <translation>논문은 관절 궤적으로 파라미터를 식별합니다. 측정한 위치나 포즈에 대한 최소제곱은 같은 팔 모델(식 5)을 쓰는 또 다른 일반적 방법입니다.</translation>
    </message>
    <message>
        <source>Parameters that the poses cannot tell are found by their columns of the Jacobian: each that is a combination of those before it (base, then ball or tool, then joint by joint) stays nominal and is named with its partners.</source>
        <translation>포즈로 구할 수 없는 파라미터는 야코비 행렬의 열로 찾습니다. 앞의 것들(베이스, 다음 구나 공구, 다음 관절 순서)의 조합인 것은 공칭값으로 두고 상대와 함께 이름을 보입니다.</translation>
    </message>
    <message>
        <source>Weights are the inverse variances of the measured coordinates. Shared deviations of an instrument and the readings of the joints do not change the weights, but are propagated in full.</source>
        <translation>가중치는 측정한 좌표의 분산의 역수입니다. 측정기의 공통 편차와 관절의 읽음값은 가중치를 바꾸지 않지만 온전히 전파됩니다.</translation>
    </message>
    <message>
        <source>In each trial the gain of the estimates is used. It differs from a complete fit by residual times curvature, below 1e-9 m here.</source>
        <translation>시행마다 추정값에서의 이득을 씁니다. 완전한 맞춤과의 차이는 잔차 × 곡률로, 여기서 1e-9 m 미만입니다.</translation>
    </message>
    <message>
        <source>Position alone does not tell the last joint&apos;s parameters from the place of the ball; a known base and a known ball leave more to find.</source>
        <translation>위치만으로는 마지막 관절의 파라미터와 구의 위치를 구별할 수 없습니다. 베이스와 구를 알면 더 많은 것을 구할 수 있습니다.</translation>
    </message>
    <message>
        <source>The uncertainty of each channel of a multi-axis force/moment sensor, used alone or while unknown loads act on its other axes; by the GUM, with the paper&apos;s evaluation beside it.</source>
        <translation>다축 힘/모멘트 센서 각 채널의 불확도. 단독으로 쓰거나 알 수 없는 하중이 다른 축에 작용할 때. GUM에 따르며 논문의 평가를 함께 보입니다.</translation>
    </message>
    <message>
        <source>U of the paper: 0.91, 1.22, 1.67, 1.68, 2.78, 1.20 % of rated output: reproduces.</source>
        <translation>논문의 U: 정격출력의 0.91, 1.22, 1.67, 1.68, 2.78, 1.20 %: 재현됨.</translation>
    </message>
    <message>
        <source>By the GUM (k = 2) with unknown loads on the other five axes: 1.446, 1.425, 2.123, 2.637, 2.990, 1.388 %. With all others at rated load interference alone reaches 2.70, 2.12, 3.33, 4.59, 3.70, 2.27 %, more than U of the paper for all six: its linear sum is no bound.</source>
        <translation>GUM에 따라(k = 2), 다른 다섯 축에 알 수 없는 하중이 있을 때: 1.446, 1.425, 2.123, 2.637, 2.990, 1.388 %. 다른 모두가 정격하중이면 간섭만으로 2.70, 2.12, 3.33, 4.59, 3.70, 2.27 %에 이르러 여섯 모두 논문의 U를 넘습니다. 선형 합은 한계가 아닙니다.</translation>
    </message>
    <message>
        <source>Monte Carlo intervals are a little shorter than k = 2 because a few rectangular loads dominate.</source>
        <translation>몇몇 직사각형 분포의 하중이 지배하므로 몬테카를로 구간은 k = 2보다 조금 짧습니다.</translation>
    </message>
    <message>
        <source>The load on an axis is one quantity in the equations of all channels, which correlates them.</source>
        <translation>한 축의 하중은 모든 채널의 식에서 하나의 양이며 채널들을 상관시킵니다.</translation>
    </message>
    <message>
        <source>With n = 3 a standard deviation has two degrees of freedom. Used alone a channel has effective degrees of freedom between 20 and 140, because its repeatability is a small part.</source>
        <translation>n = 3이면 표준편차의 자유도는 2입니다. 채널을 단독으로 쓰면 반복성이 작은 부분이므로 유효자유도는 20과 140 사이입니다.</translation>
    </message>
    <message>
        <source>Not covered: misalignment of the loads, creep, temperature, remounting.</source>
        <translation>포함하지 않음: 하중의 정렬 불량, 크리프, 온도, 재장착.</translation>
    </message>
    <message>
        <source>Forces and moments that act together, from the readings of all channels of a multi-axis sensor: the calibration matrix takes the interference between them away.</source>
        <translation>다축 센서의 모든 채널의 읽음값에서 구한, 함께 작용하는 힘과 모멘트. 교정 행렬이 채널 사이의 간섭을 없앱니다.</translation>
    </message>
    <message>
        <source>Kim prints no signs of the interference: nothing can be compensated from the paper. The readings of the example have signs of their own.</source>
        <translation>Kim은 간섭의 부호를 인쇄하지 않았습니다. 논문으로는 아무것도 보상할 수 없습니다. 예제의 읽음값에는 자체 부호가 있습니다.</translation>
    </message>
    <message>
        <source>U (k = 2) in % of rated load with all six axes at rated load: 0.184, 0.192, 0.152, 0.226, 0.219, 0.261; without load 0.149, 0.159, 0.144, 0.188, 0.179, 0.180. Compensation lowers the uncertainty under combined loads by a factor of 5 to 13 against U of the paper.</source>
        <translation>여섯 축 모두 정격하중일 때 정격하중에 대한 % U (k = 2): 0.184, 0.192, 0.152, 0.226, 0.219, 0.261. 무부하에서 0.149, 0.159, 0.144, 0.188, 0.179, 0.180. 보상은 복합 하중에서의 불확도를 논문의 U에 비해 5~13분의 1로 줄입니다.</translation>
    </message>
    <message>
        <source>Without compensation the same loads are told wrong by -0.73, +2.05, -1.42, -2.72, +2.90, -1.54 %.</source>
        <translation>보상하지 않으면 같은 하중이 -0.73, +2.05, -1.42, -2.72, +2.90, -1.54 % 틀립니다.</translation>
    </message>
    <message>
        <source>The machine&apos;s deviation is common to all readings under one load: a column of the matrix, and so a scale of the load on that axis.</source>
        <translation>시험기의 편차는 한 하중의 모든 읽음값에 공통입니다. 행렬의 한 열, 곧 그 축 하중의 척도입니다.</translation>
    </message>
    <message>
        <source>Repeatability is that of one reading, the largest of the steps; hysteresis is rectangular over the loop, in proportion to the load.</source>
        <translation>반복성은 읽음값 하나의 것으로 단계 중 가장 큰 값이며, 히스테리시스는 고리에서 하중에 비례하는 직사각형 분포입니다.</translation>
    </message>
    <message>
        <source>Not covered: products of loads in the interference, misalignment of loads, creep, temperature, remounting.</source>
        <translation>포함하지 않음: 간섭에서 하중의 곱, 하중의 정렬 불량, 크리프, 온도, 재장착.</translation>
    </message>
    <message>
        <source>Sensitivity coefficients are exact (automatic differentiation); those of unknowns that equations define implicitly follow JCGM 102 6.3.</source>
        <translation>감도계수는 정확합니다(자동 미분). 식이 음함수로 정의하는 미지수의 것은 JCGM 102 6.3을 따릅니다.</translation>
    </message>
    <message>
        <source>JCGM 100 H.1, H.2 and JCGM 101 9.2 to 9.5, JCGM 102 9.2 to 9.4 are examples in projects/gum: covaria verify holds them against their published values.</source>
        <translation>JCGM 100 H.1, H.2, JCGM 101 9.2~9.5, JCGM 102 9.2~9.4는 projects/gum의 예제입니다. covaria verify가 발표된 값과 대조합니다.</translation>
    </message>
    <message>
        <source>A straight line or polynomial through the points of a calibration by least squares, with uncertainties in y and in x: the covariance of its coefficients, its values, and the x that belong to observed y, with their uncertainties.</source>
        <translation>y와 x에 모두 불확도가 있는 교정점을 지나는 최소제곱 직선 또는 다항식. 계수의 공분산, 그 값, 관측된 y에 해당하는 x와 그 불확도.</translation>
    </message>
    <message>
        <source>Computed with polynomials that are orthonormal over the points, so results do not depend on the origin, up to degree 10. From the residuals their coefficients are drawn from a multivariate t distribution: one estimate of the scatter, n - p degrees of freedom for every result.</source>
        <translation>점 위에서 정규직교인 다항식으로 계산하므로 10차까지 결과가 원점에 따르지 않습니다. 잔차에서 구할 때 계수는 다변량 t 분포에서 추출합니다. 산포의 추정 하나, 모든 결과의 자유도는 n - p입니다.</translation>
    </message>
    <message>
        <source>JCGM 100 H.3, published y₁ = −0.1712 °C, y₂ = 0.002 18, u(y₁) = 0.0029 °C, u(y₂) = 0.000 67, b(30 °C) = −0.1494 °C with u = 0.0041 °C: reproduces.</source>
        <translation>JCGM 100 H.3, 발표값 y₁ = −0.1712 °C, y₂ = 0.002 18, u(y₁) = 0.0029 °C, u(y₂) = 0.000 67, b(30 °C) = −0.1494 °C, u = 0.0041 °C: 재현됨.</translation>
    </message>
    <message>
        <source>The uncertainty of b(x) is that of the curve: the scatter of a further observation is not part of it.</source>
        <translation>b(x)의 불확도는 곡선의 불확도입니다. 또 다른 관측의 산포는 포함되지 않습니다.</translation>
    </message>
    <message>
        <source>The mean of observations made on several days, with several instruments or by several operators, and an analysis of variance that says whether these have an effect.</source>
        <translation>여러 날, 여러 측정기 또는 여러 측정자가 한 관측의 평균과, 이들이 영향을 주는지 알려 주는 분산분석.</translation>
    </message>
    <message>
        <source>Groups may have different numbers of observations; n_0 = (N − Σ n_j²/N)/(J − 1) is then their size in the components of variance.</source>
        <translation>그룹마다 관측 수가 다를 수 있습니다. 그때 분산 성분에서의 크기는 n_0 = (N − Σ n_j²/N)/(J − 1)입니다.</translation>
    </message>
    <message>
        <source>JCGM 100 H.5, published V̄ = 10.000 097 V, s(V̄_j) = 57 µV, s_b = 85 µV, u(V̄) = 18 µV with nine degrees of freedom, or 13 µV with 49 without an effect of the days: reproduces.</source>
        <translation>JCGM 100 H.5, 발표값 V̄ = 10.000 097 V, s(V̄_j) = 57 µV, s_b = 85 µV, u(V̄) = 18 µV, 자유도 9, 또는 날짜의 영향이 없으면 13 µV, 자유도 49: 재현됨.</translation>
    </message>
    <message>
        <source>A plate or frame with calibrated nests, measured repeatedly where the real points will be. Its errors of indication give the uncertainty of each coordinate of a measured point.</source>
        <translation>교정된 받침점이 있는 판이나 틀을 실제 점이 있을 곳에서 반복 측정합니다. 그 지시 오차가 측정점 각 좌표의 불확도를 줍니다.</translation>
    </message>
    <message>
        <source>u_i² = u_cal² + u_var,i² + u_T,i² + b_i² (Eq 2) with u_T = L_max α ΔT/√3 (Eq 3).</source>
        <translation>u_i² = u_cal² + u_var,i² + u_T,i² + b_i² (식 2), u_T = L_max α ΔT/√3 (식 3).</translation>
    </message>
    <message>
        <source>The paper draws all parts independently for each point; calibration, temperature and bias are in truth common to all points, which can be chosen.</source>
        <translation>논문은 점마다 모든 부분을 독립적으로 추출합니다. 교정, 온도, 편의는 실제로 모든 점에 공통이며 그렇게 고를 수 있습니다.</translation>
    </message>
    <message>
        <source>The noise of the three points that define the artefact&apos;s frame is part of the errors of the others; the errors of the defining coordinates themselves are never observed.</source>
        <translation>표준기의 좌표계를 정하는 세 점의 잡음은 다른 점의 오차의 일부입니다. 정하는 좌표 자체의 오차는 관측되지 않습니다.</translation>
    </message>
    <message>
        <source>A bar of calibrated length, measured in many positions and orientations. Its errors of indication give one figure for every coordinate of a measured point.</source>
        <translation>교정된 길이의 막대를 여러 위치와 방향에서 측정합니다. 그 지시 오차가 측정점의 모든 좌표에 수치 하나를 줍니다.</translation>
    </message>
    <message>
        <source>u² = u_cal² + u_var² + u_T² + b² (Eq 5) with u_T = L α ΔT/√3 (Eq 6).</source>
        <translation>u² = u_cal² + u_var² + u_T² + b² (식 5), u_T = L α ΔT/√3 (식 6).</translation>
    </message>
    <message>
        <source>A length is a difference of two points: dividing by √2 would be consistent; the paper does not.</source>
        <translation>길이는 두 점의 차이므로 √2로 나누는 것이 일관되지만 논문은 그렇게 하지 않습니다.</translation>
    </message>
    <message>
        <source>A sensor that stands somewhere and reads a distance, two angles, or some of them. Its uncertainty: each reading for itself, what all its readings share, and where it stands.</source>
        <translation>어딘가에 서서 거리, 두 각도 또는 그 일부를 읽는 센서. 그 불확도: 각 읽음값 자체의 것, 모든 읽음값이 공유하는 것, 그리고 서 있는 곳.</translation>
    </message>
    <message>
        <source>The distance has the figure a + b L, each angle its own; these are independent from reading to reading. Scale, zero, index, collimation, squareness, beam offset and refraction are shared by all readings.</source>
        <translation>거리의 수치는 a + b L, 각도는 각각의 것이며 읽음값마다 독립입니다. 척도, 영점, 지표, 시준, 직각도, 빔 편심, 굴절은 모든 읽음값이 공유합니다.</translation>
    </message>
    <message>
        <source>Only a sensor that reads a distance and both angles can say by itself where a point is.</source>
        <translation>거리와 두 각도를 읽는 센서만이 혼자서 점의 위치를 말할 수 있습니다.</translation>
    </message>
    <message>
        <source>Instruments of the project that measure the same points together. Points measured by the network keep what they share: the scale and the station of each instrument.</source>
        <translation>같은 점을 함께 측정하는 프로젝트의 측정기들. 네트워크로 측정한 점은 공유하는 것, 곧 각 측정기의 척도와 스테이션을 유지합니다.</translation>
    </message>
    <message>
        <source>A point&apos;s deviations are the least-squares gain times those of the readings and stations, linearised at the point: exact to first order, and in Monte Carlo as long as the angles&apos; deviations stay below about a milliradian.</source>
        <translation>점의 편차는 최소제곱 이득 × 읽음값과 스테이션의 편차이며 그 점에서 선형화합니다. 일차에서 정확하고, 몬테카를로에서는 각도의 편차가 약 1밀리라디안 미만이면 정확합니다.</translation>
    </message>
    <message>
        <source>All points that an analysis takes from the network are measured from one set-up: none of its instruments is moved or located anew between them.</source>
        <translation>분석이 네트워크에서 가져오는 모든 점은 한 설치에서 측정됩니다. 그 사이에 어떤 측정기도 옮기거나 다시 위치를 정하지 않습니다.</translation>
    </message>
    <message>
        <source>A sensor contributes to a point that is in its range and field of view, and no others.</source>
        <translation>센서는 범위와 시야 안에 있는 점에만 기여합니다.</translation>
    </message>
    <message>
        <source>One figure of a data sheet for all coordinates: a standard uncertainty or a maximum permissible error.</source>
        <translation>모든 좌표에 대한 데이터 시트의 수치 하나. 표준불확도 또는 최대허용오차.</translation>
    </message>
    <message>
        <source>A specification taken alike in all directions overestimates, by a factor of 2 to 5 in the paper&apos;s example; an instrument that stands somewhere (spherical instrument) is closer to the truth.</source>
        <translation>모든 방향에 같게 본 사양은 논문의 예에서 2~5배 과대평가합니다. 어딘가에 서 있는 측정기(구면 측정기)가 사실에 더 가깝습니다.</translation>
    </message>
    <message>
        <source>Three or more telescopic ballbars that measure the lengths from their supports to one ball at once, and with it where the ball is.</source>
        <translation>받침에서 구 하나까지의 길이를 동시에 측정하는 신축식 볼바 세 개 이상. 그것으로 구의 위치를 알 수 있습니다.</translation>
    </message>
    <message>
        <source>The supports&apos; frame follows from the lengths between them (Eqs 4 to 7), measured once: their deviations are common to all points.</source>
        <translation>받침의 좌표계는 받침 사이의 길이에서 나오며(식 4~7) 한 번 측정합니다. 그 편차는 모든 점에 공통입니다.</translation>
    </message>
    <message>
        <source>Eq 2 as printed has Y_VC3; Y_KS3 is meant. Eq 3 has two roots; the side is a choice here.</source>
        <translation>식 2에 인쇄된 것은 Y_VC3이며 Y_KS3를 뜻합니다. 식 3에는 근이 둘 있으며 여기서 쪽을 고릅니다.</translation>
    </message>
    <message>
        <source>The paper&apos;s supports are called an equilateral triangle of 520 mm; its Table 1 is isosceles, 520 mm and 519.711 mm.</source>
        <translation>논문은 받침을 520 mm의 정삼각형이라고 합니다. 표 1은 520 mm와 519.711 mm의 이등변입니다.</translation>
    </message>
    <message>
        <source>A fourth support and those after it are located by their lengths to the first three at a height that is an input of its own: lengths say nothing about a height above the plane in which all supports lie.</source>
        <translation>네 번째부터의 받침은 처음 세 받침까지의 길이와 별도 입력인 높이로 위치를 정합니다. 길이는 모든 받침이 놓인 평면 위의 높이에 대해 아무것도 말하지 않습니다.</translation>
    </message>
    <message>
        <source>A robot as a source of uncertainty: each time it goes to a pose it misses it by a distance in a random direction, and perhaps by small rotations.</source>
        <translation>불확도의 원천으로서의 로봇. 포즈로 갈 때마다 무작위 방향으로 어떤 거리만큼, 또 작은 회전만큼 어긋납니다.</translation>
    </message>
    <message>
        <source>The paper takes the distance as rectangular in [0, r], r being the data sheet&apos;s ± 0.02 mm; u along an axis is then r/3. RP of ISO 9283 is the mean distance plus three standard deviations, which is another figure: for that law RP = 1.366 r, in a ball 1.331 r, on a sphere r, and 3.616 u for normal coordinates.</source>
        <translation>논문은 거리를 [0, r]의 직사각형 분포로 보며 r은 데이터 시트의 ± 0.02 mm입니다. 그러면 축 방향의 u는 r/3입니다. ISO 9283의 RP는 평균 거리 + 표준편차의 세 배로 다른 수치입니다. 그 분포에서 RP = 1.366 r, 공 안에서 1.331 r, 구면에서 r, 정규 좌표에서 3.616 u입니다.</translation>
    </message>
    <message>
        <source>The paper leaves the orientation out. A rotation by e moves the tool by about e times its length.</source>
        <translation>논문은 방향을 뺍니다. e만큼의 회전은 공구를 약 e × 길이만큼 움직입니다.</translation>
    </message>
    <message>
        <source>An arm of joints that turn or slide: parameters in a Denavit-Hartenberg convention with one or more components of uncertainty each, their correlation, limits, encoders, base and tool.</source>
        <translation>돌거나 미끄러지는 관절의 팔. Denavit-Hartenberg 규약의 파라미터, 각각 하나 이상의 불확도 성분, 그 상관, 한계, 엔코더, 베이스, 공구.</translation>
    </message>
    <message>
        <source>Eq. 5: T = Rz(theta) Tz(d) Tx(a) Rx(alpha) Ry(beta). Where an axis is parallel to the next, beta is a parameter and d is 0 by definition; elsewhere beta is 0.</source>
        <translation>식 5: T = Rz(theta) Tz(d) Tx(a) Rx(alpha) Ry(beta). 축이 다음 축과 평행하면 beta가 파라미터이고 d는 정의에 따라 0이며, 그 밖에는 beta가 0입니다.</translation>
    </message>
    <message>
        <source>alpha and beta of a row turn the axis of the joint into that of the next (the paper&apos;s text shifts them by one joint).</source>
        <translation>한 행의 alpha와 beta는 그 관절의 축을 다음 관절의 축으로 돌립니다(논문의 본문은 한 관절만큼 어긋나 있음).</translation>
    </message>
    <message>
        <source>The joint angle is theta plus the reading less the zero reading; a sliding joint adds its reading to d in the same way.</source>
        <translation>관절각은 theta + 읽음값 − 영점 읽음값입니다. 미끄럼 관절은 같은 방법으로 읽음값을 d에 더합니다.</translation>
    </message>
    <message>
        <source>Loads a multi-axis force/moment sensor with one force or moment at a time.</source>
        <translation>다축 힘/모멘트 센서에 한 번에 힘이나 모멘트 하나를 가합니다.</translation>
    </message>
    <message>
        <source>The uncertainty of a load is common to all readings under loads on that axis: it does not average out in the calibration matrix.</source>
        <translation>하중의 불확도는 그 축의 하중에서 모든 읽음값에 공통입니다. 교정 행렬에서 평균으로 없어지지 않습니다.</translation>
    </message>
    <message>
        <source>Up to three forces and three moments measured at once; calibrated with one load at a time, evaluated from its readings.</source>
        <translation>힘 최대 셋과 모멘트 최대 셋을 동시에 측정합니다. 한 번에 하중 하나로 교정하고 그 읽음값으로 평가합니다.</translation>
    </message>
    <message>
        <source>Tables 1 to 4 reproduce from raw readings that are consistent with them, to the printed digits, with relative uncertainties of the machine of 8.6e-4, 8.7e-4, 1.2e-5, 8.7e-4, 8.6e-4 and 1.7e-3.</source>
        <translation>표 1~4는 그것과 일치하는 원 읽음값에서 인쇄된 자리까지 재현됩니다. 시험기의 상대불확도는 8.6e-4, 8.7e-4, 1.2e-5, 8.7e-4, 8.6e-4, 1.7e-3입니다.</translation>
    </message>
    <message>
        <source>Type B, Table 3: differs for five of six sensors, because the stated uncertainties of the machine (2.1e-4, 1.8e-4, 1.2e-5, 3.1e-4, 2.9e-4, 2.4e-4) give 0.16, 0.23, 0.28, 0.31, 0.30, 0.36 µV/V and not 0.27, 0.31, 0.28, 0.41, 0.40, 0.62. The list equals the Type A column in five places: most likely copied there.</source>
        <translation>B형, 표 3: 센서 여섯 중 다섯이 다릅니다. 제시된 시험기의 불확도(2.1e-4, 1.8e-4, 1.2e-5, 3.1e-4, 2.9e-4, 2.4e-4)는 0.27, 0.31, 0.28, 0.41, 0.40, 0.62가 아니라 0.16, 0.23, 0.28, 0.31, 0.30, 0.36 µV/V를 줍니다. 목록이 다섯 곳에서 A형 열과 같아 그곳에서 옮긴 것으로 보입니다.</translation>
    </message>
    <message>
        <source>Table 4, Mx under Fy: differs, printed 1.55 %, is 0.15 %; the largest for Mx is 1.38 %, and the difference to its U 0.30 %, not 0.13 %.</source>
        <translation>표 4, Fy에서의 Mx: 다름. 1.55 %로 인쇄되었으나 0.15 %입니다. Mx의 최댓값은 1.38 %이며 U와의 차는 0.13 %가 아니라 0.30 %입니다.</translation>
    </message>
    <message>
        <source>Section 2.5 calls e_12 the output of Fy under Fx, but Table 4 divides by the rated output of the row: a row is taken as a sensor.</source>
        <translation>2.5절은 e_12를 Fx에서의 Fy의 출력이라 하지만 표 4는 행의 정격출력으로 나눕니다. 행을 센서로 봅니다.</translation>
    </message>
    <message>
        <source>Eq 12 adds hysteresis and interference, limits that are not standard uncertainties, to an expanded uncertainty: the sum is neither a standard uncertainty nor a coverage interval.</source>
        <translation>식 12는 표준불확도가 아닌 한계인 히스테리시스와 간섭을 확장불확도에 더합니다. 그 합은 표준불확도도 포함구간도 아닙니다.</translation>
    </message>
    <message>
        <source>The largest values of Type A and Type B need not occur at the same step. Eq 5 takes the rated output at every step. In 2.1.1 &quot;h=2&quot; of My and Mz is a slip.</source>
        <translation>A형과 B형의 최댓값이 같은 단계에서 나타난다는 법은 없습니다. 식 5는 모든 단계에서 정격출력을 씁니다. 2.1.1의 My와 Mz의 &quot;h=2&quot;는 잘못입니다.</translation>
    </message>
    <message>
        <source>A surface from an STL file - the robot cell, the part, the fixture, the room - that is drawn in the scenes of all analyses. It is context only: no number depends on it.</source>
        <translation>STL 파일의 표면(로봇 셀, 부품, 고정구, 방)으로 모든 분석의 장면에 그려집니다. 주변일 뿐 어떤 수도 그것에 따르지 않습니다.</translation>
    </message>
    <message>
        <source>The picture is fitted to what is measured, not to the mesh, which may be a whole hall.</source>
        <translation>그림은 홀 전체일 수 있는 메시가 아니라 측정하는 것에 맞춥니다.</translation>
    </message>
    <message>
        <source>A file that is missing or damaged is warned of; analyses keep their results.</source>
        <translation>없거나 손상된 파일은 경고하며 분석은 결과를 유지합니다.</translation>
    </message>
    <message>
        <source>Of the certificate and the report; what was typed stays as it is.</source>
        <translation>성적서와 보고서의 언어. 입력한 것은 그대로 둡니다.</translation>
    </message>
    <message>
        <source>distributions of %1</source>
        <translation>%1의 분포</translation>
    </message>
    <message>
        <source>and %1 more like these</source>
        <translation>그리고 이와 같은 것 %1개 더</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was not written: %2: %3</source>
        <translation>&apos;%1&apos;을(를) 쓰지 못했습니다: %2: %3</translation>
    </message>
    <message>
        <source>it cannot be opened</source>
        <translation>열 수 없습니다</translation>
    </message>
    <message>
        <source>writing failed</source>
        <translation>기록하지 못했습니다</translation>
    </message>
    <message>
        <source>closing failed</source>
        <translation>닫기에 실패했습니다</translation>
    </message>
    <message>
        <source>a file cannot be created in its folder &apos;%1&apos;</source>
        <translation>폴더 &apos;%1&apos;에 파일을 만들 수 없습니다</translation>
    </message>
    <message>
        <source>the permissions of the old file cannot be kept</source>
        <translation>이전 파일의 권한을 유지할 수 없습니다</translation>
    </message>
    <message>
        <source>flushing to the disk failed</source>
        <translation>디스크에 기록하지 못했습니다</translation>
    </message>
    <message>
        <source>the new file cannot take its place</source>
        <translation>새 파일이 그 자리를 대신할 수 없습니다</translation>
    </message>
    <message>
        <source>a folder</source>
        <translation>폴더</translation>
    </message>
    <message>
        <source>a pipe</source>
        <translation>파이프</translation>
    </message>
    <message>
        <source>a socket</source>
        <translation>소켓</translation>
    </message>
    <message>
        <source>a device</source>
        <translation>장치</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be read: %2</source>
        <translation>&apos;%1&apos;을(를) 읽을 수 없습니다: %2</translation>
    </message>
    <message>
        <source>it is %1, not a file</source>
        <translation>파일이 아니라 %1입니다</translation>
    </message>
    <message>
        <source>it is not a file</source>
        <translation>파일이 아닙니다</translation>
    </message>
    <message>
        <source>it is too large: files of up to %1 MB are read, it has %2 MB</source>
        <translation>너무 큽니다. 파일은 %1 MB까지 읽는데 이 파일은 %2 MB입니다</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>폴더입니다</translation>
    </message>
    <message>
        <source>unit &quot;%1&quot;: %2</source>
        <translation>단위 &quot;%1&quot;: %2</translation>
    </message>
    <message>
        <source>a parenthesis is closed that was not opened.</source>
        <translation>열지 않은 괄호를 닫았습니다.</translation>
    </message>
    <message>
        <source>write a product with &apos;*&apos; (&quot;N*m&quot;, &quot;W/(m*K)&quot;), not with a blank.</source>
        <translation>곱은 빈칸이 아니라 &apos;*&apos;로 쓰십시오 (&quot;N*m&quot;, &quot;W/(m*K)&quot;).</translation>
    </message>
    <message>
        <source>a parenthesis is not closed.</source>
        <translation>괄호를 닫지 않았습니다.</translation>
    </message>
    <message>
        <source>the exponent must be a whole number between -9 and 9, not 0 (&quot;mm^2&quot;).</source>
        <translation>지수는 0이 아닌 -9에서 9 사이의 정수여야 합니다 (&quot;mm^2&quot;).</translation>
    </message>
    <message>
        <source>the exponents are too large.</source>
        <translation>지수가 너무 큽니다.</translation>
    </message>
    <message>
        <source>a unit is missing beside &apos;*&apos;, &apos;/&apos; or a parenthesis.</source>
        <translation>&apos;*&apos;, &apos;/&apos; 또는 괄호 옆에 단위가 없습니다.</translation>
    </message>
    <message>
        <source>numbers other than 1 do not belong in a unit; put them into the value.</source>
        <translation>단위에는 1 외의 수를 쓸 수 없습니다. 값에 넣으십시오.</translation>
    </message>
    <message>
        <source>the unit &quot;%1&quot; is not known.%2</source>
        <translation>단위 &quot;%1&quot;을(를) 알 수 없습니다.%2</translation>
    </message>
    <message>
        <source>the text is too long for a unit.</source>
        <translation>단위로는 텍스트가 너무 깁니다.</translation>
    </message>
    <message>
        <source>the unit is empty: write &quot;1&quot; for a pure number.</source>
        <translation>단위가 비어 있습니다. 무차원수에는 &quot;1&quot;을 적으십시오.</translation>
    </message>
    <message>
        <source> Known units, most of them with the prefixes of the SI: %1.</source>
        <translation> 알려진 단위(대부분 SI 접두어 사용 가능): %1.</translation>
    </message>
    <message>
        <source> Did you mean %1?</source>
        <translation> %1을(를) 뜻하셨습니까?</translation>
    </message>
    <message>
        <source> Did you mean %1 or %2?</source>
        <translation> %1 또는 %2을(를) 뜻하셨습니까?</translation>
    </message>
    <message>
        <source>the attached file &apos;%1&apos; is broken</source>
        <translation>첨부 파일 &apos;%1&apos;이(가) 손상되었습니다</translation>
    </message>
    <message>
        <source>the coverage probability must lie between 0 and 1.</source>
        <translation>포함확률은 0과 1 사이여야 합니다.</translation>
    </message>
    <message>
        <source>the effective degrees of freedom must be greater than 0.</source>
        <translation>유효자유도는 0보다 커야 합니다.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is defined by itself here, directly or through other definitions; an equation that is to be solved is written &apos;solve %1 = 1: ... = ...&apos;, with a starting value</source>
        <translation>&apos;%1&apos;은(는) 여기서 직접 또는 다른 정의를 거쳐 자기 자신으로 정의됩니다. 풀어야 할 식은 시작값과 함께 &apos;solve %1 = 1: ... = ...&apos;로 씁니다</translation>
    </message>
    <message>
        <source>the expression in columns %1-%2</source>
        <translation>열 %1-%2의 식</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither defined nor one of the quantities: give it a row in the table of quantities</source>
        <translation>&apos;%1&apos;은(는) 정의되지도 않았고 양도 아닙니다. 양 표에 행을 추가하십시오</translation>
    </message>
    <message>
        <source>%1 is a difference of temperatures: its unit is K, not %2</source>
        <translation>%1은(는) 온도 차입니다. 단위는 %2이(가) 아니라 K입니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; would be a condition: a definition must give a number</source>
        <translation>&apos;%1&apos;은(는) 조건이 됩니다. 정의는 수를 주어야 합니다</translation>
    </message>
    <message>
        <source>%1 is %2, %3 is %4: they cannot be equal</source>
        <translation>%1은(는) %2, %3은(는) %4입니다. 서로 같을 수 없습니다</translation>
    </message>
    <message>
        <source>the equations do not depend on the unknown &apos;%1&apos;</source>
        <translation>방정식이 미지수 &apos;%1&apos;에 의존하지 않습니다</translation>
    </message>
    <message>
        <source>this equation does not depend on any unknown</source>
        <translation>이 방정식은 어떤 미지수에도 의존하지 않습니다</translation>
    </message>
    <message>
        <source>this constant has no value (division by zero, or root of a negative number)</source>
        <translation>이 상수에는 값이 없습니다(0으로 나눔 또는 음수의 제곱근)</translation>
    </message>
    <message>
        <source>no equation defines &apos;%1&apos;</source>
        <translation>&apos;%1&apos;을(를) 정의하는 방정식이 없습니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is to be given in %2, but is %3</source>
        <translation>&apos;%1&apos;은(는) %2(으)로 주어야 하지만 %3입니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is %2, which has no unit of its own</source>
        <translation>&apos;%1&apos;은(는) %2이며, 여기에는 고유한 단위가 없습니다</translation>
    </message>
    <message>
        <source>%1 is %2, %3 is %4</source>
        <translation>%1은(는) %2, %3은(는) %4입니다</translation>
    </message>
    <message>
        <source>they cannot be added</source>
        <translation>서로 더할 수 없습니다</translation>
    </message>
    <message>
        <source>they cannot be subtracted</source>
        <translation>서로 뺄 수 없습니다</translation>
    </message>
    <message>
        <source>%1 is %2: %3</source>
        <translation>%1은(는) %2입니다: %3</translation>
    </message>
    <message>
        <source>the exponent %1 is %2: an exponent must be a pure number</source>
        <translation>지수 %1은(는) %2입니다. 지수는 무차원수여야 합니다</translation>
    </message>
    <message>
        <source>%1 is %2: its exponent must be a constant, or the dimension would vary</source>
        <translation>%1은(는) %2입니다. 그 지수는 상수여야 합니다. 그렇지 않으면 차원이 달라집니다</translation>
    </message>
    <message>
        <source>atan2 needs two quantities of one kind</source>
        <translation>atan2에는 같은 종류의 두 양이 필요합니다</translation>
    </message>
    <message>
        <source>a function of both needs quantities of one kind</source>
        <translation>둘의 함수에는 같은 종류의 양이 필요합니다</translation>
    </message>
    <message>
        <source>sin, cos and tan need an angle or a pure number</source>
        <translation>sin, cos, tan에는 각 또는 무차원수가 필요합니다</translation>
    </message>
    <message>
        <source>an inverse function of an angle needs a pure number</source>
        <translation>각의 역함수에는 무차원수가 필요합니다</translation>
    </message>
    <message>
        <source>this function needs a pure number: divide by a quantity of the same kind</source>
        <translation>이 함수에는 무차원수가 필요합니다. 같은 종류의 양으로 나누십시오</translation>
    </message>
    <message>
        <source>they cannot be compared</source>
        <translation>서로 비교할 수 없습니다</translation>
    </message>
    <message>
        <source>%1 is not a condition: write a comparison, as in x &gt; 0</source>
        <translation>%1은(는) 조건이 아닙니다. x &gt; 0과 같이 비교를 적으십시오</translation>
    </message>
    <message>
        <source>a condition</source>
        <translation>조건</translation>
    </message>
    <message>
        <source>a pure number</source>
        <translation>무차원수</translation>
    </message>
    <message>
        <source>measured in %1</source>
        <translation>%1(으)로 측정하는 양</translation>
    </message>
    <message>
        <source>%1 is a temperature in degC, %2 a difference of temperatures: give differences in K</source>
        <translation>%1은(는) degC 단위의 온도이고 %2은(는) 온도 차입니다. 차는 K로 주십시오</translation>
    </message>
    <message>
        <source>%1 is a temperature in degC, and 0 has no unit: write 0 [degC], or 0 [K] for absolute zero</source>
        <translation>%1은(는) degC 단위의 온도이고 0에는 단위가 없습니다. 0 [degC], 절대영도라면 0 [K]로 적으십시오</translation>
    </message>
    <message>
        <source>%1 is a sum of temperatures in degC, which means nothing: give differences in K, or divide the sum by the number of temperatures for their mean</source>
        <translation>%1은(는) degC 단위 온도의 합이며 의미가 없습니다. 차를 K로 주거나, 평균을 구하려면 합을 온도의 개수로 나누십시오</translation>
    </message>
    <message>
        <source>%1 is not a condition: write a comparison, as in if(x &gt; 0, x, 0)</source>
        <translation>%1은(는) 조건이 아닙니다. if(x &gt; 0, x, 0)과 같이 비교를 적으십시오</translation>
    </message>
    <message>
        <source>both values of &apos;if&apos; must be numbers, not conditions</source>
        <translation>&apos;if&apos;의 두 값은 모두 조건이 아니라 수여야 합니다</translation>
    </message>
    <message>
        <source>both values of &apos;if&apos; must be of one kind</source>
        <translation>&apos;if&apos;의 두 값은 같은 종류여야 합니다</translation>
    </message>
    <message>
        <source>%1 is a condition: use it as the first argument of if(...)</source>
        <translation>%1은(는) 조건입니다. if(...)의 첫째 인수로 사용하십시오</translation>
    </message>
    <message>
        <source>the end of the equation</source>
        <translation>식의 끝</translation>
    </message>
    <message>
        <source>%1 is not a function; to multiply, write &apos;*&apos;. Functions are: %2</source>
        <translation>%1은(는) 함수가 아닙니다. 곱하려면 &apos;*&apos;를 쓰십시오. 함수: %2</translation>
    </message>
    <message>
        <source>%1 needs %2 arguments; here it has %3</source>
        <translation>%1에는 인수 %2개가 필요합니다. 여기에는 %3개가 있습니다</translation>
    </message>
    <message>
        <source>%1 needs %2 to %3 arguments; here it has %4</source>
        <translation>%1에는 인수 %2~%3개가 필요합니다. 여기에는 %4개가 있습니다</translation>
    </message>
    <message>
        <source>&apos;+&apos; stands here twice</source>
        <translation>여기에 &apos;+&apos;가 두 번 있습니다</translation>
    </message>
    <message>
        <source>the expression is nested more than %1 levels deep: split it into definitions</source>
        <translation>식이 %1단계를 넘어 중첩되어 있습니다. 정의로 나누십시오</translation>
    </message>
    <message>
        <source>a unit in brackets belongs behind a number: 20 [degC]</source>
        <translation>대괄호 안의 단위는 수 뒤에 와야 합니다: 20 [degC]</translation>
    </message>
    <message>
        <source>a number, a name or a parenthesis is expected here, not %1</source>
        <translation>여기에는 %1이(가) 아니라 수, 이름 또는 괄호가 필요합니다</translation>
    </message>
    <message>
        <source>this parenthesis is not closed</source>
        <translation>이 괄호를 닫지 않았습니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a function: its argument follows in parentheses</source>
        <translation>&apos;%1&apos;은(는) 함수입니다. 뒤의 괄호 안에 인수가 필요합니다</translation>
    </message>
    <message>
        <source>the word &apos;%1&apos; is not expected here</source>
        <translation>단어 &apos;%1&apos;은(는) 여기에 올 수 없습니다</translation>
    </message>
    <message>
        <source>an operator, a comma or &apos;)&apos; is expected here, not %1</source>
        <translation>여기에는 %1이(가) 아니라 연산자, 쉼표 또는 &apos;)&apos;가 필요합니다</translation>
    </message>
    <message>
        <source>this parenthesis closes nothing</source>
        <translation>이 괄호는 아무것도 닫지 않습니다</translation>
    </message>
    <message>
        <source>an equation defines one name: write &apos;y = ...&apos;; to compare, write &apos;==&apos;; an equation that is to be solved starts with &apos;solve&apos;</source>
        <translation>방정식은 이름 하나를 정의합니다: &apos;y = ...&apos;로 적으십시오. 비교하려면 &apos;==&apos;를 적으십시오. 풀어야 할 방정식은 &apos;solve&apos;로 시작합니다</translation>
    </message>
    <message>
        <source>an operator is missing before %1</source>
        <translation>%1 앞에 연산자가 없습니다</translation>
    </message>
    <message>
        <source>%1 is not expected here</source>
        <translation>%1은(는) 여기에 올 수 없습니다</translation>
    </message>
    <message>
        <source>an equation starts with the name that it defines: y = ...</source>
        <translation>방정식은 그것이 정의하는 이름으로 시작합니다: y = ...</translation>
    </message>
    <message>
        <source>a name with its starting value is expected here: y = 1</source>
        <translation>여기에는 시작값이 있는 이름이 필요합니다: y = 1</translation>
    </message>
    <message>
        <source>a function</source>
        <translation>함수</translation>
    </message>
    <message>
        <source>a word of the language</source>
        <translation>언어의 예약어</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is %2: choose another name</source>
        <translation>&apos;%1&apos;은(는) %2입니다. 다른 이름을 선택하십시오</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is defined twice</source>
        <translation>&apos;%1&apos;이(가) 두 번 정의되었습니다</translation>
    </message>
    <message>
        <source>a colon is expected before the equations to be solved: solve y = 1: y^2 = x</source>
        <translation>풀어야 할 방정식 앞에 쌍점이 필요합니다: solve y = 1: y^2 = x</translation>
    </message>
    <message>
        <source>%1 unknowns need as many equations; there are %2</source>
        <translation>미지수 %1개에는 같은 수의 방정식이 필요합니다. 지금은 %2개입니다</translation>
    </message>
    <message>
        <source>an equals sign is expected in an equation to be solved</source>
        <translation>풀어야 할 방정식에는 등호가 필요합니다</translation>
    </message>
    <message>
        <source>line %1, column %2: </source>
        <translation>%1행, %2열: </translation>
    </message>
    <message>
        <source>line %1, columns %2-%3: </source>
        <translation>%1행, %2-%3열: </translation>
    </message>
    <message>
        <source>this number is too large or too small to compute with</source>
        <translation>이 수는 계산하기에 너무 크거나 너무 작습니다</translation>
    </message>
    <message>
        <source>the bracket of a unit is not closed: write &apos;]&apos; behind the unit</source>
        <translation>단위의 대괄호를 닫지 않았습니다. 단위 뒤에 &apos;]&apos;를 적으십시오</translation>
    </message>
    <message>
        <source>the character &apos;%1&apos; does not belong in an equation</source>
        <translation>문자 &apos;%1&apos;은(는) 방정식에 쓸 수 없습니다</translation>
    </message>
    <message>
        <source>the equations have %1 characters; more than %2 are not read: put tables of data into assets or observations</source>
        <translation>식이 %1자입니다. %2자를 넘으면 읽지 않습니다. 데이터 표는 에셋이나 관측값에 넣으십시오</translation>
    </message>
    <message>
        <source>the coverage factor k must be greater than zero</source>
        <translation>포함인자 k는 0보다 커야 합니다</translation>
    </message>
    <message>
        <source>the coverage probability must lie between 0 and 100 %</source>
        <translation>포함확률은 0과 100 % 사이여야 합니다</translation>
    </message>
    <message>
        <source>the limits give the estimate: leave the value empty, or state a half-width</source>
        <translation>한계가 추정값을 줍니다. 값을 비워 두거나 반너비를 주십시오</translation>
    </message>
    <message>
        <source>the lower limit is above the upper limit</source>
        <translation>하한이 상한보다 큽니다</translation>
    </message>
    <message>
        <source>a relative part of the permissible error needs the value of the quantity</source>
        <translation>허용오차의 상대 부분에는 양의 값이 필요합니다</translation>
    </message>
    <message>
        <source>an exponential distribution needs an estimate greater than zero</source>
        <translation>지수분포에는 0보다 큰 추정값이 필요합니다</translation>
    </message>
    <message>
        <source>the number of counts must be whole</source>
        <translation>계수 횟수는 정수여야 합니다</translation>
    </message>
    <message>
        <source>the counts give the estimate: leave the value empty</source>
        <translation>계수 횟수가 추정값을 줍니다. 값을 비워 두십시오</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not used by this statement: leave it empty</source>
        <translation>이 표기에서는 &apos;%1&apos;을(를) 사용하지 않습니다. 비워 두십시오</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is missing: %2</source>
        <translation>&apos;%1&apos;이(가) 없습니다: %2</translation>
    </message>
    <message>
        <source>&apos;a&apos; must not be negative</source>
        <translation>&apos;a&apos;는 음수일 수 없습니다</translation>
    </message>
    <message>
        <source>give the degrees of freedom or the relative uncertainty of u, not both</source>
        <translation>자유도와 u의 상대불확도 중 하나만 제시하십시오</translation>
    </message>
    <message>
        <source>the degrees of freedom must be greater than zero</source>
        <translation>자유도는 0보다 커야 합니다</translation>
    </message>
    <message>
        <source>the relative uncertainty of u must not be negative</source>
        <translation>u의 상대불확도는 음수일 수 없습니다</translation>
    </message>
    <message>
        <source>there is no statement &apos;%1&apos;</source>
        <translation>표기 &apos;%1&apos;이(가) 없습니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not understood here</source>
        <translation>여기서 &apos;%1&apos;을(를) 이해할 수 없습니다</translation>
    </message>
    <message>
        <source>a number is missing after &apos;%1&apos;</source>
        <translation>&apos;%1&apos; 다음에 수가 없습니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no way to state an uncertainty. For example: 75 nm; U = 0.3 um, k = 2; rectangular 0.5; resolution 0.01; constant</source>
        <translation>&apos;%1&apos;은(는) 불확도를 표기하는 방법이 아닙니다. 예: 75 nm; U = 0.3 um, k = 2; 직사각형 0.5; 분해능 0.01; 상수</translation>
    </message>
    <message>
        <source>%1 has %2 figure</source>
        <translation>%1에 수치 %2개가 있습니다</translation>
    </message>
    <message>
        <source>%1 has %2 figures</source>
        <translation>%1에 수치 %2개가 있습니다</translation>
    </message>
    <message>
        <source>a figure is missing: an expanded uncertainty needs k = ... or p = ... %</source>
        <translation>수치가 없습니다. 확장불확도에는 k = ... 또는 p = ... %가 필요합니다</translation>
    </message>
    <message>
        <source>a figure is missing: it is noted as %1</source>
        <translation>수치가 없습니다. %1(으)로 적어 둡니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no part of it: it is noted as %2</source>
        <translation>&apos;%1&apos;은(는) 포함되지 않습니다. %2(으)로 적어 둡니다</translation>
    </message>
    <message>
        <source>it has no unit</source>
        <translation>단위가 없습니다</translation>
    </message>
    <message>
        <source>the second figure has no unit but %</source>
        <translation>두 번째 수치에 % 외의 단위가 없습니다</translation>
    </message>
    <message>
        <source>the second figure has no unit</source>
        <translation>두 번째 수치에 단위가 없습니다</translation>
    </message>
    <message>
        <source>the further part is one in %: write MPE 3 + 0.1 %</source>
        <translation>나머지 부분은 % 단위입니다. MPE 3 + 0.1 %로 쓰십시오</translation>
    </message>
    <message>
        <source>say which it is: k = ... or p = ... %</source>
        <translation>어느 것인지 밝히십시오: k = ... 또는 p = ... %</translation>
    </message>
    <message>
        <source>a part of the value needs the value</source>
        <translation>값의 일부에 그 값이 필요합니다</translation>
    </message>
    <message>
        <source>%1 is no unit for a quantity in %2</source>
        <translation>%1은(는) %2(으)로 표시된 양의 단위가 아닙니다</translation>
    </message>
    <message>
        <source>a Type A evaluation needs at least two observations.</source>
        <translation>A형 평가에는 관측값이 두 개 이상 필요합니다.</translation>
    </message>
    <message>
        <source>one of the observations is not a finite number.</source>
        <translation>관측값 중 하나가 유한한 수가 아닙니다.</translation>
    </message>
    <message>
        <source>there is no series to be pooled.</source>
        <translation>합동할 계열이 없습니다.</translation>
    </message>
    <message>
        <source>the covariance of two means needs observations made in pairs: the series have different lengths.</source>
        <translation>두 평균의 공분산에는 쌍으로 얻은 관측값이 필요합니다. 계열의 길이가 서로 다릅니다.</translation>
    </message>
    <message>
        <source>the covariance of two means needs at least two pairs.</source>
        <translation>두 평균의 공분산에는 쌍이 두 개 이상 필요합니다.</translation>
    </message>
    <message>
        <source>the components %1 and %2 are given two different correlations; a quantity that combines its components arithmetically needs +1 or -1.</source>
        <translation>성분 %1과 %2에 서로 다른 상관이 두 개 주어졌습니다. 성분을 산술적으로 합하는 양에는 +1 또는 -1이 필요합니다.</translation>
    </message>
    <message>
        <source>a correlation refers to component number %1 of %2.</source>
        <translation>상관이 %2개 중 %1번째 성분을 참조합니다.</translation>
    </message>
    <message>
        <source>a correlation is given between the component %1 and itself.</source>
        <translation>성분 %1과 그 자신 사이에 상관이 주어졌습니다.</translation>
    </message>
    <message>
        <source>the correlation of the components %1 and %2 must lie between -1 and 1.</source>
        <translation>성분 %1과 %2의 상관은 -1과 1 사이여야 합니다.</translation>
    </message>
    <message>
        <source>the quantity &quot;%1&quot; refers to component number %2 of %3.</source>
        <translation>양 &quot;%1&quot;이(가) %3개 중 %2번째 성분을 참조합니다.</translation>
    </message>
    <message>
        <source>the correlations of the components %1 contradict each other: the smallest eigenvalue of their correlation matrix is %2, it must not be negative.</source>
        <translation>성분 %1의 상관이 서로 모순됩니다. 상관행렬의 가장 작은 고윳값이 %2이며 음수일 수 없습니다.</translation>
    </message>
    <message>
        <source>the component %1 is a coordinate of a vector of random direction and cannot be correlated with another component; give it a normal distribution first.</source>
        <translation>성분 %1은(는) 방향이 무작위인 벡터의 좌표이므로 다른 성분과 상관될 수 없습니다. 먼저 정규분포로 하십시오.</translation>
    </message>
    <message>
        <source>the estimate of variance &quot;%1&quot; has component number %2, which does not exist or rests on two estimates.</source>
        <translation>분산 추정 &quot;%1&quot;의 성분 번호 %2은(는) 없거나 두 추정에 근거합니다.</translation>
    </message>
    <message>
        <source>the component %1 rests on the estimate of variance &quot;%2&quot; with others: it needs a normal or Student t distribution and their finite degrees of freedom.</source>
        <translation>성분 %1은(는) 다른 성분과 함께 분산 추정 &quot;%2&quot;에 근거합니다. 정규분포 또는 스튜던트 t 분포와 그 유한한 자유도가 필요합니다.</translation>
    </message>
    <message>
        <source>the components %1 and %2 cannot have the correlation %3: with these distributions it lies between %4 and %5.</source>
        <translation>성분 %1과 %2의 상관은 %3일 수 없습니다. 이 분포에서는 %4과 %5 사이입니다.</translation>
    </message>
    <message>
        <source>%1 distribution: %2</source>
        <translation>%1 분포: %2</translation>
    </message>
    <message>
        <source>the %1 must be a finite number.</source>
        <translation>%1은(는) 유한한 수여야 합니다.</translation>
    </message>
    <message>
        <source>the %1 is too large (at most 1e150).</source>
        <translation>%1이(가) 너무 큽니다(최대 1e150).</translation>
    </message>
    <message>
        <source>the %1 must not be negative.</source>
        <translation>%1은(는) 음수가 아니어야 합니다.</translation>
    </message>
    <message>
        <source>the %1 must lie between 0.001 and 1000000.</source>
        <translation>%1은(는) 0.001과 1000000 사이여야 합니다.</translation>
    </message>
    <message>
        <source>the lower limit must not be greater than the upper limit.</source>
        <translation>하한은 상한보다 크지 않아야 합니다.</translation>
    </message>
    <message>
        <source>the degrees of freedom must be at least 0.2 (they may be infinite).</source>
        <translation>자유도는 0.2 이상이어야 합니다(무한대도 가능).</translation>
    </message>
    <message>
        <source>the inexactness of the limits must not exceed half the distance between them.</source>
        <translation>한계의 부정확도는 한계 사이 거리의 절반을 넘지 않아야 합니다.</translation>
    </message>
    <message>
        <source>the ratio beta of top to base must lie between 0 and 1.</source>
        <translation>윗변과 밑변의 비 beta는 0과 1 사이여야 합니다.</translation>
    </message>
    <message>
        <source>one of the limits excludes every value.</source>
        <translation>한계 중 하나가 모든 값을 배제합니다.</translation>
    </message>
    <message>
        <source>the mean value lies outside the limits.</source>
        <translation>평균값이 한계 밖에 있습니다.</translation>
    </message>
    <message>
        <source>the limits lie so far from the mean value that no probability is left between them.</source>
        <translation>한계가 평균값에서 너무 멀어 그 사이에 확률이 남지 않습니다.</translation>
    </message>
    <message>
        <source>mean value of the logarithm</source>
        <translation>로그의 평균값</translation>
    </message>
    <message>
        <source>the parameters of the logarithm are too large: the quantity has no finite variance in numbers.</source>
        <translation>로그의 매개변수가 너무 큽니다. 양의 분산이 수로 나타내기에 유한하지 않습니다.</translation>
    </message>
    <message>
        <source>a discrete distribution needs at least one value.</source>
        <translation>이산분포에는 값이 하나 이상 필요합니다.</translation>
    </message>
    <message>
        <source>there must be as many probabilities as values.</source>
        <translation>확률의 수는 값의 수와 같아야 합니다.</translation>
    </message>
    <message>
        <source>values</source>
        <translation>값</translation>
    </message>
    <message>
        <source>probabilities</source>
        <translation>확률</translation>
    </message>
    <message>
        <source>the probabilities must sum to 1.</source>
        <translation>확률의 합은 1이어야 합니다.</translation>
    </message>
    <message>
        <source>discrete distribution: there must be as many probabilities as values.</source>
        <translation>이산분포: 확률의 수는 값의 수와 같아야 합니다.</translation>
    </message>
    <message>
        <source>%1 distribution: %2 parameters are needed, %3 are given.</source>
        <translation>%1 분포: 매개변수 %2개가 필요한데 %3개가 주어졌습니다.</translation>
    </message>
    <message>
        <source>the distribution &quot;%1&quot; is not known. Known distributions: %2.</source>
        <translation>분포 &quot;%1&quot;을(를) 알 수 없습니다. 알려진 분포: %2.</translation>
    </message>
    <message>
        <source>%1 in row %2 of %3</source>
        <translation>%3의 %2행에 있는 %1</translation>
    </message>
    <message>
        <source>greater than %1 and at most %2</source>
        <translation>%1보다 크고 %2 이하</translation>
    </message>
    <message>
        <source>between %1 and %2</source>
        <translation>%1과 %2 사이</translation>
    </message>
    <message>
        <source>greater than %1</source>
        <translation>%1보다 큼</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>%1 이상</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>%1 이하</translation>
    </message>
    <message>
        <source>%1 must be a whole number; it is %2</source>
        <translation>%1은(는) 정수여야 합니다. 지금은 %2입니다</translation>
    </message>
    <message>
        <source>%1 is too large a number: %2</source>
        <translation>%1은(는) 너무 큰 수입니다: %2</translation>
    </message>
    <message>
        <source>%1 must be %2; it is %3</source>
        <translation>%1은(는) %2이어야 합니다. 지금은 %3입니다</translation>
    </message>
    <message>
        <source>%1 must be one of %2; it is %3%4</source>
        <translation>%1은(는) 다음 중 하나여야 합니다: %2. 지금은 %3입니다%4</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>수</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>정수</translation>
    </message>
    <message>
        <source>one of its choices</source>
        <translation>선택 항목 중 하나</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>텍스트</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true 또는 false</translation>
    </message>
    <message>
        <source>a pose</source>
        <translation>포즈</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>표</translation>
    </message>
    <message>
        <source>the id of an asset</source>
        <translation>에셋의 id</translation>
    </message>
    <message>
        <source>%1 must be %2</source>
        <translation>%1은(는) %2이어야 합니다</translation>
    </message>
    <message>
        <source>%1 needs at least 1 row; it has %2</source>
        <translation>%1에는 행이 1개 이상 필요합니다. 지금은 %2개입니다</translation>
    </message>
    <message>
        <source>%1 needs at least %2 rows; it has %3</source>
        <translation>%1에는 행이 %2개 이상 필요합니다. 지금은 %3개입니다</translation>
    </message>
    <message>
        <source>%1 has %2 columns, but %3 units</source>
        <translation>%1의 열은 %2개이지만 단위는 %3개입니다</translation>
    </message>
    <message>
        <source>row %1 of %2 has %3 cells; there are %4 columns</source>
        <translation>%2의 행 %1에 셀이 %3개입니다. 열은 %4개입니다</translation>
    </message>
    <message>
        <source>%1 is empty</source>
        <translation>%1이(가) 비어 있습니다</translation>
    </message>
    <message>
        <source>%1 must not be empty</source>
        <translation>%1은(는) 비워 둘 수 없습니다</translation>
    </message>
    <message>
        <source>%1 must be given (&apos;%2&apos; is missing)</source>
        <translation>%1을(를) 주어야 합니다(&apos;%2&apos;이(가) 없음)</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; is %3; &apos;%4&apos; is the unit of %5</source>
        <translation>&apos;%2&apos;의 열 &apos;%1&apos;은(는) %3입니다. &apos;%4&apos;은(는) %5의 단위입니다</translation>
    </message>
    <message>
        <source>there is no field &apos;%1&apos; here%2</source>
        <translation>여기에는 필드 &apos;%1&apos;이(가) 없습니다%2</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>길이</translation>
    </message>
    <message>
        <source>an area</source>
        <translation>면적</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>부피</translation>
    </message>
    <message>
        <source>a mass</source>
        <translation>질량</translation>
    </message>
    <message>
        <source>a time</source>
        <translation>시간</translation>
    </message>
    <message>
        <source>a frequency</source>
        <translation>주파수</translation>
    </message>
    <message>
        <source>an electric current</source>
        <translation>전류</translation>
    </message>
    <message>
        <source>a temperature</source>
        <translation>온도</translation>
    </message>
    <message>
        <source>an expansion coefficient</source>
        <translation>팽창계수</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>각도</translation>
    </message>
    <message>
        <source>a velocity</source>
        <translation>속도</translation>
    </message>
    <message>
        <source>an acceleration</source>
        <translation>가속도</translation>
    </message>
    <message>
        <source>a force</source>
        <translation>힘</translation>
    </message>
    <message>
        <source>a moment</source>
        <translation>모멘트</translation>
    </message>
    <message>
        <source>a pressure</source>
        <translation>압력</translation>
    </message>
    <message>
        <source>a stiffness</source>
        <translation>강성</translation>
    </message>
    <message>
        <source>a voltage</source>
        <translation>전압</translation>
    </message>
    <message>
        <source>an electric resistance</source>
        <translation>전기저항</translation>
    </message>
    <message>
        <source>an electric charge</source>
        <translation>전하</translation>
    </message>
    <message>
        <source>a capacitance</source>
        <translation>전기용량</translation>
    </message>
    <message>
        <source>an inductance</source>
        <translation>인덕턴스</translation>
    </message>
    <message>
        <source>a magnetic flux density</source>
        <translation>자속밀도</translation>
    </message>
    <message>
        <source>a magnetic flux</source>
        <translation>자속</translation>
    </message>
    <message>
        <source>a power</source>
        <translation>일률</translation>
    </message>
    <message>
        <source>an amount of substance</source>
        <translation>물질량</translation>
    </message>
    <message>
        <source>a luminous intensity</source>
        <translation>광도</translation>
    </message>
    <message>
        <source>an angular velocity</source>
        <translation>각속도</translation>
    </message>
    <message>
        <source>a density</source>
        <translation>밀도</translation>
    </message>
    <message>
        <source> (did you mean &apos;%1&apos;?)</source>
        <translation> (&apos;%1&apos;을(를) 뜻하셨습니까?)</translation>
    </message>
    <message>
        <source>%1 must be a finite number; it is %2</source>
        <translation>%1은(는) 유한한 수여야 합니다. 지금은 %2입니다</translation>
    </message>
    <message>
        <source>%1 is too large to be computed with (at most 1e100): it is %2</source>
        <translation>%1은(는) 계산하기에 너무 큽니다(최대 1e100). 지금은 %2입니다</translation>
    </message>
    <message>
        <source>%1 is %2; %3 has no unit</source>
        <translation>%1은(는) %2입니다. %3에는 단위가 없습니다</translation>
    </message>
    <message>
        <source>%1 is %2; %3 is %4</source>
        <translation>%1은(는) %2입니다. %3은(는) %4입니다</translation>
    </message>
    <message>
        <source>the result does not represent the measurand: more than 1 % of the trials have no value</source>
        <translation>결과가 측정량을 대표하지 않습니다. 시행의 1 % 넘게 값이 없습니다</translation>
    </message>
    <message>
        <source>U = k u with the coverage factor that was fixed.</source>
        <translation>U = k u, 포함인자는 고정값.</translation>
    </message>
    <message>
        <source>U is half the width of the probabilistically symmetric coverage interval, and k = U/u.</source>
        <translation>U는 확률적으로 대칭인 포함구간의 반너비이며 k = U/u.</translation>
    </message>
    <message>
        <source>U = k u with k of the t distribution for the effective degrees of freedom.</source>
        <translation>U = k u, k는 유효자유도에 대한 t 분포의 값.</translation>
    </message>
    <message>
        <source>the number of significant digits of the numerical tolerance must be 1, 2, 3 or 4</source>
        <translation>수치 허용차의 유효숫자는 1, 2, 3 또는 4자리여야 합니다</translation>
    </message>
    <message>
        <source>the numerical tolerance must be greater than zero</source>
        <translation>수치 허용차는 0보다 커야 합니다</translation>
    </message>
    <message>
        <source>the adaptive procedure needs at least two batches</source>
        <translation>적응형 절차에는 배치가 두 개 이상 필요합니다</translation>
    </message>
    <message>
        <source>the adaptive procedure needs at least two batches: allow %1 trials or more</source>
        <translation>적응형 절차에는 배치가 두 개 이상 필요합니다. 시행을 %1회 이상 허용하십시오</translation>
    </message>
    <message>
        <source>a Monte Carlo run needs at least two trials</source>
        <translation>몬테카를로 실행에는 시행이 2회 이상 필요합니다</translation>
    </message>
    <message>
        <source>the coverage probability must lie between 0 and 1</source>
        <translation>포함확률은 0과 1 사이여야 합니다</translation>
    </message>
    <message>
        <source>the coverage probability is too near to 1</source>
        <translation>포함확률이 1에 너무 가깝습니다</translation>
    </message>
    <message>
        <source>the coverage factor must be greater than zero</source>
        <translation>포함인자는 0보다 커야 합니다</translation>
    </message>
    <message>
        <source>one-at-a-time Monte Carlo needs at least two trials</source>
        <translation>한 번에 하나씩의 몬테카를로에는 시행이 2회 이상 필요합니다</translation>
    </message>
    <message>
        <source>Monte Carlo without a contributor needs at least two trials</source>
        <translation>기여요인 하나를 뺀 몬테카를로에는 시행이 2회 이상 필요합니다</translation>
    </message>
    <message>
        <source>Sobol indices need at least 100 trials</source>
        <translation>소볼 지수에는 시행이 100회 이상 필요합니다</translation>
    </message>
    <message>
        <source>the evaluation was stopped</source>
        <translation>평가가 중지되었습니다</translation>
    </message>
    <message>
        <source>none of the trials has a value: the measurement model cannot be evaluated within the uncertainties of its inputs; check the standard uncertainties and the geometry</source>
        <translation>값이 있는 시행이 없습니다. 입력의 불확도 안에서 측정 모델을 평가할 수 없습니다. 표준불확도와 기하를 확인하십시오</translation>
    </message>
    <message>
        <source>the linear part explains %1 % of the variance: a gain of %2</source>
        <translation>선형 부분이 분산의 %1 %를 설명합니다. 이득 %2</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%2의 %1</translation>
    </message>
    <message>
        <source>no trial has a value</source>
        <translation>값이 있는 시행이 없습니다</translation>
    </message>
    <message>
        <source>the measurement model has no sensitivity coefficients near the estimates: second-order terms do not exist</source>
        <translation>추정값 근처에서 측정 모델에 감도계수가 없습니다. 이차항이 존재하지 않습니다</translation>
    </message>
    <message>
        <source>there are too many quantities for them</source>
        <translation>그것을 계산하기에는 양이 너무 많습니다</translation>
    </message>
    <message>
        <source>the degrees of freedom of %1 must be greater than zero</source>
        <translation>%1의 자유도는 0보다 커야 합니다</translation>
    </message>
    <message>
        <source>the degrees of freedom of %1 are too few: there must be at least 0.2</source>
        <translation>%1의 자유도가 너무 작습니다. 0.2 이상이어야 합니다</translation>
    </message>
    <message>
        <source>the distribution of %1 has no finite mean or standard uncertainty</source>
        <translation>%1의 분포에 유한한 평균 또는 표준불확도가 없습니다</translation>
    </message>
    <message>
        <source>the estimate of %1 is not a finite number</source>
        <translation>%1의 추정값이 유한한 수가 아닙니다</translation>
    </message>
    <message>
        <source>quantity %1 refers to a component that does not exist, or with a factor that is not finite</source>
        <translation>양 %1이(가) 존재하지 않는 성분을 참조하거나 유한하지 않은 인자로 참조합니다</translation>
    </message>
    <message>
        <source>the measurement model has %1 input quantities, but %2 were given</source>
        <translation>측정 모델의 입력량은 %1개이지만 %2개가 주어졌습니다</translation>
    </message>
    <message>
        <source>the measurement model has no output quantities</source>
        <translation>측정 모델에 출력량이 없습니다</translation>
    </message>
    <message>
        <source>its correlated components are not normally distributed</source>
        <translation>상관된 성분이 정규분포를 따르지 않습니다</translation>
    </message>
    <message>
        <source>no spread</source>
        <translation>산포 없음</translation>
    </message>
    <message>
        <source>normal as far as so few trials can tell</source>
        <translation>이렇게 적은 시행으로 알 수 있는 한 정규</translation>
    </message>
    <message>
        <source>normal within 1 %</source>
        <translation>1 % 이내로 정규</translation>
    </message>
    <message>
        <source>normal within 5 %</source>
        <translation>5 % 이내로 정규</translation>
    </message>
    <message>
        <source>too skewed for k u</source>
        <translation>k u에 비해 너무 비대칭</translation>
    </message>
    <message>
        <source>too heavy-tailed for k u</source>
        <translation>k u에 비해 꼬리가 너무 두꺼움</translation>
    </message>
    <message>
        <source>too flat for k u</source>
        <translation>k u에 비해 너무 평평함</translation>
    </message>
    <message>
        <source>Second-order terms are left out: the formula of JCGM 100 5.1.2 assumes independent components, and some of these are correlated.</source>
        <translation>이차항은 생략합니다. JCGM 100 5.1.2의 식은 성분이 독립이라고 가정하지만 여기서는 일부가 상관되어 있습니다.</translation>
    </message>
    <message>
        <source>Second-order terms are left out: %1.</source>
        <translation>이차항은 생략합니다: %1.</translation>
    </message>
    <message>
        <source>%1 of %2 trials (%3 %) have no value (the measurement model cannot be evaluated there) and are not part of the statistics.</source>
        <translation>시행 %2회 중 %1회(%3 %)는 값이 없으며(그곳에서 측정 모델을 평가할 수 없음) 통계에 포함되지 않습니다.</translation>
    </message>
    <message>
        <source>The result does not represent the measurand: more than 1 % of the trials are lost, and they are not a random choice.</source>
        <translation>결과가 측정량을 대표하지 않습니다. 시행의 1 % 넘게 잃었으며, 무작위로 고른 것이 아닙니다.</translation>
    </message>
    <message>
        <source>The adaptive procedure stopped at %1 trials before its results were stable: allow more trials, or ask for fewer significant digits.</source>
        <translation>적응형 절차가 결과가 안정되기 전에 시행 %1회에서 멈췄습니다. 시행을 더 허용하거나 유효숫자를 줄이십시오.</translation>
    </message>
    <message>
        <source>Coverage intervals are interpolated in fine cells: there are too many trials to keep the values of the tails in memory.</source>
        <translation>포함구간을 세밀한 칸에서 보간합니다. 꼬리의 값을 메모리에 보관하기에는 시행이 너무 많습니다.</translation>
    </message>
    <message>
        <source>The correlations stated cannot all hold with these distributions: the nearest that can are drawn, with coefficients that differ by up to %1.</source>
        <translation>제시된 상관은 이 분포들로는 모두 성립할 수 없습니다. 가능한 가장 가까운 것을 추출하며, 계수는 최대 %1만큼 다릅니다.</translation>
    </message>
    <message>
        <source>The angle %1%2 is hardly determined: its standard uncertainty exceeds 1 rad.</source>
        <translation>각 %1%2이(가) 거의 정해지지 않습니다. 그 표준불확도가 1 rad를 넘습니다.</translation>
    </message>
    <message>
        <source>Nothing is gained by variance reduction, and standard errors are not known: there are fewer than %1 batches of %2 trials.</source>
        <translation>분산 감소로 얻는 것이 없고 표준오차를 알 수 없습니다. 시행 %2회의 배치가 %1개보다 적습니다.</translation>
    </message>
    <message>
        <source>Control variates are not used: the linear part of the trials that have a value has another distribution than that of all trials.</source>
        <translation>제어 변량을 사용하지 않습니다. 값이 있는 시행의 선형 부분이 모든 시행의 것과 다른 분포를 가집니다.</translation>
    </message>
    <message>
        <source>Without control variate: %1.</source>
        <translation>제어 변량 없음: %1.</translation>
    </message>
    <message>
        <source>The standard uncertainty by Monte Carlo of %1 does not exist, because a Student t distribution with two degrees of freedom or fewer has no finite standard deviation: it is shown as infinite, and U is half the width of the coverage interval.</source>
        <translation>자유도가 2 이하인 스튜던트 t 분포에는 유한한 표준편차가 없으므로 몬테카를로에 의한 %1의 표준불확도가 존재하지 않습니다. 무한대로 표시하며, U는 포함구간 너비의 절반입니다.</translation>
    </message>
    <message>
        <source>The standard uncertainty by Monte Carlo of %1 cannot stabilise, because Student t distributions with four degrees of freedom or fewer have no finite fourth moment: the adaptive procedure judges by the coverage intervals; use these.</source>
        <translation>자유도가 4 이하인 스튜던트 t 분포에는 유한한 4차 모멘트가 없으므로 몬테카를로에 의한 %1의 표준불확도가 안정될 수 없습니다. 적응형 절차는 포함구간으로 판단합니다. 포함구간을 사용하십시오.</translation>
    </message>
    <message>
        <source>the measurement model has no value at the estimates of its input quantities%1: check the nominal geometry and the values entered</source>
        <translation>측정 모델이 입력량의 추정값%1에서 값을 갖지 않습니다. 공칭 기하와 입력한 값을 확인하십시오</translation>
    </message>
    <message>
        <source>Effective degrees of freedom are approximate: the Welch-Satterthwaite formula assumes independent components, and correlated components with finite degrees of freedom contribute. The Monte Carlo coverage interval is the better guide.</source>
        <translation>유효자유도는 근사값입니다. Welch-Satterthwaite 식은 성분이 독립이라고 가정하지만 자유도가 유한한 상관된 성분이 기여합니다. 몬테카를로 포함구간이 더 나은 지표입니다.</translation>
    </message>
    <message>
        <source>1 vector of random direction has coordinates with different distributions after editing: they are drawn independently.</source>
        <translation>방향이 무작위인 벡터 1개의 좌표가 편집 후 서로 다른 분포를 가집니다. 독립적으로 추출됩니다.</translation>
    </message>
    <message>
        <source>%1 vectors of random direction have coordinates with different distributions after editing: they are drawn independently.</source>
        <translation>방향이 무작위인 벡터 %1개의 좌표가 편집 후 서로 다른 분포를 가집니다. 독립적으로 추출됩니다.</translation>
    </message>
    <message>
        <source>The angle %1 is hardly determined: its standard uncertainty by the law of propagation exceeds 1 rad.</source>
        <translation>각 %1이(가) 거의 정해지지 않습니다. 전파 법칙에 의한 표준불확도가 1 rad를 넘습니다.</translation>
    </message>
    <message>
        <source>a tolerance of %1 %2 for %3 (u = %4 %2) needs about %5 trials (%6 batches)</source>
        <translation>%3의 허용오차 %1 %2(u = %4 %2)에는 시행 약 %5회(묶음 %6개)가 필요합니다</translation>
    </message>
    <message>
        <source>to correct the bias of coordinate %1, give the number of observations n in its row: the uncertainty of the correction is u_var/sqrt(n)</source>
        <translation>좌표 %1의 편의를 보정하려면 그 행에 관측 횟수 n을 주십시오. 보정의 불확도는 u_var/sqrt(n)입니다</translation>
    </message>
    <message>
        <source>there are two points called &apos;%1&apos;; rename one</source>
        <translation>&apos;%1&apos;(이)라는 점이 두 개 있습니다. 하나의 이름을 바꾸십시오</translation>
    </message>
    <message>
        <source>there is no calibrated point called &apos;%1&apos;</source>
        <translation>&apos;%1&apos;(이)라는 교정된 점이 없습니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must consist of the letters x, y and z</source>
        <translation>&apos;%1&apos;은(는) 글자 x, y, z로 이루어져야 합니다</translation>
    </message>
    <message>
        <source>coordinate %1 has fewer than two observations that do not define the frame: measure more points or runs</source>
        <translation>좌표 %1에 좌표계를 정의하지 않는 관측값이 두 개보다 적습니다. 점 또는 회차를 더 측정하십시오</translation>
    </message>
    <message>
        <source>coordinate %1 has %2 rows; it must have one</source>
        <translation>좌표 %1의 행이 %2개입니다. 하나여야 합니다</translation>
    </message>
    <message>
        <source>the length standard needs at least two observations</source>
        <translation>길이 표준기에는 관측값이 두 개 이상 필요합니다</translation>
    </message>
    <message>
        <source>the table must have one row; it has %1</source>
        <translation>표에는 행이 하나 있어야 합니다. 지금은 %1개입니다</translation>
    </message>
    <message>
        <source>the analysis has no point called &apos;%1&apos;</source>
        <translation>분석에 &apos;%1&apos;(이)라는 점이 없습니다</translation>
    </message>
    <message>
        <source>point %1: %2</source>
        <translation>점 %1: %2</translation>
    </message>
    <message>
        <source>it is at the place of the instrument</source>
        <translation>측정기의 위치에 있습니다</translation>
    </message>
    <message>
        <source>it is out of the range or field of view of the instrument</source>
        <translation>측정기의 범위나 시야 밖에 있습니다</translation>
    </message>
    <message>
        <source>correlated coordinates of a station are combinations of independent deviations, which are normal: leave the distribution normal, or the correlation out</source>
        <translation>상관이 있는 스테이션 좌표는 정규인 독립 편차의 조합입니다. 분포를 정규로 두거나 상관을 빼십시오</translation>
    </message>
    <message>
        <source>a coordinate of the station is correlated with itself; name two different ones</source>
        <translation>스테이션의 좌표가 자기 자신과 상관되어 있습니다. 서로 다른 두 개를 지정하십시오</translation>
    </message>
    <message>
        <source>the range ends before it begins: the longest distance must be greater than the shortest</source>
        <translation>범위의 끝이 시작보다 앞에 있습니다. 최대 거리는 최소 거리보다 커야 합니다</translation>
    </message>
    <message>
        <source>the sensor reads nothing: choose a distance or an angle</source>
        <translation>센서가 아무것도 읽지 않습니다. 거리 또는 각을 선택하십시오</translation>
    </message>
    <message>
        <source>these coefficients are not possible together: their matrix has a negative eigenvalue</source>
        <translation>이 계수들은 함께 성립할 수 없습니다. 그 행렬에 음의 고유값이 있습니다</translation>
    </message>
    <message>
        <source>it is at the place of %1</source>
        <translation>%1의 위치에 있습니다</translation>
    </message>
    <message>
        <source>no sensor of the network sees it</source>
        <translation>네트워크의 어떤 센서도 보지 못합니다</translation>
    </message>
    <message>
        <source>it cannot be localised from what %1 read: the readings leave a direction undetermined; add a sensor or a reading</source>
        <translation>%1의 읽음값으로는 위치를 정할 수 없습니다. 한 방향이 정해지지 않습니다. 센서나 읽음값을 추가하십시오</translation>
    </message>
    <message>
        <source>the readings do not lead to a position of every target: the estimation does not converge from the nominal coordinates; look for exchanged or mistyped readings</source>
        <translation>읽음값에서 모든 표적의 위치를 구할 수 없습니다. 추정이 공칭 좌표에서 수렴하지 않습니다. 바뀌었거나 잘못 입력한 읽음값을 찾으십시오</translation>
    </message>
    <message>
        <source>%1 looks away from target %2: its angles point to the opposite side</source>
        <translation>%1이(가) 표적 %2의 반대쪽을 봅니다. 각이 반대쪽을 가리킵니다</translation>
    </message>
    <message>
        <source>there is no target %1</source>
        <translation>표적 %1이(가) 없습니다</translation>
    </message>
    <message>
        <source>%1 does not see target %2: it is out of its range or field of view</source>
        <translation>%1에서 표적 %2이(가) 보이지 않습니다. 측정 범위 또는 시야 밖에 있습니다</translation>
    </message>
    <message>
        <source>%1 does not see %2 of the %3 targets: they are out of its range or field of view</source>
        <translation>%1에서 표적 %3개 중 %2개가 보이지 않습니다. 측정 범위 또는 시야 밖에 있습니다</translation>
    </message>
    <message>
        <source>the sensor %1 is not listed in the network</source>
        <translation>센서 %1이(가) 센서망의 목록에 없습니다</translation>
    </message>
    <message>
        <source>%1 reads no %2 according to its description</source>
        <translation>%1은(는) 그 기술에 따르면 %2을(를) 읽지 않습니다</translation>
    </message>
    <message>
        <source>more than %1 rows for target %2</source>
        <translation>표적 %2의 행이 %1개를 넘습니다</translation>
    </message>
    <message>
        <source>target %1 is at the place of %2</source>
        <translation>표적 %1이(가) %2의 위치에 있습니다</translation>
    </message>
    <message>
        <source>target %1 is behind the camera %2</source>
        <translation>표적 %1이(가) 카메라 %2 뒤에 있습니다</translation>
    </message>
    <message>
        <source>a network has at most %1 sensors; divide it into several analyses</source>
        <translation>센서망의 센서는 최대 %1개입니다. 여러 분석으로 나누십시오</translation>
    </message>
    <message>
        <source>two targets are called %1</source>
        <translation>두 표적의 이름이 %1입니다</translation>
    </message>
    <message>
        <source>a distance needs two targets at different places</source>
        <translation>거리에는 서로 다른 위치의 표적 두 개가 필요합니다</translation>
    </message>
    <message>
        <source>a calibrated length needs two targets at different places</source>
        <translation>교정된 길이에는 서로 다른 위치의 표적 두 개가 필요합니다</translation>
    </message>
    <message>
        <source>the calibrated length is missing</source>
        <translation>교정된 길이가 없습니다</translation>
    </message>
    <message>
        <source>the nominal targets of the %1 are at another distance than its calibrated length; the design takes their distance</source>
        <translation>%1의 공칭 표적 사이 거리가 교정된 길이와 다릅니다. 설계에서는 그 거리를 사용합니다</translation>
    </message>
    <message>
        <source>a calibrated length can be a constraint only of the non-linear estimator with weights from readings and stations</source>
        <translation>교정된 길이는 읽음값과 스테이션으로 가중하는 비선형 추정 방법에서만 구속조건이 될 수 있습니다</translation>
    </message>
    <message>
        <source>the targets of the %1 belong to two set-ups, which are estimated one after the other: it can only be a check</source>
        <translation>%1의 표적이 차례로 추정되는 두 설치에 속합니다. 확인으로만 사용할 수 있습니다</translation>
    </message>
    <message>
        <source>the targets of an angle must be at three places off one line: at 0° and 180° an angle has no sign and no derivative</source>
        <translation>각의 표적은 한 직선 위에 있지 않은 세 위치에 있어야 합니다. 0°와 180°에서는 각에 부호도 도함수도 없습니다</translation>
    </message>
    <message>
        <source>the name %1 is taken by another frame or a target</source>
        <translation>이름 %1은(는) 다른 좌표계 또는 표적이 이미 사용합니다</translation>
    </message>
    <message>
        <source>the three targets of frame %1 lie on one line: its axes are undefined</source>
        <translation>좌표계 %1의 세 표적이 한 직선 위에 있습니다. 축이 정의되지 않습니다</translation>
    </message>
    <message>
        <source>the x-axis of frame %1 is vertical: its Z-Y-X angles are undefined (gimbal lock)</source>
        <translation>좌표계 %1의 x축이 수직입니다. Z-Y-X 각이 정의되지 않습니다(짐벌 록)</translation>
    </message>
    <message>
        <source>scale bar %1 – %2</source>
        <translation>스케일 바 %1 – %2</translation>
    </message>
    <message>
        <source>the sensor %1 is listed twice</source>
        <translation>센서 %1이(가) 목록에 두 번 있습니다</translation>
    </message>
    <message>
        <source>%1 The residuals are larger than the uncertainties allow; the largest for its uncertainty is the %2. Look for mistyped or exchanged readings, or figures of the instruments that are too small</source>
        <translation>%1 잔차가 불확도로 허용되는 것보다 큽니다. 불확도에 비해 가장 큰 것은 %2입니다. 잘못 입력하거나 바뀐 읽음값, 또는 측정기의 너무 작은 수치를 찾으십시오</translation>
    </message>
    <message>
        <source>distance of %1 by %2</source>
        <translation>%2이(가) 측정한 %1의 거리</translation>
    </message>
    <message>
        <source>azimuth of %1 by %2</source>
        <translation>%2이(가) 측정한 %1의 방위각</translation>
    </message>
    <message>
        <source>elevation of %1 by %2</source>
        <translation>%2이(가) 측정한 %1의 고도각</translation>
    </message>
    <message>
        <source>length of the %1</source>
        <translation>%1의 길이</translation>
    </message>
    <message>
        <source>Chi-square of the residuals: %1 with %2 degrees of freedom, p = %3.</source>
        <translation>잔차의 카이제곱: %1, 자유도 %2, p = %3.</translation>
    </message>
    <message>
        <source>no sensor</source>
        <translation>센서 없음</translation>
    </message>
    <message>
        <source>target %1 has no linear equations that localise it (a distance without angles has none): use the non-linear estimator</source>
        <translation>표적 %1에는 위치를 정하는 선형 방정식이 없습니다(각이 없는 거리에는 없음). 비선형 추정 방법을 사용하십시오</translation>
    </message>
    <message>
        <source>target %1 cannot be localised from what %2 read: the readings leave a direction undetermined; add a sensor or a reading</source>
        <translation>%2의 읽음값으로 표적 %1의 위치를 정할 수 없습니다. 읽음값으로 정해지지 않는 방향이 있습니다. 센서 또는 읽음값을 추가하십시오</translation>
    </message>
    <message>
        <source>target %1 is hardly localised: in one direction u is %2 m at a distance of %3 m</source>
        <translation>표적 %1의 위치가 거의 정해지지 않습니다. 한 방향에서 거리 %3 m에 u가 %2 m입니다</translation>
    </message>
    <message>
        <source>the stations that measure target %1 lie in one plane and read distances only: its mirror image behind that plane fits as well; the one near the nominal coordinates is taken</source>
        <translation>표적 %1을(를) 측정하는 스테이션이 한 평면에 있고 거리만 읽습니다. 그 평면 뒤의 거울상도 똑같이 맞습니다. 공칭 좌표에 가까운 것을 사용합니다</translation>
    </message>
    <message>
        <source>a calibrated length cannot be a constraint of a set-up with more than %1 readings (this one has %2): make it a check</source>
        <translation>읽음값이 %1개를 넘는 설치에서는 교정된 길이가 구속조건이 될 수 없습니다(여기에는 %2개). 확인으로 바꾸십시오</translation>
    </message>
    <message>
        <source>the %1 readings of one set-up are too many to be weighed together: each target is estimated from its own readings, weighted with the stations</source>
        <translation>한 설치의 읽음값 %1개는 함께 가중하기에 너무 많습니다. 각 표적을 그 자체의 읽음값으로 추정하고 스테이션과 함께 가중합니다</translation>
    </message>
    <message>
        <source>the standard uncertainty of a coordinate, %1 mm, is more than a tenth of the distance of point %2 from the x-axis, %3 mm: the law of propagation is not reliable here, look at Monte Carlo</source>
        <translation>좌표의 표준불확도 %1 mm가 점 %2의 x축까지 거리 %3 mm의 10분의 1보다 큽니다. 여기서는 전파 법칙을 믿을 수 없으니 몬테카를로를 보십시오</translation>
    </message>
    <message>
        <source>the frame made from these points lies %1 mm and %2° away from the axes in which they are given, so results differ from the table of poses; check the side of point 3 and the shift of the origin</source>
        <translation>이 점들로 만든 좌표계는 점이 주어진 축에서 %1 mm와 %2° 떨어져 있어 결과가 포즈 표와 다릅니다. 점 3의 쪽과 원점의 이동을 확인하십시오</translation>
    </message>
    <message>
        <source>%1: beta is within 2° of ±90°, where Z-Y-X angles are undefined (gimbal lock); state the orientation as a rotation vector</source>
        <translation>%1: beta가 Z-Y-X 각이 정의되지 않는 ±90°에서 2° 이내입니다(짐벌 록). 방향을 회전 벡터로 주십시오</translation>
    </message>
    <message>
        <source>%1: beta is within 2° of 0° or 180°, where Z-Y-Z angles are undefined (gimbal lock); state the orientation as Z-Y-X angles or a rotation vector</source>
        <translation>%1: beta가 Z-Y-Z 각이 정의되지 않는 0° 또는 180°에서 2° 이내입니다(짐벌 록). 방향을 Z-Y-X 각 또는 회전 벡터로 주십시오</translation>
    </message>
    <message>
        <source>%1: the rotation is within 4° of half a turn, where the sign of the axis is undefined; state the orientation as angles</source>
        <translation>%1: 회전이 축의 부호가 정의되지 않는 반 바퀴에서 4° 이내입니다. 방향을 각으로 주십시오</translation>
    </message>
    <message>
        <source>the analysis %1 has no point called &apos;%2&apos;</source>
        <translation>분석 %1에 &apos;%2&apos;(이)라는 점이 없습니다</translation>
    </message>
    <message>
        <source>point %1 cannot be measured by %2: %3</source>
        <translation>점 %1을(를) %2(으)로 측정할 수 없습니다: %3</translation>
    </message>
    <message>
        <source>the 3-2-1 method uses the first three points; point %1 and those after it are not used: choose least squares</source>
        <translation>3-2-1 방법은 처음 세 점을 사용합니다. 점 %1과 그 뒤의 점은 사용하지 않습니다. 최소제곱을 선택하십시오</translation>
    </message>
    <message>
        <source>the base frame is undefined</source>
        <translation>베이스 좌표계가 정해지지 않습니다</translation>
    </message>
    <message>
        <source>the moving frame is undefined</source>
        <translation>움직이는 좌표계가 정해지지 않습니다</translation>
    </message>
    <message>
        <source>points %1 and %2 coincide: %3</source>
        <translation>점 %1과 %2이(가) 일치합니다: %3</translation>
    </message>
    <message>
        <source>point %1 lies on the line through %2 and %3: %4</source>
        <translation>점 %1이(가) %2과(와) %3을(를) 지나는 직선 위에 있습니다: %4</translation>
    </message>
    <message>
        <source>all points lie on one line or coincide: their frame is undefined</source>
        <translation>모든 점이 한 직선 위에 있거나 일치합니다. 그 좌표계가 정의되지 않습니다</translation>
    </message>
    <message>
        <source>not used: the uncertainties come from an artefact or instrument</source>
        <translation>사용하지 않음: 불확도는 기준물 또는 측정기에서 옵니다</translation>
    </message>
    <message>
        <source>there are two poses called &apos;%1&apos;; rename one</source>
        <translation>&apos;%1&apos;(이)라는 포즈가 둘입니다. 하나의 이름을 바꾸십시오</translation>
    </message>
    <message>
        <source>no pose may be called &apos;base&apos;: that names the base among the measured points</source>
        <translation>포즈의 이름은 &apos;base&apos;일 수 없습니다. 측정점에서 베이스를 가리키는 이름입니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither &apos;base&apos; nor the name of a pose</source>
        <translation>&apos;%1&apos;은(는) &apos;base&apos;도 포즈의 이름도 아닙니다</translation>
    </message>
    <message>
        <source>there is no point called &apos;%1&apos; in that frame</source>
        <translation>그 좌표계에 &apos;%1&apos;(이)라는 점이 없습니다</translation>
    </message>
    <message>
        <source>point %1 of &apos;%2&apos; was not measured</source>
        <translation>&apos;%2&apos;의 점 %1이(가) 측정되지 않았습니다</translation>
    </message>
    <message>
        <source>the mirrored coordinates leave %1 instead of %2: frame 0 is left-handed, check the signs and the order of its axes</source>
        <translation>거울상 좌표의 잔차는 %2이(가) 아니라 %1입니다. 좌표계 0이 왼손 좌표계이므로 축의 부호와 순서를 확인하십시오</translation>
    </message>
    <message>
        <source>with %1 and %2 exchanged the residuals are %3 instead of %4: check the names</source>
        <translation>%1과(와) %2을(를) 바꾸면 잔차는 %4이(가) 아니라 %3입니다. 이름을 확인하십시오</translation>
    </message>
    <message>
        <source>the points of &apos;%1&apos; do not fit their nominal coordinates</source>
        <translation>&apos;%1&apos;의 점이 공칭 좌표와 맞지 않습니다</translation>
    </message>
    <message>
        <source>the points of &apos;%1&apos; do not fit their nominal coordinates within the stated uncertainties: chi-square %2 with %3 degrees of freedom; the largest normalised residual is %4 (%5)</source>
        <translation>&apos;%1&apos;의 점이 제시된 불확도 안에서 공칭 좌표와 맞지 않습니다. 카이제곱 %2, 자유도 %3. 가장 큰 정규화 잔차는 %4 (%5)</translation>
    </message>
    <message>
        <source>the lengths between the supports make no triangle: the longest of %1, %2 and %3 exceeds the sum of the others</source>
        <translation>받침 사이의 길이가 삼각형을 이루지 않습니다. %1, %2, %3 중 가장 긴 것이 나머지의 합보다 큽니다</translation>
    </message>
    <message>
        <source>the three supports lie on a line (%1, %2 and %3): they leave the place of the ball undetermined; move one of them aside</source>
        <translation>세 받침(%1, %2, %3)이 한 직선 위에 있어 구의 위치가 정해지지 않습니다. 하나를 옆으로 옮기십시오</translation>
    </message>
    <message>
        <source>the lengths of support %1 do not meet at its height: they miss by %2</source>
        <translation>지지점 %1의 길이가 그 높이에서 만나지 않습니다. %2만큼 어긋납니다</translation>
    </message>
    <message>
        <source>a set has at most %1 supports</source>
        <translation>한 세트의 지지점은 최대 %1개입니다</translation>
    </message>
    <message>
        <source>the rotation about %1</source>
        <translation>%1 둘레의 회전</translation>
    </message>
    <message>
        <source>%1 has %2 points; a plane needs three, and some more to be checked</source>
        <translation>%1에는 점이 %2개 있습니다. 평면에는 3개가 필요하고, 확인하려면 몇 개가 더 필요합니다</translation>
    </message>
    <message>
        <source>%1 has a span of zero: all its points coincide</source>
        <translation>%1의 범위가 0입니다. 모든 점이 일치합니다</translation>
    </message>
    <message>
        <source>the tool centre point lies on the axis of %1 (or the tool has no length): it traces no circle; turn about another axis</source>
        <translation>공구 중심점이 %1의 축 위에 있거나 공구에 길이가 없어 원을 그리지 않습니다. 다른 축 둘레로 회전하십시오</translation>
    </message>
    <message>
        <source>the arc of %1 spans only %2°: uncertainties grow as the inverse square of the span and may be %3 times those of half a turn</source>
        <translation>%1의 원호가 %2°에 불과합니다. 불확도는 범위의 제곱에 반비례하여 커지며 반 바퀴일 때의 %3배가 될 수 있습니다</translation>
    </message>
    <message>
        <source>point %1 is %2 mm on the other side of the supports&apos; plane, where the ballbars look for no solution; change their placement or their side</source>
        <translation>점 %1이(가) 볼바가 해를 찾지 않는 지지점 평면의 반대쪽 %2 mm에 있습니다. 볼바의 배치나 쪽을 바꾸십시오</translation>
    </message>
    <message>
        <source>point %1 is only %2 mm from the supports&apos; plane, with a standard uncertainty of %3 mm in that direction: in some trials the lengths will not meet (negative root), and u is not to be trusted</source>
        <translation>점 %1이(가) 지지점 평면에서 %2 mm밖에 떨어져 있지 않고 그 방향의 표준불확도가 %3 mm입니다. 일부 시행에서 길이가 만나지 않아(음수의 제곱근) u를 믿을 수 없습니다</translation>
    </message>
    <message>
        <source>the measured points determine no sphere and no axes: they lie on one circle, or coincide; check their axes and angles</source>
        <translation>측정점이 구와 축을 정하지 못합니다. 한 원 위에 있거나 일치합니다. 축과 각을 확인하십시오</translation>
    </message>
    <message>
        <source>a procedure has at most %1 points</source>
        <translation>한 절차의 점은 최대 %1개입니다</translation>
    </message>
    <message>
        <source>two points are called %1</source>
        <translation>두 점의 이름이 %1입니다</translation>
    </message>
    <message>
        <source>the flange turns about %1 in two rotations; put their points into one</source>
        <translation>플랜지가 두 회전에서 %1 둘레로 회전합니다. 그 점들을 한 회전으로 합치십시오</translation>
    </message>
    <message>
        <source>one rotation traces one circle, which leaves the centre of the flange and its axes undetermined: add a rotation about another axis</source>
        <translation>회전 하나는 원 하나를 그리므로 플랜지의 중심과 축이 정해지지 않습니다. 다른 축 둘레의 회전을 추가하십시오</translation>
    </message>
    <message>
        <source>no rotation measures axis %1: choose another way to make the axes, or add the rotation</source>
        <translation>축 %1을(를) 측정하는 회전이 없습니다. 축을 만드는 다른 방법을 선택하거나 회전을 추가하십시오</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not offer &apos;%2&apos;</source>
        <translation>&apos;%1&apos;은(는) &apos;%2&apos;을(를) 제공하지 않습니다</translation>
    </message>
    <message>
        <source>column %1: %2</source>
        <translation>열 %1: %2</translation>
    </message>
    <message>
        <source>it is called like a joint of a gripper</source>
        <translation>그리퍼의 관절과 같은 이름입니다</translation>
    </message>
    <message>
        <source>others follow it at the end of the arm, as in a gripper</source>
        <translation>그리퍼처럼 팔 끝에서 다른 관절이 이를 따릅니다</translation>
    </message>
    <message>
        <source>it slides by less than 100 mm at the end of the arm, as in a gripper</source>
        <translation>그리퍼처럼 팔 끝에서 100 mm 미만으로 미끄러집니다</translation>
    </message>
    <message>
        <source>it is one of several at the end of the arm, as in a hand</source>
        <translation>손처럼 팔 끝에 있는 여러 관절 중 하나입니다</translation>
    </message>
    <message>
        <source>no joint leads to a link called %1</source>
        <translation>%1(이)라는 링크로 이어지는 관절이 없습니다</translation>
    </message>
    <message>
        <source>no moving joint leads to %1</source>
        <translation>%1(으)로 이어지는 움직이는 관절이 없습니다</translation>
    </message>
    <message>
        <source>the links form a ring; URDF describes trees</source>
        <translation>링크가 고리를 이룹니다. URDF는 트리를 기술합니다</translation>
    </message>
    <message>
        <source>joint %1 on the way to %2 is of the type %3: freeze it, --freeze %1=0</source>
        <translation>%2(으)로 가는 관절 %1의 종류는 %3입니다. 고정하십시오, --freeze %1=0</translation>
    </message>
    <message>
        <source>joint %1 on the way to %2 follows joint %3: freeze it, --freeze %1=0</source>
        <translation>%2(으)로 가는 관절 %1은(는) 관절 %3을(를) 따릅니다. 고정하십시오, --freeze %1=0</translation>
    </message>
    <message>
        <source>no arm: joint %1 was left out because %2</source>
        <translation>팔이 아님: 관절 %1이(가) 제외됨: %2</translation>
    </message>
    <message>
        <source>no arm: joint %1 is of the type %2</source>
        <translation>팔이 아님: 관절 %1의 종류가 %2임</translation>
    </message>
    <message>
        <source>no arm: joint %1 follows joint %2</source>
        <translation>팔이 아님: 관절 %1이(가) 관절 %2을(를) 따름</translation>
    </message>
    <message>
        <source>left out: it is of the type %1</source>
        <translation>제외: 종류가 %1임</translation>
    </message>
    <message>
        <source>left out: it follows joint %1</source>
        <translation>제외: 관절 %1을(를) 따름</translation>
    </message>
    <message>
        <source>left out: %1</source>
        <translation>제외: %1</translation>
    </message>
    <message>
        <source>left out: it is not on the way to %1</source>
        <translation>제외: %1(으)로 가는 경로에 없음</translation>
    </message>
    <message>
        <source>the file has no moving joint</source>
        <translation>파일에 움직이는 관절이 없습니다</translation>
    </message>
    <message>
        <source>the file has several arms of equal length, ending at %1 and %2: name the tip link of the one to import</source>
        <translation>파일에 길이가 같은 로봇 팔이 여러 개 있으며 %1과(와) %2에서 끝납니다. 가져올 로봇 팔의 끝 링크를 지정하십시오</translation>
    </message>
    <message>
        <source>frozen: %1</source>
        <translation>고정: %1</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not three numbers</source>
        <translation>&apos;%1&apos;은(는) 수 세 개가 아닙니다</translation>
    </message>
    <message>
        <source>joint %1 does not say which links it joins</source>
        <translation>관절 %1에 어떤 링크를 잇는지 적혀 있지 않습니다</translation>
    </message>
    <message>
        <source>joint %1: %2</source>
        <translation>관절 %1: %2</translation>
    </message>
    <message>
        <source>joint %1: its axis has no direction</source>
        <translation>관절 %1: 축에 방향이 없습니다</translation>
    </message>
    <message>
        <source>not readable as XML: %1</source>
        <translation>XML로 읽을 수 없음: %1</translation>
    </message>
    <message>
        <source>no URDF: its root element &lt;robot&gt; is missing</source>
        <translation>URDF가 아닙니다. 루트 요소 &lt;robot&gt;이 없습니다</translation>
    </message>
    <message>
        <source>the file has xacro macros: expand them first (xacro FILE &gt; arm.urdf)</source>
        <translation>파일에 xacro 매크로가 있습니다. 먼저 펼치십시오(xacro FILE &gt; arm.urdf)</translation>
    </message>
    <message>
        <source>link %1 hangs on two joints; URDF describes trees</source>
        <translation>링크 %1이(가) 두 관절에 달려 있습니다. URDF는 트리를 기술합니다</translation>
    </message>
    <message>
        <source>there is no joint %1 to freeze%2</source>
        <translation>고정할 관절 %1이(가) 없습니다%2</translation>
    </message>
    <message>
        <source>joint %1 does not move, or is frozen twice</source>
        <translation>관절 %1은(는) 움직이지 않거나 두 번 고정되었습니다</translation>
    </message>
    <message>
        <source>joint %1 is of the type %2: it can be frozen at 0 only</source>
        <translation>관절 %1의 유형은 %2입니다. 0에서만 고정할 수 있습니다</translation>
    </message>
    <message>
        <source>frozen at %1, beyond its limits</source>
        <translation>한계를 벗어난 %1에 고정</translation>
    </message>
    <message>
        <source>frozen at %1</source>
        <translation>%1에 고정</translation>
    </message>
    <message>
        <source>an arm has at most %1 joints here</source>
        <translation>여기서 로봇 팔의 관절은 최대 %1개입니다</translation>
    </message>
    <message>
        <source>joint %1 slides: state its readings as lengths, in the columns of s</source>
        <translation>관절 %1은(는) 미끄럼 관절입니다. 읽음값을 s의 열에 길이로 제시하십시오</translation>
    </message>
    <message>
        <source>joint %1 turns: state its readings as angles, or give it the type sliding</source>
        <translation>관절 %1은(는) 회전 관절입니다. 읽음값을 각도로 제시하거나 종류를 미끄럼으로 하십시오</translation>
    </message>
    <message>
        <source>joint %1</source>
        <translation>관절 %1</translation>
    </message>
    <message>
        <source>only the convention with Ry(beta) has a beta; leave it empty for %1, or choose that convention</source>
        <translation>Ry(beta)가 있는 규약에만 beta가 있습니다. %1에는 비워 두거나 그 규약을 선택하십시오</translation>
    </message>
    <message>
        <source>d and beta of %1 describe the same place of a parallel axis: where beta is given, d is 0 by definition</source>
        <translation>%1의 d와 beta는 평행한 축의 같은 위치를 기술합니다. beta가 있으면 d는 정의상 0입니다</translation>
    </message>
    <message>
        <source>the lowest reading of %1 is not below its highest</source>
        <translation>%1의 최소 읽음값이 최대 읽음값보다 작지 않습니다</translation>
    </message>
    <message>
        <source>the robot has no joint %1</source>
        <translation>로봇에 관절 %1이(가) 없습니다</translation>
    </message>
    <message>
        <source>%1 is 0 by definition, because the axis is parallel to the next</source>
        <translation>축이 다음 축과 평행하므로 %1은(는) 정의상 0입니다</translation>
    </message>
    <message>
        <source>%1 is no parameter of this robot: give beta in the table of joints where axes are parallel</source>
        <translation>%1은(는) 이 로봇의 매개변수가 아닙니다. 축이 평행하면 관절 표에 beta를 주십시오</translation>
    </message>
    <message>
        <source>a parameter is correlated with itself; name two different ones</source>
        <translation>매개변수가 자기 자신과 상관되어 있습니다. 서로 다른 두 개를 지정하십시오</translation>
    </message>
    <message>
        <source>there is no parameter &apos;%1&apos; with an uncertainty; write its symbol, such as d_3</source>
        <translation>불확도가 있는 매개변수 &apos;%1&apos;이(가) 없습니다. d_3처럼 그 기호를 적으십시오</translation>
    </message>
    <message>
        <source>%1 has several components of uncertainty: give it one, the combined, so that it can be correlated</source>
        <translation>%1에는 불확도 성분이 여러 개 있습니다. 상관을 줄 수 있도록 합성한 성분 하나만 주십시오</translation>
    </message>
    <message>
        <source>there is no pose: give joint readings or a place of the tool</source>
        <translation>포즈가 없습니다. 관절 읽음값 또는 공구의 위치를 주십시오</translation>
    </message>
    <message>
        <source>two poses are called %1</source>
        <translation>두 포즈의 이름이 %1입니다</translation>
    </message>
    <message>
        <source>pose %1: reading %2 of joint %3 is beyond its limits, %4 to %5</source>
        <translation>포즈 %1: 관절 %3의 읽음값 %2이(가) 한계 %4~%5을(를) 벗어납니다</translation>
    </message>
    <message>
        <source>pose %1: the orientation is within 2° of one that %2 cannot state (gimbal lock, half turn); state it otherwise</source>
        <translation>포즈 %1: 방향이 %2(으)로 나타낼 수 없는 방향에서 2° 이내입니다(짐벌 록, 반 바퀴). 다른 방식으로 주십시오</translation>
    </message>
    <message>
        <source>%1 has only %2 joints; leave %3 empty</source>
        <translation>%1의 관절은 %2개뿐입니다. %3을(를) 비워 두십시오</translation>
    </message>
    <message>
        <source>joint %1 of %2 slides: its reading is %3</source>
        <translation>%2의 관절 %1은(는) 미끄럼 관절입니다. 읽음값은 %3입니다</translation>
    </message>
    <message>
        <source>joint %1 of %2 turns: its reading is %3</source>
        <translation>%2의 관절 %1은(는) 회전 관절입니다. 읽음값은 %3입니다</translation>
    </message>
    <message>
        <source>pose %1: give all three angles or none</source>
        <translation>포즈 %1: 세 각을 모두 주거나 모두 비워 두십시오</translation>
    </message>
    <message>
        <source>pose %1: no readings within the limits of the joints bring the tool there; the nearest attempt misses the place by %2 but not the orientation</source>
        <translation>포즈 %1: 관절 한계 안의 어떤 읽음값도 공구를 그곳으로 보내지 못합니다. 가장 가까운 시도의 위치 차이는 %2이지만 방향은 맞습니다</translation>
    </message>
    <message>
        <source>pose %1: no readings within the limits of the joints bring the tool there; the nearest attempt misses the place by %2</source>
        <translation>포즈 %1: 관절 한계 안의 어떤 읽음값도 공구를 그곳으로 보내지 못합니다. 가장 가까운 시도의 위치 차이는 %2입니다</translation>
    </message>
    <message>
        <source>without limits</source>
        <translation>한계 없음</translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <translation>%1~%2 %3</translation>
    </message>
    <message>
        <source>%1 mm, turned by %2 deg</source>
        <translation>%1 mm, %2 deg 회전</translation>
    </message>
    <message>
        <source>joint %1: %2, slides, %3</source>
        <translation>관절 %1: %2, 미끄럼, %3</translation>
    </message>
    <message>
        <source>joint %1: %2, turns, %3</source>
        <translation>관절 %1: %2, 회전, %3</translation>
    </message>
    <message>
        <source>%1 joint from link %2 to link %3</source>
        <translation>관절 %1개, 링크 %2에서 링크 %3까지</translation>
    </message>
    <message>
        <source>%1 joints from link %2 to link %3</source>
        <translation>관절 %1개, 링크 %2에서 링크 %3까지</translation>
    </message>
    <message>
        <source>tool: link %1 at %2 from the frame of the last joint</source>
        <translation>공구: 링크 %1, 마지막 관절의 좌표계에서 %2</translation>
    </message>
    <message>
        <source>with all readings at 0 the tool stands at %1 in link %2</source>
        <translation>모든 읽음값이 0일 때 공구는 링크 %2의 %1에 있습니다</translation>
    </message>
    <message>
        <source>the chain to %1 has %2 moving joints; an arm has at most %3 here: freeze those before the arm, --freeze %4=0</source>
        <translation>%1까지의 사슬에 움직이는 관절이 %2개 있습니다. 여기서 로봇 팔의 관절은 최대 %3개입니다. 로봇 팔 앞의 관절을 고정하십시오, --freeze %4=0</translation>
    </message>
    <message>
        <source>pose %1: the residual of its %2 is %3 times its standard uncertainty (limit %4). Look at this pose first; hold it back by use = check</source>
        <translation>포즈 %1: %2의 잔차가 표준불확도의 %3배입니다(한계 %4). 이 포즈를 먼저 살펴보고, use = check로 맞춤에서 제외하십시오</translation>
    </message>
    <message>
        <source>the residuals are %1 times as large as the uncertainties of points and readings explain: there is more than these (a joint&apos;s elasticity, temperature, an outlier), and the uncertainty of the parameters is stated too small</source>
        <translation>잔차가 점과 읽음값의 불확도로 설명되는 것의 %1배입니다. 이보다 더한 것(관절의 탄성, 온도, 이상값)이 있으며, 매개변수의 불확도가 너무 작게 제시됩니다</translation>
    </message>
    <message>
        <source>these poses hardly tell %1 apart (condition %2): turn more joints further, or hold one of them</source>
        <translation>이 포즈들로는 %1을(를) 거의 구별할 수 없습니다(조건수 %2). 더 많은 관절을 더 크게 돌리거나, 그중 하나를 고정하십시오</translation>
    </message>
    <message>
        <source>no parameter of the arm can be told from these poses: every one of them is coupled with others or held</source>
        <translation>이 포즈들로는 로봇 팔의 어떤 매개변수도 알 수 없습니다. 모두 다른 매개변수와 결합되어 있거나 고정되어 있습니다</translation>
    </message>
    <message>
        <source>the poses of the fit give %1 coordinates, no more than there are unknowns to find: measure more poses, or hold parameters</source>
        <translation>맞춤의 포즈가 주는 좌표는 %1개로, 구할 미지수보다 많지 않습니다. 포즈를 더 측정하거나 매개변수를 고정하십시오</translation>
    </message>
    <message>
        <source>the fit does not converge: look for exchanged poses, readings of the wrong sign or in another unit, and for a nominal robot that is another arm</source>
        <translation>맞춤이 수렴하지 않습니다. 바뀐 포즈, 부호나 단위가 틀린 읽음값, 다른 로봇 팔인 공칭 로봇이 없는지 찾으십시오</translation>
    </message>
    <message>
        <source>at the solution the unknowns cannot be told apart; hold one of those that the table of observability names</source>
        <translation>해에서 미지수들을 구별할 수 없습니다. 관측 가능성 표에 있는 것 중 하나를 고정하십시오</translation>
    </message>
    <message>
        <source>joint %1 slides: only arms whose joints turn are identified; take an arm without it, as it stands during the measurement</source>
        <translation>관절 %1은(는) 직선 관절입니다. 회전 관절만 있는 로봇 팔만 식별합니다. 측정하는 동안의 상태로 그 관절을 뺀 로봇 팔을 사용하십시오</translation>
    </message>
    <message>
        <source>the fit has %1 poses; it needs three or more, and about twenty to tell all parameters</source>
        <translation>맞춤에 포즈가 %1개 있습니다. 3개 이상이 필요하고, 모든 매개변수를 알려면 약 20개가 필요합니다</translation>
    </message>
    <message>
        <source>the robot has only %1 joints; leave %2 empty</source>
        <translation>로봇의 관절은 %1개뿐입니다. %2을(를) 비워 두십시오</translation>
    </message>
    <message>
        <source>pose %1: its orientation is missing; give alpha, beta and gamma of every pose, or fit positions alone</source>
        <translation>포즈 %1: 방향이 없습니다. 모든 포즈의 alpha, beta, gamma를 주거나 위치만으로 맞추십시오</translation>
    </message>
    <message>
        <source>the robot has no parameter &apos;%1&apos; to hold; write its symbol, such as d_3</source>
        <translation>로봇에는 고정할 매개변수 &apos;%1&apos;이(가) 없습니다. d_3처럼 그 기호를 적으십시오</translation>
    </message>
    <message>
        <source>rotation about %1</source>
        <translation>%1 둘레의 회전</translation>
    </message>
    <message>
        <source>base %1</source>
        <translation>베이스 점 %1</translation>
    </message>
    <message>
        <source>tool %1</source>
        <translation>공구 %1</translation>
    </message>
    <message>
        <source>the points do not lead to parameters of the arm</source>
        <translation>점들에서 로봇 팔의 매개변수를 구할 수 없습니다</translation>
    </message>
    <message>
        <source>the points of %1 run against the positive direction of the joint: reverse their order, or give its readings</source>
        <translation>%1의 점들이 관절의 양의 방향과 반대로 진행합니다. 순서를 뒤집거나 관절의 읽음값을 주십시오</translation>
    </message>
    <message>
        <source>the axes of joints %1 and %2</source>
        <translation>관절 %1과(와) %2의 축</translation>
    </message>
    <message>
        <source>%1 are nearly parallel (%2): they are described by beta with d = 0, because the place of their common perpendicular is hardly determined</source>
        <translation>%1이(가) 거의 평행합니다(%2). 공통 수선의 위치가 거의 정해지지 않으므로 d = 0과 beta로 기술합니다</translation>
    </message>
    <message>
        <source>%1 are %2 apart: they are described by d without beta, although the nominal robot has beta</source>
        <translation>%1이(가) %2만큼 떨어져 있습니다. 공칭 로봇에는 beta가 있지만 beta 없이 d로 기술합니다</translation>
    </message>
    <message>
        <source>the axes of joints %1 and %2 are the same line: nothing tells their frames apart</source>
        <translation>관절 %1과 %2의 축이 같은 직선입니다. 두 좌표계를 구별할 수 없습니다</translation>
    </message>
    <message>
        <source>parameters are identified by Eq 5: describe the nominal robot in that convention, not in Craig&apos;s</source>
        <translation>매개변수는 식 5로 식별합니다. 공칭 로봇을 Craig 규약이 아니라 그 규약으로 기술하십시오</translation>
    </message>
    <message>
        <source>joint %1 slides and draws no circle: take an arm without it, as it stands during the measurement</source>
        <translation>관절 %1은(는) 직선 관절이라 원을 그리지 않습니다. 측정하는 동안의 상태로 그 관절을 뺀 로봇 팔을 사용하십시오</translation>
    </message>
    <message>
        <source>an arm of one joint has no parameters between two axes</source>
        <translation>관절이 하나인 로봇 팔에는 두 축 사이의 매개변수가 없습니다</translation>
    </message>
    <message>
        <source>the robot has no %1</source>
        <translation>로봇에 %1이(가) 없습니다</translation>
    </message>
    <message>
        <source>%1 has %2 points; a circle needs three or more</source>
        <translation>%1에는 점이 %2개 있습니다. 원에는 3개 이상이 필요합니다</translation>
    </message>
    <message>
        <source>the ball hardly moves while %1 turns: it lies on the axis of that joint and draws no circle. Fix the ball off the axis</source>
        <translation>%1이(가) 회전하는 동안 볼이 거의 움직이지 않습니다. 볼이 그 관절의 축 위에 있어 원을 그리지 않습니다. 볼을 축에서 벗어나게 고정하십시오</translation>
    </message>
    <message>
        <source>the points of %1 lie on a straight line, as far as their uncertainty lets it be seen: no circle goes through them. Turn the joint further</source>
        <translation>%1의 점들이 불확도로 알 수 있는 한 한 직선 위에 있습니다. 이 점들을 지나는 원이 없습니다. 관절을 더 크게 돌리십시오</translation>
    </message>
    <message>
        <source>the arc of %1 over %2 is short for the uncertainty of its points: its axis will be known poorly</source>
        <translation>%1의 %2 원호가 점의 불확도에 비해 짧습니다. 축이 부정확하게 구해집니다</translation>
    </message>
    <message>
        <source>the plane of %1 passes the origin at %2: Eq 1 excludes planes through the origin and fails near it. Use total least squares</source>
        <translation>%1의 평면이 원점에서 %2 떨어져 지나갑니다. 식 1은 원점을 지나는 평면을 제외하고 그 근처에서 실패합니다. 전최소제곱을 사용하십시오</translation>
    </message>
    <message>
        <source>no circle fits the points of %1; look for exchanged points</source>
        <translation>%1의 점에 맞는 원이 없습니다. 바뀐 점을 찾으십시오</translation>
    </message>
    <message>
        <source>the calibration matrix is singular: the channels answer to loads on %1 alike, so these cannot be told apart</source>
        <translation>교정 행렬이 특이합니다. 채널들이 %1의 하중에 똑같이 반응하여 이들을 구별할 수 없습니다</translation>
    </message>
    <message>
        <source>the calibration matrix has the condition number %1: loads on %2 are hardly told apart</source>
        <translation>교정 행렬의 조건수가 %1입니다. %2의 하중을 거의 구별할 수 없습니다</translation>
    </message>
    <message>
        <source>add a row of loads to be evaluated</source>
        <translation>평가할 하중의 행을 추가하십시오</translation>
    </message>
    <message>
        <source>add a row of readings to be decoupled</source>
        <translation>간섭을 보상할 읽음값의 행을 추가하십시오</translation>
    </message>
    <message>
        <source>two cases are called &apos;%1&apos;</source>
        <translation>두 경우의 이름이 &apos;%1&apos;입니다</translation>
    </message>
    <message>
        <source>channel %1 has no reading: all channels are needed</source>
        <translation>채널 %1에 읽음값이 없습니다. 모든 채널이 필요합니다</translation>
    </message>
    <message>
        <source>the sensor has no channel %1</source>
        <translation>센서에 채널 %1이(가) 없습니다</translation>
    </message>
    <message>
        <source>no load gives these readings by the calibration matrix</source>
        <translation>교정 행렬로 이 읽음값을 주는 하중이 없습니다</translation>
    </message>
    <message>
        <source>the load on %1 is %2 % of its rated load: the calibration says nothing about it</source>
        <translation>%1의 하중이 정격하중의 %2 %입니다. 교정에는 이에 대한 정보가 없습니다</translation>
    </message>
    <message>
        <source>loads on %1 are too few for this calibration matrix</source>
        <translation>이 교정 행렬에는 %1의 하중이 너무 적습니다</translation>
    </message>
    <message>
        <source>the interference of %1 is known without signs: it cannot be compensated. Give raw readings, or a table with signs</source>
        <translation>%1의 간섭에 부호가 알려져 있지 않아 보상할 수 없습니다. 원시 읽음값 또는 부호가 있는 표를 주십시오</translation>
    </message>
    <message>
        <source>quadratic terms need raw readings; %1 has a summary only</source>
        <translation>이차항에는 원시 읽음값이 필요합니다. %1에는 요약만 있습니다</translation>
    </message>
    <message>
        <source>channel %1 is listed twice</source>
        <translation>채널 %1이(가) 목록에 두 번 있습니다</translation>
    </message>
    <message>
        <source>moment</source>
        <translation>모멘트</translation>
    </message>
    <message>
        <source>force</source>
        <translation>힘</translation>
    </message>
    <message>
        <source>channel %1 needs its rated load, a %2</source>
        <translation>채널 %1에 정격하중(%2)이 필요합니다</translation>
    </message>
    <message>
        <source>%1 states no uncertainty of its load on %2: add it to its certificate</source>
        <translation>%1에 %2의 하중 불확도가 없습니다. 성적서에 추가하십시오</translation>
    </message>
    <message>
        <source>increasing loads</source>
        <translation>증가 하중</translation>
    </message>
    <message>
        <source>unloaded reading before</source>
        <translation>사전 무하중 읽음값</translation>
    </message>
    <message>
        <source>run %1 of %2 has no %3: it is left out</source>
        <translation>%2의 회차 %1에 %3이(가) 없어 제외합니다</translation>
    </message>
    <message>
        <source>%1 was not calibrated: there are no runs with its axis loaded</source>
        <translation>%1이(가) 교정되지 않았습니다. 그 축에 하중을 가한 회차가 없습니다</translation>
    </message>
    <message>
        <source>%1 has one run only: its repeatability needs two or more</source>
        <translation>%1의 회차가 하나뿐입니다. 반복성에는 2회 이상이 필요합니다</translation>
    </message>
    <message>
        <source>%1 has %2 runs, %3 are planned: its means have %4 degrees of freedom</source>
        <translation>%1의 회차는 %2회이고 계획은 %3회입니다. 평균의 자유도는 %4입니다</translation>
    </message>
    <message>
        <source>%1 has %2 preloads, %3 are planned</source>
        <translation>%1의 예비하중은 %2회이고 계획은 %3회입니다</translation>
    </message>
    <message>
        <source>, and it says nothing about repeatability</source>
        <translation>, 반복성에 대해서는 알 수 없습니다</translation>
    </message>
    <message>
        <source>step %1 of %2 is missing in %3 of %4 runs: its mean is that of %5%6</source>
        <translation>%2의 단계 %1이(가) %4회 중 %3회에 없습니다. 평균은 %5회의 평균입니다%6</translation>
    </message>
    <message>
        <source>%1 was loaded in %2 steps, %3 are planned</source>
        <translation>%1에 %2단계로 하중을 가했고 계획은 %3단계입니다</translation>
    </message>
    <message>
        <source>the largest load on %1 is %2; the rated output needs the rated load, %3</source>
        <translation>%1의 최대 하중이 %2입니다. 정격출력에는 정격하중 %3이(가) 필요합니다</translation>
    </message>
    <message>
        <source>%1 has the same reading in all runs: its repeatability is evaluated as zero</source>
        <translation>%1의 읽음값이 모든 회차에서 같습니다. 반복성을 0으로 평가합니다</translation>
    </message>
    <message>
        <source>%1 has no unloaded readings after a run: its non-zero error is taken as zero</source>
        <translation>%1에 회차 후의 무하중 읽음값이 없습니다. 영점 오차를 0으로 봅니다</translation>
    </message>
    <message>
        <source>%1 has no decreasing loads: its hysteresis is not known and is taken as zero</source>
        <translation>%1에 감소 하중이 없습니다. 히스테리시스를 알 수 없어 0으로 봅니다</translation>
    </message>
    <message>
        <source>run %1 of %2 reads the same at steps %3 and %4 although the load rises: the indicator is saturated or the channel is stuck</source>
        <translation>%2의 회차 %1에서 하중이 커지는데도 단계 %3과 %4의 읽음값이 같습니다. 지시계가 포화되었거나 채널이 멈췄습니다</translation>
    </message>
    <message>
        <source>run %1 of %2: only %3 s between steps %4 and %5, %6 s are planned</source>
        <translation>%2의 회차 %1: 단계 %4과 %5 사이가 %3 s뿐이며 계획은 %6 s입니다</translation>
    </message>
    <message>
        <source>run %1 of %2 begins %3 s after the one before was unloaded, %4 s are planned</source>
        <translation>%2의 회차 %1이(가) 앞 회차의 하중을 제거한 지 %3 s 뒤에 시작하며 계획은 %4 s입니다</translation>
    </message>
    <message>
        <source>channel %1 does not respond to its load: %2 at the rated load; look at its cable and its column</source>
        <translation>채널 %1이(가) 하중에 반응하지 않습니다. 정격하중에서 %2입니다. 케이블과 열을 살펴보십시오</translation>
    </message>
    <message>
        <source>channel %1 responds to %2 more than to its own load: are columns exchanged?</source>
        <translation>채널 %1이(가) 자체 하중보다 %2에 더 크게 반응합니다. 열이 바뀌지 않았습니까?</translation>
    </message>
    <message>
        <source>there are no readings: import them from a CSV file, or choose summary tables</source>
        <translation>읽음값이 없습니다. CSV 파일에서 가져오거나 요약표를 선택하십시오</translation>
    </message>
    <message>
        <source>the sensor has no channel %1: list it among its channels</source>
        <translation>센서에 채널 %1이(가) 없습니다. 채널 목록에 추가하십시오</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no unit of a load: %2</source>
        <translation>&apos;%1&apos;은(는) 하중의 단위가 아닙니다: %2</translation>
    </message>
    <message>
        <source>%1 is a moment, but its load is in %2: are forces and moments, or their units, exchanged?</source>
        <translation>%1은(는) 모멘트이지만 하중은 %2(으)로 되어 있습니다. 힘과 모멘트 또는 그 단위가 바뀌지 않았습니까?</translation>
    </message>
    <message>
        <source>%1 is a force, but its load is in %2: are forces and moments, or their units, exchanged?</source>
        <translation>%1은(는) 힘이지만 하중은 %2(으)로 되어 있습니다. 힘과 모멘트 또는 그 단위가 바뀌지 않았습니까?</translation>
    </message>
    <message>
        <source>a load of %1 is more than 1.2 times the rated load of %2, %3: is its unit right?</source>
        <translation>하중 %1이(가) %2의 정격하중 %3의 1.2배를 넘습니다. 단위가 맞습니까?</translation>
    </message>
    <message>
        <source>channel %1 has no reading in this row</source>
        <translation>이 행에 채널 %1의 읽음값이 없습니다</translation>
    </message>
    <message>
        <source>channel %1 indicates %2 mV/V, which is the end of the indicator&apos;s range: the reading is saturated</source>
        <translation>채널 %1의 지시값이 지시계 범위의 끝인 %2 mV/V입니다. 읽음값이 포화되었습니다</translation>
    </message>
    <message>
        <source>this run has its unloaded reading already</source>
        <translation>이 회차에는 무하중 읽음값이 이미 있습니다</translation>
    </message>
    <message>
        <source>step %1 of this run is given twice</source>
        <translation>이 회차의 단계 %1이(가) 두 번 주어졌습니다</translation>
    </message>
    <message>
        <source>channel %1 has no row in the summary</source>
        <translation>요약에 채널 %1의 행이 없습니다</translation>
    </message>
    <message>
        <source>%1 has no row in the table of interference: taken as zero</source>
        <translation>간섭 표에 %1의 행이 없습니다. 0으로 봅니다</translation>
    </message>
    <message>
        <source>axis %1 is listed twice</source>
        <translation>축 %1이(가) 목록에 두 번 있습니다</translation>
    </message>
    <message>
        <source>the sensor&apos;s calibration is a summary: there are no steps to pool over, so the largest standard deviation is taken</source>
        <translation>센서의 교정이 요약입니다. 합동할 단계가 없으므로 가장 큰 표준편차를 사용합니다</translation>
    </message>
    <message>
        <source>the name is one of a function or a word of the equations; choose another</source>
        <translation>함수의 이름이거나 방정식에 쓰이는 단어입니다. 다른 이름을 선택하십시오</translation>
    </message>
    <message>
        <source>a symbol is made of letters, Greek ones too, digits and &apos;_&apos;, a letter first</source>
        <translation>기호는 글자(그리스 문자 포함), 숫자, &apos;_&apos;로 이루어지며 글자로 시작합니다</translation>
    </message>
    <message>
        <source>only the first row of a symbol has a value; further rows add components</source>
        <translation>기호의 첫 행에만 값이 있습니다. 이후의 행은 성분을 추가합니다</translation>
    </message>
    <message>
        <source>the component is in %1, the quantity in %2</source>
        <translation>성분의 단위는 %1, 양의 단위는 %2입니다</translation>
    </message>
    <message>
        <source>a further row states a component of uncertainty</source>
        <translation>추가 행은 불확도 성분을 제시합니다</translation>
    </message>
    <message>
        <source>the instrument of the project is missing</source>
        <translation>프로젝트의 측정기가 없습니다</translation>
    </message>
    <message>
        <source>the reading of an instrument needs a value</source>
        <translation>측정기의 읽음값에는 값이 필요합니다</translation>
    </message>
    <message>
        <source>an instrument reads distances here; the unit must be one of length</source>
        <translation>여기서 측정기는 거리를 읽습니다. 단위는 길이의 단위여야 합니다</translation>
    </message>
    <message>
        <source>%1 reads no distances</source>
        <translation>%1은(는) 거리를 읽지 않습니다</translation>
    </message>
    <message>
        <source>the value is missing, and no statement gives it</source>
        <translation>값이 없고, 값을 주는 표기도 없습니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has observations and no row in the table of quantities</source>
        <translation>&apos;%1&apos;에는 관측값이 있지만 양 표에 행이 없습니다</translation>
    </message>
    <message>
        <source>Newton&apos;s method finds no solution of this equation from the starting value, at the estimates of the quantities</source>
        <translation>양들의 추정값에서 뉴턴법이 시작값으로부터 이 식의 해를 찾지 못합니다</translation>
    </message>
    <message>
        <source>this operation has no value at the estimates of the quantities (division by zero, root or logarithm of a negative number, or a number too large)</source>
        <translation>이 연산은 양들의 추정값에서 값이 없습니다(0으로 나눔, 음수의 제곱근이나 로그, 또는 너무 큰 수)</translation>
    </message>
    <message>
        <source>it has several series: leave out the name of the one that is measured now</source>
        <translation>계열이 여러 개 있습니다. 지금 측정한 계열의 이름은 비워 두십시오</translation>
    </message>
    <message>
        <source>the table of observations has no rows for it</source>
        <translation>관측값 표에 그 행이 없습니다</translation>
    </message>
    <message>
        <source>&apos;a&apos; is missing: number of observations of which the value is the mean</source>
        <translation>&apos;a&apos;가 없습니다: 값이 몇 개의 관측값의 평균인지 나타내는 수</translation>
    </message>
    <message>
        <source>there is no equation: write one, y = x_1 + x_2</source>
        <translation>식이 없습니다. 하나를 쓰십시오, y = x_1 + x_2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is defined by an equation: it cannot be a quantity too</source>
        <translation>&apos;%1&apos;은(는) 방정식으로 정의됩니다. 동시에 양일 수 없습니다</translation>
    </message>
    <message>
        <source>no equation uses &apos;%1&apos;</source>
        <translation>&apos;%1&apos;을(를) 사용하는 방정식이 없습니다</translation>
    </message>
    <message>
        <source>no equation defines &apos;%1&apos;%2</source>
        <translation>&apos;%1&apos;을(를) 정의하는 방정식이 없습니다%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is listed twice</source>
        <translation>&apos;%1&apos;이(가) 목록에 두 번 있습니다</translation>
    </message>
    <message>
        <source>group &apos;%1&apos;: %2</source>
        <translation>그룹 &apos;%1&apos;: %2</translation>
    </message>
    <message>
        <source>an analysis of variance needs at least two groups</source>
        <translation>분산분석에는 그룹이 두 개 이상 필요합니다</translation>
    </message>
    <message>
        <source>no group has more than one observation: nothing tells the scatter within the groups from that between them</source>
        <translation>관측값이 두 개 이상인 그룹이 없습니다. 그룹 안의 산포와 그룹 사이의 산포를 구별할 수 없습니다</translation>
    </message>
    <message>
        <source>the curve does not reach %1</source>
        <translation>곡선이 %1에 도달하지 않습니다</translation>
    </message>
    <message>
        <source>, outside of its points</source>
        <translation>, 점들의 범위 밖</translation>
    </message>
    <message>
        <source>the curve reaches %1 at x = %2%3: say in &apos;near&apos; which of them is meant</source>
        <translation>곡선이 x = %2에서 %1에 도달합니다%3. 그중 어느 것인지 &apos;near&apos;에 지정하십시오</translation>
    </message>
    <message>
        <source>no curve of this degree was found: the iteration for the uncertainties of x does not settle on these points</source>
        <translation>이 차수의 곡선을 찾지 못했습니다. x의 불확도에 대한 반복 계산이 이 점들에서 수렴하지 않습니다</translation>
    </message>
    <message>
        <source>the points do not determine a curve of this degree</source>
        <translation>점들로 이 차수의 곡선을 정할 수 없습니다</translation>
    </message>
    <message>
        <source>the x of y = %1 lies outside of the points of the calibration</source>
        <translation>y = %1의 x가 교정점의 범위 밖에 있습니다</translation>
    </message>
    <message>
        <source>the standard uncertainty of y is missing in row %1</source>
        <translation>%1행에 y의 표준불확도가 없습니다</translation>
    </message>
    <message>
        <source>the standard uncertainty of y must be greater than zero in row %1</source>
        <translation>%1행의 y의 표준불확도는 0보다 커야 합니다</translation>
    </message>
    <message>
        <source>readings have the scatter of the residuals, which stated uncertainties do not use: give u_y in row %1</source>
        <translation>읽음값에는 잔차의 산포가 있지만 제시된 불확도는 그것을 사용하지 않습니다. %1행에 u_y를 주십시오</translation>
    </message>
    <message>
        <source>a curve through the origin needs differences: give y in K</source>
        <translation>원점을 지나는 곡선에는 차가 필요합니다. y를 K로 주십시오</translation>
    </message>
    <message>
        <source>a polynomial of this degree needs points at %1 different places or more beside the origin</source>
        <translation>이 차수의 다항식에는 원점 외에 서로 다른 %1곳 이상의 점이 필요합니다</translation>
    </message>
    <message>
        <source>a polynomial of this degree needs points at %1 different places or more</source>
        <translation>이 차수의 다항식에는 서로 다른 %1곳 이상의 점이 필요합니다</translation>
    </message>
    <message>
        <source>residuals say nothing about the uncertainty unless there are more points than coefficients: add points, or state u_y</source>
        <translation>점이 계수보다 많지 않으면 잔차로 불확도를 알 수 없습니다. 점을 추가하거나 u_y를 주십시오</translation>
    </message>
    <message>
        <source>line %1, %2</source>
        <translation>%1행, %2</translation>
    </message>
    <message>
        <source>The mesh is not drawn: %1: %2</source>
        <translation>메시를 그리지 않습니다: %1: %2</translation>
    </message>
    <message>
        <source>The mesh is not drawn: %1</source>
        <translation>메시를 그리지 않습니다: %1</translation>
    </message>
    <message>
        <source>it has more than %1 triangles: thin it out</source>
        <translation>삼각형이 %1개를 넘습니다. 줄이십시오</translation>
    </message>
    <message>
        <source>triangle %1 has a coordinate that is not a finite number</source>
        <translation>삼각형 %1에 유한하지 않은 좌표가 있습니다</translation>
    </message>
    <message>
        <source>triangle %1: %2 is no number</source>
        <translation>삼각형 %1: %2은(는) 수가 아닙니다</translation>
    </message>
    <message>
        <source>it ends in triangle %1: it has been cut off</source>
        <translation>삼각형 %1에서 끝납니다. 잘린 파일입니다</translation>
    </message>
    <message>
        <source>triangle %1: %2 stands where %3 should</source>
        <translation>삼각형 %1: %3이(가) 있어야 할 곳에 %2이(가) 있습니다</translation>
    </message>
    <message>
        <source>it is no STL file: it neither begins with &quot;solid&quot; nor has a header of 84 bytes</source>
        <translation>STL 파일이 아닙니다. &quot;solid&quot;로 시작하지도 않고 84바이트의 머리글도 없습니다</translation>
    </message>
    <message>
        <source>it is no STL file: its header states %1 triangles, and there is more behind them</source>
        <translation>STL 파일이 아닙니다. 머리글은 삼각형 %1개라고 하지만 그 뒤에 더 있습니다</translation>
    </message>
    <message>
        <source>its header states %1 triangles; it ends in triangle %2</source>
        <translation>머리글은 삼각형 %1개라고 하지만 삼각형 %2에서 끝납니다</translation>
    </message>
    <message>
        <source>it has no triangles</source>
        <translation>삼각형이 없습니다</translation>
    </message>
    <message>
        <source>target uncertainty</source>
        <translation>목표 불확도</translation>
    </message>
    <message>
        <source>mean of the prior</source>
        <translation>사전분포의 평균</translation>
    </message>
    <message>
        <source>standard deviation of the prior</source>
        <translation>사전분포의 표준편차</translation>
    </message>
    <message>
        <source>the %1 must be greater than zero</source>
        <translation>%1은(는) 0보다 커야 합니다</translation>
    </message>
    <message>
        <source>the %1 must be above the lower limit</source>
        <translation>%1은(는) 하한보다 커야 합니다</translation>
    </message>
    <message>
        <source>the guard factor of %1 must lie between -10 and 10; 1 is a guard band of U, 0 simple acceptance</source>
        <translation>%1의 보호 계수는 -10과 10 사이여야 합니다. 1은 U의 보호대역, 0은 단순 수용입니다</translation>
    </message>
    <message>
        <source>the prior of %1 needs both a mean and a standard deviation</source>
        <translation>%1의 사전분포에는 평균과 표준편차가 모두 필요합니다</translation>
    </message>
    <message>
        <source>the prior of %1 is of use only with a tolerance: give a limit</source>
        <translation>%1의 사전분포는 허용오차가 있을 때만 쓸모가 있습니다. 한계를 제시하십시오</translation>
    </message>
    <message>
        <source> in %1</source>
        <translation> %1에서</translation>
    </message>
    <message>
        <source>the model has no output quantity %1%2%3</source>
        <translation>모델에 출력량 %1이(가) 없습니다%2%3</translation>
    </message>
    <message>
        <source>an axis needs at least two values</source>
        <translation>축에는 값이 둘 이상 필요합니다</translation>
    </message>
    <message>
        <source>&apos;from&apos; and &apos;to&apos; must be two different numbers</source>
        <translation>&apos;from&apos;과 &apos;to&apos;는 서로 다른 두 수여야 합니다</translation>
    </message>
    <message>
        <source>with logarithmic spacing both ends must be greater than zero</source>
        <translation>로그 간격이면 양 끝이 0보다 커야 합니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; takes whole numbers: there are fewer than %2 between the ends</source>
        <translation>&apos;%1&apos;은(는) 정수를 받습니다. 양 끝 사이에 %2개보다 적습니다</translation>
    </message>
    <message>
        <source>a study has one to three axes; this one has %1</source>
        <translation>스터디의 축은 하나에서 셋입니다. 현재 %1개</translation>
    </message>
    <message>
        <source>%1 is varied by two axes</source>
        <translation>%1이(가) 두 축으로 변합니다</translation>
    </message>
    <message>
        <source>Monte Carlo needs at least two trials</source>
        <translation>몬테카를로에는 시행이 2회 이상 필요합니다</translation>
    </message>
    <message>
        <source>the grid has %1 points; a study may have %2</source>
        <translation>격자의 점이 %1개입니다. 스터디는 %2개까지 가능합니다</translation>
    </message>
    <message>
        <source>the uncertainty of an input quantity can be varied by a factor only</source>
        <translation>입력량의 불확도는 배율로만 바꿀 수 있습니다</translation>
    </message>
    <message>
        <source>a factor has no unit</source>
        <translation>배율에는 단위가 없습니다</translation>
    </message>
    <message>
        <source>a factor of an uncertainty must not be negative</source>
        <translation>불확도의 배율은 음수일 수 없습니다</translation>
    </message>
    <message>
        <source>a temperature in %1 cannot be multiplied; add to it, or give its values</source>
        <translation>%1(으)로 된 온도는 곱할 수 없습니다. 더하거나 값을 제시하십시오</translation>
    </message>
    <message>
        <source>a number that varies</source>
        <translation>변하는 수치</translation>
    </message>
    <message>
        <source>an axis of a study</source>
        <translation>스터디의 축</translation>
    </message>
    <message>
        <source>an output of a study</source>
        <translation>스터디의 출력량</translation>
    </message>
    <message>
        <source>a study</source>
        <translation>스터디</translation>
    </message>
    <message>
        <source>only numbers of the set-up of an asset can be varied</source>
        <translation>에셋의 측정 구성의 수만 바꿀 수 있습니다</translation>
    </message>
    <message>
        <source>a target is written as &quot;/setup/KEY&quot;, &quot;/setup/KEY/rows/0/COLUMN&quot;, &quot;/inputs/SYMBOL/estimate&quot; or &quot;/inputs/SYMBOL/components&quot;</source>
        <translation>대상은 &quot;/setup/KEY&quot;, &quot;/setup/KEY/rows/0/COLUMN&quot;, &quot;/inputs/SYMBOL/estimate&quot; 또는 &quot;/inputs/SYMBOL/components&quot;로 씁니다</translation>
    </message>
    <message>
        <source>the set-up has no schema</source>
        <translation>측정 구성에 스키마가 없습니다</translation>
    </message>
    <message>
        <source>the set-up has no field %1%2</source>
        <translation>측정 구성에 필드 %1이(가) 없습니다%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not used with the present choices of the set-up</source>
        <translation>측정 구성의 현재 선택에서는 &apos;%1&apos;을(를) 쓰지 않습니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number</source>
        <translation>&apos;%1&apos;은(는) 수가 아닙니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not given, so there is nothing to change</source>
        <translation>&apos;%1&apos;이(가) 없어 바꿀 것이 없습니다</translation>
    </message>
    <message>
        <source>a coordinate of the pose &apos;%1&apos; is written as &quot;/setup/%2/position/0&quot; or &quot;/setup/%3/angles/2&quot;</source>
        <translation>포즈 &apos;%1&apos;의 좌표는 &quot;/setup/%2/position/0&quot; 또는 &quot;/setup/%3/angles/2&quot;로 씁니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not given</source>
        <translation>&apos;%1&apos;이(가) 없습니다</translation>
    </message>
    <message>
        <source>a number of the table &apos;%1&apos; is written as &quot;/setup/%2/rows/0/COLUMN&quot; or &quot;/setup/%3/columns/COLUMN&quot;</source>
        <translation>표 &apos;%1&apos;의 수는 &quot;/setup/%2/rows/0/COLUMN&quot; 또는 &quot;/setup/%3/columns/COLUMN&quot;으로 씁니다</translation>
    </message>
    <message>
        <source>the table &apos;%1&apos; has no column %2</source>
        <translation>표 &apos;%1&apos;에 열 %2이(가) 없습니다</translation>
    </message>
    <message>
        <source>the column %1 does not hold numbers</source>
        <translation>열 %1에 수가 없습니다</translation>
    </message>
    <message>
        <source>the table &apos;%1&apos; is empty</source>
        <translation>표 &apos;%1&apos;이(가) 비어 있습니다</translation>
    </message>
    <message>
        <source>the table &apos;%1&apos; has %2 rows, counted from 0</source>
        <translation>표 &apos;%1&apos;의 행은 %2개이며 0부터 셉니다</translation>
    </message>
    <message>
        <source>the cell is empty, so there is nothing to change</source>
        <translation>셀이 비어 있어 바꿀 것이 없습니다</translation>
    </message>
    <message>
        <source>the column is empty, so there is nothing to change</source>
        <translation>열이 비어 있어 바꿀 것이 없습니다</translation>
    </message>
    <message>
        <source>of an input quantity, &quot;estimate&quot; or &quot;components&quot; can be varied</source>
        <translation>입력량에서는 &quot;estimate&quot; 또는 &quot;components&quot;를 바꿀 수 있습니다</translation>
    </message>
    <message>
        <source>the model has no input quantity %1%2</source>
        <translation>모델에 입력량 %1이(가) 없습니다%2</translation>
    </message>
    <message>
        <source>there is no component %1%2</source>
        <translation>성분 %1이(가) 없습니다%2</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; has no unit; it is not a measured number</source>
        <translation>&apos;%2&apos;의 열 &apos;%1&apos;에는 단위가 없습니다. 측정한 수가 아닙니다</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; is missing</source>
        <translation>&apos;%2&apos;의 열 &apos;%1&apos;이(가) 없습니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no column &apos;%2&apos;%3; its columns are %4</source>
        <translation>&apos;%1&apos;에 열 &apos;%2&apos;이(가) 없습니다%3. 있는 열: %4</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; is given twice</source>
        <translation>&apos;%2&apos;의 열 &apos;%1&apos;이(가) 두 번 있습니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be one of %2; it is &apos;%3&apos;%4</source>
        <translation>&apos;%1&apos;은(는) %2 중 하나여야 합니다. 현재 &apos;%3&apos;%4</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a whole number that is not negative; it is %2</source>
        <translation>&apos;%1&apos;은(는) 음이 아닌 정수여야 합니다. 현재 %2</translation>
    </message>
    <message>
        <source>a unit is needed here, such as &quot;mm&quot;, not %1</source>
        <translation>여기에는 %1이(가) 아니라 &quot;mm&quot; 같은 단위가 필요합니다</translation>
    </message>
    <message>
        <source>a unit with a dimension is needed here, not &apos;%1&apos;</source>
        <translation>여기에는 &apos;%1&apos;이(가) 아니라 차원이 있는 단위가 필요합니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is of the same dimension as a unit before it; give one of each</source>
        <translation>&apos;%1&apos;의 차원이 앞의 단위와 같습니다. 하나씩 제시하십시오</translation>
    </message>
    <message>
        <source>what the project states for results</source>
        <translation>프로젝트가 결과에 대해 정한 것</translation>
    </message>
    <message>
        <source>the coverage factor must be greater than zero; without one, k follows from the degrees of freedom or the coverage interval</source>
        <translation>포함인자는 0보다 커야 합니다. 없으면 k는 자유도나 포함구간에서 나옵니다</translation>
    </message>
    <message>
        <source>a report has no chapter %1%2</source>
        <translation>보고서에 장 %1이(가) 없습니다%2</translation>
    </message>
    <message>
        <source>there is no analysis %1%2</source>
        <translation>분석 %1이(가) 없습니다%2</translation>
    </message>
    <message>
        <source>the contents of the report</source>
        <translation>보고서의 내용</translation>
    </message>
    <message>
        <source>a requirement</source>
        <translation>요구사항</translation>
    </message>
    <message>
        <source>a unit of length is needed here, not %1</source>
        <translation>여기에는 %1이(가) 아니라 길이 단위가 필요합니다</translation>
    </message>
    <message>
        <source>the size of a view must be greater than zero</source>
        <translation>보기의 크기는 0보다 커야 합니다</translation>
    </message>
    <message>
        <source>&apos;direction&apos; and &apos;up&apos; must be two different directions, not of length zero</source>
        <translation>&apos;direction&apos;과 &apos;up&apos;은 길이가 0이 아닌 서로 다른 두 방향이어야 합니다</translation>
    </message>
    <message>
        <source>a view</source>
        <translation>보기</translation>
    </message>
    <message>
        <source>%1 is the name of a standard view</source>
        <translation>%1은(는) 표준 보기의 이름입니다</translation>
    </message>
    <message>
        <source>the name %1 is used twice</source>
        <translation>이름 %1이(가) 두 번 쓰였습니다</translation>
    </message>
    <message>
        <source>there is no single value here, but a list or a group</source>
        <translation>여기에는 값 하나가 아니라 목록이나 그룹이 있습니다</translation>
    </message>
    <message>
        <source>there is nothing called &apos;%1&apos; to set</source>
        <translation>설정할 &apos;%1&apos;이(가) 없습니다</translation>
    </message>
    <message>
        <source>there is nothing called &apos;%1&apos; to set%2</source>
        <translation>설정할 &apos;%1&apos;이(가) 없습니다%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not of the form /PLACE/IN/THE/PROJECT=VALUE</source>
        <translation>&apos;%1&apos;은(는) /PLACE/IN/THE/PROJECT=VALUE 형식이 아닙니다</translation>
    </message>
    <message>
        <source>%1 is a table: it needs &quot;columns&quot; and &quot;rows&quot;, or the name of a &quot;csv&quot; file</source>
        <translation>%1은(는) 표입니다. &quot;columns&quot;와 &quot;rows&quot; 또는 &quot;csv&quot; 파일의 이름이 필요합니다</translation>
    </message>
    <message>
        <source>the columns of %1 must be texts in quotes</source>
        <translation>%1의 열은 따옴표 안의 텍스트여야 합니다</translation>
    </message>
    <message>
        <source>row %1 of %2 must be a list in brackets, not %3</source>
        <translation>%2의 행 %1은(는) %3이(가) 아니라 대괄호 안의 목록이어야 합니다</translation>
    </message>
    <message>
        <source>a text in quotes</source>
        <translation>따옴표 안의 텍스트</translation>
    </message>
    <message>
        <source>the columns of the CSV file of %1 must be an object in braces: a header of the file and the column it stands for</source>
        <translation>%1의 CSV 파일의 열은 중괄호 안의 객체여야 합니다. 파일의 머리글과 그것이 나타내는 열</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must stand for a column of %2 (a text), or for none (an empty text)</source>
        <translation>&apos;%1&apos;은(는) %2의 열(텍스트)을 나타내거나 아무것도(빈 텍스트) 나타내지 않아야 합니다</translation>
    </message>
    <message>
        <source>the CSV file &apos;%1&apos; of %2 must be named relative to the project&apos;s folder and lie in it</source>
        <translation>%2의 CSV 파일 &apos;%1&apos;은(는) 프로젝트 폴더를 기준으로 이름을 쓰고 그 안에 있어야 합니다</translation>
    </message>
    <message>
        <source>the CSV file of %1 does not exist: looked for &apos;%2&apos;</source>
        <translation>%1의 CSV 파일이 없습니다. 찾은 것: &apos;%2&apos;</translation>
    </message>
    <message>
        <source>CSV file of %1: %2</source>
        <translation>%1의 CSV 파일: %2</translation>
    </message>
    <message>
        <source>%1 must be a whole number, not %2</source>
        <translation>%1은(는) %2이(가) 아니라 정수여야 합니다</translation>
    </message>
    <message>
        <source>%1 is %2; its unit is missing: write {&quot;value&quot;: %3, &quot;unit&quot;: &quot;%4&quot;}</source>
        <translation>%1은(는) %2입니다. 단위가 없습니다. {&quot;value&quot;: %3, &quot;unit&quot;: &quot;%4&quot;}(으)로 쓰십시오</translation>
    </message>
    <message>
        <source>%1 must be a text in quotes, not %2</source>
        <translation>%1은(는) %2이(가) 아니라 따옴표 안의 텍스트여야 합니다</translation>
    </message>
    <message>
        <source>the lines of %1 must be texts in quotes, each one line</source>
        <translation>%1의 줄은 각각 한 줄인 따옴표 안의 텍스트여야 합니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; of %2 must be a list of three numbers</source>
        <translation>%2의 &apos;%1&apos;은(는) 수 세 개의 목록이어야 합니다</translation>
    </message>
    <message>
        <source>this set-up</source>
        <translation>이 측정 구성</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be three numbers: x, y, z</source>
        <translation>&apos;%1&apos;은(는) 세 수여야 합니다: x, y, z</translation>
    </message>
    <message>
        <source>a text is needed here, not %1</source>
        <translation>여기에는 %1이(가) 아니라 텍스트가 필요합니다</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>파일이 비어 있습니다</translation>
    </message>
    <message>
        <source>the project ends before this: nothing may follow its closing &apos;}&apos;</source>
        <translation>프로젝트가 이 앞에서 끝납니다. 마지막 &apos;}&apos; 뒤에는 아무것도 올 수 없습니다</translation>
    </message>
    <message>
        <source>%1 (column %2)</source>
        <translation>%1 (열 %2)</translation>
    </message>
    <message>
        <source>the file is truncated: it ends %1; its rest is missing</source>
        <translation>파일이 잘렸습니다. %1 끝나며 나머지가 없습니다</translation>
    </message>
    <message>
        <source>lists and objects are nested too deeply</source>
        <translation>목록과 객체가 너무 깊이 중첩되어 있습니다</translation>
    </message>
    <message>
        <source>where a value is expected</source>
        <translation>값이 있어야 할 곳에서</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is too large a number</source>
        <translation>&apos;%1&apos;은(는) 너무 큰 수입니다</translation>
    </message>
    <message>
        <source>in the middle of a value</source>
        <translation>값 중간에서</translation>
    </message>
    <message>
        <source>a value is expected here (a number, a text in quotes, a list or an object), not &apos;%1&apos;</source>
        <translation>여기에는 &apos;%1&apos;이(가) 아니라 값(수, 따옴표 안의 텍스트, 목록, 객체)이 와야 합니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number that a project file can hold: give a finite number, or null where infinity is meant</source>
        <translation>&apos;%1&apos;은(는) 프로젝트 파일이 담을 수 있는 수가 아닙니다. 유한한 수를 쓰고 무한대이면 null을 쓰십시오</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a value: texts stand in double quotes, numbers are written like -12.5e-3</source>
        <translation>&apos;%1&apos;은(는) 값이 아닙니다. 텍스트는 큰따옴표 안에, 수는 -12.5e-3처럼 씁니다</translation>
    </message>
    <message>
        <source>the text that begins here is not closed by a double quote on its line</source>
        <translation>여기서 시작하는 텍스트가 그 줄에서 큰따옴표로 닫히지 않았습니다</translation>
    </message>
    <message>
        <source>in the middle of a text</source>
        <translation>텍스트 중간에서</translation>
    </message>
    <message>
        <source>inside %1</source>
        <translation>%1 안쪽</translation>
    </message>
    <message>
        <source>&apos;,&apos; or &apos;%1&apos; is expected here, inside %2, not &apos;%3&apos;</source>
        <translation>%2 안에서 여기에는 &apos;%3&apos;이(가) 아니라 &apos;,&apos; 또는 &apos;%1&apos;이(가) 와야 합니다</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>객체</translation>
    </message>
    <message>
        <source>a key in double quotes is expected here</source>
        <translation>여기에는 큰따옴표 안의 키가 와야 합니다</translation>
    </message>
    <message>
        <source>the key before this is not a valid text</source>
        <translation>이 앞의 키가 올바른 텍스트가 아닙니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is given twice in the same object</source>
        <translation>&apos;%1&apos;이(가) 같은 객체에 두 번 있습니다</translation>
    </message>
    <message>
        <source>after the key &apos;%1&apos;</source>
        <translation>키 &apos;%1&apos; 다음에</translation>
    </message>
    <message>
        <source>&apos;:&apos; is expected after the key &apos;%1&apos;</source>
        <translation>키 &apos;%1&apos; 다음에 &apos;:&apos;이 와야 합니다</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>목록</translation>
    </message>
    <message>
        <source>there is no kind of asset &apos;%1&apos;%2; known are %3</source>
        <translation>에셋 종류 &apos;%1&apos;이(가) 없습니다%2. 알려진 것: %3</translation>
    </message>
    <message>
        <source>there is no measurement model &apos;%1&apos;%2; known are %3</source>
        <translation>측정 모델 &apos;%1&apos;이(가) 없습니다%2. 알려진 것: %3</translation>
    </message>
    <message>
        <source>%1 is taken from another analysis, with all its uncertainty: remove either this or the link</source>
        <translation>%1은(는) 모든 불확도와 함께 다른 분석에서 가져옵니다. 이것이나 연결 중 하나를 없애십시오</translation>
    </message>
    <message>
        <source>the analysis %1 has errors of its own: %2</source>
        <translation>분석 %1에 자체 오류가 있습니다: %2</translation>
    </message>
    <message>
        <source>the analysis %1 has no value at its estimates</source>
        <translation>분석 %1은(는) 추정값에서 값이 없습니다</translation>
    </message>
    <message>
        <source>the component %1 is not stated alike (held, or edited) by all analyses of the chain: they are taken as independent</source>
        <translation>성분 %1이(가) 사슬의 모든 분석에서 같게 제시되지 않습니다(고정 또는 편집). 독립으로 봅니다</translation>
    </message>
    <message>
        <source>%1 is linked twice</source>
        <translation>%1이(가) 두 번 연결되었습니다</translation>
    </message>
    <message>
        <source>%1 is %2; %3 of %4 is %5</source>
        <translation>%1: %2. %4의 %3: %5</translation>
    </message>
    <message>
        <source>the analysis %1 would be made of itself: %2%3</source>
        <translation>분석 %1이(가) 자기 자신으로 이루어지게 됩니다: %2%3</translation>
    </message>
    <message>
        <source>the analysis %1 has no output %2%3</source>
        <translation>분석 %1에 출력 %2이(가) 없습니다%3</translation>
    </message>
    <message>
        <source>&apos;schemaVersion&apos; is missing</source>
        <translation>&apos;schemaVersion&apos;이 없습니다</translation>
    </message>
    <message>
        <source>&apos;schemaVersion&apos; must be a whole number</source>
        <translation>&apos;schemaVersion&apos;은 정수여야 합니다</translation>
    </message>
    <message>
        <source>written by a newer version of Covaria (schema %1, this program reads up to %2); nothing was changed</source>
        <translation>더 새로운 Covaria가 기록했습니다(스키마 %1, 이 프로그램은 %2까지 읽음). 아무것도 바꾸지 않았습니다</translation>
    </message>
    <message>
        <source>the text &apos;%1&apos;</source>
        <translation>텍스트 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the number %1</source>
        <translation>수 %1</translation>
    </message>
    <message>
        <source>%1 must be an object in braces, not %2</source>
        <translation>%1은(는) %2이(가) 아니라 중괄호 안의 객체여야 합니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is missing in %2</source>
        <translation>%2에 &apos;%1&apos;이(가) 없습니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be %2, not %3</source>
        <translation>&apos;%1&apos;은(는) %3이(가) 아니라 %2여야 합니다</translation>
    </message>
    <message>
        <source>a list in brackets</source>
        <translation>대괄호 안의 목록</translation>
    </message>
    <message>
        <source>there is no &apos;%1&apos; in %2%3</source>
        <translation>%2에 &apos;%1&apos;은(는) 없습니다%3</translation>
    </message>
    <message>
        <source>a number with its unit</source>
        <translation>단위가 있는 수</translation>
    </message>
    <message>
        <source>a whole number from 0 to 18446744073709551615, in quotes</source>
        <translation>따옴표 안의 0부터 18446744073709551615까지의 정수</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be %2; it is %3</source>
        <translation>&apos;%1&apos; 조건: %2. 현재 %3</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>%1 중 하나</translation>
    </message>
    <message>
        <source>a whole number that is not negative</source>
        <translation>음이 아닌 정수</translation>
    </message>
    <message>
        <source>a text here is not valid UTF-8 or has a wrong \ sequence</source>
        <translation>여기의 텍스트가 올바른 UTF-8이 아니거나 잘못된 \ 표기가 있습니다</translation>
    </message>
    <message>
        <source>the project</source>
        <translation>프로젝트</translation>
    </message>
    <message>
        <source>an asset</source>
        <translation>에셋</translation>
    </message>
    <message>
        <source>an analysis</source>
        <translation>분석</translation>
    </message>
    <message>
        <source>this is not a project of Covaria: it does not begin with &quot;format&quot;: &quot;covaria&quot;</source>
        <translation>Covaria의 프로젝트가 아닙니다. &quot;format&quot;: &quot;covaria&quot;로 시작하지 않습니다</translation>
    </message>
    <message>
        <source>it has %1 MB, and projects of up to %2 MB are read: put its long tables into CSV files beside it</source>
        <translation>%1 MB이며 %2 MB까지의 프로젝트를 읽습니다. 긴 표를 옆의 CSV 파일에 넣으십시오</translation>
    </message>
    <message>
        <source>the project was not saved: it holds a number that is not finite, or fields that belong to no known kind of asset or model</source>
        <translation>프로젝트를 저장하지 않았습니다. 유한하지 않은 수, 또는 알려진 에셋 종류나 모델에 속하지 않는 필드가 있습니다</translation>
    </message>
    <message>
        <source>the project was not saved: %1</source>
        <translation>프로젝트를 저장하지 않았습니다: %1</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be two capital letters, such as DE; it is &apos;%2&apos;</source>
        <translation>&apos;%1&apos;은(는) DE와 같은 대문자 두 개여야 합니다. 현재 &apos;%2&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be one of %2; it is &apos;%3&apos;</source>
        <translation>&apos;%1&apos;은(는) %2 중 하나여야 합니다. 현재 &apos;%3&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a date of the form 2026-04-17 or an interval 2026-04-17/2026-04-18; it is &apos;%2&apos;</source>
        <translation>&apos;%1&apos;은(는) 2026-04-17 형식의 날짜 또는 2026-04-17/2026-04-18 형식의 기간이어야 합니다. 현재 &apos;%2&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a date of the form 2026-04-17; it is &apos;%2&apos;</source>
        <translation>&apos;%1&apos;은(는) 2026-04-17 형식의 날짜여야 합니다. 현재 &apos;%2&apos;</translation>
    </message>
    <message>
        <source>the item cannot have been calibrated before it was received</source>
        <translation>품목은 접수되기 전에 교정될 수 없습니다</translation>
    </message>
    <message>
        <source>the certificate cannot have been issued before the calibration</source>
        <translation>교정 전에 성적서를 발급할 수 없습니다</translation>
    </message>
    <message>
        <source> (or %1)</source>
        <translation> (또는 %1)</translation>
    </message>
    <message>
        <source>&apos;%1&apos;%2 must be stated (ISO/IEC 17025 %3)</source>
        <translation>&apos;%1&apos;%2을(를) 제시해야 합니다 (ISO/IEC 17025 %3)</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be stated (Digital Calibration Certificate)</source>
        <translation>&apos;%1&apos;을(를) 제시해야 합니다 (디지털 교정 성적서)</translation>
    </message>
    <message>
        <source>the certificate</source>
        <translation>성적서</translation>
    </message>
    <message>
        <source>%1 has more than 2 MB, too much for a logo</source>
        <translation>%1은(는) 2 MB를 넘어 로고로는 너무 큽니다</translation>
    </message>
    <message>
        <source>%1 is neither a PNG nor a JPEG picture</source>
        <translation>%1은(는) PNG도 JPEG도 아닙니다</translation>
    </message>
    <message>
        <source>The certificate has no logo: %1</source>
        <translation>성적서에 로고가 없습니다: %1</translation>
    </message>
    <message>
        <source>more than %1 columns are not read</source>
        <translation>열 %1개를 넘으면 읽지 않습니다</translation>
    </message>
    <message>
        <source>the quote that begins here is not closed</source>
        <translation>여기서 시작하는 따옴표를 닫지 않았습니다</translation>
    </message>
    <message>
        <source>text follows the closing quote of a cell; write a quote inside a quoted cell twice</source>
        <translation>셀의 닫는 따옴표 뒤에 텍스트가 있습니다. 따옴표로 묶은 셀 안의 따옴표는 두 번 쓰십시오</translation>
    </message>
    <message>
        <source>the text is encoded as UTF-16; save it as UTF-8</source>
        <translation>텍스트가 UTF-16으로 되어 있습니다. UTF-8로 저장하십시오</translation>
    </message>
    <message>
        <source>the text is not encoded as UTF-8; save it as UTF-8</source>
        <translation>텍스트가 UTF-8이 아닙니다. UTF-8로 저장하십시오</translation>
    </message>
    <message>
        <source>this row has %1 cells; there are %2 columns</source>
        <translation>이 행에 셀이 %1개입니다. 열은 %2개입니다</translation>
    </message>
    <message>
        <source>column &apos;%1&apos;: &apos;%2&apos; is not a number</source>
        <translation>열 &apos;%1&apos;: &apos;%2&apos;은(는) 수가 아닙니다</translation>
    </message>
    <message>
        <source>column &apos;%1&apos;: &apos;%2&apos; is neither true nor false</source>
        <translation>열 &apos;%1&apos;: &apos;%2&apos;은(는) true도 false도 아닙니다</translation>
    </message>
    <message>
        <source>the file has no column &apos;%1&apos;%2; its columns are %3</source>
        <translation>파일에 열 &apos;%1&apos;이(가) 없습니다%2. 있는 열: %3</translation>
    </message>
    <message>
        <source>there is no row with the names of the columns</source>
        <translation>열 이름이 있는 행이 없습니다</translation>
    </message>
    <message>
        <source>it has %1 lines, and there is memory for about %2 of these rows: leave rows out, or take means of several</source>
        <translation>행이 %1개이며 메모리는 그중 약 %2행에 충분합니다. 행을 줄이거나 여러 행의 평균을 쓰십시오</translation>
    </message>
    <message>
        <source>a table to choose from is written as &quot;/setup/KEY/rows&quot;; it is %1</source>
        <translation>고를 표는 &quot;/setup/KEY/rows&quot;로 씁니다. 현재 %1</translation>
    </message>
    <message>
        <source>a design needs &apos;variables&apos;, a table to &apos;choose&apos; from, or &apos;reductions&apos;</source>
        <translation>설계에는 &apos;variables&apos;, &apos;choose&apos;할 표, 또는 &apos;reductions&apos;가 필요합니다</translation>
    </message>
    <message>
        <source>the cheapest reductions are a design of their own, without variables and rows</source>
        <translation>가장 저렴한 감소는 변수와 행이 없는 별도의 설계입니다</translation>
    </message>
    <message>
        <source>a design has at most %1 reductions</source>
        <translation>설계의 감소는 최대 %1개입니다</translation>
    </message>
    <message>
        <source>a design has at most %1 variables</source>
        <translation>설계의 변수는 최대 %1개입니다</translation>
    </message>
    <message>
        <source>the cost is that of rows with &apos;prices&apos;: it needs a table to choose from, and no variables</source>
        <translation>비용은 &apos;prices&apos;가 있는 행의 비용입니다. 고를 표가 필요하고 변수는 없어야 합니다</translation>
    </message>
    <message>
        <source>a tolerance must not be negative</source>
        <translation>허용오차는 음수일 수 없습니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; takes whole numbers: a study shows what each of them gives</source>
        <translation>&apos;%1&apos;은(는) 정수를 받습니다. 스터디가 각각의 결과를 보여 줍니다</translation>
    </message>
    <message>
        <source>%1 is chosen by two variables</source>
        <translation>%1을(를) 두 변수가 고릅니다</translation>
    </message>
    <message>
        <source>the smallest factor is between 0 and 1</source>
        <translation>가장 작은 배율은 0과 1 사이입니다</translation>
    </message>
    <message>
        <source>a price must not be negative</source>
        <translation>가격은 음수일 수 없습니다</translation>
    </message>
    <message>
        <source>%1 is reduced twice</source>
        <translation>%1을(를) 두 번 줄입니다</translation>
    </message>
    <message>
        <source>of %1 rows, %2 to %3 can be kept; it is %4</source>
        <translation>행 %1개 중 %2~%3개를 남길 수 있습니다. 현재 %4</translation>
    </message>
    <message>
        <source>there are %1 rows, counted from 0</source>
        <translation>행은 %1개이며 0부터 셉니다</translation>
    </message>
    <message>
        <source>row %1 is fixed twice</source>
        <translation>행 %1이(가) 두 번 고정되었습니다</translation>
    </message>
    <message>
        <source>more rows are fixed than kept</source>
        <translation>남기는 것보다 많은 행이 고정되었습니다</translation>
    </message>
    <message>
        <source>there is one price for all rows, or one for each of the %1; there are %2</source>
        <translation>가격은 모든 행에 하나이거나 행 %1개에 하나씩입니다. 현재 %2개</translation>
    </message>
    <message>
        <source>a box</source>
        <translation>상자</translation>
    </message>
    <message>
        <source>every coordinate of &apos;to&apos; must be greater than that of &apos;from&apos;</source>
        <translation>&apos;to&apos;의 모든 좌표는 &apos;from&apos;의 좌표보다 커야 합니다</translation>
    </message>
    <message>
        <source>the least distance</source>
        <translation>최소 거리</translation>
    </message>
    <message>
        <source>the least distance must be greater than zero</source>
        <translation>최소 거리는 0보다 커야 합니다</translation>
    </message>
    <message>
        <source>there are 1 to %1 starts</source>
        <translation>시작은 1개에서 %1개입니다</translation>
    </message>
    <message>
        <source>at least one evaluation is needed</source>
        <translation>평가가 한 번 이상 필요합니다</translation>
    </message>
    <message>
        <source>the set-up has no table %1%2</source>
        <translation>측정 구성에 표 %1이(가) 없습니다%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be %2; it is &apos;%3&apos;</source>
        <translation>&apos;%1&apos; 조건: %2. 현재 &apos;%3&apos;</translation>
    </message>
    <message>
        <source>a variable of a design</source>
        <translation>설계의 변수</translation>
    </message>
    <message>
        <source>a number that is reduced</source>
        <translation>줄이는 수치</translation>
    </message>
    <message>
        <source>a reduction of a design</source>
        <translation>설계의 감소</translation>
    </message>
    <message>
        <source>the choice of a design</source>
        <translation>설계의 선택</translation>
    </message>
    <message>
        <source>a box of a design</source>
        <translation>설계의 상자</translation>
    </message>
    <message>
        <source>a design</source>
        <translation>설계</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a list of numbers</source>
        <translation>&apos;%1&apos;은(는) 수의 목록이어야 합니다</translation>
    </message>
    <message>
        <source>the parameters of &apos;%1&apos;</source>
        <translation>&apos;%1&apos;의 모수</translation>
    </message>
    <message>
        <source>a distribution</source>
        <translation>분포</translation>
    </message>
    <message>
        <source>there is no distribution &apos;%1&apos;%2; known are %3</source>
        <translation>분포 &apos;%1&apos;이(가) 없습니다%2. 알려진 것: %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is missing in a component</source>
        <translation>성분에 &apos;%1&apos;이(가) 없습니다</translation>
    </message>
    <message>
        <source>a component</source>
        <translation>성분</translation>
    </message>
    <message>
        <source>the edit of an input quantity</source>
        <translation>입력량의 편집</translation>
    </message>
    <message>
        <source>the notes of a quantity</source>
        <translation>양의 비고</translation>
    </message>
    <message>
        <source>an output of an analysis</source>
        <translation>분석의 출력량</translation>
    </message>
    <message>
        <source>a link</source>
        <translation>링크</translation>
    </message>
    <message>
        <source>a correlation</source>
        <translation>상관</translation>
    </message>
    <message>
        <source>component %1</source>
        <translation>성분 %1</translation>
    </message>
    <message>
        <source>%1 is %2; the unit %3 of %4 is the unit of %5</source>
        <translation>%1: %2. %4의 단위 %3은(는) %5의 단위입니다</translation>
    </message>
    <message>
        <source>%1: the degrees of freedom must be greater than zero</source>
        <translation>%1: 자유도는 0보다 커야 합니다</translation>
    </message>
    <message>
        <source>%1 is a component, not an input quantity: it can be held, but not be edited otherwise</source>
        <translation>%1은(는) 입력량이 아니라 성분입니다. 고정할 수는 있지만 달리 편집할 수 없습니다</translation>
    </message>
    <message>
        <source>%1 has no uncertainty to be correlated</source>
        <translation>%1에 상관될 불확도가 없습니다</translation>
    </message>
    <message>
        <source>there is no component or quantity %1%2</source>
        <translation>성분이나 양 %1이(가) 없습니다%2</translation>
    </message>
    <message>
        <source>%1 cannot be correlated with itself</source>
        <translation>%1은(는) 자기 자신과 상관될 수 없습니다</translation>
    </message>
    <message>
        <source>%1 and %2 have the component %3 in common, which correlates them; state the correlation of other components instead</source>
        <translation>%1과(와) %2은(는) 성분 %3을(를) 공유하여 상관됩니다. 대신 다른 성분의 상관을 제시하십시오</translation>
    </message>
    <message>
        <source>%1 is edited twice</source>
        <translation>%1이(가) 두 번 편집되었습니다</translation>
    </message>
    <message>
        <source>the correlation of %1 and %2 is given twice</source>
        <translation>%1과(와) %2의 상관이 두 번 주어졌습니다</translation>
    </message>
    <message>
        <source>a number is needed here; it is %1</source>
        <translation>여기에는 수가 필요합니다. 현재 %1</translation>
    </message>
    <message>
        <source>%1: %2 must lie within %3</source>
        <translation>%1: %2은(는) %3 안에 있어야 합니다</translation>
    </message>
    <message>
        <source>the frame of %1 is missing</source>
        <translation>%1의 좌표계가 없습니다</translation>
    </message>
    <message>
        <source>no calibration of a robot: &apos;kinematics&apos; is missing</source>
        <translation>로봇의 교정이 아닙니다. &apos;kinematics&apos;가 없습니다</translation>
    </message>
    <message>
        <source>calibration %1</source>
        <translation>교정 %1</translation>
    </message>
    <message>
        <source>lengths in m, angles in rad, about fixed axes as in URDF</source>
        <translation>길이는 m, 각은 rad, URDF처럼 고정축 둘레</translation>
    </message>
    <message>
        <source>%1 is called %2 here</source>
        <translation>%1은(는) 여기서 %2(이)라고 합니다</translation>
    </message>
    <message>
        <source>an input without a name</source>
        <translation>이름이 없는 입력</translation>
    </message>
    <message>
        <source>its %1 must be a number</source>
        <translation>%1은(는) 수여야 합니다</translation>
    </message>
    <message>
        <source>there are two inputs of that name</source>
        <translation>그 이름의 입력이 둘입니다</translation>
    </message>
    <message>
        <source>%1 %2 is %3 %4</source>
        <translation>%1 %2: %3 %4</translation>
    </message>
    <message>
        <source>typea_uncert must be a number from 0</source>
        <translation>typea_uncert는 0 이상의 수여야 합니다</translation>
    </message>
    <message>
        <source>typea must be a list of at least two observations</source>
        <translation>typea는 관측값이 둘 이상인 목록이어야 합니다</translation>
    </message>
    <message>
        <source>an observation must be a number; those in groups are not read</source>
        <translation>관측값은 수여야 합니다. 그룹으로 된 것은 읽지 않습니다</translation>
    </message>
    <message>
        <source>more than %1 observations are not read</source>
        <translation>관측값은 %1개까지만 읽습니다</translation>
    </message>
    <message>
        <source>numnewmeas must be a number from 1</source>
        <translation>numnewmeas는 1 이상의 수여야 합니다</translation>
    </message>
    <message>
        <source>its observations are taken as independent: Suncal enlarges the uncertainty of more than 50 that are autocorrelated</source>
        <translation>관측값을 독립으로 봅니다. Suncal은 50개가 넘고 자기상관인 관측값의 불확도를 크게 합니다</translation>
    </message>
    <message>
        <source>%1 %2 is no number</source>
        <translation>%1 %2은(는) 수가 아닙니다</translation>
    </message>
    <message>
        <source>%1 %2 is %3</source>
        <translation>%1 %2: %3</translation>
    </message>
    <message>
        <source>degf must be a number greater than 0, or .inf</source>
        <translation>degf는 0보다 큰 수 또는 .inf여야 합니다</translation>
    </message>
    <message>
        <source>; it has %1</source>
        <translation>; 있는 것: %1</translation>
    </message>
    <message>
        <source>the file has no calculation of mode &apos;uncertainty&apos; or &apos;system&apos;%1</source>
        <translation>파일에 모드가 &apos;uncertainty&apos; 또는 &apos;system&apos;인 계산이 없습니다%1</translation>
    </message>
    <message>
        <source>%1: %2 quantities, %3 results</source>
        <translation>%1: 양 %2개, 결과 %3개</translation>
    </message>
    <message>
        <source>the calculation has no inputs</source>
        <translation>계산에 입력이 없습니다</translation>
    </message>
    <message>
        <source>the calculation has no functions</source>
        <translation>계산에 함수가 없습니다</translation>
    </message>
    <message>
        <source>the system has no quantities</source>
        <translation>시스템에 양이 없습니다</translation>
    </message>
    <message>
        <source>quantities of type %1 are not read; those that are: direct, indirect</source>
        <translation>%1 유형의 양은 읽지 않습니다. 읽는 유형: direct, indirect</translation>
    </message>
    <message>
        <source>the system has no direct quantity</source>
        <translation>시스템에 direct 유형의 양이 없습니다</translation>
    </message>
    <message>
        <source>more than %1 inputs are not read</source>
        <translation>입력은 %1개까지만 읽습니다</translation>
    </message>
    <message>
        <source>more than %1 functions are not read</source>
        <translation>함수는 %1개까지만 읽습니다</translation>
    </message>
    <message>
        <source>a function has the name of an input or of another function</source>
        <translation>함수의 이름이 입력 또는 다른 함수의 이름과 같습니다</translation>
    </message>
    <message>
        <source>%1: in %2 instead of %3</source>
        <translation>%1: %3 대신 %2 단위로</translation>
    </message>
    <message>
        <source>%1: no starting value</source>
        <translation>%1: 시작값 없음</translation>
    </message>
    <message>
        <source>%1: state the unit of what is solved for under &apos;units&apos;</source>
        <translation>%1: 푸는 값의 단위를 &apos;units&apos;에 적으십시오</translation>
    </message>
    <message>
        <source>a correlation needs var1 and var2, two inputs, and cor, a number between -1 and 1</source>
        <translation>상관에는 두 입력 var1과 var2, 그리고 -1과 1 사이의 수 cor가 필요합니다</translation>
    </message>
    <message>
        <source>no unit can be stated for %1%2</source>
        <translation>%1에는 단위를 지정할 수 없습니다%2</translation>
    </message>
    <message>
        <source>the file has no Excel workbook in it</source>
        <translation>파일 안에 Excel 통합 문서가 없습니다</translation>
    </message>
    <message>
        <source>the file has no sheet with cells</source>
        <translation>파일에 셀이 있는 시트가 없습니다</translation>
    </message>
    <message>
        <source>%1: %2 is no place of a cell</source>
        <translation>%1: %2은(는) 셀의 위치가 아닙니다</translation>
    </message>
    <message>
        <source>%1: more than %2 cells are not read</source>
        <translation>%1: 셀은 %2개까지만 읽습니다</translation>
    </message>
    <message>
        <source>its text is missing from the file</source>
        <translation>텍스트가 파일에 없습니다</translation>
    </message>
    <message>
        <source>the file has a password or the old format .xls: save it as .xlsx without a password</source>
        <translation>파일에 암호가 있거나 이전 형식 .xls입니다. 암호 없이 .xlsx로 저장하십시오</translation>
    </message>
    <message>
        <source>XML of more than %1 MB is not read</source>
        <translation>%1 MB를 넘는 XML은 읽지 않습니다</translation>
    </message>
    <message>
        <source>a document type declaration: files that declare entities are not read</source>
        <translation>문서 유형 선언: 엔티티를 선언하는 파일은 읽지 않습니다</translation>
    </message>
    <message>
        <source>an alias (*name): write out what it stands for, aliases are not expanded</source>
        <translation>별칭(*name): 가리키는 것을 풀어서 적으십시오. 별칭은 펼치지 않습니다</translation>
    </message>
    <message>
        <source>more than %1 entries are not read</source>
        <translation>항목은 %1개까지만 읽습니다</translation>
    </message>
    <message>
        <source>more than %1 levels are not read</source>
        <translation>수준은 %1단계까지만 읽습니다</translation>
    </message>
    <message>
        <source>a key must be a word</source>
        <translation>키는 단어여야 합니다</translation>
    </message>
    <message>
        <source>the key %1 stands twice</source>
        <translation>키 %1이(가) 두 번 있습니다</translation>
    </message>
    <message>
        <source>more than 1000 keys are not read</source>
        <translation>키는 1000개까지만 읽습니다</translation>
    </message>
    <message>
        <source>YAML of more than %1 kB is not read</source>
        <translation>%1 kB를 넘는 YAML은 읽지 않습니다</translation>
    </message>
    <message>
        <source>the file has no YAML document</source>
        <translation>파일에 YAML 문서가 없습니다</translation>
    </message>
    <message>
        <source>not readable as YAML: %1</source>
        <translation>YAML로 읽을 수 없음: %1</translation>
    </message>
    <message>
        <source>the file has %1</source>
        <translation>파일의 문제: %1</translation>
    </message>
    <message>
        <source>no readable zip archive in it (%1)</source>
        <translation>읽을 수 있는 zip 아카이브가 없음(%1)</translation>
    </message>
    <message>
        <source>more than %1 parts, which are not read</source>
        <translation>파트가 %1개를 넘어 읽지 않음</translation>
    </message>
    <message>
        <source>no part %1</source>
        <translation>파트 %1 없음</translation>
    </message>
    <message>
        <source>a part %1 that cannot be read</source>
        <translation>파트 %1을(를) 읽을 수 없음</translation>
    </message>
    <message>
        <source>an encrypted part %1: save it without a password</source>
        <translation>파트 %1이(가) 암호화됨: 암호 없이 저장하십시오</translation>
    </message>
    <message>
        <source>a part %1 that cannot be unpacked</source>
        <translation>파트 %1의 압축을 풀 수 없음</translation>
    </message>
    <message>
        <source>a damaged part %1</source>
        <translation>파트 %1이(가) 손상됨</translation>
    </message>
    <message>
        <source>parts that unpack to more than %1 MB (at %2), which are not read</source>
        <translation>압축을 풀면 파트가 %1 MB를 넘어(%2에서) 읽지 않음</translation>
    </message>
    <message>
        <source>no network of GNU Gama: &lt;gama-local&gt; with a &lt;network&gt; is expected</source>
        <translation>GNU Gama의 망이 아닙니다. &lt;network&gt;가 있는 &lt;gama-local&gt;이 와야 합니다</translation>
    </message>
    <message>
        <source>the stated unit of lengths: coordinates of Gama are in metres</source>
        <translation>지정한 길이 단위: Gama의 좌표는 미터 단위입니다</translation>
    </message>
    <message>
        <source>&lt;parameters&gt;</source>
        <translation>&lt;parameters&gt;</translation>
    </message>
    <message>
        <source>%1 &lt;%2&gt; with observations</source>
        <translation>관측이 있는 &lt;%2&gt; %1개</translation>
    </message>
    <message>
        <source>%1 points without x and y</source>
        <translation>x와 y가 없는 점 %1개</translation>
    </message>
    <message>
        <source>%1 points have no z: it is taken as 0</source>
        <translation>점 %1개에 z가 없음: 0으로 봅니다</translation>
    </message>
    <message>
        <source>the network has no points with coordinates x and y</source>
        <translation>망에 좌표 x와 y가 있는 점이 없습니다</translation>
    </message>
    <message>
        <source>%1 points are to be adjusted: their coordinates are approximate ones</source>
        <translation>조정할 점 %1개: 그 좌표는 근사값입니다</translation>
    </message>
    <message>
        <source>: a left-handed frame; x and y are taken as they stand</source>
        <translation>: 왼손 좌표계. x와 y를 그대로 씁니다</translation>
    </message>
    <message>
        <source>coordinates in metres, axes-xy = %1%2</source>
        <translation>미터 단위의 좌표, axes-xy = %1%2</translation>
    </message>
    <message>
        <source>%1 = %2 is no number</source>
        <translation>%1 = %2은(는) 수가 아닙니다</translation>
    </message>
    <message>
        <source>too many points: divide the file</source>
        <translation>점이 너무 많습니다. 파일을 나누십시오</translation>
    </message>
    <message>
        <source>&lt;coordinates&gt;: point %1 has no x and y</source>
        <translation>&lt;coordinates&gt;: 점 %1에 x와 y가 없습니다</translation>
    </message>
    <message>
        <source>a covariance matrix of more than %1 coordinates</source>
        <translation>좌표 %1개를 넘는 공분산 행렬</translation>
    </message>
    <message>
        <source>the file has no adjusted coordinates</source>
        <translation>파일에 조정된 좌표가 없습니다</translation>
    </message>
    <message>
        <source>point %1 has no x and y</source>
        <translation>점 %1에 x와 y가 없습니다</translation>
    </message>
    <message>
        <source>adjusted coordinates in metres</source>
        <translation>미터 단위의 조정된 좌표</translation>
    </message>
    <message>
        <source>uncertainties: the file has no &lt;cov-mat&gt;</source>
        <translation>불확도: 파일에 &lt;cov-mat&gt;이 없습니다</translation>
    </message>
    <message>
        <source>residuals and orientations</source>
        <translation>잔차와 표정</translation>
    </message>
    <message>
        <source>its dim must be at least the %1 adjusted coordinates, its band less than it</source>
        <translation>dim은 조정된 좌표 %1개 이상, band는 그보다 작아야 합니다</translation>
    </message>
    <message>
        <source>element %1, %2 is no number</source>
        <translation>요소 %1, %2은(는) 수가 아닙니다</translation>
    </message>
    <message>
        <source>its dim must be the %1 %2, its band less than that</source>
        <translation>dim은 %2 %1개, band는 그보다 작아야 합니다</translation>
    </message>
    <message>
        <source>element %1, %2: %3 is no number</source>
        <translation>요소 %1, %2: %3은(는) 수가 아닙니다</translation>
    </message>
    <message>
        <source>a covariance matrix of observations that are left out</source>
        <translation>제외된 관측의 공분산 행렬</translation>
    </message>
    <message>
        <source>the standard deviation %1 is no number</source>
        <translation>표준편차 %1은(는) 수가 아닙니다</translation>
    </message>
    <message>
        <source>the standard deviation %1 must not be negative</source>
        <translation>표준편차 %1은(는) 음수일 수 없습니다</translation>
    </message>
    <message>
        <source>, %1 of them without a standard deviation</source>
        <translation>, 그중 %1개에 표준편차 없음</translation>
    </message>
    <message>
        <source>, %1 correlations</source>
        <translation>, 상관 %1개</translation>
    </message>
    <message>
        <source>%1 observations%2%3; each is its own result: write the equations of what you measure with them</source>
        <translation>관측 %1개%2%3. 각각이 그 자체의 결과입니다. 이들로 측정하는 것의 식을 쓰십시오</translation>
    </message>
    <message>
        <source>%1 observations: more than %2</source>
        <translation>관측 %1개: %2개 초과</translation>
    </message>
    <message>
        <source>the stated unit of lengths: words of GSI state theirs</source>
        <translation>지정한 길이 단위: GSI의 워드는 자체 단위를 밝힙니다</translation>
    </message>
    <message>
        <source>words %1 (%2)</source>
        <translation>워드 %1 (%2)</translation>
    </message>
    <message>
        <source>%1 readings of reflectors above their points: the targets are the reflectors</source>
        <translation>점 위의 반사경에 대한 읽음값 %1개: 표적은 반사경입니다</translation>
    </message>
    <message>
        <source>the file has neither coordinates nor readings with a distance</source>
        <translation>파일에 좌표도 거리가 있는 읽음값도 없습니다</translation>
    </message>
    <message>
        <source>the reading of %1: angles and a distance are needed</source>
        <translation>%1의 읽음값: 각도와 거리가 필요합니다</translation>
    </message>
    <message>
        <source>coordinates E, N, H become x, y, z</source>
        <translation>좌표 E, N, H는 x, y, z가 됩니다</translation>
    </message>
    <message>
        <source>%1: more than %2 set-ups; divide the file</source>
        <translation>%1: 설치가 %2개를 넘습니다. 파일을 나누십시오</translation>
    </message>
    <message>
        <source>%1: its coordinates are not in the file: 0, 0, 0</source>
        <translation>%1: 좌표가 파일에 없음: 0, 0, 0</translation>
    </message>
    <message>
        <source>%1: readings of points that have coordinates</source>
        <translation>%1: 좌표가 있는 점의 읽음값</translation>
    </message>
    <message>
        <source>%1: readings do not repeat, or are too far apart for it, and say nothing of their uncertainty: points</source>
        <translation>%1: 읽음값이 반복되지 않거나 너무 떨어져 있어 불확도에 대해 아무것도 말하지 않습니다. 점</translation>
    </message>
    <message>
        <source>no word of GSI: index, information, sign and data are expected</source>
        <translation>GSI의 워드가 아닙니다. 색인, 정보, 부호, 데이터가 있어야 합니다</translation>
    </message>
    <message>
        <source>more than %1 blocks</source>
        <translation>블록 %1개 초과</translation>
    </message>
    <message>
        <source>a block begins with the word 11 or 41</source>
        <translation>블록은 워드 11 또는 41로 시작합니다</translation>
    </message>
    <message>
        <source>the data of a word must be digits</source>
        <translation>워드의 데이터는 숫자여야 합니다</translation>
    </message>
    <message>
        <source>the unit &apos;%1&apos; is none of %2</source>
        <translation>단위 &apos;%1&apos;은(는) %2 중 하나가 아닙니다</translation>
    </message>
    <message>
        <source>the file has no blocks of GSI</source>
        <translation>파일에 GSI의 블록이 없습니다</translation>
    </message>
    <message>
        <source>more than %1 lines are not read</source>
        <translation>행 %1개를 넘으면 읽지 않습니다</translation>
    </message>
    <message>
        <source>the name of a section is not closed by &apos;]&apos;</source>
        <translation>섹션의 이름이 &apos;]&apos;로 닫히지 않았습니다</translation>
    </message>
    <message>
        <source>the section %1 stands twice</source>
        <translation>섹션 %1이(가) 두 번 있습니다</translation>
    </message>
    <message>
        <source>neither a section [...] nor a line name=value of one</source>
        <translation>섹션 [...]도 그 안의 줄 이름=값도 아닙니다</translation>
    </message>
    <message>
        <source>no quantity with a value and an uncertainty</source>
        <translation>값과 불확도가 있는 양이 없습니다</translation>
    </message>
    <message>
        <source>the file has no equation (Model[1]=)</source>
        <translation>파일에 식이 없습니다 (Model[1]=)</translation>
    </message>
    <message>
        <source>log may be the natural or the decimal logarithm: write ln or log10</source>
        <translation>log는 자연로그일 수도 상용로그일 수도 있습니다. ln 또는 log10으로 쓰십시오</translation>
    </message>
    <message>
        <source>no file of GUM Workbench: the section [Components] is missing</source>
        <translation>GUM Workbench의 파일이 아닙니다. 섹션 [Components]가 없습니다</translation>
    </message>
    <message>
        <source>the section [COMP %1] is missing</source>
        <translation>섹션 [COMP %1]이(가) 없습니다</translation>
    </message>
    <message>
        <source>more than %1 quantities are not read</source>
        <translation>양 %1개를 넘으면 읽지 않습니다</translation>
    </message>
    <message>
        <source>%1= is missing</source>
        <translation>%1=이(가) 없습니다</translation>
    </message>
    <message>
        <source>quantities of type %1 are not known; those that are: Result, TypBNormal, TypBRectang, TypAPooled</source>
        <translation>%1 유형의 양을 알 수 없습니다. 아는 것: Result, TypBNormal, TypBRectang, TypAPooled</translation>
    </message>
    <message>
        <source>result %1 as the file states it: %2</source>
        <translation>파일에 적힌 결과 %1: %2</translation>
    </message>
    <message>
        <source>section [%1]</source>
        <translation>섹션 [%1]</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>점 1개</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>점 %1개</translation>
    </message>
    <message>
        <source>1 name occurs again and has got a number: first %1</source>
        <translation>이름 1개가 다시 나와 번호를 붙임: 첫째 %1</translation>
    </message>
    <message>
        <source>%1 names occur again and have got a number: first %2</source>
        <translation>이름 %1개가 다시 나와 번호를 붙임: 첫째 %2</translation>
    </message>
    <message>
        <source>%1 groups in one artefact: their names stand before those of the points</source>
        <translation>표준기 하나에 그룹 %1개: 그룹의 이름이 점의 이름 앞에 옵니다</translation>
    </message>
    <message>
        <source>no uncertainties are stated: u_cal is 0 until you state it</source>
        <translation>불확도가 제시되지 않음: 제시할 때까지 u_cal은 0입니다</translation>
    </message>
    <message>
        <source>u_cal is the largest of the stated standard uncertainties: %1</source>
        <translation>u_cal은 제시된 표준불확도 중 가장 큰 것입니다: %1</translation>
    </message>
    <message>
        <source>u_cal as stated: %1</source>
        <translation>제시된 u_cal: %1</translation>
    </message>
    <message>
        <source>%1 without a stated one</source>
        <translation>제시된 것이 없는 %1</translation>
    </message>
    <message>
        <source>the uncertainty of each point by itself, and correlations: only up to %1 have an analysis of their own</source>
        <translation>각 점 자체의 불확도와 상관: %1까지만 자체 분석이 있습니다</translation>
    </message>
    <message>
        <source> and 1 correlation coefficient</source>
        <translation> 및 상관계수 1개</translation>
    </message>
    <message>
        <source> and %1 correlation coefficients</source>
        <translation> 및 상관계수 %1개</translation>
    </message>
    <message>
        <source>analysis &apos;Points as stated&apos;: every coordinate with its own uncertainty%1</source>
        <translation>분석 &apos;Points as stated&apos;: 모든 좌표가 자체 불확도를 가짐%1</translation>
    </message>
    <message>
        <source>the file has no points</source>
        <translation>파일에 점이 없습니다</translation>
    </message>
    <message>
        <source>the file has no line &apos;Frame,Time (Seconds),...&apos; with data below</source>
        <translation>파일에 아래에 데이터가 있는 줄 &apos;Frame,Time (Seconds),...&apos;이 없습니다</translation>
    </message>
    <message>
        <source>the file must begin with &apos;Format Version,&apos;</source>
        <translation>파일은 &apos;Format Version,&apos;으로 시작해야 합니다</translation>
    </message>
    <message>
        <source>rotations of type %1 are not read: export the take with quaternions</source>
        <translation>%1 유형의 회전은 읽지 않습니다. take를 사원수로 내보내십시오</translation>
    </message>
    <message>
        <source>the file does not state its unit of lengths; state it</source>
        <translation>파일이 길이 단위를 밝히지 않습니다. 지정하십시오</translation>
    </message>
    <message>
        <source>take %1, lengths in %2, coordinate space %3</source>
        <translation>take %1, 길이 %2, 좌표 공간 %3</translation>
    </message>
    <message>
        <source>%1 columns of markers</source>
        <translation>마커의 열 %1개</translation>
    </message>
    <message>
        <source>more than %1 rigid bodies are not read</source>
        <translation>강체 %1개를 넘으면 읽지 않습니다</translation>
    </message>
    <message>
        <source>rigid body %1: columns of its rotation (X, Y, Z, W) or position (X, Y, Z) are missing</source>
        <translation>강체 %1: 회전 (X, Y, Z, W) 또는 위치 (X, Y, Z)의 열이 없습니다</translation>
    </message>
    <message>
        <source>the take has no rigid body</source>
        <translation>take에 강체가 없습니다</translation>
    </message>
    <message>
        <source>%1 is not a number of a pose</source>
        <translation>%1은(는) 포즈의 수가 아닙니다</translation>
    </message>
    <message>
        <source>the quaternion of %1 has not the length 1</source>
        <translation>%1의 사원수의 길이가 1이 아닙니다</translation>
    </message>
    <message>
        <source>the angles about z and x of %1 are not determined: turned by 90 degrees about y. Turn the axes of the body in Motive by 90 degrees</source>
        <translation>%1의 z와 x 둘레의 각이 정해지지 않습니다. y 둘레로 90도 돌아 있습니다. Motive에서 강체의 축을 90도 돌리십시오</translation>
    </message>
    <message>
        <source>%1: %2 frames in which it was not seen</source>
        <translation>%1: 보이지 않은 프레임 %2개</translation>
    </message>
    <message>
        <source>rigid body %1: at least two frames in which it is seen are needed</source>
        <translation>강체 %1: 보이는 프레임이 둘 이상 필요합니다</translation>
    </message>
    <message>
        <source>rigid body %1: mean pose of %2 frames, Type A with covariance; the body must not have moved, and the frames are taken as independent</source>
        <translation>강체 %1: 프레임 %2개의 평균 포즈, 공분산이 있는 A형. 강체가 움직이지 않았어야 하며 프레임을 독립으로 봅니다</translation>
    </message>
    <message>
        <source>unit &quot;%1&quot;: write it without parentheses</source>
        <translation>단위 &quot;%1&quot;: 괄호 없이 쓰십시오</translation>
    </message>
    <message>
        <source>the exponents are too large</source>
        <translation>지수가 너무 큽니다</translation>
    </message>
    <message>
        <source>%1; state the columns: %2</source>
        <translation>%1. 열을 지정하십시오: %2</translation>
    </message>
    <message>
        <source>there is no column %1%2</source>
        <translation>열 %1이(가) 없습니다%2</translation>
    </message>
    <message>
        <source>more than %1 points: divide the file</source>
        <translation>점 %1개 초과: 파일을 나누십시오</translation>
    </message>
    <message>
        <source> is empty</source>
        <translation> 비어 있음</translation>
    </message>
    <message>
        <source> is not a number</source>
        <translation> 수가 아님</translation>
    </message>
    <message>
        <source>: an uncertainty must not be negative</source>
        <translation>: 불확도는 음수일 수 없습니다</translation>
    </message>
    <message>
        <source> is too large</source>
        <translation> 너무 큼</translation>
    </message>
    <message>
        <source>the line has %1 columns instead of %2; put names that contain blanks into quotes</source>
        <translation>행의 열이 %2개가 아니라 %1개입니다. 빈칸이 있는 이름은 따옴표로 묶으십시오</translation>
    </message>
    <message>
        <source>what stands behind column %1</source>
        <translation>열 %1 뒤의 내용</translation>
    </message>
    <message>
        <source>lengths are taken as mm: the file does not say its unit</source>
        <translation>길이를 mm로 봅니다. 파일이 단위를 밝히지 않습니다</translation>
    </message>
    <message>
        <source>column %1%2</source>
        <translation>열 %1%2</translation>
    </message>
    <message>
        <source>%1 lines above the headers</source>
        <translation>머리글 위의 %1줄</translation>
    </message>
    <message>
        <source>%1 lines of comment</source>
        <translation>주석 %1줄</translation>
    </message>
    <message>
        <source>the table has no line of headers; state the columns: %1</source>
        <translation>표에 머리글 줄이 없습니다. 열을 지정하십시오: %1</translation>
    </message>
    <message>
        <source>its columns may mean several things (names that are numbers, offsets, weights, tolerances, notes); state the columns: %1</source>
        <translation>열이 여러 가지를 뜻할 수 있습니다(수인 이름, 오프셋, 가중치, 허용오차, 비고). 열을 지정하십시오: %1</translation>
    </message>
    <message>
        <source>six numbers may be X Y Z Ux Uy Uz, but also X Y Z with weights, a vector or the angles of a frame: name the reader if they are uncertainties, or state the columns: %1</source>
        <translation>수 여섯 개는 X Y Z Ux Uy Uz일 수도, X Y Z와 가중치, 벡터 또는 좌표계의 각도일 수도 있습니다. 불확도이면 읽기 형식을 지정하거나 열을 지정하십시오: %1</translation>
    </message>
    <message>
        <source>read as %1 (%2)</source>
        <translation>%1(으)로 읽음 (%2)</translation>
    </message>
    <message>
        <source>%1: the file states no unit, %2 is taken</source>
        <translation>%1: 파일에 단위가 없어 %2을(를) 사용합니다</translation>
    </message>
    <message>
        <source>Analysis &quot;%1&quot; (%2)</source>
        <translation>분석 &quot;%1&quot; (%2)</translation>
    </message>
    <message>
        <source>not taken over</source>
        <translation>받아들이지 않음</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>%1행: %2</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>그 밖에 %1개</translation>
    </message>
    <message>
        <source>and %1 more rows</source>
        <translation>그 밖에 %1행</translation>
    </message>
    <message>
        <source>no reader recognises the file; name the one to read it with</source>
        <translation>파일을 알아보는 읽기 형식이 없습니다. 읽을 형식을 지정하십시오</translation>
    </message>
    <message>
        <source>several readers recognise the file: %1; name one of them</source>
        <translation>여러 읽기 형식이 파일을 알아봅니다: %1. 그중 하나를 지정하십시오</translation>
    </message>
    <message>
        <source>a column cannot be %1; there are %2</source>
        <translation>열은 %1일 수 없습니다. 현재 %2개</translation>
    </message>
    <message>
        <source>the columns %1 and %2 mean the same; state the columns</source>
        <translation>열 %1과(와) %2이(가) 같은 것을 뜻합니다. 열을 지정하십시오</translation>
    </message>
    <message>
        <source>a budget needs columns for the quantity or its name, for an uncertainty (u, U or limits) and one more; state the columns</source>
        <translation>총괄표에는 양이나 그 이름, 불확도(u, U 또는 한계), 그리고 또 하나의 열이 필요합니다. 열을 지정하십시오</translation>
    </message>
    <message>
        <source>the distribution %1 is not known; there are normal, rectangular, triangular, U-shaped</source>
        <translation>분포 %1을(를) 알 수 없습니다. 있는 것: normal, rectangular, triangular, U-shaped</translation>
    </message>
    <message>
        <source>the divisor must be greater than 0</source>
        <translation>제수는 0보다 커야 합니다</translation>
    </message>
    <message>
        <source>an uncertainty must not be negative</source>
        <translation>불확도는 음수일 수 없습니다</translation>
    </message>
    <message>
        <source>no uncertainty is stated</source>
        <translation>불확도가 제시되지 않았습니다</translation>
    </message>
    <message>
        <source>neither divisor, k nor distribution says what the uncertainty %1 is</source>
        <translation>제수, k, 분포 어느 것도 불확도 %1이(가) 무엇인지 말하지 않습니다</translation>
    </message>
    <message>
        <source>a normal distribution needs a divisor or k for the uncertainty %1</source>
        <translation>정규분포이면 불확도 %1에 제수나 k가 필요합니다</translation>
    </message>
    <message>
        <source>no row has a number in the stated columns</source>
        <translation>지정한 열에 수가 있는 행이 없습니다</translation>
    </message>
    <message>
        <source>there is no sheet %1 with cells; there are %2</source>
        <translation>셀이 있는 시트 %1이(가) 없습니다. 있는 시트: %2</translation>
    </message>
    <message>
        <source>the workbook has several sheets, %1: name the sheet whose columns are stated</source>
        <translation>통합 문서에 시트가 여러 개 있습니다(%1). 열을 지정한 시트의 이름을 지정하십시오</translation>
    </message>
    <message>
        <source>no row of headers of a budget was found; state the columns (quantity, value, unit, U, divisor ...)</source>
        <translation>총괄표의 머리글 행을 찾지 못했습니다. 열을 지정하십시오(양, 값, 단위, U, 나눗수 ...)</translation>
    </message>
    <message>
        <source>several sheets have a budget: %1; name one of them</source>
        <translation>여러 시트에 총괄표가 있습니다(%1). 그중 하나를 지정하십시오</translation>
    </message>
    <message>
        <source>a file that it includes: %1</source>
        <translation>포함하는 파일: %1</translation>
    </message>
    <message>
        <source>the code of a point is expected, a digit</source>
        <translation>점의 코드(숫자 하나)가 필요합니다</translation>
    </message>
    <message>
        <source>a point that is not to be used: %1</source>
        <translation>사용하지 않을 점: %1</translation>
    </message>
    <message>
        <source>code, name, x, y, z, three standard deviations and two deflections of the vertical are expected, there are %1 columns</source>
        <translation>코드, 이름, x, y, z, 표준편차 세 개, 연직선 편차 두 개가 필요한데 열이 %1개 있습니다</translation>
    </message>
    <message>
        <source>none of their coordinates</source>
        <translation>좌표를 하나도 구속하지 않음</translation>
    </message>
    <message>
        <source>%1 only</source>
        <translation>%1만</translation>
    </message>
    <message>
        <source>standard deviations of %1 points of code %2: it constrains %3</source>
        <translation>코드 %2인 점 %1개의 표준편차: 구속하는 좌표: %3</translation>
    </message>
    <message>
        <source>deflections of the vertical of %1 points</source>
        <translation>점 %1개의 연직선 편차</translation>
    </message>
    <message>
        <source>%1 points are not constrained: their coordinates are approximate ones for the adjustment</source>
        <translation>점 %1개는 구속되지 않습니다. 그 좌표는 조정을 위한 근사 좌표입니다</translation>
    </message>
    <message>
        <source>%1 comments</source>
        <translation>주석 %1개</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1은(는) 수가 아닙니다</translation>
    </message>
    <message>
        <source>%1: the constraint of %2, which is switched off</source>
        <translation>%1: 꺼져 있는 %2의 구속조건</translation>
    </message>
    <message>
        <source>coordinates in metres</source>
        <translation>미터 단위의 좌표</translation>
    </message>
    <message>
        <source>the stated unit of lengths: coordinates of Comp3D are in metres</source>
        <translation>지정한 길이의 단위: Comp3D의 좌표는 미터 단위입니다</translation>
    </message>
    <message>
        <source>the code of an observation is expected, a whole number</source>
        <translation>관측값의 코드(정수)가 필요합니다</translation>
    </message>
    <message>
        <source>an observation of code %1</source>
        <translation>코드 %1의 관측값</translation>
    </message>
    <message>
        <source>code, two points, value, one or two standard deviations and two heights are expected, there are %1 columns</source>
        <translation>코드, 점 두 개, 값, 표준편차 하나 또는 두 개, 높이 두 개가 필요한데 열이 %1개 있습니다</translation>
    </message>
    <message>
        <source>%1 %2: it is switched off</source>
        <translation>%1 %2: 꺼져 있음</translation>
    </message>
    <message>
        <source>the file has no observation that is taken</source>
        <translation>파일에 가져올 관측값이 없습니다</translation>
    </message>
    <message>
        <source>%1 observations, lengths in metres; each is its own result: write the equations of what you measure with them</source>
        <translation>관측값 %1개, 길이는 미터 단위. 각 관측값이 그대로 결과가 됩니다. 이 값들로 측정 대상의 방정식을 작성하십시오</translation>
    </message>
    <message>
        <source>the unit of angles must be one of an angle: gon, deg, rad</source>
        <translation>각의 단위는 각도 단위여야 합니다: gon, deg, rad</translation>
    </message>
    <message>
        <source>%1 %2: the part of its standard deviation that depends on the distance</source>
        <translation>%1 %2: 거리에 따라 달라지는 표준편차 부분</translation>
    </message>
    <message>
        <source>%1: it is switched off</source>
        <translation>%1: 꺼져 있음</translation>
    </message>
    <message>
        <source>a variance of its covariance matrix is negative</source>
        <translation>공분산 행렬의 분산 하나가 음수입니다</translation>
    </message>
    <message>
        <source>its covariance matrix is not symmetric</source>
        <translation>공분산 행렬이 대칭이 아닙니다</translation>
    </message>
    <message>
        <source>its matrix is no covariance matrix: a variance of some combination is negative</source>
        <translation>행렬이 공분산 행렬이 아닙니다. 어떤 조합의 분산이 음수입니다</translation>
    </message>
    <message>
        <source>no Digital Calibration Certificate: its root is &lt;%1&gt;</source>
        <translation>디지털 교정성적서(Digital Calibration Certificate)가 아닙니다. 루트 요소가 &lt;%1&gt;입니다</translation>
    </message>
    <message>
        <source>the certificate has no results with numbers</source>
        <translation>성적서에 수치가 있는 결과가 없습니다</translation>
    </message>
    <message>
        <source>schema version %1</source>
        <translation>스키마 버전 %1</translation>
    </message>
    <message>
        <source>what this version of the schema has beyond version 3</source>
        <translation>스키마의 이 버전이 버전 3을 넘어서 담고 있는 것</translation>
    </message>
    <message>
        <source>the stated unit of lengths: a certificate states its units</source>
        <translation>지정한 길이의 단위: 성적서에 단위가 적혀 있습니다</translation>
    </message>
    <message>
        <source>%1: &lt;measurementMetaData&gt;</source>
        <translation>%1: &lt;measurementMetaData&gt;</translation>
    </message>
    <message>
        <source>a quantity: more than %1 values</source>
        <translation>한 양: 값이 %1개를 넘음</translation>
    </message>
    <message>
        <source>%1 as a length standard: more than %2</source>
        <translation>%1, 길이 표준기로서: %2개를 넘음</translation>
    </message>
    <message>
        <source>the signature: it is not verified</source>
        <translation>서명: 검증하지 않음</translation>
    </message>
    <message>
        <source>%1 values, %2 of them with an uncertainty</source>
        <translation>값 %1개, 그중 %2개에 불확도가 있음</translation>
    </message>
    <message>
        <source>%1 values, %2 of them with an uncertainty, with covariances</source>
        <translation>값 %1개, 그중 %2개에 불확도가 있음, 공분산 포함</translation>
    </message>
    <message>
        <source>length standard %1: delete it where the length is no standard</source>
        <translation>길이 표준기 %1: 그 길이가 표준이 아니면 삭제하십시오</translation>
    </message>
    <message>
        <source>a value as &lt;%1&gt;</source>
        <translation>&lt;%1&gt;로 적힌 값</translation>
    </message>
    <message>
        <source>its relative uncertainty</source>
        <translation>상대불확도</translation>
    </message>
    <message>
        <source>the same in other units (%1 is taken)</source>
        <translation>다른 단위로 적힌 같은 값(%1 사용)</translation>
    </message>
    <message>
        <source>its lists have different lengths than the %1 values</source>
        <translation>목록의 길이가 값 %1개와 다릅니다</translation>
    </message>
    <message>
        <source>its covariance matrix: %1</source>
        <translation>공분산 행렬: %1</translation>
    </message>
    <message>
        <source>its covariance matrix has not %1 x %2 elements</source>
        <translation>공분산 행렬의 요소가 %1 x %2개가 아닙니다</translation>
    </message>
    <message>
        <source>p must be between 0 and 1</source>
        <translation>p는 0과 1 사이여야 합니다</translation>
    </message>
    <message>
        <source>k must be greater than 0</source>
        <translation>k는 0보다 커야 합니다</translation>
    </message>
    <message>
        <source>its uncertainty is negative</source>
        <translation>불확도가 음수입니다</translation>
    </message>
    <message>
        <source>it does not begin with \</source>
        <translation>\로 시작하지 않습니다</translation>
    </message>
    <message>
        <source>a brace is not closed</source>
        <translation>중괄호를 닫지 않았습니다</translation>
    </message>
    <message>
        <source>its power &apos;%1&apos; is no small integer</source>
        <translation>거듭제곱 &apos;%1&apos;은(는) 작은 정수가 아닙니다</translation>
    </message>
    <message>
        <source>&apos;\%1&apos; is not known</source>
        <translation>&apos;\%1&apos;은(는) 알 수 없습니다</translation>
    </message>
    <message>
        <source>it ends too early</source>
        <translation>너무 일찍 끝납니다</translation>
    </message>
    <message>
        <source>the unit %1: %2</source>
        <translation>단위 %1: %2</translation>
    </message>
    <message>
        <source>sheet %1, columns: %2</source>
        <translation>시트 %1, 열: %2</translation>
    </message>
    <message>
        <source>%1 is no number</source>
        <translation>%1은(는) 수가 아닙니다</translation>
    </message>
    <message>
        <source>its unit differs from that of the other uncertainty of the row</source>
        <translation>단위가 행의 다른 불확도의 단위와 다릅니다</translation>
    </message>
    <message>
        <source>%1 is no divisor</source>
        <translation>%1은(는) 나눗수가 아닙니다</translation>
    </message>
    <message>
        <source>degrees of freedom must be greater than 0</source>
        <translation>자유도는 0보다 커야 합니다</translation>
    </message>
    <message>
        <source>row %1: %2</source>
        <translation>%1행: %2</translation>
    </message>
    <message>
        <source>the contribution %1: c and u give %2</source>
        <translation>기여 %1: c와 u로 계산하면 %2</translation>
    </message>
    <message>
        <source>the contribution does not follow from c and u in any unit; state the unit behind the coefficient (&apos;-575 nm/K&apos;)</source>
        <translation>기여가 어떤 단위에서도 c와 u에서 나오지 않습니다. 계수 뒤에 단위를 적으십시오(&apos;-575 nm/K&apos;)</translation>
    </message>
    <message>
        <source>its unit makes no coefficient of the result</source>
        <translation>단위가 결과의 감도계수에 맞지 않습니다</translation>
    </message>
    <message>
        <source>its unit may be %1 or %2: state it behind the coefficient</source>
        <translation>단위는 %1 또는 %2일 수 있습니다. 계수 뒤에 적으십시오</translation>
    </message>
    <message>
        <source>what stands below the budget, to row %1</source>
        <translation>총괄표 아래 %1행까지에 있는 것</translation>
    </message>
    <message>
        <source>there is no quantity with an uncertainty below</source>
        <translation>아래에 불확도가 있는 양이 없습니다</translation>
    </message>
    <message>
        <source>row without a quantity</source>
        <translation>양이 없는 행</translation>
    </message>
    <message>
        <source>row %1 without figures</source>
        <translation>수치가 없는 행 %1</translation>
    </message>
    <message>
        <source>the quantity has no name</source>
        <translation>양에 이름이 없습니다</translation>
    </message>
    <message>
        <source>row %1: computed anew</source>
        <translation>행 %1: 다시 계산함</translation>
    </message>
    <message>
        <source>the unit of the result is not stated: give the result a row of its own, put the unit behind the head of the contributions, or state it as that of &apos;result&apos;</source>
        <translation>결과의 단위가 없습니다. 결과에 별도의 행을 주거나, 기여의 머리글 뒤에 단위를 넣거나, &apos;result&apos;의 단위로 지정하십시오</translation>
    </message>
    <message>
        <source>model: %1; the sheet has sensitivity coefficients only, write your equation instead where you have it</source>
        <translation>모델: %1. 시트에는 감도계수만 있습니다. 방정식이 있으면 대신 그것을 적으십시오</translation>
    </message>
    <message>
        <source>%1 quantities</source>
        <translation>양 %1개</translation>
    </message>
    <message>
        <source>sheet %1</source>
        <translation>시트 %1</translation>
    </message>
    <message>
        <source>no input quantity has an uncertainty, so that U is 0 everywhere: state the uncertainties of what the analysis uses</source>
        <translation>불확도가 있는 입력량이 없어 U가 모두 0입니다. 분석이 쓰는 것의 불확도를 제시하십시오</translation>
    </message>
    <message>
        <source>%1; the run is to end at %2 trials and will not be stable then. Choose a larger tolerance or fewer digits</source>
        <translation>%1. 실행은 시행 %2회에서 끝나며 그때 안정되지 않습니다. 허용오차를 크게 하거나 자릿수를 줄이십시오</translation>
    </message>
    <message>
        <source>it cannot be read</source>
        <translation>읽을 수 없습니다</translation>
    </message>
    <message>
        <source>%1 has no analysis &quot;%2&quot;</source>
        <translation>%1에 분석 &quot;%2&quot;이(가) 없습니다</translation>
    </message>
    <message>
        <source>%1 refers to other assets of the project and cannot be kept alone</source>
        <translation>%1은(는) 프로젝트의 다른 에셋을 참조하므로 단독으로 보관할 수 없습니다</translation>
    </message>
    <message>
        <source>%1 has errors; open it and repair it before adding to it</source>
        <translation>%1에 오류가 있습니다. 추가하기 전에 열어서 고치십시오</translation>
    </message>
    <message>
        <source>asset %1: %2</source>
        <translation>에셋 %1: %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; refers to the analysis &apos;%2&apos;</source>
        <translation>&apos;%1&apos;은(는) 분석 &apos;%2&apos;을(를) 참조합니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; refers to the asset &apos;%2&apos;</source>
        <translation>&apos;%1&apos;은(는) 에셋 &apos;%2&apos;을(를) 참조합니다</translation>
    </message>
    <message>
        <source>%1, which does not offer %2</source>
        <translation>%1, %2을(를) 제공하지 않음</translation>
    </message>
    <message>
        <source>it cannot be made</source>
        <translation>만들 수 없습니다</translation>
    </message>
    <message>
        <source>the analysis &apos;%1&apos; has errors of its own: %2</source>
        <translation>분석 &apos;%1&apos;에 자체 오류가 있습니다: %2</translation>
    </message>
    <message>
        <source>%1, which has errors of its own</source>
        <translation>%1, 자체 오류가 있음</translation>
    </message>
    <message>
        <source>%1, which is of the kind &apos;%2&apos; and does not offer %3</source>
        <translation>%1, 종류가 &apos;%2&apos;이며 %3을(를) 제공하지 않음</translation>
    </message>
    <message>
        <source>%1, which refers back to this one: %2%3</source>
        <translation>%1, 이것을 다시 참조함: %2%3</translation>
    </message>
    <message>
        <source>%1: only analyses take something from analyses</source>
        <translation>%1: 분석만이 분석에서 가져올 수 있습니다</translation>
    </message>
    <message>
        <source>%1, which does not exist%2</source>
        <translation>%1, 존재하지 않음%2</translation>
    </message>
    <message>
        <source>the values given lead to a %1</source>
        <translation>제시된 값의 결과: %1</translation>
    </message>
    <message>
        <source>the memory of this machine does not suffice</source>
        <translation>이 컴퓨터의 메모리가 부족합니다</translation>
    </message>
    <message>
        <source>a defect of the program was met (%1): please report it with the project</source>
        <translation>프로그램의 결함이 발생했습니다(%1). 프로젝트와 함께 알려 주십시오</translation>
    </message>
    <message>
        <source>%1: the part is damaged or no part at all: delete it and make it anew</source>
        <translation>%1: 이 부분은 손상되었거나 부분이 아닙니다. 삭제하고 다시 만드십시오</translation>
    </message>
    <message>
        <source>%1: the part was made %2 %3, this is %4: the bits of its results would not be those of one run</source>
        <translation>%1: 이 부분은 %2 %3(으)로 만들었고 여기는 %4입니다. 결과의 비트가 한 번의 실행과 같지 않게 됩니다</translation>
    </message>
    <message>
        <source>%1: the part would have %2 MB, more than %3: divide the run into more parts</source>
        <translation>%1: 이 부분은 %2 MB가 되어 %3을(를) 넘습니다. 실행을 더 많은 부분으로 나누십시오</translation>
    </message>
    <message>
        <source>%1: the part is of &quot;%2&quot;, which is not evaluated here: it is of another project</source>
        <translation>%1: 이 부분은 여기서 평가하지 않는 &quot;%2&quot;에 속합니다. 다른 프로젝트의 것입니다</translation>
    </message>
    <message>
        <source>%1: the part is of &quot;%2&quot; in another project or another state of it (fingerprint %3, here %4): make it anew</source>
        <translation>%1: 이 부분은 다른 프로젝트 또는 그 다른 상태의 &quot;%2&quot;에 속합니다(지문 %3, 여기 %4). 다시 만드십시오</translation>
    </message>
    <message>
        <source>the model cannot be made</source>
        <translation>모델을 만들 수 없습니다</translation>
    </message>
    <message>
        <source>there is no component &apos;%1&apos; here</source>
        <translation>여기에는 성분 &apos;%1&apos;이(가) 없습니다</translation>
    </message>
    <message>
        <source>there is no input quantity &apos;%1&apos; here</source>
        <translation>여기에는 입력량 &apos;%1&apos;이(가) 없습니다</translation>
    </message>
    <message>
        <source>the analysis has no study &apos;%1&apos;</source>
        <translation>이 분석에는 스터디 &apos;%1&apos;이(가) 없습니다</translation>
    </message>
    <message>
        <source>the study was stopped</source>
        <translation>스터디를 중지했습니다</translation>
    </message>
    <message>
        <source>the analysis does not use the asset &apos;%1&apos;: varying it changes nothing</source>
        <translation>이 분석은 에셋 &apos;%1&apos;을(를) 사용하지 않습니다. 변화시켜도 아무것도 달라지지 않습니다</translation>
    </message>
    <message>
        <source>the model shows no instruments: a least distance and boxes to keep out of mean nothing to it</source>
        <translation>이 모델에는 측정기가 없습니다. 최소 거리와 피해야 할 상자는 의미가 없습니다</translation>
    </message>
    <message>
        <source>the model shows no lines of sight, so that no box can hide them</source>
        <translation>이 모델에는 시준선이 없으므로 가릴 수 있는 상자가 없습니다</translation>
    </message>
    <message>
        <source>the analysis has no design &apos;%1&apos;</source>
        <translation>이 분석에는 설계 &apos;%1&apos;이(가) 없습니다</translation>
    </message>
    <message>
        <source>the variances are not a sum over what is reduced: some of it is correlated, or changes more than a component of uncertainty</source>
        <translation>분산이 줄이는 것들의 합이 아닙니다. 일부가 상관되어 있거나 둘 이상의 불확도 성분을 바꿉니다</translation>
    </message>
    <message>
        <source>the analysis has no measurand that a design could look at</source>
        <translation>이 분석에는 설계가 살펴볼 측정량이 없습니다</translation>
    </message>
    <message>
        <source>without target uncertainties U is looked at relative to that of the present design, which has no result (%1): state requirements</source>
        <translation>목표 불확도가 없으면 U를 현재 설계의 U에 대해 보지만 현재 설계에는 결과가 없습니다(%1). 요구사항을 제시하십시오</translation>
    </message>
    <message>
        <source>U of &apos;%1&apos; is zero now: choose the outputs to look at</source>
        <translation>&apos;%1&apos;의 U가 현재 0입니다. 살펴볼 출력량을 선택하십시오</translation>
    </message>
    <message>
        <source>the cheapest reductions need target uncertainties: state requirements</source>
        <translation>가장 저렴한 감소에는 목표 불확도가 필요합니다. 요구사항을 제시하십시오</translation>
    </message>
    <message>
        <source>the cheapest rows need target uncertainties: state requirements</source>
        <translation>가장 저렴한 행에는 목표 불확도가 필요합니다. 요구사항을 제시하십시오</translation>
    </message>
    <message>
        <source>the design was stopped</source>
        <translation>설계를 중지했습니다</translation>
    </message>
    <message>
        <source>the set-up</source>
        <translation>측정 구성</translation>
    </message>
    <message>
        <source>the component &apos;%1&apos; is not of one input quantity alone: change it where it comes from (%2)</source>
        <translation>성분 &apos;%1&apos;은(는) 입력량 하나만의 것이 아닙니다. 출처에서 바꾸십시오 (%2)</translation>
    </message>
    <message>
        <source>Distribution of %1.</source>
        <translation>%1의 분포.</translation>
    </message>
    <message>
        <source>Quantiles of %1, the least normal, against those of a normal distribution.</source>
        <translation>가장 정규적이지 않은 %1의 분위수와 정규분포의 분위수.</translation>
    </message>
    <message>
        <source>Standard uncertainty of %1 against the number of trials.</source>
        <translation>시행 횟수에 따른 %1의 표준불확도.</translation>
    </message>
    <message>
        <source>%1: uncertainty ellipsoids at a coverage probability of %2, magnified as the picture states.</source>
        <translation>%1: 포함확률 %2의 불확도 타원체, 그림에 적힌 배율로 확대.</translation>
    </message>
    <message>
        <source>Correlation coefficients of components</source>
        <translation>성분의 상관계수</translation>
    </message>
    <message>
        <source>Component</source>
        <translation>성분</translation>
    </message>
    <message>
        <source>Notes on input quantities</source>
        <translation>입력량의 비고</translation>
    </message>
    <message>
        <source>Input quantities and the origin of their uncertainties</source>
        <translation>입력량과 그 불확도의 출처</translation>
    </message>
    <message>
        <source>%1 input quantities; many with equal components share a row. The CSV table of inputs lists every one with its estimate.</source>
        <translation>입력량 %1개. 성분이 같은 여러 입력량은 한 행을 함께 씁니다. 입력량의 CSV 표에는 각각이 추정값과 함께 있습니다.</translation>
    </message>
    <message>
        <source>These input quantities are results of other analyses. All are evaluated together as one model, in every trial, so that the budget goes down to the components of the analyses that they come from; a component that reaches the result on several ways is one component.</source>
        <translation>이 입력량들은 다른 분석의 결과입니다. 모든 시행에서 하나의 모델로 함께 평가하므로 총괄표는 출처 분석의 성분까지 내려갑니다. 여러 경로로 결과에 이르는 성분은 하나의 성분입니다.</translation>
    </message>
    <message>
        <source>Linearised: the analysis that the value comes from is replaced by its law of propagation about its estimates. That is exact to first order; its non-linearity is left out of Monte Carlo.</source>
        <translation>선형화: 값의 출처인 분석을 추정값 부근의 전파 법칙으로 대신합니다. 일차에서는 정확하며, 그 비선형성은 몬테카를로에 들어가지 않습니다.</translation>
    </message>
    <message>
        <source>Where the inputs come from</source>
        <translation>입력의 출처</translation>
    </message>
    <message>
        <source>Input quantities taken from other analyses</source>
        <translation>다른 분석에서 가져온 입력량</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>분석</translation>
    </message>
    <message>
        <source>Its result</source>
        <translation>그 결과</translation>
    </message>
    <message>
        <source>%1, linearised</source>
        <translation>%1, 선형화</translation>
    </message>
    <message>
        <source>The trials are Sobol points with a random digital shift in each batch; standard errors are from the scatter of the batches.</source>
        <translation>시행은 묶음마다 무작위 디지털 이동을 준 Sobol 점이며, 표준오차는 묶음 사이의 산포에서 구합니다.</translation>
    </message>
    <message>
        <source>Mean, standard uncertainty, symmetric interval and covariance were found with the linear part of each output as control variate: its distribution is known exactly, and the trials tell how the output differs from it. Shortest intervals, histograms and probabilities of conformance are those of the trials.</source>
        <translation>평균, 표준불확도, 대칭 구간, 공분산은 각 출력량의 선형 부분을 제어변량으로 하여 구했습니다. 그 분포는 정확히 알려져 있고, 시행은 출력량이 그것과 어떻게 다른지 알려 줍니다. 최단 구간, 히스토그램, 적합 확률은 시행의 것입니다.</translation>
    </message>
    <message>
        <source>At the interval ends each trial is worth %1 plain ones or more.</source>
        <translation>구간의 끝에서 시행 하나는 일반 시행 %1회 이상의 가치가 있습니다.</translation>
    </message>
    <message>
        <source>The adaptive procedure reached its largest number of trials: the results have not stabilised to the numerical tolerance.</source>
        <translation>적응 절차가 최대 시행 횟수에 도달했습니다. 결과가 수치 허용오차 안으로 안정되지 않았습니다.</translation>
    </message>
    <message>
        <source>Coverage intervals were read from finely divided cells, not from ordered trials: there were more trials than memory allows to order.</source>
        <translation>포함구간은 정렬한 시행이 아니라 잘게 나눈 칸에서 읽었습니다. 메모리가 정렬할 수 있는 것보다 시행이 많았습니다.</translation>
    </message>
    <message>
        <source>law of propagation</source>
        <translation>전파 법칙</translation>
    </message>
    <message>
        <source>adaptive</source>
        <translation>적응</translation>
    </message>
    <message>
        <source>%1, Sobol points</source>
        <translation>%1, Sobol 점</translation>
    </message>
    <message>
        <source>%1, control variate</source>
        <translation>%1, 제어변량</translation>
    </message>
    <message>
        <source>Runs that gave these results</source>
        <translation>이 결과를 낸 실행</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>모델</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>실패</translation>
    </message>
    <message>
        <source>Fingerprint</source>
        <translation>지문</translation>
    </message>
    <message>
        <source>The same project, seed and version give the same numbers on any number of threads. The fingerprint covers everything that influences the numbers of an analysis.</source>
        <translation>같은 프로젝트, 시드, 버전은 스레드 수와 관계없이 같은 수치를 냅니다. 지문은 분석의 수치에 영향을 주는 모든 것을 포함합니다.</translation>
    </message>
    <message>
        <source>Factors by which the standard uncertainties are to be multiplied so that all measurands of a group lie in the region together with a probability of %1 (JCGM 102 6.5 and 7.7).</source>
        <translation>한 그룹의 모든 측정량이 함께 %1의 확률로 영역 안에 있도록 표준불확도에 곱하는 계수(JCGM 102 6.5, 7.7).</translation>
    </message>
    <message>
        <source>Factors of the coverage regions</source>
        <translation>포함영역의 계수</translation>
    </message>
    <message>
        <source>No ellipsoid is given where the covariance matrix of the group is singular.</source>
        <translation>그룹의 공분산 행렬이 특이한 곳에는 타원체를 제시하지 않습니다.</translation>
    </message>
    <message>
        <source>Target uncertainties</source>
        <translation>목표 불확도</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>판정</translation>
    </message>
    <message>
        <source>With the figure put in, U by the law of propagation is the target; k follows the effective degrees of freedom.</source>
        <translation>이 수치를 넣으면 전파 법칙에 의한 U가 목표입니다. k는 유효자유도를 따릅니다.</translation>
    </message>
    <message>
        <source>With the figure put in, U by Monte Carlo is the target; found with %1 trials of the same draws.</source>
        <translation>이 수치를 넣으면 몬테카를로에 의한 U가 목표입니다. 같은 추출의 시행 %1회로 구했습니다.</translation>
    </message>
    <message>
        <source>No component suffices alone: all standard uncertainties multiplied by %1 do.</source>
        <translation>한 성분만으로는 충분하지 않습니다. 모든 표준불확도에 %1을(를) 곱하면 됩니다.</translation>
    </message>
    <message>
        <source>What one component alone must be reduced to for U(%1) to meet its target</source>
        <translation>U(%1)이(가) 목표를 만족하도록 한 성분만을 줄여야 하는 값</translation>
    </message>
    <message>
        <source>needed</source>
        <translation>필요</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>비고</translation>
    </message>
    <message>
        <source>not enough by itself, even if it vanished</source>
        <translation>없어져도 그것만으로는 충분하지 않음</translation>
    </message>
    <message>
        <source>%1: specific consumer&apos;s risk %2 of this decision.</source>
        <translation>%1: 이 판정의 특정 소비자 위험 %2.</translation>
    </message>
    <message>
        <source>%1: specific producer&apos;s risk %2 of this decision.</source>
        <translation>%1: 이 판정의 특정 생산자 위험 %2.</translation>
    </message>
    <message>
        <source>%1: specific consumer&apos;s risk %2 of this decision; global risks of the rule for its prior: consumer&apos;s %3, producer&apos;s %4.</source>
        <translation>%1: 이 판정의 특정 소비자 위험 %2. 사전분포에 대한 규칙의 전역 위험: 소비자 %3, 생산자 %4.</translation>
    </message>
    <message>
        <source>%1: specific producer&apos;s risk %2 of this decision; global risks of the rule for its prior: consumer&apos;s %3, producer&apos;s %4.</source>
        <translation>%1: 이 판정의 특정 생산자 위험 %2. 사전분포에 대한 규칙의 전역 위험: 소비자 %3, 생산자 %4.</translation>
    </message>
    <message>
        <source>Conformity with tolerances</source>
        <translation>허용오차에 대한 적합성</translation>
    </message>
    <message>
        <source>The requirements are not judged: %1.</source>
        <translation>요구사항을 판정하지 않습니다: %1.</translation>
    </message>
    <message>
        <source>U of</source>
        <translation>U, 대상</translation>
    </message>
    <message>
        <source>Coverage probability %1.</source>
        <translation>포함확률 %1.</translation>
    </message>
    <message>
        <source>Values from the law of propagation of uncertainty (JCGM 100).</source>
        <translation>불확도 전파 법칙(JCGM 100)에 의한 값.</translation>
    </message>
    <message>
        <source>Values from the propagation of distributions (JCGM 101) with %1 trials; the interval is probabilistically symmetric, the shortest one beside it. The effective degrees of freedom are those of the law of propagation.</source>
        <translation>시행 %1회의 분포 전파(JCGM 101)에 의한 값. 구간은 확률적으로 대칭이며 그 옆은 최단 구간입니다. 유효자유도는 전파 법칙의 것입니다.</translation>
    </message>
    <message>
        <source>Components with finite degrees of freedom are drawn from normal distributions, as was chosen: U and k leave these degrees of freedom out, unlike k of the law of propagation (JCGM 100 G.6.4).</source>
        <translation>선택한 대로 유한한 자유도를 가진 성분은 정규분포에서 추출됩니다. 전파 법칙의 k(JCGM 100 G.6.4)와 달리 U와 k에는 이 자유도가 반영되지 않습니다.</translation>
    </message>
    <message>
        <source>This result does not represent the measurand: %1 trials, more than 1 %, have no value.</source>
        <translation>이 결과는 측정량을 대표하지 않습니다. 시행 %1회(1 % 초과)에 값이 없습니다.</translation>
    </message>
    <message>
        <source>Law of propagation with second-order terms</source>
        <translation>이차항을 포함한 전파 법칙</translation>
    </message>
    <message>
        <source>JCGM 100 5.1.2, NOTE, for independent components with symmetric distributions. The shift, half the sum of the second derivatives times the variances, is what the mean of the measurand differs by from the value at the estimates; neither is part of the results above.</source>
        <translation>JCGM 100 5.1.2 비고, 분포가 대칭인 독립 성분에 대한 것. 이동량은 이차 미분과 분산의 곱의 합의 절반으로, 측정량의 평균이 추정값에서의 값과 다른 정도입니다. 둘 다 위의 결과에 포함되지 않습니다.</translation>
    </message>
    <message>
        <source>Measurands</source>
        <translation>측정량</translation>
    </message>
    <message>
        <source>Intermediate quantities</source>
        <translation>중간량</translation>
    </message>
    <message>
        <source>Read from %1.</source>
        <translation>%1에서 읽음.</translation>
    </message>
    <message>
        <source>The first %1 of %2 rows; the project file has them all.</source>
        <translation>%2행 중 처음 %1행. 프로젝트 파일에 모두 있습니다.</translation>
    </message>
    <message>
        <source>Sobol indices of %1 in %</source>
        <translation>%1의 Sobol 지수(%)</translation>
    </message>
    <message>
        <source>first order of the law of propagation</source>
        <translation>전파 법칙의 일차</translation>
    </message>
    <message>
        <source>standard error of S</source>
        <translation>S의 표준오차</translation>
    </message>
    <message>
        <source>S total</source>
        <translation>전체 S</translation>
    </message>
    <message>
        <source>standard error of S total</source>
        <translation>전체 S의 표준오차</translation>
    </message>
    <message>
        <source>%1 components with smaller indices are left out.</source>
        <translation>지수가 더 작은 성분 %1개는 생략했습니다.</translation>
    </message>
    <message>
        <source>Sobol indices</source>
        <translation>Sobol 지수</translation>
    </message>
    <message>
        <source>S is the share of the variance that a component causes by itself, S total the share with all its interactions with others: where both agree and the shares sum to 100 %, the measurement model is additive. Components that are correlated have indices together. By Monte Carlo with %1 pairs of trials.</source>
        <translation>S는 성분이 스스로 일으키는 분산의 비율, 전체 S는 다른 성분과의 모든 상호작용을 포함한 비율입니다. 둘이 일치하고 비율의 합이 100 %이면 측정 모델은 가산적입니다. 상관된 성분은 지수를 함께 가집니다. 몬테카를로, 시행 %1쌍.</translation>
    </message>
    <message>
        <source>%1 from %2 to %3 (%4 values, logarithmic)</source>
        <translation>%1, %2부터 %3까지 (값 %4개, 로그)</translation>
    </message>
    <message>
        <source>%1 from %2 to %3 (%4 values)</source>
        <translation>%1, %2부터 %3까지 (값 %4개)</translation>
    </message>
    <message>
        <source>Evaluated at %1 grid points, with %2 trials at each.</source>
        <translation>격자점 %1개에서 각각 시행 %2회로 평가.</translation>
    </message>
    <message>
        <source>Evaluated at %1 grid points, by the law of propagation of uncertainty.</source>
        <translation>격자점 %1개에서 불확도 전파 법칙으로 평가.</translation>
    </message>
    <message>
        <source>Varied: %1.</source>
        <translation>변화시킨 것: %1.</translation>
    </message>
    <message>
        <source>The CSV table of the study has all output quantities.</source>
        <translation>스터디의 CSV 표에 모든 출력량이 있습니다.</translation>
    </message>
    <message>
        <source>%1: best and worst grid points</source>
        <translation>%1: 가장 좋은 격자점과 가장 나쁜 격자점</translation>
    </message>
    <message>
        <source>least</source>
        <translation>최소</translation>
    </message>
    <message>
        <source>greatest</source>
        <translation>최대</translation>
    </message>
    <message>
        <source>What is given for %1 of the grid points does not represent the measurand: more than 1 % of their trials have no value (see the CSV table).</source>
        <translation>격자점 %1개에 제시된 것은 측정량을 대표하지 않습니다. 시행의 1 % 넘게 값이 없습니다(CSV 표 참조).</translation>
    </message>
    <message>
        <source>%1 grid points have no values:</source>
        <translation>격자점 %1개에 값이 없습니다:</translation>
    </message>
    <message>
        <source>others: see the CSV table of the study</source>
        <translation>기타: 스터디의 CSV 표 참조</translation>
    </message>
    <message>
        <source>law of propagation of uncertainty</source>
        <translation>불확도 전파 법칙</translation>
    </message>
    <message>
        <source>adaptive Monte Carlo, %1 trials</source>
        <translation>적응 몬테카를로, 시행 %1회</translation>
    </message>
    <message>
        <source>Monte Carlo, %1 trials</source>
        <translation>몬테카를로, 시행 %1회</translation>
    </message>
    <message>
        <source>%1; %2; coverage probability %3</source>
        <translation>%1; %2; 포함확률 %3</translation>
    </message>
    <message>
        <source>k, intervals and the law of propagation are in the results of the analysis.</source>
        <translation>k, 구간, 전파 법칙은 분석의 결과에 있습니다.</translation>
    </message>
    <message>
        <source>Not evaluated: %1: %2.</source>
        <translation>평가하지 않음: %1: %2.</translation>
    </message>
    <message>
        <source>Study &quot;%1&quot; not evaluated: %2: %3.</source>
        <translation>스터디 &quot;%1&quot; 평가하지 않음: %2: %3.</translation>
    </message>
    <message>
        <source>Expanded uncertainty U: %1</source>
        <translation>확장불확도 U: %1</translation>
    </message>
    <message>
        <source>Results: %1</source>
        <translation>결과: %1</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>번호</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>작성자</translation>
    </message>
    <message>
        <source>Evaluated with</source>
        <translation>평가 프로그램</translation>
    </message>
    <message>
        <source>Not in this report</source>
        <translation>이 보고서에 없음</translation>
    </message>
    <message>
        <source>Project fingerprint</source>
        <translation>프로젝트 지문</translation>
    </message>
    <message>
        <source>Evaluated with an earlier analysis: %1.</source>
        <translation>앞선 분석과 함께 평가: %1.</translation>
    </message>
    <message>
        <source>Budget of %1, %2</source>
        <translation>%1의 총괄표, %2</translation>
    </message>
    <message>
        <source>%1 further components</source>
        <translation>나머지 성분 %1개</translation>
    </message>
    <message>
        <source>combined (law of propagation)</source>
        <translation>합성(전파 법칙)</translation>
    </message>
    <message>
        <source>%1 = %2, u_c = %3, effective degrees of freedom %4, k = %5, p = %6 (law of propagation).</source>
        <translation>%1 = %2, u_c = %3, 유효자유도 %4, k = %5, p = %6 (전파 법칙).</translation>
    </message>
    <message>
        <source>Shares of the variance in % by %1, %2</source>
        <translation>%1별 분산 비율(%), %2</translation>
    </message>
    <message>
        <source>together</source>
        <translation>합계</translation>
    </message>
    <message>
        <source>other</source>
        <translation>기타</translation>
    </message>
    <message>
        <source>Components by falling share of the variance; cᵢ in the unit of the measurand per unit of the component.</source>
        <translation>분산 비율이 큰 순서의 성분. cᵢ의 단위는 성분의 단위당 측정량의 단위.</translation>
    </message>
    <message>
        <source>Contributions to the variance of %1.</source>
        <translation>%1의 분산에 대한 기여.</translation>
    </message>
    <message>
        <source>Estimates and standard uncertainties by both methods</source>
        <translation>두 방법에 의한 추정값과 표준불확도</translation>
    </message>
    <message>
        <source>Where a distribution is too skewed, heavy-tailed or flat for k u, state its coverage interval.</source>
        <translation>분포가 k u에 비해 너무 비대칭이거나 꼬리가 두껍거나 평평하면 그 포함구간을 제시하십시오.</translation>
    </message>
    <message>
        <source>The expanded uncertainty U beside what remains of it when everything that a contributor brings in is kept at its estimate (an ideal one), and what that contributor gives alone, with the same coverage factor.</source>
        <translation>확장불확도 U와, 한 기여요인이 가져오는 모든 것을 추정값에 고정했을 때(이상적인 기여요인) 남는 것, 그리고 그 기여요인만의 것. 포함인자는 같습니다.</translation>
    </message>
    <message>
        <source>By Monte Carlo with %1 trials.</source>
        <translation>몬테카를로, 시행 %1회.</translation>
    </message>
    <message>
        <source>By the law of propagation.</source>
        <translation>전파 법칙.</translation>
    </message>
    <message>
        <source>Without %1, %2 trials had no value.</source>
        <translation>%1이(가) 없을 때 시행 %2회에 값이 없었습니다.</translation>
    </message>
    <message>
        <source>U without each contributor, and of it alone</source>
        <translation>각 기여요인이 없을 때의 U와 그것만의 U</translation>
    </message>
    <message>
        <source>without %1</source>
        <translation>%1 제외</translation>
    </message>
    <message>
        <source>%1 alone</source>
        <translation>%1만</translation>
    </message>
    <message>
        <source>Of two contributors, what remains without one is what the other gives alone.</source>
        <translation>기여요인이 둘이면 하나가 없을 때 남는 것은 다른 하나만의 것입니다.</translation>
    </message>
    <message>
        <source>Results by contributor</source>
        <translation>기여요인별 결과</translation>
    </message>
    <message>
        <source>Correlation coefficients, %1</source>
        <translation>상관계수, %1</translation>
    </message>
    <message>
        <source>Between groups, which share input quantities, the largest coefficient is %1.</source>
        <translation>입력량을 공유하는 그룹 사이에서 가장 큰 계수는 %1입니다.</translation>
    </message>
    <message>
        <source>Between groups, which share input quantities, the largest coefficient is %1, of %2 with %3.</source>
        <translation>입력량을 공유하는 그룹 사이에서 가장 큰 계수는 %2와(과) %3의 %1입니다.</translation>
    </message>
    <message>
        <source>The CSV table of correlations has all of them.</source>
        <translation>상관의 CSV 표에 모두 있습니다.</translation>
    </message>
    <message>
        <source>Looked for: the smallest %1.</source>
        <translation>탐색: 가장 작은 %1.</translation>
    </message>
    <message>
        <source>Looked for: the cheapest reductions of uncertainty with which all targets are met.</source>
        <translation>탐색: 모든 목표를 만족하는 가장 저렴한 불확도 감소.</translation>
    </message>
    <message>
        <source>Looked for: the cheapest rows with which all targets are met.</source>
        <translation>탐색: 모든 목표를 만족하는 가장 저렴한 행.</translation>
    </message>
    <message>
        <source>Cost: %1.</source>
        <translation>비용: %1.</translation>
    </message>
    <message>
        <source>Found: %1, before %2.</source>
        <translation>찾음: %1, 이전 %2.</translation>
    </message>
    <message>
        <source>Found: %1.</source>
        <translation>찾음: %1.</translation>
    </message>
    <message>
        <source>Nothing that was tried has a result.</source>
        <translation>시도한 것 중 결과가 있는 것이 없습니다.</translation>
    </message>
    <message>
        <source>%1 candidates were evaluated by the law of propagation of uncertainty, all that there are.</source>
        <translation>불확도 전파 법칙으로 후보 %1개를 모두 평가했습니다.</translation>
    </message>
    <message>
        <source>%1 candidates were evaluated by the law of propagation of uncertainty.</source>
        <translation>불확도 전파 법칙으로 후보 %1개를 평가했습니다.</translation>
    </message>
    <message>
        <source>Verified by Monte Carlo with %1 trials.</source>
        <translation>시행 %1회의 몬테카를로로 확인.</translation>
    </message>
    <message>
        <source>Not every target is met: what is given is the best that was found.</source>
        <translation>모든 목표가 만족되지는 않습니다. 찾은 것 중 가장 좋은 것을 제시합니다.</translation>
    </message>
    <message>
        <source>%1: the way of the search to the best place, coloured by the objective.</source>
        <translation>%1: 가장 좋은 위치까지의 탐색 경로, 목적함수에 따라 색을 입힘.</translation>
    </message>
    <message>
        <source>%1: the candidates, coloured by what they gain; the larger ones are chosen.</source>
        <translation>%1: 이득에 따라 색을 입힌 후보. 큰 것이 선택된 것입니다.</translation>
    </message>
    <message>
        <source>combined</source>
        <translation>합성</translation>
    </message>
    <message>
        <source>%1, constant</source>
        <translation>%1, 상수</translation>
    </message>
    <message>
        <source>%1 components, added arithmetically</source>
        <translation>성분 %1개, 산술 합</translation>
    </message>
    <message>
        <source>%1 components, in quadrature</source>
        <translation>성분 %1개, 제곱합의 제곱근</translation>
    </message>
    <message>
        <source>Table %1. %2</source>
        <translation>표 %1. %2</translation>
    </message>
    <message>
        <source>Figure %1. %2</source>
        <translation>그림 %1. %2</translation>
    </message>
    <message>
        <source>Uncertainty report</source>
        <translation>불확도 보고서</translation>
    </message>
    <message>
        <source>Report of an uncertainty evaluation</source>
        <translation>불확도 평가 보고서</translation>
    </message>
    <message>
        <source>Annex</source>
        <translation>부록</translation>
    </message>
    <message>
        <source>In the annex: %1.</source>
        <translation>부록: %1.</translation>
    </message>
    <message>
        <source>In the annex, on request: %1.</source>
        <translation>부록(요청 시): %1.</translation>
    </message>
    <message>
        <source>The first %1 of %2 rows; the annex has all of them.</source>
        <translation>%2행 중 처음 %1행. 부록에 모두 있습니다.</translation>
    </message>
    <message>
        <source>The first %1 of %2 rows; the CSV tables, and the annex on request, have all of them.</source>
        <translation>%2행 중 처음 %1행. CSV 표와 요청 시 부록에 모두 있습니다.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables; the annex has the rest.</source>
        <translation>표 %2개 중 %1개를 표시. 나머지는 부록에 있습니다.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables; the CSV tables, and the annex on request, have the rest.</source>
        <translation>표 %2개 중 %1개를 표시. 나머지는 CSV 표와 요청 시 부록에 있습니다.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 charts; the annex has the rest.</source>
        <translation>그래프 %2개 중 %1개를 표시. 나머지는 부록에 있습니다.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 charts; the CSV tables, and the annex on request, have the rest.</source>
        <translation>그래프 %2개 중 %1개를 표시. 나머지는 CSV 표와 요청 시 부록에 있습니다.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables and %3 of %4 charts; the annex has the rest.</source>
        <translation>표 %2개 중 %1개, 그래프 %4개 중 %3개를 표시. 나머지는 부록에 있습니다.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables and %3 of %4 charts; the CSV tables, and the annex on request, have the rest.</source>
        <translation>표 %2개 중 %1개, 그래프 %4개 중 %3개를 표시. 나머지는 CSV 표와 요청 시 부록에 있습니다.</translation>
    </message>
    <message>
        <source>%1 (constant)</source>
        <translation>%1 (상수)</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>이전</translation>
    </message>
    <message>
        <source>After</source>
        <translation>이후</translation>
    </message>
    <message>
        <source>U is stated by different rules: before, %1 After, %2</source>
        <translation>U를 서로 다른 규칙으로 제시합니다. 이전, %1 이후, %2</translation>
    </message>
    <message>
        <source>%1 of %2 measurands are in both results; the budgets of %3 of them differ.</source>
        <translation>측정량 %2개 중 %1개가 두 결과에 모두 있습니다. 그중 %3개의 총괄표가 다릅니다.</translation>
    </message>
    <message>
        <source>Shown are the %1 whose standard uncertainty changes most, relative to what it was.</source>
        <translation>표준불확도가 이전에 비해 가장 많이 변하는 %1개를 표시합니다.</translation>
    </message>
    <message>
        <source>Distribution of %1 before and after.</source>
        <translation>%1의 이전과 이후 분포.</translation>
    </message>
    <message>
        <source>Comparison of uncertainty evaluations</source>
        <translation>불확도 평가의 비교</translation>
    </message>
    <message>
        <source>Only before: %1.</source>
        <translation>이전에만: %1.</translation>
    </message>
    <message>
        <source>Only after: %1.</source>
        <translation>이후에만: %1.</translation>
    </message>
    <message>
        <source>this report</source>
        <translation>이 보고서</translation>
    </message>
    <message>
        <source>there are no results for the certificate to state</source>
        <translation>성적서에 기재할 결과가 없습니다</translation>
    </message>
    <message>
        <source>the standard uncertainty of %1 is not finite; a Digital Calibration Certificate has no place for that</source>
        <translation>%1의 표준불확도가 유한하지 않습니다. 디지털 교정성적서(Digital Calibration Certificate)에는 그것을 적을 곳이 없습니다</translation>
    </message>
    <message>
        <source>there is no robot to write: no analysis uses or finds one</source>
        <translation>쓸 로봇이 없습니다. 로봇을 사용하거나 구하는 분석이 없습니다</translation>
    </message>
    <message>
        <source>the file is of one robot, and there are %1: choose an analysis that uses or finds the one to write (--analysis)</source>
        <translation>파일은 로봇 하나에 대한 것인데 %1개가 있습니다. 쓸 로봇을 사용하거나 구하는 분석을 선택하십시오(--analysis)</translation>
    </message>
    <message>
        <source>there are no points to write: no analysis has a result with coordinates x, y, z of a point</source>
        <translation>쓸 점이 없습니다. 점의 좌표 x, y, z를 결과로 갖는 분석이 없습니다</translation>
    </message>
    <message>
        <source>robot %1: the file is of six joints that turn (shoulder to wrist_3); write it as URDF</source>
        <translation>로봇 %1: 파일은 회전 관절 여섯 개(shoulder~wrist_3)에 대한 것입니다. URDF로 쓰십시오</translation>
    </message>
    <message>
        <source>there are no results to write</source>
        <translation>쓸 결과가 없습니다</translation>
    </message>
    <message>
        <source>the workbook cannot be made in the folder for temporary files</source>
        <translation>임시 파일 폴더에 통합 문서를 만들 수 없습니다</translation>
    </message>
    <message>
        <source>the report carries no results to compare with (results.json)</source>
        <translation>보고서에 비교할 결과가 없습니다 (results.json)</translation>
    </message>
    <message>
        <source>what the report carries as results.json is none of Covaria</source>
        <translation>보고서의 results.json은 Covaria의 것이 아닙니다</translation>
    </message>
    <message>
        <source>no folder could be made in %1: %2</source>
        <translation>%1에 폴더를 만들 수 없습니다: %2</translation>
    </message>
    <message>
        <source>the attached file %1 would leave its folder; nothing was taken out</source>
        <translation>첨부 파일 %1이(가) 폴더를 벗어납니다. 아무것도 꺼내지 않았습니다</translation>
    </message>
    <message>
        <source>the attached file %1 cannot be taken out: another one is in its way</source>
        <translation>첨부 파일 %1을(를) 꺼낼 수 없습니다. 다른 파일이 있습니다</translation>
    </message>
    <message>
        <source>it is no PDF</source>
        <translation>PDF가 아닙니다</translation>
    </message>
    <message>
        <source>it carries no project: it is no report of Covaria, or one of a version before 0.2.0, or another program has written it anew</source>
        <translation>프로젝트가 들어 있지 않습니다. Covaria의 보고서가 아니거나 0.2.0 이전 버전의 것이거나 다른 프로그램이 다시 기록한 것입니다</translation>
    </message>
    <message>
        <source>best</source>
        <translation>최선</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>최악</translation>
    </message>
    <message>
        <source>iso-surfaces at %1</source>
        <translation>등값면 %1</translation>
    </message>
    <message>
        <source>the study has not been run</source>
        <translation>스터디를 아직 실행하지 않았습니다</translation>
    </message>
    <message>
        <source>none of the study&apos;s output quantities has a place in space</source>
        <translation>스터디의 출력량 중 공간에 위치가 있는 것이 없습니다</translation>
    </message>
    <message>
        <source>the point %1 does not move in this study</source>
        <translation>점 %1은(는) 이 스터디에서 움직이지 않습니다</translation>
    </message>
    <message>
        <source>best: %1</source>
        <translation>최선: %1</translation>
    </message>
    <message>
        <source>nothing that this design chooses stands in space</source>
        <translation>이 설계가 선택하는 것은 공간에 없습니다</translation>
    </message>
    <message>
        <source>nothing that was tried has a result</source>
        <translation>시도한 것 중 결과가 있는 것이 없습니다</translation>
    </message>
    <message>
        <source>candidates; the larger %1 of %2 are chosen</source>
        <translation>후보. %2개 중 큰 %1개가 선택됨</translation>
    </message>
    <message>
        <source>gain: by how much the uncertainty is smaller with this candidate than without it, the others as chosen</source>
        <translation>이득: 다른 것은 선택된 대로일 때 이 후보가 있으면 없을 때보다 불확도가 얼마나 작은가</translation>
    </message>
    <message>
        <source>best so far, in the order of the search</source>
        <translation>지금까지의 최선, 탐색 순서</translation>
    </message>
    <message>
        <source>dashed: where it may stand</source>
        <translation>점선: 놓을 수 있는 곳</translation>
    </message>
    <message>
        <source>analysis</source>
        <translation>분석</translation>
    </message>
    <message>
        <source>kind</source>
        <translation>종류</translation>
    </message>
    <message>
        <source>trajectory</source>
        <translation>궤적</translation>
    </message>
    <message>
        <source>mean Monte Carlo</source>
        <translation>평균, 몬테카를로</translation>
    </message>
    <message>
        <source>u Monte Carlo</source>
        <translation>u, 몬테카를로</translation>
    </message>
    <message>
        <source>interval low</source>
        <translation>구간 하한</translation>
    </message>
    <message>
        <source>interval high</source>
        <translation>구간 상한</translation>
    </message>
    <message>
        <source>shortest low</source>
        <translation>최단 구간 하한</translation>
    </message>
    <message>
        <source>shortest high</source>
        <translation>최단 구간 상한</translation>
    </message>
    <message>
        <source>skewness</source>
        <translation>왜도</translation>
    </message>
    <message>
        <source>excess kurtosis</source>
        <translation>초과 첨도</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>비</translation>
    </message>
    <message>
        <source>y at the estimates</source>
        <translation>추정값에서의 y</translation>
    </message>
    <message>
        <source>u law of prop.</source>
        <translation>u, 전파 법칙</translation>
    </message>
    <message>
        <source>u with second-order terms</source>
        <translation>u, 이차항 포함</translation>
    </message>
    <message>
        <source>shift of the estimate</source>
        <translation>추정값의 이동</translation>
    </message>
    <message>
        <source>|cᵢ|·u(xᵢ) in %1</source>
        <translation>|cᵢ|·u(xᵢ), %1</translation>
    </message>
    <message>
        <source>Share of variance in %</source>
        <translation>분산 비율(%)</translation>
    </message>
    <message>
        <source>alone, Monte Carlo, in %1</source>
        <translation>단독, 몬테카를로, %1</translation>
    </message>
    <message>
        <source>ellipsoid, law of prop.</source>
        <translation>타원체, 전파 법칙</translation>
    </message>
    <message>
        <source>rectangle, law of prop.</source>
        <translation>직육면체, 전파 법칙</translation>
    </message>
    <message>
        <source>ellipsoid, Monte Carlo</source>
        <translation>타원체, 몬테카를로</translation>
    </message>
    <message>
        <source>rectangle, Monte Carlo</source>
        <translation>직육면체, 몬테카를로</translation>
    </message>
    <message>
        <source>y before</source>
        <translation>y, 이전</translation>
    </message>
    <message>
        <source>y after</source>
        <translation>y, 이후</translation>
    </message>
    <message>
        <source>Change of y</source>
        <translation>y의 변화</translation>
    </message>
    <message>
        <source>What</source>
        <translation>내용</translation>
    </message>
    <message>
        <source>|c|·u before in %1</source>
        <translation>|c|·u, 이전, %1</translation>
    </message>
    <message>
        <source>|c|·u after in %1</source>
        <translation>|c|·u, 이후, %1</translation>
    </message>
    <message>
        <source>Share before in %</source>
        <translation>이전 비율(%)</translation>
    </message>
    <message>
        <source>Share after in %</source>
        <translation>이후 비율(%)</translation>
    </message>
    <message>
        <source>Change of variance in %</source>
        <translation>분산의 변화(%)</translation>
    </message>
    <message>
        <source>first rotation, about z</source>
        <translation>첫째 회전, z축 둘레</translation>
    </message>
    <message>
        <source>second rotation, about y</source>
        <translation>둘째 회전, y축 둘레</translation>
    </message>
    <message>
        <source>third rotation, about z</source>
        <translation>셋째 회전, z축 둘레</translation>
    </message>
    <message>
        <source>rotation vector, x</source>
        <translation>회전 벡터, x</translation>
    </message>
    <message>
        <source>rotation vector, y</source>
        <translation>회전 벡터, y</translation>
    </message>
    <message>
        <source>rotation vector, z</source>
        <translation>회전 벡터, z</translation>
    </message>
    <message>
        <source>quaternion, scalar part</source>
        <translation>사원수, 스칼라 부분</translation>
    </message>
    <message>
        <source>quaternion, x</source>
        <translation>사원수, x</translation>
    </message>
    <message>
        <source>quaternion, y</source>
        <translation>사원수, y</translation>
    </message>
    <message>
        <source>quaternion, z</source>
        <translation>사원수, z</translation>
    </message>
    <message>
        <source>Coordinates that define the frame are left out.</source>
        <translation>좌표계를 정의하는 좌표는 생략합니다.</translation>
    </message>
    <message>
        <source>%1, coordinate %2</source>
        <translation>%1, 좌표 %2</translation>
    </message>
    <message>
        <source>tool centre point</source>
        <translation>공구 중심점</translation>
    </message>
    <message>
        <source>centre of the flange</source>
        <translation>플랜지 중심</translation>
    </message>
    <message>
        <source>calibration of the artefact</source>
        <translation>기준물의 교정</translation>
    </message>
    <message>
        <source>temperature of the artefact</source>
        <translation>기준물의 온도</translation>
    </message>
    <message>
        <source>systematic error of indication</source>
        <translation>지시값의 계통오차</translation>
    </message>
    <message>
        <source>coordinate %1</source>
        <translation>좌표 %1</translation>
    </message>
    <message>
        <source>The bias b is not corrected; |b| counts as a standard uncertainty (against JCGM 100 3.2.4).</source>
        <translation>편의 b는 보정하지 않으며 |b|를 표준불확도로 셈합니다(JCGM 100 3.2.4와 다름).</translation>
    </message>
    <message>
        <source>The bias b is not part of u_c.</source>
        <translation>편의 b는 u_c에 포함되지 않습니다.</translation>
    </message>
    <message>
        <source>Measured values are taken as corrected by -b; u_var/sqrt(n) of the correction is part of u_c.</source>
        <translation>측정값은 -b만큼 보정된 것으로 봅니다. 보정의 u_var/sqrt(n)은 u_c에 포함됩니다.</translation>
    </message>
    <message>
        <source>A coordinate of a point has u_c divided by √2.</source>
        <translation>점의 한 좌표의 u_c는 √2로 나눈 값입니다.</translation>
    </message>
    <message>
        <source>measured coordinate</source>
        <translation>측정된 좌표</translation>
    </message>
    <message>
        <source>typed standard uncertainty</source>
        <translation>직접 입력한 표준불확도</translation>
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
        <translation>사양: %1</translation>
    </message>
    <message>
        <source>The figure is taken as: %1.</source>
        <translation>이 값은 다음과 같이 해석합니다: %1.</translation>
    </message>
    <message>
        <source>%1, of a length: divided by √2</source>
        <translation>%1, 길이에 대한 것: √2로 나눔</translation>
    </message>
    <message>
        <source>station, combination %1</source>
        <translation>스테이션, 조합 %1</translation>
    </message>
    <message>
        <source>instrument: standard uncertainties and correlation of the station</source>
        <translation>측정기: 스테이션의 표준불확도와 상관</translation>
    </message>
    <message>
        <source>scale of distances</source>
        <translation>거리의 척도</translation>
    </message>
    <message>
        <source>zero offset of distances</source>
        <translation>거리의 영점 오차</translation>
    </message>
    <message>
        <source>index of the elevation</source>
        <translation>고도각의 지표 오차</translation>
    </message>
    <message>
        <source>collimation</source>
        <translation>시준 오차</translation>
    </message>
    <message>
        <source>squareness of the axes</source>
        <translation>축의 직각도</translation>
    </message>
    <message>
        <source>offset of the beam</source>
        <translation>빔의 어긋남</translation>
    </message>
    <message>
        <source>coefficient of refraction</source>
        <translation>굴절 계수</translation>
    </message>
    <message>
        <source>instrument: standard uncertainty</source>
        <translation>측정기: 표준불확도</translation>
    </message>
    <message>
        <source>instrument: %1</source>
        <translation>측정기: %1</translation>
    </message>
    <message>
        <source>For a target at the height of the instrument.</source>
        <translation>측정기 높이에 있는 표적에 대한 값입니다.</translation>
    </message>
    <message>
        <source>station, %1</source>
        <translation>스테이션, %1</translation>
    </message>
    <message>
        <source>%1, %2, set-up %3</source>
        <translation>%1, %2, 설치 %3</translation>
    </message>
    <message>
        <source>displacement across the azimuth</source>
        <translation>방위각에 수직인 변위</translation>
    </message>
    <message>
        <source>%1 to %2, %3</source>
        <translation>%1에서 %2까지, %3</translation>
    </message>
    <message>
        <source>calibrated length</source>
        <translation>교정된 길이</translation>
    </message>
    <message>
        <source>calibration of the %1</source>
        <translation>교정: %1</translation>
    </message>
    <message>
        <source>%1, calibrated length</source>
        <translation>%1, 교정된 길이</translation>
    </message>
    <message>
        <source>distance from %1 to %2</source>
        <translation>%1에서 %2까지의 거리</translation>
    </message>
    <message>
        <source>angle at %1 from %2 to %3</source>
        <translation>%1에서 %2와 %3 사이의 각도</translation>
    </message>
    <message>
        <source>%1, measured minus calibrated length</source>
        <translation>%1, 측정 길이 빼기 교정 길이</translation>
    </message>
    <message>
        <source>origin of %1, coordinate %2</source>
        <translation>%1의 원점, 좌표 %2</translation>
    </message>
    <message>
        <source>rotation of %1 about %2</source>
        <translation>%2 둘레의 %1 회전</translation>
    </message>
    <message>
        <source>The precision of the readings is no uncertainty of a position: it leaves out where the sensors stand and what their readings share. Monte Carlo is in the results.</source>
        <translation>읽음값의 정밀도는 위치의 불확도가 아닙니다. 센서의 위치와 읽음값들이 공유하는 것이 빠져 있습니다. 몬테카를로는 결과에 있습니다.</translation>
    </message>
    <message>
        <source>No redundancy: as many readings as unknowns, so nothing can be checked.</source>
        <translation>여유도 없음: 읽음값이 미지수와 같은 수이므로 아무것도 점검할 수 없습니다.</translation>
    </message>
    <message>
        <source>The residuals are larger than the uncertainties allow.</source>
        <translation>잔차가 불확도가 허용하는 것보다 큽니다.</translation>
    </message>
    <message>
        <source>The residuals are smaller than the uncertainties lead to expect.</source>
        <translation>잔차가 불확도에서 예상되는 것보다 작습니다.</translation>
    </message>
    <message>
        <source>The residuals agree with the uncertainties.</source>
        <translation>잔차가 불확도와 일치합니다.</translation>
    </message>
    <message>
        <source>%1 readings have |w| &gt; 3.29 (0.1 %); where several do, look at the largest first.</source>
        <translation>읽음값 %1개가 |w| &gt; 3.29 (0.1 %)입니다. 여럿이면 가장 큰 것부터 보십시오.</translation>
    </message>
    <message>
        <source>%1 in %2, coordinate %3</source>
        <translation>%2의 %1, 좌표 %3</translation>
    </message>
    <message>
        <source>position of the platform, %1</source>
        <translation>플랫폼의 위치, %1</translation>
    </message>
    <message>
        <source>Chi-square of the residuals with the full covariance of the stated uncertainties; nominal coordinates are taken as exact. p is the probability of a larger value if all is as stated; the test has a level of 1 % for all sets together. Not tested: sets without stated uncertainty, and sets of more than %1 points.</source>
        <translation>명시된 불확도의 전체 공분산으로 구한 잔차의 카이제곱이며, 공칭 좌표는 정확한 것으로 봅니다. p는 모든 것이 명시된 대로일 때 더 큰 값이 나올 확률이고, 검정의 유의수준은 모든 집합을 합하여 1 %입니다. 검정하지 않음: 불확도가 명시되지 않은 집합과 점이 %1개보다 많은 집합.</translation>
    </message>
    <message>
        <source>Measured less nominal coordinates. w is a residual over its own standard uncertainty; |w| &gt; 3.29 (0.1 %) is remarked. Redundancy is the share of an error of the coordinate that stays in its residual.</source>
        <translation>측정 좌표 빼기 공칭 좌표. w는 잔차를 자신의 표준불확도로 나눈 값이며 |w| &gt; 3.29 (0.1 %)이면 표시합니다. 여유도는 좌표의 오차 중 그 잔차에 남는 몫입니다.</translation>
    </message>
    <message>
        <source>reading of bar %1</source>
        <translation>볼바 %1의 읽음값</translation>
    </message>
    <message>
        <source>ballbars: %1</source>
        <translation>볼바: %1</translation>
    </message>
    <message>
        <source>length between supports %1</source>
        <translation>지지점 %1 사이의 길이</translation>
    </message>
    <message>
        <source>height of support %1</source>
        <translation>지지점 %1의 높이</translation>
    </message>
    <message>
        <source>ballbars: standard uncertainty</source>
        <translation>볼바: 표준불확도</translation>
    </message>
    <message>
        <source>scale of all lengths</source>
        <translation>모든 길이의 척도</translation>
    </message>
    <message>
        <source>constant of bar %1</source>
        <translation>볼바 %1의 상수</translation>
    </message>
    <message>
        <source>%1, point %2</source>
        <translation>%1, 점 %2</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>점 %1</translation>
    </message>
    <message>
        <source>axis %1 of the flange, angle towards %2</source>
        <translation>플랜지의 %1축, %2 쪽 각도</translation>
    </message>
    <message>
        <source>repeatability along %1</source>
        <translation>%1 방향 반복성</translation>
    </message>
    <message>
        <source>repeatability: %1</source>
        <translation>반복성: %1</translation>
    </message>
    <message>
        <source>The coordinates are uncorrelated; unless they are normal, they are not independent: the distance has the law above, its direction is random.</source>
        <translation>좌표들은 상관이 없습니다. 정규분포가 아니면 독립은 아닙니다. 거리는 위의 분포를 따르고 방향은 무작위입니다.</translation>
    </message>
    <message>
        <source>repeatability about %1</source>
        <translation>%1 둘레의 반복성</translation>
    </message>
    <message>
        <source>repeatability of the orientation</source>
        <translation>자세의 반복성</translation>
    </message>
    <message>
        <source>%1 of joint %2</source>
        <translation>관절 %2의 %1</translation>
    </message>
    <message>
        <source>encoder</source>
        <translation>인코더</translation>
    </message>
    <message>
        <source>tool, rotation about %1</source>
        <translation>공구, %1 둘레의 회전</translation>
    </message>
    <message>
        <source>tool: standard uncertainty</source>
        <translation>공구: 표준불확도</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1, combined</source>
        <translation>%1, 합성</translation>
    </message>
    <message>
        <source>%1, deviation</source>
        <translation>%1, 편차</translation>
    </message>
    <message>
        <source>reading of joint %1, %2</source>
        <translation>관절 %1의 읽음값, %2</translation>
    </message>
    <message>
        <source>position of the tool, %1</source>
        <translation>공구의 위치, %1</translation>
    </message>
    <message>
        <source>orientation of the tool, %1</source>
        <translation>공구의 방위, %1</translation>
    </message>
    <message>
        <source>joint angle</source>
        <translation>관절 각도</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>오프셋</translation>
    </message>
    <message>
        <source>link length</source>
        <translation>링크 길이</translation>
    </message>
    <message>
        <source>twist</source>
        <translation>비틀림각</translation>
    </message>
    <message>
        <source>second twist</source>
        <translation>둘째 비틀림각</translation>
    </message>
    <message>
        <source>Components of a parameter combine in quadrature (Wen et al., Eq. 10). U has the factor 2 of the paper; with few effective degrees of freedom 95 % need more.</source>
        <translation>한 매개변수의 성분들은 제곱합으로 합칩니다(Wen et al., Eq. 10). U는 논문의 인자 2를 씁니다. 유효 자유도가 작으면 95 %에는 더 큰 값이 필요합니다.</translation>
    </message>
    <message>
        <source>Places of the tool in the base frame of the robot.</source>
        <translation>로봇의 베이스 좌표계에서 공구가 있는 곳입니다.</translation>
    </message>
    <message>
        <source>calculated less measured %1, held back</source>
        <translation>계산값 빼기 측정값 %1, 점검용으로 남김</translation>
    </message>
    <message>
        <source>orientation of the base, %1</source>
        <translation>베이스의 방위, %1</translation>
    </message>
    <message>
        <source>position of the base, %1</source>
        <translation>베이스의 위치, %1</translation>
    </message>
    <message>
        <source>pose %1, rotation about %2</source>
        <translation>포즈 %1, %2 둘레의 회전</translation>
    </message>
    <message>
        <source>pose %1, %2</source>
        <translation>포즈 %1, %2</translation>
    </message>
    <message>
        <source>measured orientation</source>
        <translation>측정된 방위</translation>
    </message>
    <message>
        <source>pose %1, reading of joint %2</source>
        <translation>포즈 %1, 관절 %2의 읽음값</translation>
    </message>
    <message>
        <source>Singular values are those of the weighted Jacobian with columns of length one.</source>
        <translation>특이값은 열의 길이를 1로 맞춘 가중 야코비 행렬의 것입니다.</translation>
    </message>
    <message>
        <source>Least well told apart: %1.</source>
        <translation>가장 구별하기 어려운 것: %1.</translation>
    </message>
    <message>
        <source>A residual beyond %1 times its own standard uncertainty is an outlier: 5 % for all residuals together (Bonferroni).</source>
        <translation>자신의 표준불확도의 %1배를 넘는 잔차는 이상값입니다. 모든 잔차를 합하여 5 %입니다(Bonferroni).</translation>
    </message>
    <message>
        <source>Nominal: the same base and ball fitted with the nominal parameters. E_n = |d|/U: below 1 the pose agrees with the calibration.</source>
        <translation>공칭: 같은 베이스와 볼을 공칭 매개변수로 맞춘 것. E_n = |d|/U: 1보다 작으면 포즈가 교정과 일치합니다.</translation>
    </message>
    <message>
        <source>radius of the circle of joint %1</source>
        <translation>관절 %1의 원 반지름</translation>
    </message>
    <message>
        <source>%1, point %2, %3</source>
        <translation>%1, 점 %2, %3</translation>
    </message>
    <message>
        <source>Simulated points of the nominal robot: they lie on their circles.</source>
        <translation>공칭 로봇의 모의 점들: 각자의 원 위에 있습니다.</translation>
    </message>
    <message>
        <source>load %1, compensated</source>
        <translation>하중 %1, 보상됨</translation>
    </message>
    <message>
        <source>load %1 by its own channel alone</source>
        <translation>하중 %1, 자신의 채널만으로</translation>
    </message>
    <message>
        <source>calibration machine, %1</source>
        <translation>교정기, %1</translation>
    </message>
    <message>
        <source>calibration machine, Eq 5</source>
        <translation>교정기, Eq 5</translation>
    </message>
    <message>
        <source>regression of %1</source>
        <translation>%1의 회귀</translation>
    </message>
    <message>
        <source>reading of %1 by load %2</source>
        <translation>하중 %2에 의한 %1의 읽음값</translation>
    </message>
    <message>
        <source>quadratic term of %1 by load %2</source>
        <translation>하중 %2에 의한 %1의 이차항</translation>
    </message>
    <message>
        <source>%1 of %2, %3</source>
        <translation>%2의 %1, %3</translation>
    </message>
    <message>
        <source>standard deviation of one reading, Eq 3</source>
        <translation>읽음값 하나의 표준편차, Eq 3</translation>
    </message>
    <message>
        <source>net reading of %1, %2</source>
        <translation>%1의 순 읽음값, %2</translation>
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
        <translation>Eq 10, 루프의 전체 폭</translation>
    </message>
    <message>
        <source>Eq 10, in proportion to the load</source>
        <translation>Eq 10, 하중에 비례</translation>
    </message>
    <message>
        <source>Condition number, by rated outputs and rated loads: %1; with quadratic terms beside these slopes.</source>
        <translation>조건수, 정격 출력과 정격 하중 기준: %1. 이 기울기 외에 이차항이 있습니다.</translation>
    </message>
    <message>
        <source>Condition number, by rated outputs and rated loads: %1.</source>
        <translation>조건수, 정격 출력과 정격 하중 기준: %1.</translation>
    </message>
    <message>
        <source>Uncompensated: by the slope of the channel&apos;s own axis. The uncertainties of both are among the results.</source>
        <translation>보상 안 함: 채널 자신의 축의 기울기로 구한 것. 둘의 불확도는 결과에 있습니다.</translation>
    </message>
    <message>
        <source>Reproduces: equal in all printed digits. Inside rounding: what it is computed from was rounded, too. Interference, percent: the row&apos;s sensor, then the column&apos;s axis.</source>
        <translation>재현: 인쇄된 모든 자릿수가 같습니다. 반올림 이내: 계산의 근거가 된 값도 반올림되어 있습니다. 간섭, 퍼센트: 행의 센서, 다음에 열의 축.</translation>
    </message>
    <message>
        <source>Fig. 2: %1 s without load before a series, %2 s at each load.</source>
        <translation>Fig. 2: 한 계열 전에 하중 없이 %1 s, 각 하중에서 %2 s.</translation>
    </message>
    <message>
        <source>A row is a load, a column the sensor that answers to it.</source>
        <translation>행은 하중, 열은 그에 반응하는 센서입니다.</translation>
    </message>
    <message>
        <source>A row is a sensor, a column the load under which it gives this output.</source>
        <translation>행은 센서, 열은 그 출력을 내는 하중입니다.</translation>
    </message>
    <message>
        <source>Magnitudes: the signs are not known.</source>
        <translation>크기만: 부호는 알려지지 않았습니다.</translation>
    </message>
    <message>
        <source>U = hysteresis + interference + k u_c with k = %1: a linear sum of two largest values and an expanded uncertainty. Type A: n = %2 runs, %3 degrees of freedom.</source>
        <translation>U = 히스테리시스 + 간섭 + k u_c, k = %1: 두 최댓값과 한 확장불확도의 선형 합입니다. A형: n = %2회, 자유도 %3.</translation>
    </message>
    <message>
        <source>Calibration machine: %1.</source>
        <translation>교정기: %1.</translation>
    </message>
    <message>
        <source>Table 3 takes the Type B standard uncertainties that are stated, not these.</source>
        <translation>표 3은 이것이 아니라 명시된 B형 표준불확도를 씁니다.</translation>
    </message>
    <message>
        <source>load %1 that channel %1 tells</source>
        <translation>채널 %1이 알려 주는 하중 %1</translation>
    </message>
    <message>
        <source>net reading of channel %1</source>
        <translation>채널 %1의 순 읽음값</translation>
    </message>
    <message>
        <source>load by the rated load of channel %1</source>
        <translation>채널 %1의 정격 하중에 대한 하중</translation>
    </message>
    <message>
        <source>Eqs 3, 4</source>
        <translation>Eqs 3, 4</translation>
    </message>
    <message>
        <source>net reading of %1 at rated load</source>
        <translation>정격 하중에서 %1의 순 읽음값</translation>
    </message>
    <message>
        <source>calibration machine</source>
        <translation>교정기</translation>
    </message>
    <message>
        <source>Eq 5</source>
        <translation>Eq 5</translation>
    </message>
    <message>
        <source>Eq 10, as a rectangular distribution over the loop</source>
        <translation>Eq 10, 루프에 걸친 직사각형 분포</translation>
    </message>
    <message>
        <source>unknown load on %1</source>
        <translation>%1의 알 수 없는 하중</translation>
    </message>
    <message>
        <source>set-up: unknown between minus and plus the rated load</source>
        <translation>구성: 음과 양의 정격 하중 사이에서 알 수 없음</translation>
    </message>
    <message>
        <source>load on %1 by its rated load</source>
        <translation>정격 하중에 대한 %1의 하중</translation>
    </message>
    <message>
        <source>The paper adds the largest hysteresis and the largest interference to k times u_c. It counts one other load only: with several loads their interference adds up, and exceeds the paper&apos;s U for %1 of %2 sensors when all act fully.</source>
        <translation>논문은 가장 큰 히스테리시스와 가장 큰 간섭을 k 곱하기 u_c에 더합니다. 다른 하중은 하나만 셈합니다. 하중이 여럿이면 간섭이 더해져, 모두 최대로 작용할 때 센서 %2개 중 %1개에서 논문의 U를 넘습니다.</translation>
    </message>
    <message>
        <source>So the linear sum is no bound under combined load, and for one component alone it is far too large. As hysteresis and interference are limits and no standard uncertainties, it is no coverage interval either.</source>
        <translation>따라서 선형 합은 복합 하중에서 한계가 아니며, 한 성분만 있을 때에는 지나치게 큽니다. 히스테리시스와 간섭은 한계이지 표준불확도가 아니므로 포함구간도 아닙니다.</translation>
    </message>
    <message>
        <source>GUM: hysteresis, non-zero error and resolution are rectangular, each unknown load is rectangular between minus and plus its rated load, root sum of squares. One component alone: k from the t-distribution with the effective degrees of freedom.</source>
        <translation>GUM: 히스테리시스, 영점 오차, 분해능은 직사각형 분포이고, 알 수 없는 하중은 각각 음과 양의 정격 하중 사이의 직사각형 분포이며, 제곱합의 제곱근으로 합칩니다. 한 성분만: 유효 자유도를 갖는 t 분포의 k.</translation>
    </message>
    <message>
        <source>Repeatability: the largest of the steps; its degrees of freedom are those of one step. Pooled over the steps it has more of them.</source>
        <translation>반복성: 단계 중 가장 큰 것. 자유도는 한 단계의 것입니다. 단계들을 합치면 자유도가 더 많습니다.</translation>
    </message>
    <message>
        <source>pooled standard deviation</source>
        <translation>합동 표준편차</translation>
    </message>
    <message>
        <source>mean of %1 observations</source>
        <translation>관측값 %1개의 평균</translation>
    </message>
    <message>
        <source>s is the experimental standard deviation, u = s/√n (JCGM 100 4.2). A quantity that is stated as pooled observations has the u of all its series together (JCGM 100 4.2.4).</source>
        <translation>s는 실험 표준편차, u = s/√n입니다(JCGM 100 4.2). 합동 관측으로 명시된 양은 모든 계열을 합친 u를 갖습니다(JCGM 100 4.2.4).</translation>
    </message>
    <message>
        <source>scatter of the means of the groups</source>
        <translation>그룹 평균들의 흩어짐</translation>
    </message>
    <message>
        <source>components of variance between and within the groups</source>
        <translation>그룹 사이와 그룹 안의 분산 성분</translation>
    </message>
    <message>
        <source>%1 groups, %2 observations</source>
        <translation>그룹 %1개, 관측값 %2개</translation>
    </message>
    <message>
        <source>mean of all observations</source>
        <translation>모든 관측값의 평균</translation>
    </message>
    <message>
        <source>There is an effect of the groups at the level of 5 %.</source>
        <translation>5 % 수준에서 그룹의 효과가 있습니다.</translation>
    </message>
    <message>
        <source>No effect of the groups is seen at the level of 5 %.</source>
        <translation>5 % 수준에서 그룹의 효과가 보이지 않습니다.</translation>
    </message>
    <message>
        <source>The component of variance between the groups is zero: all observations count as independent.</source>
        <translation>그룹 사이의 분산 성분이 0입니다. 모든 관측값을 독립으로 봅니다.</translation>
    </message>
    <message>
        <source>scatter of the points about the curve</source>
        <translation>곡선 둘레에서 점들의 흩어짐</translation>
    </message>
    <message>
        <source>least squares, residuals of %1 points</source>
        <translation>최소제곱, 점 %1개의 잔차</translation>
    </message>
    <message>
        <source>value of the curve at the origin</source>
        <translation>원점에서 곡선의 값</translation>
    </message>
    <message>
        <source>coefficient of the power %1</source>
        <translation>%1차의 계수</translation>
    </message>
    <message>
        <source>mean of y</source>
        <translation>y의 평균</translation>
    </message>
    <message>
        <source>term of degree %1 (orthonormal polynomial)</source>
        <translation>%1차 항 (정규직교 다항식)</translation>
    </message>
    <message>
        <source>%1 of point %2</source>
        <translation>점 %2의 %1</translation>
    </message>
    <message>
        <source>stated uncertainty of %1</source>
        <translation>%1의 명시된 불확도</translation>
    </message>
    <message>
        <source>table of points</source>
        <translation>점들의 표</translation>
    </message>
    <message>
        <source>observed y</source>
        <translation>관측된 y</translation>
    </message>
    <message>
        <source>%1, observed y</source>
        <translation>%1, 관측된 y</translation>
    </message>
    <message>
        <source>table of the inverse use</source>
        <translation>역사용의 표</translation>
    </message>
    <message>
        <source>value of the curve at %1</source>
        <translation>%1에서 곡선의 값</translation>
    </message>
    <message>
        <source>x where the curve is %1</source>
        <translation>곡선이 %1인 x</translation>
    </message>
    <message>
        <source>The residuals agree with the stated uncertainties.</source>
        <translation>잔차가 명시된 불확도와 일치합니다.</translation>
    </message>
    <message>
        <source>The residuals are larger than the stated uncertainties explain: the curve or the uncertainties do not describe these points.</source>
        <translation>잔차가 명시된 불확도로 설명되는 것보다 큽니다. 곡선이나 불확도가 이 점들을 기술하지 못합니다.</translation>
    </message>
    <message>
        <source>The x of y = %1 lies outside of the points of the calibration.</source>
        <translation>y = %1의 x가 교정 점들의 바깥에 있습니다.</translation>
    </message>
    <message>
        <source>the parameters come from an analysis, which is evaluated in every trial: their correlation cannot be ignored</source>
        <translation>매개변수는 매 시행에서 평가되는 분석에서 옵니다. 그 상관은 무시할 수 없습니다</translation>
    </message>
    <message>
        <source>Rz(θ) Tz(d) Tx(a) Rx(α) Ry(β), β for parallel joints</source>
        <translation>Rz(θ) Tz(d) Tx(a) Rx(α) Ry(β), β는 평행 관절용</translation>
    </message>
    <message>
        <source>Rz(θ) Tz(d) Tx(a) Rx(α), Denavit-Hartenberg</source>
        <translation>Rz(θ) Tz(d) Tx(a) Rx(α), Denavit-Hartenberg</translation>
    </message>
    <message>
        <source>Rx(α) Tx(a) Rz(θ) Tz(d), Craig: α and a before joint i</source>
        <translation>Rx(α) Tx(a) Rz(θ) Tz(d), Craig: α와 a는 관절 i 앞</translation>
    </message>
    <message>
        <source>Date of receipt</source>
        <translation>접수일</translation>
    </message>
    <message>
        <source>Date of calibration</source>
        <translation>교정일</translation>
    </message>
    <message>
        <source>Date of issue</source>
        <translation>발행일</translation>
    </message>
    <message>
        <source>To first order no input quantity influences %1 at these estimates: its uncertainty is of second order, as Monte Carlo shows</source>
        <translation>이 추정값에서 1차로는 어떤 입력량도 %1에 영향을 주지 않습니다: 몬테카를로가 보여 주듯 불확도는 2차입니다</translation>
    </message>
    <message>
        <source>Calibration certificate</source>
        <translation>교정 성적서</translation>
    </message>
    <message>
        <source>not normal; k u fits as far as so few trials can tell</source>
        <translation>정규가 아님. 이렇게 적은 시행으로 알 수 있는 한 k u는 맞음</translation>
    </message>
    <message>
        <source>measured artefact, Porath et al., Eq. 2</source>
        <translation>측정된 표준물, Porath et al., 식 2</translation>
    </message>
    <message>
        <source>not controlled</source>
        <translation>제어되지 않음</translation>
    </message>
    <message>
        <source>outlier?</source>
        <translation>이상값?</translation>
    </message>
    <message>
        <source>not tested</source>
        <translation>검정하지 않음</translation>
    </message>
    <message>
        <source>residuals larger than stated</source>
        <translation>잔차가 명시된 것보다 큼</translation>
    </message>
    <message>
        <source>agrees</source>
        <translation>일치</translation>
    </message>
    <message>
        <source>distance: largest</source>
        <translation>거리: 최대</translation>
    </message>
    <message>
        <source>distance: RP = mean + 3 s</source>
        <translation>거리: RP = 평균 + 3 s</translation>
    </message>
    <message>
        <source>does not move the measured points in any pose</source>
        <translation>어느 포즈에서도 측정점을 움직이지 않음</translation>
    </message>
    <message>
        <source>moves the measured points as %1 can: coupled with it, held at its nominal value</source>
        <translation>%1이(가) 할 수 있듯이 측정점을 움직임: 서로 결합되어 공칭값으로 고정</translation>
    </message>
    <message>
        <source>coordinates in the fit</source>
        <translation>맞춤에 쓰인 좌표</translation>
    </message>
    <message>
        <source>unknowns (rank)</source>
        <translation>미지수 (계수)</translation>
    </message>
    <message>
        <source>condition of the fit</source>
        <translation>맞춤의 조건수</translation>
    </message>
    <message>
        <source>smallest singular value</source>
        <translation>최소 특이값</translation>
    </message>
    <message>
        <source>residuals over what uncertainties explain</source>
        <translation>불확도가 설명하는 것 대비 잔차</translation>
    </message>
    <message>
        <source>outlier</source>
        <translation>이상값</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>공구</translation>
    </message>
    <message>
        <source>one ball is one point: it has no orientation</source>
        <translation>공 하나는 점 하나: 방향이 없음</translation>
    </message>
    <message>
        <source>places the base frame on axis 1: by definition, as nominal; it would need a measured base</source>
        <translation>베이스 좌표계를 축 1에 놓음: 정의에 따라 공칭값과 같음. 측정된 베이스가 필요함</translation>
    </message>
    <message>
        <source>places the frame of the last link, which no axis follows: by definition, as nominal</source>
        <translation>뒤따르는 축이 없는 마지막 링크의 좌표계를 놓음: 정의에 따라 공칭값과 같음</translation>
    </message>
    <message>
        <source>the axis is parallel to the next: 0 by definition, or beta and d would describe the same</source>
        <translation>축이 다음 축과 평행함: 정의에 따라 0. 그러지 않으면 beta와 d가 같은 것을 나타냄</translation>
    </message>
    <message>
        <source>reproduces</source>
        <translation>재현됨</translation>
    </message>
    <message>
        <source>inside rounding</source>
        <translation>반올림 이내</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>다름</translation>
    </message>
    <message>
        <source>planned</source>
        <translation>계획</translation>
    </message>
    <message>
        <source>total</source>
        <translation>전체</translation>
    </message>
    <message>
        <source>standard deviation of the means of the groups</source>
        <translation>그룹 평균의 표준편차</translation>
    </message>
    <message>
        <source>s_a, from the means of the groups</source>
        <translation>s_a, 그룹 평균으로부터</translation>
    </message>
    <message>
        <source>s_b, within the groups</source>
        <translation>s_b, 그룹 내</translation>
    </message>
    <message>
        <source>s_B, between the groups</source>
        <translation>s_B, 그룹 간</translation>
    </message>
    <message>
        <source>n_0, size of the groups</source>
        <translation>n_0, 그룹의 크기</translation>
    </message>
    <message>
        <source>F = s_a²/s_b²</source>
        <translation>F = s_a²/s_b²</translation>
    </message>
    <message>
        <source>95 % quantile of F</source>
        <translation>F의 95 % 분위수</translation>
    </message>
    <message>
        <source>97.5 % quantile of F</source>
        <translation>F의 97.5 % 분위수</translation>
    </message>
    <message>
        <source>between the groups</source>
        <translation>그룹 간</translation>
    </message>
    <message>
        <source>within the groups</source>
        <translation>그룹 내</translation>
    </message>
    <message>
        <source>chi-squared</source>
        <translation>카이제곱</translation>
    </message>
    <message>
        <source>its 95 % quantile</source>
        <translation>그 95 % 분위수</translation>
    </message>
    <message>
        <source>standard deviation of the residuals</source>
        <translation>잔차의 표준편차</translation>
    </message>
    <message>
        <source>coefficient of determination R²</source>
        <translation>결정계수 R²</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>곡선</translation>
    </message>
    <message>
        <source>residuals</source>
        <translation>잔차</translation>
    </message>
    <message>
        <source>position %1, rotations about x, y, z: %2</source>
        <translation>위치 %1, x, y, z 둘레의 회전: %2</translation>
    </message>
    <message>
        <source>1 further component</source>
        <translation>나머지 성분 1개</translation>
    </message>
    <message>
        <source>Shown for %1, the first of the %2 groups; the CSV table of budgets has every group.</source>
        <translation>그룹 %2개 중 첫 번째인 %1만 표시합니다. 총괄표의 CSV 표에는 모든 그룹이 있습니다.</translation>
    </message>
    <message>
        <source>Shown for %1: of the %2 groups it has the largest expanded uncertainties on average; the CSV table of budgets has every group.</source>
        <translation>%1만 표시합니다: 그룹 %2개 중 확장불확도가 평균적으로 가장 큽니다. 총괄표의 CSV 표에는 모든 그룹이 있습니다.</translation>
    </message>
    <message>
        <source>Shown for %1: of the %2 groups with the same quantities it has the largest expanded uncertainties on average; the CSV table of budgets has all %3 groups.</source>
        <translation>%1만 표시합니다: 같은 양을 가진 그룹 %2개 중 확장불확도가 평균적으로 가장 큽니다. 총괄표의 CSV 표에는 그룹 %3개가 모두 있습니다.</translation>
    </message>
    <message>
        <source>The law of propagation is validated by JCGM 101 clause 8 where both ends of its coverage interval, y ± U, lie within the numerical tolerance δ of those of the propagation of distributions. Validated: %1 of %2.</source>
        <translation>JCGM 101 8절에 따라 전파 법칙의 포함구간 y ± U의 양 끝이 분포 전파의 양 끝과 수치 허용오차 δ 이내이면 전파 법칙이 타당합니다. 타당함: %2개 중 %1개.</translation>
    </message>
    <message>
        <source>Shape of the distributions by Monte Carlo</source>
        <translation>몬테카를로에 의한 분포의 모양</translation>
    </message>
    <message>
        <source>From &apos;%1&apos; on, %2 of %3 rows; the annex has all of them.</source>
        <translation>‘%1’부터 행 %3개 중 %2개. 부록에 모두 있습니다.</translation>
    </message>
    <message>
        <source>From &apos;%1&apos; on, %2 of %3 rows; the CSV tables, and the annex on request, have all of them.</source>
        <translation>‘%1’부터 행 %3개 중 %2개. CSV 표와 요청 시 부록에 모두 있습니다.</translation>
    </message>
    <message>
        <source>The annex has the charts.</source>
        <translation>그래프는 부록에 있습니다.</translation>
    </message>
    <message>
        <source>The CSV tables, and the annex on request, have what the charts show.</source>
        <translation>그래프의 내용은 CSV 표와 요청 시 부록에 있습니다.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables and no chart; the annex has the rest.</source>
        <translation>표 %2개 중 %1개를 표시하고 그래프는 없음. 나머지는 부록에 있습니다.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables and no chart; the CSV tables, and the annex on request, have the rest.</source>
        <translation>표 %2개 중 %1개를 표시하고 그래프는 없음. 나머지는 CSV 표와 요청 시 부록에 있습니다.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>미지수</translation>
    </message>
    <message>
        <source>coupled with</source>
        <translation>결합된 미지수</translation>
    </message>
    <message>
        <source>Observations of %1</source>
        <translation>%1의 관측값</translation>
    </message>
    <message>
        <source>mean + s</source>
        <translation>평균 + s</translation>
    </message>
    <message>
        <source>mean − s</source>
        <translation>평균 − s</translation>
    </message>
    <message>
        <source>What is reported, and in which unit. Without rows: every name that an equation defines and no other one uses, in the unit of the first quantity of the same dimension, else in SI units.</source>
        <translation>무엇을 어떤 단위로 보고하는지. 행이 없으면: 한 방정식이 정의하고 다른 방정식이 쓰지 않는 모든 이름을, 같은 차원의 첫 번째 양의 단위로, 없으면 SI 단위로.</translation>
    </message>
    <message>
        <source>arcsine</source>
        <translation>아크사인</translation>
    </message>
    <message>
        <source>curvilinear</source>
        <translation>곡선사다리꼴</translation>
    </message>
    <message>
        <source>inexactness</source>
        <translation>부정확도</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>한계</translation>
    </message>
    <message>
        <source>pooled</source>
        <translation>합동</translation>
    </message>
    <message>
        <source>From the set-up as it is stated. Values and uncertainties that other analyses give (%1 quantities) are in the results, not here.</source>
        <translation>기재된 설정에 따른 것입니다. 다른 분석이 주는 값과 불확도(%1개 양)는 결과에 있으며 여기에는 없습니다.</translation>
    </message>
    <message>
        <source>Limit of the coverage interval: of Monte Carlo, else of the law of propagation</source>
        <translation>포함구간의 한계: 몬테카를로에 따르고, 없으면 전파법칙에 따름</translation>
    </message>
    <message>
        <source>Input quantities that the component is part of</source>
        <translation>성분이 속하는 입력량</translation>
    </message>
    <message>
        <source>Quantity or component of uncertainty, as at the bars of the chart</source>
        <translation>양 또는 불확도 성분. 그래프 막대의 이름과 같음</translation>
    </message>
    <message>
        <source>density</source>
        <translation>밀도</translation>
    </message>
    <message>
        <source>quantile</source>
        <translation>분위수</translation>
    </message>
    <message>
        <source>calibrated lengths</source>
        <translation>교정된 길이</translation>
    </message>
    <message>
        <source>distances</source>
        <translation>거리</translation>
    </message>
    <message>
        <source>angles</source>
        <translation>각도</translation>
    </message>
    <message>
        <source>scale bar</source>
        <translation>기준자</translation>
    </message>
    <message>
        <source>base</source>
        <translation>베이스</translation>
    </message>
    <message>
        <source>supports</source>
        <translation>지지점</translation>
    </message>
    <message>
        <source>axes of the flange</source>
        <translation>플랜지의 축</translation>
    </message>
    <message>
        <source>circles</source>
        <translation>원</translation>
    </message>
    <message>
        <source>calibration matrix</source>
        <translation>교정 행렬</translation>
    </message>
    <message>
        <source>loads on other axes</source>
        <translation>다른 축의 하중</translation>
    </message>
    <message>
        <source>scatter of all observations</source>
        <translation>모든 관측값의 흩어짐</translation>
    </message>
    <message>
        <source>points, x</source>
        <translation>점, x</translation>
    </message>
    <message>
        <source>points, y</source>
        <translation>점, y</translation>
    </message>
    <message>
        <source>inverse use</source>
        <translation>역사용</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>%1, all rows: %2</source>
        <translation>%1, 모든 행: %2</translation>
    </message>
    <message>
        <source>%1: uncertainty</source>
        <translation>%1: 불확도</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>%1행</translation>
    </message>
    <message>
        <source>%1: estimate</source>
        <translation>%1: 추정값</translation>
    </message>
    <message>
        <source>%1, factor</source>
        <translation>%1, 배수</translation>
    </message>
    <message>
        <source>%1, added</source>
        <translation>%1, 더한 값</translation>
    </message>
    <message>
        <source>base b</source>
        <translation>베이스 b</translation>
    </message>
    <message>
        <source>platform p</source>
        <translation>플랫폼 p</translation>
    </message>
    <message>
        <source>support %1</source>
        <translation>지지점 %1</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>축 %1</translation>
    </message>
    <message>
        <source>check %1</source>
        <translation>확인 %1</translation>
    </message>
    <message>
        <source>axis of %1</source>
        <translation>%1의 축</translation>
    </message>
    <message>
        <source>scale bar %1</source>
        <translation>기준자 %1</translation>
    </message>
    <message>
        <source>%1 (u of first order: %2 of that by Monte Carlo)</source>
        <translation>%1(1차 u: 몬테카를로의 %2)</translation>
    </message>
    <message>
        <source>S / %</source>
        <translation>S / %</translation>
    </message>
    <message>
        <source>Share of the variance that the component causes by itself (Sobol index)</source>
        <translation>성분이 단독으로 일으키는 분산의 비율(소볼 지수)</translation>
    </message>
    <message>
        <source>S total / %</source>
        <translation>총 S / %</translation>
    </message>
    <message>
        <source>Share of the variance with all interactions of the component with others</source>
        <translation>다른 성분과의 모든 상호작용을 포함한 분산의 비율</translation>
    </message>
    <message>
        <source>ν (first order)</source>
        <translation>ν (1차)</translation>
    </message>
    <message>
        <source>%1 out of %2</source>
        <translation>%2개 중 %1개</translation>
    </message>
    <message>
        <source>%1 interval, low</source>
        <translation>%1 구간, 하한</translation>
    </message>
    <message>
        <source>%1 interval, high</source>
        <translation>%1 구간, 상한</translation>
    </message>
    <message>
        <source>Interval, low</source>
        <translation>구간, 하한</translation>
    </message>
    <message>
        <source>Interval, high</source>
        <translation>구간, 상한</translation>
    </message>
    <message>
        <source>ballbars</source>
        <translation>볼바</translation>
    </message>
    <message>
        <source>flange</source>
        <translation>플랜지</translation>
    </message>
    <message>
        <source>A mean of n observations is drawn from a t distribution with n − 1 degrees of freedom (JCGM 101 6.4.9). Means of simultaneous observations are drawn from one multivariate t distribution with these n − 1 degrees of freedom; with the n − N of JCGM 102 5.3.2 no mean would keep its own distribution.</source>
        <translation>n개 관측값의 평균은 자유도 n − 1인 t 분포에서 추출합니다(JCGM 101 6.4.9). 동시에 관측한 값들의 평균은 같은 자유도 n − 1의 다변량 t 분포 하나에서 추출합니다. JCGM 102 5.3.2의 n − N을 쓰면 각 평균이 자신의 분포를 유지하지 못합니다.</translation>
    </message>
    <message>
        <source>if it vanished, U would exceed the target again, with fewer degrees of freedom</source>
        <translation>이것이 없어지면 자유도가 줄어 U가 다시 목표를 넘습니다</translation>
    </message>
    <message>
        <source>Unit of the value, and of a and b where they have no other; empty: 1. A difference of temperatures is given in K.</source>
        <translation>값의 단위이며, a와 b에 다른 단위가 없으면 그 단위이기도 합니다. 비우면 1입니다. 온도 차는 K로 제시합니다.</translation>
    </message>
    <message>
        <source>First figure of the statement.</source>
        <translation>제시한 내용의 첫째 수.</translation>
    </message>
    <message>
        <source>unit of a, b</source>
        <translation>a, b의 단위</translation>
    </message>
    <message>
        <source>Unit of the statement&apos;s figures; empty: the row&apos;s. % and ppm of a quantity that has a unit are parts of its value.</source>
        <translation>제시한 수의 단위. 비우면 행의 단위입니다. 단위가 있는 양의 %와 ppm은 그 값에 대한 비율입니다.</translation>
    </message>
    <message>
        <source>Budget of %1</source>
        <translation>%1의 총괄표</translation>
    </message>
    <message>
        <source>Two correlated components have half of their covariance each, in the effective degrees of freedom too.</source>
        <translation>상관된 두 성분은 공분산의 절반씩을 가지며, 유효 자유도에서도 그렇습니다.</translation>
    </message>
    <message>
        <source>u along any axis</source>
        <translation>각 축 방향의 u</translation>
    </message>
    <message>
        <source>results: in the base frame of the robot</source>
        <translation>결과: 로봇 기준 좌표계의 값</translation>
    </message>
    <message>
        <source>%1: chosen at an end of its range; a wider one can give a better design.</source>
        <translation>%1: 범위의 끝에서 선택되었습니다. 더 넓은 범위가 더 좋은 설계를 줄 수 있습니다.</translation>
    </message>
    <message>
        <source>artefact</source>
        <translation>기준물</translation>
    </message>
    <message>
        <source>length standard</source>
        <translation>길이 표준기</translation>
    </message>
    <message>
        <source>station</source>
        <translation>스테이션</translation>
    </message>
    <message>
        <source>field of view</source>
        <translation>시야</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>미정</translation>
    </message>
    <message>
        <source>Of these verdicts, %1 could be the other one with other trials.</source>
        <translation>이 가운데 %1개의 판정은 다른 시행에서는 반대일 수 있습니다.</translation>
    </message>
    <message>
        <source>the value typed is used, not the mean of the observations, %1</source>
        <translation>관측값의 평균 %1이(가) 아니라 입력한 값이 쓰입니다</translation>
    </message>
    <message>
        <source>the correlation coefficient of %1 and %2 must lie between -1 and 1; it is %3</source>
        <translation>%1과(와) %2의 상관계수는 -1과 1 사이여야 합니다. 지금은 %3입니다</translation>
    </message>
    <message>
        <source>Both are estimates by sampling, with the standard errors beside them: S can exceed S total by chance.</source>
        <translation>둘 다 표본 추출에 의한 추정값이며 표준오차가 옆에 있습니다. S가 우연히 전체 S보다 클 수 있습니다.</translation>
    </message>
    <message>
        <source>Any measurement equation with what is known about its quantities: several results, intermediate definitions, conditions, and equations that are solved in every trial.</source>
        <translation>임의의 측정식과 각 양에 대해 아는 것: 여러 결과, 중간 정의, 조건, 그리고 시행마다 푸는 식.</translation>
    </message>
    <message>
        <source>Uncertainty of a measured point</source>
        <translation>측정점의 불확도</translation>
    </message>
    <message>
        <source>Residuals of the readings</source>
        <translation>읽음값의 잔차</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>읽음</translation>
    </message>
    <message>
        <source>u of the reading</source>
        <translation>읽음값의 u</translation>
    </message>
    <message>
        <source>redundancy</source>
        <translation>잉여도</translation>
    </message>
    <message>
        <source>remark</source>
        <translation>비고</translation>
    </message>
    <message>
        <source>Fit of the measured points to their nominal coordinates</source>
        <translation>측정점의 공칭 좌표에 대한 맞춤</translation>
    </message>
    <message>
        <source>root mean square residual</source>
        <translation>잔차의 제곱평균제곱근</translation>
    </message>
    <message>
        <source>chi-square</source>
        <translation>카이제곱</translation>
    </message>
    <message>
        <source>largest normalised residual</source>
        <translation>최대 정규화 잔차</translation>
    </message>
    <message>
        <source>of</source>
        <translation>대상</translation>
    </message>
    <message>
        <source>Residuals of the points, along the axes of their frame</source>
        <translation>점의 잔차, 좌표계의 축 방향</translation>
    </message>
    <message>
        <source>residual x</source>
        <translation>잔차 x</translation>
    </message>
    <message>
        <source>residual y</source>
        <translation>잔차 y</translation>
    </message>
    <message>
        <source>residual z</source>
        <translation>잔차 z</translation>
    </message>
    <message>
        <source>redundancy x</source>
        <translation>잉여도 x</translation>
    </message>
    <message>
        <source>redundancy y</source>
        <translation>잉여도 y</translation>
    </message>
    <message>
        <source>redundancy z</source>
        <translation>잉여도 z</translation>
    </message>
    <message>
        <source>present series</source>
        <translation>현재 계열</translation>
    </message>
    <message>
        <source>also reached at x</source>
        <translation>다음 x에서도 도달</translation>
    </message>
    <message>
        <source>a kept state</source>
        <translation>보관된 상태</translation>
    </message>
    <message>
        <source>two states of the analysis %1 are kept; one can be</source>
        <translation>분석 %1의 상태가 둘 보관되어 있습니다. 하나만 보관할 수 있습니다</translation>
    </message>
    <message>
        <source>&apos;digits&apos; must be a whole number from %1 to %2 (JCGM 100 7.2.6)</source>
        <translation>&apos;digits&apos;는 %1에서 %2까지의 정수여야 합니다 (JCGM 100 7.2.6)</translation>
    </message>
    <message>
        <source>the model cannot be evaluated</source>
        <translation>모델을 평가할 수 없습니다</translation>
    </message>
    <message>
        <source>there is no output quantity &apos;%1&apos; here</source>
        <translation>여기에는 출력량 &apos;%1&apos;이(가) 없습니다</translation>
    </message>
    <message>
        <source>from the present values</source>
        <translation>현재 값에서 시작</translation>
    </message>
    <message>
        <source>global search</source>
        <translation>전역 탐색</translation>
    </message>
    <message>
        <source>start %1</source>
        <translation>시작 %1</translation>
    </message>
    <message>
        <source>a target uncertainty is not met</source>
        <translation>목표 불확도를 만족하지 못합니다</translation>
    </message>
    <message>
        <source>there is no output quantity &apos;%1&apos; then</source>
        <translation>그때는 출력량 &apos;%1&apos;이(가) 없습니다</translation>
    </message>
    <message>
        <source>an uncertainty has no finite value</source>
        <translation>유한한 값이 없는 불확도가 있습니다</translation>
    </message>
    <message>
        <source>an uncertainty vanishes: the model is degenerate there</source>
        <translation>불확도가 0이 됩니다. 모델이 그곳에서 퇴화합니다</translation>
    </message>
    <message>
        <source>all choices</source>
        <translation>모든 선택</translation>
    </message>
    <message>
        <source>greedy</source>
        <translation>단계별 선택</translation>
    </message>
    <message>
        <source>backward elimination</source>
        <translation>후진 제거</translation>
    </message>
    <message>
        <source>exchange</source>
        <translation>교환</translation>
    </message>
    <message>
        <source>%1 and %2 are closer than the least distance</source>
        <translation>%1과(와) %2이(가) 최소 거리보다 가깝습니다</translation>
    </message>
    <message>
        <source>%1 stands in a box</source>
        <translation>%1이(가) 상자 안에 있습니다</translation>
    </message>
    <message>
        <source>%1 stands in the box &apos;%2&apos;</source>
        <translation>%1이(가) 상자 &apos;%2&apos; 안에 있습니다</translation>
    </message>
    <message>
        <source>the line of sight %1 passes a box</source>
        <translation>시준선 %1이(가) 상자를 지납니다</translation>
    </message>
    <message>
        <source>the line of sight %1 passes the box &apos;%2&apos;</source>
        <translation>시준선 %1이(가) 상자 &apos;%2&apos;을(를) 지납니다</translation>
    </message>
    <message>
        <source>%1 (row %2)</source>
        <translation>%1 (%2행)</translation>
    </message>
    <message>
        <source>%1: uncertainty too small to be seen</source>
        <translation>%1: 불확도가 너무 작아 보이지 않음</translation>
    </message>
    <message>
        <source>uncertainty drawn at %1 of %2 points</source>
        <translation>%2개 점 중 %1개에 불확도를 표시함</translation>
    </message>
    <message>
        <source>standard deviation known before (Type A)</source>
        <translation>앞서 알려진 표준편차(A형)</translation>
    </message>
    <message>
        <source>share of the variance, first order</source>
        <translation>분산의 몫, 1차</translation>
    </message>
    <message>
        <source>change, relative to the variance before</source>
        <translation>이전 분산에 대한 변화</translation>
    </message>
    <message>
        <source>growth of the objective without it</source>
        <translation>그 행이 없을 때 목적값의 증가</translation>
    </message>
    <message>
        <source>the number of observations in the mean must be at least one</source>
        <translation>평균의 관측 횟수는 1 이상이어야 합니다</translation>
    </message>
    <message>
        <source>results: in the frame of the sensor</source>
        <translation>결과: 센서 좌표계의 값</translation>
    </message>
    <message>
        <source>time</source>
        <translation>시간</translation>
    </message>
    <message>
        <source>net reading</source>
        <translation>순 읽음</translation>
    </message>
    <message>
        <source>deviation from the line</source>
        <translation>직선으로부터의 편차</translation>
    </message>
    <message>
        <source>Design: twelve points of a ballbar measurement</source>
        <translation>설계: 볼바 측정의 열두 점</translation>
    </message>
    <message>
        <source>Tool centre point of a robot by telescopic ballbars</source>
        <translation>텔레스코픽 볼바에 의한 로봇의 공구 중심점</translation>
    </message>
    <message>
        <source>From the certificate of a scale bar to the tool of a robot</source>
        <translation>기준자의 성적서에서 로봇의 공구까지</translation>
    </message>
    <message>
        <source>Industrial robot ER10L-C10</source>
        <translation>산업용 로봇 ER10L-C10</translation>
    </message>
    <message>
        <source>Six-axis force/moment sensor</source>
        <translation>6축 힘/모멘트 센서</translation>
    </message>
    <message>
        <source>Scale bar in a network of three cameras and a laser tracker</source>
        <translation>카메라 세 대와 레이저 트래커 한 대로 된 센서망에 있는 기준자</translation>
    </message>
    <message>
        <source>Stewart platform measured with a total station</source>
        <translation>토털 스테이션으로 측정한 스튜어트 플랫폼</translation>
    </message>
    <message>
        <source>Pose of a Stewart platform measured by a network</source>
        <translation>센서망으로 측정한 스튜어트 플랫폼의 포즈</translation>
    </message>
    <message>
        <source>End-gauge calibration (GUM H.1)</source>
        <translation>엔드 게이지 교정 (GUM H.1)</translation>
    </message>
    <message>
        <source>Simultaneous resistance and reactance (GUM H.2)</source>
        <translation>저항과 리액턴스의 동시 측정 (GUM H.2)</translation>
    </message>
    <message>
        <source>Calibration of a thermometer (GUM H.3)</source>
        <translation>온도계 교정 (GUM H.3)</translation>
    </message>
    <message>
        <source>Zener voltage standard on ten days (GUM H.5)</source>
        <translation>열흘간의 제너 전압 표준기 (GUM H.5)</translation>
    </message>
    <message>
        <source>JCGM 100:2008, Annex H.5, Table H.9: five observations on each of ten days, and the analysis of variance that says whether the days have an effect.</source>
        <translation>JCGM 100:2008, 부속서 H.5, 표 H.9: 열흘 동안 매일 다섯 번의 관측과, 날짜가 영향을 주는지 말해 주는 분산분석.</translation>
    </message>
    <message>
        <source>Additive model (GUM Supplement 1, 9.2)</source>
        <translation>가산 모형 (GUM 보충서 1, 9.2)</translation>
    </message>
    <message>
        <source>JCGM 101:2008, clause 9.2: a sum of four quantities with three choices of their distributions, and the validation of clause 8.</source>
        <translation>JCGM 101:2008, 9.2절: 세 가지 분포를 가진 네 양의 합과 8절의 타당성 확인.</translation>
    </message>
    <message>
        <source>Mass calibration (GUM Supplement 1, 9.3)</source>
        <translation>질량 교정 (GUM 보충서 1, 9.3)</translation>
    </message>
    <message>
        <source>JCGM 101:2008, clause 9.3: a weight of 100 g is compared with a reference weight in air; to first order the densities seem not to matter.</source>
        <translation>JCGM 101:2008, 9.3절: 100 g 분동을 공기 중에서 기준 분동과 비교한다. 1차 근사에서는 밀도가 중요하지 않아 보인다.</translation>
    </message>
    <message>
        <source>Comparison loss of a power meter (GUM Supplement 1, 9.4)</source>
        <translation>전력계의 비교 손실 (GUM 보충서 1, 9.4)</translation>
    </message>
    <message>
        <source>JCGM 101:2008, clause 9.4, Tables 8 and 9: a sum of two squares near zero, where the law of propagation fails.</source>
        <translation>JCGM 101:2008, 9.4절, 표 8과 9: 0에 가까운 두 제곱의 합으로, 전파 법칙이 통하지 않는다.</translation>
    </message>
    <message>
        <source>Gauge-block calibration (GUM Supplement 1, 9.5)</source>
        <translation>게이지 블록 교정 (GUM 보충서 1, 9.5)</translation>
    </message>
    <message>
        <source>JCGM 101:2008, clause 9.5: the end gauge of GUM H.1 with the distributions of Table 10.</source>
        <translation>JCGM 101:2008, 9.5절: 표 10의 분포를 쓴 GUM H.1의 엔드 게이지.</translation>
    </message>
    <message>
        <source>Two sums with a common term (GUM Supplement 2, 9.2)</source>
        <translation>공통 항이 있는 두 합 (GUM 보충서 2, 9.2)</translation>
    </message>
    <message>
        <source>JCGM 102:2011, clause 9.2: a bivariate additive model with standard normal quantities.</source>
        <translation>JCGM 102:2011, 9.2절: 표준 정규 양의 이변량 가산 모형.</translation>
    </message>
    <message>
        <source>Cartesian to polar co-ordinates (GUM Supplement 2, 9.3)</source>
        <translation>직교 좌표에서 극좌표로 (GUM 보충서 2, 9.3)</translation>
    </message>
    <message>
        <source>JCGM 102:2011, clause 9.3, Tables 6 and 7: magnitude and phase of a small complex quantity.</source>
        <translation>JCGM 102:2011, 9.3절, 표 6과 7: 작은 복소량의 크기와 위상.</translation>
    </message>
    <message>
        <source>Resistance and reactance by Monte Carlo (GUM Supplement 2, 9.4)</source>
        <translation>몬테카를로에 의한 저항과 리액턴스 (GUM 보충서 2, 9.4)</translation>
    </message>
    <message>
        <source>JCGM 102:2011, clause 9.4: the impedance of GUM H.2 with trivariate normal input quantities and the joint coverage region of R and X.</source>
        <translation>JCGM 102:2011, 9.4절: 삼변량 정규 입력량을 쓴 GUM H.2의 임피던스와 R, X의 공동 포함 영역.</translation>
    </message>
    <message>
        <source>JCGM 100:2008, Annex H.1: a gauge block of 50 mm is compared with a standard; first- and second-order law of propagation.</source>
        <translation>JCGM 100:2008, 부속서 H.1: 50 mm 게이지 블록을 표준기와 비교한다. 1차와 2차 전파 법칙.</translation>
    </message>
    <message>
        <source>JCGM 100:2008, Annex H.2: five simultaneous observations of voltage, current and phase give three correlated results.</source>
        <translation>JCGM 100:2008, 부속서 H.2: 전압, 전류, 위상의 동시 관측 다섯 번이 상관된 세 결과를 준다.</translation>
    </message>
    <message>
        <source>JCGM 100:2008, Annex H.3: the correction b of a thermometer at eleven temperatures, and the straight line through them: b(t) = y₁ + y₂ (t − 20 °C).</source>
        <translation>JCGM 100:2008, 부속서 H.3: 열한 온도에서 온도계의 보정값 b와 그것을 지나는 직선: b(t) = y₁ + y₂ (t − 20 °C).</translation>
    </message>
    <message>
        <source>Which twelve of the 22 points of a ballbar measurement make the uncertainty of the tool centre point smallest.</source>
        <translation>볼바 측정의 22개 점 중 어느 열두 점이 공구 중심점의 불확도를 가장 작게 하는가.</translation>
    </message>
    <message>
        <source>Three telescopic ballbars measure points on spheres and circles; from them follow the flange, its axes and the tool.</source>
        <translation>세 개의 텔레스코픽 볼바가 구와 원 위의 점을 측정하고, 그로부터 플랜지와 축, 공구를 구한다.</translation>
    </message>
    <message>
        <source>Scale bar, two trackers, flange, identified arm and tool: analyses that feed each other, evaluated as one model.</source>
        <translation>기준자, 트래커 두 대, 플랜지, 식별된 암, 공구: 서로 이어지는 분석을 하나의 모형으로 평가한다.</translation>
    </message>
    <message>
        <source>Parameters of an arm of six axes, identified from measured places, and the position of its end effector.</source>
        <translation>측정한 위치로 식별한 6축 암의 매개변수와 말단 장치의 위치.</translation>
    </message>
    <message>
        <source>Rated output, zero, repeatability and interference of three forces and three moments.</source>
        <translation>세 힘과 세 모멘트의 정격 출력, 영점, 반복성, 상호 간섭.</translation>
    </message>
    <message>
        <source>Distances on a scale bar that three cameras and a laser tracker measure together.</source>
        <translation>카메라 세 대와 레이저 트래커 한 대가 함께 측정하는 기준자 위의 거리.</translation>
    </message>
    <message>
        <source>Pose of a platform from six measured points, whose uncertainties come from calibrated artefacts.</source>
        <translation>교정된 기준물에서 나온 불확도를 가진 측정점 여섯 개로 구한 플랫폼의 포즈.</translation>
    </message>
    <message>
        <source>Sensor layout, points and pose in one chain: a laser tracker and a total station measure six nests of a platform.</source>
        <translation>센서 배치, 점, 포즈를 하나의 사슬로: 레이저 트래커와 토털 스테이션이 플랫폼의 네스트 여섯 개를 측정한다.</translation>
    </message>
    <message>
        <source>%1 in line %2</source>
        <translation>%2행의 %1</translation>
    </message>
    <message>
        <source>columns between tabs</source>
        <translation>탭으로 구분된 열</translation>
    </message>
    <message>
        <source>columns between semicolons</source>
        <translation>세미콜론으로 구분된 열</translation>
    </message>
    <message>
        <source>columns between commas</source>
        <translation>쉼표로 구분된 열</translation>
    </message>
    <message>
        <source>columns between blanks, decimal commas</source>
        <translation>공백으로 구분된 열, 소수점 쉼표</translation>
    </message>
    <message>
        <source>columns between blanks</source>
        <translation>공백으로 구분된 열</translation>
    </message>
    <message>
        <source>all %1 met</source>
        <translation>%1개 모두 충족</translation>
    </message>
    <message>
        <source>%1 of %2 not met</source>
        <translation>%2개 중 %1개 미충족</translation>
    </message>
    <message>
        <source>Requirements</source>
        <translation>요구사항</translation>
    </message>
    <message>
        <source>Requirements: %1</source>
        <translation>요구 사항: %1</translation>
    </message>
    <message>
        <source>min Σ w (reading − h(X))²</source>
        <translation>min Σ w (읽음값 − h(X))²</translation>
    </message>
    <message>
        <source>least squares: R maximises tr(Rᵀ Σ (q_i − q̄) l_iᵀ),  o = q̄ − R l̄</source>
        <translation>최소제곱: R은 tr(Rᵀ Σ (q_i − q̄) l_iᵀ)를 최대로 함,  o = q̄ − R l̄</translation>
    </message>
    <message>
        <source>Z = ± √(L₁² − X² − Y²);  no value where the root is negative</source>
        <translation>Z = ± √(L₁² − X² − Y²);  근호 안이 음수이면 값 없음</translation>
    </message>
    <message>
        <source>min Σ w (L_j − |M − KS_j|)², Gauss-Newton from Eqs 1-3</source>
        <translation>min Σ w (L_j − |M − KS_j|)², 식 1-3에서 시작하는 가우스-뉴턴법</translation>
    </message>
    <message>
        <source>L_j = |P_i + e_i + R_i (ω_i × t) − KS_j| + reading&apos;s deviation</source>
        <translation>L_j = |P_i + e_i + R_i (ω_i × t) − KS_j| + 읽음값의 편차</translation>
    </message>
    <message>
        <source>n_x, n_y: planes of the arcs by total least squares;  C: sphere through all points</source>
        <translation>n_x, n_y: 전체 최소제곱에 의한 호의 평면;  C: 모든 점을 지나는 구</translation>
    </message>
    <message>
        <source>TCP = mean of Rot_iᵀ Fᵀ (M_i − C)</source>
        <translation>TCP = Rot_iᵀ Fᵀ (M_i − C)의 평균</translation>
    </message>
    <message>
        <source>JCGM 102 6.2, with all that points and readings share</source>
        <translation>JCGM 102 6.2, 점과 읽음값이 공유하는 모든 것을 포함</translation>
    </message>
    <message>
        <source>n·p = D with |n| = 1, least sum of squares</source>
        <translation>n·p = D, |n| = 1, 제곱합 최소</translation>
    </message>
    <message>
        <source>min Σ (|p_j − c| − R)²  in the fitted plane</source>
        <translation>min Σ (|p_j − c| − R)²  맞춘 평면에서</translation>
    </message>
    <message>
        <source>x_i = ± z_{i−1} × z_i/|…|,  O_i: foot of the common perpendicular on axis i + 1</source>
        <translation>x_i = ± z_{i−1} × z_i/|…|,  O_i: 축 i + 1 위의 공통 수선의 발</translation>
    </message>
    <message>
        <source>parallel: O_i in the plane through O_{i−1} normal to z_{i−1},  y_i = z_i × h/|…|,  x_i = y_i × z_i</source>
        <translation>평행: O_i는 O_{i−1}을 지나고 z_{i−1}에 수직인 평면에 있음,  y_i = z_i × h/|…|,  x_i = y_i × z_i</translation>
    </message>
    <message>
        <source>S_hc = Σ L d_h/Σ L²  over the increasing readings under load c</source>
        <translation>S_hc = Σ L d_h/Σ L²  하중 c에서 증가하는 읽음값에 대해</translation>
    </message>
    <message>
        <source>V = S L,  L = C V  with  C = S⁻¹</source>
        <translation>V = S L,  L = C V,  C = S⁻¹</translation>
    </message>
    <message>
        <source>V_h = Σ_c (S_hc L_c + Q_hc L_c²),  by Newton&apos;s method from L = C V</source>
        <translation>V_h = Σ_c (S_hc L_c + Q_hc L_c²),  L = C V에서 시작하는 뉴턴법</translation>
    </message>
    <message>
        <source>V_h = d_h + repeatability + resolution + non-zero + hysteresis</source>
        <translation>V_h = d_h + 반복성 + 분해능 + 영점 편차 + 히스테리시스</translation>
    </message>
    <message>
        <source>S_hc = fitted + regression + S_hc δ_c</source>
        <translation>S_hc = 맞춘 값 + 회귀 + S_hc δ_c</translation>
    </message>
    <message>
        <source>d_hij = d′_hij − d_h0j,  d_hi = mean over j,  s_hi,  u_A = max s_hi/√n</source>
        <translation>d_hij = d′_hij − d_h0j,  d_hi = j에 대한 평균,  s_hi,  u_A = max s_hi/√n</translation>
    </message>
    <message>
        <source>JCGM 100, Eq 1</source>
        <translation>JCGM 100, 식 1</translation>
    </message>
    <message>
        <source>JCGM 100, Eqs H.24, H.25, for groups of any size</source>
        <translation>JCGM 100, 식 H.24, H.25, 임의 크기의 그룹에 대해</translation>
    </message>
    <message>
        <source>groups included, JCGM 100 H.5.2.3</source>
        <translation>그룹 포함, JCGM 100 H.5.2.3</translation>
    </message>
    <message>
        <source>components of variance, Searle et al. 1992</source>
        <translation>분산 성분, Searle 등 1992</translation>
    </message>
    <message>
        <source>groups not included, JCGM 100, Eq H.28</source>
        <translation>그룹 불포함, JCGM 100, 식 H.28</translation>
    </message>
    <message>
        <source>JCGM 100, Eq H.12</source>
        <translation>JCGM 100, 식 H.12</translation>
    </message>
    <message>
        <source>from the residuals, JCGM 100 H.3.2</source>
        <translation>잔차로부터, JCGM 100 H.3.2</translation>
    </message>
    <message>
        <source>as stated, York et al. 2004</source>
        <translation>명시된 대로, York 등 2004</translation>
    </message>
    <message>
        <source>it must be an analysis of the kept state and have a name (otherName)</source>
        <translation>보관된 상태의 분석이어야 하고 이름(otherName)이 있어야 합니다</translation>
    </message>
    <message>
        <source>Dimensions are checked where the equations are read; plane angle counts as a number, because the radian is one in the SI. A temperature in °C is taken in kelvin only where two make a ratio; a difference of temperatures is given in K.</source>
        <translation>차원은 방정식을 읽는 곳에서 검사합니다. 평면각은 수로 취급합니다. SI에서 라디안은 수이기 때문입니다. °C로 나타낸 온도는 두 온도가 비를 이루는 곳에서만 켈빈으로 취합니다. 온도차는 K로 줍니다.</translation>
    </message>
    <message>
        <source>Angles that inverse functions give or that were read, their sums and whole multiples are on the circle where the result is given in a unit of angle.</source>
        <translation>역함수가 주거나 읽은 각도, 그 합과 정수배는 결과가 각도 단위로 주어질 때 원 위에 있습니다.</translation>
    </message>
    <message>
        <source>One equation a line: y = x_1*x_2 + x_3. Names without an equation are input quantities; a number has its unit in brackets: 3 [mm]. &apos;solve y = 1: y^2 = x&apos; finds y in every trial, from its starting value. complex(a, b) and polar(r, phi) make complex numbers, re, im, abs and arg real ones of them. &apos;#&apos; starts a comment.</source>
        <translation>한 줄에 방정식 하나: y = x_1*x_2 + x_3. 방정식이 없는 이름은 입력량이고, 수의 단위는 대괄호에 씁니다: 3 [mm]. &apos;solve y = 1: y^2 = x&apos;는 시작값에서 출발하여 시행마다 y를 찾습니다. complex(a, b)와 polar(r, phi)는 복소수를 만들고, re, im, abs, arg는 그로부터 실수를 만듭니다. &apos;#&apos;은 주석을 시작합니다.</translation>
    </message>
    <message>
        <source>How its uncertainty is known; a and b are then: u; s and n; U and k; U and p in %; half-width (and inexactness, or ratio of top to base); lower and upper limit; step of the indication; permissible error and % of the value; number of counts; number of observations in the mean (pooled); standard deviation (Laplace, Weibull about the value), scale (and shape); expected number of events; number of trials and probability in %. A sample is drawn as it is listed among the observations, a histogram has the edges of its cells there. Empty: a constant.</source>
        <translation>그 불확도를 어떻게 아는가. a와 b는 다음과 같습니다: u; s와 n; U와 k; U와 %로 나타낸 p; 반폭(과 한계의 부정확함, 또는 윗변과 밑변의 비); 하한과 상한; 지시의 분해능; 최대 허용 오차와 값의 %; 계수; 평균에 든 관측 횟수(합동); 표준편차(라플라스, 값을 평균으로 하는 와이블), 척도(와 형상); 사건의 기대 횟수; 시도 횟수와 %로 나타낸 확률. 표본은 관측값에 적힌 대로 뽑고, 히스토그램의 칸 경계도 거기에 있습니다. 비어 있음: 상수.</translation>
    </message>
    <message>
        <source>Laplace, standard deviation</source>
        <translation>라플라스, 표준편차</translation>
    </message>
    <message>
        <source>Laplace, scale</source>
        <translation>라플라스, 척도</translation>
    </message>
    <message>
        <source>Weibull, scale and shape</source>
        <translation>와이블, 척도와 형상</translation>
    </message>
    <message>
        <source>Weibull, standard deviation</source>
        <translation>와이블, 표준편차</translation>
    </message>
    <message>
        <source>Poisson</source>
        <translation>푸아송</translation>
    </message>
    <message>
        <source>binomial</source>
        <translation>이항</translation>
    </message>
    <message>
        <source>sample of values</source>
        <translation>값의 표본</translation>
    </message>
    <message>
        <source>histogram</source>
        <translation>히스토그램</translation>
    </message>
    <message>
        <source>ensemble</source>
        <translation>앙상블</translation>
    </message>
    <message>
        <source>Name of the evaluation that gave several quantities together, with one and the same nu: their uncertainties rest on one estimate of variance, and they are drawn from a multivariate t distribution (JCGM 102 5.3.2). Correlation coefficients between them stand with the correlations of the analysis.</source>
        <translation>여러 양을 같은 nu로 함께 준 평가의 이름: 그 불확도는 하나의 분산 추정에 근거하며 다변량 t 분포에서 뽑습니다(JCGM 102 5.3.2). 그 사이의 상관계수는 분석의 상관과 함께 있습니다.</translation>
    </message>
    <message>
        <source>Observed value, value of a sample or edge of a histogram, in the unit of the quantity.</source>
        <translation>관측값, 표본의 값 또는 히스토그램의 경계, 그 양의 단위로.</translation>
    </message>
    <message>
        <source>weight</source>
        <translation>가중치</translation>
    </message>
    <message>
        <source>Of a value of a sample, or of the cell of a histogram that begins at this edge: counts, or parts of any sum. Empty: one in a sample, none behind the last edge.</source>
        <translation>표본의 한 값, 또는 이 경계에서 시작하는 히스토그램 칸의 가중치: 횟수, 또는 임의의 합의 부분. 비어 있음: 표본에서는 1, 마지막 경계 뒤에는 없음.</translation>
    </message>
    <message>
        <source>Covariance of the points</source>
        <translation>점들의 공분산</translation>
    </message>
    <message>
        <source>Common u of x</source>
        <translation>x의 공통 u</translation>
    </message>
    <message>
        <source>Standard uncertainty of a deviation that all x share beside their own (one standard, one temperature), in the unit of x. Used with stated uncertainties, in the weights too.</source>
        <translation>모든 x가 자기 편차 외에 함께 갖는 편차(하나의 표준기, 하나의 온도)의 표준불확도, x의 단위로. 명시된 불확도와 함께, 가중치에도 쓰입니다.</translation>
    </message>
    <message>
        <source>Common u of y</source>
        <translation>y의 공통 u</translation>
    </message>
    <message>
        <source>Likewise of all y, in the unit of y.</source>
        <translation>모든 y에 대해서도 같음, y의 단위로.</translation>
    </message>
    <message>
        <source>Correlations of the points</source>
        <translation>점들의 상관</translation>
    </message>
    <message>
        <source>Correlation coefficients between coordinates of the points (ISO/TS 28037): they change the curve, which minimises v^T V^-1 v, and its uncertainty. Used with stated uncertainties.</source>
        <translation>점 좌표 사이의 상관계수(ISO/TS 28037): v^T V^-1 v를 최소로 하는 곡선과 그 불확도를 바꿉니다. 명시된 불확도와 함께 쓰입니다.</translation>
    </message>
    <message>
        <source>A coordinate of a point by its number: y_1 is the y of the first point.</source>
        <translation>번호로 나타낸 점의 좌표: y_1은 첫째 점의 y입니다.</translation>
    </message>
    <message>
        <source>Another one: y_2, or the x_1 of the same point.</source>
        <translation>다른 좌표: y_2, 또는 같은 점의 x_1.</translation>
    </message>
    <message>
        <source>coefficient</source>
        <translation>계수</translation>
    </message>
    <message>
        <source>Correlation coefficient of their stated uncertainties.</source>
        <translation>명시된 불확도의 상관계수.</translation>
    </message>
    <message>
        <source>Certificate of a gauge block of 50 mm</source>
        <translation>50 mm 게이지 블록의 성적서</translation>
    </message>
    <message>
        <source>A gauge block is compared with a standard of the same length, by the model of EA-4/02, S4; its certificate says all that ISO/IEC 17025 7.8 asks for.</source>
        <translation>게이지 블록을 같은 길이의 표준기와 EA-4/02 S4의 모델로 비교합니다. 성적서는 ISO/IEC 17025 7.8이 요구하는 모든 것을 담습니다.</translation>
    </message>
    <message>
        <source>Conformity of a micrometer</source>
        <translation>마이크로미터의 적합성</translation>
    </message>
    <message>
        <source>Errors of indication of a micrometer of 25 mm at four gauge blocks, and whether they conform with a maximum permissible error of 4 µm under the decision rule of ISO 14253-1.</source>
        <translation>게이지 블록 네 개에서 25 mm 마이크로미터의 지시 오차와, ISO 14253-1의 판정 규칙에 따라 최대 허용 오차 4 µm에 적합한지.</translation>
    </message>
    <message>
        <source>A budget from Excel</source>
        <translation>Excel의 예산</translation>
    </message>
    <message>
        <source>What &apos;covaria import excel-budget.xlsx&apos; makes of a budget in a spreadsheet, with the columns of EA-4/02.</source>
        <translation>&apos;covaria import excel-budget.xlsx&apos;가 EA-4/02의 열을 가진 스프레드시트 예산으로 만드는 것.</translation>
    </message>
    <message>
        <source>Gewichtsstück von 10 kg</source>
        <translation>10 kg 분동</translation>
    </message>
    <message>
        <source>Kalibrierung eines Gewichtsstücks nach EA-4/02, S2: ein Beispiel in deutscher Sprache, mit vollständigem Kalibrierschein.</source>
        <translation>EA-4/02 S2에 따른 분동 교정: 완전한 교정성적서가 있는 독일어 예제.</translation>
    </message>
    <message>
        <source>Guard band</source>
        <translation>보호 대역</translation>
    </message>
    <message>
        <source>How the guard band follows: by the guard factor, by the ratio TUR of tolerance and U (both limits are needed), or so narrow as a target risk allows (global risks need a prior).</source>
        <translation>보호 대역이 어떻게 정해지는가: 보호 계수로, 공차와 U의 비 TUR로(두 한계가 필요), 또는 목표 위험이 허용하는 만큼 좁게(전체 위험에는 사전 지식이 필요).</translation>
    </message>
    <message>
        <source>Target risk</source>
        <translation>목표 위험</translation>
    </message>
    <message>
        <source>That the guard band is made for, above 0 and up to 0.5: 0.02 or 2 %.</source>
        <translation>보호 대역이 목표로 하는 위험, 0보다 크고 0.5 이하: 0.02 또는 2 %.</translation>
    </message>
    <message>
        <source>guard factor times U</source>
        <translation>보호 계수 곱하기 U</translation>
    </message>
    <message>
        <source>RSS: root of T²/4 − U²</source>
        <translation>RSS: T²/4 − U²의 제곱근</translation>
    </message>
    <message>
        <source>NCSL RP-10: 1.25 − 1/TUR</source>
        <translation>NCSL RP-10: 1.25 − 1/TUR</translation>
    </message>
    <message>
        <source>managed (Dobbert): at most 2 % false accepts</source>
        <translation>관리형(Dobbert): 잘못된 수락 2 % 이하</translation>
    </message>
    <message>
        <source>to a specific risk at the acceptance limit</source>
        <translation>수락 한계에서의 특정 위험으로</translation>
    </message>
    <message>
        <source>to a global consumer&apos;s risk</source>
        <translation>전체 소비자 위험으로</translation>
    </message>
    <message>
        <source>to a risk of what is accepted</source>
        <translation>수락된 것의 위험으로</translation>
    </message>
    <message>
        <source>Site of calibration</source>
        <translation>교정 장소</translation>
    </message>
    <message>
        <source>Whose place it was done at; empty: in the laboratory, or elsewhere where a place is stated.</source>
        <translation>누구의 장소에서 했는가. 비어 있음: 시험실에서, 또는 장소가 적혀 있으면 다른 곳에서.</translation>
    </message>
    <message>
        <source>Where it was done if not in the laboratory: the customer&apos;s hall, the field.</source>
        <translation>시험실이 아니면 어디에서 했는가: 고객의 작업장, 현장.</translation>
    </message>
    <message>
        <source>To which a statement of conformity refers: the standard or drawing, with its edition.</source>
        <translation>적합성 진술이 근거하는 표준 또는 도면과 그 판.</translation>
    </message>
    <message>
        <source>at the customer</source>
        <translation>고객의 장소에서</translation>
    </message>
    <message>
        <source>in a branch of the laboratory</source>
        <translation>시험실의 지점에서</translation>
    </message>
    <message>
        <source>in a branch of the customer</source>
        <translation>고객의 지점에서</translation>
    </message>
    <message>
        <source>elsewhere</source>
        <translation>다른 곳</translation>
    </message>
    <message>
        <source>RSS guard band</source>
        <translation>RSS 보호 대역</translation>
    </message>
    <message>
        <source>NCSL RP-10 guard band</source>
        <translation>NCSL RP-10 보호 대역</translation>
    </message>
    <message>
        <source>managed guard band (Dobbert, 2 % false accepts)</source>
        <translation>관리형 보호 대역(Dobbert, 잘못된 수락 2 %)</translation>
    </message>
    <message>
        <source>guard band to a specific risk of %1</source>
        <translation>특정 위험 %1의 보호 대역</translation>
    </message>
    <message>
        <source>guard band to a global consumer&apos;s risk of %1</source>
        <translation>전체 소비자 위험 %1의 보호 대역</translation>
    </message>
    <message>
        <source>guard band to a risk of %1 of what is accepted</source>
        <translation>수락된 것의 위험 %1의 보호 대역</translation>
    </message>
    <message>
        <source>pass (accepted)</source>
        <translation>합격(수락)</translation>
    </message>
    <message>
        <source>fail (rejected)</source>
        <translation>불합격(거부)</translation>
    </message>
    <message>
        <source>January</source>
        <translation>1월</translation>
    </message>
    <message>
        <source>February</source>
        <translation>2월</translation>
    </message>
    <message>
        <source>March</source>
        <translation>3월</translation>
    </message>
    <message>
        <source>April</source>
        <translation>4월</translation>
    </message>
    <message>
        <source>May</source>
        <translation>5월</translation>
    </message>
    <message>
        <source>June</source>
        <translation>6월</translation>
    </message>
    <message>
        <source>July</source>
        <translation>7월</translation>
    </message>
    <message>
        <source>August</source>
        <translation>8월</translation>
    </message>
    <message>
        <source>September</source>
        <translation>9월</translation>
    </message>
    <message>
        <source>October</source>
        <translation>10월</translation>
    </message>
    <message>
        <source>November</source>
        <translation>11월</translation>
    </message>
    <message>
        <source>December</source>
        <translation>12월</translation>
    </message>
    <message>
        <source>%1 %2 %3</source>
        <translation>%3년 %2 %1일</translation>
    </message>
    <message>
        <source>required by %1 where conformity is stated</source>
        <translation>적합성을 진술하는 경우 %1이(가) 요구함</translation>
    </message>
    <message>
        <source>%1 is the unit of a temperature, and the quantity is given in %2, in which it may be a difference: give both in %1, or both in %2</source>
        <translation>%1은(는) 온도의 단위이고, 이 양은 온도차일 수 있는 %2로 주어졌습니다: 둘 다 %1로, 또는 둘 다 %2로 주십시오</translation>
    </message>
    <message>
        <source>%1 is a difference of temperatures, and %2 a temperature in %3: take a temperature, or give %2 in K</source>
        <translation>%1은(는) 온도차이고 %2은(는) %3로 나타낸 온도입니다: 온도를 취하거나 %2을(를) K로 주십시오</translation>
    </message>
    <message>
        <source>%1 is given in %2, which may be a difference of temperatures, and %3 is a temperature in %4: give both in %4, or both in K</source>
        <translation>%1은(는) 온도차일 수 있는 %2로 주어졌고 %3은(는) %4로 나타낸 온도입니다: 둘 다 %4로, 또는 둘 다 K로 주십시오</translation>
    </message>
    <message>
        <source>%1 is a temperature in %2, and %3 is given in %4, which may be a difference of temperatures: give both in %2, or both in K</source>
        <translation>%1은(는) %2로 나타낸 온도이고 %3은(는) 온도차일 수 있는 %4로 주어졌습니다: 둘 다 %2로, 또는 둘 다 K로 주십시오</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is complex, so that &apos;%2&apos; is a part of it: to use a part write re(%1) or im(%1), else choose another name</source>
        <translation>&apos;%1&apos;은(는) 복소수이므로 &apos;%2&apos;은(는) 그 일부입니다: 일부를 쓰려면 re(%1) 또는 im(%1)로 쓰고, 아니면 다른 이름을 고르십시오</translation>
    </message>
    <message>
        <source>a complex unknown counts twice, and so does a complex equation: there are %1 real unknowns and %2 real equations</source>
        <translation>복소 미지수는 둘로 세고 복소 방정식도 그렇습니다: 실수 미지수 %1개와 실수 방정식 %2개가 있습니다</translation>
    </message>
    <message>
        <source>modulus and argument</source>
        <translation>크기와 편각</translation>
    </message>
    <message>
        <source>real and imaginary part</source>
        <translation>실수부와 허수부</translation>
    </message>
    <message>
        <source>%1 of a complex number are real; one of them is complex here</source>
        <translation>복소수의 %1은(는) 실수입니다. 여기서는 하나가 복소수입니다</translation>
    </message>
    <message>
        <source>complex numbers have no order and are no condition: compare re, im, abs or arg of them</source>
        <translation>복소수에는 순서가 없고 조건이 될 수 없습니다: 그 re, im, abs 또는 arg를 비교하십시오</translation>
    </message>
    <message>
        <source>this function is one of real numbers; for a complex one there are + - * / ^, exp, log, sqrt, sin, cos, tan, sinh, cosh, tanh, conj, abs, arg, re and im</source>
        <translation>이 함수는 실수의 함수입니다. 복소수에는 + - * / ^, exp, log, sqrt, sin, cos, tan, sinh, cosh, tanh, conj, abs, arg, re, im이 있습니다</translation>
    </message>
    <message>
        <source>%1 unknowns are too many to be solved together: the time for each trial grows with the cube of their number, so the limit is %2; solve what does not depend on the rest in systems of its own</source>
        <translation>미지수 %1개는 함께 풀기에 너무 많습니다: 시행마다 시간이 그 수의 세제곱으로 늘어나므로 한계는 %2입니다. 나머지에 의존하지 않는 것은 따로 푸십시오</translation>
    </message>
    <message>
        <source>the expected number of events gives the estimate: leave the value empty, or the number</source>
        <translation>사건의 기대 횟수가 추정값을 줍니다: 값 또는 그 수를 비워 두십시오</translation>
    </message>
    <message>
        <source>the expected number of events is missing: state it, or the value</source>
        <translation>사건의 기대 횟수가 없습니다: 그것이나 값을 주십시오</translation>
    </message>
    <message>
        <source>trials and probability give the estimate: leave the value empty, or the probability</source>
        <translation>시도 횟수와 확률이 추정값을 줍니다: 값 또는 확률을 비워 두십시오</translation>
    </message>
    <message>
        <source>the probability of each trial is missing: state it, or the value</source>
        <translation>각 시도의 확률이 없습니다: 그것이나 값을 주십시오</translation>
    </message>
    <message>
        <source>the number of trials must be at least one</source>
        <translation>시도 횟수는 적어도 하나여야 합니다</translation>
    </message>
    <message>
        <source>the probability of each trial must lie between 0 and 100 %</source>
        <translation>각 시도의 확률은 0과 100 % 사이여야 합니다</translation>
    </message>
    <message>
        <source>the value must lie between 0 and the number of trials</source>
        <translation>값은 0과 시도 횟수 사이여야 합니다</translation>
    </message>
    <message>
        <source>scale and shape give the estimate: leave the value empty, or state the standard deviation alone</source>
        <translation>척도와 형상이 추정값을 줍니다: 값을 비우거나 표준편차만 주십시오</translation>
    </message>
    <message>
        <source>a Weibull distribution needs a value greater than zero, which is its mean</source>
        <translation>와이블 분포에는 평균이 되는 0보다 큰 값이 필요합니다</translation>
    </message>
    <message>
        <source>no Weibull distribution has such a ratio of standard deviation to mean: it must lie between 0.000002 and 429</source>
        <translation>어떤 와이블 분포도 표준편차와 평균의 이런 비를 갖지 않습니다: 0.000002와 429 사이여야 합니다</translation>
    </message>
    <message>
        <source>observations have no weights: for values with weights write sample 1; 2; 3 weights 2; 5; 2</source>
        <translation>관측값에는 가중치가 없습니다: 가중치가 있는 값은 sample 1; 2; 3 weights 2; 5; 2로 쓰십시오</translation>
    </message>
    <message>
        <source>weights have no unit</source>
        <translation>가중치에는 단위가 없습니다</translation>
    </message>
    <message>
        <source>a histogram has one edge more than weights: histogram 0; 1; 2 weights 5; 8</source>
        <translation>히스토그램의 경계는 가중치보다 하나 많습니다: histogram 0; 1; 2 weights 5; 8</translation>
    </message>
    <message>
        <source>there must be as many weights as values</source>
        <translation>가중치는 값만큼 있어야 합니다</translation>
    </message>
    <message>
        <source>the weights of the cells are missing: histogram 0; 1; 2 weights 5; 8</source>
        <translation>칸의 가중치가 없습니다: histogram 0; 1; 2 weights 5; 8</translation>
    </message>
    <message>
        <source>write the probability as p = 0.02 or p = 2 %</source>
        <translation>확률은 p = 0.02 또는 p = 2 %로 쓰십시오</translation>
    </message>
    <message>
        <source>location</source>
        <translation>위치</translation>
    </message>
    <message>
        <source>the shape must lie between 0.1 and 1000000.</source>
        <translation>형상은 0.1과 1000000 사이여야 합니다.</translation>
    </message>
    <message>
        <source>value without an event</source>
        <translation>사건이 없을 때의 값</translation>
    </message>
    <message>
        <source>the expected number of events must lie between 0 and 10000000; beyond it a normal distribution says the same.</source>
        <translation>사건의 기대 횟수는 0과 10000000 사이여야 합니다. 그 이상에서는 정규분포가 같은 것을 말합니다.</translation>
    </message>
    <message>
        <source>the number of trials must be a whole number up to 10000000; beyond it a normal distribution says the same.</source>
        <translation>시도 횟수는 10000000까지의 정수여야 합니다. 그 이상에서는 정규분포가 같은 것을 말합니다.</translation>
    </message>
    <message>
        <source>the probability must lie between 0 and 1.</source>
        <translation>확률은 0과 1 사이여야 합니다.</translation>
    </message>
    <message>
        <source>a histogram needs at least one cell.</source>
        <translation>히스토그램에는 적어도 한 칸이 필요합니다.</translation>
    </message>
    <message>
        <source>there must be one edge more than probabilities.</source>
        <translation>경계는 확률보다 하나 많아야 합니다.</translation>
    </message>
    <message>
        <source>edges</source>
        <translation>경계</translation>
    </message>
    <message>
        <source>the edges must rise.</source>
        <translation>경계는 커져야 합니다.</translation>
    </message>
    <message>
        <source>histogram: there must be one edge more than probabilities.</source>
        <translation>히스토그램: 경계는 확률보다 하나 많아야 합니다.</translation>
    </message>
    <message>
        <source>the measurement model has a kink at the estimates, or bends too sharply there for derivatives of second and third order</source>
        <translation>측정 모델이 추정값에서 꺾이거나, 이차와 삼차 도함수를 구하기에는 너무 심하게 휩니다</translation>
    </message>
    <message>
        <source>the measurement model has no value there</source>
        <translation>측정 모델이 그곳에서 값을 갖지 않습니다</translation>
    </message>
    <message>
        <source>its sensitivity coefficients are zero, or there are none</source>
        <translation>감도계수가 0이거나 없습니다</translation>
    </message>
    <message>
        <source>Monte Carlo answers alone for %1: the measurement model has no sensitivity coefficients at the estimates of its input quantities.</source>
        <translation>%1은(는) 몬테카를로만 답합니다: 측정 모델이 입력량의 추정값에서 감도계수를 갖지 않습니다.</translation>
    </message>
    <message>
        <source>%1 has a kink at the estimates of the input quantities (an absolute value, a maximum, a condition): the law of propagation takes the sensitivity coefficients of one side. Use Monte Carlo.</source>
        <translation>%1은(는) 입력량의 추정값에서 꺾입니다(절댓값, 최댓값, 조건): 전파 법칙은 한쪽의 감도계수를 취합니다. 몬테카를로를 쓰십시오.</translation>
    </message>
    <message>
        <source>Monte Carlo answers alone for %1, which has a kink at the estimates of the input quantities (an absolute value, a maximum, a condition): the law of propagation would take the sensitivity coefficients of one side.</source>
        <translation>%1은(는) 몬테카를로만 답합니다. 입력량의 추정값에서 꺾이기 때문입니다(절댓값, 최댓값, 조건): 전파 법칙은 한쪽의 감도계수를 취하게 됩니다.</translation>
    </message>
    <message>
        <source>There is no standard uncertainty with second-order terms of %1: they would make its variance negative, so terms of higher order matter as much. Use Monte Carlo.</source>
        <translation>%1에는 이차항을 포함한 표준불확도가 없습니다: 분산이 음수가 되므로 더 높은 차수의 항도 그만큼 중요합니다. 몬테카를로를 쓰십시오.</translation>
    </message>
    <message>
        <source>%1 trials are few for a coverage interval of %2 %: some %3 lie beyond each of its ends, so that U is not known well. JCGM 101 7.2.2 asks for some %4 trials.</source>
        <translation>%2 %의 포함구간에는 %1회 시행이 적습니다: 양 끝 너머에 약 %3회씩 있으므로 U를 잘 알 수 없습니다. JCGM 101 7.2.2는 약 %4회 시행을 요구합니다.</translation>
    </message>
    <message>
        <source>the measurement model has no sensitivity coefficients at the estimates of its input quantities%1: it is not differentiable there (singular geometry); Monte Carlo needs none</source>
        <translation>측정 모델이 입력량의 추정값에서 감도계수를 갖지 않습니다%1: 그곳에서 미분할 수 없습니다(특이 기하). 몬테카를로에는 필요하지 않습니다</translation>
    </message>
    <message>
        <source>the readings find target %1 %2 mm from its nominal coordinates; look for exchanged names or a unit that was mixed up (the result does not depend on the nominal coordinates)</source>
        <translation>읽음값은 표적 %1을(를) 공칭 좌표에서 %2 mm 떨어진 곳에서 찾습니다. 뒤바뀐 이름이나 혼동된 단위를 찾아보십시오(결과는 공칭 좌표에 의존하지 않습니다)</translation>
    </message>
    <message>
        <source>the readings find %1 further targets far from their nominal coordinates</source>
        <translation>읽음값은 그 밖에 %1개 표적을 공칭 좌표에서 먼 곳에서 찾습니다</translation>
    </message>
    <message>
        <source>observations have degrees of freedom of their own; those made together have the same numbers in the table of observations</source>
        <translation>관측값은 자기 자유도를 갖습니다. 함께 한 관측은 관측 표에서 같은 번호를 갖습니다</translation>
    </message>
    <message>
        <source>the members of an ensemble have a standard or expanded uncertainty with finite nu</source>
        <translation>앙상블의 구성원은 유한한 nu의 표준 또는 확장불확도를 갖습니다</translation>
    </message>
    <message>
        <source>the members of ensemble &apos;%1&apos; have one and the same nu; it is %2 in the first, %3 here</source>
        <translation>앙상블 &apos;%1&apos;의 구성원은 같은 nu를 갖습니다. 첫째는 %2, 여기는 %3입니다</translation>
    </message>
    <message>
        <source>the sample gives the estimate: leave the value empty</source>
        <translation>표본이 추정값을 줍니다: 값을 비워 두십시오</translation>
    </message>
    <message>
        <source>the weight of a cell of its histogram is missing</source>
        <translation>히스토그램 한 칸의 가중치가 없습니다</translation>
    </message>
    <message>
        <source>a histogram has the weight of each cell beside the edge where it begins, and none beside the last edge</source>
        <translation>히스토그램은 각 칸이 시작하는 경계 옆에 그 가중치를 두고, 마지막 경계 옆에는 두지 않습니다</translation>
    </message>
    <message>
        <source>some values of its sample have a weight and some have none</source>
        <translation>표본의 일부 값에는 가중치가 있고 일부에는 없습니다</translation>
    </message>
    <message>
        <source>its weights must have a sum above zero</source>
        <translation>가중치의 합은 0보다 커야 합니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is complex: list its parts %2 and %3, or define abs(%1) and arg(%1) and list these</source>
        <translation>&apos;%1&apos;은(는) 복소수입니다: 그 부분 %2와(과) %3을(를) 나열하거나, abs(%1)과 arg(%1)을 정의하여 나열하십시오</translation>
    </message>
    <message>
        <source>a difference: %1</source>
        <translation>온도차: %1</translation>
    </message>
    <message>
        <source>as stated with correlations, ISO/TS 28037, 10</source>
        <translation>명시된 대로 상관 포함, ISO/TS 28037, 10</translation>
    </message>
    <message>
        <source>common deviation of all %1</source>
        <translation>모든 %1의 공통 편차</translation>
    </message>
    <message>
        <source>stated for all points</source>
        <translation>모든 점에 대해 명시됨</translation>
    </message>
    <message>
        <source>a common deviation is one of stated uncertainties: choose these, or leave it 0</source>
        <translation>공통 편차는 명시된 불확도의 것입니다: 그것을 고르거나 0으로 두십시오</translation>
    </message>
    <message>
        <source>correlations are those of stated uncertainties: choose these, or leave out the correlations</source>
        <translation>상관은 명시된 불확도의 것입니다: 그것을 고르거나 상관을 빼십시오</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no coordinate of a point: write y_1 for the y of the first one</source>
        <translation>&apos;%1&apos;은(는) 점의 좌표가 아닙니다: 첫째 점의 y는 y_1로 쓰십시오</translation>
    </message>
    <message>
        <source>%1 has no standard uncertainty of its own that could be correlated</source>
        <translation>%1에는 상관될 수 있는 자기 표준불확도가 없습니다</translation>
    </message>
    <message>
        <source>a coordinate is not correlated with itself</source>
        <translation>좌표는 자기 자신과 상관되지 않습니다</translation>
    </message>
    <message>
        <source>the CSV file &apos;%1&apos; of %2 is a link that leads out of the project&apos;s folder: put the file itself there</source>
        <translation>%2의 CSV 파일 &apos;%1&apos;은(는) 프로젝트 폴더 밖으로 나가는 링크입니다: 파일 자체를 그곳에 두십시오</translation>
    </message>
    <message>
        <source>the guard band of %1 follows from the ratio of tolerance and U: give both limits, or choose a guard factor</source>
        <translation>%1의 보호 대역은 공차와 U의 비에서 나옵니다: 두 한계를 주거나 보호 계수를 고르십시오</translation>
    </message>
    <message>
        <source>the guard band of %1 is made for a global risk: give the prior, or choose a specific risk</source>
        <translation>%1의 보호 대역은 전체 위험을 위한 것입니다: 사전 지식을 주거나 특정 위험을 고르십시오</translation>
    </message>
    <message>
        <source>the guard band of %1 needs a tolerance: give a limit</source>
        <translation>%1의 보호 대역에는 공차가 필요합니다: 한계를 주십시오</translation>
    </message>
    <message>
        <source>the target risk of %1 must lie above 0 and not above 0.5</source>
        <translation>%1의 목표 위험은 0보다 크고 0.5 이하여야 합니다</translation>
    </message>
    <message>
        <source>another study has the same id</source>
        <translation>다른 연구가 같은 식별자를 갖습니다</translation>
    </message>
    <message>
        <source>its id must be made of letters, digits, &apos;-&apos; and &apos;_&apos;</source>
        <translation>식별자는 글자, 숫자, &apos;-&apos;와 &apos;_&apos;로 되어야 합니다</translation>
    </message>
    <message>
        <source>there is no asset %1, and no analysis of this name that this one takes from%2</source>
        <translation>대상 %1이(가) 없고, 이 분석이 값을 취하는 그 이름의 분석도 없습니다%2</translation>
    </message>
    <message>
        <source> (did you mean %1?)</source>
        <translation> (%1입니까?)</translation>
    </message>
    <message>
        <source>a number here is larger than any that can be computed with (1.8e308)</source>
        <translation>여기의 수는 계산할 수 있는 어떤 수보다 큽니다(1.8e308)</translation>
    </message>
    <message>
        <source>the value or its place is no text in UTF-8</source>
        <translation>값이나 그 위치가 UTF-8 글이 아닙니다</translation>
    </message>
    <message>
        <source>more than %1 analyses feed each other in a row: put the equations of some of them into one</source>
        <translation>%1개가 넘는 분석이 줄지어 서로 값을 줍니다: 그 일부의 방정식을 하나로 합치십시오</translation>
    </message>
    <message>
        <source>%1 is a link that leads out of the project&apos;s folder: put the picture itself there</source>
        <translation>%1은(는) 프로젝트 폴더 밖으로 나가는 링크입니다: 그림 자체를 그곳에 두십시오</translation>
    </message>
    <message>
        <source>%1; in this file write %2</source>
        <translation>%1; 이 파일에서는 %2로 쓰십시오</translation>
    </message>
    <message>
        <source>there is no asset %1%2</source>
        <translation>대상 %1이(가) 없습니다%2</translation>
    </message>
    <message>
        <source>the file of candidates &apos;%1&apos; is a link that leads out of the project&apos;s folder: put the file itself there</source>
        <translation>후보 파일 &apos;%1&apos;은(는) 프로젝트 폴더 밖으로 나가는 링크입니다: 파일 자체를 그곳에 두십시오</translation>
    </message>
    <message>
        <source>another design has the same id</source>
        <translation>다른 설계가 같은 식별자를 갖습니다</translation>
    </message>
    <message>
        <source>row %1 was left out</source>
        <translation>%1행을 뺐습니다</translation>
    </message>
    <message>
        <source>row %1: %2 in %3 beside a sensitivity coefficient is taken as a difference or reading, in %4</source>
        <translation>%1행: 감도계수 옆 %3의 %2은(는) 차이 또는 읽음값으로, %4로 취합니다</translation>
    </message>
    <message>
        <source>the result is not the sum of c x: %1 = %2 is the difference</source>
        <translation>결과가 c x의 합이 아닙니다: %1 = %2가 그 차이입니다</translation>
    </message>
    <message>
        <source>the sheet %1 has no row %2 to leave out</source>
        <translation>시트 %1에는 뺄 %2행이 없습니다</translation>
    </message>
    <message>
        <source>%1 is no place of a cell; D3 is one</source>
        <translation>%1은(는) 칸의 위치가 아닙니다. D3은 위치입니다</translation>
    </message>
    <message>
        <source>point %1 with other coordinates: those of line %2 are taken</source>
        <translation>다른 좌표를 가진 점 %1: %2행의 좌표를 취합니다</translation>
    </message>
    <message>
        <source>%1 determinations of the same points (&lt;coordinates&gt; of lines %2): each is an artefact of its own; keep all of them, or delete those that you do not want</source>
        <translation>같은 점들의 결정 %1회(%2행의 &lt;coordinates&gt;): 각각 별도의 기준물입니다. 모두 두거나 원하지 않는 것을 지우십시오</translation>
    </message>
    <message>
        <source>%1 is no number: write %2, with a point</source>
        <translation>%1은(는) 수가 아닙니다: 소수점을 써서 %2로 쓰십시오</translation>
    </message>
    <message>
        <source>the name of the result %1 of %2</source>
        <translation>%2의 결과 %1의 이름</translation>
    </message>
    <message>
        <source>the names of the results %1 of %2</source>
        <translation>%2의 결과 %1의 이름들</translation>
    </message>
    <message>
        <source>the certificate calls it by its symbol alone: %1 must be stated (ISO/IEC 17025 %2)</source>
        <translation>성적서가 기호로만 부릅니다: %1을(를) 명시해야 합니다(ISO/IEC 17025 %2)</translation>
    </message>
    <message>
        <source>under an accreditation U is stated for a coverage probability of about 95 % (ILAC-P14 5.3); here it is %1</source>
        <translation>인정 범위에서 U는 약 95 %의 포함확률로 명시합니다(ILAC-P14 5.3). 여기서는 %1입니다</translation>
    </message>
    <message>
        <source>%1: the file states %2, this budget gives %3, %4 apart</source>
        <translation>%1: 파일은 %2, 이 예산은 %3을(를) 주며 %4만큼 다릅니다</translation>
    </message>
    <message>
        <source>%1: FIND OUT WHY before it is used</source>
        <translation>%1: 쓰기 전에 이유를 찾으십시오</translation>
    </message>
    <message>
        <source>u(%1) by its contributions</source>
        <translation>기여로 구한 u(%1)</translation>
    </message>
    <message>
        <source>%1: the file states no result that this budget could be held against</source>
        <translation>%1: 파일은 이 예산과 견줄 결과를 명시하지 않습니다</translation>
    </message>
    <message>
        <source>another one has the same id</source>
        <translation>다른 것이 같은 식별자를 갖습니다</translation>
    </message>
    <message>
        <source>%1: of what the rule accepts %2 does not conform, of what it rejects %3 does.</source>
        <translation>%1: 규칙이 수락하는 것 중 %2은(는) 부적합하고, 거부하는 것 중 %3은(는) 적합합니다.</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>차례</translation>
    </message>
    <message>
        <source>%1 further components of %2 other sources</source>
        <translation>다른 %2개 출처의 나머지 성분 %1개</translation>
    </message>
    <message>
        <source>other sources</source>
        <translation>다른 출처</translation>
    </message>
    <message>
        <source>1 further component: %1</source>
        <translation>나머지 성분 1개: %1</translation>
    </message>
    <message>
        <source>%1 further components: %2</source>
        <translation>나머지 성분 %1개: %2</translation>
    </message>
    <message>
        <source>Left out: %1 components that contribute nothing (less than 10⁻⁹ of u_c).</source>
        <translation>뺀 것: 기여하지 않는 성분 %1개(u_c의 10⁻⁹ 미만).</translation>
    </message>
    <message>
        <source>Left out, because they contribute nothing (less than 10⁻⁹ of u_c): %1.</source>
        <translation>기여하지 않아(u_c의 10⁻⁹ 미만) 뺀 것: %1.</translation>
    </message>
    <message>
        <source>Stated in the results: %1 = %2 (propagation of distributions).</source>
        <translation>결과에 명시된 값: %1 = %2 (분포의 전파).</translation>
    </message>
    <message>
        <source>%1: under an accreditation U is stated for a coverage probability of about 95 % (ILAC-P14 5.3); with k = %2 that of %3 is %4</source>
        <translation>%1: 인정 범위에서 U는 약 95 %의 포함확률로 명시합니다(ILAC-P14 5.3). k = %2이면 %3의 포함확률은 %4입니다</translation>
    </message>
    <message>
        <source>not drawn, for it is farther away than 10¹² km: %1</source>
        <translation>10¹² km보다 멀어 그리지 않음: %1</translation>
    </message>
    <message>
        <source>Laplace</source>
        <translation>라플라스</translation>
    </message>
    <message>
        <source>Weibull</source>
        <translation>와이블</translation>
    </message>
    <message>
        <source>expected number of events</source>
        <translation>사건의 기대 횟수</translation>
    </message>
    <message>
        <source>step of one event</source>
        <translation>한 사건의 간격</translation>
    </message>
    <message>
        <source>probability</source>
        <translation>확률</translation>
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
        <translation>75 nm: 표준불확도
2 ppm: 표준불확도, 값의 일부. 양 자체가 비이면 절대값
U = 0.3 um, k = 2 (또는 p = 95 %): 성적서
s = 13 nm, n = 5: 이미 알려진 표준편차, 관측 n회의 평균(A형)
rectangular 0.5 (또는 rect, ±): 값을 중심으로 한 한계. triangular, arcsine도 같음
limits 19.5 to 20.5: 값을 줍니다
10.1; 10.3; 10.2: 관측값
resolution 0.01, MPE 3 + 0.1 %, counts 12, constant
Laplace 0.3, Weibull 0.3 (표준편차), Weibull scale 2, shape 1.5
Poisson 12, binomial n = 50, p = 2 %: 값을 줍니다
sample 1; 2; 3 weights 2; 5; 2 (그대로 뽑음), histogram 0; 1; 2 weights 5; 8 (경계)
이 중 어느 것이든 뒤의 nu 18: 자유도</translation>
    </message>
    <message>
        <source>sample</source>
        <translation>표본</translation>
    </message>
    <message>
        <source>weights</source>
        <translation>가중치</translation>
    </message>
    <message>
        <source>Network adjustment</source>
        <translation>망 조정</translation>
    </message>
    <message>
        <source>Coordinates of stations and targets from the distances, directions, angles and height differences that were read between them: heights, plane or space, free or held by known points, with the reliability of each reading.</source>
        <translation>스테이션과 표적 사이에서 읽은 거리, 방향, 각, 높이차에서 구한 그 좌표: 높이, 평면 또는 공간. 자유망이거나 기지점으로 고정하며, 각 읽음값의 신뢰도를 함께 줍니다.</translation>
    </message>
    <message>
        <source>Uncertainties follow from those that were stated for the readings; they are not multiplied by s_0, which is a test of them.</source>
        <translation>불확도는 읽음값에 제시된 불확도에서 나옵니다. s_0을 곱하지 않으며, s_0은 그 불확도에 대한 검정입니다.</translation>
    </message>
    <message>
        <source>In a free network what no reading tells is taken from the approximate coordinates of the points of the datum: the sum of squares of their changes is least. Residuals, s_0 and redundancies do not depend on the datum.</source>
        <translation>자유망에서는 어떤 읽음값도 알려 주지 않는 것을 데이텀에 속한 점의 근사 좌표에서 취합니다. 그 변화량의 제곱합이 최소가 됩니다. 잔차, s_0, 잉여도는 데이텀에 따라 달라지지 않습니다.</translation>
    </message>
    <message>
        <source>Each round of directions has an orientation that is not known. Instruments are levelled unless the set-up says how they lean: zenith angles count from the vertical, the z-axis at all points.</source>
        <translation>방향의 각 대회에는 알려지지 않은 표정이 있습니다. 측정 구성에서 기울어진 정도를 밝히지 않는 한 측정기는 정준되어 있습니다. 천정각은 연직선, 즉 모든 점에서 z축부터 셉니다.</translation>
    </message>
    <message>
        <source>Smallest detectable errors are those of a test at 0.1 % with a power of 80 % (delta_0 = 4.132), with the uncertainties that were stated.</source>
        <translation>최소 검출가능 오차는 제시된 불확도로, 검정력 80 %인 0.1 % 검정에 대한 것입니다(delta_0 = 4.132).</translation>
    </message>
    <message>
        <source>In Monte Carlo each trial is a solution with the derivatives at the estimates, repeated until it stands still.</source>
        <translation>몬테카를로에서 각 시행은 추정값에서의 도함수로 구한 해이며, 더 변하지 않을 때까지 반복합니다.</translation>
    </message>
    <message>
        <source>Stations and targets alike, with what is known of them beforehand.</source>
        <translation>스테이션과 표적을 구별하지 않으며, 미리 알려진 것을 함께 적습니다.</translation>
    </message>
    <message>
        <source>Coordinate x; of an unknown point an approximate one, or empty: the readings place it.</source>
        <translation>좌표 x. 미지점이면 근사 좌표, 또는 비워 둠: 읽음값에서 위치를 구합니다.</translation>
    </message>
    <message>
        <source>Coordinate y; of an unknown point an approximate one, or empty: the readings place it.</source>
        <translation>좌표 y. 미지점이면 근사 좌표, 또는 비워 둠: 읽음값에서 위치를 구합니다.</translation>
    </message>
    <message>
        <source>Coordinate z; of an unknown point an approximate one, or empty: the readings place it.</source>
        <translation>좌표 z. 미지점이면 근사 좌표, 또는 비워 둠: 읽음값에서 위치를 구합니다.</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>평면</translation>
    </message>
    <message>
        <source>What is known of x and y: unknown; unknown, and what no reading tells is taken from this point and others like it (free network); fixed without uncertainty; stated with u.</source>
        <translation>x와 y에 대해 알려진 것: 미지; 미지이며, 어떤 읽음값도 알려 주지 않는 것을 이 점과 같은 종류의 다른 점에서 취함(자유망); 불확도 없이 고정; u와 함께 제시.</translation>
    </message>
    <message>
        <source>unknown, of the datum</source>
        <translation>미지, 데이텀에 속함</translation>
    </message>
    <message>
        <source>stated with u</source>
        <translation>u와 함께 제시</translation>
    </message>
    <message>
        <source>not part of the network</source>
        <translation>망에 속하지 않음</translation>
    </message>
    <message>
        <source>height</source>
        <translation>높이</translation>
    </message>
    <message>
        <source>What is known of z, likewise.</source>
        <translation>z에 대해 알려진 것, 마찬가지로.</translation>
    </message>
    <message>
        <source>Standard uncertainty of a stated coordinate.</source>
        <translation>제시된 좌표의 표준불확도.</translation>
    </message>
    <message>
        <source>Name of a point.</source>
        <translation>점의 이름.</translation>
    </message>
    <message>
        <source>Name of another point.</source>
        <translation>다른 점의 이름.</translation>
    </message>
    <message>
        <source>Directions grow</source>
        <translation>방향의 증가</translation>
    </message>
    <message>
        <source>In which sense directions, angles and azimuths grow, and from which axis azimuths count.</source>
        <translation>방향, 각, 방위각이 어느 쪽으로 증가하며, 방위각을 어느 축부터 세는지.</translation>
    </message>
    <message>
        <source>from x towards y; azimuths count from x</source>
        <translation>x에서 y 쪽으로, 방위각은 x부터</translation>
    </message>
    <message>
        <source>from y towards x; azimuths count from y</source>
        <translation>y에서 x 쪽으로, 방위각은 y부터</translation>
    </message>
    <message>
        <source>What was read between the points, one row for each figure, typed or from a CSV file.</source>
        <translation>점 사이에서 읽은 것. 수치마다 한 행이며, 직접 입력하거나 CSV 파일에서 읽습니다.</translation>
    </message>
    <message>
        <source>label</source>
        <translation>레이블</translation>
    </message>
    <message>
        <source>By which a correlation calls it.</source>
        <translation>상관에서 이것을 부르는 이름.</translation>
    </message>
    <message>
        <source>What was read.</source>
        <translation>읽은 것.</translation>
    </message>
    <message>
        <source>slope distance</source>
        <translation>경사거리</translation>
    </message>
    <message>
        <source>horizontal distance</source>
        <translation>수평거리</translation>
    </message>
    <message>
        <source>zenith angle</source>
        <translation>천정각</translation>
    </message>
    <message>
        <source>height difference</source>
        <translation>높이차</translation>
    </message>
    <message>
        <source>x of a point</source>
        <translation>점의 x</translation>
    </message>
    <message>
        <source>y of a point</source>
        <translation>점의 y</translation>
    </message>
    <message>
        <source>z of a point</source>
        <translation>점의 z</translation>
    </message>
    <message>
        <source>difference of x</source>
        <translation>x의 차</translation>
    </message>
    <message>
        <source>difference of y</source>
        <translation>y의 차</translation>
    </message>
    <message>
        <source>difference of z</source>
        <translation>z의 차</translation>
    </message>
    <message>
        <source>The point where it was read; of a coordinate its point.</source>
        <translation>읽은 곳인 점. 좌표이면 그 점.</translation>
    </message>
    <message>
        <source>The point that was sighted.</source>
        <translation>시준한 점.</translation>
    </message>
    <message>
        <source>Of an angle the point at its second leg.</source>
        <translation>각이면 둘째 변의 점.</translation>
    </message>
    <message>
        <source>round</source>
        <translation>대회</translation>
    </message>
    <message>
        <source>Of a direction: rounds of one station between which its circle was turned have names; each has an orientation of its own.</source>
        <translation>방향일 때: 한 스테이션에서 그 사이에 눈금판을 돌린 대회에는 이름을 붙입니다. 대회마다 표정이 따로 있습니다.</translation>
    </message>
    <message>
        <source>A length or coordinate as read.</source>
        <translation>읽은 대로의 길이 또는 좌표.</translation>
    </message>
    <message>
        <source>An angle as read.</source>
        <translation>읽은 대로의 각.</translation>
    </message>
    <message>
        <source>u of length</source>
        <translation>길이의 u</translation>
    </message>
    <message>
        <source>Standard uncertainty of the length.</source>
        <translation>길이의 표준불확도.</translation>
    </message>
    <message>
        <source>u of angle</source>
        <translation>각의 u</translation>
    </message>
    <message>
        <source>Standard uncertainty of the angle.</source>
        <translation>각의 표준불확도.</translation>
    </message>
    <message>
        <source>height from</source>
        <translation>측정기 높이</translation>
    </message>
    <message>
        <source>Height of the instrument above its point.</source>
        <translation>점에서 잰 측정기의 높이.</translation>
    </message>
    <message>
        <source>height to</source>
        <translation>표적 높이</translation>
    </message>
    <message>
        <source>Height of the target above its point.</source>
        <translation>점에서 잰 표적의 높이.</translation>
    </message>
    <message>
        <source>Instruments that are not levelled</source>
        <translation>정준되지 않은 측정기</translation>
    </message>
    <message>
        <source>Where an instrument stands that is not levelled, or not exactly; all others are.</source>
        <translation>정준되지 않았거나 정확히 정준되지 않은 측정기가 서 있는 곳. 나머지는 모두 정준되어 있습니다.</translation>
    </message>
    <message>
        <source>The point where the instrument stands.</source>
        <translation>측정기가 서 있는 점.</translation>
    </message>
    <message>
        <source>tilt</source>
        <translation>기울기</translation>
    </message>
    <message>
        <source>How it leans: unknown, so that the readings tell it; or levelled within u, about x and about y.</source>
        <translation>기울어진 정도: 미지이며 읽음값에서 구함, 또는 x 둘레와 y 둘레로 u 이내로 정준됨.</translation>
    </message>
    <message>
        <source>levelled within u</source>
        <translation>u 이내로 정준됨</translation>
    </message>
    <message>
        <source>u of tilt</source>
        <translation>기울기의 u</translation>
    </message>
    <message>
        <source>Standard uncertainty of each tilt of a levelled instrument.</source>
        <translation>정준된 측정기의 각 기울기의 표준불확도.</translation>
    </message>
    <message>
        <source>Correlations of readings</source>
        <translation>읽음값의 상관</translation>
    </message>
    <message>
        <source>Correlation coefficients of readings: they change the weights and the uncertainty.</source>
        <translation>읽음값의 상관계수. 가중값과 불확도를 바꿉니다.</translation>
    </message>
    <message>
        <source>Label of a reading.</source>
        <translation>읽음값의 레이블.</translation>
    </message>
    <message>
        <source>Label of another reading.</source>
        <translation>다른 읽음값의 레이블.</translation>
    </message>
    <message>
        <source>Correlation coefficient of the two.</source>
        <translation>둘의 상관계수.</translation>
    </message>
    <message>
        <source>Two targets from two stations that nobody measured</source>
        <translation>아무도 위치를 측정하지 않은 두 스테이션에서 본 두 표적</translation>
    </message>
    <message>
        <source>A total station stood at S1 and S2, whose places are not known.</source>
        <translation>토털 스테이션을 위치가 알려지지 않은 S1과 S2에 세웠습니다.</translation>
    </message>
    <message>
        <source>The law of propagation of uncertainty says nothing of %1 at these estimates: Monte Carlo answers alone</source>
        <translation>이 추정값에서 불확도 전파 법칙은 %1에 대해 아무것도 알려 주지 않습니다. 몬테카를로만 답을 줍니다</translation>
    </message>
    <message>
        <source>The standard uncertainty by Monte Carlo of %1 is not known from these trials, and may not exist: the tails of its distribution are too heavy. Use the coverage interval.</source>
        <translation>%1의 몬테카를로에 의한 표준불확도는 이 시행들로 알 수 없으며 존재하지 않을 수도 있습니다. 그 분포의 꼬리가 너무 두껍습니다. 포함구간을 쓰십시오.</translation>
    </message>
    <message>
        <source>as stated</source>
        <translation>제시된 대로</translation>
    </message>
    <message>
        <source>tilt at %1 about %2</source>
        <translation>%1의 기울기, %2 둘레</translation>
    </message>
    <message>
        <source>orientation at %1</source>
        <translation>%1의 표정</translation>
    </message>
    <message>
        <source>orientation at %1, round %2</source>
        <translation>%1의 표정, 대회 %2</translation>
    </message>
    <message>
        <source>readings l, their residuals v, unknowns x</source>
        <translation>읽음값 l, 그 잔차 v, 미지수 x</translation>
    </message>
    <message>
        <source>least squares, Gauss-Newton method</source>
        <translation>최소제곱, 가우스-뉴턴법</translation>
    </message>
    <message>
        <source>law of propagation; generalised inverse of the datum</source>
        <translation>전파 법칙, 데이텀의 일반화 역행렬</translation>
    </message>
    <message>
        <source>free network: W. Baarda, S-transformations, 1973</source>
        <translation>자유망: W. Baarda, S-transformations, 1973</translation>
    </message>
    <message>
        <source>redundancy and test of a reading: W. Baarda, A testing procedure, 1968</source>
        <translation>읽음값의 잉여도와 검정: W. Baarda, A testing procedure, 1968</translation>
    </message>
    <message>
        <source>smallest error of a reading that the test finds</source>
        <translation>검정으로 찾을 수 있는 읽음값의 최소 오차</translation>
    </message>
    <message>
        <source>a posteriori; uncertainties are those that were stated, not times s₀</source>
        <translation>사후. 불확도는 제시된 값이며 s₀을 곱하지 않음</translation>
    </message>
    <message>
        <source>slope distance %1 – %2</source>
        <translation>경사거리 %1 – %2</translation>
    </message>
    <message>
        <source>horizontal distance %1 – %2</source>
        <translation>수평거리 %1 – %2</translation>
    </message>
    <message>
        <source>direction %1 – %2</source>
        <translation>방향 %1 – %2</translation>
    </message>
    <message>
        <source>azimuth %1 – %2</source>
        <translation>방위각 %1 – %2</translation>
    </message>
    <message>
        <source>zenith angle %1 – %2</source>
        <translation>천정각 %1 – %2</translation>
    </message>
    <message>
        <source>height difference %1 – %2</source>
        <translation>높이차 %1 – %2</translation>
    </message>
    <message>
        <source>tilt about x of the instrument at %1</source>
        <translation>%1에 있는 측정기의 x 둘레 기울기</translation>
    </message>
    <message>
        <source>tilt about y of the instrument at %1</source>
        <translation>%1에 있는 측정기의 y 둘레 기울기</translation>
    </message>
    <message>
        <source>x of %1</source>
        <translation>%1의 x</translation>
    </message>
    <message>
        <source>y of %1</source>
        <translation>%1의 y</translation>
    </message>
    <message>
        <source>z of %1</source>
        <translation>%1의 z</translation>
    </message>
    <message>
        <source>difference of x, %1 – %2</source>
        <translation>x의 차, %1 – %2</translation>
    </message>
    <message>
        <source>difference of y, %1 – %2</source>
        <translation>y의 차, %1 – %2</translation>
    </message>
    <message>
        <source>difference of z, %1 – %2</source>
        <translation>z의 차, %1 – %2</translation>
    </message>
    <message>
        <source>the readings do not lead to a place of every point: the adjustment does not converge; look for exchanged or mistyped readings, for a unit that was mixed up (gon and degrees, m and mm), and for coordinates that are far off</source>
        <translation>읽음값에서 모든 점의 위치를 구할 수 없습니다. 조정이 수렴하지 않습니다. 바뀌었거나 잘못 입력한 읽음값, 혼동한 단위(gon과 도, m와 mm), 크게 벗어난 좌표를 찾으십시오</translation>
    </message>
    <message>
        <source>and %1 further ways in which the points can move</source>
        <translation>그 밖에 점들이 움직일 수 있는 방식 %1가지</translation>
    </message>
    <message>
        <source>point %1: its %2 is said to be known, and is missing</source>
        <translation>점 %1: %2이(가) 알려져 있다고 했으나 값이 없습니다</translation>
    </message>
    <message>
        <source>point %1: the u of its stated %2 is missing</source>
        <translation>점 %1: 제시된 %2의 u가 없습니다</translation>
    </message>
    <message>
        <source>the name of a point is missing</source>
        <translation>점의 이름이 없습니다</translation>
    </message>
    <message>
        <source>there is no point %1</source>
        <translation>점 %1이(가) 없습니다</translation>
    </message>
    <message>
        <source>the instrument at %1: the u of its tilt is missing</source>
        <translation>%1에 있는 측정기: 기울기의 u가 없습니다</translation>
    </message>
    <message>
        <source>two instruments stand at %1</source>
        <translation>%1에 측정기 두 대가 서 있습니다</translation>
    </message>
    <message>
        <source>a reading from %1 to itself</source>
        <translation>%1에서 자기 자신으로의 읽음값</translation>
    </message>
    <message>
        <source>both legs of the angle at %1 go to %2</source>
        <translation>%1에서의 각의 두 변이 모두 %2을(를) 향합니다</translation>
    </message>
    <message>
        <source>%1: its value is missing</source>
        <translation>%1: 값이 없습니다</translation>
    </message>
    <message>
        <source>%1: its standard uncertainty is missing</source>
        <translation>%1: 표준불확도가 없습니다</translation>
    </message>
    <message>
        <source>%1 is an angle and has a length</source>
        <translation>%1은(는) 각인데 길이가 주어졌습니다</translation>
    </message>
    <message>
        <source>%1 is a length and has an angle</source>
        <translation>%1은(는) 길이인데 각이 주어졌습니다</translation>
    </message>
    <message>
        <source>%1 is not positive</source>
        <translation>%1은(는) 양수가 아닙니다</translation>
    </message>
    <message>
        <source>%1 needs the height of %2, which is not part of the network</source>
        <translation>%1에는 %2의 높이가 필요하지만 망에 속하지 않습니다</translation>
    </message>
    <message>
        <source>%1 needs x and y of %2, which are not part of the network</source>
        <translation>%1에는 %2의 x와 y가 필요하지만 망에 속하지 않습니다</translation>
    </message>
    <message>
        <source>a distance needs two points</source>
        <translation>거리에는 두 점이 필요합니다</translation>
    </message>
    <message>
        <source>all points are fixed: there is nothing to be found</source>
        <translation>모든 점이 고정되어 있어 구할 것이 없습니다</translation>
    </message>
    <message>
        <source>two readings have the label %1</source>
        <translation>두 읽음값의 레이블이 %1입니다</translation>
    </message>
    <message>
        <source>there is no reading with the label %1</source>
        <translation>레이블이 %1인 읽음값이 없습니다</translation>
    </message>
    <message>
        <source>reading %1 with itself</source>
        <translation>읽음값 %1과(와) 그 자신</translation>
    </message>
    <message>
        <source>the correlation coefficients are not possible together</source>
        <translation>상관계수들이 함께 성립할 수 없습니다</translation>
    </message>
    <message>
        <source>the readings do not place point %1: too few of them tie it to the others; add readings, or state approximate coordinates</source>
        <translation>읽음값으로 점 %1의 위치를 정할 수 없습니다. 다른 점과 연결하는 읽음값이 너무 적습니다. 읽음값을 추가하거나 근사 좌표를 제시하십시오</translation>
    </message>
    <message>
        <source>the readings do not place %1 points (%2): too few tie them to the others; add readings, or state approximate coordinates</source>
        <translation>읽음값으로 점 %1개(%2)의 위치를 정할 수 없습니다. 다른 점과 연결하는 읽음값이 너무 적습니다. 읽음값을 추가하거나 근사 좌표를 제시하십시오</translation>
    </message>
    <message>
        <source>Adjustment</source>
        <translation>조정</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>항목</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>값</translation>
    </message>
    <message>
        <source>unknowns</source>
        <translation>미지수</translation>
    </message>
    <message>
        <source>what no reading tells (datum defect)</source>
        <translation>어떤 읽음값도 알려 주지 않는 것(데이텀 결손)</translation>
    </message>
    <message>
        <source>degrees of freedom f</source>
        <translation>자유도 f</translation>
    </message>
    <message>
        <source>sum of squares vᵀ C⁻¹ v</source>
        <translation>제곱합 vᵀ C⁻¹ v</translation>
    </message>
    <message>
        <source>s₀ a posteriori</source>
        <translation>사후 s₀</translation>
    </message>
    <message>
        <source>δ₀ of smallest detectable errors (0.1 %, 80 %)</source>
        <translation>최소 검출가능 오차의 δ₀(0.1 %, 80 %)</translation>
    </message>
    <message>
        <source>smallest detectable error</source>
        <translation>최소 검출가능 오차</translation>
    </message>
    <message>
        <source>its largest effect</source>
        <translation>그 최대 영향</translation>
    </message>
    <message>
        <source>on</source>
        <translation>좌표</translation>
    </message>
    <message>
        <source>%1 The residuals are larger than the uncertainties allow; the largest for its uncertainty is the %2. Look for mistyped or exchanged readings, or uncertainties that are too small</source>
        <translation>%1 잔차가 불확도가 허용하는 것보다 큽니다. 불확도에 비해 가장 큰 것은 %2입니다. 잘못 입력했거나 바뀐 읽음값, 또는 너무 작은 불확도를 찾으십시오</translation>
    </message>
    <message>
        <source>nothing was read of point %1: add readings to it, or take it out</source>
        <translation>점 %1에 대해 읽은 것이 없습니다. 읽음값을 추가하거나 점을 빼십시오</translation>
    </message>
    <message>
        <source>nothing tells how the instrument at %1 stood: add directions or angles from there to places that are known</source>
        <translation>%1에 있는 측정기가 어떻게 서 있었는지 알 수 없습니다. 거기서 위치가 알려진 곳으로의 방향이나 각을 추가하십시오</translation>
    </message>
    <message>
        <source>nothing tells the height of %1: state it, or add a height difference, or a zenith angle with a distance</source>
        <translation>%1의 높이를 알 수 없습니다. 높이를 제시하거나, 높이차 또는 거리가 있는 천정각을 추가하십시오</translation>
    </message>
    <message>
        <source>nothing tells where %1 is: add readings to it</source>
        <translation>%1이(가) 어디에 있는지 알 수 없습니다. 읽음값을 추가하십시오</translation>
    </message>
    <message>
        <source>point %1 can move along %2 without changing a reading: add one that sees this</source>
        <translation>점 %1은(는) 읽음값을 바꾸지 않고 %2을(를) 따라 움직일 수 있습니다. 이를 알아내는 읽음값을 추가하십시오</translation>
    </message>
    <message>
        <source>the direction (%1, %2, %3)</source>
        <translation>방향 (%1, %2, %3)</translation>
    </message>
    <message>
        <source>the whole network</source>
        <translation>망 전체</translation>
    </message>
    <message>
        <source>the part with %1 and %2 more</source>
        <translation>%1 외 %2개가 있는 부분</translation>
    </message>
    <message>
        <source>the part with %1</source>
        <translation>%1이(가) 있는 부분</translation>
    </message>
    <message>
        <source>nothing tells where %1 is along %2: fix or state a point, or let points be of the datum</source>
        <translation>%1이(가) %2을(를) 따라 어디에 있는지 알 수 없습니다. 점을 고정하거나 제시하거나, 점을 데이텀에 포함하십시오</translation>
    </message>
    <message>
        <source>nothing tells the height of %1: fix or state the height of a point, or let heights be of the datum</source>
        <translation>%1의 높이를 알 수 없습니다. 점의 높이를 고정하거나 제시하거나, 높이를 데이텀에 포함하십시오</translation>
    </message>
    <message>
        <source>%1 may tilt about %2: add zenith angles or height differences, or fix a third point</source>
        <translation>%1이(가) %2 둘레로 기울 수 있습니다. 천정각이나 높이차를 추가하거나 세 번째 점을 고정하십시오</translation>
    </message>
    <message>
        <source>%1 may turn about the vertical: add an azimuth, fix a second point, or let points be of the datum</source>
        <translation>%1이(가) 연직선 둘레로 회전할 수 있습니다. 방위각을 추가하거나, 두 번째 점을 고정하거나, 점을 데이텀에 포함하십시오</translation>
    </message>
    <message>
        <source>nothing tells the scale of %1: add a distance, fix a second point, or let points be of the datum</source>
        <translation>%1의 스케일을 알 수 없습니다. 거리를 추가하거나, 두 번째 점을 고정하거나, 점을 데이텀에 포함하십시오</translation>
    </message>
    <message>
        <source>the readings leave open a common movement of %1: add readings that tie them to the others</source>
        <translation>읽음값으로는 %1의 공통 이동이 정해지지 않습니다. 다른 점과 연결하는 읽음값을 추가하십시오</translation>
    </message>
    <message>
        <source>orientations</source>
        <translation>표정</translation>
    </message>
    <message>
        <source>moving platform</source>
        <translation>이동 플랫폼</translation>
    </message>
    <message>
        <source>lengths</source>
        <translation>길이</translation>
    </message>
    <message>
        <source>measured orientations</source>
        <translation>측정된 방위</translation>
    </message>
    <message>
        <source>measured positions</source>
        <translation>측정된 위치</translation>
    </message>
    <message>
        <source>readings of the joints</source>
        <translation>관절의 읽음값</translation>
    </message>
    <message>
        <source>circle of %1</source>
        <translation>%1의 원</translation>
    </message>
    <message>
        <source>regression</source>
        <translation>회귀</translation>
    </message>
    <message>
        <source>it cannot be varied: %1</source>
        <translation>변화시킬 수 없습니다: %1</translation>
    </message>
    <message>
        <source>no more than %1</source>
        <translation>%1 이하</translation>
    </message>
    <message>
        <source>an observation of %1, which the file neither fixes nor adjusts in what it needs</source>
        <translation>%1의 관측, 그에 필요한 것을 파일이 고정하지도 조정하지도 않음</translation>
    </message>
    <message>
        <source>an observation of %1 without a standard deviation</source>
        <translation>표준편차가 없는 %1의 관측</translation>
    </message>
    <message>
        <source>a network of %1 points with %2 readings, which is adjusted</source>
        <translation>점 %1개와 읽음값 %2개로 된 망, 조정됨</translation>
    </message>
    <message>
        <source>its heights above the points are no numbers</source>
        <translation>점 위의 높이가 수가 아닙니다</translation>
    </message>
    <message>
        <source>column %1%2 of sheet %3 is filled but not understood: state what each column is, %4, with one of %5 in place of ? (- leaves the column out)</source>
        <translation>시트 %3의 열 %1%2에 내용이 있지만 이해할 수 없습니다. 각 열이 무엇인지 지정하십시오: %4, ? 자리에는 %5 중 하나(-는 열을 제외함)</translation>
    </message>
    <message>
        <source>There is no budget of %1: the law of propagation of uncertainty says nothing of it at the estimates of its input quantities.</source>
        <translation>%1의 총괄표가 없습니다. 불확도 전파 법칙은 입력량의 추정값에서 이에 대해 아무것도 알려 주지 않습니다.</translation>
    </message>
    <message>
        <source>out</source>
        <translation>출력</translation>
    </message>
    <message>
        <source>%1 trials</source>
        <translation>시행 %1회</translation>
    </message>
    <message>
        <source>sight</source>
        <translation>시준선</translation>
    </message>
    <message>
        <source>force, own scale</source>
        <translation>힘, 자체 스케일</translation>
    </message>
    <message>
        <source>moment, own scale</source>
        <translation>모멘트, 자체 스케일</translation>
    </message>
    <message>
        <source>in</source>
        <translation>입력</translation>
    </message>
    <message>
        <source>uncertainty %1</source>
        <translation>불확도 %1</translation>
    </message>
    <message>
        <source>ellipsoids %1, %2</source>
        <translation>타원체 %1, %2</translation>
    </message>
    <message>
        <source>Uncertainties of the readings</source>
        <translation>읽음값의 불확도</translation>
    </message>
    <message>
        <source>As typed in the table; or as the residuals of this adjustment see them: typed ones times one common factor s_0, or times the factor of each kind of reading and instrument (variance components). Either has the degrees of freedom of its estimate.</source>
        <translation>표에 입력한 대로, 또는 이 조정의 잔차에서 드러난 대로: 입력한 값에 공통 인자 s_0 하나를 곱하거나, 읽음값의 종류와 측정기마다의 인자를 곱합니다(분산성분). 어느 쪽이든 그 추정의 자유도를 갖습니다.</translation>
    </message>
    <message>
        <source>as seen, one factor s_0</source>
        <translation>드러난 대로, 인자 s_0 하나</translation>
    </message>
    <message>
        <source>as seen, a factor for each figure</source>
        <translation>드러난 대로, 수치마다 인자</translation>
    </message>
    <message>
        <source>Are the figures of the data sheet true?</source>
        <translation>사양서의 수치는 맞을까?</translation>
    </message>
    <message>
        <source>A section of a barrel, 8 m long, with 20 targets, read by a total station from three places that nobody measured.</source>
        <translation>표적 20개가 있는 길이 8 m의 원통 동체 구간. 아무도 측정하지 않은 세 위치에서 토털 스테이션으로 읽었습니다.</translation>
    </message>
    <message>
        <source>slope distances</source>
        <translation>경사거리</translation>
    </message>
    <message>
        <source>horizontal distances</source>
        <translation>수평거리</translation>
    </message>
    <message>
        <source>directions</source>
        <translation>방향</translation>
    </message>
    <message>
        <source>azimuths</source>
        <translation>방위각</translation>
    </message>
    <message>
        <source>zenith angles</source>
        <translation>천정각</translation>
    </message>
    <message>
        <source>height differences</source>
        <translation>높이차</translation>
    </message>
    <message>
        <source>tilts of instruments</source>
        <translation>측정기의 기울기</translation>
    </message>
    <message>
        <source>stated coordinates</source>
        <translation>제시된 좌표</translation>
    </message>
    <message>
        <source>coordinates</source>
        <translation>좌표</translation>
    </message>
    <message>
        <source>coordinate differences</source>
        <translation>좌표차</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 및 %2</translation>
    </message>
    <message>
        <source>The readings have no residuals that could tell their uncertainty: it stays as stated</source>
        <translation>읽음값에 그 불확도를 알려 줄 잔차가 없습니다. 불확도는 제시된 대로 둡니다</translation>
    </message>
    <message>
        <source>Nothing is redundant: uncertainties of the readings stay as stated</source>
        <translation>잉여 읽음값이 없습니다. 읽음값의 불확도는 제시된 대로 둡니다</translation>
    </message>
    <message>
        <source>The residuals give no factors: uncertainties of the readings stay as stated</source>
        <translation>잔차에서 인자를 구할 수 없습니다. 읽음값의 불확도는 제시된 대로 둡니다</translation>
    </message>
    <message>
        <source>Too little redundancy to say, so they stay as stated: %1</source>
        <translation>잉여도가 너무 작아 판정할 수 없으므로 제시된 대로 둠: %1</translation>
    </message>
    <message>
        <source>as seen: %1 times what was stated</source>
        <translation>드러난 대로: 제시된 값의 %1배</translation>
    </message>
    <message>
        <source>measured places</source>
        <translation>측정된 위치</translation>
    </message>
    <message>
        <source>encoders of the joints</source>
        <translation>관절의 엔코더</translation>
    </message>
    <message>
        <source>repeatability of the joints</source>
        <translation>관절의 반복성</translation>
    </message>
    <message>
        <source>Residuals over their standard uncertainties as stated</source>
        <translation>잔차를 제시된 표준불확도로 나눈 값</translation>
    </message>
    <message>
        <source>others</source>
        <translation>기타</translation>
    </message>
    <message>
        <source>Quantiles of the residuals</source>
        <translation>잔차의 분위수</translation>
    </message>
    <message>
        <source>normal distribution</source>
        <translation>정규분포</translation>
    </message>
    <message>
        <source>The readings cannot tell apart, and give one factor to: %1.</source>
        <translation>읽음값으로 구별할 수 없어 하나의 인자를 주는 것: %1.</translation>
    </message>
    <message>
        <source>The estimate of the variance was negative, so it is zero, of: %1.</source>
        <translation>분산의 추정값이 음수여서 0으로 한 것: %1.</translation>
    </message>
    <message>
        <source>The global test does not see that figures which are too large and figures which are too small make up for each other: %1.</source>
        <translation>너무 큰 수치와 너무 작은 수치가 서로 상쇄되는 것은 전체 검정에 나타나지 않습니다: %1.</translation>
    </message>
    <message>
        <source>seen is smaller</source>
        <translation>드러난 값이 더 작음</translation>
    </message>
    <message>
        <source>seen is larger</source>
        <translation>드러난 값이 더 큼</translation>
    </message>
    <message>
        <source>too little to say</source>
        <translation>판정하기에 부족</translation>
    </message>
    <message>
        <source>Stated and seen uncertainties</source>
        <translation>제시된 불확도와 드러난 불확도</translation>
    </message>
    <message>
        <source>figure</source>
        <translation>수치</translation>
    </message>
    <message>
        <source>stated u</source>
        <translation>제시된 u</translation>
    </message>
    <message>
        <source>factor</source>
        <translation>인자</translation>
    </message>
    <message>
        <source>seen u</source>
        <translation>드러난 u</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>판정</translation>
    </message>
    <message>
        <source>Nothing is redundant: the readings say nothing.</source>
        <translation>잉여 읽음값이 없습니다. 읽음값으로 아무것도 알 수 없습니다.</translation>
    </message>
    <message>
        <source>More than %1 readings: their factors are not computed.</source>
        <translation>읽음값이 %1개를 넘어 그 인자를 계산하지 않습니다.</translation>
    </message>
    <message>
        <source>The factors of the figures do not come to rest.</source>
        <translation>수치의 인자가 수렴하지 않습니다.</translation>
    </message>
    <message>
        <source>Global test: s₀ = %1 with %2 degrees of freedom passes (%3 to %4).</source>
        <translation>전체 검정: s₀ = %1, 자유도 %2, 통과(%3 ~ %4).</translation>
    </message>
    <message>
        <source>Global test: s₀ = %1 with %2 degrees of freedom fails (%3 to %4).</source>
        <translation>전체 검정: s₀ = %1, 자유도 %2, 불통과(%3 ~ %4).</translation>
    </message>
    <message>
        <source>Mean u of a coordinate: %1 as stated, %2 as seen.</source>
        <translation>좌표의 평균 u: 제시된 대로 %1, 드러난 대로 %2.</translation>
    </message>
    <message>
        <source>Geometry from points</source>
        <translation>점으로 구하는 형상</translation>
    </message>
    <message>
        <source>Lines, planes, circles, spheres, cylinders and cones through measured points by orthogonal least squares: place, direction, diameter and form deviation with the full covariance of the points.</source>
        <translation>측정점을 지나는 직선, 평면, 원, 구, 원통, 원뿔을 직교 최소제곱으로 구합니다. 점의 전체 공분산에 의한 위치, 방향, 지름, 형상 편차.</translation>
    </message>
    <message>
        <source>Points weigh alike, whatever their uncertainty, as in least-squares features of coordinate measurement; their covariance goes into the uncertainty of the results.</source>
        <translation>좌표 측정의 최소제곱 형체에서처럼 점은 불확도와 관계없이 같은 가중치를 갖습니다. 점의 공분산은 결과의 불확도에 들어갑니다.</translation>
    </message>
    <message>
        <source>A circle in space is fitted in two steps, as NIST&apos;s: the plane by all points, then the circle by the points projected onto it.</source>
        <translation>공간의 원은 NIST의 방법처럼 두 단계로 맞춥니다. 먼저 모든 점으로 평면을, 다음에 그 평면에 투영한 점으로 원을 맞춥니다.</translation>
    </message>
    <message>
        <source>The direction has its largest component positive; that of a cone leads from the apex into it. &quot;Reversed&quot; turns it. Trials keep the sign of the estimates.</source>
        <translation>방향은 가장 큰 성분이 양이고, 원뿔의 방향은 꼭짓점에서 안쪽을 향합니다. &quot;반전&quot;은 이를 뒤집습니다. 시행은 추정값의 부호를 유지합니다.</translation>
    </message>
    <message>
        <source>The place of a plane or line is the mean of the points; of a cylinder or cone it is the point of the axis next to that mean, so the uncertainty along the axis is that of the mean.</source>
        <translation>평면이나 직선의 위치는 점들의 평균이고, 원통이나 원뿔의 위치는 그 평균에 가장 가까운 축 위의 점입니다. 따라서 축 방향의 불확도는 그 평균의 불확도입니다.</translation>
    </message>
    <message>
        <source>Every trial of a Monte Carlo run fits its points anew. Form deviations of trials are larger than that of the points as measured, for uncertainty adds to what is form.</source>
        <translation>몬테카를로 실행의 모든 시행은 점을 새로 맞춥니다. 시행의 형상 편차는 측정된 점의 형상 편차보다 큽니다. 불확도가 형상에 더해지기 때문입니다.</translation>
    </message>
    <message>
        <source>Features</source>
        <translation>형체</translation>
    </message>
    <message>
        <source>Forms that are fitted to points by orthogonal least squares.</source>
        <translation>직교 최소제곱으로 점에 맞추는 형상.</translation>
    </message>
    <message>
        <source>Name of the feature, unique.</source>
        <translation>형체의 이름, 고유해야 합니다.</translation>
    </message>
    <message>
        <source>form</source>
        <translation>형상</translation>
    </message>
    <message>
        <source>What is fitted to its points. In the xy-plane z does not matter.</source>
        <translation>점에 맞추는 것. xy 평면에서는 z가 상관없습니다.</translation>
    </message>
    <message>
        <source>line</source>
        <translation>직선</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>원</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>구</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>원통</translation>
    </message>
    <message>
        <source>cone</source>
        <translation>원뿔</translation>
    </message>
    <message>
        <source>line in the xy-plane</source>
        <translation>xy 평면의 직선</translation>
    </message>
    <message>
        <source>circle in the xy-plane</source>
        <translation>xy 평면의 원</translation>
    </message>
    <message>
        <source>reversed</source>
        <translation>반전</translation>
    </message>
    <message>
        <source>The direction is stated with the other sign: the largest component of the direction is negative, that of a cone leads to its apex.</source>
        <translation>방향을 반대 부호로 나타냅니다. 방향의 가장 큰 성분이 음이고, 원뿔의 방향은 꼭짓점을 향합니다.</translation>
    </message>
    <message>
        <source>Form deviations</source>
        <translation>형상 편차</translation>
    </message>
    <message>
        <source>Peak to valley and root mean square of the points&apos; deviations from their feature are results too.</source>
        <translation>형체에서 벗어난 점의 편차의 최대-최소 폭과 제곱평균제곱근도 결과입니다.</translation>
    </message>
    <message>
        <source>Measured points of the features, typed, pasted or from a CSV file.</source>
        <translation>형체의 측정점. 직접 입력하거나 붙여넣거나 CSV 파일에서 읽습니다.</translation>
    </message>
    <message>
        <source>feature</source>
        <translation>형체</translation>
    </message>
    <message>
        <source>The feature that it is a point of; empty: that of the row above, of the first row the first.</source>
        <translation>점이 속한 형체. 비어 있으면 윗행의 형체, 첫 행이면 첫째 형체.</translation>
    </message>
    <message>
        <source>Name of the point, unique in its feature; empty: its number. Of points that an analysis measured the name there.</source>
        <translation>점의 이름, 형체 안에서 고유해야 합니다. 비어 있으면 점의 번호. 분석이 측정한 점이면 그 분석에서의 이름.</translation>
    </message>
    <message>
        <source>Measured coordinate x; empty where the point is a feature of an analysis, and z in the xy-plane.</source>
        <translation>측정한 좌표 x. 점이 분석의 형체이면 비워 두며, xy 평면에서는 z도 비워 둡니다.</translation>
    </message>
    <message>
        <source>Measured coordinate y; empty where the point is a feature of an analysis, and z in the xy-plane.</source>
        <translation>측정한 좌표 y. 점이 분석의 형체이면 비워 두며, xy 평면에서는 z도 비워 둡니다.</translation>
    </message>
    <message>
        <source>Measured coordinate z; empty where the point is a feature of an analysis, and z in the xy-plane.</source>
        <translation>측정한 좌표 z. 점이 분석의 형체이면, 또 xy 평면에서는 비워 둡니다.</translation>
    </message>
    <message>
        <source>Standard uncertainty of coordinate x of this point; empty: as for all points.</source>
        <translation>이 점의 좌표 x의 표준불확도. 비어 있으면 모든 점에 대한 값.</translation>
    </message>
    <message>
        <source>Standard uncertainty of coordinate y of this point; empty: as for all points.</source>
        <translation>이 점의 좌표 y의 표준불확도. 비어 있으면 모든 점에 대한 값.</translation>
    </message>
    <message>
        <source>Standard uncertainty of coordinate z of this point; empty: as for all points.</source>
        <translation>이 점의 좌표 z의 표준불확도. 비어 있으면 모든 점에 대한 값.</translation>
    </message>
    <message>
        <source>Correlation coefficient of the point&apos;s own x and y.</source>
        <translation>점 자신의 x와 y의 상관계수.</translation>
    </message>
    <message>
        <source>Correlation coefficient of the point&apos;s own x and z.</source>
        <translation>점 자신의 x와 z의 상관계수.</translation>
    </message>
    <message>
        <source>Correlation coefficient of the point&apos;s own y and z.</source>
        <translation>점 자신의 y와 z의 상관계수.</translation>
    </message>
    <message>
        <source>Typed, from the scatter of the points about their feature, or of what measured them: an instrument of the project, or an analysis whose results are points.</source>
        <translation>직접 입력하거나, 형체 둘레 점의 산포에서, 또는 점을 측정한 것에서 구합니다. 곧 프로젝트의 측정기, 또는 결과가 점인 분석입니다.</translation>
    </message>
    <message>
        <source>from the scatter about the feature</source>
        <translation>형체 둘레의 산포에서</translation>
    </message>
    <message>
        <source>an instrument or an analysis</source>
        <translation>측정기 또는 분석</translation>
    </message>
    <message>
        <source>Of every coordinate of every point that states none, independent of all others.</source>
        <translation>불확도를 제시하지 않은 모든 점의 모든 좌표에 대한 값, 서로 독립입니다.</translation>
    </message>
    <message>
        <source>Standard uncertainty of a deviation along x that all points share beside their own: where the instrument stands.</source>
        <translation>모든 점이 자체 편차 외에 공유하는 x 방향 편차의 표준불확도: 측정기가 놓인 곳.</translation>
    </message>
    <message>
        <source>Standard uncertainty of a deviation along y that all points share beside their own: where the instrument stands.</source>
        <translation>모든 점이 자체 편차 외에 공유하는 y 방향 편차의 표준불확도: 측정기가 놓인 곳.</translation>
    </message>
    <message>
        <source>Common u of z</source>
        <translation>z의 공통 u</translation>
    </message>
    <message>
        <source>Standard uncertainty of a deviation along z that all points share beside their own: where the instrument stands.</source>
        <translation>모든 점이 자체 편차 외에 공유하는 z 방향 편차의 표준불확도: 측정기가 놓인 곳.</translation>
    </message>
    <message>
        <source>Measured by</source>
        <translation>측정한 것</translation>
    </message>
    <message>
        <source>An instrument that stands somewhere, whose scale and station are alike for all points; or an analysis, whose points are known by their names and are evaluated with this one in every trial.</source>
        <translation>어딘가에 설치되어 스케일과 스테이션이 모든 점에 같은 측정기, 또는 점을 이름으로 알아보고 시행마다 이 분석과 함께 평가하는 분석.</translation>
    </message>
    <message>
        <source>Relation of features</source>
        <translation>형체 사이의 관계</translation>
    </message>
    <message>
        <source>Distances, angles, intersections and frames of features and points that other analyses measured, or that are typed.</source>
        <translation>다른 분석이 측정했거나 직접 입력한 형체와 점의 거리, 각, 교점과 교선, 좌표계.</translation>
    </message>
    <message>
        <source>Features are evaluated with the relations as one model in every trial: what two features have in common, as the station of their instrument, cancels where it cancels.</source>
        <translation>형체는 시행마다 관계와 함께 하나의 모델로 평가합니다. 측정기의 스테이션처럼 두 형체에 공통인 것은 상쇄되는 곳에서 상쇄됩니다.</translation>
    </message>
    <message>
        <source>A direction is that of the feature, with its sign: of a plane the normal. The angle of a line and a plane is 90° less the angle of their directions.</source>
        <translation>방향은 부호가 있는 형체의 방향이며, 평면이면 법선입니다. 직선과 평면의 각은 90°에서 두 방향의 각을 뺀 것입니다.</translation>
    </message>
    <message>
        <source>The angle of nearly parallel directions is never negative, so its estimate is too large where its uncertainty is not small; tilts have signs and no such bias.</source>
        <translation>거의 평행한 방향의 각은 음이 되지 않으므로 불확도가 작지 않으면 추정값이 너무 큽니다. 기울기는 부호가 있어 그런 편의가 없습니다.</translation>
    </message>
    <message>
        <source>A frame&apos;s angles are those of Z-Y-X: R = Rz(γ) Ry(β) Rx(α).</source>
        <translation>좌표계의 각은 Z-Y-X의 각입니다: R = Rz(γ) Ry(β) Rx(α).</translation>
    </message>
    <message>
        <source>Results of analyses (features, targets, frames&apos; origins), or typed ones, such as the direction of gravity.</source>
        <translation>분석의 결과(형체, 표적, 좌표계의 원점), 또는 중력 방향처럼 직접 입력한 것.</translation>
    </message>
    <message>
        <source>Name of the feature here, unique.</source>
        <translation>여기에서의 형체 이름, 고유해야 합니다.</translation>
    </message>
    <message>
        <source>The analysis whose result it is; empty: place and direction are typed.</source>
        <translation>이 결과를 낸 분석. 비어 있으면 위치와 방향을 직접 입력합니다.</translation>
    </message>
    <message>
        <source>Its name in that analysis: a feature, a target, &quot;apex of C1&quot;; empty: the name here.</source>
        <translation>그 분석에서의 이름: 형체, 표적, &quot;apex of C1&quot;. 비어 있으면 여기의 이름.</translation>
    </message>
    <message>
        <source>Typed coordinate x; empty: 0.</source>
        <translation>입력한 좌표 x. 비어 있으면 0.</translation>
    </message>
    <message>
        <source>Typed coordinate y; empty: 0.</source>
        <translation>입력한 좌표 y. 비어 있으면 0.</translation>
    </message>
    <message>
        <source>Typed coordinate z; empty: 0.</source>
        <translation>입력한 좌표 z. 비어 있으면 0.</translation>
    </message>
    <message>
        <source>Typed direction, component x, of any length; empty: it has none.</source>
        <translation>입력한 방향, 성분 x, 길이는 임의. 비어 있으면 방향이 없습니다.</translation>
    </message>
    <message>
        <source>Typed direction, component y, of any length; empty: it has none.</source>
        <translation>입력한 방향, 성분 y, 길이는 임의. 비어 있으면 방향이 없습니다.</translation>
    </message>
    <message>
        <source>Typed direction, component z, of any length; empty: it has none.</source>
        <translation>입력한 방향, 성분 z, 길이는 임의. 비어 있으면 방향이 없습니다.</translation>
    </message>
    <message>
        <source>Standard uncertainty of each typed coordinate; empty: none.</source>
        <translation>입력한 각 좌표의 표준불확도. 비어 있으면 없음.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the typed direction, of two tilts across it; empty: none.</source>
        <translation>입력한 방향의 표준불확도, 곧 방향에 직각인 두 기울기의 것. 비어 있으면 없음.</translation>
    </message>
    <message>
        <source>Relations</source>
        <translation>관계</translation>
    </message>
    <message>
        <source>Distances, angles, intersections and frames of the features.</source>
        <translation>형체의 거리, 각, 교점과 교선, 좌표계.</translation>
    </message>
    <message>
        <source>Name of the result, unique.</source>
        <translation>결과의 이름, 고유해야 합니다.</translation>
    </message>
    <message>
        <source>relation</source>
        <translation>관계</translation>
    </message>
    <message>
        <source>What is wanted of the features.</source>
        <translation>형체에서 구하려는 것.</translation>
    </message>
    <message>
        <source>distance of two places</source>
        <translation>두 위치의 거리</translation>
    </message>
    <message>
        <source>distance of a place from a plane</source>
        <translation>위치와 평면의 거리</translation>
    </message>
    <message>
        <source>distance of a place from a line</source>
        <translation>위치와 직선의 거리</translation>
    </message>
    <message>
        <source>distance of two lines</source>
        <translation>두 직선의 거리</translation>
    </message>
    <message>
        <source>angle of two directions</source>
        <translation>두 방향의 각</translation>
    </message>
    <message>
        <source>tilts of a direction against another</source>
        <translation>다른 방향에 대한 방향의 기울기</translation>
    </message>
    <message>
        <source>middle of two places</source>
        <translation>두 위치의 중점</translation>
    </message>
    <message>
        <source>foot of a place on a plane</source>
        <translation>평면에 내린 위치의 수선의 발</translation>
    </message>
    <message>
        <source>foot of a place on a line</source>
        <translation>직선에 내린 위치의 수선의 발</translation>
    </message>
    <message>
        <source>intersection of a line and a plane</source>
        <translation>직선과 평면의 교점</translation>
    </message>
    <message>
        <source>intersection of two lines</source>
        <translation>두 직선의 교점</translation>
    </message>
    <message>
        <source>intersection of three planes</source>
        <translation>세 평면의 교점</translation>
    </message>
    <message>
        <source>line of two planes</source>
        <translation>두 평면의 교선</translation>
    </message>
    <message>
        <source>frame: origin, z, x</source>
        <translation>좌표계: 원점, z, x</translation>
    </message>
    <message>
        <source>frame: origin on a plane, its normal z, x</source>
        <translation>좌표계: 평면 위의 원점, 법선 z, x</translation>
    </message>
    <message>
        <source>A feature: the place, line or plane that is asked about; of a frame its origin.</source>
        <translation>형체: 구하려는 위치, 직선 또는 평면. 좌표계이면 원점.</translation>
    </message>
    <message>
        <source>Another one: what it is related to; of a frame the direction of z.</source>
        <translation>다른 형체: 관계를 맺는 상대. 좌표계이면 z의 방향.</translation>
    </message>
    <message>
        <source>third</source>
        <translation>셋째</translation>
    </message>
    <message>
        <source>A third one: the third plane; of a frame and of tilts what x points to, along its direction if it has one, else towards its place.</source>
        <translation>셋째 형체: 세 번째 평면. 좌표계와 기울기에서는 x가 가리키는 것으로, 방향이 있으면 그 방향을 따르고 없으면 그 위치를 향합니다.</translation>
    </message>
    <message>
        <source>Distance meter on a baseline</source>
        <translation>기선 위의 거리계</translation>
    </message>
    <message>
        <source>Zero offset and standard deviation of a distance meter from distances between all pairs of pillars on a line, with their uncertainties, and the statistical tests of ISO 17123-4; its scale, where lengths of the baseline are known.</source>
        <translation>직선 위 모든 기둥 쌍 사이의 거리에서 구한 거리계의 영점 오프셋과 표준편차, 그 불확도, ISO 17123-4의 통계 검정. 기선의 길이가 알려져 있으면 척도도 구합니다.</translation>
    </message>
    <message>
        <source>All pairs of n pillars, read once each: the cofactor of the zero offset is 6/((n − 1)(n − 2)) whatever the lengths, and there are n (n − 1)/2 − n degrees of freedom.</source>
        <translation>기둥 n개의 모든 쌍을 한 번씩 읽으면 영점 오프셋의 여인수는 길이와 관계없이 6/((n − 1)(n − 2))이고, 자유도는 n (n − 1)/2 − n입니다.</translation>
    </message>
    <message>
        <source>Limits of the tests are quantiles of chi-squared, F and t for the degrees of freedom that the readings have, not figures of a table.</source>
        <translation>검정의 한계는 표의 수치가 아니라, 읽음값이 갖는 자유도에 대한 카이제곱, F, t의 분위수입니다.</translation>
    </message>
    <message>
        <source>Any set of readings that tells the unknowns is adjusted, also one with pairs left out or repeated; readings that repeat without the instrument set up anew agree better than the instrument does.</source>
        <translation>미지수를 알려 주는 읽음값이면 쌍이 빠지거나 반복된 것이라도 조정합니다. 측정기를 새로 설치하지 않고 반복한 읽음값은 측정기의 능력보다 더 잘 일치합니다.</translation>
    </message>
    <message>
        <source>Distances count with equal weights.</source>
        <translation>거리의 가중치는 모두 같습니다.</translation>
    </message>
    <message>
        <source>Distances between pillars that stand on a line, best of all pairs, each with the instrument set up anew.</source>
        <translation>한 직선 위에 있는 기둥 사이의 거리. 측정기를 매번 새로 설치하여 모든 쌍을 읽는 것이 가장 좋습니다.</translation>
    </message>
    <message>
        <source>Pillar of the instrument.</source>
        <translation>측정기의 기둥.</translation>
    </message>
    <message>
        <source>Pillar of the reflector.</source>
        <translation>반사경의 기둥.</translation>
    </message>
    <message>
        <source>As read, with the correction for the atmosphere and without one for the zero.</source>
        <translation>읽은 대로. 대기 보정은 하고 영점 보정은 하지 않은 값.</translation>
    </message>
    <message>
        <source>Of the reflector above the instrument, where the distance is a slope distance; empty: it is horizontal.</source>
        <translation>거리가 경사거리일 때 측정기 위로 잰 반사경의 높이. 비어 있으면 수평거리입니다.</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>시험</translation>
    </message>
    <message>
        <source>σ, stated or wanted</source>
        <translation>σ, 제시되거나 필요한 값</translation>
    </message>
    <message>
        <source>Standard deviation of one distance that test a holds s against: of the maker, or what a job needs. Empty: no test a.</source>
        <translation>검정 a에서 s와 비교하는 거리 하나의 표준편차: 제조사의 값 또는 작업에 필요한 값. 비어 있으면 검정 a 없음.</translation>
    </message>
    <message>
        <source>s of another campaign</source>
        <translation>다른 측정의 s</translation>
    </message>
    <message>
        <source>Experimental standard deviation that test b compares s with: of another instrument or day. Empty: no test b.</source>
        <translation>검정 b에서 s와 비교하는 실험표준편차: 다른 측정기 또는 다른 날의 것. 비어 있으면 검정 b 없음.</translation>
    </message>
    <message>
        <source>Its degrees of freedom</source>
        <translation>그 자유도</translation>
    </message>
    <message>
        <source>Of the s of the other campaign: 14 for all pairs of seven pillars.</source>
        <translation>다른 측정의 s의 자유도. 기둥 일곱 개의 모든 쌍이면 14.</translation>
    </message>
    <message>
        <source>Probability of the tests</source>
        <translation>검정의 확률</translation>
    </message>
    <message>
        <source>1 − α: an instrument that is as good as stated passes a test with this probability.</source>
        <translation>1 − α: 제시된 만큼 좋은 측정기는 이 확률로 검정을 통과합니다.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>척도</translation>
    </message>
    <message>
        <source>Scale correction</source>
        <translation>척도 보정</translation>
    </message>
    <message>
        <source>Readings alone say nothing of it: it needs lengths of the baseline that are known better.</source>
        <translation>읽음값만으로는 알 수 없습니다. 더 정확히 알려진 기선의 길이가 필요합니다.</translation>
    </message>
    <message>
        <source>not asked for</source>
        <translation>구하지 않음</translation>
    </message>
    <message>
        <source>by reference lengths</source>
        <translation>기준 길이에 의함</translation>
    </message>
    <message>
        <source>Reference lengths</source>
        <translation>기준 길이</translation>
    </message>
    <message>
        <source>Horizontal lengths from the pillar where the line begins, of a certificate.</source>
        <translation>기선이 시작하는 기둥에서 잰 수평 길이, 성적서의 값.</translation>
    </message>
    <message>
        <source>pillar</source>
        <translation>기둥</translation>
    </message>
    <message>
        <source>As in the readings.</source>
        <translation>읽음값에서와 같음.</translation>
    </message>
    <message>
        <source>From the pillar where the line begins.</source>
        <translation>기선이 시작하는 기둥에서.</translation>
    </message>
    <message>
        <source>Standard uncertainty of this length alone, beside what all share; empty: none.</source>
        <translation>모두가 공유하는 것 외에 이 길이만의 표준불확도. 비어 있으면 없음.</translation>
    </message>
    <message>
        <source>u of the baseline&apos;s scale</source>
        <translation>기선 척도의 u</translation>
    </message>
    <message>
        <source>Relative standard uncertainty that all reference lengths share.</source>
        <translation>모든 기준 길이가 공유하는 상대표준불확도.</translation>
    </message>
    <message>
        <source>u of the correction for the atmosphere</source>
        <translation>대기 보정의 u</translation>
    </message>
    <message>
        <source>Relative standard uncertainty that all readings share: 1 °C or 3.5 hPa are about 1 ppm.</source>
        <translation>모든 읽음값이 공유하는 상대표준불확도. 1 °C 또는 3.5 hPa가 약 1 ppm입니다.</translation>
    </message>
    <message>
        <source>Planes, circles, axes and balls through measured points, with form deviations.</source>
        <translation>측정점을 지나는 평면, 원, 축, 구와 그 형상 편차.</translation>
    </message>
    <message>
        <source>Frame, distances and angles of features</source>
        <translation>형체의 좌표계, 거리, 각</translation>
    </message>
    <message>
        <source>A frame as shops make it of a face, a bore and a hole, and where other features are from it.</source>
        <translation>현장에서 하듯이 면, 보어, 구멍으로 만드는 좌표계와, 그 좌표계에서 다른 형체가 있는 곳.</translation>
    </message>
    <message>
        <source>Zero offset and standard deviation of a distance meter, with the tests of ISO 17123-4.</source>
        <translation>거리계의 영점 오프셋과 표준편차, ISO 17123-4의 검정 포함.</translation>
    </message>
    <message>
        <source>Total station on a baseline of seven pillars</source>
        <translation>기둥 일곱 개의 기선에 놓인 토털 스테이션</translation>
    </message>
    <message>
        <source>The distance meter of a total station, tested after ISO 17123-4 with distances between all pairs of seven pillars.</source>
        <translation>토털 스테이션의 거리계를 기둥 일곱 개의 모든 쌍 사이의 거리로 ISO 17123-4에 따라 검정한 것.</translation>
    </message>
    <message>
        <source>Flange and tool of a robot, from measured points</source>
        <translation>측정점에서 구한 로봇의 플랜지와 공구</translation>
    </message>
    <message>
        <source>A laser tracker probed the flange of a robot: its face, its bore, a dowel hole, the shank of a tool and the ball at its tip.</source>
        <translation>레이저 트래커로 로봇의 플랜지를 프로빙했다: 면, 보어, 맞춤핀 구멍, 공구의 섕크, 그 끝의 볼.</translation>
    </message>
    <message>
        <source>Form deviations of a turned part</source>
        <translation>선삭 부품의 형상 편차</translation>
    </message>
    <message>
        <source>A coordinate measuring machine probed a seat, a taper, a face and a groove.</source>
        <translation>좌표 측정기로 시트, 테이퍼, 면, 홈을 프로빙했다.</translation>
    </message>
    <message>
        <source>%1, point %2, coordinate %3</source>
        <translation>%1, 점 %2, 좌표 %3</translation>
    </message>
    <message>
        <source>common deviation of all points along %1</source>
        <translation>모든 점의 %1 방향 공통 편차</translation>
    </message>
    <message>
        <source>scatter of the points of %1</source>
        <translation>%1의 점의 산포</translation>
    </message>
    <message>
        <source>residuals of %1 points about %2</source>
        <translation>%2 둘레 점 %1개의 잔차</translation>
    </message>
    <message>
        <source>an instrument measures points in space; &apos;%1&apos; lies in the xy-plane: state the uncertainty of its points</source>
        <translation>측정기는 공간의 점을 측정하는데 &apos;%1&apos;은(는) xy 평면에 있습니다. 점의 불확도를 제시하십시오</translation>
    </message>
    <message>
        <source>orthogonal distances of the points from the feature</source>
        <translation>점과 형체의 직교 거리</translation>
    </message>
    <message>
        <source>circle in its plane, cylinder</source>
        <translation>자기 평면의 원, 원통</translation>
    </message>
    <message>
        <source>cone, half angle φ</source>
        <translation>원뿔, 반각 φ</translation>
    </message>
    <message>
        <source>form deviations of m points</source>
        <translation>점 m개의 형상 편차</translation>
    </message>
    <message>
        <source>two features are called &apos;%1&apos;</source>
        <translation>두 형체의 이름이 &apos;%1&apos;입니다</translation>
    </message>
    <message>
        <source>%1 has no feature called &apos;%2&apos;</source>
        <translation>%1에 &apos;%2&apos;(이)라는 형체가 없습니다</translation>
    </message>
    <message>
        <source>%1 has no value</source>
        <translation>%1에 값이 없습니다</translation>
    </message>
    <message>
        <source>the direction of &apos;%1&apos; is zero</source>
        <translation>&apos;%1&apos;의 방향이 0입니다</translation>
    </message>
    <message>
        <source>typed coordinate</source>
        <translation>입력한 좌표</translation>
    </message>
    <message>
        <source>tilt of the typed direction</source>
        <translation>입력한 방향의 기울기</translation>
    </message>
    <message>
        <source>%1, direction along %2</source>
        <translation>%1, %2 방향 성분</translation>
    </message>
    <message>
        <source>two relations are called &apos;%1&apos;</source>
        <translation>두 관계의 이름이 &apos;%1&apos;입니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; takes two features; leave the third empty</source>
        <translation>&apos;%1&apos;은(는) 형체 둘을 취합니다. 셋째는 비워 두십시오</translation>
    </message>
    <message>
        <source>&apos;%1&apos; needs three features</source>
        <translation>&apos;%1&apos;에는 형체 셋이 필요합니다</translation>
    </message>
    <message>
        <source>there is no feature &apos;%1&apos;</source>
        <translation>형체 &apos;%1&apos;이(가) 없습니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no direction, which &apos;%2&apos; needs</source>
        <translation>&apos;%1&apos;에 방향이 없는데 &apos;%2&apos;에는 방향이 필요합니다</translation>
    </message>
    <message>
        <source>%1, distance</source>
        <translation>%1, 거리</translation>
    </message>
    <message>
        <source>%1, angle</source>
        <translation>%1, 각</translation>
    </message>
    <message>
        <source>%1, tilt towards x</source>
        <translation>%1, x 쪽 기울기</translation>
    </message>
    <message>
        <source>%1, tilt towards y</source>
        <translation>%1, y 쪽 기울기</translation>
    </message>
    <message>
        <source>%1, rotation about %2</source>
        <translation>%1, %2 둘레 회전</translation>
    </message>
    <message>
        <source>the two places are the same</source>
        <translation>두 위치가 같습니다</translation>
    </message>
    <message>
        <source>the place is on the line</source>
        <translation>위치가 직선 위에 있습니다</translation>
    </message>
    <message>
        <source>the two are parallel</source>
        <translation>둘이 평행합니다</translation>
    </message>
    <message>
        <source>the directions are parallel: ask for tilts, which have a sign</source>
        <translation>방향이 평행합니다. 부호가 있는 기울기를 구하십시오</translation>
    </message>
    <message>
        <source>the line is parallel to the plane</source>
        <translation>직선이 평면에 평행합니다</translation>
    </message>
    <message>
        <source>the three planes have no common point</source>
        <translation>세 평면에 공통점이 없습니다</translation>
    </message>
    <message>
        <source>x and z are parallel</source>
        <translation>x와 z가 평행합니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos;: %2</source>
        <translation>&apos;%1&apos;: %2</translation>
    </message>
    <message>
        <source>elementary geometry; p places, n unit directions of the first, second, third</source>
        <translation>초등 기하. p는 위치, n은 첫째, 둘째, 셋째의 단위 방향</translation>
    </message>
    <message>
        <source>from a plane; from a line the length across n₂</source>
        <translation>평면까지. 직선까지는 n₂에 직각인 길이</translation>
    </message>
    <message>
        <source>between lines</source>
        <translation>두 직선 사이</translation>
    </message>
    <message>
        <source>tilts, z = n₂</source>
        <translation>기울기, z = n₂</translation>
    </message>
    <message>
        <source>frames, v of the third</source>
        <translation>좌표계, v는 셋째의 것</translation>
    </message>
    <message>
        <source>centre of %1, %2</source>
        <translation>%1의 중심, %2</translation>
    </message>
    <message>
        <source>point on the axis of %1, %2</source>
        <translation>%1의 축 위의 점, %2</translation>
    </message>
    <message>
        <source>place of %1, %2</source>
        <translation>%1의 위치, %2</translation>
    </message>
    <message>
        <source>point on %1, %2</source>
        <translation>%1 위의 점, %2</translation>
    </message>
    <message>
        <source>normal of %1, %2</source>
        <translation>%1의 법선, %2</translation>
    </message>
    <message>
        <source>direction of the axis of %1, %2</source>
        <translation>%1의 축 방향, %2</translation>
    </message>
    <message>
        <source>direction of %1, %2</source>
        <translation>%1의 방향, %2</translation>
    </message>
    <message>
        <source>flatness deviation of %1, peak to valley</source>
        <translation>%1의 평면도 편차, 최대-최소</translation>
    </message>
    <message>
        <source>straightness deviation of %1, peak to valley</source>
        <translation>%1의 진직도 편차, 최대-최소</translation>
    </message>
    <message>
        <source>roundness deviation of %1, peak to valley</source>
        <translation>%1의 진원도 편차, 최대-최소</translation>
    </message>
    <message>
        <source>cylindricity deviation of %1, peak to valley</source>
        <translation>%1의 원통도 편차, 최대-최소</translation>
    </message>
    <message>
        <source>form deviation of %1, peak to valley</source>
        <translation>%1의 형상 편차, 최대-최소</translation>
    </message>
    <message>
        <source>diameter of %1 at its point</source>
        <translation>그 점에서 %1의 지름</translation>
    </message>
    <message>
        <source>diameter of %1</source>
        <translation>%1의 지름</translation>
    </message>
    <message>
        <source>angle of %1</source>
        <translation>%1의 각</translation>
    </message>
    <message>
        <source>form deviation of %1, root mean square</source>
        <translation>%1의 형상 편차, 제곱평균제곱근</translation>
    </message>
    <message>
        <source>apex of %1, %2</source>
        <translation>%1의 꼭짓점, %2</translation>
    </message>
    <message>
        <source>two points of &apos;%1&apos; are called &apos;%2&apos;</source>
        <translation>&apos;%1&apos;의 두 점의 이름이 &apos;%2&apos;입니다</translation>
    </message>
    <message>
        <source>%1 has no point called &apos;%2&apos;</source>
        <translation>%1에 &apos;%2&apos;(이)라는 점이 없습니다</translation>
    </message>
    <message>
        <source>point &apos;%1&apos; has no coordinate %2</source>
        <translation>점 &apos;%1&apos;에 좌표 %2이(가) 없습니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has %2 points; a %3 needs %4 or more</source>
        <translation>&apos;%1&apos;에 점이 %2개 있습니다. %3에는 %4개 이상이 필요합니다</translation>
    </message>
    <message>
        <source>the %1 points of &apos;%2&apos; do not scatter: with so few the form goes through all of them; add points, or state their uncertainty</source>
        <translation>&apos;%2&apos;의 점 %1개가 흩어지지 않습니다. 점이 이렇게 적으면 형상이 모든 점을 지납니다. 점을 추가하거나 그 불확도를 제시하십시오</translation>
    </message>
    <message>
        <source>the points of &apos;%1&apos;: %2</source>
        <translation>&apos;%1&apos;의 점: %2</translation>
    </message>
    <message>
        <source>the points of &apos;%1&apos; lie exactly on it: their scatter says nothing of their uncertainty</source>
        <translation>&apos;%1&apos;의 점이 정확히 그 위에 있습니다. 그 산포로는 불확도를 알 수 없습니다</translation>
    </message>
    <message>
        <source>they are so nearly flat or straight that they determine no radius</source>
        <translation>거의 평면이거나 직선이어서 반지름을 정할 수 없습니다</translation>
    </message>
    <message>
        <source>no %1 that fits them was found</source>
        <translation>점에 맞는 %1을(를) 찾지 못했습니다</translation>
    </message>
    <message>
        <source>all of them are the same</source>
        <translation>모두 같습니다</translation>
    </message>
    <message>
        <source>they are too far from each other</source>
        <translation>서로 너무 멀리 떨어져 있습니다</translation>
    </message>
    <message>
        <source>they lie on a straight line</source>
        <translation>한 직선 위에 있습니다</translation>
    </message>
    <message>
        <source>they lie on a plane</source>
        <translation>한 평면 위에 있습니다</translation>
    </message>
    <message>
        <source>How well the points determine the features</source>
        <translation>점으로 형체가 정해지는 정도</translation>
    </message>
    <message>
        <source>at a standard deviation of 1 mm</source>
        <translation>표준편차 1 mm일 때</translation>
    </message>
    <message>
        <source>at the scatter of the points</source>
        <translation>점의 산포일 때</translation>
    </message>
    <message>
        <source>Standard uncertainties that independent deviations of all coordinates alike would give, first with a standard deviation of 1 mm: they depend on where the points are alone. Places and tilts are along the directions in which they are largest and smallest.</source>
        <translation>모든 좌표에 같은 크기의 독립 편차가 주는 표준불확도. 먼저 표준편차 1 mm인 경우이며, 이는 점이 놓인 곳에만 따릅니다. 위치와 기울기는 불확도가 가장 크고 가장 작은 방향으로 나타냅니다.</translation>
    </message>
    <message>
        <source>place across the axis</source>
        <translation>축에 직각인 위치</translation>
    </message>
    <message>
        <source>place</source>
        <translation>위치</translation>
    </message>
    <message>
        <source>offset across the line</source>
        <translation>직선에 직각인 오프셋</translation>
    </message>
    <message>
        <source>offset along the normal</source>
        <translation>법선 방향 오프셋</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>지름</translation>
    </message>
    <message>
        <source>angle of the cone</source>
        <translation>원뿔의 각</translation>
    </message>
    <message>
        <source>correlation of diameter and centre along the middle of the arc</source>
        <translation>지름과, 호의 가운데 방향 중심의 상관</translation>
    </message>
    <message>
        <source>angle to both sides of that middle within which the points are</source>
        <translation>점들이 놓인 범위인, 그 가운데에서 양쪽으로의 각</translation>
    </message>
    <message>
        <source>Features and the scatter of their points</source>
        <translation>형체와 그 점의 산포</translation>
    </message>
    <message>
        <source>largest deviation</source>
        <translation>최대 편차</translation>
    </message>
    <message>
        <source>s is the root of the sum of squares of the deviations over the degrees of freedom.</source>
        <translation>s는 편차의 제곱합을 자유도로 나눈 값의 제곱근입니다.</translation>
    </message>
    <message>
        <source>Deviations of the points from their features</source>
        <translation>형체에서 벗어난 점의 편차</translation>
    </message>
    <message>
        <source>above the plane of the circle</source>
        <translation>원의 평면 위</translation>
    </message>
    <message>
        <source>Positive outside of a circle, sphere, cylinder or cone and on the side of a plane to which its normal points; of a line in space the distance.</source>
        <translation>원, 구, 원통, 원뿔의 바깥쪽과, 평면의 법선이 향하는 쪽에서 양입니다. 공간의 직선이면 거리입니다.</translation>
    </message>
    <message>
        <source>the points of &apos;%1&apos; are within %2° of the middle of their arc: its diameter has %3 times the standard uncertainty of a coordinate and correlates with the place of the centre by %4</source>
        <translation>&apos;%1&apos;의 점이 호의 가운데에서 %2° 이내에 있습니다. 그 지름의 표준불확도는 좌표의 %3배이고, 중심의 위치와 %4의 상관을 갖습니다</translation>
    </message>
    <message>
        <source>apex of %1</source>
        <translation>%1의 꼭짓점</translation>
    </message>
    <message>
        <source>all pairs of pillars, ISO 17123-4</source>
        <translation>기둥의 모든 쌍, ISO 17123-4</translation>
    </message>
    <message>
        <source>N distances between n pillars; JCGM 100 H.3.2</source>
        <translation>기둥 n개 사이의 거리 N개. JCGM 100 H.3.2</translation>
    </message>
    <message>
        <source>JCGM 100 E.4.3</source>
        <translation>JCGM 100 E.4.3</translation>
    </message>
    <message>
        <source>scale, by the reference lengths L_j</source>
        <translation>척도, 기준 길이 L_j에 의함</translation>
    </message>
    <message>
        <source>scatter of the distances</source>
        <translation>거리의 산포</translation>
    </message>
    <message>
        <source>least squares, residuals of %1 distances</source>
        <translation>최소제곱, 거리 %1개의 잔차</translation>
    </message>
    <message>
        <source>zero offset</source>
        <translation>영점 오프셋</translation>
    </message>
    <message>
        <source>place of pillar %1</source>
        <translation>기둥 %1의 위치</translation>
    </message>
    <message>
        <source>standard deviation of one distance</source>
        <translation>거리 하나의 표준편차</translation>
    </message>
    <message>
        <source>few degrees of freedom of s</source>
        <translation>s의 자유도가 적음</translation>
    </message>
    <message>
        <source>reference lengths and their conditions</source>
        <translation>기준 길이와 그 조건</translation>
    </message>
    <message>
        <source>scale of the readings by the atmosphere</source>
        <translation>대기에 의한 읽음값의 척도</translation>
    </message>
    <message>
        <source>correction for the atmosphere</source>
        <translation>대기 보정</translation>
    </message>
    <message>
        <source>scale of the baseline</source>
        <translation>기선의 척도</translation>
    </message>
    <message>
        <source>reference length of pillar %1</source>
        <translation>기둥 %1의 기준 길이</translation>
    </message>
    <message>
        <source>reference length</source>
        <translation>기준 길이</translation>
    </message>
    <message>
        <source>zero offset, added to a reading</source>
        <translation>영점 오프셋, 읽음값에 더함</translation>
    </message>
    <message>
        <source>scale correction, times a reading</source>
        <translation>척도 보정, 읽음값에 곱함</translation>
    </message>
    <message>
        <source>the readings do not tell the zero offset from the lengths: some line of three pillars must be read whole and in parts</source>
        <translation>읽음값으로 영점 오프셋과 길이를 구별할 수 없습니다. 기둥 세 개의 어떤 직선을 전체와 부분으로 모두 읽어야 합니다</translation>
    </message>
    <message>
        <source>a distance from pillar &apos;%1&apos; to itself</source>
        <translation>기둥 &apos;%1&apos;에서 자신까지의 거리</translation>
    </message>
    <message>
        <source>the height difference in row %1 is not shorter than the slope distance</source>
        <translation>%1행의 높이차가 경사거리보다 짧지 않습니다</translation>
    </message>
    <message>
        <source>a zero offset needs distances between three pillars or more</source>
        <translation>영점 오프셋에는 셋 이상의 기둥 사이의 거리가 필요합니다</translation>
    </message>
    <message>
        <source>%1 distances for %2 lengths and the zero offset leave nothing that would tell the scatter: read more pairs of pillars</source>
        <translation>길이 %2개와 영점 오프셋에 대한 거리 %1개로는 산포를 알려 줄 것이 남지 않습니다. 기둥 쌍을 더 읽으십시오</translation>
    </message>
    <message>
        <source>the distances do not connect all pillars</source>
        <translation>거리가 모든 기둥을 연결하지 않습니다</translation>
    </message>
    <message>
        <source>pillar &apos;%1&apos; has two reference lengths</source>
        <translation>기둥 &apos;%1&apos;에 기준 길이가 둘 있습니다</translation>
    </message>
    <message>
        <source>no reading is to or from pillar &apos;%1&apos;</source>
        <translation>기둥 &apos;%1&apos;을(를) 오가는 읽음값이 없습니다</translation>
    </message>
    <message>
        <source>reference lengths begin at pillar &apos;%1&apos;</source>
        <translation>기준 길이는 기둥 &apos;%1&apos;에서 시작합니다</translation>
    </message>
    <message>
        <source>a: s is not larger than the stated σ</source>
        <translation>a: s가 제시된 σ보다 크지 않음</translation>
    </message>
    <message>
        <source>b: s and the s of the other campaign are of one σ, s²/s²</source>
        <translation>b: s와 다른 측정의 s가 같은 σ의 것임, s²/s²</translation>
    </message>
    <message>
        <source>c: the zero offset is not different from zero</source>
        <translation>c: 영점 오프셋이 0과 다르지 않음</translation>
    </message>
    <message>
        <source>A zero offset is seen: add it to readings, or enter it in the instrument.</source>
        <translation>영점 오프셋이 드러납니다. 읽음값에 더하거나 측정기에 입력하십시오.</translation>
    </message>
    <message>
        <source>pillars</source>
        <translation>기둥</translation>
    </message>
    <message>
        <source>s of one distance</source>
        <translation>거리 하나의 s</translation>
    </message>
    <message>
        <source>standard uncertainty of s</source>
        <translation>s의 표준불확도</translation>
    </message>
    <message>
        <source>standard uncertainty of the zero offset</source>
        <translation>영점 오프셋의 표준불확도</translation>
    </message>
    <message>
        <source>cofactor of the zero offset</source>
        <translation>영점 오프셋의 여인수</translation>
    </message>
    <message>
        <source>residual over its s</source>
        <translation>잔차를 그 s로 나눈 값</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>통과</translation>
    </message>
    <message>
        <source>not passed</source>
        <translation>불통과</translation>
    </message>
    <message>
        <source>line of the baseline</source>
        <translation>기선의 직선</translation>
    </message>
    <message>
        <source>baseline</source>
        <translation>기선</translation>
    </message>
    <message>
        <source>scatter</source>
        <translation>산포</translation>
    </message>
    <message>
        <source>the name of the file says that it is a %1</source>
        <translation>파일 이름에 따르면 %1입니다</translation>
    </message>
    <message>
        <source>the file does not say which form its points have: a %1 is fitted; choose another one in the table of features</source>
        <translation>파일은 점의 형상을 밝히지 않습니다. %1(으)로 맞춥니다. 형체의 표에서 다른 것을 고르십시오</translation>
    </message>
    <message>
        <source>the first line is not a number of points</source>
        <translation>첫 줄이 점의 개수가 아닙니다</translation>
    </message>
    <message>
        <source>x y z were expected, %1 columns found</source>
        <translation>x y z가 와야 하지만 열 %1개가 있습니다</translation>
    </message>
    <message>
        <source>the first line announces %1 points, but there are %2</source>
        <translation>첫 줄은 점 %1개라고 하지만 %2개가 있습니다</translation>
    </message>
    <message>
        <source>what stands behind the %1 points</source>
        <translation>점 %1개 뒤에 있는 것</translation>
    </message>
    <message>
        <source>%1 points; their uncertainty is taken from their scatter about the form</source>
        <translation>점 %1개. 불확도는 형상 둘레의 산포에서 구합니다</translation>
    </message>
    <message>
        <source>%1 points; state their uncertainty: the file says nothing of it</source>
        <translation>점 %1개. 그 불확도를 제시하십시오. 파일에는 이에 대한 내용이 없습니다</translation>
    </message>
    <message>
        <source>List of coordinates (NIST .ds)</source>
        <translation>좌표 목록(NIST .ds)</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>결과표</translation>
    </message>
    <message>
        <source>Statistical tests</source>
        <translation>통계 검정</translation>
    </message>
    <message>
        <source>test</source>
        <translation>검정</translation>
    </message>
    <message>
        <source>Lengths of the baseline</source>
        <translation>기선의 길이</translation>
    </message>
    <message>
        <source>Readings and their residuals</source>
        <translation>읽음값과 그 잔차</translation>
    </message>
    <message>
        <source>Residuals of the distances</source>
        <translation>거리의 잔차</translation>
    </message>
    <message>
        <source>−s</source>
        <translation>−s</translation>
    </message>
    <message>
        <source>Uncertainties of the points are used</source>
        <translation>점의 불확도 사용</translation>
    </message>
    <message>
        <source>As stated; or as the residuals of least-squares frames see them: stated ones times one common factor, or times the factor of each figure (variance components). Either has the degrees of freedom of its estimate. What all points share stays as stated.</source>
        <translation>제시된 대로, 또는 최소제곱 좌표계의 잔차에서 드러난 대로: 제시된 값에 공통 인자 하나를 곱하거나, 수치마다의 인자를 곱합니다(분산성분). 어느 쪽이든 그 추정의 자유도를 갖습니다. 모든 점이 공유하는 것은 제시된 대로 둡니다.</translation>
    </message>
    <message>
        <source>Zero, scale, refraction, index and collimation of an instrument are unknowns with or without a prior, which all of its readings share.</source>
        <translation>측정기의 영점, 척도, 굴절, 지표 오차, 시준 오차는 사전분포가 있거나 없는 미지수이며, 그 측정기의 모든 읽음값이 공유합니다.</translation>
    </message>
    <message>
        <source>Map projections are not part of it: reduce the readings before. The curvature of the Earth counts in zenith angles where its radius is given.</source>
        <translation>지도 투영은 다루지 않습니다. 읽음값을 미리 환산하십시오. 지구의 반지름을 주면 천정각에서 지구의 곡률을 고려합니다.</translation>
    </message>
    <message>
        <source>Which instrument read it: readings of one kind by one instrument rest on one figure when stated uncertainties are held against the residuals, and share its figures.</source>
        <translation>이 값을 읽은 측정기. 제시된 불확도를 잔차와 비교할 때 한 측정기가 읽은 같은 종류의 읽음값은 하나의 수치를 따르며, 측정기의 수치를 공유합니다.</translation>
    </message>
    <message>
        <source>A reading that is left out stays in the table, and is told among those left out.</source>
        <translation>뺀 읽음값은 표에 남으며, 뺀 것들 가운데 표시합니다.</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>뺌</translation>
    </message>
    <message>
        <source>Figures as seen in</source>
        <translation>드러난 수치의 출처</translation>
    </message>
    <message>
        <source>Another network, rounds of a total station say, whose residuals see what its readings are worth. Readings of the same kind and instrument get the standard uncertainty that it sees, with its degrees of freedom, and follow its readings; others stay as stated here.</source>
        <translation>다른 망, 예를 들어 토털 스테이션의 대회로서, 그 잔차에서 읽음값의 정도가 드러납니다. 같은 종류와 측정기의 읽음값은 거기에서 드러난 표준불확도와 그 자유도를 가지며 그 읽음값을 따라 바뀝니다. 나머지는 여기에 제시된 대로 둡니다.</translation>
    </message>
    <message>
        <source>Figures of instruments</source>
        <translation>측정기의 수치</translation>
    </message>
    <message>
        <source>What an instrument does to all of its readings alike, with what is known of it.</source>
        <translation>측정기가 자신의 모든 읽음값에 똑같이 미치는 영향과, 그에 대해 알려진 것.</translation>
    </message>
    <message>
        <source>Name of the instrument, as in the column of the readings; empty: of all readings without one.</source>
        <translation>읽음값의 열에 있는 것과 같은 측정기의 이름. 비어 있으면 측정기가 없는 모든 읽음값.</translation>
    </message>
    <message>
        <source>zero of distances</source>
        <translation>거리의 영점</translation>
    </message>
    <message>
        <source>refraction coefficient</source>
        <translation>굴절 계수</translation>
    </message>
    <message>
        <source>vertical index</source>
        <translation>연직 지표 오차</translation>
    </message>
    <message>
        <source>knowledge</source>
        <translation>알려진 정도</translation>
    </message>
    <message>
        <source>Unknown: the readings tell it; stated with u: its value is one more reading, which all of the instrument&apos;s share; fixed without uncertainty.</source>
        <translation>미지: 읽음값으로 구합니다. u와 함께 제시: 그 값이 또 하나의 읽음값이며 측정기의 모든 읽음값이 공유합니다. 고정: 불확도가 없습니다.</translation>
    </message>
    <message>
        <source>The zero; 0 where it is empty.</source>
        <translation>영점. 비어 있으면 0.</translation>
    </message>
    <message>
        <source>Standard uncertainty of a stated zero.</source>
        <translation>제시된 영점의 표준불확도.</translation>
    </message>
    <message>
        <source>The scale beyond 1, or the refraction coefficient.</source>
        <translation>1을 넘는 척도 부분, 또는 굴절 계수.</translation>
    </message>
    <message>
        <source>u of ratio</source>
        <translation>비의 u</translation>
    </message>
    <message>
        <source>Standard uncertainty of a stated scale or refraction coefficient.</source>
        <translation>제시된 척도나 굴절 계수의 표준불확도.</translation>
    </message>
    <message>
        <source>The index or collimation; 0 where it is empty.</source>
        <translation>지표 오차 또는 시준 오차. 비어 있으면 0.</translation>
    </message>
    <message>
        <source>Standard uncertainty of a stated index or collimation.</source>
        <translation>제시된 지표 오차나 시준 오차의 표준불확도.</translation>
    </message>
    <message>
        <source>Radius of the Earth</source>
        <translation>지구의 반지름</translation>
    </message>
    <message>
        <source>Where the curvature of the Earth counts in zenith angles; empty: it does not.</source>
        <translation>천정각에서 지구의 곡률을 고려할 때의 값. 비어 있으면 고려하지 않습니다.</translation>
    </message>
    <message>
        <source>Refraction coefficient</source>
        <translation>굴절 계수</translation>
    </message>
    <message>
        <source>Of zenith angles, where the curvature of the Earth counts and no instrument states its own.</source>
        <translation>지구의 곡률을 고려하고 측정기가 자신의 계수를 제시하지 않을 때의 천정각에 씁니다.</translation>
    </message>
    <message>
        <source>What is left out</source>
        <translation>빼는 것</translation>
    </message>
    <message>
        <source>Gross readings beyond</source>
        <translation>큰 오차의 한계</translation>
    </message>
    <message>
        <source>Readings that miss what the others agree on (a robust adjustment) by more, an angle at its target, are left out; empty: none.</source>
        <translation>다른 것들이 일치하는 바(로버스트 조정)에서 이보다 더 벗어나는 읽음값을 뺍니다. 각은 표적에서의 거리로 셉니다. 비어 있으면 빼지 않습니다.</translation>
    </message>
    <message>
        <source>Points that nothing tells</source>
        <translation>알 수 없는 점</translation>
    </message>
    <message>
        <source>They are refused, by name; or left out with their readings, and told.</source>
        <translation>이름을 들어 거부하거나, 그 읽음값과 함께 빼고 알립니다.</translation>
    </message>
    <message>
        <source>are refused</source>
        <translation>거부</translation>
    </message>
    <message>
        <source>are left out</source>
        <translation>뺌</translation>
    </message>
    <message>
        <source>Outliers</source>
        <translation>이상값</translation>
    </message>
    <message>
        <source>All readings are kept, and the adjustment says which contradict the others; or the search begins robustly (Huber&apos;s weights), and readings with |w| beyond 3.29 are left out, each with its reason.</source>
        <translation>모든 읽음값을 유지하고 조정이 다른 것들과 모순되는 것을 알리거나, 로버스트하게(Huber의 가중치) 탐색을 시작하여 |w|가 3.29를 넘는 읽음값을 각각 이유와 함께 뺍니다.</translation>
    </message>
    <message>
        <source>are kept</source>
        <translation>유지</translation>
    </message>
    <message>
        <source>robust start, and left out</source>
        <translation>로버스트 시작, 뺌</translation>
    </message>
    <message>
        <source>Uncertainties of the points</source>
        <translation>점의 불확도</translation>
    </message>
    <message>
        <source>As stated; or as the distances of the points from their circles see them: stated ones times one common factor, or times the factor of each figure (variance components). Either has the degrees of freedom of its estimate. What all points share stays as stated.</source>
        <translation>제시된 대로, 또는 점과 그 원 사이의 거리에서 드러난 대로: 제시된 값에 공통 인자 하나를 곱하거나, 수치마다의 인자를 곱합니다(분산성분). 어느 쪽이든 그 추정의 자유도를 갖습니다. 모든 점이 공유하는 것은 제시된 대로 둡니다.</translation>
    </message>
    <message>
        <source>Uncertainties of points and readings</source>
        <translation>점과 읽음값의 불확도</translation>
    </message>
    <message>
        <source>As stated; or as the residuals of this fit see them: stated ones times one common factor, or times the factor of each figure (variance components). Either has the degrees of freedom of its estimate. What all poses share stays as stated.</source>
        <translation>제시된 대로, 또는 이 맞춤의 잔차에서 드러난 대로: 제시된 값에 공통 인자 하나를 곱하거나, 수치마다의 인자를 곱합니다(분산성분). 어느 쪽이든 그 추정의 자유도를 갖습니다. 모든 포즈가 공유하는 것은 제시된 대로 둡니다.</translation>
    </message>
    <message>
        <source>Stated ones weigh the points and are used as they are; or they are used as the residuals see them: times one common factor, or times one of x and one of y. Either has the degrees of freedom of its estimate. What all points share stays as stated.</source>
        <translation>제시된 값은 점의 가중치를 정하고 그대로 쓰거나, 잔차에서 드러난 대로 씁니다. 공통 인자 하나를 곱하거나, x와 y에 인자를 하나씩 곱합니다. 어느 쪽이든 그 추정의 자유도를 갖습니다. 모든 점이 공유하는 것은 제시된 대로 둡니다.</translation>
    </message>
    <message>
        <source>Accuracy and repeatability of poses</source>
        <translation>포즈의 정확도와 반복성</translation>
    </message>
    <message>
        <source>What ISO 9283 asks of a robot, from measured poses: AP and RP, distances, directions of approach, drift; with the uncertainty that few cycles and the instrument leave, and decisions about a maker&apos;s figures.</source>
        <translation>측정한 포즈에서 구하는, ISO 9283이 로봇에 요구하는 것: AP와 RP, 거리, 접근 방향, 드리프트. 적은 사이클과 측정기에서 오는 불확도와, 제조사 수치에 대한 판정을 포함합니다.</translation>
    </message>
    <message>
        <source>RP of the standard comes out too small from few cycles: by 2 % from 30 and 7 % from 10, where the scatter is alike in all directions. The result is multiplied by what that is for the shape of the scatter seen; the table gives RP as the standard defines it beside it.</source>
        <translation>표준의 RP는 사이클이 적으면 너무 작게 나옵니다. 산포가 모든 방향에서 같을 때 30회이면 2 %, 10회이면 7 % 작습니다. 결과에는 드러난 산포의 모양에 해당하는 인자를 곱합니다. 표에는 표준이 정의하는 RP를 함께 보입니다.</translation>
    </message>
    <message>
        <source>Scatter is taken to be normal. The law of RP for the number of cycles and the shape of the scatter comes from up to 4,000 simulated campaigns, always the same ones.</source>
        <translation>산포는 정규로 봅니다. 사이클 수와 산포의 모양에 따른 RP의 분포는 최대 4,000번의 모의 측정에서 구하며, 언제나 같은 것을 씁니다.</translation>
    </message>
    <message>
        <source>Limits and numbers of cycles of the standard are not built in: what is held against a figure is what is entered. Formulas of directions, distances and drift are those in common use; hold them against the text of the standard before a sheet names it.</source>
        <translation>표준의 한계와 사이클 수는 내장되어 있지 않습니다. 수치와 비교하는 것은 입력한 값입니다. 방향, 거리, 드리프트의 식은 널리 쓰이는 것입니다. 결과표에 표준을 적기 전에 그 본문과 대조하십시오.</translation>
    </message>
    <message>
        <source>RP² is split between robot and instrument as if both scattered in one shape.</source>
        <translation>RP²는 로봇과 측정기가 같은 모양으로 흩어지는 것으로 보고 나눕니다.</translation>
    </message>
    <message>
        <source>Commanded poses</source>
        <translation>지령 포즈</translation>
    </message>
    <message>
        <source>Where the robot was sent to.</source>
        <translation>로봇을 보낸 곳.</translation>
    </message>
    <message>
        <source>Name, unique: P1.</source>
        <translation>이름, 고유해야 합니다: P1.</translation>
    </message>
    <message>
        <source>Commanded coordinate x in the base of the robot.</source>
        <translation>로봇의 베이스 좌표계에서 지령 좌표 x.</translation>
    </message>
    <message>
        <source>Commanded coordinate y in the base of the robot.</source>
        <translation>로봇의 베이스 좌표계에서 지령 좌표 y.</translation>
    </message>
    <message>
        <source>Commanded coordinate z in the base of the robot.</source>
        <translation>로봇의 베이스 좌표계에서 지령 좌표 z.</translation>
    </message>
    <message>
        <source>Commanded angle of the orientation; empty: orientations are not evaluated.</source>
        <translation>자세의 지령 각도. 비어 있으면 자세를 평가하지 않습니다.</translation>
    </message>
    <message>
        <source>Attained poses</source>
        <translation>도달 포즈</translation>
    </message>
    <message>
        <source>A row for every cycle in the order of measurement, typed, pasted or from a CSV file. The coordinates are those of the robot&apos;s base.</source>
        <translation>측정 순서대로 사이클마다 한 행. 직접 입력하거나 붙여넣거나 CSV 파일에서 읽습니다. 좌표는 로봇의 베이스 좌표계의 것입니다.</translation>
    </message>
    <message>
        <source>As in the commanded poses.</source>
        <translation>지령 포즈에서와 같음.</translation>
    </message>
    <message>
        <source>From where the pose was approached, where there are several ways; empty: one for all.</source>
        <translation>접근하는 길이 여럿일 때 포즈에 접근한 곳. 비어 있으면 모두 하나의 길.</translation>
    </message>
    <message>
        <source>Of the series of cycles, where it is repeated to see a drift; empty: there is one series.</source>
        <translation>드리프트를 보려고 반복할 때 사이클 계열의 번호. 비어 있으면 계열은 하나입니다.</translation>
    </message>
    <message>
        <source>Attained coordinate x in the base of the robot.</source>
        <translation>로봇의 베이스 좌표계에서 도달 좌표 x.</translation>
    </message>
    <message>
        <source>Attained coordinate y in the base of the robot.</source>
        <translation>로봇의 베이스 좌표계에서 도달 좌표 y.</translation>
    </message>
    <message>
        <source>Attained coordinate z in the base of the robot.</source>
        <translation>로봇의 베이스 좌표계에서 도달 좌표 z.</translation>
    </message>
    <message>
        <source>Attained angle of the orientation.</source>
        <translation>자세의 도달 각도.</translation>
    </message>
    <message>
        <source>Pairs of poses whose distance is held against the commanded one, cycle by cycle.</source>
        <translation>거리를 지령 거리와 사이클별로 비교하는 포즈 쌍.</translation>
    </message>
    <message>
        <source>A commanded pose.</source>
        <translation>지령 포즈.</translation>
    </message>
    <message>
        <source>Another one, with as many cycles.</source>
        <translation>사이클 수가 같은 다른 지령 포즈.</translation>
    </message>
    <message>
        <source>u of a measured coordinate</source>
        <translation>측정한 좌표의 u</translation>
    </message>
    <message>
        <source>Standard uncertainty that all cycles of a pose share: of the instrument and of the robot&apos;s base in its frame. It is part of u(AP), not of RP.</source>
        <translation>한 포즈의 모든 사이클이 공유하는 표준불확도: 측정기의 것과, 측정기의 좌표계에서 로봇 베이스의 것. RP가 아니라 u(AP)에 들어갑니다.</translation>
    </message>
    <message>
        <source>Scatter of the instrument</source>
        <translation>측정기의 산포</translation>
    </message>
    <message>
        <source>What the instrument scatters by itself is part of RP. Where it is known, RP² less its RP² is that of the robot, if both scatter alike in all directions.</source>
        <translation>측정기 자신의 산포는 RP의 일부입니다. 이를 알면, 둘이 모든 방향으로 똑같이 흩어질 때 RP²에서 측정기의 RP²를 뺀 것이 로봇의 것입니다.</translation>
    </message>
    <message>
        <source>not taken out</source>
        <translation>빼지 않음</translation>
    </message>
    <message>
        <source>its RP from a fixed target</source>
        <translation>고정 표적에서 구한 그 RP</translation>
    </message>
    <message>
        <source>readings of a fixed target</source>
        <translation>고정 표적의 읽음값</translation>
    </message>
    <message>
        <source>RP of the instrument alone</source>
        <translation>측정기만의 RP</translation>
    </message>
    <message>
        <source>l̄ + 3 s of readings of a fixed target, as measured in the cell.</source>
        <translation>셀에서 측정한 고정 표적의 읽음값에 대한 l̄ + 3 s.</translation>
    </message>
    <message>
        <source>Its readings</source>
        <translation>그 읽음값의 수</translation>
    </message>
    <message>
        <source>Number of readings that it is taken from: so well is it known.</source>
        <translation>그것을 구한 읽음값의 개수. 그만큼 잘 알려져 있습니다.</translation>
    </message>
    <message>
        <source>Readings of a fixed target</source>
        <translation>고정 표적의 읽음값</translation>
    </message>
    <message>
        <source>Coordinates of a target that does not move, read as the poses were.</source>
        <translation>포즈를 읽은 것처럼 읽은, 움직이지 않는 표적의 좌표.</translation>
    </message>
    <message>
        <source>Read coordinate x.</source>
        <translation>읽은 좌표 x.</translation>
    </message>
    <message>
        <source>Read coordinate y.</source>
        <translation>읽은 좌표 y.</translation>
    </message>
    <message>
        <source>Read coordinate z.</source>
        <translation>읽은 좌표 z.</translation>
    </message>
    <message>
        <source>Decisions</source>
        <translation>판정</translation>
    </message>
    <message>
        <source>Rated AP</source>
        <translation>정격 AP</translation>
    </message>
    <message>
        <source>The maker&apos;s figure; empty: nothing is decided.</source>
        <translation>제조사의 수치. 비어 있으면 판정하지 않습니다.</translation>
    </message>
    <message>
        <source>Rated RP</source>
        <translation>정격 RP</translation>
    </message>
    <message>
        <source>Probability of a decision</source>
        <translation>판정의 확률</translation>
    </message>
    <message>
        <source>A robot conforms where this is the probability that its figure is not above the rated one.</source>
        <translation>로봇의 수치가 정격 값을 넘지 않을 확률이 이 값이면 로봇은 적합합니다.</translation>
    </message>
    <message>
        <source>U of the instrument</source>
        <translation>측정기의 U</translation>
    </message>
    <message>
        <source>Expanded uncertainty of the measured position, k = 2; empty: it is not held against AP and RP.</source>
        <translation>측정한 위치의 확장불확도, k = 2. 비어 있으면 AP, RP와 비교하지 않습니다.</translation>
    </message>
    <message>
        <source>Largest ratio of U to AP, RP</source>
        <translation>U와 AP, RP의 최대 비</translation>
    </message>
    <message>
        <source>What the standard or the contract allows, as it says it.</source>
        <translation>표준이나 계약이 허용하는 값을 거기에 적힌 대로.</translation>
    </message>
    <message>
        <source>Two-face and length tests of a tracker</source>
        <translation>트래커의 양면 시험과 길이 시험</translation>
    </message>
    <message>
        <source>Errors of a laser tracker at the positions of its acceptance test, with the uncertainty of the test, and the decision whether they are within the maximum permissible errors.</source>
        <translation>인수 시험의 위치에서 레이저 트래커의 오차와 시험의 불확도, 그리고 오차가 최대 허용 오차 안에 있는지에 대한 판정.</translation>
    </message>
    <message>
        <source>Positions, numbers of repetitions and limits are those that are entered: none of a standard is built in.</source>
        <translation>위치, 반복 횟수, 한계는 입력한 값입니다. 어떤 표준의 것도 내장되어 있지 않습니다.</translation>
    </message>
    <message>
        <source>The uncertainty of a test value is what the test adds, not the scatter of the tracker: that is what is tested.</source>
        <translation>시험값의 불확도는 시험이 더하는 것이며 트래커의 산포가 아닙니다. 산포는 시험의 대상입니다.</translation>
    </message>
    <message>
        <source>A row for every position, typed, pasted or from a CSV file.</source>
        <translation>위치마다 한 행. 직접 입력하거나 붙여넣거나 CSV 파일에서 읽습니다.</translation>
    </message>
    <message>
        <source>Number or name of the position, unique.</source>
        <translation>위치의 번호나 이름, 고유해야 합니다.</translation>
    </message>
    <message>
        <source>Two-face: a fixed target read in both faces. Length: a reference length.</source>
        <translation>양면: 고정 표적을 정위와 반위로 읽음. 길이: 기준 길이.</translation>
    </message>
    <message>
        <source>two-face</source>
        <translation>양면</translation>
    </message>
    <message>
        <source>Two-face: distance across the beam between the readings of both faces. Length: as measured.</source>
        <translation>양면: 정위와 반위 읽음값 사이의 빔에 직각인 거리. 길이: 측정된 대로.</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>기준</translation>
    </message>
    <message>
        <source>Calibrated length, of a length test.</source>
        <translation>교정된 길이, 길이 시험의 것.</translation>
    </message>
    <message>
        <source>range</source>
        <translation>거리</translation>
    </message>
    <message>
        <source>Distance of the target, or of the middle of the length, from the tracker.</source>
        <translation>트래커에서 표적까지, 또는 길이의 가운데까지의 거리.</translation>
    </message>
    <message>
        <source>Its horizontal angle; empty: 0.</source>
        <translation>그 수평각. 비어 있으면 0.</translation>
    </message>
    <message>
        <source>Its angle above the horizon; empty: 0.</source>
        <translation>수평면 위로 잰 그 각. 비어 있으면 0.</translation>
    </message>
    <message>
        <source>Standard uncertainty of this test value; empty: that of its kind, as below.</source>
        <translation>이 시험값의 표준불확도. 비어 있으면 아래의 그 종류의 값.</translation>
    </message>
    <message>
        <source>MPE</source>
        <translation>MPE</translation>
    </message>
    <message>
        <source>Limit for this position; empty: it follows from constant and slope, as below.</source>
        <translation>이 위치의 한계. 비어 있으면 아래의 상수와 기울기에서 구합니다.</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>한계</translation>
    </message>
    <message>
        <source>MPE two-face, constant</source>
        <translation>양면 MPE, 상수</translation>
    </message>
    <message>
        <source>As the maker states it for a two-face test; empty: every two-face test has its own MPE.</source>
        <translation>제조사가 양면 시험에 제시하는 값. 비어 있으면 양면 시험마다 자체 MPE를 갖습니다.</translation>
    </message>
    <message>
        <source>MPE two-face, per metre</source>
        <translation>양면 MPE, 미터당</translation>
    </message>
    <message>
        <source>Times the range of the target.</source>
        <translation>표적의 거리를 곱합니다.</translation>
    </message>
    <message>
        <source>MPE length, constant</source>
        <translation>길이 MPE, 상수</translation>
    </message>
    <message>
        <source>As the maker states it; empty: every length has its own MPE.</source>
        <translation>제조사가 제시하는 값. 비어 있으면 길이마다 자체 MPE를 갖습니다.</translation>
    </message>
    <message>
        <source>MPE length, per metre</source>
        <translation>길이 MPE, 미터당</translation>
    </message>
    <message>
        <source>Times the reference length.</source>
        <translation>기준 길이를 곱합니다.</translation>
    </message>
    <message>
        <source>Uncertainty of the test values</source>
        <translation>시험값의 불확도</translation>
    </message>
    <message>
        <source>u of a two-face value</source>
        <translation>양면 값의 u</translation>
    </message>
    <message>
        <source>Standard uncertainty of what the test adds: seat of the reflector, motion of its mount. Not the scatter of the tracker, which is tested.</source>
        <translation>시험이 더하는 것의 표준불확도: 반사경의 받침, 거치대의 움직임. 시험 대상인 트래커의 산포는 아닙니다.</translation>
    </message>
    <message>
        <source>u of a length</source>
        <translation>길이의 u</translation>
    </message>
    <message>
        <source>Standard uncertainty of what the test adds to each length: calibration, mounting, temperature. Not the scatter of the tracker.</source>
        <translation>시험이 각 길이에 더하는 것의 표준불확도: 교정, 설치, 온도. 트래커의 산포는 아닙니다.</translation>
    </message>
    <message>
        <source>u of the scale of the references</source>
        <translation>기준 척도의 u</translation>
    </message>
    <message>
        <source>A position conforms where this is the probability that its error is within the MPE.</source>
        <translation>오차가 MPE 안에 있을 확률이 이 값이면 위치는 적합합니다.</translation>
    </message>
    <message>
        <source>Accuracy and repeatability of a robot</source>
        <translation>로봇의 정확도와 반복성</translation>
    </message>
    <message>
        <source>AP and RP of ISO 9283 from measured poses, and whether the maker&apos;s figures are met.</source>
        <translation>측정한 포즈에서 구한 ISO 9283의 AP와 RP, 그리고 제조사의 수치를 만족하는지.</translation>
    </message>
    <message>
        <source>Acceptance test of a tracker</source>
        <translation>트래커의 인수 시험</translation>
    </message>
    <message>
        <source>Two-face and length tests against their limits, with the uncertainty of the test.</source>
        <translation>양면 시험과 길이 시험을 한계와 비교, 시험의 불확도 포함.</translation>
    </message>
    <message>
        <source>Robot at five poses, thirty cycles</source>
        <translation>다섯 포즈, 서른 사이클의 로봇</translation>
    </message>
    <message>
        <source>An industrial robot, sent thirty times to each of five poses and measured by a laser tracker: AP and RP after ISO 9283 with what thirty cycles and the tracker leave open of them.</source>
        <translation>산업용 로봇을 다섯 포즈 각각에 서른 번 보내 레이저 트래커로 측정한 것: ISO 9283의 AP와 RP, 그리고 서른 사이클과 트래커가 남기는 불확실한 부분.</translation>
    </message>
    <message>
        <source>From rounds of a total station to a certificate</source>
        <translation>토털 스테이션의 대회에서 성적서까지</translation>
    </message>
    <message>
        <source>Four rounds of a total station say what its readings are worth: a network takes their figures as seen, a pose takes its points from the network, and the certificate states the pose.</source>
        <translation>토털 스테이션의 대회 네 번에서 읽음값의 정도가 드러난다. 망은 그 수치를 드러난 대로 쓰고, 포즈는 점을 망에서 얻으며, 성적서는 포즈를 기재한다.</translation>
    </message>
    <message>
        <source>Acceptance test of a laser tracker</source>
        <translation>레이저 트래커의 인수 시험</translation>
    </message>
    <message>
        <source>A laser tracker, tested with fixed reflectors read in both faces from three distances, and with a reference length of 2.3 m.</source>
        <translation>레이저 트래커를 세 거리에서 정위와 반위로 읽은 고정 반사경과 2.3 m 기준 길이로 시험한 것.</translation>
    </message>
    <message>
        <source>%1 is a temperature in %3, and here it would be taken in kelvin (20 degC as 293.15 K): if it is a difference, give it in %4; for its reading in %3 write (%2 - 0 [%3]). Only the ratio of two temperatures in %3 is taken in kelvin</source>
        <translation>%1은(는) %3 단위의 온도이며 여기서는 켈빈으로 취하게 됩니다(20 degC는 293.15 K). 온도차이면 %4(으)로 주고, %3 단위의 읽음값이면 (%2 - 0 [%3])으로 쓰십시오. %3 단위의 두 온도의 비만 켈빈으로 취합니다</translation>
    </message>
    <message>
        <source>%1 is a multiple of a temperature in %2, which depends on where the scale has its zero: if the temperature is a difference, give it in %3; else multiply its reading, as in 1.5*(t - 0 [%2])</source>
        <translation>%1은(는) %2 단위의 온도의 배수이며, 이는 눈금의 영점이 어디인지에 따라 달라집니다. 온도가 온도차이면 %3(으)로 주고, 아니면 1.5*(t - 0 [%2])처럼 읽음값을 곱하십시오</translation>
    </message>
    <message>
        <source>a part (%, ppm) or multiple of a temperature in %1 depends on where the scale has its zero: give the figure in %2</source>
        <translation>%1 단위의 온도의 일부(%, ppm)나 배수는 눈금의 영점이 어디인지에 따라 달라집니다. 수치를 %2(으)로 주십시오</translation>
    </message>
    <message>
        <source>a difference: %1 in %2</source>
        <translation>온도차: %1, 단위 %2</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; is %3; its unit is missing: write &quot;%4 [%5]&quot;</source>
        <translation>&apos;%2&apos;의 열 &apos;%1&apos;은(는) %3입니다. 단위가 없습니다. &quot;%4 [%5]&quot;(으)로 적으십시오</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; is a difference of temperatures: give it in %3, not in %4</source>
        <translation>&apos;%2&apos;의 열 &apos;%1&apos;은(는) 온도차입니다. %4이(가) 아니라 %3(으)로 주십시오</translation>
    </message>
    <message>
        <source>%1 is a difference of temperatures: give it in %2, not in %3</source>
        <translation>%1은(는) 온도차입니다. %3이(가) 아니라 %2(으)로 주십시오</translation>
    </message>
    <message>
        <source>The figures of the set-up are too far apart in size for %1: the last digits of the estimates change its sensitivity coefficients by more than a tenth. Give coordinates from a place nearby.</source>
        <translation>설정의 수치들의 크기가 %1에 대해 서로 너무 다릅니다. 추정값의 마지막 자릿수가 감도계수를 십분의 일 넘게 바꿉니다. 가까운 곳에서 잰 좌표를 주십시오.</translation>
    </message>
    <message>
        <source>uncertainties as the residuals see them</source>
        <translation>잔차에서 드러난 불확도</translation>
    </message>
    <message>
        <source>stated figures of instruments</source>
        <translation>제시된 측정기의 수치</translation>
    </message>
    <message>
        <source>%1 does not see these figures, so they stay as stated here: %2</source>
        <translation>%1에서는 이 수치들이 드러나지 않아 여기에 제시된 대로 둡니다: %2</translation>
    </message>
    <message>
        <source>readings of figures that are seen elsewhere are correlated with others here</source>
        <translation>다른 곳에서 드러난 수치의 읽음값이 여기의 다른 읽음값과 상관됩니다</translation>
    </message>
    <message>
        <source>the readings from %1 agree if the names %2 and %3 are exchanged there</source>
        <translation>거기에서 이름 %2와(과) %3을(를) 맞바꾸면 %1에서 읽은 값이 일치합니다</translation>
    </message>
    <message>
        <source>as seen in %1: %2 times what is stated here</source>
        <translation>%1에서 드러난 대로: 여기에 제시된 값의 %2배</translation>
    </message>
    <message>
        <source>the only direction of its round, whose orientation is not known</source>
        <translation>대회의 유일한 방향이며 그 표정을 알 수 없음</translation>
    </message>
    <message>
        <source>it contradicts the others: %1</source>
        <translation>다른 것들과 모순됨: %1</translation>
    </message>
    <message>
        <source>it contradicts the others: %1; it cannot be told apart from %2</source>
        <translation>다른 것들과 모순됨: %1. %2와(과) 구별할 수 없음</translation>
    </message>
    <message>
        <source>nothing tells them</source>
        <translation>이것들을 알 수 없음</translation>
    </message>
    <message>
        <source>x and y of %1</source>
        <translation>%1의 x와 y</translation>
    </message>
    <message>
        <source>the height of %1</source>
        <translation>%1의 높이</translation>
    </message>
    <message>
        <source>nothing tells it</source>
        <translation>이것을 알 수 없음</translation>
    </message>
    <message>
        <source>its point %1 is left out</source>
        <translation>그 점 %1을(를) 뺐음</translation>
    </message>
    <message>
        <source>the height of %1 is left out</source>
        <translation>%1의 높이를 뺐음</translation>
    </message>
    <message>
        <source>it misses what the others agree on by %1 m, more than %2 m</source>
        <translation>다른 것들이 일치하는 바에서 %1 m 벗어남, %2 m 초과</translation>
    </message>
    <message>
        <source>|w| = %1</source>
        <translation>|w| = %1</translation>
    </message>
    <message>
        <source>%1 times its u in a robust adjustment</source>
        <translation>로버스트 조정에서 그 u의 %1배</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>수동으로</translation>
    </message>
    <message>
        <source>%1 is left out: %2</source>
        <translation>%1을(를) 뺐습니다: %2</translation>
    </message>
    <message>
        <source>and %1 more are left out, listed with their reasons</source>
        <translation>그 밖에 %1개를 뺐으며 이유와 함께 나열합니다</translation>
    </message>
    <message>
        <source>zero c and scale m of distances, index i, refraction k</source>
        <translation>거리의 영점 c와 척도 m, 지표 오차 i, 굴절 k</translation>
    </message>
    <message>
        <source>all instruments</source>
        <translation>모든 측정기</translation>
    </message>
    <message>
        <source>the zero of %1</source>
        <translation>%1의 영점</translation>
    </message>
    <message>
        <source>the scale of %1</source>
        <translation>%1의 척도</translation>
    </message>
    <message>
        <source>the refraction coefficient of %1</source>
        <translation>%1의 굴절 계수</translation>
    </message>
    <message>
        <source>the vertical index of %1</source>
        <translation>%1의 연직 지표 오차</translation>
    </message>
    <message>
        <source>the collimation of %1</source>
        <translation>%1의 시준 오차</translation>
    </message>
    <message>
        <source>%1 is stated twice</source>
        <translation>%1이(가) 두 번 제시되었습니다</translation>
    </message>
    <message>
        <source>%1 needs the radius of the Earth</source>
        <translation>%1에는 지구의 반지름이 필요합니다</translation>
    </message>
    <message>
        <source>there is no reading that %1 would change: readings say their instrument in their column</source>
        <translation>%1이(가) 바꿀 읽음값이 없습니다. 읽음값의 측정기는 그 열에 적습니다</translation>
    </message>
    <message>
        <source>outlier? it cannot be told apart from %1</source>
        <translation>이상값? %1와(과) 구별할 수 없음</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>이유</translation>
    </message>
    <message>
        <source>the readings cannot tell %1 apart: add readings that see them differently, or state one of them</source>
        <translation>읽음값으로 %1을(를) 구별할 수 없습니다. 이들을 다르게 보는 읽음값을 추가하거나 그중 하나를 제시하십시오</translation>
    </message>
    <message>
        <source>nothing tells %1: add readings that see it, or state it with u</source>
        <translation>%1을(를) 알 수 없습니다. 이를 보는 읽음값을 추가하거나 u와 함께 제시하십시오</translation>
    </message>
    <message>
        <source>%1 readings cannot tell %2 unknowns (coordinates less what the datum takes, orientations, figures of instruments): add %3 readings at least, or state figures with u</source>
        <translation>읽음값 %1개로 미지수 %2개(데이텀이 취하는 것을 뺀 좌표, 표정, 측정기의 수치)를 알 수 없습니다. 읽음값을 %3개 이상 추가하거나 수치를 u와 함께 제시하십시오</translation>
    </message>
    <message>
        <source>instruments</source>
        <translation>측정기</translation>
    </message>
    <message>
        <source>base points, %1</source>
        <translation>기준 점, %1</translation>
    </message>
    <message>
        <source>points of the moving frame, %1</source>
        <translation>이동 좌표계의 점, %1</translation>
    </message>
    <message>
        <source>joint %1, point %2</source>
        <translation>관절 %1, 점 %2</translation>
    </message>
    <message>
        <source>%1, off the plane</source>
        <translation>%1, 평면에서 벗어남</translation>
    </message>
    <message>
        <source>%1, along the radius</source>
        <translation>%1, 반지름 방향</translation>
    </message>
    <message>
        <source>a thermodynamic temperature: %1 in %2</source>
        <translation>열역학 온도: %1, 단위 %2</translation>
    </message>
    <message>
        <source>its reading in %2: %1 - 0 [%2]</source>
        <translation>%2 단위의 그 읽음값: %1 - 0 [%2]</translation>
    </message>
    <message>
        <source>a part of its reading in %1: %2</source>
        <translation>%1 단위의 그 읽음값의 일부: %2</translation>
    </message>
    <message>
        <source>a temperature: %1 in %2</source>
        <translation>온도: %1, 단위 %2</translation>
    </message>
    <message>
        <source>y of the points</source>
        <translation>점의 y</translation>
    </message>
    <message>
        <source>x of the points</source>
        <translation>점의 x</translation>
    </message>
    <message>
        <source>the distance in row %1 is too long</source>
        <translation>%1행의 거리가 너무 깁니다</translation>
    </message>
    <message>
        <source>%1 distances between %2 pillars are more than a baseline has: at most %3 between %4</source>
        <translation>기둥 %2개 사이의 거리 %1개는 기선이 가질 수 있는 것보다 많습니다. %4개 사이에는 최대 %3개입니다</translation>
    </message>
    <message>
        <source>%1 cycles</source>
        <translation>사이클 %1회</translation>
    </message>
    <message>
        <source>few cycles</source>
        <translation>적은 사이클</translation>
    </message>
    <message>
        <source>%1 cycles, normal scatter of the shape seen</source>
        <translation>사이클 %1회, 드러난 모양의 정규 산포</translation>
    </message>
    <message>
        <source>scatter of the cycles</source>
        <translation>사이클의 산포</translation>
    </message>
    <message>
        <source>repeatability of %1</source>
        <translation>%1의 반복성</translation>
    </message>
    <message>
        <source>mean deviation of angle %1 of %2</source>
        <translation>%2의 각 %1의 평균 편차</translation>
    </message>
    <message>
        <source>repeatability of angle %1 of %2</source>
        <translation>%2의 각 %1의 반복성</translation>
    </message>
    <message>
        <source>instrument and base of the robot</source>
        <translation>측정기와 로봇의 베이스</translation>
    </message>
    <message>
        <source>error of the measured place of %1, %2</source>
        <translation>%1의 측정된 위치의 오차, %2</translation>
    </message>
    <message>
        <source>deviation of the mean distance %1</source>
        <translation>평균 거리 %1</translation>
    </message>
    <message>
        <source>repeatability of distance %1</source>
        <translation>거리 %1의 반복성</translation>
    </message>
    <message>
        <source>repeatability of the instrument alone</source>
        <translation>측정기만의 반복성</translation>
    </message>
    <message>
        <source>ISO 9283, accuracy of a pose</source>
        <translation>ISO 9283, 포즈의 정확도</translation>
    </message>
    <message>
        <source>ISO 9283, repeatability; c = RP(∞)/RP(n) by simulated campaigns</source>
        <translation>ISO 9283, 반복성. c = RP(∞)/RP(n), 모의 측정에 의함</translation>
    </message>
    <message>
        <source>without the instrument, where both scatter in one shape</source>
        <translation>측정기를 뺀 것, 둘이 같은 모양으로 흩어질 때</translation>
    </message>
    <message>
        <source>of several directions of approach</source>
        <translation>여러 접근 방향의 것</translation>
    </message>
    <message>
        <source>distances between poses</source>
        <translation>포즈 사이의 거리</translation>
    </message>
    <message>
        <source>drift</source>
        <translation>드리프트</translation>
    </message>
    <message>
        <source>accuracy of the pose</source>
        <translation>포즈의 정확도</translation>
    </message>
    <message>
        <source>repeatability of the pose</source>
        <translation>포즈의 반복성</translation>
    </message>
    <message>
        <source>repeatability of the robot alone</source>
        <translation>로봇만의 반복성</translation>
    </message>
    <message>
        <source>share of the instrument in RP²</source>
        <translation>RP²에서 측정기의 비율</translation>
    </message>
    <message>
        <source>accuracy of angle %1</source>
        <translation>각 %1의 정확도</translation>
    </message>
    <message>
        <source>repeatability of angle %1, ±</source>
        <translation>각 %1의 반복성, ±</translation>
    </message>
    <message>
        <source>variation of the accuracy over the directions of approach</source>
        <translation>접근 방향에 따른 정확도의 변동</translation>
    </message>
    <message>
        <source>drift of the accuracy</source>
        <translation>정확도의 드리프트</translation>
    </message>
    <message>
        <source>drift of the repeatability</source>
        <translation>반복성의 드리프트</translation>
    </message>
    <message>
        <source>accuracy of the distance</source>
        <translation>거리의 정확도</translation>
    </message>
    <message>
        <source>repeatability of the distance, ±</source>
        <translation>거리의 반복성, ±</translation>
    </message>
    <message>
        <source>the instrument alone scatters as much as what it measured at %1: nothing is left that could be called the robot&apos;s</source>
        <translation>%1에서 측정기만으로도 측정한 것만큼 흩어집니다. 로봇의 것이라 할 만한 것이 남지 않습니다</translation>
    </message>
    <message>
        <source>two series are called &apos;%1&apos;</source>
        <translation>두 계열의 이름이 &apos;%1&apos;입니다</translation>
    </message>
    <message>
        <source>there is no commanded pose &apos;%1&apos;</source>
        <translation>지령 포즈 &apos;%1&apos;이(가) 없습니다</translation>
    </message>
    <message>
        <source>%1 has fewer than three cycles</source>
        <translation>%1의 사이클이 셋보다 적습니다</translation>
    </message>
    <message>
        <source>row %1 has angles, though its pose is commanded without them</source>
        <translation>%1행에는 각이 있지만 그 포즈는 각 없이 지령되었습니다</translation>
    </message>
    <message>
        <source>row %1 has no angles, though its pose is commanded with them</source>
        <translation>%1행에는 각이 없지만 그 포즈는 각과 함께 지령되었습니다</translation>
    </message>
    <message>
        <source>the coordinates at %1 are too large</source>
        <translation>%1의 좌표가 너무 큽니다</translation>
    </message>
    <message>
        <source>pose &apos;%1&apos; is commanded twice</source>
        <translation>포즈 &apos;%1&apos;이(가) 두 번 지령되었습니다</translation>
    </message>
    <message>
        <source>pose &apos;%1&apos; is commanded with some angles and without others</source>
        <translation>포즈 &apos;%1&apos;이(가) 일부 각은 있고 나머지 각은 없이 지령되었습니다</translation>
    </message>
    <message>
        <source>some poses are commanded with all angles and others are not</source>
        <translation>모든 각과 함께 지령된 포즈와 그렇지 않은 포즈가 있습니다</translation>
    </message>
    <message>
        <source>no cycles were measured at pose &apos;%1&apos;</source>
        <translation>포즈 &apos;%1&apos;에서 측정한 사이클이 없습니다</translation>
    </message>
    <message>
        <source>a distance from pose &apos;%1&apos; to itself</source>
        <translation>포즈 &apos;%1&apos;에서 자신까지의 거리</translation>
    </message>
    <message>
        <source>the distance from &apos;%1&apos; to &apos;%2&apos; is there twice</source>
        <translation>&apos;%1&apos;에서 &apos;%2&apos;까지의 거리가 두 번 있습니다</translation>
    </message>
    <message>
        <source>poses &apos;%1&apos; and &apos;%2&apos; have different numbers of cycles</source>
        <translation>포즈 &apos;%1&apos;와(과) &apos;%2&apos;의 사이클 수가 다릅니다</translation>
    </message>
    <message>
        <source>the coordinates of the fixed target in row %1 are too large</source>
        <translation>%1행의 고정 표적 좌표가 너무 큽니다</translation>
    </message>
    <message>
        <source>U of the instrument and the largest ratio go together: enter both, or neither</source>
        <translation>측정기의 U와 최대 비는 함께 써야 합니다. 둘 다 입력하거나 둘 다 비우십시오</translation>
    </message>
    <message>
        <source>AP by scatter alone</source>
        <translation>산포만의 AP</translation>
    </message>
    <message>
        <source>RP, few cycles allowed for</source>
        <translation>RP, 적은 사이클 고려</translation>
    </message>
    <message>
        <source>u of it</source>
        <translation>그 u</translation>
    </message>
    <message>
        <source>Where AP is not twice what the scatter of the cycles alone makes of it, it says little about the robot.</source>
        <translation>사이클의 산포만으로 생기는 AP의 두 배가 되지 않는 AP는 로봇에 대해 알려 주는 것이 거의 없습니다.</translation>
    </message>
    <message>
        <source>largest s of an axis</source>
        <translation>축의 최대 s</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>중간</translation>
    </message>
    <message>
        <source>smallest</source>
        <translation>최소</translation>
    </message>
    <message>
        <source>mean RP over that of many cycles</source>
        <translation>평균 RP ÷ 많은 사이클의 RP</translation>
    </message>
    <message>
        <source>relative u of RP</source>
        <translation>RP의 상대 u</translation>
    </message>
    <message>
        <source>conforms</source>
        <translation>적합</translation>
    </message>
    <message>
        <source>does not conform</source>
        <translation>부적합</translation>
    </message>
    <message>
        <source>not decided</source>
        <translation>미판정</translation>
    </message>
    <message>
        <source>rated</source>
        <translation>정격</translation>
    </message>
    <message>
        <source>probability of conformity</source>
        <translation>적합 확률</translation>
    </message>
    <message>
        <source>risk that it is wrong</source>
        <translation>판정이 틀릴 위험</translation>
    </message>
    <message>
        <source>cycles that would decide</source>
        <translation>판정에 필요한 사이클</translation>
    </message>
    <message>
        <source>AP of %1</source>
        <translation>%1의 AP</translation>
    </message>
    <message>
        <source>RP of %1</source>
        <translation>%1의 RP</translation>
    </message>
    <message>
        <source>U of the instrument over AP of %1</source>
        <translation>측정기의 U ÷ %1의 AP</translation>
    </message>
    <message>
        <source>U of the instrument over RP of %1</source>
        <translation>측정기의 U ÷ %1의 RP</translation>
    </message>
    <message>
        <source>poses</source>
        <translation>포즈</translation>
    </message>
    <message>
        <source>mean AP</source>
        <translation>평균 AP</translation>
    </message>
    <message>
        <source>largest AP</source>
        <translation>최대 AP</translation>
    </message>
    <message>
        <source>quantile of AP for the probability of a decision</source>
        <translation>판정의 확률에 대한 AP의 분위수</translation>
    </message>
    <message>
        <source>%1 poses are too few to bound this quantile: the largest of %2 poses does, with the same probability.</source>
        <translation>포즈 %1개로는 이 분위수의 상한을 정할 수 없습니다. 포즈 %2개의 최댓값이면 같은 확률로 상한이 됩니다.</translation>
    </message>
    <message>
        <source>two-face: distance of both readings across the beam</source>
        <translation>양면: 두 읽음값의 빔에 직각인 거리</translation>
    </message>
    <message>
        <source>length; a: scale of the references</source>
        <translation>길이. a: 기준의 척도</translation>
    </message>
    <message>
        <source>decision, ISO 14253-1</source>
        <translation>판정, ISO 14253-1</translation>
    </message>
    <message>
        <source>scale of the reference lengths</source>
        <translation>기준 길이의 척도</translation>
    </message>
    <message>
        <source>uncertainty of the test</source>
        <translation>시험의 불확도</translation>
    </message>
    <message>
        <source>uncertainty of the test values</source>
        <translation>시험값의 불확도</translation>
    </message>
    <message>
        <source>measured length at position %1</source>
        <translation>위치 %1에서 측정한 길이</translation>
    </message>
    <message>
        <source>distance of both faces at position %1</source>
        <translation>위치 %1에서 정위와 반위의 거리</translation>
    </message>
    <message>
        <source>error at position %1</source>
        <translation>위치 %1의 오차</translation>
    </message>
    <message>
        <source>there are two tests of position &apos;%1&apos;</source>
        <translation>위치 &apos;%1&apos;의 시험이 둘 있습니다</translation>
    </message>
    <message>
        <source>the length at position &apos;%1&apos; has no reference</source>
        <translation>위치 &apos;%1&apos;의 길이에 기준이 없습니다</translation>
    </message>
    <message>
        <source>the two-face test of position &apos;%1&apos; has a reference length</source>
        <translation>위치 &apos;%1&apos;의 양면 시험에 기준 길이가 있습니다</translation>
    </message>
    <message>
        <source>nothing says the MPE of position &apos;%1&apos;</source>
        <translation>위치 &apos;%1&apos;의 MPE를 알려 주는 것이 없습니다</translation>
    </message>
    <message>
        <source>The tracker conforms at every position.</source>
        <translation>트래커는 모든 위치에서 적합합니다.</translation>
    </message>
    <message>
        <source>The tracker does not conform.</source>
        <translation>트래커는 부적합합니다.</translation>
    </message>
    <message>
        <source>Some positions are not decided: the test is not good enough to tell.</source>
        <translation>일부 위치는 판정되지 않았습니다. 시험이 이를 가릴 만큼 좋지 않습니다.</translation>
    </message>
    <message>
        <source>distance %1</source>
        <translation>거리 %1</translation>
    </message>
    <message>
        <source>pose %1</source>
        <translation>포즈 %1</translation>
    </message>
    <message>
        <source>directions of %1</source>
        <translation>%1의 방향</translation>
    </message>
    <message>
        <source>drift of %1</source>
        <translation>%1의 드리프트</translation>
    </message>
    <message>
        <source>base of the robot</source>
        <translation>로봇의 베이스</translation>
    </message>
    <message>
        <source>references</source>
        <translation>기준 길이</translation>
    </message>
    <message>
        <source>tracker</source>
        <translation>트래커</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in row %2 of %3 must be %4, not %5: %6</source>
        <translation>%3의 %2행에 있는 &apos;%1&apos;은(는) %5이(가) 아니라 %4여야 합니다: %6</translation>
    </message>
    <message>
        <source>%1 must be a number, not %2: %3</source>
        <translation>%1은(는) %2이(가) 아니라 수여야 합니다: %3</translation>
    </message>
    <message>
        <source>%1 must be true or false, not %2: %3</source>
        <translation>%1은(는) %2이(가) 아니라 true 또는 false여야 합니다: %3</translation>
    </message>
    <message>
        <source>a difference of temperatures is given in %1</source>
        <translation>온도차는 %1(으)로 줍니다</translation>
    </message>
    <message>
        <source>write true or false, without quotes</source>
        <translation>따옴표 없이 true 또는 false를 쓰십시오</translation>
    </message>
    <message>
        <source>write a text in quotes</source>
        <translation>따옴표 안의 텍스트를 쓰십시오</translation>
    </message>
    <message>
        <source>write it in quotes: &quot;%1&quot;</source>
        <translation>따옴표 안에 쓰십시오: &quot;%1&quot;</translation>
    </message>
    <message>
        <source>write a number without quotes, such as 0.25, or null where there is none</source>
        <translation>0.25처럼 따옴표 없이 수를 쓰고, 수가 없으면 null을 쓰십시오</translation>
    </message>
    <message>
        <source>write %1, without quotes</source>
        <translation>따옴표 없이 %1을(를) 쓰십시오</translation>
    </message>
    <message>
        <source>write a number in %1, the unit of the column, without quotes</source>
        <translation>열의 단위인 %1 단위의 수를 따옴표 없이 쓰십시오</translation>
    </message>
    <message>
        <source>write %1, without quotes: the unit of the column is %2</source>
        <translation>따옴표 없이 %1을(를) 쓰십시오. 열의 단위는 %2입니다</translation>
    </message>
    <message>
        <source>write %1</source>
        <translation>%1을(를) 쓰십시오</translation>
    </message>
    <message>
        <source>observations that miss what the others agree on by more than %1 m, and points that nothing tells, are left out, as Gama does</source>
        <translation>Gama처럼, 다른 것들이 일치하는 바에서 %1 m 넘게 벗어나는 관측값과 알 수 없는 점을 뺍니다</translation>
    </message>
    <message>
        <source>the file asks for standard deviations a posteriori: for these choose uncertainties as seen, one factor s_0</source>
        <translation>파일은 사후 표준편차를 요구합니다. 이를 위해서는 불확도를 “드러난 대로, 인자 s_0 하나”로 고르십시오</translation>
    </message>
    <message>
        <source>%1: readings are not reduced to an ellipsoid</source>
        <translation>%1: 읽음값을 타원체로 환산하지 않습니다</translation>
    </message>
    <message>
        <source>update-constrained-coordinates: the datum keeps the coordinates of the file</source>
        <translation>update-constrained-coordinates: 데이텀은 파일의 좌표를 유지합니다</translation>
    </message>
    <message>
        <source>Accuracy and repeatability, from the cycles as they are</source>
        <translation>사이클 그대로에서 구한 정확도와 반복성</translation>
    </message>
    <message>
        <source>cycles</source>
        <translation>사이클</translation>
    </message>
    <message>
        <source>What few cycles do to RP</source>
        <translation>적은 사이클이 RP에 미치는 영향</translation>
    </message>
    <message>
        <source>Conformity with the maker&apos;s figures</source>
        <translation>제조사 수치에 대한 적합성</translation>
    </message>
    <message>
        <source>decision</source>
        <translation>판정</translation>
    </message>
    <message>
        <source>Is the instrument good enough</source>
        <translation>측정기는 충분히 좋은가</translation>
    </message>
    <message>
        <source>AP over the poses</source>
        <translation>포즈들의 AP</translation>
    </message>
    <message>
        <source>Accuracy and repeatability of the poses</source>
        <translation>포즈의 정확도와 반복성</translation>
    </message>
    <message>
        <source>AP, RP</source>
        <translation>AP, RP</translation>
    </message>
    <message>
        <source>AP</source>
        <translation>AP</translation>
    </message>
    <message>
        <source>RP</source>
        <translation>RP</translation>
    </message>
    <message>
        <source>rated AP</source>
        <translation>정격 AP</translation>
    </message>
    <message>
        <source>rated RP</source>
        <translation>정격 RP</translation>
    </message>
    <message>
        <source>Decisions after ISO 14253-1</source>
        <translation>ISO 14253-1에 따른 판정</translation>
    </message>
    <message>
        <source>deviation of the barycentre of %1, %2</source>
        <translation>%1의 무게중심의 편차, %2</translation>
    </message>
    <message>
        <source>x in a frame</source>
        <translation>좌표계에서의 x</translation>
    </message>
    <message>
        <source>y in a frame</source>
        <translation>좌표계에서의 y</translation>
    </message>
    <message>
        <source>z in a frame</source>
        <translation>좌표계에서의 z</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>좌표계</translation>
    </message>
    <message>
        <source>Of a coordinate in a frame: the name of the frame, whose pose the readings tell: that of an arm, a scanner, a photogrammetric network.</source>
        <translation>좌표계에서의 좌표인 경우 좌표계의 이름. 그 포즈는 읽음값으로 구합니다. 측정 암, 스캐너, 사진측량망의 좌표계 등.</translation>
    </message>
    <message>
        <source>Frames, planes and lines</source>
        <translation>좌표계, 평면, 직선</translation>
    </message>
    <message>
        <source>Frames that readings name, where more is known of them than that their pose is unknown, and planes and lines on which points are.</source>
        <translation>읽음값에서 이름을 쓰는 좌표계 가운데 포즈가 미지라는 것 외에 더 알려진 것이 있는 좌표계, 그리고 점이 놓인 평면과 직선.</translation>
    </message>
    <message>
        <source>Name of the frame, as in the column of the readings.</source>
        <translation>읽음값의 열에 있는 것과 같은 좌표계의 이름.</translation>
    </message>
    <message>
        <source>An own frame with all of its axes; or a plane, from which points are as far as their z in it says; or a line along its x-axis, from which their y and z say how far they are.</source>
        <translation>모든 축을 가진 고유 좌표계. 또는 평면으로, 점의 z가 평면에서 떨어진 거리를 나타냅니다. 또는 자체 x축을 따르는 직선으로, 점의 y와 z가 직선에서 떨어진 거리를 나타냅니다.</translation>
    </message>
    <message>
        <source>own frame</source>
        <translation>고유 좌표계</translation>
    </message>
    <message>
        <source>Scale of an own frame: fixed; unknown, so that the readings tell it; stated with u.</source>
        <translation>고유 좌표계의 척도: 고정; 미지, 읽음값으로 구함; u와 함께 제시.</translation>
    </message>
    <message>
        <source>scale beyond 1</source>
        <translation>1을 넘는 척도 부분</translation>
    </message>
    <message>
        <source>By how much coordinates in the frame are too long; 0 where it is empty.</source>
        <translation>좌표계에서의 좌표가 지나치게 긴 정도. 비어 있으면 0.</translation>
    </message>
    <message>
        <source>u of scale</source>
        <translation>척도의 u</translation>
    </message>
    <message>
        <source>Standard uncertainty of a stated scale.</source>
        <translation>제시된 척도의 표준불확도.</translation>
    </message>
    <message>
        <source>Of an own frame whose z-axis is vertical: within that standard uncertainty about x and about y; empty: nothing is known of it.</source>
        <translation>z축이 연직인 고유 좌표계의 것. x 둘레와 y 둘레로 이 표준불확도 이내. 비어 있으면 이에 대해 알려진 것이 없습니다.</translation>
    </message>
    <message>
        <source>two frames are called %1</source>
        <translation>두 좌표계의 이름이 %1입니다</translation>
    </message>
    <message>
        <source>%1 has no scale and no tilt to state</source>
        <translation>%1에는 제시할 척도와 기울기가 없습니다</translation>
    </message>
    <message>
        <source>%1: the u of its stated scale is missing</source>
        <translation>%1: 제시된 척도의 u가 없습니다</translation>
    </message>
    <message>
        <source>there is no reading in %1</source>
        <translation>%1에 읽음값이 없습니다</translation>
    </message>
    <message>
        <source>%1 has points without heights</source>
        <translation>%1에 높이가 없는 점이 있습니다</translation>
    </message>
    <message>
        <source>a coordinate of %1 in a frame: the name of the frame is missing</source>
        <translation>좌표계에서의 %1의 좌표: 좌표계의 이름이 없습니다</translation>
    </message>
    <message>
        <source>%1 has no such coordinate of %2</source>
        <translation>%1에는 %2의 그런 좌표가 없습니다</translation>
    </message>
    <message>
        <source>a coordinate in %1 needs x and y of %2, which are not part of the network</source>
        <translation>%1에서의 좌표에는 %2의 x와 y가 필요하지만 망에 속하지 않습니다</translation>
    </message>
    <message>
        <source>nothing tells how %1 lies: read more points in it whose places other readings tell, not all on a line</source>
        <translation>%1이(가) 어떻게 놓여 있는지 알 수 없습니다. 다른 읽음값으로 위치를 알 수 있는 점을 그 안에서 더 읽되, 모두 한 직선 위에 있지 않게 하십시오</translation>
    </message>
    <message>
        <source>%1, there and back</source>
        <translation>%1, 왕복</translation>
    </message>
    <message>
        <source>%1, again</source>
        <translation>%1, 반복</translation>
    </message>
    <message>
        <source>angle at %1 from %2 to %3, in two rounds</source>
        <translation>%1에서 %2와 %3 사이의 각도, 두 대회에서</translation>
    </message>
    <message>
        <source>loop of differences of x, %1</source>
        <translation>x의 차의 폐합 루프, %1</translation>
    </message>
    <message>
        <source>loop of differences of y, %1</source>
        <translation>y의 차의 폐합 루프, %1</translation>
    </message>
    <message>
        <source>loop of height differences, %1</source>
        <translation>높이차의 폐합 루프, %1</translation>
    </message>
    <message>
        <source>Closures before the adjustment</source>
        <translation>조정 전의 폐합</translation>
    </message>
    <message>
        <source>Closure</source>
        <translation>폐합</translation>
    </message>
    <message>
        <source>misclosure</source>
        <translation>폐합차</translation>
    </message>
    <message>
        <source>u of the misclosure</source>
        <translation>폐합차의 u</translation>
    </message>
    <message>
        <source>misclosure over u</source>
        <translation>폐합차를 u로 나눈 값</translation>
    </message>
    <message>
        <source>too large?</source>
        <translation>너무 큼?</translation>
    </message>
    <message>
        <source>coordinates in frames</source>
        <translation>좌표계에서의 좌표</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>좌표계 %1</translation>
    </message>
    <message>
        <source>plane %1</source>
        <translation>평면 %1</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>직선 %1</translation>
    </message>
    <message>
        <source>station %1</source>
        <translation>스테이션 %1</translation>
    </message>
    <message>
        <source>target %1</source>
        <translation>표적 %1</translation>
    </message>
    <message>
        <source>directions at %1</source>
        <translation>%1에서의 방향</translation>
    </message>
    <message>
        <source>directions at %1, round %2</source>
        <translation>%1에서의 방향, 대회 %2</translation>
    </message>
    <message>
        <source>Groups of readings</source>
        <translation>읽음값의 그룹</translation>
    </message>
    <message>
        <source>controlled</source>
        <translation>제어됨</translation>
    </message>
    <message>
        <source>sum of squares falls by</source>
        <translation>제곱합의 감소</translation>
    </message>
    <message>
        <source>contradicts the others?</source>
        <translation>다른 것들과 모순됨?</translation>
    </message>
    <message>
        <source>Without the group the sum of squares falls by as much, which is a chi-square of as many degrees of freedom as of its readings the others control; p is its probability.</source>
        <translation>그룹이 없으면 제곱합이 이만큼 줄어듭니다. 이것은 카이제곱이며, 그 자유도는 그룹의 읽음값 중 다른 읽음값이 제어하는 것의 수입니다. p는 그 확률입니다.</translation>
    </message>
    <message>
        <source>%1 groups have p &lt; 0.1 %; where several do, look at the first.</source>
        <translation>그룹 %1개가 p &lt; 0.1 %입니다. 여럿이면 첫째 것을 보십시오.</translation>
    </message>
    <message>
        <source>%1, origin along %2</source>
        <translation>%1, %2 방향의 원점 위치</translation>
    </message>
    <message>
        <source>%1, offset along its %2</source>
        <translation>%1, 자체 %2 방향의 오프셋</translation>
    </message>
    <message>
        <source>%1, tilt about its %2</source>
        <translation>%1, 자체 %2 둘레의 기울기</translation>
    </message>
    <message>
        <source>%1, turn about %2 after a right angle about y</source>
        <translation>%1, y 둘레로 직각만큼 돌린 뒤 %2 둘레의 회전</translation>
    </message>
    <message>
        <source>%1, turn about %2</source>
        <translation>%1, %2 둘레의 회전</translation>
    </message>
    <message>
        <source>tilt of %1 about %2</source>
        <translation>%1의 기울기, %2 둘레</translation>
    </message>
    <message>
        <source>%1 of %2 in %3</source>
        <translation>%3에서 %2의 %1</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>좌표계</translation>
    </message>
    <message>
        <source>it must be the SHA-256 of the file: 64 hexadecimal digits</source>
        <translation>파일의 SHA-256, 곧 16진수 64자리여야 합니다</translation>
    </message>
    <message>
        <source>its figures would have been valid only before the calibration</source>
        <translation>수치가 교정 전에만 유효했던 것이 됩니다</translation>
    </message>
    <message>
        <source>the symbol of a quantity or the key of a field is missing</source>
        <translation>양의 기호나 필드의 키가 없습니다</translation>
    </message>
    <message>
        <source>a range needs its lowest or its highest value</source>
        <translation>범위에는 최솟값이나 최댓값이 필요합니다</translation>
    </message>
    <message>
        <source>its unit does not fit that of the lowest value</source>
        <translation>단위가 최솟값의 단위와 맞지 않습니다</translation>
    </message>
    <message>
        <source>it is below the lowest value</source>
        <translation>최솟값보다 작습니다</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 %2 of %3</source>
        <translation>%3의 %1 %2</translation>
    </message>
    <message>
        <source>nothing says which certificate it is: its number is missing</source>
        <translation>어느 성적서인지 알 수 없습니다. 번호가 없습니다</translation>
    </message>
    <message>
        <source>a range of a certificate</source>
        <translation>성적서의 범위</translation>
    </message>
    <message>
        <source>a certificate of figures</source>
        <translation>수치의 성적서</translation>
    </message>
    <message>
        <source>its figures hold for %1 of %2, and here it is %3</source>
        <translation>수치는 %1이(가) %2일 때 유효한데 여기서는 %3입니다</translation>
    </message>
    <message>
        <source>its figures hold for %1 of %2, and nothing here is called so</source>
        <translation>수치는 %1이(가) %2일 때 유효한데 여기에는 그런 이름의 것이 없습니다</translation>
    </message>
    <message>
        <source>applicable</source>
        <translation>적용 가능</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>알 수 없음</translation>
    </message>
    <message>
        <source>outside what it holds for</source>
        <translation>적용 범위를 벗어남</translation>
    </message>
    <message>
        <source>expired</source>
        <translation>유효 기한 지남</translation>
    </message>
    <message>
        <source>until when it is valid is not stated</source>
        <translation>유효 기한이 기재되지 않았습니다</translation>
    </message>
    <message>
        <source>the date of the measurement is not stated</source>
        <translation>측정일이 기재되지 않았습니다</translation>
    </message>
    <message>
        <source>it is of %1, and the measurement of %2 before it</source>
        <translation>날짜가 %1인데 측정일은 그보다 앞선 %2입니다</translation>
    </message>
    <message>
        <source>it was valid until %1, and the measurement is of %2</source>
        <translation>%1까지 유효했는데 측정일은 %2입니다</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>%1: %2: %3</source>
        <translation>%1: %2: %3</translation>
    </message>
    <message>
        <source>Certificates of the figures</source>
        <translation>수치의 성적서</translation>
    </message>
    <message>
        <source>Figures of</source>
        <translation>수치의 대상</translation>
    </message>
    <message>
        <source>Calibrated</source>
        <translation>교정일</translation>
    </message>
    <message>
        <source>Valid until</source>
        <translation>유효 기한</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>Of %1 artefacts and instruments %2 have no certificate; their figures are assumed: %3.</source>
        <translation>기준물과 측정기 %1개 중 %2개에 성적서가 없어 그 수치는 가정한 것입니다: %3.</translation>
    </message>
    <message>
        <source>it is no project</source>
        <translation>프로젝트가 아닙니다</translation>
    </message>
    <message>
        <source>it has errors</source>
        <translation>오류가 있습니다</translation>
    </message>
    <message>
        <source>%1, with the old figures: %2</source>
        <translation>%1, 이전 수치로: %2</translation>
    </message>
    <message>
        <source>%1, with the new figures: %2</source>
        <translation>%1, 새 수치로: %2</translation>
    </message>
    <message>
        <source>%1: with the new figures there is no %2</source>
        <translation>%1: 새 수치로는 %2이(가) 없습니다</translation>
    </message>
    <message>
        <source>there is no folder or file %1</source>
        <translation>폴더나 파일 %1이(가) 없습니다</translation>
    </message>
    <message>
        <source>the folder %1 cannot be read: %2</source>
        <translation>폴더 %1을(를) 읽을 수 없습니다: %2</translation>
    </message>
    <message>
        <source>Results that change, the largest change first</source>
        <translation>바뀌는 결과, 변화가 큰 것부터</translation>
    </message>
    <message>
        <source>File</source>
        <translation>파일</translation>
    </message>
    <message>
        <source>Change in U</source>
        <translation>변화, U 단위</translation>
    </message>
    <message>
        <source>Verdict before</source>
        <translation>이전 판정</translation>
    </message>
    <message>
        <source>Verdict after</source>
        <translation>이후 판정</translation>
    </message>
    <message>
        <source>%1 projects and reports were looked at; %2 use the figures.</source>
        <translation>프로젝트와 보고서 %1개를 살펴보았으며, 그중 %2개가 이 수치를 사용합니다.</translation>
    </message>
    <message>
        <source>Of %1 results %2 change, %3 of them in what is stated; verdicts that change: %4.</source>
        <translation>결과 %1개 중 %2개가 바뀌며, 그중 %3개는 기재되는 내용이 바뀝니다. 판정은 %4개가 바뀝니다.</translation>
    </message>
    <message>
        <source>%1 could not be evaluated.</source>
        <translation>%1개를 평가하지 못했습니다.</translation>
    </message>
    <message>
        <source>Impact of new figures</source>
        <translation>새 수치의 영향</translation>
    </message>
    <message>
        <source>Results that rest on a certificate</source>
        <translation>성적서에 근거한 결과</translation>
    </message>
    <message>
        <source>Replaced</source>
        <translation>대체되는 수치</translation>
    </message>
    <message>
        <source>By</source>
        <translation>대체하는 수치</translation>
    </message>
    <message>
        <source>Looked for in</source>
        <translation>찾은 곳</translation>
    </message>
    <message>
        <source>Documents to amend</source>
        <translation>수정할 문서</translation>
    </message>
    <message>
        <source>Not evaluated</source>
        <translation>평가하지 않음</translation>
    </message>
    <message>
        <source>the tables of quantities have other units</source>
        <translation>양의 표들의 단위가 서로 다릅니다</translation>
    </message>
    <message>
        <source>the new figures say nothing of the quantity %1</source>
        <translation>새 수치에는 양 %1에 대한 것이 없습니다</translation>
    </message>
    <message>
        <source>none of the quantities of the certificate is stated</source>
        <translation>성적서의 양 가운데 제시된 것이 없습니다</translation>
    </message>
    <message>
        <source>%1 states no quantities in a table</source>
        <translation>%1은(는) 표에 양을 제시하지 않습니다</translation>
    </message>
    <message>
        <source>%1 has nothing with the id %2</source>
        <translation>%1에 식별자가 %2인 것이 없습니다</translation>
    </message>
    <message>
        <source>%1 has no new figures for %2: nothing in it is of the same kind</source>
        <translation>%1에 %2의 새 수치가 없습니다. 같은 종류의 것이 없습니다</translation>
    </message>
    <message>
        <source>%1 has several figures that %2 could have: name the one behind &apos;#&apos;</source>
        <translation>%1에 %2이(가) 가질 수 있는 수치가 여러 개 있습니다. &apos;#&apos; 뒤에 그중 하나를 지정하십시오</translation>
    </message>
    <message>
        <source>As it stands on the certificate.</source>
        <translation>성적서에 적힌 그대로.</translation>
    </message>
    <message>
        <source>Edition</source>
        <translation>판</translation>
    </message>
    <message>
        <source>Of an amended certificate or a data sheet.</source>
        <translation>수정된 성적서나 사양서의 판.</translation>
    </message>
    <message>
        <source>Issuer</source>
        <translation>발행처</translation>
    </message>
    <message>
        <source>Laboratory, manufacturer.</source>
        <translation>교정기관, 제조사.</translation>
    </message>
    <message>
        <source>The last day on which the figures may be used, by your own rule.</source>
        <translation>자체 규칙에 따라 수치를 사용할 수 있는 마지막 날.</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>조건</translation>
    </message>
    <message>
        <source>What the figures hold for, in words: mode, filter, support.</source>
        <translation>수치가 유효한 조건을 글로 적음: 모드, 필터, 지지 방식.</translation>
    </message>
    <message>
        <source>Its name.</source>
        <translation>파일의 이름.</translation>
    </message>
    <message>
        <source>Digest</source>
        <translation>해시</translation>
    </message>
    <message>
        <source>SHA-256 of the file, 64 hexadecimal digits.</source>
        <translation>파일의 SHA-256, 16진수 64자리.</translation>
    </message>
    <message>
        <source>certificate</source>
        <translation>성적서</translation>
    </message>
    <message>
        <source>report</source>
        <translation>보고서</translation>
    </message>
    <message>
        <source>data sheet</source>
        <translation>사양서</translation>
    </message>
    <message>
        <source>face</source>
        <translation>정위/반위</translation>
    </message>
    <message>
        <source>Of a direction, azimuth or zenith angle: the face in which it was read, as it was read. A zenith angle beyond half a turn is of face two anyway. It is brought to face one; index and collimation change it the other way.</source>
        <translation>방향, 방위각 또는 천정각을 읽은 망원경 위치(정위 또는 반위), 읽은 그대로. 반 바퀴를 넘는 천정각은 어차피 반위입니다. 정위로 환산하며, 지표 오차와 시준 오차는 반대 부호로 작용합니다.</translation>
    </message>
    <message>
        <source>one</source>
        <translation>정위</translation>
    </message>
    <message>
        <source>two</source>
        <translation>반위</translation>
    </message>
    <message>
        <source>What it does to all of its readings alike: its zero is added to distances, by its scale (weather correction included) they are longer, refraction bends its lines of sight, its index is added to zenith angles, its collimation over the sine of the zenith angle to directions; in face two both are taken off.</source>
        <translation>모든 읽음값에 똑같이 미치는 영향: 영점은 거리에 더해지고, 척도(기상 보정 포함)만큼 거리가 길어지며, 굴절은 시준선을 휘게 하고, 지표 오차는 천정각에 더해지며, 시준 오차를 천정각의 사인으로 나눈 값은 방향에 더해집니다. 반위에서는 이 둘을 뺍니다.</translation>
    </message>
    <message>
        <source>Theodolite in rounds</source>
        <translation>대회관측에 의한 데오돌라이트</translation>
    </message>
    <message>
        <source>Standard deviations of a direction and of a zenith angle measured once in both faces, and the index error of the vertical circle, from rounds to targets as ISO 17123-3 has them, with their uncertainties and the statistical tests.</source>
        <translation>ISO 17123-3에서와 같이 표적에 대한 대회관측에서 구한, 정위와 반위로 한 번 측정한 방향과 천정각의 표준편차 및 연직분도원의 지표 오차. 그 불확도와 통계적 검정 포함.</translation>
    </message>
    <message>
        <source>Any number of series, sets and targets counts, also with readings left out; four series of three sets of five targets leave 32 degrees of freedom for directions and 40 for zenith angles.</source>
        <translation>계열, 대회, 표적의 수는 제한이 없으며 읽음값이 빠져도 됩니다. 표적 다섯 개의 대회 셋으로 된 계열 넷이면 자유도가 방향은 32, 천정각은 40입니다.</translation>
    </message>
    <message>
        <source>The index error is positive where a zenith angle in face I reads too large. Its sign and the estimate of its uncertainty from its own scatter are those of this program; hold them against the text of the standard before a sheet names it.</source>
        <translation>지표 오차는 정위 I의 천정각이 너무 크게 읽힐 때 양수입니다. 그 부호와, 자체 산포에서 구한 불확도의 추정은 이 프로그램의 것입니다. 시트에 규격을 언급하기 전에 규격 본문과 대조하십시오.</translation>
    </message>
    <message>
        <source>That the index error is the same in all series is a test of this program.</source>
        <translation>지표 오차가 모든 계열에서 같은지는 이 프로그램의 검정입니다.</translation>
    </message>
    <message>
        <source>A mean of both faces says nothing of collimation and of the tilt of the axes, which it does not contain.</source>
        <translation>정위와 반위의 평균은 시준 오차와 축의 기울기를 포함하지 않으므로 이에 대해 아무것도 알려 주지 않습니다.</translation>
    </message>
    <message>
        <source>A row for each target of each set, with the readings in both faces: directions, zenith angles, or both. Typed, pasted or from a CSV file.</source>
        <translation>대회마다 표적마다 한 행이며 정위와 반위의 읽음값을 적습니다: 방향, 천정각 또는 둘 다. 직접 입력하거나 붙여넣거나 CSV 파일에서 읽습니다.</translation>
    </message>
    <message>
        <source>Number of the series; within one the instrument stands unchanged. Empty: 1.</source>
        <translation>계열의 번호. 한 계열 안에서 측정기는 바뀌지 않고 서 있습니다. 비어 있으면 1.</translation>
    </message>
    <message>
        <source>Number of the set (round) within its series.</source>
        <translation>계열 안에서 세트(대회)의 번호.</translation>
    </message>
    <message>
        <source>Hz I</source>
        <translation>Hz I</translation>
    </message>
    <message>
        <source>Horizontal circle in face I.</source>
        <translation>정위 I의 수평분도원.</translation>
    </message>
    <message>
        <source>Hz II</source>
        <translation>Hz II</translation>
    </message>
    <message>
        <source>Horizontal circle in face II.</source>
        <translation>반위 II의 수평분도원.</translation>
    </message>
    <message>
        <source>V I</source>
        <translation>V I</translation>
    </message>
    <message>
        <source>Zenith angle in face I: 90° on the horizon.</source>
        <translation>정위 I의 천정각: 수평에서 90°.</translation>
    </message>
    <message>
        <source>V II</source>
        <translation>V II</translation>
    </message>
    <message>
        <source>Zenith angle in face II: 270° on the horizon.</source>
        <translation>반위 II의 천정각: 수평에서 270°.</translation>
    </message>
    <message>
        <source>σ of a direction, stated or wanted</source>
        <translation>방향의 σ, 제시되거나 필요한 값</translation>
    </message>
    <message>
        <source>Standard deviation, measured once in both faces, that test a holds s against: of the maker, or what a job needs. Empty: no test a.</source>
        <translation>검정 a에서 s와 비교하는, 정위와 반위로 한 번 측정한 표준편차: 제조사의 값 또는 작업에 필요한 값. 비어 있으면 검정 a 없음.</translation>
    </message>
    <message>
        <source>s of a direction, another campaign</source>
        <translation>방향의 s, 다른 측정</translation>
    </message>
    <message>
        <source>Experimental standard deviation that test b compares s with: of another instrument, observer or day. Empty: no test b.</source>
        <translation>검정 b에서 s와 비교하는 실험표준편차: 다른 측정기, 측정자 또는 다른 날의 것. 비어 있으면 검정 b 없음.</translation>
    </message>
    <message>
        <source>Degrees of freedom of that s</source>
        <translation>그 s의 자유도</translation>
    </message>
    <message>
        <source>Of the s of the other campaign; the default is that of four series of three sets of five targets.</source>
        <translation>다른 측정의 s의 자유도. 기본값은 표적 다섯 개의 대회 셋으로 된 계열 넷의 자유도입니다.</translation>
    </message>
    <message>
        <source>σ of a zenith angle, stated or wanted</source>
        <translation>천정각의 σ, 제시되거나 필요한 값</translation>
    </message>
    <message>
        <source>s of a zenith angle, another campaign</source>
        <translation>천정각의 s, 다른 측정</translation>
    </message>
    <message>
        <source>History of an instrument</source>
        <translation>측정기의 이력</translation>
    </message>
    <message>
        <source>The drift of an instrument or standard from what its calibrations found, with its uncertainty: the component for its next use, and the day on which its next calibration is due.</source>
        <translation>측정기나 표준기의 교정 결과에서 구한 드리프트와 그 불확도: 다음 사용을 위한 성분과 다음 교정이 필요한 날.</translation>
    </message>
    <message>
        <source>The drift is taken as linear. Residuals in the evaluation show whether it is.</source>
        <translation>드리프트는 선형으로 봅니다. 그런지는 평가의 잔차가 보여 줍니다.</translation>
    </message>
    <message>
        <source>Adjustments are taken out of the series by their differences as left less as found; these count as exact, because both are values of one calibration.</source>
        <translation>조정은 조정 후와 조정 전 값의 차로 계열에서 제거합니다. 둘 다 한 교정의 값이므로 이 차는 정확한 것으로 셉니다.</translation>
    </message>
    <message>
        <source>What all calibrations share has no part in the drift. The scatter about the line is part of the value on a date of use: the instrument may lie off its line as it did before.</source>
        <translation>모든 교정이 공유하는 것은 드리프트에 들어가지 않습니다. 직선 둘레의 산포는 사용일의 값에 포함됩니다. 측정기가 이전처럼 직선에서 벗어나 있을 수 있기 때문입니다.</translation>
    </message>
    <message>
        <source>A year has 365.25 days.</source>
        <translation>1년은 365.25일입니다.</translation>
    </message>
    <message>
        <source>Of the value.</source>
        <translation>값의 기호.</translation>
    </message>
    <message>
        <source>What the calibrations state.</source>
        <translation>교정에서 제시하는 것.</translation>
    </message>
    <message>
        <source>In which the values are given.</source>
        <translation>값을 나타내는 단위.</translation>
    </message>
    <message>
        <source>Calibrations</source>
        <translation>교정</translation>
    </message>
    <message>
        <source>What each calibration found, typed, pasted or from a CSV file.</source>
        <translation>각 교정의 결과. 직접 입력하거나 붙여넣거나 CSV 파일에서 읽습니다.</translation>
    </message>
    <message>
        <source>date</source>
        <translation>날짜</translation>
    </message>
    <message>
        <source>Of the calibration: 2026-04-17. Earlier ones stand above.</source>
        <translation>교정의 날짜: 2026-04-17. 이른 것이 위에 옵니다.</translation>
    </message>
    <message>
        <source>as found</source>
        <translation>조정 전</translation>
    </message>
    <message>
        <source>Value or deviation before an adjustment, in the unit.</source>
        <translation>조정 전의 값 또는 편차, 해당 단위로.</translation>
    </message>
    <message>
        <source>as left</source>
        <translation>조정 후</translation>
    </message>
    <message>
        <source>After an adjustment, in the unit; empty: not adjusted.</source>
        <translation>조정 후의 값 또는 편차, 해당 단위로. 비어 있으면 조정하지 않음.</translation>
    </message>
    <message>
        <source>Standard uncertainty of this value alone, in the unit. Used, and needed, with stated uncertainties.</source>
        <translation>이 값만의 표준불확도, 해당 단위로. 불확도를 제시하는 경우에 쓰이며 반드시 필요합니다.</translation>
    </message>
    <message>
        <source>From the scatter about the line (three calibrations or more), or as stated for each value.</source>
        <translation>직선 둘레의 산포에서(교정 세 번 이상), 또는 각 값에 제시된 대로.</translation>
    </message>
    <message>
        <source>Common u</source>
        <translation>공통 u</translation>
    </message>
    <message>
        <source>Standard uncertainty of a deviation that all values share, as that of the laboratory&apos;s standard, in the unit. It is none of the drift.</source>
        <translation>교정실의 표준기의 편차처럼 모든 값이 공유하는 편차의 표준불확도, 해당 단위로. 드리프트에는 들어가지 않습니다.</translation>
    </message>
    <message>
        <source>Date of use</source>
        <translation>사용일</translation>
    </message>
    <message>
        <source>The value and the drift on that day: 2026-11-28; empty: not asked.</source>
        <translation>그날의 값과 드리프트: 2026-11-28. 비어 있으면 구하지 않음.</translation>
    </message>
    <message>
        <source>Next calibration</source>
        <translation>다음 교정</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>규칙</translation>
    </message>
    <message>
        <source>What must stay within the limit until the next calibration, with k times its u.</source>
        <translation>다음 교정까지, 그 u의 k배를 더하여 한계 안에 있어야 하는 것.</translation>
    </message>
    <message>
        <source>the drift since the last calibration</source>
        <translation>마지막 교정 이후의 드리프트</translation>
    </message>
    <message>
        <source>the deviation from the nominal value</source>
        <translation>공칭값으로부터의 편차</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>한계</translation>
    </message>
    <message>
        <source>In the unit.</source>
        <translation>해당 단위로.</translation>
    </message>
    <message>
        <source>Nominal value</source>
        <translation>공칭값</translation>
    </message>
    <message>
        <source>In the unit; 0 for deviations.</source>
        <translation>해당 단위로. 편차이면 0.</translation>
    </message>
    <message>
        <source>k of the rule</source>
        <translation>규칙의 k</translation>
    </message>
    <message>
        <source>Multiple of u that is added.</source>
        <translation>더하는 u의 배수.</translation>
    </message>
    <message>
        <source>Longest interval</source>
        <translation>최대 주기</translation>
    </message>
    <message>
        <source>Years after which it is due in any case.</source>
        <translation>어떤 경우에도 교정이 필요해지는 햇수.</translation>
    </message>
    <message>
        <source>Force-proving instrument</source>
        <translation>힘 측정기</translation>
    </message>
    <message>
        <source>Errors of a force transducer as ISO 376 has them, from indications under calibration forces in three positions, its interpolation with covariance, W over the force with all its parts as EURAMET cg-4 combines them, and its class by limits that are entered.</source>
        <translation>ISO 376에서와 같은 힘 변환기의 오차, 세 위치에서 교정 힘을 가한 지시값에서 구함. 공분산을 포함한 보간, EURAMET cg-4의 방식으로 모든 부분을 합성한 힘에 따른 W, 입력한 한계에 따른 등급.</translation>
    </message>
    <message>
        <source>Formulas are those in common use; hold them against the texts of ISO 376 and EURAMET cg-4 before a certificate names them. Limits of classes are not built in.</source>
        <translation>식은 통용되는 것입니다. 성적서에 이 문서들을 언급하기 전에 ISO 376과 EURAMET cg-4의 본문과 대조하십시오. 등급의 한계는 내장되어 있지 않습니다.</translation>
    </message>
    <message>
        <source>W of the table has the coverage factor that is entered. Results have the one of their degrees of freedom: three rotations leave two, which k = 2 does not know.</source>
        <translation>표의 W는 입력한 포함인자를 갖습니다. 결과는 그 자유도의 포함인자를 갖습니다. 회전이 세 번이면 자유도가 2이며, k = 2는 이를 반영하지 않습니다.</translation>
    </message>
    <message>
        <source>The uncertainty of the machine&apos;s force, creep, zero and temperature act at all forces alike and are common to them; the rotations keep the covariance between the forces that was seen. What is read at one force is its own.</source>
        <translation>교정기 힘의 불확도, 크리프, 영점, 온도는 모든 힘에 똑같이 작용하며 공통입니다. 회전에서는 드러난 힘 사이의 공분산이 유지됩니다. 한 힘에서 읽은 것은 그 힘만의 것입니다.</translation>
    </message>
    <message>
        <source>The coefficients have the covariance of the mean deflections; the residuals of the interpolation count at the forces, not in the coefficients.</source>
        <translation>계수는 평균 변위의 공분산을 갖습니다. 보간의 잔차는 계수가 아니라 힘에서 셉니다.</translation>
    </message>
    <message>
        <source>Drift since the calibration, another indicator and other conditions of use are not part of W.</source>
        <translation>교정 이후의 드리프트, 다른 지시계, 다른 사용 조건은 W에 포함되지 않습니다.</translation>
    </message>
    <message>
        <source>Forces and indications</source>
        <translation>힘과 지시값</translation>
    </message>
    <message>
        <source>A row for each calibration force: two series in one position, one after each of two rotations; decreasing forces where they were read. Typed, pasted or from a CSV file.</source>
        <translation>교정 힘마다 한 행: 한 위치에서 계열 둘, 두 번의 회전 뒤에 각각 하나. 읽은 경우 감소하는 힘도 포함. 직접 입력하거나 붙여넣거나 CSV 파일에서 읽습니다.</translation>
    </message>
    <message>
        <source>Of the calibration machine; its unit is that of results.</source>
        <translation>교정기의 힘. 그 단위가 결과의 단위입니다.</translation>
    </message>
    <message>
        <source>X1</source>
        <translation>X1</translation>
    </message>
    <message>
        <source>First position, increasing force.</source>
        <translation>첫째 위치, 증가하는 힘.</translation>
    </message>
    <message>
        <source>X2</source>
        <translation>X2</translation>
    </message>
    <message>
        <source>The same position again.</source>
        <translation>다시 같은 위치.</translation>
    </message>
    <message>
        <source>X3</source>
        <translation>X3</translation>
    </message>
    <message>
        <source>After the first rotation, increasing force.</source>
        <translation>첫째 회전 후, 증가하는 힘.</translation>
    </message>
    <message>
        <source>X4′</source>
        <translation>X4′</translation>
    </message>
    <message>
        <source>The same position as X3, decreasing force; empty: not read at this force.</source>
        <translation>X3과 같은 위치, 감소하는 힘. 비어 있으면 이 힘에서 읽지 않음.</translation>
    </message>
    <message>
        <source>X5</source>
        <translation>X5</translation>
    </message>
    <message>
        <source>After the second rotation, increasing force.</source>
        <translation>둘째 회전 후, 증가하는 힘.</translation>
    </message>
    <message>
        <source>X6′</source>
        <translation>X6′</translation>
    </message>
    <message>
        <source>The same position as X5, decreasing force; empty: not read at this force.</source>
        <translation>X5와 같은 위치, 감소하는 힘. 비어 있으면 이 힘에서 읽지 않음.</translation>
    </message>
    <message>
        <source>U of the force</source>
        <translation>힘의 U</translation>
    </message>
    <message>
        <source>Relative expanded uncertainty (k = 2) of this force; empty: that of the calibration machine.</source>
        <translation>이 힘의 상대확장불확도(k = 2). 비어 있으면 교정기의 상대확장불확도.</translation>
    </message>
    <message>
        <source>Indications without load</source>
        <translation>무하중 지시값</translation>
    </message>
    <message>
        <source>Before and after each series with increasing forces. Empty: the indications are deflections already, and there is no zero error.</source>
        <translation>증가하는 힘의 각 계열 전후. 비어 있으면 지시값이 이미 변위이며 영점 오차는 없습니다.</translation>
    </message>
    <message>
        <source>Series with increasing forces.</source>
        <translation>증가하는 힘의 계열.</translation>
    </message>
    <message>
        <source>Indication without load before the series.</source>
        <translation>계열 전의 무하중 지시값.</translation>
    </message>
    <message>
        <source>Indication without load after it, or after the decreasing forces that follow upon it.</source>
        <translation>계열 후, 또는 이어지는 감소하는 힘 후의 무하중 지시값.</translation>
    </message>
    <message>
        <source>Smallest step of the indication, or the half range over which it fluctuates.</source>
        <translation>지시값의 최소 단계, 또는 지시값이 흔들리는 범위의 절반.</translation>
    </message>
    <message>
        <source>Creep: indication after 30 s</source>
        <translation>크리프: 30 s 후의 지시값</translation>
    </message>
    <message>
        <source>Without load, 30 s after the largest force was taken off (or at that force). Empty: creep was not measured.</source>
        <translation>최대 힘을 제거하고 30 s 후의 무하중 지시값(또는 최대 힘에서의 지시값). 비어 있으면 크리프를 측정하지 않음.</translation>
    </message>
    <message>
        <source>Creep: indication after 300 s</source>
        <translation>크리프: 300 s 후의 지시값</translation>
    </message>
    <message>
        <source>The same after 300 s.</source>
        <translation>같은 것, 300 s 후.</translation>
    </message>
    <message>
        <source>Force and conditions</source>
        <translation>힘과 조건</translation>
    </message>
    <message>
        <source>Its certificate gives the relative uncertainty of the force. Empty: every force has its own.</source>
        <translation>그 성적서가 힘의 상대불확도를 줍니다. 비어 있으면 힘마다 자체 불확도를 가집니다.</translation>
    </message>
    <message>
        <source>Axis of the machine</source>
        <translation>교정기의 축</translation>
    </message>
    <message>
        <source>Which of the loads of its certificate acts on the instrument.</source>
        <translation>성적서의 하중 가운데 측정기에 작용하는 것.</translation>
    </message>
    <message>
        <source>Temperature coefficient</source>
        <translation>온도계수</translation>
    </message>
    <message>
        <source>Relative change of the deflection with temperature.</source>
        <translation>온도에 따른 변위의 상대 변화.</translation>
    </message>
    <message>
        <source>Temperature, half width</source>
        <translation>온도, 반너비</translation>
    </message>
    <message>
        <source>The temperature of the instrument is known within plus and minus this much.</source>
        <translation>측정기의 온도를 알고 있는 정도, 플러스 마이너스 이 값 이내.</translation>
    </message>
    <message>
        <source>Used with</source>
        <translation>사용 조건</translation>
    </message>
    <message>
        <source>Whether the instrument will be used with decreasing forces too: the reversibility error is then part of its uncertainty.</source>
        <translation>측정기를 감소하는 힘에도 사용할지 여부. 그러면 가역성 오차가 불확도에 포함됩니다.</translation>
    </message>
    <message>
        <source>increasing forces only</source>
        <translation>증가하는 힘만</translation>
    </message>
    <message>
        <source>decreasing forces too</source>
        <translation>감소하는 힘 포함</translation>
    </message>
    <message>
        <source>Divisor of the reversibility</source>
        <translation>가역성의 제수</translation>
    </message>
    <message>
        <source>The reversibility error divided by it is a standard uncertainty: √3 where the error is a limit that is reached, 3 where it hardly is.</source>
        <translation>가역성 오차를 이 값으로 나눈 것이 표준불확도입니다. 오차가 도달하는 한계이면 √3, 거의 도달하지 않는 한계이면 3.</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>곡선</translation>
    </message>
    <message>
        <source>Degree of the interpolation</source>
        <translation>보간의 차수</translation>
    </message>
    <message>
        <source>Of the polynomial of the mean deflection over the force: 1 to 3.</source>
        <translation>힘에 대한 평균 변위의 다항식의 차수: 1~3.</translation>
    </message>
    <message>
        <source>Constant term</source>
        <translation>상수항</translation>
    </message>
    <message>
        <source>Whether the polynomial may have a value without force; else it begins at zero.</source>
        <translation>다항식이 힘이 없을 때 값을 가질 수 있는지 여부. 아니면 0에서 시작합니다.</translation>
    </message>
    <message>
        <source>Interpolation counts relative to</source>
        <translation>보간 잔차의 기준</translation>
    </message>
    <message>
        <source>What the standard deviation of the residuals is divided by. Relative to the largest deflection it is the same part at every force; relative to each one it grows where forces are small, as a residual does.</source>
        <translation>잔차의 표준편차를 나누는 값. 최대 변위에 대한 것이면 모든 힘에서 같은 비율이고, 각 변위에 대한 것이면 잔차가 그렇듯 힘이 작은 곳에서 커집니다.</translation>
    </message>
    <message>
        <source>the largest deflection</source>
        <translation>최대 변위</translation>
    </message>
    <message>
        <source>the deflection at each force</source>
        <translation>각 힘에서의 변위</translation>
    </message>
    <message>
        <source>Normal, with its degrees of freedom in the law of propagation, or a t-distribution (JCGM 101 6.4.9), which has no standard deviation with three rotations.</source>
        <translation>전파 법칙에서는 자유도를 갖는 정규분포, 또는 회전이 세 번이면 표준편차가 없는 t 분포(JCGM 101 6.4.9).</translation>
    </message>
    <message>
        <source>Coverage factor of W</source>
        <translation>W의 포함인자</translation>
    </message>
    <message>
        <source>In the table and curve of W; results have the coverage factor of their degrees of freedom.</source>
        <translation>W의 표와 곡선에 쓰입니다. 결과는 그 자유도의 포함인자를 갖습니다.</translation>
    </message>
    <message>
        <source>Degree of W over the force</source>
        <translation>힘에 대한 W의 차수</translation>
    </message>
    <message>
        <source>Of the polynomial that states W between the calibration forces.</source>
        <translation>교정 힘 사이의 W를 나타내는 다항식의 차수.</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>등급</translation>
    </message>
    <message>
        <source>Limits of the classes</source>
        <translation>등급의 한계</translation>
    </message>
    <message>
        <source>A row for each class, the strictest first, with the largest errors that its standard allows: none of a standard is built in. An empty cell is held against nothing; without rows no class is found.</source>
        <translation>등급마다 한 행, 가장 엄격한 것부터, 규격이 허용하는 최대 오차와 함께. 규격의 값은 내장되어 있지 않습니다. 빈 칸은 비교하지 않으며, 행이 없으면 등급을 구하지 않습니다.</translation>
    </message>
    <message>
        <source>class</source>
        <translation>등급</translation>
    </message>
    <message>
        <source>Name of the class; the strictest first.</source>
        <translation>등급의 이름. 가장 엄격한 것부터.</translation>
    </message>
    <message>
        <source>Largest reproducibility error, with rotation.</source>
        <translation>최대 재현성 오차, 회전 있음.</translation>
    </message>
    <message>
        <source>b′</source>
        <translation>b′</translation>
    </message>
    <message>
        <source>Largest repeatability error, without rotation.</source>
        <translation>최대 반복성 오차, 회전 없음.</translation>
    </message>
    <message>
        <source>Largest interpolation error, of either sign.</source>
        <translation>최대 보간 오차, 부호 무관.</translation>
    </message>
    <message>
        <source>Largest zero error, of either sign.</source>
        <translation>최대 영점 오차, 부호 무관.</translation>
    </message>
    <message>
        <source>Largest reversibility error.</source>
        <translation>최대 가역성 오차.</translation>
    </message>
    <message>
        <source>Largest creep error.</source>
        <translation>최대 크리프 오차.</translation>
    </message>
    <message>
        <source>Largest relative expanded uncertainty (k = 2) of the calibration force.</source>
        <translation>교정 힘의 최대 상대확장불확도(k = 2).</translation>
    </message>
    <message>
        <source>Calibration of a force transducer</source>
        <translation>힘 변환기의 교정</translation>
    </message>
    <message>
        <source>Errors, interpolation, class and uncertainty of a transducer from three positions, after ISO 376.</source>
        <translation>ISO 376에 따라 세 위치에서 구한 변환기의 오차, 보간, 등급, 불확도.</translation>
    </message>
    <message>
        <source>Standard deviations of directions and zenith angles and the index error, with the tests of ISO 17123-3.</source>
        <translation>방향과 천정각의 표준편차 및 지표 오차, ISO 17123-3의 검정 포함.</translation>
    </message>
    <message>
        <source>Drift from as-found values, the component for its next use, its next calibration.</source>
        <translation>조정 전 값에서 구한 드리프트, 다음 사용을 위한 성분, 다음 교정.</translation>
    </message>
    <message>
        <source>Force transducer of 50 kN in three positions</source>
        <translation>세 위치에서의 50 kN 힘 변환기</translation>
    </message>
    <message>
        <source>A force transducer, calibrated after ISO 376 with eight forces in three positions: repeatability, reproducibility, interpolation, zero, reversibility and creep errors, W over the force as EURAMET cg-4 combines it, and the coefficients of its interpolation with their covariance.</source>
        <translation>ISO 376에 따라 세 위치에서 여덟 개의 힘으로 교정한 힘 변환기: 반복성, 재현성, 보간, 영점, 가역성, 크리프 오차, EURAMET cg-4의 방식으로 합성한 힘에 따른 W, 보간의 계수와 그 공분산.</translation>
    </message>
    <message>
        <source>Seven years of a gauge block</source>
        <translation>게이지 블록의 7년</translation>
    </message>
    <message>
        <source>Invented: the deviation of a gauge block of 50 mm from its nominal length, as seven calibrations found it.</source>
        <translation>가상의 예: 일곱 번의 교정에서 구한, 50 mm 게이지 블록의 공칭 길이로부터의 편차.</translation>
    </message>
    <message>
        <source>Theodolite in rounds to five targets</source>
        <translation>다섯 표적에 대한 대회관측에 의한 데오돌라이트</translation>
    </message>
    <message>
        <source>The circles of a total station, tested after ISO 17123-3 with four series of three sets to five targets in both faces: standard deviations of a direction and of a zenith angle, the index error, each with its uncertainty, and the statistical tests.</source>
        <translation>토탈 스테이션의 분도원을, 정위와 반위로 다섯 표적을 관측한 대회 셋으로 된 계열 넷으로 ISO 17123-3에 따라 검정한 것: 방향과 천정각의 표준편차, 지표 오차, 각각의 불확도, 그리고 통계적 검정.</translation>
    </message>
    <message>
        <source>Amended certificate</source>
        <translation>수정 성적서</translation>
    </message>
    <message>
        <source>Replaces certificate</source>
        <translation>대체되는 성적서</translation>
    </message>
    <message>
        <source>Number of the certificate that this one replaces; empty: it is no amended one.</source>
        <translation>이 성적서가 대체하는 성적서의 번호. 비어 있으면 수정 성적서가 아닙니다.</translation>
    </message>
    <message>
        <source>Its date of issue</source>
        <translation>그 발행일</translation>
    </message>
    <message>
        <source>Reasons of the amendment</source>
        <translation>수정 사유</translation>
    </message>
    <message>
        <source>What was wrong or has changed, and why.</source>
        <translation>무엇이 잘못되었거나 바뀌었는지와 그 이유.</translation>
    </message>
    <message>
        <source>Prepared by</source>
        <translation>작성</translation>
    </message>
    <message>
        <source>Who set up and evaluated the project.</source>
        <translation>프로젝트를 작성하고 평가한 사람.</translation>
    </message>
    <message>
        <source>Checked by</source>
        <translation>검토</translation>
    </message>
    <message>
        <source>Who checked it.</source>
        <translation>검토한 사람.</translation>
    </message>
    <message>
        <source>Released by</source>
        <translation>확정</translation>
    </message>
    <message>
        <source>Who authorised it (ISO/IEC 17025 7.8.1.1).</source>
        <translation>승인한 사람(ISO/IEC 17025 7.8.1.1).</translation>
    </message>
    <message>
        <source>Changes to certificate %1</source>
        <translation>성적서 %1에 대한 변경</translation>
    </message>
    <message>
        <source>No result has changed.</source>
        <translation>바뀐 결과는 없습니다.</translation>
    </message>
    <message>
        <source>Statement</source>
        <translation>기재 사항</translation>
    </message>
    <message>
        <source>Replaced certificate</source>
        <translation>대체된 성적서</translation>
    </message>
    <message>
        <source>This certificate</source>
        <translation>이 성적서</translation>
    </message>
    <message>
        <source>Sources of error that are covered</source>
        <translation>포함하는 오차 요인</translation>
    </message>
    <message>
        <source>Not covered</source>
        <translation>포함하지 않음</translation>
    </message>
    <message>
        <source>%1, face two</source>
        <translation>%1, 반위</translation>
    </message>
    <message>
        <source>%1 of face two is not between half a turn and a whole one: type it as read</source>
        <translation>반위의 %1이(가) 반 바퀴와 한 바퀴 사이가 아닙니다. 읽은 그대로 입력하십시오</translation>
    </message>
    <message>
        <source>%1 is not between 0 and half a turn (face one), nor between half a turn and a whole one (face two)</source>
        <translation>%1이(가) 0과 반 바퀴 사이(정위)도, 반 바퀴와 한 바퀴 사이(반위)도 아닙니다</translation>
    </message>
    <message>
        <source>%1, again, half a turn off (say that it is of face two)</source>
        <translation>%1, 반복, 반 바퀴 벗어남(반위라고 지정하십시오)</translation>
    </message>
    <message>
        <source>before the adjustment: %1 closes with %2 %3, %4 times its u (rows %5 of the readings)</source>
        <translation>조정 전: %1의 폐합차가 %2 %3이며 그 u의 %4배입니다(읽음값의 행 %5)</translation>
    </message>
    <message>
        <source>rows of the readings</source>
        <translation>읽음값의 행</translation>
    </message>
    <message>
        <source>loop of distances, %1</source>
        <translation>거리의 폐합 루프, %1</translation>
    </message>
    <message>
        <source>%1 and the sights of both from %2</source>
        <translation>%1, 그리고 %2에서 두 점을 본 시준</translation>
    </message>
    <message>
        <source>distance %1 – %2 by coordinates and the sights of both from %3</source>
        <translation>좌표에 의한 거리 %1 – %2, 그리고 %3에서 두 점을 본 시준</translation>
    </message>
    <message>
        <source>distance %1 – %2 by the sights from %3 and from %4</source>
        <translation>%3과(와) %4에서 본 시준에 의한 거리 %1 – %2</translation>
    </message>
    <message>
        <source>%1 in both faces, as %2</source>
        <translation>정위와 반위의 %1, %2과(와) 비교</translation>
    </message>
    <message>
        <source>%1 in both faces</source>
        <translation>정위와 반위의 %1</translation>
    </message>
    <message>
        <source>%1 from both faces of %2 sights</source>
        <translation>시준 %2개의 정위와 반위에서 구한 %1</translation>
    </message>
    <message>
        <source>Both faces before the adjustment</source>
        <translation>조정 전의 정위와 반위</translation>
    </message>
    <message>
        <source>sights</source>
        <translation>시준 수</translation>
    </message>
    <message>
        <source>from both faces</source>
        <translation>정위와 반위에서</translation>
    </message>
    <message>
        <source>u of that</source>
        <translation>그 u</translation>
    </message>
    <message>
        <source>u as stated</source>
        <translation>제시된 u</translation>
    </message>
    <message>
        <source>not as stated?</source>
        <translation>제시된 것과 다름?</translation>
    </message>
    <message>
        <source>state it among the figures of instruments</source>
        <translation>측정기의 수치에 제시하십시오</translation>
    </message>
    <message>
        <source>Index (z₁ + z₂ − 400 gon)/2 and collimation (a₁ − a₂ ± 200 gon)/2 · sin z of the sights that were read in both faces.</source>
        <translation>정위와 반위로 읽은 시준의 지표 오차 (z₁ + z₂ − 400 gon)/2 및 시준 오차 (a₁ − a₂ ± 200 gon)/2 · sin z.</translation>
    </message>
    <message>
        <source>all angles</source>
        <translation>모든 각</translation>
    </message>
    <message>
        <source>all lengths</source>
        <translation>모든 길이</translation>
    </message>
    <message>
        <source>the directions</source>
        <translation>방향</translation>
    </message>
    <message>
        <source>the zenith angles</source>
        <translation>천정각</translation>
    </message>
    <message>
        <source>the slope distances</source>
        <translation>경사거리</translation>
    </message>
    <message>
        <source>the horizontal distances</source>
        <translation>수평거리</translation>
    </message>
    <message>
        <source>the height differences</source>
        <translation>높이차</translation>
    </message>
    <message>
        <source>the angles read from %1</source>
        <translation>%1에서 읽은 각</translation>
    </message>
    <message>
        <source>the lengths read from %1</source>
        <translation>%1에서 읽은 길이</translation>
    </message>
    <message>
        <source>the angles of %1</source>
        <translation>%1의 각</translation>
    </message>
    <message>
        <source>the lengths of %1</source>
        <translation>%1의 길이</translation>
    </message>
    <message>
        <source>the readings agree if %1 are gon that were typed as degrees</source>
        <translation>%1이(가) 도로 입력된 gon이면 읽음값이 일치합니다</translation>
    </message>
    <message>
        <source>the readings agree if %1 are mm that were typed as m</source>
        <translation>%1이(가) m로 입력된 mm이면 읽음값이 일치합니다</translation>
    </message>
    <message>
        <source>the readings agree if %1 are degrees that were typed as gon</source>
        <translation>%1이(가) gon으로 입력된 도이면 읽음값이 일치합니다</translation>
    </message>
    <message>
        <source>the readings agree if %1 are m that were typed as mm</source>
        <translation>%1이(가) mm로 입력된 m이면 읽음값이 일치합니다</translation>
    </message>
    <message>
        <source>the readings agree if the coordinates of %1 and %2 are exchanged</source>
        <translation>%1과(와) %2의 좌표를 맞바꾸면 읽음값이 일치합니다</translation>
    </message>
    <message>
        <source>No limits of classes are entered: no class is found.</source>
        <translation>등급의 한계가 입력되지 않아 등급을 구하지 않습니다.</translation>
    </message>
    <message>
        <source>largest force</source>
        <translation>최대 힘</translation>
    </message>
    <message>
        <source>deflection at the largest force</source>
        <translation>최대 힘에서의 변위</translation>
    </message>
    <message>
        <source>zero error f_0, the largest of the series</source>
        <translation>영점 오차 f_0, 계열 중 최대</translation>
    </message>
    <message>
        <source>creep error c</source>
        <translation>크리프 오차 c</translation>
    </message>
    <message>
        <source>degrees of freedom of the interpolation</source>
        <translation>보간의 자유도</translation>
    </message>
    <message>
        <source>Without indications at zero there is no zero error.</source>
        <translation>무하중 지시값이 없으면 영점 오차도 없습니다.</translation>
    </message>
    <message>
        <source>Creep was not measured: the budget has none of it.</source>
        <translation>크리프를 측정하지 않아 총괄표에 들어 있지 않습니다.</translation>
    </message>
    <message>
        <source>The zero error was not measured and is held against no limit.</source>
        <translation>영점 오차를 측정하지 않아 어떤 한계와도 비교하지 않습니다.</translation>
    </message>
    <message>
        <source>The creep error was not measured and is held against no limit.</source>
        <translation>크리프 오차를 측정하지 않아 어떤 한계와도 비교하지 않습니다.</translation>
    </message>
    <message>
        <source>reproducibility</source>
        <translation>재현성</translation>
    </message>
    <message>
        <source>creep</source>
        <translation>크리프</translation>
    </message>
    <message>
        <source>zero</source>
        <translation>영점</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>온도</translation>
    </message>
    <message>
        <source>interpolation</source>
        <translation>보간</translation>
    </message>
    <message>
        <source>reversibility</source>
        <translation>가역성</translation>
    </message>
    <message>
        <source>deflection</source>
        <translation>변위</translation>
    </message>
    <message>
        <source>W, relative expanded uncertainty</source>
        <translation>W, 상대확장불확도</translation>
    </message>
    <message>
        <source>The curve of W is a fit to the steps, raised by %1 % so that no step lies above it.</source>
        <translation>W의 곡선은 단계에 맞춘 것이며, 어떤 단계도 그 위에 놓이지 않도록 %1 % 올렸습니다.</translation>
    </message>
    <message>
        <source>directions of each series, mean of both faces</source>
        <translation>각 계열의 방향, 정위와 반위의 평균</translation>
    </message>
    <message>
        <source>zenith angles of each series</source>
        <translation>각 계열의 천정각</translation>
    </message>
    <message>
        <source>pooled over the series, ν readings less unknowns; JCGM 100 H.3.2, E.4.3</source>
        <translation>계열 전체의 합동, ν는 읽음값 수에서 미지수 수를 뺀 것; JCGM 100 H.3.2, E.4.3</translation>
    </message>
    <message>
        <source>index error, s_i within the series; JCGM 100 4.2.3</source>
        <translation>지표 오차, 계열 내의 s_i; JCGM 100 4.2.3</translation>
    </message>
    <message>
        <source>standard deviation of a direction, measured once in both faces</source>
        <translation>정위와 반위로 한 번 측정한 방향의 표준편차</translation>
    </message>
    <message>
        <source>standard deviation of a zenith angle, measured once in both faces</source>
        <translation>정위와 반위로 한 번 측정한 천정각의 표준편차</translation>
    </message>
    <message>
        <source>Targets stand in their directions; how far they are is not known.</source>
        <translation>표적은 그 방향에 그립니다. 얼마나 떨어져 있는지는 알려져 있지 않습니다.</translation>
    </message>
    <message>
        <source>least squares of the rounds, residuals of %1 series</source>
        <translation>대회의 최소제곱, 계열 %1개의 잔차</translation>
    </message>
    <message>
        <source>scatter of the index</source>
        <translation>지표 오차의 산포</translation>
    </message>
    <message>
        <source>mean of %1 readings in both faces</source>
        <translation>정위와 반위 읽음값 %1개의 평균</translation>
    </message>
    <message>
        <source>index error of the vertical circle</source>
        <translation>연직분도원의 지표 오차</translation>
    </message>
    <message>
        <source>the directions leave nothing that would tell their scatter: read two targets or more in two sets or more</source>
        <translation>방향에 산포를 알려 줄 것이 남지 않습니다. 두 대회 이상에서 표적을 두 개 이상 읽으십시오</translation>
    </message>
    <message>
        <source>the zenith angles leave nothing that would tell their scatter: read targets in two sets or more</source>
        <translation>천정각에 산포를 알려 줄 것이 남지 않습니다. 두 대회 이상에서 표적을 읽으십시오</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in set %2 is read in one face only: a reading needs both</source>
        <translation>대회 %2의 &apos;%1&apos;은(는) 정위와 반위 중 하나로만 읽었습니다. 읽음값에는 둘 다 필요합니다</translation>
    </message>
    <message>
        <source>the faces of &apos;%1&apos; in set %2 differ by more than 10° from half a circle: check the faces, the target and that V is a zenith angle</source>
        <translation>대회 %2의 &apos;%1&apos;의 정위와 반위의 차가 반 바퀴에서 10° 넘게 벗어납니다. 정위와 반위, 표적, 그리고 V가 천정각인지 확인하십시오</translation>
    </message>
    <message>
        <source>the zenith angle of &apos;%1&apos; in set %2 in face I is not between 0° and 180°</source>
        <translation>대회 %2의 &apos;%1&apos;의 정위 I 천정각이 0°와 180° 사이가 아닙니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in set %2 has no reading</source>
        <translation>대회 %2의 &apos;%1&apos;에 읽음값이 없습니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is there twice in set %2 of series %3</source>
        <translation>&apos;%1&apos;이(가) 계열 %3의 대회 %2에 두 번 있습니다</translation>
    </message>
    <message>
        <source>%1 rows of readings are more than the most, %2</source>
        <translation>읽음값이 %1행으로 최대 %2행을 넘습니다</translation>
    </message>
    <message>
        <source>a: s of %1 is not larger than the stated σ</source>
        <translation>a: %1의 s가 제시된 σ보다 크지 않음</translation>
    </message>
    <message>
        <source>b: s of %1 and that of the other campaign are of one σ, s²/s²</source>
        <translation>b: %1의 s와 다른 측정의 s가 같은 σ의 것임, s²/s²</translation>
    </message>
    <message>
        <source>c: the index error is not different from zero</source>
        <translation>c: 지표 오차가 0과 다르지 않음</translation>
    </message>
    <message>
        <source>An index error is seen: it leaves the mean of both faces; take it off readings in face I alone, or adjust the instrument.</source>
        <translation>지표 오차가 드러납니다. 정위와 반위의 평균에서는 없어집니다. 정위 I만의 읽음값에서는 빼거나 측정기를 조정하십시오.</translation>
    </message>
    <message>
        <source>the index error is the same in all series, s²/s²</source>
        <translation>지표 오차가 모든 계열에서 같음, s²/s²</translation>
    </message>
    <message>
        <source>The index error changed between the series: it is not one figure, and its u holds for the mean of these series only.</source>
        <translation>지표 오차가 계열 사이에 바뀌었습니다. 하나의 수치가 아니며, 그 u는 이 계열들의 평균에만 유효합니다.</translation>
    </message>
    <message>
        <source>a direction</source>
        <translation>방향</translation>
    </message>
    <message>
        <source>a zenith angle</source>
        <translation>천정각</translation>
    </message>
    <message>
        <source>relative</source>
        <translation>상대</translation>
    </message>
    <message>
        <source>s of a direction, measured once in both faces</source>
        <translation>정위와 반위로 한 번 측정한 방향의 s</translation>
    </message>
    <message>
        <source>s of a zenith angle, measured once in both faces</source>
        <translation>정위와 반위로 한 번 측정한 천정각의 s</translation>
    </message>
    <message>
        <source>s of a direction</source>
        <translation>방향의 s</translation>
    </message>
    <message>
        <source>its degrees of freedom</source>
        <translation>그 자유도</translation>
    </message>
    <message>
        <source>s of a zenith angle</source>
        <translation>천정각의 s</translation>
    </message>
    <message>
        <source>degrees of freedom of that</source>
        <translation>그 자유도</translation>
    </message>
    <message>
        <source>index error</source>
        <translation>지표 오차</translation>
    </message>
    <message>
        <source>theodolite</source>
        <translation>데오돌라이트</translation>
    </message>
    <message>
        <source>values found, without the adjustments; t in years, t_m their weighted mean</source>
        <translation>조정을 제외한, 구한 값; t는 년, t_m은 그 가중평균</translation>
    </message>
    <message>
        <source>drift since the last calibration, on the date of use</source>
        <translation>사용일에서의, 마지막 교정 이후의 드리프트</translation>
    </message>
    <message>
        <source>value on the date of use; c is what all values share</source>
        <translation>사용일의 값; c는 모든 값이 공유하는 것</translation>
    </message>
    <message>
        <source>least squares, %1 calibrations</source>
        <translation>최소제곱, 교정 %1회</translation>
    </message>
    <message>
        <source>level of the line, at the mean of the dates</source>
        <translation>날짜의 평균에서 직선의 높이</translation>
    </message>
    <message>
        <source>scatter about the line</source>
        <translation>직선 둘레의 산포</translation>
    </message>
    <message>
        <source>drift in a year</source>
        <translation>1년의 드리프트</translation>
    </message>
    <message>
        <source>scatter of one value about the line</source>
        <translation>값 하나의 직선 둘레 산포</translation>
    </message>
    <message>
        <source>deviation that all values share</source>
        <translation>모든 값이 공유하는 편차</translation>
    </message>
    <message>
        <source>drift since the last calibration, %1</source>
        <translation>마지막 교정 이후의 드리프트, %1</translation>
    </message>
    <message>
        <source>the limit is not kept even on the day of the last calibration</source>
        <translation>마지막 교정일에도 한계가 지켜지지 않습니다</translation>
    </message>
    <message>
        <source>a date of the form 2026-04-17 is needed; it is &apos;%1&apos;</source>
        <translation>2026-04-17 형식의 날짜가 필요합니다. 현재 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the calibration in row %1 is not after the one before it</source>
        <translation>%1행의 교정이 그 앞의 교정보다 뒤가 아닙니다</translation>
    </message>
    <message>
        <source>row %1 needs the standard uncertainty of its value</source>
        <translation>%1행에 그 값의 표준불확도가 필요합니다</translation>
    </message>
    <message>
        <source>two calibrations have no scatter about a line: state the uncertainty of each value, or add a third</source>
        <translation>교정 두 번에는 직선 둘레의 산포가 없습니다. 각 값의 불확도를 제시하거나 세 번째 교정을 추가하십시오</translation>
    </message>
    <message>
        <source>the rule needs a limit above zero</source>
        <translation>규칙에 0보다 큰 한계가 필요합니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is the symbol of a drift: choose another one</source>
        <translation>&apos;%1&apos;은(는) 드리프트의 기호입니다. 다른 기호를 선택하십시오</translation>
    </message>
    <message>
        <source>the date of use is before the last calibration</source>
        <translation>사용일이 마지막 교정보다 앞섭니다</translation>
    </message>
    <message>
        <source>standard uncertainty of the drift in a year</source>
        <translation>1년의 드리프트의 표준불확도</translation>
    </message>
    <message>
        <source>drift from the last calibration to the date of use</source>
        <translation>마지막 교정부터 사용일까지의 드리프트</translation>
    </message>
    <message>
        <source>corrected: its standard uncertainty</source>
        <translation>보정함: 그 표준불확도</translation>
    </message>
    <message>
        <source>not corrected: half-width of a rectangular distribution</source>
        <translation>보정하지 않음: 직사각형 분포의 반너비</translation>
    </message>
    <message>
        <source>not corrected: standard uncertainty</source>
        <translation>보정하지 않음: 표준불확도</translation>
    </message>
    <message>
        <source>The values scatter more about the line than their uncertainties say: state larger ones, or take the uncertainty from the residuals.</source>
        <translation>값들의 직선 둘레 산포가 그 불확도보다 큽니다. 더 큰 불확도를 제시하거나 잔차에서 불확도를 구하십시오.</translation>
    </message>
    <message>
        <source>last calibration</source>
        <translation>마지막 교정</translation>
    </message>
    <message>
        <source>next calibration, at the latest</source>
        <translation>다음 교정, 늦어도</translation>
    </message>
    <message>
        <source>The limit is not kept even on the day of the last calibration.</source>
        <translation>마지막 교정일에도 한계가 지켜지지 않습니다.</translation>
    </message>
    <message>
        <source>The limit would be kept for longer: the longest interval decides.</source>
        <translation>한계는 더 오래 지켜질 것이므로 최대 주기가 결정합니다.</translation>
    </message>
    <message>
        <source>The last day on which the figure of the rule, with k times its u, is within the limit.</source>
        <translation>규칙의 수치에 그 u의 k배를 더한 값이 한계 안에 있는 마지막 날.</translation>
    </message>
    <message>
        <source>deflection, mean of the rotations</source>
        <translation>변위, 회전들의 평균</translation>
    </message>
    <message>
        <source>reproducibility, repeatability and reversibility errors, ISO 376</source>
        <translation>재현성, 반복성, 가역성 오차, ISO 376</translation>
    </message>
    <message>
        <source>interpolation, zero and creep errors, ISO 376</source>
        <translation>보간, 영점, 크리프 오차, ISO 376</translation>
    </message>
    <message>
        <source>interpolation, degree 1 to 3</source>
        <translation>보간, 차수 1~3</translation>
    </message>
    <message>
        <source>machine, reproducibility, repeatability, resolution, creep, zero, temperature, interpolation, EURAMET cg-4; (v/divisor)² for decreasing forces</source>
        <translation>교정기, 재현성, 반복성, 분해능, 크리프, 영점, 온도, 보간, EURAMET cg-4; 감소하는 힘에는 (v/제수)²</translation>
    </message>
    <message>
        <source>ν forces less coefficients</source>
        <translation>ν는 힘의 수에서 계수의 수를 뺀 것</translation>
    </message>
    <message>
        <source>force of the calibration machine</source>
        <translation>교정기의 힘</translation>
    </message>
    <message>
        <source>calibration machine &apos;%1&apos;</source>
        <translation>교정기 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>uncertainties of the forces</source>
        <translation>힘의 불확도</translation>
    </message>
    <message>
        <source>indications after 30 s and 300 s</source>
        <translation>30 s와 300 s 후의 지시값</translation>
    </message>
    <message>
        <source>zero error</source>
        <translation>영점 오차</translation>
    </message>
    <message>
        <source>largest change of the indication without load</source>
        <translation>무하중 지시값의 최대 변화</translation>
    </message>
    <message>
        <source>temperature of the instrument</source>
        <translation>측정기의 온도</translation>
    </message>
    <message>
        <source>temperature coefficient and half width</source>
        <translation>온도계수와 반너비</translation>
    </message>
    <message>
        <source>reproducibility with rotation</source>
        <translation>회전 있는 재현성</translation>
    </message>
    <message>
        <source>three positions of the instrument</source>
        <translation>측정기의 세 위치</translation>
    </message>
    <message>
        <source>mean deflection at %1</source>
        <translation>%1에서의 평균 변위</translation>
    </message>
    <message>
        <source>repeatability without rotation</source>
        <translation>회전 없는 반복성</translation>
    </message>
    <message>
        <source>two series in one position</source>
        <translation>한 위치에서의 계열 둘</translation>
    </message>
    <message>
        <source>resolution of the indicator</source>
        <translation>지시계의 분해능</translation>
    </message>
    <message>
        <source>difference of two indications</source>
        <translation>두 지시값의 차</translation>
    </message>
    <message>
        <source>decreasing against increasing force</source>
        <translation>감소하는 힘과 증가하는 힘의 비교</translation>
    </message>
    <message>
        <source>interpolated less mean deflection at %1</source>
        <translation>%1에서 보간 변위에서 평균 변위를 뺀 값</translation>
    </message>
    <message>
        <source>residuals of %1 forces</source>
        <translation>힘 %1개의 잔차</translation>
    </message>
    <message>
        <source>interpolated deflection at %1</source>
        <translation>%1에서의 보간 변위</translation>
    </message>
    <message>
        <source>coefficient of F to the power %1</source>
        <translation>F의 %1제곱의 계수</translation>
    </message>
    <message>
        <source>series %1 has no indication without load</source>
        <translation>계열 %1에 무하중 지시값이 없습니다</translation>
    </message>
    <message>
        <source>series %1 has two rows without load</source>
        <translation>계열 %1에 무하중 행이 두 개 있습니다</translation>
    </message>
    <message>
        <source>the force of %1 is there twice: readings of a force are one row</source>
        <translation>힘 %1이(가) 두 번 있습니다. 한 힘의 읽음값은 한 행입니다</translation>
    </message>
    <message>
        <source>nothing says the uncertainty of the force of %1: it needs a calibration machine or a U of its own</source>
        <translation>힘 %1의 불확도를 알 수 없습니다. 교정기 또는 자체 U가 필요합니다</translation>
    </message>
    <message>
        <source>%1 forces are more than the most, %2</source>
        <translation>힘이 %1개로 최대 %2개를 넘습니다</translation>
    </message>
    <message>
        <source>%1 forces leave nothing that would tell how well a polynomial of %2 coefficients fits: calibrate more forces or lower the degree</source>
        <translation>힘 %1개로는 계수 %2개의 다항식이 얼마나 잘 맞는지 알려 줄 것이 남지 않습니다. 더 많은 힘을 교정하거나 차수를 낮추십시오</translation>
    </message>
    <message>
        <source>%1 forces do not determine a polynomial of degree %2</source>
        <translation>힘 %1개로는 %2차 다항식이 결정되지 않습니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; states no uncertainty of %2</source>
        <translation>&apos;%1&apos;이(가) %2의 불확도를 제시하지 않습니다</translation>
    </message>
    <message>
        <source>creep needs the indications after 30 s and after 300 s</source>
        <translation>크리프에는 30 s 후와 300 s 후의 지시값이 필요합니다</translation>
    </message>
    <message>
        <source>the deflection of series %1 does not grow up to %2: check the indications, and those without load</source>
        <translation>계열 %1의 변위가 %2까지 증가하지 않습니다. 지시값과 무하중 지시값을 확인하십시오</translation>
    </message>
    <message>
        <source>for use with decreasing forces an indication X4′ or X6′ has to be read at %1</source>
        <translation>감소하는 힘에 사용하려면 %1에서 지시값 X4′ 또는 X6′을 읽어야 합니다</translation>
    </message>
    <message>
        <source>force %1</source>
        <translation>힘 %1</translation>
    </message>
    <message>
        <source>the date of &apos;%1&apos; must be of the form 2026-04-17; it is &apos;%2&apos;</source>
        <translation>&apos;%1&apos;의 날짜는 2026-04-17 형식이어야 합니다. 현재 &apos;%2&apos;</translation>
    </message>
    <message>
        <source>the date of &apos;%1&apos; is before that of the step before it</source>
        <translation>&apos;%1&apos;의 날짜가 그 앞 단계의 날짜보다 앞섭니다</translation>
    </message>
    <message>
        <source>a step of the review</source>
        <translation>검토의 단계</translation>
    </message>
    <message>
        <source>a part that was released</source>
        <translation>확정된 부분</translation>
    </message>
    <message>
        <source>an entry of the log</source>
        <translation>로그의 항목</translation>
    </message>
    <message>
        <source>the review</source>
        <translation>검토</translation>
    </message>
    <message>
        <source>the title</source>
        <translation>제목</translation>
    </message>
    <message>
        <source>the notes of the project</source>
        <translation>프로젝트의 메모</translation>
    </message>
    <message>
        <source>the author</source>
        <translation>작성자</translation>
    </message>
    <message>
        <source>the number of the project</source>
        <translation>프로젝트의 번호</translation>
    </message>
    <message>
        <source>the texts of the certificate</source>
        <translation>성적서의 텍스트</translation>
    </message>
    <message>
        <source>what the replaced certificate stated</source>
        <translation>대체된 성적서에 기재된 것</translation>
    </message>
    <message>
        <source>what goes into the report</source>
        <translation>보고서에 들어가는 것</translation>
    </message>
    <message>
        <source>how results are stated</source>
        <translation>결과의 표기 방식</translation>
    </message>
    <message>
        <source>the names and dates of the review</source>
        <translation>검토의 이름과 날짜</translation>
    </message>
    <message>
        <source>which assets and analyses there are, or their order</source>
        <translation>어떤 에셋과 분석이 있는지, 또는 그 순서</translation>
    </message>
    <message>
        <source>asset %1</source>
        <translation>에셋 %1</translation>
    </message>
    <message>
        <source>analysis %1</source>
        <translation>분석 %1</translation>
    </message>
    <message>
        <source>texts or certificates of asset %1</source>
        <translation>에셋 %1의 텍스트 또는 성적서</translation>
    </message>
    <message>
        <source>texts, requirements or designs of analysis %1</source>
        <translation>분석 %1의 텍스트, 요구사항 또는 설계</translation>
    </message>
    <message>
        <source>%1, which is new</source>
        <translation>%1(새로 생김)</translation>
    </message>
    <message>
        <source>%1, which is no longer there</source>
        <translation>%1(없어짐)</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>the record of the release</source>
        <translation>확정의 기록</translation>
    </message>
    <message>
        <source>draft: it was not released</source>
        <translation>초안: 확정되지 않았습니다</translation>
    </message>
    <message>
        <source>released by %1, digest %2</source>
        <translation>%1이(가) 확정함, 해시 %2</translation>
    </message>
    <message>
        <source>draft again: changed since it was released by %1: %2</source>
        <translation>다시 초안: %1이(가) 확정한 뒤 바뀌었습니다: %2</translation>
    </message>
    <message>
        <source>it is not released: &apos;%1&apos; needs a name and a date of the form 2026-04-17</source>
        <translation>확정되지 않았습니다. &apos;%1&apos;에 이름과 2026-04-17 형식의 날짜가 필요합니다</translation>
    </message>
    <message>
        <source>a text of the replaced certificate</source>
        <translation>대체된 성적서의 텍스트</translation>
    </message>
    <message>
        <source>a result of the replaced certificate</source>
        <translation>대체된 성적서의 결과</translation>
    </message>
    <message>
        <source>the certificate cannot have been issued before the one that it replaces</source>
        <translation>성적서는 그것이 대체하는 성적서보다 먼저 발행될 수 없습니다</translation>
    </message>
    <message>
        <source>an amended certificate has a number of its own, not that of the one that it replaces</source>
        <translation>수정 성적서는 대체하는 성적서의 번호가 아니라 자체 번호를 가집니다</translation>
    </message>
    <message>
        <source>%1 directions are of face two, as the zenith angles of their sights say</source>
        <translation>방향 %1개가, 그 시준의 천정각에 따르면 반위입니다</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>초안</translation>
    </message>
    <message>
        <source>it was not released</source>
        <translation>확정되지 않았습니다</translation>
    </message>
    <message>
        <source>changed since the release by %1: %2</source>
        <translation>%1의 확정 이후 바뀌었습니다: %2</translation>
    </message>
    <message>
        <source>Digest of the release</source>
        <translation>확정의 해시</translation>
    </message>
    <message>
        <source>the certificate that is to be replaced has no number: there is none to refer to</source>
        <translation>대체될 성적서에 번호가 없습니다. 참조할 번호가 없습니다</translation>
    </message>
    <message>
        <source>an amended certificate has a number of its own; %1 is that of the one that it replaces</source>
        <translation>수정 성적서는 자체 번호를 가집니다. %1은(는) 그것이 대체하는 성적서의 번호입니다</translation>
    </message>
    <message>
        <source>the date of issue must be of the form 2026-04-17; it is &apos;%1&apos;</source>
        <translation>발행일은 2026-04-17 형식이어야 합니다. 현재 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>Table %1, continued</source>
        <translation>표 %1, 계속</translation>
    </message>
    <message>
        <source>Errors after ISO 376</source>
        <translation>ISO 376에 따른 오차</translation>
    </message>
    <message>
        <source>mean deflection</source>
        <translation>평균 변위</translation>
    </message>
    <message>
        <source>Classes by the limits entered</source>
        <translation>입력한 한계에 따른 등급</translation>
    </message>
    <message>
        <source>Relative standard uncertainties and W</source>
        <translation>상대표준불확도와 W</translation>
    </message>
    <message>
        <source>Curves over the force</source>
        <translation>힘에 대한 곡선</translation>
    </message>
    <message>
        <source>power of the force</source>
        <translation>힘의 거듭제곱</translation>
    </message>
    <message>
        <source>Errors over the force</source>
        <translation>힘에 대한 오차</translation>
    </message>
    <message>
        <source>relative error</source>
        <translation>상대 오차</translation>
    </message>
    <message>
        <source>Relative expanded uncertainty over the force</source>
        <translation>힘에 대한 상대확장불확도</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>드리프트</translation>
    </message>
    <message>
        <source>Calibrations and their residuals</source>
        <translation>교정과 그 잔차</translation>
    </message>
    <message>
        <source>Change since the first calibration</source>
        <translation>첫 교정 이후의 변화</translation>
    </message>
    <message>
        <source>years since the first calibration</source>
        <translation>첫 교정 이후 햇수</translation>
    </message>
    <message>
        <source>line ± k u</source>
        <translation>직선 ± k u</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>계열</translation>
    </message>
    <message>
        <source>Residuals of the directions</source>
        <translation>방향의 잔차</translation>
    </message>
    <message>
        <source>Residuals of the zenith angles</source>
        <translation>천정각의 잔차</translation>
    </message>
    <message>
        <source>And in further campaigns</source>
        <translation>그 밖의 측정</translation>
    </message>
    <message>
        <source>Further networks that see the same figures. What several of them see is combined: their mean, with what it changes from one campaign to the next in its degrees of freedom (Paule and Mandel).</source>
        <translation>같은 수치가 드러나는 그 밖의 망. 여럿에서 드러난 것은 합성합니다. 그 평균을 쓰며, 한 측정에서 다음 측정으로 변하는 정도를 자유도에 반영합니다(Paule과 Mandel).</translation>
    </message>
    <message>
        <source>campaign</source>
        <translation>측정</translation>
    </message>
    <message>
        <source>A network as above.</source>
        <translation>위와 같은 망.</translation>
    </message>
    <message>
        <source>The tool centre point from a planned procedure or from measured points; or only the points as the ballbars measure them, at given places or by measured lengths.</source>
        <translation>계획된 절차나 측정점에서 구한 공구 중심점, 또는 볼바가 측정하는 점만(지정한 위치에서나 측정된 길이로).</translation>
    </message>
    <message>
        <source>points alone, measured lengths</source>
        <translation>점만, 측정된 길이</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>길이</translation>
    </message>
    <message>
        <source>Lengths of the bars at each point, typed or from a CSV file. Those of more than three bars are adjusted, and their residuals tell their uncertainty.</source>
        <translation>각 점에서의 볼바의 길이. 직접 입력하거나 CSV 파일에서 읽습니다. 볼바가 세 개보다 많으면 길이를 조정하며, 그 잔차가 길이의 불확도를 알려 줍니다.</translation>
    </message>
    <message>
        <source>Name of the point; it has a length of every bar.</source>
        <translation>점의 이름. 점마다 모든 볼바의 길이가 있습니다.</translation>
    </message>
    <message>
        <source>bar</source>
        <translation>볼바</translation>
    </message>
    <message>
        <source>Number of the bar, which is that of its support.</source>
        <translation>볼바의 번호. 그 지지점의 번호와 같습니다.</translation>
    </message>
    <message>
        <source>From the support to the ball, as read.</source>
        <translation>지지점에서 볼까지, 읽은 그대로.</translation>
    </message>
    <message>
        <source>Uncertainties of the lengths</source>
        <translation>길이의 불확도</translation>
    </message>
    <message>
        <source>As the ballbars state them, or as the residuals of the lengths see them.</source>
        <translation>볼바에 제시된 대로, 또는 길이의 잔차에서 드러난 대로.</translation>
    </message>
    <message>
        <source>Stated scatter</source>
        <translation>제시된 산포</translation>
    </message>
    <message>
        <source>Within the groups</source>
        <translation>그룹 내</translation>
    </message>
    <message>
        <source>Standard deviation of one observation, in the unit of the quantity, as a data sheet or a budget states it: the view Seen holds it against the observations. Empty: nothing is stated.</source>
        <translation>관측값 하나의 표준편차, 그 양의 단위로. 사양서나 총괄표에 제시된 값이며, 드러난 값 보기에서 관측값과 비교합니다. 비어 있으면 제시된 것이 없습니다.</translation>
    </message>
    <message>
        <source>Between the groups</source>
        <translation>그룹 간</translation>
    </message>
    <message>
        <source>The same of the deviations that the observations of a group share. Empty: nothing is stated.</source>
        <translation>한 그룹의 관측값이 공유하는 편차에 대한 같은 값. 비어 있으면 제시된 것이 없습니다.</translation>
    </message>
    <message>
        <source>elevations</source>
        <translation>고도각</translation>
    </message>
    <message>
        <source>%1; from one campaign to the next it changes by %2 %</source>
        <translation>%1. 한 측정에서 다음 측정으로 %2 %만큼 변합니다</translation>
    </message>
    <message>
        <source>height of the point</source>
        <translation>점의 높이</translation>
    </message>
    <message>
        <source>bar %1, point %2</source>
        <translation>볼바 %1, 점 %2</translation>
    </message>
    <message>
        <source>readings of the bars</source>
        <translation>볼바의 읽음값</translation>
    </message>
    <message>
        <source>lengths between supports</source>
        <translation>지지점 사이의 길이</translation>
    </message>
    <message>
        <source>heights of supports</source>
        <translation>지지점의 높이</translation>
    </message>
    <message>
        <source>constants of the bars</source>
        <translation>볼바의 상수</translation>
    </message>
    <message>
        <source>the lengths contradict each other by %1 times what their uncertainties allow (at most %2 by chance): look for a mistyped or exchanged length, or for figures of the ballbars that are too small</source>
        <translation>길이들이 불확도가 허용하는 것의 %1배로 서로 모순됩니다(우연히는 많아야 %2배). 잘못 입력했거나 바뀐 길이, 또는 볼바의 너무 작은 수치를 찾으십시오</translation>
    </message>
    <message>
        <source>there is no bar %1: the ballbars have %2 supports</source>
        <translation>볼바 %1이(가) 없습니다. 볼바의 지지점은 %2개입니다</translation>
    </message>
    <message>
        <source>point %1 has two lengths of bar %2</source>
        <translation>점 %1에 볼바 %2의 길이가 두 개 있습니다</translation>
    </message>
    <message>
        <source>point %1 has no length of bar %2</source>
        <translation>점 %1에 볼바 %2의 길이가 없습니다</translation>
    </message>
    <message>
        <source>the lengths of the first three bars do not meet at point %1: look for a mistyped or exchanged length</source>
        <translation>처음 세 볼바의 길이가 점 %1에서 만나지 않습니다. 잘못 입력했거나 바뀐 길이를 찾으십시오</translation>
    </message>
    <message>
        <source>the %1 of %2</source>
        <translation>%2의 %1</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 외 %2개</translation>
    </message>
    <message>
        <source>%1. An error of it cannot be told apart from one of %2</source>
        <translation>%1. 그 오차는 %2의 오차와 구별할 수 없습니다</translation>
    </message>
    <message>
        <source>%1, observation %2</source>
        <translation>%1, 관측값 %2</translation>
    </message>
    <message>
        <source>mean of %1</source>
        <translation>%1의 평균</translation>
    </message>
    <message>
        <source>%1, contrast %2</source>
        <translation>%1, 대비 %2</translation>
    </message>
    <message>
        <source>scatter within the groups</source>
        <translation>그룹 내 산포</translation>
    </message>
    <message>
        <source>scatter between the groups</source>
        <translation>그룹 간 산포</translation>
    </message>
    <message>
        <source>what is stated between the groups can only be held against the observations together with what is stated within them</source>
        <translation>그룹 간에 제시된 것은 그룹 내에 제시된 것과 함께여야만 관측값과 비교할 수 있습니다</translation>
    </message>
    <message>
        <source>%1 in set %2 of series %3, %4</source>
        <translation>%1, 계열 %3의 대회 %2, %4</translation>
    </message>
    <message>
        <source>order</source>
        <translation>순서</translation>
    </message>
    <message>
        <source>Histogram of the residuals</source>
        <translation>잔차의 히스토그램</translation>
    </message>
    <message>
        <source>Best measurement capability</source>
        <translation>최고 측정 능력</translation>
    </message>
    <message>
        <source>The smallest expanded uncertainties that a laboratory may state for a quantity (CMC), by ranges of its value. Certificates never state a smaller one.</source>
        <translation>시험소가 한 양에 대해 기재할 수 있는 가장 작은 확장불확도(CMC)를 값의 범위별로 담습니다. 성적서는 이보다 작은 값을 기재하지 않습니다.</translation>
    </message>
    <message>
        <source>It is for U of about 95 %. No evaluation depends on it: results and reports state what was evaluated, certificates what may be stated.</source>
        <translation>약 95 %의 U에 대한 것입니다. 어떤 평가도 이에 의존하지 않습니다. 결과와 보고서는 평가된 값을, 성적서는 기재할 수 있는 값을 나타냅니다.</translation>
    </message>
    <message>
        <source>A result for which the laboratory has no capability is outside its scope: certificates say so, and &quot;covaria check&quot; ends with status 3.</source>
        <translation>시험소에 측정 능력이 없는 결과는 인정 범위 밖입니다. 성적서가 이를 알리고 &quot;covaria check&quot;는 상태 3으로 끝납니다.</translation>
    </message>
    <message>
        <source>Of the results that it is for, and of the fixed part of U.</source>
        <translation>적용되는 결과와 U의 고정 부분의 단위입니다.</translation>
    </message>
    <message>
        <source>Symbols</source>
        <translation>기호</translation>
    </message>
    <message>
        <source>Of the results that it is for, with blanks between; empty: all results of that kind of unit.</source>
        <translation>적용되는 결과의 기호로, 공백으로 구분합니다. 비우면 그 종류의 단위를 가진 모든 결과입니다.</translation>
    </message>
    <message>
        <source>Ranges</source>
        <translation>범위</translation>
    </message>
    <message>
        <source>Value of</source>
        <translation>다음의 값</translation>
    </message>
    <message>
        <source>Symbol of the quantity that the ranges and the relative part refer to, as that of the nominal length where the result is a deviation; empty: the result itself.</source>
        <translation>범위와 비례 부분이 가리키는 양의 기호입니다. 결과가 편차일 때의 호칭 길이 등이며, 비우면 결과 자체입니다.</translation>
    </message>
    <message>
        <source>Unit of the range</source>
        <translation>범위의 단위</translation>
    </message>
    <message>
        <source>In which the ranges are given.</source>
        <translation>범위를 나타내는 단위입니다.</translation>
    </message>
    <message>
        <source>Expanded uncertainties (k = 2) that the accreditation states, by ranges; the first range that has the value counts.</source>
        <translation>인정서에 있는 확장불확도(k = 2)를 범위별로 나타냅니다. 값이 든 첫 범위가 적용됩니다.</translation>
    </message>
    <message>
        <source>Smallest value of the range, in the unit of the range.</source>
        <translation>범위의 가장 작은 값, 범위의 단위로.</translation>
    </message>
    <message>
        <source>Largest value of the range; it belongs to it.</source>
        <translation>범위의 가장 큰 값이며, 범위에 속합니다.</translation>
    </message>
    <message>
        <source>U, fixed part</source>
        <translation>U, 고정 부분</translation>
    </message>
    <message>
        <source>The part of U that does not depend on the value (a of a + b L), in the unit of the results.</source>
        <translation>값에 의존하지 않는 U의 부분(a + b L의 a), 결과의 단위로.</translation>
    </message>
    <message>
        <source>U, relative part</source>
        <translation>U, 비례 부분</translation>
    </message>
    <message>
        <source>The part of U in proportion to the value (b of a + b L): 0.5e-6 is 0.5 um in a metre.</source>
        <translation>값에 비례하는 U의 부분(a + b L의 b): 0.5e-6은 1미터에 0.5 um입니다.</translation>
    </message>
    <message>
        <source>Parts of U</source>
        <translation>U의 부분</translation>
    </message>
    <message>
        <source>Fixed and relative part of U.</source>
        <translation>U의 고정 부분과 비례 부분입니다.</translation>
    </message>
    <message>
        <source>are added: a + b L</source>
        <translation>더함: a + b L</translation>
    </message>
    <message>
        <source>in quadrature: Q[a; b L]</source>
        <translation>제곱합: Q[a; b L]</translation>
    </message>
    <message>
        <source>Smaller U</source>
        <translation>더 작은 U</translation>
    </message>
    <message>
        <source>A smaller U</source>
        <translation>더 작은 U는</translation>
    </message>
    <message>
        <source>What certificates state where the evaluated U is smaller.</source>
        <translation>평가된 U가 더 작을 때 성적서가 기재하는 것입니다.</translation>
    </message>
    <message>
        <source>is raised to it</source>
        <translation>그 값으로 올림</translation>
    </message>
    <message>
        <source>is not stated</source>
        <translation>기재하지 않음</translation>
    </message>
    <message>
        <source>the range ends below its beginning</source>
        <translation>범위의 끝이 시작보다 작습니다</translation>
    </message>
    <message>
        <source>the range has no U</source>
        <translation>범위에 U가 없습니다</translation>
    </message>
    <message>
        <source>a relative part of U needs ranges of the same kind of unit as the results</source>
        <translation>U의 비례 부분에는 결과와 같은 종류의 단위를 가진 범위가 필요합니다</translation>
    </message>
    <message>
        <source>U of %1, %2, is below the best capability (%4): certificates state %3</source>
        <translation>%1의 U %2는 최고 측정 능력(%4)보다 작습니다: 성적서는 %3을(를) 기재합니다</translation>
    </message>
    <message>
        <source>U of %1, %2, is below the best capability of %3 (%4): it may not be stated</source>
        <translation>%1의 U %2는 최고 측정 능력 %3(%4)보다 작습니다: 기재할 수 없습니다</translation>
    </message>
    <message>
        <source>%1 is outside the scope: the laboratory has no capability for it</source>
        <translation>%1은(는) 인정 범위 밖입니다: 시험소에 이에 대한 측정 능력이 없습니다</translation>
    </message>
    <message>
        <source>Distances between points that are measurands too, and calibrated lengths to hold them against.</source>
        <translation>함께 측정량이 되는 점 사이의 거리와, 그것과 비교할 교정된 길이입니다.</translation>
    </message>
    <message>
        <source>A calibrated length of the distance, or what was measured along one line of sight. It is held back from the adjustment, which is held against it (E_n).</source>
        <translation>거리의 교정된 길이 또는 한 시준선을 따라 잰 값입니다. 조정에는 쓰지 않고, 조정 결과를 이것과 비교합니다(E_n).</translation>
    </message>
    <message>
        <source>u of reference</source>
        <translation>기준값의 u</translation>
    </message>
    <message>
        <source>Standard uncertainty of the reference.</source>
        <translation>기준값의 표준불확도입니다.</translation>
    </message>
    <message>
        <source>Date of the readings</source>
        <translation>읽은 날짜</translation>
    </message>
    <message>
        <source>For the chart of figures over campaigns: 2026-11-28; empty: not stated.</source>
        <translation>측정들에 걸친 수치의 차트용: 2026-11-28. 비우면 제시하지 않음.</translation>
    </message>
    <message>
        <source>Network method for a tracker</source>
        <translation>트래커의 망 방법</translation>
    </message>
    <message>
        <source>What a tracker&apos;s readings are worth, from the same targets seen from several unknown places, and E_n against calibrated lengths.</source>
        <translation>같은 표적을 알려지지 않은 여러 위치에서 본 것으로 구한 트래커 읽음값의 가치와, 교정된 길이에 대한 E_n.</translation>
    </message>
    <message>
        <source>Figures of a laser tracker by the network method</source>
        <translation>망 방법에 의한 레이저 트래커의 수치</translation>
    </message>
    <message>
        <source>One laser tracker, put up at five places that nobody measured, read the same ten nests; it leans a little everywhere.</source>
        <translation>레이저 트래커 하나를 아무도 측정하지 않은 다섯 위치에 놓고 같은 네스트 열 개를 읽었습니다. 어디서나 조금 기울어 있습니다.</translation>
    </message>
    <message>
        <source>Standard uncertainty as seen, over campaigns</source>
        <translation>드러난 표준불확도, 측정별</translation>
    </message>
    <message>
        <source>Seen over stated, over campaigns</source>
        <translation>드러난 값/제시된 값, 측정별</translation>
    </message>
    <message>
        <source>years since the first campaign</source>
        <translation>첫 측정 이후의 해</translation>
    </message>
    <message>
        <source>campaign, in the order of the set-up</source>
        <translation>측정, 설정의 순서</translation>
    </message>
    <message>
        <source>as seen</source>
        <translation>드러난 값</translation>
    </message>
    <message>
        <source>its 95 % interval</source>
        <translation>그 95 % 구간</translation>
    </message>
    <message>
        <source>95 % interval of the next campaign</source>
        <translation>다음 측정의 95 % 구간</translation>
    </message>
    <message>
        <source>calibrated lengths, held back from the adjustment; U of the difference, k = 2</source>
        <translation>조정에 쓰지 않고 따로 둔 교정 길이; 차이의 U, k = 2</translation>
    </message>
    <message>
        <source>a reference length and its u belong together</source>
        <translation>기준 길이와 그 u는 함께 있어야 합니다</translation>
    </message>
    <message>
        <source>Calibrated lengths held back from the adjustment</source>
        <translation>조정에 쓰지 않고 따로 둔 교정 길이</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>거리</translation>
    </message>
    <message>
        <source>as adjusted</source>
        <translation>조정된 값</translation>
    </message>
    <message>
        <source>adjusted less reference</source>
        <translation>조정값 − 기준값</translation>
    </message>
    <message>
        <source>U of the difference (k = 2)</source>
        <translation>차이의 U (k = 2)</translation>
    </message>
    <message>
        <source>E_n = |d|/U: up to 1 the network agrees with the length. No reading knows it, so that it also speaks for or against what all readings have in common: the scale of distances.</source>
        <translation>E_n = |d|/U: 1까지는 망이 그 길이와 일치합니다. 어떤 읽음값도 이 길이를 모르므로, 모든 읽음값에 공통된 것, 곧 거리의 척도에 대해서도 말해 줍니다.</translation>
    </message>
    <message>
        <source>%1 as adjusted differs from its reference by %2 µm, with E_n = %3: look for a wrong scale of distances, a wrong reference, or uncertainties that are too small</source>
        <translation>조정된 %1은(는) 기준값과 %2 µm 다르며 E_n = %3입니다: 거리의 잘못된 척도, 잘못된 기준값 또는 너무 작은 불확도를 찾으십시오</translation>
    </message>
    <message>
        <source>u of %1 is a few of the steps in which numbers of its size are kept, so that its trials are rounded and their U is too large (results like this: %2). The law of propagation is not; or evaluate the deviation from a nominal value.</source>
        <translation>%1의 u는 그 크기의 수를 저장하는 간격의 몇 배에 지나지 않아 시행이 반올림되고 U가 너무 큽니다(이런 결과: %2). 전파 법칙은 그렇지 않습니다. 또는 공칭값과의 편차를 평가하십시오.</translation>
    </message>
    <message>
        <source>%1 has errors: it is not known which U may be stated for %2</source>
        <translation>%1에 오류가 있습니다. %2에 어떤 U를 기재할 수 있는지 알 수 없습니다</translation>
    </message>
    <message>
        <source>U of %1 is the best measurement capability of the laboratory, with k = 2</source>
        <translation>%1의 U는 시험소의 최고 측정 능력이며 k = 2입니다</translation>
    </message>
    <message>
        <source>%1 is not stated: U is below the best measurement capability of the laboratory</source>
        <translation>%1은(는) 기재하지 않습니다. U가 시험소의 최고 측정 능력보다 작습니다</translation>
    </message>
    <message>
        <source>Evaluated</source>
        <translation>평가</translation>
    </message>
    <message>
        <source>before and after by the law of propagation</source>
        <translation>이전과 이후 모두 전파 법칙으로</translation>
    </message>
    <message>
        <source>before and after as each project says</source>
        <translation>이전과 이후 모두 각 프로젝트가 정한 대로</translation>
    </message>
    <message>
        <source>The change of the value is given in units of the expanded uncertainty before.</source>
        <translation>값의 변화는 이전 확장불확도 단위로 나타냅니다.</translation>
    </message>
    <message>
        <source>and %1 more closures are beyond %2 times their u</source>
        <translation>그 밖에 폐합차 %1개가 그 u의 %2배를 넘습니다</translation>
    </message>
    <message>
        <source>%1 closures are beyond %2 times their u (0.1 % for all of them together).</source>
        <translation>폐합차 %1개가 그 u의 %2배를 넘습니다(모두 합하여 0.1 %).</translation>
    </message>
    <message>
        <source>The reversibility error was not measured at every step; where it was not, it is held against no limit.</source>
        <translation>가역성 오차를 모든 단계에서 측정하지는 않았습니다. 측정하지 않은 곳은 어떤 한계와도 비교하지 않습니다.</translation>
    </message>
    <message>
        <source>RP_R of %1</source>
        <translation>%1의 RP_R</translation>
    </message>
</context>
<context>
    <name>covaria::ui</name>
    <message>
        <source>Add %1</source>
        <translation>%1 추가</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>“%1”은(는) 수가 아닙니다.</translation>
    </message>
    <message>
        <source>“%1” is not a unit.</source>
        <translation>“%1”은(는) 단위가 아닙니다.</translation>
    </message>
    <message>
        <source>a number without unit is expected.</source>
        <translation>단위 없는 수가 필요합니다.</translation>
    </message>
    <message>
        <source>a unit like %1 is expected.</source>
        <translation>%1 같은 단위가 필요합니다.</translation>
    </message>
    <message>
        <source>The unit %1 does not fit here: </source>
        <translation>단위 %1은(는) 여기에 맞지 않습니다: </translation>
    </message>
    <message>
        <source>“%1” is not a whole number.</source>
        <translation>“%1”은(는) 정수가 아닙니다.</translation>
    </message>
    <message>
        <source>“%1” is not one of: %2.</source>
        <translation>“%1”은(는) 다음 중 하나가 아닙니다: %2.</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>예</translation>
    </message>
    <message>
        <source>no</source>
        <translation>아니요</translation>
    </message>
    <message>
        <source>“%1” is neither yes nor no.</source>
        <translation>“%1”은(는) 예도 아니요도 아닙니다.</translation>
    </message>
    <message>
        <source>The value must be greater than %1.</source>
        <translation>값은 %1보다 커야 합니다.</translation>
    </message>
    <message>
        <source>The value must be at least %1.</source>
        <translation>값은 %1 이상이어야 합니다.</translation>
    </message>
    <message>
        <source>The value must be at most %1.</source>
        <translation>값은 %1 이하여야 합니다.</translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation>자유도</translation>
    </message>
    <message>
        <source>Unsaved Changes</source>
        <translation>저장하지 않은 변경</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>“%1”의 변경 내용을 저장할까요?</translation>
    </message>
    <message>
        <source>Without saving they are lost.</source>
        <translation>저장하지 않으면 사라집니다.</translation>
    </message>
    <message>
        <source>File Changed</source>
        <translation>파일 변경됨</translation>
    </message>
    <message>
        <source>Another program changed “%1”.</source>
        <translation>다른 프로그램이 “%1”을(를) 변경했습니다.</translation>
    </message>
    <message>
        <source>Reading it again loses your unsaved changes.</source>
        <translation>다시 읽으면 저장하지 않은 변경이 사라집니다.</translation>
    </message>
    <message>
        <source>It can be read again.</source>
        <translation>다시 읽을 수 있습니다.</translation>
    </message>
    <message>
        <source>Read Again</source>
        <translation>다시 읽기</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>내 것 유지</translation>
    </message>
    <message>
        <source>Recover Unsaved Work</source>
        <translation>저장하지 않은 작업 복구</translation>
    </message>
    <message>
        <source>Covaria did not end properly. Unsaved work was kept:</source>
        <translation>Covaria가 정상적으로 종료되지 않았습니다. 저장하지 않은 작업이 보존되었습니다:</translation>
    </message>
    <message>
        <source>Open Project</source>
        <translation>프로젝트 열기</translation>
    </message>
    <message>
        <source>Covaria project or report (*.covaria *.pdf)</source>
        <translation>Covaria 프로젝트 또는 보고서 (*.covaria *.pdf)</translation>
    </message>
    <message>
        <source>About Covaria</source>
        <translation>Covaria 정보</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Covaria %1&lt;/h3&gt;&lt;p&gt;Measurement uncertainty of robots and large-scale metrology.&lt;br&gt;Evaluates by JCGM 100, 101 and 102.&lt;/p&gt;&lt;p&gt;Qt %2, VTK %3, Eigen %4&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Covaria %1&lt;/h3&gt;&lt;p&gt;로봇과 대형 측정의 측정불확도.&lt;br&gt;JCGM 100, 101, 102에 따라 평가합니다.&lt;/p&gt;&lt;p&gt;Qt %2, VTK %3, Eigen %4&lt;/p&gt;</translation>
    </message>
    <message>
        <source>symbol</source>
        <translation>기호</translation>
    </message>
    <message>
        <source>As the equations use it; further rows of a symbol add components</source>
        <translation>방정식이 쓰는 기호. 같은 기호의 다음 행은 성분을 추가합니다</translation>
    </message>
    <message>
        <source>quantity</source>
        <translation>양</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>무엇인지</translation>
    </message>
    <message>
        <source>estimate</source>
        <translation>추정값</translation>
    </message>
    <message>
        <source>In the row&apos;s unit: 50.000 838 or 50.000 838 mm</source>
        <translation>행의 단위로: 50.000 838 또는 50.000 838 mm</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>단위</translation>
    </message>
    <message>
        <source>stated as</source>
        <translation>제시 형식</translation>
    </message>
    <message>
        <source>type</source>
        <translation>유형</translation>
    </message>
    <message>
        <source>Type A or Type B evaluation (JCGM 100 2.3.2, 2.3.3)</source>
        <translation>A형 또는 B형 평가(JCGM 100 2.3.2, 2.3.3)</translation>
    </message>
    <message>
        <source>Degrees of freedom; empty: infinite, or those of the observations</source>
        <translation>자유도. 비어 있으면 무한대, 또는 관측값의 자유도</translation>
    </message>
    <message>
        <source>Standard uncertainty, in the row&apos;s unit</source>
        <translation>표준불확도, 행의 단위로</translation>
    </message>
    <message>
        <source>Sensitivity coefficient, unit of the result per unit of the row</source>
        <translation>감도계수, 행의 단위당 결과의 단위</translation>
    </message>
    <message>
        <source>Contribution to the standard uncertainty of the result</source>
        <translation>결과의 표준불확도에 대한 기여</translation>
    </message>
    <message>
        <source>share / %</source>
        <translation>비율 / %</translation>
    </message>
    <message>
        <source>Share of the variance, with its part of the covariances</source>
        <translation>공분산의 몫을 포함한 분산의 비율</translation>
    </message>
    <message>
        <source>source</source>
        <translation>출처</translation>
    </message>
    <message>
        <source>Where the figure comes from</source>
        <translation>수치가 나온 곳</translation>
    </message>
    <message>
        <source>Standard uncertainty of the position in space: square root of the sum of the variances of its three coordinates</source>
        <translation>공간상 위치의 표준불확도: 세 좌표의 분산의 합의 제곱근</translation>
    </message>
    <message>
        <source>, as good as %1 plain trials</source>
        <translation>, 일반 시행 %1회에 상당</translation>
    </message>
    <message>
        <source>Preview by the law of propagation, without Monte Carlo</source>
        <translation>전파 법칙에 의한 미리보기, 몬테카를로 없음</translation>
    </message>
    <message>
        <source>Preview with %1 trials, before the adaptive procedure</source>
        <translation>적응형 절차 전, 시행 %1회의 미리보기</translation>
    </message>
    <message>
        <source>Preview with %1 of %2 trials</source>
        <translation>시행 %2회 중 %1회의 미리보기</translation>
    </message>
    <message>
        <source>Law of propagation of uncertainty</source>
        <translation>불확도 전파 법칙</translation>
    </message>
    <message>
        <source>Monte Carlo, %1 trials</source>
        <translation>몬테카를로, 시행 %1회</translation>
    </message>
    <message>
        <source>Out of date: of the project as it was</source>
        <translation>갱신 필요: 이전 상태의 프로젝트</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>%1 복제</translation>
    </message>
    <message>
        <source>Expanded uncertainty</source>
        <translation>확장불확도</translation>
    </message>
    <message>
        <source>the picture shows no result of the analysis</source>
        <translation>그림이 이 분석의 결과를 보여 주지 않습니다</translation>
    </message>
    <message>
        <source>the coordinates of %1 are no quantities of the analysis</source>
        <translation>%1의 좌표가 이 분석의 양이 아닙니다</translation>
    </message>
    <message>
        <source>%1 is a constant: no uncertainty is stated for it</source>
        <translation>%1은(는) 상수이며 불확도가 명시되지 않았습니다</translation>
    </message>
    <message>
        <source>the joint covariance of the points is not known</source>
        <translation>점들의 결합 공분산을 알 수 없습니다</translation>
    </message>
    <message>
        <source>the angle is too close to 0° or 180°, or the points are too close, for the law of propagation</source>
        <translation>각도가 0° 또는 180°에 너무 가깝거나 점들이 너무 가까워 전파 법칙을 쓸 수 없습니다</translation>
    </message>
    <message>
        <source>the points are too close to each other for the law of propagation</source>
        <translation>점들이 서로 너무 가까워 전파 법칙을 쓸 수 없습니다</translation>
    </message>
    <message>
        <source>%1, u = %2</source>
        <translation>%1, u = %2</translation>
    </message>
    <message>
        <source>Angle at %1 between %2 and %3: %4</source>
        <translation>%1에서 %2와(과) %3 사이의 각도: %4</translation>
    </message>
    <message>
        <source>Distance %1 to %2: %3</source>
        <translation>%1에서 %2까지의 거리: %3</translation>
    </message>
    <message>
        <source>; u not stated, because %1</source>
        <translation>; u를 명시하지 않은 이유: %1</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>등각</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>위</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>앞</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>오른쪽</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>아래</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>뒤</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>왼쪽</translation>
    </message>
    <message>
        <source>Add an analysis</source>
        <translation>분석 추가</translation>
    </message>
    <message>
        <source>The plus sign in the toolbar adds what a project consists of. Choose Measurement equation from its menu.</source>
        <translation>도구 모음의 더하기 표시는 프로젝트를 이루는 것을 추가합니다. 그 메뉴에서 측정 방정식을 고르십시오.</translation>
    </message>
    <message>
        <source>Name the quantities</source>
        <translation>양에 이름 붙이기</translation>
    </message>
    <message>
        <source>Replace the equation in the field Equations by yours, such as l = l_S + d. Every name that it uses becomes a row of the budget when you leave the field.</source>
        <translation>방정식 필드의 식을 l = l_S + d 같은 자신의 식으로 바꾸십시오. 필드를 떠나면 식에 쓰인 이름마다 총괄표의 행이 생깁니다.</translation>
    </message>
    <message>
        <source>State an uncertainty</source>
        <translation>불확도 적기</translation>
    </message>
    <message>
        <source>Type the estimate of each quantity into its row, such as 50 mm, and what is known of it under “stated as”, such as 75 nm. “rect 30 nm” and “U = 0.3 um, k = 2” are read as they are typed.</source>
        <translation>각 양의 행에 50 mm 같은 추정값을, “제시 형식”에는 75 nm처럼 알려진 것을 입력하십시오. “rect 30 nm”와 “U = 0.3 um, k = 2”는 입력한 그대로 읽힙니다.</translation>
    </message>
    <message>
        <source>See the result</source>
        <translation>결과 보기</translation>
    </message>
    <message>
        <source>Correlate two quantities</source>
        <translation>두 양의 상관</translation>
    </message>
    <message>
        <source>Select two rows of the budget, the second with Ctrl, and type their correlation coefficient r into the field below, such as 0.5. The result takes it into account at once.</source>
        <translation>총괄표의 두 행을 고르고(둘째 행은 Ctrl과 함께) 아래 필드에 상관계수 r을 0.5처럼 입력하십시오. 결과에 바로 반영됩니다.</translation>
    </message>
    <message>
        <source>State a requirement</source>
        <translation>요구 사항 적기</translation>
    </message>
    <message>
        <source>Type the uncertainty that must not be exceeded as Target uncertainty. The verdict below it, and in the table of results, follows every change.</source>
        <translation>넘어서는 안 되는 불확도를 목표불확도로 입력하십시오. 그 아래와 결과 표의 판정이 바꿀 때마다 따라옵니다.</translation>
    </message>
    <message>
        <source>See what contributes most</source>
        <translation>가장 크게 기여하는 것 보기</translation>
    </message>
    <message>
        <source>Keep and compare</source>
        <translation>보관하고 비교하기</translation>
    </message>
    <message>
        <source>Run the analysis (F5), press Keep as Before, and change a value of the budget. The tab Compare shows the results before and after beside each other.</source>
        <translation>분석을 실행하고(F5) 이전 결과로 보관을 누른 다음 총괄표의 값을 바꾸십시오. 비교 탭이 전후 결과를 나란히 보여 줍니다.</translation>
    </message>
    <message>
        <source>Look at the report</source>
        <translation>보고서 보기</translation>
    </message>
    <message>
        <source>Save it as PDF</source>
        <translation>PDF로 저장</translation>
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
        <translation># 단축키

| 키 | 동작 |
|---|---|
| Ctrl+N, Ctrl+O, Ctrl+S | 새로 만들기, 열기, 저장 |
| Ctrl+Z; Ctrl+Shift+Z 또는 Ctrl+Y | 실행 취소; 다시 실행 |
| F6, Shift+F6 | 다음 창, 이전 창 |
| F11 | 불확도 총괄표 또는 장면만 보기, 다시 누르면 돌아옴 |
| 표에서 Tab, Shift+Tab | 다음, 이전 셀, 마지막 셀 다음으로 계속; Ctrl과 함께 바로 표 밖으로 |
| 예산에서 Ctrl+R | 선택한 두 행의 상관 계수 |
| F5, Ctrl+F5, Esc | 이 분석 실행, 모두 실행, 중지 |
| F2, Ctrl+D, Delete | 선택한 항목 이름 바꾸기, 복제, 삭제 |
| 화살표 키, + 및 − | 장면 회전과 확대/축소 |
| 1부터 7, F | 등각, 위, 앞, 오른쪽, 아래, 뒤, 왼쪽 보기, 맞춤 (어디서나 Ctrl+1부터 Ctrl+7) |
| H, I, Shift+H | 장면에서 선택한 것 숨기기, 그것만 표시, 모두 표시 |
| 장면에서 끌기 | 대상을 옮기고, 축의 끝을 끌면 회전합니다. Ctrl을 누르면 일정한 간격으로 움직입니다 |
| D, A | 장면에서 거리, 각도 측정. Esc를 누르면 도구를 끝냅니다 |
| 보고서에서 +, −, Ctrl+휠 | 쪽을 크게, 작게; Alt+위, Alt+아래: 이전, 다음 쪽 |
| Ctrl+C, Ctrl+V | 셀 블록 복사와 붙여넣기 |
| Ctrl+K | 모두 찾기: 분석, 양, 결과, 필드, 명령, 도움말 |
| F1 | 포커스가 있는 필드, 셀, 항목의 도움말 |
</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>실행 취소(&amp;U): %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>실행 취소(&amp;U)</translation>
    </message>
    <message>
        <source>The analysis is not complete yet: what must still be given is listed under Problems.</source>
        <translation>분석이 아직 완전하지 않습니다. 더 필요한 것은 ‘문제’에 나열되어 있습니다.</translation>
    </message>
    <message>
        <source>The analysis has problems; they are listed under Problems.</source>
        <translation>분석에 문제가 있습니다. ‘문제’에 나열되어 있습니다.</translation>
    </message>
    <message>
        <source>Adaptive Monte Carlo, %1 trials</source>
        <translation>적응 몬테카를로, 시행 %1회</translation>
    </message>
    <message>
        <source>; k leaves degrees of freedom out (normal draws)</source>
        <translation>; k에 자유도 미반영(정규분포 추출)</translation>
    </message>
    <message>
        <source>, chosen k = %1</source>
        <translation>, 선택한 k = %1</translation>
    </message>
    <message>
        <source>Of the estimate, and of what is stated without a unit</source>
        <translation>추정값과 단위 없이 제시된 것의 단위</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>실행 취소됨: %1</translation>
    </message>
    <message>
        <source>Before these steps</source>
        <translation>이 단계들 이전</translation>
    </message>
    <message>
        <source>Undo Lis&amp;t</source>
        <translation>단계 목록(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>다시 실행(&amp;R)</translation>
    </message>
    <message>
        <source>Done again: %1</source>
        <translation>다시 실행됨: %1</translation>
    </message>
    <message>
        <source>Type it as %1.</source>
        <translation>%1(으)로 쓰십시오.</translation>
    </message>
    <message>
        <source>Type it as %1, or as %2.</source>
        <translation>%1 또는 %2(으)로 쓰십시오.</translation>
    </message>
    <message>
        <source>met</source>
        <translation>충족</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>미충족</translation>
    </message>
    <message>
        <source>The result is there when every quantity has its uncertainty, above the budget and in the tab Results. It follows every change at once.</source>
        <translation>모든 양에 불확도가 있으면 총괄표 위와 결과 탭에 결과가 나타납니다. 결과는 모든 변경을 바로 따라갑니다.</translation>
    </message>
    <message>
        <source>The tab Contributions has them as a table and as a chart, the largest first. What is at the top is worth improving.</source>
        <translation>기여 탭에는 기여가 표와 차트로, 큰 것부터 나옵니다. 맨 위에 있는 것이 개선할 가치가 있습니다.</translation>
    </message>
    <message>
        <source>The tab Document shows the pages as they are printed, of the report or of the certificate. It has results that are up to date only: run the analysis first (F5).</source>
        <translation>문서 탭은 보고서나 성적서의 쪽을 인쇄되는 대로 보여 줍니다. 최신 결과만 들어가므로 먼저 분석을 실행하십시오(F5).</translation>
    </message>
    <message>
        <source>Report as PDF in the toolbar (Ctrl+P) writes the report with the project in it, so that Covaria can open it again. While the tab Document shows the certificate, the button writes that; it is also in the menu File under Export.</source>
        <translation>도구 모음의 PDF 보고서(Ctrl+P)는 프로젝트를 담은 보고서를 만들므로 Covaria에서 다시 열 수 있습니다. 문서 탭에 성적서가 표시되어 있는 동안에는 이 단추가 성적서를 만듭니다. 파일 메뉴의 내보내기에도 있습니다.</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>갱신 필요</translation>
    </message>
    <message>
        <source>Kept projects</source>
        <translation>보관된 프로젝트</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>복구</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>나중에</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>버리기</translation>
    </message>
    <message>
        <source>distr.</source>
        <translation>분포</translation>
    </message>
    <message>
        <source>Distribution that Monte Carlo draws</source>
        <translation>몬테카를로가 추출하는 분포</translation>
    </message>
</context>
<context>
    <name>covaria::ui::AllResultsModel</name>
    <message>
        <source>Analysis</source>
        <translation>분석</translation>
    </message>
    <message>
        <source>Coverage interval of the result line</source>
        <translation>결과 줄의 포함구간</translation>
    </message>
    <message>
        <source>State</source>
        <translation>상태</translation>
    </message>
    <message>
        <source>Double click: goes to the analysis</source>
        <translation>두 번 클릭: 해당 분석으로 이동</translation>
    </message>
</context>
<context>
    <name>covaria::ui::AllResultsTab</name>
    <message>
        <source>Filter: analysis, symbol, name, group</source>
        <translation>필터: 분석, 기호, 이름, 그룹</translation>
    </message>
    <message>
        <source>Filter of all results</source>
        <translation>모든 결과 필터</translation>
    </message>
    <message>
        <source>Not met only</source>
        <translation>미충족만</translation>
    </message>
    <message>
        <source>Only results whose target uncertainty or tolerance is not met</source>
        <translation>목표불확도 또는 허용차를 충족하지 않는 결과만</translation>
    </message>
    <message>
        <source>all-results</source>
        <translation>모든-결과</translation>
    </message>
    <message>
        <source>up to date</source>
        <translation>최신</translation>
    </message>
    <message>
        <source>%1 of %2 requirements met</source>
        <translation>요구사항 %2개 중 %1개 충족</translation>
    </message>
    <message>
        <source>%1 of %2 analyses have no result: press Ctrl+F5</source>
        <translation>분석 %2개 중 %1개에 결과가 없습니다: Ctrl+F5를 누르십시오</translation>
    </message>
    <message>
        <source>; </source>
        <translation>; </translation>
    </message>
    <message>
        <source>%1 of %2 analyses have no result: they lack something or have problems</source>
        <translation>분석 %2개 중 %1개에 결과가 없습니다. 빠진 것이 있거나 문제가 있습니다</translation>
    </message>
</context>
<context>
    <name>covaria::ui::AnswerStrip</name>
    <message>
        <source>Answer</source>
        <translation>답</translation>
    </message>
    <message>
        <source>Output quantity of the budget and the charts</source>
        <translation>총괄표와 차트의 출력량</translation>
    </message>
    <message>
        <source>Output quantity</source>
        <translation>출력량</translation>
    </message>
    <message>
        <source>Copy the result, as it stands in a certificate</source>
        <translation>결과를 성적서에 적히는 형태로 복사</translation>
    </message>
    <message>
        <source>Copy the result</source>
        <translation>결과 복사</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>다음 단계</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>실패</translation>
    </message>
    <message>
        <source>incomplete</source>
        <translation>미완성</translation>
    </message>
    <message>
        <source>has problems</source>
        <translation>문제 있음</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>갱신 필요</translation>
    </message>
    <message>
        <source>not evaluated</source>
        <translation>평가하지 않음</translation>
    </message>
    <message>
        <source>Select an analysis to see its results.</source>
        <translation>결과를 보려면 분석을 선택하세요.</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>실패: %1</translation>
    </message>
    <message>
        <source>Not complete yet: nothing is wrong.</source>
        <translation>아직 미완성: 잘못된 것은 없습니다.</translation>
    </message>
    <message>
        <source>Not complete yet, but not wrong; to give next: %1</source>
        <translation>아직 미완성이지만 잘못된 것은 없습니다. 다음으로 입력할 것: %1</translation>
    </message>
    <message>
        <source>Not evaluated yet: press F5.</source>
        <translation>아직 평가하지 않음: F5를 누르세요.</translation>
    </message>
    <message>
        <source>The analysis has problems.</source>
        <translation>분석에 문제가 있습니다.</translation>
    </message>
    <message>
        <source>; running</source>
        <translation>; 실행 중</translation>
    </message>
    <message>
        <source>; press F5 for the result</source>
        <translation>; 결과를 보려면 F5를 누르세요</translation>
    </message>
    <message>
        <source>; %1 trials without a value</source>
        <translation>; 값이 없는 시행 %1회</translation>
    </message>
    <message>
        <source>&lt;b&gt;Does not represent the measurand&lt;/b&gt; (more than 1 % of the trials are lost). </source>
        <translation>&lt;b&gt;측정량을 나타내지 않습니다&lt;/b&gt;(시행의 1 % 넘게 손실됨). </translation>
    </message>
    <message>
        <source>; not stabilised</source>
        <translation>; 안정되지 않음</translation>
    </message>
    <message>
        <source>&lt;b&gt;Out of date&lt;/b&gt;: shown for the project as it was. </source>
        <translation>&lt;b&gt;갱신 필요&lt;/b&gt;: 이전 상태의 프로젝트를 표시합니다. </translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>다음: %1</translation>
    </message>
    <message>
        <source>Goes to the field that must be given next</source>
        <translation>다음에 입력해야 할 필드로 이동합니다</translation>
    </message>
    <message>
        <source>Show the Field</source>
        <translation>필드 보기</translation>
    </message>
</context>
<context>
    <name>covaria::ui::AssetEvaluation</name>
    <message>
        <source>The asset has problems; they are listed below the scene.</source>
        <translation>에셋에 문제가 있습니다. 장면 아래에 나열되어 있습니다.</translation>
    </message>
    <message>
        <source>This asset is used as it is specified; nothing is evaluated.</source>
        <translation>이 에셋은 지정된 대로 쓰이며, 평가할 것이 없습니다.</translation>
    </message>
    <message>
        <source>Evaluation of the asset</source>
        <translation>에셋의 평가</translation>
    </message>
</context>
<context>
    <name>covaria::ui::BudgetFootModel</name>
    <message>
        <source>Out of date: being computed.</source>
        <translation>갱신 필요: 계산 중입니다.</translation>
    </message>
    <message>
        <source>Combined standard uncertainty by the law of propagation</source>
        <translation>전파 법칙에 의한 합성표준불확도</translation>
    </message>
</context>
<context>
    <name>covaria::ui::BudgetPage</name>
    <message>
        <source>Budget</source>
        <translation>총괄표</translation>
    </message>
    <message>
        <source>Correlation of Two Rows</source>
        <translation>두 행의 상관</translation>
    </message>
    <message>
        <source>c and share by the law of propagation, whose u is %1 of that by Monte Carlo</source>
        <translation>전파 법칙에 의한 c와 비율. 그 u는 몬테카를로에 의한 u의 %1</translation>
    </message>
    <message>
        <source>Result of the budget</source>
        <translation>총괄표의 결과</translation>
    </message>
</context>
<context>
    <name>covaria::ui::BudgetSheetModel</name>
    <message>
        <source>Out of date: being computed.</source>
        <translation>갱신 필요: 계산 중입니다.</translation>
    </message>
    <message>
        <source>Type a name here to add a quantity</source>
        <translation>양을 추가하려면 여기에 이름을 입력하세요</translation>
    </message>
    <message>
        <source>“%1” is not a number of degrees of freedom.</source>
        <translation>“%1”은(는) 자유도가 아닙니다.</translation>
    </message>
    <message>
        <source>Name the quantity before its observations.</source>
        <translation>관측값보다 먼저 양의 기호를 입력하십시오.</translation>
    </message>
    <message>
        <source>The observations are read from %1.</source>
        <translation>관측값은 %1에서 읽습니다.</translation>
    </message>
    <message>
        <source>type or paste rows</source>
        <translation>입력 또는 행 붙여넣기</translation>
    </message>
</context>
<context>
    <name>covaria::ui::BudgetSheetView</name>
    <message>
        <source>Show Quantity</source>
        <translation>양 표시</translation>
    </message>
    <message>
        <source>Its components, observations, correlations and notes</source>
        <translation>성분, 관측값, 상관관계 및 메모</translation>
    </message>
</context>
<context>
    <name>covaria::ui::BudgetTableModel</name>
    <message>
        <source>An estimate by sampling with a standard error of %1 %: S can exceed S total by chance</source>
        <translation>표준오차가 %1 %인 표본 추출 추정값입니다. S가 우연히 전체 S보다 클 수 있습니다</translation>
    </message>
</context>
<context>
    <name>covaria::ui::CertificateForm</name>
    <message>
        <source>Required by %1.</source>
        <translation>%1에서 요구합니다.</translation>
    </message>
    <message>
        <source>Asked for by %1 where it applies.</source>
        <translation>해당하는 경우 %1에서 요구합니다.</translation>
    </message>
    <message>
        <source>Next Missing</source>
        <translation>다음 누락</translation>
    </message>
    <message>
        <source>What the certificate lacks</source>
        <translation>성적서에 빠진 것</translation>
    </message>
    <message>
        <source>Goes to the next field that %1 requires and that is empty</source>
        <translation>%1에서 요구하지만 비어 있는 다음 필드로 이동합니다</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 변경</translation>
    </message>
    <message>
        <source>Everything that %1 requires beside the results is stated.</source>
        <translation>결과 외에 %1에서 요구하는 모든 것이 기재되었습니다.</translation>
    </message>
    <message>
        <source>For File › Export › Certificate. A clause of %1 stands where it requires something; a report needs none of it.</source>
        <translation>파일 › 내보내기 › 성적서용입니다. %1의 조항은 그것이 무엇을 요구하는 곳에 표시됩니다. 보고서에는 필요하지 않습니다.</translation>
    </message>
    <message>
        <source>%1 of %2 required texts are stated; missing: %3.</source>
        <translation>필수 텍스트 %2개 중 %1개 기재됨, 누락: %3.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg)</source>
        <translation>그림 (*.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>English (none chosen)</source>
        <translation>영어 (선택 안 함)</translation>
    </message>
    <message>
        <source>Required by %1 where conformity is stated.</source>
        <translation>적합성을 진술하는 경우 %1이(가) 요구합니다.</translation>
    </message>
    <message>
        <source>in the laboratory, or at the place stated</source>
        <translation>시험실에서, 또는 명시된 장소에서</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ChartView</name>
    <message>
        <source>Run the analysis to see this chart</source>
        <translation>이 차트를 보려면 분석을 실행하세요</translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation>%1 파일 (*.%2)</translation>
    </message>
    <message>
        <source>Save Chart</source>
        <translation>차트 저장</translation>
    </message>
    <message>
        <source>Show All</source>
        <translation>모두 표시</translation>
    </message>
    <message>
        <source>Copy Picture</source>
        <translation>그림 복사</translation>
    </message>
    <message>
        <source>Copy Data</source>
        <translation>데이터 복사</translation>
    </message>
    <message>
        <source>Save as %1 …</source>
        <translation>%1(으)로 저장 …</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ColumnTableModel</name>
    <message>
        <source>Out of date: the project has changed since.</source>
        <translation>갱신 필요: 이후 프로젝트가 변경되었습니다.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::CompareTab</name>
    <message>
        <source>Keep as Before</source>
        <translation>이전 결과로 보관</translation>
    </message>
    <message>
        <source>Keeps the present results of this analysis, to compare later ones with</source>
        <translation>나중 결과와 비교하도록 이 분석의 현재 결과를 보관합니다</translation>
    </message>
    <message>
        <source>Go Back to Kept State</source>
        <translation>보관된 상태로 되돌리기</translation>
    </message>
    <message>
        <source>Discard Kept State</source>
        <translation>보관된 상태 버리기</translation>
    </message>
    <message>
        <source>Forgets the kept results; the project stays as it is now</source>
        <translation>보관된 결과를 버립니다. 프로젝트는 지금 상태로 유지됩니다</translation>
    </message>
    <message>
        <source>comparison</source>
        <translation>비교</translation>
    </message>
    <message>
        <source>budget-changes</source>
        <translation>총괄표-변화</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>차트</translation>
    </message>
    <message>
        <source>Distributions</source>
        <translation>분포</translation>
    </message>
    <message>
        <source>Changes of the budget</source>
        <translation>총괄표의 변화</translation>
    </message>
    <message>
        <source>The results are kept: the tab Compare shows them beside those to come.</source>
        <translation>결과를 보관했습니다. 비교 탭에서 앞으로의 결과와 나란히 보여 줍니다.</translation>
    </message>
    <message>
        <source>Go back to kept state</source>
        <translation>보관된 상태로 되돌리기</translation>
    </message>
    <message>
        <source>Select an analysis to compare its results.</source>
        <translation>결과를 비교할 분석을 선택하세요.</translation>
    </message>
    <message>
        <source>Before: %1, kept at %2. </source>
        <translation>전: %1, %2에 보관. </translation>
    </message>
    <message>
        <source>After: no results.</source>
        <translation>후: 결과 없음.</translation>
    </message>
    <message>
        <source>After: %1</source>
        <translation>후: %1</translation>
    </message>
    <message>
        <source>Go Back to Kept</source>
        <translation>보관 상태로</translation>
    </message>
    <message>
        <source>Discard Kept</source>
        <translation>보관 상태 버리기</translation>
    </message>
    <message>
        <source>The present results are kept in place of those kept before.</source>
        <translation>현재 결과를 이전에 보관한 결과 대신 보관했습니다.</translation>
    </message>
    <message>
        <source>Replace Kept State</source>
        <translation>보관된 상태 바꾸기</translation>
    </message>
    <message>
        <source>Keeps the present results in place of those kept before, which are forgotten</source>
        <translation>현재 결과를 이전에 보관한 결과 대신 보관하며, 이전 것은 지워집니다</translation>
    </message>
    <message>
        <source>Run the analysis (F5), then keep its results with “%1”.</source>
        <translation>분석을 실행(F5)한 다음 ‘%1’(으)로 결과를 보관하세요.</translation>
    </message>
    <message>
        <source>results that are computed again once the analysis has run</source>
        <translation>분석이 실행되면 다시 계산되는 결과</translation>
    </message>
    <message>
        <source>Compare With Another Project</source>
        <translation>다른 프로젝트와 비교</translation>
    </message>
    <message>
        <source>Covaria project (*.covaria)</source>
        <translation>Covaria 프로젝트 (*.covaria)</translation>
    </message>
    <message>
        <source>Analysis of that project:</source>
        <translation>그 프로젝트의 분석:</translation>
    </message>
    <message>
        <source>Compare With</source>
        <translation>비교 대상</translation>
    </message>
    <message>
        <source>Another analysis, of this project or of another one, stands in the place of kept results</source>
        <translation>이 프로젝트나 다른 프로젝트의 다른 분석이 보관된 결과의 자리를 대신합니다</translation>
    </message>
    <message>
        <source>Another Project …</source>
        <translation>다른 프로젝트 …</translation>
    </message>
    <message>
        <source>%1 has no analysis.</source>
        <translation>%1에는 분석이 없습니다.</translation>
    </message>
    <message>
        <source>The tab Compare shows %1 as before.</source>
        <translation>비교 탭에 %1이(가) 이전 결과로 표시됩니다.</translation>
    </message>
    <message>
        <source>Keep the present results with “%1” and edit, or choose another analysis by “%2”: before and after stand here beside each other.</source>
        <translation>“%1”(으)로 현재 결과를 보관한 뒤 편집하거나 “%2”(으)로 다른 분석을 고르십시오. 이전과 이후가 여기에 나란히 표시됩니다.</translation>
    </message>
    <message>
        <source>Before: %1 (%2), taken at %3. </source>
        <translation>이전: %1 (%2), %3에 가져옴. </translation>
    </message>
    <message>
        <source>Makes the analysis, and what it uses, what they were when the results were kept, and the coverage factor of the project; can be undone</source>
        <translation>분석과 그것이 사용하는 것, 프로젝트의 포함 인자를 결과를 보관했을 때의 상태로 되돌립니다. 실행 취소할 수 있습니다</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ComponentsEdit</name>
    <message>
        <source>Add</source>
        <translation>추가</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>제거</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>초기화</translation>
    </message>
    <message>
        <source>Components of uncertainty</source>
        <translation>불확도 성분</translation>
    </message>
    <message>
        <source>Name of the component</source>
        <translation>성분의 이름</translation>
    </message>
    <message>
        <source>Type of evaluation</source>
        <translation>평가 유형</translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation>자유도</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>출처</translation>
    </message>
    <message>
        <source>Back to the components that the model gives</source>
        <translation>모델이 주는 성분으로 되돌립니다</translation>
    </message>
    <message>
        <source>Type A (from observations)</source>
        <translation>A형(관측값에서)</translation>
    </message>
    <message>
        <source>Type B (other means)</source>
        <translation>B형(다른 방법)</translation>
    </message>
    <message>
        <source>Degrees of freedom of the standard uncertainty; empty: infinitely many.</source>
        <translation>표준불확도의 자유도. 비어 있으면 무한대.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>이름</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>유형</translation>
    </message>
    <message>
        <source>Change component of %1</source>
        <translation>%1의 성분 변경</translation>
    </message>
    <message>
        <source>component %1</source>
        <translation>성분 %1</translation>
    </message>
    <message>
        <source>Add component to %1</source>
        <translation>%1에 성분 추가</translation>
    </message>
    <message>
        <source>Remove component of %1</source>
        <translation>%1의 성분 제거</translation>
    </message>
    <message>
        <source>Reset components of %1</source>
        <translation>%1의 성분 초기화</translation>
    </message>
    <message>
        <source>Its uncertainty comes from another analysis.</source>
        <translation>불확도는 다른 분석에서 옵니다.</translation>
    </message>
    <message>
        <source>Components that it shares with other quantities are edited where they are stated.</source>
        <translation>다른 양과 공유하는 성분은 명시된 곳에서 편집합니다.</translation>
    </message>
    <message>
        <source>It has no component of uncertainty yet.</source>
        <translation>아직 불확도 성분이 없습니다.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::CorrelationEdit</name>
    <message>
        <source>Add to the matrix</source>
        <translation>행렬에 추가</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>제거</translation>
    </message>
    <message>
        <source>Correlation coefficients between components of uncertainty</source>
        <translation>불확도 성분 사이의 상관계수</translation>
    </message>
    <message>
        <source>Component of uncertainty</source>
        <translation>불확도 성분</translation>
    </message>
    <message>
        <source>All components are uncorrelated. Add those that are correlated to the matrix.</source>
        <translation>모든 성분이 상관되지 않습니다. 상관된 성분을 행렬에 추가하세요.</translation>
    </message>
    <message>
        <source>The coefficients are possible together (positive semi-definite). Monte Carlo draws them with a Gaussian copula: exact for normal distributions, nearly so for others.</source>
        <translation>계수들은 함께 성립할 수 있습니다(양의 준정부호). 몬테카를로는 가우스 코퓰라로 추출합니다. 정규분포에는 정확하고, 다른 분포에는 거의 정확합니다.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::CorrelationTableModel</name>
    <message>
        <source>Correlation of %1 with %2</source>
        <translation>%1과(와) %2의 상관</translation>
    </message>
</context>
<context>
    <name>covaria::ui::CsvImportDialog</name>
    <message>
        <source>Import %1 into %2</source>
        <translation>%1을(를) %2(으)로 가져오기</translation>
    </message>
    <message>
        <source>found by itself</source>
        <translation>자동 인식</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>쉼표</translation>
    </message>
    <message>
        <source>semicolon</source>
        <translation>세미콜론</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>탭</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>미리보기</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>가져오기</translation>
    </message>
    <message>
        <source>&amp;Separator of cells</source>
        <translation>셀 구분자(&amp;S)</translation>
    </message>
    <message>
        <source>Column of the file</source>
        <translation>파일의 열</translation>
    </message>
    <message>
        <source>is read as</source>
        <translation>해석</translation>
    </message>
    <message>
        <source>Columns of the file</source>
        <translation>파일의 열</translation>
    </message>
    <message>
        <source>Column %1 is read as</source>
        <translation>열 %1의 해석</translation>
    </message>
    <message>
        <source>as it is named</source>
        <translation>이름대로</translation>
    </message>
    <message>
        <source>unknown: choose</source>
        <translation>알 수 없음: 선택</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>읽지 않음</translation>
    </message>
    <message>
        <source>The file cannot be imported: %1.</source>
        <translation>파일을 가져올 수 없습니다: %1.</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>%1행: %2</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s).</source>
        <translation>
            <numerusform>%n개 행.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more problem(s).</source>
        <translation>
            <numerusform>문제 %n개 더.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>covaria::ui::DateEditor</name>
    <message>
        <source>to</source>
        <translation>까지</translation>
    </message>
    <message>
        <source>%1, last day</source>
        <translation>%1, 마지막 날</translation>
    </message>
    <message>
        <source>Choose from a calendar</source>
        <translation>달력에서 선택</translation>
    </message>
    <message>
        <source>“%1” is no date of the form 2026-04-17.</source>
        <translation>“%1”은(는) 2026-04-17 형식의 날짜가 아닙니다.</translation>
    </message>
    <message>
        <source>The first day is missing.</source>
        <translation>첫째 날이 없습니다.</translation>
    </message>
    <message>
        <source>The last day is before the first.</source>
        <translation>마지막 날이 첫째 날보다 빠릅니다.</translation>
    </message>
    <message>
        <source>the same day</source>
        <translation>같은 날</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DensityPicture</name>
    <message>
        <source>Density of the distribution</source>
        <translation>분포의 밀도</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DesignBoxList</name>
    <message>
        <source>Add Box</source>
        <translation>상자 추가</translation>
    </message>
    <message>
        <source>To, %1</source>
        <translation>끝, %1</translation>
    </message>
    <message>
        <source>From, %1</source>
        <translation>시작, %1</translation>
    </message>
    <message>
        <source>Name of the box</source>
        <translation>상자의 이름</translation>
    </message>
    <message>
        <source>name, such as pillar</source>
        <translation>이름, 예: 기둥</translation>
    </message>
    <message>
        <source>Remove Box</source>
        <translation>상자 제거</translation>
    </message>
    <message>
        <source>From</source>
        <translation>시작</translation>
    </message>
    <message>
        <source>To</source>
        <translation>끝</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DesignReductionList</name>
    <message>
        <source>Add Reduction</source>
        <translation>감소 추가</translation>
    </message>
    <message>
        <source>One more uncertainty that can be made smaller for money</source>
        <translation>비용을 들여 작게 할 수 있는 불확도 하나 더</translation>
    </message>
    <message>
        <source>Smallest factor</source>
        <translation>최소 배율</translation>
    </message>
    <message>
        <source>The smallest factor that can be had, between 0 and 1</source>
        <translation>얻을 수 있는 가장 작은 배율, 0과 1 사이</translation>
    </message>
    <message>
        <source>Price of the first halving</source>
        <translation>첫 절반 감소의 가격</translation>
    </message>
    <message>
        <source>Law of the price</source>
        <translation>가격 법칙</translation>
    </message>
    <message>
        <source>price (1/f − 1)</source>
        <translation>가격 (1/f − 1)</translation>
    </message>
    <message>
        <source>price (1/f² − 1)/3: further readings</source>
        <translation>가격 (1/f² − 1)/3: 추가 읽음값</translation>
    </message>
    <message>
        <source>price log₂(1/f): every halving the same</source>
        <translation>가격 log₂(1/f): 절반 감소마다 동일</translation>
    </message>
    <message>
        <source>Remove Reduction</source>
        <translation>감소 제거</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>감소 대상</translation>
    </message>
    <message>
        <source>Least factor</source>
        <translation>최소 배율</translation>
    </message>
    <message>
        <source>First halving</source>
        <translation>첫 절반 감소</translation>
    </message>
    <message>
        <source>A factor f costs</source>
        <translation>배율 f의 비용</translation>
    </message>
    <message>
        <source>choose what is reduced</source>
        <translation>감소 대상 선택</translation>
    </message>
    <message>
        <source>Reductions</source>
        <translation>감소 방안</translation>
    </message>
    <message>
        <source>Each has a price; they take the place of variables and rows.</source>
        <translation>각각 값이 있으며, 변수와 행을 대신합니다.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DesignTab</name>
    <message>
        <source>Design</source>
        <translation>설계</translation>
    </message>
    <message>
        <source>Design of this analysis</source>
        <translation>이 분석의 설계</translation>
    </message>
    <message>
        <source>Run Design</source>
        <translation>설계 실행</translation>
    </message>
    <message>
        <source>Searches for the best design</source>
        <translation>최선의 설계를 탐색합니다</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>중지</translation>
    </message>
    <message>
        <source>Stops the search (Esc)</source>
        <translation>탐색을 중지합니다(Esc)</translation>
    </message>
    <message>
        <source>Edit …</source>
        <translation>편집 …</translation>
    </message>
    <message>
        <source>Variables, rows and objective of the design, in the properties of the analysis</source>
        <translation>분석 속성에 있는 설계의 변수, 행, 목적</translation>
    </message>
    <message>
        <source>Take Over This Design</source>
        <translation>이 설계 적용</translation>
    </message>
    <message>
        <source>Puts the values and rows that were found into the project; can be undone</source>
        <translation>찾은 값과 행을 프로젝트에 넣습니다. 실행 취소할 수 있습니다</translation>
    </message>
    <message>
        <source>Add Design …</source>
        <translation>설계 추가 …</translation>
    </message>
    <message>
        <source> – out of date</source>
        <translation> – 갱신 필요</translation>
    </message>
    <message>
        <source>%1 of %2 evaluations</source>
        <translation>평가 %2회 중 %1회</translation>
    </message>
    <message>
        <source>, best so far %1</source>
        <translation>, 현재 최선 %1</translation>
    </message>
    <message>
        <source>searching …</source>
        <translation>탐색 중 …</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>실패: %1</translation>
    </message>
    <message>
        <source>Not searched yet.</source>
        <translation>아직 탐색하지 않았습니다.</translation>
    </message>
    <message>
        <source>Nothing that was tried has a result.</source>
        <translation>시도한 것 중 결과가 있는 것이 없습니다.</translation>
    </message>
    <message>
        <source>The cheapest reductions cost %1</source>
        <translation>가장 저렴한 감소의 비용 %1</translation>
    </message>
    <message>
        <source>The cheapest rows cost %1</source>
        <translation>가장 저렴한 행의 비용 %1</translation>
    </message>
    <message>
        <source>, before %1</source>
        <translation>, 이전 %1</translation>
    </message>
    <message>
        <source>; &lt;b&gt;the target of U(%1) is not met&lt;/b&gt;</source>
        <translation>; &lt;b&gt;U(%1)의 목표 미충족&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Out of date&lt;/b&gt;: shown for the project as it was. </source>
        <translation>&lt;b&gt;갱신 필요&lt;/b&gt;: 이전 상태의 프로젝트를 표시합니다. </translation>
    </message>
    <message>
        <source>Take over design</source>
        <translation>설계 적용</translation>
    </message>
    <message>
        <source>“%1” shows the best that can be done with what the design may choose.</source>
        <translation>‘%1’을(를) 누르면 설계가 선택할 수 있는 범위에서 가능한 최선을 보여 줍니다.</translation>
    </message>
    <message>
        <source>A design finds where to stand and what to measure: add one with “%1”.</source>
        <translation>설계는 어디에 설치하고 무엇을 측정할지 찾습니다. ‘%1’(으)로 하나 추가하세요.</translation>
    </message>
    <message>
        <source> (law of propagation)</source>
        <translation> (전파 법칙)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DesignsForm</name>
    <message>
        <source>Design</source>
        <translation>설계</translation>
    </message>
    <message>
        <source>Adds a design of this analysis</source>
        <translation>이 분석의 설계를 추가합니다</translation>
    </message>
    <message>
        <source>Adds a copy of this design</source>
        <translation>이 설계의 사본을 추가합니다</translation>
    </message>
    <message>
        <source>Deletes this design</source>
        <translation>이 설계를 삭제합니다</translation>
    </message>
    <message>
        <source>Searches for the best design</source>
        <translation>최선의 설계를 탐색합니다</translation>
    </message>
    <message>
        <source>A design finds where to stand and what to measure: the numbers and the rows of the set-up that make the uncertainties smallest. Add one to let Covaria search.</source>
        <translation>설계는 어디에 설치하고 무엇을 측정할지, 즉 불확도를 가장 작게 하는 측정 구성의 수와 행을 찾습니다. 하나 추가하면 Covaria가 탐색합니다.</translation>
    </message>
    <message>
        <source>Add Variable</source>
        <translation>변수 추가</translation>
    </message>
    <message>
        <source>One more number that may be chosen</source>
        <translation>선택할 수 있는 수 하나 더</translation>
    </message>
    <message>
        <source>Name of the design</source>
        <translation>설계의 이름</translation>
    </message>
    <message>
        <source>Objective</source>
        <translation>목적</translation>
    </message>
    <message>
        <source>What is made smallest of the ratios of U to the target uncertainties; without targets to U of the present design</source>
        <translation>목표불확도에 대한 U의 비 가운데 최소화하는 것. 목표가 없으면 현재 설계의 U에 대한 비</translation>
    </message>
    <message>
        <source>Largest ratio</source>
        <translation>최대 비</translation>
    </message>
    <message>
        <source>Mean of the ratios</source>
        <translation>비의 평균</translation>
    </message>
    <message>
        <source>Root mean square of the ratios</source>
        <translation>비의 제곱평균제곱근</translation>
    </message>
    <message>
        <source>Cost of the rows, with all targets met</source>
        <translation>모든 목표를 충족하는 행의 비용</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>이름</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>최소화</translation>
    </message>
    <message>
        <source>Output quantities of the design</source>
        <translation>설계의 출력량</translation>
    </message>
    <message>
        <source>Output quantities looked at; with none ticked, all with a target uncertainty, or all measurands</source>
        <translation>살펴볼 출력량. 선택하지 않으면 목표불확도가 있는 모든 출력량, 또는 모든 측정량</translation>
    </message>
    <message>
        <source>Outputs (none ticked: all with a target, or all measurands)</source>
        <translation>출력(선택 없음: 목표가 있는 모든 출력, 또는 모든 측정량)</translation>
    </message>
    <message>
        <source>Rows to choose from</source>
        <translation>선택할 행</translation>
    </message>
    <message>
        <source>Table to choose from</source>
        <translation>선택할 표</translation>
    </message>
    <message>
        <source>Rows to keep</source>
        <translation>유지할 행 수</translation>
    </message>
    <message>
        <source>File of candidates</source>
        <translation>후보 파일</translation>
    </message>
    <message>
        <source>A CSV file beside the project with further rows; may be empty</source>
        <translation>추가 행이 있는, 프로젝트 옆의 CSV 파일. 비워 둘 수 있습니다</translation>
    </message>
    <message>
        <source>Rows that stay</source>
        <translation>남는 행</translation>
    </message>
    <message>
        <source>Ticked rows stay in any case</source>
        <translation>선택한 행은 어떤 경우에도 남습니다</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>표</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>유지</translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation>후보</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>남음</translation>
    </message>
    <message>
        <source>Prices</source>
        <translation>가격</translation>
    </message>
    <message>
        <source>Starts</source>
        <translation>시작 횟수</translation>
    </message>
    <message>
        <source>Evaluations at most</source>
        <translation>최대 평가 횟수</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>시드</translation>
    </message>
    <message>
        <source>Least distance</source>
        <translation>최소 거리</translation>
    </message>
    <message>
        <source>Between instruments, and of them from all other points</source>
        <translation>측정기 사이, 그리고 측정기와 다른 모든 점 사이</translation>
    </message>
    <message>
        <source>Keep out of</source>
        <translation>제외 영역</translation>
    </message>
    <message>
        <source>No instrument stands in this box</source>
        <translation>이 상자에는 측정기를 두지 않습니다</translation>
    </message>
    <message>
        <source>Lines of sight are hidden by</source>
        <translation>시준선을 가리는 것</translation>
    </message>
    <message>
        <source>No line of sight passes this box</source>
        <translation>시준선이 이 상자를 지나지 않습니다</translation>
    </message>
    <message>
        <source>Prices of the rows</source>
        <translation>행의 가격</translation>
    </message>
    <message>
        <source>one for all rows, or one for each: 120; 80; 95</source>
        <translation>모든 행에 하나, 또는 행마다 하나: 120; 80; 95</translation>
    </message>
    <message>
        <source>What the rows cost, separated by semicolons; needed where the cost is to be small</source>
        <translation>행의 비용, 세미콜론으로 구분. 비용을 작게 하려는 경우에 필요합니다</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no number; separate prices by semicolons</source>
        <translation>&apos;%1&apos;은(는) 수가 아닙니다. 가격을 세미콜론으로 구분하세요</translation>
    </message>
    <message>
        <source>Of the random starts: a whole number from 0 to 18446744073709551615</source>
        <translation>무작위 시작의 시드: 0부터 18446744073709551615까지의 정수</translation>
    </message>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DistributionEdit</name>
    <message>
        <source>Distribution</source>
        <translation>분포</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>단위</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>값</translation>
    </message>
    <message>
        <source>Probabilities</source>
        <translation>확률</translation>
    </message>
    <message>
        <source>numbers with ; between</source>
        <translation>;으로 구분한 수</translation>
    </message>
    <message>
        <source>“%1” are not all numbers.</source>
        <translation>“%1”이(가) 모두 수는 아닙니다.</translation>
    </message>
    <message>
        <source>There must be as many probabilities as values.</source>
        <translation>확률의 수는 값의 수와 같아야 합니다.</translation>
    </message>
    <message>
        <source>This distribution has no finite standard uncertainty.</source>
        <translation>이 분포에는 유한한 표준불확도가 없습니다.</translation>
    </message>
    <message>
        <source>Monte Carlo draws: %1, ν = %2</source>
        <translation>몬테카를로 추출: %1, ν = %2</translation>
    </message>
    <message>
        <source>Edges of the cells</source>
        <translation>칸의 경계</translation>
    </message>
    <message>
        <source>There must be one edge more than probabilities.</source>
        <translation>경계는 확률보다 하나 많아야 합니다.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DockTitle</name>
    <message>
        <source>Float or dock</source>
        <translation>띄우기 또는 도킹</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
</context>
<context>
    <name>covaria::ui::Document</name>
    <message>
        <source>Change the requirement for %1</source>
        <translation>%1의 요구사항 변경</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>제목 없음</translation>
    </message>
    <message>
        <source>%1 (from %2)</source>
        <translation>%1 (%2에서)</translation>
    </message>
    <message>
        <source>The project has no file yet: choose a name for it.</source>
        <translation>프로젝트에 아직 파일이 없습니다. 이름을 정하세요.</translation>
    </message>
    <message>
        <source> (copy)</source>
        <translation> (사본)</translation>
    </message>
    <message>
        <source>Add study</source>
        <translation>스터디 추가</translation>
    </message>
    <message>
        <source>Duplicate study</source>
        <translation>스터디 복제</translation>
    </message>
    <message>
        <source>Delete study</source>
        <translation>스터디 삭제</translation>
    </message>
    <message>
        <source>Change study</source>
        <translation>스터디 변경</translation>
    </message>
    <message>
        <source>Study %1</source>
        <translation>스터디 %1</translation>
    </message>
    <message>
        <source>Add design</source>
        <translation>설계 추가</translation>
    </message>
    <message>
        <source>Duplicate design</source>
        <translation>설계 복제</translation>
    </message>
    <message>
        <source>Delete design</source>
        <translation>설계 삭제</translation>
    </message>
    <message>
        <source>Change design</source>
        <translation>설계 변경</translation>
    </message>
    <message>
        <source>Design %1</source>
        <translation>설계 %1</translation>
    </message>
    <message>
        <source>the project</source>
        <translation>프로젝트</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 이름 바꾸기</translation>
    </message>
    <message>
        <source>Change notes of %1</source>
        <translation>%1의 메모 변경</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 삭제</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 이동</translation>
    </message>
    <message>
        <source>Take %1 from an analysis</source>
        <translation>분석에서 %1 가져오기</translation>
    </message>
    <message>
        <source>Remove the link of %1</source>
        <translation>%1의 연결 제거</translation>
    </message>
    <message>
        <source>Another program has changed the file since it was read.</source>
        <translation>파일을 읽은 뒤 다른 프로그램이 그것을 바꾸었습니다.</translation>
    </message>
    <message>
        <source>Change the requirements for %1 results</source>
        <translation>결과 %1개의 요구사항 변경</translation>
    </message>
</context>
<context>
    <name>covaria::ui::EmptyProject</name>
    <message>
        <source>Empty project</source>
        <translation>빈 프로젝트</translation>
    </message>
    <message>
        <source>What is to be evaluated?</source>
        <translation>무엇을 평가합니까?</translation>
    </message>
    <message>
        <source>&amp;Library and Templates …</source>
        <translation>라이브러리와 템플릿(&amp;L) …</translation>
    </message>
</context>
<context>
    <name>covaria::ui::EquationsView</name>
    <message>
        <source>Equations</source>
        <translation>방정식</translation>
    </message>
</context>
<context>
    <name>covaria::ui::EvaluationTab</name>
    <message>
        <source>Evaluation of the set-up</source>
        <translation>측정 구성의 평가</translation>
    </message>
</context>
<context>
    <name>covaria::ui::EvaluationView</name>
    <message>
        <source>Tables of the evaluation</source>
        <translation>평가의 표</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>차트</translation>
    </message>
    <message>
        <source>Which chart of the evaluation is shown</source>
        <translation>표시할 평가 차트</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ExportActions</name>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>PDF 문서 (*.pdf)</translation>
    </message>
    <message>
        <source>HTML page (*.html)</source>
        <translation>HTML 페이지 (*.html)</translation>
    </message>
    <message>
        <source>Markdown text (*.md)</source>
        <translation>Markdown 텍스트 (*.md)</translation>
    </message>
    <message>
        <source>Report as &amp;PDF …</source>
        <translation>PDF 보고서(&amp;P) …</translation>
    </message>
    <message>
        <source>&amp;Certificate as PDF …</source>
        <translation>PDF 성적서(&amp;C) …</translation>
    </message>
    <message>
        <source>Report as &amp;HTML …</source>
        <translation>HTML 보고서(&amp;H) …</translation>
    </message>
    <message>
        <source>Report as &amp;Markdown …</source>
        <translation>Markdown 보고서(&amp;M) …</translation>
    </message>
    <message>
        <source>&amp;Results and Tables (JSON, CSV) …</source>
        <translation>결과와 표 (JSON, CSV) (&amp;R) …</translation>
    </message>
    <message>
        <source> …</source>
        <translation> …</translation>
    </message>
    <message>
        <source>No results yet</source>
        <translation>아직 결과 없음</translation>
    </message>
    <message>
        <source>The export waits until the analyses have run</source>
        <translation>분석이 끝날 때까지 내보내기를 기다립니다</translation>
    </message>
    <message>
        <source>, without %1: not up to date</source>
        <translation>, %1 제외: 최신이 아님</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Export Report</source>
        <translation>보고서 내보내기</translation>
    </message>
    <message>
        <source>The certificate does not state what ISO/IEC 17025 requires of it:

%1

It says “not stated” in these places. They are fields of the project&apos;s page.</source>
        <translation>성적서에 ISO/IEC 17025가 요구하는 다음 사항이 없습니다:

%1

이 자리에는 “not stated”(기재되지 않음)라고 표시됩니다. 이들은 프로젝트 페이지의 필드입니다.</translation>
    </message>
    <message>
        <source>Export Anyway</source>
        <translation>그래도 내보내기</translation>
    </message>
    <message>
        <source>Export Certificate</source>
        <translation>성적서 내보내기</translation>
    </message>
    <message>
        <source>Export Results and Tables into the Folder of</source>
        <translation>결과와 표를 내보낼 폴더:</translation>
    </message>
    <message>
        <source>Results (results.json)</source>
        <translation>결과 (results.json)</translation>
    </message>
    <message>
        <source>%1: what it must state is missing</source>
        <translation>%1: 필수 기재 사항 누락</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>%1 내보내기</translation>
    </message>
    <message>
        <source>%1 (*%2)</source>
        <translation>%1 (*%2)</translation>
    </message>
    <message>
        <source>A report is being written; wait until it is finished</source>
        <translation>보고서를 쓰는 중입니다. 끝날 때까지 기다리세요</translation>
    </message>
    <message>
        <source>Writing %1 …</source>
        <translation>%1 쓰는 중 …</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 저장함</translation>
    </message>
    <message>
        <source>The export failed</source>
        <translation>내보내지 못했습니다</translation>
    </message>
    <message>
        <source>No analysis can be run: each one is incomplete or has errors.</source>
        <translation>실행할 수 있는 분석이 없습니다. 모두 불완전하거나 오류가 있습니다.</translation>
    </message>
    <message>
        <source>Ex&amp;port</source>
        <translation>내보내기(&amp;P)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FieldEditor</name>
    <message>
        <source>From %1 to %2.</source>
        <translation>%1부터 %2까지.</translation>
    </message>
    <message>
        <source>More than %1.</source>
        <translation>%1 초과.</translation>
    </message>
    <message>
        <source>At least %1.</source>
        <translation>%1 이상.</translation>
    </message>
    <message>
        <source>At most %1.</source>
        <translation>%1 이하.</translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation>%1 파일</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FieldHelp</name>
    <message>
        <source>Help on the field</source>
        <translation>필드 도움말</translation>
    </message>
    <message>
        <source>Numbers may be typed with another unit (%1); the arrow keys change the last digit.</source>
        <translation>수는 다른 단위로 입력할 수 있습니다(%1). 화살표 키는 마지막 자리를 바꿉니다.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FigureSourcesForm</name>
    <message>
        <source>certificate %1, not named yet</source>
        <translation>성적서 %1, 아직 이름 없음</translation>
    </message>
    <message>
        <source>Analyses in which it is applicable: %1.</source>
        <translation>분석 %1개에서 적용 가능.</translation>
    </message>
    <message>
        <source>No analysis uses these figures.</source>
        <translation>이 수치를 사용하는 분석이 없습니다.</translation>
    </message>
    <message>
        <source>Change the date of the measurement</source>
        <translation>측정일 변경</translation>
    </message>
    <message>
        <source>Certificate of the figures</source>
        <translation>수치의 성적서</translation>
    </message>
    <message>
        <source>Adds a certificate that figures come from</source>
        <translation>수치가 나온 성적서를 추가합니다</translation>
    </message>
    <message>
        <source>Removes this certificate</source>
        <translation>이 성적서를 제거합니다</translation>
    </message>
    <message>
        <source>Takes name and digest of the certificate&apos;s file</source>
        <translation>성적서 파일의 이름과 해시를 가져옵니다</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>종류</translation>
    </message>
    <message>
        <source>Change the kind of a certificate</source>
        <translation>성적서의 종류 변경</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 변경</translation>
    </message>
    <message>
        <source>Add a certificate</source>
        <translation>성적서 추가</translation>
    </message>
    <message>
        <source>Remove a certificate</source>
        <translation>성적서 제거</translation>
    </message>
    <message>
        <source>File of the Certificate</source>
        <translation>성적서 파일</translation>
    </message>
    <message>
        <source>Take the file of a certificate</source>
        <translation>성적서 파일 가져오기</translation>
    </message>
    <message>
        <source>These figures are assumed: no certificate states them.</source>
        <translation>이 수치는 가정한 것입니다. 이를 제시하는 성적서가 없습니다.</translation>
    </message>
    <message>
        <source>No certificate states the figures of this set-up.</source>
        <translation>이 측정 구성의 수치를 제시하는 성적서가 없습니다.</translation>
    </message>
    <message>
        <source>Date of the measurement</source>
        <translation>측정일</translation>
    </message>
    <message>
        <source>A date, or two of an interval; empty: that of the project&apos;s certificate.</source>
        <translation>날짜 하나, 또는 기간의 두 날짜. 비어 있으면 프로젝트 성적서의 것.</translation>
    </message>
    <message>
        <source>Shows what hangs on this certificate</source>
        <translation>이 성적서에 달려 있는 것을 보여 줍니다</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FileActions</name>
    <message>
        <source>line %1: </source>
        <translation>%1행: </translation>
    </message>
    <message>
        <source>&amp;New Project</source>
        <translation>새 프로젝트(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Open …</source>
        <translation>열기(&amp;O) …</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>저장(&amp;S)</translation>
    </message>
    <message>
        <source>Save &amp;As …</source>
        <translation>다른 이름으로 저장(&amp;A) …</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>최근 파일 열기(&amp;R)</translation>
    </message>
    <message>
        <source>No projects yet</source>
        <translation>아직 프로젝트 없음</translation>
    </message>
    <message>
        <source>New from &amp;Example</source>
        <translation>예제로 새로 만들기(&amp;E)</translation>
    </message>
    <message>
        <source>Untitled project</source>
        <translation>제목 없는 프로젝트</translation>
    </message>
    <message>
        <source>Opening %1 …</source>
        <translation>%1 여는 중 …</translation>
    </message>
    <message>
        <source>%1 was not opened</source>
        <translation>%1을(를) 열지 못했습니다</translation>
    </message>
    <message>
        <source>The project has errors and was not opened</source>
        <translation>프로젝트에 오류가 있어 열지 못했습니다</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>%1 열림</translation>
    </message>
    <message>
        <source>The example could not be opened</source>
        <translation>예제를 열지 못했습니다</translation>
    </message>
    <message>
        <source>The project was not saved</source>
        <translation>프로젝트를 저장하지 못했습니다</translation>
    </message>
    <message>
        <source>Save Project</source>
        <translation>프로젝트 저장</translation>
    </message>
    <message>
        <source>Covaria project (*.covaria)</source>
        <translation>Covaria 프로젝트 (*.covaria)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 저장됨</translation>
    </message>
    <message numerus="yes">
        <source>Saved %1 without %n text(s) that cannot be read: see the problems</source>
        <translation>
            <numerusform>읽을 수 없는 텍스트 %n개를 제외하고 %1 저장됨: 문제를 보세요</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>The work could not be recovered</source>
        <translation>작업을 복구하지 못했습니다</translation>
    </message>
    <message>
        <source>%1 was removed by another program; saving writes it again</source>
        <translation>다른 프로그램이 %1을(를) 제거했습니다. 저장하면 다시 씁니다</translation>
    </message>
    <message>
        <source>Name project</source>
        <translation>프로젝트 이름 지정</translation>
    </message>
    <message>
        <source>%1 was changed by another program since it was read here. Saving replaces what it holds now.</source>
        <translation>여기서 읽은 뒤 다른 프로그램이 %1을(를) 바꾸었습니다. 저장하면 지금 들어 있는 것을 대신합니다.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>바꾸기</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FileEditor</name>
    <message>
        <source>Choose a file: %1</source>
        <translation>파일 선택: %1</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FirstStepsGuide</name>
    <message>
        <source>First Steps</source>
        <translation>첫걸음</translation>
    </message>
    <message>
        <source>Not there yet: first step %1, %2.</source>
        <translation>아직 없습니다. 먼저 %1단계, %2.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FirstStepsPanel</name>
    <message>
        <source>Show Me</source>
        <translation>보여 주기</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>이전</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>다음</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>첫걸음</translation>
    </message>
    <message>
        <source>Shows where it is done: opens the tab and puts a frame around it</source>
        <translation>어디서 하는지 보여 줍니다. 탭을 열고 테두리를 두릅니다</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>step 3 of 10</comment>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>done</source>
        <translation>완료</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FoldGroups</name>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
</context>
<context>
    <name>covaria::ui::HelpActions</name>
    <message>
        <source>Help</source>
        <translation>도움말</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>단축키</translation>
    </message>
    <message>
        <source>M&amp;odels</source>
        <translation>모델(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Results and Requirements</source>
        <translation>결과와 요구사항(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Glossary</source>
        <translation>용어집(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>단축키(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;About Covaria</source>
        <translation>Covaria 정보(&amp;A)</translation>
    </message>
    <message>
        <source>The S&amp;cene</source>
        <translation>장면(&amp;C)</translation>
    </message>
    <message>
        <source>An Everyday &amp;Budget</source>
        <translation>일상적인 총괄표(&amp;B)</translation>
    </message>
    <message>
        <source>Help on &amp;What Has the Focus</source>
        <translation>포커스가 있는 항목의 도움말(&amp;W)</translation>
    </message>
    <message>
        <source>Artefacts, &amp;Instruments and Robots</source>
        <translation>기준물, 측정기, 로봇(&amp;I)</translation>
    </message>
    <message>
        <source>What Every Analysis &amp;Has</source>
        <translation>모든 분석에 있는 것(&amp;H)</translation>
    </message>
    <message>
        <source>Re&amp;view and Release</source>
        <translation>검토 및 확정(&amp;V)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::HelpPane</name>
    <message>
        <source>Help</source>
        <translation>도움말</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ImpactActions</name>
    <message>
        <source>&amp;What Hangs on a Certificate …</source>
        <translation>성적서에 달려 있는 것(&amp;W) …</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ImpactDialog</name>
    <message>
        <source>impact</source>
        <translation>impact</translation>
    </message>
    <message>
        <source>&amp;Evaluate</source>
        <translation>평가(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>중지(&amp;S)</translation>
    </message>
    <message>
        <source>Sa&amp;ve</source>
        <translation>저장(&amp;V)</translation>
    </message>
    <message>
        <source>What Hangs on a Certificate</source>
        <translation>성적서에 달려 있는 것</translation>
    </message>
    <message>
        <source>Not evaluated</source>
        <translation>평가하지 않음</translation>
    </message>
    <message>
        <source>New Figures</source>
        <translation>새 수치</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>모든 파일 (*)</translation>
    </message>
    <message>
        <source>Folder With Projects and Reports</source>
        <translation>프로젝트와 보고서가 있는 폴더</translation>
    </message>
    <message>
        <source>Files evaluated</source>
        <translation>평가한 파일</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
    <message>
        <source>&amp;Document (PDF) …</source>
        <translation>문서 (PDF)(&amp;D) …</translation>
    </message>
    <message>
        <source>Save the Impact</source>
        <translation>영향 저장</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>PDF 문서 (*.pdf)</translation>
    </message>
    <message>
        <source>Document (&amp;HTML) …</source>
        <translation>문서 (HTML)(&amp;H) …</translation>
    </message>
    <message>
        <source>HTML page (*.html)</source>
        <translation>HTML 페이지 (*.html)</translation>
    </message>
    <message>
        <source>&amp;Table (CSV) …</source>
        <translation>표 (CSV)(&amp;T) …</translation>
    </message>
    <message>
        <source>Save the Table</source>
        <translation>표 저장</translation>
    </message>
    <message>
        <source>CSV table (*.csv)</source>
        <translation>CSV 표 (*.csv)</translation>
    </message>
    <message>
        <source>Save the List</source>
        <translation>목록 저장</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>텍스트 (*.txt)</translation>
    </message>
    <message>
        <source>&amp;Find Who Used It</source>
        <translation>사용한 것 찾기(&amp;F)</translation>
    </message>
    <message>
        <source>Which results change when the figures of a certificate do?</source>
        <translation>성적서의 수치가 바뀌면 어떤 결과가 바뀝니까?</translation>
    </message>
    <message>
        <source>It could not be saved</source>
        <translation>저장할 수 없었습니다</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 저장함</translation>
    </message>
    <message>
        <source>&amp;List of Files …</source>
        <translation>파일 목록(&amp;L) …</translation>
    </message>
    <message>
        <source>Evaluating …</source>
        <translation>평가하는 중 …</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>멈추었습니다.</translation>
    </message>
    <message>
        <source>Both before and after by the law of propagation.</source>
        <translation>이전과 이후 모두 전파 법칙에 따릅니다.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ImpactForm</name>
    <message>
        <source>&amp;Browse …</source>
        <translation>찾아보기(&amp;B) …</translation>
    </message>
    <message>
        <source>&amp;Add Folder …</source>
        <translation>폴더 추가(&amp;A) …</translation>
    </message>
    <message>
        <source>Number of the certificate, its file or the SHA-256 of it; else the name of an asset</source>
        <translation>성적서 번호, 그 파일 또는 파일의 SHA-256. 아니면 에셋의 이름</translation>
    </message>
    <message>
        <source>Number, file, or name of an asset</source>
        <translation>번호, 파일 또는 에셋 이름</translation>
    </message>
    <message>
        <source>Empty: only who used the certificate</source>
        <translation>비우면 성적서를 사용한 것만</translation>
    </message>
    <message>
        <source>A project, a report (PDF) or a file of others with the new figures; FILE#ID is one asset or analysis of it</source>
        <translation>새 수치가 있는 프로젝트, 보고서(PDF) 또는 다른 프로그램의 파일. FILE#ID는 그 안의 에셋이나 분석 하나입니다</translation>
    </message>
    <message>
        <source>A folder or file on each line</source>
        <translation>한 줄에 폴더나 파일 하나</translation>
    </message>
    <message>
        <source>Projects and reports (PDF) below these folders are looked at</source>
        <translation>이 폴더 아래의 프로젝트와 보고서(PDF)를 살펴봅니다</translation>
    </message>
    <message>
        <source>Else each analysis is evaluated as its project says, with all its trials, twice</source>
        <translation>아니면 각 분석을 그 프로젝트가 정한 대로 모든 시행으로 두 번 평가합니다</translation>
    </message>
    <message>
        <source>&amp;Certificate</source>
        <translation>성적서(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;New figures</source>
        <translation>새 수치(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Look in</source>
        <translation>찾을 곳(&amp;L)</translation>
    </message>
    <message>
        <source>To first &amp;order: quick</source>
        <translation>1차로(&amp;O): 빠름</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ImpactTableModel</name>
    <message>
        <source>File</source>
        <translation>파일</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>번호</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>분석</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>그룹</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>결과</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>단위</translation>
    </message>
    <message>
        <source>y before</source>
        <translation>y, 이전</translation>
    </message>
    <message>
        <source>y after</source>
        <translation>y, 이후</translation>
    </message>
    <message>
        <source>U before</source>
        <translation>U 전</translation>
    </message>
    <message>
        <source>U after</source>
        <translation>U 후</translation>
    </message>
    <message>
        <source>Change / u</source>
        <translation>변화 / u</translation>
    </message>
    <message>
        <source>Change / U</source>
        <translation>변화 / U</translation>
    </message>
    <message>
        <source>Change of U in %</source>
        <translation>U의 변화 %</translation>
    </message>
    <message>
        <source>Verdict before</source>
        <translation>이전 판정</translation>
    </message>
    <message>
        <source>Verdict after</source>
        <translation>이후 판정</translation>
    </message>
    <message>
        <source>To amend</source>
        <translation>수정할 것</translation>
    </message>
    <message>
        <source>%1
Double click: opens it</source>
        <translation>%1
두 번 클릭하면 엽니다</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ImportActions</name>
    <message>
        <source>&amp;Import File …</source>
        <translation>파일 가져오기(&amp;I) …</translation>
    </message>
    <message>
        <source>Add points, budgets, certificates, readings or poses of other programs</source>
        <translation>다른 프로그램의 점, 총괄표, 성적서, 읽음값 또는 포즈를 추가합니다</translation>
    </message>
    <message>
        <source>Add a serial robot from a robot description in URDF</source>
        <translation>URDF 로봇 기술 파일에서 직렬 로봇을 추가합니다</translation>
    </message>
    <message>
        <source>Import File</source>
        <translation>파일 가져오기</translation>
    </message>
    <message>
        <source>Files that are read (%1);;All files (*)</source>
        <translation>읽을 수 있는 파일 (%1);;모든 파일 (*)</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 가져오기</translation>
    </message>
    <message>
        <source>Imported %1</source>
        <translation>%1 가져옴</translation>
    </message>
    <message>
        <source>Import Robot</source>
        <translation>로봇 가져오기</translation>
    </message>
    <message>
        <source>Robot description (*.urdf);;All files (*)</source>
        <translation>로봇 기술 파일 (*.urdf);;모든 파일 (*)</translation>
    </message>
    <message>
        <source>The robot was not imported</source>
        <translation>로봇을 가져오지 못했습니다</translation>
    </message>
    <message>
        <source>Import Robo&amp;t (URDF) …</source>
        <translation>로봇 가져오기(URDF)(&amp;T) …</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ImportDialog</name>
    <message>
        <source>Line %1: %2</source>
        <translation>%1행: %2</translation>
    </message>
    <message>
        <source>What the file says contradicts itself: %1</source>
        <translation>파일의 내용이 서로 모순됩니다: %1</translation>
    </message>
    <message>
        <source>&amp;Sheet</source>
        <translation>시트(&amp;S)</translation>
    </message>
    <message>
        <source>Columns of the file and what each is read as</source>
        <translation>파일의 열과 각 열의 해석</translation>
    </message>
    <message>
        <source>Units that the &amp;file does not state</source>
        <translation>파일에 없는 단위(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Note the file with its size, time and SHA-256 in what is added</source>
        <translation>추가된 것에 파일의 크기, 시각, SHA-256 기록(&amp;N)</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 가져오기</translation>
    </message>
    <message>
        <source>as the file says, else mm</source>
        <translation>파일대로, 없으면 mm</translation>
    </message>
    <message>
        <source>What becomes of the file</source>
        <translation>파일의 처리</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>가져오기</translation>
    </message>
    <message>
        <source>&amp;Read as</source>
        <translation>해석 형식(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Unit of lengths</source>
        <translation>길이의 단위(&amp;U)</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>양</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>단위</translation>
    </message>
    <message>
        <source>What becomes of it, and what is not taken over</source>
        <translation>파일의 처리와 가져오지 않는 것</translation>
    </message>
    <message>
        <source>no reader recognises it: choose one</source>
        <translation>인식하는 형식이 없음: 하나를 선택하세요</translation>
    </message>
    <message>
        <source>several readers recognise it: choose one</source>
        <translation>여러 형식이 인식함: 하나를 선택하세요</translation>
    </message>
    <message>
        <source>%1 (recognised)</source>
        <translation>%1 (인식됨)</translation>
    </message>
    <message>
        <source>Column %1 is read as</source>
        <translation>열 %1의 해석</translation>
    </message>
    <message>
        <source>unknown: choose</source>
        <translation>알 수 없음: 선택</translation>
    </message>
    <message>
        <source>as it is named</source>
        <translation>이름대로</translation>
    </message>
    <message>
        <source>Choose what the file is read as.</source>
        <translation>파일을 무엇으로 읽을지 선택하세요.</translation>
    </message>
    <message>
        <source>%1 assets and %2 analyses are added, in one step that can be undone.</source>
        <translation>에셋 %1개와 분석 %2개를, 실행 취소할 수 있는 한 단계로 추가합니다.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Imported from %1, %2 bytes, of %3, SHA-256 %4.</source>
        <translation>%1에서 가져옴, %2바이트, %3, SHA-256 %4.</translation>
    </message>
    <message>
        <source>&amp;Leave Out or Read the Row</source>
        <translation>행을 빼거나 읽기(&amp;L)</translation>
    </message>
    <message>
        <source>%1, left out</source>
        <translation>%1, 뺌</translation>
    </message>
    <message>
        <source>What each column is read as; cells can be typed over</source>
        <translation>각 열을 무엇으로 읽는가. 칸은 덮어쓸 수 있습니다</translation>
    </message>
</context>
<context>
    <name>covaria::ui::InputCorrelationModel</name>
    <message>
        <source>Remove correlations of %1</source>
        <translation>%1의 상관 제거</translation>
    </message>
    <message>
        <source>Change correlation of %1 and %2</source>
        <translation>%1과(와) %2의 상관 변경</translation>
    </message>
    <message>
        <source>The correlation coefficient of %1 and %2 lies between −1 and 1; “%3” does not.</source>
        <translation>%1과(와) %2의 상관계수는 −1과 1 사이에 있습니다. “%3”은(는) 그렇지 않습니다.</translation>
    </message>
    <message>
        <source>The correlation coefficient of %1 and %2 is a number; “%3” is not.</source>
        <translation>%1과(와) %2의 상관계수는 숫자입니다. “%3”은(는) 숫자가 아닙니다.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::InputQuantitiesModel</name>
    <message>
        <source>from %1, linearised: %2</source>
        <translation>%1에서, 선형화: %2</translation>
    </message>
    <message>
        <source>from %1: %2</source>
        <translation>%1에서: %2</translation>
    </message>
    <message>
        <source>Evaluated in the other analysis, in every trial: edit it there.</source>
        <translation>다른 분석에서 매 시행마다 평가됩니다. 그곳에서 편집하세요.</translation>
    </message>
    <message>
        <source>Changed: differs from what the model says.</source>
        <translation>변경됨: 모델의 값과 다릅니다.</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>기호</translation>
    </message>
    <message>
        <source>Input quantity</source>
        <translation>입력량</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>추정값</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>단위</translation>
    </message>
    <message>
        <source>Constant</source>
        <translation>상수</translation>
    </message>
    <message>
        <source>Change estimate of %1</source>
        <translation>%1의 추정값 변경</translation>
    </message>
    <message>
        <source>Keep %1 constant</source>
        <translation>%1 일정하게 유지</translation>
    </message>
    <message>
        <source>Let %1 vary</source>
        <translation>%1 변하게 하기</translation>
    </message>
    <message>
        <source>Reset %1 to the model&apos;s values</source>
        <translation>%1을(를) 모델의 값으로 초기화</translation>
    </message>
    <message>
        <source>%1 (%2, %3)</source>
        <translation>%1 (%2, %3)</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>성분</translation>
    </message>
</context>
<context>
    <name>covaria::ui::InputsPage</name>
    <message>
        <source>Find a quantity</source>
        <translation>양 찾기</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>성분</translation>
    </message>
    <message>
        <source>Correlations</source>
        <translation>상관</translation>
    </message>
    <message>
        <source>The quantities that the set-up makes. What is changed here replaces what the set-up states.</source>
        <translation>측정 구성이 만드는 양. 여기서 변경한 것은 측정 구성에 제시된 것을 대신합니다.</translation>
    </message>
    <message>
        <source>Input quantities</source>
        <translation>입력량</translation>
    </message>
    <message>
        <source>Take From an Analysis …</source>
        <translation>분석에서 가져오기 …</translation>
    </message>
    <message>
        <source>Remove Link</source>
        <translation>연결 제거</translation>
    </message>
    <message>
        <source>Observations</source>
        <translation>관측값</translation>
    </message>
    <message>
        <source>Notes on the quantity</source>
        <translation>양에 대한 메모</translation>
    </message>
</context>
<context>
    <name>covaria::ui::InquiryHead</name>
    <message>
        <source>Add</source>
        <translation>추가</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>복제</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>삭제</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>실행</translation>
    </message>
</context>
<context>
    <name>covaria::ui::InspectorHead</name>
    <message>
        <source>Entry before</source>
        <translation>이전 항목</translation>
    </message>
    <message>
        <source>Entry after</source>
        <translation>다음 항목</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>속성</translation>
    </message>
    <message>
        <source>Project and documents</source>
        <translation>프로젝트와 문서</translation>
    </message>
</context>
<context>
    <name>covaria::ui::KeptStates</name>
    <message>
        <source>Keep state</source>
        <translation>상태 보관</translation>
    </message>
    <message>
        <source>Discard kept state</source>
        <translation>보관된 상태 버리기</translation>
    </message>
    <message>
        <source>Compare with %1</source>
        <translation>%1과(와) 비교</translation>
    </message>
</context>
<context>
    <name>covaria::ui::LibraryBrowser</name>
    <message>
        <source>Collections</source>
        <translation>모음</translation>
    </message>
    <message>
        <source>Templates, examples and assets</source>
        <translation>템플릿, 예제, 에셋</translation>
    </message>
    <message>
        <source>Library and Examples</source>
        <translation>라이브러리와 예제</translation>
    </message>
    <message>
        <source>Search: name, kind, source</source>
        <translation>검색: 이름, 종류, 출처</translation>
    </message>
    <message>
        <source>Search in the library</source>
        <translation>라이브러리에서 검색</translation>
    </message>
    <message>
        <source>What is selected</source>
        <translation>선택한 것</translation>
    </message>
    <message>
        <source>New analysis</source>
        <translation>새 분석</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>예제</translation>
    </message>
    <message>
        <source>GUM and its supplements</source>
        <translation>GUM과 그 보충서</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>전체</translation>
    </message>
    <message>
        <source>It comes with what it needs and has results at once. Assets of the same kind that the project has already stand in the place of its own.</source>
        <translation>필요한 것과 함께 추가되어 바로 결과가 나옵니다. 프로젝트에 이미 같은 종류의 에셋이 있으면 그것을 대신 씁니다.</translation>
    </message>
    <message>
        <source>Opens as a new project.</source>
        <translation>새 프로젝트로 열립니다.</translation>
    </message>
    <message>
        <source>Add to the Project</source>
        <translation>프로젝트에 추가</translation>
    </message>
    <message>
        <source>&lt;p&gt;Nothing here has these words.&lt;/p&gt;</source>
        <translation>&lt;p&gt;이 단어가 있는 항목이 없습니다.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Open as a New Project</source>
        <translation>새 프로젝트로 열기</translation>
    </message>
    <message>
        <source>Add This Analysis</source>
        <translation>이 분석 추가</translation>
    </message>
</context>
<context>
    <name>covaria::ui::LibraryMenu</name>
    <message>
        <source>Not readable: %1</source>
        <translation>읽을 수 없음: %1</translation>
    </message>
    <message>
        <source>F&amp;rom the Library</source>
        <translation>라이브러리에서(&amp;R)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::LinesEditor</name>
    <message>
        <source>Add rows for new names</source>
        <translation>새 이름의 행 추가</translation>
    </message>
    <message>
        <source>Adds a row to the tables below for every name that has none yet</source>
        <translation>아직 행이 없는 모든 이름에 대해 아래 표에 행을 추가합니다</translation>
    </message>
</context>
<context>
    <name>covaria::ui::LinkDialog</name>
    <message>
        <source>&amp;Linearised: faster, exact to first order only</source>
        <translation>선형화(&amp;L): 더 빠르지만 일차까지만 정확함</translation>
    </message>
    <message>
        <source>Take %1 From an Analysis</source>
        <translation>분석에서 %1 가져오기</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>분석</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>결과</translation>
    </message>
    <message>
        <source>No other analysis has a result of this dimension.</source>
        <translation>이 차원의 결과가 있는 다른 분석이 없습니다.</translation>
    </message>
    <message>
        <source>Both analyses are then evaluated together, as one model: the result is not carried over as a number with an uncertainty.</source>
        <translation>두 분석은 하나의 모델로 함께 평가됩니다. 결과를 불확도가 있는 수로 옮기는 것이 아닙니다.</translation>
    </message>
    <message>
        <source>&amp;Analysis</source>
        <translation>분석(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Result</source>
        <translation>결과(&amp;R)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ListEditor</name>
    <message>
        <source>(none)</source>
        <translation>(없음)</translation>
    </message>
    <message>
        <source>%1 (does not exist)</source>
        <translation>%1 (존재하지 않음)</translation>
    </message>
    <message>
        <source>%1

Chosen: %2</source>
        <translation>%1

선택됨: %2</translation>
    </message>
</context>
<context>
    <name>covaria::ui::LogPane</name>
    <message>
        <source>Log</source>
        <translation>로그</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
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
        <translation>프로젝트</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>속성</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>문제</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>로그</translation>
    </message>
    <message>
        <source>Add an analysis or what it uses</source>
        <translation>분석이나 분석에 쓰이는 것을 추가합니다</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>도구</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>파일(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Library and Examples …</source>
        <translation>라이브러리와 예제(&amp;L) …</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>끝내기(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>편집(&amp;E)</translation>
    </message>
    <message>
        <source>Pre&amp;ferences …</source>
        <translation>환경설정(&amp;F) …</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>실행(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>보기(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Reset Layout</source>
        <translation>배치 초기화(&amp;R)</translation>
    </message>
    <message>
        <source>Start Page</source>
        <translation>시작 페이지</translation>
    </message>
    <message>
        <source>3D Scene</source>
        <translation>3D 장면</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>도움말(&amp;H)</translation>
    </message>
    <message>
        <source>Problems (%1)</source>
        <translation>문제 (%1)</translation>
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
        <translation>첫걸음(&amp;S)</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>실행</translation>
    </message>
    <message>
        <source>Document</source>
        <translation>문서</translation>
    </message>
</context>
<context>
    <name>covaria::ui::MeasureTool</name>
    <message>
        <source>Measure Distance</source>
        <translation>거리 측정</translation>
    </message>
    <message>
        <source>Distance of two points, with its uncertainty (D)</source>
        <translation>두 점의 거리와 그 불확도 (D)</translation>
    </message>
    <message>
        <source>Measure Angle</source>
        <translation>각도 측정</translation>
    </message>
    <message>
        <source>Angle at the second of three points, with its uncertainty (A)</source>
        <translation>세 점 중 두 번째 점에서의 각도와 그 불확도 (A)</translation>
    </message>
    <message>
        <source>Distance: pick the first point. Esc puts the tool away.</source>
        <translation>거리: 첫 번째 점을 고르십시오. Esc를 누르면 도구를 끝냅니다.</translation>
    </message>
    <message>
        <source>Distance: pick the second point.</source>
        <translation>거리: 두 번째 점을 고르십시오.</translation>
    </message>
    <message>
        <source>Angle: pick a point on the first side. Esc puts the tool away.</source>
        <translation>각도: 첫 번째 변의 점을 고르십시오. Esc를 누르면 도구를 끝냅니다.</translation>
    </message>
    <message>
        <source>Angle: pick the apex.</source>
        <translation>각도: 꼭짓점을 고르십시오.</translation>
    </message>
    <message>
        <source>Angle: pick a point on the second side.</source>
        <translation>각도: 두 번째 변의 점을 고르십시오.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::NotesPage</name>
    <message>
        <source>Title</source>
        <translation>제목</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>이름</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>메모</translation>
    </message>
    <message>
        <source>Appear in the report</source>
        <translation>보고서에 표시</translation>
    </message>
</context>
<context>
    <name>covaria::ui::OnlyMiddle</name>
    <message>
        <source>Only the &amp;Middle</source>
        <translation>가운데만(&amp;M)</translation>
    </message>
    <message>
        <source>The stage alone; once more, and the panes stand as they did</source>
        <translation>작업 영역만 표시. 다시 누르면 창이 이전 상태로 돌아옵니다</translation>
    </message>
</context>
<context>
    <name>covaria::ui::OptionsForm</name>
    <message>
        <source>none</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>Forecast</source>
        <translation>예측</translation>
    </message>
    <message>
        <source>Change evaluation options</source>
        <translation>평가 옵션 변경</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>자동</translation>
    </message>
</context>
<context>
    <name>covaria::ui::OutputsTab</name>
    <message>
        <source>Filter: symbol, name, group</source>
        <translation>필터: 기호, 이름, 그룹</translation>
    </message>
    <message>
        <source>Filter of the results</source>
        <translation>결과 필터</translation>
    </message>
    <message>
        <source>All groups</source>
        <translation>모든 그룹</translation>
    </message>
    <message>
        <source>Results of all poses, points or targets, whichever is selected</source>
        <translation>선택과 관계없이 모든 포즈, 점 또는 표적의 결과</translation>
    </message>
    <message>
        <source>Not met only</source>
        <translation>미충족만</translation>
    </message>
    <message>
        <source>Only results whose target uncertainty or tolerance is not met</source>
        <translation>목표불확도 또는 허용차를 충족하지 않는 결과만</translation>
    </message>
    <message>
        <source>results</source>
        <translation>결과</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>단위</translation>
    </message>
    <message>
        <source>Shortest Coverage Intervals</source>
        <translation>최단 포함구간</translation>
    </message>
    <message>
        <source>Require…</source>
        <translation>요구사항…</translation>
    </message>
    <message>
        <source>Target uncertainty and limits of the results that are selected</source>
        <translation>선택한 결과의 목표불확도와 한계</translation>
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
        <translation>쪽</translation>
    </message>
    <message>
        <source>Number of the page that is shown</source>
        <translation>보이는 쪽의 번호</translation>
    </message>
    <message>
        <source>Previous page</source>
        <translation>이전 쪽</translation>
    </message>
    <message>
        <source>Next page</source>
        <translation>다음 쪽</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>작게</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>크게</translation>
    </message>
    <message>
        <source>Size of the pages</source>
        <translation>쪽 크기</translation>
    </message>
    <message>
        <source>Size of the pages: fitted, or in per cent of the paper (Ctrl with the wheel)</source>
        <translation>쪽 크기: 창에 맞춤, 또는 용지의 백분율(Ctrl과 휠)</translation>
    </message>
    <message>
        <source>Fit Width</source>
        <translation>너비에 맞춤</translation>
    </message>
    <message>
        <source>Fit Page</source>
        <translation>쪽에 맞춤</translation>
    </message>
    <message>
        <source> of %1</source>
        <comment>page 3 of 17</comment>
        <translation> (%1)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::PageList</name>
    <message>
        <source>Pages</source>
        <translation>쪽</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>%1쪽</translation>
    </message>
</context>
<context>
    <name>covaria::ui::PairCorrelation</name>
    <message>
        <source>Correlation coefficient</source>
        <translation>상관계수</translation>
    </message>
    <message>
        <source>&lt;i&gt;r&lt;/i&gt;(%1, %2) =</source>
        <translation>&lt;i&gt;r&lt;/i&gt;(%1, %2) =</translation>
    </message>
    <message>
        <source>&lt;i&gt;r&lt;/i&gt; of two rows =</source>
        <translation>두 행의 &lt;i&gt;r&lt;/i&gt; =</translation>
    </message>
    <message>
        <source>Both quantities need an uncertainty before they can be correlated</source>
        <translation>두 양 모두 불확도가 있어야 상관을 줄 수 있습니다</translation>
    </message>
    <message>
        <source>Select two rows, and type the correlation coefficient of their components</source>
        <translation>두 행을 선택하고 그 성분의 상관계수를 입력하세요</translation>
    </message>
</context>
<context>
    <name>covaria::ui::PaneKeys</name>
    <message>
        <source>Ne&amp;xt Pane</source>
        <translation>다음 창(&amp;X)</translation>
    </message>
    <message>
        <source>Pre&amp;vious Pane</source>
        <translation>이전 창(&amp;V)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>환경설정</translation>
    </message>
    <message>
        <source>Results in the window</source>
        <translation>창에 표시되는 결과</translation>
    </message>
    <message>
        <source>New analyses</source>
        <translation>새 분석</translation>
    </message>
    <message>
        <source>Written into analyses that are added; others stay as they are.</source>
        <translation>추가되는 분석에 기록됩니다. 다른 분석은 그대로입니다.</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>창</translation>
    </message>
    <message>
        <source>Of tables and charts of results</source>
        <translation>결과의 표와 차트에 적용</translation>
    </message>
    <message>
        <source>As the model gives them</source>
        <translation>모델이 주는 대로</translation>
    </message>
    <message>
        <source>Digits of U</source>
        <translation>U의 자릿수</translation>
    </message>
    <message>
        <source>Significant digits of uncertainties; estimates are rounded to match</source>
        <translation>불확도의 유효숫자. 추정값은 이에 맞게 반올림합니다</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>수</translation>
    </message>
    <message>
        <source>Of all tables, charts and fields of the window</source>
        <translation>창의 모든 표, 차트, 필드에 적용</translation>
    </message>
    <message>
        <source>As the language writes them</source>
        <translation>언어의 표기대로</translation>
    </message>
    <message>
        <source>1234.5 (point)</source>
        <translation>1234.5 (점)</translation>
    </message>
    <message>
        <source>1234,5 (comma)</source>
        <translation>1234,5 (쉼표)</translation>
    </message>
    <message>
        <source>Coverage factor</source>
        <translation>포함인자</translation>
    </message>
    <message>
        <source>Of U = k u, where a new analysis begins with a fixed one</source>
        <translation>U = k u의 값, 새 분석을 고정 포함인자로 시작하는 경우</translation>
    </message>
    <message>
        <source>k from the degrees of freedom or the coverage interval</source>
        <translation>자유도 또는 포함구간에서 구한 k</translation>
    </message>
    <message>
        <source>k = 2</source>
        <translation>k = 2</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>시행 횟수</translation>
    </message>
    <message>
        <source>Of Monte Carlo</source>
        <translation>몬테카를로의 시행 횟수</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>언어</translation>
    </message>
    <message>
        <source>Of the window, when Covaria starts again</source>
        <translation>창의 언어, Covaria를 다시 시작하면 적용</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>시스템 설정대로</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>색상</translation>
    </message>
    <message>
        <source>Of the window, its charts and the scene</source>
        <translation>창, 차트, 장면의 색상</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>밝게</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>어둡게</translation>
    </message>
    <message>
        <source>Font size</source>
        <translation>글꼴 크기</translation>
    </message>
    <message>
        <source>Of the whole window</source>
        <translation>창 전체에 적용</translation>
    </message>
    <message>
        <source>as the system</source>
        <translation>시스템 설정대로</translation>
    </message>
    <message>
        <source> pt</source>
        <translation> pt</translation>
    </message>
    <message>
        <source>Recovery copy</source>
        <translation>복구 사본</translation>
    </message>
    <message>
        <source>How long an edit may stay without a copy that a crash leaves behind</source>
        <translation>비정상 종료에 대비한 사본 없이 편집 내용이 남아 있을 수 있는 시간</translation>
    </message>
    <message>
        <source>at most </source>
        <translation>편집 후 </translation>
    </message>
    <message>
        <source> s after an edit</source>
        <translation> s 이내</translation>
    </message>
    <message>
        <source>Where the project does not state them. Reports and files are the project&apos;s alone.</source>
        <translation>프로젝트가 정하지 않은 곳에 쓰입니다. 보고서와 파일은 프로젝트만을 따릅니다.</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>글꼴</translation>
    </message>
    <message>
        <source>Covaria&apos;s own</source>
        <translation>Covaria 기본 글꼴</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProblemsModel</name>
    <message>
        <source>, row %1</source>
        <translation>, %1행</translation>
    </message>
    <message>
        <source>Project: certificate, %1</source>
        <translation>프로젝트: 성적서, %1</translation>
    </message>
    <message>
        <source>Project: report</source>
        <translation>프로젝트: 보고서</translation>
    </message>
    <message>
        <source>evaluation, %1</source>
        <translation>평가, %1</translation>
    </message>
    <message>
        <source>To give</source>
        <translation>입력 필요</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>오류</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>경고</translation>
    </message>
    <message>
        <source>, line %1</source>
        <translation>, %1번째 줄</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>종류</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>위치</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>문제</translation>
    </message>
    <message>
        <source>correlation of %1 and %2</source>
        <translation>%1과(와) %2의 상관</translation>
    </message>
    <message>
        <source>link of %1</source>
        <translation>%1의 링크</translation>
    </message>
    <message>
        <source>change of %1</source>
        <translation>%1의 변경</translation>
    </message>
    <message>
        <source>requirement on %1</source>
        <translation>%1에 대한 요구</translation>
    </message>
    <message>
        <source>study</source>
        <translation>연구</translation>
    </message>
    <message>
        <source>design</source>
        <translation>설계</translation>
    </message>
    <message>
        <source>Way out</source>
        <translation>해결 방법</translation>
    </message>
    <message>
        <source>or</source>
        <translation>또는</translation>
    </message>
    <message>
        <source>Project: review</source>
        <translation>프로젝트: 검토</translation>
    </message>
    <message>
        <source>certificate %1</source>
        <translation>성적서 %1</translation>
    </message>
    <message>
        <source>date of the measurement</source>
        <translation>측정일</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProblemsPane</name>
    <message>
        <source>Problems</source>
        <translation>문제</translation>
    </message>
    <message>
        <source>No problems.</source>
        <translation>문제 없음.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProjectPage</name>
    <message>
        <source>Number</source>
        <translation>번호</translation>
    </message>
    <message>
        <source>Of the project or order; in the report</source>
        <translation>프로젝트 또는 주문의 번호; 보고서에 표시</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>작성자</translation>
    </message>
    <message>
        <source>Who evaluated; in the report</source>
        <translation>평가한 사람; 보고서에 표시</translation>
    </message>
    <message>
        <source>Results of all analyses</source>
        <translation>모든 분석의 결과</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 변경</translation>
    </message>
    <message>
        <source>Not stated</source>
        <translation>명시되지 않음</translation>
    </message>
    <message>
        <source>Of results in the window, reports, tables and CSV files; where it is not stated, files have the unit of the model</source>
        <translation>창, 보고서, 표, CSV 파일의 결과 단위; 명시하지 않으면 파일은 모델의 단위를 씀</translation>
    </message>
    <message>
        <source>Change units of results</source>
        <translation>결과 단위들 변경</translation>
    </message>
    <message>
        <source>Digits of U</source>
        <translation>U의 자릿수</translation>
    </message>
    <message>
        <source>Significant digits of uncertainties in the window and the report; certificates have two</source>
        <translation>창과 보고서에서 불확도의 유효숫자 자릿수; 인증서는 두 자리</translation>
    </message>
    <message>
        <source>Change digits of results</source>
        <translation>결과 자릿수 변경</translation>
    </message>
    <message>
        <source>Coverage factor</source>
        <translation>포함인자</translation>
    </message>
    <message>
        <source>A fixed k for U = k u of all analyses whose options state none; empty: from the degrees of freedom, or the coverage interval</source>
        <translation>옵션에 k가 없는 모든 분석의 U = k u에 쓰는 고정된 k; 비우면 자유도 또는 포함구간에서 구함</translation>
    </message>
    <message>
        <source>Change coverage factor</source>
        <translation>포함인자 변경</translation>
    </message>
    <message>
        <source>Reports, certificates and files have these units, and those of the model where none is stated; units of the preferences are of the window only.</source>
        <translation>보고서, 성적서, 파일에는 이 단위를 쓰고, 명시되지 않은 것은 모델의 단위를 씁니다. 환경설정의 단위는 창에만 적용됩니다.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProjectPane</name>
    <message>
        <source>Project</source>
        <translation>프로젝트</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>이름 바꾸기(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Delete …</source>
        <translation>삭제(&amp;D) …</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>추가(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Library and Templates …</source>
        <translation>라이브러리와 템플릿(&amp;L) …</translation>
    </message>
    <message>
        <source>The analysis was not added: %1</source>
        <translation>분석을 추가하지 못했습니다: %1</translation>
    </message>
    <message>
        <source>“%1” is in the project now</source>
        <translation>“%1”이(가) 프로젝트에 추가되었습니다</translation>
    </message>
    <message>
        <source>Delete “%1”?</source>
        <translation>“%1”을(를) 삭제할까요?</translation>
    </message>
    <message>
        <source>

It is used by: %1. They will have an error until they use something else.</source>
        <translation>

다음에서 사용 중입니다: %1. 다른 것을 사용할 때까지 오류가 있습니다.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>삭제</translation>
    </message>
    <message>
        <source>“%1” is in your library now (Add &gt; From the Library)</source>
        <translation>“%1”이(가) 내 라이브러리에 추가되었습니다(추가 &gt; 라이브러리에서)</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>실행</translation>
    </message>
    <message>
        <source>Keep in My Library</source>
        <translation>내 라이브러리에 보관</translation>
    </message>
    <message>
        <source>Show in the Scene</source>
        <translation>장면에 표시</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>분석</translation>
    </message>
    <message>
        <source>What it uses</source>
        <translation>사용하는 것</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>복제(&amp;L)</translation>
    </message>
    <message>
        <source>Add an analysis or what it uses</source>
        <translation>분석이나 분석에 쓰이는 것을 추가합니다</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProjectTreeModel</name>
    <message>
        <source>Artefacts</source>
        <translation>기준물</translation>
    </message>
    <message>
        <source>Instruments</source>
        <translation>측정기</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>로봇</translation>
    </message>
    <message>
        <source>Points and frames</source>
        <translation>점과 좌표계</translation>
    </message>
    <message>
        <source>Analyses</source>
        <translation>분석</translation>
    </message>
    <message>
        <source>has problems</source>
        <translation>문제 있음</translation>
    </message>
    <message>
        <source>Untitled project</source>
        <translation>제목 없는 프로젝트</translation>
    </message>
    <message>
        <source>Title, notes, certificate and contents of the report</source>
        <translation>제목, 메모, 성적서, 보고서의 내용</translation>
    </message>
    <message>
        <source>incomplete</source>
        <translation>미완성</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>프로젝트</translation>
    </message>
    <message>
        <source>State</source>
        <translation>상태</translation>
    </message>
    <message>
        <source>running</source>
        <translation>실행 중</translation>
    </message>
    <message>
        <source>up to date</source>
        <translation>최신</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>실패</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>갱신 필요</translation>
    </message>
    <message>
        <source>%1 of %2 requirements not met</source>
        <translation>요구사항 %2개 중 %1개 미충족</translation>
    </message>
    <message>
        <source>Context</source>
        <translation>주변</translation>
    </message>
    <message>
        <source>Laboratory</source>
        <translation>교정기관</translation>
    </message>
</context>
<context>
    <name>covaria::ui::PropertiesPane</name>
    <message>
        <source>The project is empty. Add an analysis, or first what it uses, with the plus sign above or a right click in the project tree.</source>
        <translation>프로젝트가 비어 있습니다. 위의 더하기 표시나 프로젝트 트리의 오른쪽 클릭으로 분석을, 또는 먼저 분석에 쓰이는 것을 추가하세요.</translation>
    </message>
    <message>
        <source>Select an entry of the project tree to see its properties.</source>
        <translation>속성을 보려면 프로젝트 트리에서 항목을 선택하세요.</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>프로젝트</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>성적서</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>보고서</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>평가</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>입력</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>옵션</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>스터디</translation>
    </message>
    <message>
        <source>Designs</source>
        <translation>설계</translation>
    </message>
    <message>
        <source>Requirements</source>
        <translation>요구사항</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>메모</translation>
    </message>
    <message>
        <source>Certificates</source>
        <translation>성적서</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>검토</translation>
    </message>
    <message>
        <source>What can be evaluated with it</source>
        <translation>이것으로 평가할 수 있는 것</translation>
    </message>
</context>
<context>
    <name>covaria::ui::QuantityEdit</name>
    <message>
        <source>A value is needed here.</source>
        <translation>값이 필요합니다.</translation>
    </message>
    <message>
        <source>A whole number is needed here.</source>
        <translation>정수가 필요합니다.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::QuantityNotesEdit</name>
    <message>
        <source>Notes on the quantity</source>
        <translation>양에 대한 메모</translation>
    </message>
    <message>
        <source>Why this figure, what was agreed: in the report, below the input quantities</source>
        <translation>이 값의 근거와 합의 사항: 보고서의 입력량 아래에 실립니다</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ReferenceEditor</name>
    <message>
        <source>(nothing in the project fits: add it first)</source>
        <translation>(프로젝트에 맞는 것이 없음: 먼저 추가하세요)</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>(없음)</translation>
    </message>
    <message>
        <source>(choose)</source>
        <translation>(선택)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ReportForm</name>
    <message>
        <source>Analyses, of report and certificate</source>
        <translation>분석, 보고서와 성적서용</translation>
    </message>
    <message>
        <source>Chapters of the report</source>
        <translation>보고서의 장</translation>
    </message>
    <message>
        <source>Long tables</source>
        <translation>긴 표</translation>
    </message>
    <message>
        <source>The report shows what counts most of long tables; the CSV files have them whole. Ticked, they stand whole at the end of the report too.</source>
        <translation>보고서는 긴 표에서 가장 중요한 부분을 보여 줍니다. CSV 파일에는 전체가 있습니다. 선택하면 보고서 끝에도 전체가 실립니다.</translation>
    </message>
    <message>
        <source>Whole, in an annex</source>
        <translation>전체, 부록으로</translation>
    </message>
    <message>
        <source>Change the annex of the report</source>
        <translation>보고서의 부록 변경</translation>
    </message>
    <message>
        <source>Goes into the report where it is ticked.</source>
        <translation>선택하면 보고서에 포함됩니다.</translation>
    </message>
    <message>
        <source>Put %1 into the report</source>
        <translation>%1을(를) 보고서에 포함</translation>
    </message>
    <message>
        <source>Leave %1 out of the report</source>
        <translation>%1을(를) 보고서에서 제외</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>언어</translation>
    </message>
    <message>
        <source>English: none is chosen on the page Certificate.</source>
        <translation>영어: 성적서 페이지에서 선택하지 않았습니다.</translation>
    </message>
    <message>
        <source>%1, as chosen on the page Certificate.</source>
        <translation>%1, 성적서 페이지에서 선택한 언어.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ReportPreview</name>
    <message>
        <source>Document</source>
        <translation>문서</translation>
    </message>
    <message>
        <source>What is shown: the report, or the calibration certificate</source>
        <translation>표시할 것: 보고서 또는 교정성적서</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>보고서</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>성적서</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>갱신</translation>
    </message>
    <message>
        <source>The report</source>
        <translation>보고서</translation>
    </message>
    <message>
        <source>The certificate</source>
        <translation>성적서</translation>
    </message>
    <message>
        <source>Out of date: the project or its results have changed since.</source>
        <translation>갱신 필요: 이후 프로젝트나 그 결과가 변경되었습니다.</translation>
    </message>
    <message>
        <source>%1 has not been made yet.</source>
        <translation>아직 만들지 않음: %1.</translation>
    </message>
    <message>
        <source>The analyses are running: %1 waits for them.</source>
        <translation>분석을 실행 중입니다. 끝나면 만들 문서: %1.</translation>
    </message>
    <message>
        <source>No analysis is up to date: run one first (F5).</source>
        <translation>최신 상태인 분석이 없습니다. 먼저 하나를 실행하세요(F5).</translation>
    </message>
    <message>
        <source>%1 could not be made: %2</source>
        <translation>%1을(를) 만들지 못했습니다: %2</translation>
    </message>
    <message>
        <source>1 page, as printed</source>
        <translation>1쪽, 인쇄 기준</translation>
    </message>
    <message>
        <source>%1 pages, as printed</source>
        <translation>%1쪽, 인쇄 기준</translation>
    </message>
    <message>
        <source>%1; one required text is not stated</source>
        <translation>%1; 필수 텍스트 하나가 기재되지 않음</translation>
    </message>
    <message>
        <source>%1; %2 required texts are not stated</source>
        <translation>%1; 필수 텍스트 %2개가 기재되지 않음</translation>
    </message>
    <message>
        <source>Pages as they are printed</source>
        <translation>인쇄될 모습의 쪽</translation>
    </message>
    <message>
        <source>Being made …</source>
        <translation>만드는 중 …</translation>
    </message>
</context>
<context>
    <name>covaria::ui::RequirementDialog</name>
    <message>
        <source>Requirements for Results</source>
        <translation>결과의 요구사항</translation>
    </message>
    <message>
        <source>Left out, for their unit is another: %1.</source>
        <translation>단위가 달라서 뺀 것: %1.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::RequirementsForm</name>
    <message>
        <source>U = %1: the target is %2.</source>
        <translation>U = %1: 목표는 %2입니다.</translation>
    </message>
    <message>
        <source>met</source>
        <translation>충족</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>미충족</translation>
    </message>
    <message>
        <source>&lt;li&gt;u of %1 reduced from %2 to %3: %4 of what is stated&lt;/li&gt;</source>
        <translation>&lt;li&gt;%1의 u를 %2에서 %3(으)로 감소: 제시한 값의 %4&lt;/li&gt;</translation>
    </message>
    <message>
        <source>&lt;br&gt;It would be met with one of these alone:&lt;ul&gt;%1&lt;/ul&gt;</source>
        <translation>&lt;br&gt;다음 중 하나만으로 충족됩니다:&lt;ul&gt;%1&lt;/ul&gt;</translation>
    </message>
    <message>
        <source>&lt;br&gt;No component suffices alone.</source>
        <translation>&lt;br&gt;어느 한 성분만으로는 충분하지 않습니다.</translation>
    </message>
    <message>
        <source> It would be met with all standard uncertainties multiplied by %1.</source>
        <translation> 모든 표준불확도에 %1을(를) 곱하면 충족됩니다.</translation>
    </message>
    <message>
        <source>(trials)</source>
        <translation>(시행)</translation>
    </message>
    <message>
        <source>(Student t)</source>
        <translation>(스튜던트 t)</translation>
    </message>
    <message>
        <source>(normal)</source>
        <translation>(정규)</translation>
    </message>
    <message>
        <source>Not judged: %1.</source>
        <translation>판정하지 않음: %1.</translation>
    </message>
    <message>
        <source>By %5, guard band %1: the result is &lt;b&gt;%2&lt;/b&gt;. Probability of conformance %3 %4.</source>
        <translation>%5 기준, 보호대역 %1: 결과는 &lt;b&gt;%2&lt;/b&gt;입니다. 적합 확률 %3 %4.</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>합격</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>불합격</translation>
    </message>
    <message>
        <source>&lt;br&gt;TUR %1, C&lt;sub&gt;m&lt;/sub&gt; %2.</source>
        <translation>&lt;br&gt;TUR %1, C&lt;sub&gt;m&lt;/sub&gt; %2.</translation>
    </message>
    <message>
        <source>&lt;br&gt;Global risks of the rule: consumer&apos;s %1, producer&apos;s %2.</source>
        <translation>&lt;br&gt;규칙의 전역 위험: 소비자 %1, 생산자 %2.</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>결과</translation>
    </message>
    <message>
        <source>By the law of propagation; Monte Carlo is to follow.</source>
        <translation>전파 법칙에 의함. 몬테카를로가 이어집니다.</translation>
    </message>
    <message>
        <source>By the trials of a preview; the whole run is to follow.</source>
        <translation>미리보기 시행에 의함. 전체 실행이 이어집니다.</translation>
    </message>
    <message>
        <source>Run the analysis to see whether the requirement is met.</source>
        <translation>요구사항의 충족 여부를 보려면 분석을 실행하세요.</translation>
    </message>
    <message>
        <source>&lt;br&gt;Of what the rule accepts %1 does not conform, of what it rejects %2 does.</source>
        <translation>&lt;br&gt;규칙이 수락하는 것 중 %1은(는) 부적합하고, 거부하는 것 중 %2은(는) 적합합니다.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ResultTableModel</name>
    <message>
        <source>Ends of the interval differ by %1 and %2 from those of Monte Carlo; tolerance %3</source>
        <translation>구간의 양 끝이 몬테카를로의 끝과 %1, %2만큼 다름. 허용 오차 %3</translation>
    </message>
    <message>
        <source>. Other trials could give the other verdict: more of them decide.</source>
        <translation>. 다른 시행에서는 판정이 반대일 수 있습니다. 시행 수를 늘리면 정해집니다.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ResultsPane</name>
    <message>
        <source>Results</source>
        <translation>결과</translation>
    </message>
    <message>
        <source>Budget</source>
        <translation>총괄표</translation>
    </message>
    <message>
        <source>Distributions</source>
        <translation>분포</translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation>상관</translation>
    </message>
    <message>
        <source>Convergence</source>
        <translation>수렴</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>평가</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>스터디</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>설계</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>비교</translation>
    </message>
    <message>
        <source>digits of U: </source>
        <translation>U의 자릿수: </translation>
    </message>
    <message>
        <source>Significant digits of uncertainties</source>
        <translation>불확도의 유효숫자</translation>
    </message>
    <message>
        <source>Significant digits of uncertainties in the window; estimates are rounded to match. Documents have those of the project page.</source>
        <translation>창에 표시되는 불확도의 유효숫자 자릿수. 추정값은 그에 맞춰 반올림됩니다. 문서에는 프로젝트 페이지의 자릿수가 쓰입니다.</translation>
    </message>
    <message>
        <source>budget</source>
        <translation>총괄표</translation>
    </message>
    <message>
        <source>correlation</source>
        <translation>상관</translation>
    </message>
    <message>
        <source>All Results</source>
        <translation>모든 결과</translation>
    </message>
    <message>
        <source>Go to Source</source>
        <translation>출처로 이동</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>차트</translation>
    </message>
    <message>
        <source>Document</source>
        <translation>문서</translation>
    </message>
    <message>
        <source>Kind of chart</source>
        <translation>차트의 종류</translation>
    </message>
    <message>
        <source>Which charts of the result are shown</source>
        <translation>표시할 결과 차트</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>장면</translation>
    </message>
    <message>
        <source>Contributions</source>
        <translation>기여</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>드러난 값</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ReviewForm</name>
    <message>
        <source>draft</source>
        <translation>초안</translation>
    </message>
    <message>
        <source>released</source>
        <translation>확정됨</translation>
    </message>
    <message>
        <source>draft again</source>
        <translation>다시 초안</translation>
    </message>
    <message>
        <source>A release states in report and certificate who is responsible, and a digest by which every later change shows.</source>
        <translation>확정하면 보고서와 성적서에 책임자와, 이후의 모든 변경을 드러내는 해시가 적힙니다.</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>확정</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>이름</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>한 일</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>날짜</translation>
    </message>
    <message>
        <source>The day of this step; empty: that of the release.</source>
        <translation>이 단계의 날짜. 비어 있으면 확정일.</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 변경</translation>
    </message>
    <message>
        <source>Add to the Log</source>
        <translation>로그에 추가</translation>
    </message>
    <message>
        <source>Release the project</source>
        <translation>프로젝트 확정</translation>
    </message>
    <message>
        <source>Add to the log</source>
        <translation>로그에 추가</translation>
    </message>
    <message>
        <source>A project with errors is not released.</source>
        <translation>오류가 있는 프로젝트는 확정되지 않습니다.</translation>
    </message>
    <message>
        <source>All three names are needed.</source>
        <translation>세 이름이 모두 필요합니다.</translation>
    </message>
    <message>
        <source>Takes the digest of the project as it is now</source>
        <translation>현재 프로젝트의 해시를 취합니다</translation>
    </message>
</context>
<context>
    <name>covaria::ui::RowTools</name>
    <message>
        <source>Add row</source>
        <translation>행 추가</translation>
    </message>
    <message>
        <source>Delete rows</source>
        <translation>행 삭제</translation>
    </message>
    <message>
        <source>Fill down</source>
        <translation>아래로 채우기</translation>
    </message>
</context>
<context>
    <name>covaria::ui::RunActions</name>
    <message>
        <source>&amp;Run This Analysis</source>
        <translation>이 분석 실행(&amp;R)</translation>
    </message>
    <message>
        <source>Run &amp;All</source>
        <translation>모두 실행(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>중지(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Live</source>
        <translation>실시간(&amp;L)</translation>
    </message>
    <message>
        <source>Each edit computes first-order results at once, then Monte Carlo</source>
        <translation>편집할 때마다 일차 결과를 바로 계산하고, 이어서 몬테카를로를 계산합니다</translation>
    </message>
</context>
<context>
    <name>covaria::ui::RunStatus</name>
    <message>
        <source>%1 trials</source>
        <translation>시행 %1회</translation>
    </message>
    <message>
        <source>, %1 million/s</source>
        <translation>, %1백만/s</translation>
    </message>
    <message>
        <source>Progress of the run</source>
        <translation>실행 진행률</translation>
    </message>
    <message>
        <source>Stop all runs (Esc)</source>
        <translation>모든 실행 중지(Esc)</translation>
    </message>
    <message>
        <source>Stop all runs</source>
        <translation>모든 실행 중지</translation>
    </message>
    <message>
        <source>%1: %2 %</source>
        <translation>%1: %2 %</translation>
    </message>
    <message>
        <source>, best so far %1</source>
        <translation>, 현재 최선 %1</translation>
    </message>
    <message>
        <source>No analysis yet</source>
        <translation>아직 분석 없음</translation>
    </message>
    <message>
        <source>No analysis selected</source>
        <translation>선택한 분석 없음</translation>
    </message>
    <message>
        <source>has problems</source>
        <translation>문제 있음</translation>
    </message>
    <message>
        <source>, %1 trials</source>
        <translation>, 시행 %1회</translation>
    </message>
    <message>
        <source>, with warnings</source>
        <translation>, 경고 있음</translation>
    </message>
    <message>
        <source>%1, kept state: </source>
        <translation>%1, 보관된 상태: </translation>
    </message>
    <message>
        <source>%1 s left</source>
        <translation>%1 s 남음</translation>
    </message>
    <message>
        <source>%1 min left</source>
        <translation>%1 min 남음</translation>
    </message>
    <message>
        <source>%1 h left</source>
        <translation>%1 h 남음</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ScenePanel</name>
    <message>
        <source>Select an analysis in the project tree to see its layout here.</source>
        <translation>배치를 보려면 프로젝트 트리에서 분석을 선택하세요.</translation>
    </message>
    <message>
        <source>Which pose or group of outputs to show</source>
        <translation>표시할 포즈 또는 출력 그룹</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>그룹</translation>
    </message>
    <message>
        <source>Iso</source>
        <translation>등각</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>화면 맞춤</translation>
    </message>
    <message>
        <source>Everything in the picture (F)</source>
        <translation>모두 그림 안에 표시 (F)</translation>
    </message>
    <message>
        <source>Magnification of the uncertainty; it is always written in the picture</source>
        <translation>불확도의 확대율. 항상 그림에 표시됩니다</translation>
    </message>
    <message>
        <source>Magnification of the uncertainty</source>
        <translation>불확도의 확대율</translation>
    </message>
    <message>
        <source>× %1</source>
        <translation>× %1</translation>
    </message>
    <message>
        <source>Coverage probability of the ellipsoids</source>
        <translation>타원체의 포함확률</translation>
    </message>
    <message>
        <source>p = %1 %</source>
        <translation>p = %1 %</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>좌표계</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>점</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>물체</translation>
    </message>
    <message>
        <source>Links and Sight Lines</source>
        <translation>링크와 시준선</translation>
    </message>
    <message>
        <source>Vectors</source>
        <translation>벡터</translation>
    </message>
    <message>
        <source>Ellipsoids</source>
        <translation>타원체</translation>
    </message>
    <message>
        <source>Clouds</source>
        <translation>점군</translation>
    </message>
    <message>
        <source>Histograms on the Walls</source>
        <translation>벽면의 히스토그램</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>레이블</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>축</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>범례</translation>
    </message>
    <message>
        <source>Map of a Study or Design</source>
        <translation>스터디 또는 설계의 맵</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>레이어</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;  at %2</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;  위치 %2</translation>
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
        <translation>보기</translation>
    </message>
    <message>
        <source>Ellipsoids of the Kept State</source>
        <translation>보관된 상태의 타원체</translation>
    </message>
    <message>
        <source>× auto</source>
        <translation>× 자동</translation>
    </message>
    <message>
        <source>Context Meshes</source>
        <translation>주변 메시</translation>
    </message>
    <message>
        <source>View from the front right, from above (1); beside it standard and saved views, orthographic or perspective</source>
        <translation>오른쪽 앞 위에서 본 모습(1); 옆에는 표준 보기와 저장한 보기, 직교 또는 원근</translation>
    </message>
    <message>
        <source>Layers: what the picture shows</source>
        <translation>레이어: 그림에 보이는 것</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SceneView</name>
    <message>
        <source>3D scene</source>
        <translation>3D 장면</translation>
    </message>
    <message>
        <source>The picture could not be written to %1</source>
        <translation>그림을 %1에 쓰지 못했습니다</translation>
    </message>
    <message>
        <source>Drawing …</source>
        <translation>그리는 중 …</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>화면 맞춤</translation>
    </message>
    <message>
        <source>Copy Picture</source>
        <translation>그림 복사</translation>
    </message>
    <message>
        <source>Save Picture …</source>
        <translation>그림 저장 …</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>그림 저장</translation>
    </message>
    <message>
        <source>scene.png</source>
        <translation>scene.png</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG 그림 (*.png)</translation>
    </message>
    <message>
        <source>Arrow keys turn the scene, plus and minus zoom, F fits, 1 to 7 are standard views, H hides what is selected, I shows it alone, Shift+H shows all; points and instruments can be dragged to another place</source>
        <translation>화살표 키는 장면을 회전하고, 더하기와 빼기는 확대/축소, F는 맞춤, 1부터 7까지는 표준 보기입니다. H는 선택한 것을 숨기고, I는 그것만 표시하고, Shift+H는 모두 표시합니다. 점과 측정기는 다른 곳으로 끌어 옮길 수 있습니다</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>숨기기</translation>
    </message>
    <message>
        <source>Show Only This</source>
        <translation>이것만 표시</translation>
    </message>
    <message>
        <source>Show All</source>
        <translation>모두 표시</translation>
    </message>
    <message>
        <source>Type Coordinates</source>
        <translation>좌표 입력</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SearchActions</name>
    <message>
        <source>&amp;Find Anything …</source>
        <translation>모두 찾기(&amp;F) …</translation>
    </message>
    <message>
        <source>analysis</source>
        <translation>분석</translation>
    </message>
    <message>
        <source>asset</source>
        <translation>에셋</translation>
    </message>
    <message>
        <source>command, menu %1</source>
        <translation>명령, 메뉴 %1</translation>
    </message>
    <message>
        <source>field of %1</source>
        <translation>%1의 필드</translation>
    </message>
    <message>
        <source>result of %1</source>
        <translation>%1의 결과</translation>
    </message>
    <message>
        <source>input quantity of %1</source>
        <translation>%1의 입력량</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>탭</translation>
    </message>
    <message>
        <source>help</source>
        <translation>도움말</translation>
    </message>
    <message>
        <source>help: %1</source>
        <translation>도움말: %1</translation>
    </message>
    <message>
        <source>group</source>
        <translation>그룹</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SearchPalette</name>
    <message>
        <source>Find anything</source>
        <translation>모두 찾기</translation>
    </message>
    <message>
        <source>Analyses, quantities, results, fields, commands, help</source>
        <translation>분석, 양, 결과, 필드, 명령, 도움말</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>찾은 항목</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SecondPart</name>
    <message>
        <source>View of the second part</source>
        <translation>둘째 부분의 보기</translation>
    </message>
    <message>
        <source>What the second part of the stage shows</source>
        <translation>작업 영역의 둘째 부분에 표시할 것</translation>
    </message>
    <message>
        <source>Close this part</source>
        <translation>이 부분 닫기</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SectionBar</name>
    <message>
        <source>Section</source>
        <translation>단면</translation>
    </message>
    <message>
        <source>In the picture Shift+wheel, Page Up and Page Down move the section, with Shift in fine steps; Esc ends it</source>
        <translation>그림에서 Shift+휠, Page Up, Page Down으로 단면을 옮깁니다. Shift와 함께면 미세하게, Esc로 끝냅니다</translation>
    </message>
    <message>
        <source>Position of the section</source>
        <translation>단면의 위치</translation>
    </message>
    <message>
        <source>Section across %1</source>
        <translation>%1에 수직인 단면</translation>
    </message>
    <message>
        <source>Where the plane is; a number without a unit is in %1</source>
        <translation>평면의 위치. 단위가 없는 숫자는 %1 단위입니다</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SectionTool</name>
    <message>
        <source>Section</source>
        <translation>단면</translation>
    </message>
    <message>
        <source>Section: cut away what lies before a plane (S)</source>
        <translation>단면: 평면 앞에 있는 것을 잘라 냅니다 (S)</translation>
    </message>
    <message>
        <source>Flip Side</source>
        <translation>반대쪽</translation>
    </message>
    <message>
        <source>Cut away the other side (Shift+S)</source>
        <translation>다른 쪽을 잘라 냅니다 (Shift+S)</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>끄기</translation>
    </message>
    <message>
        <source>The scene is whole again (Esc)</source>
        <translation>장면이 다시 온전해집니다 (Esc)</translation>
    </message>
    <message>
        <source>Across x</source>
        <translation>x에 수직</translation>
    </message>
    <message>
        <source>Across y</source>
        <translation>y에 수직</translation>
    </message>
    <message>
        <source>Across z</source>
        <translation>z에 수직</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SeenTab</name>
    <message>
        <source>seen</source>
        <translation>드러난-값</translation>
    </message>
    <message>
        <source>What the residuals say</source>
        <translation>잔차가 알려 주는 것</translation>
    </message>
    <message>
        <source>Level of the tests</source>
        <translation>검정의 유의수준</translation>
    </message>
    <message>
        <source>How often a figure that is right is contradicted by chance</source>
        <translation>올바른 수치가 우연히 부정되는 빈도</translation>
    </message>
    <message>
        <source>Level %1 %</source>
        <translation>유의수준 %1 %</translation>
    </message>
    <message>
        <source>Back to Stated</source>
        <translation>제시된 값으로</translation>
    </message>
    <message>
        <source>Take Over as Seen</source>
        <translation>드러난 대로 적용</translation>
    </message>
    <message>
        <source>The results follow from the stated uncertainties again</source>
        <translation>결과를 다시 제시된 불확도에서 구합니다</translation>
    </message>
    <message>
        <source>The results, and all that hang on them, follow from the uncertainties that the residuals see, and change with the readings; can be undone</source>
        <translation>결과와 결과에 따르는 모든 것을 잔차에서 드러난 불확도에서 구하며, 읽음값과 함께 바뀝니다. 실행 취소할 수 있습니다</translation>
    </message>
    <message>
        <source>Back to stated uncertainties</source>
        <translation>제시된 불확도로 되돌리기</translation>
    </message>
    <message>
        <source>Take over uncertainties as seen</source>
        <translation>드러난 불확도 적용</translation>
    </message>
    <message>
        <source>Go to Source</source>
        <translation>출처로 이동</translation>
    </message>
    <message>
        <source>What the residuals are drawn over</source>
        <translation>잔차를 무엇에 대하여 그릴지</translation>
    </message>
    <message>
        <source>Distribution of the residuals</source>
        <translation>잔차의 분포</translation>
    </message>
    <message>
        <source>Quantiles</source>
        <translation>분위수</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>히스토그램</translation>
    </message>
    <message>
        <source>Over: %1</source>
        <translation>가로축: %1</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SeenTableModel</name>
    <message>
        <source>interval of the factor</source>
        <translation>인자의 구간</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SetupForm</name>
    <message>
        <source>Change %1</source>
        <translation>%1 변경</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>외 %n개</numerusform>
        </translation>
    </message>
    <message>
        <source>From “%1”: %2. What is stated of them here is not used.</source>
        <translation>“%1”에서 가져옴: %2. 여기에 제시된 그 양들의 내용은 쓰이지 않습니다.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SetupTableModel</name>
    <message>
        <source>Insert rows in %1</source>
        <translation>%1에 행 삽입</translation>
    </message>
    <message>
        <source>Delete rows of %1</source>
        <translation>%1의 행 삭제</translation>
    </message>
    <message>
        <source>Paste into %1</source>
        <translation>%1에 붙여넣기</translation>
    </message>
    <message>
        <source>Delete rows</source>
        <translation>행 삭제</translation>
    </message>
    <message>
        <source>Fill down in %1</source>
        <translation>%1에서 아래로 채우기</translation>
    </message>
    <message>
        <source>Clear cells of %1</source>
        <translation>%1의 셀 지우기</translation>
    </message>
    <message>
        <source>Change unit in %1</source>
        <translation>%1의 단위 변경</translation>
    </message>
    <message>
        <source>Take %1 into the project</source>
        <translation>%1을(를) 프로젝트에 넣기</translation>
    </message>
    <message>
        <source>%1 is no unit for a quantity in %2.</source>
        <translation>%1은(는) %2 단위의 양에 맞는 단위가 아닙니다.</translation>
    </message>
    <message>
        <source>Its value is %1 of the analysis “%2”: what is stated here is not used.</source>
        <translation>그 값은 분석 “%2”의 %1입니다. 여기에 기재된 내용은 사용되지 않습니다.</translation>
    </message>
    <message>
        <source>%1 of the value</source>
        <translation>값의 %1</translation>
    </message>
    <message>
        <source>%1 absolute, not a part of the value</source>
        <translation>%1(절대값), 값에 대한 비가 아님</translation>
    </message>
    <message>
        <source>Change %1: %2</source>
        <translation>%1 변경: %2</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>%1행</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SortableTable</name>
    <message>
        <source>Click to sort, right click to choose columns</source>
        <translation>클릭하면 정렬, 오른쪽 클릭하면 열 선택</translation>
    </message>
    <message>
        <source>Save Table</source>
        <translation>표 저장</translation>
    </message>
    <message>
        <source>CSV table (*.csv)</source>
        <translation>CSV 표 (*.csv)</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>복사</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>모두 선택</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>열</translation>
    </message>
    <message>
        <source>Original Order</source>
        <translation>원래 순서</translation>
    </message>
    <message>
        <source>Save as CSV …</source>
        <translation>CSV로 저장 …</translation>
    </message>
    <message>
        <source>Fit Widths</source>
        <translation>너비 맞춤</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SpreadsheetView</name>
    <message>
        <source>Copy</source>
        <translation>복사</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>잘라내기</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>붙여넣기</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>지우기</translation>
    </message>
    <message>
        <source>Fill down</source>
        <translation>아래로 채우기</translation>
    </message>
    <message>
        <source>Insert row above</source>
        <translation>위에 행 삽입</translation>
    </message>
    <message>
        <source>Add row at the end</source>
        <translation>끝에 행 추가</translation>
    </message>
    <message>
        <source>Delete rows</source>
        <translation>행 삭제</translation>
    </message>
</context>
<context>
    <name>covaria::ui::Stage</name>
    <message>
        <source>Two views at once</source>
        <translation>두 보기를 동시에</translation>
    </message>
    <message>
        <source>Below Each Other</source>
        <translation>위아래로</translation>
    </message>
    <message>
        <source>Beside Each Other</source>
        <translation>나란히</translation>
    </message>
</context>
<context>
    <name>covaria::ui::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>시작 페이지</translation>
    </message>
    <message>
        <source>New Project</source>
        <translation>새 프로젝트</translation>
    </message>
    <message>
        <source>Open …</source>
        <translation>열기 …</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>최근 파일</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>예제</translation>
    </message>
    <message>
        <source>They open as new projects; the shipped files stay as they are.</source>
        <translation>새 프로젝트로 열립니다. 제공된 파일은 그대로 유지됩니다.</translation>
    </message>
    <message>
        <source>Projects that you open are listed here.</source>
        <translation>연 프로젝트가 여기에 나열됩니다.</translation>
    </message>
    <message>
        <source>First Steps</source>
        <translation>첫걸음</translation>
    </message>
    <message>
        <source>A budget from nothing to a PDF, in ten steps beside the window</source>
        <translation>창 옆의 열 단계로 빈 상태에서 PDF까지 총괄표 하나</translation>
    </message>
    <message>
        <source>What do you want to know?</source>
        <translation>무엇을 알고 싶으신가요?</translation>
    </message>
    <message>
        <source>Library …</source>
        <translation>라이브러리 …</translation>
    </message>
    <message>
        <source>A quantity by an equation</source>
        <translation>방정식으로 구하는 양</translation>
    </message>
    <message>
        <source>Type y = f(x), state each input, get the budget.</source>
        <translation>y = f(x)를 입력하고 각 입력을 제시하면 총괄표가 나옵니다.</translation>
    </message>
    <message>
        <source>Points by instruments</source>
        <translation>측정기로 구하는 점</translation>
    </message>
    <message>
        <source>Tracker, total station, camera; one or many.</source>
        <translation>트래커, 토털 스테이션, 카메라. 하나 또는 여럿.</translation>
    </message>
    <message>
        <source>The pose of an object</source>
        <translation>물체의 포즈</translation>
    </message>
    <message>
        <source>A frame from its points, in the frame of another.</source>
        <translation>점으로 정한 좌표계를 다른 좌표계에서.</translation>
    </message>
    <message>
        <source>A robot</source>
        <translation>로봇</translation>
    </message>
    <message>
        <source>Where its tool is, and what its parameters are.</source>
        <translation>공구가 있는 곳과 매개변수의 값.</translation>
    </message>
    <message>
        <source>A file I have</source>
        <translation>가지고 있는 파일</translation>
    </message>
    <message>
        <source>Excel budget, points, measurement report.</source>
        <translation>Excel 총괄표, 점, 측정 보고서.</translation>
    </message>
    <message>
        <source>Budget, Points or Report …</source>
        <translation>총괄표, 점 또는 보고서 …</translation>
    </message>
    <message>
        <source>Robot (URDF) …</source>
        <translation>로봇(URDF) …</translation>
    </message>
    <message>
        <source>Project …</source>
        <translation>프로젝트 …</translation>
    </message>
    <message>
        <source>Show All %1</source>
        <translation>%1개 모두 표시</translation>
    </message>
</context>
<context>
    <name>covaria::ui::StudiesForm</name>
    <message>
        <source>Study</source>
        <translation>스터디</translation>
    </message>
    <message>
        <source>Adds a study of this analysis</source>
        <translation>이 분석의 스터디를 추가합니다</translation>
    </message>
    <message>
        <source>Adds a copy of this study</source>
        <translation>이 스터디의 사본을 추가합니다</translation>
    </message>
    <message>
        <source>Deletes this study</source>
        <translation>이 스터디를 삭제합니다</translation>
    </message>
    <message>
        <source>Evaluates the analysis at every grid point of this study</source>
        <translation>이 스터디의 모든 격자점에서 분석을 평가합니다</translation>
    </message>
    <message>
        <source>A study evaluates this analysis for many values of a number: a sweep over one, a map over two or three. Add one to see how the uncertainty depends on the set-up.</source>
        <translation>스터디는 한 수의 여러 값에 대해 이 분석을 평가합니다. 하나면 스윕, 둘이나 셋이면 맵입니다. 하나 추가하여 불확도가 측정 구성에 어떻게 의존하는지 보세요.</translation>
    </message>
    <message>
        <source>Name of the study</source>
        <translation>스터디의 이름</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>방법</translation>
    </message>
    <message>
        <source>Law of propagation</source>
        <translation>전파 법칙</translation>
    </message>
    <message>
        <source>Monte Carlo</source>
        <translation>몬테카를로</translation>
    </message>
    <message>
        <source>Trials at each grid point</source>
        <translation>각 격자점의 시행 횟수</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>이름</translation>
    </message>
    <message>
        <source>Trials per point</source>
        <translation>점당 시행 횟수</translation>
    </message>
    <message>
        <source>Add Axis</source>
        <translation>축 추가</translation>
    </message>
    <message>
        <source>Varies one more number: every combination is evaluated</source>
        <translation>수 하나를 더 변화시킵니다. 모든 조합을 평가합니다</translation>
    </message>
    <message>
        <source>Output quantities of the study</source>
        <translation>스터디의 출력량</translation>
    </message>
    <message>
        <source>Output quantities looked at; with none ticked, all measurands</source>
        <translation>살펴볼 출력량. 선택하지 않으면 모든 측정량</translation>
    </message>
    <message>
        <source>Outputs (none ticked: all measurands)</source>
        <translation>출력(선택 없음: 모든 측정량)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::StudyAxisEdit</name>
    <message>
        <source>Axis %1</source>
        <translation>축 %1</translation>
    </message>
    <message>
        <source>Variable %1</source>
        <translation>변수 %1</translation>
    </message>
    <message>
        <source>Remove Axis</source>
        <translation>축 제거</translation>
    </message>
    <message>
        <source>Remove Variable</source>
        <translation>변수 제거</translation>
    </message>
    <message>
        <source>takes these values</source>
        <translation>이 값들을 취함</translation>
    </message>
    <message>
        <source>is multiplied with</source>
        <translation>이 값들을 곱함</translation>
    </message>
    <message>
        <source>has added to it</source>
        <translation>이 값들을 더함</translation>
    </message>
    <message>
        <source>evenly spaced</source>
        <translation>등간격</translation>
    </message>
    <message>
        <source>logarithmically spaced</source>
        <translation>로그 간격</translation>
    </message>
    <message>
        <source>From</source>
        <translation>시작</translation>
    </message>
    <message>
        <source>To</source>
        <translation>끝</translation>
    </message>
    <message>
        <source>Number of values</source>
        <translation>값의 수</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>허용차</translation>
    </message>
    <message>
        <source>It can be put into effect only so well: what counts is the worst within it</source>
        <translation>실제로는 이만큼만 정확히 구현할 수 있습니다. 그 안에서 최악의 경우를 셈합니다</translation>
    </message>
    <message>
        <source>Varied</source>
        <translation>변화 대상</translation>
    </message>
    <message>
        <source>It</source>
        <translation>적용 방식</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>값</translation>
    </message>
    <message>
        <source>choose what is varied</source>
        <translation>변화 대상 선택</translation>
    </message>
    <message>
        <source> (factor)</source>
        <translation> (배율)</translation>
    </message>
    <message>
        <source>%1: has a problem</source>
        <translation>%1: 문제 있음</translation>
    </message>
</context>
<context>
    <name>covaria::ui::StudyTab</name>
    <message>
        <source>study</source>
        <translation>스터디</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>스터디</translation>
    </message>
    <message>
        <source>Study of this analysis</source>
        <translation>이 분석의 스터디</translation>
    </message>
    <message>
        <source>Run Study</source>
        <translation>스터디 실행</translation>
    </message>
    <message>
        <source>Edit …</source>
        <translation>편집 …</translation>
    </message>
    <message>
        <source>Axes, outputs and method of the study, in the properties of the analysis</source>
        <translation>분석 속성에 있는 스터디의 축, 출력, 방법</translation>
    </message>
    <message>
        <source>Quantity of the study</source>
        <translation>스터디의 양</translation>
    </message>
    <message>
        <source>What the chart and the scene show</source>
        <translation>차트와 장면에 표시할 것</translation>
    </message>
    <message>
        <source>Kind of chart</source>
        <translation>차트의 종류</translation>
    </message>
    <message>
        <source>A map, or lines over the first axis</source>
        <translation>맵, 또는 첫 번째 축에 대한 선</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>맵</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>선</translation>
    </message>
    <message>
        <source>Axis of the slices</source>
        <translation>단면의 축</translation>
    </message>
    <message>
        <source>Which axis the slices are across</source>
        <translation>단면이 가로지르는 축</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>단면</translation>
    </message>
    <message>
        <source>slice only</source>
        <translation>단면만</translation>
    </message>
    <message>
        <source>In the scene: the points of this slice; else all</source>
        <translation>장면에서: 이 단면의 점. 아니면 모두</translation>
    </message>
    <message>
        <source>ellipsoids</source>
        <translation>타원체</translation>
    </message>
    <message>
        <source>In the scene: coverage ellipsoids at the grid points</source>
        <translation>장면에서: 격자점의 포함 타원체</translation>
    </message>
    <message>
        <source>Add Study …</source>
        <translation>스터디 추가 …</translation>
    </message>
    <message>
        <source>Out of date: of the project as it was</source>
        <translation>갱신 필요: 이전 상태의 프로젝트</translation>
    </message>
    <message>
        <source>slice: </source>
        <translation>단면: </translation>
    </message>
    <message>
        <source> – out of date</source>
        <translation> – 갱신 필요</translation>
    </message>
    <message>
        <source>running …</source>
        <translation>실행 중 …</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>실패: %1</translation>
    </message>
    <message>
        <source>Not evaluated yet.</source>
        <translation>아직 평가하지 않았습니다.</translation>
    </message>
    <message>
        <source>%1 grid points</source>
        <translation>격자점 %1개</translation>
    </message>
    <message>
        <source>, %1 without values</source>
        <translation>, 값 없음 %1개</translation>
    </message>
    <message>
        <source>&lt;b&gt;Out of date&lt;/b&gt;: shown for the project as it was. </source>
        <translation>&lt;b&gt;갱신 필요&lt;/b&gt;: 이전 상태의 프로젝트를 표시합니다. </translation>
    </message>
    <message>
        <source>“%1” shows how the uncertainty depends on what the study varies.</source>
        <translation>‘%1’을(를) 누르면 스터디가 바꾸는 값에 불확도가 어떻게 의존하는지 보여 줍니다.</translation>
    </message>
    <message>
        <source>A study evaluates the analysis for many values of a number: add one with “%1”.</source>
        <translation>스터디는 한 수의 여러 값에 대해 분석을 평가합니다. ‘%1’(으)로 하나 추가하세요.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::StudyTableModel</name>
    <message>
        <source>Remark</source>
        <translation>비고</translation>
    </message>
    <message>
        <source>Why there are no values, or what is wrong with them</source>
        <translation>값이 없는 이유, 또는 값의 문제</translation>
    </message>
</context>
<context>
    <name>covaria::ui::TabBar</name>
    <message>
        <source>More tabs</source>
        <translation>더 많은 탭</translation>
    </message>
</context>
<context>
    <name>covaria::ui::TableEditor</name>
    <message>
        <source>Take into the project</source>
        <translation>프로젝트에 넣기</translation>
    </message>
    <message>
        <source>Import CSV …</source>
        <translation>CSV 가져오기 …</translation>
    </message>
    <message>
        <source>Read from %1</source>
        <translation>%1에서 읽음</translation>
    </message>
    <message>
        <source>The rows are read from %1. Taken into the project they can be edited here.</source>
        <translation>행을 %1에서 읽습니다. 프로젝트에 넣으면 여기서 편집할 수 있습니다.</translation>
    </message>
    <message>
        <source>Import CSV into %1</source>
        <translation>%1에 CSV 가져오기</translation>
    </message>
    <message>
        <source>Tables (*.csv *.tsv *.txt);;All files (*)</source>
        <translation>표 (*.csv *.tsv *.txt);;모든 파일 (*)</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 가져오기</translation>
    </message>
    <message>
        <source>All columns</source>
        <translation>모든 열</translation>
    </message>
    <message>
        <source>Shows also the columns that no row has something in</source>
        <translation>어느 행에도 값이 없는 열도 보입니다</translation>
    </message>
</context>
<context>
    <name>covaria::ui::TargetBox</name>
    <message>
        <source>What is varied: type a part of its name to search</source>
        <translation>변화 대상: 검색하려면 이름의 일부를 입력하세요</translation>
    </message>
    <message>
        <source>What is varied</source>
        <translation>변화 대상</translation>
    </message>
    <message>
        <source>“%1” names nothing that can be varied.</source>
        <translation>“%1”에 해당하는 변화 대상이 없습니다.</translation>
    </message>
    <message numerus="yes">
        <source>“%1” names %n things that can be varied.</source>
        <translation>
            <numerusform>“%1”에 해당하는 변화 대상이 %n개 있습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source> (factor)</source>
        <translation> (배율)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::UnitButton</name>
    <message>
        <source>Units</source>
        <translation>단위</translation>
    </message>
    <message>
        <source>Units of the tables and charts</source>
        <translation>표와 차트의 단위</translation>
    </message>
    <message>
        <source>As the Model Gives Them</source>
        <translation>모델이 주는 대로</translation>
    </message>
    <message>
        <source>Change unit of results</source>
        <translation>결과 단위 변경</translation>
    </message>
    <message>
        <source>Clear units of results</source>
        <translation>결과 단위 지우기</translation>
    </message>
    <message>
        <source>In Reports and Files Too</source>
        <translation>보고서와 파일에도 사용</translation>
    </message>
    <message>
        <source>States the units that are shown in the project: they are those of its documents</source>
        <translation>표시된 단위를 프로젝트에 정합니다. 문서에도 그 단위를 씁니다</translation>
    </message>
    <message>
        <source>Units of the tables and charts; reports and files have those that the project states</source>
        <translation>표와 그래프의 단위. 보고서와 파일은 프로젝트가 정한 단위를 씁니다</translation>
    </message>
</context>
<context>
    <name>covaria::ui::UnitChoices</name>
    <message>
        <source>Lengths</source>
        <translation>길이</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>각도</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>힘</translation>
    </message>
    <message>
        <source>Moments</source>
        <translation>모멘트</translation>
    </message>
</context>
<context>
    <name>covaria::ui::UnreadTexts</name>
    <message>
        <source>What is typed in a field cannot be read. %1</source>
        <translation>필드에 입력한 것을 읽을 수 없습니다. %1</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ViewActions</name>
    <message>
        <source>&amp;Scene</source>
        <translation>장면(&amp;S)</translation>
    </message>
    <message>
        <source>Save View</source>
        <translation>보기 저장</translation>
    </message>
    <message>
        <source>Name of the view:</source>
        <translation>보기 이름:</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>화면 맞춤</translation>
    </message>
    <message>
        <source>&amp;Orthographic</source>
        <translation>직교(&amp;O)</translation>
    </message>
    <message>
        <source>Parallel lines stay parallel, and the scale bar holds everywhere</source>
        <translation>평행선이 평행으로 남고 축척이 어디서나 맞습니다</translation>
    </message>
    <message>
        <source>Show &amp;All</source>
        <translation>모두 표시(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Save View …</source>
        <translation>보기 저장(&amp;S) …</translation>
    </message>
    <message>
        <source>Remo&amp;ve View</source>
        <translation>보기 제거(&amp;V)</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>보기 %1</translation>
    </message>
    <message>
        <source>Save View %1</source>
        <translation>보기 %1 저장</translation>
    </message>
    <message>
        <source>Remove View %1</source>
        <translation>보기 %1 제거</translation>
    </message>
</context>
</TS>
