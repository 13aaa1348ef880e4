behind_camera = { $n } point(s) image derrière la caméra, écarté(s) : { $pairs }.

behind_camera-photographs = { $n } photo(s) ont plus de { PERCENT($limit) } % des points de liaison derrière la caméra : { $ids }.

behind_camera-matches = { $n } fausse(s) correspondance(s) derrière la caméra écartée(s) : { $pairs }.
