# $image = "IMG_1"
query-image_without_part = Image { $image } took no part in the adjustment.
    .do = Leave it out.

# $name = "plane:floor"
query-unknown_own = { $name } is no unknown of an observation kind that takes part.
    .do = Give KIND:NAME, for example plane:floor.

# $name = "point:P9"
query-unknown = { $name } is no unknown of this adjustment.
    .do = Give point:ID, image:ID, camera:ID, or KIND:NAME (for example plane:floor) of an estimated object.
