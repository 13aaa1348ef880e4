studio_table-table = Table

# $kind = "pairs"
studio_table-kind = { $kind ->
        [observations] image observations
        [pairs] pairs of images
        *[points] points
    }

studio_table-filter = Filter by name

studio_table-rows = Rows: arrow keys choose one, Enter opens it

# $n = 1200
studio_table-count = { $n } { $n ->
        [one] row
        *[other] rows
    }

# $name = "point"
studio_table-sort = Sort by { $name }

studio_table-largest_w = max |w|

studio_table-w = |w|

studio_table-x = x [px]

studio_table-y = y [px]

studio_table-vx = vx [px]

studio_table-vy = vy [px]

studio_table-redundancy = redundancy

studio_table-other_image = other image

studio_table-base = base

studio_table-observation = image observation
