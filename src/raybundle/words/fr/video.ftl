video-count_and_time = Le nombre d'images et l'intervalle de temps s'excluent.

video-option_not_positive = { $option ->
        [count] Le nombre d'images
        [every_s] Le temps entre images [s]
       *[motion] Le mouvement entre images
     } vaut { $value }.

video-not_decoded = La vidéo ne peut être décodée.

video-no_frame = La vidéo n'a aucune image décodable.
