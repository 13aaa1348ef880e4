# $n = 4
# $rays = 3
# $control = 4
# $check = 4
# $bars = 2
simulation-too_few_points = Simulation: only { $n } points have { $rays } rays.
    .why = It needs points for { $control } control points, { $check } check points and { $bars } scale bars (two each).
    .do = Add points or stations, or move the stations nearer.

# $block = "facade"
# $image = "left.jpg"
# $point = "P1"
# $n = 4
# $total = 900
simulation-point_not_visible = Block { $block }: photograph { $image } cannot show point { $point } from its station.
    .why = This concerns { $n } of { $total } image points.
    .do = Adjust the block first.

# $block = "pair"
simulation-has_scenes = Block { $block } has satellite scenes; only photographs can be simulated.
    .do = Use a block without scenes.

# $block = "facade"
# $point = "P1"
simulation-point_unknown = Block { $block }: point { $point } has no coordinates.
    .do = Adjust the block first.

# $block = "facade"
# $point = "P1"
simulation-control_without_sigma = Block { $block }: control point { $point } has no standard deviation.
    .do = Add sX, sY and sZ.

# $n = 7
# $known = [4, 5, 9]
simulation-control_layout = There is no layout of { $n } control points.
    .do = Give one of { LIST($known, most: 20) }: { OPTION("control_points") }.

# $n = 1
# $total = 40
# $least = 12
# $across_m = [80.0, 60.0]
# $spacing_m = 200.0
# $width_m = 800.0
# $length_m = 900.0
# $base_m = 20.0
# $lines_m = 40.0
simulation-too_few_photographs = { $n } of { $total } photographs of the flight show { $least } tie points; two photographs are needed.
    .why = A photograph covers { $across_m } m; tie points are { $spacing_m } m apart over { $width_m } x { $length_m } m, photographs { $base_m } m, lines { $lines_m } m.
    .do = Adapt { OPTION("height") }, { OPTION("base") }, { OPTION("line_spacing") }, { OPTION("ground") }, { OPTION("tie_points") } or { OPTION("jitter") }.

# $name = "tower"
# $known = ["box", "facade"]
simulation-unknown_scene = { $name } is neither a scene nor the folder of a plan or a block.
    .do = Give one of { LIST($known, most: 20) }, or such a folder.

# $setting = "check_points"
# $folder = "plan"
simulation-setting_of_scenes = { OPTION($setting) } belongs to scenes; { $folder } has its own control and scale bars.
    .do = Leave it out, or plan with it.
