micmac-affine_frame = Un repère affine du capteur (OrIntGlob) n'est pas pris en charge.

micmac-several_distortions = Plusieurs distorsions successives ne sont pas prises en charge.

micmac-model_count = Modèles de distorsion : { $n } ; il en faut un seul.

micmac-radial_count = La distorsion radiale a { $n } coefficients ; { $most } au plus.
