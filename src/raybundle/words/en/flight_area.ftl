# $kind = "zone"
# $name = "2"
flight_area-not_finite = A corner of { $kind ->
        [zone] no-go zone { $name }
        [object] the object
        [outline] outline { $name }
       *[area] the area
     } is not two finite coordinates.
    .do = Correct the corner.

# $kind = "zone"
# $name = "2"
# $n = 2
flight_area-too_few_corners = { $kind ->
        [zone] No-go zone { $name }
        [object] The object
        [outline] Outline { $name }
       *[area] The area
     } has { $n } different corners; three are needed.
    .do = Add corners.

# $kind = "zone"
# $name = "2"
# $first = 1
# $second = 3
# $x = 533000.5
# $y = 5337000.2
flight_area-crosses_itself = { $kind ->
        [zone] No-go zone { $name }
        [object] The object
        [outline] Outline { $name }
       *[area] The area
     } crosses itself at the edges after corners { $first } and { $second }.
    .why = They meet near { NUM($x, decimals: 1) }, { NUM($y, decimals: 1) }.
    .do = List the corners in their order along the outline.

# $kind = "zone"
# $name = "2"
# $area = 0.0
# $length = 100.0
flight_area-no_area = { $kind ->
        [zone] No-go zone { $name }
        [object] The object
        [outline] Outline { $name }
       *[area] The area
     } has no extent: all corners are on one line.
    .why = Its area is { $area } over a length of { $length }.
    .do = Give its outline{ $kind ->
        [area] , or plan a corridor along the line
       *[other] { "" }
     }.
