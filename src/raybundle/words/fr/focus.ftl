focus-calibrations_differ = Les étalonnages à deux mises au point ont des modèles ou paramètres différents.

focus-out_of_range = La mise au point à { $focus_m } m est hors de la plage étalonnée { $near_m } à { $far_m } m.
