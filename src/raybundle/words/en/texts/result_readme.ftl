# $name = "facade"
# $version = "0.1.0"
result_readme-title = { $name }: result folder, written by raybundle { $version }.

# $entry = "points"
result_readme-file = { $entry ->
        [report_html] report, for a browser
        [report_pdf] report, for print
        [network_html] network in three dimensions, for a browser
        [map_csv] stations and points in the coordinate system of the control
        [map_control_csv] control and check points in that system, with adjusted minus given
        [coordinate_list_csv] measured coordinates, for a spreadsheet
        [nominal_csv] deviations from nominal coordinates
        [lengths_csv] measured against known lengths
        [calibration_toml] calibrated cameras, for { OPTION("calibration") } of later runs
        [record_toml] recording sheet: client, object, place, operator, rights
        [result_json] statistics, cameras, correlations and warnings, for programs
        [block] adjusted block with all digits, for further adjustments
        [images] exterior orientations: projection centres and rotations
        [points] object points
        [observations] image points with residuals and tests
        [control] control points: given, with residuals and tests
        [check] check points: given, and adjusted minus given
        [distances] scale bars
        [stations] observed projection centres
        [attitudes] observed attitudes
       [displacements_csv] displacements between the dates, in the axes of X, Y, Z, with standard deviations, tests and verdicts
        [velocities_csv] velocities and accelerations of what moved in three dates or more [m, years], with standard deviations and tests
        [surface_strain_csv] strains of the surface between the dates, of groups and patches of points, with standard deviations and tests
        [epochs_json] dates, moved points and areas, limit, changes of earlier results
       *[other] observations of this kind, with residuals and tests
    }

# $unit = "m"
result_readme-rules = Tables: UTF-8, commas, decimal points; an empty cell is no number.
    .why = Columns without a unit in their name are { $unit ->
        [none] in an arbitrary unit: nothing determines the scale
       *[other] in { $unit }
    }.

# $content = "sigma"
result_readme-column = { $content ->
        [coordinates] coordinates in object space
        [angles] rotation of the image, R = R(omega) R(phi) R(kappa)
        [image_point] image point: x right, y down, from the upper left corner of the format
        [sigma] standard deviations, a posteriori
        [sigma_given] standard deviations of observations, a priori
        [p_wrong] probability that the station of a photograph is wrong
        [rays] number of image observations in the adjustment
        [window] size of the window of a tie point in object space
        [roughness] standard deviation along the ray from relief within the window; part of sX, sY, sZ
        [correlation] correlations of the coordinates
        [difference] adjusted minus given
        [adjusted] adjusted value
        [residual] residual: adjusted minus observed
        [redundancy] redundancy number, 0 (not checked) to 1 (fully checked)
        [normalised] normalised residual, v over its a-priori standard deviation
        [test] the same, a posteriori
        [detectable] smallest blunder that would be found (1 in 1000 false, 80 % found)
       *[rejected] reason for rejection; empty: in the adjustment
    }
