"""How grave a notice is: one table of codes, by which reports and command lines order, mark and grade."""

from __future__ import annotations

from collections.abc import Mapping

from raybundle.errors import Severity
from raybundle.observations import OfKinds, observation_kinds

_CODES = {
    Severity.FAULT: (
        "attitudes_contradict bars_contradict behind_camera camera_contradicts control_contradicts "
        "control_exchanged control_identical control_left_out control_mirrored control_not_located control_rejected "
        "control_unit epochs_names epochs_scale images_mirrored group_less_precise groups_contradict image_contradicts "
        "incomplete camera_constant_unknown mark_contradicts no_redundancy "
        "nominal_mirrored nominal_names nominal_scale not_determinable position_left_out positions_axes "
        "positions_distant positions_exchanged positions_unit redundancy_sum several_cameras "
        "snooping_masked snooping_unfinished weak_convergence"
    ),
    Severity.WARNING: (
        "approximate_values_replaced attitude_wrong attitudes_convergence attitudes_mount attitudes_nominal "
        "attitudes_steep attitudes_undecided blunder_not_located board_alike calibration_contradicted "
        "calibration_outweighed "
        "camera_constant camera_kept_apart camera_projection check_points_apart check_unseen control_file "
        "control_leaves_open control_not_observed control_sigma errors_independent "
        "control_without_photograph coordinate_system correlation cropped_photographs "
        "datum_lost distance_lost global_test gps_too_near "
        "held_not_determinable identical_images image_left_out lengths_contradict levelled line_alone "
        "little_redundancy "
        "mark_rejected marked_lost marked_once marks_left_out marks_not_adjusted "
        "marks_reduced marks_turned marks_untested mask_orientation mask_refused "
        "mask_uniform mirrored_photographs moved_ambiguous no_targets nominal_missing nominal_wrong "
        "one_ray_control outside_format parts_apart pixel_shape given_twice "
        "points_left_out positions_shifted rays_diverge read_out_unused relative_control repeated_structure "
        "residual_structure "
        "choice_unfinished result_unsettled rolling_shutter scale_unchecked scene_datum scene_prior small_angle "
        "approximate_scale relief_unknown start_behind "
        "start_parallel static_background systematic_residuals tables_not_read "
        "target_without_normal two_cameras unstable_camera unusual_errors up_ambiguous up_uncertain "
        "weak_photographs wrong_stations"
    ),
    Severity.NOTE: (
        "attitudes attitudes_reading axes_fitted camera camera_joined check_points_open "
        "control_unchecked dropped "
        "given_rejected gps "
        "in_parts masks memory_exceeded model not_significant parallel_rays parts_joined photographs place "
        "positions_assumed read_out reduced_features rejected relative_positions "
        "scale_checked scene_joins stored_turned target_eccentricity "
        "control_precise names_exchanged shape_held ties_mismatched "
        "snooping_robust target_radius wide_baselines up_by_edges up_without_edges variance_groups"
    ),
}

_CODE = {code: s for s, codes in _CODES.items() for code in codes.split()}
SEVERITY: Mapping[str, Severity] = OfKinds(
    lambda: {**_CODE, **{f"{kind}_suspect": Severity.FAULT for kind in observation_kinds}}
)
"""Severity of each code; `Notice.severity` may state another where it hangs on the numbers."""


def severity_of(code: str) -> Severity:
    """The severity of a code, or of its subject: that of `behind_camera` for `behind_camera.matches`."""
    return SEVERITY.get(code) or SEVERITY.get(code.partition(".")[0], Severity.WARNING)


POOR_FIT = 3.0
"""sigma0 beyond which the a-priori standard deviations alone do not explain the residuals: a fault.

They are guesses of a factor of two, as a rule; what is three times as large states that something else is wrong."""
NEARLY = 1.1
"""sigma0 up to which residuals of many observations are as stated for every use, whatever a test of their sum states.

A standard deviation from 50 redundant observations is uncertain by 10 % itself (GUM, table E.1), and two digits of it
suffice (7.2.6)."""
