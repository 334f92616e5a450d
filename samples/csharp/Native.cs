// Made by generate.py from the public headers: every function of libwirecut-io and libwirecut.
using System;
using System.Runtime.InteropServices;

public enum wcut_bow_file { WCUT_BOW_FILE_FIGURES = 0, WCUT_BOW_FILE_STATIONS = 1, WCUT_BOW_FILE_MAP = 2, WCUT_BOW_FILE_CHART = 3 }
public enum wcut_brep_part { WCUT_BREP_PART_CUT = 0, WCUT_BREP_PART_SIDE_X0 = 1, WCUT_BREP_PART_SIDE_XW = 2, WCUT_BREP_PART_SIDE_Y0 = 3, WCUT_BREP_PART_SIDE_YL = 4, WCUT_BREP_PART_OPPOSITE = 5, WCUT_BREP_PART_KEY_FLANK = 6, WCUT_BREP_PART_KEY_TIP = 7, WCUT_BREP_PART_LUG = 8, WCUT_BREP_PART_FRAME = 9 }
public enum wcut_camera_kind { WCUT_CAMERA_KIND_PLANE = 0, WCUT_CAMERA_KIND_PINHOLE = 1, WCUT_CAMERA_KIND_FULL = 2 }
public enum wcut_channel { WCUT_CHANNEL_TIME = 0, WCUT_CHANNEL_STATION = 1, WCUT_CHANNEL_SPEED_A = 2, WCUT_CHANNEL_SPEED_B = 3, WCUT_CHANNEL_TENSION_A = 4, WCUT_CHANNEL_TENSION_B = 5, WCUT_CHANNEL_ALPHA_A = 6, WCUT_CHANNEL_BETA_A = 7, WCUT_CHANNEL_ALPHA_B = 8, WCUT_CHANNEL_BETA_B = 9, WCUT_CHANNEL_SPEED_COMMAND = 10, WCUT_CHANNEL_HEAT = 11, WCUT_CHANNEL_HEATER_VOLTAGE = 12, WCUT_CHANNEL_HEATER_CURRENT = 13, WCUT_CHANNEL_A_X = 14, WCUT_CHANNEL_A_Y = 15, WCUT_CHANNEL_A_Z = 16, WCUT_CHANNEL_B_X = 17, WCUT_CHANNEL_B_Y = 18, WCUT_CHANNEL_B_Z = 19, WCUT_CHANNEL_FORCE_X = 20, WCUT_CHANNEL_FORCE_Y = 21, WCUT_CHANNEL_FORCE_Z = 22, WCUT_CHANNEL_MOMENT_X = 23, WCUT_CHANNEL_MOMENT_Y = 24, WCUT_CHANNEL_MOMENT_Z = 25, WCUT_CHANNEL_SPEED = 26, WCUT_CHANNEL_TOOL_X = 27, WCUT_CHANNEL_TOOL_Y = 28, WCUT_CHANNEL_TOOL_Z = 29, WCUT_CHANNEL_COUNT = 30 }
public enum wcut_cloud_format { WCUT_CLOUD_FORMAT_ANY = 0, WCUT_CLOUD_FORMAT_PLY = 1, WCUT_CLOUD_FORMAT_TEXT = 2, WCUT_CLOUD_FORMAT_STL = 3, WCUT_CLOUD_FORMAT_LAS = 4, WCUT_CLOUD_FORMAT_PCD = 5, WCUT_CLOUD_FORMAT_OBJ = 6, WCUT_CLOUD_FORMAT_OFF = 7, WCUT_CLOUD_FORMAT_GLTF = 8, WCUT_CLOUD_FORMAT_PTX = 9, WCUT_CLOUD_FORMAT_COUNT = 10 }
public enum wcut_compare_distance { WCUT_COMPARE_DISTANCE_SURFACE = 0, WCUT_COMPARE_DISTANCE_MESH = 1, WCUT_COMPARE_DISTANCE_RECONSTRUCTION = 2, WCUT_COMPARE_DISTANCE_COUNT = 3 }
public enum wcut_condition { WCUT_CONDITION_TENSION = 0, WCUT_CONDITION_SPEED_MAX = 1, WCUT_CONDITION_SPEED_MIN = 2, WCUT_CONDITION_TIME = 3 }
public enum wcut_contradiction_kind { WCUT_CONTRADICTION_EXCITATION = 0, WCUT_CONTRADICTION_HEATER = 1, WCUT_CONTRADICTION_STATION = 2, WCUT_CONTRADICTION_SPEED = 3, WCUT_CONTRADICTION_PLACES = 4, WCUT_CONTRADICTION_TENSION_ZERO = 5, WCUT_CONTRADICTION_COUNT = 6 }
public enum wcut_control_state { WCUT_CONTROL_STATE_RUN = 0, WCUT_CONTROL_STATE_HOLD = 1, WCUT_CONTROL_STATE_STOP_TENSION = 2, WCUT_CONTROL_STATE_STOP_ABSURD = 3, WCUT_CONTROL_STATE_STOP_STALE = 4 }
public enum wcut_curve_format { WCUT_CURVE_FORMAT_ANY = 0, WCUT_CURVE_FORMAT_STEP = 1, WCUT_CURVE_FORMAT_IGES = 2, WCUT_CURVE_FORMAT_JSON = 3, WCUT_CURVE_FORMAT_CSV = 4, WCUT_CURVE_FORMAT_COUNT = 5 }
public enum wcut_design_feed { WCUT_DESIGN_FEED_AUTO = 0, WCUT_DESIGN_FEED_PLUS_Y = 1, WCUT_DESIGN_FEED_MINUS_Y = 2, WCUT_DESIGN_FEED_PLUS_X = 3, WCUT_DESIGN_FEED_MINUS_X = 4 }
public enum wcut_design_reason { WCUT_DESIGN_REASON_NONE = 0, WCUT_DESIGN_REASON_DOMED = 1, WCUT_DESIGN_REASON_TIGHT = 2, WCUT_DESIGN_REASON_ANGLE = 3, WCUT_DESIGN_REASON_PATTERN = 4 }
public enum wcut_direction { WCUT_DIRECTION_U = 0, WCUT_DIRECTION_V = 1 }
public enum wcut_dof_kind { WCUT_DOF_KIND_FREE = 0, WCUT_DOF_KIND_LOCKED = 1, WCUT_DOF_KIND_PRIOR = 2 }
public enum wcut_effect_kind { WCUT_EFFECT_WIRE_THERMAL_LAG = 0, WCUT_EFFECT_AIR_OVERHEATING = 1, WCUT_EFFECT_END_COOLING = 2, WCUT_EFFECT_FOAM_DENSITY_GRADIENT = 3, WCUT_EFFECT_FOAM_INCLUSION = 4, WCUT_EFFECT_TANGENTIAL_DRAG = 5, WCUT_EFFECT_WIRE_ELONGATION = 6, WCUT_EFFECT_MOUNT_COMPLIANCE = 7, WCUT_EFFECT_RATE_DEPENDENCE = 8, WCUT_EFFECT_SLICE_SOFTENING = 9, WCUT_EFFECT_WIRE_FOULING = 10, WCUT_EFFECT_EMPIRICAL_FORCE = 11, WCUT_EFFECT_WIRE_LENGTH = 12, WCUT_EFFECT_BLOCK_SHIFT = 13, WCUT_EFFECT_KERF_GROWTH = 14, WCUT_EFFECT_BLOCK_SPRINGBACK = 15, WCUT_EFFECT_ANGLE_OFFSET = 16, WCUT_EFFECT_TENSION_GAIN = 17, WCUT_EFFECT_TENSION_DRIFT = 18, WCUT_EFFECT_CLOCK_OFFSET = 19, WCUT_EFFECT_TENSION_DELAY = 20, WCUT_EFFECT_TENSION_ZERO = 21, WCUT_EFFECT_ANGLE_GAIN = 22, WCUT_EFFECT_ENCODER_FRICTION = 23, WCUT_EFFECT_EMPIRICAL_READING = 24, WCUT_EFFECT_SCAN_OFFSET = 25, WCUT_EFFECT_SCAN_SCALE = 26, WCUT_EFFECT_COUNT = 27 }
public enum wcut_effect_place { WCUT_EFFECT_PLACE_STEP = 0, WCUT_EFFECT_PLACE_FACE = 1, WCUT_EFFECT_PLACE_SENSOR = 2, WCUT_EFFECT_PLACE_SCAN = 3 }
public enum wcut_evidence_channel { WCUT_EVIDENCE_CHANNEL_SPEED = 0, WCUT_EVIDENCE_CHANNEL_TENSION = 1, WCUT_EVIDENCE_CHANNEL_ALPHA = 2, WCUT_EVIDENCE_CHANNEL_BETA = 3, WCUT_EVIDENCE_CHANNEL_SCAN = 4, WCUT_EVIDENCE_CHANNEL_FORCE = 5, WCUT_EVIDENCE_CHANNEL_COUNT = 6 }
public enum wcut_facade_field_kind { WCUT_FACADE_FIELD_CONSTANT = 0, WCUT_FACADE_FIELD_LINEAR = 1, WCUT_FACADE_FIELD_SINE = 2, WCUT_FACADE_FIELD_GRID = 3, WCUT_FACADE_FIELD_ATTRACTOR = 4 }
public enum wcut_facade_lattice { WCUT_FACADE_LATTICE_PLANE = 0, WCUT_FACADE_LATTICE_CYLINDER = 1, WCUT_FACADE_LATTICE_SURFACE = 2, WCUT_FACADE_LATTICE_FREE = 3 }
public enum wcut_facade_match { WCUT_FACADE_MATCH_NONE = 0, WCUT_FACADE_MATCH_EDGE = 1, WCUT_FACADE_MATCH_TANGENT = 2 }
public enum wcut_feasibility_verdict { WCUT_FEASIBILITY_VERDICT_FEASIBLE = 0, WCUT_FEASIBILITY_VERDICT_AT_LIMIT = 1, WCUT_FEASIBILITY_VERDICT_INFEASIBLE = 2 }
public enum wcut_feed_kind { WCUT_FEED_KIND_NONE = 0, WCUT_FEED_KIND_CONSTANT = 1, WCUT_FEED_KIND_STATIONS = 2, WCUT_FEED_KIND_TIME = 3 }
public enum wcut_integrator { WCUT_INTEGRATOR_IMPLICIT = 0, WCUT_INTEGRATOR_HEUN = 1 }
public enum wcut_lack_of_fit { WCUT_LACK_OF_FIT_UNTESTED = 0, WCUT_LACK_OF_FIT_REPLICATE = 1, WCUT_LACK_OF_FIT_FLEXIBLE = 2 }
public enum wcut_length_unit { WCUT_LENGTH_UNIT_MM = 0, WCUT_LENGTH_UNIT_CM = 1, WCUT_LENGTH_UNIT_M = 2, WCUT_LENGTH_UNIT_INCH = 3, WCUT_LENGTH_UNIT_FOOT = 4, WCUT_LENGTH_UNIT_DM = 5, WCUT_LENGTH_UNIT_UM = 6, WCUT_LENGTH_UNIT_COUNT = 7 }
public enum wcut_loss { WCUT_LOSS_SQUARE = 0, WCUT_LOSS_HUBER = 1, WCUT_LOSS_TUKEY = 2 }
public enum wcut_mesh_format { WCUT_MESH_FORMAT_ANY = 0, WCUT_MESH_FORMAT_STL = 1, WCUT_MESH_FORMAT_PLY = 2, WCUT_MESH_FORMAT_OBJ = 3, WCUT_MESH_FORMAT_OFF = 4, WCUT_MESH_FORMAT_GLTF = 5, WCUT_MESH_FORMAT_COUNT = 6 }
public enum wcut_mode { WCUT_MODE_PATH = 0, WCUT_MODE_DESIGN = 1 }
public enum wcut_motion { WCUT_MOTION_STATION = 0, WCUT_MOTION_POSITION = 1 }
public enum wcut_mould_part { WCUT_MOULD_PART_LOWER = 1, WCUT_MOULD_PART_UPPER = 2, WCUT_MOULD_PART_FRAME = 4, WCUT_MOULD_PART_CASTING = 8 }
public enum wcut_noise { WCUT_NOISE_RELATIVE = 0, WCUT_NOISE_ABSOLUTE = 1 }
public enum wcut_part { WCUT_PART_ALL = 0, WCUT_PART_ENTRY = 1, WCUT_PART_STEADY = 2, WCUT_PART_EXIT = 3, WCUT_PART_COUNT = 4 }
public enum wcut_phase { WCUT_PHASE_APPROACH = 0, WCUT_PHASE_ENTRY = 1, WCUT_PHASE_STEADY = 2, WCUT_PHASE_EXIT = 3, WCUT_PHASE_LEFT = 4 }
public enum wcut_place { WCUT_PLACE_INSIDE = 0, WCUT_PLACE_BORDER = 1, WCUT_PLACE_BEYOND = 2, WCUT_PLACE_AMBIGUOUS = 3, WCUT_PLACE_COUNT = 4 }
public enum wcut_registration_method { WCUT_REGISTRATION_METHOD_NONE = 0, WCUT_REGISTRATION_METHOD_DATUM = 1, WCUT_REGISTRATION_METHOD_FIT = 2 }
public enum wcut_report_mark { WCUT_REPORT_MARK_LINE = 0, WCUT_REPORT_MARK_DASHED = 1, WCUT_REPORT_MARK_POINTS = 2 }
public enum wcut_report_scale { WCUT_REPORT_SCALE_SEQUENTIAL = 0, WCUT_REPORT_SCALE_DIVERGING = 1 }
public enum wcut_report_tone { WCUT_REPORT_TONE_PLAIN = 0, WCUT_REPORT_TONE_GOOD = 1, WCUT_REPORT_TONE_WARNING = 2, WCUT_REPORT_TONE_BAD = 3 }
public enum wcut_result_state { WCUT_RESULT_STATE_WHOLE = 0, WCUT_RESULT_STATE_CHANGED = 1, WCUT_RESULT_STATE_MISSING = 2 }
public enum wcut_rig_kind { WCUT_RIG_KIND_TWO_ARMS = 0, WCUT_RIG_KIND_BOW = 1, WCUT_RIG_KIND_BLADE = 2 }
public enum wcut_robot_format { WCUT_ROBOT_FORMAT_URSCRIPT = 0, WCUT_ROBOT_FORMAT_RAPID = 1, WCUT_ROBOT_FORMAT_KRL = 2, WCUT_ROBOT_FORMAT_CSV = 3, WCUT_ROBOT_FORMAT_JSON = 4 }
public enum wcut_scatter_kind { WCUT_SCATTER_LEVEL = 0, WCUT_SCATTER_LEVEL_B = 1, WCUT_SCATTER_LENGTH = 2, WCUT_SCATTER_TENSION_ZERO = 3, WCUT_SCATTER_ENCODER_ZERO = 4, WCUT_SCATTER_FRICTION = 5, WCUT_SCATTER_FACE = 6, WCUT_SCATTER_SCAN_SHIFT = 7, WCUT_SCATTER_SCAN_TURN = 8, WCUT_SCATTER_COUNT = 9 }
public enum wcut_scored { WCUT_SCORED_SPEED = 0, WCUT_SCORED_TENSION = 1, WCUT_SCORED_ALPHA = 2, WCUT_SCORED_BETA = 3, WCUT_SCORED_SPEED_A = 4, WCUT_SCORED_SPEED_B = 5, WCUT_SCORED_TENSION_A = 6, WCUT_SCORED_TENSION_B = 7, WCUT_SCORED_ALPHA_A = 8, WCUT_SCORED_BETA_A = 9, WCUT_SCORED_ALPHA_B = 10, WCUT_SCORED_BETA_B = 11, WCUT_SCORED_COUNT = 12 }
public enum wcut_slip_column { WCUT_SLIP_COLUMN_NONE = 0, WCUT_SLIP_COLUMN_HEAT = 1, WCUT_SLIP_COLUMN_SPEED = 2, WCUT_SLIP_COLUMN_ENGAGED = 3, WCUT_SLIP_COLUMN_TENSION = 4, WCUT_SLIP_COLUMN_ALPHA = 5, WCUT_SLIP_COLUMN_COUNT = 6 }
public enum wcut_status { WCUT_OK = 0, WCUT_BAD_ARGUMENT = 1, WCUT_NO_MEMORY = 2, WCUT_NOT_CONVERGED = 3, WCUT_SINGULAR = 4, WCUT_DEGENERATE = 5, WCUT_NOT_FOUND = 6, WCUT_BAD_FORMAT = 7, WCUT_NOT_WRITTEN = 8, WCUT_INTERRUPTED = 9, WCUT_INTERNAL = 10, WCUT_STATUS_COUNT = 11 }
public enum wcut_step_schema { WCUT_STEP_SCHEMA_AP214 = 0, WCUT_STEP_SCHEMA_AP242 = 1, WCUT_STEP_SCHEMA_COUNT = 2 }
public enum wcut_sweep_state { WCUT_SWEEP_STATE_MISSING = 0, WCUT_SWEEP_STATE_DONE = 1, WCUT_SWEEP_STATE_OUTSIDE = 2, WCUT_SWEEP_STATE_NOT_CONVERGED = 3, WCUT_SWEEP_STATE_REFUSED = 4, WCUT_SWEEP_STATE_FAILED = 5, WCUT_SWEEP_STATE_CRASHED = 6, WCUT_SWEEP_STATE_COUNT = 7 }
public enum wcut_tool_frame { WCUT_TOOL_FRAME_FIXED = 0, WCUT_TOOL_FRAME_FOLLOWING = 1 }
public enum wcut_verdict_kind { WCUT_VERDICT_NONE = 0, WCUT_VERDICT_PHYSICS = 1, WCUT_VERDICT_INSTRUMENT = 2, WCUT_VERDICT_BOTH = 3, WCUT_VERDICT_AMBIGUOUS = 4, WCUT_VERDICT_UNKNOWN = 5, WCUT_VERDICT_COUNT = 6 }

[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_affine
{
    public wcut_vec3 x;
    public wcut_vec3 y;
    public wcut_vec3 z;
    public wcut_vec3 shift;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_bow_place
{
    public double value;
    public int station;
    public int node;
    public wcut_vec3 at;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_bow_results
{
    public int stations;
    public int nodes;
    public wcut_bow_row* row;
    public double* departure;
    public wcut_bow_place bow;
    public wcut_bow_place departure_max;
    public double tension_max;
    public int tension_station;
    public double force_max;
    public double moment_max;
    public double slack_share;
    public double temperature;
    public double strength;
    public wcut_feed_chart_row chart_0, chart_1, chart_2, chart_3, chart_4, chart_5, chart_6, chart_7, chart_8, chart_9, chart_10;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_bow_row
{
    public double bow;
    public int node;
    public double closing;
    public wcut_vec3 force;
    public wcut_vec3 moment;
    public double tension;
    public double departure_max;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_box
{
    public wcut_vec3 low;
    public wcut_vec3 high;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_brep
{
    public int vertex_count;
    public int edge_count;
    public int coedge_count;
    public int loop_count;
    public int face_count;
    public wcut_vec3* vertex;
    public wcut_brep_edge* edge;
    public wcut_brep_coedge* coedge;
    public wcut_brep_loop* loop;
    public wcut_brep_face* face;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_brep_coedge
{
    public int edge;
    public int reversed;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_brep_edge
{
    public int from;
    public int to;
    public wcut_curve* curve;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_brep_face
{
    public wcut_brep_part part;
    public wcut_surface* surface;
    public int same_sense;
    public wcut_vec3 origin;
    public wcut_vec3 normal;
    public int first_loop;
    public int loop_count;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_brep_loop
{
    public int first_coedge;
    public int coedge_count;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_calibration
{
    public wcut_law_fit force;
    public wcut_law_fit tension;
    public int tension_fitted;
    public double q_eff_low;
    public double q_eff_high;
    public int heats;
    public int speeds;
    public int q_effs;
    public int separable;
    public int large_angles;
    public double reference_force;
    public double reference_heat;
    public double reference_speed;
    public double reference_speed_error;
    public double exponent;
    public double exponent_error;
    public double correlation;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_calibration_options
{
    public wcut_noise noise;
    public wcut_loss loss;
    public double confidence;
    public double reference_force;
    public double reference_heat;
    public double alpha_large;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_calibration_point
{
    public double q_eff;
    public wcut_law_fit_point force;
    public wcut_law_fit_point tension;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_camera
{
    public wcut_camera_kind kind;
    public int width;
    public int height;
    public fixed double rotation[9];
    public wcut_vec3 centre;
    public double focal;
    public double k1;
    public double k2;
    public fixed double homography[9];
    public wcut_vec3 plane;
    public wcut_vec3 plane_x;
    public wcut_vec3 plane_y;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_camera_options
{
    public double pixel_sigma;
    public double rms_max;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_camera_report
{
    public int parameters;
    public int iterations;
    public double rms;
    public double sigma;
    public fixed double covariance[81];
    public double focal_sigma;
    public byte left_out;
    public int suspect;
    public double flatness;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_case
{
    public byte* name;
    public int cuts;
    public wcut_case_cut* cut;
    public byte* calibration;
    public wcut_recording_format format;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_case_cut
{
    public byte* job;
    public byte* recording;
    public byte* scan;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_clean_options
{
    public double duplicate;
    public double radius;
    public int radius_min;
    public int neighbours;
    public double deviations;
    public double factor_min;
    public int robust;
    public double voxel;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_clean_report
{
    public fixed int removed[5];
    public double centre;
    public double scale;
    public double limit;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_cloud
{
    public int count;
    public wcut_vec3* point;
    public wcut_vec3* normal;
    public wcut_cloud_info info;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_cloud_info
{
    public wcut_cloud_format format;
    public int has_normals;
    public double unit;
    public int stated;
    public int read;
    public int not_finite;
    public int withheld;
    public int thinned;
    public wcut_vec3 low;
    public wcut_vec3 high;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_cloud_options
{
    public wcut_cloud_format format;
    public wcut_length_unit unit;
    public byte* columns;
    public int max_points;
    public double voxel;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_cloud_unit
{
    public double ratio;
    public double factor;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_column
{
    public byte* name;
    public double* value;
    public byte* present;
    public int missing;
    public int text;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_column_map
{
    public wcut_channel channel;
    public byte* column;
    public double factor;
    public double offset;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_compare_options
{
    public wcut_length_unit unit;
    public wcut_length_unit reference_unit;
    public byte* columns;
    public byte flip;
    public wcut_compare_distance distance;
    public double chord_tolerance;
    public wcut_clean_options clean;
    public int hold;
    public wcut_registration_method method;
    public wcut_registration_options registration;
    public byte* datums;
    public int bands;
    public fixed double band[8];
    public double tolerance;
    public double share;
    public int normals;
    public byte reconstruct;
    public double support;
    public byte* zones;
    public byte* part;
    public byte* inspector;
    public byte* instrument;
    public byte* date;
    public byte feet;
    public int threads;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_compare_reference
{
    public byte* path;
    public byte* face;
    public byte* edges;
    public byte* force_law;
    public void* setup;
    public wcut_history* history;
    public wcut_mesh* mesh;
    public wcut_surface* surface;
    public byte* name;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_compare_result
{
    public wcut_compared compared;
    public wcut_report_compare page;
    public wcut_deviation* row;
    public wcut_vec3* normal;
    public double limit;
    public byte streamed;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_compare_scan
{
    public byte* path;
    public int count;
    public wcut_vec3* point;
    public byte* name;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_compare_watch
{
    public IntPtr progress;
    public IntPtr warn;
    public void* context;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_compared
{
    public byte* reference;
    public byte* distance;
    public byte* part;
    public byte* inspector;
    public byte* instrument;
    public byte* date;
    public byte* datum_file;
    public wcut_clean_options* cleaning;
    public int scans;
    public wcut_compared_scan* scan;
    public fixed int removed[5];
    public wcut_registration* registration;
    public int datums;
    public wcut_datum_residual* datum;
    public wcut_deviation_summary_result* found;
    public wcut_deviation_summary_result* unmoved;
    public wcut_statistics* face_to_scan;
    public double resolution;
    public double kerf;
    public int has_kerf;
    public double unmeasured;
    public double support;
    public double tolerance;
    public double share;
    public int within;
    public byte* zones_file;
    public wcut_survey_result* survey;
    public byte* reconstruction_method;
    public wcut_reconstruction* reconstruction;
    public wcut_statistics* to_scan;
    public wcut_statistics* to_face;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_compared_scan
{
    public byte* name;
    public byte* sha256;
    public int read;
    public int not_finite;
    public int withheld;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_comparison
{
    public int samples;
    public wcut_phase* phase;
    public byte* counted;
    public int counted_samples;
    public double contact;
    public double leave;
    public double from;
    public double to;
    public wcut_prediction* planned;
    public wcut_prediction* replayed;
    public wcut_scores planned_score;
    public wcut_scores replayed_score;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_comparison_options
{
    public wcut_replay_options replay;
    public double tolerance;
    public double settle;
    public double leave;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_compensation
{
    public wcut_job* job;
    public double before_rms;
    public double before_max;
    public double after_rms;
    public double after_max;
    public int used;
    public int strays;
    public int uncovered;
    public int branch;
    public int runs;
    public int rounds;
    public wcut_design_round* round;
    public int stations;
    public double* nearer;
    public double* lag;
    public double* rise_a;
    public double* rise_b;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_compensation_result
{
    public byte* job;
    public byte* with;
    public byte* target;
    public wcut_compensation* compensation;
    public int interval;
    public double spread;
    public double smaller_rms;
    public double smaller_before;
    public double larger_rms;
    public double larger_before;
    public double worth;
    public int effects;
    public wcut_effect* effect;
    public double* moved;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_contradiction
{
    public wcut_contradiction_kind kind;
    public fixed byte column[32];
    public int cuts;
    public fixed int cut[64];
    public double found;
    public double expected;
    public double error;
    public fixed byte unit[8];
    public byte fault;
    public byte common;
    public byte repaired;
    public fixed byte text[480];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_control_settings
{
    public byte feedback;
    public double tension;
    public double exponent_speed;
    public double gain;
    public double rate;
    public double filter;
    public double authority;
    public double speed_min;
    public double speed_max;
    public double acceleration;
    public double caution;
    public double margin;
    public double noise;
    public double tension_stop;
    public double tension_absurd;
    public double fault_time;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_control_view
{
    public wcut_control_state state;
    public double speed;
    public double planned;
    public double tension;
    public double error;
    public double correction;
    public int dropped;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_correction
{
    public double a;
    public double b;
    public double length_change;
    public double kerf;
    public double kerf_per_q;
    public int effects;
    public wcut_effect effect_0, effect_1, effect_2, effect_3, effect_4, effect_5, effect_6, effect_7;
    public int intervals;
    public double kerf_per_q_low;
    public double kerf_per_q_high;
    public wcut_effect low_0, low_1, low_2, low_3, low_4, low_5, low_6, low_7;
    public wcut_effect high_0, high_1, high_2, high_3, high_4, high_5, high_6, high_7;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_crossing
{
    public int first;
    public int second;
    public wcut_vec3 point;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_curve
{
    public int degree;
    public int control_count;
    public double* knots;
    public wcut_vec3* control;
    public double* weights;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_curve_foot
{
    public double u;
    public wcut_vec3 point;
    public double distance;
    public double gap;
    public int beyond;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_curve_loft_report
{
    public int used;
    public int dropped;
    public int nodes;
    public double section_error;
    public int closed;
    public int turned;
    public int first_turned;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_curve_read_options
{
    public wcut_curve_format format;
    public int interpolate;
    public int max_curves;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_curve_set
{
    public wcut_curve_format format;
    public int count;
    public wcut_curve** curve;
    public byte** name;
    public int left_out;
    public fixed byte why[240];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_cut_options
{
    public wcut_integrator integrator;
    public double tolerance;
    public int max_iterations;
    public int max_halvings;
    public byte weighted;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_datum_face
{
    public wcut_vec3 point;
    public wcut_vec3 normal;
    public double sigma;
    public int count;
    public wcut_vec3* scan;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_datum_pair
{
    public wcut_vec3 scan;
    public wcut_vec3 block;
    public double sigma;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_datum_residual
{
    public int is_face;
    public int datum;
    public wcut_vec3 moved;
    public wcut_vec3 offset;
    public double distance;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_datums
{
    public int pairs;
    public int faces;
    public wcut_datum_pair* pair;
    public wcut_datum_face* face;
    public wcut_vec3* point;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_dependence
{
    public fixed byte quantity[40];
    public wcut_evidence_channel channel;
    public wcut_estimate coefficient;
    public double gain;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_design
{
    public wcut_job* job;
    public wcut_job* path;
    public wcut_design_feed feed;
    public fixed double turn[12];
    public double rms;
    public double max;
    public double path_rms;
    public double path_max;
    public double unpolished_rms;
    public double start_rms;
    public int used;
    public int strays;
    public int uncovered;
    public int runs;
    public int rounds;
    public wcut_design_round* round;
    public int points;
    public wcut_vec3* point;
    public int stations;
    public double* lag;
    public double* sag;
    public double* extra;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_design_joint
{
    public int first;
    public int second;
    public int places;
    public double step_rms;
    public double step_max;
    public double angle_rms;
    public double angle_max;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_design_map
{
    public wcut_design_feed feed;
    public double predicted_rms;
    public double predicted_max;
    public fixed double feed_rms[5];
    public double domed_share;
    public int rows;
    public int columns;
    public wcut_vec3* point;
    public double* bow;
    public double* gauss;
    public byte* reason;
    public fixed double share[5];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_design_options
{
    public wcut_design_feed feed;
    public int free_edges;
    public double tolerance;
    public double angle_max;
    public int unknowns_max;
    public int threads;
    public byte* name;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_design_panel
{
    public wcut_vec3 low;
    public wcut_vec3 high;
    public double predicted_rms;
    public wcut_design* design;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_design_panels
{
    public int across;
    public int along;
    public int count;
    public wcut_design_panel* panel;
    public int joints;
    public wcut_design_joint* joint;
    public double rms;
    public double max;
    public int runs;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_design_result
{
    public byte* target;
    public double tolerance;
    public wcut_design_map* map;
    public wcut_design* design;
    public wcut_design_panels* panels;
    public double face_rms;
    public double face_max;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_design_round
{
    public int stations;
    public int nodes;
    public int unknowns;
    public int runs;
    public double rms;
    public double max;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_deviation
{
    public double distance;
    public wcut_vec3 foot;
    public double u;
    public double v;
    public int triangle;
    public wcut_place place;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_deviation_options
{
    public wcut_vec3 low;
    public wcut_vec3 high;
    public double border;
    public double reach;
    public int flip;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_deviation_summary_options
{
    public wcut_vec3 low;
    public wcut_vec3 high;
    public double patch;
    public double cell;
    public int bands;
    public fixed double band[8];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_deviation_summary_result
{
    public wcut_statistics statistics;
    public fixed int place[4];
    public int zones;
    public wcut_zone* zone;
    public int worsts;
    public wcut_worst* worst;
    public wcut_split split;
    public int related;
    public wcut_relation time;
    public wcut_relation path;
    public wcut_relation bend;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_diagnosis
{
    public wcut_verdict_kind kind;
    public double confidence;
    public double confidence_by;
    public fixed byte sentence[900];
    public byte form_open;
    public int effects;
    public wcut_found_effect effect_0, effect_1, effect_2, effect_3;
    public int small_effects;
    public wcut_small_effect small_effect;
    public wcut_estimate a;
    public wcut_estimate b;
    public wcut_estimate length_change;
    public wcut_estimate kerf;
    public double a_job;
    public double b_job;
    public double swift;
    public double droop;
    public double adequacy;
    public double adequacy_p;
    public int hypotheses;
    public wcut_hypothesis* hypothesis;
    public int contradictions;
    public wcut_contradiction* contradiction;
    public int mismatches;
    public wcut_mismatch* mismatch;
    public int dependences;
    public wcut_dependence* dependence;
    public wcut_modelled modelled;
    public wcut_diagnosis_view view;
    public int traces;
    public wcut_residual_trace* trace;
    public int rig_rows;
    public wcut_rig_row* rig;
    public int cuts;
    public byte* held_out;
    public wcut_evidence_score score_0, score_1, score_2, score_3, score_4, score_5, score_6, score_7, score_8, score_9, score_10, score_11, score_12, score_13, score_14, score_15, score_16, score_17, score_18, score_19, score_20, score_21, score_22, score_23;
    public wcut_evidence_score held_out_score_0, held_out_score_1, held_out_score_2, held_out_score_3, held_out_score_4, held_out_score_5, held_out_score_6, held_out_score_7, held_out_score_8, held_out_score_9, held_out_score_10, held_out_score_11, held_out_score_12, held_out_score_13, held_out_score_14, held_out_score_15, held_out_score_16, held_out_score_17, held_out_score_18, held_out_score_19, held_out_score_20, held_out_score_21, held_out_score_22, held_out_score_23;
    public wcut_correction correction;
    public fixed byte withheld[160];
    public wcut_job* improved;
    public wcut_job* next_experiment;
    public fixed byte next_reason[900];
    public int limits;
    public byte** limit;
    public fixed double noise[6];
    public fixed byte unprofiled[120];
    public fixed byte unproven[120];
    public byte naive_false;
    public fixed byte naive[80];
    public byte interrupted;
    public fixed byte stopped[80];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_diagnosis_cut
{
    public wcut_job* job;
    public wcut_recording* recording;
    public wcut_cloud* scan;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_diagnosis_options
{
    public int threads;
    public fixed byte without[27];
    public byte proof;
    public byte naive;
    public ulong seed;
    public wcut_rig_prior* rig;
    public wcut_recording* still;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_diagnosis_view
{
    public int cut;
    public double time;
    public wcut_vec3 block;
    public int rows;
    public int nodes;
    public wcut_vec3* surface;
    public int worst;
    public int points;
    public wcut_vec3* point;
    public double* distance;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_dither
{
    public double amplitude;
    public double period;
    public double phase;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_dof
{
    public wcut_dof_kind kind;
    public double value;
    public double sigma;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_doubt
{
    public wcut_channel channel;
    public double ratio;
    public byte certain;
    public wcut_error error;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_effect
{
    public wcut_effect_kind kind;
    public int choice;
    public fixed double value[6];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_effect_info
{
    public byte* name;
    public wcut_effect_place place;
    public byte* choice_key;
    public byte choice_required;
    public byte** choice;
    public int strengths;
    public double neutral;
    public byte repeats;
    public byte needs_mounts;
    public wcut_effect_parameter* parameter;
    public byte* equation;
    public byte* source;
    public byte* where;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_effect_parameter
{
    public byte* key;
    public int at;
    public int size;
    public byte required;
    public double initial;
    public double min;
    public double max;
    public double low;
    public double high;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_element
{
    public wcut_job* job;
    public double* border_0, border_1, border_2, border_3;
    public byte upper;
    public wcut_element_options options;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_element_face
{
    public wcut_vec3 block;
    public wcut_surface* surface;
    public wcut_vec3* point;
    public double* force;
    public double* moved;
    public double* cut_0, cut_1, cut_2, cut_3;
    public double moved_max;
    public double fit_error;
    public double radius_min;
    public double volume;
    public double area;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_element_options
{
    public double thickness;
    public double density;
    public byte moulds;
    public double chord_tolerance;
    public byte* formats;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_equilibrium_options
{
    public double tolerance;
    public int max_iterations;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_equilibrium_report
{
    public double strain;
    public double unbalance;
    public int iterations;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_error
{
    public wcut_status status;
    public fixed byte text[480];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_estimate
{
    public double value;
    public double low;
    public double high;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_event
{
    public int cut;
    public fixed double time[2];
    public fixed double station[2];
    public double tension;
    public double force;
    public double heat;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_evidence_score
{
    public int count;
    public double rmsd;
    public double rmse;
    public double nrmsd;
    public double rmse_over_range;
    public double low;
    public double high;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_facade
{
    public wcut_facade_match match;
    public int rows;
    public int columns;
    public int elements;
    public wcut_facade_element* element;
    public int joints;
    public wcut_facade_joint* joint;
    public double moved;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_facade_description
{
    public byte* name;
    public wcut_facade* facade;
    public int variants;
    public byte** variant_name;
    public int* variant;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_facade_element
{
    public int row;
    public int column;
    public int turn;
    public byte mirrored;
    public wcut_vec3 origin;
    public wcut_vec3 x;
    public wcut_vec3 y;
    public wcut_vec3 z;
    public wcut_job* job;
    public double* border_0, border_1, border_2, border_3;
    public fixed int joint[4];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_facade_field
{
    public wcut_facade_field_kind kind;
    public double value;
    public fixed double slope[2];
    public double amplitude;
    public double period;
    public double direction;
    public double phase;
    public int rows;
    public int columns;
    public double* grid;
    public int points;
    public double* place;
    public double radius;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_facade_item
{
    public int distinct;
    public fixed byte hash[65];
    public wcut_sweep_state state;
    public byte feasible;
    public fixed byte reason[240];
    public double duration;
    public double speed_min;
    public double speed_max;
    public double radius_min;
    public double foam_lower;
    public double foam_upper;
    public double area;
    public double moved_max;
    public double panel_volume;
    public double panel_mass;
    public wcut_element_face* face;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_facade_joint
{
    public fixed int element[2];
    public fixed int border[2];
    public byte reversed;
    public double opening_min;
    public double opening_max;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_facade_placement
{
    public int row;
    public int column;
    public int turn;
    public byte mirrored;
    public int job;
    public wcut_vec3 origin;
    public wcut_vec3 x;
    public wcut_vec3 y;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_facade_plan
{
    public wcut_facade_lattice lattice;
    public int rows;
    public int columns;
    public double radius;
    public wcut_surface* surface;
    public double joint;
    public wcut_facade_match match;
    public double match_move;
    public int placements;
    public wcut_facade_placement* placement;
    public int jobs;
    public wcut_job** job;
    public int heights;
    public wcut_facade_field* height;
    public int extras;
    public wcut_facade_field* extra;
    public double overrun;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_facade_results
{
    public wcut_facade_description* description;
    public int distinct;
    public wcut_facade_item* item;
    public wcut_element_face** face;
    public wcut_joint_report* joint;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_face
{
    public wcut_surface* surface;
    public wcut_vec3 low;
    public wcut_vec3 high;
    public int stations;
    public int nodes;
    public double* parameter;
    public double* begin;
    public double* end;
    public wcut_vec3* point;
    public double* v;
    public byte* inside;
    public double* force;
    public double* curvature;
    public double* half_kerf;
    public double* time;
    public double* path_bend;
    public wcut_phase* phase;
    public int dropped;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_face_map
{
    public int rows;
    public int columns;
    public double* sum;
    public double* weight;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_fdm_options
{
    public double tolerance;
    public int max_rounds;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_fdm_report
{
    public double strain;
    public int rounds;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_feasibility
{
    public wcut_feasibility_verdict verdict;
    public int station;
    public double radius_min;
    public fixed byte reason[240];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_feed
{
    public wcut_feed_kind kind;
    public int count;
    public double* speed;
    public double* time;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_feed_chart_row
{
    public double heat;
    public double temperature;
    public byte too_hot;
    public double strength;
    public fixed double feed[3];
    public fixed double kerf[3];
    public fixed double tension[3];
    public fixed double allowed[3];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_foot
{
    public double u;
    public double v;
    public wcut_vec3 point;
    public double distance;
    public double height;
    public double gap;
    public int beyond;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_force_law
{
    public double a;
    public double b;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_found_effect
{
    public wcut_effect effect;
    public wcut_estimate parameter_0, parameter_1, parameter_2, parameter_3, parameter_4, parameter_5;
    public fixed byte estimated[6];
    public int cut;
    public byte present;
    public double confidence;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_frame
{
    public wcut_vec3 point;
    public wcut_vec3 tangent;
    public wcut_vec3 normal;
    public wcut_vec3 binormal;
    public double curvature;
    public double torsion;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_half
{
    public wcut_mesh* mesh;
    public byte* cut;
    public double* draft;
    public wcut_brep* brep;
    public wcut_half_report report;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_half_report
{
    public int closed;
    public int oriented;
    public int self_intersections;
    public int pieces;
    public double volume;
    public double area;
    public double cut_area;
    public wcut_vec3 box_low;
    public wcut_vec3 box_high;
    public double draft_min;
    public wcut_vec3 draft_place;
    public double undercut_area;
    public double wall_min;
    public wcut_vec3 wall_place;
    public double edge_min;
    public wcut_vec3 edge_place;
    public int wall_held;
    public int draft_held;
    public double key_volume;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_heat_step
{
    public double from;
    public double to;
    public double factor;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_history
{
    public int stations;
    public int planned;
    public int nodes;
    public wcut_history_row* row;
    public wcut_vec3* position;
    public wcut_vec3* force;
    public double* force_line;
    public double* speed;
    public wcut_error ended;
    public double* tension;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_history_row
{
    public double time;
    public double duration;
    public double speed_a;
    public double speed_b;
    public double tension_a;
    public double tension_b;
    public double alpha_a;
    public double beta_a;
    public double alpha_b;
    public double beta_b;
    public double engaged_length;
    public double residual;
    public int iterations;
    public int substeps;
    public wcut_phase phase;
    public wcut_condition condition;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_hole
{
    public double area;
    public wcut_vec3 centre;
    public int open;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_hypothesis
{
    public int count;
    public wcut_effect effect_0, effect_1;
    public int parameters;
    public double gain;
    public double held_out;
    public double adequacy;
    public double probability;
    public byte* why;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_job
{
    public byte* name;
    public byte* foam_material;
    public byte* wire_material;
    public wcut_vec3 block_size;
    public double wire_diameter;
    public double wire_density;
    public double wire_cold_strength;
    public double wire_hot_strength;
    public double wire_emissivity;
    public double wire_length;
    public int nodes;
    public double heat;
    public double tension;
    public wcut_force_law force_law;
    public wcut_tension_law tension_law;
    public double speed_max;
    public double speed_min;
    public double kerf_width;
    public double kerf_per_q;
    public wcut_rig rig;
    public wcut_feed feed;
    public wcut_mode mode;
    public int stations;
    public wcut_vec3* mount_a;
    public wcut_vec3* mount_b;
    public wcut_pose* tool;
    public wcut_vec3 mount_a_in_tool;
    public wcut_vec3 mount_b_in_tool;
    public wcut_curve* edge_a;
    public wcut_curve* edge_b;
    public int extra_count;
    public double* extra_u;
    public double* extra_length;
    public double clearance;
    public double overrun;
    public int dither_count;
    public wcut_dither* dither;
    public int heat_step_count;
    public wcut_heat_step* heat_step;
    public int effect_count;
    public wcut_effect* effect;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_joint_report
{
    public double gap_max;
    public double step_max;
    public double angle_min;
    public double angle_median;
    public double angle_max;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_key
{
    public int upper;
    public double x;
    public double y;
    public double radius;
    public double tip_radius;
    public double height;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_law_fit
{
    public double a;
    public double b;
    public double c;
    public fixed double standard_error[3];
    public fixed double low[3];
    public fixed double high[3];
    public fixed double covariance[9];
    public fixed double correlation[9];
    public int c_held;
    public double scale;
    public int degrees;
    public double leave_one_out;
    public int left_out;
    public wcut_lack_of_fit lack;
    public fixed int lack_degrees[2];
    public double lack_f;
    public double lack_p;
    public double evidence;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_law_fit_point
{
    public double measured;
    public double fitted;
    public double residual;
    public double loss_weight;
    public double left_out;
    public double relative;
    public double leverage;
    public double influence;
    public int unusual;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_loft_report
{
    public int used;
    public int dropped;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_mesh
{
    public int vertex_count;
    public int triangle_count;
    public wcut_vec3* vertex;
    public wcut_vec3* normal;
    public double* uv;
    public double* scalar;
    public int* triangle;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_mesh_foot
{
    public wcut_vec3 point;
    public double distance;
    public double height;
    public double b;
    public double c;
    public int triangle;
    public int border;
    public int beyond;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_mesh_object
{
    public wcut_mesh* mesh;
    public byte* name;
    public byte* material;
    public byte* marked_material;
    public byte* mark;
    public uint colour;
    public uint marked_colour;
    public int turned;
    public wcut_vec3 move;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_mesh_read_info
{
    public wcut_mesh_format format;
    public int collapsed;
    public int split;
    public wcut_vec3 low;
    public wcut_vec3 high;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_mesh_read_options
{
    public wcut_mesh_format format;
    public wcut_length_unit unit;
    public int max_triangles;
    public int seconds;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_mesh_tree_info
{
    public int border_edges;
    public int nonmanifold_edges;
    public int flat;
    public double area;
    public wcut_vec3 area_sum;
    public wcut_vec3 low;
    public wcut_vec3 high;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_mismatch
{
    public int cut;
    public wcut_evidence_channel channel;
    public fixed byte column[24];
    public fixed double time[2];
    public fixed double station[2];
    public fixed double wire[2];
    public wcut_vec3 block_0, block_1;
    public double mean;
    public double share;
    public double p_value;
    public fixed byte regime[16];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_modelled
{
    public int terms;
    public wcut_found_effect term_0, term_1, term_2;
    public fixed byte equation[240];
    public int rivals;
    public fixed byte rival[320];
    public int events;
    public wcut_event event_0, event_1, event_2, event_3, event_4, event_5, event_6, event_7, event_8, event_9, event_10, event_11, event_12, event_13, event_14, event_15, event_16, event_17, event_18, event_19, event_20, event_21, event_22, event_23;
    public double recalibrated;
    public double after;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_mould
{
    public wcut_half lower;
    public wcut_half upper;
    public wcut_mesh* frame;
    public wcut_brep* frame_brep;
    public double frame_volume;
    public wcut_mesh* kerf;
    public double kerf_volume;
    public double block_volume;
    public double volume_error;
    public double fit_error;
    public double chord_error;
    public double prolonged_entry;
    public double prolonged_exit;
    public double prolonged_side;
    public double radius_min;
    public wcut_vec3 radius_place;
    public double kerf_min;
    public double kerf_max;
    public double thickness;
    public int lugs;
    public double scale;
    public double wire_radius;
    public double wall_asked;
    public double draft_asked;
    public wcut_vec3 pull;
    public int by_boolean;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_mould_options
{
    public double chord_tolerance;
    public double fit_tolerance;
    public double prolong;
    public double kerf;
    public int kerf_stations;
    public int kerf_nodes;
    public double* kerf_parameter;
    public double* kerf_field;
    public int key_count;
    public wcut_key* key;
    public double thickness;
    public double lug_radius;
    public double lug_height;
    public double lug_clearance;
    public double frame_wall;
    public double frame_clearance;
    public double scale;
    public wcut_vec3 pull;
    public double wire_diameter;
    public double wall_asked;
    public double draft_asked;
    public wcut_mesh* stock;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_normals_options
{
    public int neighbours;
    public wcut_vec3 side;
    public double steep;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_normals_report
{
    public int undefined;
    public int propagated;
    public int guessed;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_offset_report
{
    public double error;
    public double curvature;
    public double tight_u;
    public double tight_v;
    public int folds;
    public int crossings;
    public fixed double crossing_u[2];
    public fixed double crossing_v[2];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_overlaid
{
    public byte* job;
    public byte* photo;
    public byte* job_sha256;
    public byte* photo_sha256;
    public wcut_vec3 block;
    public wcut_picture_source* source;
    public wcut_camera* camera;
    public wcut_camera_report* report;
    public int points;
    public wcut_photo_point* point;
    public double* residual;
    public double* leave_one_out;
    public wcut_history* history;
    public wcut_overlay* overlay;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_overlay
{
    public double resolution;
    public double covered;
    public wcut_picture* rectified;
    public int columns;
    public int rows;
    public wcut_rill_patch* patch;
    public int readable;
    public int worst_count;
    public fixed int worst[10];
    public double readable_share;
    public wcut_rill_phase phase_0, phase_1, phase_2, phase_3, phase_4;
    public int curve_count;
    public wcut_rill_curve* curve;
    public int differing;
    public double noise;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_overlay_options
{
    public byte upper;
    public double resolution;
    public double patch;
    public int curves;
    public int threads;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_overlay_style
{
    public byte by_force;
    public double width;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_panel
{
    public wcut_mesh* mesh;
    public wcut_brep* solid;
    public double volume;
    public double area;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_path_near
{
    public double distance;
    public double station;
    public wcut_vec3 place;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_photo_point
{
    public double u;
    public double v;
    public wcut_vec3 place;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_picture
{
    public int width;
    public int height;
    public int channels;
    public byte* pixel;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_picture_source
{
    public int orientation;
    public int depth;
    public byte profile;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_pose
{
    public wcut_vec3 at;
    public fixed double turn[4];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_prediction
{
    public int samples;
    public byte* present;
    public double* value_0, value_1, value_2, value_3, value_4, value_5, value_6, value_7;
    public int without_motion;
    public int standing;
    public int failed;
    public int first_failed;
    public wcut_error cause;
    public double scatter;
    public int iterations;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_range
{
    public double min;
    public double max;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_reconstruction
{
    public wcut_mesh* mesh;
    public wcut_mesh* unmeasured;
    public wcut_hole* hole;
    public int hole_count;
    public double point_spacing;
    public double spacing;
    public double smoothing;
    public int used;
    public int beyond;
    public double area;
    public double supported_area;
    public double lost;
    public double unmeasured_area;
    public double farthest;
    public double rms;
    public int iterations;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_reconstruction_options
{
    public double support;
    public double spacing;
    public double smoothing;
    public wcut_vec3 block;
    public wcut_mesh* mesh;
    public double hole_min;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_recording
{
    public int samples;
    public wcut_column channel_0, channel_1, channel_2, channel_3, channel_4, channel_5, channel_6, channel_7, channel_8, channel_9, channel_10, channel_11, channel_12, channel_13, channel_14, channel_15, channel_16, channel_17, channel_18, channel_19, channel_20, channel_21, channel_22, channel_23, channel_24, channel_25, channel_26, channel_27, channel_28, channel_29;
    public wcut_table* further;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_recording_format
{
    public int maps;
    public wcut_column_map* map;
    public double period;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_region
{
    public fixed byte name[64];
    public wcut_vec3 low;
    public wcut_vec3 high;
    public int corners;
    public double* corner;
    public double tolerance;
    public double share;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_region_result
{
    public int count;
    public double mean;
    public double std;
    public double rms;
    public double mae;
    public double min;
    public double max;
    public double within;
    public fixed double within_band[8];
    public int passed;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_regions
{
    public int regions;
    public wcut_region* region;
    public int sections;
    public wcut_section* section;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_registration
{
    public wcut_registration_method method;
    public fixed double matrix[16];
    public wcut_vec3 pivot;
    public fixed double parameter[6];
    public fixed double covariance[36];
    public fixed int determined[6];
    public int free;
    public int rank;
    public int iterations;
    public int converged;
    public double step;
    public double doubt;
    public int points;
    public int kept;
    public double overlap;
    public double noise;
    public double rms;
    public double rms_before;
    public double rival;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_registration_options
{
    public wcut_dof dof_0, dof_1, dof_2, dof_3, dof_4, dof_5;
    public int pivot_given;
    public wcut_vec3 pivot;
    public double noise;
    public double keep;
    public int coarse;
    public int max_points;
    public double sensitivity;
    public double tolerance;
    public int max_iterations;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_relation
{
    public double of_deviation;
    public double of_size;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_replay_options
{
    public wcut_motion motion;
    public double window;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_report
{
    public byte* verb;
    public byte* title;
    public wcut_report_tone tone;
    public byte* verdict;
    public int fact_count;
    public wcut_report_fact* fact;
    public wcut_report_scene* scene;
    public int section_count;
    public wcut_report_section* section;
    public int source_count;
    public wcut_report_source* source;
    public int option_count;
    public wcut_report_fact* option;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_report_calibrate
{
    public byte* path;
    public byte* weights;
    public int cuts;
    public wcut_test_cut* cut;
    public wcut_calibration_options* options;
    public wcut_calibration* fit;
    public wcut_calibration_point* point;
    public int warnings;
    public byte** warning;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_report_cases
{
    public int rows;
    public int columns;
    public int parameters;
    public wcut_report_column* column;
    public int* number;
    public byte** link;
    public int goal;
    public byte highest;
    public int best_count;
    public int* best;
    public byte* called;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_report_chart
{
    public byte* title;
    public byte* note;
    public byte* x_label_0, x_label_1;
    public byte* x_unit_0, x_unit_1;
    public byte* y_label;
    public byte* y_unit;
    public int series_count;
    public wcut_report_series* series;
    public int span_count;
    public wcut_report_span* span;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_report_column
{
    public byte* label;
    public byte* unit;
    public double* number;
    public byte** text;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_report_compare
{
    public wcut_compared* compared;
    public byte* title;
    public byte* reference_sha256;
    public wcut_face* face;
    public int stations;
    public wcut_vec3* mount_a;
    public wcut_vec3* mount_b;
    public wcut_mesh* mesh;
    public double* value;
    public byte* present;
    public int points;
    public wcut_vec3* point;
    public double* deviation;
    public double spacing;
    public byte* unit;
    public double border;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_report_design
{
    public byte* title;
    public wcut_vec3 block;
    public wcut_design_result* result;
    public wcut_history* history;
    public double* deviation;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_report_diagnose
{
    public byte* title;
    public wcut_diagnosis* diagnosis;
    public byte** cut_name;
    public int said;
    public byte** said_text;
    public int options;
    public wcut_report_fact* option;
    public int sources;
    public wcut_report_source* source;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_report_fact
{
    public byte* label;
    public byte* text;
    public double value;
    public byte* unit;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_report_field
{
    public byte* label;
    public byte* unit;
    public wcut_report_scale scale;
    public double tolerance;
    public double* value;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_report_line
{
    public byte* group;
    public byte* label;
    public int count;
    public wcut_vec3* point;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_report_map
{
    public byte* title;
    public byte* note;
    public byte* x_label;
    public byte* x_unit;
    public byte* y_label;
    public byte* y_unit;
    public byte* label;
    public byte* unit;
    public int columns;
    public int rows;
    public double* x;
    public double* y;
    public double* value;
    public wcut_report_scale scale;
    public double limit;
    public byte blank_missing;
    public int bands;
    public int* band;
    public byte** band_label;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_report_mould
{
    public byte* job_path;
    public byte* stock_path;
    public byte* edges_path;
    public double chord_tolerance;
    public double fit_tolerance;
    public double prolong;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_report_scene
{
    public byte* title;
    public byte* note;
    public wcut_vec3 block_size;
    public int shape_count;
    public wcut_report_shape* shape;
    public int line_count;
    public wcut_report_line* line;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_report_score
{
    public byte* title;
    public int cuts;
    public wcut_scored_cut* cut;
    public int groups;
    public byte** group_name;
    public wcut_scores* planned;
    public wcut_scores* replayed;
    public byte* group_label;
    public wcut_comparison_options* options;
    public int nodes;
    public int sources;
    public wcut_report_source* source;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_report_section
{
    public byte* title;
    public byte* note;
    public int chart_count;
    public int map_count;
    public int table_count;
    public wcut_report_chart* chart;
    public wcut_report_map* map;
    public wcut_report_table* table;
    public wcut_report_cases* cases;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_report_series
{
    public byte* label;
    public wcut_report_mark mark;
    public int count;
    public double* x_0, x_1;
    public double* y;
    public double* low;
    public double* high;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_report_shape
{
    public byte* name;
    public int vertex_count;
    public wcut_vec3* vertex;
    public int rows;
    public int columns;
    public byte* row_label;
    public byte* column_label;
    public int triangle_count;
    public int* triangle;
    public int field_count;
    public wcut_report_field* field;
    public int* part;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_report_simulate
{
    public byte* job_path;
    public byte* integrator;
    public double chord_tolerance;
    public double merge;
    public wcut_status ended;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_report_source
{
    public byte* role;
    public byte* name;
    public byte* sha256;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_report_span
{
    public byte* label;
    public fixed double from[2];
    public fixed double to[2];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_report_table
{
    public byte* title;
    public byte* note;
    public int rows;
    public int columns;
    public wcut_report_column* column;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_residual_trace
{
    public int cut;
    public wcut_evidence_channel channel;
    public fixed byte column[24];
    public int count;
    public double* time;
    public double* station;
    public double* measured;
    public double* before;
    public double* recalibrated;
    public double* after;
    public double noise;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_rig
{
    public wcut_rig_kind kind;
    public double pretension;
    public double stiffness;
    public double wire_stiffness;
    public double expansion;
    public byte force_in_block;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_rig_figures
{
    public double from;
    public double to;
    public double mean;
    public double rms;
    public double max;
    public double settled;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_rig_options
{
    public double law_a;
    public double law_b;
    public double density;
    public double density_from;
    public double delay;
    public double lag;
    public double noise_tension;
    public double noise_angle;
    public double noise_speed;
    public double noise_position;
    public ulong seed;
    public double period;
    public int decimation;
    public byte excitation;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_rig_prior
{
    public fixed double scatter[9];
    public double tension_delay;
    public double angle_delay;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_rig_row
{
    public fixed byte name[32];
    public wcut_estimate value;
    public int cuts;
    public fixed int cut[64];
    public wcut_estimate of_cut_0, of_cut_1, of_cut_2, of_cut_3, of_cut_4, of_cut_5, of_cut_6, of_cut_7, of_cut_8, of_cut_9, of_cut_10, of_cut_11, of_cut_12, of_cut_13, of_cut_14, of_cut_15, of_cut_16, of_cut_17, of_cut_18, of_cut_19, of_cut_20, of_cut_21, of_cut_22, of_cut_23, of_cut_24, of_cut_25, of_cut_26, of_cut_27, of_cut_28, of_cut_29, of_cut_30, of_cut_31, of_cut_32, of_cut_33, of_cut_34, of_cut_35, of_cut_36, of_cut_37, of_cut_38, of_cut_39, of_cut_40, of_cut_41, of_cut_42, of_cut_43, of_cut_44, of_cut_45, of_cut_46, of_cut_47, of_cut_48, of_cut_49, of_cut_50, of_cut_51, of_cut_52, of_cut_53, of_cut_54, of_cut_55, of_cut_56, of_cut_57, of_cut_58, of_cut_59, of_cut_60, of_cut_61, of_cut_62, of_cut_63;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_rig_run
{
    public wcut_recording recording;
    public double* tension;
    public double* planned;
    public wcut_phase* phase;
    public wcut_control_state* state;
    public double* beyond;
    public int room;
    public wcut_control_state ended;
    public byte complete;
    public double duration;
    public double target;
    public double overshoot;
    public byte has_steady;
    public byte has_density;
    public wcut_rig_figures steady;
    public wcut_rig_figures density;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_rig_summary
{
    public wcut_job* job;
    public wcut_control_settings* control;
    public wcut_rig_options* options;
    public wcut_rig_run* feedback;
    public wcut_rig_run* plan;
    public byte plan_recorded;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_rill_curve
{
    public int station;
    public int count;
    public wcut_rill_node* node;
    public int readable;
    public double range;
    public double range_sigma;
    public byte differs;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_rill_node
{
    public wcut_vec3 place;
    public byte readable;
    public double deviation;
    public double sigma;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_rill_patch
{
    public wcut_vec3 place;
    public double station;
    public double wire;
    public byte readable;
    public double angle;
    public double sigma;
    public double systematic;
    public double coherence;
    public double contrast;
    public double covered;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_rill_phase
{
    public int patches;
    public int readable;
    public double median;
    public double sigma;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_robot_check
{
    public byte* name;
    public byte* unit;
    public double value;
    public double limit;
    public int station;
    public byte over;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_robot_limits
{
    public double speed;
    public double acceleration;
    public double alpha;
    public double beta;
    public double ambient;
    public double emissivity;
    public double temperature;
    public double cold_strength;
    public double hot_strength;
    public double hot_temperature;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_robot_motion
{
    public byte single;
    public int count;
    public wcut_robot_target* target;
    public int stations;
    public int first;
    public int last;
    public double lead_out;
    public double chord_error;
    public double time_error;
    public double duration;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_robot_names
{
    public byte* title;
    public byte* program;
    public byte* wire_on;
    public byte* wire_off;
    public byte* wire_heat;
    public int sync_io;
    public double approach_speed;
    public double approach_acceleration;
    public double preheat;
    public double heat;
    public double tension;
    public double wire_length;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_robot_options
{
    public double chord_tolerance;
    public double time_tolerance;
    public double angle_tolerance;
    public double lead_in;
    public double lead_out;
    public double zone;
    public wcut_tool_frame frame;
    public wcut_job* heater;
    public wcut_job* clear;
    public wcut_job* tool;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_robot_summary
{
    public wcut_job* job;
    public wcut_robot_motion* motion;
    public wcut_robot_check* check;
    public wcut_path_near* near;
    public wcut_robot_format format;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_robot_target
{
    public int station;
    public double time;
    public double duration;
    public wcut_vec3 a;
    public wcut_vec3 b;
    public double speed_a;
    public double speed_b;
    public double zone_a;
    public double zone_b;
    public fixed double frame_a[4];
    public fixed double frame_b[4];
    public double heat;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_score
{
    public int count;
    public double bias;
    public double rmsd;
    public double rmse;
    public double range;
    public double nrmsd;
    public double rmse_over_range;
    public double correlation;
    public byte correlated;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_scored_cut
{
    public byte* of_case;
    public byte* name;
    public byte* job;
    public byte* recording;
    public wcut_recording* samples;
    public wcut_comparison* comparison;
    public wcut_error* error;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_scores
{
    public wcut_score of_0, of_1, of_2, of_3, of_4, of_5, of_6, of_7, of_8, of_9, of_10, of_11, of_12, of_13, of_14, of_15, of_16, of_17, of_18, of_19, of_20, of_21, of_22, of_23, of_24, of_25, of_26, of_27, of_28, of_29, of_30, of_31, of_32, of_33, of_34, of_35, of_36, of_37, of_38, of_39, of_40, of_41, of_42, of_43, of_44, of_45, of_46, of_47;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_section
{
    public fixed byte name[64];
    public int points;
    public double* point;
    public double width;
    public double step;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_section_result
{
    public int rows;
    public wcut_section_row* row;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_section_row
{
    public double along;
    public double x;
    public double y;
    public int count;
    public double nominal;
    public double measured;
    public double deviation;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_setup_span
{
    public int stations;
    public int part_first;
    public int part_last;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_shape
{
    public byte* name;
    public wcut_brep* solid;
    public wcut_surface* surface;
    public wcut_curve* curve;
    public int coloured;
    public uint colour;
    public uint cut_colour;
    public uint key_colour;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_slip
{
    public int cut;
    public wcut_slip_column column;
    public double factor;
    public double ratio;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_slurm
{
    public byte* program;
    public int tasks;
    public int cpus;
    public byte* partition;
    public byte* time;
    public byte* memory;
    public byte* modules;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_small_effect
{
    public wcut_found_effect found;
    public double gain;
    public double tension;
    public double face;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_split
{
    public double offset;
    public double offset_error;
    public double form_rms;
    public double noise_rms;
    public double cell;
    public int cells;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_station
{
    public int index;
    public double time;
    public double duration;
    public int nodes;
    public wcut_vec3* position;
    public wcut_vec3* force;
    public double* force_line;
    public double* speed;
    public double* tension;
    public double* engaged;
    public wcut_vec3 mount_a;
    public wcut_vec3 mount_b;
    public double speed_a;
    public double speed_b;
    public double tension_a;
    public double tension_b;
    public double alpha_a;
    public double beta_a;
    public double alpha_b;
    public double beta_b;
    public double engaged_length;
    public wcut_phase phase;
    public wcut_condition condition;
    public int iterations;
    public int substeps;
    public double residual;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_statistics
{
    public int count;
    public double mean;
    public double std;
    public double rms;
    public double mae;
    public double median;
    public double p01;
    public double p05;
    public double p95;
    public double p99;
    public double min;
    public double max;
    public double hausdorff;
    public double profile;
    public int positive;
    public int negative;
    public double positive_mean;
    public double negative_mean;
    public int bands;
    public fixed double band[8];
    public fixed double within[8];
    public fixed double over[8];
    public fixed double under[8];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_step_place
{
    public byte* name;
    public int shape;
    public wcut_vec3 origin;
    public wcut_vec3 x;
    public wcut_vec3 z;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_study_info
{
    public byte* name;
    public byte* verb;
    public int cases;
    public int parameters;
    public byte** parameter;
    public int figures;
    public byte** figure;
    public byte** pointer;
    public int best;
    public byte best_is_highest;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_summary
{
    public double duration;
    public wcut_range speed;
    public double speed_median;
    public wcut_range alpha;
    public wcut_range beta;
    public wcut_range tension;
    public double force_line_max;
    public double residual_max;
    public double iterations_mean;
    public int iterations_max;
    public double substeps_mean;
    public int substeps_max;
    public fixed int conditions[4];
    public fixed int phases[5];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_surface
{
    public int degree_u;
    public int degree_v;
    public int count_u;
    public int count_v;
    public double* knots_u;
    public double* knots_v;
    public wcut_vec3* control;
    public double* weights;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_surface_fit_report
{
    public double node_error;
    public double between_error;
    public int control_count;
    public int node_count;
    public int used;
    public int dropped;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_surface_report
{
    public int closed_u;
    public int closed_v;
    public int poles;
    public int folds;
    public double fold_u;
    public double fold_v;
    public int crossings;
    public fixed double crossing_u[2];
    public fixed double crossing_v[2];
    public double chord_error;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_survey_result
{
    public wcut_regions* of;
    public int bands;
    public wcut_region_result* region;
    public wcut_section_result* section;
    public int passed;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_sweep_counts
{
    public int cases;
    public fixed int state[7];
    public int ran;
    public double seconds;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_sweep_options
{
    public byte* program;
    public byte* word;
    public int jobs;
    public int share;
    public int shares;
    public int limit;
    public IntPtr progress;
    public void* context;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_table
{
    public int rows;
    public int columns;
    public wcut_column* column;
    public int* line;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_tangent_frame
{
    public wcut_vec3 point;
    public wcut_vec3 normal;
    public double gauss;
    public double mean;
    public double larger;
    public double smaller;
    public wcut_vec3 along;
    public wcut_vec3 across;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_tension_law
{
    public double a;
    public double b;
    public double c;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_tessellation_report
{
    public double chord_error;
    public int rows;
    public int columns;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_test_cut
{
    public double heat;
    public double speed;
    public double engaged;
    public double tension_a;
    public double tension_b;
    public double alpha_a;
    public double alpha_b;
    public double weight;
    public int line;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_trace
{
    public int count;
    public int closed;
    public int face;
    public wcut_vec3* point;
    public double* uv;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_traces
{
    public int count;
    public wcut_trace* trace;
    public int touching;
    public double touch_u;
    public double touch_v;
    public int loose;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_trimmed
{
    public wcut_surface* surface;
    public int loops;
    public int* first;
    public wcut_vec3* point;
    public double* uv;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_trimmed_set
{
    public wcut_curve_format format;
    public int count;
    public wcut_trimmed** face;
    public byte** name;
    public int left_out;
    public fixed byte why[240];
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_vec3
{
    public double x;
    public double y;
    public double z;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_verification
{
    public int vouchers;
    public int count;
    public int broken;
    public wcut_verified_file* file;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_verified_file
{
    public byte* voucher;
    public byte* name;
    public wcut_result_state state;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_wire_material
{
    public byte* name;
    public double modulus;
    public double expansion;
    public double cold_strength;
    public double hot_strength;
    public double hot_temperature;
    public double emissivity;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_worst
{
    public wcut_vec3 place;
    public wcut_vec3 low;
    public wcut_vec3 high;
    public double area;
    public double volume;
    public double mean;
    public double peak;
    public int count;
}
[StructLayout(LayoutKind.Sequential)]
public unsafe struct wcut_zone
{
    public fixed byte name[32];
    public int is_patch;
    public wcut_vec3 low;
    public wcut_vec3 high;
    public int count;
    public double mean;
    public double std;
    public double rms;
    public double mae;
    public double min;
    public double max;
    public fixed double within[8];
}

public static unsafe class Native
{
    [DllImport("wirecut-io")] public static extern byte* wcut_bow_file_name(wcut_bow_file a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_bow_results_create(void* a0, wcut_history* a1, wcut_robot_limits* a2, wcut_bow_results** a3, wcut_error* a4);
    [DllImport("wirecut-io")] public static extern void wcut_bow_results_destroy(wcut_bow_results* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_bow_results_write(wcut_bow_results* a0, wcut_history* a1, wcut_bow_file a2, byte* a3, wcut_error* a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_calibration_fit(int a0, wcut_test_cut* a1, wcut_calibration_options* a2, wcut_calibration* a3, wcut_calibration_point* a4, wcut_error* a5);
    [DllImport("wirecut-io")] public static extern wcut_calibration_options wcut_calibration_options_default();
    [DllImport("wirecut-io")] public static extern wcut_status wcut_calibration_slips(int a0, wcut_test_cut* a1, wcut_calibration_options* a2, int* a3, wcut_slip* a4, wcut_error* a5);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_calibration_table_read(byte* a0, byte* a1, int* a2, wcut_test_cut** a3, wcut_error* a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_camera_fit(int a0, wcut_photo_point* a1, int a2, int a3, wcut_camera_options* a4, wcut_camera* a5, wcut_camera_report* a6, double* a7, double* a8, wcut_error* a9);
    [DllImport("wirecut-io")] public static extern wcut_camera_options wcut_camera_options_default();
    [DllImport("wirecut-io")] public static extern wcut_status wcut_camera_project(wcut_camera* a0, int a1, wcut_vec3* a2, double* a3, double* a4);
    [DllImport("wirecut-io")] public static extern void wcut_case_destroy(wcut_case* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_case_read(byte* a0, wcut_case** a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern byte* wcut_channel_name(wcut_channel a0);
    [DllImport("wirecut-io")] public static extern wcut_clean_options wcut_clean_options_default();
    [DllImport("wirecut-io")] public static extern wcut_status wcut_cloud_clean(int a0, wcut_vec3* a1, wcut_clean_options* a2, int a3, byte* a4, wcut_clean_report* a5);
    [DllImport("wirecut-io")] public static extern void wcut_cloud_destroy(wcut_cloud* a0);
    [DllImport("wirecut-io")] public static extern int wcut_cloud_keep(int a0, byte* a1, wcut_vec3* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_cloud_locate(int a0, wcut_vec3* a1, int a2, wcut_vec3* a3, int a4, double* a5);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_cloud_normals(int a0, wcut_vec3* a1, wcut_normals_options* a2, int a3, wcut_vec3* a4, wcut_normals_report* a5);
    [DllImport("wirecut-io")] public static extern wcut_cloud_options wcut_cloud_options_default();
    [DllImport("wirecut-io")] public static extern wcut_status wcut_cloud_read(byte* a0, wcut_cloud_options* a1, wcut_cloud** a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_cloud_source_create(byte* a0, wcut_cloud_options* a1, void** a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern void wcut_cloud_source_destroy(void* a0);
    [DllImport("wirecut-io")] public static extern wcut_cloud_info* wcut_cloud_source_info(void* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_cloud_source_next(void* a0, int a1, wcut_vec3* a2, wcut_vec3* a3, int* a4, wcut_error* a5);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_cloud_span(int a0, wcut_vec3* a1, int* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_cloud_unit_eval(wcut_vec3 a0, wcut_vec3 a1, wcut_vec3 a2, wcut_cloud_unit* a3);
    [DllImport("wirecut-io")] public static extern void wcut_compare_destroy(wcut_compare_result* a0);
    [DllImport("wirecut-io")] public static extern int wcut_compare_files(wcut_compare_result* a0, byte** a1);
    [DllImport("wirecut-io")] public static extern wcut_compare_options wcut_compare_options_default();
    [DllImport("wirecut-io")] public static extern wcut_status wcut_compare_run(wcut_compare_reference* a0, int a1, wcut_compare_scan* a2, wcut_compare_options* a3, void* a4, wcut_compare_watch* a5, wcut_compare_result** a6, wcut_error* a7);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_compare_write(wcut_compare_result* a0, void* a1, byte** a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_comparison_create(wcut_job* a0, wcut_recording* a1, wcut_comparison_options* a2, wcut_comparison** a3, wcut_error* a4);
    [DllImport("wirecut-io")] public static extern void wcut_comparison_destroy(wcut_comparison* a0);
    [DllImport("wirecut-io")] public static extern wcut_comparison_options wcut_comparison_options_default();
    [DllImport("wirecut-io")] public static extern wcut_status wcut_comparison_run(int a0, wcut_job** a1, wcut_recording** a2, wcut_comparison_options* a3, IntPtr a4, void* a5, wcut_comparison** a6, wcut_error* a7);
    [DllImport("wirecut-io")] public static extern void wcut_compensation_destroy(wcut_compensation* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_compensation_fit(void* a0, wcut_job* a1, wcut_design_options* a2, IntPtr a3, void* a4, wcut_compensation** a5, wcut_error* a6);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_compensation_measure(void* a0, wcut_job* a1, int a2, double* a3, double* a4, wcut_error* a5);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_compensation_print(wcut_compensation_result* a0, byte** a1);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_compensation_say(wcut_compensation_result* a0, int a1, byte* a2);
    [DllImport("wirecut-io")] public static extern byte* wcut_condition_name(wcut_condition a0);
    [DllImport("wirecut-io")] public static extern byte* wcut_contradiction_name(wcut_contradiction_kind a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_control_create(wcut_control_settings* a0, wcut_history* a1, void** a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern void wcut_control_destroy(void* a0);
    [DllImport("wirecut-io")] public static extern void wcut_control_look(void* a0, wcut_control_view* a1);
    [DllImport("wirecut-io")] public static extern wcut_control_settings wcut_control_settings_default(wcut_job* a0);
    [DllImport("wirecut-io")] public static extern byte* wcut_control_state_name(wcut_control_state a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_control_step(void* a0, double a1, double a2, double a3, double a4, double* a5);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_correction_apply(wcut_correction* a0, wcut_job* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_correction_read(byte* a0, wcut_correction* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_curve_bounds(wcut_curve* a0, double a1, wcut_box* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_curve_clearance(wcut_curve* a0, wcut_box* a1, double a2, double* a3, double* a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_curve_create(int a0, int a1, double* a2, wcut_vec3* a3, double* a4, wcut_curve** a5);
    [DllImport("wirecut-io")] public static extern void wcut_curve_destroy(wcut_curve* a0);
    [DllImport("wirecut-io")] public static extern void wcut_curve_domain(wcut_curve* a0, double* a1, double* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_curve_elevate(wcut_curve* a0, int a1, wcut_curve** a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_curve_eval(wcut_curve* a0, double a1, int a2, wcut_vec3* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_curve_frame(wcut_curve* a0, double a1, wcut_frame* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_curve_insert_knot(wcut_curve* a0, double a1, int a2, wcut_curve** a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_curve_interpolate(int a0, wcut_vec3* a1, wcut_curve** a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_curve_interpolate_at(int a0, wcut_vec3* a1, double* a2, wcut_vec3* a3, wcut_vec3* a4, wcut_curve** a5);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_curve_join(int a0, wcut_curve** a1, double a2, wcut_curve** a3, double* a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_curve_length(wcut_curve* a0, double a1, double a2, double* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_curve_locate(wcut_curve* a0, int a1, wcut_vec3* a2, int a3, wcut_curve_foot* a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_curve_locate_length(wcut_curve* a0, double a1, double* a2);
    [DllImport("wirecut-io")] public static extern wcut_curve_read_options wcut_curve_read_options_default();
    [DllImport("wirecut-io")] public static extern wcut_status wcut_curve_remove_knots(wcut_curve* a0, double a1, wcut_curve** a2, double* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_curve_reverse(wcut_curve* a0, wcut_curve** a1);
    [DllImport("wirecut-io")] public static extern void wcut_curve_set_destroy(wcut_curve_set* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_curve_set_read(byte* a0, wcut_curve_read_options* a1, wcut_curve_set** a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_curve_split(wcut_curve* a0, double a1, wcut_curve** a2, wcut_curve** a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_curve_transform(wcut_curve* a0, wcut_affine* a1, wcut_curve** a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_cut_create(void* a0, void** a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern void wcut_cut_destroy(void* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_cut_drive(void* a0, wcut_vec3 a1, wcut_vec3 a2, double a3, double a4, wcut_error* a5);
    [DllImport("wirecut-io")] public static extern wcut_cut_options wcut_cut_options_default();
    [DllImport("wirecut-io")] public static extern wcut_status wcut_cut_step(void* a0, wcut_error* a1);
    [DllImport("wirecut-io")] public static extern void wcut_cut_view(void* a0, wcut_station* a1);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_datum_residual_eval(wcut_registration* a0, int a1, wcut_datum_pair* a2, int a3, wcut_datum_face* a4, wcut_datum_residual* a5);
    [DllImport("wirecut-io")] public static extern void wcut_datums_destroy(wcut_datums* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_datums_read(byte* a0, wcut_datums** a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern void wcut_design_destroy(wcut_design* a0);
    [DllImport("wirecut-io")] public static extern byte* wcut_design_feed_name(wcut_design_feed a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_design_fit(void* a0, wcut_job* a1, wcut_design_options* a2, IntPtr a3, void* a4, wcut_design** a5, wcut_error* a6);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_design_map_create(void* a0, wcut_job* a1, wcut_design_options* a2, wcut_design_map** a3, wcut_error* a4);
    [DllImport("wirecut-io")] public static extern void wcut_design_map_destroy(wcut_design_map* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_design_map_write_png(wcut_design_map* a0, double a1, byte* a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern wcut_design_options wcut_design_options_default();
    [DllImport("wirecut-io")] public static extern void wcut_design_panels_destroy(wcut_design_panels* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_design_panels_fit(void* a0, wcut_job* a1, wcut_design_options* a2, int a3, double a4, IntPtr a5, void* a6, wcut_design_panels** a7, wcut_error* a8);
    [DllImport("wirecut-io")] public static extern byte* wcut_design_reason_name(wcut_design_reason a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_design_result_print(wcut_design_result* a0, byte** a1);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_design_result_say(wcut_design_result* a0, int a1, byte* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_design_result_write(wcut_design_result* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern void wcut_design_target_destroy(void* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_design_target_from_faces(int a0, wcut_trimmed** a1, wcut_vec3 a2, void** a3, wcut_error* a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_design_target_from_mesh(wcut_mesh* a0, wcut_vec3 a1, void** a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_design_target_from_points(int a0, wcut_vec3* a1, wcut_vec3 a2, void** a3, wcut_error* a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_design_target_from_surface(wcut_surface* a0, wcut_vec3 a1, void** a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_deviation_from_mesh(void* a0, int a1, wcut_vec3* a2, wcut_deviation_options* a3, int a4, wcut_deviation* a5);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_deviation_from_surface(void* a0, int a1, wcut_vec3* a2, wcut_deviation_options* a3, int a4, wcut_deviation* a5, wcut_foot* a6);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_deviation_from_trimmed(wcut_trimmed* a0, void* a1, int a2, wcut_vec3* a3, wcut_deviation_options* a4, int a5, wcut_deviation* a6, wcut_foot* a7);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_deviation_mesh_write_obj(wcut_mesh* a0, double* a1, byte* a2, double a3, byte* a4, wcut_error* a5);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_deviation_mesh_write_ply(wcut_mesh* a0, double* a1, byte* a2, double a3, byte* a4, wcut_error* a5);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_deviation_onto_surface(wcut_mesh* a0, int a1, wcut_deviation* a2);
    [DllImport("wirecut-io")] public static extern wcut_deviation_options wcut_deviation_options_default();
    [DllImport("wirecut-io")] public static extern wcut_status wcut_deviation_print(wcut_compared* a0, byte** a1);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_deviation_stream_append(void* a0, int a1, wcut_vec3* a2, wcut_vec3* a3, wcut_deviation* a4, wcut_error* a5);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_deviation_stream_commit(void* a0, wcut_error* a1);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_deviation_stream_create(byte* a0, double a1, int a2, void** a3, wcut_error* a4);
    [DllImport("wirecut-io")] public static extern void wcut_deviation_stream_destroy(void* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_deviation_summary_add(void* a0, int a1, wcut_deviation* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_deviation_summary_create(wcut_deviation_summary_options* a0, wcut_face* a1, void** a2);
    [DllImport("wirecut-io")] public static extern void wcut_deviation_summary_destroy(void* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_deviation_summary_eval(void* a0, wcut_deviation_summary_result** a1);
    [DllImport("wirecut-io")] public static extern wcut_deviation_summary_options wcut_deviation_summary_options_default();
    [DllImport("wirecut-io")] public static extern wcut_status wcut_deviation_write(wcut_compared* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_diagnosis_create(int a0, wcut_diagnosis_cut* a1, int a2, wcut_test_cut* a3, wcut_diagnosis_options* a4, IntPtr a5, void* a6, wcut_diagnosis** a7, wcut_error* a8);
    [DllImport("wirecut-io")] public static extern void wcut_diagnosis_destroy(wcut_diagnosis* a0);
    [DllImport("wirecut-io")] public static extern wcut_diagnosis_options wcut_diagnosis_options_default();
    [DllImport("wirecut-io")] public static extern wcut_status wcut_diagnosis_print(wcut_diagnosis* a0, byte* a1, byte** a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_diagnosis_write(wcut_diagnosis* a0, byte* a1, byte* a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern wcut_effect wcut_effect_choose(wcut_effect_kind a0, int a1);
    [DllImport("wirecut-io")] public static extern wcut_effect wcut_effect_default(wcut_effect_kind a0);
    [DllImport("wirecut-io")] public static extern byte wcut_effect_is_neutral(wcut_effect* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_effect_locate(byte* a0, wcut_effect_kind* a1);
    [DllImport("wirecut-io")] public static extern wcut_effect_parameter* wcut_effect_parameters(wcut_effect* a0);
    [DllImport("wirecut-io")] public static extern wcut_effect_info* wcut_effect_view(wcut_effect_kind a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_effects_check(int a0, wcut_effect* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern void wcut_element_destroy(wcut_element* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_element_face_create(wcut_surface* a0, wcut_vec3 a1, double** a2, int a3, int a4, wcut_vec3* a5, double* a6, wcut_element_face** a7, wcut_error* a8);
    [DllImport("wirecut-io")] public static extern void wcut_element_face_destroy(wcut_element_face* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_element_face_interpolate(wcut_vec3 a0, double* a1, wcut_element_face** a2);
    [DllImport("wirecut-io")] public static extern wcut_element_options wcut_element_options_default();
    [DllImport("wirecut-io")] public static extern wcut_status wcut_element_read(byte* a0, wcut_element** a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_element_result_print(wcut_element* a0, void* a1, wcut_history* a2, wcut_element_face* a3, wcut_panel* a4, byte* a5, byte** a6);
    [DllImport("wirecut-io")] public static extern wcut_equilibrium_options wcut_equilibrium_options_default();
    [DllImport("wirecut-io")] public static extern wcut_status wcut_equilibrium_solve(int a0, wcut_vec3* a1, double* a2, wcut_equilibrium_options* a3, wcut_vec3* a4, double* a5, wcut_equilibrium_report* a6);
    [DllImport("wirecut-io")] public static extern byte* wcut_evidence_name(wcut_evidence_channel a0);
    [DllImport("wirecut-io")] public static extern byte* wcut_evidence_unit(wcut_evidence_channel a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_facade_create(wcut_facade_plan* a0, wcut_facade** a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern void wcut_facade_description_destroy(wcut_facade_description* a0);
    [DllImport("wirecut-io")] public static extern void wcut_facade_destroy(wcut_facade* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_facade_field_eval(int a0, wcut_facade_field* a1, double* a2, double a3, double a4, double* a5);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_facade_points(wcut_facade* a0, wcut_element_face** a1, wcut_vec3* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_facade_print(wcut_facade_results* a0, byte** a1);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_facade_read(byte* a0, wcut_facade_description** a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern void wcut_facade_results_destroy(wcut_facade_results* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_facade_results_read(wcut_facade_description* a0, wcut_element_options* a1, void* a2, wcut_facade_results** a3, wcut_error* a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_facade_sweep_create(wcut_facade_description* a0, wcut_element_options* a1, byte* a2, void** a3, wcut_error* a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_facade_write_csv(wcut_facade_results* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_facade_write_glb(wcut_facade_results* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_facade_write_step(wcut_facade_results* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_face_create(wcut_job* a0, wcut_history* a1, wcut_vec3* a2, wcut_vec3* a3, double a4, wcut_face** a5);
    [DllImport("wirecut-io")] public static extern void wcut_face_destroy(wcut_face* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_face_eval(int a0, wcut_effect* a1, wcut_vec3 a2, int a3, wcut_vec3* a4, double* a5, wcut_vec3* a6);
    [DllImport("wirecut-io")] public static extern double wcut_face_kerf(wcut_face* a0);
    [DllImport("wirecut-io")] public static extern void wcut_face_locate(wcut_face* a0, double a1, double a2, double* a3, double* a4);
    [DllImport("wirecut-io")] public static extern void wcut_face_map_add(wcut_face_map* a0, wcut_face* a1, int a2, wcut_deviation* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_face_map_create(wcut_face* a0, wcut_face_map** a1);
    [DllImport("wirecut-io")] public static extern void wcut_face_map_destroy(wcut_face_map* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_face_map_eval(wcut_face_map* a0, wcut_face* a1, double a2, double* a3, byte* a4, double* a5);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_face_mesh(wcut_face* a0, wcut_mesh** a1);
    [DllImport("wirecut-io")] public static extern wcut_fdm_options wcut_fdm_options_default();
    [DllImport("wirecut-io")] public static extern wcut_status wcut_fdm_solve(int a0, wcut_vec3* a1, double* a2, wcut_fdm_options* a3, double* a4, wcut_vec3* a5, wcut_fdm_report* a6);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_feasibility_eval(wcut_job* a0, wcut_history* a1, wcut_vec3* a2, wcut_vec3* a3, wcut_robot_limits* a4, wcut_feasibility* a5, double* a6);
    [DllImport("wirecut-io")] public static extern byte* wcut_feasibility_name(wcut_feasibility_verdict a0);
    [DllImport("wirecut-io")] public static extern double* wcut_feed_chart_bows();
    [DllImport("wirecut-io")] public static extern wcut_status wcut_feed_eval(wcut_feed* a0, int a1, double a2, double a3, double* a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_file_hash(byte* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern double wcut_force_law_eval(wcut_force_law* a0, double a1, double a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_force_law_print(int a0, wcut_test_cut* a1, wcut_calibration_options* a2, wcut_calibration* a3, wcut_calibration_point* a4, byte** a5);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_force_law_speed(wcut_force_law* a0, double a1, double a2, double* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_force_law_write(int a0, wcut_test_cut* a1, wcut_calibration_options* a2, wcut_calibration* a3, wcut_calibration_point* a4, byte* a5, wcut_error* a6);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_format_read(byte* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_gaussian_scores(int a0, double* a1, double* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_histogram_add(void* a0, int a1, double* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_histogram_create(int a0, double* a1, void** a2);
    [DllImport("wirecut-io")] public static extern void wcut_histogram_destroy(void* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_histogram_eval(void* a0, wcut_statistics* a1);
    [DllImport("wirecut-io")] public static extern void wcut_history_destroy(wcut_history* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_history_excite(wcut_job* a0, wcut_history* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_history_kerf(wcut_job* a0, wcut_history* a1, double* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_history_path(void* a0, wcut_history* a1, wcut_vec3* a2, wcut_vec3* a3, double* a4, wcut_error* a5);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_history_write_csv(wcut_history* a0, wcut_vec3* a1, wcut_vec3* a2, byte* a3, wcut_error* a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_history_write_vtp(wcut_history* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_identification_create(wcut_job* a0, int a1, ulong a2, wcut_job** a3, wcut_error* a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_iges_write(int a0, wcut_shape* a1, byte* a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_job_create(wcut_job** a0);
    [DllImport("wirecut-io")] public static extern void wcut_job_destroy(wcut_job* a0);
    [DllImport("wirecut-io")] public static extern double wcut_job_heat_eval(wcut_job* a0, double a1);
    [DllImport("wirecut-io")] public static extern double wcut_job_pace_eval(wcut_job* a0, double a1);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_job_place_mounts(wcut_job* a0, wcut_error* a1);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_job_read(byte* a0, wcut_job** a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_job_read_edges(wcut_job* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_job_read_force_law(wcut_job* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_job_resample(wcut_job* a0, int a1);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_job_write(wcut_job* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_joint_eval(wcut_facade* a0, int a1, wcut_element_face* a2, wcut_element_face* a3, wcut_joint_report* a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_keys_at_corners(wcut_vec3 a0, double a1, double a2, wcut_key* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_law_fit_eval(wcut_law_fit* a0, double a1, int a2, double* a3, double* a4, double* a5, double* a6);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_mesh_base(wcut_mesh* a0, int a1, wcut_surface** a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_mesh_create(int a0, int a1, uint a2, wcut_mesh** a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_mesh_crossings(wcut_mesh* a0, int a1, wcut_crossing* a2, int* a3);
    [DllImport("wirecut-io")] public static extern void wcut_mesh_destroy(wcut_mesh* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_mesh_map_eval(wcut_mesh* a0, double* a1, double* a2, int a3, wcut_vec3* a4, double a5, int a6, double* a7, byte* a8, double* a9);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_mesh_read(byte* a0, wcut_mesh_read_options* a1, wcut_mesh** a2, wcut_mesh_read_info* a3, wcut_error* a4);
    [DllImport("wirecut-io")] public static extern wcut_mesh_read_options wcut_mesh_read_options_default();
    [DllImport("wirecut-io")] public static extern wcut_status wcut_mesh_sample(wcut_mesh* a0, int a1, int a2, double* a3, double* a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_mesh_spread(wcut_mesh* a0, int a1, wcut_deviation* a2, double* a3, double* a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_mesh_tree_create(wcut_mesh* a0, void** a1);
    [DllImport("wirecut-io")] public static extern void wcut_mesh_tree_destroy(void* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_mesh_tree_locate(void* a0, int a1, wcut_vec3* a2, int a3, wcut_mesh_foot* a4);
    [DllImport("wirecut-io")] public static extern wcut_mesh_tree_info* wcut_mesh_tree_view(void* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_mesh_write_3mf(int a0, wcut_mesh_object* a1, byte* a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_mesh_write_glb(wcut_mesh* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_mesh_write_obj(wcut_mesh* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_mesh_write_ply(wcut_mesh* a0, byte* a1, byte* a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_mesh_write_stl(wcut_mesh* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_mould_create(wcut_surface* a0, wcut_vec3 a1, wcut_mould_options* a2, wcut_mould** a3, wcut_error* a4);
    [DllImport("wirecut-io")] public static extern wcut_mould_options wcut_mould_default();
    [DllImport("wirecut-io")] public static extern void wcut_mould_destroy(wcut_mould* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_mould_print(wcut_mould* a0, byte* a1, byte** a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_mould_write(wcut_mould* a0, byte* a1, byte* a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_mould_write_3mf(wcut_mould* a0, byte* a1, uint a2, int a3, byte* a4, wcut_error* a5);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_mould_write_step(wcut_mould* a0, byte* a1, wcut_mould_part a2, wcut_step_schema a3, byte* a4, wcut_error* a5);
    [DllImport("wirecut-io")] public static extern wcut_normals_options wcut_normals_options_default();
    [DllImport("wirecut-io")] public static extern wcut_status wcut_overlay_create(wcut_vec3 a0, wcut_history* a1, wcut_camera* a2, wcut_camera_report* a3, wcut_picture* a4, wcut_overlay_options* a5, IntPtr a6, void* a7, wcut_overlay** a8, wcut_error* a9);
    [DllImport("wirecut-io")] public static extern void wcut_overlay_destroy(wcut_overlay* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_overlay_details(wcut_overlay* a0, wcut_vec3 a1, wcut_history* a2, wcut_picture* a3, double a4, wcut_picture** a5);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_overlay_draw(wcut_overlay* a0, wcut_vec3 a1, wcut_history* a2, wcut_overlay_style* a3, wcut_picture** a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_overlay_draw_photo(wcut_overlay* a0, wcut_vec3 a1, wcut_history* a2, wcut_overlay_style* a3, wcut_camera* a4, wcut_picture* a5, wcut_picture** a6);
    [DllImport("wirecut-io")] public static extern wcut_overlay_options wcut_overlay_options_default();
    [DllImport("wirecut-io")] public static extern wcut_status wcut_overlay_print(wcut_overlaid* a0, byte** a1);
    [DllImport("wirecut-io")] public static extern wcut_overlay_style wcut_overlay_style_default();
    [DllImport("wirecut-io")] public static extern wcut_status wcut_overlay_svg_write(wcut_overlaid* a0, byte* a1, byte* a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_panel_create(wcut_element_face* a0, double a1, double a2, wcut_panel** a3, wcut_error* a4);
    [DllImport("wirecut-io")] public static extern void wcut_panel_destroy(wcut_panel* a0);
    [DllImport("wirecut-io")] public static extern byte* wcut_part_name(wcut_part a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_path_clearance(int a0, wcut_vec3* a1, wcut_box* a2, double a3, wcut_path_near* a4);
    [DllImport("wirecut-io")] public static extern byte* wcut_phase_name(wcut_phase a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_photo_points_read(byte* a0, int* a1, wcut_photo_point** a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_picture_create(int a0, int a1, int a2, wcut_picture** a3);
    [DllImport("wirecut-io")] public static extern void wcut_picture_destroy(wcut_picture* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_picture_read(byte* a0, wcut_picture** a1, wcut_picture_source* a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_picture_write(wcut_picture* a0, double a1, byte* a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern byte* wcut_place_name(wcut_place a0);
    [DllImport("wirecut-io")] public static extern wcut_vec3 wcut_pose_point(wcut_pose* a0, wcut_vec3 a1);
    [DllImport("wirecut-io")] public static extern void wcut_prediction_destroy(wcut_prediction* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_prediction_plan(wcut_history* a0, wcut_recording* a1, wcut_prediction** a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_prediction_replay(void* a0, wcut_recording* a1, wcut_replay_options* a2, wcut_prediction** a3, wcut_error* a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_projection_create(wcut_surface* a0, void** a1);
    [DllImport("wirecut-io")] public static extern void wcut_projection_destroy(void* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_projection_locate(void* a0, int a1, wcut_vec3* a2, int a3, wcut_foot* a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_projection_prepare_many(void* a0);
    [DllImport("wirecut-io")] public static extern double wcut_q_eff_eval(double a0, double a1);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_reconstruction_create(wcut_surface* a0, int a1, wcut_vec3* a2, wcut_foot* a3, wcut_reconstruction_options* a4, int a5, wcut_reconstruction** a6, wcut_error* a7);
    [DllImport("wirecut-io")] public static extern void wcut_reconstruction_destroy(wcut_reconstruction* a0);
    [DllImport("wirecut-io")] public static extern wcut_reconstruction_options wcut_reconstruction_options_default();
    [DllImport("wirecut-io")] public static extern wcut_status wcut_recording_check(wcut_job* a0, wcut_recording* a1, int* a2, wcut_doubt* a3);
    [DllImport("wirecut-io")] public static extern void wcut_recording_destroy(wcut_recording* a0);
    [DllImport("wirecut-io")] public static extern void wcut_recording_format_clear(wcut_recording_format* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_recording_format_parse(byte* a0, wcut_recording_format* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern byte wcut_recording_has_force(wcut_recording* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_recording_place(wcut_job* a0, wcut_recording* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_recording_read(byte* a0, wcut_recording_format* a1, wcut_recording** a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_recording_write(wcut_recording* a0, byte* a1, byte* a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern void wcut_regions_destroy(wcut_regions* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_regions_read(byte* a0, wcut_regions** a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_registration_fit(void* a0, int a1, wcut_vec3* a2, wcut_registration_options* a3, int a4, wcut_registration* a5, wcut_error* a6);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_registration_fit_mesh(wcut_mesh* a0, void* a1, int a2, wcut_vec3* a3, wcut_registration_options* a4, int a5, wcut_registration* a6, wcut_error* a7);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_registration_move(wcut_registration* a0, int a1, wcut_vec3* a2, wcut_vec3* a3);
    [DllImport("wirecut-io")] public static extern wcut_registration wcut_registration_none();
    [DllImport("wirecut-io")] public static extern wcut_registration_options wcut_registration_options_default();
    [DllImport("wirecut-io")] public static extern wcut_status wcut_registration_solve_datum(int a0, wcut_datum_pair* a1, int a2, wcut_datum_face* a3, wcut_registration_options* a4, wcut_registration* a5, wcut_error* a6);
    [DllImport("wirecut-io")] public static extern wcut_replay_options wcut_replay_options_default();
    [DllImport("wirecut-io")] public static extern void wcut_report_calibrate_lack(wcut_law_fit* a0, byte* a1);
    [DllImport("wirecut-io")] public static extern void wcut_report_calibrate_scatter(wcut_report_calibrate* a0, wcut_law_fit* a1, byte* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_report_calibrate_write(wcut_report_calibrate* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_report_compare_write(wcut_report_compare* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_report_compensate_write(byte* a0, wcut_compensation_result* a1, byte* a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_report_control_write(wcut_rig_summary* a0, byte* a1, byte* a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_report_design_write(wcut_report_design* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_report_diagnose_write(wcut_report_diagnose* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_report_facade_write(wcut_facade_results* a0, byte* a1, byte* a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_report_mould_write(wcut_report_mould* a0, wcut_job* a1, wcut_history* a2, wcut_mould* a3, byte* a4, wcut_error* a5);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_report_overlay_write(wcut_overlaid* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_report_score_write(wcut_report_score* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_report_simulate_write(wcut_report_simulate* a0, void* a1, wcut_history* a2, byte* a3, wcut_error* a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_report_sweep_write(void* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_report_write(wcut_report* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_residuals_write(int a0, wcut_scored_cut* a1, byte* a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_results_add(void* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_results_commit(void* a0, byte* a1, byte* a2, byte** a3, wcut_error* a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_results_create(byte* a0, int a1, byte** a2, void** a3, wcut_error* a4);
    [DllImport("wirecut-io")] public static extern void wcut_results_destroy(void* a0);
    [DllImport("wirecut-io")] public static extern byte* wcut_results_path(void* a0, byte* a1);
    [DllImport("wirecut-io")] public static extern void wcut_results_reword(void* a0, wcut_error* a1);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_results_verify(byte* a0, wcut_verification** a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern byte* wcut_rig_name(wcut_rig_kind a0);
    [DllImport("wirecut-io")] public static extern wcut_rig_options wcut_rig_options_default(wcut_job* a0);
    [DllImport("wirecut-io")] public static extern wcut_rig_prior wcut_rig_prior_default();
    [DllImport("wirecut-io")] public static extern wcut_status wcut_rig_prior_read(byte* a0, wcut_rig_prior* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_rig_run_create(wcut_job* a0, wcut_history* a1, wcut_control_settings* a2, wcut_rig_options* a3, IntPtr a4, void* a5, wcut_rig_run** a6, wcut_error* a7);
    [DllImport("wirecut-io")] public static extern void wcut_rig_run_destroy(wcut_rig_run* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_rig_summary_print(wcut_rig_summary* a0, byte** a1);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_rig_summary_write(wcut_rig_summary* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_rills_write(wcut_overlay* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern byte* wcut_robot_file_name(wcut_robot_format a0, int a1);
    [DllImport("wirecut-io")] public static extern byte* wcut_robot_format_name(wcut_robot_format a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_robot_limits_check(wcut_job* a0, wcut_history* a1, wcut_vec3* a2, wcut_vec3* a3, wcut_robot_limits* a4, wcut_robot_check* a5);
    [DllImport("wirecut-io")] public static extern wcut_robot_limits wcut_robot_limits_default(wcut_job* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_robot_motion_create(wcut_history* a0, wcut_vec3* a1, wcut_vec3* a2, wcut_robot_options* a3, wcut_robot_motion** a4, wcut_error* a5);
    [DllImport("wirecut-io")] public static extern void wcut_robot_motion_destroy(wcut_robot_motion* a0);
    [DllImport("wirecut-io")] public static extern wcut_robot_names wcut_robot_names_default();
    [DllImport("wirecut-io")] public static extern wcut_robot_options wcut_robot_options_default();
    [DllImport("wirecut-io")] public static extern wcut_status wcut_robot_summary_print(wcut_robot_summary* a0, byte** a1);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_robot_write(wcut_robot_motion* a0, wcut_robot_names* a1, wcut_robot_format a2, int a3, byte* a4, wcut_error* a5);
    [DllImport("wirecut-io")] public static extern byte* wcut_scatter_name(wcut_scatter_kind a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_score_eval(int a0, double* a1, double* a2, double a3, wcut_score* a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_score_mean(int a0, wcut_score* a1, wcut_score* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_score_print(int a0, wcut_scored_cut* a1, wcut_comparison_options* a2, byte** a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_score_write(int a0, wcut_scored_cut* a1, wcut_comparison_options* a2, byte* a3, wcut_error* a4);
    [DllImport("wirecut-io")] public static extern byte* wcut_scored_name(wcut_scored a0);
    [DllImport("wirecut-io")] public static extern byte* wcut_scored_unit(wcut_scored a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_scores_mean(int a0, wcut_comparison** a1, wcut_scores* a2, wcut_scores* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_sections_write(wcut_survey_result* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_sensors_eval(int a0, wcut_effect* a1, int a2, double* a3, byte* a4, double** a5);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_setup_create(wcut_job* a0, wcut_cut_options* a1, void** a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern void wcut_setup_destroy(void* a0);
    [DllImport("wirecut-io")] public static extern wcut_job* wcut_setup_job(void* a0);
    [DllImport("wirecut-io")] public static extern wcut_cut_options* wcut_setup_options(void* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_setup_path_job(void* a0, wcut_job** a1);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_setup_run(void* a0, IntPtr a1, void* a2, wcut_history** a3, wcut_error* a4);
    [DllImport("wirecut-io")] public static extern wcut_setup_span wcut_setup_stations(void* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_slurm_write(void* a0, wcut_slurm* a1, byte* a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_source_hash(byte* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern byte* wcut_status_text(wcut_status a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_step_write(int a0, wcut_shape* a1, wcut_step_schema a2, byte* a3, wcut_error* a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_step_write_assembly(byte* a0, int a1, wcut_shape* a2, int a3, wcut_step_place* a4, byte* a5, wcut_error* a6);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_stl_stream_append(void* a0, int a1, wcut_vec3* a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_stl_stream_commit(void* a0, wcut_error* a1);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_stl_stream_create(byte* a0, void** a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern void wcut_stl_stream_destroy(void* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_study_call_print(void* a0, int a1, byte* a2, byte** a3);
    [DllImport("wirecut-io")] public static extern void wcut_study_destroy(void* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_study_hash_eval(void* a0, int a1, byte* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_study_input_print(void* a0, int a1, byte** a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_study_read(byte* a0, void** a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_study_value_print(void* a0, int a1, int a2, byte** a3);
    [DllImport("wirecut-io")] public static extern wcut_study_info* wcut_study_view(void* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_summary_eval(wcut_history* a0, wcut_summary* a1);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_summary_print(void* a0, wcut_history* a1, byte** a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_summary_write(void* a0, wcut_history* a1, byte* a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_surface_bounds(wcut_surface* a0, double a1, wcut_box* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_surface_create(int a0, int a1, int a2, int a3, double* a4, double* a5, wcut_vec3* a6, double* a7, wcut_surface** a8);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_surface_curvature(wcut_surface* a0, double a1, double a2, double* a3, double* a4);
    [DllImport("wirecut-io")] public static extern void wcut_surface_destroy(wcut_surface* a0);
    [DllImport("wirecut-io")] public static extern void wcut_surface_domain(wcut_surface* a0, double* a1, double* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_surface_elevate(wcut_surface* a0, wcut_direction a1, int a2, wcut_surface** a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_surface_eval(wcut_surface* a0, double a1, double a2, int a3, wcut_vec3* a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_surface_eval_grid(wcut_surface* a0, int a1, double* a2, int a3, double* a4, wcut_vec3* a5);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_surface_fit(int a0, int a1, wcut_vec3* a2, double a3, double a4, wcut_surface** a5, double* a6, wcut_surface_fit_report* a7);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_surface_frame(wcut_surface* a0, double a1, double a2, wcut_tangent_frame* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_surface_insert_knot(wcut_surface* a0, wcut_direction a1, double a2, int a3, wcut_surface** a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_surface_inspect(wcut_surface* a0, double a1, wcut_surface_report* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_surface_intersect_box(wcut_surface* a0, wcut_box* a1, double a2, wcut_traces** a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_surface_intersect_plane(wcut_surface* a0, wcut_vec3 a1, wcut_vec3 a2, double a3, wcut_traces** a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_surface_iso_curve(wcut_surface* a0, wcut_direction a1, double a2, wcut_curve** a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_surface_join(wcut_surface* a0, wcut_surface* a1, wcut_direction a2, double a3, wcut_surface** a4, double* a5);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_surface_loft(int a0, int a1, wcut_vec3* a2, double a3, wcut_surface** a4, double* a5, wcut_loft_report* a6);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_surface_loft_curves(int a0, wcut_curve** a1, double a2, double a3, wcut_surface** a4, double* a5, wcut_curve_loft_report* a6);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_surface_normal(wcut_surface* a0, double a1, double a2, wcut_vec3* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_surface_offset(wcut_surface* a0, double a1, double a2, wcut_surface** a3, wcut_offset_report* a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_surface_remove_knots(wcut_surface* a0, double a1, wcut_surface** a2, double* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_surface_reverse(wcut_surface* a0, wcut_direction a1, wcut_surface** a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_surface_split(wcut_surface* a0, wcut_direction a1, double a2, wcut_surface** a3, wcut_surface** a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_surface_tessellate(wcut_surface* a0, double a1, wcut_mesh** a2, wcut_tessellation_report* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_surface_transform(wcut_surface* a0, wcut_affine* a1, wcut_surface** a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_surface_transpose(wcut_surface* a0, wcut_surface** a1);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_survey_add(void* a0, int a1, wcut_vec3* a2, wcut_deviation* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_survey_create(wcut_regions* a0, int a1, double* a2, void** a3);
    [DllImport("wirecut-io")] public static extern void wcut_survey_destroy(void* a0);
    [DllImport("wirecut-io")] public static extern wcut_survey_result* wcut_survey_eval(void* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_sweep_create(byte* a0, byte* a1, void** a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern void wcut_sweep_destroy(void* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_sweep_figures_query(void* a0, wcut_error* a1);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_sweep_measure(void* a0, wcut_sweep_options* a1, double* a2, double* a3, double* a4, wcut_error* a5);
    [DllImport("wirecut-io")] public static extern wcut_sweep_options wcut_sweep_options_default();
    [DllImport("wirecut-io")] public static extern wcut_status wcut_sweep_print(void* a0, byte** a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_sweep_query(void* a0, wcut_sweep_counts* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_sweep_read(byte* a0, void** a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_sweep_run(void* a0, wcut_sweep_options* a1, wcut_sweep_counts* a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern byte* wcut_sweep_state_name(wcut_sweep_state a0);
    [DllImport("wirecut-io")] public static extern void* wcut_sweep_view(void* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_sweep_write_csv(void* a0, byte* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern void wcut_table_destroy(wcut_table* a0);
    [DllImport("wirecut-io")] public static extern int wcut_table_locate(wcut_table* a0, byte* a1);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_table_read(byte* a0, int a1, byte** a2, wcut_table** a3, wcut_error* a4);
    [DllImport("wirecut-io")] public static extern double wcut_tension_law_eval(wcut_tension_law* a0, double a1, double a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_tension_law_speed(wcut_tension_law* a0, double a1, double a2, double* a3);
    [DllImport("wirecut-io")] public static extern void wcut_test_cut_destroy(wcut_test_cut* a0);
    [DllImport("wirecut-io")] public static extern double wcut_test_cut_force(wcut_test_cut* a0);
    [DllImport("wirecut-io")] public static extern double wcut_test_cut_tension(wcut_test_cut* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_thinning_add(void* a0, int a1, wcut_vec3* a2, byte* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_thinning_create(double a0, void** a1);
    [DllImport("wirecut-io")] public static extern void wcut_thinning_destroy(void* a0);
    [DllImport("wirecut-io")] public static extern void wcut_traces_destroy(wcut_traces* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_traces_join(wcut_traces* a0, double a1, wcut_traces** a2);
    [DllImport("wirecut-io")] public static extern double wcut_trimmed_border(wcut_trimmed* a0, wcut_vec3 a1);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_trimmed_create(wcut_surface* a0, int a1, int* a2, wcut_curve** a3, double a4, wcut_trimmed** a5, wcut_error* a6);
    [DllImport("wirecut-io")] public static extern void wcut_trimmed_destroy(wcut_trimmed* a0);
    [DllImport("wirecut-io")] public static extern int wcut_trimmed_inside(wcut_trimmed* a0, double a1, double a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_trimmed_mesh(wcut_trimmed* a0, double a1, wcut_mesh** a2);
    [DllImport("wirecut-io")] public static extern void wcut_trimmed_set_destroy(wcut_trimmed_set* a0);
    [DllImport("wirecut-io")] public static extern int wcut_trimmed_set_find(wcut_trimmed_set* a0, byte* a1, UIntPtr a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_trimmed_set_read(byte* a0, wcut_trimmed_set** a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern byte* wcut_verdict_name(wcut_verdict_kind a0);
    [DllImport("wirecut-io")] public static extern void wcut_verification_destroy(wcut_verification* a0);
    [DllImport("wirecut-io")] public static extern byte* wcut_version_text();
    [DllImport("wirecut-io")] public static extern wcut_status wcut_vtp_stream_append(void* a0, wcut_station* a1, wcut_error* a2);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_vtp_stream_commit(void* a0, wcut_error* a1);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_vtp_stream_create(byte* a0, int a1, int a2, void** a3, wcut_error* a4);
    [DllImport("wirecut-io")] public static extern void wcut_vtp_stream_destroy(void* a0);
    [DllImport("wirecut-io")] public static extern wcut_wire_material* wcut_wire_material_view(byte* a0);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_wire_temperature(double a0, double a1, double a2, double a3, double* a4);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_world_write(wcut_overlay* a0, wcut_vec3 a1, byte* a2, wcut_error* a3);
    [DllImport("wirecut-io")] public static extern wcut_status wcut_zones_write(wcut_deviation_summary_result* a0, wcut_survey_result* a1, byte* a2, wcut_error* a3);
}
