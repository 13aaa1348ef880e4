studio_epochs-date = Date

studio_epochs-against = Compare with

studio_epochs-blink = Blink
    .title = Alternate the photographs of both dates

studio_epochs-larger = Arrows

studio_epochs-stable = Stable points

studio_epochs-whole = Whole picture

studio_epochs-picture = Rectified photographs with displacements. Arrow keys change the date, the wheel zooms.

studio_epochs-moved_when = Displacements since the first date, with standard deviations

studio_epochs-rows = Rows

# $kind = "moved"
studio_epochs-kind = { $kind ->
        [untested] untested
        [every] all displaced
        *[moved] moved
    }

# $n = 120
# $shown = 120
# $unit = "mm"
studio_epochs-count = { $n } { $n ->
        [one] row
        *[other] rows
    }, { $shown } shown [{ $unit }]

studio_epochs-point = Point or area

studio_epochs-since = First seen moved

# $verdict = "untested"
studio_epochs-verdict = { $verdict ->
        [untested] untested
        [moved_area] with its area
        [moved] moved
        *[not_significant] not significant
    }

studio_epochs-mean_of_uneven = Its points moved unevenly. The curve is their mean.

# $least = "3.8"
# $largest = "106.0"
studio_epochs-uneven = uneven, { $least } to { $largest }

# $name = "t12"
# $n = 0
studio_epochs-over_time = { $name }{ $n ->
        [0] {""}
        *[other] {" "}({ $n } points)
    }: displacement along its direction, 95 % band

# $name = "t12"
studio_epochs-choose = Show { $name } over time

studio_epochs-nothing_chosen = Choose a point in the picture or the table.

studio_epochs-visit = Show in images

# $from = "2026-05-01"
# $to = "2026-06-01"
# $values = "dX 1.2 ± 0.2, dY 0.4 ± 0.2, dZ 3.1 ± 0.4 mm"
studio_epochs-at_date = { $from } to { $to }: { $values }

# $date = "2026-06-01"
studio_epochs-no_place = No displacement at { $date }.

# $date = "2026-06-01"
studio_epochs-rectifying = Rectifying the photographs of { $date } ...

# $date = "2026-06-01"
studio_epochs-no_picture = No photograph of { $date } shows the plane of the points.

# $part = "near"
studio_epochs-legend = { $part ->
        [near] towards the viewer
        [away] away from the viewer
        [open] not significant at this date
        *[arrow] in the plane of the picture
    }
