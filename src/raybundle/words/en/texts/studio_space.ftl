studio_space-no_graphics = This browser shows no 3D graphics (WebGL is switched off).
    .why = Tables and images contain the same points.

studio_space-canvas = Object space: arrow keys turn, + and - zoom, 0 shows all

studio_space-click = Click a point to choose it, a station to open its image.

studio_space-click_points = Click the points to measure.

# $n = 1000000
# $of = 1200000
studio_space-points_shown = { $n } of { $of } points are shown.

# $n = 12
studio_space-beyond = beyond the limit: { $n }

# $name = "t17"
# $n = 3
# $sigma = "0.2 mm"
# $w = "1.2"
studio_space-point = { $name ->
        [none] Point
        *[other] { $name }
    }: { $n } { $n ->
        [one] ray
        *[other] rays
    }{ $sigma ->
        [none] {""}
        *[other] , sigma { $sigma }
    }{ $w ->
        [none] {""}
        *[other] , |w| { $w }
    }

studio_space-colour = colour

# $by = "w"
studio_space-colouring = { $by ->
        [role] role
        [rays] rays
        [sigma] sigma
        [w] largest |w|
        [redundancy] redundancy number
        *[residual] residual
    }

# $by = "w"
# $limit = "1"
studio_space-up_to = { $by ->
        [w] |w|
        [redundancy] smallest redundancy number
        [residual] residual (rms)
        *[sigma] sigma
    } ≤ { $limit }

studio_space-few_rays = 2 rays or fewer

studio_space-unknown = unknown

# $role = "tie"
studio_space-role = { $role ->
        [control] control points
        [check] check points
        *[tie] tie points
    }

# $name = "bars"
studio_space-shown = { $name ->
        [points] points
        [stations] stations
        [bars] scale bars
        *[ellipsoids] ellipsoids
    }

studio_space-enlargement = Enlargement of the error ellipsoids

studio_space-all = All
    .title = Show all (0)

studio_space-measure = measure
    .title = Click points: 2 give a distance, 3 an angle, more an area

studio_space-measured = Quantity

# $kind = "distance"
studio_space-quantity = { $kind ->
        [coordinates] coordinates
        [distance] distance
        [angle] angle
        [area] area
        [length] length of a polyline
        [plane] flatness
        [line] straightness
        [to_plane] first point to a plane
        [to_line] first point to a line
        *[any] by number of points
    }

studio_space-add_current = Add current point
    .title = Measure to the current point, too

studio_space-clear = Clear
    .title = Begin a new measurement

studio_space-pairs = match graph
    .title = Draw lines between photographs with common points

studio_space-fewest = Fewest common points of a connection

# $limit = 30
studio_space-weak_pairs = < { $limit } common points

studio_space-section = section
    .title = Draw only the points between two planes

# $across = "level"
studio_space-across = { $across ->
        [side] upright, from the side
        [front] upright, facing
        [level] level
        [points] by 3 measured points
        *[none] none
    }

studio_space-section_place = Place of the section

studio_space-section_thickness = Thickness of the section

studio_space-three_points_first = measure between three points first
