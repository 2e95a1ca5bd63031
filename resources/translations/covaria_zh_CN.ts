<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>QObject</name>
    <message>
        <source>Move %1</source>
        <translation>移动 %1</translation>
    </message>
    <message>
        <source>&lt;p&gt;%1 more rows; the exported table has all of them.&lt;/p&gt;</source>
        <translation>&lt;p&gt;另有 %1 行；导出的表格包含全部行。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>旋转 %1</translation>
    </message>
    <message>
        <source>&lt;b&gt;Trial %1&lt;/b&gt;, inputs farthest from their estimates: %2</source>
        <translation>&lt;b&gt;试验 %1&lt;/b&gt;，偏离估计值最远的输入量：%2</translation>
    </message>
    <message>
        <source>Only %1 is shown (Shift+H: all)</source>
        <translation>仅显示 %1（Shift+H：全部）</translation>
    </message>
    <message numerus="yes">
        <source>%n hidden (Shift+H: show all)</source>
        <translation>
            <numerusform>已隐藏 %n 项（Shift+H：全部显示）</numerusform>
        </translation>
    </message>
    <message>
        <source>The interval is not symmetric about the estimate: state the interval, not y ± U (JCGM 101 5.5).</source>
        <translation>区间关于估计值不对称：请给出区间，而不是 y ± U（JCGM 101 5.5）。</translation>
    </message>
    <message>
        <source>Turns about its %1 axis</source>
        <translation>绕其 %1 轴旋转</translation>
    </message>
    <message>
        <source>Moves along %1</source>
        <translation>沿 %1 移动</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>Pose from points</source>
        <extracomment>Measurement model</extracomment>
        <translation>由点求位姿</translation>
    </message>
    <message>
        <source>Base frame</source>
        <translation>基坐标系</translation>
    </message>
    <message>
        <source>Base points</source>
        <translation>基坐标系的点</translation>
    </message>
    <message>
        <source>Nominal coordinates of the points in their own frame, and standard uncertainties of single coordinates where they differ from the common ones.</source>
        <translation>各点在其自身坐标系中的标称坐标；单个坐标的标准不确定度与共用值不同时，在此给出。</translation>
    </message>
    <message>
        <source>name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Name of the point.</source>
        <translation>点的名称。</translation>
    </message>
    <message>
        <source>Nominal coordinate x in the point&apos;s own frame.</source>
        <translation>点在其自身坐标系中的标称坐标 x。</translation>
    </message>
    <message>
        <source>Nominal coordinate y in the point&apos;s own frame.</source>
        <translation>点在其自身坐标系中的标称坐标 y。</translation>
    </message>
    <message>
        <source>Nominal coordinate z in the point&apos;s own frame.</source>
        <translation>点在其自身坐标系中的标称坐标 z。</translation>
    </message>
    <message>
        <source>Standard uncertainty of this x; empty: as typed for all.</source>
        <translation>该 x 的标准不确定度；留空：采用为全部点输入的值。</translation>
    </message>
    <message>
        <source>Standard uncertainty of this y; empty: as typed for all.</source>
        <translation>该 y 的标准不确定度；留空：采用为全部点输入的值。</translation>
    </message>
    <message>
        <source>Standard uncertainty of this z; empty: as typed for all.</source>
        <translation>该 z 的标准不确定度；留空：采用为全部点输入的值。</translation>
    </message>
    <message>
        <source>Frame from its points</source>
        <translation>由点建立坐标系</translation>
    </message>
    <message>
        <source>3-2-1: the origin from point 1, the x-axis from points 1 and 2, the xy-plane from points 1, 2 and 3. Least squares: the frame in which the nominal coordinates fit all points best.</source>
        <translation>3-2-1：原点取自点 1，x 轴取自点 1 和 2，xy 平面取自点 1、2 和 3。最小二乘：标称坐标与全部点拟合最佳的坐标系。</translation>
    </message>
    <message>
        <source>3-2-1</source>
        <translation>3-2-1</translation>
    </message>
    <message>
        <source>least squares</source>
        <translation>最小二乘</translation>
    </message>
    <message>
        <source>Side of point 3</source>
        <translation>点 3 所在侧</translation>
    </message>
    <message>
        <source>On which side of the x-axis point 3 lies in the base frame b; this directs z.</source>
        <translation>在基坐标系 b 中，点 3 位于 x 轴的哪一侧；由此确定 z 的方向。</translation>
    </message>
    <message>
        <source>negative y: z = (q3 − q1) × x</source>
        <translation>y 为负：z = (q3 − q1) × x</translation>
    </message>
    <message>
        <source>positive y: z = x × (q3 − q1)</source>
        <translation>y 为正：z = x × (q3 − q1)</translation>
    </message>
    <message>
        <source>Origin from point 1, x</source>
        <translation>原点相对点 1，x</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along x of the base frame b (s of Eqs 17 and 18).</source>
        <translation>原点相对点 1 沿基坐标系 b 的 x 方向的位置（式 17 和 18 中的 s）。</translation>
    </message>
    <message>
        <source>Origin from point 1, y</source>
        <translation>原点相对点 1，y</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along y of the base frame b (s of Eqs 17 and 18).</source>
        <translation>原点相对点 1 沿基坐标系 b 的 y 方向的位置（式 17 和 18 中的 s）。</translation>
    </message>
    <message>
        <source>Origin from point 1, z</source>
        <translation>原点相对点 1，z</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along z of the base frame b (s of Eqs 17 and 18).</source>
        <translation>原点相对点 1 沿基坐标系 b 的 z 方向的位置（式 17 和 18 中的 s）。</translation>
    </message>
    <message>
        <source>Pose of the base in frame 0</source>
        <translation>基座在坐标系 0 中的位姿</translation>
    </message>
    <message>
        <source>Where the base stands in the frame of the measurement (frame 0, the world of the picture). It matters only for an instrument that stands somewhere.</source>
        <translation>基座在测量坐标系（坐标系 0，即图中的世界坐标系）中的位置。仅对设于某处的仪器有影响。</translation>
    </message>
    <message>
        <source>Moving frame</source>
        <translation>动坐标系</translation>
    </message>
    <message>
        <source>Points of the moving frame</source>
        <translation>动坐标系的点</translation>
    </message>
    <message>
        <source>On which side of the x-axis point 3 lies in the moving frame p; this directs z.</source>
        <translation>在动坐标系 p 中，点 3 位于 x 轴的哪一侧；由此确定 z 的方向。</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along x of the moving frame p (s of Eqs 17 and 18).</source>
        <translation>原点相对点 1 沿动坐标系 p 的 x 方向的位置（式 17 和 18 中的 s）。</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along y of the moving frame p (s of Eqs 17 and 18).</source>
        <translation>原点相对点 1 沿动坐标系 p 的 y 方向的位置（式 17 和 18 中的 s）。</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along z of the moving frame p (s of Eqs 17 and 18).</source>
        <translation>原点相对点 1 沿动坐标系 p 的 z 方向的位置（式 17 和 18 中的 s）。</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>位姿</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>评定</translation>
    </message>
    <message>
        <source>A priori: at the nominal coordinates. A posteriori: at the means of measured coordinates.</source>
        <translation>先验：在标称坐标处评定。后验：在实测坐标的平均值处评定。</translation>
    </message>
    <message>
        <source>a priori (nominal poses)</source>
        <translation>先验（标称位姿）</translation>
    </message>
    <message>
        <source>a posteriori (measured points)</source>
        <translation>后验（实测点）</translation>
    </message>
    <message>
        <source>Nominal poses of the moving frame in the base frame; angles are R = Rz(γ) Ry(β) Rx(α). All poses share the measurement of the base.</source>
        <translation>动坐标系在基坐标系中的标称位姿；角度定义为 R = Rz(γ) Ry(β) Rx(α)。所有位姿共用基坐标系的测量结果。</translation>
    </message>
    <message>
        <source>Name of the pose; groups its results.</source>
        <translation>位姿的名称；其结果按此分组。</translation>
    </message>
    <message>
        <source>Position x in the base frame.</source>
        <translation>在基坐标系中的位置 x。</translation>
    </message>
    <message>
        <source>Position y in the base frame.</source>
        <translation>在基坐标系中的位置 y。</translation>
    </message>
    <message>
        <source>Position z in the base frame.</source>
        <translation>在基坐标系中的位置 z。</translation>
    </message>
    <message>
        <source>Rotation about x.</source>
        <translation>绕 x 的旋转。</translation>
    </message>
    <message>
        <source>Rotation about y.</source>
        <translation>绕 y 的旋转。</translation>
    </message>
    <message>
        <source>Rotation about z.</source>
        <translation>绕 z 的旋转。</translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation>实测点</translation>
    </message>
    <message>
        <source>Coordinates in one frame 0 for the base and every pose, typed or from a CSV file; the mean of the repeats is the estimate.</source>
        <translation>基座和各位姿在同一坐标系 0 中的坐标，手工输入或来自 CSV 文件；重复测量的平均值为估计值。</translation>
    </message>
    <message>
        <source>set</source>
        <translation>点组</translation>
    </message>
    <message>
        <source>&quot;base&quot;, or the name of a pose.</source>
        <translation>“base”，或某个位姿的名称。</translation>
    </message>
    <message>
        <source>point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>repeat</source>
        <translation>重复</translation>
    </message>
    <message>
        <source>Number of the repetition.</source>
        <translation>重复测量的序号。</translation>
    </message>
    <message>
        <source>Measured coordinate x in frame 0.</source>
        <translation>在坐标系 0 中的实测坐标 x。</translation>
    </message>
    <message>
        <source>Measured coordinate y in frame 0.</source>
        <translation>在坐标系 0 中的实测坐标 y。</translation>
    </message>
    <message>
        <source>Measured coordinate z in frame 0.</source>
        <translation>在坐标系 0 中的实测坐标 z。</translation>
    </message>
    <message>
        <source>Orientation stated as</source>
        <translation>姿态表示方式</translation>
    </message>
    <message>
        <source>Numbers in which the result states the orientation of the moving frame. Angles are undefined in gimbal lock; rotation vector and quaternion are not.</source>
        <translation>结果中表示动坐标系姿态的数值。万向节锁定时角度无定义；旋转矢量和四元数则不受影响。</translation>
    </message>
    <message>
        <source>Z-Y-X angles (roll α, pitch β, yaw γ)</source>
        <translation>Z-Y-X 角（横滚 α、俯仰 β、偏航 γ）</translation>
    </message>
    <message>
        <source>Z-Y-Z angles</source>
        <translation>Z-Y-Z 角</translation>
    </message>
    <message>
        <source>rotation vector</source>
        <translation>旋转矢量</translation>
    </message>
    <message>
        <source>unit quaternion</source>
        <translation>单位四元数</translation>
    </message>
    <message>
        <source>Uncertainty: Base frame</source>
        <translation>不确定度：基坐标系</translation>
    </message>
    <message>
        <source>Uncertainty of the points</source>
        <translation>点的不确定度</translation>
    </message>
    <message>
        <source>Standard uncertainties typed here, or those that an artefact or an instrument of the project gives.</source>
        <translation>在此输入的标准不确定度，或由项目中的实物标准器或仪器给出的标准不确定度。</translation>
    </message>
    <message>
        <source>typed</source>
        <translation>手工输入</translation>
    </message>
    <message>
        <source>artefact or instrument</source>
        <translation>实物标准器或仪器</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along x of the base frame b.</source>
        <translation>点坐标沿基坐标系 b 的 x 方向的标准不确定度。</translation>
    </message>
    <message>
        <source>u_x is common</source>
        <translation>u_x 为共有</translation>
    </message>
    <message>
        <source>One and the same deviation along x for all base points, instead of independent ones.</source>
        <translation>所有基坐标系点沿 x 共有同一个偏差，而不是各自独立的偏差。</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along y of the base frame b.</source>
        <translation>点坐标沿基坐标系 b 的 y 方向的标准不确定度。</translation>
    </message>
    <message>
        <source>u_y is common</source>
        <translation>u_y 为共有</translation>
    </message>
    <message>
        <source>One and the same deviation along y for all base points, instead of independent ones.</source>
        <translation>所有基坐标系点沿 y 共有同一个偏差，而不是各自独立的偏差。</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along z of the base frame b.</source>
        <translation>点坐标沿基坐标系 b 的 z 方向的标准不确定度。</translation>
    </message>
    <message>
        <source>u_z is common</source>
        <translation>u_z 为共有</translation>
    </message>
    <message>
        <source>One and the same deviation along z for all base points, instead of independent ones.</source>
        <translation>所有基坐标系点沿 z 共有同一个偏差，而不是各自独立的偏差。</translation>
    </message>
    <message>
        <source>Their distribution</source>
        <translation>其分布</translation>
    </message>
    <message>
        <source>The distribution of typed deviations of the points; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation>手工输入的点偏差的分布；无论形状如何，给出的都是其标准不确定度。</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>正态</translation>
    </message>
    <message>
        <source>rectangular: limits ± √3 u</source>
        <translation>矩形：界限 ± √3 u</translation>
    </message>
    <message>
        <source>triangular: limits ± √6 u</source>
        <translation>三角：界限 ± √6 u</translation>
    </message>
    <message>
        <source>arc sine: limits ± √2 u</source>
        <translation>反正弦：界限 ± √2 u</translation>
    </message>
    <message>
        <source>Artefact or instrument</source>
        <translation>实物标准器或仪器</translation>
    </message>
    <message>
        <source>Gives the uncertainty of the coordinates of the points of the base frame b.</source>
        <translation>给出基坐标系 b 各点坐标的不确定度。</translation>
    </message>
    <message>
        <source>Uncertainty: Moving frame</source>
        <translation>不确定度：动坐标系</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along x of the moving frame p.</source>
        <translation>点坐标沿动坐标系 p 的 x 方向的标准不确定度。</translation>
    </message>
    <message>
        <source>One and the same deviation along x for all points of the moving frame, in all poses, instead of independent ones.</source>
        <translation>动坐标系的所有点在所有位姿下沿 x 共有同一个偏差，而不是各自独立的偏差。</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along y of the moving frame p.</source>
        <translation>点坐标沿动坐标系 p 的 y 方向的标准不确定度。</translation>
    </message>
    <message>
        <source>One and the same deviation along y for all points of the moving frame, in all poses, instead of independent ones.</source>
        <translation>动坐标系的所有点在所有位姿下沿 y 共有同一个偏差，而不是各自独立的偏差。</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along z of the moving frame p.</source>
        <translation>点坐标沿动坐标系 p 的 z 方向的标准不确定度。</translation>
    </message>
    <message>
        <source>One and the same deviation along z for all points of the moving frame, in all poses, instead of independent ones.</source>
        <translation>动坐标系的所有点在所有位姿下沿 z 共有同一个偏差，而不是各自独立的偏差。</translation>
    </message>
    <message>
        <source>Gives the uncertainty of the coordinates of the points of the moving frame p.</source>
        <translation>给出动坐标系 p 各点坐标的不确定度。</translation>
    </message>
    <message>
        <source>Uncertainties along</source>
        <translation>不确定度的方向</translation>
    </message>
    <message>
        <source>Along which axes the typed uncertainties of the moving points lie: those of the moving frame, which turn with it, or those of the base frame, the same in all poses.</source>
        <translation>手工输入的动坐标系点的不确定度沿哪些轴：随动坐标系转动的动坐标系各轴，或在所有位姿下都相同的基坐标系各轴。</translation>
    </message>
    <message>
        <source>the axes of the moving frame</source>
        <translation>动坐标系的轴</translation>
    </message>
    <message>
        <source>the axes of the base frame</source>
        <translation>基坐标系的轴</translation>
    </message>
    <message>
        <source>Points from sensors</source>
        <translation>由传感器求点</translation>
    </message>
    <message>
        <source>Network</source>
        <translation>网络</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>传感器</translation>
    </message>
    <message>
        <source>The instruments of the network, each an instrument of the project that stands somewhere.</source>
        <translation>网络中的仪器，每一台都是项目中设于某处的仪器。</translation>
    </message>
    <message>
        <source>sensor</source>
        <translation>传感器</translation>
    </message>
    <message>
        <source>An instrument of the project.</source>
        <translation>项目中的一台仪器。</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>目标点</translation>
    </message>
    <message>
        <source>Points to be localised, at their nominal coordinates.</source>
        <translation>待定位的点，取其标称坐标。</translation>
    </message>
    <message>
        <source>Name of the target, unique.</source>
        <translation>目标点的名称，须唯一。</translation>
    </message>
    <message>
        <source>Nominal coordinate x.</source>
        <translation>标称坐标 x。</translation>
    </message>
    <message>
        <source>Nominal coordinate y.</source>
        <translation>标称坐标 y。</translation>
    </message>
    <message>
        <source>Nominal coordinate z.</source>
        <translation>标称坐标 z。</translation>
    </message>
    <message>
        <source>new set-up</source>
        <translation>重新设站</translation>
    </message>
    <message>
        <source>The sensors were located anew before this target: it and those below share the deviations of the stations with each other, not with the targets above.</source>
        <translation>在测量该目标点之前，传感器已重新定位：该目标点及其以下各点彼此共有测站偏差，与以上各点不共有。</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Distances between targets that are measurands too, for instance of a scale bar.</source>
        <translation>同样作为被测量的目标点间距离，例如基准尺的长度。</translation>
    </message>
    <message>
        <source>from</source>
        <translation>自</translation>
    </message>
    <message>
        <source>Name of a target.</source>
        <translation>一个目标点的名称。</translation>
    </message>
    <message>
        <source>to</source>
        <translation>至</translation>
    </message>
    <message>
        <source>Name of another target.</source>
        <translation>另一个目标点的名称。</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Angles at a target between the directions to two others, measurands too.</source>
        <translation>在某个目标点处、指向另外两个目标点的方向之间的角度，同样作为被测量。</translation>
    </message>
    <message>
        <source>at</source>
        <translation>位于</translation>
    </message>
    <message>
        <source>Name of the target where the angle is.</source>
        <translation>角度顶点处目标点的名称。</translation>
    </message>
    <message>
        <source>Name of a third target.</source>
        <translation>第三个目标点的名称。</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>Frames on three targets (3-2-1), whose position and Z-Y-X angles in the world are measurands too.</source>
        <translation>建立在三个目标点上（3-2-1）的坐标系，其在世界坐标系中的位置和 Z-Y-X 角同样作为被测量。</translation>
    </message>
    <message>
        <source>Name of the frame, unique.</source>
        <translation>坐标系的名称，须唯一。</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>原点</translation>
    </message>
    <message>
        <source>Target at its origin.</source>
        <translation>位于其原点的目标点。</translation>
    </message>
    <message>
        <source>on x</source>
        <translation>在 x 上</translation>
    </message>
    <message>
        <source>Target on its positive x-axis.</source>
        <translation>位于其正 x 轴上的目标点。</translation>
    </message>
    <message>
        <source>in xy</source>
        <translation>在 xy 内</translation>
    </message>
    <message>
        <source>Target in its xy-plane, at positive y.</source>
        <translation>位于其 xy 平面内、y 为正的目标点。</translation>
    </message>
    <message>
        <source>Calibrated lengths</source>
        <translation>已校准长度</translation>
    </message>
    <message>
        <source>Scale bars and other calibrated distances between two targets: compared with the network, or a constraint of the estimation.</source>
        <translation>基准尺以及两个目标点之间的其他已校准距离：与网络比较，或作为估计的约束。</translation>
    </message>
    <message>
        <source>length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Calibrated length; empty in a design: the distance of the nominal targets.</source>
        <translation>已校准长度；在设计中留空：取标称目标点间的距离。</translation>
    </message>
    <message>
        <source>Standard uncertainty of the length as it is during the measurement, with temperature.</source>
        <translation>该长度在测量期间的标准不确定度，含温度影响。</translation>
    </message>
    <message>
        <source>role</source>
        <translation>作用</translation>
    </message>
    <message>
        <source>Check: the difference between network and calibration is a measurand. Constraint: the length is adjusted with the readings.</source>
        <translation>检核：网络与校准之差为被测量。约束：该长度与读数一起平差。</translation>
    </message>
    <message>
        <source>check</source>
        <translation>检核</translation>
    </message>
    <message>
        <source>constraint</source>
        <translation>约束</translation>
    </message>
    <message>
        <source>distribution</source>
        <translation>分布</translation>
    </message>
    <message>
        <source>The distribution that has the standard uncertainty u; empty: normal.</source>
        <translation>具有标准不确定度 u 的分布；留空：正态。</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>读数</translation>
    </message>
    <message>
        <source>A priori: the readings are those of the nominal targets. A posteriori: the readings are given.</source>
        <translation>先验：读数取标称目标点的读数。后验：读数已给出。</translation>
    </message>
    <message>
        <source>a priori (design: nominal targets)</source>
        <translation>先验（设计：标称目标点）</translation>
    </message>
    <message>
        <source>a posteriori (given readings)</source>
        <translation>后验（给定读数）</translation>
    </message>
    <message>
        <source>What the sensors read, one row for a sensor and a target, typed or from a CSV file; leave empty what was not read.</source>
        <translation>传感器的读数，每个传感器和目标点占一行，手工输入或来自 CSV 文件；未读取的项留空。</translation>
    </message>
    <message>
        <source>target</source>
        <translation>目标点</translation>
    </message>
    <message>
        <source>Name of the target.</source>
        <translation>目标点的名称。</translation>
    </message>
    <message>
        <source>The instrument that read it.</source>
        <translation>读取该点的仪器。</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Slope distance.</source>
        <translation>斜距。</translation>
    </message>
    <message>
        <source>azimuth</source>
        <translation>方位角</translation>
    </message>
    <message>
        <source>Horizontal angle from the sensor&apos;s x-axis, positive towards y; whole turns do not matter.</source>
        <translation>从传感器 x 轴起算的水平角，朝向 y 为正；整圈数无影响。</translation>
    </message>
    <message>
        <source>elevation</source>
        <translation>俯仰角</translation>
    </message>
    <message>
        <source>Vertical angle above the sensor&apos;s xy-plane.</source>
        <translation>高于传感器 xy 平面的垂直角。</translation>
    </message>
    <message>
        <source>Estimation</source>
        <translation>估计</translation>
    </message>
    <message>
        <source>Estimator</source>
        <translation>估计方法</translation>
    </message>
    <message>
        <source>How a target&apos;s coordinates follow from its readings.</source>
        <translation>如何由读数得到目标点的坐标。</translation>
    </message>
    <message>
        <source>non-linear weighted least squares</source>
        <translation>非线性加权最小二乘</translation>
    </message>
    <message>
        <source>linearised equations: OLS, then GLS (Eqs 1-4 of the paper)</source>
        <translation>线性化方程：先 OLS，后 GLS（论文式 1-4）</translation>
    </message>
    <message>
        <source>linearised equations: OLS alone (Eq 3 of the paper)</source>
        <translation>线性化方程：仅 OLS（论文式 3）</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>权</translation>
    </message>
    <message>
        <source>What the weights of the equations account for. Weights from the readings alone, as in the paper, are not the best where the stations are uncertain.</source>
        <translation>方程的权考虑哪些因素。测站不确定时，如论文那样仅由读数定权并非最佳。</translation>
    </message>
    <message>
        <source>readings and stations, all targets of a set-up at once</source>
        <translation>读数和测站，一次设站的所有目标点同时估计</translation>
    </message>
    <message>
        <source>readings alone, each target by itself (the paper)</source>
        <translation>仅读数，每个目标点单独估计（论文）</translation>
    </message>
    <message>
        <source>TCP from ballbars</source>
        <translation>由球杆仪求 TCP</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Ballbars</source>
        <translation>球杆仪</translation>
    </message>
    <message>
        <source>The set of telescopic ballbars that measures the points.</source>
        <translation>测量这些点的一组伸缩式球杆仪。</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Gives the repeatability with which the robot goes to the points; none: an ideal robot.</source>
        <translation>给出机器人到达各点的重复性；无：理想机器人。</translation>
    </message>
    <message>
        <source>tool centre point, planned procedure</source>
        <translation>工具中心点，计划程序</translation>
    </message>
    <message>
        <source>tool centre point, measured points</source>
        <translation>工具中心点，实测点</translation>
    </message>
    <message>
        <source>points alone</source>
        <translation>仅点</translation>
    </message>
    <message>
        <source>Procedure</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Flange</source>
        <translation>法兰</translation>
    </message>
    <message>
        <source>Pose of the flange in the robot&apos;s frame before it turns; its origin is the centre of the sphere on which the ball moves.</source>
        <translation>法兰转动前在机器人坐标系中的位姿；其原点为球运动所在球面的中心。</translation>
    </message>
    <message>
        <source>Tool x</source>
        <translation>工具 x</translation>
    </message>
    <message>
        <source>Nominal coordinate x of the tool centre point in the flange&apos;s frame.</source>
        <translation>工具中心点在法兰坐标系中的标称坐标 x。</translation>
    </message>
    <message>
        <source>Tool y</source>
        <translation>工具 y</translation>
    </message>
    <message>
        <source>Nominal coordinate y of the tool centre point in the flange&apos;s frame.</source>
        <translation>工具中心点在法兰坐标系中的标称坐标 y。</translation>
    </message>
    <message>
        <source>Tool z</source>
        <translation>工具 z</translation>
    </message>
    <message>
        <source>Nominal coordinate z of the tool centre point in the flange&apos;s frame.</source>
        <translation>工具中心点在法兰坐标系中的标称坐标 z。</translation>
    </message>
    <message>
        <source>Rotations</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Two or three rotations of the flange about its own axes, its origin held in place: the ball traces an arc in each.</source>
        <translation>法兰绕其自身轴的两次或三次旋转，其原点保持不动：每次旋转中球画出一段圆弧。</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Axis of the flange about which the robot turns.</source>
        <translation>机器人绕法兰的哪根轴转动。</translation>
    </message>
    <message>
        <source>start</source>
        <translation>起始</translation>
    </message>
    <message>
        <source>Angle at the first point.</source>
        <translation>第一个点处的角度。</translation>
    </message>
    <message>
        <source>span</source>
        <translation>跨度</translation>
    </message>
    <message>
        <source>Angle from the first point to the last; negative: turned the other way.</source>
        <translation>从第一个点到最后一个点的角度；负值：反向转动。</translation>
    </message>
    <message>
        <source>points</source>
        <translation>点数</translation>
    </message>
    <message>
        <source>Number of points, equally spaced from the first to the last.</source>
        <translation>点的数目，从第一个点到最后一个点等间隔。</translation>
    </message>
    <message>
        <source>Points as measured, each with the axis of its rotation and the commanded angle, typed or from a CSV file.</source>
        <translation>实测点，各带其旋转轴和指令角度，手工输入或来自 CSV 文件。</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Commanded angle of rotation.</source>
        <translation>指令旋转角度。</translation>
    </message>
    <message>
        <source>Coordinate x in the frame of the ballbars.</source>
        <translation>在球杆仪坐标系中的坐标 x。</translation>
    </message>
    <message>
        <source>Coordinate y in the frame of the ballbars.</source>
        <translation>在球杆仪坐标系中的坐标 y。</translation>
    </message>
    <message>
        <source>Coordinate z in the frame of the ballbars.</source>
        <translation>在球杆仪坐标系中的坐标 z。</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Places of the ball that are measured, typed or from a CSV file.</source>
        <translation>被测量的球的位置，手工输入或来自 CSV 文件。</translation>
    </message>
    <message>
        <source>Name of the point, unique.</source>
        <translation>点的名称，须唯一。</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>拟合</translation>
    </message>
    <message>
        <source>Axes of the flange</source>
        <translation>法兰的轴</translation>
    </message>
    <message>
        <source>Measured axes are not exactly perpendicular: which one is kept as measured. A third measured axis then only helps the sphere and the mean.</source>
        <translation>实测的轴并不严格垂直：哪一根轴保持实测值。第三根实测轴此时仅有助于确定球面和平均值。</translation>
    </message>
    <message>
        <source>y as measured, x nearest to measured</source>
        <translation>y 取实测值，x 取最接近实测值</translation>
    </message>
    <message>
        <source>x as measured, y nearest to measured</source>
        <translation>x 取实测值，y 取最接近实测值</translation>
    </message>
    <message>
        <source>z as measured, x nearest to measured</source>
        <translation>z 取实测值，x 取最接近实测值</translation>
    </message>
    <message>
        <source>nearest to all measured axes</source>
        <translation>最接近所有实测轴</translation>
    </message>
    <message>
        <source>Centre of the flange</source>
        <translation>法兰中心</translation>
    </message>
    <message>
        <source>Sphere through all points by linear least squares, or refined to least distances from it.</source>
        <translation>用线性最小二乘求过所有点的球面，或再精化使到球面的距离最小。</translation>
    </message>
    <message>
        <source>sphere, geometric fit from the linear one</source>
        <translation>球面，由线性拟合起始的几何拟合</translation>
    </message>
    <message>
        <source>sphere, linear fit</source>
        <translation>球面，线性拟合</translation>
    </message>
    <message>
        <source>Robot pose</source>
        <translation>机器人位姿</translation>
    </message>
    <message>
        <source>The arm, with its parameters and their uncertainty.</source>
        <translation>机械臂及其参数和参数的不确定度。</translation>
    </message>
    <message>
        <source>Components of a parameter</source>
        <translation>参数的分量</translation>
    </message>
    <message>
        <source>Each by itself, so that the budget tells the sources apart; or combined into one normal deviation, which needs fewer draws.</source>
        <translation>各自单独，使预算能区分各来源；或合并为一个正态偏差，所需抽样数较少。</translation>
    </message>
    <message>
        <source>each by itself</source>
        <translation>各自单独</translation>
    </message>
    <message>
        <source>combined into one</source>
        <translation>合并为一个</translation>
    </message>
    <message>
        <source>Correlation of the parameters</source>
        <translation>参数的相关性</translation>
    </message>
    <message>
        <source>Used as the robot states it; or ignored, as in the paper, to see what that does.</source>
        <translation>按机器人给出的相关性使用；或如论文那样忽略，以查看其影响。</translation>
    </message>
    <message>
        <source>used</source>
        <translation>使用</translation>
    </message>
    <message>
        <source>ignored (the paper)</source>
        <translation>忽略（论文）</translation>
    </message>
    <message>
        <source>Poses by joint readings</source>
        <translation>由关节读数给定位姿</translation>
    </message>
    <message>
        <source>Readings of the joints, typed or from a CSV file. An empty cell is the zero reading of the joint; a robot with fewer joints leaves the last columns empty.</source>
        <translation>关节读数，手工输入或来自 CSV 文件。空单元格表示该关节的零位读数；关节较少的机器人最后几列留空。</translation>
    </message>
    <message>
        <source>Name of the pose, unique.</source>
        <translation>位姿的名称，须唯一。</translation>
    </message>
    <message>
        <source>Reading of joint 1, if it turns.</source>
        <translation>关节 1 的读数（转动关节）。</translation>
    </message>
    <message>
        <source>Reading of joint 2, if it turns.</source>
        <translation>关节 2 的读数（转动关节）。</translation>
    </message>
    <message>
        <source>Reading of joint 3, if it turns.</source>
        <translation>关节 3 的读数（转动关节）。</translation>
    </message>
    <message>
        <source>Reading of joint 4, if it turns.</source>
        <translation>关节 4 的读数（转动关节）。</translation>
    </message>
    <message>
        <source>Reading of joint 5, if it turns.</source>
        <translation>关节 5 的读数（转动关节）。</translation>
    </message>
    <message>
        <source>Reading of joint 6, if it turns.</source>
        <translation>关节 6 的读数（转动关节）。</translation>
    </message>
    <message>
        <source>Reading of joint 7, if it turns.</source>
        <translation>关节 7 的读数（转动关节）。</translation>
    </message>
    <message>
        <source>Reading of joint 1, if it slides.</source>
        <translation>关节 1 的读数（移动关节）。</translation>
    </message>
    <message>
        <source>Reading of joint 2, if it slides.</source>
        <translation>关节 2 的读数（移动关节）。</translation>
    </message>
    <message>
        <source>Reading of joint 3, if it slides.</source>
        <translation>关节 3 的读数（移动关节）。</translation>
    </message>
    <message>
        <source>Reading of joint 4, if it slides.</source>
        <translation>关节 4 的读数（移动关节）。</translation>
    </message>
    <message>
        <source>Reading of joint 5, if it slides.</source>
        <translation>关节 5 的读数（移动关节）。</translation>
    </message>
    <message>
        <source>Reading of joint 6, if it slides.</source>
        <translation>关节 6 的读数（移动关节）。</translation>
    </message>
    <message>
        <source>Reading of joint 7, if it slides.</source>
        <translation>关节 7 的读数（移动关节）。</translation>
    </message>
    <message>
        <source>Poses by place</source>
        <translation>由位置给定位姿</translation>
    </message>
    <message>
        <source>Places of the tool in the robot&apos;s base frame; the readings follow by inverse kinematics, within the limits and near those of the pose before.</source>
        <translation>工具在机器人基坐标系中的位置；读数由逆运动学求得，在限位之内并接近前一位姿的读数。</translation>
    </message>
    <message>
        <source>Name, unique.</source>
        <translation>名称，须唯一。</translation>
    </message>
    <message>
        <source>Coordinate x of the tool.</source>
        <translation>工具的坐标 x。</translation>
    </message>
    <message>
        <source>Coordinate y of the tool.</source>
        <translation>工具的坐标 y。</translation>
    </message>
    <message>
        <source>Coordinate z of the tool.</source>
        <translation>工具的坐标 z。</translation>
    </message>
    <message>
        <source>Orientation, R = Rz(gamma) Ry(beta) Rx(alpha); all three empty: any orientation.</source>
        <translation>姿态，R = Rz(gamma) Ry(beta) Rx(alpha)；三者均留空：任意姿态。</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Numbers that state the orientation of the tool; none: the position alone.</source>
        <translation>表示工具姿态的数值；无：仅位置。</translation>
    </message>
    <message>
        <source>none (position alone)</source>
        <translation>无（仅位置）</translation>
    </message>
    <message>
        <source>Results in</source>
        <translation>结果所在坐标系</translation>
    </message>
    <message>
        <source>The frame in which position and orientation are stated.</source>
        <translation>表示位置和姿态的坐标系。</translation>
    </message>
    <message>
        <source>the base frame of the robot</source>
        <translation>机器人的基坐标系</translation>
    </message>
    <message>
        <source>the world frame</source>
        <translation>世界坐标系</translation>
    </message>
    <message>
        <source>Robot by joint trajectories</source>
        <translation>由关节轨迹求机器人</translation>
    </message>
    <message>
        <source>Nominal robot</source>
        <translation>标称机器人</translation>
    </message>
    <message>
        <source>The arm as designed: directions of the frames, definitions of base and last link, and the arm of a simulation.</source>
        <translation>设计的机械臂：各坐标系的方向、基座和末端连杆的定义，以及模拟所用的机械臂。</translation>
    </message>
    <message>
        <source>Points are</source>
        <translation>点的来源</translation>
    </message>
    <message>
        <source>Measured: a table. Simulated: those of the nominal robot, to see what an experiment would give.</source>
        <translation>实测：一个表格。模拟：标称机器人的点，用于查看实验会给出什么。</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>模拟</translation>
    </message>
    <message>
        <source>Points of the ball at the flange in the order in which they were measured, joint by joint, in the frame of the instrument&apos;s world; typed or from a CSV file.</source>
        <translation>法兰上的球的各点，按测量顺序逐关节给出，在仪器的世界坐标系中；手工输入或来自 CSV 文件。</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>Number of the joint that turned.</source>
        <translation>转动关节的编号。</translation>
    </message>
    <message>
        <source>Reading of that joint; says which way round the points run. Empty: with the joint&apos;s positive direction.</source>
        <translation>该关节的读数；表明各点的走向。留空：沿关节的正方向。</translation>
    </message>
    <message>
        <source>Coordinate x.</source>
        <translation>坐标 x。</translation>
    </message>
    <message>
        <source>Coordinate y.</source>
        <translation>坐标 y。</translation>
    </message>
    <message>
        <source>Coordinate z.</source>
        <translation>坐标 z。</translation>
    </message>
    <message>
        <source>Range of each joint, ±</source>
        <translation>各关节的范围，±</translation>
    </message>
    <message>
        <source>Each joint turns from its zero reading less this to its zero reading plus this.</source>
        <translation>每个关节从零位读数减去此值转到零位读数加上此值。</translation>
    </message>
    <message>
        <source>Points for each joint</source>
        <translation>每个关节的点数</translation>
    </message>
    <message>
        <source>Number of points, evenly spaced over the range.</source>
        <translation>点的数目，在范围内均匀分布。</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>球</translation>
    </message>
    <message>
        <source>Where the ball is in the frame of the last link. On the axis of a joint it draws no circle.</source>
        <translation>球在末端连杆坐标系中的位置。若位于关节轴上，则画不出圆。</translation>
    </message>
    <message>
        <source>A standard uncertainty of every coordinate, or an instrument of the project that stands somewhere.</source>
        <translation>每个坐标的标准不确定度，或项目中设于某处的仪器。</translation>
    </message>
    <message>
        <source>typed: alike for all coordinates</source>
        <translation>手工输入：所有坐标相同</translation>
    </message>
    <message>
        <source>an instrument</source>
        <translation>仪器</translation>
    </message>
    <message>
        <source>Standard uncertainty of a coordinate</source>
        <translation>坐标的标准不确定度</translation>
    </message>
    <message>
        <source>Of every coordinate of every point, independent of all others.</source>
        <translation>每个点的每个坐标的标准不确定度，彼此独立。</translation>
    </message>
    <message>
        <source>The distribution of the coordinates&apos; deviations; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation>坐标偏差的分布；无论形状如何，给出的都是其标准不确定度。</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>仪器</translation>
    </message>
    <message>
        <source>What measured the points: each reading deviates by itself, its scale and its station alike for all points.</source>
        <translation>测量这些点的仪器：每个读数各自有偏差，尺度和测站的偏差对所有点相同。</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Plane of a circle</source>
        <translation>圆所在平面</translation>
    </message>
    <message>
        <source>Total least squares fits any plane. Eq 1 of the paper has no plane through the origin and fails near it.</source>
        <translation>总体最小二乘可拟合任意平面。论文式 1 不能表示过原点的平面，在其附近失效。</translation>
    </message>
    <message>
        <source>total least squares</source>
        <translation>总体最小二乘</translation>
    </message>
    <message>
        <source>A x + B y + C z + 1 = 0 (Eq 1)</source>
        <translation>A x + B y + C z + 1 = 0（式 1）</translation>
    </message>
    <message>
        <source>Axes are parallel below</source>
        <translation>轴视为平行的阈值</translation>
    </message>
    <message>
        <source>Angle between two axes below which they are described by beta and not by their common perpendicular, whose place is then hardly determined.</source>
        <translation>两轴夹角小于此值时用 beta 描述，而不用其公垂线，因为此时公垂线的位置几乎无法确定。</translation>
    </message>
    <message>
        <source>Robot from measured poses</source>
        <translation>由实测位姿求机器人</translation>
    </message>
    <message>
        <source>The arm as designed: start of the fit, values of what the poses cannot tell, uncertainty of the readings of its joints, and the arm of a simulation.</source>
        <translation>设计的机械臂：拟合的初值、位姿无法确定的参数值、关节读数的不确定度，以及模拟所用的机械臂。</translation>
    </message>
    <message>
        <source>Poses are</source>
        <translation>位姿的来源</translation>
    </message>
    <message>
        <source>Measured is</source>
        <translation>测量内容</translation>
    </message>
    <message>
        <source>The position of a ball alone, or position and orientation of the tool.</source>
        <translation>仅球的位置，或工具的位置和姿态。</translation>
    </message>
    <message>
        <source>the position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>position and orientation</source>
        <translation>位置和姿态</translation>
    </message>
    <message>
        <source>Measured poses</source>
        <translation>实测位姿</translation>
    </message>
    <message>
        <source>Readings of the joints and the place of the ball or tool that was measured there; typed or from a CSV file.</source>
        <translation>关节读数以及在该处测得的球或工具的位置；手工输入或来自 CSV 文件。</translation>
    </message>
    <message>
        <source>use</source>
        <translation>用途</translation>
    </message>
    <message>
        <source>fit: taken into the fit. check: held back, to see how well the fit tells a pose that it has not seen. Empty: fit.</source>
        <translation>拟合：参与拟合。检核：不参与拟合，用于查看拟合对未见过的位姿预测得如何。留空：拟合。</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>拟合</translation>
    </message>
    <message>
        <source>Reading of joint 1; empty: its zero reading.</source>
        <translation>关节 1 的读数；留空：其零位读数。</translation>
    </message>
    <message>
        <source>Reading of joint 2; empty: its zero reading.</source>
        <translation>关节 2 的读数；留空：其零位读数。</translation>
    </message>
    <message>
        <source>Reading of joint 3; empty: its zero reading.</source>
        <translation>关节 3 的读数；留空：其零位读数。</translation>
    </message>
    <message>
        <source>Reading of joint 4; empty: its zero reading.</source>
        <translation>关节 4 的读数；留空：其零位读数。</translation>
    </message>
    <message>
        <source>Reading of joint 5; empty: its zero reading.</source>
        <translation>关节 5 的读数；留空：其零位读数。</translation>
    </message>
    <message>
        <source>Reading of joint 6; empty: its zero reading.</source>
        <translation>关节 6 的读数；留空：其零位读数。</translation>
    </message>
    <message>
        <source>Reading of joint 7; empty: its zero reading.</source>
        <translation>关节 7 的读数；留空：其零位读数。</translation>
    </message>
    <message>
        <source>Measured coordinate x in the frame of the instrument&apos;s world.</source>
        <translation>在仪器的世界坐标系中的实测坐标 x。</translation>
    </message>
    <message>
        <source>Measured coordinate y in the frame of the instrument&apos;s world.</source>
        <translation>在仪器的世界坐标系中的实测坐标 y。</translation>
    </message>
    <message>
        <source>Measured coordinate z in the frame of the instrument&apos;s world.</source>
        <translation>在仪器的世界坐标系中的实测坐标 z。</translation>
    </message>
    <message>
        <source>Measured orientation, R = Rz(gamma) Ry(beta) Rx(alpha), where poses are measured.</source>
        <translation>测量位姿时的实测姿态，R = Rz(gamma) Ry(beta) Rx(alpha)。</translation>
    </message>
    <message>
        <source>Number of poses</source>
        <translation>位姿数</translation>
    </message>
    <message>
        <source>Poses of the simulated experiment, spread over the range of all joints, always the same.</source>
        <translation>模拟实验的位姿，分布在所有关节的范围内，每次相同。</translation>
    </message>
    <message>
        <source>From the zero reading on, as far as the limits of the joint allow.</source>
        <translation>从零位读数起，直到关节限位允许之处。</translation>
    </message>
    <message>
        <source>Standard uncertainty of an orientation</source>
        <translation>姿态的标准不确定度</translation>
    </message>
    <message>
        <source>Of the rotation of the measured tool about each of its axes, independent.</source>
        <translation>实测工具绕其各轴旋转的标准不确定度，彼此独立。</translation>
    </message>
    <message>
        <source>Ball or tool</source>
        <translation>球或工具</translation>
    </message>
    <message>
        <source>Where it is in the frame of the last link: exactly, or as a start of the fit.</source>
        <translation>它在末端连杆坐标系中的位置：精确值，或拟合的初值。</translation>
    </message>
    <message>
        <source>Place of the ball or tool is</source>
        <translation>球或工具的位置</translation>
    </message>
    <message>
        <source>Found by the fit together with the parameters, or known.</source>
        <translation>与参数一起由拟合求得，或为已知。</translation>
    </message>
    <message>
        <source>found by the fit</source>
        <translation>由拟合求得</translation>
    </message>
    <message>
        <source>known exactly</source>
        <translation>精确已知</translation>
    </message>
    <message>
        <source>Place of the base is</source>
        <translation>基座的位置</translation>
    </message>
    <message>
        <source>Found by the fit: the instrument stands anywhere. Known: the base stands where the robot says it stands in the world.</source>
        <translation>由拟合求得：仪器可设于任意处。已知：基座位于机器人所给出的世界坐标系中的位置。</translation>
    </message>
    <message>
        <source>Parameters held</source>
        <translation>固定的参数</translation>
    </message>
    <message>
        <source>Parameters that stay nominal although the poses could tell them.</source>
        <translation>虽可由位姿确定、但仍保持标称值的参数。</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>A parameter by its symbol, such as d_3 or alpha_4.</source>
        <translation>以符号表示的参数，例如 d_3 或 alpha_4。</translation>
    </message>
    <message>
        <source>Channels of a force/moment sensor</source>
        <translation>力/力矩传感器的通道</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>传感器</translation>
    </message>
    <message>
        <source>The calibrated multi-axis sensor.</source>
        <translation>经校准的多轴传感器。</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>使用</translation>
    </message>
    <message>
        <source>Loads on the other axes</source>
        <translation>其他轴上的载荷</translation>
    </message>
    <message>
        <source>What acts on the other axes while a channel is read. Unknown loads are rectangular between minus and plus the rated load, one and the same for all channels.</source>
        <translation>读取某通道时作用在其他轴上的载荷。未知载荷在负、正额定载荷之间服从矩形分布，对所有通道为同一个量。</translation>
    </message>
    <message>
        <source>none: one component alone</source>
        <translation>无：仅一个分量</translation>
    </message>
    <message>
        <source>unknown on one axis, that with the largest interference</source>
        <translation>一根轴上未知，即干扰最大的轴</translation>
    </message>
    <message>
        <source>unknown on all other axes</source>
        <translation>所有其他轴上均未知</translation>
    </message>
    <message>
        <source>Repeatability</source>
        <translation>重复性</translation>
    </message>
    <message>
        <source>The largest standard deviation of all steps, as in the paper, or that pooled over the steps, which has more degrees of freedom.</source>
        <translation>如论文那样取各级中最大的标准偏差，或取各级的合并标准偏差，后者自由度更大。</translation>
    </message>
    <message>
        <source>largest of the steps</source>
        <translation>各级中最大者</translation>
    </message>
    <message>
        <source>pooled over the steps</source>
        <translation>各级合并</translation>
    </message>
    <message>
        <source>Type A in Monte Carlo</source>
        <translation>蒙特卡洛中的 A 类评定</translation>
    </message>
    <message>
        <source>Normal, with its degrees of freedom in the law of propagation, or a t-distribution (JCGM 101 6.4.9). With n = 3 the latter has no standard deviation: only coverage intervals then mean something.</source>
        <translation>正态分布，其自由度用于传播律；或 t 分布（JCGM 101 6.4.9）。n = 3 时 t 分布没有标准偏差，此时只有包含区间有意义。</translation>
    </message>
    <message>
        <source>scaled and shifted t</source>
        <translation>缩放平移 t 分布</translation>
    </message>
    <message>
        <source>Coverage factor of the comparison</source>
        <translation>比较用的包含因子</translation>
    </message>
    <message>
        <source>k of the GUM&apos;s columns in the table beside the paper&apos;s.</source>
        <translation>表中与论文各列并列的 GUM 各列的 k。</translation>
    </message>
    <message>
        <source>Forces and moments by the calibration matrix</source>
        <translation>由校准矩阵求力和力矩</translation>
    </message>
    <message>
        <source>Cases</source>
        <translation>工况</translation>
    </message>
    <message>
        <source>Cases are given by</source>
        <translation>工况的给定方式</translation>
    </message>
    <message>
        <source>Readings that were taken, or loads whose uncertainty is wanted.</source>
        <translation>已取得的读数，或需求其不确定度的载荷。</translation>
    </message>
    <message>
        <source>readings</source>
        <translation>读数</translation>
    </message>
    <message>
        <source>loads</source>
        <translation>载荷</translation>
    </message>
    <message>
        <source>Net readings of all channels, the unloaded readings subtracted.</source>
        <translation>所有通道的净读数，已减去空载读数。</translation>
    </message>
    <message>
        <source>Names the case in results.</source>
        <translation>在结果中标识该工况。</translation>
    </message>
    <message>
        <source>Fx</source>
        <translation>Fx</translation>
    </message>
    <message>
        <source>Net reading of this channel.</source>
        <translation>该通道的净读数。</translation>
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
        <translation>载荷</translation>
    </message>
    <message>
        <source>Forces and moments that act together; the readings follow from the calibration matrix. An empty cell is zero.</source>
        <translation>同时作用的力和力矩；读数由校准矩阵得到。空单元格为零。</translation>
    </message>
    <message>
        <source>Load on this axis.</source>
        <translation>该轴上的载荷。</translation>
    </message>
    <message>
        <source>Calibration matrix</source>
        <translation>校准矩阵</translation>
    </message>
    <message>
        <source>Least squares through zero over the increasing readings: slopes alone, or with the squares of the loads.</source>
        <translation>对递增读数作过零点的最小二乘：仅斜率，或含载荷的平方项。</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>线性</translation>
    </message>
    <message>
        <source>with quadratic terms</source>
        <translation>含二次项</translation>
    </message>
    <message>
        <source>Repeatability of a reading</source>
        <translation>读数的重复性</translation>
    </message>
    <message>
        <source>The largest standard deviation of all steps, or that pooled over the steps.</source>
        <translation>各级中最大的标准偏差，或各级的合并标准偏差。</translation>
    </message>
    <message>
        <source>Normal, with its degrees of freedom in the law of propagation, or a t-distribution (JCGM 101 6.4.9), which has no standard deviation with n = 3.</source>
        <translation>正态分布，其自由度用于传播律；或 t 分布（JCGM 101 6.4.9），n = 3 时它没有标准偏差。</translation>
    </message>
    <message>
        <source>Hysteresis of a reading</source>
        <translation>读数的滞后</translation>
    </message>
    <message>
        <source>Rectangular over the width of the loop: in proportion to the load on the channel&apos;s axis, or the full width at any load.</source>
        <translation>在滞后回线宽度上的矩形分布：与通道所在轴的载荷成比例，或在任意载荷下取全宽。</translation>
    </message>
    <message>
        <source>in proportion to the load</source>
        <translation>与载荷成比例</translation>
    </message>
    <message>
        <source>full at any load</source>
        <translation>任意载荷下取全宽</translation>
    </message>
    <message>
        <source>Measurement equation</source>
        <translation>测量方程</translation>
    </message>
    <message>
        <source>Equations</source>
        <translation>方程</translation>
    </message>
    <message>
        <source>symbol</source>
        <translation>符号</translation>
    </message>
    <message>
        <source>Name that an equation defines.</source>
        <translation>由方程定义的名称。</translation>
    </message>
    <message>
        <source>What it is, for tables and reports.</source>
        <translation>它是什么，用于表格和报告。</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Unit of the result; empty: the SI unit that follows from the equations.</source>
        <translation>结果的单位；留空：由方程得到的 SI 单位。</translation>
    </message>
    <message>
        <source>Measurands have coverage regions together; empty: measurand.</source>
        <translation>各被测量共同构成包含区域；留空：被测量。</translation>
    </message>
    <message>
        <source>measurand</source>
        <translation>被测量</translation>
    </message>
    <message>
        <source>intermediate</source>
        <translation>中间量</translation>
    </message>
    <message>
        <source>group</source>
        <translation>组</translation>
    </message>
    <message>
        <source>Results of one group have a joint coverage region.</source>
        <translation>同一组的结果具有联合包含区域。</translation>
    </message>
    <message>
        <source>Quantities</source>
        <translation>量</translation>
    </message>
    <message>
        <source>One row for each component of uncertainty. The first row of a symbol has its value and unit; further rows of the same symbol add components and have no value.</source>
        <translation>每个不确定度分量占一行。某符号的第一行给出其值和单位；同一符号的后续行用于增加分量，没有值。</translation>
    </message>
    <message>
        <source>Name that the equations use: x_1, alpha_s.</source>
        <translation>方程所用的名称：x_1、alpha_s。</translation>
    </message>
    <message>
        <source>What it is, or what the component is.</source>
        <translation>它是什么，或该分量是什么。</translation>
    </message>
    <message>
        <source>value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Estimate, in the row&apos;s unit; empty where observations or limits give it.</source>
        <translation>估计值，以该行的单位表示；由观测值或界限给出时留空。</translation>
    </message>
    <message>
        <source>stated as</source>
        <translation>给出方式</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>常量</translation>
    </message>
    <message>
        <source>standard uncertainty</source>
        <translation>标准不确定度</translation>
    </message>
    <message>
        <source>certificate, U and k</source>
        <translation>证书，U 和 k</translation>
    </message>
    <message>
        <source>certificate, U and p</source>
        <translation>证书，U 和 p</translation>
    </message>
    <message>
        <source>rectangular</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>limits from a to b</source>
        <translation>界限 a 至 b</translation>
    </message>
    <message>
        <source>limits inexactly known</source>
        <translation>界限不精确已知</translation>
    </message>
    <message>
        <source>trapezoidal</source>
        <translation>梯形</translation>
    </message>
    <message>
        <source>triangular</source>
        <translation>三角</translation>
    </message>
    <message>
        <source>arc sine</source>
        <translation>反正弦</translation>
    </message>
    <message>
        <source>resolution</source>
        <translation>分辨力</translation>
    </message>
    <message>
        <source>maximum permissible error</source>
        <translation>最大允许误差</translation>
    </message>
    <message>
        <source>exponential</source>
        <translation>指数</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>计数</translation>
    </message>
    <message>
        <source>observations (Type A)</source>
        <translation>观测值（A 类）</translation>
    </message>
    <message>
        <source>pooled observations (Type A)</source>
        <translation>合并观测值（A 类）</translation>
    </message>
    <message>
        <source>reading of an instrument</source>
        <translation>仪器读数</translation>
    </message>
    <message>
        <source>Second figure of the statement.</source>
        <translation>给出内容的第二个数值。</translation>
    </message>
    <message>
        <source>Degrees of freedom; empty: infinite, or those of the observations.</source>
        <translation>自由度；留空：无穷大，或观测值的自由度。</translation>
    </message>
    <message>
        <source>Relative uncertainty of u instead of degrees of freedom (JCGM 100 G.3).</source>
        <translation>以 u 的相对不确定度代替自由度（JCGM 100 G.3）。</translation>
    </message>
    <message>
        <source>source</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Where the figure comes from: certificate, data sheet, handbook.</source>
        <translation>数值的出处：证书、数据表、手册。</translation>
    </message>
    <message>
        <source>instrument</source>
        <translation>仪器</translation>
    </message>
    <message>
        <source>Instrument of the project that reads the quantity, a distance.</source>
        <translation>项目中读取该量（距离）的仪器。</translation>
    </message>
    <message>
        <source>Observations</source>
        <translation>观测值</translation>
    </message>
    <message>
        <source>Repeated observations for Type A evaluations, typed, pasted or from a CSV file. Observations of several quantities with the same numbers were made together: their means are then correlated (JCGM 100 5.2.3).</source>
        <translation>用于 A 类评定的重复观测值，手工输入、粘贴或来自 CSV 文件。若干量中编号相同的观测值是同时取得的：其平均值因而相关（JCGM 100 5.2.3）。</translation>
    </message>
    <message>
        <source>quantity</source>
        <translation>量</translation>
    </message>
    <message>
        <source>Symbol of the quantity.</source>
        <translation>该量的符号。</translation>
    </message>
    <message>
        <source>number</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>Number of the simultaneous observation; empty: the quantity was observed by itself.</source>
        <translation>同时观测的编号；留空：该量为单独观测。</translation>
    </message>
    <message>
        <source>series</source>
        <translation>系列</translation>
    </message>
    <message>
        <source>Name of an earlier series of the same procedure, for a pooled standard deviation.</source>
        <translation>同一程序的先前系列的名称，用于合并标准偏差。</translation>
    </message>
    <message>
        <source>Observed value, in the unit of the quantity.</source>
        <translation>观测值，以该量的单位表示。</translation>
    </message>
    <message>
        <source>Means of observations</source>
        <translation>观测值的平均值</translation>
    </message>
    <message>
        <source>Distribution of a mean in Monte Carlo trials: Student t with the degrees of freedom of the observations (JCGM 101 6.4.9), or normal.</source>
        <translation>平均值在蒙特卡洛试验中的分布：以观测值自由度为自由度的 t 分布（JCGM 101 6.4.9），或正态分布。</translation>
    </message>
    <message>
        <source>Student t</source>
        <translation>t 分布</translation>
    </message>
    <message>
        <source>Calibration curve</source>
        <translation>校准曲线</translation>
    </message>
    <message>
        <source>Unit of x</source>
        <translation>x 的单位</translation>
    </message>
    <message>
        <source>Unit in which x is given. A difference of temperatures, a correction of a thermometer too, is given in K.</source>
        <translation>给出 x 所用的单位。温度差（包括温度计的修正值）以 K 给出。</translation>
    </message>
    <message>
        <source>Unit of y</source>
        <translation>y 的单位</translation>
    </message>
    <message>
        <source>Unit in which y is given. A difference of temperatures, a correction of a thermometer too, is given in K.</source>
        <translation>给出 y 所用的单位。温度差（包括温度计的修正值）以 K 给出。</translation>
    </message>
    <message>
        <source>Points of the calibration, typed, pasted or from a CSV file.</source>
        <translation>校准点，手工输入、粘贴或来自 CSV 文件。</translation>
    </message>
    <message>
        <source>Independent quantity, in its unit.</source>
        <translation>自变量，以其单位表示。</translation>
    </message>
    <message>
        <source>Standard uncertainty of x; empty: none. Used with stated uncertainties.</source>
        <translation>x 的标准不确定度；留空：无。采用给出的不确定度时使用。</translation>
    </message>
    <message>
        <source>Observed quantity, in its unit.</source>
        <translation>观测量，以其单位表示。</translation>
    </message>
    <message>
        <source>Standard uncertainty of y. Used, and needed, with stated uncertainties.</source>
        <translation>y 的标准不确定度。采用给出的不确定度时使用，且必须给出。</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Degree</source>
        <translation>次数</translation>
    </message>
    <message>
        <source>Of the polynomial: 1 is a straight line.</source>
        <translation>多项式的次数：1 为直线。</translation>
    </message>
    <message>
        <source>Origin x_0</source>
        <translation>原点 x_0</translation>
    </message>
    <message>
        <source>The polynomial is one of x - x_0, in the unit of x. In the middle of the points the coefficients are hardly correlated.</source>
        <translation>多项式以 x - x_0 为自变量，以 x 的单位表示。取在各点中部时，各系数几乎不相关。</translation>
    </message>
    <message>
        <source>Through the origin</source>
        <translation>过原点</translation>
    </message>
    <message>
        <source>No constant term: the curve is zero at x_0.</source>
        <translation>无常数项：曲线在 x_0 处为零。</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>不确定度</translation>
    </message>
    <message>
        <source>From the scatter of the residuals about the curve (JCGM 100 H.3), or as stated for each point.</source>
        <translation>由残差围绕曲线的分散性得到（JCGM 100 H.3），或按各点给出的值。</translation>
    </message>
    <message>
        <source>from the residuals</source>
        <translation>由残差得到</translation>
    </message>
    <message>
        <source>as stated for x and y</source>
        <translation>按 x 和 y 给出的值</translation>
    </message>
    <message>
        <source>Use of the curve</source>
        <translation>曲线的使用</translation>
    </message>
    <message>
        <source>Where the value of the curve is wanted, with its uncertainty.</source>
        <translation>需求曲线值及其不确定度之处。</translation>
    </message>
    <message>
        <source>In the unit of x.</source>
        <translation>以 x 的单位表示。</translation>
    </message>
    <message>
        <source>Inverse use</source>
        <translation>反向使用</translation>
    </message>
    <message>
        <source>Observed values of y whose x is wanted, with its uncertainty.</source>
        <translation>需求其 x 及不确定度的 y 观测值。</translation>
    </message>
    <message>
        <source>Observed, in the unit of y.</source>
        <translation>观测值，以 y 的单位表示。</translation>
    </message>
    <message>
        <source>Standard uncertainty of the observed y; empty: none beside that of the readings.</source>
        <translation>所观测 y 的标准不确定度；留空：除读数的不确定度外无其他。</translation>
    </message>
    <message>
        <source>The observed y is the mean of so many readings, which scatter as the points of the calibration do. With the uncertainty from the residuals only.</source>
        <translation>所观测的 y 是这么多次读数的平均值，其分散性与校准点相同。仅用于由残差得到不确定度的情形。</translation>
    </message>
    <message>
        <source>near</source>
        <translation>邻近</translation>
    </message>
    <message>
        <source>Of several x that give this y, the one nearest to here, in the unit of x. Needed where the curve reaches y more than once between its points.</source>
        <translation>给出该 y 的若干 x 中最接近此处的一个，以 x 的单位表示。曲线在各点之间不止一次达到 y 时需要。</translation>
    </message>
    <message>
        <source>Observations in groups</source>
        <translation>分组观测值</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>量</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>符号</translation>
    </message>
    <message>
        <source>Of the measured quantity.</source>
        <translation>被测的量的符号。</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>What is measured.</source>
        <translation>测量的是什么。</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>In which the observations are given.</source>
        <translation>给出观测值所用的单位。</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>Every observation, or mean and standard deviation of each group.</source>
        <translation>每个观测值，或各组的平均值和标准偏差。</translation>
    </message>
    <message>
        <source>observations</source>
        <translation>观测值</translation>
    </message>
    <message>
        <source>means and standard deviations</source>
        <translation>平均值和标准偏差</translation>
    </message>
    <message>
        <source>Observations with the day, instrument or operator they belong to, typed, pasted or from a CSV file.</source>
        <translation>观测值及其所属的日期、仪器或操作者，手工输入、粘贴或来自 CSV 文件。</translation>
    </message>
    <message>
        <source>Day, instrument or operator.</source>
        <translation>日期、仪器或操作者。</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>组</translation>
    </message>
    <message>
        <source>Mean and experimental standard deviation of the observations of each group.</source>
        <translation>各组观测值的平均值和实验标准偏差。</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>平均值</translation>
    </message>
    <message>
        <source>Of the observations of the group, in the unit of the quantity.</source>
        <translation>该组观测值的平均值，以该量的单位表示。</translation>
    </message>
    <message>
        <source>Experimental standard deviation of a single observation of the group.</source>
        <translation>该组单次观测值的实验标准偏差。</translation>
    </message>
    <message>
        <source>Number of observations in the group; empty: observations per group, as below.</source>
        <translation>该组的观测次数；留空：按下面的每组观测次数。</translation>
    </message>
    <message>
        <source>Observations per group</source>
        <translation>每组观测次数</translation>
    </message>
    <message>
        <source>Number of observations in each group whose row does not say it.</source>
        <translation>行中未给出观测次数的各组的观测次数。</translation>
    </message>
    <message>
        <source>Effect of the groups</source>
        <translation>分组效应</translation>
    </message>
    <message>
        <source>Included: u of the mean of the groups&apos; means from their scatter. By components of variance: the same for groups of one size, else groups with more observations have more weight. Not included: all observations count as independent, which the F-test in the evaluation must allow.</source>
        <translation>计入：由各组平均值的分散性得到其平均值的 u。按方差分量：各组大小相同时结果相同，否则观测次数多的组权更大。不计入：所有观测值视为独立，评定中的 F 检验须允许这样做。</translation>
    </message>
    <message>
        <source>included</source>
        <translation>计入</translation>
    </message>
    <message>
        <source>by components of variance</source>
        <translation>按方差分量</translation>
    </message>
    <message>
        <source>not included</source>
        <translation>不计入</translation>
    </message>
    <message>
        <source>Artefact with calibrated points</source>
        <translation>带已校准点的实物标准器</translation>
    </message>
    <message>
        <source>Artefact</source>
        <translation>实物标准器</translation>
    </message>
    <message>
        <source>Calibrated points</source>
        <translation>已校准的点</translation>
    </message>
    <message>
        <source>The artefact&apos;s points with their calibrated coordinates in the artefact&apos;s frame.</source>
        <translation>实物标准器的点及其在实物标准器坐标系中的校准坐标。</translation>
    </message>
    <message>
        <source>Calibrated coordinate x.</source>
        <translation>校准坐标 x。</translation>
    </message>
    <message>
        <source>Calibrated coordinate y.</source>
        <translation>校准坐标 y。</translation>
    </message>
    <message>
        <source>Calibrated coordinate z.</source>
        <translation>校准坐标 z。</translation>
    </message>
    <message>
        <source>defines</source>
        <translation>定义</translation>
    </message>
    <message>
        <source>Coordinates that define the frame (&quot;xyz&quot;, &quot;yz&quot;), when they are named by point.</source>
        <translation>按点指定时，定义坐标系的坐标（&quot;xyz&quot;、&quot;yz&quot;）。</translation>
    </message>
    <message>
        <source>Evaluate from</source>
        <translation>评定依据</translation>
    </message>
    <message>
        <source>Repeated measurements of the artefact, or the components of uncertainty as a report prints them (Table 1 of the paper).</source>
        <translation>对实物标准器的重复测量，或报告中列出的不确定度分量（论文表 1）。</translation>
    </message>
    <message>
        <source>components of uncertainty</source>
        <translation>不确定度分量</translation>
    </message>
    <message>
        <source>Measured coordinates in the artefact&apos;s frame: one row for each point and run, typed or from a CSV file.</source>
        <translation>在实物标准器坐标系中的实测坐标：每个点和测次占一行，手工输入或来自 CSV 文件。</translation>
    </message>
    <message>
        <source>Name of a calibrated point.</source>
        <translation>一个已校准点的名称。</translation>
    </message>
    <message>
        <source>run</source>
        <translation>测次</translation>
    </message>
    <message>
        <source>Indicated coordinate x.</source>
        <translation>示值坐标 x。</translation>
    </message>
    <message>
        <source>Indicated coordinate y.</source>
        <translation>示值坐标 y。</translation>
    </message>
    <message>
        <source>Indicated coordinate z.</source>
        <translation>示值坐标 z。</translation>
    </message>
    <message>
        <source>Components of uncertainty</source>
        <translation>不确定度分量</translation>
    </message>
    <message>
        <source>One row for each coordinate, as Table 1 of the paper prints them.</source>
        <translation>每个坐标占一行，与论文表 1 相同。</translation>
    </message>
    <message>
        <source>coordinate</source>
        <translation>坐标</translation>
    </message>
    <message>
        <source>Coordinate of the row.</source>
        <translation>该行的坐标。</translation>
    </message>
    <message>
        <source>Calibration.</source>
        <translation>校准。</translation>
    </message>
    <message>
        <source>Temperature.</source>
        <translation>温度。</translation>
    </message>
    <message>
        <source>Variability: standard deviation of the errors of indication.</source>
        <translation>变动性：示值误差的标准偏差。</translation>
    </message>
    <message>
        <source>Bias: mean of the errors of indication.</source>
        <translation>偏移：示值误差的平均值。</translation>
    </message>
    <message>
        <source>Number of observations, where it is known; gives the degrees of freedom.</source>
        <translation>观测次数（已知时）；由此得到自由度。</translation>
    </message>
    <message>
        <source>Coordinates that define the frame</source>
        <translation>定义坐标系的坐标</translation>
    </message>
    <message>
        <source>Errors of these coordinates are zero by construction of the frame and are left out of the statistics.</source>
        <translation>按坐标系的构造，这些坐标的误差为零，不参与统计。</translation>
    </message>
    <message>
        <source>first point x, y, z; second y, z; third z</source>
        <translation>第一点 x、y、z；第二点 y、z；第三点 z</translation>
    </message>
    <message>
        <source>as the points&apos; column &apos;defines&apos; says</source>
        <translation>按点的“定义”列</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Systematic error of indication</source>
        <translation>示值的系统误差</translation>
    </message>
    <message>
        <source>What becomes of the mean error b. The paper leaves it uncorrected and counts |b| as a standard uncertainty; JCGM 100 3.2.4 asks for a correction.</source>
        <translation>如何处理平均误差 b。论文不作修正而将 |b| 计为标准不确定度；JCGM 100 3.2.4 要求修正。</translation>
    </message>
    <message>
        <source>counts as a standard uncertainty (paper)</source>
        <translation>计为标准不确定度（论文）</translation>
    </message>
    <message>
        <source>ignored</source>
        <translation>忽略</translation>
    </message>
    <message>
        <source>corrected, the uncertainty of the correction remains</source>
        <translation>已修正，保留修正值的不确定度</translation>
    </message>
    <message>
        <source>Systematic parts are common to all points</source>
        <translation>系统部分对所有点共有</translation>
    </message>
    <message>
        <source>Calibration, temperature and bias are drawn once for all points instead of independently for each, as the paper does.</source>
        <translation>校准、温度和偏移对所有点只抽样一次，而不是如论文那样对每个点独立抽样。</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>校准</translation>
    </message>
    <message>
        <source>Standard uncertainty of calibration</source>
        <translation>校准的标准不确定度</translation>
    </message>
    <message>
        <source>Largest standard uncertainty of the calibrated values, from the certificate (U divided by its k).</source>
        <translation>校准值的最大标准不确定度，取自证书（U 除以其 k）。</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>Coefficient of thermal expansion</source>
        <translation>热膨胀系数</translation>
    </message>
    <message>
        <source>Linear expansion of the artefact&apos;s material; aluminium has about 23e-6 1/K.</source>
        <translation>实物标准器材料的线膨胀系数；铝约为 23e-6 1/K。</translation>
    </message>
    <message>
        <source>Temperature of the artefact</source>
        <translation>实物标准器的温度</translation>
    </message>
    <message>
        <source>Whether indications are corrected to 20 °C with a measured temperature. If not, the largest deviation from 20 °C is a component of uncertainty.</source>
        <translation>示值是否用实测温度修正到 20 °C。若不修正，与 20 °C 的最大偏差为一个不确定度分量。</translation>
    </message>
    <message>
        <source>not corrected</source>
        <translation>未修正</translation>
    </message>
    <message>
        <source>corrected to 20 °C</source>
        <translation>修正到 20 °C</translation>
    </message>
    <message>
        <source>Largest deviation from 20 °C, or U of the temperature</source>
        <translation>与 20 °C 的最大偏差，或温度的 U</translation>
    </message>
    <message>
        <source>ΔT of Eqs 3 and 6: without correction the largest absolute deviation from 20 °C, with correction the expanded uncertainty of the measured temperature. Half-width of a rectangular distribution.</source>
        <translation>式 3 和 6 中的 ΔT：未修正时为与 20 °C 的最大绝对偏差，修正时为实测温度的扩展不确定度。矩形分布的半宽。</translation>
    </message>
    <message>
        <source>Measured temperature</source>
        <translation>实测温度</translation>
    </message>
    <message>
        <source>Temperature of the artefact during the measurement; indications are divided by 1 + α (T − 20 °C).</source>
        <translation>测量期间实物标准器的温度；示值除以 1 + α (T − 20 °C)。</translation>
    </message>
    <message>
        <source>Length for the thermal expansion</source>
        <translation>热膨胀所用长度</translation>
    </message>
    <message>
        <source>L_max of Eq 3. The paper&apos;s figures result with the largest distance between two points; its text says the largest value of the coordinate, which gives 0 for a flat artefact&apos;s z.</source>
        <translation>式 3 中的 L_max。论文的数值由两点间的最大距离得到；其正文却称取坐标的最大值，这对平面型实物标准器的 z 给出 0。</translation>
    </message>
    <message>
        <source>largest distance between two points</source>
        <translation>两点间的最大距离</translation>
    </message>
    <message>
        <source>largest value of the coordinate (text of Eq 3)</source>
        <translation>坐标的最大值（式 3 正文）</translation>
    </message>
    <message>
        <source>Length standard</source>
        <translation>长度标准器</translation>
    </message>
    <message>
        <source>Calibrated length</source>
        <translation>已校准长度</translation>
    </message>
    <message>
        <source>Distance between the two nests, from the certificate. It should be like the largest distance between the points of both frames.</source>
        <translation>两个靶座之间的距离，取自证书。它应与两个坐标系各点间的最大距离相近。</translation>
    </message>
    <message>
        <source>Repeated measurements of the artefact, or the components of uncertainty as a report prints them (Table 2 of the paper).</source>
        <translation>对实物标准器的重复测量，或报告中列出的不确定度分量（论文表 2）。</translation>
    </message>
    <message>
        <source>Measured lengths: one row for each position and run, typed or from a CSV file. The paper proposes at least 14 positions of three runs.</source>
        <translation>实测长度：每个位置和测次占一行，手工输入或来自 CSV 文件。论文建议至少 14 个位置，每个位置三个测次。</translation>
    </message>
    <message>
        <source>position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Where the standard stood.</source>
        <translation>标准器所在的位置。</translation>
    </message>
    <message>
        <source>Indicated length.</source>
        <translation>示值长度。</translation>
    </message>
    <message>
        <source>One row, as Table 2 of the paper prints it.</source>
        <translation>一行，与论文表 2 相同。</translation>
    </message>
    <message>
        <source>Uncertainty of a coordinate</source>
        <translation>坐标的不确定度</translation>
    </message>
    <message>
        <source>A length is the difference of two points, so u of a length is √2 times u of a coordinate. The paper uses the length&apos;s figure unchanged, which is cautious.</source>
        <translation>长度是两点之差，因此长度的 u 为坐标的 u 的 √2 倍。论文直接采用长度的数值，偏于保守。</translation>
    </message>
    <message>
        <source>that of the length (paper)</source>
        <translation>取长度的值（论文）</translation>
    </message>
    <message>
        <source>that of the length divided by √2</source>
        <translation>取长度的值除以 √2</translation>
    </message>
    <message>
        <source>Tracker, total station, camera or distance meter</source>
        <translation>跟踪仪、全站仪、相机或测距仪</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>测站</translation>
    </message>
    <message>
        <source>Where the instrument stands in the world frame: the point where its axes meet. x is the zero of the azimuth (the optical axis of a camera), z the vertical axis.</source>
        <translation>仪器在世界坐标系中的位置：其各轴的交点。x 为方位角的零方向（相机的光轴），z 为竖轴。</translation>
    </message>
    <message>
        <source>The angles are</source>
        <translation>角度的定义</translation>
    </message>
    <message>
        <source>How the three angles of the station turn its axes.</source>
        <translation>测站的三个角度如何转动其各轴。</translation>
    </message>
    <message>
        <source>α, β, γ: R = Rz(γ) Ry(β) Rx(α)</source>
        <translation>α、β、γ：R = Rz(γ) Ry(β) Rx(α)</translation>
    </message>
    <message>
        <source>ω, φ, κ: R = Rx(ω) Ry(φ) Rz(κ), photogrammetric</source>
        <translation>ω、φ、κ：R = Rx(ω) Ry(φ) Rz(κ)，摄影测量</translation>
    </message>
    <message>
        <source>What the instrument reads, and how it is drawn.</source>
        <translation>仪器读取什么，以及如何绘制。</translation>
    </message>
    <message>
        <source>total station: distance and two angles</source>
        <translation>全站仪：距离和两个角度</translation>
    </message>
    <message>
        <source>laser tracker: distance and two angles</source>
        <translation>激光跟踪仪：距离和两个角度</translation>
    </message>
    <message>
        <source>laser scanner: distance and two angles</source>
        <translation>激光扫描仪：距离和两个角度</translation>
    </message>
    <message>
        <source>camera: two angles</source>
        <translation>相机：两个角度</translation>
    </message>
    <message>
        <source>distance meter: distance only</source>
        <translation>测距仪：仅距离</translation>
    </message>
    <message>
        <source>other: chosen readings</source>
        <translation>其他：选定的读数</translation>
    </message>
    <message>
        <source>Reads the distance</source>
        <translation>读取距离</translation>
    </message>
    <message>
        <source>Whether the sensor reads a distance.</source>
        <translation>传感器是否读取距离。</translation>
    </message>
    <message>
        <source>Reads the azimuth</source>
        <translation>读取方位角</translation>
    </message>
    <message>
        <source>Whether the sensor reads a horizontal angle.</source>
        <translation>传感器是否读取水平角。</translation>
    </message>
    <message>
        <source>Reads the elevation</source>
        <translation>读取俯仰角</translation>
    </message>
    <message>
        <source>Whether the sensor reads a vertical angle.</source>
        <translation>传感器是否读取垂直角。</translation>
    </message>
    <message>
        <source>Specification</source>
        <translation>技术指标</translation>
    </message>
    <message>
        <source>Distance: constant part a</source>
        <translation>距离：固定部分 a</translation>
    </message>
    <message>
        <source>Part of the distance&apos;s figure that does not depend on the distance.</source>
        <translation>距离指标中与距离无关的部分。</translation>
    </message>
    <message>
        <source>Distance: part b per length</source>
        <translation>距离：单位长度部分 b</translation>
    </message>
    <message>
        <source>Part of the distance&apos;s figure in proportion to the distance.</source>
        <translation>距离指标中与距离成比例的部分。</translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation>方位角</translation>
    </message>
    <message>
        <source>Figure for the horizontal angle.</source>
        <translation>水平角的指标。</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>俯仰角</translation>
    </message>
    <message>
        <source>Figure for the vertical angle.</source>
        <translation>垂直角的指标。</translation>
    </message>
    <message>
        <source>Angles: constant part across</source>
        <translation>角度：横向固定部分</translation>
    </message>
    <message>
        <source>Part of both angles&apos; figures that is a length across the line of sight, as trackers state it (15 µm + 6 µm/m); an angle&apos;s figure is this over the distance plus its own.</source>
        <translation>两个角度的指标中表示为垂直于视线的长度的部分，如跟踪仪的给法（15 µm + 6 µm/m）；角度的指标为该值除以距离再加上角度自身的指标。</translation>
    </message>
    <message>
        <source>The figures are</source>
        <translation>指标的含义</translation>
    </message>
    <message>
        <source>What the data sheet states: a standard uncertainty, an expanded one, or a limit that is not exceeded (maximum permissible error).</source>
        <translation>数据表给出的是：标准不确定度、扩展不确定度，或不超过的界限（最大允许误差）。</translation>
    </message>
    <message>
        <source>standard uncertainty (normal)</source>
        <translation>标准不确定度（正态）</translation>
    </message>
    <message>
        <source>expanded uncertainty, k = 2 (normal)</source>
        <translation>扩展不确定度，k = 2（正态）</translation>
    </message>
    <message>
        <source>limit (MPE), rectangular: divided by √3</source>
        <translation>界限（MPE），矩形：除以 √3</translation>
    </message>
    <message>
        <source>limit (MPE), triangular: divided by √6</source>
        <translation>界限（MPE），三角：除以 √6</translation>
    </message>
    <message>
        <source>limit (MPE), arc sine: divided by √2</source>
        <translation>界限（MPE），反正弦：除以 √2</translation>
    </message>
    <message>
        <source>Range and field of view</source>
        <translation>测程和视场</translation>
    </message>
    <message>
        <source>Shortest distance</source>
        <translation>最短距离</translation>
    </message>
    <message>
        <source>Targets nearer than this are not measured.</source>
        <translation>比此更近的目标点不测量。</translation>
    </message>
    <message>
        <source>Longest distance</source>
        <translation>最长距离</translation>
    </message>
    <message>
        <source>Targets farther than this are not measured; empty: no limit.</source>
        <translation>比此更远的目标点不测量；留空：无限制。</translation>
    </message>
    <message>
        <source>Horizontal field of view</source>
        <translation>水平视场</translation>
    </message>
    <message>
        <source>Full angle, half of it to either side of the sensor&apos;s x-axis; empty: all round.</source>
        <translation>全角，传感器 x 轴两侧各一半；留空：全周。</translation>
    </message>
    <message>
        <source>Vertical field of view</source>
        <translation>垂直视场</translation>
    </message>
    <message>
        <source>Full angle, half of it above the sensor&apos;s xy-plane and half below; empty: no limit.</source>
        <translation>全角，传感器 xy 平面上下各一半；留空：无限制。</translation>
    </message>
    <message>
        <source>Shared by all readings</source>
        <translation>所有读数共有</translation>
    </message>
    <message>
        <source>Scale of distances</source>
        <translation>距离的比例误差</translation>
    </message>
    <message>
        <source>Standard uncertainty of the scale, which all distances share: wavelength, refractive index, temperature of a scale.</source>
        <translation>所有距离共有的尺度的标准不确定度：波长、折射率、标尺温度。</translation>
    </message>
    <message>
        <source>Zero offset of distances</source>
        <translation>距离的零点偏移</translation>
    </message>
    <message>
        <source>Standard uncertainty of the constant offset of all distances: home position, reflector.</source>
        <translation>所有距离的固定偏移的标准不确定度：零位（home）位置、反射器。</translation>
    </message>
    <message>
        <source>Index of the elevation</source>
        <translation>竖盘指标差</translation>
    </message>
    <message>
        <source>Standard uncertainty of the zero of the vertical circle.</source>
        <translation>竖盘零位的标准不确定度。</translation>
    </message>
    <message>
        <source>Collimation</source>
        <translation>视准差</translation>
    </message>
    <message>
        <source>Standard uncertainty of the angle between beam and tilting axis off square: the azimuth changes by it over the cosine of the elevation.</source>
        <translation>光束与横轴之间夹角偏离直角的标准不确定度：方位角的变化为该值除以俯仰角的余弦。</translation>
    </message>
    <message>
        <source>Squareness of the axes</source>
        <translation>轴系垂直度</translation>
    </message>
    <message>
        <source>Standard uncertainty of the angle between the two axes off square: the azimuth changes by it times the tangent of the elevation.</source>
        <translation>两轴之间夹角偏离直角的标准不确定度：方位角的变化为该值乘以俯仰角的正切。</translation>
    </message>
    <message>
        <source>Offset of the beam</source>
        <translation>光束偏移</translation>
    </message>
    <message>
        <source>Standard uncertainty of the distance by which the beam misses the vertical axis sideways: the azimuth changes by it over the horizontal distance.</source>
        <translation>光束侧向偏离竖轴的距离的标准不确定度：方位角的变化为该值除以水平距离。</translation>
    </message>
    <message>
        <source>Coefficient of refraction</source>
        <translation>折光系数</translation>
    </message>
    <message>
        <source>Standard uncertainty of k: the elevation changes by k L/(2 × 6371 km) over a distance L.</source>
        <translation>k 的标准不确定度：在距离 L 上俯仰角的变化为 k L/(2 × 6371 km)。</translation>
    </message>
    <message>
        <source>The distribution of what all readings share; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation>所有读数共有的各量的分布；无论形状如何，给出的都是其标准不确定度。</translation>
    </message>
    <message>
        <source>Uncertainty of the station</source>
        <translation>测站的不确定度</translation>
    </message>
    <message>
        <source>position x</source>
        <translation>位置 x</translation>
    </message>
    <message>
        <source>Standard uncertainty of this coordinate of the station, shared by everything measured from it.</source>
        <translation>测站该坐标的标准不确定度，由该站所测的一切共有。</translation>
    </message>
    <message>
        <source>position y</source>
        <translation>位置 y</translation>
    </message>
    <message>
        <source>position z</source>
        <translation>位置 z</translation>
    </message>
    <message>
        <source>rotation about x</source>
        <translation>绕 x 的旋转</translation>
    </message>
    <message>
        <source>rotation about y</source>
        <translation>绕 y 的旋转</translation>
    </message>
    <message>
        <source>rotation about z</source>
        <translation>绕 z 的旋转</translation>
    </message>
    <message>
        <source>The distribution of the coordinates of the station; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation>测站坐标的分布；无论形状如何，给出的都是其标准不确定度。</translation>
    </message>
    <message>
        <source>Correlation of the station&apos;s coordinates</source>
        <translation>测站坐标的相关性</translation>
    </message>
    <message>
        <source>Correlation coefficients from the adjustment that located the station; pairs left out are uncorrelated.</source>
        <translation>由确定测站位置的平差得到的相关系数；未列出的对视为不相关。</translation>
    </message>
    <message>
        <source>first</source>
        <translation>第一</translation>
    </message>
    <message>
        <source>A coordinate of the station.</source>
        <translation>测站的一个坐标。</translation>
    </message>
    <message>
        <source>second</source>
        <translation>第二</translation>
    </message>
    <message>
        <source>Correlation coefficient.</source>
        <translation>相关系数。</translation>
    </message>
    <message>
        <source>Network of sensors</source>
        <translation>传感器网络</translation>
    </message>
    <message>
        <source>What the weights of the readings account for. With the stations, all points of one analysis are estimated together.</source>
        <translation>读数的权考虑哪些因素。计入测站时，一个分析中的所有点同时估计。</translation>
    </message>
    <message>
        <source>readings and stations, all points at once</source>
        <translation>读数和测站，所有点同时估计</translation>
    </message>
    <message>
        <source>readings alone, each point by itself</source>
        <translation>仅读数，每个点单独估计</translation>
    </message>
    <message>
        <source>Specification of a measured point</source>
        <translation>实测点技术指标</translation>
    </message>
    <message>
        <source>Figure of the data sheet</source>
        <translation>数据表的指标</translation>
    </message>
    <message>
        <source>The uncertainty or limit that the manufacturer states, the same for x, y and z.</source>
        <translation>制造商给出的不确定度或界限，对 x、y 和 z 相同。</translation>
    </message>
    <message>
        <source>The figure applies to</source>
        <translation>指标的适用对象</translation>
    </message>
    <message>
        <source>A coordinate of a point, or a length between two points; a length is the difference of two points, so a coordinate has 1/√2 of it.</source>
        <translation>点的坐标，或两点间的长度；长度是两点之差，因此坐标为其 1/√2。</translation>
    </message>
    <message>
        <source>a coordinate</source>
        <translation>坐标</translation>
    </message>
    <message>
        <source>a length between two points</source>
        <translation>两点间的长度</translation>
    </message>
    <message>
        <source>Telescopic ballbars (multilateration)</source>
        <translation>伸缩式球杆仪（多边测量）</translation>
    </message>
    <message>
        <source>Supports</source>
        <translation>支座</translation>
    </message>
    <message>
        <source>Support 1 to support 2</source>
        <translation>支座 1 至支座 2</translation>
    </message>
    <message>
        <source>Measured length between supports 1 and 2.</source>
        <translation>支座 1 与 2 之间的实测长度。</translation>
    </message>
    <message>
        <source>Support 1 to support 3</source>
        <translation>支座 1 至支座 3</translation>
    </message>
    <message>
        <source>Measured length between supports 1 and 3.</source>
        <translation>支座 1 与 3 之间的实测长度。</translation>
    </message>
    <message>
        <source>Support 2 to support 3</source>
        <translation>支座 2 至支座 3</translation>
    </message>
    <message>
        <source>Measured length between supports 2 and 3.</source>
        <translation>支座 2 与 3 之间的实测长度。</translation>
    </message>
    <message>
        <source>Further supports</source>
        <translation>其他支座</translation>
    </message>
    <message>
        <source>Supports 4, 5 ...: their lengths to the first three, and their height above the plane of these. More than three lengths are adjusted by least squares.</source>
        <translation>支座 4、5 …：它们到前三个支座的长度，以及高出前三者所在平面的高度。多于三个长度时用最小二乘平差。</translation>
    </message>
    <message>
        <source>Length to this support.</source>
        <translation>到该支座的长度。</translation>
    </message>
    <message>
        <source>Height above the first three supports.</source>
        <translation>高出前三个支座的高度。</translation>
    </message>
    <message>
        <source>Standard uncertainty of the height.</source>
        <translation>高度的标准不确定度。</translation>
    </message>
    <message>
        <source>The ball is</source>
        <translation>球所在侧</translation>
    </message>
    <message>
        <source>Three lengths meet in two points, mirror images in the plane of the supports: on which side of it the ball is (sign of the root of Eq 3).</source>
        <translation>三个长度交于两点，关于支座平面互为镜像：球位于平面的哪一侧（式 3 中根号的符号）。</translation>
    </message>
    <message>
        <source>on the side of +z</source>
        <translation>在 +z 侧</translation>
    </message>
    <message>
        <source>on the side of −z</source>
        <translation>在 −z 侧</translation>
    </message>
    <message>
        <source>Placement</source>
        <translation>安放</translation>
    </message>
    <message>
        <source>Place in the robot&apos;s frame</source>
        <translation>在机器人坐标系中的位置</translation>
    </message>
    <message>
        <source>Where the instrument&apos;s frame is in the robot&apos;s: origin in support 1, x towards support 2, z normal to the plane of the first three supports, on the left of the way 1-2-3.</source>
        <translation>仪器坐标系在机器人坐标系中的位置：原点在支座 1，x 指向支座 2，z 垂直于前三个支座的平面，在 1-2-3 行进方向的左侧。</translation>
    </message>
    <message>
        <source>Uncertainty of a length</source>
        <translation>长度的不确定度</translation>
    </message>
    <message>
        <source>To the ball: constant part a</source>
        <translation>至球：固定部分 a</translation>
    </message>
    <message>
        <source>Figure for one reading of a bar to the ball, the part that does not depend on the length.</source>
        <translation>球杆仪对球的单次读数的指标，与长度无关的部分。</translation>
    </message>
    <message>
        <source>To the ball: part b per length</source>
        <translation>至球：单位长度部分 b</translation>
    </message>
    <message>
        <source>Figure for one reading of a bar to the ball, the part in proportion to the length.</source>
        <translation>球杆仪对球的单次读数的指标，与长度成比例的部分。</translation>
    </message>
    <message>
        <source>Between supports: constant part a</source>
        <translation>支座之间：固定部分 a</translation>
    </message>
    <message>
        <source>Figure for a length between two supports, which one measurement gives for all points: the part that does not depend on the length.</source>
        <translation>两支座间长度的指标，由一次测量给出并用于所有点：与长度无关的部分。</translation>
    </message>
    <message>
        <source>Between supports: part b per length</source>
        <translation>支座之间：单位长度部分 b</translation>
    </message>
    <message>
        <source>Figure for a length between two supports, the part in proportion to the length.</source>
        <translation>两支座间长度的指标，与长度成比例的部分。</translation>
    </message>
    <message>
        <source>Shared by all lengths</source>
        <translation>所有长度共有</translation>
    </message>
    <message>
        <source>Scale of all lengths</source>
        <translation>所有长度的比例误差</translation>
    </message>
    <message>
        <source>Standard uncertainty of the scale that all lengths share: wavelength, refractive index.</source>
        <translation>所有长度共有的尺度的标准不确定度：波长、折射率。</translation>
    </message>
    <message>
        <source>Constant of each bar</source>
        <translation>各球杆仪的常数</translation>
    </message>
    <message>
        <source>Standard uncertainty of the constant of a bar, the same in all its readings to the ball.</source>
        <translation>球杆仪常数的标准不确定度，在其对球的所有读数中相同。</translation>
    </message>
    <message>
        <source>The distribution of scale and constants; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation>尺度和常数的分布；无论形状如何，给出的都是其标准不确定度。</translation>
    </message>
    <message>
        <source>Robot: repeatability of a pose</source>
        <translation>机器人：位姿重复性</translation>
    </message>
    <message>
        <source>Positioning</source>
        <translation>定位</translation>
    </message>
    <message>
        <source>The robot&apos;s figure for the scatter of a position that it is sent to again and again.</source>
        <translation>机器人反复到达同一位置时分散性的指标。</translation>
    </message>
    <message>
        <source>The figure is</source>
        <translation>指标的含义</translation>
    </message>
    <message>
        <source>A largest distance from the mean position, or RP of ISO 9283: the mean distance plus three times its standard deviation. A normal law has no largest distance, so its figure is always RP.</source>
        <translation>到平均位置的最大距离，或 ISO 9283 的 RP：平均距离加三倍其标准偏差。正态分布没有最大距离，因此其指标总是 RP。</translation>
    </message>
    <message>
        <source>the largest distance r</source>
        <translation>最大距离 r</translation>
    </message>
    <message>
        <source>RP of ISO 9283: mean + 3 s</source>
        <translation>ISO 9283 的 RP：平均值 + 3 s</translation>
    </message>
    <message>
        <source>Deviation of a position</source>
        <translation>位置偏差</translation>
    </message>
    <message>
        <source>How the distance from the mean position is distributed; all directions are equally probable.</source>
        <translation>到平均位置的距离如何分布；所有方向等概率。</translation>
    </message>
    <message>
        <source>rectangular in [0, r] in a random direction</source>
        <translation>在 [0, r] 内矩形分布，方向随机</translation>
    </message>
    <message>
        <source>anywhere in a ball of radius r</source>
        <translation>在半径为 r 的球内任意处</translation>
    </message>
    <message>
        <source>always r, in a random direction</source>
        <translation>恒为 r，方向随机</translation>
    </message>
    <message>
        <source>normal along each axis</source>
        <translation>沿各轴正态</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>姿态</translation>
    </message>
    <message>
        <source>Figure for the scatter of the orientation about each axis of the flange; 0: none.</source>
        <translation>绕法兰各轴的姿态分散性的指标；0：无。</translation>
    </message>
    <message>
        <source>The angle is</source>
        <translation>角度的含义</translation>
    </message>
    <message>
        <source>A standard uncertainty, RP of ISO 9283 for an angle (three times its standard deviation), or a limit that is not exceeded.</source>
        <translation>标准不确定度、ISO 9283 的角度 RP（三倍其标准偏差），或不超过的界限。</translation>
    </message>
    <message>
        <source>RP of ISO 9283: ± 3 s (normal)</source>
        <translation>ISO 9283 的 RP：± 3 s（正态）</translation>
    </message>
    <message>
        <source>limit, rectangular: divided by √3</source>
        <translation>界限，矩形：除以 √3</translation>
    </message>
    <message>
        <source>Serial robot</source>
        <translation>串联机器人</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>几何</translation>
    </message>
    <message>
        <source>Convention</source>
        <translation>约定</translation>
    </message>
    <message>
        <source>How the parameters of a row lead from one joint&apos;s frame to the next.</source>
        <translation>一行参数如何从一个关节的坐标系导出下一个关节的坐标系。</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>关节</translation>
    </message>
    <message>
        <source>One row for each joint from the base to the tool, in the chosen convention.</source>
        <translation>从基座到工具每个关节占一行，按所选约定。</translation>
    </message>
    <message>
        <source>Joint angle where the reading is the zero reading.</source>
        <translation>读数为零位读数时的关节角。</translation>
    </message>
    <message>
        <source>Offset along the joint&apos;s axis.</source>
        <translation>沿关节轴的偏距。</translation>
    </message>
    <message>
        <source>Length of the common perpendicular.</source>
        <translation>公垂线的长度。</translation>
    </message>
    <message>
        <source>Twist about x between two axes.</source>
        <translation>两轴之间绕 x 的扭角。</translation>
    </message>
    <message>
        <source>Twist about y, of a joint whose axis is parallel to the next: d is then 0 by definition. Empty: the axes are not parallel.</source>
        <translation>绕 y 的扭角，用于轴与下一关节平行的关节：此时 d 按定义为 0。留空：两轴不平行。</translation>
    </message>
    <message>
        <source>Reading of the joint at which theta holds; empty: 0.</source>
        <translation>theta 成立时的关节读数；留空：0。</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Whether the joint angle grows or falls with the reading; empty: grows.</source>
        <translation>关节角随读数增大还是减小；留空：增大。</translation>
    </message>
    <message>
        <source>with the reading</source>
        <translation>与读数同向</translation>
    </message>
    <message>
        <source>against the reading</source>
        <translation>与读数反向</translation>
    </message>
    <message>
        <source>Lowest reading; empty: no limit.</source>
        <translation>最小读数；留空：无限制。</translation>
    </message>
    <message>
        <source>Highest reading; empty: no limit.</source>
        <translation>最大读数；留空：无限制。</translation>
    </message>
    <message>
        <source>Standard uncertainty of a reading by the joint&apos;s encoder, drawn anew at each pose.</source>
        <translation>关节编码器读数的标准不确定度，在每个位姿重新抽样。</translation>
    </message>
    <message>
        <source>Standard uncertainty by which the joint comes back to a reading, drawn anew at each pose.</source>
        <translation>关节回到同一读数的标准不确定度，在每个位姿重新抽样。</translation>
    </message>
    <message>
        <source>type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>A joint that turns has readings q, which add to theta; one that slides has readings s, which add to d. Empty: it turns.</source>
        <translation>转动关节的读数为 q，加到 theta 上；移动关节的读数为 s，加到 d 上。留空：转动。</translation>
    </message>
    <message>
        <source>turns about its axis</source>
        <translation>绕其轴转动</translation>
    </message>
    <message>
        <source>slides along its axis</source>
        <translation>沿其轴移动</translation>
    </message>
    <message>
        <source>Reading of a sliding joint at which d holds; empty: 0.</source>
        <translation>d 成立时的移动关节读数；留空：0。</translation>
    </message>
    <message>
        <source>Lowest reading of a sliding joint; empty: no limit.</source>
        <translation>移动关节的最小读数；留空：无限制。</translation>
    </message>
    <message>
        <source>Highest reading of a sliding joint; empty: no limit.</source>
        <translation>移动关节的最大读数；留空：无限制。</translation>
    </message>
    <message>
        <source>Standard uncertainty of a reading of a sliding joint by its scale, drawn anew at each pose.</source>
        <translation>移动关节标尺读数的标准不确定度，在每个位姿重新抽样。</translation>
    </message>
    <message>
        <source>Standard uncertainty by which a sliding joint comes back to a reading, drawn anew at each pose.</source>
        <translation>移动关节回到同一读数的标准不确定度，在每个位姿重新抽样。</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>基座</translation>
    </message>
    <message>
        <source>Where frame 0 of the robot stands in the world.</source>
        <translation>机器人的坐标系 0 在世界坐标系中的位置。</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>Where the tool is in the frame of the last link.</source>
        <translation>工具在末端连杆坐标系中的位置。</translation>
    </message>
    <message>
        <source>Standard uncertainties of the parameters by source. A row for a joint and a source; components of one parameter combine in quadrature.</source>
        <translation>按来源给出的参数标准不确定度。每个关节和来源占一行；同一参数的各分量按方和根合成。</translation>
    </message>
    <message>
        <source>Where the figures come from: repeatability, sampling, range, certificate ...</source>
        <translation>数值的出处：重复性、采样、范围、证书等。</translation>
    </message>
    <message>
        <source>Number of the joint; empty: all joints, each with a deviation of its own.</source>
        <translation>关节的编号；留空：所有关节，各有自己的偏差。</translation>
    </message>
    <message>
        <source>Standard uncertainty of theta from this source; empty: none.</source>
        <translation>来自该来源的 theta 的标准不确定度；留空：无。</translation>
    </message>
    <message>
        <source>Standard uncertainty of d from this source; empty: none.</source>
        <translation>来自该来源的 d 的标准不确定度；留空：无。</translation>
    </message>
    <message>
        <source>Standard uncertainty of a from this source; empty: none.</source>
        <translation>来自该来源的 a 的标准不确定度；留空：无。</translation>
    </message>
    <message>
        <source>Standard uncertainty of alpha from this source; empty: none.</source>
        <translation>来自该来源的 alpha 的标准不确定度；留空：无。</translation>
    </message>
    <message>
        <source>Standard uncertainty of beta from this source; empty: none.</source>
        <translation>来自该来源的 beta 的标准不确定度；留空：无。</translation>
    </message>
    <message>
        <source>Degrees of freedom of the figures; empty: infinitely many.</source>
        <translation>各数值的自由度；留空：无穷大。</translation>
    </message>
    <message>
        <source>Form of the distribution with this standard uncertainty; empty: normal.</source>
        <translation>具有该标准不确定度的分布的形式；留空：正态。</translation>
    </message>
    <message>
        <source>Correlation coefficients from the identification; pairs left out are uncorrelated. A correlated parameter has one component.</source>
        <translation>由辨识得到的相关系数；未列出的对视为不相关。相关的参数只有一个分量。</translation>
    </message>
    <message>
        <source>Tool, position</source>
        <translation>工具，位置</translation>
    </message>
    <message>
        <source>Standard uncertainty of each coordinate of the tool in the frame of the last link.</source>
        <translation>工具在末端连杆坐标系中各坐标的标准不确定度。</translation>
    </message>
    <message>
        <source>Tool, orientation</source>
        <translation>工具，姿态</translation>
    </message>
    <message>
        <source>Standard uncertainty of each rotation of the tool about its own axes.</source>
        <translation>工具绕其自身各轴旋转的标准不确定度。</translation>
    </message>
    <message>
        <source>Force/moment calibration machine</source>
        <translation>力/力矩校准机</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>证书</translation>
    </message>
    <message>
        <source>Uncertainty of its loads</source>
        <translation>其载荷的不确定度</translation>
    </message>
    <message>
        <source>One row for each axis that the machine loads: the relative expanded uncertainty of its certificate and the coverage factor.</source>
        <translation>校准机加载的每根轴占一行：其证书的相对扩展不确定度和包含因子。</translation>
    </message>
    <message>
        <source>Force or moment.</source>
        <translation>力或力矩。</translation>
    </message>
    <message>
        <source>Relative expanded uncertainty of the load: a ratio, not %.</source>
        <translation>载荷的相对扩展不确定度：比值，不是 %。</translation>
    </message>
    <message>
        <source>Coverage factor; empty: 2.</source>
        <translation>包含因子；留空：2。</translation>
    </message>
    <message>
        <source>Multi-axis force/moment sensor</source>
        <translation>多轴力/力矩传感器</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>通道</translation>
    </message>
    <message>
        <source>The forces and moments that the sensor measures, with their rated loads.</source>
        <translation>传感器测量的力和力矩及其额定载荷。</translation>
    </message>
    <message>
        <source>Force or moment that the channel measures.</source>
        <translation>该通道测量的力或力矩。</translation>
    </message>
    <message>
        <source>rated force</source>
        <translation>额定力</translation>
    </message>
    <message>
        <source>Rated load of Fx, Fy or Fz.</source>
        <translation>Fx、Fy 或 Fz 的额定载荷。</translation>
    </message>
    <message>
        <source>rated moment</source>
        <translation>额定力矩</translation>
    </message>
    <message>
        <source>Rated load of Mx, My or Mz.</source>
        <translation>Mx、My 或 Mz 的额定载荷。</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Where the sensor&apos;s axes are; loads are along and about them.</source>
        <translation>传感器各轴所在处；载荷沿这些轴和绕这些轴作用。</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>直径</translation>
    </message>
    <message>
        <source>Of its housing, for the picture.</source>
        <translation>外壳的直径，用于图形。</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Indicator</source>
        <translation>指示器</translation>
    </message>
    <message>
        <source>Resolution of the indicator</source>
        <translation>指示器的分辨力</translation>
    </message>
    <message>
        <source>Smallest step of the indicated value, r of Eq 6.</source>
        <translation>示值的最小步进，式 6 中的 r。</translation>
    </message>
    <message>
        <source>Range of the indicator</source>
        <translation>指示器的量程</translation>
    </message>
    <message>
        <source>Largest value that it can indicate; a reading there is refused as saturated. Empty: only readings that stand still while the load rises are.</source>
        <translation>可指示的最大值；达到该值的读数因饱和而被拒绝。留空：仅拒绝载荷上升时停滞不变的读数。</translation>
    </message>
    <message>
        <source>Calibration machine</source>
        <translation>校准机</translation>
    </message>
    <message>
        <source>What loaded the sensor; its relative uncertainty enters by Eq 5.</source>
        <translation>对传感器加载的设备；其相对不确定度由式 5 计入。</translation>
    </message>
    <message>
        <source>Raw readings, from which everything follows, or what an evaluation states.</source>
        <translation>原始读数（一切由此得到），或评定给出的结果。</translation>
    </message>
    <message>
        <source>raw readings</source>
        <translation>原始读数</translation>
    </message>
    <message>
        <source>summary tables</source>
        <translation>汇总表</translation>
    </message>
    <message>
        <source>Indicated values of all channels at each step, the unloaded value not subtracted; typed or from a CSV file, whose columns may have other names.</source>
        <translation>所有通道在各级的示值，未减去空载值；手工输入或来自 CSV 文件，其列可用其他名称。</translation>
    </message>
    <message>
        <source>Axis on which the machine&apos;s load acts.</source>
        <translation>校准机载荷所作用的轴。</translation>
    </message>
    <message>
        <source>Preloading or calibration.</source>
        <translation>预加载或校准。</translation>
    </message>
    <message>
        <source>preload</source>
        <translation>预加载</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>校准</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>阶段</translation>
    </message>
    <message>
        <source>Unloaded before, preload, increasing or decreasing load, unloaded after.</source>
        <translation>加载前空载、预加载、递增或递减载荷、加载后空载。</translation>
    </message>
    <message>
        <source>zero before</source>
        <translation>加载前零点</translation>
    </message>
    <message>
        <source>load</source>
        <translation>载荷</translation>
    </message>
    <message>
        <source>increasing</source>
        <translation>递增</translation>
    </message>
    <message>
        <source>decreasing</source>
        <translation>递减</translation>
    </message>
    <message>
        <source>zero after</source>
        <translation>加载后零点</translation>
    </message>
    <message>
        <source>step</source>
        <translation>级</translation>
    </message>
    <message>
        <source>Number of the step: 0 without load, the same number for increasing and decreasing load.</source>
        <translation>级的编号：空载为 0，递增和递减载荷的编号相同。</translation>
    </message>
    <message>
        <source>Load in the unit of the next column.</source>
        <translation>载荷，以下一列的单位表示。</translation>
    </message>
    <message>
        <source>load unit</source>
        <translation>载荷单位</translation>
    </message>
    <message>
        <source>N, kN, Nm ...; empty: N for forces and N·m for moments.</source>
        <translation>N、kN、Nm …；留空：力为 N，力矩为 N·m。</translation>
    </message>
    <message>
        <source>Time of the reading.</source>
        <translation>读数的时间。</translation>
    </message>
    <message>
        <source>Indicated value of this channel.</source>
        <translation>该通道的示值。</translation>
    </message>
    <message>
        <source>Summary</source>
        <translation>汇总</translation>
    </message>
    <message>
        <source>What an evaluation states of each channel, like Tables 1 and 3 of the paper.</source>
        <translation>评定对各通道给出的结果，如论文表 1 和表 3。</translation>
    </message>
    <message>
        <source>Channel.</source>
        <translation>通道。</translation>
    </message>
    <message>
        <source>rated output</source>
        <translation>额定输出</translation>
    </message>
    <message>
        <source>Mean net reading at the rated load.</source>
        <translation>额定载荷下的平均净读数。</translation>
    </message>
    <message>
        <source>non-zero error</source>
        <translation>回零误差</translation>
    </message>
    <message>
        <source>Non-zero error: change of the unloaded reading over a series.</source>
        <translation>回零误差：一个系列中空载读数的变化。</translation>
    </message>
    <message>
        <source>Type A standard uncertainty of the mean, the largest of all steps.</source>
        <translation>平均值的 A 类标准不确定度，取各级中最大者。</translation>
    </message>
    <message>
        <source>hysteresis</source>
        <translation>滞后</translation>
    </message>
    <message>
        <source>Largest difference between increasing and decreasing load.</source>
        <translation>递增与递减载荷之间的最大差值。</translation>
    </message>
    <message>
        <source>Type B standard uncertainty as stated; empty: from the machine, the resolution and the non-zero error (Eq 8).</source>
        <translation>给出的 B 类标准不确定度；留空：由校准机、分辨力和回零误差得到（式 8）。</translation>
    </message>
    <message>
        <source>Interference</source>
        <translation>干扰</translation>
    </message>
    <message>
        <source>Outputs at rated loads on other axes, like Table 2 of the paper; which index is the load is chosen below.</source>
        <translation>其他轴额定载荷下的输出，如论文表 2；哪个下标为载荷在下面选择。</translation>
    </message>
    <message>
        <source>Row of the table.</source>
        <translation>表的行。</translation>
    </message>
    <message>
        <source>Column of the table; empty on the diagonal.</source>
        <translation>表的列；对角线上为空。</translation>
    </message>
    <message>
        <source>Interference has signs</source>
        <translation>干扰带符号</translation>
    </message>
    <message>
        <source>Whether the signs are printed. Without them interference cannot be compensated.</source>
        <translation>是否给出了符号。没有符号则不能补偿干扰。</translation>
    </message>
    <message>
        <source>Calibration plan</source>
        <translation>校准方案</translation>
    </message>
    <message>
        <source>Preloads</source>
        <translation>预加载</translation>
    </message>
    <message>
        <source>How often each axis is loaded to its rated load before.</source>
        <translation>每根轴事先加载到额定载荷的次数。</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>测次数</translation>
    </message>
    <message>
        <source>Calibration series of each axis: n of Eqs 2 to 4.</source>
        <translation>每根轴的校准系列数：式 2 至 4 中的 n。</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>级数</translation>
    </message>
    <message>
        <source>Loads of a series up to the rated load; the paper asks for five or more.</source>
        <translation>一个系列中直至额定载荷的载荷级数；论文要求五级或更多。</translation>
    </message>
    <message>
        <source>Decreasing loads too</source>
        <translation>含递减载荷</translation>
    </message>
    <message>
        <source>Whether each series goes down again; hysteresis needs it.</source>
        <translation>每个系列是否再次卸载；滞后需要此项。</translation>
    </message>
    <message>
        <source>Without load before a series</source>
        <translation>系列前的空载时间</translation>
    </message>
    <message>
        <source>Before each series, Fig. 2.</source>
        <translation>每个系列之前，图 2。</translation>
    </message>
    <message>
        <source>At each load</source>
        <translation>每级载荷的保持时间</translation>
    </message>
    <message>
        <source>Before a reading is taken, Fig. 2.</source>
        <translation>取读数之前，图 2。</translation>
    </message>
    <message>
        <source>Evaluation by the paper</source>
        <translation>按论文评定</translation>
    </message>
    <message>
        <source>Coverage factor k of Eq 12</source>
        <translation>式 12 的包含因子 k</translation>
    </message>
    <message>
        <source>The paper takes 2.</source>
        <translation>论文取 2。</translation>
    </message>
    <message>
        <source>A row of the interference table is</source>
        <translation>干扰表的一行表示</translation>
    </message>
    <message>
        <source>Section 2.5 says e_12 is the output of Fy under Fx (row = load), but divides by the rated output of the row and calls the row&apos;s largest the error of that sensor. Raw readings leave no doubt; for a printed table the choice changes U.</source>
        <translation>第 2.5 节称 e_12 是 Fx 作用下 Fy 的输出（行 = 载荷），但却除以该行的额定输出，并把该行最大者称为该传感器的误差。原始读数不会产生疑问；对于已印出的表，该选择会改变 U。</translation>
    </message>
    <message>
        <source>a sensor: its outputs under the other loads</source>
        <translation>一个传感器：其在其他载荷下的输出</translation>
    </message>
    <message>
        <source>a load: the outputs of the other sensors under it</source>
        <translation>一个载荷：其他传感器在该载荷下的输出</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Stated values</source>
        <translation>给出的值</translation>
    </message>
    <message>
        <source>Values that a certificate or a paper prints, to be compared with those computed.</source>
        <translation>证书或论文所印的值，与计算值比较。</translation>
    </message>
    <message>
        <source>As printed, in mV/V; empty: not compared.</source>
        <translation>按所印，以 mV/V 表示；留空：不比较。</translation>
    </message>
    <message>
        <source>interference</source>
        <translation>干扰</translation>
    </message>
    <message>
        <source>U, relative</source>
        <translation>U，相对</translation>
    </message>
    <message>
        <source>Relative expanded uncertainty of Eq 12b.</source>
        <translation>式 12b 的相对扩展不确定度。</translation>
    </message>
    <message>
        <source>U, as a load</source>
        <translation>U，以载荷表示</translation>
    </message>
    <message>
        <source>Expanded uncertainty of Eq 12c in N or N·m, a number without unit.</source>
        <translation>式 12c 的扩展不确定度，以 N 或 N·m 计，为不带单位的数值。</translation>
    </message>
    <message>
        <source>Stated interference in %</source>
        <translation>给出的干扰（%）</translation>
    </message>
    <message>
        <source>Table 4 of the paper: interference by the rated output of the row.</source>
        <translation>论文表 4：干扰除以该行的额定输出。</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Largest of the row.</source>
        <translation>该行的最大值。</translation>
    </message>
    <message>
        <source>Typed measurement equation</source>
        <translation>手工输入的测量方程</translation>
    </message>
    <message>
        <source>The uncertainty of a quantity computed from others by an equation.</source>
        <translation>由方程从其他量计算得到的量的不确定度。</translation>
    </message>
    <message>
        <source>Gauge block by comparison</source>
        <translation>量块比较测量</translation>
    </message>
    <message>
        <source>The length of a gauge block compared with a standard of the same length.</source>
        <translation>量块与相同长度的标准器比较得到的长度。</translation>
    </message>
    <message>
        <source>Two quantities from the same readings</source>
        <translation>同一组读数求两个量</translation>
    </message>
    <message>
        <source>Resistance and reactance from simultaneous readings, with their correlation.</source>
        <translation>由同时读数求电阻和电抗及其相关性。</translation>
    </message>
    <message>
        <source>Calibration line of a thermometer</source>
        <translation>温度计校准直线</translation>
    </message>
    <message>
        <source>The correction at any reading, from a line through calibration points.</source>
        <translation>由过校准点的直线求任意读数处的修正值。</translation>
    </message>
    <message>
        <source>Observations on several days</source>
        <translation>多日观测</translation>
    </message>
    <message>
        <source>The mean of readings in groups, and whether the groups differ.</source>
        <translation>分组读数的平均值，以及各组之间是否有差异。</translation>
    </message>
    <message>
        <source>Pose of a platform from a tracker</source>
        <translation>由跟踪仪求平台位姿</translation>
    </message>
    <message>
        <source>Where a robot&apos;s flange or platform is, from nests measured by a laser tracker.</source>
        <translation>由激光跟踪仪测量靶座，求机器人法兰或平台的位姿。</translation>
    </message>
    <message>
        <source>Pose from two instruments together</source>
        <translation>两台仪器联合求位姿</translation>
    </message>
    <message>
        <source>The same pose measured by a tracker and a total station as one network.</source>
        <translation>跟踪仪和全站仪组成一个网络测量同一位姿。</translation>
    </message>
    <message>
        <source>Pose from calibrated artefacts</source>
        <translation>由已校准的实物标准器求位姿</translation>
    </message>
    <message>
        <source>A pose whose point uncertainties come from measurements of artefacts.</source>
        <translation>点的不确定度来自对实物标准器测量的位姿。</translation>
    </message>
    <message>
        <source>Points by cameras and a tracker</source>
        <translation>由相机和跟踪仪求点</translation>
    </message>
    <message>
        <source>Coordinates of targets that several instruments measure together.</source>
        <translation>若干仪器共同测量的目标点的坐标。</translation>
    </message>
    <message>
        <source>Network with unknown stations</source>
        <translation>测站未知的网</translation>
    </message>
    <message>
        <source>Places of targets and of the instruments themselves, from readings to control points.</source>
        <translation>由对控制点的读数求目标点和仪器自身的位置。</translation>
    </message>
    <message>
        <source>Where do I put the station?</source>
        <translation>测站设在哪里？</translation>
    </message>
    <message>
        <source>The place of an instrument that makes the uncertainties smallest.</source>
        <translation>使不确定度最小的仪器位置。</translation>
    </message>
    <message>
        <source>Tool by ballbars</source>
        <translation>由球杆仪求工具中心点</translation>
    </message>
    <message>
        <source>A robot&apos;s tool centre point from rotations measured by telescopic ballbars.</source>
        <translation>由伸缩式球杆仪测量的旋转求机器人的工具中心点。</translation>
    </message>
    <message>
        <source>Which points do I measure?</source>
        <translation>测量哪些点？</translation>
    </message>
    <message>
        <source>The dozen of a plan of points that makes the uncertainty smallest.</source>
        <translation>从点的方案中选出使不确定度最小的十二个点。</translation>
    </message>
    <message>
        <source>Tool position of a robot</source>
        <translation>机器人的工具位置</translation>
    </message>
    <message>
        <source>Where the tool is, from joint readings and Denavit-Hartenberg parameters.</source>
        <translation>由关节读数和 Denavit-Hartenberg 参数求工具的位置。</translation>
    </message>
    <message>
        <source>Parameters of an arm from circles that its joints describe one by one.</source>
        <translation>由各关节逐一画出的圆求机械臂的参数。</translation>
    </message>
    <message>
        <source>Parameters of an arm from measured places of its flange.</source>
        <translation>由法兰的实测位置求机械臂的参数。</translation>
    </message>
    <message>
        <source>Calibration of a force/moment sensor</source>
        <translation>力/力矩传感器的校准</translation>
    </message>
    <message>
        <source>Errors and uncertainty of the channels of a multi-axis sensor.</source>
        <translation>多轴传感器各通道的误差和不确定度。</translation>
    </message>
    <message>
        <source>Forces and moments from readings</source>
        <translation>由读数求力和力矩</translation>
    </message>
    <message>
        <source>Loads from the readings of a multi-axis sensor by its calibration matrix.</source>
        <translation>用校准矩阵由多轴传感器的读数求载荷。</translation>
    </message>
    <message>
        <source>Law of propagation alone (JCGM 100), with a fixed number of trials (JCGM 101), or with as many as the tolerance needs.</source>
        <translation>仅传播律（JCGM 100）、固定试验次数（JCGM 101），或按容差需要的试验次数。</translation>
    </message>
    <message>
        <source>Law of propagation only</source>
        <translation>仅传播律</translation>
    </message>
    <message>
        <source>Monte Carlo, fixed number of trials</source>
        <translation>蒙特卡洛，固定试验次数</translation>
    </message>
    <message>
        <source>Monte Carlo, adaptive</source>
        <translation>蒙特卡洛，自适应</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>试验次数</translation>
    </message>
    <message>
        <source>Of the method monte-carlo.</source>
        <translation>monte-carlo 方法的试验次数。</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>种子</translation>
    </message>
    <message>
        <source>0 to 18446744073709551615, as text.</source>
        <translation>0 至 18446744073709551615，以文本给出。</translation>
    </message>
    <message>
        <source>Variance reduction</source>
        <translation>方差缩减</translation>
    </message>
    <message>
        <source>Makes each trial tell more; the gain is measured and stated with the result. Plain trials are those of JCGM 101.</source>
        <translation>使每次试验提供更多信息；增益经测定并随结果给出。普通试验即 JCGM 101 的试验。</translation>
    </message>
    <message>
        <source>None: plain trials</source>
        <translation>无：普通试验</translation>
    </message>
    <message>
        <source>Control variate: the linear part</source>
        <translation>控制变量：线性部分</translation>
    </message>
    <message>
        <source>Sobol points, scrambled</source>
        <translation>加扰 Sobol 点</translation>
    </message>
    <message>
        <source>Coverage probability</source>
        <translation>包含概率</translation>
    </message>
    <message>
        <source>Of the expanded uncertainty, of intervals and regions.</source>
        <translation>扩展不确定度、区间和区域的包含概率。</translation>
    </message>
    <message>
        <source>Coverage factor</source>
        <translation>包含因子</translation>
    </message>
    <message>
        <source>A fixed k for U = k u; absent: U by the effective degrees of freedom (law of propagation), or half of the coverage interval (Monte Carlo).</source>
        <translation>U = k u 所用的固定 k；缺省：U 由有效自由度得到（传播律），或为包含区间的一半（蒙特卡洛）。</translation>
    </message>
    <message>
        <source>Second-order terms</source>
        <translation>二阶项</translation>
    </message>
    <message>
        <source>Terms of second order of the law of propagation (JCGM 100 5.1.2).</source>
        <translation>传播律的二阶项（JCGM 100 5.1.2）。</translation>
    </message>
    <message>
        <source>Trials one at a time</source>
        <translation>逐个分量的试验次数</translation>
    </message>
    <message>
        <source>Of Monte Carlo with all components but one kept constant, for each component; 0: none.</source>
        <translation>对每个分量，其余分量均保持不变时的蒙特卡洛试验次数；0：无。</translation>
    </message>
    <message>
        <source>Trials by contributor</source>
        <translation>每个贡献源的试验次数</translation>
    </message>
    <message>
        <source>Of Monte Carlo without each contributor, and of it alone; 0: none.</source>
        <translation>去掉每个贡献源以及仅保留该贡献源时的蒙特卡洛试验次数；0：无。</translation>
    </message>
    <message>
        <source>Trials for Sobol indices</source>
        <translation>Sobol 指数的试验次数</translation>
    </message>
    <message>
        <source>Pairs of trials for Sobol indices; 0: none.</source>
        <translation>用于 Sobol 指数的试验对数；0：无。</translation>
    </message>
    <message>
        <source>Significant digits</source>
        <translation>有效位数</translation>
    </message>
    <message>
        <source>Of u, for the numerical tolerance of adaptive runs and of the validation (JCGM 101 7.9.2, 8).</source>
        <translation>u 的有效位数，用于自适应运行的数值容差和验证（JCGM 101 7.9.2、8）。</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>容差</translation>
    </message>
    <message>
        <source>A quantity applies to the outputs of its dimension; a number to every output in its SI unit.</source>
        <translation>带单位的量适用于同量纲的输出；纯数适用于每个输出，以其 SI 单位计。</translation>
    </message>
    <message>
        <source>Least number of batches</source>
        <translation>最少批数</translation>
    </message>
    <message>
        <source>Of an adaptive run, before it may stop.</source>
        <translation>自适应运行允许停止前的批数。</translation>
    </message>
    <message>
        <source>Most trials</source>
        <translation>最多试验次数</translation>
    </message>
    <message>
        <source>At which an adaptive run stops in any case.</source>
        <translation>自适应运行无论如何都停止的试验次数。</translation>
    </message>
    <message>
        <source>Certificate and laboratory</source>
        <translation>证书和实验室</translation>
    </message>
    <message>
        <source>Certificate number</source>
        <translation>证书编号</translation>
    </message>
    <message>
        <source>Unique; it stands on every page.</source>
        <translation>唯一；印在每一页上。</translation>
    </message>
    <message>
        <source>Laboratory</source>
        <translation>实验室</translation>
    </message>
    <message>
        <source>That issues the certificate.</source>
        <translation>出具证书的实验室。</translation>
    </message>
    <message>
        <source>Address of the laboratory</source>
        <translation>实验室地址</translation>
    </message>
    <message>
        <source>Street, town, country.</source>
        <translation>街道、城市、国家。</translation>
    </message>
    <message>
        <source>Country of the laboratory</source>
        <translation>实验室所在国家</translation>
    </message>
    <message>
        <source>Two capital letters (ISO 3166-1): DE. For a Digital Calibration Certificate.</source>
        <translation>两个大写字母（ISO 3166-1）：DE。用于数字校准证书。</translation>
    </message>
    <message>
        <source>Accreditation number</source>
        <translation>认可编号</translation>
    </message>
    <message>
        <source>Absent: not accredited for this.</source>
        <translation>缺省：未就此获得认可。</translation>
    </message>
    <message>
        <source>Place of calibration</source>
        <translation>校准地点</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>客户</translation>
    </message>
    <message>
        <source>For whom it was done.</source>
        <translation>为谁进行校准。</translation>
    </message>
    <message>
        <source>Address of the customer</source>
        <translation>客户地址</translation>
    </message>
    <message>
        <source>Item</source>
        <translation>被校物品</translation>
    </message>
    <message>
        <source>What was calibrated.</source>
        <translation>校准的是什么。</translation>
    </message>
    <message>
        <source>Manufacturer</source>
        <translation>制造商</translation>
    </message>
    <message>
        <source>Of the item.</source>
        <translation>被校物品的制造商。</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>The manufacturer&apos;s name for it: model, size, class.</source>
        <translation>制造商给出的名称：型号、规格、等级。</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>序列号</translation>
    </message>
    <message>
        <source>By which the item is recognised, unless it has an identification.</source>
        <translation>用于识别被校物品，除非已有标识。</translation>
    </message>
    <message>
        <source>Identification</source>
        <translation>标识</translation>
    </message>
    <message>
        <source>The customer&apos;s mark, an inventory number.</source>
        <translation>客户的标记、资产编号。</translation>
    </message>
    <message>
        <source>Condition of the item</source>
        <translation>被校物品状态</translation>
    </message>
    <message>
        <source>As it was received, where that matters.</source>
        <translation>接收时的状态（有影响时）。</translation>
    </message>
    <message>
        <source>Dates</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>ISO 8601: 2026-04-17.</source>
        <translation>ISO 8601：2026-04-17。</translation>
    </message>
    <message>
        <source>A date, or two of an interval: 2026-04-17/2026-04-18.</source>
        <translation>一个日期，或表示期间的两个日期：2026-04-17/2026-04-18。</translation>
    </message>
    <message>
        <source>ISO 8601: 2026-04-20.</source>
        <translation>ISO 8601：2026-04-20。</translation>
    </message>
    <message>
        <source>Procedure by which it was calibrated, with its edition.</source>
        <translation>校准所依据的程序及其版本。</translation>
    </message>
    <message>
        <source>Deviations from the method</source>
        <translation>对方法的偏离</translation>
    </message>
    <message>
        <source>Additions, exclusions.</source>
        <translation>增加、删减。</translation>
    </message>
    <message>
        <source>Environmental conditions</source>
        <translation>环境条件</translation>
    </message>
    <message>
        <source>Those that influence the results.</source>
        <translation>影响结果的环境条件。</translation>
    </message>
    <message>
        <source>Metrological traceability</source>
        <translation>计量溯源性</translation>
    </message>
    <message>
        <source>To which references, by which certificates the results are traceable.</source>
        <translation>结果通过哪些证书溯源到哪些参考标准。</translation>
    </message>
    <message>
        <source>Adjustment or repair</source>
        <translation>调整或修理</translation>
    </message>
    <message>
        <source>Results before and after it.</source>
        <translation>调整或修理前后的结果。</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Opinions and interpretations are marked as such (7.8.7).</source>
        <translation>意见和解释按规定标明（7.8.7）。</translation>
    </message>
    <message>
        <source>Authorisation</source>
        <translation>批准</translation>
    </message>
    <message>
        <source>Authorised by</source>
        <translation>批准人</translation>
    </message>
    <message>
        <source>The person who authorises the certificate.</source>
        <translation>批准证书的人员。</translation>
    </message>
    <message>
        <source>Function</source>
        <translation>职务</translation>
    </message>
    <message>
        <source>Of that person in the laboratory.</source>
        <translation>该人员在实验室的职务。</translation>
    </message>
    <message>
        <source>Measurement model</source>
        <translation>测量模型</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>测量设置</translation>
    </message>
    <message>
        <source>Input quantities</source>
        <translation>输入量</translation>
    </message>
    <message>
        <source>Artefacts and instruments</source>
        <translation>实物标准器和仪器</translation>
    </message>
    <message>
        <source>Uncertainty budgets</source>
        <translation>不确定度预算</translation>
    </message>
    <message>
        <source>Sobol indices and contributors</source>
        <translation>Sobol 指数和贡献源</translation>
    </message>
    <message>
        <source>Evaluation of the set-up</source>
        <translation>测量设置的评定</translation>
    </message>
    <message>
        <source>Law of propagation beside Monte Carlo</source>
        <translation>传播律与蒙特卡洛对照</translation>
    </message>
    <message>
        <source>Joint coverage regions</source>
        <translation>联合包含区域</translation>
    </message>
    <message>
        <source>Distributions</source>
        <translation>分布</translation>
    </message>
    <message>
        <source>Set-up in space</source>
        <translation>测量设置的空间图</translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation>相关性</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>参数研究</translation>
    </message>
    <message>
        <source>Designs</source>
        <translation>设计</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>附注</translation>
    </message>
    <message>
        <source>Provenance</source>
        <translation>来源记录</translation>
    </message>
    <message>
        <source>mean value</source>
        <translation>均值</translation>
    </message>
    <message>
        <source>standard deviation</source>
        <translation>标准偏差</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>尺度</translation>
    </message>
    <message>
        <source>degrees of freedom</source>
        <translation>自由度</translation>
    </message>
    <message>
        <source>lower limit</source>
        <translation>下限</translation>
    </message>
    <message>
        <source>upper limit</source>
        <translation>上限</translation>
    </message>
    <message>
        <source>curvilinear trapezoid</source>
        <translation>曲线梯形</translation>
    </message>
    <message>
        <source>inexactness of the limits</source>
        <translation>界限的不精确度</translation>
    </message>
    <message>
        <source>ratio of top to base</source>
        <translation>上底与下底之比</translation>
    </message>
    <message>
        <source>shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>truncated normal</source>
        <translation>截尾正态</translation>
    </message>
    <message>
        <source>lognormal</source>
        <translation>对数正态</translation>
    </message>
    <message>
        <source>mean value of the logarithm of the number in SI</source>
        <translation>SI 数值的对数的均值</translation>
    </message>
    <message>
        <source>standard deviation of the logarithm</source>
        <translation>对数的标准偏差</translation>
    </message>
    <message>
        <source>parameter alpha</source>
        <translation>参数 alpha</translation>
    </message>
    <message>
        <source>parameter beta</source>
        <translation>参数 beta</translation>
    </message>
    <message>
        <source>discrete</source>
        <translation>离散</translation>
    </message>
    <message>
        <source>SpatialAnalyzer points (ASCII)</source>
        <translation>SpatialAnalyzer 点（ASCII）</translation>
    </message>
    <message>
        <source>Table of points</source>
        <translation>点表</translation>
    </message>
    <message>
        <source>Digital Calibration Certificate</source>
        <translation>数字校准证书</translation>
    </message>
    <message>
        <source>Leica GSI-8 and GSI-16</source>
        <translation>Leica GSI-8 和 GSI-16</translation>
    </message>
    <message>
        <source>GNU Gama network</source>
        <translation>GNU Gama 网络</translation>
    </message>
    <message>
        <source>Comp3D coordinates</source>
        <translation>Comp3D 坐标</translation>
    </message>
    <message>
        <source>Comp3D observations</source>
        <translation>Comp3D 观测值</translation>
    </message>
    <message>
        <source>Uncertainty budget in Excel</source>
        <translation>Excel 中的不确定度预算</translation>
    </message>
    <message>
        <source>GUM Workbench</source>
        <translation>GUM Workbench</translation>
    </message>
    <message>
        <source>Suncal project</source>
        <translation>Suncal 项目</translation>
    </message>
    <message>
        <source>OptiTrack Motive tracking data</source>
        <translation>OptiTrack Motive 跟踪数据</translation>
    </message>
    <message>
        <source>Kinematic calibration of a UR robot (ROS)</source>
        <translation>UR 机器人运动学校准（ROS）</translation>
    </message>
    <message>
        <source>Point list with Ux Uy Uz (SpatialAnalyzer ASCII)</source>
        <translation>带 Ux Uy Uz 的点列表（SpatialAnalyzer ASCII）</translation>
    </message>
    <message>
        <source>Digital Calibration Certificate 3.2.1</source>
        <translation>数字校准证书 3.2.1</translation>
    </message>
    <message>
        <source>Excel workbook</source>
        <translation>Excel 工作簿</translation>
    </message>
    <message>
        <source>Robot description (URDF)</source>
        <translation>机器人描述（URDF）</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>组</translation>
    </message>
    <message>
        <source>The pose, point or target the quantity belongs to</source>
        <translation>该量所属的位姿、点或目标点</translation>
    </message>
    <message>
        <source>Output quantity</source>
        <translation>输出量</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>估计值</translation>
    </message>
    <message>
        <source>Best value of the output quantity</source>
        <translation>输出量的最佳值</translation>
    </message>
    <message>
        <source>Standard uncertainty</source>
        <translation>标准不确定度</translation>
    </message>
    <message>
        <source>Coverage factor. U = k u with k of the t distribution for the effective degrees of freedom.</source>
        <translation>包含因子。U = k u，k 取有效自由度的 t 分布。</translation>
    </message>
    <message>
        <source>Expanded uncertainty. U = k u with k of the t distribution for the effective degrees of freedom.</source>
        <translation>扩展不确定度。U = k u，k 取有效自由度的 t 分布。</translation>
    </message>
    <message>
        <source>Limit of the shortest coverage interval</source>
        <translation>最短包含区间的界限</translation>
    </message>
    <message>
        <source>Estimate (first order)</source>
        <translation>估计值（一阶）</translation>
    </message>
    <message>
        <source>By the law of propagation of uncertainty</source>
        <translation>按不确定度传播律</translation>
    </message>
    <message>
        <source>u (first order)</source>
        <translation>u（一阶）</translation>
    </message>
    <message>
        <source>Effective degrees of freedom (JCGM 100 G.4)</source>
        <translation>有效自由度（JCGM 100 G.4）</translation>
    </message>
    <message>
        <source>U (first order)</source>
        <translation>U（一阶）</translation>
    </message>
    <message>
        <source>First order validated</source>
        <translation>一阶结果已验证</translation>
    </message>
    <message>
        <source>JCGM 101 clause 8: agrees with Monte Carlo within the tolerance</source>
        <translation>JCGM 101 第 8 章：在容差内与蒙特卡洛一致</translation>
    </message>
    <message>
        <source>u (second order)</source>
        <translation>u（二阶）</translation>
    </message>
    <message>
        <source>With the second-order terms of JCGM 100 5.1.2; for information</source>
        <translation>含 JCGM 100 5.1.2 的二阶项；仅供参考</translation>
    </message>
    <message>
        <source>shift (second order)</source>
        <translation>偏移（二阶）</translation>
    </message>
    <message>
        <source>What the curvature of the equation adds to the estimate; for information, not added</source>
        <translation>方程的曲率给估计值带来的增量；仅供参考，未计入</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标值</translation>
    </message>
    <message>
        <source>Target uncertainty that is required</source>
        <translation>要求的目标不确定度</translation>
    </message>
    <message>
        <source>U / target</source>
        <translation>U / 目标值</translation>
    </message>
    <message>
        <source>Expanded uncertainty as a part of its target: above 1 the target is not met</source>
        <translation>扩展不确定度与其目标值之比：大于 1 则不满足目标值</translation>
    </message>
    <message>
        <source>Requirement</source>
        <translation>要求</translation>
    </message>
    <message>
        <source>Whether the target uncertainty is met and the value is accepted</source>
        <translation>是否满足目标不确定度且值被接受</translation>
    </message>
    <message>
        <source>Input quantity</source>
        <translation>输入量</translation>
    </message>
    <message>
        <source>Component of uncertainty</source>
        <translation>不确定度分量</translation>
    </message>
    <message>
        <source>Of the component&apos;s u</source>
        <translation>该分量 u 的单位</translation>
    </message>
    <message>
        <source>Standard uncertainty of the component</source>
        <translation>该分量的标准不确定度</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>分布</translation>
    </message>
    <message>
        <source>Type A or Type B evaluation (JCGM 100 2.3.2, 2.3.3)</source>
        <translation>A 类或 B 类评定（JCGM 100 2.3.2、2.3.3）</translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation>自由度</translation>
    </message>
    <message>
        <source>Sensitivity coefficient, unit of the output quantity per unit of the component</source>
        <translation>灵敏系数，输出量的单位除以分量的单位</translation>
    </message>
    <message>
        <source>|c|·u</source>
        <translation>|c|·u</translation>
    </message>
    <message>
        <source>Contribution to the standard uncertainty</source>
        <translation>对标准不确定度的贡献</translation>
    </message>
    <message>
        <source>Share / %</source>
        <translation>占比 / %</translation>
    </message>
    <message>
        <source>Of the variance, with its part of the covariances</source>
        <translation>占方差的比例，含其协方差部分</translation>
    </message>
    <message>
        <source>u one at a time</source>
        <translation>逐一 u</translation>
    </message>
    <message>
        <source>By Monte Carlo with every other component kept constant</source>
        <translation>由蒙特卡洛得到，其余分量均保持不变</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Where the figure comes from</source>
        <translation>数值的出处</translation>
    </message>
    <message>
        <source>In</source>
        <translation>存在于</translation>
    </message>
    <message>
        <source>Whether both results have the quantity</source>
        <translation>两个结果是否都有该量</translation>
    </message>
    <message>
        <source>U before</source>
        <translation>U（前）</translation>
    </message>
    <message>
        <source>Expanded uncertainty</source>
        <translation>扩展不确定度</translation>
    </message>
    <message>
        <source>U after</source>
        <translation>U（后）</translation>
    </message>
    <message>
        <source>Change of U in %</source>
        <translation>U 的变化（%）</translation>
    </message>
    <message>
        <source>Change of the expanded uncertainty, in per cent of that before</source>
        <translation>扩展不确定度的变化，以之前值的百分数表示</translation>
    </message>
    <message>
        <source>Estimate before</source>
        <translation>估计值（前）</translation>
    </message>
    <message>
        <source>Estimate after</source>
        <translation>估计值（后）</translation>
    </message>
    <message>
        <source>Change of estimate</source>
        <translation>估计值的变化</translation>
    </message>
    <message>
        <source>Estimate after less estimate before</source>
        <translation>之后的估计值减去之前的估计值</translation>
    </message>
    <message>
        <source>u before</source>
        <translation>u（前）</translation>
    </message>
    <message>
        <source>u after</source>
        <translation>u（后）</translation>
    </message>
    <message>
        <source>k before</source>
        <translation>k（前）</translation>
    </message>
    <message>
        <source>k after</source>
        <translation>k（后）</translation>
    </message>
    <message>
        <source>Changed, the same, new, or gone</source>
        <translation>已变化、相同、新增或消失</translation>
    </message>
    <message>
        <source>|c|·u before</source>
        <translation>|c|·u（前）</translation>
    </message>
    <message>
        <source>|c|·u after</source>
        <translation>|c|·u（后）</translation>
    </message>
    <message>
        <source>Share before / %</source>
        <translation>占比（前）/ %</translation>
    </message>
    <message>
        <source>Of the variance before</source>
        <translation>占之前方差的比例</translation>
    </message>
    <message>
        <source>Share after / %</source>
        <translation>占比（后）/ %</translation>
    </message>
    <message>
        <source>Of the variance after</source>
        <translation>占之后方差的比例</translation>
    </message>
    <message>
        <source>Change of variance / %</source>
        <translation>方差的变化 / %</translation>
    </message>
    <message>
        <source>By how much this component changes the variance of the output, in per cent of the whole variance before; the rows add up to the change of the whole</source>
        <translation>该分量使输出的方差改变多少，以之前总方差的百分数表示；各行之和为总变化</translation>
    </message>
    <message>
        <source>met</source>
        <translation>满足</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>不满足</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
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
        <translation>包含因子。U = k u，采用固定的包含因子。</translation>
    </message>
    <message>
        <source>Expanded uncertainty. U = k u with the coverage factor that was fixed.</source>
        <translation>扩展不确定度。U = k u，采用固定的包含因子。</translation>
    </message>
    <message>
        <source>Coverage factor. U is half the width of the probabilistically symmetric coverage interval, and k = U/u.</source>
        <translation>包含因子。U 为概率对称包含区间宽度的一半，k = U/u。</translation>
    </message>
    <message>
        <source>Expanded uncertainty. U is half the width of the probabilistically symmetric coverage interval, and k = U/u.</source>
        <translation>扩展不确定度。U 为概率对称包含区间宽度的一半，k = U/u。</translation>
    </message>
    <message>
        <source>Target uncertainty</source>
        <translation>目标不确定度</translation>
    </message>
    <message>
        <source>The expanded uncertainty U must not exceed this.</source>
        <translation>扩展不确定度 U 不得超过此值。</translation>
    </message>
    <message>
        <source>Lower limit</source>
        <translation>下限</translation>
    </message>
    <message>
        <source>Of the tolerance; empty: none.</source>
        <translation>容差的界限；留空：无。</translation>
    </message>
    <message>
        <source>Upper limit</source>
        <translation>上限</translation>
    </message>
    <message>
        <source>Guard factor</source>
        <translation>保护带系数</translation>
    </message>
    <message>
        <source>Guard bands of this times U inside the tolerance: 1 proves conformity (ISO 14253-1), 0 is simple acceptance, negative values favour the producer.</source>
        <translation>容差内取 U 的这一倍数作为保护带：1 证明合格（ISO 14253-1），0 为简单接受，负值有利于生产方。</translation>
    </message>
    <message>
        <source>Prior mean</source>
        <translation>先验均值</translation>
    </message>
    <message>
        <source>What is known of such quantities before the measurement, as a normal distribution (the production process): for the global risks of JCGM 106.</source>
        <translation>测量前对此类量的认知，以正态分布表示（生产过程）：用于 JCGM 106 的全局风险。</translation>
    </message>
    <message>
        <source>Prior standard deviation</source>
        <translation>先验标准偏差</translation>
    </message>
    <message>
        <source>Of the production process.</source>
        <translation>生产过程的标准偏差。</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>Logo</source>
        <translation>徽标</translation>
    </message>
    <message>
        <source>A PNG or JPEG file beside the project, up to 2 MB: at the head of the first page.</source>
        <translation>项目旁的 PNG 或 JPEG 文件，最大 2 MB：位于首页页眉。</translation>
    </message>
    <message>
        <source>Calibration certificate %1</source>
        <translation>校准证书 %1</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>第 %1 页，共 %2 页</translation>
    </message>
    <message>
        <source>— not stated —</source>
        <translation>— 未给出 —</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>in the laboratory</source>
        <translation>在实验室内</translation>
    </message>
    <message>
        <source>This certificate states %1 of %2 results. Not stated: %3.</source>
        <translation>本证书给出 %2 个结果中的 %1 个。未给出：%3。</translation>
    </message>
    <message>
        <source>1 further result is in the digital certificate that is attached to the PDF (certificate.xml).</source>
        <translation>另有 1 个结果在 PDF 所附的数字证书（certificate.xml）中。</translation>
    </message>
    <message>
        <source>%1 further results are in the digital certificate that is attached to the PDF (certificate.xml).</source>
        <translation>另有 %1 个结果在 PDF 所附的数字证书（certificate.xml）中。</translation>
    </message>
    <message>
        <source>Not evaluated: %1.</source>
        <translation>未评定：%1。</translation>
    </message>
    <message>
        <source>Evaluated with Covaria %1, project fingerprint %2.</source>
        <translation>用 Covaria %1 评定，项目指纹 %2。</translation>
    </message>
    <message>
        <source>Evaluated with Covaria %1, project fingerprint %2, analyses: %3.</source>
        <translation>用 Covaria %1 评定，项目指纹 %2，分析：%3。</translation>
    </message>
    <message>
        <source>The results relate only to the item described above, in the state in which it was calibrated. This certificate may be reproduced in full only, unless the laboratory permits otherwise.</source>
        <translation>结果仅与上述物品在校准时的状态有关。未经实验室许可，本证书只能全文复制。</translation>
    </message>
    <message>
        <source>Date of issue: %1</source>
        <translation>签发日期：%1</translation>
    </message>
    <message>
        <source>End of certificate</source>
        <translation>证书结束</translation>
    </message>
    <message>
        <source>End of certificate %1</source>
        <translation>证书 %1 结束</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>p = %1 to %2.</source>
        <translation>p = %1 至 %2。</translation>
    </message>
    <message>
        <source>No result is stated: what was evaluated does not represent the measurand; %1 trials have no value.</source>
        <translation>不给出结果：所评定的内容不代表被测量；%1 次试验没有值。</translation>
    </message>
    <message>
        <source>Coverage intervals that are not symmetric about the estimate: %1.</source>
        <translation>不关于估计值对称的包含区间：%1。</translation>
    </message>
    <message>
        <source>Coverage intervals that are not symmetric about the estimate: %1; and %2 others.</source>
        <translation>不关于估计值对称的包含区间：%1；以及另外 %2 个。</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 在 %2 内</translation>
    </message>
    <message>
        <source>%1 (exact)</source>
        <translation>%1（精确）</translation>
    </message>
    <message>
        <source>%1 (U not finite)</source>
        <translation>%1（U 不是有限值）</translation>
    </message>
    <message>
        <source>without k, because u is not finite</source>
        <translation>无 k，因为 u 不是有限值</translation>
    </message>
    <message>
        <source>coverage interval %1</source>
        <translation>包含区间 %1</translation>
    </message>
    <message>
        <source>The standard uncertainty was determined by the law of propagation of uncertainty in accordance with JCGM 100.</source>
        <translation>标准不确定度按 JCGM 100 的不确定度传播律确定。</translation>
    </message>
    <message>
        <source>The distribution was determined by the propagation of distributions in accordance with JCGM 101.</source>
        <translation>分布按 JCGM 101 的分布传播确定。</translation>
    </message>
    <message>
        <source>The expanded uncertainty U stated after ± is the standard uncertainty multiplied by the fixed coverage factor k; y ± U has the coverage probability p that is stated with it.</source>
        <translation>± 之后给出的扩展不确定度 U 是标准不确定度乘以固定的包含因子 k；y ± U 的包含概率 p 与其一同给出。</translation>
    </message>
    <message>
        <source>The expanded uncertainty U stated after ± is half the width of the probabilistically symmetric coverage interval of the coverage probability p, and k = U/u.</source>
        <translation>± 之后给出的扩展不确定度 U 是包含概率为 p 的概率对称包含区间的半宽，且 k = U/u。</translation>
    </message>
    <message>
        <source>The expanded uncertainty U stated after ± is the standard uncertainty multiplied by the coverage factor k, which for a normal distribution, or for a t distribution of the effective degrees of freedom nu_eff where they are stated, corresponds to the coverage probability p.</source>
        <translation>± 之后给出的扩展不确定度 U 是标准不确定度乘以包含因子 k；对于正态分布，或在给出有效自由度 nu_eff 时对于 t 分布，k 对应于包含概率 p。</translation>
    </message>
    <message>
        <source>Statement of conformity</source>
        <translation>符合性声明</translation>
    </message>
    <message>
        <source>Acceptance</source>
        <translation>接受区间</translation>
    </message>
    <message>
        <source>Decision rule</source>
        <translation>判定规则</translation>
    </message>
    <message>
        <source>Decision</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Conforming</source>
        <translation>合格概率</translation>
    </message>
    <message>
        <source>by</source>
        <translation>依据</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>未判定</translation>
    </message>
    <message>
        <source>trials</source>
        <translation>试验</translation>
    </message>
    <message>
        <source>JCGM 106: probability that the measurand lies inside the tolerance, by the distribution of the result: its trials, or by the law of propagation Student&apos;s t for the effective degrees of freedom. The acceptance interval is the tolerance less guard bands w. Decision rules are named as in ILAC-G8:09/2019. TUR: half of the tolerance over U. C_m: T/(2U) for U = 2u, T/(4u).</source>
        <translation>JCGM 106：被测量处于容差内的概率，按结果的分布计算：其试验，或在传播律下按有效自由度的 t 分布。接受区间是容差减去保护带 w。判定规则的名称按 ILAC-G8:09/2019。TUR：容差的一半除以 U。C_m：U = 2u 时为 T/(2U)，即 T/(4u)。</translation>
    </message>
    <message>
        <source>simple acceptance (w = 0)</source>
        <translation>简单接受（w = 0）</translation>
    </message>
    <message>
        <source>guard band w = %1</source>
        <translation>保护带 w = %1</translation>
    </message>
    <message>
        <source>guarded rejection (w = −%1)</source>
        <translation>带保护的拒绝（w = −%1）</translation>
    </message>
    <message>
        <source>Results before and after</source>
        <translation>前后结果</translation>
    </message>
    <message>
        <source>Context mesh</source>
        <translation>环境网格</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>STL file</source>
        <translation>STL 文件</translation>
    </message>
    <message>
        <source>A binary or ASCII STL file beside the project, up to 200 MB and 5 million triangles. It is drawn in the scenes of all analyses and influences no number.</source>
        <translation>项目旁边的二进制或 ASCII STL 文件，最大 200 MB、500 万个三角形。它绘制在所有分析的场景中，不影响任何数值。</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>文件的单位</translation>
    </message>
    <message>
        <source>STL files do not say in which unit their numbers are.</source>
        <translation>STL 文件不说明其数值的单位。</translation>
    </message>
    <message>
        <source>millimetre</source>
        <translation>毫米</translation>
    </message>
    <message>
        <source>metre</source>
        <translation>米</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>Position and orientation</source>
        <translation>位置和姿态</translation>
    </message>
    <message>
        <source>Where the origin of the file stands in the world frame, and how its axes are turned.</source>
        <translation>文件的原点在世界坐标系中的位置，以及其各轴的旋转。</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>外观</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Of the surface, on a light and on a dark ground.</source>
        <translation>曲面的颜色，用于浅色和深色背景。</translation>
    </message>
    <message>
        <source>grey</source>
        <translation>灰色</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>蓝色</translation>
    </message>
    <message>
        <source>green</source>
        <translation>绿色</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>橙色</translation>
    </message>
    <message>
        <source>red</source>
        <translation>红色</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>100 % hides what is behind the surface; less lets the measured points be seen.</source>
        <translation>100 % 会遮住曲面后面的东西；较小的值能看到实测点。</translation>
    </message>
    <message>
        <source>largest U/target</source>
        <translation>最大 U/目标值</translation>
    </message>
    <message>
        <source>largest U relative to the present design</source>
        <translation>相对当前设计的最大 U</translation>
    </message>
    <message>
        <source>mean U/target</source>
        <translation>U/目标值的平均值</translation>
    </message>
    <message>
        <source>mean U relative to the present design</source>
        <translation>相对当前设计的 U 平均值</translation>
    </message>
    <message>
        <source>root mean square of U/target</source>
        <translation>U/目标值的均方根</translation>
    </message>
    <message>
        <source>root mean square of U relative to the present design</source>
        <translation>相对当前设计的 U 均方根</translation>
    </message>
    <message>
        <source>Monte Carlo</source>
        <translation>蒙特卡洛</translation>
    </message>
    <message>
        <source>Run Monte Carlo to see the distribution of %1</source>
        <translation>运行蒙特卡洛以查看 %1 的分布</translation>
    </message>
    <message>
        <source>Run Monte Carlo to see the quantiles of %1</source>
        <translation>运行蒙特卡洛以查看 %1 的分位数</translation>
    </message>
    <message>
        <source>Run Monte Carlo with more trials to see the distribution of %1</source>
        <translation>用更多次试验运行蒙特卡洛以查看 %1 的分布</translation>
    </message>
    <message>
        <source>Run Monte Carlo with more trials to see the quantiles of %1</source>
        <translation>用更多次试验运行蒙特卡洛以查看 %1 的分位数</translation>
    </message>
    <message>
        <source>%1 has the same value in every trial: give its inputs components of uncertainty</source>
        <translation>%1 在每次试验中取值相同：请为其输入量给出不确定度分量</translation>
    </message>
    <message>
        <source>Distribution of %1</source>
        <translation>%1 的分布</translation>
    </message>
    <message>
        <source>probability density</source>
        <translation>概率密度</translation>
    </message>
    <message>
        <source>normal, same mean and u</source>
        <translation>正态分布，均值和 u 相同</translation>
    </message>
    <message>
        <source>normal, same interval</source>
        <translation>正态分布，区间相同</translation>
    </message>
    <message>
        <source>normal, first order</source>
        <translation>正态分布，一阶</translation>
    </message>
    <message>
        <source>Student t, first order</source>
        <translation>t 分布，一阶</translation>
    </message>
    <message>
        <source>%1 coverage interval</source>
        <translation>%1 包含区间</translation>
    </message>
    <message>
        <source>mean %1</source>
        <translation>平均值 %1</translation>
    </message>
    <message>
        <source>Normal quantiles of %1</source>
        <translation>%1 的正态分位数</translation>
    </message>
    <message>
        <source>quantile of the standard normal distribution</source>
        <translation>标准正态分布的分位数</translation>
    </message>
    <message>
        <source>quantile of %1</source>
        <translation>%1 的分位数</translation>
    </message>
    <message>
        <source>No input quantity with an uncertainty influences %1: give its inputs components of uncertainty</source>
        <translation>没有带不确定度的输入量影响 %1：请为其输入量给出不确定度分量</translation>
    </message>
    <message>
        <source>Contributions to u(%1)</source>
        <translation>对 u(%1) 的贡献</translation>
    </message>
    <message>
        <source>first order</source>
        <translation>一阶</translation>
    </message>
    <message>
        <source>one at a time, Monte Carlo</source>
        <translation>逐一，蒙特卡洛</translation>
    </message>
    <message>
        <source>%1 others</source>
        <translation>其他 %1 个</translation>
    </message>
    <message>
        <source>A single output quantity has nothing to be correlated with</source>
        <translation>只有一个输出量，无相关性可显示</translation>
    </message>
    <message>
        <source>Correlation coefficients</source>
        <translation>相关系数</translation>
    </message>
    <message>
        <source>correlation coefficient</source>
        <translation>相关系数</translation>
    </message>
    <message>
        <source>Run Monte Carlo to see how u of %1 settles</source>
        <translation>运行蒙特卡洛以查看 %1 的 u 如何趋于稳定</translation>
    </message>
    <message>
        <source>%1, against the number of trials</source>
        <translation>%1 随试验次数的变化</translation>
    </message>
    <message>
        <source>%1 (not stabilised)</source>
        <translation>%1（未稳定）</translation>
    </message>
    <message>
        <source>± 2 standard errors</source>
        <translation>± 2 倍标准误差</translation>
    </message>
    <message>
        <source>final u %1</source>
        <translation>最终 u %1</translation>
    </message>
    <message>
        <source>before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>after</source>
        <translation>之后</translation>
    </message>
    <message>
        <source>Distributions of %1</source>
        <translation>%1 的各分布</translation>
    </message>
    <message>
        <source>The output quantity has no distribution to show</source>
        <translation>该输出量没有可显示的分布</translation>
    </message>
    <message>
        <source>Only one of the results has %1</source>
        <translation>只有一个结果含有 %1</translation>
    </message>
    <message>
        <source>The budget of %1 has not changed</source>
        <translation>%1 的不确定度预算没有变化</translation>
    </message>
    <message>
        <source>Changes of the budget of %1</source>
        <translation>%1 的不确定度预算的变化</translation>
    </message>
    <message>
        <source>uncertainty</source>
        <translation>不确定度</translation>
    </message>
    <message>
        <source>as set up: %1</source>
        <translation>当前设置：%1</translation>
    </message>
    <message>
        <source>%1 at %2 = %3</source>
        <translation>%1，%2 = %3</translation>
    </message>
    <message>
        <source>Run the study “%1” to see it</source>
        <translation>运行参数研究“%1”以查看它</translation>
    </message>
    <message>
        <source>No grid point of “%1” has values: %2</source>
        <translation>“%1”的网格点均无数值：%2</translation>
    </message>
    <message>
        <source>Uncertainties before and after</source>
        <translation>前后的不确定度</translation>
    </message>
    <message>
        <source>U relative to the present design</source>
        <translation>相对当前设计的 U</translation>
    </message>
    <message>
        <source>designed</source>
        <translation>设计后</translation>
    </message>
    <message>
        <source>What more rows give</source>
        <translation>增加行的收益</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>行数</translation>
    </message>
    <message>
        <source>best found</source>
        <translation>找到的最佳</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>What each row kept is worth</source>
        <translation>每一保留行的价值</translation>
    </message>
    <message>
        <source>What a smaller uncertainty costs</source>
        <translation>减小不确定度的成本</translation>
    </message>
    <message>
        <source>largest U / target</source>
        <translation>最大 U / 目标值</translation>
    </message>
    <message>
        <source>cost</source>
        <translation>成本</translation>
    </message>
    <message>
        <source>cheapest reductions</source>
        <translation>成本最低的减小项</translation>
    </message>
    <message>
        <source>cheapest rows</source>
        <translation>成本最低的行</translation>
    </message>
    <message>
        <source>targets</source>
        <translation>目标值</translation>
    </message>
    <message>
        <source>The way of the search</source>
        <translation>搜索过程</translation>
    </message>
    <message>
        <source>evaluations</source>
        <translation>评定次数</translation>
    </message>
    <message>
        <source>best so far</source>
        <translation>目前最佳</translation>
    </message>
    <message>
        <source>both</source>
        <translation>两者</translation>
    </message>
    <message>
        <source>only before</source>
        <translation>仅之前</translation>
    </message>
    <message>
        <source>only after</source>
        <translation>仅之后</translation>
    </message>
    <message>
        <source>new</source>
        <translation>新增</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>已移除</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>已改变</translation>
    </message>
    <message>
        <source>same</source>
        <translation>相同</translation>
    </message>
    <message>
        <source>number of trials</source>
        <translation>试验次数</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Coordinate measuring machines and arms</source>
        <translation>坐标测量机与测量臂</translation>
    </message>
    <message>
        <source>Distance meters</source>
        <translation>测距仪</translation>
    </message>
    <message>
        <source>Laser scanners</source>
        <translation>激光扫描仪</translation>
    </message>
    <message>
        <source>Laser trackers</source>
        <translation>激光跟踪仪</translation>
    </message>
    <message>
        <source>Length standards and ballbars</source>
        <translation>长度标准器与球杆仪</translation>
    </message>
    <message>
        <source>Robot arms</source>
        <translation>机械臂</translation>
    </message>
    <message>
        <source>Total stations</source>
        <translation>全站仪</translation>
    </message>
    <message>
        <source>Uncertainty budget of a measured point</source>
        <translation>实测点的不确定度预算</translation>
    </message>
    <message>
        <source>Errors of indication (Eq 1)</source>
        <translation>示值误差（式 1）</translation>
    </message>
    <message>
        <source>Errors of indication (Eq 4)</source>
        <translation>示值误差（式 4）</translation>
    </message>
    <message>
        <source>Standard uncertainty of one reading, along and across the line of sight</source>
        <translation>一次读数的标准不确定度，沿视线与垂直于视线</translation>
    </message>
    <message>
        <source>across, by azimuth</source>
        <translation>横向，由方位角</translation>
    </message>
    <message>
        <source>across, by elevation</source>
        <translation>横向，由俯仰角</translation>
    </message>
    <message>
        <source>along</source>
        <translation>沿视线</translation>
    </message>
    <message>
        <source>Standard uncertainty by the readings alone, and with the stations</source>
        <translation>仅由读数及连同测站的标准不确定度</translation>
    </message>
    <message>
        <source>readings alone (Eq 5)</source>
        <translation>仅读数（式 5）</translation>
    </message>
    <message>
        <source>readings and shared deviations, first order</source>
        <translation>读数与共同偏差，一阶</translation>
    </message>
    <message>
        <source>Parameters and their uncertainty</source>
        <translation>参数及其不确定度</translation>
    </message>
    <message>
        <source>u, section 4.1</source>
        <translation>u，第 4.1 节</translation>
    </message>
    <message>
        <source>U = 2 u</source>
        <translation>U = 2 u</translation>
    </message>
    <message>
        <source>value − U</source>
        <translation>值 − U</translation>
    </message>
    <message>
        <source>value + U</source>
        <translation>值 + U</translation>
    </message>
    <message>
        <source>u, Table 1</source>
        <translation>u，表 1</translation>
    </message>
    <message>
        <source>u, repeatability</source>
        <translation>u，重复性</translation>
    </message>
    <message>
        <source>u, sampling</source>
        <translation>u，采样</translation>
    </message>
    <message>
        <source>u, range</source>
        <translation>u，范围</translation>
    </message>
    <message>
        <source>Identified parameters beside the nominal ones</source>
        <translation>辨识参数与标称参数对照</translation>
    </message>
    <message>
        <source>nominal</source>
        <translation>标称值</translation>
    </message>
    <message>
        <source>identified</source>
        <translation>辨识值</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>差值</translation>
    </message>
    <message>
        <source>What these points cannot tell</source>
        <translation>这些点无法确定的内容</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Observability</source>
        <translation>可观测性</translation>
    </message>
    <message>
        <source>Strongest correlation of each unknown</source>
        <translation>每个未知数的最强相关</translation>
    </message>
    <message>
        <source>Residuals of the fit, measured less calculated</source>
        <translation>拟合残差，测量值减计算值</translation>
    </message>
    <message>
        <source>pose</source>
        <translation>位姿</translation>
    </message>
    <message>
        <source>largest over its u</source>
        <translation>最大值与其 u 之比</translation>
    </message>
    <message>
        <source>outlier test</source>
        <translation>离群值检验</translation>
    </message>
    <message>
        <source>Poses held back from the fit, calculated less measured</source>
        <translation>未参与拟合的位姿，计算值减测量值</translation>
    </message>
    <message>
        <source>nominal, distance</source>
        <translation>标称值，距离</translation>
    </message>
    <message>
        <source>U (k = 2), largest</source>
        <translation>U (k = 2)，最大</translation>
    </message>
    <message>
        <source>E_n, largest</source>
        <translation>E_n，最大</translation>
    </message>
    <message>
        <source>Circles of the joints</source>
        <translation>关节圆</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>圆弧</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>rms along the radius</source>
        <translation>沿半径方向的均方根</translation>
    </message>
    <message>
        <source>rms off the plane</source>
        <translation>离面均方根</translation>
    </message>
    <message>
        <source>Readings and places of the poses, without uncertainty</source>
        <translation>位姿的读数与位置，无不确定度</translation>
    </message>
    <message>
        <source>Relative uncertainty of the loads</source>
        <translation>载荷的相对不确定度</translation>
    </message>
    <message>
        <source>Calibration as planned and as read</source>
        <translation>计划的校准与实际读数</translation>
    </message>
    <message>
        <source>preloads</source>
        <translation>预加载次数</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>测次数</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>级数</translation>
    </message>
    <message>
        <source>decreasing steps</source>
        <translation>递减级数</translation>
    </message>
    <message>
        <source>spread of the preloads</source>
        <translation>预加载的分散性</translation>
    </message>
    <message>
        <source>Rated output and non-zero error of each sensor (Kim, Table 1)</source>
        <translation>各传感器的额定输出与回零误差（Kim，表 1）</translation>
    </message>
    <message>
        <source>rated load</source>
        <translation>额定载荷</translation>
    </message>
    <message>
        <source>Interference error of each sensor (Kim, Table 2)</source>
        <translation>各传感器的干扰误差（Kim，表 2）</translation>
    </message>
    <message>
        <source>Uncertainty of the sensors by the paper (Kim, Table 3, Eqs 4 to 12)</source>
        <translation>按论文的传感器不确定度（Kim，表 3，式 4 至 12）</translation>
    </message>
    <message>
        <source>U, load</source>
        <translation>U，载荷</translation>
    </message>
    <message>
        <source>Interference error in per cent of the rated output (Kim, Table 4)</source>
        <translation>干扰误差占额定输出的百分比（Kim，表 4）</translation>
    </message>
    <message>
        <source>Parts of the Type B standard uncertainty (Eqs 5 to 8)</source>
        <translation>B 类标准不确定度的组成（式 5 至 8）</translation>
    </message>
    <message>
        <source>Means and standard deviations of the net values (Eqs 1 to 4)</source>
        <translation>净值的平均值与标准偏差（式 1 至 4）</translation>
    </message>
    <message>
        <source>mean, decreasing</source>
        <translation>平均值，递减</translation>
    </message>
    <message>
        <source>Stated values beside the computed ones</source>
        <translation>给出的值与计算值对照</translation>
    </message>
    <message>
        <source>stated</source>
        <translation>给出</translation>
    </message>
    <message>
        <source>computed</source>
        <translation>计算</translation>
    </message>
    <message>
        <source>status</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Interference at rated loads (% of the sensor&apos;s rated output)</source>
        <translation>额定载荷下的干扰（占传感器额定输出的 %）</translation>
    </message>
    <message>
        <source>Parts of U by the paper (% of rated output)</source>
        <translation>按论文的 U 的组成（占额定输出的 %）</translation>
    </message>
    <message>
        <source>per cent of rated output</source>
        <translation>占额定输出的百分比</translation>
    </message>
    <message>
        <source>k u_c</source>
        <translation>k u_c</translation>
    </message>
    <message>
        <source>Loads of one axis against time</source>
        <translation>一个轴的载荷随时间变化</translation>
    </message>
    <message>
        <source>Calibration curve of Fx</source>
        <translation>Fx 的校准曲线</translation>
    </message>
    <message>
        <source>increasing, mean</source>
        <translation>递增，平均值</translation>
    </message>
    <message>
        <source>decreasing, mean</source>
        <translation>递减，平均值</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of Fx</source>
        <translation>Fx 相对过零直线的残差</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of Fx</source>
        <translation>Fx 的滞后回线（放大）</translation>
    </message>
    <message>
        <source>Calibration curve of Fy</source>
        <translation>Fy 的校准曲线</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of Fy</source>
        <translation>Fy 相对过零直线的残差</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of Fy</source>
        <translation>Fy 的滞后回线（放大）</translation>
    </message>
    <message>
        <source>Calibration curve of Fz</source>
        <translation>Fz 的校准曲线</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of Fz</source>
        <translation>Fz 相对过零直线的残差</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of Fz</source>
        <translation>Fz 的滞后回线（放大）</translation>
    </message>
    <message>
        <source>Calibration curve of Mx</source>
        <translation>Mx 的校准曲线</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of Mx</source>
        <translation>Mx 相对过零直线的残差</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of Mx</source>
        <translation>Mx 的滞后回线（放大）</translation>
    </message>
    <message>
        <source>Calibration curve of My</source>
        <translation>My 的校准曲线</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of My</source>
        <translation>My 相对过零直线的残差</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of My</source>
        <translation>My 的滞后回线（放大）</translation>
    </message>
    <message>
        <source>Calibration curve of Mz</source>
        <translation>Mz 的校准曲线</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of Mz</source>
        <translation>Mz 相对过零直线的残差</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of Mz</source>
        <translation>Mz 的滞后回线（放大）</translation>
    </message>
    <message>
        <source>The paper&apos;s U and the GUM&apos;s, per cent of rated output</source>
        <translation>论文的 U 与 GUM 的 U，占额定输出的百分比</translation>
    </message>
    <message>
        <source>paper, linear sum</source>
        <translation>论文，线性和</translation>
    </message>
    <message>
        <source>GUM, unknown loads on all other axes</source>
        <translation>GUM，其他各轴载荷未知</translation>
    </message>
    <message>
        <source>GUM, unknown load on one axis</source>
        <translation>GUM，一个轴载荷未知</translation>
    </message>
    <message>
        <source>GUM, one component alone, 95 %</source>
        <translation>GUM，仅一个分量，95 %</translation>
    </message>
    <message>
        <source>all other axes at rated load, worst signs</source>
        <translation>其他各轴为额定载荷，最不利符号</translation>
    </message>
    <message>
        <source>interference alone exceeds the paper&apos;s U</source>
        <translation>仅干扰即超过论文的 U</translation>
    </message>
    <message>
        <source>Standard uncertainties by the GUM</source>
        <translation>按 GUM 的标准不确定度</translation>
    </message>
    <message>
        <source>repeatability</source>
        <translation>重复性</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>校准机</translation>
    </message>
    <message>
        <source>non-zero</source>
        <translation>回零</translation>
    </message>
    <message>
        <source>all</source>
        <translation>合计</translation>
    </message>
    <message>
        <source>U by the paper and by the GUM</source>
        <translation>按论文与按 GUM 的 U</translation>
    </message>
    <message>
        <source>all others at rated load, worst signs</source>
        <translation>其他均为额定载荷，最不利符号</translation>
    </message>
    <message>
        <source>Calibration matrix: reading by load</source>
        <translation>校准矩阵：每单位载荷的读数</translation>
    </message>
    <message>
        <source>channel</source>
        <translation>通道</translation>
    </message>
    <message>
        <source>load Fx</source>
        <translation>载荷 Fx</translation>
    </message>
    <message>
        <source>load Fy</source>
        <translation>载荷 Fy</translation>
    </message>
    <message>
        <source>load Fz</source>
        <translation>载荷 Fz</translation>
    </message>
    <message>
        <source>load Mx</source>
        <translation>载荷 Mx</translation>
    </message>
    <message>
        <source>load My</source>
        <translation>载荷 My</translation>
    </message>
    <message>
        <source>load Mz</source>
        <translation>载荷 Mz</translation>
    </message>
    <message>
        <source>Decoupling matrix: load by reading</source>
        <translation>解耦矩阵：每单位读数的载荷</translation>
    </message>
    <message>
        <source>channel Fx</source>
        <translation>通道 Fx</translation>
    </message>
    <message>
        <source>channel Fy</source>
        <translation>通道 Fy</translation>
    </message>
    <message>
        <source>channel Fz</source>
        <translation>通道 Fz</translation>
    </message>
    <message>
        <source>channel Mx</source>
        <translation>通道 Mx</translation>
    </message>
    <message>
        <source>channel My</source>
        <translation>通道 My</translation>
    </message>
    <message>
        <source>channel Mz</source>
        <translation>通道 Mz</translation>
    </message>
    <message>
        <source>Loads with and without compensation of interference</source>
        <translation>有无干扰补偿的载荷</translation>
    </message>
    <message>
        <source>case</source>
        <translation>工况</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>读数</translation>
    </message>
    <message>
        <source>compensated</source>
        <translation>已补偿</translation>
    </message>
    <message>
        <source>uncompensated</source>
        <translation>未补偿</translation>
    </message>
    <message>
        <source>by rated load</source>
        <translation>除以额定载荷</translation>
    </message>
    <message>
        <source>What interference adds without compensation</source>
        <translation>未补偿时干扰的附加量</translation>
    </message>
    <message>
        <source>per cent of rated load</source>
        <translation>占额定载荷的百分比</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>混合</translation>
    </message>
    <message>
        <source>all rated</source>
        <translation>全部额定</translation>
    </message>
    <message>
        <source>no load</source>
        <translation>无载荷</translation>
    </message>
    <message>
        <source>Supports in the instrument&apos;s frame and in the robot&apos;s</source>
        <translation>支座在仪器坐标系与机器人坐标系中的位置</translation>
    </message>
    <message>
        <source>support</source>
        <translation>支座</translation>
    </message>
    <message>
        <source>Scatter of a pose that the robot is sent to again</source>
        <translation>机器人重复到达同一位姿的分散性</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>偏差</translation>
    </message>
    <message>
        <source>Rotations of the flange</source>
        <translation>法兰的旋转</translation>
    </message>
    <message>
        <source>about</source>
        <translation>绕</translation>
    </message>
    <message>
        <source>radius of the circle</source>
        <translation>圆的半径</translation>
    </message>
    <message>
        <source>least height above the supports</source>
        <translation>高于支座的最小高度</translation>
    </message>
    <message>
        <source>greatest height</source>
        <translation>最大高度</translation>
    </message>
    <message>
        <source>Sensors of the network</source>
        <translation>网络的传感器</translation>
    </message>
    <message>
        <source>reads</source>
        <translation>读取</translation>
    </message>
    <message>
        <source>Analysis of variance</source>
        <translation>方差分析</translation>
    </message>
    <message>
        <source>source of variation</source>
        <translation>变异来源</translation>
    </message>
    <message>
        <source>sum of squares</source>
        <translation>平方和</translation>
    </message>
    <message>
        <source>mean square</source>
        <translation>均方</translation>
    </message>
    <message>
        <source>Components of variance</source>
        <translation>方差分量</translation>
    </message>
    <message>
        <source>Type A evaluation of observations</source>
        <translation>观测值的 A 类评定</translation>
    </message>
    <message>
        <source>s of one observation</source>
        <translation>单次观测的 s</translation>
    </message>
    <message>
        <source>u of the mean</source>
        <translation>平均值的 u</translation>
    </message>
    <message>
        <source>number of the observation</source>
        <translation>观测序号</translation>
    </message>
    <message>
        <source>Points and their residuals</source>
        <translation>各点及其残差</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>Analysis of variance of the fit</source>
        <translation>拟合的方差分析</translation>
    </message>
    <message>
        <source>Uncertainties</source>
        <translation>不确定度</translation>
    </message>
    <message>
        <source>output</source>
        <translation>输出量</translation>
    </message>
    <message>
        <source>U by Monte Carlo</source>
        <translation>蒙特卡洛的 U</translation>
    </message>
    <message>
        <source>validated (clause 8)</source>
        <translation>已验证（第 8 章）</translation>
    </message>
    <message>
        <source>cost per unit of target</source>
        <translation>每单位目标值的成本</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>值</translation>
    </message>
    <message>
        <source>variable</source>
        <translation>变量</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>选定</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>容差</translation>
    </message>
    <message>
        <source>Rows that are kept</source>
        <translation>保留的行</translation>
    </message>
    <message>
        <source>row</source>
        <translation>行</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>固定</translation>
    </message>
    <message>
        <source>of the candidates&apos; file</source>
        <translation>来自候选文件</translation>
    </message>
    <message>
        <source>objective without it</source>
        <translation>去掉它后的目标函数</translation>
    </message>
    <message>
        <source>price</source>
        <translation>价格</translation>
    </message>
    <message>
        <source>Candidates and what they gain</source>
        <translation>候选项及其收益</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>收益</translation>
    </message>
    <message>
        <source>What would be gained without the uncertainty of</source>
        <translation>去掉下列不确定度后的收益</translation>
    </message>
    <message>
        <source>Objective and number of rows</source>
        <translation>目标函数与行数</translation>
    </message>
    <message>
        <source>objective</source>
        <translation>目标函数</translation>
    </message>
    <message>
        <source>change</source>
        <translation>变化</translation>
    </message>
    <message>
        <source>Cost and uncertainty</source>
        <translation>成本与不确定度</translation>
    </message>
    <message>
        <source>Improvements</source>
        <translation>改进</translation>
    </message>
    <message>
        <source>evaluation</source>
        <translation>评定</translation>
    </message>
    <message>
        <source>search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Candidates without result</source>
        <translation>无结果的候选项</translation>
    </message>
    <message>
        <source>count</source>
        <translation>数量</translation>
    </message>
    <message>
        <source>U without %1</source>
        <translation>去掉 %1 后的 U</translation>
    </message>
    <message>
        <source>Expanded uncertainty that remains when everything %1 brings in is kept constant (an ideal one), by the law of propagation</source>
        <translation>将 %1 带来的一切保持不变（理想情况）时剩余的扩展不确定度，按传播律</translation>
    </message>
    <message>
        <source>Expanded uncertainty that remains when everything %1 brings in is kept constant (an ideal one), by Monte Carlo</source>
        <translation>将 %1 带来的一切保持不变（理想情况）时剩余的扩展不确定度，按蒙特卡洛</translation>
    </message>
    <message>
        <source>symbol of the quantity</source>
        <translation>量的符号</translation>
    </message>
    <message>
        <source>what it is</source>
        <translation>说明</translation>
    </message>
    <message>
        <source>estimate</source>
        <translation>估计值</translation>
    </message>
    <message>
        <source>unit of estimate and uncertainty</source>
        <translation>估计值与不确定度的单位</translation>
    </message>
    <message>
        <source>uncertainty before the divisor</source>
        <translation>除以除数之前的不确定度</translation>
    </message>
    <message>
        <source>half-width of the limits</source>
        <translation>界限半宽</translation>
    </message>
    <message>
        <source>divisor, coverage factor k</source>
        <translation>除数，包含因子 k</translation>
    </message>
    <message>
        <source>sensitivity coefficient</source>
        <translation>灵敏系数</translation>
    </message>
    <message>
        <source>contribution to u(y)</source>
        <translation>对 u(y) 的贡献</translation>
    </message>
    <message>
        <source>where the figure comes from</source>
        <translation>数值的出处</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>不读取</translation>
    </message>
    <message>
        <source>name of the point</source>
        <translation>点的名称</translation>
    </message>
    <message>
        <source>standard uncertainty of x, y, z</source>
        <translation>x、y、z 的标准不确定度</translation>
    </message>
    <message>
        <source>standard uncertainty of x</source>
        <translation>x 的标准不确定度</translation>
    </message>
    <message>
        <source>standard uncertainty of y</source>
        <translation>y 的标准不确定度</translation>
    </message>
    <message>
        <source>standard uncertainty of z</source>
        <translation>z 的标准不确定度</translation>
    </message>
    <message>
        <source>expanded uncertainty of x, y, z, k = 2</source>
        <translation>x、y、z 的扩展不确定度，k = 2</translation>
    </message>
    <message>
        <source>expanded uncertainty of x, k = 2</source>
        <translation>x 的扩展不确定度，k = 2</translation>
    </message>
    <message>
        <source>expanded uncertainty of y, k = 2</source>
        <translation>y 的扩展不确定度，k = 2</translation>
    </message>
    <message>
        <source>expanded uncertainty of z, k = 2</source>
        <translation>z 的扩展不确定度，k = 2</translation>
    </message>
    <message>
        <source>Kind of change</source>
        <translation>变化类型</translation>
    </message>
    <message>
        <source>Fields of the set-up</source>
        <translation>测量设置的字段</translation>
    </message>
    <message>
        <source>Equations as evaluated</source>
        <translation>实际计算的方程</translation>
    </message>
    <message>
        <source>References</source>
        <translation>参考文献</translation>
    </message>
    <message>
        <source>Options of the evaluation</source>
        <translation>评定的选项</translation>
    </message>
    <message>
        <source>What a calibration certificate says beside its results, with the clause of ISO/IEC 17025:2017 that asks for it.</source>
        <translation>校准证书除结果之外所说明的内容，以及 ISO/IEC 17025:2017 中要求它的条款。</translation>
    </message>
    <message>
        <source>optional</source>
        <translation>可选</translation>
    </message>
    <message>
        <source>default %1</source>
        <translation>默认值 %1</translation>
    </message>
    <message>
        <source>Choices: </source>
        <translation>选项： </translation>
    </message>
    <message>
        <source>required by %1</source>
        <translation>%1 要求必备</translation>
    </message>
    <message>
        <source>asked for by %1</source>
        <translation>%1 要求</translation>
    </message>
    <message>
        <source>integer</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>choice</source>
        <translation>选择</translation>
    </message>
    <message>
        <source>text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>flag</source>
        <translation>是或否</translation>
    </message>
    <message>
        <source>table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>reference to an asset</source>
        <translation>对资源的引用</translation>
    </message>
    <message>
        <source>real number</source>
        <translation>实数</translation>
    </message>
    <message>
        <source>Position and orientation of a moving frame in a base frame, both defined by measured points: the platform of a robot measured with a total station or laser tracker.</source>
        <translation>动坐标系在基坐标系中的位置和姿态，两者均由实测点定义：用全站仪或激光跟踪仪测量的机器人平台。</translation>
    </message>
    <message>
        <source>Eq 19 is corrected: o_p − o_b must be expressed in the base frame. As printed, the pose does not depend on the orientation of the base, and U(x) of all poses is the same.</source>
        <translation>式 19 已更正：o_p − o_b 必须在基坐标系中表示。按原文，位姿不取决于基座的姿态，所有位姿的 U(x) 相同。</translation>
    </message>
    <message>
        <source>Eq 20 is corrected: R = R_bᵀ R_p. The printed R_p R_bᵀ is the same rotation expressed in frame 0.</source>
        <translation>式 20 已更正：R = R_bᵀ R_p。原文的 R_p R_bᵀ 是在坐标系 0 中表示的同一旋转。</translation>
    </message>
    <message>
        <source>Eqs 21-23 are corrected: as printed they are Z-Y-Z angles, undefined without tilt; the text and Table 3 use Z-Y-X angles, R = Rz(γ) Ry(β) Rx(α).</source>
        <translation>式 21-23 已更正：按原文它们是 Z-Y-Z 角，无倾斜时无定义；正文和表 3 使用 Z-Y-X 角，R = Rz(γ) Ry(β) Rx(α)。</translation>
    </message>
    <message>
        <source>b₃ lies at negative y of its frame (Eq 10) and p₃ at positive y of its own (Eq 14); other arrangements can be chosen.</source>
        <translation>b₃ 位于其坐标系的负 y 侧（式 10），p₃ 位于其自身坐标系的正 y 侧（式 14）；可选择其他布置。</translation>
    </message>
    <message>
        <source>Typed uncertainties lie along the axes of the frame that the points define (those of the moving frame along the base&apos;s on request) and are turned into frame 0; those of an instrument lie along and across its line of sight.</source>
        <translation>输入的不确定度沿各点所定义的坐标系的轴（动坐标系的可按要求沿基坐标系的轴），并转换到坐标系 0；仪器的不确定度沿其视线和垂直于视线。</translation>
    </message>
    <message>
        <source>Measured points of a least-squares frame are tested against their nominal coordinates: residuals, redundancy, chi-square with the full covariance of the stated uncertainties.</source>
        <translation>最小二乘坐标系的实测点与其标称坐标比对检验：残差、冗余度、采用给出的不确定度的全协方差的卡方。</translation>
    </message>
    <message>
        <source>All poses of an analysis share one measurement of the base, so their results are correlated.</source>
        <translation>一个分析的所有位姿共用基座的一次测量，因此其结果相关。</translation>
    </message>
    <message>
        <source>The uncertainty of the mean of repeated measurements (a posteriori) is taken as that of one measurement, as in the paper: the systematic part does not average out.</source>
        <translation>重复测量平均值的不确定度（后验）按论文取一次测量的不确定度：系统部分不会平均掉。</translation>
    </message>
    <message>
        <source>Angles are undefined in gimbal lock; the set-up then warns. Rotation vector and quaternion are free of it.</source>
        <translation>万向节锁定时角度无定义；测量设置会给出警告。旋转矢量和四元数没有此问题。</translation>
    </message>
    <message>
        <source>Coordinates of targets and distances between them, measured by any mix of trackers, total stations, cameras and distance meters placed in space.</source>
        <translation>目标点的坐标及其间的距离，由空间中任意组合的跟踪仪、全站仪、相机和测距仪测得。</translation>
    </message>
    <message>
        <source>The uncertainty of the stations does not contribute marginally to the position of a target, as the paper says: only distances within one set-up are nearly free of it. Eq 5 is the precision of the readings; it is shown beside the total, never as the uncertainty of a position.</source>
        <translation>测站的不确定度对目标点位置的贡献并不像论文所说的那样微小：只有一次设站内的距离几乎不受其影响。式 5 是读数的精密度；它显示在总量旁边，从不作为位置的不确定度。</translation>
    </message>
    <message>
        <source>Weights from the readings alone, as in the paper, are inefficient for positions; those with the stations are the default.</source>
        <translation>如论文那样仅由读数得出的权对位置而言效率低；默认采用连同测站的权。</translation>
    </message>
    <message>
        <source>Eq 2 is corrected: D holds equations by readings; as printed it is transposed.</source>
        <translation>式 2 已更正：D 的行为方程、列为读数；原文是转置的。</translation>
    </message>
    <message>
        <source>The linearised equations have the measured angles in M: their estimate shrinks towards the sensors, the non-linear one moves outwards by half as much. It matters beyond a milliradian (3.5 mrad, cameras alone: −6.9 mm against +3.3 mm) and not for the paper&apos;s network.</source>
        <translation>线性化方程的 M 中含实测角度：其估计向传感器收缩，非线性估计则向外移动一半的量。超过一毫弧度时才重要（3.5 mrad，仅相机：−6.9 mm 对 +3.3 mm），对论文的网络不重要。</translation>
    </message>
    <message>
        <source>Stations are located once for a set-up: all its targets share their deviations. &quot;New set-up&quot; at a target draws them anew.</source>
        <translation>一次设站的测站只定位一次：其所有目标点共用其偏差。目标点处的“重新设站”重新抽取偏差。</translation>
    </message>
    <message>
        <source>A distance without angles has no linear equation; the non-linear estimator uses it, from the nominal coordinates as start.</source>
        <translation>没有角度的距离没有线性方程；非线性估计以标称坐标为起点使用它。</translation>
    </message>
    <message>
        <source>A calibrated length as a check is not used in the estimation: its difference is to be judged by its uncertainty. As a constraint it carries its own uncertainty; a scale that the instruments share is corrected by it.</source>
        <translation>作为检核的已校准长度不用于估计：其差值按其不确定度判断。作为约束时它带有自身的不确定度；各仪器共有的尺度由它修正。</translation>
    </message>
    <message>
        <source>With more than 600 readings in one set-up each target is estimated by itself, weighted with the stations.</source>
        <translation>一次设站的读数超过 600 个时，每个目标点单独估计，与测站一起加权。</translation>
    </message>
    <message>
        <source>Azimuths may be given with any number of whole turns.</source>
        <translation>方位角可以带任意整圈数。</translation>
    </message>
    <message>
        <source>The tool centre point of a robot: the flange turns about its own axes, telescopic ballbars measure where the ball at the tool goes, and planes and a sphere give the flange&apos;s axes and centre.</source>
        <translation>机器人的工具中心点：法兰绕其自身的轴转动，伸缩式球杆仪测量工具处的球到达哪里，由平面和球面得出法兰的轴和中心。</translation>
    </message>
    <message>
        <source>The paper states neither the tool, nor the flange&apos;s orientation, start angles, how the frame is made, nor how the points are averaged. With a tool of (0, 0, 100) mm, the flange pointing down, arcs from -60° to 140° and from -90° to 90° and u(L) = 1.55 µm, the published values reproduce within 1.5 % (root mean square).</source>
        <translation>论文没有说明工具、法兰的姿态、起始角、坐标系如何构成，也没有说明各点如何平均。取工具 (0, 0, 100) mm、法兰朝下、圆弧 -60° 至 140° 和 -90° 至 90°、u(L) = 1.55 µm 时，可在 1.5 %（均方根）内重现发表的值。</translation>
    </message>
    <message>
        <source>U(TCP): published 8.2, 11.1, 5.1 µm; here 8.16, 10.92, 5.00 µm: reproduces.</source>
        <translation>U(TCP)：发表值 8.2, 11.1, 5.1 µm；此处 8.16, 10.92, 5.00 µm：重现。</translation>
    </message>
    <message>
        <source>U(TCP) with an ideal robot: published 2.8, 3.7, 1.6 µm; here 2.77, 3.61, 1.57 µm: reproduces.</source>
        <translation>理想机器人的 U(TCP)：发表值 2.8, 3.7, 1.6 µm；此处 2.77, 3.61, 1.57 µm：重现。</translation>
    </message>
    <message>
        <source>U of the axes&apos; angles XY, XZ, YX, YZ: published 79, 87, 59, 123 µrad; here 78.3, 87.2, 58.5, 120.6 µrad: reproduces.</source>
        <translation>各轴夹角 XY, XZ, YX, YZ 的 U：发表值 79, 87, 59, 123 µrad；此处 78.3, 87.2, 58.5, 120.6 µrad：重现。</translation>
    </message>
    <message>
        <source>Largest U of a point measured by the ballbars alone: published 5.7, 5.7, 2.4 µm; here 5.83, 5.72, 2.38 µm: reproduces.</source>
        <translation>仅由球杆仪测量的点的最大 U：发表值 5.7, 5.7, 2.4 µm；此处 5.83, 5.72, 2.38 µm：重现。</translation>
    </message>
    <message>
        <source>With the stated U(L) = 4 µm the same geometry gives U(TCP) 8.46, 11.31, 5.16 µm and points up to 7.53, 7.37, 3.07 µm: differs, because the stated 4 µm and the published points cannot both hold. U(z) of a point at most 577 mm above the supports is 2.4 µm only for U(L) near 3.1 µm; all six figures of the instrument alone are 0.78 of what 4 µm gives.</source>
        <translation>按给出的 U(L) = 4 µm，同样的几何给出 U(TCP) 8.46, 11.31, 5.16 µm，点至多 7.53, 7.37, 3.07 µm：不同，因为给出的 4 µm 与发表的点不能同时成立。支座上方至多 577 mm 的点，只有 U(L) 接近 3.1 µm 时 U(z) 才为 2.4 µm；仅仪器的六个数值均为 4 µm 所给出的 0.78 倍。</translation>
    </message>
    <message>
        <source>The centre of the sphere is the centre of the flange, not the tool centre point as section 4 says: its U is 5.96, 7.42, 6.94 µm.</source>
        <translation>球面的中心是法兰的中心，而不是第 4 节所说的工具中心点：其 U 为 5.96, 7.42, 6.94 µm。</translation>
    </message>
    <message>
        <source>Eq 8 needs perpendicular axes, which two measured normals are not: U(x) of the tool is 8.16, 8.37 or 8.66 µm with y first, symmetric or x first.</source>
        <translation>式 8 需要垂直的轴，而两条实测法线并不垂直：工具的 U(x) 在先取 y、对称或先取 x 时为 8.16、8.37 或 8.66 µm。</translation>
    </message>
    <message>
        <source>A trial whose lengths do not meet (negative root of Eq 3) has no value: it is counted and reported.</source>
        <translation>长度不相交的试验（式 3 的根为负）没有值：计数并报告。</translation>
    </message>
    <message>
        <source>Position and orientation of the tool of a serial robot from its geometric parameters and joint readings.</source>
        <translation>由串联机器人的几何参数和关节读数求其工具的位置和姿态。</translation>
    </message>
    <message>
        <source>The paper calls the model highly non-linear. At the uncertainties of its Table 1 it is not: the law of propagation and Monte Carlo agree to 4e-5 mm in u, and the laws are normal.</source>
        <translation>论文称模型高度非线性。在其表 1 的不确定度下并非如此：传播律和蒙特卡洛的 u 一致到 4e-5 mm，分布为正态。</translation>
    </message>
    <message>
        <source>The tolerance 0.0001 of the paper has no unit. In millimetres it would need 5e9 trials; in metres it is 0.1 mm, and 20 000 trials do.</source>
        <translation>论文的容差 0.0001 没有单位。以毫米计需要 5e9 次试验；以米计为 0.1 mm，20 000 次试验即可。</translation>
    </message>
    <message>
        <source>The paper takes the parameters as uncorrelated. Parameters identified together are strongly correlated; an identified robot carries their full covariance into this analysis, which lowers u by up to a factor of 12.</source>
        <translation>论文取参数为不相关。一起辨识的参数强烈相关；辨识的机器人将其全协方差带入此分析，使 u 最多降低到 1/12。</translation>
    </message>
    <message>
        <source>Of two readings of section 4.1 (0.01 rad for theta alone, or for all angles) both are reproduced; that theta matters more than alpha holds only where its standard deviation is ten times larger.</source>
        <translation>第 4.1 节的两种解读（仅 theta 为 0.01 rad，或所有角度）都可重现；theta 比 alpha 重要仅在其标准偏差大十倍时成立。</translation>
    </message>
    <message>
        <source>Readings of the joints deviate anew at each pose; parameters and tool are the same for all poses of an analysis.</source>
        <translation>关节读数在每个位姿重新偏离；参数和工具对一个分析的所有位姿相同。</translation>
    </message>
    <message>
        <source>Geometric parameters of a serial robot from points measured while one joint after the other turns (circle point analysis).</source>
        <translation>由逐个关节转动时测得的点求串联机器人的几何参数（圆点分析）。</translation>
    </message>
    <message>
        <source>Eq 4 is corrected: without the square its derivative by R gives R = 0.</source>
        <translation>式 4 已更正：没有平方时对 R 的导数给出 R = 0。</translation>
    </message>
    <message>
        <source>2.1.3 is corrected: x_i = z_i × y_i is left-handed.</source>
        <translation>2.1.3 已更正：x_i = z_i × y_i 是左手系。</translation>
    </message>
    <message>
        <source>2.1.4 is corrected: alpha_i and beta_i turn z_{i−1} into z_i.</source>
        <translation>2.1.4 已更正：alpha_i 和 beta_i 将 z_{i−1} 转到 z_i。</translation>
    </message>
    <message>
        <source>The auxiliary plane of Figure 2 is not defined in the paper; it must pass through O_{i−1} with the normal z_{i−1}, or d_i = 0 is impossible.</source>
        <translation>论文没有定义图 2 的辅助平面；它必须以 z_{i−1} 为法线通过 O_{i−1}，否则 d_i = 0 不可能。</translation>
    </message>
    <message>
        <source>Eq 1 has no plane through the origin and fails near it; total least squares is the default.</source>
        <translation>式 1 不能表示通过原点的平面，在其附近失效；默认采用总体最小二乘。</translation>
    </message>
    <message>
        <source>Eq 8 is a standard deviation of the mean of repeats. The paper applies it to different ranges and numbers of points, which are no repeats: the ±10° run dominates, and the noise is counted three times. Here the covariance is that of the chosen experiment.</source>
        <translation>式 8 是重复测量平均值的标准偏差。论文将其用于不同范围和点数，它们并非重复：±10° 的测次占主导，噪声被计算三次。此处的协方差是所选实验的。</translation>
    </message>
    <message>
        <source>The standard deviation falls with the square of the range (factor 30 from ±10° to ±60°) and with the root of the number of points.</source>
        <translation>标准偏差随范围的平方下降（从 ±10° 到 ±60° 为 30 倍），随点数的平方根下降。</translation>
    </message>
    <message>
        <source>Parameters are strongly correlated (d_3 and alpha_3: −0.99): use their full covariance, as an identified robot does.</source>
        <translation>参数强烈相关（d_3 和 alpha_3：−0.99）：请如辨识的机器人那样使用其全协方差。</translation>
    </message>
    <message>
        <source>Every joint needs a ball off its axis; at the paper&apos;s flange origin joint 6 draws no circle.</source>
        <translation>每个关节都需要在其轴外的球；在论文的法兰原点处，关节 6 不画圆。</translation>
    </message>
    <message>
        <source>Geometric parameters of a serial robot by least squares from measured positions or poses of its tool, with observability, residuals and validation.</source>
        <translation>由实测的工具位置或位姿按最小二乘法求串联机器人的几何参数，含可观测性、残差和验证。</translation>
    </message>
    <message>
        <source>The paper identifies parameters by joint trajectories; least squares on measured positions or poses is the other usual way, with the same model of the arm (Eq 5).</source>
        <translation>论文由关节轨迹辨识参数；对实测的位置或位姿作最小二乘是另一种常用方法，机械臂的模型相同（式 5）。</translation>
    </message>
    <message>
        <source>Parameters that the poses cannot tell are found by their columns of the Jacobian: each that is a combination of those before it (base, then ball or tool, then joint by joint) stays nominal and is named with its partners.</source>
        <translation>位姿不能得出的参数由其雅可比矩阵的列找出：凡为其前者（基座，然后球或工具，然后逐个关节）组合的参数保持标称值，并与其相关者一起列出。</translation>
    </message>
    <message>
        <source>Weights are the inverse variances of the measured coordinates. Shared deviations of an instrument and the readings of the joints do not change the weights, but are propagated in full.</source>
        <translation>权为实测坐标方差的倒数。仪器的共有偏差和关节的读数不改变权，但完整传播。</translation>
    </message>
    <message>
        <source>In each trial the gain of the estimates is used. It differs from a complete fit by residual times curvature, below 1e-9 m here.</source>
        <translation>每次试验使用估计值处的增益。它与完整拟合相差残差乘以曲率，此处小于 1e-9 m。</translation>
    </message>
    <message>
        <source>Position alone does not tell the last joint&apos;s parameters from the place of the ball; a known base and a known ball leave more to find.</source>
        <translation>仅由位置不能区分最后一个关节的参数与球的位置；已知的基座和已知的球可使更多参数得以求出。</translation>
    </message>
    <message>
        <source>The uncertainty of each channel of a multi-axis force/moment sensor, used alone or while unknown loads act on its other axes; by the GUM, with the paper&apos;s evaluation beside it.</source>
        <translation>多轴力/力矩传感器各通道的不确定度，单独使用或有未知载荷作用于其他轴时；按 GUM，并附论文的评定。</translation>
    </message>
    <message>
        <source>U of the paper: 0.91, 1.22, 1.67, 1.68, 2.78, 1.20 % of rated output: reproduces.</source>
        <translation>论文的 U：额定输出的 0.91, 1.22, 1.67, 1.68, 2.78, 1.20 %：重现。</translation>
    </message>
    <message>
        <source>By the GUM (k = 2) with unknown loads on the other five axes: 1.446, 1.425, 2.123, 2.637, 2.990, 1.388 %. With all others at rated load interference alone reaches 2.70, 2.12, 3.33, 4.59, 3.70, 2.27 %, more than U of the paper for all six: its linear sum is no bound.</source>
        <translation>按 GUM（k = 2），其他五轴有未知载荷时：1.446, 1.425, 2.123, 2.637, 2.990, 1.388 %。其他各轴均为额定载荷时，仅干扰即达 2.70, 2.12, 3.33, 4.59, 3.70, 2.27 %，六个轴均超过论文的 U：其线性和不是界限。</translation>
    </message>
    <message>
        <source>Monte Carlo intervals are a little shorter than k = 2 because a few rectangular loads dominate.</source>
        <translation>蒙特卡洛区间比 k = 2 稍短，因为少数矩形分布的载荷占主导。</translation>
    </message>
    <message>
        <source>The load on an axis is one quantity in the equations of all channels, which correlates them.</source>
        <translation>一个轴上的载荷在所有通道的方程中是同一个量，使各通道相关。</translation>
    </message>
    <message>
        <source>With n = 3 a standard deviation has two degrees of freedom. Used alone a channel has effective degrees of freedom between 20 and 140, because its repeatability is a small part.</source>
        <translation>n = 3 时标准偏差有两个自由度。单独使用时，通道的有效自由度在 20 和 140 之间，因为其重复性只占一小部分。</translation>
    </message>
    <message>
        <source>Not covered: misalignment of the loads, creep, temperature, remounting.</source>
        <translation>未涵盖：载荷的不对中、蠕变、温度、重新安装。</translation>
    </message>
    <message>
        <source>Forces and moments that act together, from the readings of all channels of a multi-axis sensor: the calibration matrix takes the interference between them away.</source>
        <translation>由多轴传感器所有通道的读数得出共同作用的力和力矩：校准矩阵消除其间的干扰。</translation>
    </message>
    <message>
        <source>Kim prints no signs of the interference: nothing can be compensated from the paper. The readings of the example have signs of their own.</source>
        <translation>Kim 没有给出干扰的符号：由论文不能作任何补偿。示例的读数有其自己的符号。</translation>
    </message>
    <message>
        <source>U (k = 2) in % of rated load with all six axes at rated load: 0.184, 0.192, 0.152, 0.226, 0.219, 0.261; without load 0.149, 0.159, 0.144, 0.188, 0.179, 0.180. Compensation lowers the uncertainty under combined loads by a factor of 5 to 13 against U of the paper.</source>
        <translation>六轴均为额定载荷时 U (k = 2) 占额定载荷的 %：0.184, 0.192, 0.152, 0.226, 0.219, 0.261；无载荷时 0.149, 0.159, 0.144, 0.188, 0.179, 0.180。与论文的 U 相比，补偿使复合载荷下的不确定度降低 5 至 13 倍。</translation>
    </message>
    <message>
        <source>Without compensation the same loads are told wrong by -0.73, +2.05, -1.42, -2.72, +2.90, -1.54 %.</source>
        <translation>不补偿时，同样的载荷误差为 -0.73, +2.05, -1.42, -2.72, +2.90, -1.54 %。</translation>
    </message>
    <message>
        <source>The machine&apos;s deviation is common to all readings under one load: a column of the matrix, and so a scale of the load on that axis.</source>
        <translation>校准机的偏差为一个载荷下所有读数所共有：矩阵的一列，即该轴上载荷的尺度。</translation>
    </message>
    <message>
        <source>Repeatability is that of one reading, the largest of the steps; hysteresis is rectangular over the loop, in proportion to the load.</source>
        <translation>重复性是单次读数的重复性，取各级中最大者；滞后在回线上为矩形分布，与载荷成比例。</translation>
    </message>
    <message>
        <source>Not covered: products of loads in the interference, misalignment of loads, creep, temperature, remounting.</source>
        <translation>未涵盖：干扰中载荷的乘积、载荷的不对中、蠕变、温度、重新安装。</translation>
    </message>
    <message>
        <source>Sensitivity coefficients are exact (automatic differentiation); those of unknowns that equations define implicitly follow JCGM 102 6.3.</source>
        <translation>灵敏系数是精确的（自动微分）；方程隐式定义的未知数按 JCGM 102 6.3 处理。</translation>
    </message>
    <message>
        <source>JCGM 100 H.1, H.2 and JCGM 101 9.2 to 9.5, JCGM 102 9.2 to 9.4 are examples in projects/gum: covaria verify holds them against their published values.</source>
        <translation>JCGM 100 H.1、H.2，JCGM 101 9.2 至 9.5，JCGM 102 9.2 至 9.4 为 projects/gum 中的示例：covaria verify 将其与发表的值比对。</translation>
    </message>
    <message>
        <source>A straight line or polynomial through the points of a calibration by least squares, with uncertainties in y and in x: the covariance of its coefficients, its values, and the x that belong to observed y, with their uncertainties.</source>
        <translation>用最小二乘法通过校准各点的直线或多项式，y 和 x 都有不确定度：其系数的协方差、其值，以及与观测的 y 对应的 x 及其不确定度。</translation>
    </message>
    <message>
        <source>Computed with polynomials that are orthonormal over the points, so results do not depend on the origin, up to degree 10. From the residuals their coefficients are drawn from a multivariate t distribution: one estimate of the scatter, n - p degrees of freedom for every result.</source>
        <translation>用在各点上正交归一的多项式计算，因此结果不取决于原点，最高 10 次。由残差得出时，其系数由多元 t 分布抽取：对所有结果只有一个分散性的估计，自由度为 n - p。</translation>
    </message>
    <message>
        <source>JCGM 100 H.3, published y₁ = −0.1712 °C, y₂ = 0.002 18, u(y₁) = 0.0029 °C, u(y₂) = 0.000 67, b(30 °C) = −0.1494 °C with u = 0.0041 °C: reproduces.</source>
        <translation>JCGM 100 H.3，发表值 y₁ = −0.1712 °C、y₂ = 0.002 18、u(y₁) = 0.0029 °C、u(y₂) = 0.000 67、b(30 °C) = −0.1494 °C 且 u = 0.0041 °C：重现。</translation>
    </message>
    <message>
        <source>The uncertainty of b(x) is that of the curve: the scatter of a further observation is not part of it.</source>
        <translation>b(x) 的不确定度是曲线的不确定度：不包括另一个观测值的分散性。</translation>
    </message>
    <message>
        <source>The mean of observations made on several days, with several instruments or by several operators, and an analysis of variance that says whether these have an effect.</source>
        <translation>在若干天、用若干仪器或由若干操作者所得观测值的平均值，以及说明这些因素是否有影响的方差分析。</translation>
    </message>
    <message>
        <source>Groups may have different numbers of observations; n_0 = (N − Σ n_j²/N)/(J − 1) is then their size in the components of variance.</source>
        <translation>各组的观测次数可以不同；方差分量中它们的大小为 n_0 = (N − Σ n_j²/N)/(J − 1)。</translation>
    </message>
    <message>
        <source>JCGM 100 H.5, published V̄ = 10.000 097 V, s(V̄_j) = 57 µV, s_b = 85 µV, u(V̄) = 18 µV with nine degrees of freedom, or 13 µV with 49 without an effect of the days: reproduces.</source>
        <translation>JCGM 100 H.5，发表值 V̄ = 10.000 097 V、s(V̄_j) = 57 µV、s_b = 85 µV、u(V̄) = 18 µV 且自由度为九，或无日间影响时 13 µV 且自由度为 49：重现。</translation>
    </message>
    <message>
        <source>A plate or frame with calibrated nests, measured repeatedly where the real points will be. Its errors of indication give the uncertainty of each coordinate of a measured point.</source>
        <translation>带已校准靶座的板或框架，在实际点所在处重复测量。其示值误差给出实测点每个坐标的不确定度。</translation>
    </message>
    <message>
        <source>u_i² = u_cal² + u_var,i² + u_T,i² + b_i² (Eq 2) with u_T = L_max α ΔT/√3 (Eq 3).</source>
        <translation>u_i² = u_cal² + u_var,i² + u_T,i² + b_i²（式 2），其中 u_T = L_max α ΔT/√3（式 3）。</translation>
    </message>
    <message>
        <source>The paper draws all parts independently for each point; calibration, temperature and bias are in truth common to all points, which can be chosen.</source>
        <translation>论文对每个点独立抽取所有部分；校准、温度和偏移实际上为所有点所共有，可以选择。</translation>
    </message>
    <message>
        <source>The noise of the three points that define the artefact&apos;s frame is part of the errors of the others; the errors of the defining coordinates themselves are never observed.</source>
        <translation>定义实物标准器坐标系的三个点的噪声是其他点误差的一部分；定义坐标本身的误差从未被观测到。</translation>
    </message>
    <message>
        <source>A bar of calibrated length, measured in many positions and orientations. Its errors of indication give one figure for every coordinate of a measured point.</source>
        <translation>已校准长度的杆，在许多位置和姿态测量。其示值误差为实测点的每个坐标给出一个数值。</translation>
    </message>
    <message>
        <source>u² = u_cal² + u_var² + u_T² + b² (Eq 5) with u_T = L α ΔT/√3 (Eq 6).</source>
        <translation>u² = u_cal² + u_var² + u_T² + b²（式 5），其中 u_T = L α ΔT/√3（式 6）。</translation>
    </message>
    <message>
        <source>A length is a difference of two points: dividing by √2 would be consistent; the paper does not.</source>
        <translation>长度是两点之差：除以 √2 才一致；论文没有这样做。</translation>
    </message>
    <message>
        <source>A sensor that stands somewhere and reads a distance, two angles, or some of them. Its uncertainty: each reading for itself, what all its readings share, and where it stands.</source>
        <translation>位于某处的传感器，读取距离、两个角度或其中一些。其不确定度：每个读数自身的、所有读数共有的，以及它所在位置的。</translation>
    </message>
    <message>
        <source>The distance has the figure a + b L, each angle its own; these are independent from reading to reading. Scale, zero, index, collimation, squareness, beam offset and refraction are shared by all readings.</source>
        <translation>距离的数值为 a + b L，每个角度各有其值；它们在各读数间独立。尺度、零点、指标差、视准差、轴系垂直度、光束偏移和折光为所有读数所共有。</translation>
    </message>
    <message>
        <source>Only a sensor that reads a distance and both angles can say by itself where a point is.</source>
        <translation>只有读取距离和两个角度的传感器才能单独得出点的位置。</translation>
    </message>
    <message>
        <source>Instruments of the project that measure the same points together. Points measured by the network keep what they share: the scale and the station of each instrument.</source>
        <translation>项目中一起测量相同点的若干仪器。由网络测得的点保留其共有部分：每台仪器的尺度和测站。</translation>
    </message>
    <message>
        <source>A point&apos;s deviations are the least-squares gain times those of the readings and stations, linearised at the point: exact to first order, and in Monte Carlo as long as the angles&apos; deviations stay below about a milliradian.</source>
        <translation>点的偏差是最小二乘增益乘以读数和测站的偏差，在该点线性化：一阶精确；在蒙特卡洛中，只要角度偏差小于约一毫弧度即成立。</translation>
    </message>
    <message>
        <source>All points that an analysis takes from the network are measured from one set-up: none of its instruments is moved or located anew between them.</source>
        <translation>分析取自网络的所有点由一次设站测量：其间没有仪器移动或重新定位。</translation>
    </message>
    <message>
        <source>A sensor contributes to a point that is in its range and field of view, and no others.</source>
        <translation>传感器只对位于其测程和视场内的点作贡献。</translation>
    </message>
    <message>
        <source>One figure of a data sheet for all coordinates: a standard uncertainty or a maximum permissible error.</source>
        <translation>数据表中对所有坐标的一个数值：标准不确定度或最大允许误差。</translation>
    </message>
    <message>
        <source>A specification taken alike in all directions overestimates, by a factor of 2 to 5 in the paper&apos;s example; an instrument that stands somewhere (spherical instrument) is closer to the truth.</source>
        <translation>在所有方向相同的技术指标会高估，在论文的示例中为 2 至 5 倍；位于某处的仪器（球坐标仪器）更接近实际。</translation>
    </message>
    <message>
        <source>Three or more telescopic ballbars that measure the lengths from their supports to one ball at once, and with it where the ball is.</source>
        <translation>三个或更多伸缩式球杆仪同时测量从其支座到一个球的长度，从而得出球的位置。</translation>
    </message>
    <message>
        <source>The supports&apos; frame follows from the lengths between them (Eqs 4 to 7), measured once: their deviations are common to all points.</source>
        <translation>支座的坐标系由它们之间的长度得出（式 4 至 7），只测量一次：其偏差为所有点所共有。</translation>
    </message>
    <message>
        <source>Eq 2 as printed has Y_VC3; Y_KS3 is meant. Eq 3 has two roots; the side is a choice here.</source>
        <translation>式 2 原文为 Y_VC3；应为 Y_KS3。式 3 有两个根；此处可选择所在的一侧。</translation>
    </message>
    <message>
        <source>The paper&apos;s supports are called an equilateral triangle of 520 mm; its Table 1 is isosceles, 520 mm and 519.711 mm.</source>
        <translation>论文称支座为 520 mm 的等边三角形；其表 1 为等腰，520 mm 和 519.711 mm。</translation>
    </message>
    <message>
        <source>A fourth support and those after it are located by their lengths to the first three at a height that is an input of its own: lengths say nothing about a height above the plane in which all supports lie.</source>
        <translation>第四个及其后的支座由其到前三个支座的长度定位，其高度为单独的输入：对于所有支座所在平面之上的高度，长度不能给出任何信息。</translation>
    </message>
    <message>
        <source>A robot as a source of uncertainty: each time it goes to a pose it misses it by a distance in a random direction, and perhaps by small rotations.</source>
        <translation>机器人作为不确定度的来源：每次到达位姿时，它在随机方向上偏离一段距离，也可能有小的旋转。</translation>
    </message>
    <message>
        <source>The paper takes the distance as rectangular in [0, r], r being the data sheet&apos;s ± 0.02 mm; u along an axis is then r/3. RP of ISO 9283 is the mean distance plus three standard deviations, which is another figure: for that law RP = 1.366 r, in a ball 1.331 r, on a sphere r, and 3.616 u for normal coordinates.</source>
        <translation>论文取距离在 [0, r] 上为矩形分布，r 为数据表的 ± 0.02 mm；于是沿轴的 u 为 r/3。ISO 9283 的 RP 是平均距离加三倍标准偏差，为另一数值：对该分布 RP = 1.366 r，在球内 1.331 r，在球面上 r，对正态坐标为 3.616 u。</translation>
    </message>
    <message>
        <source>The paper leaves the orientation out. A rotation by e moves the tool by about e times its length.</source>
        <translation>论文不计姿态。旋转 e 使工具移动约 e 乘以其长度。</translation>
    </message>
    <message>
        <source>An arm of joints that turn or slide: parameters in a Denavit-Hartenberg convention with one or more components of uncertainty each, their correlation, limits, encoders, base and tool.</source>
        <translation>由转动或移动关节构成的机械臂：Denavit-Hartenberg 约定下的参数，每个有一个或多个不确定度分量，及其相关、限位、编码器、基座和工具。</translation>
    </message>
    <message>
        <source>Eq. 5: T = Rz(theta) Tz(d) Tx(a) Rx(alpha) Ry(beta). Where an axis is parallel to the next, beta is a parameter and d is 0 by definition; elsewhere beta is 0.</source>
        <translation>式 5：T = Rz(theta) Tz(d) Tx(a) Rx(alpha) Ry(beta)。轴与下一轴平行时，beta 为参数，d 按定义为 0；其他情况 beta 为 0。</translation>
    </message>
    <message>
        <source>alpha and beta of a row turn the axis of the joint into that of the next (the paper&apos;s text shifts them by one joint).</source>
        <translation>一行的 alpha 和 beta 将该关节的轴转到下一关节的轴（论文正文错开了一个关节）。</translation>
    </message>
    <message>
        <source>The joint angle is theta plus the reading less the zero reading; a sliding joint adds its reading to d in the same way.</source>
        <translation>关节角为 theta 加读数减零位读数；移动关节以同样方式将其读数加到 d。</translation>
    </message>
    <message>
        <source>Loads a multi-axis force/moment sensor with one force or moment at a time.</source>
        <translation>每次以一个力或力矩对多轴力/力矩传感器加载。</translation>
    </message>
    <message>
        <source>The uncertainty of a load is common to all readings under loads on that axis: it does not average out in the calibration matrix.</source>
        <translation>载荷的不确定度为该轴载荷下所有读数所共有：它在校准矩阵中不会平均掉。</translation>
    </message>
    <message>
        <source>Up to three forces and three moments measured at once; calibrated with one load at a time, evaluated from its readings.</source>
        <translation>同时测量最多三个力和三个力矩；每次以一个载荷校准，由其读数评定。</translation>
    </message>
    <message>
        <source>Tables 1 to 4 reproduce from raw readings that are consistent with them, to the printed digits, with relative uncertainties of the machine of 8.6e-4, 8.7e-4, 1.2e-5, 8.7e-4, 8.6e-4 and 1.7e-3.</source>
        <translation>表 1 至 4 由与之一致的原始读数重现到印出的位数，校准机的相对不确定度为 8.6e-4, 8.7e-4, 1.2e-5, 8.7e-4, 8.6e-4 和 1.7e-3。</translation>
    </message>
    <message>
        <source>Type B, Table 3: differs for five of six sensors, because the stated uncertainties of the machine (2.1e-4, 1.8e-4, 1.2e-5, 3.1e-4, 2.9e-4, 2.4e-4) give 0.16, 0.23, 0.28, 0.31, 0.30, 0.36 µV/V and not 0.27, 0.31, 0.28, 0.41, 0.40, 0.62. The list equals the Type A column in five places: most likely copied there.</source>
        <translation>B 类，表 3：六个传感器中五个不同，因为给出的校准机不确定度（2.1e-4, 1.8e-4, 1.2e-5, 3.1e-4, 2.9e-4, 2.4e-4）给出 0.16, 0.23, 0.28, 0.31, 0.30, 0.36 µV/V，而不是 0.27, 0.31, 0.28, 0.41, 0.40, 0.62。该列有五处与 A 类列相同：很可能是抄自那里。</translation>
    </message>
    <message>
        <source>Table 4, Mx under Fy: differs, printed 1.55 %, is 0.15 %; the largest for Mx is 1.38 %, and the difference to its U 0.30 %, not 0.13 %.</source>
        <translation>表 4，Fy 下的 Mx：不同，印为 1.55 %，应为 0.15 %；Mx 的最大值为 1.38 %，与其 U 之差为 0.30 %，不是 0.13 %。</translation>
    </message>
    <message>
        <source>Section 2.5 calls e_12 the output of Fy under Fx, but Table 4 divides by the rated output of the row: a row is taken as a sensor.</source>
        <translation>第 2.5 节称 e_12 为 Fx 下 Fy 的输出，但表 4 除以该行的额定输出：一行视为一个传感器。</translation>
    </message>
    <message>
        <source>Eq 12 adds hysteresis and interference, limits that are not standard uncertainties, to an expanded uncertainty: the sum is neither a standard uncertainty nor a coverage interval.</source>
        <translation>式 12 将滞后和干扰（并非标准不确定度的界限）加到扩展不确定度上：其和既不是标准不确定度也不是包含区间。</translation>
    </message>
    <message>
        <source>The largest values of Type A and Type B need not occur at the same step. Eq 5 takes the rated output at every step. In 2.1.1 &quot;h=2&quot; of My and Mz is a slip.</source>
        <translation>A 类和 B 类的最大值不一定出现在同一级。式 5 在每一级取额定输出。2.1.1 中 My 和 Mz 的“h=2”是笔误。</translation>
    </message>
    <message>
        <source>A surface from an STL file - the robot cell, the part, the fixture, the room - that is drawn in the scenes of all analyses. It is context only: no number depends on it.</source>
        <translation>STL 文件中的表面（机器人工作单元、工件、夹具、房间），绘制在所有分析的场景中。它仅为环境：没有数值取决于它。</translation>
    </message>
    <message>
        <source>The picture is fitted to what is measured, not to the mesh, which may be a whole hall.</source>
        <translation>画面按所测量的内容缩放，而不是按网格，因为网格可能是整个厂房。</translation>
    </message>
    <message>
        <source>A file that is missing or damaged is warned of; analyses keep their results.</source>
        <translation>文件缺失或损坏时给出警告；分析保留其结果。</translation>
    </message>
    <message>
        <source>Of the certificate and the report; what was typed stays as it is.</source>
        <translation>证书和报告的语言；所输入的内容保持不变。</translation>
    </message>
    <message>
        <source>distributions of %1</source>
        <translation>%1 的分布</translation>
    </message>
    <message>
        <source>and %1 more like these</source>
        <translation>以及另外 %1 个类似的</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was not written: %2: %3</source>
        <translation>&apos;%1&apos; 没有写入：%2：%3</translation>
    </message>
    <message>
        <source>it cannot be opened</source>
        <translation>不能打开</translation>
    </message>
    <message>
        <source>writing failed</source>
        <translation>写入失败</translation>
    </message>
    <message>
        <source>closing failed</source>
        <translation>关闭失败</translation>
    </message>
    <message>
        <source>a file cannot be created in its folder &apos;%1&apos;</source>
        <translation>不能在其文件夹 &apos;%1&apos; 中创建文件</translation>
    </message>
    <message>
        <source>the permissions of the old file cannot be kept</source>
        <translation>不能保留旧文件的权限</translation>
    </message>
    <message>
        <source>flushing to the disk failed</source>
        <translation>写入磁盘失败</translation>
    </message>
    <message>
        <source>the new file cannot take its place</source>
        <translation>新文件不能取代原文件</translation>
    </message>
    <message>
        <source>a folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>a pipe</source>
        <translation>管道</translation>
    </message>
    <message>
        <source>a socket</source>
        <translation>套接字</translation>
    </message>
    <message>
        <source>a device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be read: %2</source>
        <translation>不能读取 &apos;%1&apos;：%2</translation>
    </message>
    <message>
        <source>it is %1, not a file</source>
        <translation>它是%1，不是文件</translation>
    </message>
    <message>
        <source>it is not a file</source>
        <translation>它不是文件</translation>
    </message>
    <message>
        <source>it is too large: files of up to %1 MB are read, it has %2 MB</source>
        <translation>它过大：可读取不超过 %1 MB 的文件，它有 %2 MB</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>它是文件夹</translation>
    </message>
    <message>
        <source>unit &quot;%1&quot;: %2</source>
        <translation>单位“%1”：%2</translation>
    </message>
    <message>
        <source>a parenthesis is closed that was not opened.</source>
        <translation>关闭了没有打开的括号。</translation>
    </message>
    <message>
        <source>write a product with &apos;*&apos; (&quot;N*m&quot;, &quot;W/(m*K)&quot;), not with a blank.</source>
        <translation>乘积请用 &apos;*&apos;（&quot;N*m&quot;、&quot;W/(m*K)&quot;），不要用空格。</translation>
    </message>
    <message>
        <source>a parenthesis is not closed.</source>
        <translation>有括号没有关闭。</translation>
    </message>
    <message>
        <source>the exponent must be a whole number between -9 and 9, not 0 (&quot;mm^2&quot;).</source>
        <translation>指数必须是 -9 到 9 之间不为 0 的整数（&quot;mm^2&quot;）。</translation>
    </message>
    <message>
        <source>the exponents are too large.</source>
        <translation>指数过大。</translation>
    </message>
    <message>
        <source>a unit is missing beside &apos;*&apos;, &apos;/&apos; or a parenthesis.</source>
        <translation>&apos;*&apos;、&apos;/&apos; 或括号旁缺少单位。</translation>
    </message>
    <message>
        <source>numbers other than 1 do not belong in a unit; put them into the value.</source>
        <translation>单位中不应有 1 以外的数字；请将其并入数值。</translation>
    </message>
    <message>
        <source>the unit &quot;%1&quot; is not known.%2</source>
        <translation>未知单位“%1”。%2</translation>
    </message>
    <message>
        <source>the text is too long for a unit.</source>
        <translation>该文本作为单位过长。</translation>
    </message>
    <message>
        <source>the unit is empty: write &quot;1&quot; for a pure number.</source>
        <translation>单位为空：纯数请写 &quot;1&quot;。</translation>
    </message>
    <message>
        <source> Known units, most of them with the prefixes of the SI: %1.</source>
        <translation> 已知单位（大多可加 SI 词头）：%1。</translation>
    </message>
    <message>
        <source> Did you mean %1?</source>
        <translation> 是否指 %1？</translation>
    </message>
    <message>
        <source> Did you mean %1 or %2?</source>
        <translation> 是否指 %1 或 %2？</translation>
    </message>
    <message>
        <source>the attached file &apos;%1&apos; is broken</source>
        <translation>附件 &apos;%1&apos; 已损坏</translation>
    </message>
    <message>
        <source>the coverage probability must lie between 0 and 1.</source>
        <translation>包含概率必须在 0 和 1 之间。</translation>
    </message>
    <message>
        <source>the effective degrees of freedom must be greater than 0.</source>
        <translation>有效自由度必须大于 0。</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is defined by itself here, directly or through other definitions; an equation that is to be solved is written &apos;solve %1 = 1: ... = ...&apos;, with a starting value</source>
        <translation>&apos;%1&apos; 在此直接或通过其他定义由自身定义；要求解的方程写作 &apos;solve %1 = 1: ... = ...&apos;，并给出初值</translation>
    </message>
    <message>
        <source>the expression in columns %1-%2</source>
        <translation>第 %1-%2 列的表达式</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither defined nor one of the quantities: give it a row in the table of quantities</source>
        <translation>&apos;%1&apos; 既未定义，也不在各量之中：请在量的表中为它添加一行</translation>
    </message>
    <message>
        <source>%1 is a difference of temperatures: its unit is K, not %2</source>
        <translation>%1 是温度差：其单位是 K，不是 %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; would be a condition: a definition must give a number</source>
        <translation>&apos;%1&apos; 会成为条件：定义必须给出数值</translation>
    </message>
    <message>
        <source>%1 is %2, %3 is %4: they cannot be equal</source>
        <translation>%1 为%2，%3 为%4：它们不能相等</translation>
    </message>
    <message>
        <source>the equations do not depend on the unknown &apos;%1&apos;</source>
        <translation>方程不取决于未知数 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>this equation does not depend on any unknown</source>
        <translation>此方程不取决于任何未知数</translation>
    </message>
    <message>
        <source>this constant has no value (division by zero, or root of a negative number)</source>
        <translation>此常数没有值（除以零，或负数的根）</translation>
    </message>
    <message>
        <source>no equation defines &apos;%1&apos;</source>
        <translation>没有方程定义 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is to be given in %2, but is %3</source>
        <translation>&apos;%1&apos; 要以 %2 给出，但它是%3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is %2, which has no unit of its own</source>
        <translation>&apos;%1&apos; 为%2，没有自己的单位</translation>
    </message>
    <message>
        <source>%1 is %2, %3 is %4</source>
        <translation>%1 为%2，%3 为%4</translation>
    </message>
    <message>
        <source>they cannot be added</source>
        <translation>它们不能相加</translation>
    </message>
    <message>
        <source>they cannot be subtracted</source>
        <translation>它们不能相减</translation>
    </message>
    <message>
        <source>%1 is %2: %3</source>
        <translation>%1 为%2：%3</translation>
    </message>
    <message>
        <source>the exponent %1 is %2: an exponent must be a pure number</source>
        <translation>指数 %1 为%2：指数必须是纯数</translation>
    </message>
    <message>
        <source>%1 is %2: its exponent must be a constant, or the dimension would vary</source>
        <translation>%1 为%2：其指数必须是常数，否则量纲会变化</translation>
    </message>
    <message>
        <source>atan2 needs two quantities of one kind</source>
        <translation>atan2 需要两个同类的量</translation>
    </message>
    <message>
        <source>a function of both needs quantities of one kind</source>
        <translation>两者的函数需要同类的量</translation>
    </message>
    <message>
        <source>sin, cos and tan need an angle or a pure number</source>
        <translation>sin、cos 和 tan 需要角度或纯数</translation>
    </message>
    <message>
        <source>an inverse function of an angle needs a pure number</source>
        <translation>角度的反函数需要纯数</translation>
    </message>
    <message>
        <source>this function needs a pure number: divide by a quantity of the same kind</source>
        <translation>此函数需要纯数：请除以同类的量</translation>
    </message>
    <message>
        <source>they cannot be compared</source>
        <translation>它们不能比较</translation>
    </message>
    <message>
        <source>%1 is not a condition: write a comparison, as in x &gt; 0</source>
        <translation>%1 不是条件：请写比较，如 x &gt; 0</translation>
    </message>
    <message>
        <source>a condition</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>a pure number</source>
        <translation>纯数</translation>
    </message>
    <message>
        <source>measured in %1</source>
        <translation>以 %1 计量的量</translation>
    </message>
    <message>
        <source>%1 is a temperature in degC, %2 a difference of temperatures: give differences in K</source>
        <translation>%1 是以 degC 表示的温度，%2 是温度差：温度差请以 K 给出</translation>
    </message>
    <message>
        <source>%1 is a temperature in degC, and 0 has no unit: write 0 [degC], or 0 [K] for absolute zero</source>
        <translation>%1 是以 degC 表示的温度，而 0 没有单位：请写 0 [degC]，绝对零度请写 0 [K]</translation>
    </message>
    <message>
        <source>%1 is a sum of temperatures in degC, which means nothing: give differences in K, or divide the sum by the number of temperatures for their mean</source>
        <translation>%1 是以 degC 表示的温度之和，没有意义：温度差请以 K 给出，求平均值请将和除以温度的个数</translation>
    </message>
    <message>
        <source>%1 is not a condition: write a comparison, as in if(x &gt; 0, x, 0)</source>
        <translation>%1 不是条件：请写比较，如 if(x &gt; 0, x, 0)</translation>
    </message>
    <message>
        <source>both values of &apos;if&apos; must be numbers, not conditions</source>
        <translation>&apos;if&apos; 的两个值必须是数值，不是条件</translation>
    </message>
    <message>
        <source>both values of &apos;if&apos; must be of one kind</source>
        <translation>&apos;if&apos; 的两个值必须同类</translation>
    </message>
    <message>
        <source>%1 is a condition: use it as the first argument of if(...)</source>
        <translation>%1 是条件：请将其用作 if(...) 的第一个参数</translation>
    </message>
    <message>
        <source>the end of the equation</source>
        <translation>方程的末尾</translation>
    </message>
    <message>
        <source>%1 is not a function; to multiply, write &apos;*&apos;. Functions are: %2</source>
        <translation>%1 不是函数；相乘请写 &apos;*&apos;。函数有：%2</translation>
    </message>
    <message>
        <source>%1 needs %2 arguments; here it has %3</source>
        <translation>%1 需要 %2 个参数；此处有 %3 个</translation>
    </message>
    <message>
        <source>%1 needs %2 to %3 arguments; here it has %4</source>
        <translation>%1 需要 %2 至 %3 个参数；此处有 %4 个</translation>
    </message>
    <message>
        <source>&apos;+&apos; stands here twice</source>
        <translation>&apos;+&apos; 在此出现两次</translation>
    </message>
    <message>
        <source>the expression is nested more than %1 levels deep: split it into definitions</source>
        <translation>该表达式嵌套超过 %1 层：请拆分为定义</translation>
    </message>
    <message>
        <source>a unit in brackets belongs behind a number: 20 [degC]</source>
        <translation>方括号中的单位应在数字之后：20 [degC]</translation>
    </message>
    <message>
        <source>a number, a name or a parenthesis is expected here, not %1</source>
        <translation>此处应为数字、名称或括号，而不是 %1</translation>
    </message>
    <message>
        <source>this parenthesis is not closed</source>
        <translation>此括号没有关闭</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a function: its argument follows in parentheses</source>
        <translation>&apos;%1&apos; 是函数：其参数在其后的括号中</translation>
    </message>
    <message>
        <source>the word &apos;%1&apos; is not expected here</source>
        <translation>此处不应有关键字 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>an operator, a comma or &apos;)&apos; is expected here, not %1</source>
        <translation>此处应为运算符、逗号或 &apos;)&apos;，而不是 %1</translation>
    </message>
    <message>
        <source>this parenthesis closes nothing</source>
        <translation>此括号没有对应的开括号</translation>
    </message>
    <message>
        <source>an equation defines one name: write &apos;y = ...&apos;; to compare, write &apos;==&apos;; an equation that is to be solved starts with &apos;solve&apos;</source>
        <translation>一个方程定义一个名称：请写 &apos;y = ...&apos;；比较请写 &apos;==&apos;；要求解的方程以 &apos;solve&apos; 开头</translation>
    </message>
    <message>
        <source>an operator is missing before %1</source>
        <translation>%1 之前缺少运算符</translation>
    </message>
    <message>
        <source>%1 is not expected here</source>
        <translation>此处不应有 %1</translation>
    </message>
    <message>
        <source>an equation starts with the name that it defines: y = ...</source>
        <translation>方程以其所定义的名称开头：y = ...</translation>
    </message>
    <message>
        <source>a name with its starting value is expected here: y = 1</source>
        <translation>此处应为带初值的名称：y = 1</translation>
    </message>
    <message>
        <source>a function</source>
        <translation>函数</translation>
    </message>
    <message>
        <source>a word of the language</source>
        <translation>方程语言的关键字</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is %2: choose another name</source>
        <translation>&apos;%1&apos; 是%2：请另选名称</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is defined twice</source>
        <translation>&apos;%1&apos; 定义了两次</translation>
    </message>
    <message>
        <source>a colon is expected before the equations to be solved: solve y = 1: y^2 = x</source>
        <translation>要求解的方程之前应有冒号：solve y = 1: y^2 = x</translation>
    </message>
    <message>
        <source>%1 unknowns need as many equations; there are %2</source>
        <translation>%1 个未知数需要同样多的方程；现有 %2 个</translation>
    </message>
    <message>
        <source>an equals sign is expected in an equation to be solved</source>
        <translation>要求解的方程中应有等号</translation>
    </message>
    <message>
        <source>line %1, column %2: </source>
        <translation>第 %1 行第 %2 列： </translation>
    </message>
    <message>
        <source>line %1, columns %2-%3: </source>
        <translation>第 %1 行第 %2-%3 列： </translation>
    </message>
    <message>
        <source>this number is too large or too small to compute with</source>
        <translation>此数过大或过小，无法计算</translation>
    </message>
    <message>
        <source>the bracket of a unit is not closed: write &apos;]&apos; behind the unit</source>
        <translation>单位的方括号没有关闭：请在单位之后写 &apos;]&apos;</translation>
    </message>
    <message>
        <source>the character &apos;%1&apos; does not belong in an equation</source>
        <translation>字符 &apos;%1&apos; 不应出现在方程中</translation>
    </message>
    <message>
        <source>the equations have %1 characters; more than %2 are not read: put tables of data into assets or observations</source>
        <translation>方程有 %1 个字符；超过 %2 个不读取：请将数据表放入资源或观测值</translation>
    </message>
    <message>
        <source>the coverage factor k must be greater than zero</source>
        <translation>包含因子 k 必须大于零</translation>
    </message>
    <message>
        <source>the coverage probability must lie between 0 and 100 %</source>
        <translation>包含概率必须在 0 和 100 % 之间</translation>
    </message>
    <message>
        <source>the limits give the estimate: leave the value empty, or state a half-width</source>
        <translation>界限给出估计值：请将值留空，或给出半宽</translation>
    </message>
    <message>
        <source>the lower limit is above the upper limit</source>
        <translation>下限大于上限</translation>
    </message>
    <message>
        <source>a relative part of the permissible error needs the value of the quantity</source>
        <translation>允许误差的相对部分需要量的值</translation>
    </message>
    <message>
        <source>an exponential distribution needs an estimate greater than zero</source>
        <translation>指数分布需要大于零的估计值</translation>
    </message>
    <message>
        <source>the number of counts must be whole</source>
        <translation>计数必须是整数</translation>
    </message>
    <message>
        <source>the counts give the estimate: leave the value empty</source>
        <translation>计数给出估计值：请将值留空</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not used by this statement: leave it empty</source>
        <translation>此给出方式不使用 &apos;%1&apos;：请留空</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is missing: %2</source>
        <translation>缺少 &apos;%1&apos;：%2</translation>
    </message>
    <message>
        <source>&apos;a&apos; must not be negative</source>
        <translation>&apos;a&apos; 不得为负</translation>
    </message>
    <message>
        <source>give the degrees of freedom or the relative uncertainty of u, not both</source>
        <translation>请给出自由度或 u 的相对不确定度，不要两者都给</translation>
    </message>
    <message>
        <source>the degrees of freedom must be greater than zero</source>
        <translation>自由度必须大于零</translation>
    </message>
    <message>
        <source>the relative uncertainty of u must not be negative</source>
        <translation>u 的相对不确定度不得为负</translation>
    </message>
    <message>
        <source>there is no statement &apos;%1&apos;</source>
        <translation>没有给出方式 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not understood here</source>
        <translation>无法理解此处的 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>a number is missing after &apos;%1&apos;</source>
        <translation>&apos;%1&apos; 之后缺少数字</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no way to state an uncertainty. For example: 75 nm; U = 0.3 um, k = 2; rectangular 0.5; resolution 0.01; constant</source>
        <translation>&apos;%1&apos; 不是给出不确定度的方式。例如：75 nm；U = 0.3 um, k = 2；矩形 0.5；分辨力 0.01；常量</translation>
    </message>
    <message>
        <source>%1 has %2 figure</source>
        <translation>%1 有 %2 个数值</translation>
    </message>
    <message>
        <source>%1 has %2 figures</source>
        <translation>%1 有 %2 个数值</translation>
    </message>
    <message>
        <source>a figure is missing: an expanded uncertainty needs k = ... or p = ... %</source>
        <translation>缺少数值：扩展不确定度需要 k = ... 或 p = ... %</translation>
    </message>
    <message>
        <source>a figure is missing: it is noted as %1</source>
        <translation>缺少数值：写法为 %1</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no part of it: it is noted as %2</source>
        <translation>&apos;%1&apos; 不属于它：写法为 %2</translation>
    </message>
    <message>
        <source>it has no unit</source>
        <translation>它没有单位</translation>
    </message>
    <message>
        <source>the second figure has no unit but %</source>
        <translation>第二个数值除 % 外没有单位</translation>
    </message>
    <message>
        <source>the second figure has no unit</source>
        <translation>第二个数值没有单位</translation>
    </message>
    <message>
        <source>the further part is one in %: write MPE 3 + 0.1 %</source>
        <translation>另一部分以 % 表示：请写 MPE 3 + 0.1 %</translation>
    </message>
    <message>
        <source>say which it is: k = ... or p = ... %</source>
        <translation>请说明是哪一个：k = ... 或 p = ... %</translation>
    </message>
    <message>
        <source>a part of the value needs the value</source>
        <translation>以值的一部分给出时，需要该值</translation>
    </message>
    <message>
        <source>%1 is no unit for a quantity in %2</source>
        <translation>%1 不是以 %2 表示的量的单位</translation>
    </message>
    <message>
        <source>a Type A evaluation needs at least two observations.</source>
        <translation>A 类评定至少需要两个观测值。</translation>
    </message>
    <message>
        <source>one of the observations is not a finite number.</source>
        <translation>有一个观测值不是有限数。</translation>
    </message>
    <message>
        <source>there is no series to be pooled.</source>
        <translation>没有可合并的系列。</translation>
    </message>
    <message>
        <source>the covariance of two means needs observations made in pairs: the series have different lengths.</source>
        <translation>两个平均值的协方差需要成对的观测值：各系列的长度不同。</translation>
    </message>
    <message>
        <source>the covariance of two means needs at least two pairs.</source>
        <translation>两个平均值的协方差至少需要两对。</translation>
    </message>
    <message>
        <source>the components %1 and %2 are given two different correlations; a quantity that combines its components arithmetically needs +1 or -1.</source>
        <translation>分量 %1 和 %2 给出了两个不同的相关；分量按代数相加的量需要 +1 或 -1。</translation>
    </message>
    <message>
        <source>a correlation refers to component number %1 of %2.</source>
        <translation>有相关引用了 %2 个分量中的第 %1 个。</translation>
    </message>
    <message>
        <source>a correlation is given between the component %1 and itself.</source>
        <translation>分量 %1 与自身之间给出了相关。</translation>
    </message>
    <message>
        <source>the correlation of the components %1 and %2 must lie between -1 and 1.</source>
        <translation>分量 %1 和 %2 的相关必须在 -1 和 1 之间。</translation>
    </message>
    <message>
        <source>the quantity &quot;%1&quot; refers to component number %2 of %3.</source>
        <translation>量“%1”引用了 %3 个分量中的第 %2 个。</translation>
    </message>
    <message>
        <source>the correlations of the components %1 contradict each other: the smallest eigenvalue of their correlation matrix is %2, it must not be negative.</source>
        <translation>分量 %1 的相关互相矛盾：其相关矩阵的最小特征值为 %2，不得为负。</translation>
    </message>
    <message>
        <source>the component %1 is a coordinate of a vector of random direction and cannot be correlated with another component; give it a normal distribution first.</source>
        <translation>分量 %1 是随机方向矢量的一个坐标，不能与其他分量相关；请先赋予它正态分布。</translation>
    </message>
    <message>
        <source>the estimate of variance &quot;%1&quot; has component number %2, which does not exist or rests on two estimates.</source>
        <translation>方差估计“%1”有编号为 %2 的分量，它不存在或依据两个估计。</translation>
    </message>
    <message>
        <source>the component %1 rests on the estimate of variance &quot;%2&quot; with others: it needs a normal or Student t distribution and their finite degrees of freedom.</source>
        <translation>分量 %1 与其他分量共同依据方差估计“%2”：它需要正态分布或 t 分布及其有限自由度。</translation>
    </message>
    <message>
        <source>the components %1 and %2 cannot have the correlation %3: with these distributions it lies between %4 and %5.</source>
        <translation>分量 %1 和 %2 的相关不能是 %3：对于这些分布，它在 %4 和 %5 之间。</translation>
    </message>
    <message>
        <source>%1 distribution: %2</source>
        <translation>%1分布：%2</translation>
    </message>
    <message>
        <source>the %1 must be a finite number.</source>
        <translation>%1必须是有限数。</translation>
    </message>
    <message>
        <source>the %1 is too large (at most 1e150).</source>
        <translation>%1过大（至多 1e150）。</translation>
    </message>
    <message>
        <source>the %1 must not be negative.</source>
        <translation>%1不得为负。</translation>
    </message>
    <message>
        <source>the %1 must lie between 0.001 and 1000000.</source>
        <translation>%1必须在 0.001 和 1000000 之间。</translation>
    </message>
    <message>
        <source>the lower limit must not be greater than the upper limit.</source>
        <translation>下限不得大于上限。</translation>
    </message>
    <message>
        <source>the degrees of freedom must be at least 0.2 (they may be infinite).</source>
        <translation>自由度必须至少为 0.2（可以为无穷大）。</translation>
    </message>
    <message>
        <source>the inexactness of the limits must not exceed half the distance between them.</source>
        <translation>界限的不精确度不得超过其间距的一半。</translation>
    </message>
    <message>
        <source>the ratio beta of top to base must lie between 0 and 1.</source>
        <translation>上底与下底之比 beta 必须在 0 和 1 之间。</translation>
    </message>
    <message>
        <source>one of the limits excludes every value.</source>
        <translation>有一个界限排除了所有值。</translation>
    </message>
    <message>
        <source>the mean value lies outside the limits.</source>
        <translation>均值在界限之外。</translation>
    </message>
    <message>
        <source>the limits lie so far from the mean value that no probability is left between them.</source>
        <translation>界限离均值过远，其间没有剩余的概率。</translation>
    </message>
    <message>
        <source>mean value of the logarithm</source>
        <translation>对数的均值</translation>
    </message>
    <message>
        <source>the parameters of the logarithm are too large: the quantity has no finite variance in numbers.</source>
        <translation>对数的参数过大：该量没有可用数字表示的有限方差。</translation>
    </message>
    <message>
        <source>a discrete distribution needs at least one value.</source>
        <translation>离散分布至少需要一个值。</translation>
    </message>
    <message>
        <source>there must be as many probabilities as values.</source>
        <translation>概率的个数必须与值相同。</translation>
    </message>
    <message>
        <source>values</source>
        <translation>取值个数</translation>
    </message>
    <message>
        <source>probabilities</source>
        <translation>概率</translation>
    </message>
    <message>
        <source>the probabilities must sum to 1.</source>
        <translation>概率之和必须为 1。</translation>
    </message>
    <message>
        <source>discrete distribution: there must be as many probabilities as values.</source>
        <translation>离散分布：概率的个数必须与值相同。</translation>
    </message>
    <message>
        <source>%1 distribution: %2 parameters are needed, %3 are given.</source>
        <translation>%1分布：需要 %2 个参数，给出了 %3 个。</translation>
    </message>
    <message>
        <source>the distribution &quot;%1&quot; is not known. Known distributions: %2.</source>
        <translation>未知分布“%1”。已知分布：%2。</translation>
    </message>
    <message>
        <source>%1 in row %2 of %3</source>
        <translation>%3第 %2 行的%1</translation>
    </message>
    <message>
        <source>greater than %1 and at most %2</source>
        <translation>大于 %1 且至多 %2</translation>
    </message>
    <message>
        <source>between %1 and %2</source>
        <translation>在 %1 和 %2 之间</translation>
    </message>
    <message>
        <source>greater than %1</source>
        <translation>大于 %1</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>至少 %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>至多 %1</translation>
    </message>
    <message>
        <source>%1 must be a whole number; it is %2</source>
        <translation>%1 必须是整数；现为 %2</translation>
    </message>
    <message>
        <source>%1 is too large a number: %2</source>
        <translation>%1 的数值过大：%2</translation>
    </message>
    <message>
        <source>%1 must be %2; it is %3</source>
        <translation>%1 必须%2；现为 %3</translation>
    </message>
    <message>
        <source>%1 must be one of %2; it is %3%4</source>
        <translation>%1 必须是 %2 之一；现为 %3%4</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数字</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>one of its choices</source>
        <translation>其选项之一</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true 或 false</translation>
    </message>
    <message>
        <source>a pose</source>
        <translation>位姿</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>the id of an asset</source>
        <translation>资源的 id</translation>
    </message>
    <message>
        <source>%1 must be %2</source>
        <translation>%1 必须是%2</translation>
    </message>
    <message>
        <source>%1 needs at least 1 row; it has %2</source>
        <translation>%1 至少需要 1 行；现有 %2 行</translation>
    </message>
    <message>
        <source>%1 needs at least %2 rows; it has %3</source>
        <translation>%1 至少需要 %2 行；现有 %3 行</translation>
    </message>
    <message>
        <source>%1 has %2 columns, but %3 units</source>
        <translation>%1 有 %2 列，但有 %3 个单位</translation>
    </message>
    <message>
        <source>row %1 of %2 has %3 cells; there are %4 columns</source>
        <translation>%2 的第 %1 行有 %3 个单元格；现有 %4 列</translation>
    </message>
    <message>
        <source>%1 is empty</source>
        <translation>%1 为空</translation>
    </message>
    <message>
        <source>%1 must not be empty</source>
        <translation>%1 不得为空</translation>
    </message>
    <message>
        <source>%1 must be given (&apos;%2&apos; is missing)</source>
        <translation>必须给出 %1（缺少 &apos;%2&apos;）</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; is %3; &apos;%4&apos; is the unit of %5</source>
        <translation>&apos;%2&apos; 的列 &apos;%1&apos; 是%3；&apos;%4&apos; 是%5的单位</translation>
    </message>
    <message>
        <source>there is no field &apos;%1&apos; here%2</source>
        <translation>此处没有字段 &apos;%1&apos;%2</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>an area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>体积</translation>
    </message>
    <message>
        <source>a mass</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>a time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>a frequency</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>an electric current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>a temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>an expansion coefficient</source>
        <translation>膨胀系数</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>a velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>an acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>a force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>a moment</source>
        <translation>力矩</translation>
    </message>
    <message>
        <source>a pressure</source>
        <translation>压力</translation>
    </message>
    <message>
        <source>a stiffness</source>
        <translation>刚度</translation>
    </message>
    <message>
        <source>a voltage</source>
        <translation>电压</translation>
    </message>
    <message>
        <source>an electric resistance</source>
        <translation>电阻</translation>
    </message>
    <message>
        <source>an electric charge</source>
        <translation>电荷</translation>
    </message>
    <message>
        <source>a capacitance</source>
        <translation>电容</translation>
    </message>
    <message>
        <source>an inductance</source>
        <translation>电感</translation>
    </message>
    <message>
        <source>a magnetic flux density</source>
        <translation>磁通密度</translation>
    </message>
    <message>
        <source>a magnetic flux</source>
        <translation>磁通量</translation>
    </message>
    <message>
        <source>a power</source>
        <translation>功率</translation>
    </message>
    <message>
        <source>an amount of substance</source>
        <translation>物质的量</translation>
    </message>
    <message>
        <source>a luminous intensity</source>
        <translation>发光强度</translation>
    </message>
    <message>
        <source>an angular velocity</source>
        <translation>角速度</translation>
    </message>
    <message>
        <source>a density</source>
        <translation>密度</translation>
    </message>
    <message>
        <source> (did you mean &apos;%1&apos;?)</source>
        <translation> （是否指 &apos;%1&apos;？）</translation>
    </message>
    <message>
        <source>%1 must be a finite number; it is %2</source>
        <translation>%1 必须是有限数；现为 %2</translation>
    </message>
    <message>
        <source>%1 is too large to be computed with (at most 1e100): it is %2</source>
        <translation>%1 过大，无法计算（至多 1e100）：现为 %2</translation>
    </message>
    <message>
        <source>%1 is %2; %3 has no unit</source>
        <translation>%1 为%2；%3 没有单位</translation>
    </message>
    <message>
        <source>%1 is %2; %3 is %4</source>
        <translation>%1 为%2；%3 为%4</translation>
    </message>
    <message>
        <source>the result does not represent the measurand: more than 1 % of the trials have no value</source>
        <translation>该结果不代表被测量：超过 1 % 的试验没有值</translation>
    </message>
    <message>
        <source>U = k u with the coverage factor that was fixed.</source>
        <translation>U = k u，包含因子为固定值。</translation>
    </message>
    <message>
        <source>U is half the width of the probabilistically symmetric coverage interval, and k = U/u.</source>
        <translation>U 是概率对称包含区间的半宽，k = U/u。</translation>
    </message>
    <message>
        <source>U = k u with k of the t distribution for the effective degrees of freedom.</source>
        <translation>U = k u，k 取有效自由度的 t 分布。</translation>
    </message>
    <message>
        <source>the number of significant digits of the numerical tolerance must be 1, 2, 3 or 4</source>
        <translation>数值容差的有效位数必须是 1、2、3 或 4</translation>
    </message>
    <message>
        <source>the numerical tolerance must be greater than zero</source>
        <translation>数值容差必须大于零</translation>
    </message>
    <message>
        <source>the adaptive procedure needs at least two batches</source>
        <translation>自适应程序至少需要两批</translation>
    </message>
    <message>
        <source>the adaptive procedure needs at least two batches: allow %1 trials or more</source>
        <translation>自适应程序至少需要两批：请允许 %1 次或更多试验</translation>
    </message>
    <message>
        <source>a Monte Carlo run needs at least two trials</source>
        <translation>蒙特卡洛运行至少需要两次试验</translation>
    </message>
    <message>
        <source>the coverage probability must lie between 0 and 1</source>
        <translation>包含概率必须在 0 和 1 之间</translation>
    </message>
    <message>
        <source>the coverage probability is too near to 1</source>
        <translation>包含概率过于接近 1</translation>
    </message>
    <message>
        <source>the coverage factor must be greater than zero</source>
        <translation>包含因子必须大于零</translation>
    </message>
    <message>
        <source>one-at-a-time Monte Carlo needs at least two trials</source>
        <translation>逐一蒙特卡洛至少需要两次试验</translation>
    </message>
    <message>
        <source>Monte Carlo without a contributor needs at least two trials</source>
        <translation>去掉一个贡献源的蒙特卡洛至少需要两次试验</translation>
    </message>
    <message>
        <source>Sobol indices need at least 100 trials</source>
        <translation>Sobol 指数至少需要 100 次试验</translation>
    </message>
    <message>
        <source>the evaluation was stopped</source>
        <translation>评定已停止</translation>
    </message>
    <message>
        <source>none of the trials has a value: the measurement model cannot be evaluated within the uncertainties of its inputs; check the standard uncertainties and the geometry</source>
        <translation>没有一次试验有值：测量模型在其输入的不确定度范围内不能评定；请检查标准不确定度和几何</translation>
    </message>
    <message>
        <source>the linear part explains %1 % of the variance: a gain of %2</source>
        <translation>线性部分解释方差的 %1 %：增益为 %2</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%2 的%1</translation>
    </message>
    <message>
        <source>no trial has a value</source>
        <translation>没有试验有值</translation>
    </message>
    <message>
        <source>the measurement model has no sensitivity coefficients near the estimates: second-order terms do not exist</source>
        <translation>测量模型在估计值附近没有灵敏系数：不存在二阶项</translation>
    </message>
    <message>
        <source>there are too many quantities for them</source>
        <translation>量过多</translation>
    </message>
    <message>
        <source>the degrees of freedom of %1 must be greater than zero</source>
        <translation>%1 的自由度必须大于零</translation>
    </message>
    <message>
        <source>the degrees of freedom of %1 are too few: there must be at least 0.2</source>
        <translation>%1 的自由度过少：必须至少为 0.2</translation>
    </message>
    <message>
        <source>the distribution of %1 has no finite mean or standard uncertainty</source>
        <translation>%1 的分布没有有限的均值或标准不确定度</translation>
    </message>
    <message>
        <source>the estimate of %1 is not a finite number</source>
        <translation>%1 的估计值不是有限数</translation>
    </message>
    <message>
        <source>quantity %1 refers to a component that does not exist, or with a factor that is not finite</source>
        <translation>量 %1 引用了不存在的分量，或其因子不是有限数</translation>
    </message>
    <message>
        <source>the measurement model has %1 input quantities, but %2 were given</source>
        <translation>测量模型有 %1 个输入量，但给出了 %2 个</translation>
    </message>
    <message>
        <source>the measurement model has no output quantities</source>
        <translation>测量模型没有输出量</translation>
    </message>
    <message>
        <source>its correlated components are not normally distributed</source>
        <translation>其相关的分量不是正态分布</translation>
    </message>
    <message>
        <source>no spread</source>
        <translation>无分散性</translation>
    </message>
    <message>
        <source>normal as far as so few trials can tell</source>
        <translation>就如此少的试验而言为正态</translation>
    </message>
    <message>
        <source>normal within 1 %</source>
        <translation>正态，在 1 % 以内</translation>
    </message>
    <message>
        <source>normal within 5 %</source>
        <translation>正态，在 5 % 以内</translation>
    </message>
    <message>
        <source>too skewed for k u</source>
        <translation>对 k u 而言过于偏斜</translation>
    </message>
    <message>
        <source>too heavy-tailed for k u</source>
        <translation>对 k u 而言尾部过重</translation>
    </message>
    <message>
        <source>too flat for k u</source>
        <translation>对 k u 而言过平</translation>
    </message>
    <message>
        <source>Second-order terms are left out: the formula of JCGM 100 5.1.2 assumes independent components, and some of these are correlated.</source>
        <translation>略去二阶项：JCGM 100 5.1.2 的公式假定分量独立，而其中一些是相关的。</translation>
    </message>
    <message>
        <source>Second-order terms are left out: %1.</source>
        <translation>略去二阶项：%1。</translation>
    </message>
    <message>
        <source>%1 of %2 trials (%3 %) have no value (the measurement model cannot be evaluated there) and are not part of the statistics.</source>
        <translation>%2 次试验中有 %1 次（%3 %）没有值（测量模型在那里不能评定），不计入统计。</translation>
    </message>
    <message>
        <source>The result does not represent the measurand: more than 1 % of the trials are lost, and they are not a random choice.</source>
        <translation>该结果不代表被测量：丢失的试验超过 1 %，且并非随机选取。</translation>
    </message>
    <message>
        <source>The adaptive procedure stopped at %1 trials before its results were stable: allow more trials, or ask for fewer significant digits.</source>
        <translation>自适应程序在其结果稳定之前于 %1 次试验停止：请允许更多试验，或要求更少的有效位数。</translation>
    </message>
    <message>
        <source>Coverage intervals are interpolated in fine cells: there are too many trials to keep the values of the tails in memory.</source>
        <translation>包含区间在细单元中内插：试验过多，内存不能保留尾部的值。</translation>
    </message>
    <message>
        <source>The correlations stated cannot all hold with these distributions: the nearest that can are drawn, with coefficients that differ by up to %1.</source>
        <translation>所给的相关不能与这些分布同时成立：抽取的是可能的最接近者，其系数最多相差 %1。</translation>
    </message>
    <message>
        <source>The angle %1%2 is hardly determined: its standard uncertainty exceeds 1 rad.</source>
        <translation>角度 %1%2 几乎不能确定：其标准不确定度超过 1 rad。</translation>
    </message>
    <message>
        <source>Nothing is gained by variance reduction, and standard errors are not known: there are fewer than %1 batches of %2 trials.</source>
        <translation>方差缩减没有增益，标准误差未知：%2 次试验的批少于 %1 批。</translation>
    </message>
    <message>
        <source>Control variates are not used: the linear part of the trials that have a value has another distribution than that of all trials.</source>
        <translation>不使用控制变量：有值的试验的线性部分与所有试验的分布不同。</translation>
    </message>
    <message>
        <source>Without control variate: %1.</source>
        <translation>没有控制变量：%1。</translation>
    </message>
    <message>
        <source>The standard uncertainty by Monte Carlo of %1 does not exist, because a Student t distribution with two degrees of freedom or fewer has no finite standard deviation: it is shown as infinite, and U is half the width of the coverage interval.</source>
        <translation>%1 的蒙特卡洛标准不确定度不存在，因为自由度不超过 2 的 t 分布没有有限的标准偏差：显示为无穷大，U 为包含区间的半宽。</translation>
    </message>
    <message>
        <source>The standard uncertainty by Monte Carlo of %1 cannot stabilise, because Student t distributions with four degrees of freedom or fewer have no finite fourth moment: the adaptive procedure judges by the coverage intervals; use these.</source>
        <translation>%1 的蒙特卡洛标准不确定度不能稳定，因为自由度不超过 4 的 t 分布没有有限的四阶矩：自适应程序按包含区间判断；请使用包含区间。</translation>
    </message>
    <message>
        <source>the measurement model has no value at the estimates of its input quantities%1: check the nominal geometry and the values entered</source>
        <translation>测量模型在其输入量的估计值处没有值%1：请检查标称几何和输入的值</translation>
    </message>
    <message>
        <source>Effective degrees of freedom are approximate: the Welch-Satterthwaite formula assumes independent components, and correlated components with finite degrees of freedom contribute. The Monte Carlo coverage interval is the better guide.</source>
        <translation>有效自由度是近似的：Welch-Satterthwaite 公式假定分量独立，而有自由度有限的相关分量参与贡献。蒙特卡洛包含区间是更好的依据。</translation>
    </message>
    <message>
        <source>1 vector of random direction has coordinates with different distributions after editing: they are drawn independently.</source>
        <translation>1 个随机方向的矢量在编辑后各坐标的分布不同：它们被独立抽取。</translation>
    </message>
    <message>
        <source>%1 vectors of random direction have coordinates with different distributions after editing: they are drawn independently.</source>
        <translation>%1 个随机方向的矢量在编辑后各坐标的分布不同：它们被独立抽取。</translation>
    </message>
    <message>
        <source>The angle %1 is hardly determined: its standard uncertainty by the law of propagation exceeds 1 rad.</source>
        <translation>角度 %1 几乎不能确定：按传播律其标准不确定度超过 1 rad。</translation>
    </message>
    <message>
        <source>a tolerance of %1 %2 for %3 (u = %4 %2) needs about %5 trials (%6 batches)</source>
        <translation>%3 的容差 %1 %2（u = %4 %2）约需 %5 次试验（%6 批）</translation>
    </message>
    <message>
        <source>to correct the bias of coordinate %1, give the number of observations n in its row: the uncertainty of the correction is u_var/sqrt(n)</source>
        <translation>要修正坐标 %1 的偏移，请在其行中给出观测次数 n：修正的不确定度为 u_var/sqrt(n)</translation>
    </message>
    <message>
        <source>there are two points called &apos;%1&apos;; rename one</source>
        <translation>有两个点名为 &apos;%1&apos;；请将其中一个改名</translation>
    </message>
    <message>
        <source>there is no calibrated point called &apos;%1&apos;</source>
        <translation>没有名为 &apos;%1&apos; 的已校准点</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must consist of the letters x, y and z</source>
        <translation>&apos;%1&apos; 必须由字母 x、y 和 z 组成</translation>
    </message>
    <message>
        <source>coordinate %1 has fewer than two observations that do not define the frame: measure more points or runs</source>
        <translation>坐标 %1 不定义坐标系的观测值少于两个：请测量更多的点或测次</translation>
    </message>
    <message>
        <source>coordinate %1 has %2 rows; it must have one</source>
        <translation>坐标 %1 有 %2 行；必须为一行</translation>
    </message>
    <message>
        <source>the length standard needs at least two observations</source>
        <translation>长度标准器至少需要两个观测值</translation>
    </message>
    <message>
        <source>the table must have one row; it has %1</source>
        <translation>该表必须有一行；现有 %1 行</translation>
    </message>
    <message>
        <source>the analysis has no point called &apos;%1&apos;</source>
        <translation>该分析没有名为 &apos;%1&apos; 的点</translation>
    </message>
    <message>
        <source>point %1: %2</source>
        <translation>点 %1：%2</translation>
    </message>
    <message>
        <source>it is at the place of the instrument</source>
        <translation>它位于仪器的位置</translation>
    </message>
    <message>
        <source>it is out of the range or field of view of the instrument</source>
        <translation>它在仪器的测程或视场之外</translation>
    </message>
    <message>
        <source>correlated coordinates of a station are combinations of independent deviations, which are normal: leave the distribution normal, or the correlation out</source>
        <translation>测站的相关坐标是独立偏差的组合，而独立偏差为正态：请保留正态分布，或去掉相关</translation>
    </message>
    <message>
        <source>a coordinate of the station is correlated with itself; name two different ones</source>
        <translation>测站的坐标与自身相关；请写两个不同的坐标</translation>
    </message>
    <message>
        <source>the range ends before it begins: the longest distance must be greater than the shortest</source>
        <translation>测程的终点在起点之前：最长距离必须大于最短距离</translation>
    </message>
    <message>
        <source>the sensor reads nothing: choose a distance or an angle</source>
        <translation>该传感器不读取任何量：请选择距离或角度</translation>
    </message>
    <message>
        <source>these coefficients are not possible together: their matrix has a negative eigenvalue</source>
        <translation>这些系数不能同时成立：其矩阵有负特征值</translation>
    </message>
    <message>
        <source>it is at the place of %1</source>
        <translation>它位于 %1 的位置</translation>
    </message>
    <message>
        <source>no sensor of the network sees it</source>
        <translation>网络中没有传感器能看到它</translation>
    </message>
    <message>
        <source>it cannot be localised from what %1 read: the readings leave a direction undetermined; add a sensor or a reading</source>
        <translation>不能由 %1 的读数定位：有一个方向不能由读数确定；请增加传感器或读数</translation>
    </message>
    <message>
        <source>the readings do not lead to a position of every target: the estimation does not converge from the nominal coordinates; look for exchanged or mistyped readings</source>
        <translation>读数不能得出每个目标点的位置：由标称坐标开始的估计不收敛；请查找对调或误输的读数</translation>
    </message>
    <message>
        <source>%1 looks away from target %2: its angles point to the opposite side</source>
        <translation>%1 背向目标点 %2：其角度指向相反一侧</translation>
    </message>
    <message>
        <source>there is no target %1</source>
        <translation>没有目标点 %1</translation>
    </message>
    <message>
        <source>%1 does not see target %2: it is out of its range or field of view</source>
        <translation>%1 看不到目标点 %2：它在其测程或视场之外</translation>
    </message>
    <message>
        <source>%1 does not see %2 of the %3 targets: they are out of its range or field of view</source>
        <translation>%1 看不到 %3 个目标点中的 %2 个：它们在其测程或视场之外</translation>
    </message>
    <message>
        <source>the sensor %1 is not listed in the network</source>
        <translation>传感器 %1 未列在网络中</translation>
    </message>
    <message>
        <source>%1 reads no %2 according to its description</source>
        <translation>按其说明，%1 不读取 %2</translation>
    </message>
    <message>
        <source>more than %1 rows for target %2</source>
        <translation>目标点 %2 超过 %1 行</translation>
    </message>
    <message>
        <source>target %1 is at the place of %2</source>
        <translation>目标点 %1 位于 %2 的位置</translation>
    </message>
    <message>
        <source>target %1 is behind the camera %2</source>
        <translation>目标点 %1 在相机 %2 之后</translation>
    </message>
    <message>
        <source>a network has at most %1 sensors; divide it into several analyses</source>
        <translation>一个网络最多有 %1 个传感器；请将其分为多个分析</translation>
    </message>
    <message>
        <source>two targets are called %1</source>
        <translation>有两个目标点名为 %1</translation>
    </message>
    <message>
        <source>a distance needs two targets at different places</source>
        <translation>距离需要位于不同位置的两个目标点</translation>
    </message>
    <message>
        <source>a calibrated length needs two targets at different places</source>
        <translation>已校准长度需要位于不同位置的两个目标点</translation>
    </message>
    <message>
        <source>the calibrated length is missing</source>
        <translation>缺少已校准长度</translation>
    </message>
    <message>
        <source>the nominal targets of the %1 are at another distance than its calibrated length; the design takes their distance</source>
        <translation>%1 的标称目标点之间的距离与其已校准长度不同；设计取它们的距离</translation>
    </message>
    <message>
        <source>a calibrated length can be a constraint only of the non-linear estimator with weights from readings and stations</source>
        <translation>只有非线性估计且权来自读数和测站时，已校准长度才能作为约束</translation>
    </message>
    <message>
        <source>the targets of the %1 belong to two set-ups, which are estimated one after the other: it can only be a check</source>
        <translation>%1 的目标点属于两次设站，两者先后估计：它只能作为检核</translation>
    </message>
    <message>
        <source>the targets of an angle must be at three places off one line: at 0° and 180° an angle has no sign and no derivative</source>
        <translation>角度的目标点必须在不共线的三个位置：在 0° 和 180° 处角度没有符号也没有导数</translation>
    </message>
    <message>
        <source>the name %1 is taken by another frame or a target</source>
        <translation>名称 %1 已被另一坐标系或目标点使用</translation>
    </message>
    <message>
        <source>the three targets of frame %1 lie on one line: its axes are undefined</source>
        <translation>坐标系 %1 的三个目标点在一条直线上：其轴无定义</translation>
    </message>
    <message>
        <source>the x-axis of frame %1 is vertical: its Z-Y-X angles are undefined (gimbal lock)</source>
        <translation>坐标系 %1 的 x 轴是竖直的：其 Z-Y-X 角无定义（万向节锁定）</translation>
    </message>
    <message>
        <source>scale bar %1 – %2</source>
        <translation>基准尺 %1 – %2</translation>
    </message>
    <message>
        <source>the sensor %1 is listed twice</source>
        <translation>传感器 %1 列出了两次</translation>
    </message>
    <message>
        <source>%1 The residuals are larger than the uncertainties allow; the largest for its uncertainty is the %2. Look for mistyped or exchanged readings, or figures of the instruments that are too small</source>
        <translation>%1 残差大于不确定度所允许的；相对其不确定度最大的是 %2。请查找误输或对调的读数，或过小的仪器数值</translation>
    </message>
    <message>
        <source>distance of %1 by %2</source>
        <translation>%2 所测 %1 的距离</translation>
    </message>
    <message>
        <source>azimuth of %1 by %2</source>
        <translation>%2 所测 %1 的方位角</translation>
    </message>
    <message>
        <source>elevation of %1 by %2</source>
        <translation>%2 所测 %1 的俯仰角</translation>
    </message>
    <message>
        <source>length of the %1</source>
        <translation>%1 的长度</translation>
    </message>
    <message>
        <source>Chi-square of the residuals: %1 with %2 degrees of freedom, p = %3.</source>
        <translation>残差的卡方：%1，自由度 %2，p = %3。</translation>
    </message>
    <message>
        <source>no sensor</source>
        <translation>没有传感器</translation>
    </message>
    <message>
        <source>target %1 has no linear equations that localise it (a distance without angles has none): use the non-linear estimator</source>
        <translation>目标点 %1 没有能将其定位的线性方程（没有角度的距离没有线性方程）：请使用非线性估计</translation>
    </message>
    <message>
        <source>target %1 cannot be localised from what %2 read: the readings leave a direction undetermined; add a sensor or a reading</source>
        <translation>目标点 %1 不能由 %2 的读数定位：有一个方向不能由读数确定；请增加传感器或读数</translation>
    </message>
    <message>
        <source>target %1 is hardly localised: in one direction u is %2 m at a distance of %3 m</source>
        <translation>目标点 %1 几乎不能定位：在一个方向上，距离 %3 m 处 u 为 %2 m</translation>
    </message>
    <message>
        <source>the stations that measure target %1 lie in one plane and read distances only: its mirror image behind that plane fits as well; the one near the nominal coordinates is taken</source>
        <translation>测量目标点 %1 的测站在一个平面内且只读取距离：其在该平面后的镜像同样符合；取靠近标称坐标的那个</translation>
    </message>
    <message>
        <source>a calibrated length cannot be a constraint of a set-up with more than %1 readings (this one has %2): make it a check</source>
        <translation>已校准长度不能作为读数超过 %1 个的设站的约束（此设站有 %2 个）：请改为检核</translation>
    </message>
    <message>
        <source>the %1 readings of one set-up are too many to be weighed together: each target is estimated from its own readings, weighted with the stations</source>
        <translation>一次设站的 %1 个读数过多，不能一起加权：每个目标点由其自身的读数估计，与测站一起加权</translation>
    </message>
    <message>
        <source>the standard uncertainty of a coordinate, %1 mm, is more than a tenth of the distance of point %2 from the x-axis, %3 mm: the law of propagation is not reliable here, look at Monte Carlo</source>
        <translation>坐标的标准不确定度 %1 mm 超过点 %2 到 x 轴距离 %3 mm 的十分之一：此处传播律不可靠，请看蒙特卡洛</translation>
    </message>
    <message>
        <source>the frame made from these points lies %1 mm and %2° away from the axes in which they are given, so results differ from the table of poses; check the side of point 3 and the shift of the origin</source>
        <translation>由这些点构成的坐标系与给出它们的轴相差 %1 mm 和 %2°，因此结果与位姿表不同；请检查点 3 所在的一侧和原点的偏移</translation>
    </message>
    <message>
        <source>%1: beta is within 2° of ±90°, where Z-Y-X angles are undefined (gimbal lock); state the orientation as a rotation vector</source>
        <translation>%1：beta 距 ±90° 不足 2°，该处 Z-Y-X 角无定义（万向节锁定）；请以旋转矢量表示姿态</translation>
    </message>
    <message>
        <source>%1: beta is within 2° of 0° or 180°, where Z-Y-Z angles are undefined (gimbal lock); state the orientation as Z-Y-X angles or a rotation vector</source>
        <translation>%1：beta 距 0° 或 180° 不足 2°，该处 Z-Y-Z 角无定义（万向节锁定）；请以 Z-Y-X 角或旋转矢量表示姿态</translation>
    </message>
    <message>
        <source>%1: the rotation is within 4° of half a turn, where the sign of the axis is undefined; state the orientation as angles</source>
        <translation>%1：旋转距半圈不足 4°，该处轴的符号无定义；请以角度表示姿态</translation>
    </message>
    <message>
        <source>the analysis %1 has no point called &apos;%2&apos;</source>
        <translation>分析 %1 没有名为 &apos;%2&apos; 的点</translation>
    </message>
    <message>
        <source>point %1 cannot be measured by %2: %3</source>
        <translation>点 %1 不能由 %2 测量：%3</translation>
    </message>
    <message>
        <source>the 3-2-1 method uses the first three points; point %1 and those after it are not used: choose least squares</source>
        <translation>3-2-1 法使用前三个点；点 %1 及其后的点不使用：请选择最小二乘</translation>
    </message>
    <message>
        <source>the base frame is undefined</source>
        <translation>基坐标系无定义</translation>
    </message>
    <message>
        <source>the moving frame is undefined</source>
        <translation>动坐标系无定义</translation>
    </message>
    <message>
        <source>points %1 and %2 coincide: %3</source>
        <translation>点 %1 和 %2 重合：%3</translation>
    </message>
    <message>
        <source>point %1 lies on the line through %2 and %3: %4</source>
        <translation>点 %1 位于通过 %2 和 %3 的直线上：%4</translation>
    </message>
    <message>
        <source>all points lie on one line or coincide: their frame is undefined</source>
        <translation>所有点在一条直线上或重合：其坐标系无定义</translation>
    </message>
    <message>
        <source>not used: the uncertainties come from an artefact or instrument</source>
        <translation>不使用：不确定度来自实物标准器或仪器</translation>
    </message>
    <message>
        <source>there are two poses called &apos;%1&apos;; rename one</source>
        <translation>有两个名为 &apos;%1&apos; 的位姿；请将其中一个改名</translation>
    </message>
    <message>
        <source>no pose may be called &apos;base&apos;: that names the base among the measured points</source>
        <translation>位姿不得名为 &apos;base&apos;：它在实测点中指基座</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither &apos;base&apos; nor the name of a pose</source>
        <translation>&apos;%1&apos; 既不是 &apos;base&apos; 也不是位姿的名称</translation>
    </message>
    <message>
        <source>there is no point called &apos;%1&apos; in that frame</source>
        <translation>该坐标系中没有名为 &apos;%1&apos; 的点</translation>
    </message>
    <message>
        <source>point %1 of &apos;%2&apos; was not measured</source>
        <translation>&apos;%2&apos; 的点 %1 没有测量</translation>
    </message>
    <message>
        <source>the mirrored coordinates leave %1 instead of %2: frame 0 is left-handed, check the signs and the order of its axes</source>
        <translation>镜像坐标的残差为 %1 而不是 %2：坐标系 0 是左手系，请检查其轴的符号和顺序</translation>
    </message>
    <message>
        <source>with %1 and %2 exchanged the residuals are %3 instead of %4: check the names</source>
        <translation>将 %1 和 %2 对调后，残差为 %3 而不是 %4：请检查名称</translation>
    </message>
    <message>
        <source>the points of &apos;%1&apos; do not fit their nominal coordinates</source>
        <translation>&apos;%1&apos; 的点与其标称坐标不符</translation>
    </message>
    <message>
        <source>the points of &apos;%1&apos; do not fit their nominal coordinates within the stated uncertainties: chi-square %2 with %3 degrees of freedom; the largest normalised residual is %4 (%5)</source>
        <translation>&apos;%1&apos; 的点在给出的不确定度内与其标称坐标不符：卡方 %2，自由度 %3；最大标准化残差为 %4（%5）</translation>
    </message>
    <message>
        <source>the lengths between the supports make no triangle: the longest of %1, %2 and %3 exceeds the sum of the others</source>
        <translation>支座之间的长度不构成三角形：%1、%2 和 %3 中最长的超过其余之和</translation>
    </message>
    <message>
        <source>the three supports lie on a line (%1, %2 and %3): they leave the place of the ball undetermined; move one of them aside</source>
        <translation>三个支座（%1、%2 和 %3）在一条直线上：它们不能确定球的位置；请将其中一个移开</translation>
    </message>
    <message>
        <source>the lengths of support %1 do not meet at its height: they miss by %2</source>
        <translation>支座 %1 的长度在其高度处不相交：相差 %2</translation>
    </message>
    <message>
        <source>a set has at most %1 supports</source>
        <translation>一组最多有 %1 个支座</translation>
    </message>
    <message>
        <source>the rotation about %1</source>
        <translation>绕 %1 的旋转</translation>
    </message>
    <message>
        <source>%1 has %2 points; a plane needs three, and some more to be checked</source>
        <translation>%1有 %2 个点；平面需要三个，以及另外一些供检核</translation>
    </message>
    <message>
        <source>%1 has a span of zero: all its points coincide</source>
        <translation>%1的跨度为零：其所有点重合</translation>
    </message>
    <message>
        <source>the tool centre point lies on the axis of %1 (or the tool has no length): it traces no circle; turn about another axis</source>
        <translation>工具中心点位于%1的轴上（或工具没有长度）：它不画圆；请绕另一轴转动</translation>
    </message>
    <message>
        <source>the arc of %1 spans only %2°: uncertainties grow as the inverse square of the span and may be %3 times those of half a turn</source>
        <translation>%1的圆弧仅跨 %2°：不确定度按跨度平方的倒数增大，可能为半圈时的 %3 倍</translation>
    </message>
    <message>
        <source>point %1 is %2 mm on the other side of the supports&apos; plane, where the ballbars look for no solution; change their placement or their side</source>
        <translation>点 %1 在支座平面另一侧 %2 mm 处，球杆仪不在那里求解；请更改其放置或所在的一侧</translation>
    </message>
    <message>
        <source>point %1 is only %2 mm from the supports&apos; plane, with a standard uncertainty of %3 mm in that direction: in some trials the lengths will not meet (negative root), and u is not to be trusted</source>
        <translation>点 %1 距支座平面仅 %2 mm，该方向的标准不确定度为 %3 mm：某些试验中长度将不相交（负数的根），u 不可信</translation>
    </message>
    <message>
        <source>the measured points determine no sphere and no axes: they lie on one circle, or coincide; check their axes and angles</source>
        <translation>实测点不能确定球面和轴：它们在一个圆上或重合；请检查其轴和角度</translation>
    </message>
    <message>
        <source>a procedure has at most %1 points</source>
        <translation>一个程序最多有 %1 个点</translation>
    </message>
    <message>
        <source>two points are called %1</source>
        <translation>有两个点名为 %1</translation>
    </message>
    <message>
        <source>the flange turns about %1 in two rotations; put their points into one</source>
        <translation>法兰在两次旋转中绕 %1 转动；请将其点合并为一个</translation>
    </message>
    <message>
        <source>one rotation traces one circle, which leaves the centre of the flange and its axes undetermined: add a rotation about another axis</source>
        <translation>一次旋转画一个圆，法兰的中心和轴仍未确定：请添加绕另一轴的旋转</translation>
    </message>
    <message>
        <source>no rotation measures axis %1: choose another way to make the axes, or add the rotation</source>
        <translation>没有旋转测量轴 %1：请选择其他构成轴的方式，或添加该旋转</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not offer &apos;%2&apos;</source>
        <translation>&apos;%1&apos; 不提供 &apos;%2&apos;</translation>
    </message>
    <message>
        <source>column %1: %2</source>
        <translation>第 %1 列：%2</translation>
    </message>
    <message>
        <source>it is called like a joint of a gripper</source>
        <translation>其名称像夹爪的关节</translation>
    </message>
    <message>
        <source>others follow it at the end of the arm, as in a gripper</source>
        <translation>其他关节在机械臂末端跟随它，如同夹爪</translation>
    </message>
    <message>
        <source>it slides by less than 100 mm at the end of the arm, as in a gripper</source>
        <translation>它在机械臂末端移动不足 100 mm，如同夹爪</translation>
    </message>
    <message>
        <source>it is one of several at the end of the arm, as in a hand</source>
        <translation>它是机械臂末端若干关节之一，如同手</translation>
    </message>
    <message>
        <source>no joint leads to a link called %1</source>
        <translation>没有关节通向名为 %1 的连杆</translation>
    </message>
    <message>
        <source>no moving joint leads to %1</source>
        <translation>没有活动关节通向 %1</translation>
    </message>
    <message>
        <source>the links form a ring; URDF describes trees</source>
        <translation>连杆构成环；URDF 描述树</translation>
    </message>
    <message>
        <source>joint %1 on the way to %2 is of the type %3: freeze it, --freeze %1=0</source>
        <translation>通向 %2 的关节 %1 的类型为 %3：请固定它，--freeze %1=0</translation>
    </message>
    <message>
        <source>joint %1 on the way to %2 follows joint %3: freeze it, --freeze %1=0</source>
        <translation>通向 %2 的关节 %1 跟随关节 %3：请固定它，--freeze %1=0</translation>
    </message>
    <message>
        <source>no arm: joint %1 was left out because %2</source>
        <translation>不是机械臂：关节 %1 被省略，因为 %2</translation>
    </message>
    <message>
        <source>no arm: joint %1 is of the type %2</source>
        <translation>不是机械臂：关节 %1 的类型为 %2</translation>
    </message>
    <message>
        <source>no arm: joint %1 follows joint %2</source>
        <translation>不是机械臂：关节 %1 跟随关节 %2</translation>
    </message>
    <message>
        <source>left out: it is of the type %1</source>
        <translation>已省略：其类型为 %1</translation>
    </message>
    <message>
        <source>left out: it follows joint %1</source>
        <translation>已省略：它跟随关节 %1</translation>
    </message>
    <message>
        <source>left out: %1</source>
        <translation>已省略：%1</translation>
    </message>
    <message>
        <source>left out: it is not on the way to %1</source>
        <translation>已省略：它不在通向 %1 的路径上</translation>
    </message>
    <message>
        <source>the file has no moving joint</source>
        <translation>文件没有活动关节</translation>
    </message>
    <message>
        <source>the file has several arms of equal length, ending at %1 and %2: name the tip link of the one to import</source>
        <translation>文件有多条等长的机械臂，末端为 %1 和 %2：请指明要导入者的末端连杆</translation>
    </message>
    <message>
        <source>frozen: %1</source>
        <translation>已固定：%1</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not three numbers</source>
        <translation>&apos;%1&apos; 不是三个数字</translation>
    </message>
    <message>
        <source>joint %1 does not say which links it joins</source>
        <translation>关节 %1 没有说明它连接哪些连杆</translation>
    </message>
    <message>
        <source>joint %1: %2</source>
        <translation>关节 %1：%2</translation>
    </message>
    <message>
        <source>joint %1: its axis has no direction</source>
        <translation>关节 %1：其轴没有方向</translation>
    </message>
    <message>
        <source>not readable as XML: %1</source>
        <translation>不能作为 XML 读取：%1</translation>
    </message>
    <message>
        <source>no URDF: its root element &lt;robot&gt; is missing</source>
        <translation>不是 URDF：缺少根元素 &lt;robot&gt;</translation>
    </message>
    <message>
        <source>the file has xacro macros: expand them first (xacro FILE &gt; arm.urdf)</source>
        <translation>文件有 xacro 宏：请先展开（xacro FILE &gt; arm.urdf）</translation>
    </message>
    <message>
        <source>link %1 hangs on two joints; URDF describes trees</source>
        <translation>连杆 %1 挂在两个关节上；URDF 描述树</translation>
    </message>
    <message>
        <source>there is no joint %1 to freeze%2</source>
        <translation>没有可固定的关节 %1%2</translation>
    </message>
    <message>
        <source>joint %1 does not move, or is frozen twice</source>
        <translation>关节 %1 不活动，或被固定两次</translation>
    </message>
    <message>
        <source>joint %1 is of the type %2: it can be frozen at 0 only</source>
        <translation>关节 %1 的类型为 %2：只能固定在 0</translation>
    </message>
    <message>
        <source>frozen at %1, beyond its limits</source>
        <translation>固定在 %1，超出其限位</translation>
    </message>
    <message>
        <source>frozen at %1</source>
        <translation>固定在 %1</translation>
    </message>
    <message>
        <source>an arm has at most %1 joints here</source>
        <translation>此处机械臂最多有 %1 个关节</translation>
    </message>
    <message>
        <source>joint %1 slides: state its readings as lengths, in the columns of s</source>
        <translation>关节 %1 是移动关节：请在 s 的各列中以长度给出其读数</translation>
    </message>
    <message>
        <source>joint %1 turns: state its readings as angles, or give it the type sliding</source>
        <translation>关节 %1 是转动关节：请以角度给出其读数，或将其类型设为移动</translation>
    </message>
    <message>
        <source>joint %1</source>
        <translation>关节 %1</translation>
    </message>
    <message>
        <source>only the convention with Ry(beta) has a beta; leave it empty for %1, or choose that convention</source>
        <translation>只有含 Ry(beta) 的约定才有 beta；请将 %1 的 beta 留空，或选择该约定</translation>
    </message>
    <message>
        <source>d and beta of %1 describe the same place of a parallel axis: where beta is given, d is 0 by definition</source>
        <translation>%1 的 d 和 beta 描述平行轴的同一位置：给出 beta 时，d 按定义为 0</translation>
    </message>
    <message>
        <source>the lowest reading of %1 is not below its highest</source>
        <translation>%1 的最小读数不小于其最大读数</translation>
    </message>
    <message>
        <source>the robot has no joint %1</source>
        <translation>机器人没有关节 %1</translation>
    </message>
    <message>
        <source>%1 is 0 by definition, because the axis is parallel to the next</source>
        <translation>%1 按定义为 0，因为该轴与下一轴平行</translation>
    </message>
    <message>
        <source>%1 is no parameter of this robot: give beta in the table of joints where axes are parallel</source>
        <translation>%1 不是此机器人的参数：请在关节表中轴平行处给出 beta</translation>
    </message>
    <message>
        <source>a parameter is correlated with itself; name two different ones</source>
        <translation>参数与自身相关；请写两个不同的参数</translation>
    </message>
    <message>
        <source>there is no parameter &apos;%1&apos; with an uncertainty; write its symbol, such as d_3</source>
        <translation>没有带不确定度的参数 &apos;%1&apos;；请写其符号，如 d_3</translation>
    </message>
    <message>
        <source>%1 has several components of uncertainty: give it one, the combined, so that it can be correlated</source>
        <translation>%1 有多个不确定度分量：请给它一个合成的分量，使其可以相关</translation>
    </message>
    <message>
        <source>there is no pose: give joint readings or a place of the tool</source>
        <translation>没有位姿：请给出关节读数或工具的位置</translation>
    </message>
    <message>
        <source>two poses are called %1</source>
        <translation>有两个位姿名为 %1</translation>
    </message>
    <message>
        <source>pose %1: reading %2 of joint %3 is beyond its limits, %4 to %5</source>
        <translation>位姿 %1：关节 %3 的读数 %2 超出其限位 %4 至 %5</translation>
    </message>
    <message>
        <source>pose %1: the orientation is within 2° of one that %2 cannot state (gimbal lock, half turn); state it otherwise</source>
        <translation>位姿 %1：姿态与%2不能表示的姿态相差不足 2°（万向节锁定、半圈）；请以其他方式表示</translation>
    </message>
    <message>
        <source>%1 has only %2 joints; leave %3 empty</source>
        <translation>%1 只有 %2 个关节；请将 %3 留空</translation>
    </message>
    <message>
        <source>joint %1 of %2 slides: its reading is %3</source>
        <translation>%2 的关节 %1 是移动关节：其读数为 %3</translation>
    </message>
    <message>
        <source>joint %1 of %2 turns: its reading is %3</source>
        <translation>%2 的关节 %1 是转动关节：其读数为 %3</translation>
    </message>
    <message>
        <source>pose %1: give all three angles or none</source>
        <translation>位姿 %1：请给出全部三个角度或都不给</translation>
    </message>
    <message>
        <source>pose %1: no readings within the limits of the joints bring the tool there; the nearest attempt misses the place by %2 but not the orientation</source>
        <translation>位姿 %1：关节限位内没有读数能使工具到达那里；最接近的尝试在位置上相差 %2，但姿态不差</translation>
    </message>
    <message>
        <source>pose %1: no readings within the limits of the joints bring the tool there; the nearest attempt misses the place by %2</source>
        <translation>位姿 %1：关节限位内没有读数能使工具到达那里；最接近的尝试在位置上相差 %2</translation>
    </message>
    <message>
        <source>without limits</source>
        <translation>没有限位</translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <translation>%1 至 %2 %3</translation>
    </message>
    <message>
        <source>%1 mm, turned by %2 deg</source>
        <translation>%1 mm，旋转 %2 deg</translation>
    </message>
    <message>
        <source>joint %1: %2, slides, %3</source>
        <translation>关节 %1：%2，移动，%3</translation>
    </message>
    <message>
        <source>joint %1: %2, turns, %3</source>
        <translation>关节 %1：%2，转动，%3</translation>
    </message>
    <message>
        <source>%1 joint from link %2 to link %3</source>
        <translation>%1 个关节，从连杆 %2 到连杆 %3</translation>
    </message>
    <message>
        <source>%1 joints from link %2 to link %3</source>
        <translation>%1 个关节，从连杆 %2 到连杆 %3</translation>
    </message>
    <message>
        <source>tool: link %1 at %2 from the frame of the last joint</source>
        <translation>工具：连杆 %1，距最后一个关节的坐标系 %2</translation>
    </message>
    <message>
        <source>with all readings at 0 the tool stands at %1 in link %2</source>
        <translation>所有读数为 0 时，工具位于连杆 %2 中的 %1</translation>
    </message>
    <message>
        <source>the chain to %1 has %2 moving joints; an arm has at most %3 here: freeze those before the arm, --freeze %4=0</source>
        <translation>通向 %1 的链有 %2 个活动关节；此处机械臂最多有 %3 个：请固定机械臂之前的关节，--freeze %4=0</translation>
    </message>
    <message>
        <source>pose %1: the residual of its %2 is %3 times its standard uncertainty (limit %4). Look at this pose first; hold it back by use = check</source>
        <translation>位姿 %1：其%2的残差是其标准不确定度的 %3 倍（限值 %4）。请先查看此位姿；设“用途 = 检核”可将其留作检验</translation>
    </message>
    <message>
        <source>the residuals are %1 times as large as the uncertainties of points and readings explain: there is more than these (a joint&apos;s elasticity, temperature, an outlier), and the uncertainty of the parameters is stated too small</source>
        <translation>残差是各点和读数的不确定度所能解释的 %1 倍：还有其他因素（关节的弹性、温度、离群值），所给出的参数不确定度过小</translation>
    </message>
    <message>
        <source>these poses hardly tell %1 apart (condition %2): turn more joints further, or hold one of them</source>
        <translation>这些位姿几乎不能区分 %1（条件数 %2）：请让更多关节转得更远，或固定其中之一</translation>
    </message>
    <message>
        <source>no parameter of the arm can be told from these poses: every one of them is coupled with others or held</source>
        <translation>由这些位姿不能得出机械臂的任何参数：每个参数都与其他参数耦合或被固定</translation>
    </message>
    <message>
        <source>the poses of the fit give %1 coordinates, no more than there are unknowns to find: measure more poses, or hold parameters</source>
        <translation>参与拟合的位姿给出 %1 个坐标，不多于待求的未知数：请测量更多位姿，或固定参数</translation>
    </message>
    <message>
        <source>the fit does not converge: look for exchanged poses, readings of the wrong sign or in another unit, and for a nominal robot that is another arm</source>
        <translation>拟合不收敛：请查找对调的位姿、符号或单位错误的读数，以及是否为另一种机械臂的标称机器人</translation>
    </message>
    <message>
        <source>at the solution the unknowns cannot be told apart; hold one of those that the table of observability names</source>
        <translation>在解处不能区分各未知数；请固定可观测性表中所列者之一</translation>
    </message>
    <message>
        <source>joint %1 slides: only arms whose joints turn are identified; take an arm without it, as it stands during the measurement</source>
        <translation>关节 %1 是移动关节：只辨识关节均转动的机械臂；请取不含它的机械臂，保持测量时的状态</translation>
    </message>
    <message>
        <source>the fit has %1 poses; it needs three or more, and about twenty to tell all parameters</source>
        <translation>拟合有 %1 个位姿；至少需要三个，要得出所有参数约需二十个</translation>
    </message>
    <message>
        <source>the robot has only %1 joints; leave %2 empty</source>
        <translation>机器人只有 %1 个关节；请将 %2 留空</translation>
    </message>
    <message>
        <source>pose %1: its orientation is missing; give alpha, beta and gamma of every pose, or fit positions alone</source>
        <translation>位姿 %1：缺少姿态；请给出每个位姿的 alpha、beta 和 gamma，或只拟合位置</translation>
    </message>
    <message>
        <source>the robot has no parameter &apos;%1&apos; to hold; write its symbol, such as d_3</source>
        <translation>机器人没有可固定的参数 &apos;%1&apos;；请写其符号，如 d_3</translation>
    </message>
    <message>
        <source>rotation about %1</source>
        <translation>绕 %1 的旋转</translation>
    </message>
    <message>
        <source>base %1</source>
        <translation>基座点 %1</translation>
    </message>
    <message>
        <source>tool %1</source>
        <translation>工具 %1</translation>
    </message>
    <message>
        <source>the points do not lead to parameters of the arm</source>
        <translation>这些点不能得出机械臂的参数</translation>
    </message>
    <message>
        <source>the points of %1 run against the positive direction of the joint: reverse their order, or give its readings</source>
        <translation>%1 的点与关节的正方向相反：请颠倒其顺序，或给出其读数</translation>
    </message>
    <message>
        <source>the axes of joints %1 and %2</source>
        <translation>关节 %1 和 %2 的轴</translation>
    </message>
    <message>
        <source>%1 are nearly parallel (%2): they are described by beta with d = 0, because the place of their common perpendicular is hardly determined</source>
        <translation>%1几乎平行（%2）：以 beta 且 d = 0 描述，因为其公垂线的位置几乎不能确定</translation>
    </message>
    <message>
        <source>%1 are %2 apart: they are described by d without beta, although the nominal robot has beta</source>
        <translation>%1相距 %2：以 d 而无 beta 描述，尽管标称机器人有 beta</translation>
    </message>
    <message>
        <source>the axes of joints %1 and %2 are the same line: nothing tells their frames apart</source>
        <translation>关节 %1 和 %2 的轴是同一直线：无法区分其坐标系</translation>
    </message>
    <message>
        <source>parameters are identified by Eq 5: describe the nominal robot in that convention, not in Craig&apos;s</source>
        <translation>参数按式 5 辨识：请以该约定而不是 Craig 约定描述标称机器人</translation>
    </message>
    <message>
        <source>joint %1 slides and draws no circle: take an arm without it, as it stands during the measurement</source>
        <translation>关节 %1 是移动关节，不画圆：请取不含它的机械臂，保持测量时的状态</translation>
    </message>
    <message>
        <source>an arm of one joint has no parameters between two axes</source>
        <translation>只有一个关节的机械臂没有两轴之间的参数</translation>
    </message>
    <message>
        <source>the robot has no %1</source>
        <translation>机器人没有 %1</translation>
    </message>
    <message>
        <source>%1 has %2 points; a circle needs three or more</source>
        <translation>%1 有 %2 个点；圆至少需要三个</translation>
    </message>
    <message>
        <source>the ball hardly moves while %1 turns: it lies on the axis of that joint and draws no circle. Fix the ball off the axis</source>
        <translation>%1 转动时球几乎不动：它位于该关节的轴上，不画圆。请将球固定在轴外</translation>
    </message>
    <message>
        <source>the points of %1 lie on a straight line, as far as their uncertainty lets it be seen: no circle goes through them. Turn the joint further</source>
        <translation>就其不确定度所能看出的，%1 的点在一条直线上：没有圆通过它们。请让关节转得更远</translation>
    </message>
    <message>
        <source>the arc of %1 over %2 is short for the uncertainty of its points: its axis will be known poorly</source>
        <translation>%1 在 %2 上的圆弧相对其点的不确定度过短：其轴将很不准确</translation>
    </message>
    <message>
        <source>the plane of %1 passes the origin at %2: Eq 1 excludes planes through the origin and fails near it. Use total least squares</source>
        <translation>%1 的平面在 %2 处经过原点：式 1 排除通过原点的平面，在其附近失效。请使用总体最小二乘</translation>
    </message>
    <message>
        <source>no circle fits the points of %1; look for exchanged points</source>
        <translation>没有圆符合 %1 的点；请查找对调的点</translation>
    </message>
    <message>
        <source>the calibration matrix is singular: the channels answer to loads on %1 alike, so these cannot be told apart</source>
        <translation>校准矩阵奇异：各通道对 %1 上的载荷响应相同，因此不能区分</translation>
    </message>
    <message>
        <source>the calibration matrix has the condition number %1: loads on %2 are hardly told apart</source>
        <translation>校准矩阵的条件数为 %1：%2 上的载荷几乎不能区分</translation>
    </message>
    <message>
        <source>add a row of loads to be evaluated</source>
        <translation>请添加一行要评定的载荷</translation>
    </message>
    <message>
        <source>add a row of readings to be decoupled</source>
        <translation>请添加一行要解耦的读数</translation>
    </message>
    <message>
        <source>two cases are called &apos;%1&apos;</source>
        <translation>有两个工况名为 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>channel %1 has no reading: all channels are needed</source>
        <translation>通道 %1 没有读数：需要所有通道</translation>
    </message>
    <message>
        <source>the sensor has no channel %1</source>
        <translation>传感器没有通道 %1</translation>
    </message>
    <message>
        <source>no load gives these readings by the calibration matrix</source>
        <translation>按校准矩阵没有载荷给出这些读数</translation>
    </message>
    <message>
        <source>the load on %1 is %2 % of its rated load: the calibration says nothing about it</source>
        <translation>%1 上的载荷为其额定载荷的 %2 %：校准对此没有说明</translation>
    </message>
    <message>
        <source>loads on %1 are too few for this calibration matrix</source>
        <translation>%1 上的载荷对此校准矩阵来说过少</translation>
    </message>
    <message>
        <source>the interference of %1 is known without signs: it cannot be compensated. Give raw readings, or a table with signs</source>
        <translation>%1 的干扰不知符号：不能补偿。请给出原始读数，或带符号的表</translation>
    </message>
    <message>
        <source>quadratic terms need raw readings; %1 has a summary only</source>
        <translation>二次项需要原始读数；%1 只有汇总</translation>
    </message>
    <message>
        <source>channel %1 is listed twice</source>
        <translation>通道 %1 列出了两次</translation>
    </message>
    <message>
        <source>moment</source>
        <translation>力矩</translation>
    </message>
    <message>
        <source>force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>channel %1 needs its rated load, a %2</source>
        <translation>通道 %1 需要其额定载荷，即%2</translation>
    </message>
    <message>
        <source>%1 states no uncertainty of its load on %2: add it to its certificate</source>
        <translation>%1 未给出其在 %2 上载荷的不确定度：请将其加入其证书</translation>
    </message>
    <message>
        <source>increasing loads</source>
        <translation>递增载荷</translation>
    </message>
    <message>
        <source>unloaded reading before</source>
        <translation>之前的空载读数</translation>
    </message>
    <message>
        <source>run %1 of %2 has no %3: it is left out</source>
        <translation>%2 的第 %1 测次没有%3：将其省略</translation>
    </message>
    <message>
        <source>%1 was not calibrated: there are no runs with its axis loaded</source>
        <translation>%1 没有校准：没有对其轴加载的测次</translation>
    </message>
    <message>
        <source>%1 has one run only: its repeatability needs two or more</source>
        <translation>%1 只有一个测次：其重复性需要两个或更多</translation>
    </message>
    <message>
        <source>%1 has %2 runs, %3 are planned: its means have %4 degrees of freedom</source>
        <translation>%1 有 %2 个测次，计划为 %3 个：其平均值的自由度为 %4</translation>
    </message>
    <message>
        <source>%1 has %2 preloads, %3 are planned</source>
        <translation>%1 有 %2 次预加载，计划为 %3 次</translation>
    </message>
    <message>
        <source>, and it says nothing about repeatability</source>
        <translation>，且不能说明重复性</translation>
    </message>
    <message>
        <source>step %1 of %2 is missing in %3 of %4 runs: its mean is that of %5%6</source>
        <translation>%2 的第 %1 级在 %4 个测次中的 %3 个缺失：其平均值取自 %5 个测次%6</translation>
    </message>
    <message>
        <source>%1 was loaded in %2 steps, %3 are planned</source>
        <translation>%1 分 %2 级加载，计划为 %3 级</translation>
    </message>
    <message>
        <source>the largest load on %1 is %2; the rated output needs the rated load, %3</source>
        <translation>%1 上的最大载荷为 %2；额定输出需要额定载荷 %3</translation>
    </message>
    <message>
        <source>%1 has the same reading in all runs: its repeatability is evaluated as zero</source>
        <translation>%1 在所有测次中读数相同：其重复性评定为零</translation>
    </message>
    <message>
        <source>%1 has no unloaded readings after a run: its non-zero error is taken as zero</source>
        <translation>%1 在测次之后没有空载读数：其回零误差取为零</translation>
    </message>
    <message>
        <source>%1 has no decreasing loads: its hysteresis is not known and is taken as zero</source>
        <translation>%1 没有递减载荷：其滞后未知，取为零</translation>
    </message>
    <message>
        <source>run %1 of %2 reads the same at steps %3 and %4 although the load rises: the indicator is saturated or the channel is stuck</source>
        <translation>%2 的第 %1 测次在第 %3 级和第 %4 级读数相同，尽管载荷上升：指示器饱和或通道卡住</translation>
    </message>
    <message>
        <source>run %1 of %2: only %3 s between steps %4 and %5, %6 s are planned</source>
        <translation>%2 的第 %1 测次：第 %4 级和第 %5 级之间仅 %3 s，计划为 %6 s</translation>
    </message>
    <message>
        <source>run %1 of %2 begins %3 s after the one before was unloaded, %4 s are planned</source>
        <translation>%2 的第 %1 测次在前一测次卸载后 %3 s 开始，计划为 %4 s</translation>
    </message>
    <message>
        <source>channel %1 does not respond to its load: %2 at the rated load; look at its cable and its column</source>
        <translation>通道 %1 不响应其载荷：在额定载荷下为 %2；请检查其电缆和其列</translation>
    </message>
    <message>
        <source>channel %1 responds to %2 more than to its own load: are columns exchanged?</source>
        <translation>通道 %1 对 %2 的响应大于对其自身载荷的响应：列是否对调了？</translation>
    </message>
    <message>
        <source>there are no readings: import them from a CSV file, or choose summary tables</source>
        <translation>没有读数：请从 CSV 文件导入，或选择汇总表</translation>
    </message>
    <message>
        <source>the sensor has no channel %1: list it among its channels</source>
        <translation>传感器没有通道 %1：请将其列入通道</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no unit of a load: %2</source>
        <translation>&apos;%1&apos; 不是载荷的单位：%2</translation>
    </message>
    <message>
        <source>%1 is a moment, but its load is in %2: are forces and moments, or their units, exchanged?</source>
        <translation>%1 是力矩，但其载荷单位为 %2：力和力矩或其单位是否对调了？</translation>
    </message>
    <message>
        <source>%1 is a force, but its load is in %2: are forces and moments, or their units, exchanged?</source>
        <translation>%1 是力，但其载荷单位为 %2：力和力矩或其单位是否对调了？</translation>
    </message>
    <message>
        <source>a load of %1 is more than 1.2 times the rated load of %2, %3: is its unit right?</source>
        <translation>载荷 %1 超过 %2 额定载荷 %3 的 1.2 倍：其单位对吗？</translation>
    </message>
    <message>
        <source>channel %1 has no reading in this row</source>
        <translation>通道 %1 在此行没有读数</translation>
    </message>
    <message>
        <source>channel %1 indicates %2 mV/V, which is the end of the indicator&apos;s range: the reading is saturated</source>
        <translation>通道 %1 指示 %2 mV/V，即指示器量程的末端：读数饱和</translation>
    </message>
    <message>
        <source>this run has its unloaded reading already</source>
        <translation>此测次已有空载读数</translation>
    </message>
    <message>
        <source>step %1 of this run is given twice</source>
        <translation>此测次的第 %1 级给出了两次</translation>
    </message>
    <message>
        <source>channel %1 has no row in the summary</source>
        <translation>通道 %1 在汇总中没有行</translation>
    </message>
    <message>
        <source>%1 has no row in the table of interference: taken as zero</source>
        <translation>%1 在干扰表中没有行：取为零</translation>
    </message>
    <message>
        <source>axis %1 is listed twice</source>
        <translation>轴 %1 列出了两次</translation>
    </message>
    <message>
        <source>the sensor&apos;s calibration is a summary: there are no steps to pool over, so the largest standard deviation is taken</source>
        <translation>传感器的校准是汇总：没有可合并的各级，因此取最大标准偏差</translation>
    </message>
    <message>
        <source>the name is one of a function or a word of the equations; choose another</source>
        <translation>该名称是方程所用的函数名或关键字；请另选一个</translation>
    </message>
    <message>
        <source>a symbol is made of letters, Greek ones too, digits and &apos;_&apos;, a letter first</source>
        <translation>符号由字母（包括希腊字母）、数字和 &apos;_&apos; 组成，以字母开头</translation>
    </message>
    <message>
        <source>only the first row of a symbol has a value; further rows add components</source>
        <translation>只有符号的第一行有值；其后的行添加分量</translation>
    </message>
    <message>
        <source>the component is in %1, the quantity in %2</source>
        <translation>该分量以 %1 为单位，该量以 %2 为单位</translation>
    </message>
    <message>
        <source>a further row states a component of uncertainty</source>
        <translation>其后的行给出一个不确定度分量</translation>
    </message>
    <message>
        <source>the instrument of the project is missing</source>
        <translation>缺少项目的仪器</translation>
    </message>
    <message>
        <source>the reading of an instrument needs a value</source>
        <translation>仪器的读数需要值</translation>
    </message>
    <message>
        <source>an instrument reads distances here; the unit must be one of length</source>
        <translation>仪器在此读取距离；单位必须是长度单位</translation>
    </message>
    <message>
        <source>%1 reads no distances</source>
        <translation>%1 不读取距离</translation>
    </message>
    <message>
        <source>the value is missing, and no statement gives it</source>
        <translation>缺少值，给出方式也不提供它</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has observations and no row in the table of quantities</source>
        <translation>&apos;%1&apos; 有观测值而在量的表中没有行</translation>
    </message>
    <message>
        <source>Newton&apos;s method finds no solution of this equation from the starting value, at the estimates of the quantities</source>
        <translation>在各量的估计值处，牛顿法从初值出发找不到此方程的解</translation>
    </message>
    <message>
        <source>this operation has no value at the estimates of the quantities (division by zero, root or logarithm of a negative number, or a number too large)</source>
        <translation>此运算在各量的估计值处没有值（除以零、负数的根或对数，或数值过大）</translation>
    </message>
    <message>
        <source>it has several series: leave out the name of the one that is measured now</source>
        <translation>它有多个系列：现在测量的那个请省去名称</translation>
    </message>
    <message>
        <source>the table of observations has no rows for it</source>
        <translation>观测值表中没有它的行</translation>
    </message>
    <message>
        <source>&apos;a&apos; is missing: number of observations of which the value is the mean</source>
        <translation>缺少 &apos;a&apos;：该值为其平均值的观测次数</translation>
    </message>
    <message>
        <source>there is no equation: write one, y = x_1 + x_2</source>
        <translation>没有方程：请写一个，y = x_1 + x_2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is defined by an equation: it cannot be a quantity too</source>
        <translation>&apos;%1&apos; 由方程定义：它不能同时是量</translation>
    </message>
    <message>
        <source>no equation uses &apos;%1&apos;</source>
        <translation>没有方程使用 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>no equation defines &apos;%1&apos;%2</source>
        <translation>没有方程定义 &apos;%1&apos;%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is listed twice</source>
        <translation>&apos;%1&apos; 列出了两次</translation>
    </message>
    <message>
        <source>group &apos;%1&apos;: %2</source>
        <translation>组 &apos;%1&apos;：%2</translation>
    </message>
    <message>
        <source>an analysis of variance needs at least two groups</source>
        <translation>方差分析至少需要两组</translation>
    </message>
    <message>
        <source>no group has more than one observation: nothing tells the scatter within the groups from that between them</source>
        <translation>没有组有一个以上的观测值：无法区分组内与组间的分散性</translation>
    </message>
    <message>
        <source>the curve does not reach %1</source>
        <translation>曲线达不到 %1</translation>
    </message>
    <message>
        <source>, outside of its points</source>
        <translation>，在其点之外</translation>
    </message>
    <message>
        <source>the curve reaches %1 at x = %2%3: say in &apos;near&apos; which of them is meant</source>
        <translation>曲线在 x = %2 处达到 %1%3：请在“邻近”中说明指哪一个</translation>
    </message>
    <message>
        <source>no curve of this degree was found: the iteration for the uncertainties of x does not settle on these points</source>
        <translation>没有找到此次数的曲线：计入 x 的不确定度的迭代在这些点上不收敛</translation>
    </message>
    <message>
        <source>the points do not determine a curve of this degree</source>
        <translation>这些点不能确定此次数的曲线</translation>
    </message>
    <message>
        <source>the x of y = %1 lies outside of the points of the calibration</source>
        <translation>y = %1 的 x 在校准的点之外</translation>
    </message>
    <message>
        <source>the standard uncertainty of y is missing in row %1</source>
        <translation>第 %1 行缺少 y 的标准不确定度</translation>
    </message>
    <message>
        <source>the standard uncertainty of y must be greater than zero in row %1</source>
        <translation>第 %1 行 y 的标准不确定度必须大于零</translation>
    </message>
    <message>
        <source>readings have the scatter of the residuals, which stated uncertainties do not use: give u_y in row %1</source>
        <translation>读数具有残差的分散性，而给出的不确定度不使用它：请在第 %1 行给出 u_y</translation>
    </message>
    <message>
        <source>a curve through the origin needs differences: give y in K</source>
        <translation>通过原点的曲线需要差值：y 请以 K 给出</translation>
    </message>
    <message>
        <source>a polynomial of this degree needs points at %1 different places or more beside the origin</source>
        <translation>此次数的多项式需要除原点外在 %1 个或更多不同位置上的点</translation>
    </message>
    <message>
        <source>a polynomial of this degree needs points at %1 different places or more</source>
        <translation>此次数的多项式需要在 %1 个或更多不同位置上的点</translation>
    </message>
    <message>
        <source>residuals say nothing about the uncertainty unless there are more points than coefficients: add points, or state u_y</source>
        <translation>除非点多于系数，残差不能说明不确定度：请添加点，或给出 u_y</translation>
    </message>
    <message>
        <source>line %1, %2</source>
        <translation>第 %1 行，%2</translation>
    </message>
    <message>
        <source>The mesh is not drawn: %1: %2</source>
        <translation>不绘制网格：%1：%2</translation>
    </message>
    <message>
        <source>The mesh is not drawn: %1</source>
        <translation>不绘制网格：%1</translation>
    </message>
    <message>
        <source>it has more than %1 triangles: thin it out</source>
        <translation>它有超过 %1 个三角形：请减少</translation>
    </message>
    <message>
        <source>triangle %1 has a coordinate that is not a finite number</source>
        <translation>三角形 %1 有一个坐标不是有限数</translation>
    </message>
    <message>
        <source>triangle %1: %2 is no number</source>
        <translation>三角形 %1：%2 不是数字</translation>
    </message>
    <message>
        <source>it ends in triangle %1: it has been cut off</source>
        <translation>它在三角形 %1 处结束：已被截断</translation>
    </message>
    <message>
        <source>triangle %1: %2 stands where %3 should</source>
        <translation>三角形 %1：%2 处应为 %3</translation>
    </message>
    <message>
        <source>it is no STL file: it neither begins with &quot;solid&quot; nor has a header of 84 bytes</source>
        <translation>它不是 STL 文件：既不以 &quot;solid&quot; 开头，也没有 84 字节的文件头</translation>
    </message>
    <message>
        <source>it is no STL file: its header states %1 triangles, and there is more behind them</source>
        <translation>它不是 STL 文件：文件头声明 %1 个三角形，其后还有内容</translation>
    </message>
    <message>
        <source>its header states %1 triangles; it ends in triangle %2</source>
        <translation>其文件头声明 %1 个三角形；它在三角形 %2 处结束</translation>
    </message>
    <message>
        <source>it has no triangles</source>
        <translation>它没有三角形</translation>
    </message>
    <message>
        <source>target uncertainty</source>
        <translation>目标不确定度</translation>
    </message>
    <message>
        <source>mean of the prior</source>
        <translation>先验的均值</translation>
    </message>
    <message>
        <source>standard deviation of the prior</source>
        <translation>先验的标准偏差</translation>
    </message>
    <message>
        <source>the %1 must be greater than zero</source>
        <translation>%1必须大于零</translation>
    </message>
    <message>
        <source>the %1 must be above the lower limit</source>
        <translation>%1必须高于下限</translation>
    </message>
    <message>
        <source>the guard factor of %1 must lie between -10 and 10; 1 is a guard band of U, 0 simple acceptance</source>
        <translation>%1 的保护带系数必须在 -10 和 10 之间；1 为保护带 U，0 为简单接受</translation>
    </message>
    <message>
        <source>the prior of %1 needs both a mean and a standard deviation</source>
        <translation>%1 的先验需要均值和标准偏差两者</translation>
    </message>
    <message>
        <source>the prior of %1 is of use only with a tolerance: give a limit</source>
        <translation>%1 的先验只有在有容差时才有用：请给出界限</translation>
    </message>
    <message>
        <source> in %1</source>
        <translation> 在 %1 中</translation>
    </message>
    <message>
        <source>the model has no output quantity %1%2%3</source>
        <translation>模型没有输出量 %1%2%3</translation>
    </message>
    <message>
        <source>an axis needs at least two values</source>
        <translation>轴至少需要两个值</translation>
    </message>
    <message>
        <source>&apos;from&apos; and &apos;to&apos; must be two different numbers</source>
        <translation>&apos;from&apos; 和 &apos;to&apos; 必须是两个不同的数字</translation>
    </message>
    <message>
        <source>with logarithmic spacing both ends must be greater than zero</source>
        <translation>对数间隔时两端都必须大于零</translation>
    </message>
    <message>
        <source>&apos;%1&apos; takes whole numbers: there are fewer than %2 between the ends</source>
        <translation>&apos;%1&apos; 取整数：两端之间少于 %2 个</translation>
    </message>
    <message>
        <source>a study has one to three axes; this one has %1</source>
        <translation>参数研究有一至三个轴；此处有 %1 个</translation>
    </message>
    <message>
        <source>%1 is varied by two axes</source>
        <translation>%1 由两个轴改变</translation>
    </message>
    <message>
        <source>Monte Carlo needs at least two trials</source>
        <translation>蒙特卡洛至少需要两次试验</translation>
    </message>
    <message>
        <source>the grid has %1 points; a study may have %2</source>
        <translation>网格有 %1 个点；参数研究最多可有 %2 个</translation>
    </message>
    <message>
        <source>the uncertainty of an input quantity can be varied by a factor only</source>
        <translation>输入量的不确定度只能以因子改变</translation>
    </message>
    <message>
        <source>a factor has no unit</source>
        <translation>因子没有单位</translation>
    </message>
    <message>
        <source>a factor of an uncertainty must not be negative</source>
        <translation>不确定度的因子不得为负</translation>
    </message>
    <message>
        <source>a temperature in %1 cannot be multiplied; add to it, or give its values</source>
        <translation>以 %1 表示的温度不能乘以因子；请加上增量，或给出其值</translation>
    </message>
    <message>
        <source>a number that varies</source>
        <translation>变化的数值</translation>
    </message>
    <message>
        <source>an axis of a study</source>
        <translation>参数研究的轴</translation>
    </message>
    <message>
        <source>an output of a study</source>
        <translation>参数研究的输出量</translation>
    </message>
    <message>
        <source>a study</source>
        <translation>参数研究</translation>
    </message>
    <message>
        <source>only numbers of the set-up of an asset can be varied</source>
        <translation>只能改变资源的测量设置中的数字</translation>
    </message>
    <message>
        <source>a target is written as &quot;/setup/KEY&quot;, &quot;/setup/KEY/rows/0/COLUMN&quot;, &quot;/inputs/SYMBOL/estimate&quot; or &quot;/inputs/SYMBOL/components&quot;</source>
        <translation>目标写作 &quot;/setup/KEY&quot;、&quot;/setup/KEY/rows/0/COLUMN&quot;、&quot;/inputs/SYMBOL/estimate&quot; 或 &quot;/inputs/SYMBOL/components&quot;</translation>
    </message>
    <message>
        <source>the set-up has no schema</source>
        <translation>该测量设置没有模式</translation>
    </message>
    <message>
        <source>the set-up has no field %1%2</source>
        <translation>该测量设置没有字段 %1%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not used with the present choices of the set-up</source>
        <translation>按测量设置目前的选择不使用 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number</source>
        <translation>&apos;%1&apos; 不是数字</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not given, so there is nothing to change</source>
        <translation>没有给出 &apos;%1&apos;，因此没有可改变的</translation>
    </message>
    <message>
        <source>a coordinate of the pose &apos;%1&apos; is written as &quot;/setup/%2/position/0&quot; or &quot;/setup/%3/angles/2&quot;</source>
        <translation>位姿 &apos;%1&apos; 的坐标写作 &quot;/setup/%2/position/0&quot; 或 &quot;/setup/%3/angles/2&quot;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not given</source>
        <translation>没有给出 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>a number of the table &apos;%1&apos; is written as &quot;/setup/%2/rows/0/COLUMN&quot; or &quot;/setup/%3/columns/COLUMN&quot;</source>
        <translation>表 &apos;%1&apos; 的数字写作 &quot;/setup/%2/rows/0/COLUMN&quot; 或 &quot;/setup/%3/columns/COLUMN&quot;</translation>
    </message>
    <message>
        <source>the table &apos;%1&apos; has no column %2</source>
        <translation>表 &apos;%1&apos; 没有列 %2</translation>
    </message>
    <message>
        <source>the column %1 does not hold numbers</source>
        <translation>列 %1 中不是数字</translation>
    </message>
    <message>
        <source>the table &apos;%1&apos; is empty</source>
        <translation>表 &apos;%1&apos; 为空</translation>
    </message>
    <message>
        <source>the table &apos;%1&apos; has %2 rows, counted from 0</source>
        <translation>表 &apos;%1&apos; 有 %2 行，从 0 计数</translation>
    </message>
    <message>
        <source>the cell is empty, so there is nothing to change</source>
        <translation>该单元格为空，因此没有可改变的</translation>
    </message>
    <message>
        <source>the column is empty, so there is nothing to change</source>
        <translation>该列为空，因此没有可改变的</translation>
    </message>
    <message>
        <source>of an input quantity, &quot;estimate&quot; or &quot;components&quot; can be varied</source>
        <translation>输入量中可改变 &quot;estimate&quot; 或 &quot;components&quot;</translation>
    </message>
    <message>
        <source>the model has no input quantity %1%2</source>
        <translation>模型没有输入量 %1%2</translation>
    </message>
    <message>
        <source>there is no component %1%2</source>
        <translation>没有分量 %1%2</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; has no unit; it is not a measured number</source>
        <translation>&apos;%2&apos; 的列 &apos;%1&apos; 没有单位；它不是测得的数字</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; is missing</source>
        <translation>缺少 &apos;%2&apos; 的列 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no column &apos;%2&apos;%3; its columns are %4</source>
        <translation>&apos;%1&apos; 没有列 &apos;%2&apos;%3；其列为 %4</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; is given twice</source>
        <translation>&apos;%2&apos; 的列 &apos;%1&apos; 给出了两次</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be one of %2; it is &apos;%3&apos;%4</source>
        <translation>&apos;%1&apos; 必须是 %2 之一；现为 &apos;%3&apos;%4</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a whole number that is not negative; it is %2</source>
        <translation>&apos;%1&apos; 必须是非负整数；现为 %2</translation>
    </message>
    <message>
        <source>a unit is needed here, such as &quot;mm&quot;, not %1</source>
        <translation>此处需要单位，如 &quot;mm&quot;，而不是 %1</translation>
    </message>
    <message>
        <source>a unit with a dimension is needed here, not &apos;%1&apos;</source>
        <translation>此处需要有量纲的单位，而不是 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is of the same dimension as a unit before it; give one of each</source>
        <translation>&apos;%1&apos; 与其前的一个单位量纲相同；请各给一个</translation>
    </message>
    <message>
        <source>what the project states for results</source>
        <translation>项目对结果的规定</translation>
    </message>
    <message>
        <source>the coverage factor must be greater than zero; without one, k follows from the degrees of freedom or the coverage interval</source>
        <translation>包含因子必须大于零；没有时 k 由自由度或包含区间得出</translation>
    </message>
    <message>
        <source>a report has no chapter %1%2</source>
        <translation>报告没有章节 %1%2</translation>
    </message>
    <message>
        <source>there is no analysis %1%2</source>
        <translation>没有分析 %1%2</translation>
    </message>
    <message>
        <source>the contents of the report</source>
        <translation>报告的内容</translation>
    </message>
    <message>
        <source>a requirement</source>
        <translation>要求</translation>
    </message>
    <message>
        <source>a unit of length is needed here, not %1</source>
        <translation>此处需要长度单位，而不是 %1</translation>
    </message>
    <message>
        <source>the size of a view must be greater than zero</source>
        <translation>视图的大小必须大于零</translation>
    </message>
    <message>
        <source>&apos;direction&apos; and &apos;up&apos; must be two different directions, not of length zero</source>
        <translation>&apos;direction&apos; 和 &apos;up&apos; 必须是两个不同的方向，长度不为零</translation>
    </message>
    <message>
        <source>a view</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>%1 is the name of a standard view</source>
        <translation>%1 是标准视图的名称</translation>
    </message>
    <message>
        <source>the name %1 is used twice</source>
        <translation>名称 %1 使用了两次</translation>
    </message>
    <message>
        <source>there is no single value here, but a list or a group</source>
        <translation>此处不是单个值，而是列表或组</translation>
    </message>
    <message>
        <source>there is nothing called &apos;%1&apos; to set</source>
        <translation>没有名为 &apos;%1&apos; 的内容可设</translation>
    </message>
    <message>
        <source>there is nothing called &apos;%1&apos; to set%2</source>
        <translation>没有名为 &apos;%1&apos; 的内容可设%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not of the form /PLACE/IN/THE/PROJECT=VALUE</source>
        <translation>&apos;%1&apos; 不是 /PLACE/IN/THE/PROJECT=VALUE 的形式</translation>
    </message>
    <message>
        <source>%1 is a table: it needs &quot;columns&quot; and &quot;rows&quot;, or the name of a &quot;csv&quot; file</source>
        <translation>%1 是表：它需要 &quot;columns&quot; 和 &quot;rows&quot;，或 &quot;csv&quot; 文件的名称</translation>
    </message>
    <message>
        <source>the columns of %1 must be texts in quotes</source>
        <translation>%1 的列必须是带引号的文本</translation>
    </message>
    <message>
        <source>row %1 of %2 must be a list in brackets, not %3</source>
        <translation>%2 的第 %1 行必须是方括号中的列表，而不是 %3</translation>
    </message>
    <message>
        <source>a text in quotes</source>
        <translation>带引号的文本</translation>
    </message>
    <message>
        <source>the columns of the CSV file of %1 must be an object in braces: a header of the file and the column it stands for</source>
        <translation>%1 的 CSV 文件的列必须是花括号中的对象：文件的列标题及其所代表的列</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must stand for a column of %2 (a text), or for none (an empty text)</source>
        <translation>&apos;%1&apos; 必须代表 %2 的列（文本），或不代表任何列（空文本）</translation>
    </message>
    <message>
        <source>the CSV file &apos;%1&apos; of %2 must be named relative to the project&apos;s folder and lie in it</source>
        <translation>%2 的 CSV 文件 &apos;%1&apos; 必须相对于项目的文件夹命名并位于其中</translation>
    </message>
    <message>
        <source>the CSV file of %1 does not exist: looked for &apos;%2&apos;</source>
        <translation>%1 的 CSV 文件不存在：查找了 &apos;%2&apos;</translation>
    </message>
    <message>
        <source>CSV file of %1: %2</source>
        <translation>%1 的 CSV 文件：%2</translation>
    </message>
    <message>
        <source>%1 must be a whole number, not %2</source>
        <translation>%1 必须是整数，而不是 %2</translation>
    </message>
    <message>
        <source>%1 is %2; its unit is missing: write {&quot;value&quot;: %3, &quot;unit&quot;: &quot;%4&quot;}</source>
        <translation>%1 是%2；缺少其单位：请写 {&quot;value&quot;: %3, &quot;unit&quot;: &quot;%4&quot;}</translation>
    </message>
    <message>
        <source>%1 must be a text in quotes, not %2</source>
        <translation>%1 必须是带引号的文本，而不是 %2</translation>
    </message>
    <message>
        <source>the lines of %1 must be texts in quotes, each one line</source>
        <translation>%1 的各行必须是带引号的文本，每个一行</translation>
    </message>
    <message>
        <source>&apos;%1&apos; of %2 must be a list of three numbers</source>
        <translation>%2 的 &apos;%1&apos; 必须是三个数字的列表</translation>
    </message>
    <message>
        <source>this set-up</source>
        <translation>此测量设置</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be three numbers: x, y, z</source>
        <translation>&apos;%1&apos; 必须是三个数字：x、y、z</translation>
    </message>
    <message>
        <source>a text is needed here, not %1</source>
        <translation>此处需要文本，而不是 %1</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>文件为空</translation>
    </message>
    <message>
        <source>the project ends before this: nothing may follow its closing &apos;}&apos;</source>
        <translation>项目在此之前已结束：其结尾的 &apos;}&apos; 之后不得有内容</translation>
    </message>
    <message>
        <source>%1 (column %2)</source>
        <translation>%1（第 %2 列）</translation>
    </message>
    <message>
        <source>the file is truncated: it ends %1; its rest is missing</source>
        <translation>文件被截断：它在%1结束；其余缺失</translation>
    </message>
    <message>
        <source>lists and objects are nested too deeply</source>
        <translation>列表和对象嵌套过深</translation>
    </message>
    <message>
        <source>where a value is expected</source>
        <translation>在应有值的位置</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is too large a number</source>
        <translation>&apos;%1&apos; 的数值过大</translation>
    </message>
    <message>
        <source>in the middle of a value</source>
        <translation>在值中间</translation>
    </message>
    <message>
        <source>a value is expected here (a number, a text in quotes, a list or an object), not &apos;%1&apos;</source>
        <translation>此处应为值（数字、带引号的文本、列表或对象），而不是 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number that a project file can hold: give a finite number, or null where infinity is meant</source>
        <translation>&apos;%1&apos; 不是项目文件能容纳的数字：请给出有限数，表示无穷大处用 null</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a value: texts stand in double quotes, numbers are written like -12.5e-3</source>
        <translation>&apos;%1&apos; 不是值：文本用双引号，数字写作 -12.5e-3</translation>
    </message>
    <message>
        <source>the text that begins here is not closed by a double quote on its line</source>
        <translation>此处开始的文本在其行中没有以双引号结束</translation>
    </message>
    <message>
        <source>in the middle of a text</source>
        <translation>在文本中间</translation>
    </message>
    <message>
        <source>inside %1</source>
        <translation>在 %1 内部</translation>
    </message>
    <message>
        <source>&apos;,&apos; or &apos;%1&apos; is expected here, inside %2, not &apos;%3&apos;</source>
        <translation>%2 中此处应为 &apos;,&apos; 或 &apos;%1&apos;，而不是 &apos;%3&apos;</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>a key in double quotes is expected here</source>
        <translation>此处应为双引号中的键</translation>
    </message>
    <message>
        <source>the key before this is not a valid text</source>
        <translation>此前的键不是有效文本</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is given twice in the same object</source>
        <translation>&apos;%1&apos; 在同一对象中给出了两次</translation>
    </message>
    <message>
        <source>after the key &apos;%1&apos;</source>
        <translation>在键 &apos;%1&apos; 之后</translation>
    </message>
    <message>
        <source>&apos;:&apos; is expected after the key &apos;%1&apos;</source>
        <translation>键 &apos;%1&apos; 之后应为 &apos;:&apos;</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>列表</translation>
    </message>
    <message>
        <source>there is no kind of asset &apos;%1&apos;%2; known are %3</source>
        <translation>没有资源种类 &apos;%1&apos;%2；已知的有 %3</translation>
    </message>
    <message>
        <source>there is no measurement model &apos;%1&apos;%2; known are %3</source>
        <translation>没有测量模型 &apos;%1&apos;%2；已知的有 %3</translation>
    </message>
    <message>
        <source>%1 is taken from another analysis, with all its uncertainty: remove either this or the link</source>
        <translation>%1 连同其全部不确定度取自另一分析：请去掉此项或该链接</translation>
    </message>
    <message>
        <source>the analysis %1 has errors of its own: %2</source>
        <translation>分析 %1 自身有错误：%2</translation>
    </message>
    <message>
        <source>the analysis %1 has no value at its estimates</source>
        <translation>分析 %1 在其估计值处没有值</translation>
    </message>
    <message>
        <source>the component %1 is not stated alike (held, or edited) by all analyses of the chain: they are taken as independent</source>
        <translation>链中各分析对分量 %1 的规定不同（固定或编辑）：按独立处理</translation>
    </message>
    <message>
        <source>%1 is linked twice</source>
        <translation>%1 链接了两次</translation>
    </message>
    <message>
        <source>%1 is %2; %3 of %4 is %5</source>
        <translation>%1 为%2；%4 的 %3 为%5</translation>
    </message>
    <message>
        <source>the analysis %1 would be made of itself: %2%3</source>
        <translation>分析 %1 会由其自身构成：%2%3</translation>
    </message>
    <message>
        <source>the analysis %1 has no output %2%3</source>
        <translation>分析 %1 没有输出 %2%3</translation>
    </message>
    <message>
        <source>&apos;schemaVersion&apos; is missing</source>
        <translation>缺少 &apos;schemaVersion&apos;</translation>
    </message>
    <message>
        <source>&apos;schemaVersion&apos; must be a whole number</source>
        <translation>&apos;schemaVersion&apos; 必须是整数</translation>
    </message>
    <message>
        <source>written by a newer version of Covaria (schema %1, this program reads up to %2); nothing was changed</source>
        <translation>由更新版本的 Covaria 写入（模式 %1，本程序读取到 %2）；未作任何更改</translation>
    </message>
    <message>
        <source>the text &apos;%1&apos;</source>
        <translation>文本 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the number %1</source>
        <translation>数字 %1</translation>
    </message>
    <message>
        <source>%1 must be an object in braces, not %2</source>
        <translation>%1 必须是花括号中的对象，而不是 %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is missing in %2</source>
        <translation>%2 中缺少 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be %2, not %3</source>
        <translation>&apos;%1&apos; 必须是%2，而不是 %3</translation>
    </message>
    <message>
        <source>a list in brackets</source>
        <translation>方括号中的列表</translation>
    </message>
    <message>
        <source>there is no &apos;%1&apos; in %2%3</source>
        <translation>%2 中没有 &apos;%1&apos;%3</translation>
    </message>
    <message>
        <source>a number with its unit</source>
        <translation>带单位的数字</translation>
    </message>
    <message>
        <source>a whole number from 0 to 18446744073709551615, in quotes</source>
        <translation>引号中 0 至 18446744073709551615 的整数</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be %2; it is %3</source>
        <translation>&apos;%1&apos; 必须是%2；现为 %3</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>%1 之一</translation>
    </message>
    <message>
        <source>a whole number that is not negative</source>
        <translation>非负整数</translation>
    </message>
    <message>
        <source>a text here is not valid UTF-8 or has a wrong \ sequence</source>
        <translation>此处的文本不是有效的 UTF-8，或有错误的 \ 序列</translation>
    </message>
    <message>
        <source>the project</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>an asset</source>
        <translation>资源</translation>
    </message>
    <message>
        <source>an analysis</source>
        <translation>分析</translation>
    </message>
    <message>
        <source>this is not a project of Covaria: it does not begin with &quot;format&quot;: &quot;covaria&quot;</source>
        <translation>这不是 Covaria 的项目：它不以 &quot;format&quot;: &quot;covaria&quot; 开头</translation>
    </message>
    <message>
        <source>it has %1 MB, and projects of up to %2 MB are read: put its long tables into CSV files beside it</source>
        <translation>它有 %1 MB，可读取不超过 %2 MB 的项目：请将其长表放入旁边的 CSV 文件</translation>
    </message>
    <message>
        <source>the project was not saved: it holds a number that is not finite, or fields that belong to no known kind of asset or model</source>
        <translation>项目未保存：其中有不是有限的数字，或不属于任何已知资源种类或模型的字段</translation>
    </message>
    <message>
        <source>the project was not saved: %1</source>
        <translation>项目未保存：%1</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be two capital letters, such as DE; it is &apos;%2&apos;</source>
        <translation>&apos;%1&apos; 必须是两个大写字母，如 DE；现为 &apos;%2&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be one of %2; it is &apos;%3&apos;</source>
        <translation>&apos;%1&apos; 必须是 %2 之一；现为 &apos;%3&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a date of the form 2026-04-17 or an interval 2026-04-17/2026-04-18; it is &apos;%2&apos;</source>
        <translation>&apos;%1&apos; 必须是形如 2026-04-17 的日期或形如 2026-04-17/2026-04-18 的期间；现为 &apos;%2&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a date of the form 2026-04-17; it is &apos;%2&apos;</source>
        <translation>&apos;%1&apos; 必须是形如 2026-04-17 的日期；现为 &apos;%2&apos;</translation>
    </message>
    <message>
        <source>the item cannot have been calibrated before it was received</source>
        <translation>被校物品不可能在收到之前校准</translation>
    </message>
    <message>
        <source>the certificate cannot have been issued before the calibration</source>
        <translation>证书不可能在校准之前签发</translation>
    </message>
    <message>
        <source> (or %1)</source>
        <translation> （或 %1）</translation>
    </message>
    <message>
        <source>&apos;%1&apos;%2 must be stated (ISO/IEC 17025 %3)</source>
        <translation>必须给出 &apos;%1&apos;%2（ISO/IEC 17025 %3）</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be stated (Digital Calibration Certificate)</source>
        <translation>必须给出 &apos;%1&apos;（数字校准证书）</translation>
    </message>
    <message>
        <source>the certificate</source>
        <translation>证书</translation>
    </message>
    <message>
        <source>%1 has more than 2 MB, too much for a logo</source>
        <translation>%1 超过 2 MB，作为徽标过大</translation>
    </message>
    <message>
        <source>%1 is neither a PNG nor a JPEG picture</source>
        <translation>%1 既不是 PNG 也不是 JPEG 图片</translation>
    </message>
    <message>
        <source>The certificate has no logo: %1</source>
        <translation>证书没有徽标：%1</translation>
    </message>
    <message>
        <source>more than %1 columns are not read</source>
        <translation>超过 %1 列不读取</translation>
    </message>
    <message>
        <source>the quote that begins here is not closed</source>
        <translation>此处开始的引号没有关闭</translation>
    </message>
    <message>
        <source>text follows the closing quote of a cell; write a quote inside a quoted cell twice</source>
        <translation>单元格的结束引号之后有文本；引号内的单元格中的引号请写两次</translation>
    </message>
    <message>
        <source>the text is encoded as UTF-16; save it as UTF-8</source>
        <translation>文本编码为 UTF-16；请另存为 UTF-8</translation>
    </message>
    <message>
        <source>the text is not encoded as UTF-8; save it as UTF-8</source>
        <translation>文本编码不是 UTF-8；请另存为 UTF-8</translation>
    </message>
    <message>
        <source>this row has %1 cells; there are %2 columns</source>
        <translation>此行有 %1 个单元格；现有 %2 列</translation>
    </message>
    <message>
        <source>column &apos;%1&apos;: &apos;%2&apos; is not a number</source>
        <translation>列 &apos;%1&apos;：&apos;%2&apos; 不是数字</translation>
    </message>
    <message>
        <source>column &apos;%1&apos;: &apos;%2&apos; is neither true nor false</source>
        <translation>列 &apos;%1&apos;：&apos;%2&apos; 既不是 true 也不是 false</translation>
    </message>
    <message>
        <source>the file has no column &apos;%1&apos;%2; its columns are %3</source>
        <translation>文件没有列 &apos;%1&apos;%2；其列为 %3</translation>
    </message>
    <message>
        <source>there is no row with the names of the columns</source>
        <translation>没有包含列名的行</translation>
    </message>
    <message>
        <source>it has %1 lines, and there is memory for about %2 of these rows: leave rows out, or take means of several</source>
        <translation>它有 %1 行，而内存约够其中 %2 行：请省略一些行，或取若干行的平均</translation>
    </message>
    <message>
        <source>a table to choose from is written as &quot;/setup/KEY/rows&quot;; it is %1</source>
        <translation>供选择的表写作 &quot;/setup/KEY/rows&quot;；现为 %1</translation>
    </message>
    <message>
        <source>a design needs &apos;variables&apos;, a table to &apos;choose&apos; from, or &apos;reductions&apos;</source>
        <translation>设计需要 &apos;variables&apos;、供 &apos;choose&apos; 的表，或 &apos;reductions&apos;</translation>
    </message>
    <message>
        <source>the cheapest reductions are a design of their own, without variables and rows</source>
        <translation>成本最低的减小项是单独的一种设计，没有变量和行</translation>
    </message>
    <message>
        <source>a design has at most %1 reductions</source>
        <translation>一个设计最多有 %1 个减小项</translation>
    </message>
    <message>
        <source>a design has at most %1 variables</source>
        <translation>一个设计最多有 %1 个变量</translation>
    </message>
    <message>
        <source>the cost is that of rows with &apos;prices&apos;: it needs a table to choose from, and no variables</source>
        <translation>成本是带 &apos;prices&apos; 的行的成本：它需要供选择的表，且没有变量</translation>
    </message>
    <message>
        <source>a tolerance must not be negative</source>
        <translation>容差不得为负</translation>
    </message>
    <message>
        <source>&apos;%1&apos; takes whole numbers: a study shows what each of them gives</source>
        <translation>&apos;%1&apos; 取整数：参数研究可显示每个取值的结果</translation>
    </message>
    <message>
        <source>%1 is chosen by two variables</source>
        <translation>%1 由两个变量选择</translation>
    </message>
    <message>
        <source>the smallest factor is between 0 and 1</source>
        <translation>最小因子在 0 和 1 之间</translation>
    </message>
    <message>
        <source>a price must not be negative</source>
        <translation>价格不得为负</translation>
    </message>
    <message>
        <source>%1 is reduced twice</source>
        <translation>%1 减小了两次</translation>
    </message>
    <message>
        <source>of %1 rows, %2 to %3 can be kept; it is %4</source>
        <translation>%1 行中可保留 %2 至 %3 行；现为 %4</translation>
    </message>
    <message>
        <source>there are %1 rows, counted from 0</source>
        <translation>共有 %1 行，从 0 计数</translation>
    </message>
    <message>
        <source>row %1 is fixed twice</source>
        <translation>第 %1 行固定了两次</translation>
    </message>
    <message>
        <source>more rows are fixed than kept</source>
        <translation>固定的行多于保留的行</translation>
    </message>
    <message>
        <source>there is one price for all rows, or one for each of the %1; there are %2</source>
        <translation>所有行用一个价格，或 %1 行各一个；现有 %2 个</translation>
    </message>
    <message>
        <source>a box</source>
        <translation>长方体</translation>
    </message>
    <message>
        <source>every coordinate of &apos;to&apos; must be greater than that of &apos;from&apos;</source>
        <translation>&apos;to&apos; 的每个坐标必须大于 &apos;from&apos; 的坐标</translation>
    </message>
    <message>
        <source>the least distance</source>
        <translation>最小距离</translation>
    </message>
    <message>
        <source>the least distance must be greater than zero</source>
        <translation>最小距离必须大于零</translation>
    </message>
    <message>
        <source>there are 1 to %1 starts</source>
        <translation>起点数为 1 至 %1</translation>
    </message>
    <message>
        <source>at least one evaluation is needed</source>
        <translation>至少需要一次评定</translation>
    </message>
    <message>
        <source>the set-up has no table %1%2</source>
        <translation>测量设置没有表 %1%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be %2; it is &apos;%3&apos;</source>
        <translation>&apos;%1&apos; 必须是%2；现为 &apos;%3&apos;</translation>
    </message>
    <message>
        <source>a variable of a design</source>
        <translation>设计的变量</translation>
    </message>
    <message>
        <source>a number that is reduced</source>
        <translation>被减小的数值</translation>
    </message>
    <message>
        <source>a reduction of a design</source>
        <translation>设计的减小项</translation>
    </message>
    <message>
        <source>the choice of a design</source>
        <translation>设计的选择</translation>
    </message>
    <message>
        <source>a box of a design</source>
        <translation>设计的长方体</translation>
    </message>
    <message>
        <source>a design</source>
        <translation>设计</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a list of numbers</source>
        <translation>&apos;%1&apos; 必须是数字的列表</translation>
    </message>
    <message>
        <source>the parameters of &apos;%1&apos;</source>
        <translation>&apos;%1&apos; 的参数</translation>
    </message>
    <message>
        <source>a distribution</source>
        <translation>分布</translation>
    </message>
    <message>
        <source>there is no distribution &apos;%1&apos;%2; known are %3</source>
        <translation>没有分布 &apos;%1&apos;%2；已知的有 %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is missing in a component</source>
        <translation>分量中缺少 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>a component</source>
        <translation>分量</translation>
    </message>
    <message>
        <source>the edit of an input quantity</source>
        <translation>输入量的编辑</translation>
    </message>
    <message>
        <source>the notes of a quantity</source>
        <translation>量的附注</translation>
    </message>
    <message>
        <source>an output of an analysis</source>
        <translation>分析的输出量</translation>
    </message>
    <message>
        <source>a link</source>
        <translation>链接</translation>
    </message>
    <message>
        <source>a correlation</source>
        <translation>相关</translation>
    </message>
    <message>
        <source>component %1</source>
        <translation>分量 %1</translation>
    </message>
    <message>
        <source>%1 is %2; the unit %3 of %4 is the unit of %5</source>
        <translation>%1 为%2；%4 的单位 %3 是%5的单位</translation>
    </message>
    <message>
        <source>%1: the degrees of freedom must be greater than zero</source>
        <translation>%1：自由度必须大于零</translation>
    </message>
    <message>
        <source>%1 is a component, not an input quantity: it can be held, but not be edited otherwise</source>
        <translation>%1 是分量，不是输入量：可以固定，但不能以其他方式编辑</translation>
    </message>
    <message>
        <source>%1 has no uncertainty to be correlated</source>
        <translation>%1 没有可相关的不确定度</translation>
    </message>
    <message>
        <source>there is no component or quantity %1%2</source>
        <translation>没有分量或量 %1%2</translation>
    </message>
    <message>
        <source>%1 cannot be correlated with itself</source>
        <translation>%1 不能与自身相关</translation>
    </message>
    <message>
        <source>%1 and %2 have the component %3 in common, which correlates them; state the correlation of other components instead</source>
        <translation>%1 和 %2 共有分量 %3，因而相关；请改为给出其他分量的相关</translation>
    </message>
    <message>
        <source>%1 is edited twice</source>
        <translation>%1 编辑了两次</translation>
    </message>
    <message>
        <source>the correlation of %1 and %2 is given twice</source>
        <translation>%1 和 %2 的相关给出了两次</translation>
    </message>
    <message>
        <source>a number is needed here; it is %1</source>
        <translation>此处需要数字；现为 %1</translation>
    </message>
    <message>
        <source>%1: %2 must lie within %3</source>
        <translation>%1：%2 必须在 %3 内</translation>
    </message>
    <message>
        <source>the frame of %1 is missing</source>
        <translation>缺少 %1 的坐标系</translation>
    </message>
    <message>
        <source>no calibration of a robot: &apos;kinematics&apos; is missing</source>
        <translation>不是机器人的校准数据：缺少 &apos;kinematics&apos;</translation>
    </message>
    <message>
        <source>calibration %1</source>
        <translation>校准 %1</translation>
    </message>
    <message>
        <source>lengths in m, angles in rad, about fixed axes as in URDF</source>
        <translation>长度以 m、角度以 rad 为单位，绕固定轴，如 URDF</translation>
    </message>
    <message>
        <source>%1 is called %2 here</source>
        <translation>%1 在此称为 %2</translation>
    </message>
    <message>
        <source>an input without a name</source>
        <translation>没有名称的输入</translation>
    </message>
    <message>
        <source>its %1 must be a number</source>
        <translation>其 %1 必须是数字</translation>
    </message>
    <message>
        <source>there are two inputs of that name</source>
        <translation>有两个同名的输入</translation>
    </message>
    <message>
        <source>%1 %2 is %3 %4</source>
        <translation>%1 %2 为 %3 %4</translation>
    </message>
    <message>
        <source>typea_uncert must be a number from 0</source>
        <translation>typea_uncert 必须是不小于 0 的数字</translation>
    </message>
    <message>
        <source>typea must be a list of at least two observations</source>
        <translation>typea 必须是至少两个观测值的列表</translation>
    </message>
    <message>
        <source>an observation must be a number; those in groups are not read</source>
        <translation>观测值必须是数字；成组的不读取</translation>
    </message>
    <message>
        <source>more than %1 observations are not read</source>
        <translation>超过 %1 个观测值不读取</translation>
    </message>
    <message>
        <source>numnewmeas must be a number from 1</source>
        <translation>numnewmeas 必须是不小于 1 的数字</translation>
    </message>
    <message>
        <source>its observations are taken as independent: Suncal enlarges the uncertainty of more than 50 that are autocorrelated</source>
        <translation>其观测值视为独立：Suncal 对超过 50 个且自相关的观测值会增大不确定度</translation>
    </message>
    <message>
        <source>%1 %2 is no number</source>
        <translation>%1 %2 不是数字</translation>
    </message>
    <message>
        <source>%1 %2 is %3</source>
        <translation>%1 %2 为 %3</translation>
    </message>
    <message>
        <source>degf must be a number greater than 0, or .inf</source>
        <translation>degf 必须是大于 0 的数字或 .inf</translation>
    </message>
    <message>
        <source>; it has %1</source>
        <translation>；它有 %1</translation>
    </message>
    <message>
        <source>the file has no calculation of mode &apos;uncertainty&apos; or &apos;system&apos;%1</source>
        <translation>文件没有模式为 &apos;uncertainty&apos; 或 &apos;system&apos; 的计算%1</translation>
    </message>
    <message>
        <source>%1: %2 quantities, %3 results</source>
        <translation>%1：%2 个量，%3 个结果</translation>
    </message>
    <message>
        <source>the calculation has no inputs</source>
        <translation>该计算没有输入</translation>
    </message>
    <message>
        <source>the calculation has no functions</source>
        <translation>该计算没有函数</translation>
    </message>
    <message>
        <source>the system has no quantities</source>
        <translation>该系统没有量</translation>
    </message>
    <message>
        <source>quantities of type %1 are not read; those that are: direct, indirect</source>
        <translation>不读取类型为 %1 的量；可读取的有：direct, indirect</translation>
    </message>
    <message>
        <source>the system has no direct quantity</source>
        <translation>该系统没有 direct 的量</translation>
    </message>
    <message>
        <source>more than %1 inputs are not read</source>
        <translation>超过 %1 个输入不读取</translation>
    </message>
    <message>
        <source>more than %1 functions are not read</source>
        <translation>超过 %1 个函数不读取</translation>
    </message>
    <message>
        <source>a function has the name of an input or of another function</source>
        <translation>有函数与输入或其他函数同名</translation>
    </message>
    <message>
        <source>%1: in %2 instead of %3</source>
        <translation>%1：以 %2 而不是 %3</translation>
    </message>
    <message>
        <source>%1: no starting value</source>
        <translation>%1：没有初值</translation>
    </message>
    <message>
        <source>%1: state the unit of what is solved for under &apos;units&apos;</source>
        <translation>%1：请在 &apos;units&apos; 下给出所求量的单位</translation>
    </message>
    <message>
        <source>a correlation needs var1 and var2, two inputs, and cor, a number between -1 and 1</source>
        <translation>相关需要 var1 和 var2（两个输入）以及 cor（-1 和 1 之间的数字）</translation>
    </message>
    <message>
        <source>no unit can be stated for %1%2</source>
        <translation>不能为 %1 给出单位%2</translation>
    </message>
    <message>
        <source>the file has no Excel workbook in it</source>
        <translation>文件中没有 Excel 工作簿</translation>
    </message>
    <message>
        <source>the file has no sheet with cells</source>
        <translation>文件没有带单元格的工作表</translation>
    </message>
    <message>
        <source>%1: %2 is no place of a cell</source>
        <translation>%1：%2 不是单元格的位置</translation>
    </message>
    <message>
        <source>%1: more than %2 cells are not read</source>
        <translation>%1：超过 %2 个单元格不读取</translation>
    </message>
    <message>
        <source>its text is missing from the file</source>
        <translation>文件中缺少其文本</translation>
    </message>
    <message>
        <source>the file has a password or the old format .xls: save it as .xlsx without a password</source>
        <translation>文件有密码或为旧格式 .xls：请另存为无密码的 .xlsx</translation>
    </message>
    <message>
        <source>XML of more than %1 MB is not read</source>
        <translation>超过 %1 MB 的 XML 不读取</translation>
    </message>
    <message>
        <source>a document type declaration: files that declare entities are not read</source>
        <translation>文档类型声明：声明实体的文件不读取</translation>
    </message>
    <message>
        <source>an alias (*name): write out what it stands for, aliases are not expanded</source>
        <translation>别名（*name）：请写出它所代表的内容，别名不展开</translation>
    </message>
    <message>
        <source>more than %1 entries are not read</source>
        <translation>超过 %1 个条目不读取</translation>
    </message>
    <message>
        <source>more than %1 levels are not read</source>
        <translation>超过 %1 层不读取</translation>
    </message>
    <message>
        <source>a key must be a word</source>
        <translation>键必须是一个词</translation>
    </message>
    <message>
        <source>the key %1 stands twice</source>
        <translation>键 %1 出现两次</translation>
    </message>
    <message>
        <source>more than 1000 keys are not read</source>
        <translation>超过 1000 个键不读取</translation>
    </message>
    <message>
        <source>YAML of more than %1 kB is not read</source>
        <translation>超过 %1 kB 的 YAML 不读取</translation>
    </message>
    <message>
        <source>the file has no YAML document</source>
        <translation>文件没有 YAML 文档</translation>
    </message>
    <message>
        <source>not readable as YAML: %1</source>
        <translation>不能作为 YAML 读取：%1</translation>
    </message>
    <message>
        <source>the file has %1</source>
        <translation>文件有%1</translation>
    </message>
    <message>
        <source>no readable zip archive in it (%1)</source>
        <translation>其中没有可读的 zip 压缩包（%1）</translation>
    </message>
    <message>
        <source>more than %1 parts, which are not read</source>
        <translation>超过 %1 个部分，不读取</translation>
    </message>
    <message>
        <source>no part %1</source>
        <translation>没有部分 %1</translation>
    </message>
    <message>
        <source>a part %1 that cannot be read</source>
        <translation>不能读取的部分 %1</translation>
    </message>
    <message>
        <source>an encrypted part %1: save it without a password</source>
        <translation>加密的部分 %1：请不带密码保存</translation>
    </message>
    <message>
        <source>a part %1 that cannot be unpacked</source>
        <translation>不能解压的部分 %1</translation>
    </message>
    <message>
        <source>a damaged part %1</source>
        <translation>损坏的部分 %1</translation>
    </message>
    <message>
        <source>parts that unpack to more than %1 MB (at %2), which are not read</source>
        <translation>解压后超过 %1 MB 的部分（在 %2），不读取</translation>
    </message>
    <message>
        <source>no network of GNU Gama: &lt;gama-local&gt; with a &lt;network&gt; is expected</source>
        <translation>不是 GNU Gama 的网络：应为带 &lt;network&gt; 的 &lt;gama-local&gt;</translation>
    </message>
    <message>
        <source>the stated unit of lengths: coordinates of Gama are in metres</source>
        <translation>给出的长度单位：Gama 的坐标以米为单位</translation>
    </message>
    <message>
        <source>&lt;parameters&gt;</source>
        <translation>&lt;parameters&gt;</translation>
    </message>
    <message>
        <source>%1 &lt;%2&gt; with observations</source>
        <translation>%1 个带观测的 &lt;%2&gt;</translation>
    </message>
    <message>
        <source>%1 points without x and y</source>
        <translation>%1 个没有 x 和 y 的点</translation>
    </message>
    <message>
        <source>%1 points have no z: it is taken as 0</source>
        <translation>%1 个点没有 z：取为 0</translation>
    </message>
    <message>
        <source>the network has no points with coordinates x and y</source>
        <translation>网络中没有带坐标 x 和 y 的点</translation>
    </message>
    <message>
        <source>%1 points are to be adjusted: their coordinates are approximate ones</source>
        <translation>%1 个点有待平差：其坐标是近似坐标</translation>
    </message>
    <message>
        <source>: a left-handed frame; x and y are taken as they stand</source>
        <translation>：左手坐标系；x 和 y 按原样采用</translation>
    </message>
    <message>
        <source>coordinates in metres, axes-xy = %1%2</source>
        <translation>以米为单位的坐标，axes-xy = %1%2</translation>
    </message>
    <message>
        <source>%1 = %2 is no number</source>
        <translation>%1 = %2 不是数字</translation>
    </message>
    <message>
        <source>too many points: divide the file</source>
        <translation>点过多：请拆分文件</translation>
    </message>
    <message>
        <source>&lt;coordinates&gt;: point %1 has no x and y</source>
        <translation>&lt;coordinates&gt;：点 %1 没有 x 和 y</translation>
    </message>
    <message>
        <source>a covariance matrix of more than %1 coordinates</source>
        <translation>超过 %1 个坐标的协方差矩阵</translation>
    </message>
    <message>
        <source>the file has no adjusted coordinates</source>
        <translation>文件没有平差后的坐标</translation>
    </message>
    <message>
        <source>point %1 has no x and y</source>
        <translation>点 %1 没有 x 和 y</translation>
    </message>
    <message>
        <source>adjusted coordinates in metres</source>
        <translation>以米为单位的平差后坐标</translation>
    </message>
    <message>
        <source>uncertainties: the file has no &lt;cov-mat&gt;</source>
        <translation>不确定度：文件没有 &lt;cov-mat&gt;</translation>
    </message>
    <message>
        <source>residuals and orientations</source>
        <translation>残差和定向</translation>
    </message>
    <message>
        <source>its dim must be at least the %1 adjusted coordinates, its band less than it</source>
        <translation>其 dim 必须至少为 %1 个平差后的坐标，其 band 小于它</translation>
    </message>
    <message>
        <source>element %1, %2 is no number</source>
        <translation>元素 %1, %2 不是数字</translation>
    </message>
    <message>
        <source>its dim must be the %1 %2, its band less than that</source>
        <translation>其 dim 必须为 %1 个%2，其 band 小于它</translation>
    </message>
    <message>
        <source>element %1, %2: %3 is no number</source>
        <translation>元素 %1, %2：%3 不是数字</translation>
    </message>
    <message>
        <source>a covariance matrix of observations that are left out</source>
        <translation>被略去的观测的协方差矩阵</translation>
    </message>
    <message>
        <source>the standard deviation %1 is no number</source>
        <translation>标准偏差 %1 不是数字</translation>
    </message>
    <message>
        <source>the standard deviation %1 must not be negative</source>
        <translation>标准偏差 %1 不得为负</translation>
    </message>
    <message>
        <source>, %1 of them without a standard deviation</source>
        <translation>，其中 %1 个没有标准偏差</translation>
    </message>
    <message>
        <source>, %1 correlations</source>
        <translation>，%1 个相关</translation>
    </message>
    <message>
        <source>%1 observations%2%3; each is its own result: write the equations of what you measure with them</source>
        <translation>%1 个观测%2%3；每个都是其自身的结果：请用它们写出所测量的方程</translation>
    </message>
    <message>
        <source>%1 observations: more than %2</source>
        <translation>%1 个观测：超过 %2</translation>
    </message>
    <message>
        <source>the stated unit of lengths: words of GSI state theirs</source>
        <translation>给出的长度单位：GSI 的字自带单位</translation>
    </message>
    <message>
        <source>words %1 (%2)</source>
        <translation>字 %1（%2）</translation>
    </message>
    <message>
        <source>%1 readings of reflectors above their points: the targets are the reflectors</source>
        <translation>%1 个对点上方反射器的读数：目标点为反射器</translation>
    </message>
    <message>
        <source>the file has neither coordinates nor readings with a distance</source>
        <translation>文件既没有坐标也没有带距离的读数</translation>
    </message>
    <message>
        <source>the reading of %1: angles and a distance are needed</source>
        <translation>%1 的读数：需要角度和距离</translation>
    </message>
    <message>
        <source>coordinates E, N, H become x, y, z</source>
        <translation>坐标 E、N、H 成为 x、y、z</translation>
    </message>
    <message>
        <source>%1: more than %2 set-ups; divide the file</source>
        <translation>%1：超过 %2 次设站；请拆分文件</translation>
    </message>
    <message>
        <source>%1: its coordinates are not in the file: 0, 0, 0</source>
        <translation>%1：其坐标不在文件中：0, 0, 0</translation>
    </message>
    <message>
        <source>%1: readings of points that have coordinates</source>
        <translation>%1：对有坐标的点的读数</translation>
    </message>
    <message>
        <source>%1: readings do not repeat, or are too far apart for it, and say nothing of their uncertainty: points</source>
        <translation>%1：读数没有重复，或相差过大，不能说明其不确定度：点</translation>
    </message>
    <message>
        <source>no word of GSI: index, information, sign and data are expected</source>
        <translation>不是 GSI 的字：应为字索引、信息、符号和数据</translation>
    </message>
    <message>
        <source>more than %1 blocks</source>
        <translation>超过 %1 个块</translation>
    </message>
    <message>
        <source>a block begins with the word 11 or 41</source>
        <translation>块以字 11 或 41 开头</translation>
    </message>
    <message>
        <source>the data of a word must be digits</source>
        <translation>字的数据必须是数字</translation>
    </message>
    <message>
        <source>the unit &apos;%1&apos; is none of %2</source>
        <translation>单位 &apos;%1&apos; 不是 %2 之一</translation>
    </message>
    <message>
        <source>the file has no blocks of GSI</source>
        <translation>文件没有 GSI 的块</translation>
    </message>
    <message>
        <source>more than %1 lines are not read</source>
        <translation>超过 %1 行不读取</translation>
    </message>
    <message>
        <source>the name of a section is not closed by &apos;]&apos;</source>
        <translation>节的名称没有以 &apos;]&apos; 结束</translation>
    </message>
    <message>
        <source>the section %1 stands twice</source>
        <translation>节 %1 出现两次</translation>
    </message>
    <message>
        <source>neither a section [...] nor a line name=value of one</source>
        <translation>既不是节 [...]，也不是节中的“名称=值”行</translation>
    </message>
    <message>
        <source>no quantity with a value and an uncertainty</source>
        <translation>没有带值和不确定度的量</translation>
    </message>
    <message>
        <source>the file has no equation (Model[1]=)</source>
        <translation>文件没有方程（Model[1]=）</translation>
    </message>
    <message>
        <source>log may be the natural or the decimal logarithm: write ln or log10</source>
        <translation>log 可以是自然对数或常用对数：请写 ln 或 log10</translation>
    </message>
    <message>
        <source>no file of GUM Workbench: the section [Components] is missing</source>
        <translation>不是 GUM Workbench 的文件：缺少节 [Components]</translation>
    </message>
    <message>
        <source>the section [COMP %1] is missing</source>
        <translation>缺少节 [COMP %1]</translation>
    </message>
    <message>
        <source>more than %1 quantities are not read</source>
        <translation>超过 %1 个量不读取</translation>
    </message>
    <message>
        <source>%1= is missing</source>
        <translation>缺少 %1=</translation>
    </message>
    <message>
        <source>quantities of type %1 are not known; those that are: Result, TypBNormal, TypBRectang, TypAPooled</source>
        <translation>未知类型为 %1 的量；已知的有：Result, TypBNormal, TypBRectang, TypAPooled</translation>
    </message>
    <message>
        <source>result %1 as the file states it: %2</source>
        <translation>文件所述的结果 %1：%2</translation>
    </message>
    <message>
        <source>section [%1]</source>
        <translation>节 [%1]</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 个点</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 个点</translation>
    </message>
    <message>
        <source>1 name occurs again and has got a number: first %1</source>
        <translation>1 个名称重复出现并加了编号：首个为 %1</translation>
    </message>
    <message>
        <source>%1 names occur again and have got a number: first %2</source>
        <translation>%1 个名称重复出现并加了编号：首个为 %2</translation>
    </message>
    <message>
        <source>%1 groups in one artefact: their names stand before those of the points</source>
        <translation>一个实物标准器中有 %1 个组：其名称放在点名之前</translation>
    </message>
    <message>
        <source>no uncertainties are stated: u_cal is 0 until you state it</source>
        <translation>未给出不确定度：在您给出之前 u_cal 为 0</translation>
    </message>
    <message>
        <source>u_cal is the largest of the stated standard uncertainties: %1</source>
        <translation>u_cal 为给出的标准不确定度中最大者：%1</translation>
    </message>
    <message>
        <source>u_cal as stated: %1</source>
        <translation>给出的 u_cal：%1</translation>
    </message>
    <message>
        <source>%1 without a stated one</source>
        <translation>%1没有给出不确定度</translation>
    </message>
    <message>
        <source>the uncertainty of each point by itself, and correlations: only up to %1 have an analysis of their own</source>
        <translation>各点自身的不确定度和相关：只有不超过 %1时才有其自身的分析</translation>
    </message>
    <message>
        <source> and 1 correlation coefficient</source>
        <translation> 和 1 个相关系数</translation>
    </message>
    <message>
        <source> and %1 correlation coefficients</source>
        <translation> 和 %1 个相关系数</translation>
    </message>
    <message>
        <source>analysis &apos;Points as stated&apos;: every coordinate with its own uncertainty%1</source>
        <translation>分析 &apos;Points as stated&apos;：每个坐标带其自身的不确定度%1</translation>
    </message>
    <message>
        <source>the file has no points</source>
        <translation>文件没有点</translation>
    </message>
    <message>
        <source>the file has no line &apos;Frame,Time (Seconds),...&apos; with data below</source>
        <translation>文件没有其下带数据的行 &apos;Frame,Time (Seconds),...&apos;</translation>
    </message>
    <message>
        <source>the file must begin with &apos;Format Version,&apos;</source>
        <translation>文件必须以 &apos;Format Version,&apos; 开头</translation>
    </message>
    <message>
        <source>rotations of type %1 are not read: export the take with quaternions</source>
        <translation>不读取类型为 %1 的旋转：请以四元数导出该录制（take）</translation>
    </message>
    <message>
        <source>the file does not state its unit of lengths; state it</source>
        <translation>文件未给出其长度单位；请给出</translation>
    </message>
    <message>
        <source>take %1, lengths in %2, coordinate space %3</source>
        <translation>录制（take）%1，长度以 %2 为单位，坐标空间 %3</translation>
    </message>
    <message>
        <source>%1 columns of markers</source>
        <translation>%1 列标记点</translation>
    </message>
    <message>
        <source>more than %1 rigid bodies are not read</source>
        <translation>超过 %1 个刚体不读取</translation>
    </message>
    <message>
        <source>rigid body %1: columns of its rotation (X, Y, Z, W) or position (X, Y, Z) are missing</source>
        <translation>刚体 %1：缺少其旋转（X、Y、Z、W）或位置（X、Y、Z）的列</translation>
    </message>
    <message>
        <source>the take has no rigid body</source>
        <translation>该录制（take）没有刚体</translation>
    </message>
    <message>
        <source>%1 is not a number of a pose</source>
        <translation>%1 不是位姿的数字</translation>
    </message>
    <message>
        <source>the quaternion of %1 has not the length 1</source>
        <translation>%1 的四元数长度不为 1</translation>
    </message>
    <message>
        <source>the angles about z and x of %1 are not determined: turned by 90 degrees about y. Turn the axes of the body in Motive by 90 degrees</source>
        <translation>%1 绕 z 和 x 的角度不能确定：绕 y 转了 90 度。请在 Motive 中将刚体的轴转 90 度</translation>
    </message>
    <message>
        <source>%1: %2 frames in which it was not seen</source>
        <translation>%1：%2 帧中没有看到它</translation>
    </message>
    <message>
        <source>rigid body %1: at least two frames in which it is seen are needed</source>
        <translation>刚体 %1：至少需要两帧看到它</translation>
    </message>
    <message>
        <source>rigid body %1: mean pose of %2 frames, Type A with covariance; the body must not have moved, and the frames are taken as independent</source>
        <translation>刚体 %1：%2 帧的平均位姿，A 类，带协方差；该刚体不得移动过，各帧视为独立</translation>
    </message>
    <message>
        <source>unit &quot;%1&quot;: write it without parentheses</source>
        <translation>单位“%1”：请不用括号书写</translation>
    </message>
    <message>
        <source>the exponents are too large</source>
        <translation>指数过大</translation>
    </message>
    <message>
        <source>%1; state the columns: %2</source>
        <translation>%1；请给出各列：%2</translation>
    </message>
    <message>
        <source>there is no column %1%2</source>
        <translation>没有列 %1%2</translation>
    </message>
    <message>
        <source>more than %1 points: divide the file</source>
        <translation>超过 %1 个点：请拆分文件</translation>
    </message>
    <message>
        <source> is empty</source>
        <translation> 为空</translation>
    </message>
    <message>
        <source> is not a number</source>
        <translation> 不是数字</translation>
    </message>
    <message>
        <source>: an uncertainty must not be negative</source>
        <translation>：不确定度不得为负</translation>
    </message>
    <message>
        <source> is too large</source>
        <translation> 过大</translation>
    </message>
    <message>
        <source>the line has %1 columns instead of %2; put names that contain blanks into quotes</source>
        <translation>该行有 %1 列而不是 %2 列；含空格的名称请加引号</translation>
    </message>
    <message>
        <source>what stands behind column %1</source>
        <translation>第 %1 列之后的内容</translation>
    </message>
    <message>
        <source>lengths are taken as mm: the file does not say its unit</source>
        <translation>长度按 mm 处理：文件未给出其单位</translation>
    </message>
    <message>
        <source>column %1%2</source>
        <translation>列 %1%2</translation>
    </message>
    <message>
        <source>%1 lines above the headers</source>
        <translation>标题上方的 %1 行</translation>
    </message>
    <message>
        <source>%1 lines of comment</source>
        <translation>%1 行注释</translation>
    </message>
    <message>
        <source>the table has no line of headers; state the columns: %1</source>
        <translation>该表没有标题行；请给出各列：%1</translation>
    </message>
    <message>
        <source>its columns may mean several things (names that are numbers, offsets, weights, tolerances, notes); state the columns: %1</source>
        <translation>其列可能有多种含义（为数字的名称、偏移、权、容差、附注）；请给出各列：%1</translation>
    </message>
    <message>
        <source>six numbers may be X Y Z Ux Uy Uz, but also X Y Z with weights, a vector or the angles of a frame: name the reader if they are uncertainties, or state the columns: %1</source>
        <translation>六个数字可能是 X Y Z Ux Uy Uz，也可能是带权的 X Y Z、矢量或坐标系的角度：若为不确定度请指明读取器，或给出各列：%1</translation>
    </message>
    <message>
        <source>read as %1 (%2)</source>
        <translation>读作 %1（%2）</translation>
    </message>
    <message>
        <source>%1: the file states no unit, %2 is taken</source>
        <translation>%1：文件没有给出单位，取 %2</translation>
    </message>
    <message>
        <source>Analysis &quot;%1&quot; (%2)</source>
        <translation>分析“%1”（%2）</translation>
    </message>
    <message>
        <source>not taken over</source>
        <translation>未采用</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>第 %1 行：%2</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>以及另外 %1 个</translation>
    </message>
    <message>
        <source>and %1 more rows</source>
        <translation>以及另外 %1 行</translation>
    </message>
    <message>
        <source>no reader recognises the file; name the one to read it with</source>
        <translation>没有读取器识别该文件；请指明用于读取的读取器</translation>
    </message>
    <message>
        <source>several readers recognise the file: %1; name one of them</source>
        <translation>多个读取器识别该文件：%1；请指明其中一个</translation>
    </message>
    <message>
        <source>a column cannot be %1; there are %2</source>
        <translation>列不能为 %1；可用的有：%2</translation>
    </message>
    <message>
        <source>the columns %1 and %2 mean the same; state the columns</source>
        <translation>列 %1 和 %2 含义相同；请给出各列</translation>
    </message>
    <message>
        <source>a budget needs columns for the quantity or its name, for an uncertainty (u, U or limits) and one more; state the columns</source>
        <translation>预算需要量或其名称的列、不确定度（u、U 或界限）的列，以及另外一列；请给出各列</translation>
    </message>
    <message>
        <source>the distribution %1 is not known; there are normal, rectangular, triangular, U-shaped</source>
        <translation>未知分布 %1；有 normal, rectangular, triangular, U-shaped</translation>
    </message>
    <message>
        <source>the divisor must be greater than 0</source>
        <translation>除数必须大于 0</translation>
    </message>
    <message>
        <source>an uncertainty must not be negative</source>
        <translation>不确定度不得为负</translation>
    </message>
    <message>
        <source>no uncertainty is stated</source>
        <translation>未给出不确定度</translation>
    </message>
    <message>
        <source>neither divisor, k nor distribution says what the uncertainty %1 is</source>
        <translation>除数、k 和分布都没有说明不确定度 %1 是什么</translation>
    </message>
    <message>
        <source>a normal distribution needs a divisor or k for the uncertainty %1</source>
        <translation>对于不确定度 %1，正态分布需要除数或 k</translation>
    </message>
    <message>
        <source>no row has a number in the stated columns</source>
        <translation>给出的列中没有一行有数字</translation>
    </message>
    <message>
        <source>there is no sheet %1 with cells; there are %2</source>
        <translation>没有带单元格的工作表 %1；现有 %2</translation>
    </message>
    <message>
        <source>the workbook has several sheets, %1: name the sheet whose columns are stated</source>
        <translation>工作簿有多个工作表，%1：请指明已给出其列的工作表</translation>
    </message>
    <message>
        <source>no row of headers of a budget was found; state the columns (quantity, value, unit, U, divisor ...)</source>
        <translation>没有找到预算的标题行；请给出各列（quantity, value, unit, U, divisor ...）</translation>
    </message>
    <message>
        <source>several sheets have a budget: %1; name one of them</source>
        <translation>多个工作表有预算：%1；请指明其中一个</translation>
    </message>
    <message>
        <source>a file that it includes: %1</source>
        <translation>它所包含的文件：%1</translation>
    </message>
    <message>
        <source>the code of a point is expected, a digit</source>
        <translation>应为点的代码，即一位数字</translation>
    </message>
    <message>
        <source>a point that is not to be used: %1</source>
        <translation>不使用的点：%1</translation>
    </message>
    <message>
        <source>code, name, x, y, z, three standard deviations and two deflections of the vertical are expected, there are %1 columns</source>
        <translation>应有代码、名称、x、y、z、三个标准偏差和两个垂线偏差，现有 %1 列</translation>
    </message>
    <message>
        <source>none of their coordinates</source>
        <translation>无</translation>
    </message>
    <message>
        <source>%1 only</source>
        <translation>仅 %1</translation>
    </message>
    <message>
        <source>standard deviations of %1 points of code %2: it constrains %3</source>
        <translation>代码为 %2 的 %1 个点的标准偏差：该代码所约束的坐标：%3</translation>
    </message>
    <message>
        <source>deflections of the vertical of %1 points</source>
        <translation>%1 个点的垂线偏差</translation>
    </message>
    <message>
        <source>%1 points are not constrained: their coordinates are approximate ones for the adjustment</source>
        <translation>%1 个点未受约束：其坐标是平差的近似坐标</translation>
    </message>
    <message>
        <source>%1 comments</source>
        <translation>%1 条注释</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 不是数字</translation>
    </message>
    <message>
        <source>%1: the constraint of %2, which is switched off</source>
        <translation>%1：%2 的约束，已关闭</translation>
    </message>
    <message>
        <source>coordinates in metres</source>
        <translation>以米为单位的坐标</translation>
    </message>
    <message>
        <source>the stated unit of lengths: coordinates of Comp3D are in metres</source>
        <translation>给出的长度单位：Comp3D 的坐标以米为单位</translation>
    </message>
    <message>
        <source>the code of an observation is expected, a whole number</source>
        <translation>应为观测的代码，即整数</translation>
    </message>
    <message>
        <source>an observation of code %1</source>
        <translation>代码为 %1 的观测</translation>
    </message>
    <message>
        <source>code, two points, value, one or two standard deviations and two heights are expected, there are %1 columns</source>
        <translation>应有代码、两个点、值、一个或两个标准偏差和两个高度，现有 %1 列</translation>
    </message>
    <message>
        <source>%1 %2: it is switched off</source>
        <translation>%1 %2：已关闭</translation>
    </message>
    <message>
        <source>the file has no observation that is taken</source>
        <translation>文件中没有可采用的观测</translation>
    </message>
    <message>
        <source>%1 observations, lengths in metres; each is its own result: write the equations of what you measure with them</source>
        <translation>%1 个观测，长度以米为单位；每个都是其自身的结果：请用它们写出所测量的方程</translation>
    </message>
    <message>
        <source>the unit of angles must be one of an angle: gon, deg, rad</source>
        <translation>角度的单位必须是角度单位：gon, deg, rad</translation>
    </message>
    <message>
        <source>%1 %2: the part of its standard deviation that depends on the distance</source>
        <translation>%1 %2：其标准偏差中取决于距离的部分</translation>
    </message>
    <message>
        <source>%1: it is switched off</source>
        <translation>%1：已关闭</translation>
    </message>
    <message>
        <source>a variance of its covariance matrix is negative</source>
        <translation>其协方差矩阵的一个方差为负</translation>
    </message>
    <message>
        <source>its covariance matrix is not symmetric</source>
        <translation>其协方差矩阵不对称</translation>
    </message>
    <message>
        <source>its matrix is no covariance matrix: a variance of some combination is negative</source>
        <translation>其矩阵不是协方差矩阵：某个组合的方差为负</translation>
    </message>
    <message>
        <source>no Digital Calibration Certificate: its root is &lt;%1&gt;</source>
        <translation>不是数字校准证书：其根元素为 &lt;%1&gt;</translation>
    </message>
    <message>
        <source>the certificate has no results with numbers</source>
        <translation>证书没有带数字的结果</translation>
    </message>
    <message>
        <source>schema version %1</source>
        <translation>模式版本 %1</translation>
    </message>
    <message>
        <source>what this version of the schema has beyond version 3</source>
        <translation>该模式版本中超出版本 3 的内容</translation>
    </message>
    <message>
        <source>the stated unit of lengths: a certificate states its units</source>
        <translation>给出的长度单位：证书自有其单位</translation>
    </message>
    <message>
        <source>%1: &lt;measurementMetaData&gt;</source>
        <translation>%1：&lt;measurementMetaData&gt;</translation>
    </message>
    <message>
        <source>a quantity: more than %1 values</source>
        <translation>一个量：超过 %1 个值</translation>
    </message>
    <message>
        <source>%1 as a length standard: more than %2</source>
        <translation>%1 作为长度标准器：超过 %2</translation>
    </message>
    <message>
        <source>the signature: it is not verified</source>
        <translation>签名：未经验证</translation>
    </message>
    <message>
        <source>%1 values, %2 of them with an uncertainty</source>
        <translation>%1 个值，其中 %2 个有不确定度</translation>
    </message>
    <message>
        <source>%1 values, %2 of them with an uncertainty, with covariances</source>
        <translation>%1 个值，其中 %2 个有不确定度，有协方差</translation>
    </message>
    <message>
        <source>length standard %1: delete it where the length is no standard</source>
        <translation>长度标准器 %1：若该长度不是标准器，请删除它</translation>
    </message>
    <message>
        <source>a value as &lt;%1&gt;</source>
        <translation>以 &lt;%1&gt; 表示的值</translation>
    </message>
    <message>
        <source>its relative uncertainty</source>
        <translation>其相对不确定度</translation>
    </message>
    <message>
        <source>the same in other units (%1 is taken)</source>
        <translation>以其他单位表示的同一内容（取 %1）</translation>
    </message>
    <message>
        <source>its lists have different lengths than the %1 values</source>
        <translation>其列表的长度与 %1 个值不同</translation>
    </message>
    <message>
        <source>its covariance matrix: %1</source>
        <translation>其协方差矩阵：%1</translation>
    </message>
    <message>
        <source>its covariance matrix has not %1 x %2 elements</source>
        <translation>其协方差矩阵没有 %1 x %2 个元素</translation>
    </message>
    <message>
        <source>p must be between 0 and 1</source>
        <translation>p 必须在 0 和 1 之间</translation>
    </message>
    <message>
        <source>k must be greater than 0</source>
        <translation>k 必须大于 0</translation>
    </message>
    <message>
        <source>its uncertainty is negative</source>
        <translation>其不确定度为负</translation>
    </message>
    <message>
        <source>it does not begin with \</source>
        <translation>它不以 \ 开头</translation>
    </message>
    <message>
        <source>a brace is not closed</source>
        <translation>有花括号没有关闭</translation>
    </message>
    <message>
        <source>its power &apos;%1&apos; is no small integer</source>
        <translation>其幂 &apos;%1&apos; 不是小整数</translation>
    </message>
    <message>
        <source>&apos;\%1&apos; is not known</source>
        <translation>未知 &apos;\%1&apos;</translation>
    </message>
    <message>
        <source>it ends too early</source>
        <translation>它过早结束</translation>
    </message>
    <message>
        <source>the unit %1: %2</source>
        <translation>单位 %1：%2</translation>
    </message>
    <message>
        <source>sheet %1, columns: %2</source>
        <translation>工作表 %1，列：%2</translation>
    </message>
    <message>
        <source>%1 is no number</source>
        <translation>%1 不是数字</translation>
    </message>
    <message>
        <source>its unit differs from that of the other uncertainty of the row</source>
        <translation>其单位与该行另一个不确定度的单位不同</translation>
    </message>
    <message>
        <source>%1 is no divisor</source>
        <translation>%1 不是除数</translation>
    </message>
    <message>
        <source>degrees of freedom must be greater than 0</source>
        <translation>自由度必须大于 0</translation>
    </message>
    <message>
        <source>row %1: %2</source>
        <translation>第 %1 行：%2</translation>
    </message>
    <message>
        <source>the contribution %1: c and u give %2</source>
        <translation>贡献 %1：c 和 u 得出 %2</translation>
    </message>
    <message>
        <source>the contribution does not follow from c and u in any unit; state the unit behind the coefficient (&apos;-575 nm/K&apos;)</source>
        <translation>在任何单位下贡献都不能由 c 和 u 得出；请在系数后写明单位（&apos;-575 nm/K&apos;）</translation>
    </message>
    <message>
        <source>its unit makes no coefficient of the result</source>
        <translation>其单位不能构成结果的系数</translation>
    </message>
    <message>
        <source>its unit may be %1 or %2: state it behind the coefficient</source>
        <translation>其单位可能是 %1 或 %2：请在系数后写明</translation>
    </message>
    <message>
        <source>what stands below the budget, to row %1</source>
        <translation>预算之下直至第 %1 行的内容</translation>
    </message>
    <message>
        <source>there is no quantity with an uncertainty below</source>
        <translation>其下没有带不确定度的量</translation>
    </message>
    <message>
        <source>row without a quantity</source>
        <translation>没有量的行</translation>
    </message>
    <message>
        <source>row %1 without figures</source>
        <translation>没有数值的第 %1 行</translation>
    </message>
    <message>
        <source>the quantity has no name</source>
        <translation>该量没有名称</translation>
    </message>
    <message>
        <source>row %1: computed anew</source>
        <translation>第 %1 行：重新计算</translation>
    </message>
    <message>
        <source>the unit of the result is not stated: give the result a row of its own, put the unit behind the head of the contributions, or state it as that of &apos;result&apos;</source>
        <translation>未给出结果的单位：请给结果单独一行，把单位写在贡献的标题之后，或作为 &apos;result&apos; 的单位给出</translation>
    </message>
    <message>
        <source>model: %1; the sheet has sensitivity coefficients only, write your equation instead where you have it</source>
        <translation>模型：%1；该表只有灵敏系数，如果有方程，请改写为您的方程</translation>
    </message>
    <message>
        <source>%1 quantities</source>
        <translation>%1 个量</translation>
    </message>
    <message>
        <source>sheet %1</source>
        <translation>工作表 %1</translation>
    </message>
    <message>
        <source>no input quantity has an uncertainty, so that U is 0 everywhere: state the uncertainties of what the analysis uses</source>
        <translation>没有输入量有不确定度，因此 U 处处为 0：请给出分析所用内容的不确定度</translation>
    </message>
    <message>
        <source>%1; the run is to end at %2 trials and will not be stable then. Choose a larger tolerance or fewer digits</source>
        <translation>%1；运行将在 %2 次试验时结束，届时不会稳定。请选择更大的容差或更少的位数</translation>
    </message>
    <message>
        <source>it cannot be read</source>
        <translation>不能读取</translation>
    </message>
    <message>
        <source>%1 has no analysis &quot;%2&quot;</source>
        <translation>%1 没有分析“%2”</translation>
    </message>
    <message>
        <source>%1 refers to other assets of the project and cannot be kept alone</source>
        <translation>%1 引用项目的其他资源，不能单独保留</translation>
    </message>
    <message>
        <source>%1 has errors; open it and repair it before adding to it</source>
        <translation>%1 有错误；请在添加之前打开并修复</translation>
    </message>
    <message>
        <source>asset %1: %2</source>
        <translation>资源 %1：%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; refers to the analysis &apos;%2&apos;</source>
        <translation>&apos;%1&apos; 引用了分析 &apos;%2&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; refers to the asset &apos;%2&apos;</source>
        <translation>&apos;%1&apos; 引用了资源 &apos;%2&apos;</translation>
    </message>
    <message>
        <source>%1, which does not offer %2</source>
        <translation>%1，它不提供 %2</translation>
    </message>
    <message>
        <source>it cannot be made</source>
        <translation>不能生成</translation>
    </message>
    <message>
        <source>the analysis &apos;%1&apos; has errors of its own: %2</source>
        <translation>分析 &apos;%1&apos; 自身有错误：%2</translation>
    </message>
    <message>
        <source>%1, which has errors of its own</source>
        <translation>%1，它自身有错误</translation>
    </message>
    <message>
        <source>%1, which is of the kind &apos;%2&apos; and does not offer %3</source>
        <translation>%1，其种类为 &apos;%2&apos;，不提供 %3</translation>
    </message>
    <message>
        <source>%1, which refers back to this one: %2%3</source>
        <translation>%1，它反过来引用本项：%2%3</translation>
    </message>
    <message>
        <source>%1: only analyses take something from analyses</source>
        <translation>%1：只有分析能取自分析</translation>
    </message>
    <message>
        <source>%1, which does not exist%2</source>
        <translation>%1，它不存在%2</translation>
    </message>
    <message>
        <source>the values given lead to a %1</source>
        <translation>所给的值导致 %1</translation>
    </message>
    <message>
        <source>the memory of this machine does not suffice</source>
        <translation>本机内存不足</translation>
    </message>
    <message>
        <source>a defect of the program was met (%1): please report it with the project</source>
        <translation>遇到程序缺陷（%1）：请连同项目一起报告</translation>
    </message>
    <message>
        <source>%1: the part is damaged or no part at all: delete it and make it anew</source>
        <translation>%1：该部分已损坏，或根本不是运行的一部分：请删除并重新生成</translation>
    </message>
    <message>
        <source>%1: the part was made %2 %3, this is %4: the bits of its results would not be those of one run</source>
        <translation>%1：该部分的生成方式为“%2 %3”，此处为 %4：其结果不会与一次运行的结果逐位相同</translation>
    </message>
    <message>
        <source>%1: the part would have %2 MB, more than %3: divide the run into more parts</source>
        <translation>%1：该部分将有 %2 MB，超过 %3：请将运行分为更多部分</translation>
    </message>
    <message>
        <source>%1: the part is of &quot;%2&quot;, which is not evaluated here: it is of another project</source>
        <translation>%1：该部分属于“%2”，此处不评定它：它来自另一项目</translation>
    </message>
    <message>
        <source>%1: the part is of &quot;%2&quot; in another project or another state of it (fingerprint %3, here %4): make it anew</source>
        <translation>%1：该部分属于另一项目或该项目另一状态的“%2”（指纹 %3，此处 %4）：请重新生成</translation>
    </message>
    <message>
        <source>the model cannot be made</source>
        <translation>不能生成模型</translation>
    </message>
    <message>
        <source>there is no component &apos;%1&apos; here</source>
        <translation>此处没有分量 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>there is no input quantity &apos;%1&apos; here</source>
        <translation>此处没有输入量 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the analysis has no study &apos;%1&apos;</source>
        <translation>该分析没有参数研究 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the study was stopped</source>
        <translation>参数研究已停止</translation>
    </message>
    <message>
        <source>the analysis does not use the asset &apos;%1&apos;: varying it changes nothing</source>
        <translation>该分析不使用资源 &apos;%1&apos;：改变它没有任何影响</translation>
    </message>
    <message>
        <source>the model shows no instruments: a least distance and boxes to keep out of mean nothing to it</source>
        <translation>该模型没有仪器：最小距离和要避开的长方体对它没有意义</translation>
    </message>
    <message>
        <source>the model shows no lines of sight, so that no box can hide them</source>
        <translation>该模型没有视线，因此没有长方体能遮挡它们</translation>
    </message>
    <message>
        <source>the analysis has no design &apos;%1&apos;</source>
        <translation>该分析没有设计 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the variances are not a sum over what is reduced: some of it is correlated, or changes more than a component of uncertainty</source>
        <translation>方差不是所减小各项之和：其中有些是相关的，或改变不止一个不确定度分量</translation>
    </message>
    <message>
        <source>the analysis has no measurand that a design could look at</source>
        <translation>该分析没有设计可以考察的被测量</translation>
    </message>
    <message>
        <source>without target uncertainties U is looked at relative to that of the present design, which has no result (%1): state requirements</source>
        <translation>没有目标不确定度时，U 相对于当前设计的 U 考察，而当前设计没有结果（%1）：请给出要求</translation>
    </message>
    <message>
        <source>U of &apos;%1&apos; is zero now: choose the outputs to look at</source>
        <translation>&apos;%1&apos; 的 U 目前为零：请选择要看的输出量</translation>
    </message>
    <message>
        <source>the cheapest reductions need target uncertainties: state requirements</source>
        <translation>成本最低的减小项需要目标不确定度：请给出要求</translation>
    </message>
    <message>
        <source>the cheapest rows need target uncertainties: state requirements</source>
        <translation>成本最低的行需要目标不确定度：请给出要求</translation>
    </message>
    <message>
        <source>the design was stopped</source>
        <translation>设计已停止</translation>
    </message>
    <message>
        <source>the set-up</source>
        <translation>测量设置</translation>
    </message>
    <message>
        <source>the component &apos;%1&apos; is not of one input quantity alone: change it where it comes from (%2)</source>
        <translation>分量 &apos;%1&apos; 不只属于一个输入量：请在其来源处（%2）更改</translation>
    </message>
    <message>
        <source>Distribution of %1.</source>
        <translation>%1 的分布。</translation>
    </message>
    <message>
        <source>Quantiles of %1, the least normal, against those of a normal distribution.</source>
        <translation>最不正态的 %1 的分位数与正态分布的分位数对照。</translation>
    </message>
    <message>
        <source>Standard uncertainty of %1 against the number of trials.</source>
        <translation>%1 的标准不确定度随试验次数的变化。</translation>
    </message>
    <message>
        <source>%1: uncertainty ellipsoids at a coverage probability of %2, magnified as the picture states.</source>
        <translation>%1：包含概率为 %2 的不确定度椭球，放大倍数见图。</translation>
    </message>
    <message>
        <source>Correlation coefficients of components</source>
        <translation>分量的相关系数</translation>
    </message>
    <message>
        <source>Component</source>
        <translation>分量</translation>
    </message>
    <message>
        <source>Notes on input quantities</source>
        <translation>输入量的附注</translation>
    </message>
    <message>
        <source>Input quantities and the origin of their uncertainties</source>
        <translation>输入量及其不确定度的来源</translation>
    </message>
    <message>
        <source>%1 input quantities; many with equal components share a row. The CSV table of inputs lists every one with its estimate.</source>
        <translation>%1 个输入量；许多分量相同的输入量共用一行。输入量的 CSV 表列出每一个及其估计值。</translation>
    </message>
    <message>
        <source>These input quantities are results of other analyses. All are evaluated together as one model, in every trial, so that the budget goes down to the components of the analyses that they come from; a component that reaches the result on several ways is one component.</source>
        <translation>这些输入量是其他分析的结果。所有分析在每次试验中作为一个模型一起评定，因此预算一直细分到它们所来自的分析的分量；经多条路径到达结果的分量是同一个分量。</translation>
    </message>
    <message>
        <source>Linearised: the analysis that the value comes from is replaced by its law of propagation about its estimates. That is exact to first order; its non-linearity is left out of Monte Carlo.</source>
        <translation>线性化：该值所来自的分析由其在估计值附近的传播律代替。这在一阶上是精确的；蒙特卡洛中不含其非线性。</translation>
    </message>
    <message>
        <source>Where the inputs come from</source>
        <translation>输入的来源</translation>
    </message>
    <message>
        <source>Input quantities taken from other analyses</source>
        <translation>取自其他分析的输入量</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>分析</translation>
    </message>
    <message>
        <source>Its result</source>
        <translation>其结果</translation>
    </message>
    <message>
        <source>%1, linearised</source>
        <translation>%1，线性化</translation>
    </message>
    <message>
        <source>The trials are Sobol points with a random digital shift in each batch; standard errors are from the scatter of the batches.</source>
        <translation>试验是 Sobol 点，每批带有随机数字移位；标准误差由各批的分散性得出。</translation>
    </message>
    <message>
        <source>Mean, standard uncertainty, symmetric interval and covariance were found with the linear part of each output as control variate: its distribution is known exactly, and the trials tell how the output differs from it. Shortest intervals, histograms and probabilities of conformance are those of the trials.</source>
        <translation>平均值、标准不确定度、对称区间和协方差以各输出量的线性部分为控制变量求得：其分布精确已知，试验给出输出量与它的差别。最短区间、直方图和合格概率由试验得出。</translation>
    </message>
    <message>
        <source>At the interval ends each trial is worth %1 plain ones or more.</source>
        <translation>在区间端点，每次试验相当于 %1 次或更多的普通试验。</translation>
    </message>
    <message>
        <source>The adaptive procedure reached its largest number of trials: the results have not stabilised to the numerical tolerance.</source>
        <translation>自适应程序达到了最大试验次数：结果未在数值容差内稳定。</translation>
    </message>
    <message>
        <source>Coverage intervals were read from finely divided cells, not from ordered trials: there were more trials than memory allows to order.</source>
        <translation>包含区间由细分的单元读出，而不是由排序的试验得出：试验次数多于内存可排序的数量。</translation>
    </message>
    <message>
        <source>law of propagation</source>
        <translation>传播律</translation>
    </message>
    <message>
        <source>adaptive</source>
        <translation>自适应</translation>
    </message>
    <message>
        <source>%1, Sobol points</source>
        <translation>%1，Sobol 点</translation>
    </message>
    <message>
        <source>%1, control variate</source>
        <translation>%1，控制变量</translation>
    </message>
    <message>
        <source>Runs that gave these results</source>
        <translation>得出这些结果的运行</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>Fingerprint</source>
        <translation>指纹</translation>
    </message>
    <message>
        <source>The same project, seed and version give the same numbers on any number of threads. The fingerprint covers everything that influences the numbers of an analysis.</source>
        <translation>相同的项目、种子和版本在任意线程数下给出相同的数值。指纹涵盖影响分析数值的一切。</translation>
    </message>
    <message>
        <source>Factors by which the standard uncertainties are to be multiplied so that all measurands of a group lie in the region together with a probability of %1 (JCGM 102 6.5 and 7.7).</source>
        <translation>各标准不确定度应乘的因子，使一组的所有被测量以概率 %1 同时位于区域内（JCGM 102 6.5 和 7.7）。</translation>
    </message>
    <message>
        <source>Factors of the coverage regions</source>
        <translation>包含区域的因子</translation>
    </message>
    <message>
        <source>No ellipsoid is given where the covariance matrix of the group is singular.</source>
        <translation>组的协方差矩阵奇异时不给出椭球。</translation>
    </message>
    <message>
        <source>Target uncertainties</source>
        <translation>目标不确定度</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>结论</translation>
    </message>
    <message>
        <source>With the figure put in, U by the law of propagation is the target; k follows the effective degrees of freedom.</source>
        <translation>代入该数值后，按传播律的 U 即为目标值；k 取决于有效自由度。</translation>
    </message>
    <message>
        <source>With the figure put in, U by Monte Carlo is the target; found with %1 trials of the same draws.</source>
        <translation>代入该数值后，按蒙特卡洛的 U 即为目标值；以同样抽样的 %1 次试验求得。</translation>
    </message>
    <message>
        <source>No component suffices alone: all standard uncertainties multiplied by %1 do.</source>
        <translation>没有一个分量单独足够：所有标准不确定度乘以 %1 则可。</translation>
    </message>
    <message>
        <source>What one component alone must be reduced to for U(%1) to meet its target</source>
        <translation>单独一个分量必须减小到多少，U(%1) 才满足其目标值</translation>
    </message>
    <message>
        <source>needed</source>
        <translation>所需</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>not enough by itself, even if it vanished</source>
        <translation>即使消失，单独也不够</translation>
    </message>
    <message>
        <source>%1: specific consumer&apos;s risk %2 of this decision.</source>
        <translation>%1：该判定的特定使用方风险 %2。</translation>
    </message>
    <message>
        <source>%1: specific producer&apos;s risk %2 of this decision.</source>
        <translation>%1：该判定的特定生产方风险 %2。</translation>
    </message>
    <message>
        <source>%1: specific consumer&apos;s risk %2 of this decision; global risks of the rule for its prior: consumer&apos;s %3, producer&apos;s %4.</source>
        <translation>%1：该判定的特定使用方风险 %2；该规则对其先验分布的全局风险：使用方 %3，生产方 %4。</translation>
    </message>
    <message>
        <source>%1: specific producer&apos;s risk %2 of this decision; global risks of the rule for its prior: consumer&apos;s %3, producer&apos;s %4.</source>
        <translation>%1：该判定的特定生产方风险 %2；该规则对其先验分布的全局风险：使用方 %3，生产方 %4。</translation>
    </message>
    <message>
        <source>Conformity with tolerances</source>
        <translation>与容差的符合性</translation>
    </message>
    <message>
        <source>The requirements are not judged: %1.</source>
        <translation>不判定要求：%1。</translation>
    </message>
    <message>
        <source>U of</source>
        <translation>U 所属的量</translation>
    </message>
    <message>
        <source>Coverage probability %1.</source>
        <translation>包含概率 %1。</translation>
    </message>
    <message>
        <source>Values from the law of propagation of uncertainty (JCGM 100).</source>
        <translation>由不确定度传播律（JCGM 100）得出的值。</translation>
    </message>
    <message>
        <source>Values from the propagation of distributions (JCGM 101) with %1 trials; the interval is probabilistically symmetric, the shortest one beside it. The effective degrees of freedom are those of the law of propagation.</source>
        <translation>由分布传播（JCGM 101）以 %1 次试验得出的值；区间是概率对称的，旁边是最短区间。有效自由度是传播律的。</translation>
    </message>
    <message>
        <source>Components with finite degrees of freedom are drawn from normal distributions, as was chosen: U and k leave these degrees of freedom out, unlike k of the law of propagation (JCGM 100 G.6.4).</source>
        <translation>按所选设置，自由度有限的分量从正态分布抽样：U 与 k 未计入这些自由度，与传播律的 k（JCGM 100 G.6.4）不同。</translation>
    </message>
    <message>
        <source>This result does not represent the measurand: %1 trials, more than 1 %, have no value.</source>
        <translation>该结果不代表被测量：%1 次试验（超过 1 %）没有值。</translation>
    </message>
    <message>
        <source>Law of propagation with second-order terms</source>
        <translation>含二阶项的传播律</translation>
    </message>
    <message>
        <source>JCGM 100 5.1.2, NOTE, for independent components with symmetric distributions. The shift, half the sum of the second derivatives times the variances, is what the mean of the measurand differs by from the value at the estimates; neither is part of the results above.</source>
        <translation>JCGM 100 5.1.2 注，适用于分布对称的独立分量。偏移为二阶导数与方差乘积之和的一半，即被测量的均值与估计值处的值之差；两者都不是上述结果的一部分。</translation>
    </message>
    <message>
        <source>Measurands</source>
        <translation>被测量</translation>
    </message>
    <message>
        <source>Intermediate quantities</source>
        <translation>中间量</translation>
    </message>
    <message>
        <source>Read from %1.</source>
        <translation>读自 %1。</translation>
    </message>
    <message>
        <source>The first %1 of %2 rows; the project file has them all.</source>
        <translation>%2 行中的前 %1 行；项目文件列出全部。</translation>
    </message>
    <message>
        <source>Sobol indices of %1 in %</source>
        <translation>%1 的 Sobol 指数（%）</translation>
    </message>
    <message>
        <source>first order of the law of propagation</source>
        <translation>传播律一阶</translation>
    </message>
    <message>
        <source>standard error of S</source>
        <translation>S 的标准误差</translation>
    </message>
    <message>
        <source>S total</source>
        <translation>总 S</translation>
    </message>
    <message>
        <source>standard error of S total</source>
        <translation>总 S 的标准误差</translation>
    </message>
    <message>
        <source>%1 components with smaller indices are left out.</source>
        <translation>省略了 %1 个指数较小的分量。</translation>
    </message>
    <message>
        <source>Sobol indices</source>
        <translation>Sobol 指数</translation>
    </message>
    <message>
        <source>S is the share of the variance that a component causes by itself, S total the share with all its interactions with others: where both agree and the shares sum to 100 %, the measurement model is additive. Components that are correlated have indices together. By Monte Carlo with %1 pairs of trials.</source>
        <translation>S 是分量自身引起的方差占比，总 S 是包括其与其他分量所有交互作用的占比：两者一致且占比之和为 100 % 时，测量模型是可加的。相关的分量共有指数。按蒙特卡洛法，%1 对试验。</translation>
    </message>
    <message>
        <source>%1 from %2 to %3 (%4 values, logarithmic)</source>
        <translation>%1，从 %2 到 %3（%4 个值，对数）</translation>
    </message>
    <message>
        <source>%1 from %2 to %3 (%4 values)</source>
        <translation>%1，从 %2 到 %3（%4 个值）</translation>
    </message>
    <message>
        <source>Evaluated at %1 grid points, with %2 trials at each.</source>
        <translation>在 %1 个网格点评定，每点 %2 次试验。</translation>
    </message>
    <message>
        <source>Evaluated at %1 grid points, by the law of propagation of uncertainty.</source>
        <translation>在 %1 个网格点按不确定度传播律评定。</translation>
    </message>
    <message>
        <source>Varied: %1.</source>
        <translation>变化的量：%1。</translation>
    </message>
    <message>
        <source>The CSV table of the study has all output quantities.</source>
        <translation>参数研究的 CSV 表列出所有输出量。</translation>
    </message>
    <message>
        <source>%1: best and worst grid points</source>
        <translation>%1：最好和最差的网格点</translation>
    </message>
    <message>
        <source>least</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>greatest</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>What is given for %1 of the grid points does not represent the measurand: more than 1 % of their trials have no value (see the CSV table).</source>
        <translation>对其中 %1 个网格点所给出的不代表被测量：其试验有超过 1 % 没有值（见 CSV 表）。</translation>
    </message>
    <message>
        <source>%1 grid points have no values:</source>
        <translation>%1 个网格点没有值：</translation>
    </message>
    <message>
        <source>others: see the CSV table of the study</source>
        <translation>其他：见参数研究的 CSV 表</translation>
    </message>
    <message>
        <source>law of propagation of uncertainty</source>
        <translation>不确定度传播律</translation>
    </message>
    <message>
        <source>adaptive Monte Carlo, %1 trials</source>
        <translation>自适应蒙特卡洛，%1 次试验</translation>
    </message>
    <message>
        <source>Monte Carlo, %1 trials</source>
        <translation>蒙特卡洛，%1 次试验</translation>
    </message>
    <message>
        <source>%1; %2; coverage probability %3</source>
        <translation>%1；%2；包含概率 %3</translation>
    </message>
    <message>
        <source>k, intervals and the law of propagation are in the results of the analysis.</source>
        <translation>k、区间和传播律见该分析的结果。</translation>
    </message>
    <message>
        <source>Not evaluated: %1: %2.</source>
        <translation>未评定：%1：%2。</translation>
    </message>
    <message>
        <source>Study &quot;%1&quot; not evaluated: %2: %3.</source>
        <translation>参数研究“%1”未评定：%2：%3。</translation>
    </message>
    <message>
        <source>Expanded uncertainty U: %1</source>
        <translation>扩展不确定度 U：%1</translation>
    </message>
    <message>
        <source>Results: %1</source>
        <translation>结果：%1</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>作者</translation>
    </message>
    <message>
        <source>Evaluated with</source>
        <translation>评定软件</translation>
    </message>
    <message>
        <source>Not in this report</source>
        <translation>不在本报告中</translation>
    </message>
    <message>
        <source>Project fingerprint</source>
        <translation>项目指纹</translation>
    </message>
    <message>
        <source>Evaluated with an earlier analysis: %1.</source>
        <translation>与先前的分析一起评定：%1。</translation>
    </message>
    <message>
        <source>Budget of %1, %2</source>
        <translation>%1 的预算，%2</translation>
    </message>
    <message>
        <source>%1 further components</source>
        <translation>另外 %1 个分量</translation>
    </message>
    <message>
        <source>combined (law of propagation)</source>
        <translation>合成（传播律）</translation>
    </message>
    <message>
        <source>%1 = %2, u_c = %3, effective degrees of freedom %4, k = %5, p = %6 (law of propagation).</source>
        <translation>%1 = %2，u_c = %3，有效自由度 %4，k = %5，p = %6（传播律）。</translation>
    </message>
    <message>
        <source>Shares of the variance in % by %1, %2</source>
        <translation>按%1的方差占比（%），%2</translation>
    </message>
    <message>
        <source>together</source>
        <translation>合计</translation>
    </message>
    <message>
        <source>other</source>
        <translation>其他</translation>
    </message>
    <message>
        <source>Components by falling share of the variance; cᵢ in the unit of the measurand per unit of the component.</source>
        <translation>分量按方差占比递减排列；cᵢ 的单位为被测量的单位除以分量的单位。</translation>
    </message>
    <message>
        <source>Contributions to the variance of %1.</source>
        <translation>对 %1 的方差的贡献。</translation>
    </message>
    <message>
        <source>Estimates and standard uncertainties by both methods</source>
        <translation>两种方法的估计值和标准不确定度</translation>
    </message>
    <message>
        <source>Where a distribution is too skewed, heavy-tailed or flat for k u, state its coverage interval.</source>
        <translation>当分布对 k u 而言过于偏斜、尾部过重或过平时，请给出其包含区间。</translation>
    </message>
    <message>
        <source>The expanded uncertainty U beside what remains of it when everything that a contributor brings in is kept at its estimate (an ideal one), and what that contributor gives alone, with the same coverage factor.</source>
        <translation>扩展不确定度 U，旁边是将一个贡献源带来的一切保持在其估计值（理想的贡献源）时剩下的部分，以及该贡献源单独产生的部分，包含因子相同。</translation>
    </message>
    <message>
        <source>By Monte Carlo with %1 trials.</source>
        <translation>按蒙特卡洛法，%1 次试验。</translation>
    </message>
    <message>
        <source>By the law of propagation.</source>
        <translation>按传播律。</translation>
    </message>
    <message>
        <source>Without %1, %2 trials had no value.</source>
        <translation>去掉 %1 时，%2 次试验没有值。</translation>
    </message>
    <message>
        <source>U without each contributor, and of it alone</source>
        <translation>去掉每个贡献源的 U，以及仅有它的 U</translation>
    </message>
    <message>
        <source>without %1</source>
        <translation>去掉 %1</translation>
    </message>
    <message>
        <source>%1 alone</source>
        <translation>仅 %1</translation>
    </message>
    <message>
        <source>Of two contributors, what remains without one is what the other gives alone.</source>
        <translation>若有两个贡献源，去掉其中一个后剩下的即为另一个单独产生的。</translation>
    </message>
    <message>
        <source>Results by contributor</source>
        <translation>按贡献源的结果</translation>
    </message>
    <message>
        <source>Correlation coefficients, %1</source>
        <translation>相关系数，%1</translation>
    </message>
    <message>
        <source>Between groups, which share input quantities, the largest coefficient is %1.</source>
        <translation>在共用输入量的组之间，最大系数为 %1。</translation>
    </message>
    <message>
        <source>Between groups, which share input quantities, the largest coefficient is %1, of %2 with %3.</source>
        <translation>在共用输入量的组之间，最大系数为 %1，即 %2 与 %3。</translation>
    </message>
    <message>
        <source>The CSV table of correlations has all of them.</source>
        <translation>相关性的 CSV 表列出全部。</translation>
    </message>
    <message>
        <source>Looked for: the smallest %1.</source>
        <translation>寻找：最小的 %1。</translation>
    </message>
    <message>
        <source>Looked for: the cheapest reductions of uncertainty with which all targets are met.</source>
        <translation>寻找：使所有目标值得到满足、且成本最低的不确定度减小项。</translation>
    </message>
    <message>
        <source>Looked for: the cheapest rows with which all targets are met.</source>
        <translation>寻找：使所有目标值得到满足、且成本最低的行。</translation>
    </message>
    <message>
        <source>Cost: %1.</source>
        <translation>成本：%1。</translation>
    </message>
    <message>
        <source>Found: %1, before %2.</source>
        <translation>找到：%1，之前 %2。</translation>
    </message>
    <message>
        <source>Found: %1.</source>
        <translation>找到：%1。</translation>
    </message>
    <message>
        <source>Nothing that was tried has a result.</source>
        <translation>所尝试的均无结果。</translation>
    </message>
    <message>
        <source>%1 candidates were evaluated by the law of propagation of uncertainty, all that there are.</source>
        <translation>按不确定度传播律评定了 %1 个候选项，即全部候选项。</translation>
    </message>
    <message>
        <source>%1 candidates were evaluated by the law of propagation of uncertainty.</source>
        <translation>按不确定度传播律评定了 %1 个候选项。</translation>
    </message>
    <message>
        <source>Verified by Monte Carlo with %1 trials.</source>
        <translation>以 %1 次试验的蒙特卡洛验证。</translation>
    </message>
    <message>
        <source>Not every target is met: what is given is the best that was found.</source>
        <translation>并非每个目标值都得到满足：给出的是找到的最佳结果。</translation>
    </message>
    <message>
        <source>%1: the way of the search to the best place, coloured by the objective.</source>
        <translation>%1：搜索到最佳位置的路径，按目标函数着色。</translation>
    </message>
    <message>
        <source>%1: the candidates, coloured by what they gain; the larger ones are chosen.</source>
        <translation>%1：候选项，按其收益着色；较大的被选中。</translation>
    </message>
    <message>
        <source>combined</source>
        <translation>合成</translation>
    </message>
    <message>
        <source>%1, constant</source>
        <translation>%1，常量</translation>
    </message>
    <message>
        <source>%1 components, added arithmetically</source>
        <translation>%1 个分量，代数相加</translation>
    </message>
    <message>
        <source>%1 components, in quadrature</source>
        <translation>%1 个分量，方和根</translation>
    </message>
    <message>
        <source>Table %1. %2</source>
        <translation>表 %1 %2</translation>
    </message>
    <message>
        <source>Figure %1. %2</source>
        <translation>图 %1 %2</translation>
    </message>
    <message>
        <source>Uncertainty report</source>
        <translation>不确定度报告</translation>
    </message>
    <message>
        <source>Report of an uncertainty evaluation</source>
        <translation>不确定度评定报告</translation>
    </message>
    <message>
        <source>Annex</source>
        <translation>附录</translation>
    </message>
    <message>
        <source>In the annex: %1.</source>
        <translation>在附录中：%1。</translation>
    </message>
    <message>
        <source>In the annex, on request: %1.</source>
        <translation>在附录中（按需）：%1。</translation>
    </message>
    <message>
        <source>The first %1 of %2 rows; the annex has all of them.</source>
        <translation>%2 行中的前 %1 行；附录列出全部。</translation>
    </message>
    <message>
        <source>The first %1 of %2 rows; the CSV tables, and the annex on request, have all of them.</source>
        <translation>%2 行中的前 %1 行；CSV 表以及按需的附录列出全部。</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables; the annex has the rest.</source>
        <translation>显示 %2 个表中的 %1 个；其余见附录。</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables; the CSV tables, and the annex on request, have the rest.</source>
        <translation>显示 %2 个表中的 %1 个；其余见 CSV 表以及按需的附录。</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 charts; the annex has the rest.</source>
        <translation>显示 %2 张图中的 %1 张；其余见附录。</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 charts; the CSV tables, and the annex on request, have the rest.</source>
        <translation>显示 %2 张图中的 %1 张；其余见 CSV 表以及按需的附录。</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables and %3 of %4 charts; the annex has the rest.</source>
        <translation>显示 %2 个表中的 %1 个和 %4 张图中的 %3 张；其余见附录。</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables and %3 of %4 charts; the CSV tables, and the annex on request, have the rest.</source>
        <translation>显示 %2 个表中的 %1 个和 %4 张图中的 %3 张；其余见 CSV 表以及按需的附录。</translation>
    </message>
    <message>
        <source>%1 (constant)</source>
        <translation>%1（常量）</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>After</source>
        <translation>之后</translation>
    </message>
    <message>
        <source>U is stated by different rules: before, %1 After, %2</source>
        <translation>U 按不同的规则给出。之前：%1之后：%2</translation>
    </message>
    <message>
        <source>%1 of %2 measurands are in both results; the budgets of %3 of them differ.</source>
        <translation>%2 个被测量中有 %1 个在两个结果中；其中 %3 个的预算不同。</translation>
    </message>
    <message>
        <source>Shown are the %1 whose standard uncertainty changes most, relative to what it was.</source>
        <translation>显示标准不确定度相对于原值变化最大的 %1 个。</translation>
    </message>
    <message>
        <source>Distribution of %1 before and after.</source>
        <translation>%1 之前和之后的分布。</translation>
    </message>
    <message>
        <source>Comparison of uncertainty evaluations</source>
        <translation>不确定度评定的比较</translation>
    </message>
    <message>
        <source>Only before: %1.</source>
        <translation>仅在之前：%1。</translation>
    </message>
    <message>
        <source>Only after: %1.</source>
        <translation>仅在之后：%1。</translation>
    </message>
    <message>
        <source>this report</source>
        <translation>本报告</translation>
    </message>
    <message>
        <source>there are no results for the certificate to state</source>
        <translation>没有可供证书给出的结果</translation>
    </message>
    <message>
        <source>the standard uncertainty of %1 is not finite; a Digital Calibration Certificate has no place for that</source>
        <translation>%1 的标准不确定度不是有限的；数字校准证书无法容纳</translation>
    </message>
    <message>
        <source>there is no robot to write: no analysis uses or finds one</source>
        <translation>没有可写入的机器人：没有分析使用或求得机器人</translation>
    </message>
    <message>
        <source>the file is of one robot, and there are %1: choose an analysis that uses or finds the one to write (--analysis)</source>
        <translation>文件只容一个机器人，而现有 %1 个：请选择使用或求得所要机器人的分析（--analysis）</translation>
    </message>
    <message>
        <source>there are no points to write: no analysis has a result with coordinates x, y, z of a point</source>
        <translation>没有可写入的点：没有分析的结果含有点的坐标 x、y、z</translation>
    </message>
    <message>
        <source>robot %1: the file is of six joints that turn (shoulder to wrist_3); write it as URDF</source>
        <translation>机器人 %1：该文件用于六个转动关节（shoulder 至 wrist_3）；请写为 URDF</translation>
    </message>
    <message>
        <source>there are no results to write</source>
        <translation>没有可写入的结果</translation>
    </message>
    <message>
        <source>the workbook cannot be made in the folder for temporary files</source>
        <translation>不能在临时文件的文件夹中生成工作簿</translation>
    </message>
    <message>
        <source>the report carries no results to compare with (results.json)</source>
        <translation>报告中没有可比较的结果（results.json）</translation>
    </message>
    <message>
        <source>what the report carries as results.json is none of Covaria</source>
        <translation>报告中的 results.json 不是 Covaria 的</translation>
    </message>
    <message>
        <source>no folder could be made in %1: %2</source>
        <translation>不能在 %1 中创建文件夹：%2</translation>
    </message>
    <message>
        <source>the attached file %1 would leave its folder; nothing was taken out</source>
        <translation>附件 %1 会超出其文件夹；未取出任何文件</translation>
    </message>
    <message>
        <source>the attached file %1 cannot be taken out: another one is in its way</source>
        <translation>不能取出附件 %1：有另一个文件挡路</translation>
    </message>
    <message>
        <source>it is no PDF</source>
        <translation>它不是 PDF</translation>
    </message>
    <message>
        <source>it carries no project: it is no report of Covaria, or one of a version before 0.2.0, or another program has written it anew</source>
        <translation>其中没有项目：它不是 Covaria 的报告，或出自 0.2.0 之前的版本，或被其他程序重新写过</translation>
    </message>
    <message>
        <source>best</source>
        <translation>最好</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>最差</translation>
    </message>
    <message>
        <source>iso-surfaces at %1</source>
        <translation>等值面取值 %1</translation>
    </message>
    <message>
        <source>the study has not been run</source>
        <translation>该参数研究尚未运行</translation>
    </message>
    <message>
        <source>none of the study&apos;s output quantities has a place in space</source>
        <translation>该参数研究的输出量都没有空间位置</translation>
    </message>
    <message>
        <source>the point %1 does not move in this study</source>
        <translation>点 %1 在此参数研究中不移动</translation>
    </message>
    <message>
        <source>best: %1</source>
        <translation>最好：%1</translation>
    </message>
    <message>
        <source>nothing that this design chooses stands in space</source>
        <translation>该设计所选的都不在空间中</translation>
    </message>
    <message>
        <source>nothing that was tried has a result</source>
        <translation>所尝试的均没有结果</translation>
    </message>
    <message>
        <source>candidates; the larger %1 of %2 are chosen</source>
        <translation>候选项；%2 个中较大的 %1 个被选中</translation>
    </message>
    <message>
        <source>gain: by how much the uncertainty is smaller with this candidate than without it, the others as chosen</source>
        <translation>收益：有此候选项比没有它时不确定度减小多少，其他按所选</translation>
    </message>
    <message>
        <source>best so far, in the order of the search</source>
        <translation>目前最佳，按搜索顺序</translation>
    </message>
    <message>
        <source>dashed: where it may stand</source>
        <translation>虚线：可放置的范围</translation>
    </message>
    <message>
        <source>analysis</source>
        <translation>分析</translation>
    </message>
    <message>
        <source>kind</source>
        <translation>种类</translation>
    </message>
    <message>
        <source>trajectory</source>
        <translation>轨迹</translation>
    </message>
    <message>
        <source>mean Monte Carlo</source>
        <translation>平均值，蒙特卡洛</translation>
    </message>
    <message>
        <source>u Monte Carlo</source>
        <translation>u，蒙特卡洛</translation>
    </message>
    <message>
        <source>interval low</source>
        <translation>区间下限</translation>
    </message>
    <message>
        <source>interval high</source>
        <translation>区间上限</translation>
    </message>
    <message>
        <source>shortest low</source>
        <translation>最短区间下限</translation>
    </message>
    <message>
        <source>shortest high</source>
        <translation>最短区间上限</translation>
    </message>
    <message>
        <source>skewness</source>
        <translation>偏度</translation>
    </message>
    <message>
        <source>excess kurtosis</source>
        <translation>超值峰度</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>比值</translation>
    </message>
    <message>
        <source>y at the estimates</source>
        <translation>估计值处的 y</translation>
    </message>
    <message>
        <source>u law of prop.</source>
        <translation>u，传播律</translation>
    </message>
    <message>
        <source>u with second-order terms</source>
        <translation>u，含二阶项</translation>
    </message>
    <message>
        <source>shift of the estimate</source>
        <translation>估计值的偏移</translation>
    </message>
    <message>
        <source>|cᵢ|·u(xᵢ) in %1</source>
        <translation>|cᵢ|·u(xᵢ)，单位 %1</translation>
    </message>
    <message>
        <source>Share of variance in %</source>
        <translation>方差占比（%）</translation>
    </message>
    <message>
        <source>alone, Monte Carlo, in %1</source>
        <translation>单独，蒙特卡洛，单位 %1</translation>
    </message>
    <message>
        <source>ellipsoid, law of prop.</source>
        <translation>椭球，传播律</translation>
    </message>
    <message>
        <source>rectangle, law of prop.</source>
        <translation>矩形，传播律</translation>
    </message>
    <message>
        <source>ellipsoid, Monte Carlo</source>
        <translation>椭球，蒙特卡洛</translation>
    </message>
    <message>
        <source>rectangle, Monte Carlo</source>
        <translation>矩形，蒙特卡洛</translation>
    </message>
    <message>
        <source>y before</source>
        <translation>y，之前</translation>
    </message>
    <message>
        <source>y after</source>
        <translation>y，之后</translation>
    </message>
    <message>
        <source>Change of y</source>
        <translation>y 的变化</translation>
    </message>
    <message>
        <source>What</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>|c|·u before in %1</source>
        <translation>|c|·u，之前，单位 %1</translation>
    </message>
    <message>
        <source>|c|·u after in %1</source>
        <translation>|c|·u，之后，单位 %1</translation>
    </message>
    <message>
        <source>Share before in %</source>
        <translation>之前的占比（%）</translation>
    </message>
    <message>
        <source>Share after in %</source>
        <translation>之后的占比（%）</translation>
    </message>
    <message>
        <source>Change of variance in %</source>
        <translation>方差变化（%）</translation>
    </message>
    <message>
        <source>first rotation, about z</source>
        <translation>第一次旋转，绕 z</translation>
    </message>
    <message>
        <source>second rotation, about y</source>
        <translation>第二次旋转，绕 y</translation>
    </message>
    <message>
        <source>third rotation, about z</source>
        <translation>第三次旋转，绕 z</translation>
    </message>
    <message>
        <source>rotation vector, x</source>
        <translation>旋转矢量，x</translation>
    </message>
    <message>
        <source>rotation vector, y</source>
        <translation>旋转矢量，y</translation>
    </message>
    <message>
        <source>rotation vector, z</source>
        <translation>旋转矢量，z</translation>
    </message>
    <message>
        <source>quaternion, scalar part</source>
        <translation>四元数，标量部分</translation>
    </message>
    <message>
        <source>quaternion, x</source>
        <translation>四元数，x</translation>
    </message>
    <message>
        <source>quaternion, y</source>
        <translation>四元数，y</translation>
    </message>
    <message>
        <source>quaternion, z</source>
        <translation>四元数，z</translation>
    </message>
    <message>
        <source>Coordinates that define the frame are left out.</source>
        <translation>定义坐标系的坐标不列出。</translation>
    </message>
    <message>
        <source>%1, coordinate %2</source>
        <translation>%1，坐标 %2</translation>
    </message>
    <message>
        <source>tool centre point</source>
        <translation>工具中心点</translation>
    </message>
    <message>
        <source>centre of the flange</source>
        <translation>法兰中心</translation>
    </message>
    <message>
        <source>calibration of the artefact</source>
        <translation>实物标准器的校准</translation>
    </message>
    <message>
        <source>temperature of the artefact</source>
        <translation>实物标准器的温度</translation>
    </message>
    <message>
        <source>systematic error of indication</source>
        <translation>示值的系统误差</translation>
    </message>
    <message>
        <source>coordinate %1</source>
        <translation>坐标 %1</translation>
    </message>
    <message>
        <source>The bias b is not corrected; |b| counts as a standard uncertainty (against JCGM 100 3.2.4).</source>
        <translation>偏移 b 未修正；|b| 计为标准不确定度（与 JCGM 100 3.2.4 不符）。</translation>
    </message>
    <message>
        <source>The bias b is not part of u_c.</source>
        <translation>偏移 b 不是 u_c 的一部分。</translation>
    </message>
    <message>
        <source>Measured values are taken as corrected by -b; u_var/sqrt(n) of the correction is part of u_c.</source>
        <translation>测得值视为已按 -b 修正；修正的 u_var/sqrt(n) 是 u_c 的一部分。</translation>
    </message>
    <message>
        <source>A coordinate of a point has u_c divided by √2.</source>
        <translation>点的一个坐标的 u_c 已除以 √2。</translation>
    </message>
    <message>
        <source>measured coordinate</source>
        <translation>实测坐标</translation>
    </message>
    <message>
        <source>typed standard uncertainty</source>
        <translation>输入的标准不确定度</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>specification: %1</source>
        <translation>技术指标：%1</translation>
    </message>
    <message>
        <source>The figure is taken as: %1.</source>
        <translation>该数值理解为：%1。</translation>
    </message>
    <message>
        <source>%1, of a length: divided by √2</source>
        <translation>%1，属于长度：除以 √2</translation>
    </message>
    <message>
        <source>station, combination %1</source>
        <translation>测站，组合 %1</translation>
    </message>
    <message>
        <source>instrument: standard uncertainties and correlation of the station</source>
        <translation>仪器：测站的标准不确定度与相关性</translation>
    </message>
    <message>
        <source>scale of distances</source>
        <translation>距离的比例误差</translation>
    </message>
    <message>
        <source>zero offset of distances</source>
        <translation>距离的零点偏移</translation>
    </message>
    <message>
        <source>index of the elevation</source>
        <translation>竖盘指标差</translation>
    </message>
    <message>
        <source>collimation</source>
        <translation>视准差</translation>
    </message>
    <message>
        <source>squareness of the axes</source>
        <translation>轴系垂直度</translation>
    </message>
    <message>
        <source>offset of the beam</source>
        <translation>光束偏移</translation>
    </message>
    <message>
        <source>coefficient of refraction</source>
        <translation>折光系数</translation>
    </message>
    <message>
        <source>instrument: standard uncertainty</source>
        <translation>仪器：标准不确定度</translation>
    </message>
    <message>
        <source>instrument: %1</source>
        <translation>仪器：%1</translation>
    </message>
    <message>
        <source>For a target at the height of the instrument.</source>
        <translation>针对与仪器同高的目标点。</translation>
    </message>
    <message>
        <source>station, %1</source>
        <translation>测站，%1</translation>
    </message>
    <message>
        <source>%1, %2, set-up %3</source>
        <translation>%1，%2，第 %3 次设站</translation>
    </message>
    <message>
        <source>displacement across the azimuth</source>
        <translation>垂直于方位方向的位移</translation>
    </message>
    <message>
        <source>%1 to %2, %3</source>
        <translation>%1 至 %2，%3</translation>
    </message>
    <message>
        <source>calibrated length</source>
        <translation>已校准长度</translation>
    </message>
    <message>
        <source>calibration of the %1</source>
        <translation>校准：%1</translation>
    </message>
    <message>
        <source>%1, calibrated length</source>
        <translation>%1，已校准长度</translation>
    </message>
    <message>
        <source>distance from %1 to %2</source>
        <translation>%1 到 %2 的距离</translation>
    </message>
    <message>
        <source>angle at %1 from %2 to %3</source>
        <translation>%1 处从 %2 到 %3 的角度</translation>
    </message>
    <message>
        <source>%1, measured minus calibrated length</source>
        <translation>%1，实测长度减已校准长度</translation>
    </message>
    <message>
        <source>origin of %1, coordinate %2</source>
        <translation>%1 的原点，坐标 %2</translation>
    </message>
    <message>
        <source>rotation of %1 about %2</source>
        <translation>%1 绕 %2 的旋转</translation>
    </message>
    <message>
        <source>The precision of the readings is no uncertainty of a position: it leaves out where the sensors stand and what their readings share. Monte Carlo is in the results.</source>
        <translation>读数的精密度不是位置的不确定度：它没有计入传感器所在位置和各读数的共有部分。蒙特卡洛结果见结果部分。</translation>
    </message>
    <message>
        <source>No redundancy: as many readings as unknowns, so nothing can be checked.</source>
        <translation>无冗余：读数与未知数一样多，因此无法检验。</translation>
    </message>
    <message>
        <source>The residuals are larger than the uncertainties allow.</source>
        <translation>残差大于不确定度所允许的范围。</translation>
    </message>
    <message>
        <source>The residuals are smaller than the uncertainties lead to expect.</source>
        <translation>残差小于按不确定度所预期的大小。</translation>
    </message>
    <message>
        <source>The residuals agree with the uncertainties.</source>
        <translation>残差与不确定度一致。</translation>
    </message>
    <message>
        <source>%1 readings have |w| &gt; 3.29 (0.1 %); where several do, look at the largest first.</source>
        <translation>%1 个读数的 |w| &gt; 3.29 (0.1 %)；若有多个，先查看最大的。</translation>
    </message>
    <message>
        <source>%1 in %2, coordinate %3</source>
        <translation>%2 中的 %1，坐标 %3</translation>
    </message>
    <message>
        <source>position of the platform, %1</source>
        <translation>平台位置，%1</translation>
    </message>
    <message>
        <source>Chi-square of the residuals with the full covariance of the stated uncertainties; nominal coordinates are taken as exact. p is the probability of a larger value if all is as stated; the test has a level of 1 % for all sets together. Not tested: sets without stated uncertainty, and sets of more than %1 points.</source>
        <translation>用给出的不确定度的全协方差计算的残差卡方；标称坐标视为精确。p 是一切如所述时出现更大值的概率；检验对所有点组合计的显著性水平为 1 %。未检验：没有给出不确定度的点组，以及多于 %1 个点的点组。</translation>
    </message>
    <message>
        <source>Measured less nominal coordinates. w is a residual over its own standard uncertainty; |w| &gt; 3.29 (0.1 %) is remarked. Redundancy is the share of an error of the coordinate that stays in its residual.</source>
        <translation>实测坐标减标称坐标。w 是残差与其自身标准不确定度之比；|w| &gt; 3.29 (0.1 %) 会被标注。冗余度是坐标误差中留在其残差里的部分。</translation>
    </message>
    <message>
        <source>reading of bar %1</source>
        <translation>球杆仪 %1 的读数</translation>
    </message>
    <message>
        <source>ballbars: %1</source>
        <translation>球杆仪：%1</translation>
    </message>
    <message>
        <source>length between supports %1</source>
        <translation>支座 %1 之间的长度</translation>
    </message>
    <message>
        <source>height of support %1</source>
        <translation>支座 %1 的高度</translation>
    </message>
    <message>
        <source>ballbars: standard uncertainty</source>
        <translation>球杆仪：标准不确定度</translation>
    </message>
    <message>
        <source>scale of all lengths</source>
        <translation>所有长度的比例误差</translation>
    </message>
    <message>
        <source>constant of bar %1</source>
        <translation>球杆仪 %1 的常数</translation>
    </message>
    <message>
        <source>%1, point %2</source>
        <translation>%1，点 %2</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>点 %1</translation>
    </message>
    <message>
        <source>axis %1 of the flange, angle towards %2</source>
        <translation>法兰的 %1 轴，朝 %2 的角度</translation>
    </message>
    <message>
        <source>repeatability along %1</source>
        <translation>沿 %1 的重复性</translation>
    </message>
    <message>
        <source>repeatability: %1</source>
        <translation>重复性：%1</translation>
    </message>
    <message>
        <source>The coordinates are uncorrelated; unless they are normal, they are not independent: the distance has the law above, its direction is random.</source>
        <translation>各坐标不相关；除非为正态分布，否则并不独立：距离服从上述分布，其方向是随机的。</translation>
    </message>
    <message>
        <source>repeatability about %1</source>
        <translation>绕 %1 的重复性</translation>
    </message>
    <message>
        <source>repeatability of the orientation</source>
        <translation>姿态的重复性</translation>
    </message>
    <message>
        <source>%1 of joint %2</source>
        <translation>关节 %2 的%1</translation>
    </message>
    <message>
        <source>encoder</source>
        <translation>编码器</translation>
    </message>
    <message>
        <source>tool, rotation about %1</source>
        <translation>工具，绕 %1 的旋转</translation>
    </message>
    <message>
        <source>tool: standard uncertainty</source>
        <translation>工具：标准不确定度</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1, combined</source>
        <translation>%1，合成</translation>
    </message>
    <message>
        <source>%1, deviation</source>
        <translation>%1，偏差</translation>
    </message>
    <message>
        <source>reading of joint %1, %2</source>
        <translation>关节 %1 的读数，%2</translation>
    </message>
    <message>
        <source>position of the tool, %1</source>
        <translation>工具位置，%1</translation>
    </message>
    <message>
        <source>orientation of the tool, %1</source>
        <translation>工具姿态，%1</translation>
    </message>
    <message>
        <source>joint angle</source>
        <translation>关节角</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>偏距</translation>
    </message>
    <message>
        <source>link length</source>
        <translation>连杆长度</translation>
    </message>
    <message>
        <source>twist</source>
        <translation>扭角</translation>
    </message>
    <message>
        <source>second twist</source>
        <translation>第二扭角</translation>
    </message>
    <message>
        <source>Components of a parameter combine in quadrature (Wen et al., Eq. 10). U has the factor 2 of the paper; with few effective degrees of freedom 95 % need more.</source>
        <translation>一个参数的各分量按方和根合成（Wen et al.，式 10）。U 采用论文的因子 2；有效自由度较少时，95 % 需要更大的因子。</translation>
    </message>
    <message>
        <source>Places of the tool in the base frame of the robot.</source>
        <translation>工具在机器人基坐标系中的位置。</translation>
    </message>
    <message>
        <source>calculated less measured %1, held back</source>
        <translation>计算值减测得值 %1，留作检验</translation>
    </message>
    <message>
        <source>orientation of the base, %1</source>
        <translation>基座姿态，%1</translation>
    </message>
    <message>
        <source>position of the base, %1</source>
        <translation>基座位置，%1</translation>
    </message>
    <message>
        <source>pose %1, rotation about %2</source>
        <translation>位姿 %1，绕 %2 的旋转</translation>
    </message>
    <message>
        <source>pose %1, %2</source>
        <translation>位姿 %1，%2</translation>
    </message>
    <message>
        <source>measured orientation</source>
        <translation>实测姿态</translation>
    </message>
    <message>
        <source>pose %1, reading of joint %2</source>
        <translation>位姿 %1，关节 %2 的读数</translation>
    </message>
    <message>
        <source>Singular values are those of the weighted Jacobian with columns of length one.</source>
        <translation>奇异值取自各列长度为一的加权雅可比矩阵。</translation>
    </message>
    <message>
        <source>Least well told apart: %1.</source>
        <translation>最难区分的：%1。</translation>
    </message>
    <message>
        <source>A residual beyond %1 times its own standard uncertainty is an outlier: 5 % for all residuals together (Bonferroni).</source>
        <translation>残差超过其自身标准不确定度的 %1 倍即为离群值：对所有残差合计为 5 %（Bonferroni）。</translation>
    </message>
    <message>
        <source>Nominal: the same base and ball fitted with the nominal parameters. E_n = |d|/U: below 1 the pose agrees with the calibration.</source>
        <translation>标称：用标称参数拟合的同一基座和球。E_n = |d|/U：小于 1 时该位姿与校准一致。</translation>
    </message>
    <message>
        <source>radius of the circle of joint %1</source>
        <translation>关节 %1 的圆半径</translation>
    </message>
    <message>
        <source>%1, point %2, %3</source>
        <translation>%1，点 %2，%3</translation>
    </message>
    <message>
        <source>Simulated points of the nominal robot: they lie on their circles.</source>
        <translation>标称机器人的模拟点：它们位于各自的圆上。</translation>
    </message>
    <message>
        <source>load %1, compensated</source>
        <translation>载荷 %1，已补偿</translation>
    </message>
    <message>
        <source>load %1 by its own channel alone</source>
        <translation>载荷 %1，仅由其自身通道得出</translation>
    </message>
    <message>
        <source>calibration machine, %1</source>
        <translation>校准机，%1</translation>
    </message>
    <message>
        <source>calibration machine, Eq 5</source>
        <translation>校准机，式 5</translation>
    </message>
    <message>
        <source>regression of %1</source>
        <translation>%1 的回归</translation>
    </message>
    <message>
        <source>reading of %1 by load %2</source>
        <translation>载荷 %2 引起的 %1 读数</translation>
    </message>
    <message>
        <source>quadratic term of %1 by load %2</source>
        <translation>载荷 %2 引起的 %1 二次项</translation>
    </message>
    <message>
        <source>%1 of %2, %3</source>
        <translation>%2 的%1，%3</translation>
    </message>
    <message>
        <source>standard deviation of one reading, Eq 3</source>
        <translation>单个读数的标准偏差，式 3</translation>
    </message>
    <message>
        <source>net reading of %1, %2</source>
        <translation>%1 的净读数，%2</translation>
    </message>
    <message>
        <source>Eq 6</source>
        <translation>式 6</translation>
    </message>
    <message>
        <source>Eq 7</source>
        <translation>式 7</translation>
    </message>
    <message>
        <source>Eq 10, full width of the loop</source>
        <translation>式 10，回线的全宽</translation>
    </message>
    <message>
        <source>Eq 10, in proportion to the load</source>
        <translation>式 10，与载荷成比例</translation>
    </message>
    <message>
        <source>Condition number, by rated outputs and rated loads: %1; with quadratic terms beside these slopes.</source>
        <translation>条件数（按额定输出和额定载荷）：%1；除这些斜率外还有二次项。</translation>
    </message>
    <message>
        <source>Condition number, by rated outputs and rated loads: %1.</source>
        <translation>条件数（按额定输出和额定载荷）：%1。</translation>
    </message>
    <message>
        <source>Uncompensated: by the slope of the channel&apos;s own axis. The uncertainties of both are among the results.</source>
        <translation>未补偿：按通道自身轴的斜率。两者的不确定度见结果。</translation>
    </message>
    <message>
        <source>Reproduces: equal in all printed digits. Inside rounding: what it is computed from was rounded, too. Interference, percent: the row&apos;s sensor, then the column&apos;s axis.</source>
        <translation>重现：所有印出的数字均相同。在修约之内：计算所依据的数据也经过修约。干扰，百分比：先是行的传感器，再是列的轴。</translation>
    </message>
    <message>
        <source>Fig. 2: %1 s without load before a series, %2 s at each load.</source>
        <translation>图 2：每个系列之前空载 %1 s，每级载荷保持 %2 s。</translation>
    </message>
    <message>
        <source>A row is a load, a column the sensor that answers to it.</source>
        <translation>一行是一个载荷，一列是对它有响应的传感器。</translation>
    </message>
    <message>
        <source>A row is a sensor, a column the load under which it gives this output.</source>
        <translation>一行是一个传感器，一列是使它给出该输出的载荷。</translation>
    </message>
    <message>
        <source>Magnitudes: the signs are not known.</source>
        <translation>绝对值：符号未知。</translation>
    </message>
    <message>
        <source>U = hysteresis + interference + k u_c with k = %1: a linear sum of two largest values and an expanded uncertainty. Type A: n = %2 runs, %3 degrees of freedom.</source>
        <translation>U = 滞后 + 干扰 + k u_c，k = %1：两个最大值与一个扩展不确定度的线性和。A 类：n = %2 个测次，自由度 %3。</translation>
    </message>
    <message>
        <source>Calibration machine: %1.</source>
        <translation>校准机：%1。</translation>
    </message>
    <message>
        <source>Table 3 takes the Type B standard uncertainties that are stated, not these.</source>
        <translation>表 3 采用所给出的 B 类标准不确定度，而不是这些。</translation>
    </message>
    <message>
        <source>load %1 that channel %1 tells</source>
        <translation>通道 %1 所指示的载荷 %1</translation>
    </message>
    <message>
        <source>net reading of channel %1</source>
        <translation>通道 %1 的净读数</translation>
    </message>
    <message>
        <source>load by the rated load of channel %1</source>
        <translation>载荷与通道 %1 额定载荷之比</translation>
    </message>
    <message>
        <source>Eqs 3, 4</source>
        <translation>式 3、4</translation>
    </message>
    <message>
        <source>net reading of %1 at rated load</source>
        <translation>额定载荷下 %1 的净读数</translation>
    </message>
    <message>
        <source>calibration machine</source>
        <translation>校准机</translation>
    </message>
    <message>
        <source>Eq 5</source>
        <translation>式 5</translation>
    </message>
    <message>
        <source>Eq 10, as a rectangular distribution over the loop</source>
        <translation>式 10，按回线上的矩形分布</translation>
    </message>
    <message>
        <source>unknown load on %1</source>
        <translation>%1 上的未知载荷</translation>
    </message>
    <message>
        <source>set-up: unknown between minus and plus the rated load</source>
        <translation>测量设置：在负、正额定载荷之间未知</translation>
    </message>
    <message>
        <source>load on %1 by its rated load</source>
        <translation>%1 上的载荷与其额定载荷之比</translation>
    </message>
    <message>
        <source>The paper adds the largest hysteresis and the largest interference to k times u_c. It counts one other load only: with several loads their interference adds up, and exceeds the paper&apos;s U for %1 of %2 sensors when all act fully.</source>
        <translation>论文把最大滞后和最大干扰加到 k 乘 u_c 上。它只计入一个其他载荷：有多个载荷时干扰会叠加，当全部满载作用时，%2 个传感器中有 %1 个超过论文的 U。</translation>
    </message>
    <message>
        <source>So the linear sum is no bound under combined load, and for one component alone it is far too large. As hysteresis and interference are limits and no standard uncertainties, it is no coverage interval either.</source>
        <translation>因此在组合载荷下线性和不是界限，而对单独一个分量又大得多。由于滞后和干扰是界限而不是标准不确定度，它也不是包含区间。</translation>
    </message>
    <message>
        <source>GUM: hysteresis, non-zero error and resolution are rectangular, each unknown load is rectangular between minus and plus its rated load, root sum of squares. One component alone: k from the t-distribution with the effective degrees of freedom.</source>
        <translation>GUM：滞后、回零误差和分辨力为矩形分布，每个未知载荷在负、正额定载荷之间为矩形分布，取平方和的根。单独一个分量：k 取自具有有效自由度的 t 分布。</translation>
    </message>
    <message>
        <source>Repeatability: the largest of the steps; its degrees of freedom are those of one step. Pooled over the steps it has more of them.</source>
        <translation>重复性：各级中最大的一个；其自由度为一级的自由度。各级合并后自由度更多。</translation>
    </message>
    <message>
        <source>pooled standard deviation</source>
        <translation>合并标准偏差</translation>
    </message>
    <message>
        <source>mean of %1 observations</source>
        <translation>%1 次观测的平均值</translation>
    </message>
    <message>
        <source>s is the experimental standard deviation, u = s/√n (JCGM 100 4.2). A quantity that is stated as pooled observations has the u of all its series together (JCGM 100 4.2.4).</source>
        <translation>s 为实验标准偏差，u = s/√n（JCGM 100 4.2）。以合并观测给出的量采用其所有系列合并的 u（JCGM 100 4.2.4）。</translation>
    </message>
    <message>
        <source>scatter of the means of the groups</source>
        <translation>各组平均值的分散性</translation>
    </message>
    <message>
        <source>components of variance between and within the groups</source>
        <translation>组间与组内的方差分量</translation>
    </message>
    <message>
        <source>%1 groups, %2 observations</source>
        <translation>%1 组，%2 次观测</translation>
    </message>
    <message>
        <source>mean of all observations</source>
        <translation>全部观测的平均值</translation>
    </message>
    <message>
        <source>There is an effect of the groups at the level of 5 %.</source>
        <translation>在 5 % 水平上存在组的效应。</translation>
    </message>
    <message>
        <source>No effect of the groups is seen at the level of 5 %.</source>
        <translation>在 5 % 水平上看不出组的效应。</translation>
    </message>
    <message>
        <source>The component of variance between the groups is zero: all observations count as independent.</source>
        <translation>组间方差分量为零：全部观测视为独立。</translation>
    </message>
    <message>
        <source>scatter of the points about the curve</source>
        <translation>各点相对曲线的分散性</translation>
    </message>
    <message>
        <source>least squares, residuals of %1 points</source>
        <translation>最小二乘，%1 个点的残差</translation>
    </message>
    <message>
        <source>value of the curve at the origin</source>
        <translation>曲线在原点的值</translation>
    </message>
    <message>
        <source>coefficient of the power %1</source>
        <translation>%1 次项系数</translation>
    </message>
    <message>
        <source>mean of y</source>
        <translation>y 的平均值</translation>
    </message>
    <message>
        <source>term of degree %1 (orthonormal polynomial)</source>
        <translation>%1 次项（标准正交多项式）</translation>
    </message>
    <message>
        <source>%1 of point %2</source>
        <translation>点 %2 的 %1</translation>
    </message>
    <message>
        <source>stated uncertainty of %1</source>
        <translation>给出的 %1 的不确定度</translation>
    </message>
    <message>
        <source>table of points</source>
        <translation>点表</translation>
    </message>
    <message>
        <source>observed y</source>
        <translation>观测的 y</translation>
    </message>
    <message>
        <source>%1, observed y</source>
        <translation>%1，观测的 y</translation>
    </message>
    <message>
        <source>table of the inverse use</source>
        <translation>反向使用表</translation>
    </message>
    <message>
        <source>value of the curve at %1</source>
        <translation>曲线在 %1 处的值</translation>
    </message>
    <message>
        <source>x where the curve is %1</source>
        <translation>曲线为 %1 时的 x</translation>
    </message>
    <message>
        <source>The residuals agree with the stated uncertainties.</source>
        <translation>残差与给出的不确定度一致。</translation>
    </message>
    <message>
        <source>The residuals are larger than the stated uncertainties explain: the curve or the uncertainties do not describe these points.</source>
        <translation>残差大于给出的不确定度所能解释的范围：曲线或不确定度不能描述这些点。</translation>
    </message>
    <message>
        <source>The x of y = %1 lies outside of the points of the calibration.</source>
        <translation>y = %1 对应的 x 在校准点之外。</translation>
    </message>
    <message>
        <source>the parameters come from an analysis, which is evaluated in every trial: their correlation cannot be ignored</source>
        <translation>参数来自在每次试验中评定的分析：其相关性不能忽略</translation>
    </message>
    <message>
        <source>Rz(θ) Tz(d) Tx(a) Rx(α) Ry(β), β for parallel joints</source>
        <translation>Rz(θ) Tz(d) Tx(a) Rx(α) Ry(β)，β 用于平行关节</translation>
    </message>
    <message>
        <source>Rz(θ) Tz(d) Tx(a) Rx(α), Denavit-Hartenberg</source>
        <translation>Rz(θ) Tz(d) Tx(a) Rx(α)，Denavit-Hartenberg</translation>
    </message>
    <message>
        <source>Rx(α) Tx(a) Rz(θ) Tz(d), Craig: α and a before joint i</source>
        <translation>Rx(α) Tx(a) Rz(θ) Tz(d)，Craig：α 和 a 在关节 i 之前</translation>
    </message>
    <message>
        <source>Date of receipt</source>
        <translation>接收日期</translation>
    </message>
    <message>
        <source>Date of calibration</source>
        <translation>校准日期</translation>
    </message>
    <message>
        <source>Date of issue</source>
        <translation>签发日期</translation>
    </message>
    <message>
        <source>To first order no input quantity influences %1 at these estimates: its uncertainty is of second order, as Monte Carlo shows</source>
        <translation>在这些估计值处，一阶上没有输入量影响 %1：其不确定度为二阶，如蒙特卡洛所示</translation>
    </message>
    <message>
        <source>Calibration certificate</source>
        <translation>校准证书</translation>
    </message>
    <message>
        <source>not normal; k u fits as far as so few trials can tell</source>
        <translation>非正态；就如此少的试验而言 k u 适用</translation>
    </message>
    <message>
        <source>measured artefact, Porath et al., Eq. 2</source>
        <translation>实测的实物标准器，Porath et al.，式 2</translation>
    </message>
    <message>
        <source>not controlled</source>
        <translation>不受控</translation>
    </message>
    <message>
        <source>outlier?</source>
        <translation>离群值？</translation>
    </message>
    <message>
        <source>not tested</source>
        <translation>未检验</translation>
    </message>
    <message>
        <source>residuals larger than stated</source>
        <translation>残差大于所给不确定度</translation>
    </message>
    <message>
        <source>agrees</source>
        <translation>一致</translation>
    </message>
    <message>
        <source>distance: largest</source>
        <translation>距离：最大</translation>
    </message>
    <message>
        <source>distance: RP = mean + 3 s</source>
        <translation>距离：RP = 平均值 + 3 s</translation>
    </message>
    <message>
        <source>does not move the measured points in any pose</source>
        <translation>在任何位姿下都不移动实测点</translation>
    </message>
    <message>
        <source>moves the measured points as %1 can: coupled with it, held at its nominal value</source>
        <translation>移动实测点的方式与 %1 相同：与之耦合，保持标称值</translation>
    </message>
    <message>
        <source>coordinates in the fit</source>
        <translation>参与拟合的坐标</translation>
    </message>
    <message>
        <source>unknowns (rank)</source>
        <translation>未知数（秩）</translation>
    </message>
    <message>
        <source>condition of the fit</source>
        <translation>拟合的条件数</translation>
    </message>
    <message>
        <source>smallest singular value</source>
        <translation>最小奇异值</translation>
    </message>
    <message>
        <source>residuals over what uncertainties explain</source>
        <translation>残差与不确定度所能解释部分之比</translation>
    </message>
    <message>
        <source>outlier</source>
        <translation>离群值</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>one ball is one point: it has no orientation</source>
        <translation>一个球就是一个点：没有姿态</translation>
    </message>
    <message>
        <source>places the base frame on axis 1: by definition, as nominal; it would need a measured base</source>
        <translation>将基坐标系放在轴 1 上：按定义取标称值；需要对基座进行测量</translation>
    </message>
    <message>
        <source>places the frame of the last link, which no axis follows: by definition, as nominal</source>
        <translation>确定最后一个连杆的坐标系，其后没有轴：按定义取标称值</translation>
    </message>
    <message>
        <source>the axis is parallel to the next: 0 by definition, or beta and d would describe the same</source>
        <translation>该轴与下一轴平行：按定义为 0，否则 beta 与 d 描述同一内容</translation>
    </message>
    <message>
        <source>reproduces</source>
        <translation>重现</translation>
    </message>
    <message>
        <source>inside rounding</source>
        <translation>在修约之内</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>不同</translation>
    </message>
    <message>
        <source>planned</source>
        <translation>计划</translation>
    </message>
    <message>
        <source>total</source>
        <translation>总计</translation>
    </message>
    <message>
        <source>standard deviation of the means of the groups</source>
        <translation>各组平均值的标准偏差</translation>
    </message>
    <message>
        <source>s_a, from the means of the groups</source>
        <translation>s_a，由各组平均值得到</translation>
    </message>
    <message>
        <source>s_b, within the groups</source>
        <translation>s_b，组内</translation>
    </message>
    <message>
        <source>s_B, between the groups</source>
        <translation>s_B，组间</translation>
    </message>
    <message>
        <source>n_0, size of the groups</source>
        <translation>n_0，组的大小</translation>
    </message>
    <message>
        <source>F = s_a²/s_b²</source>
        <translation>F = s_a²/s_b²</translation>
    </message>
    <message>
        <source>95 % quantile of F</source>
        <translation>F 的 95 % 分位数</translation>
    </message>
    <message>
        <source>97.5 % quantile of F</source>
        <translation>F 的 97.5 % 分位数</translation>
    </message>
    <message>
        <source>between the groups</source>
        <translation>组间</translation>
    </message>
    <message>
        <source>within the groups</source>
        <translation>组内</translation>
    </message>
    <message>
        <source>chi-squared</source>
        <translation>卡方</translation>
    </message>
    <message>
        <source>its 95 % quantile</source>
        <translation>其 95 % 分位数</translation>
    </message>
    <message>
        <source>standard deviation of the residuals</source>
        <translation>残差的标准偏差</translation>
    </message>
    <message>
        <source>coefficient of determination R²</source>
        <translation>决定系数 R²</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>residuals</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>position %1, rotations about x, y, z: %2</source>
        <translation>位置 %1，绕 x、y、z 的旋转：%2</translation>
    </message>
    <message>
        <source>1 further component</source>
        <translation>另外 1 个分量</translation>
    </message>
    <message>
        <source>Shown for %1, the first of the %2 groups; the CSV table of budgets has every group.</source>
        <translation>显示 %2 组中的第一组 %1；预算的 CSV 表包含每一组。</translation>
    </message>
    <message>
        <source>Shown for %1: of the %2 groups it has the largest expanded uncertainties on average; the CSV table of budgets has every group.</source>
        <translation>显示 %1：在 %2 组中其扩展不确定度平均而言最大；预算的 CSV 表包含每一组。</translation>
    </message>
    <message>
        <source>Shown for %1: of the %2 groups with the same quantities it has the largest expanded uncertainties on average; the CSV table of budgets has all %3 groups.</source>
        <translation>显示 %1：在具有相同量的 %2 组中其扩展不确定度平均而言最大；预算的 CSV 表包含全部 %3 组。</translation>
    </message>
    <message>
        <source>The law of propagation is validated by JCGM 101 clause 8 where both ends of its coverage interval, y ± U, lie within the numerical tolerance δ of those of the propagation of distributions. Validated: %1 of %2.</source>
        <translation>按 JCGM 101 第 8 章，当传播律的包含区间 y ± U 的两端与分布传播的两端之差在数值容差 δ 内时，传播律得到验证。已验证：%2 个中的 %1 个。</translation>
    </message>
    <message>
        <source>Shape of the distributions by Monte Carlo</source>
        <translation>蒙特卡洛所得分布的形状</translation>
    </message>
    <message>
        <source>From &apos;%1&apos; on, %2 of %3 rows; the annex has all of them.</source>
        <translation>自“%1”起，%3 行中的 %2 行；全部见附录。</translation>
    </message>
    <message>
        <source>From &apos;%1&apos; on, %2 of %3 rows; the CSV tables, and the annex on request, have all of them.</source>
        <translation>自“%1”起，%3 行中的 %2 行；全部见 CSV 表以及按需的附录。</translation>
    </message>
    <message>
        <source>The annex has the charts.</source>
        <translation>图见附录。</translation>
    </message>
    <message>
        <source>The CSV tables, and the annex on request, have what the charts show.</source>
        <translation>图中的内容见 CSV 表以及按需的附录。</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables and no chart; the annex has the rest.</source>
        <translation>显示 %2 个表中的 %1 个，不显示图；其余见附录。</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables and no chart; the CSV tables, and the annex on request, have the rest.</source>
        <translation>显示 %2 个表中的 %1 个，不显示图；其余见 CSV 表以及按需的附录。</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知数</translation>
    </message>
    <message>
        <source>coupled with</source>
        <translation>与之耦合</translation>
    </message>
    <message>
        <source>Observations of %1</source>
        <translation>%1 的观测值</translation>
    </message>
    <message>
        <source>mean + s</source>
        <translation>平均值 + s</translation>
    </message>
    <message>
        <source>mean − s</source>
        <translation>平均值 − s</translation>
    </message>
    <message>
        <source>What is reported, and in which unit. Without rows: every name that an equation defines and no other one uses, in the unit of the first quantity of the same dimension, else in SI units.</source>
        <translation>报告什么以及用什么单位。没有行时：由方程定义且未被其他方程使用的每个名称，采用第一个同量纲的量的单位，否则采用 SI 单位。</translation>
    </message>
    <message>
        <source>arcsine</source>
        <translation>反正弦</translation>
    </message>
    <message>
        <source>curvilinear</source>
        <translation>曲线梯形</translation>
    </message>
    <message>
        <source>inexactness</source>
        <translation>不精确度</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>界限</translation>
    </message>
    <message>
        <source>pooled</source>
        <translation>合并</translation>
    </message>
    <message>
        <source>From the set-up as it is stated. Values and uncertainties that other analyses give (%1 quantities) are in the results, not here.</source>
        <translation>依据给出的测量设置。由其他分析给出的值和不确定度（%1 个量）体现在结果中，不在此处。</translation>
    </message>
    <message>
        <source>Limit of the coverage interval: of Monte Carlo, else of the law of propagation</source>
        <translation>包含区间的界限：由蒙特卡洛法得出，否则由传播律得出</translation>
    </message>
    <message>
        <source>Input quantities that the component is part of</source>
        <translation>该分量所属的输入量</translation>
    </message>
    <message>
        <source>Quantity or component of uncertainty, as at the bars of the chart</source>
        <translation>量或不确定度分量，与图中各条的名称相同</translation>
    </message>
    <message>
        <source>density</source>
        <translation>密度</translation>
    </message>
    <message>
        <source>quantile</source>
        <translation>分位数</translation>
    </message>
    <message>
        <source>calibrated lengths</source>
        <translation>已校准长度</translation>
    </message>
    <message>
        <source>distances</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>angles</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>scale bar</source>
        <translation>基准尺</translation>
    </message>
    <message>
        <source>base</source>
        <translation>基座</translation>
    </message>
    <message>
        <source>supports</source>
        <translation>支座</translation>
    </message>
    <message>
        <source>axes of the flange</source>
        <translation>法兰的轴</translation>
    </message>
    <message>
        <source>circles</source>
        <translation>圆</translation>
    </message>
    <message>
        <source>calibration matrix</source>
        <translation>校准矩阵</translation>
    </message>
    <message>
        <source>loads on other axes</source>
        <translation>其他轴上的载荷</translation>
    </message>
    <message>
        <source>scatter of all observations</source>
        <translation>全部观测值的分散性</translation>
    </message>
    <message>
        <source>points, x</source>
        <translation>点，x</translation>
    </message>
    <message>
        <source>points, y</source>
        <translation>点，y</translation>
    </message>
    <message>
        <source>inverse use</source>
        <translation>反向使用</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1，%2：%3</translation>
    </message>
    <message>
        <source>%1, all rows: %2</source>
        <translation>%1，所有行：%2</translation>
    </message>
    <message>
        <source>%1: uncertainty</source>
        <translation>%1：不确定度</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>第 %1 行</translation>
    </message>
    <message>
        <source>%1: estimate</source>
        <translation>%1：估计值</translation>
    </message>
    <message>
        <source>%1, factor</source>
        <translation>%1，因子</translation>
    </message>
    <message>
        <source>%1, added</source>
        <translation>%1，增加量</translation>
    </message>
    <message>
        <source>base b</source>
        <translation>基座 b</translation>
    </message>
    <message>
        <source>platform p</source>
        <translation>平台 p</translation>
    </message>
    <message>
        <source>support %1</source>
        <translation>支座 %1</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>轴 %1</translation>
    </message>
    <message>
        <source>check %1</source>
        <translation>检核 %1</translation>
    </message>
    <message>
        <source>axis of %1</source>
        <translation>%1 的轴</translation>
    </message>
    <message>
        <source>scale bar %1</source>
        <translation>基准尺 %1</translation>
    </message>
    <message>
        <source>%1 (u of first order: %2 of that by Monte Carlo)</source>
        <translation>%1（一阶 u 为蒙特卡洛法的 %2）</translation>
    </message>
    <message>
        <source>S / %</source>
        <translation>S / %</translation>
    </message>
    <message>
        <source>Share of the variance that the component causes by itself (Sobol index)</source>
        <translation>该分量单独引起的方差占比（Sobol 指数）</translation>
    </message>
    <message>
        <source>S total / %</source>
        <translation>总 S / %</translation>
    </message>
    <message>
        <source>Share of the variance with all interactions of the component with others</source>
        <translation>含该分量与其他分量全部交互作用的方差占比</translation>
    </message>
    <message>
        <source>ν (first order)</source>
        <translation>ν（一阶）</translation>
    </message>
    <message>
        <source>%1 out of %2</source>
        <translation>%2 个中的 %1 个</translation>
    </message>
    <message>
        <source>%1 interval, low</source>
        <translation>%1 区间，下限</translation>
    </message>
    <message>
        <source>%1 interval, high</source>
        <translation>%1 区间，上限</translation>
    </message>
    <message>
        <source>Interval, low</source>
        <translation>区间，下限</translation>
    </message>
    <message>
        <source>Interval, high</source>
        <translation>区间，上限</translation>
    </message>
    <message>
        <source>ballbars</source>
        <translation>球杆仪</translation>
    </message>
    <message>
        <source>flange</source>
        <translation>法兰</translation>
    </message>
    <message>
        <source>A mean of n observations is drawn from a t distribution with n − 1 degrees of freedom (JCGM 101 6.4.9). Means of simultaneous observations are drawn from one multivariate t distribution with these n − 1 degrees of freedom; with the n − N of JCGM 102 5.3.2 no mean would keep its own distribution.</source>
        <translation>n 次观测的平均值从自由度为 n − 1 的 t 分布抽样（JCGM 101 6.4.9）。同时观测所得的各平均值从同一个自由度为 n − 1 的多元 t 分布抽样；若取 JCGM 102 5.3.2 的 n − N，各平均值便不再保持自身的分布。</translation>
    </message>
    <message>
        <source>if it vanished, U would exceed the target again, with fewer degrees of freedom</source>
        <translation>若其为零，U 会再次超过目标，因为自由度变少</translation>
    </message>
    <message>
        <source>Unit of the value, and of a and b where they have no other; empty: 1. A difference of temperatures is given in K.</source>
        <translation>值的单位，以及 a 和 b 没有其他单位时的单位；留空为 1。温度差以 K 给出。</translation>
    </message>
    <message>
        <source>First figure of the statement.</source>
        <translation>声明的第一个数值。</translation>
    </message>
    <message>
        <source>unit of a, b</source>
        <translation>a、b 的单位</translation>
    </message>
    <message>
        <source>Unit of the statement&apos;s figures; empty: the row&apos;s. % and ppm of a quantity that has a unit are parts of its value.</source>
        <translation>声明中数值的单位；留空则为该行的单位。对有单位的量，% 和 ppm 表示其值的一部分。</translation>
    </message>
    <message>
        <source>Budget of %1</source>
        <translation>%1 的预算</translation>
    </message>
    <message>
        <source>Two correlated components have half of their covariance each, in the effective degrees of freedom too.</source>
        <translation>两个相关的分量各占其协方差的一半，计算有效自由度时也是如此。</translation>
    </message>
    <message>
        <source>u along any axis</source>
        <translation>沿任一轴的 u</translation>
    </message>
    <message>
        <source>results: in the base frame of the robot</source>
        <translation>结果：在机器人基坐标系中</translation>
    </message>
    <message>
        <source>%1: chosen at an end of its range; a wider one can give a better design.</source>
        <translation>%1：取在其范围的端点；更宽的范围可能给出更好的设计。</translation>
    </message>
    <message>
        <source>artefact</source>
        <translation>实物标准器</translation>
    </message>
    <message>
        <source>length standard</source>
        <translation>长度标准器</translation>
    </message>
    <message>
        <source>station</source>
        <translation>测站</translation>
    </message>
    <message>
        <source>field of view</source>
        <translation>视场</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>未定</translation>
    </message>
    <message>
        <source>Of these verdicts, %1 could be the other one with other trials.</source>
        <translation>其中 %1 个结论换用其他试验时可能相反。</translation>
    </message>
    <message>
        <source>the value typed is used, not the mean of the observations, %1</source>
        <translation>使用键入的值，而非观测值的平均值 %1</translation>
    </message>
    <message>
        <source>the correlation coefficient of %1 and %2 must lie between -1 and 1; it is %3</source>
        <translation>%1 与 %2 的相关系数必须在 -1 和 1 之间；现为 %3</translation>
    </message>
    <message>
        <source>Both are estimates by sampling, with the standard errors beside them: S can exceed S total by chance.</source>
        <translation>两者都是抽样估计值，标准误差列在旁边：S 可能偶然大于总 S。</translation>
    </message>
    <message>
        <source>Any measurement equation with what is known about its quantities: several results, intermediate definitions, conditions, and equations that are solved in every trial.</source>
        <translation>任意测量方程及其中各量的已知信息：可有多个结果、中间定义、条件，以及在每次试验中求解的方程。</translation>
    </message>
    <message>
        <source>Uncertainty of a measured point</source>
        <translation>实测点的不确定度</translation>
    </message>
    <message>
        <source>Residuals of the readings</source>
        <translation>读数的残差</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>读数</translation>
    </message>
    <message>
        <source>u of the reading</source>
        <translation>读数的 u</translation>
    </message>
    <message>
        <source>redundancy</source>
        <translation>多余度</translation>
    </message>
    <message>
        <source>remark</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Fit of the measured points to their nominal coordinates</source>
        <translation>实测点对标称坐标的拟合</translation>
    </message>
    <message>
        <source>root mean square residual</source>
        <translation>残差的均方根</translation>
    </message>
    <message>
        <source>chi-square</source>
        <translation>卡方</translation>
    </message>
    <message>
        <source>largest normalised residual</source>
        <translation>最大归一化残差</translation>
    </message>
    <message>
        <source>of</source>
        <translation>属于</translation>
    </message>
    <message>
        <source>Residuals of the points, along the axes of their frame</source>
        <translation>各点的残差，沿其坐标系各轴</translation>
    </message>
    <message>
        <source>residual x</source>
        <translation>残差 x</translation>
    </message>
    <message>
        <source>residual y</source>
        <translation>残差 y</translation>
    </message>
    <message>
        <source>residual z</source>
        <translation>残差 z</translation>
    </message>
    <message>
        <source>redundancy x</source>
        <translation>多余度 x</translation>
    </message>
    <message>
        <source>redundancy y</source>
        <translation>多余度 y</translation>
    </message>
    <message>
        <source>redundancy z</source>
        <translation>多余度 z</translation>
    </message>
    <message>
        <source>present series</source>
        <translation>当前系列</translation>
    </message>
    <message>
        <source>also reached at x</source>
        <translation>也在 x 处达到</translation>
    </message>
    <message>
        <source>a kept state</source>
        <translation>保留的状态</translation>
    </message>
    <message>
        <source>two states of the analysis %1 are kept; one can be</source>
        <translation>分析%1保留了两个状态；只能保留一个</translation>
    </message>
    <message>
        <source>&apos;digits&apos; must be a whole number from %1 to %2 (JCGM 100 7.2.6)</source>
        <translation>&apos;digits&apos; 必须是 %1 到 %2 之间的整数（JCGM 100 7.2.6）</translation>
    </message>
    <message>
        <source>the model cannot be evaluated</source>
        <translation>模型无法求值</translation>
    </message>
    <message>
        <source>there is no output quantity &apos;%1&apos; here</source>
        <translation>此处没有输出量 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>from the present values</source>
        <translation>从当前值开始</translation>
    </message>
    <message>
        <source>global search</source>
        <translation>全局搜索</translation>
    </message>
    <message>
        <source>start %1</source>
        <translation>起点 %1</translation>
    </message>
    <message>
        <source>a target uncertainty is not met</source>
        <translation>未满足某个目标不确定度</translation>
    </message>
    <message>
        <source>there is no output quantity &apos;%1&apos; then</source>
        <translation>此时没有输出量 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>an uncertainty has no finite value</source>
        <translation>某个不确定度没有有限值</translation>
    </message>
    <message>
        <source>an uncertainty vanishes: the model is degenerate there</source>
        <translation>某个不确定度为零：模型在该处退化</translation>
    </message>
    <message>
        <source>all choices</source>
        <translation>所有选择</translation>
    </message>
    <message>
        <source>greedy</source>
        <translation>逐步选取</translation>
    </message>
    <message>
        <source>backward elimination</source>
        <translation>后向剔除</translation>
    </message>
    <message>
        <source>exchange</source>
        <translation>交换</translation>
    </message>
    <message>
        <source>%1 and %2 are closer than the least distance</source>
        <translation>%1 与 %2 的距离小于最小距离</translation>
    </message>
    <message>
        <source>%1 stands in a box</source>
        <translation>%1 位于一个长方体内</translation>
    </message>
    <message>
        <source>%1 stands in the box &apos;%2&apos;</source>
        <translation>%1 位于长方体 &apos;%2&apos; 内</translation>
    </message>
    <message>
        <source>the line of sight %1 passes a box</source>
        <translation>视线 %1 穿过一个长方体</translation>
    </message>
    <message>
        <source>the line of sight %1 passes the box &apos;%2&apos;</source>
        <translation>视线 %1 穿过长方体 &apos;%2&apos;</translation>
    </message>
    <message>
        <source>%1 (row %2)</source>
        <translation>%1（第 %2 行）</translation>
    </message>
    <message>
        <source>%1: uncertainty too small to be seen</source>
        <translation>%1：不确定度过小，无法看见</translation>
    </message>
    <message>
        <source>uncertainty drawn at %1 of %2 points</source>
        <translation>在 %2 个点中的 %1 个处绘出不确定度</translation>
    </message>
    <message>
        <source>standard deviation known before (Type A)</source>
        <translation>先前已知的标准差（A 类）</translation>
    </message>
    <message>
        <source>share of the variance, first order</source>
        <translation>方差占比，一阶</translation>
    </message>
    <message>
        <source>change, relative to the variance before</source>
        <translation>相对于之前方差的变化</translation>
    </message>
    <message>
        <source>growth of the objective without it</source>
        <translation>去掉该行后目标函数的增长</translation>
    </message>
    <message>
        <source>the number of observations in the mean must be at least one</source>
        <translation>平均值的观测次数必须至少为 1</translation>
    </message>
    <message>
        <source>results: in the frame of the sensor</source>
        <translation>结果：在传感器坐标系中</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>net reading</source>
        <translation>净读数</translation>
    </message>
    <message>
        <source>deviation from the line</source>
        <translation>与直线的偏差</translation>
    </message>
    <message>
        <source>Design: twelve points of a ballbar measurement</source>
        <translation>设计：球杆仪测量的十二个点</translation>
    </message>
    <message>
        <source>Tool centre point of a robot by telescopic ballbars</source>
        <translation>用伸缩式球杆仪测量机器人的工具中心点</translation>
    </message>
    <message>
        <source>From the certificate of a scale bar to the tool of a robot</source>
        <translation>从基准尺的证书到机器人的工具</translation>
    </message>
    <message>
        <source>Industrial robot ER10L-C10</source>
        <translation>工业机器人 ER10L-C10</translation>
    </message>
    <message>
        <source>Six-axis force/moment sensor</source>
        <translation>六轴力/力矩传感器</translation>
    </message>
    <message>
        <source>Scale bar in a network of three cameras and a laser tracker</source>
        <translation>由三台相机和一台激光跟踪仪组成的网络中的基准尺</translation>
    </message>
    <message>
        <source>Stewart platform measured with a total station</source>
        <translation>用全站仪测量的 Stewart 平台</translation>
    </message>
    <message>
        <source>Pose of a Stewart platform measured by a network</source>
        <translation>由网络测量的 Stewart 平台位姿</translation>
    </message>
    <message>
        <source>End-gauge calibration (GUM H.1)</source>
        <translation>量块校准（GUM H.1）</translation>
    </message>
    <message>
        <source>Simultaneous resistance and reactance (GUM H.2)</source>
        <translation>同时测量电阻与电抗（GUM H.2）</translation>
    </message>
    <message>
        <source>Calibration of a thermometer (GUM H.3)</source>
        <translation>温度计校准（GUM H.3）</translation>
    </message>
    <message>
        <source>Zener voltage standard on ten days (GUM H.5)</source>
        <translation>齐纳电压标准的十天测量（GUM H.5）</translation>
    </message>
    <message>
        <source>JCGM 100:2008, Annex H.5, Table H.9: five observations on each of ten days, and the analysis of variance that says whether the days have an effect.</source>
        <translation>JCGM 100:2008，附录 H.5，表 H.9：十天中每天五次观测，以及判断天数是否有影响的方差分析。</translation>
    </message>
    <message>
        <source>Additive model (GUM Supplement 1, 9.2)</source>
        <translation>加法模型（GUM 补充件 1，9.2）</translation>
    </message>
    <message>
        <source>JCGM 101:2008, clause 9.2: a sum of four quantities with three choices of their distributions, and the validation of clause 8.</source>
        <translation>JCGM 101:2008，第 9.2 条：四个量之和，其分布有三种取法，以及第 8 章的验证。</translation>
    </message>
    <message>
        <source>Mass calibration (GUM Supplement 1, 9.3)</source>
        <translation>质量校准（GUM 补充件 1，9.3）</translation>
    </message>
    <message>
        <source>JCGM 101:2008, clause 9.3: a weight of 100 g is compared with a reference weight in air; to first order the densities seem not to matter.</source>
        <translation>JCGM 101:2008，第 9.3 条：在空气中将 100 g 砝码与参考砝码比较；按一阶近似，密度似乎没有影响。</translation>
    </message>
    <message>
        <source>Comparison loss of a power meter (GUM Supplement 1, 9.4)</source>
        <translation>功率计的比较损耗（GUM 补充件 1，9.4）</translation>
    </message>
    <message>
        <source>JCGM 101:2008, clause 9.4, Tables 8 and 9: a sum of two squares near zero, where the law of propagation fails.</source>
        <translation>JCGM 101:2008，第 9.4 条，表 8 和表 9：接近零的两个平方之和，此处传播律失效。</translation>
    </message>
    <message>
        <source>Gauge-block calibration (GUM Supplement 1, 9.5)</source>
        <translation>量块校准（GUM 补充件 1，9.5）</translation>
    </message>
    <message>
        <source>JCGM 101:2008, clause 9.5: the end gauge of GUM H.1 with the distributions of Table 10.</source>
        <translation>JCGM 101:2008，第 9.5 条：GUM H.1 的量块，采用表 10 的分布。</translation>
    </message>
    <message>
        <source>Two sums with a common term (GUM Supplement 2, 9.2)</source>
        <translation>有公共项的两个和（GUM 补充件 2，9.2）</translation>
    </message>
    <message>
        <source>JCGM 102:2011, clause 9.2: a bivariate additive model with standard normal quantities.</source>
        <translation>JCGM 102:2011，第 9.2 条：标准正态量的二元加法模型。</translation>
    </message>
    <message>
        <source>Cartesian to polar co-ordinates (GUM Supplement 2, 9.3)</source>
        <translation>从直角坐标到极坐标（GUM 补充件 2，9.3）</translation>
    </message>
    <message>
        <source>JCGM 102:2011, clause 9.3, Tables 6 and 7: magnitude and phase of a small complex quantity.</source>
        <translation>JCGM 102:2011，第 9.3 条，表 6 和表 7：一个小复数量的模与相位。</translation>
    </message>
    <message>
        <source>Resistance and reactance by Monte Carlo (GUM Supplement 2, 9.4)</source>
        <translation>用蒙特卡洛法求电阻与电抗（GUM 补充件 2，9.4）</translation>
    </message>
    <message>
        <source>JCGM 102:2011, clause 9.4: the impedance of GUM H.2 with trivariate normal input quantities and the joint coverage region of R and X.</source>
        <translation>JCGM 102:2011，第 9.4 条：GUM H.2 的阻抗，输入量为三元正态，以及 R 与 X 的联合包含区域。</translation>
    </message>
    <message>
        <source>JCGM 100:2008, Annex H.1: a gauge block of 50 mm is compared with a standard; first- and second-order law of propagation.</source>
        <translation>JCGM 100:2008，附录 H.1：将 50 mm 量块与标准器比较；一阶和二阶传播律。</translation>
    </message>
    <message>
        <source>JCGM 100:2008, Annex H.2: five simultaneous observations of voltage, current and phase give three correlated results.</source>
        <translation>JCGM 100:2008，附录 H.2：电压、电流和相位的五次同时观测给出三个相关的结果。</translation>
    </message>
    <message>
        <source>JCGM 100:2008, Annex H.3: the correction b of a thermometer at eleven temperatures, and the straight line through them: b(t) = y₁ + y₂ (t − 20 °C).</source>
        <translation>JCGM 100:2008，附录 H.3：温度计在十一个温度下的修正值 b，以及通过它们的直线：b(t) = y₁ + y₂ (t − 20 °C)。</translation>
    </message>
    <message>
        <source>Which twelve of the 22 points of a ballbar measurement make the uncertainty of the tool centre point smallest.</source>
        <translation>球杆仪测量的 22 个点中，哪十二个使工具中心点的不确定度最小。</translation>
    </message>
    <message>
        <source>Three telescopic ballbars measure points on spheres and circles; from them follow the flange, its axes and the tool.</source>
        <translation>三根伸缩式球杆仪测量球面和圆上的点；由此得到法兰、其轴线和工具。</translation>
    </message>
    <message>
        <source>Scale bar, two trackers, flange, identified arm and tool: analyses that feed each other, evaluated as one model.</source>
        <translation>基准尺、两台跟踪仪、法兰、辨识后的机械臂和工具：互相衔接的分析，作为一个模型评定。</translation>
    </message>
    <message>
        <source>Parameters of an arm of six axes, identified from measured places, and the position of its end effector.</source>
        <translation>由实测位置辨识的六轴机械臂参数，及其末端执行器的位置。</translation>
    </message>
    <message>
        <source>Rated output, zero, repeatability and interference of three forces and three moments.</source>
        <translation>三个力和三个力矩的额定输出、零点、重复性和相互干扰。</translation>
    </message>
    <message>
        <source>Distances on a scale bar that three cameras and a laser tracker measure together.</source>
        <translation>三台相机和一台激光跟踪仪共同测量的基准尺上的距离。</translation>
    </message>
    <message>
        <source>Pose of a platform from six measured points, whose uncertainties come from calibrated artefacts.</source>
        <translation>由六个测点得到的平台位姿，测点的不确定度来自已校准的标准件。</translation>
    </message>
    <message>
        <source>Sensor layout, points and pose in one chain: a laser tracker and a total station measure six nests of a platform.</source>
        <translation>传感器布局、点和位姿连成一串：一台激光跟踪仪和一台全站仪测量平台上的六个靶座。</translation>
    </message>
    <message>
        <source>%1 in line %2</source>
        <translation>%1，第 %2 行</translation>
    </message>
    <message>
        <source>columns between tabs</source>
        <translation>以制表符分隔的列</translation>
    </message>
    <message>
        <source>columns between semicolons</source>
        <translation>以分号分隔的列</translation>
    </message>
    <message>
        <source>columns between commas</source>
        <translation>以逗号分隔的列</translation>
    </message>
    <message>
        <source>columns between blanks, decimal commas</source>
        <translation>以空格分隔的列，小数逗号</translation>
    </message>
    <message>
        <source>columns between blanks</source>
        <translation>以空格分隔的列</translation>
    </message>
    <message>
        <source>all %1 met</source>
        <translation>全部 %1 项满足</translation>
    </message>
    <message>
        <source>%1 of %2 not met</source>
        <translation>%2 项中有 %1 项不满足</translation>
    </message>
    <message>
        <source>Requirements</source>
        <translation>要求</translation>
    </message>
    <message>
        <source>Requirements: %1</source>
        <translation>要求：%1</translation>
    </message>
    <message>
        <source>min Σ w (reading − h(X))²</source>
        <translation>min Σ w (读数 − h(X))²</translation>
    </message>
    <message>
        <source>least squares: R maximises tr(Rᵀ Σ (q_i − q̄) l_iᵀ),  o = q̄ − R l̄</source>
        <translation>最小二乘：R 使 tr(Rᵀ Σ (q_i − q̄) l_iᵀ) 最大，o = q̄ − R l̄</translation>
    </message>
    <message>
        <source>Z = ± √(L₁² − X² − Y²);  no value where the root is negative</source>
        <translation>Z = ± √(L₁² − X² − Y²)；根号内为负时无值</translation>
    </message>
    <message>
        <source>min Σ w (L_j − |M − KS_j|)², Gauss-Newton from Eqs 1-3</source>
        <translation>min Σ w (L_j − |M − KS_j|)²，由式 1-3 起的高斯-牛顿法</translation>
    </message>
    <message>
        <source>L_j = |P_i + e_i + R_i (ω_i × t) − KS_j| + reading&apos;s deviation</source>
        <translation>L_j = |P_i + e_i + R_i (ω_i × t) − KS_j| + 读数的偏差</translation>
    </message>
    <message>
        <source>n_x, n_y: planes of the arcs by total least squares;  C: sphere through all points</source>
        <translation>n_x, n_y：由整体最小二乘得到的圆弧平面；C：通过所有点的球</translation>
    </message>
    <message>
        <source>TCP = mean of Rot_iᵀ Fᵀ (M_i − C)</source>
        <translation>TCP = Rot_iᵀ Fᵀ (M_i − C) 的平均</translation>
    </message>
    <message>
        <source>JCGM 102 6.2, with all that points and readings share</source>
        <translation>JCGM 102 6.2，计入点与读数的所有共同部分</translation>
    </message>
    <message>
        <source>n·p = D with |n| = 1, least sum of squares</source>
        <translation>n·p = D，|n| = 1，平方和最小</translation>
    </message>
    <message>
        <source>min Σ (|p_j − c| − R)²  in the fitted plane</source>
        <translation>min Σ (|p_j − c| − R)²，在拟合平面内</translation>
    </message>
    <message>
        <source>x_i = ± z_{i−1} × z_i/|…|,  O_i: foot of the common perpendicular on axis i + 1</source>
        <translation>x_i = ± z_{i−1} × z_i/|…|，O_i：公垂线在轴 i + 1 上的垂足</translation>
    </message>
    <message>
        <source>parallel: O_i in the plane through O_{i−1} normal to z_{i−1},  y_i = z_i × h/|…|,  x_i = y_i × z_i</source>
        <translation>平行时：O_i 在过 O_{i−1} 且垂直于 z_{i−1} 的平面内，y_i = z_i × h/|…|，x_i = y_i × z_i</translation>
    </message>
    <message>
        <source>S_hc = Σ L d_h/Σ L²  over the increasing readings under load c</source>
        <translation>S_hc = Σ L d_h/Σ L²，对载荷 c 下的递增读数求和</translation>
    </message>
    <message>
        <source>V = S L,  L = C V  with  C = S⁻¹</source>
        <translation>V = S L，L = C V，其中 C = S⁻¹</translation>
    </message>
    <message>
        <source>V_h = Σ_c (S_hc L_c + Q_hc L_c²),  by Newton&apos;s method from L = C V</source>
        <translation>V_h = Σ_c (S_hc L_c + Q_hc L_c²)，由 L = C V 起用牛顿法</translation>
    </message>
    <message>
        <source>V_h = d_h + repeatability + resolution + non-zero + hysteresis</source>
        <translation>V_h = d_h + 重复性 + 分辨力 + 零点偏差 + 滞后</translation>
    </message>
    <message>
        <source>S_hc = fitted + regression + S_hc δ_c</source>
        <translation>S_hc = 拟合值 + 回归 + S_hc δ_c</translation>
    </message>
    <message>
        <source>d_hij = d′_hij − d_h0j,  d_hi = mean over j,  s_hi,  u_A = max s_hi/√n</source>
        <translation>d_hij = d′_hij − d_h0j，d_hi = 对 j 的平均，s_hi，u_A = max s_hi/√n</translation>
    </message>
    <message>
        <source>JCGM 100, Eq 1</source>
        <translation>JCGM 100，式 1</translation>
    </message>
    <message>
        <source>JCGM 100, Eqs H.24, H.25, for groups of any size</source>
        <translation>JCGM 100，式 H.24、H.25，适用于任意大小的组</translation>
    </message>
    <message>
        <source>groups included, JCGM 100 H.5.2.3</source>
        <translation>计入组间影响，JCGM 100 H.5.2.3</translation>
    </message>
    <message>
        <source>components of variance, Searle et al. 1992</source>
        <translation>方差分量，Searle 等 1992</translation>
    </message>
    <message>
        <source>groups not included, JCGM 100, Eq H.28</source>
        <translation>未计入组间影响，JCGM 100，式 H.28</translation>
    </message>
    <message>
        <source>JCGM 100, Eq H.12</source>
        <translation>JCGM 100，式 H.12</translation>
    </message>
    <message>
        <source>from the residuals, JCGM 100 H.3.2</source>
        <translation>由残差，JCGM 100 H.3.2</translation>
    </message>
    <message>
        <source>as stated, York et al. 2004</source>
        <translation>按所述，York 等 2004</translation>
    </message>
    <message>
        <source>it must be an analysis of the kept state and have a name (otherName)</source>
        <translation>它必须是所保留状态中的一个分析并有名称 (otherName)</translation>
    </message>
    <message>
        <source>Dimensions are checked where the equations are read; plane angle counts as a number, because the radian is one in the SI. A temperature in °C is taken in kelvin only where two make a ratio; a difference of temperatures is given in K.</source>
        <translation>量纲在读取方程时检查；平面角按数处理，因为弧度在 SI 中是一个数。以 °C 表示的温度只有在两者构成比值时才按开尔文取值；温差以 K 给出。</translation>
    </message>
    <message>
        <source>Angles that inverse functions give or that were read, their sums and whole multiples are on the circle where the result is given in a unit of angle.</source>
        <translation>反函数给出的或读数得到的角度、它们的和与整数倍，当结果以角度单位给出时位于圆周上。</translation>
    </message>
    <message>
        <source>One equation a line: y = x_1*x_2 + x_3. Names without an equation are input quantities; a number has its unit in brackets: 3 [mm]. &apos;solve y = 1: y^2 = x&apos; finds y in every trial, from its starting value. complex(a, b) and polar(r, phi) make complex numbers, re, im, abs and arg real ones of them. &apos;#&apos; starts a comment.</source>
        <translation>每行一个方程：y = x_1*x_2 + x_3。没有方程的名称是输入量；数的单位写在方括号中：3 [mm]。&apos;solve y = 1: y^2 = x&apos; 在每次试验中从起始值求出 y。complex(a, b) 和 polar(r, phi) 构成复数，re、im、abs 和 arg 由其得到实数。&apos;#&apos; 开始注释。</translation>
    </message>
    <message>
        <source>How its uncertainty is known; a and b are then: u; s and n; U and k; U and p in %; half-width (and inexactness, or ratio of top to base); lower and upper limit; step of the indication; permissible error and % of the value; number of counts; number of observations in the mean (pooled); standard deviation (Laplace, Weibull about the value), scale (and shape); expected number of events; number of trials and probability in %. A sample is drawn as it is listed among the observations, a histogram has the edges of its cells there. Empty: a constant.</source>
        <translation>如何得知其不确定度；a 和 b 则为：u；s 和 n；U 和 k；U 和以 % 表示的 p；半宽（以及界限的不精确度，或上底与下底之比）；下限和上限；示值的分辨力；最大允许误差和值的 %；计数；平均值中的观测次数（合并）；标准偏差（拉普拉斯，以值为均值的威布尔），尺度（和形状）；事件的期望数；试验次数和以 % 表示的概率。样本按观测值中所列抽取，直方图的单元边界也在那里。空：常数。</translation>
    </message>
    <message>
        <source>Laplace, standard deviation</source>
        <translation>拉普拉斯，标准偏差</translation>
    </message>
    <message>
        <source>Laplace, scale</source>
        <translation>拉普拉斯，尺度</translation>
    </message>
    <message>
        <source>Weibull, scale and shape</source>
        <translation>威布尔，尺度和形状</translation>
    </message>
    <message>
        <source>Weibull, standard deviation</source>
        <translation>威布尔，标准偏差</translation>
    </message>
    <message>
        <source>Poisson</source>
        <translation>泊松</translation>
    </message>
    <message>
        <source>binomial</source>
        <translation>二项</translation>
    </message>
    <message>
        <source>sample of values</source>
        <translation>数值样本</translation>
    </message>
    <message>
        <source>histogram</source>
        <translation>直方图</translation>
    </message>
    <message>
        <source>ensemble</source>
        <translation>总体组</translation>
    </message>
    <message>
        <source>Name of the evaluation that gave several quantities together, with one and the same nu: their uncertainties rest on one estimate of variance, and they are drawn from a multivariate t distribution (JCGM 102 5.3.2). Correlation coefficients between them stand with the correlations of the analysis.</source>
        <translation>同时给出若干个量且具有同一 nu 的评定的名称：它们的不确定度基于同一方差估计，并从多元 t 分布中抽取（JCGM 102 5.3.2）。它们之间的相关系数与分析的相关一起给出。</translation>
    </message>
    <message>
        <source>Observed value, value of a sample or edge of a histogram, in the unit of the quantity.</source>
        <translation>观测值、样本的值或直方图的边界，以该量的单位表示。</translation>
    </message>
    <message>
        <source>weight</source>
        <translation>权重</translation>
    </message>
    <message>
        <source>Of a value of a sample, or of the cell of a histogram that begins at this edge: counts, or parts of any sum. Empty: one in a sample, none behind the last edge.</source>
        <translation>样本中一个值的权重，或从该边界开始的直方图单元的权重：计数，或任意总和的部分。空：样本中为一，最后边界之后没有。</translation>
    </message>
    <message>
        <source>Covariance of the points</source>
        <translation>点的协方差</translation>
    </message>
    <message>
        <source>Common u of x</source>
        <translation>x 的共同 u</translation>
    </message>
    <message>
        <source>Standard uncertainty of a deviation that all x share beside their own (one standard, one temperature), in the unit of x. Used with stated uncertainties, in the weights too.</source>
        <translation>所有 x 除各自偏差外共有的偏差的标准不确定度（同一标准器、同一温度），以 x 的单位表示。用于给定的不确定度，也用于权重。</translation>
    </message>
    <message>
        <source>Common u of y</source>
        <translation>y 的共同 u</translation>
    </message>
    <message>
        <source>Likewise of all y, in the unit of y.</source>
        <translation>所有 y 同理，以 y 的单位表示。</translation>
    </message>
    <message>
        <source>Correlations of the points</source>
        <translation>点的相关</translation>
    </message>
    <message>
        <source>Correlation coefficients between coordinates of the points (ISO/TS 28037): they change the curve, which minimises v^T V^-1 v, and its uncertainty. Used with stated uncertainties.</source>
        <translation>点的坐标之间的相关系数（ISO/TS 28037）：它们改变使 v^T V^-1 v 最小的曲线及其不确定度。用于给定的不确定度。</translation>
    </message>
    <message>
        <source>A coordinate of a point by its number: y_1 is the y of the first point.</source>
        <translation>用编号表示的点坐标：y_1 是第一个点的 y。</translation>
    </message>
    <message>
        <source>Another one: y_2, or the x_1 of the same point.</source>
        <translation>另一个坐标：y_2，或同一点的 x_1。</translation>
    </message>
    <message>
        <source>coefficient</source>
        <translation>系数</translation>
    </message>
    <message>
        <source>Correlation coefficient of their stated uncertainties.</source>
        <translation>它们的给定不确定度的相关系数。</translation>
    </message>
    <message>
        <source>Certificate of a gauge block of 50 mm</source>
        <translation>50 mm 量块的证书</translation>
    </message>
    <message>
        <source>A gauge block is compared with a standard of the same length, by the model of EA-4/02, S4; its certificate says all that ISO/IEC 17025 7.8 asks for.</source>
        <translation>按 EA-4/02 S4 的模型，将量块与相同长度的标准器比较；其证书包含 ISO/IEC 17025 7.8 要求的全部内容。</translation>
    </message>
    <message>
        <source>Conformity of a micrometer</source>
        <translation>千分尺的符合性</translation>
    </message>
    <message>
        <source>Errors of indication of a micrometer of 25 mm at four gauge blocks, and whether they conform with a maximum permissible error of 4 µm under the decision rule of ISO 14253-1.</source>
        <translation>25 mm 千分尺在四个量块上的示值误差，以及按 ISO 14253-1 的判定规则是否符合 4 µm 的最大允许误差。</translation>
    </message>
    <message>
        <source>A budget from Excel</source>
        <translation>来自 Excel 的预算</translation>
    </message>
    <message>
        <source>What &apos;covaria import excel-budget.xlsx&apos; makes of a budget in a spreadsheet, with the columns of EA-4/02.</source>
        <translation>&apos;covaria import excel-budget.xlsx&apos; 由具有 EA-4/02 各列的电子表格预算得到的结果。</translation>
    </message>
    <message>
        <source>Gewichtsstück von 10 kg</source>
        <translation>10 kg 砝码</translation>
    </message>
    <message>
        <source>Kalibrierung eines Gewichtsstücks nach EA-4/02, S2: ein Beispiel in deutscher Sprache, mit vollständigem Kalibrierschein.</source>
        <translation>按 EA-4/02 S2 校准砝码：一个带完整校准证书的德语示例。</translation>
    </message>
    <message>
        <source>Guard band</source>
        <translation>保护带</translation>
    </message>
    <message>
        <source>How the guard band follows: by the guard factor, by the ratio TUR of tolerance and U (both limits are needed), or so narrow as a target risk allows (global risks need a prior).</source>
        <translation>保护带如何得出：由保护因子、由公差与 U 之比 TUR（需要两个界限），或窄到目标风险所允许（全局风险需要先验）。</translation>
    </message>
    <message>
        <source>Target risk</source>
        <translation>目标风险</translation>
    </message>
    <message>
        <source>That the guard band is made for, above 0 and up to 0.5: 0.02 or 2 %.</source>
        <translation>保护带所针对的风险，大于 0 且不超过 0.5：0.02 或 2 %。</translation>
    </message>
    <message>
        <source>guard factor times U</source>
        <translation>保护因子乘以 U</translation>
    </message>
    <message>
        <source>RSS: root of T²/4 − U²</source>
        <translation>RSS：T²/4 − U² 的平方根</translation>
    </message>
    <message>
        <source>NCSL RP-10: 1.25 − 1/TUR</source>
        <translation>NCSL RP-10：1.25 − 1/TUR</translation>
    </message>
    <message>
        <source>managed (Dobbert): at most 2 % false accepts</source>
        <translation>受控（Dobbert）：误接受至多 2 %</translation>
    </message>
    <message>
        <source>to a specific risk at the acceptance limit</source>
        <translation>按接受限处的特定风险</translation>
    </message>
    <message>
        <source>to a global consumer&apos;s risk</source>
        <translation>按全局消费者风险</translation>
    </message>
    <message>
        <source>to a risk of what is accepted</source>
        <translation>按被接受者的风险</translation>
    </message>
    <message>
        <source>Site of calibration</source>
        <translation>校准场所</translation>
    </message>
    <message>
        <source>Whose place it was done at; empty: in the laboratory, or elsewhere where a place is stated.</source>
        <translation>在谁的场所进行；空：在实验室，或在给出地点处。</translation>
    </message>
    <message>
        <source>Where it was done if not in the laboratory: the customer&apos;s hall, the field.</source>
        <translation>若不在实验室，在何处进行：客户的车间、现场。</translation>
    </message>
    <message>
        <source>To which a statement of conformity refers: the standard or drawing, with its edition.</source>
        <translation>符合性声明所依据的标准或图纸及其版本。</translation>
    </message>
    <message>
        <source>at the customer</source>
        <translation>在客户处</translation>
    </message>
    <message>
        <source>in a branch of the laboratory</source>
        <translation>在实验室的分支机构</translation>
    </message>
    <message>
        <source>in a branch of the customer</source>
        <translation>在客户的分支机构</translation>
    </message>
    <message>
        <source>elsewhere</source>
        <translation>其他地点</translation>
    </message>
    <message>
        <source>RSS guard band</source>
        <translation>RSS 保护带</translation>
    </message>
    <message>
        <source>NCSL RP-10 guard band</source>
        <translation>NCSL RP-10 保护带</translation>
    </message>
    <message>
        <source>managed guard band (Dobbert, 2 % false accepts)</source>
        <translation>受控保护带（Dobbert，误接受 2 %）</translation>
    </message>
    <message>
        <source>guard band to a specific risk of %1</source>
        <translation>按特定风险 %1 的保护带</translation>
    </message>
    <message>
        <source>guard band to a global consumer&apos;s risk of %1</source>
        <translation>按全局消费者风险 %1 的保护带</translation>
    </message>
    <message>
        <source>guard band to a risk of %1 of what is accepted</source>
        <translation>按被接受者风险 %1 的保护带</translation>
    </message>
    <message>
        <source>pass (accepted)</source>
        <translation>合格（接受）</translation>
    </message>
    <message>
        <source>fail (rejected)</source>
        <translation>不合格（拒绝）</translation>
    </message>
    <message>
        <source>January</source>
        <translation>1月</translation>
    </message>
    <message>
        <source>February</source>
        <translation>2月</translation>
    </message>
    <message>
        <source>March</source>
        <translation>3月</translation>
    </message>
    <message>
        <source>April</source>
        <translation>4月</translation>
    </message>
    <message>
        <source>May</source>
        <translation>5月</translation>
    </message>
    <message>
        <source>June</source>
        <translation>6月</translation>
    </message>
    <message>
        <source>July</source>
        <translation>7月</translation>
    </message>
    <message>
        <source>August</source>
        <translation>8月</translation>
    </message>
    <message>
        <source>September</source>
        <translation>9月</translation>
    </message>
    <message>
        <source>October</source>
        <translation>10月</translation>
    </message>
    <message>
        <source>November</source>
        <translation>11月</translation>
    </message>
    <message>
        <source>December</source>
        <translation>12月</translation>
    </message>
    <message>
        <source>%1 %2 %3</source>
        <translation>%3年%2%1日</translation>
    </message>
    <message>
        <source>required by %1 where conformity is stated</source>
        <translation>声明符合性时 %1 要求</translation>
    </message>
    <message>
        <source>%1 is the unit of a temperature, and the quantity is given in %2, in which it may be a difference: give both in %1, or both in %2</source>
        <translation>%1 是温度的单位，而该量以 %2 给出，在其中可能是温差：两者都用 %1，或都用 %2</translation>
    </message>
    <message>
        <source>%1 is a difference of temperatures, and %2 a temperature in %3: take a temperature, or give %2 in K</source>
        <translation>%1 是温差，而 %2 是以 %3 表示的温度：请取一个温度，或以 K 给出 %2</translation>
    </message>
    <message>
        <source>%1 is given in %2, which may be a difference of temperatures, and %3 is a temperature in %4: give both in %4, or both in K</source>
        <translation>%1 以 %2 给出，可能是温差，而 %3 是以 %4 表示的温度：两者都用 %4，或都用 K</translation>
    </message>
    <message>
        <source>%1 is a temperature in %2, and %3 is given in %4, which may be a difference of temperatures: give both in %2, or both in K</source>
        <translation>%1 是以 %2 表示的温度，而 %3 以 %4 给出，可能是温差：两者都用 %2，或都用 K</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is complex, so that &apos;%2&apos; is a part of it: to use a part write re(%1) or im(%1), else choose another name</source>
        <translation>&apos;%1&apos; 是复数，因此 &apos;%2&apos; 是它的一部分：要使用一部分请写 re(%1) 或 im(%1)，否则换一个名称</translation>
    </message>
    <message>
        <source>a complex unknown counts twice, and so does a complex equation: there are %1 real unknowns and %2 real equations</source>
        <translation>复未知数计两次，复方程也是：有 %1 个实未知数和 %2 个实方程</translation>
    </message>
    <message>
        <source>modulus and argument</source>
        <translation>模和辐角</translation>
    </message>
    <message>
        <source>real and imaginary part</source>
        <translation>实部和虚部</translation>
    </message>
    <message>
        <source>%1 of a complex number are real; one of them is complex here</source>
        <translation>复数的%1是实数；这里有一个是复数</translation>
    </message>
    <message>
        <source>complex numbers have no order and are no condition: compare re, im, abs or arg of them</source>
        <translation>复数没有大小顺序，也不是条件：请比较它们的 re、im、abs 或 arg</translation>
    </message>
    <message>
        <source>this function is one of real numbers; for a complex one there are + - * / ^, exp, log, sqrt, sin, cos, tan, sinh, cosh, tanh, conj, abs, arg, re and im</source>
        <translation>此函数用于实数；用于复数的有 + - * / ^、exp、log、sqrt、sin、cos、tan、sinh、cosh、tanh、conj、abs、arg、re 和 im</translation>
    </message>
    <message>
        <source>%1 unknowns are too many to be solved together: the time for each trial grows with the cube of their number, so the limit is %2; solve what does not depend on the rest in systems of its own</source>
        <translation>%1 个未知数太多，无法一起求解：每次试验的时间随其个数的立方增长，因此上限为 %2；不依赖其余部分的请用单独的方程组求解</translation>
    </message>
    <message>
        <source>the expected number of events gives the estimate: leave the value empty, or the number</source>
        <translation>事件的期望数给出估计值：值或该数留空</translation>
    </message>
    <message>
        <source>the expected number of events is missing: state it, or the value</source>
        <translation>缺少事件的期望数：请给出它或值</translation>
    </message>
    <message>
        <source>trials and probability give the estimate: leave the value empty, or the probability</source>
        <translation>试验次数和概率给出估计值：值或概率留空</translation>
    </message>
    <message>
        <source>the probability of each trial is missing: state it, or the value</source>
        <translation>缺少每次试验的概率：请给出它或值</translation>
    </message>
    <message>
        <source>the number of trials must be at least one</source>
        <translation>试验次数至少为一</translation>
    </message>
    <message>
        <source>the probability of each trial must lie between 0 and 100 %</source>
        <translation>每次试验的概率必须在 0 到 100 % 之间</translation>
    </message>
    <message>
        <source>the value must lie between 0 and the number of trials</source>
        <translation>值必须在 0 和试验次数之间</translation>
    </message>
    <message>
        <source>scale and shape give the estimate: leave the value empty, or state the standard deviation alone</source>
        <translation>尺度和形状给出估计值：值留空，或只给出标准偏差</translation>
    </message>
    <message>
        <source>a Weibull distribution needs a value greater than zero, which is its mean</source>
        <translation>威布尔分布需要大于零的值，它是其均值</translation>
    </message>
    <message>
        <source>no Weibull distribution has such a ratio of standard deviation to mean: it must lie between 0.000002 and 429</source>
        <translation>没有威布尔分布具有这样的标准偏差与均值之比：它必须在 0.000002 到 429 之间</translation>
    </message>
    <message>
        <source>observations have no weights: for values with weights write sample 1; 2; 3 weights 2; 5; 2</source>
        <translation>观测值没有权重：带权重的值请写 sample 1; 2; 3 weights 2; 5; 2</translation>
    </message>
    <message>
        <source>weights have no unit</source>
        <translation>权重没有单位</translation>
    </message>
    <message>
        <source>a histogram has one edge more than weights: histogram 0; 1; 2 weights 5; 8</source>
        <translation>直方图的边界比权重多一个：histogram 0; 1; 2 weights 5; 8</translation>
    </message>
    <message>
        <source>there must be as many weights as values</source>
        <translation>权重必须与值一样多</translation>
    </message>
    <message>
        <source>the weights of the cells are missing: histogram 0; 1; 2 weights 5; 8</source>
        <translation>缺少单元的权重：histogram 0; 1; 2 weights 5; 8</translation>
    </message>
    <message>
        <source>write the probability as p = 0.02 or p = 2 %</source>
        <translation>请将概率写作 p = 0.02 或 p = 2 %</translation>
    </message>
    <message>
        <source>location</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>the shape must lie between 0.1 and 1000000.</source>
        <translation>形状必须在 0.1 到 1000000 之间。</translation>
    </message>
    <message>
        <source>value without an event</source>
        <translation>无事件时的值</translation>
    </message>
    <message>
        <source>the expected number of events must lie between 0 and 10000000; beyond it a normal distribution says the same.</source>
        <translation>事件的期望数必须在 0 到 10000000 之间；超出时正态分布给出同样的结果。</translation>
    </message>
    <message>
        <source>the number of trials must be a whole number up to 10000000; beyond it a normal distribution says the same.</source>
        <translation>试验次数必须是不超过 10000000 的整数；超出时正态分布给出同样的结果。</translation>
    </message>
    <message>
        <source>the probability must lie between 0 and 1.</source>
        <translation>概率必须在 0 到 1 之间。</translation>
    </message>
    <message>
        <source>a histogram needs at least one cell.</source>
        <translation>直方图至少需要一个单元。</translation>
    </message>
    <message>
        <source>there must be one edge more than probabilities.</source>
        <translation>边界必须比概率多一个。</translation>
    </message>
    <message>
        <source>edges</source>
        <translation>边界</translation>
    </message>
    <message>
        <source>the edges must rise.</source>
        <translation>边界必须递增。</translation>
    </message>
    <message>
        <source>histogram: there must be one edge more than probabilities.</source>
        <translation>直方图：边界必须比概率多一个。</translation>
    </message>
    <message>
        <source>the measurement model has a kink at the estimates, or bends too sharply there for derivatives of second and third order</source>
        <translation>测量模型在估计值处有折点，或在那里弯曲过大，无法求二阶和三阶导数</translation>
    </message>
    <message>
        <source>the measurement model has no value there</source>
        <translation>测量模型在那里没有值</translation>
    </message>
    <message>
        <source>its sensitivity coefficients are zero, or there are none</source>
        <translation>其灵敏系数为零，或不存在</translation>
    </message>
    <message>
        <source>Monte Carlo answers alone for %1: the measurement model has no sensitivity coefficients at the estimates of its input quantities.</source>
        <translation>%1 只由蒙特卡洛给出：测量模型在其输入量的估计值处没有灵敏系数。</translation>
    </message>
    <message>
        <source>%1 has a kink at the estimates of the input quantities (an absolute value, a maximum, a condition): the law of propagation takes the sensitivity coefficients of one side. Use Monte Carlo.</source>
        <translation>%1 在输入量的估计值处有折点（绝对值、最大值、条件）：传播律取一侧的灵敏系数。请使用蒙特卡洛。</translation>
    </message>
    <message>
        <source>Monte Carlo answers alone for %1, which has a kink at the estimates of the input quantities (an absolute value, a maximum, a condition): the law of propagation would take the sensitivity coefficients of one side.</source>
        <translation>%1 只由蒙特卡洛给出，它在输入量的估计值处有折点（绝对值、最大值、条件）：传播律会取一侧的灵敏系数。</translation>
    </message>
    <message>
        <source>There is no standard uncertainty with second-order terms of %1: they would make its variance negative, so terms of higher order matter as much. Use Monte Carlo.</source>
        <translation>%1 没有含二阶项的标准不确定度：它们会使其方差为负，因此高阶项同样重要。请使用蒙特卡洛。</translation>
    </message>
    <message>
        <source>%1 trials are few for a coverage interval of %2 %: some %3 lie beyond each of its ends, so that U is not known well. JCGM 101 7.2.2 asks for some %4 trials.</source>
        <translation>对于 %2 % 的包含区间，%1 次试验太少：每端之外约有 %3 次，因此 U 不够准确。JCGM 101 7.2.2 要求约 %4 次试验。</translation>
    </message>
    <message>
        <source>the measurement model has no sensitivity coefficients at the estimates of its input quantities%1: it is not differentiable there (singular geometry); Monte Carlo needs none</source>
        <translation>测量模型在输入量的估计值处没有灵敏系数%1：它在那里不可微（奇异几何）；蒙特卡洛不需要灵敏系数</translation>
    </message>
    <message>
        <source>the readings find target %1 %2 mm from its nominal coordinates; look for exchanged names or a unit that was mixed up (the result does not depend on the nominal coordinates)</source>
        <translation>读数得到的目标 %1 距其标称坐标 %2 mm；请查找互换的名称或弄混的单位（结果不取决于标称坐标）</translation>
    </message>
    <message>
        <source>the readings find %1 further targets far from their nominal coordinates</source>
        <translation>读数还得到另外 %1 个远离其标称坐标的目标</translation>
    </message>
    <message>
        <source>observations have degrees of freedom of their own; those made together have the same numbers in the table of observations</source>
        <translation>观测值有自己的自由度；一起进行的观测在观测表中具有相同编号</translation>
    </message>
    <message>
        <source>the members of an ensemble have a standard or expanded uncertainty with finite nu</source>
        <translation>总体组的成员具有有限 nu 的标准或扩展不确定度</translation>
    </message>
    <message>
        <source>the members of ensemble &apos;%1&apos; have one and the same nu; it is %2 in the first, %3 here</source>
        <translation>总体组 &apos;%1&apos; 的成员具有同一 nu；第一个为 %2，此处为 %3</translation>
    </message>
    <message>
        <source>the sample gives the estimate: leave the value empty</source>
        <translation>样本给出估计值：值留空</translation>
    </message>
    <message>
        <source>the weight of a cell of its histogram is missing</source>
        <translation>缺少其直方图一个单元的权重</translation>
    </message>
    <message>
        <source>a histogram has the weight of each cell beside the edge where it begins, and none beside the last edge</source>
        <translation>直方图每个单元的权重在其开始的边界旁，最后的边界旁没有权重</translation>
    </message>
    <message>
        <source>some values of its sample have a weight and some have none</source>
        <translation>其样本的一些值有权重，一些没有</translation>
    </message>
    <message>
        <source>its weights must have a sum above zero</source>
        <translation>其权重之和必须大于零</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is complex: list its parts %2 and %3, or define abs(%1) and arg(%1) and list these</source>
        <translation>&apos;%1&apos; 是复数：请列出其部分 %2 和 %3，或定义 abs(%1) 和 arg(%1) 并列出它们</translation>
    </message>
    <message>
        <source>a difference: %1</source>
        <translation>温差：%1</translation>
    </message>
    <message>
        <source>as stated with correlations, ISO/TS 28037, 10</source>
        <translation>按给定值并含相关，ISO/TS 28037，10</translation>
    </message>
    <message>
        <source>common deviation of all %1</source>
        <translation>所有 %1 的共同偏差</translation>
    </message>
    <message>
        <source>stated for all points</source>
        <translation>对所有点给出</translation>
    </message>
    <message>
        <source>a common deviation is one of stated uncertainties: choose these, or leave it 0</source>
        <translation>共同偏差属于给定的不确定度：请选择它们，或保持为 0</translation>
    </message>
    <message>
        <source>correlations are those of stated uncertainties: choose these, or leave out the correlations</source>
        <translation>相关属于给定的不确定度：请选择它们，或去掉相关</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no coordinate of a point: write y_1 for the y of the first one</source>
        <translation>&apos;%1&apos; 不是点的坐标：第一个点的 y 请写 y_1</translation>
    </message>
    <message>
        <source>%1 has no standard uncertainty of its own that could be correlated</source>
        <translation>%1 没有可以相关的自身标准不确定度</translation>
    </message>
    <message>
        <source>a coordinate is not correlated with itself</source>
        <translation>坐标不与自身相关</translation>
    </message>
    <message>
        <source>the CSV file &apos;%1&apos; of %2 is a link that leads out of the project&apos;s folder: put the file itself there</source>
        <translation>%2 的 CSV 文件 &apos;%1&apos; 是指向项目文件夹之外的链接：请将文件本身放在那里</translation>
    </message>
    <message>
        <source>the guard band of %1 follows from the ratio of tolerance and U: give both limits, or choose a guard factor</source>
        <translation>%1 的保护带由公差与 U 之比得出：请给出两个界限，或选择保护因子</translation>
    </message>
    <message>
        <source>the guard band of %1 is made for a global risk: give the prior, or choose a specific risk</source>
        <translation>%1 的保护带针对全局风险：请给出先验，或选择特定风险</translation>
    </message>
    <message>
        <source>the guard band of %1 needs a tolerance: give a limit</source>
        <translation>%1 的保护带需要公差：请给出一个界限</translation>
    </message>
    <message>
        <source>the target risk of %1 must lie above 0 and not above 0.5</source>
        <translation>%1 的目标风险必须大于 0 且不大于 0.5</translation>
    </message>
    <message>
        <source>another study has the same id</source>
        <translation>另一个研究具有相同的标识</translation>
    </message>
    <message>
        <source>its id must be made of letters, digits, &apos;-&apos; and &apos;_&apos;</source>
        <translation>其标识必须由字母、数字、&apos;-&apos; 和 &apos;_&apos; 组成</translation>
    </message>
    <message>
        <source>there is no asset %1, and no analysis of this name that this one takes from%2</source>
        <translation>没有对象 %1，也没有本分析从中取值的同名分析%2</translation>
    </message>
    <message>
        <source> (did you mean %1?)</source>
        <translation> （您是指 %1 吗？）</translation>
    </message>
    <message>
        <source>a number here is larger than any that can be computed with (1.8e308)</source>
        <translation>这里的一个数大于可以计算的任何数（1.8e308）</translation>
    </message>
    <message>
        <source>the value or its place is no text in UTF-8</source>
        <translation>该值或其位置不是 UTF-8 文本</translation>
    </message>
    <message>
        <source>more than %1 analyses feed each other in a row: put the equations of some of them into one</source>
        <translation>超过 %1 个分析依次相互供给：请将其中一些的方程合为一个</translation>
    </message>
    <message>
        <source>%1 is a link that leads out of the project&apos;s folder: put the picture itself there</source>
        <translation>%1 是指向项目文件夹之外的链接：请将图片本身放在那里</translation>
    </message>
    <message>
        <source>%1; in this file write %2</source>
        <translation>%1；在此文件中写 %2</translation>
    </message>
    <message>
        <source>there is no asset %1%2</source>
        <translation>没有对象 %1%2</translation>
    </message>
    <message>
        <source>the file of candidates &apos;%1&apos; is a link that leads out of the project&apos;s folder: put the file itself there</source>
        <translation>候选文件 &apos;%1&apos; 是指向项目文件夹之外的链接：请将文件本身放在那里</translation>
    </message>
    <message>
        <source>another design has the same id</source>
        <translation>另一个设计具有相同的标识</translation>
    </message>
    <message>
        <source>row %1 was left out</source>
        <translation>第 %1 行已略去</translation>
    </message>
    <message>
        <source>row %1: %2 in %3 beside a sensitivity coefficient is taken as a difference or reading, in %4</source>
        <translation>第 %1 行：%3 中灵敏系数旁的 %2 作为差值或读数，以 %4 取值</translation>
    </message>
    <message>
        <source>the result is not the sum of c x: %1 = %2 is the difference</source>
        <translation>结果不是 c x 之和：%1 = %2 是差值</translation>
    </message>
    <message>
        <source>the sheet %1 has no row %2 to leave out</source>
        <translation>工作表 %1 没有可略去的第 %2 行</translation>
    </message>
    <message>
        <source>%1 is no place of a cell; D3 is one</source>
        <translation>%1 不是单元格的位置；D3 才是</translation>
    </message>
    <message>
        <source>point %1 with other coordinates: those of line %2 are taken</source>
        <translation>点 %1 有其他坐标：取第 %2 行的坐标</translation>
    </message>
    <message>
        <source>%1 determinations of the same points (&lt;coordinates&gt; of lines %2): each is an artefact of its own; keep all of them, or delete those that you do not want</source>
        <translation>相同点的 %1 次测定（第 %2 行的 &lt;coordinates&gt;）：每次都是单独的器具；全部保留，或删除不需要的</translation>
    </message>
    <message>
        <source>%1 is no number: write %2, with a point</source>
        <translation>%1 不是数：请写 %2，用小数点</translation>
    </message>
    <message>
        <source>the name of the result %1 of %2</source>
        <translation>%2 的结果 %1 的名称</translation>
    </message>
    <message>
        <source>the names of the results %1 of %2</source>
        <translation>%2 的结果 %1 的名称</translation>
    </message>
    <message>
        <source>the certificate calls it by its symbol alone: %1 must be stated (ISO/IEC 17025 %2)</source>
        <translation>证书仅以符号称呼它：必须给出%1（ISO/IEC 17025 %2）</translation>
    </message>
    <message>
        <source>under an accreditation U is stated for a coverage probability of about 95 % (ILAC-P14 5.3); here it is %1</source>
        <translation>在认可范围内，U 以约 95 % 的包含概率给出（ILAC-P14 5.3）；此处为 %1</translation>
    </message>
    <message>
        <source>%1: the file states %2, this budget gives %3, %4 apart</source>
        <translation>%1：文件给出 %2，此预算得到 %3，相差 %4</translation>
    </message>
    <message>
        <source>%1: FIND OUT WHY before it is used</source>
        <translation>%1：使用前请查明原因</translation>
    </message>
    <message>
        <source>u(%1) by its contributions</source>
        <translation>由各贡献得到的 u(%1)</translation>
    </message>
    <message>
        <source>%1: the file states no result that this budget could be held against</source>
        <translation>%1：文件没有给出可与此预算比较的结果</translation>
    </message>
    <message>
        <source>another one has the same id</source>
        <translation>另一个具有相同的标识</translation>
    </message>
    <message>
        <source>%1: of what the rule accepts %2 does not conform, of what it rejects %3 does.</source>
        <translation>%1：规则接受的之中 %2 不符合，拒绝的之中 %3 符合。</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>目录</translation>
    </message>
    <message>
        <source>%1 further components of %2 other sources</source>
        <translation>来自另外 %2 个来源的其余 %1 个分量</translation>
    </message>
    <message>
        <source>other sources</source>
        <translation>其他来源</translation>
    </message>
    <message>
        <source>1 further component: %1</source>
        <translation>其余 1 个分量：%1</translation>
    </message>
    <message>
        <source>%1 further components: %2</source>
        <translation>其余 %1 个分量：%2</translation>
    </message>
    <message>
        <source>Left out: %1 components that contribute nothing (less than 10⁻⁹ of u_c).</source>
        <translation>已略去：%1 个没有贡献的分量（小于 u_c 的 10⁻⁹）。</translation>
    </message>
    <message>
        <source>Left out, because they contribute nothing (less than 10⁻⁹ of u_c): %1.</source>
        <translation>因没有贡献（小于 u_c 的 10⁻⁹）而略去：%1。</translation>
    </message>
    <message>
        <source>Stated in the results: %1 = %2 (propagation of distributions).</source>
        <translation>结果中给出：%1 = %2（分布传播）。</translation>
    </message>
    <message>
        <source>%1: under an accreditation U is stated for a coverage probability of about 95 % (ILAC-P14 5.3); with k = %2 that of %3 is %4</source>
        <translation>%1：在认可范围内，U 以约 95 % 的包含概率给出（ILAC-P14 5.3）；k = %2 时 %3 的包含概率为 %4</translation>
    </message>
    <message>
        <source>not drawn, for it is farther away than 10¹² km: %1</source>
        <translation>未绘出，因为它远于 10¹² km：%1</translation>
    </message>
    <message>
        <source>Laplace</source>
        <translation>拉普拉斯</translation>
    </message>
    <message>
        <source>Weibull</source>
        <translation>威布尔</translation>
    </message>
    <message>
        <source>expected number of events</source>
        <translation>事件的期望数</translation>
    </message>
    <message>
        <source>step of one event</source>
        <translation>一个事件的步长</translation>
    </message>
    <message>
        <source>probability</source>
        <translation>概率</translation>
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
        <translation>75 nm：标准不确定度
2 ppm：标准不确定度，值的一部分；若该量本身是比值则为绝对值
U = 0.3 um, k = 2（或 p = 95 %）：证书
s = 13 nm, n = 5：事先已知的标准偏差，n 次观测的平均值（A 类）
rectangular 0.5（或 rect, ±）：以值为中心的界限；triangular、arcsine 同理
limits 19.5 to 20.5：它们给出值
10.1; 10.3; 10.2：观测值
resolution 0.01, MPE 3 + 0.1 %, counts 12, constant
Laplace 0.3, Weibull 0.3（标准偏差），Weibull scale 2, shape 1.5
Poisson 12, binomial n = 50, p = 2 %：它们给出值
sample 1; 2; 3 weights 2; 5; 2（按原样抽取），histogram 0; 1; 2 weights 5; 8（边界）
其后的 nu 18：自由度</translation>
    </message>
    <message>
        <source>sample</source>
        <translation>样本</translation>
    </message>
    <message>
        <source>weights</source>
        <translation>权重</translation>
    </message>
    <message>
        <source>Network adjustment</source>
        <translation>网平差</translation>
    </message>
    <message>
        <source>Coordinates of stations and targets from the distances, directions, angles and height differences that were read between them: heights, plane or space, free or held by known points, with the reliability of each reading.</source>
        <translation>由测站和目标点之间所读的距离、方向、角度和高差求其坐标：高程、平面或空间，自由或由已知点固定，并给出每个读数的可靠性。</translation>
    </message>
    <message>
        <source>Uncertainties follow from those that were stated for the readings; they are not multiplied by s_0, which is a test of them.</source>
        <translation>不确定度由对读数给出的不确定度得出；不乘以 s_0，s_0 是对它们的检验。</translation>
    </message>
    <message>
        <source>In a free network what no reading tells is taken from the approximate coordinates of the points of the datum: the sum of squares of their changes is least. Residuals, s_0 and redundancies do not depend on the datum.</source>
        <translation>在自由网中，读数无法确定的部分取自各基准点的近似坐标：其改变量的平方和最小。残差、s_0 和多余度与基准无关。</translation>
    </message>
    <message>
        <source>Each round of directions has an orientation that is not known. Instruments are levelled unless the set-up says how they lean: zenith angles count from the vertical, the z-axis at all points.</source>
        <translation>每个测回的方向有一个未知的定向。仪器视为已整平，除非测量设置说明其如何倾斜：天顶距从铅垂线起算，在所有点处即为 z 轴。</translation>
    </message>
    <message>
        <source>Smallest detectable errors are those of a test at 0.1 % with a power of 80 % (delta_0 = 4.132), with the uncertainties that were stated.</source>
        <translation>最小可探测误差是检验显著性水平为 0.1 %、功效为 80 % 时的值（delta_0 = 4.132），采用给出的不确定度。</translation>
    </message>
    <message>
        <source>In Monte Carlo each trial is a solution with the derivatives at the estimates, repeated until it stands still.</source>
        <translation>在蒙特卡洛中，每次试验都用估计值处的导数求解，并重复到不再变化为止。</translation>
    </message>
    <message>
        <source>Stations and targets alike, with what is known of them beforehand.</source>
        <translation>测站和目标点一并列出，并说明事先已知的内容。</translation>
    </message>
    <message>
        <source>Coordinate x; of an unknown point an approximate one, or empty: the readings place it.</source>
        <translation>坐标 x；未知点填近似值或留空：由读数确定其位置。</translation>
    </message>
    <message>
        <source>Coordinate y; of an unknown point an approximate one, or empty: the readings place it.</source>
        <translation>坐标 y；未知点填近似值或留空：由读数确定其位置。</translation>
    </message>
    <message>
        <source>Coordinate z; of an unknown point an approximate one, or empty: the readings place it.</source>
        <translation>坐标 z；未知点填近似值或留空：由读数确定其位置。</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>What is known of x and y: unknown; unknown, and what no reading tells is taken from this point and others like it (free network); fixed without uncertainty; stated with u.</source>
        <translation>x 和 y 的已知情况：未知；未知，且读数无法确定的部分取自此点及其他同类点（自由网）；固定，无不确定度；以 u 给出。</translation>
    </message>
    <message>
        <source>unknown, of the datum</source>
        <translation>未知，属于基准</translation>
    </message>
    <message>
        <source>stated with u</source>
        <translation>以 u 给出</translation>
    </message>
    <message>
        <source>not part of the network</source>
        <translation>不属于网</translation>
    </message>
    <message>
        <source>height</source>
        <translation>高程</translation>
    </message>
    <message>
        <source>What is known of z, likewise.</source>
        <translation>z 的已知情况，同上。</translation>
    </message>
    <message>
        <source>Standard uncertainty of a stated coordinate.</source>
        <translation>给出的坐标的标准不确定度。</translation>
    </message>
    <message>
        <source>Name of a point.</source>
        <translation>一个点的名称。</translation>
    </message>
    <message>
        <source>Name of another point.</source>
        <translation>另一个点的名称。</translation>
    </message>
    <message>
        <source>Directions grow</source>
        <translation>方向增大</translation>
    </message>
    <message>
        <source>In which sense directions, angles and azimuths grow, and from which axis azimuths count.</source>
        <translation>方向、角度和方位角向哪一侧增大，以及方位角从哪根轴起算。</translation>
    </message>
    <message>
        <source>from x towards y; azimuths count from x</source>
        <translation>从 x 向 y；方位角从 x 起算</translation>
    </message>
    <message>
        <source>from y towards x; azimuths count from y</source>
        <translation>从 y 向 x；方位角从 y 起算</translation>
    </message>
    <message>
        <source>What was read between the points, one row for each figure, typed or from a CSV file.</source>
        <translation>在各点之间所读的内容，每个数值一行，手工输入或来自 CSV 文件。</translation>
    </message>
    <message>
        <source>label</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>By which a correlation calls it.</source>
        <translation>相关性用它来指称该读数。</translation>
    </message>
    <message>
        <source>What was read.</source>
        <translation>所读的量。</translation>
    </message>
    <message>
        <source>slope distance</source>
        <translation>斜距</translation>
    </message>
    <message>
        <source>horizontal distance</source>
        <translation>平距</translation>
    </message>
    <message>
        <source>zenith angle</source>
        <translation>天顶距</translation>
    </message>
    <message>
        <source>height difference</source>
        <translation>高差</translation>
    </message>
    <message>
        <source>x of a point</source>
        <translation>点的 x</translation>
    </message>
    <message>
        <source>y of a point</source>
        <translation>点的 y</translation>
    </message>
    <message>
        <source>z of a point</source>
        <translation>点的 z</translation>
    </message>
    <message>
        <source>difference of x</source>
        <translation>x 之差</translation>
    </message>
    <message>
        <source>difference of y</source>
        <translation>y 之差</translation>
    </message>
    <message>
        <source>difference of z</source>
        <translation>z 之差</translation>
    </message>
    <message>
        <source>The point where it was read; of a coordinate its point.</source>
        <translation>进行读数的点；对于坐标则为该坐标所属的点。</translation>
    </message>
    <message>
        <source>The point that was sighted.</source>
        <translation>所照准的点。</translation>
    </message>
    <message>
        <source>Of an angle the point at its second leg.</source>
        <translation>对于角度，为其第二条边上的点。</translation>
    </message>
    <message>
        <source>round</source>
        <translation>测回</translation>
    </message>
    <message>
        <source>Of a direction: rounds of one station between which its circle was turned have names; each has an orientation of its own.</source>
        <translation>用于方向：同一测站上其间转动过度盘的各测回有各自的名称；每个测回有自己的定向。</translation>
    </message>
    <message>
        <source>A length or coordinate as read.</source>
        <translation>所读的长度或坐标。</translation>
    </message>
    <message>
        <source>An angle as read.</source>
        <translation>所读的角度。</translation>
    </message>
    <message>
        <source>u of length</source>
        <translation>长度的 u</translation>
    </message>
    <message>
        <source>Standard uncertainty of the length.</source>
        <translation>长度的标准不确定度。</translation>
    </message>
    <message>
        <source>u of angle</source>
        <translation>角度的 u</translation>
    </message>
    <message>
        <source>Standard uncertainty of the angle.</source>
        <translation>角度的标准不确定度。</translation>
    </message>
    <message>
        <source>height from</source>
        <translation>仪器高</translation>
    </message>
    <message>
        <source>Height of the instrument above its point.</source>
        <translation>仪器高出其点的高度。</translation>
    </message>
    <message>
        <source>height to</source>
        <translation>目标高</translation>
    </message>
    <message>
        <source>Height of the target above its point.</source>
        <translation>目标高出其点的高度。</translation>
    </message>
    <message>
        <source>Instruments that are not levelled</source>
        <translation>未整平的仪器</translation>
    </message>
    <message>
        <source>Where an instrument stands that is not levelled, or not exactly; all others are.</source>
        <translation>未整平或未精确整平的仪器所在之处；其他仪器均已整平。</translation>
    </message>
    <message>
        <source>The point where the instrument stands.</source>
        <translation>仪器所在的点。</translation>
    </message>
    <message>
        <source>tilt</source>
        <translation>倾斜</translation>
    </message>
    <message>
        <source>How it leans: unknown, so that the readings tell it; or levelled within u, about x and about y.</source>
        <translation>仪器如何倾斜：未知，由读数确定；或在 u 之内整平，绕 x 和绕 y。</translation>
    </message>
    <message>
        <source>levelled within u</source>
        <translation>在 u 之内整平</translation>
    </message>
    <message>
        <source>u of tilt</source>
        <translation>倾斜的 u</translation>
    </message>
    <message>
        <source>Standard uncertainty of each tilt of a levelled instrument.</source>
        <translation>已整平仪器的每个倾斜的标准不确定度。</translation>
    </message>
    <message>
        <source>Correlations of readings</source>
        <translation>读数的相关性</translation>
    </message>
    <message>
        <source>Correlation coefficients of readings: they change the weights and the uncertainty.</source>
        <translation>读数的相关系数：它们改变权和不确定度。</translation>
    </message>
    <message>
        <source>Label of a reading.</source>
        <translation>一个读数的标签。</translation>
    </message>
    <message>
        <source>Label of another reading.</source>
        <translation>另一个读数的标签。</translation>
    </message>
    <message>
        <source>Correlation coefficient of the two.</source>
        <translation>两者的相关系数。</translation>
    </message>
    <message>
        <source>Two targets from two stations that nobody measured</source>
        <translation>由两个未测定的测站求两个目标点</translation>
    </message>
    <message>
        <source>A total station stood at S1 and S2, whose places are not known.</source>
        <translation>全站仪设在 S1 和 S2，其位置未知。</translation>
    </message>
    <message>
        <source>The law of propagation of uncertainty says nothing of %1 at these estimates: Monte Carlo answers alone</source>
        <translation>不确定度传播律在这些估计值处对 %1 没有说明：只由蒙特卡洛给出</translation>
    </message>
    <message>
        <source>The standard uncertainty by Monte Carlo of %1 is not known from these trials, and may not exist: the tails of its distribution are too heavy. Use the coverage interval.</source>
        <translation>%1 的蒙特卡洛标准不确定度无法由这些试验得知，也可能不存在：其分布的尾部过重。请使用包含区间。</translation>
    </message>
    <message>
        <source>as stated</source>
        <translation>按给出值</translation>
    </message>
    <message>
        <source>tilt at %1 about %2</source>
        <translation>%1 处绕 %2 的倾斜</translation>
    </message>
    <message>
        <source>orientation at %1</source>
        <translation>%1 处的定向</translation>
    </message>
    <message>
        <source>orientation at %1, round %2</source>
        <translation>%1 处的定向，测回 %2</translation>
    </message>
    <message>
        <source>readings l, their residuals v, unknowns x</source>
        <translation>读数 l，其残差 v，未知数 x</translation>
    </message>
    <message>
        <source>least squares, Gauss-Newton method</source>
        <translation>最小二乘，高斯-牛顿法</translation>
    </message>
    <message>
        <source>law of propagation; generalised inverse of the datum</source>
        <translation>传播律；基准的广义逆</translation>
    </message>
    <message>
        <source>free network: W. Baarda, S-transformations, 1973</source>
        <translation>自由网：W. Baarda, S-transformations, 1973</translation>
    </message>
    <message>
        <source>redundancy and test of a reading: W. Baarda, A testing procedure, 1968</source>
        <translation>读数的多余度和检验：W. Baarda, A testing procedure, 1968</translation>
    </message>
    <message>
        <source>smallest error of a reading that the test finds</source>
        <translation>检验能发现的读数最小误差</translation>
    </message>
    <message>
        <source>a posteriori; uncertainties are those that were stated, not times s₀</source>
        <translation>后验；不确定度为给出的不确定度，不乘以 s₀</translation>
    </message>
    <message>
        <source>slope distance %1 – %2</source>
        <translation>斜距 %1 – %2</translation>
    </message>
    <message>
        <source>horizontal distance %1 – %2</source>
        <translation>平距 %1 – %2</translation>
    </message>
    <message>
        <source>direction %1 – %2</source>
        <translation>方向 %1 – %2</translation>
    </message>
    <message>
        <source>azimuth %1 – %2</source>
        <translation>方位角 %1 – %2</translation>
    </message>
    <message>
        <source>zenith angle %1 – %2</source>
        <translation>天顶距 %1 – %2</translation>
    </message>
    <message>
        <source>height difference %1 – %2</source>
        <translation>高差 %1 – %2</translation>
    </message>
    <message>
        <source>tilt about x of the instrument at %1</source>
        <translation>%1 处仪器绕 x 的倾斜</translation>
    </message>
    <message>
        <source>tilt about y of the instrument at %1</source>
        <translation>%1 处仪器绕 y 的倾斜</translation>
    </message>
    <message>
        <source>x of %1</source>
        <translation>%1 的 x</translation>
    </message>
    <message>
        <source>y of %1</source>
        <translation>%1 的 y</translation>
    </message>
    <message>
        <source>z of %1</source>
        <translation>%1 的 z</translation>
    </message>
    <message>
        <source>difference of x, %1 – %2</source>
        <translation>x 之差，%1 – %2</translation>
    </message>
    <message>
        <source>difference of y, %1 – %2</source>
        <translation>y 之差，%1 – %2</translation>
    </message>
    <message>
        <source>difference of z, %1 – %2</source>
        <translation>z 之差，%1 – %2</translation>
    </message>
    <message>
        <source>the readings do not lead to a place of every point: the adjustment does not converge; look for exchanged or mistyped readings, for a unit that was mixed up (gon and degrees, m and mm), and for coordinates that are far off</source>
        <translation>读数不能得出每个点的位置：平差不收敛；请查找对调或误输的读数、弄混的单位（gon 与度、m 与 mm）以及偏离很远的坐标</translation>
    </message>
    <message>
        <source>and %1 further ways in which the points can move</source>
        <translation>以及另外 %1 种点可移动的方式</translation>
    </message>
    <message>
        <source>point %1: its %2 is said to be known, and is missing</source>
        <translation>点 %1：其 %2 称为已知，但缺失</translation>
    </message>
    <message>
        <source>point %1: the u of its stated %2 is missing</source>
        <translation>点 %1：缺少所给出的 %2 的 u</translation>
    </message>
    <message>
        <source>the name of a point is missing</source>
        <translation>缺少一个点的名称</translation>
    </message>
    <message>
        <source>there is no point %1</source>
        <translation>没有点 %1</translation>
    </message>
    <message>
        <source>the instrument at %1: the u of its tilt is missing</source>
        <translation>%1 处的仪器：缺少其倾斜的 u</translation>
    </message>
    <message>
        <source>two instruments stand at %1</source>
        <translation>有两台仪器设在 %1</translation>
    </message>
    <message>
        <source>a reading from %1 to itself</source>
        <translation>从 %1 到其自身的读数</translation>
    </message>
    <message>
        <source>both legs of the angle at %1 go to %2</source>
        <translation>%1 处的角度的两条边都指向 %2</translation>
    </message>
    <message>
        <source>%1: its value is missing</source>
        <translation>%1：缺少其值</translation>
    </message>
    <message>
        <source>%1: its standard uncertainty is missing</source>
        <translation>%1：缺少其标准不确定度</translation>
    </message>
    <message>
        <source>%1 is an angle and has a length</source>
        <translation>%1 是角度却带有长度</translation>
    </message>
    <message>
        <source>%1 is a length and has an angle</source>
        <translation>%1 是长度却带有角度</translation>
    </message>
    <message>
        <source>%1 is not positive</source>
        <translation>%1 不是正值</translation>
    </message>
    <message>
        <source>%1 needs the height of %2, which is not part of the network</source>
        <translation>%1 需要 %2 的高程，而它不属于网</translation>
    </message>
    <message>
        <source>%1 needs x and y of %2, which are not part of the network</source>
        <translation>%1 需要 %2 的 x 和 y，而它们不属于网</translation>
    </message>
    <message>
        <source>a distance needs two points</source>
        <translation>距离需要两个点</translation>
    </message>
    <message>
        <source>all points are fixed: there is nothing to be found</source>
        <translation>所有点都已固定：没有待求的量</translation>
    </message>
    <message>
        <source>two readings have the label %1</source>
        <translation>有两个读数的标签都是 %1</translation>
    </message>
    <message>
        <source>there is no reading with the label %1</source>
        <translation>没有标签为 %1 的读数</translation>
    </message>
    <message>
        <source>reading %1 with itself</source>
        <translation>读数 %1 与其自身</translation>
    </message>
    <message>
        <source>the correlation coefficients are not possible together</source>
        <translation>这些相关系数不能同时成立</translation>
    </message>
    <message>
        <source>the readings do not place point %1: too few of them tie it to the others; add readings, or state approximate coordinates</source>
        <translation>读数不能确定点 %1 的位置：把它与其他点联系起来的读数太少；请添加读数，或给出近似坐标</translation>
    </message>
    <message>
        <source>the readings do not place %1 points (%2): too few tie them to the others; add readings, or state approximate coordinates</source>
        <translation>读数不能确定 %1 个点（%2）的位置：把它们与其他点联系起来的读数太少；请添加读数，或给出近似坐标</translation>
    </message>
    <message>
        <source>Adjustment</source>
        <translation>平差</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>unknowns</source>
        <translation>未知数</translation>
    </message>
    <message>
        <source>what no reading tells (datum defect)</source>
        <translation>读数无法确定的部分（基准秩亏）</translation>
    </message>
    <message>
        <source>degrees of freedom f</source>
        <translation>自由度 f</translation>
    </message>
    <message>
        <source>sum of squares vᵀ C⁻¹ v</source>
        <translation>平方和 vᵀ C⁻¹ v</translation>
    </message>
    <message>
        <source>s₀ a posteriori</source>
        <translation>后验 s₀</translation>
    </message>
    <message>
        <source>δ₀ of smallest detectable errors (0.1 %, 80 %)</source>
        <translation>最小可探测误差的 δ₀（0.1 %，80 %）</translation>
    </message>
    <message>
        <source>smallest detectable error</source>
        <translation>最小可探测误差</translation>
    </message>
    <message>
        <source>its largest effect</source>
        <translation>其最大影响</translation>
    </message>
    <message>
        <source>on</source>
        <translation>影响于</translation>
    </message>
    <message>
        <source>%1 The residuals are larger than the uncertainties allow; the largest for its uncertainty is the %2. Look for mistyped or exchanged readings, or uncertainties that are too small</source>
        <translation>%1 残差大于不确定度所允许的；相对其不确定度最大的是 %2。请查找误输或对调的读数，或过小的不确定度</translation>
    </message>
    <message>
        <source>nothing was read of point %1: add readings to it, or take it out</source>
        <translation>点 %1 没有任何读数：请为其添加读数，或将其去掉</translation>
    </message>
    <message>
        <source>nothing tells how the instrument at %1 stood: add directions or angles from there to places that are known</source>
        <translation>无法确定 %1 处仪器的朝向：请添加从该处到已知位置的方向或角度</translation>
    </message>
    <message>
        <source>nothing tells the height of %1: state it, or add a height difference, or a zenith angle with a distance</source>
        <translation>无法确定 %1 的高程：请给出其高程，或添加高差，或添加天顶距和距离</translation>
    </message>
    <message>
        <source>nothing tells where %1 is: add readings to it</source>
        <translation>无法确定 %1 的位置：请为其添加读数</translation>
    </message>
    <message>
        <source>point %1 can move along %2 without changing a reading: add one that sees this</source>
        <translation>点 %1 可沿 %2 移动而不改变任何读数：请添加能反映这一移动的读数</translation>
    </message>
    <message>
        <source>the direction (%1, %2, %3)</source>
        <translation>方向 (%1, %2, %3)</translation>
    </message>
    <message>
        <source>the whole network</source>
        <translation>整个网</translation>
    </message>
    <message>
        <source>the part with %1 and %2 more</source>
        <translation>含 %1 及另外 %2 个点的部分</translation>
    </message>
    <message>
        <source>the part with %1</source>
        <translation>含 %1 的部分</translation>
    </message>
    <message>
        <source>nothing tells where %1 is along %2: fix or state a point, or let points be of the datum</source>
        <translation>无法确定 %1 沿 %2 的位置：请固定一个点或给出其坐标，或让一些点属于基准</translation>
    </message>
    <message>
        <source>nothing tells the height of %1: fix or state the height of a point, or let heights be of the datum</source>
        <translation>无法确定 %1 的高程：请固定或给出一个点的高程，或让一些高程属于基准</translation>
    </message>
    <message>
        <source>%1 may tilt about %2: add zenith angles or height differences, or fix a third point</source>
        <translation>%1 可绕 %2 倾斜：请添加天顶距或高差，或固定第三个点</translation>
    </message>
    <message>
        <source>%1 may turn about the vertical: add an azimuth, fix a second point, or let points be of the datum</source>
        <translation>%1 可绕铅垂线转动：请添加方位角，固定第二个点，或让一些点属于基准</translation>
    </message>
    <message>
        <source>nothing tells the scale of %1: add a distance, fix a second point, or let points be of the datum</source>
        <translation>无法确定 %1 的尺度：请添加距离，固定第二个点，或让一些点属于基准</translation>
    </message>
    <message>
        <source>the readings leave open a common movement of %1: add readings that tie them to the others</source>
        <translation>读数未能约束 %1 的共同移动：请添加把它们与其他点联系起来的读数</translation>
    </message>
    <message>
        <source>orientations</source>
        <translation>定向</translation>
    </message>
    <message>
        <source>moving platform</source>
        <translation>动平台</translation>
    </message>
    <message>
        <source>lengths</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>measured orientations</source>
        <translation>实测姿态</translation>
    </message>
    <message>
        <source>measured positions</source>
        <translation>实测位置</translation>
    </message>
    <message>
        <source>readings of the joints</source>
        <translation>关节读数</translation>
    </message>
    <message>
        <source>circle of %1</source>
        <translation>%1 的圆</translation>
    </message>
    <message>
        <source>regression</source>
        <translation>回归</translation>
    </message>
    <message>
        <source>it cannot be varied: %1</source>
        <translation>不能改变它：%1</translation>
    </message>
    <message>
        <source>no more than %1</source>
        <translation>不大于 %1</translation>
    </message>
    <message>
        <source>an observation of %1, which the file neither fixes nor adjusts in what it needs</source>
        <translation>%1 的一个观测，其所需的坐标在文件中既未固定也未平差</translation>
    </message>
    <message>
        <source>an observation of %1 without a standard deviation</source>
        <translation>%1 的一个没有标准偏差的观测</translation>
    </message>
    <message>
        <source>a network of %1 points with %2 readings, which is adjusted</source>
        <translation>含 %1 个点和 %2 个读数的网，将其平差</translation>
    </message>
    <message>
        <source>its heights above the points are no numbers</source>
        <translation>其高出点的高度不是数字</translation>
    </message>
    <message>
        <source>column %1%2 of sheet %3 is filled but not understood: state what each column is, %4, with one of %5 in place of ? (- leaves the column out)</source>
        <translation>工作表 %3 的列 %1%2 有内容但无法理解：请说明每列是什么，%4，用 %5 之一代替 ?（- 表示略去该列）</translation>
    </message>
    <message>
        <source>There is no budget of %1: the law of propagation of uncertainty says nothing of it at the estimates of its input quantities.</source>
        <translation>没有 %1 的预算：不确定度传播律在其输入量的估计值处对它没有说明。</translation>
    </message>
    <message>
        <source>out</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>%1 trials</source>
        <translation>%1 次试验</translation>
    </message>
    <message>
        <source>sight</source>
        <translation>视线</translation>
    </message>
    <message>
        <source>force, own scale</source>
        <translation>力，独立比例</translation>
    </message>
    <message>
        <source>moment, own scale</source>
        <translation>力矩，独立比例</translation>
    </message>
    <message>
        <source>in</source>
        <translation>输入</translation>
    </message>
    <message>
        <source>uncertainty %1</source>
        <translation>不确定度 %1</translation>
    </message>
    <message>
        <source>ellipsoids %1, %2</source>
        <translation>椭球 %1，%2</translation>
    </message>
    <message>
        <source>Uncertainties of the readings</source>
        <translation>读数的不确定度</translation>
    </message>
    <message>
        <source>As typed in the table; or as the residuals of this adjustment see them: typed ones times one common factor s_0, or times the factor of each kind of reading and instrument (variance components). Either has the degrees of freedom of its estimate.</source>
        <translation>按表中输入的值；或按本次平差的残差所见的值：输入值乘以一个共同的系数 s_0，或乘以每类读数和每台仪器各自的系数（方差分量）。后两者均具有其估计的自由度。</translation>
    </message>
    <message>
        <source>as seen, one factor s_0</source>
        <translation>按所见值，一个系数 s_0</translation>
    </message>
    <message>
        <source>as seen, a factor for each figure</source>
        <translation>按所见值，每个指标一个系数</translation>
    </message>
    <message>
        <source>Are the figures of the data sheet true?</source>
        <translation>数据表的指标属实吗？</translation>
    </message>
    <message>
        <source>A section of a barrel, 8 m long, with 20 targets, read by a total station from three places that nobody measured.</source>
        <translation>一段 8 m 长的筒体，带 20 个目标点，由全站仪从三个未经测量的位置读取。</translation>
    </message>
    <message>
        <source>slope distances</source>
        <translation>斜距</translation>
    </message>
    <message>
        <source>horizontal distances</source>
        <translation>平距</translation>
    </message>
    <message>
        <source>directions</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>azimuths</source>
        <translation>方位角</translation>
    </message>
    <message>
        <source>zenith angles</source>
        <translation>天顶距</translation>
    </message>
    <message>
        <source>height differences</source>
        <translation>高差</translation>
    </message>
    <message>
        <source>tilts of instruments</source>
        <translation>仪器的倾斜</translation>
    </message>
    <message>
        <source>stated coordinates</source>
        <translation>给出的坐标</translation>
    </message>
    <message>
        <source>coordinates</source>
        <translation>坐标</translation>
    </message>
    <message>
        <source>coordinate differences</source>
        <translation>坐标差</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 和 %2</translation>
    </message>
    <message>
        <source>The readings have no residuals that could tell their uncertainty: it stays as stated</source>
        <translation>读数没有可确定其不确定度的残差：其不确定度保持给出值</translation>
    </message>
    <message>
        <source>Nothing is redundant: uncertainties of the readings stay as stated</source>
        <translation>无冗余：读数的不确定度保持给出值</translation>
    </message>
    <message>
        <source>The residuals give no factors: uncertainties of the readings stay as stated</source>
        <translation>残差不能得出系数：读数的不确定度保持给出值</translation>
    </message>
    <message>
        <source>Too little redundancy to say, so they stay as stated: %1</source>
        <translation>多余度太小，无法判断，因此保持给出值：%1</translation>
    </message>
    <message>
        <source>as seen: %1 times what was stated</source>
        <translation>按所见值：给出值的 %1 倍</translation>
    </message>
    <message>
        <source>measured places</source>
        <translation>实测位置</translation>
    </message>
    <message>
        <source>encoders of the joints</source>
        <translation>关节的编码器</translation>
    </message>
    <message>
        <source>repeatability of the joints</source>
        <translation>关节的重复性</translation>
    </message>
    <message>
        <source>Residuals over their standard uncertainties as stated</source>
        <translation>残差除以其给出的标准不确定度</translation>
    </message>
    <message>
        <source>others</source>
        <translation>其他</translation>
    </message>
    <message>
        <source>Quantiles of the residuals</source>
        <translation>残差的分位数</translation>
    </message>
    <message>
        <source>normal distribution</source>
        <translation>正态分布</translation>
    </message>
    <message>
        <source>The readings cannot tell apart, and give one factor to: %1.</source>
        <translation>读数不能区分以下各项，对它们给出同一系数：%1。</translation>
    </message>
    <message>
        <source>The estimate of the variance was negative, so it is zero, of: %1.</source>
        <translation>以下各项的方差估计值为负，因此取零：%1。</translation>
    </message>
    <message>
        <source>The global test does not see that figures which are too large and figures which are too small make up for each other: %1.</source>
        <translation>总体检验看不出过大的指标与过小的指标相互抵消：%1。</translation>
    </message>
    <message>
        <source>seen is smaller</source>
        <translation>所见值较小</translation>
    </message>
    <message>
        <source>seen is larger</source>
        <translation>所见值较大</translation>
    </message>
    <message>
        <source>too little to say</source>
        <translation>不足以判断</translation>
    </message>
    <message>
        <source>Stated and seen uncertainties</source>
        <translation>给出的和所见的不确定度</translation>
    </message>
    <message>
        <source>figure</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>stated u</source>
        <translation>给出的 u</translation>
    </message>
    <message>
        <source>factor</source>
        <translation>系数</translation>
    </message>
    <message>
        <source>seen u</source>
        <translation>所见的 u</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>结论</translation>
    </message>
    <message>
        <source>Nothing is redundant: the readings say nothing.</source>
        <translation>无冗余：读数不能说明任何问题。</translation>
    </message>
    <message>
        <source>More than %1 readings: their factors are not computed.</source>
        <translation>读数超过 %1 个：不计算其系数。</translation>
    </message>
    <message>
        <source>The factors of the figures do not come to rest.</source>
        <translation>各指标的系数不收敛。</translation>
    </message>
    <message>
        <source>Global test: s₀ = %1 with %2 degrees of freedom passes (%3 to %4).</source>
        <translation>总体检验：s₀ = %1，自由度 %2，通过（%3 至 %4）。</translation>
    </message>
    <message>
        <source>Global test: s₀ = %1 with %2 degrees of freedom fails (%3 to %4).</source>
        <translation>总体检验：s₀ = %1，自由度 %2，未通过（%3 至 %4）。</translation>
    </message>
    <message>
        <source>Mean u of a coordinate: %1 as stated, %2 as seen.</source>
        <translation>坐标的 u 平均值：按给出值 %1，按所见值 %2。</translation>
    </message>
    <message>
        <source>Geometry from points</source>
        <translation>由点求几何要素</translation>
    </message>
    <message>
        <source>Lines, planes, circles, spheres, cylinders and cones through measured points by orthogonal least squares: place, direction, diameter and form deviation with the full covariance of the points.</source>
        <translation>用正交最小二乘法求通过实测点的直线、平面、圆、球、圆柱和圆锥：位置、方向、直径和形状偏差，采用各点的全协方差。</translation>
    </message>
    <message>
        <source>Points weigh alike, whatever their uncertainty, as in least-squares features of coordinate measurement; their covariance goes into the uncertainty of the results.</source>
        <translation>各点的权相同，与其不确定度无关，与坐标测量中的最小二乘要素一样；各点的协方差计入结果的不确定度。</translation>
    </message>
    <message>
        <source>A circle in space is fitted in two steps, as NIST&apos;s: the plane by all points, then the circle by the points projected onto it.</source>
        <translation>空间中的圆分两步拟合，与 NIST 的做法相同：先由所有点得到平面，再由投影到该平面上的点得到圆。</translation>
    </message>
    <message>
        <source>The direction has its largest component positive; that of a cone leads from the apex into it. &quot;Reversed&quot; turns it. Trials keep the sign of the estimates.</source>
        <translation>方向的最大分量为正；圆锥的方向由顶点指向圆锥内部。“反向”使其反转。各次试验保持估计值的符号。</translation>
    </message>
    <message>
        <source>The place of a plane or line is the mean of the points; of a cylinder or cone it is the point of the axis next to that mean, so the uncertainty along the axis is that of the mean.</source>
        <translation>平面或直线的位置为各点的平均值；圆柱或圆锥的位置为轴线上最接近该平均值的点，因此沿轴线的不确定度为该平均值的不确定度。</translation>
    </message>
    <message>
        <source>Every trial of a Monte Carlo run fits its points anew. Form deviations of trials are larger than that of the points as measured, for uncertainty adds to what is form.</source>
        <translation>蒙特卡洛运行的每次试验都重新拟合其各点。试验的形状偏差大于实测点的形状偏差，因为不确定度叠加在形状之上。</translation>
    </message>
    <message>
        <source>Features</source>
        <translation>要素</translation>
    </message>
    <message>
        <source>Forms that are fitted to points by orthogonal least squares.</source>
        <translation>用正交最小二乘法拟合到各点的形状。</translation>
    </message>
    <message>
        <source>Name of the feature, unique.</source>
        <translation>要素的名称，须唯一。</translation>
    </message>
    <message>
        <source>form</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>What is fitted to its points. In the xy-plane z does not matter.</source>
        <translation>对其各点拟合什么。在 xy 平面内时 z 无关紧要。</translation>
    </message>
    <message>
        <source>line</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>圆</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>球</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>圆柱</translation>
    </message>
    <message>
        <source>cone</source>
        <translation>圆锥</translation>
    </message>
    <message>
        <source>line in the xy-plane</source>
        <translation>xy 平面内的直线</translation>
    </message>
    <message>
        <source>circle in the xy-plane</source>
        <translation>xy 平面内的圆</translation>
    </message>
    <message>
        <source>reversed</source>
        <translation>反向</translation>
    </message>
    <message>
        <source>The direction is stated with the other sign: the largest component of the direction is negative, that of a cone leads to its apex.</source>
        <translation>方向以相反的符号给出：方向的最大分量为负，圆锥的方向指向其顶点。</translation>
    </message>
    <message>
        <source>Form deviations</source>
        <translation>形状偏差</translation>
    </message>
    <message>
        <source>Peak to valley and root mean square of the points&apos; deviations from their feature are results too.</source>
        <translation>各点相对其要素的偏差的峰谷值和均方根也作为结果。</translation>
    </message>
    <message>
        <source>Measured points of the features, typed, pasted or from a CSV file.</source>
        <translation>要素的实测点，手工输入、粘贴或来自 CSV 文件。</translation>
    </message>
    <message>
        <source>feature</source>
        <translation>要素</translation>
    </message>
    <message>
        <source>The feature that it is a point of; empty: that of the row above, of the first row the first.</source>
        <translation>该点所属的要素；留空：与上一行相同，第一行为第一个要素。</translation>
    </message>
    <message>
        <source>Name of the point, unique in its feature; empty: its number. Of points that an analysis measured the name there.</source>
        <translation>点的名称，在其要素内须唯一；留空：其编号。若为某分析所测的点，则为其在该分析中的名称。</translation>
    </message>
    <message>
        <source>Measured coordinate x; empty where the point is a feature of an analysis, and z in the xy-plane.</source>
        <translation>实测坐标 x；若该点是某分析的要素，则留空；在 xy 平面内 z 也留空。</translation>
    </message>
    <message>
        <source>Measured coordinate y; empty where the point is a feature of an analysis, and z in the xy-plane.</source>
        <translation>实测坐标 y；若该点是某分析的要素，则留空；在 xy 平面内 z 也留空。</translation>
    </message>
    <message>
        <source>Measured coordinate z; empty where the point is a feature of an analysis, and z in the xy-plane.</source>
        <translation>实测坐标 z；若该点是某分析的要素，则留空；在 xy 平面内也留空。</translation>
    </message>
    <message>
        <source>Standard uncertainty of coordinate x of this point; empty: as for all points.</source>
        <translation>该点坐标 x 的标准不确定度；留空：与所有点相同。</translation>
    </message>
    <message>
        <source>Standard uncertainty of coordinate y of this point; empty: as for all points.</source>
        <translation>该点坐标 y 的标准不确定度；留空：与所有点相同。</translation>
    </message>
    <message>
        <source>Standard uncertainty of coordinate z of this point; empty: as for all points.</source>
        <translation>该点坐标 z 的标准不确定度；留空：与所有点相同。</translation>
    </message>
    <message>
        <source>Correlation coefficient of the point&apos;s own x and y.</source>
        <translation>该点自身 x 与 y 的相关系数。</translation>
    </message>
    <message>
        <source>Correlation coefficient of the point&apos;s own x and z.</source>
        <translation>该点自身 x 与 z 的相关系数。</translation>
    </message>
    <message>
        <source>Correlation coefficient of the point&apos;s own y and z.</source>
        <translation>该点自身 y 与 z 的相关系数。</translation>
    </message>
    <message>
        <source>Typed, from the scatter of the points about their feature, or of what measured them: an instrument of the project, or an analysis whose results are points.</source>
        <translation>手工输入，由各点相对其要素的分散性得到，或取自测量这些点的对象：项目中的仪器，或以点为结果的分析。</translation>
    </message>
    <message>
        <source>from the scatter about the feature</source>
        <translation>由相对要素的分散性得到</translation>
    </message>
    <message>
        <source>an instrument or an analysis</source>
        <translation>仪器或分析</translation>
    </message>
    <message>
        <source>Of every coordinate of every point that states none, independent of all others.</source>
        <translation>适用于未给出不确定度的每个点的每个坐标，彼此独立。</translation>
    </message>
    <message>
        <source>Standard uncertainty of a deviation along x that all points share beside their own: where the instrument stands.</source>
        <translation>所有点除各自偏差外共有的沿 x 偏差的标准不确定度：仪器的位置。</translation>
    </message>
    <message>
        <source>Standard uncertainty of a deviation along y that all points share beside their own: where the instrument stands.</source>
        <translation>所有点除各自偏差外共有的沿 y 偏差的标准不确定度：仪器的位置。</translation>
    </message>
    <message>
        <source>Common u of z</source>
        <translation>z 的共同 u</translation>
    </message>
    <message>
        <source>Standard uncertainty of a deviation along z that all points share beside their own: where the instrument stands.</source>
        <translation>所有点除各自偏差外共有的沿 z 偏差的标准不确定度：仪器的位置。</translation>
    </message>
    <message>
        <source>Measured by</source>
        <translation>测量者</translation>
    </message>
    <message>
        <source>An instrument that stands somewhere, whose scale and station are alike for all points; or an analysis, whose points are known by their names and are evaluated with this one in every trial.</source>
        <translation>设于某处的仪器，其尺度和测站对所有点相同；或一个分析，其各点由名称识别，并在每次试验中与本分析一起评定。</translation>
    </message>
    <message>
        <source>Relation of features</source>
        <translation>要素之间的关系</translation>
    </message>
    <message>
        <source>Distances, angles, intersections and frames of features and points that other analyses measured, or that are typed.</source>
        <translation>要素和点之间的距离、角度、交点、交线以及由其建立的坐标系；要素和点由其他分析测得，或由手工输入。</translation>
    </message>
    <message>
        <source>Features are evaluated with the relations as one model in every trial: what two features have in common, as the station of their instrument, cancels where it cancels.</source>
        <translation>在每次试验中，要素与关系作为一个模型一起评定：两个要素的共有部分（如其仪器的测站）在可抵消之处相互抵消。</translation>
    </message>
    <message>
        <source>A direction is that of the feature, with its sign: of a plane the normal. The angle of a line and a plane is 90° less the angle of their directions.</source>
        <translation>方向为要素的方向，带符号：平面为其法线。直线与平面的夹角为 90° 减去两者方向的夹角。</translation>
    </message>
    <message>
        <source>The angle of nearly parallel directions is never negative, so its estimate is too large where its uncertainty is not small; tilts have signs and no such bias.</source>
        <translation>接近平行的两方向的夹角永不为负，因此当其不确定度不小时，其估计值偏大；倾斜带符号，没有这种偏移。</translation>
    </message>
    <message>
        <source>A frame&apos;s angles are those of Z-Y-X: R = Rz(γ) Ry(β) Rx(α).</source>
        <translation>坐标系的角度按 Z-Y-X：R = Rz(γ) Ry(β) Rx(α)。</translation>
    </message>
    <message>
        <source>Results of analyses (features, targets, frames&apos; origins), or typed ones, such as the direction of gravity.</source>
        <translation>分析的结果（要素、目标点、坐标系原点），或手工输入的结果，如重力方向。</translation>
    </message>
    <message>
        <source>Name of the feature here, unique.</source>
        <translation>要素在此处的名称，须唯一。</translation>
    </message>
    <message>
        <source>The analysis whose result it is; empty: place and direction are typed.</source>
        <translation>结果所属的分析；留空：位置和方向由手工输入。</translation>
    </message>
    <message>
        <source>Its name in that analysis: a feature, a target, &quot;apex of C1&quot;; empty: the name here.</source>
        <translation>其在该分析中的名称：要素、目标点、&quot;apex of C1&quot;；留空：此处的名称。</translation>
    </message>
    <message>
        <source>Typed coordinate x; empty: 0.</source>
        <translation>输入的坐标 x；留空：0。</translation>
    </message>
    <message>
        <source>Typed coordinate y; empty: 0.</source>
        <translation>输入的坐标 y；留空：0。</translation>
    </message>
    <message>
        <source>Typed coordinate z; empty: 0.</source>
        <translation>输入的坐标 z；留空：0。</translation>
    </message>
    <message>
        <source>Typed direction, component x, of any length; empty: it has none.</source>
        <translation>输入的方向，分量 x，长度任意；留空：没有方向。</translation>
    </message>
    <message>
        <source>Typed direction, component y, of any length; empty: it has none.</source>
        <translation>输入的方向，分量 y，长度任意；留空：没有方向。</translation>
    </message>
    <message>
        <source>Typed direction, component z, of any length; empty: it has none.</source>
        <translation>输入的方向，分量 z，长度任意；留空：没有方向。</translation>
    </message>
    <message>
        <source>Standard uncertainty of each typed coordinate; empty: none.</source>
        <translation>每个输入坐标的标准不确定度；留空：无。</translation>
    </message>
    <message>
        <source>Standard uncertainty of the typed direction, of two tilts across it; empty: none.</source>
        <translation>输入方向的标准不确定度，即垂直于该方向的两个倾斜的标准不确定度；留空：无。</translation>
    </message>
    <message>
        <source>Relations</source>
        <translation>关系</translation>
    </message>
    <message>
        <source>Distances, angles, intersections and frames of the features.</source>
        <translation>要素的距离、角度、交点、交线和坐标系。</translation>
    </message>
    <message>
        <source>Name of the result, unique.</source>
        <translation>结果的名称，须唯一。</translation>
    </message>
    <message>
        <source>relation</source>
        <translation>关系</translation>
    </message>
    <message>
        <source>What is wanted of the features.</source>
        <translation>由要素求什么。</translation>
    </message>
    <message>
        <source>distance of two places</source>
        <translation>两个位置的距离</translation>
    </message>
    <message>
        <source>distance of a place from a plane</source>
        <translation>位置到平面的距离</translation>
    </message>
    <message>
        <source>distance of a place from a line</source>
        <translation>位置到直线的距离</translation>
    </message>
    <message>
        <source>distance of two lines</source>
        <translation>两直线的距离</translation>
    </message>
    <message>
        <source>angle of two directions</source>
        <translation>两方向的夹角</translation>
    </message>
    <message>
        <source>tilts of a direction against another</source>
        <translation>一个方向相对另一方向的倾斜</translation>
    </message>
    <message>
        <source>middle of two places</source>
        <translation>两个位置的中点</translation>
    </message>
    <message>
        <source>foot of a place on a plane</source>
        <translation>位置在平面上的垂足</translation>
    </message>
    <message>
        <source>foot of a place on a line</source>
        <translation>位置在直线上的垂足</translation>
    </message>
    <message>
        <source>intersection of a line and a plane</source>
        <translation>直线与平面的交点</translation>
    </message>
    <message>
        <source>intersection of two lines</source>
        <translation>两直线的交点</translation>
    </message>
    <message>
        <source>intersection of three planes</source>
        <translation>三平面的交点</translation>
    </message>
    <message>
        <source>line of two planes</source>
        <translation>两平面的交线</translation>
    </message>
    <message>
        <source>frame: origin, z, x</source>
        <translation>坐标系：原点、z、x</translation>
    </message>
    <message>
        <source>frame: origin on a plane, its normal z, x</source>
        <translation>坐标系：平面上的原点、其法线 z、x</translation>
    </message>
    <message>
        <source>A feature: the place, line or plane that is asked about; of a frame its origin.</source>
        <translation>一个要素：所求的位置、直线或平面；对坐标系为其原点。</translation>
    </message>
    <message>
        <source>Another one: what it is related to; of a frame the direction of z.</source>
        <translation>另一个要素：与之相关的要素；对坐标系为 z 的方向。</translation>
    </message>
    <message>
        <source>third</source>
        <translation>第三</translation>
    </message>
    <message>
        <source>A third one: the third plane; of a frame and of tilts what x points to, along its direction if it has one, else towards its place.</source>
        <translation>第三个要素：第三个平面；对坐标系和倾斜为 x 所指的要素：若其有方向则沿其方向，否则指向其位置。</translation>
    </message>
    <message>
        <source>Distance meter on a baseline</source>
        <translation>基线上的测距仪</translation>
    </message>
    <message>
        <source>Zero offset and standard deviation of a distance meter from distances between all pairs of pillars on a line, with their uncertainties, and the statistical tests of ISO 17123-4; its scale, where lengths of the baseline are known.</source>
        <translation>由一条直线上所有观测墩两两之间的距离求测距仪的零点偏移和标准偏差及其不确定度，并按 ISO 17123-4 进行统计检验；若基线的长度已知，还求其尺度。</translation>
    </message>
    <message>
        <source>All pairs of n pillars, read once each: the cofactor of the zero offset is 6/((n − 1)(n − 2)) whatever the lengths, and there are n (n − 1)/2 − n degrees of freedom.</source>
        <translation>n 个观测墩两两组合，各读一次：无论长度如何，零点偏移的协因数为 6/((n − 1)(n − 2))，自由度为 n (n − 1)/2 − n。</translation>
    </message>
    <message>
        <source>Limits of the tests are quantiles of chi-squared, F and t for the degrees of freedom that the readings have, not figures of a table.</source>
        <translation>检验的界限为读数所具有的自由度下的卡方、F 和 t 分位数，而不是表格中的数值。</translation>
    </message>
    <message>
        <source>Any set of readings that tells the unknowns is adjusted, also one with pairs left out or repeated; readings that repeat without the instrument set up anew agree better than the instrument does.</source>
        <translation>凡能确定未知数的任何一组读数均可平差，包括缺少某些组合或有重复的；未重新安置仪器的重复读数之间的一致性好于仪器本身。</translation>
    </message>
    <message>
        <source>Distances count with equal weights.</source>
        <translation>距离按等权计。</translation>
    </message>
    <message>
        <source>Distances between pillars that stand on a line, best of all pairs, each with the instrument set up anew.</source>
        <translation>同一直线上各观测墩之间的距离，最好为所有两两组合，每次均重新安置仪器。</translation>
    </message>
    <message>
        <source>Pillar of the instrument.</source>
        <translation>仪器所在的观测墩。</translation>
    </message>
    <message>
        <source>Pillar of the reflector.</source>
        <translation>反射器所在的观测墩。</translation>
    </message>
    <message>
        <source>As read, with the correction for the atmosphere and without one for the zero.</source>
        <translation>读数值，已作大气改正，未作零点改正。</translation>
    </message>
    <message>
        <source>Of the reflector above the instrument, where the distance is a slope distance; empty: it is horizontal.</source>
        <translation>反射器高于仪器的高差，用于距离为斜距的情形；留空：距离为平距。</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>检测</translation>
    </message>
    <message>
        <source>σ, stated or wanted</source>
        <translation>σ，给出的或所需的</translation>
    </message>
    <message>
        <source>Standard deviation of one distance that test a holds s against: of the maker, or what a job needs. Empty: no test a.</source>
        <translation>检验 a 用以与 s 比较的单次距离的标准偏差：制造商的值，或任务所需的值。留空：不作检验 a。</translation>
    </message>
    <message>
        <source>s of another campaign</source>
        <translation>另一次测试的 s</translation>
    </message>
    <message>
        <source>Experimental standard deviation that test b compares s with: of another instrument or day. Empty: no test b.</source>
        <translation>检验 b 用以与 s 比较的实验标准偏差：另一台仪器或另一天的值。留空：不作检验 b。</translation>
    </message>
    <message>
        <source>Its degrees of freedom</source>
        <translation>其自由度</translation>
    </message>
    <message>
        <source>Of the s of the other campaign: 14 for all pairs of seven pillars.</source>
        <translation>另一次测试的 s 的自由度：七个观测墩的所有两两组合时为 14。</translation>
    </message>
    <message>
        <source>Probability of the tests</source>
        <translation>检验的概率</translation>
    </message>
    <message>
        <source>1 − α: an instrument that is as good as stated passes a test with this probability.</source>
        <translation>1 − α：与给出值同样好的仪器以此概率通过检验。</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>尺度</translation>
    </message>
    <message>
        <source>Scale correction</source>
        <translation>尺度改正</translation>
    </message>
    <message>
        <source>Readings alone say nothing of it: it needs lengths of the baseline that are known better.</source>
        <translation>仅凭读数无法得知：需要更准确已知的基线长度。</translation>
    </message>
    <message>
        <source>not asked for</source>
        <translation>不求</translation>
    </message>
    <message>
        <source>by reference lengths</source>
        <translation>由参考长度</translation>
    </message>
    <message>
        <source>Reference lengths</source>
        <translation>参考长度</translation>
    </message>
    <message>
        <source>Horizontal lengths from the pillar where the line begins, of a certificate.</source>
        <translation>从基线起点观测墩起算的水平长度，取自证书。</translation>
    </message>
    <message>
        <source>pillar</source>
        <translation>观测墩</translation>
    </message>
    <message>
        <source>As in the readings.</source>
        <translation>与读数中相同。</translation>
    </message>
    <message>
        <source>From the pillar where the line begins.</source>
        <translation>从基线起点观测墩起算。</translation>
    </message>
    <message>
        <source>Standard uncertainty of this length alone, beside what all share; empty: none.</source>
        <translation>仅该长度的标准不确定度，不含所有长度共有的部分；留空：无。</translation>
    </message>
    <message>
        <source>u of the baseline&apos;s scale</source>
        <translation>基线尺度的 u</translation>
    </message>
    <message>
        <source>Relative standard uncertainty that all reference lengths share.</source>
        <translation>所有参考长度共有的相对标准不确定度。</translation>
    </message>
    <message>
        <source>u of the correction for the atmosphere</source>
        <translation>大气改正的 u</translation>
    </message>
    <message>
        <source>Relative standard uncertainty that all readings share: 1 °C or 3.5 hPa are about 1 ppm.</source>
        <translation>所有读数共有的相对标准不确定度：1 °C 或 3.5 hPa 约为 1 ppm。</translation>
    </message>
    <message>
        <source>Planes, circles, axes and balls through measured points, with form deviations.</source>
        <translation>通过实测点的平面、圆、轴线和球，含形状偏差。</translation>
    </message>
    <message>
        <source>Frame, distances and angles of features</source>
        <translation>要素的坐标系、距离和角度</translation>
    </message>
    <message>
        <source>A frame as shops make it of a face, a bore and a hole, and where other features are from it.</source>
        <translation>按车间的做法由一个端面、一个中心孔和一个销孔建立的坐标系，以及其他要素在其中的位置。</translation>
    </message>
    <message>
        <source>Zero offset and standard deviation of a distance meter, with the tests of ISO 17123-4.</source>
        <translation>测距仪的零点偏移和标准偏差，含 ISO 17123-4 的检验。</translation>
    </message>
    <message>
        <source>Total station on a baseline of seven pillars</source>
        <translation>七墩基线上的全站仪</translation>
    </message>
    <message>
        <source>The distance meter of a total station, tested after ISO 17123-4 with distances between all pairs of seven pillars.</source>
        <translation>全站仪的测距仪，按 ISO 17123-4 用七个观测墩两两之间的距离进行检验。</translation>
    </message>
    <message>
        <source>Flange and tool of a robot, from measured points</source>
        <translation>由实测点求机器人的法兰和工具</translation>
    </message>
    <message>
        <source>A laser tracker probed the flange of a robot: its face, its bore, a dowel hole, the shank of a tool and the ball at its tip.</source>
        <translation>激光跟踪仪探测了机器人的法兰：其端面、中心孔、一个销孔、工具的柄部和工具尖端的球。</translation>
    </message>
    <message>
        <source>Form deviations of a turned part</source>
        <translation>车削件的形状偏差</translation>
    </message>
    <message>
        <source>A coordinate measuring machine probed a seat, a taper, a face and a groove.</source>
        <translation>坐标测量机探测了一个配合面、一个锥面、一个端面和一个槽。</translation>
    </message>
    <message>
        <source>%1, point %2, coordinate %3</source>
        <translation>%1，点 %2，坐标 %3</translation>
    </message>
    <message>
        <source>common deviation of all points along %1</source>
        <translation>所有点沿 %1 的共同偏差</translation>
    </message>
    <message>
        <source>scatter of the points of %1</source>
        <translation>%1 的点的分散性</translation>
    </message>
    <message>
        <source>residuals of %1 points about %2</source>
        <translation>%1 个点相对 %2 的残差</translation>
    </message>
    <message>
        <source>an instrument measures points in space; &apos;%1&apos; lies in the xy-plane: state the uncertainty of its points</source>
        <translation>仪器测量空间中的点；&apos;%1&apos; 在 xy 平面内：请给出其点的不确定度</translation>
    </message>
    <message>
        <source>orthogonal distances of the points from the feature</source>
        <translation>点到要素的正交距离</translation>
    </message>
    <message>
        <source>circle in its plane, cylinder</source>
        <translation>所在平面内的圆、圆柱</translation>
    </message>
    <message>
        <source>cone, half angle φ</source>
        <translation>圆锥，半角 φ</translation>
    </message>
    <message>
        <source>form deviations of m points</source>
        <translation>m 个点的形状偏差</translation>
    </message>
    <message>
        <source>two features are called &apos;%1&apos;</source>
        <translation>有两个要素名为 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>%1 has no feature called &apos;%2&apos;</source>
        <translation>%1 没有名为 &apos;%2&apos; 的要素</translation>
    </message>
    <message>
        <source>%1 has no value</source>
        <translation>%1 没有值</translation>
    </message>
    <message>
        <source>the direction of &apos;%1&apos; is zero</source>
        <translation>&apos;%1&apos; 的方向为零</translation>
    </message>
    <message>
        <source>typed coordinate</source>
        <translation>输入的坐标</translation>
    </message>
    <message>
        <source>tilt of the typed direction</source>
        <translation>输入方向的倾斜</translation>
    </message>
    <message>
        <source>%1, direction along %2</source>
        <translation>%1，沿 %2 的方向</translation>
    </message>
    <message>
        <source>two relations are called &apos;%1&apos;</source>
        <translation>有两个关系名为 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; takes two features; leave the third empty</source>
        <translation>&apos;%1&apos; 取两个要素；第三个请留空</translation>
    </message>
    <message>
        <source>&apos;%1&apos; needs three features</source>
        <translation>&apos;%1&apos; 需要三个要素</translation>
    </message>
    <message>
        <source>there is no feature &apos;%1&apos;</source>
        <translation>没有要素 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no direction, which &apos;%2&apos; needs</source>
        <translation>&apos;%2&apos; 需要方向，而 &apos;%1&apos; 没有方向</translation>
    </message>
    <message>
        <source>%1, distance</source>
        <translation>%1，距离</translation>
    </message>
    <message>
        <source>%1, angle</source>
        <translation>%1，角度</translation>
    </message>
    <message>
        <source>%1, tilt towards x</source>
        <translation>%1，向 x 的倾斜</translation>
    </message>
    <message>
        <source>%1, tilt towards y</source>
        <translation>%1，向 y 的倾斜</translation>
    </message>
    <message>
        <source>%1, rotation about %2</source>
        <translation>%1，绕 %2 的旋转</translation>
    </message>
    <message>
        <source>the two places are the same</source>
        <translation>两个位置相同</translation>
    </message>
    <message>
        <source>the place is on the line</source>
        <translation>该位置在直线上</translation>
    </message>
    <message>
        <source>the two are parallel</source>
        <translation>两者平行</translation>
    </message>
    <message>
        <source>the directions are parallel: ask for tilts, which have a sign</source>
        <translation>两方向平行：请改求带符号的倾斜</translation>
    </message>
    <message>
        <source>the line is parallel to the plane</source>
        <translation>直线与平面平行</translation>
    </message>
    <message>
        <source>the three planes have no common point</source>
        <translation>三个平面没有公共点</translation>
    </message>
    <message>
        <source>x and z are parallel</source>
        <translation>x 与 z 平行</translation>
    </message>
    <message>
        <source>&apos;%1&apos;: %2</source>
        <translation>&apos;%1&apos;：%2</translation>
    </message>
    <message>
        <source>elementary geometry; p places, n unit directions of the first, second, third</source>
        <translation>初等几何；p 为位置，n 为第一、第二、第三个要素的单位方向</translation>
    </message>
    <message>
        <source>from a plane; from a line the length across n₂</source>
        <translation>到平面；到直线时为垂直于 n₂ 的长度</translation>
    </message>
    <message>
        <source>between lines</source>
        <translation>两直线之间</translation>
    </message>
    <message>
        <source>tilts, z = n₂</source>
        <translation>倾斜，z = n₂</translation>
    </message>
    <message>
        <source>frames, v of the third</source>
        <translation>坐标系，v 属于第三个要素</translation>
    </message>
    <message>
        <source>centre of %1, %2</source>
        <translation>%1 的中心，%2</translation>
    </message>
    <message>
        <source>point on the axis of %1, %2</source>
        <translation>%1 轴线上的点，%2</translation>
    </message>
    <message>
        <source>place of %1, %2</source>
        <translation>%1 的位置，%2</translation>
    </message>
    <message>
        <source>point on %1, %2</source>
        <translation>%1 上的点，%2</translation>
    </message>
    <message>
        <source>normal of %1, %2</source>
        <translation>%1 的法线，%2</translation>
    </message>
    <message>
        <source>direction of the axis of %1, %2</source>
        <translation>%1 的轴线方向，%2</translation>
    </message>
    <message>
        <source>direction of %1, %2</source>
        <translation>%1 的方向，%2</translation>
    </message>
    <message>
        <source>flatness deviation of %1, peak to valley</source>
        <translation>%1 的平面度偏差，峰谷值</translation>
    </message>
    <message>
        <source>straightness deviation of %1, peak to valley</source>
        <translation>%1 的直线度偏差，峰谷值</translation>
    </message>
    <message>
        <source>roundness deviation of %1, peak to valley</source>
        <translation>%1 的圆度偏差，峰谷值</translation>
    </message>
    <message>
        <source>cylindricity deviation of %1, peak to valley</source>
        <translation>%1 的圆柱度偏差，峰谷值</translation>
    </message>
    <message>
        <source>form deviation of %1, peak to valley</source>
        <translation>%1 的形状偏差，峰谷值</translation>
    </message>
    <message>
        <source>diameter of %1 at its point</source>
        <translation>%1 在其点处的直径</translation>
    </message>
    <message>
        <source>diameter of %1</source>
        <translation>%1 的直径</translation>
    </message>
    <message>
        <source>angle of %1</source>
        <translation>%1 的角度</translation>
    </message>
    <message>
        <source>form deviation of %1, root mean square</source>
        <translation>%1 的形状偏差，均方根</translation>
    </message>
    <message>
        <source>apex of %1, %2</source>
        <translation>%1 的顶点，%2</translation>
    </message>
    <message>
        <source>two points of &apos;%1&apos; are called &apos;%2&apos;</source>
        <translation>&apos;%1&apos; 有两个点名为 &apos;%2&apos;</translation>
    </message>
    <message>
        <source>%1 has no point called &apos;%2&apos;</source>
        <translation>%1 没有名为 &apos;%2&apos; 的点</translation>
    </message>
    <message>
        <source>point &apos;%1&apos; has no coordinate %2</source>
        <translation>点 &apos;%1&apos; 没有坐标 %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has %2 points; a %3 needs %4 or more</source>
        <translation>&apos;%1&apos; 有 %2 个点；%3需要 %4 个或更多</translation>
    </message>
    <message>
        <source>the %1 points of &apos;%2&apos; do not scatter: with so few the form goes through all of them; add points, or state their uncertainty</source>
        <translation>&apos;%2&apos; 的 %1 个点没有分散性：点数如此少时，拟合的形状通过所有点；请增加点，或给出其不确定度</translation>
    </message>
    <message>
        <source>the points of &apos;%1&apos;: %2</source>
        <translation>&apos;%1&apos; 的点：%2</translation>
    </message>
    <message>
        <source>the points of &apos;%1&apos; lie exactly on it: their scatter says nothing of their uncertainty</source>
        <translation>&apos;%1&apos; 的点恰好都在其上：其分散性不能说明其不确定度</translation>
    </message>
    <message>
        <source>they are so nearly flat or straight that they determine no radius</source>
        <translation>它们过于接近平面或直线，无法确定半径</translation>
    </message>
    <message>
        <source>no %1 that fits them was found</source>
        <translation>找不到与之吻合的%1</translation>
    </message>
    <message>
        <source>all of them are the same</source>
        <translation>它们全部相同</translation>
    </message>
    <message>
        <source>they are too far from each other</source>
        <translation>它们彼此相距过远</translation>
    </message>
    <message>
        <source>they lie on a straight line</source>
        <translation>它们在一条直线上</translation>
    </message>
    <message>
        <source>they lie on a plane</source>
        <translation>它们在一个平面上</translation>
    </message>
    <message>
        <source>How well the points determine the features</source>
        <translation>各点对要素的确定程度</translation>
    </message>
    <message>
        <source>at a standard deviation of 1 mm</source>
        <translation>标准偏差为 1 mm 时</translation>
    </message>
    <message>
        <source>at the scatter of the points</source>
        <translation>按各点的分散性</translation>
    </message>
    <message>
        <source>Standard uncertainties that independent deviations of all coordinates alike would give, first with a standard deviation of 1 mm: they depend on where the points are alone. Places and tilts are along the directions in which they are largest and smallest.</source>
        <translation>所有坐标独立且同等的偏差所给出的标准不确定度，首先按标准偏差 1 mm：它们只取决于点的位置。位置和倾斜取其最大和最小的方向。</translation>
    </message>
    <message>
        <source>place across the axis</source>
        <translation>垂直于轴线的位置</translation>
    </message>
    <message>
        <source>place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>offset across the line</source>
        <translation>垂直于直线的偏移</translation>
    </message>
    <message>
        <source>offset along the normal</source>
        <translation>沿法线的偏移</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>直径</translation>
    </message>
    <message>
        <source>angle of the cone</source>
        <translation>圆锥的角度</translation>
    </message>
    <message>
        <source>correlation of diameter and centre along the middle of the arc</source>
        <translation>直径与沿圆弧中点方向的圆心的相关</translation>
    </message>
    <message>
        <source>angle to both sides of that middle within which the points are</source>
        <translation>各点所在范围：以该中点为准，两侧的角度</translation>
    </message>
    <message>
        <source>Features and the scatter of their points</source>
        <translation>要素及其点的分散性</translation>
    </message>
    <message>
        <source>largest deviation</source>
        <translation>最大偏差</translation>
    </message>
    <message>
        <source>s is the root of the sum of squares of the deviations over the degrees of freedom.</source>
        <translation>s 为偏差平方和除以自由度后的平方根。</translation>
    </message>
    <message>
        <source>Deviations of the points from their features</source>
        <translation>各点相对其要素的偏差</translation>
    </message>
    <message>
        <source>above the plane of the circle</source>
        <translation>高于圆所在平面</translation>
    </message>
    <message>
        <source>Positive outside of a circle, sphere, cylinder or cone and on the side of a plane to which its normal points; of a line in space the distance.</source>
        <translation>在圆、球、圆柱或圆锥外侧为正，在平面法线所指一侧为正；对空间中的直线为距离。</translation>
    </message>
    <message>
        <source>the points of &apos;%1&apos; are within %2° of the middle of their arc: its diameter has %3 times the standard uncertainty of a coordinate and correlates with the place of the centre by %4</source>
        <translation>&apos;%1&apos; 的点位于其圆弧中点两侧 %2° 以内：其直径的标准不确定度为坐标的 %3 倍，与圆心位置的相关系数为 %4</translation>
    </message>
    <message>
        <source>apex of %1</source>
        <translation>%1 的顶点</translation>
    </message>
    <message>
        <source>all pairs of pillars, ISO 17123-4</source>
        <translation>观测墩的所有两两组合，ISO 17123-4</translation>
    </message>
    <message>
        <source>N distances between n pillars; JCGM 100 H.3.2</source>
        <translation>n 个观测墩间的 N 个距离；JCGM 100 H.3.2</translation>
    </message>
    <message>
        <source>JCGM 100 E.4.3</source>
        <translation>JCGM 100 E.4.3</translation>
    </message>
    <message>
        <source>scale, by the reference lengths L_j</source>
        <translation>尺度，由参考长度 L_j 得到</translation>
    </message>
    <message>
        <source>scatter of the distances</source>
        <translation>距离的分散性</translation>
    </message>
    <message>
        <source>least squares, residuals of %1 distances</source>
        <translation>最小二乘，%1 个距离的残差</translation>
    </message>
    <message>
        <source>zero offset</source>
        <translation>零点偏移</translation>
    </message>
    <message>
        <source>place of pillar %1</source>
        <translation>观测墩 %1 的位置</translation>
    </message>
    <message>
        <source>standard deviation of one distance</source>
        <translation>单次距离的标准偏差</translation>
    </message>
    <message>
        <source>few degrees of freedom of s</source>
        <translation>s 的自由度过少</translation>
    </message>
    <message>
        <source>reference lengths and their conditions</source>
        <translation>参考长度及其条件</translation>
    </message>
    <message>
        <source>scale of the readings by the atmosphere</source>
        <translation>大气引起的读数尺度</translation>
    </message>
    <message>
        <source>correction for the atmosphere</source>
        <translation>大气改正</translation>
    </message>
    <message>
        <source>scale of the baseline</source>
        <translation>基线的尺度</translation>
    </message>
    <message>
        <source>reference length of pillar %1</source>
        <translation>观测墩 %1 的参考长度</translation>
    </message>
    <message>
        <source>reference length</source>
        <translation>参考长度</translation>
    </message>
    <message>
        <source>zero offset, added to a reading</source>
        <translation>零点偏移，加到读数上</translation>
    </message>
    <message>
        <source>scale correction, times a reading</source>
        <translation>尺度改正，乘以读数</translation>
    </message>
    <message>
        <source>the readings do not tell the zero offset from the lengths: some line of three pillars must be read whole and in parts</source>
        <translation>读数无法区分零点偏移与长度：必须有三个观测墩所成的直线，既整段读取又分段读取</translation>
    </message>
    <message>
        <source>a distance from pillar &apos;%1&apos; to itself</source>
        <translation>从观测墩 &apos;%1&apos; 到其自身的距离</translation>
    </message>
    <message>
        <source>the height difference in row %1 is not shorter than the slope distance</source>
        <translation>第 %1 行中的高差不小于斜距</translation>
    </message>
    <message>
        <source>a zero offset needs distances between three pillars or more</source>
        <translation>零点偏移需要三个或更多观测墩之间的距离</translation>
    </message>
    <message>
        <source>%1 distances for %2 lengths and the zero offset leave nothing that would tell the scatter: read more pairs of pillars</source>
        <translation>%1 个距离求 %2 个长度和零点偏移，没有余量可确定分散性：请读取更多的观测墩组合</translation>
    </message>
    <message>
        <source>the distances do not connect all pillars</source>
        <translation>各距离未把所有观测墩连接起来</translation>
    </message>
    <message>
        <source>pillar &apos;%1&apos; has two reference lengths</source>
        <translation>观测墩 &apos;%1&apos; 有两个参考长度</translation>
    </message>
    <message>
        <source>no reading is to or from pillar &apos;%1&apos;</source>
        <translation>没有读数以观测墩 &apos;%1&apos; 为起点或终点</translation>
    </message>
    <message>
        <source>reference lengths begin at pillar &apos;%1&apos;</source>
        <translation>参考长度从观测墩 &apos;%1&apos; 起算</translation>
    </message>
    <message>
        <source>a: s is not larger than the stated σ</source>
        <translation>a：s 不大于给出的 σ</translation>
    </message>
    <message>
        <source>b: s and the s of the other campaign are of one σ, s²/s²</source>
        <translation>b：s 与另一次测试的 s 属于同一 σ，s²/s²</translation>
    </message>
    <message>
        <source>c: the zero offset is not different from zero</source>
        <translation>c：零点偏移与零无差异</translation>
    </message>
    <message>
        <source>A zero offset is seen: add it to readings, or enter it in the instrument.</source>
        <translation>存在零点偏移：请将其加到读数上，或输入到仪器中。</translation>
    </message>
    <message>
        <source>pillars</source>
        <translation>观测墩</translation>
    </message>
    <message>
        <source>s of one distance</source>
        <translation>单次距离的 s</translation>
    </message>
    <message>
        <source>standard uncertainty of s</source>
        <translation>s 的标准不确定度</translation>
    </message>
    <message>
        <source>standard uncertainty of the zero offset</source>
        <translation>零点偏移的标准不确定度</translation>
    </message>
    <message>
        <source>cofactor of the zero offset</source>
        <translation>零点偏移的协因数</translation>
    </message>
    <message>
        <source>residual over its s</source>
        <translation>残差除以其 s</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>通过</translation>
    </message>
    <message>
        <source>not passed</source>
        <translation>未通过</translation>
    </message>
    <message>
        <source>line of the baseline</source>
        <translation>基线所在直线</translation>
    </message>
    <message>
        <source>baseline</source>
        <translation>基线</translation>
    </message>
    <message>
        <source>scatter</source>
        <translation>分散性</translation>
    </message>
    <message>
        <source>the name of the file says that it is a %1</source>
        <translation>文件名表明其为%1</translation>
    </message>
    <message>
        <source>the file does not say which form its points have: a %1 is fitted; choose another one in the table of features</source>
        <translation>文件没有说明其点属于哪种形状：按%1拟合；可在要素表中选择其他形状</translation>
    </message>
    <message>
        <source>the first line is not a number of points</source>
        <translation>第一行不是点数</translation>
    </message>
    <message>
        <source>x y z were expected, %1 columns found</source>
        <translation>应为 x y z，却有 %1 列</translation>
    </message>
    <message>
        <source>the first line announces %1 points, but there are %2</source>
        <translation>第一行声明有 %1 个点，实际有 %2 个</translation>
    </message>
    <message>
        <source>what stands behind the %1 points</source>
        <translation>%1 个点之后的内容</translation>
    </message>
    <message>
        <source>%1 points; their uncertainty is taken from their scatter about the form</source>
        <translation>%1 个点；其不确定度由各点相对形状的分散性得到</translation>
    </message>
    <message>
        <source>%1 points; state their uncertainty: the file says nothing of it</source>
        <translation>%1 个点；请给出其不确定度：文件中没有说明</translation>
    </message>
    <message>
        <source>List of coordinates (NIST .ds)</source>
        <translation>坐标列表 (NIST .ds)</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>结果表</translation>
    </message>
    <message>
        <source>Statistical tests</source>
        <translation>统计检验</translation>
    </message>
    <message>
        <source>test</source>
        <translation>检验</translation>
    </message>
    <message>
        <source>Lengths of the baseline</source>
        <translation>基线的长度</translation>
    </message>
    <message>
        <source>Readings and their residuals</source>
        <translation>读数及其残差</translation>
    </message>
    <message>
        <source>Residuals of the distances</source>
        <translation>距离的残差</translation>
    </message>
    <message>
        <source>−s</source>
        <translation>−s</translation>
    </message>
    <message>
        <source>Uncertainties of the points are used</source>
        <translation>点的不确定度的采用方式</translation>
    </message>
    <message>
        <source>As stated; or as the residuals of least-squares frames see them: stated ones times one common factor, or times the factor of each figure (variance components). Either has the degrees of freedom of its estimate. What all points share stays as stated.</source>
        <translation>按给出值；或按最小二乘坐标系的残差所见的值：给出值乘以一个共同的系数，或乘以每个指标各自的系数（方差分量）。后两者均具有其估计的自由度。所有点共有的部分保持给出值。</translation>
    </message>
    <message>
        <source>Zero, scale, refraction, index and collimation of an instrument are unknowns with or without a prior, which all of its readings share.</source>
        <translation>仪器的零点、尺度、折光、指标差和视准差为未知数，可有或没有先验，由其所有读数共有。</translation>
    </message>
    <message>
        <source>Map projections are not part of it: reduce the readings before. The curvature of the Earth counts in zenith angles where its radius is given.</source>
        <translation>不包括地图投影：请事先归算读数。在给出地球半径时，天顶距计及地球曲率。</translation>
    </message>
    <message>
        <source>Which instrument read it: readings of one kind by one instrument rest on one figure when stated uncertainties are held against the residuals, and share its figures.</source>
        <translation>由哪台仪器读取：将给出的不确定度与残差对照时，同一仪器的同类读数依据同一指标，并共有该仪器的各项数值。</translation>
    </message>
    <message>
        <source>A reading that is left out stays in the table, and is told among those left out.</source>
        <translation>略去的读数保留在表中，并列入略去项。</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>略去</translation>
    </message>
    <message>
        <source>Figures as seen in</source>
        <translation>所见指标取自</translation>
    </message>
    <message>
        <source>Another network, rounds of a total station say, whose residuals see what its readings are worth. Readings of the same kind and instrument get the standard uncertainty that it sees, with its degrees of freedom, and follow its readings; others stay as stated here.</source>
        <translation>另一个网，例如全站仪的各测回，其残差可看出读数的质量。同类读数和同一仪器取得该网所见的标准不确定度及其自由度，并随其读数变化；其他读数保持此处给出的值。</translation>
    </message>
    <message>
        <source>Figures of instruments</source>
        <translation>仪器的各项数值</translation>
    </message>
    <message>
        <source>What an instrument does to all of its readings alike, with what is known of it.</source>
        <translation>仪器对其所有读数的同样影响，以及对此已知的内容。</translation>
    </message>
    <message>
        <source>Name of the instrument, as in the column of the readings; empty: of all readings without one.</source>
        <translation>仪器的名称，与读数的列中相同；留空：没有仪器名称的所有读数。</translation>
    </message>
    <message>
        <source>zero of distances</source>
        <translation>距离的零点</translation>
    </message>
    <message>
        <source>refraction coefficient</source>
        <translation>折光系数</translation>
    </message>
    <message>
        <source>vertical index</source>
        <translation>竖盘指标差</translation>
    </message>
    <message>
        <source>knowledge</source>
        <translation>已知情况</translation>
    </message>
    <message>
        <source>Unknown: the readings tell it; stated with u: its value is one more reading, which all of the instrument&apos;s share; fixed without uncertainty.</source>
        <translation>未知：由读数确定；以 u 给出：其值作为又一个读数，由该仪器的所有读数共有；固定：没有不确定度。</translation>
    </message>
    <message>
        <source>The zero; 0 where it is empty.</source>
        <translation>零点；留空为 0。</translation>
    </message>
    <message>
        <source>Standard uncertainty of a stated zero.</source>
        <translation>给出的零点的标准不确定度。</translation>
    </message>
    <message>
        <source>The scale beyond 1, or the refraction coefficient.</source>
        <translation>尺度超出 1 的部分，或折光系数。</translation>
    </message>
    <message>
        <source>u of ratio</source>
        <translation>比值的 u</translation>
    </message>
    <message>
        <source>Standard uncertainty of a stated scale or refraction coefficient.</source>
        <translation>给出的尺度或折光系数的标准不确定度。</translation>
    </message>
    <message>
        <source>The index or collimation; 0 where it is empty.</source>
        <translation>指标差或视准差；留空为 0。</translation>
    </message>
    <message>
        <source>Standard uncertainty of a stated index or collimation.</source>
        <translation>给出的指标差或视准差的标准不确定度。</translation>
    </message>
    <message>
        <source>Radius of the Earth</source>
        <translation>地球半径</translation>
    </message>
    <message>
        <source>Where the curvature of the Earth counts in zenith angles; empty: it does not.</source>
        <translation>用于在天顶距中计及地球曲率；留空：不计及。</translation>
    </message>
    <message>
        <source>Refraction coefficient</source>
        <translation>折光系数</translation>
    </message>
    <message>
        <source>Of zenith angles, where the curvature of the Earth counts and no instrument states its own.</source>
        <translation>用于计及地球曲率且仪器没有给出自身折光系数时的天顶距。</translation>
    </message>
    <message>
        <source>What is left out</source>
        <translation>略去的内容</translation>
    </message>
    <message>
        <source>Gross readings beyond</source>
        <translation>粗差读数的界限</translation>
    </message>
    <message>
        <source>Readings that miss what the others agree on (a robust adjustment) by more, an angle at its target, are left out; empty: none.</source>
        <translation>读数与其他读数的一致结果（稳健平差）之差超过该值时略去，角度按其在目标点处的偏差计；留空：不略去。</translation>
    </message>
    <message>
        <source>Points that nothing tells</source>
        <translation>无法确定的点</translation>
    </message>
    <message>
        <source>They are refused, by name; or left out with their readings, and told.</source>
        <translation>按名称拒绝；或连同其读数一起略去并说明。</translation>
    </message>
    <message>
        <source>are refused</source>
        <translation>拒绝</translation>
    </message>
    <message>
        <source>are left out</source>
        <translation>略去</translation>
    </message>
    <message>
        <source>Outliers</source>
        <translation>离群值</translation>
    </message>
    <message>
        <source>All readings are kept, and the adjustment says which contradict the others; or the search begins robustly (Huber&apos;s weights), and readings with |w| beyond 3.29 are left out, each with its reason.</source>
        <translation>保留所有读数，平差指出哪些与其他读数矛盾；或搜索从稳健方法（Huber 权）开始，|w| 超过 3.29 的读数逐个略去并说明原因。</translation>
    </message>
    <message>
        <source>are kept</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>robust start, and left out</source>
        <translation>稳健起始，并略去</translation>
    </message>
    <message>
        <source>Uncertainties of the points</source>
        <translation>点的不确定度</translation>
    </message>
    <message>
        <source>As stated; or as the distances of the points from their circles see them: stated ones times one common factor, or times the factor of each figure (variance components). Either has the degrees of freedom of its estimate. What all points share stays as stated.</source>
        <translation>按给出值；或按各点到其圆的距离所见的值：给出值乘以一个共同的系数，或乘以每个指标各自的系数（方差分量）。后两者均具有其估计的自由度。所有点共有的部分保持给出值。</translation>
    </message>
    <message>
        <source>Uncertainties of points and readings</source>
        <translation>点和读数的不确定度</translation>
    </message>
    <message>
        <source>As stated; or as the residuals of this fit see them: stated ones times one common factor, or times the factor of each figure (variance components). Either has the degrees of freedom of its estimate. What all poses share stays as stated.</source>
        <translation>按给出值；或按本次拟合的残差所见的值：给出值乘以一个共同的系数，或乘以每个指标各自的系数（方差分量）。后两者均具有其估计的自由度。所有位姿共有的部分保持给出值。</translation>
    </message>
    <message>
        <source>Stated ones weigh the points and are used as they are; or they are used as the residuals see them: times one common factor, or times one of x and one of y. Either has the degrees of freedom of its estimate. What all points share stays as stated.</source>
        <translation>给出值用于各点的加权并照原样采用；或按残差所见的值采用：乘以一个共同的系数，或对 x 和 y 各乘以一个系数。后两者均具有其估计的自由度。所有点共有的部分保持给出值。</translation>
    </message>
    <message>
        <source>Accuracy and repeatability of poses</source>
        <translation>位姿的准确度和重复性</translation>
    </message>
    <message>
        <source>What ISO 9283 asks of a robot, from measured poses: AP and RP, distances, directions of approach, drift; with the uncertainty that few cycles and the instrument leave, and decisions about a maker&apos;s figures.</source>
        <translation>ISO 9283 对机器人的要求，由实测位姿得到：AP 和 RP、距离、接近方向、漂移；含较少循环次数和仪器所留下的不确定度，以及对制造商指标的判定。</translation>
    </message>
    <message>
        <source>RP of the standard comes out too small from few cycles: by 2 % from 30 and 7 % from 10, where the scatter is alike in all directions. The result is multiplied by what that is for the shape of the scatter seen; the table gives RP as the standard defines it beside it.</source>
        <translation>循环次数少时，标准的 RP 偏小：分散性在各方向相同时，30 次循环偏小 2 %，10 次偏小 7 %。结果乘以按所见分散性形状得到的修正；表中并列给出标准所定义的 RP。</translation>
    </message>
    <message>
        <source>Scatter is taken to be normal. The law of RP for the number of cycles and the shape of the scatter comes from up to 4,000 simulated campaigns, always the same ones.</source>
        <translation>分散性按正态处理。RP 随循环次数和分散性形状的分布由至多 4,000 个模拟测量系列得到，每次均为同样的系列。</translation>
    </message>
    <message>
        <source>Limits and numbers of cycles of the standard are not built in: what is held against a figure is what is entered. Formulas of directions, distances and drift are those in common use; hold them against the text of the standard before a sheet names it.</source>
        <translation>标准的界限和循环次数未内置：与指标比较的是所输入的值。方向、距离和漂移的公式是通用公式；在结果表上写明该标准之前，请与标准原文核对。</translation>
    </message>
    <message>
        <source>RP² is split between robot and instrument as if both scattered in one shape.</source>
        <translation>RP² 在机器人与仪器之间划分时，视两者的分散性形状相同。</translation>
    </message>
    <message>
        <source>Commanded poses</source>
        <translation>指令位姿</translation>
    </message>
    <message>
        <source>Where the robot was sent to.</source>
        <translation>机器人被指令到达的位置。</translation>
    </message>
    <message>
        <source>Name, unique: P1.</source>
        <translation>名称，须唯一：P1。</translation>
    </message>
    <message>
        <source>Commanded coordinate x in the base of the robot.</source>
        <translation>机器人基坐标系中的指令坐标 x。</translation>
    </message>
    <message>
        <source>Commanded coordinate y in the base of the robot.</source>
        <translation>机器人基坐标系中的指令坐标 y。</translation>
    </message>
    <message>
        <source>Commanded coordinate z in the base of the robot.</source>
        <translation>机器人基坐标系中的指令坐标 z。</translation>
    </message>
    <message>
        <source>Commanded angle of the orientation; empty: orientations are not evaluated.</source>
        <translation>姿态的指令角度；留空：不评定姿态。</translation>
    </message>
    <message>
        <source>Attained poses</source>
        <translation>实到位姿</translation>
    </message>
    <message>
        <source>A row for every cycle in the order of measurement, typed, pasted or from a CSV file. The coordinates are those of the robot&apos;s base.</source>
        <translation>按测量顺序每个循环一行，手工输入、粘贴或来自 CSV 文件。坐标在机器人的基坐标系中。</translation>
    </message>
    <message>
        <source>As in the commanded poses.</source>
        <translation>与指令位姿中相同。</translation>
    </message>
    <message>
        <source>From where the pose was approached, where there are several ways; empty: one for all.</source>
        <translation>有多种接近方式时，从何处接近该位姿；留空：全部为同一方式。</translation>
    </message>
    <message>
        <source>Of the series of cycles, where it is repeated to see a drift; empty: there is one series.</source>
        <translation>循环系列的编号，用于重复以观察漂移；留空：只有一个系列。</translation>
    </message>
    <message>
        <source>Attained coordinate x in the base of the robot.</source>
        <translation>机器人基坐标系中的实到坐标 x。</translation>
    </message>
    <message>
        <source>Attained coordinate y in the base of the robot.</source>
        <translation>机器人基坐标系中的实到坐标 y。</translation>
    </message>
    <message>
        <source>Attained coordinate z in the base of the robot.</source>
        <translation>机器人基坐标系中的实到坐标 z。</translation>
    </message>
    <message>
        <source>Attained angle of the orientation.</source>
        <translation>姿态的实到角度。</translation>
    </message>
    <message>
        <source>Pairs of poses whose distance is held against the commanded one, cycle by cycle.</source>
        <translation>位姿对，其距离逐个循环与指令距离比较。</translation>
    </message>
    <message>
        <source>A commanded pose.</source>
        <translation>一个指令位姿。</translation>
    </message>
    <message>
        <source>Another one, with as many cycles.</source>
        <translation>另一个指令位姿，循环次数相同。</translation>
    </message>
    <message>
        <source>u of a measured coordinate</source>
        <translation>实测坐标的 u</translation>
    </message>
    <message>
        <source>Standard uncertainty that all cycles of a pose share: of the instrument and of the robot&apos;s base in its frame. It is part of u(AP), not of RP.</source>
        <translation>同一位姿的所有循环共有的标准不确定度：来自仪器以及机器人基座在仪器坐标系中的位置。它计入 u(AP)，不计入 RP。</translation>
    </message>
    <message>
        <source>Scatter of the instrument</source>
        <translation>仪器的分散性</translation>
    </message>
    <message>
        <source>What the instrument scatters by itself is part of RP. Where it is known, RP² less its RP² is that of the robot, if both scatter alike in all directions.</source>
        <translation>仪器自身的分散性是 RP 的一部分。若其已知，且两者在各方向上分散性相同，则 RP² 减去仪器的 RP² 即为机器人的。</translation>
    </message>
    <message>
        <source>not taken out</source>
        <translation>不扣除</translation>
    </message>
    <message>
        <source>its RP from a fixed target</source>
        <translation>其对固定目标的 RP</translation>
    </message>
    <message>
        <source>readings of a fixed target</source>
        <translation>固定目标的读数</translation>
    </message>
    <message>
        <source>RP of the instrument alone</source>
        <translation>仅仪器的 RP</translation>
    </message>
    <message>
        <source>l̄ + 3 s of readings of a fixed target, as measured in the cell.</source>
        <translation>固定目标读数的 l̄ + 3 s，在工作单元内测得。</translation>
    </message>
    <message>
        <source>Its readings</source>
        <translation>其读数个数</translation>
    </message>
    <message>
        <source>Number of readings that it is taken from: so well is it known.</source>
        <translation>得出该值的读数个数：决定其已知程度。</translation>
    </message>
    <message>
        <source>Readings of a fixed target</source>
        <translation>固定目标的读数</translation>
    </message>
    <message>
        <source>Coordinates of a target that does not move, read as the poses were.</source>
        <translation>不动目标的坐标，读取方式与位姿相同。</translation>
    </message>
    <message>
        <source>Read coordinate x.</source>
        <translation>读取的坐标 x。</translation>
    </message>
    <message>
        <source>Read coordinate y.</source>
        <translation>读取的坐标 y。</translation>
    </message>
    <message>
        <source>Read coordinate z.</source>
        <translation>读取的坐标 z。</translation>
    </message>
    <message>
        <source>Decisions</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Rated AP</source>
        <translation>额定 AP</translation>
    </message>
    <message>
        <source>The maker&apos;s figure; empty: nothing is decided.</source>
        <translation>制造商的指标；留空：不作判定。</translation>
    </message>
    <message>
        <source>Rated RP</source>
        <translation>额定 RP</translation>
    </message>
    <message>
        <source>Probability of a decision</source>
        <translation>判定的概率</translation>
    </message>
    <message>
        <source>A robot conforms where this is the probability that its figure is not above the rated one.</source>
        <translation>机器人的指标不超过额定值的概率达到此值时，机器人合格。</translation>
    </message>
    <message>
        <source>U of the instrument</source>
        <translation>仪器的 U</translation>
    </message>
    <message>
        <source>Expanded uncertainty of the measured position, k = 2; empty: it is not held against AP and RP.</source>
        <translation>实测位置的扩展不确定度，k = 2；留空：不与 AP 和 RP 比较。</translation>
    </message>
    <message>
        <source>Largest ratio of U to AP, RP</source>
        <translation>U 与 AP、RP 的最大比值</translation>
    </message>
    <message>
        <source>What the standard or the contract allows, as it says it.</source>
        <translation>标准或合同所允许的值，按其表述。</translation>
    </message>
    <message>
        <source>Two-face and length tests of a tracker</source>
        <translation>跟踪仪的双面和长度检测</translation>
    </message>
    <message>
        <source>Errors of a laser tracker at the positions of its acceptance test, with the uncertainty of the test, and the decision whether they are within the maximum permissible errors.</source>
        <translation>激光跟踪仪在其验收检测各位置的误差及检测的不确定度，以及误差是否在最大允许误差之内的判定。</translation>
    </message>
    <message>
        <source>Positions, numbers of repetitions and limits are those that are entered: none of a standard is built in.</source>
        <translation>位置、重复次数和界限均为所输入的值：未内置任何标准的数值。</translation>
    </message>
    <message>
        <source>The uncertainty of a test value is what the test adds, not the scatter of the tracker: that is what is tested.</source>
        <translation>检测值的不确定度是检测所带来的部分，不是跟踪仪的分散性：后者正是被检测的内容。</translation>
    </message>
    <message>
        <source>A row for every position, typed, pasted or from a CSV file.</source>
        <translation>每个位置一行，手工输入、粘贴或来自 CSV 文件。</translation>
    </message>
    <message>
        <source>Number or name of the position, unique.</source>
        <translation>位置的编号或名称，须唯一。</translation>
    </message>
    <message>
        <source>Two-face: a fixed target read in both faces. Length: a reference length.</source>
        <translation>双面：以盘左盘右读取固定目标。长度：一个参考长度。</translation>
    </message>
    <message>
        <source>two-face</source>
        <translation>双面</translation>
    </message>
    <message>
        <source>Two-face: distance across the beam between the readings of both faces. Length: as measured.</source>
        <translation>双面：盘左与盘右读数之间垂直于光束的距离。长度：实测值。</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>参考值</translation>
    </message>
    <message>
        <source>Calibrated length, of a length test.</source>
        <translation>校准长度，用于长度检测。</translation>
    </message>
    <message>
        <source>range</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Distance of the target, or of the middle of the length, from the tracker.</source>
        <translation>目标点或长度中点到跟踪仪的距离。</translation>
    </message>
    <message>
        <source>Its horizontal angle; empty: 0.</source>
        <translation>其水平角；留空：0。</translation>
    </message>
    <message>
        <source>Its angle above the horizon; empty: 0.</source>
        <translation>其高于水平面的角度；留空：0。</translation>
    </message>
    <message>
        <source>Standard uncertainty of this test value; empty: that of its kind, as below.</source>
        <translation>该检测值的标准不确定度；留空：该类的值，见下。</translation>
    </message>
    <message>
        <source>MPE</source>
        <translation>MPE</translation>
    </message>
    <message>
        <source>Limit for this position; empty: it follows from constant and slope, as below.</source>
        <translation>该位置的界限；留空：由常数和斜率得出，见下。</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>界限</translation>
    </message>
    <message>
        <source>MPE two-face, constant</source>
        <translation>双面 MPE，常数</translation>
    </message>
    <message>
        <source>As the maker states it for a two-face test; empty: every two-face test has its own MPE.</source>
        <translation>制造商给出的双面检测值；留空：每次双面检测有自己的 MPE。</translation>
    </message>
    <message>
        <source>MPE two-face, per metre</source>
        <translation>双面 MPE，每米</translation>
    </message>
    <message>
        <source>Times the range of the target.</source>
        <translation>乘以目标点的距离。</translation>
    </message>
    <message>
        <source>MPE length, constant</source>
        <translation>长度 MPE，常数</translation>
    </message>
    <message>
        <source>As the maker states it; empty: every length has its own MPE.</source>
        <translation>制造商给出的值；留空：每个长度有自己的 MPE。</translation>
    </message>
    <message>
        <source>MPE length, per metre</source>
        <translation>长度 MPE，每米</translation>
    </message>
    <message>
        <source>Times the reference length.</source>
        <translation>乘以参考长度。</translation>
    </message>
    <message>
        <source>Uncertainty of the test values</source>
        <translation>检测值的不确定度</translation>
    </message>
    <message>
        <source>u of a two-face value</source>
        <translation>双面值的 u</translation>
    </message>
    <message>
        <source>Standard uncertainty of what the test adds: seat of the reflector, motion of its mount. Not the scatter of the tracker, which is tested.</source>
        <translation>检测所带来部分的标准不确定度：反射器的靶座、其支架的移动。不是跟踪仪的分散性，后者是被检测的。</translation>
    </message>
    <message>
        <source>u of a length</source>
        <translation>长度的 u</translation>
    </message>
    <message>
        <source>Standard uncertainty of what the test adds to each length: calibration, mounting, temperature. Not the scatter of the tracker.</source>
        <translation>检测给每个长度带来部分的标准不确定度：校准、安装、温度。不是跟踪仪的分散性。</translation>
    </message>
    <message>
        <source>u of the scale of the references</source>
        <translation>参考长度尺度的 u</translation>
    </message>
    <message>
        <source>A position conforms where this is the probability that its error is within the MPE.</source>
        <translation>误差在 MPE 之内的概率达到此值时，该位置合格。</translation>
    </message>
    <message>
        <source>Accuracy and repeatability of a robot</source>
        <translation>机器人的准确度和重复性</translation>
    </message>
    <message>
        <source>AP and RP of ISO 9283 from measured poses, and whether the maker&apos;s figures are met.</source>
        <translation>由实测位姿得到 ISO 9283 的 AP 和 RP，以及是否达到制造商的指标。</translation>
    </message>
    <message>
        <source>Acceptance test of a tracker</source>
        <translation>跟踪仪的验收检测</translation>
    </message>
    <message>
        <source>Two-face and length tests against their limits, with the uncertainty of the test.</source>
        <translation>双面和长度检测与其界限的比较，含检测的不确定度。</translation>
    </message>
    <message>
        <source>Robot at five poses, thirty cycles</source>
        <translation>五个位姿、三十次循环的机器人</translation>
    </message>
    <message>
        <source>An industrial robot, sent thirty times to each of five poses and measured by a laser tracker: AP and RP after ISO 9283 with what thirty cycles and the tracker leave open of them.</source>
        <translation>一台工业机器人，到达五个位姿各三十次，由激光跟踪仪测量：ISO 9283 的 AP 和 RP，以及三十次循环和跟踪仪留下的未定部分。</translation>
    </message>
    <message>
        <source>From rounds of a total station to a certificate</source>
        <translation>从全站仪的测回到证书</translation>
    </message>
    <message>
        <source>Four rounds of a total station say what its readings are worth: a network takes their figures as seen, a pose takes its points from the network, and the certificate states the pose.</source>
        <translation>全站仪的四个测回说明其读数的质量：一个网采用其所见的指标，一个位姿从该网取得其点，证书给出该位姿。</translation>
    </message>
    <message>
        <source>Acceptance test of a laser tracker</source>
        <translation>激光跟踪仪的验收检测</translation>
    </message>
    <message>
        <source>A laser tracker, tested with fixed reflectors read in both faces from three distances, and with a reference length of 2.3 m.</source>
        <translation>一台激光跟踪仪，以从三个距离用盘左盘右读取的固定反射器，以及一个 2.3 m 的参考长度进行检测。</translation>
    </message>
    <message>
        <source>%1 is a temperature in %3, and here it would be taken in kelvin (20 degC as 293.15 K): if it is a difference, give it in %4; for its reading in %3 write (%2 - 0 [%3]). Only the ratio of two temperatures in %3 is taken in kelvin</source>
        <translation>%1 是以 %3 表示的温度，在此将按开尔文取值（20 degC 取为 293.15 K）：若为温差，请以 %4 给出；若要用其以 %3 表示的读数，请写作 (%2 - 0 [%3])。只有以 %3 表示的两个温度之比才按开尔文取值</translation>
    </message>
    <message>
        <source>%1 is a multiple of a temperature in %2, which depends on where the scale has its zero: if the temperature is a difference, give it in %3; else multiply its reading, as in 1.5*(t - 0 [%2])</source>
        <translation>%1 是以 %2 表示的温度的倍数，取决于该温标的零点：若该温度为温差，请以 %3 给出；否则请将其读数相乘，如 1.5*(t - 0 [%2])</translation>
    </message>
    <message>
        <source>a part (%, ppm) or multiple of a temperature in %1 depends on where the scale has its zero: give the figure in %2</source>
        <translation>以 %1 表示的温度的一部分（%、ppm）或倍数取决于该温标的零点：请以 %2 给出该数值</translation>
    </message>
    <message>
        <source>a difference: %1 in %2</source>
        <translation>温差：%1，以 %2 表示</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; is %3; its unit is missing: write &quot;%4 [%5]&quot;</source>
        <translation>&apos;%2&apos; 的列 &apos;%1&apos; 是%3；缺少其单位：请写 &quot;%4 [%5]&quot;</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; is a difference of temperatures: give it in %3, not in %4</source>
        <translation>&apos;%2&apos; 的列 &apos;%1&apos; 是温差：请以 %3 给出，而不是 %4</translation>
    </message>
    <message>
        <source>%1 is a difference of temperatures: give it in %2, not in %3</source>
        <translation>%1 是温差：请以 %2 给出，而不是 %3</translation>
    </message>
    <message>
        <source>The figures of the set-up are too far apart in size for %1: the last digits of the estimates change its sensitivity coefficients by more than a tenth. Give coordinates from a place nearby.</source>
        <translation>对 %1 而言，设置中的数值大小相差过大：估计值的末位数字使其灵敏系数改变十分之一以上。请从附近的点给出坐标。</translation>
    </message>
    <message>
        <source>uncertainties as the residuals see them</source>
        <translation>残差所见的不确定度</translation>
    </message>
    <message>
        <source>stated figures of instruments</source>
        <translation>给出的仪器数值</translation>
    </message>
    <message>
        <source>%1 does not see these figures, so they stay as stated here: %2</source>
        <translation>%1 看不出这些指标，因此保持此处给出的值：%2</translation>
    </message>
    <message>
        <source>readings of figures that are seen elsewhere are correlated with others here</source>
        <translation>在别处看出其指标的读数与此处的其他读数相关</translation>
    </message>
    <message>
        <source>the readings from %1 agree if the names %2 and %3 are exchanged there</source>
        <translation>若将其中的名称 %2 与 %3 互换，来自 %1 的读数即相符</translation>
    </message>
    <message>
        <source>as seen in %1: %2 times what is stated here</source>
        <translation>按 %1 中所见：此处给出值的 %2 倍</translation>
    </message>
    <message>
        <source>the only direction of its round, whose orientation is not known</source>
        <translation>其测回的唯一方向，该测回的定向未知</translation>
    </message>
    <message>
        <source>it contradicts the others: %1</source>
        <translation>与其他读数矛盾：%1</translation>
    </message>
    <message>
        <source>it contradicts the others: %1; it cannot be told apart from %2</source>
        <translation>与其他读数矛盾：%1；无法与 %2 区分</translation>
    </message>
    <message>
        <source>nothing tells them</source>
        <translation>无法确定它们</translation>
    </message>
    <message>
        <source>x and y of %1</source>
        <translation>%1 的 x 和 y</translation>
    </message>
    <message>
        <source>the height of %1</source>
        <translation>%1 的高程</translation>
    </message>
    <message>
        <source>nothing tells it</source>
        <translation>无法确定它</translation>
    </message>
    <message>
        <source>its point %1 is left out</source>
        <translation>其点 %1 已略去</translation>
    </message>
    <message>
        <source>the height of %1 is left out</source>
        <translation>%1 的高程已略去</translation>
    </message>
    <message>
        <source>it misses what the others agree on by %1 m, more than %2 m</source>
        <translation>与其他读数的一致结果相差 %1 m，超过 %2 m</translation>
    </message>
    <message>
        <source>|w| = %1</source>
        <translation>|w| = %1</translation>
    </message>
    <message>
        <source>%1 times its u in a robust adjustment</source>
        <translation>稳健平差中为其 u 的 %1 倍</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>手工</translation>
    </message>
    <message>
        <source>%1 is left out: %2</source>
        <translation>%1 已略去：%2</translation>
    </message>
    <message>
        <source>and %1 more are left out, listed with their reasons</source>
        <translation>另有 %1 个已略去，连同原因列出</translation>
    </message>
    <message>
        <source>zero c and scale m of distances, index i, refraction k</source>
        <translation>距离的零点 c 和尺度 m，指标差 i，折光 k</translation>
    </message>
    <message>
        <source>all instruments</source>
        <translation>所有仪器</translation>
    </message>
    <message>
        <source>the zero of %1</source>
        <translation>%1 的零点</translation>
    </message>
    <message>
        <source>the scale of %1</source>
        <translation>%1 的尺度</translation>
    </message>
    <message>
        <source>the refraction coefficient of %1</source>
        <translation>%1 的折光系数</translation>
    </message>
    <message>
        <source>the vertical index of %1</source>
        <translation>%1 的竖盘指标差</translation>
    </message>
    <message>
        <source>the collimation of %1</source>
        <translation>%1 的视准差</translation>
    </message>
    <message>
        <source>%1 is stated twice</source>
        <translation>%1 给出了两次</translation>
    </message>
    <message>
        <source>%1 needs the radius of the Earth</source>
        <translation>%1 需要地球半径</translation>
    </message>
    <message>
        <source>there is no reading that %1 would change: readings say their instrument in their column</source>
        <translation>没有读数会受 %1 影响：读数在其列中指明仪器</translation>
    </message>
    <message>
        <source>outlier? it cannot be told apart from %1</source>
        <translation>离群值？无法与 %1 区分</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>the readings cannot tell %1 apart: add readings that see them differently, or state one of them</source>
        <translation>读数无法区分 %1：请添加以不同方式反映它们的读数，或给出其中之一</translation>
    </message>
    <message>
        <source>nothing tells %1: add readings that see it, or state it with u</source>
        <translation>无法确定 %1：请添加能反映它的读数，或以 u 给出</translation>
    </message>
    <message>
        <source>%1 readings cannot tell %2 unknowns (coordinates less what the datum takes, orientations, figures of instruments): add %3 readings at least, or state figures with u</source>
        <translation>%1 个读数无法确定 %2 个未知数（坐标减去基准所取的部分、定向、仪器的数值）：请至少添加 %3 个读数，或以 u 给出数值</translation>
    </message>
    <message>
        <source>instruments</source>
        <translation>仪器</translation>
    </message>
    <message>
        <source>base points, %1</source>
        <translation>基坐标系的点，%1</translation>
    </message>
    <message>
        <source>points of the moving frame, %1</source>
        <translation>动坐标系的点，%1</translation>
    </message>
    <message>
        <source>joint %1, point %2</source>
        <translation>关节 %1，点 %2</translation>
    </message>
    <message>
        <source>%1, off the plane</source>
        <translation>%1，离面</translation>
    </message>
    <message>
        <source>%1, along the radius</source>
        <translation>%1，沿半径</translation>
    </message>
    <message>
        <source>a thermodynamic temperature: %1 in %2</source>
        <translation>热力学温度：%1，以 %2 表示</translation>
    </message>
    <message>
        <source>its reading in %2: %1 - 0 [%2]</source>
        <translation>其以 %2 表示的读数：%1 - 0 [%2]</translation>
    </message>
    <message>
        <source>a part of its reading in %1: %2</source>
        <translation>其以 %1 表示的读数的一部分：%2</translation>
    </message>
    <message>
        <source>a temperature: %1 in %2</source>
        <translation>温度：%1，以 %2 表示</translation>
    </message>
    <message>
        <source>y of the points</source>
        <translation>各点的 y</translation>
    </message>
    <message>
        <source>x of the points</source>
        <translation>各点的 x</translation>
    </message>
    <message>
        <source>the distance in row %1 is too long</source>
        <translation>第 %1 行中的距离过长</translation>
    </message>
    <message>
        <source>%1 distances between %2 pillars are more than a baseline has: at most %3 between %4</source>
        <translation>%2 个观测墩间的 %1 个距离多于一条基线所能有的：%4 个之间至多 %3 个</translation>
    </message>
    <message>
        <source>%1 cycles</source>
        <translation>%1 次循环</translation>
    </message>
    <message>
        <source>few cycles</source>
        <translation>循环次数少</translation>
    </message>
    <message>
        <source>%1 cycles, normal scatter of the shape seen</source>
        <translation>%1 次循环，正态分散性，形状按所见</translation>
    </message>
    <message>
        <source>scatter of the cycles</source>
        <translation>循环的分散性</translation>
    </message>
    <message>
        <source>repeatability of %1</source>
        <translation>%1 的重复性</translation>
    </message>
    <message>
        <source>mean deviation of angle %1 of %2</source>
        <translation>%2 的角度 %1 的平均偏差</translation>
    </message>
    <message>
        <source>repeatability of angle %1 of %2</source>
        <translation>%2 的角度 %1 的重复性</translation>
    </message>
    <message>
        <source>instrument and base of the robot</source>
        <translation>仪器和机器人基座</translation>
    </message>
    <message>
        <source>error of the measured place of %1, %2</source>
        <translation>%1 的实测位置的误差，%2</translation>
    </message>
    <message>
        <source>deviation of the mean distance %1</source>
        <translation>平均距离 %1</translation>
    </message>
    <message>
        <source>repeatability of distance %1</source>
        <translation>距离 %1 的重复性</translation>
    </message>
    <message>
        <source>repeatability of the instrument alone</source>
        <translation>仅仪器的重复性</translation>
    </message>
    <message>
        <source>ISO 9283, accuracy of a pose</source>
        <translation>ISO 9283，位姿准确度</translation>
    </message>
    <message>
        <source>ISO 9283, repeatability; c = RP(∞)/RP(n) by simulated campaigns</source>
        <translation>ISO 9283，重复性；c = RP(∞)/RP(n)，由模拟测量系列得到</translation>
    </message>
    <message>
        <source>without the instrument, where both scatter in one shape</source>
        <translation>不含仪器，两者的分散性形状相同时</translation>
    </message>
    <message>
        <source>of several directions of approach</source>
        <translation>多个接近方向</translation>
    </message>
    <message>
        <source>distances between poses</source>
        <translation>位姿间的距离</translation>
    </message>
    <message>
        <source>drift</source>
        <translation>漂移</translation>
    </message>
    <message>
        <source>accuracy of the pose</source>
        <translation>位姿的准确度</translation>
    </message>
    <message>
        <source>repeatability of the pose</source>
        <translation>位姿的重复性</translation>
    </message>
    <message>
        <source>repeatability of the robot alone</source>
        <translation>仅机器人的重复性</translation>
    </message>
    <message>
        <source>share of the instrument in RP²</source>
        <translation>仪器在 RP² 中的占比</translation>
    </message>
    <message>
        <source>accuracy of angle %1</source>
        <translation>角度 %1 的准确度</translation>
    </message>
    <message>
        <source>repeatability of angle %1, ±</source>
        <translation>角度 %1 的重复性，±</translation>
    </message>
    <message>
        <source>variation of the accuracy over the directions of approach</source>
        <translation>准确度随接近方向的变动</translation>
    </message>
    <message>
        <source>drift of the accuracy</source>
        <translation>准确度的漂移</translation>
    </message>
    <message>
        <source>drift of the repeatability</source>
        <translation>重复性的漂移</translation>
    </message>
    <message>
        <source>accuracy of the distance</source>
        <translation>距离的准确度</translation>
    </message>
    <message>
        <source>repeatability of the distance, ±</source>
        <translation>距离的重复性，±</translation>
    </message>
    <message>
        <source>the instrument alone scatters as much as what it measured at %1: nothing is left that could be called the robot&apos;s</source>
        <translation>在 %1 处仅仪器的分散性就与其测得的一样大：没有可归于机器人的部分</translation>
    </message>
    <message>
        <source>two series are called &apos;%1&apos;</source>
        <translation>有两个系列名为 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>there is no commanded pose &apos;%1&apos;</source>
        <translation>没有指令位姿 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>%1 has fewer than three cycles</source>
        <translation>%1 的循环少于三次</translation>
    </message>
    <message>
        <source>row %1 has angles, though its pose is commanded without them</source>
        <translation>第 %1 行有角度，而其位姿的指令没有角度</translation>
    </message>
    <message>
        <source>row %1 has no angles, though its pose is commanded with them</source>
        <translation>第 %1 行没有角度，而其位姿的指令有角度</translation>
    </message>
    <message>
        <source>the coordinates at %1 are too large</source>
        <translation>%1 处的坐标过大</translation>
    </message>
    <message>
        <source>pose &apos;%1&apos; is commanded twice</source>
        <translation>位姿 &apos;%1&apos; 的指令给出了两次</translation>
    </message>
    <message>
        <source>pose &apos;%1&apos; is commanded with some angles and without others</source>
        <translation>位姿 &apos;%1&apos; 的指令只有部分角度，缺少其他角度</translation>
    </message>
    <message>
        <source>some poses are commanded with all angles and others are not</source>
        <translation>部分位姿的指令有全部角度，其他的没有</translation>
    </message>
    <message>
        <source>no cycles were measured at pose &apos;%1&apos;</source>
        <translation>在位姿 &apos;%1&apos; 没有测得循环</translation>
    </message>
    <message>
        <source>a distance from pose &apos;%1&apos; to itself</source>
        <translation>从位姿 &apos;%1&apos; 到其自身的距离</translation>
    </message>
    <message>
        <source>the distance from &apos;%1&apos; to &apos;%2&apos; is there twice</source>
        <translation>从 &apos;%1&apos; 到 &apos;%2&apos; 的距离出现了两次</translation>
    </message>
    <message>
        <source>poses &apos;%1&apos; and &apos;%2&apos; have different numbers of cycles</source>
        <translation>位姿 &apos;%1&apos; 和 &apos;%2&apos; 的循环次数不同</translation>
    </message>
    <message>
        <source>the coordinates of the fixed target in row %1 are too large</source>
        <translation>第 %1 行中固定目标的坐标过大</translation>
    </message>
    <message>
        <source>U of the instrument and the largest ratio go together: enter both, or neither</source>
        <translation>仪器的 U 与最大比值须同时给出：两者都输入，或都不输入</translation>
    </message>
    <message>
        <source>AP by scatter alone</source>
        <translation>仅分散性的 AP</translation>
    </message>
    <message>
        <source>RP, few cycles allowed for</source>
        <translation>RP，已计入循环次数少</translation>
    </message>
    <message>
        <source>u of it</source>
        <translation>其 u</translation>
    </message>
    <message>
        <source>Where AP is not twice what the scatter of the cycles alone makes of it, it says little about the robot.</source>
        <translation>若 AP 不到仅由循环的分散性所产生值的两倍，则它对机器人说明不了多少。</translation>
    </message>
    <message>
        <source>largest s of an axis</source>
        <translation>轴的最大 s</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>中间</translation>
    </message>
    <message>
        <source>smallest</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>mean RP over that of many cycles</source>
        <translation>平均 RP 与多次循环的 RP 之比</translation>
    </message>
    <message>
        <source>relative u of RP</source>
        <translation>RP 的相对 u</translation>
    </message>
    <message>
        <source>conforms</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>does not conform</source>
        <translation>不合格</translation>
    </message>
    <message>
        <source>not decided</source>
        <translation>未判定</translation>
    </message>
    <message>
        <source>rated</source>
        <translation>额定</translation>
    </message>
    <message>
        <source>probability of conformity</source>
        <translation>合格概率</translation>
    </message>
    <message>
        <source>risk that it is wrong</source>
        <translation>误判风险</translation>
    </message>
    <message>
        <source>cycles that would decide</source>
        <translation>判定所需循环数</translation>
    </message>
    <message>
        <source>AP of %1</source>
        <translation>%1 的 AP</translation>
    </message>
    <message>
        <source>RP of %1</source>
        <translation>%1 的 RP</translation>
    </message>
    <message>
        <source>U of the instrument over AP of %1</source>
        <translation>仪器的 U 与 %1 的 AP 之比</translation>
    </message>
    <message>
        <source>U of the instrument over RP of %1</source>
        <translation>仪器的 U 与 %1 的 RP 之比</translation>
    </message>
    <message>
        <source>poses</source>
        <translation>位姿</translation>
    </message>
    <message>
        <source>mean AP</source>
        <translation>平均 AP</translation>
    </message>
    <message>
        <source>largest AP</source>
        <translation>最大 AP</translation>
    </message>
    <message>
        <source>quantile of AP for the probability of a decision</source>
        <translation>判定概率下的 AP 分位数</translation>
    </message>
    <message>
        <source>%1 poses are too few to bound this quantile: the largest of %2 poses does, with the same probability.</source>
        <translation>%1 个位姿太少，不能给出该分位数的上限：%2 个位姿中的最大值可以，概率相同。</translation>
    </message>
    <message>
        <source>two-face: distance of both readings across the beam</source>
        <translation>双面：两读数间垂直于光束的距离</translation>
    </message>
    <message>
        <source>length; a: scale of the references</source>
        <translation>长度；a：参考长度的尺度</translation>
    </message>
    <message>
        <source>decision, ISO 14253-1</source>
        <translation>判定，ISO 14253-1</translation>
    </message>
    <message>
        <source>scale of the reference lengths</source>
        <translation>参考长度的尺度</translation>
    </message>
    <message>
        <source>uncertainty of the test</source>
        <translation>检测的不确定度</translation>
    </message>
    <message>
        <source>uncertainty of the test values</source>
        <translation>检测值的不确定度</translation>
    </message>
    <message>
        <source>measured length at position %1</source>
        <translation>位置 %1 处的实测长度</translation>
    </message>
    <message>
        <source>distance of both faces at position %1</source>
        <translation>位置 %1 处盘左盘右的距离</translation>
    </message>
    <message>
        <source>error at position %1</source>
        <translation>位置 %1 处的误差</translation>
    </message>
    <message>
        <source>there are two tests of position &apos;%1&apos;</source>
        <translation>位置 &apos;%1&apos; 有两次检测</translation>
    </message>
    <message>
        <source>the length at position &apos;%1&apos; has no reference</source>
        <translation>位置 &apos;%1&apos; 处的长度没有参考值</translation>
    </message>
    <message>
        <source>the two-face test of position &apos;%1&apos; has a reference length</source>
        <translation>位置 &apos;%1&apos; 的双面检测有参考长度</translation>
    </message>
    <message>
        <source>nothing says the MPE of position &apos;%1&apos;</source>
        <translation>无从得知位置 &apos;%1&apos; 的 MPE</translation>
    </message>
    <message>
        <source>The tracker conforms at every position.</source>
        <translation>跟踪仪在每个位置均合格。</translation>
    </message>
    <message>
        <source>The tracker does not conform.</source>
        <translation>跟踪仪不合格。</translation>
    </message>
    <message>
        <source>Some positions are not decided: the test is not good enough to tell.</source>
        <translation>部分位置未判定：检测不够好，无法判断。</translation>
    </message>
    <message>
        <source>distance %1</source>
        <translation>距离 %1</translation>
    </message>
    <message>
        <source>pose %1</source>
        <translation>位姿 %1</translation>
    </message>
    <message>
        <source>directions of %1</source>
        <translation>%1 的方向</translation>
    </message>
    <message>
        <source>drift of %1</source>
        <translation>%1 的漂移</translation>
    </message>
    <message>
        <source>base of the robot</source>
        <translation>机器人基座</translation>
    </message>
    <message>
        <source>references</source>
        <translation>参考长度</translation>
    </message>
    <message>
        <source>tracker</source>
        <translation>跟踪仪</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in row %2 of %3 must be %4, not %5: %6</source>
        <translation>%3 第 %2 行中的 &apos;%1&apos; 必须是 %4，而不是 %5：%6</translation>
    </message>
    <message>
        <source>%1 must be a number, not %2: %3</source>
        <translation>%1 必须是数字，而不是 %2：%3</translation>
    </message>
    <message>
        <source>%1 must be true or false, not %2: %3</source>
        <translation>%1 必须是 true 或 false，而不是 %2：%3</translation>
    </message>
    <message>
        <source>a difference of temperatures is given in %1</source>
        <translation>温差以 %1 给出</translation>
    </message>
    <message>
        <source>write true or false, without quotes</source>
        <translation>写 true 或 false，不加引号</translation>
    </message>
    <message>
        <source>write a text in quotes</source>
        <translation>写带引号的文本</translation>
    </message>
    <message>
        <source>write it in quotes: &quot;%1&quot;</source>
        <translation>写在引号中：&quot;%1&quot;</translation>
    </message>
    <message>
        <source>write a number without quotes, such as 0.25, or null where there is none</source>
        <translation>写不带引号的数字，如 0.25；没有时写 null</translation>
    </message>
    <message>
        <source>write %1, without quotes</source>
        <translation>写 %1，不加引号</translation>
    </message>
    <message>
        <source>write a number in %1, the unit of the column, without quotes</source>
        <translation>写一个数字，以列的单位 %1 表示，不加引号</translation>
    </message>
    <message>
        <source>write %1, without quotes: the unit of the column is %2</source>
        <translation>写 %1，不加引号：列的单位是 %2</translation>
    </message>
    <message>
        <source>write %1</source>
        <translation>写 %1</translation>
    </message>
    <message>
        <source>observations that miss what the others agree on by more than %1 m, and points that nothing tells, are left out, as Gama does</source>
        <translation>与其他观测的一致结果相差超过 %1 m 的观测值，以及无法确定的点，均予略去，与 Gama 相同</translation>
    </message>
    <message>
        <source>the file asks for standard deviations a posteriori: for these choose uncertainties as seen, one factor s_0</source>
        <translation>文件要求后验标准偏差：为此请选择“按所见值，一个系数 s_0”的不确定度</translation>
    </message>
    <message>
        <source>%1: readings are not reduced to an ellipsoid</source>
        <translation>%1：读数不归算到椭球</translation>
    </message>
    <message>
        <source>update-constrained-coordinates: the datum keeps the coordinates of the file</source>
        <translation>update-constrained-coordinates：基准保持文件的坐标</translation>
    </message>
    <message>
        <source>Accuracy and repeatability, from the cycles as they are</source>
        <translation>由循环原样得到的准确度和重复性</translation>
    </message>
    <message>
        <source>cycles</source>
        <translation>循环</translation>
    </message>
    <message>
        <source>What few cycles do to RP</source>
        <translation>循环次数少对 RP 的影响</translation>
    </message>
    <message>
        <source>Conformity with the maker&apos;s figures</source>
        <translation>与制造商指标的符合性</translation>
    </message>
    <message>
        <source>decision</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Is the instrument good enough</source>
        <translation>仪器是否足够好</translation>
    </message>
    <message>
        <source>AP over the poses</source>
        <translation>全部位姿的 AP</translation>
    </message>
    <message>
        <source>Accuracy and repeatability of the poses</source>
        <translation>位姿的准确度和重复性</translation>
    </message>
    <message>
        <source>AP, RP</source>
        <translation>AP、RP</translation>
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
        <translation>额定 AP</translation>
    </message>
    <message>
        <source>rated RP</source>
        <translation>额定 RP</translation>
    </message>
    <message>
        <source>Decisions after ISO 14253-1</source>
        <translation>按 ISO 14253-1 的判定</translation>
    </message>
    <message>
        <source>deviation of the barycentre of %1, %2</source>
        <translation>%1 的重心偏差，%2</translation>
    </message>
    <message>
        <source>x in a frame</source>
        <translation>坐标系中的 x</translation>
    </message>
    <message>
        <source>y in a frame</source>
        <translation>坐标系中的 y</translation>
    </message>
    <message>
        <source>z in a frame</source>
        <translation>坐标系中的 z</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>Of a coordinate in a frame: the name of the frame, whose pose the readings tell: that of an arm, a scanner, a photogrammetric network.</source>
        <translation>用于坐标系中的坐标：坐标系的名称，其位姿由读数确定，例如测量臂、扫描仪、摄影测量网的坐标系。</translation>
    </message>
    <message>
        <source>Frames, planes and lines</source>
        <translation>坐标系、平面和直线</translation>
    </message>
    <message>
        <source>Frames that readings name, where more is known of them than that their pose is unknown, and planes and lines on which points are.</source>
        <translation>读数所指名的坐标系（除位姿未知外还有更多已知信息者），以及点所在的平面和直线。</translation>
    </message>
    <message>
        <source>Name of the frame, as in the column of the readings.</source>
        <translation>坐标系的名称，与读数的列中相同。</translation>
    </message>
    <message>
        <source>An own frame with all of its axes; or a plane, from which points are as far as their z in it says; or a line along its x-axis, from which their y and z say how far they are.</source>
        <translation>具有全部轴的独立坐标系；或平面，点与它的距离由点在其中的 z 表示；或沿其 x 轴的直线，点与它的距离由点的 y 和 z 表示。</translation>
    </message>
    <message>
        <source>own frame</source>
        <translation>独立坐标系</translation>
    </message>
    <message>
        <source>Scale of an own frame: fixed; unknown, so that the readings tell it; stated with u.</source>
        <translation>独立坐标系的尺度：固定；未知，由读数确定；以 u 给出。</translation>
    </message>
    <message>
        <source>scale beyond 1</source>
        <translation>尺度超出 1 的部分</translation>
    </message>
    <message>
        <source>By how much coordinates in the frame are too long; 0 where it is empty.</source>
        <translation>坐标系中的坐标偏长的程度；留空为 0。</translation>
    </message>
    <message>
        <source>u of scale</source>
        <translation>尺度的 u</translation>
    </message>
    <message>
        <source>Standard uncertainty of a stated scale.</source>
        <translation>给出的尺度的标准不确定度。</translation>
    </message>
    <message>
        <source>Of an own frame whose z-axis is vertical: within that standard uncertainty about x and about y; empty: nothing is known of it.</source>
        <translation>用于 z 轴竖直的独立坐标系：绕 x 和绕 y 均在此标准不确定度之内；留空：对此一无所知。</translation>
    </message>
    <message>
        <source>two frames are called %1</source>
        <translation>有两个坐标系名为 %1</translation>
    </message>
    <message>
        <source>%1 has no scale and no tilt to state</source>
        <translation>%1 没有可给出的尺度和倾斜</translation>
    </message>
    <message>
        <source>%1: the u of its stated scale is missing</source>
        <translation>%1：缺少所给尺度的 u</translation>
    </message>
    <message>
        <source>there is no reading in %1</source>
        <translation>%1 中没有读数</translation>
    </message>
    <message>
        <source>%1 has points without heights</source>
        <translation>%1 含有没有高程的点</translation>
    </message>
    <message>
        <source>a coordinate of %1 in a frame: the name of the frame is missing</source>
        <translation>%1 在坐标系中的坐标：缺少坐标系的名称</translation>
    </message>
    <message>
        <source>%1 has no such coordinate of %2</source>
        <translation>%1 中没有 %2 的这种坐标</translation>
    </message>
    <message>
        <source>a coordinate in %1 needs x and y of %2, which are not part of the network</source>
        <translation>%1 中的坐标需要 %2 的 x 和 y，而它们不属于网</translation>
    </message>
    <message>
        <source>nothing tells how %1 lies: read more points in it whose places other readings tell, not all on a line</source>
        <translation>无法确定 %1 的位姿：请在其中读取更多位置由其他读数确定的点，且这些点不全在一条直线上</translation>
    </message>
    <message>
        <source>%1, there and back</source>
        <translation>%1，往返</translation>
    </message>
    <message>
        <source>%1, again</source>
        <translation>%1，重复</translation>
    </message>
    <message>
        <source>angle at %1 from %2 to %3, in two rounds</source>
        <translation>%1 处从 %2 到 %3 的角度，两个测回</translation>
    </message>
    <message>
        <source>loop of differences of x, %1</source>
        <translation>x 之差的闭合环，%1</translation>
    </message>
    <message>
        <source>loop of differences of y, %1</source>
        <translation>y 之差的闭合环，%1</translation>
    </message>
    <message>
        <source>loop of height differences, %1</source>
        <translation>高差闭合环，%1</translation>
    </message>
    <message>
        <source>Closures before the adjustment</source>
        <translation>平差前的闭合检核</translation>
    </message>
    <message>
        <source>Closure</source>
        <translation>闭合</translation>
    </message>
    <message>
        <source>misclosure</source>
        <translation>闭合差</translation>
    </message>
    <message>
        <source>u of the misclosure</source>
        <translation>闭合差的 u</translation>
    </message>
    <message>
        <source>misclosure over u</source>
        <translation>闭合差除以 u</translation>
    </message>
    <message>
        <source>too large?</source>
        <translation>过大？</translation>
    </message>
    <message>
        <source>coordinates in frames</source>
        <translation>坐标系中的坐标</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>坐标系 %1</translation>
    </message>
    <message>
        <source>plane %1</source>
        <translation>平面 %1</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>直线 %1</translation>
    </message>
    <message>
        <source>station %1</source>
        <translation>测站 %1</translation>
    </message>
    <message>
        <source>target %1</source>
        <translation>目标点 %1</translation>
    </message>
    <message>
        <source>directions at %1</source>
        <translation>%1 处的方向</translation>
    </message>
    <message>
        <source>directions at %1, round %2</source>
        <translation>%1 处的方向，测回 %2</translation>
    </message>
    <message>
        <source>Groups of readings</source>
        <translation>读数的组</translation>
    </message>
    <message>
        <source>controlled</source>
        <translation>受控</translation>
    </message>
    <message>
        <source>sum of squares falls by</source>
        <translation>平方和减少</translation>
    </message>
    <message>
        <source>contradicts the others?</source>
        <translation>与其他读数矛盾？</translation>
    </message>
    <message>
        <source>Without the group the sum of squares falls by as much, which is a chi-square of as many degrees of freedom as of its readings the others control; p is its probability.</source>
        <translation>去掉该组后，平方和减少这么多；它是卡方，其自由度为该组读数中受其他读数控制的个数；p 为其概率。</translation>
    </message>
    <message>
        <source>%1 groups have p &lt; 0.1 %; where several do, look at the first.</source>
        <translation>%1 个组的 p &lt; 0.1 %；若有多个，请查看第一个。</translation>
    </message>
    <message>
        <source>%1, origin along %2</source>
        <translation>%1，原点沿 %2 的位置</translation>
    </message>
    <message>
        <source>%1, offset along its %2</source>
        <translation>%1，沿其 %2 的偏移</translation>
    </message>
    <message>
        <source>%1, tilt about its %2</source>
        <translation>%1，绕其 %2 的倾斜</translation>
    </message>
    <message>
        <source>%1, turn about %2 after a right angle about y</source>
        <translation>%1，绕 y 转直角后绕 %2 的旋转</translation>
    </message>
    <message>
        <source>%1, turn about %2</source>
        <translation>%1，绕 %2 的旋转</translation>
    </message>
    <message>
        <source>tilt of %1 about %2</source>
        <translation>%1 绕 %2 的倾斜</translation>
    </message>
    <message>
        <source>%1 of %2 in %3</source>
        <translation>%2 在 %3 中的 %1</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>it must be the SHA-256 of the file: 64 hexadecimal digits</source>
        <translation>必须是文件的 SHA-256：64 位十六进制数字</translation>
    </message>
    <message>
        <source>its figures would have been valid only before the calibration</source>
        <translation>其数值只在校准之前有效</translation>
    </message>
    <message>
        <source>the symbol of a quantity or the key of a field is missing</source>
        <translation>缺少量的符号或字段的键</translation>
    </message>
    <message>
        <source>a range needs its lowest or its highest value</source>
        <translation>范围需要其最小值或最大值</translation>
    </message>
    <message>
        <source>its unit does not fit that of the lowest value</source>
        <translation>其单位与最小值的单位不符</translation>
    </message>
    <message>
        <source>it is below the lowest value</source>
        <translation>它小于最小值</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 %2 of %3</source>
        <translation>%3的%1 %2</translation>
    </message>
    <message>
        <source>nothing says which certificate it is: its number is missing</source>
        <translation>无法确定是哪份证书：缺少其编号</translation>
    </message>
    <message>
        <source>a range of a certificate</source>
        <translation>证书的范围</translation>
    </message>
    <message>
        <source>a certificate of figures</source>
        <translation>数值的证书</translation>
    </message>
    <message>
        <source>its figures hold for %1 of %2, and here it is %3</source>
        <translation>其数值适用于 %1 为 %2 的情形，而此处为 %3</translation>
    </message>
    <message>
        <source>its figures hold for %1 of %2, and nothing here is called so</source>
        <translation>其数值适用于 %1 为 %2 的情形，而此处没有以此为名的量</translation>
    </message>
    <message>
        <source>applicable</source>
        <translation>适用</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>outside what it holds for</source>
        <translation>超出适用范围</translation>
    </message>
    <message>
        <source>expired</source>
        <translation>已过有效期</translation>
    </message>
    <message>
        <source>until when it is valid is not stated</source>
        <translation>未给出有效期</translation>
    </message>
    <message>
        <source>the date of the measurement is not stated</source>
        <translation>未给出测量日期</translation>
    </message>
    <message>
        <source>it is of %1, and the measurement of %2 before it</source>
        <translation>其日期为 %1，而测量日期 %2 在其之前</translation>
    </message>
    <message>
        <source>it was valid until %1, and the measurement is of %2</source>
        <translation>其有效期至 %1，而测量日期为 %2</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1；%2</translation>
    </message>
    <message>
        <source>%1: %2: %3</source>
        <translation>%1：%2：%3</translation>
    </message>
    <message>
        <source>Certificates of the figures</source>
        <translation>数值的证书</translation>
    </message>
    <message>
        <source>Figures of</source>
        <translation>数值所属</translation>
    </message>
    <message>
        <source>Calibrated</source>
        <translation>校准日期</translation>
    </message>
    <message>
        <source>Valid until</source>
        <translation>有效期至</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1：%2。</translation>
    </message>
    <message>
        <source>Of %1 artefacts and instruments %2 have no certificate; their figures are assumed: %3.</source>
        <translation>%1 件实物标准器和仪器中有 %2 件没有证书；其数值为假定值：%3。</translation>
    </message>
    <message>
        <source>it is no project</source>
        <translation>它不是项目</translation>
    </message>
    <message>
        <source>it has errors</source>
        <translation>它有错误</translation>
    </message>
    <message>
        <source>%1, with the old figures: %2</source>
        <translation>%1，采用旧数值：%2</translation>
    </message>
    <message>
        <source>%1, with the new figures: %2</source>
        <translation>%1，采用新数值：%2</translation>
    </message>
    <message>
        <source>%1: with the new figures there is no %2</source>
        <translation>%1：采用新数值时没有 %2</translation>
    </message>
    <message>
        <source>there is no folder or file %1</source>
        <translation>没有文件夹或文件 %1</translation>
    </message>
    <message>
        <source>the folder %1 cannot be read: %2</source>
        <translation>不能读取文件夹 %1：%2</translation>
    </message>
    <message>
        <source>Results that change, the largest change first</source>
        <translation>有变化的结果，变化最大者在前</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Change in U</source>
        <translation>变化，以 U 计</translation>
    </message>
    <message>
        <source>Verdict before</source>
        <translation>结论（前）</translation>
    </message>
    <message>
        <source>Verdict after</source>
        <translation>结论（后）</translation>
    </message>
    <message>
        <source>%1 projects and reports were looked at; %2 use the figures.</source>
        <translation>查看了 %1 个项目和报告；其中 %2 个使用这些数值。</translation>
    </message>
    <message>
        <source>Of %1 results %2 change, %3 of them in what is stated; verdicts that change: %4.</source>
        <translation>%1 个结果中有 %2 个变化，其中 %3 个所给出的内容有变化；有 %4 个结论变化。</translation>
    </message>
    <message>
        <source>%1 could not be evaluated.</source>
        <translation>有 %1 个无法评定。</translation>
    </message>
    <message>
        <source>Impact of new figures</source>
        <translation>新数值的影响</translation>
    </message>
    <message>
        <source>Results that rest on a certificate</source>
        <translation>以证书为依据的结果</translation>
    </message>
    <message>
        <source>Replaced</source>
        <translation>被替换</translation>
    </message>
    <message>
        <source>By</source>
        <translation>替换为</translation>
    </message>
    <message>
        <source>Looked for in</source>
        <translation>查找位置</translation>
    </message>
    <message>
        <source>Documents to amend</source>
        <translation>需修订的文件</translation>
    </message>
    <message>
        <source>Not evaluated</source>
        <translation>未评定</translation>
    </message>
    <message>
        <source>the tables of quantities have other units</source>
        <translation>量的两个表格单位不同</translation>
    </message>
    <message>
        <source>the new figures say nothing of the quantity %1</source>
        <translation>新数值中没有关于量 %1 的内容</translation>
    </message>
    <message>
        <source>none of the quantities of the certificate is stated</source>
        <translation>证书的量均未给出</translation>
    </message>
    <message>
        <source>%1 states no quantities in a table</source>
        <translation>%1 没有在表格中给出量</translation>
    </message>
    <message>
        <source>%1 has nothing with the id %2</source>
        <translation>%1 中没有标识为 %2 的条目</translation>
    </message>
    <message>
        <source>%1 has no new figures for %2: nothing in it is of the same kind</source>
        <translation>%1 没有 %2 的新数值：其中没有同类的条目</translation>
    </message>
    <message>
        <source>%1 has several figures that %2 could have: name the one behind &apos;#&apos;</source>
        <translation>%1 中有多组数值可用于 %2：请在 &apos;#&apos; 之后指明其中一组</translation>
    </message>
    <message>
        <source>As it stands on the certificate.</source>
        <translation>与证书上所写相同。</translation>
    </message>
    <message>
        <source>Edition</source>
        <translation>版本</translation>
    </message>
    <message>
        <source>Of an amended certificate or a data sheet.</source>
        <translation>经修订的证书或数据表的版本。</translation>
    </message>
    <message>
        <source>Issuer</source>
        <translation>签发方</translation>
    </message>
    <message>
        <source>Laboratory, manufacturer.</source>
        <translation>实验室、制造商。</translation>
    </message>
    <message>
        <source>The last day on which the figures may be used, by your own rule.</source>
        <translation>按您自己的规定，可使用这些数值的最后一天。</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>条件</translation>
    </message>
    <message>
        <source>What the figures hold for, in words: mode, filter, support.</source>
        <translation>数值适用的条件，以文字说明：模式、滤波、支承。</translation>
    </message>
    <message>
        <source>Its name.</source>
        <translation>文件的名称。</translation>
    </message>
    <message>
        <source>Digest</source>
        <translation>摘要</translation>
    </message>
    <message>
        <source>SHA-256 of the file, 64 hexadecimal digits.</source>
        <translation>文件的 SHA-256，64 位十六进制数字。</translation>
    </message>
    <message>
        <source>certificate</source>
        <translation>证书</translation>
    </message>
    <message>
        <source>report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>data sheet</source>
        <translation>数据表</translation>
    </message>
    <message>
        <source>face</source>
        <translation>盘位</translation>
    </message>
    <message>
        <source>Of a direction, azimuth or zenith angle: the face in which it was read, as it was read. A zenith angle beyond half a turn is of face two anyway. It is brought to face one; index and collimation change it the other way.</source>
        <translation>方向、方位角或天顶距读取时的盘位，按读取时的状态。大于半圈的天顶距必为盘右。它被换算到盘左；指标差和视准差对它的影响符号相反。</translation>
    </message>
    <message>
        <source>one</source>
        <translation>盘左</translation>
    </message>
    <message>
        <source>two</source>
        <translation>盘右</translation>
    </message>
    <message>
        <source>What it does to all of its readings alike: its zero is added to distances, by its scale (weather correction included) they are longer, refraction bends its lines of sight, its index is added to zenith angles, its collimation over the sine of the zenith angle to directions; in face two both are taken off.</source>
        <translation>仪器对其所有读数的同样影响：零点加到距离上，尺度（含气象改正）使距离变长，折光使视线弯曲，指标差加到天顶距上，视准差除以天顶距的正弦后加到方向上；盘右时二者均减去。</translation>
    </message>
    <message>
        <source>Theodolite in rounds</source>
        <translation>经纬仪测回观测</translation>
    </message>
    <message>
        <source>Standard deviations of a direction and of a zenith angle measured once in both faces, and the index error of the vertical circle, from rounds to targets as ISO 17123-3 has them, with their uncertainties and the statistical tests.</source>
        <translation>按 ISO 17123-3，由对各目标点的测回求盘左盘右各测一次的方向和天顶距的标准偏差以及竖盘指标差，含其不确定度和统计检验。</translation>
    </message>
    <message>
        <source>Any number of series, sets and targets counts, also with readings left out; four series of three sets of five targets leave 32 degrees of freedom for directions and 40 for zenith angles.</source>
        <translation>系列、测回和目标点的数目不限，也可缺少读数；四个系列、每系列三个测回、五个目标点时，方向的自由度为 32，天顶距的自由度为 40。</translation>
    </message>
    <message>
        <source>The index error is positive where a zenith angle in face I reads too large. Its sign and the estimate of its uncertainty from its own scatter are those of this program; hold them against the text of the standard before a sheet names it.</source>
        <translation>盘左 I 的天顶距读数偏大时指标差为正。其符号以及由其自身分散性得到的不确定度的估计是本程序的做法；在报表注明该标准之前，请与标准文本核对。</translation>
    </message>
    <message>
        <source>That the index error is the same in all series is a test of this program.</source>
        <translation>指标差在所有系列中相同，是本程序的检验。</translation>
    </message>
    <message>
        <source>A mean of both faces says nothing of collimation and of the tilt of the axes, which it does not contain.</source>
        <translation>盘左盘右的平均值不反映视准差和轴的倾斜，因为其中不含这些影响。</translation>
    </message>
    <message>
        <source>A row for each target of each set, with the readings in both faces: directions, zenith angles, or both. Typed, pasted or from a CSV file.</source>
        <translation>每个测回的每个目标点占一行，含盘左盘右的读数：方向、天顶距或两者。手工输入、粘贴或来自 CSV 文件。</translation>
    </message>
    <message>
        <source>Number of the series; within one the instrument stands unchanged. Empty: 1.</source>
        <translation>系列的编号；在一个系列内仪器保持不动。留空：1。</translation>
    </message>
    <message>
        <source>Number of the set (round) within its series.</source>
        <translation>测回在其系列中的编号。</translation>
    </message>
    <message>
        <source>Hz I</source>
        <translation>Hz I</translation>
    </message>
    <message>
        <source>Horizontal circle in face I.</source>
        <translation>盘左 I 的水平度盘。</translation>
    </message>
    <message>
        <source>Hz II</source>
        <translation>Hz II</translation>
    </message>
    <message>
        <source>Horizontal circle in face II.</source>
        <translation>盘右 II 的水平度盘。</translation>
    </message>
    <message>
        <source>V I</source>
        <translation>V I</translation>
    </message>
    <message>
        <source>Zenith angle in face I: 90° on the horizon.</source>
        <translation>盘左 I 的天顶距：水平时为 90°。</translation>
    </message>
    <message>
        <source>V II</source>
        <translation>V II</translation>
    </message>
    <message>
        <source>Zenith angle in face II: 270° on the horizon.</source>
        <translation>盘右 II 的天顶距：水平时为 270°。</translation>
    </message>
    <message>
        <source>σ of a direction, stated or wanted</source>
        <translation>方向的 σ，给出的或所需的</translation>
    </message>
    <message>
        <source>Standard deviation, measured once in both faces, that test a holds s against: of the maker, or what a job needs. Empty: no test a.</source>
        <translation>检验 a 用以与 s 比较的、盘左盘右各测一次的标准偏差：制造商的值，或任务所需的值。留空：不作检验 a。</translation>
    </message>
    <message>
        <source>s of a direction, another campaign</source>
        <translation>方向的 s，另一次测试</translation>
    </message>
    <message>
        <source>Experimental standard deviation that test b compares s with: of another instrument, observer or day. Empty: no test b.</source>
        <translation>检验 b 用以与 s 比较的实验标准偏差：另一台仪器、另一名观测者或另一天的值。留空：不作检验 b。</translation>
    </message>
    <message>
        <source>Degrees of freedom of that s</source>
        <translation>该 s 的自由度</translation>
    </message>
    <message>
        <source>Of the s of the other campaign; the default is that of four series of three sets of five targets.</source>
        <translation>另一次测试的 s 的自由度；默认值为四个系列、每系列三个测回、五个目标点时的自由度。</translation>
    </message>
    <message>
        <source>σ of a zenith angle, stated or wanted</source>
        <translation>天顶距的 σ，给出的或所需的</translation>
    </message>
    <message>
        <source>s of a zenith angle, another campaign</source>
        <translation>天顶距的 s，另一次测试</translation>
    </message>
    <message>
        <source>History of an instrument</source>
        <translation>仪器的历史</translation>
    </message>
    <message>
        <source>The drift of an instrument or standard from what its calibrations found, with its uncertainty: the component for its next use, and the day on which its next calibration is due.</source>
        <translation>由历次校准的结果求仪器或标准器的漂移及其不确定度：用于下次使用的分量，以及下次校准到期的日期。</translation>
    </message>
    <message>
        <source>The drift is taken as linear. Residuals in the evaluation show whether it is.</source>
        <translation>漂移按线性处理。评定中的残差表明是否如此。</translation>
    </message>
    <message>
        <source>Adjustments are taken out of the series by their differences as left less as found; these count as exact, because both are values of one calibration.</source>
        <translation>调整按调整后与调整前之差从系列中去除；这些差视为精确值，因为两者都是同一次校准的值。</translation>
    </message>
    <message>
        <source>What all calibrations share has no part in the drift. The scatter about the line is part of the value on a date of use: the instrument may lie off its line as it did before.</source>
        <translation>所有校准共有的部分不计入漂移。围绕直线的分散性是使用日期的值的一部分：仪器可能像以前一样偏离其直线。</translation>
    </message>
    <message>
        <source>A year has 365.25 days.</source>
        <translation>一年为 365.25 天。</translation>
    </message>
    <message>
        <source>Of the value.</source>
        <translation>该值的符号。</translation>
    </message>
    <message>
        <source>What the calibrations state.</source>
        <translation>校准给出的量。</translation>
    </message>
    <message>
        <source>In which the values are given.</source>
        <translation>给出各值所用的单位。</translation>
    </message>
    <message>
        <source>Calibrations</source>
        <translation>校准</translation>
    </message>
    <message>
        <source>What each calibration found, typed, pasted or from a CSV file.</source>
        <translation>每次校准的结果，手工输入、粘贴或来自 CSV 文件。</translation>
    </message>
    <message>
        <source>date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Of the calibration: 2026-04-17. Earlier ones stand above.</source>
        <translation>校准的日期：2026-04-17。较早的在上。</translation>
    </message>
    <message>
        <source>as found</source>
        <translation>调整前</translation>
    </message>
    <message>
        <source>Value or deviation before an adjustment, in the unit.</source>
        <translation>调整前的值或偏差，以该单位表示。</translation>
    </message>
    <message>
        <source>as left</source>
        <translation>调整后</translation>
    </message>
    <message>
        <source>After an adjustment, in the unit; empty: not adjusted.</source>
        <translation>调整后的值或偏差，以该单位表示；留空：未调整。</translation>
    </message>
    <message>
        <source>Standard uncertainty of this value alone, in the unit. Used, and needed, with stated uncertainties.</source>
        <translation>仅此值的标准不确定度，以该单位表示。采用给出的不确定度时使用，且必须填写。</translation>
    </message>
    <message>
        <source>From the scatter about the line (three calibrations or more), or as stated for each value.</source>
        <translation>由围绕直线的分散性得到（三次或更多校准），或按各值给出的值。</translation>
    </message>
    <message>
        <source>Common u</source>
        <translation>共同的 u</translation>
    </message>
    <message>
        <source>Standard uncertainty of a deviation that all values share, as that of the laboratory&apos;s standard, in the unit. It is none of the drift.</source>
        <translation>所有值共有的偏差（如实验室标准器的偏差）的标准不确定度，以该单位表示。它不计入漂移。</translation>
    </message>
    <message>
        <source>Date of use</source>
        <translation>使用日期</translation>
    </message>
    <message>
        <source>The value and the drift on that day: 2026-11-28; empty: not asked.</source>
        <translation>该日的值和漂移：2026-11-28；留空：不求。</translation>
    </message>
    <message>
        <source>Next calibration</source>
        <translation>下次校准</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>规则</translation>
    </message>
    <message>
        <source>What must stay within the limit until the next calibration, with k times its u.</source>
        <translation>在下次校准之前，连同其 u 的 k 倍必须保持在界限之内的量。</translation>
    </message>
    <message>
        <source>the drift since the last calibration</source>
        <translation>自上次校准以来的漂移</translation>
    </message>
    <message>
        <source>the deviation from the nominal value</source>
        <translation>与标称值的偏差</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>界限</translation>
    </message>
    <message>
        <source>In the unit.</source>
        <translation>以该单位表示。</translation>
    </message>
    <message>
        <source>Nominal value</source>
        <translation>标称值</translation>
    </message>
    <message>
        <source>In the unit; 0 for deviations.</source>
        <translation>以该单位表示；偏差时为 0。</translation>
    </message>
    <message>
        <source>k of the rule</source>
        <translation>规则的 k</translation>
    </message>
    <message>
        <source>Multiple of u that is added.</source>
        <translation>所加的 u 的倍数。</translation>
    </message>
    <message>
        <source>Longest interval</source>
        <translation>最长间隔</translation>
    </message>
    <message>
        <source>Years after which it is due in any case.</source>
        <translation>无论如何都到期的年数。</translation>
    </message>
    <message>
        <source>Force-proving instrument</source>
        <translation>标准测力仪</translation>
    </message>
    <message>
        <source>Errors of a force transducer as ISO 376 has them, from indications under calibration forces in three positions, its interpolation with covariance, W over the force with all its parts as EURAMET cg-4 combines them, and its class by limits that are entered.</source>
        <translation>按 ISO 376，由三个位置上各校准力下的示值求力传感器的误差，含带协方差的内插、按 EURAMET cg-4 合成所有部分的随力变化的 W，以及按所输入界限确定的等级。</translation>
    </message>
    <message>
        <source>Formulas are those in common use; hold them against the texts of ISO 376 and EURAMET cg-4 before a certificate names them. Limits of classes are not built in.</source>
        <translation>公式为通用公式；在证书注明之前，请与 ISO 376 和 EURAMET cg-4 的文本核对。等级的界限未内置。</translation>
    </message>
    <message>
        <source>W of the table has the coverage factor that is entered. Results have the one of their degrees of freedom: three rotations leave two, which k = 2 does not know.</source>
        <translation>表中的 W 采用所输入的包含因子。结果采用其自由度对应的包含因子：三次旋转只有两个自由度，k = 2 未考虑这一点。</translation>
    </message>
    <message>
        <source>The uncertainty of the machine&apos;s force, creep, zero and temperature act at all forces alike and are common to them; the rotations keep the covariance between the forces that was seen. What is read at one force is its own.</source>
        <translation>校准机的力的不确定度、蠕变、零点和温度对所有力的影响相同，为各力所共有；旋转保留所见的各力之间的协方差。在一个力下读取的只属于该力。</translation>
    </message>
    <message>
        <source>The coefficients have the covariance of the mean deflections; the residuals of the interpolation count at the forces, not in the coefficients.</source>
        <translation>系数具有平均变形的协方差；内插的残差计入各力，不计入系数。</translation>
    </message>
    <message>
        <source>Drift since the calibration, another indicator and other conditions of use are not part of W.</source>
        <translation>自校准以来的漂移、其他指示装置和其他使用条件不是 W 的一部分。</translation>
    </message>
    <message>
        <source>Forces and indications</source>
        <translation>力和示值</translation>
    </message>
    <message>
        <source>A row for each calibration force: two series in one position, one after each of two rotations; decreasing forces where they were read. Typed, pasted or from a CSV file.</source>
        <translation>每个校准力占一行：同一位置两个系列，两次旋转后各一个系列；有读数时也含递减力。手工输入、粘贴或来自 CSV 文件。</translation>
    </message>
    <message>
        <source>Of the calibration machine; its unit is that of results.</source>
        <translation>校准机的力；其单位即结果的单位。</translation>
    </message>
    <message>
        <source>X1</source>
        <translation>X1</translation>
    </message>
    <message>
        <source>First position, increasing force.</source>
        <translation>第一个位置，递增力。</translation>
    </message>
    <message>
        <source>X2</source>
        <translation>X2</translation>
    </message>
    <message>
        <source>The same position again.</source>
        <translation>同一位置，再次。</translation>
    </message>
    <message>
        <source>X3</source>
        <translation>X3</translation>
    </message>
    <message>
        <source>After the first rotation, increasing force.</source>
        <translation>第一次旋转后，递增力。</translation>
    </message>
    <message>
        <source>X4′</source>
        <translation>X4′</translation>
    </message>
    <message>
        <source>The same position as X3, decreasing force; empty: not read at this force.</source>
        <translation>与 X3 相同的位置，递减力；留空：在该力下未读取。</translation>
    </message>
    <message>
        <source>X5</source>
        <translation>X5</translation>
    </message>
    <message>
        <source>After the second rotation, increasing force.</source>
        <translation>第二次旋转后，递增力。</translation>
    </message>
    <message>
        <source>X6′</source>
        <translation>X6′</translation>
    </message>
    <message>
        <source>The same position as X5, decreasing force; empty: not read at this force.</source>
        <translation>与 X5 相同的位置，递减力；留空：在该力下未读取。</translation>
    </message>
    <message>
        <source>U of the force</source>
        <translation>力的 U</translation>
    </message>
    <message>
        <source>Relative expanded uncertainty (k = 2) of this force; empty: that of the calibration machine.</source>
        <translation>该力的相对扩展不确定度（k = 2）；留空：采用校准机的值。</translation>
    </message>
    <message>
        <source>Indications without load</source>
        <translation>空载示值</translation>
    </message>
    <message>
        <source>Before and after each series with increasing forces. Empty: the indications are deflections already, and there is no zero error.</source>
        <translation>每个递增力系列之前和之后。留空：示值已是变形，没有零点误差。</translation>
    </message>
    <message>
        <source>Series with increasing forces.</source>
        <translation>递增力的系列。</translation>
    </message>
    <message>
        <source>Indication without load before the series.</source>
        <translation>系列之前的空载示值。</translation>
    </message>
    <message>
        <source>Indication without load after it, or after the decreasing forces that follow upon it.</source>
        <translation>系列之后，或其后的递减力之后的空载示值。</translation>
    </message>
    <message>
        <source>Smallest step of the indication, or the half range over which it fluctuates.</source>
        <translation>示值的最小步进，或其波动范围的一半。</translation>
    </message>
    <message>
        <source>Creep: indication after 30 s</source>
        <translation>蠕变：30 s 后的示值</translation>
    </message>
    <message>
        <source>Without load, 30 s after the largest force was taken off (or at that force). Empty: creep was not measured.</source>
        <translation>卸除最大力 30 s 后的空载示值（或在该力下的示值）。留空：未测蠕变。</translation>
    </message>
    <message>
        <source>Creep: indication after 300 s</source>
        <translation>蠕变：300 s 后的示值</translation>
    </message>
    <message>
        <source>The same after 300 s.</source>
        <translation>同上，300 s 后。</translation>
    </message>
    <message>
        <source>Force and conditions</source>
        <translation>力和条件</translation>
    </message>
    <message>
        <source>Its certificate gives the relative uncertainty of the force. Empty: every force has its own.</source>
        <translation>其证书给出力的相对不确定度。留空：每个力有自己的不确定度。</translation>
    </message>
    <message>
        <source>Axis of the machine</source>
        <translation>校准机的轴</translation>
    </message>
    <message>
        <source>Which of the loads of its certificate acts on the instrument.</source>
        <translation>其证书的哪个载荷作用于仪器。</translation>
    </message>
    <message>
        <source>Temperature coefficient</source>
        <translation>温度系数</translation>
    </message>
    <message>
        <source>Relative change of the deflection with temperature.</source>
        <translation>变形随温度的相对变化。</translation>
    </message>
    <message>
        <source>Temperature, half width</source>
        <translation>温度，半宽</translation>
    </message>
    <message>
        <source>The temperature of the instrument is known within plus and minus this much.</source>
        <translation>已知仪器的温度在正负该值的范围之内。</translation>
    </message>
    <message>
        <source>Used with</source>
        <translation>使用方式</translation>
    </message>
    <message>
        <source>Whether the instrument will be used with decreasing forces too: the reversibility error is then part of its uncertainty.</source>
        <translation>仪器是否也用于递减力：若是，则可逆性误差是其不确定度的一部分。</translation>
    </message>
    <message>
        <source>increasing forces only</source>
        <translation>仅递增力</translation>
    </message>
    <message>
        <source>decreasing forces too</source>
        <translation>含递减力</translation>
    </message>
    <message>
        <source>Divisor of the reversibility</source>
        <translation>可逆性的除数</translation>
    </message>
    <message>
        <source>The reversibility error divided by it is a standard uncertainty: √3 where the error is a limit that is reached, 3 where it hardly is.</source>
        <translation>可逆性误差除以它即为标准不确定度：误差是会达到的界限时为 √3，几乎不会达到时为 3。</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Degree of the interpolation</source>
        <translation>内插的次数</translation>
    </message>
    <message>
        <source>Of the polynomial of the mean deflection over the force: 1 to 3.</source>
        <translation>平均变形关于力的多项式的次数：1 至 3。</translation>
    </message>
    <message>
        <source>Constant term</source>
        <translation>常数项</translation>
    </message>
    <message>
        <source>Whether the polynomial may have a value without force; else it begins at zero.</source>
        <translation>多项式在无力时是否可以有值；否则从零开始。</translation>
    </message>
    <message>
        <source>Interpolation counts relative to</source>
        <translation>内插残差的基准</translation>
    </message>
    <message>
        <source>What the standard deviation of the residuals is divided by. Relative to the largest deflection it is the same part at every force; relative to each one it grows where forces are small, as a residual does.</source>
        <translation>残差的标准偏差所除以的量。相对于最大变形时，在每个力下比例相同；相对于各力下的变形时，力小处比例变大，与残差一样。</translation>
    </message>
    <message>
        <source>the largest deflection</source>
        <translation>最大变形</translation>
    </message>
    <message>
        <source>the deflection at each force</source>
        <translation>各力下的变形</translation>
    </message>
    <message>
        <source>Normal, with its degrees of freedom in the law of propagation, or a t-distribution (JCGM 101 6.4.9), which has no standard deviation with three rotations.</source>
        <translation>正态分布，其自由度用于传播律；或 t 分布（JCGM 101 6.4.9），三次旋转时它没有标准偏差。</translation>
    </message>
    <message>
        <source>Coverage factor of W</source>
        <translation>W 的包含因子</translation>
    </message>
    <message>
        <source>In the table and curve of W; results have the coverage factor of their degrees of freedom.</source>
        <translation>用于 W 的表和曲线；结果采用其自由度对应的包含因子。</translation>
    </message>
    <message>
        <source>Degree of W over the force</source>
        <translation>W 关于力的次数</translation>
    </message>
    <message>
        <source>Of the polynomial that states W between the calibration forces.</source>
        <translation>给出各校准力之间的 W 的多项式的次数。</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>等级</translation>
    </message>
    <message>
        <source>Limits of the classes</source>
        <translation>等级的界限</translation>
    </message>
    <message>
        <source>A row for each class, the strictest first, with the largest errors that its standard allows: none of a standard is built in. An empty cell is held against nothing; without rows no class is found.</source>
        <translation>每个等级占一行，最严格的在前，列出其标准允许的最大误差：未内置任何标准的值。空单元格不作比较；没有行时不确定等级。</translation>
    </message>
    <message>
        <source>class</source>
        <translation>等级</translation>
    </message>
    <message>
        <source>Name of the class; the strictest first.</source>
        <translation>等级的名称；最严格的在前。</translation>
    </message>
    <message>
        <source>Largest reproducibility error, with rotation.</source>
        <translation>最大复现性误差，有旋转。</translation>
    </message>
    <message>
        <source>b′</source>
        <translation>b′</translation>
    </message>
    <message>
        <source>Largest repeatability error, without rotation.</source>
        <translation>最大重复性误差，无旋转。</translation>
    </message>
    <message>
        <source>Largest interpolation error, of either sign.</source>
        <translation>最大内插误差，不论符号。</translation>
    </message>
    <message>
        <source>Largest zero error, of either sign.</source>
        <translation>最大零点误差，不论符号。</translation>
    </message>
    <message>
        <source>Largest reversibility error.</source>
        <translation>最大可逆性误差。</translation>
    </message>
    <message>
        <source>Largest creep error.</source>
        <translation>最大蠕变误差。</translation>
    </message>
    <message>
        <source>Largest relative expanded uncertainty (k = 2) of the calibration force.</source>
        <translation>校准力的最大相对扩展不确定度（k = 2）。</translation>
    </message>
    <message>
        <source>Calibration of a force transducer</source>
        <translation>力传感器的校准</translation>
    </message>
    <message>
        <source>Errors, interpolation, class and uncertainty of a transducer from three positions, after ISO 376.</source>
        <translation>按 ISO 376，由三个位置求传感器的误差、内插、等级和不确定度。</translation>
    </message>
    <message>
        <source>Standard deviations of directions and zenith angles and the index error, with the tests of ISO 17123-3.</source>
        <translation>方向和天顶距的标准偏差以及指标差，含 ISO 17123-3 的检验。</translation>
    </message>
    <message>
        <source>Drift from as-found values, the component for its next use, its next calibration.</source>
        <translation>由调整前的值求漂移、用于下次使用的分量、下次校准。</translation>
    </message>
    <message>
        <source>Force transducer of 50 kN in three positions</source>
        <translation>三个位置上的 50 kN 力传感器</translation>
    </message>
    <message>
        <source>A force transducer, calibrated after ISO 376 with eight forces in three positions: repeatability, reproducibility, interpolation, zero, reversibility and creep errors, W over the force as EURAMET cg-4 combines it, and the coefficients of its interpolation with their covariance.</source>
        <translation>一台力传感器，按 ISO 376 以三个位置上的八个力校准：重复性、复现性、内插、零点、可逆性和蠕变误差，按 EURAMET cg-4 合成的随力变化的 W，以及其内插的系数及协方差。</translation>
    </message>
    <message>
        <source>Seven years of a gauge block</source>
        <translation>一个量块的七年</translation>
    </message>
    <message>
        <source>Invented: the deviation of a gauge block of 50 mm from its nominal length, as seven calibrations found it.</source>
        <translation>虚构：七次校准得到的 50 mm 量块与其标称长度的偏差。</translation>
    </message>
    <message>
        <source>Theodolite in rounds to five targets</source>
        <translation>对五个目标点的经纬仪测回观测</translation>
    </message>
    <message>
        <source>The circles of a total station, tested after ISO 17123-3 with four series of three sets to five targets in both faces: standard deviations of a direction and of a zenith angle, the index error, each with its uncertainty, and the statistical tests.</source>
        <translation>全站仪的度盘，按 ISO 17123-3 用四个系列、每系列三个测回、以盘左盘右观测五个目标点进行检验：方向和天顶距的标准偏差、指标差，各含其不确定度，以及统计检验。</translation>
    </message>
    <message>
        <source>Amended certificate</source>
        <translation>修订的证书</translation>
    </message>
    <message>
        <source>Replaces certificate</source>
        <translation>所替换的证书</translation>
    </message>
    <message>
        <source>Number of the certificate that this one replaces; empty: it is no amended one.</source>
        <translation>本证书所替换的证书的编号；留空：本证书不是修订的证书。</translation>
    </message>
    <message>
        <source>Its date of issue</source>
        <translation>其签发日期</translation>
    </message>
    <message>
        <source>Reasons of the amendment</source>
        <translation>修订的理由</translation>
    </message>
    <message>
        <source>What was wrong or has changed, and why.</source>
        <translation>何处有误或有变化，以及原因。</translation>
    </message>
    <message>
        <source>Prepared by</source>
        <translation>编制人</translation>
    </message>
    <message>
        <source>Who set up and evaluated the project.</source>
        <translation>建立并评定项目的人员。</translation>
    </message>
    <message>
        <source>Checked by</source>
        <translation>审核人</translation>
    </message>
    <message>
        <source>Who checked it.</source>
        <translation>审核项目的人员。</translation>
    </message>
    <message>
        <source>Released by</source>
        <translation>发布人</translation>
    </message>
    <message>
        <source>Who authorised it (ISO/IEC 17025 7.8.1.1).</source>
        <translation>批准项目的人员（ISO/IEC 17025 7.8.1.1）。</translation>
    </message>
    <message>
        <source>Changes to certificate %1</source>
        <translation>对证书 %1 的更改</translation>
    </message>
    <message>
        <source>No result has changed.</source>
        <translation>结果没有变化。</translation>
    </message>
    <message>
        <source>Statement</source>
        <translation>陈述内容</translation>
    </message>
    <message>
        <source>Replaced certificate</source>
        <translation>被替换的证书</translation>
    </message>
    <message>
        <source>This certificate</source>
        <translation>本证书</translation>
    </message>
    <message>
        <source>Sources of error that are covered</source>
        <translation>已涵盖的误差来源</translation>
    </message>
    <message>
        <source>Not covered</source>
        <translation>未涵盖</translation>
    </message>
    <message>
        <source>%1, face two</source>
        <translation>%1，盘右</translation>
    </message>
    <message>
        <source>%1 of face two is not between half a turn and a whole one: type it as read</source>
        <translation>盘右的%1不在半圈与一圈之间：请按读取的值输入</translation>
    </message>
    <message>
        <source>%1 is not between 0 and half a turn (face one), nor between half a turn and a whole one (face two)</source>
        <translation>%1 不在 0 与半圈之间（盘左），也不在半圈与一圈之间（盘右）</translation>
    </message>
    <message>
        <source>%1, again, half a turn off (say that it is of face two)</source>
        <translation>%1，重复，差半圈（请注明其为盘右）</translation>
    </message>
    <message>
        <source>before the adjustment: %1 closes with %2 %3, %4 times its u (rows %5 of the readings)</source>
        <translation>平差前：%1 的闭合差为 %2 %3，是其 u 的 %4 倍（读数的第 %5 行）</translation>
    </message>
    <message>
        <source>rows of the readings</source>
        <translation>读数的行</translation>
    </message>
    <message>
        <source>loop of distances, %1</source>
        <translation>距离闭合环，%1</translation>
    </message>
    <message>
        <source>%1 and the sights of both from %2</source>
        <translation>%1 与从 %2 对两点的观测</translation>
    </message>
    <message>
        <source>distance %1 – %2 by coordinates and the sights of both from %3</source>
        <translation>由坐标得到的距离 %1 – %2 与从 %3 对两点的观测</translation>
    </message>
    <message>
        <source>distance %1 – %2 by the sights from %3 and from %4</source>
        <translation>由从 %3 和从 %4 的观测得到的距离 %1 – %2</translation>
    </message>
    <message>
        <source>%1 in both faces, as %2</source>
        <translation>盘左盘右的%1，与%2比较</translation>
    </message>
    <message>
        <source>%1 in both faces</source>
        <translation>盘左盘右的%1</translation>
    </message>
    <message>
        <source>%1 from both faces of %2 sights</source>
        <translation>由 %2 次照准的盘左盘右得到的%1</translation>
    </message>
    <message>
        <source>Both faces before the adjustment</source>
        <translation>平差前的盘左盘右</translation>
    </message>
    <message>
        <source>sights</source>
        <translation>照准数</translation>
    </message>
    <message>
        <source>from both faces</source>
        <translation>由盘左盘右得到</translation>
    </message>
    <message>
        <source>u of that</source>
        <translation>其 u</translation>
    </message>
    <message>
        <source>u as stated</source>
        <translation>给出的 u</translation>
    </message>
    <message>
        <source>not as stated?</source>
        <translation>与给出的不符？</translation>
    </message>
    <message>
        <source>state it among the figures of instruments</source>
        <translation>请在仪器的数值中给出</translation>
    </message>
    <message>
        <source>Index (z₁ + z₂ − 400 gon)/2 and collimation (a₁ − a₂ ± 200 gon)/2 · sin z of the sights that were read in both faces.</source>
        <translation>由盘左盘右均读取的照准得到的指标差 (z₁ + z₂ − 400 gon)/2 和视准差 (a₁ − a₂ ± 200 gon)/2 · sin z。</translation>
    </message>
    <message>
        <source>all angles</source>
        <translation>所有角度</translation>
    </message>
    <message>
        <source>all lengths</source>
        <translation>所有长度</translation>
    </message>
    <message>
        <source>the directions</source>
        <translation>各方向</translation>
    </message>
    <message>
        <source>the zenith angles</source>
        <translation>各天顶距</translation>
    </message>
    <message>
        <source>the slope distances</source>
        <translation>各斜距</translation>
    </message>
    <message>
        <source>the horizontal distances</source>
        <translation>各平距</translation>
    </message>
    <message>
        <source>the height differences</source>
        <translation>各高差</translation>
    </message>
    <message>
        <source>the angles read from %1</source>
        <translation>在 %1 读取的角度</translation>
    </message>
    <message>
        <source>the lengths read from %1</source>
        <translation>在 %1 读取的长度</translation>
    </message>
    <message>
        <source>the angles of %1</source>
        <translation>%1 的角度</translation>
    </message>
    <message>
        <source>the lengths of %1</source>
        <translation>%1 的长度</translation>
    </message>
    <message>
        <source>the readings agree if %1 are gon that were typed as degrees</source>
        <translation>如果%1是误按度输入的 gon，则读数一致</translation>
    </message>
    <message>
        <source>the readings agree if %1 are mm that were typed as m</source>
        <translation>如果%1是误按 m 输入的 mm，则读数一致</translation>
    </message>
    <message>
        <source>the readings agree if %1 are degrees that were typed as gon</source>
        <translation>如果%1是误按 gon 输入的度，则读数一致</translation>
    </message>
    <message>
        <source>the readings agree if %1 are m that were typed as mm</source>
        <translation>如果%1是误按 mm 输入的 m，则读数一致</translation>
    </message>
    <message>
        <source>the readings agree if the coordinates of %1 and %2 are exchanged</source>
        <translation>如果将 %1 和 %2 的坐标对调，则读数一致</translation>
    </message>
    <message>
        <source>No limits of classes are entered: no class is found.</source>
        <translation>未输入等级的界限：不确定等级。</translation>
    </message>
    <message>
        <source>largest force</source>
        <translation>最大力</translation>
    </message>
    <message>
        <source>deflection at the largest force</source>
        <translation>最大力下的变形</translation>
    </message>
    <message>
        <source>zero error f_0, the largest of the series</source>
        <translation>零点误差 f_0，各系列中最大者</translation>
    </message>
    <message>
        <source>creep error c</source>
        <translation>蠕变误差 c</translation>
    </message>
    <message>
        <source>degrees of freedom of the interpolation</source>
        <translation>内插的自由度</translation>
    </message>
    <message>
        <source>Without indications at zero there is no zero error.</source>
        <translation>没有空载示值，就没有零点误差。</translation>
    </message>
    <message>
        <source>Creep was not measured: the budget has none of it.</source>
        <translation>未测蠕变：预算中不含蠕变。</translation>
    </message>
    <message>
        <source>The zero error was not measured and is held against no limit.</source>
        <translation>未测零点误差，不与任何界限比较。</translation>
    </message>
    <message>
        <source>The creep error was not measured and is held against no limit.</source>
        <translation>未测蠕变误差，不与任何界限比较。</translation>
    </message>
    <message>
        <source>reproducibility</source>
        <translation>复现性</translation>
    </message>
    <message>
        <source>creep</source>
        <translation>蠕变</translation>
    </message>
    <message>
        <source>zero</source>
        <translation>零点</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>interpolation</source>
        <translation>内插</translation>
    </message>
    <message>
        <source>reversibility</source>
        <translation>可逆性</translation>
    </message>
    <message>
        <source>deflection</source>
        <translation>变形</translation>
    </message>
    <message>
        <source>W, relative expanded uncertainty</source>
        <translation>W，相对扩展不确定度</translation>
    </message>
    <message>
        <source>The curve of W is a fit to the steps, raised by %1 % so that no step lies above it.</source>
        <translation>W 的曲线是对各级的拟合，并提高了 %1 %，使各级均不在其上方。</translation>
    </message>
    <message>
        <source>directions of each series, mean of both faces</source>
        <translation>各系列的方向，盘左盘右的平均值</translation>
    </message>
    <message>
        <source>zenith angles of each series</source>
        <translation>各系列的天顶距</translation>
    </message>
    <message>
        <source>pooled over the series, ν readings less unknowns; JCGM 100 H.3.2, E.4.3</source>
        <translation>各系列合并，ν 为读数个数减去未知数个数；JCGM 100 H.3.2、E.4.3</translation>
    </message>
    <message>
        <source>index error, s_i within the series; JCGM 100 4.2.3</source>
        <translation>指标差，系列内的 s_i；JCGM 100 4.2.3</translation>
    </message>
    <message>
        <source>standard deviation of a direction, measured once in both faces</source>
        <translation>盘左盘右各测一次的方向的标准偏差</translation>
    </message>
    <message>
        <source>standard deviation of a zenith angle, measured once in both faces</source>
        <translation>盘左盘右各测一次的天顶距的标准偏差</translation>
    </message>
    <message>
        <source>Targets stand in their directions; how far they are is not known.</source>
        <translation>目标点画在其方向上；其远近未知。</translation>
    </message>
    <message>
        <source>least squares of the rounds, residuals of %1 series</source>
        <translation>测回的最小二乘，%1 个系列的残差</translation>
    </message>
    <message>
        <source>scatter of the index</source>
        <translation>指标差的分散性</translation>
    </message>
    <message>
        <source>mean of %1 readings in both faces</source>
        <translation>%1 个盘左盘右读数的平均值</translation>
    </message>
    <message>
        <source>index error of the vertical circle</source>
        <translation>竖盘指标差</translation>
    </message>
    <message>
        <source>the directions leave nothing that would tell their scatter: read two targets or more in two sets or more</source>
        <translation>方向没有余量可确定其分散性：请在两个或更多测回中读取两个或更多目标点</translation>
    </message>
    <message>
        <source>the zenith angles leave nothing that would tell their scatter: read targets in two sets or more</source>
        <translation>天顶距没有余量可确定其分散性：请在两个或更多测回中读取目标点</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in set %2 is read in one face only: a reading needs both</source>
        <translation>测回 %2 中的 &apos;%1&apos; 只在一个盘位读取：读数需要盘左和盘右</translation>
    </message>
    <message>
        <source>the faces of &apos;%1&apos; in set %2 differ by more than 10° from half a circle: check the faces, the target and that V is a zenith angle</source>
        <translation>测回 %2 中 &apos;%1&apos; 的盘左盘右之差偏离半圈超过 10°：请检查盘位、目标点以及 V 是否为天顶距</translation>
    </message>
    <message>
        <source>the zenith angle of &apos;%1&apos; in set %2 in face I is not between 0° and 180°</source>
        <translation>测回 %2 中 &apos;%1&apos; 的盘左 I 天顶距不在 0° 与 180° 之间</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in set %2 has no reading</source>
        <translation>测回 %2 中的 &apos;%1&apos; 没有读数</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is there twice in set %2 of series %3</source>
        <translation>&apos;%1&apos; 在系列 %3 的测回 %2 中出现了两次</translation>
    </message>
    <message>
        <source>%1 rows of readings are more than the most, %2</source>
        <translation>读数有 %1 行，超过最多的 %2 行</translation>
    </message>
    <message>
        <source>a: s of %1 is not larger than the stated σ</source>
        <translation>a：%1的 s 不大于给出的 σ</translation>
    </message>
    <message>
        <source>b: s of %1 and that of the other campaign are of one σ, s²/s²</source>
        <translation>b：%1的 s 与另一次测试的 s 属于同一 σ，s²/s²</translation>
    </message>
    <message>
        <source>c: the index error is not different from zero</source>
        <translation>c：指标差与零无差异</translation>
    </message>
    <message>
        <source>An index error is seen: it leaves the mean of both faces; take it off readings in face I alone, or adjust the instrument.</source>
        <translation>存在指标差：它在盘左盘右的平均值中消除；请从仅盘左 I 的读数中减去它，或调整仪器。</translation>
    </message>
    <message>
        <source>the index error is the same in all series, s²/s²</source>
        <translation>指标差在所有系列中相同，s²/s²</translation>
    </message>
    <message>
        <source>The index error changed between the series: it is not one figure, and its u holds for the mean of these series only.</source>
        <translation>指标差在各系列之间有变化：它不是一个单一的数值，其 u 只适用于这些系列的平均值。</translation>
    </message>
    <message>
        <source>a direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>a zenith angle</source>
        <translation>天顶距</translation>
    </message>
    <message>
        <source>relative</source>
        <translation>相对</translation>
    </message>
    <message>
        <source>s of a direction, measured once in both faces</source>
        <translation>盘左盘右各测一次的方向的 s</translation>
    </message>
    <message>
        <source>s of a zenith angle, measured once in both faces</source>
        <translation>盘左盘右各测一次的天顶距的 s</translation>
    </message>
    <message>
        <source>s of a direction</source>
        <translation>方向的 s</translation>
    </message>
    <message>
        <source>its degrees of freedom</source>
        <translation>其自由度</translation>
    </message>
    <message>
        <source>s of a zenith angle</source>
        <translation>天顶距的 s</translation>
    </message>
    <message>
        <source>degrees of freedom of that</source>
        <translation>其自由度</translation>
    </message>
    <message>
        <source>index error</source>
        <translation>指标差</translation>
    </message>
    <message>
        <source>theodolite</source>
        <translation>经纬仪</translation>
    </message>
    <message>
        <source>values found, without the adjustments; t in years, t_m their weighted mean</source>
        <translation>得到的值，不含各次调整；t 以年计，t_m 为其加权平均值</translation>
    </message>
    <message>
        <source>drift since the last calibration, on the date of use</source>
        <translation>自上次校准至使用日期的漂移</translation>
    </message>
    <message>
        <source>value on the date of use; c is what all values share</source>
        <translation>使用日期的值；c 为所有值共有的部分</translation>
    </message>
    <message>
        <source>least squares, %1 calibrations</source>
        <translation>最小二乘，%1 次校准</translation>
    </message>
    <message>
        <source>level of the line, at the mean of the dates</source>
        <translation>直线在平均日期处的高度</translation>
    </message>
    <message>
        <source>scatter about the line</source>
        <translation>围绕直线的分散性</translation>
    </message>
    <message>
        <source>drift in a year</source>
        <translation>一年的漂移</translation>
    </message>
    <message>
        <source>scatter of one value about the line</source>
        <translation>单个值围绕直线的分散性</translation>
    </message>
    <message>
        <source>deviation that all values share</source>
        <translation>所有值共有的偏差</translation>
    </message>
    <message>
        <source>drift since the last calibration, %1</source>
        <translation>自上次校准以来的漂移，%1</translation>
    </message>
    <message>
        <source>the limit is not kept even on the day of the last calibration</source>
        <translation>即使在上次校准当天也未满足界限</translation>
    </message>
    <message>
        <source>a date of the form 2026-04-17 is needed; it is &apos;%1&apos;</source>
        <translation>需要形如 2026-04-17 的日期；现为 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the calibration in row %1 is not after the one before it</source>
        <translation>第 %1 行的校准不在其前一次校准之后</translation>
    </message>
    <message>
        <source>row %1 needs the standard uncertainty of its value</source>
        <translation>第 %1 行需要其值的标准不确定度</translation>
    </message>
    <message>
        <source>two calibrations have no scatter about a line: state the uncertainty of each value, or add a third</source>
        <translation>两次校准没有围绕直线的分散性：请给出每个值的不确定度，或添加第三次校准</translation>
    </message>
    <message>
        <source>the rule needs a limit above zero</source>
        <translation>规则需要大于零的界限</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is the symbol of a drift: choose another one</source>
        <translation>&apos;%1&apos; 是漂移的符号：请另选一个</translation>
    </message>
    <message>
        <source>the date of use is before the last calibration</source>
        <translation>使用日期在上次校准之前</translation>
    </message>
    <message>
        <source>standard uncertainty of the drift in a year</source>
        <translation>一年的漂移的标准不确定度</translation>
    </message>
    <message>
        <source>drift from the last calibration to the date of use</source>
        <translation>自上次校准至使用日期的漂移</translation>
    </message>
    <message>
        <source>corrected: its standard uncertainty</source>
        <translation>已修正：其标准不确定度</translation>
    </message>
    <message>
        <source>not corrected: half-width of a rectangular distribution</source>
        <translation>未修正：矩形分布的半宽</translation>
    </message>
    <message>
        <source>not corrected: standard uncertainty</source>
        <translation>未修正：标准不确定度</translation>
    </message>
    <message>
        <source>The values scatter more about the line than their uncertainties say: state larger ones, or take the uncertainty from the residuals.</source>
        <translation>各值围绕直线的分散性大于其不确定度所说明的：请给出更大的不确定度，或由残差得到不确定度。</translation>
    </message>
    <message>
        <source>last calibration</source>
        <translation>上次校准</translation>
    </message>
    <message>
        <source>next calibration, at the latest</source>
        <translation>下次校准，最迟</translation>
    </message>
    <message>
        <source>The limit is not kept even on the day of the last calibration.</source>
        <translation>即使在上次校准当天也未满足界限。</translation>
    </message>
    <message>
        <source>The limit would be kept for longer: the longest interval decides.</source>
        <translation>界限可在更长时间内满足：由最长间隔决定。</translation>
    </message>
    <message>
        <source>The last day on which the figure of the rule, with k times its u, is within the limit.</source>
        <translation>规则的数值连同其 u 的 k 倍仍在界限之内的最后一天。</translation>
    </message>
    <message>
        <source>deflection, mean of the rotations</source>
        <translation>变形，各次旋转的平均值</translation>
    </message>
    <message>
        <source>reproducibility, repeatability and reversibility errors, ISO 376</source>
        <translation>复现性、重复性和可逆性误差，ISO 376</translation>
    </message>
    <message>
        <source>interpolation, zero and creep errors, ISO 376</source>
        <translation>内插、零点和蠕变误差，ISO 376</translation>
    </message>
    <message>
        <source>interpolation, degree 1 to 3</source>
        <translation>内插，次数 1 至 3</translation>
    </message>
    <message>
        <source>machine, reproducibility, repeatability, resolution, creep, zero, temperature, interpolation, EURAMET cg-4; (v/divisor)² for decreasing forces</source>
        <translation>校准机、复现性、重复性、分辨力、蠕变、零点、温度、内插，EURAMET cg-4；递减力时为 (v/除数)²</translation>
    </message>
    <message>
        <source>ν forces less coefficients</source>
        <translation>ν 为力的个数减去系数的个数</translation>
    </message>
    <message>
        <source>force of the calibration machine</source>
        <translation>校准机的力</translation>
    </message>
    <message>
        <source>calibration machine &apos;%1&apos;</source>
        <translation>校准机 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>uncertainties of the forces</source>
        <translation>各力的不确定度</translation>
    </message>
    <message>
        <source>indications after 30 s and 300 s</source>
        <translation>30 s 和 300 s 后的示值</translation>
    </message>
    <message>
        <source>zero error</source>
        <translation>零点误差</translation>
    </message>
    <message>
        <source>largest change of the indication without load</source>
        <translation>空载示值的最大变化</translation>
    </message>
    <message>
        <source>temperature of the instrument</source>
        <translation>仪器的温度</translation>
    </message>
    <message>
        <source>temperature coefficient and half width</source>
        <translation>温度系数和半宽</translation>
    </message>
    <message>
        <source>reproducibility with rotation</source>
        <translation>有旋转的复现性</translation>
    </message>
    <message>
        <source>three positions of the instrument</source>
        <translation>仪器的三个位置</translation>
    </message>
    <message>
        <source>mean deflection at %1</source>
        <translation>%1 下的平均变形</translation>
    </message>
    <message>
        <source>repeatability without rotation</source>
        <translation>无旋转的重复性</translation>
    </message>
    <message>
        <source>two series in one position</source>
        <translation>同一位置的两个系列</translation>
    </message>
    <message>
        <source>resolution of the indicator</source>
        <translation>指示装置的分辨力</translation>
    </message>
    <message>
        <source>difference of two indications</source>
        <translation>两个示值之差</translation>
    </message>
    <message>
        <source>decreasing against increasing force</source>
        <translation>递减力与递增力之差</translation>
    </message>
    <message>
        <source>interpolated less mean deflection at %1</source>
        <translation>%1 下的内插变形减平均变形</translation>
    </message>
    <message>
        <source>residuals of %1 forces</source>
        <translation>%1 个力的残差</translation>
    </message>
    <message>
        <source>interpolated deflection at %1</source>
        <translation>%1 下的内插变形</translation>
    </message>
    <message>
        <source>coefficient of F to the power %1</source>
        <translation>F 的 %1 次幂的系数</translation>
    </message>
    <message>
        <source>series %1 has no indication without load</source>
        <translation>系列 %1 没有空载示值</translation>
    </message>
    <message>
        <source>series %1 has two rows without load</source>
        <translation>系列 %1 有两行空载值</translation>
    </message>
    <message>
        <source>the force of %1 is there twice: readings of a force are one row</source>
        <translation>力 %1 出现了两次：一个力的读数占一行</translation>
    </message>
    <message>
        <source>nothing says the uncertainty of the force of %1: it needs a calibration machine or a U of its own</source>
        <translation>无法得知力 %1 的不确定度：需要校准机或其自身的 U</translation>
    </message>
    <message>
        <source>%1 forces are more than the most, %2</source>
        <translation>有 %1 个力，超过最多的 %2 个</translation>
    </message>
    <message>
        <source>%1 forces leave nothing that would tell how well a polynomial of %2 coefficients fits: calibrate more forces or lower the degree</source>
        <translation>%1 个力没有余量可确定具有 %2 个系数的多项式的拟合程度：请校准更多的力或降低次数</translation>
    </message>
    <message>
        <source>%1 forces do not determine a polynomial of degree %2</source>
        <translation>%1 个力不能确定 %2 次多项式</translation>
    </message>
    <message>
        <source>&apos;%1&apos; states no uncertainty of %2</source>
        <translation>&apos;%1&apos; 未给出 %2 的不确定度</translation>
    </message>
    <message>
        <source>creep needs the indications after 30 s and after 300 s</source>
        <translation>蠕变需要 30 s 后和 300 s 后的示值</translation>
    </message>
    <message>
        <source>the deflection of series %1 does not grow up to %2: check the indications, and those without load</source>
        <translation>系列 %1 的变形到 %2 为止没有递增：请检查示值和空载示值</translation>
    </message>
    <message>
        <source>for use with decreasing forces an indication X4′ or X6′ has to be read at %1</source>
        <translation>用于递减力时，必须在 %1 下读取示值 X4′ 或 X6′</translation>
    </message>
    <message>
        <source>force %1</source>
        <translation>力 %1</translation>
    </message>
    <message>
        <source>the date of &apos;%1&apos; must be of the form 2026-04-17; it is &apos;%2&apos;</source>
        <translation>&apos;%1&apos; 的日期必须是形如 2026-04-17 的日期；现为 &apos;%2&apos;</translation>
    </message>
    <message>
        <source>the date of &apos;%1&apos; is before that of the step before it</source>
        <translation>&apos;%1&apos; 的日期在其前一步骤的日期之前</translation>
    </message>
    <message>
        <source>a step of the review</source>
        <translation>审核的步骤</translation>
    </message>
    <message>
        <source>a part that was released</source>
        <translation>已发布的部分</translation>
    </message>
    <message>
        <source>an entry of the log</source>
        <translation>日志的条目</translation>
    </message>
    <message>
        <source>the review</source>
        <translation>审核</translation>
    </message>
    <message>
        <source>the title</source>
        <translation>标题</translation>
    </message>
    <message>
        <source>the notes of the project</source>
        <translation>项目的附注</translation>
    </message>
    <message>
        <source>the author</source>
        <translation>作者</translation>
    </message>
    <message>
        <source>the number of the project</source>
        <translation>项目的编号</translation>
    </message>
    <message>
        <source>the texts of the certificate</source>
        <translation>证书的文本</translation>
    </message>
    <message>
        <source>what the replaced certificate stated</source>
        <translation>被替换的证书所给出的内容</translation>
    </message>
    <message>
        <source>what goes into the report</source>
        <translation>报告的内容</translation>
    </message>
    <message>
        <source>how results are stated</source>
        <translation>结果的给出方式</translation>
    </message>
    <message>
        <source>the names and dates of the review</source>
        <translation>审核的姓名和日期</translation>
    </message>
    <message>
        <source>which assets and analyses there are, or their order</source>
        <translation>有哪些资源和分析，或其顺序</translation>
    </message>
    <message>
        <source>asset %1</source>
        <translation>资源 %1</translation>
    </message>
    <message>
        <source>analysis %1</source>
        <translation>分析 %1</translation>
    </message>
    <message>
        <source>texts or certificates of asset %1</source>
        <translation>资源 %1 的文本或证书</translation>
    </message>
    <message>
        <source>texts, requirements or designs of analysis %1</source>
        <translation>分析 %1 的文本、要求或设计</translation>
    </message>
    <message>
        <source>%1, which is new</source>
        <translation>%1（新增）</translation>
    </message>
    <message>
        <source>%1, which is no longer there</source>
        <translation>%1（已不存在）</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>the record of the release</source>
        <translation>发布的记录</translation>
    </message>
    <message>
        <source>draft: it was not released</source>
        <translation>草稿：未发布</translation>
    </message>
    <message>
        <source>released by %1, digest %2</source>
        <translation>由 %1 发布，摘要 %2</translation>
    </message>
    <message>
        <source>draft again: changed since it was released by %1: %2</source>
        <translation>重新成为草稿：由 %1 发布之后有更改：%2</translation>
    </message>
    <message>
        <source>it is not released: &apos;%1&apos; needs a name and a date of the form 2026-04-17</source>
        <translation>未发布：&apos;%1&apos; 需要姓名和形如 2026-04-17 的日期</translation>
    </message>
    <message>
        <source>a text of the replaced certificate</source>
        <translation>被替换的证书的文本</translation>
    </message>
    <message>
        <source>a result of the replaced certificate</source>
        <translation>被替换的证书的结果</translation>
    </message>
    <message>
        <source>the certificate cannot have been issued before the one that it replaces</source>
        <translation>证书不可能在其所替换的证书之前签发</translation>
    </message>
    <message>
        <source>an amended certificate has a number of its own, not that of the one that it replaces</source>
        <translation>修订的证书有其自己的编号，而不是其所替换的证书的编号</translation>
    </message>
    <message>
        <source>%1 directions are of face two, as the zenith angles of their sights say</source>
        <translation>按其照准的天顶距，有 %1 个方向为盘右</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>草稿</translation>
    </message>
    <message>
        <source>it was not released</source>
        <translation>未发布</translation>
    </message>
    <message>
        <source>changed since the release by %1: %2</source>
        <translation>由 %1 发布之后有更改：%2</translation>
    </message>
    <message>
        <source>Digest of the release</source>
        <translation>发布的摘要</translation>
    </message>
    <message>
        <source>the certificate that is to be replaced has no number: there is none to refer to</source>
        <translation>要替换的证书没有编号：无从引用</translation>
    </message>
    <message>
        <source>an amended certificate has a number of its own; %1 is that of the one that it replaces</source>
        <translation>修订的证书有其自己的编号；%1 是其所替换的证书的编号</translation>
    </message>
    <message>
        <source>the date of issue must be of the form 2026-04-17; it is &apos;%1&apos;</source>
        <translation>签发日期必须是形如 2026-04-17 的日期；现为 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>Table %1, continued</source>
        <translation>表 %1（续）</translation>
    </message>
    <message>
        <source>Errors after ISO 376</source>
        <translation>按 ISO 376 的误差</translation>
    </message>
    <message>
        <source>mean deflection</source>
        <translation>平均变形</translation>
    </message>
    <message>
        <source>Classes by the limits entered</source>
        <translation>按所输入界限的等级</translation>
    </message>
    <message>
        <source>Relative standard uncertainties and W</source>
        <translation>相对标准不确定度和 W</translation>
    </message>
    <message>
        <source>Curves over the force</source>
        <translation>随力变化的曲线</translation>
    </message>
    <message>
        <source>power of the force</source>
        <translation>力的幂次</translation>
    </message>
    <message>
        <source>Errors over the force</source>
        <translation>随力变化的误差</translation>
    </message>
    <message>
        <source>relative error</source>
        <translation>相对误差</translation>
    </message>
    <message>
        <source>Relative expanded uncertainty over the force</source>
        <translation>随力变化的相对扩展不确定度</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>漂移</translation>
    </message>
    <message>
        <source>Calibrations and their residuals</source>
        <translation>各次校准及其残差</translation>
    </message>
    <message>
        <source>Change since the first calibration</source>
        <translation>自首次校准以来的变化</translation>
    </message>
    <message>
        <source>years since the first calibration</source>
        <translation>自首次校准以来的年数</translation>
    </message>
    <message>
        <source>line ± k u</source>
        <translation>直线 ± k u</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>系列</translation>
    </message>
    <message>
        <source>Residuals of the directions</source>
        <translation>方向的残差</translation>
    </message>
    <message>
        <source>Residuals of the zenith angles</source>
        <translation>天顶距的残差</translation>
    </message>
    <message>
        <source>And in further campaigns</source>
        <translation>以及其他测试</translation>
    </message>
    <message>
        <source>Further networks that see the same figures. What several of them see is combined: their mean, with what it changes from one campaign to the next in its degrees of freedom (Paule and Mandel).</source>
        <translation>可见相同指标的其他网。多个网对同一指标的所见值合并：取其平均值，各次测试之间的变化计入其自由度（Paule 和 Mandel）。</translation>
    </message>
    <message>
        <source>campaign</source>
        <translation>测试</translation>
    </message>
    <message>
        <source>A network as above.</source>
        <translation>与上面相同的网。</translation>
    </message>
    <message>
        <source>The tool centre point from a planned procedure or from measured points; or only the points as the ballbars measure them, at given places or by measured lengths.</source>
        <translation>按计划程序或实测点求工具中心点；或仅求球杆仪所测的点，在给定位置或按实测长度。</translation>
    </message>
    <message>
        <source>points alone, measured lengths</source>
        <translation>仅点，实测长度</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Lengths of the bars at each point, typed or from a CSV file. Those of more than three bars are adjusted, and their residuals tell their uncertainty.</source>
        <translation>各点处各球杆仪的长度，手工输入或来自 CSV 文件。多于三个球杆仪的长度进行平差，其残差说明长度的不确定度。</translation>
    </message>
    <message>
        <source>Name of the point; it has a length of every bar.</source>
        <translation>点的名称；每个点有每个球杆仪的长度。</translation>
    </message>
    <message>
        <source>bar</source>
        <translation>球杆仪</translation>
    </message>
    <message>
        <source>Number of the bar, which is that of its support.</source>
        <translation>球杆仪的编号，即其支座的编号。</translation>
    </message>
    <message>
        <source>From the support to the ball, as read.</source>
        <translation>从支座到球，按读取的原样。</translation>
    </message>
    <message>
        <source>Uncertainties of the lengths</source>
        <translation>长度的不确定度</translation>
    </message>
    <message>
        <source>As the ballbars state them, or as the residuals of the lengths see them.</source>
        <translation>按球杆仪的给出值，或按长度的残差所见的值。</translation>
    </message>
    <message>
        <source>Stated scatter</source>
        <translation>给出的分散性</translation>
    </message>
    <message>
        <source>Within the groups</source>
        <translation>组内</translation>
    </message>
    <message>
        <source>Standard deviation of one observation, in the unit of the quantity, as a data sheet or a budget states it: the view Seen holds it against the observations. Empty: nothing is stated.</source>
        <translation>单次观测的标准偏差，以该量的单位表示，如数据表或预算所给出：所见视图将其与观测值对照。留空：未给出。</translation>
    </message>
    <message>
        <source>Between the groups</source>
        <translation>组间</translation>
    </message>
    <message>
        <source>The same of the deviations that the observations of a group share. Empty: nothing is stated.</source>
        <translation>一组的各观测所共有的偏差的同类值。留空：未给出。</translation>
    </message>
    <message>
        <source>elevations</source>
        <translation>俯仰角</translation>
    </message>
    <message>
        <source>%1; from one campaign to the next it changes by %2 %</source>
        <translation>%1；各次测试之间的变化为 %2 %</translation>
    </message>
    <message>
        <source>height of the point</source>
        <translation>点的高度</translation>
    </message>
    <message>
        <source>bar %1, point %2</source>
        <translation>球杆仪 %1，点 %2</translation>
    </message>
    <message>
        <source>readings of the bars</source>
        <translation>球杆仪的读数</translation>
    </message>
    <message>
        <source>lengths between supports</source>
        <translation>支座之间的长度</translation>
    </message>
    <message>
        <source>heights of supports</source>
        <translation>支座的高度</translation>
    </message>
    <message>
        <source>constants of the bars</source>
        <translation>球杆仪的常数</translation>
    </message>
    <message>
        <source>the lengths contradict each other by %1 times what their uncertainties allow (at most %2 by chance): look for a mistyped or exchanged length, or for figures of the ballbars that are too small</source>
        <translation>各长度互相矛盾，达到其不确定度所允许的 %1 倍（偶然情况下至多 %2）：请查找误输或对调的长度，或过小的球杆仪数值</translation>
    </message>
    <message>
        <source>there is no bar %1: the ballbars have %2 supports</source>
        <translation>没有球杆仪 %1：球杆仪共有 %2 个支座</translation>
    </message>
    <message>
        <source>point %1 has two lengths of bar %2</source>
        <translation>点 %1 有球杆仪 %2 的两个长度</translation>
    </message>
    <message>
        <source>point %1 has no length of bar %2</source>
        <translation>点 %1 没有球杆仪 %2 的长度</translation>
    </message>
    <message>
        <source>the lengths of the first three bars do not meet at point %1: look for a mistyped or exchanged length</source>
        <translation>前三个球杆仪的长度在点 %1 处不相交：请查找误输或对调的长度</translation>
    </message>
    <message>
        <source>the %1 of %2</source>
        <translation>%2 的 %1</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 及另外 %2 个</translation>
    </message>
    <message>
        <source>%1. An error of it cannot be told apart from one of %2</source>
        <translation>%1。其误差无法与 %2 的误差区分</translation>
    </message>
    <message>
        <source>%1, observation %2</source>
        <translation>%1，观测 %2</translation>
    </message>
    <message>
        <source>mean of %1</source>
        <translation>%1 的平均值</translation>
    </message>
    <message>
        <source>%1, contrast %2</source>
        <translation>%1，对比 %2</translation>
    </message>
    <message>
        <source>scatter within the groups</source>
        <translation>组内的分散性</translation>
    </message>
    <message>
        <source>scatter between the groups</source>
        <translation>组间的分散性</translation>
    </message>
    <message>
        <source>what is stated between the groups can only be held against the observations together with what is stated within them</source>
        <translation>组间的给出值只能与组内的给出值一起同观测值对照</translation>
    </message>
    <message>
        <source>%1 in set %2 of series %3, %4</source>
        <translation>系列 %3 的测回 %2 中的 %1，%4</translation>
    </message>
    <message>
        <source>order</source>
        <translation>顺序</translation>
    </message>
    <message>
        <source>Histogram of the residuals</source>
        <translation>残差的直方图</translation>
    </message>
    <message>
        <source>Best measurement capability</source>
        <translation>最佳测量能力</translation>
    </message>
    <message>
        <source>The smallest expanded uncertainties that a laboratory may state for a quantity (CMC), by ranges of its value. Certificates never state a smaller one.</source>
        <translation>实验室对某个量可以给出的最小扩展不确定度（CMC），按其值的范围列出。证书从不给出更小的值。</translation>
    </message>
    <message>
        <source>It is for U of about 95 %. No evaluation depends on it: results and reports state what was evaluated, certificates what may be stated.</source>
        <translation>它针对约 95 % 的 U。任何评定都不依赖它：结果和报告给出评定值，证书给出可以给出的值。</translation>
    </message>
    <message>
        <source>A result for which the laboratory has no capability is outside its scope: certificates say so, and &quot;covaria check&quot; ends with status 3.</source>
        <translation>实验室没有相应能力的结果超出其范围：证书会说明，“covaria check”以状态 3 结束。</translation>
    </message>
    <message>
        <source>Of the results that it is for, and of the fixed part of U.</source>
        <translation>所适用的结果以及 U 的固定部分的单位。</translation>
    </message>
    <message>
        <source>Symbols</source>
        <translation>符号</translation>
    </message>
    <message>
        <source>Of the results that it is for, with blanks between; empty: all results of that kind of unit.</source>
        <translation>所适用结果的符号，以空格分隔；空：该类单位的所有结果。</translation>
    </message>
    <message>
        <source>Ranges</source>
        <translation>范围</translation>
    </message>
    <message>
        <source>Value of</source>
        <translation>其值取自</translation>
    </message>
    <message>
        <source>Symbol of the quantity that the ranges and the relative part refer to, as that of the nominal length where the result is a deviation; empty: the result itself.</source>
        <translation>范围和比例部分所指的量的符号，例如结果为偏差时的标称长度；空：结果本身。</translation>
    </message>
    <message>
        <source>Unit of the range</source>
        <translation>范围的单位</translation>
    </message>
    <message>
        <source>In which the ranges are given.</source>
        <translation>给出范围所用的单位。</translation>
    </message>
    <message>
        <source>Expanded uncertainties (k = 2) that the accreditation states, by ranges; the first range that has the value counts.</source>
        <translation>认可所列的扩展不确定度（k = 2），按范围列出；以第一个包含该值的范围为准。</translation>
    </message>
    <message>
        <source>Smallest value of the range, in the unit of the range.</source>
        <translation>范围的最小值，以范围的单位表示。</translation>
    </message>
    <message>
        <source>Largest value of the range; it belongs to it.</source>
        <translation>范围的最大值；属于该范围。</translation>
    </message>
    <message>
        <source>U, fixed part</source>
        <translation>U，固定部分</translation>
    </message>
    <message>
        <source>The part of U that does not depend on the value (a of a + b L), in the unit of the results.</source>
        <translation>U 中不依赖于值的部分（a + b L 中的 a），以结果的单位表示。</translation>
    </message>
    <message>
        <source>U, relative part</source>
        <translation>U，比例部分</translation>
    </message>
    <message>
        <source>The part of U in proportion to the value (b of a + b L): 0.5e-6 is 0.5 um in a metre.</source>
        <translation>U 中与值成正比的部分（a + b L 中的 b）：0.5e-6 即每米 0.5 um。</translation>
    </message>
    <message>
        <source>Parts of U</source>
        <translation>U 的组成部分</translation>
    </message>
    <message>
        <source>Fixed and relative part of U.</source>
        <translation>U 的固定部分和比例部分。</translation>
    </message>
    <message>
        <source>are added: a + b L</source>
        <translation>相加：a + b L</translation>
    </message>
    <message>
        <source>in quadrature: Q[a; b L]</source>
        <translation>平方和：Q[a; b L]</translation>
    </message>
    <message>
        <source>Smaller U</source>
        <translation>更小的 U</translation>
    </message>
    <message>
        <source>A smaller U</source>
        <translation>更小的 U</translation>
    </message>
    <message>
        <source>What certificates state where the evaluated U is smaller.</source>
        <translation>评定的 U 更小时证书给出什么。</translation>
    </message>
    <message>
        <source>is raised to it</source>
        <translation>提高到该值</translation>
    </message>
    <message>
        <source>is not stated</source>
        <translation>不给出</translation>
    </message>
    <message>
        <source>the range ends below its beginning</source>
        <translation>范围的终点低于起点</translation>
    </message>
    <message>
        <source>the range has no U</source>
        <translation>该范围没有 U</translation>
    </message>
    <message>
        <source>a relative part of U needs ranges of the same kind of unit as the results</source>
        <translation>U 的比例部分需要与结果同类单位的范围</translation>
    </message>
    <message>
        <source>U of %1, %2, is below the best capability (%4): certificates state %3</source>
        <translation>%1 的 U（%2）低于最佳测量能力（%4）：证书给出 %3</translation>
    </message>
    <message>
        <source>U of %1, %2, is below the best capability of %3 (%4): it may not be stated</source>
        <translation>%1 的 U（%2）低于最佳测量能力 %3（%4）：不可给出</translation>
    </message>
    <message>
        <source>%1 is outside the scope: the laboratory has no capability for it</source>
        <translation>%1 超出认可范围：实验室对此没有测量能力</translation>
    </message>
    <message>
        <source>Distances between points that are measurands too, and calibrated lengths to hold them against.</source>
        <translation>同样作为被测量的点间距离，以及与之对照的校准长度。</translation>
    </message>
    <message>
        <source>A calibrated length of the distance, or what was measured along one line of sight. It is held back from the adjustment, which is held against it (E_n).</source>
        <translation>该距离的校准长度，或沿一条视线测得的值。平差不使用它，并与其对照（E_n）。</translation>
    </message>
    <message>
        <source>u of reference</source>
        <translation>参考值的 u</translation>
    </message>
    <message>
        <source>Standard uncertainty of the reference.</source>
        <translation>参考值的标准不确定度。</translation>
    </message>
    <message>
        <source>Date of the readings</source>
        <translation>读数日期</translation>
    </message>
    <message>
        <source>For the chart of figures over campaigns: 2026-11-28; empty: not stated.</source>
        <translation>用于各次测试指标的图表：2026-11-28；空：未给出。</translation>
    </message>
    <message>
        <source>Network method for a tracker</source>
        <translation>跟踪仪的网络法</translation>
    </message>
    <message>
        <source>What a tracker&apos;s readings are worth, from the same targets seen from several unknown places, and E_n against calibrated lengths.</source>
        <translation>由多个未知位置观测相同目标点得出的跟踪仪读数的价值，以及相对校准长度的 E_n。</translation>
    </message>
    <message>
        <source>Figures of a laser tracker by the network method</source>
        <translation>用网络法求激光跟踪仪的各项数值</translation>
    </message>
    <message>
        <source>One laser tracker, put up at five places that nobody measured, read the same ten nests; it leans a little everywhere.</source>
        <translation>一台激光跟踪仪设于五个未经测量的位置，读取同样的十个靶座；在各处都略有倾斜。</translation>
    </message>
    <message>
        <source>Standard uncertainty as seen, over campaigns</source>
        <translation>各次测试所见的标准不确定度</translation>
    </message>
    <message>
        <source>Seen over stated, over campaigns</source>
        <translation>各次测试的所见值除以给出值</translation>
    </message>
    <message>
        <source>years since the first campaign</source>
        <translation>自首次测试起的年数</translation>
    </message>
    <message>
        <source>campaign, in the order of the set-up</source>
        <translation>测试，按设置的顺序</translation>
    </message>
    <message>
        <source>as seen</source>
        <translation>所见</translation>
    </message>
    <message>
        <source>its 95 % interval</source>
        <translation>其 95 % 区间</translation>
    </message>
    <message>
        <source>95 % interval of the next campaign</source>
        <translation>下一次测试的 95 % 区间</translation>
    </message>
    <message>
        <source>calibrated lengths, held back from the adjustment; U of the difference, k = 2</source>
        <translation>未用于平差而保留的校准长度；差值的 U，k = 2</translation>
    </message>
    <message>
        <source>a reference length and its u belong together</source>
        <translation>参考长度与其 u 应一同给出</translation>
    </message>
    <message>
        <source>Calibrated lengths held back from the adjustment</source>
        <translation>未用于平差而保留的校准长度</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>as adjusted</source>
        <translation>平差值</translation>
    </message>
    <message>
        <source>adjusted less reference</source>
        <translation>平差值减参考值</translation>
    </message>
    <message>
        <source>U of the difference (k = 2)</source>
        <translation>差值的 U (k = 2)</translation>
    </message>
    <message>
        <source>E_n = |d|/U: up to 1 the network agrees with the length. No reading knows it, so that it also speaks for or against what all readings have in common: the scale of distances.</source>
        <translation>E_n = |d|/U：不超过 1 则网与该长度一致。任何读数都不知道它，因此它也能说明所有读数共有的东西：距离的尺度。</translation>
    </message>
    <message>
        <source>%1 as adjusted differs from its reference by %2 µm, with E_n = %3: look for a wrong scale of distances, a wrong reference, or uncertainties that are too small</source>
        <translation>%1 的平差值与参考值相差 %2 µm，E_n = %3：请查找错误的距离尺度、错误的参考值或过小的不确定度</translation>
    </message>
    <message>
        <source>u of %1 is a few of the steps in which numbers of its size are kept, so that its trials are rounded and their U is too large (results like this: %2). The law of propagation is not; or evaluate the deviation from a nominal value.</source>
        <translation>%1 的 u 只有存储该大小数值的步长的几倍，因此其试验被舍入，U 过大（此类结果：%2）。传播律不受影响；或者评定相对于标称值的偏差。</translation>
    </message>
    <message>
        <source>%1 has errors: it is not known which U may be stated for %2</source>
        <translation>%1 有错误：不知道 %2 可给出怎样的 U</translation>
    </message>
    <message>
        <source>U of %1 is the best measurement capability of the laboratory, with k = 2</source>
        <translation>%1 的 U 为实验室的最佳测量能力，k = 2</translation>
    </message>
    <message>
        <source>%1 is not stated: U is below the best measurement capability of the laboratory</source>
        <translation>不给出 %1：U 小于实验室的最佳测量能力</translation>
    </message>
    <message>
        <source>Evaluated</source>
        <translation>评定</translation>
    </message>
    <message>
        <source>before and after by the law of propagation</source>
        <translation>前后均按传播律</translation>
    </message>
    <message>
        <source>before and after as each project says</source>
        <translation>前后均按各项目的规定</translation>
    </message>
    <message>
        <source>The change of the value is given in units of the expanded uncertainty before.</source>
        <translation>值的变化以之前的扩展不确定度为单位给出。</translation>
    </message>
    <message>
        <source>and %1 more closures are beyond %2 times their u</source>
        <translation>另有 %1 个闭合差超过其 u 的 %2 倍</translation>
    </message>
    <message>
        <source>%1 closures are beyond %2 times their u (0.1 % for all of them together).</source>
        <translation>%1 个闭合差超过其 u 的 %2 倍（全部合计 0.1 %）。</translation>
    </message>
    <message>
        <source>The reversibility error was not measured at every step; where it was not, it is held against no limit.</source>
        <translation>并非每一级都测了可逆性误差；未测之处不与任何界限比较。</translation>
    </message>
    <message>
        <source>RP_R of %1</source>
        <translation>%1 的 RP_R</translation>
    </message>
    <message>
        <source>Robot from distances, planes and balls</source>
        <translation>由距离、平面和球求机器人</translation>
    </message>
    <message>
        <source>Geometric parameters of a robot by least squares from distances, touched planes, distances between poses and positions of reflectors, without measured poses.</source>
        <translation>由距离、被接触的平面、位姿间的距离和反射器的位置按最小二乘法求机器人的几何参数，无需实测位姿。</translation>
    </message>
    <message>
        <source>Unknowns that the readings cannot tell are found by their columns of the Jacobian: each that is a combination of those before it (base, places, zeros, targets, then joint by joint, then compliances) stays as stated and is named with its partners.</source>
        <translation>读数不能确定的未知量由其雅可比矩阵的列找出：凡为其前者（基座、位置、零点、目标点，然后逐个关节，最后是柔度）组合的未知量保持给定值，并与其对应的未知量一起列出名称。</translation>
    </message>
    <message>
        <source>Touched planes that are themselves found tell no lengths: an arm and its surroundings that are larger by one factor touch planes that are further away by it. One known distance gives the scale.</source>
        <translation>本身也待求的被接触平面不能确定长度：机械臂及其周围环境按同一因子放大时，接触的平面也按该因子更远。一个已知距离即可给出尺度。</translation>
    </message>
    <message>
        <source>Weights are the inverse variances of the readings. What readings share (the scale of the distances, an instrument&apos;s station, readings of the joints, known places) does not change the weights, but is propagated in full.</source>
        <translation>权为读数方差的倒数。读数共有的部分（距离的尺度、仪器的测站、关节的读数、已知位置）不改变权，但完整传播。</translation>
    </message>
    <message>
        <source>The identified robot stands where its base was found; compliances are reported and not part of it.</source>
        <translation>所辨识的机器人位于其基座被求得之处；柔度会被报告，但不属于机器人。</translation>
    </message>
    <message>
        <source>In each trial the gain of the estimates is used. It differs from a complete fit by residual times curvature.</source>
        <translation>每次试验使用估计值处的增益。它与完整拟合相差残差乘以曲率。</translation>
    </message>
    <message>
        <source>The arm as designed: start of the fit, values of what the readings cannot tell, uncertainty of the readings of its joints, and the arm of a plan.</source>
        <translation>设计的机械臂：拟合的初值、读数无法确定的参数值、关节读数的不确定度，以及计划所用的机械臂。</translation>
    </message>
    <message>
        <source>Readings are</source>
        <translation>读数为</translation>
    </message>
    <message>
        <source>Measured. Or a plan: readings are those of the nominal robot, to see what an experiment would give.</source>
        <translation>实测。或计划：读数为标称机器人的读数，用于查看实验会给出什么。</translation>
    </message>
    <message>
        <source>a plan</source>
        <translation>计划</translation>
    </message>
    <message>
        <source>Balls and reflectors</source>
        <translation>球和反射器</translation>
    </message>
    <message>
        <source>What is measured on the last link.</source>
        <translation>末端连杆上被测量的对象。</translation>
    </message>
    <message>
        <source>Coordinate x in the frame of the last link; of one that is found: about.</source>
        <translation>在末端连杆坐标系中的坐标 x；待求者为近似值。</translation>
    </message>
    <message>
        <source>Coordinate y in the frame of the last link; of one that is found: about.</source>
        <translation>在末端连杆坐标系中的坐标 y；待求者为近似值。</translation>
    </message>
    <message>
        <source>Coordinate z in the frame of the last link; of one that is found: about.</source>
        <translation>在末端连杆坐标系中的坐标 z；待求者为近似值。</translation>
    </message>
    <message>
        <source>place is</source>
        <translation>位置为</translation>
    </message>
    <message>
        <source>Found by the fit, or known. Empty: found.</source>
        <translation>由拟合求得，或为已知。留空：由拟合求得。</translation>
    </message>
    <message>
        <source>known</source>
        <translation>已知</translation>
    </message>
    <message>
        <source>Standard uncertainty of each coordinate, where it is known.</source>
        <translation>位置已知时各坐标的标准不确定度。</translation>
    </message>
    <message>
        <source>Points and planes</source>
        <translation>点和平面</translation>
    </message>
    <message>
        <source>What distances are measured from.</source>
        <translation>距离由此起测。</translation>
    </message>
    <message>
        <source>is a</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>A point: the centre of a ball, a wire&apos;s or a distance meter&apos;s zero. Or a plane.</source>
        <translation>点：球心、拉线传感器或测距仪的零点。或平面。</translation>
    </message>
    <message>
        <source>Coordinate x in the measuring frame, of the point or of any point of the plane; may be empty where it is found.</source>
        <translation>在测量坐标系中点的坐标 x，或平面上任意一点的坐标 x；待求时可以留空。</translation>
    </message>
    <message>
        <source>Coordinate y in the measuring frame, of the point or of any point of the plane; may be empty where it is found.</source>
        <translation>在测量坐标系中点的坐标 y，或平面上任意一点的坐标 y；待求时可以留空。</translation>
    </message>
    <message>
        <source>Coordinate z in the measuring frame, of the point or of any point of the plane; may be empty where it is found.</source>
        <translation>在测量坐标系中点的坐标 z，或平面上任意一点的坐标 z；待求时可以留空。</translation>
    </message>
    <message>
        <source>Coordinate x of the normal of a plane, to the side on which distances are positive; may be empty where it is found.</source>
        <translation>平面法线的坐标 x，指向距离为正的一侧；待求时可以留空。</translation>
    </message>
    <message>
        <source>Coordinate y of the normal of a plane, to the side on which distances are positive; may be empty where it is found.</source>
        <translation>平面法线的坐标 y，指向距离为正的一侧；待求时可以留空。</translation>
    </message>
    <message>
        <source>Coordinate z of the normal of a plane, to the side on which distances are positive; may be empty where it is found.</source>
        <translation>平面法线的坐标 z，指向距离为正的一侧；待求时可以留空。</translation>
    </message>
    <message>
        <source>Found by the fit, or known. Empty: known.</source>
        <translation>由拟合求得，或为已知。留空：已知。</translation>
    </message>
    <message>
        <source>Standard uncertainty of each coordinate of a known point, or of a known plane along its normal.</source>
        <translation>已知点各坐标的标准不确定度，或已知平面沿其法线的标准不确定度。</translation>
    </message>
    <message>
        <source>Readings of the joints.</source>
        <translation>关节的读数。</translation>
    </message>
    <message>
        <source>Torque of the load about the axis of joint 1, where compliances are found; empty: none.</source>
        <translation>负载绕关节 1 的轴的力矩，用于求柔度；留空：无。</translation>
    </message>
    <message>
        <source>Torque of the load about the axis of joint 2, where compliances are found; empty: none.</source>
        <translation>负载绕关节 2 的轴的力矩，用于求柔度；留空：无。</translation>
    </message>
    <message>
        <source>Torque of the load about the axis of joint 3, where compliances are found; empty: none.</source>
        <translation>负载绕关节 3 的轴的力矩，用于求柔度；留空：无。</translation>
    </message>
    <message>
        <source>Torque of the load about the axis of joint 4, where compliances are found; empty: none.</source>
        <translation>负载绕关节 4 的轴的力矩，用于求柔度；留空：无。</translation>
    </message>
    <message>
        <source>Torque of the load about the axis of joint 5, where compliances are found; empty: none.</source>
        <translation>负载绕关节 5 的轴的力矩，用于求柔度；留空：无。</translation>
    </message>
    <message>
        <source>Torque of the load about the axis of joint 6, where compliances are found; empty: none.</source>
        <translation>负载绕关节 6 的轴的力矩，用于求柔度；留空：无。</translation>
    </message>
    <message>
        <source>Torque of the load about the axis of joint 7, where compliances are found; empty: none.</source>
        <translation>负载绕关节 7 的轴的力矩，用于求柔度；留空：无。</translation>
    </message>
    <message>
        <source>Distances of a target in one pose from a point, a plane, or its place in another pose: laser tracer, wire sensors, ballbar, dial gauge, probe on a ball plate.</source>
        <translation>一个位姿中的目标点到点、到平面或到其在另一位姿中的位置的距离：激光追踪仪、拉线传感器、球杆仪、千分表、球板上的测头。</translation>
    </message>
    <message>
        <source>Name of the pose in which the arm stood.</source>
        <translation>机械臂所处位姿的名称。</translation>
    </message>
    <message>
        <source>Name of the ball or reflector that was measured. Empty: the first.</source>
        <translation>所测球或反射器的名称。留空：第一个。</translation>
    </message>
    <message>
        <source>from a</source>
        <translation>起自</translation>
    </message>
    <message>
        <source>Distance of the target from a point; from a plane, on the side of its normal; or from where the same target is in another pose.</source>
        <translation>目标点到点的距离；到平面的距离，在其法线一侧为正；或到同一目标点在另一位姿中所在处的距离。</translation>
    </message>
    <message>
        <source>called</source>
        <translation>其名称</translation>
    </message>
    <message>
        <source>Name of the point, the plane or the other pose.</source>
        <translation>点、平面或另一位姿的名称。</translation>
    </message>
    <message>
        <source>Measured distance; 0 where the ball touches the plane. Not needed of a plan.</source>
        <translation>实测距离；球接触平面时为 0。计划不需要。</translation>
    </message>
    <message>
        <source>Standard uncertainty of this distance. Empty: that of all distances.</source>
        <translation>该距离的标准不确定度。留空：采用所有距离的值。</translation>
    </message>
    <message>
        <source>Name of an unknown that all distances of that name contain: zero of a wire sensor, length of a ballbar, radius of a ball. Empty: none.</source>
        <translation>同名的所有距离都包含的未知量的名称：拉线传感器的零点、球杆仪的长度、球的半径。留空：无。</translation>
    </message>
    <message>
        <source>fit: taken into the fit. check: held back, to see how well the identified arm tells it. Empty: fit.</source>
        <translation>fit（拟合）：参与拟合。check（检核）：不参与拟合，用于查看所辨识的机械臂对其预测得如何。留空：fit。</translation>
    </message>
    <message>
        <source>Standard uncertainty of a distance</source>
        <translation>距离的标准不确定度</translation>
    </message>
    <message>
        <source>Of each distance that states none of its own, independent of all others.</source>
        <translation>适用于自身未给出不确定度的每个距离，与其他所有距离独立。</translation>
    </message>
    <message>
        <source>Relative standard uncertainty of their scale</source>
        <translation>其尺度的相对标准不确定度</translation>
    </message>
    <message>
        <source>All distances from points and between poses share it: the length standard, its temperature.</source>
        <translation>到点的和位姿间的所有距离所共有：长度标准、其温度。</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Coordinates of targets that an instrument measured, one or more targets in a pose.</source>
        <translation>仪器测得的目标点坐标，一个位姿中可有一个或多个目标点。</translation>
    </message>
    <message>
        <source>Measured coordinate x in the measuring frame. Not needed of a plan.</source>
        <translation>在测量坐标系中的实测坐标 x。计划不需要。</translation>
    </message>
    <message>
        <source>Measured coordinate y in the measuring frame. Not needed of a plan.</source>
        <translation>在测量坐标系中的实测坐标 y。计划不需要。</translation>
    </message>
    <message>
        <source>Measured coordinate z in the measuring frame. Not needed of a plan.</source>
        <translation>在测量坐标系中的实测坐标 z。计划不需要。</translation>
    </message>
    <message>
        <source>Found by the fit: points, planes and the instrument stand anywhere. Known: the base stands where the robot says it stands, and places are given or found relative to it.</source>
        <translation>由拟合求得：点、平面和仪器可设于任意处。已知：基座位于机器人所给出的位置，各位置相对于它给出或求得。</translation>
    </message>
    <message>
        <source>Compliance of the joints</source>
        <translation>关节的柔度</translation>
    </message>
    <message>
        <source>Found: each joint gives way in proportion to the torque of the load about it. Not in the model.</source>
        <translation>由拟合求得：每个关节的偏转与负载绕它的力矩成正比。或不在模型中。</translation>
    </message>
    <message>
        <source>not in the model</source>
        <translation>不在模型中</translation>
    </message>
    <message>
        <source>Parameters that stay nominal although the readings could tell them.</source>
        <translation>虽可由读数确定、但仍保持标称值的参数。</translation>
    </message>
    <message>
        <source>As stated; or as the residuals of this fit see them: stated ones times one common factor, or times the factor of each figure (variance components). Either has the degrees of freedom of its estimate. What all readings share stays as stated.</source>
        <translation>按给出值；或按本次拟合的残差所见的值：给出值乘以一个共同的系数，或乘以每个指标各自的系数（方差分量）。后两者均具有其估计的自由度。所有读数共有的部分保持给出值。</translation>
    </message>
    <message>
        <source>Parameters of an arm from what can be measured without poses.</source>
        <translation>由无需位姿即可测得的量求机械臂的参数。</translation>
    </message>
    <message>
        <source>A robot identified without poses</source>
        <translation>不用位姿辨识的机器人</translation>
    </message>
    <message>
        <source>An arm of six joints from what can be measured without poses: distances from points, touched planes with distances between poses, positions of reflectors.</source>
        <translation>由无需位姿即可测得的量求六关节机械臂：到点的距离、被接触的平面加位姿间的距离、反射器的位置。</translation>
    </message>
    <message>
        <source>distances from points</source>
        <translation>到点的距离</translation>
    </message>
    <message>
        <source>distances from planes</source>
        <translation>到平面的距离</translation>
    </message>
    <message>
        <source>%1: the residual is %2 times its standard uncertainty (limit %3). Look at this reading first; hold it back by use = check</source>
        <translation>%1：残差是其标准不确定度的 %2 倍（限值 %3）。请先查看此读数；设 use = check（用途 = 检核）可将其留作检验</translation>
    </message>
    <message>
        <source>the residuals are %1 times as large as the uncertainties of the readings explain: there is more than these (a joint&apos;s elasticity, temperature, an outlier), and the uncertainty of the parameters is stated too small</source>
        <translation>残差是读数的不确定度所能解释的 %1 倍：还有其他因素（关节的弹性、温度、离群值），所给出的参数不确定度过小</translation>
    </message>
    <message>
        <source>no parameter of the arm can be told from these readings: every one of them is coupled with others or held</source>
        <translation>由这些读数不能得出机械臂的任何参数：每个参数都与其他参数耦合或被固定</translation>
    </message>
    <message>
        <source>the fit has %1 readings, no more than there are unknowns to find (%2): measure more, or hold parameters</source>
        <translation>拟合有 %1 个读数，不多于待求的未知数（%2 个）：请测量更多，或固定参数</translation>
    </message>
    <message>
        <source>gives the scale, which the readings do not tell: all lengths of the arm may be larger by one factor</source>
        <translation>用于给出读数不能确定的尺度：机械臂的所有长度可能按同一因子偏大</translation>
    </message>
    <message>
        <source>%1: calculated less measured, held back</source>
        <translation>%1：计算值减测得值，留作检验</translation>
    </message>
    <message>
        <source>compliance of %1</source>
        <translation>%1 的柔度</translation>
    </message>
    <message>
        <source>zero %1</source>
        <translation>零点 %1</translation>
    </message>
    <message>
        <source>distance of plane %1 from the origin</source>
        <translation>平面 %1 到原点的距离</translation>
    </message>
    <message>
        <source>distance from a point, from another pose</source>
        <translation>到点的距离，到另一位姿的距离</translation>
    </message>
    <message>
        <source>distance from a plane, 0 where it is touched</source>
        <translation>到平面的距离，接触时为 0</translation>
    </message>
    <message>
        <source>where compliances are found</source>
        <translation>用于求柔度</translation>
    </message>
    <message>
        <source>JCGM 102 6.2, with all that readings share</source>
        <translation>JCGM 102 6.2，计入读数的所有共同部分</translation>
    </message>
    <message>
        <source>nothing is measured: give distances or positions</source>
        <translation>没有测量任何内容：请给出距离或位置</translation>
    </message>
    <message>
        <source>two of them are called %1</source>
        <translation>其中有两个名为 %1</translation>
    </message>
    <message>
        <source>a plan must say where %1 is: give %2</source>
        <translation>计划必须说明 %1 的位置：请给出 %2</translation>
    </message>
    <message>
        <source>%1 is known, but where it is is not said: give %2, or let the fit find it</source>
        <translation>%1 为已知，但未说明其位置：请给出 %2，或由拟合求得</translation>
    </message>
    <message>
        <source>joint %1 slides: a compliance is found of joints that turn</source>
        <translation>关节 %1 是移动关节：只对转动关节求柔度</translation>
    </message>
    <message>
        <source>joint %1 slides: its reading is %2</source>
        <translation>关节 %1 是移动关节：其读数为 %2</translation>
    </message>
    <message>
        <source>joint %1 turns: its reading is %2</source>
        <translation>关节 %1 是转动关节：其读数为 %2</translation>
    </message>
    <message>
        <source>there is no pose &apos;%1&apos;</source>
        <translation>没有位姿 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>there is no ball or reflector &apos;%1&apos;</source>
        <translation>没有球或反射器 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>%1 from %2</source>
        <translation>%1 到 %2</translation>
    </message>
    <message>
        <source>a distance from a pose to itself is 0</source>
        <translation>位姿到其自身的距离为 0</translation>
    </message>
    <message>
        <source>this distance was not measured: give its value or take its row out</source>
        <translation>此距离未测量：请给出其值，或删除其所在行</translation>
    </message>
    <message>
        <source>a distance from a point or pose is above zero</source>
        <translation>到点或位姿的距离大于零</translation>
    </message>
    <message>
        <source>there is no plane &apos;%1&apos;</source>
        <translation>没有平面 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>there is no point &apos;%1&apos;</source>
        <translation>没有点 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a point and no plane</source>
        <translation>&apos;%1&apos; 是点而不是平面</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a plane and no point</source>
        <translation>&apos;%1&apos; 是平面而不是点</translation>
    </message>
    <message>
        <source>this position was not measured: give x, y and z or take its row out</source>
        <translation>此位置未测量：请给出 x、y 和 z，或删除其所在行</translation>
    </message>
    <message>
        <source>scale of the distances</source>
        <translation>距离的尺度</translation>
    </message>
    <message>
        <source>measured distance</source>
        <translation>实测距离</translation>
    </message>
    <message>
        <source>known place</source>
        <translation>已知位置</translation>
    </message>
    <message>
        <source>plane %1, along its normal</source>
        <translation>平面 %1，沿其法线</translation>
    </message>
    <message>
        <source>tilt %1</source>
        <translation>倾斜 %1</translation>
    </message>
    <message>
        <source>Nominal: the same surroundings fitted with the nominal parameters. E_n = |d|/U: below 1 the reading agrees with the calibration.</source>
        <translation>标称：用标称参数拟合的同一周围环境。E_n = |d|/U：小于 1 时该读数与校准一致。</translation>
    </message>
    <message>
        <source>readings in the fit</source>
        <translation>拟合中的读数</translation>
    </message>
    <message>
        <source>measured distances</source>
        <translation>实测距离</translation>
    </message>
    <message>
        <source>known places</source>
        <translation>已知位置</translation>
    </message>
    <message>
        <source>What was found beside the parameters</source>
        <translation>参数之外求得的量</translation>
    </message>
    <message>
        <source>over its u</source>
        <translation>与其 u 之比</translation>
    </message>
    <message>
        <source>Readings held back from the fit, calculated less measured</source>
        <translation>未参与拟合的读数，计算值减测量值</translation>
    </message>
    <message>
        <source>U (k = 2)</source>
        <translation>U (k = 2)</translation>
    </message>
    <message>
        <source>Hand-eye calibration</source>
        <translation>手眼标定</translation>
    </message>
    <message>
        <source>Where an instrument on a robot&apos;s flange is and where its target stands, or the other way round (A X = Z B), with covariance, residuals and validation.</source>
        <translation>求机器人法兰上的仪器位于何处及其目标位于何处，或反之（A X = Z B），含协方差、残差和验证。</translation>
    </message>
    <message>
        <source>Least squares is on what was measured, and not on A X = Z B itself: an error of a rotation counts by its own u, and not by the lever of X.</source>
        <translation>最小二乘针对测得的量，而不是 A X = Z B 本身：转动的误差按其自身的 u 计入，而不按 X 的力臂。</translation>
    </message>
    <message>
        <source>Errors of the arm are taken to be independent from pose to pose; an arm that is wrong by its parameters shows larger residuals, and an identified robot is the better way.</source>
        <translation>机械臂的误差视为在各位姿之间相互独立；参数有误的机械臂会显示较大的残差，此时所辨识的机器人是更好的途径。</translation>
    </message>
    <message>
        <source>Where all turns of the flange are about one direction, the position along it is not told and named.</source>
        <translation>法兰的所有转动都绕同一方向时，沿该方向的位置不能确定，并列出其名称。</translation>
    </message>
    <message>
        <source>The flange carries</source>
        <translation>法兰携带</translation>
    </message>
    <message>
        <source>The instrument (a camera on the hand), which measures a target that stands still. Or the target, which an instrument that stands still measures.</source>
        <translation>仪器（手上的相机），测量静止的目标。或目标，由静止的仪器测量。</translation>
    </message>
    <message>
        <source>the instrument</source>
        <translation>仪器</translation>
    </message>
    <message>
        <source>the target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Poses of the flange, and where the instrument saw the target in each.</source>
        <translation>法兰的位姿，以及在每个位姿中仪器所见目标的位置。</translation>
    </message>
    <message>
        <source>fit: taken into the fit. check: held back, to see how well the result tells it. Empty: fit.</source>
        <translation>fit（拟合）：参与拟合。check（检核）：不参与拟合，用于查看结果对其预测得如何。留空：fit。</translation>
    </message>
    <message>
        <source>Coordinate x of the flange in the frame of the robot&apos;s base, as the controller says.</source>
        <translation>控制器给出的法兰在机器人基坐标系中的坐标 x。</translation>
    </message>
    <message>
        <source>Coordinate y of the flange in the frame of the robot&apos;s base, as the controller says.</source>
        <translation>控制器给出的法兰在机器人基坐标系中的坐标 y。</translation>
    </message>
    <message>
        <source>Coordinate z of the flange in the frame of the robot&apos;s base, as the controller says.</source>
        <translation>控制器给出的法兰在机器人基坐标系中的坐标 z。</translation>
    </message>
    <message>
        <source>Angle of the flange&apos;s orientation, R = Rz(gamma) Ry(beta) Rx(alpha): W, P, R of some controllers, C, B, A of others.</source>
        <translation>法兰姿态的角度，R = Rz(gamma) Ry(beta) Rx(alpha)：某些控制器的 W、P、R，另一些的 C、B、A。</translation>
    </message>
    <message>
        <source>Coordinate of the target in the frame of the instrument, as measured.</source>
        <translation>目标在仪器坐标系中的实测坐标。</translation>
    </message>
    <message>
        <source>Angle of the target&apos;s orientation in the frame of the instrument, composed likewise; empty in all rows where points alone are measured.</source>
        <translation>目标在仪器坐标系中的姿态角度，按同样方式组合；只测量点时所有行均留空。</translation>
    </message>
    <message>
        <source>Measured positions</source>
        <translation>实测位置</translation>
    </message>
    <message>
        <source>Standard uncertainty of each measured coordinate, independent.</source>
        <translation>每个实测坐标的标准不确定度，彼此独立。</translation>
    </message>
    <message>
        <source>Measured orientations</source>
        <translation>实测姿态</translation>
    </message>
    <message>
        <source>Standard uncertainty of the measured rotation about each axis of the target, independent.</source>
        <translation>绕目标各轴的实测转动的标准不确定度，彼此独立。</translation>
    </message>
    <message>
        <source>Positions of the flange</source>
        <translation>法兰的位置</translation>
    </message>
    <message>
        <source>Standard uncertainty of each coordinate of the flange, independent in each pose: repeatability, errors of the arm.</source>
        <translation>法兰各坐标的标准不确定度，在每个位姿中独立：重复性、机械臂的误差。</translation>
    </message>
    <message>
        <source>Orientations of the flange</source>
        <translation>法兰的姿态</translation>
    </message>
    <message>
        <source>Standard uncertainty of the rotation about each axis of the flange, independent in each pose.</source>
        <translation>绕法兰各轴的转动的标准不确定度，在每个位姿中独立。</translation>
    </message>
    <message>
        <source>Where a camera is on the flange, or a tracker beside the robot.</source>
        <translation>求法兰上的相机的位置，或机器人旁的跟踪仪的位置。</translation>
    </message>
    <message>
        <source>A camera on the hand of a robot, a tracker beside it</source>
        <translation>机器人手上的相机，机器人旁的跟踪仪</translation>
    </message>
    <message>
        <source>Where a camera is on the flange and a board in the cell, and where a tracker stands and a reflector is on the flange.</source>
        <translation>求法兰上的相机和单元中的标定板位于何处，以及跟踪仪和法兰上的反射器位于何处。</translation>
    </message>
    <message>
        <source>orientations of the flange</source>
        <translation>法兰的姿态</translation>
    </message>
    <message>
        <source>positions of the flange</source>
        <translation>法兰的位置</translation>
    </message>
    <message>
        <source>these poses hardly tell %1 apart (condition %2): turn the flange further, about other axes</source>
        <translation>这些位姿几乎不能区分 %1（条件数 %2）：请使法兰绕其他轴转得更远</translation>
    </message>
    <message>
        <source>pose %1: a residual is %2 times its standard uncertainty (limit %3). Look at this pose first; hold it back by use = check</source>
        <translation>位姿 %1：有一个残差是其标准不确定度的 %2 倍（限值 %3）。请先查看此位姿；设 use = check（用途 = 检核）可将其留作检验</translation>
    </message>
    <message>
        <source>the residuals are %1 times as large as the stated uncertainties explain: errors of the arm, of the instrument, an outlier; X and Z are then less certain than stated</source>
        <translation>残差是所给出的不确定度所能解释的 %1 倍：机械臂的误差、仪器的误差、离群值；此时 X 和 Z 的不确定度比给出的更大</translation>
    </message>
    <message>
        <source>the fit does not converge: look for exchanged poses, angles in another order or unit, and for what the flange carries</source>
        <translation>拟合不收敛：请查找对调的位姿、顺序或单位不同的角度，并检查法兰所携带的是什么</translation>
    </message>
    <message>
        <source>at the solution X and Z cannot be told apart</source>
        <translation>在解处不能区分 X 和 Z</translation>
    </message>
    <message>
        <source>E_n = |d|/U: below 1 the pose agrees with the calibration.</source>
        <translation>E_n = |d|/U：小于 1 时该位姿与校准一致。</translation>
    </message>
    <message>
        <source>instrument in the frame of the flange</source>
        <translation>仪器在法兰坐标系中</translation>
    </message>
    <message>
        <source>target in the frame of the base</source>
        <translation>目标在基坐标系中</translation>
    </message>
    <message>
        <source>target in the frame of the flange</source>
        <translation>目标在法兰坐标系中</translation>
    </message>
    <message>
        <source>instrument in the frame of the base</source>
        <translation>仪器在基坐标系中</translation>
    </message>
    <message>
        <source>instrument %1</source>
        <translation>仪器 %1</translation>
    </message>
    <message>
        <source>start: linear in both rotations, then in both positions</source>
        <translation>初值：先对两个转动作线性求解，再对两个位置作线性求解</translation>
    </message>
    <message>
        <source>the fit has %1 poses; it needs %2 or more</source>
        <translation>拟合有 %1 个位姿；需要 %2 个或更多</translation>
    </message>
    <message>
        <source>pose %1: its measured orientation is missing; give alpha_m, beta_m and gamma_m of every pose, or of none</source>
        <translation>位姿 %1：缺少其实测姿态；请给出每个位姿的 alpha_m、beta_m 和 gamma_m，或全部不给</translation>
    </message>
    <message>
        <source>measured pose</source>
        <translation>实测位姿</translation>
    </message>
    <message>
        <source>pose of the flange</source>
        <translation>法兰的位姿</translation>
    </message>
    <message>
        <source>pose %1, %2, rotation about %3</source>
        <translation>位姿 %1，%2，绕 %3 的旋转</translation>
    </message>
    <message>
        <source>pose %1, %2, %3</source>
        <translation>位姿 %1，%2，%3</translation>
    </message>
    <message>
        <source>measured poses</source>
        <translation>实测位姿</translation>
    </message>
    <message>
        <source>poses of the flange</source>
        <translation>法兰的位姿</translation>
    </message>
    <message>
        <source>The residuals of more than %1 readings are not divided between their figures: uncertainties stay as stated; one factor for all of them can be had</source>
        <translation>读数超过 %1 个时，残差不在其各指标之间分配：不确定度保持给出值；可以对全部读数采用一个系数</translation>
    </message>
    <message>
        <source>the readings contradict each other so much that the search for the places of the points went astray: look for exchanged or mistyped readings, for a unit or the sense of angles that was mixed up, and for coordinates that are far off</source>
        <translation>读数相互矛盾过大，以致对各点位置的搜索偏离正途：请查找对调或误输的读数、弄混的单位或角度增大方向，以及偏离很远的坐标</translation>
    </message>
    <message>
        <source>the readings agree if %1 are feet that were typed as m</source>
        <translation>如果%1是误按 m 输入的英尺值，则读数一致</translation>
    </message>
    <message>
        <source>the readings agree if the %1 is in mm and was typed as m</source>
        <translation>如果%1以 mm 为单位却误按 m 输入，则读数一致</translation>
    </message>
    <message>
        <source>the readings agree if angles grow the other way round: the sense of angles, clockwise or counter-clockwise, is probably the other one, or x and y are exchanged</source>
        <translation>如果角度按相反方向增大，则读数一致：角度的方向（顺时针或逆时针）很可能相反，或 x 与 y 对调</translation>
    </message>
    <message>
        <source>the readings agree if the coordinates of %1 are mm that were typed as m</source>
        <translation>如果%1的坐标是误按 m 输入的 mm，则读数一致</translation>
    </message>
    <message>
        <source>the readings agree if the coordinates of %1 are feet that were typed as m</source>
        <translation>如果%1的坐标是误按 m 输入的英尺值，则读数一致</translation>
    </message>
    <message>
        <source>all points</source>
        <translation>所有点</translation>
    </message>
    <message>
        <source>the known points</source>
        <translation>已知点</translation>
    </message>
    <message>
        <source>lengths in mm that were typed as m</source>
        <translation>误按 m 输入的 mm 长度</translation>
    </message>
    <message>
        <source>coordinates in mm that were typed as m</source>
        <translation>误按 m 输入的 mm 坐标</translation>
    </message>
    <message>
        <source>lengths in feet that were typed as m</source>
        <translation>误按 m 输入的英尺长度</translation>
    </message>
    <message>
        <source>coordinates in feet that were typed as m</source>
        <translation>误按 m 输入的英尺坐标</translation>
    </message>
    <message>
        <source>the readings draw a network %1 times as large as the approximate coordinates of the datum do: look for %2</source>
        <translation>由读数绘出的网的大小是由基准点近似坐标绘出的网的 %1 倍：请查找%2</translation>
    </message>
    <message>
        <source>the readings draw a network %1 times as large as the approximate coordinates of the datum do: look for a wrong unit or scale</source>
        <translation>由读数绘出的网的大小是由基准点近似坐标绘出的网的 %1 倍：请查找错误的单位或尺度</translation>
    </message>
    <message>
        <source>the approximate coordinates of the datum agree with the readings if those of %1 and %2 are exchanged</source>
        <translation>如果将 %1 和 %2 的坐标对调，则基准点的近似坐标与读数一致</translation>
    </message>
    <message>
        <source>the approximate coordinates of the datum agree with the readings but for those of %1: look for a mistyped one</source>
        <translation>除 %1 的坐标外，基准点的近似坐标与读数一致：请查找误输的坐标</translation>
    </message>
    <message>
        <source>the readings draw the mirror image of what the approximate coordinates of the datum do: the sense of angles, clockwise or counter-clockwise, is probably the other one, or x and y are exchanged</source>
        <translation>由读数绘出的网是由基准点近似坐标绘出的网的镜像：角度的方向（顺时针或逆时针）很可能相反，或 x 与 y 对调</translation>
    </message>
    <message>
        <source>the readings draw the mirror image of what the approximate coordinates of the datum do: x and y are probably exchanged</source>
        <translation>由读数绘出的网是由基准点近似坐标绘出的网的镜像：x 与 y 很可能对调</translation>
    </message>
    <message>
        <source>distances alone do not tell the network of %1 from its mirror image: state approximate coordinates of four of its points that are not all in a plane</source>
        <translation>仅凭距离不能区分 %1 的网与其镜像：请给出其中不全在一个平面内的四个点的近似坐标</translation>
    </message>
    <message>
        <source>the distances fit as well where %1 are mirrored in the plane of %2: state an approximate coordinate that tells the side, or add a reading that does</source>
        <translation>将 %1 以 %2 的平面作镜像后，距离同样符合：请给出能确定在哪一侧的近似坐标，或添加能确定这一点的读数</translation>
    </message>
    <message>
        <source>the distances fit as well with %1 on the other side of the plane of %2, at (%3, %4, %5) m: state an approximate coordinate that tells the side, or add a reading that does</source>
        <translation>%1 位于 %2 的平面的另一侧 (%3, %4, %5) m 处时，距离同样符合：请给出能确定在哪一侧的近似坐标，或添加能确定这一点的读数</translation>
    </message>
    <message>
        <source>%1 lies so near to the plane of %2 that the distances hardly tell how far from it: %3 m, with u = %4 m, which is no more than its order: add a reading to %1 from outside of the plane, or one of its height</source>
        <translation>%1 离 %2 的平面太近，距离几乎不能确定它离平面多远：%3 m，u = %4 m，这只是其数量级：请添加从平面之外到 %1 的读数，或其高程的读数</translation>
    </message>
    <message>
        <source>and %1 more points with a mirror image that fits as well</source>
        <translation>另有 %1 个点的镜像同样符合</translation>
    </message>
    <message>
        <source>changes no reading</source>
        <translation>不改变任何读数</translation>
    </message>
    <message>
        <source>the fit does not converge: look for exchanged poses, readings of the wrong sign or in another unit, a base far from where the robot says it stands, and for a nominal robot that is another arm</source>
        <translation>拟合不收敛：请查找对调的位姿、符号或单位错误的读数、远离机器人所给位置的基座，以及是否为另一种机械臂的标称机器人</translation>
    </message>
    <message>
        <source>The readings hardly tell the scale: all lengths may be larger by one factor. %1 takes part with its nominal value, as uncertain as the nominal robot states</source>
        <translation>读数几乎不能确定尺度：所有长度可能按同一因子偏大。%1 以其标称值参与，其不确定度为标称机器人所给出的值</translation>
    </message>
    <message>
        <source>The readings do not tell the scale: all lengths may be larger by one factor. %1 is held at its nominal value, of which the nominal robot states no uncertainty: the other lengths are no more certain than it is</source>
        <translation>读数不能确定尺度：所有长度可能按同一因子偏大。%1 固定在其标称值，标称机器人未给出其不确定度：其他长度不会比它更可靠</translation>
    </message>
    <message>
        <source>%1. A length that is known gives the scale: distances between poses, or from several known points</source>
        <translation>%1。已知的长度可给出尺度：位姿间的距离，或到若干已知点的距离</translation>
    </message>
    <message>
        <source>nominal %1</source>
        <translation>标称 %1</translation>
    </message>
    <message>
        <source>pose %1 lacks its reading %2, which other poses have</source>
        <translation>位姿 %1 缺少其读数 %2，而其他位姿具有该读数</translation>
    </message>
    <message>
        <source>at most %1 %2 are taken</source>
        <translation>最多取 %1 个%2</translation>
    </message>
    <message>
        <source>balls and reflectors</source>
        <translation>球和反射器</translation>
    </message>
    <message>
        <source>points and planes</source>
        <translation>点和平面</translation>
    </message>
    <message>
        <source>a ball on the arm is called %1, too</source>
        <translation>机械臂上有一个球也名为 %1</translation>
    </message>
    <message>
        <source>zeros</source>
        <translation>零点</translation>
    </message>
    <message>
        <source>nominal robot</source>
        <translation>标称机器人</translation>
    </message>
</context>
<context>
    <name>covaria::ui</name>
    <message>
        <source>Add %1</source>
        <translation>添加 %1</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>“%1”不是数字。</translation>
    </message>
    <message>
        <source>“%1” is not a unit.</source>
        <translation>“%1”不是单位。</translation>
    </message>
    <message>
        <source>a number without unit is expected.</source>
        <translation>应为不带单位的数值。</translation>
    </message>
    <message>
        <source>a unit like %1 is expected.</source>
        <translation>应为 %1 之类的单位。</translation>
    </message>
    <message>
        <source>The unit %1 does not fit here: </source>
        <translation>单位 %1 不适用于此处： </translation>
    </message>
    <message>
        <source>“%1” is not a whole number.</source>
        <translation>“%1”不是整数。</translation>
    </message>
    <message>
        <source>“%1” is not one of: %2.</source>
        <translation>“%1”不是下列之一：%2。</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>“%1” is neither yes nor no.</source>
        <translation>“%1”既非“是”也非“否”。</translation>
    </message>
    <message>
        <source>The value must be greater than %1.</source>
        <translation>值必须大于 %1。</translation>
    </message>
    <message>
        <source>The value must be at least %1.</source>
        <translation>值必须不小于 %1。</translation>
    </message>
    <message>
        <source>The value must be at most %1.</source>
        <translation>值必须不大于 %1。</translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation>自由度</translation>
    </message>
    <message>
        <source>Unsaved Changes</source>
        <translation>未保存的更改</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>是否保存对“%1”的更改？</translation>
    </message>
    <message>
        <source>Without saving they are lost.</source>
        <translation>不保存则更改将丢失。</translation>
    </message>
    <message>
        <source>File Changed</source>
        <translation>文件已更改</translation>
    </message>
    <message>
        <source>Another program changed “%1”.</source>
        <translation>另一程序更改了“%1”。</translation>
    </message>
    <message>
        <source>Reading it again loses your unsaved changes.</source>
        <translation>重新读取将丢失未保存的更改。</translation>
    </message>
    <message>
        <source>It can be read again.</source>
        <translation>可以重新读取。</translation>
    </message>
    <message>
        <source>Read Again</source>
        <translation>重新读取</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>保留我的</translation>
    </message>
    <message>
        <source>Recover Unsaved Work</source>
        <translation>恢复未保存的工作</translation>
    </message>
    <message>
        <source>Covaria did not end properly. Unsaved work was kept:</source>
        <translation>Covaria 上次未正常结束。未保存的工作已保留：</translation>
    </message>
    <message>
        <source>Open Project</source>
        <translation>打开项目</translation>
    </message>
    <message>
        <source>Covaria project or report (*.covaria *.pdf)</source>
        <translation>Covaria 项目或报告 (*.covaria *.pdf)</translation>
    </message>
    <message>
        <source>About Covaria</source>
        <translation>关于 Covaria</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Covaria %1&lt;/h3&gt;&lt;p&gt;Measurement uncertainty of robots and large-scale metrology.&lt;br&gt;Evaluates by JCGM 100, 101 and 102.&lt;/p&gt;&lt;p&gt;Qt %2, VTK %3, Eigen %4&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Covaria %1&lt;/h3&gt;&lt;p&gt;机器人与大尺寸计量的测量不确定度。&lt;br&gt;按 JCGM 100、101 和 102 评定。&lt;/p&gt;&lt;p&gt;Qt %2, VTK %3, Eigen %4&lt;/p&gt;</translation>
    </message>
    <message>
        <source>symbol</source>
        <translation>符号</translation>
    </message>
    <message>
        <source>As the equations use it; further rows of a symbol add components</source>
        <translation>与方程中所用的一致；同一符号的后续行增加分量</translation>
    </message>
    <message>
        <source>quantity</source>
        <translation>量</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>它是什么</translation>
    </message>
    <message>
        <source>estimate</source>
        <translation>估计值</translation>
    </message>
    <message>
        <source>In the row&apos;s unit: 50.000 838 or 50.000 838 mm</source>
        <translation>以该行的单位表示：50.000 838 或 50.000 838 mm</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>stated as</source>
        <translation>给出方式</translation>
    </message>
    <message>
        <source>type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Type A or Type B evaluation (JCGM 100 2.3.2, 2.3.3)</source>
        <translation>A 类或 B 类评定（JCGM 100 2.3.2、2.3.3）</translation>
    </message>
    <message>
        <source>Degrees of freedom; empty: infinite, or those of the observations</source>
        <translation>自由度；留空：无穷大，或观测值的自由度</translation>
    </message>
    <message>
        <source>Standard uncertainty, in the row&apos;s unit</source>
        <translation>标准不确定度，以该行的单位表示</translation>
    </message>
    <message>
        <source>Sensitivity coefficient, unit of the result per unit of the row</source>
        <translation>灵敏系数，结果的单位除以该行的单位</translation>
    </message>
    <message>
        <source>Contribution to the standard uncertainty of the result</source>
        <translation>对结果标准不确定度的贡献</translation>
    </message>
    <message>
        <source>share / %</source>
        <translation>占比 / %</translation>
    </message>
    <message>
        <source>Share of the variance, with its part of the covariances</source>
        <translation>占方差的比例，含其协方差部分</translation>
    </message>
    <message>
        <source>source</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Where the figure comes from</source>
        <translation>数值的出处</translation>
    </message>
    <message>
        <source>Standard uncertainty of the position in space: square root of the sum of the variances of its three coordinates</source>
        <translation>空间位置的标准不确定度：三个坐标的方差之和的平方根</translation>
    </message>
    <message>
        <source>, as good as %1 plain trials</source>
        <translation>，相当于 %1 次普通试验</translation>
    </message>
    <message>
        <source>Preview by the law of propagation, without Monte Carlo</source>
        <translation>按传播律预览，不含蒙特卡洛</translation>
    </message>
    <message>
        <source>Preview with %1 trials, before the adaptive procedure</source>
        <translation>用 %1 次试验预览，先于自适应程序</translation>
    </message>
    <message>
        <source>Preview with %1 of %2 trials</source>
        <translation>用 %1 次试验预览，共 %2 次</translation>
    </message>
    <message>
        <source>Law of propagation of uncertainty</source>
        <translation>不确定度传播律</translation>
    </message>
    <message>
        <source>Monte Carlo, %1 trials</source>
        <translation>蒙特卡洛，%1 次试验</translation>
    </message>
    <message>
        <source>Out of date: of the project as it was</source>
        <translation>已过期：为项目之前的状态</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>创建 %1 的副本</translation>
    </message>
    <message>
        <source>Expanded uncertainty</source>
        <translation>扩展不确定度</translation>
    </message>
    <message>
        <source>the picture shows no result of the analysis</source>
        <translation>图中未显示该分析的结果</translation>
    </message>
    <message>
        <source>the coordinates of %1 are no quantities of the analysis</source>
        <translation>%1 的坐标不是该分析的量</translation>
    </message>
    <message>
        <source>%1 is a constant: no uncertainty is stated for it</source>
        <translation>%1 是常量：未给出其不确定度</translation>
    </message>
    <message>
        <source>the joint covariance of the points is not known</source>
        <translation>各点的联合协方差未知</translation>
    </message>
    <message>
        <source>the angle is too close to 0° or 180°, or the points are too close, for the law of propagation</source>
        <translation>角度过于接近 0° 或 180°，或点间距过近，传播律不适用</translation>
    </message>
    <message>
        <source>the points are too close to each other for the law of propagation</source>
        <translation>点间距过近，传播律不适用</translation>
    </message>
    <message>
        <source>%1, u = %2</source>
        <translation>%1, u = %2</translation>
    </message>
    <message>
        <source>Angle at %1 between %2 and %3: %4</source>
        <translation>%1 处 %2 与 %3 之间的角度：%4</translation>
    </message>
    <message>
        <source>Distance %1 to %2: %3</source>
        <translation>%1 到 %2 的距离：%3</translation>
    </message>
    <message>
        <source>; u not stated, because %1</source>
        <translation>；未给出 u，因为%1</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>等轴测</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>俯视</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>前视</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右视</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>仰视</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>后视</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左视</translation>
    </message>
    <message>
        <source>Add an analysis</source>
        <translation>添加分析</translation>
    </message>
    <message>
        <source>The plus sign in the toolbar adds what a project consists of. Choose Measurement equation from its menu.</source>
        <translation>工具栏中的加号用于添加项目的组成部分。从其菜单中选择“测量方程”。</translation>
    </message>
    <message>
        <source>Name the quantities</source>
        <translation>命名各个量</translation>
    </message>
    <message>
        <source>Replace the equation in the field Equations by yours, such as l = l_S + d. Every name that it uses becomes a row of the budget when you leave the field.</source>
        <translation>将“方程”字段中的方程换成您的方程，例如 l = l_S + d。离开该字段时，其中每个名称都成为预算的一行。</translation>
    </message>
    <message>
        <source>State an uncertainty</source>
        <translation>给出不确定度</translation>
    </message>
    <message>
        <source>Type the estimate of each quantity into its row, such as 50 mm, and what is known of it under “stated as”, such as 75 nm. “rect 30 nm” and “U = 0.3 um, k = 2” are read as they are typed.</source>
        <translation>在每个量的行中键入估计值，例如 50 mm，并在“给出方式”下键入已知信息，例如 75 nm。“rect 30 nm”和“U = 0.3 um, k = 2”按键入的形式读取。</translation>
    </message>
    <message>
        <source>See the result</source>
        <translation>查看结果</translation>
    </message>
    <message>
        <source>Correlate two quantities</source>
        <translation>使两个量相关</translation>
    </message>
    <message>
        <source>Select two rows of the budget, the second with Ctrl, and type their correlation coefficient r into the field below, such as 0.5. The result takes it into account at once.</source>
        <translation>选择预算的两行（第二行按住 Ctrl），并在下方字段中键入其相关系数 r，例如 0.5。结果会立即将其计入。</translation>
    </message>
    <message>
        <source>State a requirement</source>
        <translation>给出要求</translation>
    </message>
    <message>
        <source>Type the uncertainty that must not be exceeded as Target uncertainty. The verdict below it, and in the table of results, follows every change.</source>
        <translation>将不得超过的不确定度键入“目标不确定度”。其下方以及结果表中的结论随每次更改更新。</translation>
    </message>
    <message>
        <source>See what contributes most</source>
        <translation>查看贡献最大者</translation>
    </message>
    <message>
        <source>Keep and compare</source>
        <translation>保留并比较</translation>
    </message>
    <message>
        <source>Run the analysis (F5), press Keep as Before, and change a value of the budget. The tab Compare shows the results before and after beside each other.</source>
        <translation>运行分析 (F5)，按“保留为之前状态”，然后更改预算的一个值。“比较”标签页并排显示前后结果。</translation>
    </message>
    <message>
        <source>Look at the report</source>
        <translation>查看报告</translation>
    </message>
    <message>
        <source>Save it as PDF</source>
        <translation>另存为 PDF</translation>
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
        <translation># 快捷键

| 键 | 作用 |
|---|---|
| Ctrl+N、Ctrl+O、Ctrl+S | 新建、打开、保存 |
| Ctrl+Z；Ctrl+Shift+Z 或 Ctrl+Y | 撤销；重做 |
| F6、Shift+F6 | 下一窗格、上一窗格 |
| F11 | 仅显示预算或场景，再按返回 |
| 表格中的 Tab、Shift+Tab | 下一单元格、上一单元格，到最后一格后继续向外；加 Ctrl 立即离开表格 |
| 预算中的 Ctrl+R | 所选两行的相关系数 |
| F5、Ctrl+F5、Esc | 运行此分析、运行全部、停止 |
| F2、Ctrl+D、Delete | 重命名、创建副本、删除所选条目 |
| 方向键、+ 和 − | 旋转和缩放场景 |
| 1 至 7、F | 等轴测、俯视、前视、右视、仰视、后视、左视、适应窗口（任何位置：Ctrl+1 至 Ctrl+7） |
| H、I、Shift+H | 在场景中隐藏所选项、仅显示所选项、显示全部 |
| 在场景中拖动 | 移动对象，拖动轴端可旋转对象；按住 Ctrl 按整步进行 |
| D、A | 在场景中测量距离、角度；按 Esc 退出工具 |
| 报告中的 +、−、Ctrl+滚轮 | 放大、缩小页面；Alt+上、Alt+下：上一页、下一页 |
| Ctrl+C、Ctrl+V | 复制和粘贴单元格块 |
| Ctrl+K | 查找一切：分析、量、结果、字段、命令、帮助 |
| F1 | 当前焦点处的字段、单元格或条目的帮助 |
</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>撤销(&amp;U)：%1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>The analysis is not complete yet: what must still be given is listed under Problems.</source>
        <translation>分析尚不完整：还需给出的内容列在“问题”中。</translation>
    </message>
    <message>
        <source>The analysis has problems; they are listed under Problems.</source>
        <translation>分析存在问题，列在“问题”中。</translation>
    </message>
    <message>
        <source>Adaptive Monte Carlo, %1 trials</source>
        <translation>自适应蒙特卡洛，%1 次试验</translation>
    </message>
    <message>
        <source>; k leaves degrees of freedom out (normal draws)</source>
        <translation>；k 未计入自由度（正态抽样）</translation>
    </message>
    <message>
        <source>, chosen k = %1</source>
        <translation>，选定 k = %1</translation>
    </message>
    <message>
        <source>Of the estimate, and of what is stated without a unit</source>
        <translation>估计值以及未带单位的声明所用的单位</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>已撤销：%1</translation>
    </message>
    <message>
        <source>Before these steps</source>
        <translation>这些步骤之前</translation>
    </message>
    <message>
        <source>Undo Lis&amp;t</source>
        <translation>步骤列表(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>Done again: %1</source>
        <translation>已重做：%1</translation>
    </message>
    <message>
        <source>Type it as %1.</source>
        <translation>请写作 %1。</translation>
    </message>
    <message>
        <source>Type it as %1, or as %2.</source>
        <translation>请写作 %1 或 %2。</translation>
    </message>
    <message>
        <source>met</source>
        <translation>满足</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>不满足</translation>
    </message>
    <message>
        <source>The result is there when every quantity has its uncertainty, above the budget and in the tab Results. It follows every change at once.</source>
        <translation>每个量都有了不确定度后，结果即出现在预算上方和“结果”标签页中。任何更改都会立即反映到结果。</translation>
    </message>
    <message>
        <source>The tab Contributions has them as a table and as a chart, the largest first. What is at the top is worth improving.</source>
        <translation>“贡献”标签页以表格和图显示各贡献，最大的在前。排在最前的值得改进。</translation>
    </message>
    <message>
        <source>The tab Document shows the pages as they are printed, of the report or of the certificate. It has results that are up to date only: run the analysis first (F5).</source>
        <translation>“文档”标签页按打印的样子显示报告或证书的页面。其中只有最新的结果：请先运行分析 (F5)。</translation>
    </message>
    <message>
        <source>Report as PDF in the toolbar (Ctrl+P) writes the report with the project in it, so that Covaria can open it again. While the tab Document shows the certificate, the button writes that; it is also in the menu File under Export.</source>
        <translation>工具栏中的“报告为 PDF”(Ctrl+P) 写出报告，其中含有项目，因此 Covaria 可以再次打开它。“文档”标签页显示证书时，该按钮写出证书；它也在“文件”菜单的“导出”下。</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>已过期</translation>
    </message>
    <message>
        <source>Kept projects</source>
        <translation>保留的项目</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>以后</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>distr.</source>
        <translation>分布</translation>
    </message>
    <message>
        <source>Distribution that Monte Carlo draws</source>
        <translation>蒙特卡洛抽样所用的分布</translation>
    </message>
</context>
<context>
    <name>covaria::ui::AllResultsModel</name>
    <message>
        <source>Analysis</source>
        <translation>分析</translation>
    </message>
    <message>
        <source>Coverage interval of the result line</source>
        <translation>结果行的包含区间</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Double click: goes to the analysis</source>
        <translation>双击：转到该分析</translation>
    </message>
</context>
<context>
    <name>covaria::ui::AllResultsTab</name>
    <message>
        <source>Filter: analysis, symbol, name, group</source>
        <translation>筛选：分析、符号、名称、组</translation>
    </message>
    <message>
        <source>Filter of all results</source>
        <translation>全部结果的筛选</translation>
    </message>
    <message>
        <source>Not met only</source>
        <translation>仅显示不满足的</translation>
    </message>
    <message>
        <source>Only results whose target uncertainty or tolerance is not met</source>
        <translation>仅显示不满足目标不确定度或容差的结果</translation>
    </message>
    <message>
        <source>all-results</source>
        <translation>全部结果</translation>
    </message>
    <message>
        <source>up to date</source>
        <translation>最新</translation>
    </message>
    <message>
        <source>%1 of %2 requirements met</source>
        <translation>%2 项要求中满足 %1 项</translation>
    </message>
    <message>
        <source>%1 of %2 analyses have no result: press Ctrl+F5</source>
        <translation>%2 个分析中有 %1 个没有结果：请按 Ctrl+F5</translation>
    </message>
    <message>
        <source>; </source>
        <translation>; </translation>
    </message>
    <message>
        <source>%1 of %2 analyses have no result: they lack something or have problems</source>
        <translation>%2 个分析中有 %1 个没有结果：缺少内容或存在问题</translation>
    </message>
</context>
<context>
    <name>covaria::ui::AnswerStrip</name>
    <message>
        <source>Answer</source>
        <translation>答案</translation>
    </message>
    <message>
        <source>Output quantity of the budget and the charts</source>
        <translation>预算和图的输出量</translation>
    </message>
    <message>
        <source>Output quantity</source>
        <translation>输出量</translation>
    </message>
    <message>
        <source>Copy the result, as it stands in a certificate</source>
        <translation>按证书中的写法复制结果</translation>
    </message>
    <message>
        <source>Copy the result</source>
        <translation>复制结果</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>incomplete</source>
        <translation>不完整</translation>
    </message>
    <message>
        <source>has problems</source>
        <translation>有问题</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>已过期</translation>
    </message>
    <message>
        <source>not evaluated</source>
        <translation>未评定</translation>
    </message>
    <message>
        <source>Select an analysis to see its results.</source>
        <translation>选择一个分析以查看其结果。</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>失败：%1</translation>
    </message>
    <message>
        <source>Not complete yet: nothing is wrong.</source>
        <translation>尚不完整：没有错误。</translation>
    </message>
    <message>
        <source>Not complete yet, but not wrong; to give next: %1</source>
        <translation>尚不完整，但没有错误；接下来需给出：%1</translation>
    </message>
    <message>
        <source>Not evaluated yet: press F5.</source>
        <translation>尚未评定：请按 F5。</translation>
    </message>
    <message>
        <source>The analysis has problems.</source>
        <translation>分析有问题。</translation>
    </message>
    <message>
        <source>; running</source>
        <translation>；运行中</translation>
    </message>
    <message>
        <source>; press F5 for the result</source>
        <translation>；按 F5 得到结果</translation>
    </message>
    <message>
        <source>; %1 trials without a value</source>
        <translation>；%1 次试验没有值</translation>
    </message>
    <message>
        <source>&lt;b&gt;Does not represent the measurand&lt;/b&gt; (more than 1 % of the trials are lost). </source>
        <translation>&lt;b&gt;不能代表被测量&lt;/b&gt;（损失的试验超过 1 %）。 </translation>
    </message>
    <message>
        <source>; not stabilised</source>
        <translation>；未稳定</translation>
    </message>
    <message>
        <source>&lt;b&gt;Out of date&lt;/b&gt;: shown for the project as it was. </source>
        <translation>&lt;b&gt;已过期&lt;/b&gt;：显示的是项目之前的状态。 </translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>下一步：%1</translation>
    </message>
    <message>
        <source>Goes to the field that must be given next</source>
        <translation>转到下一个必须给出的字段</translation>
    </message>
    <message>
        <source>Show the Field</source>
        <translation>显示字段</translation>
    </message>
</context>
<context>
    <name>covaria::ui::AssetEvaluation</name>
    <message>
        <source>The asset has problems; they are listed below the scene.</source>
        <translation>该资源有问题；列于场景下方。</translation>
    </message>
    <message>
        <source>This asset is used as it is specified; nothing is evaluated.</source>
        <translation>该资源按其技术指标使用；不作评定。</translation>
    </message>
    <message>
        <source>Evaluation of the asset</source>
        <translation>资源的评定</translation>
    </message>
</context>
<context>
    <name>covaria::ui::BudgetFootModel</name>
    <message>
        <source>Out of date: being computed.</source>
        <translation>已过期：正在计算。</translation>
    </message>
    <message>
        <source>Combined standard uncertainty by the law of propagation</source>
        <translation>按传播律的合成标准不确定度</translation>
    </message>
</context>
<context>
    <name>covaria::ui::BudgetPage</name>
    <message>
        <source>Budget</source>
        <translation>预算</translation>
    </message>
    <message>
        <source>Correlation of Two Rows</source>
        <translation>两行的相关性</translation>
    </message>
    <message>
        <source>c and share by the law of propagation, whose u is %1 of that by Monte Carlo</source>
        <translation>c 和占比按传播律，其 u 为蒙特卡洛 u 的 %1</translation>
    </message>
    <message>
        <source>Result of the budget</source>
        <translation>预算的结果</translation>
    </message>
</context>
<context>
    <name>covaria::ui::BudgetSheetModel</name>
    <message>
        <source>Out of date: being computed.</source>
        <translation>已过期：正在计算。</translation>
    </message>
    <message>
        <source>Type a name here to add a quantity</source>
        <translation>在此输入名称以添加量</translation>
    </message>
    <message>
        <source>“%1” is not a number of degrees of freedom.</source>
        <translation>“%1”不是自由度。</translation>
    </message>
    <message>
        <source>Name the quantity before its observations.</source>
        <translation>请先给该量一个符号，再键入其观测值。</translation>
    </message>
    <message>
        <source>The observations are read from %1.</source>
        <translation>观测值从 %1 读取。</translation>
    </message>
    <message>
        <source>type or paste rows</source>
        <translation>键入或粘贴行</translation>
    </message>
</context>
<context>
    <name>covaria::ui::BudgetSheetView</name>
    <message>
        <source>Show Quantity</source>
        <translation>显示量</translation>
    </message>
    <message>
        <source>Its components, observations, correlations and notes</source>
        <translation>其分量、观测值、相关性和附注</translation>
    </message>
</context>
<context>
    <name>covaria::ui::BudgetTableModel</name>
    <message>
        <source>An estimate by sampling with a standard error of %1 %: S can exceed S total by chance</source>
        <translation>抽样估计值，标准误差为 %1 %：S 可能偶然大于总 S</translation>
    </message>
</context>
<context>
    <name>covaria::ui::CertificateForm</name>
    <message>
        <source>Required by %1.</source>
        <translation>%1 要求。</translation>
    </message>
    <message>
        <source>Asked for by %1 where it applies.</source>
        <translation>%1 在适用时要求。</translation>
    </message>
    <message>
        <source>Next Missing</source>
        <translation>下一个缺项</translation>
    </message>
    <message>
        <source>What the certificate lacks</source>
        <translation>证书缺少的内容</translation>
    </message>
    <message>
        <source>Goes to the next field that %1 requires and that is empty</source>
        <translation>转到 %1 要求且为空的下一个字段</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>更改%1</translation>
    </message>
    <message>
        <source>Everything that %1 requires beside the results is stated.</source>
        <translation>%1 要求的结果以外的内容均已给出。</translation>
    </message>
    <message>
        <source>For File › Export › Certificate. A clause of %1 stands where it requires something; a report needs none of it.</source>
        <translation>用于“文件 › 导出 › 证书”。有要求之处标有 %1 的条款；报告不需要这些内容。</translation>
    </message>
    <message>
        <source>%1 of %2 required texts are stated; missing: %3.</source>
        <translation>要求的 %2 项文本中已给出 %1 项；缺少：%3。</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg)</source>
        <translation>图片 (*.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>English (none chosen)</source>
        <translation>英语（未选择）</translation>
    </message>
    <message>
        <source>Required by %1 where conformity is stated.</source>
        <translation>声明符合性时 %1 要求。</translation>
    </message>
    <message>
        <source>in the laboratory, or at the place stated</source>
        <translation>在实验室，或在给出的地点</translation>
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
        <translation>运行分析以查看此图</translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation>%1 文件 (*.%2)</translation>
    </message>
    <message>
        <source>Save Chart</source>
        <translation>保存图</translation>
    </message>
    <message>
        <source>Show All</source>
        <translation>显示全部</translation>
    </message>
    <message>
        <source>Copy Picture</source>
        <translation>复制图片</translation>
    </message>
    <message>
        <source>Copy Data</source>
        <translation>复制数据</translation>
    </message>
    <message>
        <source>Save as %1 …</source>
        <translation>保存为 %1 …</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ColumnTableModel</name>
    <message>
        <source>Out of date: the project has changed since.</source>
        <translation>已过期：项目此后已更改。</translation>
    </message>
</context>
<context>
    <name>covaria::ui::CompareTab</name>
    <message>
        <source>Keep as Before</source>
        <translation>保留为之前状态</translation>
    </message>
    <message>
        <source>Keeps the present results of this analysis, to compare later ones with</source>
        <translation>保留此分析的当前结果，以便与后来的结果比较</translation>
    </message>
    <message>
        <source>Go Back to Kept State</source>
        <translation>返回保留的状态</translation>
    </message>
    <message>
        <source>Discard Kept State</source>
        <translation>放弃保留的状态</translation>
    </message>
    <message>
        <source>Forgets the kept results; the project stays as it is now</source>
        <translation>丢弃保留的结果；项目保持现状</translation>
    </message>
    <message>
        <source>comparison</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>budget-changes</source>
        <translation>预算变化</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>图</translation>
    </message>
    <message>
        <source>Distributions</source>
        <translation>分布</translation>
    </message>
    <message>
        <source>Changes of the budget</source>
        <translation>预算的变化</translation>
    </message>
    <message>
        <source>The results are kept: the tab Compare shows them beside those to come.</source>
        <translation>结果已保留：“比较”标签页将其与以后的结果并列显示。</translation>
    </message>
    <message>
        <source>Go back to kept state</source>
        <translation>返回保留的状态</translation>
    </message>
    <message>
        <source>Select an analysis to compare its results.</source>
        <translation>选择一个分析以比较其结果。</translation>
    </message>
    <message>
        <source>Before: %1, kept at %2. </source>
        <translation>之前：%1，保留于 %2。 </translation>
    </message>
    <message>
        <source>After: no results.</source>
        <translation>之后：无结果。</translation>
    </message>
    <message>
        <source>After: %1</source>
        <translation>之后：%1</translation>
    </message>
    <message>
        <source>Go Back to Kept</source>
        <translation>返回保留状态</translation>
    </message>
    <message>
        <source>Discard Kept</source>
        <translation>放弃保留状态</translation>
    </message>
    <message>
        <source>The present results are kept in place of those kept before.</source>
        <translation>当前结果已代替先前保留的结果。</translation>
    </message>
    <message>
        <source>Replace Kept State</source>
        <translation>替换保留的状态</translation>
    </message>
    <message>
        <source>Keeps the present results in place of those kept before, which are forgotten</source>
        <translation>保留当前结果以代替先前保留的结果，先前的将被丢弃</translation>
    </message>
    <message>
        <source>Run the analysis (F5), then keep its results with “%1”.</source>
        <translation>运行分析 (F5)，然后用“%1”保留其结果。</translation>
    </message>
    <message>
        <source>results that are computed again once the analysis has run</source>
        <translation>待分析运行后重新计算的结果</translation>
    </message>
    <message>
        <source>Compare With Another Project</source>
        <translation>与其他项目比较</translation>
    </message>
    <message>
        <source>Covaria project (*.covaria)</source>
        <translation>Covaria 项目 (*.covaria)</translation>
    </message>
    <message>
        <source>Analysis of that project:</source>
        <translation>该项目的分析：</translation>
    </message>
    <message>
        <source>Compare With</source>
        <translation>比较对象</translation>
    </message>
    <message>
        <source>Another analysis, of this project or of another one, stands in the place of kept results</source>
        <translation>另一个分析（本项目或其他项目的）代替保留的结果</translation>
    </message>
    <message>
        <source>Another Project …</source>
        <translation>其他项目…</translation>
    </message>
    <message>
        <source>%1 has no analysis.</source>
        <translation>%1 中没有分析。</translation>
    </message>
    <message>
        <source>The tab Compare shows %1 as before.</source>
        <translation>“比较”页将 %1 显示为之前。</translation>
    </message>
    <message>
        <source>Keep the present results with “%1” and edit, or choose another analysis by “%2”: before and after stand here beside each other.</source>
        <translation>用“%1”保留当前结果再编辑，或用“%2”选择另一个分析：之前与之后在此并列显示。</translation>
    </message>
    <message>
        <source>Before: %1 (%2), taken at %3. </source>
        <translation>之前：%1（%2），取自 %3。 </translation>
    </message>
    <message>
        <source>Makes the analysis, and what it uses, what they were when the results were kept, and the coverage factor of the project; can be undone</source>
        <translation>使分析、其所用的内容和项目的包含因子恢复到保留结果时的样子；可以撤销</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ComponentsEdit</name>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>重置</translation>
    </message>
    <message>
        <source>Components of uncertainty</source>
        <translation>不确定度分量</translation>
    </message>
    <message>
        <source>Name of the component</source>
        <translation>分量名称</translation>
    </message>
    <message>
        <source>Type of evaluation</source>
        <translation>评定类型</translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation>自由度</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Back to the components that the model gives</source>
        <translation>恢复模型给出的分量</translation>
    </message>
    <message>
        <source>Type A (from observations)</source>
        <translation>A 类（由观测值）</translation>
    </message>
    <message>
        <source>Type B (other means)</source>
        <translation>B 类（其他方法）</translation>
    </message>
    <message>
        <source>Degrees of freedom of the standard uncertainty; empty: infinitely many.</source>
        <translation>标准不确定度的自由度；留空：无穷大。</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Change component of %1</source>
        <translation>更改 %1 的分量</translation>
    </message>
    <message>
        <source>component %1</source>
        <translation>分量 %1</translation>
    </message>
    <message>
        <source>Add component to %1</source>
        <translation>为 %1 添加分量</translation>
    </message>
    <message>
        <source>Remove component of %1</source>
        <translation>移除 %1 的分量</translation>
    </message>
    <message>
        <source>Reset components of %1</source>
        <translation>重置 %1 的分量</translation>
    </message>
    <message>
        <source>Its uncertainty comes from another analysis.</source>
        <translation>其不确定度来自另一个分析。</translation>
    </message>
    <message>
        <source>Components that it shares with other quantities are edited where they are stated.</source>
        <translation>与其他量共有的分量在其给出处编辑。</translation>
    </message>
    <message>
        <source>It has no component of uncertainty yet.</source>
        <translation>尚无不确定度分量。</translation>
    </message>
</context>
<context>
    <name>covaria::ui::CorrelationEdit</name>
    <message>
        <source>Add to the matrix</source>
        <translation>添加到矩阵</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Correlation coefficients between components of uncertainty</source>
        <translation>不确定度分量之间的相关系数</translation>
    </message>
    <message>
        <source>Component of uncertainty</source>
        <translation>不确定度分量</translation>
    </message>
    <message>
        <source>All components are uncorrelated. Add those that are correlated to the matrix.</source>
        <translation>所有分量均不相关。将相关的分量添加到矩阵。</translation>
    </message>
    <message>
        <source>The coefficients are possible together (positive semi-definite). Monte Carlo draws them with a Gaussian copula: exact for normal distributions, nearly so for others.</source>
        <translation>这些系数可以同时成立（半正定）。蒙特卡洛用高斯 copula 抽样：对正态分布精确，对其他分布近似精确。</translation>
    </message>
</context>
<context>
    <name>covaria::ui::CorrelationTableModel</name>
    <message>
        <source>Correlation of %1 with %2</source>
        <translation>%1 与 %2 的相关性</translation>
    </message>
</context>
<context>
    <name>covaria::ui::CsvImportDialog</name>
    <message>
        <source>Import %1 into %2</source>
        <translation>将 %1 导入%2</translation>
    </message>
    <message>
        <source>found by itself</source>
        <translation>自动识别</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>逗号</translation>
    </message>
    <message>
        <source>semicolon</source>
        <translation>分号</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>制表符</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>&amp;Separator of cells</source>
        <translation>单元格分隔符(&amp;S)</translation>
    </message>
    <message>
        <source>Column of the file</source>
        <translation>文件的列</translation>
    </message>
    <message>
        <source>is read as</source>
        <translation>读作</translation>
    </message>
    <message>
        <source>Columns of the file</source>
        <translation>文件的各列</translation>
    </message>
    <message>
        <source>Column %1 is read as</source>
        <translation>第 %1 列读作</translation>
    </message>
    <message>
        <source>as it is named</source>
        <translation>按其名称</translation>
    </message>
    <message>
        <source>unknown: choose</source>
        <translation>未知：请选择</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>不读取</translation>
    </message>
    <message>
        <source>The file cannot be imported: %1.</source>
        <translation>无法导入该文件：%1。</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>第 %1 行：%2</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s).</source>
        <translation>
            <numerusform>%n 行。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more problem(s).</source>
        <translation>
            <numerusform>另有 %n 个问题。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>covaria::ui::DateEditor</name>
    <message>
        <source>to</source>
        <translation>至</translation>
    </message>
    <message>
        <source>%1, last day</source>
        <translation>%1，最后一天</translation>
    </message>
    <message>
        <source>Choose from a calendar</source>
        <translation>从日历中选择</translation>
    </message>
    <message>
        <source>“%1” is no date of the form 2026-04-17.</source>
        <translation>“%1”不是 2026-04-17 形式的日期。</translation>
    </message>
    <message>
        <source>The first day is missing.</source>
        <translation>缺少第一天。</translation>
    </message>
    <message>
        <source>The last day is before the first.</source>
        <translation>最后一天早于第一天。</translation>
    </message>
    <message>
        <source>the same day</source>
        <translation>同一天</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DensityPicture</name>
    <message>
        <source>Density of the distribution</source>
        <translation>分布的密度</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DesignBoxList</name>
    <message>
        <source>Add Box</source>
        <translation>添加长方体</translation>
    </message>
    <message>
        <source>To, %1</source>
        <translation>到，%1</translation>
    </message>
    <message>
        <source>From, %1</source>
        <translation>从，%1</translation>
    </message>
    <message>
        <source>Name of the box</source>
        <translation>长方体名称</translation>
    </message>
    <message>
        <source>name, such as pillar</source>
        <translation>名称，例如立柱</translation>
    </message>
    <message>
        <source>Remove Box</source>
        <translation>移除长方体</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>To</source>
        <translation>到</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DesignReductionList</name>
    <message>
        <source>Add Reduction</source>
        <translation>添加减小项</translation>
    </message>
    <message>
        <source>One more uncertainty that can be made smaller for money</source>
        <translation>再增加一个可花钱减小的不确定度</translation>
    </message>
    <message>
        <source>Smallest factor</source>
        <translation>最小因子</translation>
    </message>
    <message>
        <source>The smallest factor that can be had, between 0 and 1</source>
        <translation>可达到的最小因子，在 0 和 1 之间</translation>
    </message>
    <message>
        <source>Price of the first halving</source>
        <translation>首次减半的价格</translation>
    </message>
    <message>
        <source>Law of the price</source>
        <translation>价格规律</translation>
    </message>
    <message>
        <source>price (1/f − 1)</source>
        <translation>价格 (1/f − 1)</translation>
    </message>
    <message>
        <source>price (1/f² − 1)/3: further readings</source>
        <translation>价格 (1/f² − 1)/3：增加读数</translation>
    </message>
    <message>
        <source>price log₂(1/f): every halving the same</source>
        <translation>价格 log₂(1/f)：每次减半相同</translation>
    </message>
    <message>
        <source>Remove Reduction</source>
        <translation>移除减小项</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>被减小的量</translation>
    </message>
    <message>
        <source>Least factor</source>
        <translation>最小因子</translation>
    </message>
    <message>
        <source>First halving</source>
        <translation>首次减半</translation>
    </message>
    <message>
        <source>A factor f costs</source>
        <translation>因子 f 的成本</translation>
    </message>
    <message>
        <source>choose what is reduced</source>
        <translation>选择要减小的量</translation>
    </message>
    <message>
        <source>Reductions</source>
        <translation>减小项</translation>
    </message>
    <message>
        <source>Each has a price; they take the place of variables and rows.</source>
        <translation>每项都有价格；它们代替变量和行。</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DesignTab</name>
    <message>
        <source>Design</source>
        <translation>设计</translation>
    </message>
    <message>
        <source>Design of this analysis</source>
        <translation>此分析的设计</translation>
    </message>
    <message>
        <source>Run Design</source>
        <translation>运行设计</translation>
    </message>
    <message>
        <source>Searches for the best design</source>
        <translation>搜索最佳设计</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stops the search (Esc)</source>
        <translation>停止搜索 (Esc)</translation>
    </message>
    <message>
        <source>Edit …</source>
        <translation>编辑 …</translation>
    </message>
    <message>
        <source>Variables, rows and objective of the design, in the properties of the analysis</source>
        <translation>设计的变量、行和目标函数，在分析的属性中</translation>
    </message>
    <message>
        <source>Take Over This Design</source>
        <translation>采用此设计</translation>
    </message>
    <message>
        <source>Puts the values and rows that were found into the project; can be undone</source>
        <translation>将找到的值和行写入项目；可以撤销</translation>
    </message>
    <message>
        <source>Add Design …</source>
        <translation>添加设计 …</translation>
    </message>
    <message>
        <source> – out of date</source>
        <translation> – 已过期</translation>
    </message>
    <message>
        <source>%1 of %2 evaluations</source>
        <translation>%1 / %2 次评定</translation>
    </message>
    <message>
        <source>, best so far %1</source>
        <translation>，目前最佳 %1</translation>
    </message>
    <message>
        <source>searching …</source>
        <translation>正在搜索 …</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>失败：%1</translation>
    </message>
    <message>
        <source>Not searched yet.</source>
        <translation>尚未搜索。</translation>
    </message>
    <message>
        <source>Nothing that was tried has a result.</source>
        <translation>所尝试的均无结果。</translation>
    </message>
    <message>
        <source>The cheapest reductions cost %1</source>
        <translation>成本最低的减小项：成本 %1</translation>
    </message>
    <message>
        <source>The cheapest rows cost %1</source>
        <translation>成本最低的行：成本 %1</translation>
    </message>
    <message>
        <source>, before %1</source>
        <translation>，之前 %1</translation>
    </message>
    <message>
        <source>; &lt;b&gt;the target of U(%1) is not met&lt;/b&gt;</source>
        <translation>；&lt;b&gt;不满足 U(%1) 的目标值&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Out of date&lt;/b&gt;: shown for the project as it was. </source>
        <translation>&lt;b&gt;已过期&lt;/b&gt;：显示的是项目之前的状态。 </translation>
    </message>
    <message>
        <source>Take over design</source>
        <translation>采用设计</translation>
    </message>
    <message>
        <source>“%1” shows the best that can be done with what the design may choose.</source>
        <translation>“%1”可查看在设计可选范围内所能达到的最佳结果。</translation>
    </message>
    <message>
        <source>A design finds where to stand and what to measure: add one with “%1”.</source>
        <translation>设计用于找出设站位置和测量内容：请用“%1”添加一个。</translation>
    </message>
    <message>
        <source> (law of propagation)</source>
        <translation> （传播律）</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DesignsForm</name>
    <message>
        <source>Design</source>
        <translation>设计</translation>
    </message>
    <message>
        <source>Adds a design of this analysis</source>
        <translation>添加此分析的一个设计</translation>
    </message>
    <message>
        <source>Adds a copy of this design</source>
        <translation>添加此设计的副本</translation>
    </message>
    <message>
        <source>Deletes this design</source>
        <translation>删除此设计</translation>
    </message>
    <message>
        <source>Searches for the best design</source>
        <translation>搜索最佳设计</translation>
    </message>
    <message>
        <source>A design finds where to stand and what to measure: the numbers and the rows of the set-up that make the uncertainties smallest. Add one to let Covaria search.</source>
        <translation>设计用于找出设站位置和测量内容：使不确定度最小的设置值和表行。添加一个设计，让 Covaria 搜索。</translation>
    </message>
    <message>
        <source>Add Variable</source>
        <translation>添加变量</translation>
    </message>
    <message>
        <source>One more number that may be chosen</source>
        <translation>再增加一个可选择的数值</translation>
    </message>
    <message>
        <source>Name of the design</source>
        <translation>设计名称</translation>
    </message>
    <message>
        <source>Objective</source>
        <translation>目标函数</translation>
    </message>
    <message>
        <source>What is made smallest of the ratios of U to the target uncertainties; without targets to U of the present design</source>
        <translation>在 U 与目标不确定度之比中使哪一个最小；没有目标值时，取与当前设计的 U 之比</translation>
    </message>
    <message>
        <source>Largest ratio</source>
        <translation>最大比值</translation>
    </message>
    <message>
        <source>Mean of the ratios</source>
        <translation>比值的平均值</translation>
    </message>
    <message>
        <source>Root mean square of the ratios</source>
        <translation>比值的均方根</translation>
    </message>
    <message>
        <source>Cost of the rows, with all targets met</source>
        <translation>行的成本，且满足所有目标值</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>最小化</translation>
    </message>
    <message>
        <source>Output quantities of the design</source>
        <translation>设计的输出量</translation>
    </message>
    <message>
        <source>Output quantities looked at; with none ticked, all with a target uncertainty, or all measurands</source>
        <translation>所考察的输出量；均未勾选时，为所有带目标不确定度的输出量，或所有被测量</translation>
    </message>
    <message>
        <source>Outputs (none ticked: all with a target, or all measurands)</source>
        <translation>输出量（均未勾选：所有带目标值的，或所有被测量）</translation>
    </message>
    <message>
        <source>Rows to choose from</source>
        <translation>可选的行</translation>
    </message>
    <message>
        <source>Table to choose from</source>
        <translation>可选的表</translation>
    </message>
    <message>
        <source>Rows to keep</source>
        <translation>保留的行数</translation>
    </message>
    <message>
        <source>File of candidates</source>
        <translation>候选文件</translation>
    </message>
    <message>
        <source>A CSV file beside the project with further rows; may be empty</source>
        <translation>与项目并存的含其他行的 CSV 文件；可为空</translation>
    </message>
    <message>
        <source>Rows that stay</source>
        <translation>固定保留的行</translation>
    </message>
    <message>
        <source>Ticked rows stay in any case</source>
        <translation>勾选的行无论如何都保留</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation>候选项</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>固定</translation>
    </message>
    <message>
        <source>Prices</source>
        <translation>价格</translation>
    </message>
    <message>
        <source>Starts</source>
        <translation>起点数</translation>
    </message>
    <message>
        <source>Evaluations at most</source>
        <translation>最多评定次数</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>种子</translation>
    </message>
    <message>
        <source>Least distance</source>
        <translation>最小距离</translation>
    </message>
    <message>
        <source>Between instruments, and of them from all other points</source>
        <translation>仪器之间，以及仪器与所有其他点之间</translation>
    </message>
    <message>
        <source>Keep out of</source>
        <translation>禁入区域</translation>
    </message>
    <message>
        <source>No instrument stands in this box</source>
        <translation>此长方体内不放置仪器</translation>
    </message>
    <message>
        <source>Lines of sight are hidden by</source>
        <translation>视线遮挡物</translation>
    </message>
    <message>
        <source>No line of sight passes this box</source>
        <translation>视线不穿过此长方体</translation>
    </message>
    <message>
        <source>Prices of the rows</source>
        <translation>各行的价格</translation>
    </message>
    <message>
        <source>one for all rows, or one for each: 120; 80; 95</source>
        <translation>所有行一个，或每行一个：120; 80; 95</translation>
    </message>
    <message>
        <source>What the rows cost, separated by semicolons; needed where the cost is to be small</source>
        <translation>各行的成本，用分号分隔；要求成本小时需要</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no number; separate prices by semicolons</source>
        <translation>&apos;%1&apos; 不是数字；请用分号分隔价格</translation>
    </message>
    <message>
        <source>Of the random starts: a whole number from 0 to 18446744073709551615</source>
        <translation>随机起点的种子：0 至 18446744073709551615 的整数</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DistributionEdit</name>
    <message>
        <source>Distribution</source>
        <translation>分布</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Probabilities</source>
        <translation>概率</translation>
    </message>
    <message>
        <source>numbers with ; between</source>
        <translation>以 ; 分隔的数值</translation>
    </message>
    <message>
        <source>“%1” are not all numbers.</source>
        <translation>“%1”不全是数字。</translation>
    </message>
    <message>
        <source>There must be as many probabilities as values.</source>
        <translation>概率的个数必须与值的个数相同。</translation>
    </message>
    <message>
        <source>This distribution has no finite standard uncertainty.</source>
        <translation>该分布没有有限的标准不确定度。</translation>
    </message>
    <message>
        <source>Monte Carlo draws: %1, ν = %2</source>
        <translation>蒙特卡洛抽样所用：%1，ν = %2</translation>
    </message>
    <message>
        <source>Edges of the cells</source>
        <translation>单元的边界</translation>
    </message>
    <message>
        <source>There must be one edge more than probabilities.</source>
        <translation>边界必须比概率多一个。</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DockTitle</name>
    <message>
        <source>Float or dock</source>
        <translation>浮动或停靠</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>covaria::ui::Document</name>
    <message>
        <source>Change the requirement for %1</source>
        <translation>更改对 %1 的要求</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>未命名</translation>
    </message>
    <message>
        <source>%1 (from %2)</source>
        <translation>%1（来自 %2）</translation>
    </message>
    <message>
        <source>The project has no file yet: choose a name for it.</source>
        <translation>项目尚无文件：请为其选择名称。</translation>
    </message>
    <message>
        <source> (copy)</source>
        <translation> （副本）</translation>
    </message>
    <message>
        <source>Add study</source>
        <translation>添加参数研究</translation>
    </message>
    <message>
        <source>Duplicate study</source>
        <translation>创建参数研究副本</translation>
    </message>
    <message>
        <source>Delete study</source>
        <translation>删除参数研究</translation>
    </message>
    <message>
        <source>Change study</source>
        <translation>更改参数研究</translation>
    </message>
    <message>
        <source>Study %1</source>
        <translation>参数研究 %1</translation>
    </message>
    <message>
        <source>Add design</source>
        <translation>添加设计</translation>
    </message>
    <message>
        <source>Duplicate design</source>
        <translation>创建设计副本</translation>
    </message>
    <message>
        <source>Delete design</source>
        <translation>删除设计</translation>
    </message>
    <message>
        <source>Change design</source>
        <translation>更改设计</translation>
    </message>
    <message>
        <source>Design %1</source>
        <translation>设计 %1</translation>
    </message>
    <message>
        <source>the project</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>重命名 %1</translation>
    </message>
    <message>
        <source>Change notes of %1</source>
        <translation>更改 %1 的附注</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>删除 %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>移动 %1</translation>
    </message>
    <message>
        <source>Take %1 from an analysis</source>
        <translation>从分析中取 %1</translation>
    </message>
    <message>
        <source>Remove the link of %1</source>
        <translation>移除 %1 的链接</translation>
    </message>
    <message>
        <source>Another program has changed the file since it was read.</source>
        <translation>自读取以来，另一个程序更改了该文件。</translation>
    </message>
    <message>
        <source>Change the requirements for %1 results</source>
        <translation>更改对 %1 个结果的要求</translation>
    </message>
</context>
<context>
    <name>covaria::ui::EmptyProject</name>
    <message>
        <source>Empty project</source>
        <translation>空项目</translation>
    </message>
    <message>
        <source>What is to be evaluated?</source>
        <translation>要评定什么？</translation>
    </message>
    <message>
        <source>&amp;Library and Templates …</source>
        <translation>库和模板(&amp;L) …</translation>
    </message>
</context>
<context>
    <name>covaria::ui::EquationsView</name>
    <message>
        <source>Equations</source>
        <translation>方程</translation>
    </message>
</context>
<context>
    <name>covaria::ui::EvaluationTab</name>
    <message>
        <source>Evaluation of the set-up</source>
        <translation>测量设置的评定</translation>
    </message>
</context>
<context>
    <name>covaria::ui::EvaluationView</name>
    <message>
        <source>Tables of the evaluation</source>
        <translation>评定的表格</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>图</translation>
    </message>
    <message>
        <source>Which chart of the evaluation is shown</source>
        <translation>显示评定的哪个图</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ExportActions</name>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>PDF 文档 (*.pdf)</translation>
    </message>
    <message>
        <source>HTML page (*.html)</source>
        <translation>HTML 页面 (*.html)</translation>
    </message>
    <message>
        <source>Markdown text (*.md)</source>
        <translation>Markdown 文本 (*.md)</translation>
    </message>
    <message>
        <source>Report as &amp;PDF …</source>
        <translation>报告为 PDF(&amp;P) …</translation>
    </message>
    <message>
        <source>&amp;Certificate as PDF …</source>
        <translation>证书为 PDF(&amp;C) …</translation>
    </message>
    <message>
        <source>Report as &amp;HTML …</source>
        <translation>报告为 HTML(&amp;H) …</translation>
    </message>
    <message>
        <source>Report as &amp;Markdown …</source>
        <translation>报告为 Markdown(&amp;M) …</translation>
    </message>
    <message>
        <source>&amp;Results and Tables (JSON, CSV) …</source>
        <translation>结果和表格 (JSON, CSV) (&amp;R) …</translation>
    </message>
    <message>
        <source> …</source>
        <translation> …</translation>
    </message>
    <message>
        <source>No results yet</source>
        <translation>尚无结果</translation>
    </message>
    <message>
        <source>The export waits until the analyses have run</source>
        <translation>导出将等待各分析运行完毕</translation>
    </message>
    <message>
        <source>, without %1: not up to date</source>
        <translation>，不含 %1：未更新</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Export Report</source>
        <translation>导出报告</translation>
    </message>
    <message>
        <source>The certificate does not state what ISO/IEC 17025 requires of it:

%1

It says “not stated” in these places. They are fields of the project&apos;s page.</source>
        <translation>证书未给出 ISO/IEC 17025 所要求的内容：

%1

这些位置将写为“未给出”。它们是项目页面的字段。</translation>
    </message>
    <message>
        <source>Export Anyway</source>
        <translation>仍然导出</translation>
    </message>
    <message>
        <source>Export Certificate</source>
        <translation>导出证书</translation>
    </message>
    <message>
        <source>Export Results and Tables into the Folder of</source>
        <translation>将结果和表格导出到所选文件的文件夹</translation>
    </message>
    <message>
        <source>Results (results.json)</source>
        <translation>结果 (results.json)</translation>
    </message>
    <message>
        <source>%1: what it must state is missing</source>
        <translation>%1：缺少必须给出的内容</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>导出 %1</translation>
    </message>
    <message>
        <source>%1 (*%2)</source>
        <translation>%1 (*%2)</translation>
    </message>
    <message>
        <source>A report is being written; wait until it is finished</source>
        <translation>正在写报告；请等待其完成</translation>
    </message>
    <message>
        <source>Writing %1 …</source>
        <translation>正在写入 %1 …</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>已写入 %1</translation>
    </message>
    <message>
        <source>The export failed</source>
        <translation>导出失败</translation>
    </message>
    <message>
        <source>No analysis can be run: each one is incomplete or has errors.</source>
        <translation>没有可以运行的分析：每个分析都不完整或有错误。</translation>
    </message>
    <message>
        <source>Ex&amp;port</source>
        <translation>导出(&amp;P)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FieldEditor</name>
    <message>
        <source>From %1 to %2.</source>
        <translation>从 %1 到 %2。</translation>
    </message>
    <message>
        <source>More than %1.</source>
        <translation>大于 %1。</translation>
    </message>
    <message>
        <source>At least %1.</source>
        <translation>不小于 %1。</translation>
    </message>
    <message>
        <source>At most %1.</source>
        <translation>不大于 %1。</translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation>%1 文件</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FieldHelp</name>
    <message>
        <source>Help on the field</source>
        <translation>字段帮助</translation>
    </message>
    <message>
        <source>Numbers may be typed with another unit (%1); the arrow keys change the last digit.</source>
        <translation>数值可以用其他单位输入（%1）；方向键改变最后一位数字。</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FigureSourcesForm</name>
    <message>
        <source>certificate %1, not named yet</source>
        <translation>证书 %1，尚未命名</translation>
    </message>
    <message>
        <source>Analyses in which it is applicable: %1.</source>
        <translation>在 %1 个分析中适用。</translation>
    </message>
    <message>
        <source>No analysis uses these figures.</source>
        <translation>没有分析使用这些数值。</translation>
    </message>
    <message>
        <source>Change the date of the measurement</source>
        <translation>更改测量日期</translation>
    </message>
    <message>
        <source>Certificate of the figures</source>
        <translation>数值的证书</translation>
    </message>
    <message>
        <source>Adds a certificate that figures come from</source>
        <translation>添加数值所出自的证书</translation>
    </message>
    <message>
        <source>Removes this certificate</source>
        <translation>移除此证书</translation>
    </message>
    <message>
        <source>Takes name and digest of the certificate&apos;s file</source>
        <translation>取证书文件的名称和摘要</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>种类</translation>
    </message>
    <message>
        <source>Change the kind of a certificate</source>
        <translation>更改证书的种类</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>更改%1</translation>
    </message>
    <message>
        <source>Add a certificate</source>
        <translation>添加证书</translation>
    </message>
    <message>
        <source>Remove a certificate</source>
        <translation>移除证书</translation>
    </message>
    <message>
        <source>File of the Certificate</source>
        <translation>证书文件</translation>
    </message>
    <message>
        <source>Take the file of a certificate</source>
        <translation>取证书文件</translation>
    </message>
    <message>
        <source>These figures are assumed: no certificate states them.</source>
        <translation>这些数值为假定值：没有证书给出它们。</translation>
    </message>
    <message>
        <source>No certificate states the figures of this set-up.</source>
        <translation>没有证书给出此测量设置的数值。</translation>
    </message>
    <message>
        <source>Date of the measurement</source>
        <translation>测量日期</translation>
    </message>
    <message>
        <source>A date, or two of an interval; empty: that of the project&apos;s certificate.</source>
        <translation>一个日期，或表示期间的两个日期；留空：项目证书的日期。</translation>
    </message>
    <message>
        <source>Shows what hangs on this certificate</source>
        <translation>显示取决于此证书的内容</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FileActions</name>
    <message>
        <source>line %1: </source>
        <translation>第 %1 行： </translation>
    </message>
    <message>
        <source>&amp;New Project</source>
        <translation>新建项目(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Open …</source>
        <translation>打开(&amp;O) …</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save &amp;As …</source>
        <translation>另存为(&amp;A) …</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>打开最近的项目(&amp;R)</translation>
    </message>
    <message>
        <source>No projects yet</source>
        <translation>尚无项目</translation>
    </message>
    <message>
        <source>New from &amp;Example</source>
        <translation>从示例新建(&amp;E)</translation>
    </message>
    <message>
        <source>Untitled project</source>
        <translation>未命名项目</translation>
    </message>
    <message>
        <source>Opening %1 …</source>
        <translation>正在打开 %1 …</translation>
    </message>
    <message>
        <source>%1 was not opened</source>
        <translation>%1 未打开</translation>
    </message>
    <message>
        <source>The project has errors and was not opened</source>
        <translation>项目有错误，未打开</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>已打开 %1</translation>
    </message>
    <message>
        <source>The example could not be opened</source>
        <translation>无法打开示例</translation>
    </message>
    <message>
        <source>The project was not saved</source>
        <translation>项目未保存</translation>
    </message>
    <message>
        <source>Save Project</source>
        <translation>保存项目</translation>
    </message>
    <message>
        <source>Covaria project (*.covaria)</source>
        <translation>Covaria 项目 (*.covaria)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message numerus="yes">
        <source>Saved %1 without %n text(s) that cannot be read: see the problems</source>
        <translation>
            <numerusform>已保存 %1，但不含 %n 项无法读取的文本：见问题</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>The work could not be recovered</source>
        <translation>无法恢复工作</translation>
    </message>
    <message>
        <source>%1 was removed by another program; saving writes it again</source>
        <translation>%1 已被另一程序移除；保存将重新写入</translation>
    </message>
    <message>
        <source>Name project</source>
        <translation>命名项目</translation>
    </message>
    <message>
        <source>%1 was changed by another program since it was read here. Saving replaces what it holds now.</source>
        <translation>自在此读取以来，%1 已被另一个程序更改。保存将替换其现有内容。</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>替换</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FileEditor</name>
    <message>
        <source>Choose a file: %1</source>
        <translation>选择文件：%1</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FirstStepsGuide</name>
    <message>
        <source>First Steps</source>
        <translation>入门</translation>
    </message>
    <message>
        <source>Not there yet: first step %1, %2.</source>
        <translation>还没有：先做第 %1 步，%2。</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FirstStepsPanel</name>
    <message>
        <source>Show Me</source>
        <translation>指给我看</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>上一步</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>入门</translation>
    </message>
    <message>
        <source>Shows where it is done: opens the tab and puts a frame around it</source>
        <translation>显示操作位置：打开标签页并加上边框</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>step 3 of 10</comment>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>done</source>
        <translation>已完成</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FoldGroups</name>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
</context>
<context>
    <name>covaria::ui::HelpActions</name>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>快捷键</translation>
    </message>
    <message>
        <source>M&amp;odels</source>
        <translation>模型(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Results and Requirements</source>
        <translation>结果与要求(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Glossary</source>
        <translation>术语表(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>快捷键(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;About Covaria</source>
        <translation>关于 Covaria(&amp;A)</translation>
    </message>
    <message>
        <source>The S&amp;cene</source>
        <translation>场景(&amp;C)</translation>
    </message>
    <message>
        <source>An Everyday &amp;Budget</source>
        <translation>日常预算(&amp;B)</translation>
    </message>
    <message>
        <source>Help on &amp;What Has the Focus</source>
        <translation>当前焦点项的帮助(&amp;W)</translation>
    </message>
    <message>
        <source>Artefacts, &amp;Instruments and Robots</source>
        <translation>实物标准器、仪器与机器人(&amp;I)</translation>
    </message>
    <message>
        <source>What Every Analysis &amp;Has</source>
        <translation>每个分析都有的内容(&amp;H)</translation>
    </message>
    <message>
        <source>Re&amp;view and Release</source>
        <translation>审核与发布(&amp;V)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::HelpPane</name>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ImpactActions</name>
    <message>
        <source>&amp;What Hangs on a Certificate …</source>
        <translation>取决于证书的内容(&amp;W) …</translation>
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
        <translation>评定(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>Sa&amp;ve</source>
        <translation>保存(&amp;V)</translation>
    </message>
    <message>
        <source>What Hangs on a Certificate</source>
        <translation>取决于证书的内容</translation>
    </message>
    <message>
        <source>Not evaluated</source>
        <translation>未评定</translation>
    </message>
    <message>
        <source>New Figures</source>
        <translation>新数值</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>Folder With Projects and Reports</source>
        <translation>含有项目和报告的文件夹</translation>
    </message>
    <message>
        <source>Files evaluated</source>
        <translation>已评定的文件</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>&amp;Document (PDF) …</source>
        <translation>文件 (PDF)(&amp;D) …</translation>
    </message>
    <message>
        <source>Save the Impact</source>
        <translation>保存影响</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>PDF 文档 (*.pdf)</translation>
    </message>
    <message>
        <source>Document (&amp;HTML) …</source>
        <translation>文件 (HTML)(&amp;H) …</translation>
    </message>
    <message>
        <source>HTML page (*.html)</source>
        <translation>HTML 页面 (*.html)</translation>
    </message>
    <message>
        <source>&amp;Table (CSV) …</source>
        <translation>表格 (CSV)(&amp;T) …</translation>
    </message>
    <message>
        <source>Save the Table</source>
        <translation>保存表格</translation>
    </message>
    <message>
        <source>CSV table (*.csv)</source>
        <translation>CSV 表格 (*.csv)</translation>
    </message>
    <message>
        <source>Save the List</source>
        <translation>保存列表</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>文本 (*.txt)</translation>
    </message>
    <message>
        <source>&amp;Find Who Used It</source>
        <translation>查找使用者(&amp;F)</translation>
    </message>
    <message>
        <source>Which results change when the figures of a certificate do?</source>
        <translation>证书的数值变化时，哪些结果会变化？</translation>
    </message>
    <message>
        <source>It could not be saved</source>
        <translation>无法保存</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>已写入 %1</translation>
    </message>
    <message>
        <source>&amp;List of Files …</source>
        <translation>文件列表(&amp;L) …</translation>
    </message>
    <message>
        <source>Evaluating …</source>
        <translation>正在评定 …</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>已停止。</translation>
    </message>
    <message>
        <source>Both before and after by the law of propagation.</source>
        <translation>前后均按传播律。</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ImpactForm</name>
    <message>
        <source>&amp;Browse …</source>
        <translation>浏览(&amp;B) …</translation>
    </message>
    <message>
        <source>&amp;Add Folder …</source>
        <translation>添加文件夹(&amp;A) …</translation>
    </message>
    <message>
        <source>Number of the certificate, its file or the SHA-256 of it; else the name of an asset</source>
        <translation>证书编号、其文件或该文件的 SHA-256；否则为资源名称</translation>
    </message>
    <message>
        <source>Number, file, or name of an asset</source>
        <translation>编号、文件或资源名称</translation>
    </message>
    <message>
        <source>Empty: only who used the certificate</source>
        <translation>留空：仅查找用过该证书者</translation>
    </message>
    <message>
        <source>A project, a report (PDF) or a file of others with the new figures; FILE#ID is one asset or analysis of it</source>
        <translation>含有新数值的项目、报告 (PDF) 或其他程序的文件；FILE#ID 是其中的一个资源或分析</translation>
    </message>
    <message>
        <source>A folder or file on each line</source>
        <translation>每行一个文件夹或文件</translation>
    </message>
    <message>
        <source>Projects and reports (PDF) below these folders are looked at</source>
        <translation>将查看这些文件夹下的项目和报告 (PDF)</translation>
    </message>
    <message>
        <source>Else each analysis is evaluated as its project says, with all its trials, twice</source>
        <translation>否则每个分析按其项目的规定、以全部试验评定两次</translation>
    </message>
    <message>
        <source>&amp;Certificate</source>
        <translation>证书(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;New figures</source>
        <translation>新数值(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Look in</source>
        <translation>查找位置(&amp;L)</translation>
    </message>
    <message>
        <source>To first &amp;order: quick</source>
        <translation>一阶(&amp;O)：快速</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ImpactTableModel</name>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>分析</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>组</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>y before</source>
        <translation>y，之前</translation>
    </message>
    <message>
        <source>y after</source>
        <translation>y，之后</translation>
    </message>
    <message>
        <source>U before</source>
        <translation>U（前）</translation>
    </message>
    <message>
        <source>U after</source>
        <translation>U（后）</translation>
    </message>
    <message>
        <source>Change / u</source>
        <translation>变化 / u</translation>
    </message>
    <message>
        <source>Change / U</source>
        <translation>变化 / U</translation>
    </message>
    <message>
        <source>Change of U in %</source>
        <translation>U 的变化（%）</translation>
    </message>
    <message>
        <source>Verdict before</source>
        <translation>结论（前）</translation>
    </message>
    <message>
        <source>Verdict after</source>
        <translation>结论（后）</translation>
    </message>
    <message>
        <source>To amend</source>
        <translation>需修订</translation>
    </message>
    <message>
        <source>%1
Double click: opens it</source>
        <translation>%1
双击：打开</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ImportActions</name>
    <message>
        <source>&amp;Import File …</source>
        <translation>导入文件(&amp;I) …</translation>
    </message>
    <message>
        <source>Add points, budgets, certificates, readings or poses of other programs</source>
        <translation>添加其他程序的点、预算、证书、读数或位姿</translation>
    </message>
    <message>
        <source>Add a serial robot from a robot description in URDF</source>
        <translation>从 URDF 机器人描述添加串联机器人</translation>
    </message>
    <message>
        <source>Import File</source>
        <translation>导入文件</translation>
    </message>
    <message>
        <source>Files that are read (%1);;All files (*)</source>
        <translation>可读取的文件 (%1);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>导入 %1</translation>
    </message>
    <message>
        <source>Imported %1</source>
        <translation>已导入 %1</translation>
    </message>
    <message>
        <source>Import Robot</source>
        <translation>导入机器人</translation>
    </message>
    <message>
        <source>Robot description (*.urdf);;All files (*)</source>
        <translation>机器人描述 (*.urdf);;所有文件 (*)</translation>
    </message>
    <message>
        <source>The robot was not imported</source>
        <translation>机器人未导入</translation>
    </message>
    <message>
        <source>Import Robo&amp;t (URDF) …</source>
        <translation>导入机器人 (URDF)(&amp;T) …</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ImportDialog</name>
    <message>
        <source>Line %1: %2</source>
        <translation>第 %1 行：%2</translation>
    </message>
    <message>
        <source>What the file says contradicts itself: %1</source>
        <translation>文件内容自相矛盾：%1</translation>
    </message>
    <message>
        <source>&amp;Sheet</source>
        <translation>工作表(&amp;S)</translation>
    </message>
    <message>
        <source>Columns of the file and what each is read as</source>
        <translation>文件的各列以及各读作什么</translation>
    </message>
    <message>
        <source>Units that the &amp;file does not state</source>
        <translation>文件未给出的单位(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Note the file with its size, time and SHA-256 in what is added</source>
        <translation>在所添加的内容中注明文件及其大小、时间和 SHA-256(&amp;N)</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>导入 %1</translation>
    </message>
    <message>
        <source>as the file says, else mm</source>
        <translation>按文件所述，否则为 mm</translation>
    </message>
    <message>
        <source>What becomes of the file</source>
        <translation>文件如何处理</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>&amp;Read as</source>
        <translation>读作(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Unit of lengths</source>
        <translation>长度单位(&amp;U)</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>量</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>What becomes of it, and what is not taken over</source>
        <translation>如何处理，以及哪些内容不采用</translation>
    </message>
    <message>
        <source>no reader recognises it: choose one</source>
        <translation>没有读取器能识别：请选择一个</translation>
    </message>
    <message>
        <source>several readers recognise it: choose one</source>
        <translation>有多个读取器能识别：请选择一个</translation>
    </message>
    <message>
        <source>%1 (recognised)</source>
        <translation>%1（已识别）</translation>
    </message>
    <message>
        <source>Column %1 is read as</source>
        <translation>第 %1 列读作</translation>
    </message>
    <message>
        <source>unknown: choose</source>
        <translation>未知：请选择</translation>
    </message>
    <message>
        <source>as it is named</source>
        <translation>按其名称</translation>
    </message>
    <message>
        <source>Choose what the file is read as.</source>
        <translation>选择文件读作什么。</translation>
    </message>
    <message>
        <source>%1 assets and %2 analyses are added, in one step that can be undone.</source>
        <translation>将添加 %1 个资源和 %2 个分析，为可撤销的一步。</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Imported from %1, %2 bytes, of %3, SHA-256 %4.</source>
        <translation>导入自 %1，%2 字节，%3，SHA-256 %4。</translation>
    </message>
    <message>
        <source>&amp;Leave Out or Read the Row</source>
        <translation>略去或读取该行(&amp;L)</translation>
    </message>
    <message>
        <source>%1, left out</source>
        <translation>%1，已略去</translation>
    </message>
    <message>
        <source>What each column is read as; cells can be typed over</source>
        <translation>每列读作什么；单元格可以改写</translation>
    </message>
</context>
<context>
    <name>covaria::ui::InputCorrelationModel</name>
    <message>
        <source>Remove correlations of %1</source>
        <translation>移除 %1 的相关性</translation>
    </message>
    <message>
        <source>Change correlation of %1 and %2</source>
        <translation>更改 %1 与 %2 的相关性</translation>
    </message>
    <message>
        <source>The correlation coefficient of %1 and %2 lies between −1 and 1; “%3” does not.</source>
        <translation>%1 与 %2 的相关系数在 −1 和 1 之间；“%3”不在此范围。</translation>
    </message>
    <message>
        <source>The correlation coefficient of %1 and %2 is a number; “%3” is not.</source>
        <translation>%1 与 %2 的相关系数是一个数；“%3”不是。</translation>
    </message>
</context>
<context>
    <name>covaria::ui::InputQuantitiesModel</name>
    <message>
        <source>from %1, linearised: %2</source>
        <translation>来自 %1，线性化：%2</translation>
    </message>
    <message>
        <source>from %1: %2</source>
        <translation>来自 %1：%2</translation>
    </message>
    <message>
        <source>Evaluated in the other analysis, in every trial: edit it there.</source>
        <translation>在每次试验中于另一分析内评定：请在该处编辑。</translation>
    </message>
    <message>
        <source>Changed: differs from what the model says.</source>
        <translation>已更改：与模型给出的不同。</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>符号</translation>
    </message>
    <message>
        <source>Input quantity</source>
        <translation>输入量</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>估计值</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Constant</source>
        <translation>常量</translation>
    </message>
    <message>
        <source>Change estimate of %1</source>
        <translation>更改 %1 的估计值</translation>
    </message>
    <message>
        <source>Keep %1 constant</source>
        <translation>使 %1 保持不变</translation>
    </message>
    <message>
        <source>Let %1 vary</source>
        <translation>使 %1 可变</translation>
    </message>
    <message>
        <source>Reset %1 to the model&apos;s values</source>
        <translation>将 %1 重置为模型的值</translation>
    </message>
    <message>
        <source>%1 (%2, %3)</source>
        <translation>%1（%2，%3）</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>分量</translation>
    </message>
</context>
<context>
    <name>covaria::ui::InputsPage</name>
    <message>
        <source>Find a quantity</source>
        <translation>查找量</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>分量</translation>
    </message>
    <message>
        <source>Correlations</source>
        <translation>相关性</translation>
    </message>
    <message>
        <source>The quantities that the set-up makes. What is changed here replaces what the set-up states.</source>
        <translation>测量设置所产生的量。在此更改的内容取代测量设置给出的内容。</translation>
    </message>
    <message>
        <source>Input quantities</source>
        <translation>输入量</translation>
    </message>
    <message>
        <source>Take From an Analysis …</source>
        <translation>取自分析 …</translation>
    </message>
    <message>
        <source>Remove Link</source>
        <translation>移除链接</translation>
    </message>
    <message>
        <source>Observations</source>
        <translation>观测值</translation>
    </message>
    <message>
        <source>Notes on the quantity</source>
        <translation>关于该量的附注</translation>
    </message>
</context>
<context>
    <name>covaria::ui::InquiryHead</name>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>创建副本</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
</context>
<context>
    <name>covaria::ui::InspectorHead</name>
    <message>
        <source>Entry before</source>
        <translation>上一条目</translation>
    </message>
    <message>
        <source>Entry after</source>
        <translation>下一条目</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>属性</translation>
    </message>
    <message>
        <source>Project and documents</source>
        <translation>项目和文档</translation>
    </message>
</context>
<context>
    <name>covaria::ui::KeptStates</name>
    <message>
        <source>Keep state</source>
        <translation>保留状态</translation>
    </message>
    <message>
        <source>Discard kept state</source>
        <translation>放弃保留的状态</translation>
    </message>
    <message>
        <source>Compare with %1</source>
        <translation>与 %1 比较</translation>
    </message>
</context>
<context>
    <name>covaria::ui::LibraryBrowser</name>
    <message>
        <source>Collections</source>
        <translation>集合</translation>
    </message>
    <message>
        <source>Templates, examples and assets</source>
        <translation>模板、示例和资源</translation>
    </message>
    <message>
        <source>Library and Examples</source>
        <translation>库和示例</translation>
    </message>
    <message>
        <source>Search: name, kind, source</source>
        <translation>搜索：名称、种类、来源</translation>
    </message>
    <message>
        <source>Search in the library</source>
        <translation>在库中搜索</translation>
    </message>
    <message>
        <source>What is selected</source>
        <translation>所选内容</translation>
    </message>
    <message>
        <source>New analysis</source>
        <translation>新分析</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>示例</translation>
    </message>
    <message>
        <source>GUM and its supplements</source>
        <translation>GUM 及其补充件</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>It comes with what it needs and has results at once. Assets of the same kind that the project has already stand in the place of its own.</source>
        <translation>它带有所需的一切，并立即有结果。项目中已有的同类资源将取代其自带资源。</translation>
    </message>
    <message>
        <source>Opens as a new project.</source>
        <translation>作为新项目打开。</translation>
    </message>
    <message>
        <source>Add to the Project</source>
        <translation>添加到项目</translation>
    </message>
    <message>
        <source>&lt;p&gt;Nothing here has these words.&lt;/p&gt;</source>
        <translation>&lt;p&gt;此处没有包含这些词的内容。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Open as a New Project</source>
        <translation>作为新项目打开</translation>
    </message>
    <message>
        <source>Add This Analysis</source>
        <translation>添加此分析</translation>
    </message>
</context>
<context>
    <name>covaria::ui::LibraryMenu</name>
    <message>
        <source>Not readable: %1</source>
        <translation>无法读取：%1</translation>
    </message>
    <message>
        <source>F&amp;rom the Library</source>
        <translation>从库中(&amp;R)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::LinesEditor</name>
    <message>
        <source>Add rows for new names</source>
        <translation>为新名称添加行</translation>
    </message>
    <message>
        <source>Adds a row to the tables below for every name that has none yet</source>
        <translation>在下面的表中为每个尚无行的名称添加一行</translation>
    </message>
</context>
<context>
    <name>covaria::ui::LinkDialog</name>
    <message>
        <source>&amp;Linearised: faster, exact to first order only</source>
        <translation>线性化：较快，仅一阶精确(&amp;L)</translation>
    </message>
    <message>
        <source>Take %1 From an Analysis</source>
        <translation>从分析中取 %1</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>分析</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>No other analysis has a result of this dimension.</source>
        <translation>没有其他分析具有该量纲的结果。</translation>
    </message>
    <message>
        <source>Both analyses are then evaluated together, as one model: the result is not carried over as a number with an uncertainty.</source>
        <translation>两个分析将作为一个模型一起评定：结果不是作为带不确定度的数值传递。</translation>
    </message>
    <message>
        <source>&amp;Analysis</source>
        <translation>分析(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Result</source>
        <translation>结果(&amp;R)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ListEditor</name>
    <message>
        <source>(none)</source>
        <translation>（无）</translation>
    </message>
    <message>
        <source>%1 (does not exist)</source>
        <translation>%1（不存在）</translation>
    </message>
    <message>
        <source>%1

Chosen: %2</source>
        <translation>%1

已选：%2</translation>
    </message>
</context>
<context>
    <name>covaria::ui::LogPane</name>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
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
        <translation>项目</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>属性</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>Add an analysis or what it uses</source>
        <translation>添加分析或其所用的内容</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Library and Examples …</source>
        <translation>库和示例(&amp;L) …</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>Pre&amp;ferences …</source>
        <translation>首选项(&amp;F) …</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>运行(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Reset Layout</source>
        <translation>重置布局(&amp;R)</translation>
    </message>
    <message>
        <source>Start Page</source>
        <translation>起始页</translation>
    </message>
    <message>
        <source>3D Scene</source>
        <translation>三维场景</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>Problems (%1)</source>
        <translation>问题 (%1)</translation>
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
        <translation>入门(&amp;S)</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Document</source>
        <translation>文档</translation>
    </message>
</context>
<context>
    <name>covaria::ui::MeasureTool</name>
    <message>
        <source>Measure Distance</source>
        <translation>测量距离</translation>
    </message>
    <message>
        <source>Distance of two points, with its uncertainty (D)</source>
        <translation>两点间的距离及其不确定度 (D)</translation>
    </message>
    <message>
        <source>Measure Angle</source>
        <translation>测量角度</translation>
    </message>
    <message>
        <source>Angle at the second of three points, with its uncertainty (A)</source>
        <translation>三点中第二点处的角度及其不确定度 (A)</translation>
    </message>
    <message>
        <source>Distance: pick the first point. Esc puts the tool away.</source>
        <translation>距离：请选取第一个点。按 Esc 退出工具。</translation>
    </message>
    <message>
        <source>Distance: pick the second point.</source>
        <translation>距离：请选取第二个点。</translation>
    </message>
    <message>
        <source>Angle: pick a point on the first side. Esc puts the tool away.</source>
        <translation>角度：请选取第一条边上的点。按 Esc 退出工具。</translation>
    </message>
    <message>
        <source>Angle: pick the apex.</source>
        <translation>角度：请选取顶点。</translation>
    </message>
    <message>
        <source>Angle: pick a point on the second side.</source>
        <translation>角度：请选取第二条边上的点。</translation>
    </message>
</context>
<context>
    <name>covaria::ui::NotesPage</name>
    <message>
        <source>Title</source>
        <translation>标题</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>附注</translation>
    </message>
    <message>
        <source>Appear in the report</source>
        <translation>列入报告</translation>
    </message>
</context>
<context>
    <name>covaria::ui::OnlyMiddle</name>
    <message>
        <source>Only the &amp;Middle</source>
        <translation>仅中间区域(&amp;M)</translation>
    </message>
    <message>
        <source>The stage alone; once more, and the panes stand as they did</source>
        <translation>仅显示主区域；再按一次，各窗格恢复原状</translation>
    </message>
</context>
<context>
    <name>covaria::ui::OptionsForm</name>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Forecast</source>
        <translation>预测</translation>
    </message>
    <message>
        <source>Change evaluation options</source>
        <translation>更改评定选项</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
</context>
<context>
    <name>covaria::ui::OutputsTab</name>
    <message>
        <source>Filter: symbol, name, group</source>
        <translation>筛选：符号、名称、组</translation>
    </message>
    <message>
        <source>Filter of the results</source>
        <translation>结果筛选</translation>
    </message>
    <message>
        <source>All groups</source>
        <translation>所有组</translation>
    </message>
    <message>
        <source>Results of all poses, points or targets, whichever is selected</source>
        <translation>所有位姿、点或目标点的结果，无论选择了哪一个</translation>
    </message>
    <message>
        <source>Not met only</source>
        <translation>仅显示不满足的</translation>
    </message>
    <message>
        <source>Only results whose target uncertainty or tolerance is not met</source>
        <translation>仅显示不满足目标不确定度或容差的结果</translation>
    </message>
    <message>
        <source>results</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Shortest Coverage Intervals</source>
        <translation>最短包含区间</translation>
    </message>
    <message>
        <source>Require…</source>
        <translation>要求…</translation>
    </message>
    <message>
        <source>Target uncertainty and limits of the results that are selected</source>
        <translation>所选结果的目标不确定度和界限</translation>
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
        <translation>页</translation>
    </message>
    <message>
        <source>Number of the page that is shown</source>
        <translation>所显示页的页码</translation>
    </message>
    <message>
        <source>Previous page</source>
        <translation>上一页</translation>
    </message>
    <message>
        <source>Next page</source>
        <translation>下一页</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>缩小</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>放大</translation>
    </message>
    <message>
        <source>Size of the pages</source>
        <translation>页面大小</translation>
    </message>
    <message>
        <source>Size of the pages: fitted, or in per cent of the paper (Ctrl with the wheel)</source>
        <translation>页面大小：适应窗口，或纸张的百分比（Ctrl 加滚轮）</translation>
    </message>
    <message>
        <source>Fit Width</source>
        <translation>适应宽度</translation>
    </message>
    <message>
        <source>Fit Page</source>
        <translation>适应页面</translation>
    </message>
    <message>
        <source> of %1</source>
        <comment>page 3 of 17</comment>
        <translation> / %1</translation>
    </message>
</context>
<context>
    <name>covaria::ui::PageList</name>
    <message>
        <source>Pages</source>
        <translation>页</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>第 %1 页</translation>
    </message>
</context>
<context>
    <name>covaria::ui::PairCorrelation</name>
    <message>
        <source>Correlation coefficient</source>
        <translation>相关系数</translation>
    </message>
    <message>
        <source>&lt;i&gt;r&lt;/i&gt;(%1, %2) =</source>
        <translation>&lt;i&gt;r&lt;/i&gt;(%1, %2) =</translation>
    </message>
    <message>
        <source>&lt;i&gt;r&lt;/i&gt; of two rows =</source>
        <translation>两行的 &lt;i&gt;r&lt;/i&gt; =</translation>
    </message>
    <message>
        <source>Both quantities need an uncertainty before they can be correlated</source>
        <translation>两个量都须有不确定度，才能给出相关系数</translation>
    </message>
    <message>
        <source>Select two rows, and type the correlation coefficient of their components</source>
        <translation>选择两行，输入其分量的相关系数</translation>
    </message>
</context>
<context>
    <name>covaria::ui::PaneKeys</name>
    <message>
        <source>Ne&amp;xt Pane</source>
        <translation>下一窗格(&amp;X)</translation>
    </message>
    <message>
        <source>Pre&amp;vious Pane</source>
        <translation>上一窗格(&amp;V)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>首选项</translation>
    </message>
    <message>
        <source>Results in the window</source>
        <translation>窗口中的结果</translation>
    </message>
    <message>
        <source>New analyses</source>
        <translation>新分析</translation>
    </message>
    <message>
        <source>Written into analyses that are added; others stay as they are.</source>
        <translation>写入所添加的分析；其他分析保持不变。</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>Of tables and charts of results</source>
        <translation>结果表格和图的单位</translation>
    </message>
    <message>
        <source>As the model gives them</source>
        <translation>按模型给出</translation>
    </message>
    <message>
        <source>Digits of U</source>
        <translation>U 的位数</translation>
    </message>
    <message>
        <source>Significant digits of uncertainties; estimates are rounded to match</source>
        <translation>不确定度的有效位数；估计值相应修约</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Of all tables, charts and fields of the window</source>
        <translation>窗口中所有表格、图和字段的数值</translation>
    </message>
    <message>
        <source>As the language writes them</source>
        <translation>按语言习惯</translation>
    </message>
    <message>
        <source>1234.5 (point)</source>
        <translation>1234.5（点）</translation>
    </message>
    <message>
        <source>1234,5 (comma)</source>
        <translation>1234,5（逗号）</translation>
    </message>
    <message>
        <source>Coverage factor</source>
        <translation>包含因子</translation>
    </message>
    <message>
        <source>Of U = k u, where a new analysis begins with a fixed one</source>
        <translation>U = k u 的包含因子，新分析以固定值开始时使用</translation>
    </message>
    <message>
        <source>k from the degrees of freedom or the coverage interval</source>
        <translation>k 由自由度或包含区间得到</translation>
    </message>
    <message>
        <source>k = 2</source>
        <translation>k = 2</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>试验次数</translation>
    </message>
    <message>
        <source>Of Monte Carlo</source>
        <translation>蒙特卡洛的试验次数</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>Of the window, when Covaria starts again</source>
        <translation>窗口的语言，Covaria 重新启动后生效</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>跟随系统</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Of the window, its charts and the scene</source>
        <translation>窗口、图和场景的颜色</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>Font size</source>
        <translation>字号</translation>
    </message>
    <message>
        <source>Of the whole window</source>
        <translation>整个窗口的字号</translation>
    </message>
    <message>
        <source>as the system</source>
        <translation>跟随系统</translation>
    </message>
    <message>
        <source> pt</source>
        <translation> pt</translation>
    </message>
    <message>
        <source>Recovery copy</source>
        <translation>恢复副本</translation>
    </message>
    <message>
        <source>How long an edit may stay without a copy that a crash leaves behind</source>
        <translation>一次编辑之后，最迟多久保存一份崩溃后可用的副本</translation>
    </message>
    <message>
        <source>at most </source>
        <translation>至多 </translation>
    </message>
    <message>
        <source> s after an edit</source>
        <translation> s（编辑后）</translation>
    </message>
    <message>
        <source>Where the project does not state them. Reports and files are the project&apos;s alone.</source>
        <translation>项目未指定时使用。报告和文件只以项目为准。</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>字体</translation>
    </message>
    <message>
        <source>Covaria&apos;s own</source>
        <translation>Covaria 自带</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProblemsModel</name>
    <message>
        <source>, row %1</source>
        <translation>，第 %1 行</translation>
    </message>
    <message>
        <source>Project: certificate, %1</source>
        <translation>项目：证书，%1</translation>
    </message>
    <message>
        <source>Project: report</source>
        <translation>项目：报告</translation>
    </message>
    <message>
        <source>evaluation, %1</source>
        <translation>评定，%1</translation>
    </message>
    <message>
        <source>To give</source>
        <translation>待给出</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>, line %1</source>
        <translation>，第 %1 行</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>种类</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>correlation of %1 and %2</source>
        <translation>%1 与 %2 的相关</translation>
    </message>
    <message>
        <source>link of %1</source>
        <translation>%1 的链接</translation>
    </message>
    <message>
        <source>change of %1</source>
        <translation>%1 的更改</translation>
    </message>
    <message>
        <source>requirement on %1</source>
        <translation>对 %1 的要求</translation>
    </message>
    <message>
        <source>study</source>
        <translation>研究</translation>
    </message>
    <message>
        <source>design</source>
        <translation>设计</translation>
    </message>
    <message>
        <source>Way out</source>
        <translation>出路</translation>
    </message>
    <message>
        <source>or</source>
        <translation>或</translation>
    </message>
    <message>
        <source>Project: review</source>
        <translation>项目：审核</translation>
    </message>
    <message>
        <source>certificate %1</source>
        <translation>证书 %1</translation>
    </message>
    <message>
        <source>date of the measurement</source>
        <translation>测量日期</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProblemsPane</name>
    <message>
        <source>Problems</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>No problems.</source>
        <translation>没有问题。</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProjectPage</name>
    <message>
        <source>Number</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>Of the project or order; in the report</source>
        <translation>项目或委托的编号；写入报告</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>作者</translation>
    </message>
    <message>
        <source>Who evaluated; in the report</source>
        <translation>评定人；写入报告</translation>
    </message>
    <message>
        <source>Results of all analyses</source>
        <translation>所有分析的结果</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>更改%1</translation>
    </message>
    <message>
        <source>Not stated</source>
        <translation>未给出</translation>
    </message>
    <message>
        <source>Of results in the window, reports, tables and CSV files; where it is not stated, files have the unit of the model</source>
        <translation>窗口、报告、表格和 CSV 文件中结果的单位；未给出时，文件采用模型的单位</translation>
    </message>
    <message>
        <source>Change units of results</source>
        <translation>更改结果的各单位</translation>
    </message>
    <message>
        <source>Digits of U</source>
        <translation>U 的位数</translation>
    </message>
    <message>
        <source>Significant digits of uncertainties in the window and the report; certificates have two</source>
        <translation>窗口和报告中不确定度的有效位数；证书为两位</translation>
    </message>
    <message>
        <source>Change digits of results</source>
        <translation>更改结果的位数</translation>
    </message>
    <message>
        <source>Coverage factor</source>
        <translation>包含因子</translation>
    </message>
    <message>
        <source>A fixed k for U = k u of all analyses whose options state none; empty: from the degrees of freedom, or the coverage interval</source>
        <translation>对选项中未给出 k 的所有分析，U = k u 中采用的固定 k；留空：由自由度或包含区间得出</translation>
    </message>
    <message>
        <source>Change coverage factor</source>
        <translation>更改包含因子</translation>
    </message>
    <message>
        <source>Reports, certificates and files have these units, and those of the model where none is stated; units of the preferences are of the window only.</source>
        <translation>报告、证书和文件使用这些单位，未给出时使用模型的单位；首选项中的单位仅用于窗口。</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProjectPane</name>
    <message>
        <source>Project</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>重命名(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Delete …</source>
        <translation>删除(&amp;D) …</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>添加(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Library and Templates …</source>
        <translation>库和模板(&amp;L) …</translation>
    </message>
    <message>
        <source>The analysis was not added: %1</source>
        <translation>分析未添加：%1</translation>
    </message>
    <message>
        <source>“%1” is in the project now</source>
        <translation>“%1”现已在项目中</translation>
    </message>
    <message>
        <source>Delete “%1”?</source>
        <translation>删除“%1”？</translation>
    </message>
    <message>
        <source>

It is used by: %1. They will have an error until they use something else.</source>
        <translation>

它被下列各项使用：%1。在改用其他内容之前，它们将有错误。</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>“%1” is in your library now (Add &gt; From the Library)</source>
        <translation>“%1”现已在您的库中（添加 &gt; 从库中）</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Keep in My Library</source>
        <translation>保存到我的库</translation>
    </message>
    <message>
        <source>Show in the Scene</source>
        <translation>在场景中显示</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>分析</translation>
    </message>
    <message>
        <source>What it uses</source>
        <translation>所用的资源</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>创建副本(&amp;L)</translation>
    </message>
    <message>
        <source>Add an analysis or what it uses</source>
        <translation>添加分析或其所用的内容</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProjectTreeModel</name>
    <message>
        <source>Artefacts</source>
        <translation>实物标准器</translation>
    </message>
    <message>
        <source>Instruments</source>
        <translation>仪器</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Points and frames</source>
        <translation>点和坐标系</translation>
    </message>
    <message>
        <source>Analyses</source>
        <translation>分析</translation>
    </message>
    <message>
        <source>has problems</source>
        <translation>有问题</translation>
    </message>
    <message>
        <source>Untitled project</source>
        <translation>未命名项目</translation>
    </message>
    <message>
        <source>Title, notes, certificate and contents of the report</source>
        <translation>标题、附注、证书和报告内容</translation>
    </message>
    <message>
        <source>incomplete</source>
        <translation>不完整</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>running</source>
        <translation>运行中</translation>
    </message>
    <message>
        <source>up to date</source>
        <translation>最新</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>已过期</translation>
    </message>
    <message>
        <source>%1 of %2 requirements not met</source>
        <translation>%2 项要求中有 %1 项不满足</translation>
    </message>
    <message>
        <source>Context</source>
        <translation>环境</translation>
    </message>
    <message>
        <source>Laboratory</source>
        <translation>实验室</translation>
    </message>
</context>
<context>
    <name>covaria::ui::PropertiesPane</name>
    <message>
        <source>The project is empty. Add an analysis, or first what it uses, with the plus sign above or a right click in the project tree.</source>
        <translation>项目为空。用上方的加号或在项目树中单击右键，添加一个分析，或先添加其所用的内容。</translation>
    </message>
    <message>
        <source>Select an entry of the project tree to see its properties.</source>
        <translation>选择项目树中的条目以查看其属性。</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>证书</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>评定</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>输入</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>选项</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>参数研究</translation>
    </message>
    <message>
        <source>Designs</source>
        <translation>设计</translation>
    </message>
    <message>
        <source>Requirements</source>
        <translation>要求</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>附注</translation>
    </message>
    <message>
        <source>Certificates</source>
        <translation>证书</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>审核</translation>
    </message>
    <message>
        <source>What can be evaluated with it</source>
        <translation>可用它评定什么</translation>
    </message>
</context>
<context>
    <name>covaria::ui::QuantityEdit</name>
    <message>
        <source>A value is needed here.</source>
        <translation>此处需要一个值。</translation>
    </message>
    <message>
        <source>A whole number is needed here.</source>
        <translation>此处需要一个整数。</translation>
    </message>
</context>
<context>
    <name>covaria::ui::QuantityNotesEdit</name>
    <message>
        <source>Notes on the quantity</source>
        <translation>关于该量的附注</translation>
    </message>
    <message>
        <source>Why this figure, what was agreed: in the report, below the input quantities</source>
        <translation>为何取此值、有何约定：列于报告中输入量之下</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ReferenceEditor</name>
    <message>
        <source>(nothing in the project fits: add it first)</source>
        <translation>（项目中没有合适的内容：请先添加）</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>（无）</translation>
    </message>
    <message>
        <source>(choose)</source>
        <translation>（请选择）</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ReportForm</name>
    <message>
        <source>Analyses, of report and certificate</source>
        <translation>报告和证书所含的分析</translation>
    </message>
    <message>
        <source>Chapters of the report</source>
        <translation>报告的章节</translation>
    </message>
    <message>
        <source>Long tables</source>
        <translation>长表</translation>
    </message>
    <message>
        <source>The report shows what counts most of long tables; the CSV files have them whole. Ticked, they stand whole at the end of the report too.</source>
        <translation>报告只显示长表中最重要的内容；CSV 文件包含完整长表。勾选后，长表也完整列于报告末尾。</translation>
    </message>
    <message>
        <source>Whole, in an annex</source>
        <translation>完整，列于附录</translation>
    </message>
    <message>
        <source>Change the annex of the report</source>
        <translation>更改报告的附录</translation>
    </message>
    <message>
        <source>Goes into the report where it is ticked.</source>
        <translation>勾选时列入报告。</translation>
    </message>
    <message>
        <source>Put %1 into the report</source>
        <translation>将“%1”列入报告</translation>
    </message>
    <message>
        <source>Leave %1 out of the report</source>
        <translation>报告中不列入“%1”</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>English: none is chosen on the page Certificate.</source>
        <translation>英语：“证书”页未选择语言。</translation>
    </message>
    <message>
        <source>%1, as chosen on the page Certificate.</source>
        <translation>%1，如“证书”页所选。</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ReportPreview</name>
    <message>
        <source>Document</source>
        <translation>文档</translation>
    </message>
    <message>
        <source>What is shown: the report, or the calibration certificate</source>
        <translation>显示内容：报告或校准证书</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>证书</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>更新</translation>
    </message>
    <message>
        <source>The report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>The certificate</source>
        <translation>证书</translation>
    </message>
    <message>
        <source>Out of date: the project or its results have changed since.</source>
        <translation>已过期：项目或其结果此后已更改。</translation>
    </message>
    <message>
        <source>%1 has not been made yet.</source>
        <translation>%1尚未生成。</translation>
    </message>
    <message>
        <source>The analyses are running: %1 waits for them.</source>
        <translation>分析正在运行：%1等待其完成。</translation>
    </message>
    <message>
        <source>No analysis is up to date: run one first (F5).</source>
        <translation>没有最新的分析：请先运行一个分析 (F5)。</translation>
    </message>
    <message>
        <source>%1 could not be made: %2</source>
        <translation>无法生成%1：%2</translation>
    </message>
    <message>
        <source>1 page, as printed</source>
        <translation>1 页，与打印一致</translation>
    </message>
    <message>
        <source>%1 pages, as printed</source>
        <translation>%1 页，与打印一致</translation>
    </message>
    <message>
        <source>%1; one required text is not stated</source>
        <translation>%1；有一项要求的文本未给出</translation>
    </message>
    <message>
        <source>%1; %2 required texts are not stated</source>
        <translation>%1；有 %2 项要求的文本未给出</translation>
    </message>
    <message>
        <source>Pages as they are printed</source>
        <translation>打印页面</translation>
    </message>
    <message>
        <source>Being made …</source>
        <translation>正在生成…</translation>
    </message>
</context>
<context>
    <name>covaria::ui::RequirementDialog</name>
    <message>
        <source>Requirements for Results</source>
        <translation>对结果的要求</translation>
    </message>
    <message>
        <source>Left out, for their unit is another: %1.</source>
        <translation>因单位不同而略去：%1。</translation>
    </message>
</context>
<context>
    <name>covaria::ui::RequirementsForm</name>
    <message>
        <source>U = %1: the target is %2.</source>
        <translation>U = %1：%2目标值。</translation>
    </message>
    <message>
        <source>met</source>
        <translation>满足</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>不满足</translation>
    </message>
    <message>
        <source>&lt;li&gt;u of %1 reduced from %2 to %3: %4 of what is stated&lt;/li&gt;</source>
        <translation>&lt;li&gt;%1 的 u 从 %2 减小到 %3：为给出值的 %4&lt;/li&gt;</translation>
    </message>
    <message>
        <source>&lt;br&gt;It would be met with one of these alone:&lt;ul&gt;%1&lt;/ul&gt;</source>
        <translation>&lt;br&gt;仅采取下列任一措施即可达到：&lt;ul&gt;%1&lt;/ul&gt;</translation>
    </message>
    <message>
        <source>&lt;br&gt;No component suffices alone.</source>
        <translation>&lt;br&gt;单靠任何一个分量都不够。</translation>
    </message>
    <message>
        <source> It would be met with all standard uncertainties multiplied by %1.</source>
        <translation> 所有标准不确定度乘以 %1 即可达到。</translation>
    </message>
    <message>
        <source>(trials)</source>
        <translation>（由试验得出）</translation>
    </message>
    <message>
        <source>(Student t)</source>
        <translation>（t 分布）</translation>
    </message>
    <message>
        <source>(normal)</source>
        <translation>（正态）</translation>
    </message>
    <message>
        <source>Not judged: %1.</source>
        <translation>未判定：%1。</translation>
    </message>
    <message>
        <source>By %5, guard band %1: the result is &lt;b&gt;%2&lt;/b&gt;. Probability of conformance %3 %4.</source>
        <translation>按%5，保护带 %1：结果为&lt;b&gt;%2&lt;/b&gt;。合格概率 %3%4。</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>接受</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>拒绝</translation>
    </message>
    <message>
        <source>&lt;br&gt;TUR %1, C&lt;sub&gt;m&lt;/sub&gt; %2.</source>
        <translation>&lt;br&gt;TUR %1，C&lt;sub&gt;m&lt;/sub&gt; %2。</translation>
    </message>
    <message>
        <source>&lt;br&gt;Global risks of the rule: consumer&apos;s %1, producer&apos;s %2.</source>
        <translation>&lt;br&gt;该规则的全局风险：使用方风险 %1，生产方风险 %2。</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>By the law of propagation; Monte Carlo is to follow.</source>
        <translation>按传播律；蒙特卡洛随后进行。</translation>
    </message>
    <message>
        <source>By the trials of a preview; the whole run is to follow.</source>
        <translation>按预览的试验；完整运行随后进行。</translation>
    </message>
    <message>
        <source>Run the analysis to see whether the requirement is met.</source>
        <translation>运行分析以查看是否满足要求。</translation>
    </message>
    <message>
        <source>&lt;br&gt;Of what the rule accepts %1 does not conform, of what it rejects %2 does.</source>
        <translation>&lt;br&gt;规则接受的之中 %1 不符合，拒绝的之中 %2 符合。</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ResultTableModel</name>
    <message>
        <source>Ends of the interval differ by %1 and %2 from those of Monte Carlo; tolerance %3</source>
        <translation>区间端点与蒙特卡洛法的端点相差 %1 和 %2；容差 %3</translation>
    </message>
    <message>
        <source>. Other trials could give the other verdict: more of them decide.</source>
        <translation>。其他试验可能给出相反的结论：增加试验次数可判定。</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ResultsPane</name>
    <message>
        <source>Results</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Budget</source>
        <translation>预算</translation>
    </message>
    <message>
        <source>Distributions</source>
        <translation>分布</translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation>相关性</translation>
    </message>
    <message>
        <source>Convergence</source>
        <translation>收敛性</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>评定</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>参数研究</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>设计</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>digits of U: </source>
        <translation>U 的位数： </translation>
    </message>
    <message>
        <source>Significant digits of uncertainties</source>
        <translation>不确定度的有效位数</translation>
    </message>
    <message>
        <source>Significant digits of uncertainties in the window; estimates are rounded to match. Documents have those of the project page.</source>
        <translation>窗口中不确定度的有效位数；估计值相应修约。文件采用项目页面中的位数。</translation>
    </message>
    <message>
        <source>budget</source>
        <translation>预算</translation>
    </message>
    <message>
        <source>correlation</source>
        <translation>相关性</translation>
    </message>
    <message>
        <source>All Results</source>
        <translation>全部结果</translation>
    </message>
    <message>
        <source>Go to Source</source>
        <translation>转到来源</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>图</translation>
    </message>
    <message>
        <source>Document</source>
        <translation>文档</translation>
    </message>
    <message>
        <source>Kind of chart</source>
        <translation>图的种类</translation>
    </message>
    <message>
        <source>Which charts of the result are shown</source>
        <translation>显示结果的哪些图</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>Contributions</source>
        <translation>贡献</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>所见</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ReviewForm</name>
    <message>
        <source>draft</source>
        <translation>草稿</translation>
    </message>
    <message>
        <source>released</source>
        <translation>已发布</translation>
    </message>
    <message>
        <source>draft again</source>
        <translation>重新成为草稿</translation>
    </message>
    <message>
        <source>A release states in report and certificate who is responsible, and a digest by which every later change shows.</source>
        <translation>发布后，报告和证书中会给出责任人，以及可显示以后每次更改的摘要。</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>发布</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>姓名</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>所做的工作</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>The day of this step; empty: that of the release.</source>
        <translation>该步骤的日期；留空：发布的日期。</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>更改%1</translation>
    </message>
    <message>
        <source>Add to the Log</source>
        <translation>添加到日志</translation>
    </message>
    <message>
        <source>Release the project</source>
        <translation>发布项目</translation>
    </message>
    <message>
        <source>Add to the log</source>
        <translation>添加到日志</translation>
    </message>
    <message>
        <source>A project with errors is not released.</source>
        <translation>有错误的项目不能发布。</translation>
    </message>
    <message>
        <source>All three names are needed.</source>
        <translation>三个姓名均须填写。</translation>
    </message>
    <message>
        <source>Takes the digest of the project as it is now</source>
        <translation>取项目当前状态的摘要</translation>
    </message>
</context>
<context>
    <name>covaria::ui::RowTools</name>
    <message>
        <source>Add row</source>
        <translation>添加行</translation>
    </message>
    <message>
        <source>Delete rows</source>
        <translation>删除行</translation>
    </message>
    <message>
        <source>Fill down</source>
        <translation>向下填充</translation>
    </message>
</context>
<context>
    <name>covaria::ui::RunActions</name>
    <message>
        <source>&amp;Run This Analysis</source>
        <translation>运行此分析(&amp;R)</translation>
    </message>
    <message>
        <source>Run &amp;All</source>
        <translation>全部运行(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Live</source>
        <translation>实时(&amp;L)</translation>
    </message>
    <message>
        <source>Each edit computes first-order results at once, then Monte Carlo</source>
        <translation>每次编辑后立即计算一阶结果，然后进行蒙特卡洛</translation>
    </message>
</context>
<context>
    <name>covaria::ui::RunStatus</name>
    <message>
        <source>%1 trials</source>
        <translation>%1 次试验</translation>
    </message>
    <message>
        <source>, %1 million/s</source>
        <translation>，%1 百万次/s</translation>
    </message>
    <message>
        <source>Progress of the run</source>
        <translation>运行进度</translation>
    </message>
    <message>
        <source>Stop all runs (Esc)</source>
        <translation>停止所有运行 (Esc)</translation>
    </message>
    <message>
        <source>Stop all runs</source>
        <translation>停止所有运行</translation>
    </message>
    <message>
        <source>%1: %2 %</source>
        <translation>%1：%2 %</translation>
    </message>
    <message>
        <source>, best so far %1</source>
        <translation>，目前最佳 %1</translation>
    </message>
    <message>
        <source>No analysis yet</source>
        <translation>尚无分析</translation>
    </message>
    <message>
        <source>No analysis selected</source>
        <translation>未选择分析</translation>
    </message>
    <message>
        <source>has problems</source>
        <translation>有问题</translation>
    </message>
    <message>
        <source>, %1 trials</source>
        <translation>，%1 次试验</translation>
    </message>
    <message>
        <source>, with warnings</source>
        <translation>，有警告</translation>
    </message>
    <message>
        <source>%1, kept state: </source>
        <translation>%1，保留的状态： </translation>
    </message>
    <message>
        <source>%1 s left</source>
        <translation>剩余 %1 s</translation>
    </message>
    <message>
        <source>%1 min left</source>
        <translation>剩余 %1 min</translation>
    </message>
    <message>
        <source>%1 h left</source>
        <translation>剩余 %1 h</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ScenePanel</name>
    <message>
        <source>Select an analysis in the project tree to see its layout here.</source>
        <translation>在项目树中选择一个分析，在此查看其布局。</translation>
    </message>
    <message>
        <source>Which pose or group of outputs to show</source>
        <translation>显示哪个位姿或哪组输出</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>组</translation>
    </message>
    <message>
        <source>Iso</source>
        <translation>轴测</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适应窗口</translation>
    </message>
    <message>
        <source>Everything in the picture (F)</source>
        <translation>显示全部内容 (F)</translation>
    </message>
    <message>
        <source>Magnification of the uncertainty; it is always written in the picture</source>
        <translation>不确定度的放大倍数；始终标注在图中</translation>
    </message>
    <message>
        <source>Magnification of the uncertainty</source>
        <translation>不确定度的放大倍数</translation>
    </message>
    <message>
        <source>× %1</source>
        <translation>× %1</translation>
    </message>
    <message>
        <source>Coverage probability of the ellipsoids</source>
        <translation>椭球的包含概率</translation>
    </message>
    <message>
        <source>p = %1 %</source>
        <translation>p = %1 %</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>实体</translation>
    </message>
    <message>
        <source>Links and Sight Lines</source>
        <translation>连杆和视线</translation>
    </message>
    <message>
        <source>Vectors</source>
        <translation>矢量</translation>
    </message>
    <message>
        <source>Ellipsoids</source>
        <translation>椭球</translation>
    </message>
    <message>
        <source>Clouds</source>
        <translation>点云</translation>
    </message>
    <message>
        <source>Histograms on the Walls</source>
        <translation>壁面直方图</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>坐标轴</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>图例</translation>
    </message>
    <message>
        <source>Map of a Study or Design</source>
        <translation>参数研究或设计的等值图</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>图层</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;  at %2</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;  位于 %2</translation>
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
        <translation>视图</translation>
    </message>
    <message>
        <source>Ellipsoids of the Kept State</source>
        <translation>保留状态的椭球</translation>
    </message>
    <message>
        <source>× auto</source>
        <translation>× 自动</translation>
    </message>
    <message>
        <source>Context Meshes</source>
        <translation>环境网格</translation>
    </message>
    <message>
        <source>View from the front right, from above (1); beside it standard and saved views, orthographic or perspective</source>
        <translation>从右前上方观察（1）；旁边是标准视图和已保存的视图，正投影或透视</translation>
    </message>
    <message>
        <source>Layers: what the picture shows</source>
        <translation>图层：图中显示的内容</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SceneView</name>
    <message>
        <source>3D scene</source>
        <translation>三维场景</translation>
    </message>
    <message>
        <source>The picture could not be written to %1</source>
        <translation>图片无法写入 %1</translation>
    </message>
    <message>
        <source>Drawing …</source>
        <translation>正在绘制 …</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适应窗口</translation>
    </message>
    <message>
        <source>Copy Picture</source>
        <translation>复制图片</translation>
    </message>
    <message>
        <source>Save Picture …</source>
        <translation>保存图片 …</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>保存图片</translation>
    </message>
    <message>
        <source>scene.png</source>
        <translation>scene.png</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG 图片 (*.png)</translation>
    </message>
    <message>
        <source>Arrow keys turn the scene, plus and minus zoom, F fits, 1 to 7 are standard views, H hides what is selected, I shows it alone, Shift+H shows all; points and instruments can be dragged to another place</source>
        <translation>方向键旋转场景，加减键缩放，F 适应窗口，1 至 7 为标准视图，H 隐藏所选项，I 仅显示所选项，Shift+H 显示全部；点和仪器可拖到其他位置</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>Show Only This</source>
        <translation>仅显示此项</translation>
    </message>
    <message>
        <source>Show All</source>
        <translation>显示全部</translation>
    </message>
    <message>
        <source>Type Coordinates</source>
        <translation>键入坐标</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SearchActions</name>
    <message>
        <source>&amp;Find Anything …</source>
        <translation>查找一切(&amp;F) …</translation>
    </message>
    <message>
        <source>analysis</source>
        <translation>分析</translation>
    </message>
    <message>
        <source>asset</source>
        <translation>资源</translation>
    </message>
    <message>
        <source>command, menu %1</source>
        <translation>命令，菜单 %1</translation>
    </message>
    <message>
        <source>field of %1</source>
        <translation>%1 的字段</translation>
    </message>
    <message>
        <source>result of %1</source>
        <translation>%1 的结果</translation>
    </message>
    <message>
        <source>input quantity of %1</source>
        <translation>%1 的输入量</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>标签页</translation>
    </message>
    <message>
        <source>help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>help: %1</source>
        <translation>帮助：%1</translation>
    </message>
    <message>
        <source>group</source>
        <translation>组</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SearchPalette</name>
    <message>
        <source>Find anything</source>
        <translation>查找一切</translation>
    </message>
    <message>
        <source>Analyses, quantities, results, fields, commands, help</source>
        <translation>分析、量、结果、字段、命令、帮助</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>找到的内容</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SecondPart</name>
    <message>
        <source>View of the second part</source>
        <translation>第二部分的视图</translation>
    </message>
    <message>
        <source>What the second part of the stage shows</source>
        <translation>主区域的第二部分显示什么</translation>
    </message>
    <message>
        <source>Close this part</source>
        <translation>关闭此部分</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SectionBar</name>
    <message>
        <source>Section</source>
        <translation>剖切</translation>
    </message>
    <message>
        <source>In the picture Shift+wheel, Page Up and Page Down move the section, with Shift in fine steps; Esc ends it</source>
        <translation>在图中用 Shift+滚轮、Page Up 和 Page Down 移动剖切面，按 Shift 为微调；Esc 结束</translation>
    </message>
    <message>
        <source>Position of the section</source>
        <translation>剖切面的位置</translation>
    </message>
    <message>
        <source>Section across %1</source>
        <translation>垂直于 %1 的剖切</translation>
    </message>
    <message>
        <source>Where the plane is; a number without a unit is in %1</source>
        <translation>平面的位置；不带单位的数字以 %1 为单位</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SectionTool</name>
    <message>
        <source>Section</source>
        <translation>剖切</translation>
    </message>
    <message>
        <source>Section: cut away what lies before a plane (S)</source>
        <translation>剖切：切去平面之前的部分 (S)</translation>
    </message>
    <message>
        <source>Flip Side</source>
        <translation>换边</translation>
    </message>
    <message>
        <source>Cut away the other side (Shift+S)</source>
        <translation>切去另一侧 (Shift+S)</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>The scene is whole again (Esc)</source>
        <translation>场景恢复完整 (Esc)</translation>
    </message>
    <message>
        <source>Across x</source>
        <translation>垂直于 x</translation>
    </message>
    <message>
        <source>Across y</source>
        <translation>垂直于 y</translation>
    </message>
    <message>
        <source>Across z</source>
        <translation>垂直于 z</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SeenTab</name>
    <message>
        <source>seen</source>
        <translation>所见</translation>
    </message>
    <message>
        <source>What the residuals say</source>
        <translation>残差说明了什么</translation>
    </message>
    <message>
        <source>Level of the tests</source>
        <translation>检验的水平</translation>
    </message>
    <message>
        <source>How often a figure that is right is contradicted by chance</source>
        <translation>正确的指标偶然被否定的频度</translation>
    </message>
    <message>
        <source>Level %1 %</source>
        <translation>水平 %1 %</translation>
    </message>
    <message>
        <source>Back to Stated</source>
        <translation>恢复给出值</translation>
    </message>
    <message>
        <source>Take Over as Seen</source>
        <translation>采用所见值</translation>
    </message>
    <message>
        <source>The results follow from the stated uncertainties again</source>
        <translation>结果重新由给出的不确定度得出</translation>
    </message>
    <message>
        <source>The results, and all that hang on them, follow from the uncertainties that the residuals see, and change with the readings; can be undone</source>
        <translation>结果及所有依赖于结果的内容由残差所见的不确定度得出，并随读数变化；可以撤销</translation>
    </message>
    <message>
        <source>Back to stated uncertainties</source>
        <translation>恢复给出的不确定度</translation>
    </message>
    <message>
        <source>Take over uncertainties as seen</source>
        <translation>采用所见的不确定度</translation>
    </message>
    <message>
        <source>Go to Source</source>
        <translation>转到来源</translation>
    </message>
    <message>
        <source>What the residuals are drawn over</source>
        <translation>残差相对于什么绘制</translation>
    </message>
    <message>
        <source>Distribution of the residuals</source>
        <translation>残差的分布</translation>
    </message>
    <message>
        <source>Quantiles</source>
        <translation>分位数</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>直方图</translation>
    </message>
    <message>
        <source>Over: %1</source>
        <translation>横坐标：%1</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SeenTableModel</name>
    <message>
        <source>interval of the factor</source>
        <translation>因子的区间</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SetupForm</name>
    <message>
        <source>Change %1</source>
        <translation>更改%1</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>及另外 %n 项</numerusform>
        </translation>
    </message>
    <message>
        <source>From “%1”: %2. What is stated of them here is not used.</source>
        <translation>来自“%1”：%2。此处对它们的说明不被使用。</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SetupTableModel</name>
    <message>
        <source>Insert rows in %1</source>
        <translation>在%1中插入行</translation>
    </message>
    <message>
        <source>Delete rows of %1</source>
        <translation>删除%1的行</translation>
    </message>
    <message>
        <source>Paste into %1</source>
        <translation>粘贴到%1</translation>
    </message>
    <message>
        <source>Delete rows</source>
        <translation>删除行</translation>
    </message>
    <message>
        <source>Fill down in %1</source>
        <translation>在%1中向下填充</translation>
    </message>
    <message>
        <source>Clear cells of %1</source>
        <translation>清除%1的单元格</translation>
    </message>
    <message>
        <source>Change unit in %1</source>
        <translation>更改%1中的单位</translation>
    </message>
    <message>
        <source>Take %1 into the project</source>
        <translation>将%1纳入项目</translation>
    </message>
    <message>
        <source>%1 is no unit for a quantity in %2.</source>
        <translation>%1 不是以 %2 表示的量的单位。</translation>
    </message>
    <message>
        <source>Its value is %1 of the analysis “%2”: what is stated here is not used.</source>
        <translation>其值是分析“%2”的 %1：此处所述内容不会被使用。</translation>
    </message>
    <message>
        <source>%1 of the value</source>
        <translation>值的 %1</translation>
    </message>
    <message>
        <source>%1 absolute, not a part of the value</source>
        <translation>%1（绝对值），不是值的一部分</translation>
    </message>
    <message>
        <source>Change %1: %2</source>
        <translation>更改%1：%2</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>第 %1 行</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SortableTable</name>
    <message>
        <source>Click to sort, right click to choose columns</source>
        <translation>单击排序，单击右键选择列</translation>
    </message>
    <message>
        <source>Save Table</source>
        <translation>保存表格</translation>
    </message>
    <message>
        <source>CSV table (*.csv)</source>
        <translation>CSV 表格 (*.csv)</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>全选</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>列</translation>
    </message>
    <message>
        <source>Original Order</source>
        <translation>原始顺序</translation>
    </message>
    <message>
        <source>Save as CSV …</source>
        <translation>保存为 CSV …</translation>
    </message>
    <message>
        <source>Fit Widths</source>
        <translation>适应列宽</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SpreadsheetView</name>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>剪切</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>粘贴</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>Fill down</source>
        <translation>向下填充</translation>
    </message>
    <message>
        <source>Insert row above</source>
        <translation>在上方插入行</translation>
    </message>
    <message>
        <source>Add row at the end</source>
        <translation>在末尾添加行</translation>
    </message>
    <message>
        <source>Delete rows</source>
        <translation>删除行</translation>
    </message>
</context>
<context>
    <name>covaria::ui::Stage</name>
    <message>
        <source>Two views at once</source>
        <translation>同时显示两个视图</translation>
    </message>
    <message>
        <source>Below Each Other</source>
        <translation>上下排列</translation>
    </message>
    <message>
        <source>Beside Each Other</source>
        <translation>左右排列</translation>
    </message>
</context>
<context>
    <name>covaria::ui::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>起始页</translation>
    </message>
    <message>
        <source>New Project</source>
        <translation>新建项目</translation>
    </message>
    <message>
        <source>Open …</source>
        <translation>打开 …</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>最近</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>示例</translation>
    </message>
    <message>
        <source>They open as new projects; the shipped files stay as they are.</source>
        <translation>它们作为新项目打开；随附的文件保持不变。</translation>
    </message>
    <message>
        <source>Projects that you open are listed here.</source>
        <translation>您打开的项目列于此处。</translation>
    </message>
    <message>
        <source>First Steps</source>
        <translation>入门</translation>
    </message>
    <message>
        <source>A budget from nothing to a PDF, in ten steps beside the window</source>
        <translation>在窗口旁用十步从零开始完成一份预算直到 PDF</translation>
    </message>
    <message>
        <source>What do you want to know?</source>
        <translation>您想知道什么？</translation>
    </message>
    <message>
        <source>Library …</source>
        <translation>库 …</translation>
    </message>
    <message>
        <source>A quantity by an equation</source>
        <translation>由方程求一个量</translation>
    </message>
    <message>
        <source>Type y = f(x), state each input, get the budget.</source>
        <translation>键入 y = f(x)，给出各输入量，得到预算。</translation>
    </message>
    <message>
        <source>Points by instruments</source>
        <translation>由仪器测点</translation>
    </message>
    <message>
        <source>Tracker, total station, camera; one or many.</source>
        <translation>跟踪仪、全站仪、相机；一台或多台。</translation>
    </message>
    <message>
        <source>The pose of an object</source>
        <translation>物体的位姿</translation>
    </message>
    <message>
        <source>A frame from its points, in the frame of another.</source>
        <translation>由各点得到的坐标系，在另一坐标系中表示。</translation>
    </message>
    <message>
        <source>A robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Where its tool is, and what its parameters are.</source>
        <translation>其工具在何处，其参数是多少。</translation>
    </message>
    <message>
        <source>A file I have</source>
        <translation>我已有的文件</translation>
    </message>
    <message>
        <source>Excel budget, points, measurement report.</source>
        <translation>Excel 预算、点、测量报告。</translation>
    </message>
    <message>
        <source>Budget, Points or Report …</source>
        <translation>预算、点或报告 …</translation>
    </message>
    <message>
        <source>Robot (URDF) …</source>
        <translation>机器人 (URDF) …</translation>
    </message>
    <message>
        <source>Project …</source>
        <translation>项目 …</translation>
    </message>
    <message>
        <source>Show All %1</source>
        <translation>显示全部 %1 个</translation>
    </message>
</context>
<context>
    <name>covaria::ui::StudiesForm</name>
    <message>
        <source>Study</source>
        <translation>参数研究</translation>
    </message>
    <message>
        <source>Adds a study of this analysis</source>
        <translation>添加此分析的一个参数研究</translation>
    </message>
    <message>
        <source>Adds a copy of this study</source>
        <translation>添加此参数研究的副本</translation>
    </message>
    <message>
        <source>Deletes this study</source>
        <translation>删除此参数研究</translation>
    </message>
    <message>
        <source>Evaluates the analysis at every grid point of this study</source>
        <translation>在此参数研究的每个网格点评定分析</translation>
    </message>
    <message>
        <source>A study evaluates this analysis for many values of a number: a sweep over one, a map over two or three. Add one to see how the uncertainty depends on the set-up.</source>
        <translation>参数研究让一个数值取许多值，逐一评定此分析：一个数值为扫描，两个或三个数值为等值图。添加一个，查看不确定度如何随测量设置变化。</translation>
    </message>
    <message>
        <source>Name of the study</source>
        <translation>参数研究名称</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Law of propagation</source>
        <translation>传播律</translation>
    </message>
    <message>
        <source>Monte Carlo</source>
        <translation>蒙特卡洛</translation>
    </message>
    <message>
        <source>Trials at each grid point</source>
        <translation>每个网格点的试验次数</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Trials per point</source>
        <translation>每点试验次数</translation>
    </message>
    <message>
        <source>Add Axis</source>
        <translation>添加轴</translation>
    </message>
    <message>
        <source>Varies one more number: every combination is evaluated</source>
        <translation>再改变一个数值：评定每种组合</translation>
    </message>
    <message>
        <source>Output quantities of the study</source>
        <translation>参数研究的输出量</translation>
    </message>
    <message>
        <source>Output quantities looked at; with none ticked, all measurands</source>
        <translation>所考察的输出量；均未勾选时，为所有被测量</translation>
    </message>
    <message>
        <source>Outputs (none ticked: all measurands)</source>
        <translation>输出量（均未勾选：所有被测量）</translation>
    </message>
</context>
<context>
    <name>covaria::ui::StudyAxisEdit</name>
    <message>
        <source>Axis %1</source>
        <translation>轴 %1</translation>
    </message>
    <message>
        <source>Variable %1</source>
        <translation>变量 %1</translation>
    </message>
    <message>
        <source>Remove Axis</source>
        <translation>移除轴</translation>
    </message>
    <message>
        <source>Remove Variable</source>
        <translation>移除变量</translation>
    </message>
    <message>
        <source>takes these values</source>
        <translation>取下列值</translation>
    </message>
    <message>
        <source>is multiplied with</source>
        <translation>乘以</translation>
    </message>
    <message>
        <source>has added to it</source>
        <translation>加上</translation>
    </message>
    <message>
        <source>evenly spaced</source>
        <translation>等间隔</translation>
    </message>
    <message>
        <source>logarithmically spaced</source>
        <translation>对数等间隔</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>To</source>
        <translation>到</translation>
    </message>
    <message>
        <source>Number of values</source>
        <translation>值的个数</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>容差</translation>
    </message>
    <message>
        <source>It can be put into effect only so well: what counts is the worst within it</source>
        <translation>它只能以这样的精度实现：以其范围内的最差情况为准</translation>
    </message>
    <message>
        <source>Varied</source>
        <translation>被改变的量</translation>
    </message>
    <message>
        <source>It</source>
        <translation>该量</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>值</translation>
    </message>
    <message>
        <source>choose what is varied</source>
        <translation>选择要改变的量</translation>
    </message>
    <message>
        <source> (factor)</source>
        <translation> （因子）</translation>
    </message>
    <message>
        <source>%1: has a problem</source>
        <translation>%1：有问题</translation>
    </message>
</context>
<context>
    <name>covaria::ui::StudyTab</name>
    <message>
        <source>study</source>
        <translation>参数研究</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>参数研究</translation>
    </message>
    <message>
        <source>Study of this analysis</source>
        <translation>此分析的参数研究</translation>
    </message>
    <message>
        <source>Run Study</source>
        <translation>运行参数研究</translation>
    </message>
    <message>
        <source>Edit …</source>
        <translation>编辑 …</translation>
    </message>
    <message>
        <source>Axes, outputs and method of the study, in the properties of the analysis</source>
        <translation>参数研究的轴、输出和方法，在分析的属性中</translation>
    </message>
    <message>
        <source>Quantity of the study</source>
        <translation>参数研究的量</translation>
    </message>
    <message>
        <source>What the chart and the scene show</source>
        <translation>图和场景显示的内容</translation>
    </message>
    <message>
        <source>Kind of chart</source>
        <translation>图的种类</translation>
    </message>
    <message>
        <source>A map, or lines over the first axis</source>
        <translation>等值图，或沿第一轴的曲线</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>等值图</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Axis of the slices</source>
        <translation>切片的轴</translation>
    </message>
    <message>
        <source>Which axis the slices are across</source>
        <translation>切片与哪个轴垂直</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>切片</translation>
    </message>
    <message>
        <source>slice only</source>
        <translation>仅切片</translation>
    </message>
    <message>
        <source>In the scene: the points of this slice; else all</source>
        <translation>在场景中：此切片的点；否则为全部</translation>
    </message>
    <message>
        <source>ellipsoids</source>
        <translation>椭球</translation>
    </message>
    <message>
        <source>In the scene: coverage ellipsoids at the grid points</source>
        <translation>在场景中：网格点处的包含椭球</translation>
    </message>
    <message>
        <source>Add Study …</source>
        <translation>添加参数研究 …</translation>
    </message>
    <message>
        <source>Out of date: of the project as it was</source>
        <translation>已过期：为项目之前的状态</translation>
    </message>
    <message>
        <source>slice: </source>
        <translation>切片： </translation>
    </message>
    <message>
        <source> – out of date</source>
        <translation> – 已过期</translation>
    </message>
    <message>
        <source>running …</source>
        <translation>运行中 …</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>失败：%1</translation>
    </message>
    <message>
        <source>Not evaluated yet.</source>
        <translation>尚未评定。</translation>
    </message>
    <message>
        <source>%1 grid points</source>
        <translation>%1 个网格点</translation>
    </message>
    <message>
        <source>, %1 without values</source>
        <translation>，%1 个没有值</translation>
    </message>
    <message>
        <source>&lt;b&gt;Out of date&lt;/b&gt;: shown for the project as it was. </source>
        <translation>&lt;b&gt;已过期&lt;/b&gt;：显示的是项目之前的状态。 </translation>
    </message>
    <message>
        <source>“%1” shows how the uncertainty depends on what the study varies.</source>
        <translation>“%1”可查看不确定度如何随参数研究所改变的量变化。</translation>
    </message>
    <message>
        <source>A study evaluates the analysis for many values of a number: add one with “%1”.</source>
        <translation>参数研究对一个数值的许多取值评定分析：请用“%1”添加一个。</translation>
    </message>
</context>
<context>
    <name>covaria::ui::StudyTableModel</name>
    <message>
        <source>Remark</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Why there are no values, or what is wrong with them</source>
        <translation>为何没有值，或值有何问题</translation>
    </message>
</context>
<context>
    <name>covaria::ui::TabBar</name>
    <message>
        <source>More tabs</source>
        <translation>更多标签页</translation>
    </message>
</context>
<context>
    <name>covaria::ui::TableEditor</name>
    <message>
        <source>Take into the project</source>
        <translation>纳入项目</translation>
    </message>
    <message>
        <source>Import CSV …</source>
        <translation>导入 CSV …</translation>
    </message>
    <message>
        <source>Read from %1</source>
        <translation>读自 %1</translation>
    </message>
    <message>
        <source>The rows are read from %1. Taken into the project they can be edited here.</source>
        <translation>这些行读自 %1。纳入项目后可在此编辑。</translation>
    </message>
    <message>
        <source>Import CSV into %1</source>
        <translation>将 CSV 导入%1</translation>
    </message>
    <message>
        <source>Tables (*.csv *.tsv *.txt);;All files (*)</source>
        <translation>表格 (*.csv *.tsv *.txt);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>导入 %1</translation>
    </message>
    <message>
        <source>All columns</source>
        <translation>所有列</translation>
    </message>
    <message>
        <source>Shows also the columns that no row has something in</source>
        <translation>同时显示所有行都为空的列</translation>
    </message>
</context>
<context>
    <name>covaria::ui::TargetBox</name>
    <message>
        <source>What is varied: type a part of its name to search</source>
        <translation>改变的量：输入其名称的一部分以搜索</translation>
    </message>
    <message>
        <source>What is varied</source>
        <translation>改变的量</translation>
    </message>
    <message>
        <source>“%1” names nothing that can be varied.</source>
        <translation>“%1”不对应任何可改变的量。</translation>
    </message>
    <message numerus="yes">
        <source>“%1” names %n things that can be varied.</source>
        <translation>
            <numerusform>“%1”对应 %n 个可改变的量。</numerusform>
        </translation>
    </message>
    <message>
        <source> (factor)</source>
        <translation> （因子）</translation>
    </message>
</context>
<context>
    <name>covaria::ui::UnitButton</name>
    <message>
        <source>Units</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Units of the tables and charts</source>
        <translation>表格和图的单位</translation>
    </message>
    <message>
        <source>As the Model Gives Them</source>
        <translation>按模型给出</translation>
    </message>
    <message>
        <source>Change unit of results</source>
        <translation>更改结果的单位</translation>
    </message>
    <message>
        <source>Clear units of results</source>
        <translation>清除结果的单位</translation>
    </message>
    <message>
        <source>In Reports and Files Too</source>
        <translation>报告和文件中也使用</translation>
    </message>
    <message>
        <source>States the units that are shown in the project: they are those of its documents</source>
        <translation>在项目中规定所显示的单位：其文档即使用这些单位</translation>
    </message>
    <message>
        <source>Units of the tables and charts; reports and files have those that the project states</source>
        <translation>表格和图表的单位；报告和文件使用项目规定的单位</translation>
    </message>
</context>
<context>
    <name>covaria::ui::UnitChoices</name>
    <message>
        <source>Lengths</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Moments</source>
        <translation>力矩</translation>
    </message>
</context>
<context>
    <name>covaria::ui::UnreadTexts</name>
    <message>
        <source>What is typed in a field cannot be read. %1</source>
        <translation>字段中输入的内容无法读取。%1</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ViewActions</name>
    <message>
        <source>&amp;Scene</source>
        <translation>场景(&amp;S)</translation>
    </message>
    <message>
        <source>Save View</source>
        <translation>保存视图</translation>
    </message>
    <message>
        <source>Name of the view:</source>
        <translation>视图名称：</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适应窗口</translation>
    </message>
    <message>
        <source>&amp;Orthographic</source>
        <translation>正投影(&amp;O)</translation>
    </message>
    <message>
        <source>Parallel lines stay parallel, and the scale bar holds everywhere</source>
        <translation>平行线保持平行，比例尺处处有效</translation>
    </message>
    <message>
        <source>Show &amp;All</source>
        <translation>显示全部(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Save View …</source>
        <translation>保存视图(&amp;S) …</translation>
    </message>
    <message>
        <source>Remo&amp;ve View</source>
        <translation>移除视图(&amp;V)</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>视图 %1</translation>
    </message>
    <message>
        <source>Save View %1</source>
        <translation>保存视图 %1</translation>
    </message>
    <message>
        <source>Remove View %1</source>
        <translation>移除视图 %1</translation>
    </message>
</context>
</TS>
