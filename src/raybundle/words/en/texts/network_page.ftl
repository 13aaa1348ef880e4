# $name = "facade"
network_page-title = Network of { $name }

network_page-decimal = .

network_page-colour_of_points = Colour of points

network_page-number_of_rays = number of rays

network_page-standard_deviation = standard deviation

network_page-role = role

network_page-sigma_of_object = standard deviation of the object

network_page-colour_of_dense_points = Colour of dense points

network_page-own_colour = own colour

network_page-source_photograph = source photograph

network_page-show = Show

network_page-dense_points = dense points

network_page-object_points = object points

network_page-known_points = control and check points, enlarged

network_page-images = images

network_page-proposals = proposed photographs (red)

network_page-object = object

network_page-scale_bars = scale bars

network_page-ellipsoids = error ellipsoids (1 sigma)

network_page-enlarged = enlarged

network_page-first_view = first view

network_page-mouse = Drag to turn, right-drag to shift, wheel to zoom.

network_page-click = Click a point or an image to see its rays.

network_page-no_graphics = This browser shows no 3D graphics (WebGL is switched off).
    .why = The report and the PLY file contain the same network.

network_page-tie_points = tie points

network_page-control_points = control points

network_page-check_points = check points

network_page-tie_point = tie point

network_page-control_point = control point

network_page-check_point = check point

network_page-rays_2 = 2 rays or fewer

network_page-rays_3 = 3 rays

network_page-rays_4 = 4 to 5

network_page-rays_6 = 6 to 9

network_page-rays_10 = 10 and more

network_page-image = image

network_page-sigma = sigma

network_page-rays = rays

# $points = 50000
# $of_points = 81200
# $all_points = false
# $images = 40
# $of_images = 40
# $all_images = true
network_page-contents = { $points ->
        [0] No object point has coordinates
        *[other] { $points }{ $all_points ->
            [yes] {""}
            *[no] {" "}of { $of_points }
        } object { $of_points ->
            [one] point
            *[other] points
        }
    }, { $images }{ $all_images ->
        [yes] {""}
        *[no] {" "}of { $of_images }
    } { $of_images ->
        [one] image
        *[other] images
    }.

# $cell = 0.25
# $unit = "m"
network_page-one_per_cell = Of tie points, one per cell of { NUM($cell) } { $unit } is shown.

# $n = 5000
network_page-worst_points = The { $n } with the largest standard deviations are shown as well.

network_page-all_in_table = The table of points contains all.

network_page-images_chosen = Images are evenly chosen.

# $n = 2000
network_page-ellipsoids_of = Error ellipsoids (1 sigma, 20 % probability) of { $n } { $n ->
        [one] point
        *[other] points
    }, enlarged.

network_page-no_statistics = Standard deviations were not computed (statistics are off).

network_page-arbitrary_scale = The scale is arbitrary: lengths have no absolute unit.

# $n = 200000
# $cell = 0.01
# $unit = "m"
network_page-dense_shown = { $n } dense { $n ->
        [one] point is
        *[other] points are
    } shown{ $cell ->
        [0] {""}
        *[other] , one per cell of { NUM($cell, digits: 2) } { $unit }
    }.
    .why = Their standard deviations are along the ray.

# $sigma = 0.5
# $unit = "mm"
# $what = "worst"
network_page-wanted = Required standard deviation of a coordinate: { NUM($sigma) } { $unit } ({ $what ->
        [worst] worst point
        *[mean] mean
    }).
    .why = Red is worse; one step of colour corresponds to twice as many photographs.

network_page-unseen = seen by less than two images
