# $focal_mm = 35.0
# $zoom = true
# $low_mm = 18.0
# $high_mm = 55.0
library_match-focal_length = EXIF focal length { NUM($focal_mm, digits: 6) } mm{ $zoom ->
        [yes] , within { NUM($low_mm, digits: 6) } to { NUM($high_mm, digits: 6) } mm of a calibrated zoom lens
        *[no] {""}
    }

# $quantity = "serial"
# $equal = true
# $value = "2001"
library_match-same = { $quantity ->
        [serial] serial number
        *[lens] lens
    } { $equal ->
        [yes] { $value }
        *[no] not compared: not known for both
    }

# $whole = false
# $width_px = 6000
# $height_px = 4000
# $own_width_px = 3000
# $own_height_px = 2000
library_match-format = format { $width_px } x { $height_px } px{ $whole ->
        [yes] {""}
        *[no] , taken as the whole of { $own_width_px } x { $own_height_px } px
    }

# $focus_m = 2.0
# $own_focus_m = 4.0
# $difference_px = 52.0
library_match-focus = focused at { NUM($focus_m, digits: 6) } m, the photograph at { NUM($own_focus_m, digits: 6) } m: c may differ by { NUM($difference_px, digits: 2) } px

library_match-no_model = the photograph's EXIF contains no camera model

# $quantity = "model"
# $value = "D3"
# $own = "D5100"
library_match-other = other { $quantity ->
        [make] make
        [model] model
        [serial] serial number
        *[lens] lens
    }: calibration { $value }, photograph { $own }

# $zoom = false
library_match-focal_length_unknown = { $zoom ->
        [yes] the photograph's EXIF focal length is not known, and the calibration is that of a zoom lens
        *[no] the EXIF focal length is not known for both; a calibration is valid for one focal length only
    }

# $focal_mm = 35.0
# $own_focal_mm = 50.0
library_match-other_focal_length = other EXIF focal length: calibration { NUM($focal_mm, digits: 6) } mm, photograph { NUM($own_focal_mm, digits: 6) } mm

# $zoom = 1.5
library_match-digital_zoom = the photograph has a digital zoom of { NUM($zoom, digits: 6) }: it is a crop

# $width_px = 6000
# $height_px = 4000
# $own_width_px = 3000
# $own_height_px = 2000
# $turned = false
library_match-other_format = other format: calibration { $width_px } x { $height_px } px, photograph { $own_width_px } x { $own_height_px } px, { $turned ->
        [yes] turned by a program
        *[no] a crop
    }

# $low_mm = 18.0
# $high_mm = 55.0
# $own_focal_mm = 70.0
library_match-beyond_zoom = calibrated for { NUM($low_mm, digits: 6) } to { NUM($high_mm, digits: 6) } mm of a zoom lens, photograph { NUM($own_focal_mm, digits: 6) } mm

# $step_mm = 1.0
# $sigma_mm = 0.3
library_match-focal_length_rounded = EXIF rounds the focal length to { NUM($step_mm, digits: 6) } mm: c is estimated from { NUM($sigma_mm, digits: 2) } mm
