studio_point-current = Current point

studio_point-current_name = Name of the current point

studio_point-current_none = none (N: new point)

studio_point-coordinates = Coordinates of the current point

studio_point-marks = Marks of the current point

studio_point-filter = Filter points

studio_point-points = Points

# $n = 3
# $of = 1200
studio_point-points_of = Points: { $n } measured, { $of } in the block

# $n = 3
studio_point-visible = Visible, not measured ({ $n })

studio_point-visible_images = Images in which the current point is visible and not measured

studio_point-angle = Angle to the nearest measured ray

studio_point-new = New
    .title = New point (N)

studio_point-snap = snap to

# $how = "ellipse"
studio_point-how = { $how ->
        [auto] auto
        [ellipse] ellipse
        [corner] corner
        [cross] cross
        [patch] patch
        [hand] by hand
        *[file] file
    }

# $how = "ellipse"
studio_point-snapping = Snap to: { studio_point-how }

studio_point-worst_next = Next worst
    .title = Show the next of the worst observations and points (W)

studio_point-no_worst = There is no adjustment yet.

# $number = 1
# $of = 20
# $point = "t17"
# $kind = "w"
# $value = "5.2"
# $unit = "m"
# $n = 2
studio_point-worst = { $number } of { $of }: { $point }, { $kind ->
        [w] |w| = { $value }
        [sigma] sigma { $value } { $unit }
        *[rays] { $n } rays
    }

studio_point-none_visible = The current point is visible in no further image.

studio_point-no_unit = no unit

studio_point-choose_or_begin = Click a point in an image or in the list, or begin a new one.

# $source = "intersected"
# $n = 3
studio_point-located = { $source ->
        [adjusted] From the adjustment
        [updated] From the adjustment and later marks
        [intersected] Intersected from its marks
        [ray] Seen once: depth unknown
        *[unknown] Not seen yet
    }; { $n } { $n ->
        [one] ray
        *[other] rays
    }.

studio_point-by = by

studio_point-sigma_px = s
    .title = Standard deviation [px]

studio_point-vx = vx
    .title = Residual in x [px]

studio_point-vy = vy
    .title = Residual in y [px]

# $point = "M1"
studio_point-show = Show { $point }

# $point = "M1"
studio_point-choose = Choose { $point }

# $name = "F1"
studio_point-measure = Measure { $name }

# $name = "M1"
studio_point-remove = Remove { $name }

# $name = "M1"
studio_point-removed = Removed: { $name }.

# $n = 3
studio_point-mark_count = { $n } { $n ->
        [one] mark
        *[other] marks
    }

# $point = "M1"
studio_point-mark_removed = Mark of { $point } removed.

# $point = "M1"
# $how = "ellipse"
# $sigma_px = "0.03"
# $cause = "none"
# $far_px = 3.1
studio_point-marked = { $point } measured: { studio_point-how }, { $sigma_px } px{ $cause ->
        [none] {""}
        *[other] ; { $cause }
    }{ $far_px ->
        [0] {""}
        *[other] ; { $far_px } px from the click, check it
    }.

# $point = "M1"
# $how = "ellipse"
# $sigma_px = "0.03"
# $cause = "none"
# $far_px = 3.1
studio_point-moved = { $point } moved: { studio_point-how }, { $sigma_px } px{ $cause ->
        [none] {""}
        *[other] ; { $cause }
    }{ $far_px ->
        [0] {""}
        *[other] ; { $far_px } px from the click, check it
    }.

# $point = "M1"
studio_point-marked_before = { $point } is measured here already.
    .do = Drag the mark, or move it with Shift and the arrow keys.

studio_point-not_marked = The current point is not measured in this image.

studio_point-none_chosen = No point is chosen.
    .do = Begin one with N, or click an image point.

# $point = "M1"
studio_point-new_point = New point { $point }.
    .do = Click it in an image, or move the cross hair there and press Enter.

# $point = "t17"
studio_point-rejected = { $point } is not used from the next adjustment on.

# $point = "t17"
studio_point-accepted = { $point } is used again from the next adjustment on.

studio_point-patch_reference = A patch needs its point in another image; mark it there first.

# $role = "control"
studio_point-role = { $role ->
        [control] control
        [check] check
        *[tie] tie
    }

# $point = "P7"
# $role = "control"
studio_point-role_given = { $point }: { studio_point-role }

studio_point-role_of_current = Role of the current point

# $point = "M1"
studio_point-of_point = of { $point }

# $field = "length"
studio_point-number_missing = { $field }: a number is missing.

studio_point-give = Give

studio_point-bars = Scale bars

studio_point-bar_start = from point

# $point = "M1"
studio_point-bar_start_as = from point, e.g. { $point }

studio_point-bar_end = to point

studio_point-last_two = Use the two points that were measured last

# $start = "M1"
# $end = "M2"
# $length = "1.5"
studio_point-bar_given = Scale bar { $start } – { $end }: { $length }

studio_point-control = Control and check points

studio_point-control_table = Table of control coordinates

studio_point-control_note = Drop a table point,X,Y,Z,sX,sY,sZ anywhere on this window.

# $n = 8
# $name = "control.csv"
studio_point-control_added = { $n } control { $n ->
        [one] point
        *[other] points
    } from { $name }

# $name = "control.csv"
studio_point-table_too_large = { $name } is too large for a table of control coordinates.

studio_point-drop = Drop the table of control coordinates

studio_point-lines = Lines, levels, planes

studio_point-line_name = name of the figure

# $kind = "plumb"
studio_point-line_kind = { $kind ->
        [straight] straight line
        [plumb] plumb line
        [level] level
        *[plane] plane
    }

studio_point-line_kinds = Kind of figure

studio_point-line_points = Points of the line

studio_point-line_sigma = Standard deviation of a point's distance from it

# $kind = "plumb"
# $line = "edge"
# $points = "M1, M2"
studio_point-line_given = { $kind ->
        [straight] Straight line
        [plumb] Plumb line
        [level] Level
        *[plane] Plane
    } { $line }: { $points }

studio_point-add = Add
    .title = Add the named or the current point

studio_point-add_chosen = add each chosen point
    .title = Add each point chosen in a photograph, in space or in a list

studio_point-clear = Clear
    .title = Remove all points

studio_point-datum = Coordinate system

studio_point-origin = origin

studio_point-on_axis = on the X axis

studio_point-in_plane = in the XY plane (optional)

# $role = "origin"
studio_point-use_current = Use the current point ({ $role })

studio_point-remove_datum = Remove
    .title = Use the coordinate system of the block

studio_point-datum_removed = The coordinate system is that of the block.

# $points = "M1, M2, M3"
studio_point-datum_given = Coordinate system: { $points }

# $origin = "M1"
# $axis = "M2"
# $plane = "M3"
studio_point-datum_is = Origin { $origin }, X axis { $plane ->
        [none] towards { $axis }, vertical from levels and plumb lines
        *[other] through { $axis }, { $plane } in the XY plane
    }.

studio_point-datum_note = The coordinate system is that of the block.
    .do = Give three points: origin, X axis, XY plane. With levels or plumb lines, two points are enough.

studio_point-rename_or_forget = Rename or delete a point

studio_point-new_name = new name

studio_point-rename = Rename

# $point = "M1"
# $to = "P7"
studio_point-renamed = { $point } renamed to { $to }.

studio_point-forget = Delete
    .title = Delete the current point with its marks

# $point = "M1"
studio_point-forgotten = { $point } deleted, with its marks.

studio_point-masks = Masks

studio_point-mask_name = name of the mask

# $number = 1
studio_point-mask_default = mask { $number }

studio_point-draw_mask = Draw an area
    .title = Click its corners, or move the cross hair there and press Enter

studio_point-exclude = Exclude this area

studio_point-last_corner = Back
    .title = Remove the last corner (Delete)

studio_point-cancel_mask = Cancel
    .title = Draw no mask (Esc)

studio_point-mask_of_camera = in all photographs of the camera

studio_point-no_corner = No corner is drawn.
    .do = Click the corners in a photograph.

# $mask = "mask 1"
studio_point-mask_given = { $mask } is excluded when orient runs again.

# $image = "a.jpg"
studio_point-mask_elsewhere = The area is drawn in { $image }; Esc ends it.

# $n = 3
# $image = "a.jpg"
studio_point-corners = { $n } { $n ->
        [one] corner
        *[other] corners
    }{ $image ->
        [none] {""}
        *[other]  in { $image }
    }.
    .do = Drag a corner to move it; Delete removes the last.

# $folder = "masks"
studio_point-masks_note = Masks are used when orient runs again in this project.{ $folder ->
        [none] {""}
        *[other]  Masks of { $folder } are drawn, too.
    }

# $mask = "mask 1"
studio_point-edit_mask = Edit { $mask }

# $image = "a.jpg"
studio_point-camera_of = camera of { $image }

studio_point-fiducials = Fiducial marks

# $image = "old_1.jpg"
# $n = 2
# $of = 4
studio_point-fiducials_of = Fiducial marks of { $image }: { $n } of { $of }

studio_point-find_fiducials = Find the others
    .title = Measure the others near their expected places

# $n = 2
studio_point-fiducials_found = { $n } fiducial { $n ->
        [one] mark
        *[other] marks
    } found

# $name = "F1"
studio_point-click_fiducial = Click { $name } in the scan; Esc ends.

studio_point-fiducials_note = Choose one and click it in the scan. They place the scan in the frame of its camera.
