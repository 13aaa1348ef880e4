scene_control-height_unit = Les altitudes d'appui semblent être en { $unit }, pas en mètres.

scene_control-image_axes = Les points d'appui tournent ou étirent l'image de { PERCENT($share) } % avec le biais { $model } (limite { PERCENT($limit) } %).
