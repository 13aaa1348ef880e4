mission_picture-take_off = take-off

# $number = 2
mission_picture-battery = battery { $number }

mission_picture-photographs_of_place = photographs that show a place

# $number = 1
mission_picture-gap = gap { $number }

# $name = "mission"
mission_picture-gaps = { $name }: to be flown again
