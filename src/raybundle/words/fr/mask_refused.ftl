mask_refused = Les masques de { LIST($ids, most: 3) } sont inutilisables ; les photographies sont utilisées entièrement.
