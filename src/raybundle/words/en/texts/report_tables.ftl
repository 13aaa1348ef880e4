report_tables-title = Coordinates and orientations

# $n = 8742
report_tables-object_points = { $n } object { $n ->
        [one] point
        *[other] points
    }

# $n = 60
report_tables-images = { $n } { $n ->
        [one] image
        *[other] images
    }

# $n = 70
# $of = 8742
report_tables-points_printed = { $n } of { $of } points: known and named ones, those with the largest standard deviations, a sample.

report_tables-all_points = All points are in points.csv, and here with { OPTION("all_coordinates", "True") }.

# $n = 2000
# $of = 8742
report_tables-first_points = The first { $n } of { $of } points.

report_tables-changed = not the default

report_tables-input_label = input

report_tables-hash = SHA-256 of the values

report_tables-software_label = software

report_tables-settings = Settings

report_tables-input = Input

# $kind = "source"
# $text = "survey of 2024"
report_tables-about = { $kind ->
        [description] Description
        [source] Source
        *[licence] Licence
    }: { $text }

report_tables-software = Software

report_tables-provenance = Settings, input and software

# $name = "images"
# $other = "distances"
report_tables-table = { $name ->
        [cameras] cameras
        [images] images
        [observations] observations
        [points] points
        [instruments] antennas and IMUs
        [rig_stations] rig stations
        [distances] distances
        [stations] projection centres
        [attitudes] attitudes
        [planes] planes
        [lines] lines
        [plumb_lines] plumb lines
        [levels] levels
        [coordinates] coordinates
        [deviations] deviations
        [directions] directions
        [zenith_angles] zenith angles
        [slope_distances] slope distances
        [differences] coordinate differences
        *[other] { $other }
    }

# $native = true
report_tables-kernel = { $native ->
        [yes] native, RootSIFT by the native kernel
        *[no] NumPy (no native kernel: slower, same results from the same image points), RootSIFT by OpenCV
    }

report_tables-not_installed = not installed
