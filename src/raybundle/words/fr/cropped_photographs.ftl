cropped_photographs = Caméra { $camera } : point principal à { PERCENT($off) } % du format de son centre (limite { PERCENT($limit) } %) : { LIST($ids, most: 4) }.
