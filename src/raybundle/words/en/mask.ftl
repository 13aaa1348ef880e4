# $n = 20
# $names = ["img_07.jpg.png", "img_07_mask.png", "img_07.png"]
# $similar = ["IMG_07.JPG"]
mask-none_found = The folder has no mask of the { $n } photographs.
    .why = Names are compared with upper and lower case; similar ones exist for: { $similar }.
    .do = Name masks like { $names }.

# $hidden = 19
# $n = 20
# $names = ["img_01.jpg", "img_02.jpg"]
mask-all_hidden = The masks exclude { $hidden } of { $n } photographs completely; two photographs are needed.
    .why = In a mask, 0 or transparent is excluded, any other value is used.
    .do = Check whether the masks are inverted or empty: { LIST($names, most: 3) }.

# $width_px = 3000
# $height_px = 1999
# $orientation = 1
# $photograph = "img_07.jpg"
# $photograph_width_px = 6000
# $photograph_height_px = 4000
mask-size_differs = The mask has { $width_px } x { $height_px } px, photograph { $photograph } { $photograph_width_px } x { $photograph_height_px } px.
    .why = The mask is not used: sizes must be equal, or whole multiples (EXIF orientation { $orientation }).
    .do = Export the mask again.

# $corner = 2
# $word = "'300'"
mask-corner_form = Corner { $corner } of the polygon is { $word }.
    .do = Give x and y with a comma, corners with a blank between: '10,20 300,20 300,200'

# $name = "IMG_07.JPG.png"
# $names = ["img_07.jpg.png", "img_07_mask.png", "img_07.png"]
mask-other_name = { $name } differs from the names of a mask for this photograph.
    .do = Rename it to one of { $names } (COLMAP, Metashape), with the same upper and lower case.
