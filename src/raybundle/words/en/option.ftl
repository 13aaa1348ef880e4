# $first = "gsd"
# $second = "height"
option-exclusive = { OPTION($first) } and { OPTION($second) } exclude each other.
    .do = Give one of them.

# $setting = "interval"
# $value = "HEIGHT"
option-missing = { OPTION($setting, $value) } is missing.
    .do = Add it.
