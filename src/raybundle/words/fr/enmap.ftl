enmap-no_rpc = Le fichier ne contient aucun RPC de bande (bandID).

enmap-one_band = Le RPC de la bande { $band } est utilisé{ $n ->
     [one] , le seul
     *[other] { " " }; ceux des { $n } bandes diffèrent jusqu'à { NUM($apart_px, decimals: 2) } px
    }.
