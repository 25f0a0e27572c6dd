<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- SPDX-License-Identifier: LGPL-2.1-or-later -->
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>How the laps of the spiral are made</source>
        <translation>螺线各圈的生成方式</translation>
    </message>
    <message>
        <source>Percent of cutter diameter to step over on each lap, at most</source>
        <translation>每圈步距占刀具直径的百分比上限</translation>
    </message>
    <message>
        <source>Largest engagement angle of a straight cut, in place of StepOver; 0 for that of StepOver</source>
        <translation>直线切削的最大啮合角，代替 StepOver；0 表示由 StepOver 决定</translation>
    </message>
    <message>
        <source>Climb or conventional milling, for a spindle that turns clockwise</source>
        <translation>顺铣或逆铣（主轴正转）</translation>
    </message>
    <message>
        <source>How much stock to leave in the XY plane (eg for finishing operation)</source>
        <translation>XY 平面内保留的余量（例如用于精加工）</translation>
    </message>
    <message>
        <source>How much stock to leave along the Z axis</source>
        <translation>沿 Z 轴保留的余量</translation>
    </message>
    <message>
        <source>Ramp angle of the helical entry</source>
        <translation>螺旋下刀的斜坡角度</translation>
    </message>
    <message>
        <source>Limit helix entry diameter, if limit larger than tool diameter or 0, tool diameter is used</source>
        <translation>螺旋下刀直径上限；若大于刀具直径或为 0，则用刀具直径</translation>
    </message>
    <message>
        <source>Largest deviation of the path from the exact curve</source>
        <translation>刀路与精确曲线的最大偏差</translation>
    </message>
    <message>
        <source>The machine on which the time is to be least</source>
        <translation>以用时最短为目标的机床</translation>
    </message>
    <message>
        <source>How the feed follows the engagement: slowed where it passes the limit, slowed linearly with the chip, or raised where the chip is thin</source>
        <translation>进给如何随啮合变化：超限处减速、随切屑线性减速，或在切屑薄处加速</translation>
    </message>
    <message>
        <source>Feed at the largest radial depth of cut, in percent (Linear slow-down)</source>
        <translation>最大径向切深处的进给百分比（线性减速）</translation>
    </message>
    <message>
        <source>Largest feed where the chip is thin, as a multiple of the tool controller's (Chip thickness)</source>
        <translation>切屑薄处的最大进给，为刀具控制器进给的倍数（切屑厚度）</translation>
    </message>
    <message>
        <source>Feed of moves at depth through cleared ground in mm/min, 0 for the horizontal rapid rate</source>
        <translation>在已清除区域内以切深移动时的进给 (mm/min)，0 为水平快移速度</translation>
    </message>
    <message>
        <source>Largest axial depth of one level of a slot that opens the pocket, 0 for automatic</source>
        <translation>开槽时每层的最大轴向切深，0 为自动</translation>
    </message>
    <message>
        <source>To take a finishing lap along the walls at the end; Automatic and Extended Archimedean do without, their laps finish the walls</source>
        <translation>最后沿侧壁走一圈精加工；“自动”和“扩展阿基米德”不需要，其圈次已精加工侧壁</translation>
    </message>
    <message>
        <source>Ignore islands and clear everything inside the outline</source>
        <translation>忽略岛屿，清除轮廓内的全部材料</translation>
    </message>
    <message>
        <source>Clear the floor beyond its edge where no wall rises, and begin there in the air where the stock ends near by; else the cutter stays within the floor</source>
        <translation>在没有侧壁的地方越过底面边缘进行清除，若毛坯就在附近结束则从空气中开始；否则刀具保持在底面之内</translation>
    </message>
    <message>
        <source>Cut only what earlier operations of the job have left standing in the pocket</source>
        <translation>仅加工任务中先前操作在型腔内留下的材料</translation>
    </message>
    <message>
        <source>Make True, if specifying a Start Point</source>
        <translation>指定起点时设为 True</translation>
    </message>
    <message>
        <source>Where the cutter goes down, as near as it can; its height does not matter</source>
        <translation>刀具下刀位置，尽可能靠近；高度无关</translation>
    </message>
    <message>
        <source>The exact curves behind the path, B-splines at the floors; can be exported to STEP</source>
        <translation>刀路背后的精确曲线，位于底面的 B 样条；可导出为 STEP</translation>
    </message>
    <message>
        <source>Largest engagement angle that was measured, at the floor after the entry</source>
        <translation>测得的最大啮合角，在进刀后的底面处</translation>
    </message>
    <message>
        <source>Area within the cutter's reach left standing, in mm^2</source>
        <translation>刀具可达但未切除的面积 (mm^2)</translation>
    </message>
    <message>
        <source>How far the cutter passes the walls, measured</source>
        <translation>测得的刀具越过侧壁的距离</translation>
    </message>
    <message>
        <source>Length of all cutting moves</source>
        <translation>全部切削移动的长度</translation>
    </message>
    <message>
        <source>Time of the path on the chosen machine, in seconds</source>
        <translation>路径在所选机床上的时间，单位为秒</translation>
    </message>
    <message>
        <source>What the machinist should know about this path</source>
        <translation>操作者应了解的刀路说明</translation>
    </message>
    <message>
        <source>Version of these properties</source>
        <translation>这些属性的版本</translation>
    </message>
</context>
<context>
    <name>SpiralPocket</name>
    <message>
        <source>{} was saved by a FreeCAD without Spiral Pocket; its path may be older than the part. Recompute the document.</source>
        <translation>{} 曾由没有 Spiral Pocket 的 FreeCAD 保存；其刀路可能比零件旧。请重新计算文档。</translation>
    </message>
    <message>
        <source>Compare...</source>
        <translation>比较…</translation>
    </message>
    <message>
        <source>All strategies side by side</source>
        <translation>并列比较全部策略</translation>
    </message>
    <message>
        <source>Use this</source>
        <translation>采用此项</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>用时</translation>
    </message>
    <message>
        <source>Cutting length</source>
        <translation>切削长度</translation>
    </message>
    <message>
        <source>Largest engagement</source>
        <translation>最大啮合角</translation>
    </message>
    <message>
        <source>99 % of it below</source>
        <translation>99 % 低于</translation>
    </message>
    <message>
        <source>Mean engagement</source>
        <translation>平均啮合角</translation>
    </message>
    <message>
        <source>Left uncut in reach</source>
        <translation>可及范围内未切削</translation>
    </message>
    <message>
        <source>the fastest that keeps the limit of engagement on 99 % of the way and leaves nothing uncut</source>
        <translation>在 99 % 的路程上保持啮合上限且不留残料的最快策略</translation>
    </message>
    <message>
        <source>An error, see the Report view.</source>
        <translation>出错，见报告视图。</translation>
    </message>
    <message>
        <source>Planning... {:.0f} %</source>
        <translation>规划中… {:.0f} %</translation>
    </message>
    <message>
        <source>No path</source>
        <translation>无刀路</translation>
    </message>
    <message>
        <source>FreeCAD's Adaptive</source>
        <translation>FreeCAD 自适应</translation>
    </message>
    <message>
        <source>Compare strategies</source>
        <translation>比较策略</translation>
    </message>
    <message>
        <source>Pocket {} ({}), {}</source>
        <translation>型腔 {}（{}），{}</translation>
    </message>
    <message>
        <source>No pocket: the first line of the panel says why.</source>
        <translation>没有型腔：面板第一行说明了原因。</translation>
    </message>
    <message>
        <source>With the same cutter, step-over and feeds on {}. Limit of engagement {:.0f}°; what clearly passes it, or stays uncut, is red. ★ the fastest that keeps it on 99 % of the way and leaves nothing uncut.</source>
        <translation>相同的刀具、步距和进给，机床为 {}。啮合角上限 {:.0f}°；明显超过者或未切除者以红色显示。★ 在 99 % 的路程上遵守上限且不留残料的最快策略。</translation>
    </message>
    <message>
        <source>Create Spiral Pocket</source>
        <translation>创建螺旋型腔</translation>
    </message>
    <message>
        <source>Type {} to {}.</source>
        <translation>请输入 {} 到 {} 之间的值。</translation>
    </message>
    <message>
        <source>Type more than {} and less than {}.</source>
        <translation>请输入大于 {} 且小于 {} 的值。</translation>
    </message>
    <message>
        <source>Type a number.</source>
        <translation>请输入一个数。</translation>
    </message>
    <message>
        <source>Type a number; where no unit is typed, it is "{}".</source>
        <translation>请输入一个数；未写单位时，单位为“{}”。</translation>
    </message>
    <message>
        <source>Type {} or more.</source>
        <translation>请输入不小于 {} 的值。</translation>
    </message>
    <message>
        <source>Type more than 0, at most {}.</source>
        <translation>请输入大于 0 且不超过 {} 的值。</translation>
    </message>
    <message>
        <source>Feed of moves at depth through cleared ground, 0 for the horizontal rapid rate</source>
        <translation>在已清除区域内以切深移动时的进给，0 为水平快移速度</translation>
    </message>
    <message>
        <source>Set by the expression {}</source>
        <translation>由表达式 {} 决定</translation>
    </message>
    <message>
        <source>The same step-over as a length, for this cutter</source>
        <translation>同一步距以长度表示，针对此刀具</translation>
    </message>
    <message>
        <source>The engagement angle of a straight cut at this step-over: 90° at half the cutter's diameter, 180° in a full slot</source>
        <translation>此步距下直线切削的啮合角：半个刀径时为 90°，全槽时为 180°</translation>
    </message>
    <message>
        <source>{}: "{}" is not taken, {} stays.</source>
        <translation>{}：不接受“{}”，保留 {}。</translation>
    </message>
    <message>
        <source>OK once more keeps what was made without that.</source>
        <translation>再按一次“确定”即保留其余已完成的部分。</translation>
    </message>
    <message>
        <source>The remarks in the result box say why.</source>
        <translation>“结果”框中的提示说明了原因。</translation>
    </message>
    <message>
        <source>OK once more keeps this path.</source>
        <translation>再按一次“确定”即保留此刀路。</translation>
    </message>
    <message>
        <source>An error in the add-on: the path was not computed.</source>
        <translation>插件出错：刀路未计算。</translation>
    </message>
    <message>
        <source>Please report it with the text in the Report view.</source>
        <translation>请连同“报告视图”中的文本一起报告。</translation>
    </message>
    <message>
        <source>Remove Spiral Pocket</source>
        <translation>删除螺旋型腔</translation>
    </message>
    <message>
        <source>{} of the floor stay uncut.</source>
        <translation>底面有 {} 未切除。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Spiral Pocket</source>
        <translation>螺旋型腔</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>图表</translation>
    </message>
    <message>
        <source>Engagement, feed, velocity and force along the time</source>
        <translation>啮合角、进给、速度和切削力随时间变化</translation>
    </message>
    <message>
        <source>Aluminum 6082-T6</source>
        <translation>6082-T6 铝合金</translation>
    </message>
    <message>
        <source>Spiral Pocket plots</source>
        <translation>螺旋型腔图表</translation>
    </message>
    <message>
        <source>Mean cutting force in {} [N]</source>
        <translation>{} 中的平均切削力 [N]</translation>
    </message>
    <message>
        <source>No path: the first line of the panel says why.</source>
        <translation>没有刀路：面板第一行说明了原因。</translation>
    </message>
    <message>
        <source>Engagement [°]</source>
        <translation>啮合角 [°]</translation>
    </message>
    <message>
        <source>Time [s]</source>
        <translation>时间 [s]</translation>
    </message>
    <message>
        <source>No force: no spindle speed in the tool controller</source>
        <translation>无切削力：刀具控制器中没有主轴转速</translation>
    </message>
    <message>
        <source>Plots need the Python library matplotlib.</source>
        <translation>图表需要 Python 库 matplotlib。</translation>
    </message>
    <message>
        <source>Install it with the Addon Manager or pip.</source>
        <translation>请用插件管理器或 pip 安装。</translation>
    </message>
    <message>
        <source>Programmed feed [{}]</source>
        <translation>编程进给 [{}]</translation>
    </message>
    <message>
        <source>The machine's velocity [{}]</source>
        <translation>机床速度 [{}]</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>Draw the path anew while values change</source>
        <translation>数值更改时重新绘制刀路</translation>
    </message>
    <message>
        <source>What the colors of the cut show</source>
        <translation>切削颜色的含义</translation>
    </message>
    <message>
        <source>Play the cut</source>
        <translation>播放切削</translation>
    </message>
    <message>
        <source>How far the cut is shown</source>
        <translation>切削显示进度</translation>
    </message>
    <message>
        <source>Feed [{}]</source>
        <translation>进给 [{}]</translation>
    </message>
    <message>
        <source>The mark is the limit at the step-over: {:.0f}°</source>
        <translation>标记为该步距下的上限：{:.0f}°</translation>
    </message>
    <message>
        <source>entry</source>
        <translation>下刀</translation>
    </message>
    <message>
        <source>link</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>rapid</source>
        <translation>快移</translation>
    </message>
    <message>
        <source>cleared</source>
        <translation>已清除</translation>
    </message>
    <message>
        <source>left over</source>
        <translation>残留</translation>
    </message>
    <message>
        <source>island</source>
        <translation>岛屿</translation>
    </message>
    <message>
        <source>Switched off.</source>
        <translation>已关闭。</translation>
    </message>
    <message>
        <source>This is the proved path.</source>
        <translation>这是已验证的刀路。</translation>
    </message>
    <message>
        <source>Draft. Stopped; Apply or the next change goes on.</source>
        <translation>草稿。已停止；“应用”或下次更改时继续。</translation>
    </message>
    <message>
        <source>Draft. The path is being proved: {:.0f} %</source>
        <translation>草稿。正在验证刀路：{:.0f} %</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>The operation has this path.</source>
        <translation>工序已采用此刀路。</translation>
    </message>
    <message>
        <source>OK or Apply makes this path.</source>
        <translation>“确定”或“应用”生成此刀路。</translation>
    </message>
    <message>
        <source>Stopped: no new path. OK or Apply plans it again.</source>
        <translation>已停止：没有新刀路。“确定”或“应用”重新规划。</translation>
    </message>
    <message>
        <source>Live is off: OK or Apply plans the path.</source>
        <translation>“实时”已关闭：“确定”或“应用”规划刀路。</translation>
    </message>
    <message>
        <source>There is no path.</source>
        <translation>没有刀路。</translation>
    </message>
    <message>
        <source>Planning: {:.0f} %</source>
        <translation>正在规划：{:.0f} %</translation>
    </message>
    <message>
        <source>Click to see the place</source>
        <translation>点击查看位置</translation>
    </message>
    <message>
        <source>FreeCAD's estimate</source>
        <translation>FreeCAD 估算</translation>
    </message>
    <message>
        <source>Entry at full width, deep</source>
        <translation>全宽进刀深度</translation>
    </message>
    <message>
        <source>Gouge</source>
        <translation>过切</translation>
    </message>
    <message>
        <source>{:.0f}°, limit {:.0f}°</source>
        <translation>{:.0f}°，上限 {:.0f}°</translation>
    </message>
    <message>
        <source>whole width, {} deep</source>
        <translation>全宽切削，深 {}</translation>
    </message>
    <message>
        <source>Time on {}</source>
        <translation>在 {} 上的用时</translation>
    </message>
    <message>
        <source>{} (allowed: {})</source>
        <translation>{}（允许 {}）</translation>
    </message>
    <message>
        <source>pockets not cut: {}</source>
        <translation>未加工的型腔：{}</translation>
    </message>
    <message>
        <source>remarks: {}</source>
        <translation>提示：{} 条</translation>
    </message>
    <message>
        <source>{} uncut</source>
        <translation>{} 未切除</translation>
    </message>
    <message>
        <source>Any pocket, with islands and necks: holds the engagement, least time on the machine</source>
        <translation>任意型腔，含岛屿和窄颈：保持啮合角，机床用时最短</translation>
    </message>
    <message>
        <source>One exact B-spline from the middle to the wall, for pockets without islands</source>
        <translation>从中部到侧壁的一条精确 B 样条，用于无岛屿型腔</translation>
    </message>
    <message>
        <source>Even laps about the pocket's middle line, for long and branched pockets</source>
        <translation>围绕中线的均匀圈次，用于狭长和分叉型腔</translation>
    </message>
    <message>
        <source>Laps like lines of equal temperature, smooth everywhere, for compact pockets</source>
        <translation>圈次如等温线，处处光顺，用于紧凑型腔</translation>
    </message>
    <message>
        <source>A round spiral that turns into the wall's shape, for compact pockets</source>
        <translation>由圆螺线过渡到侧壁形状，用于紧凑型腔</translation>
    </message>
    <message>
        <source>Start point</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>"{}"</source>
        <translation>“{}”</translation>
    </message>
    <message>
        <source>Switched off: no path until Active is set again.</source>
        <translation>已停用：重新启用 Active 之前没有刀路。</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Add one with an end mill to the job, then try again.</source>
        <translation>在作业中添加一个带立铣刀的刀具控制器，然后重试。</translation>
    </message>
    <message>
        <source>{} has no tool controller that can clear a pocket.</source>
        <translation>{} 没有可清除型腔的刀具控制器。</translation>
    </message>
    <message>
        <source>Use as Default in This Job</source>
        <translation>作为此作业的默认值</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Linear Morph</source>
        <translation>线性渐变</translation>
    </message>
    <message>
        <source>Extended Archimedean</source>
        <translation>扩展阿基米德</translation>
    </message>
    <message>
        <source>Isotherm</source>
        <translation>等温线</translation>
    </message>
    <message>
        <source>Central Spiral</source>
        <translation>中心螺线</translation>
    </message>
    <message>
        <source>Climb</source>
        <translation>顺铣</translation>
    </message>
    <message>
        <source>Conventional</source>
        <translation>逆铣</translation>
    </message>
    <message>
        <source>Constant</source>
        <translation>恒定</translation>
    </message>
    <message>
        <source>Linear slow-down</source>
        <translation>线性减速</translation>
    </message>
    <message>
        <source>Chip thickness</source>
        <translation>切屑厚度</translation>
    </message>
    <message>
        <source>Benchtop mill</source>
        <translation>台式铣床</translation>
    </message>
    <message>
        <source>Hobby router</source>
        <translation>业余雕刻机</translation>
    </message>
    <message>
        <source>Huron with Siemens 840D</source>
        <translation>Huron（西门子 840D）</translation>
    </message>
    <message>
        <source>Mikron UCP710</source>
        <translation>Mikron UCP710</translation>
    </message>
    <message>
        <source>Vertical machining center</source>
        <translation>立式加工中心</translation>
    </message>
</context>
<context>
    <name>SpiralPocketMessages</name>
    <message>
        <source>the pocket</source>
        <translation>型腔</translation>
    </message>
    <message>
        <source>feeds</source>
        <translation>进给</translation>
    </message>
    <message>
        <source>horizontal feed</source>
        <translation>水平进给</translation>
    </message>
    <message>
        <source>vertical feed</source>
        <translation>垂直进给</translation>
    </message>
    <message>
        <source>rapid</source>
        <translation>快移</translation>
    </message>
    <message>
        <source>link</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>the path asked for failed its proof</source>
        <translation>所要求的路径未通过验证</translation>
    </message>
    <message>
        <source>the path asked for would leave {0} mm2 standing</source>
        <translation>所要求的路径会残留 {0} mm2</translation>
    </message>
    <message>
        <source>The cutter's diameter</source>
        <translation>刀具直径</translation>
    </message>
    <message>
        <source>The horizontal feed</source>
        <translation>水平进给</translation>
    </message>
    <message>
        <source>The vertical feed</source>
        <translation>垂直进给</translation>
    </message>
    <message>
        <source>The horizontal rapid rate</source>
        <translation>水平快移速度</translation>
    </message>
    <message>
        <source>The vertical rapid rate</source>
        <translation>垂直快移速度</translation>
    </message>
    <message>
        <source>The tolerance</source>
        <translation>公差</translation>
    </message>
    <message>
        <source>XY stock to leave</source>
        <translation>XY 余量</translation>
    </message>
    <message>
        <source>Z stock to leave</source>
        <translation>Z 余量</translation>
    </message>
    <message>
        <source>with {0} mm of stock to leave</source>
        <translation>（余量 {0} mm）</translation>
    </message>
    <message>
        <source>Pocket {0} of {1}: {2}</source>
        <translation>型腔 {0}/{1}：{2}</translation>
    </message>
    <message>
        <source>0.01 mm is usual.</source>
        <translation>通常为 0.01 mm。</translation>
    </message>
    <message>
        <source>A cutter below {0} mm reaches all of them.</source>
        <translation>小于 {0} mm 的刀具可到达所有这些部分。</translation>
    </message>
    <message>
        <source>A cutter below {0} mm reaches it.</source>
        <translation>小于 {0} mm 的刀具可到达。</translation>
    </message>
    <message>
        <source>A cutter below {0} mm reaches {1} of them.</source>
        <translation>小于 {0} mm 的刀具可到达其中 {1} 处。</translation>
    </message>
    <message>
        <source>A depth or height is {0}; it must be a number of millimeters.</source>
        <translation>某个深度或高度为 {0}；它必须是以毫米计的数值。</translation>
    </message>
    <message>
        <source>A helix angle of {0} degrees cannot be cut.</source>
        <translation>无法以 {0} 度的螺旋角切削。</translation>
    </message>
    <message>
        <source>A largest engagement of {0} degrees cannot be cut.</source>
        <translation>无法以 {0} 度的最大啮合角切削。</translation>
    </message>
    <message>
        <source>A smaller StepDown makes them smaller; a finishing operation removes them.</source>
        <translation>减小 StepDown 可使其变小；精加工工序可去除。</translation>
    </message>
    <message>
        <source>A smaller step-over may clear it.</source>
        <translation>较小的步距或可清除。</translation>
    </message>
    <message>
        <source>A step down of {0} mm makes more than {1} levels.</source>
        <translation>每层下刀 {0} mm 会产生超过 {1} 层。</translation>
    </message>
    <message>
        <source>A step down of {0} mm never reaches the floor.</source>
        <translation>下刀步距 {0} mm 永远到不了底。</translation>
    </message>
    <message>
        <source>A step-over of {0} mm is wider than the {1} mm cutter.</source>
        <translation>步距 {0} mm 大于 {1} mm 的刀具。</translation>
    </message>
    <message>
        <source>A step-over of {0} mm never clears the pocket.</source>
        <translation>步距 {0} mm 永远无法清完型腔。</translation>
    </message>
    <message>
        <source>A tolerance of {0} mm is too coarse for this cutter.</source>
        <translation>{0} mm 的公差对该刀具来说太粗。</translation>
    </message>
    <message>
        <source>A {0} move runs through standing stock at {at}, {1} mm in all.</source>
        <translation>在 {at} 处{0}移动穿过残余材料，共 {1} mm。</translation>
    </message>
    <message>
        <source>Above Z{0} also {1} mm2 beside the selected floor are cleared, down to ledges.</source>
        <translation>在 Z{0} 以上,所选底面旁边还有 {1} mm2 会被清除,直至台阶面。</translation>
    </message>
    <message>
        <source>Above the floor the pocket has notches that the {0} mm cutter does not fit, the largest at {at}; these ({1} mm2) stay uncut.</source>
        <translation>底面以上型腔有 {0} mm 刀具进不去的缺口，最大的位于 {at}；这些缺口（{1} mm2）未切除。</translation>
    </message>
    <message>
        <source>Add it; vmc.json shows how.</source>
        <translation>请补上；参见 vmc.json。</translation>
    </message>
    <message>
        <source>Add the part to the job's model.</source>
        <translation>请将零件加入作业的模型。</translation>
    </message>
    <message>
        <source>Another part of the job covers the whole floor; no cutter gets there from above.</source>
        <translation>作业中的另一个零件盖住了整个底面；刀具无法从上方到达。</translation>
    </message>
    <message>
        <source>Another part of the job covers {0} mm2 of the floor; that stays uncut.</source>
        <translation>作业中的另一个零件盖住了 {0} mm2 的底面；该部分不切削。</translation>
    </message>
    <message>
        <source>Another part of the job stands in the pocket or over it; the cutter keeps off that.</source>
        <translation>作业中的另一个零件位于型腔内或其上方；刀具会避开它。</translation>
    </message>
    <message>
        <source>At Z{0} the pocket reaches under a wall.</source>
        <translation>在 Z{0} 处型腔伸到侧壁下方。</translation>
    </message>
    <message>
        <source>At a helix angle of {0} degrees the cutter goes round more than {1} times on its way down.</source>
        <translation>螺旋角为 {0} 度时，刀具下刀要绕 {1} 圈以上。</translation>
    </message>
    <message>
        <source>At {at} the cutter cuts {0} mm into the wall.</source>
        <translation>在 {at} 处刀具切入侧壁 {0} mm。</translation>
    </message>
    <message>
        <source>At {at} the engagement reaches {0} degrees, the step-over of {1} % allows {2}; {3} % of the cut clearly pass that.</source>
        <translation>在 {at} 处啮合角达到 {0} 度，{1} % 的步距允许 {2} 度；{3} % 的切削明显超过该值。</translation>
    </message>
    <message>
        <source>Below Z{0} that part stays uncut.</source>
        <translation>Z{0} 以下该部分未切除。</translation>
    </message>
    <message>
        <source>Below Z{0} the pocket is too narrow and stays uncut.</source>
        <translation>Z{0} 以下型腔过窄，未切除。</translation>
    </message>
    <message>
        <source>Central Spiral cannot go round islands; there is one at {at}.</source>
        <translation>“中心螺线”不能绕过岛屿；{at} 处有一个。</translation>
    </message>
    <message>
        <source>Central Spiral needs a pocket whose whole wall can be seen from one place in its middle; the one at {at} has walls behind corners.</source>
        <translation>“中心螺线”要求从中部一点能看到整个侧壁；{at} 处的型腔有被拐角遮挡的侧壁。</translation>
    </message>
    <message>
        <source>Check the geometry of the part and the job's stock.</source>
        <translation>请检查零件和任务毛坯的几何形状。</translation>
    </message>
    <message>
        <source>Check the outline for tiny steps, or choose a smaller cutter.</source>
        <translation>请检查轮廓中的微小台阶，或选更小的刀具。</translation>
    </message>
    <message>
        <source>Check the part's geometry in the Part workbench and repair the face.</source>
        <translation>在 Part 工作台检查零件几何并修复该面。</translation>
    </message>
    <message>
        <source>Check the part's geometry in the Part workbench.</source>
        <translation>在 Part 工作台检查零件几何。</translation>
    </message>
    <message>
        <source>Checking the pocket</source>
        <translation>检查型腔</translation>
    </message>
    <message>
        <source>Choose a tool controller with an end mill in it.</source>
        <translation>请选择装有立铣刀的刀具控制器。</translation>
    </message>
    <message>
        <source>Choose another strategy, for example Automatic.</source>
        <translation>请选择其他策略，例如“自动”。</translation>
    </message>
    <message>
        <source>Choose one of: {0}.</source>
        <translation>可选：{0}。</translation>
    </message>
    <message>
        <source>Choose one with an end mill in it.</source>
        <translation>请选择装有立铣刀的。</translation>
    </message>
    <message>
        <source>Choose that strategy, or another step-over.</source>
        <translation>请选择该策略，或使用其他步距。</translation>
    </message>
    <message>
        <source>Choose the strategy Automatic or Isotherm for this pocket.</source>
        <translation>此型腔请选用“自动”或“等温线”策略。</translation>
    </message>
    <message>
        <source>Choose your machine in Machine, or lower the feed in the tool controller.</source>
        <translation>请在 Machine 中选择您的机床，或在刀具控制器中降低进给。</translation>
    </message>
    <message>
        <source>Close it first (Part workbench, Check Geometry and Convert to Solid).</source>
        <translation>请先封闭（Part 工作台，检查几何并转换为实体）。</translation>
    </message>
    <message>
        <source>Compare it with vmc.json.</source>
        <translation>请与 vmc.json 对照。</translation>
    </message>
    <message>
        <source>Cut them by a smaller cutter.</source>
        <translation>请用更小的刀具加工。</translation>
    </message>
    <message>
        <source>Do not run this path; check the final depth and the floor stock.</source>
        <translation>不要运行此刀路；请检查最终深度和底面余量。</translation>
    </message>
    <message>
        <source>Do not run this path; try another strategy or step-over.</source>
        <translation>不要运行此刀路；请尝试其他策略或步距。</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Drag it into the job's operations.</source>
        <translation>请将其拖入作业的工序中。</translation>
    </message>
    <message>
        <source>Earlier operations have cleared more than 99 % of this pocket; what this cutter reaches of the rest is cut.</source>
        <translation>先前的操作已清除该型腔的 99 % 以上；其余部分中刀具可及之处将被加工。</translation>
    </message>
    <message>
        <source>Earlier operations have cleared this pocket as far as this cutter reaches.</source>
        <translation>先前的操作已将该型腔清除到此刀具可及之处。</translation>
    </message>
    <message>
        <source>Earlier operations have cleared {0} % of this pocket; what this cutter reaches of the rest is cut.</source>
        <translation>先前的操作已清除该型腔的 {0} %；其余部分中刀具可及之处将被加工。</translation>
    </message>
    <message>
        <source>Finish with a flat end mill where that must be sharp.</source>
        <translation>需要清角的地方请用平底铣刀精加工。</translation>
    </message>
    <message>
        <source>FreeCAD's Adaptive cannot be reached from here.</source>
        <translation>此处无法使用 FreeCAD 自适应。</translation>
    </message>
    <message>
        <source>FreeCAD's Adaptive finds no path in this pocket.</source>
        <translation>FreeCAD 自适应 在此型腔中找不到刀路。</translation>
    </message>
    <message>
        <source>FreeCAD's Adaptive has found no path in this pocket within {0} s.</source>
        <translation>FreeCAD 自适应 在 {0} 秒内未在此型腔中找到刀路。</translation>
    </message>
    <message>
        <source>Give it the number of an end mill, 1 or higher.</source>
        <translation>请给它一个立铣刀的编号，1 或以上。</translation>
    </message>
    <message>
        <source>Install it with FreeCAD's Addon Manager (it is a dependency of Spiral Pocket) or with pip into the Python that FreeCAD uses, then start FreeCAD again.</source>
        <translation>请用 FreeCAD 插件管理器安装（它是 Spiral Pocket 的依赖），或用 pip 装入 FreeCAD 所用的 Python，然后重启 FreeCAD。</translation>
    </message>
    <message>
        <source>Islands on {0} mm2 of the floor are milled away.</source>
        <translation>底面上占 {0} mm2 的岛屿将被铣掉。</translation>
    </message>
    <message>
        <source>Isotherm would need more than {0} laps.</source>
        <translation>“等温线”将需要超过 {0} 圈。</translation>
    </message>
    <message>
        <source>It comes with matplotlib 3.6 or later: install that with FreeCAD's Addon Manager, or choose another strategy.</source>
        <translation>它随 matplotlib 3.6 或更高版本提供：请用 FreeCAD 的插件管理器安装，或选择其他策略。</translation>
    </message>
    <message>
        <source>Its faces are Face1 to Face{0}.</source>
        <translation>其面为 Face1 至 Face{0}。</translation>
    </message>
    <message>
        <source>Keep clamps away from that side, or unset ExtendOpenSides.</source>
        <translation>请让夹具远离该侧，或关闭 ExtendOpenSides。</translation>
    </message>
    <message>
        <source>Laps of Linear Morph would cross themselves at {at}, where the wall turns away from the middle of the pocket.</source>
        <translation>“线性渐变”的圈次会在 {at} 自交，侧壁在该处背离型腔中部。</translation>
    </message>
    <message>
        <source>Laying the spiral</source>
        <translation>生成螺线</translation>
    </message>
    <message>
        <source>Levels are {0} mm deep, the tool's cutting edge is {1} mm long.</source>
        <translation>每层深 {0} mm，刀具的切削刃长 {1} mm。</translation>
    </message>
    <message>
        <source>Linear Morph cannot go round islands; there is one at {at}.</source>
        <translation>“线性渐变”不能绕过岛屿；{at} 处有一个。</translation>
    </message>
    <message>
        <source>Linear Morph finds no middle to start from.</source>
        <translation>“线性渐变”找不到起始中心。</translation>
    </message>
    <message>
        <source>Look what lies under the hole. If it goes on there, select a wall of that.</source>
        <translation>请查看孔下方的情况。如果孔在那里继续，请选择那里的一个侧壁。</translation>
    </message>
    <message>
        <source>Look what lies under the stock, or raise FinalDepth.</source>
        <translation>请检查毛坯下方有什么，或提高 FinalDepth。</translation>
    </message>
    <message>
        <source>Look whether the stock is where it should be.</source>
        <translation>请检查毛坯的位置是否正确。</translation>
    </message>
    <message>
        <source>Lower FinishDepth or raise StepDown.</source>
        <translation>减小 FinishDepth 或增大 StepDown。</translation>
    </message>
    <message>
        <source>Lower StepDown, or take a longer tool.</source>
        <translation>请减小 StepDown，或使用更长的刀具。</translation>
    </message>
    <message>
        <source>Lower StockToLeave.</source>
        <translation>减小 StockToLeave。</translation>
    </message>
    <message>
        <source>Lower Tolerance if the wall must be truer.</source>
        <translation>如果壁面需要更精确,请减小 Tolerance。</translation>
    </message>
    <message>
        <source>Lower ZStockToLeave.</source>
        <translation>减小 ZStockToLeave。</translation>
    </message>
    <message>
        <source>Machine that part from another side, or with an undercutting tool.</source>
        <translation>请从另一侧加工该部分，或用倒扣刀具。</translation>
    </message>
    <message>
        <source>Mend or remove it.</source>
        <translation>请修正或删除。</translation>
    </message>
    <message>
        <source>More than {0} laps are left beside the spirals.</source>
        <translation>螺线旁仍剩超过 {0} 圈。</translation>
    </message>
    <message>
        <source>Move this operation behind the one with the larger end mill, or unset UseRestMachining. Only flat end mills count: round ones leave ridges.</source>
        <translation>请将此操作移到使用大刀具的操作之后，或关闭 UseRestMachining。只有平底立铣刀才算数：圆头刀会留下残脊。</translation>
    </message>
    <message>
        <source>Much the same is told of {0} more pockets (at {1}).</source>
        <translation>另有 {0} 个型腔情况大致相同（位于 {1}）。</translation>
    </message>
    <message>
        <source>Much the same is told of {0} more pockets.</source>
        <translation>另有 {0} 个型腔情况大致相同。</translation>
    </message>
    <message>
        <source>No cutter goes through so narrow a gap; check the model.</source>
        <translation>没有刀具能通过如此窄的缝隙；请检查模型。</translation>
    </message>
    <message>
        <source>No earlier operation has cleared any of this pocket down to its floor; all is cut.</source>
        <translation>没有先前的操作将该型腔清除到底面；将全部加工。</translation>
    </message>
    <message>
        <source>No face is selected.</source>
        <translation>未选择面。</translation>
    </message>
    <message>
        <source>No isotherm leads to the slot.</source>
        <translation>没有等温线通向槽。</translation>
    </message>
    <message>
        <source>Nothing is cut below Z{0}.</source>
        <translation>Z{0} 以下不切削。</translation>
    </message>
    <message>
        <source>Of the step-over of {0} % Automatic uses {1}: wider laps would leave stock where they meet.</source>
        <translation>步距为 {0} %，“自动”只用其中的 {1}：更宽的圈次会在相接处留下余料。</translation>
    </message>
    <message>
        <source>Open the document in that version, or make a new job here.</source>
        <translation>请用该版本打开文档，或在此新建作业。</translation>
    </message>
    <message>
        <source>Other strategies use it whole, and may leave stock.</source>
        <translation>其他策略会使用全部步距，但可能留下余料。</translation>
    </message>
    <message>
        <source>Planning feeds</source>
        <translation>规划进给</translation>
    </message>
    <message>
        <source>Proving the path</source>
        <translation>验证刀路</translation>
    </message>
    <message>
        <source>Put an end mill into the tool controller.</source>
        <translation>请在刀具控制器中放入立铣刀。</translation>
    </message>
    <message>
        <source>Raise FinalDepth or ZStockToLeave if that is not meant.</source>
        <translation>若非本意，请提高 FinalDepth 或 ZStockToLeave。</translation>
    </message>
    <message>
        <source>Raise HelixDiameterLimit.</source>
        <translation>请增大 HelixDiameterLimit。</translation>
    </message>
    <message>
        <source>Raise SafeHeight and ClearanceHeight above the stock.</source>
        <translation>请将 SafeHeight 和 ClearanceHeight 提高到毛坯之上。</translation>
    </message>
    <message>
        <source>Raise SlotBite, or set it to 0 to have it found.</source>
        <translation>请增大 SlotBite，或设为 0 以自动确定。</translation>
    </message>
    <message>
        <source>Raise StartDepth to the top of the stock, or clear it with an operation before.</source>
        <translation>请将 StartDepth 提高到毛坯顶面，或先用其他操作清除。</translation>
    </message>
    <message>
        <source>Raise StepDown.</source>
        <translation>请增大 StepDown。</translation>
    </message>
    <message>
        <source>Raise StockToLeave if that is not meant.</source>
        <translation>若非本意，请提高 StockToLeave。</translation>
    </message>
    <message>
        <source>Recompute the operation to try again.</source>
        <translation>重新计算工序以重试。</translation>
    </message>
    <message>
        <source>Refine the part (Part workbench, Refine Shape), or select one of them.</source>
        <translation>请精炼零件（Part 工作台，精炼形状），或只选其中一个。</translation>
    </message>
    <message>
        <source>Remove it from the base geometry and select the floor of the pocket again.</source>
        <translation>请从基础几何中移除它，并重新选择型腔底面。</translation>
    </message>
    <message>
        <source>Repair the part (Part workbench, Check Geometry).</source>
        <translation>请修复零件（Part 工作台，检查几何）。</translation>
    </message>
    <message>
        <source>Repairing the path</source>
        <translation>修复刀路</translation>
    </message>
    <message>
        <source>Select a face of the job's model, or add that part to it.</source>
        <translation>请选择作业模型的面，或将该零件加入模型。</translation>
    </message>
    <message>
        <source>Select all faces that make the floor, or refine the part.</source>
        <translation>请选择构成底面的所有面，或精炼零件。</translation>
    </message>
    <message>
        <source>Select the floor face of the pocket.</source>
        <translation>请选择型腔底面。</translation>
    </message>
    <message>
        <source>Select the floor of the pocket, a flat level face with walls around it, or a wall of a hole through the part that ends at one level face below.</source>
        <translation>请选择型腔的底面（四周有侧壁的水平平面），或通孔的一个侧壁（该孔下端须止于同一水平面）。</translation>
    </message>
    <message>
        <source>Select the floor of the pocket, or turn the part over.</source>
        <translation>请选择型腔底面，或翻转零件。</translation>
    </message>
    <message>
        <source>Set ClearanceHeight above SafeHeight above StartDepth.</source>
        <translation>使 ClearanceHeight 高于 SafeHeight，SafeHeight 高于 StartDepth。</translation>
    </message>
    <message>
        <source>Set ExtendOpenSides, or clear that side with another operation.</source>
        <translation>请启用 ExtendOpenSides，或用其他操作清除该侧。</translation>
    </message>
    <message>
        <source>Set HelixAngle above 0 and below 90 degrees; 5 is usual.</source>
        <translation>请将 HelixAngle 设为大于 0 且小于 90 度；通常为 5。</translation>
    </message>
    <message>
        <source>Set HelixAngle above {0} degrees; 5 is usual.</source>
        <translation>请将 HelixAngle 设为大于 {0} 度；通常为 5。</translation>
    </message>
    <message>
        <source>Set HelixDiameterLimit to 0 for no limit.</source>
        <translation>将 HelixDiameterLimit 设为 0 表示不限制。</translation>
    </message>
    <message>
        <source>Set LinkFeed to 0 for the horizontal rapid rate.</source>
        <translation>将 LinkFeed 设为 0 表示水平快移速度。</translation>
    </message>
    <message>
        <source>Set MaxEngagement up to {0} degrees, or to 0 for StepOver's.</source>
        <translation>将 MaxEngagement 设为不超过 {0} 度，或设 0 采用 StepOver。</translation>
    </message>
    <message>
        <source>Set MaxFeedRatio to 1 or more; 2 is usual.</source>
        <translation>将 MaxFeedRatio 设为 1 或以上；通常为 2。</translation>
    </message>
    <message>
        <source>Set SlotBite to 0 to have it found.</source>
        <translation>请将 SlotBite 设为 0 以自动确定。</translation>
    </message>
    <message>
        <source>Set SlowdownPercent between 1 and 100; 75 is usual.</source>
        <translation>将 SlowdownPercent 设在 1 到 100 之间；通常为 75。</translation>
    </message>
    <message>
        <source>Set StartDepth above FinalDepth.</source>
        <translation>将 StartDepth 设在 FinalDepth 之上。</translation>
    </message>
    <message>
        <source>Set StartPoint inside one, or do without.</source>
        <translation>将 StartPoint 设在某个型腔内，或不使用起点。</translation>
    </message>
    <message>
        <source>Set StartPoint where a helix has room, or near the slot along the wall.</source>
        <translation>请将 StartPoint 设在可容纳螺旋进刀之处，或靠近沿壁的槽。</translation>
    </message>
    <message>
        <source>Set StartPoint, or do without.</source>
        <translation>设置 StartPoint，或不使用起点。</translation>
    </message>
    <message>
        <source>Set StepDown above 0.</source>
        <translation>将 StepDown 设为大于 0。</translation>
    </message>
    <message>
        <source>Set StepOver above 0; 20 to 45 % of the cutter's diameter is usual.</source>
        <translation>将 StepOver 设为大于 0；通常为刀具直径的 20 至 45 %。</translation>
    </message>
    <message>
        <source>Set StepOver to 100 % or less.</source>
        <translation>将 StepOver 设为 100 % 或以下。</translation>
    </message>
    <message>
        <source>Set StepOver to {0}, or a smaller one.</source>
        <translation>请将 StepOver 设为 {0} 或更小。</translation>
    </message>
    <message>
        <source>Set Tolerance to at most {0} mm.</source>
        <translation>请将 Tolerance 设为至多 {0} mm。</translation>
    </message>
    <message>
        <source>Set all depths and heights.</source>
        <translation>请设置所有深度和高度。</translation>
    </message>
    <message>
        <source>Set it in the tool controller, unless you start the spindle by hand.</source>
        <translation>请在刀具控制器中设置，除非您手动启动主轴。</translation>
    </message>
    <message>
        <source>Set it in the tool of the tool controller.</source>
        <translation>请在刀具控制器的刀具中设置。</translation>
    </message>
    <message>
        <source>Set it to 0 for none.</source>
        <translation>设为 0 表示无。</translation>
    </message>
    <message>
        <source>Set one up in the job's editor.</source>
        <translation>请在任务编辑器中设置毛坯。</translation>
    </message>
    <message>
        <source>Set the feeds in the tool controller.</source>
        <translation>请在刀具控制器中设置进给。</translation>
    </message>
    <message>
        <source>Set the horizontal and vertical feed in the tool controller.</source>
        <translation>请在刀具控制器中设置水平和垂直进给。</translation>
    </message>
    <message>
        <source>Set the spindle's direction in the tool controller or the tool, or the other CutMode.</source>
        <translation>请在刀具控制器或刀具中将主轴设为正转，或设置另一种 CutMode。</translation>
    </message>
    <message>
        <source>Set the spindle's direction there, or in the tool, unless you start it by hand.</source>
        <translation>请在那里或在刀具中设置主轴转向，除非您手动启动主轴。</translation>
    </message>
    <message>
        <source>Spiral Pocket needs shapely 2, this FreeCAD has {0}.</source>
        <translation>Spiral Pocket 需要 shapely 2，当前 FreeCAD 为 {0}。</translation>
    </message>
    <message>
        <source>Spiral Pocket needs the Python library {0}, which this FreeCAD lacks.</source>
        <translation>Spiral Pocket 需要 Python 库 {0}，当前 FreeCAD 缺少它。</translation>
    </message>
    <message>
        <source>Stopped by the user.</source>
        <translation>已被用户停止。</translation>
    </message>
    <message>
        <source>Take a cutter below {0} mm.</source>
        <translation>请用小于 {0} mm 的刀具。</translation>
    </message>
    <message>
        <source>Take a larger step-over or the strategy Automatic.</source>
        <translation>请用更大的步距或“自动”策略。</translation>
    </message>
    <message>
        <source>Take a longer tool; its holder would strike the part.</source>
        <translation>请换用更长的刀具;否则刀柄会撞到零件。</translation>
    </message>
    <message>
        <source>Take a lower feed or a smaller SlotBite if that is too heavy for the cutter.</source>
        <translation>若对刀具负荷过大，请降低进给或减小 SlotBite。</translation>
    </message>
    <message>
        <source>Take a smaller cutter or the strategy Automatic.</source>
        <translation>请用更小的刀具或“自动”策略。</translation>
    </message>
    <message>
        <source>Take a smaller cutter.</source>
        <translation>请用更小的刀具。</translation>
    </message>
    <message>
        <source>Take a smaller cutter; a hole as wide as the cutter is one for FreeCAD's Drilling.</source>
        <translation>请换用更小的铣刀;与铣刀等宽的孔应使用 FreeCAD 的钻孔。</translation>
    </message>
    <message>
        <source>Take a smaller cutter; a slot as wide as the cutter is one for FreeCAD's Slot.</source>
        <translation>请选用更小的刀具;与刀具同宽的槽请用 FreeCAD 的 Slot 操作。</translation>
    </message>
    <message>
        <source>Take a wider cutter or a larger step-over.</source>
        <translation>请用更大的刀具或步距。</translation>
    </message>
    <message>
        <source>Take that part out of the job's model if it is not there when the pocket is cut.</source>
        <translation>如果切削型腔时该零件不在那里，请将其从作业模型中移除。</translation>
    </message>
    <message>
        <source>Take that part out of the job's model.</source>
        <translation>请将该零件从作业模型中移除。</translation>
    </message>
    <message>
        <source>That part stays uncut.</source>
        <translation>该部分未切除。</translation>
    </message>
    <message>
        <source>The cutter goes down at {at}, {0} mm from the start point: that is as near as {1} can begin.</source>
        <translation>刀具在 {at} 处下刀，距起点 {0} mm：{1} 无法在更近处开始。</translation>
    </message>
    <message>
        <source>The cutter goes {0} mm below the floor.</source>
        <translation>刀具低于底面 {0} mm。</translation>
    </message>
    <message>
        <source>The cutter goes {0} mm below the selected floor, {1} mm of that below the stock.</source>
        <translation>刀具低于所选底面 {0} mm，其中 {1} mm 在毛坯以下。</translation>
    </message>
    <message>
        <source>The cutter goes {0} mm below the selected floor.</source>
        <translation>刀具低于所选底面 {0} mm。</translation>
    </message>
    <message>
        <source>The cutter goes {0} mm below the top of the stock, the tool is {1} mm long.</source>
        <translation>铣刀下到毛坯顶面以下 {0} mm,而刀具长 {1} mm。</translation>
    </message>
    <message>
        <source>The cutter goes {0} mm into the walls.</source>
        <translation>刀具切入侧壁 {0} mm。</translation>
    </message>
    <message>
        <source>The cutter has no room to go down anywhere in the pocket.</source>
        <translation>刀具在型腔内无处下刀。</translation>
    </message>
    <message>
        <source>The depths are upside down: the pocket's floor (final depth {0} mm) is not below its top (start depth {1} mm).</source>
        <translation>深度颠倒：型腔底（最终深度 {0} mm）不低于顶（起始深度 {1} mm）。</translation>
    </message>
    <message>
        <source>The expression of {0} cannot be evaluated: {1}.</source>
        <translation>{0} 的表达式无法求值：{1}。</translation>
    </message>
    <message>
        <source>The feed is lowered there; take a lower one if that is too heavy for the cutter.</source>
        <translation>该处已降低进给；若对刀具仍过重，请采用更低的进给。</translation>
    </message>
    <message>
        <source>The finish depth of {0} mm is not between 0 and the step down of {1} mm.</source>
        <translation>精加工深度 {0} mm 不在 0 与下刀步距 {1} mm 之间。</translation>
    </message>
    <message>
        <source>The fit of {0} patches has no solution.</source>
        <translation>{0} 段曲线的拟合无解。</translation>
    </message>
    <message>
        <source>The floor goes on beyond what is selected; that stays.</source>
        <translation>底面延伸到所选范围之外；那部分不加工。</translation>
    </message>
    <message>
        <source>The heights are upside down: clearance {0} mm, safe {1} mm, start depth {2} mm.</source>
        <translation>高度颠倒：间隙高度 {0} mm，安全高度 {1} mm，起始深度 {2} mm。</translation>
    </message>
    <message>
        <source>The helix's diameter limit is negative.</source>
        <translation>螺旋直径上限为负。</translation>
    </message>
    <message>
        <source>The hole ends at Z{0}, the part goes down to Z{1}; the cutter goes down to Z{2}.</source>
        <translation>该孔止于 Z{0}，而零件延伸至 Z{1}；刀具下到 Z{2}。</translation>
    </message>
    <message>
        <source>The horizontal feed of {0} mm/min is more than the chosen machine does; the program runs at {1} mm/min.</source>
        <translation>水平进给 {0} mm/min 超出所选机床的能力；程序以 {1} mm/min 运行。</translation>
    </message>
    <message>
        <source>The largest feed ratio of {0} is below 1.</source>
        <translation>最大进给倍率 {0} 小于 1。</translation>
    </message>
    <message>
        <source>The level from Z{0} to Z{1} is not between 0 and the step down of {2} mm deep.</source>
        <translation>从 Z{0} 到 Z{1} 的层深不在 0 与下刀步距 {2} mm 之间。</translation>
    </message>
    <message>
        <source>The link feed is negative.</source>
        <translation>连接进给为负。</translation>
    </message>
    <message>
        <source>The lowest level, at Z{0}, is not the pocket's floor.</source>
        <translation>最低层 Z{0} 不是型腔底面。</translation>
    </message>
    <message>
        <source>The machine file {0} cannot be read: {1}.</source>
        <translation>无法读取机床文件 {0}：{1}。</translation>
    </message>
    <message>
        <source>The machine file {0} is broken: {1}.</source>
        <translation>机床文件 {0} 损坏：{1}。</translation>
    </message>
    <message>
        <source>The machine file {0} lacks {1}.</source>
        <translation>机床文件 {0} 缺少 {1}。</translation>
    </message>
    <message>
        <source>The outline of {0} crosses itself.</source>
        <translation>{0} 的轮廓自交。</translation>
    </message>
    <message>
        <source>The outline of {0} has points at infinity.</source>
        <translation>轮廓（{0}）含有无穷远的点。</translation>
    </message>
    <message>
        <source>The outline of {0} is broken ({1}).</source>
        <translation>轮廓（{0}）已损坏（{1}）。</translation>
    </message>
    <message>
        <source>The outline of {0} is not closed at X{1} Y{2}.</source>
        <translation>{0} 的轮廓在 X{1} Y{2} 处未闭合。</translation>
    </message>
    <message>
        <source>The part overhangs the whole floor; no cutter gets there from above.</source>
        <translation>零件遮住整个底面；刀具无法从上方到达。</translation>
    </message>
    <message>
        <source>The part with {0} is an open shell, not a closed solid.</source>
        <translation>含 {0} 的零件是开放壳体，不是封闭实体。</translation>
    </message>
    <message>
        <source>The path was made, but at {at} would cut {0} mm into a wall or the floor; it is not handed out.</source>
        <translation>路径已生成，但在 {at} 处会切入壁面或底面 {0} mm；不予输出。</translation>
    </message>
    <message>
        <source>The path was made, but at {at} would run {0} mm through standing stock where it should not cut; it is not handed out.</source>
        <translation>刀路已生成，但在 {at} 处会在不应切削的地方穿过 {0} mm 残余材料；不予输出。</translation>
    </message>
    <message>
        <source>The plate has several summits.</source>
        <translation>板上有多个峰。</translation>
    </message>
    <message>
        <source>The pocket at {at} is cut by {0} instead of {1}: {2}.</source>
        <translation>{at} 处的型腔改用 {0} 而非 {1} 切削：{2}。</translation>
    </message>
    <message>
        <source>The pocket at {at} is cut with a step-over of {0} mm instead of {1} mm: {2}.</source>
        <translation>{at} 处的型腔以 {0} mm 而非 {1} mm 的步距切削：{2}。</translation>
    </message>
    <message>
        <source>The pocket has no area.</source>
        <translation>型腔没有面积。</translation>
    </message>
    <message>
        <source>The pocket is more than {0} step-overs wide.</source>
        <translation>型腔宽度超过 {0} 个步距。</translation>
    </message>
    <message>
        <source>The pocket is no wider than the {0} mm cutter{1}, at {at}.</source>
        <translation>型腔不比 {0} mm 铣刀{1}宽,位于 {at}。</translation>
    </message>
    <message>
        <source>The pocket is open at a side; the cutter runs out of it there.</source>
        <translation>型腔有一侧开放；刀具会从那里驶出。</translation>
    </message>
    <message>
        <source>The pocket is open at a side; the cutter stays within the floor there.</source>
        <translation>型腔一侧敞开；刀具在该处不超出底面。</translation>
    </message>
    <message>
        <source>The pocket is too narrow at {at} for Isotherm: no isotherm leads through.</source>
        <translation>型腔在 {at} 处对“等温线”过窄：没有等温线通过。</translation>
    </message>
    <message>
        <source>The pocket lies beside the stock.</source>
        <translation>型腔位于毛坯之外。</translation>
    </message>
    <message>
        <source>The pocket's outline has points at infinity.</source>
        <translation>型腔轮廓含无穷远点。</translation>
    </message>
    <message>
        <source>The pocket's outline is broken ({0}).</source>
        <translation>型腔轮廓损坏（{0}）。</translation>
    </message>
    <message>
        <source>The pocket's wall near {at} is too jagged or too narrow for Linear Morph.</source>
        <translation>{at} 附近的型腔侧壁对“线性渐变”过于参差或过窄。</translation>
    </message>
    <message>
        <source>The selected floor lies {0} mm above the stock.</source>
        <translation>所选底面在毛坯以上 {0} mm。</translation>
    </message>
    <message>
        <source>The selected floor lies {0} mm below the stock.</source>
        <translation>所选底面在毛坯以下 {0} mm。</translation>
    </message>
    <message>
        <source>The slot bite is negative.</source>
        <translation>槽的切深为负。</translation>
    </message>
    <message>
        <source>The slowed feed of {0} percent is not between 0 and 100 percent.</source>
        <translation>减速进给 {0} % 不在 0 到 100 % 之间。</translation>
    </message>
    <message>
        <source>The spindle runs in reverse; what CutMode calls climb is conventional then.</source>
        <translation>主轴反转；CutMode 所称的顺铣此时为逆铣。</translation>
    </message>
    <message>
        <source>The spindle speed of {0} is 0; the program does not start it.</source>
        <translation>{0} 的主轴转速为 0；程序不会启动主轴。</translation>
    </message>
    <message>
        <source>The start point at {at} lies in none of the pockets.</source>
        <translation>起点 {at} 不在任何型腔内。</translation>
    </message>
    <message>
        <source>The start point is not a place.</source>
        <translation>起点不是有效位置。</translation>
    </message>
    <message>
        <source>The stock reaches {0} mm above the height at which rapids go over it.</source>
        <translation>毛坯比快速移动的高度高出 {0} mm。</translation>
    </message>
    <message>
        <source>The stock reaches {0} mm above the start depth; the cutter goes down through that without ramping.</source>
        <translation>毛坯高出起始深度 {0} mm；刀具将不走斜坡直接穿过。</translation>
    </message>
    <message>
        <source>The strategy Automatic begins anywhere with room for a helix.</source>
        <translation>“自动”策略可在任何能容纳螺旋下刀的位置开始。</translation>
    </message>
    <message>
        <source>The wall at {at} cannot be cut at Z{0}: {1}.</source>
        <translation>{at} 处的侧壁无法在 Z{0} 剖切：{1}。</translation>
    </message>
    <message>
        <source>The wall of the pocket about {at} is too jagged for Central Spiral.</source>
        <translation>{at} 附近的型腔侧壁过于参差，不适用“中心螺线”。</translation>
    </message>
    <message>
        <source>The walls' outline at Z{0} is not closed at {at}.</source>
        <translation>Z{0} 处壁面的轮廓在 {at} 未闭合。</translation>
    </message>
    <message>
        <source>The {0} is not a number.</source>
        <translation>{0} 不是数字。</translation>
    </message>
    <message>
        <source>The {0} mm cutter does not fit the pocket{1}: it is {2} mm wide at its widest, at {at}.</source>
        <translation>{0} mm 刀具放不进型腔{1}：最宽处在 {at}，仅 {2} mm。</translation>
    </message>
    <message>
        <source>The {0} mm cutter does not fit the room at {at}, {1} mm wide at its widest; that part ({2} mm2) stays uncut.</source>
        <translation>{0} mm 刀具进不了 {at} 处的区域（最宽处 {1} mm）；该部分（{2} mm2）未切除。</translation>
    </message>
    <message>
        <source>The {0} mm cutter does not fit the {1} mm neck at {at}; that part ({2} mm2) stays uncut.</source>
        <translation>{0} mm 刀具通不过 {at} 处 {1} mm 的窄颈；该部分（{2} mm2）未切除。</translation>
    </message>
    <message>
        <source>The {0} mm cutter does not fit {1} necks, up to {2} mm wide, the widest at {at}; these parts ({3} mm2) stay uncut.</source>
        <translation>{0} mm 刀具通不过 {1} 处窄颈（最宽 {2} mm，位于 {at}）；这些部分（{3} mm2）未切除。</translation>
    </message>
    <message>
        <source>The {0} mm cutter does not fit {1} rooms, up to {2} mm wide, the widest at {at}; these ({3} mm2) stay uncut.</source>
        <translation>{0} mm 刀具进不了 {1} 处区域（最宽 {2} mm，位于 {at}）；这些区域（{3} mm2）未切除。</translation>
    </message>
    <message>
        <source>The {0} mm cutter fits the pocket, but has no room for its helix at {at} (circle of {1} mm).</source>
        <translation>{0} mm 刀具可进入型腔，但在 {at} 处没有螺旋下刀空间（圆 {1} mm）。</translation>
    </message>
    <message>
        <source>There is no machine '{0}'.</source>
        <translation>没有机床 '{0}'。</translation>
    </message>
    <message>
        <source>This FreeCAD cannot read {0}, which another version has saved.</source>
        <translation>此 FreeCAD 无法读取由其他版本保存的 {0}。</translation>
    </message>
    <message>
        <source>This pocket is not cut.</source>
        <translation>此型腔不切削。</translation>
    </message>
    <message>
        <source>Try another step-over or strategy, and please report this pocket.</source>
        <translation>请尝试其他步距或策略，并报告此型腔。</translation>
    </message>
    <message>
        <source>Turn the part over, or machine it from another side.</source>
        <translation>请翻转零件，或从另一侧加工。</translation>
    </message>
    <message>
        <source>Unset UseOutline if they shall stand.</source>
        <translation>若要保留它们，请关闭 UseOutline。</translation>
    </message>
    <message>
        <source>Unset UseRestMachining to cut it all the same.</source>
        <translation>若仍要加工，请关闭 UseRestMachining。</translation>
    </message>
    <message>
        <source>Use a flat end mill, or finish the floor with one.</source>
        <translation>请用平底立铣刀，或用其精加工底面。</translation>
    </message>
    <message>
        <source>Walls lean over the floor; {0} mm2 of it below them stay uncut.</source>
        <translation>侧壁向底面倾斜；其下方 {0} mm2 未切除。</translation>
    </message>
    <message>
        <source>Walls that are not vertical keep steps up to {0} mm wide and {1} mm high, the widest at {at}.</source>
        <translation>非垂直侧壁留有最宽 {0} mm、最高 {1} mm 的台阶，最宽处在 {at}。</translation>
    </message>
    <message>
        <source>Where that is done already, lower StartDepth or set UseRestMachining.</source>
        <translation>如果那里已经加工过,请降低 StartDepth 或启用 UseRestMachining。</translation>
    </message>
    <message>
        <source>With a slot bite of {0} mm a slot has more than {1} levels.</source>
        <translation>槽的切深为 {0} mm 时，槽会超过 {1} 层。</translation>
    </message>
    <message>
        <source>With {0} mm of stock to leave on the floor nothing is left to cut.</source>
        <translation>底面余量 {0} mm，已无可切材料。</translation>
    </message>
    <message>
        <source>{0} does not start the spindle.</source>
        <translation>{0} 不会启动主轴。</translation>
    </message>
    <message>
        <source>{0} has no face {1}.</source>
        <translation>{0} 没有面 {1}。</translation>
    </message>
    <message>
        <source>{0} has no model.</source>
        <translation>{0} 没有模型。</translation>
    </message>
    <message>
        <source>{0} has no stock.</source>
        <translation>{0} 没有毛坯。</translation>
    </message>
    <message>
        <source>{0} has no tool controller.</source>
        <translation>{0} 没有刀具控制器。</translation>
    </message>
    <message>
        <source>{0} has no tool, or one without a diameter.</source>
        <translation>{0} 没有刀具，或刀具没有直径。</translation>
    </message>
    <message>
        <source>{0} has no {1}; the path carries no feeds and its time is unknown.</source>
        <translation>{0} 没有设置{1}；刀路不含进给，时间未知。</translation>
    </message>
    <message>
        <source>{0} has tool number 0, which stands for no tool.</source>
        <translation>{0} 的刀具号为 0，表示无刀具。</translation>
    </message>
    <message>
        <source>{0} is not a face.</source>
        <translation>{0} 不是面。</translation>
    </message>
    <message>
        <source>{0} is not an end mill; it cannot clear a pocket.</source>
        <translation>{0} 不是立铣刀，不能清除型腔。</translation>
    </message>
    <message>
        <source>{0} is not flat at its end and leaves ridges on the floor.</source>
        <translation>{0} 端部不平，会在底面留下残脊。</translation>
    </message>
    <message>
        <source>{0} is not flat.</source>
        <translation>{0} 不是平面。</translation>
    </message>
    <message>
        <source>{0} is not in a job.</source>
        <translation>{0} 不在任何作业中。</translation>
    </message>
    <message>
        <source>{0} is not in the job's model.</source>
        <translation>{0} 不在作业的模型中。</translation>
    </message>
    <message>
        <source>{0} is not level.</source>
        <translation>{0} 不水平。</translation>
    </message>
    <message>
        <source>{0} is not the floor of a pocket: no wall rises from it.</source>
        <translation>{0} 不是型腔底面：没有侧壁从其升起。</translation>
    </message>
    <message>
        <source>{0} is not there any more: the model has changed.</source>
        <translation>{0} 已不存在：模型已更改。</translation>
    </message>
    <message>
        <source>{0} is vertical: it is a wall, not a floor.</source>
        <translation>{0} 是垂直的：是侧壁而非底面。</translation>
    </message>
    <message>
        <source>{0} is {1}; it must be more than 0.</source>
        <translation>{0} 为 {1}；必须大于 0。</translation>
    </message>
    <message>
        <source>{0} leaves the radius of its corner, {1} mm, at the foot of walls.</source>
        <translation>{0} 会在侧壁底部留下其圆角半径 {1} mm。</translation>
    </message>
    <message>
        <source>{0} looks down.</source>
        <translation>{0} 朝下。</translation>
    </message>
    <message>
        <source>{0} meet, but do not make one floor.</source>
        <translation>{0} 相接，但不构成同一底面。</translation>
    </message>
    <message>
        <source>{0} mm2 of the floor stay uncut, the largest part at {at}.</source>
        <translation>底面有 {0} mm2 未切除，最大一块在 {at}。</translation>
    </message>
    <message>
        <source>{0} mm2 of the pocket lie beside the stock, at {at}.</source>
        <translation>型腔有 {0} mm2 位于毛坯之外,在 {at}。</translation>
    </message>
</context>
<context>
    <name>SpiralPocketPanel</name>
    <message>
        <source>Tool controller</source>
        <translation>刀具控制器</translation>
    </message>
    <message>
        <source>The tool and its feeds and speed</source>
        <translation>刀具及其进给和转速</translation>
    </message>
    <message>
        <source>Coolant</source>
        <translation>冷却液</translation>
    </message>
    <message>
        <source>The coolant of this operation</source>
        <translation>此工序的冷却方式</translation>
    </message>
    <message>
        <source>Show feeds, speed and tool here, to change them for all operations with this tool controller</source>
        <translation>在此显示进给、转速和刀具，可为使用此刀具控制器的所有工序进行更改</translation>
    </message>
    <message>
        <source>Edit Tool Controller</source>
        <translation>编辑刀具控制器</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>策略</translation>
    </message>
    <message>
        <source>Step over percent</source>
        <translation>步距百分比</translation>
    </message>
    <message>
        <source>Step over</source>
        <translation>步距</translation>
    </message>
    <message>
        <source>Engagement angle</source>
        <translation>啮合角</translation>
    </message>
    <message>
        <source>Cut mode</source>
        <translation>铣削方式</translation>
    </message>
    <message>
        <source>XY stock to leave</source>
        <translation>XY 余量</translation>
    </message>
    <message>
        <source>Z stock to leave</source>
        <translation>Z 余量</translation>
    </message>
    <message>
        <source>Helix ramp angle</source>
        <translation>螺旋下刀角度</translation>
    </message>
    <message>
        <source>Helix max diameter</source>
        <translation>螺旋最大直径</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>机床</translation>
    </message>
    <message>
        <source>Feed mode</source>
        <translation>进给方式</translation>
    </message>
    <message>
        <source>Slow-down percent</source>
        <translation>减速百分比</translation>
    </message>
    <message>
        <source>Max feed ratio</source>
        <translation>最大进给倍率</translation>
    </message>
    <message>
        <source>Finishing profile</source>
        <translation>精加工轮廓</translation>
    </message>
    <message>
        <source>Ignore islands</source>
        <translation>忽略岛屿</translation>
    </message>
    <message>
        <source>Show options that are rarely needed</source>
        <translation>显示很少用到的选项</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>高级</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>公差</translation>
    </message>
    <message>
        <source>Link feed</source>
        <translation>连接进给</translation>
    </message>
    <message>
        <source>Slot bite</source>
        <translation>开槽切深</translation>
    </message>
    <message>
        <source>Extend open sides</source>
        <translation>延伸开放侧</translation>
    </message>
    <message>
        <source>Use rest machining</source>
        <translation>使用残料加工</translation>
    </message>
    <message>
        <source>Use start point</source>
        <translation>使用起点</translation>
    </message>
    <message>
        <source>Start point X</source>
        <translation>起点 X</translation>
    </message>
    <message>
        <source>Start point Y</source>
        <translation>起点 Y</translation>
    </message>
    <message>
        <source>Take the place that was clicked on the part</source>
        <translation>采用在零件上点击的位置</translation>
    </message>
    <message>
        <source>From selection</source>
        <translation>取自选择</translation>
    </message>
</context>
<context>
    <name>SpiralPocketPreferences</name>
    <message>
        <source>Spiral Pocket</source>
        <translation>螺旋型腔</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>机床</translation>
    </message>
    <message>
        <source>Folder with own machines</source>
        <translation>自有机床文件夹</translation>
    </message>
    <message>
        <source>Machine files (JSON) in this folder are offered besides those of the add-on; after the next start</source>
        <translation>除插件自带的机床外，还提供此文件夹中的机床文件 (JSON)；下次启动后生效</translation>
    </message>
    <message>
        <source>Defaults of new operations</source>
        <translation>新建工序的默认值</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>策略</translation>
    </message>
    <message>
        <source>Step over percent</source>
        <translation>步距百分比</translation>
    </message>
    <message>
        <source>Cut mode</source>
        <translation>铣削方式</translation>
    </message>
    <message>
        <source>Helix ramp angle</source>
        <translation>螺旋下刀角度</translation>
    </message>
    <message>
        <source>Feed mode</source>
        <translation>进给方式</translation>
    </message>
    <message>
        <source>Slow-down percent</source>
        <translation>减速百分比</translation>
    </message>
    <message>
        <source>Max feed ratio</source>
        <translation>最大进给倍率</translation>
    </message>
    <message>
        <source>Link feed</source>
        <translation>连接进给</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>公差</translation>
    </message>
</context>
<context>
    <name>SpiralPocket_Create</name>
    <message>
        <source>Spiral Pocket</source>
        <translation>螺旋型腔</translation>
    </message>
    <message>
        <source>Clears the pockets above the selected floors with one smooth spiral each</source>
        <translation>以光顺螺线清除所选底面上方的型腔</translation>
    </message>
</context>
</TS>
