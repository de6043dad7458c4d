struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_10 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: f32,
member_4: u32,
member_5: u32,
member_6: u32,
}
struct type_11 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_10,
}
struct type_12 {
member: type_2,
member_1: u32,
member_2: type_5,
member_3: type_7,
member_4: type_7,
member_5: type_7,
member_6: type_7,
member_7: type_5,
member_8: f32,
member_9: f32,
}
struct type_13 {
member: type_2,
member_1: u32,
member_2: type_2,
member_3: u32,
member_4: type_2,
member_5: u32,
member_6: type_4,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: type_5,
member_11: f32,
member_12: f32,
member_13: f32,
member_14: type_5,
member_15: type_5,
member_16: type_6,
member_17: type_9,
member_18: type_11,
member_19: type_5,
member_20: type_12,
}
struct type_14 {
member: type_13,
}
struct type_16 {
member: array<f32>,
}
struct type_20 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: i32,
member_13: i32,
member_14: f32,
}
struct type_23 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_14;
@group(0) @binding(1)
var<storage> global_2: type_16;
@group(0) @binding(2)
var<storage> global_3: type_16;
@group(0) @binding(3)
var<storage> global_4: type_16;
@group(0) @binding(4)
var<storage, read_write> global_5: type_16;
@group(0) @binding(5)
var<storage, read_write> global_6: type_23;
fn function_() {
var phi_643_: u32;
var phi_725_: i32;
var phi_727_: type_20;
var phi_730_: i32;
var phi_732_: i32;
var phi_2006_: i32;
var phi_2009_: i32;
var phi_2007_: i32;
var phi_2010_: i32;
var phi_3121_: i32;
var phi_3123_: i32;
var phi_3126_: i32;
var phi_3124_: i32;
var phi_3127_: i32;
var local: i32;
var local_1: i32;
var phi_3428_: type_20;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var phi_3763_: type_20;
var phi_3816_: type_20;
var phi_3830_: type_20;
var local_8: i32;
var local_9: i32;
var phi_4274_: type_20;
var phi_4275_: type_20;
var phi_4255_: type_20;
var phi_4276_: type_20;
var phi_4281_: type_20;
var phi_4282_: type_20;
var phi_4283_: bool;
var phi_4287_: type_20;
var local_10: i32;
var local_11: i32;
var phi_3101_: type_20;
var phi_4289_: type_20;
var phi_4290_: i32;
var phi_1396_: i32;
var phi_1399_: i32;
var phi_1397_: i32;
var phi_1400_: i32;
var local_12: i32;
var local_13: i32;
var local_14: i32;
var phi_2002_: type_20;
var phi_1716_: type_20;
var phi_2004_: type_20;
var phi_4291_: type_20;
var phi_4292_: i32;
var phi_1355_: type_20;
var phi_1356_: type_20;
var phi_1388_: i32;
var phi_4293_: type_20;
var phi_4294_: i32;
var phi_728_: type_20;
var phi_731_: i32;
var phi_733_: i32;
var local_15: i32;
var local_16: i32;
var phi_4300_: i32;
var local_17: type_20;
var local_18: type_20;
var local_19: type_20;
var local_20: type_20;
var local_21: type_20;
var local_22: type_20;
var local_23: type_20;
var local_24: type_20;
var local_25: type_20;
var local_26: type_20;
var local_27: type_20;
var local_28: type_20;
var local_29: type_20;
var local_30: type_20;
var local_31: type_20;
var local_32: type_20;
var local_33: type_20;
var local_34: type_20;
var local_35: type_20;
var local_36: type_20;
var local_37: type_20;
var local_38: type_20;
var local_39: type_20;
var local_40: f32;
let _e94 = global;
let _e98 = arrayLength((&global_3.member));
let _e100 = arrayLength((&global_4.member));
let _e107 = global_1.member.member;
if (_e94.x < _e107.member) {
if (_e94.y < _e107.member_1) {
let _e114 = (_e107.member * _e107.member_1);
let _e116 = ((_e94.y * _e107.member) + _e94.x);
let _e117 = bitcast<i32>(_e116);
let _e119 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e121 = select(_e119, _e117, (_e117 < _e119));
let _e127 = global_5.member[bitcast<u32>(select(0i, _e121, (_e121 > 0i)))];
let _e128 = (_e114 + _e116);
let _e129 = bitcast<i32>(_e128);
let _e131 = select(_e119, _e129, (_e129 < _e119));
let _e137 = global_5.member[bitcast<u32>(select(0i, _e131, (_e131 > 0i)))];
let _e139 = ((2u * _e114) + _e116);
let _e140 = bitcast<i32>(_e139);
let _e142 = select(_e119, _e140, (_e140 < _e119));
let _e148 = global_5.member[bitcast<u32>(select(0i, _e142, (_e142 > 0i)))];
let _e150 = ((3u * _e114) + _e116);
let _e151 = bitcast<i32>(_e150);
let _e153 = select(_e119, _e151, (_e151 < _e119));
let _e159 = global_5.member[bitcast<u32>(select(0i, _e153, (_e153 > 0i)))];
let _e161 = ((4u * _e114) + _e116);
let _e162 = bitcast<i32>(_e161);
let _e164 = select(_e119, _e162, (_e162 < _e119));
let _e170 = global_5.member[bitcast<u32>(select(0i, _e164, (_e164 > 0i)))];
let _e172 = ((5u * _e114) + _e116);
let _e173 = bitcast<i32>(_e172);
let _e175 = select(_e119, _e173, (_e173 < _e119));
let _e181 = global_5.member[bitcast<u32>(select(0i, _e175, (_e175 > 0i)))];
let _e183 = ((6u * _e114) + _e116);
let _e184 = bitcast<i32>(_e183);
let _e186 = select(_e119, _e184, (_e184 < _e119));
let _e192 = global_5.member[bitcast<u32>(select(0i, _e186, (_e186 > 0i)))];
let _e194 = ((7u * _e114) + _e116);
let _e195 = bitcast<i32>(_e194);
let _e197 = select(_e119, _e195, (_e195 < _e119));
let _e203 = global_5.member[bitcast<u32>(select(0i, _e197, (_e197 > 0i)))];
let _e205 = ((8u * _e114) + _e116);
let _e206 = bitcast<i32>(_e205);
let _e208 = select(_e119, _e206, (_e206 < _e119));
let _e214 = global_5.member[bitcast<u32>(select(0i, _e208, (_e208 > 0i)))];
let _e216 = ((9u * _e114) + _e116);
let _e217 = bitcast<i32>(_e216);
let _e219 = select(_e119, _e217, (_e217 < _e119));
let _e225 = global_5.member[bitcast<u32>(select(0i, _e219, (_e219 > 0i)))];
let _e227 = ((10u * _e114) + _e116);
let _e228 = bitcast<i32>(_e227);
let _e230 = select(_e119, _e228, (_e228 < _e119));
let _e236 = global_5.member[bitcast<u32>(select(0i, _e230, (_e230 > 0i)))];
let _e238 = ((11u * _e114) + _e116);
let _e239 = bitcast<i32>(_e238);
let _e241 = select(_e119, _e239, (_e239 < _e119));
let _e247 = global_5.member[bitcast<u32>(select(0i, _e241, (_e241 > 0i)))];
let _e249 = ((12u * _e114) + _e116);
let _e250 = bitcast<i32>(_e249);
let _e252 = select(_e119, _e250, (_e250 < _e119));
let _e258 = global_5.member[bitcast<u32>(select(0i, _e252, (_e252 > 0i)))];
let _e260 = ((13u * _e114) + _e116);
let _e261 = bitcast<i32>(_e260);
let _e263 = select(_e119, _e261, (_e261 < _e119));
let _e269 = global_5.member[bitcast<u32>(select(0i, _e263, (_e263 > 0i)))];
let _e271 = ((14u * _e114) + _e116);
let _e272 = bitcast<i32>(_e271);
let _e274 = select(_e119, _e272, (_e272 < _e119));
let _e280 = global_5.member[bitcast<u32>(select(0i, _e274, (_e274 > 0i)))];
let _e282 = ((15u * _e114) + _e116);
let _e283 = bitcast<i32>(_e282);
let _e285 = select(_e119, _e283, (_e283 < _e119));
let _e291 = global_5.member[bitcast<u32>(select(0i, _e285, (_e285 > 0i)))];
let _e293 = ((16u * _e114) + _e116);
let _e294 = bitcast<i32>(_e293);
let _e296 = select(_e119, _e294, (_e294 < _e119));
let _e302 = global_5.member[bitcast<u32>(select(0i, _e296, (_e296 > 0i)))];
let _e304 = ((17u * _e114) + _e116);
let _e305 = bitcast<i32>(_e304);
let _e307 = select(_e119, _e305, (_e305 < _e119));
let _e313 = global_5.member[bitcast<u32>(select(0i, _e307, (_e307 > 0i)))];
let _e315 = ((18u * _e114) + _e116);
let _e316 = bitcast<i32>(_e315);
let _e318 = select(_e119, _e316, (_e316 < _e119));
let _e324 = global_5.member[bitcast<u32>(select(0i, _e318, (_e318 > 0i)))];
let _e326 = ((19u * _e114) + _e116);
let _e327 = bitcast<i32>(_e326);
let _e329 = select(_e119, _e327, (_e327 < _e119));
let _e335 = global_5.member[bitcast<u32>(select(0i, _e329, (_e329 > 0i)))];
let _e337 = ((20u * _e114) + _e116);
let _e338 = bitcast<i32>(_e337);
let _e340 = select(_e119, _e338, (_e338 < _e119));
let _e346 = global_5.member[bitcast<u32>(select(0i, _e340, (_e340 > 0i)))];
let _e348 = ((21u * _e114) + _e116);
let _e349 = bitcast<i32>(_e348);
let _e351 = select(_e119, _e349, (_e349 < _e119));
let _e357 = global_5.member[bitcast<u32>(select(0i, _e351, (_e351 > 0i)))];
let _e359 = ((22u * _e114) + _e116);
let _e360 = bitcast<i32>(_e359);
let _e362 = select(_e119, _e360, (_e360 < _e119));
let _e368 = global_5.member[bitcast<u32>(select(0i, _e362, (_e362 > 0i)))];
let _e370 = ((23u * _e114) + _e116);
let _e371 = bitcast<i32>(_e370);
let _e373 = select(_e119, _e371, (_e371 < _e119));
let _e379 = global_5.member[bitcast<u32>(select(0i, _e373, (_e373 > 0i)))];
let _e381 = ((24u * _e114) + _e116);
let _e382 = bitcast<i32>(_e381);
let _e384 = select(_e119, _e382, (_e382 < _e119));
let _e390 = global_5.member[bitcast<u32>(select(0i, _e384, (_e384 > 0i)))];
if (_e302 == 0f) {
phi_643_ = 3u;
} else {
phi_643_ = select(0u, 1u, (_e302 == 4f));
}
let _e395 = phi_643_;
if (_e395 > 0u) {
if (arrayLength((&global_6.member)) >= 3u) {
let _e404 = atomicLoad((&global_6.member[0u]));
if (_e404 == 0u) {
atomicStore((&global_6.member[0u]), ((_e107.member + 7u) / 8u));
atomicStore((&global_6.member[1u]), ((_e107.member_1 + 7u) / 8u));
atomicStore((&global_6.member[2u]), 1u);
}
}
}
if (_e395 > 1u) {
let _e423 = select(0i, select(select(i32(_e313), i32(-2147483648), (_e313 < -2147483600f)), 2147483647i, (_e313 > 2147483500f)), (_e313 == _e313));
let _e439 = bitcast<i32>(arrayLength((&global_2.member)));
if (_e423 == 16i) {
phi_725_ = 0i;
} else {
phi_725_ = -(_e423);
}
let _e444 = phi_725_;
phi_727_ = type_20(vec3<f32>(_e127, _e137, _e148), vec3<f32>(_e159, _e170, _e181), vec3<f32>(_e192, _e203, _e214), vec3<f32>(_e225, _e236, _e247), vec3<f32>(_e258, _e269, _e280), _e291, _e302, _e423, _e324, _e335, _e346, _e357, select(0i, select(select(i32(_e368), i32(-2147483648), (_e368 < -2147483600f)), 2147483647i, (_e368 > 2147483500f)), (_e368 == _e368)), select(0i, select(select(i32(_e379), i32(-2147483648), (_e379 < -2147483600f)), 2147483647i, (_e379 > 2147483500f)), (_e379 == _e379)), _e390);
phi_730_ = 0i;
phi_732_ = _e444;
loop {
let _e446 = phi_727_;
let _e448 = phi_730_;
let _e450 = phi_732_;
local_15 = _e450;
local_16 = _e450;
local_17 = _e446;
local_18 = _e446;
local_19 = _e446;
local_20 = _e446;
local_21 = _e446;
local_22 = _e446;
local_23 = _e446;
local_24 = _e446;
local_25 = _e446;
local_26 = _e446;
local_27 = _e446;
local_28 = _e446;
local_29 = _e446;
local_30 = _e446;
local_31 = _e446;
local_32 = _e446;
local_33 = _e446;
local_34 = _e446;
local_35 = _e446;
local_36 = _e446;
local_37 = _e446;
local_38 = _e446;
local_39 = _e446;
let _e454 = ((_e448 < 1024i) && (_e446.member_6 == 0f));
local_40 = _e446.member_6;
if _e454 {
if (_e446.member_12 < (_e439 / 8i)) {
let _e2650 = (_e446.member_12 * 8i);
let _e2654 = bitcast<f32>((bitcast<u32>(_e446.member_1.x) & 2147483647u));
let _e2659 = (1f / select(_e446.member_1.x, select(1e-12f, -1e-12f, (_e446.member_1.x < 0f)), (_e2654 < 1e-12f)));
let _e2663 = bitcast<f32>((bitcast<u32>(_e446.member_1.y) & 2147483647u));
let _e2668 = (1f / select(_e446.member_1.y, select(1e-12f, -1e-12f, (_e446.member_1.y < 0f)), (_e2663 < 1e-12f)));
let _e2672 = bitcast<f32>((bitcast<u32>(_e446.member_1.z) & 2147483647u));
let _e2677 = (1f / select(_e446.member_1.z, select(1e-12f, -1e-12f, (_e446.member_1.z < 0f)), (_e2672 < 1e-12f)));
let _e2679 = (_e439 - 1i);
let _e2681 = select(_e2679, _e2650, (_e2650 < _e2679));
let _e2687 = global_2.member[bitcast<u32>(select(0i, _e2681, (_e2681 > 0i)))];
let _e2688 = (_e2650 + 1i);
let _e2690 = select(_e2679, _e2688, (_e2688 < _e2679));
let _e2696 = global_2.member[bitcast<u32>(select(0i, _e2690, (_e2690 > 0i)))];
let _e2697 = (_e2650 + 2i);
let _e2699 = select(_e2679, _e2697, (_e2697 < _e2679));
let _e2705 = global_2.member[bitcast<u32>(select(0i, _e2699, (_e2699 > 0i)))];
let _e2706 = (_e2650 + 3i);
let _e2708 = select(_e2679, _e2706, (_e2706 < _e2679));
let _e2714 = global_2.member[bitcast<u32>(select(0i, _e2708, (_e2708 > 0i)))];
let _e2715 = (_e2650 + 4i);
let _e2717 = select(_e2679, _e2715, (_e2715 < _e2679));
let _e2723 = global_2.member[bitcast<u32>(select(0i, _e2717, (_e2717 > 0i)))];
let _e2724 = (_e2650 + 5i);
let _e2726 = select(_e2679, _e2724, (_e2724 < _e2679));
let _e2732 = global_2.member[bitcast<u32>(select(0i, _e2726, (_e2726 > 0i)))];
let _e2735 = ((_e2687 - _e446.member.x) * _e2659);
let _e2737 = ((_e2714 - _e446.member.x) * _e2659);
let _e2740 = ((_e2696 - _e446.member.y) * _e2668);
let _e2742 = ((_e2723 - _e446.member.y) * _e2668);
let _e2745 = ((_e2705 - _e446.member.z) * _e2677);
let _e2747 = ((_e2732 - _e446.member.z) * _e2677);
let _e2749 = select(_e2737, _e2735, (_e2735 < _e2737));
let _e2751 = select(_e2742, _e2740, (_e2740 < _e2742));
let _e2753 = select(_e2751, _e2749, (_e2749 > _e2751));
let _e2755 = select(_e2747, _e2745, (_e2745 < _e2747));
let _e2759 = select(_e2737, _e2735, (_e2735 > _e2737));
let _e2761 = select(_e2742, _e2740, (_e2740 > _e2742));
let _e2763 = select(_e2761, _e2759, (_e2759 < _e2761));
let _e2765 = select(_e2747, _e2745, (_e2745 > _e2747));
let _e2767 = select(_e2765, _e2763, (_e2763 < _e2765));
let _e2773 = ((select(_e2755, _e2753, (_e2753 > _e2755)) <= select(_e446.member_14, _e2767, (_e2767 < _e446.member_14))) && (_e2767 >= 0f));
let _e2774 = (_e2650 + 6i);
let _e2776 = select(_e2679, _e2774, (_e2774 < _e2679));
let _e2782 = global_2.member[bitcast<u32>(select(0i, _e2776, (_e2776 > 0i)))];
let _e2789 = select(0i, select(select(i32(_e2782), i32(-2147483648), (_e2782 < -2147483600f)), 2147483647i, (_e2782 > 2147483500f)), (_e2782 == _e2782));
if (_e2773 && (_e2789 >= 0i)) {
let _e2794 = ((_e2654 >= _e2663) && (_e2654 >= _e2672));
let _e2797 = (!(_e2794) && (_e2663 >= _e2672));
let _e2804 = (1f / select(select(_e446.member_1.z, _e446.member_1.y, _e2797), _e446.member_1.x, _e2794));
let _e2805 = (select(select(_e446.member_1.x, _e446.member_1.z, _e2797), _e446.member_1.y, _e2794) * _e2804);
let _e2806 = (select(select(_e446.member_1.y, _e446.member_1.x, _e2797), _e446.member_1.z, _e2794) * _e2804);
let _e2807 = (_e2789 * 19i);
let _e2809 = (bitcast<i32>(_e98) - 1i);
let _e2811 = select(_e2809, _e2807, (_e2807 < _e2809));
let _e2817 = global_3.member[bitcast<u32>(select(0i, _e2811, (_e2811 > 0i)))];
let _e2818 = (_e2807 + 1i);
let _e2820 = select(_e2809, _e2818, (_e2818 < _e2809));
let _e2826 = global_3.member[bitcast<u32>(select(0i, _e2820, (_e2820 > 0i)))];
let _e2827 = (_e2807 + 2i);
let _e2829 = select(_e2809, _e2827, (_e2827 < _e2809));
let _e2835 = global_3.member[bitcast<u32>(select(0i, _e2829, (_e2829 > 0i)))];
let _e2836 = (_e2817 - _e446.member.x);
let _e2837 = (_e2826 - _e446.member.y);
let _e2838 = (_e2835 - _e446.member.z);
let _e2844 = select(select(_e2838, _e2837, _e2797), _e2836, _e2794);
let _e2846 = (select(select(_e2836, _e2838, _e2797), _e2837, _e2794) - (_e2805 * _e2844));
let _e2848 = (select(select(_e2837, _e2836, _e2797), _e2838, _e2794) - (_e2806 * _e2844));
let _e2850 = (_e2807 + 3i);
let _e2852 = select(_e2809, _e2850, (_e2850 < _e2809));
let _e2858 = global_3.member[bitcast<u32>(select(0i, _e2852, (_e2852 > 0i)))];
let _e2859 = (_e2807 + 4i);
let _e2861 = select(_e2809, _e2859, (_e2859 < _e2809));
let _e2867 = global_3.member[bitcast<u32>(select(0i, _e2861, (_e2861 > 0i)))];
let _e2868 = (_e2807 + 5i);
let _e2870 = select(_e2809, _e2868, (_e2868 < _e2809));
let _e2876 = global_3.member[bitcast<u32>(select(0i, _e2870, (_e2870 > 0i)))];
let _e2877 = (_e2858 - _e446.member.x);
let _e2878 = (_e2867 - _e446.member.y);
let _e2879 = (_e2876 - _e446.member.z);
let _e2885 = select(select(_e2879, _e2878, _e2797), _e2877, _e2794);
let _e2887 = (select(select(_e2877, _e2879, _e2797), _e2878, _e2794) - (_e2805 * _e2885));
let _e2889 = (select(select(_e2878, _e2877, _e2797), _e2879, _e2794) - (_e2806 * _e2885));
let _e2891 = (_e2807 + 6i);
let _e2893 = select(_e2809, _e2891, (_e2891 < _e2809));
let _e2899 = global_3.member[bitcast<u32>(select(0i, _e2893, (_e2893 > 0i)))];
let _e2900 = (_e2807 + 7i);
let _e2902 = select(_e2809, _e2900, (_e2900 < _e2809));
let _e2908 = global_3.member[bitcast<u32>(select(0i, _e2902, (_e2902 > 0i)))];
let _e2909 = (_e2807 + 8i);
let _e2911 = select(_e2809, _e2909, (_e2909 < _e2809));
let _e2917 = global_3.member[bitcast<u32>(select(0i, _e2911, (_e2911 > 0i)))];
let _e2918 = (_e2899 - _e446.member.x);
let _e2919 = (_e2908 - _e446.member.y);
let _e2920 = (_e2917 - _e446.member.z);
let _e2926 = select(select(_e2920, _e2919, _e2797), _e2918, _e2794);
let _e2928 = (select(select(_e2918, _e2920, _e2797), _e2919, _e2794) - (_e2805 * _e2926));
let _e2930 = (select(select(_e2919, _e2918, _e2797), _e2920, _e2794) - (_e2806 * _e2926));
let _e2934 = ((_e2928 * _e2889) - (_e2930 * _e2887));
let _e2937 = ((_e2846 * _e2930) - (_e2848 * _e2928));
let _e2940 = ((_e2887 * _e2848) - (_e2889 * _e2846));
let _e2942 = ((_e2934 + _e2937) + _e2940);
let _e2956 = (!(((((_e2934 < 0f) || (_e2937 < 0f)) || (_e2940 < 0f)) && (((_e2934 > 0f) || (_e2937 > 0f)) || (_e2940 > 0f)))) && (_e2942 != 0f));
let _e2963 = ((((_e2934 * (_e2844 * _e2804)) + (_e2937 * (_e2885 * _e2804))) + (_e2940 * (_e2926 * _e2804))) / select(1f, _e2942, _e2956));
let _e2966 = select(1e30f, _e2963, (_e2956 && (_e2963 > 1e-3f)));
if (_e2966 < _e446.member_14) {
let _e2982 = type_20(_e446.member, _e446.member_1, _e446.member_2, _e446.member_3, _e446.member_4, _e446.member_5, _e446.member_6, _e446.member_7, _e446.member_8, _e446.member_9, _e446.member_10, _e446.member_11, _e446.member_12, _e446.member_13, _e2966);
phi_1355_ = type_20(_e2982.member, _e2982.member_1, _e2982.member_2, _e2982.member_3, _e2982.member_4, _e2982.member_5, _e2982.member_6, _e2982.member_7, _e2982.member_8, _e2982.member_9, _e2982.member_10, _e2982.member_11, _e2982.member_12, _e2789, _e2982.member_14);
} else {
phi_1355_ = _e446;
}
let _e2999 = phi_1355_;
phi_1356_ = _e2999;
} else {
phi_1356_ = _e446;
}
let _e3001 = phi_1356_;
if _e2773 {
phi_1388_ = (_e3001.member_12 + 1i);
} else {
let _e3002 = (_e2650 + 7i);
let _e3004 = select(_e2679, _e3002, (_e3002 < _e2679));
let _e3010 = global_2.member[bitcast<u32>(select(0i, _e3004, (_e3004 > 0i)))];
phi_1388_ = select(0i, select(select(i32(_e3010), i32(-2147483648), (_e3010 < -2147483600f)), 2147483647i, (_e3010 > 2147483500f)), (_e3010 == _e3010));
}
let _e3021 = phi_1388_;
phi_4293_ = type_20(_e3001.member, _e3001.member_1, _e3001.member_2, _e3001.member_3, _e3001.member_4, _e3001.member_5, _e3001.member_6, _e3001.member_7, _e3001.member_8, _e3001.member_9, _e3001.member_10, _e3001.member_11, _e3021, _e3001.member_13, _e3001.member_14);
phi_4294_ = _e450;
} else {
if (_e446.member_13 < 0i) {
phi_1396_ = 15i;
phi_1399_ = 16i;
loop {
let _e2180 = phi_1396_;
let _e2182 = phi_1399_;
local_12 = _e2182;
local_13 = _e2182;
local_14 = _e2182;
let _e2183 = (_e2180 >= 0i);
if _e2183 {
phi_1397_ = (_e2180 - 1i);
phi_1400_ = select(_e2182, _e2180, (((_e450 >> bitcast<u32>((_e2180 & 31i))) & 1i) == 1i));
} else {
phi_1397_ = i32();
phi_1400_ = i32();
}
let _e2192 = phi_1397_;
let _e2194 = phi_1400_;
continue;
continuing {
phi_1396_ = _e2192;
phi_1399_ = _e2194;
break if !(_e2183);
}
}
let _e2196 = (_e446.member_13 == -1i);
let _e2198 = local_12;
if (_e2196 || (_e2198 == 16i)) {
if _e2196 {
phi_1716_ = type_20(_e446.member, _e446.member_1, _e446.member_2, _e446.member_3, _e446.member_4, _e446.member_5, 1f, _e446.member_7, _e446.member_8, _e446.member_9, _e446.member_10, _e446.member_11, _e446.member_12, _e446.member_13, _e446.member_14);
} else {
let _e2557 = type_20(vec3<f32>((_e446.member.x + (_e446.member_1.x * _e446.member_14)), (_e446.member.y + (_e446.member_1.y * _e446.member_14)), (_e446.member.z + (_e446.member_1.z * _e446.member_14))), _e446.member_1, _e446.member_2, _e446.member_3, _e446.member_4, _e446.member_5, _e446.member_6, _e446.member_7, _e446.member_8, _e446.member_9, _e446.member_10, _e446.member_11, _e446.member_12, _e446.member_13, _e446.member_14);
let _e2574 = type_20(_e2557.member, _e2557.member_1, _e2557.member_2, _e2557.member_3, _e2557.member_4, (_e446.member_5 + _e446.member_14), _e2557.member_6, _e2557.member_7, _e2557.member_8, _e2557.member_9, _e2557.member_10, _e2557.member_11, _e2557.member_12, _e2557.member_13, _e2557.member_14);
let _e2590 = type_20(_e2574.member, _e2574.member_1, _e2574.member_2, _e2574.member_3, _e2574.member_4, _e2574.member_5, _e2574.member_6, _e2574.member_7, _e2574.member_8, _e2574.member_9, _e2574.member_10, _e2574.member_11, _e2574.member_12, _e2574.member_13, (_e446.member_14 - _e446.member_14));
let _e2610 = type_20(_e2590.member, _e2590.member_1, _e2590.member_2, _e2590.member_3, _e2590.member_4, _e2590.member_5, _e2590.member_6, _e2590.member_7, _e2590.member_8, _e2590.member_9, (_e446.member_10 + select(0f, _e446.member_14, (_e446.member_8 == 0f))), _e2590.member_11, _e2590.member_12, _e2590.member_13, _e2590.member_14);
phi_1716_ = type_20(_e2610.member, _e2610.member_1, _e2610.member_2, _e2610.member_3, _e2610.member_4, _e2610.member_5, 3f, _e2610.member_7, _e2610.member_8, _e2610.member_9, _e2610.member_10, _e2610.member_11, _e2610.member_12, _e2610.member_13, _e2610.member_14);
}
let _e2642 = phi_1716_;
phi_2004_ = _e2642;
} else {
let _e2233 = type_20(vec3<f32>((_e446.member.x + (_e446.member_1.x * _e446.member_14)), (_e446.member.y + (_e446.member_1.y * _e446.member_14)), (_e446.member.z + (_e446.member_1.z * _e446.member_14))), _e446.member_1, _e446.member_2, _e446.member_3, _e446.member_4, _e446.member_5, _e446.member_6, _e446.member_7, _e446.member_8, _e446.member_9, _e446.member_10, _e446.member_11, _e446.member_12, _e446.member_13, _e446.member_14);
let _e2250 = type_20(_e2233.member, _e2233.member_1, _e2233.member_2, _e2233.member_3, _e2233.member_4, (_e446.member_5 + _e446.member_14), _e2233.member_6, _e2233.member_7, _e2233.member_8, _e2233.member_9, _e2233.member_10, _e2233.member_11, _e2233.member_12, _e2233.member_13, _e2233.member_14);
let _e2266 = type_20(_e2250.member, _e2250.member_1, _e2250.member_2, _e2250.member_3, _e2250.member_4, _e2250.member_5, _e2250.member_6, _e2250.member_7, _e2250.member_8, _e2250.member_9, _e2250.member_10, _e2250.member_11, _e2250.member_12, _e2250.member_13, (_e446.member_14 - _e446.member_14));
let _e2286 = type_20(_e2266.member, _e2266.member_1, _e2266.member_2, _e2266.member_3, _e2266.member_4, _e2266.member_5, _e2266.member_6, _e2266.member_7, _e2266.member_8, _e2266.member_9, (_e446.member_10 + select(0f, _e446.member_14, (_e446.member_8 == 0f))), _e2266.member_11, _e2266.member_12, _e2266.member_13, _e2266.member_14);
let _e2288 = local_13;
if (_e2288 != 16i) {
let _e2306 = type_20(_e2286.member, _e2286.member_1, _e2286.member_2, _e2286.member_3, _e2286.member_4, _e2286.member_5, _e2286.member_6, _e2286.member_7, _e2286.member_8, (_e446.member_9 + _e446.member_14), _e2286.member_10, _e2286.member_11, _e2286.member_12, _e2286.member_13, _e2286.member_14);
let _e2308 = local_14;
let _e2309 = (_e2308 * 4i);
let _e2310 = (_e2309 + 1i);
let _e2312 = (bitcast<i32>(_e100) - 1i);
let _e2314 = select(_e2312, _e2310, (_e2310 < _e2312));
let _e2320 = global_4.member[bitcast<u32>(select(0i, _e2314, (_e2314 > 0i)))];
let _e2322 = -((_e2320 * _e446.member_14));
let _e2324 = select(-87f, _e2322, (_e2322 > -87f));
let _e2326 = select(88f, _e2324, (_e2324 < 88f));
let _e2328 = ((_e2326 * 1.442695f) + 0.5f);
let _e2330 = select(-127f, _e2328, (_e2328 > -127f));
let _e2332 = select(128f, _e2330, (_e2330 < 128f));
let _e2339 = select(0i, select(select(i32(_e2332), i32(-2147483648), (_e2332 < -2147483600f)), 2147483647i, (_e2332 > 2147483500f)), (_e2332 == _e2332));
let _e2343 = (_e2339 - select(0i, 1i, (_e2332 < f32(_e2339))));
let _e2344 = f32(_e2343);
let _e2348 = ((_e2326 - (_e2344 * 0.6933594f)) - (_e2344 * -2.1219444e-4f));
let _e2372 = (_e2309 + 2i);
let _e2374 = select(_e2312, _e2372, (_e2372 < _e2312));
let _e2380 = global_4.member[bitcast<u32>(select(0i, _e2374, (_e2374 > 0i)))];
let _e2382 = -((_e2380 * _e446.member_14));
let _e2384 = select(-87f, _e2382, (_e2382 > -87f));
let _e2386 = select(88f, _e2384, (_e2384 < 88f));
let _e2388 = ((_e2386 * 1.442695f) + 0.5f);
let _e2390 = select(-127f, _e2388, (_e2388 > -127f));
let _e2392 = select(128f, _e2390, (_e2390 < 128f));
let _e2399 = select(0i, select(select(i32(_e2392), i32(-2147483648), (_e2392 < -2147483600f)), 2147483647i, (_e2392 > 2147483500f)), (_e2392 == _e2392));
let _e2403 = (_e2399 - select(0i, 1i, (_e2392 < f32(_e2399))));
let _e2404 = f32(_e2403);
let _e2408 = ((_e2386 - (_e2404 * 0.6933594f)) - (_e2404 * -2.1219444e-4f));
let _e2432 = (_e2309 + 3i);
let _e2434 = select(_e2312, _e2432, (_e2432 < _e2312));
let _e2440 = global_4.member[bitcast<u32>(select(0i, _e2434, (_e2434 > 0i)))];
let _e2442 = -((_e2440 * _e446.member_14));
let _e2444 = select(-87f, _e2442, (_e2442 > -87f));
let _e2446 = select(88f, _e2444, (_e2444 < 88f));
let _e2448 = ((_e2446 * 1.442695f) + 0.5f);
let _e2450 = select(-127f, _e2448, (_e2448 > -127f));
let _e2452 = select(128f, _e2450, (_e2450 < 128f));
let _e2459 = select(0i, select(select(i32(_e2452), i32(-2147483648), (_e2452 < -2147483600f)), 2147483647i, (_e2452 > 2147483500f)), (_e2452 == _e2452));
let _e2463 = (_e2459 - select(0i, 1i, (_e2452 < f32(_e2459))));
let _e2464 = f32(_e2463);
let _e2468 = ((_e2446 - (_e2464 * 0.6933594f)) - (_e2464 * -2.1219444e-4f));
phi_2002_ = type_20(_e2306.member, _e2306.member_1, vec3<f32>((_e446.member_2.x * ((1f + (_e2348 * (1f + (_e2348 * (0.5f + (_e2348 * (0.16666667f + (_e2348 * (0.041666668f + (_e2348 * (0.008333334f + (_e2348 * (0.001388889f + (_e2348 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2343 + 127i)) << bitcast<u32>(23i))))), (_e446.member_2.y * ((1f + (_e2408 * (1f + (_e2408 * (0.5f + (_e2408 * (0.16666667f + (_e2408 * (0.041666668f + (_e2408 * (0.008333334f + (_e2408 * (0.001388889f + (_e2408 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2403 + 127i)) << bitcast<u32>(23i))))), (_e446.member_2.z * ((1f + (_e2468 * (1f + (_e2468 * (0.5f + (_e2468 * (0.16666667f + (_e2468 * (0.041666668f + (_e2468 * (0.008333334f + (_e2468 * (0.001388889f + (_e2468 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2463 + 127i)) << bitcast<u32>(23i)))))), _e2306.member_3, _e2306.member_4, _e2306.member_5, _e2306.member_6, _e2306.member_7, _e2306.member_8, _e2306.member_9, _e2306.member_10, _e2306.member_11, _e2306.member_12, _e2306.member_13, _e2306.member_14);
} else {
phi_2002_ = _e2286;
}
let _e2509 = phi_2002_;
phi_2004_ = type_20(_e2509.member, _e2509.member_1, _e2509.member_2, _e2509.member_3, _e2509.member_4, _e2509.member_5, 3f, _e2509.member_7, _e2509.member_8, _e2509.member_9, _e2509.member_10, _e2509.member_11, _e2509.member_12, _e2509.member_13, _e2509.member_14);
}
let _e2644 = phi_2004_;
phi_4291_ = _e2644;
phi_4292_ = _e450;
} else {
phi_2006_ = 15i;
phi_2009_ = 16i;
loop {
let _e461 = phi_2006_;
let _e463 = phi_2009_;
local = _e463;
local_1 = _e463;
local_2 = _e463;
local_4 = _e463;
local_5 = _e463;
local_8 = _e463;
local_10 = _e463;
local_11 = _e463;
let _e464 = (_e461 >= 0i);
if _e464 {
phi_2007_ = (_e461 - 1i);
phi_2010_ = select(_e463, _e461, (((_e450 >> bitcast<u32>((_e461 & 31i))) & 1i) == 1i));
} else {
phi_2007_ = i32();
phi_2010_ = i32();
}
let _e473 = phi_2007_;
let _e475 = phi_2010_;
continue;
continuing {
phi_2006_ = _e473;
phi_2009_ = _e475;
break if !(_e464);
}
}
let _e477 = (_e446.member_13 * 19i);
let _e479 = (bitcast<i32>(_e98) - 1i);
let _e481 = select(_e479, _e477, (_e477 < _e479));
let _e487 = global_3.member[bitcast<u32>(select(0i, _e481, (_e481 > 0i)))];
let _e488 = (_e477 + 1i);
let _e490 = select(_e479, _e488, (_e488 < _e479));
let _e496 = global_3.member[bitcast<u32>(select(0i, _e490, (_e490 > 0i)))];
let _e497 = (_e477 + 2i);
let _e499 = select(_e479, _e497, (_e497 < _e479));
let _e505 = global_3.member[bitcast<u32>(select(0i, _e499, (_e499 > 0i)))];
let _e506 = (_e477 + 3i);
let _e508 = select(_e479, _e506, (_e506 < _e479));
let _e514 = global_3.member[bitcast<u32>(select(0i, _e508, (_e508 > 0i)))];
let _e515 = (_e477 + 4i);
let _e517 = select(_e479, _e515, (_e515 < _e479));
let _e523 = global_3.member[bitcast<u32>(select(0i, _e517, (_e517 > 0i)))];
let _e524 = (_e477 + 5i);
let _e526 = select(_e479, _e524, (_e524 < _e479));
let _e532 = global_3.member[bitcast<u32>(select(0i, _e526, (_e526 > 0i)))];
let _e533 = (_e477 + 6i);
let _e535 = select(_e479, _e533, (_e533 < _e479));
let _e541 = global_3.member[bitcast<u32>(select(0i, _e535, (_e535 > 0i)))];
let _e542 = (_e477 + 7i);
let _e544 = select(_e479, _e542, (_e542 < _e479));
let _e550 = global_3.member[bitcast<u32>(select(0i, _e544, (_e544 > 0i)))];
let _e551 = (_e477 + 8i);
let _e553 = select(_e479, _e551, (_e551 < _e479));
let _e559 = global_3.member[bitcast<u32>(select(0i, _e553, (_e553 > 0i)))];
let _e560 = (_e514 - _e487);
let _e561 = (_e523 - _e496);
let _e562 = (_e532 - _e505);
let _e563 = (_e541 - _e487);
let _e564 = (_e550 - _e496);
let _e565 = (_e559 - _e505);
let _e568 = ((_e561 * _e565) - (_e562 * _e564));
let _e571 = ((_e562 * _e563) - (_e560 * _e565));
let _e574 = ((_e560 * _e564) - (_e561 * _e563));
let _e579 = (((_e568 * _e568) + (_e571 * _e571)) + (_e574 * _e574));
let _e582 = sqrt(select(0f, _e579, (_e579 > 0f)));
let _e585 = (1f / select(1e-20f, _e582, (_e582 > 1e-20f)));
let _e586 = (_e568 * _e585);
let _e587 = (_e571 * _e585);
let _e588 = (_e574 * _e585);
let _e594 = bitcast<f32>((bitcast<u32>(_e446.member_1.x) & 2147483647u));
let _e598 = bitcast<f32>((bitcast<u32>(_e446.member_1.y) & 2147483647u));
let _e602 = bitcast<f32>((bitcast<u32>(_e446.member_1.z) & 2147483647u));
let _e605 = ((_e594 >= _e598) && (_e594 >= _e602));
let _e608 = (!(_e605) && (_e598 >= _e602));
let _e615 = (1f / select(select(_e446.member_1.z, _e446.member_1.y, _e608), _e446.member_1.x, _e605));
let _e616 = (select(select(_e446.member_1.x, _e446.member_1.z, _e608), _e446.member_1.y, _e605) * _e615);
let _e617 = (select(select(_e446.member_1.y, _e446.member_1.x, _e608), _e446.member_1.z, _e605) * _e615);
let _e619 = (_e487 - _e446.member.x);
let _e621 = (_e496 - _e446.member.y);
let _e623 = (_e505 - _e446.member.z);
let _e629 = select(select(_e623, _e621, _e608), _e619, _e605);
let _e631 = (select(select(_e619, _e623, _e608), _e621, _e605) - (_e616 * _e629));
let _e633 = (select(select(_e621, _e619, _e608), _e623, _e605) - (_e617 * _e629));
let _e634 = (_e514 - _e446.member.x);
let _e635 = (_e523 - _e446.member.y);
let _e636 = (_e532 - _e446.member.z);
let _e642 = select(select(_e636, _e635, _e608), _e634, _e605);
let _e644 = (select(select(_e634, _e636, _e608), _e635, _e605) - (_e616 * _e642));
let _e646 = (select(select(_e635, _e634, _e608), _e636, _e605) - (_e617 * _e642));
let _e647 = (_e541 - _e446.member.x);
let _e648 = (_e550 - _e446.member.y);
let _e649 = (_e559 - _e446.member.z);
let _e655 = select(select(_e649, _e648, _e608), _e647, _e605);
let _e657 = (select(select(_e647, _e649, _e608), _e648, _e605) - (_e616 * _e655));
let _e659 = (select(select(_e648, _e647, _e608), _e649, _e605) - (_e617 * _e655));
let _e662 = ((_e657 * _e646) - (_e659 * _e644));
let _e665 = ((_e631 * _e659) - (_e633 * _e657));
let _e668 = ((_e644 * _e633) - (_e646 * _e631));
let _e670 = ((_e662 + _e665) + _e668);
let _e673 = (1f / select(_e670, 1f, (_e670 == 0f)));
let _e674 = (_e662 * _e673);
let _e675 = (_e665 * _e673);
let _e676 = (_e668 * _e673);
let _e677 = (_e477 + 9i);
let _e679 = select(_e479, _e677, (_e677 < _e479));
let _e685 = global_3.member[bitcast<u32>(select(0i, _e679, (_e679 > 0i)))];
let _e686 = (_e477 + 10i);
let _e688 = select(_e479, _e686, (_e686 < _e479));
let _e694 = global_3.member[bitcast<u32>(select(0i, _e688, (_e688 > 0i)))];
let _e695 = (_e477 + 11i);
let _e697 = select(_e479, _e695, (_e695 < _e479));
let _e703 = global_3.member[bitcast<u32>(select(0i, _e697, (_e697 > 0i)))];
let _e707 = (_e477 + 12i);
let _e709 = select(_e479, _e707, (_e707 < _e479));
let _e715 = global_3.member[bitcast<u32>(select(0i, _e709, (_e709 > 0i)))];
let _e716 = (_e477 + 13i);
let _e718 = select(_e479, _e716, (_e716 < _e479));
let _e724 = global_3.member[bitcast<u32>(select(0i, _e718, (_e718 > 0i)))];
let _e725 = (_e477 + 14i);
let _e727 = select(_e479, _e725, (_e725 < _e479));
let _e733 = global_3.member[bitcast<u32>(select(0i, _e727, (_e727 > 0i)))];
let _e740 = (_e477 + 15i);
let _e742 = select(_e479, _e740, (_e740 < _e479));
let _e748 = global_3.member[bitcast<u32>(select(0i, _e742, (_e742 > 0i)))];
let _e749 = (_e477 + 16i);
let _e751 = select(_e479, _e749, (_e749 < _e479));
let _e757 = global_3.member[bitcast<u32>(select(0i, _e751, (_e751 > 0i)))];
let _e758 = (_e477 + 17i);
let _e760 = select(_e479, _e758, (_e758 < _e479));
let _e766 = global_3.member[bitcast<u32>(select(0i, _e760, (_e760 > 0i)))];
let _e770 = (((_e685 * _e674) + (_e715 * _e675)) + (_e748 * _e676));
let _e771 = (((_e694 * _e674) + (_e724 * _e675)) + (_e757 * _e676));
let _e772 = (((_e703 * _e674) + (_e733 * _e675)) + (_e766 * _e676));
let _e777 = (((_e770 * _e770) + (_e771 * _e771)) + (_e772 * _e772));
let _e780 = sqrt(select(0f, _e777, (_e777 > 0f)));
let _e783 = (1f / select(1e-20f, _e780, (_e780 > 1e-20f)));
let _e784 = (_e770 * _e783);
let _e785 = (_e771 * _e783);
let _e786 = (_e772 * _e783);
let _e798 = (((((_e784 * _e446.member_1.x) + (_e785 * _e446.member_1.y)) + (_e786 * _e446.member_1.z)) * (((_e586 * _e446.member_1.x) + (_e587 * _e446.member_1.y)) + (_e588 * _e446.member_1.z))) > 0f);
let _e799 = select(_e586, _e784, _e798);
let _e800 = select(_e587, _e785, _e798);
let _e801 = select(_e588, _e786, _e798);
let _e803 = (_e477 + 18i);
let _e805 = select(_e479, _e803, (_e803 < _e479));
let _e811 = global_3.member[bitcast<u32>(select(0i, _e805, (_e805 > 0i)))];
let _e818 = select(0i, select(select(i32(_e811), i32(-2147483648), (_e811 < -2147483600f)), 2147483647i, (_e811 > 2147483500f)), (_e811 == _e811));
let _e819 = (_e818 * 4i);
let _e821 = (bitcast<i32>(_e100) - 1i);
let _e823 = select(_e821, _e819, (_e819 < _e821));
let _e829 = global_4.member[bitcast<u32>(select(0i, _e823, (_e823 > 0i)))];
if (select(_e829, 1f, (_e818 == 16i)) == 0f) {
let _e1885 = type_20(vec3<f32>((_e446.member.x + (_e446.member_1.x * _e446.member_14)), (_e446.member.y + (_e446.member_1.y * _e446.member_14)), (_e446.member.z + (_e446.member_1.z * _e446.member_14))), _e446.member_1, _e446.member_2, _e446.member_3, _e446.member_4, _e446.member_5, _e446.member_6, _e446.member_7, _e446.member_8, _e446.member_9, _e446.member_10, _e446.member_11, _e446.member_12, _e446.member_13, _e446.member_14);
let _e1902 = type_20(_e1885.member, _e1885.member_1, _e1885.member_2, _e1885.member_3, _e1885.member_4, (_e446.member_5 + _e446.member_14), _e1885.member_6, _e1885.member_7, _e1885.member_8, _e1885.member_9, _e1885.member_10, _e1885.member_11, _e1885.member_12, _e1885.member_13, _e1885.member_14);
let _e1918 = type_20(_e1902.member, _e1902.member_1, _e1902.member_2, _e1902.member_3, _e1902.member_4, _e1902.member_5, _e1902.member_6, _e1902.member_7, _e1902.member_8, _e1902.member_9, _e1902.member_10, _e1902.member_11, _e1902.member_12, _e1902.member_13, (_e446.member_14 - _e446.member_14));
let _e1938 = type_20(_e1918.member, _e1918.member_1, _e1918.member_2, _e1918.member_3, _e1918.member_4, _e1918.member_5, _e1918.member_6, _e1918.member_7, _e1918.member_8, _e1918.member_9, (_e446.member_10 + select(0f, _e446.member_14, (_e446.member_8 == 0f))), _e1918.member_11, _e1918.member_12, _e1918.member_13, _e1918.member_14);
let _e1940 = local_10;
if (_e1940 != 16i) {
let _e1958 = type_20(_e1938.member, _e1938.member_1, _e1938.member_2, _e1938.member_3, _e1938.member_4, _e1938.member_5, _e1938.member_6, _e1938.member_7, _e1938.member_8, (_e446.member_9 + _e446.member_14), _e1938.member_10, _e1938.member_11, _e1938.member_12, _e1938.member_13, _e1938.member_14);
let _e1960 = local_11;
let _e1961 = (_e1960 * 4i);
let _e1962 = (_e1961 + 1i);
let _e1964 = select(_e821, _e1962, (_e1962 < _e821));
let _e1970 = global_4.member[bitcast<u32>(select(0i, _e1964, (_e1964 > 0i)))];
let _e1972 = -((_e1970 * _e446.member_14));
let _e1974 = select(-87f, _e1972, (_e1972 > -87f));
let _e1976 = select(88f, _e1974, (_e1974 < 88f));
let _e1978 = ((_e1976 * 1.442695f) + 0.5f);
let _e1980 = select(-127f, _e1978, (_e1978 > -127f));
let _e1982 = select(128f, _e1980, (_e1980 < 128f));
let _e1989 = select(0i, select(select(i32(_e1982), i32(-2147483648), (_e1982 < -2147483600f)), 2147483647i, (_e1982 > 2147483500f)), (_e1982 == _e1982));
let _e1993 = (_e1989 - select(0i, 1i, (_e1982 < f32(_e1989))));
let _e1994 = f32(_e1993);
let _e1998 = ((_e1976 - (_e1994 * 0.6933594f)) - (_e1994 * -2.1219444e-4f));
let _e2022 = (_e1961 + 2i);
let _e2024 = select(_e821, _e2022, (_e2022 < _e821));
let _e2030 = global_4.member[bitcast<u32>(select(0i, _e2024, (_e2024 > 0i)))];
let _e2032 = -((_e2030 * _e446.member_14));
let _e2034 = select(-87f, _e2032, (_e2032 > -87f));
let _e2036 = select(88f, _e2034, (_e2034 < 88f));
let _e2038 = ((_e2036 * 1.442695f) + 0.5f);
let _e2040 = select(-127f, _e2038, (_e2038 > -127f));
let _e2042 = select(128f, _e2040, (_e2040 < 128f));
let _e2049 = select(0i, select(select(i32(_e2042), i32(-2147483648), (_e2042 < -2147483600f)), 2147483647i, (_e2042 > 2147483500f)), (_e2042 == _e2042));
let _e2053 = (_e2049 - select(0i, 1i, (_e2042 < f32(_e2049))));
let _e2054 = f32(_e2053);
let _e2058 = ((_e2036 - (_e2054 * 0.6933594f)) - (_e2054 * -2.1219444e-4f));
let _e2082 = (_e1961 + 3i);
let _e2084 = select(_e821, _e2082, (_e2082 < _e821));
let _e2090 = global_4.member[bitcast<u32>(select(0i, _e2084, (_e2084 > 0i)))];
let _e2092 = -((_e2090 * _e446.member_14));
let _e2094 = select(-87f, _e2092, (_e2092 > -87f));
let _e2096 = select(88f, _e2094, (_e2094 < 88f));
let _e2098 = ((_e2096 * 1.442695f) + 0.5f);
let _e2100 = select(-127f, _e2098, (_e2098 > -127f));
let _e2102 = select(128f, _e2100, (_e2100 < 128f));
let _e2109 = select(0i, select(select(i32(_e2102), i32(-2147483648), (_e2102 < -2147483600f)), 2147483647i, (_e2102 > 2147483500f)), (_e2102 == _e2102));
let _e2113 = (_e2109 - select(0i, 1i, (_e2102 < f32(_e2109))));
let _e2114 = f32(_e2113);
let _e2118 = ((_e2096 - (_e2114 * 0.6933594f)) - (_e2114 * -2.1219444e-4f));
phi_3101_ = type_20(_e1958.member, _e1958.member_1, vec3<f32>((_e446.member_2.x * ((1f + (_e1998 * (1f + (_e1998 * (0.5f + (_e1998 * (0.16666667f + (_e1998 * (0.041666668f + (_e1998 * (0.008333334f + (_e1998 * (0.001388889f + (_e1998 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1993 + 127i)) << bitcast<u32>(23i))))), (_e446.member_2.y * ((1f + (_e2058 * (1f + (_e2058 * (0.5f + (_e2058 * (0.16666667f + (_e2058 * (0.041666668f + (_e2058 * (0.008333334f + (_e2058 * (0.001388889f + (_e2058 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2053 + 127i)) << bitcast<u32>(23i))))), (_e446.member_2.z * ((1f + (_e2118 * (1f + (_e2118 * (0.5f + (_e2118 * (0.16666667f + (_e2118 * (0.041666668f + (_e2118 * (0.008333334f + (_e2118 * (0.001388889f + (_e2118 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2113 + 127i)) << bitcast<u32>(23i)))))), _e1958.member_3, _e1958.member_4, _e1958.member_5, _e1958.member_6, _e1958.member_7, _e1958.member_8, _e1958.member_9, _e1958.member_10, _e1958.member_11, _e1958.member_12, _e1958.member_13, _e1958.member_14);
} else {
phi_3101_ = _e1938;
}
let _e2159 = phi_3101_;
phi_4289_ = type_20(_e2159.member, _e2159.member_1, _e2159.member_2, _e2159.member_3, _e2159.member_4, _e2159.member_5, 3f, _e2159.member_7, _e2159.member_8, _e2159.member_9, _e2159.member_10, _e2159.member_11, _e2159.member_12, _e2159.member_13, _e2159.member_14);
phi_4290_ = _e450;
} else {
let _e835 = (1i << bitcast<u32>((_e818 & 31i)));
if ((((_e446.member_1.x * _e586) + (_e446.member_1.y * _e587)) + (_e446.member_1.z * _e588)) < 0f) {
phi_3121_ = (_e450 | _e835);
} else {
phi_3121_ = (_e450 & ~(_e835));
}
let _e846 = phi_3121_;
phi_3123_ = 15i;
phi_3126_ = 16i;
loop {
let _e848 = phi_3123_;
let _e850 = phi_3126_;
local_3 = _e850;
local_6 = _e850;
local_7 = _e850;
local_9 = _e850;
let _e851 = (_e848 >= 0i);
if _e851 {
phi_3124_ = (_e848 - 1i);
phi_3127_ = select(_e850, _e848, (((_e846 >> bitcast<u32>((_e848 & 31i))) & 1i) == 1i));
} else {
phi_3124_ = i32();
phi_3127_ = i32();
}
let _e860 = phi_3124_;
let _e862 = phi_3127_;
continue;
continuing {
phi_3123_ = _e860;
phi_3126_ = _e862;
break if !(_e851);
}
}
let _e892 = type_20(vec3<f32>((_e446.member.x + (_e446.member_1.x * _e446.member_14)), (_e446.member.y + (_e446.member_1.y * _e446.member_14)), (_e446.member.z + (_e446.member_1.z * _e446.member_14))), _e446.member_1, _e446.member_2, _e446.member_3, _e446.member_4, _e446.member_5, _e446.member_6, _e446.member_7, _e446.member_8, _e446.member_9, _e446.member_10, _e446.member_11, _e446.member_12, _e446.member_13, _e446.member_14);
let _e909 = type_20(_e892.member, _e892.member_1, _e892.member_2, _e892.member_3, _e892.member_4, (_e446.member_5 + _e446.member_14), _e892.member_6, _e892.member_7, _e892.member_8, _e892.member_9, _e892.member_10, _e892.member_11, _e892.member_12, _e892.member_13, _e892.member_14);
let _e929 = type_20(_e909.member, _e909.member_1, _e909.member_2, _e909.member_3, _e909.member_4, _e909.member_5, _e909.member_6, _e909.member_7, _e909.member_8, _e909.member_9, (_e446.member_10 + select(0f, _e446.member_14, (_e446.member_8 == 0f))), _e909.member_11, _e909.member_12, _e909.member_13, _e909.member_14);
let _e931 = local;
if (_e931 != 16i) {
let _e949 = type_20(_e929.member, _e929.member_1, _e929.member_2, _e929.member_3, _e929.member_4, _e929.member_5, _e929.member_6, _e929.member_7, _e929.member_8, (_e446.member_9 + _e446.member_14), _e929.member_10, _e929.member_11, _e929.member_12, _e929.member_13, _e929.member_14);
let _e951 = local_1;
let _e952 = (_e951 * 4i);
let _e953 = (_e952 + 1i);
let _e955 = select(_e821, _e953, (_e953 < _e821));
let _e961 = global_4.member[bitcast<u32>(select(0i, _e955, (_e955 > 0i)))];
let _e963 = -((_e961 * _e446.member_14));
let _e965 = select(-87f, _e963, (_e963 > -87f));
let _e967 = select(88f, _e965, (_e965 < 88f));
let _e969 = ((_e967 * 1.442695f) + 0.5f);
let _e971 = select(-127f, _e969, (_e969 > -127f));
let _e973 = select(128f, _e971, (_e971 < 128f));
let _e980 = select(0i, select(select(i32(_e973), i32(-2147483648), (_e973 < -2147483600f)), 2147483647i, (_e973 > 2147483500f)), (_e973 == _e973));
let _e984 = (_e980 - select(0i, 1i, (_e973 < f32(_e980))));
let _e985 = f32(_e984);
let _e989 = ((_e967 - (_e985 * 0.6933594f)) - (_e985 * -2.1219444e-4f));
let _e1013 = (_e952 + 2i);
let _e1015 = select(_e821, _e1013, (_e1013 < _e821));
let _e1021 = global_4.member[bitcast<u32>(select(0i, _e1015, (_e1015 > 0i)))];
let _e1023 = -((_e1021 * _e446.member_14));
let _e1025 = select(-87f, _e1023, (_e1023 > -87f));
let _e1027 = select(88f, _e1025, (_e1025 < 88f));
let _e1029 = ((_e1027 * 1.442695f) + 0.5f);
let _e1031 = select(-127f, _e1029, (_e1029 > -127f));
let _e1033 = select(128f, _e1031, (_e1031 < 128f));
let _e1040 = select(0i, select(select(i32(_e1033), i32(-2147483648), (_e1033 < -2147483600f)), 2147483647i, (_e1033 > 2147483500f)), (_e1033 == _e1033));
let _e1044 = (_e1040 - select(0i, 1i, (_e1033 < f32(_e1040))));
let _e1045 = f32(_e1044);
let _e1049 = ((_e1027 - (_e1045 * 0.6933594f)) - (_e1045 * -2.1219444e-4f));
let _e1073 = (_e952 + 3i);
let _e1075 = select(_e821, _e1073, (_e1073 < _e821));
let _e1081 = global_4.member[bitcast<u32>(select(0i, _e1075, (_e1075 > 0i)))];
let _e1083 = -((_e1081 * _e446.member_14));
let _e1085 = select(-87f, _e1083, (_e1083 > -87f));
let _e1087 = select(88f, _e1085, (_e1085 < 88f));
let _e1089 = ((_e1087 * 1.442695f) + 0.5f);
let _e1091 = select(-127f, _e1089, (_e1089 > -127f));
let _e1093 = select(128f, _e1091, (_e1091 < 128f));
let _e1100 = select(0i, select(select(i32(_e1093), i32(-2147483648), (_e1093 < -2147483600f)), 2147483647i, (_e1093 > 2147483500f)), (_e1093 == _e1093));
let _e1104 = (_e1100 - select(0i, 1i, (_e1093 < f32(_e1100))));
let _e1105 = f32(_e1104);
let _e1109 = ((_e1087 - (_e1105 * 0.6933594f)) - (_e1105 * -2.1219444e-4f));
phi_3428_ = type_20(_e949.member, _e949.member_1, vec3<f32>((_e446.member_2.x * ((1f + (_e989 * (1f + (_e989 * (0.5f + (_e989 * (0.16666667f + (_e989 * (0.041666668f + (_e989 * (0.008333334f + (_e989 * (0.001388889f + (_e989 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e984 + 127i)) << bitcast<u32>(23i))))), (_e446.member_2.y * ((1f + (_e1049 * (1f + (_e1049 * (0.5f + (_e1049 * (0.16666667f + (_e1049 * (0.041666668f + (_e1049 * (0.008333334f + (_e1049 * (0.001388889f + (_e1049 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1044 + 127i)) << bitcast<u32>(23i))))), (_e446.member_2.z * ((1f + (_e1109 * (1f + (_e1109 * (0.5f + (_e1109 * (0.16666667f + (_e1109 * (0.041666668f + (_e1109 * (0.008333334f + (_e1109 * (0.001388889f + (_e1109 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1104 + 127i)) << bitcast<u32>(23i)))))), _e949.member_3, _e949.member_4, _e949.member_5, _e949.member_6, _e949.member_7, _e949.member_8, _e949.member_9, _e949.member_10, _e949.member_11, _e949.member_12, _e949.member_13, _e949.member_14);
} else {
phi_3428_ = _e929;
}
let _e1150 = phi_3428_;
let _e1152 = local_2;
let _e1154 = local_3;
if (_e1152 == _e1154) {
let _e1732 = global_1.member.member_17.member.member;
let _e1746 = ((((_e1732.member.member * _e1150.member.x) + (_e1732.member.member_1 * _e1150.member.y)) + (_e1732.member.member_2 * _e1150.member.z)) + _e1732.member_1);
let _e1755 = -((((_e1732.member.member * _e1150.member_1.x) + (_e1732.member.member_1 * _e1150.member_1.y)) + (_e1732.member.member_2 * _e1150.member_1.z)));
let _e1757 = (_e1755 > 1e-9f);
let _e1761 = ((_e1746 / select(1e-9f, _e1755, _e1757)) - 0.015625f);
let _e1764 = select(1e30f, select(0f, _e1761, (_e1761 > 0f)), ((_e1746 > 0f) && _e1757));
let _e1769 = global_1.member.member_17.member_1.member;
let _e1780 = ((((_e1769.member.member * _e1150.member.x) + (_e1769.member.member_1 * _e1150.member.y)) + (_e1769.member.member_2 * _e1150.member.z)) + _e1769.member_1);
let _e1786 = -((((_e1769.member.member * _e1150.member_1.x) + (_e1769.member.member_1 * _e1150.member_1.y)) + (_e1769.member.member_2 * _e1150.member_1.z)));
let _e1788 = (_e1786 > 1e-9f);
let _e1792 = ((_e1780 / select(1e-9f, _e1786, _e1788)) - 0.015625f);
let _e1795 = select(1e30f, select(0f, _e1792, (_e1792 > 0f)), ((_e1780 > 0f) && _e1788));
let _e1799 = (_e1795 < _e1764);
let _e1817 = type_20(_e1150.member, _e1150.member_1, _e1150.member_2, _e1150.member_3, _e1150.member_4, _e1150.member_5, _e1150.member_6, _e1150.member_7, _e1150.member_8, _e1150.member_9, _e1150.member_10, _e1150.member_11, 0i, _e1150.member_13, _e1150.member_14);
let _e1832 = type_20(_e1817.member, _e1817.member_1, _e1817.member_2, _e1817.member_3, _e1817.member_4, _e1817.member_5, _e1817.member_6, _e1817.member_7, _e1817.member_8, _e1817.member_9, _e1817.member_10, _e1817.member_11, _e1817.member_12, select(select(-2i, -3i, _e1799), -1i, ((_e1764 >= 1e30f) && (_e1795 >= 1e30f))), _e1817.member_14);
phi_4281_ = type_20(_e1832.member, _e1832.member_1, _e1832.member_2, _e1832.member_3, _e1832.member_4, _e1832.member_5, _e1832.member_6, _e1832.member_7, _e1832.member_8, _e1832.member_9, _e1832.member_10, _e1832.member_11, _e1832.member_12, _e1832.member_13, select(_e1764, _e1795, _e1799));
phi_4282_ = type_20();
phi_4283_ = true;
} else {
let _e1158 = local_4;
let _e1159 = (_e1158 * 4i);
let _e1161 = select(_e821, _e1159, (_e1159 < _e821));
let _e1167 = global_4.member[bitcast<u32>(select(0i, _e1161, (_e1161 > 0i)))];
let _e1169 = local_5;
let _e1171 = select(_e1167, 1f, (_e1169 == 16i));
let _e1173 = local_6;
let _e1174 = (_e1173 * 4i);
let _e1176 = select(_e821, _e1174, (_e1174 < _e821));
let _e1182 = global_4.member[bitcast<u32>(select(0i, _e1176, (_e1176 > 0i)))];
let _e1184 = local_7;
let _e1186 = select(_e1182, 1f, (_e1184 == 16i));
let _e1196 = select(1f, -1f, ((((_e1150.member_1.x * _e799) + (_e1150.member_1.y * _e800)) + (_e1150.member_1.z * _e801)) > 0f));
let _e1197 = (_e799 * _e1196);
let _e1198 = (_e800 * _e1196);
let _e1199 = (_e801 * _e1196);
let _e1205 = -((((_e1150.member_1.x * _e1197) + (_e1150.member_1.y * _e1198)) + (_e1150.member_1.z * _e1199)));
let _e1207 = select(0f, _e1205, (_e1205 > 0f));
let _e1208 = (_e1171 / _e1186);
let _e1210 = (_e1207 * _e1207);
let _e1213 = (1f - ((_e1208 * _e1208) * (1f - _e1210)));
let _e1214 = (_e1213 <= 0f);
let _e1222 = ((_e1208 * _e1207) - sqrt(select(0f, _e1213, (_e1213 > 0f))));
let _e1229 = (2f * _e1207);
let _e1236 = select(((_e1150.member_1.x * _e1208) + (_e1197 * _e1222)), (_e1150.member_1.x + (_e1197 * _e1229)), _e1214);
let _e1237 = select(((_e1150.member_1.y * _e1208) + (_e1198 * _e1222)), (_e1150.member_1.y + (_e1198 * _e1229)), _e1214);
let _e1238 = select(((_e1150.member_1.z * _e1208) + (_e1199 * _e1222)), (_e1150.member_1.z + (_e1199 * _e1229)), _e1214);
let _e1243 = (((_e1236 * _e1236) + (_e1237 * _e1237)) + (_e1238 * _e1238));
let _e1246 = sqrt(select(0f, _e1243, (_e1243 > 0f)));
let _e1249 = (1f / select(1e-20f, _e1246, (_e1246 > 1e-20f)));
let _e1254 = (_e1186 / _e1171);
let _e1257 = (((_e1254 * _e1254) - 1f) + _e1210);
let _e1260 = sqrt(select(0f, _e1257, (_e1257 > 0f)));
let _e1261 = (_e1260 - _e1207);
let _e1262 = (_e1260 + _e1207);
let _e1265 = (_e1261 / select(1e-6f, _e1262, (_e1262 > 1e-6f)));
let _e1269 = ((_e1207 * _e1261) + 1f);
let _e1272 = (((_e1207 * _e1262) - 1f) / select(1e-6f, _e1269, (_e1269 > 1e-6f)));
let _e1286 = global_1.member.member_1;
let _e1289 = select(0f, select(select((((0.5f * _e1265) * _e1265) * (1f + (_e1272 * _e1272))), 1f, (_e1257 <= 0f)), 0f, (_e1171 == _e1186)), ((_e1286 & 1u) != 0u));
if (_e1150.member_8 == 0f) {
let _e1304 = type_20(_e1150.member, _e1150.member_1, _e1150.member_2, vec3<f32>(_e799, _e800, _e801), _e1150.member_4, _e1150.member_5, _e1150.member_6, _e1150.member_7, _e1150.member_8, _e1150.member_9, _e1150.member_10, _e1150.member_11, _e1150.member_12, _e1150.member_13, _e1150.member_14);
phi_3763_ = type_20(_e1304.member, _e1304.member_1, _e1304.member_2, _e1304.member_3, _e1304.member_4, _e1304.member_5, _e1304.member_6, _e1304.member_7, _e1304.member_8, _e1304.member_9, _e1304.member_10, _e1289, _e1304.member_12, _e1304.member_13, _e1304.member_14);
} else {
phi_3763_ = _e1150;
}
let _e1321 = phi_3763_;
let _e1323 = (_e1321.member_8 + 1f);
let _e1338 = type_20(_e1321.member, _e1321.member_1, _e1321.member_2, _e1321.member_3, _e1321.member_4, _e1321.member_5, _e1321.member_6, _e1321.member_7, _e1323, _e1321.member_9, _e1321.member_10, _e1321.member_11, _e1321.member_12, _e1321.member_13, _e1321.member_14);
let _e1341 = ((_e107.member_2 == 0u) && (_e1323 >= 2f));
if (_e1214 && _e1341) {
let _e1366 = (((_e1321.member_1.x * _e799) + (_e1321.member_1.y * _e800)) + (_e1321.member_1.z * _e801));
let _e1370 = (_e1321.member_1.x - (_e799 * _e1366));
let _e1371 = (_e1321.member_1.y - (_e800 * _e1366));
let _e1372 = (_e1321.member_1.z - (_e801 * _e1366));
let _e1377 = (((_e1370 * _e1370) + (_e1371 * _e1371)) + (_e1372 * _e1372));
let _e1380 = sqrt(select(0f, _e1377, (_e1377 > 0f)));
let _e1383 = (1f / select(1e-20f, _e1380, (_e1380 > 1e-20f)));
phi_3816_ = type_20(_e1338.member, vec3<f32>((_e1370 * _e1383), (_e1371 * _e1383), (_e1372 * _e1383)), _e1338.member_2, _e1338.member_3, _e1338.member_4, _e1338.member_5, _e1338.member_6, _e1338.member_7, _e1338.member_8, _e1338.member_9, _e1338.member_10, _e1338.member_11, _e1338.member_12, _e1338.member_13, _e1338.member_14);
} else {
phi_3816_ = type_20(_e1338.member, vec3<f32>((_e1236 * _e1249), (_e1237 * _e1249), (_e1238 * _e1249)), _e1338.member_2, _e1338.member_3, _e1338.member_4, _e1338.member_5, _e1338.member_6, _e1338.member_7, _e1338.member_8, _e1338.member_9, _e1338.member_10, _e1338.member_11, _e1338.member_12, _e1338.member_13, _e1338.member_14);
}
let _e1404 = phi_3816_;
if _e1214 {
phi_3830_ = _e1404;
} else {
let _e1405 = (1f - _e1289);
phi_3830_ = type_20(_e1404.member, _e1404.member_1, vec3<f32>((_e1404.member_2.x * _e1405), (_e1404.member_2.y * _e1405), (_e1404.member_2.z * _e1405)), _e1404.member_3, _e1404.member_4, _e1404.member_5, _e1404.member_6, _e1404.member_7, _e1404.member_8, _e1404.member_9, _e1404.member_10, _e1404.member_11, _e1404.member_12, _e1404.member_13, _e1404.member_14);
}
let _e1432 = phi_3830_;
let _e1439 = global_1.member.member_17.member.member;
let _e1453 = ((((_e1439.member.member * _e1432.member.x) + (_e1439.member.member_1 * _e1432.member.y)) + (_e1439.member.member_2 * _e1432.member.z)) + _e1439.member_1);
let _e1462 = -((((_e1439.member.member * _e1432.member_1.x) + (_e1439.member.member_1 * _e1432.member_1.y)) + (_e1439.member.member_2 * _e1432.member_1.z)));
let _e1464 = (_e1462 > 1e-9f);
let _e1468 = ((_e1453 / select(1e-9f, _e1462, _e1464)) - 0.015625f);
let _e1471 = select(1e30f, select(0f, _e1468, (_e1468 > 0f)), ((_e1453 > 0f) && _e1464));
let _e1476 = global_1.member.member_17.member_1.member;
let _e1487 = ((((_e1476.member.member * _e1432.member.x) + (_e1476.member.member_1 * _e1432.member.y)) + (_e1476.member.member_2 * _e1432.member.z)) + _e1476.member_1);
let _e1493 = -((((_e1476.member.member * _e1432.member_1.x) + (_e1476.member.member_1 * _e1432.member_1.y)) + (_e1476.member.member_2 * _e1432.member_1.z)));
let _e1495 = (_e1493 > 1e-9f);
let _e1499 = ((_e1487 / select(1e-9f, _e1493, _e1495)) - 0.015625f);
let _e1502 = select(1e30f, select(0f, _e1499, (_e1499 > 0f)), ((_e1487 > 0f) && _e1495));
let _e1506 = (_e1502 < _e1471);
let _e1508 = select(select(-2i, -3i, _e1506), -1i, ((_e1471 >= 1e30f) && (_e1502 >= 1e30f)));
let _e1509 = select(_e1471, _e1502, _e1506);
let _e1524 = type_20(_e1432.member, _e1432.member_1, _e1432.member_2, _e1432.member_3, _e1432.member_4, _e1432.member_5, _e1432.member_6, _e1432.member_7, _e1432.member_8, _e1432.member_9, _e1432.member_10, _e1432.member_11, 0i, _e1432.member_13, _e1432.member_14);
let _e1539 = type_20(_e1524.member, _e1524.member_1, _e1524.member_2, _e1524.member_3, _e1524.member_4, _e1524.member_5, _e1524.member_6, _e1524.member_7, _e1524.member_8, _e1524.member_9, _e1524.member_10, _e1524.member_11, _e1524.member_12, _e1508, _e1524.member_14);
let _e1554 = type_20(_e1539.member, _e1539.member_1, _e1539.member_2, _e1539.member_3, _e1539.member_4, _e1539.member_5, _e1539.member_6, _e1539.member_7, _e1539.member_8, _e1539.member_9, _e1539.member_10, _e1539.member_11, _e1539.member_12, _e1539.member_13, _e1509);
let _e1556 = local_8;
let _e1558 = local_9;
let _e1561 = ((_e1286 & 2u) != 0u);
if (_e1341 && !(_e1561)) {
if (_e1508 == -1i) {
phi_4255_ = type_20(_e1554.member, _e1554.member_1, _e1554.member_2, _e1554.member_3, _e1554.member_4, _e1554.member_5, 1f, _e1554.member_7, _e1554.member_8, _e1554.member_9, _e1554.member_10, _e1554.member_11, _e1554.member_12, _e1554.member_13, _e1554.member_14);
} else {
let _e1637 = type_20(vec3<f32>((_e1432.member.x + (_e1432.member_1.x * _e1509)), (_e1432.member.y + (_e1432.member_1.y * _e1509)), (_e1432.member.z + (_e1432.member_1.z * _e1509))), _e1554.member_1, _e1554.member_2, _e1554.member_3, _e1554.member_4, _e1554.member_5, _e1554.member_6, _e1554.member_7, _e1554.member_8, _e1554.member_9, _e1554.member_10, _e1554.member_11, _e1554.member_12, _e1554.member_13, _e1554.member_14);
let _e1654 = type_20(_e1637.member, _e1637.member_1, _e1637.member_2, _e1637.member_3, _e1637.member_4, (_e1432.member_5 + _e1509), _e1637.member_6, _e1637.member_7, _e1637.member_8, _e1637.member_9, _e1637.member_10, _e1637.member_11, _e1637.member_12, _e1637.member_13, _e1637.member_14);
let _e1670 = type_20(_e1654.member, _e1654.member_1, _e1654.member_2, _e1654.member_3, _e1654.member_4, _e1654.member_5, _e1654.member_6, _e1654.member_7, _e1654.member_8, _e1654.member_9, _e1654.member_10, _e1654.member_11, _e1654.member_12, _e1654.member_13, (_e1509 - _e1509));
let _e1690 = type_20(_e1670.member, _e1670.member_1, _e1670.member_2, _e1670.member_3, _e1670.member_4, _e1670.member_5, _e1670.member_6, _e1670.member_7, _e1670.member_8, _e1670.member_9, (_e1432.member_10 + select(0f, _e1509, (_e1432.member_8 == 0f))), _e1670.member_11, _e1670.member_12, _e1670.member_13, _e1670.member_14);
phi_4255_ = type_20(_e1690.member, _e1690.member_1, _e1690.member_2, _e1690.member_3, _e1690.member_4, _e1690.member_5, 3f, _e1690.member_7, _e1690.member_8, _e1690.member_9, _e1690.member_10, _e1690.member_11, _e1690.member_12, _e1690.member_13, _e1690.member_14);
}
let _e1722 = phi_4255_;
phi_4276_ = _e1722;
} else {
let _e1568 = global_1.member.member_5;
if ((!(_e1341) && (_e1432.member_8 >= f32(bitcast<i32>(_e1568)))) && (select(_e1558, _e1556, _e1214) != 16i)) {
phi_4275_ = type_20(_e1554.member, _e1554.member_1, _e1554.member_2, _e1554.member_3, _e1554.member_4, _e1554.member_5, 2f, _e1554.member_7, _e1554.member_8, _e1554.member_9, _e1554.member_10, _e1554.member_11, _e1554.member_12, _e1554.member_13, _e1554.member_14);
} else {
if _e1561 {
phi_4274_ = type_20(_e1554.member, _e1554.member_1, _e1554.member_2, _e1554.member_3, _e1554.member_4, _e1554.member_5, 4f, _e1554.member_7, _e1554.member_8, _e1554.member_9, _e1554.member_10, _e1554.member_11, _e1554.member_12, _e1554.member_13, _e1554.member_14);
} else {
phi_4274_ = _e1554;
}
let _e1591 = phi_4274_;
phi_4275_ = _e1591;
}
let _e1608 = phi_4275_;
phi_4276_ = _e1608;
}
let _e1724 = phi_4276_;
phi_4281_ = _e1724;
phi_4282_ = _e1724;
phi_4283_ = !(_e1214);
}
let _e1849 = phi_4281_;
let _e1851 = phi_4282_;
let _e1853 = phi_4283_;
if _e1853 {
phi_4287_ = _e1849;
} else {
phi_4287_ = _e1851;
}
let _e1855 = phi_4287_;
phi_4289_ = _e1855;
phi_4290_ = select(_e450, _e846, _e1853);
}
let _e2176 = phi_4289_;
let _e2178 = phi_4290_;
phi_4291_ = _e2176;
phi_4292_ = _e2178;
}
let _e2646 = phi_4291_;
let _e2648 = phi_4292_;
phi_4293_ = _e2646;
phi_4294_ = _e2648;
}
let _e3038 = phi_4293_;
let _e3040 = phi_4294_;
phi_728_ = _e3038;
phi_731_ = (_e448 + 1i);
phi_733_ = _e3040;
} else {
phi_728_ = type_20();
phi_731_ = i32();
phi_733_ = i32();
}
let _e3042 = phi_728_;
let _e3044 = phi_731_;
let _e3046 = phi_733_;
continue;
continuing {
phi_727_ = _e3042;
phi_730_ = _e3044;
phi_732_ = _e3046;
break if !(_e454);
}
}
let _e3049 = local_15;
if (_e3049 == 0i) {
phi_4300_ = 16i;
} else {
let _e3052 = local_16;
phi_4300_ = -(_e3052);
}
let _e3055 = phi_4300_;
let _e3057 = local_17;
let _e3061 = local_18;
let _e3065 = local_19;
let _e3069 = local_20;
let _e3073 = local_21;
let _e3077 = local_22;
let _e3081 = local_23;
let _e3085 = local_24;
let _e3089 = local_25;
let _e3093 = local_26;
let _e3097 = local_27;
let _e3101 = local_28;
let _e3105 = local_29;
let _e3109 = local_30;
let _e3113 = local_31;
let _e3117 = local_32;
let _e3121 = local_33;
let _e3124 = local_34;
let _e3127 = local_35;
let _e3130 = local_36;
let _e3133 = local_37;
let _e3137 = local_38;
let _e3141 = local_39;
global_5.member[_e116] = _e3057.member.x;
global_5.member[_e128] = _e3061.member.y;
global_5.member[_e139] = _e3065.member.z;
global_5.member[_e150] = _e3069.member_1.x;
global_5.member[_e161] = _e3073.member_1.y;
global_5.member[_e172] = _e3077.member_1.z;
global_5.member[_e183] = _e3081.member_2.x;
global_5.member[_e194] = _e3085.member_2.y;
global_5.member[_e205] = _e3089.member_2.z;
global_5.member[_e216] = _e3093.member_3.x;
global_5.member[_e227] = _e3097.member_3.y;
global_5.member[_e238] = _e3101.member_3.z;
global_5.member[_e249] = _e3105.member_4.x;
global_5.member[_e260] = _e3109.member_4.y;
global_5.member[_e271] = _e3113.member_4.z;
global_5.member[_e282] = _e3117.member_5;
let _e3178 = local_40;
global_5.member[_e293] = _e3178;
global_5.member[_e304] = f32(_e3055);
global_5.member[_e315] = _e3121.member_8;
global_5.member[_e326] = _e3124.member_9;
global_5.member[_e337] = _e3127.member_10;
global_5.member[_e348] = _e3130.member_11;
global_5.member[_e359] = f32(_e3133.member_12);
global_5.member[_e370] = f32(_e3137.member_13);
global_5.member[_e381] = _e3141.member_14;
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
