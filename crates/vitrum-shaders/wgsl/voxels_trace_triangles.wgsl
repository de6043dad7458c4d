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
fn function_() {
var phi_640_: u32;
var phi_850_: i32;
var phi_852_: type_20;
var phi_855_: i32;
var phi_857_: i32;
var phi_2131_: i32;
var phi_2134_: i32;
var phi_2132_: i32;
var phi_2135_: i32;
var phi_3246_: i32;
var phi_3248_: i32;
var phi_3251_: i32;
var phi_3249_: i32;
var phi_3252_: i32;
var local: i32;
var local_1: i32;
var phi_3553_: type_20;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var phi_3888_: type_20;
var phi_3941_: type_20;
var phi_3955_: type_20;
var local_8: i32;
var local_9: i32;
var phi_4399_: type_20;
var phi_4400_: type_20;
var phi_4380_: type_20;
var phi_4401_: type_20;
var phi_4406_: type_20;
var phi_4407_: type_20;
var phi_4408_: bool;
var phi_4412_: type_20;
var local_10: i32;
var local_11: i32;
var phi_3226_: type_20;
var phi_4414_: type_20;
var phi_4415_: i32;
var phi_1521_: i32;
var phi_1524_: i32;
var phi_1522_: i32;
var phi_1525_: i32;
var local_12: i32;
var local_13: i32;
var local_14: i32;
var phi_2127_: type_20;
var phi_1841_: type_20;
var phi_2129_: type_20;
var phi_4416_: type_20;
var phi_4417_: i32;
var phi_1480_: type_20;
var phi_1481_: type_20;
var phi_1513_: i32;
var phi_4418_: type_20;
var phi_4419_: i32;
var phi_853_: type_20;
var phi_856_: i32;
var phi_858_: i32;
var local_15: i32;
var local_16: i32;
var phi_4425_: i32;
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
let _e93 = global;
let _e97 = arrayLength((&global_3.member));
let _e99 = arrayLength((&global_4.member));
let _e104 = global_1.member.member;
if (_e93.x < _e104.member) {
if (_e93.y < _e104.member_1) {
let _e111 = (_e104.member * _e104.member_1);
let _e113 = ((_e93.y * _e104.member) + _e93.x);
let _e114 = bitcast<i32>(_e113);
let _e116 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e118 = select(_e116, _e114, (_e114 < _e116));
let _e124 = global_5.member[bitcast<u32>(select(0i, _e118, (_e118 > 0i)))];
let _e125 = (_e111 + _e113);
let _e126 = bitcast<i32>(_e125);
let _e128 = select(_e116, _e126, (_e126 < _e116));
let _e134 = global_5.member[bitcast<u32>(select(0i, _e128, (_e128 > 0i)))];
let _e136 = ((2u * _e111) + _e113);
let _e137 = bitcast<i32>(_e136);
let _e139 = select(_e116, _e137, (_e137 < _e116));
let _e145 = global_5.member[bitcast<u32>(select(0i, _e139, (_e139 > 0i)))];
let _e147 = ((3u * _e111) + _e113);
let _e148 = bitcast<i32>(_e147);
let _e150 = select(_e116, _e148, (_e148 < _e116));
let _e156 = global_5.member[bitcast<u32>(select(0i, _e150, (_e150 > 0i)))];
let _e158 = ((4u * _e111) + _e113);
let _e159 = bitcast<i32>(_e158);
let _e161 = select(_e116, _e159, (_e159 < _e116));
let _e167 = global_5.member[bitcast<u32>(select(0i, _e161, (_e161 > 0i)))];
let _e169 = ((5u * _e111) + _e113);
let _e170 = bitcast<i32>(_e169);
let _e172 = select(_e116, _e170, (_e170 < _e116));
let _e178 = global_5.member[bitcast<u32>(select(0i, _e172, (_e172 > 0i)))];
let _e180 = ((6u * _e111) + _e113);
let _e181 = bitcast<i32>(_e180);
let _e183 = select(_e116, _e181, (_e181 < _e116));
let _e189 = global_5.member[bitcast<u32>(select(0i, _e183, (_e183 > 0i)))];
let _e191 = ((7u * _e111) + _e113);
let _e192 = bitcast<i32>(_e191);
let _e194 = select(_e116, _e192, (_e192 < _e116));
let _e200 = global_5.member[bitcast<u32>(select(0i, _e194, (_e194 > 0i)))];
let _e202 = ((8u * _e111) + _e113);
let _e203 = bitcast<i32>(_e202);
let _e205 = select(_e116, _e203, (_e203 < _e116));
let _e211 = global_5.member[bitcast<u32>(select(0i, _e205, (_e205 > 0i)))];
let _e213 = ((9u * _e111) + _e113);
let _e214 = bitcast<i32>(_e213);
let _e216 = select(_e116, _e214, (_e214 < _e116));
let _e222 = global_5.member[bitcast<u32>(select(0i, _e216, (_e216 > 0i)))];
let _e224 = ((10u * _e111) + _e113);
let _e225 = bitcast<i32>(_e224);
let _e227 = select(_e116, _e225, (_e225 < _e116));
let _e233 = global_5.member[bitcast<u32>(select(0i, _e227, (_e227 > 0i)))];
let _e235 = ((11u * _e111) + _e113);
let _e236 = bitcast<i32>(_e235);
let _e238 = select(_e116, _e236, (_e236 < _e116));
let _e244 = global_5.member[bitcast<u32>(select(0i, _e238, (_e238 > 0i)))];
let _e246 = ((12u * _e111) + _e113);
let _e247 = bitcast<i32>(_e246);
let _e249 = select(_e116, _e247, (_e247 < _e116));
let _e255 = global_5.member[bitcast<u32>(select(0i, _e249, (_e249 > 0i)))];
let _e257 = ((13u * _e111) + _e113);
let _e258 = bitcast<i32>(_e257);
let _e260 = select(_e116, _e258, (_e258 < _e116));
let _e266 = global_5.member[bitcast<u32>(select(0i, _e260, (_e260 > 0i)))];
let _e268 = ((14u * _e111) + _e113);
let _e269 = bitcast<i32>(_e268);
let _e271 = select(_e116, _e269, (_e269 < _e116));
let _e277 = global_5.member[bitcast<u32>(select(0i, _e271, (_e271 > 0i)))];
let _e279 = ((15u * _e111) + _e113);
let _e280 = bitcast<i32>(_e279);
let _e282 = select(_e116, _e280, (_e280 < _e116));
let _e288 = global_5.member[bitcast<u32>(select(0i, _e282, (_e282 > 0i)))];
let _e290 = ((16u * _e111) + _e113);
let _e291 = bitcast<i32>(_e290);
let _e293 = select(_e116, _e291, (_e291 < _e116));
let _e299 = global_5.member[bitcast<u32>(select(0i, _e293, (_e293 > 0i)))];
let _e301 = ((17u * _e111) + _e113);
let _e302 = bitcast<i32>(_e301);
let _e304 = select(_e116, _e302, (_e302 < _e116));
let _e310 = global_5.member[bitcast<u32>(select(0i, _e304, (_e304 > 0i)))];
let _e312 = ((18u * _e111) + _e113);
let _e313 = bitcast<i32>(_e312);
let _e315 = select(_e116, _e313, (_e313 < _e116));
let _e321 = global_5.member[bitcast<u32>(select(0i, _e315, (_e315 > 0i)))];
let _e323 = ((19u * _e111) + _e113);
let _e324 = bitcast<i32>(_e323);
let _e326 = select(_e116, _e324, (_e324 < _e116));
let _e332 = global_5.member[bitcast<u32>(select(0i, _e326, (_e326 > 0i)))];
let _e334 = ((20u * _e111) + _e113);
let _e335 = bitcast<i32>(_e334);
let _e337 = select(_e116, _e335, (_e335 < _e116));
let _e343 = global_5.member[bitcast<u32>(select(0i, _e337, (_e337 > 0i)))];
let _e345 = ((21u * _e111) + _e113);
let _e346 = bitcast<i32>(_e345);
let _e348 = select(_e116, _e346, (_e346 < _e116));
let _e354 = global_5.member[bitcast<u32>(select(0i, _e348, (_e348 > 0i)))];
let _e356 = ((22u * _e111) + _e113);
let _e357 = bitcast<i32>(_e356);
let _e359 = select(_e116, _e357, (_e357 < _e116));
let _e365 = global_5.member[bitcast<u32>(select(0i, _e359, (_e359 > 0i)))];
let _e367 = ((23u * _e111) + _e113);
let _e368 = bitcast<i32>(_e367);
let _e370 = select(_e116, _e368, (_e368 < _e116));
let _e376 = global_5.member[bitcast<u32>(select(0i, _e370, (_e370 > 0i)))];
let _e378 = ((24u * _e111) + _e113);
let _e379 = bitcast<i32>(_e378);
let _e381 = select(_e116, _e379, (_e379 < _e116));
let _e387 = global_5.member[bitcast<u32>(select(0i, _e381, (_e381 > 0i)))];
if (_e299 == 0f) {
phi_640_ = 3u;
} else {
phi_640_ = select(0u, 1u, (_e299 == 4f));
}
let _e392 = phi_640_;
if (_e392 > 1u) {
let _e406 = select(0i, select(select(i32(_e310), i32(-2147483648), (_e310 < -2147483600f)), 2147483647i, (_e310 > 2147483500f)), (_e310 == _e310));
let _e422 = bitcast<i32>(arrayLength((&global_2.member)));
if (_e406 == 16i) {
phi_850_ = 0i;
} else {
phi_850_ = -(_e406);
}
let _e427 = phi_850_;
phi_852_ = type_20(vec3<f32>(_e124, _e134, _e145), vec3<f32>(_e156, _e167, _e178), vec3<f32>(_e189, _e200, _e211), vec3<f32>(_e222, _e233, _e244), vec3<f32>(_e255, _e266, _e277), _e288, _e299, _e406, _e321, _e332, _e343, _e354, select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < -2147483600f)), 2147483647i, (_e365 > 2147483500f)), (_e365 == _e365)), select(0i, select(select(i32(_e376), i32(-2147483648), (_e376 < -2147483600f)), 2147483647i, (_e376 > 2147483500f)), (_e376 == _e376)), _e387);
phi_855_ = 0i;
phi_857_ = _e427;
loop {
let _e429 = phi_852_;
let _e431 = phi_855_;
let _e433 = phi_857_;
local_15 = _e433;
local_16 = _e433;
local_17 = _e429;
local_18 = _e429;
local_19 = _e429;
local_20 = _e429;
local_21 = _e429;
local_22 = _e429;
local_23 = _e429;
local_24 = _e429;
local_25 = _e429;
local_26 = _e429;
local_27 = _e429;
local_28 = _e429;
local_29 = _e429;
local_30 = _e429;
local_31 = _e429;
local_32 = _e429;
local_33 = _e429;
local_34 = _e429;
local_35 = _e429;
local_36 = _e429;
local_37 = _e429;
local_38 = _e429;
local_39 = _e429;
let _e437 = ((_e431 < 1024i) && (_e429.member_6 == 0f));
local_40 = _e429.member_6;
if _e437 {
if (_e429.member_12 < (_e422 / 8i)) {
let _e2633 = (_e429.member_12 * 8i);
let _e2637 = bitcast<f32>((bitcast<u32>(_e429.member_1.x) & 2147483647u));
let _e2642 = (1f / select(_e429.member_1.x, select(1e-12f, -1e-12f, (_e429.member_1.x < 0f)), (_e2637 < 1e-12f)));
let _e2646 = bitcast<f32>((bitcast<u32>(_e429.member_1.y) & 2147483647u));
let _e2651 = (1f / select(_e429.member_1.y, select(1e-12f, -1e-12f, (_e429.member_1.y < 0f)), (_e2646 < 1e-12f)));
let _e2655 = bitcast<f32>((bitcast<u32>(_e429.member_1.z) & 2147483647u));
let _e2660 = (1f / select(_e429.member_1.z, select(1e-12f, -1e-12f, (_e429.member_1.z < 0f)), (_e2655 < 1e-12f)));
let _e2662 = (_e422 - 1i);
let _e2664 = select(_e2662, _e2633, (_e2633 < _e2662));
let _e2670 = global_2.member[bitcast<u32>(select(0i, _e2664, (_e2664 > 0i)))];
let _e2671 = (_e2633 + 1i);
let _e2673 = select(_e2662, _e2671, (_e2671 < _e2662));
let _e2679 = global_2.member[bitcast<u32>(select(0i, _e2673, (_e2673 > 0i)))];
let _e2680 = (_e2633 + 2i);
let _e2682 = select(_e2662, _e2680, (_e2680 < _e2662));
let _e2688 = global_2.member[bitcast<u32>(select(0i, _e2682, (_e2682 > 0i)))];
let _e2689 = (_e2633 + 3i);
let _e2691 = select(_e2662, _e2689, (_e2689 < _e2662));
let _e2697 = global_2.member[bitcast<u32>(select(0i, _e2691, (_e2691 > 0i)))];
let _e2698 = (_e2633 + 4i);
let _e2700 = select(_e2662, _e2698, (_e2698 < _e2662));
let _e2706 = global_2.member[bitcast<u32>(select(0i, _e2700, (_e2700 > 0i)))];
let _e2707 = (_e2633 + 5i);
let _e2709 = select(_e2662, _e2707, (_e2707 < _e2662));
let _e2715 = global_2.member[bitcast<u32>(select(0i, _e2709, (_e2709 > 0i)))];
let _e2718 = ((_e2670 - _e429.member.x) * _e2642);
let _e2720 = ((_e2697 - _e429.member.x) * _e2642);
let _e2723 = ((_e2679 - _e429.member.y) * _e2651);
let _e2725 = ((_e2706 - _e429.member.y) * _e2651);
let _e2728 = ((_e2688 - _e429.member.z) * _e2660);
let _e2730 = ((_e2715 - _e429.member.z) * _e2660);
let _e2732 = select(_e2720, _e2718, (_e2718 < _e2720));
let _e2734 = select(_e2725, _e2723, (_e2723 < _e2725));
let _e2736 = select(_e2734, _e2732, (_e2732 > _e2734));
let _e2738 = select(_e2730, _e2728, (_e2728 < _e2730));
let _e2742 = select(_e2720, _e2718, (_e2718 > _e2720));
let _e2744 = select(_e2725, _e2723, (_e2723 > _e2725));
let _e2746 = select(_e2744, _e2742, (_e2742 < _e2744));
let _e2748 = select(_e2730, _e2728, (_e2728 > _e2730));
let _e2750 = select(_e2748, _e2746, (_e2746 < _e2748));
let _e2756 = ((select(_e2738, _e2736, (_e2736 > _e2738)) <= select(_e429.member_14, _e2750, (_e2750 < _e429.member_14))) && (_e2750 >= 0f));
let _e2757 = (_e2633 + 6i);
let _e2759 = select(_e2662, _e2757, (_e2757 < _e2662));
let _e2765 = global_2.member[bitcast<u32>(select(0i, _e2759, (_e2759 > 0i)))];
let _e2772 = select(0i, select(select(i32(_e2765), i32(-2147483648), (_e2765 < -2147483600f)), 2147483647i, (_e2765 > 2147483500f)), (_e2765 == _e2765));
if (_e2756 && (_e2772 >= 0i)) {
let _e2777 = ((_e2637 >= _e2646) && (_e2637 >= _e2655));
let _e2780 = (!(_e2777) && (_e2646 >= _e2655));
let _e2787 = (1f / select(select(_e429.member_1.z, _e429.member_1.y, _e2780), _e429.member_1.x, _e2777));
let _e2788 = (select(select(_e429.member_1.x, _e429.member_1.z, _e2780), _e429.member_1.y, _e2777) * _e2787);
let _e2789 = (select(select(_e429.member_1.y, _e429.member_1.x, _e2780), _e429.member_1.z, _e2777) * _e2787);
let _e2790 = (_e2772 * 19i);
let _e2792 = (bitcast<i32>(_e97) - 1i);
let _e2794 = select(_e2792, _e2790, (_e2790 < _e2792));
let _e2800 = global_3.member[bitcast<u32>(select(0i, _e2794, (_e2794 > 0i)))];
let _e2801 = (_e2790 + 1i);
let _e2803 = select(_e2792, _e2801, (_e2801 < _e2792));
let _e2809 = global_3.member[bitcast<u32>(select(0i, _e2803, (_e2803 > 0i)))];
let _e2810 = (_e2790 + 2i);
let _e2812 = select(_e2792, _e2810, (_e2810 < _e2792));
let _e2818 = global_3.member[bitcast<u32>(select(0i, _e2812, (_e2812 > 0i)))];
let _e2819 = (_e2800 - _e429.member.x);
let _e2820 = (_e2809 - _e429.member.y);
let _e2821 = (_e2818 - _e429.member.z);
let _e2827 = select(select(_e2821, _e2820, _e2780), _e2819, _e2777);
let _e2829 = (select(select(_e2819, _e2821, _e2780), _e2820, _e2777) - (_e2788 * _e2827));
let _e2831 = (select(select(_e2820, _e2819, _e2780), _e2821, _e2777) - (_e2789 * _e2827));
let _e2833 = (_e2790 + 3i);
let _e2835 = select(_e2792, _e2833, (_e2833 < _e2792));
let _e2841 = global_3.member[bitcast<u32>(select(0i, _e2835, (_e2835 > 0i)))];
let _e2842 = (_e2790 + 4i);
let _e2844 = select(_e2792, _e2842, (_e2842 < _e2792));
let _e2850 = global_3.member[bitcast<u32>(select(0i, _e2844, (_e2844 > 0i)))];
let _e2851 = (_e2790 + 5i);
let _e2853 = select(_e2792, _e2851, (_e2851 < _e2792));
let _e2859 = global_3.member[bitcast<u32>(select(0i, _e2853, (_e2853 > 0i)))];
let _e2860 = (_e2841 - _e429.member.x);
let _e2861 = (_e2850 - _e429.member.y);
let _e2862 = (_e2859 - _e429.member.z);
let _e2868 = select(select(_e2862, _e2861, _e2780), _e2860, _e2777);
let _e2870 = (select(select(_e2860, _e2862, _e2780), _e2861, _e2777) - (_e2788 * _e2868));
let _e2872 = (select(select(_e2861, _e2860, _e2780), _e2862, _e2777) - (_e2789 * _e2868));
let _e2874 = (_e2790 + 6i);
let _e2876 = select(_e2792, _e2874, (_e2874 < _e2792));
let _e2882 = global_3.member[bitcast<u32>(select(0i, _e2876, (_e2876 > 0i)))];
let _e2883 = (_e2790 + 7i);
let _e2885 = select(_e2792, _e2883, (_e2883 < _e2792));
let _e2891 = global_3.member[bitcast<u32>(select(0i, _e2885, (_e2885 > 0i)))];
let _e2892 = (_e2790 + 8i);
let _e2894 = select(_e2792, _e2892, (_e2892 < _e2792));
let _e2900 = global_3.member[bitcast<u32>(select(0i, _e2894, (_e2894 > 0i)))];
let _e2901 = (_e2882 - _e429.member.x);
let _e2902 = (_e2891 - _e429.member.y);
let _e2903 = (_e2900 - _e429.member.z);
let _e2909 = select(select(_e2903, _e2902, _e2780), _e2901, _e2777);
let _e2911 = (select(select(_e2901, _e2903, _e2780), _e2902, _e2777) - (_e2788 * _e2909));
let _e2913 = (select(select(_e2902, _e2901, _e2780), _e2903, _e2777) - (_e2789 * _e2909));
let _e2917 = ((_e2911 * _e2872) - (_e2913 * _e2870));
let _e2920 = ((_e2829 * _e2913) - (_e2831 * _e2911));
let _e2923 = ((_e2870 * _e2831) - (_e2872 * _e2829));
let _e2925 = ((_e2917 + _e2920) + _e2923);
let _e2939 = (!(((((_e2917 < 0f) || (_e2920 < 0f)) || (_e2923 < 0f)) && (((_e2917 > 0f) || (_e2920 > 0f)) || (_e2923 > 0f)))) && (_e2925 != 0f));
let _e2946 = ((((_e2917 * (_e2827 * _e2787)) + (_e2920 * (_e2868 * _e2787))) + (_e2923 * (_e2909 * _e2787))) / select(1f, _e2925, _e2939));
let _e2949 = select(1e30f, _e2946, (_e2939 && (_e2946 > 1e-3f)));
if (_e2949 < _e429.member_14) {
let _e2965 = type_20(_e429.member, _e429.member_1, _e429.member_2, _e429.member_3, _e429.member_4, _e429.member_5, _e429.member_6, _e429.member_7, _e429.member_8, _e429.member_9, _e429.member_10, _e429.member_11, _e429.member_12, _e429.member_13, _e2949);
phi_1480_ = type_20(_e2965.member, _e2965.member_1, _e2965.member_2, _e2965.member_3, _e2965.member_4, _e2965.member_5, _e2965.member_6, _e2965.member_7, _e2965.member_8, _e2965.member_9, _e2965.member_10, _e2965.member_11, _e2965.member_12, _e2772, _e2965.member_14);
} else {
phi_1480_ = _e429;
}
let _e2982 = phi_1480_;
phi_1481_ = _e2982;
} else {
phi_1481_ = _e429;
}
let _e2984 = phi_1481_;
if _e2756 {
phi_1513_ = (_e2984.member_12 + 1i);
} else {
let _e2985 = (_e2633 + 7i);
let _e2987 = select(_e2662, _e2985, (_e2985 < _e2662));
let _e2993 = global_2.member[bitcast<u32>(select(0i, _e2987, (_e2987 > 0i)))];
phi_1513_ = select(0i, select(select(i32(_e2993), i32(-2147483648), (_e2993 < -2147483600f)), 2147483647i, (_e2993 > 2147483500f)), (_e2993 == _e2993));
}
let _e3004 = phi_1513_;
phi_4418_ = type_20(_e2984.member, _e2984.member_1, _e2984.member_2, _e2984.member_3, _e2984.member_4, _e2984.member_5, _e2984.member_6, _e2984.member_7, _e2984.member_8, _e2984.member_9, _e2984.member_10, _e2984.member_11, _e3004, _e2984.member_13, _e2984.member_14);
phi_4419_ = _e433;
} else {
if (_e429.member_13 < 0i) {
phi_1521_ = 15i;
phi_1524_ = 16i;
loop {
let _e2163 = phi_1521_;
let _e2165 = phi_1524_;
local_12 = _e2165;
local_13 = _e2165;
local_14 = _e2165;
let _e2166 = (_e2163 >= 0i);
if _e2166 {
phi_1522_ = (_e2163 - 1i);
phi_1525_ = select(_e2165, _e2163, (((_e433 >> bitcast<u32>((_e2163 & 31i))) & 1i) == 1i));
} else {
phi_1522_ = i32();
phi_1525_ = i32();
}
let _e2175 = phi_1522_;
let _e2177 = phi_1525_;
continue;
continuing {
phi_1521_ = _e2175;
phi_1524_ = _e2177;
break if !(_e2166);
}
}
let _e2179 = (_e429.member_13 == -1i);
let _e2181 = local_12;
if (_e2179 || (_e2181 == 16i)) {
if _e2179 {
phi_1841_ = type_20(_e429.member, _e429.member_1, _e429.member_2, _e429.member_3, _e429.member_4, _e429.member_5, 1f, _e429.member_7, _e429.member_8, _e429.member_9, _e429.member_10, _e429.member_11, _e429.member_12, _e429.member_13, _e429.member_14);
} else {
let _e2540 = type_20(vec3<f32>((_e429.member.x + (_e429.member_1.x * _e429.member_14)), (_e429.member.y + (_e429.member_1.y * _e429.member_14)), (_e429.member.z + (_e429.member_1.z * _e429.member_14))), _e429.member_1, _e429.member_2, _e429.member_3, _e429.member_4, _e429.member_5, _e429.member_6, _e429.member_7, _e429.member_8, _e429.member_9, _e429.member_10, _e429.member_11, _e429.member_12, _e429.member_13, _e429.member_14);
let _e2557 = type_20(_e2540.member, _e2540.member_1, _e2540.member_2, _e2540.member_3, _e2540.member_4, (_e429.member_5 + _e429.member_14), _e2540.member_6, _e2540.member_7, _e2540.member_8, _e2540.member_9, _e2540.member_10, _e2540.member_11, _e2540.member_12, _e2540.member_13, _e2540.member_14);
let _e2573 = type_20(_e2557.member, _e2557.member_1, _e2557.member_2, _e2557.member_3, _e2557.member_4, _e2557.member_5, _e2557.member_6, _e2557.member_7, _e2557.member_8, _e2557.member_9, _e2557.member_10, _e2557.member_11, _e2557.member_12, _e2557.member_13, (_e429.member_14 - _e429.member_14));
let _e2593 = type_20(_e2573.member, _e2573.member_1, _e2573.member_2, _e2573.member_3, _e2573.member_4, _e2573.member_5, _e2573.member_6, _e2573.member_7, _e2573.member_8, _e2573.member_9, (_e429.member_10 + select(0f, _e429.member_14, (_e429.member_8 == 0f))), _e2573.member_11, _e2573.member_12, _e2573.member_13, _e2573.member_14);
phi_1841_ = type_20(_e2593.member, _e2593.member_1, _e2593.member_2, _e2593.member_3, _e2593.member_4, _e2593.member_5, 3f, _e2593.member_7, _e2593.member_8, _e2593.member_9, _e2593.member_10, _e2593.member_11, _e2593.member_12, _e2593.member_13, _e2593.member_14);
}
let _e2625 = phi_1841_;
phi_2129_ = _e2625;
} else {
let _e2216 = type_20(vec3<f32>((_e429.member.x + (_e429.member_1.x * _e429.member_14)), (_e429.member.y + (_e429.member_1.y * _e429.member_14)), (_e429.member.z + (_e429.member_1.z * _e429.member_14))), _e429.member_1, _e429.member_2, _e429.member_3, _e429.member_4, _e429.member_5, _e429.member_6, _e429.member_7, _e429.member_8, _e429.member_9, _e429.member_10, _e429.member_11, _e429.member_12, _e429.member_13, _e429.member_14);
let _e2233 = type_20(_e2216.member, _e2216.member_1, _e2216.member_2, _e2216.member_3, _e2216.member_4, (_e429.member_5 + _e429.member_14), _e2216.member_6, _e2216.member_7, _e2216.member_8, _e2216.member_9, _e2216.member_10, _e2216.member_11, _e2216.member_12, _e2216.member_13, _e2216.member_14);
let _e2249 = type_20(_e2233.member, _e2233.member_1, _e2233.member_2, _e2233.member_3, _e2233.member_4, _e2233.member_5, _e2233.member_6, _e2233.member_7, _e2233.member_8, _e2233.member_9, _e2233.member_10, _e2233.member_11, _e2233.member_12, _e2233.member_13, (_e429.member_14 - _e429.member_14));
let _e2269 = type_20(_e2249.member, _e2249.member_1, _e2249.member_2, _e2249.member_3, _e2249.member_4, _e2249.member_5, _e2249.member_6, _e2249.member_7, _e2249.member_8, _e2249.member_9, (_e429.member_10 + select(0f, _e429.member_14, (_e429.member_8 == 0f))), _e2249.member_11, _e2249.member_12, _e2249.member_13, _e2249.member_14);
let _e2271 = local_13;
if (_e2271 != 16i) {
let _e2289 = type_20(_e2269.member, _e2269.member_1, _e2269.member_2, _e2269.member_3, _e2269.member_4, _e2269.member_5, _e2269.member_6, _e2269.member_7, _e2269.member_8, (_e429.member_9 + _e429.member_14), _e2269.member_10, _e2269.member_11, _e2269.member_12, _e2269.member_13, _e2269.member_14);
let _e2291 = local_14;
let _e2292 = (_e2291 * 4i);
let _e2293 = (_e2292 + 1i);
let _e2295 = (bitcast<i32>(_e99) - 1i);
let _e2297 = select(_e2295, _e2293, (_e2293 < _e2295));
let _e2303 = global_4.member[bitcast<u32>(select(0i, _e2297, (_e2297 > 0i)))];
let _e2305 = -((_e2303 * _e429.member_14));
let _e2307 = select(-87f, _e2305, (_e2305 > -87f));
let _e2309 = select(88f, _e2307, (_e2307 < 88f));
let _e2311 = ((_e2309 * 1.442695f) + 0.5f);
let _e2313 = select(-127f, _e2311, (_e2311 > -127f));
let _e2315 = select(128f, _e2313, (_e2313 < 128f));
let _e2322 = select(0i, select(select(i32(_e2315), i32(-2147483648), (_e2315 < -2147483600f)), 2147483647i, (_e2315 > 2147483500f)), (_e2315 == _e2315));
let _e2326 = (_e2322 - select(0i, 1i, (_e2315 < f32(_e2322))));
let _e2327 = f32(_e2326);
let _e2331 = ((_e2309 - (_e2327 * 0.6933594f)) - (_e2327 * -2.1219444e-4f));
let _e2355 = (_e2292 + 2i);
let _e2357 = select(_e2295, _e2355, (_e2355 < _e2295));
let _e2363 = global_4.member[bitcast<u32>(select(0i, _e2357, (_e2357 > 0i)))];
let _e2365 = -((_e2363 * _e429.member_14));
let _e2367 = select(-87f, _e2365, (_e2365 > -87f));
let _e2369 = select(88f, _e2367, (_e2367 < 88f));
let _e2371 = ((_e2369 * 1.442695f) + 0.5f);
let _e2373 = select(-127f, _e2371, (_e2371 > -127f));
let _e2375 = select(128f, _e2373, (_e2373 < 128f));
let _e2382 = select(0i, select(select(i32(_e2375), i32(-2147483648), (_e2375 < -2147483600f)), 2147483647i, (_e2375 > 2147483500f)), (_e2375 == _e2375));
let _e2386 = (_e2382 - select(0i, 1i, (_e2375 < f32(_e2382))));
let _e2387 = f32(_e2386);
let _e2391 = ((_e2369 - (_e2387 * 0.6933594f)) - (_e2387 * -2.1219444e-4f));
let _e2415 = (_e2292 + 3i);
let _e2417 = select(_e2295, _e2415, (_e2415 < _e2295));
let _e2423 = global_4.member[bitcast<u32>(select(0i, _e2417, (_e2417 > 0i)))];
let _e2425 = -((_e2423 * _e429.member_14));
let _e2427 = select(-87f, _e2425, (_e2425 > -87f));
let _e2429 = select(88f, _e2427, (_e2427 < 88f));
let _e2431 = ((_e2429 * 1.442695f) + 0.5f);
let _e2433 = select(-127f, _e2431, (_e2431 > -127f));
let _e2435 = select(128f, _e2433, (_e2433 < 128f));
let _e2442 = select(0i, select(select(i32(_e2435), i32(-2147483648), (_e2435 < -2147483600f)), 2147483647i, (_e2435 > 2147483500f)), (_e2435 == _e2435));
let _e2446 = (_e2442 - select(0i, 1i, (_e2435 < f32(_e2442))));
let _e2447 = f32(_e2446);
let _e2451 = ((_e2429 - (_e2447 * 0.6933594f)) - (_e2447 * -2.1219444e-4f));
phi_2127_ = type_20(_e2289.member, _e2289.member_1, vec3<f32>((_e429.member_2.x * ((1f + (_e2331 * (1f + (_e2331 * (0.5f + (_e2331 * (0.16666667f + (_e2331 * (0.041666668f + (_e2331 * (0.008333334f + (_e2331 * (0.001388889f + (_e2331 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2326 + 127i)) << bitcast<u32>(23i))))), (_e429.member_2.y * ((1f + (_e2391 * (1f + (_e2391 * (0.5f + (_e2391 * (0.16666667f + (_e2391 * (0.041666668f + (_e2391 * (0.008333334f + (_e2391 * (0.001388889f + (_e2391 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2386 + 127i)) << bitcast<u32>(23i))))), (_e429.member_2.z * ((1f + (_e2451 * (1f + (_e2451 * (0.5f + (_e2451 * (0.16666667f + (_e2451 * (0.041666668f + (_e2451 * (0.008333334f + (_e2451 * (0.001388889f + (_e2451 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2446 + 127i)) << bitcast<u32>(23i)))))), _e2289.member_3, _e2289.member_4, _e2289.member_5, _e2289.member_6, _e2289.member_7, _e2289.member_8, _e2289.member_9, _e2289.member_10, _e2289.member_11, _e2289.member_12, _e2289.member_13, _e2289.member_14);
} else {
phi_2127_ = _e2269;
}
let _e2492 = phi_2127_;
phi_2129_ = type_20(_e2492.member, _e2492.member_1, _e2492.member_2, _e2492.member_3, _e2492.member_4, _e2492.member_5, 3f, _e2492.member_7, _e2492.member_8, _e2492.member_9, _e2492.member_10, _e2492.member_11, _e2492.member_12, _e2492.member_13, _e2492.member_14);
}
let _e2627 = phi_2129_;
phi_4416_ = _e2627;
phi_4417_ = _e433;
} else {
phi_2131_ = 15i;
phi_2134_ = 16i;
loop {
let _e444 = phi_2131_;
let _e446 = phi_2134_;
local = _e446;
local_1 = _e446;
local_2 = _e446;
local_4 = _e446;
local_5 = _e446;
local_8 = _e446;
local_10 = _e446;
local_11 = _e446;
let _e447 = (_e444 >= 0i);
if _e447 {
phi_2132_ = (_e444 - 1i);
phi_2135_ = select(_e446, _e444, (((_e433 >> bitcast<u32>((_e444 & 31i))) & 1i) == 1i));
} else {
phi_2132_ = i32();
phi_2135_ = i32();
}
let _e456 = phi_2132_;
let _e458 = phi_2135_;
continue;
continuing {
phi_2131_ = _e456;
phi_2134_ = _e458;
break if !(_e447);
}
}
let _e460 = (_e429.member_13 * 19i);
let _e462 = (bitcast<i32>(_e97) - 1i);
let _e464 = select(_e462, _e460, (_e460 < _e462));
let _e470 = global_3.member[bitcast<u32>(select(0i, _e464, (_e464 > 0i)))];
let _e471 = (_e460 + 1i);
let _e473 = select(_e462, _e471, (_e471 < _e462));
let _e479 = global_3.member[bitcast<u32>(select(0i, _e473, (_e473 > 0i)))];
let _e480 = (_e460 + 2i);
let _e482 = select(_e462, _e480, (_e480 < _e462));
let _e488 = global_3.member[bitcast<u32>(select(0i, _e482, (_e482 > 0i)))];
let _e489 = (_e460 + 3i);
let _e491 = select(_e462, _e489, (_e489 < _e462));
let _e497 = global_3.member[bitcast<u32>(select(0i, _e491, (_e491 > 0i)))];
let _e498 = (_e460 + 4i);
let _e500 = select(_e462, _e498, (_e498 < _e462));
let _e506 = global_3.member[bitcast<u32>(select(0i, _e500, (_e500 > 0i)))];
let _e507 = (_e460 + 5i);
let _e509 = select(_e462, _e507, (_e507 < _e462));
let _e515 = global_3.member[bitcast<u32>(select(0i, _e509, (_e509 > 0i)))];
let _e516 = (_e460 + 6i);
let _e518 = select(_e462, _e516, (_e516 < _e462));
let _e524 = global_3.member[bitcast<u32>(select(0i, _e518, (_e518 > 0i)))];
let _e525 = (_e460 + 7i);
let _e527 = select(_e462, _e525, (_e525 < _e462));
let _e533 = global_3.member[bitcast<u32>(select(0i, _e527, (_e527 > 0i)))];
let _e534 = (_e460 + 8i);
let _e536 = select(_e462, _e534, (_e534 < _e462));
let _e542 = global_3.member[bitcast<u32>(select(0i, _e536, (_e536 > 0i)))];
let _e543 = (_e497 - _e470);
let _e544 = (_e506 - _e479);
let _e545 = (_e515 - _e488);
let _e546 = (_e524 - _e470);
let _e547 = (_e533 - _e479);
let _e548 = (_e542 - _e488);
let _e551 = ((_e544 * _e548) - (_e545 * _e547));
let _e554 = ((_e545 * _e546) - (_e543 * _e548));
let _e557 = ((_e543 * _e547) - (_e544 * _e546));
let _e562 = (((_e551 * _e551) + (_e554 * _e554)) + (_e557 * _e557));
let _e565 = sqrt(select(0f, _e562, (_e562 > 0f)));
let _e568 = (1f / select(1e-20f, _e565, (_e565 > 1e-20f)));
let _e569 = (_e551 * _e568);
let _e570 = (_e554 * _e568);
let _e571 = (_e557 * _e568);
let _e577 = bitcast<f32>((bitcast<u32>(_e429.member_1.x) & 2147483647u));
let _e581 = bitcast<f32>((bitcast<u32>(_e429.member_1.y) & 2147483647u));
let _e585 = bitcast<f32>((bitcast<u32>(_e429.member_1.z) & 2147483647u));
let _e588 = ((_e577 >= _e581) && (_e577 >= _e585));
let _e591 = (!(_e588) && (_e581 >= _e585));
let _e598 = (1f / select(select(_e429.member_1.z, _e429.member_1.y, _e591), _e429.member_1.x, _e588));
let _e599 = (select(select(_e429.member_1.x, _e429.member_1.z, _e591), _e429.member_1.y, _e588) * _e598);
let _e600 = (select(select(_e429.member_1.y, _e429.member_1.x, _e591), _e429.member_1.z, _e588) * _e598);
let _e602 = (_e470 - _e429.member.x);
let _e604 = (_e479 - _e429.member.y);
let _e606 = (_e488 - _e429.member.z);
let _e612 = select(select(_e606, _e604, _e591), _e602, _e588);
let _e614 = (select(select(_e602, _e606, _e591), _e604, _e588) - (_e599 * _e612));
let _e616 = (select(select(_e604, _e602, _e591), _e606, _e588) - (_e600 * _e612));
let _e617 = (_e497 - _e429.member.x);
let _e618 = (_e506 - _e429.member.y);
let _e619 = (_e515 - _e429.member.z);
let _e625 = select(select(_e619, _e618, _e591), _e617, _e588);
let _e627 = (select(select(_e617, _e619, _e591), _e618, _e588) - (_e599 * _e625));
let _e629 = (select(select(_e618, _e617, _e591), _e619, _e588) - (_e600 * _e625));
let _e630 = (_e524 - _e429.member.x);
let _e631 = (_e533 - _e429.member.y);
let _e632 = (_e542 - _e429.member.z);
let _e638 = select(select(_e632, _e631, _e591), _e630, _e588);
let _e640 = (select(select(_e630, _e632, _e591), _e631, _e588) - (_e599 * _e638));
let _e642 = (select(select(_e631, _e630, _e591), _e632, _e588) - (_e600 * _e638));
let _e645 = ((_e640 * _e629) - (_e642 * _e627));
let _e648 = ((_e614 * _e642) - (_e616 * _e640));
let _e651 = ((_e627 * _e616) - (_e629 * _e614));
let _e653 = ((_e645 + _e648) + _e651);
let _e656 = (1f / select(_e653, 1f, (_e653 == 0f)));
let _e657 = (_e645 * _e656);
let _e658 = (_e648 * _e656);
let _e659 = (_e651 * _e656);
let _e660 = (_e460 + 9i);
let _e662 = select(_e462, _e660, (_e660 < _e462));
let _e668 = global_3.member[bitcast<u32>(select(0i, _e662, (_e662 > 0i)))];
let _e669 = (_e460 + 10i);
let _e671 = select(_e462, _e669, (_e669 < _e462));
let _e677 = global_3.member[bitcast<u32>(select(0i, _e671, (_e671 > 0i)))];
let _e678 = (_e460 + 11i);
let _e680 = select(_e462, _e678, (_e678 < _e462));
let _e686 = global_3.member[bitcast<u32>(select(0i, _e680, (_e680 > 0i)))];
let _e690 = (_e460 + 12i);
let _e692 = select(_e462, _e690, (_e690 < _e462));
let _e698 = global_3.member[bitcast<u32>(select(0i, _e692, (_e692 > 0i)))];
let _e699 = (_e460 + 13i);
let _e701 = select(_e462, _e699, (_e699 < _e462));
let _e707 = global_3.member[bitcast<u32>(select(0i, _e701, (_e701 > 0i)))];
let _e708 = (_e460 + 14i);
let _e710 = select(_e462, _e708, (_e708 < _e462));
let _e716 = global_3.member[bitcast<u32>(select(0i, _e710, (_e710 > 0i)))];
let _e723 = (_e460 + 15i);
let _e725 = select(_e462, _e723, (_e723 < _e462));
let _e731 = global_3.member[bitcast<u32>(select(0i, _e725, (_e725 > 0i)))];
let _e732 = (_e460 + 16i);
let _e734 = select(_e462, _e732, (_e732 < _e462));
let _e740 = global_3.member[bitcast<u32>(select(0i, _e734, (_e734 > 0i)))];
let _e741 = (_e460 + 17i);
let _e743 = select(_e462, _e741, (_e741 < _e462));
let _e749 = global_3.member[bitcast<u32>(select(0i, _e743, (_e743 > 0i)))];
let _e753 = (((_e668 * _e657) + (_e698 * _e658)) + (_e731 * _e659));
let _e754 = (((_e677 * _e657) + (_e707 * _e658)) + (_e740 * _e659));
let _e755 = (((_e686 * _e657) + (_e716 * _e658)) + (_e749 * _e659));
let _e760 = (((_e753 * _e753) + (_e754 * _e754)) + (_e755 * _e755));
let _e763 = sqrt(select(0f, _e760, (_e760 > 0f)));
let _e766 = (1f / select(1e-20f, _e763, (_e763 > 1e-20f)));
let _e767 = (_e753 * _e766);
let _e768 = (_e754 * _e766);
let _e769 = (_e755 * _e766);
let _e781 = (((((_e767 * _e429.member_1.x) + (_e768 * _e429.member_1.y)) + (_e769 * _e429.member_1.z)) * (((_e569 * _e429.member_1.x) + (_e570 * _e429.member_1.y)) + (_e571 * _e429.member_1.z))) > 0f);
let _e782 = select(_e569, _e767, _e781);
let _e783 = select(_e570, _e768, _e781);
let _e784 = select(_e571, _e769, _e781);
let _e786 = (_e460 + 18i);
let _e788 = select(_e462, _e786, (_e786 < _e462));
let _e794 = global_3.member[bitcast<u32>(select(0i, _e788, (_e788 > 0i)))];
let _e801 = select(0i, select(select(i32(_e794), i32(-2147483648), (_e794 < -2147483600f)), 2147483647i, (_e794 > 2147483500f)), (_e794 == _e794));
let _e802 = (_e801 * 4i);
let _e804 = (bitcast<i32>(_e99) - 1i);
let _e806 = select(_e804, _e802, (_e802 < _e804));
let _e812 = global_4.member[bitcast<u32>(select(0i, _e806, (_e806 > 0i)))];
if (select(_e812, 1f, (_e801 == 16i)) == 0f) {
let _e1868 = type_20(vec3<f32>((_e429.member.x + (_e429.member_1.x * _e429.member_14)), (_e429.member.y + (_e429.member_1.y * _e429.member_14)), (_e429.member.z + (_e429.member_1.z * _e429.member_14))), _e429.member_1, _e429.member_2, _e429.member_3, _e429.member_4, _e429.member_5, _e429.member_6, _e429.member_7, _e429.member_8, _e429.member_9, _e429.member_10, _e429.member_11, _e429.member_12, _e429.member_13, _e429.member_14);
let _e1885 = type_20(_e1868.member, _e1868.member_1, _e1868.member_2, _e1868.member_3, _e1868.member_4, (_e429.member_5 + _e429.member_14), _e1868.member_6, _e1868.member_7, _e1868.member_8, _e1868.member_9, _e1868.member_10, _e1868.member_11, _e1868.member_12, _e1868.member_13, _e1868.member_14);
let _e1901 = type_20(_e1885.member, _e1885.member_1, _e1885.member_2, _e1885.member_3, _e1885.member_4, _e1885.member_5, _e1885.member_6, _e1885.member_7, _e1885.member_8, _e1885.member_9, _e1885.member_10, _e1885.member_11, _e1885.member_12, _e1885.member_13, (_e429.member_14 - _e429.member_14));
let _e1921 = type_20(_e1901.member, _e1901.member_1, _e1901.member_2, _e1901.member_3, _e1901.member_4, _e1901.member_5, _e1901.member_6, _e1901.member_7, _e1901.member_8, _e1901.member_9, (_e429.member_10 + select(0f, _e429.member_14, (_e429.member_8 == 0f))), _e1901.member_11, _e1901.member_12, _e1901.member_13, _e1901.member_14);
let _e1923 = local_10;
if (_e1923 != 16i) {
let _e1941 = type_20(_e1921.member, _e1921.member_1, _e1921.member_2, _e1921.member_3, _e1921.member_4, _e1921.member_5, _e1921.member_6, _e1921.member_7, _e1921.member_8, (_e429.member_9 + _e429.member_14), _e1921.member_10, _e1921.member_11, _e1921.member_12, _e1921.member_13, _e1921.member_14);
let _e1943 = local_11;
let _e1944 = (_e1943 * 4i);
let _e1945 = (_e1944 + 1i);
let _e1947 = select(_e804, _e1945, (_e1945 < _e804));
let _e1953 = global_4.member[bitcast<u32>(select(0i, _e1947, (_e1947 > 0i)))];
let _e1955 = -((_e1953 * _e429.member_14));
let _e1957 = select(-87f, _e1955, (_e1955 > -87f));
let _e1959 = select(88f, _e1957, (_e1957 < 88f));
let _e1961 = ((_e1959 * 1.442695f) + 0.5f);
let _e1963 = select(-127f, _e1961, (_e1961 > -127f));
let _e1965 = select(128f, _e1963, (_e1963 < 128f));
let _e1972 = select(0i, select(select(i32(_e1965), i32(-2147483648), (_e1965 < -2147483600f)), 2147483647i, (_e1965 > 2147483500f)), (_e1965 == _e1965));
let _e1976 = (_e1972 - select(0i, 1i, (_e1965 < f32(_e1972))));
let _e1977 = f32(_e1976);
let _e1981 = ((_e1959 - (_e1977 * 0.6933594f)) - (_e1977 * -2.1219444e-4f));
let _e2005 = (_e1944 + 2i);
let _e2007 = select(_e804, _e2005, (_e2005 < _e804));
let _e2013 = global_4.member[bitcast<u32>(select(0i, _e2007, (_e2007 > 0i)))];
let _e2015 = -((_e2013 * _e429.member_14));
let _e2017 = select(-87f, _e2015, (_e2015 > -87f));
let _e2019 = select(88f, _e2017, (_e2017 < 88f));
let _e2021 = ((_e2019 * 1.442695f) + 0.5f);
let _e2023 = select(-127f, _e2021, (_e2021 > -127f));
let _e2025 = select(128f, _e2023, (_e2023 < 128f));
let _e2032 = select(0i, select(select(i32(_e2025), i32(-2147483648), (_e2025 < -2147483600f)), 2147483647i, (_e2025 > 2147483500f)), (_e2025 == _e2025));
let _e2036 = (_e2032 - select(0i, 1i, (_e2025 < f32(_e2032))));
let _e2037 = f32(_e2036);
let _e2041 = ((_e2019 - (_e2037 * 0.6933594f)) - (_e2037 * -2.1219444e-4f));
let _e2065 = (_e1944 + 3i);
let _e2067 = select(_e804, _e2065, (_e2065 < _e804));
let _e2073 = global_4.member[bitcast<u32>(select(0i, _e2067, (_e2067 > 0i)))];
let _e2075 = -((_e2073 * _e429.member_14));
let _e2077 = select(-87f, _e2075, (_e2075 > -87f));
let _e2079 = select(88f, _e2077, (_e2077 < 88f));
let _e2081 = ((_e2079 * 1.442695f) + 0.5f);
let _e2083 = select(-127f, _e2081, (_e2081 > -127f));
let _e2085 = select(128f, _e2083, (_e2083 < 128f));
let _e2092 = select(0i, select(select(i32(_e2085), i32(-2147483648), (_e2085 < -2147483600f)), 2147483647i, (_e2085 > 2147483500f)), (_e2085 == _e2085));
let _e2096 = (_e2092 - select(0i, 1i, (_e2085 < f32(_e2092))));
let _e2097 = f32(_e2096);
let _e2101 = ((_e2079 - (_e2097 * 0.6933594f)) - (_e2097 * -2.1219444e-4f));
phi_3226_ = type_20(_e1941.member, _e1941.member_1, vec3<f32>((_e429.member_2.x * ((1f + (_e1981 * (1f + (_e1981 * (0.5f + (_e1981 * (0.16666667f + (_e1981 * (0.041666668f + (_e1981 * (0.008333334f + (_e1981 * (0.001388889f + (_e1981 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1976 + 127i)) << bitcast<u32>(23i))))), (_e429.member_2.y * ((1f + (_e2041 * (1f + (_e2041 * (0.5f + (_e2041 * (0.16666667f + (_e2041 * (0.041666668f + (_e2041 * (0.008333334f + (_e2041 * (0.001388889f + (_e2041 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2036 + 127i)) << bitcast<u32>(23i))))), (_e429.member_2.z * ((1f + (_e2101 * (1f + (_e2101 * (0.5f + (_e2101 * (0.16666667f + (_e2101 * (0.041666668f + (_e2101 * (0.008333334f + (_e2101 * (0.001388889f + (_e2101 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2096 + 127i)) << bitcast<u32>(23i)))))), _e1941.member_3, _e1941.member_4, _e1941.member_5, _e1941.member_6, _e1941.member_7, _e1941.member_8, _e1941.member_9, _e1941.member_10, _e1941.member_11, _e1941.member_12, _e1941.member_13, _e1941.member_14);
} else {
phi_3226_ = _e1921;
}
let _e2142 = phi_3226_;
phi_4414_ = type_20(_e2142.member, _e2142.member_1, _e2142.member_2, _e2142.member_3, _e2142.member_4, _e2142.member_5, 3f, _e2142.member_7, _e2142.member_8, _e2142.member_9, _e2142.member_10, _e2142.member_11, _e2142.member_12, _e2142.member_13, _e2142.member_14);
phi_4415_ = _e433;
} else {
let _e818 = (1i << bitcast<u32>((_e801 & 31i)));
if ((((_e429.member_1.x * _e569) + (_e429.member_1.y * _e570)) + (_e429.member_1.z * _e571)) < 0f) {
phi_3246_ = (_e433 | _e818);
} else {
phi_3246_ = (_e433 & ~(_e818));
}
let _e829 = phi_3246_;
phi_3248_ = 15i;
phi_3251_ = 16i;
loop {
let _e831 = phi_3248_;
let _e833 = phi_3251_;
local_3 = _e833;
local_6 = _e833;
local_7 = _e833;
local_9 = _e833;
let _e834 = (_e831 >= 0i);
if _e834 {
phi_3249_ = (_e831 - 1i);
phi_3252_ = select(_e833, _e831, (((_e829 >> bitcast<u32>((_e831 & 31i))) & 1i) == 1i));
} else {
phi_3249_ = i32();
phi_3252_ = i32();
}
let _e843 = phi_3249_;
let _e845 = phi_3252_;
continue;
continuing {
phi_3248_ = _e843;
phi_3251_ = _e845;
break if !(_e834);
}
}
let _e875 = type_20(vec3<f32>((_e429.member.x + (_e429.member_1.x * _e429.member_14)), (_e429.member.y + (_e429.member_1.y * _e429.member_14)), (_e429.member.z + (_e429.member_1.z * _e429.member_14))), _e429.member_1, _e429.member_2, _e429.member_3, _e429.member_4, _e429.member_5, _e429.member_6, _e429.member_7, _e429.member_8, _e429.member_9, _e429.member_10, _e429.member_11, _e429.member_12, _e429.member_13, _e429.member_14);
let _e892 = type_20(_e875.member, _e875.member_1, _e875.member_2, _e875.member_3, _e875.member_4, (_e429.member_5 + _e429.member_14), _e875.member_6, _e875.member_7, _e875.member_8, _e875.member_9, _e875.member_10, _e875.member_11, _e875.member_12, _e875.member_13, _e875.member_14);
let _e912 = type_20(_e892.member, _e892.member_1, _e892.member_2, _e892.member_3, _e892.member_4, _e892.member_5, _e892.member_6, _e892.member_7, _e892.member_8, _e892.member_9, (_e429.member_10 + select(0f, _e429.member_14, (_e429.member_8 == 0f))), _e892.member_11, _e892.member_12, _e892.member_13, _e892.member_14);
let _e914 = local;
if (_e914 != 16i) {
let _e932 = type_20(_e912.member, _e912.member_1, _e912.member_2, _e912.member_3, _e912.member_4, _e912.member_5, _e912.member_6, _e912.member_7, _e912.member_8, (_e429.member_9 + _e429.member_14), _e912.member_10, _e912.member_11, _e912.member_12, _e912.member_13, _e912.member_14);
let _e934 = local_1;
let _e935 = (_e934 * 4i);
let _e936 = (_e935 + 1i);
let _e938 = select(_e804, _e936, (_e936 < _e804));
let _e944 = global_4.member[bitcast<u32>(select(0i, _e938, (_e938 > 0i)))];
let _e946 = -((_e944 * _e429.member_14));
let _e948 = select(-87f, _e946, (_e946 > -87f));
let _e950 = select(88f, _e948, (_e948 < 88f));
let _e952 = ((_e950 * 1.442695f) + 0.5f);
let _e954 = select(-127f, _e952, (_e952 > -127f));
let _e956 = select(128f, _e954, (_e954 < 128f));
let _e963 = select(0i, select(select(i32(_e956), i32(-2147483648), (_e956 < -2147483600f)), 2147483647i, (_e956 > 2147483500f)), (_e956 == _e956));
let _e967 = (_e963 - select(0i, 1i, (_e956 < f32(_e963))));
let _e968 = f32(_e967);
let _e972 = ((_e950 - (_e968 * 0.6933594f)) - (_e968 * -2.1219444e-4f));
let _e996 = (_e935 + 2i);
let _e998 = select(_e804, _e996, (_e996 < _e804));
let _e1004 = global_4.member[bitcast<u32>(select(0i, _e998, (_e998 > 0i)))];
let _e1006 = -((_e1004 * _e429.member_14));
let _e1008 = select(-87f, _e1006, (_e1006 > -87f));
let _e1010 = select(88f, _e1008, (_e1008 < 88f));
let _e1012 = ((_e1010 * 1.442695f) + 0.5f);
let _e1014 = select(-127f, _e1012, (_e1012 > -127f));
let _e1016 = select(128f, _e1014, (_e1014 < 128f));
let _e1023 = select(0i, select(select(i32(_e1016), i32(-2147483648), (_e1016 < -2147483600f)), 2147483647i, (_e1016 > 2147483500f)), (_e1016 == _e1016));
let _e1027 = (_e1023 - select(0i, 1i, (_e1016 < f32(_e1023))));
let _e1028 = f32(_e1027);
let _e1032 = ((_e1010 - (_e1028 * 0.6933594f)) - (_e1028 * -2.1219444e-4f));
let _e1056 = (_e935 + 3i);
let _e1058 = select(_e804, _e1056, (_e1056 < _e804));
let _e1064 = global_4.member[bitcast<u32>(select(0i, _e1058, (_e1058 > 0i)))];
let _e1066 = -((_e1064 * _e429.member_14));
let _e1068 = select(-87f, _e1066, (_e1066 > -87f));
let _e1070 = select(88f, _e1068, (_e1068 < 88f));
let _e1072 = ((_e1070 * 1.442695f) + 0.5f);
let _e1074 = select(-127f, _e1072, (_e1072 > -127f));
let _e1076 = select(128f, _e1074, (_e1074 < 128f));
let _e1083 = select(0i, select(select(i32(_e1076), i32(-2147483648), (_e1076 < -2147483600f)), 2147483647i, (_e1076 > 2147483500f)), (_e1076 == _e1076));
let _e1087 = (_e1083 - select(0i, 1i, (_e1076 < f32(_e1083))));
let _e1088 = f32(_e1087);
let _e1092 = ((_e1070 - (_e1088 * 0.6933594f)) - (_e1088 * -2.1219444e-4f));
phi_3553_ = type_20(_e932.member, _e932.member_1, vec3<f32>((_e429.member_2.x * ((1f + (_e972 * (1f + (_e972 * (0.5f + (_e972 * (0.16666667f + (_e972 * (0.041666668f + (_e972 * (0.008333334f + (_e972 * (0.001388889f + (_e972 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e967 + 127i)) << bitcast<u32>(23i))))), (_e429.member_2.y * ((1f + (_e1032 * (1f + (_e1032 * (0.5f + (_e1032 * (0.16666667f + (_e1032 * (0.041666668f + (_e1032 * (0.008333334f + (_e1032 * (0.001388889f + (_e1032 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1027 + 127i)) << bitcast<u32>(23i))))), (_e429.member_2.z * ((1f + (_e1092 * (1f + (_e1092 * (0.5f + (_e1092 * (0.16666667f + (_e1092 * (0.041666668f + (_e1092 * (0.008333334f + (_e1092 * (0.001388889f + (_e1092 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1087 + 127i)) << bitcast<u32>(23i)))))), _e932.member_3, _e932.member_4, _e932.member_5, _e932.member_6, _e932.member_7, _e932.member_8, _e932.member_9, _e932.member_10, _e932.member_11, _e932.member_12, _e932.member_13, _e932.member_14);
} else {
phi_3553_ = _e912;
}
let _e1133 = phi_3553_;
let _e1135 = local_2;
let _e1137 = local_3;
if (_e1135 == _e1137) {
let _e1715 = global_1.member.member_17.member.member;
let _e1729 = ((((_e1715.member.member * _e1133.member.x) + (_e1715.member.member_1 * _e1133.member.y)) + (_e1715.member.member_2 * _e1133.member.z)) + _e1715.member_1);
let _e1738 = -((((_e1715.member.member * _e1133.member_1.x) + (_e1715.member.member_1 * _e1133.member_1.y)) + (_e1715.member.member_2 * _e1133.member_1.z)));
let _e1740 = (_e1738 > 1e-9f);
let _e1744 = ((_e1729 / select(1e-9f, _e1738, _e1740)) - 0.015625f);
let _e1747 = select(1e30f, select(0f, _e1744, (_e1744 > 0f)), ((_e1729 > 0f) && _e1740));
let _e1752 = global_1.member.member_17.member_1.member;
let _e1763 = ((((_e1752.member.member * _e1133.member.x) + (_e1752.member.member_1 * _e1133.member.y)) + (_e1752.member.member_2 * _e1133.member.z)) + _e1752.member_1);
let _e1769 = -((((_e1752.member.member * _e1133.member_1.x) + (_e1752.member.member_1 * _e1133.member_1.y)) + (_e1752.member.member_2 * _e1133.member_1.z)));
let _e1771 = (_e1769 > 1e-9f);
let _e1775 = ((_e1763 / select(1e-9f, _e1769, _e1771)) - 0.015625f);
let _e1778 = select(1e30f, select(0f, _e1775, (_e1775 > 0f)), ((_e1763 > 0f) && _e1771));
let _e1782 = (_e1778 < _e1747);
let _e1800 = type_20(_e1133.member, _e1133.member_1, _e1133.member_2, _e1133.member_3, _e1133.member_4, _e1133.member_5, _e1133.member_6, _e1133.member_7, _e1133.member_8, _e1133.member_9, _e1133.member_10, _e1133.member_11, 0i, _e1133.member_13, _e1133.member_14);
let _e1815 = type_20(_e1800.member, _e1800.member_1, _e1800.member_2, _e1800.member_3, _e1800.member_4, _e1800.member_5, _e1800.member_6, _e1800.member_7, _e1800.member_8, _e1800.member_9, _e1800.member_10, _e1800.member_11, _e1800.member_12, select(select(-2i, -3i, _e1782), -1i, ((_e1747 >= 1e30f) && (_e1778 >= 1e30f))), _e1800.member_14);
phi_4406_ = type_20(_e1815.member, _e1815.member_1, _e1815.member_2, _e1815.member_3, _e1815.member_4, _e1815.member_5, _e1815.member_6, _e1815.member_7, _e1815.member_8, _e1815.member_9, _e1815.member_10, _e1815.member_11, _e1815.member_12, _e1815.member_13, select(_e1747, _e1778, _e1782));
phi_4407_ = type_20();
phi_4408_ = true;
} else {
let _e1141 = local_4;
let _e1142 = (_e1141 * 4i);
let _e1144 = select(_e804, _e1142, (_e1142 < _e804));
let _e1150 = global_4.member[bitcast<u32>(select(0i, _e1144, (_e1144 > 0i)))];
let _e1152 = local_5;
let _e1154 = select(_e1150, 1f, (_e1152 == 16i));
let _e1156 = local_6;
let _e1157 = (_e1156 * 4i);
let _e1159 = select(_e804, _e1157, (_e1157 < _e804));
let _e1165 = global_4.member[bitcast<u32>(select(0i, _e1159, (_e1159 > 0i)))];
let _e1167 = local_7;
let _e1169 = select(_e1165, 1f, (_e1167 == 16i));
let _e1179 = select(1f, -1f, ((((_e1133.member_1.x * _e782) + (_e1133.member_1.y * _e783)) + (_e1133.member_1.z * _e784)) > 0f));
let _e1180 = (_e782 * _e1179);
let _e1181 = (_e783 * _e1179);
let _e1182 = (_e784 * _e1179);
let _e1188 = -((((_e1133.member_1.x * _e1180) + (_e1133.member_1.y * _e1181)) + (_e1133.member_1.z * _e1182)));
let _e1190 = select(0f, _e1188, (_e1188 > 0f));
let _e1191 = (_e1154 / _e1169);
let _e1193 = (_e1190 * _e1190);
let _e1196 = (1f - ((_e1191 * _e1191) * (1f - _e1193)));
let _e1197 = (_e1196 <= 0f);
let _e1205 = ((_e1191 * _e1190) - sqrt(select(0f, _e1196, (_e1196 > 0f))));
let _e1212 = (2f * _e1190);
let _e1219 = select(((_e1133.member_1.x * _e1191) + (_e1180 * _e1205)), (_e1133.member_1.x + (_e1180 * _e1212)), _e1197);
let _e1220 = select(((_e1133.member_1.y * _e1191) + (_e1181 * _e1205)), (_e1133.member_1.y + (_e1181 * _e1212)), _e1197);
let _e1221 = select(((_e1133.member_1.z * _e1191) + (_e1182 * _e1205)), (_e1133.member_1.z + (_e1182 * _e1212)), _e1197);
let _e1226 = (((_e1219 * _e1219) + (_e1220 * _e1220)) + (_e1221 * _e1221));
let _e1229 = sqrt(select(0f, _e1226, (_e1226 > 0f)));
let _e1232 = (1f / select(1e-20f, _e1229, (_e1229 > 1e-20f)));
let _e1237 = (_e1169 / _e1154);
let _e1240 = (((_e1237 * _e1237) - 1f) + _e1193);
let _e1243 = sqrt(select(0f, _e1240, (_e1240 > 0f)));
let _e1244 = (_e1243 - _e1190);
let _e1245 = (_e1243 + _e1190);
let _e1248 = (_e1244 / select(1e-6f, _e1245, (_e1245 > 1e-6f)));
let _e1252 = ((_e1190 * _e1244) + 1f);
let _e1255 = (((_e1190 * _e1245) - 1f) / select(1e-6f, _e1252, (_e1252 > 1e-6f)));
let _e1269 = global_1.member.member_1;
let _e1272 = select(0f, select(select((((0.5f * _e1248) * _e1248) * (1f + (_e1255 * _e1255))), 1f, (_e1240 <= 0f)), 0f, (_e1154 == _e1169)), ((_e1269 & 1u) != 0u));
if (_e1133.member_8 == 0f) {
let _e1287 = type_20(_e1133.member, _e1133.member_1, _e1133.member_2, vec3<f32>(_e782, _e783, _e784), _e1133.member_4, _e1133.member_5, _e1133.member_6, _e1133.member_7, _e1133.member_8, _e1133.member_9, _e1133.member_10, _e1133.member_11, _e1133.member_12, _e1133.member_13, _e1133.member_14);
phi_3888_ = type_20(_e1287.member, _e1287.member_1, _e1287.member_2, _e1287.member_3, _e1287.member_4, _e1287.member_5, _e1287.member_6, _e1287.member_7, _e1287.member_8, _e1287.member_9, _e1287.member_10, _e1272, _e1287.member_12, _e1287.member_13, _e1287.member_14);
} else {
phi_3888_ = _e1133;
}
let _e1304 = phi_3888_;
let _e1306 = (_e1304.member_8 + 1f);
let _e1321 = type_20(_e1304.member, _e1304.member_1, _e1304.member_2, _e1304.member_3, _e1304.member_4, _e1304.member_5, _e1304.member_6, _e1304.member_7, _e1306, _e1304.member_9, _e1304.member_10, _e1304.member_11, _e1304.member_12, _e1304.member_13, _e1304.member_14);
let _e1324 = ((_e104.member_2 == 0u) && (_e1306 >= 2f));
if (_e1197 && _e1324) {
let _e1349 = (((_e1304.member_1.x * _e782) + (_e1304.member_1.y * _e783)) + (_e1304.member_1.z * _e784));
let _e1353 = (_e1304.member_1.x - (_e782 * _e1349));
let _e1354 = (_e1304.member_1.y - (_e783 * _e1349));
let _e1355 = (_e1304.member_1.z - (_e784 * _e1349));
let _e1360 = (((_e1353 * _e1353) + (_e1354 * _e1354)) + (_e1355 * _e1355));
let _e1363 = sqrt(select(0f, _e1360, (_e1360 > 0f)));
let _e1366 = (1f / select(1e-20f, _e1363, (_e1363 > 1e-20f)));
phi_3941_ = type_20(_e1321.member, vec3<f32>((_e1353 * _e1366), (_e1354 * _e1366), (_e1355 * _e1366)), _e1321.member_2, _e1321.member_3, _e1321.member_4, _e1321.member_5, _e1321.member_6, _e1321.member_7, _e1321.member_8, _e1321.member_9, _e1321.member_10, _e1321.member_11, _e1321.member_12, _e1321.member_13, _e1321.member_14);
} else {
phi_3941_ = type_20(_e1321.member, vec3<f32>((_e1219 * _e1232), (_e1220 * _e1232), (_e1221 * _e1232)), _e1321.member_2, _e1321.member_3, _e1321.member_4, _e1321.member_5, _e1321.member_6, _e1321.member_7, _e1321.member_8, _e1321.member_9, _e1321.member_10, _e1321.member_11, _e1321.member_12, _e1321.member_13, _e1321.member_14);
}
let _e1387 = phi_3941_;
if _e1197 {
phi_3955_ = _e1387;
} else {
let _e1388 = (1f - _e1272);
phi_3955_ = type_20(_e1387.member, _e1387.member_1, vec3<f32>((_e1387.member_2.x * _e1388), (_e1387.member_2.y * _e1388), (_e1387.member_2.z * _e1388)), _e1387.member_3, _e1387.member_4, _e1387.member_5, _e1387.member_6, _e1387.member_7, _e1387.member_8, _e1387.member_9, _e1387.member_10, _e1387.member_11, _e1387.member_12, _e1387.member_13, _e1387.member_14);
}
let _e1415 = phi_3955_;
let _e1422 = global_1.member.member_17.member.member;
let _e1436 = ((((_e1422.member.member * _e1415.member.x) + (_e1422.member.member_1 * _e1415.member.y)) + (_e1422.member.member_2 * _e1415.member.z)) + _e1422.member_1);
let _e1445 = -((((_e1422.member.member * _e1415.member_1.x) + (_e1422.member.member_1 * _e1415.member_1.y)) + (_e1422.member.member_2 * _e1415.member_1.z)));
let _e1447 = (_e1445 > 1e-9f);
let _e1451 = ((_e1436 / select(1e-9f, _e1445, _e1447)) - 0.015625f);
let _e1454 = select(1e30f, select(0f, _e1451, (_e1451 > 0f)), ((_e1436 > 0f) && _e1447));
let _e1459 = global_1.member.member_17.member_1.member;
let _e1470 = ((((_e1459.member.member * _e1415.member.x) + (_e1459.member.member_1 * _e1415.member.y)) + (_e1459.member.member_2 * _e1415.member.z)) + _e1459.member_1);
let _e1476 = -((((_e1459.member.member * _e1415.member_1.x) + (_e1459.member.member_1 * _e1415.member_1.y)) + (_e1459.member.member_2 * _e1415.member_1.z)));
let _e1478 = (_e1476 > 1e-9f);
let _e1482 = ((_e1470 / select(1e-9f, _e1476, _e1478)) - 0.015625f);
let _e1485 = select(1e30f, select(0f, _e1482, (_e1482 > 0f)), ((_e1470 > 0f) && _e1478));
let _e1489 = (_e1485 < _e1454);
let _e1491 = select(select(-2i, -3i, _e1489), -1i, ((_e1454 >= 1e30f) && (_e1485 >= 1e30f)));
let _e1492 = select(_e1454, _e1485, _e1489);
let _e1507 = type_20(_e1415.member, _e1415.member_1, _e1415.member_2, _e1415.member_3, _e1415.member_4, _e1415.member_5, _e1415.member_6, _e1415.member_7, _e1415.member_8, _e1415.member_9, _e1415.member_10, _e1415.member_11, 0i, _e1415.member_13, _e1415.member_14);
let _e1522 = type_20(_e1507.member, _e1507.member_1, _e1507.member_2, _e1507.member_3, _e1507.member_4, _e1507.member_5, _e1507.member_6, _e1507.member_7, _e1507.member_8, _e1507.member_9, _e1507.member_10, _e1507.member_11, _e1507.member_12, _e1491, _e1507.member_14);
let _e1537 = type_20(_e1522.member, _e1522.member_1, _e1522.member_2, _e1522.member_3, _e1522.member_4, _e1522.member_5, _e1522.member_6, _e1522.member_7, _e1522.member_8, _e1522.member_9, _e1522.member_10, _e1522.member_11, _e1522.member_12, _e1522.member_13, _e1492);
let _e1539 = local_8;
let _e1541 = local_9;
let _e1544 = ((_e1269 & 2u) != 0u);
if (_e1324 && !(_e1544)) {
if (_e1491 == -1i) {
phi_4380_ = type_20(_e1537.member, _e1537.member_1, _e1537.member_2, _e1537.member_3, _e1537.member_4, _e1537.member_5, 1f, _e1537.member_7, _e1537.member_8, _e1537.member_9, _e1537.member_10, _e1537.member_11, _e1537.member_12, _e1537.member_13, _e1537.member_14);
} else {
let _e1620 = type_20(vec3<f32>((_e1415.member.x + (_e1415.member_1.x * _e1492)), (_e1415.member.y + (_e1415.member_1.y * _e1492)), (_e1415.member.z + (_e1415.member_1.z * _e1492))), _e1537.member_1, _e1537.member_2, _e1537.member_3, _e1537.member_4, _e1537.member_5, _e1537.member_6, _e1537.member_7, _e1537.member_8, _e1537.member_9, _e1537.member_10, _e1537.member_11, _e1537.member_12, _e1537.member_13, _e1537.member_14);
let _e1637 = type_20(_e1620.member, _e1620.member_1, _e1620.member_2, _e1620.member_3, _e1620.member_4, (_e1415.member_5 + _e1492), _e1620.member_6, _e1620.member_7, _e1620.member_8, _e1620.member_9, _e1620.member_10, _e1620.member_11, _e1620.member_12, _e1620.member_13, _e1620.member_14);
let _e1653 = type_20(_e1637.member, _e1637.member_1, _e1637.member_2, _e1637.member_3, _e1637.member_4, _e1637.member_5, _e1637.member_6, _e1637.member_7, _e1637.member_8, _e1637.member_9, _e1637.member_10, _e1637.member_11, _e1637.member_12, _e1637.member_13, (_e1492 - _e1492));
let _e1673 = type_20(_e1653.member, _e1653.member_1, _e1653.member_2, _e1653.member_3, _e1653.member_4, _e1653.member_5, _e1653.member_6, _e1653.member_7, _e1653.member_8, _e1653.member_9, (_e1415.member_10 + select(0f, _e1492, (_e1415.member_8 == 0f))), _e1653.member_11, _e1653.member_12, _e1653.member_13, _e1653.member_14);
phi_4380_ = type_20(_e1673.member, _e1673.member_1, _e1673.member_2, _e1673.member_3, _e1673.member_4, _e1673.member_5, 3f, _e1673.member_7, _e1673.member_8, _e1673.member_9, _e1673.member_10, _e1673.member_11, _e1673.member_12, _e1673.member_13, _e1673.member_14);
}
let _e1705 = phi_4380_;
phi_4401_ = _e1705;
} else {
let _e1551 = global_1.member.member_5;
if ((!(_e1324) && (_e1415.member_8 >= f32(bitcast<i32>(_e1551)))) && (select(_e1541, _e1539, _e1197) != 16i)) {
phi_4400_ = type_20(_e1537.member, _e1537.member_1, _e1537.member_2, _e1537.member_3, _e1537.member_4, _e1537.member_5, 2f, _e1537.member_7, _e1537.member_8, _e1537.member_9, _e1537.member_10, _e1537.member_11, _e1537.member_12, _e1537.member_13, _e1537.member_14);
} else {
if _e1544 {
phi_4399_ = type_20(_e1537.member, _e1537.member_1, _e1537.member_2, _e1537.member_3, _e1537.member_4, _e1537.member_5, 4f, _e1537.member_7, _e1537.member_8, _e1537.member_9, _e1537.member_10, _e1537.member_11, _e1537.member_12, _e1537.member_13, _e1537.member_14);
} else {
phi_4399_ = _e1537;
}
let _e1574 = phi_4399_;
phi_4400_ = _e1574;
}
let _e1591 = phi_4400_;
phi_4401_ = _e1591;
}
let _e1707 = phi_4401_;
phi_4406_ = _e1707;
phi_4407_ = _e1707;
phi_4408_ = !(_e1197);
}
let _e1832 = phi_4406_;
let _e1834 = phi_4407_;
let _e1836 = phi_4408_;
if _e1836 {
phi_4412_ = _e1832;
} else {
phi_4412_ = _e1834;
}
let _e1838 = phi_4412_;
phi_4414_ = _e1838;
phi_4415_ = select(_e433, _e829, _e1836);
}
let _e2159 = phi_4414_;
let _e2161 = phi_4415_;
phi_4416_ = _e2159;
phi_4417_ = _e2161;
}
let _e2629 = phi_4416_;
let _e2631 = phi_4417_;
phi_4418_ = _e2629;
phi_4419_ = _e2631;
}
let _e3021 = phi_4418_;
let _e3023 = phi_4419_;
phi_853_ = _e3021;
phi_856_ = (_e431 + 1i);
phi_858_ = _e3023;
} else {
phi_853_ = type_20();
phi_856_ = i32();
phi_858_ = i32();
}
let _e3025 = phi_853_;
let _e3027 = phi_856_;
let _e3029 = phi_858_;
continue;
continuing {
phi_852_ = _e3025;
phi_855_ = _e3027;
phi_857_ = _e3029;
break if !(_e437);
}
}
let _e3032 = local_15;
if (_e3032 == 0i) {
phi_4425_ = 16i;
} else {
let _e3035 = local_16;
phi_4425_ = -(_e3035);
}
let _e3038 = phi_4425_;
let _e3040 = local_17;
let _e3044 = local_18;
let _e3048 = local_19;
let _e3052 = local_20;
let _e3056 = local_21;
let _e3060 = local_22;
let _e3064 = local_23;
let _e3068 = local_24;
let _e3072 = local_25;
let _e3076 = local_26;
let _e3080 = local_27;
let _e3084 = local_28;
let _e3088 = local_29;
let _e3092 = local_30;
let _e3096 = local_31;
let _e3100 = local_32;
let _e3104 = local_33;
let _e3107 = local_34;
let _e3110 = local_35;
let _e3113 = local_36;
let _e3116 = local_37;
let _e3120 = local_38;
let _e3124 = local_39;
global_5.member[_e113] = _e3040.member.x;
global_5.member[_e125] = _e3044.member.y;
global_5.member[_e136] = _e3048.member.z;
global_5.member[_e147] = _e3052.member_1.x;
global_5.member[_e158] = _e3056.member_1.y;
global_5.member[_e169] = _e3060.member_1.z;
global_5.member[_e180] = _e3064.member_2.x;
global_5.member[_e191] = _e3068.member_2.y;
global_5.member[_e202] = _e3072.member_2.z;
global_5.member[_e213] = _e3076.member_3.x;
global_5.member[_e224] = _e3080.member_3.y;
global_5.member[_e235] = _e3084.member_3.z;
global_5.member[_e246] = _e3088.member_4.x;
global_5.member[_e257] = _e3092.member_4.y;
global_5.member[_e268] = _e3096.member_4.z;
global_5.member[_e279] = _e3100.member_5;
let _e3161 = local_40;
global_5.member[_e290] = _e3161;
global_5.member[_e301] = f32(_e3038);
global_5.member[_e312] = _e3104.member_8;
global_5.member[_e323] = _e3107.member_9;
global_5.member[_e334] = _e3110.member_10;
global_5.member[_e345] = _e3113.member_11;
global_5.member[_e356] = f32(_e3116.member_12);
global_5.member[_e367] = f32(_e3120.member_13);
global_5.member[_e378] = _e3124.member_14;
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
