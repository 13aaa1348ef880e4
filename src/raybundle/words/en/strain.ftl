# $name = "load-07.tif"
# $n = 1200
# $of = 1250
# $sigma_px = 0.006
strain-displacements = { $name }: { $n } of { $of } subsets followed, standard deviation { NUM($sigma_px, digits: 2) } px.

# $u_px = 3.21
# $v_px = -0.42
# $rotation_deg = 0.12
strain-motion = Common motion { NUM($u_px, digits: 4) } px right, { NUM($v_px, digits: 4) } px down, { NUM($rotation_deg, digits: 3) } deg.

# $xx = 1210
# $yy = -350
# $xy = 20
# $sigma = 110
# $largest = 4300
strain-strains = Median strain [1e-6]: xx { NUM($xx, digits: 3) }, yy { NUM($yy, digits: 3) }, xy { NUM($xy, digits: 3) }, each ± { NUM($sigma, digits: 2) }; 99 % below { NUM($largest, digits: 3) }.

# $name = "load-07.tif"
# $images = 3
# $n = 50
# $of = 1250
# $states = ["40 outside", "10 torn"]
strain-not_followed = { $name }{ $images ->
        [one] {""}
        *[other] , worst of { $images } images
    }: { $n } of { $of } subsets were not followed ({ LIST($states, most: 7) }).
    .why = outside: leaves the image. flat: no texture. unsteady: no convergence. unlike: correlation below 0.75. torn: parts move apart. changed: grey values changed. unreached: no neighbour was followed.
    .do = Compare displacements.csv, column state, with the images.

# $name = "load-07.tif"
# $share = 0.2
# $limit_px = 0.02
strain-bent = { $name }: { PERCENT($share) } % of the subsets deform by more than an affine map ({ $limit_px } px).
    .why = Parts of these subsets are displaced against their shape. The standard deviations do not contain this.
    .do = Use { OPTION("shape", "quadratic") } or a smaller { OPTION("window", "PX") }.

# $names = ["load-07.tif"]
# $gauge = 5
strain-no_strain = { LIST($names, most: 3) }: no strain, because no { $gauge } x { $gauge } subsets are half followed and connected.
    .do = Use a smaller { OPTION("step", "PX") } or { OPTION("gauge", "COUNT") }.

# $window = 31
strain-no_subset = No subset of { $window } x { $window } pixels fits into the specimen.
    .do = Give a smaller { OPTION("window", "PX") }, or another extent or mask.

# $n = 1250
# $names = ["load-01.tif"]
strain-nothing_followed = None of { $n } subsets is found again in { LIST($names, most: 3) }.
    .why = The images have no common texture, or differ too much in light or focus.
    .do = Check that the reference belongs to the series.

# $width_px = 1000
# $height_px = 800
# $reference = "load-00.tif"
# $reference_width_px = 1200
# $reference_height_px = 800
strain-other_size = { $width_px } x { $height_px } pixels, but { $reference } has { $reference_width_px } x { $reference_height_px }.
    .do = Give images of one camera, not cropped or scaled.

# $reference = "load-00.tif"
strain-same_image = The image is a copy of the reference { $reference }.
    .why = Its noise is the same; standard deviations would be wrong.
    .do = Give another image.

# $extent = [100, 100, 50, 300]
strain-empty_extent = The extent { LIST($extent) } holds no pixel.
    .do = Give left, top, right and bottom in this order.

strain-map_empty = no values

# $name = "load-00.tif"
# $correlation = 0.9
# $period_px = 12.0
strain-repeated = { $name }: the texture repeats after { NUM($period_px, digits: 3) } px (correlation { NUM($correlation, digits: 2) }).
    .why = A displacement by a whole period looks like none; subsets may be found one period off.
    .do = Use a random pattern, or a { OPTION("window", "PX") } of several periods that holds what does not repeat.

# $name = "load-00.tif"
# $share = 0.3
# $limit = 0.1
strain-saturated = { $name }: { PERCENT($share) } % of the pixels have the darkest or brightest grey value (limit { PERCENT($limit) } %).
    .why = They carry no place and no noise: standard deviations are too small, by a fifth with a third of the pixels.
    .do = Expose so that no pixel is saturated.

# $name = "mask.png"
strain-mask_empty = The mask { $name } masks nothing.
    .why = Only pixels with the grey value 0 are masked; transparency is not read.
    .do = Give an image that is black outside the specimen.

# $names = ["series.tif"]
strain-pages = Only the first picture is used of files with several: { LIST($names, most: 3) }.
    .do = Save each picture as a file of its own.

# $name = "load-07.tif"
# $n = 1200
# $of = 2300
# $share = 0.52
strain-jumps = { $name }: displacements jump between { $n } of { $of } pairs of neighbours.
    .why = The shape of a subset predicts where its neighbour lies; { PERCENT($share) } % lie more than a pixel away. The texture repeats, or the motion is too large.
    .do = Do not use this image. Use a random pattern, a larger { OPTION("window", "PX") }, or images at smaller loads in between.

# $names = ["copy.tif"]
strain-same_content = The reference itself, moved or not: { LIST($names, most: 3) }.
    .why = Its noise is the same; standard deviations are too small.
    .do = Give another image.

strain-image_twice = The image is given twice.
    .do = Give each image once.

# $name = "web"
# $n = 120
# $xx = 1210
# $yy = -350
# $xy = 20
# $s_xx = 12
# $s_yy = 11
# $s_xy = 8
strain-area = Area { $name } ({ $n } subsets), strain [1e-6]: xx { NUM($xx, digits: 3) } ± { NUM($s_xx, digits: 2) }, yy { NUM($yy, digits: 3) } ± { NUM($s_yy, digits: 2) }, xy { NUM($xy, digits: 3) } ± { NUM($s_xy, digits: 2) }.

# $name = "web"
# $n = 120
# $xx = 1210
# $yy = -350
# $xy = 20
# $misfit = 2.4
strain-area_not_one = Area { $name } ({ $n } subsets) has no single strain; plane [1e-6]: xx { NUM($xx, digits: 2) }, yy { NUM($yy, digits: 2) }, xy { NUM($xy, digits: 2) }.
    .why = Displacements differ from this plane by { NUM($misfit, digits: 2) } standard deviations (rms). No standard deviation is stated.

# $text = "web:10,20"
strain-area_text = { $text } is no area.
    .do = Give NAME:LEFT,TOP,RIGHT,BOTTOM in pixels, each name once.

# $area = "web"
# $name = "load-07.tif"
# $misfit = 2.4
# $n = 2
strain-area_uneven = Strain is not the same everywhere in { $n } { $n ->
        [one] area
       *[other] areas
    }, most of all in { $area } ({ $name }).
    .why = Displacements differ from a plane by { NUM($misfit, digits: 2) } standard deviations (rms). Strain and standard deviation are those of the plane.
    .do = Choose smaller areas, or read the maps.

# $area = "web"
# $names = ["load-07.tif"]
strain-area_empty = Area { $area } has too few subsets in { LIST($names, most: 3) }.
    .do = Choose a larger area or a smaller { OPTION("step", "PX") }.

# $area = "web"
# $width_px = 400
# $height_px = 300
strain-area_outside = Area { $area } is not within the image of { $width_px } x { $height_px } px.
    .do = Give left, top, right and bottom in pixels of the reference.
