struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
}
struct type_5 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: type_4,
member_4: type_4,
member_5: type_4,
member_6: type_4,
member_7: type_4,
member_8: type_4,
member_9: type_4,
member_10: vec4<u32>,
member_11: type_4,
member_12: type_4,
member_13: type_4,
member_14: type_4,
member_15: type_4,
member_16: type_4,
member_17: type_4,
member_18: type_4,
member_19: type_4,
member_20: type_4,
member_21: type_4,
member_22: type_4,
member_23: type_4,
member_24: vec4<u32>,
member_25: type_4,
member_26: type_4,
member_27: type_4,
member_28: type_4,
}
struct type_6 {
member: type_5,
}
struct type_8 {
member: array<f32>,
}
struct type_12 {
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
var<storage> global_1: type_6;
@group(0) @binding(1)
var<storage> global_2: type_8;
@group(0) @binding(2)
var<storage> global_3: type_8;
@group(0) @binding(3)
var<storage> global_4: type_8;
@group(0) @binding(4)
var<storage, read_write> global_5: type_8;
fn function_() {
var phi_631_: u32;
var phi_840_: i32;
var phi_842_: type_12;
var phi_845_: i32;
var phi_847_: i32;
var phi_2121_: i32;
var phi_2124_: i32;
var phi_2122_: i32;
var phi_2125_: i32;
var phi_3236_: i32;
var phi_3238_: i32;
var phi_3241_: i32;
var phi_3239_: i32;
var phi_3242_: i32;
var local: i32;
var local_1: i32;
var phi_3543_: type_12;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var phi_3872_: type_12;
var phi_3925_: type_12;
var phi_3939_: type_12;
var local_8: i32;
var local_9: i32;
var phi_4378_: type_12;
var phi_4379_: type_12;
var phi_4358_: type_12;
var phi_4380_: type_12;
var phi_4385_: type_12;
var phi_4386_: type_12;
var phi_4387_: bool;
var phi_4391_: type_12;
var local_10: i32;
var local_11: i32;
var phi_3216_: type_12;
var phi_4393_: type_12;
var phi_4394_: i32;
var phi_1511_: i32;
var phi_1514_: i32;
var phi_1512_: i32;
var phi_1515_: i32;
var local_12: i32;
var local_13: i32;
var local_14: i32;
var phi_2117_: type_12;
var phi_1831_: type_12;
var phi_2119_: type_12;
var phi_4395_: type_12;
var phi_4396_: i32;
var phi_1470_: type_12;
var phi_1471_: type_12;
var phi_1503_: i32;
var phi_4397_: type_12;
var phi_4398_: i32;
var phi_843_: type_12;
var phi_846_: i32;
var phi_848_: i32;
var local_15: i32;
var local_16: i32;
var phi_4404_: i32;
var local_17: type_12;
var local_18: type_12;
var local_19: type_12;
var local_20: type_12;
var local_21: type_12;
var local_22: type_12;
var local_23: type_12;
var local_24: type_12;
var local_25: type_12;
var local_26: type_12;
var local_27: type_12;
var local_28: type_12;
var local_29: type_12;
var local_30: type_12;
var local_31: type_12;
var local_32: type_12;
var local_33: type_12;
var local_34: type_12;
var local_35: type_12;
var local_36: type_12;
var local_37: type_12;
var local_38: type_12;
var local_39: type_12;
var local_40: f32;
let _e93 = global;
let _e97 = arrayLength((&global_3.member));
let _e99 = arrayLength((&global_4.member));
let _e105 = global_1.member.member[0u];
let _e109 = global_1.member.member[1u];
if (_e93.x < _e105) {
if (_e93.y < _e109) {
let _e114 = (_e105 * _e109);
let _e116 = ((_e93.y * _e105) + _e93.x);
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
phi_631_ = 3u;
} else {
phi_631_ = select(0u, 1u, (_e302 == 4f));
}
let _e395 = phi_631_;
if (_e395 > 1u) {
let _e400 = global_1.member.member[2u];
let _e412 = select(0i, select(select(i32(_e313), i32(-2147483648), (_e313 < -2147483600f)), 2147483647i, (_e313 > 2147483500f)), (_e313 == _e313));
let _e428 = bitcast<i32>(arrayLength((&global_2.member)));
if (_e412 == 16i) {
phi_840_ = 0i;
} else {
phi_840_ = -(_e412);
}
let _e433 = phi_840_;
phi_842_ = type_12(vec3<f32>(_e127, _e137, _e148), vec3<f32>(_e159, _e170, _e181), vec3<f32>(_e192, _e203, _e214), vec3<f32>(_e225, _e236, _e247), vec3<f32>(_e258, _e269, _e280), _e291, _e302, _e412, _e324, _e335, _e346, _e357, select(0i, select(select(i32(_e368), i32(-2147483648), (_e368 < -2147483600f)), 2147483647i, (_e368 > 2147483500f)), (_e368 == _e368)), select(0i, select(select(i32(_e379), i32(-2147483648), (_e379 < -2147483600f)), 2147483647i, (_e379 > 2147483500f)), (_e379 == _e379)), _e390);
phi_845_ = 0i;
phi_847_ = _e433;
loop {
let _e435 = phi_842_;
let _e437 = phi_845_;
let _e439 = phi_847_;
local_15 = _e439;
local_16 = _e439;
local_17 = _e435;
local_18 = _e435;
local_19 = _e435;
local_20 = _e435;
local_21 = _e435;
local_22 = _e435;
local_23 = _e435;
local_24 = _e435;
local_25 = _e435;
local_26 = _e435;
local_27 = _e435;
local_28 = _e435;
local_29 = _e435;
local_30 = _e435;
local_31 = _e435;
local_32 = _e435;
local_33 = _e435;
local_34 = _e435;
local_35 = _e435;
local_36 = _e435;
local_37 = _e435;
local_38 = _e435;
local_39 = _e435;
let _e443 = ((_e437 < 1024i) && (_e435.member_6 == 0f));
local_40 = _e435.member_6;
if _e443 {
if (_e435.member_12 < (_e428 / 8i)) {
let _e2629 = (_e435.member_12 * 8i);
let _e2633 = bitcast<f32>((bitcast<u32>(_e435.member_1.x) & 2147483647u));
let _e2638 = (1f / select(_e435.member_1.x, select(1e-12f, -1e-12f, (_e435.member_1.x < 0f)), (_e2633 < 1e-12f)));
let _e2642 = bitcast<f32>((bitcast<u32>(_e435.member_1.y) & 2147483647u));
let _e2647 = (1f / select(_e435.member_1.y, select(1e-12f, -1e-12f, (_e435.member_1.y < 0f)), (_e2642 < 1e-12f)));
let _e2651 = bitcast<f32>((bitcast<u32>(_e435.member_1.z) & 2147483647u));
let _e2656 = (1f / select(_e435.member_1.z, select(1e-12f, -1e-12f, (_e435.member_1.z < 0f)), (_e2651 < 1e-12f)));
let _e2658 = (_e428 - 1i);
let _e2660 = select(_e2658, _e2629, (_e2629 < _e2658));
let _e2666 = global_2.member[bitcast<u32>(select(0i, _e2660, (_e2660 > 0i)))];
let _e2667 = (_e2629 + 1i);
let _e2669 = select(_e2658, _e2667, (_e2667 < _e2658));
let _e2675 = global_2.member[bitcast<u32>(select(0i, _e2669, (_e2669 > 0i)))];
let _e2676 = (_e2629 + 2i);
let _e2678 = select(_e2658, _e2676, (_e2676 < _e2658));
let _e2684 = global_2.member[bitcast<u32>(select(0i, _e2678, (_e2678 > 0i)))];
let _e2685 = (_e2629 + 3i);
let _e2687 = select(_e2658, _e2685, (_e2685 < _e2658));
let _e2693 = global_2.member[bitcast<u32>(select(0i, _e2687, (_e2687 > 0i)))];
let _e2694 = (_e2629 + 4i);
let _e2696 = select(_e2658, _e2694, (_e2694 < _e2658));
let _e2702 = global_2.member[bitcast<u32>(select(0i, _e2696, (_e2696 > 0i)))];
let _e2703 = (_e2629 + 5i);
let _e2705 = select(_e2658, _e2703, (_e2703 < _e2658));
let _e2711 = global_2.member[bitcast<u32>(select(0i, _e2705, (_e2705 > 0i)))];
let _e2714 = ((_e2666 - _e435.member.x) * _e2638);
let _e2716 = ((_e2693 - _e435.member.x) * _e2638);
let _e2719 = ((_e2675 - _e435.member.y) * _e2647);
let _e2721 = ((_e2702 - _e435.member.y) * _e2647);
let _e2724 = ((_e2684 - _e435.member.z) * _e2656);
let _e2726 = ((_e2711 - _e435.member.z) * _e2656);
let _e2728 = select(_e2716, _e2714, (_e2714 < _e2716));
let _e2730 = select(_e2721, _e2719, (_e2719 < _e2721));
let _e2732 = select(_e2730, _e2728, (_e2728 > _e2730));
let _e2734 = select(_e2726, _e2724, (_e2724 < _e2726));
let _e2738 = select(_e2716, _e2714, (_e2714 > _e2716));
let _e2740 = select(_e2721, _e2719, (_e2719 > _e2721));
let _e2742 = select(_e2740, _e2738, (_e2738 < _e2740));
let _e2744 = select(_e2726, _e2724, (_e2724 > _e2726));
let _e2746 = select(_e2744, _e2742, (_e2742 < _e2744));
let _e2752 = ((select(_e2734, _e2732, (_e2732 > _e2734)) <= select(_e435.member_14, _e2746, (_e2746 < _e435.member_14))) && (_e2746 >= 0f));
let _e2753 = (_e2629 + 6i);
let _e2755 = select(_e2658, _e2753, (_e2753 < _e2658));
let _e2761 = global_2.member[bitcast<u32>(select(0i, _e2755, (_e2755 > 0i)))];
let _e2768 = select(0i, select(select(i32(_e2761), i32(-2147483648), (_e2761 < -2147483600f)), 2147483647i, (_e2761 > 2147483500f)), (_e2761 == _e2761));
if (_e2752 && (_e2768 >= 0i)) {
let _e2773 = ((_e2633 >= _e2642) && (_e2633 >= _e2651));
let _e2776 = (!(_e2773) && (_e2642 >= _e2651));
let _e2783 = (1f / select(select(_e435.member_1.z, _e435.member_1.y, _e2776), _e435.member_1.x, _e2773));
let _e2784 = (select(select(_e435.member_1.x, _e435.member_1.z, _e2776), _e435.member_1.y, _e2773) * _e2783);
let _e2785 = (select(select(_e435.member_1.y, _e435.member_1.x, _e2776), _e435.member_1.z, _e2773) * _e2783);
let _e2786 = (_e2768 * 19i);
let _e2788 = (bitcast<i32>(_e97) - 1i);
let _e2790 = select(_e2788, _e2786, (_e2786 < _e2788));
let _e2796 = global_3.member[bitcast<u32>(select(0i, _e2790, (_e2790 > 0i)))];
let _e2797 = (_e2786 + 1i);
let _e2799 = select(_e2788, _e2797, (_e2797 < _e2788));
let _e2805 = global_3.member[bitcast<u32>(select(0i, _e2799, (_e2799 > 0i)))];
let _e2806 = (_e2786 + 2i);
let _e2808 = select(_e2788, _e2806, (_e2806 < _e2788));
let _e2814 = global_3.member[bitcast<u32>(select(0i, _e2808, (_e2808 > 0i)))];
let _e2815 = (_e2796 - _e435.member.x);
let _e2816 = (_e2805 - _e435.member.y);
let _e2817 = (_e2814 - _e435.member.z);
let _e2823 = select(select(_e2817, _e2816, _e2776), _e2815, _e2773);
let _e2825 = (select(select(_e2815, _e2817, _e2776), _e2816, _e2773) - (_e2784 * _e2823));
let _e2827 = (select(select(_e2816, _e2815, _e2776), _e2817, _e2773) - (_e2785 * _e2823));
let _e2829 = (_e2786 + 3i);
let _e2831 = select(_e2788, _e2829, (_e2829 < _e2788));
let _e2837 = global_3.member[bitcast<u32>(select(0i, _e2831, (_e2831 > 0i)))];
let _e2838 = (_e2786 + 4i);
let _e2840 = select(_e2788, _e2838, (_e2838 < _e2788));
let _e2846 = global_3.member[bitcast<u32>(select(0i, _e2840, (_e2840 > 0i)))];
let _e2847 = (_e2786 + 5i);
let _e2849 = select(_e2788, _e2847, (_e2847 < _e2788));
let _e2855 = global_3.member[bitcast<u32>(select(0i, _e2849, (_e2849 > 0i)))];
let _e2856 = (_e2837 - _e435.member.x);
let _e2857 = (_e2846 - _e435.member.y);
let _e2858 = (_e2855 - _e435.member.z);
let _e2864 = select(select(_e2858, _e2857, _e2776), _e2856, _e2773);
let _e2866 = (select(select(_e2856, _e2858, _e2776), _e2857, _e2773) - (_e2784 * _e2864));
let _e2868 = (select(select(_e2857, _e2856, _e2776), _e2858, _e2773) - (_e2785 * _e2864));
let _e2870 = (_e2786 + 6i);
let _e2872 = select(_e2788, _e2870, (_e2870 < _e2788));
let _e2878 = global_3.member[bitcast<u32>(select(0i, _e2872, (_e2872 > 0i)))];
let _e2879 = (_e2786 + 7i);
let _e2881 = select(_e2788, _e2879, (_e2879 < _e2788));
let _e2887 = global_3.member[bitcast<u32>(select(0i, _e2881, (_e2881 > 0i)))];
let _e2888 = (_e2786 + 8i);
let _e2890 = select(_e2788, _e2888, (_e2888 < _e2788));
let _e2896 = global_3.member[bitcast<u32>(select(0i, _e2890, (_e2890 > 0i)))];
let _e2897 = (_e2878 - _e435.member.x);
let _e2898 = (_e2887 - _e435.member.y);
let _e2899 = (_e2896 - _e435.member.z);
let _e2905 = select(select(_e2899, _e2898, _e2776), _e2897, _e2773);
let _e2907 = (select(select(_e2897, _e2899, _e2776), _e2898, _e2773) - (_e2784 * _e2905));
let _e2909 = (select(select(_e2898, _e2897, _e2776), _e2899, _e2773) - (_e2785 * _e2905));
let _e2913 = ((_e2907 * _e2868) - (_e2909 * _e2866));
let _e2916 = ((_e2825 * _e2909) - (_e2827 * _e2907));
let _e2919 = ((_e2866 * _e2827) - (_e2868 * _e2825));
let _e2921 = ((_e2913 + _e2916) + _e2919);
let _e2935 = (!(((((_e2913 < 0f) || (_e2916 < 0f)) || (_e2919 < 0f)) && (((_e2913 > 0f) || (_e2916 > 0f)) || (_e2919 > 0f)))) && (_e2921 != 0f));
let _e2942 = ((((_e2913 * (_e2823 * _e2783)) + (_e2916 * (_e2864 * _e2783))) + (_e2919 * (_e2905 * _e2783))) / select(1f, _e2921, _e2935));
let _e2945 = select(1e30f, _e2942, (_e2935 && (_e2942 > 1e-3f)));
if (_e2945 < _e435.member_14) {
let _e2961 = type_12(_e435.member, _e435.member_1, _e435.member_2, _e435.member_3, _e435.member_4, _e435.member_5, _e435.member_6, _e435.member_7, _e435.member_8, _e435.member_9, _e435.member_10, _e435.member_11, _e435.member_12, _e435.member_13, _e2945);
phi_1470_ = type_12(_e2961.member, _e2961.member_1, _e2961.member_2, _e2961.member_3, _e2961.member_4, _e2961.member_5, _e2961.member_6, _e2961.member_7, _e2961.member_8, _e2961.member_9, _e2961.member_10, _e2961.member_11, _e2961.member_12, _e2768, _e2961.member_14);
} else {
phi_1470_ = _e435;
}
let _e2978 = phi_1470_;
phi_1471_ = _e2978;
} else {
phi_1471_ = _e435;
}
let _e2980 = phi_1471_;
if _e2752 {
phi_1503_ = (_e2980.member_12 + 1i);
} else {
let _e2981 = (_e2629 + 7i);
let _e2983 = select(_e2658, _e2981, (_e2981 < _e2658));
let _e2989 = global_2.member[bitcast<u32>(select(0i, _e2983, (_e2983 > 0i)))];
phi_1503_ = select(0i, select(select(i32(_e2989), i32(-2147483648), (_e2989 < -2147483600f)), 2147483647i, (_e2989 > 2147483500f)), (_e2989 == _e2989));
}
let _e3000 = phi_1503_;
phi_4397_ = type_12(_e2980.member, _e2980.member_1, _e2980.member_2, _e2980.member_3, _e2980.member_4, _e2980.member_5, _e2980.member_6, _e2980.member_7, _e2980.member_8, _e2980.member_9, _e2980.member_10, _e2980.member_11, _e3000, _e2980.member_13, _e2980.member_14);
phi_4398_ = _e439;
} else {
if (_e435.member_13 < 0i) {
phi_1511_ = 15i;
phi_1514_ = 16i;
loop {
let _e2159 = phi_1511_;
let _e2161 = phi_1514_;
local_12 = _e2161;
local_13 = _e2161;
local_14 = _e2161;
let _e2162 = (_e2159 >= 0i);
if _e2162 {
phi_1512_ = (_e2159 - 1i);
phi_1515_ = select(_e2161, _e2159, (((_e439 >> bitcast<u32>((_e2159 & 31i))) & 1i) == 1i));
} else {
phi_1512_ = i32();
phi_1515_ = i32();
}
let _e2171 = phi_1512_;
let _e2173 = phi_1515_;
continue;
continuing {
phi_1511_ = _e2171;
phi_1514_ = _e2173;
break if !(_e2162);
}
}
let _e2175 = (_e435.member_13 == -1i);
let _e2177 = local_12;
if (_e2175 || (_e2177 == 16i)) {
if _e2175 {
phi_1831_ = type_12(_e435.member, _e435.member_1, _e435.member_2, _e435.member_3, _e435.member_4, _e435.member_5, 1f, _e435.member_7, _e435.member_8, _e435.member_9, _e435.member_10, _e435.member_11, _e435.member_12, _e435.member_13, _e435.member_14);
} else {
let _e2536 = type_12(vec3<f32>((_e435.member.x + (_e435.member_1.x * _e435.member_14)), (_e435.member.y + (_e435.member_1.y * _e435.member_14)), (_e435.member.z + (_e435.member_1.z * _e435.member_14))), _e435.member_1, _e435.member_2, _e435.member_3, _e435.member_4, _e435.member_5, _e435.member_6, _e435.member_7, _e435.member_8, _e435.member_9, _e435.member_10, _e435.member_11, _e435.member_12, _e435.member_13, _e435.member_14);
let _e2553 = type_12(_e2536.member, _e2536.member_1, _e2536.member_2, _e2536.member_3, _e2536.member_4, (_e435.member_5 + _e435.member_14), _e2536.member_6, _e2536.member_7, _e2536.member_8, _e2536.member_9, _e2536.member_10, _e2536.member_11, _e2536.member_12, _e2536.member_13, _e2536.member_14);
let _e2569 = type_12(_e2553.member, _e2553.member_1, _e2553.member_2, _e2553.member_3, _e2553.member_4, _e2553.member_5, _e2553.member_6, _e2553.member_7, _e2553.member_8, _e2553.member_9, _e2553.member_10, _e2553.member_11, _e2553.member_12, _e2553.member_13, (_e435.member_14 - _e435.member_14));
let _e2589 = type_12(_e2569.member, _e2569.member_1, _e2569.member_2, _e2569.member_3, _e2569.member_4, _e2569.member_5, _e2569.member_6, _e2569.member_7, _e2569.member_8, _e2569.member_9, (_e435.member_10 + select(0f, _e435.member_14, (_e435.member_8 == 0f))), _e2569.member_11, _e2569.member_12, _e2569.member_13, _e2569.member_14);
phi_1831_ = type_12(_e2589.member, _e2589.member_1, _e2589.member_2, _e2589.member_3, _e2589.member_4, _e2589.member_5, 3f, _e2589.member_7, _e2589.member_8, _e2589.member_9, _e2589.member_10, _e2589.member_11, _e2589.member_12, _e2589.member_13, _e2589.member_14);
}
let _e2621 = phi_1831_;
phi_2119_ = _e2621;
} else {
let _e2212 = type_12(vec3<f32>((_e435.member.x + (_e435.member_1.x * _e435.member_14)), (_e435.member.y + (_e435.member_1.y * _e435.member_14)), (_e435.member.z + (_e435.member_1.z * _e435.member_14))), _e435.member_1, _e435.member_2, _e435.member_3, _e435.member_4, _e435.member_5, _e435.member_6, _e435.member_7, _e435.member_8, _e435.member_9, _e435.member_10, _e435.member_11, _e435.member_12, _e435.member_13, _e435.member_14);
let _e2229 = type_12(_e2212.member, _e2212.member_1, _e2212.member_2, _e2212.member_3, _e2212.member_4, (_e435.member_5 + _e435.member_14), _e2212.member_6, _e2212.member_7, _e2212.member_8, _e2212.member_9, _e2212.member_10, _e2212.member_11, _e2212.member_12, _e2212.member_13, _e2212.member_14);
let _e2245 = type_12(_e2229.member, _e2229.member_1, _e2229.member_2, _e2229.member_3, _e2229.member_4, _e2229.member_5, _e2229.member_6, _e2229.member_7, _e2229.member_8, _e2229.member_9, _e2229.member_10, _e2229.member_11, _e2229.member_12, _e2229.member_13, (_e435.member_14 - _e435.member_14));
let _e2265 = type_12(_e2245.member, _e2245.member_1, _e2245.member_2, _e2245.member_3, _e2245.member_4, _e2245.member_5, _e2245.member_6, _e2245.member_7, _e2245.member_8, _e2245.member_9, (_e435.member_10 + select(0f, _e435.member_14, (_e435.member_8 == 0f))), _e2245.member_11, _e2245.member_12, _e2245.member_13, _e2245.member_14);
let _e2267 = local_13;
if (_e2267 != 16i) {
let _e2285 = type_12(_e2265.member, _e2265.member_1, _e2265.member_2, _e2265.member_3, _e2265.member_4, _e2265.member_5, _e2265.member_6, _e2265.member_7, _e2265.member_8, (_e435.member_9 + _e435.member_14), _e2265.member_10, _e2265.member_11, _e2265.member_12, _e2265.member_13, _e2265.member_14);
let _e2287 = local_14;
let _e2288 = (_e2287 * 4i);
let _e2289 = (_e2288 + 1i);
let _e2291 = (bitcast<i32>(_e99) - 1i);
let _e2293 = select(_e2291, _e2289, (_e2289 < _e2291));
let _e2299 = global_4.member[bitcast<u32>(select(0i, _e2293, (_e2293 > 0i)))];
let _e2301 = -((_e2299 * _e435.member_14));
let _e2303 = select(-87f, _e2301, (_e2301 > -87f));
let _e2305 = select(88f, _e2303, (_e2303 < 88f));
let _e2307 = ((_e2305 * 1.442695f) + 0.5f);
let _e2309 = select(-127f, _e2307, (_e2307 > -127f));
let _e2311 = select(128f, _e2309, (_e2309 < 128f));
let _e2318 = select(0i, select(select(i32(_e2311), i32(-2147483648), (_e2311 < -2147483600f)), 2147483647i, (_e2311 > 2147483500f)), (_e2311 == _e2311));
let _e2322 = (_e2318 - select(0i, 1i, (_e2311 < f32(_e2318))));
let _e2323 = f32(_e2322);
let _e2327 = ((_e2305 - (_e2323 * 0.6933594f)) - (_e2323 * -2.1219444e-4f));
let _e2351 = (_e2288 + 2i);
let _e2353 = select(_e2291, _e2351, (_e2351 < _e2291));
let _e2359 = global_4.member[bitcast<u32>(select(0i, _e2353, (_e2353 > 0i)))];
let _e2361 = -((_e2359 * _e435.member_14));
let _e2363 = select(-87f, _e2361, (_e2361 > -87f));
let _e2365 = select(88f, _e2363, (_e2363 < 88f));
let _e2367 = ((_e2365 * 1.442695f) + 0.5f);
let _e2369 = select(-127f, _e2367, (_e2367 > -127f));
let _e2371 = select(128f, _e2369, (_e2369 < 128f));
let _e2378 = select(0i, select(select(i32(_e2371), i32(-2147483648), (_e2371 < -2147483600f)), 2147483647i, (_e2371 > 2147483500f)), (_e2371 == _e2371));
let _e2382 = (_e2378 - select(0i, 1i, (_e2371 < f32(_e2378))));
let _e2383 = f32(_e2382);
let _e2387 = ((_e2365 - (_e2383 * 0.6933594f)) - (_e2383 * -2.1219444e-4f));
let _e2411 = (_e2288 + 3i);
let _e2413 = select(_e2291, _e2411, (_e2411 < _e2291));
let _e2419 = global_4.member[bitcast<u32>(select(0i, _e2413, (_e2413 > 0i)))];
let _e2421 = -((_e2419 * _e435.member_14));
let _e2423 = select(-87f, _e2421, (_e2421 > -87f));
let _e2425 = select(88f, _e2423, (_e2423 < 88f));
let _e2427 = ((_e2425 * 1.442695f) + 0.5f);
let _e2429 = select(-127f, _e2427, (_e2427 > -127f));
let _e2431 = select(128f, _e2429, (_e2429 < 128f));
let _e2438 = select(0i, select(select(i32(_e2431), i32(-2147483648), (_e2431 < -2147483600f)), 2147483647i, (_e2431 > 2147483500f)), (_e2431 == _e2431));
let _e2442 = (_e2438 - select(0i, 1i, (_e2431 < f32(_e2438))));
let _e2443 = f32(_e2442);
let _e2447 = ((_e2425 - (_e2443 * 0.6933594f)) - (_e2443 * -2.1219444e-4f));
phi_2117_ = type_12(_e2285.member, _e2285.member_1, vec3<f32>((_e435.member_2.x * ((1f + (_e2327 * (1f + (_e2327 * (0.5f + (_e2327 * (0.16666667f + (_e2327 * (0.041666668f + (_e2327 * (0.008333334f + (_e2327 * (0.001388889f + (_e2327 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2322 + 127i)) << bitcast<u32>(23i))))), (_e435.member_2.y * ((1f + (_e2387 * (1f + (_e2387 * (0.5f + (_e2387 * (0.16666667f + (_e2387 * (0.041666668f + (_e2387 * (0.008333334f + (_e2387 * (0.001388889f + (_e2387 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2382 + 127i)) << bitcast<u32>(23i))))), (_e435.member_2.z * ((1f + (_e2447 * (1f + (_e2447 * (0.5f + (_e2447 * (0.16666667f + (_e2447 * (0.041666668f + (_e2447 * (0.008333334f + (_e2447 * (0.001388889f + (_e2447 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2442 + 127i)) << bitcast<u32>(23i)))))), _e2285.member_3, _e2285.member_4, _e2285.member_5, _e2285.member_6, _e2285.member_7, _e2285.member_8, _e2285.member_9, _e2285.member_10, _e2285.member_11, _e2285.member_12, _e2285.member_13, _e2285.member_14);
} else {
phi_2117_ = _e2265;
}
let _e2488 = phi_2117_;
phi_2119_ = type_12(_e2488.member, _e2488.member_1, _e2488.member_2, _e2488.member_3, _e2488.member_4, _e2488.member_5, 3f, _e2488.member_7, _e2488.member_8, _e2488.member_9, _e2488.member_10, _e2488.member_11, _e2488.member_12, _e2488.member_13, _e2488.member_14);
}
let _e2623 = phi_2119_;
phi_4395_ = _e2623;
phi_4396_ = _e439;
} else {
phi_2121_ = 15i;
phi_2124_ = 16i;
loop {
let _e450 = phi_2121_;
let _e452 = phi_2124_;
local = _e452;
local_1 = _e452;
local_2 = _e452;
local_4 = _e452;
local_5 = _e452;
local_8 = _e452;
local_10 = _e452;
local_11 = _e452;
let _e453 = (_e450 >= 0i);
if _e453 {
phi_2122_ = (_e450 - 1i);
phi_2125_ = select(_e452, _e450, (((_e439 >> bitcast<u32>((_e450 & 31i))) & 1i) == 1i));
} else {
phi_2122_ = i32();
phi_2125_ = i32();
}
let _e462 = phi_2122_;
let _e464 = phi_2125_;
continue;
continuing {
phi_2121_ = _e462;
phi_2124_ = _e464;
break if !(_e453);
}
}
let _e466 = (_e435.member_13 * 19i);
let _e468 = (bitcast<i32>(_e97) - 1i);
let _e470 = select(_e468, _e466, (_e466 < _e468));
let _e476 = global_3.member[bitcast<u32>(select(0i, _e470, (_e470 > 0i)))];
let _e477 = (_e466 + 1i);
let _e479 = select(_e468, _e477, (_e477 < _e468));
let _e485 = global_3.member[bitcast<u32>(select(0i, _e479, (_e479 > 0i)))];
let _e486 = (_e466 + 2i);
let _e488 = select(_e468, _e486, (_e486 < _e468));
let _e494 = global_3.member[bitcast<u32>(select(0i, _e488, (_e488 > 0i)))];
let _e495 = (_e466 + 3i);
let _e497 = select(_e468, _e495, (_e495 < _e468));
let _e503 = global_3.member[bitcast<u32>(select(0i, _e497, (_e497 > 0i)))];
let _e504 = (_e466 + 4i);
let _e506 = select(_e468, _e504, (_e504 < _e468));
let _e512 = global_3.member[bitcast<u32>(select(0i, _e506, (_e506 > 0i)))];
let _e513 = (_e466 + 5i);
let _e515 = select(_e468, _e513, (_e513 < _e468));
let _e521 = global_3.member[bitcast<u32>(select(0i, _e515, (_e515 > 0i)))];
let _e522 = (_e466 + 6i);
let _e524 = select(_e468, _e522, (_e522 < _e468));
let _e530 = global_3.member[bitcast<u32>(select(0i, _e524, (_e524 > 0i)))];
let _e531 = (_e466 + 7i);
let _e533 = select(_e468, _e531, (_e531 < _e468));
let _e539 = global_3.member[bitcast<u32>(select(0i, _e533, (_e533 > 0i)))];
let _e540 = (_e466 + 8i);
let _e542 = select(_e468, _e540, (_e540 < _e468));
let _e548 = global_3.member[bitcast<u32>(select(0i, _e542, (_e542 > 0i)))];
let _e549 = (_e503 - _e476);
let _e550 = (_e512 - _e485);
let _e551 = (_e521 - _e494);
let _e552 = (_e530 - _e476);
let _e553 = (_e539 - _e485);
let _e554 = (_e548 - _e494);
let _e557 = ((_e550 * _e554) - (_e551 * _e553));
let _e560 = ((_e551 * _e552) - (_e549 * _e554));
let _e563 = ((_e549 * _e553) - (_e550 * _e552));
let _e568 = (((_e557 * _e557) + (_e560 * _e560)) + (_e563 * _e563));
let _e571 = sqrt(select(0f, _e568, (_e568 > 0f)));
let _e574 = (1f / select(1e-20f, _e571, (_e571 > 1e-20f)));
let _e575 = (_e557 * _e574);
let _e576 = (_e560 * _e574);
let _e577 = (_e563 * _e574);
let _e583 = bitcast<f32>((bitcast<u32>(_e435.member_1.x) & 2147483647u));
let _e587 = bitcast<f32>((bitcast<u32>(_e435.member_1.y) & 2147483647u));
let _e591 = bitcast<f32>((bitcast<u32>(_e435.member_1.z) & 2147483647u));
let _e594 = ((_e583 >= _e587) && (_e583 >= _e591));
let _e597 = (!(_e594) && (_e587 >= _e591));
let _e604 = (1f / select(select(_e435.member_1.z, _e435.member_1.y, _e597), _e435.member_1.x, _e594));
let _e605 = (select(select(_e435.member_1.x, _e435.member_1.z, _e597), _e435.member_1.y, _e594) * _e604);
let _e606 = (select(select(_e435.member_1.y, _e435.member_1.x, _e597), _e435.member_1.z, _e594) * _e604);
let _e608 = (_e476 - _e435.member.x);
let _e610 = (_e485 - _e435.member.y);
let _e612 = (_e494 - _e435.member.z);
let _e618 = select(select(_e612, _e610, _e597), _e608, _e594);
let _e620 = (select(select(_e608, _e612, _e597), _e610, _e594) - (_e605 * _e618));
let _e622 = (select(select(_e610, _e608, _e597), _e612, _e594) - (_e606 * _e618));
let _e623 = (_e503 - _e435.member.x);
let _e624 = (_e512 - _e435.member.y);
let _e625 = (_e521 - _e435.member.z);
let _e631 = select(select(_e625, _e624, _e597), _e623, _e594);
let _e633 = (select(select(_e623, _e625, _e597), _e624, _e594) - (_e605 * _e631));
let _e635 = (select(select(_e624, _e623, _e597), _e625, _e594) - (_e606 * _e631));
let _e636 = (_e530 - _e435.member.x);
let _e637 = (_e539 - _e435.member.y);
let _e638 = (_e548 - _e435.member.z);
let _e644 = select(select(_e638, _e637, _e597), _e636, _e594);
let _e646 = (select(select(_e636, _e638, _e597), _e637, _e594) - (_e605 * _e644));
let _e648 = (select(select(_e637, _e636, _e597), _e638, _e594) - (_e606 * _e644));
let _e651 = ((_e646 * _e635) - (_e648 * _e633));
let _e654 = ((_e620 * _e648) - (_e622 * _e646));
let _e657 = ((_e633 * _e622) - (_e635 * _e620));
let _e659 = ((_e651 + _e654) + _e657);
let _e662 = (1f / select(_e659, 1f, (_e659 == 0f)));
let _e663 = (_e651 * _e662);
let _e664 = (_e654 * _e662);
let _e665 = (_e657 * _e662);
let _e666 = (_e466 + 9i);
let _e668 = select(_e468, _e666, (_e666 < _e468));
let _e674 = global_3.member[bitcast<u32>(select(0i, _e668, (_e668 > 0i)))];
let _e675 = (_e466 + 10i);
let _e677 = select(_e468, _e675, (_e675 < _e468));
let _e683 = global_3.member[bitcast<u32>(select(0i, _e677, (_e677 > 0i)))];
let _e684 = (_e466 + 11i);
let _e686 = select(_e468, _e684, (_e684 < _e468));
let _e692 = global_3.member[bitcast<u32>(select(0i, _e686, (_e686 > 0i)))];
let _e696 = (_e466 + 12i);
let _e698 = select(_e468, _e696, (_e696 < _e468));
let _e704 = global_3.member[bitcast<u32>(select(0i, _e698, (_e698 > 0i)))];
let _e705 = (_e466 + 13i);
let _e707 = select(_e468, _e705, (_e705 < _e468));
let _e713 = global_3.member[bitcast<u32>(select(0i, _e707, (_e707 > 0i)))];
let _e714 = (_e466 + 14i);
let _e716 = select(_e468, _e714, (_e714 < _e468));
let _e722 = global_3.member[bitcast<u32>(select(0i, _e716, (_e716 > 0i)))];
let _e729 = (_e466 + 15i);
let _e731 = select(_e468, _e729, (_e729 < _e468));
let _e737 = global_3.member[bitcast<u32>(select(0i, _e731, (_e731 > 0i)))];
let _e738 = (_e466 + 16i);
let _e740 = select(_e468, _e738, (_e738 < _e468));
let _e746 = global_3.member[bitcast<u32>(select(0i, _e740, (_e740 > 0i)))];
let _e747 = (_e466 + 17i);
let _e749 = select(_e468, _e747, (_e747 < _e468));
let _e755 = global_3.member[bitcast<u32>(select(0i, _e749, (_e749 > 0i)))];
let _e759 = (((_e674 * _e663) + (_e704 * _e664)) + (_e737 * _e665));
let _e760 = (((_e683 * _e663) + (_e713 * _e664)) + (_e746 * _e665));
let _e761 = (((_e692 * _e663) + (_e722 * _e664)) + (_e755 * _e665));
let _e766 = (((_e759 * _e759) + (_e760 * _e760)) + (_e761 * _e761));
let _e769 = sqrt(select(0f, _e766, (_e766 > 0f)));
let _e772 = (1f / select(1e-20f, _e769, (_e769 > 1e-20f)));
let _e773 = (_e759 * _e772);
let _e774 = (_e760 * _e772);
let _e775 = (_e761 * _e772);
let _e787 = (((((_e773 * _e435.member_1.x) + (_e774 * _e435.member_1.y)) + (_e775 * _e435.member_1.z)) * (((_e575 * _e435.member_1.x) + (_e576 * _e435.member_1.y)) + (_e577 * _e435.member_1.z))) > 0f);
let _e788 = select(_e575, _e773, _e787);
let _e789 = select(_e576, _e774, _e787);
let _e790 = select(_e577, _e775, _e787);
let _e792 = (_e466 + 18i);
let _e794 = select(_e468, _e792, (_e792 < _e468));
let _e800 = global_3.member[bitcast<u32>(select(0i, _e794, (_e794 > 0i)))];
let _e807 = select(0i, select(select(i32(_e800), i32(-2147483648), (_e800 < -2147483600f)), 2147483647i, (_e800 > 2147483500f)), (_e800 == _e800));
let _e808 = (_e807 * 4i);
let _e810 = (bitcast<i32>(_e99) - 1i);
let _e812 = select(_e810, _e808, (_e808 < _e810));
let _e818 = global_4.member[bitcast<u32>(select(0i, _e812, (_e812 > 0i)))];
if (select(_e818, 1f, (_e807 == 16i)) == 0f) {
let _e1864 = type_12(vec3<f32>((_e435.member.x + (_e435.member_1.x * _e435.member_14)), (_e435.member.y + (_e435.member_1.y * _e435.member_14)), (_e435.member.z + (_e435.member_1.z * _e435.member_14))), _e435.member_1, _e435.member_2, _e435.member_3, _e435.member_4, _e435.member_5, _e435.member_6, _e435.member_7, _e435.member_8, _e435.member_9, _e435.member_10, _e435.member_11, _e435.member_12, _e435.member_13, _e435.member_14);
let _e1881 = type_12(_e1864.member, _e1864.member_1, _e1864.member_2, _e1864.member_3, _e1864.member_4, (_e435.member_5 + _e435.member_14), _e1864.member_6, _e1864.member_7, _e1864.member_8, _e1864.member_9, _e1864.member_10, _e1864.member_11, _e1864.member_12, _e1864.member_13, _e1864.member_14);
let _e1897 = type_12(_e1881.member, _e1881.member_1, _e1881.member_2, _e1881.member_3, _e1881.member_4, _e1881.member_5, _e1881.member_6, _e1881.member_7, _e1881.member_8, _e1881.member_9, _e1881.member_10, _e1881.member_11, _e1881.member_12, _e1881.member_13, (_e435.member_14 - _e435.member_14));
let _e1917 = type_12(_e1897.member, _e1897.member_1, _e1897.member_2, _e1897.member_3, _e1897.member_4, _e1897.member_5, _e1897.member_6, _e1897.member_7, _e1897.member_8, _e1897.member_9, (_e435.member_10 + select(0f, _e435.member_14, (_e435.member_8 == 0f))), _e1897.member_11, _e1897.member_12, _e1897.member_13, _e1897.member_14);
let _e1919 = local_10;
if (_e1919 != 16i) {
let _e1937 = type_12(_e1917.member, _e1917.member_1, _e1917.member_2, _e1917.member_3, _e1917.member_4, _e1917.member_5, _e1917.member_6, _e1917.member_7, _e1917.member_8, (_e435.member_9 + _e435.member_14), _e1917.member_10, _e1917.member_11, _e1917.member_12, _e1917.member_13, _e1917.member_14);
let _e1939 = local_11;
let _e1940 = (_e1939 * 4i);
let _e1941 = (_e1940 + 1i);
let _e1943 = select(_e810, _e1941, (_e1941 < _e810));
let _e1949 = global_4.member[bitcast<u32>(select(0i, _e1943, (_e1943 > 0i)))];
let _e1951 = -((_e1949 * _e435.member_14));
let _e1953 = select(-87f, _e1951, (_e1951 > -87f));
let _e1955 = select(88f, _e1953, (_e1953 < 88f));
let _e1957 = ((_e1955 * 1.442695f) + 0.5f);
let _e1959 = select(-127f, _e1957, (_e1957 > -127f));
let _e1961 = select(128f, _e1959, (_e1959 < 128f));
let _e1968 = select(0i, select(select(i32(_e1961), i32(-2147483648), (_e1961 < -2147483600f)), 2147483647i, (_e1961 > 2147483500f)), (_e1961 == _e1961));
let _e1972 = (_e1968 - select(0i, 1i, (_e1961 < f32(_e1968))));
let _e1973 = f32(_e1972);
let _e1977 = ((_e1955 - (_e1973 * 0.6933594f)) - (_e1973 * -2.1219444e-4f));
let _e2001 = (_e1940 + 2i);
let _e2003 = select(_e810, _e2001, (_e2001 < _e810));
let _e2009 = global_4.member[bitcast<u32>(select(0i, _e2003, (_e2003 > 0i)))];
let _e2011 = -((_e2009 * _e435.member_14));
let _e2013 = select(-87f, _e2011, (_e2011 > -87f));
let _e2015 = select(88f, _e2013, (_e2013 < 88f));
let _e2017 = ((_e2015 * 1.442695f) + 0.5f);
let _e2019 = select(-127f, _e2017, (_e2017 > -127f));
let _e2021 = select(128f, _e2019, (_e2019 < 128f));
let _e2028 = select(0i, select(select(i32(_e2021), i32(-2147483648), (_e2021 < -2147483600f)), 2147483647i, (_e2021 > 2147483500f)), (_e2021 == _e2021));
let _e2032 = (_e2028 - select(0i, 1i, (_e2021 < f32(_e2028))));
let _e2033 = f32(_e2032);
let _e2037 = ((_e2015 - (_e2033 * 0.6933594f)) - (_e2033 * -2.1219444e-4f));
let _e2061 = (_e1940 + 3i);
let _e2063 = select(_e810, _e2061, (_e2061 < _e810));
let _e2069 = global_4.member[bitcast<u32>(select(0i, _e2063, (_e2063 > 0i)))];
let _e2071 = -((_e2069 * _e435.member_14));
let _e2073 = select(-87f, _e2071, (_e2071 > -87f));
let _e2075 = select(88f, _e2073, (_e2073 < 88f));
let _e2077 = ((_e2075 * 1.442695f) + 0.5f);
let _e2079 = select(-127f, _e2077, (_e2077 > -127f));
let _e2081 = select(128f, _e2079, (_e2079 < 128f));
let _e2088 = select(0i, select(select(i32(_e2081), i32(-2147483648), (_e2081 < -2147483600f)), 2147483647i, (_e2081 > 2147483500f)), (_e2081 == _e2081));
let _e2092 = (_e2088 - select(0i, 1i, (_e2081 < f32(_e2088))));
let _e2093 = f32(_e2092);
let _e2097 = ((_e2075 - (_e2093 * 0.6933594f)) - (_e2093 * -2.1219444e-4f));
phi_3216_ = type_12(_e1937.member, _e1937.member_1, vec3<f32>((_e435.member_2.x * ((1f + (_e1977 * (1f + (_e1977 * (0.5f + (_e1977 * (0.16666667f + (_e1977 * (0.041666668f + (_e1977 * (0.008333334f + (_e1977 * (0.001388889f + (_e1977 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1972 + 127i)) << bitcast<u32>(23i))))), (_e435.member_2.y * ((1f + (_e2037 * (1f + (_e2037 * (0.5f + (_e2037 * (0.16666667f + (_e2037 * (0.041666668f + (_e2037 * (0.008333334f + (_e2037 * (0.001388889f + (_e2037 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2032 + 127i)) << bitcast<u32>(23i))))), (_e435.member_2.z * ((1f + (_e2097 * (1f + (_e2097 * (0.5f + (_e2097 * (0.16666667f + (_e2097 * (0.041666668f + (_e2097 * (0.008333334f + (_e2097 * (0.001388889f + (_e2097 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2092 + 127i)) << bitcast<u32>(23i)))))), _e1937.member_3, _e1937.member_4, _e1937.member_5, _e1937.member_6, _e1937.member_7, _e1937.member_8, _e1937.member_9, _e1937.member_10, _e1937.member_11, _e1937.member_12, _e1937.member_13, _e1937.member_14);
} else {
phi_3216_ = _e1917;
}
let _e2138 = phi_3216_;
phi_4393_ = type_12(_e2138.member, _e2138.member_1, _e2138.member_2, _e2138.member_3, _e2138.member_4, _e2138.member_5, 3f, _e2138.member_7, _e2138.member_8, _e2138.member_9, _e2138.member_10, _e2138.member_11, _e2138.member_12, _e2138.member_13, _e2138.member_14);
phi_4394_ = _e439;
} else {
let _e824 = (1i << bitcast<u32>((_e807 & 31i)));
if ((((_e435.member_1.x * _e575) + (_e435.member_1.y * _e576)) + (_e435.member_1.z * _e577)) < 0f) {
phi_3236_ = (_e439 | _e824);
} else {
phi_3236_ = (_e439 & ~(_e824));
}
let _e835 = phi_3236_;
phi_3238_ = 15i;
phi_3241_ = 16i;
loop {
let _e837 = phi_3238_;
let _e839 = phi_3241_;
local_3 = _e839;
local_6 = _e839;
local_7 = _e839;
local_9 = _e839;
let _e840 = (_e837 >= 0i);
if _e840 {
phi_3239_ = (_e837 - 1i);
phi_3242_ = select(_e839, _e837, (((_e835 >> bitcast<u32>((_e837 & 31i))) & 1i) == 1i));
} else {
phi_3239_ = i32();
phi_3242_ = i32();
}
let _e849 = phi_3239_;
let _e851 = phi_3242_;
continue;
continuing {
phi_3238_ = _e849;
phi_3241_ = _e851;
break if !(_e840);
}
}
let _e881 = type_12(vec3<f32>((_e435.member.x + (_e435.member_1.x * _e435.member_14)), (_e435.member.y + (_e435.member_1.y * _e435.member_14)), (_e435.member.z + (_e435.member_1.z * _e435.member_14))), _e435.member_1, _e435.member_2, _e435.member_3, _e435.member_4, _e435.member_5, _e435.member_6, _e435.member_7, _e435.member_8, _e435.member_9, _e435.member_10, _e435.member_11, _e435.member_12, _e435.member_13, _e435.member_14);
let _e898 = type_12(_e881.member, _e881.member_1, _e881.member_2, _e881.member_3, _e881.member_4, (_e435.member_5 + _e435.member_14), _e881.member_6, _e881.member_7, _e881.member_8, _e881.member_9, _e881.member_10, _e881.member_11, _e881.member_12, _e881.member_13, _e881.member_14);
let _e918 = type_12(_e898.member, _e898.member_1, _e898.member_2, _e898.member_3, _e898.member_4, _e898.member_5, _e898.member_6, _e898.member_7, _e898.member_8, _e898.member_9, (_e435.member_10 + select(0f, _e435.member_14, (_e435.member_8 == 0f))), _e898.member_11, _e898.member_12, _e898.member_13, _e898.member_14);
let _e920 = local;
if (_e920 != 16i) {
let _e938 = type_12(_e918.member, _e918.member_1, _e918.member_2, _e918.member_3, _e918.member_4, _e918.member_5, _e918.member_6, _e918.member_7, _e918.member_8, (_e435.member_9 + _e435.member_14), _e918.member_10, _e918.member_11, _e918.member_12, _e918.member_13, _e918.member_14);
let _e940 = local_1;
let _e941 = (_e940 * 4i);
let _e942 = (_e941 + 1i);
let _e944 = select(_e810, _e942, (_e942 < _e810));
let _e950 = global_4.member[bitcast<u32>(select(0i, _e944, (_e944 > 0i)))];
let _e952 = -((_e950 * _e435.member_14));
let _e954 = select(-87f, _e952, (_e952 > -87f));
let _e956 = select(88f, _e954, (_e954 < 88f));
let _e958 = ((_e956 * 1.442695f) + 0.5f);
let _e960 = select(-127f, _e958, (_e958 > -127f));
let _e962 = select(128f, _e960, (_e960 < 128f));
let _e969 = select(0i, select(select(i32(_e962), i32(-2147483648), (_e962 < -2147483600f)), 2147483647i, (_e962 > 2147483500f)), (_e962 == _e962));
let _e973 = (_e969 - select(0i, 1i, (_e962 < f32(_e969))));
let _e974 = f32(_e973);
let _e978 = ((_e956 - (_e974 * 0.6933594f)) - (_e974 * -2.1219444e-4f));
let _e1002 = (_e941 + 2i);
let _e1004 = select(_e810, _e1002, (_e1002 < _e810));
let _e1010 = global_4.member[bitcast<u32>(select(0i, _e1004, (_e1004 > 0i)))];
let _e1012 = -((_e1010 * _e435.member_14));
let _e1014 = select(-87f, _e1012, (_e1012 > -87f));
let _e1016 = select(88f, _e1014, (_e1014 < 88f));
let _e1018 = ((_e1016 * 1.442695f) + 0.5f);
let _e1020 = select(-127f, _e1018, (_e1018 > -127f));
let _e1022 = select(128f, _e1020, (_e1020 < 128f));
let _e1029 = select(0i, select(select(i32(_e1022), i32(-2147483648), (_e1022 < -2147483600f)), 2147483647i, (_e1022 > 2147483500f)), (_e1022 == _e1022));
let _e1033 = (_e1029 - select(0i, 1i, (_e1022 < f32(_e1029))));
let _e1034 = f32(_e1033);
let _e1038 = ((_e1016 - (_e1034 * 0.6933594f)) - (_e1034 * -2.1219444e-4f));
let _e1062 = (_e941 + 3i);
let _e1064 = select(_e810, _e1062, (_e1062 < _e810));
let _e1070 = global_4.member[bitcast<u32>(select(0i, _e1064, (_e1064 > 0i)))];
let _e1072 = -((_e1070 * _e435.member_14));
let _e1074 = select(-87f, _e1072, (_e1072 > -87f));
let _e1076 = select(88f, _e1074, (_e1074 < 88f));
let _e1078 = ((_e1076 * 1.442695f) + 0.5f);
let _e1080 = select(-127f, _e1078, (_e1078 > -127f));
let _e1082 = select(128f, _e1080, (_e1080 < 128f));
let _e1089 = select(0i, select(select(i32(_e1082), i32(-2147483648), (_e1082 < -2147483600f)), 2147483647i, (_e1082 > 2147483500f)), (_e1082 == _e1082));
let _e1093 = (_e1089 - select(0i, 1i, (_e1082 < f32(_e1089))));
let _e1094 = f32(_e1093);
let _e1098 = ((_e1076 - (_e1094 * 0.6933594f)) - (_e1094 * -2.1219444e-4f));
phi_3543_ = type_12(_e938.member, _e938.member_1, vec3<f32>((_e435.member_2.x * ((1f + (_e978 * (1f + (_e978 * (0.5f + (_e978 * (0.16666667f + (_e978 * (0.041666668f + (_e978 * (0.008333334f + (_e978 * (0.001388889f + (_e978 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e973 + 127i)) << bitcast<u32>(23i))))), (_e435.member_2.y * ((1f + (_e1038 * (1f + (_e1038 * (0.5f + (_e1038 * (0.16666667f + (_e1038 * (0.041666668f + (_e1038 * (0.008333334f + (_e1038 * (0.001388889f + (_e1038 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1033 + 127i)) << bitcast<u32>(23i))))), (_e435.member_2.z * ((1f + (_e1098 * (1f + (_e1098 * (0.5f + (_e1098 * (0.16666667f + (_e1098 * (0.041666668f + (_e1098 * (0.008333334f + (_e1098 * (0.001388889f + (_e1098 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1093 + 127i)) << bitcast<u32>(23i)))))), _e938.member_3, _e938.member_4, _e938.member_5, _e938.member_6, _e938.member_7, _e938.member_8, _e938.member_9, _e938.member_10, _e938.member_11, _e938.member_12, _e938.member_13, _e938.member_14);
} else {
phi_3543_ = _e918;
}
let _e1139 = phi_3543_;
let _e1141 = local_2;
let _e1143 = local_3;
if (_e1141 == _e1143) {
let _e1715 = global_1.member.member_17;
let _e1728 = ((((_e1715.member * _e1139.member.x) + (_e1715.member_1 * _e1139.member.y)) + (_e1715.member_2 * _e1139.member.z)) + _e1715.member_3);
let _e1737 = -((((_e1715.member * _e1139.member_1.x) + (_e1715.member_1 * _e1139.member_1.y)) + (_e1715.member_2 * _e1139.member_1.z)));
let _e1739 = (_e1737 > 1e-9f);
let _e1743 = ((_e1728 / select(1e-9f, _e1737, _e1739)) - 0.015625f);
let _e1746 = select(1e30f, select(0f, _e1743, (_e1743 > 0f)), ((_e1728 > 0f) && _e1739));
let _e1749 = global_1.member.member_19;
let _e1759 = ((((_e1749.member * _e1139.member.x) + (_e1749.member_1 * _e1139.member.y)) + (_e1749.member_2 * _e1139.member.z)) + _e1749.member_3);
let _e1765 = -((((_e1749.member * _e1139.member_1.x) + (_e1749.member_1 * _e1139.member_1.y)) + (_e1749.member_2 * _e1139.member_1.z)));
let _e1767 = (_e1765 > 1e-9f);
let _e1771 = ((_e1759 / select(1e-9f, _e1765, _e1767)) - 0.015625f);
let _e1774 = select(1e30f, select(0f, _e1771, (_e1771 > 0f)), ((_e1759 > 0f) && _e1767));
let _e1778 = (_e1774 < _e1746);
let _e1796 = type_12(_e1139.member, _e1139.member_1, _e1139.member_2, _e1139.member_3, _e1139.member_4, _e1139.member_5, _e1139.member_6, _e1139.member_7, _e1139.member_8, _e1139.member_9, _e1139.member_10, _e1139.member_11, 0i, _e1139.member_13, _e1139.member_14);
let _e1811 = type_12(_e1796.member, _e1796.member_1, _e1796.member_2, _e1796.member_3, _e1796.member_4, _e1796.member_5, _e1796.member_6, _e1796.member_7, _e1796.member_8, _e1796.member_9, _e1796.member_10, _e1796.member_11, _e1796.member_12, select(select(-2i, -3i, _e1778), -1i, ((_e1746 >= 1e30f) && (_e1774 >= 1e30f))), _e1796.member_14);
phi_4385_ = type_12(_e1811.member, _e1811.member_1, _e1811.member_2, _e1811.member_3, _e1811.member_4, _e1811.member_5, _e1811.member_6, _e1811.member_7, _e1811.member_8, _e1811.member_9, _e1811.member_10, _e1811.member_11, _e1811.member_12, _e1811.member_13, select(_e1746, _e1774, _e1778));
phi_4386_ = type_12();
phi_4387_ = true;
} else {
let _e1147 = local_4;
let _e1148 = (_e1147 * 4i);
let _e1150 = select(_e810, _e1148, (_e1148 < _e810));
let _e1156 = global_4.member[bitcast<u32>(select(0i, _e1150, (_e1150 > 0i)))];
let _e1158 = local_5;
let _e1160 = select(_e1156, 1f, (_e1158 == 16i));
let _e1162 = local_6;
let _e1163 = (_e1162 * 4i);
let _e1165 = select(_e810, _e1163, (_e1163 < _e810));
let _e1171 = global_4.member[bitcast<u32>(select(0i, _e1165, (_e1165 > 0i)))];
let _e1173 = local_7;
let _e1175 = select(_e1171, 1f, (_e1173 == 16i));
let _e1185 = select(1f, -1f, ((((_e1139.member_1.x * _e788) + (_e1139.member_1.y * _e789)) + (_e1139.member_1.z * _e790)) > 0f));
let _e1186 = (_e788 * _e1185);
let _e1187 = (_e789 * _e1185);
let _e1188 = (_e790 * _e1185);
let _e1194 = -((((_e1139.member_1.x * _e1186) + (_e1139.member_1.y * _e1187)) + (_e1139.member_1.z * _e1188)));
let _e1196 = select(0f, _e1194, (_e1194 > 0f));
let _e1197 = (_e1160 / _e1175);
let _e1199 = (_e1196 * _e1196);
let _e1202 = (1f - ((_e1197 * _e1197) * (1f - _e1199)));
let _e1203 = (_e1202 <= 0f);
let _e1211 = ((_e1197 * _e1196) - sqrt(select(0f, _e1202, (_e1202 > 0f))));
let _e1218 = (2f * _e1196);
let _e1225 = select(((_e1139.member_1.x * _e1197) + (_e1186 * _e1211)), (_e1139.member_1.x + (_e1186 * _e1218)), _e1203);
let _e1226 = select(((_e1139.member_1.y * _e1197) + (_e1187 * _e1211)), (_e1139.member_1.y + (_e1187 * _e1218)), _e1203);
let _e1227 = select(((_e1139.member_1.z * _e1197) + (_e1188 * _e1211)), (_e1139.member_1.z + (_e1188 * _e1218)), _e1203);
let _e1232 = (((_e1225 * _e1225) + (_e1226 * _e1226)) + (_e1227 * _e1227));
let _e1235 = sqrt(select(0f, _e1232, (_e1232 > 0f)));
let _e1238 = (1f / select(1e-20f, _e1235, (_e1235 > 1e-20f)));
let _e1243 = (_e1175 / _e1160);
let _e1246 = (((_e1243 * _e1243) - 1f) + _e1199);
let _e1249 = sqrt(select(0f, _e1246, (_e1246 > 0f)));
let _e1250 = (_e1249 - _e1196);
let _e1251 = (_e1249 + _e1196);
let _e1254 = (_e1250 / select(1e-6f, _e1251, (_e1251 > 1e-6f)));
let _e1258 = ((_e1196 * _e1250) + 1f);
let _e1261 = (((_e1196 * _e1251) - 1f) / select(1e-6f, _e1258, (_e1258 > 1e-6f)));
let _e1276 = global_1.member.member[3u];
let _e1279 = select(0f, select(select((((0.5f * _e1254) * _e1254) * (1f + (_e1261 * _e1261))), 1f, (_e1246 <= 0f)), 0f, (_e1160 == _e1175)), ((_e1276 & 1u) != 0u));
if (_e1139.member_8 == 0f) {
let _e1294 = type_12(_e1139.member, _e1139.member_1, _e1139.member_2, vec3<f32>(_e788, _e789, _e790), _e1139.member_4, _e1139.member_5, _e1139.member_6, _e1139.member_7, _e1139.member_8, _e1139.member_9, _e1139.member_10, _e1139.member_11, _e1139.member_12, _e1139.member_13, _e1139.member_14);
phi_3872_ = type_12(_e1294.member, _e1294.member_1, _e1294.member_2, _e1294.member_3, _e1294.member_4, _e1294.member_5, _e1294.member_6, _e1294.member_7, _e1294.member_8, _e1294.member_9, _e1294.member_10, _e1279, _e1294.member_12, _e1294.member_13, _e1294.member_14);
} else {
phi_3872_ = _e1139;
}
let _e1311 = phi_3872_;
let _e1313 = (_e1311.member_8 + 1f);
let _e1328 = type_12(_e1311.member, _e1311.member_1, _e1311.member_2, _e1311.member_3, _e1311.member_4, _e1311.member_5, _e1311.member_6, _e1311.member_7, _e1313, _e1311.member_9, _e1311.member_10, _e1311.member_11, _e1311.member_12, _e1311.member_13, _e1311.member_14);
let _e1331 = ((_e400 == 0u) && (_e1313 >= 2f));
if (_e1203 && _e1331) {
let _e1356 = (((_e1311.member_1.x * _e788) + (_e1311.member_1.y * _e789)) + (_e1311.member_1.z * _e790));
let _e1360 = (_e1311.member_1.x - (_e788 * _e1356));
let _e1361 = (_e1311.member_1.y - (_e789 * _e1356));
let _e1362 = (_e1311.member_1.z - (_e790 * _e1356));
let _e1367 = (((_e1360 * _e1360) + (_e1361 * _e1361)) + (_e1362 * _e1362));
let _e1370 = sqrt(select(0f, _e1367, (_e1367 > 0f)));
let _e1373 = (1f / select(1e-20f, _e1370, (_e1370 > 1e-20f)));
phi_3925_ = type_12(_e1328.member, vec3<f32>((_e1360 * _e1373), (_e1361 * _e1373), (_e1362 * _e1373)), _e1328.member_2, _e1328.member_3, _e1328.member_4, _e1328.member_5, _e1328.member_6, _e1328.member_7, _e1328.member_8, _e1328.member_9, _e1328.member_10, _e1328.member_11, _e1328.member_12, _e1328.member_13, _e1328.member_14);
} else {
phi_3925_ = type_12(_e1328.member, vec3<f32>((_e1225 * _e1238), (_e1226 * _e1238), (_e1227 * _e1238)), _e1328.member_2, _e1328.member_3, _e1328.member_4, _e1328.member_5, _e1328.member_6, _e1328.member_7, _e1328.member_8, _e1328.member_9, _e1328.member_10, _e1328.member_11, _e1328.member_12, _e1328.member_13, _e1328.member_14);
}
let _e1394 = phi_3925_;
if _e1203 {
phi_3939_ = _e1394;
} else {
let _e1395 = (1f - _e1279);
phi_3939_ = type_12(_e1394.member, _e1394.member_1, vec3<f32>((_e1394.member_2.x * _e1395), (_e1394.member_2.y * _e1395), (_e1394.member_2.z * _e1395)), _e1394.member_3, _e1394.member_4, _e1394.member_5, _e1394.member_6, _e1394.member_7, _e1394.member_8, _e1394.member_9, _e1394.member_10, _e1394.member_11, _e1394.member_12, _e1394.member_13, _e1394.member_14);
}
let _e1422 = phi_3939_;
let _e1427 = global_1.member.member_17;
let _e1440 = ((((_e1427.member * _e1422.member.x) + (_e1427.member_1 * _e1422.member.y)) + (_e1427.member_2 * _e1422.member.z)) + _e1427.member_3);
let _e1449 = -((((_e1427.member * _e1422.member_1.x) + (_e1427.member_1 * _e1422.member_1.y)) + (_e1427.member_2 * _e1422.member_1.z)));
let _e1451 = (_e1449 > 1e-9f);
let _e1455 = ((_e1440 / select(1e-9f, _e1449, _e1451)) - 0.015625f);
let _e1458 = select(1e30f, select(0f, _e1455, (_e1455 > 0f)), ((_e1440 > 0f) && _e1451));
let _e1461 = global_1.member.member_19;
let _e1471 = ((((_e1461.member * _e1422.member.x) + (_e1461.member_1 * _e1422.member.y)) + (_e1461.member_2 * _e1422.member.z)) + _e1461.member_3);
let _e1477 = -((((_e1461.member * _e1422.member_1.x) + (_e1461.member_1 * _e1422.member_1.y)) + (_e1461.member_2 * _e1422.member_1.z)));
let _e1479 = (_e1477 > 1e-9f);
let _e1483 = ((_e1471 / select(1e-9f, _e1477, _e1479)) - 0.015625f);
let _e1486 = select(1e30f, select(0f, _e1483, (_e1483 > 0f)), ((_e1471 > 0f) && _e1479));
let _e1490 = (_e1486 < _e1458);
let _e1492 = select(select(-2i, -3i, _e1490), -1i, ((_e1458 >= 1e30f) && (_e1486 >= 1e30f)));
let _e1493 = select(_e1458, _e1486, _e1490);
let _e1508 = type_12(_e1422.member, _e1422.member_1, _e1422.member_2, _e1422.member_3, _e1422.member_4, _e1422.member_5, _e1422.member_6, _e1422.member_7, _e1422.member_8, _e1422.member_9, _e1422.member_10, _e1422.member_11, 0i, _e1422.member_13, _e1422.member_14);
let _e1523 = type_12(_e1508.member, _e1508.member_1, _e1508.member_2, _e1508.member_3, _e1508.member_4, _e1508.member_5, _e1508.member_6, _e1508.member_7, _e1508.member_8, _e1508.member_9, _e1508.member_10, _e1508.member_11, _e1508.member_12, _e1492, _e1508.member_14);
let _e1538 = type_12(_e1523.member, _e1523.member_1, _e1523.member_2, _e1523.member_3, _e1523.member_4, _e1523.member_5, _e1523.member_6, _e1523.member_7, _e1523.member_8, _e1523.member_9, _e1523.member_10, _e1523.member_11, _e1523.member_12, _e1523.member_13, _e1493);
let _e1540 = local_8;
let _e1542 = local_9;
let _e1545 = ((_e1276 & 2u) != 0u);
if (_e1331 && !(_e1545)) {
if (_e1492 == -1i) {
phi_4358_ = type_12(_e1538.member, _e1538.member_1, _e1538.member_2, _e1538.member_3, _e1538.member_4, _e1538.member_5, 1f, _e1538.member_7, _e1538.member_8, _e1538.member_9, _e1538.member_10, _e1538.member_11, _e1538.member_12, _e1538.member_13, _e1538.member_14);
} else {
let _e1622 = type_12(vec3<f32>((_e1422.member.x + (_e1422.member_1.x * _e1493)), (_e1422.member.y + (_e1422.member_1.y * _e1493)), (_e1422.member.z + (_e1422.member_1.z * _e1493))), _e1538.member_1, _e1538.member_2, _e1538.member_3, _e1538.member_4, _e1538.member_5, _e1538.member_6, _e1538.member_7, _e1538.member_8, _e1538.member_9, _e1538.member_10, _e1538.member_11, _e1538.member_12, _e1538.member_13, _e1538.member_14);
let _e1639 = type_12(_e1622.member, _e1622.member_1, _e1622.member_2, _e1622.member_3, _e1622.member_4, (_e1422.member_5 + _e1493), _e1622.member_6, _e1622.member_7, _e1622.member_8, _e1622.member_9, _e1622.member_10, _e1622.member_11, _e1622.member_12, _e1622.member_13, _e1622.member_14);
let _e1655 = type_12(_e1639.member, _e1639.member_1, _e1639.member_2, _e1639.member_3, _e1639.member_4, _e1639.member_5, _e1639.member_6, _e1639.member_7, _e1639.member_8, _e1639.member_9, _e1639.member_10, _e1639.member_11, _e1639.member_12, _e1639.member_13, (_e1493 - _e1493));
let _e1675 = type_12(_e1655.member, _e1655.member_1, _e1655.member_2, _e1655.member_3, _e1655.member_4, _e1655.member_5, _e1655.member_6, _e1655.member_7, _e1655.member_8, _e1655.member_9, (_e1422.member_10 + select(0f, _e1493, (_e1422.member_8 == 0f))), _e1655.member_11, _e1655.member_12, _e1655.member_13, _e1655.member_14);
phi_4358_ = type_12(_e1675.member, _e1675.member_1, _e1675.member_2, _e1675.member_3, _e1675.member_4, _e1675.member_5, 3f, _e1675.member_7, _e1675.member_8, _e1675.member_9, _e1675.member_10, _e1675.member_11, _e1675.member_12, _e1675.member_13, _e1675.member_14);
}
let _e1707 = phi_4358_;
phi_4380_ = _e1707;
} else {
let _e1553 = global_1.member.member_2[3u];
if ((!(_e1331) && (_e1422.member_8 >= f32(bitcast<i32>(_e1553)))) && (select(_e1542, _e1540, _e1203) != 16i)) {
phi_4379_ = type_12(_e1538.member, _e1538.member_1, _e1538.member_2, _e1538.member_3, _e1538.member_4, _e1538.member_5, 2f, _e1538.member_7, _e1538.member_8, _e1538.member_9, _e1538.member_10, _e1538.member_11, _e1538.member_12, _e1538.member_13, _e1538.member_14);
} else {
if _e1545 {
phi_4378_ = type_12(_e1538.member, _e1538.member_1, _e1538.member_2, _e1538.member_3, _e1538.member_4, _e1538.member_5, 4f, _e1538.member_7, _e1538.member_8, _e1538.member_9, _e1538.member_10, _e1538.member_11, _e1538.member_12, _e1538.member_13, _e1538.member_14);
} else {
phi_4378_ = _e1538;
}
let _e1576 = phi_4378_;
phi_4379_ = _e1576;
}
let _e1593 = phi_4379_;
phi_4380_ = _e1593;
}
let _e1709 = phi_4380_;
phi_4385_ = _e1709;
phi_4386_ = _e1709;
phi_4387_ = !(_e1203);
}
let _e1828 = phi_4385_;
let _e1830 = phi_4386_;
let _e1832 = phi_4387_;
if _e1832 {
phi_4391_ = _e1828;
} else {
phi_4391_ = _e1830;
}
let _e1834 = phi_4391_;
phi_4393_ = _e1834;
phi_4394_ = select(_e439, _e835, _e1832);
}
let _e2155 = phi_4393_;
let _e2157 = phi_4394_;
phi_4395_ = _e2155;
phi_4396_ = _e2157;
}
let _e2625 = phi_4395_;
let _e2627 = phi_4396_;
phi_4397_ = _e2625;
phi_4398_ = _e2627;
}
let _e3017 = phi_4397_;
let _e3019 = phi_4398_;
phi_843_ = _e3017;
phi_846_ = (_e437 + 1i);
phi_848_ = _e3019;
} else {
phi_843_ = type_12();
phi_846_ = i32();
phi_848_ = i32();
}
let _e3021 = phi_843_;
let _e3023 = phi_846_;
let _e3025 = phi_848_;
continue;
continuing {
phi_842_ = _e3021;
phi_845_ = _e3023;
phi_847_ = _e3025;
break if !(_e443);
}
}
let _e3028 = local_15;
if (_e3028 == 0i) {
phi_4404_ = 16i;
} else {
let _e3031 = local_16;
phi_4404_ = -(_e3031);
}
let _e3034 = phi_4404_;
let _e3036 = local_17;
let _e3040 = local_18;
let _e3044 = local_19;
let _e3048 = local_20;
let _e3052 = local_21;
let _e3056 = local_22;
let _e3060 = local_23;
let _e3064 = local_24;
let _e3068 = local_25;
let _e3072 = local_26;
let _e3076 = local_27;
let _e3080 = local_28;
let _e3084 = local_29;
let _e3088 = local_30;
let _e3092 = local_31;
let _e3096 = local_32;
let _e3100 = local_33;
let _e3103 = local_34;
let _e3106 = local_35;
let _e3109 = local_36;
let _e3112 = local_37;
let _e3116 = local_38;
let _e3120 = local_39;
global_5.member[_e116] = _e3036.member.x;
global_5.member[_e128] = _e3040.member.y;
global_5.member[_e139] = _e3044.member.z;
global_5.member[_e150] = _e3048.member_1.x;
global_5.member[_e161] = _e3052.member_1.y;
global_5.member[_e172] = _e3056.member_1.z;
global_5.member[_e183] = _e3060.member_2.x;
global_5.member[_e194] = _e3064.member_2.y;
global_5.member[_e205] = _e3068.member_2.z;
global_5.member[_e216] = _e3072.member_3.x;
global_5.member[_e227] = _e3076.member_3.y;
global_5.member[_e238] = _e3080.member_3.z;
global_5.member[_e249] = _e3084.member_4.x;
global_5.member[_e260] = _e3088.member_4.y;
global_5.member[_e271] = _e3092.member_4.z;
global_5.member[_e282] = _e3096.member_5;
let _e3157 = local_40;
global_5.member[_e293] = _e3157;
global_5.member[_e304] = f32(_e3034);
global_5.member[_e315] = _e3100.member_8;
global_5.member[_e326] = _e3103.member_9;
global_5.member[_e337] = _e3106.member_10;
global_5.member[_e348] = _e3109.member_11;
global_5.member[_e359] = f32(_e3112.member_12);
global_5.member[_e370] = f32(_e3116.member_13);
global_5.member[_e381] = _e3120.member_14;
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
