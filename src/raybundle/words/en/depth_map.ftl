# $density = 3
depth_map-density = The density of a depth map is { $density }; possible are 1, 2 and 4.
    .do = Give 1 for a depth at every pixel, 2 at every second, 4 at every fourth.

# $image = "IMG_1"
depth_map-no_source = Image { $image }: no other photograph is suitable for dense matching with it.
    .do = Take photographs that overlap with it and differ in position.

# $image = "IMG_1"
depth_map-outside_region = Image { $image } does not show the region.
    .do = Leave it out, or choose another region.

# $image = "IMG_1"
# $n = 3
# $least = 10
depth_map-too_few_points = Image { $image } has { $n } tie points; the range of depths needs { $least }.
    .do = Leave it out, or take photographs with more overlap.

# $n = 40
# $most = 16
depth_map-source_count = The reference image has { $n } source images; 1 to { $most } are possible.
    .do = Choose the best source images.

# $array = "starts"
# $shape = [3, 10]
# $needed = [3, 10, 12]
depth_map-array_shape = Array { $array } has shape ({ $shape }).
    .do = Give an array of shape ({ $needed }).

# $x_px = 4100
# $y_px = 3000
# $width_px = 4000
# $height_px = 3000
depth_map-grid_outside = The grid of pixels extends to { $x_px }, { $y_px }; the image has { $width_px } x { $height_px } px.
    .do = Give a grid inside the image.

# $width_px = 12000
# $height_px = 9000
# $memory_gb = 2.0
depth_map-memory = Depths of { $width_px } x { $height_px } px need more than { NUM($memory_gb, digits: 2) } GB of memory.
    .do = Allow more memory, or reduce the photographs.

depth_map-single_photograph = A surface needs at least two photographs of the same part of the object.
    .do = Add overlapping photographs.

# $low = 2.0
# $high = 1.0
depth_map-depth_range = Depth parameters from { $low } to { $high } are not a range of depths.
    .do = Give two increasing values above 0.

# $image = "IMG_1"
# $error_px = 0.3
# $limit_px = 0.05
depth_map-projection_table = Image { $image }: the table of its projection has errors of { $error_px } px (limit { $limit_px } px).
    .do = Leave it out as a source image.
