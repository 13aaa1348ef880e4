enmap-no_rpc = Die Datei enthält kein RPC eines Kanals (bandID).
    .why = Orthorektifizierte Produkte (Stufe 1C, 2A) haben keines.
    .do = Die Metadaten des Produkts der Stufe 1B angeben.

enmap-one_band = Das RPC des Kanals { $band } wird verwendet{ $n ->
     [one] , das einzige
     *[other] ; die der { $n } Kanäle unterscheiden sich um bis zu { NUM($apart_px, decimals: 2) } px
    }.
