attitudes_contradict = Die Lagewinkel { $source ->
     [gimbal] des Gimbals
     *[other] aus { $source }
    } widersprechen den Aufnahmen und sind weggelassen.
    .why = Nach dem besten Einbau der Kamera streuen sie um { NUM($scatter_deg, decimals: 2) }° (Median); ihre Standardabweichung ist { NUM($sigma_deg, digits: 2) }°.
    .do = { $other ->
     [yes] Die Spalten nach der passenden Konvention benennen:
     *[no] Die Konvention der Lagewinkel ({ $reading }), die Aufnahmezeiten und die Zuordnung der Zeilen prüfen.
    }

attitudes_contradict-mounting = Der Einbau weicht um { NUM($off_deg, decimals: 0) }° von einer ganzen Zahl von Vierteldrehungen ab.

attitudes_contradict-reading = { $reading ->
     [opk] Omega, phi, kappa
     [phi_primary] Omega, phi, kappa mit phi als Primärdrehung
     [opk_inverse] Omega, phi, kappa der umgekehrten Drehung (Kamera zu Objekt)
     [opk_omega_phi_reversed] Omega, phi, kappa mit entgegengesetztem Vorzeichen von omega und phi
     [opk_kappa_reversed] Omega, phi, kappa mit entgegengesetztem Vorzeichen von kappa
     [rpy] Roll, pitch, yaw gegen Nord, Ost, unten
     [rpy_roll_reversed] Roll, pitch, yaw mit entgegengesetztem Vorzeichen von roll
     [rpy_pitch_reversed] Roll, pitch, yaw mit entgegengesetztem Vorzeichen von pitch
     [rpy_roll_pitch_reversed] Roll, pitch, yaw mit entgegengesetztem Vorzeichen von roll und pitch
     [pry] Pitch, roll, yaw (die ersten beiden vertauscht)
     [rpy_yaw_from_east] Roll, pitch, yaw mit yaw von Ost aus gegen den Uhrzeigersinn
     [gimbal] Yaw, pitch, roll der Kamera (Gimbal)
     [ypr] Yaw, pitch, roll des Flugzeugs
     *[gimbal_rpy] Roll, pitch, yaw der Kamera (Gimbal)
    }: Streuung { NUM($scatter_deg, decimals: 2) }°
