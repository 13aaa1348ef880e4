gps_too_near = Les positions de { $n } photographies sont trop proches les unes des autres et ne sont pas utilisées.
