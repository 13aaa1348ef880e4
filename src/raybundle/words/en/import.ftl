# $camera = "1"
# $model = "brown"
# $deviation_px = 0.02
# $covered = 1.0
# $whole = true
import-camera_fitted = Camera { $camera } is read as model { $model }, fitted over the format: largest deviation { $deviation_px } px.
    .why = { $whole ->
     [yes] { "" }
     *[no] Its distortion can be inverted over { PERCENT($covered) } % of the format.
    }

# $n = 3
# $kinds = ["2 R", "1 T"]
import-not_read = { $n } { $n ->
     [one] element of the file was
     *[other] elements of the file were
    } not read: { LIST($kinds, most: 6) }.

# $n = 3
import-repeated_observations = { $n } { $n ->
     [one] observation repeats
     *[other] observations repeat
    } a point in the same image and { $n ->
     [one] is
     *[other] are
    } left out.

# $sigma_px = 0.5
import-sigma_assumed = Standard deviation of the image observations: not in the format; { $sigma_px } px assumed.

# $n = 2
import-sensors_without_pose = { $n } { $n ->
     [one] image has a sensor
     *[other] images have sensors
    } without orientation in the rig; image orientations are used.

# $n = 6
# $total = 6
# $apart = 0.12
# $image = "a.jpg"
# $angle_deg = 0.5
import-rig_poses_differ = Exterior orientations of { $n } of { $total } images differ between images and rigs; the rigs are used.
    .why = The largest differences are { $apart } in position (image { $image }) and { $angle_deg }°.

# $n = 12
# $total = 400
import-points_without_object = { $n } of { $total } image points belong to no object point and are left out.

# $format = "BINGO"
# $pixel_mm = 0.01
# $table = "cameras.toml"
import-format_assumed = { $format } contains neither format nor pixel size; a format around the image points is assumed.
    .why = The assumed pixel size is { $pixel_mm } mm.
    .do = Add { $table } to the folder if they are known.

# $n = 4
# $plan_m = 0.01
# $height_m = 0.02
import-control_sigma_assumed = { $n } control { $n ->
     [one] point has
     *[other] points have
    } no standard deviation; { $plan_m } m in plan and { $height_m } m in height assumed.

# $reading = "opk_gon"
import-orientation_convention = The orientations are read as { $reading ->
     [pok_gon] phi, omega, kappa in gon
     [opk_gon] omega, phi, kappa in gon
     [opk_deg] omega, phi, kappa in degrees
     [object_to_image] rotations from object to image axes
     *[image_to_object] rotations from image to object axes
    }.
    .why = The image points fit this convention better than that of the format.

# $n = 2
# $total = 20
import-not_oriented = { $n } of { $total } photographs have no exterior orientation.

# $name = "fl_x"
# $used_px = 1200.0
# $other = "camera_angle_x"
# $other_px = 1310.0
import-focal_length_contradicts = { $name } ({ NUM($used_px, digits: 6) } px) and { $other } ({ NUM($other_px, digits: 6) } px) contradict each other; { $name } is used.

import-no_observations = The format contains no image observations.

# $n = 3
import-first_reconstruction = The file has { $n } reconstructions; the first is read.
    .why = Each of them is in a coordinate system of its own.

# $name = "tracks.csv"
import-no_tracks = There are no tracks ({ $name }); no image observations are read.

# $system = "'EPSG:25832'"
import-system_of_file = The coordinates are in { $system }.
    .do = Give { OPTION("crs") } with this system.

# $system = "'EPSG:25832'"
# $shift = ["534684.000", "5338120.000", "171.000"]
# $scaled = false
# $scale = ["1", "1", "1"]
# $swapped = false
import-processing_frame = The coordinates are in the processing frame of the project, shift { LIST($shift, most: 3) }.
    .why = The reference is { $system }{ $scaled ->
     [yes] ; scale { LIST($scale, most: 3) }
     *[no] { "" }
    }{ $swapped ->
     [yes] ; X and Y are exchanged
     *[no] { "" }
    }.

# $kind = "camera"
# $n = 1
import-elements_left_out = { $n } { $kind ->
     [sensor] { $n ->
     [one] sensor
     *[other] sensors
     }
     [transform] { $n ->
     [one] transform
     *[other] transforms
     }
     [rotation_or_location_of_a_sensor] { $n ->
     [one] mounting of a sensor
     *[other] mountings of sensors
     }
     [marker] { $n ->
     [one] marker
     *[other] markers
     }
     [reference_of_a_marker] { $n ->
     [one] reference of a marker
     *[other] references of markers
     }
     *[camera] { $n ->
     [one] camera
     *[other] cameras
     }
    } of the file left out, the first one for this reason:

# $kind = "disabled_camera"
# $n = 2
import-elements_disabled = { $n } disabled { $kind ->
     [disabled_marker] { $n ->
     [one] marker is
     *[other] markers are
     }
     *[disabled_camera] { $n ->
     [one] camera is
     *[other] cameras are
     }
    } not used.

# $number = 2
# $n = 3
import-one_chunk = The file has { $n } chunks; chunk { $number } is read.
    .why = The first enabled chunk with cameras is preferred.

import-chunk_disabled = The chunk is disabled; no other one has cameras.

# $sensor = "FC6310"
import-sensor_without_calibration = Sensor { $sensor } has no calibration and is left out with its images.

import-no_object_space = The chunk has no transform to object space; its coordinates have no scale.

# $n = 4
import-components_apart = { $n } { $n ->
     [one] image is
     *[other] images are
    } read without orientation: { $n ->
     [one] its component has
     *[other] their components have
    } no transform to the rest.

import-geocentric = The chunk is georeferenced: its coordinates are geocentric (X, Y, Z of the earth).

# $n = 3
# $sigma_m = ["0.005"]
import-marker_sigma_assumed = { $n } { $n ->
     [one] marker has
     *[other] markers have
    } no accuracy; the chunk's standard deviation of { LIST($sigma_m, most: 3) } is assumed.

import-system_not_read = The coordinate system of the chunk cannot be read:

# $unit = "foot"
# $length_m = "0.3048"
import-markers_converted = The coordinates of markers are converted from { $unit } to metres (1 { $unit } = { $length_m } m).
