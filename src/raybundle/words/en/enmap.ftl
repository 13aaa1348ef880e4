enmap-no_rpc = The file contains no RPC of a band (bandID).
    .why = Orthorectified products (level 1C, 2A) have none.
    .do = Give the metadata of the level 1B product.

# $band = "1"
# $n = 224
# $apart_px = 20.0
enmap-one_band = The RPC of band { $band } is used{ $n ->
     [one] , the only one
     *[other] ; those of the { $n } bands differ by up to { NUM($apart_px, decimals: 2) } px
    }.
