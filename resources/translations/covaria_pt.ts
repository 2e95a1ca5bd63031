<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pt" sourcelanguage="en">
<context>
    <name>QObject</name>
    <message>
        <source>Move %1</source>
        <translation>Mover %1</translation>
    </message>
    <message>
        <source>&lt;p&gt;%1 more rows; the exported table has all of them.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Mais %1 linhas; a tabela exportada contém todas.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>Girar %1</translation>
    </message>
    <message>
        <source>&lt;b&gt;Trial %1&lt;/b&gt;, inputs farthest from their estimates: %2</source>
        <translation>&lt;b&gt;Ensaio %1&lt;/b&gt;, entradas mais afastadas das suas estimativas: %2</translation>
    </message>
    <message>
        <source>Only %1 is shown (Shift+H: all)</source>
        <translation>Só %1 é mostrado (Shift+H: tudo)</translation>
    </message>
    <message numerus="yes">
        <source>%n hidden (Shift+H: show all)</source>
        <translation>
            <numerusform>%n ocultos (Shift+H: mostrar tudo)</numerusform>
            <numerusform>%n ocultos (Shift+H: mostrar tudo)</numerusform>
        </translation>
    </message>
    <message>
        <source>The interval is not symmetric about the estimate: state the interval, not y ± U (JCGM 101 5.5).</source>
        <translation>O intervalo não é simétrico em torno da estimativa: declare o intervalo, não y ± U (JCGM 101 5.5).</translation>
    </message>
    <message>
        <source>Turns about its %1 axis</source>
        <translation>Gira em torno do seu eixo %1</translation>
    </message>
    <message>
        <source>Moves along %1</source>
        <translation>Move ao longo de %1</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>Pose from points</source>
        <extracomment>Measurement model</extracomment>
        <translation>Pose a partir de pontos</translation>
    </message>
    <message>
        <source>Base frame</source>
        <translation>Referencial da base</translation>
    </message>
    <message>
        <source>Base points</source>
        <translation>Pontos da base</translation>
    </message>
    <message>
        <source>Nominal coordinates of the points in their own frame, and standard uncertainties of single coordinates where they differ from the common ones.</source>
        <translation>Coordenadas nominais dos pontos em seu próprio referencial, e incertezas-padrão de coordenadas individuais onde diferem das comuns.</translation>
    </message>
    <message>
        <source>name</source>
        <translation>nome</translation>
    </message>
    <message>
        <source>Name of the point.</source>
        <translation>Nome do ponto.</translation>
    </message>
    <message>
        <source>Nominal coordinate x in the point&apos;s own frame.</source>
        <translation>Coordenada nominal x no referencial próprio do ponto.</translation>
    </message>
    <message>
        <source>Nominal coordinate y in the point&apos;s own frame.</source>
        <translation>Coordenada nominal y no referencial próprio do ponto.</translation>
    </message>
    <message>
        <source>Nominal coordinate z in the point&apos;s own frame.</source>
        <translation>Coordenada nominal z no referencial próprio do ponto.</translation>
    </message>
    <message>
        <source>Standard uncertainty of this x; empty: as typed for all.</source>
        <translation>Incerteza-padrão deste x; vazio: a digitada para todos.</translation>
    </message>
    <message>
        <source>Standard uncertainty of this y; empty: as typed for all.</source>
        <translation>Incerteza-padrão deste y; vazio: a digitada para todos.</translation>
    </message>
    <message>
        <source>Standard uncertainty of this z; empty: as typed for all.</source>
        <translation>Incerteza-padrão deste z; vazio: a digitada para todos.</translation>
    </message>
    <message>
        <source>Frame from its points</source>
        <translation>Referencial a partir de seus pontos</translation>
    </message>
    <message>
        <source>3-2-1: the origin from point 1, the x-axis from points 1 and 2, the xy-plane from points 1, 2 and 3. Least squares: the frame in which the nominal coordinates fit all points best.</source>
        <translation>3-2-1: a origem pelo ponto 1, o eixo x pelos pontos 1 e 2, o plano xy pelos pontos 1, 2 e 3. Mínimos quadrados: o referencial em que as coordenadas nominais melhor se ajustam a todos os pontos.</translation>
    </message>
    <message>
        <source>3-2-1</source>
        <translation>3-2-1</translation>
    </message>
    <message>
        <source>least squares</source>
        <translation>mínimos quadrados</translation>
    </message>
    <message>
        <source>Side of point 3</source>
        <translation>Lado do ponto 3</translation>
    </message>
    <message>
        <source>On which side of the x-axis point 3 lies in the base frame b; this directs z.</source>
        <translation>De que lado do eixo x está o ponto 3 no referencial da base b; isto dá o sentido de z.</translation>
    </message>
    <message>
        <source>negative y: z = (q3 − q1) × x</source>
        <translation>y negativo: z = (q3 − q1) × x</translation>
    </message>
    <message>
        <source>positive y: z = x × (q3 − q1)</source>
        <translation>y positivo: z = x × (q3 − q1)</translation>
    </message>
    <message>
        <source>Origin from point 1, x</source>
        <translation>Origem a partir do ponto 1, x</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along x of the base frame b (s of Eqs 17 and 18).</source>
        <translation>Posição da origem a partir do ponto 1 ao longo de x do referencial da base b (s das Eqs. 17 e 18).</translation>
    </message>
    <message>
        <source>Origin from point 1, y</source>
        <translation>Origem a partir do ponto 1, y</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along y of the base frame b (s of Eqs 17 and 18).</source>
        <translation>Posição da origem a partir do ponto 1 ao longo de y do referencial da base b (s das Eqs. 17 e 18).</translation>
    </message>
    <message>
        <source>Origin from point 1, z</source>
        <translation>Origem a partir do ponto 1, z</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along z of the base frame b (s of Eqs 17 and 18).</source>
        <translation>Posição da origem a partir do ponto 1 ao longo de z do referencial da base b (s das Eqs. 17 e 18).</translation>
    </message>
    <message>
        <source>Pose of the base in frame 0</source>
        <translation>Pose da base no referencial 0</translation>
    </message>
    <message>
        <source>Where the base stands in the frame of the measurement (frame 0, the world of the picture). It matters only for an instrument that stands somewhere.</source>
        <translation>Onde está a base no referencial da medição (referencial 0, o mundo da imagem). Só importa para um instrumento que está em algum lugar.</translation>
    </message>
    <message>
        <source>Moving frame</source>
        <translation>Referencial móvel</translation>
    </message>
    <message>
        <source>Points of the moving frame</source>
        <translation>Pontos do referencial móvel</translation>
    </message>
    <message>
        <source>On which side of the x-axis point 3 lies in the moving frame p; this directs z.</source>
        <translation>De que lado do eixo x está o ponto 3 no referencial móvel p; isto dá o sentido de z.</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along x of the moving frame p (s of Eqs 17 and 18).</source>
        <translation>Posição da origem a partir do ponto 1 ao longo de x do referencial móvel p (s das Eqs. 17 e 18).</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along y of the moving frame p (s of Eqs 17 and 18).</source>
        <translation>Posição da origem a partir do ponto 1 ao longo de y do referencial móvel p (s das Eqs. 17 e 18).</translation>
    </message>
    <message>
        <source>Position of the origin from point 1 along z of the moving frame p (s of Eqs 17 and 18).</source>
        <translation>Posição da origem a partir do ponto 1 ao longo de z do referencial móvel p (s das Eqs. 17 e 18).</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>Poses</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>Avaliação</translation>
    </message>
    <message>
        <source>A priori: at the nominal coordinates. A posteriori: at the means of measured coordinates.</source>
        <translation>A priori: nas coordenadas nominais. A posteriori: nas médias das coordenadas medidas.</translation>
    </message>
    <message>
        <source>a priori (nominal poses)</source>
        <translation>a priori (poses nominais)</translation>
    </message>
    <message>
        <source>a posteriori (measured points)</source>
        <translation>a posteriori (pontos medidos)</translation>
    </message>
    <message>
        <source>Nominal poses of the moving frame in the base frame; angles are R = Rz(γ) Ry(β) Rx(α). All poses share the measurement of the base.</source>
        <translation>Poses nominais do referencial móvel no referencial da base; os ângulos são R = Rz(γ) Ry(β) Rx(α). Todas as poses compartilham a medição da base.</translation>
    </message>
    <message>
        <source>Name of the pose; groups its results.</source>
        <translation>Nome da pose; agrupa seus resultados.</translation>
    </message>
    <message>
        <source>Position x in the base frame.</source>
        <translation>Posição x no referencial da base.</translation>
    </message>
    <message>
        <source>Position y in the base frame.</source>
        <translation>Posição y no referencial da base.</translation>
    </message>
    <message>
        <source>Position z in the base frame.</source>
        <translation>Posição z no referencial da base.</translation>
    </message>
    <message>
        <source>Rotation about x.</source>
        <translation>Rotação em torno de x.</translation>
    </message>
    <message>
        <source>Rotation about y.</source>
        <translation>Rotação em torno de y.</translation>
    </message>
    <message>
        <source>Rotation about z.</source>
        <translation>Rotação em torno de z.</translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation>Pontos medidos</translation>
    </message>
    <message>
        <source>Coordinates in one frame 0 for the base and every pose, typed or from a CSV file; the mean of the repeats is the estimate.</source>
        <translation>Coordenadas em um referencial 0 para a base e cada pose, digitadas ou de um arquivo CSV; a média das repetições é a estimativa.</translation>
    </message>
    <message>
        <source>set</source>
        <translation>conjunto</translation>
    </message>
    <message>
        <source>&quot;base&quot;, or the name of a pose.</source>
        <translation>&quot;base&quot;, ou o nome de uma pose.</translation>
    </message>
    <message>
        <source>point</source>
        <translation>ponto</translation>
    </message>
    <message>
        <source>repeat</source>
        <translation>repetição</translation>
    </message>
    <message>
        <source>Number of the repetition.</source>
        <translation>Número da repetição.</translation>
    </message>
    <message>
        <source>Measured coordinate x in frame 0.</source>
        <translation>Coordenada medida x no referencial 0.</translation>
    </message>
    <message>
        <source>Measured coordinate y in frame 0.</source>
        <translation>Coordenada medida y no referencial 0.</translation>
    </message>
    <message>
        <source>Measured coordinate z in frame 0.</source>
        <translation>Coordenada medida z no referencial 0.</translation>
    </message>
    <message>
        <source>Orientation stated as</source>
        <translation>Orientação expressa como</translation>
    </message>
    <message>
        <source>Numbers in which the result states the orientation of the moving frame. Angles are undefined in gimbal lock; rotation vector and quaternion are not.</source>
        <translation>Números em que o resultado expressa a orientação do referencial móvel. Os ângulos são indefinidos no bloqueio de cardã (gimbal lock); o vetor de rotação e o quatérnio não.</translation>
    </message>
    <message>
        <source>Z-Y-X angles (roll α, pitch β, yaw γ)</source>
        <translation>Ângulos Z-Y-X (rolagem α, arfagem β, guinada γ)</translation>
    </message>
    <message>
        <source>Z-Y-Z angles</source>
        <translation>Ângulos Z-Y-Z</translation>
    </message>
    <message>
        <source>rotation vector</source>
        <translation>vetor de rotação</translation>
    </message>
    <message>
        <source>unit quaternion</source>
        <translation>quatérnio unitário</translation>
    </message>
    <message>
        <source>Uncertainty: Base frame</source>
        <translation>Incerteza: referencial da base</translation>
    </message>
    <message>
        <source>Uncertainty of the points</source>
        <translation>Incerteza dos pontos</translation>
    </message>
    <message>
        <source>Standard uncertainties typed here, or those that an artefact or an instrument of the project gives.</source>
        <translation>Incertezas-padrão digitadas aqui, ou as que um artefato ou um instrumento do projeto fornece.</translation>
    </message>
    <message>
        <source>typed</source>
        <translation>digitadas</translation>
    </message>
    <message>
        <source>artefact or instrument</source>
        <translation>artefato ou instrumento</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along x of the base frame b.</source>
        <translation>Incerteza-padrão das coordenadas dos pontos ao longo de x do referencial da base b.</translation>
    </message>
    <message>
        <source>u_x is common</source>
        <translation>u_x é comum</translation>
    </message>
    <message>
        <source>One and the same deviation along x for all base points, instead of independent ones.</source>
        <translation>Um só e mesmo desvio ao longo de x para todos os pontos da base, em vez de desvios independentes.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along y of the base frame b.</source>
        <translation>Incerteza-padrão das coordenadas dos pontos ao longo de y do referencial da base b.</translation>
    </message>
    <message>
        <source>u_y is common</source>
        <translation>u_y é comum</translation>
    </message>
    <message>
        <source>One and the same deviation along y for all base points, instead of independent ones.</source>
        <translation>Um só e mesmo desvio ao longo de y para todos os pontos da base, em vez de desvios independentes.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along z of the base frame b.</source>
        <translation>Incerteza-padrão das coordenadas dos pontos ao longo de z do referencial da base b.</translation>
    </message>
    <message>
        <source>u_z is common</source>
        <translation>u_z é comum</translation>
    </message>
    <message>
        <source>One and the same deviation along z for all base points, instead of independent ones.</source>
        <translation>Um só e mesmo desvio ao longo de z para todos os pontos da base, em vez de desvios independentes.</translation>
    </message>
    <message>
        <source>Their distribution</source>
        <translation>Sua distribuição</translation>
    </message>
    <message>
        <source>The distribution of typed deviations of the points; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation>A distribuição dos desvios digitados dos pontos; o que se declara é a incerteza-padrão, qualquer que seja a forma.</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>rectangular: limits ± √3 u</source>
        <translation>retangular: limites ± √3 u</translation>
    </message>
    <message>
        <source>triangular: limits ± √6 u</source>
        <translation>triangular: limites ± √6 u</translation>
    </message>
    <message>
        <source>arc sine: limits ± √2 u</source>
        <translation>arco seno: limites ± √2 u</translation>
    </message>
    <message>
        <source>Artefact or instrument</source>
        <translation>Artefato ou instrumento</translation>
    </message>
    <message>
        <source>Gives the uncertainty of the coordinates of the points of the base frame b.</source>
        <translation>Fornece a incerteza das coordenadas dos pontos do referencial da base b.</translation>
    </message>
    <message>
        <source>Uncertainty: Moving frame</source>
        <translation>Incerteza: referencial móvel</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along x of the moving frame p.</source>
        <translation>Incerteza-padrão das coordenadas dos pontos ao longo de x do referencial móvel p.</translation>
    </message>
    <message>
        <source>One and the same deviation along x for all points of the moving frame, in all poses, instead of independent ones.</source>
        <translation>Um só e mesmo desvio ao longo de x para todos os pontos do referencial móvel, em todas as poses, em vez de desvios independentes.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along y of the moving frame p.</source>
        <translation>Incerteza-padrão das coordenadas dos pontos ao longo de y do referencial móvel p.</translation>
    </message>
    <message>
        <source>One and the same deviation along y for all points of the moving frame, in all poses, instead of independent ones.</source>
        <translation>Um só e mesmo desvio ao longo de y para todos os pontos do referencial móvel, em todas as poses, em vez de desvios independentes.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the points&apos; coordinates along z of the moving frame p.</source>
        <translation>Incerteza-padrão das coordenadas dos pontos ao longo de z do referencial móvel p.</translation>
    </message>
    <message>
        <source>One and the same deviation along z for all points of the moving frame, in all poses, instead of independent ones.</source>
        <translation>Um só e mesmo desvio ao longo de z para todos os pontos do referencial móvel, em todas as poses, em vez de desvios independentes.</translation>
    </message>
    <message>
        <source>Gives the uncertainty of the coordinates of the points of the moving frame p.</source>
        <translation>Fornece a incerteza das coordenadas dos pontos do referencial móvel p.</translation>
    </message>
    <message>
        <source>Uncertainties along</source>
        <translation>Incertezas ao longo de</translation>
    </message>
    <message>
        <source>Along which axes the typed uncertainties of the moving points lie: those of the moving frame, which turn with it, or those of the base frame, the same in all poses.</source>
        <translation>Ao longo de que eixos estão as incertezas digitadas dos pontos móveis: os do referencial móvel, que giram com ele, ou os do referencial da base, iguais em todas as poses.</translation>
    </message>
    <message>
        <source>the axes of the moving frame</source>
        <translation>os eixos do referencial móvel</translation>
    </message>
    <message>
        <source>the axes of the base frame</source>
        <translation>os eixos do referencial da base</translation>
    </message>
    <message>
        <source>Points from sensors</source>
        <translation>Pontos a partir de sensores</translation>
    </message>
    <message>
        <source>Network</source>
        <translation>Rede</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>Sensores</translation>
    </message>
    <message>
        <source>The instruments of the network, each an instrument of the project that stands somewhere.</source>
        <translation>Os instrumentos da rede, cada um deles um instrumento do projeto que está em algum lugar.</translation>
    </message>
    <message>
        <source>sensor</source>
        <translation>sensor</translation>
    </message>
    <message>
        <source>An instrument of the project.</source>
        <translation>Um instrumento do projeto.</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Alvos</translation>
    </message>
    <message>
        <source>Points to be localised, at their nominal coordinates.</source>
        <translation>Pontos a localizar, em suas coordenadas nominais.</translation>
    </message>
    <message>
        <source>Name of the target, unique.</source>
        <translation>Nome do alvo, único.</translation>
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
        <translation>nova configuração</translation>
    </message>
    <message>
        <source>The sensors were located anew before this target: it and those below share the deviations of the stations with each other, not with the targets above.</source>
        <translation>Os sensores foram localizados de novo antes deste alvo: ele e os que estão abaixo compartilham entre si os desvios das estações, mas não com os alvos acima.</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Distâncias</translation>
    </message>
    <message>
        <source>Distances between targets that are measurands too, for instance of a scale bar.</source>
        <translation>Distâncias entre alvos que também são mensurandos, por exemplo de uma barra de escala.</translation>
    </message>
    <message>
        <source>from</source>
        <translation>de</translation>
    </message>
    <message>
        <source>Name of a target.</source>
        <translation>Nome de um alvo.</translation>
    </message>
    <message>
        <source>to</source>
        <translation>até</translation>
    </message>
    <message>
        <source>Name of another target.</source>
        <translation>Nome de outro alvo.</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Ângulos</translation>
    </message>
    <message>
        <source>Angles at a target between the directions to two others, measurands too.</source>
        <translation>Ângulos em um alvo entre as direções a outros dois, também mensurandos.</translation>
    </message>
    <message>
        <source>at</source>
        <translation>em</translation>
    </message>
    <message>
        <source>Name of the target where the angle is.</source>
        <translation>Nome do alvo onde está o ângulo.</translation>
    </message>
    <message>
        <source>Name of a third target.</source>
        <translation>Nome de um terceiro alvo.</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Referenciais</translation>
    </message>
    <message>
        <source>Frames on three targets (3-2-1), whose position and Z-Y-X angles in the world are measurands too.</source>
        <translation>Referenciais em três alvos (3-2-1), cuja posição e cujos ângulos Z-Y-X no mundo também são mensurandos.</translation>
    </message>
    <message>
        <source>Name of the frame, unique.</source>
        <translation>Nome do referencial, único.</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>origem</translation>
    </message>
    <message>
        <source>Target at its origin.</source>
        <translation>Alvo em sua origem.</translation>
    </message>
    <message>
        <source>on x</source>
        <translation>em x</translation>
    </message>
    <message>
        <source>Target on its positive x-axis.</source>
        <translation>Alvo em seu eixo x positivo.</translation>
    </message>
    <message>
        <source>in xy</source>
        <translation>em xy</translation>
    </message>
    <message>
        <source>Target in its xy-plane, at positive y.</source>
        <translation>Alvo em seu plano xy, em y positivo.</translation>
    </message>
    <message>
        <source>Calibrated lengths</source>
        <translation>Comprimentos calibrados</translation>
    </message>
    <message>
        <source>Scale bars and other calibrated distances between two targets: compared with the network, or a constraint of the estimation.</source>
        <translation>Barras de escala e outras distâncias calibradas entre dois alvos: comparadas com a rede, ou uma restrição da estimação.</translation>
    </message>
    <message>
        <source>length</source>
        <translation>comprimento</translation>
    </message>
    <message>
        <source>Calibrated length; empty in a design: the distance of the nominal targets.</source>
        <translation>Comprimento calibrado; vazio em um planejamento: a distância dos alvos nominais.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the length as it is during the measurement, with temperature.</source>
        <translation>Incerteza-padrão do comprimento tal como é durante a medição, com a temperatura.</translation>
    </message>
    <message>
        <source>role</source>
        <translation>papel</translation>
    </message>
    <message>
        <source>Check: the difference between network and calibration is a measurand. Constraint: the length is adjusted with the readings.</source>
        <translation>Verificação: a diferença entre rede e calibração é um mensurando. Restrição: o comprimento é ajustado com as leituras.</translation>
    </message>
    <message>
        <source>check</source>
        <translation>verificação</translation>
    </message>
    <message>
        <source>constraint</source>
        <translation>restrição</translation>
    </message>
    <message>
        <source>distribution</source>
        <translation>distribuição</translation>
    </message>
    <message>
        <source>The distribution that has the standard uncertainty u; empty: normal.</source>
        <translation>A distribuição que tem a incerteza-padrão u; vazio: normal.</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Leituras</translation>
    </message>
    <message>
        <source>A priori: the readings are those of the nominal targets. A posteriori: the readings are given.</source>
        <translation>A priori: as leituras são as dos alvos nominais. A posteriori: as leituras são dadas.</translation>
    </message>
    <message>
        <source>a priori (design: nominal targets)</source>
        <translation>a priori (planejamento: alvos nominais)</translation>
    </message>
    <message>
        <source>a posteriori (given readings)</source>
        <translation>a posteriori (leituras dadas)</translation>
    </message>
    <message>
        <source>What the sensors read, one row for a sensor and a target, typed or from a CSV file; leave empty what was not read.</source>
        <translation>O que os sensores leem, uma linha para cada sensor e alvo, digitada ou de um arquivo CSV; deixe vazio o que não foi lido.</translation>
    </message>
    <message>
        <source>target</source>
        <translation>alvo</translation>
    </message>
    <message>
        <source>Name of the target.</source>
        <translation>Nome do alvo.</translation>
    </message>
    <message>
        <source>The instrument that read it.</source>
        <translation>O instrumento que o leu.</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>distância</translation>
    </message>
    <message>
        <source>Slope distance.</source>
        <translation>Distância inclinada.</translation>
    </message>
    <message>
        <source>azimuth</source>
        <translation>azimute</translation>
    </message>
    <message>
        <source>Horizontal angle from the sensor&apos;s x-axis, positive towards y; whole turns do not matter.</source>
        <translation>Ângulo horizontal a partir do eixo x do sensor, positivo em direção a y; voltas inteiras não importam.</translation>
    </message>
    <message>
        <source>elevation</source>
        <translation>elevação</translation>
    </message>
    <message>
        <source>Vertical angle above the sensor&apos;s xy-plane.</source>
        <translation>Ângulo vertical acima do plano xy do sensor.</translation>
    </message>
    <message>
        <source>Estimation</source>
        <translation>Estimação</translation>
    </message>
    <message>
        <source>Estimator</source>
        <translation>Estimador</translation>
    </message>
    <message>
        <source>How a target&apos;s coordinates follow from its readings.</source>
        <translation>Como as coordenadas de um alvo resultam de suas leituras.</translation>
    </message>
    <message>
        <source>non-linear weighted least squares</source>
        <translation>mínimos quadrados ponderados não lineares</translation>
    </message>
    <message>
        <source>linearised equations: OLS, then GLS (Eqs 1-4 of the paper)</source>
        <translation>linearizadas: OLS, depois GLS (Eqs. 1-4 do artigo)</translation>
    </message>
    <message>
        <source>linearised equations: OLS alone (Eq 3 of the paper)</source>
        <translation>equações linearizadas: só OLS (Eq. 3 do artigo)</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Pesos</translation>
    </message>
    <message>
        <source>What the weights of the equations account for. Weights from the readings alone, as in the paper, are not the best where the stations are uncertain.</source>
        <translation>O que os pesos das equações levam em conta. Pesos só das leituras, como no artigo, não são os melhores onde as estações são incertas.</translation>
    </message>
    <message>
        <source>readings and stations, all targets of a set-up at once</source>
        <translation>leituras e estações, juntas por configuração</translation>
    </message>
    <message>
        <source>readings alone, each target by itself (the paper)</source>
        <translation>só leituras, cada alvo por si (o artigo)</translation>
    </message>
    <message>
        <source>TCP from ballbars</source>
        <translation>TCP a partir de ballbars</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Medição</translation>
    </message>
    <message>
        <source>Ballbars</source>
        <translation>Ballbars</translation>
    </message>
    <message>
        <source>The set of telescopic ballbars that measures the points.</source>
        <translation>O conjunto de ballbars telescópicos que mede os pontos.</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robô</translation>
    </message>
    <message>
        <source>Gives the repeatability with which the robot goes to the points; none: an ideal robot.</source>
        <translation>Fornece a repetibilidade com que o robô vai aos pontos; nenhum: um robô ideal.</translation>
    </message>
    <message>
        <source>The tool centre point from a planned procedure or from measured points; or only the points as the ballbars measure them.</source>
        <translation>O ponto central da ferramenta por um procedimento planejado ou por pontos medidos; ou só os pontos como os ballbars os medem.</translation>
    </message>
    <message>
        <source>tool centre point, planned procedure</source>
        <translation>ponto central da ferramenta, procedimento planejado</translation>
    </message>
    <message>
        <source>tool centre point, measured points</source>
        <translation>ponto central da ferramenta, pontos medidos</translation>
    </message>
    <message>
        <source>points alone</source>
        <translation>só pontos</translation>
    </message>
    <message>
        <source>Procedure</source>
        <translation>Procedimento</translation>
    </message>
    <message>
        <source>Flange</source>
        <translation>Flange</translation>
    </message>
    <message>
        <source>Pose of the flange in the robot&apos;s frame before it turns; its origin is the centre of the sphere on which the ball moves.</source>
        <translation>Pose do flange no referencial do robô antes de girar; sua origem é o centro da esfera sobre a qual a esfera-alvo se move.</translation>
    </message>
    <message>
        <source>Tool x</source>
        <translation>Ferramenta x</translation>
    </message>
    <message>
        <source>Nominal coordinate x of the tool centre point in the flange&apos;s frame.</source>
        <translation>Coordenada nominal x do ponto central da ferramenta no referencial do flange.</translation>
    </message>
    <message>
        <source>Tool y</source>
        <translation>Ferramenta y</translation>
    </message>
    <message>
        <source>Nominal coordinate y of the tool centre point in the flange&apos;s frame.</source>
        <translation>Coordenada nominal y do ponto central da ferramenta no referencial do flange.</translation>
    </message>
    <message>
        <source>Tool z</source>
        <translation>Ferramenta z</translation>
    </message>
    <message>
        <source>Nominal coordinate z of the tool centre point in the flange&apos;s frame.</source>
        <translation>Coordenada nominal z do ponto central da ferramenta no referencial do flange.</translation>
    </message>
    <message>
        <source>Rotations</source>
        <translation>Rotações</translation>
    </message>
    <message>
        <source>Two or three rotations of the flange about its own axes, its origin held in place: the ball traces an arc in each.</source>
        <translation>Duas ou três rotações do flange em torno de seus próprios eixos, com a origem mantida no lugar: em cada uma a esfera-alvo traça um arco.</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>eixo</translation>
    </message>
    <message>
        <source>Axis of the flange about which the robot turns.</source>
        <translation>Eixo do flange em torno do qual o robô gira.</translation>
    </message>
    <message>
        <source>start</source>
        <translation>início</translation>
    </message>
    <message>
        <source>Angle at the first point.</source>
        <translation>Ângulo no primeiro ponto.</translation>
    </message>
    <message>
        <source>span</source>
        <translation>abertura</translation>
    </message>
    <message>
        <source>Angle from the first point to the last; negative: turned the other way.</source>
        <translation>Ângulo do primeiro ponto ao último; negativo: girado no outro sentido.</translation>
    </message>
    <message>
        <source>points</source>
        <translation>pontos</translation>
    </message>
    <message>
        <source>Number of points, equally spaced from the first to the last.</source>
        <translation>Número de pontos, igualmente espaçados do primeiro ao último.</translation>
    </message>
    <message>
        <source>Points as measured, each with the axis of its rotation and the commanded angle, typed or from a CSV file.</source>
        <translation>Pontos como medidos, cada um com o eixo de sua rotação e o ângulo comandado, digitados ou de um arquivo CSV.</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>ângulo</translation>
    </message>
    <message>
        <source>Commanded angle of rotation.</source>
        <translation>Ângulo de rotação comandado.</translation>
    </message>
    <message>
        <source>Coordinate x in the frame of the ballbars.</source>
        <translation>Coordenada x no referencial dos ballbars.</translation>
    </message>
    <message>
        <source>Coordinate y in the frame of the ballbars.</source>
        <translation>Coordenada y no referencial dos ballbars.</translation>
    </message>
    <message>
        <source>Coordinate z in the frame of the ballbars.</source>
        <translation>Coordenada z no referencial dos ballbars.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Pontos</translation>
    </message>
    <message>
        <source>Places of the ball that are measured, typed or from a CSV file.</source>
        <translation>Lugares da esfera-alvo que são medidos, digitados ou de um arquivo CSV.</translation>
    </message>
    <message>
        <source>Name of the point, unique.</source>
        <translation>Nome do ponto, único.</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuste</translation>
    </message>
    <message>
        <source>Axes of the flange</source>
        <translation>Eixos do flange</translation>
    </message>
    <message>
        <source>Measured axes are not exactly perpendicular: which one is kept as measured. A third measured axis then only helps the sphere and the mean.</source>
        <translation>Os eixos medidos não são exatamente perpendiculares: qual deles se mantém como medido. Um terceiro eixo medido só ajuda então a esfera e a média.</translation>
    </message>
    <message>
        <source>y as measured, x nearest to measured</source>
        <translation>y como medido, x o mais próximo do medido</translation>
    </message>
    <message>
        <source>x as measured, y nearest to measured</source>
        <translation>x como medido, y o mais próximo do medido</translation>
    </message>
    <message>
        <source>z as measured, x nearest to measured</source>
        <translation>z como medido, x o mais próximo do medido</translation>
    </message>
    <message>
        <source>nearest to all measured axes</source>
        <translation>o mais próximo de todos os eixos medidos</translation>
    </message>
    <message>
        <source>Centre of the flange</source>
        <translation>Centro do flange</translation>
    </message>
    <message>
        <source>Sphere through all points by linear least squares, or refined to least distances from it.</source>
        <translation>Esfera por todos os pontos por mínimos quadrados lineares, ou refinada para as menores distâncias a ela.</translation>
    </message>
    <message>
        <source>sphere, geometric fit from the linear one</source>
        <translation>esfera, ajuste geométrico a partir do linear</translation>
    </message>
    <message>
        <source>sphere, linear fit</source>
        <translation>esfera, ajuste linear</translation>
    </message>
    <message>
        <source>Robot pose</source>
        <translation>Pose do robô</translation>
    </message>
    <message>
        <source>The arm, with its parameters and their uncertainty.</source>
        <translation>O braço, com seus parâmetros e a incerteza deles.</translation>
    </message>
    <message>
        <source>Components of a parameter</source>
        <translation>Componentes de um parâmetro</translation>
    </message>
    <message>
        <source>Each by itself, so that the budget tells the sources apart; or combined into one normal deviation, which needs fewer draws.</source>
        <translation>Cada uma por si, para que o balanço distinga as fontes; ou combinadas em um desvio normal, que exige menos sorteios.</translation>
    </message>
    <message>
        <source>each by itself</source>
        <translation>cada uma por si</translation>
    </message>
    <message>
        <source>combined into one</source>
        <translation>combinadas em uma</translation>
    </message>
    <message>
        <source>Correlation of the parameters</source>
        <translation>Correlação dos parâmetros</translation>
    </message>
    <message>
        <source>Used as the robot states it; or ignored, as in the paper, to see what that does.</source>
        <translation>Usada como o robô a declara; ou ignorada, como no artigo, para ver o que isso causa.</translation>
    </message>
    <message>
        <source>used</source>
        <translation>usada</translation>
    </message>
    <message>
        <source>ignored (the paper)</source>
        <translation>ignorada (o artigo)</translation>
    </message>
    <message>
        <source>Poses by joint readings</source>
        <translation>Poses por leituras das juntas</translation>
    </message>
    <message>
        <source>Readings of the joints, typed or from a CSV file. An empty cell is the zero reading of the joint; a robot with fewer joints leaves the last columns empty.</source>
        <translation>Leituras das juntas, digitadas ou de um arquivo CSV. Uma célula vazia é a leitura de zero da junta; um robô com menos juntas deixa vazias as últimas colunas.</translation>
    </message>
    <message>
        <source>Name of the pose, unique.</source>
        <translation>Nome da pose, único.</translation>
    </message>
    <message>
        <source>Reading of joint 1, if it turns.</source>
        <translation>Leitura da junta 1, se ela gira.</translation>
    </message>
    <message>
        <source>Reading of joint 2, if it turns.</source>
        <translation>Leitura da junta 2, se ela gira.</translation>
    </message>
    <message>
        <source>Reading of joint 3, if it turns.</source>
        <translation>Leitura da junta 3, se ela gira.</translation>
    </message>
    <message>
        <source>Reading of joint 4, if it turns.</source>
        <translation>Leitura da junta 4, se ela gira.</translation>
    </message>
    <message>
        <source>Reading of joint 5, if it turns.</source>
        <translation>Leitura da junta 5, se ela gira.</translation>
    </message>
    <message>
        <source>Reading of joint 6, if it turns.</source>
        <translation>Leitura da junta 6, se ela gira.</translation>
    </message>
    <message>
        <source>Reading of joint 7, if it turns.</source>
        <translation>Leitura da junta 7, se ela gira.</translation>
    </message>
    <message>
        <source>Reading of joint 1, if it slides.</source>
        <translation>Leitura da junta 1, se ela desliza.</translation>
    </message>
    <message>
        <source>Reading of joint 2, if it slides.</source>
        <translation>Leitura da junta 2, se ela desliza.</translation>
    </message>
    <message>
        <source>Reading of joint 3, if it slides.</source>
        <translation>Leitura da junta 3, se ela desliza.</translation>
    </message>
    <message>
        <source>Reading of joint 4, if it slides.</source>
        <translation>Leitura da junta 4, se ela desliza.</translation>
    </message>
    <message>
        <source>Reading of joint 5, if it slides.</source>
        <translation>Leitura da junta 5, se ela desliza.</translation>
    </message>
    <message>
        <source>Reading of joint 6, if it slides.</source>
        <translation>Leitura da junta 6, se ela desliza.</translation>
    </message>
    <message>
        <source>Reading of joint 7, if it slides.</source>
        <translation>Leitura da junta 7, se ela desliza.</translation>
    </message>
    <message>
        <source>Poses by place</source>
        <translation>Poses por lugar</translation>
    </message>
    <message>
        <source>Places of the tool in the robot&apos;s base frame; the readings follow by inverse kinematics, within the limits and near those of the pose before.</source>
        <translation>Lugares da ferramenta no referencial da base do robô; as leituras resultam da cinemática inversa, dentro dos limites e perto das da pose anterior.</translation>
    </message>
    <message>
        <source>Name, unique.</source>
        <translation>Nome, único.</translation>
    </message>
    <message>
        <source>Coordinate x of the tool.</source>
        <translation>Coordenada x da ferramenta.</translation>
    </message>
    <message>
        <source>Coordinate y of the tool.</source>
        <translation>Coordenada y da ferramenta.</translation>
    </message>
    <message>
        <source>Coordinate z of the tool.</source>
        <translation>Coordenada z da ferramenta.</translation>
    </message>
    <message>
        <source>Orientation, R = Rz(gamma) Ry(beta) Rx(alpha); all three empty: any orientation.</source>
        <translation>Orientação, R = Rz(gamma) Ry(beta) Rx(alpha); os três vazios: qualquer orientação.</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Resultados</translation>
    </message>
    <message>
        <source>Numbers that state the orientation of the tool; none: the position alone.</source>
        <translation>Números que expressam a orientação da ferramenta; nenhum: só a posição.</translation>
    </message>
    <message>
        <source>none (position alone)</source>
        <translation>nenhum (só posição)</translation>
    </message>
    <message>
        <source>Results in</source>
        <translation>Resultados em</translation>
    </message>
    <message>
        <source>The frame in which position and orientation are stated.</source>
        <translation>O referencial em que posição e orientação são expressas.</translation>
    </message>
    <message>
        <source>the base frame of the robot</source>
        <translation>o referencial da base do robô</translation>
    </message>
    <message>
        <source>the world frame</source>
        <translation>o referencial do mundo</translation>
    </message>
    <message>
        <source>Robot by joint trajectories</source>
        <translation>Robô por trajetórias das juntas</translation>
    </message>
    <message>
        <source>Nominal robot</source>
        <translation>Robô nominal</translation>
    </message>
    <message>
        <source>The arm as designed: directions of the frames, definitions of base and last link, and the arm of a simulation.</source>
        <translation>O braço como projetado: direções dos referenciais, definições da base e do último elo, e o braço de uma simulação.</translation>
    </message>
    <message>
        <source>Points are</source>
        <translation>Os pontos são</translation>
    </message>
    <message>
        <source>Measured: a table. Simulated: those of the nominal robot, to see what an experiment would give.</source>
        <translation>Medidos: uma tabela. Simulados: os do robô nominal, para ver o que um experimento daria.</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>medidos</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>simulados</translation>
    </message>
    <message>
        <source>Points of the ball at the flange in the order in which they were measured, joint by joint, in the frame of the instrument&apos;s world; typed or from a CSV file.</source>
        <translation>Pontos da esfera-alvo no flange na ordem em que foram medidos, junta por junta, no referencial do mundo do instrumento; digitados ou de um arquivo CSV.</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>junta</translation>
    </message>
    <message>
        <source>Number of the joint that turned.</source>
        <translation>Número da junta que girou.</translation>
    </message>
    <message>
        <source>Reading of that joint; says which way round the points run. Empty: with the joint&apos;s positive direction.</source>
        <translation>Leitura dessa junta; diz em que sentido correm os pontos. Vazio: no sentido positivo da junta.</translation>
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
        <translation>Faixa de cada junta, ±</translation>
    </message>
    <message>
        <source>Each joint turns from its zero reading less this to its zero reading plus this.</source>
        <translation>Cada junta gira de sua leitura de zero menos este valor até sua leitura de zero mais este valor.</translation>
    </message>
    <message>
        <source>Points for each joint</source>
        <translation>Pontos para cada junta</translation>
    </message>
    <message>
        <source>Number of points, evenly spaced over the range.</source>
        <translation>Número de pontos, uniformemente espaçados na faixa.</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Esfera-alvo</translation>
    </message>
    <message>
        <source>Where the ball is in the frame of the last link. On the axis of a joint it draws no circle.</source>
        <translation>Onde está a esfera-alvo no referencial do último elo. No eixo de uma junta ela não traça círculo.</translation>
    </message>
    <message>
        <source>A standard uncertainty of every coordinate, or an instrument of the project that stands somewhere.</source>
        <translation>Uma incerteza-padrão de cada coordenada, ou um instrumento do projeto que está em algum lugar.</translation>
    </message>
    <message>
        <source>typed: alike for all coordinates</source>
        <translation>digitada: igual para todas as coordenadas</translation>
    </message>
    <message>
        <source>an instrument</source>
        <translation>um instrumento</translation>
    </message>
    <message>
        <source>Standard uncertainty of a coordinate</source>
        <translation>Incerteza-padrão de uma coordenada</translation>
    </message>
    <message>
        <source>Of every coordinate of every point, independent of all others.</source>
        <translation>De cada coordenada de cada ponto, independente de todas as outras.</translation>
    </message>
    <message>
        <source>The distribution of the coordinates&apos; deviations; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation>A distribuição dos desvios das coordenadas; o que se declara é a incerteza-padrão, qualquer que seja a forma.</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>Instrumento</translation>
    </message>
    <message>
        <source>What measured the points: each reading deviates by itself, its scale and its station alike for all points.</source>
        <translation>O que mediu os pontos: cada leitura desvia por si, sua escala e sua estação igualmente para todos os pontos.</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>Plane of a circle</source>
        <translation>Plano de um círculo</translation>
    </message>
    <message>
        <source>Total least squares fits any plane. Eq 1 of the paper has no plane through the origin and fails near it.</source>
        <translation>Os mínimos quadrados totais ajustam qualquer plano. A Eq. 1 do artigo não tem plano pela origem e falha perto dela.</translation>
    </message>
    <message>
        <source>total least squares</source>
        <translation>mínimos quadrados totais</translation>
    </message>
    <message>
        <source>A x + B y + C z + 1 = 0 (Eq 1)</source>
        <translation>A x + B y + C z + 1 = 0 (Eq. 1)</translation>
    </message>
    <message>
        <source>Axes are parallel below</source>
        <translation>Eixos paralelos abaixo de</translation>
    </message>
    <message>
        <source>Angle between two axes below which they are described by beta and not by their common perpendicular, whose place is then hardly determined.</source>
        <translation>Ângulo entre dois eixos abaixo do qual são descritos por beta e não por sua perpendicular comum, cujo lugar fica então mal determinado.</translation>
    </message>
    <message>
        <source>Robot from measured poses</source>
        <translation>Robô a partir de poses medidas</translation>
    </message>
    <message>
        <source>The arm as designed: start of the fit, values of what the poses cannot tell, uncertainty of the readings of its joints, and the arm of a simulation.</source>
        <translation>O braço como projetado: início do ajuste, valores do que as poses não podem revelar, incerteza das leituras de suas juntas, e o braço de uma simulação.</translation>
    </message>
    <message>
        <source>Poses are</source>
        <translation>As poses são</translation>
    </message>
    <message>
        <source>Measured is</source>
        <translation>Mede-se</translation>
    </message>
    <message>
        <source>The position of a ball alone, or position and orientation of the tool.</source>
        <translation>Só a posição de uma esfera-alvo, ou posição e orientação da ferramenta.</translation>
    </message>
    <message>
        <source>the position</source>
        <translation>a posição</translation>
    </message>
    <message>
        <source>position and orientation</source>
        <translation>posição e orientação</translation>
    </message>
    <message>
        <source>Measured poses</source>
        <translation>Poses medidas</translation>
    </message>
    <message>
        <source>Readings of the joints and the place of the ball or tool that was measured there; typed or from a CSV file.</source>
        <translation>Leituras das juntas e o lugar da esfera-alvo ou ferramenta ali medido; digitadas ou de um arquivo CSV.</translation>
    </message>
    <message>
        <source>use</source>
        <translation>uso</translation>
    </message>
    <message>
        <source>fit: taken into the fit. check: held back, to see how well the fit tells a pose that it has not seen. Empty: fit.</source>
        <translation>ajuste: entra no ajuste. verificação: retida, para ver quão bem o ajuste prevê uma pose que não viu. Vazio: ajuste.</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>ajuste</translation>
    </message>
    <message>
        <source>Reading of joint 1; empty: its zero reading.</source>
        <translation>Leitura da junta 1; vazio: sua leitura de zero.</translation>
    </message>
    <message>
        <source>Reading of joint 2; empty: its zero reading.</source>
        <translation>Leitura da junta 2; vazio: sua leitura de zero.</translation>
    </message>
    <message>
        <source>Reading of joint 3; empty: its zero reading.</source>
        <translation>Leitura da junta 3; vazio: sua leitura de zero.</translation>
    </message>
    <message>
        <source>Reading of joint 4; empty: its zero reading.</source>
        <translation>Leitura da junta 4; vazio: sua leitura de zero.</translation>
    </message>
    <message>
        <source>Reading of joint 5; empty: its zero reading.</source>
        <translation>Leitura da junta 5; vazio: sua leitura de zero.</translation>
    </message>
    <message>
        <source>Reading of joint 6; empty: its zero reading.</source>
        <translation>Leitura da junta 6; vazio: sua leitura de zero.</translation>
    </message>
    <message>
        <source>Reading of joint 7; empty: its zero reading.</source>
        <translation>Leitura da junta 7; vazio: sua leitura de zero.</translation>
    </message>
    <message>
        <source>Measured coordinate x in the frame of the instrument&apos;s world.</source>
        <translation>Coordenada medida x no referencial do mundo do instrumento.</translation>
    </message>
    <message>
        <source>Measured coordinate y in the frame of the instrument&apos;s world.</source>
        <translation>Coordenada medida y no referencial do mundo do instrumento.</translation>
    </message>
    <message>
        <source>Measured coordinate z in the frame of the instrument&apos;s world.</source>
        <translation>Coordenada medida z no referencial do mundo do instrumento.</translation>
    </message>
    <message>
        <source>Measured orientation, R = Rz(gamma) Ry(beta) Rx(alpha), where poses are measured.</source>
        <translation>Orientação medida, R = Rz(gamma) Ry(beta) Rx(alpha), onde se medem poses.</translation>
    </message>
    <message>
        <source>Number of poses</source>
        <translation>Número de poses</translation>
    </message>
    <message>
        <source>Poses of the simulated experiment, spread over the range of all joints, always the same.</source>
        <translation>Poses do experimento simulado, distribuídas pela faixa de todas as juntas, sempre as mesmas.</translation>
    </message>
    <message>
        <source>From the zero reading on, as far as the limits of the joint allow.</source>
        <translation>A partir da leitura de zero, até onde os limites da junta permitem.</translation>
    </message>
    <message>
        <source>Standard uncertainty of an orientation</source>
        <translation>Incerteza-padrão de uma orientação</translation>
    </message>
    <message>
        <source>Of the rotation of the measured tool about each of its axes, independent.</source>
        <translation>Da rotação da ferramenta medida em torno de cada um de seus eixos, independente.</translation>
    </message>
    <message>
        <source>Ball or tool</source>
        <translation>Esfera-alvo ou ferramenta</translation>
    </message>
    <message>
        <source>Where it is in the frame of the last link: exactly, or as a start of the fit.</source>
        <translation>Onde está no referencial do último elo: exatamente, ou como início do ajuste.</translation>
    </message>
    <message>
        <source>Place of the ball or tool is</source>
        <translation>O lugar da esfera-alvo ou ferramenta é</translation>
    </message>
    <message>
        <source>Found by the fit together with the parameters, or known.</source>
        <translation>Encontrado pelo ajuste junto com os parâmetros, ou conhecido.</translation>
    </message>
    <message>
        <source>found by the fit</source>
        <translation>encontrado pelo ajuste</translation>
    </message>
    <message>
        <source>known exactly</source>
        <translation>conhecido exatamente</translation>
    </message>
    <message>
        <source>Place of the base is</source>
        <translation>O lugar da base é</translation>
    </message>
    <message>
        <source>Found by the fit: the instrument stands anywhere. Known: the base stands where the robot says it stands in the world.</source>
        <translation>Encontrado pelo ajuste: o instrumento está em qualquer lugar. Conhecido: a base está onde o robô diz que está no mundo.</translation>
    </message>
    <message>
        <source>Parameters held</source>
        <translation>Parâmetros mantidos</translation>
    </message>
    <message>
        <source>Parameters that stay nominal although the poses could tell them.</source>
        <translation>Parâmetros que ficam nominais embora as poses pudessem revelá-los.</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>parâmetro</translation>
    </message>
    <message>
        <source>A parameter by its symbol, such as d_3 or alpha_4.</source>
        <translation>Um parâmetro por seu símbolo, como d_3 ou alpha_4.</translation>
    </message>
    <message>
        <source>Channels of a force/moment sensor</source>
        <translation>Canais de um sensor de força/momento</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Sensor</translation>
    </message>
    <message>
        <source>The calibrated multi-axis sensor.</source>
        <translation>O sensor multieixo calibrado.</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Uso</translation>
    </message>
    <message>
        <source>Loads on the other axes</source>
        <translation>Cargas nos outros eixos</translation>
    </message>
    <message>
        <source>What acts on the other axes while a channel is read. Unknown loads are rectangular between minus and plus the rated load, one and the same for all channels.</source>
        <translation>O que atua nos outros eixos enquanto se lê um canal. Cargas desconhecidas são retangulares entre menos e mais a carga nominal, uma só e a mesma para todos os canais.</translation>
    </message>
    <message>
        <source>none: one component alone</source>
        <translation>nenhuma: só uma componente</translation>
    </message>
    <message>
        <source>unknown on one axis, that with the largest interference</source>
        <translation>desconhecida em um eixo, o de maior interferência</translation>
    </message>
    <message>
        <source>unknown on all other axes</source>
        <translation>desconhecida em todos os outros eixos</translation>
    </message>
    <message>
        <source>Repeatability</source>
        <translation>Repetibilidade</translation>
    </message>
    <message>
        <source>The largest standard deviation of all steps, as in the paper, or that pooled over the steps, which has more degrees of freedom.</source>
        <translation>O maior desvio-padrão de todos os degraus, como no artigo, ou o agrupado sobre os degraus, que tem mais graus de liberdade.</translation>
    </message>
    <message>
        <source>largest of the steps</source>
        <translation>o maior dos degraus</translation>
    </message>
    <message>
        <source>pooled over the steps</source>
        <translation>agrupado sobre os degraus</translation>
    </message>
    <message>
        <source>Type A in Monte Carlo</source>
        <translation>Tipo A em Monte Carlo</translation>
    </message>
    <message>
        <source>Normal, with its degrees of freedom in the law of propagation, or a t-distribution (JCGM 101 6.4.9). With n = 3 the latter has no standard deviation: only coverage intervals then mean something.</source>
        <translation>Normal, com seus graus de liberdade na lei de propagação, ou uma distribuição t (JCGM 101 6.4.9). Com n = 3 esta não tem desvio-padrão: só os intervalos de abrangência têm então sentido.</translation>
    </message>
    <message>
        <source>scaled and shifted t</source>
        <translation>t escalada e deslocada</translation>
    </message>
    <message>
        <source>Coverage factor of the comparison</source>
        <translation>Fator de abrangência da comparação</translation>
    </message>
    <message>
        <source>k of the GUM&apos;s columns in the table beside the paper&apos;s.</source>
        <translation>k das colunas do GUM na tabela ao lado das do artigo.</translation>
    </message>
    <message>
        <source>Forces and moments by the calibration matrix</source>
        <translation>Forças e momentos pela matriz de calibração</translation>
    </message>
    <message>
        <source>Cases</source>
        <translation>Casos</translation>
    </message>
    <message>
        <source>Cases are given by</source>
        <translation>Os casos são dados por</translation>
    </message>
    <message>
        <source>Readings that were taken, or loads whose uncertainty is wanted.</source>
        <translation>Leituras que foram feitas, ou cargas cuja incerteza se procura.</translation>
    </message>
    <message>
        <source>readings</source>
        <translation>leituras</translation>
    </message>
    <message>
        <source>loads</source>
        <translation>cargas</translation>
    </message>
    <message>
        <source>Net readings of all channels, the unloaded readings subtracted.</source>
        <translation>Leituras líquidas de todos os canais, subtraídas as leituras sem carga.</translation>
    </message>
    <message>
        <source>Names the case in results.</source>
        <translation>Dá nome ao caso nos resultados.</translation>
    </message>
    <message>
        <source>Fx</source>
        <translation>Fx</translation>
    </message>
    <message>
        <source>Net reading of this channel.</source>
        <translation>Leitura líquida deste canal.</translation>
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
        <translation>Forças e momentos que atuam juntos; as leituras resultam da matriz de calibração. Uma célula vazia é zero.</translation>
    </message>
    <message>
        <source>Load on this axis.</source>
        <translation>Carga neste eixo.</translation>
    </message>
    <message>
        <source>Calibration matrix</source>
        <translation>Matriz de calibração</translation>
    </message>
    <message>
        <source>Least squares through zero over the increasing readings: slopes alone, or with the squares of the loads.</source>
        <translation>Mínimos quadrados por zero sobre as leituras crescentes: só inclinações, ou com os quadrados das cargas.</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>with quadratic terms</source>
        <translation>com termos quadráticos</translation>
    </message>
    <message>
        <source>Repeatability of a reading</source>
        <translation>Repetibilidade de uma leitura</translation>
    </message>
    <message>
        <source>The largest standard deviation of all steps, or that pooled over the steps.</source>
        <translation>O maior desvio-padrão de todos os degraus, ou o agrupado sobre os degraus.</translation>
    </message>
    <message>
        <source>Normal, with its degrees of freedom in the law of propagation, or a t-distribution (JCGM 101 6.4.9), which has no standard deviation with n = 3.</source>
        <translation>Normal, com seus graus de liberdade na lei de propagação, ou uma distribuição t (JCGM 101 6.4.9), que não tem desvio-padrão com n = 3.</translation>
    </message>
    <message>
        <source>Hysteresis of a reading</source>
        <translation>Histerese de uma leitura</translation>
    </message>
    <message>
        <source>Rectangular over the width of the loop: in proportion to the load on the channel&apos;s axis, or the full width at any load.</source>
        <translation>Retangular sobre a largura do laço: em proporção à carga no eixo do canal, ou a largura inteira com qualquer carga.</translation>
    </message>
    <message>
        <source>in proportion to the load</source>
        <translation>em proporção à carga</translation>
    </message>
    <message>
        <source>full at any load</source>
        <translation>inteira com qualquer carga</translation>
    </message>
    <message>
        <source>Measurement equation</source>
        <translation>Equação de medição</translation>
    </message>
    <message>
        <source>Equations</source>
        <translation>Equações</translation>
    </message>
    <message>
        <source>symbol</source>
        <translation>símbolo</translation>
    </message>
    <message>
        <source>Name that an equation defines.</source>
        <translation>Nome que uma equação define.</translation>
    </message>
    <message>
        <source>What it is, for tables and reports.</source>
        <translation>O que é, para tabelas e relatórios.</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>unidade</translation>
    </message>
    <message>
        <source>Unit of the result; empty: the SI unit that follows from the equations.</source>
        <translation>Unidade do resultado; vazio: a unidade SI que resulta das equações.</translation>
    </message>
    <message>
        <source>Measurands have coverage regions together; empty: measurand.</source>
        <translation>Os mensurandos têm regiões de abrangência em conjunto; vazio: mensurando.</translation>
    </message>
    <message>
        <source>measurand</source>
        <translation>mensurando</translation>
    </message>
    <message>
        <source>intermediate</source>
        <translation>intermediário</translation>
    </message>
    <message>
        <source>group</source>
        <translation>grupo</translation>
    </message>
    <message>
        <source>Results of one group have a joint coverage region.</source>
        <translation>Os resultados de um grupo têm uma região de abrangência conjunta.</translation>
    </message>
    <message>
        <source>Quantities</source>
        <translation>Grandezas</translation>
    </message>
    <message>
        <source>One row for each component of uncertainty. The first row of a symbol has its value and unit; further rows of the same symbol add components and have no value.</source>
        <translation>Uma linha para cada componente de incerteza. A primeira linha de um símbolo tem seu valor e unidade; outras linhas do mesmo símbolo acrescentam componentes e não têm valor.</translation>
    </message>
    <message>
        <source>Name that the equations use: x_1, alpha_s.</source>
        <translation>Nome que as equações usam: x_1, alpha_s.</translation>
    </message>
    <message>
        <source>What it is, or what the component is.</source>
        <translation>O que é, ou o que a componente é.</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valor</translation>
    </message>
    <message>
        <source>Estimate, in the row&apos;s unit; empty where observations or limits give it.</source>
        <translation>Estimativa, na unidade da linha; vazio onde observações ou limites a dão.</translation>
    </message>
    <message>
        <source>stated as</source>
        <translation>declarado como</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>constante</translation>
    </message>
    <message>
        <source>standard uncertainty</source>
        <translation>incerteza-padrão</translation>
    </message>
    <message>
        <source>certificate, U and k</source>
        <translation>certificado, U e k</translation>
    </message>
    <message>
        <source>certificate, U and p</source>
        <translation>certificado, U e p</translation>
    </message>
    <message>
        <source>rectangular</source>
        <translation>retangular</translation>
    </message>
    <message>
        <source>limits from a to b</source>
        <translation>limites de a até b</translation>
    </message>
    <message>
        <source>limits inexactly known</source>
        <translation>limites mal conhecidos</translation>
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
        <translation>arco seno</translation>
    </message>
    <message>
        <source>resolution</source>
        <translation>resolução</translation>
    </message>
    <message>
        <source>maximum permissible error</source>
        <translation>erro máximo admissível</translation>
    </message>
    <message>
        <source>exponential</source>
        <translation>exponencial</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>contagens</translation>
    </message>
    <message>
        <source>observations (Type A)</source>
        <translation>observações (Tipo A)</translation>
    </message>
    <message>
        <source>pooled observations (Type A)</source>
        <translation>observações agrupadas (Tipo A)</translation>
    </message>
    <message>
        <source>reading of an instrument</source>
        <translation>leitura de um instrumento</translation>
    </message>
    <message>
        <source>Second figure of the statement.</source>
        <translation>Segundo número da declaração.</translation>
    </message>
    <message>
        <source>Degrees of freedom; empty: infinite, or those of the observations.</source>
        <translation>Graus de liberdade; vazio: infinitos, ou os das observações.</translation>
    </message>
    <message>
        <source>Relative uncertainty of u instead of degrees of freedom (JCGM 100 G.3).</source>
        <translation>Incerteza relativa de u em vez de graus de liberdade (JCGM 100 G.3).</translation>
    </message>
    <message>
        <source>source</source>
        <translation>fonte</translation>
    </message>
    <message>
        <source>Where the figure comes from: certificate, data sheet, handbook.</source>
        <translation>De onde vem o número: certificado, folha de dados, manual.</translation>
    </message>
    <message>
        <source>instrument</source>
        <translation>instrumento</translation>
    </message>
    <message>
        <source>Instrument of the project that reads the quantity, a distance.</source>
        <translation>Instrumento do projeto que lê a grandeza, uma distância.</translation>
    </message>
    <message>
        <source>Observations</source>
        <translation>Observações</translation>
    </message>
    <message>
        <source>Repeated observations for Type A evaluations, typed, pasted or from a CSV file. Observations of several quantities with the same numbers were made together: their means are then correlated (JCGM 100 5.2.3).</source>
        <translation>Observações repetidas para avaliações Tipo A, digitadas, coladas ou de um arquivo CSV. Observações de várias grandezas com os mesmos números foram feitas juntas: suas médias são então correlacionadas (JCGM 100 5.2.3).</translation>
    </message>
    <message>
        <source>quantity</source>
        <translation>grandeza</translation>
    </message>
    <message>
        <source>Symbol of the quantity.</source>
        <translation>Símbolo da grandeza.</translation>
    </message>
    <message>
        <source>number</source>
        <translation>número</translation>
    </message>
    <message>
        <source>Number of the simultaneous observation; empty: the quantity was observed by itself.</source>
        <translation>Número da observação simultânea; vazio: a grandeza foi observada por si.</translation>
    </message>
    <message>
        <source>series</source>
        <translation>série</translation>
    </message>
    <message>
        <source>Name of an earlier series of the same procedure, for a pooled standard deviation.</source>
        <translation>Nome de uma série anterior do mesmo procedimento, para um desvio-padrão agrupado.</translation>
    </message>
    <message>
        <source>Observed value, in the unit of the quantity.</source>
        <translation>Valor observado, na unidade da grandeza.</translation>
    </message>
    <message>
        <source>Means of observations</source>
        <translation>Médias de observações</translation>
    </message>
    <message>
        <source>Distribution of a mean in Monte Carlo trials: Student t with the degrees of freedom of the observations (JCGM 101 6.4.9), or normal.</source>
        <translation>Distribuição de uma média nos ensaios de Monte Carlo: t de Student com os graus de liberdade das observações (JCGM 101 6.4.9), ou normal.</translation>
    </message>
    <message>
        <source>Student t</source>
        <translation>t de Student</translation>
    </message>
    <message>
        <source>Calibration curve</source>
        <translation>Curva de calibração</translation>
    </message>
    <message>
        <source>Unit of x</source>
        <translation>Unidade de x</translation>
    </message>
    <message>
        <source>Unit in which x is given. A difference of temperatures, a correction of a thermometer too, is given in K.</source>
        <translation>Unidade em que x é dado. Uma diferença de temperaturas, também a correção de um termômetro, é dada em K.</translation>
    </message>
    <message>
        <source>Unit of y</source>
        <translation>Unidade de y</translation>
    </message>
    <message>
        <source>Unit in which y is given. A difference of temperatures, a correction of a thermometer too, is given in K.</source>
        <translation>Unidade em que y é dado. Uma diferença de temperaturas, também a correção de um termômetro, é dada em K.</translation>
    </message>
    <message>
        <source>Points of the calibration, typed, pasted or from a CSV file.</source>
        <translation>Pontos da calibração, digitados, colados ou de um arquivo CSV.</translation>
    </message>
    <message>
        <source>Independent quantity, in its unit.</source>
        <translation>Grandeza independente, em sua unidade.</translation>
    </message>
    <message>
        <source>Standard uncertainty of x; empty: none. Used with stated uncertainties.</source>
        <translation>Incerteza-padrão de x; vazio: nenhuma. Usada com incertezas declaradas.</translation>
    </message>
    <message>
        <source>Observed quantity, in its unit.</source>
        <translation>Grandeza observada, em sua unidade.</translation>
    </message>
    <message>
        <source>Standard uncertainty of y. Used, and needed, with stated uncertainties.</source>
        <translation>Incerteza-padrão de y. Usada, e necessária, com incertezas declaradas.</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Curva</translation>
    </message>
    <message>
        <source>Degree</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Of the polynomial: 1 is a straight line.</source>
        <translation>Do polinômio: 1 é uma reta.</translation>
    </message>
    <message>
        <source>Origin x_0</source>
        <translation>Origem x_0</translation>
    </message>
    <message>
        <source>The polynomial is one of x - x_0, in the unit of x. In the middle of the points the coefficients are hardly correlated.</source>
        <translation>O polinômio é em x - x_0, na unidade de x. No meio dos pontos os coeficientes quase não são correlacionados.</translation>
    </message>
    <message>
        <source>Through the origin</source>
        <translation>Pela origem</translation>
    </message>
    <message>
        <source>No constant term: the curve is zero at x_0.</source>
        <translation>Sem termo constante: a curva é zero em x_0.</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Incerteza</translation>
    </message>
    <message>
        <source>From the scatter of the residuals about the curve (JCGM 100 H.3), or as stated for each point.</source>
        <translation>Da dispersão dos resíduos em torno da curva (JCGM 100 H.3), ou como declarada para cada ponto.</translation>
    </message>
    <message>
        <source>from the residuals</source>
        <translation>dos resíduos</translation>
    </message>
    <message>
        <source>as stated for x and y</source>
        <translation>como declarada para x e y</translation>
    </message>
    <message>
        <source>Use of the curve</source>
        <translation>Uso da curva</translation>
    </message>
    <message>
        <source>Where the value of the curve is wanted, with its uncertainty.</source>
        <translation>Onde se procura o valor da curva, com sua incerteza.</translation>
    </message>
    <message>
        <source>In the unit of x.</source>
        <translation>Na unidade de x.</translation>
    </message>
    <message>
        <source>Inverse use</source>
        <translation>Uso inverso</translation>
    </message>
    <message>
        <source>Observed values of y whose x is wanted, with its uncertainty.</source>
        <translation>Valores observados de y cujo x se procura, com sua incerteza.</translation>
    </message>
    <message>
        <source>Observed, in the unit of y.</source>
        <translation>Observado, na unidade de y.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the observed y; empty: none beside that of the readings.</source>
        <translation>Incerteza-padrão do y observado; vazio: nenhuma além da das leituras.</translation>
    </message>
    <message>
        <source>The observed y is the mean of so many readings, which scatter as the points of the calibration do. With the uncertainty from the residuals only.</source>
        <translation>O y observado é a média de tantas leituras, que se dispersam como os pontos da calibração. Só com a incerteza dos resíduos.</translation>
    </message>
    <message>
        <source>near</source>
        <translation>perto de</translation>
    </message>
    <message>
        <source>Of several x that give this y, the one nearest to here, in the unit of x. Needed where the curve reaches y more than once between its points.</source>
        <translation>De vários x que dão este y, o mais próximo daqui, na unidade de x. Necessário onde a curva atinge y mais de uma vez entre seus pontos.</translation>
    </message>
    <message>
        <source>Observations in groups</source>
        <translation>Observações em grupos</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Grandeza</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>Símbolo</translation>
    </message>
    <message>
        <source>Of the measured quantity.</source>
        <translation>Da grandeza medida.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>What is measured.</source>
        <translation>O que se mede.</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidade</translation>
    </message>
    <message>
        <source>In which the observations are given.</source>
        <translation>Em que são dadas as observações.</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Dados</translation>
    </message>
    <message>
        <source>Every observation, or mean and standard deviation of each group.</source>
        <translation>Cada observação, ou média e desvio-padrão de cada grupo.</translation>
    </message>
    <message>
        <source>observations</source>
        <translation>observações</translation>
    </message>
    <message>
        <source>means and standard deviations</source>
        <translation>médias e desvios-padrão</translation>
    </message>
    <message>
        <source>Observations with the day, instrument or operator they belong to, typed, pasted or from a CSV file.</source>
        <translation>Observações com o dia, instrumento ou operador a que pertencem, digitadas, coladas ou de um arquivo CSV.</translation>
    </message>
    <message>
        <source>Day, instrument or operator.</source>
        <translation>Dia, instrumento ou operador.</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Grupos</translation>
    </message>
    <message>
        <source>Mean and experimental standard deviation of the observations of each group.</source>
        <translation>Média e desvio-padrão experimental das observações de cada grupo.</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>média</translation>
    </message>
    <message>
        <source>Of the observations of the group, in the unit of the quantity.</source>
        <translation>Das observações do grupo, na unidade da grandeza.</translation>
    </message>
    <message>
        <source>Experimental standard deviation of a single observation of the group.</source>
        <translation>Desvio-padrão experimental de uma única observação do grupo.</translation>
    </message>
    <message>
        <source>Number of observations in the group; empty: observations per group, as below.</source>
        <translation>Número de observações no grupo; vazio: observações por grupo, como abaixo.</translation>
    </message>
    <message>
        <source>Observations per group</source>
        <translation>Observações por grupo</translation>
    </message>
    <message>
        <source>Number of observations in each group whose row does not say it.</source>
        <translation>Número de observações em cada grupo cuja linha não o diz.</translation>
    </message>
    <message>
        <source>Effect of the groups</source>
        <translation>Efeito dos grupos</translation>
    </message>
    <message>
        <source>Included: u of the mean of the groups&apos; means from their scatter. By components of variance: the same for groups of one size, else groups with more observations have more weight. Not included: all observations count as independent, which the F-test in the evaluation must allow.</source>
        <translation>Incluído: u da média das médias dos grupos, pela dispersão delas. Por componentes de variância: o mesmo para grupos de um só tamanho, senão grupos com mais observações têm mais peso. Não incluído: todas as observações contam como independentes, o que o teste F da avaliação deve permitir.</translation>
    </message>
    <message>
        <source>included</source>
        <translation>incluído</translation>
    </message>
    <message>
        <source>by components of variance</source>
        <translation>por componentes de variância</translation>
    </message>
    <message>
        <source>not included</source>
        <translation>não incluído</translation>
    </message>
    <message>
        <source>Artefact with calibrated points</source>
        <translation>Artefato com pontos calibrados</translation>
    </message>
    <message>
        <source>Artefact</source>
        <translation>Artefato</translation>
    </message>
    <message>
        <source>Calibrated points</source>
        <translation>Pontos calibrados</translation>
    </message>
    <message>
        <source>The artefact&apos;s points with their calibrated coordinates in the artefact&apos;s frame.</source>
        <translation>Os pontos do artefato com suas coordenadas calibradas no referencial do artefato.</translation>
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
        <translation>Coordenadas que definem o referencial (&quot;xyz&quot;, &quot;yz&quot;), quando são indicadas por ponto.</translation>
    </message>
    <message>
        <source>Evaluate from</source>
        <translation>Avaliar a partir de</translation>
    </message>
    <message>
        <source>Repeated measurements of the artefact, or the components of uncertainty as a report prints them (Table 1 of the paper).</source>
        <translation>Medições repetidas do artefato, ou as componentes de incerteza como um relatório as imprime (Tabela 1 do artigo).</translation>
    </message>
    <message>
        <source>components of uncertainty</source>
        <translation>componentes de incerteza</translation>
    </message>
    <message>
        <source>Measured coordinates in the artefact&apos;s frame: one row for each point and run, typed or from a CSV file.</source>
        <translation>Coordenadas medidas no referencial do artefato: uma linha para cada ponto e série, digitada ou de um arquivo CSV.</translation>
    </message>
    <message>
        <source>Name of a calibrated point.</source>
        <translation>Nome de um ponto calibrado.</translation>
    </message>
    <message>
        <source>run</source>
        <translation>série</translation>
    </message>
    <message>
        <source>Indicated coordinate x.</source>
        <translation>Coordenada indicada x.</translation>
    </message>
    <message>
        <source>Indicated coordinate y.</source>
        <translation>Coordenada indicada y.</translation>
    </message>
    <message>
        <source>Indicated coordinate z.</source>
        <translation>Coordenada indicada z.</translation>
    </message>
    <message>
        <source>Components of uncertainty</source>
        <translation>Componentes de incerteza</translation>
    </message>
    <message>
        <source>One row for each coordinate, as Table 1 of the paper prints them.</source>
        <translation>Uma linha para cada coordenada, como as imprime a Tabela 1 do artigo.</translation>
    </message>
    <message>
        <source>coordinate</source>
        <translation>coordenada</translation>
    </message>
    <message>
        <source>Coordinate of the row.</source>
        <translation>Coordenada da linha.</translation>
    </message>
    <message>
        <source>Calibration.</source>
        <translation>Calibração.</translation>
    </message>
    <message>
        <source>Temperature.</source>
        <translation>Temperatura.</translation>
    </message>
    <message>
        <source>Variability: standard deviation of the errors of indication.</source>
        <translation>Variabilidade: desvio-padrão dos erros de indicação.</translation>
    </message>
    <message>
        <source>Bias: mean of the errors of indication.</source>
        <translation>Tendência: média dos erros de indicação.</translation>
    </message>
    <message>
        <source>Number of observations, where it is known; gives the degrees of freedom.</source>
        <translation>Número de observações, onde é conhecido; fornece os graus de liberdade.</translation>
    </message>
    <message>
        <source>Coordinates that define the frame</source>
        <translation>Coordenadas que definem o referencial</translation>
    </message>
    <message>
        <source>Errors of these coordinates are zero by construction of the frame and are left out of the statistics.</source>
        <translation>Os erros destas coordenadas são zero por construção do referencial e ficam fora da estatística.</translation>
    </message>
    <message>
        <source>first point x, y, z; second y, z; third z</source>
        <translation>primeiro ponto x, y, z; segundo y, z; terceiro z</translation>
    </message>
    <message>
        <source>as the points&apos; column &apos;defines&apos; says</source>
        <translation>como diz a coluna &apos;define&apos; dos pontos</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nenhum</translation>
    </message>
    <message>
        <source>Systematic error of indication</source>
        <translation>Erro sistemático de indicação</translation>
    </message>
    <message>
        <source>What becomes of the mean error b. The paper leaves it uncorrected and counts |b| as a standard uncertainty; JCGM 100 3.2.4 asks for a correction.</source>
        <translation>O que se faz do erro médio b. O artigo o deixa sem correção e conta |b| como uma incerteza-padrão; o JCGM 100 3.2.4 pede uma correção.</translation>
    </message>
    <message>
        <source>counts as a standard uncertainty (paper)</source>
        <translation>conta como incerteza-padrão (artigo)</translation>
    </message>
    <message>
        <source>ignored</source>
        <translation>ignorado</translation>
    </message>
    <message>
        <source>corrected, the uncertainty of the correction remains</source>
        <translation>corrigido, resta a incerteza da correção</translation>
    </message>
    <message>
        <source>Systematic parts are common to all points</source>
        <translation>Partes sistemáticas comuns a todos os pontos</translation>
    </message>
    <message>
        <source>Calibration, temperature and bias are drawn once for all points instead of independently for each, as the paper does.</source>
        <translation>Calibração, temperatura e tendência são sorteadas uma vez para todos os pontos, em vez de independentemente para cada um, como faz o artigo.</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Calibração</translation>
    </message>
    <message>
        <source>Standard uncertainty of calibration</source>
        <translation>Incerteza-padrão da calibração</translation>
    </message>
    <message>
        <source>Largest standard uncertainty of the calibrated values, from the certificate (U divided by its k).</source>
        <translation>Maior incerteza-padrão dos valores calibrados, do certificado (U dividida por seu k).</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatura</translation>
    </message>
    <message>
        <source>Coefficient of thermal expansion</source>
        <translation>Coeficiente de dilatação térmica</translation>
    </message>
    <message>
        <source>Linear expansion of the artefact&apos;s material; aluminium has about 23e-6 1/K.</source>
        <translation>Dilatação linear do material do artefato; o alumínio tem cerca de 23e-6 1/K.</translation>
    </message>
    <message>
        <source>Temperature of the artefact</source>
        <translation>Temperatura do artefato</translation>
    </message>
    <message>
        <source>Whether indications are corrected to 20 °C with a measured temperature. If not, the largest deviation from 20 °C is a component of uncertainty.</source>
        <translation>Se as indicações são corrigidas para 20 °C com uma temperatura medida. Se não, o maior desvio em relação a 20 °C é uma componente de incerteza.</translation>
    </message>
    <message>
        <source>not corrected</source>
        <translation>não corrigida</translation>
    </message>
    <message>
        <source>corrected to 20 °C</source>
        <translation>corrigida para 20 °C</translation>
    </message>
    <message>
        <source>Largest deviation from 20 °C, or U of the temperature</source>
        <translation>Maior desvio de 20 °C, ou U da temperatura</translation>
    </message>
    <message>
        <source>ΔT of Eqs 3 and 6: without correction the largest absolute deviation from 20 °C, with correction the expanded uncertainty of the measured temperature. Half-width of a rectangular distribution.</source>
        <translation>ΔT das Eqs. 3 e 6: sem correção o maior desvio absoluto em relação a 20 °C, com correção a incerteza expandida da temperatura medida. Semiamplitude de uma distribuição retangular.</translation>
    </message>
    <message>
        <source>Measured temperature</source>
        <translation>Temperatura medida</translation>
    </message>
    <message>
        <source>Temperature of the artefact during the measurement; indications are divided by 1 + α (T − 20 °C).</source>
        <translation>Temperatura do artefato durante a medição; as indicações são divididas por 1 + α (T − 20 °C).</translation>
    </message>
    <message>
        <source>Length for the thermal expansion</source>
        <translation>Comprimento para a dilatação térmica</translation>
    </message>
    <message>
        <source>L_max of Eq 3. The paper&apos;s figures result with the largest distance between two points; its text says the largest value of the coordinate, which gives 0 for a flat artefact&apos;s z.</source>
        <translation>L_max da Eq. 3. Os números do artigo resultam com a maior distância entre dois pontos; seu texto diz o maior valor da coordenada, o que dá 0 para o z de um artefato plano.</translation>
    </message>
    <message>
        <source>largest distance between two points</source>
        <translation>maior distância entre dois pontos</translation>
    </message>
    <message>
        <source>largest value of the coordinate (text of Eq 3)</source>
        <translation>maior valor da coordenada (texto da Eq. 3)</translation>
    </message>
    <message>
        <source>Length standard</source>
        <translation>Padrão de comprimento</translation>
    </message>
    <message>
        <source>Calibrated length</source>
        <translation>Comprimento calibrado</translation>
    </message>
    <message>
        <source>Distance between the two nests, from the certificate. It should be like the largest distance between the points of both frames.</source>
        <translation>Distância entre os dois ninhos, do certificado. Deve ser semelhante à maior distância entre os pontos de ambos os referenciais.</translation>
    </message>
    <message>
        <source>Repeated measurements of the artefact, or the components of uncertainty as a report prints them (Table 2 of the paper).</source>
        <translation>Medições repetidas do artefato, ou as componentes de incerteza como um relatório as imprime (Tabela 2 do artigo).</translation>
    </message>
    <message>
        <source>Measured lengths: one row for each position and run, typed or from a CSV file. The paper proposes at least 14 positions of three runs.</source>
        <translation>Comprimentos medidos: uma linha para cada posição e série, digitada ou de um arquivo CSV. O artigo propõe pelo menos 14 posições de três séries.</translation>
    </message>
    <message>
        <source>position</source>
        <translation>posição</translation>
    </message>
    <message>
        <source>Where the standard stood.</source>
        <translation>Onde estava o padrão.</translation>
    </message>
    <message>
        <source>Indicated length.</source>
        <translation>Comprimento indicado.</translation>
    </message>
    <message>
        <source>One row, as Table 2 of the paper prints it.</source>
        <translation>Uma linha, como a imprime a Tabela 2 do artigo.</translation>
    </message>
    <message>
        <source>Uncertainty of a coordinate</source>
        <translation>Incerteza de uma coordenada</translation>
    </message>
    <message>
        <source>A length is the difference of two points, so u of a length is √2 times u of a coordinate. The paper uses the length&apos;s figure unchanged, which is cautious.</source>
        <translation>Um comprimento é a diferença de dois pontos, portanto u de um comprimento é √2 vezes u de uma coordenada. O artigo usa o número do comprimento sem alteração, o que é cauteloso.</translation>
    </message>
    <message>
        <source>that of the length (paper)</source>
        <translation>a do comprimento (artigo)</translation>
    </message>
    <message>
        <source>that of the length divided by √2</source>
        <translation>a do comprimento dividida por √2</translation>
    </message>
    <message>
        <source>Tracker, total station, camera or distance meter</source>
        <translation>Laser tracker, estação total, câmera ou distanciômetro</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Estação</translation>
    </message>
    <message>
        <source>Where the instrument stands in the world frame: the point where its axes meet. x is the zero of the azimuth (the optical axis of a camera), z the vertical axis.</source>
        <translation>Onde está o instrumento no referencial do mundo: o ponto em que seus eixos se encontram. x é o zero do azimute (o eixo óptico de uma câmera), z o eixo vertical.</translation>
    </message>
    <message>
        <source>The angles are</source>
        <translation>Os ângulos são</translation>
    </message>
    <message>
        <source>How the three angles of the station turn its axes.</source>
        <translation>Como os três ângulos da estação giram seus eixos.</translation>
    </message>
    <message>
        <source>α, β, γ: R = Rz(γ) Ry(β) Rx(α)</source>
        <translation>α, β, γ: R = Rz(γ) Ry(β) Rx(α)</translation>
    </message>
    <message>
        <source>ω, φ, κ: R = Rx(ω) Ry(φ) Rz(κ), photogrammetric</source>
        <translation>ω, φ, κ: R = Rx(ω) Ry(φ) Rz(κ), fotogramétrico</translation>
    </message>
    <message>
        <source>What the instrument reads, and how it is drawn.</source>
        <translation>O que o instrumento lê, e como é desenhado.</translation>
    </message>
    <message>
        <source>total station: distance and two angles</source>
        <translation>estação total: distância e dois ângulos</translation>
    </message>
    <message>
        <source>laser tracker: distance and two angles</source>
        <translation>laser tracker: distância e dois ângulos</translation>
    </message>
    <message>
        <source>laser scanner: distance and two angles</source>
        <translation>scanner a laser: distância e dois ângulos</translation>
    </message>
    <message>
        <source>camera: two angles</source>
        <translation>câmera: dois ângulos</translation>
    </message>
    <message>
        <source>distance meter: distance only</source>
        <translation>distanciômetro: só distância</translation>
    </message>
    <message>
        <source>other: chosen readings</source>
        <translation>outro: leituras escolhidas</translation>
    </message>
    <message>
        <source>Reads the distance</source>
        <translation>Lê a distância</translation>
    </message>
    <message>
        <source>Whether the sensor reads a distance.</source>
        <translation>Se o sensor lê uma distância.</translation>
    </message>
    <message>
        <source>Reads the azimuth</source>
        <translation>Lê o azimute</translation>
    </message>
    <message>
        <source>Whether the sensor reads a horizontal angle.</source>
        <translation>Se o sensor lê um ângulo horizontal.</translation>
    </message>
    <message>
        <source>Reads the elevation</source>
        <translation>Lê a elevação</translation>
    </message>
    <message>
        <source>Whether the sensor reads a vertical angle.</source>
        <translation>Se o sensor lê um ângulo vertical.</translation>
    </message>
    <message>
        <source>Specification</source>
        <translation>Especificação</translation>
    </message>
    <message>
        <source>Distance: constant part a</source>
        <translation>Distância: parte constante a</translation>
    </message>
    <message>
        <source>Part of the distance&apos;s figure that does not depend on the distance.</source>
        <translation>Parte do número da distância que não depende da distância.</translation>
    </message>
    <message>
        <source>Distance: part b per length</source>
        <translation>Distância: parte b por comprimento</translation>
    </message>
    <message>
        <source>Part of the distance&apos;s figure in proportion to the distance.</source>
        <translation>Parte do número da distância em proporção à distância.</translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation>Azimute</translation>
    </message>
    <message>
        <source>Figure for the horizontal angle.</source>
        <translation>Número para o ângulo horizontal.</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Elevação</translation>
    </message>
    <message>
        <source>Figure for the vertical angle.</source>
        <translation>Número para o ângulo vertical.</translation>
    </message>
    <message>
        <source>Angles: constant part across</source>
        <translation>Ângulos: parte constante transversal</translation>
    </message>
    <message>
        <source>Part of both angles&apos; figures that is a length across the line of sight, as trackers state it (15 µm + 6 µm/m); an angle&apos;s figure is this over the distance plus its own.</source>
        <translation>Parte dos números de ambos os ângulos que é um comprimento transversal à linha de visada, como os laser trackers a declaram (15 µm + 6 µm/m); o número de um ângulo é esta parte dividida pela distância mais o seu próprio.</translation>
    </message>
    <message>
        <source>The figures are</source>
        <translation>Os números são</translation>
    </message>
    <message>
        <source>What the data sheet states: a standard uncertainty, an expanded one, or a limit that is not exceeded (maximum permissible error).</source>
        <translation>O que a folha de dados declara: uma incerteza-padrão, uma expandida, ou um limite que não é excedido (erro máximo admissível).</translation>
    </message>
    <message>
        <source>standard uncertainty (normal)</source>
        <translation>incerteza-padrão (normal)</translation>
    </message>
    <message>
        <source>expanded uncertainty, k = 2 (normal)</source>
        <translation>incerteza expandida, k = 2 (normal)</translation>
    </message>
    <message>
        <source>limit (MPE), rectangular: divided by √3</source>
        <translation>limite (MPE), retangular: dividido por √3</translation>
    </message>
    <message>
        <source>limit (MPE), triangular: divided by √6</source>
        <translation>limite (MPE), triangular: dividido por √6</translation>
    </message>
    <message>
        <source>limit (MPE), arc sine: divided by √2</source>
        <translation>limite (MPE), arco seno: dividido por √2</translation>
    </message>
    <message>
        <source>Range and field of view</source>
        <translation>Alcance e campo de visão</translation>
    </message>
    <message>
        <source>Shortest distance</source>
        <translation>Menor distância</translation>
    </message>
    <message>
        <source>Targets nearer than this are not measured.</source>
        <translation>Alvos mais próximos do que isto não são medidos.</translation>
    </message>
    <message>
        <source>Longest distance</source>
        <translation>Maior distância</translation>
    </message>
    <message>
        <source>Targets farther than this are not measured; empty: no limit.</source>
        <translation>Alvos mais distantes do que isto não são medidos; vazio: sem limite.</translation>
    </message>
    <message>
        <source>Horizontal field of view</source>
        <translation>Campo de visão horizontal</translation>
    </message>
    <message>
        <source>Full angle, half of it to either side of the sensor&apos;s x-axis; empty: all round.</source>
        <translation>Ângulo total, metade para cada lado do eixo x do sensor; vazio: toda a volta.</translation>
    </message>
    <message>
        <source>Vertical field of view</source>
        <translation>Campo de visão vertical</translation>
    </message>
    <message>
        <source>Full angle, half of it above the sensor&apos;s xy-plane and half below; empty: no limit.</source>
        <translation>Ângulo total, metade acima do plano xy do sensor e metade abaixo; vazio: sem limite.</translation>
    </message>
    <message>
        <source>Shared by all readings</source>
        <translation>Comum a todas as leituras</translation>
    </message>
    <message>
        <source>Scale of distances</source>
        <translation>Escala das distâncias</translation>
    </message>
    <message>
        <source>Standard uncertainty of the scale, which all distances share: wavelength, refractive index, temperature of a scale.</source>
        <translation>Incerteza-padrão da escala, que todas as distâncias compartilham: comprimento de onda, índice de refração, temperatura de uma escala.</translation>
    </message>
    <message>
        <source>Zero offset of distances</source>
        <translation>Desvio de zero das distâncias</translation>
    </message>
    <message>
        <source>Standard uncertainty of the constant offset of all distances: home position, reflector.</source>
        <translation>Incerteza-padrão do desvio constante de todas as distâncias: posição de origem, refletor.</translation>
    </message>
    <message>
        <source>Index of the elevation</source>
        <translation>Índice da elevação</translation>
    </message>
    <message>
        <source>Standard uncertainty of the zero of the vertical circle.</source>
        <translation>Incerteza-padrão do zero do círculo vertical.</translation>
    </message>
    <message>
        <source>Collimation</source>
        <translation>Colimação</translation>
    </message>
    <message>
        <source>Standard uncertainty of the angle between beam and tilting axis off square: the azimuth changes by it over the cosine of the elevation.</source>
        <translation>Incerteza-padrão do desvio de perpendicularidade entre o feixe e o eixo de basculamento: o azimute varia por este valor dividido pelo cosseno da elevação.</translation>
    </message>
    <message>
        <source>Squareness of the axes</source>
        <translation>Perpendicularidade dos eixos</translation>
    </message>
    <message>
        <source>Standard uncertainty of the angle between the two axes off square: the azimuth changes by it times the tangent of the elevation.</source>
        <translation>Incerteza-padrão do desvio de perpendicularidade entre os dois eixos: o azimute varia por este valor vezes a tangente da elevação.</translation>
    </message>
    <message>
        <source>Offset of the beam</source>
        <translation>Deslocamento do feixe</translation>
    </message>
    <message>
        <source>Standard uncertainty of the distance by which the beam misses the vertical axis sideways: the azimuth changes by it over the horizontal distance.</source>
        <translation>Incerteza-padrão da distância com que o feixe passa ao lado do eixo vertical: o azimute varia por este valor dividido pela distância horizontal.</translation>
    </message>
    <message>
        <source>Coefficient of refraction</source>
        <translation>Coeficiente de refração</translation>
    </message>
    <message>
        <source>Standard uncertainty of k: the elevation changes by k L/(2 × 6371 km) over a distance L.</source>
        <translation>Incerteza-padrão de k: a elevação varia k L/(2 × 6371 km) em uma distância L.</translation>
    </message>
    <message>
        <source>The distribution of what all readings share; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation>A distribuição do que todas as leituras compartilham; o que se declara é a incerteza-padrão, qualquer que seja a forma.</translation>
    </message>
    <message>
        <source>Uncertainty of the station</source>
        <translation>Incerteza da estação</translation>
    </message>
    <message>
        <source>position x</source>
        <translation>posição x</translation>
    </message>
    <message>
        <source>Standard uncertainty of this coordinate of the station, shared by everything measured from it.</source>
        <translation>Incerteza-padrão desta coordenada da estação, compartilhada por tudo o que se mede a partir dela.</translation>
    </message>
    <message>
        <source>position y</source>
        <translation>posição y</translation>
    </message>
    <message>
        <source>position z</source>
        <translation>posição z</translation>
    </message>
    <message>
        <source>rotation about x</source>
        <translation>rotação em torno de x</translation>
    </message>
    <message>
        <source>rotation about y</source>
        <translation>rotação em torno de y</translation>
    </message>
    <message>
        <source>rotation about z</source>
        <translation>rotação em torno de z</translation>
    </message>
    <message>
        <source>The distribution of the coordinates of the station; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation>A distribuição das coordenadas da estação; o que se declara é a incerteza-padrão, qualquer que seja a forma.</translation>
    </message>
    <message>
        <source>Correlation of the station&apos;s coordinates</source>
        <translation>Correlação das coordenadas da estação</translation>
    </message>
    <message>
        <source>Correlation coefficients from the adjustment that located the station; pairs left out are uncorrelated.</source>
        <translation>Coeficientes de correlação do ajustamento que localizou a estação; pares omitidos não são correlacionados.</translation>
    </message>
    <message>
        <source>first</source>
        <translation>primeira</translation>
    </message>
    <message>
        <source>A coordinate of the station.</source>
        <translation>Uma coordenada da estação.</translation>
    </message>
    <message>
        <source>second</source>
        <translation>segunda</translation>
    </message>
    <message>
        <source>Correlation coefficient.</source>
        <translation>Coeficiente de correlação.</translation>
    </message>
    <message>
        <source>Network of sensors</source>
        <translation>Rede de sensores</translation>
    </message>
    <message>
        <source>What the weights of the readings account for. With the stations, all points of one analysis are estimated together.</source>
        <translation>O que os pesos das leituras levam em conta. Com as estações, todos os pontos de uma análise são estimados juntos.</translation>
    </message>
    <message>
        <source>readings and stations, all points at once</source>
        <translation>leituras e estações, todos os pontos de uma vez</translation>
    </message>
    <message>
        <source>readings alone, each point by itself</source>
        <translation>só leituras, cada ponto por si</translation>
    </message>
    <message>
        <source>Specification of a measured point</source>
        <translation>Especificação de um ponto medido</translation>
    </message>
    <message>
        <source>Figure of the data sheet</source>
        <translation>Número da folha de dados</translation>
    </message>
    <message>
        <source>The uncertainty or limit that the manufacturer states, the same for x, y and z.</source>
        <translation>A incerteza ou o limite que o fabricante declara, igual para x, y e z.</translation>
    </message>
    <message>
        <source>The figure applies to</source>
        <translation>O número se aplica a</translation>
    </message>
    <message>
        <source>A coordinate of a point, or a length between two points; a length is the difference of two points, so a coordinate has 1/√2 of it.</source>
        <translation>Uma coordenada de um ponto, ou um comprimento entre dois pontos; um comprimento é a diferença de dois pontos, portanto a uma coordenada cabe 1/√2 dele.</translation>
    </message>
    <message>
        <source>a coordinate</source>
        <translation>uma coordenada</translation>
    </message>
    <message>
        <source>a length between two points</source>
        <translation>um comprimento entre dois pontos</translation>
    </message>
    <message>
        <source>Telescopic ballbars (multilateration)</source>
        <translation>Ballbars telescópicos (multilateração)</translation>
    </message>
    <message>
        <source>Supports</source>
        <translation>Suportes</translation>
    </message>
    <message>
        <source>Support 1 to support 2</source>
        <translation>Suporte 1 ao suporte 2</translation>
    </message>
    <message>
        <source>Measured length between supports 1 and 2.</source>
        <translation>Comprimento medido entre os suportes 1 e 2.</translation>
    </message>
    <message>
        <source>Support 1 to support 3</source>
        <translation>Suporte 1 ao suporte 3</translation>
    </message>
    <message>
        <source>Measured length between supports 1 and 3.</source>
        <translation>Comprimento medido entre os suportes 1 e 3.</translation>
    </message>
    <message>
        <source>Support 2 to support 3</source>
        <translation>Suporte 2 ao suporte 3</translation>
    </message>
    <message>
        <source>Measured length between supports 2 and 3.</source>
        <translation>Comprimento medido entre os suportes 2 e 3.</translation>
    </message>
    <message>
        <source>Further supports</source>
        <translation>Outros suportes</translation>
    </message>
    <message>
        <source>Supports 4, 5 ...: their lengths to the first three, and their height above the plane of these. More than three lengths are adjusted by least squares.</source>
        <translation>Suportes 4, 5 ...: seus comprimentos até os três primeiros, e sua altura acima do plano destes. Mais de três comprimentos são ajustados por mínimos quadrados.</translation>
    </message>
    <message>
        <source>Length to this support.</source>
        <translation>Comprimento até este suporte.</translation>
    </message>
    <message>
        <source>Height above the first three supports.</source>
        <translation>Altura acima dos três primeiros suportes.</translation>
    </message>
    <message>
        <source>Standard uncertainty of the height.</source>
        <translation>Incerteza-padrão da altura.</translation>
    </message>
    <message>
        <source>The ball is</source>
        <translation>A esfera-alvo está</translation>
    </message>
    <message>
        <source>Three lengths meet in two points, mirror images in the plane of the supports: on which side of it the ball is (sign of the root of Eq 3).</source>
        <translation>Três comprimentos se encontram em dois pontos, simétricos em relação ao plano dos suportes: de que lado dele está a esfera-alvo (sinal da raiz da Eq. 3).</translation>
    </message>
    <message>
        <source>on the side of +z</source>
        <translation>do lado de +z</translation>
    </message>
    <message>
        <source>on the side of −z</source>
        <translation>do lado de −z</translation>
    </message>
    <message>
        <source>Placement</source>
        <translation>Colocação</translation>
    </message>
    <message>
        <source>Place in the robot&apos;s frame</source>
        <translation>Lugar no referencial do robô</translation>
    </message>
    <message>
        <source>Where the instrument&apos;s frame is in the robot&apos;s: origin in support 1, x towards support 2, z normal to the plane of the first three supports, on the left of the way 1-2-3.</source>
        <translation>Onde está o referencial do instrumento no do robô: origem no suporte 1, x em direção ao suporte 2, z normal ao plano dos três primeiros suportes, à esquerda do percurso 1-2-3.</translation>
    </message>
    <message>
        <source>Uncertainty of a length</source>
        <translation>Incerteza de um comprimento</translation>
    </message>
    <message>
        <source>To the ball: constant part a</source>
        <translation>À esfera-alvo: parte constante a</translation>
    </message>
    <message>
        <source>Figure for one reading of a bar to the ball, the part that does not depend on the length.</source>
        <translation>Número para uma leitura de um ballbar até a esfera-alvo, a parte que não depende do comprimento.</translation>
    </message>
    <message>
        <source>To the ball: part b per length</source>
        <translation>À esfera-alvo: parte b por comprimento</translation>
    </message>
    <message>
        <source>Figure for one reading of a bar to the ball, the part in proportion to the length.</source>
        <translation>Número para uma leitura de um ballbar até a esfera-alvo, a parte em proporção ao comprimento.</translation>
    </message>
    <message>
        <source>Between supports: constant part a</source>
        <translation>Entre suportes: parte constante a</translation>
    </message>
    <message>
        <source>Figure for a length between two supports, which one measurement gives for all points: the part that does not depend on the length.</source>
        <translation>Número para um comprimento entre dois suportes, que uma só medição dá para todos os pontos: a parte que não depende do comprimento.</translation>
    </message>
    <message>
        <source>Between supports: part b per length</source>
        <translation>Entre suportes: parte b por comprimento</translation>
    </message>
    <message>
        <source>Figure for a length between two supports, the part in proportion to the length.</source>
        <translation>Número para um comprimento entre dois suportes, a parte em proporção ao comprimento.</translation>
    </message>
    <message>
        <source>Shared by all lengths</source>
        <translation>Comum a todos os comprimentos</translation>
    </message>
    <message>
        <source>Scale of all lengths</source>
        <translation>Escala de todos os comprimentos</translation>
    </message>
    <message>
        <source>Standard uncertainty of the scale that all lengths share: wavelength, refractive index.</source>
        <translation>Incerteza-padrão da escala que todos os comprimentos compartilham: comprimento de onda, índice de refração.</translation>
    </message>
    <message>
        <source>Constant of each bar</source>
        <translation>Constante de cada ballbar</translation>
    </message>
    <message>
        <source>Standard uncertainty of the constant of a bar, the same in all its readings to the ball.</source>
        <translation>Incerteza-padrão da constante de um ballbar, a mesma em todas as suas leituras até a esfera-alvo.</translation>
    </message>
    <message>
        <source>The distribution of scale and constants; what is stated is its standard uncertainty, whatever the shape.</source>
        <translation>A distribuição da escala e das constantes; o que se declara é a incerteza-padrão, qualquer que seja a forma.</translation>
    </message>
    <message>
        <source>Robot: repeatability of a pose</source>
        <translation>Robô: repetibilidade de uma pose</translation>
    </message>
    <message>
        <source>Positioning</source>
        <translation>Posicionamento</translation>
    </message>
    <message>
        <source>The robot&apos;s figure for the scatter of a position that it is sent to again and again.</source>
        <translation>O número do robô para a dispersão de uma posição a que é enviado repetidas vezes.</translation>
    </message>
    <message>
        <source>The figure is</source>
        <translation>O número é</translation>
    </message>
    <message>
        <source>A largest distance from the mean position, or RP of ISO 9283: the mean distance plus three times its standard deviation. A normal law has no largest distance, so its figure is always RP.</source>
        <translation>Uma maior distância à posição média, ou RP da ISO 9283: a distância média mais três vezes seu desvio-padrão. Uma lei normal não tem maior distância, portanto seu número é sempre RP.</translation>
    </message>
    <message>
        <source>the largest distance r</source>
        <translation>a maior distância r</translation>
    </message>
    <message>
        <source>RP of ISO 9283: mean + 3 s</source>
        <translation>RP da ISO 9283: média + 3 s</translation>
    </message>
    <message>
        <source>Deviation of a position</source>
        <translation>Desvio de uma posição</translation>
    </message>
    <message>
        <source>How the distance from the mean position is distributed; all directions are equally probable.</source>
        <translation>Como se distribui a distância à posição média; todas as direções são igualmente prováveis.</translation>
    </message>
    <message>
        <source>rectangular in [0, r] in a random direction</source>
        <translation>retangular em [0, r] em direção aleatória</translation>
    </message>
    <message>
        <source>anywhere in a ball of radius r</source>
        <translation>em qualquer lugar de uma bola de raio r</translation>
    </message>
    <message>
        <source>always r, in a random direction</source>
        <translation>sempre r, em direção aleatória</translation>
    </message>
    <message>
        <source>normal along each axis</source>
        <translation>normal ao longo de cada eixo</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Orientação</translation>
    </message>
    <message>
        <source>Figure for the scatter of the orientation about each axis of the flange; 0: none.</source>
        <translation>Número para a dispersão da orientação em torno de cada eixo do flange; 0: nenhuma.</translation>
    </message>
    <message>
        <source>The angle is</source>
        <translation>O ângulo é</translation>
    </message>
    <message>
        <source>A standard uncertainty, RP of ISO 9283 for an angle (three times its standard deviation), or a limit that is not exceeded.</source>
        <translation>Uma incerteza-padrão, RP da ISO 9283 para um ângulo (três vezes seu desvio-padrão), ou um limite que não é excedido.</translation>
    </message>
    <message>
        <source>RP of ISO 9283: ± 3 s (normal)</source>
        <translation>RP da ISO 9283: ± 3 s (normal)</translation>
    </message>
    <message>
        <source>limit, rectangular: divided by √3</source>
        <translation>limite, retangular: dividido por √3</translation>
    </message>
    <message>
        <source>Serial robot</source>
        <translation>Robô serial</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Geometria</translation>
    </message>
    <message>
        <source>Convention</source>
        <translation>Convenção</translation>
    </message>
    <message>
        <source>How the parameters of a row lead from one joint&apos;s frame to the next.</source>
        <translation>Como os parâmetros de uma linha levam do referencial de uma junta ao da seguinte.</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Juntas</translation>
    </message>
    <message>
        <source>One row for each joint from the base to the tool, in the chosen convention.</source>
        <translation>Uma linha para cada junta, da base à ferramenta, na convenção escolhida.</translation>
    </message>
    <message>
        <source>Joint angle where the reading is the zero reading.</source>
        <translation>Ângulo da junta onde a leitura é a leitura de zero.</translation>
    </message>
    <message>
        <source>Offset along the joint&apos;s axis.</source>
        <translation>Deslocamento ao longo do eixo da junta.</translation>
    </message>
    <message>
        <source>Length of the common perpendicular.</source>
        <translation>Comprimento da perpendicular comum.</translation>
    </message>
    <message>
        <source>Twist about x between two axes.</source>
        <translation>Torção em torno de x entre dois eixos.</translation>
    </message>
    <message>
        <source>Twist about y, of a joint whose axis is parallel to the next: d is then 0 by definition. Empty: the axes are not parallel.</source>
        <translation>Torção em torno de y, de uma junta cujo eixo é paralelo ao seguinte: d é então 0 por definição. Vazio: os eixos não são paralelos.</translation>
    </message>
    <message>
        <source>Reading of the joint at which theta holds; empty: 0.</source>
        <translation>Leitura da junta em que theta vale; vazio: 0.</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>sentido</translation>
    </message>
    <message>
        <source>Whether the joint angle grows or falls with the reading; empty: grows.</source>
        <translation>Se o ângulo da junta cresce ou decresce com a leitura; vazio: cresce.</translation>
    </message>
    <message>
        <source>with the reading</source>
        <translation>com a leitura</translation>
    </message>
    <message>
        <source>against the reading</source>
        <translation>contra a leitura</translation>
    </message>
    <message>
        <source>Lowest reading; empty: no limit.</source>
        <translation>Menor leitura; vazio: sem limite.</translation>
    </message>
    <message>
        <source>Highest reading; empty: no limit.</source>
        <translation>Maior leitura; vazio: sem limite.</translation>
    </message>
    <message>
        <source>Standard uncertainty of a reading by the joint&apos;s encoder, drawn anew at each pose.</source>
        <translation>Incerteza-padrão de uma leitura pelo encoder da junta, sorteada de novo em cada pose.</translation>
    </message>
    <message>
        <source>Standard uncertainty by which the joint comes back to a reading, drawn anew at each pose.</source>
        <translation>Incerteza-padrão com que a junta retorna a uma leitura, sorteada de novo em cada pose.</translation>
    </message>
    <message>
        <source>type</source>
        <translation>tipo</translation>
    </message>
    <message>
        <source>A joint that turns has readings q, which add to theta; one that slides has readings s, which add to d. Empty: it turns.</source>
        <translation>Uma junta que gira tem leituras q, que se somam a theta; uma que desliza tem leituras s, que se somam a d. Vazio: gira.</translation>
    </message>
    <message>
        <source>turns about its axis</source>
        <translation>gira em torno de seu eixo</translation>
    </message>
    <message>
        <source>slides along its axis</source>
        <translation>desliza ao longo de seu eixo</translation>
    </message>
    <message>
        <source>Reading of a sliding joint at which d holds; empty: 0.</source>
        <translation>Leitura de uma junta deslizante em que d vale; vazio: 0.</translation>
    </message>
    <message>
        <source>Lowest reading of a sliding joint; empty: no limit.</source>
        <translation>Menor leitura de uma junta deslizante; vazio: sem limite.</translation>
    </message>
    <message>
        <source>Highest reading of a sliding joint; empty: no limit.</source>
        <translation>Maior leitura de uma junta deslizante; vazio: sem limite.</translation>
    </message>
    <message>
        <source>Standard uncertainty of a reading of a sliding joint by its scale, drawn anew at each pose.</source>
        <translation>Incerteza-padrão de uma leitura de uma junta deslizante por sua escala, sorteada de novo em cada pose.</translation>
    </message>
    <message>
        <source>Standard uncertainty by which a sliding joint comes back to a reading, drawn anew at each pose.</source>
        <translation>Incerteza-padrão com que uma junta deslizante retorna a uma leitura, sorteada de novo em cada pose.</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Where frame 0 of the robot stands in the world.</source>
        <translation>Onde está o referencial 0 do robô no mundo.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Ferramenta</translation>
    </message>
    <message>
        <source>Where the tool is in the frame of the last link.</source>
        <translation>Onde está a ferramenta no referencial do último elo.</translation>
    </message>
    <message>
        <source>Standard uncertainties of the parameters by source. A row for a joint and a source; components of one parameter combine in quadrature.</source>
        <translation>Incertezas-padrão dos parâmetros por fonte. Uma linha para uma junta e uma fonte; componentes de um parâmetro combinam-se em quadratura.</translation>
    </message>
    <message>
        <source>Where the figures come from: repeatability, sampling, range, certificate ...</source>
        <translation>De onde vêm os números: repetibilidade, amostragem, faixa, certificado ...</translation>
    </message>
    <message>
        <source>Number of the joint; empty: all joints, each with a deviation of its own.</source>
        <translation>Número da junta; vazio: todas as juntas, cada uma com um desvio próprio.</translation>
    </message>
    <message>
        <source>Standard uncertainty of theta from this source; empty: none.</source>
        <translation>Incerteza-padrão de theta desta fonte; vazio: nenhuma.</translation>
    </message>
    <message>
        <source>Standard uncertainty of d from this source; empty: none.</source>
        <translation>Incerteza-padrão de d desta fonte; vazio: nenhuma.</translation>
    </message>
    <message>
        <source>Standard uncertainty of a from this source; empty: none.</source>
        <translation>Incerteza-padrão de a desta fonte; vazio: nenhuma.</translation>
    </message>
    <message>
        <source>Standard uncertainty of alpha from this source; empty: none.</source>
        <translation>Incerteza-padrão de alpha desta fonte; vazio: nenhuma.</translation>
    </message>
    <message>
        <source>Standard uncertainty of beta from this source; empty: none.</source>
        <translation>Incerteza-padrão de beta desta fonte; vazio: nenhuma.</translation>
    </message>
    <message>
        <source>Degrees of freedom of the figures; empty: infinitely many.</source>
        <translation>Graus de liberdade dos números; vazio: infinitos.</translation>
    </message>
    <message>
        <source>Form of the distribution with this standard uncertainty; empty: normal.</source>
        <translation>Forma da distribuição com esta incerteza-padrão; vazio: normal.</translation>
    </message>
    <message>
        <source>Correlation coefficients from the identification; pairs left out are uncorrelated. A correlated parameter has one component.</source>
        <translation>Coeficientes de correlação da identificação; pares omitidos não são correlacionados. Um parâmetro correlacionado tem uma só componente.</translation>
    </message>
    <message>
        <source>Tool, position</source>
        <translation>Ferramenta, posição</translation>
    </message>
    <message>
        <source>Standard uncertainty of each coordinate of the tool in the frame of the last link.</source>
        <translation>Incerteza-padrão de cada coordenada da ferramenta no referencial do último elo.</translation>
    </message>
    <message>
        <source>Tool, orientation</source>
        <translation>Ferramenta, orientação</translation>
    </message>
    <message>
        <source>Standard uncertainty of each rotation of the tool about its own axes.</source>
        <translation>Incerteza-padrão de cada rotação da ferramenta em torno de seus próprios eixos.</translation>
    </message>
    <message>
        <source>Force/moment calibration machine</source>
        <translation>Máquina de calibração de força/momento</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Certificado</translation>
    </message>
    <message>
        <source>Uncertainty of its loads</source>
        <translation>Incerteza de suas cargas</translation>
    </message>
    <message>
        <source>One row for each axis that the machine loads: the relative expanded uncertainty of its certificate and the coverage factor.</source>
        <translation>Uma linha para cada eixo que a máquina carrega: a incerteza expandida relativa de seu certificado e o fator de abrangência.</translation>
    </message>
    <message>
        <source>Force or moment.</source>
        <translation>Força ou momento.</translation>
    </message>
    <message>
        <source>Relative expanded uncertainty of the load: a ratio, not %.</source>
        <translation>Incerteza expandida relativa da carga: uma razão, não %.</translation>
    </message>
    <message>
        <source>Coverage factor; empty: 2.</source>
        <translation>Fator de abrangência; vazio: 2.</translation>
    </message>
    <message>
        <source>Multi-axis force/moment sensor</source>
        <translation>Sensor de força/momento multieixo</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Canais</translation>
    </message>
    <message>
        <source>The forces and moments that the sensor measures, with their rated loads.</source>
        <translation>As forças e os momentos que o sensor mede, com suas cargas nominais.</translation>
    </message>
    <message>
        <source>Force or moment that the channel measures.</source>
        <translation>Força ou momento que o canal mede.</translation>
    </message>
    <message>
        <source>rated force</source>
        <translation>força nominal</translation>
    </message>
    <message>
        <source>Rated load of Fx, Fy or Fz.</source>
        <translation>Carga nominal de Fx, Fy ou Fz.</translation>
    </message>
    <message>
        <source>rated moment</source>
        <translation>momento nominal</translation>
    </message>
    <message>
        <source>Rated load of Mx, My or Mz.</source>
        <translation>Carga nominal de Mx, My ou Mz.</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>Where the sensor&apos;s axes are; loads are along and about them.</source>
        <translation>Onde estão os eixos do sensor; as cargas atuam ao longo e em torno deles.</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diâmetro</translation>
    </message>
    <message>
        <source>Of its housing, for the picture.</source>
        <translation>De seu corpo, para a imagem.</translation>
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
        <translation>Resolução do indicador</translation>
    </message>
    <message>
        <source>Smallest step of the indicated value, r of Eq 6.</source>
        <translation>Menor degrau do valor indicado, r da Eq. 6.</translation>
    </message>
    <message>
        <source>Range of the indicator</source>
        <translation>Faixa do indicador</translation>
    </message>
    <message>
        <source>Largest value that it can indicate; a reading there is refused as saturated. Empty: only readings that stand still while the load rises are.</source>
        <translation>Maior valor que ele pode indicar; uma leitura aí é recusada como saturada. Vazio: só o são leituras que ficam paradas enquanto a carga sobe.</translation>
    </message>
    <message>
        <source>Calibration machine</source>
        <translation>Máquina de calibração</translation>
    </message>
    <message>
        <source>What loaded the sensor; its relative uncertainty enters by Eq 5.</source>
        <translation>O que carregou o sensor; sua incerteza relativa entra pela Eq. 5.</translation>
    </message>
    <message>
        <source>Raw readings, from which everything follows, or what an evaluation states.</source>
        <translation>Leituras brutas, das quais tudo resulta, ou o que uma avaliação declara.</translation>
    </message>
    <message>
        <source>raw readings</source>
        <translation>leituras brutas</translation>
    </message>
    <message>
        <source>summary tables</source>
        <translation>tabelas-resumo</translation>
    </message>
    <message>
        <source>Indicated values of all channels at each step, the unloaded value not subtracted; typed or from a CSV file, whose columns may have other names.</source>
        <translation>Valores indicados de todos os canais em cada degrau, sem subtrair o valor sem carga; digitados ou de um arquivo CSV, cujas colunas podem ter outros nomes.</translation>
    </message>
    <message>
        <source>Axis on which the machine&apos;s load acts.</source>
        <translation>Eixo em que atua a carga da máquina.</translation>
    </message>
    <message>
        <source>Preloading or calibration.</source>
        <translation>Pré-carga ou calibração.</translation>
    </message>
    <message>
        <source>preload</source>
        <translation>pré-carga</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>calibração</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>fase</translation>
    </message>
    <message>
        <source>Unloaded before, preload, increasing or decreasing load, unloaded after.</source>
        <translation>Sem carga antes, pré-carga, carga crescente ou decrescente, sem carga depois.</translation>
    </message>
    <message>
        <source>zero before</source>
        <translation>zero antes</translation>
    </message>
    <message>
        <source>load</source>
        <translation>carga</translation>
    </message>
    <message>
        <source>increasing</source>
        <translation>crescente</translation>
    </message>
    <message>
        <source>decreasing</source>
        <translation>decrescente</translation>
    </message>
    <message>
        <source>zero after</source>
        <translation>zero depois</translation>
    </message>
    <message>
        <source>step</source>
        <translation>degrau</translation>
    </message>
    <message>
        <source>Number of the step: 0 without load, the same number for increasing and decreasing load.</source>
        <translation>Número do degrau: 0 sem carga, o mesmo número para carga crescente e decrescente.</translation>
    </message>
    <message>
        <source>Load in the unit of the next column.</source>
        <translation>Carga na unidade da coluna seguinte.</translation>
    </message>
    <message>
        <source>load unit</source>
        <translation>unidade da carga</translation>
    </message>
    <message>
        <source>N, kN, Nm ...; empty: N for forces and N·m for moments.</source>
        <translation>N, kN, Nm ...; vazio: N para forças e N·m para momentos.</translation>
    </message>
    <message>
        <source>Time of the reading.</source>
        <translation>Hora da leitura.</translation>
    </message>
    <message>
        <source>Indicated value of this channel.</source>
        <translation>Valor indicado deste canal.</translation>
    </message>
    <message>
        <source>Summary</source>
        <translation>Resumo</translation>
    </message>
    <message>
        <source>What an evaluation states of each channel, like Tables 1 and 3 of the paper.</source>
        <translation>O que uma avaliação declara de cada canal, como as Tabelas 1 e 3 do artigo.</translation>
    </message>
    <message>
        <source>Channel.</source>
        <translation>Canal.</translation>
    </message>
    <message>
        <source>rated output</source>
        <translation>saída nominal</translation>
    </message>
    <message>
        <source>Mean net reading at the rated load.</source>
        <translation>Leitura líquida média na carga nominal.</translation>
    </message>
    <message>
        <source>non-zero error</source>
        <translation>erro de retorno a zero</translation>
    </message>
    <message>
        <source>Non-zero error: change of the unloaded reading over a series.</source>
        <translation>Erro de retorno a zero: variação da leitura sem carga durante uma série.</translation>
    </message>
    <message>
        <source>Type A standard uncertainty of the mean, the largest of all steps.</source>
        <translation>Incerteza-padrão Tipo A da média, a maior de todos os degraus.</translation>
    </message>
    <message>
        <source>hysteresis</source>
        <translation>histerese</translation>
    </message>
    <message>
        <source>Largest difference between increasing and decreasing load.</source>
        <translation>Maior diferença entre carga crescente e decrescente.</translation>
    </message>
    <message>
        <source>Type B standard uncertainty as stated; empty: from the machine, the resolution and the non-zero error (Eq 8).</source>
        <translation>Incerteza-padrão Tipo B como declarada; vazio: da máquina, da resolução e do erro de retorno a zero (Eq. 8).</translation>
    </message>
    <message>
        <source>Interference</source>
        <translation>Interferência</translation>
    </message>
    <message>
        <source>Outputs at rated loads on other axes, like Table 2 of the paper; which index is the load is chosen below.</source>
        <translation>Saídas com cargas nominais em outros eixos, como a Tabela 2 do artigo; qual índice é a carga escolhe-se abaixo.</translation>
    </message>
    <message>
        <source>Row of the table.</source>
        <translation>Linha da tabela.</translation>
    </message>
    <message>
        <source>Column of the table; empty on the diagonal.</source>
        <translation>Coluna da tabela; vazio na diagonal.</translation>
    </message>
    <message>
        <source>Interference has signs</source>
        <translation>A interferência tem sinais</translation>
    </message>
    <message>
        <source>Whether the signs are printed. Without them interference cannot be compensated.</source>
        <translation>Se os sinais estão impressos. Sem eles a interferência não pode ser compensada.</translation>
    </message>
    <message>
        <source>Calibration plan</source>
        <translation>Plano de calibração</translation>
    </message>
    <message>
        <source>Preloads</source>
        <translation>Pré-cargas</translation>
    </message>
    <message>
        <source>How often each axis is loaded to its rated load before.</source>
        <translation>Quantas vezes cada eixo é carregado antes até sua carga nominal.</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Séries</translation>
    </message>
    <message>
        <source>Calibration series of each axis: n of Eqs 2 to 4.</source>
        <translation>Séries de calibração de cada eixo: n das Eqs. 2 a 4.</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Degraus</translation>
    </message>
    <message>
        <source>Loads of a series up to the rated load; the paper asks for five or more.</source>
        <translation>Cargas de uma série até a carga nominal; o artigo pede cinco ou mais.</translation>
    </message>
    <message>
        <source>Decreasing loads too</source>
        <translation>Também cargas decrescentes</translation>
    </message>
    <message>
        <source>Whether each series goes down again; hysteresis needs it.</source>
        <translation>Se cada série também desce; a histerese o exige.</translation>
    </message>
    <message>
        <source>Without load before a series</source>
        <translation>Sem carga antes de uma série</translation>
    </message>
    <message>
        <source>Before each series, Fig. 2.</source>
        <translation>Antes de cada série, Fig. 2.</translation>
    </message>
    <message>
        <source>At each load</source>
        <translation>Em cada carga</translation>
    </message>
    <message>
        <source>Before a reading is taken, Fig. 2.</source>
        <translation>Antes de se fazer uma leitura, Fig. 2.</translation>
    </message>
    <message>
        <source>Evaluation by the paper</source>
        <translation>Avaliação segundo o artigo</translation>
    </message>
    <message>
        <source>Coverage factor k of Eq 12</source>
        <translation>Fator de abrangência k da Eq. 12</translation>
    </message>
    <message>
        <source>The paper takes 2.</source>
        <translation>O artigo toma 2.</translation>
    </message>
    <message>
        <source>A row of the interference table is</source>
        <translation>Uma linha da tabela de interferência é</translation>
    </message>
    <message>
        <source>Section 2.5 says e_12 is the output of Fy under Fx (row = load), but divides by the rated output of the row and calls the row&apos;s largest the error of that sensor. Raw readings leave no doubt; for a printed table the choice changes U.</source>
        <translation>A Seção 2.5 diz que e_12 é a saída de Fy sob Fx (linha = carga), mas divide pela saída nominal da linha e chama o maior da linha de erro desse sensor. Leituras brutas não deixam dúvida; para uma tabela impressa a escolha altera U.</translation>
    </message>
    <message>
        <source>a sensor: its outputs under the other loads</source>
        <translation>um sensor: suas saídas sob as outras cargas</translation>
    </message>
    <message>
        <source>a load: the outputs of the other sensors under it</source>
        <translation>uma carga: as saídas dos outros sensores sob ela</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Comparação</translation>
    </message>
    <message>
        <source>Stated values</source>
        <translation>Valores declarados</translation>
    </message>
    <message>
        <source>Values that a certificate or a paper prints, to be compared with those computed.</source>
        <translation>Valores que um certificado ou um artigo imprime, a comparar com os calculados.</translation>
    </message>
    <message>
        <source>As printed, in mV/V; empty: not compared.</source>
        <translation>Como impresso, em mV/V; vazio: não comparado.</translation>
    </message>
    <message>
        <source>interference</source>
        <translation>interferência</translation>
    </message>
    <message>
        <source>U, relative</source>
        <translation>U, relativa</translation>
    </message>
    <message>
        <source>Relative expanded uncertainty of Eq 12b.</source>
        <translation>Incerteza expandida relativa da Eq. 12b.</translation>
    </message>
    <message>
        <source>U, as a load</source>
        <translation>U, como carga</translation>
    </message>
    <message>
        <source>Expanded uncertainty of Eq 12c in N or N·m, a number without unit.</source>
        <translation>Incerteza expandida da Eq. 12c em N ou N·m, um número sem unidade.</translation>
    </message>
    <message>
        <source>Stated interference in %</source>
        <translation>Interferência declarada em %</translation>
    </message>
    <message>
        <source>Table 4 of the paper: interference by the rated output of the row.</source>
        <translation>Tabela 4 do artigo: interferência pela saída nominal da linha.</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>maior</translation>
    </message>
    <message>
        <source>Largest of the row.</source>
        <translation>O maior da linha.</translation>
    </message>
    <message>
        <source>Typed measurement equation</source>
        <translation>Equação de medição digitada</translation>
    </message>
    <message>
        <source>The uncertainty of a quantity computed from others by an equation.</source>
        <translation>A incerteza de uma grandeza calculada a partir de outras por uma equação.</translation>
    </message>
    <message>
        <source>Gauge block by comparison</source>
        <translation>Bloco-padrão por comparação</translation>
    </message>
    <message>
        <source>The length of a gauge block compared with a standard of the same length.</source>
        <translation>O comprimento de um bloco-padrão comparado com um padrão do mesmo comprimento.</translation>
    </message>
    <message>
        <source>Two quantities from the same readings</source>
        <translation>Duas grandezas das mesmas leituras</translation>
    </message>
    <message>
        <source>Resistance and reactance from simultaneous readings, with their correlation.</source>
        <translation>Resistência e reatância de leituras simultâneas, com sua correlação.</translation>
    </message>
    <message>
        <source>Calibration line of a thermometer</source>
        <translation>Reta de calibração de um termômetro</translation>
    </message>
    <message>
        <source>The correction at any reading, from a line through calibration points.</source>
        <translation>A correção em qualquer leitura, por uma reta pelos pontos de calibração.</translation>
    </message>
    <message>
        <source>Observations on several days</source>
        <translation>Observações em vários dias</translation>
    </message>
    <message>
        <source>The mean of readings in groups, and whether the groups differ.</source>
        <translation>A média de leituras em grupos, e se os grupos diferem.</translation>
    </message>
    <message>
        <source>Pose of a platform from a tracker</source>
        <translation>Pose de uma plataforma por laser tracker</translation>
    </message>
    <message>
        <source>Where a robot&apos;s flange or platform is, from nests measured by a laser tracker.</source>
        <translation>Onde está o flange ou a plataforma de um robô, por ninhos medidos com um laser tracker.</translation>
    </message>
    <message>
        <source>Pose from two instruments together</source>
        <translation>Pose por dois instrumentos juntos</translation>
    </message>
    <message>
        <source>The same pose measured by a tracker and a total station as one network.</source>
        <translation>A mesma pose medida por um laser tracker e uma estação total como uma só rede.</translation>
    </message>
    <message>
        <source>Pose from calibrated artefacts</source>
        <translation>Pose a partir de artefatos calibrados</translation>
    </message>
    <message>
        <source>A pose whose point uncertainties come from measurements of artefacts.</source>
        <translation>Uma pose cujas incertezas dos pontos vêm de medições de artefatos.</translation>
    </message>
    <message>
        <source>Points by cameras and a tracker</source>
        <translation>Pontos por câmeras e um laser tracker</translation>
    </message>
    <message>
        <source>Coordinates of targets that several instruments measure together.</source>
        <translation>Coordenadas de alvos que vários instrumentos medem juntos.</translation>
    </message>
    <message>
        <source>Network with unknown stations</source>
        <translation>Rede com estações desconhecidas</translation>
    </message>
    <message>
        <source>Places of targets and of the instruments themselves, from readings to control points.</source>
        <translation>Posições de alvos e dos próprios instrumentos, a partir de leituras a pontos de controle.</translation>
    </message>
    <message>
        <source>Where do I put the station?</source>
        <translation>Onde coloco a estação?</translation>
    </message>
    <message>
        <source>The place of an instrument that makes the uncertainties smallest.</source>
        <translation>O lugar de um instrumento que torna as incertezas mínimas.</translation>
    </message>
    <message>
        <source>Tool by ballbars</source>
        <translation>Ferramenta por ballbars</translation>
    </message>
    <message>
        <source>A robot&apos;s tool centre point from rotations measured by telescopic ballbars.</source>
        <translation>O ponto central da ferramenta de um robô por rotações medidas com ballbars telescópicos.</translation>
    </message>
    <message>
        <source>Which points do I measure?</source>
        <translation>Que pontos meço?</translation>
    </message>
    <message>
        <source>The dozen of a plan of points that makes the uncertainty smallest.</source>
        <translation>A dúzia de um plano de pontos que torna a incerteza mínima.</translation>
    </message>
    <message>
        <source>Tool position of a robot</source>
        <translation>Posição da ferramenta de um robô</translation>
    </message>
    <message>
        <source>Where the tool is, from joint readings and Denavit-Hartenberg parameters.</source>
        <translation>Onde está a ferramenta, por leituras das juntas e parâmetros de Denavit-Hartenberg.</translation>
    </message>
    <message>
        <source>Parameters of an arm from circles that its joints describe one by one.</source>
        <translation>Parâmetros de um braço por círculos que suas juntas descrevem uma a uma.</translation>
    </message>
    <message>
        <source>Parameters of an arm from measured places of its flange.</source>
        <translation>Parâmetros de um braço por lugares medidos de seu flange.</translation>
    </message>
    <message>
        <source>Calibration of a force/moment sensor</source>
        <translation>Calibração de um sensor de força/momento</translation>
    </message>
    <message>
        <source>Errors and uncertainty of the channels of a multi-axis sensor.</source>
        <translation>Erros e incerteza dos canais de um sensor multieixo.</translation>
    </message>
    <message>
        <source>Forces and moments from readings</source>
        <translation>Forças e momentos a partir de leituras</translation>
    </message>
    <message>
        <source>Loads from the readings of a multi-axis sensor by its calibration matrix.</source>
        <translation>Cargas a partir das leituras de um sensor multieixo por sua matriz de calibração.</translation>
    </message>
    <message>
        <source>Law of propagation alone (JCGM 100), with a fixed number of trials (JCGM 101), or with as many as the tolerance needs.</source>
        <translation>Só a lei de propagação (JCGM 100), com um número fixo de ensaios (JCGM 101), ou com tantos quantos a tolerância exige.</translation>
    </message>
    <message>
        <source>Law of propagation only</source>
        <translation>Só lei de propagação</translation>
    </message>
    <message>
        <source>Monte Carlo, fixed number of trials</source>
        <translation>Monte Carlo, número fixo de ensaios</translation>
    </message>
    <message>
        <source>Monte Carlo, adaptive</source>
        <translation>Monte Carlo, adaptativo</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Ensaios</translation>
    </message>
    <message>
        <source>Of the method monte-carlo.</source>
        <translation>Do método monte-carlo.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semente</translation>
    </message>
    <message>
        <source>0 to 18446744073709551615, as text.</source>
        <translation>0 a 18446744073709551615, como texto.</translation>
    </message>
    <message>
        <source>Variance reduction</source>
        <translation>Redução de variância</translation>
    </message>
    <message>
        <source>Makes each trial tell more; the gain is measured and stated with the result. Plain trials are those of JCGM 101.</source>
        <translation>Faz cada ensaio revelar mais; o ganho é medido e declarado com o resultado. Ensaios simples são os do JCGM 101.</translation>
    </message>
    <message>
        <source>None: plain trials</source>
        <translation>Nenhuma: ensaios simples</translation>
    </message>
    <message>
        <source>Control variate: the linear part</source>
        <translation>Variável de controle: a parte linear</translation>
    </message>
    <message>
        <source>Sobol points, scrambled</source>
        <translation>Pontos de Sobol, embaralhados</translation>
    </message>
    <message>
        <source>Coverage probability</source>
        <translation>Probabilidade de abrangência</translation>
    </message>
    <message>
        <source>Of the expanded uncertainty, of intervals and regions.</source>
        <translation>Da incerteza expandida, de intervalos e regiões.</translation>
    </message>
    <message>
        <source>Coverage factor</source>
        <translation>Fator de abrangência</translation>
    </message>
    <message>
        <source>A fixed k for U = k u; absent: U by the effective degrees of freedom (law of propagation), or half of the coverage interval (Monte Carlo).</source>
        <translation>Um k fixo para U = k u; ausente: U pelos graus de liberdade efetivos (lei de propagação), ou metade do intervalo de abrangência (Monte Carlo).</translation>
    </message>
    <message>
        <source>Second-order terms</source>
        <translation>Termos de segunda ordem</translation>
    </message>
    <message>
        <source>Terms of second order of the law of propagation (JCGM 100 5.1.2).</source>
        <translation>Termos de segunda ordem da lei de propagação (JCGM 100 5.1.2).</translation>
    </message>
    <message>
        <source>Trials one at a time</source>
        <translation>Ensaios de um por vez</translation>
    </message>
    <message>
        <source>Of Monte Carlo with all components but one kept constant, for each component; 0: none.</source>
        <translation>De Monte Carlo com todas as componentes menos uma mantidas constantes, para cada componente; 0: nenhum.</translation>
    </message>
    <message>
        <source>Trials by contributor</source>
        <translation>Ensaios por contribuição</translation>
    </message>
    <message>
        <source>Of Monte Carlo without each contributor, and of it alone; 0: none.</source>
        <translation>De Monte Carlo sem cada contribuição, e só com ela; 0: nenhum.</translation>
    </message>
    <message>
        <source>Trials for Sobol indices</source>
        <translation>Ensaios para índices de Sobol</translation>
    </message>
    <message>
        <source>Pairs of trials for Sobol indices; 0: none.</source>
        <translation>Pares de ensaios para índices de Sobol; 0: nenhum.</translation>
    </message>
    <message>
        <source>Significant digits</source>
        <translation>Algarismos significativos</translation>
    </message>
    <message>
        <source>Of u, for the numerical tolerance of adaptive runs and of the validation (JCGM 101 7.9.2, 8).</source>
        <translation>De u, para a tolerância numérica de execuções adaptativas e da validação (JCGM 101 7.9.2, 8).</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerância</translation>
    </message>
    <message>
        <source>A quantity applies to the outputs of its dimension; a number to every output in its SI unit.</source>
        <translation>Uma grandeza aplica-se às saídas de sua dimensão; um número a cada saída em sua unidade SI.</translation>
    </message>
    <message>
        <source>Least number of batches</source>
        <translation>Número mínimo de lotes</translation>
    </message>
    <message>
        <source>Of an adaptive run, before it may stop.</source>
        <translation>De uma execução adaptativa, antes que possa parar.</translation>
    </message>
    <message>
        <source>Most trials</source>
        <translation>Máximo de ensaios</translation>
    </message>
    <message>
        <source>At which an adaptive run stops in any case.</source>
        <translation>Em que uma execução adaptativa para de qualquer modo.</translation>
    </message>
    <message>
        <source>Certificate and laboratory</source>
        <translation>Certificado e laboratório</translation>
    </message>
    <message>
        <source>Certificate number</source>
        <translation>Número do certificado</translation>
    </message>
    <message>
        <source>Unique; it stands on every page.</source>
        <translation>Único; consta em cada página.</translation>
    </message>
    <message>
        <source>Laboratory</source>
        <translation>Laboratório</translation>
    </message>
    <message>
        <source>That issues the certificate.</source>
        <translation>Que emite o certificado.</translation>
    </message>
    <message>
        <source>Address of the laboratory</source>
        <translation>Endereço do laboratório</translation>
    </message>
    <message>
        <source>Street, town, country.</source>
        <translation>Rua, cidade, país.</translation>
    </message>
    <message>
        <source>Country of the laboratory</source>
        <translation>País do laboratório</translation>
    </message>
    <message>
        <source>Two capital letters (ISO 3166-1): DE. For a Digital Calibration Certificate.</source>
        <translation>Duas letras maiúsculas (ISO 3166-1): DE. Para um Certificado de Calibração Digital.</translation>
    </message>
    <message>
        <source>Accreditation number</source>
        <translation>Número de acreditação</translation>
    </message>
    <message>
        <source>Absent: not accredited for this.</source>
        <translation>Ausente: não acreditado para isto.</translation>
    </message>
    <message>
        <source>Place of calibration</source>
        <translation>Local da calibração</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>Cliente</translation>
    </message>
    <message>
        <source>For whom it was done.</source>
        <translation>Para quem foi feita.</translation>
    </message>
    <message>
        <source>Address of the customer</source>
        <translation>Endereço do cliente</translation>
    </message>
    <message>
        <source>Item</source>
        <translation>Item</translation>
    </message>
    <message>
        <source>What was calibrated.</source>
        <translation>O que foi calibrado.</translation>
    </message>
    <message>
        <source>Manufacturer</source>
        <translation>Fabricante</translation>
    </message>
    <message>
        <source>Of the item.</source>
        <translation>Do item.</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>The manufacturer&apos;s name for it: model, size, class.</source>
        <translation>O nome que o fabricante lhe dá: modelo, tamanho, classe.</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Número de série</translation>
    </message>
    <message>
        <source>By which the item is recognised, unless it has an identification.</source>
        <translation>Pelo qual o item é reconhecido, a menos que tenha uma identificação.</translation>
    </message>
    <message>
        <source>Identification</source>
        <translation>Identificação</translation>
    </message>
    <message>
        <source>The customer&apos;s mark, an inventory number.</source>
        <translation>A marca do cliente, um número de inventário.</translation>
    </message>
    <message>
        <source>Condition of the item</source>
        <translation>Estado do item</translation>
    </message>
    <message>
        <source>As it was received, where that matters.</source>
        <translation>Como foi recebido, onde isso importa.</translation>
    </message>
    <message>
        <source>Dates</source>
        <translation>Datas</translation>
    </message>
    <message>
        <source>ISO 8601: 2026-04-17.</source>
        <translation>ISO 8601: 2026-04-17.</translation>
    </message>
    <message>
        <source>A date, or two of an interval: 2026-04-17/2026-04-18.</source>
        <translation>Uma data, ou as duas de um intervalo: 2026-04-17/2026-04-18.</translation>
    </message>
    <message>
        <source>ISO 8601: 2026-04-20.</source>
        <translation>ISO 8601: 2026-04-20.</translation>
    </message>
    <message>
        <source>Procedure by which it was calibrated, with its edition.</source>
        <translation>Procedimento pelo qual foi calibrado, com sua edição.</translation>
    </message>
    <message>
        <source>Deviations from the method</source>
        <translation>Desvios em relação ao método</translation>
    </message>
    <message>
        <source>Additions, exclusions.</source>
        <translation>Adições, exclusões.</translation>
    </message>
    <message>
        <source>Environmental conditions</source>
        <translation>Condições ambientais</translation>
    </message>
    <message>
        <source>Those that influence the results.</source>
        <translation>As que influenciam os resultados.</translation>
    </message>
    <message>
        <source>Metrological traceability</source>
        <translation>Rastreabilidade metrológica</translation>
    </message>
    <message>
        <source>To which references, by which certificates the results are traceable.</source>
        <translation>A que referências, e por quais certificados, os resultados são rastreáveis.</translation>
    </message>
    <message>
        <source>Adjustment or repair</source>
        <translation>Ajuste ou reparo</translation>
    </message>
    <message>
        <source>Results before and after it.</source>
        <translation>Resultados antes e depois dele.</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Comentários</translation>
    </message>
    <message>
        <source>Opinions and interpretations are marked as such (7.8.7).</source>
        <translation>Opiniões e interpretações são marcadas como tais (7.8.7).</translation>
    </message>
    <message>
        <source>Authorisation</source>
        <translation>Autorização</translation>
    </message>
    <message>
        <source>Authorised by</source>
        <translation>Autorizado por</translation>
    </message>
    <message>
        <source>The person who authorises the certificate.</source>
        <translation>A pessoa que autoriza o certificado.</translation>
    </message>
    <message>
        <source>Function</source>
        <translation>Função</translation>
    </message>
    <message>
        <source>Of that person in the laboratory.</source>
        <translation>Dessa pessoa no laboratório.</translation>
    </message>
    <message>
        <source>Measurement model</source>
        <translation>Modelo de medição</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>Configuração</translation>
    </message>
    <message>
        <source>Input quantities</source>
        <translation>Grandezas de entrada</translation>
    </message>
    <message>
        <source>Artefacts and instruments</source>
        <translation>Artefatos e instrumentos</translation>
    </message>
    <message>
        <source>Uncertainty budgets</source>
        <translation>Balanços de incertezas</translation>
    </message>
    <message>
        <source>Sobol indices and contributors</source>
        <translation>Índices de Sobol e contribuições</translation>
    </message>
    <message>
        <source>Evaluation of the set-up</source>
        <translation>Avaliação da configuração</translation>
    </message>
    <message>
        <source>Law of propagation beside Monte Carlo</source>
        <translation>Lei de propagação ao lado de Monte Carlo</translation>
    </message>
    <message>
        <source>Joint coverage regions</source>
        <translation>Regiões de abrangência conjuntas</translation>
    </message>
    <message>
        <source>Distributions</source>
        <translation>Distribuições</translation>
    </message>
    <message>
        <source>Set-up in space</source>
        <translation>Configuração no espaço</translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation>Correlação</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Estudos</translation>
    </message>
    <message>
        <source>Designs</source>
        <translation>Planejamentos</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notas</translation>
    </message>
    <message>
        <source>Provenance</source>
        <translation>Proveniência</translation>
    </message>
    <message>
        <source>mean value</source>
        <translation>valor médio</translation>
    </message>
    <message>
        <source>standard deviation</source>
        <translation>desvio-padrão</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>escala</translation>
    </message>
    <message>
        <source>degrees of freedom</source>
        <translation>graus de liberdade</translation>
    </message>
    <message>
        <source>lower limit</source>
        <translation>limite inferior</translation>
    </message>
    <message>
        <source>upper limit</source>
        <translation>limite superior</translation>
    </message>
    <message>
        <source>curvilinear trapezoid</source>
        <translation>trapézio curvilíneo</translation>
    </message>
    <message>
        <source>inexactness of the limits</source>
        <translation>inexatidão dos limites</translation>
    </message>
    <message>
        <source>ratio of top to base</source>
        <translation>razão do topo à base</translation>
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
        <translation>valor médio do logaritmo do número em SI</translation>
    </message>
    <message>
        <source>standard deviation of the logarithm</source>
        <translation>desvio-padrão do logaritmo</translation>
    </message>
    <message>
        <source>parameter alpha</source>
        <translation>parâmetro alpha</translation>
    </message>
    <message>
        <source>parameter beta</source>
        <translation>parâmetro beta</translation>
    </message>
    <message>
        <source>discrete</source>
        <translation>discreta</translation>
    </message>
    <message>
        <source>SpatialAnalyzer points (ASCII)</source>
        <translation>Pontos do SpatialAnalyzer (ASCII)</translation>
    </message>
    <message>
        <source>Table of points</source>
        <translation>Tabela de pontos</translation>
    </message>
    <message>
        <source>Digital Calibration Certificate</source>
        <translation>Certificado de Calibração Digital</translation>
    </message>
    <message>
        <source>Leica GSI-8 and GSI-16</source>
        <translation>Leica GSI-8 e GSI-16</translation>
    </message>
    <message>
        <source>GNU Gama network</source>
        <translation>Rede do GNU Gama</translation>
    </message>
    <message>
        <source>Comp3D coordinates</source>
        <translation>Coordenadas do Comp3D</translation>
    </message>
    <message>
        <source>Comp3D observations</source>
        <translation>Observações do Comp3D</translation>
    </message>
    <message>
        <source>Uncertainty budget in Excel</source>
        <translation>Balanço de incertezas em Excel</translation>
    </message>
    <message>
        <source>GUM Workbench</source>
        <translation>GUM Workbench</translation>
    </message>
    <message>
        <source>Suncal project</source>
        <translation>Projeto do Suncal</translation>
    </message>
    <message>
        <source>OptiTrack Motive tracking data</source>
        <translation>Dados de rastreamento do OptiTrack Motive</translation>
    </message>
    <message>
        <source>Kinematic calibration of a UR robot (ROS)</source>
        <translation>Calibração cinemática de um robô UR (ROS)</translation>
    </message>
    <message>
        <source>Point list with Ux Uy Uz (SpatialAnalyzer ASCII)</source>
        <translation>Lista de pontos com Ux Uy Uz (SpatialAnalyzer ASCII)</translation>
    </message>
    <message>
        <source>Digital Calibration Certificate 3.2.1</source>
        <translation>Certificado de Calibração Digital 3.2.1</translation>
    </message>
    <message>
        <source>Excel workbook</source>
        <translation>Pasta de trabalho do Excel</translation>
    </message>
    <message>
        <source>Robot description (URDF)</source>
        <translation>Descrição de robô (URDF)</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grupo</translation>
    </message>
    <message>
        <source>The pose, point or target the quantity belongs to</source>
        <translation>A pose, o ponto ou o alvo a que pertence a grandeza</translation>
    </message>
    <message>
        <source>Output quantity</source>
        <translation>Grandeza de saída</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>Estimativa</translation>
    </message>
    <message>
        <source>Best value of the output quantity</source>
        <translation>Melhor valor da grandeza de saída</translation>
    </message>
    <message>
        <source>Standard uncertainty</source>
        <translation>Incerteza-padrão</translation>
    </message>
    <message>
        <source>Coverage factor. U = k u with k of the t distribution for the effective degrees of freedom.</source>
        <translation>Fator de abrangência. U = k u com k da distribuição t para os graus de liberdade efetivos.</translation>
    </message>
    <message>
        <source>Expanded uncertainty. U = k u with k of the t distribution for the effective degrees of freedom.</source>
        <translation>Incerteza expandida. U = k u com k da distribuição t para os graus de liberdade efetivos.</translation>
    </message>
    <message>
        <source>Limit of the shortest coverage interval</source>
        <translation>Limite do intervalo de abrangência mais curto</translation>
    </message>
    <message>
        <source>Estimate (first order)</source>
        <translation>Estimativa (1ª ordem)</translation>
    </message>
    <message>
        <source>By the law of propagation of uncertainty</source>
        <translation>Pela lei de propagação da incerteza</translation>
    </message>
    <message>
        <source>u (first order)</source>
        <translation>u (1ª ordem)</translation>
    </message>
    <message>
        <source>Effective degrees of freedom (JCGM 100 G.4)</source>
        <translation>Graus de liberdade efetivos (JCGM 100 G.4)</translation>
    </message>
    <message>
        <source>U (first order)</source>
        <translation>U (1ª ordem)</translation>
    </message>
    <message>
        <source>First order validated</source>
        <translation>1ª ordem validada</translation>
    </message>
    <message>
        <source>JCGM 101 clause 8: agrees with Monte Carlo within the tolerance</source>
        <translation>JCGM 101 seção 8: concorda com Monte Carlo dentro da tolerância</translation>
    </message>
    <message>
        <source>u (second order)</source>
        <translation>u (2ª ordem)</translation>
    </message>
    <message>
        <source>With the second-order terms of JCGM 100 5.1.2; for information</source>
        <translation>Com os termos de segunda ordem do JCGM 100 5.1.2; para informação</translation>
    </message>
    <message>
        <source>shift (second order)</source>
        <translation>desvio (2ª ordem)</translation>
    </message>
    <message>
        <source>What the curvature of the equation adds to the estimate; for information, not added</source>
        <translation>O que a curvatura da equação acrescenta à estimativa; para informação, não somado</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Alvo</translation>
    </message>
    <message>
        <source>Target uncertainty that is required</source>
        <translation>Incerteza-alvo exigida</translation>
    </message>
    <message>
        <source>U / target</source>
        <translation>U / alvo</translation>
    </message>
    <message>
        <source>Expanded uncertainty as a part of its target: above 1 the target is not met</source>
        <translation>Incerteza expandida como fração de seu alvo: acima de 1 o alvo não é atingido</translation>
    </message>
    <message>
        <source>Requirement</source>
        <translation>Requisito</translation>
    </message>
    <message>
        <source>Whether the target uncertainty is met and the value is accepted</source>
        <translation>Se a incerteza-alvo é atingida e o valor é aceito</translation>
    </message>
    <message>
        <source>Input quantity</source>
        <translation>Grandeza de entrada</translation>
    </message>
    <message>
        <source>Component of uncertainty</source>
        <translation>Componente de incerteza</translation>
    </message>
    <message>
        <source>Of the component&apos;s u</source>
        <translation>Do u da componente</translation>
    </message>
    <message>
        <source>Standard uncertainty of the component</source>
        <translation>Incerteza-padrão da componente</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Distribuição</translation>
    </message>
    <message>
        <source>Type A or Type B evaluation (JCGM 100 2.3.2, 2.3.3)</source>
        <translation>Avaliação Tipo A ou Tipo B (JCGM 100 2.3.2, 2.3.3)</translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation>Graus de liberdade</translation>
    </message>
    <message>
        <source>Sensitivity coefficient, unit of the output quantity per unit of the component</source>
        <translation>Coeficiente de sensibilidade, unidade da grandeza de saída por unidade da componente</translation>
    </message>
    <message>
        <source>|c|·u</source>
        <translation>|c|·u</translation>
    </message>
    <message>
        <source>Contribution to the standard uncertainty</source>
        <translation>Contribuição para a incerteza-padrão</translation>
    </message>
    <message>
        <source>Share / %</source>
        <translation>Parcela / %</translation>
    </message>
    <message>
        <source>Of the variance, with its part of the covariances</source>
        <translation>Da variância, com sua parte das covariâncias</translation>
    </message>
    <message>
        <source>u one at a time</source>
        <translation>u de um por vez</translation>
    </message>
    <message>
        <source>By Monte Carlo with every other component kept constant</source>
        <translation>Por Monte Carlo com todas as outras componentes mantidas constantes</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Origem</translation>
    </message>
    <message>
        <source>Where the figure comes from</source>
        <translation>De onde vem o número</translation>
    </message>
    <message>
        <source>In</source>
        <translation>Em</translation>
    </message>
    <message>
        <source>Whether both results have the quantity</source>
        <translation>Se ambos os resultados têm a grandeza</translation>
    </message>
    <message>
        <source>U before</source>
        <translation>U antes</translation>
    </message>
    <message>
        <source>Expanded uncertainty</source>
        <translation>Incerteza expandida</translation>
    </message>
    <message>
        <source>U after</source>
        <translation>U depois</translation>
    </message>
    <message>
        <source>Change of U in %</source>
        <translation>Variação de U em %</translation>
    </message>
    <message>
        <source>Change of the expanded uncertainty, in per cent of that before</source>
        <translation>Variação da incerteza expandida, em por cento da anterior</translation>
    </message>
    <message>
        <source>Estimate before</source>
        <translation>Estimativa antes</translation>
    </message>
    <message>
        <source>Estimate after</source>
        <translation>Estimativa depois</translation>
    </message>
    <message>
        <source>Change of estimate</source>
        <translation>Variação da estimativa</translation>
    </message>
    <message>
        <source>Estimate after less estimate before</source>
        <translation>Estimativa depois menos estimativa antes</translation>
    </message>
    <message>
        <source>u before</source>
        <translation>u antes</translation>
    </message>
    <message>
        <source>u after</source>
        <translation>u depois</translation>
    </message>
    <message>
        <source>k before</source>
        <translation>k antes</translation>
    </message>
    <message>
        <source>k after</source>
        <translation>k depois</translation>
    </message>
    <message>
        <source>Changed, the same, new, or gone</source>
        <translation>Alterado, igual, novo ou removido</translation>
    </message>
    <message>
        <source>|c|·u before</source>
        <translation>|c|·u antes</translation>
    </message>
    <message>
        <source>|c|·u after</source>
        <translation>|c|·u depois</translation>
    </message>
    <message>
        <source>Share before / %</source>
        <translation>Parcela antes / %</translation>
    </message>
    <message>
        <source>Of the variance before</source>
        <translation>Da variância antes</translation>
    </message>
    <message>
        <source>Share after / %</source>
        <translation>Parcela depois / %</translation>
    </message>
    <message>
        <source>Of the variance after</source>
        <translation>Da variância depois</translation>
    </message>
    <message>
        <source>Change of variance / %</source>
        <translation>Variação da variância / %</translation>
    </message>
    <message>
        <source>By how much this component changes the variance of the output, in per cent of the whole variance before; the rows add up to the change of the whole</source>
        <translation>Quanto esta componente altera a variância da saída, em por cento da variância total antes; as linhas somam a variação do total</translation>
    </message>
    <message>
        <source>met</source>
        <translation>atingido</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>não atingido</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sim</translation>
    </message>
    <message>
        <source>no</source>
        <translation>não</translation>
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
        <translation>Fator de abrangência. U = k u com o fator de abrangência que foi fixado.</translation>
    </message>
    <message>
        <source>Expanded uncertainty. U = k u with the coverage factor that was fixed.</source>
        <translation>Incerteza expandida. U = k u com o fator de abrangência que foi fixado.</translation>
    </message>
    <message>
        <source>Coverage factor. U is half the width of the probabilistically symmetric coverage interval, and k = U/u.</source>
        <translation>Fator de abrangência. U é metade da largura do intervalo de abrangência probabilisticamente simétrico, e k = U/u.</translation>
    </message>
    <message>
        <source>Expanded uncertainty. U is half the width of the probabilistically symmetric coverage interval, and k = U/u.</source>
        <translation>Incerteza expandida. U é metade da largura do intervalo de abrangência probabilisticamente simétrico, e k = U/u.</translation>
    </message>
    <message>
        <source>Target uncertainty</source>
        <translation>Incerteza-alvo</translation>
    </message>
    <message>
        <source>The expanded uncertainty U must not exceed this.</source>
        <translation>A incerteza expandida U não deve exceder este valor.</translation>
    </message>
    <message>
        <source>Lower limit</source>
        <translation>Limite inferior</translation>
    </message>
    <message>
        <source>Of the tolerance; empty: none.</source>
        <translation>Da tolerância; vazio: nenhum.</translation>
    </message>
    <message>
        <source>Upper limit</source>
        <translation>Limite superior</translation>
    </message>
    <message>
        <source>Guard factor</source>
        <translation>Fator de guarda</translation>
    </message>
    <message>
        <source>Guard bands of this times U inside the tolerance: 1 proves conformity (ISO 14253-1), 0 is simple acceptance, negative values favour the producer.</source>
        <translation>Bandas de guarda de tantas U dentro da tolerância: 1 comprova a conformidade (ISO 14253-1), 0 é aceitação simples, valores negativos favorecem o produtor.</translation>
    </message>
    <message>
        <source>Prior mean</source>
        <translation>Média a priori</translation>
    </message>
    <message>
        <source>What is known of such quantities before the measurement, as a normal distribution (the production process): for the global risks of JCGM 106.</source>
        <translation>O que se sabe de tais grandezas antes da medição, como distribuição normal (o processo de produção): para os riscos globais da JCGM 106.</translation>
    </message>
    <message>
        <source>Prior standard deviation</source>
        <translation>Desvio-padrão a priori</translation>
    </message>
    <message>
        <source>Of the production process.</source>
        <translation>Do processo de produção.</translation>
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
        <translation>Um arquivo PNG ou JPEG junto ao projeto, até 2 MB: no topo da primeira página.</translation>
    </message>
    <message>
        <source>Calibration certificate %1</source>
        <translation>Certificado de calibração %1</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Página %1 de %2</translation>
    </message>
    <message>
        <source>— not stated —</source>
        <translation>— não indicado —</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>in the laboratory</source>
        <translation>no laboratório</translation>
    </message>
    <message>
        <source>This certificate states %1 of %2 results. Not stated: %3.</source>
        <translation>Este certificado indica %1 de %2 resultados. Não indicados: %3.</translation>
    </message>
    <message>
        <source>1 further result is in the digital certificate that is attached to the PDF (certificate.xml).</source>
        <translation>Mais 1 resultado está no certificado digital anexado ao PDF (certificate.xml).</translation>
    </message>
    <message>
        <source>%1 further results are in the digital certificate that is attached to the PDF (certificate.xml).</source>
        <translation>Mais %1 resultados estão no certificado digital anexado ao PDF (certificate.xml).</translation>
    </message>
    <message>
        <source>Not evaluated: %1.</source>
        <translation>Não avaliado: %1.</translation>
    </message>
    <message>
        <source>Evaluated with Covaria %1, project fingerprint %2.</source>
        <translation>Avaliado com Covaria %1, impressão digital do projeto %2.</translation>
    </message>
    <message>
        <source>Evaluated with Covaria %1, project fingerprint %2, analyses: %3.</source>
        <translation>Avaliado com Covaria %1, impressão digital do projeto %2, análises: %3.</translation>
    </message>
    <message>
        <source>The results relate only to the item described above, in the state in which it was calibrated. This certificate may be reproduced in full only, unless the laboratory permits otherwise.</source>
        <translation>Os resultados referem-se apenas ao item descrito acima, no estado em que foi calibrado. Este certificado só pode ser reproduzido na íntegra, salvo autorização do laboratório.</translation>
    </message>
    <message>
        <source>Date of issue: %1</source>
        <translation>Data de emissão: %1</translation>
    </message>
    <message>
        <source>End of certificate</source>
        <translation>Fim do certificado</translation>
    </message>
    <message>
        <source>End of certificate %1</source>
        <translation>Fim do certificado %1</translation>
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
        <translation>Nenhum resultado é indicado: o que foi avaliado não representa o mensurando; %1 ensaios não têm valor.</translation>
    </message>
    <message>
        <source>Coverage intervals that are not symmetric about the estimate: %1.</source>
        <translation>Intervalos de cobertura que não são simétricos em torno da estimativa: %1.</translation>
    </message>
    <message>
        <source>Coverage intervals that are not symmetric about the estimate: %1; and %2 others.</source>
        <translation>Intervalos de cobertura que não são simétricos em torno da estimativa: %1; e outros %2.</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 em %2</translation>
    </message>
    <message>
        <source>%1 (exact)</source>
        <translation>%1 (exato)</translation>
    </message>
    <message>
        <source>%1 (U not finite)</source>
        <translation>%1 (U não finita)</translation>
    </message>
    <message>
        <source>without k, because u is not finite</source>
        <translation>sem k, porque u não é finita</translation>
    </message>
    <message>
        <source>coverage interval %1</source>
        <translation>intervalo de cobertura %1</translation>
    </message>
    <message>
        <source>The standard uncertainty was determined by the law of propagation of uncertainty in accordance with JCGM 100.</source>
        <translation>A incerteza-padrão foi determinada pela lei de propagação de incertezas de acordo com o JCGM 100.</translation>
    </message>
    <message>
        <source>The distribution was determined by the propagation of distributions in accordance with JCGM 101.</source>
        <translation>A distribuição foi determinada pela propagação de distribuições de acordo com o JCGM 101.</translation>
    </message>
    <message>
        <source>The expanded uncertainty U stated after ± is the standard uncertainty multiplied by the fixed coverage factor k; y ± U has the coverage probability p that is stated with it.</source>
        <translation>A incerteza expandida U indicada após ± é a incerteza-padrão multiplicada pelo fator de abrangência fixo k; y ± U tem a probabilidade de abrangência p indicada com ela.</translation>
    </message>
    <message>
        <source>The expanded uncertainty U stated after ± is half the width of the probabilistically symmetric coverage interval of the coverage probability p, and k = U/u.</source>
        <translation>A incerteza expandida U indicada após ± é metade da largura do intervalo de abrangência probabilisticamente simétrico de probabilidade de abrangência p, e k = U/u.</translation>
    </message>
    <message>
        <source>The expanded uncertainty U stated after ± is the standard uncertainty multiplied by the coverage factor k, which for a normal distribution, or for a t distribution of the effective degrees of freedom nu_eff where they are stated, corresponds to the coverage probability p.</source>
        <translation>A incerteza expandida U indicada após ± é a incerteza-padrão multiplicada pelo fator de abrangência k, que para uma distribuição normal, ou para uma distribuição t com os graus de liberdade efetivos nu_eff onde indicados, corresponde à probabilidade de abrangência p.</translation>
    </message>
    <message>
        <source>Statement of conformity</source>
        <translation>Declaração de conformidade</translation>
    </message>
    <message>
        <source>Acceptance</source>
        <translation>Aceitação</translation>
    </message>
    <message>
        <source>Decision rule</source>
        <translation>Regra de decisão</translation>
    </message>
    <message>
        <source>Decision</source>
        <translation>Decisão</translation>
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
        <translation>não avaliado</translation>
    </message>
    <message>
        <source>trials</source>
        <translation>ensaios</translation>
    </message>
    <message>
        <source>JCGM 106: probability that the measurand lies inside the tolerance, by the distribution of the result: its trials, or by the law of propagation Student&apos;s t for the effective degrees of freedom. The acceptance interval is the tolerance less guard bands w. Decision rules are named as in ILAC-G8:09/2019. TUR: half of the tolerance over U. C_m: T/(2U) for U = 2u, T/(4u).</source>
        <translation>JCGM 106: probabilidade de o mensurando estar dentro da tolerância, segundo a distribuição do resultado: seus ensaios ou, pela lei de propagação, a t de Student com os graus de liberdade efetivos. O intervalo de aceitação é a tolerância menos as bandas de guarda w. As regras de decisão são nomeadas como em ILAC-G8:09/2019. TUR: metade da tolerância dividida por U. C_m: T/(2U) para U = 2u, T/(4u).</translation>
    </message>
    <message>
        <source>simple acceptance (w = 0)</source>
        <translation>aceitação simples (w = 0)</translation>
    </message>
    <message>
        <source>guard band w = %1</source>
        <translation>banda de guarda w = %1</translation>
    </message>
    <message>
        <source>guarded rejection (w = −%1)</source>
        <translation>rejeição com guarda (w = −%1)</translation>
    </message>
    <message>
        <source>Results before and after</source>
        <translation>Resultados antes e depois</translation>
    </message>
    <message>
        <source>Context mesh</source>
        <translation>Malha de contexto</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Malha</translation>
    </message>
    <message>
        <source>STL file</source>
        <translation>Arquivo STL</translation>
    </message>
    <message>
        <source>A binary or ASCII STL file beside the project, up to 200 MB and 5 million triangles. It is drawn in the scenes of all analyses and influences no number.</source>
        <translation>Um arquivo STL binário ou ASCII ao lado do projeto, de até 200 MB e 5 milhões de triângulos. É desenhado nas cenas de todas as análises e não influencia nenhum número.</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>Unidade do arquivo</translation>
    </message>
    <message>
        <source>STL files do not say in which unit their numbers are.</source>
        <translation>Arquivos STL não dizem em que unidade estão seus números.</translation>
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
        <translation>polegada</translation>
    </message>
    <message>
        <source>Position and orientation</source>
        <translation>Posição e orientação</translation>
    </message>
    <message>
        <source>Where the origin of the file stands in the world frame, and how its axes are turned.</source>
        <translation>Onde está a origem do arquivo no referencial do mundo e como seus eixos estão girados.</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Aparência</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Cor</translation>
    </message>
    <message>
        <source>Of the surface, on a light and on a dark ground.</source>
        <translation>Da superfície, sobre fundo claro e sobre fundo escuro.</translation>
    </message>
    <message>
        <source>grey</source>
        <translation>cinza</translation>
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
        <translation>laranja</translation>
    </message>
    <message>
        <source>red</source>
        <translation>vermelho</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidade</translation>
    </message>
    <message>
        <source>100 % hides what is behind the surface; less lets the measured points be seen.</source>
        <translation>100 % esconde o que está atrás da superfície; com menos se veem os pontos medidos.</translation>
    </message>
    <message>
        <source>largest U/target</source>
        <translation>maior U/alvo</translation>
    </message>
    <message>
        <source>largest U relative to the present design</source>
        <translation>maior U em relação ao projeto atual</translation>
    </message>
    <message>
        <source>mean U/target</source>
        <translation>média de U/alvo</translation>
    </message>
    <message>
        <source>mean U relative to the present design</source>
        <translation>média de U em relação ao projeto atual</translation>
    </message>
    <message>
        <source>root mean square of U/target</source>
        <translation>média quadrática de U/alvo</translation>
    </message>
    <message>
        <source>root mean square of U relative to the present design</source>
        <translation>média quadrática de U em relação ao projeto atual</translation>
    </message>
    <message>
        <source>Monte Carlo</source>
        <translation>Monte Carlo</translation>
    </message>
    <message>
        <source>Run Monte Carlo to see the distribution of %1</source>
        <translation>Execute Monte Carlo para ver a distribuição de %1</translation>
    </message>
    <message>
        <source>Run Monte Carlo to see the quantiles of %1</source>
        <translation>Execute Monte Carlo para ver os quantis de %1</translation>
    </message>
    <message>
        <source>Run Monte Carlo with more trials to see the distribution of %1</source>
        <translation>Execute Monte Carlo com mais ensaios para ver a distribuição de %1</translation>
    </message>
    <message>
        <source>Run Monte Carlo with more trials to see the quantiles of %1</source>
        <translation>Execute Monte Carlo com mais ensaios para ver os quantis de %1</translation>
    </message>
    <message>
        <source>%1 has the same value in every trial: give its inputs components of uncertainty</source>
        <translation>%1 tem o mesmo valor em todos os ensaios: dê componentes de incerteza às suas grandezas de entrada</translation>
    </message>
    <message>
        <source>Distribution of %1</source>
        <translation>Distribuição de %1</translation>
    </message>
    <message>
        <source>probability density</source>
        <translation>densidade de probabilidade</translation>
    </message>
    <message>
        <source>normal, same mean and u</source>
        <translation>normal, mesma média e mesma u</translation>
    </message>
    <message>
        <source>normal, same interval</source>
        <translation>normal, mesmo intervalo</translation>
    </message>
    <message>
        <source>normal, first order</source>
        <translation>normal, primeira ordem</translation>
    </message>
    <message>
        <source>Student t, first order</source>
        <translation>t de Student, primeira ordem</translation>
    </message>
    <message>
        <source>%1 coverage interval</source>
        <translation>intervalo de abrangência de %1</translation>
    </message>
    <message>
        <source>mean %1</source>
        <translation>média %1</translation>
    </message>
    <message>
        <source>Normal quantiles of %1</source>
        <translation>Quantis normais de %1</translation>
    </message>
    <message>
        <source>quantile of the standard normal distribution</source>
        <translation>quantil da distribuição normal padrão</translation>
    </message>
    <message>
        <source>quantile of %1</source>
        <translation>quantil de %1</translation>
    </message>
    <message>
        <source>No input quantity with an uncertainty influences %1: give its inputs components of uncertainty</source>
        <translation>Nenhuma grandeza de entrada com incerteza influencia %1: dê componentes de incerteza às suas grandezas de entrada</translation>
    </message>
    <message>
        <source>Contributions to u(%1)</source>
        <translation>Contribuições para u(%1)</translation>
    </message>
    <message>
        <source>first order</source>
        <translation>primeira ordem</translation>
    </message>
    <message>
        <source>one at a time, Monte Carlo</source>
        <translation>uma de cada vez, Monte Carlo</translation>
    </message>
    <message>
        <source>%1 others</source>
        <translation>outras %1</translation>
    </message>
    <message>
        <source>A single output quantity has nothing to be correlated with</source>
        <translation>Uma única grandeza de saída não tem com que se correlacionar</translation>
    </message>
    <message>
        <source>Correlation coefficients</source>
        <translation>Coeficientes de correlação</translation>
    </message>
    <message>
        <source>correlation coefficient</source>
        <translation>coeficiente de correlação</translation>
    </message>
    <message>
        <source>Run Monte Carlo to see how u of %1 settles</source>
        <translation>Execute Monte Carlo para ver como u de %1 se estabiliza</translation>
    </message>
    <message>
        <source>%1, against the number of trials</source>
        <translation>%1 em função do número de ensaios</translation>
    </message>
    <message>
        <source>%1 (not stabilised)</source>
        <translation>%1 (não estabilizada)</translation>
    </message>
    <message>
        <source>± 2 standard errors</source>
        <translation>± 2 erros-padrão</translation>
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
        <translation>depois</translation>
    </message>
    <message>
        <source>Distributions of %1</source>
        <translation>Distribuições de %1</translation>
    </message>
    <message>
        <source>The output quantity has no distribution to show</source>
        <translation>A grandeza de saída não tem distribuição para mostrar</translation>
    </message>
    <message>
        <source>Only one of the results has %1</source>
        <translation>Só um dos resultados tem %1</translation>
    </message>
    <message>
        <source>The budget of %1 has not changed</source>
        <translation>O balanço de %1 não mudou</translation>
    </message>
    <message>
        <source>Changes of the budget of %1</source>
        <translation>Alterações do balanço de %1</translation>
    </message>
    <message>
        <source>uncertainty</source>
        <translation>incerteza</translation>
    </message>
    <message>
        <source>as set up: %1</source>
        <translation>como está configurado: %1</translation>
    </message>
    <message>
        <source>%1 at %2 = %3</source>
        <translation>%1 em %2 = %3</translation>
    </message>
    <message>
        <source>Run the study “%1” to see it</source>
        <translation>Execute o estudo “%1” para o ver</translation>
    </message>
    <message>
        <source>No grid point of “%1” has values: %2</source>
        <translation>Nenhum ponto da grade de “%1” tem valores: %2</translation>
    </message>
    <message>
        <source>Uncertainties before and after</source>
        <translation>Incertezas antes e depois</translation>
    </message>
    <message>
        <source>U relative to the present design</source>
        <translation>U em relação ao projeto atual</translation>
    </message>
    <message>
        <source>designed</source>
        <translation>projeto</translation>
    </message>
    <message>
        <source>What more rows give</source>
        <translation>O que mais linhas trazem</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>linhas</translation>
    </message>
    <message>
        <source>best found</source>
        <translation>o melhor encontrado</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>mantidas</translation>
    </message>
    <message>
        <source>What each row kept is worth</source>
        <translation>Quanto vale cada linha mantida</translation>
    </message>
    <message>
        <source>What a smaller uncertainty costs</source>
        <translation>Quanto custa uma incerteza menor</translation>
    </message>
    <message>
        <source>largest U / target</source>
        <translation>maior U / alvo</translation>
    </message>
    <message>
        <source>cost</source>
        <translation>custo</translation>
    </message>
    <message>
        <source>cheapest reductions</source>
        <translation>reduções mais baratas</translation>
    </message>
    <message>
        <source>cheapest rows</source>
        <translation>linhas mais baratas</translation>
    </message>
    <message>
        <source>targets</source>
        <translation>alvos</translation>
    </message>
    <message>
        <source>The way of the search</source>
        <translation>O caminho da busca</translation>
    </message>
    <message>
        <source>evaluations</source>
        <translation>avaliações</translation>
    </message>
    <message>
        <source>best so far</source>
        <translation>o melhor até agora</translation>
    </message>
    <message>
        <source>both</source>
        <translation>em ambos</translation>
    </message>
    <message>
        <source>only before</source>
        <translation>só antes</translation>
    </message>
    <message>
        <source>only after</source>
        <translation>só depois</translation>
    </message>
    <message>
        <source>new</source>
        <translation>nova</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>eliminada</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>alterada</translation>
    </message>
    <message>
        <source>same</source>
        <translation>igual</translation>
    </message>
    <message>
        <source>number of trials</source>
        <translation>número de ensaios</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Câmeras</translation>
    </message>
    <message>
        <source>Coordinate measuring machines and arms</source>
        <translation>Máquinas e braços de medição por coordenadas</translation>
    </message>
    <message>
        <source>Distance meters</source>
        <translation>Distanciômetros</translation>
    </message>
    <message>
        <source>Laser scanners</source>
        <translation>Scanners a laser</translation>
    </message>
    <message>
        <source>Laser trackers</source>
        <translation>Laser trackers</translation>
    </message>
    <message>
        <source>Length standards and ballbars</source>
        <translation>Padrões de comprimento e ballbars</translation>
    </message>
    <message>
        <source>Robot arms</source>
        <translation>Braços robóticos</translation>
    </message>
    <message>
        <source>Total stations</source>
        <translation>Estações totais</translation>
    </message>
    <message>
        <source>Uncertainty budget of a measured point</source>
        <translation>Balanço de incertezas de um ponto medido</translation>
    </message>
    <message>
        <source>Errors of indication (Eq 1)</source>
        <translation>Erros de indicação (eq. 1)</translation>
    </message>
    <message>
        <source>Errors of indication (Eq 4)</source>
        <translation>Erros de indicação (eq. 4)</translation>
    </message>
    <message>
        <source>Standard uncertainty of one reading, along and across the line of sight</source>
        <translation>Incerteza-padrão de uma leitura, ao longo e através da linha de visada</translation>
    </message>
    <message>
        <source>across, by azimuth</source>
        <translation>através, pelo azimute</translation>
    </message>
    <message>
        <source>across, by elevation</source>
        <translation>através, pela elevação</translation>
    </message>
    <message>
        <source>along</source>
        <translation>ao longo</translation>
    </message>
    <message>
        <source>Standard uncertainty by the readings alone, and with the stations</source>
        <translation>Incerteza-padrão só pelas leituras e com as estações</translation>
    </message>
    <message>
        <source>readings alone (Eq 5)</source>
        <translation>só leituras (eq. 5)</translation>
    </message>
    <message>
        <source>readings and shared deviations, first order</source>
        <translation>leituras e desvios comuns, primeira ordem</translation>
    </message>
    <message>
        <source>Parameters and their uncertainty</source>
        <translation>Parâmetros e sua incerteza</translation>
    </message>
    <message>
        <source>u, section 4.1</source>
        <translation>u, seção 4.1</translation>
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
        <translation>u, tabela 1</translation>
    </message>
    <message>
        <source>u, repeatability</source>
        <translation>u, repetibilidade</translation>
    </message>
    <message>
        <source>u, sampling</source>
        <translation>u, amostragem</translation>
    </message>
    <message>
        <source>u, range</source>
        <translation>u, faixa</translation>
    </message>
    <message>
        <source>Identified parameters beside the nominal ones</source>
        <translation>Parâmetros identificados ao lado dos nominais</translation>
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
        <translation>diferença</translation>
    </message>
    <message>
        <source>What these points cannot tell</source>
        <translation>O que estes pontos não podem dizer</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>motivo</translation>
    </message>
    <message>
        <source>Observability</source>
        <translation>Observabilidade</translation>
    </message>
    <message>
        <source>Strongest correlation of each unknown</source>
        <translation>Correlação mais forte de cada incógnita</translation>
    </message>
    <message>
        <source>Residuals of the fit, measured less calculated</source>
        <translation>Resíduos do ajuste, medido menos calculado</translation>
    </message>
    <message>
        <source>pose</source>
        <translation>pose</translation>
    </message>
    <message>
        <source>largest over its u</source>
        <translation>maior dividido por sua u</translation>
    </message>
    <message>
        <source>outlier test</source>
        <translation>teste de valores atípicos</translation>
    </message>
    <message>
        <source>Poses held back from the fit, calculated less measured</source>
        <translation>Poses reservadas do ajuste, calculado menos medido</translation>
    </message>
    <message>
        <source>nominal, distance</source>
        <translation>nominal, distância</translation>
    </message>
    <message>
        <source>U (k = 2), largest</source>
        <translation>U (k = 2), maior</translation>
    </message>
    <message>
        <source>E_n, largest</source>
        <translation>E_n, maior</translation>
    </message>
    <message>
        <source>Circles of the joints</source>
        <translation>Círculos das juntas</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>arco</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>raio</translation>
    </message>
    <message>
        <source>rms along the radius</source>
        <translation>rms ao longo do raio</translation>
    </message>
    <message>
        <source>rms off the plane</source>
        <translation>rms fora do plano</translation>
    </message>
    <message>
        <source>Readings and places of the poses, without uncertainty</source>
        <translation>Leituras e lugares das poses, sem incerteza</translation>
    </message>
    <message>
        <source>Relative uncertainty of the loads</source>
        <translation>Incerteza relativa das cargas</translation>
    </message>
    <message>
        <source>Calibration as planned and as read</source>
        <translation>Calibração prevista e lida</translation>
    </message>
    <message>
        <source>preloads</source>
        <translation>pré-cargas</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>séries</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>degraus</translation>
    </message>
    <message>
        <source>decreasing steps</source>
        <translation>degraus decrescentes</translation>
    </message>
    <message>
        <source>spread of the preloads</source>
        <translation>dispersão das pré-cargas</translation>
    </message>
    <message>
        <source>Rated output and non-zero error of each sensor (Kim, Table 1)</source>
        <translation>Saída nominal e erro de zero de cada sensor (Kim, tabela 1)</translation>
    </message>
    <message>
        <source>rated load</source>
        <translation>carga nominal</translation>
    </message>
    <message>
        <source>Interference error of each sensor (Kim, Table 2)</source>
        <translation>Erro de interferência de cada sensor (Kim, tabela 2)</translation>
    </message>
    <message>
        <source>Uncertainty of the sensors by the paper (Kim, Table 3, Eqs 4 to 12)</source>
        <translation>Incerteza dos sensores segundo o artigo (Kim, tabela 3, eqs. 4 a 12)</translation>
    </message>
    <message>
        <source>U, load</source>
        <translation>U, carga</translation>
    </message>
    <message>
        <source>Interference error in per cent of the rated output (Kim, Table 4)</source>
        <translation>Erro de interferência em por cento da saída nominal (Kim, tabela 4)</translation>
    </message>
    <message>
        <source>Parts of the Type B standard uncertainty (Eqs 5 to 8)</source>
        <translation>Partes da incerteza-padrão do tipo B (eqs. 5 a 8)</translation>
    </message>
    <message>
        <source>Means and standard deviations of the net values (Eqs 1 to 4)</source>
        <translation>Médias e desvios-padrão dos valores líquidos (eqs. 1 a 4)</translation>
    </message>
    <message>
        <source>mean, decreasing</source>
        <translation>média, decrescente</translation>
    </message>
    <message>
        <source>Stated values beside the computed ones</source>
        <translation>Valores declarados ao lado dos calculados</translation>
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
        <translation>Interferência com cargas nominais (% da saída nominal)</translation>
    </message>
    <message>
        <source>Parts of U by the paper (% of rated output)</source>
        <translation>Partes de U segundo o artigo (% da saída nominal)</translation>
    </message>
    <message>
        <source>per cent of rated output</source>
        <translation>por cento da saída nominal</translation>
    </message>
    <message>
        <source>k u_c</source>
        <translation>k u_c</translation>
    </message>
    <message>
        <source>Loads of one axis against time</source>
        <translation>Cargas de um eixo em função do tempo</translation>
    </message>
    <message>
        <source>Calibration curve of Fx</source>
        <translation>Curva de calibração de Fx</translation>
    </message>
    <message>
        <source>increasing, mean</source>
        <translation>crescente, média</translation>
    </message>
    <message>
        <source>decreasing, mean</source>
        <translation>decrescente, média</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of Fx</source>
        <translation>Resíduos em relação à reta por zero de Fx</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of Fx</source>
        <translation>Laço de histerese, ampliado, de Fx</translation>
    </message>
    <message>
        <source>Calibration curve of Fy</source>
        <translation>Curva de calibração de Fy</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of Fy</source>
        <translation>Resíduos em relação à reta por zero de Fy</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of Fy</source>
        <translation>Laço de histerese, ampliado, de Fy</translation>
    </message>
    <message>
        <source>Calibration curve of Fz</source>
        <translation>Curva de calibração de Fz</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of Fz</source>
        <translation>Resíduos em relação à reta por zero de Fz</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of Fz</source>
        <translation>Laço de histerese, ampliado, de Fz</translation>
    </message>
    <message>
        <source>Calibration curve of Mx</source>
        <translation>Curva de calibração de Mx</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of Mx</source>
        <translation>Resíduos em relação à reta por zero de Mx</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of Mx</source>
        <translation>Laço de histerese, ampliado, de Mx</translation>
    </message>
    <message>
        <source>Calibration curve of My</source>
        <translation>Curva de calibração de My</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of My</source>
        <translation>Resíduos em relação à reta por zero de My</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of My</source>
        <translation>Laço de histerese, ampliado, de My</translation>
    </message>
    <message>
        <source>Calibration curve of Mz</source>
        <translation>Curva de calibração de Mz</translation>
    </message>
    <message>
        <source>Residuals from the line through zero of Mz</source>
        <translation>Resíduos em relação à reta por zero de Mz</translation>
    </message>
    <message>
        <source>Hysteresis loop, magnified, of Mz</source>
        <translation>Laço de histerese, ampliado, de Mz</translation>
    </message>
    <message>
        <source>The paper&apos;s U and the GUM&apos;s, per cent of rated output</source>
        <translation>U do artigo e do GUM, por cento da saída nominal</translation>
    </message>
    <message>
        <source>paper, linear sum</source>
        <translation>artigo, soma linear</translation>
    </message>
    <message>
        <source>GUM, unknown loads on all other axes</source>
        <translation>GUM, cargas desconhecidas em todos os outros eixos</translation>
    </message>
    <message>
        <source>GUM, unknown load on one axis</source>
        <translation>GUM, carga desconhecida em um eixo</translation>
    </message>
    <message>
        <source>GUM, one component alone, 95 %</source>
        <translation>GUM, uma só componente, 95 %</translation>
    </message>
    <message>
        <source>all other axes at rated load, worst signs</source>
        <translation>todos os outros eixos à carga nominal, piores sinais</translation>
    </message>
    <message>
        <source>interference alone exceeds the paper&apos;s U</source>
        <translation>só a interferência excede a U do artigo</translation>
    </message>
    <message>
        <source>Standard uncertainties by the GUM</source>
        <translation>Incertezas-padrão segundo o GUM</translation>
    </message>
    <message>
        <source>repeatability</source>
        <translation>repetibilidade</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>máquina</translation>
    </message>
    <message>
        <source>non-zero</source>
        <translation>erro de zero</translation>
    </message>
    <message>
        <source>all</source>
        <translation>todas</translation>
    </message>
    <message>
        <source>U by the paper and by the GUM</source>
        <translation>U segundo o artigo e segundo o GUM</translation>
    </message>
    <message>
        <source>all others at rated load, worst signs</source>
        <translation>todos os outros à carga nominal, piores sinais</translation>
    </message>
    <message>
        <source>Calibration matrix: reading by load</source>
        <translation>Matriz de calibração: leitura por carga</translation>
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
        <translation>Matriz de desacoplamento: carga por leitura</translation>
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
        <translation>Cargas com e sem compensação da interferência</translation>
    </message>
    <message>
        <source>case</source>
        <translation>caso</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>leitura</translation>
    </message>
    <message>
        <source>compensated</source>
        <translation>compensada</translation>
    </message>
    <message>
        <source>uncompensated</source>
        <translation>não compensada</translation>
    </message>
    <message>
        <source>by rated load</source>
        <translation>por carga nominal</translation>
    </message>
    <message>
        <source>What interference adds without compensation</source>
        <translation>O que a interferência acrescenta sem compensação</translation>
    </message>
    <message>
        <source>per cent of rated load</source>
        <translation>por cento da carga nominal</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>mista</translation>
    </message>
    <message>
        <source>all rated</source>
        <translation>todas nominais</translation>
    </message>
    <message>
        <source>no load</source>
        <translation>sem carga</translation>
    </message>
    <message>
        <source>Supports in the instrument&apos;s frame and in the robot&apos;s</source>
        <translation>Apoios no sistema do instrumento e no do robô</translation>
    </message>
    <message>
        <source>support</source>
        <translation>apoio</translation>
    </message>
    <message>
        <source>Scatter of a pose that the robot is sent to again</source>
        <translation>Dispersão de uma pose à qual o robô volta</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>desvio</translation>
    </message>
    <message>
        <source>Rotations of the flange</source>
        <translation>Rotações do flange</translation>
    </message>
    <message>
        <source>about</source>
        <translation>em torno de</translation>
    </message>
    <message>
        <source>radius of the circle</source>
        <translation>raio do círculo</translation>
    </message>
    <message>
        <source>least height above the supports</source>
        <translation>altura mínima sobre os apoios</translation>
    </message>
    <message>
        <source>greatest height</source>
        <translation>altura máxima</translation>
    </message>
    <message>
        <source>Sensors of the network</source>
        <translation>Sensores da rede</translation>
    </message>
    <message>
        <source>reads</source>
        <translation>lê</translation>
    </message>
    <message>
        <source>Analysis of variance</source>
        <translation>Análise de variância</translation>
    </message>
    <message>
        <source>source of variation</source>
        <translation>fonte de variação</translation>
    </message>
    <message>
        <source>sum of squares</source>
        <translation>soma de quadrados</translation>
    </message>
    <message>
        <source>mean square</source>
        <translation>quadrado médio</translation>
    </message>
    <message>
        <source>Components of variance</source>
        <translation>Componentes da variância</translation>
    </message>
    <message>
        <source>Type A evaluation of observations</source>
        <translation>Avaliação do tipo A das observações</translation>
    </message>
    <message>
        <source>s of one observation</source>
        <translation>s de uma observação</translation>
    </message>
    <message>
        <source>u of the mean</source>
        <translation>u da média</translation>
    </message>
    <message>
        <source>number of the observation</source>
        <translation>número da observação</translation>
    </message>
    <message>
        <source>Points and their residuals</source>
        <translation>Pontos e seus resíduos</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>resíduo</translation>
    </message>
    <message>
        <source>Analysis of variance of the fit</source>
        <translation>Análise de variância do ajuste</translation>
    </message>
    <message>
        <source>Uncertainties</source>
        <translation>Incertezas</translation>
    </message>
    <message>
        <source>output</source>
        <translation>grandeza de saída</translation>
    </message>
    <message>
        <source>U by Monte Carlo</source>
        <translation>U por Monte Carlo</translation>
    </message>
    <message>
        <source>validated (clause 8)</source>
        <translation>validado (seção 8)</translation>
    </message>
    <message>
        <source>cost per unit of target</source>
        <translation>custo por unidade do alvo</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>variable</source>
        <translation>variável</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>escolhido</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>tolerância</translation>
    </message>
    <message>
        <source>Rows that are kept</source>
        <translation>Linhas que são mantidas</translation>
    </message>
    <message>
        <source>row</source>
        <translation>linha</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>fixa</translation>
    </message>
    <message>
        <source>of the candidates&apos; file</source>
        <translation>do arquivo de candidatos</translation>
    </message>
    <message>
        <source>objective without it</source>
        <translation>objetivo sem ela</translation>
    </message>
    <message>
        <source>price</source>
        <translation>preço</translation>
    </message>
    <message>
        <source>Candidates and what they gain</source>
        <translation>Candidatos e o que ganham</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>ganho</translation>
    </message>
    <message>
        <source>What would be gained without the uncertainty of</source>
        <translation>O que se ganharia sem a incerteza de</translation>
    </message>
    <message>
        <source>Objective and number of rows</source>
        <translation>Objetivo e número de linhas</translation>
    </message>
    <message>
        <source>objective</source>
        <translation>objetivo</translation>
    </message>
    <message>
        <source>change</source>
        <translation>alteração</translation>
    </message>
    <message>
        <source>Cost and uncertainty</source>
        <translation>Custo e incerteza</translation>
    </message>
    <message>
        <source>Improvements</source>
        <translation>Melhorias</translation>
    </message>
    <message>
        <source>evaluation</source>
        <translation>avaliação</translation>
    </message>
    <message>
        <source>search</source>
        <translation>busca</translation>
    </message>
    <message>
        <source>Candidates without result</source>
        <translation>Candidatos sem resultado</translation>
    </message>
    <message>
        <source>count</source>
        <translation>quantidade</translation>
    </message>
    <message>
        <source>U without %1</source>
        <translation>U sem %1</translation>
    </message>
    <message>
        <source>Expanded uncertainty that remains when everything %1 brings in is kept constant (an ideal one), by the law of propagation</source>
        <translation>Incerteza expandida que resta quando tudo o que %1 traz é mantido constante (um ideal), pela lei de propagação</translation>
    </message>
    <message>
        <source>Expanded uncertainty that remains when everything %1 brings in is kept constant (an ideal one), by Monte Carlo</source>
        <translation>Incerteza expandida que resta quando tudo o que %1 traz é mantido constante (um ideal), por Monte Carlo</translation>
    </message>
    <message>
        <source>symbol of the quantity</source>
        <translation>símbolo da grandeza</translation>
    </message>
    <message>
        <source>what it is</source>
        <translation>o que é</translation>
    </message>
    <message>
        <source>estimate</source>
        <translation>estimativa</translation>
    </message>
    <message>
        <source>unit of estimate and uncertainty</source>
        <translation>unidade da estimativa e da incerteza</translation>
    </message>
    <message>
        <source>uncertainty before the divisor</source>
        <translation>incerteza antes do divisor</translation>
    </message>
    <message>
        <source>half-width of the limits</source>
        <translation>meia largura dos limites</translation>
    </message>
    <message>
        <source>divisor, coverage factor k</source>
        <translation>divisor, fator de abrangência k</translation>
    </message>
    <message>
        <source>sensitivity coefficient</source>
        <translation>coeficiente de sensibilidade</translation>
    </message>
    <message>
        <source>contribution to u(y)</source>
        <translation>contribuição para u(y)</translation>
    </message>
    <message>
        <source>where the figure comes from</source>
        <translation>de onde vem o número</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>não lida</translation>
    </message>
    <message>
        <source>name of the point</source>
        <translation>nome do ponto</translation>
    </message>
    <message>
        <source>standard uncertainty of x, y, z</source>
        <translation>incerteza-padrão de x, y, z</translation>
    </message>
    <message>
        <source>standard uncertainty of x</source>
        <translation>incerteza-padrão de x</translation>
    </message>
    <message>
        <source>standard uncertainty of y</source>
        <translation>incerteza-padrão de y</translation>
    </message>
    <message>
        <source>standard uncertainty of z</source>
        <translation>incerteza-padrão de z</translation>
    </message>
    <message>
        <source>expanded uncertainty of x, y, z, k = 2</source>
        <translation>incerteza expandida de x, y, z, k = 2</translation>
    </message>
    <message>
        <source>expanded uncertainty of x, k = 2</source>
        <translation>incerteza expandida de x, k = 2</translation>
    </message>
    <message>
        <source>expanded uncertainty of y, k = 2</source>
        <translation>incerteza expandida de y, k = 2</translation>
    </message>
    <message>
        <source>expanded uncertainty of z, k = 2</source>
        <translation>incerteza expandida de z, k = 2</translation>
    </message>
    <message>
        <source>Kind of change</source>
        <translation>Tipo de alteração</translation>
    </message>
    <message>
        <source>Fields of the set-up</source>
        <translation>Campos da configuração</translation>
    </message>
    <message>
        <source>Equations as evaluated</source>
        <translation>Equações como são avaliadas</translation>
    </message>
    <message>
        <source>References</source>
        <translation>Referências</translation>
    </message>
    <message>
        <source>Options of the evaluation</source>
        <translation>Opções da avaliação</translation>
    </message>
    <message>
        <source>What a calibration certificate says beside its results, with the clause of ISO/IEC 17025:2017 that asks for it.</source>
        <translation>O que um certificado de calibração diz além dos resultados, com o item da ISO/IEC 17025:2017 que o pede.</translation>
    </message>
    <message>
        <source>optional</source>
        <translation>opcional</translation>
    </message>
    <message>
        <source>default %1</source>
        <translation>padrão %1</translation>
    </message>
    <message>
        <source>Choices: </source>
        <translation>Opções: </translation>
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
        <translation>número inteiro</translation>
    </message>
    <message>
        <source>choice</source>
        <translation>escolha</translation>
    </message>
    <message>
        <source>text</source>
        <translation>texto</translation>
    </message>
    <message>
        <source>flag</source>
        <translation>sim ou não</translation>
    </message>
    <message>
        <source>table</source>
        <translation>tabela</translation>
    </message>
    <message>
        <source>reference to an asset</source>
        <translation>referência a um recurso</translation>
    </message>
    <message>
        <source>real number</source>
        <translation>número real</translation>
    </message>
    <message>
        <source>Position and orientation of a moving frame in a base frame, both defined by measured points: the platform of a robot measured with a total station or laser tracker.</source>
        <translation>Posição e orientação de um sistema móvel em um sistema de base, ambos definidos por pontos medidos: a plataforma de um robô medida com estação total ou laser tracker.</translation>
    </message>
    <message>
        <source>Eq 19 is corrected: o_p − o_b must be expressed in the base frame. As printed, the pose does not depend on the orientation of the base, and U(x) of all poses is the same.</source>
        <translation>A eq. 19 é corrigida: o_p − o_b deve ser expresso no sistema da base. Como impressa, a pose não depende da orientação da base, e U(x) de todas as poses é o mesmo.</translation>
    </message>
    <message>
        <source>Eq 20 is corrected: R = R_bᵀ R_p. The printed R_p R_bᵀ is the same rotation expressed in frame 0.</source>
        <translation>A eq. 20 é corrigida: R = R_bᵀ R_p. O R_p R_bᵀ impresso é a mesma rotação expressa no sistema 0.</translation>
    </message>
    <message>
        <source>Eqs 21-23 are corrected: as printed they are Z-Y-Z angles, undefined without tilt; the text and Table 3 use Z-Y-X angles, R = Rz(γ) Ry(β) Rx(α).</source>
        <translation>As eqs. 21-23 são corrigidas: como impressas são ângulos Z-Y-Z, indefinidos sem inclinação; o texto e a Tabela 3 usam ângulos Z-Y-X, R = Rz(γ) Ry(β) Rx(α).</translation>
    </message>
    <message>
        <source>b₃ lies at negative y of its frame (Eq 10) and p₃ at positive y of its own (Eq 14); other arrangements can be chosen.</source>
        <translation>b₃ está no y negativo de seu sistema (eq. 10) e p₃ no y positivo do seu (eq. 14); outras disposições podem ser escolhidas.</translation>
    </message>
    <message>
        <source>Typed uncertainties lie along the axes of the frame that the points define (those of the moving frame along the base&apos;s on request) and are turned into frame 0; those of an instrument lie along and across its line of sight.</source>
        <translation>Incertezas digitadas seguem os eixos do sistema que os pontos definem (as do sistema móvel, a pedido, os da base) e são giradas para o sistema 0; as de um instrumento ficam ao longo e através de sua linha de visada.</translation>
    </message>
    <message>
        <source>Measured points of a least-squares frame are tested against their nominal coordinates: residuals, redundancy, chi-square with the full covariance of the stated uncertainties.</source>
        <translation>Pontos medidos de um sistema de mínimos quadrados são testados contra suas coordenadas nominais: resíduos, redundância, qui-quadrado com a covariância completa das incertezas declaradas.</translation>
    </message>
    <message>
        <source>All poses of an analysis share one measurement of the base, so their results are correlated.</source>
        <translation>Todas as poses de uma análise compartilham uma medição da base, de modo que seus resultados são correlacionados.</translation>
    </message>
    <message>
        <source>The uncertainty of the mean of repeated measurements (a posteriori) is taken as that of one measurement, as in the paper: the systematic part does not average out.</source>
        <translation>A incerteza da média de medições repetidas (a posteriori) é tomada como a de uma medição, como no artigo: a parte sistemática não se anula na média.</translation>
    </message>
    <message>
        <source>Angles are undefined in gimbal lock; the set-up then warns. Rotation vector and quaternion are free of it.</source>
        <translation>Os ângulos são indefinidos em gimbal lock; a configuração então avisa. Vetor de rotação e quatérnio estão livres disso.</translation>
    </message>
    <message>
        <source>Coordinates of targets and distances between them, measured by any mix of trackers, total stations, cameras and distance meters placed in space.</source>
        <translation>Coordenadas de alvos e distâncias entre eles, medidas por qualquer mistura de trackers, estações totais, câmeras e medidores de distância colocados no espaço.</translation>
    </message>
    <message>
        <source>The uncertainty of the stations does not contribute marginally to the position of a target, as the paper says: only distances within one set-up are nearly free of it. Eq 5 is the precision of the readings; it is shown beside the total, never as the uncertainty of a position.</source>
        <translation>A incerteza das estações não contribui apenas marginalmente para a posição de um alvo, como diz o artigo: só as distâncias dentro de um estacionamento estão quase livres dela. A eq. 5 é a precisão das leituras; é mostrada ao lado do total, nunca como incerteza de uma posição.</translation>
    </message>
    <message>
        <source>Weights from the readings alone, as in the paper, are inefficient for positions; those with the stations are the default.</source>
        <translation>Pesos só das leituras, como no artigo, são ineficientes para posições; os que incluem as estações são o padrão.</translation>
    </message>
    <message>
        <source>Eq 2 is corrected: D holds equations by readings; as printed it is transposed.</source>
        <translation>A eq. 2 é corrigida: D contém equações por leituras; como impressa está transposta.</translation>
    </message>
    <message>
        <source>The linearised equations have the measured angles in M: their estimate shrinks towards the sensors, the non-linear one moves outwards by half as much. It matters beyond a milliradian (3.5 mrad, cameras alone: −6.9 mm against +3.3 mm) and not for the paper&apos;s network.</source>
        <translation>As equações linearizadas têm os ângulos medidos em M: sua estimativa encolhe em direção aos sensores, a não linear move-se para fora a metade disso. Importa além de um milirradiano (3,5 mrad, só câmeras: −6,9 mm contra +3,3 mm) e não para a rede do artigo.</translation>
    </message>
    <message>
        <source>Stations are located once for a set-up: all its targets share their deviations. &quot;New set-up&quot; at a target draws them anew.</source>
        <translation>As estações são localizadas uma vez por estacionamento: todos os seus alvos compartilham seus desvios. &quot;Novo estacionamento&quot; num alvo sorteia-os de novo.</translation>
    </message>
    <message>
        <source>A distance without angles has no linear equation; the non-linear estimator uses it, from the nominal coordinates as start.</source>
        <translation>Uma distância sem ângulos não tem equação linear; o estimador não linear a usa, com as coordenadas nominais como início.</translation>
    </message>
    <message>
        <source>A calibrated length as a check is not used in the estimation: its difference is to be judged by its uncertainty. As a constraint it carries its own uncertainty; a scale that the instruments share is corrected by it.</source>
        <translation>Um comprimento calibrado como verificação não é usado na estimação: sua diferença deve ser julgada por sua incerteza. Como restrição traz sua própria incerteza; uma escala que os instrumentos compartilham é corrigida por ele.</translation>
    </message>
    <message>
        <source>With more than 600 readings in one set-up each target is estimated by itself, weighted with the stations.</source>
        <translation>Com mais de 600 leituras num estacionamento cada alvo é estimado por si, ponderado com as estações.</translation>
    </message>
    <message>
        <source>Azimuths may be given with any number of whole turns.</source>
        <translation>Azimutes podem ser dados com qualquer número de voltas inteiras.</translation>
    </message>
    <message>
        <source>The tool centre point of a robot: the flange turns about its own axes, telescopic ballbars measure where the ball at the tool goes, and planes and a sphere give the flange&apos;s axes and centre.</source>
        <translation>O ponto central da ferramenta de um robô: o flange gira em torno de seus próprios eixos, ballbars telescópicas medem aonde vai a esfera da ferramenta, e planos e uma esfera dão os eixos e o centro do flange.</translation>
    </message>
    <message>
        <source>The paper states neither the tool, nor the flange&apos;s orientation, start angles, how the frame is made, nor how the points are averaged. With a tool of (0, 0, 100) mm, the flange pointing down, arcs from -60° to 140° and from -90° to 90° and u(L) = 1.55 µm, the published values reproduce within 1.5 % (root mean square).</source>
        <translation>O artigo não declara a ferramenta, nem a orientação do flange, nem os ângulos iniciais, nem como o sistema é construído, nem como os pontos são ponderados na média. Com uma ferramenta de (0, 0, 100) mm, o flange apontando para baixo, arcos de -60° a 140° e de -90° a 90° e u(L) = 1,55 µm, os valores publicados se reproduzem dentro de 1,5 % (valor quadrático médio).</translation>
    </message>
    <message>
        <source>U(TCP): published 8.2, 11.1, 5.1 µm; here 8.16, 10.92, 5.00 µm: reproduces.</source>
        <translation>U(TCP): publicado 8,2, 11,1, 5,1 µm; aqui 8,16, 10,92, 5,00 µm: reproduz.</translation>
    </message>
    <message>
        <source>U(TCP) with an ideal robot: published 2.8, 3.7, 1.6 µm; here 2.77, 3.61, 1.57 µm: reproduces.</source>
        <translation>U(TCP) com um robô ideal: publicado 2,8, 3,7, 1,6 µm; aqui 2,77, 3,61, 1,57 µm: reproduz.</translation>
    </message>
    <message>
        <source>U of the axes&apos; angles XY, XZ, YX, YZ: published 79, 87, 59, 123 µrad; here 78.3, 87.2, 58.5, 120.6 µrad: reproduces.</source>
        <translation>U dos ângulos dos eixos XY, XZ, YX, YZ: publicado 79, 87, 59, 123 µrad; aqui 78,3, 87,2, 58,5, 120,6 µrad: reproduz.</translation>
    </message>
    <message>
        <source>Largest U of a point measured by the ballbars alone: published 5.7, 5.7, 2.4 µm; here 5.83, 5.72, 2.38 µm: reproduces.</source>
        <translation>Maior U de um ponto medido só pelas ballbars: publicado 5,7, 5,7, 2,4 µm; aqui 5,83, 5,72, 2,38 µm: reproduz.</translation>
    </message>
    <message>
        <source>With the stated U(L) = 4 µm the same geometry gives U(TCP) 8.46, 11.31, 5.16 µm and points up to 7.53, 7.37, 3.07 µm: differs, because the stated 4 µm and the published points cannot both hold. U(z) of a point at most 577 mm above the supports is 2.4 µm only for U(L) near 3.1 µm; all six figures of the instrument alone are 0.78 of what 4 µm gives.</source>
        <translation>Com o U(L) = 4 µm declarado a mesma geometria dá U(TCP) 8,46, 11,31, 5,16 µm e pontos de até 7,53, 7,37, 3,07 µm: difere, porque os 4 µm declarados e os pontos publicados não podem valer ambos. U(z) de um ponto no máximo 577 mm acima dos apoios só é 2,4 µm para U(L) perto de 3,1 µm; os seis números do instrumento sozinho são 0,78 do que 4 µm dá.</translation>
    </message>
    <message>
        <source>The centre of the sphere is the centre of the flange, not the tool centre point as section 4 says: its U is 5.96, 7.42, 6.94 µm.</source>
        <translation>O centro da esfera é o centro do flange, não o ponto central da ferramenta como diz a seção 4: seu U é 5,96, 7,42, 6,94 µm.</translation>
    </message>
    <message>
        <source>Eq 8 needs perpendicular axes, which two measured normals are not: U(x) of the tool is 8.16, 8.37 or 8.66 µm with y first, symmetric or x first.</source>
        <translation>A eq. 8 precisa de eixos perpendiculares, o que duas normais medidas não são: U(x) da ferramenta é 8,16, 8,37 ou 8,66 µm com y primeiro, simétrico ou x primeiro.</translation>
    </message>
    <message>
        <source>A trial whose lengths do not meet (negative root of Eq 3) has no value: it is counted and reported.</source>
        <translation>Um ensaio cujos comprimentos não se encontram (raiz negativa da eq. 3) não tem valor: é contado e relatado.</translation>
    </message>
    <message>
        <source>Position and orientation of the tool of a serial robot from its geometric parameters and joint readings.</source>
        <translation>Posição e orientação da ferramenta de um robô serial a partir de seus parâmetros geométricos e das leituras das juntas.</translation>
    </message>
    <message>
        <source>The paper calls the model highly non-linear. At the uncertainties of its Table 1 it is not: the law of propagation and Monte Carlo agree to 4e-5 mm in u, and the laws are normal.</source>
        <translation>O artigo chama o modelo de altamente não linear. Com as incertezas de sua Tabela 1 não é: a lei de propagação e Monte Carlo concordam a 4e-5 mm em u, e as leis são normais.</translation>
    </message>
    <message>
        <source>The tolerance 0.0001 of the paper has no unit. In millimetres it would need 5e9 trials; in metres it is 0.1 mm, and 20 000 trials do.</source>
        <translation>A tolerância 0,0001 do artigo não tem unidade. Em milímetros precisaria de 5e9 ensaios; em metros é 0,1 mm, e 20 000 ensaios bastam.</translation>
    </message>
    <message>
        <source>The paper takes the parameters as uncorrelated. Parameters identified together are strongly correlated; an identified robot carries their full covariance into this analysis, which lowers u by up to a factor of 12.</source>
        <translation>O artigo toma os parâmetros como não correlacionados. Parâmetros identificados juntos são fortemente correlacionados; um robô identificado traz sua covariância completa a esta análise, o que reduz u por um fator de até 12.</translation>
    </message>
    <message>
        <source>Of two readings of section 4.1 (0.01 rad for theta alone, or for all angles) both are reproduced; that theta matters more than alpha holds only where its standard deviation is ten times larger.</source>
        <translation>Das duas leituras da seção 4.1 (0,01 rad só para theta, ou para todos os ângulos) ambas são reproduzidas; que theta importe mais que alpha só vale onde seu desvio-padrão é dez vezes maior.</translation>
    </message>
    <message>
        <source>Readings of the joints deviate anew at each pose; parameters and tool are the same for all poses of an analysis.</source>
        <translation>As leituras das juntas desviam-se de novo em cada pose; parâmetros e ferramenta são os mesmos para todas as poses de uma análise.</translation>
    </message>
    <message>
        <source>Geometric parameters of a serial robot from points measured while one joint after the other turns (circle point analysis).</source>
        <translation>Parâmetros geométricos de um robô serial a partir de pontos medidos enquanto uma junta após a outra gira (análise de pontos de círculo).</translation>
    </message>
    <message>
        <source>Eq 4 is corrected: without the square its derivative by R gives R = 0.</source>
        <translation>A eq. 4 é corrigida: sem o quadrado sua derivada por R dá R = 0.</translation>
    </message>
    <message>
        <source>2.1.3 is corrected: x_i = z_i × y_i is left-handed.</source>
        <translation>2.1.3 é corrigido: x_i = z_i × y_i é levogiro.</translation>
    </message>
    <message>
        <source>2.1.4 is corrected: alpha_i and beta_i turn z_{i−1} into z_i.</source>
        <translation>2.1.4 é corrigido: alpha_i e beta_i giram z_{i−1} para z_i.</translation>
    </message>
    <message>
        <source>The auxiliary plane of Figure 2 is not defined in the paper; it must pass through O_{i−1} with the normal z_{i−1}, or d_i = 0 is impossible.</source>
        <translation>O plano auxiliar da Figura 2 não é definido no artigo; deve passar por O_{i−1} com a normal z_{i−1}, ou d_i = 0 é impossível.</translation>
    </message>
    <message>
        <source>Eq 1 has no plane through the origin and fails near it; total least squares is the default.</source>
        <translation>A eq. 1 não tem plano pela origem e falha perto dela; mínimos quadrados totais são o padrão.</translation>
    </message>
    <message>
        <source>Eq 8 is a standard deviation of the mean of repeats. The paper applies it to different ranges and numbers of points, which are no repeats: the ±10° run dominates, and the noise is counted three times. Here the covariance is that of the chosen experiment.</source>
        <translation>A eq. 8 é um desvio-padrão da média de repetições. O artigo a aplica a faixas e números de pontos diferentes, que não são repetições: a série de ±10° domina, e o ruído é contado três vezes. Aqui a covariância é a do experimento escolhido.</translation>
    </message>
    <message>
        <source>The standard deviation falls with the square of the range (factor 30 from ±10° to ±60°) and with the root of the number of points.</source>
        <translation>O desvio-padrão cai com o quadrado da faixa (fator 30 de ±10° a ±60°) e com a raiz do número de pontos.</translation>
    </message>
    <message>
        <source>Parameters are strongly correlated (d_3 and alpha_3: −0.99): use their full covariance, as an identified robot does.</source>
        <translation>Os parâmetros são fortemente correlacionados (d_3 e alpha_3: −0,99): use sua covariância completa, como faz um robô identificado.</translation>
    </message>
    <message>
        <source>Every joint needs a ball off its axis; at the paper&apos;s flange origin joint 6 draws no circle.</source>
        <translation>Cada junta precisa de uma esfera fora de seu eixo; na origem do flange do artigo a junta 6 não traça círculo.</translation>
    </message>
    <message>
        <source>Geometric parameters of a serial robot by least squares from measured positions or poses of its tool, with observability, residuals and validation.</source>
        <translation>Parâmetros geométricos de um robô serial por mínimos quadrados a partir de posições ou poses medidas de sua ferramenta, com observabilidade, resíduos e validação.</translation>
    </message>
    <message>
        <source>The paper identifies parameters by joint trajectories; least squares on measured positions or poses is the other usual way, with the same model of the arm (Eq 5).</source>
        <translation>O artigo identifica parâmetros por trajetórias de juntas; mínimos quadrados sobre posições ou poses medidas é a outra forma usual, com o mesmo modelo do braço (eq. 5).</translation>
    </message>
    <message>
        <source>Parameters that the poses cannot tell are found by their columns of the Jacobian: each that is a combination of those before it (base, then ball or tool, then joint by joint) stays nominal and is named with its partners.</source>
        <translation>Parâmetros que as poses não podem distinguir são encontrados por suas colunas da jacobiana: cada um que é combinação dos anteriores (base, depois esfera ou ferramenta, depois junta por junta) fica nominal e é nomeado com seus parceiros.</translation>
    </message>
    <message>
        <source>Weights are the inverse variances of the measured coordinates. Shared deviations of an instrument and the readings of the joints do not change the weights, but are propagated in full.</source>
        <translation>Os pesos são as variâncias inversas das coordenadas medidas. Desvios comuns de um instrumento e as leituras das juntas não mudam os pesos, mas são propagados por inteiro.</translation>
    </message>
    <message>
        <source>In each trial the gain of the estimates is used. It differs from a complete fit by residual times curvature, below 1e-9 m here.</source>
        <translation>Em cada ensaio usa-se o ganho das estimativas. Difere de um ajuste completo por resíduo vezes curvatura, aqui abaixo de 1e-9 m.</translation>
    </message>
    <message>
        <source>Position alone does not tell the last joint&apos;s parameters from the place of the ball; a known base and a known ball leave more to find.</source>
        <translation>Só a posição não distingue os parâmetros da última junta do lugar da esfera; uma base conhecida e uma esfera conhecida deixam mais a encontrar.</translation>
    </message>
    <message>
        <source>The uncertainty of each channel of a multi-axis force/moment sensor, used alone or while unknown loads act on its other axes; by the GUM, with the paper&apos;s evaluation beside it.</source>
        <translation>A incerteza de cada canal de um sensor multieixo de força e momento, usado sozinho ou enquanto cargas desconhecidas atuam em seus outros eixos; pelo GUM, com a avaliação do artigo ao lado.</translation>
    </message>
    <message>
        <source>U of the paper: 0.91, 1.22, 1.67, 1.68, 2.78, 1.20 % of rated output: reproduces.</source>
        <translation>U do artigo: 0,91, 1,22, 1,67, 1,68, 2,78, 1,20 % da saída nominal: reproduz.</translation>
    </message>
    <message>
        <source>By the GUM (k = 2) with unknown loads on the other five axes: 1.446, 1.425, 2.123, 2.637, 2.990, 1.388 %. With all others at rated load interference alone reaches 2.70, 2.12, 3.33, 4.59, 3.70, 2.27 %, more than U of the paper for all six: its linear sum is no bound.</source>
        <translation>Pelo GUM (k = 2) com cargas desconhecidas nos outros cinco eixos: 1,446, 1,425, 2,123, 2,637, 2,990, 1,388 %. Com todos os outros em carga nominal só a interferência alcança 2,70, 2,12, 3,33, 4,59, 3,70, 2,27 %, mais que o U do artigo para os seis: sua soma linear não é um limite.</translation>
    </message>
    <message>
        <source>Monte Carlo intervals are a little shorter than k = 2 because a few rectangular loads dominate.</source>
        <translation>Os intervalos de Monte Carlo são um pouco mais curtos que k = 2 porque umas poucas cargas retangulares dominam.</translation>
    </message>
    <message>
        <source>The load on an axis is one quantity in the equations of all channels, which correlates them.</source>
        <translation>A carga num eixo é uma só grandeza nas equações de todos os canais, o que os correlaciona.</translation>
    </message>
    <message>
        <source>With n = 3 a standard deviation has two degrees of freedom. Used alone a channel has effective degrees of freedom between 20 and 140, because its repeatability is a small part.</source>
        <translation>Com n = 3 um desvio-padrão tem dois graus de liberdade. Usado sozinho um canal tem graus de liberdade efetivos entre 20 e 140, porque sua repetibilidade é uma parte pequena.</translation>
    </message>
    <message>
        <source>Not covered: misalignment of the loads, creep, temperature, remounting.</source>
        <translation>Não incluído: desalinhamento das cargas, fluência, temperatura, remontagem.</translation>
    </message>
    <message>
        <source>Forces and moments that act together, from the readings of all channels of a multi-axis sensor: the calibration matrix takes the interference between them away.</source>
        <translation>Forças e momentos que atuam juntos, a partir das leituras de todos os canais de um sensor multieixo: a matriz de calibração retira a interferência entre eles.</translation>
    </message>
    <message>
        <source>Kim prints no signs of the interference: nothing can be compensated from the paper. The readings of the example have signs of their own.</source>
        <translation>Kim não imprime sinais da interferência: nada pode ser compensado a partir do artigo. As leituras do exemplo têm sinais próprios.</translation>
    </message>
    <message>
        <source>U (k = 2) in % of rated load with all six axes at rated load: 0.184, 0.192, 0.152, 0.226, 0.219, 0.261; without load 0.149, 0.159, 0.144, 0.188, 0.179, 0.180. Compensation lowers the uncertainty under combined loads by a factor of 5 to 13 against U of the paper.</source>
        <translation>U (k = 2) em % da carga nominal com os seis eixos em carga nominal: 0,184, 0,192, 0,152, 0,226, 0,219, 0,261; sem carga 0,149, 0,159, 0,144, 0,188, 0,179, 0,180. A compensação reduz a incerteza sob cargas combinadas por um fator de 5 a 13 em relação ao U do artigo.</translation>
    </message>
    <message>
        <source>Without compensation the same loads are told wrong by -0.73, +2.05, -1.42, -2.72, +2.90, -1.54 %.</source>
        <translation>Sem compensação as mesmas cargas são indicadas com erro de -0,73, +2,05, -1,42, -2,72, +2,90, -1,54 %.</translation>
    </message>
    <message>
        <source>The machine&apos;s deviation is common to all readings under one load: a column of the matrix, and so a scale of the load on that axis.</source>
        <translation>O desvio da máquina é comum a todas as leituras sob uma carga: uma coluna da matriz, e assim uma escala da carga nesse eixo.</translation>
    </message>
    <message>
        <source>Repeatability is that of one reading, the largest of the steps; hysteresis is rectangular over the loop, in proportion to the load.</source>
        <translation>A repetibilidade é a de uma leitura, a maior dos degraus; a histerese é retangular ao longo do laço, proporcional à carga.</translation>
    </message>
    <message>
        <source>Not covered: products of loads in the interference, misalignment of loads, creep, temperature, remounting.</source>
        <translation>Não incluído: produtos de cargas na interferência, desalinhamento de cargas, fluência, temperatura, remontagem.</translation>
    </message>
    <message>
        <source>Sensitivity coefficients are exact (automatic differentiation); those of unknowns that equations define implicitly follow JCGM 102 6.3.</source>
        <translation>Os coeficientes de sensibilidade são exatos (derivação automática); os de incógnitas que equações definem implicitamente seguem a JCGM 102 6.3.</translation>
    </message>
    <message>
        <source>JCGM 100 H.1, H.2 and JCGM 101 9.2 to 9.5, JCGM 102 9.2 to 9.4 are examples in projects/gum: covaria verify holds them against their published values.</source>
        <translation>JCGM 100 H.1, H.2 e JCGM 101 9.2 a 9.5, JCGM 102 9.2 a 9.4 são exemplos em projects/gum: covaria verify os confronta com seus valores publicados.</translation>
    </message>
    <message>
        <source>A straight line or polynomial through the points of a calibration by least squares, with uncertainties in y and in x: the covariance of its coefficients, its values, and the x that belong to observed y, with their uncertainties.</source>
        <translation>Uma reta ou um polinômio pelos pontos de uma calibração por mínimos quadrados, com incertezas em y e em x: a covariância de seus coeficientes, seus valores e os x que correspondem aos y observados, com suas incertezas.</translation>
    </message>
    <message>
        <source>Computed with polynomials that are orthonormal over the points, so results do not depend on the origin, up to degree 10. From the residuals their coefficients are drawn from a multivariate t distribution: one estimate of the scatter, n - p degrees of freedom for every result.</source>
        <translation>Calculado com polinômios ortonormais sobre os pontos, de modo que os resultados não dependem da origem, até o grau 10. A partir dos resíduos seus coeficientes são sorteados de uma distribuição t multivariada: uma estimativa da dispersão, n - p graus de liberdade para cada resultado.</translation>
    </message>
    <message>
        <source>JCGM 100 H.3, published y₁ = −0.1712 °C, y₂ = 0.002 18, u(y₁) = 0.0029 °C, u(y₂) = 0.000 67, b(30 °C) = −0.1494 °C with u = 0.0041 °C: reproduces.</source>
        <translation>JCGM 100 H.3, publicado y₁ = −0,1712 °C, y₂ = 0,002 18, u(y₁) = 0,0029 °C, u(y₂) = 0,000 67, b(30 °C) = −0,1494 °C com u = 0,0041 °C: reproduz.</translation>
    </message>
    <message>
        <source>The uncertainty of b(x) is that of the curve: the scatter of a further observation is not part of it.</source>
        <translation>A incerteza de b(x) é a da curva: a dispersão de uma observação adicional não faz parte dela.</translation>
    </message>
    <message>
        <source>The mean of observations made on several days, with several instruments or by several operators, and an analysis of variance that says whether these have an effect.</source>
        <translation>A média de observações feitas em vários dias, com vários instrumentos ou por vários operadores, e uma análise de variância que diz se estes têm efeito.</translation>
    </message>
    <message>
        <source>Groups may have different numbers of observations; n_0 = (N − Σ n_j²/N)/(J − 1) is then their size in the components of variance.</source>
        <translation>Os grupos podem ter números diferentes de observações; n_0 = (N − Σ n_j²/N)/(J − 1) é então seu tamanho nas componentes de variância.</translation>
    </message>
    <message>
        <source>JCGM 100 H.5, published V̄ = 10.000 097 V, s(V̄_j) = 57 µV, s_b = 85 µV, u(V̄) = 18 µV with nine degrees of freedom, or 13 µV with 49 without an effect of the days: reproduces.</source>
        <translation>JCGM 100 H.5, publicado V̄ = 10,000 097 V, s(V̄_j) = 57 µV, s_b = 85 µV, u(V̄) = 18 µV com nove graus de liberdade, ou 13 µV com 49 sem efeito dos dias: reproduz.</translation>
    </message>
    <message>
        <source>A plate or frame with calibrated nests, measured repeatedly where the real points will be. Its errors of indication give the uncertainty of each coordinate of a measured point.</source>
        <translation>Uma placa ou armação com assentos calibrados, medida repetidamente onde estarão os pontos reais. Seus erros de indicação dão a incerteza de cada coordenada de um ponto medido.</translation>
    </message>
    <message>
        <source>u_i² = u_cal² + u_var,i² + u_T,i² + b_i² (Eq 2) with u_T = L_max α ΔT/√3 (Eq 3).</source>
        <translation>u_i² = u_cal² + u_var,i² + u_T,i² + b_i² (eq. 2) com u_T = L_max α ΔT/√3 (eq. 3).</translation>
    </message>
    <message>
        <source>The paper draws all parts independently for each point; calibration, temperature and bias are in truth common to all points, which can be chosen.</source>
        <translation>O artigo sorteia todas as partes independentemente para cada ponto; calibração, temperatura e tendência são na verdade comuns a todos os pontos, o que pode ser escolhido.</translation>
    </message>
    <message>
        <source>The noise of the three points that define the artefact&apos;s frame is part of the errors of the others; the errors of the defining coordinates themselves are never observed.</source>
        <translation>O ruído dos três pontos que definem o sistema do padrão faz parte dos erros dos outros; os erros das próprias coordenadas que o definem nunca são observados.</translation>
    </message>
    <message>
        <source>A bar of calibrated length, measured in many positions and orientations. Its errors of indication give one figure for every coordinate of a measured point.</source>
        <translation>Uma barra de comprimento calibrado, medida em muitas posições e orientações. Seus erros de indicação dão um número para cada coordenada de um ponto medido.</translation>
    </message>
    <message>
        <source>u² = u_cal² + u_var² + u_T² + b² (Eq 5) with u_T = L α ΔT/√3 (Eq 6).</source>
        <translation>u² = u_cal² + u_var² + u_T² + b² (eq. 5) com u_T = L α ΔT/√3 (eq. 6).</translation>
    </message>
    <message>
        <source>A length is a difference of two points: dividing by √2 would be consistent; the paper does not.</source>
        <translation>Um comprimento é uma diferença de dois pontos: dividir por √2 seria coerente; o artigo não o faz.</translation>
    </message>
    <message>
        <source>A sensor that stands somewhere and reads a distance, two angles, or some of them. Its uncertainty: each reading for itself, what all its readings share, and where it stands.</source>
        <translation>Um sensor que está em algum lugar e lê uma distância, dois ângulos, ou alguns deles. Sua incerteza: cada leitura por si, o que todas as suas leituras compartilham, e onde ele está.</translation>
    </message>
    <message>
        <source>The distance has the figure a + b L, each angle its own; these are independent from reading to reading. Scale, zero, index, collimation, squareness, beam offset and refraction are shared by all readings.</source>
        <translation>A distância tem o número a + b L, cada ângulo o seu; estes são independentes de leitura a leitura. Escala, zero, índice, colimação, perpendicularidade, desvio do feixe e refração são compartilhados por todas as leituras.</translation>
    </message>
    <message>
        <source>Only a sensor that reads a distance and both angles can say by itself where a point is.</source>
        <translation>Só um sensor que lê uma distância e os dois ângulos pode dizer sozinho onde está um ponto.</translation>
    </message>
    <message>
        <source>Instruments of the project that measure the same points together. Points measured by the network keep what they share: the scale and the station of each instrument.</source>
        <translation>Instrumentos do projeto que medem juntos os mesmos pontos. Pontos medidos pela rede mantêm o que compartilham: a escala e a estação de cada instrumento.</translation>
    </message>
    <message>
        <source>A point&apos;s deviations are the least-squares gain times those of the readings and stations, linearised at the point: exact to first order, and in Monte Carlo as long as the angles&apos; deviations stay below about a milliradian.</source>
        <translation>Os desvios de um ponto são o ganho de mínimos quadrados vezes os das leituras e estações, linearizado no ponto: exato em primeira ordem, e em Monte Carlo enquanto os desvios dos ângulos ficarem abaixo de cerca de um milirradiano.</translation>
    </message>
    <message>
        <source>All points that an analysis takes from the network are measured from one set-up: none of its instruments is moved or located anew between them.</source>
        <translation>Todos os pontos que uma análise toma da rede são medidos de um só estacionamento: nenhum de seus instrumentos é movido ou localizado de novo entre eles.</translation>
    </message>
    <message>
        <source>A sensor contributes to a point that is in its range and field of view, and no others.</source>
        <translation>Um sensor contribui para um ponto que está em seu alcance e campo de visão, e para nenhum outro.</translation>
    </message>
    <message>
        <source>One figure of a data sheet for all coordinates: a standard uncertainty or a maximum permissible error.</source>
        <translation>Um número de uma folha de dados para todas as coordenadas: uma incerteza-padrão ou um erro máximo permitido.</translation>
    </message>
    <message>
        <source>A specification taken alike in all directions overestimates, by a factor of 2 to 5 in the paper&apos;s example; an instrument that stands somewhere (spherical instrument) is closer to the truth.</source>
        <translation>Uma especificação tomada igual em todas as direções superestima, por um fator de 2 a 5 no exemplo do artigo; um instrumento que está em algum lugar (instrumento esférico) está mais perto da verdade.</translation>
    </message>
    <message>
        <source>Three or more telescopic ballbars that measure the lengths from their supports to one ball at once, and with it where the ball is.</source>
        <translation>Três ou mais ballbars telescópicas que medem ao mesmo tempo os comprimentos de seus apoios a uma esfera, e com isso onde está a esfera.</translation>
    </message>
    <message>
        <source>The supports&apos; frame follows from the lengths between them (Eqs 4 to 7), measured once: their deviations are common to all points.</source>
        <translation>O sistema dos apoios decorre dos comprimentos entre eles (eqs. 4 a 7), medidos uma vez: seus desvios são comuns a todos os pontos.</translation>
    </message>
    <message>
        <source>Eq 2 as printed has Y_VC3; Y_KS3 is meant. Eq 3 has two roots; the side is a choice here.</source>
        <translation>A eq. 2 como impressa tem Y_VC3; quer-se dizer Y_KS3. A eq. 3 tem duas raízes; o lado é uma escolha aqui.</translation>
    </message>
    <message>
        <source>The paper&apos;s supports are called an equilateral triangle of 520 mm; its Table 1 is isosceles, 520 mm and 519.711 mm.</source>
        <translation>Os apoios do artigo são chamados de triângulo equilátero de 520 mm; sua Tabela 1 é isósceles, 520 mm e 519,711 mm.</translation>
    </message>
    <message>
        <source>A fourth support and those after it are located by their lengths to the first three at a height that is an input of its own: lengths say nothing about a height above the plane in which all supports lie.</source>
        <translation>Um quarto apoio e os seguintes são localizados por seus comprimentos aos três primeiros a uma altura que é uma entrada própria: os comprimentos nada dizem sobre uma altura acima do plano em que estão todos os apoios.</translation>
    </message>
    <message>
        <source>A robot as a source of uncertainty: each time it goes to a pose it misses it by a distance in a random direction, and perhaps by small rotations.</source>
        <translation>Um robô como fonte de incerteza: cada vez que vai a uma pose erra-a por uma distância numa direção aleatória, e talvez por pequenas rotações.</translation>
    </message>
    <message>
        <source>The paper takes the distance as rectangular in [0, r], r being the data sheet&apos;s ± 0.02 mm; u along an axis is then r/3. RP of ISO 9283 is the mean distance plus three standard deviations, which is another figure: for that law RP = 1.366 r, in a ball 1.331 r, on a sphere r, and 3.616 u for normal coordinates.</source>
        <translation>O artigo toma a distância como retangular em [0, r], sendo r os ± 0,02 mm da folha de dados; u ao longo de um eixo é então r/3. RP da ISO 9283 é a distância média mais três desvios-padrão, que é outro número: para essa lei RP = 1,366 r, numa bola 1,331 r, numa esfera r, e 3,616 u para coordenadas normais.</translation>
    </message>
    <message>
        <source>The paper leaves the orientation out. A rotation by e moves the tool by about e times its length.</source>
        <translation>O artigo deixa de fora a orientação. Uma rotação de e move a ferramenta cerca de e vezes seu comprimento.</translation>
    </message>
    <message>
        <source>An arm of joints that turn or slide: parameters in a Denavit-Hartenberg convention with one or more components of uncertainty each, their correlation, limits, encoders, base and tool.</source>
        <translation>Um braço de juntas que giram ou deslizam: parâmetros numa convenção de Denavit-Hartenberg com uma ou mais componentes de incerteza cada um, sua correlação, limites, encoders, base e ferramenta.</translation>
    </message>
    <message>
        <source>Eq. 5: T = Rz(theta) Tz(d) Tx(a) Rx(alpha) Ry(beta). Where an axis is parallel to the next, beta is a parameter and d is 0 by definition; elsewhere beta is 0.</source>
        <translation>Eq. 5: T = Rz(theta) Tz(d) Tx(a) Rx(alpha) Ry(beta). Onde um eixo é paralelo ao seguinte, beta é um parâmetro e d é 0 por definição; nos demais casos beta é 0.</translation>
    </message>
    <message>
        <source>alpha and beta of a row turn the axis of the joint into that of the next (the paper&apos;s text shifts them by one joint).</source>
        <translation>alpha e beta de uma linha giram o eixo da junta para o da seguinte (o texto do artigo os desloca de uma junta).</translation>
    </message>
    <message>
        <source>The joint angle is theta plus the reading less the zero reading; a sliding joint adds its reading to d in the same way.</source>
        <translation>O ângulo da junta é theta mais a leitura menos a leitura de zero; uma junta deslizante soma sua leitura a d do mesmo modo.</translation>
    </message>
    <message>
        <source>Loads a multi-axis force/moment sensor with one force or moment at a time.</source>
        <translation>Carrega um sensor multieixo de força e momento com uma força ou um momento de cada vez.</translation>
    </message>
    <message>
        <source>The uncertainty of a load is common to all readings under loads on that axis: it does not average out in the calibration matrix.</source>
        <translation>A incerteza de uma carga é comum a todas as leituras sob cargas nesse eixo: não se anula na média na matriz de calibração.</translation>
    </message>
    <message>
        <source>Up to three forces and three moments measured at once; calibrated with one load at a time, evaluated from its readings.</source>
        <translation>Até três forças e três momentos medidos ao mesmo tempo; calibrado com uma carga de cada vez, avaliado a partir de suas leituras.</translation>
    </message>
    <message>
        <source>Tables 1 to 4 reproduce from raw readings that are consistent with them, to the printed digits, with relative uncertainties of the machine of 8.6e-4, 8.7e-4, 1.2e-5, 8.7e-4, 8.6e-4 and 1.7e-3.</source>
        <translation>As Tabelas 1 a 4 se reproduzem de leituras brutas coerentes com elas, até os dígitos impressos, com incertezas relativas da máquina de 8,6e-4, 8,7e-4, 1,2e-5, 8,7e-4, 8,6e-4 e 1,7e-3.</translation>
    </message>
    <message>
        <source>Type B, Table 3: differs for five of six sensors, because the stated uncertainties of the machine (2.1e-4, 1.8e-4, 1.2e-5, 3.1e-4, 2.9e-4, 2.4e-4) give 0.16, 0.23, 0.28, 0.31, 0.30, 0.36 µV/V and not 0.27, 0.31, 0.28, 0.41, 0.40, 0.62. The list equals the Type A column in five places: most likely copied there.</source>
        <translation>Tipo B, Tabela 3: difere para cinco de seis sensores, porque as incertezas declaradas da máquina (2,1e-4, 1,8e-4, 1,2e-5, 3,1e-4, 2,9e-4, 2,4e-4) dão 0,16, 0,23, 0,28, 0,31, 0,30, 0,36 µV/V e não 0,27, 0,31, 0,28, 0,41, 0,40, 0,62. A lista é igual à coluna do Tipo A em cinco lugares: muito provavelmente copiada de lá.</translation>
    </message>
    <message>
        <source>Table 4, Mx under Fy: differs, printed 1.55 %, is 0.15 %; the largest for Mx is 1.38 %, and the difference to its U 0.30 %, not 0.13 %.</source>
        <translation>Tabela 4, Mx sob Fy: difere, impresso 1,55 %, é 0,15 %; o maior para Mx é 1,38 %, e a diferença para seu U 0,30 %, não 0,13 %.</translation>
    </message>
    <message>
        <source>Section 2.5 calls e_12 the output of Fy under Fx, but Table 4 divides by the rated output of the row: a row is taken as a sensor.</source>
        <translation>A seção 2.5 chama e_12 a saída de Fy sob Fx, mas a Tabela 4 divide pela saída nominal da linha: uma linha é tomada como um sensor.</translation>
    </message>
    <message>
        <source>Eq 12 adds hysteresis and interference, limits that are not standard uncertainties, to an expanded uncertainty: the sum is neither a standard uncertainty nor a coverage interval.</source>
        <translation>A eq. 12 soma histerese e interferência, limites que não são incertezas-padrão, a uma incerteza expandida: a soma não é incerteza-padrão nem intervalo de abrangência.</translation>
    </message>
    <message>
        <source>The largest values of Type A and Type B need not occur at the same step. Eq 5 takes the rated output at every step. In 2.1.1 &quot;h=2&quot; of My and Mz is a slip.</source>
        <translation>Os maiores valores do Tipo A e do Tipo B não precisam ocorrer no mesmo degrau. A eq. 5 toma a saída nominal em cada degrau. Em 2.1.1 &quot;h=2&quot; de My e Mz é um lapso.</translation>
    </message>
    <message>
        <source>A surface from an STL file - the robot cell, the part, the fixture, the room - that is drawn in the scenes of all analyses. It is context only: no number depends on it.</source>
        <translation>Uma superfície de um arquivo STL - a célula do robô, a peça, o dispositivo, a sala - que é desenhada nas cenas de todas as análises. É só contexto: nenhum número depende dela.</translation>
    </message>
    <message>
        <source>The picture is fitted to what is measured, not to the mesh, which may be a whole hall.</source>
        <translation>A figura é ajustada ao que se mede, não à malha, que pode ser um galpão inteiro.</translation>
    </message>
    <message>
        <source>A file that is missing or damaged is warned of; analyses keep their results.</source>
        <translation>Um arquivo que falta ou está danificado gera um aviso; as análises mantêm seus resultados.</translation>
    </message>
    <message>
        <source>Of the certificate and the report; what was typed stays as it is.</source>
        <translation>Do certificado e do relatório; o que foi digitado fica como está.</translation>
    </message>
    <message>
        <source>distributions of %1</source>
        <translation>distribuições de %1</translation>
    </message>
    <message>
        <source>and %1 more like these</source>
        <translation>e mais %1 como estes</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was not written: %2: %3</source>
        <translation>&apos;%1&apos; não foi gravado: %2: %3</translation>
    </message>
    <message>
        <source>it cannot be opened</source>
        <translation>não pode ser aberto</translation>
    </message>
    <message>
        <source>writing failed</source>
        <translation>a gravação falhou</translation>
    </message>
    <message>
        <source>closing failed</source>
        <translation>o fechamento falhou</translation>
    </message>
    <message>
        <source>a file cannot be created in its folder &apos;%1&apos;</source>
        <translation>não se pode criar um arquivo em sua pasta &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the permissions of the old file cannot be kept</source>
        <translation>as permissões do arquivo antigo não podem ser mantidas</translation>
    </message>
    <message>
        <source>flushing to the disk failed</source>
        <translation>a gravação no disco falhou</translation>
    </message>
    <message>
        <source>the new file cannot take its place</source>
        <translation>o arquivo novo não pode tomar seu lugar</translation>
    </message>
    <message>
        <source>a folder</source>
        <translation>uma pasta</translation>
    </message>
    <message>
        <source>a pipe</source>
        <translation>um pipe</translation>
    </message>
    <message>
        <source>a socket</source>
        <translation>um socket</translation>
    </message>
    <message>
        <source>a device</source>
        <translation>um dispositivo</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be read: %2</source>
        <translation>&apos;%1&apos; não pode ser lido: %2</translation>
    </message>
    <message>
        <source>it is %1, not a file</source>
        <translation>é %1, não um arquivo</translation>
    </message>
    <message>
        <source>it is not a file</source>
        <translation>não é um arquivo</translation>
    </message>
    <message>
        <source>it is too large: files of up to %1 MB are read, it has %2 MB</source>
        <translation>é grande demais: leem-se arquivos de até %1 MB, tem %2 MB</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>é uma pasta</translation>
    </message>
    <message>
        <source>unit &quot;%1&quot;: %2</source>
        <translation>unidade &quot;%1&quot;: %2</translation>
    </message>
    <message>
        <source>a parenthesis is closed that was not opened.</source>
        <translation>fecha-se um parêntese que não foi aberto.</translation>
    </message>
    <message>
        <source>write a product with &apos;*&apos; (&quot;N*m&quot;, &quot;W/(m*K)&quot;), not with a blank.</source>
        <translation>escreva um produto com &apos;*&apos; (&quot;N*m&quot;, &quot;W/(m*K)&quot;), não com um espaço.</translation>
    </message>
    <message>
        <source>a parenthesis is not closed.</source>
        <translation>um parêntese não é fechado.</translation>
    </message>
    <message>
        <source>the exponent must be a whole number between -9 and 9, not 0 (&quot;mm^2&quot;).</source>
        <translation>o expoente deve ser um número inteiro entre -9 e 9, diferente de 0 (&quot;mm^2&quot;).</translation>
    </message>
    <message>
        <source>the exponents are too large.</source>
        <translation>os expoentes são grandes demais.</translation>
    </message>
    <message>
        <source>a unit is missing beside &apos;*&apos;, &apos;/&apos; or a parenthesis.</source>
        <translation>falta uma unidade ao lado de &apos;*&apos;, &apos;/&apos; ou de um parêntese.</translation>
    </message>
    <message>
        <source>numbers other than 1 do not belong in a unit; put them into the value.</source>
        <translation>números diferentes de 1 não cabem numa unidade; coloque-os no valor.</translation>
    </message>
    <message>
        <source>the unit &quot;%1&quot; is not known.%2</source>
        <translation>a unidade &quot;%1&quot; não é conhecida.%2</translation>
    </message>
    <message>
        <source>the text is too long for a unit.</source>
        <translation>o texto é longo demais para uma unidade.</translation>
    </message>
    <message>
        <source>the unit is empty: write &quot;1&quot; for a pure number.</source>
        <translation>a unidade está vazia: escreva &quot;1&quot; para um número puro.</translation>
    </message>
    <message>
        <source> Known units, most of them with the prefixes of the SI: %1.</source>
        <translation> Unidades conhecidas, a maioria com os prefixos do SI: %1.</translation>
    </message>
    <message>
        <source> Did you mean %1?</source>
        <translation> Quis dizer %1?</translation>
    </message>
    <message>
        <source> Did you mean %1 or %2?</source>
        <translation> Quis dizer %1 ou %2?</translation>
    </message>
    <message>
        <source>the attached file &apos;%1&apos; is broken</source>
        <translation>o arquivo anexo &apos;%1&apos; está danificado</translation>
    </message>
    <message>
        <source>the coverage probability must lie between 0 and 1.</source>
        <translation>a probabilidade de abrangência deve estar entre 0 e 1.</translation>
    </message>
    <message>
        <source>the effective degrees of freedom must be greater than 0.</source>
        <translation>os graus de liberdade efetivos devem ser maiores que 0.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is defined by itself here, directly or through other definitions; an equation that is to be solved is written &apos;solve %1 = 1: ... = ...&apos;, with a starting value</source>
        <translation>&apos;%1&apos; é definido aqui por si mesmo, diretamente ou por outras definições; uma equação a ser resolvida escreve-se &apos;solve %1 = 1: ... = ...&apos;, com um valor inicial</translation>
    </message>
    <message>
        <source>the expression in columns %1-%2</source>
        <translation>a expressão nas colunas %1-%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither defined nor one of the quantities: give it a row in the table of quantities</source>
        <translation>&apos;%1&apos; não é definido nem é uma das grandezas: dê-lhe uma linha na tabela de grandezas</translation>
    </message>
    <message>
        <source>%1 is a difference of temperatures: its unit is K, not %2</source>
        <translation>%1 é uma diferença de temperaturas: sua unidade é K, não %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; would be a condition: a definition must give a number</source>
        <translation>&apos;%1&apos; seria uma condição: uma definição deve dar um número</translation>
    </message>
    <message>
        <source>%1 is %2, %3 is %4: they cannot be equal</source>
        <translation>%1 é %2, %3 é %4: não podem ser iguais</translation>
    </message>
    <message>
        <source>the equations do not depend on the unknown &apos;%1&apos;</source>
        <translation>as equações não dependem da incógnita &apos;%1&apos;</translation>
    </message>
    <message>
        <source>this equation does not depend on any unknown</source>
        <translation>esta equação não depende de nenhuma incógnita</translation>
    </message>
    <message>
        <source>this constant has no value (division by zero, or root of a negative number)</source>
        <translation>esta constante não tem valor (divisão por zero, ou raiz de um número negativo)</translation>
    </message>
    <message>
        <source>no equation defines &apos;%1&apos;</source>
        <translation>nenhuma equação define &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is to be given in %2, but is %3</source>
        <translation>&apos;%1&apos; deve ser dado em %2, mas é %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is %2, which has no unit of its own</source>
        <translation>&apos;%1&apos; é %2, que não tem unidade própria</translation>
    </message>
    <message>
        <source>%1 is %2, %3 is %4</source>
        <translation>%1 é %2, %3 é %4</translation>
    </message>
    <message>
        <source>they cannot be added</source>
        <translation>não podem ser somados</translation>
    </message>
    <message>
        <source>they cannot be subtracted</source>
        <translation>não podem ser subtraídos</translation>
    </message>
    <message>
        <source>%1 is %2: %3</source>
        <translation>%1 é %2: %3</translation>
    </message>
    <message>
        <source>the exponent %1 is %2: an exponent must be a pure number</source>
        <translation>o expoente %1 é %2: um expoente deve ser um número puro</translation>
    </message>
    <message>
        <source>%1 is %2: its exponent must be a constant, or the dimension would vary</source>
        <translation>%1 é %2: seu expoente deve ser uma constante, ou a dimensão variaria</translation>
    </message>
    <message>
        <source>atan2 needs two quantities of one kind</source>
        <translation>atan2 precisa de duas grandezas da mesma espécie</translation>
    </message>
    <message>
        <source>a function of both needs quantities of one kind</source>
        <translation>uma função de ambas precisa de grandezas da mesma espécie</translation>
    </message>
    <message>
        <source>sin, cos and tan need an angle or a pure number</source>
        <translation>sin, cos e tan precisam de um ângulo ou de um número puro</translation>
    </message>
    <message>
        <source>an inverse function of an angle needs a pure number</source>
        <translation>uma função inversa de um ângulo precisa de um número puro</translation>
    </message>
    <message>
        <source>this function needs a pure number: divide by a quantity of the same kind</source>
        <translation>esta função precisa de um número puro: divida por uma grandeza da mesma espécie</translation>
    </message>
    <message>
        <source>they cannot be compared</source>
        <translation>não podem ser comparados</translation>
    </message>
    <message>
        <source>%1 is not a condition: write a comparison, as in x &gt; 0</source>
        <translation>%1 não é uma condição: escreva uma comparação, como em x &gt; 0</translation>
    </message>
    <message>
        <source>a condition</source>
        <translation>uma condição</translation>
    </message>
    <message>
        <source>a pure number</source>
        <translation>um número puro</translation>
    </message>
    <message>
        <source>measured in %1</source>
        <translation>medido em %1</translation>
    </message>
    <message>
        <source>%1 is a temperature in degC, %2 a difference of temperatures: give differences in K</source>
        <translation>%1 é uma temperatura em degC, %2 uma diferença de temperaturas: dê as diferenças em K</translation>
    </message>
    <message>
        <source>%1 is a temperature in degC, and 0 has no unit: write 0 [degC], or 0 [K] for absolute zero</source>
        <translation>%1 é uma temperatura em degC, e 0 não tem unidade: escreva 0 [degC], ou 0 [K] para o zero absoluto</translation>
    </message>
    <message>
        <source>%1 is a sum of temperatures in degC, which means nothing: give differences in K, or divide the sum by the number of temperatures for their mean</source>
        <translation>%1 é uma soma de temperaturas em degC, que nada significa: dê as diferenças em K, ou divida a soma pelo número de temperaturas para sua média</translation>
    </message>
    <message>
        <source>%1 is not a condition: write a comparison, as in if(x &gt; 0, x, 0)</source>
        <translation>%1 não é uma condição: escreva uma comparação, como em if(x &gt; 0, x, 0)</translation>
    </message>
    <message>
        <source>both values of &apos;if&apos; must be numbers, not conditions</source>
        <translation>ambos os valores de &apos;if&apos; devem ser números, não condições</translation>
    </message>
    <message>
        <source>both values of &apos;if&apos; must be of one kind</source>
        <translation>ambos os valores de &apos;if&apos; devem ser da mesma espécie</translation>
    </message>
    <message>
        <source>%1 is a condition: use it as the first argument of if(...)</source>
        <translation>%1 é uma condição: use-a como primeiro argumento de if(...)</translation>
    </message>
    <message>
        <source>the end of the equation</source>
        <translation>o fim da equação</translation>
    </message>
    <message>
        <source>%1 is not a function; to multiply, write &apos;*&apos;. Functions are: %2</source>
        <translation>%1 não é uma função; para multiplicar, escreva &apos;*&apos;. As funções são: %2</translation>
    </message>
    <message>
        <source>%1 needs %2 arguments; here it has %3</source>
        <translation>%1 precisa de %2 argumentos; aqui tem %3</translation>
    </message>
    <message>
        <source>%1 needs %2 to %3 arguments; here it has %4</source>
        <translation>%1 precisa de %2 a %3 argumentos; aqui tem %4</translation>
    </message>
    <message>
        <source>&apos;+&apos; stands here twice</source>
        <translation>&apos;+&apos; aparece aqui duas vezes</translation>
    </message>
    <message>
        <source>the expression is nested more than %1 levels deep: split it into definitions</source>
        <translation>a expressão tem mais de %1 níveis de aninhamento: divida-a em definições</translation>
    </message>
    <message>
        <source>a unit in brackets belongs behind a number: 20 [degC]</source>
        <translation>uma unidade entre colchetes fica depois de um número: 20 [degC]</translation>
    </message>
    <message>
        <source>a number, a name or a parenthesis is expected here, not %1</source>
        <translation>aqui se espera um número, um nome ou um parêntese, não %1</translation>
    </message>
    <message>
        <source>this parenthesis is not closed</source>
        <translation>este parêntese não está fechado</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a function: its argument follows in parentheses</source>
        <translation>&apos;%1&apos; é uma função: seu argumento segue entre parênteses</translation>
    </message>
    <message>
        <source>the word &apos;%1&apos; is not expected here</source>
        <translation>a palavra &apos;%1&apos; não é esperada aqui</translation>
    </message>
    <message>
        <source>an operator, a comma or &apos;)&apos; is expected here, not %1</source>
        <translation>aqui se espera um operador, uma vírgula ou &apos;)&apos;, não %1</translation>
    </message>
    <message>
        <source>this parenthesis closes nothing</source>
        <translation>este parêntese não fecha nada</translation>
    </message>
    <message>
        <source>an equation defines one name: write &apos;y = ...&apos;; to compare, write &apos;==&apos;; an equation that is to be solved starts with &apos;solve&apos;</source>
        <translation>uma equação define um nome: escreva &apos;y = ...&apos;; para comparar, escreva &apos;==&apos;; uma equação a ser resolvida começa com &apos;solve&apos;</translation>
    </message>
    <message>
        <source>an operator is missing before %1</source>
        <translation>falta um operador antes de %1</translation>
    </message>
    <message>
        <source>%1 is not expected here</source>
        <translation>%1 não é esperado aqui</translation>
    </message>
    <message>
        <source>an equation starts with the name that it defines: y = ...</source>
        <translation>uma equação começa com o nome que define: y = ...</translation>
    </message>
    <message>
        <source>a name with its starting value is expected here: y = 1</source>
        <translation>aqui se espera um nome com seu valor inicial: y = 1</translation>
    </message>
    <message>
        <source>a function</source>
        <translation>uma função</translation>
    </message>
    <message>
        <source>a word of the language</source>
        <translation>uma palavra da linguagem</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is %2: choose another name</source>
        <translation>&apos;%1&apos; é %2: escolha outro nome</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is defined twice</source>
        <translation>&apos;%1&apos; é definido duas vezes</translation>
    </message>
    <message>
        <source>a colon is expected before the equations to be solved: solve y = 1: y^2 = x</source>
        <translation>esperam-se dois-pontos antes das equações a serem resolvidas: solve y = 1: y^2 = x</translation>
    </message>
    <message>
        <source>%1 unknowns need as many equations; there are %2</source>
        <translation>%1 incógnitas precisam de outras tantas equações; há %2</translation>
    </message>
    <message>
        <source>an equals sign is expected in an equation to be solved</source>
        <translation>espera-se um sinal de igual numa equação a ser resolvida</translation>
    </message>
    <message>
        <source>line %1, column %2: </source>
        <translation>linha %1, coluna %2: </translation>
    </message>
    <message>
        <source>line %1, columns %2-%3: </source>
        <translation>linha %1, colunas %2-%3: </translation>
    </message>
    <message>
        <source>this number is too large or too small to compute with</source>
        <translation>este número é grande demais ou pequeno demais para calcular com ele</translation>
    </message>
    <message>
        <source>the bracket of a unit is not closed: write &apos;]&apos; behind the unit</source>
        <translation>o colchete de uma unidade não está fechado: escreva &apos;]&apos; depois da unidade</translation>
    </message>
    <message>
        <source>the character &apos;%1&apos; does not belong in an equation</source>
        <translation>o caractere &apos;%1&apos; não cabe numa equação</translation>
    </message>
    <message>
        <source>the equations have %1 characters; more than %2 are not read: put tables of data into assets or observations</source>
        <translation>as equações têm %1 caracteres; mais de %2 não são lidos: coloque tabelas de dados em recursos ou observações</translation>
    </message>
    <message>
        <source>the coverage factor k must be greater than zero</source>
        <translation>o fator de abrangência k deve ser maior que zero</translation>
    </message>
    <message>
        <source>the coverage probability must lie between 0 and 100 %</source>
        <translation>a probabilidade de abrangência deve estar entre 0 e 100 %</translation>
    </message>
    <message>
        <source>the limits give the estimate: leave the value empty, or state a half-width</source>
        <translation>os limites dão a estimativa: deixe o valor vazio, ou declare uma meia-largura</translation>
    </message>
    <message>
        <source>the lower limit is above the upper limit</source>
        <translation>o limite inferior está acima do superior</translation>
    </message>
    <message>
        <source>a relative part of the permissible error needs the value of the quantity</source>
        <translation>uma parte relativa do erro permitido precisa do valor da grandeza</translation>
    </message>
    <message>
        <source>an exponential distribution needs an estimate greater than zero</source>
        <translation>uma distribuição exponencial precisa de uma estimativa maior que zero</translation>
    </message>
    <message>
        <source>the number of counts must be whole</source>
        <translation>o número de contagens deve ser inteiro</translation>
    </message>
    <message>
        <source>the counts give the estimate: leave the value empty</source>
        <translation>as contagens dão a estimativa: deixe o valor vazio</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not used by this statement: leave it empty</source>
        <translation>&apos;%1&apos; não é usado por esta declaração: deixe vazio</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is missing: %2</source>
        <translation>falta &apos;%1&apos;: %2</translation>
    </message>
    <message>
        <source>&apos;a&apos; must not be negative</source>
        <translation>&apos;a&apos; não deve ser negativo</translation>
    </message>
    <message>
        <source>give the degrees of freedom or the relative uncertainty of u, not both</source>
        <translation>dê os graus de liberdade ou a incerteza relativa de u, não ambos</translation>
    </message>
    <message>
        <source>the degrees of freedom must be greater than zero</source>
        <translation>os graus de liberdade devem ser maiores que zero</translation>
    </message>
    <message>
        <source>the relative uncertainty of u must not be negative</source>
        <translation>a incerteza relativa de u não deve ser negativa</translation>
    </message>
    <message>
        <source>there is no statement &apos;%1&apos;</source>
        <translation>não há declaração &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not understood here</source>
        <translation>&apos;%1&apos; não é entendido aqui</translation>
    </message>
    <message>
        <source>a number is missing after &apos;%1&apos;</source>
        <translation>falta um número depois de &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no way to state an uncertainty. For example: 75 nm; U = 0.3 um, k = 2; rectangular 0.5; resolution 0.01; constant</source>
        <translation>&apos;%1&apos; não é uma forma de declarar uma incerteza. Por exemplo: 75 nm; U = 0,3 um, k = 2; retangular 0,5; resolução 0,01; constante</translation>
    </message>
    <message>
        <source>%1 has %2 figure</source>
        <translation>%1 tem %2 número</translation>
    </message>
    <message>
        <source>%1 has %2 figures</source>
        <translation>%1 tem %2 números</translation>
    </message>
    <message>
        <source>a figure is missing: an expanded uncertainty needs k = ... or p = ... %</source>
        <translation>falta um número: uma incerteza expandida precisa de k = ... ou p = ... %</translation>
    </message>
    <message>
        <source>a figure is missing: it is noted as %1</source>
        <translation>falta um número: é anotado como %1</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no part of it: it is noted as %2</source>
        <translation>&apos;%1&apos; não faz parte disso: é anotado como %2</translation>
    </message>
    <message>
        <source>it has no unit</source>
        <translation>não tem unidade</translation>
    </message>
    <message>
        <source>the second figure has no unit but %</source>
        <translation>o segundo número não tem unidade além de %</translation>
    </message>
    <message>
        <source>the second figure has no unit</source>
        <translation>o segundo número não tem unidade</translation>
    </message>
    <message>
        <source>the further part is one in %: write MPE 3 + 0.1 %</source>
        <translation>a outra parte é em %: escreva MPE 3 + 0.1 %</translation>
    </message>
    <message>
        <source>say which it is: k = ... or p = ... %</source>
        <translation>diga qual é: k = ... ou p = ... %</translation>
    </message>
    <message>
        <source>a part of the value needs the value</source>
        <translation>uma parte do valor precisa do valor</translation>
    </message>
    <message>
        <source>%1 is no unit for a quantity in %2</source>
        <translation>%1 não é unidade para uma grandeza em %2</translation>
    </message>
    <message>
        <source>a Type A evaluation needs at least two observations.</source>
        <translation>uma avaliação do Tipo A precisa de pelo menos duas observações.</translation>
    </message>
    <message>
        <source>one of the observations is not a finite number.</source>
        <translation>uma das observações não é um número finito.</translation>
    </message>
    <message>
        <source>there is no series to be pooled.</source>
        <translation>não há série a agrupar.</translation>
    </message>
    <message>
        <source>the covariance of two means needs observations made in pairs: the series have different lengths.</source>
        <translation>a covariância de duas médias precisa de observações feitas aos pares: as séries têm comprimentos diferentes.</translation>
    </message>
    <message>
        <source>the covariance of two means needs at least two pairs.</source>
        <translation>a covariância de duas médias precisa de pelo menos dois pares.</translation>
    </message>
    <message>
        <source>the components %1 and %2 are given two different correlations; a quantity that combines its components arithmetically needs +1 or -1.</source>
        <translation>são dadas duas correlações diferentes às componentes %1 e %2; uma grandeza que combina suas componentes aritmeticamente precisa de +1 ou -1.</translation>
    </message>
    <message>
        <source>a correlation refers to component number %1 of %2.</source>
        <translation>uma correlação refere-se à componente número %1 de %2.</translation>
    </message>
    <message>
        <source>a correlation is given between the component %1 and itself.</source>
        <translation>é dada uma correlação entre a componente %1 e ela mesma.</translation>
    </message>
    <message>
        <source>the correlation of the components %1 and %2 must lie between -1 and 1.</source>
        <translation>a correlação das componentes %1 e %2 deve estar entre -1 e 1.</translation>
    </message>
    <message>
        <source>the quantity &quot;%1&quot; refers to component number %2 of %3.</source>
        <translation>a grandeza &quot;%1&quot; refere-se à componente número %2 de %3.</translation>
    </message>
    <message>
        <source>the correlations of the components %1 contradict each other: the smallest eigenvalue of their correlation matrix is %2, it must not be negative.</source>
        <translation>as correlações das componentes %1 contradizem-se: o menor autovalor de sua matriz de correlação é %2, não deve ser negativo.</translation>
    </message>
    <message>
        <source>the component %1 is a coordinate of a vector of random direction and cannot be correlated with another component; give it a normal distribution first.</source>
        <translation>a componente %1 é uma coordenada de um vetor de direção aleatória e não pode ser correlacionada com outra componente; dê-lhe antes uma distribuição normal.</translation>
    </message>
    <message>
        <source>the estimate of variance &quot;%1&quot; has component number %2, which does not exist or rests on two estimates.</source>
        <translation>a estimativa de variância &quot;%1&quot; tem a componente número %2, que não existe ou se apoia em duas estimativas.</translation>
    </message>
    <message>
        <source>the component %1 rests on the estimate of variance &quot;%2&quot; with others: it needs a normal or Student t distribution and their finite degrees of freedom.</source>
        <translation>a componente %1 apoia-se com outras na estimativa de variância &quot;%2&quot;: precisa de uma distribuição normal ou t de Student e de seus graus de liberdade finitos.</translation>
    </message>
    <message>
        <source>the components %1 and %2 cannot have the correlation %3: with these distributions it lies between %4 and %5.</source>
        <translation>as componentes %1 e %2 não podem ter a correlação %3: com estas distribuições ela está entre %4 e %5.</translation>
    </message>
    <message>
        <source>%1 distribution: %2</source>
        <translation>distribuição %1: %2</translation>
    </message>
    <message>
        <source>the %1 must be a finite number.</source>
        <translation>%1: deve ser um número finito.</translation>
    </message>
    <message>
        <source>the %1 is too large (at most 1e150).</source>
        <translation>%1: é grande demais (no máximo 1e150).</translation>
    </message>
    <message>
        <source>the %1 must not be negative.</source>
        <translation>%1: não deve ser negativo.</translation>
    </message>
    <message>
        <source>the %1 must lie between 0.001 and 1000000.</source>
        <translation>%1: deve estar entre 0.001 e 1000000.</translation>
    </message>
    <message>
        <source>the lower limit must not be greater than the upper limit.</source>
        <translation>o limite inferior não deve ser maior que o superior.</translation>
    </message>
    <message>
        <source>the degrees of freedom must be at least 0.2 (they may be infinite).</source>
        <translation>os graus de liberdade devem ser pelo menos 0.2 (podem ser infinitos).</translation>
    </message>
    <message>
        <source>the inexactness of the limits must not exceed half the distance between them.</source>
        <translation>a inexatidão dos limites não deve exceder metade da distância entre eles.</translation>
    </message>
    <message>
        <source>the ratio beta of top to base must lie between 0 and 1.</source>
        <translation>a razão beta da base superior para a inferior deve estar entre 0 e 1.</translation>
    </message>
    <message>
        <source>one of the limits excludes every value.</source>
        <translation>um dos limites exclui todo valor.</translation>
    </message>
    <message>
        <source>the mean value lies outside the limits.</source>
        <translation>o valor médio está fora dos limites.</translation>
    </message>
    <message>
        <source>the limits lie so far from the mean value that no probability is left between them.</source>
        <translation>os limites estão tão longe do valor médio que não resta probabilidade entre eles.</translation>
    </message>
    <message>
        <source>mean value of the logarithm</source>
        <translation>valor médio do logaritmo</translation>
    </message>
    <message>
        <source>the parameters of the logarithm are too large: the quantity has no finite variance in numbers.</source>
        <translation>os parâmetros do logaritmo são grandes demais: a grandeza não tem variância finita em números.</translation>
    </message>
    <message>
        <source>a discrete distribution needs at least one value.</source>
        <translation>uma distribuição discreta precisa de pelo menos um valor.</translation>
    </message>
    <message>
        <source>there must be as many probabilities as values.</source>
        <translation>deve haver tantas probabilidades quantos valores.</translation>
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
        <translation>as probabilidades devem somar 1.</translation>
    </message>
    <message>
        <source>discrete distribution: there must be as many probabilities as values.</source>
        <translation>distribuição discreta: deve haver tantas probabilidades quantos valores.</translation>
    </message>
    <message>
        <source>%1 distribution: %2 parameters are needed, %3 are given.</source>
        <translation>distribuição %1: são necessários %2 parâmetros, são dados %3.</translation>
    </message>
    <message>
        <source>the distribution &quot;%1&quot; is not known. Known distributions: %2.</source>
        <translation>a distribuição &quot;%1&quot; não é conhecida. Distribuições conhecidas: %2.</translation>
    </message>
    <message>
        <source>%1 in row %2 of %3</source>
        <translation>%1 na linha %2 de %3</translation>
    </message>
    <message>
        <source>greater than %1 and at most %2</source>
        <translation>maior que %1 e no máximo %2</translation>
    </message>
    <message>
        <source>between %1 and %2</source>
        <translation>entre %1 e %2</translation>
    </message>
    <message>
        <source>greater than %1</source>
        <translation>maior que %1</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>pelo menos %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>no máximo %1</translation>
    </message>
    <message>
        <source>%1 must be a whole number; it is %2</source>
        <translation>%1 deve ser um número inteiro; é %2</translation>
    </message>
    <message>
        <source>%1 is too large a number: %2</source>
        <translation>%1 é um número grande demais: %2</translation>
    </message>
    <message>
        <source>%1 must be %2; it is %3</source>
        <translation>%1 deve ser %2; é %3</translation>
    </message>
    <message>
        <source>%1 must be one of %2; it is %3%4</source>
        <translation>%1 deve ser um de %2; é %3%4</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>um número</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>um número inteiro</translation>
    </message>
    <message>
        <source>one of its choices</source>
        <translation>uma de suas opções</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>um texto</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true ou false</translation>
    </message>
    <message>
        <source>a pose</source>
        <translation>uma pose</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>uma tabela</translation>
    </message>
    <message>
        <source>the id of an asset</source>
        <translation>o id de um recurso</translation>
    </message>
    <message>
        <source>%1 must be %2</source>
        <translation>%1 deve ser %2</translation>
    </message>
    <message>
        <source>%1 needs at least 1 row; it has %2</source>
        <translation>%1 precisa de pelo menos 1 linha; tem %2</translation>
    </message>
    <message>
        <source>%1 needs at least %2 rows; it has %3</source>
        <translation>%1 precisa de pelo menos %2 linhas; tem %3</translation>
    </message>
    <message>
        <source>%1 has %2 columns, but %3 units</source>
        <translation>%1 tem %2 colunas, mas %3 unidades</translation>
    </message>
    <message>
        <source>row %1 of %2 has %3 cells; there are %4 columns</source>
        <translation>a linha %1 de %2 tem %3 células; há %4 colunas</translation>
    </message>
    <message>
        <source>%1 is empty</source>
        <translation>%1 está vazio</translation>
    </message>
    <message>
        <source>%1 must not be empty</source>
        <translation>%1 não deve estar vazio</translation>
    </message>
    <message>
        <source>%1 must be given (&apos;%2&apos; is missing)</source>
        <translation>%1 deve ser dado (falta &apos;%2&apos;)</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; is %3; &apos;%4&apos; is the unit of %5</source>
        <translation>a coluna &apos;%1&apos; de &apos;%2&apos; é %3; &apos;%4&apos; é a unidade de %5</translation>
    </message>
    <message>
        <source>there is no field &apos;%1&apos; here%2</source>
        <translation>aqui não há campo &apos;%1&apos;%2</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>um comprimento</translation>
    </message>
    <message>
        <source>an area</source>
        <translation>uma área</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>um volume</translation>
    </message>
    <message>
        <source>a mass</source>
        <translation>uma massa</translation>
    </message>
    <message>
        <source>a time</source>
        <translation>um tempo</translation>
    </message>
    <message>
        <source>a frequency</source>
        <translation>uma frequência</translation>
    </message>
    <message>
        <source>an electric current</source>
        <translation>uma corrente elétrica</translation>
    </message>
    <message>
        <source>a temperature</source>
        <translation>uma temperatura</translation>
    </message>
    <message>
        <source>an expansion coefficient</source>
        <translation>um coeficiente de dilatação</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>um ângulo</translation>
    </message>
    <message>
        <source>a velocity</source>
        <translation>uma velocidade</translation>
    </message>
    <message>
        <source>an acceleration</source>
        <translation>uma aceleração</translation>
    </message>
    <message>
        <source>a force</source>
        <translation>uma força</translation>
    </message>
    <message>
        <source>a moment</source>
        <translation>um momento</translation>
    </message>
    <message>
        <source>a pressure</source>
        <translation>uma pressão</translation>
    </message>
    <message>
        <source>a stiffness</source>
        <translation>uma rigidez</translation>
    </message>
    <message>
        <source>a voltage</source>
        <translation>uma tensão elétrica</translation>
    </message>
    <message>
        <source>an electric resistance</source>
        <translation>uma resistência elétrica</translation>
    </message>
    <message>
        <source>an electric charge</source>
        <translation>uma carga elétrica</translation>
    </message>
    <message>
        <source>a capacitance</source>
        <translation>uma capacitância</translation>
    </message>
    <message>
        <source>an inductance</source>
        <translation>uma indutância</translation>
    </message>
    <message>
        <source>a magnetic flux density</source>
        <translation>uma densidade de fluxo magnético</translation>
    </message>
    <message>
        <source>a magnetic flux</source>
        <translation>um fluxo magnético</translation>
    </message>
    <message>
        <source>a power</source>
        <translation>uma potência</translation>
    </message>
    <message>
        <source>an amount of substance</source>
        <translation>uma quantidade de substância</translation>
    </message>
    <message>
        <source>a luminous intensity</source>
        <translation>uma intensidade luminosa</translation>
    </message>
    <message>
        <source>an angular velocity</source>
        <translation>uma velocidade angular</translation>
    </message>
    <message>
        <source>a density</source>
        <translation>uma densidade</translation>
    </message>
    <message>
        <source> (did you mean &apos;%1&apos;?)</source>
        <translation> (quis dizer &apos;%1&apos;?)</translation>
    </message>
    <message>
        <source>%1 must be a finite number; it is %2</source>
        <translation>%1 deve ser um número finito; é %2</translation>
    </message>
    <message>
        <source>%1 is too large to be computed with (at most 1e100): it is %2</source>
        <translation>%1 é grande demais para calcular com ele (no máximo 1e100): é %2</translation>
    </message>
    <message>
        <source>%1 is %2; %3 has no unit</source>
        <translation>%1 é %2; %3 não tem unidade</translation>
    </message>
    <message>
        <source>%1 is %2; %3 is %4</source>
        <translation>%1 é %2; %3 é %4</translation>
    </message>
    <message>
        <source>the result does not represent the measurand: more than 1 % of the trials have no value</source>
        <translation>o resultado não representa o mensurando: mais de 1 % dos ensaios não têm valor</translation>
    </message>
    <message>
        <source>U = k u with the coverage factor that was fixed.</source>
        <translation>U = k u com o fator de abrangência que foi fixado.</translation>
    </message>
    <message>
        <source>U is half the width of the probabilistically symmetric coverage interval, and k = U/u.</source>
        <translation>U é metade da largura do intervalo de abrangência probabilisticamente simétrico, e k = U/u.</translation>
    </message>
    <message>
        <source>U = k u with k of the t distribution for the effective degrees of freedom.</source>
        <translation>U = k u com k da distribuição t para os graus de liberdade efetivos.</translation>
    </message>
    <message>
        <source>the number of significant digits of the numerical tolerance must be 1, 2, 3 or 4</source>
        <translation>o número de algarismos significativos da tolerância numérica deve ser 1, 2, 3 ou 4</translation>
    </message>
    <message>
        <source>the numerical tolerance must be greater than zero</source>
        <translation>a tolerância numérica deve ser maior que zero</translation>
    </message>
    <message>
        <source>the adaptive procedure needs at least two batches</source>
        <translation>o procedimento adaptativo precisa de pelo menos dois lotes</translation>
    </message>
    <message>
        <source>the adaptive procedure needs at least two batches: allow %1 trials or more</source>
        <translation>o procedimento adaptativo precisa de pelo menos dois lotes: permita %1 ensaios ou mais</translation>
    </message>
    <message>
        <source>a Monte Carlo run needs at least two trials</source>
        <translation>uma execução de Monte Carlo precisa de pelo menos dois ensaios</translation>
    </message>
    <message>
        <source>the coverage probability must lie between 0 and 1</source>
        <translation>a probabilidade de abrangência deve estar entre 0 e 1</translation>
    </message>
    <message>
        <source>the coverage probability is too near to 1</source>
        <translation>a probabilidade de abrangência está próxima demais de 1</translation>
    </message>
    <message>
        <source>the coverage factor must be greater than zero</source>
        <translation>o fator de abrangência deve ser maior que zero</translation>
    </message>
    <message>
        <source>one-at-a-time Monte Carlo needs at least two trials</source>
        <translation>Monte Carlo de um em um precisa de pelo menos dois ensaios</translation>
    </message>
    <message>
        <source>Monte Carlo without a contributor needs at least two trials</source>
        <translation>Monte Carlo sem uma contribuição precisa de pelo menos dois ensaios</translation>
    </message>
    <message>
        <source>Sobol indices need at least 100 trials</source>
        <translation>os índices de Sobol precisam de pelo menos 100 ensaios</translation>
    </message>
    <message>
        <source>the evaluation was stopped</source>
        <translation>a avaliação foi interrompida</translation>
    </message>
    <message>
        <source>none of the trials has a value: the measurement model cannot be evaluated within the uncertainties of its inputs; check the standard uncertainties and the geometry</source>
        <translation>nenhum dos ensaios tem valor: o modelo de medição não pode ser avaliado dentro das incertezas de suas entradas; confira as incertezas-padrão e a geometria</translation>
    </message>
    <message>
        <source>the linear part explains %1 % of the variance: a gain of %2</source>
        <translation>a parte linear explica %1 % da variância: um ganho de %2</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>no trial has a value</source>
        <translation>nenhum ensaio tem valor</translation>
    </message>
    <message>
        <source>the measurement model has no sensitivity coefficients near the estimates: second-order terms do not exist</source>
        <translation>o modelo de medição não tem coeficientes de sensibilidade perto das estimativas: termos de segunda ordem não existem</translation>
    </message>
    <message>
        <source>there are too many quantities for them</source>
        <translation>há grandezas demais para eles</translation>
    </message>
    <message>
        <source>the degrees of freedom of %1 must be greater than zero</source>
        <translation>os graus de liberdade de %1 devem ser maiores que zero</translation>
    </message>
    <message>
        <source>the degrees of freedom of %1 are too few: there must be at least 0.2</source>
        <translation>os graus de liberdade de %1 são poucos demais: deve haver pelo menos 0,2</translation>
    </message>
    <message>
        <source>the distribution of %1 has no finite mean or standard uncertainty</source>
        <translation>a distribuição de %1 não tem média ou incerteza-padrão finita</translation>
    </message>
    <message>
        <source>the estimate of %1 is not a finite number</source>
        <translation>a estimativa de %1 não é um número finito</translation>
    </message>
    <message>
        <source>quantity %1 refers to a component that does not exist, or with a factor that is not finite</source>
        <translation>a grandeza %1 refere-se a uma componente que não existe, ou com um fator que não é finito</translation>
    </message>
    <message>
        <source>the measurement model has %1 input quantities, but %2 were given</source>
        <translation>o modelo de medição tem %1 grandezas de entrada, mas foram dadas %2</translation>
    </message>
    <message>
        <source>the measurement model has no output quantities</source>
        <translation>o modelo de medição não tem grandezas de saída</translation>
    </message>
    <message>
        <source>its correlated components are not normally distributed</source>
        <translation>suas componentes correlacionadas não têm distribuição normal</translation>
    </message>
    <message>
        <source>no spread</source>
        <translation>sem dispersão</translation>
    </message>
    <message>
        <source>normal as far as so few trials can tell</source>
        <translation>normal até onde tão poucos ensaios podem dizer</translation>
    </message>
    <message>
        <source>normal within 1 %</source>
        <translation>normal dentro de 1 %</translation>
    </message>
    <message>
        <source>normal within 5 %</source>
        <translation>normal dentro de 5 %</translation>
    </message>
    <message>
        <source>too skewed for k u</source>
        <translation>assimétrica demais para k u</translation>
    </message>
    <message>
        <source>too heavy-tailed for k u</source>
        <translation>de caudas pesadas demais para k u</translation>
    </message>
    <message>
        <source>too flat for k u</source>
        <translation>achatada demais para k u</translation>
    </message>
    <message>
        <source>Second-order terms are left out: the formula of JCGM 100 5.1.2 assumes independent components, and some of these are correlated.</source>
        <translation>Omitem-se os termos de segunda ordem: a fórmula da JCGM 100 5.1.2 supõe componentes independentes, e algumas destas são correlacionadas.</translation>
    </message>
    <message>
        <source>Second-order terms are left out: %1.</source>
        <translation>Omitem-se os termos de segunda ordem: %1.</translation>
    </message>
    <message>
        <source>%1 of %2 trials (%3 %) have no value (the measurement model cannot be evaluated there) and are not part of the statistics.</source>
        <translation>%1 de %2 ensaios (%3 %) não têm valor (o modelo de medição não pode ser avaliado ali) e não fazem parte da estatística.</translation>
    </message>
    <message>
        <source>The result does not represent the measurand: more than 1 % of the trials are lost, and they are not a random choice.</source>
        <translation>O resultado não representa o mensurando: mais de 1 % dos ensaios se perdem, e não são uma escolha ao acaso.</translation>
    </message>
    <message>
        <source>The adaptive procedure stopped at %1 trials before its results were stable: allow more trials, or ask for fewer significant digits.</source>
        <translation>O procedimento adaptativo parou em %1 ensaios antes que seus resultados fossem estáveis: permita mais ensaios, ou peça menos algarismos significativos.</translation>
    </message>
    <message>
        <source>Coverage intervals are interpolated in fine cells: there are too many trials to keep the values of the tails in memory.</source>
        <translation>Os intervalos de abrangência são interpolados em células finas: há ensaios demais para manter na memória os valores das caudas.</translation>
    </message>
    <message>
        <source>The correlations stated cannot all hold with these distributions: the nearest that can are drawn, with coefficients that differ by up to %1.</source>
        <translation>As correlações declaradas não podem valer todas com estas distribuições: são sorteadas as mais próximas possíveis, com coeficientes que diferem em até %1.</translation>
    </message>
    <message>
        <source>The angle %1%2 is hardly determined: its standard uncertainty exceeds 1 rad.</source>
        <translation>O ângulo %1%2 mal é determinado: sua incerteza-padrão excede 1 rad.</translation>
    </message>
    <message>
        <source>Nothing is gained by variance reduction, and standard errors are not known: there are fewer than %1 batches of %2 trials.</source>
        <translation>Nada se ganha com a redução de variância, e erros-padrão não são conhecidos: há menos de %1 lotes de %2 ensaios.</translation>
    </message>
    <message>
        <source>Control variates are not used: the linear part of the trials that have a value has another distribution than that of all trials.</source>
        <translation>Não se usam variáveis de controle: a parte linear dos ensaios que têm valor tem outra distribuição que a de todos os ensaios.</translation>
    </message>
    <message>
        <source>Without control variate: %1.</source>
        <translation>Sem variável de controle: %1.</translation>
    </message>
    <message>
        <source>The standard uncertainty by Monte Carlo of %1 does not exist, because a Student t distribution with two degrees of freedom or fewer has no finite standard deviation: it is shown as infinite, and U is half the width of the coverage interval.</source>
        <translation>A incerteza-padrão por Monte Carlo de %1 não existe, porque uma distribuição t de Student com dois graus de liberdade ou menos não tem desvio-padrão finito: é mostrada como infinita, e U é metade da largura do intervalo de abrangência.</translation>
    </message>
    <message>
        <source>The standard uncertainty by Monte Carlo of %1 cannot stabilise, because Student t distributions with four degrees of freedom or fewer have no finite fourth moment: the adaptive procedure judges by the coverage intervals; use these.</source>
        <translation>A incerteza-padrão por Monte Carlo de %1 não pode estabilizar-se, porque distribuições t de Student com quatro graus de liberdade ou menos não têm quarto momento finito: o procedimento adaptativo julga pelos intervalos de abrangência; use estes.</translation>
    </message>
    <message>
        <source>the measurement model has no value at the estimates of its input quantities%1: check the nominal geometry and the values entered</source>
        <translation>o modelo de medição não tem valor nas estimativas de suas grandezas de entrada%1: confira a geometria nominal e os valores digitados</translation>
    </message>
    <message>
        <source>Effective degrees of freedom are approximate: the Welch-Satterthwaite formula assumes independent components, and correlated components with finite degrees of freedom contribute. The Monte Carlo coverage interval is the better guide.</source>
        <translation>Os graus de liberdade efetivos são aproximados: a fórmula de Welch-Satterthwaite supõe componentes independentes, e componentes correlacionadas com graus de liberdade finitos contribuem. O intervalo de abrangência de Monte Carlo é o melhor guia.</translation>
    </message>
    <message>
        <source>1 vector of random direction has coordinates with different distributions after editing: they are drawn independently.</source>
        <translation>1 vetor de direção aleatória tem coordenadas com distribuições diferentes após a edição: são sorteadas independentemente.</translation>
    </message>
    <message>
        <source>%1 vectors of random direction have coordinates with different distributions after editing: they are drawn independently.</source>
        <translation>%1 vetores de direção aleatória têm coordenadas com distribuições diferentes após a edição: são sorteados independentemente.</translation>
    </message>
    <message>
        <source>The angle %1 is hardly determined: its standard uncertainty by the law of propagation exceeds 1 rad.</source>
        <translation>O ângulo %1 mal é determinado: sua incerteza-padrão pela lei de propagação excede 1 rad.</translation>
    </message>
    <message>
        <source>a tolerance of %1 %2 for %3 (u = %4 %2) needs about %5 trials (%6 batches)</source>
        <translation>uma tolerância de %1 %2 para %3 (u = %4 %2) precisa de cerca de %5 ensaios (%6 lotes)</translation>
    </message>
    <message>
        <source>to correct the bias of coordinate %1, give the number of observations n in its row: the uncertainty of the correction is u_var/sqrt(n)</source>
        <translation>para corrigir a tendência da coordenada %1, dê em sua linha o número de observações n: a incerteza da correção é u_var/sqrt(n)</translation>
    </message>
    <message>
        <source>there are two points called &apos;%1&apos;; rename one</source>
        <translation>há dois pontos chamados &apos;%1&apos;; renomeie um</translation>
    </message>
    <message>
        <source>there is no calibrated point called &apos;%1&apos;</source>
        <translation>não há ponto calibrado chamado &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must consist of the letters x, y and z</source>
        <translation>&apos;%1&apos; deve ser formado pelas letras x, y e z</translation>
    </message>
    <message>
        <source>coordinate %1 has fewer than two observations that do not define the frame: measure more points or runs</source>
        <translation>a coordenada %1 tem menos de duas observações que não definem o sistema: meça mais pontos ou séries</translation>
    </message>
    <message>
        <source>coordinate %1 has %2 rows; it must have one</source>
        <translation>a coordenada %1 tem %2 linhas; deve ter uma</translation>
    </message>
    <message>
        <source>the length standard needs at least two observations</source>
        <translation>o padrão de comprimento precisa de pelo menos duas observações</translation>
    </message>
    <message>
        <source>the table must have one row; it has %1</source>
        <translation>a tabela deve ter uma linha; tem %1</translation>
    </message>
    <message>
        <source>the analysis has no point called &apos;%1&apos;</source>
        <translation>a análise não tem ponto chamado &apos;%1&apos;</translation>
    </message>
    <message>
        <source>point %1: %2</source>
        <translation>ponto %1: %2</translation>
    </message>
    <message>
        <source>it is at the place of the instrument</source>
        <translation>está no lugar do instrumento</translation>
    </message>
    <message>
        <source>it is out of the range or field of view of the instrument</source>
        <translation>está fora do alcance ou do campo de visão do instrumento</translation>
    </message>
    <message>
        <source>correlated coordinates of a station are combinations of independent deviations, which are normal: leave the distribution normal, or the correlation out</source>
        <translation>coordenadas correlacionadas de uma estação são combinações de desvios independentes, que são normais: deixe a distribuição normal, ou retire a correlação</translation>
    </message>
    <message>
        <source>a coordinate of the station is correlated with itself; name two different ones</source>
        <translation>uma coordenada da estação está correlacionada consigo mesma; nomeie duas diferentes</translation>
    </message>
    <message>
        <source>the range ends before it begins: the longest distance must be greater than the shortest</source>
        <translation>o alcance termina antes de começar: a maior distância deve ser maior que a menor</translation>
    </message>
    <message>
        <source>the sensor reads nothing: choose a distance or an angle</source>
        <translation>o sensor nada lê: escolha uma distância ou um ângulo</translation>
    </message>
    <message>
        <source>these coefficients are not possible together: their matrix has a negative eigenvalue</source>
        <translation>estes coeficientes não são possíveis juntos: sua matriz tem um autovalor negativo</translation>
    </message>
    <message>
        <source>it is at the place of %1</source>
        <translation>está no lugar de %1</translation>
    </message>
    <message>
        <source>no sensor of the network sees it</source>
        <translation>nenhum sensor da rede o vê</translation>
    </message>
    <message>
        <source>it cannot be localised from what %1 read: the readings leave a direction undetermined; add a sensor or a reading</source>
        <translation>não pode ser localizado pelo que %1 leem: as leituras deixam uma direção indeterminada; acrescente um sensor ou uma leitura</translation>
    </message>
    <message>
        <source>the readings do not lead to a position of every target: the estimation does not converge from the nominal coordinates; look for exchanged or mistyped readings</source>
        <translation>as leituras não levam a uma posição de cada alvo: a estimação não converge a partir das coordenadas nominais; procure leituras trocadas ou mal digitadas</translation>
    </message>
    <message>
        <source>%1 looks away from target %2: its angles point to the opposite side</source>
        <translation>%1 olha para longe do alvo %2: seus ângulos apontam para o lado oposto</translation>
    </message>
    <message>
        <source>there is no target %1</source>
        <translation>não há alvo %1</translation>
    </message>
    <message>
        <source>%1 does not see target %2: it is out of its range or field of view</source>
        <translation>%1 não vê o alvo %2: está fora de seu alcance ou campo de visão</translation>
    </message>
    <message>
        <source>%1 does not see %2 of the %3 targets: they are out of its range or field of view</source>
        <translation>%1 não vê %2 dos %3 alvos: estão fora de seu alcance ou campo de visão</translation>
    </message>
    <message>
        <source>the sensor %1 is not listed in the network</source>
        <translation>o sensor %1 não consta da rede</translation>
    </message>
    <message>
        <source>%1 reads no %2 according to its description</source>
        <translation>%1 não lê %2 segundo sua descrição</translation>
    </message>
    <message>
        <source>more than %1 rows for target %2</source>
        <translation>mais de %1 linhas para o alvo %2</translation>
    </message>
    <message>
        <source>target %1 is at the place of %2</source>
        <translation>o alvo %1 está no lugar de %2</translation>
    </message>
    <message>
        <source>target %1 is behind the camera %2</source>
        <translation>o alvo %1 está atrás da câmera %2</translation>
    </message>
    <message>
        <source>a network has at most %1 sensors; divide it into several analyses</source>
        <translation>uma rede tem no máximo %1 sensores; divida-a em várias análises</translation>
    </message>
    <message>
        <source>two targets are called %1</source>
        <translation>dois alvos chamam-se %1</translation>
    </message>
    <message>
        <source>a distance needs two targets at different places</source>
        <translation>uma distância precisa de dois alvos em lugares diferentes</translation>
    </message>
    <message>
        <source>a calibrated length needs two targets at different places</source>
        <translation>um comprimento calibrado precisa de dois alvos em lugares diferentes</translation>
    </message>
    <message>
        <source>the calibrated length is missing</source>
        <translation>falta o comprimento calibrado</translation>
    </message>
    <message>
        <source>the nominal targets of the %1 are at another distance than its calibrated length; the design takes their distance</source>
        <translation>os alvos nominais de %1 estão a outra distância que seu comprimento calibrado; o planejamento toma a distância deles</translation>
    </message>
    <message>
        <source>a calibrated length can be a constraint only of the non-linear estimator with weights from readings and stations</source>
        <translation>um comprimento calibrado só pode ser restrição do estimador não linear com pesos de leituras e estações</translation>
    </message>
    <message>
        <source>the targets of the %1 belong to two set-ups, which are estimated one after the other: it can only be a check</source>
        <translation>os alvos de %1 pertencem a dois estacionamentos, estimados um após o outro: só pode ser uma verificação</translation>
    </message>
    <message>
        <source>the targets of an angle must be at three places off one line: at 0° and 180° an angle has no sign and no derivative</source>
        <translation>os alvos de um ângulo devem estar em três lugares fora de uma reta: a 0° e 180° um ângulo não tem sinal nem derivada</translation>
    </message>
    <message>
        <source>the name %1 is taken by another frame or a target</source>
        <translation>o nome %1 já é de outro sistema ou de um alvo</translation>
    </message>
    <message>
        <source>the three targets of frame %1 lie on one line: its axes are undefined</source>
        <translation>os três alvos do sistema %1 estão numa reta: seus eixos não estão definidos</translation>
    </message>
    <message>
        <source>the x-axis of frame %1 is vertical: its Z-Y-X angles are undefined (gimbal lock)</source>
        <translation>o eixo x do sistema %1 é vertical: seus ângulos Z-Y-X não estão definidos (gimbal lock)</translation>
    </message>
    <message>
        <source>scale bar %1 – %2</source>
        <translation>barra de escala %1 – %2</translation>
    </message>
    <message>
        <source>the sensor %1 is listed twice</source>
        <translation>o sensor %1 consta duas vezes</translation>
    </message>
    <message>
        <source>%1 The residuals are larger than the uncertainties allow; the largest for its uncertainty is the %2. Look for mistyped or exchanged readings, or figures of the instruments that are too small</source>
        <translation>%1 Os resíduos são maiores do que as incertezas permitem; o maior para sua incerteza é %2. Procure leituras mal digitadas ou trocadas, ou números dos instrumentos pequenos demais</translation>
    </message>
    <message>
        <source>distance of %1 by %2</source>
        <translation>distância de %1 por %2</translation>
    </message>
    <message>
        <source>azimuth of %1 by %2</source>
        <translation>azimute de %1 por %2</translation>
    </message>
    <message>
        <source>elevation of %1 by %2</source>
        <translation>elevação de %1 por %2</translation>
    </message>
    <message>
        <source>length of the %1</source>
        <translation>comprimento de %1</translation>
    </message>
    <message>
        <source>Chi-square of the residuals: %1 with %2 degrees of freedom, p = %3.</source>
        <translation>Qui-quadrado dos resíduos: %1 com %2 graus de liberdade, p = %3.</translation>
    </message>
    <message>
        <source>no sensor</source>
        <translation>nenhum sensor</translation>
    </message>
    <message>
        <source>target %1 has no linear equations that localise it (a distance without angles has none): use the non-linear estimator</source>
        <translation>o alvo %1 não tem equações lineares que o localizem (uma distância sem ângulos não as tem): use o estimador não linear</translation>
    </message>
    <message>
        <source>target %1 cannot be localised from what %2 read: the readings leave a direction undetermined; add a sensor or a reading</source>
        <translation>o alvo %1 não pode ser localizado pelo que %2 leem: as leituras deixam uma direção indeterminada; acrescente um sensor ou uma leitura</translation>
    </message>
    <message>
        <source>target %1 is hardly localised: in one direction u is %2 m at a distance of %3 m</source>
        <translation>o alvo %1 mal é localizado: numa direção u é %2 m a uma distância de %3 m</translation>
    </message>
    <message>
        <source>the stations that measure target %1 lie in one plane and read distances only: its mirror image behind that plane fits as well; the one near the nominal coordinates is taken</source>
        <translation>as estações que medem o alvo %1 estão num plano e só leem distâncias: sua imagem espelhada atrás desse plano também se ajusta; toma-se a próxima das coordenadas nominais</translation>
    </message>
    <message>
        <source>a calibrated length cannot be a constraint of a set-up with more than %1 readings (this one has %2): make it a check</source>
        <translation>um comprimento calibrado não pode ser restrição de um estacionamento com mais de %1 leituras (este tem %2): faça dele uma verificação</translation>
    </message>
    <message>
        <source>the %1 readings of one set-up are too many to be weighed together: each target is estimated from its own readings, weighted with the stations</source>
        <translation>as %1 leituras de um estacionamento são demais para serem ponderadas juntas: cada alvo é estimado por suas próprias leituras, ponderadas com as estações</translation>
    </message>
    <message>
        <source>the standard uncertainty of a coordinate, %1 mm, is more than a tenth of the distance of point %2 from the x-axis, %3 mm: the law of propagation is not reliable here, look at Monte Carlo</source>
        <translation>a incerteza-padrão de uma coordenada, %1 mm, é mais de um décimo da distância do ponto %2 ao eixo x, %3 mm: a lei de propagação não é confiável aqui, olhe Monte Carlo</translation>
    </message>
    <message>
        <source>the frame made from these points lies %1 mm and %2° away from the axes in which they are given, so results differ from the table of poses; check the side of point 3 and the shift of the origin</source>
        <translation>o sistema formado por estes pontos está a %1 mm e %2° dos eixos em que são dados, de modo que os resultados diferem da tabela de poses; confira o lado do ponto 3 e o deslocamento da origem</translation>
    </message>
    <message>
        <source>%1: beta is within 2° of ±90°, where Z-Y-X angles are undefined (gimbal lock); state the orientation as a rotation vector</source>
        <translation>%1: beta está a menos de 2° de ±90°, onde os ângulos Z-Y-X não estão definidos (gimbal lock); declare a orientação como vetor de rotação</translation>
    </message>
    <message>
        <source>%1: beta is within 2° of 0° or 180°, where Z-Y-Z angles are undefined (gimbal lock); state the orientation as Z-Y-X angles or a rotation vector</source>
        <translation>%1: beta está a menos de 2° de 0° ou 180°, onde os ângulos Z-Y-Z não estão definidos (gimbal lock); declare a orientação como ângulos Z-Y-X ou vetor de rotação</translation>
    </message>
    <message>
        <source>%1: the rotation is within 4° of half a turn, where the sign of the axis is undefined; state the orientation as angles</source>
        <translation>%1: a rotação está a menos de 4° de meia volta, onde o sinal do eixo não está definido; declare a orientação como ângulos</translation>
    </message>
    <message>
        <source>the analysis %1 has no point called &apos;%2&apos;</source>
        <translation>a análise %1 não tem ponto chamado &apos;%2&apos;</translation>
    </message>
    <message>
        <source>point %1 cannot be measured by %2: %3</source>
        <translation>o ponto %1 não pode ser medido por %2: %3</translation>
    </message>
    <message>
        <source>the 3-2-1 method uses the first three points; point %1 and those after it are not used: choose least squares</source>
        <translation>o método 3-2-1 usa os três primeiros pontos; o ponto %1 e os seguintes não são usados: escolha mínimos quadrados</translation>
    </message>
    <message>
        <source>the base frame is undefined</source>
        <translation>o sistema da base não está definido</translation>
    </message>
    <message>
        <source>the moving frame is undefined</source>
        <translation>o sistema móvel não está definido</translation>
    </message>
    <message>
        <source>points %1 and %2 coincide: %3</source>
        <translation>os pontos %1 e %2 coincidem: %3</translation>
    </message>
    <message>
        <source>point %1 lies on the line through %2 and %3: %4</source>
        <translation>o ponto %1 está na reta por %2 e %3: %4</translation>
    </message>
    <message>
        <source>all points lie on one line or coincide: their frame is undefined</source>
        <translation>todos os pontos estão numa reta ou coincidem: seu sistema não está definido</translation>
    </message>
    <message>
        <source>not used: the uncertainties come from an artefact or instrument</source>
        <translation>não usado: as incertezas vêm de um padrão ou instrumento</translation>
    </message>
    <message>
        <source>there are two poses called &apos;%1&apos;; rename one</source>
        <translation>há duas poses chamadas &apos;%1&apos;; renomeie uma</translation>
    </message>
    <message>
        <source>no pose may be called &apos;base&apos;: that names the base among the measured points</source>
        <translation>nenhuma pose pode chamar-se &apos;base&apos;: isso nomeia a base entre os pontos medidos</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither &apos;base&apos; nor the name of a pose</source>
        <translation>&apos;%1&apos; não é &apos;base&apos; nem o nome de uma pose</translation>
    </message>
    <message>
        <source>there is no point called &apos;%1&apos; in that frame</source>
        <translation>não há ponto chamado &apos;%1&apos; nesse sistema</translation>
    </message>
    <message>
        <source>point %1 of &apos;%2&apos; was not measured</source>
        <translation>o ponto %1 de &apos;%2&apos; não foi medido</translation>
    </message>
    <message>
        <source>the mirrored coordinates leave %1 instead of %2: frame 0 is left-handed, check the signs and the order of its axes</source>
        <translation>as coordenadas espelhadas deixam %1 em vez de %2: o sistema 0 é levogiro, confira os sinais e a ordem de seus eixos</translation>
    </message>
    <message>
        <source>with %1 and %2 exchanged the residuals are %3 instead of %4: check the names</source>
        <translation>com %1 e %2 trocados os resíduos são %3 em vez de %4: confira os nomes</translation>
    </message>
    <message>
        <source>the points of &apos;%1&apos; do not fit their nominal coordinates</source>
        <translation>os pontos de &apos;%1&apos; não se ajustam a suas coordenadas nominais</translation>
    </message>
    <message>
        <source>the points of &apos;%1&apos; do not fit their nominal coordinates within the stated uncertainties: chi-square %2 with %3 degrees of freedom; the largest normalised residual is %4 (%5)</source>
        <translation>os pontos de &apos;%1&apos; não se ajustam a suas coordenadas nominais dentro das incertezas declaradas: qui-quadrado %2 com %3 graus de liberdade; o maior resíduo normalizado é %4 (%5)</translation>
    </message>
    <message>
        <source>the lengths between the supports make no triangle: the longest of %1, %2 and %3 exceeds the sum of the others</source>
        <translation>os comprimentos entre os apoios não formam um triângulo: o maior de %1, %2 e %3 excede a soma dos outros</translation>
    </message>
    <message>
        <source>the three supports lie on a line (%1, %2 and %3): they leave the place of the ball undetermined; move one of them aside</source>
        <translation>os três apoios estão numa reta (%1, %2 e %3): deixam indeterminado o lugar da esfera; afaste um deles</translation>
    </message>
    <message>
        <source>the lengths of support %1 do not meet at its height: they miss by %2</source>
        <translation>os comprimentos do apoio %1 não se encontram em sua altura: falham por %2</translation>
    </message>
    <message>
        <source>a set has at most %1 supports</source>
        <translation>um conjunto tem no máximo %1 apoios</translation>
    </message>
    <message>
        <source>the rotation about %1</source>
        <translation>a rotação em torno de %1</translation>
    </message>
    <message>
        <source>%1 has %2 points; a plane needs three, and some more to be checked</source>
        <translation>%1 tem %2 pontos; um plano precisa de três, e de mais alguns para ser verificado</translation>
    </message>
    <message>
        <source>%1 has a span of zero: all its points coincide</source>
        <translation>%1 tem percurso zero: todos os seus pontos coincidem</translation>
    </message>
    <message>
        <source>the tool centre point lies on the axis of %1 (or the tool has no length): it traces no circle; turn about another axis</source>
        <translation>o ponto central da ferramenta está no eixo de %1 (ou a ferramenta não tem comprimento): não traça círculo; gire em torno de outro eixo</translation>
    </message>
    <message>
        <source>the arc of %1 spans only %2°: uncertainties grow as the inverse square of the span and may be %3 times those of half a turn</source>
        <translation>o arco de %1 abrange só %2°: as incertezas crescem com o inverso do quadrado do percurso e podem ser %3 vezes as de meia volta</translation>
    </message>
    <message>
        <source>point %1 is %2 mm on the other side of the supports&apos; plane, where the ballbars look for no solution; change their placement or their side</source>
        <translation>o ponto %1 está %2 mm do outro lado do plano dos apoios, onde as ballbars não procuram solução; mude sua colocação ou seu lado</translation>
    </message>
    <message>
        <source>point %1 is only %2 mm from the supports&apos; plane, with a standard uncertainty of %3 mm in that direction: in some trials the lengths will not meet (negative root), and u is not to be trusted</source>
        <translation>o ponto %1 está a só %2 mm do plano dos apoios, com incerteza-padrão de %3 mm nessa direção: em alguns ensaios os comprimentos não se encontrarão (raiz negativa), e não se deve confiar em u</translation>
    </message>
    <message>
        <source>the measured points determine no sphere and no axes: they lie on one circle, or coincide; check their axes and angles</source>
        <translation>os pontos medidos não determinam esfera nem eixos: estão num círculo, ou coincidem; confira seus eixos e ângulos</translation>
    </message>
    <message>
        <source>a procedure has at most %1 points</source>
        <translation>um procedimento tem no máximo %1 pontos</translation>
    </message>
    <message>
        <source>two points are called %1</source>
        <translation>dois pontos chamam-se %1</translation>
    </message>
    <message>
        <source>the flange turns about %1 in two rotations; put their points into one</source>
        <translation>o flange gira em torno de %1 em duas rotações; ponha seus pontos em uma</translation>
    </message>
    <message>
        <source>one rotation traces one circle, which leaves the centre of the flange and its axes undetermined: add a rotation about another axis</source>
        <translation>uma rotação traça um círculo, o que deixa indeterminados o centro do flange e seus eixos: acrescente uma rotação em torno de outro eixo</translation>
    </message>
    <message>
        <source>no rotation measures axis %1: choose another way to make the axes, or add the rotation</source>
        <translation>nenhuma rotação mede o eixo %1: escolha outra forma de construir os eixos, ou acrescente a rotação</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not offer &apos;%2&apos;</source>
        <translation>&apos;%1&apos; não oferece &apos;%2&apos;</translation>
    </message>
    <message>
        <source>column %1: %2</source>
        <translation>coluna %1: %2</translation>
    </message>
    <message>
        <source>it is called like a joint of a gripper</source>
        <translation>tem nome de junta de uma garra</translation>
    </message>
    <message>
        <source>others follow it at the end of the arm, as in a gripper</source>
        <translation>outras a seguem no fim do braço, como numa garra</translation>
    </message>
    <message>
        <source>it slides by less than 100 mm at the end of the arm, as in a gripper</source>
        <translation>desliza menos de 100 mm no fim do braço, como numa garra</translation>
    </message>
    <message>
        <source>it is one of several at the end of the arm, as in a hand</source>
        <translation>é uma de várias no fim do braço, como numa mão</translation>
    </message>
    <message>
        <source>no joint leads to a link called %1</source>
        <translation>nenhuma junta leva a um elo chamado %1</translation>
    </message>
    <message>
        <source>no moving joint leads to %1</source>
        <translation>nenhuma junta móvel leva a %1</translation>
    </message>
    <message>
        <source>the links form a ring; URDF describes trees</source>
        <translation>os elos formam um anel; URDF descreve árvores</translation>
    </message>
    <message>
        <source>joint %1 on the way to %2 is of the type %3: freeze it, --freeze %1=0</source>
        <translation>a junta %1 no caminho até %2 é do tipo %3: congele-a, --freeze %1=0</translation>
    </message>
    <message>
        <source>joint %1 on the way to %2 follows joint %3: freeze it, --freeze %1=0</source>
        <translation>a junta %1 no caminho até %2 segue a junta %3: congele-a, --freeze %1=0</translation>
    </message>
    <message>
        <source>no arm: joint %1 was left out because %2</source>
        <translation>não é um braço: a junta %1 foi omitida porque %2</translation>
    </message>
    <message>
        <source>no arm: joint %1 is of the type %2</source>
        <translation>não é um braço: a junta %1 é do tipo %2</translation>
    </message>
    <message>
        <source>no arm: joint %1 follows joint %2</source>
        <translation>não é um braço: a junta %1 segue a junta %2</translation>
    </message>
    <message>
        <source>left out: it is of the type %1</source>
        <translation>omitida: é do tipo %1</translation>
    </message>
    <message>
        <source>left out: it follows joint %1</source>
        <translation>omitida: segue a junta %1</translation>
    </message>
    <message>
        <source>left out: %1</source>
        <translation>omitida: %1</translation>
    </message>
    <message>
        <source>left out: it is not on the way to %1</source>
        <translation>omitida: não está no caminho até %1</translation>
    </message>
    <message>
        <source>the file has no moving joint</source>
        <translation>o arquivo não tem junta móvel</translation>
    </message>
    <message>
        <source>the file has several arms of equal length, ending at %1 and %2: name the tip link of the one to import</source>
        <translation>o arquivo tem vários braços de igual comprimento, que terminam em %1 e %2: nomeie o elo final do que se importa</translation>
    </message>
    <message>
        <source>frozen: %1</source>
        <translation>congelada: %1</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not three numbers</source>
        <translation>&apos;%1&apos; não são três números</translation>
    </message>
    <message>
        <source>joint %1 does not say which links it joins</source>
        <translation>a junta %1 não diz que elos une</translation>
    </message>
    <message>
        <source>joint %1: %2</source>
        <translation>junta %1: %2</translation>
    </message>
    <message>
        <source>joint %1: its axis has no direction</source>
        <translation>junta %1: seu eixo não tem direção</translation>
    </message>
    <message>
        <source>not readable as XML: %1</source>
        <translation>não legível como XML: %1</translation>
    </message>
    <message>
        <source>no URDF: its root element &lt;robot&gt; is missing</source>
        <translation>não é URDF: falta seu elemento raiz &lt;robot&gt;</translation>
    </message>
    <message>
        <source>the file has xacro macros: expand them first (xacro FILE &gt; arm.urdf)</source>
        <translation>o arquivo tem macros xacro: expanda-as antes (xacro FILE &gt; arm.urdf)</translation>
    </message>
    <message>
        <source>link %1 hangs on two joints; URDF describes trees</source>
        <translation>o elo %1 pende de duas juntas; URDF descreve árvores</translation>
    </message>
    <message>
        <source>there is no joint %1 to freeze%2</source>
        <translation>não há junta %1 a congelar%2</translation>
    </message>
    <message>
        <source>joint %1 does not move, or is frozen twice</source>
        <translation>a junta %1 não se move, ou é congelada duas vezes</translation>
    </message>
    <message>
        <source>joint %1 is of the type %2: it can be frozen at 0 only</source>
        <translation>a junta %1 é do tipo %2: só pode ser congelada em 0</translation>
    </message>
    <message>
        <source>frozen at %1, beyond its limits</source>
        <translation>congelada em %1, além de seus limites</translation>
    </message>
    <message>
        <source>frozen at %1</source>
        <translation>congelada em %1</translation>
    </message>
    <message>
        <source>an arm has at most %1 joints here</source>
        <translation>um braço tem aqui no máximo %1 juntas</translation>
    </message>
    <message>
        <source>joint %1 slides: state its readings as lengths, in the columns of s</source>
        <translation>a junta %1 desliza: declare suas leituras como comprimentos, nas colunas de s</translation>
    </message>
    <message>
        <source>joint %1 turns: state its readings as angles, or give it the type sliding</source>
        <translation>a junta %1 gira: declare suas leituras como ângulos, ou dê-lhe o tipo deslizante</translation>
    </message>
    <message>
        <source>joint %1</source>
        <translation>junta %1</translation>
    </message>
    <message>
        <source>only the convention with Ry(beta) has a beta; leave it empty for %1, or choose that convention</source>
        <translation>só a convenção com Ry(beta) tem beta; deixe vazio para %1, ou escolha essa convenção</translation>
    </message>
    <message>
        <source>d and beta of %1 describe the same place of a parallel axis: where beta is given, d is 0 by definition</source>
        <translation>d e beta de %1 descrevem o mesmo lugar de um eixo paralelo: onde se dá beta, d é 0 por definição</translation>
    </message>
    <message>
        <source>the lowest reading of %1 is not below its highest</source>
        <translation>a menor leitura de %1 não está abaixo da maior</translation>
    </message>
    <message>
        <source>the robot has no joint %1</source>
        <translation>o robô não tem junta %1</translation>
    </message>
    <message>
        <source>%1 is 0 by definition, because the axis is parallel to the next</source>
        <translation>%1 é 0 por definição, porque o eixo é paralelo ao seguinte</translation>
    </message>
    <message>
        <source>%1 is no parameter of this robot: give beta in the table of joints where axes are parallel</source>
        <translation>%1 não é parâmetro deste robô: dê beta na tabela de juntas onde os eixos são paralelos</translation>
    </message>
    <message>
        <source>a parameter is correlated with itself; name two different ones</source>
        <translation>um parâmetro está correlacionado consigo mesmo; nomeie dois diferentes</translation>
    </message>
    <message>
        <source>there is no parameter &apos;%1&apos; with an uncertainty; write its symbol, such as d_3</source>
        <translation>não há parâmetro &apos;%1&apos; com incerteza; escreva seu símbolo, como d_3</translation>
    </message>
    <message>
        <source>%1 has several components of uncertainty: give it one, the combined, so that it can be correlated</source>
        <translation>%1 tem várias componentes de incerteza: dê-lhe uma, a combinada, para que possa ser correlacionado</translation>
    </message>
    <message>
        <source>there is no pose: give joint readings or a place of the tool</source>
        <translation>não há pose: dê leituras de juntas ou um lugar da ferramenta</translation>
    </message>
    <message>
        <source>two poses are called %1</source>
        <translation>duas poses chamam-se %1</translation>
    </message>
    <message>
        <source>pose %1: reading %2 of joint %3 is beyond its limits, %4 to %5</source>
        <translation>pose %1: a leitura %2 da junta %3 está além de seus limites, %4 a %5</translation>
    </message>
    <message>
        <source>pose %1: the orientation is within 2° of one that %2 cannot state (gimbal lock, half turn); state it otherwise</source>
        <translation>pose %1: a orientação está a menos de 2° de uma que %2 não pode declarar (gimbal lock, meia volta); declare-a de outro modo</translation>
    </message>
    <message>
        <source>%1 has only %2 joints; leave %3 empty</source>
        <translation>%1 só tem %2 juntas; deixe %3 vazio</translation>
    </message>
    <message>
        <source>joint %1 of %2 slides: its reading is %3</source>
        <translation>a junta %1 de %2 desliza: sua leitura é %3</translation>
    </message>
    <message>
        <source>joint %1 of %2 turns: its reading is %3</source>
        <translation>a junta %1 de %2 gira: sua leitura é %3</translation>
    </message>
    <message>
        <source>pose %1: give all three angles or none</source>
        <translation>pose %1: dê os três ângulos ou nenhum</translation>
    </message>
    <message>
        <source>pose %1: no readings within the limits of the joints bring the tool there; the nearest attempt misses the place by %2 but not the orientation</source>
        <translation>pose %1: nenhuma leitura dentro dos limites das juntas leva a ferramenta até lá; a tentativa mais próxima erra o lugar em %2, mas não a orientação</translation>
    </message>
    <message>
        <source>pose %1: no readings within the limits of the joints bring the tool there; the nearest attempt misses the place by %2</source>
        <translation>pose %1: nenhuma leitura dentro dos limites das juntas leva a ferramenta até lá; a tentativa mais próxima erra o lugar em %2</translation>
    </message>
    <message>
        <source>without limits</source>
        <translation>sem limites</translation>
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
        <translation>junta %1: %2, desliza, %3</translation>
    </message>
    <message>
        <source>joint %1: %2, turns, %3</source>
        <translation>junta %1: %2, gira, %3</translation>
    </message>
    <message>
        <source>%1 joint from link %2 to link %3</source>
        <translation>%1 junta do elo %2 ao elo %3</translation>
    </message>
    <message>
        <source>%1 joints from link %2 to link %3</source>
        <translation>%1 juntas do elo %2 ao elo %3</translation>
    </message>
    <message>
        <source>tool: link %1 at %2 from the frame of the last joint</source>
        <translation>ferramenta: elo %1 a %2 do sistema da última junta</translation>
    </message>
    <message>
        <source>with all readings at 0 the tool stands at %1 in link %2</source>
        <translation>com todas as leituras em 0 a ferramenta está em %1 no elo %2</translation>
    </message>
    <message>
        <source>the chain to %1 has %2 moving joints; an arm has at most %3 here: freeze those before the arm, --freeze %4=0</source>
        <translation>a cadeia até %1 tem %2 juntas móveis; um braço tem aqui no máximo %3: congele as anteriores ao braço, --freeze %4=0</translation>
    </message>
    <message>
        <source>pose %1: the residual of its %2 is %3 times its standard uncertainty (limit %4). Look at this pose first; hold it back by use = check</source>
        <translation>pose %1: o resíduo de seu %2 é %3 vezes sua incerteza-padrão (limite %4). Olhe primeiro esta pose; reserve-a com use = check</translation>
    </message>
    <message>
        <source>the residuals are %1 times as large as the uncertainties of points and readings explain: there is more than these (a joint&apos;s elasticity, temperature, an outlier), and the uncertainty of the parameters is stated too small</source>
        <translation>os resíduos são %1 vezes maiores do que as incertezas de pontos e leituras explicam: há mais que isso (elasticidade de uma junta, temperatura, um valor discrepante), e a incerteza dos parâmetros é declarada pequena demais</translation>
    </message>
    <message>
        <source>these poses hardly tell %1 apart (condition %2): turn more joints further, or hold one of them</source>
        <translation>estas poses mal distinguem %1 (condição %2): gire mais juntas mais longe, ou fixe um deles</translation>
    </message>
    <message>
        <source>no parameter of the arm can be told from these poses: every one of them is coupled with others or held</source>
        <translation>nenhum parâmetro do braço pode ser obtido destas poses: cada um está acoplado com outros ou fixado</translation>
    </message>
    <message>
        <source>the poses of the fit give %1 coordinates, no more than there are unknowns to find: measure more poses, or hold parameters</source>
        <translation>as poses do ajuste dão %1 coordenadas, não mais que as incógnitas a encontrar: meça mais poses, ou fixe parâmetros</translation>
    </message>
    <message>
        <source>the fit does not converge: look for exchanged poses, readings of the wrong sign or in another unit, and for a nominal robot that is another arm</source>
        <translation>o ajuste não converge: procure poses trocadas, leituras de sinal errado ou em outra unidade, e um robô nominal que seja outro braço</translation>
    </message>
    <message>
        <source>at the solution the unknowns cannot be told apart; hold one of those that the table of observability names</source>
        <translation>na solução as incógnitas não podem ser distinguidas; fixe uma das que a tabela de observabilidade nomeia</translation>
    </message>
    <message>
        <source>joint %1 slides: only arms whose joints turn are identified; take an arm without it, as it stands during the measurement</source>
        <translation>a junta %1 desliza: só se identificam braços cujas juntas giram; tome um braço sem ela, tal como está durante a medição</translation>
    </message>
    <message>
        <source>the fit has %1 poses; it needs three or more, and about twenty to tell all parameters</source>
        <translation>o ajuste tem %1 poses; precisa de três ou mais, e de cerca de vinte para obter todos os parâmetros</translation>
    </message>
    <message>
        <source>the robot has only %1 joints; leave %2 empty</source>
        <translation>o robô só tem %1 juntas; deixe %2 vazio</translation>
    </message>
    <message>
        <source>pose %1: its orientation is missing; give alpha, beta and gamma of every pose, or fit positions alone</source>
        <translation>pose %1: falta sua orientação; dê alpha, beta e gamma de cada pose, ou ajuste só posições</translation>
    </message>
    <message>
        <source>the robot has no parameter &apos;%1&apos; to hold; write its symbol, such as d_3</source>
        <translation>o robô não tem parâmetro &apos;%1&apos; a fixar; escreva seu símbolo, como d_3</translation>
    </message>
    <message>
        <source>rotation about %1</source>
        <translation>rotação em torno de %1</translation>
    </message>
    <message>
        <source>base %1</source>
        <translation>base %1</translation>
    </message>
    <message>
        <source>tool %1</source>
        <translation>ferramenta %1</translation>
    </message>
    <message>
        <source>the points do not lead to parameters of the arm</source>
        <translation>os pontos não levam a parâmetros do braço</translation>
    </message>
    <message>
        <source>the points of %1 run against the positive direction of the joint: reverse their order, or give its readings</source>
        <translation>os pontos de %1 correm contra o sentido positivo da junta: inverta sua ordem, ou dê suas leituras</translation>
    </message>
    <message>
        <source>the axes of joints %1 and %2</source>
        <translation>os eixos das juntas %1 e %2</translation>
    </message>
    <message>
        <source>%1 are nearly parallel (%2): they are described by beta with d = 0, because the place of their common perpendicular is hardly determined</source>
        <translation>%1 são quase paralelos (%2): são descritos por beta com d = 0, porque o lugar de sua perpendicular comum mal é determinado</translation>
    </message>
    <message>
        <source>%1 are %2 apart: they are described by d without beta, although the nominal robot has beta</source>
        <translation>%1 estão a %2: são descritos por d sem beta, embora o robô nominal tenha beta</translation>
    </message>
    <message>
        <source>the axes of joints %1 and %2 are the same line: nothing tells their frames apart</source>
        <translation>os eixos das juntas %1 e %2 são a mesma reta: nada distingue seus sistemas</translation>
    </message>
    <message>
        <source>parameters are identified by Eq 5: describe the nominal robot in that convention, not in Craig&apos;s</source>
        <translation>os parâmetros são identificados pela eq. 5: descreva o robô nominal nessa convenção, não na de Craig</translation>
    </message>
    <message>
        <source>joint %1 slides and draws no circle: take an arm without it, as it stands during the measurement</source>
        <translation>a junta %1 desliza e não traça círculo: tome um braço sem ela, tal como está durante a medição</translation>
    </message>
    <message>
        <source>an arm of one joint has no parameters between two axes</source>
        <translation>um braço de uma junta não tem parâmetros entre dois eixos</translation>
    </message>
    <message>
        <source>the robot has no %1</source>
        <translation>o robô não tem %1</translation>
    </message>
    <message>
        <source>%1 has %2 points; a circle needs three or more</source>
        <translation>%1 tem %2 pontos; um círculo precisa de três ou mais</translation>
    </message>
    <message>
        <source>the ball hardly moves while %1 turns: it lies on the axis of that joint and draws no circle. Fix the ball off the axis</source>
        <translation>a esfera mal se move enquanto %1 gira: está no eixo dessa junta e não traça círculo. Fixe a esfera fora do eixo</translation>
    </message>
    <message>
        <source>the points of %1 lie on a straight line, as far as their uncertainty lets it be seen: no circle goes through them. Turn the joint further</source>
        <translation>os pontos de %1 estão numa reta, até onde sua incerteza deixa ver: nenhum círculo passa por eles. Gire mais a junta</translation>
    </message>
    <message>
        <source>the arc of %1 over %2 is short for the uncertainty of its points: its axis will be known poorly</source>
        <translation>o arco de %1 sobre %2 é curto para a incerteza de seus pontos: seu eixo será mal conhecido</translation>
    </message>
    <message>
        <source>the plane of %1 passes the origin at %2: Eq 1 excludes planes through the origin and fails near it. Use total least squares</source>
        <translation>o plano de %1 passa pela origem a %2: a eq. 1 exclui planos pela origem e falha perto dela. Use mínimos quadrados totais</translation>
    </message>
    <message>
        <source>no circle fits the points of %1; look for exchanged points</source>
        <translation>nenhum círculo se ajusta aos pontos de %1; procure pontos trocados</translation>
    </message>
    <message>
        <source>the calibration matrix is singular: the channels answer to loads on %1 alike, so these cannot be told apart</source>
        <translation>a matriz de calibração é singular: os canais respondem igualmente a cargas em %1, de modo que não podem ser distinguidas</translation>
    </message>
    <message>
        <source>the calibration matrix has the condition number %1: loads on %2 are hardly told apart</source>
        <translation>a matriz de calibração tem número de condição %1: as cargas em %2 mal se distinguem</translation>
    </message>
    <message>
        <source>add a row of loads to be evaluated</source>
        <translation>acrescente uma linha de cargas a avaliar</translation>
    </message>
    <message>
        <source>add a row of readings to be decoupled</source>
        <translation>acrescente uma linha de leituras a desacoplar</translation>
    </message>
    <message>
        <source>two cases are called &apos;%1&apos;</source>
        <translation>dois casos chamam-se &apos;%1&apos;</translation>
    </message>
    <message>
        <source>channel %1 has no reading: all channels are needed</source>
        <translation>o canal %1 não tem leitura: todos os canais são necessários</translation>
    </message>
    <message>
        <source>the sensor has no channel %1</source>
        <translation>o sensor não tem canal %1</translation>
    </message>
    <message>
        <source>no load gives these readings by the calibration matrix</source>
        <translation>nenhuma carga dá estas leituras pela matriz de calibração</translation>
    </message>
    <message>
        <source>the load on %1 is %2 % of its rated load: the calibration says nothing about it</source>
        <translation>a carga em %1 é %2 % de sua carga nominal: a calibração nada diz sobre ela</translation>
    </message>
    <message>
        <source>loads on %1 are too few for this calibration matrix</source>
        <translation>as cargas em %1 são poucas demais para esta matriz de calibração</translation>
    </message>
    <message>
        <source>the interference of %1 is known without signs: it cannot be compensated. Give raw readings, or a table with signs</source>
        <translation>a interferência de %1 é conhecida sem sinais: não pode ser compensada. Dê leituras brutas, ou uma tabela com sinais</translation>
    </message>
    <message>
        <source>quadratic terms need raw readings; %1 has a summary only</source>
        <translation>termos quadráticos precisam de leituras brutas; %1 só tem um resumo</translation>
    </message>
    <message>
        <source>channel %1 is listed twice</source>
        <translation>o canal %1 consta duas vezes</translation>
    </message>
    <message>
        <source>moment</source>
        <translation>momento</translation>
    </message>
    <message>
        <source>force</source>
        <translation>força</translation>
    </message>
    <message>
        <source>channel %1 needs its rated load, a %2</source>
        <translation>o canal %1 precisa de sua carga nominal, de %2</translation>
    </message>
    <message>
        <source>%1 states no uncertainty of its load on %2: add it to its certificate</source>
        <translation>%1 não declara a incerteza de sua carga em %2: acrescente-a a seu certificado</translation>
    </message>
    <message>
        <source>increasing loads</source>
        <translation>cargas crescentes</translation>
    </message>
    <message>
        <source>unloaded reading before</source>
        <translation>leitura sem carga antes</translation>
    </message>
    <message>
        <source>run %1 of %2 has no %3: it is left out</source>
        <translation>a série %1 de %2 não tem %3: é omitida</translation>
    </message>
    <message>
        <source>%1 was not calibrated: there are no runs with its axis loaded</source>
        <translation>%1 não foi calibrado: não há séries com seu eixo carregado</translation>
    </message>
    <message>
        <source>%1 has one run only: its repeatability needs two or more</source>
        <translation>%1 tem uma só série: sua repetibilidade precisa de duas ou mais</translation>
    </message>
    <message>
        <source>%1 has %2 runs, %3 are planned: its means have %4 degrees of freedom</source>
        <translation>%1 tem %2 séries, estão previstas %3: suas médias têm %4 graus de liberdade</translation>
    </message>
    <message>
        <source>%1 has %2 preloads, %3 are planned</source>
        <translation>%1 tem %2 pré-cargas, estão previstas %3</translation>
    </message>
    <message>
        <source>, and it says nothing about repeatability</source>
        <translation>, e nada diz sobre a repetibilidade</translation>
    </message>
    <message>
        <source>step %1 of %2 is missing in %3 of %4 runs: its mean is that of %5%6</source>
        <translation>o degrau %1 de %2 falta em %3 de %4 séries: sua média é a de %5%6</translation>
    </message>
    <message>
        <source>%1 was loaded in %2 steps, %3 are planned</source>
        <translation>%1 foi carregado em %2 degraus, estão previstos %3</translation>
    </message>
    <message>
        <source>the largest load on %1 is %2; the rated output needs the rated load, %3</source>
        <translation>a maior carga em %1 é %2; a saída nominal precisa da carga nominal, %3</translation>
    </message>
    <message>
        <source>%1 has the same reading in all runs: its repeatability is evaluated as zero</source>
        <translation>%1 tem a mesma leitura em todas as séries: sua repetibilidade é avaliada como zero</translation>
    </message>
    <message>
        <source>%1 has no unloaded readings after a run: its non-zero error is taken as zero</source>
        <translation>%1 não tem leituras sem carga depois de uma série: seu erro de zero é tomado como zero</translation>
    </message>
    <message>
        <source>%1 has no decreasing loads: its hysteresis is not known and is taken as zero</source>
        <translation>%1 não tem cargas decrescentes: sua histerese não é conhecida e é tomada como zero</translation>
    </message>
    <message>
        <source>run %1 of %2 reads the same at steps %3 and %4 although the load rises: the indicator is saturated or the channel is stuck</source>
        <translation>a série %1 de %2 lê o mesmo nos degraus %3 e %4 embora a carga suba: o indicador está saturado ou o canal travado</translation>
    </message>
    <message>
        <source>run %1 of %2: only %3 s between steps %4 and %5, %6 s are planned</source>
        <translation>série %1 de %2: só %3 s entre os degraus %4 e %5, estão previstos %6 s</translation>
    </message>
    <message>
        <source>run %1 of %2 begins %3 s after the one before was unloaded, %4 s are planned</source>
        <translation>a série %1 de %2 começa %3 s depois que a anterior foi descarregada, estão previstos %4 s</translation>
    </message>
    <message>
        <source>channel %1 does not respond to its load: %2 at the rated load; look at its cable and its column</source>
        <translation>o canal %1 não responde à sua carga: %2 na carga nominal; olhe seu cabo e sua coluna</translation>
    </message>
    <message>
        <source>channel %1 responds to %2 more than to its own load: are columns exchanged?</source>
        <translation>o canal %1 responde a %2 mais do que à sua própria carga: as colunas estão trocadas?</translation>
    </message>
    <message>
        <source>there are no readings: import them from a CSV file, or choose summary tables</source>
        <translation>não há leituras: importe-as de um arquivo CSV, ou escolha tabelas de resumo</translation>
    </message>
    <message>
        <source>the sensor has no channel %1: list it among its channels</source>
        <translation>o sensor não tem canal %1: inclua-o entre seus canais</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no unit of a load: %2</source>
        <translation>&apos;%1&apos; não é unidade de uma carga: %2</translation>
    </message>
    <message>
        <source>%1 is a moment, but its load is in %2: are forces and moments, or their units, exchanged?</source>
        <translation>%1 é um momento, mas sua carga está em %2: forças e momentos, ou suas unidades, estão trocados?</translation>
    </message>
    <message>
        <source>%1 is a force, but its load is in %2: are forces and moments, or their units, exchanged?</source>
        <translation>%1 é uma força, mas sua carga está em %2: forças e momentos, ou suas unidades, estão trocados?</translation>
    </message>
    <message>
        <source>a load of %1 is more than 1.2 times the rated load of %2, %3: is its unit right?</source>
        <translation>uma carga de %1 é mais de 1,2 vezes a carga nominal de %2, %3: sua unidade está certa?</translation>
    </message>
    <message>
        <source>channel %1 has no reading in this row</source>
        <translation>o canal %1 não tem leitura nesta linha</translation>
    </message>
    <message>
        <source>channel %1 indicates %2 mV/V, which is the end of the indicator&apos;s range: the reading is saturated</source>
        <translation>o canal %1 indica %2 mV/V, que é o fim da faixa do indicador: a leitura está saturada</translation>
    </message>
    <message>
        <source>this run has its unloaded reading already</source>
        <translation>esta série já tem sua leitura sem carga</translation>
    </message>
    <message>
        <source>step %1 of this run is given twice</source>
        <translation>o degrau %1 desta série é dado duas vezes</translation>
    </message>
    <message>
        <source>channel %1 has no row in the summary</source>
        <translation>o canal %1 não tem linha no resumo</translation>
    </message>
    <message>
        <source>%1 has no row in the table of interference: taken as zero</source>
        <translation>%1 não tem linha na tabela de interferência: toma-se como zero</translation>
    </message>
    <message>
        <source>axis %1 is listed twice</source>
        <translation>o eixo %1 consta duas vezes</translation>
    </message>
    <message>
        <source>the sensor&apos;s calibration is a summary: there are no steps to pool over, so the largest standard deviation is taken</source>
        <translation>a calibração do sensor é um resumo: não há degraus a agrupar, de modo que se toma o maior desvio-padrão</translation>
    </message>
    <message>
        <source>the name is one of a function or a word of the equations; choose another</source>
        <translation>o nome é de uma função ou de uma palavra das equações; escolha outro</translation>
    </message>
    <message>
        <source>a symbol is made of letters, Greek ones too, digits and &apos;_&apos;, a letter first</source>
        <translation>um símbolo é feito de letras, também gregas, dígitos e &apos;_&apos;, com uma letra primeiro</translation>
    </message>
    <message>
        <source>only the first row of a symbol has a value; further rows add components</source>
        <translation>só a primeira linha de um símbolo tem valor; as demais acrescentam componentes</translation>
    </message>
    <message>
        <source>the component is in %1, the quantity in %2</source>
        <translation>a componente está em %1, a grandeza em %2</translation>
    </message>
    <message>
        <source>a further row states a component of uncertainty</source>
        <translation>uma linha adicional declara uma componente de incerteza</translation>
    </message>
    <message>
        <source>the instrument of the project is missing</source>
        <translation>falta o instrumento do projeto</translation>
    </message>
    <message>
        <source>the reading of an instrument needs a value</source>
        <translation>a leitura de um instrumento precisa de um valor</translation>
    </message>
    <message>
        <source>an instrument reads distances here; the unit must be one of length</source>
        <translation>um instrumento lê aqui distâncias; a unidade deve ser de comprimento</translation>
    </message>
    <message>
        <source>%1 reads no distances</source>
        <translation>%1 não lê distâncias</translation>
    </message>
    <message>
        <source>the value is missing, and no statement gives it</source>
        <translation>falta o valor, e nenhuma declaração o dá</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has observations and no row in the table of quantities</source>
        <translation>&apos;%1&apos; tem observações e nenhuma linha na tabela de grandezas</translation>
    </message>
    <message>
        <source>Newton&apos;s method finds no solution of this equation from the starting value, at the estimates of the quantities</source>
        <translation>o método de Newton não encontra solução desta equação a partir do valor inicial, nas estimativas das grandezas</translation>
    </message>
    <message>
        <source>this operation has no value at the estimates of the quantities (division by zero, root or logarithm of a negative number, or a number too large)</source>
        <translation>esta operação não tem valor nas estimativas das grandezas (divisão por zero, raiz ou logaritmo de um número negativo, ou um número grande demais)</translation>
    </message>
    <message>
        <source>it has several series: leave out the name of the one that is measured now</source>
        <translation>tem várias séries: omita o nome da que é medida agora</translation>
    </message>
    <message>
        <source>the table of observations has no rows for it</source>
        <translation>a tabela de observações não tem linhas para ela</translation>
    </message>
    <message>
        <source>&apos;a&apos; is missing: number of observations of which the value is the mean</source>
        <translation>falta &apos;a&apos;: número de observações de que o valor é a média</translation>
    </message>
    <message>
        <source>there is no equation: write one, y = x_1 + x_2</source>
        <translation>não há equação: escreva uma, y = x_1 + x_2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is defined by an equation: it cannot be a quantity too</source>
        <translation>&apos;%1&apos; é definido por uma equação: não pode ser também uma grandeza</translation>
    </message>
    <message>
        <source>no equation uses &apos;%1&apos;</source>
        <translation>nenhuma equação usa &apos;%1&apos;</translation>
    </message>
    <message>
        <source>no equation defines &apos;%1&apos;%2</source>
        <translation>nenhuma equação define &apos;%1&apos;%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is listed twice</source>
        <translation>&apos;%1&apos; consta duas vezes</translation>
    </message>
    <message>
        <source>group &apos;%1&apos;: %2</source>
        <translation>grupo &apos;%1&apos;: %2</translation>
    </message>
    <message>
        <source>an analysis of variance needs at least two groups</source>
        <translation>uma análise de variância precisa de pelo menos dois grupos</translation>
    </message>
    <message>
        <source>no group has more than one observation: nothing tells the scatter within the groups from that between them</source>
        <translation>nenhum grupo tem mais de uma observação: nada distingue a dispersão dentro dos grupos da que há entre eles</translation>
    </message>
    <message>
        <source>the curve does not reach %1</source>
        <translation>a curva não alcança %1</translation>
    </message>
    <message>
        <source>, outside of its points</source>
        <translation>, fora de seus pontos</translation>
    </message>
    <message>
        <source>the curve reaches %1 at x = %2%3: say in &apos;near&apos; which of them is meant</source>
        <translation>a curva alcança %1 em x = %2%3: diga em &apos;near&apos; qual deles se quer</translation>
    </message>
    <message>
        <source>no curve of this degree was found: the iteration for the uncertainties of x does not settle on these points</source>
        <translation>não foi encontrada curva deste grau: a iteração para as incertezas de x não se estabiliza com estes pontos</translation>
    </message>
    <message>
        <source>the points do not determine a curve of this degree</source>
        <translation>os pontos não determinam uma curva deste grau</translation>
    </message>
    <message>
        <source>the x of y = %1 lies outside of the points of the calibration</source>
        <translation>o x de y = %1 está fora dos pontos da calibração</translation>
    </message>
    <message>
        <source>the standard uncertainty of y is missing in row %1</source>
        <translation>falta a incerteza-padrão de y na linha %1</translation>
    </message>
    <message>
        <source>the standard uncertainty of y must be greater than zero in row %1</source>
        <translation>a incerteza-padrão de y deve ser maior que zero na linha %1</translation>
    </message>
    <message>
        <source>readings have the scatter of the residuals, which stated uncertainties do not use: give u_y in row %1</source>
        <translation>as leituras têm a dispersão dos resíduos, que as incertezas declaradas não usam: dê u_y na linha %1</translation>
    </message>
    <message>
        <source>a curve through the origin needs differences: give y in K</source>
        <translation>uma curva pela origem precisa de diferenças: dê y em K</translation>
    </message>
    <message>
        <source>a polynomial of this degree needs points at %1 different places or more beside the origin</source>
        <translation>um polinômio deste grau precisa de pontos em %1 lugares diferentes ou mais além da origem</translation>
    </message>
    <message>
        <source>a polynomial of this degree needs points at %1 different places or more</source>
        <translation>um polinômio deste grau precisa de pontos em %1 lugares diferentes ou mais</translation>
    </message>
    <message>
        <source>residuals say nothing about the uncertainty unless there are more points than coefficients: add points, or state u_y</source>
        <translation>os resíduos nada dizem sobre a incerteza se não houver mais pontos que coeficientes: acrescente pontos, ou declare u_y</translation>
    </message>
    <message>
        <source>line %1, %2</source>
        <translation>linha %1, %2</translation>
    </message>
    <message>
        <source>The mesh is not drawn: %1: %2</source>
        <translation>A malha não é desenhada: %1: %2</translation>
    </message>
    <message>
        <source>The mesh is not drawn: %1</source>
        <translation>A malha não é desenhada: %1</translation>
    </message>
    <message>
        <source>it has more than %1 triangles: thin it out</source>
        <translation>tem mais de %1 triângulos: reduza-o</translation>
    </message>
    <message>
        <source>triangle %1 has a coordinate that is not a finite number</source>
        <translation>o triângulo %1 tem uma coordenada que não é um número finito</translation>
    </message>
    <message>
        <source>triangle %1: %2 is no number</source>
        <translation>triângulo %1: %2 não é um número</translation>
    </message>
    <message>
        <source>it ends in triangle %1: it has been cut off</source>
        <translation>termina no triângulo %1: está cortado</translation>
    </message>
    <message>
        <source>triangle %1: %2 stands where %3 should</source>
        <translation>triângulo %1: %2 está onde deveria estar %3</translation>
    </message>
    <message>
        <source>it is no STL file: it neither begins with &quot;solid&quot; nor has a header of 84 bytes</source>
        <translation>não é um arquivo STL: nem começa com &quot;solid&quot; nem tem um cabeçalho de 84 bytes</translation>
    </message>
    <message>
        <source>it is no STL file: its header states %1 triangles, and there is more behind them</source>
        <translation>não é um arquivo STL: seu cabeçalho declara %1 triângulos, e há mais depois deles</translation>
    </message>
    <message>
        <source>its header states %1 triangles; it ends in triangle %2</source>
        <translation>seu cabeçalho declara %1 triângulos; termina no triângulo %2</translation>
    </message>
    <message>
        <source>it has no triangles</source>
        <translation>não tem triângulos</translation>
    </message>
    <message>
        <source>target uncertainty</source>
        <translation>incerteza-alvo</translation>
    </message>
    <message>
        <source>mean of the prior</source>
        <translation>média da distribuição a priori</translation>
    </message>
    <message>
        <source>standard deviation of the prior</source>
        <translation>desvio-padrão da distribuição a priori</translation>
    </message>
    <message>
        <source>the %1 must be greater than zero</source>
        <translation>%1: deve ser maior que zero</translation>
    </message>
    <message>
        <source>the %1 must be above the lower limit</source>
        <translation>%1: deve estar acima do limite inferior</translation>
    </message>
    <message>
        <source>the guard factor of %1 must lie between -10 and 10; 1 is a guard band of U, 0 simple acceptance</source>
        <translation>o fator de guarda de %1 deve estar entre -10 e 10; 1 é uma banda de guarda de U, 0 aceitação simples</translation>
    </message>
    <message>
        <source>the prior of %1 needs both a mean and a standard deviation</source>
        <translation>a distribuição a priori de %1 precisa de média e de desvio-padrão</translation>
    </message>
    <message>
        <source>the prior of %1 is of use only with a tolerance: give a limit</source>
        <translation>a distribuição a priori de %1 só serve com uma tolerância: dê um limite</translation>
    </message>
    <message>
        <source> in %1</source>
        <translation> em %1</translation>
    </message>
    <message>
        <source>the model has no output quantity %1%2%3</source>
        <translation>o modelo não tem grandeza de saída %1%2%3</translation>
    </message>
    <message>
        <source>an axis needs at least two values</source>
        <translation>um eixo precisa de pelo menos dois valores</translation>
    </message>
    <message>
        <source>&apos;from&apos; and &apos;to&apos; must be two different numbers</source>
        <translation>&apos;from&apos; e &apos;to&apos; devem ser dois números diferentes</translation>
    </message>
    <message>
        <source>with logarithmic spacing both ends must be greater than zero</source>
        <translation>com espaçamento logarítmico ambos os extremos devem ser maiores que zero</translation>
    </message>
    <message>
        <source>&apos;%1&apos; takes whole numbers: there are fewer than %2 between the ends</source>
        <translation>&apos;%1&apos; toma números inteiros: há menos de %2 entre os extremos</translation>
    </message>
    <message>
        <source>a study has one to three axes; this one has %1</source>
        <translation>um estudo tem de um a três eixos; este tem %1</translation>
    </message>
    <message>
        <source>%1 is varied by two axes</source>
        <translation>%1 é variado por dois eixos</translation>
    </message>
    <message>
        <source>Monte Carlo needs at least two trials</source>
        <translation>Monte Carlo precisa de pelo menos dois ensaios</translation>
    </message>
    <message>
        <source>the grid has %1 points; a study may have %2</source>
        <translation>a malha tem %1 pontos; um estudo pode ter %2</translation>
    </message>
    <message>
        <source>the uncertainty of an input quantity can be varied by a factor only</source>
        <translation>a incerteza de uma grandeza de entrada só pode ser variada por um fator</translation>
    </message>
    <message>
        <source>a factor has no unit</source>
        <translation>um fator não tem unidade</translation>
    </message>
    <message>
        <source>a factor of an uncertainty must not be negative</source>
        <translation>um fator de uma incerteza não deve ser negativo</translation>
    </message>
    <message>
        <source>a temperature in %1 cannot be multiplied; add to it, or give its values</source>
        <translation>uma temperatura em %1 não pode ser multiplicada; some a ela, ou dê seus valores</translation>
    </message>
    <message>
        <source>a number that varies</source>
        <translation>um número que varia</translation>
    </message>
    <message>
        <source>an axis of a study</source>
        <translation>um eixo de um estudo</translation>
    </message>
    <message>
        <source>an output of a study</source>
        <translation>uma saída de um estudo</translation>
    </message>
    <message>
        <source>a study</source>
        <translation>um estudo</translation>
    </message>
    <message>
        <source>only numbers of the set-up of an asset can be varied</source>
        <translation>só números da configuração de um recurso podem ser variados</translation>
    </message>
    <message>
        <source>a target is written as &quot;/setup/KEY&quot;, &quot;/setup/KEY/rows/0/COLUMN&quot;, &quot;/inputs/SYMBOL/estimate&quot; or &quot;/inputs/SYMBOL/components&quot;</source>
        <translation>um alvo escreve-se &quot;/setup/KEY&quot;, &quot;/setup/KEY/rows/0/COLUMN&quot;, &quot;/inputs/SYMBOL/estimate&quot; ou &quot;/inputs/SYMBOL/components&quot;</translation>
    </message>
    <message>
        <source>the set-up has no schema</source>
        <translation>a configuração não tem esquema</translation>
    </message>
    <message>
        <source>the set-up has no field %1%2</source>
        <translation>a configuração não tem campo %1%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not used with the present choices of the set-up</source>
        <translation>&apos;%1&apos; não é usado com as escolhas atuais da configuração</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number</source>
        <translation>&apos;%1&apos; não é um número</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not given, so there is nothing to change</source>
        <translation>&apos;%1&apos; não é dado, de modo que não há o que mudar</translation>
    </message>
    <message>
        <source>a coordinate of the pose &apos;%1&apos; is written as &quot;/setup/%2/position/0&quot; or &quot;/setup/%3/angles/2&quot;</source>
        <translation>uma coordenada da pose &apos;%1&apos; escreve-se &quot;/setup/%2/position/0&quot; ou &quot;/setup/%3/angles/2&quot;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not given</source>
        <translation>&apos;%1&apos; não é dado</translation>
    </message>
    <message>
        <source>a number of the table &apos;%1&apos; is written as &quot;/setup/%2/rows/0/COLUMN&quot; or &quot;/setup/%3/columns/COLUMN&quot;</source>
        <translation>um número da tabela &apos;%1&apos; escreve-se &quot;/setup/%2/rows/0/COLUMN&quot; ou &quot;/setup/%3/columns/COLUMN&quot;</translation>
    </message>
    <message>
        <source>the table &apos;%1&apos; has no column %2</source>
        <translation>a tabela &apos;%1&apos; não tem coluna %2</translation>
    </message>
    <message>
        <source>the column %1 does not hold numbers</source>
        <translation>a coluna %1 não contém números</translation>
    </message>
    <message>
        <source>the table &apos;%1&apos; is empty</source>
        <translation>a tabela &apos;%1&apos; está vazia</translation>
    </message>
    <message>
        <source>the table &apos;%1&apos; has %2 rows, counted from 0</source>
        <translation>a tabela &apos;%1&apos; tem %2 linhas, contadas a partir de 0</translation>
    </message>
    <message>
        <source>the cell is empty, so there is nothing to change</source>
        <translation>a célula está vazia, de modo que não há o que mudar</translation>
    </message>
    <message>
        <source>the column is empty, so there is nothing to change</source>
        <translation>a coluna está vazia, de modo que não há o que mudar</translation>
    </message>
    <message>
        <source>of an input quantity, &quot;estimate&quot; or &quot;components&quot; can be varied</source>
        <translation>de uma grandeza de entrada podem ser variados &quot;estimate&quot; ou &quot;components&quot;</translation>
    </message>
    <message>
        <source>the model has no input quantity %1%2</source>
        <translation>o modelo não tem grandeza de entrada %1%2</translation>
    </message>
    <message>
        <source>there is no component %1%2</source>
        <translation>não há componente %1%2</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; has no unit; it is not a measured number</source>
        <translation>a coluna &apos;%1&apos; de &apos;%2&apos; não tem unidade; não é um número medido</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; is missing</source>
        <translation>falta a coluna &apos;%1&apos; de &apos;%2&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no column &apos;%2&apos;%3; its columns are %4</source>
        <translation>&apos;%1&apos; não tem coluna &apos;%2&apos;%3; suas colunas são %4</translation>
    </message>
    <message>
        <source>column &apos;%1&apos; of &apos;%2&apos; is given twice</source>
        <translation>a coluna &apos;%1&apos; de &apos;%2&apos; é dada duas vezes</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be one of %2; it is &apos;%3&apos;%4</source>
        <translation>&apos;%1&apos; deve ser um de %2; é &apos;%3&apos;%4</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a whole number that is not negative; it is %2</source>
        <translation>&apos;%1&apos; deve ser um número inteiro não negativo; é %2</translation>
    </message>
    <message>
        <source>a unit is needed here, such as &quot;mm&quot;, not %1</source>
        <translation>aqui é preciso uma unidade, como &quot;mm&quot;, não %1</translation>
    </message>
    <message>
        <source>a unit with a dimension is needed here, not &apos;%1&apos;</source>
        <translation>aqui é preciso uma unidade com dimensão, não &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is of the same dimension as a unit before it; give one of each</source>
        <translation>&apos;%1&apos; tem a mesma dimensão de uma unidade anterior; dê uma de cada</translation>
    </message>
    <message>
        <source>what the project states for results</source>
        <translation>o que o projeto declara para os resultados</translation>
    </message>
    <message>
        <source>the coverage factor must be greater than zero; without one, k follows from the degrees of freedom or the coverage interval</source>
        <translation>o fator de abrangência deve ser maior que zero; sem um, k decorre dos graus de liberdade ou do intervalo de abrangência</translation>
    </message>
    <message>
        <source>a report has no chapter %1%2</source>
        <translation>um relatório não tem capítulo %1%2</translation>
    </message>
    <message>
        <source>there is no analysis %1%2</source>
        <translation>não há análise %1%2</translation>
    </message>
    <message>
        <source>the contents of the report</source>
        <translation>o conteúdo do relatório</translation>
    </message>
    <message>
        <source>a requirement</source>
        <translation>um requisito</translation>
    </message>
    <message>
        <source>a unit of length is needed here, not %1</source>
        <translation>aqui é preciso uma unidade de comprimento, não %1</translation>
    </message>
    <message>
        <source>the size of a view must be greater than zero</source>
        <translation>o tamanho de uma vista deve ser maior que zero</translation>
    </message>
    <message>
        <source>&apos;direction&apos; and &apos;up&apos; must be two different directions, not of length zero</source>
        <translation>&apos;direction&apos; e &apos;up&apos; devem ser duas direções diferentes, não de comprimento zero</translation>
    </message>
    <message>
        <source>a view</source>
        <translation>uma vista</translation>
    </message>
    <message>
        <source>%1 is the name of a standard view</source>
        <translation>%1 é o nome de uma vista padrão</translation>
    </message>
    <message>
        <source>the name %1 is used twice</source>
        <translation>o nome %1 é usado duas vezes</translation>
    </message>
    <message>
        <source>there is no single value here, but a list or a group</source>
        <translation>não há aqui um só valor, mas uma lista ou um grupo</translation>
    </message>
    <message>
        <source>there is nothing called &apos;%1&apos; to set</source>
        <translation>não há nada chamado &apos;%1&apos; a ajustar</translation>
    </message>
    <message>
        <source>there is nothing called &apos;%1&apos; to set%2</source>
        <translation>não há nada chamado &apos;%1&apos; a ajustar%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not of the form /PLACE/IN/THE/PROJECT=VALUE</source>
        <translation>&apos;%1&apos; não é da forma /PLACE/IN/THE/PROJECT=VALUE</translation>
    </message>
    <message>
        <source>%1 is a table: it needs &quot;columns&quot; and &quot;rows&quot;, or the name of a &quot;csv&quot; file</source>
        <translation>%1 é uma tabela: precisa de &quot;columns&quot; e &quot;rows&quot;, ou do nome de um arquivo &quot;csv&quot;</translation>
    </message>
    <message>
        <source>the columns of %1 must be texts in quotes</source>
        <translation>as colunas de %1 devem ser textos entre aspas</translation>
    </message>
    <message>
        <source>row %1 of %2 must be a list in brackets, not %3</source>
        <translation>a linha %1 de %2 deve ser uma lista entre colchetes, não %3</translation>
    </message>
    <message>
        <source>a text in quotes</source>
        <translation>um texto entre aspas</translation>
    </message>
    <message>
        <source>the columns of the CSV file of %1 must be an object in braces: a header of the file and the column it stands for</source>
        <translation>as colunas do arquivo CSV de %1 devem ser um objeto entre chaves: um cabeçalho do arquivo e a coluna que representa</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must stand for a column of %2 (a text), or for none (an empty text)</source>
        <translation>&apos;%1&apos; deve representar uma coluna de %2 (um texto), ou nenhuma (um texto vazio)</translation>
    </message>
    <message>
        <source>the CSV file &apos;%1&apos; of %2 must be named relative to the project&apos;s folder and lie in it</source>
        <translation>o arquivo CSV &apos;%1&apos; de %2 deve ser nomeado em relação à pasta do projeto e estar nela</translation>
    </message>
    <message>
        <source>the CSV file of %1 does not exist: looked for &apos;%2&apos;</source>
        <translation>o arquivo CSV de %1 não existe: procurou-se &apos;%2&apos;</translation>
    </message>
    <message>
        <source>CSV file of %1: %2</source>
        <translation>Arquivo CSV de %1: %2</translation>
    </message>
    <message>
        <source>%1 must be a whole number, not %2</source>
        <translation>%1 deve ser um número inteiro, não %2</translation>
    </message>
    <message>
        <source>%1 is %2; its unit is missing: write {&quot;value&quot;: %3, &quot;unit&quot;: &quot;%4&quot;}</source>
        <translation>%1 é %2; falta sua unidade: escreva {&quot;value&quot;: %3, &quot;unit&quot;: &quot;%4&quot;}</translation>
    </message>
    <message>
        <source>%1 must be a text in quotes, not %2</source>
        <translation>%1 deve ser um texto entre aspas, não %2</translation>
    </message>
    <message>
        <source>the lines of %1 must be texts in quotes, each one line</source>
        <translation>as linhas de %1 devem ser textos entre aspas, cada um uma linha</translation>
    </message>
    <message>
        <source>&apos;%1&apos; of %2 must be a list of three numbers</source>
        <translation>&apos;%1&apos; de %2 deve ser uma lista de três números</translation>
    </message>
    <message>
        <source>this set-up</source>
        <translation>esta configuração</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be three numbers: x, y, z</source>
        <translation>&apos;%1&apos; deve ser três números: x, y, z</translation>
    </message>
    <message>
        <source>a text is needed here, not %1</source>
        <translation>aqui é preciso um texto, não %1</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>o arquivo está vazio</translation>
    </message>
    <message>
        <source>the project ends before this: nothing may follow its closing &apos;}&apos;</source>
        <translation>o projeto termina antes disto: nada pode seguir seu &apos;}&apos; final</translation>
    </message>
    <message>
        <source>%1 (column %2)</source>
        <translation>%1 (coluna %2)</translation>
    </message>
    <message>
        <source>the file is truncated: it ends %1; its rest is missing</source>
        <translation>o arquivo está truncado: termina %1; falta o resto</translation>
    </message>
    <message>
        <source>lists and objects are nested too deeply</source>
        <translation>listas e objetos estão aninhados fundo demais</translation>
    </message>
    <message>
        <source>where a value is expected</source>
        <translation>onde se espera um valor</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is too large a number</source>
        <translation>&apos;%1&apos; é um número grande demais</translation>
    </message>
    <message>
        <source>in the middle of a value</source>
        <translation>no meio de um valor</translation>
    </message>
    <message>
        <source>a value is expected here (a number, a text in quotes, a list or an object), not &apos;%1&apos;</source>
        <translation>aqui se espera um valor (um número, um texto entre aspas, uma lista ou um objeto), não &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number that a project file can hold: give a finite number, or null where infinity is meant</source>
        <translation>&apos;%1&apos; não é um número que um arquivo de projeto possa conter: dê um número finito, ou null onde se quer infinito</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a value: texts stand in double quotes, numbers are written like -12.5e-3</source>
        <translation>&apos;%1&apos; não é um valor: textos ficam entre aspas duplas, números escrevem-se como -12.5e-3</translation>
    </message>
    <message>
        <source>the text that begins here is not closed by a double quote on its line</source>
        <translation>o texto que começa aqui não é fechado por aspas duplas em sua linha</translation>
    </message>
    <message>
        <source>in the middle of a text</source>
        <translation>no meio de um texto</translation>
    </message>
    <message>
        <source>inside %1</source>
        <translation>dentro de %1</translation>
    </message>
    <message>
        <source>&apos;,&apos; or &apos;%1&apos; is expected here, inside %2, not &apos;%3&apos;</source>
        <translation>aqui se espera &apos;,&apos; ou &apos;%1&apos;, dentro de %2, não &apos;%3&apos;</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>um objeto</translation>
    </message>
    <message>
        <source>a key in double quotes is expected here</source>
        <translation>aqui se espera uma chave entre aspas duplas</translation>
    </message>
    <message>
        <source>the key before this is not a valid text</source>
        <translation>a chave anterior não é um texto válido</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is given twice in the same object</source>
        <translation>&apos;%1&apos; aparece duas vezes no mesmo objeto</translation>
    </message>
    <message>
        <source>after the key &apos;%1&apos;</source>
        <translation>depois da chave &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;:&apos; is expected after the key &apos;%1&apos;</source>
        <translation>espera-se &apos;:&apos; depois da chave &apos;%1&apos;</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>uma lista</translation>
    </message>
    <message>
        <source>there is no kind of asset &apos;%1&apos;%2; known are %3</source>
        <translation>não há espécie de recurso &apos;%1&apos;%2; conhecidas são %3</translation>
    </message>
    <message>
        <source>there is no measurement model &apos;%1&apos;%2; known are %3</source>
        <translation>não há modelo de medição &apos;%1&apos;%2; conhecidos são %3</translation>
    </message>
    <message>
        <source>%1 is taken from another analysis, with all its uncertainty: remove either this or the link</source>
        <translation>%1 é tomado de outra análise, com toda a sua incerteza: retire isto ou a ligação</translation>
    </message>
    <message>
        <source>the analysis %1 has errors of its own: %2</source>
        <translation>a análise %1 tem erros próprios: %2</translation>
    </message>
    <message>
        <source>the analysis %1 has no value at its estimates</source>
        <translation>a análise %1 não tem valor em suas estimativas</translation>
    </message>
    <message>
        <source>the component %1 is not stated alike (held, or edited) by all analyses of the chain: they are taken as independent</source>
        <translation>a componente %1 não é declarada igualmente (fixada, ou editada) por todas as análises da cadeia: são tomadas como independentes</translation>
    </message>
    <message>
        <source>%1 is linked twice</source>
        <translation>%1 é ligado duas vezes</translation>
    </message>
    <message>
        <source>%1 is %2; %3 of %4 is %5</source>
        <translation>%1 é %2; %3 de %4 é %5</translation>
    </message>
    <message>
        <source>the analysis %1 would be made of itself: %2%3</source>
        <translation>a análise %1 seria feita de si mesma: %2%3</translation>
    </message>
    <message>
        <source>the analysis %1 has no output %2%3</source>
        <translation>a análise %1 não tem saída %2%3</translation>
    </message>
    <message>
        <source>&apos;schemaVersion&apos; is missing</source>
        <translation>falta &apos;schemaVersion&apos;</translation>
    </message>
    <message>
        <source>&apos;schemaVersion&apos; must be a whole number</source>
        <translation>&apos;schemaVersion&apos; deve ser um número inteiro</translation>
    </message>
    <message>
        <source>written by a newer version of Covaria (schema %1, this program reads up to %2); nothing was changed</source>
        <translation>escrito por uma versão mais nova da Covaria (esquema %1, este programa lê até %2); nada foi mudado</translation>
    </message>
    <message>
        <source>the text &apos;%1&apos;</source>
        <translation>o texto &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the number %1</source>
        <translation>o número %1</translation>
    </message>
    <message>
        <source>%1 must be an object in braces, not %2</source>
        <translation>%1 deve ser um objeto entre chaves, não %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is missing in %2</source>
        <translation>falta &apos;%1&apos; em %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be %2, not %3</source>
        <translation>&apos;%1&apos; deve ser %2, não %3</translation>
    </message>
    <message>
        <source>a list in brackets</source>
        <translation>uma lista entre colchetes</translation>
    </message>
    <message>
        <source>there is no &apos;%1&apos; in %2%3</source>
        <translation>não há &apos;%1&apos; em %2%3</translation>
    </message>
    <message>
        <source>a number with its unit</source>
        <translation>um número com sua unidade</translation>
    </message>
    <message>
        <source>a whole number from 0 to 18446744073709551615, in quotes</source>
        <translation>um número inteiro de 0 a 18446744073709551615, entre aspas</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be %2; it is %3</source>
        <translation>&apos;%1&apos; deve ser %2; é %3</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>um de %1</translation>
    </message>
    <message>
        <source>a whole number that is not negative</source>
        <translation>um número inteiro não negativo</translation>
    </message>
    <message>
        <source>a text here is not valid UTF-8 or has a wrong \ sequence</source>
        <translation>um texto aqui não é UTF-8 válido ou tem uma sequência \ errada</translation>
    </message>
    <message>
        <source>the project</source>
        <translation>o projeto</translation>
    </message>
    <message>
        <source>an asset</source>
        <translation>um recurso</translation>
    </message>
    <message>
        <source>an analysis</source>
        <translation>uma análise</translation>
    </message>
    <message>
        <source>this is not a project of Covaria: it does not begin with &quot;format&quot;: &quot;covaria&quot;</source>
        <translation>isto não é um projeto da Covaria: não começa com &quot;format&quot;: &quot;covaria&quot;</translation>
    </message>
    <message>
        <source>it has %1 MB, and projects of up to %2 MB are read: put its long tables into CSV files beside it</source>
        <translation>tem %1 MB, e leem-se projetos de até %2 MB: ponha suas tabelas longas em arquivos CSV ao lado</translation>
    </message>
    <message>
        <source>the project was not saved: it holds a number that is not finite, or fields that belong to no known kind of asset or model</source>
        <translation>o projeto não foi salvo: contém um número que não é finito, ou campos que não pertencem a nenhuma espécie conhecida de recurso ou modelo</translation>
    </message>
    <message>
        <source>the project was not saved: %1</source>
        <translation>o projeto não foi salvo: %1</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be two capital letters, such as DE; it is &apos;%2&apos;</source>
        <translation>&apos;%1&apos; deve ter duas letras maiúsculas, como DE; é &apos;%2&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be one of %2; it is &apos;%3&apos;</source>
        <translation>&apos;%1&apos; deve ser um de %2; é &apos;%3&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a date of the form 2026-04-17 or an interval 2026-04-17/2026-04-18; it is &apos;%2&apos;</source>
        <translation>&apos;%1&apos; deve ser uma data da forma 2026-04-17 ou um intervalo 2026-04-17/2026-04-18; é &apos;%2&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a date of the form 2026-04-17; it is &apos;%2&apos;</source>
        <translation>&apos;%1&apos; deve ser uma data da forma 2026-04-17; é &apos;%2&apos;</translation>
    </message>
    <message>
        <source>the item cannot have been calibrated before it was received</source>
        <translation>o item não pode ter sido calibrado antes de ser recebido</translation>
    </message>
    <message>
        <source>the certificate cannot have been issued before the calibration</source>
        <translation>o certificado não pode ter sido emitido antes da calibração</translation>
    </message>
    <message>
        <source> (or %1)</source>
        <translation> (ou %1)</translation>
    </message>
    <message>
        <source>&apos;%1&apos;%2 must be stated (ISO/IEC 17025 %3)</source>
        <translation>&apos;%1&apos;%2 deve ser declarado (ISO/IEC 17025 %3)</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be stated (Digital Calibration Certificate)</source>
        <translation>&apos;%1&apos; deve ser declarado (certificado digital de calibração)</translation>
    </message>
    <message>
        <source>the certificate</source>
        <translation>o certificado</translation>
    </message>
    <message>
        <source>%1 has more than 2 MB, too much for a logo</source>
        <translation>%1 tem mais de 2 MB, demais para um logotipo</translation>
    </message>
    <message>
        <source>%1 is neither a PNG nor a JPEG picture</source>
        <translation>%1 não é figura PNG nem JPEG</translation>
    </message>
    <message>
        <source>The certificate has no logo: %1</source>
        <translation>O certificado não tem logotipo: %1</translation>
    </message>
    <message>
        <source>more than %1 columns are not read</source>
        <translation>mais de %1 colunas não são lidas</translation>
    </message>
    <message>
        <source>the quote that begins here is not closed</source>
        <translation>as aspas que começam aqui não são fechadas</translation>
    </message>
    <message>
        <source>text follows the closing quote of a cell; write a quote inside a quoted cell twice</source>
        <translation>há texto depois das aspas finais de uma célula; escreva duas vezes as aspas dentro de uma célula entre aspas</translation>
    </message>
    <message>
        <source>the text is encoded as UTF-16; save it as UTF-8</source>
        <translation>o texto está codificado como UTF-16; salve-o como UTF-8</translation>
    </message>
    <message>
        <source>the text is not encoded as UTF-8; save it as UTF-8</source>
        <translation>o texto não está codificado como UTF-8; salve-o como UTF-8</translation>
    </message>
    <message>
        <source>this row has %1 cells; there are %2 columns</source>
        <translation>esta linha tem %1 células; há %2 colunas</translation>
    </message>
    <message>
        <source>column &apos;%1&apos;: &apos;%2&apos; is not a number</source>
        <translation>coluna &apos;%1&apos;: &apos;%2&apos; não é um número</translation>
    </message>
    <message>
        <source>column &apos;%1&apos;: &apos;%2&apos; is neither true nor false</source>
        <translation>coluna &apos;%1&apos;: &apos;%2&apos; não é true nem false</translation>
    </message>
    <message>
        <source>the file has no column &apos;%1&apos;%2; its columns are %3</source>
        <translation>o arquivo não tem coluna &apos;%1&apos;%2; suas colunas são %3</translation>
    </message>
    <message>
        <source>there is no row with the names of the columns</source>
        <translation>não há linha com os nomes das colunas</translation>
    </message>
    <message>
        <source>it has %1 lines, and there is memory for about %2 of these rows: leave rows out, or take means of several</source>
        <translation>tem %1 linhas, e há memória para cerca de %2 delas: omita linhas, ou tome médias de várias</translation>
    </message>
    <message>
        <source>a table to choose from is written as &quot;/setup/KEY/rows&quot;; it is %1</source>
        <translation>uma tabela de onde escolher escreve-se &quot;/setup/KEY/rows&quot;; é %1</translation>
    </message>
    <message>
        <source>a design needs &apos;variables&apos;, a table to &apos;choose&apos; from, or &apos;reductions&apos;</source>
        <translation>um planejamento precisa de &apos;variables&apos;, de uma tabela de onde &apos;choose&apos;, ou de &apos;reductions&apos;</translation>
    </message>
    <message>
        <source>the cheapest reductions are a design of their own, without variables and rows</source>
        <translation>as reduções mais baratas são um planejamento próprio, sem variáveis nem linhas</translation>
    </message>
    <message>
        <source>a design has at most %1 reductions</source>
        <translation>um planejamento tem no máximo %1 reduções</translation>
    </message>
    <message>
        <source>a design has at most %1 variables</source>
        <translation>um planejamento tem no máximo %1 variáveis</translation>
    </message>
    <message>
        <source>the cost is that of rows with &apos;prices&apos;: it needs a table to choose from, and no variables</source>
        <translation>o custo é o de linhas com &apos;prices&apos;: precisa de uma tabela de onde escolher, e de nenhuma variável</translation>
    </message>
    <message>
        <source>a tolerance must not be negative</source>
        <translation>uma tolerância não deve ser negativa</translation>
    </message>
    <message>
        <source>&apos;%1&apos; takes whole numbers: a study shows what each of them gives</source>
        <translation>&apos;%1&apos; toma números inteiros: um estudo mostra o que cada um deles dá</translation>
    </message>
    <message>
        <source>%1 is chosen by two variables</source>
        <translation>%1 é escolhido por duas variáveis</translation>
    </message>
    <message>
        <source>the smallest factor is between 0 and 1</source>
        <translation>o menor fator está entre 0 e 1</translation>
    </message>
    <message>
        <source>a price must not be negative</source>
        <translation>um preço não deve ser negativo</translation>
    </message>
    <message>
        <source>%1 is reduced twice</source>
        <translation>%1 é reduzido duas vezes</translation>
    </message>
    <message>
        <source>of %1 rows, %2 to %3 can be kept; it is %4</source>
        <translation>de %1 linhas podem ser mantidas %2 a %3; é %4</translation>
    </message>
    <message>
        <source>there are %1 rows, counted from 0</source>
        <translation>há %1 linhas, contadas a partir de 0</translation>
    </message>
    <message>
        <source>row %1 is fixed twice</source>
        <translation>a linha %1 é fixada duas vezes</translation>
    </message>
    <message>
        <source>more rows are fixed than kept</source>
        <translation>mais linhas são fixadas do que mantidas</translation>
    </message>
    <message>
        <source>there is one price for all rows, or one for each of the %1; there are %2</source>
        <translation>há um preço para todas as linhas, ou um para cada uma das %1; há %2</translation>
    </message>
    <message>
        <source>a box</source>
        <translation>uma caixa</translation>
    </message>
    <message>
        <source>every coordinate of &apos;to&apos; must be greater than that of &apos;from&apos;</source>
        <translation>cada coordenada de &apos;to&apos; deve ser maior que a de &apos;from&apos;</translation>
    </message>
    <message>
        <source>the least distance</source>
        <translation>a menor distância</translation>
    </message>
    <message>
        <source>the least distance must be greater than zero</source>
        <translation>a menor distância deve ser maior que zero</translation>
    </message>
    <message>
        <source>there are 1 to %1 starts</source>
        <translation>há de 1 a %1 inícios</translation>
    </message>
    <message>
        <source>at least one evaluation is needed</source>
        <translation>é preciso pelo menos uma avaliação</translation>
    </message>
    <message>
        <source>the set-up has no table %1%2</source>
        <translation>a configuração não tem tabela %1%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be %2; it is &apos;%3&apos;</source>
        <translation>&apos;%1&apos; deve ser %2; é &apos;%3&apos;</translation>
    </message>
    <message>
        <source>a variable of a design</source>
        <translation>uma variável de um planejamento</translation>
    </message>
    <message>
        <source>a number that is reduced</source>
        <translation>um número que é reduzido</translation>
    </message>
    <message>
        <source>a reduction of a design</source>
        <translation>uma redução de um planejamento</translation>
    </message>
    <message>
        <source>the choice of a design</source>
        <translation>a escolha de um planejamento</translation>
    </message>
    <message>
        <source>a box of a design</source>
        <translation>uma caixa de um planejamento</translation>
    </message>
    <message>
        <source>a design</source>
        <translation>um planejamento</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a list of numbers</source>
        <translation>&apos;%1&apos; deve ser uma lista de números</translation>
    </message>
    <message>
        <source>the parameters of &apos;%1&apos;</source>
        <translation>os parâmetros de &apos;%1&apos;</translation>
    </message>
    <message>
        <source>a distribution</source>
        <translation>uma distribuição</translation>
    </message>
    <message>
        <source>there is no distribution &apos;%1&apos;%2; known are %3</source>
        <translation>não há distribuição &apos;%1&apos;%2; conhecidas são %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is missing in a component</source>
        <translation>falta &apos;%1&apos; numa componente</translation>
    </message>
    <message>
        <source>a component</source>
        <translation>uma componente</translation>
    </message>
    <message>
        <source>the edit of an input quantity</source>
        <translation>a edição de uma grandeza de entrada</translation>
    </message>
    <message>
        <source>the notes of a quantity</source>
        <translation>as notas de uma grandeza</translation>
    </message>
    <message>
        <source>an output of an analysis</source>
        <translation>uma saída de uma análise</translation>
    </message>
    <message>
        <source>a link</source>
        <translation>um link</translation>
    </message>
    <message>
        <source>a correlation</source>
        <translation>uma correlação</translation>
    </message>
    <message>
        <source>component %1</source>
        <translation>componente %1</translation>
    </message>
    <message>
        <source>%1 is %2; the unit %3 of %4 is the unit of %5</source>
        <translation>%1 é %2; a unidade %3 de %4 é a unidade de %5</translation>
    </message>
    <message>
        <source>%1: the degrees of freedom must be greater than zero</source>
        <translation>%1: os graus de liberdade devem ser maiores que zero</translation>
    </message>
    <message>
        <source>%1 is a component, not an input quantity: it can be held, but not be edited otherwise</source>
        <translation>%1 é uma componente, não uma grandeza de entrada: pode ser fixada, mas não editada de outro modo</translation>
    </message>
    <message>
        <source>%1 has no uncertainty to be correlated</source>
        <translation>%1 não tem incerteza a correlacionar</translation>
    </message>
    <message>
        <source>there is no component or quantity %1%2</source>
        <translation>não há componente nem grandeza %1%2</translation>
    </message>
    <message>
        <source>%1 cannot be correlated with itself</source>
        <translation>%1 não pode ser correlacionado consigo mesmo</translation>
    </message>
    <message>
        <source>%1 and %2 have the component %3 in common, which correlates them; state the correlation of other components instead</source>
        <translation>%1 e %2 têm em comum a componente %3, que os correlaciona; declare em vez disso a correlação de outras componentes</translation>
    </message>
    <message>
        <source>%1 is edited twice</source>
        <translation>%1 é editado duas vezes</translation>
    </message>
    <message>
        <source>the correlation of %1 and %2 is given twice</source>
        <translation>a correlação de %1 e %2 é dada duas vezes</translation>
    </message>
    <message>
        <source>a number is needed here; it is %1</source>
        <translation>aqui é preciso um número; é %1</translation>
    </message>
    <message>
        <source>%1: %2 must lie within %3</source>
        <translation>%1: %2 deve estar dentro de %3</translation>
    </message>
    <message>
        <source>the frame of %1 is missing</source>
        <translation>falta o sistema de %1</translation>
    </message>
    <message>
        <source>no calibration of a robot: &apos;kinematics&apos; is missing</source>
        <translation>não é calibração de um robô: falta &apos;kinematics&apos;</translation>
    </message>
    <message>
        <source>calibration %1</source>
        <translation>calibração %1</translation>
    </message>
    <message>
        <source>lengths in m, angles in rad, about fixed axes as in URDF</source>
        <translation>comprimentos em m, ângulos em rad, em torno de eixos fixos como no URDF</translation>
    </message>
    <message>
        <source>%1 is called %2 here</source>
        <translation>%1 chama-se %2 aqui</translation>
    </message>
    <message>
        <source>an input without a name</source>
        <translation>uma entrada sem nome</translation>
    </message>
    <message>
        <source>its %1 must be a number</source>
        <translation>seu %1 deve ser um número</translation>
    </message>
    <message>
        <source>there are two inputs of that name</source>
        <translation>há duas entradas com esse nome</translation>
    </message>
    <message>
        <source>%1 %2 is %3 %4</source>
        <translation>%1 %2 é %3 %4</translation>
    </message>
    <message>
        <source>typea_uncert must be a number from 0</source>
        <translation>typea_uncert deve ser um número a partir de 0</translation>
    </message>
    <message>
        <source>typea must be a list of at least two observations</source>
        <translation>typea deve ser uma lista de pelo menos duas observações</translation>
    </message>
    <message>
        <source>an observation must be a number; those in groups are not read</source>
        <translation>uma observação deve ser um número; as de grupos não são lidas</translation>
    </message>
    <message>
        <source>more than %1 observations are not read</source>
        <translation>mais de %1 observações não são lidas</translation>
    </message>
    <message>
        <source>numnewmeas must be a number from 1</source>
        <translation>numnewmeas deve ser um número a partir de 1</translation>
    </message>
    <message>
        <source>its observations are taken as independent: Suncal enlarges the uncertainty of more than 50 that are autocorrelated</source>
        <translation>suas observações são tomadas como independentes: o Suncal aumenta a incerteza de mais de 50 que sejam autocorrelacionadas</translation>
    </message>
    <message>
        <source>%1 %2 is no number</source>
        <translation>%1 %2 não é número</translation>
    </message>
    <message>
        <source>%1 %2 is %3</source>
        <translation>%1 %2 é %3</translation>
    </message>
    <message>
        <source>degf must be a number greater than 0, or .inf</source>
        <translation>degf deve ser um número maior que 0, ou .inf</translation>
    </message>
    <message>
        <source>; it has %1</source>
        <translation>; tem %1</translation>
    </message>
    <message>
        <source>the file has no calculation of mode &apos;uncertainty&apos; or &apos;system&apos;%1</source>
        <translation>o arquivo não tem cálculo de modo &apos;uncertainty&apos; ou &apos;system&apos;%1</translation>
    </message>
    <message>
        <source>%1: %2 quantities, %3 results</source>
        <translation>%1: %2 grandezas, %3 resultados</translation>
    </message>
    <message>
        <source>the calculation has no inputs</source>
        <translation>o cálculo não tem entradas</translation>
    </message>
    <message>
        <source>the calculation has no functions</source>
        <translation>o cálculo não tem funções</translation>
    </message>
    <message>
        <source>the system has no quantities</source>
        <translation>o sistema não tem grandezas</translation>
    </message>
    <message>
        <source>quantities of type %1 are not read; those that are: direct, indirect</source>
        <translation>grandezas do tipo %1 não são lidas; as que são: direct, indirect</translation>
    </message>
    <message>
        <source>the system has no direct quantity</source>
        <translation>o sistema não tem grandeza direct</translation>
    </message>
    <message>
        <source>more than %1 inputs are not read</source>
        <translation>mais de %1 entradas não são lidas</translation>
    </message>
    <message>
        <source>more than %1 functions are not read</source>
        <translation>mais de %1 funções não são lidas</translation>
    </message>
    <message>
        <source>a function has the name of an input or of another function</source>
        <translation>uma função tem o nome de uma entrada ou de outra função</translation>
    </message>
    <message>
        <source>%1: in %2 instead of %3</source>
        <translation>%1: em %2 em vez de %3</translation>
    </message>
    <message>
        <source>%1: no starting value</source>
        <translation>%1: sem valor inicial</translation>
    </message>
    <message>
        <source>%1: state the unit of what is solved for under &apos;units&apos;</source>
        <translation>%1: declare em &apos;units&apos; a unidade do que se resolve</translation>
    </message>
    <message>
        <source>a correlation needs var1 and var2, two inputs, and cor, a number between -1 and 1</source>
        <translation>uma correlação precisa de var1 e var2, duas entradas, e cor, um número entre -1 e 1</translation>
    </message>
    <message>
        <source>no unit can be stated for %1%2</source>
        <translation>não se pode declarar unidade para %1%2</translation>
    </message>
    <message>
        <source>the file has no Excel workbook in it</source>
        <translation>o arquivo não contém pasta de trabalho do Excel</translation>
    </message>
    <message>
        <source>the file has no sheet with cells</source>
        <translation>o arquivo não tem folha com células</translation>
    </message>
    <message>
        <source>%1: %2 is no place of a cell</source>
        <translation>%1: %2 não é o lugar de uma célula</translation>
    </message>
    <message>
        <source>%1: more than %2 cells are not read</source>
        <translation>%1: mais de %2 células não são lidas</translation>
    </message>
    <message>
        <source>its text is missing from the file</source>
        <translation>seu texto falta no arquivo</translation>
    </message>
    <message>
        <source>the file has a password or the old format .xls: save it as .xlsx without a password</source>
        <translation>o arquivo tem senha ou o formato antigo .xls: salve-o como .xlsx sem senha</translation>
    </message>
    <message>
        <source>XML of more than %1 MB is not read</source>
        <translation>XML de mais de %1 MB não é lido</translation>
    </message>
    <message>
        <source>a document type declaration: files that declare entities are not read</source>
        <translation>uma declaração de tipo de documento: arquivos que declaram entidades não são lidos</translation>
    </message>
    <message>
        <source>an alias (*name): write out what it stands for, aliases are not expanded</source>
        <translation>um alias (*name): escreva por extenso o que representa, aliases não são expandidos</translation>
    </message>
    <message>
        <source>more than %1 entries are not read</source>
        <translation>mais de %1 entradas não são lidas</translation>
    </message>
    <message>
        <source>more than %1 levels are not read</source>
        <translation>mais de %1 níveis não são lidos</translation>
    </message>
    <message>
        <source>a key must be a word</source>
        <translation>uma chave deve ser uma palavra</translation>
    </message>
    <message>
        <source>the key %1 stands twice</source>
        <translation>a chave %1 aparece duas vezes</translation>
    </message>
    <message>
        <source>more than 1000 keys are not read</source>
        <translation>mais de 1000 chaves não são lidas</translation>
    </message>
    <message>
        <source>YAML of more than %1 kB is not read</source>
        <translation>YAML de mais de %1 kB não é lido</translation>
    </message>
    <message>
        <source>the file has no YAML document</source>
        <translation>o arquivo não tem documento YAML</translation>
    </message>
    <message>
        <source>not readable as YAML: %1</source>
        <translation>não legível como YAML: %1</translation>
    </message>
    <message>
        <source>the file has %1</source>
        <translation>o arquivo tem %1</translation>
    </message>
    <message>
        <source>no readable zip archive in it (%1)</source>
        <translation>não contém arquivo zip legível (%1)</translation>
    </message>
    <message>
        <source>more than %1 parts, which are not read</source>
        <translation>mais de %1 partes, que não são lidas</translation>
    </message>
    <message>
        <source>no part %1</source>
        <translation>nenhuma parte %1</translation>
    </message>
    <message>
        <source>a part %1 that cannot be read</source>
        <translation>uma parte %1 que não pode ser lida</translation>
    </message>
    <message>
        <source>an encrypted part %1: save it without a password</source>
        <translation>uma parte %1 criptografada: salve-o sem senha</translation>
    </message>
    <message>
        <source>a part %1 that cannot be unpacked</source>
        <translation>uma parte %1 que não pode ser descompactada</translation>
    </message>
    <message>
        <source>a damaged part %1</source>
        <translation>uma parte %1 danificada</translation>
    </message>
    <message>
        <source>parts that unpack to more than %1 MB (at %2), which are not read</source>
        <translation>partes que se descompactam em mais de %1 MB (em %2), que não são lidas</translation>
    </message>
    <message>
        <source>no network of GNU Gama: &lt;gama-local&gt; with a &lt;network&gt; is expected</source>
        <translation>não é uma rede do GNU Gama: espera-se &lt;gama-local&gt; com &lt;network&gt;</translation>
    </message>
    <message>
        <source>the stated unit of lengths: coordinates of Gama are in metres</source>
        <translation>a unidade de comprimento declarada: coordenadas do Gama são em metros</translation>
    </message>
    <message>
        <source>&lt;parameters&gt;</source>
        <translation>&lt;parameters&gt;</translation>
    </message>
    <message>
        <source>%1 &lt;%2&gt; with observations</source>
        <translation>%1 &lt;%2&gt; com observações</translation>
    </message>
    <message>
        <source>%1 points without x and y</source>
        <translation>%1 pontos sem x e y</translation>
    </message>
    <message>
        <source>%1 points have no z: it is taken as 0</source>
        <translation>%1 pontos não têm z: toma-se como 0</translation>
    </message>
    <message>
        <source>the network has no points with coordinates x and y</source>
        <translation>a rede não tem pontos com coordenadas x e y</translation>
    </message>
    <message>
        <source>%1 points are to be adjusted: their coordinates are approximate ones</source>
        <translation>%1 pontos devem ser ajustados: suas coordenadas são aproximadas</translation>
    </message>
    <message>
        <source>: a left-handed frame; x and y are taken as they stand</source>
        <translation>: um sistema levogiro; x e y são tomados como estão</translation>
    </message>
    <message>
        <source>coordinates in metres, axes-xy = %1%2</source>
        <translation>coordenadas em metros, axes-xy = %1%2</translation>
    </message>
    <message>
        <source>%1 = %2 is no number</source>
        <translation>%1 = %2 não é número</translation>
    </message>
    <message>
        <source>too many points: divide the file</source>
        <translation>pontos demais: divida o arquivo</translation>
    </message>
    <message>
        <source>&lt;coordinates&gt;: point %1 has no x and y</source>
        <translation>&lt;coordinates&gt;: o ponto %1 não tem x e y</translation>
    </message>
    <message>
        <source>a covariance matrix of more than %1 coordinates</source>
        <translation>uma matriz de covariância de mais de %1 coordenadas</translation>
    </message>
    <message>
        <source>the file has no adjusted coordinates</source>
        <translation>o arquivo não tem coordenadas ajustadas</translation>
    </message>
    <message>
        <source>point %1 has no x and y</source>
        <translation>o ponto %1 não tem x e y</translation>
    </message>
    <message>
        <source>adjusted coordinates in metres</source>
        <translation>coordenadas ajustadas em metros</translation>
    </message>
    <message>
        <source>uncertainties: the file has no &lt;cov-mat&gt;</source>
        <translation>incertezas: o arquivo não tem &lt;cov-mat&gt;</translation>
    </message>
    <message>
        <source>residuals and orientations</source>
        <translation>resíduos e orientações</translation>
    </message>
    <message>
        <source>its dim must be at least the %1 adjusted coordinates, its band less than it</source>
        <translation>seu dim deve ser pelo menos o das %1 coordenadas ajustadas, seu band menor que ele</translation>
    </message>
    <message>
        <source>element %1, %2 is no number</source>
        <translation>o elemento %1, %2 não é número</translation>
    </message>
    <message>
        <source>its dim must be the %1 %2, its band less than that</source>
        <translation>seu dim deve ser o dos %1 %2, seu band menor que isso</translation>
    </message>
    <message>
        <source>element %1, %2: %3 is no number</source>
        <translation>elemento %1, %2: %3 não é número</translation>
    </message>
    <message>
        <source>a covariance matrix of observations that are left out</source>
        <translation>uma matriz de covariância de observações que são omitidas</translation>
    </message>
    <message>
        <source>the standard deviation %1 is no number</source>
        <translation>o desvio-padrão %1 não é número</translation>
    </message>
    <message>
        <source>the standard deviation %1 must not be negative</source>
        <translation>o desvio-padrão %1 não deve ser negativo</translation>
    </message>
    <message>
        <source>, %1 of them without a standard deviation</source>
        <translation>, %1 delas sem desvio-padrão</translation>
    </message>
    <message>
        <source>, %1 correlations</source>
        <translation>, %1 correlações</translation>
    </message>
    <message>
        <source>%1 observations%2%3; each is its own result: write the equations of what you measure with them</source>
        <translation>%1 observações%2%3; cada uma é seu próprio resultado: escreva com elas as equações do que mede</translation>
    </message>
    <message>
        <source>%1 observations: more than %2</source>
        <translation>%1 observações: mais de %2</translation>
    </message>
    <message>
        <source>the stated unit of lengths: words of GSI state theirs</source>
        <translation>a unidade de comprimento declarada: palavras de GSI declaram a sua</translation>
    </message>
    <message>
        <source>words %1 (%2)</source>
        <translation>palavras %1 (%2)</translation>
    </message>
    <message>
        <source>%1 readings of reflectors above their points: the targets are the reflectors</source>
        <translation>%1 leituras de refletores acima de seus pontos: os alvos são os refletores</translation>
    </message>
    <message>
        <source>the file has neither coordinates nor readings with a distance</source>
        <translation>o arquivo não tem coordenadas nem leituras com distância</translation>
    </message>
    <message>
        <source>the reading of %1: angles and a distance are needed</source>
        <translation>a leitura de %1: são precisos ângulos e uma distância</translation>
    </message>
    <message>
        <source>coordinates E, N, H become x, y, z</source>
        <translation>as coordenadas E, N, H passam a x, y, z</translation>
    </message>
    <message>
        <source>%1: more than %2 set-ups; divide the file</source>
        <translation>%1: mais de %2 estacionamentos; divida o arquivo</translation>
    </message>
    <message>
        <source>%1: its coordinates are not in the file: 0, 0, 0</source>
        <translation>%1: suas coordenadas não estão no arquivo: 0, 0, 0</translation>
    </message>
    <message>
        <source>%1: readings of points that have coordinates</source>
        <translation>%1: leituras de pontos que têm coordenadas</translation>
    </message>
    <message>
        <source>%1: readings do not repeat, or are too far apart for it, and say nothing of their uncertainty: points</source>
        <translation>%1: as leituras não se repetem, ou estão afastadas demais para isso, e nada dizem de sua incerteza: pontos</translation>
    </message>
    <message>
        <source>no word of GSI: index, information, sign and data are expected</source>
        <translation>não é palavra de GSI: esperam-se índice, informação, sinal e dados</translation>
    </message>
    <message>
        <source>more than %1 blocks</source>
        <translation>mais de %1 blocos</translation>
    </message>
    <message>
        <source>a block begins with the word 11 or 41</source>
        <translation>um bloco começa com a palavra 11 ou 41</translation>
    </message>
    <message>
        <source>the data of a word must be digits</source>
        <translation>os dados de uma palavra devem ser dígitos</translation>
    </message>
    <message>
        <source>the unit &apos;%1&apos; is none of %2</source>
        <translation>a unidade &apos;%1&apos; não é nenhuma de %2</translation>
    </message>
    <message>
        <source>the file has no blocks of GSI</source>
        <translation>o arquivo não tem blocos de GSI</translation>
    </message>
    <message>
        <source>more than %1 lines are not read</source>
        <translation>mais de %1 linhas não são lidas</translation>
    </message>
    <message>
        <source>the name of a section is not closed by &apos;]&apos;</source>
        <translation>o nome de uma seção não é fechado por &apos;]&apos;</translation>
    </message>
    <message>
        <source>the section %1 stands twice</source>
        <translation>a seção %1 aparece duas vezes</translation>
    </message>
    <message>
        <source>neither a section [...] nor a line name=value of one</source>
        <translation>nem uma seção [...] nem uma linha nome=valor de uma</translation>
    </message>
    <message>
        <source>no quantity with a value and an uncertainty</source>
        <translation>nenhuma grandeza com valor e incerteza</translation>
    </message>
    <message>
        <source>the file has no equation (Model[1]=)</source>
        <translation>o arquivo não tem equação (Model[1]=)</translation>
    </message>
    <message>
        <source>log may be the natural or the decimal logarithm: write ln or log10</source>
        <translation>log pode ser o logaritmo natural ou o decimal: escreva ln ou log10</translation>
    </message>
    <message>
        <source>no file of GUM Workbench: the section [Components] is missing</source>
        <translation>não é arquivo do GUM Workbench: falta a seção [Components]</translation>
    </message>
    <message>
        <source>the section [COMP %1] is missing</source>
        <translation>falta a seção [COMP %1]</translation>
    </message>
    <message>
        <source>more than %1 quantities are not read</source>
        <translation>mais de %1 grandezas não são lidas</translation>
    </message>
    <message>
        <source>%1= is missing</source>
        <translation>falta %1=</translation>
    </message>
    <message>
        <source>quantities of type %1 are not known; those that are: Result, TypBNormal, TypBRectang, TypAPooled</source>
        <translation>grandezas do tipo %1 não são conhecidas; as que são: Result, TypBNormal, TypBRectang, TypAPooled</translation>
    </message>
    <message>
        <source>result %1 as the file states it: %2</source>
        <translation>resultado %1 como o arquivo o declara: %2</translation>
    </message>
    <message>
        <source>section [%1]</source>
        <translation>seção [%1]</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 ponto</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 pontos</translation>
    </message>
    <message>
        <source>1 name occurs again and has got a number: first %1</source>
        <translation>1 nome se repete e recebeu um número: primeiro %1</translation>
    </message>
    <message>
        <source>%1 names occur again and have got a number: first %2</source>
        <translation>%1 nomes se repetem e receberam um número: primeiro %2</translation>
    </message>
    <message>
        <source>%1 groups in one artefact: their names stand before those of the points</source>
        <translation>%1 grupos num padrão: seus nomes ficam antes dos dos pontos</translation>
    </message>
    <message>
        <source>no uncertainties are stated: u_cal is 0 until you state it</source>
        <translation>nenhuma incerteza é declarada: u_cal é 0 até que a declare</translation>
    </message>
    <message>
        <source>u_cal is the largest of the stated standard uncertainties: %1</source>
        <translation>u_cal é a maior das incertezas-padrão declaradas: %1</translation>
    </message>
    <message>
        <source>u_cal as stated: %1</source>
        <translation>u_cal como declarado: %1</translation>
    </message>
    <message>
        <source>%1 without a stated one</source>
        <translation>%1 sem uma declarada</translation>
    </message>
    <message>
        <source>the uncertainty of each point by itself, and correlations: only up to %1 have an analysis of their own</source>
        <translation>a incerteza de cada ponto por si, e correlações: só até %1 têm uma análise própria</translation>
    </message>
    <message>
        <source> and 1 correlation coefficient</source>
        <translation> e 1 coeficiente de correlação</translation>
    </message>
    <message>
        <source> and %1 correlation coefficients</source>
        <translation> e %1 coeficientes de correlação</translation>
    </message>
    <message>
        <source>analysis &apos;Points as stated&apos;: every coordinate with its own uncertainty%1</source>
        <translation>análise &apos;Points as stated&apos;: cada coordenada com sua própria incerteza%1</translation>
    </message>
    <message>
        <source>the file has no points</source>
        <translation>o arquivo não tem pontos</translation>
    </message>
    <message>
        <source>the file has no line &apos;Frame,Time (Seconds),...&apos; with data below</source>
        <translation>o arquivo não tem linha &apos;Frame,Time (Seconds),...&apos; com dados abaixo</translation>
    </message>
    <message>
        <source>the file must begin with &apos;Format Version,&apos;</source>
        <translation>o arquivo deve começar com &apos;Format Version,&apos;</translation>
    </message>
    <message>
        <source>rotations of type %1 are not read: export the take with quaternions</source>
        <translation>rotações do tipo %1 não são lidas: exporte o take com quatérnios</translation>
    </message>
    <message>
        <source>the file does not state its unit of lengths; state it</source>
        <translation>o arquivo não declara sua unidade de comprimento; declare-a</translation>
    </message>
    <message>
        <source>take %1, lengths in %2, coordinate space %3</source>
        <translation>take %1, comprimentos em %2, espaço de coordenadas %3</translation>
    </message>
    <message>
        <source>%1 columns of markers</source>
        <translation>%1 colunas de marcadores</translation>
    </message>
    <message>
        <source>more than %1 rigid bodies are not read</source>
        <translation>mais de %1 corpos rígidos não são lidos</translation>
    </message>
    <message>
        <source>rigid body %1: columns of its rotation (X, Y, Z, W) or position (X, Y, Z) are missing</source>
        <translation>corpo rígido %1: faltam colunas de sua rotação (X, Y, Z, W) ou posição (X, Y, Z)</translation>
    </message>
    <message>
        <source>the take has no rigid body</source>
        <translation>o take não tem corpo rígido</translation>
    </message>
    <message>
        <source>%1 is not a number of a pose</source>
        <translation>%1 não é número de uma pose</translation>
    </message>
    <message>
        <source>the quaternion of %1 has not the length 1</source>
        <translation>o quatérnio de %1 não tem comprimento 1</translation>
    </message>
    <message>
        <source>the angles about z and x of %1 are not determined: turned by 90 degrees about y. Turn the axes of the body in Motive by 90 degrees</source>
        <translation>os ângulos de %1 em torno de z e x não são determinados: girado de 90 graus em torno de y. Gire de 90 graus os eixos do corpo no Motive</translation>
    </message>
    <message>
        <source>%1: %2 frames in which it was not seen</source>
        <translation>%1: %2 quadros em que não foi visto</translation>
    </message>
    <message>
        <source>rigid body %1: at least two frames in which it is seen are needed</source>
        <translation>corpo rígido %1: são precisos pelo menos dois quadros em que é visto</translation>
    </message>
    <message>
        <source>rigid body %1: mean pose of %2 frames, Type A with covariance; the body must not have moved, and the frames are taken as independent</source>
        <translation>corpo rígido %1: pose média de %2 quadros, Tipo A com covariância; o corpo não deve ter-se movido, e os quadros são tomados como independentes</translation>
    </message>
    <message>
        <source>unit &quot;%1&quot;: write it without parentheses</source>
        <translation>unidade &quot;%1&quot;: escreva-a sem parênteses</translation>
    </message>
    <message>
        <source>the exponents are too large</source>
        <translation>os expoentes são grandes demais</translation>
    </message>
    <message>
        <source>%1; state the columns: %2</source>
        <translation>%1; declare as colunas: %2</translation>
    </message>
    <message>
        <source>there is no column %1%2</source>
        <translation>não há coluna %1%2</translation>
    </message>
    <message>
        <source>more than %1 points: divide the file</source>
        <translation>mais de %1 pontos: divida o arquivo</translation>
    </message>
    <message>
        <source> is empty</source>
        <translation> está vazio</translation>
    </message>
    <message>
        <source> is not a number</source>
        <translation> não é um número</translation>
    </message>
    <message>
        <source>: an uncertainty must not be negative</source>
        <translation>: uma incerteza não deve ser negativa</translation>
    </message>
    <message>
        <source> is too large</source>
        <translation> é grande demais</translation>
    </message>
    <message>
        <source>the line has %1 columns instead of %2; put names that contain blanks into quotes</source>
        <translation>a linha tem %1 colunas em vez de %2; ponha entre aspas nomes que contêm espaços</translation>
    </message>
    <message>
        <source>what stands behind column %1</source>
        <translation>o que está depois da coluna %1</translation>
    </message>
    <message>
        <source>lengths are taken as mm: the file does not say its unit</source>
        <translation>os comprimentos são tomados como mm: o arquivo não diz sua unidade</translation>
    </message>
    <message>
        <source>column %1%2</source>
        <translation>coluna %1%2</translation>
    </message>
    <message>
        <source>%1 lines above the headers</source>
        <translation>%1 linhas acima dos cabeçalhos</translation>
    </message>
    <message>
        <source>%1 lines of comment</source>
        <translation>%1 linhas de comentário</translation>
    </message>
    <message>
        <source>the table has no line of headers; state the columns: %1</source>
        <translation>a tabela não tem linha de cabeçalhos; declare as colunas: %1</translation>
    </message>
    <message>
        <source>its columns may mean several things (names that are numbers, offsets, weights, tolerances, notes); state the columns: %1</source>
        <translation>suas colunas podem significar várias coisas (nomes que são números, desvios, pesos, tolerâncias, notas); declare as colunas: %1</translation>
    </message>
    <message>
        <source>six numbers may be X Y Z Ux Uy Uz, but also X Y Z with weights, a vector or the angles of a frame: name the reader if they are uncertainties, or state the columns: %1</source>
        <translation>seis números podem ser X Y Z Ux Uy Uz, mas também X Y Z com pesos, um vetor ou os ângulos de um sistema: nomeie o leitor se forem incertezas, ou declare as colunas: %1</translation>
    </message>
    <message>
        <source>read as %1 (%2)</source>
        <translation>lido como %1 (%2)</translation>
    </message>
    <message>
        <source>%1: the file states no unit, %2 is taken</source>
        <translation>%1: o arquivo não informa unidade, toma-se %2</translation>
    </message>
    <message>
        <source>Analysis &quot;%1&quot; (%2)</source>
        <translation>Análise &quot;%1&quot; (%2)</translation>
    </message>
    <message>
        <source>not taken over</source>
        <translation>não incorporado</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>linha %1: %2</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>e mais %1</translation>
    </message>
    <message>
        <source>and %1 more rows</source>
        <translation>e mais %1 linhas</translation>
    </message>
    <message>
        <source>no reader recognises the file; name the one to read it with</source>
        <translation>nenhum leitor reconhece o arquivo; nomeie aquele com que deve ser lido</translation>
    </message>
    <message>
        <source>several readers recognise the file: %1; name one of them</source>
        <translation>vários leitores reconhecem o arquivo: %1; nomeie um deles</translation>
    </message>
    <message>
        <source>a column cannot be %1; there are %2</source>
        <translation>uma coluna não pode ser %1; há %2</translation>
    </message>
    <message>
        <source>the columns %1 and %2 mean the same; state the columns</source>
        <translation>as colunas %1 e %2 significam o mesmo; declare as colunas</translation>
    </message>
    <message>
        <source>a budget needs columns for the quantity or its name, for an uncertainty (u, U or limits) and one more; state the columns</source>
        <translation>um balanço precisa de colunas para a grandeza ou seu nome, para uma incerteza (u, U ou limites) e de mais uma; declare as colunas</translation>
    </message>
    <message>
        <source>the distribution %1 is not known; there are normal, rectangular, triangular, U-shaped</source>
        <translation>a distribuição %1 não é conhecida; há normal, rectangular, triangular, U-shaped</translation>
    </message>
    <message>
        <source>the divisor must be greater than 0</source>
        <translation>o divisor deve ser maior que 0</translation>
    </message>
    <message>
        <source>an uncertainty must not be negative</source>
        <translation>uma incerteza não deve ser negativa</translation>
    </message>
    <message>
        <source>no uncertainty is stated</source>
        <translation>nenhuma incerteza é declarada</translation>
    </message>
    <message>
        <source>neither divisor, k nor distribution says what the uncertainty %1 is</source>
        <translation>nem divisor, nem k, nem distribuição diz o que é a incerteza %1</translation>
    </message>
    <message>
        <source>a normal distribution needs a divisor or k for the uncertainty %1</source>
        <translation>uma distribuição normal precisa de um divisor ou de k para a incerteza %1</translation>
    </message>
    <message>
        <source>no row has a number in the stated columns</source>
        <translation>nenhuma linha tem número nas colunas declaradas</translation>
    </message>
    <message>
        <source>there is no sheet %1 with cells; there are %2</source>
        <translation>não há folha %1 com células; há %2</translation>
    </message>
    <message>
        <source>the workbook has several sheets, %1: name the sheet whose columns are stated</source>
        <translation>a pasta de trabalho tem várias folhas, %1: nomeie a folha cujas colunas são declaradas</translation>
    </message>
    <message>
        <source>no row of headers of a budget was found; state the columns (quantity, value, unit, U, divisor ...)</source>
        <translation>não foi encontrada linha de cabeçalhos de um balanço; declare as colunas (quantity, value, unit, U, divisor ...)</translation>
    </message>
    <message>
        <source>several sheets have a budget: %1; name one of them</source>
        <translation>várias folhas têm um balanço: %1; nomeie uma delas</translation>
    </message>
    <message>
        <source>a file that it includes: %1</source>
        <translation>um arquivo que ele inclui: %1</translation>
    </message>
    <message>
        <source>the code of a point is expected, a digit</source>
        <translation>espera-se o código de um ponto, um dígito</translation>
    </message>
    <message>
        <source>a point that is not to be used: %1</source>
        <translation>um ponto que não deve ser usado: %1</translation>
    </message>
    <message>
        <source>code, name, x, y, z, three standard deviations and two deflections of the vertical are expected, there are %1 columns</source>
        <translation>esperam-se código, nome, x, y, z, três desvios-padrão e dois desvios da vertical, há %1 colunas</translation>
    </message>
    <message>
        <source>none of their coordinates</source>
        <translation>nenhuma de suas coordenadas</translation>
    </message>
    <message>
        <source>%1 only</source>
        <translation>só %1</translation>
    </message>
    <message>
        <source>standard deviations of %1 points of code %2: it constrains %3</source>
        <translation>desvios-padrão de %1 pontos de código %2: restringe %3</translation>
    </message>
    <message>
        <source>deflections of the vertical of %1 points</source>
        <translation>desvios da vertical de %1 pontos</translation>
    </message>
    <message>
        <source>%1 points are not constrained: their coordinates are approximate ones for the adjustment</source>
        <translation>%1 pontos não são restringidos: suas coordenadas são aproximadas, para o ajustamento</translation>
    </message>
    <message>
        <source>%1 comments</source>
        <translation>%1 comentários</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 não é um número</translation>
    </message>
    <message>
        <source>%1: the constraint of %2, which is switched off</source>
        <translation>%1: a restrição de %2, que está desligada</translation>
    </message>
    <message>
        <source>coordinates in metres</source>
        <translation>coordenadas em metros</translation>
    </message>
    <message>
        <source>the stated unit of lengths: coordinates of Comp3D are in metres</source>
        <translation>a unidade de comprimento declarada: coordenadas do Comp3D são em metros</translation>
    </message>
    <message>
        <source>the code of an observation is expected, a whole number</source>
        <translation>espera-se o código de uma observação, um número inteiro</translation>
    </message>
    <message>
        <source>an observation of code %1</source>
        <translation>uma observação de código %1</translation>
    </message>
    <message>
        <source>code, two points, value, one or two standard deviations and two heights are expected, there are %1 columns</source>
        <translation>esperam-se código, dois pontos, valor, um ou dois desvios-padrão e duas alturas, há %1 colunas</translation>
    </message>
    <message>
        <source>%1 %2: it is switched off</source>
        <translation>%1 %2: está desligado</translation>
    </message>
    <message>
        <source>the file has no observation that is taken</source>
        <translation>o arquivo não tem observação que seja tomada</translation>
    </message>
    <message>
        <source>%1 observations, lengths in metres; each is its own result: write the equations of what you measure with them</source>
        <translation>%1 observações, comprimentos em metros; cada uma é seu próprio resultado: escreva com elas as equações do que mede</translation>
    </message>
    <message>
        <source>the unit of angles must be one of an angle: gon, deg, rad</source>
        <translation>a unidade dos ângulos deve ser de ângulo: gon, deg, rad</translation>
    </message>
    <message>
        <source>%1 %2: the part of its standard deviation that depends on the distance</source>
        <translation>%1 %2: a parte de seu desvio-padrão que depende da distância</translation>
    </message>
    <message>
        <source>%1: it is switched off</source>
        <translation>%1: está desligado</translation>
    </message>
    <message>
        <source>a variance of its covariance matrix is negative</source>
        <translation>uma variância de sua matriz de covariância é negativa</translation>
    </message>
    <message>
        <source>its covariance matrix is not symmetric</source>
        <translation>sua matriz de covariância não é simétrica</translation>
    </message>
    <message>
        <source>its matrix is no covariance matrix: a variance of some combination is negative</source>
        <translation>sua matriz não é de covariância: a variância de alguma combinação é negativa</translation>
    </message>
    <message>
        <source>no Digital Calibration Certificate: its root is &lt;%1&gt;</source>
        <translation>não é um certificado digital de calibração: sua raiz é &lt;%1&gt;</translation>
    </message>
    <message>
        <source>the certificate has no results with numbers</source>
        <translation>o certificado não tem resultados com números</translation>
    </message>
    <message>
        <source>schema version %1</source>
        <translation>versão de esquema %1</translation>
    </message>
    <message>
        <source>what this version of the schema has beyond version 3</source>
        <translation>o que esta versão do esquema tem além da versão 3</translation>
    </message>
    <message>
        <source>the stated unit of lengths: a certificate states its units</source>
        <translation>a unidade de comprimento declarada: um certificado declara suas unidades</translation>
    </message>
    <message>
        <source>%1: &lt;measurementMetaData&gt;</source>
        <translation>%1: &lt;measurementMetaData&gt;</translation>
    </message>
    <message>
        <source>a quantity: more than %1 values</source>
        <translation>uma grandeza: mais de %1 valores</translation>
    </message>
    <message>
        <source>%1 as a length standard: more than %2</source>
        <translation>%1 como padrão de comprimento: mais de %2</translation>
    </message>
    <message>
        <source>the signature: it is not verified</source>
        <translation>a assinatura: não é verificada</translation>
    </message>
    <message>
        <source>%1 values, %2 of them with an uncertainty</source>
        <translation>%1 valores, %2 deles com incerteza</translation>
    </message>
    <message>
        <source>%1 values, %2 of them with an uncertainty, with covariances</source>
        <translation>%1 valores, %2 deles com incerteza, com covariâncias</translation>
    </message>
    <message>
        <source>length standard %1: delete it where the length is no standard</source>
        <translation>padrão de comprimento %1: apague-o se o comprimento não for um padrão</translation>
    </message>
    <message>
        <source>a value as &lt;%1&gt;</source>
        <translation>um valor como &lt;%1&gt;</translation>
    </message>
    <message>
        <source>its relative uncertainty</source>
        <translation>sua incerteza relativa</translation>
    </message>
    <message>
        <source>the same in other units (%1 is taken)</source>
        <translation>o mesmo em outras unidades (toma-se %1)</translation>
    </message>
    <message>
        <source>its lists have different lengths than the %1 values</source>
        <translation>suas listas têm comprimentos diferentes dos %1 valores</translation>
    </message>
    <message>
        <source>its covariance matrix: %1</source>
        <translation>sua matriz de covariância: %1</translation>
    </message>
    <message>
        <source>its covariance matrix has not %1 x %2 elements</source>
        <translation>sua matriz de covariância não tem %1 x %2 elementos</translation>
    </message>
    <message>
        <source>p must be between 0 and 1</source>
        <translation>p deve estar entre 0 e 1</translation>
    </message>
    <message>
        <source>k must be greater than 0</source>
        <translation>k deve ser maior que 0</translation>
    </message>
    <message>
        <source>its uncertainty is negative</source>
        <translation>sua incerteza é negativa</translation>
    </message>
    <message>
        <source>it does not begin with \</source>
        <translation>não começa com \</translation>
    </message>
    <message>
        <source>a brace is not closed</source>
        <translation>uma chave não está fechada</translation>
    </message>
    <message>
        <source>its power &apos;%1&apos; is no small integer</source>
        <translation>sua potência &apos;%1&apos; não é um inteiro pequeno</translation>
    </message>
    <message>
        <source>&apos;\%1&apos; is not known</source>
        <translation>&apos;\%1&apos; não é conhecido</translation>
    </message>
    <message>
        <source>it ends too early</source>
        <translation>termina cedo demais</translation>
    </message>
    <message>
        <source>the unit %1: %2</source>
        <translation>a unidade %1: %2</translation>
    </message>
    <message>
        <source>sheet %1, columns: %2</source>
        <translation>folha %1, colunas: %2</translation>
    </message>
    <message>
        <source>%1 is no number</source>
        <translation>%1 não é número</translation>
    </message>
    <message>
        <source>its unit differs from that of the other uncertainty of the row</source>
        <translation>sua unidade difere da da outra incerteza da linha</translation>
    </message>
    <message>
        <source>%1 is no divisor</source>
        <translation>%1 não é divisor</translation>
    </message>
    <message>
        <source>degrees of freedom must be greater than 0</source>
        <translation>os graus de liberdade devem ser maiores que 0</translation>
    </message>
    <message>
        <source>row %1: %2</source>
        <translation>linha %1: %2</translation>
    </message>
    <message>
        <source>the contribution %1: c and u give %2</source>
        <translation>a contribuição %1: c e u dão %2</translation>
    </message>
    <message>
        <source>the contribution does not follow from c and u in any unit; state the unit behind the coefficient (&apos;-575 nm/K&apos;)</source>
        <translation>a contribuição não decorre de c e u em nenhuma unidade; declare a unidade após o coeficiente (&apos;-575 nm/K&apos;)</translation>
    </message>
    <message>
        <source>its unit makes no coefficient of the result</source>
        <translation>sua unidade não dá um coeficiente do resultado</translation>
    </message>
    <message>
        <source>its unit may be %1 or %2: state it behind the coefficient</source>
        <translation>sua unidade pode ser %1 ou %2: declare-a após o coeficiente</translation>
    </message>
    <message>
        <source>what stands below the budget, to row %1</source>
        <translation>o que está abaixo do balanço, até a linha %1</translation>
    </message>
    <message>
        <source>there is no quantity with an uncertainty below</source>
        <translation>abaixo não há grandeza com incerteza</translation>
    </message>
    <message>
        <source>row without a quantity</source>
        <translation>linha sem grandeza</translation>
    </message>
    <message>
        <source>row %1 without figures</source>
        <translation>linha %1 sem números</translation>
    </message>
    <message>
        <source>the quantity has no name</source>
        <translation>a grandeza não tem nome</translation>
    </message>
    <message>
        <source>row %1: computed anew</source>
        <translation>linha %1: calculada de novo</translation>
    </message>
    <message>
        <source>the unit of the result is not stated: give the result a row of its own, put the unit behind the head of the contributions, or state it as that of &apos;result&apos;</source>
        <translation>a unidade do resultado não é declarada: dê ao resultado uma linha própria, ponha a unidade após o cabeçalho das contribuições, ou declare-a como a de &apos;result&apos;</translation>
    </message>
    <message>
        <source>model: %1; the sheet has sensitivity coefficients only, write your equation instead where you have it</source>
        <translation>modelo: %1; a folha só tem coeficientes de sensibilidade, escreva em seu lugar sua equação onde a tiver</translation>
    </message>
    <message>
        <source>%1 quantities</source>
        <translation>%1 grandezas</translation>
    </message>
    <message>
        <source>sheet %1</source>
        <translation>folha %1</translation>
    </message>
    <message>
        <source>no input quantity has an uncertainty, so that U is 0 everywhere: state the uncertainties of what the analysis uses</source>
        <translation>nenhuma grandeza de entrada tem incerteza, de modo que U é 0 em toda parte: declare as incertezas do que a análise usa</translation>
    </message>
    <message>
        <source>%1; the run is to end at %2 trials and will not be stable then. Choose a larger tolerance or fewer digits</source>
        <translation>%1; a execução deve terminar em %2 ensaios e não estará estável então. Escolha uma tolerância maior ou menos dígitos</translation>
    </message>
    <message>
        <source>it cannot be read</source>
        <translation>não pode ser lido</translation>
    </message>
    <message>
        <source>%1 has no analysis &quot;%2&quot;</source>
        <translation>%1 não tem a análise &quot;%2&quot;</translation>
    </message>
    <message>
        <source>%1 refers to other assets of the project and cannot be kept alone</source>
        <translation>%1 refere-se a outros recursos do projeto e não pode ser mantido sozinho</translation>
    </message>
    <message>
        <source>%1 has errors; open it and repair it before adding to it</source>
        <translation>%1 tem erros; abra-o e corrija-o antes de acrescentar a ele</translation>
    </message>
    <message>
        <source>asset %1: %2</source>
        <translation>recurso %1: %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; refers to the analysis &apos;%2&apos;</source>
        <translation>&apos;%1&apos; refere-se à análise &apos;%2&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; refers to the asset &apos;%2&apos;</source>
        <translation>&apos;%1&apos; refere-se ao recurso &apos;%2&apos;</translation>
    </message>
    <message>
        <source>%1, which does not offer %2</source>
        <translation>%1, que não oferece %2</translation>
    </message>
    <message>
        <source>it cannot be made</source>
        <translation>não pode ser feito</translation>
    </message>
    <message>
        <source>the analysis &apos;%1&apos; has errors of its own: %2</source>
        <translation>a análise &apos;%1&apos; tem erros próprios: %2</translation>
    </message>
    <message>
        <source>%1, which has errors of its own</source>
        <translation>%1, que tem erros próprios</translation>
    </message>
    <message>
        <source>%1, which is of the kind &apos;%2&apos; and does not offer %3</source>
        <translation>%1, que é da espécie &apos;%2&apos; e não oferece %3</translation>
    </message>
    <message>
        <source>%1, which refers back to this one: %2%3</source>
        <translation>%1, que se refere de volta a este: %2%3</translation>
    </message>
    <message>
        <source>%1: only analyses take something from analyses</source>
        <translation>%1: só análises tomam algo de análises</translation>
    </message>
    <message>
        <source>%1, which does not exist%2</source>
        <translation>%1, que não existe%2</translation>
    </message>
    <message>
        <source>the values given lead to a %1</source>
        <translation>os valores dados levam a: %1</translation>
    </message>
    <message>
        <source>the memory of this machine does not suffice</source>
        <translation>a memória desta máquina não basta</translation>
    </message>
    <message>
        <source>a defect of the program was met (%1): please report it with the project</source>
        <translation>encontrou-se um defeito do programa (%1): relate-o com o projeto</translation>
    </message>
    <message>
        <source>%1: the part is damaged or no part at all: delete it and make it anew</source>
        <translation>%1: a parte está danificada ou não é uma parte: apague-a e faça-a de novo</translation>
    </message>
    <message>
        <source>%1: the part was made %2 %3, this is %4: the bits of its results would not be those of one run</source>
        <translation>%1: a parte foi feita com %2 %3, isto é %4: os bits de seus resultados não seriam os de uma só execução</translation>
    </message>
    <message>
        <source>%1: the part would have %2 MB, more than %3: divide the run into more parts</source>
        <translation>%1: a parte teria %2 MB, mais que %3: divida a execução em mais partes</translation>
    </message>
    <message>
        <source>%1: the part is of &quot;%2&quot;, which is not evaluated here: it is of another project</source>
        <translation>%1: a parte é de &quot;%2&quot;, que não é avaliado aqui: é de outro projeto</translation>
    </message>
    <message>
        <source>%1: the part is of &quot;%2&quot; in another project or another state of it (fingerprint %3, here %4): make it anew</source>
        <translation>%1: a parte é de &quot;%2&quot; em outro projeto ou em outro estado dele (impressão digital %3, aqui %4): faça-a de novo</translation>
    </message>
    <message>
        <source>the model cannot be made</source>
        <translation>o modelo não pode ser formado</translation>
    </message>
    <message>
        <source>there is no component &apos;%1&apos; here</source>
        <translation>não há componente &apos;%1&apos; aqui</translation>
    </message>
    <message>
        <source>there is no input quantity &apos;%1&apos; here</source>
        <translation>não há grandeza de entrada &apos;%1&apos; aqui</translation>
    </message>
    <message>
        <source>the analysis has no study &apos;%1&apos;</source>
        <translation>a análise não tem o estudo &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the study was stopped</source>
        <translation>o estudo foi interrompido</translation>
    </message>
    <message>
        <source>the analysis does not use the asset &apos;%1&apos;: varying it changes nothing</source>
        <translation>a análise não usa o recurso &apos;%1&apos;: variá-lo não muda nada</translation>
    </message>
    <message>
        <source>the model shows no instruments: a least distance and boxes to keep out of mean nothing to it</source>
        <translation>o modelo não mostra instrumentos: uma menor distância e caixas a evitar não significam nada para ele</translation>
    </message>
    <message>
        <source>the model shows no lines of sight, so that no box can hide them</source>
        <translation>o modelo não mostra linhas de visada, de modo que nenhuma caixa pode escondê-las</translation>
    </message>
    <message>
        <source>the analysis has no design &apos;%1&apos;</source>
        <translation>a análise não tem o planejamento &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the variances are not a sum over what is reduced: some of it is correlated, or changes more than a component of uncertainty</source>
        <translation>as variâncias não são uma soma sobre o que é reduzido: parte disso é correlacionada, ou muda mais de uma componente de incerteza</translation>
    </message>
    <message>
        <source>the analysis has no measurand that a design could look at</source>
        <translation>a análise não tem mensurando que um planejamento possa observar</translation>
    </message>
    <message>
        <source>without target uncertainties U is looked at relative to that of the present design, which has no result (%1): state requirements</source>
        <translation>sem incertezas-alvo, U é observado em relação ao do planejamento atual, que não tem resultado (%1): declare requisitos</translation>
    </message>
    <message>
        <source>U of &apos;%1&apos; is zero now: choose the outputs to look at</source>
        <translation>U de &apos;%1&apos; é agora zero: escolha as saídas a observar</translation>
    </message>
    <message>
        <source>the cheapest reductions need target uncertainties: state requirements</source>
        <translation>as reduções mais baratas precisam de incertezas-alvo: declare requisitos</translation>
    </message>
    <message>
        <source>the cheapest rows need target uncertainties: state requirements</source>
        <translation>as linhas mais baratas precisam de incertezas-alvo: declare requisitos</translation>
    </message>
    <message>
        <source>the design was stopped</source>
        <translation>o planejamento foi interrompido</translation>
    </message>
    <message>
        <source>the set-up</source>
        <translation>a configuração</translation>
    </message>
    <message>
        <source>the component &apos;%1&apos; is not of one input quantity alone: change it where it comes from (%2)</source>
        <translation>a componente &apos;%1&apos; não é de uma só grandeza de entrada: mude-a na sua origem (%2)</translation>
    </message>
    <message>
        <source>Distribution of %1.</source>
        <translation>Distribuição de %1.</translation>
    </message>
    <message>
        <source>Quantiles of %1, the least normal, against those of a normal distribution.</source>
        <translation>Quantis de %1, a menos normal, contra os de uma distribuição normal.</translation>
    </message>
    <message>
        <source>Standard uncertainty of %1 against the number of trials.</source>
        <translation>Incerteza-padrão de %1 contra o número de ensaios.</translation>
    </message>
    <message>
        <source>%1: uncertainty ellipsoids at a coverage probability of %2, magnified as the picture states.</source>
        <translation>%1: elipsoides de incerteza com probabilidade de abrangência de %2, ampliados como a figura informa.</translation>
    </message>
    <message>
        <source>Correlation coefficients of components</source>
        <translation>Coeficientes de correlação das componentes</translation>
    </message>
    <message>
        <source>Component</source>
        <translation>Componente</translation>
    </message>
    <message>
        <source>Notes on input quantities</source>
        <translation>Notas sobre grandezas de entrada</translation>
    </message>
    <message>
        <source>Input quantities and the origin of their uncertainties</source>
        <translation>Grandezas de entrada e origem de suas incertezas</translation>
    </message>
    <message>
        <source>%1 input quantities; many with equal components share a row. The CSV table of inputs lists every one with its estimate.</source>
        <translation>%1 grandezas de entrada; muitas com componentes iguais compartilham uma linha. A tabela CSV das entradas contém todas com sua estimativa.</translation>
    </message>
    <message>
        <source>These input quantities are results of other analyses. All are evaluated together as one model, in every trial, so that the budget goes down to the components of the analyses that they come from; a component that reaches the result on several ways is one component.</source>
        <translation>Estas grandezas de entrada são resultados de outras análises. Todas são avaliadas juntas como um só modelo, em cada ensaio, de modo que o balanço desce até as componentes das análises de onde vêm; uma componente que chega ao resultado por vários caminhos é uma só componente.</translation>
    </message>
    <message>
        <source>Linearised: the analysis that the value comes from is replaced by its law of propagation about its estimates. That is exact to first order; its non-linearity is left out of Monte Carlo.</source>
        <translation>Linearizado: a análise de onde vem o valor é substituída por sua lei de propagação em torno de suas estimativas. É exato em primeira ordem; sua não linearidade não entra em Monte Carlo.</translation>
    </message>
    <message>
        <source>Where the inputs come from</source>
        <translation>De onde vêm as entradas</translation>
    </message>
    <message>
        <source>Input quantities taken from other analyses</source>
        <translation>Grandezas de entrada tomadas de outras análises</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>Análise</translation>
    </message>
    <message>
        <source>Its result</source>
        <translation>Seu resultado</translation>
    </message>
    <message>
        <source>%1, linearised</source>
        <translation>%1, linearizado</translation>
    </message>
    <message>
        <source>The trials are Sobol points with a random digital shift in each batch; standard errors are from the scatter of the batches.</source>
        <translation>Os ensaios são pontos de Sobol com um deslocamento digital aleatório em cada lote; os erros-padrão vêm da dispersão dos lotes.</translation>
    </message>
    <message>
        <source>Mean, standard uncertainty, symmetric interval and covariance were found with the linear part of each output as control variate: its distribution is known exactly, and the trials tell how the output differs from it. Shortest intervals, histograms and probabilities of conformance are those of the trials.</source>
        <translation>Média, incerteza-padrão, intervalo simétrico e covariância foram obtidos com a parte linear de cada grandeza de saída como variável de controle: sua distribuição é conhecida exatamente, e os ensaios dizem como a saída difere dela. Intervalos mais curtos, histogramas e probabilidades de conformidade são os dos ensaios.</translation>
    </message>
    <message>
        <source>At the interval ends each trial is worth %1 plain ones or more.</source>
        <translation>Nos extremos do intervalo cada ensaio vale por %1 simples ou mais.</translation>
    </message>
    <message>
        <source>The adaptive procedure reached its largest number of trials: the results have not stabilised to the numerical tolerance.</source>
        <translation>O procedimento adaptativo atingiu seu maior número de ensaios: os resultados não se estabilizaram dentro da tolerância numérica.</translation>
    </message>
    <message>
        <source>Coverage intervals were read from finely divided cells, not from ordered trials: there were more trials than memory allows to order.</source>
        <translation>Os intervalos de abrangência foram lidos de células finamente divididas, não de ensaios ordenados: havia mais ensaios do que a memória permite ordenar.</translation>
    </message>
    <message>
        <source>law of propagation</source>
        <translation>lei de propagação</translation>
    </message>
    <message>
        <source>adaptive</source>
        <translation>adaptativo</translation>
    </message>
    <message>
        <source>%1, Sobol points</source>
        <translation>%1, pontos de Sobol</translation>
    </message>
    <message>
        <source>%1, control variate</source>
        <translation>%1, variável de controle</translation>
    </message>
    <message>
        <source>Runs that gave these results</source>
        <translation>Execuções que deram estes resultados</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Falhou</translation>
    </message>
    <message>
        <source>Fingerprint</source>
        <translation>Impressão digital</translation>
    </message>
    <message>
        <source>The same project, seed and version give the same numbers on any number of threads. The fingerprint covers everything that influences the numbers of an analysis.</source>
        <translation>O mesmo projeto, semente e versão dão os mesmos números com qualquer número de threads. A impressão digital abrange tudo o que influencia os números de uma análise.</translation>
    </message>
    <message>
        <source>Factors by which the standard uncertainties are to be multiplied so that all measurands of a group lie in the region together with a probability of %1 (JCGM 102 6.5 and 7.7).</source>
        <translation>Fatores pelos quais as incertezas-padrão devem ser multiplicadas para que todos os mensurandos de um grupo estejam juntos na região com probabilidade %1 (JCGM 102 6.5 e 7.7).</translation>
    </message>
    <message>
        <source>Factors of the coverage regions</source>
        <translation>Fatores das regiões de abrangência</translation>
    </message>
    <message>
        <source>No ellipsoid is given where the covariance matrix of the group is singular.</source>
        <translation>Não se dá elipsoide onde a matriz de covariância do grupo é singular.</translation>
    </message>
    <message>
        <source>Target uncertainties</source>
        <translation>Incertezas-alvo</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredito</translation>
    </message>
    <message>
        <source>With the figure put in, U by the law of propagation is the target; k follows the effective degrees of freedom.</source>
        <translation>Com o número posto, U pela lei de propagação é o alvo; k segue os graus de liberdade efetivos.</translation>
    </message>
    <message>
        <source>With the figure put in, U by Monte Carlo is the target; found with %1 trials of the same draws.</source>
        <translation>Com o número posto, U por Monte Carlo é o alvo; encontrado com %1 ensaios dos mesmos sorteios.</translation>
    </message>
    <message>
        <source>No component suffices alone: all standard uncertainties multiplied by %1 do.</source>
        <translation>Nenhuma componente basta sozinha: todas as incertezas-padrão multiplicadas por %1 bastam.</translation>
    </message>
    <message>
        <source>What one component alone must be reduced to for U(%1) to meet its target</source>
        <translation>A que uma componente sozinha deve ser reduzida para que U(%1) atenda seu alvo</translation>
    </message>
    <message>
        <source>needed</source>
        <translation>necessário</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Comentário</translation>
    </message>
    <message>
        <source>not enough by itself, even if it vanished</source>
        <translation>não basta sozinha, mesmo que desaparecesse</translation>
    </message>
    <message>
        <source>%1: specific consumer&apos;s risk %2 of this decision.</source>
        <translation>%1: risco específico do consumidor %2 desta decisão.</translation>
    </message>
    <message>
        <source>%1: specific producer&apos;s risk %2 of this decision.</source>
        <translation>%1: risco específico do produtor %2 desta decisão.</translation>
    </message>
    <message>
        <source>%1: specific consumer&apos;s risk %2 of this decision; global risks of the rule for its prior: consumer&apos;s %3, producer&apos;s %4.</source>
        <translation>%1: risco específico do consumidor %2 desta decisão; riscos globais da regra para sua distribuição a priori: consumidor %3, produtor %4.</translation>
    </message>
    <message>
        <source>%1: specific producer&apos;s risk %2 of this decision; global risks of the rule for its prior: consumer&apos;s %3, producer&apos;s %4.</source>
        <translation>%1: risco específico do produtor %2 desta decisão; riscos globais da regra para sua distribuição a priori: consumidor %3, produtor %4.</translation>
    </message>
    <message>
        <source>Conformity with tolerances</source>
        <translation>Conformidade com tolerâncias</translation>
    </message>
    <message>
        <source>The requirements are not judged: %1.</source>
        <translation>Os requisitos não são julgados: %1.</translation>
    </message>
    <message>
        <source>U of</source>
        <translation>U de</translation>
    </message>
    <message>
        <source>Coverage probability %1.</source>
        <translation>Probabilidade de abrangência %1.</translation>
    </message>
    <message>
        <source>Values from the law of propagation of uncertainty (JCGM 100).</source>
        <translation>Valores da lei de propagação de incertezas (JCGM 100).</translation>
    </message>
    <message>
        <source>Values from the propagation of distributions (JCGM 101) with %1 trials; the interval is probabilistically symmetric, the shortest one beside it. The effective degrees of freedom are those of the law of propagation.</source>
        <translation>Valores da propagação de distribuições (JCGM 101) com %1 ensaios; o intervalo é probabilisticamente simétrico, com o mais curto ao lado. Os graus de liberdade efetivos são os da lei de propagação.</translation>
    </message>
    <message>
        <source>Components with finite degrees of freedom are drawn from normal distributions, as was chosen: U and k leave these degrees of freedom out, unlike k of the law of propagation (JCGM 100 G.6.4).</source>
        <translation>As componentes com graus de liberdade finitos são sorteadas de distribuições normais, como foi escolhido: U e k não levam em conta esses graus de liberdade, ao contrário do k da lei de propagação (JCGM 100 G.6.4).</translation>
    </message>
    <message>
        <source>This result does not represent the measurand: %1 trials, more than 1 %, have no value.</source>
        <translation>Este resultado não representa o mensurando: %1 ensaios, mais de 1 %, não têm valor.</translation>
    </message>
    <message>
        <source>Law of propagation with second-order terms</source>
        <translation>Lei de propagação com termos de segunda ordem</translation>
    </message>
    <message>
        <source>JCGM 100 5.1.2, NOTE, for independent components with symmetric distributions. The shift, half the sum of the second derivatives times the variances, is what the mean of the measurand differs by from the value at the estimates; neither is part of the results above.</source>
        <translation>JCGM 100 5.1.2, NOTA, para componentes independentes com distribuições simétricas. O deslocamento, metade da soma das segundas derivadas vezes as variâncias, é o quanto a média do mensurando difere do valor nas estimativas; nenhum dos dois faz parte dos resultados acima.</translation>
    </message>
    <message>
        <source>Measurands</source>
        <translation>Mensurandos</translation>
    </message>
    <message>
        <source>Intermediate quantities</source>
        <translation>Grandezas intermediárias</translation>
    </message>
    <message>
        <source>Read from %1.</source>
        <translation>Lido de %1.</translation>
    </message>
    <message>
        <source>The first %1 of %2 rows; the project file has them all.</source>
        <translation>As primeiras %1 de %2 linhas; o arquivo do projeto contém todas.</translation>
    </message>
    <message>
        <source>Sobol indices of %1 in %</source>
        <translation>Índices de Sobol de %1 em %</translation>
    </message>
    <message>
        <source>first order of the law of propagation</source>
        <translation>primeira ordem da lei de propagação</translation>
    </message>
    <message>
        <source>standard error of S</source>
        <translation>erro-padrão de S</translation>
    </message>
    <message>
        <source>S total</source>
        <translation>S total</translation>
    </message>
    <message>
        <source>standard error of S total</source>
        <translation>erro-padrão de S total</translation>
    </message>
    <message>
        <source>%1 components with smaller indices are left out.</source>
        <translation>%1 componentes com índices menores foram omitidas.</translation>
    </message>
    <message>
        <source>Sobol indices</source>
        <translation>Índices de Sobol</translation>
    </message>
    <message>
        <source>S is the share of the variance that a component causes by itself, S total the share with all its interactions with others: where both agree and the shares sum to 100 %, the measurement model is additive. Components that are correlated have indices together. By Monte Carlo with %1 pairs of trials.</source>
        <translation>S é a parcela da variância que uma componente causa por si, S total a parcela com todas as suas interações com outras: onde ambas concordam e as parcelas somam 100 %, o modelo de medição é aditivo. Componentes correlacionadas têm índices em conjunto. Por Monte Carlo com %1 pares de ensaios.</translation>
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
        <translation>Avaliado em %1 pontos da malha, com %2 ensaios em cada um.</translation>
    </message>
    <message>
        <source>Evaluated at %1 grid points, by the law of propagation of uncertainty.</source>
        <translation>Avaliado em %1 pontos da malha, pela lei de propagação de incertezas.</translation>
    </message>
    <message>
        <source>Varied: %1.</source>
        <translation>Variado: %1.</translation>
    </message>
    <message>
        <source>The CSV table of the study has all output quantities.</source>
        <translation>A tabela CSV do estudo contém todas as grandezas de saída.</translation>
    </message>
    <message>
        <source>%1: best and worst grid points</source>
        <translation>%1: melhor e pior ponto da malha</translation>
    </message>
    <message>
        <source>least</source>
        <translation>menor</translation>
    </message>
    <message>
        <source>greatest</source>
        <translation>maior</translation>
    </message>
    <message>
        <source>What is given for %1 of the grid points does not represent the measurand: more than 1 % of their trials have no value (see the CSV table).</source>
        <translation>O que se dá para %1 dos pontos da malha não representa o mensurando: mais de 1 % de seus ensaios não têm valor (ver a tabela CSV).</translation>
    </message>
    <message>
        <source>%1 grid points have no values:</source>
        <translation>%1 pontos da malha não têm valores:</translation>
    </message>
    <message>
        <source>others: see the CSV table of the study</source>
        <translation>outros: ver a tabela CSV do estudo</translation>
    </message>
    <message>
        <source>law of propagation of uncertainty</source>
        <translation>lei de propagação de incertezas</translation>
    </message>
    <message>
        <source>adaptive Monte Carlo, %1 trials</source>
        <translation>Monte Carlo adaptativo, %1 ensaios</translation>
    </message>
    <message>
        <source>Monte Carlo, %1 trials</source>
        <translation>Monte Carlo, %1 ensaios</translation>
    </message>
    <message>
        <source>%1; %2; coverage probability %3</source>
        <translation>%1; %2; probabilidade de abrangência %3</translation>
    </message>
    <message>
        <source>k, intervals and the law of propagation are in the results of the analysis.</source>
        <translation>k, intervalos e a lei de propagação estão nos resultados da análise.</translation>
    </message>
    <message>
        <source>Not evaluated: %1: %2.</source>
        <translation>Não avaliado: %1: %2.</translation>
    </message>
    <message>
        <source>Study &quot;%1&quot; not evaluated: %2: %3.</source>
        <translation>Estudo &quot;%1&quot; não avaliado: %2: %3.</translation>
    </message>
    <message>
        <source>Expanded uncertainty U: %1</source>
        <translation>Incerteza expandida U: %1</translation>
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
        <translation>Avaliado com</translation>
    </message>
    <message>
        <source>Not in this report</source>
        <translation>Não está neste relatório</translation>
    </message>
    <message>
        <source>Project fingerprint</source>
        <translation>Impressão digital do projeto</translation>
    </message>
    <message>
        <source>Evaluated with an earlier analysis: %1.</source>
        <translation>Avaliado com uma análise anterior: %1.</translation>
    </message>
    <message>
        <source>Budget of %1, %2</source>
        <translation>Balanço de %1, %2</translation>
    </message>
    <message>
        <source>%1 further components</source>
        <translation>mais %1 componentes</translation>
    </message>
    <message>
        <source>combined (law of propagation)</source>
        <translation>combinada (lei de propagação)</translation>
    </message>
    <message>
        <source>%1 = %2, u_c = %3, effective degrees of freedom %4, k = %5, p = %6 (law of propagation).</source>
        <translation>%1 = %2, u_c = %3, graus de liberdade efetivos %4, k = %5, p = %6 (lei de propagação).</translation>
    </message>
    <message>
        <source>Shares of the variance in % by %1, %2</source>
        <translation>Parcelas da variância em % por %1, %2</translation>
    </message>
    <message>
        <source>together</source>
        <translation>em conjunto</translation>
    </message>
    <message>
        <source>other</source>
        <translation>outros</translation>
    </message>
    <message>
        <source>Components by falling share of the variance; cᵢ in the unit of the measurand per unit of the component.</source>
        <translation>Componentes por parcela decrescente da variância; cᵢ na unidade do mensurando por unidade da componente.</translation>
    </message>
    <message>
        <source>Contributions to the variance of %1.</source>
        <translation>Contribuições para a variância de %1.</translation>
    </message>
    <message>
        <source>Estimates and standard uncertainties by both methods</source>
        <translation>Estimativas e incertezas-padrão pelos dois métodos</translation>
    </message>
    <message>
        <source>Where a distribution is too skewed, heavy-tailed or flat for k u, state its coverage interval.</source>
        <translation>Onde uma distribuição for assimétrica, de caudas pesadas ou achatada demais para k u, declare seu intervalo de abrangência.</translation>
    </message>
    <message>
        <source>The expanded uncertainty U beside what remains of it when everything that a contributor brings in is kept at its estimate (an ideal one), and what that contributor gives alone, with the same coverage factor.</source>
        <translation>A incerteza expandida U ao lado do que resta dela quando tudo o que uma contribuição traz é mantido em sua estimativa (uma ideal), e o que essa contribuição dá sozinha, com o mesmo fator de abrangência.</translation>
    </message>
    <message>
        <source>By Monte Carlo with %1 trials.</source>
        <translation>Por Monte Carlo com %1 ensaios.</translation>
    </message>
    <message>
        <source>By the law of propagation.</source>
        <translation>Pela lei de propagação.</translation>
    </message>
    <message>
        <source>Without %1, %2 trials had no value.</source>
        <translation>Sem %1, %2 ensaios não tiveram valor.</translation>
    </message>
    <message>
        <source>U without each contributor, and of it alone</source>
        <translation>U sem cada contribuição, e só com ela</translation>
    </message>
    <message>
        <source>without %1</source>
        <translation>sem %1</translation>
    </message>
    <message>
        <source>%1 alone</source>
        <translation>só %1</translation>
    </message>
    <message>
        <source>Of two contributors, what remains without one is what the other gives alone.</source>
        <translation>De duas contribuições, o que resta sem uma é o que a outra dá sozinha.</translation>
    </message>
    <message>
        <source>Results by contributor</source>
        <translation>Resultados por contribuição</translation>
    </message>
    <message>
        <source>Correlation coefficients, %1</source>
        <translation>Coeficientes de correlação, %1</translation>
    </message>
    <message>
        <source>Between groups, which share input quantities, the largest coefficient is %1.</source>
        <translation>Entre grupos que compartilham grandezas de entrada, o maior coeficiente é %1.</translation>
    </message>
    <message>
        <source>Between groups, which share input quantities, the largest coefficient is %1, of %2 with %3.</source>
        <translation>Entre grupos que compartilham grandezas de entrada, o maior coeficiente é %1, de %2 com %3.</translation>
    </message>
    <message>
        <source>The CSV table of correlations has all of them.</source>
        <translation>A tabela CSV das correlações contém todas.</translation>
    </message>
    <message>
        <source>Looked for: the smallest %1.</source>
        <translation>Procurou-se: o menor %1.</translation>
    </message>
    <message>
        <source>Looked for: the cheapest reductions of uncertainty with which all targets are met.</source>
        <translation>Procuraram-se: as reduções de incerteza mais baratas com que todos os alvos são atendidos.</translation>
    </message>
    <message>
        <source>Looked for: the cheapest rows with which all targets are met.</source>
        <translation>Procuraram-se: as linhas mais baratas com que todos os alvos são atendidos.</translation>
    </message>
    <message>
        <source>Cost: %1.</source>
        <translation>Custo: %1.</translation>
    </message>
    <message>
        <source>Found: %1, before %2.</source>
        <translation>Encontrado: %1, antes %2.</translation>
    </message>
    <message>
        <source>Found: %1.</source>
        <translation>Encontrado: %1.</translation>
    </message>
    <message>
        <source>Nothing that was tried has a result.</source>
        <translation>Nada do que foi tentado tem resultado.</translation>
    </message>
    <message>
        <source>%1 candidates were evaluated by the law of propagation of uncertainty, all that there are.</source>
        <translation>Foram avaliados %1 candidatos pela lei de propagação de incertezas, todos os que existem.</translation>
    </message>
    <message>
        <source>%1 candidates were evaluated by the law of propagation of uncertainty.</source>
        <translation>Foram avaliados %1 candidatos pela lei de propagação de incertezas.</translation>
    </message>
    <message>
        <source>Verified by Monte Carlo with %1 trials.</source>
        <translation>Verificado por Monte Carlo com %1 ensaios.</translation>
    </message>
    <message>
        <source>Not every target is met: what is given is the best that was found.</source>
        <translation>Nem todos os alvos são atendidos: o que se dá é o melhor que foi encontrado.</translation>
    </message>
    <message>
        <source>%1: the way of the search to the best place, coloured by the objective.</source>
        <translation>%1: o caminho da busca até o melhor lugar, colorido pelo objetivo.</translation>
    </message>
    <message>
        <source>%1: the candidates, coloured by what they gain; the larger ones are chosen.</source>
        <translation>%1: os candidatos, coloridos pelo que ganham; os maiores são os escolhidos.</translation>
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
        <translation>%1 componentes, soma aritmética</translation>
    </message>
    <message>
        <source>%1 components, in quadrature</source>
        <translation>%1 componentes, soma quadrática</translation>
    </message>
    <message>
        <source>Table %1. %2</source>
        <translation>Tabela %1. %2</translation>
    </message>
    <message>
        <source>Figure %1. %2</source>
        <translation>Figura %1. %2</translation>
    </message>
    <message>
        <source>Uncertainty report</source>
        <translation>Relatório de incerteza</translation>
    </message>
    <message>
        <source>Report of an uncertainty evaluation</source>
        <translation>Relatório de uma avaliação de incerteza</translation>
    </message>
    <message>
        <source>Annex</source>
        <translation>Anexo</translation>
    </message>
    <message>
        <source>In the annex: %1.</source>
        <translation>No anexo: %1.</translation>
    </message>
    <message>
        <source>In the annex, on request: %1.</source>
        <translation>No anexo, a pedido: %1.</translation>
    </message>
    <message>
        <source>The first %1 of %2 rows; the annex has all of them.</source>
        <translation>As primeiras %1 de %2 linhas; o anexo contém todas.</translation>
    </message>
    <message>
        <source>The first %1 of %2 rows; the CSV tables, and the annex on request, have all of them.</source>
        <translation>As primeiras %1 de %2 linhas; as tabelas CSV e, a pedido, o anexo contêm todas.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables; the annex has the rest.</source>
        <translation>São mostradas %1 de %2 tabelas; o anexo contém o resto.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables; the CSV tables, and the annex on request, have the rest.</source>
        <translation>São mostradas %1 de %2 tabelas; as tabelas CSV e, a pedido, o anexo contêm o resto.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 charts; the annex has the rest.</source>
        <translation>São mostrados %1 de %2 gráficos; o anexo contém o resto.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 charts; the CSV tables, and the annex on request, have the rest.</source>
        <translation>São mostrados %1 de %2 gráficos; as tabelas CSV e, a pedido, o anexo contêm o resto.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables and %3 of %4 charts; the annex has the rest.</source>
        <translation>São mostradas %1 de %2 tabelas e %3 de %4 gráficos; o anexo contém o resto.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables and %3 of %4 charts; the CSV tables, and the annex on request, have the rest.</source>
        <translation>São mostradas %1 de %2 tabelas e %3 de %4 gráficos; as tabelas CSV e, a pedido, o anexo contêm o resto.</translation>
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
        <translation>Depois</translation>
    </message>
    <message>
        <source>U is stated by different rules: before, %1 After, %2</source>
        <translation>U é declarado por regras diferentes: antes, %1 Depois, %2</translation>
    </message>
    <message>
        <source>%1 of %2 measurands are in both results; the budgets of %3 of them differ.</source>
        <translation>%1 de %2 mensurandos estão em ambos os resultados; os balanços de %3 deles diferem.</translation>
    </message>
    <message>
        <source>Shown are the %1 whose standard uncertainty changes most, relative to what it was.</source>
        <translation>São mostradas as %1 cuja incerteza-padrão mais muda, em relação ao que era.</translation>
    </message>
    <message>
        <source>Distribution of %1 before and after.</source>
        <translation>Distribuição de %1 antes e depois.</translation>
    </message>
    <message>
        <source>Comparison of uncertainty evaluations</source>
        <translation>Comparação de avaliações de incerteza</translation>
    </message>
    <message>
        <source>Only before: %1.</source>
        <translation>Só antes: %1.</translation>
    </message>
    <message>
        <source>Only after: %1.</source>
        <translation>Só depois: %1.</translation>
    </message>
    <message>
        <source>this report</source>
        <translation>este relatório</translation>
    </message>
    <message>
        <source>there are no results for the certificate to state</source>
        <translation>não há resultados que o certificado possa declarar</translation>
    </message>
    <message>
        <source>the standard uncertainty of %1 is not finite; a Digital Calibration Certificate has no place for that</source>
        <translation>a incerteza-padrão de %1 não é finita; um certificado digital de calibração não tem lugar para isso</translation>
    </message>
    <message>
        <source>there is no robot to write: no analysis uses or finds one</source>
        <translation>não há robô a escrever: nenhuma análise usa ou encontra um</translation>
    </message>
    <message>
        <source>the file is of one robot, and there are %1: choose an analysis that uses or finds the one to write (--analysis)</source>
        <translation>o arquivo é de um robô e há %1: escolha uma análise que use ou encontre o que se quer escrever (--analysis)</translation>
    </message>
    <message>
        <source>there are no points to write: no analysis has a result with coordinates x, y, z of a point</source>
        <translation>não há pontos a escrever: nenhuma análise tem resultado com coordenadas x, y, z de um ponto</translation>
    </message>
    <message>
        <source>robot %1: the file is of six joints that turn (shoulder to wrist_3); write it as URDF</source>
        <translation>robô %1: o arquivo é de seis juntas que giram (shoulder a wrist_3); escreva-o como URDF</translation>
    </message>
    <message>
        <source>there are no results to write</source>
        <translation>não há resultados a escrever</translation>
    </message>
    <message>
        <source>the workbook cannot be made in the folder for temporary files</source>
        <translation>a pasta de trabalho não pode ser criada na pasta de arquivos temporários</translation>
    </message>
    <message>
        <source>the report carries no results to compare with (results.json)</source>
        <translation>o relatório não traz resultados para comparar (results.json)</translation>
    </message>
    <message>
        <source>what the report carries as results.json is none of Covaria</source>
        <translation>o que o relatório traz como results.json não é da Covaria</translation>
    </message>
    <message>
        <source>no folder could be made in %1: %2</source>
        <translation>não foi possível criar uma pasta em %1: %2</translation>
    </message>
    <message>
        <source>the attached file %1 would leave its folder; nothing was taken out</source>
        <translation>o arquivo anexo %1 sairia de sua pasta; nada foi extraído</translation>
    </message>
    <message>
        <source>the attached file %1 cannot be taken out: another one is in its way</source>
        <translation>o arquivo anexo %1 não pode ser extraído: há outro no caminho</translation>
    </message>
    <message>
        <source>it is no PDF</source>
        <translation>não é um PDF</translation>
    </message>
    <message>
        <source>it carries no project: it is no report of Covaria, or one of a version before 0.2.0, or another program has written it anew</source>
        <translation>não traz nenhum projeto: não é um relatório da Covaria, ou é de uma versão anterior a 0.2.0, ou outro programa o gravou de novo</translation>
    </message>
    <message>
        <source>best</source>
        <translation>melhor</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>pior</translation>
    </message>
    <message>
        <source>iso-surfaces at %1</source>
        <translation>isossuperfícies em %1</translation>
    </message>
    <message>
        <source>the study has not been run</source>
        <translation>o estudo não foi executado</translation>
    </message>
    <message>
        <source>none of the study&apos;s output quantities has a place in space</source>
        <translation>nenhuma das grandezas de saída do estudo tem lugar no espaço</translation>
    </message>
    <message>
        <source>the point %1 does not move in this study</source>
        <translation>o ponto %1 não se move neste estudo</translation>
    </message>
    <message>
        <source>best: %1</source>
        <translation>melhor: %1</translation>
    </message>
    <message>
        <source>nothing that this design chooses stands in space</source>
        <translation>nada do que este planejamento escolhe está no espaço</translation>
    </message>
    <message>
        <source>nothing that was tried has a result</source>
        <translation>nada do que foi tentado tem resultado</translation>
    </message>
    <message>
        <source>candidates; the larger %1 of %2 are chosen</source>
        <translation>candidatos; os %1 maiores de %2 são os escolhidos</translation>
    </message>
    <message>
        <source>gain: by how much the uncertainty is smaller with this candidate than without it, the others as chosen</source>
        <translation>ganho: quanto a incerteza é menor com este candidato do que sem ele, os demais como escolhidos</translation>
    </message>
    <message>
        <source>best so far, in the order of the search</source>
        <translation>o melhor até agora, na ordem da busca</translation>
    </message>
    <message>
        <source>dashed: where it may stand</source>
        <translation>tracejado: onde pode ficar</translation>
    </message>
    <message>
        <source>analysis</source>
        <translation>análise</translation>
    </message>
    <message>
        <source>kind</source>
        <translation>tipo</translation>
    </message>
    <message>
        <source>trajectory</source>
        <translation>trajetória</translation>
    </message>
    <message>
        <source>mean Monte Carlo</source>
        <translation>média Monte Carlo</translation>
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
        <translation>mais curto inferior</translation>
    </message>
    <message>
        <source>shortest high</source>
        <translation>mais curto superior</translation>
    </message>
    <message>
        <source>skewness</source>
        <translation>assimetria</translation>
    </message>
    <message>
        <source>excess kurtosis</source>
        <translation>excesso de curtose</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>razão</translation>
    </message>
    <message>
        <source>y at the estimates</source>
        <translation>y nas estimativas</translation>
    </message>
    <message>
        <source>u law of prop.</source>
        <translation>u lei de prop.</translation>
    </message>
    <message>
        <source>u with second-order terms</source>
        <translation>u com termos de segunda ordem</translation>
    </message>
    <message>
        <source>shift of the estimate</source>
        <translation>deslocamento da estimativa</translation>
    </message>
    <message>
        <source>|cᵢ|·u(xᵢ) in %1</source>
        <translation>|cᵢ|·u(xᵢ) em %1</translation>
    </message>
    <message>
        <source>Share of variance in %</source>
        <translation>Parcela da variância em %</translation>
    </message>
    <message>
        <source>alone, Monte Carlo, in %1</source>
        <translation>só ela, Monte Carlo, em %1</translation>
    </message>
    <message>
        <source>ellipsoid, law of prop.</source>
        <translation>elipsoide, lei de prop.</translation>
    </message>
    <message>
        <source>rectangle, law of prop.</source>
        <translation>paralelepípedo, lei de prop.</translation>
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
        <translation>y depois</translation>
    </message>
    <message>
        <source>Change of y</source>
        <translation>Mudança de y</translation>
    </message>
    <message>
        <source>What</source>
        <translation>O quê</translation>
    </message>
    <message>
        <source>|c|·u before in %1</source>
        <translation>|c|·u antes em %1</translation>
    </message>
    <message>
        <source>|c|·u after in %1</source>
        <translation>|c|·u depois em %1</translation>
    </message>
    <message>
        <source>Share before in %</source>
        <translation>Parcela antes em %</translation>
    </message>
    <message>
        <source>Share after in %</source>
        <translation>Parcela depois em %</translation>
    </message>
    <message>
        <source>Change of variance in %</source>
        <translation>Mudança da variância em %</translation>
    </message>
    <message>
        <source>first rotation, about z</source>
        <translation>primeira rotação, em torno de z</translation>
    </message>
    <message>
        <source>second rotation, about y</source>
        <translation>segunda rotação, em torno de y</translation>
    </message>
    <message>
        <source>third rotation, about z</source>
        <translation>terceira rotação, em torno de z</translation>
    </message>
    <message>
        <source>rotation vector, x</source>
        <translation>vetor de rotação, x</translation>
    </message>
    <message>
        <source>rotation vector, y</source>
        <translation>vetor de rotação, y</translation>
    </message>
    <message>
        <source>rotation vector, z</source>
        <translation>vetor de rotação, z</translation>
    </message>
    <message>
        <source>quaternion, scalar part</source>
        <translation>quatérnio, parte escalar</translation>
    </message>
    <message>
        <source>quaternion, x</source>
        <translation>quatérnio, x</translation>
    </message>
    <message>
        <source>quaternion, y</source>
        <translation>quatérnio, y</translation>
    </message>
    <message>
        <source>quaternion, z</source>
        <translation>quatérnio, z</translation>
    </message>
    <message>
        <source>Coordinates that define the frame are left out.</source>
        <translation>As coordenadas que definem o referencial são omitidas.</translation>
    </message>
    <message>
        <source>%1, coordinate %2</source>
        <translation>%1, coordenada %2</translation>
    </message>
    <message>
        <source>tool centre point</source>
        <translation>ponto central da ferramenta</translation>
    </message>
    <message>
        <source>centre of the flange</source>
        <translation>centro do flange</translation>
    </message>
    <message>
        <source>calibration of the artefact</source>
        <translation>calibração do artefato</translation>
    </message>
    <message>
        <source>temperature of the artefact</source>
        <translation>temperatura do artefato</translation>
    </message>
    <message>
        <source>systematic error of indication</source>
        <translation>erro sistemático de indicação</translation>
    </message>
    <message>
        <source>coordinate %1</source>
        <translation>coordenada %1</translation>
    </message>
    <message>
        <source>The bias b is not corrected; |b| counts as a standard uncertainty (against JCGM 100 3.2.4).</source>
        <translation>A tendência b não é corrigida; |b| conta como incerteza-padrão (contra JCGM 100 3.2.4).</translation>
    </message>
    <message>
        <source>The bias b is not part of u_c.</source>
        <translation>A tendência b não faz parte de u_c.</translation>
    </message>
    <message>
        <source>Measured values are taken as corrected by -b; u_var/sqrt(n) of the correction is part of u_c.</source>
        <translation>Os valores medidos são tomados como corrigidos por -b; u_var/sqrt(n) da correção faz parte de u_c.</translation>
    </message>
    <message>
        <source>A coordinate of a point has u_c divided by √2.</source>
        <translation>Uma coordenada de um ponto tem u_c dividida por √2.</translation>
    </message>
    <message>
        <source>measured coordinate</source>
        <translation>coordenada medida</translation>
    </message>
    <message>
        <source>typed standard uncertainty</source>
        <translation>incerteza-padrão digitada</translation>
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
        <translation>especificação: %1</translation>
    </message>
    <message>
        <source>The figure is taken as: %1.</source>
        <translation>O valor é tomado como: %1.</translation>
    </message>
    <message>
        <source>%1, of a length: divided by √2</source>
        <translation>%1, de um comprimento: dividida por √2</translation>
    </message>
    <message>
        <source>station, combination %1</source>
        <translation>estação, combinação %1</translation>
    </message>
    <message>
        <source>instrument: standard uncertainties and correlation of the station</source>
        <translation>instrumento: incertezas-padrão e correlação da estação</translation>
    </message>
    <message>
        <source>scale of distances</source>
        <translation>escala das distâncias</translation>
    </message>
    <message>
        <source>zero offset of distances</source>
        <translation>erro de zero das distâncias</translation>
    </message>
    <message>
        <source>index of the elevation</source>
        <translation>índice da elevação</translation>
    </message>
    <message>
        <source>collimation</source>
        <translation>colimação</translation>
    </message>
    <message>
        <source>squareness of the axes</source>
        <translation>perpendicularidade dos eixos</translation>
    </message>
    <message>
        <source>offset of the beam</source>
        <translation>deslocamento do feixe</translation>
    </message>
    <message>
        <source>coefficient of refraction</source>
        <translation>coeficiente de refração</translation>
    </message>
    <message>
        <source>instrument: standard uncertainty</source>
        <translation>instrumento: incerteza-padrão</translation>
    </message>
    <message>
        <source>instrument: %1</source>
        <translation>instrumento: %1</translation>
    </message>
    <message>
        <source>For a target at the height of the instrument.</source>
        <translation>Para um alvo na altura do instrumento.</translation>
    </message>
    <message>
        <source>station, %1</source>
        <translation>estação, %1</translation>
    </message>
    <message>
        <source>%1, %2, set-up %3</source>
        <translation>%1, %2, estacionamento %3</translation>
    </message>
    <message>
        <source>displacement across the azimuth</source>
        <translation>deslocamento transversal ao azimute</translation>
    </message>
    <message>
        <source>%1 to %2, %3</source>
        <translation>%1 a %2, %3</translation>
    </message>
    <message>
        <source>calibrated length</source>
        <translation>comprimento calibrado</translation>
    </message>
    <message>
        <source>calibration of the %1</source>
        <translation>calibração: %1</translation>
    </message>
    <message>
        <source>%1, calibrated length</source>
        <translation>%1, comprimento calibrado</translation>
    </message>
    <message>
        <source>distance from %1 to %2</source>
        <translation>distância de %1 a %2</translation>
    </message>
    <message>
        <source>angle at %1 from %2 to %3</source>
        <translation>ângulo em %1 de %2 a %3</translation>
    </message>
    <message>
        <source>%1, measured minus calibrated length</source>
        <translation>%1, comprimento medido menos calibrado</translation>
    </message>
    <message>
        <source>origin of %1, coordinate %2</source>
        <translation>origem de %1, coordenada %2</translation>
    </message>
    <message>
        <source>rotation of %1 about %2</source>
        <translation>rotação de %1 em torno de %2</translation>
    </message>
    <message>
        <source>The precision of the readings is no uncertainty of a position: it leaves out where the sensors stand and what their readings share. Monte Carlo is in the results.</source>
        <translation>A precisão das leituras não é a incerteza de uma posição: omite onde estão os sensores e o que suas leituras têm em comum. Monte Carlo está nos resultados.</translation>
    </message>
    <message>
        <source>No redundancy: as many readings as unknowns, so nothing can be checked.</source>
        <translation>Sem redundância: tantas leituras quanto incógnitas, portanto nada pode ser verificado.</translation>
    </message>
    <message>
        <source>The residuals are larger than the uncertainties allow.</source>
        <translation>Os resíduos são maiores do que as incertezas permitem.</translation>
    </message>
    <message>
        <source>The residuals are smaller than the uncertainties lead to expect.</source>
        <translation>Os resíduos são menores do que as incertezas fazem esperar.</translation>
    </message>
    <message>
        <source>The residuals agree with the uncertainties.</source>
        <translation>Os resíduos concordam com as incertezas.</translation>
    </message>
    <message>
        <source>%1 readings have |w| &gt; 3.29 (0.1 %); where several do, look at the largest first.</source>
        <translation>%1 leituras têm |w| &gt; 3.29 (0.1 %); se forem várias, veja primeiro a maior.</translation>
    </message>
    <message>
        <source>%1 in %2, coordinate %3</source>
        <translation>%1 em %2, coordenada %3</translation>
    </message>
    <message>
        <source>position of the platform, %1</source>
        <translation>posição da plataforma, %1</translation>
    </message>
    <message>
        <source>Chi-square of the residuals with the full covariance of the stated uncertainties; nominal coordinates are taken as exact. p is the probability of a larger value if all is as stated; the test has a level of 1 % for all sets together. Not tested: sets without stated uncertainty, and sets of more than %1 points.</source>
        <translation>Qui-quadrado dos resíduos com a covariância completa das incertezas declaradas; as coordenadas nominais são tomadas como exatas. p é a probabilidade de um valor maior se tudo for como declarado; o teste tem nível de 1 % para todos os conjuntos juntos. Não testados: conjuntos sem incerteza declarada e conjuntos com mais de %1 pontos.</translation>
    </message>
    <message>
        <source>Measured less nominal coordinates. w is a residual over its own standard uncertainty; |w| &gt; 3.29 (0.1 %) is remarked. Redundancy is the share of an error of the coordinate that stays in its residual.</source>
        <translation>Coordenadas medidas menos nominais. w é um resíduo dividido por sua própria incerteza-padrão; |w| &gt; 3.29 (0.1 %) é assinalado. A redundância é a parte de um erro da coordenada que fica em seu resíduo.</translation>
    </message>
    <message>
        <source>reading of bar %1</source>
        <translation>leitura da barra %1</translation>
    </message>
    <message>
        <source>ballbars: %1</source>
        <translation>ballbars: %1</translation>
    </message>
    <message>
        <source>length between supports %1</source>
        <translation>comprimento entre os apoios %1</translation>
    </message>
    <message>
        <source>height of support %1</source>
        <translation>altura do apoio %1</translation>
    </message>
    <message>
        <source>ballbars: standard uncertainty</source>
        <translation>ballbars: incerteza-padrão</translation>
    </message>
    <message>
        <source>scale of all lengths</source>
        <translation>escala de todos os comprimentos</translation>
    </message>
    <message>
        <source>constant of bar %1</source>
        <translation>constante da barra %1</translation>
    </message>
    <message>
        <source>%1, point %2</source>
        <translation>%1, ponto %2</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>ponto %1</translation>
    </message>
    <message>
        <source>axis %1 of the flange, angle towards %2</source>
        <translation>eixo %1 do flange, ângulo em direção a %2</translation>
    </message>
    <message>
        <source>repeatability along %1</source>
        <translation>repetibilidade ao longo de %1</translation>
    </message>
    <message>
        <source>repeatability: %1</source>
        <translation>repetibilidade: %1</translation>
    </message>
    <message>
        <source>The coordinates are uncorrelated; unless they are normal, they are not independent: the distance has the law above, its direction is random.</source>
        <translation>As coordenadas não são correlacionadas; a menos que sejam normais, não são independentes: a distância tem a lei acima, sua direção é aleatória.</translation>
    </message>
    <message>
        <source>repeatability about %1</source>
        <translation>repetibilidade em torno de %1</translation>
    </message>
    <message>
        <source>repeatability of the orientation</source>
        <translation>repetibilidade da orientação</translation>
    </message>
    <message>
        <source>%1 of joint %2</source>
        <translation>%1 da junta %2</translation>
    </message>
    <message>
        <source>encoder</source>
        <translation>codificador</translation>
    </message>
    <message>
        <source>tool, rotation about %1</source>
        <translation>ferramenta, rotação em torno de %1</translation>
    </message>
    <message>
        <source>tool: standard uncertainty</source>
        <translation>ferramenta: incerteza-padrão</translation>
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
        <translation>%1, desvio</translation>
    </message>
    <message>
        <source>reading of joint %1, %2</source>
        <translation>leitura da junta %1, %2</translation>
    </message>
    <message>
        <source>position of the tool, %1</source>
        <translation>posição da ferramenta, %1</translation>
    </message>
    <message>
        <source>orientation of the tool, %1</source>
        <translation>orientação da ferramenta, %1</translation>
    </message>
    <message>
        <source>joint angle</source>
        <translation>ângulo da junta</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>deslocamento</translation>
    </message>
    <message>
        <source>link length</source>
        <translation>comprimento do elo</translation>
    </message>
    <message>
        <source>twist</source>
        <translation>torção</translation>
    </message>
    <message>
        <source>second twist</source>
        <translation>segunda torção</translation>
    </message>
    <message>
        <source>Components of a parameter combine in quadrature (Wen et al., Eq. 10). U has the factor 2 of the paper; with few effective degrees of freedom 95 % need more.</source>
        <translation>Os componentes de um parâmetro combinam-se em quadratura (Wen et al., Eq. 10). U tem o fator 2 do artigo; com poucos graus de liberdade efetivos, 95 % exigem mais.</translation>
    </message>
    <message>
        <source>Places of the tool in the base frame of the robot.</source>
        <translation>Lugares da ferramenta no referencial da base do robô.</translation>
    </message>
    <message>
        <source>calculated less measured %1, held back</source>
        <translation>%1 calculada menos medida, reservada</translation>
    </message>
    <message>
        <source>orientation of the base, %1</source>
        <translation>orientação da base, %1</translation>
    </message>
    <message>
        <source>position of the base, %1</source>
        <translation>posição da base, %1</translation>
    </message>
    <message>
        <source>pose %1, rotation about %2</source>
        <translation>pose %1, rotação em torno de %2</translation>
    </message>
    <message>
        <source>pose %1, %2</source>
        <translation>pose %1, %2</translation>
    </message>
    <message>
        <source>measured orientation</source>
        <translation>orientação medida</translation>
    </message>
    <message>
        <source>pose %1, reading of joint %2</source>
        <translation>pose %1, leitura da junta %2</translation>
    </message>
    <message>
        <source>Singular values are those of the weighted Jacobian with columns of length one.</source>
        <translation>Os valores singulares são os da jacobiana ponderada com colunas de comprimento um.</translation>
    </message>
    <message>
        <source>Least well told apart: %1.</source>
        <translation>Os que menos se distinguem: %1.</translation>
    </message>
    <message>
        <source>A residual beyond %1 times its own standard uncertainty is an outlier: 5 % for all residuals together (Bonferroni).</source>
        <translation>Um resíduo além de %1 vezes sua própria incerteza-padrão é um valor discrepante: 5 % para todos os resíduos juntos (Bonferroni).</translation>
    </message>
    <message>
        <source>Nominal: the same base and ball fitted with the nominal parameters. E_n = |d|/U: below 1 the pose agrees with the calibration.</source>
        <translation>Nominal: a mesma base e esfera ajustadas com os parâmetros nominais. E_n = |d|/U: abaixo de 1 a pose concorda com a calibração.</translation>
    </message>
    <message>
        <source>radius of the circle of joint %1</source>
        <translation>raio do círculo da junta %1</translation>
    </message>
    <message>
        <source>%1, point %2, %3</source>
        <translation>%1, ponto %2, %3</translation>
    </message>
    <message>
        <source>Simulated points of the nominal robot: they lie on their circles.</source>
        <translation>Pontos simulados do robô nominal: estão sobre seus círculos.</translation>
    </message>
    <message>
        <source>load %1, compensated</source>
        <translation>carga %1, compensada</translation>
    </message>
    <message>
        <source>load %1 by its own channel alone</source>
        <translation>carga %1 apenas por seu próprio canal</translation>
    </message>
    <message>
        <source>calibration machine, %1</source>
        <translation>máquina de calibração, %1</translation>
    </message>
    <message>
        <source>calibration machine, Eq 5</source>
        <translation>máquina de calibração, Eq 5</translation>
    </message>
    <message>
        <source>regression of %1</source>
        <translation>regressão de %1</translation>
    </message>
    <message>
        <source>reading of %1 by load %2</source>
        <translation>leitura de %1 pela carga %2</translation>
    </message>
    <message>
        <source>quadratic term of %1 by load %2</source>
        <translation>termo quadrático de %1 pela carga %2</translation>
    </message>
    <message>
        <source>%1 of %2, %3</source>
        <translation>%1 de %2, %3</translation>
    </message>
    <message>
        <source>standard deviation of one reading, Eq 3</source>
        <translation>desvio-padrão de uma leitura, Eq 3</translation>
    </message>
    <message>
        <source>net reading of %1, %2</source>
        <translation>leitura líquida de %1, %2</translation>
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
        <translation>Eq 10, largura completa do ciclo</translation>
    </message>
    <message>
        <source>Eq 10, in proportion to the load</source>
        <translation>Eq 10, em proporção à carga</translation>
    </message>
    <message>
        <source>Condition number, by rated outputs and rated loads: %1; with quadratic terms beside these slopes.</source>
        <translation>Número de condição, referido às saídas e cargas nominais: %1; com termos quadráticos além destas inclinações.</translation>
    </message>
    <message>
        <source>Condition number, by rated outputs and rated loads: %1.</source>
        <translation>Número de condição, referido às saídas e cargas nominais: %1.</translation>
    </message>
    <message>
        <source>Uncompensated: by the slope of the channel&apos;s own axis. The uncertainties of both are among the results.</source>
        <translation>Sem compensação: pela inclinação do próprio eixo do canal. As incertezas de ambas estão nos resultados.</translation>
    </message>
    <message>
        <source>Reproduces: equal in all printed digits. Inside rounding: what it is computed from was rounded, too. Interference, percent: the row&apos;s sensor, then the column&apos;s axis.</source>
        <translation>Reproduz: igual em todos os algarismos impressos. Dentro do arredondamento: aquilo de que se calcula também foi arredondado. Interferência, por cento: o sensor da linha, depois o eixo da coluna.</translation>
    </message>
    <message>
        <source>Fig. 2: %1 s without load before a series, %2 s at each load.</source>
        <translation>Fig. 2: %1 s sem carga antes de uma série, %2 s em cada carga.</translation>
    </message>
    <message>
        <source>A row is a load, a column the sensor that answers to it.</source>
        <translation>Uma linha é uma carga, uma coluna o sensor que responde a ela.</translation>
    </message>
    <message>
        <source>A row is a sensor, a column the load under which it gives this output.</source>
        <translation>Uma linha é um sensor, uma coluna a carga sob a qual ele dá esta saída.</translation>
    </message>
    <message>
        <source>Magnitudes: the signs are not known.</source>
        <translation>Magnitudes: os sinais não são conhecidos.</translation>
    </message>
    <message>
        <source>U = hysteresis + interference + k u_c with k = %1: a linear sum of two largest values and an expanded uncertainty. Type A: n = %2 runs, %3 degrees of freedom.</source>
        <translation>U = histerese + interferência + k u_c com k = %1: uma soma linear de dois valores máximos e uma incerteza expandida. Tipo A: n = %2 séries, %3 graus de liberdade.</translation>
    </message>
    <message>
        <source>Calibration machine: %1.</source>
        <translation>Máquina de calibração: %1.</translation>
    </message>
    <message>
        <source>Table 3 takes the Type B standard uncertainties that are stated, not these.</source>
        <translation>A tabela 3 toma as incertezas-padrão do tipo B declaradas, não estas.</translation>
    </message>
    <message>
        <source>load %1 that channel %1 tells</source>
        <translation>carga %1 que o canal %1 indica</translation>
    </message>
    <message>
        <source>net reading of channel %1</source>
        <translation>leitura líquida do canal %1</translation>
    </message>
    <message>
        <source>load by the rated load of channel %1</source>
        <translation>carga dividida pela carga nominal do canal %1</translation>
    </message>
    <message>
        <source>Eqs 3, 4</source>
        <translation>Eqs 3, 4</translation>
    </message>
    <message>
        <source>net reading of %1 at rated load</source>
        <translation>leitura líquida de %1 na carga nominal</translation>
    </message>
    <message>
        <source>calibration machine</source>
        <translation>máquina de calibração</translation>
    </message>
    <message>
        <source>Eq 5</source>
        <translation>Eq 5</translation>
    </message>
    <message>
        <source>Eq 10, as a rectangular distribution over the loop</source>
        <translation>Eq 10, como distribuição retangular sobre o ciclo</translation>
    </message>
    <message>
        <source>unknown load on %1</source>
        <translation>carga desconhecida em %1</translation>
    </message>
    <message>
        <source>set-up: unknown between minus and plus the rated load</source>
        <translation>configuração: desconhecida entre menos e mais a carga nominal</translation>
    </message>
    <message>
        <source>load on %1 by its rated load</source>
        <translation>carga em %1 dividida por sua carga nominal</translation>
    </message>
    <message>
        <source>The paper adds the largest hysteresis and the largest interference to k times u_c. It counts one other load only: with several loads their interference adds up, and exceeds the paper&apos;s U for %1 of %2 sensors when all act fully.</source>
        <translation>O artigo soma a maior histerese e a maior interferência a k vezes u_c. Conta apenas uma outra carga: com várias cargas as interferências se somam e excedem a U do artigo em %1 de %2 sensores quando todas atuam por completo.</translation>
    </message>
    <message>
        <source>So the linear sum is no bound under combined load, and for one component alone it is far too large. As hysteresis and interference are limits and no standard uncertainties, it is no coverage interval either.</source>
        <translation>Assim, a soma linear não é um limite sob carga combinada, e para um só componente é grande demais. Como histerese e interferência são limites e não incertezas-padrão, também não é um intervalo de abrangência.</translation>
    </message>
    <message>
        <source>GUM: hysteresis, non-zero error and resolution are rectangular, each unknown load is rectangular between minus and plus its rated load, root sum of squares. One component alone: k from the t-distribution with the effective degrees of freedom.</source>
        <translation>GUM: histerese, erro de zero e resolução são retangulares, cada carga desconhecida é retangular entre menos e mais sua carga nominal, raiz da soma dos quadrados. Um só componente: k da distribuição t com os graus de liberdade efetivos.</translation>
    </message>
    <message>
        <source>Repeatability: the largest of the steps; its degrees of freedom are those of one step. Pooled over the steps it has more of them.</source>
        <translation>Repetibilidade: a maior dos degraus; seus graus de liberdade são os de um degrau. Combinada sobre os degraus tem mais.</translation>
    </message>
    <message>
        <source>pooled standard deviation</source>
        <translation>desvio-padrão combinado</translation>
    </message>
    <message>
        <source>mean of %1 observations</source>
        <translation>média de %1 observações</translation>
    </message>
    <message>
        <source>s is the experimental standard deviation, u = s/√n (JCGM 100 4.2). A quantity that is stated as pooled observations has the u of all its series together (JCGM 100 4.2.4).</source>
        <translation>s é o desvio-padrão experimental, u = s/√n (JCGM 100 4.2). Uma grandeza declarada como observações combinadas tem a u de todas as suas séries juntas (JCGM 100 4.2.4).</translation>
    </message>
    <message>
        <source>scatter of the means of the groups</source>
        <translation>dispersão das médias dos grupos</translation>
    </message>
    <message>
        <source>components of variance between and within the groups</source>
        <translation>componentes da variância entre os grupos e dentro deles</translation>
    </message>
    <message>
        <source>%1 groups, %2 observations</source>
        <translation>%1 grupos, %2 observações</translation>
    </message>
    <message>
        <source>mean of all observations</source>
        <translation>média de todas as observações</translation>
    </message>
    <message>
        <source>There is an effect of the groups at the level of 5 %.</source>
        <translation>Há um efeito dos grupos ao nível de 5 %.</translation>
    </message>
    <message>
        <source>No effect of the groups is seen at the level of 5 %.</source>
        <translation>Não se vê efeito dos grupos ao nível de 5 %.</translation>
    </message>
    <message>
        <source>The component of variance between the groups is zero: all observations count as independent.</source>
        <translation>O componente da variância entre os grupos é zero: todas as observações contam como independentes.</translation>
    </message>
    <message>
        <source>scatter of the points about the curve</source>
        <translation>dispersão dos pontos em torno da curva</translation>
    </message>
    <message>
        <source>least squares, residuals of %1 points</source>
        <translation>mínimos quadrados, resíduos de %1 pontos</translation>
    </message>
    <message>
        <source>value of the curve at the origin</source>
        <translation>valor da curva na origem</translation>
    </message>
    <message>
        <source>coefficient of the power %1</source>
        <translation>coeficiente da potência %1</translation>
    </message>
    <message>
        <source>mean of y</source>
        <translation>média de y</translation>
    </message>
    <message>
        <source>term of degree %1 (orthonormal polynomial)</source>
        <translation>termo de grau %1 (polinômio ortonormal)</translation>
    </message>
    <message>
        <source>%1 of point %2</source>
        <translation>%1 do ponto %2</translation>
    </message>
    <message>
        <source>stated uncertainty of %1</source>
        <translation>incerteza declarada de %1</translation>
    </message>
    <message>
        <source>table of points</source>
        <translation>tabela dos pontos</translation>
    </message>
    <message>
        <source>observed y</source>
        <translation>y observado</translation>
    </message>
    <message>
        <source>%1, observed y</source>
        <translation>%1, y observado</translation>
    </message>
    <message>
        <source>table of the inverse use</source>
        <translation>tabela do uso inverso</translation>
    </message>
    <message>
        <source>value of the curve at %1</source>
        <translation>valor da curva em %1</translation>
    </message>
    <message>
        <source>x where the curve is %1</source>
        <translation>x onde a curva é %1</translation>
    </message>
    <message>
        <source>The residuals agree with the stated uncertainties.</source>
        <translation>Os resíduos concordam com as incertezas declaradas.</translation>
    </message>
    <message>
        <source>The residuals are larger than the stated uncertainties explain: the curve or the uncertainties do not describe these points.</source>
        <translation>Os resíduos são maiores do que as incertezas declaradas explicam: a curva ou as incertezas não descrevem estes pontos.</translation>
    </message>
    <message>
        <source>The x of y = %1 lies outside of the points of the calibration.</source>
        <translation>O x de y = %1 está fora dos pontos da calibração.</translation>
    </message>
    <message>
        <source>the parameters come from an analysis, which is evaluated in every trial: their correlation cannot be ignored</source>
        <translation>os parâmetros vêm de uma análise que é avaliada em cada ensaio: sua correlação não pode ser ignorada</translation>
    </message>
    <message>
        <source>Rz(θ) Tz(d) Tx(a) Rx(α) Ry(β), β for parallel joints</source>
        <translation>Rz(θ) Tz(d) Tx(a) Rx(α) Ry(β), β para juntas paralelas</translation>
    </message>
    <message>
        <source>Rz(θ) Tz(d) Tx(a) Rx(α), Denavit-Hartenberg</source>
        <translation>Rz(θ) Tz(d) Tx(a) Rx(α), Denavit-Hartenberg</translation>
    </message>
    <message>
        <source>Rx(α) Tx(a) Rz(θ) Tz(d), Craig: α and a before joint i</source>
        <translation>Rx(α) Tx(a) Rz(θ) Tz(d), Craig: α e a antes da junta i</translation>
    </message>
    <message>
        <source>Date of receipt</source>
        <translation>Data de recebimento</translation>
    </message>
    <message>
        <source>Date of calibration</source>
        <translation>Data de calibração</translation>
    </message>
    <message>
        <source>Date of issue</source>
        <translation>Data de emissão</translation>
    </message>
    <message>
        <source>To first order no input quantity influences %1 at these estimates: its uncertainty is of second order, as Monte Carlo shows</source>
        <translation>Em primeira ordem nenhuma grandeza de entrada influencia %1 nestas estimativas: sua incerteza é de segunda ordem, como mostra Monte Carlo</translation>
    </message>
    <message>
        <source>Calibration certificate</source>
        <translation>Certificado de calibração</translation>
    </message>
    <message>
        <source>not normal; k u fits as far as so few trials can tell</source>
        <translation>não normal; k u serve até onde tão poucos ensaios podem dizer</translation>
    </message>
    <message>
        <source>measured artefact, Porath et al., Eq. 2</source>
        <translation>artefato medido, Porath et al., eq. 2</translation>
    </message>
    <message>
        <source>not controlled</source>
        <translation>não controlada</translation>
    </message>
    <message>
        <source>outlier?</source>
        <translation>valor atípico?</translation>
    </message>
    <message>
        <source>not tested</source>
        <translation>não testado</translation>
    </message>
    <message>
        <source>residuals larger than stated</source>
        <translation>resíduos maiores que o declarado</translation>
    </message>
    <message>
        <source>agrees</source>
        <translation>concorda</translation>
    </message>
    <message>
        <source>distance: largest</source>
        <translation>distância: maior</translation>
    </message>
    <message>
        <source>distance: RP = mean + 3 s</source>
        <translation>distância: RP = média + 3 s</translation>
    </message>
    <message>
        <source>does not move the measured points in any pose</source>
        <translation>não move os pontos medidos em nenhuma pose</translation>
    </message>
    <message>
        <source>moves the measured points as %1 can: coupled with it, held at its nominal value</source>
        <translation>move os pontos medidos como %1 pode: acoplado a isso, mantido em seu valor nominal</translation>
    </message>
    <message>
        <source>coordinates in the fit</source>
        <translation>coordenadas no ajuste</translation>
    </message>
    <message>
        <source>unknowns (rank)</source>
        <translation>incógnitas (posto)</translation>
    </message>
    <message>
        <source>condition of the fit</source>
        <translation>número de condição do ajuste</translation>
    </message>
    <message>
        <source>smallest singular value</source>
        <translation>menor valor singular</translation>
    </message>
    <message>
        <source>residuals over what uncertainties explain</source>
        <translation>resíduos em relação ao que as incertezas explicam</translation>
    </message>
    <message>
        <source>outlier</source>
        <translation>valor atípico</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>ferramenta</translation>
    </message>
    <message>
        <source>one ball is one point: it has no orientation</source>
        <translation>uma esfera é um ponto: não tem orientação</translation>
    </message>
    <message>
        <source>places the base frame on axis 1: by definition, as nominal; it would need a measured base</source>
        <translation>situa o referencial da base no eixo 1: por definição, como o nominal; seria necessária uma base medida</translation>
    </message>
    <message>
        <source>places the frame of the last link, which no axis follows: by definition, as nominal</source>
        <translation>situa o referencial do último elo, ao qual não segue nenhum eixo: por definição, como o nominal</translation>
    </message>
    <message>
        <source>the axis is parallel to the next: 0 by definition, or beta and d would describe the same</source>
        <translation>o eixo é paralelo ao seguinte: 0 por definição, ou beta e d descreveriam o mesmo</translation>
    </message>
    <message>
        <source>reproduces</source>
        <translation>reproduz-se</translation>
    </message>
    <message>
        <source>inside rounding</source>
        <translation>dentro do arredondamento</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>difere</translation>
    </message>
    <message>
        <source>planned</source>
        <translation>planejado</translation>
    </message>
    <message>
        <source>total</source>
        <translation>total</translation>
    </message>
    <message>
        <source>standard deviation of the means of the groups</source>
        <translation>desvio-padrão das médias dos grupos</translation>
    </message>
    <message>
        <source>s_a, from the means of the groups</source>
        <translation>s_a, das médias dos grupos</translation>
    </message>
    <message>
        <source>s_b, within the groups</source>
        <translation>s_b, dentro dos grupos</translation>
    </message>
    <message>
        <source>s_B, between the groups</source>
        <translation>s_B, entre os grupos</translation>
    </message>
    <message>
        <source>n_0, size of the groups</source>
        <translation>n_0, tamanho dos grupos</translation>
    </message>
    <message>
        <source>F = s_a²/s_b²</source>
        <translation>F = s_a²/s_b²</translation>
    </message>
    <message>
        <source>95 % quantile of F</source>
        <translation>quantil de 95 % de F</translation>
    </message>
    <message>
        <source>97.5 % quantile of F</source>
        <translation>quantil de 97,5 % de F</translation>
    </message>
    <message>
        <source>between the groups</source>
        <translation>entre os grupos</translation>
    </message>
    <message>
        <source>within the groups</source>
        <translation>dentro dos grupos</translation>
    </message>
    <message>
        <source>chi-squared</source>
        <translation>qui-quadrado</translation>
    </message>
    <message>
        <source>its 95 % quantile</source>
        <translation>seu quantil de 95 %</translation>
    </message>
    <message>
        <source>standard deviation of the residuals</source>
        <translation>desvio-padrão dos resíduos</translation>
    </message>
    <message>
        <source>coefficient of determination R²</source>
        <translation>coeficiente de determinação R²</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>curva</translation>
    </message>
    <message>
        <source>residuals</source>
        <translation>resíduos</translation>
    </message>
    <message>
        <source>position %1, rotations about x, y, z: %2</source>
        <translation>posição %1, rotações em torno de x, y, z: %2</translation>
    </message>
    <message>
        <source>1 further component</source>
        <translation>mais 1 componente</translation>
    </message>
    <message>
        <source>Shown for %1, the first of the %2 groups; the CSV table of budgets has every group.</source>
        <translation>Mostrado para %1, o primeiro dos %2 grupos; a tabela CSV dos balanços contém todos os grupos.</translation>
    </message>
    <message>
        <source>Shown for %1: of the %2 groups it has the largest expanded uncertainties on average; the CSV table of budgets has every group.</source>
        <translation>Mostrado para %1: dos %2 grupos tem, em média, as maiores incertezas expandidas; a tabela CSV dos balanços contém todos os grupos.</translation>
    </message>
    <message>
        <source>Shown for %1: of the %2 groups with the same quantities it has the largest expanded uncertainties on average; the CSV table of budgets has all %3 groups.</source>
        <translation>Mostrado para %1: dos %2 grupos com as mesmas grandezas tem, em média, as maiores incertezas expandidas; a tabela CSV dos balanços contém todos os %3 grupos.</translation>
    </message>
    <message>
        <source>The law of propagation is validated by JCGM 101 clause 8 where both ends of its coverage interval, y ± U, lie within the numerical tolerance δ of those of the propagation of distributions. Validated: %1 of %2.</source>
        <translation>A lei de propagação é validada segundo a JCGM 101, seção 8, onde os dois extremos de seu intervalo de abrangência, y ± U, estão dentro da tolerância numérica δ dos da propagação de distribuições. Validadas: %1 de %2.</translation>
    </message>
    <message>
        <source>Shape of the distributions by Monte Carlo</source>
        <translation>Forma das distribuições por Monte Carlo</translation>
    </message>
    <message>
        <source>From &apos;%1&apos; on, %2 of %3 rows; the annex has all of them.</source>
        <translation>A partir de “%1”, %2 de %3 linhas; o anexo contém todas.</translation>
    </message>
    <message>
        <source>From &apos;%1&apos; on, %2 of %3 rows; the CSV tables, and the annex on request, have all of them.</source>
        <translation>A partir de “%1”, %2 de %3 linhas; as tabelas CSV e, a pedido, o anexo contêm todas.</translation>
    </message>
    <message>
        <source>The annex has the charts.</source>
        <translation>O anexo contém os gráficos.</translation>
    </message>
    <message>
        <source>The CSV tables, and the annex on request, have what the charts show.</source>
        <translation>As tabelas CSV e, a pedido, o anexo contêm o que os gráficos mostram.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables and no chart; the annex has the rest.</source>
        <translation>São mostradas %1 de %2 tabelas e nenhum gráfico; o anexo contém o resto.</translation>
    </message>
    <message>
        <source>Shown are %1 of %2 tables and no chart; the CSV tables, and the annex on request, have the rest.</source>
        <translation>São mostradas %1 de %2 tabelas e nenhum gráfico; as tabelas CSV e, a pedido, o anexo contêm o resto.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>incógnita</translation>
    </message>
    <message>
        <source>coupled with</source>
        <translation>acoplada a</translation>
    </message>
    <message>
        <source>Observations of %1</source>
        <translation>Observações de %1</translation>
    </message>
    <message>
        <source>mean + s</source>
        <translation>média + s</translation>
    </message>
    <message>
        <source>mean − s</source>
        <translation>média − s</translation>
    </message>
    <message>
        <source>What is reported, and in which unit. Without rows: every name that an equation defines and no other one uses, in the unit of the first quantity of the same dimension, else in SI units.</source>
        <translation>O que é relatado e em que unidade. Sem linhas: cada nome que uma equação define e que nenhuma outra usa, na unidade da primeira grandeza da mesma dimensão e, se não houver, em unidades SI.</translation>
    </message>
    <message>
        <source>arcsine</source>
        <translation>arco-seno</translation>
    </message>
    <message>
        <source>curvilinear</source>
        <translation>curvilíneo</translation>
    </message>
    <message>
        <source>inexactness</source>
        <translation>inexatidão</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>limites</translation>
    </message>
    <message>
        <source>pooled</source>
        <translation>agrupada</translation>
    </message>
    <message>
        <source>From the set-up as it is stated. Values and uncertainties that other analyses give (%1 quantities) are in the results, not here.</source>
        <translation>A partir da configuração como está indicada. Valores e incertezas dados por outras análises (%1 grandezas) estão nos resultados, não aqui.</translation>
    </message>
    <message>
        <source>Limit of the coverage interval: of Monte Carlo, else of the law of propagation</source>
        <translation>Limite do intervalo de abrangência: de Monte Carlo e, se não houver, da lei de propagação</translation>
    </message>
    <message>
        <source>Input quantities that the component is part of</source>
        <translation>Grandezas de entrada de que a componente faz parte</translation>
    </message>
    <message>
        <source>Quantity or component of uncertainty, as at the bars of the chart</source>
        <translation>Grandeza ou componente de incerteza, como nas barras do gráfico</translation>
    </message>
    <message>
        <source>density</source>
        <translation>densidade</translation>
    </message>
    <message>
        <source>quantile</source>
        <translation>quantil</translation>
    </message>
    <message>
        <source>calibrated lengths</source>
        <translation>comprimentos calibrados</translation>
    </message>
    <message>
        <source>distances</source>
        <translation>distâncias</translation>
    </message>
    <message>
        <source>angles</source>
        <translation>ângulos</translation>
    </message>
    <message>
        <source>scale bar</source>
        <translation>barra de escala</translation>
    </message>
    <message>
        <source>base</source>
        <translation>base</translation>
    </message>
    <message>
        <source>supports</source>
        <translation>apoios</translation>
    </message>
    <message>
        <source>axes of the flange</source>
        <translation>eixos do flange</translation>
    </message>
    <message>
        <source>circles</source>
        <translation>círculos</translation>
    </message>
    <message>
        <source>calibration matrix</source>
        <translation>matriz de calibração</translation>
    </message>
    <message>
        <source>loads on other axes</source>
        <translation>cargas em outros eixos</translation>
    </message>
    <message>
        <source>scatter of all observations</source>
        <translation>dispersão de todas as observações</translation>
    </message>
    <message>
        <source>points, x</source>
        <translation>pontos, x</translation>
    </message>
    <message>
        <source>points, y</source>
        <translation>pontos, y</translation>
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
        <translation>%1, todas as linhas: %2</translation>
    </message>
    <message>
        <source>%1: uncertainty</source>
        <translation>%1: incerteza</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>linha %1</translation>
    </message>
    <message>
        <source>%1: estimate</source>
        <translation>%1: estimativa</translation>
    </message>
    <message>
        <source>%1, factor</source>
        <translation>%1, fator</translation>
    </message>
    <message>
        <source>%1, added</source>
        <translation>%1, somado</translation>
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
        <translation>apoio %1</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>eixo %1</translation>
    </message>
    <message>
        <source>check %1</source>
        <translation>verificação %1</translation>
    </message>
    <message>
        <source>axis of %1</source>
        <translation>eixo de %1</translation>
    </message>
    <message>
        <source>scale bar %1</source>
        <translation>barra de escala %1</translation>
    </message>
    <message>
        <source>%1 (u of first order: %2 of that by Monte Carlo)</source>
        <translation>%1 (u de primeira ordem: %2 da de Monte Carlo)</translation>
    </message>
    <message>
        <source>S / %</source>
        <translation>S / %</translation>
    </message>
    <message>
        <source>Share of the variance that the component causes by itself (Sobol index)</source>
        <translation>Parcela da variância que a componente causa sozinha (índice de Sobol)</translation>
    </message>
    <message>
        <source>S total / %</source>
        <translation>S total / %</translation>
    </message>
    <message>
        <source>Share of the variance with all interactions of the component with others</source>
        <translation>Parcela da variância com todas as interações da componente com outras</translation>
    </message>
    <message>
        <source>ν (first order)</source>
        <translation>ν (primeira ordem)</translation>
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
        <translation>flange</translation>
    </message>
    <message>
        <source>A mean of n observations is drawn from a t distribution with n − 1 degrees of freedom (JCGM 101 6.4.9). Means of simultaneous observations are drawn from one multivariate t distribution with these n − 1 degrees of freedom; with the n − N of JCGM 102 5.3.2 no mean would keep its own distribution.</source>
        <translation>A média de n observações é sorteada de uma distribuição t com n − 1 graus de liberdade (JCGM 101 6.4.9). As médias de observações simultâneas são sorteadas de uma única distribuição t multivariada com esses n − 1 graus de liberdade; com os n − N do JCGM 102 5.3.2 nenhuma média manteria a sua própria distribuição.</translation>
    </message>
    <message>
        <source>if it vanished, U would exceed the target again, with fewer degrees of freedom</source>
        <translation>se desaparecesse, U voltaria a exceder o alvo, com menos graus de liberdade</translation>
    </message>
    <message>
        <source>Unit of the value, and of a and b where they have no other; empty: 1. A difference of temperatures is given in K.</source>
        <translation>Unidade do valor, e de a e b se não têm outra; vazia: 1. Uma diferença de temperaturas é dada em K.</translation>
    </message>
    <message>
        <source>First figure of the statement.</source>
        <translation>Primeiro valor da declaração.</translation>
    </message>
    <message>
        <source>unit of a, b</source>
        <translation>unidade de a, b</translation>
    </message>
    <message>
        <source>Unit of the statement&apos;s figures; empty: the row&apos;s. % and ppm of a quantity that has a unit are parts of its value.</source>
        <translation>Unidade dos valores da declaração; vazia: a da linha. % e ppm de uma grandeza com unidade são partes do seu valor.</translation>
    </message>
    <message>
        <source>Budget of %1</source>
        <translation>Balanço de %1</translation>
    </message>
    <message>
        <source>Two correlated components have half of their covariance each, in the effective degrees of freedom too.</source>
        <translation>Duas componentes correlacionadas têm cada uma a metade da sua covariância, também nos graus de liberdade efetivos.</translation>
    </message>
    <message>
        <source>u along any axis</source>
        <translation>u ao longo de cada eixo</translation>
    </message>
    <message>
        <source>results: in the base frame of the robot</source>
        <translation>resultados: no sistema da base do robô</translation>
    </message>
    <message>
        <source>%1: chosen at an end of its range; a wider one can give a better design.</source>
        <translation>%1: escolhido em um extremo de seu intervalo; um mais amplo pode dar um projeto melhor.</translation>
    </message>
    <message>
        <source>artefact</source>
        <translation>artefato</translation>
    </message>
    <message>
        <source>length standard</source>
        <translation>padrão de comprimento</translation>
    </message>
    <message>
        <source>station</source>
        <translation>estação</translation>
    </message>
    <message>
        <source>field of view</source>
        <translation>campo de visão</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>não decidido</translation>
    </message>
    <message>
        <source>Of these verdicts, %1 could be the other one with other trials.</source>
        <translation>Destes julgamentos, %1 poderiam ser o contrário com outras tentativas.</translation>
    </message>
    <message>
        <source>the value typed is used, not the mean of the observations, %1</source>
        <translation>usa-se o valor digitado, não a média das observações, %1</translation>
    </message>
    <message>
        <source>the correlation coefficient of %1 and %2 must lie between -1 and 1; it is %3</source>
        <translation>o coeficiente de correlação de %1 e %2 deve estar entre -1 e 1; é %3</translation>
    </message>
    <message>
        <source>Both are estimates by sampling, with the standard errors beside them: S can exceed S total by chance.</source>
        <translation>Ambas são estimativas por amostragem, com os erros-padrão ao lado: S pode exceder S total por acaso.</translation>
    </message>
    <message>
        <source>Any measurement equation with what is known about its quantities: several results, intermediate definitions, conditions, and equations that are solved in every trial.</source>
        <translation>Qualquer equação de medição com o que se sabe de suas grandezas: vários resultados, definições intermediárias, condições e equações que são resolvidas em cada ensaio.</translation>
    </message>
    <message>
        <source>Uncertainty of a measured point</source>
        <translation>Incerteza de um ponto medido</translation>
    </message>
    <message>
        <source>Residuals of the readings</source>
        <translation>Resíduos das leituras</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Leitura</translation>
    </message>
    <message>
        <source>u of the reading</source>
        <translation>u da leitura</translation>
    </message>
    <message>
        <source>redundancy</source>
        <translation>redundância</translation>
    </message>
    <message>
        <source>remark</source>
        <translation>comentário</translation>
    </message>
    <message>
        <source>Fit of the measured points to their nominal coordinates</source>
        <translation>Ajuste dos pontos medidos às suas coordenadas nominais</translation>
    </message>
    <message>
        <source>root mean square residual</source>
        <translation>resíduo quadrático médio</translation>
    </message>
    <message>
        <source>chi-square</source>
        <translation>qui-quadrado</translation>
    </message>
    <message>
        <source>largest normalised residual</source>
        <translation>maior resíduo normalizado</translation>
    </message>
    <message>
        <source>of</source>
        <translation>de</translation>
    </message>
    <message>
        <source>Residuals of the points, along the axes of their frame</source>
        <translation>Resíduos dos pontos, ao longo dos eixos do seu sistema</translation>
    </message>
    <message>
        <source>residual x</source>
        <translation>resíduo x</translation>
    </message>
    <message>
        <source>residual y</source>
        <translation>resíduo y</translation>
    </message>
    <message>
        <source>residual z</source>
        <translation>resíduo z</translation>
    </message>
    <message>
        <source>redundancy x</source>
        <translation>redundância x</translation>
    </message>
    <message>
        <source>redundancy y</source>
        <translation>redundância y</translation>
    </message>
    <message>
        <source>redundancy z</source>
        <translation>redundância z</translation>
    </message>
    <message>
        <source>present series</source>
        <translation>série atual</translation>
    </message>
    <message>
        <source>also reached at x</source>
        <translation>também atingido em x</translation>
    </message>
    <message>
        <source>a kept state</source>
        <translation>um estado mantido</translation>
    </message>
    <message>
        <source>two states of the analysis %1 are kept; one can be</source>
        <translation>são mantidos dois estados da análise %1; só pode haver um</translation>
    </message>
    <message>
        <source>&apos;digits&apos; must be a whole number from %1 to %2 (JCGM 100 7.2.6)</source>
        <translation>&apos;digits&apos; deve ser um número inteiro de %1 a %2 (JCGM 100 7.2.6)</translation>
    </message>
    <message>
        <source>the model cannot be evaluated</source>
        <translation>o modelo não pode ser avaliado</translation>
    </message>
    <message>
        <source>there is no output quantity &apos;%1&apos; here</source>
        <translation>aqui não há grandeza de saída &apos;%1&apos;</translation>
    </message>
    <message>
        <source>from the present values</source>
        <translation>a partir dos valores atuais</translation>
    </message>
    <message>
        <source>global search</source>
        <translation>busca global</translation>
    </message>
    <message>
        <source>start %1</source>
        <translation>início %1</translation>
    </message>
    <message>
        <source>a target uncertainty is not met</source>
        <translation>uma incerteza-alvo não é atendida</translation>
    </message>
    <message>
        <source>there is no output quantity &apos;%1&apos; then</source>
        <translation>então não há grandeza de saída &apos;%1&apos;</translation>
    </message>
    <message>
        <source>an uncertainty has no finite value</source>
        <translation>uma incerteza não tem valor finito</translation>
    </message>
    <message>
        <source>an uncertainty vanishes: the model is degenerate there</source>
        <translation>uma incerteza se anula: o modelo é degenerado ali</translation>
    </message>
    <message>
        <source>all choices</source>
        <translation>todas as escolhas</translation>
    </message>
    <message>
        <source>greedy</source>
        <translation>passo a passo</translation>
    </message>
    <message>
        <source>backward elimination</source>
        <translation>eliminação retroativa</translation>
    </message>
    <message>
        <source>exchange</source>
        <translation>troca</translation>
    </message>
    <message>
        <source>%1 and %2 are closer than the least distance</source>
        <translation>%1 e %2 estão mais próximos que a menor distância</translation>
    </message>
    <message>
        <source>%1 stands in a box</source>
        <translation>%1 está dentro de uma caixa</translation>
    </message>
    <message>
        <source>%1 stands in the box &apos;%2&apos;</source>
        <translation>%1 está dentro da caixa &apos;%2&apos;</translation>
    </message>
    <message>
        <source>the line of sight %1 passes a box</source>
        <translation>a linha de visada %1 atravessa uma caixa</translation>
    </message>
    <message>
        <source>the line of sight %1 passes the box &apos;%2&apos;</source>
        <translation>a linha de visada %1 atravessa a caixa &apos;%2&apos;</translation>
    </message>
    <message>
        <source>%1 (row %2)</source>
        <translation>%1 (linha %2)</translation>
    </message>
    <message>
        <source>%1: uncertainty too small to be seen</source>
        <translation>%1: incerteza pequena demais para ser vista</translation>
    </message>
    <message>
        <source>uncertainty drawn at %1 of %2 points</source>
        <translation>incerteza desenhada em %1 de %2 pontos</translation>
    </message>
    <message>
        <source>standard deviation known before (Type A)</source>
        <translation>desvio-padrão conhecido de antes (Tipo A)</translation>
    </message>
    <message>
        <source>share of the variance, first order</source>
        <translation>parcela da variância, primeira ordem</translation>
    </message>
    <message>
        <source>change, relative to the variance before</source>
        <translation>alteração, relativa à variância anterior</translation>
    </message>
    <message>
        <source>growth of the objective without it</source>
        <translation>aumento do objetivo sem ela</translation>
    </message>
    <message>
        <source>the number of observations in the mean must be at least one</source>
        <translation>o número de observações na média deve ser pelo menos um</translation>
    </message>
    <message>
        <source>results: in the frame of the sensor</source>
        <translation>resultados: no sistema do sensor</translation>
    </message>
    <message>
        <source>time</source>
        <translation>tempo</translation>
    </message>
    <message>
        <source>net reading</source>
        <translation>leitura líquida</translation>
    </message>
    <message>
        <source>deviation from the line</source>
        <translation>desvio da reta</translation>
    </message>
    <message>
        <source>Design: twelve points of a ballbar measurement</source>
        <translation>Projeto: doze pontos de uma medição com ballbar</translation>
    </message>
    <message>
        <source>Tool centre point of a robot by telescopic ballbars</source>
        <translation>Ponto central da ferramenta de um robô com ballbars telescópicos</translation>
    </message>
    <message>
        <source>From the certificate of a scale bar to the tool of a robot</source>
        <translation>Do certificado de uma barra de escala à ferramenta de um robô</translation>
    </message>
    <message>
        <source>Industrial robot ER10L-C10</source>
        <translation>Robô industrial ER10L-C10</translation>
    </message>
    <message>
        <source>Six-axis force/moment sensor</source>
        <translation>Sensor de força/momento de seis eixos</translation>
    </message>
    <message>
        <source>Scale bar in a network of three cameras and a laser tracker</source>
        <translation>Barra de escala numa rede de três câmaras e um laser tracker</translation>
    </message>
    <message>
        <source>Stewart platform measured with a total station</source>
        <translation>Plataforma Stewart medida com uma estação total</translation>
    </message>
    <message>
        <source>Pose of a Stewart platform measured by a network</source>
        <translation>Pose de uma plataforma Stewart medida por uma rede</translation>
    </message>
    <message>
        <source>End-gauge calibration (GUM H.1)</source>
        <translation>Calibração de um bloco-padrão (GUM H.1)</translation>
    </message>
    <message>
        <source>Simultaneous resistance and reactance (GUM H.2)</source>
        <translation>Resistência e reatância simultâneas (GUM H.2)</translation>
    </message>
    <message>
        <source>Calibration of a thermometer (GUM H.3)</source>
        <translation>Calibração de um termômetro (GUM H.3)</translation>
    </message>
    <message>
        <source>Zener voltage standard on ten days (GUM H.5)</source>
        <translation>Padrão de tensão Zener em dez dias (GUM H.5)</translation>
    </message>
    <message>
        <source>JCGM 100:2008, Annex H.5, Table H.9: five observations on each of ten days, and the analysis of variance that says whether the days have an effect.</source>
        <translation>JCGM 100:2008, anexo H.5, tabela H.9: cinco observações em cada um de dez dias e a análise de variância que diz se os dias têm efeito.</translation>
    </message>
    <message>
        <source>Additive model (GUM Supplement 1, 9.2)</source>
        <translation>Modelo aditivo (Suplemento 1 do GUM, 9.2)</translation>
    </message>
    <message>
        <source>JCGM 101:2008, clause 9.2: a sum of four quantities with three choices of their distributions, and the validation of clause 8.</source>
        <translation>JCGM 101:2008, seção 9.2: uma soma de quatro grandezas com três escolhas das suas distribuições, e a validação da seção 8.</translation>
    </message>
    <message>
        <source>Mass calibration (GUM Supplement 1, 9.3)</source>
        <translation>Calibração de massa (Suplemento 1 do GUM, 9.3)</translation>
    </message>
    <message>
        <source>JCGM 101:2008, clause 9.3: a weight of 100 g is compared with a reference weight in air; to first order the densities seem not to matter.</source>
        <translation>JCGM 101:2008, seção 9.3: um peso de 100 g é comparado no ar com um peso de referência; em primeira ordem, as densidades parecem não importar.</translation>
    </message>
    <message>
        <source>Comparison loss of a power meter (GUM Supplement 1, 9.4)</source>
        <translation>Perda de comparação de um medidor de potência (Suplemento 1 do GUM, 9.4)</translation>
    </message>
    <message>
        <source>JCGM 101:2008, clause 9.4, Tables 8 and 9: a sum of two squares near zero, where the law of propagation fails.</source>
        <translation>JCGM 101:2008, seção 9.4, tabelas 8 e 9: uma soma de dois quadrados perto de zero, onde a lei de propagação falha.</translation>
    </message>
    <message>
        <source>Gauge-block calibration (GUM Supplement 1, 9.5)</source>
        <translation>Calibração de um bloco-padrão (Suplemento 1 do GUM, 9.5)</translation>
    </message>
    <message>
        <source>JCGM 101:2008, clause 9.5: the end gauge of GUM H.1 with the distributions of Table 10.</source>
        <translation>JCGM 101:2008, seção 9.5: o bloco-padrão do GUM H.1 com as distribuições da tabela 10.</translation>
    </message>
    <message>
        <source>Two sums with a common term (GUM Supplement 2, 9.2)</source>
        <translation>Duas somas com um termo comum (Suplemento 2 do GUM, 9.2)</translation>
    </message>
    <message>
        <source>JCGM 102:2011, clause 9.2: a bivariate additive model with standard normal quantities.</source>
        <translation>JCGM 102:2011, seção 9.2: um modelo aditivo bivariado com grandezas normais padrão.</translation>
    </message>
    <message>
        <source>Cartesian to polar co-ordinates (GUM Supplement 2, 9.3)</source>
        <translation>De coordenadas cartesianas a polares (Suplemento 2 do GUM, 9.3)</translation>
    </message>
    <message>
        <source>JCGM 102:2011, clause 9.3, Tables 6 and 7: magnitude and phase of a small complex quantity.</source>
        <translation>JCGM 102:2011, seção 9.3, tabelas 6 e 7: módulo e fase de uma grandeza complexa pequena.</translation>
    </message>
    <message>
        <source>Resistance and reactance by Monte Carlo (GUM Supplement 2, 9.4)</source>
        <translation>Resistência e reatância por Monte Carlo (Suplemento 2 do GUM, 9.4)</translation>
    </message>
    <message>
        <source>JCGM 102:2011, clause 9.4: the impedance of GUM H.2 with trivariate normal input quantities and the joint coverage region of R and X.</source>
        <translation>JCGM 102:2011, seção 9.4: a impedância do GUM H.2 com grandezas de entrada normais trivariadas e a região de abrangência conjunta de R e X.</translation>
    </message>
    <message>
        <source>JCGM 100:2008, Annex H.1: a gauge block of 50 mm is compared with a standard; first- and second-order law of propagation.</source>
        <translation>JCGM 100:2008, anexo H.1: um bloco-padrão de 50 mm é comparado com um padrão; lei de propagação de primeira e segunda ordem.</translation>
    </message>
    <message>
        <source>JCGM 100:2008, Annex H.2: five simultaneous observations of voltage, current and phase give three correlated results.</source>
        <translation>JCGM 100:2008, anexo H.2: cinco observações simultâneas de tensão, corrente e fase dão três resultados correlacionados.</translation>
    </message>
    <message>
        <source>JCGM 100:2008, Annex H.3: the correction b of a thermometer at eleven temperatures, and the straight line through them: b(t) = y₁ + y₂ (t − 20 °C).</source>
        <translation>JCGM 100:2008, anexo H.3: a correção b de um termômetro a onze temperaturas e a reta que passa por elas: b(t) = y₁ + y₂ (t − 20 °C).</translation>
    </message>
    <message>
        <source>Which twelve of the 22 points of a ballbar measurement make the uncertainty of the tool centre point smallest.</source>
        <translation>Quais doze dos 22 pontos de uma medição com ballbars tornam mínima a incerteza do ponto central da ferramenta.</translation>
    </message>
    <message>
        <source>Three telescopic ballbars measure points on spheres and circles; from them follow the flange, its axes and the tool.</source>
        <translation>Três ballbars telescópicos medem pontos em esferas e círculos; deles resultam a flange, os seus eixos e a ferramenta.</translation>
    </message>
    <message>
        <source>Scale bar, two trackers, flange, identified arm and tool: analyses that feed each other, evaluated as one model.</source>
        <translation>Barra de escala, dois trackers, flange, braço identificado e ferramenta: análises que se alimentam umas às outras, avaliadas como um só modelo.</translation>
    </message>
    <message>
        <source>Parameters of an arm of six axes, identified from measured places, and the position of its end effector.</source>
        <translation>Parâmetros de um braço de seis eixos, identificados a partir de lugares medidos, e a posição do seu efetuador final.</translation>
    </message>
    <message>
        <source>Rated output, zero, repeatability and interference of three forces and three moments.</source>
        <translation>Saída nominal, zero, repetibilidade e interferência de três forças e três momentos.</translation>
    </message>
    <message>
        <source>Distances on a scale bar that three cameras and a laser tracker measure together.</source>
        <translation>Distâncias numa barra de escala que três câmaras e um laser tracker medem em conjunto.</translation>
    </message>
    <message>
        <source>Pose of a platform from six measured points, whose uncertainties come from calibrated artefacts.</source>
        <translation>Pose de uma plataforma a partir de seis pontos medidos, cujas incertezas vêm de artefatos calibrados.</translation>
    </message>
    <message>
        <source>Sensor layout, points and pose in one chain: a laser tracker and a total station measure six nests of a platform.</source>
        <translation>Disposição dos sensores, pontos e pose numa cadeia: um laser tracker e uma estação total medem seis alojamentos de uma plataforma.</translation>
    </message>
    <message>
        <source>%1 in line %2</source>
        <translation>%1 na linha %2</translation>
    </message>
    <message>
        <source>columns between tabs</source>
        <translation>colunas entre tabulações</translation>
    </message>
    <message>
        <source>columns between semicolons</source>
        <translation>colunas entre pontos e vírgulas</translation>
    </message>
    <message>
        <source>columns between commas</source>
        <translation>colunas entre vírgulas</translation>
    </message>
    <message>
        <source>columns between blanks, decimal commas</source>
        <translation>colunas entre espaços, vírgulas decimais</translation>
    </message>
    <message>
        <source>columns between blanks</source>
        <translation>colunas entre espaços</translation>
    </message>
    <message>
        <source>all %1 met</source>
        <translation>todos os %1 cumpridos</translation>
    </message>
    <message>
        <source>%1 of %2 not met</source>
        <translation>%1 de %2 não cumpridos</translation>
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
        <translation>min Σ w (leitura − h(X))²</translation>
    </message>
    <message>
        <source>least squares: R maximises tr(Rᵀ Σ (q_i − q̄) l_iᵀ),  o = q̄ − R l̄</source>
        <translation>mínimos quadrados: R maximiza tr(Rᵀ Σ (q_i − q̄) l_iᵀ),  o = q̄ − R l̄</translation>
    </message>
    <message>
        <source>Z = ± √(L₁² − X² − Y²);  no value where the root is negative</source>
        <translation>Z = ± √(L₁² − X² − Y²);  sem valor onde a raiz é negativa</translation>
    </message>
    <message>
        <source>min Σ w (L_j − |M − KS_j|)², Gauss-Newton from Eqs 1-3</source>
        <translation>min Σ w (L_j − |M − KS_j|)², Gauss-Newton a partir das Eqs. 1-3</translation>
    </message>
    <message>
        <source>L_j = |P_i + e_i + R_i (ω_i × t) − KS_j| + reading&apos;s deviation</source>
        <translation>L_j = |P_i + e_i + R_i (ω_i × t) − KS_j| + desvio da leitura</translation>
    </message>
    <message>
        <source>n_x, n_y: planes of the arcs by total least squares;  C: sphere through all points</source>
        <translation>n_x, n_y: planos dos arcos por mínimos quadrados totais;  C: esfera por todos os pontos</translation>
    </message>
    <message>
        <source>TCP = mean of Rot_iᵀ Fᵀ (M_i − C)</source>
        <translation>TCP = média de Rot_iᵀ Fᵀ (M_i − C)</translation>
    </message>
    <message>
        <source>JCGM 102 6.2, with all that points and readings share</source>
        <translation>JCGM 102 6.2, com tudo o que pontos e leituras partilham</translation>
    </message>
    <message>
        <source>n·p = D with |n| = 1, least sum of squares</source>
        <translation>n·p = D com |n| = 1, soma de quadrados mínima</translation>
    </message>
    <message>
        <source>min Σ (|p_j − c| − R)²  in the fitted plane</source>
        <translation>min Σ (|p_j − c| − R)²  no plano ajustado</translation>
    </message>
    <message>
        <source>x_i = ± z_{i−1} × z_i/|…|,  O_i: foot of the common perpendicular on axis i + 1</source>
        <translation>x_i = ± z_{i−1} × z_i/|…|,  O_i: pé da perpendicular comum no eixo i + 1</translation>
    </message>
    <message>
        <source>parallel: O_i in the plane through O_{i−1} normal to z_{i−1},  y_i = z_i × h/|…|,  x_i = y_i × z_i</source>
        <translation>paralelos: O_i no plano por O_{i−1} normal a z_{i−1},  y_i = z_i × h/|…|,  x_i = y_i × z_i</translation>
    </message>
    <message>
        <source>S_hc = Σ L d_h/Σ L²  over the increasing readings under load c</source>
        <translation>S_hc = Σ L d_h/Σ L²  sobre as leituras crescentes sob a carga c</translation>
    </message>
    <message>
        <source>V = S L,  L = C V  with  C = S⁻¹</source>
        <translation>V = S L,  L = C V  com  C = S⁻¹</translation>
    </message>
    <message>
        <source>V_h = Σ_c (S_hc L_c + Q_hc L_c²),  by Newton&apos;s method from L = C V</source>
        <translation>V_h = Σ_c (S_hc L_c + Q_hc L_c²),  pelo método de Newton a partir de L = C V</translation>
    </message>
    <message>
        <source>V_h = d_h + repeatability + resolution + non-zero + hysteresis</source>
        <translation>V_h = d_h + repetibilidade + resolução + desvio do zero + histerese</translation>
    </message>
    <message>
        <source>S_hc = fitted + regression + S_hc δ_c</source>
        <translation>S_hc = valor ajustado + regressão + S_hc δ_c</translation>
    </message>
    <message>
        <source>d_hij = d′_hij − d_h0j,  d_hi = mean over j,  s_hi,  u_A = max s_hi/√n</source>
        <translation>d_hij = d′_hij − d_h0j,  d_hi = média sobre j,  s_hi,  u_A = max s_hi/√n</translation>
    </message>
    <message>
        <source>JCGM 100, Eq 1</source>
        <translation>JCGM 100, Eq. 1</translation>
    </message>
    <message>
        <source>JCGM 100, Eqs H.24, H.25, for groups of any size</source>
        <translation>JCGM 100, Eqs. H.24, H.25, para grupos de qualquer tamanho</translation>
    </message>
    <message>
        <source>groups included, JCGM 100 H.5.2.3</source>
        <translation>grupos incluídos, JCGM 100 H.5.2.3</translation>
    </message>
    <message>
        <source>components of variance, Searle et al. 1992</source>
        <translation>componentes da variância, Searle et al. 1992</translation>
    </message>
    <message>
        <source>groups not included, JCGM 100, Eq H.28</source>
        <translation>grupos não incluídos, JCGM 100, Eq. H.28</translation>
    </message>
    <message>
        <source>JCGM 100, Eq H.12</source>
        <translation>JCGM 100, Eq. H.12</translation>
    </message>
    <message>
        <source>from the residuals, JCGM 100 H.3.2</source>
        <translation>dos resíduos, JCGM 100 H.3.2</translation>
    </message>
    <message>
        <source>as stated, York et al. 2004</source>
        <translation>como declarado, York et al. 2004</translation>
    </message>
    <message>
        <source>it must be an analysis of the kept state and have a name (otherName)</source>
        <translation>deve ser uma análise do estado mantido e ter um nome (otherName)</translation>
    </message>
    <message>
        <source>Dimensions are checked where the equations are read; plane angle counts as a number, because the radian is one in the SI. A temperature in °C is taken in kelvin only where two make a ratio; a difference of temperatures is given in K.</source>
        <translation>As dimensões são verificadas onde as equações são lidas; o ângulo plano conta como número, porque o radiano o é no SI. Uma temperatura em °C só é tomada em kelvin onde duas formam uma razão; uma diferença de temperaturas é dada em K.</translation>
    </message>
    <message>
        <source>Angles that inverse functions give or that were read, their sums and whole multiples are on the circle where the result is given in a unit of angle.</source>
        <translation>Os ângulos que as funções inversas dão ou que foram lidos, as suas somas e os seus múltiplos inteiros estão no círculo onde o resultado é dado numa unidade de ângulo.</translation>
    </message>
    <message>
        <source>One equation a line: y = x_1*x_2 + x_3. Names without an equation are input quantities; a number has its unit in brackets: 3 [mm]. &apos;solve y = 1: y^2 = x&apos; finds y in every trial, from its starting value. complex(a, b) and polar(r, phi) make complex numbers, re, im, abs and arg real ones of them. &apos;#&apos; starts a comment.</source>
        <translation>Uma equação por linha: y = x_1*x_2 + x_3. Nomes sem equação são grandezas de entrada; um número tem a sua unidade entre colchetes: 3 [mm]. &apos;solve y = 1: y^2 = x&apos; encontra y em cada ensaio, a partir do seu valor inicial. complex(a, b) e polar(r, phi) formam números complexos; re, im, abs e arg, reais a partir deles. &apos;#&apos; começa um comentário.</translation>
    </message>
    <message>
        <source>How its uncertainty is known; a and b are then: u; s and n; U and k; U and p in %; half-width (and inexactness, or ratio of top to base); lower and upper limit; step of the indication; permissible error and % of the value; number of counts; number of observations in the mean (pooled); standard deviation (Laplace, Weibull about the value), scale (and shape); expected number of events; number of trials and probability in %. A sample is drawn as it is listed among the observations, a histogram has the edges of its cells there. Empty: a constant.</source>
        <translation>Como se conhece a sua incerteza; a e b são então: u; s e n; U e k; U e p em %; meia largura (e inexatidão, ou razão entre topo e base); limite inferior e superior; passo da indicação; erro admissível e % do valor; número de contagens; número de observações na média (combinada); desvio-padrão (Laplace, Weibull em torno do valor), escala (e forma); número esperado de eventos; número de provas e probabilidade em %. Uma amostra é sorteada como está entre as observações; um histograma tem ali as bordas das suas células. Vazio: uma constante.</translation>
    </message>
    <message>
        <source>Laplace, standard deviation</source>
        <translation>Laplace, desvio-padrão</translation>
    </message>
    <message>
        <source>Laplace, scale</source>
        <translation>Laplace, escala</translation>
    </message>
    <message>
        <source>Weibull, scale and shape</source>
        <translation>Weibull, escala e forma</translation>
    </message>
    <message>
        <source>Weibull, standard deviation</source>
        <translation>Weibull, desvio-padrão</translation>
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
        <translation>amostra de valores</translation>
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
        <translation>Nome da avaliação que deu várias grandezas juntas, com um mesmo nu: as suas incertezas assentam numa só estimativa da variância e são sorteadas de uma distribuição t multivariada (JCGM 102 5.3.2). Os coeficientes de correlação entre elas estão com as correlações da análise.</translation>
    </message>
    <message>
        <source>Observed value, value of a sample or edge of a histogram, in the unit of the quantity.</source>
        <translation>Valor observado, valor de uma amostra ou borda de um histograma, na unidade da grandeza.</translation>
    </message>
    <message>
        <source>weight</source>
        <translation>peso</translation>
    </message>
    <message>
        <source>Of a value of a sample, or of the cell of a histogram that begins at this edge: counts, or parts of any sum. Empty: one in a sample, none behind the last edge.</source>
        <translation>De um valor de uma amostra, ou da célula de um histograma que começa nesta borda: contagens, ou partes de uma soma qualquer. Vazio: um numa amostra, nenhum depois da última borda.</translation>
    </message>
    <message>
        <source>Covariance of the points</source>
        <translation>Covariância dos pontos</translation>
    </message>
    <message>
        <source>Common u of x</source>
        <translation>u comum de x</translation>
    </message>
    <message>
        <source>Standard uncertainty of a deviation that all x share beside their own (one standard, one temperature), in the unit of x. Used with stated uncertainties, in the weights too.</source>
        <translation>Incerteza-padrão de um desvio que todos os x partilham além do próprio (um padrão, uma temperatura), na unidade de x. Usada com incertezas declaradas, também nos pesos.</translation>
    </message>
    <message>
        <source>Common u of y</source>
        <translation>u comum de y</translation>
    </message>
    <message>
        <source>Likewise of all y, in the unit of y.</source>
        <translation>O mesmo de todos os y, na unidade de y.</translation>
    </message>
    <message>
        <source>Correlations of the points</source>
        <translation>Correlações dos pontos</translation>
    </message>
    <message>
        <source>Correlation coefficients between coordinates of the points (ISO/TS 28037): they change the curve, which minimises v^T V^-1 v, and its uncertainty. Used with stated uncertainties.</source>
        <translation>Coeficientes de correlação entre coordenadas dos pontos (ISO/TS 28037): mudam a curva, que minimiza v^T V^-1 v, e a sua incerteza. Usados com incertezas declaradas.</translation>
    </message>
    <message>
        <source>A coordinate of a point by its number: y_1 is the y of the first point.</source>
        <translation>Uma coordenada de um ponto pelo seu número: y_1 é o y do primeiro ponto.</translation>
    </message>
    <message>
        <source>Another one: y_2, or the x_1 of the same point.</source>
        <translation>Outra: y_2, ou o x_1 do mesmo ponto.</translation>
    </message>
    <message>
        <source>coefficient</source>
        <translation>coeficiente</translation>
    </message>
    <message>
        <source>Correlation coefficient of their stated uncertainties.</source>
        <translation>Coeficiente de correlação das suas incertezas declaradas.</translation>
    </message>
    <message>
        <source>Certificate of a gauge block of 50 mm</source>
        <translation>Certificado de um bloco-padrão de 50 mm</translation>
    </message>
    <message>
        <source>A gauge block is compared with a standard of the same length, by the model of EA-4/02, S4; its certificate says all that ISO/IEC 17025 7.8 asks for.</source>
        <translation>Um bloco-padrão é comparado com um padrão do mesmo comprimento, pelo modelo de EA-4/02, S4; o seu certificado diz tudo o que a ISO/IEC 17025 7.8 pede.</translation>
    </message>
    <message>
        <source>Conformity of a micrometer</source>
        <translation>Conformidade de um micrômetro</translation>
    </message>
    <message>
        <source>Errors of indication of a micrometer of 25 mm at four gauge blocks, and whether they conform with a maximum permissible error of 4 µm under the decision rule of ISO 14253-1.</source>
        <translation>Erros de indicação de um micrômetro de 25 mm em quatro blocos-padrão, e se cumprem um erro máximo admissível de 4 µm pela regra de decisão da ISO 14253-1.</translation>
    </message>
    <message>
        <source>A budget from Excel</source>
        <translation>Um balanço do Excel</translation>
    </message>
    <message>
        <source>What &apos;covaria import excel-budget.xlsx&apos; makes of a budget in a spreadsheet, with the columns of EA-4/02.</source>
        <translation>O que &apos;covaria import excel-budget.xlsx&apos; faz de um balanço numa planilha, com as colunas de EA-4/02.</translation>
    </message>
    <message>
        <source>Gewichtsstück von 10 kg</source>
        <translation>Peso de 10 kg</translation>
    </message>
    <message>
        <source>Kalibrierung eines Gewichtsstücks nach EA-4/02, S2: ein Beispiel in deutscher Sprache, mit vollständigem Kalibrierschein.</source>
        <translation>Calibração de um peso segundo EA-4/02, S2: um exemplo em alemão, com certificado completo.</translation>
    </message>
    <message>
        <source>Guard band</source>
        <translation>Banda de guarda</translation>
    </message>
    <message>
        <source>How the guard band follows: by the guard factor, by the ratio TUR of tolerance and U (both limits are needed), or so narrow as a target risk allows (global risks need a prior).</source>
        <translation>Como resulta a banda de guarda: do fator de guarda, da razão TUR entre tolerância e U (são precisos ambos os limites), ou tão estreita quanto um risco-alvo permite (riscos globais precisam de um conhecimento prévio).</translation>
    </message>
    <message>
        <source>Target risk</source>
        <translation>Risco-alvo</translation>
    </message>
    <message>
        <source>That the guard band is made for, above 0 and up to 0.5: 0.02 or 2 %.</source>
        <translation>Para o qual a banda de guarda é feita, acima de 0 e até 0.5: 0.02 ou 2 %.</translation>
    </message>
    <message>
        <source>guard factor times U</source>
        <translation>fator de guarda vezes U</translation>
    </message>
    <message>
        <source>RSS: root of T²/4 − U²</source>
        <translation>RSS: raiz de T²/4 − U²</translation>
    </message>
    <message>
        <source>NCSL RP-10: 1.25 − 1/TUR</source>
        <translation>NCSL RP-10: 1.25 − 1/TUR</translation>
    </message>
    <message>
        <source>managed (Dobbert): at most 2 % false accepts</source>
        <translation>gerida (Dobbert): no máximo 2 % de aceitações falsas</translation>
    </message>
    <message>
        <source>to a specific risk at the acceptance limit</source>
        <translation>a um risco específico no limite de aceitação</translation>
    </message>
    <message>
        <source>to a global consumer&apos;s risk</source>
        <translation>a um risco global do consumidor</translation>
    </message>
    <message>
        <source>to a risk of what is accepted</source>
        <translation>a um risco do que é aceito</translation>
    </message>
    <message>
        <source>Site of calibration</source>
        <translation>Local da calibração</translation>
    </message>
    <message>
        <source>Whose place it was done at; empty: in the laboratory, or elsewhere where a place is stated.</source>
        <translation>Em casa de quem foi feita; vazio: no laboratório, ou noutro lado onde se indica um local.</translation>
    </message>
    <message>
        <source>Where it was done if not in the laboratory: the customer&apos;s hall, the field.</source>
        <translation>Onde foi feita, se não no laboratório: o pavilhão do cliente, o campo.</translation>
    </message>
    <message>
        <source>To which a statement of conformity refers: the standard or drawing, with its edition.</source>
        <translation>A que se refere uma declaração de conformidade: a norma ou o desenho, com a sua edição.</translation>
    </message>
    <message>
        <source>at the customer</source>
        <translation>no cliente</translation>
    </message>
    <message>
        <source>in a branch of the laboratory</source>
        <translation>numa filial do laboratório</translation>
    </message>
    <message>
        <source>in a branch of the customer</source>
        <translation>numa filial do cliente</translation>
    </message>
    <message>
        <source>elsewhere</source>
        <translation>noutro local</translation>
    </message>
    <message>
        <source>RSS guard band</source>
        <translation>banda de guarda RSS</translation>
    </message>
    <message>
        <source>NCSL RP-10 guard band</source>
        <translation>banda de guarda NCSL RP-10</translation>
    </message>
    <message>
        <source>managed guard band (Dobbert, 2 % false accepts)</source>
        <translation>banda de guarda gerida (Dobbert, 2 % de aceitações falsas)</translation>
    </message>
    <message>
        <source>guard band to a specific risk of %1</source>
        <translation>banda de guarda a um risco específico de %1</translation>
    </message>
    <message>
        <source>guard band to a global consumer&apos;s risk of %1</source>
        <translation>banda de guarda a um risco global do consumidor de %1</translation>
    </message>
    <message>
        <source>guard band to a risk of %1 of what is accepted</source>
        <translation>banda de guarda a um risco de %1 do que é aceito</translation>
    </message>
    <message>
        <source>pass (accepted)</source>
        <translation>passa (aceito)</translation>
    </message>
    <message>
        <source>fail (rejected)</source>
        <translation>não passa (rejeitado)</translation>
    </message>
    <message>
        <source>January</source>
        <translation>janeiro</translation>
    </message>
    <message>
        <source>February</source>
        <translation>fevereiro</translation>
    </message>
    <message>
        <source>March</source>
        <translation>março</translation>
    </message>
    <message>
        <source>April</source>
        <translation>abril</translation>
    </message>
    <message>
        <source>May</source>
        <translation>maio</translation>
    </message>
    <message>
        <source>June</source>
        <translation>junho</translation>
    </message>
    <message>
        <source>July</source>
        <translation>julho</translation>
    </message>
    <message>
        <source>August</source>
        <translation>agosto</translation>
    </message>
    <message>
        <source>September</source>
        <translation>setembro</translation>
    </message>
    <message>
        <source>October</source>
        <translation>outubro</translation>
    </message>
    <message>
        <source>November</source>
        <translation>novembro</translation>
    </message>
    <message>
        <source>December</source>
        <translation>dezembro</translation>
    </message>
    <message>
        <source>%1 %2 %3</source>
        <translation>%1 de %2 de %3</translation>
    </message>
    <message>
        <source>required by %1 where conformity is stated</source>
        <translation>exigido por %1 onde se declara conformidade</translation>
    </message>
    <message>
        <source>%1 is the unit of a temperature, and the quantity is given in %2, in which it may be a difference: give both in %1, or both in %2</source>
        <translation>%1 é a unidade de uma temperatura, e a grandeza é dada em %2, em que pode ser uma diferença: dê ambas em %1, ou ambas em %2</translation>
    </message>
    <message>
        <source>%1 is a difference of temperatures, and %2 a temperature in %3: take a temperature, or give %2 in K</source>
        <translation>%1 é uma diferença de temperaturas, e %2 uma temperatura em %3: tome uma temperatura, ou dê %2 em K</translation>
    </message>
    <message>
        <source>%1 is given in %2, which may be a difference of temperatures, and %3 is a temperature in %4: give both in %4, or both in K</source>
        <translation>%1 é dada em %2, que pode ser uma diferença de temperaturas, e %3 é uma temperatura em %4: dê ambas em %4, ou ambas em K</translation>
    </message>
    <message>
        <source>%1 is a temperature in %2, and %3 is given in %4, which may be a difference of temperatures: give both in %2, or both in K</source>
        <translation>%1 é uma temperatura em %2, e %3 é dada em %4, que pode ser uma diferença de temperaturas: dê ambas em %2, ou ambas em K</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is complex, so that &apos;%2&apos; is a part of it: to use a part write re(%1) or im(%1), else choose another name</source>
        <translation>&apos;%1&apos; é complexo, de modo que &apos;%2&apos; é uma parte dele: para usar uma parte escreva re(%1) ou im(%1); senão, escolha outro nome</translation>
    </message>
    <message>
        <source>a complex unknown counts twice, and so does a complex equation: there are %1 real unknowns and %2 real equations</source>
        <translation>uma incógnita complexa conta em dobro, e uma equação complexa também: há %1 incógnitas reais e %2 equações reais</translation>
    </message>
    <message>
        <source>modulus and argument</source>
        <translation>módulo e argumento</translation>
    </message>
    <message>
        <source>real and imaginary part</source>
        <translation>parte real e imaginária</translation>
    </message>
    <message>
        <source>%1 of a complex number are real; one of them is complex here</source>
        <translation>%1 de um número complexo são reais; um deles aqui é complexo</translation>
    </message>
    <message>
        <source>complex numbers have no order and are no condition: compare re, im, abs or arg of them</source>
        <translation>números complexos não têm ordem e não são uma condição: compare re, im, abs ou arg deles</translation>
    </message>
    <message>
        <source>this function is one of real numbers; for a complex one there are + - * / ^, exp, log, sqrt, sin, cos, tan, sinh, cosh, tanh, conj, abs, arg, re and im</source>
        <translation>esta função é de números reais; para um complexo há + - * / ^, exp, log, sqrt, sin, cos, tan, sinh, cosh, tanh, conj, abs, arg, re e im</translation>
    </message>
    <message>
        <source>%1 unknowns are too many to be solved together: the time for each trial grows with the cube of their number, so the limit is %2; solve what does not depend on the rest in systems of its own</source>
        <translation>%1 incógnitas são demais para serem resolvidas juntas: o tempo de cada ensaio cresce com o cubo do seu número, por isso o limite é %2; resolva em sistemas próprios o que não depende do resto</translation>
    </message>
    <message>
        <source>the expected number of events gives the estimate: leave the value empty, or the number</source>
        <translation>o número esperado de eventos dá a estimativa: deixe vazio o valor, ou o número</translation>
    </message>
    <message>
        <source>the expected number of events is missing: state it, or the value</source>
        <translation>falta o número esperado de eventos: indique-o, ou o valor</translation>
    </message>
    <message>
        <source>trials and probability give the estimate: leave the value empty, or the probability</source>
        <translation>provas e probabilidade dão a estimativa: deixe vazio o valor, ou a probabilidade</translation>
    </message>
    <message>
        <source>the probability of each trial is missing: state it, or the value</source>
        <translation>falta a probabilidade de cada prova: indique-a, ou o valor</translation>
    </message>
    <message>
        <source>the number of trials must be at least one</source>
        <translation>o número de provas deve ser pelo menos um</translation>
    </message>
    <message>
        <source>the probability of each trial must lie between 0 and 100 %</source>
        <translation>a probabilidade de cada prova deve estar entre 0 e 100 %</translation>
    </message>
    <message>
        <source>the value must lie between 0 and the number of trials</source>
        <translation>o valor deve estar entre 0 e o número de provas</translation>
    </message>
    <message>
        <source>scale and shape give the estimate: leave the value empty, or state the standard deviation alone</source>
        <translation>escala e forma dão a estimativa: deixe vazio o valor, ou indique só o desvio-padrão</translation>
    </message>
    <message>
        <source>a Weibull distribution needs a value greater than zero, which is its mean</source>
        <translation>uma distribuição de Weibull precisa de um valor maior que zero, que é a sua média</translation>
    </message>
    <message>
        <source>no Weibull distribution has such a ratio of standard deviation to mean: it must lie between 0.000002 and 429</source>
        <translation>nenhuma distribuição de Weibull tem tal razão entre desvio-padrão e média: deve estar entre 0.000002 e 429</translation>
    </message>
    <message>
        <source>observations have no weights: for values with weights write sample 1; 2; 3 weights 2; 5; 2</source>
        <translation>observações não têm pesos: para valores com pesos escreva sample 1; 2; 3 weights 2; 5; 2</translation>
    </message>
    <message>
        <source>weights have no unit</source>
        <translation>pesos não têm unidade</translation>
    </message>
    <message>
        <source>a histogram has one edge more than weights: histogram 0; 1; 2 weights 5; 8</source>
        <translation>um histograma tem uma borda a mais que pesos: histogram 0; 1; 2 weights 5; 8</translation>
    </message>
    <message>
        <source>there must be as many weights as values</source>
        <translation>deve haver tantos pesos quantos valores</translation>
    </message>
    <message>
        <source>the weights of the cells are missing: histogram 0; 1; 2 weights 5; 8</source>
        <translation>faltam os pesos das células: histogram 0; 1; 2 weights 5; 8</translation>
    </message>
    <message>
        <source>write the probability as p = 0.02 or p = 2 %</source>
        <translation>escreva a probabilidade como p = 0.02 ou p = 2 %</translation>
    </message>
    <message>
        <source>location</source>
        <translation>localização</translation>
    </message>
    <message>
        <source>the shape must lie between 0.1 and 1000000.</source>
        <translation>a forma deve estar entre 0.1 e 1000000.</translation>
    </message>
    <message>
        <source>value without an event</source>
        <translation>valor sem evento</translation>
    </message>
    <message>
        <source>the expected number of events must lie between 0 and 10000000; beyond it a normal distribution says the same.</source>
        <translation>o número esperado de eventos deve estar entre 0 e 10000000; acima disso, uma distribuição normal diz o mesmo.</translation>
    </message>
    <message>
        <source>the number of trials must be a whole number up to 10000000; beyond it a normal distribution says the same.</source>
        <translation>o número de provas deve ser um inteiro até 10000000; acima disso, uma distribuição normal diz o mesmo.</translation>
    </message>
    <message>
        <source>the probability must lie between 0 and 1.</source>
        <translation>a probabilidade deve estar entre 0 e 1.</translation>
    </message>
    <message>
        <source>a histogram needs at least one cell.</source>
        <translation>um histograma precisa de pelo menos uma célula.</translation>
    </message>
    <message>
        <source>there must be one edge more than probabilities.</source>
        <translation>deve haver uma borda a mais que probabilidades.</translation>
    </message>
    <message>
        <source>edges</source>
        <translation>bordas</translation>
    </message>
    <message>
        <source>the edges must rise.</source>
        <translation>as bordas devem crescer.</translation>
    </message>
    <message>
        <source>histogram: there must be one edge more than probabilities.</source>
        <translation>histograma: deve haver uma borda a mais que probabilidades.</translation>
    </message>
    <message>
        <source>the measurement model has a kink at the estimates, or bends too sharply there for derivatives of second and third order</source>
        <translation>o modelo de medição tem uma quebra nas estimativas, ou curva-se ali demais para derivadas de segunda e terceira ordem</translation>
    </message>
    <message>
        <source>the measurement model has no value there</source>
        <translation>o modelo de medição não tem valor ali</translation>
    </message>
    <message>
        <source>its sensitivity coefficients are zero, or there are none</source>
        <translation>os seus coeficientes de sensibilidade são zero, ou não existem</translation>
    </message>
    <message>
        <source>Monte Carlo answers alone for %1: the measurement model has no sensitivity coefficients at the estimates of its input quantities.</source>
        <translation>Só Monte Carlo responde por %1: o modelo de medição não tem coeficientes de sensibilidade nas estimativas das suas grandezas de entrada.</translation>
    </message>
    <message>
        <source>%1 has a kink at the estimates of the input quantities (an absolute value, a maximum, a condition): the law of propagation takes the sensitivity coefficients of one side. Use Monte Carlo.</source>
        <translation>%1 tem uma quebra nas estimativas das grandezas de entrada (um valor absoluto, um máximo, uma condição): a lei de propagação toma os coeficientes de sensibilidade de um lado. Use Monte Carlo.</translation>
    </message>
    <message>
        <source>Monte Carlo answers alone for %1, which has a kink at the estimates of the input quantities (an absolute value, a maximum, a condition): the law of propagation would take the sensitivity coefficients of one side.</source>
        <translation>Só Monte Carlo responde por %1, que tem uma quebra nas estimativas das grandezas de entrada (um valor absoluto, um máximo, uma condição): a lei de propagação tomaria os coeficientes de sensibilidade de um lado.</translation>
    </message>
    <message>
        <source>There is no standard uncertainty with second-order terms of %1: they would make its variance negative, so terms of higher order matter as much. Use Monte Carlo.</source>
        <translation>Não há incerteza-padrão com termos de segunda ordem de %1: tornariam negativa a sua variância, de modo que termos de ordem superior contam igual. Use Monte Carlo.</translation>
    </message>
    <message>
        <source>%1 trials are few for a coverage interval of %2 %: some %3 lie beyond each of its ends, so that U is not known well. JCGM 101 7.2.2 asks for some %4 trials.</source>
        <translation>%1 ensaios são poucos para um intervalo de abrangência de %2 %: uns %3 ficam além de cada extremo, de modo que U não é bem conhecida. JCGM 101 7.2.2 pede uns %4 ensaios.</translation>
    </message>
    <message>
        <source>the measurement model has no sensitivity coefficients at the estimates of its input quantities%1: it is not differentiable there (singular geometry); Monte Carlo needs none</source>
        <translation>o modelo de medição não tem coeficientes de sensibilidade nas estimativas das grandezas de entrada%1: não é diferenciável ali (geometria singular); Monte Carlo não precisa de nenhum</translation>
    </message>
    <message>
        <source>the readings find target %1 %2 mm from its nominal coordinates; look for exchanged names or a unit that was mixed up (the result does not depend on the nominal coordinates)</source>
        <translation>as leituras encontram o alvo %1 a %2 mm das suas coordenadas nominais; procure nomes trocados ou uma unidade confundida (o resultado não depende das coordenadas nominais)</translation>
    </message>
    <message>
        <source>the readings find %1 further targets far from their nominal coordinates</source>
        <translation>as leituras encontram mais %1 alvos longe das suas coordenadas nominais</translation>
    </message>
    <message>
        <source>observations have degrees of freedom of their own; those made together have the same numbers in the table of observations</source>
        <translation>observações têm graus de liberdade próprios; as feitas juntas têm os mesmos números na tabela de observações</translation>
    </message>
    <message>
        <source>the members of an ensemble have a standard or expanded uncertainty with finite nu</source>
        <translation>os membros de um conjunto têm uma incerteza-padrão ou expandida com nu finito</translation>
    </message>
    <message>
        <source>the members of ensemble &apos;%1&apos; have one and the same nu; it is %2 in the first, %3 here</source>
        <translation>os membros do conjunto &apos;%1&apos; têm um mesmo nu; é %2 no primeiro, %3 aqui</translation>
    </message>
    <message>
        <source>the sample gives the estimate: leave the value empty</source>
        <translation>a amostra dá a estimativa: deixe vazio o valor</translation>
    </message>
    <message>
        <source>the weight of a cell of its histogram is missing</source>
        <translation>falta o peso de uma célula do seu histograma</translation>
    </message>
    <message>
        <source>a histogram has the weight of each cell beside the edge where it begins, and none beside the last edge</source>
        <translation>um histograma tem o peso de cada célula junto à borda onde ela começa, e nenhum junto à última borda</translation>
    </message>
    <message>
        <source>some values of its sample have a weight and some have none</source>
        <translation>alguns valores da sua amostra têm peso e outros não</translation>
    </message>
    <message>
        <source>its weights must have a sum above zero</source>
        <translation>os seus pesos devem ter uma soma acima de zero</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is complex: list its parts %2 and %3, or define abs(%1) and arg(%1) and list these</source>
        <translation>&apos;%1&apos; é complexo: liste as suas partes %2 e %3, ou defina abs(%1) e arg(%1) e liste estes</translation>
    </message>
    <message>
        <source>a difference: %1</source>
        <translation>uma diferença: %1</translation>
    </message>
    <message>
        <source>as stated with correlations, ISO/TS 28037, 10</source>
        <translation>como declarado, com correlações, ISO/TS 28037, 10</translation>
    </message>
    <message>
        <source>common deviation of all %1</source>
        <translation>desvio comum de todos os %1</translation>
    </message>
    <message>
        <source>stated for all points</source>
        <translation>declarada para todos os pontos</translation>
    </message>
    <message>
        <source>a common deviation is one of stated uncertainties: choose these, or leave it 0</source>
        <translation>um desvio comum é de incertezas declaradas: escolha-as, ou deixe-o em 0</translation>
    </message>
    <message>
        <source>correlations are those of stated uncertainties: choose these, or leave out the correlations</source>
        <translation>correlações são de incertezas declaradas: escolha-as, ou deixe as correlações de fora</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no coordinate of a point: write y_1 for the y of the first one</source>
        <translation>&apos;%1&apos; não é uma coordenada de um ponto: escreva y_1 para o y do primeiro</translation>
    </message>
    <message>
        <source>%1 has no standard uncertainty of its own that could be correlated</source>
        <translation>%1 não tem incerteza-padrão própria que possa estar correlacionada</translation>
    </message>
    <message>
        <source>a coordinate is not correlated with itself</source>
        <translation>uma coordenada não está correlacionada consigo mesma</translation>
    </message>
    <message>
        <source>the CSV file &apos;%1&apos; of %2 is a link that leads out of the project&apos;s folder: put the file itself there</source>
        <translation>o arquivo CSV &apos;%1&apos; de %2 é uma ligação que leva para fora da pasta do projeto: ponha lá o próprio arquivo</translation>
    </message>
    <message>
        <source>the guard band of %1 follows from the ratio of tolerance and U: give both limits, or choose a guard factor</source>
        <translation>a banda de guarda de %1 resulta da razão entre tolerância e U: dê ambos os limites, ou escolha um fator de guarda</translation>
    </message>
    <message>
        <source>the guard band of %1 is made for a global risk: give the prior, or choose a specific risk</source>
        <translation>a banda de guarda de %1 é feita para um risco global: dê o conhecimento prévio, ou escolha um risco específico</translation>
    </message>
    <message>
        <source>the guard band of %1 needs a tolerance: give a limit</source>
        <translation>a banda de guarda de %1 precisa de uma tolerância: dê um limite</translation>
    </message>
    <message>
        <source>the target risk of %1 must lie above 0 and not above 0.5</source>
        <translation>o risco-alvo de %1 deve estar acima de 0 e não acima de 0.5</translation>
    </message>
    <message>
        <source>another study has the same id</source>
        <translation>outro estudo tem o mesmo identificador</translation>
    </message>
    <message>
        <source>its id must be made of letters, digits, &apos;-&apos; and &apos;_&apos;</source>
        <translation>o seu identificador deve ser feito de letras, algarismos, &apos;-&apos; e &apos;_&apos;</translation>
    </message>
    <message>
        <source>there is no asset %1, and no analysis of this name that this one takes from%2</source>
        <translation>não há ativo %1, nem análise deste nome da qual esta tome%2</translation>
    </message>
    <message>
        <source> (did you mean %1?)</source>
        <translation> (quis dizer %1?)</translation>
    </message>
    <message>
        <source>a number here is larger than any that can be computed with (1.8e308)</source>
        <translation>um número aqui é maior que qualquer um com que se possa calcular (1.8e308)</translation>
    </message>
    <message>
        <source>the value or its place is no text in UTF-8</source>
        <translation>o valor ou o seu lugar não é texto em UTF-8</translation>
    </message>
    <message>
        <source>more than %1 analyses feed each other in a row: put the equations of some of them into one</source>
        <translation>mais de %1 análises alimentam-se umas às outras em fila: ponha as equações de algumas numa só</translation>
    </message>
    <message>
        <source>%1 is a link that leads out of the project&apos;s folder: put the picture itself there</source>
        <translation>%1 é uma ligação que leva para fora da pasta do projeto: ponha lá a própria imagem</translation>
    </message>
    <message>
        <source>%1; in this file write %2</source>
        <translation>%1; neste arquivo escreva %2</translation>
    </message>
    <message>
        <source>there is no asset %1%2</source>
        <translation>não há ativo %1%2</translation>
    </message>
    <message>
        <source>the file of candidates &apos;%1&apos; is a link that leads out of the project&apos;s folder: put the file itself there</source>
        <translation>o arquivo de candidatos &apos;%1&apos; é uma ligação que leva para fora da pasta do projeto: ponha lá o próprio arquivo</translation>
    </message>
    <message>
        <source>another design has the same id</source>
        <translation>outro projeto de medição tem o mesmo identificador</translation>
    </message>
    <message>
        <source>row %1 was left out</source>
        <translation>a linha %1 foi omitida</translation>
    </message>
    <message>
        <source>row %1: %2 in %3 beside a sensitivity coefficient is taken as a difference or reading, in %4</source>
        <translation>linha %1: %2 em %3 ao lado de um coeficiente de sensibilidade é tomada como diferença ou leitura, em %4</translation>
    </message>
    <message>
        <source>the result is not the sum of c x: %1 = %2 is the difference</source>
        <translation>o resultado não é a soma dos c x: %1 = %2 é a diferença</translation>
    </message>
    <message>
        <source>the sheet %1 has no row %2 to leave out</source>
        <translation>a folha %1 não tem linha %2 para omitir</translation>
    </message>
    <message>
        <source>%1 is no place of a cell; D3 is one</source>
        <translation>%1 não é o lugar de uma célula; D3 é um</translation>
    </message>
    <message>
        <source>point %1 with other coordinates: those of line %2 are taken</source>
        <translation>ponto %1 com outras coordenadas: são tomadas as da linha %2</translation>
    </message>
    <message>
        <source>%1 determinations of the same points (&lt;coordinates&gt; of lines %2): each is an artefact of its own; keep all of them, or delete those that you do not want</source>
        <translation>%1 determinações dos mesmos pontos (&lt;coordinates&gt; das linhas %2): cada uma é um artefato próprio; mantenha todas, ou apague as que não quer</translation>
    </message>
    <message>
        <source>%1 is no number: write %2, with a point</source>
        <translation>%1 não é um número: escreva %2, com ponto</translation>
    </message>
    <message>
        <source>the name of the result %1 of %2</source>
        <translation>o nome do resultado %1 de %2</translation>
    </message>
    <message>
        <source>the names of the results %1 of %2</source>
        <translation>os nomes dos resultados %1 de %2</translation>
    </message>
    <message>
        <source>the certificate calls it by its symbol alone: %1 must be stated (ISO/IEC 17025 %2)</source>
        <translation>o certificado chama-o só pelo seu símbolo: deve ser indicado %1 (ISO/IEC 17025 %2)</translation>
    </message>
    <message>
        <source>under an accreditation U is stated for a coverage probability of about 95 % (ILAC-P14 5.3); here it is %1</source>
        <translation>sob acreditação, U é declarada para uma probabilidade de abrangência de cerca de 95 % (ILAC-P14 5.3); aqui é %1</translation>
    </message>
    <message>
        <source>%1: the file states %2, this budget gives %3, %4 apart</source>
        <translation>%1: o arquivo declara %2, este balanço dá %3, uma diferença de %4</translation>
    </message>
    <message>
        <source>%1: FIND OUT WHY before it is used</source>
        <translation>%1: DESCUBRA PORQUÊ antes de ser usado</translation>
    </message>
    <message>
        <source>u(%1) by its contributions</source>
        <translation>u(%1) pelas suas contribuições</translation>
    </message>
    <message>
        <source>%1: the file states no result that this budget could be held against</source>
        <translation>%1: o arquivo não declara nenhum resultado com que este balanço possa ser comparado</translation>
    </message>
    <message>
        <source>another one has the same id</source>
        <translation>outro tem o mesmo identificador</translation>
    </message>
    <message>
        <source>%1: of what the rule accepts %2 does not conform, of what it rejects %3 does.</source>
        <translation>%1: do que a regra aceita, %2 não é conforme; do que rejeita, %3 é.</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Índice</translation>
    </message>
    <message>
        <source>%1 further components of %2 other sources</source>
        <translation>mais %1 componentes de %2 outras fontes</translation>
    </message>
    <message>
        <source>other sources</source>
        <translation>outras fontes</translation>
    </message>
    <message>
        <source>1 further component: %1</source>
        <translation>mais 1 componente: %1</translation>
    </message>
    <message>
        <source>%1 further components: %2</source>
        <translation>mais %1 componentes: %2</translation>
    </message>
    <message>
        <source>Left out: %1 components that contribute nothing (less than 10⁻⁹ of u_c).</source>
        <translation>Omitidas: %1 componentes que não contribuem nada (menos de 10⁻⁹ de u_c).</translation>
    </message>
    <message>
        <source>Left out, because they contribute nothing (less than 10⁻⁹ of u_c): %1.</source>
        <translation>Omitidas, porque não contribuem nada (menos de 10⁻⁹ de u_c): %1.</translation>
    </message>
    <message>
        <source>Stated in the results: %1 = %2 (propagation of distributions).</source>
        <translation>Declarado nos resultados: %1 = %2 (propagação de distribuições).</translation>
    </message>
    <message>
        <source>%1: under an accreditation U is stated for a coverage probability of about 95 % (ILAC-P14 5.3); with k = %2 that of %3 is %4</source>
        <translation>%1: sob acreditação, U é declarada para uma probabilidade de abrangência de cerca de 95 % (ILAC-P14 5.3); com k = %2 a de %3 é %4</translation>
    </message>
    <message>
        <source>not drawn, for it is farther away than 10¹² km: %1</source>
        <translation>não desenhado, porque está a mais de 10¹² km: %1</translation>
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
        <translation>número esperado de eventos</translation>
    </message>
    <message>
        <source>step of one event</source>
        <translation>passo de um evento</translation>
    </message>
    <message>
        <source>probability</source>
        <translation>probabilidade</translation>
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
        <translation>75 nm: incerteza-padrão
2 ppm: incerteza-padrão, uma parte do valor; absoluta onde a grandeza é ela mesma uma razão
U = 0.3 um, k = 2 (ou p = 95 %): certificado
s = 13 nm, n = 5: desvio-padrão conhecido de antes, média de n observações (tipo A)
rectangular 0.5 (ou rect, ±): limites em torno do valor; igualmente triangular, arcsine
limits 19.5 to 20.5: dão o valor
10.1; 10.3; 10.2: observações
resolution 0.01, MPE 3 + 0.1 %, counts 12, constant
Laplace 0.3, Weibull 0.3 (desvios-padrão), Weibull scale 2, shape 1.5
Poisson 12, binomial n = 50, p = 2 %: dão o valor
sample 1; 2; 3 weights 2; 5; 2 (sorteados como são), histogram 0; 1; 2 weights 5; 8 (bordas)
nu 18 atrás de qualquer um deles: graus de liberdade</translation>
    </message>
    <message>
        <source>sample</source>
        <translation>amostra</translation>
    </message>
    <message>
        <source>weights</source>
        <translation>pesos</translation>
    </message>
    <message>
        <source>Network adjustment</source>
        <translation>Ajustamento de rede</translation>
    </message>
    <message>
        <source>Coordinates of stations and targets from the distances, directions, angles and height differences that were read between them: heights, plane or space, free or held by known points, with the reliability of each reading.</source>
        <translation>Coordenadas de estações e alvos a partir das distâncias, direções, ângulos e desníveis lidos entre eles: alturas, plano ou espaço, livre ou apoiada em pontos conhecidos, com a confiabilidade de cada leitura.</translation>
    </message>
    <message>
        <source>Uncertainties follow from those that were stated for the readings; they are not multiplied by s_0, which is a test of them.</source>
        <translation>As incertezas resultam das declaradas para as leituras; não são multiplicadas por s_0, que é um teste delas.</translation>
    </message>
    <message>
        <source>In a free network what no reading tells is taken from the approximate coordinates of the points of the datum: the sum of squares of their changes is least. Residuals, s_0 and redundancies do not depend on the datum.</source>
        <translation>Em uma rede livre, o que nenhuma leitura determina é tomado das coordenadas aproximadas dos pontos do datum: a soma dos quadrados de suas variações é mínima. Resíduos, s_0 e redundâncias não dependem do datum.</translation>
    </message>
    <message>
        <source>Each round of directions has an orientation that is not known. Instruments are levelled unless the set-up says how they lean: zenith angles count from the vertical, the z-axis at all points.</source>
        <translation>Cada série de direções tem uma orientação que não é conhecida. Os instrumentos estão nivelados, a menos que a configuração diga como se inclinam: ângulos zenitais contam a partir da vertical, o eixo z em todos os pontos.</translation>
    </message>
    <message>
        <source>Smallest detectable errors are those of a test at 0.1 % with a power of 80 % (delta_0 = 4.132), with the uncertainties that were stated.</source>
        <translation>Os menores erros detectáveis são os de um teste a 0,1 % com poder de 80 % (delta_0 = 4,132), com as incertezas declaradas.</translation>
    </message>
    <message>
        <source>In Monte Carlo each trial is a solution with the derivatives at the estimates, repeated until it stands still.</source>
        <translation>Em Monte Carlo cada ensaio é uma solução com as derivadas nas estimativas, repetida até que não mude mais.</translation>
    </message>
    <message>
        <source>Stations and targets alike, with what is known of them beforehand.</source>
        <translation>Tanto estações como alvos, com o que se sabe deles de antemão.</translation>
    </message>
    <message>
        <source>Coordinate x; of an unknown point an approximate one, or empty: the readings place it.</source>
        <translation>Coordenada x; de um ponto desconhecido, uma aproximada, ou vazio: as leituras o situam.</translation>
    </message>
    <message>
        <source>Coordinate y; of an unknown point an approximate one, or empty: the readings place it.</source>
        <translation>Coordenada y; de um ponto desconhecido, uma aproximada, ou vazio: as leituras o situam.</translation>
    </message>
    <message>
        <source>Coordinate z; of an unknown point an approximate one, or empty: the readings place it.</source>
        <translation>Coordenada z; de um ponto desconhecido, uma aproximada, ou vazio: as leituras o situam.</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>plano</translation>
    </message>
    <message>
        <source>What is known of x and y: unknown; unknown, and what no reading tells is taken from this point and others like it (free network); fixed without uncertainty; stated with u.</source>
        <translation>O que se sabe de x e y: incógnitas; incógnitas, e o que nenhuma leitura determina é tomado deste ponto e de outros como ele (rede livre); fixas, sem incerteza; declaradas com u.</translation>
    </message>
    <message>
        <source>unknown, of the datum</source>
        <translation>incógnita, do datum</translation>
    </message>
    <message>
        <source>stated with u</source>
        <translation>declarada com u</translation>
    </message>
    <message>
        <source>not part of the network</source>
        <translation>não faz parte da rede</translation>
    </message>
    <message>
        <source>height</source>
        <translation>altura</translation>
    </message>
    <message>
        <source>What is known of z, likewise.</source>
        <translation>O que se sabe de z, do mesmo modo.</translation>
    </message>
    <message>
        <source>Standard uncertainty of a stated coordinate.</source>
        <translation>Incerteza-padrão de uma coordenada declarada.</translation>
    </message>
    <message>
        <source>Distances between points that are measurands too.</source>
        <translation>Distâncias entre pontos que também são mensurandos.</translation>
    </message>
    <message>
        <source>Name of a point.</source>
        <translation>Nome de um ponto.</translation>
    </message>
    <message>
        <source>Name of another point.</source>
        <translation>Nome de outro ponto.</translation>
    </message>
    <message>
        <source>Directions grow</source>
        <translation>Direções crescem</translation>
    </message>
    <message>
        <source>In which sense directions, angles and azimuths grow, and from which axis azimuths count.</source>
        <translation>Em que sentido crescem direções, ângulos e azimutes, e a partir de que eixo contam os azimutes.</translation>
    </message>
    <message>
        <source>from x towards y; azimuths count from x</source>
        <translation>de x para y; azimutes contam a partir de x</translation>
    </message>
    <message>
        <source>from y towards x; azimuths count from y</source>
        <translation>de y para x; azimutes contam a partir de y</translation>
    </message>
    <message>
        <source>What was read between the points, one row for each figure, typed or from a CSV file.</source>
        <translation>O que se leu entre os pontos, uma linha para cada número, digitada ou de um arquivo CSV.</translation>
    </message>
    <message>
        <source>label</source>
        <translation>rótulo</translation>
    </message>
    <message>
        <source>By which a correlation calls it.</source>
        <translation>O nome com que uma correlação a designa.</translation>
    </message>
    <message>
        <source>What was read.</source>
        <translation>O que se leu.</translation>
    </message>
    <message>
        <source>slope distance</source>
        <translation>distância inclinada</translation>
    </message>
    <message>
        <source>horizontal distance</source>
        <translation>distância horizontal</translation>
    </message>
    <message>
        <source>zenith angle</source>
        <translation>ângulo zenital</translation>
    </message>
    <message>
        <source>height difference</source>
        <translation>desnível</translation>
    </message>
    <message>
        <source>x of a point</source>
        <translation>x de um ponto</translation>
    </message>
    <message>
        <source>y of a point</source>
        <translation>y de um ponto</translation>
    </message>
    <message>
        <source>z of a point</source>
        <translation>z de um ponto</translation>
    </message>
    <message>
        <source>difference of x</source>
        <translation>diferença de x</translation>
    </message>
    <message>
        <source>difference of y</source>
        <translation>diferença de y</translation>
    </message>
    <message>
        <source>difference of z</source>
        <translation>diferença de z</translation>
    </message>
    <message>
        <source>The point where it was read; of a coordinate its point.</source>
        <translation>O ponto onde se leu; de uma coordenada, seu ponto.</translation>
    </message>
    <message>
        <source>The point that was sighted.</source>
        <translation>O ponto que se visou.</translation>
    </message>
    <message>
        <source>Of an angle the point at its second leg.</source>
        <translation>De um ângulo, o ponto em seu segundo lado.</translation>
    </message>
    <message>
        <source>round</source>
        <translation>série</translation>
    </message>
    <message>
        <source>Of a direction: rounds of one station between which its circle was turned have names; each has an orientation of its own.</source>
        <translation>De uma direção: séries de uma estação entre as quais seu círculo foi girado têm nomes; cada uma tem uma orientação própria.</translation>
    </message>
    <message>
        <source>A length or coordinate as read.</source>
        <translation>Um comprimento ou coordenada como foi lido.</translation>
    </message>
    <message>
        <source>An angle as read.</source>
        <translation>Um ângulo como foi lido.</translation>
    </message>
    <message>
        <source>u of length</source>
        <translation>u do comprimento</translation>
    </message>
    <message>
        <source>Standard uncertainty of the length.</source>
        <translation>Incerteza-padrão do comprimento.</translation>
    </message>
    <message>
        <source>u of angle</source>
        <translation>u do ângulo</translation>
    </message>
    <message>
        <source>Standard uncertainty of the angle.</source>
        <translation>Incerteza-padrão do ângulo.</translation>
    </message>
    <message>
        <source>height from</source>
        <translation>altura de</translation>
    </message>
    <message>
        <source>Height of the instrument above its point.</source>
        <translation>Altura do instrumento acima de seu ponto.</translation>
    </message>
    <message>
        <source>height to</source>
        <translation>altura até</translation>
    </message>
    <message>
        <source>Height of the target above its point.</source>
        <translation>Altura do alvo acima de seu ponto.</translation>
    </message>
    <message>
        <source>Instruments that are not levelled</source>
        <translation>Instrumentos que não estão nivelados</translation>
    </message>
    <message>
        <source>Where an instrument stands that is not levelled, or not exactly; all others are.</source>
        <translation>Onde está um instrumento que não está nivelado, ou não exatamente; todos os outros estão.</translation>
    </message>
    <message>
        <source>The point where the instrument stands.</source>
        <translation>O ponto onde está o instrumento.</translation>
    </message>
    <message>
        <source>tilt</source>
        <translation>inclinação</translation>
    </message>
    <message>
        <source>How it leans: unknown, so that the readings tell it; or levelled within u, about x and about y.</source>
        <translation>Como se inclina: incógnita, de modo que as leituras a determinam; ou nivelado dentro de u, em torno de x e em torno de y.</translation>
    </message>
    <message>
        <source>levelled within u</source>
        <translation>nivelado dentro de u</translation>
    </message>
    <message>
        <source>u of tilt</source>
        <translation>u da inclinação</translation>
    </message>
    <message>
        <source>Standard uncertainty of each tilt of a levelled instrument.</source>
        <translation>Incerteza-padrão de cada inclinação de um instrumento nivelado.</translation>
    </message>
    <message>
        <source>Correlations of readings</source>
        <translation>Correlações das leituras</translation>
    </message>
    <message>
        <source>Correlation coefficients of readings: they change the weights and the uncertainty.</source>
        <translation>Coeficientes de correlação das leituras: mudam os pesos e a incerteza.</translation>
    </message>
    <message>
        <source>Label of a reading.</source>
        <translation>Rótulo de uma leitura.</translation>
    </message>
    <message>
        <source>Label of another reading.</source>
        <translation>Rótulo de outra leitura.</translation>
    </message>
    <message>
        <source>Correlation coefficient of the two.</source>
        <translation>Coeficiente de correlação das duas.</translation>
    </message>
    <message>
        <source>Two targets from two stations that nobody measured</source>
        <translation>Dois alvos a partir de duas estações que ninguém mediu</translation>
    </message>
    <message>
        <source>A total station stood at S1 and S2, whose places are not known.</source>
        <translation>Uma estação total esteve em S1 e S2, cujas posições não são conhecidas.</translation>
    </message>
    <message>
        <source>The law of propagation of uncertainty says nothing of %1 at these estimates: Monte Carlo answers alone</source>
        <translation>A lei de propagação de incertezas nada diz de %1 nestas estimativas: só Monte Carlo responde</translation>
    </message>
    <message>
        <source>The standard uncertainty by Monte Carlo of %1 is not known from these trials, and may not exist: the tails of its distribution are too heavy. Use the coverage interval.</source>
        <translation>A incerteza-padrão por Monte Carlo de %1 não é conhecida por estes ensaios, e pode não existir: as caudas de sua distribuição são pesadas demais. Use o intervalo de abrangência.</translation>
    </message>
    <message>
        <source>as stated</source>
        <translation>como declarado</translation>
    </message>
    <message>
        <source>tilt at %1 about %2</source>
        <translation>inclinação em %1 em torno de %2</translation>
    </message>
    <message>
        <source>orientation at %1</source>
        <translation>orientação em %1</translation>
    </message>
    <message>
        <source>orientation at %1, round %2</source>
        <translation>orientação em %1, série %2</translation>
    </message>
    <message>
        <source>readings l, their residuals v, unknowns x</source>
        <translation>leituras l, seus resíduos v, incógnitas x</translation>
    </message>
    <message>
        <source>least squares, Gauss-Newton method</source>
        <translation>mínimos quadrados, método de Gauss-Newton</translation>
    </message>
    <message>
        <source>law of propagation; generalised inverse of the datum</source>
        <translation>lei de propagação; inversa generalizada do datum</translation>
    </message>
    <message>
        <source>free network: W. Baarda, S-transformations, 1973</source>
        <translation>rede livre: W. Baarda, S-transformations, 1973</translation>
    </message>
    <message>
        <source>redundancy and test of a reading: W. Baarda, A testing procedure, 1968</source>
        <translation>redundância e teste de uma leitura: W. Baarda, A testing procedure, 1968</translation>
    </message>
    <message>
        <source>smallest error of a reading that the test finds</source>
        <translation>menor erro de uma leitura que o teste encontra</translation>
    </message>
    <message>
        <source>a posteriori; uncertainties are those that were stated, not times s₀</source>
        <translation>a posteriori; as incertezas são as declaradas, não multiplicadas por s₀</translation>
    </message>
    <message>
        <source>slope distance %1 – %2</source>
        <translation>distância inclinada %1 – %2</translation>
    </message>
    <message>
        <source>horizontal distance %1 – %2</source>
        <translation>distância horizontal %1 – %2</translation>
    </message>
    <message>
        <source>direction %1 – %2</source>
        <translation>direção %1 – %2</translation>
    </message>
    <message>
        <source>azimuth %1 – %2</source>
        <translation>azimute %1 – %2</translation>
    </message>
    <message>
        <source>zenith angle %1 – %2</source>
        <translation>ângulo zenital %1 – %2</translation>
    </message>
    <message>
        <source>height difference %1 – %2</source>
        <translation>desnível %1 – %2</translation>
    </message>
    <message>
        <source>tilt about x of the instrument at %1</source>
        <translation>inclinação em torno de x do instrumento em %1</translation>
    </message>
    <message>
        <source>tilt about y of the instrument at %1</source>
        <translation>inclinação em torno de y do instrumento em %1</translation>
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
        <translation>diferença de x, %1 – %2</translation>
    </message>
    <message>
        <source>difference of y, %1 – %2</source>
        <translation>diferença de y, %1 – %2</translation>
    </message>
    <message>
        <source>difference of z, %1 – %2</source>
        <translation>diferença de z, %1 – %2</translation>
    </message>
    <message>
        <source>the readings do not lead to a place of every point: the adjustment does not converge; look for exchanged or mistyped readings, for a unit that was mixed up (gon and degrees, m and mm), and for coordinates that are far off</source>
        <translation>as leituras não levam a uma posição de cada ponto: o ajustamento não converge; procure leituras trocadas ou mal digitadas, uma unidade confundida (gon e graus, m e mm) e coordenadas muito afastadas</translation>
    </message>
    <message>
        <source>and %1 further ways in which the points can move</source>
        <translation>e mais %1 modos em que os pontos podem mover-se</translation>
    </message>
    <message>
        <source>point %1: its %2 is said to be known, and is missing</source>
        <translation>ponto %1: seu %2 é dado como conhecido, e falta</translation>
    </message>
    <message>
        <source>point %1: the u of its stated %2 is missing</source>
        <translation>ponto %1: falta a u de seu %2 declarado</translation>
    </message>
    <message>
        <source>the name of a point is missing</source>
        <translation>falta o nome de um ponto</translation>
    </message>
    <message>
        <source>there is no point %1</source>
        <translation>não há ponto %1</translation>
    </message>
    <message>
        <source>the instrument at %1: the u of its tilt is missing</source>
        <translation>o instrumento em %1: falta a u de sua inclinação</translation>
    </message>
    <message>
        <source>two instruments stand at %1</source>
        <translation>dois instrumentos estão em %1</translation>
    </message>
    <message>
        <source>a reading from %1 to itself</source>
        <translation>uma leitura de %1 para si mesmo</translation>
    </message>
    <message>
        <source>both legs of the angle at %1 go to %2</source>
        <translation>ambos os lados do ângulo em %1 vão a %2</translation>
    </message>
    <message>
        <source>%1: its value is missing</source>
        <translation>%1: falta seu valor</translation>
    </message>
    <message>
        <source>%1: its standard uncertainty is missing</source>
        <translation>%1: falta sua incerteza-padrão</translation>
    </message>
    <message>
        <source>%1 is an angle and has a length</source>
        <translation>%1 é um ângulo e tem um comprimento</translation>
    </message>
    <message>
        <source>%1 is a length and has an angle</source>
        <translation>%1 é um comprimento e tem um ângulo</translation>
    </message>
    <message>
        <source>%1 is not positive</source>
        <translation>%1: o valor não é positivo</translation>
    </message>
    <message>
        <source>%1 is not between 0 and half a turn: state the mean of both faces</source>
        <translation>%1 não está entre 0 e meia volta: declare a média das duas posições da luneta</translation>
    </message>
    <message>
        <source>%1 needs the height of %2, which is not part of the network</source>
        <translation>%1 precisa da altura de %2, que não faz parte da rede</translation>
    </message>
    <message>
        <source>%1 needs x and y of %2, which are not part of the network</source>
        <translation>%1 precisa de x e y de %2, que não fazem parte da rede</translation>
    </message>
    <message>
        <source>a distance needs two points</source>
        <translation>uma distância precisa de dois pontos</translation>
    </message>
    <message>
        <source>all points are fixed: there is nothing to be found</source>
        <translation>todos os pontos são fixos: não há nada a determinar</translation>
    </message>
    <message>
        <source>two readings have the label %1</source>
        <translation>duas leituras têm o rótulo %1</translation>
    </message>
    <message>
        <source>there is no reading with the label %1</source>
        <translation>não há leitura com o rótulo %1</translation>
    </message>
    <message>
        <source>reading %1 with itself</source>
        <translation>leitura %1 consigo mesma</translation>
    </message>
    <message>
        <source>the correlation coefficients are not possible together</source>
        <translation>os coeficientes de correlação não são possíveis juntos</translation>
    </message>
    <message>
        <source>the readings do not place point %1: too few of them tie it to the others; add readings, or state approximate coordinates</source>
        <translation>as leituras não situam o ponto %1: são poucas demais as que o ligam aos outros; acrescente leituras, ou declare coordenadas aproximadas</translation>
    </message>
    <message>
        <source>the readings do not place %1 points (%2): too few tie them to the others; add readings, or state approximate coordinates</source>
        <translation>as leituras não situam %1 pontos (%2): são poucas demais as que os ligam aos outros; acrescente leituras, ou declare coordenadas aproximadas</translation>
    </message>
    <message>
        <source>Adjustment</source>
        <translation>Ajustamento</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Número</translation>
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
        <translation>o que nenhuma leitura determina (defeito de datum)</translation>
    </message>
    <message>
        <source>degrees of freedom f</source>
        <translation>graus de liberdade f</translation>
    </message>
    <message>
        <source>sum of squares vᵀ C⁻¹ v</source>
        <translation>soma de quadrados vᵀ C⁻¹ v</translation>
    </message>
    <message>
        <source>s₀ a posteriori</source>
        <translation>s₀ a posteriori</translation>
    </message>
    <message>
        <source>δ₀ of smallest detectable errors (0.1 %, 80 %)</source>
        <translation>δ₀ dos menores erros detectáveis (0,1 %, 80 %)</translation>
    </message>
    <message>
        <source>smallest detectable error</source>
        <translation>menor erro detectável</translation>
    </message>
    <message>
        <source>its largest effect</source>
        <translation>seu maior efeito</translation>
    </message>
    <message>
        <source>on</source>
        <translation>em</translation>
    </message>
    <message>
        <source>%1 The residuals are larger than the uncertainties allow; the largest for its uncertainty is the %2. Look for mistyped or exchanged readings, or uncertainties that are too small</source>
        <translation>%1 Os resíduos são maiores do que as incertezas permitem; o maior para sua incerteza é %2. Procure leituras mal digitadas ou trocadas, ou incertezas pequenas demais</translation>
    </message>
    <message>
        <source>nothing was read of point %1: add readings to it, or take it out</source>
        <translation>nada foi lido do ponto %1: acrescente leituras para ele, ou retire-o</translation>
    </message>
    <message>
        <source>nothing tells how the instrument at %1 stood: add directions or angles from there to places that are known</source>
        <translation>nada diz como estava o instrumento em %1: acrescente direções ou ângulos dali para lugares conhecidos</translation>
    </message>
    <message>
        <source>nothing tells the height of %1: state it, or add a height difference, or a zenith angle with a distance</source>
        <translation>nada diz a altura de %1: declare-a, ou acrescente um desnível, ou um ângulo zenital com uma distância</translation>
    </message>
    <message>
        <source>nothing tells where %1 is: add readings to it</source>
        <translation>nada diz onde está %1: acrescente leituras para ele</translation>
    </message>
    <message>
        <source>point %1 can move along %2 without changing a reading: add one that sees this</source>
        <translation>o ponto %1 pode mover-se ao longo de %2 sem mudar uma leitura: acrescente uma que o detecte</translation>
    </message>
    <message>
        <source>the direction (%1, %2, %3)</source>
        <translation>a direção (%1, %2, %3)</translation>
    </message>
    <message>
        <source>the whole network</source>
        <translation>a rede inteira</translation>
    </message>
    <message>
        <source>the part with %1 and %2 more</source>
        <translation>a parte com %1 e mais %2</translation>
    </message>
    <message>
        <source>the part with %1</source>
        <translation>a parte com %1</translation>
    </message>
    <message>
        <source>nothing tells where %1 is along %2: fix or state a point, or let points be of the datum</source>
        <translation>nada diz onde está %1 ao longo de %2: fixe ou declare um ponto, ou ponha pontos no datum</translation>
    </message>
    <message>
        <source>nothing tells the height of %1: fix or state the height of a point, or let heights be of the datum</source>
        <translation>nada diz a altura de %1: fixe ou declare a altura de um ponto, ou ponha alturas no datum</translation>
    </message>
    <message>
        <source>%1 may tilt about %2: add zenith angles or height differences, or fix a third point</source>
        <translation>%1 pode inclinar-se em torno de %2: acrescente ângulos zenitais ou desníveis, ou fixe um terceiro ponto</translation>
    </message>
    <message>
        <source>%1 may turn about the vertical: add an azimuth, fix a second point, or let points be of the datum</source>
        <translation>%1 pode girar em torno da vertical: acrescente um azimute, fixe um segundo ponto, ou ponha pontos no datum</translation>
    </message>
    <message>
        <source>nothing tells the scale of %1: add a distance, fix a second point, or let points be of the datum</source>
        <translation>nada diz a escala de %1: acrescente uma distância, fixe um segundo ponto, ou ponha pontos no datum</translation>
    </message>
    <message>
        <source>the readings leave open a common movement of %1: add readings that tie them to the others</source>
        <translation>as leituras deixam em aberto um movimento comum de %1: acrescente leituras que os liguem aos outros</translation>
    </message>
    <message>
        <source>orientations</source>
        <translation>orientações</translation>
    </message>
    <message>
        <source>moving platform</source>
        <translation>plataforma móvel</translation>
    </message>
    <message>
        <source>lengths</source>
        <translation>comprimentos</translation>
    </message>
    <message>
        <source>measured orientations</source>
        <translation>orientações medidas</translation>
    </message>
    <message>
        <source>measured positions</source>
        <translation>posições medidas</translation>
    </message>
    <message>
        <source>readings of the joints</source>
        <translation>leituras das juntas</translation>
    </message>
    <message>
        <source>circle of %1</source>
        <translation>círculo de %1</translation>
    </message>
    <message>
        <source>regression</source>
        <translation>regressão</translation>
    </message>
    <message>
        <source>it cannot be varied: %1</source>
        <translation>não pode ser variado: %1</translation>
    </message>
    <message>
        <source>no more than %1</source>
        <translation>não mais que %1</translation>
    </message>
    <message>
        <source>an observation of %1, which the file neither fixes nor adjusts in what it needs</source>
        <translation>uma observação de %1, que o arquivo não fixa nem ajusta no que ela precisa</translation>
    </message>
    <message>
        <source>an observation of %1 without a standard deviation</source>
        <translation>uma observação de %1 sem desvio-padrão</translation>
    </message>
    <message>
        <source>a network of %1 points with %2 readings, which is adjusted</source>
        <translation>uma rede de %1 pontos com %2 leituras, que é ajustada</translation>
    </message>
    <message>
        <source>its heights above the points are no numbers</source>
        <translation>suas alturas acima dos pontos não são números</translation>
    </message>
    <message>
        <source>column %1%2 of sheet %3 is filled but not understood: state what each column is, %4, with one of %5 in place of ? (- leaves the column out)</source>
        <translation>a coluna %1%2 da folha %3 está preenchida, mas não é entendida: declare o que é cada coluna, %4, com um de %5 no lugar de ? (- omite a coluna)</translation>
    </message>
    <message>
        <source>There is no budget of %1: the law of propagation of uncertainty says nothing of it at the estimates of its input quantities.</source>
        <translation>Não há balanço de %1: a lei de propagação de incertezas nada diz dele nas estimativas de suas grandezas de entrada.</translation>
    </message>
    <message>
        <source>out</source>
        <translation>saída</translation>
    </message>
    <message>
        <source>%1 trials</source>
        <translation>%1 ensaios</translation>
    </message>
    <message>
        <source>sight</source>
        <translation>visada</translation>
    </message>
    <message>
        <source>force, own scale</source>
        <translation>força, escala própria</translation>
    </message>
    <message>
        <source>moment, own scale</source>
        <translation>momento, escala própria</translation>
    </message>
    <message>
        <source>in</source>
        <translation>entrada</translation>
    </message>
    <message>
        <source>uncertainty %1</source>
        <translation>incerteza %1</translation>
    </message>
    <message>
        <source>ellipsoids %1, %2</source>
        <translation>elipsoides %1, %2</translation>
    </message>
    <message>
        <source>Uncertainties of the readings</source>
        <translation>Incertezas das leituras</translation>
    </message>
    <message>
        <source>As typed in the table; or as the residuals of this adjustment see them: typed ones times one common factor s_0, or times the factor of each kind of reading and instrument (variance components). Either has the degrees of freedom of its estimate.</source>
        <translation>Como digitadas na tabela; ou como as mostram os resíduos deste ajustamento: as digitadas vezes um fator comum s_0, ou vezes o fator de cada tipo de leitura e instrumento (componentes de variância). Nos dois casos, com os graus de liberdade de sua estimativa.</translation>
    </message>
    <message>
        <source>as seen, one factor s_0</source>
        <translation>como observado, um fator s_0</translation>
    </message>
    <message>
        <source>as seen, a factor for each figure</source>
        <translation>como observado, um fator para cada número</translation>
    </message>
    <message>
        <source>Are the figures of the data sheet true?</source>
        <translation>Os números da folha de dados são verdadeiros?</translation>
    </message>
    <message>
        <source>A section of a barrel, 8 m long, with 20 targets, read by a total station from three places that nobody measured.</source>
        <translation>Uma seção cilíndrica de 8 m de comprimento, com 20 alvos, lida por uma estação total a partir de três lugares que ninguém mediu.</translation>
    </message>
    <message>
        <source>slope distances</source>
        <translation>distâncias inclinadas</translation>
    </message>
    <message>
        <source>horizontal distances</source>
        <translation>distâncias horizontais</translation>
    </message>
    <message>
        <source>directions</source>
        <translation>direções</translation>
    </message>
    <message>
        <source>azimuths</source>
        <translation>azimutes</translation>
    </message>
    <message>
        <source>zenith angles</source>
        <translation>ângulos zenitais</translation>
    </message>
    <message>
        <source>height differences</source>
        <translation>desníveis</translation>
    </message>
    <message>
        <source>tilts of instruments</source>
        <translation>inclinações de instrumentos</translation>
    </message>
    <message>
        <source>stated coordinates</source>
        <translation>coordenadas declaradas</translation>
    </message>
    <message>
        <source>coordinates</source>
        <translation>coordenadas</translation>
    </message>
    <message>
        <source>coordinate differences</source>
        <translation>diferenças de coordenadas</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 e %2</translation>
    </message>
    <message>
        <source>The readings have no residuals that could tell their uncertainty: it stays as stated</source>
        <translation>As leituras não têm resíduos que pudessem dizer sua incerteza: ela fica como declarada</translation>
    </message>
    <message>
        <source>Nothing is redundant: uncertainties of the readings stay as stated</source>
        <translation>Nada é redundante: as incertezas das leituras ficam como declaradas</translation>
    </message>
    <message>
        <source>The residuals give no factors: uncertainties of the readings stay as stated</source>
        <translation>Os resíduos não dão fatores: as incertezas das leituras ficam como declaradas</translation>
    </message>
    <message>
        <source>Too little redundancy to say, so they stay as stated: %1</source>
        <translation>Redundância insuficiente para um veredito; ficam como declaradas: %1</translation>
    </message>
    <message>
        <source>as seen: %1 times what was stated</source>
        <translation>como observado: %1 vezes o declarado</translation>
    </message>
    <message>
        <source>measured places</source>
        <translation>lugares medidos</translation>
    </message>
    <message>
        <source>encoders of the joints</source>
        <translation>codificadores das juntas</translation>
    </message>
    <message>
        <source>repeatability of the joints</source>
        <translation>repetibilidade das juntas</translation>
    </message>
    <message>
        <source>Residuals over their standard uncertainties as stated</source>
        <translation>Resíduos divididos por suas incertezas-padrão como declaradas</translation>
    </message>
    <message>
        <source>others</source>
        <translation>outros</translation>
    </message>
    <message>
        <source>Quantiles of the residuals</source>
        <translation>Quantis dos resíduos</translation>
    </message>
    <message>
        <source>normal distribution</source>
        <translation>distribuição normal</translation>
    </message>
    <message>
        <source>The readings cannot tell apart, and give one factor to: %1.</source>
        <translation>As leituras não conseguem distinguir, e dão um só fator a: %1.</translation>
    </message>
    <message>
        <source>The estimate of the variance was negative, so it is zero, of: %1.</source>
        <translation>A estimativa da variância foi negativa, e por isso é zero, de: %1.</translation>
    </message>
    <message>
        <source>The global test does not see that figures which are too large and figures which are too small make up for each other: %1.</source>
        <translation>O teste global não percebe que números grandes demais e números pequenos demais se compensam: %1.</translation>
    </message>
    <message>
        <source>seen is smaller</source>
        <translation>a observada é menor</translation>
    </message>
    <message>
        <source>seen is larger</source>
        <translation>a observada é maior</translation>
    </message>
    <message>
        <source>too little to say</source>
        <translation>insuficiente para um veredito</translation>
    </message>
    <message>
        <source>Stated and seen uncertainties</source>
        <translation>Incertezas declaradas e observadas</translation>
    </message>
    <message>
        <source>figure</source>
        <translation>número</translation>
    </message>
    <message>
        <source>stated u</source>
        <translation>u declarada</translation>
    </message>
    <message>
        <source>factor</source>
        <translation>fator</translation>
    </message>
    <message>
        <source>seen u</source>
        <translation>u observada</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>veredito</translation>
    </message>
    <message>
        <source>Nothing is redundant: the readings say nothing.</source>
        <translation>Nada é redundante: as leituras não dizem nada.</translation>
    </message>
    <message>
        <source>More than %1 readings: their factors are not computed.</source>
        <translation>Mais de %1 leituras: seus fatores não são calculados.</translation>
    </message>
    <message>
        <source>The factors of the figures do not come to rest.</source>
        <translation>Os fatores dos números não convergem.</translation>
    </message>
    <message>
        <source>Global test: s₀ = %1 with %2 degrees of freedom passes (%3 to %4).</source>
        <translation>Teste global: s₀ = %1 com %2 graus de liberdade passa (%3 a %4).</translation>
    </message>
    <message>
        <source>Global test: s₀ = %1 with %2 degrees of freedom fails (%3 to %4).</source>
        <translation>Teste global: s₀ = %1 com %2 graus de liberdade não passa (%3 a %4).</translation>
    </message>
    <message>
        <source>Mean u of a coordinate: %1 as stated, %2 as seen.</source>
        <translation>u média de uma coordenada: %1 como declarado, %2 como observado.</translation>
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
        <translation type="unfinished">a coluna &apos;%1&apos; de &apos;%2&apos; é %3; falta sua unidade: escreva &quot;%1 [%4]&quot; {1&apos;?} {2&apos;?} {3;?} {4 ?} {5]?}</translation>
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
        <translation>Adicionar %1</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>“%1” não é um número.</translation>
    </message>
    <message>
        <source>“%1” is not a unit.</source>
        <translation>“%1” não é uma unidade.</translation>
    </message>
    <message>
        <source>a number without unit is expected.</source>
        <translation>espera-se um número sem unidade.</translation>
    </message>
    <message>
        <source>a unit like %1 is expected.</source>
        <translation>espera-se uma unidade como %1.</translation>
    </message>
    <message>
        <source>The unit %1 does not fit here: </source>
        <translation>A unidade %1 não cabe aqui: </translation>
    </message>
    <message>
        <source>“%1” is not a whole number.</source>
        <translation>“%1” não é um número inteiro.</translation>
    </message>
    <message>
        <source>“%1” is not one of: %2.</source>
        <translation>“%1” não é um destes: %2.</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sim</translation>
    </message>
    <message>
        <source>no</source>
        <translation>não</translation>
    </message>
    <message>
        <source>“%1” is neither yes nor no.</source>
        <translation>“%1” não é sim nem não.</translation>
    </message>
    <message>
        <source>The value must be greater than %1.</source>
        <translation>O valor deve ser maior que %1.</translation>
    </message>
    <message>
        <source>The value must be at least %1.</source>
        <translation>O valor deve ser no mínimo %1.</translation>
    </message>
    <message>
        <source>The value must be at most %1.</source>
        <translation>O valor deve ser no máximo %1.</translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation>Graus de liberdade</translation>
    </message>
    <message>
        <source>Unsaved Changes</source>
        <translation>Alterações não salvas</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>Salvar as alterações em “%1”?</translation>
    </message>
    <message>
        <source>Without saving they are lost.</source>
        <translation>Sem salvar, elas se perdem.</translation>
    </message>
    <message>
        <source>File Changed</source>
        <translation>Arquivo alterado</translation>
    </message>
    <message>
        <source>Another program changed “%1”.</source>
        <translation>Outro programa alterou “%1”.</translation>
    </message>
    <message>
        <source>Reading it again loses your unsaved changes.</source>
        <translation>Ler de novo descarta suas alterações não salvas.</translation>
    </message>
    <message>
        <source>It can be read again.</source>
        <translation>Ele pode ser lido de novo.</translation>
    </message>
    <message>
        <source>Read Again</source>
        <translation>Ler de novo</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>Manter o meu</translation>
    </message>
    <message>
        <source>Recover Unsaved Work</source>
        <translation>Recuperar trabalho não salvo</translation>
    </message>
    <message>
        <source>Covaria did not end properly. Unsaved work was kept:</source>
        <translation>O Covaria não terminou corretamente. O trabalho não salvo foi mantido:</translation>
    </message>
    <message>
        <source>Open Project</source>
        <translation>Abrir projeto</translation>
    </message>
    <message>
        <source>Covaria project or report (*.covaria *.pdf)</source>
        <translation>Projeto ou relatório do Covaria (*.covaria *.pdf)</translation>
    </message>
    <message>
        <source>About Covaria</source>
        <translation>Sobre o Covaria</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Covaria %1&lt;/h3&gt;&lt;p&gt;Measurement uncertainty of robots and large-scale metrology.&lt;br&gt;Evaluates by JCGM 100, 101 and 102.&lt;/p&gt;&lt;p&gt;Qt %2, VTK %3, Eigen %4&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Covaria %1&lt;/h3&gt;&lt;p&gt;Incerteza de medição de robôs e metrologia de grandes volumes.&lt;br&gt;Avalia segundo JCGM 100, 101 e 102.&lt;/p&gt;&lt;p&gt;Qt %2, VTK %3, Eigen %4&lt;/p&gt;</translation>
    </message>
    <message>
        <source>symbol</source>
        <translation>símbolo</translation>
    </message>
    <message>
        <source>As the equations use it; further rows of a symbol add components</source>
        <translation>Como as equações a usam; outras linhas de um símbolo acrescentam componentes</translation>
    </message>
    <message>
        <source>quantity</source>
        <translation>grandeza</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>O que é</translation>
    </message>
    <message>
        <source>estimate</source>
        <translation>estimativa</translation>
    </message>
    <message>
        <source>In the row&apos;s unit: 50.000 838 or 50.000 838 mm</source>
        <translation>Na unidade da linha: 50.000 838 ou 50.000 838 mm</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>unidade</translation>
    </message>
    <message>
        <source>stated as</source>
        <translation>declarado como</translation>
    </message>
    <message>
        <source>distribution</source>
        <translation>distribuição</translation>
    </message>
    <message>
        <source>That Monte Carlo draws</source>
        <translation>Que Monte Carlo sorteia</translation>
    </message>
    <message>
        <source>type</source>
        <translation>tipo</translation>
    </message>
    <message>
        <source>Type A or Type B evaluation (JCGM 100 2.3.2, 2.3.3)</source>
        <translation>Avaliação Tipo A ou Tipo B (JCGM 100 2.3.2, 2.3.3)</translation>
    </message>
    <message>
        <source>Degrees of freedom; empty: infinite, or those of the observations</source>
        <translation>Graus de liberdade; vazio: infinitos, ou os das observações</translation>
    </message>
    <message>
        <source>Standard uncertainty, in the row&apos;s unit</source>
        <translation>Incerteza-padrão, na unidade da linha</translation>
    </message>
    <message>
        <source>Sensitivity coefficient, unit of the result per unit of the row</source>
        <translation>Coeficiente de sensibilidade, unidade do resultado por unidade da linha</translation>
    </message>
    <message>
        <source>Contribution to the standard uncertainty of the result</source>
        <translation>Contribuição para a incerteza-padrão do resultado</translation>
    </message>
    <message>
        <source>share / %</source>
        <translation>parcela / %</translation>
    </message>
    <message>
        <source>Share of the variance, with its part of the covariances</source>
        <translation>Parcela da variância, com sua parte das covariâncias</translation>
    </message>
    <message>
        <source>source</source>
        <translation>fonte</translation>
    </message>
    <message>
        <source>Where the figure comes from</source>
        <translation>De onde vem o número</translation>
    </message>
    <message>
        <source>Standard uncertainty of the position in space: square root of the sum of the variances of its three coordinates</source>
        <translation>Incerteza-padrão da posição no espaço: raiz quadrada da soma das variâncias de suas três coordenadas</translation>
    </message>
    <message>
        <source>, as good as %1 plain trials</source>
        <translation>, tão boa quanto %1 ensaios simples</translation>
    </message>
    <message>
        <source>Preview by the law of propagation, without Monte Carlo</source>
        <translation>Prévia pela lei de propagação, sem Monte Carlo</translation>
    </message>
    <message>
        <source>Preview with %1 trials, before the adaptive procedure</source>
        <translation>Prévia com %1 ensaios, antes do procedimento adaptativo</translation>
    </message>
    <message>
        <source>Preview with %1 of %2 trials</source>
        <translation>Prévia com %1 de %2 ensaios</translation>
    </message>
    <message>
        <source>Law of propagation of uncertainty</source>
        <translation>Lei de propagação da incerteza</translation>
    </message>
    <message>
        <source>Monte Carlo, %1 trials</source>
        <translation>Monte Carlo, %1 ensaios</translation>
    </message>
    <message>
        <source>Out of date: of the project as it was</source>
        <translation>Desatualizado: do projeto como era</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>Duplicar %1</translation>
    </message>
    <message>
        <source>Expanded uncertainty</source>
        <translation>Incerteza expandida</translation>
    </message>
    <message>
        <source>the picture shows no result of the analysis</source>
        <translation>a imagem não mostra nenhum resultado da análise</translation>
    </message>
    <message>
        <source>the coordinates of %1 are no quantities of the analysis</source>
        <translation>as coordenadas de %1 não são grandezas da análise</translation>
    </message>
    <message>
        <source>%1 is a constant: no uncertainty is stated for it</source>
        <translation>%1 é constante: nenhuma incerteza é declarada</translation>
    </message>
    <message>
        <source>the joint covariance of the points is not known</source>
        <translation>a covariância conjunta dos pontos não é conhecida</translation>
    </message>
    <message>
        <source>the angle is too close to 0° or 180°, or the points are too close, for the law of propagation</source>
        <translation>o ângulo está perto demais de 0° ou 180°, ou os pontos próximos demais, para a lei de propagação</translation>
    </message>
    <message>
        <source>the points are too close to each other for the law of propagation</source>
        <translation>os pontos estão próximos demais entre si para a lei de propagação</translation>
    </message>
    <message>
        <source>%1, u = %2</source>
        <translation>%1, u = %2</translation>
    </message>
    <message>
        <source>Angle at %1 between %2 and %3: %4</source>
        <translation>Ângulo em %1 entre %2 e %3: %4</translation>
    </message>
    <message>
        <source>Distance %1 to %2: %3</source>
        <translation>Distância de %1 a %2: %3</translation>
    </message>
    <message>
        <source>; u not stated, because %1</source>
        <translation>; u não é declarada porque %1</translation>
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
        <translation>Direita</translation>
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
        <translation>Esquerda</translation>
    </message>
    <message>
        <source>Add an analysis</source>
        <translation>Adicionar uma análise</translation>
    </message>
    <message>
        <source>The plus sign in the toolbar adds what a project consists of. Choose Measurement equation from its menu.</source>
        <translation>O sinal de mais na barra de ferramentas adiciona as partes de um projeto. Escolha no menu dele Equação de medição.</translation>
    </message>
    <message>
        <source>Name the quantities</source>
        <translation>Dar nome às grandezas</translation>
    </message>
    <message>
        <source>Replace the equation in the field Equations by yours, such as l = l_S + d. Every name that it uses becomes a row of the budget when you leave the field.</source>
        <translation>Substitua a equação do campo Equações pela sua, como l = l_S + d. Cada nome usado nela vira uma linha do balanço ao sair do campo.</translation>
    </message>
    <message>
        <source>State an uncertainty</source>
        <translation>Declarar uma incerteza</translation>
    </message>
    <message>
        <source>Type the estimate of each quantity into its row, such as 50 mm, and what is known of it under “stated as”, such as 75 nm. “rect 30 nm” and “U = 0.3 um, k = 2” are read as they are typed.</source>
        <translation>Digite a estimativa de cada grandeza na linha dela, como 50 mm, e o que se sabe dela em “declarado como”, como 75 nm. “rect 30 nm” e “U = 0.3 um, k = 2” são lidos como digitados.</translation>
    </message>
    <message>
        <source>See the result</source>
        <translation>Ver o resultado</translation>
    </message>
    <message>
        <source>Correlate two quantities</source>
        <translation>Correlacionar duas grandezas</translation>
    </message>
    <message>
        <source>Select two rows of the budget, the second with Ctrl, and type their correlation coefficient r into the field below, such as 0.5. The result takes it into account at once.</source>
        <translation>Selecione duas linhas do balanço, a segunda com Ctrl, e digite o coeficiente de correlação r no campo abaixo, como 0.5. O resultado o considera na hora.</translation>
    </message>
    <message>
        <source>State a requirement</source>
        <translation>Declarar um requisito</translation>
    </message>
    <message>
        <source>Type the uncertainty that must not be exceeded as Target uncertainty. The verdict below it, and in the table of results, follows every change.</source>
        <translation>Digite como incerteza-alvo a que não deve ser ultrapassada. O veredito abaixo, e o da tabela de resultados, acompanha cada mudança.</translation>
    </message>
    <message>
        <source>See what contributes most</source>
        <translation>Ver o que mais contribui</translation>
    </message>
    <message>
        <source>Keep and compare</source>
        <translation>Guardar e comparar</translation>
    </message>
    <message>
        <source>Run the analysis (F5), press Keep as Before, and change a value of the budget. The tab Compare shows the results before and after beside each other.</source>
        <translation>Execute a análise (F5), pressione Manter como antes e mude um valor do balanço. A aba Comparar mostra os resultados de antes e depois lado a lado.</translation>
    </message>
    <message>
        <source>Look at the report</source>
        <translation>Olhar o relatório</translation>
    </message>
    <message>
        <source>Save it as PDF</source>
        <translation>Salvar como PDF</translation>
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

| Tecla | Ação |
|---|---|
| Ctrl+N, Ctrl+O, Ctrl+S | novo, abrir, salvar |
| Ctrl+Z; Ctrl+Shift+Z ou Ctrl+Y | desfazer; refazer |
| F6, Shift+F6 | próximo painel, painel anterior |
| F11 | só o balanço ou a cena, e de volta |
| Tab, Shift+Tab numa tabela | célula seguinte, anterior, e para além da última; com Ctrl, logo para fora da tabela |
| Ctrl+R num orçamento | coeficiente de correlação das duas linhas selecionadas |
| F5, Ctrl+F5, Esc | calcular esta análise, calcular todas, parar |
| F2, Ctrl+D, Delete | renomear, duplicar, excluir a entrada selecionada |
| Setas, + e − | girar e ampliar a cena |
| 1 a 7, F | vista isométrica, superior, frontal, direita, inferior, posterior, esquerda, ajustar (Ctrl+1 a Ctrl+7 em toda parte) |
| H, I, Shift+H | ocultar o selecionado na cena, mostrar só isso, mostrar tudo |
| Arrastar na cena | move um objeto, gira-o pela ponta de um eixo; com Ctrl em passos redondos |
| D, A | medir uma distância, um ângulo na cena; Esc deixa a ferramenta |
| +, −, Ctrl+roda no relatório | páginas maiores, menores; Alt+Acima e Alt+Abaixo: página anterior, próxima |
| Ctrl+C, Ctrl+V | copiar e colar blocos de células |
| Ctrl+K | encontrar qualquer coisa: análises, grandezas, resultados, campos, comandos, ajuda |
| F1 | ajuda sobre o campo, a célula ou a entrada com o foco |
</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Desfazer: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Desfazer</translation>
    </message>
    <message>
        <source>The analysis is not complete yet: what must still be given is listed under Problems.</source>
        <translation>A análise ainda não está completa: o que falta consta em Problemas.</translation>
    </message>
    <message>
        <source>The analysis has problems; they are listed under Problems.</source>
        <translation>A análise tem problemas; constam em Problemas.</translation>
    </message>
    <message>
        <source>Adaptive Monte Carlo, %1 trials</source>
        <translation>Monte Carlo adaptativo, %1 ensaios</translation>
    </message>
    <message>
        <source>; k leaves degrees of freedom out (normal draws)</source>
        <translation>; k sem graus de liberdade (sorteio normal)</translation>
    </message>
    <message>
        <source>, chosen k = %1</source>
        <translation>, k = %1 escolhido</translation>
    </message>
    <message>
        <source>Of the estimate, and of what is stated without a unit</source>
        <translation>Da estimativa e do que é declarado sem unidade</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>Desfeito: %1</translation>
    </message>
    <message>
        <source>Before these steps</source>
        <translation>Antes destes passos</translation>
    </message>
    <message>
        <source>Undo Lis&amp;t</source>
        <translation>&amp;Lista de passos</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Refazer</translation>
    </message>
    <message>
        <source>Done again: %1</source>
        <translation>Refeito: %1</translation>
    </message>
    <message>
        <source>Type it as %1.</source>
        <translation>Escreva-o como %1.</translation>
    </message>
    <message>
        <source>Type it as %1, or as %2.</source>
        <translation>Escreva-o como %1, ou como %2.</translation>
    </message>
    <message>
        <source>met</source>
        <translation>atingido</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>não atingido</translation>
    </message>
    <message>
        <source>The result is there when every quantity has its uncertainty, above the budget and in the tab Results. It follows every change at once.</source>
        <translation>O resultado aparece quando cada grandeza tem sua incerteza, acima do balanço e na aba Resultados. Ele acompanha cada alteração de imediato.</translation>
    </message>
    <message>
        <source>The tab Contributions has them as a table and as a chart, the largest first. What is at the top is worth improving.</source>
        <translation>A aba Contribuições as mostra como tabela e como gráfico, as maiores primeiro. O que está no topo vale a pena melhorar.</translation>
    </message>
    <message>
        <source>The tab Document shows the pages as they are printed, of the report or of the certificate. It has results that are up to date only: run the analysis first (F5).</source>
        <translation>A aba Documento mostra as páginas como são impressas, do relatório ou do certificado. Ela só contém resultados atualizados: execute antes a análise (F5).</translation>
    </message>
    <message>
        <source>Report as PDF in the toolbar (Ctrl+P) writes the report with the project in it, so that Covaria can open it again. While the tab Document shows the certificate, the button writes that; it is also in the menu File under Export.</source>
        <translation>Relatório em PDF, na barra de ferramentas (Ctrl+P), grava o relatório com o projeto dentro dele, para que o Covaria possa abri-lo de novo. Enquanto a aba Documento mostra o certificado, o botão grava este; ele também está no menu Arquivo, em Exportar.</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>desatualizado</translation>
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
        <translation>Análise</translation>
    </message>
    <message>
        <source>Coverage interval of the result line</source>
        <translation>Intervalo de abrangência da linha de resultado</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Double click: goes to the analysis</source>
        <translation>Duplo clique: vai para a análise</translation>
    </message>
</context>
<context>
    <name>covaria::ui::AllResultsTab</name>
    <message>
        <source>Filter: analysis, symbol, name, group</source>
        <translation>Filtro: análise, símbolo, nome, grupo</translation>
    </message>
    <message>
        <source>Filter of all results</source>
        <translation>Filtro de todos os resultados</translation>
    </message>
    <message>
        <source>Not met only</source>
        <translation>Só não atendidos</translation>
    </message>
    <message>
        <source>Only results whose target uncertainty or tolerance is not met</source>
        <translation>Só resultados cuja incerteza-alvo ou tolerância não é atendida</translation>
    </message>
    <message>
        <source>all-results</source>
        <translation>todos-os-resultados</translation>
    </message>
    <message>
        <source>up to date</source>
        <translation>atualizado</translation>
    </message>
    <message>
        <source>%1 of %2 requirements met</source>
        <translation>%1 de %2 requisitos atendidos</translation>
    </message>
    <message>
        <source>%1 of %2 analyses have no result: press Ctrl+F5</source>
        <translation>%1 de %2 análises não têm resultado: pressione Ctrl+F5</translation>
    </message>
    <message>
        <source>; </source>
        <translation>; </translation>
    </message>
    <message>
        <source>%1 of %2 analyses have no result: they lack something or have problems</source>
        <translation>%1 de %2 análises não têm resultado: falta algo a elas ou têm problemas</translation>
    </message>
</context>
<context>
    <name>covaria::ui::AnswerStrip</name>
    <message>
        <source>Answer</source>
        <translation>Resposta</translation>
    </message>
    <message>
        <source>Output quantity of the budget and the charts</source>
        <translation>Grandeza de saída do balanço e dos gráficos</translation>
    </message>
    <message>
        <source>Output quantity</source>
        <translation>Grandeza de saída</translation>
    </message>
    <message>
        <source>Copy the result, as it stands in a certificate</source>
        <translation>Copiar o resultado, como consta em um certificado</translation>
    </message>
    <message>
        <source>Copy the result</source>
        <translation>Copiar o resultado</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Próximo passo</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>falhou</translation>
    </message>
    <message>
        <source>incomplete</source>
        <translation>incompleto</translation>
    </message>
    <message>
        <source>has problems</source>
        <translation>tem problemas</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>desatualizado</translation>
    </message>
    <message>
        <source>not evaluated</source>
        <translation>não avaliado</translation>
    </message>
    <message>
        <source>Select an analysis to see its results.</source>
        <translation>Selecione uma análise para ver seus resultados.</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Falhou: %1</translation>
    </message>
    <message>
        <source>Not complete yet: nothing is wrong.</source>
        <translation>Ainda não completo: nada está errado.</translation>
    </message>
    <message>
        <source>Not complete yet, but not wrong; to give next: %1</source>
        <translation>Ainda não completo, mas nada está errado; a seguir, indicar: %1</translation>
    </message>
    <message>
        <source>Not evaluated yet: press F5.</source>
        <translation>Ainda não avaliado: pressione F5.</translation>
    </message>
    <message>
        <source>The analysis has problems.</source>
        <translation>A análise tem problemas.</translation>
    </message>
    <message>
        <source>; running</source>
        <translation>; em execução</translation>
    </message>
    <message>
        <source>; press F5 for the result</source>
        <translation>; pressione F5 para o resultado</translation>
    </message>
    <message>
        <source>; %1 trials without a value</source>
        <translation>; %1 ensaios sem valor</translation>
    </message>
    <message>
        <source>&lt;b&gt;Does not represent the measurand&lt;/b&gt; (more than 1 % of the trials are lost). </source>
        <translation>&lt;b&gt;Não representa o mensurando&lt;/b&gt; (mais de 1 % dos ensaios se perderam). </translation>
    </message>
    <message>
        <source>; not stabilised</source>
        <translation>; não estabilizado</translation>
    </message>
    <message>
        <source>&lt;b&gt;Out of date&lt;/b&gt;: shown for the project as it was. </source>
        <translation>&lt;b&gt;Desatualizado&lt;/b&gt;: mostrado para o projeto como era. </translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>A seguir: %1</translation>
    </message>
    <message>
        <source>Goes to the field that must be given next</source>
        <translation>Vai ao campo que deve ser indicado a seguir</translation>
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
        <translation>O recurso tem problemas; estão listados abaixo da cena.</translation>
    </message>
    <message>
        <source>This asset is used as it is specified; nothing is evaluated.</source>
        <translation>Este recurso é usado como está especificado; nada é avaliado.</translation>
    </message>
    <message>
        <source>Evaluation of the asset</source>
        <translation>Avaliação do recurso</translation>
    </message>
</context>
<context>
    <name>covaria::ui::BudgetPage</name>
    <message>
        <source>Correlation coefficient</source>
        <translation>Coeficiente de correlação</translation>
    </message>
    <message>
        <source>Select two rows, and type the correlation coefficient of their components</source>
        <translation>Selecione duas linhas e digite o coeficiente de correlação de suas componentes</translation>
    </message>
    <message>
        <source>Budget</source>
        <translation>Balanço</translation>
    </message>
    <message>
        <source>&lt;i&gt;r&lt;/i&gt; of two rows =</source>
        <translation>&lt;i&gt;r&lt;/i&gt; de duas linhas =</translation>
    </message>
    <message>
        <source>Correlation of Two Rows</source>
        <translation>Correlação de duas linhas</translation>
    </message>
    <message>
        <source>&lt;i&gt;r&lt;/i&gt;(%1, %2) =</source>
        <translation>&lt;i&gt;r&lt;/i&gt;(%1, %2) =</translation>
    </message>
    <message>
        <source>Both quantities need an uncertainty before they can be correlated</source>
        <translation>Ambas as grandezas precisam de uma incerteza antes de poderem ser correlacionadas</translation>
    </message>
    <message>
        <source>c and share by the law of propagation, whose u is %1 of that by Monte Carlo</source>
        <translation>c e parcela pela lei de propagação, cuja u é %1 da de Monte Carlo</translation>
    </message>
</context>
<context>
    <name>covaria::ui::BudgetSheetModel</name>
    <message>
        <source>Out of date: being computed.</source>
        <translation>Desatualizado: em cálculo.</translation>
    </message>
    <message>
        <source>Type a name here to add a quantity</source>
        <translation>Digite um nome aqui para adicionar uma grandeza</translation>
    </message>
    <message>
        <source>“%1” is not a number of degrees of freedom.</source>
        <translation>“%1” não é um número de graus de liberdade.</translation>
    </message>
    <message>
        <source>Name the quantity before its observations.</source>
        <translation>Dê um símbolo à grandeza antes de suas observações.</translation>
    </message>
    <message>
        <source>The observations are read from %1.</source>
        <translation>As observações são lidas de %1.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::BudgetSheetView</name>
    <message>
        <source>Show Quantity</source>
        <translation>Mostrar grandeza</translation>
    </message>
    <message>
        <source>Its components, observations, correlations and notes</source>
        <translation>Seus componentes, observações, correlações e notas</translation>
    </message>
</context>
<context>
    <name>covaria::ui::BudgetTableModel</name>
    <message>
        <source>An estimate by sampling with a standard error of %1 %: S can exceed S total by chance</source>
        <translation>Estimativa por amostragem com erro-padrão de %1 %: S pode exceder S total por acaso</translation>
    </message>
</context>
<context>
    <name>covaria::ui::CertificateForm</name>
    <message>
        <source>Required by %1.</source>
        <translation>Exigido por %1.</translation>
    </message>
    <message>
        <source>Asked for by %1 where it applies.</source>
        <translation>Pedido por %1 onde se aplica.</translation>
    </message>
    <message>
        <source>Next Missing</source>
        <translation>Próximo faltante</translation>
    </message>
    <message>
        <source>What the certificate lacks</source>
        <translation>O que falta no certificado</translation>
    </message>
    <message>
        <source>Goes to the next field that %1 requires and that is empty</source>
        <translation>Vai ao próximo campo que %1 exige e que está vazio</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Alterar %1</translation>
    </message>
    <message>
        <source>Everything that %1 requires beside the results is stated.</source>
        <translation>Tudo o que %1 exige além dos resultados está declarado.</translation>
    </message>
    <message>
        <source>For File › Export › Certificate. A clause of %1 stands where it requires something; a report needs none of it.</source>
        <translation>Para Arquivo › Exportar › Certificado. Uma seção de %1 consta onde ela exige algo; um relatório não precisa de nada disto.</translation>
    </message>
    <message>
        <source>%1 of %2 required texts are stated; missing: %3.</source>
        <translation>%1 de %2 textos exigidos estão declarados; faltam: %3.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg)</source>
        <translation>Imagens (*.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>English (none chosen)</source>
        <translation>Inglês (nenhum escolhido)</translation>
    </message>
    <message>
        <source>Required by %1 where conformity is stated.</source>
        <translation>Exigido por %1 onde se declara conformidade.</translation>
    </message>
    <message>
        <source>in the laboratory, or at the place stated</source>
        <translation>no laboratório, ou no local indicado</translation>
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
        <translation>Execute a análise para ver este gráfico</translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation>Arquivos %1 (*.%2)</translation>
    </message>
    <message>
        <source>Save Chart</source>
        <translation>Salvar gráfico</translation>
    </message>
    <message>
        <source>Show All</source>
        <translation>Mostrar tudo</translation>
    </message>
    <message>
        <source>Copy Picture</source>
        <translation>Copiar imagem</translation>
    </message>
    <message>
        <source>Copy Data</source>
        <translation>Copiar dados</translation>
    </message>
    <message>
        <source>Save as %1 …</source>
        <translation>Salvar como %1 …</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ColumnTableModel</name>
    <message>
        <source>Out of date: the project has changed since.</source>
        <translation>Desatualizado: o projeto mudou desde então.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::CompareTab</name>
    <message>
        <source>Keep as Before</source>
        <translation>Manter como antes</translation>
    </message>
    <message>
        <source>Keeps the present results of this analysis, to compare later ones with</source>
        <translation>Mantém os resultados atuais desta análise, para comparar com eles os posteriores</translation>
    </message>
    <message>
        <source>Go Back to Kept State</source>
        <translation>Voltar ao estado mantido</translation>
    </message>
    <message>
        <source>Discard Kept State</source>
        <translation>Descartar estado mantido</translation>
    </message>
    <message>
        <source>Forgets the kept results; the project stays as it is now</source>
        <translation>Esquece os resultados mantidos; o projeto fica como está agora</translation>
    </message>
    <message>
        <source>comparison</source>
        <translation>comparação</translation>
    </message>
    <message>
        <source>budget-changes</source>
        <translation>alterações-do-balanço</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Gráfico</translation>
    </message>
    <message>
        <source>Distributions</source>
        <translation>Distribuições</translation>
    </message>
    <message>
        <source>Changes of the budget</source>
        <translation>Alterações do balanço</translation>
    </message>
    <message>
        <source>The results are kept: the tab Compare shows them beside those to come.</source>
        <translation>Os resultados foram mantidos: a aba Comparar os mostra ao lado dos que virão.</translation>
    </message>
    <message>
        <source>Go back to kept state</source>
        <translation>Voltar ao estado mantido</translation>
    </message>
    <message>
        <source>Select an analysis to compare its results.</source>
        <translation>Selecione uma análise para comparar seus resultados.</translation>
    </message>
    <message>
        <source>Before: %1, kept at %2. </source>
        <translation>Antes: %1, mantido em %2. </translation>
    </message>
    <message>
        <source>After: no results.</source>
        <translation>Depois: sem resultados.</translation>
    </message>
    <message>
        <source>After: %1</source>
        <translation>Depois: %1</translation>
    </message>
    <message>
        <source>Go Back to Kept</source>
        <translation>Voltar ao mantido</translation>
    </message>
    <message>
        <source>Discard Kept</source>
        <translation>Descartar mantido</translation>
    </message>
    <message>
        <source>The present results are kept in place of those kept before.</source>
        <translation>Os resultados atuais são mantidos no lugar dos mantidos antes.</translation>
    </message>
    <message>
        <source>Replace Kept State</source>
        <translation>Substituir estado mantido</translation>
    </message>
    <message>
        <source>Keeps the present results in place of those kept before, which are forgotten</source>
        <translation>Mantém os resultados atuais no lugar dos mantidos antes, que são esquecidos</translation>
    </message>
    <message>
        <source>Run the analysis (F5), then keep its results with “%1”.</source>
        <translation>Execute a análise (F5) e depois mantenha seus resultados com “%1”.</translation>
    </message>
    <message>
        <source>results that are computed again once the analysis has run</source>
        <translation>resultados que são calculados outra vez assim que a análise tiver sido executada</translation>
    </message>
    <message>
        <source>Compare With Another Project</source>
        <translation>Comparar com outro projeto</translation>
    </message>
    <message>
        <source>Covaria project (*.covaria)</source>
        <translation>Projeto do Covaria (*.covaria)</translation>
    </message>
    <message>
        <source>Analysis of that project:</source>
        <translation>Análise desse projeto:</translation>
    </message>
    <message>
        <source>Compare With</source>
        <translation>Comparar com</translation>
    </message>
    <message>
        <source>Another analysis, of this project or of another one, stands in the place of kept results</source>
        <translation>Outra análise, deste projeto ou de outro, ocupa o lugar dos resultados mantidos</translation>
    </message>
    <message>
        <source>Another Project …</source>
        <translation>Outro projeto …</translation>
    </message>
    <message>
        <source>%1 has no analysis.</source>
        <translation>%1 não tem nenhuma análise.</translation>
    </message>
    <message>
        <source>The tab Compare shows %1 as before.</source>
        <translation>A aba Comparar mostra %1 como antes.</translation>
    </message>
    <message>
        <source>Keep the present results with “%1” and edit, or choose another analysis by “%2”: before and after stand here beside each other.</source>
        <translation>Mantenha os resultados atuais com “%1” e edite, ou escolha outra análise com “%2”: antes e depois ficam aqui lado a lado.</translation>
    </message>
    <message>
        <source>Before: %1 (%2), taken at %3. </source>
        <translation>Antes: %1 (%2), tomado às %3. </translation>
    </message>
    <message>
        <source>Makes the analysis, and what it uses, what they were when the results were kept, and the coverage factor of the project; can be undone</source>
        <translation>Faz a análise, o que ela usa e o fator de abrangência do projeto voltarem ao que eram quando os resultados foram mantidos; pode ser desfeito</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ComponentsEdit</name>
    <message>
        <source>Add</source>
        <translation>Adicionar</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Remover</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Restaurar</translation>
    </message>
    <message>
        <source>Components of uncertainty</source>
        <translation>Componentes de incerteza</translation>
    </message>
    <message>
        <source>Name of the component</source>
        <translation>Nome da componente</translation>
    </message>
    <message>
        <source>Type of evaluation</source>
        <translation>Tipo de avaliação</translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation>Graus de liberdade</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Origem</translation>
    </message>
    <message>
        <source>Back to the components that the model gives</source>
        <translation>Voltar às componentes que o modelo dá</translation>
    </message>
    <message>
        <source>Type A (from observations)</source>
        <translation>Tipo A (de observações)</translation>
    </message>
    <message>
        <source>Type B (other means)</source>
        <translation>Tipo B (outros meios)</translation>
    </message>
    <message>
        <source>Degrees of freedom of the standard uncertainty; empty: infinitely many.</source>
        <translation>Graus de liberdade da incerteza-padrão; vazio: infinitos.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Change component of %1</source>
        <translation>Alterar componente de %1</translation>
    </message>
    <message>
        <source>component %1</source>
        <translation>componente %1</translation>
    </message>
    <message>
        <source>Add component to %1</source>
        <translation>Adicionar componente a %1</translation>
    </message>
    <message>
        <source>Remove component of %1</source>
        <translation>Remover componente de %1</translation>
    </message>
    <message>
        <source>Reset components of %1</source>
        <translation>Restaurar componentes de %1</translation>
    </message>
    <message>
        <source>Its uncertainty comes from another analysis.</source>
        <translation>A sua incerteza vem de outra análise.</translation>
    </message>
    <message>
        <source>Components that it shares with other quantities are edited where they are stated.</source>
        <translation>As componentes que partilha com outras grandezas são editadas onde são declaradas.</translation>
    </message>
    <message>
        <source>It has no component of uncertainty yet.</source>
        <translation>Ainda não tem nenhuma componente de incerteza.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::CorrelationEdit</name>
    <message>
        <source>Add to the matrix</source>
        <translation>Adicionar à matriz</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Remover</translation>
    </message>
    <message>
        <source>Correlation coefficients between components of uncertainty</source>
        <translation>Coeficientes de correlação entre componentes de incerteza</translation>
    </message>
    <message>
        <source>Component of uncertainty</source>
        <translation>Componente de incerteza</translation>
    </message>
    <message>
        <source>All components are uncorrelated. Add those that are correlated to the matrix.</source>
        <translation>Todas as componentes são não correlacionadas. Adicione à matriz as que são correlacionadas.</translation>
    </message>
    <message>
        <source>The coefficients are possible together (positive semi-definite). Monte Carlo draws them with a Gaussian copula: exact for normal distributions, nearly so for others.</source>
        <translation>Os coeficientes são possíveis em conjunto (semidefinida positiva). Monte Carlo os sorteia com uma cópula gaussiana: exato para distribuições normais, quase exato para outras.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::CorrelationTableModel</name>
    <message>
        <source>Correlation of %1 with %2</source>
        <translation>Correlação de %1 com %2</translation>
    </message>
</context>
<context>
    <name>covaria::ui::CsvImportDialog</name>
    <message>
        <source>Import %1 into %2</source>
        <translation>Importar %1 para %2</translation>
    </message>
    <message>
        <source>found by itself</source>
        <translation>detectado</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>vírgula</translation>
    </message>
    <message>
        <source>semicolon</source>
        <translation>ponto e vírgula</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>tabulação</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Prévia</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importar</translation>
    </message>
    <message>
        <source>&amp;Separator of cells</source>
        <translation>&amp;Separador de células</translation>
    </message>
    <message>
        <source>Column of the file</source>
        <translation>Coluna do arquivo</translation>
    </message>
    <message>
        <source>is read as</source>
        <translation>é lida como</translation>
    </message>
    <message>
        <source>Columns of the file</source>
        <translation>Colunas do arquivo</translation>
    </message>
    <message>
        <source>Column %1 is read as</source>
        <translation>A coluna %1 é lida como</translation>
    </message>
    <message>
        <source>as it is named</source>
        <translation>como é nomeada</translation>
    </message>
    <message>
        <source>unknown: choose</source>
        <translation>desconhecida: escolha</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>não lida</translation>
    </message>
    <message>
        <source>The file cannot be imported: %1.</source>
        <translation>O arquivo não pode ser importado: %1.</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Linha %1: %2</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s).</source>
        <translation>
            <numerusform>%n linha(s).</numerusform>
            <numerusform>%n linha(s).</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more problem(s).</source>
        <translation>
            <numerusform>Mais %n problema(s).</numerusform>
            <numerusform>Mais %n problema(s).</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>covaria::ui::DateEditor</name>
    <message>
        <source>to</source>
        <translation>até</translation>
    </message>
    <message>
        <source>%1, last day</source>
        <translation>%1, último dia</translation>
    </message>
    <message>
        <source>Choose from a calendar</source>
        <translation>Escolher em um calendário</translation>
    </message>
    <message>
        <source>“%1” is no date of the form 2026-04-17.</source>
        <translation>“%1” não é uma data da forma 2026-04-17.</translation>
    </message>
    <message>
        <source>The first day is missing.</source>
        <translation>Falta o primeiro dia.</translation>
    </message>
    <message>
        <source>The last day is before the first.</source>
        <translation>O último dia é anterior ao primeiro.</translation>
    </message>
    <message>
        <source>the same day</source>
        <translation>o mesmo dia</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DensityPicture</name>
    <message>
        <source>Density of the distribution</source>
        <translation>Densidade da distribuição</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DesignBoxList</name>
    <message>
        <source>Add Box</source>
        <translation>Adicionar caixa</translation>
    </message>
    <message>
        <source>To, %1</source>
        <translation>Até, %1</translation>
    </message>
    <message>
        <source>From, %1</source>
        <translation>De, %1</translation>
    </message>
    <message>
        <source>Name of the box</source>
        <translation>Nome da caixa</translation>
    </message>
    <message>
        <source>name, such as pillar</source>
        <translation>nome, como pilar</translation>
    </message>
    <message>
        <source>Remove Box</source>
        <translation>Remover caixa</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Até</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DesignReductionList</name>
    <message>
        <source>Add Reduction</source>
        <translation>Adicionar redução</translation>
    </message>
    <message>
        <source>One more uncertainty that can be made smaller for money</source>
        <translation>Mais uma incerteza que pode ser reduzida por dinheiro</translation>
    </message>
    <message>
        <source>Smallest factor</source>
        <translation>Menor fator</translation>
    </message>
    <message>
        <source>The smallest factor that can be had, between 0 and 1</source>
        <translation>O menor fator que se pode obter, entre 0 e 1</translation>
    </message>
    <message>
        <source>Price of the first halving</source>
        <translation>Preço da primeira redução à metade</translation>
    </message>
    <message>
        <source>Law of the price</source>
        <translation>Lei do preço</translation>
    </message>
    <message>
        <source>price (1/f − 1)</source>
        <translation>preço (1/f − 1)</translation>
    </message>
    <message>
        <source>price (1/f² − 1)/3: further readings</source>
        <translation>preço (1/f² − 1)/3: mais leituras</translation>
    </message>
    <message>
        <source>price log₂(1/f): every halving the same</source>
        <translation>preço log₂(1/f): igual a cada metade</translation>
    </message>
    <message>
        <source>Remove Reduction</source>
        <translation>Remover redução</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>Reduzida</translation>
    </message>
    <message>
        <source>Least factor</source>
        <translation>Fator mínimo</translation>
    </message>
    <message>
        <source>First halving</source>
        <translation>Primeira metade</translation>
    </message>
    <message>
        <source>A factor f costs</source>
        <translation>Um fator f custa</translation>
    </message>
    <message>
        <source>choose what is reduced</source>
        <translation>escolha o que se reduz</translation>
    </message>
    <message>
        <source>Reductions</source>
        <translation>Reduções</translation>
    </message>
    <message>
        <source>Each has a price; they take the place of variables and rows.</source>
        <translation>Cada uma tem um preço; elas tomam o lugar de variáveis e linhas.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DesignTab</name>
    <message>
        <source>Design</source>
        <translation>Planejamento</translation>
    </message>
    <message>
        <source>Design of this analysis</source>
        <translation>Planejamento desta análise</translation>
    </message>
    <message>
        <source>Run Design</source>
        <translation>Executar planejamento</translation>
    </message>
    <message>
        <source>Searches for the best design</source>
        <translation>Procura o melhor planejamento</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Parar</translation>
    </message>
    <message>
        <source>Stops the search (Esc)</source>
        <translation>Para a busca (Esc)</translation>
    </message>
    <message>
        <source>Edit …</source>
        <translation>Editar …</translation>
    </message>
    <message>
        <source>Variables, rows and objective of the design, in the properties of the analysis</source>
        <translation>Variáveis, linhas e objetivo do planejamento, nas propriedades da análise</translation>
    </message>
    <message>
        <source>Take Over This Design</source>
        <translation>Adotar este planejamento</translation>
    </message>
    <message>
        <source>Puts the values and rows that were found into the project; can be undone</source>
        <translation>Põe no projeto os valores e as linhas encontrados; pode ser desfeito</translation>
    </message>
    <message>
        <source>Add Design …</source>
        <translation>Adicionar planejamento …</translation>
    </message>
    <message>
        <source> – out of date</source>
        <translation> – desatualizado</translation>
    </message>
    <message>
        <source>%1 of %2 evaluations</source>
        <translation>%1 de %2 avaliações</translation>
    </message>
    <message>
        <source>, best so far %1</source>
        <translation>, melhor até agora %1</translation>
    </message>
    <message>
        <source>searching …</source>
        <translation>procurando …</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Falhou: %1</translation>
    </message>
    <message>
        <source>Not searched yet.</source>
        <translation>Ainda não procurado.</translation>
    </message>
    <message>
        <source>Nothing that was tried has a result.</source>
        <translation>Nada do que foi tentado tem resultado.</translation>
    </message>
    <message>
        <source>The cheapest reductions cost %1</source>
        <translation>As reduções mais baratas custam %1</translation>
    </message>
    <message>
        <source>The cheapest rows cost %1</source>
        <translation>As linhas mais baratas custam %1</translation>
    </message>
    <message>
        <source>, before %1</source>
        <translation>, antes %1</translation>
    </message>
    <message>
        <source>; &lt;b&gt;the target of U(%1) is not met&lt;/b&gt;</source>
        <translation>; &lt;b&gt;o alvo de U(%1) não é atingido&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Out of date&lt;/b&gt;: shown for the project as it was. </source>
        <translation>&lt;b&gt;Desatualizado&lt;/b&gt;: mostrado para o projeto como era. </translation>
    </message>
    <message>
        <source>Take over design</source>
        <translation>Adotar planejamento</translation>
    </message>
    <message>
        <source>“%1” shows the best that can be done with what the design may choose.</source>
        <translation>“%1” mostra o melhor que se pode obter com o que o planejamento pode escolher.</translation>
    </message>
    <message>
        <source>A design finds where to stand and what to measure: add one with “%1”.</source>
        <translation>Um planejamento encontra onde ficar e o que medir: adicione um com “%1”.</translation>
    </message>
    <message>
        <source> (law of propagation)</source>
        <translation> (lei de propagação)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DesignsForm</name>
    <message>
        <source>Design</source>
        <translation>Planejamento</translation>
    </message>
    <message>
        <source>Adds a design of this analysis</source>
        <translation>Adiciona um planejamento desta análise</translation>
    </message>
    <message>
        <source>Adds a copy of this design</source>
        <translation>Adiciona uma cópia deste planejamento</translation>
    </message>
    <message>
        <source>Deletes this design</source>
        <translation>Exclui este planejamento</translation>
    </message>
    <message>
        <source>Searches for the best design</source>
        <translation>Procura o melhor planejamento</translation>
    </message>
    <message>
        <source>A design finds where to stand and what to measure: the numbers and the rows of the set-up that make the uncertainties smallest. Add one to let Covaria search.</source>
        <translation>Um planejamento encontra onde ficar e o que medir: os números e as linhas da configuração que tornam as incertezas mínimas. Adicione um para o Covaria procurar.</translation>
    </message>
    <message>
        <source>Add Variable</source>
        <translation>Adicionar variável</translation>
    </message>
    <message>
        <source>One more number that may be chosen</source>
        <translation>Mais um número que pode ser escolhido</translation>
    </message>
    <message>
        <source>Name of the design</source>
        <translation>Nome do planejamento</translation>
    </message>
    <message>
        <source>Objective</source>
        <translation>Objetivo</translation>
    </message>
    <message>
        <source>What is made smallest of the ratios of U to the target uncertainties; without targets to U of the present design</source>
        <translation>O que se minimiza das razões de U às incertezas-alvo; sem alvos, a U do planejamento atual</translation>
    </message>
    <message>
        <source>Largest ratio</source>
        <translation>Maior razão</translation>
    </message>
    <message>
        <source>Mean of the ratios</source>
        <translation>Média das razões</translation>
    </message>
    <message>
        <source>Root mean square of the ratios</source>
        <translation>Raiz da média quadrática das razões</translation>
    </message>
    <message>
        <source>Cost of the rows, with all targets met</source>
        <translation>Custo das linhas, com todos os alvos atingidos</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>Minimizar</translation>
    </message>
    <message>
        <source>Output quantities of the design</source>
        <translation>Grandezas de saída do planejamento</translation>
    </message>
    <message>
        <source>Output quantities looked at; with none ticked, all with a target uncertainty, or all measurands</source>
        <translation>Grandezas de saída consideradas; sem nenhuma marcada, todas com incerteza-alvo, ou todos os mensurandos</translation>
    </message>
    <message>
        <source>Outputs (none ticked: all with a target, or all measurands)</source>
        <translation>Saídas (nenhuma marcada: todas com alvo, ou todos os mensurandos)</translation>
    </message>
    <message>
        <source>Rows to choose from</source>
        <translation>Linhas para escolha</translation>
    </message>
    <message>
        <source>Table to choose from</source>
        <translation>Tabela para escolha</translation>
    </message>
    <message>
        <source>Rows to keep</source>
        <translation>Linhas a manter</translation>
    </message>
    <message>
        <source>File of candidates</source>
        <translation>Arquivo de candidatos</translation>
    </message>
    <message>
        <source>A CSV file beside the project with further rows; may be empty</source>
        <translation>Um arquivo CSV junto ao projeto com outras linhas; pode ficar vazio</translation>
    </message>
    <message>
        <source>Rows that stay</source>
        <translation>Linhas que ficam</translation>
    </message>
    <message>
        <source>Ticked rows stay in any case</source>
        <translation>Linhas marcadas ficam em qualquer caso</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabela</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Manter</translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation>Candidatos</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Ficam</translation>
    </message>
    <message>
        <source>Prices</source>
        <translation>Preços</translation>
    </message>
    <message>
        <source>Starts</source>
        <translation>Inícios</translation>
    </message>
    <message>
        <source>Evaluations at most</source>
        <translation>Avaliações no máximo</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semente</translation>
    </message>
    <message>
        <source>Least distance</source>
        <translation>Distância mínima</translation>
    </message>
    <message>
        <source>Between instruments, and of them from all other points</source>
        <translation>Entre instrumentos, e deles a todos os outros pontos</translation>
    </message>
    <message>
        <source>Keep out of</source>
        <translation>Manter fora de</translation>
    </message>
    <message>
        <source>No instrument stands in this box</source>
        <translation>Nenhum instrumento fica nesta caixa</translation>
    </message>
    <message>
        <source>Lines of sight are hidden by</source>
        <translation>Visadas são obstruídas por</translation>
    </message>
    <message>
        <source>No line of sight passes this box</source>
        <translation>Nenhuma linha de visada atravessa esta caixa</translation>
    </message>
    <message>
        <source>Prices of the rows</source>
        <translation>Preços das linhas</translation>
    </message>
    <message>
        <source>one for all rows, or one for each: 120; 80; 95</source>
        <translation>um para todas as linhas, ou um para cada: 120; 80; 95</translation>
    </message>
    <message>
        <source>What the rows cost, separated by semicolons; needed where the cost is to be small</source>
        <translation>O que as linhas custam, separado por ponto e vírgula; necessário onde o custo deve ser mínimo</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no number; separate prices by semicolons</source>
        <translation>&apos;%1&apos; não é número; separe os preços por ponto e vírgula</translation>
    </message>
    <message>
        <source>Of the random starts: a whole number from 0 to 18446744073709551615</source>
        <translation>Dos inícios aleatórios: um número inteiro de 0 a 18446744073709551615</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nenhum</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DistributionEdit</name>
    <message>
        <source>Distribution</source>
        <translation>Distribuição</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidade</translation>
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
        <translation>números com ; entre eles</translation>
    </message>
    <message>
        <source>“%1” are not all numbers.</source>
        <translation>“%1” não são todos números.</translation>
    </message>
    <message>
        <source>There must be as many probabilities as values.</source>
        <translation>Deve haver tantas probabilidades quantos valores.</translation>
    </message>
    <message>
        <source>This distribution has no finite standard uncertainty.</source>
        <translation>Esta distribuição não tem incerteza-padrão finita.</translation>
    </message>
    <message>
        <source>Monte Carlo draws: %1, ν = %2</source>
        <translation>Monte Carlo sorteia: %1, ν = %2</translation>
    </message>
    <message>
        <source>Edges of the cells</source>
        <translation>Bordas das células</translation>
    </message>
    <message>
        <source>There must be one edge more than probabilities.</source>
        <translation>Deve haver uma borda a mais que probabilidades.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::DockTitle</name>
    <message>
        <source>Float or dock</source>
        <translation>Soltar ou encaixar</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
</context>
<context>
    <name>covaria::ui::Document</name>
    <message>
        <source>Untitled</source>
        <translation>Sem título</translation>
    </message>
    <message>
        <source>%1 (from %2)</source>
        <translation>%1 (de %2)</translation>
    </message>
    <message>
        <source>The project has no file yet: choose a name for it.</source>
        <translation>O projeto ainda não tem arquivo: escolha um nome para ele.</translation>
    </message>
    <message>
        <source> (copy)</source>
        <translation> (cópia)</translation>
    </message>
    <message>
        <source>Add study</source>
        <translation>Adicionar estudo</translation>
    </message>
    <message>
        <source>Duplicate study</source>
        <translation>Duplicar estudo</translation>
    </message>
    <message>
        <source>Delete study</source>
        <translation>Excluir estudo</translation>
    </message>
    <message>
        <source>Change study</source>
        <translation>Alterar estudo</translation>
    </message>
    <message>
        <source>Study %1</source>
        <translation>Estudo %1</translation>
    </message>
    <message>
        <source>Add design</source>
        <translation>Adicionar planejamento</translation>
    </message>
    <message>
        <source>Duplicate design</source>
        <translation>Duplicar planejamento</translation>
    </message>
    <message>
        <source>Delete design</source>
        <translation>Excluir planejamento</translation>
    </message>
    <message>
        <source>Change design</source>
        <translation>Alterar planejamento</translation>
    </message>
    <message>
        <source>Design %1</source>
        <translation>Planejamento %1</translation>
    </message>
    <message>
        <source>the project</source>
        <translation>o projeto</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>Renomear %1</translation>
    </message>
    <message>
        <source>Change notes of %1</source>
        <translation>Alterar notas de %1</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>Excluir %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Mover %1</translation>
    </message>
    <message>
        <source>Take %1 from an analysis</source>
        <translation>Tomar %1 de uma análise</translation>
    </message>
    <message>
        <source>Remove the link of %1</source>
        <translation>Remover o vínculo de %1</translation>
    </message>
    <message>
        <source>Another program has changed the file since it was read.</source>
        <translation>Outro programa alterou o arquivo desde que foi lido.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::EmptyProject</name>
    <message>
        <source>Empty project</source>
        <translation>Projeto vazio</translation>
    </message>
    <message>
        <source>What is to be evaluated?</source>
        <translation>O que será avaliado?</translation>
    </message>
    <message>
        <source>&amp;Library and Templates …</source>
        <translation>&amp;Biblioteca e modelos prontos …</translation>
    </message>
</context>
<context>
    <name>covaria::ui::EquationsView</name>
    <message>
        <source>Equations</source>
        <translation>Equações</translation>
    </message>
</context>
<context>
    <name>covaria::ui::EvaluationTab</name>
    <message>
        <source>Evaluation of the set-up</source>
        <translation>Avaliação da configuração</translation>
    </message>
</context>
<context>
    <name>covaria::ui::EvaluationView</name>
    <message>
        <source>Tables of the evaluation</source>
        <translation>Tabelas da avaliação</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Gráfico</translation>
    </message>
    <message>
        <source>Which chart of the evaluation is shown</source>
        <translation>Que gráfico da avaliação é mostrado</translation>
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
        <translation>Relatório em &amp;PDF …</translation>
    </message>
    <message>
        <source>&amp;Certificate as PDF …</source>
        <translation>&amp;Certificado em PDF …</translation>
    </message>
    <message>
        <source>Report as &amp;HTML …</source>
        <translation>Relatório em &amp;HTML …</translation>
    </message>
    <message>
        <source>Report as &amp;Markdown …</source>
        <translation>Relatório em &amp;Markdown …</translation>
    </message>
    <message>
        <source>&amp;Results and Tables (JSON, CSV) …</source>
        <translation>&amp;Resultados e tabelas (JSON, CSV) …</translation>
    </message>
    <message>
        <source> …</source>
        <translation> …</translation>
    </message>
    <message>
        <source>No results yet</source>
        <translation>Ainda sem resultados</translation>
    </message>
    <message>
        <source>The export waits until the analyses have run</source>
        <translation>A exportação espera até que as análises tenham sido executadas</translation>
    </message>
    <message>
        <source>, without %1: not up to date</source>
        <translation>, sem %1: não atualizado</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Export Report</source>
        <translation>Exportar relatório</translation>
    </message>
    <message>
        <source>The certificate does not state what ISO/IEC 17025 requires of it:

%1

It says “not stated” in these places. They are fields of the project&apos;s page.</source>
        <translation>O certificado não declara o que a ISO/IEC 17025 exige dele:

%1

Nesses lugares ele diz “não declarado”. São campos da página do projeto.</translation>
    </message>
    <message>
        <source>Export Anyway</source>
        <translation>Exportar assim mesmo</translation>
    </message>
    <message>
        <source>Export Certificate</source>
        <translation>Exportar certificado</translation>
    </message>
    <message>
        <source>Export Results and Tables into the Folder of</source>
        <translation>Exportar resultados e tabelas para a pasta de</translation>
    </message>
    <message>
        <source>Results (results.json)</source>
        <translation>Resultados (results.json)</translation>
    </message>
    <message>
        <source>%1: what it must state is missing</source>
        <translation>%1: falta o que deve declarar</translation>
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
        <translation>Um relatório está sendo escrito; espere até que termine</translation>
    </message>
    <message>
        <source>Writing %1 …</source>
        <translation>Escrevendo %1 …</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 escrito</translation>
    </message>
    <message>
        <source>The export failed</source>
        <translation>A exportação falhou</translation>
    </message>
    <message>
        <source>No analysis can be run: each one is incomplete or has errors.</source>
        <translation>Nenhuma análise pode ser executada: cada uma está incompleta ou tem erros.</translation>
    </message>
    <message>
        <source>Ex&amp;port</source>
        <translation>E&amp;xportar</translation>
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
        <translation>Mais que %1.</translation>
    </message>
    <message>
        <source>At least %1.</source>
        <translation>No mínimo %1.</translation>
    </message>
    <message>
        <source>At most %1.</source>
        <translation>No máximo %1.</translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation>Arquivos %1</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FieldHelp</name>
    <message>
        <source>Help on the field</source>
        <translation>Ajuda sobre o campo</translation>
    </message>
    <message>
        <source>Numbers may be typed with another unit (%1); the arrow keys change the last digit.</source>
        <translation>Números podem ser digitados com outra unidade (%1); as teclas de seta alteram o último algarismo.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FileActions</name>
    <message>
        <source>line %1: </source>
        <translation>linha %1: </translation>
    </message>
    <message>
        <source>&amp;New Project</source>
        <translation>&amp;Novo projeto</translation>
    </message>
    <message>
        <source>&amp;Open …</source>
        <translation>&amp;Abrir …</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Salvar</translation>
    </message>
    <message>
        <source>Save &amp;As …</source>
        <translation>Salvar &amp;como …</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Abrir recen&amp;te</translation>
    </message>
    <message>
        <source>No projects yet</source>
        <translation>Ainda sem projetos</translation>
    </message>
    <message>
        <source>New from &amp;Example</source>
        <translation>Novo a partir de &amp;exemplo</translation>
    </message>
    <message>
        <source>Untitled project</source>
        <translation>Projeto sem título</translation>
    </message>
    <message>
        <source>Opening %1 …</source>
        <translation>Abrindo %1 …</translation>
    </message>
    <message>
        <source>%1 was not opened</source>
        <translation>%1 não foi aberto</translation>
    </message>
    <message>
        <source>The project has errors and was not opened</source>
        <translation>O projeto tem erros e não foi aberto</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>%1 aberto</translation>
    </message>
    <message>
        <source>The example could not be opened</source>
        <translation>O exemplo não pôde ser aberto</translation>
    </message>
    <message>
        <source>The project was not saved</source>
        <translation>O projeto não foi salvo</translation>
    </message>
    <message>
        <source>Save Project</source>
        <translation>Salvar projeto</translation>
    </message>
    <message>
        <source>Covaria project (*.covaria)</source>
        <translation>Projeto do Covaria (*.covaria)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 salvo</translation>
    </message>
    <message numerus="yes">
        <source>Saved %1 without %n text(s) that cannot be read: see the problems</source>
        <translation>
            <numerusform>%1 salvo sem %n texto(s) que não pode(m) ser lido(s): veja os problemas</numerusform>
            <numerusform>%1 salvo sem %n texto(s) que não pode(m) ser lido(s): veja os problemas</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>The work could not be recovered</source>
        <translation>O trabalho não pôde ser recuperado</translation>
    </message>
    <message>
        <source>%1 was removed by another program; saving writes it again</source>
        <translation>%1 foi removido por outro programa; salvar o escreve de novo</translation>
    </message>
    <message>
        <source>Name project</source>
        <translation>Dar nome ao projeto</translation>
    </message>
    <message>
        <source>%1 was changed by another program since it was read here. Saving replaces what it holds now.</source>
        <translation>%1 foi alterado por outro programa desde que foi lido aqui. Salvar substitui o que contém agora.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Substituir</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FileEditor</name>
    <message>
        <source>Choose a file: %1</source>
        <translation>Escolher um arquivo: %1</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FirstStepsGuide</name>
    <message>
        <source>First Steps</source>
        <translation>Primeiros passos</translation>
    </message>
    <message>
        <source>Not there yet: first step %1, %2.</source>
        <translation>Ainda não existe: antes, o passo %1, %2.</translation>
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
        <translation>Voltar</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Próximo</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Primeiros passos</translation>
    </message>
    <message>
        <source>Shows where it is done: opens the tab and puts a frame around it</source>
        <translation>Mostra onde se faz: abre a aba e coloca uma moldura em volta</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>step 3 of 10</comment>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>done</source>
        <translation>feito</translation>
    </message>
</context>
<context>
    <name>covaria::ui::FoldGroups</name>
    <message>
        <source>none</source>
        <translation type="unfinished">nenhum</translation>
    </message>
</context>
<context>
    <name>covaria::ui::HelpActions</name>
    <message>
        <source>Help</source>
        <translation>Ajuda</translation>
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
        <translation>&amp;Resultados e requisitos</translation>
    </message>
    <message>
        <source>&amp;Glossary</source>
        <translation>&amp;Glossário</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Teclas</translation>
    </message>
    <message>
        <source>&amp;About Covaria</source>
        <translation>&amp;Sobre o Covaria</translation>
    </message>
    <message>
        <source>The S&amp;cene</source>
        <translation>A &amp;cena</translation>
    </message>
    <message>
        <source>An Everyday &amp;Budget</source>
        <translation>Um &amp;balanço do dia a dia</translation>
    </message>
    <message>
        <source>Help on &amp;What Has the Focus</source>
        <translation>Ajuda sobre o que tem o &amp;foco</translation>
    </message>
    <message>
        <source>Artefacts, &amp;Instruments and Robots</source>
        <translation>Padrões, &amp;instrumentos e robôs</translation>
    </message>
    <message>
        <source>What Every Analysis &amp;Has</source>
        <translation>O que toda &amp;análise tem</translation>
    </message>
</context>
<context>
    <name>covaria::ui::HelpPane</name>
    <message>
        <source>Help</source>
        <translation>Ajuda</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ImportActions</name>
    <message>
        <source>&amp;Import File …</source>
        <translation>&amp;Importar arquivo …</translation>
    </message>
    <message>
        <source>Add points, budgets, certificates, readings or poses of other programs</source>
        <translation>Adicionar pontos, balanços, certificados, leituras ou poses de outros programas</translation>
    </message>
    <message>
        <source>Add a serial robot from a robot description in URDF</source>
        <translation>Adicionar um robô serial a partir de uma descrição de robô em URDF</translation>
    </message>
    <message>
        <source>Import File</source>
        <translation>Importar arquivo</translation>
    </message>
    <message>
        <source>Files that are read (%1);;All files (*)</source>
        <translation>Arquivos que são lidos (%1);;Todos os arquivos (*)</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Importar %1</translation>
    </message>
    <message>
        <source>Imported %1</source>
        <translation>%1 importado</translation>
    </message>
    <message>
        <source>Import Robot</source>
        <translation>Importar robô</translation>
    </message>
    <message>
        <source>Robot description (*.urdf);;All files (*)</source>
        <translation>Descrição de robô (*.urdf);;Todos os arquivos (*)</translation>
    </message>
    <message>
        <source>The robot was not imported</source>
        <translation>O robô não foi importado</translation>
    </message>
    <message>
        <source>Import Robo&amp;t (URDF) …</source>
        <translation>Importar robô (&amp;URDF) …</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ImportDialog</name>
    <message>
        <source>Line %1: %2</source>
        <translation>Linha %1: %2</translation>
    </message>
    <message>
        <source>What the file says contradicts itself: %1</source>
        <translation>O que o arquivo diz é contraditório: %1</translation>
    </message>
    <message>
        <source>&amp;Sheet</source>
        <translation>&amp;Planilha</translation>
    </message>
    <message>
        <source>Columns of the file and what each is read as</source>
        <translation>Colunas do arquivo e como cada uma é lida</translation>
    </message>
    <message>
        <source>Units that the &amp;file does not state</source>
        <translation>Unidades que o &amp;arquivo não declara</translation>
    </message>
    <message>
        <source>&amp;Note the file with its size, time and SHA-256 in what is added</source>
        <translation>A&amp;notar o arquivo com tamanho, hora e SHA-256 no que é adicionado</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Importar %1</translation>
    </message>
    <message>
        <source>as the file says, else mm</source>
        <translation>como diz o arquivo, senão mm</translation>
    </message>
    <message>
        <source>What becomes of the file</source>
        <translation>O que resulta do arquivo</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importar</translation>
    </message>
    <message>
        <source>&amp;Read as</source>
        <translation>&amp;Ler como</translation>
    </message>
    <message>
        <source>&amp;Unit of lengths</source>
        <translation>&amp;Unidade dos comprimentos</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Grandeza</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidade</translation>
    </message>
    <message>
        <source>What becomes of it, and what is not taken over</source>
        <translation>O que resulta dele, e o que não é aproveitado</translation>
    </message>
    <message>
        <source>no reader recognises it: choose one</source>
        <translation>nenhum leitor o reconhece: escolha um</translation>
    </message>
    <message>
        <source>several readers recognise it: choose one</source>
        <translation>vários leitores o reconhecem: escolha um</translation>
    </message>
    <message>
        <source>%1 (recognised)</source>
        <translation>%1 (reconhecido)</translation>
    </message>
    <message>
        <source>Column %1 is read as</source>
        <translation>A coluna %1 é lida como</translation>
    </message>
    <message>
        <source>unknown: choose</source>
        <translation>desconhecida: escolha</translation>
    </message>
    <message>
        <source>as it is named</source>
        <translation>como é nomeada</translation>
    </message>
    <message>
        <source>Choose what the file is read as.</source>
        <translation>Escolha como o arquivo é lido.</translation>
    </message>
    <message>
        <source>%1 assets and %2 analyses are added, in one step that can be undone.</source>
        <translation>%1 recursos e %2 análises são adicionados, em um passo que pode ser desfeito.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Imported from %1, %2 bytes, of %3, SHA-256 %4.</source>
        <translation>Importado de %1, %2 bytes, de %3, SHA-256 %4.</translation>
    </message>
    <message>
        <source>&amp;Leave Out or Read the Row</source>
        <translation>&amp;Omitir ou ler a linha</translation>
    </message>
    <message>
        <source>%1, left out</source>
        <translation>%1, omitida</translation>
    </message>
    <message>
        <source>What each column is read as; cells can be typed over</source>
        <translation>Como cada coluna é lida; pode-se escrever por cima das células</translation>
    </message>
</context>
<context>
    <name>covaria::ui::InputCorrelationModel</name>
    <message>
        <source>Remove correlations of %1</source>
        <translation>Remover correlações de %1</translation>
    </message>
    <message>
        <source>Change correlation of %1 and %2</source>
        <translation>Alterar correlação de %1 e %2</translation>
    </message>
    <message>
        <source>The correlation coefficient of %1 and %2 lies between −1 and 1; “%3” does not.</source>
        <translation>O coeficiente de correlação de %1 e %2 está entre −1 e 1; “%3” não.</translation>
    </message>
    <message>
        <source>The correlation coefficient of %1 and %2 is a number; “%3” is not.</source>
        <translation>O coeficiente de correlação de %1 e %2 é um número; “%3” não é.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::InputQuantitiesModel</name>
    <message>
        <source>from %1, linearised: %2</source>
        <translation>de %1, linearizado: %2</translation>
    </message>
    <message>
        <source>from %1: %2</source>
        <translation>de %1: %2</translation>
    </message>
    <message>
        <source>Evaluated in the other analysis, in every trial: edit it there.</source>
        <translation>Avaliado na outra análise, em cada ensaio: edite-o lá.</translation>
    </message>
    <message>
        <source>Changed: differs from what the model says.</source>
        <translation>Alterado: difere do que o modelo diz.</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>Símbolo</translation>
    </message>
    <message>
        <source>Input quantity</source>
        <translation>Grandeza de entrada</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>Estimativa</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidade</translation>
    </message>
    <message>
        <source>Constant</source>
        <translation>Constante</translation>
    </message>
    <message>
        <source>Change estimate of %1</source>
        <translation>Alterar estimativa de %1</translation>
    </message>
    <message>
        <source>Keep %1 constant</source>
        <translation>Manter %1 constante</translation>
    </message>
    <message>
        <source>Let %1 vary</source>
        <translation>Deixar %1 variar</translation>
    </message>
    <message>
        <source>Reset %1 to the model&apos;s values</source>
        <translation>Restaurar %1 aos valores do modelo</translation>
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
        <translation>Localizar uma grandeza</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Componentes</translation>
    </message>
    <message>
        <source>Correlations</source>
        <translation>Correlações</translation>
    </message>
    <message>
        <source>The quantities that the set-up makes. What is changed here replaces what the set-up states.</source>
        <translation>As grandezas que a configuração cria. O que se altera aqui substitui o que a configuração declara.</translation>
    </message>
    <message>
        <source>Input quantities</source>
        <translation>Grandezas de entrada</translation>
    </message>
    <message>
        <source>Take From an Analysis …</source>
        <translation>Tomar de uma análise …</translation>
    </message>
    <message>
        <source>Remove Link</source>
        <translation>Remover vínculo</translation>
    </message>
    <message>
        <source>Observations</source>
        <translation>Observações</translation>
    </message>
    <message>
        <source>Notes on the quantity</source>
        <translation type="unfinished">Notas sobre a grandeza</translation>
    </message>
</context>
<context>
    <name>covaria::ui::InquiryHead</name>
    <message>
        <source>Add</source>
        <translation>Adicionar</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplicar</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Excluir</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Executar</translation>
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
        <translation type="unfinished">Propriedades</translation>
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
        <translation>Manter estado</translation>
    </message>
    <message>
        <source>Discard kept state</source>
        <translation>Descartar o estado mantido</translation>
    </message>
    <message>
        <source>Compare with %1</source>
        <translation>Comparar com %1</translation>
    </message>
</context>
<context>
    <name>covaria::ui::LibraryBrowser</name>
    <message>
        <source>Collections</source>
        <translation>Coleções</translation>
    </message>
    <message>
        <source>Templates, examples and assets</source>
        <translation>Modelos prontos, exemplos e recursos</translation>
    </message>
    <message>
        <source>Library and Examples</source>
        <translation>Biblioteca e exemplos</translation>
    </message>
    <message>
        <source>Search: name, kind, source</source>
        <translation>Buscar: nome, tipo, fonte</translation>
    </message>
    <message>
        <source>Search in the library</source>
        <translation>Buscar na biblioteca</translation>
    </message>
    <message>
        <source>What is selected</source>
        <translation>O que está selecionado</translation>
    </message>
    <message>
        <source>New analysis</source>
        <translation>Nova análise</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Exemplos</translation>
    </message>
    <message>
        <source>GUM and its supplements</source>
        <translation>GUM e seus suplementos</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Tudo</translation>
    </message>
    <message>
        <source>It comes with what it needs and has results at once. Assets of the same kind that the project has already stand in the place of its own.</source>
        <translation>Vem com o que precisa e tem resultados de imediato. Recursos do mesmo tipo que o projeto já tem tomam o lugar dos seus.</translation>
    </message>
    <message>
        <source>Opens as a new project.</source>
        <translation>Abre como um novo projeto.</translation>
    </message>
    <message>
        <source>Add to the Project</source>
        <translation>Adicionar ao projeto</translation>
    </message>
    <message>
        <source>&lt;p&gt;Nothing here has these words.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Nada aqui contém estas palavras.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Open as a New Project</source>
        <translation>Abrir como novo projeto</translation>
    </message>
    <message>
        <source>Add This Analysis</source>
        <translation>Adicionar esta análise</translation>
    </message>
</context>
<context>
    <name>covaria::ui::LibraryMenu</name>
    <message>
        <source>Not readable: %1</source>
        <translation>Ilegível: %1</translation>
    </message>
    <message>
        <source>F&amp;rom the Library</source>
        <translation>Da bib&amp;lioteca</translation>
    </message>
</context>
<context>
    <name>covaria::ui::LinesEditor</name>
    <message>
        <source>Add rows for new names</source>
        <translation>Adicionar linhas para novos nomes</translation>
    </message>
    <message>
        <source>Adds a row to the tables below for every name that has none yet</source>
        <translation>Adiciona uma linha às tabelas abaixo para cada nome que ainda não tem nenhuma</translation>
    </message>
</context>
<context>
    <name>covaria::ui::LinkDialog</name>
    <message>
        <source>&amp;Linearised: faster, exact to first order only</source>
        <translation>&amp;Linearizado: mais rápido, exato só em primeira ordem</translation>
    </message>
    <message>
        <source>Take %1 From an Analysis</source>
        <translation>Tomar %1 de uma análise</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>Análise</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>No other analysis has a result of this dimension.</source>
        <translation>Nenhuma outra análise tem um resultado desta dimensão.</translation>
    </message>
    <message>
        <source>Both analyses are then evaluated together, as one model: the result is not carried over as a number with an uncertainty.</source>
        <translation>Ambas as análises são então avaliadas juntas, como um só modelo: o resultado não é transferido como um número com uma incerteza.</translation>
    </message>
    <message>
        <source>&amp;Analysis</source>
        <translation>&amp;Análise</translation>
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
        <translation>(nenhum)</translation>
    </message>
    <message>
        <source>%1 (does not exist)</source>
        <translation>%1 (não existe)</translation>
    </message>
    <message>
        <source>%1

Chosen: %2</source>
        <translation>%1

Escolhido: %2</translation>
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
        <translation>Projeto</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Propriedades</translation>
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
        <translation>Adicionar uma análise ou o que ela usa</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Ferramentas</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Arquivo</translation>
    </message>
    <message>
        <source>&amp;Library and Examples …</source>
        <translation>&amp;Biblioteca e exemplos …</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Sai&amp;r</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>Pre&amp;ferences …</source>
        <translation>Pre&amp;ferências …</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>E&amp;xecutar</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>&amp;Reset Layout</source>
        <translation>&amp;Restaurar layout</translation>
    </message>
    <message>
        <source>Start Page</source>
        <translation>Página inicial</translation>
    </message>
    <message>
        <source>3D Scene</source>
        <translation>Cena 3D</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;juda</translation>
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
        <translation>Primeiros &amp;passos</translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished">Executar</translation>
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
        <translation>Medir distância</translation>
    </message>
    <message>
        <source>Distance of two points, with its uncertainty (D)</source>
        <translation>Distância entre dois pontos, com sua incerteza (D)</translation>
    </message>
    <message>
        <source>Measure Angle</source>
        <translation>Medir ângulo</translation>
    </message>
    <message>
        <source>Angle at the second of three points, with its uncertainty (A)</source>
        <translation>Ângulo no segundo de três pontos, com sua incerteza (A)</translation>
    </message>
    <message>
        <source>Distance: pick the first point. Esc puts the tool away.</source>
        <translation>Distância: escolher o primeiro ponto. Esc deixa a ferramenta.</translation>
    </message>
    <message>
        <source>Distance: pick the second point.</source>
        <translation>Distância: escolher o segundo ponto.</translation>
    </message>
    <message>
        <source>Angle: pick a point on the first side. Esc puts the tool away.</source>
        <translation>Ângulo: escolher um ponto do primeiro lado. Esc deixa a ferramenta.</translation>
    </message>
    <message>
        <source>Angle: pick the apex.</source>
        <translation>Ângulo: escolher o vértice.</translation>
    </message>
    <message>
        <source>Angle: pick a point on the second side.</source>
        <translation>Ângulo: escolher um ponto do segundo lado.</translation>
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
        <translation>Nome</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notas</translation>
    </message>
    <message>
        <source>Appear in the report</source>
        <translation>Aparecem no relatório</translation>
    </message>
</context>
<context>
    <name>covaria::ui::OnlyMiddle</name>
    <message>
        <source>Only the &amp;Middle</source>
        <translation>Só o ce&amp;ntro</translation>
    </message>
    <message>
        <source>The stage alone; once more, and the panes stand as they did</source>
        <translation>Só a área central; mais uma vez, e os painéis voltam a ficar como estavam</translation>
    </message>
</context>
<context>
    <name>covaria::ui::OptionsForm</name>
    <message>
        <source>none</source>
        <translation>nenhum</translation>
    </message>
    <message>
        <source>Forecast</source>
        <translation>Previsão</translation>
    </message>
    <message>
        <source>Change evaluation options</source>
        <translation>Alterar opções de avaliação</translation>
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
        <translation>Número da página mostrada</translation>
    </message>
    <message>
        <source>Previous page</source>
        <translation>Página anterior</translation>
    </message>
    <message>
        <source>Next page</source>
        <translation>Próxima página</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Menor</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Maior</translation>
    </message>
    <message>
        <source>Size of the pages</source>
        <translation>Tamanho das páginas</translation>
    </message>
    <message>
        <source>Size of the pages: fitted, or in per cent of the paper (Ctrl with the wheel)</source>
        <translation>Tamanho das páginas: ajustado, ou em por cento do papel (Ctrl com a roda)</translation>
    </message>
    <message>
        <source>Fit Width</source>
        <translation>Ajustar à largura</translation>
    </message>
    <message>
        <source>Fit Page</source>
        <translation>Ajustar à página</translation>
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
        <translation>Pró&amp;ximo painel</translation>
    </message>
    <message>
        <source>Pre&amp;vious Pane</source>
        <translation>Painel anteri&amp;or</translation>
    </message>
</context>
<context>
    <name>covaria::ui::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Preferências</translation>
    </message>
    <message>
        <source>Results in the window</source>
        <translation>Resultados na janela</translation>
    </message>
    <message>
        <source>New analyses</source>
        <translation>Novas análises</translation>
    </message>
    <message>
        <source>Written into analyses that are added; others stay as they are.</source>
        <translation>Escrito nas análises que são adicionadas; as outras ficam como estão.</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Janela</translation>
    </message>
    <message>
        <source>Of tables and charts of results</source>
        <translation>De tabelas e gráficos de resultados</translation>
    </message>
    <message>
        <source>As the model gives them</source>
        <translation>Como o modelo os dá</translation>
    </message>
    <message>
        <source>Digits of U</source>
        <translation>Algarismos de U</translation>
    </message>
    <message>
        <source>Significant digits of uncertainties; estimates are rounded to match</source>
        <translation>Algarismos significativos das incertezas; as estimativas são arredondadas de acordo</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Números</translation>
    </message>
    <message>
        <source>Of all tables, charts and fields of the window</source>
        <translation>De todas as tabelas, gráficos e campos da janela</translation>
    </message>
    <message>
        <source>As the language writes them</source>
        <translation>Como o idioma os escreve</translation>
    </message>
    <message>
        <source>1234.5 (point)</source>
        <translation>1234.5 (ponto)</translation>
    </message>
    <message>
        <source>1234,5 (comma)</source>
        <translation>1234,5 (vírgula)</translation>
    </message>
    <message>
        <source>Coverage factor</source>
        <translation>Fator de abrangência</translation>
    </message>
    <message>
        <source>Of U = k u, where a new analysis begins with a fixed one</source>
        <translation>De U = k u, onde uma nova análise começa com um fixo</translation>
    </message>
    <message>
        <source>k from the degrees of freedom or the coverage interval</source>
        <translation>k dos graus de liberdade ou do intervalo de abrangência</translation>
    </message>
    <message>
        <source>k = 2</source>
        <translation>k = 2</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Ensaios</translation>
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
        <translation>Da janela, quando o Covaria iniciar de novo</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Como o sistema</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Cores</translation>
    </message>
    <message>
        <source>Of the window, its charts and the scene</source>
        <translation>Da janela, de seus gráficos e da cena</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Escuro</translation>
    </message>
    <message>
        <source>Font size</source>
        <translation>Tamanho da fonte</translation>
    </message>
    <message>
        <source>Of the whole window</source>
        <translation>De toda a janela</translation>
    </message>
    <message>
        <source>as the system</source>
        <translation>como o sistema</translation>
    </message>
    <message>
        <source> pt</source>
        <translation> pt</translation>
    </message>
    <message>
        <source>Recovery copy</source>
        <translation>Cópia de recuperação</translation>
    </message>
    <message>
        <source>How long an edit may stay without a copy that a crash leaves behind</source>
        <translation>Quanto tempo uma edição pode ficar sem uma cópia que sobreviva a uma falha do programa</translation>
    </message>
    <message>
        <source>at most </source>
        <translation>no máximo </translation>
    </message>
    <message>
        <source> s after an edit</source>
        <translation> s após uma edição</translation>
    </message>
    <message>
        <source>Where the project does not state them. Reports and files are the project&apos;s alone.</source>
        <translation>Onde o projeto não as declara. Relatórios e arquivos seguem apenas o projeto.</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>Fonte</translation>
    </message>
    <message>
        <source>Covaria&apos;s own</source>
        <translation>A do Covaria</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProblemsModel</name>
    <message>
        <source>, row %1</source>
        <translation>, linha %1</translation>
    </message>
    <message>
        <source>Project: certificate, %1</source>
        <translation>Projeto: certificado, %1</translation>
    </message>
    <message>
        <source>Project: report</source>
        <translation>Projeto: relatório</translation>
    </message>
    <message>
        <source>evaluation, %1</source>
        <translation>avaliação, %1</translation>
    </message>
    <message>
        <source>To give</source>
        <translation>A indicar</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erro</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Aviso</translation>
    </message>
    <message>
        <source>, line %1</source>
        <translation>, linha %1</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
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
        <translation>correlação de %1 e %2</translation>
    </message>
    <message>
        <source>link of %1</source>
        <translation>ligação de %1</translation>
    </message>
    <message>
        <source>change of %1</source>
        <translation>mudança de %1</translation>
    </message>
    <message>
        <source>requirement on %1</source>
        <translation>requisito de %1</translation>
    </message>
    <message>
        <source>study</source>
        <translation>estudo</translation>
    </message>
    <message>
        <source>design</source>
        <translation>projeto de medição</translation>
    </message>
    <message>
        <source>Way out</source>
        <translation>Saída</translation>
    </message>
    <message>
        <source>or</source>
        <translation>ou</translation>
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
        <translation>Sem problemas.</translation>
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
        <translation>Do projeto ou pedido; no relatório</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Autor</translation>
    </message>
    <message>
        <source>Who evaluated; in the report</source>
        <translation>Quem avaliou; no relatório</translation>
    </message>
    <message>
        <source>Results of all analyses</source>
        <translation>Resultados de todas as análises</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Alterar %1</translation>
    </message>
    <message>
        <source>Not stated</source>
        <translation>Não indicado</translation>
    </message>
    <message>
        <source>Of results in the window, reports, tables and CSV files; where it is not stated, files have the unit of the model</source>
        <translation>Dos resultados na janela, nos relatórios, nas tabelas e nos arquivos CSV; se não indicada, os arquivos têm a unidade do modelo</translation>
    </message>
    <message>
        <source>Change units of results</source>
        <translation>Alterar as unidades dos resultados</translation>
    </message>
    <message>
        <source>Digits of U</source>
        <translation>Algarismos de U</translation>
    </message>
    <message>
        <source>Significant digits of uncertainties in the window and the report; certificates have two</source>
        <translation>Algarismos significativos das incertezas na janela e no relatório; certificados têm dois</translation>
    </message>
    <message>
        <source>Change digits of results</source>
        <translation>Alterar os algarismos dos resultados</translation>
    </message>
    <message>
        <source>Coverage factor</source>
        <translation>Fator de abrangência</translation>
    </message>
    <message>
        <source>A fixed k for U = k u of all analyses whose options state none; empty: from the degrees of freedom, or the coverage interval</source>
        <translation>Um k fixo para U = k u de todas as análises cujas opções não indicam nenhum; vazio: pelos graus de liberdade ou pelo intervalo de abrangência</translation>
    </message>
    <message>
        <source>Change coverage factor</source>
        <translation>Alterar o fator de abrangência</translation>
    </message>
    <message>
        <source>Reports, certificates and files have these units, and those of the model where none is stated; units of the preferences are of the window only.</source>
        <translation>Relatórios, certificados e arquivos têm estas unidades e, onde nenhuma é declarada, as do modelo; as unidades das preferências valem só para a janela.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProjectPane</name>
    <message>
        <source>Project</source>
        <translation>Projeto</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>Re&amp;nomear</translation>
    </message>
    <message>
        <source>&amp;Delete …</source>
        <translation>&amp;Excluir …</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>&amp;Adicionar</translation>
    </message>
    <message>
        <source>&amp;Library and Templates …</source>
        <translation>&amp;Biblioteca e modelos prontos …</translation>
    </message>
    <message>
        <source>The analysis was not added: %1</source>
        <translation>A análise não foi adicionada: %1</translation>
    </message>
    <message>
        <source>“%1” is in the project now</source>
        <translation>“%1” está agora no projeto</translation>
    </message>
    <message>
        <source>Delete “%1”?</source>
        <translation>Excluir “%1”?</translation>
    </message>
    <message>
        <source>

It is used by: %1. They will have an error until they use something else.</source>
        <translation>

É usado por: %1. Eles terão um erro até que usem outra coisa.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Excluir</translation>
    </message>
    <message>
        <source>“%1” is in your library now (Add &gt; From the Library)</source>
        <translation>“%1” está agora em sua biblioteca (Adicionar &gt; Da biblioteca)</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Executar</translation>
    </message>
    <message>
        <source>Keep in My Library</source>
        <translation>Manter em minha biblioteca</translation>
    </message>
    <message>
        <source>Show in the Scene</source>
        <translation>Mostrar na cena</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>Análise</translation>
    </message>
    <message>
        <source>What it uses</source>
        <translation>O que ela usa</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>D&amp;uplicar</translation>
    </message>
    <message>
        <source>Add an analysis or what it uses</source>
        <translation type="unfinished">Adicionar uma análise ou o que ela usa</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ProjectTreeModel</name>
    <message>
        <source>Artefacts</source>
        <translation>Artefatos</translation>
    </message>
    <message>
        <source>Instruments</source>
        <translation>Instrumentos</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Robôs</translation>
    </message>
    <message>
        <source>Points and frames</source>
        <translation>Pontos e referenciais</translation>
    </message>
    <message>
        <source>Analyses</source>
        <translation>Análises</translation>
    </message>
    <message>
        <source>has problems</source>
        <translation>tem problemas</translation>
    </message>
    <message>
        <source>Untitled project</source>
        <translation>Projeto sem título</translation>
    </message>
    <message>
        <source>Title, notes, certificate and contents of the report</source>
        <translation>Título, notas, certificado e conteúdo do relatório</translation>
    </message>
    <message>
        <source>incomplete</source>
        <translation>incompleto</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projeto</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>running</source>
        <translation>em execução</translation>
    </message>
    <message>
        <source>up to date</source>
        <translation>atualizado</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>falhou</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>desatualizado</translation>
    </message>
    <message>
        <source>%1 of %2 requirements not met</source>
        <translation>%1 de %2 requisitos não atendidos</translation>
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
        <translation>O projeto está vazio. Adicione uma análise, ou primeiro o que ela usa, com o sinal de mais acima ou com o botão direito na árvore do projeto.</translation>
    </message>
    <message>
        <source>Select an entry of the project tree to see its properties.</source>
        <translation>Selecione uma entrada da árvore do projeto para ver suas propriedades.</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projeto</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Certificado</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Relatório</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>Avaliação</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Entradas</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Opções</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Estudos</translation>
    </message>
    <message>
        <source>Designs</source>
        <translation>Planejamentos</translation>
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
        <translation>Aqui é preciso um valor.</translation>
    </message>
    <message>
        <source>A whole number is needed here.</source>
        <translation>Aqui é preciso um número inteiro.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::QuantityNotesEdit</name>
    <message>
        <source>Notes on the quantity</source>
        <translation>Notas sobre a grandeza</translation>
    </message>
    <message>
        <source>Why this figure, what was agreed: in the report, below the input quantities</source>
        <translation>Por que este valor, o que foi acordado: no relatório, abaixo das grandezas de entrada</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ReferenceEditor</name>
    <message>
        <source>(nothing in the project fits: add it first)</source>
        <translation>(nada no projeto serve: adicione-o primeiro)</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>(nenhum)</translation>
    </message>
    <message>
        <source>(choose)</source>
        <translation>(escolher)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ReportForm</name>
    <message>
        <source>Analyses, of report and certificate</source>
        <translation>Análises, do relatório e do certificado</translation>
    </message>
    <message>
        <source>Chapters of the report</source>
        <translation>Capítulos do relatório</translation>
    </message>
    <message>
        <source>Long tables</source>
        <translation>Tabelas longas</translation>
    </message>
    <message>
        <source>The report shows what counts most of long tables; the CSV files have them whole. Ticked, they stand whole at the end of the report too.</source>
        <translation>O relatório mostra o que mais conta das tabelas longas; os arquivos CSV as contêm inteiras. Marcadas, ficam também inteiras no fim do relatório.</translation>
    </message>
    <message>
        <source>Whole, in an annex</source>
        <translation>Inteiras, em um anexo</translation>
    </message>
    <message>
        <source>Change the annex of the report</source>
        <translation>Alterar o anexo do relatório</translation>
    </message>
    <message>
        <source>Goes into the report where it is ticked.</source>
        <translation>Entra no relatório onde está marcado.</translation>
    </message>
    <message>
        <source>Put %1 into the report</source>
        <translation>Pôr %1 no relatório</translation>
    </message>
    <message>
        <source>Leave %1 out of the report</source>
        <translation>Deixar %1 fora do relatório</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>English: none is chosen on the page Certificate.</source>
        <translation>Inglês: nenhum foi escolhido na página Certificado.</translation>
    </message>
    <message>
        <source>%1, as chosen on the page Certificate.</source>
        <translation>%1, como escolhido na página Certificado.</translation>
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
        <translation>O que é mostrado: o relatório, ou o certificado de calibração</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Relatório</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Certificado</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>Atualizar</translation>
    </message>
    <message>
        <source>The report</source>
        <translation>O relatório</translation>
    </message>
    <message>
        <source>The certificate</source>
        <translation>O certificado</translation>
    </message>
    <message>
        <source>Out of date: the project or its results have changed since.</source>
        <translation>Desatualizado: o projeto ou seus resultados mudaram desde então.</translation>
    </message>
    <message>
        <source>%1 has not been made yet.</source>
        <translation>%1 ainda não foi feito.</translation>
    </message>
    <message>
        <source>The analyses are running: %1 waits for them.</source>
        <translation>As análises estão em execução: %1 espera por elas.</translation>
    </message>
    <message>
        <source>No analysis is up to date: run one first (F5).</source>
        <translation>Nenhuma análise está atualizada: execute uma primeiro (F5).</translation>
    </message>
    <message>
        <source>%1 could not be made: %2</source>
        <translation>%1 não pôde ser feito: %2</translation>
    </message>
    <message>
        <source>1 page, as printed</source>
        <translation>1 página, como impressa</translation>
    </message>
    <message>
        <source>%1 pages, as printed</source>
        <translation>%1 páginas, como impressas</translation>
    </message>
    <message>
        <source>%1; one required text is not stated</source>
        <translation>%1; um texto exigido não está declarado</translation>
    </message>
    <message>
        <source>%1; %2 required texts are not stated</source>
        <translation>%1; %2 textos exigidos não estão declarados</translation>
    </message>
    <message>
        <source>Pages as they are printed</source>
        <translation>Páginas como são impressas</translation>
    </message>
    <message>
        <source>Being made …</source>
        <translation>em preparação …</translation>
    </message>
</context>
<context>
    <name>covaria::ui::RequirementsForm</name>
    <message>
        <source>U = %1: the target is %2.</source>
        <translation>U = %1: o alvo é %2.</translation>
    </message>
    <message>
        <source>met</source>
        <translation>atingido</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>não atingido</translation>
    </message>
    <message>
        <source>&lt;li&gt;u of %1 reduced from %2 to %3: %4 of what is stated&lt;/li&gt;</source>
        <translation>&lt;li&gt;u de %1 reduzida de %2 para %3: %4 do declarado&lt;/li&gt;</translation>
    </message>
    <message>
        <source>&lt;br&gt;It would be met with one of these alone:&lt;ul&gt;%1&lt;/ul&gt;</source>
        <translation>&lt;br&gt;Seria atingido com uma só destas:&lt;ul&gt;%1&lt;/ul&gt;</translation>
    </message>
    <message>
        <source>&lt;br&gt;No component suffices alone.</source>
        <translation>&lt;br&gt;Nenhuma componente basta sozinha.</translation>
    </message>
    <message>
        <source> It would be met with all standard uncertainties multiplied by %1.</source>
        <translation> Seria atingido com todas as incertezas-padrão multiplicadas por %1.</translation>
    </message>
    <message>
        <source>(trials)</source>
        <translation>(ensaios)</translation>
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
        <translation>Não julgado: %1.</translation>
    </message>
    <message>
        <source>By %5, guard band %1: the result is &lt;b&gt;%2&lt;/b&gt;. Probability of conformance %3 %4.</source>
        <translation>Por %5, banda de guarda %1: o resultado é &lt;b&gt;%2&lt;/b&gt;. Probabilidade de conformidade %3 %4.</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>aceito</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>rejeitado</translation>
    </message>
    <message>
        <source>&lt;br&gt;TUR %1, C&lt;sub&gt;m&lt;/sub&gt; %2.</source>
        <translation>&lt;br&gt;TUR %1, C&lt;sub&gt;m&lt;/sub&gt; %2.</translation>
    </message>
    <message>
        <source>&lt;br&gt;Global risks of the rule: consumer&apos;s %1, producer&apos;s %2.</source>
        <translation>&lt;br&gt;Riscos globais da regra: do consumidor %1, do produtor %2.</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Change the requirement for %1</source>
        <translation>Alterar o requisito para %1</translation>
    </message>
    <message>
        <source>By the law of propagation; Monte Carlo is to follow.</source>
        <translation>Pela lei de propagação; Monte Carlo segue.</translation>
    </message>
    <message>
        <source>By the trials of a preview; the whole run is to follow.</source>
        <translation>Pelos ensaios de uma prévia; a execução completa segue.</translation>
    </message>
    <message>
        <source>Run the analysis to see whether the requirement is met.</source>
        <translation>Execute a análise para ver se o requisito é atingido.</translation>
    </message>
    <message>
        <source>&lt;br&gt;Of what the rule accepts %1 does not conform, of what it rejects %2 does.</source>
        <translation>&lt;br&gt;Do que a regra aceita, %1 não é conforme; do que rejeita, %2 é.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ResultTableModel</name>
    <message>
        <source>Ends of the interval differ by %1 and %2 from those of Monte Carlo; tolerance %3</source>
        <translation>Os extremos do intervalo diferem em %1 e %2 dos de Monte Carlo; tolerância %3</translation>
    </message>
    <message>
        <source>. Other trials could give the other verdict: more of them decide.</source>
        <translation>. Outras tentativas poderiam dar o julgamento contrário: mais tentativas decidem.</translation>
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
        <translation>Balanço</translation>
    </message>
    <message>
        <source>Distributions</source>
        <translation>Distribuições</translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation>Correlação</translation>
    </message>
    <message>
        <source>Convergence</source>
        <translation>Convergência</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>Avaliação</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Estudo</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>Planejamento</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>digits of U: </source>
        <translation>algarismos de U: </translation>
    </message>
    <message>
        <source>Significant digits of uncertainties</source>
        <translation>Algarismos significativos das incertezas</translation>
    </message>
    <message>
        <source>Significant digits of uncertainties in the window; estimates are rounded to match. Documents have those of the project page.</source>
        <translation>Algarismos significativos das incertezas na janela; as estimativas são arredondadas de acordo. Os documentos têm os da página do projeto.</translation>
    </message>
    <message>
        <source>Filter: symbol, name, group</source>
        <translation>Filtro: símbolo, nome, grupo</translation>
    </message>
    <message>
        <source>Filter of the results</source>
        <translation>Filtro dos resultados</translation>
    </message>
    <message>
        <source>All groups</source>
        <translation>Todos os grupos</translation>
    </message>
    <message>
        <source>Results of all poses, points or targets, whichever is selected</source>
        <translation>Resultados de todas as poses, pontos ou alvos, qualquer que seja o selecionado</translation>
    </message>
    <message>
        <source>Not met only</source>
        <translation>Só não atendidos</translation>
    </message>
    <message>
        <source>Only results whose target uncertainty or tolerance is not met</source>
        <translation>Só resultados cuja incerteza-alvo ou tolerância não é atendida</translation>
    </message>
    <message>
        <source>results</source>
        <translation>resultados</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidade</translation>
    </message>
    <message>
        <source>Shortest Coverage Intervals</source>
        <translation>Intervalos de abrangência mais curtos</translation>
    </message>
    <message>
        <source>budget</source>
        <translation>balanço</translation>
    </message>
    <message>
        <source>correlation</source>
        <translation>correlação</translation>
    </message>
    <message>
        <source>All Results</source>
        <translation>Todos os resultados</translation>
    </message>
    <message>
        <source>Go to Source</source>
        <translation>Ir para a origem</translation>
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
        <translation>Tipo de gráfico</translation>
    </message>
    <message>
        <source>Which charts of the result are shown</source>
        <translation>Que gráficos do resultado são mostrados</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Cena</translation>
    </message>
    <message>
        <source>Contributions</source>
        <translation>Contribuições</translation>
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
        <translation>&amp;Executar esta análise</translation>
    </message>
    <message>
        <source>Run &amp;All</source>
        <translation>Executar &amp;todas</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Parar</translation>
    </message>
    <message>
        <source>&amp;Live</source>
        <translation>Ao &amp;vivo</translation>
    </message>
    <message>
        <source>Each edit computes first-order results at once, then Monte Carlo</source>
        <translation>Cada edição calcula de imediato resultados de primeira ordem, depois Monte Carlo</translation>
    </message>
</context>
<context>
    <name>covaria::ui::RunStatus</name>
    <message>
        <source>%1 trials</source>
        <translation>%1 ensaios</translation>
    </message>
    <message>
        <source>, %1 million/s</source>
        <translation>, %1 milhões/s</translation>
    </message>
    <message>
        <source>Progress of the run</source>
        <translation>Progresso da execução</translation>
    </message>
    <message>
        <source>Stop all runs (Esc)</source>
        <translation>Parar todas as execuções (Esc)</translation>
    </message>
    <message>
        <source>Stop all runs</source>
        <translation>Parar todas as execuções</translation>
    </message>
    <message>
        <source>%1: %2 %</source>
        <translation>%1: %2 %</translation>
    </message>
    <message>
        <source>, best so far %1</source>
        <translation>, melhor até agora %1</translation>
    </message>
    <message>
        <source>No analysis yet</source>
        <translation>Ainda sem análise</translation>
    </message>
    <message>
        <source>No analysis selected</source>
        <translation>Nenhuma análise selecionada</translation>
    </message>
    <message>
        <source>has problems</source>
        <translation>tem problemas</translation>
    </message>
    <message>
        <source>, %1 trials</source>
        <translation>, %1 ensaios</translation>
    </message>
    <message>
        <source>, with warnings</source>
        <translation>, com avisos</translation>
    </message>
    <message>
        <source>%1, kept state: </source>
        <translation>%1, estado mantido: </translation>
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
        <translation>Selecione uma análise na árvore do projeto para ver aqui sua disposição.</translation>
    </message>
    <message>
        <source>Which pose or group of outputs to show</source>
        <translation>Que pose ou grupo de saídas mostrar</translation>
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
        <translation>Enquadrar</translation>
    </message>
    <message>
        <source>Everything in the picture (F)</source>
        <translation>Tudo na imagem (F)</translation>
    </message>
    <message>
        <source>Magnification of the uncertainty; it is always written in the picture</source>
        <translation>Ampliação da incerteza; está sempre escrita na imagem</translation>
    </message>
    <message>
        <source>Magnification of the uncertainty</source>
        <translation>Ampliação da incerteza</translation>
    </message>
    <message>
        <source>× %1</source>
        <translation>× %1</translation>
    </message>
    <message>
        <source>Coverage probability of the ellipsoids</source>
        <translation>Probabilidade de abrangência dos elipsoides</translation>
    </message>
    <message>
        <source>p = %1 %</source>
        <translation>p = %1 %</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Referenciais</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Pontos</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>Corpos</translation>
    </message>
    <message>
        <source>Links and Sight Lines</source>
        <translation>Elos e linhas de visada</translation>
    </message>
    <message>
        <source>Vectors</source>
        <translation>Vetores</translation>
    </message>
    <message>
        <source>Ellipsoids</source>
        <translation>Elipsoides</translation>
    </message>
    <message>
        <source>Clouds</source>
        <translation>Nuvens</translation>
    </message>
    <message>
        <source>Histograms on the Walls</source>
        <translation>Histogramas nas paredes</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Rótulos</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Eixos</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legenda</translation>
    </message>
    <message>
        <source>Map of a Study or Design</source>
        <translation>Mapa de um estudo ou planejamento</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Camadas</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;  at %2</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;  em %2</translation>
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
        <translation>Elipsoides do estado mantido</translation>
    </message>
    <message>
        <source>× auto</source>
        <translation>× auto</translation>
    </message>
    <message>
        <source>Context Meshes</source>
        <translation>Malhas de contexto</translation>
    </message>
    <message>
        <source>View from the front right, from above (1); beside it standard and saved views, orthographic or perspective</source>
        <translation>Vista da frente à direita, de cima (1); ao lado, vistas padrão e guardadas, ortográficas ou em perspectiva</translation>
    </message>
    <message>
        <source>Layers: what the picture shows</source>
        <translation>Camadas: o que a imagem mostra</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SceneView</name>
    <message>
        <source>3D scene</source>
        <translation>Cena 3D</translation>
    </message>
    <message>
        <source>The picture could not be written to %1</source>
        <translation>A imagem não pôde ser escrita em %1</translation>
    </message>
    <message>
        <source>Drawing …</source>
        <translation>Desenhando …</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Enquadrar</translation>
    </message>
    <message>
        <source>Copy Picture</source>
        <translation>Copiar imagem</translation>
    </message>
    <message>
        <source>Save Picture …</source>
        <translation>Salvar imagem …</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Salvar imagem</translation>
    </message>
    <message>
        <source>scene.png</source>
        <translation>cena.png</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>Imagem PNG (*.png)</translation>
    </message>
    <message>
        <source>Arrow keys turn the scene, plus and minus zoom, F fits, 1 to 7 are standard views, H hides what is selected, I shows it alone, Shift+H shows all; points and instruments can be dragged to another place</source>
        <translation>As teclas de seta giram a cena, mais e menos ampliam e reduzem, F enquadra, 1 a 7 são vistas padrão, H oculta o selecionado, I mostra só isso, Shift+H mostra tudo; pontos e instrumentos podem ser arrastados para outro lugar</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ocultar</translation>
    </message>
    <message>
        <source>Show Only This</source>
        <translation>Mostrar só isto</translation>
    </message>
    <message>
        <source>Show All</source>
        <translation>Mostrar tudo</translation>
    </message>
    <message>
        <source>Type Coordinates</source>
        <translation>Digitar coordenadas</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SearchActions</name>
    <message>
        <source>&amp;Find Anything …</source>
        <translation>&amp;Encontrar qualquer coisa …</translation>
    </message>
    <message>
        <source>analysis</source>
        <translation>análise</translation>
    </message>
    <message>
        <source>asset</source>
        <translation>recurso</translation>
    </message>
    <message>
        <source>command, menu %1</source>
        <translation>comando, menu %1</translation>
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
        <translation>grandeza de entrada de %1</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>aba</translation>
    </message>
    <message>
        <source>help</source>
        <translation>ajuda</translation>
    </message>
    <message>
        <source>help: %1</source>
        <translation>ajuda: %1</translation>
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
        <translation>Encontrar qualquer coisa</translation>
    </message>
    <message>
        <source>Analyses, quantities, results, fields, commands, help</source>
        <translation>Análises, grandezas, resultados, campos, comandos, ajuda</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>O que foi encontrado</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SecondPart</name>
    <message>
        <source>View of the second part</source>
        <translation>Vista da segunda parte</translation>
    </message>
    <message>
        <source>What the second part of the stage shows</source>
        <translation>O que a segunda parte da área central mostra</translation>
    </message>
    <message>
        <source>Close this part</source>
        <translation>Fechar esta parte</translation>
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
        <translation>O que dizem os resíduos</translation>
    </message>
    <message>
        <source>Level of the tests</source>
        <translation>Nível dos testes</translation>
    </message>
    <message>
        <source>How often a figure that is right is contradicted by chance</source>
        <translation>Com que frequência um número correto é contradito por acaso</translation>
    </message>
    <message>
        <source>Level %1 %</source>
        <translation>Nível %1 %</translation>
    </message>
    <message>
        <source>Back to Stated</source>
        <translation>Voltar ao declarado</translation>
    </message>
    <message>
        <source>Take Over as Seen</source>
        <translation>Adotar como observado</translation>
    </message>
    <message>
        <source>The results follow from the stated uncertainties again</source>
        <translation>Os resultados voltam a resultar das incertezas declaradas</translation>
    </message>
    <message>
        <source>The results, and all that hang on them, follow from the uncertainties that the residuals see, and change with the readings; can be undone</source>
        <translation>Os resultados, e tudo o que depende deles, resultam das incertezas que os resíduos mostram e mudam com as leituras; pode ser desfeito</translation>
    </message>
    <message>
        <source>Back to stated uncertainties</source>
        <translation>Voltar às incertezas declaradas</translation>
    </message>
    <message>
        <source>Take over uncertainties as seen</source>
        <translation>Adotar incertezas como observadas</translation>
    </message>
    <message>
        <source>Go to Source</source>
        <translation type="unfinished">Ir para a origem</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SeenTableModel</name>
    <message>
        <source>interval of the factor</source>
        <translation>intervalo do fator</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SetupForm</name>
    <message>
        <source>Change %1</source>
        <translation>Alterar %1</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>e mais %n</numerusform>
            <numerusform>e mais %n</numerusform>
        </translation>
    </message>
    <message>
        <source>From “%1”: %2. What is stated of them here is not used.</source>
        <translation>De “%1”: %2. O que aqui se declara delas não é usado.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SetupTableModel</name>
    <message>
        <source>Insert rows in %1</source>
        <translation>Inserir linhas em %1</translation>
    </message>
    <message>
        <source>Delete rows of %1</source>
        <translation>Excluir linhas de %1</translation>
    </message>
    <message>
        <source>Paste into %1</source>
        <translation>Colar em %1</translation>
    </message>
    <message>
        <source>Delete rows</source>
        <translation>Excluir linhas</translation>
    </message>
    <message>
        <source>Fill down in %1</source>
        <translation>Preencher abaixo em %1</translation>
    </message>
    <message>
        <source>Clear cells of %1</source>
        <translation>Limpar células de %1</translation>
    </message>
    <message>
        <source>Change unit in %1</source>
        <translation>Alterar unidade em %1</translation>
    </message>
    <message>
        <source>Take %1 into the project</source>
        <translation>Levar %1 para o projeto</translation>
    </message>
    <message>
        <source>%1 is no unit for a quantity in %2.</source>
        <translation>%1 não é unidade para uma grandeza em %2.</translation>
    </message>
    <message>
        <source>Its value is %1 of the analysis “%2”: what is stated here is not used.</source>
        <translation>O seu valor é %1 da análise “%2”: o que está declarado aqui não é usado.</translation>
    </message>
    <message>
        <source>%1 of the value</source>
        <translation>%1 do valor</translation>
    </message>
    <message>
        <source>%1 absolute, not a part of the value</source>
        <translation>%1 em termos absolutos, não uma parte do valor</translation>
    </message>
    <message>
        <source>Change %1: %2</source>
        <translation>Mudar %1: %2</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>linha %1</translation>
    </message>
</context>
<context>
    <name>covaria::ui::SortableTable</name>
    <message>
        <source>Click to sort, right click to choose columns</source>
        <translation>Clique para ordenar, botão direito para escolher colunas</translation>
    </message>
    <message>
        <source>Save Table</source>
        <translation>Salvar tabela</translation>
    </message>
    <message>
        <source>CSV table (*.csv)</source>
        <translation>Tabela CSV (*.csv)</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Selecionar tudo</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Colunas</translation>
    </message>
    <message>
        <source>Original Order</source>
        <translation>Ordem original</translation>
    </message>
    <message>
        <source>Save as CSV …</source>
        <translation>Salvar como CSV …</translation>
    </message>
    <message>
        <source>Fit Widths</source>
        <translation>Ajustar larguras</translation>
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
        <translation>Recortar</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Colar</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Limpar</translation>
    </message>
    <message>
        <source>Fill down</source>
        <translation>Preencher abaixo</translation>
    </message>
    <message>
        <source>Insert row above</source>
        <translation>Inserir linha acima</translation>
    </message>
    <message>
        <source>Add row at the end</source>
        <translation>Adicionar linha no fim</translation>
    </message>
    <message>
        <source>Delete rows</source>
        <translation>Excluir linhas</translation>
    </message>
</context>
<context>
    <name>covaria::ui::Stage</name>
    <message>
        <source>Two views at once</source>
        <translation>Duas vistas ao mesmo tempo</translation>
    </message>
    <message>
        <source>Below Each Other</source>
        <translation>Uma abaixo da outra</translation>
    </message>
    <message>
        <source>Beside Each Other</source>
        <translation>Lado a lado</translation>
    </message>
</context>
<context>
    <name>covaria::ui::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>Página inicial</translation>
    </message>
    <message>
        <source>New Project</source>
        <translation>Novo projeto</translation>
    </message>
    <message>
        <source>Open …</source>
        <translation>Abrir …</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Recentes</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Exemplos</translation>
    </message>
    <message>
        <source>They open as new projects; the shipped files stay as they are.</source>
        <translation>Abrem como novos projetos; os arquivos fornecidos ficam como estão.</translation>
    </message>
    <message>
        <source>Projects that you open are listed here.</source>
        <translation>Os projetos abertos serão listados aqui.</translation>
    </message>
    <message>
        <source>First Steps</source>
        <translation>Primeiros passos</translation>
    </message>
    <message>
        <source>A budget from nothing to a PDF, in ten steps beside the window</source>
        <translation>Um balanço do zero ao PDF, em dez passos ao lado da janela</translation>
    </message>
    <message>
        <source>What do you want to know?</source>
        <translation>O que você quer saber?</translation>
    </message>
    <message>
        <source>Library …</source>
        <translation>Biblioteca …</translation>
    </message>
    <message>
        <source>A quantity by an equation</source>
        <translation>Uma grandeza por uma equação</translation>
    </message>
    <message>
        <source>Type y = f(x), state each input, get the budget.</source>
        <translation>Digite y = f(x), declare cada entrada, obtenha o balanço.</translation>
    </message>
    <message>
        <source>Points by instruments</source>
        <translation>Pontos por instrumentos</translation>
    </message>
    <message>
        <source>Tracker, total station, camera; one or many.</source>
        <translation>Laser tracker, estação total, câmera; um ou vários.</translation>
    </message>
    <message>
        <source>The pose of an object</source>
        <translation>A pose de um objeto</translation>
    </message>
    <message>
        <source>A frame from its points, in the frame of another.</source>
        <translation>Um referencial por seus pontos, no referencial de outro.</translation>
    </message>
    <message>
        <source>A robot</source>
        <translation>Um robô</translation>
    </message>
    <message>
        <source>Where its tool is, and what its parameters are.</source>
        <translation>Onde está sua ferramenta, e quais são seus parâmetros.</translation>
    </message>
    <message>
        <source>A file I have</source>
        <translation>Um arquivo que tenho</translation>
    </message>
    <message>
        <source>Excel budget, points, measurement report.</source>
        <translation>Balanço do Excel, pontos, relatório de medição.</translation>
    </message>
    <message>
        <source>Budget, Points or Report …</source>
        <translation>Balanço, pontos ou relatório …</translation>
    </message>
    <message>
        <source>Robot (URDF) …</source>
        <translation>Robô (URDF) …</translation>
    </message>
    <message>
        <source>Project …</source>
        <translation>Projeto …</translation>
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
        <translation>Estudo</translation>
    </message>
    <message>
        <source>Adds a study of this analysis</source>
        <translation>Adiciona um estudo desta análise</translation>
    </message>
    <message>
        <source>Adds a copy of this study</source>
        <translation>Adiciona uma cópia deste estudo</translation>
    </message>
    <message>
        <source>Deletes this study</source>
        <translation>Exclui este estudo</translation>
    </message>
    <message>
        <source>Evaluates the analysis at every grid point of this study</source>
        <translation>Avalia a análise em cada ponto da grade deste estudo</translation>
    </message>
    <message>
        <source>A study evaluates this analysis for many values of a number: a sweep over one, a map over two or three. Add one to see how the uncertainty depends on the set-up.</source>
        <translation>Um estudo avalia esta análise para muitos valores de um número: uma varredura sobre um, um mapa sobre dois ou três. Adicione um para ver como a incerteza depende da configuração.</translation>
    </message>
    <message>
        <source>Name of the study</source>
        <translation>Nome do estudo</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>Law of propagation</source>
        <translation>Lei de propagação</translation>
    </message>
    <message>
        <source>Monte Carlo</source>
        <translation>Monte Carlo</translation>
    </message>
    <message>
        <source>Trials at each grid point</source>
        <translation>Ensaios em cada ponto da grade</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Trials per point</source>
        <translation>Ensaios por ponto</translation>
    </message>
    <message>
        <source>Add Axis</source>
        <translation>Adicionar eixo</translation>
    </message>
    <message>
        <source>Varies one more number: every combination is evaluated</source>
        <translation>Varia mais um número: cada combinação é avaliada</translation>
    </message>
    <message>
        <source>Output quantities of the study</source>
        <translation>Grandezas de saída do estudo</translation>
    </message>
    <message>
        <source>Output quantities looked at; with none ticked, all measurands</source>
        <translation>Grandezas de saída consideradas; sem nenhuma marcada, todos os mensurandos</translation>
    </message>
    <message>
        <source>Outputs (none ticked: all measurands)</source>
        <translation>Saídas (nenhuma marcada: todos os mensurandos)</translation>
    </message>
</context>
<context>
    <name>covaria::ui::StudyAxisEdit</name>
    <message>
        <source>Axis %1</source>
        <translation>Eixo %1</translation>
    </message>
    <message>
        <source>Variable %1</source>
        <translation>Variável %1</translation>
    </message>
    <message>
        <source>Remove Axis</source>
        <translation>Remover eixo</translation>
    </message>
    <message>
        <source>Remove Variable</source>
        <translation>Remover variável</translation>
    </message>
    <message>
        <source>takes these values</source>
        <translation>toma estes valores</translation>
    </message>
    <message>
        <source>is multiplied with</source>
        <translation>é multiplicado por</translation>
    </message>
    <message>
        <source>has added to it</source>
        <translation>é acrescido de</translation>
    </message>
    <message>
        <source>evenly spaced</source>
        <translation>igualmente espaçados</translation>
    </message>
    <message>
        <source>logarithmically spaced</source>
        <translation>logaritmicamente espaçados</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Até</translation>
    </message>
    <message>
        <source>Number of values</source>
        <translation>Número de valores</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerância</translation>
    </message>
    <message>
        <source>It can be put into effect only so well: what counts is the worst within it</source>
        <translation>Só pode ser realizado com esta exatidão: o que conta é o pior dentro dela</translation>
    </message>
    <message>
        <source>Varied</source>
        <translation>Variado</translation>
    </message>
    <message>
        <source>It</source>
        <translation>Ele</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>choose what is varied</source>
        <translation>escolha o que se varia</translation>
    </message>
    <message>
        <source> (factor)</source>
        <translation> (fator)</translation>
    </message>
    <message>
        <source>%1: has a problem</source>
        <translation>%1: tem um problema</translation>
    </message>
</context>
<context>
    <name>covaria::ui::StudyTab</name>
    <message>
        <source>study</source>
        <translation>estudo</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Estudo</translation>
    </message>
    <message>
        <source>Study of this analysis</source>
        <translation>Estudo desta análise</translation>
    </message>
    <message>
        <source>Run Study</source>
        <translation>Executar estudo</translation>
    </message>
    <message>
        <source>Edit …</source>
        <translation>Editar …</translation>
    </message>
    <message>
        <source>Axes, outputs and method of the study, in the properties of the analysis</source>
        <translation>Eixos, saídas e método do estudo, nas propriedades da análise</translation>
    </message>
    <message>
        <source>Quantity of the study</source>
        <translation>Grandeza do estudo</translation>
    </message>
    <message>
        <source>What the chart and the scene show</source>
        <translation>O que o gráfico e a cena mostram</translation>
    </message>
    <message>
        <source>Kind of chart</source>
        <translation>Tipo de gráfico</translation>
    </message>
    <message>
        <source>A map, or lines over the first axis</source>
        <translation>Um mapa, ou linhas sobre o primeiro eixo</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linhas</translation>
    </message>
    <message>
        <source>Axis of the slices</source>
        <translation>Eixo das fatias</translation>
    </message>
    <message>
        <source>Which axis the slices are across</source>
        <translation>A que eixo as fatias são transversais</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>Fatia</translation>
    </message>
    <message>
        <source>slice only</source>
        <translation>só fatia</translation>
    </message>
    <message>
        <source>In the scene: the points of this slice; else all</source>
        <translation>Na cena: os pontos desta fatia; senão todos</translation>
    </message>
    <message>
        <source>ellipsoids</source>
        <translation>elipsoides</translation>
    </message>
    <message>
        <source>In the scene: coverage ellipsoids at the grid points</source>
        <translation>Na cena: elipsoides de abrangência nos pontos da grade</translation>
    </message>
    <message>
        <source>Add Study …</source>
        <translation>Adicionar estudo …</translation>
    </message>
    <message>
        <source>Out of date: of the project as it was</source>
        <translation>Desatualizado: do projeto como era</translation>
    </message>
    <message>
        <source>slice: </source>
        <translation>fatia: </translation>
    </message>
    <message>
        <source> – out of date</source>
        <translation> – desatualizado</translation>
    </message>
    <message>
        <source>running …</source>
        <translation>executando …</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Falhou: %1</translation>
    </message>
    <message>
        <source>Not evaluated yet.</source>
        <translation>Ainda não avaliado.</translation>
    </message>
    <message>
        <source>%1 grid points</source>
        <translation>%1 pontos da grade</translation>
    </message>
    <message>
        <source>, %1 without values</source>
        <translation>, %1 sem valores</translation>
    </message>
    <message>
        <source>&lt;b&gt;Out of date&lt;/b&gt;: shown for the project as it was. </source>
        <translation>&lt;b&gt;Desatualizado&lt;/b&gt;: mostrado para o projeto como era. </translation>
    </message>
    <message>
        <source>“%1” shows how the uncertainty depends on what the study varies.</source>
        <translation>“%1” mostra como a incerteza depende do que o estudo varia.</translation>
    </message>
    <message>
        <source>A study evaluates the analysis for many values of a number: add one with “%1”.</source>
        <translation>Um estudo avalia a análise para muitos valores de um número: adicione um com “%1”.</translation>
    </message>
</context>
<context>
    <name>covaria::ui::StudyTableModel</name>
    <message>
        <source>Remark</source>
        <translation>Comentário</translation>
    </message>
    <message>
        <source>Why there are no values, or what is wrong with them</source>
        <translation>Por que não há valores, ou o que há de errado com eles</translation>
    </message>
</context>
<context>
    <name>covaria::ui::TabBar</name>
    <message>
        <source>More tabs</source>
        <translation>Mais separadores</translation>
    </message>
</context>
<context>
    <name>covaria::ui::TableEditor</name>
    <message>
        <source>Take into the project</source>
        <translation>Levar para o projeto</translation>
    </message>
    <message>
        <source>Add row</source>
        <translation>Adicionar linha</translation>
    </message>
    <message>
        <source>Delete rows</source>
        <translation>Excluir linhas</translation>
    </message>
    <message>
        <source>Import CSV …</source>
        <translation>Importar CSV …</translation>
    </message>
    <message>
        <source>Read from %1</source>
        <translation>Lido de %1</translation>
    </message>
    <message>
        <source>The rows are read from %1. Taken into the project they can be edited here.</source>
        <translation>As linhas são lidas de %1. Levadas para o projeto, podem ser editadas aqui.</translation>
    </message>
    <message>
        <source>Import CSV into %1</source>
        <translation>Importar CSV para %1</translation>
    </message>
    <message>
        <source>Tables (*.csv *.tsv *.txt);;All files (*)</source>
        <translation>Tabelas (*.csv *.tsv *.txt);;Todos os arquivos (*)</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Importar %1</translation>
    </message>
    <message>
        <source>All columns</source>
        <translation>Todas as colunas</translation>
    </message>
    <message>
        <source>Shows also the columns that no row has something in</source>
        <translation>Mostra também as colunas em que nenhuma linha tem algo</translation>
    </message>
    <message>
        <source>Fill down</source>
        <translation type="unfinished">Preencher abaixo</translation>
    </message>
</context>
<context>
    <name>covaria::ui::TargetBox</name>
    <message>
        <source>What is varied: type a part of its name to search</source>
        <translation>O que se varia: digite parte do nome para buscar</translation>
    </message>
    <message>
        <source>What is varied</source>
        <translation>O que se varia</translation>
    </message>
    <message>
        <source>“%1” names nothing that can be varied.</source>
        <translation>“%1” não designa nada que possa ser variado.</translation>
    </message>
    <message numerus="yes">
        <source>“%1” names %n things that can be varied.</source>
        <translation>
            <numerusform>“%1” designa %n coisas que podem ser variadas.</numerusform>
            <numerusform>“%1” designa %n coisas que podem ser variadas.</numerusform>
        </translation>
    </message>
    <message>
        <source> (factor)</source>
        <translation> (fator)</translation>
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
        <translation>Unidades das tabelas e gráficos</translation>
    </message>
    <message>
        <source>As the Model Gives Them</source>
        <translation>Como o modelo as dá</translation>
    </message>
    <message>
        <source>Change unit of results</source>
        <translation>Alterar a unidade dos resultados</translation>
    </message>
    <message>
        <source>Clear units of results</source>
        <translation>Limpar as unidades dos resultados</translation>
    </message>
    <message>
        <source>In Reports and Files Too</source>
        <translation>Também em relatórios e arquivos</translation>
    </message>
    <message>
        <source>States the units that are shown in the project: they are those of its documents</source>
        <translation>Fixa no projeto as unidades mostradas: são as dos seus documentos</translation>
    </message>
    <message>
        <source>Units of the tables and charts; reports and files have those that the project states</source>
        <translation>Unidades das tabelas e gráficos; relatórios e arquivos têm as que o projeto indica</translation>
    </message>
</context>
<context>
    <name>covaria::ui::UnitChoices</name>
    <message>
        <source>Lengths</source>
        <translation>Comprimentos</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Ângulos</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Forças</translation>
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
        <translation>O que está digitado em um campo não pode ser lido. %1</translation>
    </message>
</context>
<context>
    <name>covaria::ui::ViewActions</name>
    <message>
        <source>&amp;Scene</source>
        <translation>&amp;Cena</translation>
    </message>
    <message>
        <source>Save View</source>
        <translation>Salvar vista</translation>
    </message>
    <message>
        <source>Name of the view:</source>
        <translation>Nome da vista:</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Enquadrar</translation>
    </message>
    <message>
        <source>&amp;Orthographic</source>
        <translation>&amp;Ortográfica</translation>
    </message>
    <message>
        <source>Parallel lines stay parallel, and the scale bar holds everywhere</source>
        <translation>Linhas paralelas continuam paralelas, e a escala gráfica vale em toda parte</translation>
    </message>
    <message>
        <source>Show &amp;All</source>
        <translation>Mostrar &amp;tudo</translation>
    </message>
    <message>
        <source>&amp;Save View …</source>
        <translation>&amp;Salvar vista …</translation>
    </message>
    <message>
        <source>Remo&amp;ve View</source>
        <translation>&amp;Remover vista</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Vista %1</translation>
    </message>
    <message>
        <source>Save View %1</source>
        <translation>Salvar vista %1</translation>
    </message>
    <message>
        <source>Remove View %1</source>
        <translation>Remover vista %1</translation>
    </message>
</context>
</TS>
