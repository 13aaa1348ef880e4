# $least = 10
orientation-no_pair = No two images have a relative orientation.
    .why = It needs { $least } common points with intersecting rays and different depths.
    .do = Check that the images show one object from different stations.

# $names = ["left.jpg", "right.jpg"]
orientation-images_missing = Images without exterior orientation: { $names }.
    .do = Orient them first.

# $n = 3
# $total = 20
orientation-not_found = { $n } of { $total } images have no approximate orientation.
    .do = Measure more common points, or give approximate values in images.csv.

