no_targets = Étalonné par points naturels : { $n } photographies examinées ne montrent ni cibles codées ni panneau.

no_targets-few = Étalonné par points naturels : moins de la moitié de { $n } photographies examinées montrent des cibles ({ $families }).

no_targets-unread = Aucune cible de { $families } n'a été lue dans les photographies.
