# $n = 5
studio_photo-count = { $n } { $n ->
        [one] image
        *[other] images
    }

studio_photo-filter_images = Filter images

# $n = 1200
studio_photo-rays = { $n } { $n ->
        [one] ray
        *[other] rays
    }

# $percent = 2.0
studio_photo-p_wrong = probability that the station is wrong: { NUM($percent, digits: 2) } %

# $n = 2
studio_photo-not_oriented = not oriented{ $n ->
        [0] {""}
        [one] , { $n } mark
        *[other] , { $n } marks
    }

# $name = "weak"
studio_photo-legend = { $name ->
        [used] used
        [weak] fewer than 3 rays
        [rejected] rejected
        [control] control
        [check] check
        [mark] mark
        [predicted] predicted, 1 and 3 sigma
        [beyond] beyond the limit
        *[masked] masked
    }

# $filter = "worst"
studio_photo-filter = { $filter ->
        [all] all
        [rejected] rejected
        [weak] weak
        [control] control
        [worst] largest |w|
        *[none] none
    }

# $n = 2
studio_photo-panes = { $n ->
        [one] { $n } image
        *[other] { $n } images side by side
    }

studio_photo-pane_count = Number of images

studio_photo-linked = linked
    .title = Move and zoom all images together

studio_photo-loupe = loupe
    .title = Enlarge the part at the pointer (L)

studio_photo-targets = targets
    .title = Draw the targets found in the photographs

studio_photo-residuals = residuals
    .title = Length of a residual of 1 px on the screen

studio_photo-brightness = brightness
    .title = Double-click to reset

studio_photo-contrast = contrast
    .title = Double-click to reset

studio_photo-last_open = The last image stays open.

studio_photo-no_point_here = There is no image point at the pointer or cross hair.

# $image = "a.jpg"
studio_photo-canvas = Photograph { $image }: arrow keys move the cross hair, Enter marks, ? lists all keys

# $image = "a.jpg"
studio_photo-pane = Image { $image }

# $image = "a.jpg"
studio_photo-turn_left = Turn { $image } to the left

# $image = "a.jpg"
studio_photo-turn_right = Turn { $image } to the right

# $image = "a.jpg"
studio_photo-pixels = Show { $image } pixel by pixel

# $image = "a.jpg"
studio_photo-fit = Fit
    .title = Show all of { $image }

# $image = "a.jpg"
studio_photo-close = Close { $image }

studio_photo-unknown = The file of the photograph is unknown.
    .do = Give its folder: { OPTION("photos") }.

studio_photo-outside = This place is outside the photograph.

# $vx = "0.12"
# $vy = "-0.3"
# $w = "1.2"
# $n = 3
studio_photo-residual = v { $vx }, { $vy } px, |w| { $w }, { $n } { $n ->
        [one] ray
        *[other] rays
    }

# $cause = "blunder"
studio_photo-rejected = rejected: { $cause }

studio_photo-by_hand = by hand
