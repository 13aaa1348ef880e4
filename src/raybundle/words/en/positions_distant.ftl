# $distance = 120000.0
# $exchanged = 5200000.0
# $photographs = 20
# $distance_km = 120.0
# $table = "positions.csv"
# $ids = ["IMG_1"]
positions_distant = The positions of { $table } are { $distance_km } km from the positions recorded in the { $photographs } photographs.
    .do = Check the coordinate system of { $table }, and whether it belongs to these photographs.
