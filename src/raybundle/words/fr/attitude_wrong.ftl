attitude_wrong = { $n } attitude(s) contredisant les photographies jusqu'à { NUM($off_deg, decimals: 1) }°, écartée(s) : { $ids }.
