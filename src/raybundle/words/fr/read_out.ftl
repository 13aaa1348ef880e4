read_out-time = Un temps de lecture de { NUM($time_ms, decimals: 0) } ± { NUM($sigma_ms, decimals: 0) } ms réduit le khi-deux de { NUM($by_read_out, decimals: 0) }.

read_out-share = Une lecture de { PERCENT($share) } % de l'intervalle entre photographies réduit le khi-deux de { NUM($by_read_out, decimals: 0) }.

read_out-given = Le temps de lecture donné de { $time_ms } ms est observé à { PERCENT($sigma_share) } %.

read_out-table = Mesures publiées de cette caméra : { NUM($time_ms, decimals: 0) } ms.

read_out-still = { $n } photographies sans vitesse (virages, lacunes) sont supposées immobiles.

read_out = Caméra { $camera } : l'obturateur déroulant est modélisé.
