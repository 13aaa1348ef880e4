report_trajectories-title = Observed positions and attitudes

report_trajectories-carried = Lever arms, shifts, drifts and misalignments

# $kind = "antenna"
# $name = "1"
# $n = 40
report_trajectories-line = { $kind ->
        [antenna] Antenna { $name }
        [positions] Positions
        *[attitudes] Attitudes
    }, { $n } { $n ->
        [one] image
        *[other] images
    }

# $n = 8
# $of = 20
report_trajectories-lines_drawn = { $n } of { $of } lines are drawn.

# $positions = 40
# $attitudes = 40
report_trajectories-observed = Observed: { $positions } { $positions ->
        [one] position
        *[other] positions
    }, { $attitudes } { $attitudes ->
        [one] attitude
        *[other] attitudes
    }.

report_trajectories-methods = Direct orientation uses them unchanged; integrated orientation adjusts them with the image points.

report_trajectories-difference = Their difference, observed minus adjusted, contains the errors of GNSS and INS.
    .why = It also contains remaining errors of lever arm, misalignment and clocks.

# $component = "east"
report_trajectories-component = { $component }

report_trajectories-component_label = component

report_trajectories-sigma_after = sigma after adjustment

report_trajectories-comparison = Direct minus integrated orientation

report_trajectories-corrected = After lever arm, shift, drift and misalignment, where they are estimated.

report_trajectories-marked = Marked: the rms exceeds twice the stated sigma.

report_trajectories-sigma_after_note = Sigma after adjustment: of the integrated value, in the datum of the block.

report_trajectories-carrier = instrument

report_trajectories-separability = With level images of one heading, lever arm and shift are not separable.
    .why = A constant error of the attitude is absorbed by the misalignment.

# $component = "east"
# $rms = 31.0
# $unit = "mm"
report_trajectories-along_line = Observed minus adjusted { $component }, rms { $rms } { $unit }; band: 95 % by the stated standard deviation.

# $kind = "velocity"
report_trajectories-motion = { $kind ->
        [velocity] Velocity
        *[rotation] Rotation
    } during read-out of each image, in the order of the block, and its sigma.

report_trajectories-motion_heading = Motion during read-out

report_trajectories-shift = Shift: position as observed minus adjusted, along X, Y, Z.
    .why = With coordinates of a map these are east, north and up.
